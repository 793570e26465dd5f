//! The run permit: the engine may have ignition only while the logger keeps asking for it.
//!
//! A logger that dies leaves its outputs as they were, throttle open. The microcontroller therefore holds the ignition
//! relay itself: it closes while permission is renewed at least every [`PERMIT_TICKS`], and opens otherwise. A relay
//! without power grounds the ignition, so that a reset, a cut wire and a loss of supply stop the engine, too.

use crate::clock::{Instant, TICKS_PER_SECOND};

/// How long one permission lasts: 250 ms.
pub const PERMIT_TICKS: u32 = TICKS_PER_SECOND / 4;

/// Whether the engine may run.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunPermit {
    granted: Option<Instant>,
}

impl RunPermit {
    /// Nothing is permitted yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { granted: None }
    }

    /// The logger permits at this moment.
    pub fn grant(&mut self, at: Instant) {
        self.granted = Some(at);
    }

    /// The logger withdraws its permission.
    pub fn withdraw(&mut self) {
        self.granted = None;
    }

    /// Whether the relay is to be held closed. A permission that has run out does not come back by itself.
    pub fn holds(&mut self, now: Instant) -> bool {
        let holds = self.granted.is_some_and(|granted| now.since(granted) < PERMIT_TICKS);
        if !holds {
            self.granted = None;
        }
        holds
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_permission_runs_out_and_stays_so() {
        let mut permit = RunPermit::new();
        assert!(!permit.holds(Instant(0)));
        permit.grant(Instant(100));
        assert!(permit.holds(Instant(100 + u64::from(PERMIT_TICKS) - 1)));
        assert!(!permit.holds(Instant(100 + u64::from(PERMIT_TICKS))));
        assert!(!permit.holds(Instant(101)));
        permit.grant(Instant(200));
        permit.withdraw();
        assert!(!permit.holds(Instant(200)));
    }
}
