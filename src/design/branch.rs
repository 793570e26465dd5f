//! The curve from an operating point to the stall of the secondary.

use solver::{Linearisation, SolveError};

use super::error::DesignError;
use super::state::State;
use crate::case::{Model, Resolved};
use crate::drive::{Constant, Failure, Output, Question, SolveOptions, Solved, inputs, solve, solve_question_from};

/// First, smallest and largest step in speed efficiency.
const FIRST_STEP: f64 = 2e-3;
const SMALLEST_STEP: f64 = 1e-4;
const LARGEST_STEP: f64 = 0.15;
/// How steps grow, and shrink after a failure.
const GROWTH: f64 = 1.6;
const SHRINKAGE: f64 = 0.3;
/// Factor by which the torque grows, or the slack tension falls, as long as the speed efficiency hardly tells; and the one
/// below which a step is too small.
const FACTOR: f64 = 1.25;
const LEAST_FACTOR: f64 = 1.002;
/// Fall of the speed efficiency over the change of the logarithm of torque or slack tension from which on it tells.
const TELLING: f64 = 1e-3;
/// Smallest length over which torque or tension changes, over their value at the start: a tension may pass zero.
const LEAST_STRIDE: f64 = 0.01;
/// Points before the speed efficiency must tell, points where it turns, and how often it may.
const MOST_POINTS: usize = 60;
const LEAST_POINTS: usize = 2;
const MOST_TURNS: usize = 8;

/// In what a curve is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// The torque, upwards, or the slack tension, downwards: given like any other constant.
    Given(Constant),
    /// The speed efficiency, downwards: prescribed, with torque or slack tension unknown.
    SpeedEfficiency,
}

/// A solution on the curve.
#[derive(Debug, Clone)]
pub struct Point {
    /// The solution.
    pub solved: Solved,
    /// In what the curve is followed here.
    pub parameter: Parameter,
    /// The parameter's value.
    pub place: f64,
}

/// Where a curve ends.
#[derive(Debug)]
pub enum BranchEnd {
    /// At the speed efficiency to which it was to be followed.
    Whole,
    /// No solution was found beyond its last point.
    Lost(Failure),
}

/// Solutions in order: first towards more torque or less tension, until that makes the speed efficiency fall, then in
/// order of falling speed efficiency; where that turns, again towards more torque or less tension. Where the parameter
/// changes, a solution stands twice.
#[derive(Debug)]
pub struct Branch {
    /// The solutions, the operating point first.
    pub points: Vec<Point>,
    /// Why there are no more.
    pub end: BranchEnd,
    model: Model,
    question: Question,
    free: Constant,
    efficiency: Output,
    options: SolveOptions,
}

impl Point {
    /// What the drive does here.
    pub fn state(&self) -> State {
        State::of(&self.solved)
    }

    /// An output, and its rate along the curve: its derivative with respect to the parameter, in the direction in which
    /// the curve is followed.
    ///
    /// # Errors
    /// What the solver says if the equations are singular, as where the parameter turns.
    pub fn value_and_rate(&self, output: Output) -> Result<(f64, f64), SolveError> {
        let (ends, integrals) = inputs(&self.solved.solution);
        let (values, gradients) =
            self.solved.belt.output_gradients(&ends, &integrals, self.solved.solution.constants());
        let linearisation = Linearisation::new(&self.solved.belt, &self.solved.solution)?;
        let (index, direction) = match self.parameter {
            Parameter::Given(Constant::SlackTension) => (Constant::SlackTension.index(), -1.0),
            Parameter::Given(constant) => (constant.index(), 1.0),
            // Prescribed last.
            Parameter::SpeedEfficiency => {
                (Constant::ALL.len() + self.solved.belt.prescribed().len().saturating_sub(1), -1.0)
            }
        };
        let rates = linearisation.sensitivity(index).inputs();
        let rate = |gradient: &Vec<f64>| gradient.iter().zip(&rates).map(|(partial, rate)| partial * rate).sum::<f64>();
        let at = output.index();
        let value = values.get(at).copied().unwrap_or(f64::NAN);
        Ok((value, gradients.get(at).map_or(f64::NAN, |gradient| direction * rate(gradient))))
    }
}

impl Branch {
    /// Follows the curve of `case`, in which `free` (the primary's torque, or the slack tension) is given, from the case's
    /// operating point down to the speed efficiency `last`, 0 being the stall.
    ///
    /// # Errors
    /// [`DesignError::Start`] if the operating point has no solution.
    pub fn trace(case: &Resolved, free: Constant, last: f64, options: &SolveOptions) -> Result<Self, DesignError> {
        let efficiency = Output::all().find(|output| output.name() == "efficiency__speed");
        let Some(efficiency) = efficiency else { return Err(Failure::NoEquations.into()) };
        let solved = solve(case, options)?;
        let start = Point { parameter: Parameter::Given(free), place: solved.constant(free), solved };
        let mut branch = Self {
            points: vec![start],
            end: BranchEnd::Whole,
            model: case.model,
            question: Question::of(case),
            free,
            efficiency,
            options: *options,
        };
        branch.approach(last, 0)?;
        branch.descend(last);
        // Where the speed efficiency turns, torque or tension does not; it is followed in them until the efficiency tells
        // again.
        for _ in 0..MOST_TURNS {
            let (BranchEnd::Lost(_), Some(here)) = (&branch.end, branch.points.last()) else { break };
            let before = branch.points.len();
            let Ok(point) = branch.at(Parameter::Given(free), here.solved.constant(free), &here.solved) else { break };
            branch.points.push(point);
            branch.approach(last, LEAST_POINTS)?;
            if branch.points.len() == before + 1 {
                branch.points.pop();
                break;
            }
            branch.end = BranchEnd::Whole;
            branch.descend(last);
        }
        Ok(branch)
    }

    /// The solution at a value of a parameter, from one nearby.
    pub(super) fn at(&self, parameter: Parameter, place: f64, from: &Solved) -> Result<Point, Failure> {
        let question = match parameter {
            Parameter::Given(constant) => {
                let mut question = self.question.clone();
                question.constants[constant] = place;
                question
            }
            Parameter::SpeedEfficiency => self.question.clone().swap(self.free, self.efficiency, place),
        };
        let solved = solve_question_from(from, &self.model, &question, &self.options)?;
        Ok(Point { solved, parameter, place })
    }

    /// Towards more torque or less tension, by some points and until the speed efficiency tells how far the belt slips: a
    /// tighter belt sinks deeper, and that alone may change the speed more than slip does.
    fn approach(&mut self, last: f64, points: usize) -> Result<(), DesignError> {
        let parameter = Parameter::Given(self.free);
        let least = LEAST_STRIDE * self.points.first().map_or(0.0, |point| point.place.abs());
        let (least_points, most, mut factor) = (self.points.len() + points, self.points.len() + MOST_POINTS, FACTOR);
        while self.points.len() < most {
            let Some(here) = self.points.last() else { return Ok(()) };
            let (speed, rate) = here.value_and_rate(self.efficiency)?;
            let stride = here.place.abs().max(least);
            let tells = rate * stride <= -TELLING && self.points.len() >= least_points;
            if tells || speed <= last || factor < LEAST_FACTOR {
                break;
            }
            let next = match self.free {
                Constant::SlackTension => here.place - (1.0 - 1.0 / factor) * stride,
                _ => here.place + (factor - 1.0) * stride,
            };
            match self.at(parameter, next, &here.solved) {
                Ok(point) => self.points.push(point),
                Err(_) => factor = factor.sqrt(),
            }
        }
        Ok(())
    }

    fn descend(&mut self, last: f64) {
        let Some(here) = self.points.last() else { return };
        let speed = here.state().speed_efficiency;
        match self.at(Parameter::SpeedEfficiency, speed.max(last), &here.solved) {
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
            match self.at(Parameter::SpeedEfficiency, next, &here.solved) {
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
