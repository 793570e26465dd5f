//! The curve from an operating point to the stall of the secondary.

use solver::Linearisation;
use solver::continuation::PointKind;

use super::error::DesignError;
use super::state::DriveState;
use crate::case::ModelChoices;
use crate::drive::{Curve, End, Failure, SolveOptions, Solved, step_to_question, trace};
use crate::model::{Constant, InternalError, Output};

/// Speed efficiency down to which a curve is followed in arclength. Below it the belt comes to rest: states change
/// within 1e-4 of speed efficiency at the end, where sliding speeds on the secondary fall below the slip threshold, and
/// the speed efficiency itself is the better parameter.
const RESTING: f64 = 0.02;
/// The same in engine braking, where it is the secondary's speed that grows beyond all bounds: steps in arclength
/// follow it by a few thousandths each, while torque and tension hardly change any more.
const RUNNING_AWAY: f64 = 0.8;
/// Speed efficiency to which the curve is followed in engine braking, where the driven pulley comes to rest as the
/// secondary's speed grows beyond all bounds.
const AT_REST: f64 = 0.01;
/// Speed efficiency from which on the driven pulley counts as at rest in engine braking, should the curve be lost:
/// beyond it, the secondary's speed changes torque and tension by less than a hundredth.
const BRAKED: f64 = 0.1;
/// Speed efficiency below which a curve that is lost in arclength is followed in speed efficiency.
const SLIPPING: f64 = 0.98;
/// First, smallest and largest step in speed efficiency.
const FIRST_STEP: f64 = 2e-3;
const SMALLEST_STEP: f64 = 1e-4;
const LARGEST_STEP: f64 = 0.15;
/// How steps grow, and shrink after a failure.
const GROWTH: f64 = 1.6;
const SHRINKAGE: f64 = 0.3;

/// In what a curve is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// Arclength.
    Arclength,
    /// The speed efficiency, downwards: prescribed, with torque or slack tension unknown.
    SpeedEfficiency,
}

/// A solution on the curve.
#[derive(Debug, Clone)]
pub struct BranchPoint {
    /// The solution.
    pub solved: Solved,
    /// What the drive does here.
    pub state: DriveState,
    /// In what the curve is followed here.
    pub parameter: Parameter,
    /// The speed efficiency.
    pub place: f64,
    /// Whether what is sought was found to have an extremum here.
    pub is_extremum: bool,
}

/// Where a curve ends.
#[derive(Debug)]
pub enum BranchEnd {
    /// At the speed efficiency to which it was to be followed.
    Whole,
    /// No solution was found beyond its last point.
    Lost(Failure),
}

/// Solutions in order, the operating point first. Where the parameter changes, a solution stands twice.
#[derive(Debug)]
pub struct Branch {
    /// The solutions.
    pub points: Vec<BranchPoint>,
    /// Why there are no more.
    pub end: BranchEnd,
    model: ModelChoices,
    start: Solved,
    free: Constant,
    efficiency: Output,
    /// Whether the secondary drives.
    braking: bool,
    options: SolveOptions,
}

impl BranchPoint {
    fn new(solved: Solved, parameter: Parameter, place: f64, is_extremum: bool) -> Result<Self, InternalError> {
        Ok(Self { state: DriveState::of(&solved)?, solved, parameter, place, is_extremum })
    }

    /// An output here, SI.
    ///
    /// # Errors
    /// [`InternalError::Output`] if the drive does not have it.
    pub fn value(&self, output: Output) -> Result<f64, InternalError> {
        self.solved.belt.output_values(&self.solved.solution)?.get(output)
    }

    /// An output, and its rate as the speed efficiency falls, where that is prescribed.
    ///
    /// # Errors
    /// [`DesignError::Singular`] if the equations are singular, as where the parameter turns.
    pub fn value_and_rate(&self, output: Output) -> Result<(f64, f64), DesignError> {
        let (values, gradients) = self.solved.belt.output_gradients(&self.solved.solution)?;
        // Prescribed last.
        let index = Constant::ALL.len() + self.solved.belt.prescribed().count().saturating_sub(1);
        let rates = Linearisation::new(&self.solved.belt, &self.solved.solution)?.sensitivity(index).inputs();
        let gradient = gradients.get(output)?.iter();
        let rate = gradient.zip(&rates).map(|(partial, rate)| partial * rate).sum::<f64>();
        Ok((values.get(output)?, -rate))
    }
}

impl Branch {
    /// Follows the curve on which `free` (the primary's torque, or the slack tension) moves, from the operating point
    /// `start` down to the speed efficiency `last`, 0 being the stall (in engine braking, a tenth); at first so that
    /// `sought` rises (`upwards`) or falls.
    ///
    /// # Errors
    /// [`Failure::NoEquations`].
    pub fn trace(
        model: &ModelChoices,
        start: &Solved,
        (free, sought): (Constant, Output),
        upwards: bool,
        last: f64,
        options: &SolveOptions,
    ) -> Result<Self, Failure> {
        let efficiency = Output::EfficiencySpeed;
        // In engine braking the primary is driven: it comes to rest as σ grows beyond all bounds.
        let braking = start.constant(Constant::PrimaryTorque) < 0.0;
        let least = last.max(if braking { RUNNING_AWAY } else { RESTING });
        let (asked, last) = (last, if braking { last.max(AT_REST) } else { last });
        let end = End { output: efficiency, value: if braking { 1.0 / least } else { least }, rising: braking };
        let Curve { points, lost } = trace(model, start, (free, sought), upwards, end, options)?;
        let mut branch = Self {
            points: Vec::new(),
            end: BranchEnd::Whole,
            model: *model,
            start: start.clone(),
            free,
            efficiency,
            braking,
            options: *options,
        };
        for (kind, solved) in points {
            let place = DriveState::of(&solved)?.speed_efficiency;
            let is_extremum = kind == PointKind::Fold;
            // An extremum counts as accurately as any solution.
            let settled = if is_extremum { branch.at(place, &solved).ok() } else { None };
            let solved = settled.map_or(solved, |point| point.solved);
            branch.points.push(BranchPoint::new(solved, Parameter::Arclength, place, is_extremum)?);
        }
        match lost {
            // Where arclength is lost on a belt that slips, the speed efficiency may still be a good parameter.
            Some(failure) if !failure.is_cancelled() && branch.slips() => {
                let found = branch.points.len();
                branch.descend(last);
                if branch.points.len() == found {
                    branch.end = BranchEnd::Lost(failure);
                }
            }
            Some(failure) => branch.end = BranchEnd::Lost(failure),
            None => branch.descend(last),
        }
        if braking && asked < AT_REST && branch.points.last().is_some_and(|point| point.place <= BRAKED) {
            branch.end = BranchEnd::Whole;
        }
        Ok(branch)
    }

    /// The solution at a speed efficiency, from one nearby.
    pub(super) fn at(&self, place: f64, from: &Solved) -> Result<BranchPoint, Failure> {
        let value = if self.braking { 1.0 / place } else { place };
        let question = self.start.question.clone().swap(self.free, self.efficiency, value);
        let solved = step_to_question(from, &self.model, &question, &self.options)?;
        Ok(BranchPoint::new(solved, Parameter::SpeedEfficiency, place, false)?)
    }

    /// Whether the last point's speed efficiency is well below one.
    fn slips(&self) -> bool {
        self.points.last().is_some_and(|point| point.place < SLIPPING)
    }

    fn descend(&mut self, last: f64) {
        let Some(here) = self.points.last() else { return };
        let speed = here.state.speed_efficiency;
        match self.at(speed.max(last), &here.solved) {
            Ok(point) => self.points.push(point),
            Err(failure) => {
                self.end = BranchEnd::Lost(failure);
                return;
            }
        }
        let mut step = FIRST_STEP;
        while let Some(here) = self.points.last().filter(|point| point.place > last) {
            let rest = here.place - last;
            // A last sliver would cost a step of its own.
            let next = if 1.01 * step >= rest { last } else { here.place - step };
            match self.at(next, &here.solved) {
                Ok(point) => {
                    step = (GROWTH * step).min(LARGEST_STEP);
                    self.points.push(point);
                }
                Err(failure) => {
                    step = SHRINKAGE * step.min(rest);
                    if step < SMALLEST_STEP {
                        self.end = BranchEnd::Lost(failure);
                        return;
                    }
                }
            }
        }
    }
}
