//! One run of the rig: every 6.7 ms a frame is read, the interlock decides, outputs are set, all is recorded.

use rig_core::{Frame, Identity};

use crate::calibration::Calibration;
use crate::hardware::{Brake, Hardware, HardwareError, Outputs};
use crate::interlock::{BrakeAllowed, Cause, Command, Inputs, Interlock, Limits, Mode, Temperature};
use crate::journal::{Record, Recorder};
use crate::watch::{IDLING_RPM, IDLING_US, Watch};

/// Time between two frames: 150 Hz, as the thesis oversamples its converter.
pub const PERIOD_US: u64 = 1_000_000 / 150;
/// Time between two readings of the rotor's temperature.
const TEMPERATURE_PERIOD_US: u64 = 100_000;
/// Least time between two notes that the throttle stays closed: a key that is held down does not flood the journal.
const REFUSAL_PERIOD_US: u64 = 1_000_000;

/// What may not be passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperatingLimits {
    /// Rotor, °C.
    pub rotor_celsius: f64,
    /// Engine, rpm.
    pub primary_rpm: f64,
    /// Secondary, rpm.
    pub secondary_rpm: f64,
}

impl OperatingLimits {
    /// For the thesis's rig: governor at 3800 rpm, secondary at most 7600 rpm.
    pub const RIG: Self = Self { rotor_celsius: 300.0, primary_rpm: 4300.0, secondary_rpm: 8000.0 };
}

/// What is known after a step; the displays show it.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Status {
    /// Time, µs.
    pub time: u64,
    /// State of the interlock, as text.
    pub mode: String,
    /// What the operator should know: why it tripped, or what the test does.
    pub message: String,
    /// Speeds, rpm.
    pub primary_rpm: f64,
    /// Speeds, rpm.
    pub secondary_rpm: f64,
    /// Torque at the secondary, N·m.
    pub torque: f64,
    /// Output power, W.
    pub power: f64,
    /// Rotor, °C; absent while it cannot be read.
    pub rotor_celsius: Option<f64>,
    /// The operating point that is being read or was read last.
    pub point: u32,
    /// Frames read, and transfers that failed.
    pub frames: u64,
    /// Transfers that failed or brought no good frame.
    pub bad_transfers: u64,
}

/// A run.
pub struct Session<H> {
    /// The rig.
    pub hardware: H,
    interlock: Interlock,
    limits: OperatingLimits,
    calibration: Calibration,
    recorder: Recorder,
    watch: Watch,
    outputs: Outputs,
    outputs_good: bool,
    temperature: Result<f64, HardwareError>,
    next_temperature: u64,
    next_refusal: u64,
    last_step: u64,
    status: Status,
    /// The latest good frame, and when its transfer had ended, µs.
    latest: Option<(Frame, u64)>,
}

impl<H: Hardware> Session<H> {
    /// A run over a rig, with everything closed.
    pub fn new(mut hardware: H, calibration: Calibration, limits: OperatingLimits, recorder: Recorder) -> Self {
        let time = hardware.now();
        let status = Status {
            time,
            mode: "Safe".to_owned(),
            message: String::new(),
            primary_rpm: 0.0,
            secondary_rpm: 0.0,
            torque: 0.0,
            power: 0.0,
            rotor_celsius: None,
            point: 0,
            frames: 0,
            bad_transfers: 0,
        };
        Self {
            hardware,
            interlock: Interlock::new(Limits::RIG),
            limits,
            calibration,
            recorder,
            watch: Watch::default(),
            outputs: Outputs { throttle_open: false, ignition: false, brake: Brake::Hold },
            outputs_good: true,
            temperature: Err(HardwareError::Temperature("not read yet".to_owned())),
            next_temperature: time,
            next_refusal: time,
            last_step: time,
            status,
            latest: None,
        }
    }

    /// The latest state.
    pub fn status(&self) -> &Status {
        &self.status
    }

    /// The latest good frame.
    pub fn frame(&self) -> Option<&Frame> {
        self.latest.as_ref().map(|(frame, _)| frame)
    }

    /// Whether the engine idles, as good frames have said for a while: only then may the throttle be opened.
    pub fn idles(&self) -> bool {
        self.watch.findings(false).idling
    }

    /// The interlock's state.
    pub fn mode(&self) -> Mode {
        self.interlock.mode()
    }

    /// Torque at the secondary for a converter value, N·m.
    pub fn torque(&self, value: u16) -> f64 {
        self.calibration.torque(value)
    }

    /// What the firmware says of itself.
    ///
    /// # Errors
    /// If it does not answer.
    pub fn identity(&mut self) -> Result<Identity, HardwareError> {
        self.hardware.identity()
    }

    /// Ends the recording; whether all of it was written.
    pub fn finish(self) -> (H, bool) {
        (self.hardware, self.recorder.finish())
    }

    /// Records anything.
    pub fn record(&mut self, record: &Record) {
        if self.hardware.real_time() { self.recorder.record(record) } else { self.recorder.record_patiently(record) }
    }

    /// A note for the operator and for the journal.
    pub fn note(&mut self, text: &str) {
        text.clone_into(&mut self.status.message);
        self.record(&Record::Note { at: self.status.time, text: text.to_owned() });
    }

    /// The number of the operating point, for the displays.
    pub fn set_point(&mut self, number: u32) {
        self.status.point = number;
    }

    /// Waits for the next step and does it: reads, decides, sets. `brake` is what the test wants of the brake.
    pub fn step(&mut self, command: Option<Command>, brake: Brake) {
        self.hardware.wait_until(self.last_step + PERIOD_US);
        let time = self.hardware.now();
        let elapsed_us = time - self.last_step;
        self.last_step = time;
        self.status.time = time;
        let (fresh, restarted) = self.read_frame(time);
        self.read_temperature(time);
        let inputs = self.inputs(fresh, restarted, command);
        let before = self.interlock.mode();
        let allowed = self.interlock.step(&inputs, elapsed_us.div_ceil(1000).min(u64::from(u16::MAX)) as u16);
        self.say_mode(before);
        if command == Some(Command::Go) && matches!(self.interlock.mode(), Mode::Safe | Mode::Ready) {
            self.say_refused(inputs.idling);
        }
        let brake = match (allowed.brake, brake) {
            (BrakeAllowed::Hold, _) | (BrakeAllowed::NoRelease, Brake::Release) => Brake::Hold,
            (BrakeAllowed::Any | BrakeAllowed::NoRelease, wanted) => wanted,
        };
        self.outputs = Outputs { throttle_open: allowed.throttle, ignition: allowed.ignition, brake };
        self.watch.moved(brake, elapsed_us);
        let set = self.hardware.set(&self.outputs);
        if let (Err(error), true) = (&set, self.outputs_good) {
            self.note(&error.to_string());
        }
        self.outputs_good = set.is_ok();
    }

    fn read_frame(&mut self, time: u64) -> (bool, bool) {
        let read =
            self.hardware.exchange(self.outputs.ignition).and_then(|bytes| Ok((bytes, Frame::from_bytes(&bytes)?)));
        let (bytes, frame) = match read {
            Ok(read) => read,
            Err(_) => {
                self.status.bad_transfers += 1;
                return (false, false);
            }
        };
        self.record(&Record::Frame { at: time, bytes });
        let after = self.hardware.now();
        let (mut fresh, mut restarted) = (true, false);
        if let Some((before, read_at)) = self.latest {
            fresh = frame.snapshot.now != before.snapshot.now;
            restarted = restarted_between(&before, &frame, time.saturating_sub(read_at));
        }
        self.latest = Some((frame, after));
        self.status.frames += 1;
        self.status.primary_rpm = frame.snapshot.primary.speed.rpm_exact();
        self.status.secondary_rpm = frame.snapshot.secondary.speed.rpm_exact();
        self.status.torque = self.calibration.torque(frame.snapshot.torque);
        self.status.power = self.status.torque * self.status.secondary_rpm * std::f64::consts::PI / 30.0;
        self.watch.frame(time, &frame, self.status.torque);
        (fresh, restarted)
    }

    fn read_temperature(&mut self, time: u64) {
        if time < self.next_temperature {
            return;
        }
        self.next_temperature = time + TEMPERATURE_PERIOD_US;
        self.temperature = self.hardware.rotor_temperature();
        self.status.rotor_celsius = self.temperature.as_ref().ok().copied();
        if let Ok(celsius) = self.temperature {
            self.record(&Record::Temperature { at: time, celsius });
        }
    }

    fn inputs(&mut self, fresh_frame: bool, device_restarted: bool, command: Option<Command>) -> Inputs {
        let running = self.interlock.mode() == Mode::Running;
        let findings = self.watch.findings(running);
        let speeds = [self.status.primary_rpm, self.status.secondary_rpm];
        let too_fast =
            self.frame().is_some_and(|frame| frame.snapshot.primary.too_fast || frame.snapshot.secondary.too_fast);
        Inputs {
            fresh_frame,
            device_restarted,
            temperature: match self.temperature {
                Ok(celsius) if celsius <= self.limits.rotor_celsius => Temperature::Good,
                Ok(_) => Temperature::Hot,
                Err(_) => Temperature::Unreadable,
            },
            brake_on: findings.brake_on,
            brake_jammed: findings.brake_jammed,
            overspeed: too_fast || speeds[0] > self.limits.primary_rpm || speeds[1] > self.limits.secondary_rpm,
            torque_stuck: findings.torque_stuck,
            speed_stuck: findings.speed_stuck,
            speeds_lost: findings.speeds_lost,
            idling: findings.idling,
            recording: self.recorder.good(),
            outputs: self.outputs_good,
            emergency_stop: self.hardware.emergency_stop(),
            at_rest: self
                .frame()
                .is_some_and(|frame| frame.snapshot.primary.stopped && frame.snapshot.secondary.stopped),
            command,
        }
    }

    /// Tells the operator why the throttle stays closed.
    fn say_refused(&mut self, idling: bool) {
        if self.status.time < self.next_refusal {
            return;
        }
        self.next_refusal = self.status.time + REFUSAL_PERIOD_US;
        if idling {
            return self.note("The throttle stays closed: something forbids it at this moment. Press g again.");
        }
        let rpm = self.status.primary_rpm;
        self.note(&format!(
            "The throttle stays closed: the engine does not idle. It turns at {rpm:.0} rpm; more than {IDLING_RPM:.0} \
             rpm for {} s are expected.",
            IDLING_US / 1_000_000
        ));
    }

    fn say_mode(&mut self, before: Mode) {
        let mode = self.interlock.mode();
        if mode == before {
            return;
        }
        self.status.mode = mode_name(mode).to_owned();
        match mode {
            Mode::Stopping(cause) | Mode::Tripped(cause) => {
                self.note(&format!("{}: {}", mode_name(mode), cause.message()));
            }
            Mode::Safe | Mode::Ready | Mode::Running => self.note(mode_name(mode)),
        }
        if mode == Mode::Running {
            self.watch.opened(self.status.time);
        }
    }

    /// A test finds the brake jammed when the torque does not follow it.
    pub fn brake_does_not_follow(&mut self) {
        self.watch.brake_jammed = true;
    }

    /// Why the rig stopped, if it did.
    pub fn cause(&self) -> Option<Cause> {
        match self.interlock.mode() {
            Mode::Stopping(cause) | Mode::Tripped(cause) => Some(cause),
            Mode::Safe | Mode::Ready | Mode::Running => None,
        }
    }
}

/// Whether the measuring device started anew between two frames, the second of which was asked for `between_us` after
/// the first had come: its clock then shows less time than must have passed. The oldest frame that the device can hand
/// out is 20 ms old, and its crystal is good to a part in a thousand at the very worst.
fn restarted_between(before: &Frame, after: &Frame, between_us: u64) -> bool {
    let Some(passed) = after.snapshot.now.microseconds().checked_sub(before.snapshot.now.microseconds()) else {
        return true;
    };
    passed + passed / 1000 + 20_000 < between_us
}

/// A state in one word.
#[must_use]
pub const fn mode_name(mode: Mode) -> &'static str {
    match mode {
        Mode::Safe => "Safe",
        Mode::Ready => "Ready",
        Mode::Running => "Running",
        Mode::Stopping(_) => "Stopping",
        Mode::Tripped(_) => "Tripped",
    }
}
