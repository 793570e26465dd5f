//! The helix of a secondary: what turns the belt's torque, and its torsion spring's, into axial force.

use std::f64::consts::FRAC_PI_2;

use generated::{HELIX, HelixInput, HelixOutput};

use super::error::{ActuatorError, check};
use super::profile::Profile;
use super::shift::Shift;
use crate::formula::Inputs;

/// From where makers measure a helix angle. A steep helix turns little of the torque into force; of the two
/// conventions, the first calls it large and the second small.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AngleFrom {
    /// From the plane of rotation, as here everywhere: a helix of 90° would press with nothing.
    #[default]
    Rotation,
    /// From the shaft's axis: a helix of 0° would press with nothing.
    Axis,
}

impl AngleFrom {
    /// The angle from the plane of rotation, rad.
    pub fn from_rotation(self, angle: f64) -> f64 {
        match self {
            Self::Rotation => angle,
            Self::Axis => std::f64::consts::FRAC_PI_2 - angle,
        }
    }
}

/// A helix and the spring that winds it up.
#[derive(Debug, Clone, PartialEq)]
pub struct Helix {
    /// Radius at which the helix bears, m.
    pub radius: f64,
    /// Turn of the movable sheave in rad over its opening in m: a straight line for a constant angle.
    turn: Profile,
    /// Rate of the spring in torsion, N·m/rad.
    pub torsion_rate: f64,
    /// Angle by which the spring is wound up when installed, rad.
    pub pretension: f64,
    /// Friction angle of the flanks, rad.
    pub friction_angle: f64,
    /// Share of the belt's torque that the movable sheave carries: one half where both faces of the groove rub alike.
    pub torque_share: f64,
}

/// A helix's axial force with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HelixForce {
    /// The force, N, positive where it closes the sheave.
    pub value: f64,
    /// The torque that the helix carries, N·m.
    pub torque: f64,
    /// Derivative of the force with respect to the belt's torque on the secondary, 1/m.
    pub by_torque: f64,
    /// Derivative with respect to the opening, N/m.
    pub by_opening: f64,
    /// Derivative with respect to the pretension, N/rad.
    pub by_pretension: f64,
    /// Derivative with respect to the torsion rate, rad/m.
    pub by_torsion_rate: f64,
    /// Derivative with respect to the tangent of the helix angle where the sheave stands, N.
    pub by_tangent: f64,
    /// Derivative with respect to the helix angle from the plane of rotation, all over the helix alike, N/rad: the turn
    /// changes with it.
    pub by_angle: f64,
    /// Derivative with respect to the share of the belt's torque that the movable sheave carries, N.
    pub by_share: f64,
    /// Derivative with respect to the friction angle, N/rad.
    pub by_friction: f64,
}

impl Helix {
    /// A helix of one angle in rad from the plane of rotation, at a radius in m.
    ///
    /// # Errors
    /// [`ActuatorError::Parameter`] for an angle outside (0°, 90°) or a radius that is not positive.
    pub fn constant(radius: f64, angle: f64) -> Result<Self, ActuatorError> {
        check("the helix radius", radius, radius > 0.0, "a positive length in m")?;
        let inclined = angle > 0.0 && angle < FRAC_PI_2;
        check("the helix angle", angle, inclined, "an angle between 0 and π/2 rad from the plane of rotation")?;
        Ok(Self::with_turn(radius, Profile::line(0.0, 0.0, 1.0 / (radius * libm::tan(angle)))))
    }

    /// A helix whose angle in rad from the plane of rotation varies over the opening in m: the turn is its integral.
    ///
    /// # Errors
    /// As [`Helix::constant`].
    pub fn varying(radius: f64, angle: &Profile) -> Result<Self, ActuatorError> {
        check("the helix radius", radius, radius > 0.0, "a positive length in m")?;
        for &angle in angle.values() {
            let inclined = angle > 0.0 && angle < FRAC_PI_2;
            check("the helix angle", angle, inclined, "an angle between 0 and π/2 rad from the plane of rotation")?;
        }
        let slopes: Vec<f64> = angle.values().iter().map(|angle| 1.0 / (radius * libm::tan(*angle))).collect();
        let slope = Profile::new(angle.places().to_vec(), slopes)?;
        // The turn's slope is what counts; its table is dense enough that the cubic between its points follows it.
        const POINTS: usize = 201;
        let (first, last) = angle.domain();
        let places: Vec<f64> = (0..POINTS).map(|i| first + (last - first) * i as f64 / (POINTS - 1) as f64).collect();
        let turns = places.iter().map(|place| slope.integral(*place) - slope.integral(0.0)).collect();
        Ok(Self::with_turn(radius, Profile::new(places, turns)?))
    }

    fn with_turn(radius: f64, turn: Profile) -> Self {
        Self { radius, turn, torsion_rate: 0.0, pretension: 0.0, friction_angle: 0.0, torque_share: 0.5 }
    }

    /// Openings in m between which the helix is known; for one of a constant angle, more than any sheave's.
    pub fn openings(&self) -> (f64, f64) {
        self.turn.domain()
    }

    /// Turn of the movable sheave in rad where it has opened by `opening` in m.
    pub fn turn(&self, opening: f64) -> f64 {
        self.turn.at(opening).value
    }

    /// Derivative of the turn at an opening with respect to the helix angle, all over the helix alike: the integral of
    /// d/dα 1/(r_h tan α) = −(1 + tan² α)/(r_h tan² α) = −(1/r_h + r_h φ'²) over the opening.
    fn turn_by_angle(&self, opening: f64) -> f64 {
        const PIECES: u32 = 64;
        let rate = |at: f64| -(1.0 / self.radius + self.radius * self.turn.at(at).slope.powi(2));
        let step = opening / f64::from(PIECES);
        // Simpson's rule.
        let piece = |i: u32| {
            let at = step * f64::from(i);
            step / 6.0 * (rate(at) + 4.0 * rate(at + 0.5 * step) + rate(at + step))
        };
        (0..PIECES).map(piece).sum()
    }

    /// The axial force in N at the belt's torque on the secondary in N·m, where the sheave has turned by `turn` in rad
    /// and the helix has an angle of this tangent, whatever the helix is elsewhere; and the torque in N·m that it
    /// carries. A helix is designed from it.
    pub fn state(&self, torque: f64, turn: f64, tangent: f64, shift: Shift) -> (f64, f64) {
        let found = self.formulae(torque, turn, tangent, shift).outputs();
        (found.get(HelixOutput::Force), found.get(HelixOutput::Torque))
    }

    fn formulae(&self, torque: f64, turn: f64, tangent: f64, shift: Shift) -> Inputs<HelixInput, HelixOutput> {
        use HelixInput as Input;
        Inputs::new(&HELIX).with(&[
            (Input::TorsionRate, self.torsion_rate),
            (Input::Pretension, self.pretension),
            (Input::Turn, turn),
            (Input::Radius, self.radius),
            (Input::Tangent, tangent),
            (Input::Share, self.torque_share),
            (Input::Torque, torque),
            (Input::FrictionAngle, shift.sign() * self.friction_angle),
        ])
    }

    /// The axial force at the belt's torque on the secondary in N·m, where the sheave has opened by `opening` in m.
    ///
    /// # Errors
    /// [`ActuatorError::HelixContact`] where the flank would have to pull, [`ActuatorError::HelixLocks`] where friction
    /// lets no torque move the sheave.
    pub fn force(&self, torque: f64, opening: f64, shift: Shift) -> Result<HelixForce, ActuatorError> {
        use HelixInput as Input;
        use HelixOutput as Output;
        let jet = self.turn.at(opening);
        let tangent = 1.0 / (self.radius * jet.slope);
        let angle = libm::atan(tangent);
        let against = angle + shift.sign() * self.friction_angle;
        if !(against > 0.0 && against < FRAC_PI_2) {
            let friction_angle = self.friction_angle;
            return Err(ActuatorError::HelixLocks { travel: opening, angle, friction_angle, shift });
        }
        let found = self.formulae(torque, jet.value, tangent, shift).linearised();
        let carried = found.get(Output::Torque);
        if carried < 0.0 || !found.get(Output::Force).is_finite() {
            return Err(ActuatorError::HelixContact { travel: opening, torque: carried });
        }
        let by = |input| found.derivative(Output::Force, input);
        // tan α = 1/(r_h φ'): its slope over the opening is −φ''/(r_h φ'²).
        let tangent_slope = -jet.curvature / (self.radius * jet.slope * jet.slope);
        Ok(HelixForce {
            value: found.get(Output::Force),
            torque: carried,
            by_torque: by(Input::Torque),
            by_opening: by(Input::Turn) * jet.slope + by(Input::Tangent) * tangent_slope,
            by_pretension: by(Input::Pretension),
            by_torsion_rate: by(Input::TorsionRate),
            by_tangent: by(Input::Tangent),
            by_angle: by(Input::Tangent) * (1.0 + tangent * tangent) + by(Input::Turn) * self.turn_by_angle(opening),
            by_share: by(Input::Share),
            by_friction: shift.sign() * by(Input::FrictionAngle),
        })
    }
}
