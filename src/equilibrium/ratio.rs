//! A drive at a nominal ratio, between its stops: the speed of the engine is found, or given, and that of the secondary
//! follows.

use super::error::EquilibriumError;
use super::phase::{Direction, Phase};
use super::point::{Equilibrium, ordinary};
use super::question::{Given, Whole};
use crate::case::geometry::radii_of_ratio;
use crate::case::{Clamp, Free, Load, Resolved, Speed};
use crate::drive::{
    Constant, Failure, Question, SolveOptions, Solved, approach_question, solve_question, solve_question_from,
};

/// A drive whose radii are nominal but for one, which is where the belt closes: as on a map over the ratio.
pub(crate) struct AtRatio<'a> {
    whole: Whole<'a>,
    case: &'a Resolved,
    radii: (f64, f64),
    options: &'a SolveOptions,
}

impl<'a> AtRatio<'a> {
    /// A whole drive at a ratio that its belt fits.
    ///
    /// # Errors
    /// A case that lacks a part, or a ratio at which the belt fits no pulleys.
    pub fn new(
        case: &'a Resolved,
        ratio: f64,
        direction: Direction,
        options: &'a SolveOptions,
    ) -> Result<Self, EquilibriumError> {
        let whole = Whole::new(case, Given::SecondarySpeed(1.0), direction)?;
        let why = "the belt fits no pulleys of this ratio";
        let radii = radii_of_ratio(ratio, case.belt.length, case.drive.center_distance)
            .map_err(|_| EquilibriumError::Implausible { phase: Phase::Shift, why })?;
        Ok(Self { whole, case, radii, options })
    }

    fn question(&self, speed: f64, tension: f64) -> Question {
        let mut posed = ordinary(self.case);
        posed.drive.free = self.case.drive.free.or(Some(Free::PrimaryRadius));
        (posed.drive.primary_radius, posed.drive.secondary_radius) = self.radii;
        posed.operating_point.speed = Speed::Primary(speed);
        posed.operating_point.load = Load::PrimaryTorque(self.whole.engine.torque(speed).value);
        posed.operating_point.clamp = Clamp::SlackTension(tension);
        Question::of(&posed)
    }

    fn solved(&self, question: &Question, near: Option<&Solved>) -> Result<Solved, Failure> {
        let model = &self.case.model;
        match near {
            Some(near) => solve_question_from(near, model, question, self.options)
                .or_else(|_| approach_question(near, model, question, self.options)),
            None => solve_question(model, question, self.options),
        }
    }

    /// A state of the belt with the engine's torque at a speed and with a slack tension, whatever the actuators press
    /// with.
    ///
    /// # Errors
    /// See [`EquilibriumError`].
    pub fn belt(&self, speed: f64, tension: f64, near: Option<&Solved>) -> Result<Solved, EquilibriumError> {
        let solved = self.solved(&self.question(speed, tension), near);
        let solved = solved.map_err(|failure| self.whole.failed(Phase::Shift, failure))?;
        self.whole.plausible(solved, Phase::Shift)
    }

    /// What the actuators press with beside a state of the belt, and what it takes.
    ///
    /// # Errors
    /// [`EquilibriumError::Actuator`].
    pub fn beside(&self, belt: &Solved) -> Result<Equilibrium, EquilibriumError> {
        self.whole.read(belt.clone(), Phase::Shift)
    }

    /// The state of the belt at a speed at which the secondary's actuator balances it.
    ///
    /// # Errors
    /// See [`EquilibriumError`].
    pub fn clamped(&self, speed: f64, near: &Solved) -> Result<Equilibrium, EquilibriumError> {
        let question = self.question(speed, near.constant(Constant::SlackTension));
        let question = question.close(self.whole.by_secondary(Constant::SlackTension));
        self.read(self.solved(&question, Some(near)))
    }

    /// The equilibrium: the speed and the slack tension at which both actuators balance the belt.
    ///
    /// # Errors
    /// See [`EquilibriumError`].
    pub fn balance(&self, near: &Solved) -> Result<Equilibrium, EquilibriumError> {
        let (speed, tension) = (near.constant(Constant::PrimarySpeed), near.constant(Constant::SlackTension));
        let question = self.question(speed, tension).close(self.whole.by_engine());
        let question = question.close(self.whole.by_primary(Constant::PrimarySpeed));
        self.read(self.solved(&question.close(self.whole.by_secondary(Constant::SlackTension)), Some(near)))
    }

    fn read(&self, solved: Result<Solved, Failure>) -> Result<Equilibrium, EquilibriumError> {
        let solved = solved.map_err(|failure| self.whole.failed(Phase::Shift, failure))?;
        self.whole.read(solved, Phase::Shift)
    }
}
