//! The clamp that leaves a given margin against slip.

use super::compute::Reading;
use super::{Outcome, read_at, warmed};
use crate::case::{Clamp, Key, Margin, Resolved};
use crate::clock::Stopwatch;
use crate::drive::{Failure, Question, SolveOptions, Solved, solve, solve_along};
use crate::losses::{Heat, warm_start};
use crate::model::{Constant, InternalError};

/// Slack tension of the start over M/R_P: a belt as tight as this does not slip much.
const TIGHT: f64 = 0.5;
/// Factor on the slack tension of the start where the torque is not carried, and how often it is applied.
const TIGHTER: f64 = 2.0;
const TIGHTENED: usize = 5;
/// Solutions at most after the first.
const SOLUTIONS: usize = 40;
/// Largest factor between the slack tensions of two of them.
const STRIDE: f64 = 4.0;
/// The utilization is read from the solution's samples: it is not met more accurately than that.
const FINEST: f64 = 1e-9;

/// Share of the friction at hand that the busier pulley uses.
///
/// # Errors
/// None, unless this program is broken.
pub fn utilization(solved: &Solved) -> Result<f64, InternalError> {
    let reading = Reading::new(solved)?;
    Ok(reading.primary()?.friction_utilization.max(reading.secondary()?.friction_utilization))
}

/// Solves a case whose clamp is found for a margin: the slack tension at which it holds, by the secant method. The
/// reciprocal of the utilization is nearly linear in the slack tension, for the pressure is.
///
/// # Errors
/// [`Failure::Margin`] if no clamp that was tried leaves that margin, with the nearest; else see [`Failure`].
pub fn run(case: &Resolved, margin: Margin, options: &SolveOptions) -> Result<Outcome, Failure> {
    let start = Stopwatch::start();
    let target = margin.utilization();
    let mut inner = case.clone();
    inner.operating_point.margin = None;
    let first = carried(&mut inner, options)?;
    let (mut near, mut heat) = warmed(&inner, options, (first, case.stiffnesses.reference))?;
    let mut here = near.constant(Constant::SlackTension);
    let mut used = utilization(&near)?;
    // The tightest belt that uses more than is wanted, and the loosest that uses less.
    let (mut loose, mut tight) = (0.0_f64, f64::INFINITY);
    let mut before: Option<(f64, f64)> = None;
    for _ in 0..SOLUTIONS {
        if (used - target).abs() <= options.tolerance.max(FINEST) * target {
            let mut outcome = read_at(&inner, options, (near, heat.into()), start)?;
            outcome.result.inputs = case.clone();
            outcome.result.add_found(Key::SlackTension, here);
            return Ok(outcome);
        }
        if used > target {
            loose = loose.max(here)
        } else {
            tight = tight.min(here)
        }
        let next = next(here, used, before, target).clamp(here / STRIDE, here * STRIDE);
        let next = if next > loose && next < tight { next } else { 0.5 * (loose + tight.min(here * STRIDE)) };
        inner.operating_point.clamp = Clamp::SlackTension(next);
        match at(&inner, &near, heat.as_ref(), options) {
            Ok((solved, warm)) => {
                before = Some((here, used));
                (here, used, near, heat) = (next, utilization(&solved)?, solved, warm);
            }
            Err(Failure::Cancelled) => return Err(Failure::Cancelled),
            // Beyond what has a solution: half the way.
            Err(failure) if (next - here).abs() <= 1e-6 * here => {
                return Err(Failure::margin(target, used, here, failure));
            }
            Err(_) if next < here => loose = loose.max(next),
            Err(_) => tight = tight.min(next),
        }
    }
    Err(Failure::margin(target, used, here, Failure::NoStart))
}

/// A solution of the case from one nearby, the belt as warm as it becomes.
fn at(
    case: &Resolved,
    near: &Solved,
    heat: Option<&Heat>,
    options: &SolveOptions,
) -> Result<(Solved, Option<Heat>), Failure> {
    let (warm, temperature) = warm_start(case, heat);
    let solved = solve_along(&[near], &warm, options).or_else(|_| solve(&warm, options))?;
    warmed(case, options, (solved, temperature))
}

/// The next slack tension, from two solutions or one.
fn next(here: f64, used: f64, before: Option<(f64, f64)>, target: f64) -> f64 {
    let rate = match before {
        Some((there, other)) if other != used && there != here => (1.0 / used - 1.0 / other) / (here - there),
        // As if no tension were centrifugal, and none carried torque.
        _ => 1.0 / (used * here),
    };
    here + (1.0 / target - 1.0 / used) / rate
}

/// A solution of the case, tighter than it asks if need be.
fn carried(case: &mut Resolved, options: &SolveOptions) -> Result<Solved, Failure> {
    let guess = Question::of(case).constants;
    let least = TIGHT * guess[Constant::PrimaryTorque].abs() / guess[Constant::PrimaryRadius];
    let mut tension = guess[Constant::SlackTension].max(least);
    let mut first = None;
    for _ in 0..=TIGHTENED {
        case.operating_point.clamp = Clamp::SlackTension(tension);
        match solve(case, options) {
            Ok(solved) => return Ok(solved),
            Err(failure) if failure.is_bad_input() || failure.is_cancelled() => return Err(failure),
            Err(failure) => _ = first.get_or_insert(failure),
        }
        tension *= TIGHTER;
    }
    Err(first.unwrap_or(Failure::NoStart))
}
