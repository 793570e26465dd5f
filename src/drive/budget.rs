//! What a solve may cost, and how it is stopped from elsewhere.

use std::cell::Cell;
use std::ops::ControlFlow;

use solver::{Event, Observer};

use crate::cancel::is_cancelled;

thread_local! {
    /// Work left to all solves of this thread together, where that is limited.
    static ALLOWANCE: Cell<Option<usize>> = const { Cell::new(None) };
}

/// Does `work`, whose solves on this thread may take no more than `limit` together, over what each of them may take.
/// Once that is spent, each of them ends at its first iteration with the failure of a work limit.
pub(crate) fn with_allowance<T>(limit: usize, work: impl FnOnce() -> T) -> T {
    /// Puts back what held before, less what was spent, even where `work` panics.
    struct Restored {
        before: Option<usize>,
        given: usize,
    }
    impl Drop for Restored {
        fn drop(&mut self) {
            let left = ALLOWANCE.get().unwrap_or(self.given);
            ALLOWANCE.set(self.before.map(|before| before - (self.given - left)));
        }
    }
    let before = ALLOWANCE.get();
    let given = before.map_or(limit, |before| before.min(limit));
    let restored = Restored { before, given };
    ALLOWANCE.set(Some(given));
    let done = work();
    drop(restored);
    done
}

/// Work left to a solve, over all that it tries; it ends the computation when none is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    left: usize,
}

impl Budget {
    /// So much work, or what all solves of this thread together have left: Newton iterations, each counted once for
    /// every mesh interval.
    pub(super) fn new(work: usize) -> Self {
        Self { left: ALLOWANCE.get().map_or(work, |all| all.min(work)) }
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
            ALLOWANCE.set(ALLOWANCE.get().map(|all| all.saturating_sub(*intervals)));
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

    #[test]
    fn solves_share_an_allowance() {
        let spend = |intervals| {
            let mut budget = Budget::new(500);
            let flow = budget.notify(&newton(intervals));
            (budget.left(), flow.is_break())
        };
        with_allowance(1000, || {
            assert_eq!(spend(300), (200, false));
            with_allowance(250, || assert_eq!(spend(100), (150, false)));
            assert_eq!(spend(450), (50, false));
            assert_eq!(with_allowance(400, || spend(150)), (0, true));
            assert_eq!(spend(1), (0, true));
        });
        let panicked = std::panic::catch_unwind(|| with_allowance(10, || panic!("on purpose")));
        assert!(panicked.is_err());
        assert_eq!(spend(300), (200, false));
    }
}
