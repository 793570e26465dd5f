//! Flyweights: what turns the primary's speed into an axial force.

use generated::{
    FLYWEIGHT_ARM, FLYWEIGHT_RAMP, FLYWEIGHT_ROLLER, FLYWEIGHT_TABLE, FlyweightArmInput, FlyweightArmOutput,
    FlyweightRampInput, FlyweightRampOutput, FlyweightRollerInput, FlyweightRollerOutput, FlyweightTableInput,
    FlyweightTableOutput,
};

use super::error::ActuatorError;
use super::profile::{Jet, Profile};
use super::shift::Shift;
use crate::formula::Inputs;

/// Newton steps that bring a roller onto its ramp, and the gap in metres that is none.
const CONTACT_STEPS: usize = 50;
const CONTACT_GAP: f64 = 1e-13;

/// Flyweights that are all alike.
#[derive(Debug, Clone, PartialEq)]
pub struct Flyweights {
    /// How many there are.
    pub count: u32,
    /// Mass of one, kg.
    pub mass: f64,
    /// How they bear on the movable sheave.
    pub mechanism: Mechanism,
}

/// How flyweights bear on the movable sheave. Travel s is in metres, positive where the sheave closes.
#[derive(Debug, Clone, PartialEq)]
pub enum Mechanism {
    /// r dr/ds is known over the travel, as a bench measures it (9.2).
    Coefficient {
        /// r dr/ds in m over s in m.
        coefficient: Profile,
        /// Share of the force that friction takes.
        lost: f64,
    },
    /// A wedge or roller that slides along a radius against a ramp.
    Ramp {
        /// Radius of the centre of mass in m over s in m.
        radius: Profile,
        /// Friction angle of the ramp, rad.
        friction_angle: f64,
    },
    /// A pivoted arm with a roller at its end, on a ramp of the movable sheave.
    RollerArm(RollerArm),
    /// A pivoted arm with a cam, against a roller.
    CamArm(CamArm),
}

/// A pivoted arm with a roller at its end.
#[derive(Debug, Clone, PartialEq)]
pub struct RollerArm {
    /// Radius of the pivot from the shaft, m.
    pub pivot_radius: f64,
    /// From the pivot to the roller's centre, m.
    pub arm_length: f64,
    /// From the pivot to the centre of mass, m.
    pub mass_distance: f64,
    /// From the line to the roller to that to the centre of mass, rad.
    pub mass_angle: f64,
    /// Radius in m to which the ramp lets the roller's centre, over the place on the ramp in m.
    pub ramp: Profile,
    /// Place on the ramp that the pivot faces at s = 0, m.
    pub ramp_start: f64,
    /// Friction angle of the roller, rad.
    pub friction_angle: f64,
}

/// A pivoted arm with a cam.
#[derive(Debug, Clone, PartialEq)]
pub struct CamArm {
    /// Radius of the pivot from the shaft, m.
    pub pivot_radius: f64,
    /// Radius of the roller's centre from the shaft, m.
    pub roller_radius: f64,
    /// From the pivot to the roller's centre along the shaft at s = 0, m.
    pub start: f64,
    /// From the pivot to the centre of mass, m.
    pub mass_distance: f64,
    /// Angle of the centre of mass in the arm, rad.
    pub mass_angle: f64,
    /// The cam's pitch curve: angle in the arm in rad over the distance from the pivot in m, for the roller's centre.
    pub pitch_curve: Profile,
    /// Friction angle of the roller, rad.
    pub friction_angle: f64,
}

/// An axial force of the primary with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlyweightForce {
    /// The force of all flyweights, N.
    pub value: f64,
    /// Its derivative with respect to the speed, N·s.
    pub by_speed: f64,
    /// Its derivative with respect to the travel, N/m.
    pub by_travel: f64,
    /// Its derivative with respect to the mass of one flyweight, N/kg.
    pub by_mass: f64,
    /// Its derivative with respect to the friction angle, N/rad; to the share that friction takes, N, where that is
    /// given.
    pub by_friction: f64,
}

/// A roller arm at an angle that is given, on a ramp of a slope that is given: what a ramp is designed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollerState {
    /// Axial force of all arms, N.
    pub force: f64,
    /// dθ/ds: turn of the arm over the travel, rad/m.
    pub turn: f64,
    /// From the pivot to the roller's centre along the shaft, m.
    pub along: f64,
}

/// A cam arm whose pitch curve has an angle and a slope that are given: what a cam is designed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CamState {
    /// Axial force of all arms, N.
    pub force: f64,
    /// From the pivot to the roller's centre, m.
    pub distance: f64,
    /// Its slope over the travel.
    pub distance_slope: f64,
}

impl RollerArm {
    /// `flyweights` of this arm at a speed in rad/s, the arms at `angle` in rad on a ramp of slope dh/dx.
    pub fn state(&self, flyweights: &Flyweights, speed: f64, shift: Shift, angle: f64, slope: f64) -> RollerState {
        use FlyweightRollerInput as Input;
        use FlyweightRollerOutput as Output;
        let mut formulae = self.formulae(flyweights, speed, shift);
        formulae.set(Input::ArmAngle, angle);
        formulae.set(Input::RampRadius, self.radius(angle));
        formulae.set(Input::RampSlope, slope);
        let found = formulae.outputs();
        let (force, turn) = (found.get(Output::Force), found.get(Output::AngleSlope));
        RollerState { force, turn, along: found.get(Output::Along) }
    }

    /// Radius of the roller's centre from the shaft in m, the arm at `angle` in rad.
    pub fn radius(&self, angle: f64) -> f64 {
        self.pivot_radius + self.arm_length * libm::sin(angle)
    }

    /// Angle of the arm in rad at which the roller bears on its ramp at a travel in m.
    ///
    /// # Errors
    /// [`ActuatorError::OffRamp`].
    pub fn angle(&self, travel: f64) -> Result<f64, ActuatorError> {
        let any = Flyweights { count: 1, mass: 1.0, mechanism: Mechanism::RollerArm(self.clone()) };
        let (formulae, _) = self.contact(self.formulae(&any, 1.0, Shift::Frictionless), travel)?;
        Ok(formulae.get(FlyweightRollerInput::ArmAngle))
    }

    /// All that does not depend on where the roller stands.
    fn formulae(
        &self,
        flyweights: &Flyweights,
        speed: f64,
        shift: Shift,
    ) -> Inputs<FlyweightRollerInput, FlyweightRollerOutput> {
        use FlyweightRollerInput as Input;
        Inputs::new(&FLYWEIGHT_ROLLER).with(&[
            (Input::Count, f64::from(flyweights.count)),
            (Input::Mass, flyweights.mass),
            (Input::Speed, speed),
            (Input::PivotRadius, self.pivot_radius),
            (Input::ArmLength, self.arm_length),
            (Input::MassDistance, self.mass_distance),
            (Input::MassAngle, self.mass_angle),
            (Input::FrictionAngle, shift.sign() * self.friction_angle),
            (Input::ArmAngle, 0.0),
            (Input::RampRadius, 0.0),
            (Input::RampSlope, 0.0),
        ])
    }

    /// Newton's method for the arm's angle at which the roller bears on the ramp; with the ramp there.
    fn contact(
        &self,
        mut formulae: Inputs<FlyweightRollerInput, FlyweightRollerOutput>,
        travel: f64,
    ) -> Result<(Inputs<FlyweightRollerInput, FlyweightRollerOutput>, Jet), ActuatorError> {
        use FlyweightRollerInput as Input;
        use FlyweightRollerOutput as Output;
        for _ in 0..CONTACT_STEPS {
            let along = formulae.outputs().get(Output::Along);
            let jet = self.ramp.at(self.ramp_start + travel - along);
            formulae.set(Input::RampRadius, jet.value);
            formulae.set(Input::RampSlope, jet.slope);
            let found = formulae.linearised();
            let gap = found.get(Output::Gap);
            if gap.abs() <= CONTACT_GAP {
                return Ok((formulae, jet));
            }
            let by_angle = found.derivative(Output::Gap, Input::ArmAngle)
                - jet.slope * -found.derivative(Output::Along, Input::ArmAngle);
            let next = formulae.get(Input::ArmAngle) - gap / by_angle;
            if !next.is_finite() || next.abs() > std::f64::consts::FRAC_PI_2 {
                break;
            }
            formulae.set(Input::ArmAngle, next);
        }
        Err(ActuatorError::OffRamp { travel })
    }
}

impl CamArm {
    /// `flyweights` of this arm at a speed in rad/s and a travel in m, where the pitch curve has the angle ξ in rad and
    /// the slope dξ/dd in rad/m.
    pub fn state(
        &self,
        flyweights: &Flyweights,
        (speed, travel): (f64, f64),
        shift: Shift,
        (angle, slope): (f64, f64),
    ) -> CamState {
        use FlyweightArmInput as Input;
        use FlyweightArmOutput as Output;
        let mut formulae = self.formulae(flyweights, speed, travel, shift);
        formulae.set(Input::PitchAngle, angle);
        formulae.set(Input::PitchSlope, slope);
        let found = formulae.outputs();
        let (distance, distance_slope) = (found.get(Output::Distance), found.get(Output::DistanceSlope));
        CamState { force: found.get(Output::Force), distance, distance_slope }
    }

    fn formulae(
        &self,
        flyweights: &Flyweights,
        speed: f64,
        travel: f64,
        shift: Shift,
    ) -> Inputs<FlyweightArmInput, FlyweightArmOutput> {
        use FlyweightArmInput as Input;
        Inputs::new(&FLYWEIGHT_ARM).with(&[
            (Input::Count, f64::from(flyweights.count)),
            (Input::Mass, flyweights.mass),
            (Input::Speed, speed),
            (Input::Travel, travel),
            (Input::Start, self.start),
            (Input::PivotRadius, self.pivot_radius),
            (Input::RollerRadius, self.roller_radius),
            (Input::MassDistance, self.mass_distance),
            (Input::MassAngle, self.mass_angle),
            (Input::FrictionAngle, shift.sign() * self.friction_angle),
            (Input::PitchAngle, 0.0),
            (Input::PitchSlope, 0.0),
        ])
    }
}

impl Flyweights {
    /// The axial force at a speed in rad/s and a travel in m.
    ///
    /// # Errors
    /// [`ActuatorError::OffRamp`] where the roller has no place on its ramp, [`ActuatorError::NoForce`] where the
    /// mechanism locks or pulls.
    pub fn force(&self, speed: f64, travel: f64, shift: Shift) -> Result<FlyweightForce, ActuatorError> {
        let force = match &self.mechanism {
            Mechanism::Coefficient { coefficient, lost } => {
                self.by_coefficient(coefficient, *lost, speed, travel, shift)
            }
            Mechanism::Ramp { radius, friction_angle } => self.on_ramp(radius, *friction_angle, speed, travel, shift),
            Mechanism::RollerArm(arm) => self.with_roller(arm, speed, travel, shift)?,
            Mechanism::CamArm(arm) => self.with_cam(arm, speed, travel, shift),
        };
        let sound = force.value.is_finite() && force.value >= 0.0;
        if sound { Ok(force) } else { Err(ActuatorError::NoForce { travel, force: force.value }) }
    }

    fn by_coefficient(
        &self,
        coefficient: &Profile,
        lost: f64,
        speed: f64,
        travel: f64,
        shift: Shift,
    ) -> FlyweightForce {
        use FlyweightTableInput as Input;
        let jet = coefficient.at(travel);
        let formulae = Inputs::new(&FLYWEIGHT_TABLE).with(&[
            (Input::Count, f64::from(self.count)),
            (Input::Mass, self.mass),
            (Input::Speed, speed),
            (Input::Coefficient, jet.value),
            (Input::Lost, shift.sign() * lost),
        ]);
        let found = formulae.linearised();
        let by = |input| found.derivative(FlyweightTableOutput::Force, input);
        FlyweightForce {
            value: found.get(FlyweightTableOutput::Force),
            by_speed: by(Input::Speed),
            by_travel: by(Input::Coefficient) * jet.slope,
            by_mass: by(Input::Mass),
            by_friction: shift.sign() * by(Input::Lost),
        }
    }

    fn on_ramp(&self, radius: &Profile, friction: f64, speed: f64, travel: f64, shift: Shift) -> FlyweightForce {
        use FlyweightRampInput as Input;
        let jet = radius.at(travel);
        let formulae = Inputs::new(&FLYWEIGHT_RAMP).with(&[
            (Input::Count, f64::from(self.count)),
            (Input::Mass, self.mass),
            (Input::Speed, speed),
            (Input::Radius, jet.value),
            (Input::RadiusSlope, jet.slope),
            (Input::FrictionAngle, shift.sign() * friction),
        ]);
        let found = formulae.linearised();
        let by = |input| found.derivative(FlyweightRampOutput::Force, input);
        FlyweightForce {
            value: found.get(FlyweightRampOutput::Force),
            by_speed: by(Input::Speed),
            by_travel: by(Input::Radius) * jet.slope + by(Input::RadiusSlope) * jet.curvature,
            by_mass: by(Input::Mass),
            by_friction: shift.sign() * by(Input::FrictionAngle),
        }
    }

    fn with_cam(&self, arm: &CamArm, speed: f64, travel: f64, shift: Shift) -> FlyweightForce {
        use FlyweightArmInput as Input;
        use FlyweightArmOutput as Output;
        let mut formulae = arm.formulae(self, speed, travel, shift);
        // The distance follows from the travel alone; the cam is read there.
        let jet = arm.pitch_curve.at(formulae.outputs().get(Output::Distance));
        formulae.set(Input::PitchAngle, jet.value);
        formulae.set(Input::PitchSlope, jet.slope);
        let found = formulae.linearised();
        let by = |input| found.derivative(Output::Force, input);
        let along = by(Input::PitchAngle) * jet.slope + by(Input::PitchSlope) * jet.curvature;
        FlyweightForce {
            value: found.get(Output::Force),
            by_speed: by(Input::Speed),
            by_travel: by(Input::Travel) + along * found.get(Output::DistanceSlope),
            by_mass: by(Input::Mass),
            by_friction: shift.sign() * by(Input::FrictionAngle),
        }
    }

    fn with_roller(
        &self,
        arm: &RollerArm,
        speed: f64,
        travel: f64,
        shift: Shift,
    ) -> Result<FlyweightForce, ActuatorError> {
        use FlyweightRollerInput as Input;
        use FlyweightRollerOutput as Output;
        let (formulae, jet) = arm.contact(arm.formulae(self, speed, shift), travel)?;
        let found = formulae.linearised();
        let turn = found.get(Output::AngleSlope);
        let by = |input| found.derivative(Output::Force, input);
        let on_ramp = 1.0 - found.derivative(Output::Along, Input::ArmAngle) * turn;
        let ramp = by(Input::RampRadius) * jet.slope + by(Input::RampSlope) * jet.curvature;
        Ok(FlyweightForce {
            value: found.get(Output::Force),
            by_speed: by(Input::Speed),
            by_travel: by(Input::ArmAngle) * turn + ramp * on_ramp,
            by_mass: by(Input::Mass),
            by_friction: shift.sign() * by(Input::FrictionAngle),
        })
    }
}
