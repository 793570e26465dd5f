//! What a solve may cost.

use std::ops::ControlFlow;

use solver::{Event, Observer};

/// Newton iterations left to a solve, over all that it tries; it ends the computation when none are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Budget {
    left: usize,
}

impl Budget {
    pub(super) const fn new(iterations: usize) -> Self {
        Self { left: iterations }
    }

    /// Whether all is spent.
    pub(super) const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Iterations left.
    pub(super) const fn left(&self) -> usize {
        self.left
    }

    /// A part of what is left, at most `iterations`.
    pub(super) fn part(&self, iterations: usize) -> Self {
        Self { left: self.left.min(iterations) }
    }

    /// Takes what a part has spent.
    pub(super) fn take(&mut self, given: &Self, left: &Self) {
        self.left -= given.left - left.left;
    }
}

impl Observer for Budget {
    fn notify(&mut self, event: &Event) -> ControlFlow<()> {
        if let Event::Newton { .. } = event {
            self.left = self.left.saturating_sub(1);
        }
        if self.is_spent() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
