//! The throttle opens only where the engine idles, whoever asks for it and whenever.

#![allow(clippy::unwrap_used)]

use rig_logger::calibration::Calibration;
use rig_logger::interlock::{Cause, Command};
use rig_logger::session::{OperatingLimits, Session, Status};
use rig_logger::simulated::SimulatedRig;
use rig_logger::steady::{Operator, Plan, run};

mod support;

/// Presses g again and again from the start, and remembers what was seen.
#[derive(Default)]
struct Impatient {
    /// Messages, each once.
    messages: Vec<String>,
    /// The engine's speed when the throttle was first seen open, rpm.
    opened_at: Option<f64>,
    stop_after: Option<u64>,
}

impl Operator for Impatient {
    fn command(&mut self, status: &Status) -> Option<Command> {
        if !self.messages.contains(&status.message) {
            self.messages.push(status.message.clone());
        }
        if status.mode == "Running" {
            self.opened_at.get_or_insert(status.primary_rpm);
        }
        let stop = self.stop_after.is_some_and(|time| status.time > time);
        Some(if stop { Command::Stop } else { Command::Go })
    }
}

const ASKING: Plan = Plan { ask_before_opening: true, most_points: 1, read_ms: 500, ..Plan::THESIS };

fn session(rig: SimulatedRig) -> Session<SimulatedRig> {
    Session::new(rig, Calibration::THESIS, OperatingLimits::RIG, support::recorder())
}

#[test]
fn g_opens_nothing_while_the_engine_stands_still() {
    for ask_before_opening in [true, false] {
        let mut rig = SimulatedRig::new(false);
        rig.starter_pulled = false;
        let mut session = session(rig);
        let mut operator = Impatient { stop_after: Some(20_000_000), ..Impatient::default() };
        assert!(run(&mut session, &Plan { ask_before_opening, ..ASKING }, &mut operator).is_empty());
        assert_eq!((operator.opened_at, session.cause()), (None, Some(Cause::Ended)), "{:?}", session.status());
        let told = |message: &&String| message.contains("the engine does not idle") && message.contains("0 rpm");
        assert!(operator.messages.iter().any(|message| told(&message)), "{:?}", operator.messages);
        assert!(!operator.messages.iter().any(|message| message.contains("Then press g")), "{:?}", operator.messages);
    }
}

#[test]
fn g_that_came_too_soon_opens_once_the_engine_idles() {
    let mut session = session(SimulatedRig::new(false));
    let mut operator = Impatient::default();
    assert_eq!(run(&mut session, &ASKING, &mut operator).len(), 1, "{:?}", session.status());
    assert!(operator.opened_at.unwrap() > 1300.0, "{:?}", operator.opened_at);
}
