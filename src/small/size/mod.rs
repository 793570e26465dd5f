//! Sizing of a belt drive: the torques and the inertia that its motor has to deal with, (3.21) to (3.27) of the chapter
//! on power transmission in R. Crowder, *Electric Drives and Electromechanical Systems*.
//!
//! ```
//! use sheave::small::size::{BeltDrive, size};
//! // 50 kg on a belt that a pulley of 100 mm moves against 20 N of friction.
//! let drive = BeltDrive { linear_mass: 50.0, friction_force: 20.0, ..BeltDrive::new(0.1) };
//! let sizing = size(&drive)?;
//! assert!((sizing.inertia.load - 0.125).abs() < 1e-15); // 50 · 0.1²/4
//! assert_eq!(sizing.torque.friction, 1.0); // 0.1 · 20/2
//! # Ok::<(), sheave::small::size::SizeError>(())
//! ```

mod error;
mod file;
mod keys;

pub use error::{SizeError, SizeProblem};
pub use keys::{Entry, IDLER, TABLE};

use crate::formula::Inputs;
use generated::{DRIVE_SIZING, DRIVE_SIZING_IDLER, DriveSizingIdlerOutput, DriveSizingInput, DriveSizingOutput};
use serde::Serialize;

/// A belt drive, SI. What is zero is not there.
#[derive(Debug, Clone, PartialEq)]
pub struct BeltDrive {
    /// M, mass of the belt, kg.
    pub belt_mass: f64,
    /// M, mass that the belt moves in a straight line, kg.
    pub linear_mass: f64,
    /// F, external force on the belt against its motion, N.
    pub force: f64,
    /// F_f, friction force on what the belt moves in a straight line, N.
    pub friction_force: f64,
    /// D_in, m.
    pub input_diameter: f64,
    /// I_p1, kg·m².
    pub input_inertia: f64,
    /// D_out, m; of the same size as the input's for a belt that only conveys.
    pub output_diameter: f64,
    /// I_p2, of the output pulley itself, kg·m².
    pub output_inertia: f64,
    /// I_RL, of the rotary load on the output pulley, kg·m².
    pub load_inertia: f64,
    /// T_out, that the application takes from the output pulley, N·m.
    pub load_torque: f64,
    /// Angular acceleration of the input, rad/s².
    pub acceleration: f64,
    /// All idlers.
    pub idlers: Vec<Idler>,
}

/// A pulley that only turns with the belt.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Idler {
    /// kg·m².
    pub inertia: f64,
    /// m.
    pub diameter: f64,
}

/// What the input of a belt drive sees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Sizing {
    /// n, diameter of the output over that of the input pulley (3.25).
    pub ratio: f64,
    /// Inertia at the input.
    pub inertia: Inertia,
    /// Torque at the input.
    pub torque: Torque,
}

/// Inertia at the input, kg·m².
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Inertia {
    /// I_L, of the belt and of what it moves in a straight line (3.22).
    pub load: f64,
    /// Of the idlers.
    pub idlers: f64,
    /// I_p, of all that rotates, idlers included (3.21).
    pub rotating: f64,
    /// I_tot (3.21), (3.27).
    pub total: f64,
}

/// Torque at the input, N·m.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Torque {
    /// T_ext, for the external force (3.23).
    pub external: f64,
    /// T_f, for the friction force (3.24).
    pub friction: f64,
    /// T_i, for the load torque (3.26).
    pub load: f64,
    /// These three.
    pub steady: f64,
    /// For the acceleration of the total inertia.
    pub acceleration: f64,
    /// All together.
    pub drive: f64,
}

impl BeltDrive {
    /// Two pulleys of that diameter in m, and nothing else.
    pub fn new(diameter: f64) -> Self {
        Self {
            belt_mass: 0.0,
            linear_mass: 0.0,
            force: 0.0,
            friction_force: 0.0,
            input_diameter: diameter,
            input_inertia: 0.0,
            output_diameter: diameter,
            output_inertia: 0.0,
            load_inertia: 0.0,
            load_torque: 0.0,
            acceleration: 0.0,
            idlers: Vec::new(),
        }
    }

    /// Inertia of the idlers at the input, kg·m².
    fn idlers_at_input(&self) -> f64 {
        let reflected = |idler: &Idler| {
            let inputs = [
                (DriveSizingInput::InputDiameter, self.input_diameter),
                (DriveSizingInput::IdlerDiameter, idler.diameter),
                (DriveSizingInput::OwnInertia, idler.inertia),
            ];
            Inputs::new(&DRIVE_SIZING_IDLER).with(&inputs).outputs().get(DriveSizingIdlerOutput::ReflectedInertia)
        };
        self.idlers.iter().map(reflected).sum()
    }
}

/// Sizes a drive.
///
/// # Errors
/// [`SizeProblem::OutOfRange`] names the first quantity that is out of its range.
pub fn size(drive: &BeltDrive) -> Result<Sizing, SizeError> {
    keys::check(drive)?;
    let idlers = drive.idlers_at_input();
    let outputs = Inputs::new(&DRIVE_SIZING)
        .with(&[
            (DriveSizingInput::BeltMass, drive.belt_mass),
            (DriveSizingInput::LoadMass, drive.linear_mass),
            (DriveSizingInput::InputDiameter, drive.input_diameter),
            (DriveSizingInput::OutputDiameter, drive.output_diameter),
            (DriveSizingInput::ExternalForce, drive.force),
            (DriveSizingInput::FrictionForce, drive.friction_force),
            (DriveSizingInput::OutputTorque, drive.load_torque),
            (DriveSizingInput::InputPulleyInertia, drive.input_inertia),
            (DriveSizingInput::OutputPulleyInertia, drive.output_inertia),
            (DriveSizingInput::RotaryLoadInertia, drive.load_inertia),
            (DriveSizingInput::IdlerInertia, idlers),
            (DriveSizingInput::Acceleration, drive.acceleration),
        ])
        .outputs();
    let sizing = Sizing {
        ratio: outputs.get(DriveSizingOutput::Ratio),
        inertia: Inertia {
            load: outputs.get(DriveSizingOutput::LoadInertia),
            idlers,
            rotating: outputs.get(DriveSizingOutput::RotatingInertia),
            total: outputs.get(DriveSizingOutput::TotalInertia),
        },
        torque: Torque {
            external: outputs.get(DriveSizingOutput::ExternalTorque),
            friction: outputs.get(DriveSizingOutput::FrictionTorque),
            load: outputs.get(DriveSizingOutput::InputTorque),
            steady: outputs.get(DriveSizingOutput::SteadyTorque),
            acceleration: outputs.get(DriveSizingOutput::AccelerationTorque),
            drive: outputs.get(DriveSizingOutput::DriveTorque),
        },
    };
    let (inertia, torque) = (&sizing.inertia, &sizing.torque);
    let all = [inertia.rotating, inertia.total, torque.steady, torque.drive, sizing.ratio];
    if all.iter().all(|value| value.is_finite()) {
        Ok(sizing)
    } else {
        Err(SizeError::new(SizeProblem::Overflow, None))
    }
}
