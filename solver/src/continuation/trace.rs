//! Tracing a branch of solutions through folds, in one constant, by pseudo-arclength; folds and events are located.

use super::branch::{Branch, BranchError, BranchOptions, EventFunction};
use super::checkpoint::Checkpoint;
use super::tracer::Tracer;
use crate::budget::Budget;
use crate::guess::Guess;
use crate::observer::{Observer, Silent};
use crate::problem::Problem;

/// Solves at the start's value of the constant `parameter` and traces the branch from there.
///
/// To go on in another constant from any point, call this again with [`Guess::from`] its solution.
///
/// # Errors
/// [`BranchError`] holds the points up to where it was lost.
pub fn trace<P: Problem + ?Sized>(
    problem: &P,
    start: &Guess,
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
) -> Result<Branch, BranchError> {
    trace_observed(problem, start, parameter, unknowns, options, events, &mut Silent)
}

/// As [`trace`], watched by an observer that may cancel it.
///
/// # Errors
/// As [`trace`].
pub fn trace_observed<P: Problem + ?Sized>(
    problem: &P,
    start: &Guess,
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
    observer: &mut dyn Observer,
) -> Result<Branch, BranchError> {
    trace_within(&problem, start, parameter, unknowns, options, events, observer, &Budget::new(&options.solve))
}

/// As [`trace_observed`], as a part of a larger computation with a budget of its own.
pub(super) fn trace_within(
    problem: &dyn Problem,
    start: &Guess,
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
    observer: &mut dyn Observer,
    budget: &Budget,
) -> Result<Branch, BranchError> {
    Tracer::new(problem, parameter, unknowns, options, events, observer, budget)
        .run(|tracer| Ok((tracer.first(start)?, 0.0, options.first_step)))
}

/// Goes on from a checkpoint of an earlier tracing of the same branch, at folds too. The points begin with the
/// checkpoint's.
///
/// # Errors
/// As [`trace`].
pub fn resume_trace<P: Problem + ?Sized>(
    problem: &P,
    from: &Checkpoint,
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
    observer: &mut dyn Observer,
) -> Result<Branch, BranchError> {
    Tracer::new(&problem, parameter, unknowns, options, events, observer, &Budget::new(&options.solve))
        .run(|tracer| Ok((tracer.resumed(from)?, from.position, from.step)))
}
