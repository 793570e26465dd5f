//! From a drive and a speed of its secondary to its equilibrium.

use std::sync::Arc;

use super::error::EquilibriumError;
use super::estimate::{Estimate, elsewhere, estimate, highest_ratio};
use super::laws::{EngineLaw, PrimaryLaw, SecondaryLaw};
use super::point::{Direction, Equilibrium, Phase, Stop};
use crate::actuator::{ActuatorError, PrimaryActuator, travel_by_radius};
use crate::case::geometry::radius_beside;
use crate::case::{Actuation, Clamp, Load, Resolved, Speed};
use crate::drive::{
    Closing, Constant, Failure, Output, Question, SolveOptions, Solved, approach_question, solve_question,
    solve_question_from,
};
use crate::powertrain::Engine;

/// States that are tried at most: from one end to the other and back.
const STATES: usize = 5;
/// A typical force of an actuator, N.
const FORCE: f64 = 1000.0;
/// Travel in m, and share of a force, by which a stop may be missed.
const TRAVEL_SLACK: f64 = 1e-9;
const FORCE_SLACK: f64 = 1e-6;
/// Over the last speed for which the engine's torque is known, the speed at which no equilibrium is sought. Below, one
/// may be found at the high stop: a belt that is hardly loaded climbs on the primary, and the engine turns the slower.
const BEYOND_ENGINE: f64 = 2.0;
/// Radius of the secondary over that which the belt's length leaves beside the primary's, at least: belts that are
/// clamped well have 0.9 and more, those that hardly carry the torque, and bulge, 0.73 and more.
const LEAST_RADIUS: f64 = 0.7;
/// Share of the speed by which two states of a belt that slips are two.
const JUMP: f64 = 0.03;
/// Shares of the secondary's speed from which an equilibrium is followed where none is found from nothing, and steps.
const SLOWER: [f64; 2] = [0.9, 0.75];
const SLOWER_STEPS: u32 = 3;
/// By what the secondary's speed changes with each step towards one at which the belt slips as a clutch does, and steps
/// at most: down to a hundredth of the speed at which the primary closes.
const CLUTCH_STEP: f64 = 0.8;
const CLUTCH_STEPS: i32 = 21;

/// What is given of a drive, beside its parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Given {
    /// Speed of the secondary, rad/s.
    SecondarySpeed(f64),
    /// A stop that the sheave touches without a force: where a phase begins or ends.
    Corner(Stop),
    /// Speed efficiency at the low stop: where the belt takes the drive off.
    SpeedEfficiency(f64),
}

/// A drive with all its parts.
#[derive(Clone, Copy)]
pub(super) struct Whole<'a> {
    case: &'a Resolved,
    actuation: &'a Actuation,
    engine: &'a Engine,
    given: Given,
    direction: Direction,
}

/// The equilibrium of a drive whose secondary turns at `secondary_speed` in rad/s, from nothing. Of the case, belt,
/// sheaves, center distance, actuators and engine count; its operating point and its radii do not. Where the search
/// comes to one at which the belt slips, it looks elsewhere for another that holds: a drive may have both. Where it
/// comes to none, it goes on from a slower secondary.
///
/// # Errors
/// See [`EquilibriumError`].
pub fn equilibrium(
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let error = match from_nothing(case, secondary_speed, direction, options) {
        Err(
            error @ (EquilibriumError::Failure { .. }
            | EquilibriumError::Implausible { .. }
            | EquilibriumError::Cycle(_)),
        ) if !error.is_bad_input() && !error.is_cancelled() => error,
        done => return done,
    };
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    for share in SLOWER {
        let Ok(near) = from_nothing(case, share * secondary_speed, direction, options) else { continue };
        let left = |step: u32| 1.0 - f64::from(step) / f64::from(SLOWER_STEPS);
        let speeds = (1..=SLOWER_STEPS).map(|step| secondary_speed * libm::pow(share, left(step)));
        match whole.along(near, speeds, options) {
            Err(error) if !error.is_cancelled() => {}
            done => return done,
        }
    }
    Err(error)
}

/// As [`equilibrium`], by starts at the speed itself.
fn from_nothing(
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    let near = whole.rough();
    match whole.in_reach(&near) {
        Ok(()) => {}
        Err(open @ EquilibriumError::Disengaged { .. }) => return whole.engaging(secondary_speed, open, options),
        Err(error) => return Err(error),
    }
    let from = |near: &Estimate| {
        let question = whole.question(near.phase, &start(case, near));
        let solved = solve_question(&case.model, &question, options);
        whole.settle(whole.read(solved.map_err(|failure| whole.failed(near.phase, failure))?, near.phase)?, options)
    };
    let first = match from(&near) {
        Ok(found) if found.holds()? => return Ok(found),
        Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
        other => other,
    };
    // A start may lead nowhere, or to a belt that slips, because the drive is not where it was taken to be.
    let mut best = first;
    for other in elsewhere(case, whole.actuation, whole.engine, secondary_speed, direction) {
        match from(&other) {
            Ok(found) if found.holds()? => return Ok(found),
            Ok(found) => {
                if best.as_ref().map_or(Ok(true), |best| loses_less(&found, best))? {
                    best = Ok(found);
                }
            }
            Err(error) if error.is_cancelled() => return Err(error),
            Err(_) => {}
        }
    }
    best
}

/// Whether a belt loses clearly less of the speed than another one.
fn loses_less(found: &Equilibrium, other: &Equilibrium) -> Result<bool, EquilibriumError> {
    Ok(found.output(Output::EfficiencySpeed)? > other.output(Output::EfficiencySpeed)? + JUMP)
}

/// As [`equilibrium`], from that of a case nearby: other parts, or another speed. Where that leads nowhere, as it may
/// across a stop, from nothing; so too where it leads to a belt that slips, and slips more than it did: the better of
/// both is told.
///
/// # Errors
/// See [`EquilibriumError`].
pub fn equilibrium_from(
    near: &Equilibrium,
    case: &Resolved,
    secondary_speed: f64,
    direction: Direction,
    options: &SolveOptions,
) -> Result<Equilibrium, EquilibriumError> {
    let whole = Whole::new(case, Given::SecondarySpeed(secondary_speed), direction)?;
    let slipping = match whole.settle_from(&near.solved, near.phase, options) {
        Ok(found) if found.holds()? || !loses_less(near, &found)? => return Ok(found),
        Ok(found) => found,
        Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
        Err(_) => return from_nothing(case, secondary_speed, direction, options),
    };
    match from_nothing(case, secondary_speed, direction, options) {
        Ok(found) if loses_less(&found, &slipping)? => Ok(found),
        Err(error) if error.is_cancelled() => Err(error),
        Ok(_) | Err(_) => Ok(slipping),
    }
}

/// Refuses a case that lacks a part of a whole drive.
///
/// # Errors
/// [`EquilibriumError::Missing`] says which, and what to give.
pub fn has_all_parts(case: &Resolved) -> Result<(), EquilibriumError> {
    Whole::new(case, Given::Corner(Stop::SecondaryClosed), Direction::default()).map(|_| ())
}

impl<'a> Whole<'a> {
    pub fn new(case: &'a Resolved, given: Given, direction: Direction) -> Result<Self, EquilibriumError> {
        if let Given::SecondarySpeed(speed) = given
            && !(speed > 0.0 && speed.is_finite())
        {
            return Err(EquilibriumError::Speed(speed));
        }
        let actuation = case.parts.actuation.as_ref().ok_or(EquilibriumError::Missing {
            what: "actuators",
            needs: "give [primary.actuator] and [secondary.actuator] with their springs",
        })?;
        let engine = case
            .parts
            .engine
            .as_ref()
            .ok_or(EquilibriumError::Missing { what: "engine", needs: "give [engine] with speeds and torques" })?;
        Ok(Self { case, actuation, engine, given, direction })
    }

    /// A rough equilibrium, to begin with.
    pub fn rough(&self) -> Estimate {
        let speed = match self.given {
            Given::SecondarySpeed(speed) => speed,
            Given::Corner(_) | Given::SpeedEfficiency(_) => self.engine.range().0,
        };
        estimate(self.case, self.actuation, self.engine, speed, self.direction)
    }

    /// The equilibrium at an end of a phase, from one of the same drive.
    pub fn corner(&self, from: &Equilibrium, options: &SolveOptions) -> Result<Equilibrium, EquilibriumError> {
        let phase = match self.given {
            Given::Corner(Stop::SecondaryClosed) | Given::SpeedEfficiency(_) => Phase::Low,
            Given::Corner(stop) => Phase::High(stop),
            Given::SecondarySpeed(_) => from.phase,
        };
        let question = self.question(phase, &posed_at(self.case, &from.solved));
        let solved = approach_question(&from.solved, &self.case.model, &question, options);
        let found = self.read(solved.map_err(|failure| self.failed(phase, failure))?, phase)?;
        match self.given {
            Given::SpeedEfficiency(_) if self.other(&found).is_some() => {
                let why = "the secondary opens before the belt takes the drive off";
                Err(EquilibriumError::Implausible { phase, why })
            }
            Given::Corner(_) | Given::SpeedEfficiency(_) | Given::SecondarySpeed(_) => Ok(found),
        }
    }

    /// Whether a belt lies on a radius of the secondary that has nothing to do with its length: the equations have such
    /// solutions at high speeds, with spans that swing far out.
    fn lies_deep(&self, solved: &Solved) -> bool {
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        let beside = radius_beside(solved.constant(Constant::PrimaryRadius), length, center);
        beside.is_ok_and(|radius| solved.constant(Constant::SecondaryRadius) < LEAST_RADIUS * radius)
    }

    /// Refuses a drive whose engine would have to turn far beyond what is known of it, whose primary is open, or whose
    /// secondary cannot press: a search would end nowhere, after long, and would not know why.
    fn in_reach(&self, near: &Estimate) -> Result<(), EquilibriumError> {
        if let Given::SecondarySpeed(secondary_speed) = self.given {
            let ratio = highest_ratio(self.case, self.actuation, self.engine, secondary_speed, self.direction);
            let last_speed = self.engine.range().1;
            if ratio * secondary_speed > BEYOND_ENGINE * last_speed {
                return Err(EquilibriumError::BeyondEngine { secondary_speed, ratio, last_speed });
            }
        }
        self.secondary_presses(near)?;
        let half_angle = self.case.sheave.half_angle;
        let travel = crate::actuator::travel(half_angle, self.actuation.start_radius, near.primary_radius);
        match self.actuation.primary.force(near.speed, travel, self.direction.primary()) {
            Err(error) => Err(EquilibriumError::Actuator { phase: near.phase, error }),
            Ok(Some(force)) if force.value <= 0.0 => {
                Err(EquilibriumError::Disengaged { speed: near.speed, force: -force.value })
            }
            Ok(_) => Ok(()),
        }
    }

    fn secondary_presses(&self, near: &Estimate) -> Result<(), EquilibriumError> {
        let half_angle = self.case.sheave.half_angle;
        let opening = crate::actuator::travel(half_angle, near.secondary_radius, self.actuation.closed_radius);
        let torque = near.torque * near.secondary_radius / near.primary_radius;
        match self.actuation.secondary.force(torque, opening, self.direction.secondary()) {
            // Where the sheave comes to stand in the end, contact and spring may be another matter; friction is not.
            Err(error @ ActuatorError::HelixLocks { .. }) => {
                Err(EquilibriumError::Actuator { phase: near.phase, error })
            }
            Ok(_) | Err(_) => Ok(()),
        }
    }

    /// What is asked of the belt in a phase: constants as in `at`, five or four of them unknown.
    fn question(&self, phase: Phase, at: &Resolved) -> Question {
        let slope = travel_by_radius(self.case.sheave.half_angle);
        let mut question = Question::of(at);
        let closed = self.actuation.closed_radius;
        match phase {
            Phase::Low | Phase::High(Stop::SecondaryClosed) => question.constants[Constant::SecondaryRadius] = closed,
            Phase::High(Stop::SecondaryOpen) => {
                let travel = self.actuation.secondary_travel.unwrap_or(0.0);
                question.constants[Constant::SecondaryRadius] = closed - travel / slope;
            }
            Phase::High(Stop::PrimaryClosed) => {
                let travel = self.actuation.primary_travel.unwrap_or(0.0);
                question.constants[Constant::PrimaryRadius] = self.actuation.start_radius + travel / slope;
            }
            Phase::Held => {
                let travel = match self.actuation.primary {
                    PrimaryActuator::Position(travel) => travel,
                    PrimaryActuator::Flyweights { .. } | PrimaryActuator::Force(_) => 0.0,
                };
                question.constants[Constant::PrimaryRadius] = self.actuation.start_radius + travel / slope;
            }
            Phase::Shift => {}
        }
        let primary_is_given = matches!(phase, Phase::High(Stop::PrimaryClosed) | Phase::Held);
        let other = if primary_is_given { Constant::SecondaryRadius } else { Constant::PrimaryRadius };
        let question = question.swap(other, Output::BeltUnstretchedLength, self.case.belt.length);
        let mut question = match self.given {
            Given::SecondarySpeed(speed) => question.swap(Constant::PrimarySpeed, Output::SecondarySpeed, speed),
            Given::SpeedEfficiency(share) => question.swap(Constant::PrimarySpeed, Output::EfficiencySpeed, share),
            // The law of the pulley that touches its stop holds as well.
            Given::Corner(Stop::PrimaryClosed) => question.close(self.by_primary(Constant::PrimarySpeed)),
            Given::Corner(Stop::SecondaryClosed | Stop::SecondaryOpen) => {
                question.close(self.by_secondary(Constant::PrimarySpeed))
            }
        };
        question = question.close(self.by_engine());
        if !primary_is_given {
            question = question.close(self.by_primary(Constant::SlackTension));
        }
        match phase {
            Phase::Shift => question.close(self.by_secondary(Constant::SecondaryRadius)),
            Phase::High(Stop::PrimaryClosed) | Phase::Held => question.close(self.by_secondary(Constant::SlackTension)),
            Phase::Low | Phase::High(Stop::SecondaryOpen | Stop::SecondaryClosed) => question,
        }
    }

    fn by_engine(&self) -> Closing {
        let law = EngineLaw { engine: self.engine.clone() };
        Closing { free: Constant::PrimaryTorque, law: Arc::new(law) }
    }

    pub fn by_primary(&self, free: Constant) -> Closing {
        let law = PrimaryLaw {
            actuator: self.actuation.primary.clone(),
            shift: self.direction.primary(),
            start_radius: self.actuation.start_radius,
            scale: FORCE,
        };
        Closing { free, law: Arc::new(law) }
    }

    pub fn by_secondary(&self, free: Constant) -> Closing {
        let law = SecondaryLaw {
            actuator: self.actuation.secondary.clone(),
            shift: self.direction.secondary(),
            closed_radius: self.actuation.closed_radius,
            scale: FORCE,
        };
        Closing { free, law: Arc::new(law) }
    }

    fn read(&self, solved: Solved, phase: Phase) -> Result<Equilibrium, EquilibriumError> {
        if self.lies_deep(&solved) {
            let why = "the only state found has the belt far deeper in the secondary than its length leaves it";
            return Err(EquilibriumError::Implausible { phase, why });
        }
        Equilibrium::of(self.actuation, solved, phase, self.direction)
    }

    fn failed(&self, phase: Phase, failure: Failure) -> EquilibriumError {
        EquilibriumError::Failure { phase, failure: Box::new(failure) }
    }

    /// The phase that a state is to be left for; none if it is consistent with all stops.
    fn other(&self, found: &Equilibrium) -> Option<Phase> {
        let pulls = |belt: f64| found.forces.stop.is_some_and(|force| force < -FORCE_SLACK * belt);
        match found.phase {
            Phase::Held => None,
            Phase::Low => pulls(found.forces.secondary_belt).then_some(Phase::Shift),
            Phase::High(Stop::PrimaryClosed) => pulls(found.forces.primary_belt).then_some(Phase::Shift),
            Phase::High(_) => pulls(found.forces.secondary_belt).then_some(Phase::Shift),
            Phase::Shift => {
                let beyond = |travel: f64, most: Option<f64>| most.is_some_and(|most| travel > most + TRAVEL_SLACK);
                if found.secondary_travel < -TRAVEL_SLACK {
                    Some(Phase::Low)
                } else if beyond(found.primary_travel, self.actuation.primary_travel) {
                    Some(Phase::High(Stop::PrimaryClosed))
                } else if beyond(found.secondary_travel, self.actuation.secondary_travel) {
                    Some(Phase::High(Stop::SecondaryOpen))
                } else {
                    None
                }
            }
        }
    }

    /// The equilibrium of a drive whose primary would be open if the belt did not slip: the engine runs away from the
    /// secondary until it closes the primary on the belt, which slips as a clutch does. It is sought from a faster
    /// secondary, at which the primary is closed, by steps; where those lead nowhere, the primary is told to be `open`.
    fn engaging(
        &self,
        secondary_speed: f64,
        open: EquilibriumError,
        options: &SolveOptions,
    ) -> Result<Equilibrium, EquilibriumError> {
        let speeds: Vec<f64> = (1..=CLUTCH_STEPS).map(|step| secondary_speed / CLUTCH_STEP.powi(step)).collect();
        let closed = speeds.iter().position(|speed| {
            let faster = self.at(*speed);
            faster.in_reach(&faster.rough()).is_ok()
        });
        let Some((slower, &[closed, ..])) = closed.and_then(|closed| speeds.split_at_checked(closed)) else {
            return Err(open);
        };
        let speeds = slower.iter().rev().chain([&secondary_speed]).copied();
        let found =
            from_nothing(self.case, closed, self.direction, options).and_then(|near| self.along(near, speeds, options));
        found.map_err(|error| if error.is_cancelled() { error } else { open })
    }

    /// From a state of the drive on to others, speed by speed of the secondary, to that at the last.
    fn along(
        &self,
        near: Equilibrium,
        speeds: impl IntoIterator<Item = f64>,
        options: &SolveOptions,
    ) -> Result<Equilibrium, EquilibriumError> {
        let mut speeds = speeds.into_iter();
        speeds.try_fold(near, |near, speed| self.at(speed).settle_from(&near.solved, near.phase, options))
    }

    /// The same drive at another speed of the secondary, rad/s.
    fn at(&self, secondary_speed: f64) -> Self {
        Self { given: Given::SecondarySpeed(secondary_speed), ..*self }
    }

    /// Goes on from a state to the one that is consistent with all stops.
    fn settle(&self, found: Equilibrium, options: &SolveOptions) -> Result<Equilibrium, EquilibriumError> {
        let mut here = found;
        for _ in 0..STATES {
            let Some(phase) = self.other(&here) else { return Ok(here) };
            let question = self.question(phase, &posed_at(self.case, &here.solved));
            let solved = approach_question(&here.solved, &self.case.model, &question, options);
            here = self.read(solved.map_err(|failure| self.failed(phase, failure))?, phase)?;
        }
        Err(EquilibriumError::Cycle(STATES))
    }

    /// From the solution of a drive nearby, taken to be in the same phase first.
    fn settle_from(
        &self,
        near: &Solved,
        phase: Phase,
        options: &SolveOptions,
    ) -> Result<Equilibrium, EquilibriumError> {
        let question = self.question(phase, &posed_at(self.case, near));
        let solved = solve_question_from(near, &self.case.model, &question, options)
            .or_else(|_| approach_question(near, &self.case.model, &question, options));
        let found = self.read(solved.map_err(|failure| self.failed(phase, failure))?, phase)?;
        self.settle(found, options)
    }
}

/// The case as an ordinary operating point at a rough equilibrium.
fn start(case: &Resolved, near: &Estimate) -> Resolved {
    let mut posed = ordinary(case);
    posed.drive.primary_radius = near.primary_radius;
    posed.drive.secondary_radius = near.secondary_radius;
    posed.operating_point.speed = Speed::Primary(near.speed);
    posed.operating_point.load = Load::PrimaryTorque(near.torque);
    posed.operating_point.clamp = Clamp::SlackTension(near.slack_tension);
    posed
}

/// The case as an ordinary operating point at a solution.
pub(super) fn posed_at(case: &Resolved, solved: &Solved) -> Resolved {
    let mut posed = ordinary(case);
    posed.drive.primary_radius = solved.constant(Constant::PrimaryRadius);
    posed.drive.secondary_radius = solved.constant(Constant::SecondaryRadius);
    posed.operating_point.speed = Speed::Primary(solved.constant(Constant::PrimarySpeed));
    posed.operating_point.load = Load::PrimaryTorque(solved.constant(Constant::PrimaryTorque));
    posed.operating_point.clamp = Clamp::SlackTension(solved.constant(Constant::SlackTension));
    posed
}

/// The case with nothing free and nothing prescribed.
pub(super) fn ordinary(case: &Resolved) -> Resolved {
    let mut posed = case.clone();
    posed.drive.free = None;
    posed.operating_point.fourth = None;
    posed.operating_point.margin = None;
    posed.swaps.clear();
    posed.found.clear();
    posed
}
