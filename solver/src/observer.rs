//! Progress and cancellation.

use crate::continuation::Checkpoint;
use std::ops::ControlFlow;

/// What the solver has just done.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Event {
    /// A Newton correction was computed.
    Newton {
        /// Counted from 1 on each mesh.
        iteration: usize,
        /// Intervals of all regions: what the iteration cost goes with it.
        intervals: usize,
        /// Its size, relative to typical magnitudes.
        correction: f64,
        /// Damping factor of the step before.
        damping: f64,
    },
    /// Newton converged on a mesh.
    Mesh {
        /// Intervals of all regions.
        intervals: usize,
        /// Largest defect over all regions.
        defect: f64,
    },
    /// A continuation step was accepted.
    Step {
        /// Steps so far.
        step: usize,
        /// Path parameter reached; on a branch, value of the constant in which it is traced.
        lambda: f64,
    },
    /// A continuation step was rejected.
    Rejected {
        /// Path parameter that was tried; on a branch, value of the constant where it stands.
        lambda: f64,
    },
}

/// Watches a computation and may stop it. Any `FnMut(&Event) -> ControlFlow<()>` is one.
pub trait Observer {
    /// Called after each event; `Break` ends the computation with a cancellation error.
    fn notify(&mut self, event: &Event) -> ControlFlow<()>;

    /// Whether [`checkpoint`](Self::checkpoint) is to be called.
    fn wants_checkpoints(&self) -> bool {
        false
    }

    /// Called after each accepted step of a continuation, if wanted.
    fn checkpoint(&mut self, _: &Checkpoint) {}
}

impl<F: FnMut(&Event) -> ControlFlow<()>> Observer for F {
    fn notify(&mut self, event: &Event) -> ControlFlow<()> {
        self(event)
    }
}

/// Watches nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {
    fn notify(&mut self, _: &Event) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
