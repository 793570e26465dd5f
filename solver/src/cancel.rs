//! How a computation is stopped from outside.

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

    /// Ends every computation that holds a clone of this handle with
    /// [`SolveError::Cancelled`](crate::SolveError::Cancelled), at its next step.
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
