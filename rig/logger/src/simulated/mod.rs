//! A rig that is made up: engine, CVT, brake and sensors with noise, bounces and dropouts, and the measuring device
//! itself,
//! which runs the firmware's own code. The logger cannot see the difference.

pub mod drive;

use drive::{Drive, Plant};
use rig_core::ad7171::ConversionError;
use rig_core::device::{Device, identity};
use rig_core::frame::FRAME_LENGTH;
use rig_core::{BusAnswer, Identity, Instant};

use crate::calibration::Calibration;
use crate::hardware::{Brake, Hardware, HardwareError, Outputs};

/// Step of the simulation, µs.
const STEP: u64 = 500;

/// What can be made to fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The I²C cable comes off.
    LinkLost,
    /// The primary's Hall sensor gives no more pulses.
    PrimarySpeedStuck,
    /// The secondary's Hall sensor gives no more pulses.
    SecondarySpeedStuck,
    /// The common supply of both Hall sensors breaks.
    BothSpeedsStuck,
    /// The converter repeats one value.
    TorqueStuck,
    /// Every pulse comes twice, 2 ms apart.
    DoublePulses,
    /// The brake's actuator moves, the brake does not.
    BrakeJammed,
    /// The brake lets go.
    BrakeReleased,
    /// The rotor is 400 °C hot.
    RotorHot,
    /// The infrared sensor does not answer.
    TemperatureUnreadable,
    /// The governor fails and the engine runs away.
    Runaway,
    /// The emergency stop is pressed.
    EmergencyStop,
    /// The measuring device is reset by its watchdog.
    DeviceReset,
}

/// The simulated rig.
pub struct SimulatedRig {
    /// Engine, CVT and brake.
    pub plant: Plant,
    device: Device,
    device_started: u64,
    now: u64,
    real_time: Option<std::time::Instant>,
    outputs: Outputs,
    sequence: u16,
    /// From when, until when, what.
    faults: Vec<(u64, u64, Fault)>,
    /// Whether somebody pulls the starter once ignition is permitted.
    pub starter_pulled: bool,
    random: u64,
    passages: [f64; 2],
    second_pulse: [Option<u64>; 2],
    next_conversion: u64,
    filtered_torque: f64,
    calibration: Calibration,
    /// A known load on the shaft for a calibration, N·m at the secondary, in place of the brake's torque.
    pub hung_load: Option<f64>,
}

impl SimulatedRig {
    /// A rig whose time runs as fast as it can, or as it does outside.
    #[must_use]
    pub fn new(real_time: bool) -> Self {
        Self {
            plant: Plant::new(),
            device: Device::new(1),
            device_started: 0,
            now: 0,
            real_time: real_time.then(std::time::Instant::now),
            outputs: Outputs { throttle_open: false, ignition: false, brake: Brake::Hold },
            sequence: 0,
            faults: Vec::new(),
            starter_pulled: true,
            random: 0x9e37_79b9_7f4a_7c15,
            passages: [std::f64::consts::TAU; 2],
            second_pulse: [None; 2],
            next_conversion: 0,
            filtered_torque: 0.0,
            calibration: Calibration::THESIS,
            hung_load: None,
        }
    }

    /// Lets something fail from a time on, µs.
    pub fn fail_at(&mut self, time: u64, fault: Fault) {
        self.fail_between(time, u64::MAX, fault);
    }

    /// Lets something fail between two times, µs.
    pub fn fail_between(&mut self, begin: u64, end: u64, fault: Fault) {
        self.faults.push((begin, end, fault));
    }

    /// Open throttle and ignition: what the interlock is there for.
    #[must_use]
    pub fn power(&mut self) -> bool {
        self.outputs.throttle_open && self.permitted()
    }

    fn has(&self, fault: Fault) -> bool {
        self.faults.iter().any(|(begin, end, failing)| (*begin..*end).contains(&self.now) && *failing == fault)
    }

    fn device_now(&self) -> Instant {
        Instant::from_microseconds(self.now - self.device_started)
    }

    fn permitted(&mut self) -> bool {
        let now = self.device_now();
        self.device.permit.holds(now)
    }

    /// A number in −1..1.
    fn noise(&mut self) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Runs to a time, µs.
    pub fn run_to(&mut self, time: u64) {
        while self.now + STEP <= time {
            self.now += STEP;
            self.step();
        }
    }

    fn step(&mut self) {
        if self.now == STEP {
            // The operator pulls the starter once ignition is permitted; from then on the engine idles.
            self.plant.speeds[0] = 0.0;
        }
        self.reset_device();
        let ignition = self.permitted();
        if self.starter_pulled && ignition && self.plant.speeds[0] < 80.0 && !self.outputs.throttle_open {
            self.plant.speeds[0] += 0.5;
        }
        let actuator = match self.outputs.brake {
            Brake::Apply if !self.has(Fault::BrakeJammed) => 1.0,
            Brake::Release => -1.0,
            _ => 0.0,
        };
        if self.has(Fault::BrakeReleased) {
            self.plant.travel = 0.0;
        }
        if self.has(Fault::RotorHot) {
            self.plant.rotor = self.plant.rotor.max(400.0);
        }
        let no_governor = self.has(Fault::Runaway);
        // Ignition alone turns no engine that nobody has started.
        let fires = ignition && (self.starter_pulled || self.plant.speeds[0] > 30.0);
        let drive = Drive { throttle_open: self.outputs.throttle_open, ignition: fires, actuator, no_governor };
        if no_governor && ignition && self.outputs.throttle_open {
            self.plant.speeds[0] += 0.15;
        }
        self.plant.step(&drive, STEP as f64 * 1e-6);
        self.pulses();
        self.conversion();
    }

    fn reset_device(&mut self) {
        let reset = self
            .faults
            .iter()
            .any(|(time, _, fault)| *fault == Fault::DeviceReset && *time > self.now - STEP && *time <= self.now);
        if reset {
            self.device = Device::new(0b1000);
            self.device_started = self.now;
        }
    }

    fn pulses(&mut self) {
        let both = self.has(Fault::BothSpeedsStuck);
        let stuck = [both || self.has(Fault::PrimarySpeedStuck), both || self.has(Fault::SecondarySpeedStuck)];
        let double = self.has(Fault::DoublePulses);
        for (shaft, stuck) in stuck.into_iter().enumerate() {
            if self.second_pulse[shaft].is_some_and(|time| time <= self.now) {
                self.second_pulse[shaft] = None;
                self.pulse(shaft, self.now);
            }
            let (angle, speed) = (self.plant.angles[shaft], self.plant.speeds[shaft]);
            if angle < self.passages[shaft] || speed < 0.1 {
                continue;
            }
            let late = ((angle - self.passages[shaft]) / speed * 1e6).min(STEP as f64);
            self.passages[shaft] += std::f64::consts::TAU;
            // One in two thousand is missed; the moment is good to 20 µs.
            if stuck || self.noise() > 0.999 {
                continue;
            }
            let at = self.now as f64 - late + 20.0 * self.noise();
            self.pulse(shaft, at.max(0.0) as u64);
            if double || self.noise() > 0.98 {
                self.second_pulse[shaft] = Some(self.now + 2000);
            }
        }
    }

    fn pulse(&mut self, shaft: usize, at: u64) {
        let at = Instant::from_microseconds(at.saturating_sub(self.device_started));
        if shaft == 0 {
            self.device.primary.pulse(at)
        } else {
            self.device.secondary.pulse(at)
        };
    }

    /// Torque with the engine's firing and the rotor's turning in it, through the 15 Hz filter, at 125 Hz.
    fn conversion(&mut self) {
        let torque = self.hung_load.unwrap_or(self.plant.brake_torque);
        let firing = 0.3 * (self.plant.angles[0] / 2.0).sin();
        let rotor = 0.1 * (self.plant.angles[1] * 32.0 / 61.0).sin();
        let target = torque * (1.0 + firing + rotor);
        self.filtered_torque +=
            (target - self.filtered_torque) * (STEP as f64 * 1e-6 * 15.0 * std::f64::consts::TAU).min(1.0);
        if self.now < self.next_conversion {
            return;
        }
        self.next_conversion = self.now + 8000;
        let at = self.device_now();
        let value = self.calibration.slope * self.filtered_torque + self.calibration.intercept + 8.0 * self.noise();
        if self.has(Fault::TorqueStuck) {
            self.device.conversion(at, Ok(36_000));
        } else if self.noise() > 0.995 {
            // The slip ring lifts off.
            self.device.conversion(at, Err(ConversionError::Reported));
        } else {
            self.device.conversion(at, Ok(value.round().clamp(0.0, 65_535.0) as u16));
        }
    }
}

impl Hardware for SimulatedRig {
    fn now(&mut self) -> u64 {
        if let Some(start) = self.real_time {
            let time = start.elapsed().as_micros() as u64;
            self.run_to(time);
            return time.max(self.now);
        }
        self.now
    }

    fn wait_until(&mut self, time: u64) {
        if let Some(start) = self.real_time {
            let wait = time.saturating_sub(start.elapsed().as_micros() as u64);
            std::thread::sleep(std::time::Duration::from_micros(wait));
        }
        self.run_to(time);
    }

    fn real_time(&self) -> bool {
        self.real_time.is_some()
    }

    fn exchange(&mut self, permit: bool) -> Result<[u8; FRAME_LENGTH], HardwareError> {
        if self.has(Fault::LinkLost) {
            return Err(HardwareError::Bus("no acknowledge from address 0x03".to_owned()));
        }
        let now = self.device_now();
        if permit {
            self.device.permit.grant(now)
        } else {
            self.device.permit.withdraw()
        }
        self.sequence = self.sequence.wrapping_add(1);
        let mut answer = BusAnswer::empty();
        answer.fill(&self.device.snapshot(now), self.sequence);
        // One transfer in a thousand is disturbed.
        if self.noise() > 0.998 {
            answer.frame[7] ^= 0x10;
        }
        Ok(answer.frame)
    }

    fn identity(&mut self) -> Result<Identity, HardwareError> {
        Ok(identity([0, 1, 0]))
    }

    fn rotor_temperature(&mut self) -> Result<f64, HardwareError> {
        if self.has(Fault::TemperatureUnreadable) {
            return Err(HardwareError::Temperature("no acknowledge from address 0x5a".to_owned()));
        }
        Ok(self.plant.rotor + 0.5 * self.noise())
    }

    fn emergency_stop(&mut self) -> bool {
        self.has(Fault::EmergencyStop)
    }

    fn set(&mut self, outputs: &Outputs) -> Result<(), HardwareError> {
        self.outputs = *outputs;
        Ok(())
    }
}
