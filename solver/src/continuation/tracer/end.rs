//! The end of the range.
//!
//! The parameter is there what the range says, to the last digit: the equations may have no meaning beyond. The last
//! point is therefore solved for with the parameter given, from what the branch says of it beside the end.

use super::Tracer;
use crate::collocation::plan::Plan;
use crate::continuation::arclength::{Reference, constant_squares};
use crate::error::SolveError;
use crate::guess::Guess;
use crate::run::Run;
use crate::solution::Solution;
use crate::start;

/// A point that has been located at the end moves by no more than this part of the step to be exactly there.
const MOVED: f64 = 1e-3;

impl Tracer<'_, '_> {
    /// The end of the range that a value of the parameter is beyond.
    pub(super) fn end_before(&self, value: f64) -> Option<f64> {
        let (low, high) = self.options.range;
        if value < low { Some(low) } else { (value > high).then_some(high) }
    }

    /// A point that has been located at an end of the range, exactly there.
    pub(super) fn exactly_at_end(&mut self, found: &Reference, end: f64, step: f64) -> Result<Reference, SolveError> {
        if found.value(self.parameter) == end {
            return Ok(found.clone());
        }
        if let Some(exact) = self.solved_at_end(found, end, MOVED * step)? {
            return Ok(exact);
        }
        // Where the branch folds at the end, the parameter does not determine the solution.
        self.told_at(found, end)
    }

    /// The point at the end of the range where a step fails, if the branch would go on to beyond that end: what the
    /// equations are there may not be defined. None if there is no solution at the end, or one that is farther from
    /// what the tangent says than the step is long.
    pub(super) fn reached_end(&mut self, here: &Reference, step: f64) -> Result<Option<Reference>, SolveError> {
        let predicted = here.value(self.parameter) + step * here.direction.constants[self.parameter];
        match self.end_before(predicted) {
            Some(end) if !here.is_crossing => self.solved_at_end(here, end, step),
            _ => Ok(None),
        }
    }

    /// The solution with the parameter at an end of the range, predicted along the tangent at a point; none if there is
    /// none within reach of that.
    fn solved_at_end(&mut self, from: &Reference, end: f64, reach: f64) -> Result<Option<Reference>, SolveError> {
        let distance = (end - from.value(self.parameter)) / from.direction.constants[self.parameter];
        let by = if distance.abs() <= reach { distance } else { 0.0 };
        let mut guess = from.moved(by);
        guess.constants[self.parameter] = end;
        let plan = Plan::new(self.problem.layout(), self.unknowns);
        let mut run = Run::new(self.problem, plan, &self.path_options, self.observer, self.budget);
        (run.coarsen, run.needs_determined) = (false, false);
        let start = start::near(&from.solution, &from.inner, &guess);
        let outcome = run.refine(start).and_then(|solved| run.finish(&solved));
        let contraction = run.contraction;
        let stats = run.stats;
        drop(run);
        self.stats += stats;
        match outcome {
            Err(cause) if cause.is_interruption() => Err(cause),
            Err(_) => Ok(None),
            Ok(solution) => {
                let is_near = contraction <= self.options.largest_contraction && self.miss(&solution, &guess) <= reach;
                let direction = from.direction.clone();
                Ok(is_near.then(|| Reference::new(solution, direction, from.determinant)))
            }
        }
    }

    /// A point as it stands, but for its parameter.
    fn told_at(&mut self, point: &Reference, value: f64) -> Result<Reference, SolveError> {
        let mut guess = Guess::from(&point.solution);
        guess.constants[self.parameter] = value;
        self.as_it_stands(point, &guess)
    }

    /// The largest difference between a solution and what was expected, relative to the size of what differs.
    fn miss(&self, solution: &Solution, expected: &Guess) -> f64 {
        let layout = self.problem.layout();
        let squares = constant_squares(layout, solution);
        let constants = solution.constants().iter().zip(&expected.constants).zip(squares);
        let mut largest = constants.map(|((a, b), square)| (a - b).abs() / square.sqrt()).fold(0.0, f64::max);
        let regions = solution.regions().iter().zip(&expected.regions).zip(&layout.regions);
        for ((found, expected), region) in regions {
            let found = found.eval_along(&expected.mesh);
            for ((found, expected), state) in found.iter().zip(&expected.states).zip(&region.states) {
                let size = found.iter().fold(state.scale.unwrap_or(1.0), |size, y| size.max(y.abs()));
                largest = found.iter().zip(expected).map(|(a, b)| (a - b).abs() / size).fold(largest, f64::max);
            }
        }
        largest
    }
}
