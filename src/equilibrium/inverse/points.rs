//! The belt along the shift, the engine held at one speed: what each pulley's actuator has to press with.

use serde::Serialize;

use super::error::InverseError;
use crate::actuator::{PrimaryActuator, SecondaryActuator, travel_by_radius};
use crate::case::geometry::{radius_beside, wrap_angles};
use crate::case::{Actuation, Clamp, Load, Resolved, Speed};
use crate::drive::{
    Compressed, Failure, Question, SolveOptions, Solved, approach_question, solve_question, solve_question_from,
};
use crate::equilibrium::Direction;
use crate::equilibrium::point::ordinary;
use crate::equilibrium::question::{Given, Whole};
use crate::model::{Constant, Output};
use crate::quantity::rpm;
use crate::result::{is_buckled, slip_reserve};

/// Slack tensions of the first solution over M_in/R_P.
const FIRST: [f64; 5] = [0.35, 0.7, 0.2, 1.2, 0.1];
/// How often a step from one place to the next is halved.
const HALVED: usize = 3;
/// Steps of the search for the slack tension of a reserve, how well it is met, and the largest step of its logarithm.
const RESERVES: usize = 30;
const MET: f64 = 1e-7;
const STRIDE: f64 = 0.7;
/// Change of the slack tension with which that search begins.
const NUDGE: f64 = 1.05;

/// What clamps the belt while a profile is made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ClampedBy {
    /// The secondary's actuator, as the case has it: the primary's is made.
    Secondary,
    /// The primary's actuator, as the case has it: the secondary's is made.
    Primary,
    /// As much as leaves this share of the friction at hand: both are made.
    Reserve(f64),
}

/// The belt at a place of the shift, the engine at the target's speed and full torque; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InversePoint {
    /// Travel of the primary from where it is open.
    pub primary_travel: f64,
    /// Opening of the secondary from where it is closed.
    pub secondary_travel: f64,
    /// R_S/R_P.
    pub ratio: f64,
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// Torque out of the secondary.
    pub secondary_torque: f64,
    /// Axial force of the belt on the primary.
    pub primary_axial_force: f64,
    /// Axial force of the belt on the secondary.
    pub secondary_axial_force: f64,
    /// Tractive tension of the slack span.
    pub slack_tension: f64,
    /// Share of the friction at hand that is left over.
    pub slip_reserve: f64,
    /// Power out over power in, friction of the belt alone counted.
    pub efficiency: Option<f64>,
    /// Whether the belt has buckled: it is wound round its pulleys as none is whose spans are nearly straight.
    pub buckled: bool,
    /// Whether the belt is pushed somewhere, but for what its own inertia adds: only its speed holds it there.
    pub pushed: bool,
}

/// Which radius is given; the other one is where the belt closes.
#[derive(Debug, Clone, Copy)]
enum Place {
    Primary(f64),
    Secondary(f64),
}

/// The belt of a drive whose engine is held at one speed.
pub(super) struct Held<'a> {
    pub case: &'a Resolved,
    pub actuation: &'a Actuation,
    pub whole: Whole<'a>,
    /// Speed of the primary, rad/s.
    pub target: f64,
    /// Torque of the engine there, N·m.
    pub torque: f64,
    pub direction: Direction,
    pub clamp: ClampedBy,
    pub options: &'a SolveOptions,
}

impl<'a> Held<'a> {
    pub fn new(
        case: &'a Resolved,
        target: f64,
        direction: Direction,
        clamp: ClampedBy,
        options: &'a SolveOptions,
    ) -> Result<Self, InverseError> {
        // Says what the case lacks.
        let whole = Whole::new(case, Given::SecondarySpeed(1.0), direction)?;
        let (actuation, engine) = (case.parts.actuation.as_ref(), case.parts.engine.as_ref());
        let (Some(actuation), Some(engine)) = (actuation, engine) else {
            let needs = "give [primary.actuator], [secondary.actuator] and [engine]";
            return Err(InverseError::Missing { what: "actuators or engine", needs });
        };
        let (from, to) = engine.range();
        let torque = engine.torque(target).value;
        if !(from..=to).contains(&target) || torque <= 0.0 {
            let told = |speed: f64| format!("{:.0} rpm", rpm(speed));
            let expected = format!("a speed from {} to {} at which the engine gives torque", told(from), told(to));
            return Err(InverseError::Parameter { what: "the target", given: told(target), expected });
        }
        Ok(Self { case, actuation, whole, target, torque, direction, clamp, options })
    }

    /// `count` places at the most, evenly spaced in the travel of the primary but for the stops, from the low stop to
    /// the high one.
    pub fn points(&self, count: usize) -> Result<Vec<InversePoint>, InverseError> {
        let slope = travel_by_radius(self.case.sheave.half_angle);
        let (closed, start) = (self.actuation.closed_radius, self.actuation.start_radius);
        let high = match (self.actuation.primary_travel, self.actuation.secondary_travel) {
            (Some(travel), _) => Place::Primary(start + travel / slope),
            (None, Some(travel)) => Place::Secondary(closed - travel / slope),
            (None, None) => {
                let needs = "give primary.travel, or secondary.travel, so that the end of the shift is known";
                return Err(InverseError::Missing { what: "stop at high ratio", needs });
            }
        };
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        let end = match high {
            Place::Primary(radius) => radius,
            Place::Secondary(radius) => radius_beside(radius, length, center).unwrap_or(start),
        };
        // From the middle outwards, so that each place is solved from one nearby; the stops, whose radii are found,
        // last.
        let radius = |at: usize| start + (end - start) * at as f64 / (count - 1) as f64;
        let middle = count / 2;
        let first = self.first(radius(middle))?;
        let mut below = vec![first.clone()];
        for at in (1..middle).rev() {
            below.push(self.next(below.last().unwrap_or(&first), Place::Primary(radius(at)))?);
        }
        let low = self.next(below.last().unwrap_or(&first), Place::Secondary(closed))?;
        let mut found = vec![low];
        found.extend(below.into_iter().rev());
        for at in middle + 1..count - 1 {
            found.push(self.next(found.last().unwrap_or(&first), Place::Primary(radius(at)))?);
        }
        found.push(self.next(found.last().unwrap_or(&first), high)?);
        // A place beside a stop, closer than a quarter of a step, would say little and be noisy.
        let least = 0.25 * (end - start) / (count - 1) as f64;
        let at = |solved: &Solved| solved.constant(Constant::PrimaryRadius);
        let (low, high) = (found.first().map_or(start, at), found.last().map_or(end, at));
        let last = found.len() - 1;
        let kept = found
            .iter()
            .enumerate()
            .filter(|(i, solved)| *i == 0 || *i == last || (at(solved) - low >= least && high - at(solved) >= least));
        kept.map(|(_, solved)| self.read(solved)).collect()
    }

    fn question(&self, place: Place, tension: f64) -> Question {
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        let beside = |radius: f64, otherwise: f64| radius_beside(radius, length, center).unwrap_or(otherwise);
        let mut posed = ordinary(self.case);
        let (start, closed) = (self.actuation.start_radius, self.actuation.closed_radius);
        (posed.drive.primary_radius, posed.drive.secondary_radius) = match place {
            Place::Primary(radius) => (radius, beside(radius, closed)),
            Place::Secondary(radius) => (beside(radius, start), radius),
        };
        posed.operating_point.speed = Speed::Primary(self.target);
        posed.operating_point.load = Load::PrimaryTorque(self.torque);
        posed.operating_point.clamp = Clamp::SlackTension(tension);
        let free = match place {
            Place::Primary(_) => Constant::SecondaryRadius,
            Place::Secondary(_) => Constant::PrimaryRadius,
        };
        let question = Question::of(&posed).swap(free, Output::BeltUnstretchedLength, length);
        match self.clamp {
            ClampedBy::Secondary => question.close(self.whole.by_secondary(Constant::SlackTension)),
            ClampedBy::Primary => question.close(self.whole.by_primary(Constant::SlackTension)),
            ClampedBy::Reserve(_) => question,
        }
    }

    /// From nothing.
    fn first(&self, radius: f64) -> Result<Solved, InverseError> {
        let place = Place::Primary(radius);
        let pull = self.torque / radius;
        let mut why = None;
        for tension in self.likely(radius).into_iter().chain(FIRST.map(|share| share * pull)) {
            let solved = solve_question(&self.case.model, &self.question(place, tension), self.options);
            let solved = solved.map_err(|failure| self.failed(self.ratio(radius), failure));
            match solved.and_then(|solved| self.in_place(solved)) {
                Ok(solved) => return self.settled(solved, place),
                Err(error) if error.is_bad_input() || crate::cancel::is_cancelled() => return Err(error),
                Err(error) => _ = why.get_or_insert(error),
            }
        }
        let none = InverseError::Missing { what: "first solution", needs: "none was tried" };
        Err(why.unwrap_or(none))
    }

    /// The slack tension of a belt of rough proportions that the given actuator clamps, N.
    fn likely(&self, radius: f64) -> Option<f64> {
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        let half_angle = self.case.sheave.half_angle;
        let other = radius_beside(radius, length, center).ok()?;
        let (on_primary, on_secondary) = wrap_angles(radius, other, center);
        let travel = |from: f64, to: f64| crate::actuator::travel(half_angle, from, to);
        let (force, share, wrap) = match self.clamp {
            ClampedBy::Secondary => {
                let opening = travel(other, self.actuation.closed_radius);
                let torque = 0.95 * self.torque * other / radius;
                let shift = self.direction.secondary();
                (self.actuation.secondary.force(torque, opening, shift).ok()?.value, 0.42, on_secondary)
            }
            ClampedBy::Primary => {
                let closed = travel(self.actuation.start_radius, radius);
                let shift = self.direction.primary();
                (self.actuation.primary.force(self.target, closed, shift).ok()??.value, 0.62, on_primary)
            }
            ClampedBy::Reserve(_) => return None,
        };
        let tension = force * 2.0 * libm::tan(half_angle) / (share * wrap) - 0.5 * self.torque / radius;
        (tension > 0.1 * self.torque / radius).then_some(tension)
    }

    fn ratio(&self, primary: f64) -> f64 {
        let beside = radius_beside(primary, self.case.belt.length, self.case.drive.center_distance);
        beside.map_or(f64::NAN, |secondary| secondary / primary)
    }

    fn failed(&self, ratio: f64, failure: Failure) -> InverseError {
        InverseError::Belt { ratio, clamp: self.clamps(), failure: Box::new(failure) }
    }

    const fn clamps(&self) -> &'static str {
        let (primary, secondary) = (&self.actuation.primary, &self.actuation.secondary);
        match self.clamp {
            ClampedBy::Secondary => match secondary {
                SecondaryActuator::Helix { .. } => "helix and spring clamp",
                SecondaryActuator::Force(_) => "the secondary's servo clamps",
            },
            ClampedBy::Primary => match primary {
                PrimaryActuator::Flyweights { .. } => "flyweights and spring clamp",
                PrimaryActuator::Force(_) | PrimaryActuator::Position(_) => "the primary's servo clamps",
            },
            ClampedBy::Reserve(_) => "the reserve that is asked for is left by",
        }
    }

    /// The next place, from a solution nearby; where that is too far, by way of the place half-way.
    fn next(&self, near: &Solved, place: Place) -> Result<Solved, InverseError> {
        self.by_steps(near, place, HALVED)
    }

    fn by_steps(&self, near: &Solved, place: Place, halvings: usize) -> Result<Solved, InverseError> {
        let question = self.question(place, near.constant(Constant::SlackTension));
        let error = match self.solved(near, &question, place) {
            Ok(solved) => return self.settled(solved, place),
            Err(error) if error.is_bad_input() || crate::cancel::is_cancelled() || halvings == 0 => return Err(error),
            Err(error) => error,
        };
        let halfway = match place {
            Place::Primary(radius) => Place::Primary(0.5 * (near.constant(Constant::PrimaryRadius) + radius)),
            Place::Secondary(radius) => Place::Secondary(0.5 * (near.constant(Constant::SecondaryRadius) + radius)),
        };
        let between = self.by_steps(near, halfway, halvings - 1).map_err(|_| error)?;
        self.by_steps(&between, place, halvings - 1)
    }

    fn solved(&self, near: &Solved, question: &Question, place: Place) -> Result<Solved, InverseError> {
        let solved = solve_question_from(near, &self.case.model, question, self.options)
            .or_else(|_| approach_question(near, &self.case.model, question, self.options));
        let ratio = match place {
            Place::Primary(radius) => self.ratio(radius),
            Place::Secondary(radius) => radius / self.whole_primary(radius),
        };
        solved.map_err(|failure| self.failed(ratio, failure)).and_then(|solved| self.in_place(solved))
    }

    /// Refuses a belt on a radius of the secondary that has nothing to do with its length: no drive comes to it.
    fn in_place(&self, solved: Solved) -> Result<Solved, InverseError> {
        if !self.whole.lies_deep(&solved) {
            return Ok(solved);
        }
        let (primary, secondary) =
            (solved.constant(Constant::PrimaryRadius), solved.constant(Constant::SecondaryRadius));
        Err(InverseError::Deep { ratio: secondary / primary, left: self.ratio(primary), clamp: self.clamps() })
    }

    fn whole_primary(&self, secondary: f64) -> f64 {
        radius_beside(secondary, self.case.belt.length, self.case.drive.center_distance).unwrap_or(f64::NAN)
    }

    /// With the reserve that is asked for, if that is what clamps: the slack tension by secants of its logarithm.
    fn settled(&self, solved: Solved, place: Place) -> Result<Solved, InverseError> {
        let ClampedBy::Reserve(wanted) = self.clamp else { return Ok(solved) };
        let mut here = solved;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..RESERVES {
            let (tension, missing) = (libm::log(here.constant(Constant::SlackTension)), wanted - slip_reserve(&here)?);
            if missing.abs() <= MET {
                return Ok(here);
            }
            let step = match before {
                Some((other, missed)) if missed != missing => -missing * (tension - other) / (missing - missed),
                _ => missing.signum() * libm::log(NUDGE),
            };
            before = Some((tension, missing));
            let next = libm::exp(tension + step.clamp(-STRIDE, STRIDE));
            here = self.solved(&here, &self.question(place, next), place)?;
        }
        let ratio = here.constant(Constant::SecondaryRadius) / here.constant(Constant::PrimaryRadius);
        let remedy = "no slack tension was found that leaves as much; ask for another reserve";
        Err(InverseError::Reserve { ratio, reserve: slip_reserve(&here)?, wanted, remedy })
    }

    fn read(&self, solved: &Solved) -> Result<InversePoint, InverseError> {
        let outputs = solved.belt.output_values(&solved.solution)?;
        let half_angle = self.case.sheave.half_angle;
        let (primary, secondary) =
            (solved.constant(Constant::PrimaryRadius), solved.constant(Constant::SecondaryRadius));
        let efficiency = outputs.get(Output::EfficiencyOverall)?;
        Ok(InversePoint {
            primary_travel: crate::actuator::travel(half_angle, self.actuation.start_radius, primary),
            secondary_travel: crate::actuator::travel(half_angle, secondary, self.actuation.closed_radius),
            ratio: secondary / primary,
            secondary_speed: outputs.get(Output::SecondarySpeed)?,
            secondary_torque: outputs.get(Output::SecondaryTorque)?,
            primary_axial_force: outputs.get(Output::PrimaryAxialForce)?,
            secondary_axial_force: outputs.get(Output::SecondaryAxialForce)?,
            slack_tension: solved.constant(Constant::SlackTension),
            slip_reserve: slip_reserve(solved)?,
            efficiency: efficiency.is_finite().then_some(efficiency),
            buckled: is_buckled(solved.constant(Constant::PrimaryWrap), solved.constant(Constant::SecondaryWrap)),
            pushed: Compressed::of(&solved.belt, &solved.solution).is_some(),
        })
    }
}
