//! From the force that a part has to give at each travel to its shape.
//!
//! Each mechanism's law, the very one of the forward problem, is inverted for the slope of the profile at a place;
//! along the travel that is an ordinary differential equation for the flyweight's radius, the arm's angle or the turn
//! of the helix, which is integrated by an explicit Runge-Kutta method of order 8.

use std::cell::RefCell;
use std::f64::consts::FRAC_PI_2;

use differential_equations::prelude::{ExplicitRungeKutta, IVP};

use super::error::InverseError;
use super::points::InversePoint;
use crate::actuator::{
    CamArm, Flyweights, Helix, Mechanism, PrimaryActuator, Profile, RollerArm, SecondaryActuator, Shift, Spring,
};
use crate::integrator;

/// Relative and absolute tolerance of the integration.
const RELATIVE: f64 = 1e-10;
const ABSOLUTE: f64 = 1e-13;
/// Bisections of the angle of a slope.
const HALVINGS: usize = 60;
/// Steepest slope that is considered, rad from flat.
const STEEPEST: f64 = FRAC_PI_2 - 1e-3;

/// A profile as it is made; SI.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// r dr/ds of a flyweight in m over the travel in m.
    Coefficient(Profile),
    /// Radius of a flyweight's centre of mass in m over the travel in m.
    Ramp(Profile),
    /// Radius to which the ramp lets the roller's centre in m over the place on the ramp in m.
    Roller(Profile),
    /// Angle of the cam's pitch curve in rad over the distance from the pivot in m.
    Cam(Profile),
    /// Helix angle from the plane of rotation in rad over the opening in m; and the turn in rad at the same openings.
    Helix(Profile, Vec<f64>),
}

impl Shape {
    /// What is given over what.
    pub const fn profile(&self) -> &Profile {
        match self {
            Self::Coefficient(profile)
            | Self::Ramp(profile)
            | Self::Roller(profile)
            | Self::Cam(profile)
            | Self::Helix(profile, _) => profile,
        }
    }
}

/// The force of a spring that may be none, at every travel, N.
pub(super) fn spring_forces(spring: Option<&Spring>, travels: &[f64]) -> Result<Vec<f64>, InverseError> {
    let force = |travel: &f64| match spring {
        Some(spring) => Ok(spring.force(*travel).map_err(|error| InverseError::Actuator { error })?.value),
        None => Ok(0.0),
    };
    travels.iter().map(force).collect()
}

/// The profile of the flyweights that press with what the belt and the spring take, at a speed in rad/s; and the travel
/// at each of its places.
pub(super) fn flyweight_shape(
    actuator: &PrimaryActuator,
    points: &[InversePoint],
    speed: f64,
    shift: Shift,
) -> Result<(Shape, Vec<f64>), InverseError> {
    let PrimaryActuator::Flyweights { flyweights, spring } = actuator else {
        let needs = "a servo has no profile; give primary.actuator.type = \"table\", \"ramp\", \"arm\" or \"cam\"";
        return Err(InverseError::Missing { what: "flyweights", needs });
    };
    let mut travels: Vec<f64> = points.iter().map(|point| point.primary_travel).collect();
    let springs = spring_forces(spring.as_ref(), &travels)?;
    let mut forces = Vec::with_capacity(points.len());
    for (point, spring) in points.iter().zip(&springs) {
        let (travel, belt) = (point.primary_travel, point.primary_axial_force);
        let force = belt + spring;
        if force <= 0.0 {
            let (part, verb) = ("flyweights", "pull");
            return Err(InverseError::WrongSign { part, verb, travel, force, belt, spring: -spring });
        }
        forces.push(force);
    }
    // Below the low stop the belt is held by the secondary's stop: the profile goes on to where the primary is open,
    // with the force that it has at the stop.
    if let (Some(first), Some(second), Some(force)) = (travels.first(), travels.get(1), forces.first())
        && *first > 0.25 * (second - first)
    {
        forces.insert(0, *force);
        travels.insert(0, 0.0);
    }
    let wanted = Wanted { flyweights, forces: profile(travels.clone(), forces)?, speed, shift };
    let shape = match &flyweights.mechanism {
        Mechanism::Coefficient { lost, .. } => wanted.coefficient(*lost)?,
        Mechanism::Ramp { radius, friction_angle } => wanted.ramp(radius, *friction_angle)?,
        Mechanism::RollerArm(arm) => wanted.roller(arm)?,
        Mechanism::CamArm(arm) => {
            let (shape, falls) = wanted.cam(arm)?;
            if falls {
                travels.reverse();
            }
            shape
        }
    };
    Ok((shape, travels))
}

fn profile(places: Vec<f64>, values: Vec<f64>) -> Result<Profile, InverseError> {
    Profile::new(places, values).map_err(|error| InverseError::Actuator { error: error.into() })
}

/// What flyweights have to press with.
struct Wanted<'a> {
    flyweights: &'a Flyweights,
    /// Over the travel; the shape is found at its places.
    forces: Profile,
    speed: f64,
    shift: Shift,
}

impl Wanted<'_> {
    fn with(&self, mechanism: Mechanism) -> Flyweights {
        Flyweights { mechanism, ..self.flyweights.clone() }
    }

    /// The force is proportional to the coefficient, whatever share of it friction takes.
    fn coefficient(&self, lost: f64) -> Result<Shape, InverseError> {
        const UNIT: f64 = 1e-2;
        let unit = self.with(Mechanism::Coefficient { coefficient: Profile::line(0.0, UNIT, 0.0), lost });
        let of_unit = unit.force(self.speed, 0.0, self.shift).map_err(|error| InverseError::Actuator { error })?;
        let travels = self.forces.places();
        let values = travels.iter().map(|travel| UNIT * self.forces.at(*travel).value / of_unit.value).collect();
        Ok(Shape::Coefficient(profile(travels.to_vec(), values)?))
    }

    /// dr/ds from r.
    fn ramp(&self, start: &Profile, friction_angle: f64) -> Result<Shape, InverseError> {
        const NAME: &str = "ramp";
        let level = self.shift.sign() * friction_angle;
        let slope = |travel: f64, radius: f64| {
            let force = |angle: f64| {
                let radius = Profile::line(travel, radius, libm::tan(angle));
                let made = self.with(Mechanism::Ramp { radius, friction_angle });
                made.force(self.speed, travel, self.shift).map_or(f64::NAN, |force| force.value)
            };
            let reason = "give heavier or more flyweights, or a larger radius to begin with";
            steepness(self.forces.at(travel).value, level, force).map(libm::tan).ok_or((travel, reason))
        };
        let (first, _) = self.forces.domain();
        let radii = integrated(NAME, &self.forces, start.at(first).value, slope)?;
        Ok(Shape::Ramp(profile(self.forces.places().to_vec(), radii)?))
    }

    /// dθ/ds from θ; the ramp is where the roller is.
    fn roller(&self, arm: &RollerArm) -> Result<Shape, InverseError> {
        const NAME: &str = "ramp";
        let level = self.shift.sign() * arm.friction_angle;
        let state = |angle: f64, slope: f64| arm.state(self.flyweights, self.speed, self.shift, angle, slope);
        let turn = |travel: f64, angle: f64| {
            let force = |steep: f64| state(angle, libm::tan(steep)).force;
            let reason = "the arm stands too steep, or the flyweights are too light: give heavier or more flyweights, \
                or a stiffer spring where they are too heavy";
            let found = steepness(self.forces.at(travel).value, level, force).ok_or((travel, reason))?;
            Ok(state(angle, libm::tan(found)).turn)
        };
        let travels = self.forces.places();
        let (first, _) = self.forces.domain();
        let start = arm.angle(first).map_err(|error| InverseError::Actuator { error })?;
        let angles = integrated(NAME, &self.forces, start, turn)?;
        let place = |(travel, angle): (&f64, &f64)| arm.ramp_start + travel - state(*angle, 0.0).along;
        let places: Vec<f64> = travels.iter().zip(&angles).map(place).collect();
        let reason = "the roller would go back on its ramp: give heavier flyweights, or a longer arm";
        increasing(NAME, travels, &places, reason)?;
        Ok(Shape::Roller(profile(places, angles.iter().map(|angle| arm.radius(*angle)).collect())?))
    }

    /// dξ/ds from ξ; the distance follows from the travel. And whether the distance falls as the travel grows.
    fn cam(&self, arm: &CamArm) -> Result<(Shape, bool), InverseError> {
        const NAME: &str = "cam";
        let state = |travel: f64, at: (f64, f64)| arm.state(self.flyweights, (self.speed, travel), self.shift, at);
        let slope = |travel: f64, angle: f64| {
            let distance = state(travel, (angle, 0.0)).distance;
            let of = |steep: f64| (angle, libm::tan(steep) / distance);
            let friction = self.shift.sign() * arm.friction_angle;
            let most = STEEPEST - friction.abs();
            let force = |steep: f64| state(travel, of(steep)).force;
            let reason = "give heavier or more flyweights";
            let found = crossing(self.forces.at(travel).value, (-most, most), force).ok_or((travel, reason))?;
            Ok(of(found).1 * state(travel, of(found)).distance_slope)
        };
        let travels = self.forces.places();
        let (first, _) = self.forces.domain();
        let distance = |travel: &f64| state(*travel, (0.0, 0.0)).distance;
        let start = arm.pitch_curve.at(distance(&first)).value;
        let mut angles = integrated(NAME, &self.forces, start, slope)?;
        let mut distances: Vec<f64> = travels.iter().map(distance).collect();
        let falls = distances.first() > distances.last();
        if falls {
            distances.reverse();
            angles.reverse();
        }
        let reason = "the roller comes nearer to the pivot and goes away again, so that one place of the cam would \
            have to press twice: move the roller, or the pivot, along the shaft";
        increasing(NAME, travels, &distances, reason)?;
        Ok((Shape::Cam(profile(distances, angles)?), falls))
    }
}

/// The helix that presses with what the belt takes beyond the spring; and the primary's travel at each of its places.
pub(super) fn helix_shape(
    actuator: &SecondaryActuator,
    points: &[InversePoint],
    shift: Shift,
) -> Result<(Shape, Vec<f64>), InverseError> {
    const NAME: &str = "helix";
    let SecondaryActuator::Helix { helix, spring } = actuator else {
        let needs = "a servo has no profile; give secondary.actuator.type = \"helix\"";
        return Err(InverseError::Missing { what: "helix", needs });
    };
    let openings: Vec<f64> = points.iter().map(|point| point.secondary_travel).collect();
    increasing(NAME, &openings, &openings, "the secondary does not open as the primary closes")?;
    let springs = spring_forces(spring.as_ref(), &openings)?;
    let mut forces = Vec::with_capacity(points.len());
    for (point, spring) in points.iter().zip(&springs) {
        let (travel, belt) = (point.secondary_travel, point.secondary_axial_force);
        let force = belt - spring;
        if force <= 0.0 {
            let (part, verb) = ("helix", "pull");
            return Err(InverseError::WrongSign { part, verb, travel, force, belt, spring: *spring });
        }
        forces.push(force);
    }
    let forces = profile(openings.clone(), forces)?;
    let torques = profile(openings.clone(), points.iter().map(|point| point.secondary_torque).collect())?;
    let angle = |opening: f64, turn: f64| angle_of(helix, &forces, &torques, shift, (opening, turn));
    let slope = |opening: f64, turn: f64| angle(opening, turn).map(|angle| 1.0 / (helix.radius * libm::tan(angle)));
    let start = 0.0;
    let turns = integrated(NAME, &forces, start, slope)?;
    let angles = openings.iter().zip(&turns).map(|(opening, turn)| {
        let force = forces.at(*opening).value;
        let told = |(travel, reason)| InverseError::Slope { profile: NAME, travel, force, reason };
        angle(*opening, *turn).map_err(told)
    });
    let angles = angles.collect::<Result<_, _>>()?;
    let travels = points.iter().map(|point| point.primary_travel).collect();
    Ok((Shape::Helix(profile(openings, angles)?, turns), travels))
}

/// The helix angle at an opening where the sheave has turned so far.
fn angle_of(
    helix: &Helix,
    forces: &Profile,
    torques: &Profile,
    shift: Shift,
    (opening, turn): (f64, f64),
) -> Result<f64, (f64, &'static str)> {
    let torque = torques.at(opening).value;
    let (_, carried) = helix.state(torque, turn, 1.0, shift);
    if carried <= 0.0 {
        return Err((opening, "the flank carries no torque and has no contact: wind the torsion spring up further"));
    }
    let friction = shift.sign() * helix.friction_angle;
    let force = |angle: f64| helix.state(torque, turn, libm::tan(angle), shift).0;
    let range = ((-friction).max(0.0) + 1e-6, STEEPEST - friction.max(0.0));
    let reason =
        "the torque on the helix is too small or too large for it: give another spring, or another helix radius";
    crossing(forces.at(opening).value, range, force).ok_or((opening, reason))
}

/// The angle of a slope, from `level` up, at which a force that grows with it is `wanted`; where the slope is so steep
/// that the mechanism locks, the force is none, or no number.
fn steepness(wanted: f64, level: f64, force: impl Fn(f64) -> f64) -> Option<f64> {
    let steep = |angle: f64| {
        let found = force(angle);
        !(0.0..wanted).contains(&found)
    };
    let (mut low, mut high) = (level.max(-STEEPEST), STEEPEST);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        // Just above the level the force is a little positive.
        if steep(middle) { high = middle } else { low = middle }
    }
    let found = force(low);
    ((found / wanted - 1.0).abs() < 1e-6).then_some(low)
}

/// The angle within a range at which a monotone force is `wanted`.
fn crossing(wanted: f64, (low, high): (f64, f64), force: impl Fn(f64) -> f64) -> Option<f64> {
    let (at_low, at_high) = (force(low) - wanted, force(high) - wanted);
    // Nor where one of them is no number.
    if (at_low * at_high).partial_cmp(&0.0).is_none_or(std::cmp::Ordering::is_gt) {
        return None;
    }
    let (mut low, mut high) = (low, high);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if (force(middle) - wanted) * at_low > 0.0 { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

fn increasing(
    profile: &'static str,
    travels: &[f64],
    places: &[f64],
    reason: &'static str,
) -> Result<(), InverseError> {
    let back = places.windows(2).position(|pair| !matches!(pair, [a, b] if b > a));
    match back.and_then(|at| travels.get(at + 1)) {
        Some(travel) => Err(InverseError::Folds { profile, travel: *travel, reason }),
        None => Ok(()),
    }
}

/// What grows by `slope` from `start`, at every travel of the forces that are wanted.
fn integrated(
    name: &'static str,
    forces: &Profile,
    start: f64,
    slope: impl Fn(f64, f64) -> Result<f64, (f64, &'static str)>,
) -> Result<Vec<f64>, InverseError> {
    let (travels, (first, last)) = (forces.places(), forces.domain());
    let broken: RefCell<Option<(f64, &'static str)>> = RefCell::new(None);
    let derivative = |travel: f64, value: &f64, derivative: &mut f64| match slope(travel, *value) {
        Ok(found) => *derivative = found,
        Err(reason) => {
            *derivative = f64::NAN;
            broken.borrow_mut().get_or_insert(reason);
        }
    };
    let method = ExplicitRungeKutta::dop853().rtol(RELATIVE).atol(ABSOLUTE);
    let solved = IVP::ode_from_fn(&derivative, first, last, start).t_eval(travels).method(method).solve();
    let reason = match solved {
        Ok(solution) if solution.y.len() == travels.len() && solution.y.iter().all(|value| value.is_finite()) => {
            return Ok(solution.y);
        }
        Ok(solution) => format!("it ended after {} of {} places", solution.y.len(), travels.len()),
        Err(error) => integrator::reason(&error, |travel| format!("at a travel of {:.2} mm", travel * 1e3)),
    };
    match broken.into_inner() {
        Some((travel, reason)) => {
            let force = forces.at(travel).value;
            Err(InverseError::Slope { profile: name, travel, force, reason })
        }
        None => Err(InverseError::Integration { profile: name, reason }),
    }
}
