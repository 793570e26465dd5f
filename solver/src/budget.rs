//! What a computation may cost, and how it is stopped from outside.

use crate::error::SolveError;
use crate::observer::{Event, Observer};
use crate::options::Options;
use crate::stats::Stats;
use std::cell::Cell;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A handle that stops computations from another thread or from a signal handler: clone it, hand one clone to
/// [`Options::cancel`](crate::Options::cancel), and call [`cancel`](Self::cancel) on another. Asking costs one atomic
/// load; every Newton iteration and every damped step of it asks. Once cancelled, a handle stays so.
#[derive(Debug, Clone, Default)]
pub struct Cancel(Arc<Handle>);

#[derive(Default)]
struct Handle {
    cancelled: AtomicBool,
    asked: Option<Box<Asked>>,
}

/// What says on the computing thread whether to stop.
type Asked = dyn Fn() -> bool + Send + Sync;

impl Cancel {
    /// A handle that has not been cancelled.
    pub fn new() -> Self {
        Self::default()
    }

    /// A handle that is also cancelled as soon as `asked` says so, which the computation asks on its own thread at
    /// every Newton iteration: for the embedder whose interrupts reach no other thread, as those of an interpreter. It
    /// should answer within a microsecond, and look at the clock before it does anything slower.
    ///
    /// ```
    /// use solver::Cancel;
    /// let cancel = Cancel::asking(|| true);
    /// assert!(cancel.is_cancelled());
    /// ```
    pub fn asking(asked: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Arc::new(Handle { cancelled: AtomicBool::new(false), asked: Some(Box::new(asked)) }))
    }

    /// Ends every computation that holds a clone of this handle with [`SolveError::Cancelled`], at its next step.
    pub fn cancel(&self) {
        self.0.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether [`cancel`](Self::cancel) has been called on this handle or a clone of it, or what it asks has said so.
    pub fn is_cancelled(&self) -> bool {
        if self.0.cancelled.load(Ordering::Relaxed) {
            return true;
        }
        let stop = self.0.asked.as_ref().is_some_and(|asked| asked());
        if stop {
            self.cancel();
        }
        stop
    }
}

impl fmt::Debug for Handle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Handle").field("cancelled", &self.cancelled).field("asked", &self.asked.is_some()).finish()
    }
}

/// Handles are equal if one cancels the other.
impl PartialEq for Cancel {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

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
