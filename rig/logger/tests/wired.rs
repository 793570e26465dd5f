//! The real rig's code against wires that are made up: the measuring device's own code behind the bus, an infrared
//! sensor with its check, lines and a servo that remember what was done to them.

#![allow(clippy::unwrap_used)]

use std::cell::RefCell;
use std::convert::Infallible;
use std::rc::Rc;
use std::time::{Duration, Instant as HostInstant};

use embedded_hal::digital::{self, InputPin, OutputPin};
use embedded_hal::i2c::{self, I2c, NoAcknowledgeSource, Operation};
use embedded_hal::pwm::{self, SetDutyCycle};
use rig_core::device::{Device, identity};
use rig_core::wire::{Request, Selected, Selection};
use rig_core::{BusAnswer, Frame, Instant};
use rig_logger::calibration::Calibration;
use rig_logger::hardware::{Brake, Hardware, HardwareError, Outputs};
use rig_logger::interlock::{Cause, Command, Mode};
use rig_logger::session::{OperatingLimits, Session};
use rig_logger::wired::{WiredRig, Wires};

mod support;

/// What is at the other end of the wires.
struct Far {
    device: Device,
    switched_on: HostInstant,
    sequence: u16,
    permitted: bool,
    /// Somebody has pulled the starter: with ignition the engine idles at 1714 rpm.
    started: bool,
    next_pulse: Option<u64>,
    bus_cut: bool,
    temperature: u16,
    spoil_check: bool,
    stop_high: bool,
    stop_fails: bool,
    servo_fails: bool,
    moves: bool,
    applies: bool,
    duty: u16,
    /// (moves, applies) after every change of either.
    brake: Vec<(bool, bool)>,
}

type Shared = Rc<RefCell<Far>>;

fn far() -> Shared {
    Rc::new(RefCell::new(Far {
        device: Device::new(1),
        switched_on: HostInstant::now(),
        sequence: 0,
        permitted: false,
        started: false,
        next_pulse: None,
        bus_cut: false,
        temperature: 0x3af7,
        spoil_check: false,
        stop_high: true,
        stop_fails: false,
        servo_fails: false,
        moves: false,
        applies: false,
        duty: 0,
        brake: Vec::new(),
    }))
}

struct Bus(Shared);

impl i2c::ErrorType for Bus {
    type Error = i2c::ErrorKind;
}

impl Far {
    /// The pulses of the engine's shaft until now.
    fn engine(&mut self, now: u64) {
        const PERIOD: u64 = 35_000;
        if !(self.started && self.device.permit.holds(Instant::from_microseconds(now))) {
            self.next_pulse = None;
            return;
        }
        let mut next = self.next_pulse.unwrap_or(now);
        while next <= now {
            self.device.primary.pulse(Instant::from_microseconds(next));
            next += PERIOD;
        }
        self.next_pulse = Some(next);
    }

    fn measuring_device(&mut self, written: &[u8], read: &mut [u8]) {
        let microseconds = self.switched_on.elapsed().as_micros() as u64;
        self.engine(microseconds);
        let now = Instant::from_microseconds(microseconds);
        let mut selection = Selection::new();
        selection.start_write();
        for byte in written {
            match selection.byte(*byte) {
                Request::Grant => self.device.permit.grant(now),
                Request::Withdraw => self.device.permit.withdraw(),
                Request::None => {}
            }
        }
        self.sequence = self.sequence.wrapping_add(1);
        let mut answer = BusAnswer::empty();
        let snapshot = self.device.snapshot(now);
        self.permitted = snapshot.permitted;
        answer.fill(&snapshot, self.sequence);
        let bytes = match selection.selected {
            Selected::Legacy => answer.legacy.to_vec(),
            Selected::Frame => answer.frame.to_vec(),
            Selected::Identity => identity([1, 2, 3]).to_bytes().to_vec(),
        };
        read.copy_from_slice(&bytes[..read.len()]);
    }

    /// The data sheet's check, x⁸ + x² + x + 1, bit by bit.
    fn infrared(&mut self, written: &[u8], read: &mut [u8]) {
        let [low, high] = self.temperature.to_le_bytes();
        let mut check = 0u8;
        for byte in [0x5a << 1, written[0], 0x5a << 1 | 1, low, high] {
            check ^= byte;
            for _ in 0..8 {
                check = if check & 0x80 == 0 { check << 1 } else { (check << 1) ^ 0x07 };
            }
        }
        read.copy_from_slice(&[low, high, check ^ u8::from(self.spoil_check)]);
    }
}

impl I2c for Bus {
    fn transaction(&mut self, address: u8, operations: &mut [Operation<'_>]) -> Result<(), i2c::ErrorKind> {
        let mut far = self.0.borrow_mut();
        let [Operation::Write(written), Operation::Read(read)] = operations else {
            return Err(i2c::ErrorKind::Other);
        };
        match address {
            0x03 if !far.bus_cut => far.measuring_device(written, read),
            0x5a if !far.bus_cut => far.infrared(written, read),
            _ => return Err(i2c::ErrorKind::NoAcknowledge(NoAcknowledgeSource::Address)),
        }
        Ok(())
    }
}

enum Line {
    Moves,
    Applies,
}

struct Output(Shared, Line);

impl digital::ErrorType for Output {
    type Error = Infallible;
}

impl OutputPin for Output {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.set_state(digital::PinState::Low)
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.set_state(digital::PinState::High)
    }

    fn set_state(&mut self, state: digital::PinState) -> Result<(), Infallible> {
        let mut far = self.0.borrow_mut();
        let high = state == digital::PinState::High;
        match self.1 {
            Line::Moves => far.moves = high,
            Line::Applies => far.applies = high,
        }
        let now = (far.moves, far.applies);
        if far.brake.last() != Some(&now) {
            far.brake.push(now);
        }
        Ok(())
    }
}

struct Stop(Shared);

impl digital::ErrorType for Stop {
    type Error = digital::ErrorKind;
}

impl InputPin for Stop {
    fn is_high(&mut self) -> Result<bool, digital::ErrorKind> {
        let far = self.0.borrow();
        if far.stop_fails { Err(digital::ErrorKind::Other) } else { Ok(far.stop_high) }
    }

    fn is_low(&mut self) -> Result<bool, digital::ErrorKind> {
        self.is_high().map(|high| !high)
    }
}

struct Servo(Shared);

impl pwm::ErrorType for Servo {
    type Error = pwm::ErrorKind;
}

impl SetDutyCycle for Servo {
    fn max_duty_cycle(&self) -> u16 {
        20_000
    }

    fn set_duty_cycle(&mut self, duty: u16) -> Result<(), pwm::ErrorKind> {
        let mut far = self.0.borrow_mut();
        if far.servo_fails {
            return Err(pwm::ErrorKind::Other);
        }
        far.duty = duty;
        Ok(())
    }
}

fn rig(far: &Shared) -> WiredRig<Bus, Output, Stop, Servo> {
    WiredRig::new(Wires {
        bus: Bus(Rc::clone(far)),
        brake_moves: Output(Rc::clone(far), Line::Moves),
        brake_applies: Output(Rc::clone(far), Line::Applies),
        stop_loop: Stop(Rc::clone(far)),
        throttle: Servo(Rc::clone(far)),
    })
    .unwrap()
}

const CLOSED: Outputs = Outputs { throttle_open: false, ignition: false, brake: Brake::Hold };

#[test]
fn frames_permit_and_identity_go_over_the_bus() {
    let far = far();
    let mut rig = rig(&far);
    assert_eq!(rig.identity().unwrap(), identity([1, 2, 3]));
    let frame = Frame::from_bytes(&rig.exchange(true).unwrap()).unwrap();
    assert!(frame.snapshot.permitted && far.borrow().permitted);
    let frame = Frame::from_bytes(&rig.exchange(false).unwrap()).unwrap();
    assert!(!frame.snapshot.permitted);
    far.borrow_mut().bus_cut = true;
    assert!(matches!(rig.exchange(true), Err(HardwareError::Bus(_))));
}

#[test]
fn a_temperature_counts_only_with_its_check() {
    let far = far();
    let mut rig = rig(&far);
    assert!((rig.rotor_temperature().unwrap() - 28.75).abs() < 0.01);
    far.borrow_mut().spoil_check = true;
    assert!(matches!(rig.rotor_temperature(), Err(HardwareError::Temperature(_))));
    far.borrow_mut().spoil_check = false;
    far.borrow_mut().temperature = 0x8001;
    assert!(matches!(rig.rotor_temperature(), Err(HardwareError::Temperature(_))));
}

#[test]
fn the_emergency_stop_counts_as_pressed_unless_its_loop_is_seen_closed() {
    let far = far();
    let mut rig = rig(&far);
    assert!(!rig.emergency_stop());
    far.borrow_mut().stop_high = false;
    assert!(rig.emergency_stop());
    far.borrow_mut().stop_high = true;
    far.borrow_mut().stop_fails = true;
    assert!(rig.emergency_stop());
}

#[test]
fn the_brake_s_relay_never_switches_under_current() {
    let far = far();
    let mut rig = rig(&far);
    for brake in [Brake::Apply, Brake::Hold, Brake::Release, Brake::Apply, Brake::Apply, Brake::Hold] {
        for _ in 0..3 {
            rig.set(&Outputs { brake, ..CLOSED }).unwrap();
            std::thread::sleep(Duration::from_millis(8));
        }
    }
    let brake = far.borrow().brake.clone();
    for (before, after) in brake.iter().zip(brake.iter().skip(1)) {
        assert!(before.1 == after.1 || !(before.0 || after.0), "{brake:?}");
    }
    for moving in [(true, true), (true, false)] {
        assert!(brake.contains(&moving), "{brake:?}");
    }
    assert!(!far.borrow().moves);
}

#[test]
fn the_throttle_s_pulses_are_those_of_the_thesis_and_it_closes_when_the_rig_is_let_go() {
    let far = far();
    let mut rig = rig(&far);
    assert_eq!(far.borrow().duty, 2200);
    rig.set(&Outputs { throttle_open: true, brake: Brake::Apply, ..CLOSED }).unwrap();
    assert_eq!(far.borrow().duty, 800);
    drop(rig);
    assert_eq!((far.borrow().duty, far.borrow().moves), (2200, false));
}

/// Has the brake put on and asks for an open throttle from the beginning on, for as long as the brake's actuator takes
/// and a little longer.
fn asked_to_open(far: &Shared, started: bool) -> Session<WiredRig<Bus, Output, Stop, Servo>> {
    far.borrow_mut().started = started;
    let mut session = Session::new(rig(far), Calibration::THESIS, OperatingLimits::RIG, support::recorder());
    let convert = |place: u16| {
        let mut far = far.borrow_mut();
        let now = Instant::from_microseconds(far.switched_on.elapsed().as_micros() as u64);
        far.device.conversion(now, Ok(36_000 + place % 7));
    };
    // The brake's actuator counts as on after 2.9 s.
    for step in 0..520 {
        convert(step);
        let command = match session.mode() {
            Mode::Safe if step > 10 => Some(Command::Enable),
            Mode::Ready => Some(Command::Go),
            _ => None,
        };
        session.step(command, Brake::Apply);
        if session.mode() == Mode::Running {
            break;
        }
    }
    session
}

fn running(far: &Shared) -> Session<WiredRig<Bus, Output, Stop, Servo>> {
    let session = asked_to_open(far, true);
    assert_eq!(session.mode(), Mode::Running, "{:?}", session.status());
    assert_eq!(far.borrow().duty, 800);
    session
}

#[test]
fn an_engine_that_nobody_started_gets_no_open_throttle() {
    let far = far();
    let session = asked_to_open(&far, false);
    assert_eq!((session.mode(), far.borrow().duty), (Mode::Ready, 2200), "{:?}", session.status());
    assert!(session.status().message.contains("the engine does not idle"), "{:?}", session.status());
}

/// In real time: the throttle opens, then a fault ends power by the same path as on the simulated rig.
#[test]
fn a_cut_bus_ends_power() {
    let far = far();
    let mut session = running(&far);
    far.borrow_mut().bus_cut = true;
    for _ in 0..45 {
        session.step(None, Brake::Hold);
    }
    assert_eq!(session.cause(), Some(Cause::LinkLost));
    assert_eq!(far.borrow().duty, 2200);
}

#[test]
fn a_servo_that_does_not_obey_ends_the_ignition() {
    let far = far();
    let mut session = running(&far);
    far.borrow_mut().servo_fails = true;
    far.borrow_mut().stop_high = false;
    session.step(None, Brake::Hold);
    assert_eq!(session.cause(), Some(Cause::EmergencyStop));
    far.borrow_mut().stop_high = true;
    session.step(None, Brake::Hold);
    assert_eq!(far.borrow().duty, 800, "the servo is stuck open");
    assert!(!far.borrow().permitted, "and the engine has no ignition");
}
