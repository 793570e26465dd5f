//! What a solve may cost, and how it is stopped from elsewhere.

use std::ops::ControlFlow;

use solver::{Event, Observer};

use crate::cancel::is_cancelled;

/// Work left to a solve, over all that it tries; it ends the computation when none is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    left: usize,
}

impl Budget {
    /// So much work: Newton iterations, each counted once for every mesh interval.
    pub(super) const fn new(work: usize) -> Self {
        Self { left: work }
    }

    /// Whether all is spent.
    pub(super) const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Work left.
    pub(super) const fn left(&self) -> usize {
        self.left
    }

    /// A part of what is left, at most `work`.
    pub(super) fn part(&self, work: usize) -> Self {
        Self { left: self.left.min(work) }
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
        if self.is_spent() || is_cancelled() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
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
        let mut whole = Budget::new(1000);
        let given = whole.part(300);
        let mut part = given;
        assert!(part.notify(&newton(100)).is_continue() && part.notify(&newton(199)).is_continue());
        assert!(part.notify(&newton(50)).is_break() && part.is_spent());
        whole.take(&given, &part);
        assert_eq!(whole.left(), 700);
    }
}
