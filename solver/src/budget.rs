//! What a computation may cost.

use crate::cancel::Cancel;
use crate::error::SolveError;
use crate::observer::{Event, Observer};
use crate::options::Options;
use crate::stats::Stats;
use std::cell::Cell;

/// What one call of the library may still cost: shared by all the solves that it consists of.
pub(crate) struct Budget {
    cancel: Option<Cancel>,
    limit: usize,
    /// Points of solves that have ended, whether they succeeded or not.
    spent: Cell<usize>,
}

impl Budget {
    pub(crate) fn new(options: &Options) -> Self {
        Self { cancel: options.cancel.clone(), limit: options.work_limit(), spent: Cell::new(0) }
    }

    /// # Errors
    /// The computation is cancelled, or its work is spent; `running`: what the solve under way has cost.
    pub(crate) fn check(&self, running: &Stats) -> Result<(), SolveError> {
        if self.cancel.as_ref().is_some_and(Cancel::is_cancelled) {
            return Err(SolveError::Cancelled);
        }
        let points = self.spent.get().saturating_add(running.points());
        if points > self.limit { Err(SolveError::WorkLimit { points, limit: self.limit }) } else { Ok(()) }
    }

    /// As [`check`](Self::check), after telling the observer.
    ///
    /// # Errors
    /// As [`check`](Self::check); the observer too may cancel.
    pub(crate) fn notify(&self, observer: &mut dyn Observer, event: &Event, running: &Stats) -> Result<(), SolveError> {
        if observer.notify(event).is_break() { Err(SolveError::Cancelled) } else { self.check(running) }
    }

    /// Adds what a solve has cost, which is over.
    pub(crate) fn charge(&self, ended: &Stats) {
        self.spent.set(self.spent.get().saturating_add(ended.points()));
    }
}
