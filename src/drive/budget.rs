//! What a solve may cost, and how it is stopped from elsewhere.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use solver::{Event, Observer};

/// A handle that stops solves from elsewhere, from another thread or a signal handler: give a copy of it to
/// [`SolveOptions::cancel`](super::SolveOptions::cancel) and call [`cancel`](Self::cancel) on another. Every Newton
/// iteration asks. Once cancelled, a handle stays so. It takes one byte, which is kept until the program ends.
#[derive(Debug, Clone, Copy)]
pub struct Cancel(&'static AtomicBool);

impl Cancel {
    /// A handle that has not been cancelled.
    pub fn new() -> Self {
        Self(Box::leak(Box::new(AtomicBool::new(false))))
    }

    /// Ends every solve that holds a copy of this handle with [`Failure::Cancelled`](super::Failure::Cancelled).
    pub fn cancel(self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether [`cancel`](Self::cancel) has been called on this handle or a copy of it.
    pub fn is_cancelled(self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

impl Default for Cancel {
    fn default() -> Self {
        Self::new()
    }
}

/// Handles are equal if one cancels the other.
impl PartialEq for Cancel {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }
}

/// Work left to a solve, over all that it tries; it ends the computation when none is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    left: usize,
    cancel: Option<Cancel>,
}

impl Budget {
    /// So much work: Newton iterations, each counted once for every mesh interval.
    pub(super) const fn new(work: usize, cancel: Option<Cancel>) -> Self {
        Self { left: work, cancel }
    }

    /// Whether all is spent.
    pub(super) const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Whether the solve was cancelled from elsewhere.
    pub(super) fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(Cancel::is_cancelled)
    }

    /// Work left.
    pub(super) const fn left(&self) -> usize {
        self.left
    }

    /// A part of what is left, at most `work`.
    pub(super) fn part(&self, work: usize) -> Self {
        Self { left: self.left.min(work), ..*self }
    }

    /// Takes what a part has spent.
    pub(super) fn take(&mut self, given: &Self, left: &Self) {
        self.left -= given.left - left.left;
    }
}

impl Observer for Budget {
    fn notify(&mut self, event: &Event) -> ControlFlow<()> {
        if let Event::Newton { intervals, .. } = event {
            self.left = self.left.saturating_sub(*intervals);
        }
        if self.is_spent() || self.is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn newton(intervals: usize) -> Event {
        Event::Newton { iteration: 1, intervals, correction: 1.0, damping: 1.0 }
    }

    #[test]
    fn work_is_weighed_by_intervals() {
        let mut whole = Budget::new(1000, None);
        let given = whole.part(300);
        let mut part = given;
        assert!(part.notify(&newton(100)).is_continue() && part.notify(&newton(199)).is_continue());
        assert!(part.notify(&newton(50)).is_break() && part.is_spent());
        whole.take(&given, &part);
        assert_eq!(whole.left(), 700);
    }

    #[test]
    fn a_handle_stops_whoever_holds_a_copy() {
        let (cancel, other) = (Cancel::new(), Cancel::new());
        let mut budget = Budget::new(1000, Some(cancel));
        other.cancel();
        assert!(budget.notify(&newton(1)).is_continue() && cancel != other);
        cancel.cancel();
        assert!(budget.notify(&newton(1)).is_break() && !budget.is_spent());
    }
}
