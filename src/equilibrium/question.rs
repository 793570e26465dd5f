//! What is asked of a belt within a whole drive, and whether a state of it is consistent with the drive's stops.

use std::sync::Arc;

use super::error::EquilibriumError;
use super::estimate::{Estimate, estimate, highest_ratio};
use super::laws::{EngineLaw, PrimaryLaw, SecondaryLaw};
use super::phase::{Direction, Phase, Stop};
use super::point::{Equilibrium, ordinary, posed_at};
use crate::actuator::{ActuatorError, PrimaryActuator, travel_by_radius};
use crate::case::geometry::radius_beside;
use crate::case::{Actuation, Clamp, Load, Resolved, Speed};
use crate::drive::{
    Closing, Constant, Failure, Output, Question, SolveOptions, Solved, approach_question, solve_question_from,
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

/// The slip threshold, m/s, from which on equilibria of belts without bending stiffness are found.
const STRING_THRESHOLD: f64 = 5e-3;

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
    pub case: &'a Resolved,
    pub actuation: &'a Actuation,
    pub engine: &'a Engine,
    given: Given,
    pub direction: Direction,
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
    pub fn lies_deep(&self, solved: &Solved) -> bool {
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        let beside = radius_beside(solved.constant(Constant::PrimaryRadius), length, center);
        beside.is_ok_and(|radius| solved.constant(Constant::SecondaryRadius) < LEAST_RADIUS * radius)
    }

    /// Refuses a drive whose engine would have to turn far beyond what is known of it, whose primary is open, or whose
    /// secondary cannot press: a search would end nowhere, after long, and would not know why.
    pub fn in_reach(&self, near: &Estimate) -> Result<(), EquilibriumError> {
        if let Given::SecondarySpeed(secondary_speed) = self.given {
            let (ratio, _) = self.highest_ratio(secondary_speed);
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

    /// R_S/R_P where the sheaves stand at the high stop, and that stop; without one, as far as the belt lets them.
    pub fn highest_ratio(&self, secondary_speed: f64) -> (f64, Option<Stop>) {
        highest_ratio(self.case, self.actuation, self.engine, secondary_speed, self.direction)
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
    pub fn question(&self, phase: Phase, at: &Resolved) -> Question {
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

    pub fn by_engine(&self) -> Closing {
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

    pub fn read(&self, solved: Solved, phase: Phase) -> Result<Equilibrium, EquilibriumError> {
        Equilibrium::of(self.actuation, self.plausible(solved, phase)?, phase, self.direction)
    }

    /// Refuses a state of the belt to which no drive comes.
    pub fn plausible(&self, solved: Solved, phase: Phase) -> Result<Solved, EquilibriumError> {
        if self.lies_deep(&solved) {
            let why = "the only state found has the belt far deeper in the secondary than its length leaves it";
            return Err(EquilibriumError::Implausible { phase, why });
        }
        Ok(solved)
    }

    pub fn failed(&self, phase: Phase, failure: Failure) -> EquilibriumError {
        let has_bending = self.case.edition.model().bending.is_some();
        let sharp = !has_bending && self.case.sheave.slip_threshold < STRING_THRESHOLD;
        EquilibriumError::Failure { phase, failure: Box::new(failure), sharp }
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

    /// From a state of the drive on to others, speed by speed of the secondary, to that at the last.
    pub fn along(
        &self,
        near: Equilibrium,
        speeds: impl IntoIterator<Item = f64>,
        options: &SolveOptions,
    ) -> Result<Equilibrium, EquilibriumError> {
        let mut speeds = speeds.into_iter();
        speeds.try_fold(near, |near, speed| self.at(speed).settle_from(&near.solved, near.phase, options))
    }

    /// The same drive at another speed of the secondary, rad/s.
    pub fn at(&self, secondary_speed: f64) -> Self {
        Self { given: Given::SecondarySpeed(secondary_speed), ..*self }
    }

    /// Goes on from a state to the one that is consistent with all stops.
    pub fn settle(&self, found: Equilibrium, options: &SolveOptions) -> Result<Equilibrium, EquilibriumError> {
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
    pub fn settle_from(
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
pub(super) fn start(case: &Resolved, near: &Estimate) -> Resolved {
    let mut posed = ordinary(case);
    posed.drive.primary_radius = near.primary_radius;
    posed.drive.secondary_radius = near.secondary_radius;
    posed.operating_point.speed = Speed::Primary(near.speed);
    posed.operating_point.load = Load::PrimaryTorque(near.torque);
    posed.operating_point.clamp = Clamp::SlackTension(near.slack_tension);
    posed
}
