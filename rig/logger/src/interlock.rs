//! Who may open the throttle: a state machine small enough to be checked whole.
//!
//! ```text
//!            Enable       Go, brake on, engine idles     any cause, or Stop
//!   Safe ------------> Ready ---------------> Running ----------------------+
//!    ^                   |  any cause, or Stop                              v
//!    |                   +--------------------------------------------> Stopping
//!    |   Acknowledge, and the cause is gone                                 | at rest, or time is up
//!    +------------------------------------------------------------------ Tripped
//!    +--------------------------------------------------- (a test that has simply ended)
//! ```
//!
//! Invariants, held by `tests/interlock.rs` over every state that can be reached, with faults at any moment. *Power*
//! is an open throttle together with ignition; what is compared is the truth outside, not what the machine believes.
//!
//! 1. Power ends within `link_ms` + one step after the link to the measuring device is lost.
//! 2. Power ends within `brake_ms` + one step after the brake is released.
//! 3. Power ends within `hot_ms` + one step after the rotor's temperature passes its limit.
//! 4. Power ends within `unreadable_ms` + one step after the temperature cannot be read any more.
//! 5. Power ends within one step after the emergency stop, an overspeed, a recording that fails, an output that cannot
//!    be set, a brake that is found jammed, or a speed sensor or both that are found silent.
//! 6. Power ends within the run permit of the measuring device (250 ms) + one step after this program dies.
//! 7. The throttle opens in Running alone, ignition is permitted in Ready and Running alone, and the brake is never
//!    let go where the throttle may be open.
//! 8. A trip is left only by Acknowledge, after its cause has gone, and leads to Safe.
//! 9. From every state Safe can be reached again once the faults are gone.
//! 10. Power ends within `torque_ms` + one step after the torque sensor gives nothing new.
//! 11. A reset of the measuring device ends power at once, and power stays off until a frame has told of the reset,
//!     also where the link is lost meanwhile.
//! 12. The throttle opens only where the engine idles, as a good frame says, and not because somebody asks for it.

/// Times after which a condition ends a run, ms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Limits {
    /// Without a good frame from the measuring device.
    pub link_ms: u16,
    /// With the rotor above its limit.
    pub hot_ms: u16,
    /// Without a reading of the rotor's temperature.
    pub unreadable_ms: u16,
    /// With the brake released.
    pub brake_ms: u16,
    /// With a torque sensor that gives nothing, or nothing but one value.
    pub torque_ms: u16,
    /// How long stopping may take before it is ended without knowing that the shafts are at rest.
    pub stopping_ms: u16,
}

impl Limits {
    /// The rig's limits.
    pub const RIG: Self =
        Self { link_ms: 200, hot_ms: 200, unreadable_ms: 400, brake_ms: 300, torque_ms: 300, stopping_ms: 15_000 };
}

/// The rotor's temperature, as far as the interlock cares.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Temperature {
    /// Read, and below the limit.
    Good,
    /// Read, and above it.
    Hot,
    /// Not read.
    Unreadable,
}

/// What the operator asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Permit ignition, so that the engine can be started.
    Enable,
    /// Open the throttle.
    Go,
    /// End the run in an orderly way.
    Stop,
    /// The operator has seen why the rig tripped.
    Acknowledge,
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cause {
    /// The operator or the test plan ended it.
    Ended,
    /// The emergency stop.
    EmergencyStop,
    /// No good frame from the measuring device.
    LinkLost,
    /// The measuring device started anew.
    DeviceRestarted,
    /// The rotor is too hot.
    RotorHot,
    /// The rotor's temperature cannot be read.
    TemperatureUnreadable,
    /// The brake is released.
    BrakeReleased,
    /// The brake does not follow its actuator.
    BrakeJammed,
    /// A shaft turns faster than it may.
    Overspeed,
    /// The torque sensor gives nothing, or nothing but one value.
    TorqueStuck,
    /// A speed sensor gives nothing while its shaft must turn.
    SpeedStuck,
    /// Neither shaft shows pulses under an open throttle.
    SpeedsLost,
    /// The recording cannot be written.
    RecordingFailed,
    /// Throttle or brake cannot be set.
    OutputFailed,
}

impl Cause {
    /// What the operator reads.
    #[must_use]
    pub const fn message(self) -> &'static str {
        match self {
            Self::Ended => "The run has ended.",
            Self::EmergencyStop => "Emergency stop. Release the button, then acknowledge.",
            Self::LinkLost => "No good data from the measuring device: check its supply and the I2C cable.",
            Self::DeviceRestarted => {
                "The measuring device restarted: its watchdog or its supply; look at the reset cause."
            }
            Self::RotorHot => "The brake rotor is too hot: let it cool down before the next run.",
            Self::TemperatureUnreadable => "The rotor's temperature cannot be read: check the infrared sensor.",
            Self::BrakeReleased => "The brake is released under an open throttle: check actuator and pressure.",
            Self::BrakeJammed => "The torque does not follow the brake's actuator: it is jammed, or the pads slip.",
            Self::Overspeed => {
                "A shaft turns faster than it may: check the governor, and whether the belt is still on."
            }
            Self::TorqueStuck => "The torque sensor gives nothing new: check slip ring, amplifier and converter.",
            Self::SpeedStuck => "A speed sensor gives no pulses while its shaft must turn: check sensor and magnet.",
            Self::SpeedsLost => {
                "Both speeds are lost under an open throttle: check the sensors' common supply, or the engine stalled."
            }
            Self::RecordingFailed => "The recording cannot be written: the disk is full or gone. Nothing was deleted.",
            Self::OutputFailed => {
                "Throttle or brake cannot be set: check the outputs of the computer. Ignition is off."
            }
        }
    }
}

/// What the machine is told in each step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Inputs {
    /// A good frame came in since the last step.
    pub fresh_frame: bool,
    /// The measuring device's clock ran backwards, or it says that it was reset.
    pub device_restarted: bool,
    /// The rotor.
    pub temperature: Temperature,
    /// The brake is on.
    pub brake_on: bool,
    /// The brake does not follow.
    pub brake_jammed: bool,
    /// A shaft is too fast.
    pub overspeed: bool,
    /// The torque is stale or has not changed at all.
    pub torque_stuck: bool,
    /// A shaft that must turn shows no pulses.
    pub speed_stuck: bool,
    /// Neither shaft shows pulses although the throttle is open.
    pub speeds_lost: bool,
    /// The recording is being written.
    pub recording: bool,
    /// Throttle and brake could be set in the last step.
    pub outputs: bool,
    /// The emergency stop is pressed.
    pub emergency_stop: bool,
    /// Both shafts stand still, as a good frame said.
    pub at_rest: bool,
    /// The engine idles, as good frames have said for a while.
    pub idling: bool,
    /// What the operator asks for.
    pub command: Option<Command>,
}

/// The state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Ignition off, throttle closed.
    Safe,
    /// Ignition permitted, throttle closed.
    Ready,
    /// The throttle is open.
    Running,
    /// Ignition off, throttle closed, the shafts are running down.
    Stopping(Cause),
    /// As Safe, but for the operator to see why.
    Tripped(Cause),
}

/// What may be done with the brake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BrakeAllowed {
    /// Anything.
    Any,
    /// It may be put on further or held, not let go.
    NoRelease,
    /// It is held where it is.
    Hold,
}

/// What is allowed until the next step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Allowed {
    /// The throttle may be open.
    pub throttle: bool,
    /// Ignition: what the measuring device is asked to permit.
    pub ignition: bool,
    /// The brake.
    pub brake: BrakeAllowed,
}

/// The machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Interlock {
    limits: Limits,
    mode: Mode,
    silent_ms: u16,
    hot_ms: u16,
    unreadable_ms: u16,
    released_ms: u16,
    torque_ms: u16,
    stopping_ms: u16,
}

fn count(timer: &mut u16, counts: bool, elapsed_ms: u16, limit: u16) -> bool {
    // Beyond its limit a timer says nothing more: it stays there, and the machine stays small.
    *timer = if counts { timer.saturating_add(elapsed_ms).min(limit) } else { 0 };
    *timer >= limit
}

impl Interlock {
    /// A machine in [`Mode::Safe`].
    #[must_use]
    pub const fn new(limits: Limits) -> Self {
        Self {
            limits,
            mode: Mode::Safe,
            silent_ms: limits.link_ms,
            hot_ms: 0,
            unreadable_ms: limits.unreadable_ms,
            released_ms: limits.brake_ms,
            torque_ms: limits.torque_ms,
            stopping_ms: 0,
        }
    }

    /// The state.
    #[must_use]
    pub const fn mode(&self) -> Mode {
        self.mode
    }

    /// One step, `elapsed_ms` after the last one.
    pub fn step(&mut self, inputs: &Inputs, elapsed_ms: u16) -> Allowed {
        let cause = self.cause(inputs, elapsed_ms);
        let before = self.mode;
        self.mode = self.next(inputs, cause, elapsed_ms);
        if !matches!((before, self.mode), (Mode::Stopping(_), Mode::Stopping(_))) {
            self.stopping_ms = 0;
        }
        self.allowed()
    }

    /// What is wrong, most urgent first. All timers run in every state.
    fn cause(&mut self, inputs: &Inputs, elapsed_ms: u16) -> Option<Cause> {
        let limits = self.limits;
        let silent = count(&mut self.silent_ms, !inputs.fresh_frame, elapsed_ms, limits.link_ms);
        let hot = count(&mut self.hot_ms, inputs.temperature == Temperature::Hot, elapsed_ms, limits.hot_ms);
        let unread = inputs.temperature == Temperature::Unreadable;
        let unreadable = count(&mut self.unreadable_ms, unread, elapsed_ms, limits.unreadable_ms);
        let released = count(&mut self.released_ms, !inputs.brake_on, elapsed_ms, limits.brake_ms);
        let torque = count(&mut self.torque_ms, inputs.torque_stuck, elapsed_ms, limits.torque_ms);
        [
            (inputs.emergency_stop, Cause::EmergencyStop),
            (inputs.overspeed, Cause::Overspeed),
            (silent, Cause::LinkLost),
            (inputs.device_restarted, Cause::DeviceRestarted),
            (hot, Cause::RotorHot),
            (unreadable, Cause::TemperatureUnreadable),
            (released && self.mode == Mode::Running, Cause::BrakeReleased),
            (inputs.brake_jammed, Cause::BrakeJammed),
            (torque, Cause::TorqueStuck),
            (inputs.speed_stuck, Cause::SpeedStuck),
            (inputs.speeds_lost, Cause::SpeedsLost),
            (!inputs.recording, Cause::RecordingFailed),
            (!inputs.outputs, Cause::OutputFailed),
        ]
        .into_iter()
        .find_map(|(holds, cause)| holds.then_some(cause))
    }

    fn next(&mut self, inputs: &Inputs, cause: Option<Cause>, elapsed_ms: u16) -> Mode {
        match (self.mode, cause, inputs.command) {
            (Mode::Ready | Mode::Running, Some(cause), _) => Mode::Stopping(cause),
            (Mode::Ready | Mode::Running, None, Some(Command::Stop)) => Mode::Stopping(Cause::Ended),
            (Mode::Safe, None, Some(Command::Enable)) => Mode::Ready,
            // A transient fault must be gone for good, not just short of its limit; and an engine that stands still
            // must not be started under an open throttle.
            (Mode::Ready, None, Some(Command::Go)) if inputs.idling && self.nothing_counts() => Mode::Running,
            (Mode::Stopping(reason), _, _) => self.stopping(reason, inputs, elapsed_ms),
            (Mode::Tripped(_), None, Some(Command::Acknowledge)) => Mode::Safe,
            (mode, _, _) => mode,
        }
    }

    fn stopping(&mut self, reason: Cause, inputs: &Inputs, elapsed_ms: u16) -> Mode {
        let time_is_up = count(&mut self.stopping_ms, true, elapsed_ms, self.limits.stopping_ms);
        let done = time_is_up || (inputs.at_rest && inputs.fresh_frame);
        match reason {
            Cause::Ended if done => Mode::Safe,
            reason if done => Mode::Tripped(reason),
            reason => Mode::Stopping(reason),
        }
    }

    fn nothing_counts(&self) -> bool {
        self.silent_ms == 0
            && self.hot_ms == 0
            && self.unreadable_ms == 0
            && self.released_ms == 0
            && self.torque_ms == 0
    }

    /// What the present state allows.
    #[must_use]
    pub const fn allowed(&self) -> Allowed {
        match self.mode {
            Mode::Safe | Mode::Tripped(_) => Allowed { throttle: false, ignition: false, brake: BrakeAllowed::Any },
            Mode::Ready => Allowed { throttle: false, ignition: true, brake: BrakeAllowed::NoRelease },
            Mode::Running => Allowed { throttle: true, ignition: true, brake: BrakeAllowed::NoRelease },
            Mode::Stopping(_) => Allowed { throttle: false, ignition: false, brake: BrakeAllowed::Hold },
        }
    }
}
