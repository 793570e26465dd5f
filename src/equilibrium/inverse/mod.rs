//! Inverse design: the ramp and the helix that hold the engine at one speed over the whole shift.
//!
//! A tuner chooses parts and finds out where the engine runs. Asked the other way round, the engine runs at the
//! target's speed and gives its torque there, at every place of the shift. Then the belt is a problem with what clamps
//! it still to be said:
//!
//! | made | the belt is clamped by | what it takes on the other side is |
//! |---|---|---|
//! | ramp | helix and spring of the case | A_P + F_spring, which the flyweights have to give |
//! | helix | flyweights and spring of the case | A_S − F_spring, which the helix has to give |
//! | both | as much as leaves the slip reserve that is asked for | both |
//!
//! From the force over the travel follows the profile ([`Shape`]), by the same laws as in the forward problem. It is
//! written as text with six decimals, read again as any part is, and the drive is solved forward with it.

mod check;
mod drawing;
mod error;
mod points;
mod shape;
mod table;

pub use check::{Check, CheckPoint};
pub use drawing::{Outline, dxf, surface};
pub use error::InverseError;
pub use points::{ClampedBy, InversePoint};
pub use shape::Shape;
pub use table::{inverse_figures, inverse_summary, inverse_table};

use serde::Serialize;

use crate::case::{Case, Key};
use crate::drive::SolveOptions;
use crate::equilibrium::remarks::SUNK;
use crate::equilibrium::{Direction, SLIPPING};
use crate::quantity::{rpm, unsigned_zero};
use points::Held;
use shape::{flyweight_shape, helix_shape};

/// Share of the target's speed by which the engine may leave it before it is said.
const KEPT: f64 = 0.005;

/// Which profile is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Made {
    /// The flyweights' ramp, cam or coefficients; the helix is the case's.
    Ramp,
    /// The helix; the flyweights are the case's.
    Helix,
    /// Both, with the slip reserve that is asked for at every place.
    Both,
}

/// What is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InverseOptions {
    /// Speed to hold the engine at, rad/s.
    pub target: f64,
    /// What is made.
    pub made: Made,
    /// Least slip reserve over the shift; with [`Made::Both`] the one at every place.
    pub reserve: f64,
    /// Which way friction in the actuators acts.
    pub direction: Direction,
    /// Places of the shift at which the belt is solved, and points of the profile.
    pub points: usize,
    /// Places between them at which the drive is solved forward.
    pub checked: usize,
    /// How the belt is solved.
    pub solve: SolveOptions,
}

impl InverseOptions {
    /// For a target speed in rad/s.
    pub fn new(target: f64, made: Made) -> Self {
        let reserve = if made == Made::Both { 0.3 } else { 0.0 };
        let direction = Direction::Up;
        Self { target, made, reserve, direction, points: 41, checked: 9, solve: SolveOptions::default() }
    }

    /// Refuses options that no search can meet.
    ///
    /// # Errors
    /// [`InverseError::Parameter`] says which, and what is expected.
    pub fn check(&self) -> Result<(), InverseError> {
        let wrong = |what, given: String, expected: &str| {
            Err(InverseError::Parameter { what, given, expected: expected.to_owned() })
        };
        if !(self.target.is_finite() && self.target > 0.0) {
            return wrong("the target", format!("{} rad/s", self.target), "a speed above zero, such as \"3400 rpm\"");
        }
        if !(0.0..1.0).contains(&self.reserve) {
            return wrong("the reserve", self.reserve.to_string(), "a share from 0 to below 1");
        }
        if self.made == Made::Both && self.reserve <= 0.0 {
            return wrong(
                "the reserve",
                self.reserve.to_string(),
                "a share above 0, for both profiles are made from it",
            );
        }
        if !(5..=1000).contains(&self.points) {
            return wrong("the number of points", self.points.to_string(), "a number from 5 to 1000");
        }
        if !(1..=1000).contains(&self.checked) {
            return wrong("the number of checked places", self.checked.to_string(), "a number from 1 to 1000");
        }
        Ok(())
    }
}

/// A made part: the section of the case file that it is, with its keys.
#[derive(Debug, Clone, PartialEq)]
pub struct MadePart {
    /// Its profile.
    pub shape: Shape,
    /// Travel of the primary in m at each place of the profile; they fall along a cam to which the roller comes nearer.
    /// Before the first point of the belt there may be one where the primary is open.
    pub travels: Vec<f64>,
    /// Name of the section: `primary.actuator` or `secondary.actuator`.
    pub section: &'static str,
    /// All of the section, as the text of a part in a file of its own.
    pub text: String,
    /// Its curve, where it is one that can be drawn to scale.
    pub outlines: Vec<Outline>,
}

impl MadePart {
    /// Travel of the primary, place and value of the profile, in the order in which the sheaves come to them; SI.
    pub fn along(&self) -> Vec<(f64, f64, f64)> {
        let profile = self.shape.profile();
        let places = self.travels.iter().zip(profile.places()).zip(profile.values());
        let mut along: Vec<_> = places.map(|((travel, place), value)| (*travel, *place, *value)).collect();
        along.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
        along
    }
}

/// The profiles that hold the engine at a speed, and how well they do it.
#[derive(Debug, Clone)]
pub struct Inverse {
    /// What was asked for.
    pub options: InverseOptions,
    /// Torque of the engine at the target, N·m.
    pub torque: f64,
    /// The belt along the shift.
    pub points: Vec<InversePoint>,
    /// What was made: the primary's part first.
    pub parts: Vec<MadePart>,
    /// The case with the profiles in it.
    pub case: Case,
    /// The drive solved forward with them.
    pub check: Check,
}

impl Inverse {
    /// Smallest slip reserve over the shift.
    pub fn smallest_reserve(&self) -> f64 {
        self.points.iter().map(|point| point.slip_reserve).fold(f64::INFINITY, f64::min)
    }

    /// Sentences about belts along the shift that are none to make a profile from: those that slip, those that are
    /// wound round their pulleys as none is whose spans are nearly straight, and those that have sunk below the radius
    /// at which the primary is open; and about a profile with which the engine does not keep to the target.
    pub fn remarks(&self) -> Vec<String> {
        let between = |told: &str, holds: &dyn Fn(&InversePoint) -> bool| {
            let ratios = || self.points.iter().filter(|point| holds(point)).map(|point| point.ratio);
            let (lowest, highest) = (ratios().reduce(f64::max)?, ratios().reduce(f64::min)?);
            let count = ratios().count();
            Some(format!(
                "At {count} of the {} places of the shift {told}, at ratios from {lowest:.2} to {highest:.2}: what \
                 presses there is too little for the engine's torque, and the profile is made from such a belt.",
                self.points.len()
            ))
        };
        let buckled = between("the belt buckles", &|point| point.buckled);
        let pushed =
            between("the belt is pushed, and held by its speed alone", &|point| !point.buckled && point.pushed);
        let slips = between("the belt slips, or is about to", &|point| !point.buckled && point.slip_reserve < SLIPPING);
        buckled.into_iter().chain(pushed).chain(slips).chain(self.sunk()).chain(self.missed()).collect()
    }

    /// Where a primary would have to stand farther open than it can.
    fn sunk(&self) -> Option<String> {
        let sunk = || self.points.iter().filter(|point| point.primary_travel < -SUNK);
        let farthest = sunk().map(|point| point.primary_travel).reduce(f64::min)?;
        Some(format!(
            "At {} of the {} places of the shift the belt lies below the radius at which the primary is open, as if \
             that stood {:.2} mm farther open: the drive does not come there, and the profile is of use from where the \
             primary is open.",
            sunk().count(),
            self.points.len(),
            -1e3 * farthest
        ))
    }

    /// Where the drive that is solved forward leaves the target.
    fn missed(&self) -> Option<String> {
        let (missed, target) = (self.check.largest_deviation, self.options.target);
        (missed > KEPT * target).then(|| {
            format!(
                "With the profile as it is made the engine leaves the target by up to {:.0} rpm: make it with more \
                 points, or look at `sheave shift` at what the drive does there.",
                rpm(missed)
            )
        })
    }
}

/// Makes the profiles. A belt whose temperature is to be found is taken as it is given.
///
/// # Errors
/// See [`InverseError`]: what was asked is wrong, or such a profile cannot be made.
pub fn inverse(case: &Case, options: &InverseOptions) -> Result<Inverse, InverseError> {
    options.check()?;
    let mut resolved = case.resolve()?;
    resolved.thermal = None;
    let clamp = match options.made {
        Made::Ramp => ClampedBy::Secondary,
        Made::Helix => ClampedBy::Primary,
        Made::Both => ClampedBy::Reserve(options.reserve),
    };
    let held = Held::new(&resolved, options.target, options.direction, clamp, &options.solve)?;
    let points = held.points(options.points)?;
    enough(&points, options)?;
    let mut shapes = Vec::new();
    if options.made != Made::Helix {
        let (actuator, shift) = (&held.actuation.primary, options.direction.primary());
        shapes.push(flyweight_shape(actuator, &points, options.target, shift)?);
    }
    if options.made != Made::Ramp {
        shapes.push(helix_shape(&held.actuation.secondary, &points, options.direction.secondary())?);
    }
    let mut with = case.clone();
    for (shape, _) in &shapes {
        place(&mut with, shape, held.actuation.angle_from)?;
    }
    let parts = shapes.into_iter().map(|(shape, travels)| {
        let section = section(&shape);
        let outlines = drawing::outlines(&shape, held.actuation);
        MadePart { text: with.part_toml(section), shape, travels, section, outlines }
    });
    let parts = parts.collect();
    let check = check::check(&with, &points, options)?;
    Ok(Inverse { options: *options, torque: held.torque, points, parts, case: with, check })
}

/// Refuses a clamp that leaves less than is asked for.
fn enough(points: &[InversePoint], options: &InverseOptions) -> Result<(), InverseError> {
    let remedy = match options.made {
        Made::Ramp => {
            "a smaller helix angle or a stiffer spring of the secondary clamps tighter; or let both profiles be made"
        }
        Made::Helix => {
            "heavier flyweights or a softer spring of the primary clamp tighter; or let both profiles be made"
        }
        Made::Both => return Ok(()),
    };
    let least = points.iter().min_by(|a, b| a.slip_reserve.total_cmp(&b.slip_reserve));
    match least {
        Some(point) if point.slip_reserve < options.reserve => {
            let (ratio, reserve) = (point.ratio, point.slip_reserve);
            Err(InverseError::Reserve { ratio, reserve, wanted: options.reserve, remedy })
        }
        _ => Ok(()),
    }
}

const fn section(shape: &Shape) -> &'static str {
    match shape {
        Shape::Coefficient(_) | Shape::Ramp(_) | Shape::Roller(_) | Shape::Cam(_) => "primary.actuator",
        Shape::Helix(..) => "secondary.actuator",
    }
}

/// Six decimals: a nanometre, where the unit is a millimetre.
fn list(values: &[f64], unit: f64, symbol: &str) -> String {
    let texts: Vec<String> = values.iter().map(|value| unsigned_zero(&format!("{:.6}", value / unit)).into()).collect();
    format!("{} {symbol}", texts.join(", "))
}

/// Puts a profile into a case, by the text that its file has.
fn place(case: &mut Case, shape: &Shape, from: crate::actuator::AngleFrom) -> Result<(), InverseError> {
    const MM: f64 = 1e-3;
    const DEG: f64 = std::f64::consts::PI / 180.0;
    let mut set = |keys: [Key; 2], profile: &crate::actuator::Profile, values: String| {
        case.set(keys[0].path(), &list(profile.places(), MM, "mm"))?;
        case.set(keys[1].path(), &values)
    };
    match shape {
        Shape::Coefficient(profile) => {
            set([Key::FlyweightTravels, Key::FlyweightCoefficients], profile, list(profile.values(), MM, "mm"))?;
        }
        Shape::Ramp(profile) => {
            set([Key::FlyweightTravels, Key::FlyweightRadii], profile, list(profile.values(), MM, "mm"))?;
        }
        Shape::Roller(profile) => {
            set([Key::RampPlaces, Key::RampRadii], profile, list(profile.values(), MM, "mm"))?;
        }
        Shape::Cam(profile) => {
            set([Key::PitchDistances, Key::PitchAngles], profile, list(profile.values(), DEG, "deg"))?;
        }
        Shape::Helix(profile, _) => {
            let angles: Vec<f64> = profile.values().iter().map(|angle| from.from_rotation(*angle)).collect();
            set([Key::HelixOpenings, Key::HelixAngles], profile, list(&angles, DEG, "deg"))?;
            case.unset(Key::HelixAngle.path())?;
        }
    }
    Ok(())
}
