//! Tracing a branch of solutions through folds, in one constant, by pseudo-arclength; folds and events are located.

use super::branch::{Branch, BranchError, BranchOptions, BranchPoint, EventFunction, Side};
use super::checkpoint::Checkpoint;
use super::tracer::Tracer;
use crate::budget::Budget;
use crate::guess::Guess;
use crate::observer::{Observer, Silent};
use crate::problem::Problem;

/// Solves at the start's value of the constant `parameter` and traces the branch from there.
///
/// To go on in another constant from any point but a fold, call this again with [`Guess::from`] its solution. At a fold
/// the solution is a double one for the constants that it has: go on from a point beside it.
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

/// Traces the branch that crosses another at a simple branch point, to both sides of it. The points begin with the
/// branch point.
///
/// The first step leaves at right angles to the branch that the point was found on, in the plane of both, so that
/// `first_step` must be large enough for the two branches to be apart, and small enough for a straight line to be near
/// the branch. The first point's `rate` is that of this direction.
///
/// ```
/// use solver::bvp::Bvp;
/// use solver::continuation::{BranchOptions, trace, trace_crossing};
///
/// // Euler's strut: θ'' = -λ sin θ, θ'(0) = θ'(1) = 0. The straight one buckles at λ = π².
/// let strut = Bvp::new(
///     &["angle", "curvature"],
///     (0.0, 1.0),
///     |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].sin()),
///     |a, b, _, g| (g[0], g[1]) = (a[1], b[1]),
/// )
/// .given("load", 5.0);
/// let options = BranchOptions { range: (5.0, 15.0), max_points: 60, ..BranchOptions::default() };
/// let straight = trace(&strut, &strut.start(), 0, &[], &options, &[])?;
/// let buckling = straight.branch_points().next().ok_or("no branch point")?;
/// assert!((buckling.parameter - std::f64::consts::PI.powi(2)).abs() < 1e-3);
/// let [left, right] = trace_crossing(&strut, buckling, 0, &[], &options, &[])?;
/// let ends = [left, right].map(|half| half.points.last().map(|point| point.solution.regions()[0].eval(0.0)[0]));
/// let [Some(left), Some(right)] = ends else { return Err("no points".into()) };
/// assert!(left.abs() > 1.0 && (left + right).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`trace`], of the side that is lost first: each side alone is had from [`trace_crossing_observed`]. The cause is
/// [`SolveError::Option`](crate::SolveError::Option) if the point is no branch point.
pub fn trace_crossing<P: Problem + ?Sized>(
    problem: &P,
    at: &BranchPoint,
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
) -> Result<[Branch; 2], BranchError> {
    let budget = Budget::new(&options.solve);
    let traced = |side| side_within(&problem, (at, side), parameter, unknowns, options, events, &mut Silent, &budget);
    Ok([traced(Side::First)?, traced(Side::Second)?])
}

/// One side of the branch that [`trace_crossing`] traces, watched by an observer that may cancel it.
///
/// # Errors
/// As [`trace_crossing`].
pub fn trace_crossing_observed<P: Problem + ?Sized>(
    problem: &P,
    (at, side): (&BranchPoint, Side),
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
    observer: &mut dyn Observer,
) -> Result<Branch, BranchError> {
    side_within(&problem, (at, side), parameter, unknowns, options, events, observer, &Budget::new(&options.solve))
}

fn side_within(
    problem: &dyn Problem,
    (at, side): (&BranchPoint, Side),
    parameter: usize,
    unknowns: &[usize],
    options: &BranchOptions,
    events: &[EventFunction<'_>],
    observer: &mut dyn Observer,
    budget: &Budget,
) -> Result<Branch, BranchError> {
    Tracer::new(problem, parameter, unknowns, options, events, observer, budget)
        .run(|tracer| Ok((tracer.crossing(at, side)?, 0.0, options.first_step)))
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
