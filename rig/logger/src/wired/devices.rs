//! The Raspberry Pi's own devices, by the kernel's interfaces.

use std::path::{Path, PathBuf};
use std::{fs, io};

use embedded_hal::pwm::{ErrorKind, ErrorType, SetDutyCycle};
use linux_embedded_hal::gpio_cdev::{Chip, LineRequestFlags};
use linux_embedded_hal::{CdevPin, I2cdev};

use super::{WiredRig, Wires};
use crate::hardware::HardwareError;

/// Where the devices are; the defaults are those of a Raspberry Pi wired as docs/rig.md shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Devices {
    /// The I²C bus.
    pub bus: PathBuf,
    /// The chip of the input and output lines.
    pub lines: PathBuf,
    /// Folder of the servo's pulse-width output.
    pub servo: PathBuf,
    /// Line of the actuator's MOSFET (header pin 33).
    pub brake_moves: u32,
    /// Line of the actuator's relay (header pin 16).
    pub brake_applies: u32,
    /// Line of the emergency stop (header pin 18).
    pub stop_loop: u32,
}

impl Default for Devices {
    fn default() -> Self {
        Self {
            bus: "/dev/i2c-1".into(),
            lines: "/dev/gpiochip0".into(),
            servo: "/sys/class/pwm/pwmchip0/pwm0".into(),
            brake_moves: 13,
            brake_applies: 23,
            stop_loop: 24,
        }
    }
}

/// The rig on a Raspberry Pi.
pub type LinuxRig = WiredRig<I2cdev, CdevPin, CdevPin, PwmFolder>;

/// Opens the devices, with the throttle closed and the brake's actuator at rest.
///
/// # Errors
/// If a device is missing, in use, or not permitted; the text names it.
pub fn open(devices: &Devices) -> Result<LinuxRig, HardwareError> {
    let bus = I2cdev::new(&devices.bus).map_err(|error| missing(&devices.bus, &error))?;
    let line = |number: u32, flags: LineRequestFlags| {
        Chip::new(&devices.lines)
            .and_then(|mut chip| chip.get_line(number))
            .and_then(|line| line.request(flags, 0, "sheave-rig"))
            .and_then(CdevPin::new)
            .map_err(|error| HardwareError::Output(format!("{}, line {number}: {error}", devices.lines.display())))
    };
    WiredRig::new(Wires {
        bus,
        brake_moves: line(devices.brake_moves, LineRequestFlags::OUTPUT)?,
        brake_applies: line(devices.brake_applies, LineRequestFlags::OUTPUT)?,
        stop_loop: line(devices.stop_loop, LineRequestFlags::INPUT)?,
        throttle: PwmFolder::open(&devices.servo)?,
    })
}

fn missing(path: &Path, error: &dyn std::fmt::Display) -> HardwareError {
    HardwareError::Output(format!("{}: {error}", path.display()))
}

/// Period of a servo's pulses.
const SERVO_PERIOD_NS: u32 = 20_000_000;

/// A pulse-width output as the kernel shows it: a folder with the files `period`, `duty_cycle` and `enable`.
#[derive(Debug)]
pub struct PwmFolder {
    duty_cycle: PathBuf,
}

/// A pulse-width output could not be set.
#[derive(Debug)]
pub struct PwmError(io::ErrorKind);

impl embedded_hal::pwm::Error for PwmError {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Other
    }
}

impl std::fmt::Display for PwmError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}

impl PwmFolder {
    /// Takes the output, exporting it if the kernel has not yet, at a servo's period.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn open(folder: &Path) -> Result<Self, HardwareError> {
        let write = |path: PathBuf, text: &str| fs::write(&path, text).map_err(|error| missing(&path, &error));
        if !folder.exists()
            && let (Some(chip), Some(name)) = (folder.parent(), folder.file_name().and_then(|name| name.to_str()))
        {
            write(chip.join("export"), name.trim_start_matches("pwm"))?;
        }
        write(folder.join("period"), &SERVO_PERIOD_NS.to_string())?;
        write(folder.join("enable"), "1")?;
        Ok(Self { duty_cycle: folder.join("duty_cycle") })
    }
}

impl ErrorType for PwmFolder {
    type Error = PwmError;
}

impl SetDutyCycle for PwmFolder {
    fn max_duty_cycle(&self) -> u16 {
        20_000
    }

    fn set_duty_cycle(&mut self, duty: u16) -> Result<(), PwmError> {
        let nanoseconds = u64::from(duty) * u64::from(SERVO_PERIOD_NS) / u64::from(self.max_duty_cycle());
        fs::write(&self.duty_cycle, nanoseconds.to_string()).map_err(|error| PwmError(error.kind()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_servo_s_pulses_are_those_of_the_thesis() {
        let folder = tempfile::tempdir().unwrap();
        let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
        let mut servo = PwmFolder::open(folder.path()).unwrap();
        servo.set_duty_cycle_fraction(110, 1000).unwrap();
        assert_eq!(
            (read("period"), read("enable"), read("duty_cycle")),
            ("20000000".into(), "1".into(), "2200000".into())
        );
        servo.set_duty_cycle_fraction(40, 1000).unwrap();
        assert_eq!(read("duty_cycle"), "800000");
    }

    #[test]
    fn a_missing_device_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let devices = Devices { bus: folder.path().join("i2c-1"), ..Devices::default() };
        let Err(error) = open(&devices) else { panic!("there is no such bus") };
        assert!(error.to_string().contains("i2c-1"), "{error}");
        let Err(error) = PwmFolder::open(&folder.path().join("pwm0")) else { panic!("there is no such output") };
        assert!(error.to_string().contains("pwm0"), "{error}");
    }
}
