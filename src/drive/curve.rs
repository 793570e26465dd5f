//! The curve on which the solutions of a question lie when one of its given constants moves, followed through its
//! folds.

use std::cell::Cell;
use std::ops::ControlFlow;

use solver::continuation::{BranchOptions, BranchPoint, PointKind, trace_observed};
use solver::{Event, Observer, Options, Solution, SolveError, Stats};

use super::approach::{posed, start};
use super::budget::Budget;
use super::correct::relaxed;
use super::failure::Failure;
use super::options::SolveOptions;
use super::solved::Solved;
use crate::cancel::is_cancelled;
use crate::case::ModelChoices;
use crate::model::{Constant, Output};

/// Intervals at most: a curve that needs more is lost.
const MAX_INTERVALS: usize = 2000;
/// First contraction of Newton's iteration that steps aim at: kinks of the friction law upset it more than turns of the
/// curve.
const CONTRACTION: f64 = 0.5;
/// Largest step in arclength: an axial force may rise and fall again within two of these.
const LARGEST_STEP: f64 = 0.2;
/// Smallest step in arclength: where steps must be shorter, meshes are at their limit, and every step takes long.
const SMALLEST_STEP: f64 = 1e-3;
/// Points of the curve are this accurate; who needs a better one solves anew from there.
const TOLERANCE: f64 = 1e-4;
/// Newton iterations on each mesh of a step.
const MAX_ITERATIONS: usize = 25;
/// Points at most.
const MAX_POINTS: usize = 200;

/// Solutions in order of arclength.
#[derive(Debug)]
pub struct Curve {
    /// The solutions, the first being where the curve was entered; with what is special about each.
    pub points: Vec<(PointKind, Solved)>,
    /// Why there are no more, if its end was not reached.
    pub lost: Option<Failure>,
}

/// An output, and the value at which a curve ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct End {
    /// The output.
    pub output: Output,
    /// Its value there.
    pub value: f64,
    /// Whether it is reached from below, the output being less before; else from above.
    pub rising: bool,
}

/// Follows the curve through the solution `from` on which `free`, given there, moves: by pseudo-arclength, with
/// `output` as its parameter, at whose extrema there are points of the kind [`PointKind::Fold`]. It is left in the
/// direction in which the output rises (`upwards`) or falls, and followed to its `end`, a point of the kind
/// [`PointKind::Event`].
///
/// # Errors
/// [`Failure::NoEquations`]; a curve that is lost holds what was found of it.
pub fn trace(
    model: &ModelChoices,
    from: &Solved,
    (free, output): (Constant, Output),
    upwards: bool,
    end: End,
    options: &SolveOptions,
) -> Result<Curve, Failure> {
    let question = from.question.clone().swap(free, output, f64::NAN);
    let (belt, start) = (posed(model, &question)?, start(from, &question)?);
    // Targets of outputs stand before those of laws, and the new one is the last of them.
    let parameter = start.constants.len().saturating_sub(1 + question.closings.len());
    let unknowns: Vec<usize> = question.unknowns().into_iter().map(Constant::index).collect();
    let (over, broken) = (Cell::new(false), Cell::new(None));
    let sign = if end.rising { -1.0 } else { 1.0 };
    let excess = |solution: &Solution| {
        let value = belt.output_values(solution).and_then(|values| values.get(end.output));
        // A value that is missing ends the curve; the error is told below.
        let excess =
            value.map_err(|error| broken.set(Some(error))).map_or(f64::NAN, |value| sign * (value - end.value));
        over.set(over.get() || excess <= 0.0);
        excess
    };
    let mut budget = Budget::new(options.work_limit);
    let mut observer = |event: &Event| match event {
        Event::Step { .. } if over.get() => ControlFlow::Break(()),
        event => budget.notify(event),
    };
    let tolerance = options.tolerance.max(TOLERANCE);
    let solve = relaxed(&Options { max_intervals: MAX_INTERVALS, tolerance, ..options.solver() });
    let branch = BranchOptions {
        solve,
        upwards,
        contraction: CONTRACTION,
        // Friction has kinks.
        largest_contraction: f64::INFINITY,
        smallest_step: SMALLEST_STEP,
        largest_step: LARGEST_STEP,
        max_points: MAX_POINTS,
        max_iterations: MAX_ITERATIONS,
        branch_points: false,
        ..BranchOptions::default()
    };
    let traced = trace_observed(&belt, &start, parameter, &unknowns, &branch, &[&excess], &mut observer);
    if let Some(error) = broken.get() {
        return Err(error.into());
    }
    let (mut points, cause) = match traced {
        Ok(branch) => (branch.points, Box::new(SolveError::Steps { steps: MAX_POINTS })),
        Err(error) => (error.points, error.cause),
    };
    tracing::debug!("a curve of {} points was ended by the solver: {cause}", points.len());
    let ended = points.iter().position(|point| matches!(point.kind, PointKind::Event(_)));
    points.truncate(ended.map_or(points.len(), |at| at + 1));
    let last = points.last().map(|point| &point.solution);
    let lost = ended.is_none().then(|| match is_cancelled() {
        true => Failure::Cancelled,
        false => Failure::of(&belt, &from.question.constants, last, cause),
    });
    let solved = |point: BranchPoint| {
        let mut question = question.clone();
        question.swaps.iter_mut().next_back().into_iter().for_each(|swap| swap.value = point.parameter);
        let solved = Solved {
            question,
            belt: belt.clone(),
            solution: point.solution,
            stats: Stats::default(),
            continuation_steps: 0,
            route: None,
        };
        (point.kind, solved)
    };
    Ok(Curve { points: points.into_iter().map(solved).collect(), lost })
}
