//! The simple belt drive: from two speeds, torques and axial forces to the speed v_0 of the unstretched belt, in the
//! seven situations of Z. Wang, *Belt Velocity Initialization* (2012).
//!
//! The belt adheres where it enters a pulley and slides on an angle Φ before it leaves; it does not move up or down the
//! groove. Torques are those of the belt on the pulleys in the direction of rotation: the output's is positive and the
//! input's negative where the input drives; the other way round where the output drives.
//!
//! ```
//! use sheave::small::init::{SimpleDrive, Situation, solve};
//! let drive = SimpleDrive {
//!     input_radius: 0.0683, output_radius: 0.0683, half_contact_angle: std::f64::consts::FRAC_PI_2,
//!     longitudinal_stiffness: 243.5e3, mass_per_length: 0.4375, friction_coefficient: 1.92, half_angle: 0.2094,
//! };
//! let state = solve(&drive, Situation::One { input_speed: 356.0, output_torque: 17.0, output_axial_force: 500.0 })?;
//! assert!(state.output_speed < 356.0 && state.belt_speed < 0.0683 * 356.0);
//! # Ok::<(), sheave::small::init::InitError>(())
//! ```

mod newton;
mod state;

pub use state::{InitError, InitialState, Method, PulleyId};

use crate::case::{Clamp, Load, Resolved, Speed, geometry};
use crate::formula::{Inputs, Outputs};
use generated::{
    BELT_PULLEY_LIMITS, BeltPulleyLimit, BeltPulleyLimitInput, FormulaKernel, Identity, SIMPLE_DRIVE,
    SIMPLE_DRIVE_CLOSED, SimpleDriveInput as Given, SimpleDriveOutput as Derived, SimpleDriveResidual as Residual,
};
use newton::System;
use state::check_given;
use std::f64::consts::PI;

/// A belt drive, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SimpleDrive {
    /// r_I, radius of the input pulley, m.
    pub input_radius: f64,
    /// r_O, radius of the output pulley, m.
    pub output_radius: f64,
    /// φ, half the contact angle on the output pulley, rad; on the input pulley it is π − φ.
    pub half_contact_angle: f64,
    /// EA of the belt, N.
    pub longitudinal_stiffness: f64,
    /// m*, mass per length of the unstretched belt, kg/m.
    pub mass_per_length: f64,
    /// μ*, coefficient of friction in the groove: that on the sheave's face over sin δ_0.
    pub friction_coefficient: f64,
    /// δ_0, half angle of the groove, rad.
    pub half_angle: f64,
}

/// What is given, by the sections of the source. Speeds in rad/s, forces in N; torques in N·m, those of the belt on the
/// pulley: `output_torque` is positive and `input_torque` negative where the input drives.
#[derive(Debug, Clone, Copy, PartialEq)]
#[expect(missing_docs, reason = "the fields' names say it all")]
pub enum Situation {
    /// ω_I, M_O, F_CO; for ω_O and v_0.
    One { input_speed: f64, output_torque: f64, output_axial_force: f64 },
    /// ω_O, M_I, F_CI; for ω_I and v_0.
    Two { output_speed: f64, input_torque: f64, input_axial_force: f64 },
    /// ω_I, ω_O, F_CO; for M_O and v_0.
    Three { input_speed: f64, output_speed: f64, output_axial_force: f64 },
    /// ω_I, ω_O, F_CI; for M_I and v_0.
    Four { input_speed: f64, output_speed: f64, input_axial_force: f64 },
    /// ω_I, M_O, F_CI; for ω_O and v_0.
    Five { input_speed: f64, output_torque: f64, input_axial_force: f64 },
    /// ω_I, M_I, F_CO; for ω_O and v_0.
    Six { input_speed: f64, input_torque: f64, output_axial_force: f64 },
    /// ω_I, M_I, F_CI; for ω_O and v_0.
    Seven { input_speed: f64, input_torque: f64, input_axial_force: f64 },
}

/// Solves a situation: in closed form where no torque is transmitted, else by Newton's method for v_0 and the other
/// unknown.
///
/// # Errors
/// See [`InitError`].
pub fn solve(drive: &SimpleDrive, situation: Situation) -> Result<InitialState, InitError> {
    drive.check()?;
    situation.check()?;
    let problem = Problem { drive: *drive, situation };
    if problem.is_unloaded() { problem.unloaded() } else { problem.loaded() }
}

impl SimpleDrive {
    /// The drive of a case, on tangent lines (6.10).
    pub fn of_case(case: &Resolved) -> Self {
        let (primary, secondary) = (case.drive.primary_radius, case.drive.secondary_radius);
        let (_, contact) = geometry::wrap_angles(primary, secondary, case.drive.center_distance);
        let face = [
            (BeltPulleyLimitInput::FaceFriction, case.sheave.friction_coefficient),
            (BeltPulleyLimitInput::GrooveAngle, 2.0 * case.sheave.half_angle),
        ];
        Self {
            input_radius: primary,
            output_radius: secondary,
            half_contact_angle: contact / 2.0,
            longitudinal_stiffness: case.belt.longitudinal_stiffness,
            mass_per_length: case.belt.mass_per_length,
            friction_coefficient: Inputs::new(&BELT_PULLEY_LIMITS)
                .with(&face)
                .outputs()
                .get(BeltPulleyLimit::WedgeCoefficient),
            half_angle: case.sheave.half_angle,
        }
    }

    /// Contact angle of a pulley, rad.
    pub fn contact_angle(&self, pulley: PulleyId) -> f64 {
        match pulley {
            PulleyId::Input => 2.0 * (PI - self.half_contact_angle),
            PulleyId::Output => 2.0 * self.half_contact_angle,
        }
    }

    fn check(&self) -> Result<(), InitError> {
        let below = |limit: f64| move |value: f64| value > 0.0 && value < limit;
        for (what, unit, value, limit) in [
            ("input_radius", "m", self.input_radius, f64::INFINITY),
            ("output_radius", "m", self.output_radius, f64::INFINITY),
            ("half_contact_angle", "rad", self.half_contact_angle, PI),
            ("longitudinal_stiffness", "N", self.longitudinal_stiffness, f64::INFINITY),
            ("mass_per_length", "kg/m", self.mass_per_length, f64::INFINITY),
            ("friction_coefficient", "", self.friction_coefficient, f64::INFINITY),
            ("half_angle", "rad", self.half_angle, PI / 2.0),
        ] {
            check_given(
                what,
                unit,
                value,
                below(limit),
                "a positive number, for an angle one that the drive can have",
            )?;
        }
        Ok(())
    }

    /// The drive's inputs of a set of formulae, friction towards the sign of the output's torque.
    fn inputs<O: Identity>(&self, kernel: &'static FormulaKernel<Given, O>, sign: f64) -> Inputs<Given, O> {
        Inputs::new(kernel).with(&[
            (Given::InputRadius, self.input_radius),
            (Given::OutputRadius, self.output_radius),
            (Given::HalfContactAngle, self.half_contact_angle),
            (Given::LongitudinalStiffness, self.longitudinal_stiffness),
            (Given::MassPerLength, self.mass_per_length),
            (Given::GrooveFriction, self.friction_coefficient.copysign(sign)),
            (Given::HalfAngle, self.half_angle),
        ])
    }
}

impl Situation {
    /// Its number in the source.
    pub fn number(&self) -> u8 {
        match self {
            Self::One { .. } => 1,
            Self::Two { .. } => 2,
            Self::Three { .. } => 3,
            Self::Four { .. } => 4,
            Self::Five { .. } => 5,
            Self::Six { .. } => 6,
            Self::Seven { .. } => 7,
        }
    }

    /// The situation that a case's operating point is, its torques positive where the primary drives; with `no_load`
    /// the torque is zero, and two speeds follow from the primary's.
    ///
    /// # Errors
    /// [`InitError::NoSituation`] if it is none of the seven, [`InitError::FreeRadius`] if a radius is solved for.
    pub fn of_case(case: &Resolved, no_load: bool) -> Result<Self, InitError> {
        if case.drive.free.is_some() {
            return Err(InitError::FreeRadius);
        }
        let point = &case.operating_point;
        let load = |torque: f64| if no_load { 0.0 } else { torque };
        let ratio = case.drive.primary_radius / case.drive.secondary_radius;
        let output = |speed: f64, of_input: f64| if no_load { of_input * ratio } else { speed };
        match (point.speed, point.load, point.clamp) {
            (Speed::Primary(input_speed), Load::SecondaryTorque(torque), Clamp::SecondaryAxialForce(force)) => {
                Ok(Self::One { input_speed, output_torque: load(torque), output_axial_force: force })
            }
            (Speed::Secondary(output_speed), Load::PrimaryTorque(torque), Clamp::PrimaryAxialForce(force)) => {
                Ok(Self::Two { output_speed, input_torque: -load(torque), input_axial_force: force })
            }
            (Speed::Primary(input_speed), Load::SecondarySpeed(speed), clamp) => {
                Self::of_speeds(input_speed, output(speed, input_speed), clamp)
            }
            (Speed::Primary(input_speed), Load::SpeedRatio(ratio), clamp) => {
                Self::of_speeds(input_speed, output(ratio * input_speed, input_speed), clamp)
            }
            (Speed::Primary(input_speed), Load::SecondaryTorque(torque), Clamp::PrimaryAxialForce(force)) => {
                Ok(Self::Five { input_speed, output_torque: load(torque), input_axial_force: force })
            }
            (Speed::Primary(input_speed), Load::PrimaryTorque(torque), Clamp::SecondaryAxialForce(force)) => {
                Ok(Self::Six { input_speed, input_torque: -load(torque), output_axial_force: force })
            }
            (Speed::Primary(input_speed), Load::PrimaryTorque(torque), Clamp::PrimaryAxialForce(force)) => {
                Ok(Self::Seven { input_speed, input_torque: -load(torque), input_axial_force: force })
            }
            _ => Err(InitError::NoSituation),
        }
    }

    fn of_speeds(input_speed: f64, output_speed: f64, clamp: Clamp) -> Result<Self, InitError> {
        match clamp {
            Clamp::SecondaryAxialForce(output_axial_force) => {
                Ok(Self::Three { input_speed, output_speed, output_axial_force })
            }
            Clamp::PrimaryAxialForce(input_axial_force) => {
                Ok(Self::Four { input_speed, output_speed, input_axial_force })
            }
            _ => Err(InitError::NoSituation),
        }
    }

    /// The inputs of the formulae that are given, with their values.
    fn given(&self) -> [(Given, f64); 3] {
        match *self {
            Self::One { input_speed, output_torque, output_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::OutputTorque, output_torque),
                (Given::OutputAxialForce, output_axial_force),
            ],
            Self::Two { output_speed, input_torque, input_axial_force } => [
                (Given::OutputSpeed, output_speed),
                (Given::InputTorque, input_torque),
                (Given::InputAxialForce, input_axial_force),
            ],
            Self::Three { input_speed, output_speed, output_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::OutputSpeed, output_speed),
                (Given::OutputAxialForce, output_axial_force),
            ],
            Self::Four { input_speed, output_speed, input_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::OutputSpeed, output_speed),
                (Given::InputAxialForce, input_axial_force),
            ],
            Self::Five { input_speed, output_torque, input_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::OutputTorque, output_torque),
                (Given::InputAxialForce, input_axial_force),
            ],
            Self::Six { input_speed, input_torque, output_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::InputTorque, input_torque),
                (Given::OutputAxialForce, output_axial_force),
            ],
            Self::Seven { input_speed, input_torque, input_axial_force } => [
                (Given::InputSpeed, input_speed),
                (Given::InputTorque, input_torque),
                (Given::InputAxialForce, input_axial_force),
            ],
        }
    }

    fn value(&self, input: Given) -> Option<f64> {
        self.given().into_iter().find(|(given, _)| *given == input).map(|(_, value)| value)
    }

    /// The pulley whose axial force is given.
    fn clamped(&self) -> PulleyId {
        if self.value(Given::OutputAxialForce).is_some() { PulleyId::Output } else { PulleyId::Input }
    }

    fn check(&self) -> Result<(), InitError> {
        for (input, value) in self.given() {
            let what = match input {
                Given::InputSpeed => "input_speed",
                Given::OutputSpeed => "output_speed",
                Given::InputTorque => "input_torque",
                Given::OutputTorque => "output_torque",
                Given::InputAxialForce => "input_axial_force",
                Given::OutputAxialForce => "output_axial_force",
                // The drive's own are checked with it.
                _ => continue,
            };
            let unit = input.symbol().unit;
            match input {
                Given::InputTorque | Given::OutputTorque => {
                    check_given(what, unit, value, f64::is_finite, "a finite number")?;
                }
                _ => check_given(what, unit, value, |value| value > 0.0, "a positive number")?,
            }
        }
        Ok(())
    }
}

/// The closed forms with their inputs.
type ClosedForms = Inputs<Given, Derived>;

/// A drive in a situation.
struct Problem {
    drive: SimpleDrive,
    situation: Situation,
}

impl Problem {
    /// Sign of the output's torque; 0 without a torque, where two given speeds differ by rounding alone included.
    fn sign(&self) -> f64 {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let value = |name| self.situation.value(name);
        let (excess, least) = match (
            value(Given::OutputTorque),
            value(Given::InputTorque),
            value(Given::InputSpeed),
            value(Given::OutputSpeed),
        ) {
            (Some(torque), ..) => (torque, 0.0),
            (_, Some(torque), ..) => (-torque, 0.0),
            (_, _, Some(input), Some(output)) => {
                let (input, output) = (self.drive.input_radius * input, self.drive.output_radius * output);
                (input - output, ROUNDING * input)
            }
            _ => (0.0, 0.0),
        };
        if excess.abs() <= least { 0.0 } else { excess.signum() }
    }

    fn is_unloaded(&self) -> bool {
        self.sign() == 0.0
    }

    fn inputs<O: Identity>(&self, kernel: &'static FormulaKernel<Given, O>) -> Inputs<Given, O> {
        self.drive.inputs(kernel, self.sign()).with(&self.situation.given())
    }

    /// The closed forms, v_0 and both speeds aside.
    fn closed(&self) -> ClosedForms {
        let mut inputs = self.inputs(&SIMPLE_DRIVE_CLOSED);
        let rim = match self.situation.value(Given::InputSpeed) {
            Some(speed) => self.drive.input_radius * speed,
            None => self.drive.output_radius * inputs.get(Given::OutputSpeed),
        };
        inputs.set(Given::RimSpeed, rim);
        // (11), (20): whichever torque is given, the other follows.
        let torques = inputs.outputs();
        if self.situation.value(Given::InputTorque).is_some() {
            inputs.set(Given::OutputTorque, torques.get(Derived::OutputTorqueFromInput));
        } else if self.situation.value(Given::OutputTorque).is_some() {
            inputs.set(Given::InputTorque, torques.get(Derived::InputTorqueFromOutput));
        }
        inputs
    }

    /// v_0 at no torque: 2.220 from F_CO, (15) from F_CI.
    fn no_load_speed(&self, closed: &Outputs<Given, Derived>) -> f64 {
        closed.get(match self.situation.clamped() {
            PulleyId::Output => Derived::BeltSpeedFromOutputForce,
            PulleyId::Input => Derived::BeltSpeedFromInputForce,
        })
    }

    /// What follows from v_0 for the other unknown: (21), (2), (17), (19).
    fn complete(&self, inputs: &mut ClosedForms, v_0: f64) {
        inputs.set(Given::BeltSpeed, v_0);
        let value = |name| self.situation.value(name).is_some();
        match (value(Given::InputSpeed), value(Given::OutputSpeed)) {
            (true, true) => {
                let outputs = inputs.outputs();
                inputs.set(Given::OutputTorque, outputs.get(Derived::OutputTorqueFromSpeeds));
                inputs.set(Given::InputTorque, outputs.get(Derived::InputTorqueFromSpeeds));
            }
            (true, false) => inputs.set(Given::OutputSpeed, inputs.outputs().get(Derived::OutputSpeedFromTorque)),
            _ => inputs.set(Given::InputSpeed, inputs.outputs().get(Derived::InputSpeedFromTorque)),
        }
    }

    fn unloaded(&self) -> Result<InitialState, InitError> {
        let mut inputs = self.closed();
        inputs.set(Given::OutputTorque, 0.0);
        inputs.set(Given::InputTorque, 0.0);
        let v_0 = self.no_load_speed(&inputs.outputs());
        self.complete(&mut inputs, v_0);
        inputs.set(Given::OutputTorque, 0.0);
        inputs.set(Given::InputTorque, 0.0);
        InitialState::read(&self.drive, &inputs, Method::Closed)
    }

    fn loaded(&self) -> Result<InitialState, InitError> {
        let mut closed = self.closed();
        let start = self.no_load_speed(&closed.outputs());
        self.start(&mut closed, start)?;
        let (equations, unknown) = match self.situation {
            Situation::One { .. } | Situation::Six { .. } => {
                ([Residual::OutputSpeedBalance, Residual::OutputAxialBalance], Given::OutputSpeed)
            }
            Situation::Two { .. } => ([Residual::OutputSpeedBalance, Residual::InputAxialBalance], Given::InputSpeed),
            Situation::Three { .. } => {
                ([Residual::OutputSpeedBalance, Residual::OutputAxialBalance], Given::OutputTorque)
            }
            Situation::Four { .. } => ([Residual::InputSpeedBalance, Residual::InputAxialBalance], Given::InputTorque),
            Situation::Five { .. } => ([Residual::OutputSpeedBalance, Residual::InputAxialBalance], Given::OutputSpeed),
            Situation::Seven { .. } => ([Residual::InputSpeedBalance, Residual::InputAxialBalance], Given::OutputSpeed),
        };
        let residuals = self.inputs(&SIMPLE_DRIVE);
        let system = System { drive: &self.drive, equations, unknown, clamped: self.situation.clamped() };
        let iterations = system.solve(residuals, &mut closed)?;
        // The torque that was not among the unknowns.
        match unknown {
            Given::OutputTorque => closed.set(Given::InputTorque, closed.outputs().get(Derived::InputTorqueFromOutput)),
            Given::InputTorque => closed.set(Given::OutputTorque, closed.outputs().get(Derived::OutputTorqueFromInput)),
            _ => {}
        }
        InitialState::read(&self.drive, &closed, Method::Newton { iterations })
    }

    /// The start: v_0 as without a torque, and where the belt would then lift off or slide all over, slower by the
    /// strain that the torque takes, twice that, four times.
    fn start(&self, closed: &mut ClosedForms, v_0: f64) -> Result<(), InitError> {
        self.complete(closed, v_0);
        let torque = closed.get(Given::OutputTorque).abs();
        let strain = torque / (self.drive.output_radius * self.drive.longitudinal_stiffness);
        let mut slower = 0.0;
        while !newton::is_possible(&self.drive, closed, self.situation.clamped()) {
            slower = if slower == 0.0 { strain } else { 2.0 * slower };
            // Nor does a strain of zero, where the torque is too small to be told, lead anywhere.
            if !(slower > 0.0 && slower < 1.0) {
                return Err(InitError::Overloaded { torque });
            }
            self.complete(closed, v_0 * (1.0 - slower));
        }
        Ok(())
    }
}
