//! The real rig, over the traits of `embedded-hal`: a bus, two lines for the brake, one for the emergency stop, a
//! servo.
//!
//! With the feature `linux`, [`open`] takes them from `/dev/i2c-1`, `/dev/gpiochip0` and `/sys/class/pwm`; the tests
//! take them from a device that is made up.

use std::time::{Duration, Instant};

use embedded_hal::digital::{InputPin, OutputPin};
use embedded_hal::i2c::I2c;
use embedded_hal::pwm::SetDutyCycle;
use rig_core::Identity;
use rig_core::frame::{BUS_ADDRESS, FRAME_LENGTH, IDENTITY_LENGTH};
use rig_core::wire::{GRANT, REGISTER_IDENTITY, REGISTER_PERMIT, WITHDRAW};

use crate::hardware::{Brake, Hardware, HardwareError, Outputs, mlx90614_celsius};

#[cfg(feature = "linux")]
mod devices;
#[cfg(feature = "linux")]
pub use devices::{Devices, LinuxRig, PwmFolder, open};

/// The infrared sensor's address, and its register of the object's temperature (data sheet).
const INFRARED_ADDRESS: u8 = 0x5a;
const OBJECT_TEMPERATURE: u8 = 0x07;
/// The check of an SMBus transfer.
const PACKET_CHECK: crc::Crc<u8> = crc::Crc::<u8>::new(&crc::CRC_8_SMBUS);
/// Share of the servo's period of 20 ms, in thousandths, for a closed and an open throttle (Appendix H: 11 and 4 %).
const SERVO_CLOSED: u16 = 110;
const SERVO_OPEN: u16 = 40;
/// The relay that turns the actuator round switches without current, and is given this long for it.
const RELAY_TIME: Duration = Duration::from_millis(15);

/// Everything that the logger's computer is wired to.
#[derive(Debug)]
pub struct Wires<B, O, I, S> {
    /// The bus with the measuring device and the infrared sensor.
    pub bus: B,
    /// The actuator's MOSFET: high moves it.
    pub brake_moves: O,
    /// The actuator's relay: high applies, low releases.
    pub brake_applies: O,
    /// The emergency stop's loop: high while it is closed. A pressed button and a cut wire both read low.
    pub stop_loop: I,
    /// The throttle's servo.
    pub throttle: S,
}

/// A rig behind wires.
pub struct WiredRig<B, O: OutputPin, I, S: SetDutyCycle> {
    wires: Wires<B, O, I, S>,
    started: Instant,
    throttle_open: Option<bool>,
    direction: Option<(Brake, Instant)>,
}

impl<B, O: OutputPin, I, S: SetDutyCycle> WiredRig<B, O, I, S> {
    /// Closes the throttle and stops the brake's actuator.
    ///
    /// # Errors
    /// If an output cannot be set.
    pub fn new(wires: Wires<B, O, I, S>) -> Result<Self, HardwareError> {
        let mut rig = Self { wires, started: Instant::now(), throttle_open: None, direction: None };
        rig.set_throttle(false)?;
        rig.move_brake(Brake::Hold)?;
        Ok(rig)
    }

    fn set_throttle(&mut self, open: bool) -> Result<(), HardwareError> {
        if self.throttle_open == Some(open) {
            return Ok(());
        }
        let share = if open { SERVO_OPEN } else { SERVO_CLOSED };
        self.throttle_open = None;
        self.wires.throttle.set_duty_cycle_fraction(share, 1000).map_err(|error| failed("throttle", &error))?;
        self.throttle_open = Some(open);
        Ok(())
    }

    fn move_brake(&mut self, brake: Brake) -> Result<(), HardwareError> {
        let moves = |wires: &mut Wires<B, O, I, S>, moves: bool| {
            wires.brake_moves.set_state(moves.into()).map_err(|error| failed("brake actuator", &error))
        };
        if brake == Brake::Hold {
            return moves(&mut self.wires, false);
        }
        match self.direction {
            Some((direction, since)) if direction == brake => moves(&mut self.wires, since.elapsed() >= RELAY_TIME),
            Some(_) | None => {
                moves(&mut self.wires, false)?;
                let applies = brake == Brake::Apply;
                self.wires.brake_applies.set_state(applies.into()).map_err(|error| failed("brake relay", &error))?;
                self.direction = Some((brake, Instant::now()));
                Ok(())
            }
        }
    }
}

/// A rig that is let go of has its throttle closed and its actuator at rest, as far as the outputs still obey; the
/// ignition ends by itself, because nobody renews the run permit.
impl<B, O: OutputPin, I, S: SetDutyCycle> Drop for WiredRig<B, O, I, S> {
    fn drop(&mut self) {
        let _ = self.set_throttle(false);
        let _ = self.move_brake(Brake::Hold);
    }
}

fn failed(what: &str, error: &dyn std::fmt::Debug) -> HardwareError {
    HardwareError::Output(format!("{what}: {error:?}"))
}

impl<B: I2c, O: OutputPin, I: InputPin, S: SetDutyCycle> Hardware for WiredRig<B, O, I, S> {
    fn now(&mut self) -> u64 {
        self.started.elapsed().as_micros() as u64
    }

    fn wait_until(&mut self, time: u64) {
        std::thread::sleep(Duration::from_micros(time.saturating_sub(self.now())));
    }

    fn real_time(&self) -> bool {
        true
    }

    fn exchange(&mut self, permit: bool) -> Result<[u8; FRAME_LENGTH], HardwareError> {
        let mut bytes = [0; FRAME_LENGTH];
        let request = [REGISTER_PERMIT, if permit { GRANT } else { WITHDRAW }];
        let read = self.wires.bus.write_read(BUS_ADDRESS, &request, &mut bytes);
        read.map_err(|error| HardwareError::Bus(format!("{error:?}")))?;
        Ok(bytes)
    }

    fn identity(&mut self) -> Result<Identity, HardwareError> {
        let mut bytes = [0; IDENTITY_LENGTH];
        let read = self.wires.bus.write_read(BUS_ADDRESS, &[REGISTER_IDENTITY], &mut bytes);
        read.map_err(|error| HardwareError::Bus(format!("{error:?}")))?;
        Ok(Identity::from_bytes(&bytes)?)
    }

    fn rotor_temperature(&mut self) -> Result<f64, HardwareError> {
        let mut bytes = [0; 3];
        let read = self.wires.bus.write_read(INFRARED_ADDRESS, &[OBJECT_TEMPERATURE], &mut bytes);
        read.map_err(|error| HardwareError::Temperature(format!("{error:?}")))?;
        let [low, high, check] = bytes;
        // The check covers the whole transfer, both addresses with their direction bits included.
        let transfer = [INFRARED_ADDRESS << 1, OBJECT_TEMPERATURE, INFRARED_ADDRESS << 1 | 1, low, high];
        if PACKET_CHECK.checksum(&transfer) != check {
            return Err(HardwareError::Temperature("the check does not fit: the transfer was disturbed".to_owned()));
        }
        mlx90614_celsius(u16::from_le_bytes([low, high]))
    }

    fn emergency_stop(&mut self) -> bool {
        !matches!(self.wires.stop_loop.is_high(), Ok(true))
    }

    fn set(&mut self, outputs: &Outputs) -> Result<(), HardwareError> {
        // The throttle must close even where the brake does not obey.
        let throttle = self.set_throttle(outputs.throttle_open);
        let brake = self.move_brake(outputs.brake);
        throttle.and(brake)
    }
}
