//! What the logger needs of a rig, real or simulated.

use rig_core::Identity;
use rig_core::frame::FRAME_LENGTH;

/// What the brake's actuator does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Brake {
    /// Nothing: the brake keeps its position.
    Hold,
    /// It moves towards more braking.
    Apply,
    /// It moves towards less.
    Release,
}

/// All outputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// Throttle: wide open, or closed.
    pub throttle_open: bool,
    /// Ignition is permitted; sent to the measuring device, which holds the relay, with every frame that is asked for.
    pub ignition: bool,
    /// The brake.
    pub brake: Brake,
}

/// Why something did not work.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HardwareError {
    /// The bus.
    #[error("the I2C bus failed: {0}")]
    Bus(String),
    /// A frame that came in is not a good one.
    #[error("a frame was not good: {0}")]
    Frame(#[from] rig_core::FrameError),
    /// An output.
    #[error("an output could not be set: {0}")]
    Output(String),
    /// The infrared sensor.
    #[error("the rotor's temperature could not be read: {0}")]
    Temperature(String),
}

/// A rig.
pub trait Hardware {
    /// Time since the program started, µs; never runs backwards.
    fn now(&mut self) -> u64;
    /// Returns at a time, µs.
    fn wait_until(&mut self, time: u64);
    /// Whether time passes as it does outside; false for a simulated rig that runs as fast as it can.
    fn real_time(&self) -> bool;
    /// Renews or withdraws the run permit and reads the versioned frame, in one transfer.
    ///
    /// # Errors
    /// If the bus fails; the frame itself is checked by the caller.
    fn exchange(&mut self, permit: bool) -> Result<[u8; FRAME_LENGTH], HardwareError>;
    /// Reads what the firmware says of itself.
    ///
    /// # Errors
    /// If the bus fails or the answer is not good.
    fn identity(&mut self) -> Result<Identity, HardwareError>;
    /// The brake rotor's temperature, °C.
    ///
    /// # Errors
    /// If the sensor does not answer.
    fn rotor_temperature(&mut self) -> Result<f64, HardwareError>;
    /// Whether the emergency stop is pressed. A wire that is cut counts as pressed.
    fn emergency_stop(&mut self) -> bool;
    /// Sets throttle and brake.
    ///
    /// # Errors
    /// If an output cannot be set.
    fn set(&mut self, outputs: &Outputs) -> Result<(), HardwareError>;
}

/// Temperature from the MLX90614's register: 0.02 K a count; bit 15 reports an error (data sheet).
///
/// # Errors
/// If the error bit is set.
pub fn mlx90614_celsius(raw: u16) -> Result<f64, HardwareError> {
    if raw & 0x8000 != 0 || raw == 0 {
        return Err(HardwareError::Temperature(format!("the sensor reports an error (0x{raw:04x})")));
    }
    Ok(f64::from(raw) * 0.02 - 273.15)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temperatures_are_those_of_the_data_sheet() {
        assert!((mlx90614_celsius(0x3af7).unwrap() - 28.75).abs() < 0.01);
        assert!(mlx90614_celsius(0x8000).is_err() && mlx90614_celsius(0).is_err());
    }
}
