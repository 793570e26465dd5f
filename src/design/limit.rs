//! The largest torque for a clamp, and the smallest clamp for a torque.
//!
//! Where the belt's temperature is to be found, a limit is that of a belt as warm as its losses at this very limit make
//! it: the curve is followed at one temperature, for a belt takes minutes to warm and slips at once.

use serde::{Serialize, Serializer};

use super::branch::{Branch, BranchEnd, BranchPoint, Parameter};
use super::error::DesignError;
use super::state::DriveState;
use crate::case::{Clamp, Key, Load, ModelChoices, Resolved, Speed};
use crate::drive::{Failure, Question, SolveOptions, Solved, solve};
use crate::losses::{at_temperature, into_belt};
use crate::model::{Constant, InternalError, Output};

/// Slack tension of the start over M_in/R_P: a belt as tight as this does not slip much.
const TIGHT: f64 = 0.5;
/// Factor on the slack tension of the start where the torque is not carried, and how often it is applied.
const TIGHTER: f64 = 2.0;
const TIGHTENED: usize = 4;
/// A fold counts if it differs from the end of the curve by this many times the tolerance.
const DISTINCT: f64 = 30.0;
/// Evaluations that locate an extremum, and the relative bracket at which it counts as located.
const LOCATING: usize = 30;
const LOCATED: f64 = 1e-9;

/// What a limit is.
#[derive(Debug, Clone, PartialEq)]
pub enum LimitKind {
    /// An extremum on the curve: beyond it, there is no solution near this one.
    Fold,
    /// The collapse of the speed ratio: the limit is reached where the secondary stands still.
    Collapse,
    /// The speed efficiency fell to the least that was asked for.
    SpeedEfficiency,
    /// The solution was lost for this reason: the limit lies beyond.
    Lost(String),
}

impl LimitKind {
    /// The word for a limit that was not reached.
    pub(super) const LOST: &str = "lost";

    /// In one word.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Fold => "fold",
            Self::Collapse => "collapse",
            Self::SpeedEfficiency => "speed_efficiency",
            Self::Lost(_) => Self::LOST,
        }
    }
}

impl Serialize for LimitKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for LimitKind {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "LimitKind".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "string", "enum": ["fold", "collapse", "speed_efficiency", "lost"] })
    }
}

/// A limit, and the drive there.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Limit {
    /// The limiting value, N or N·m.
    pub value: f64,
    /// What makes it a limit.
    pub kind: LimitKind,
    /// The drive there.
    pub state: DriveState,
    /// Temperature of the belt, K, if it was to be found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub belt_temperature: Option<f64>,
}

/// The smallest clamps, in the ways to give one.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ClampLimits {
    /// Tractive tension at the exit of the primary, N.
    pub slack_tension: Limit,
    /// Axial force on the primary, N.
    pub primary_axial_force: Limit,
    /// Axial force on the secondary, N.
    pub secondary_axial_force: Limit,
}

/// How limits are sought.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LimitOptions {
    /// For every solution on the path.
    pub solve: SolveOptions,
    /// Speed efficiency below which the drive counts as slipping; 0 follows it to the stall.
    pub least_speed_efficiency: f64,
}

/// Shares of the torque of the start that are tried in turn, where it has no solution.
const EASIER: [f64; 3] = [1.0, 0.3, 0.1];
/// Torque of the start in engine braking over tension times radius: the loose strand keeps the rest.
const BRAKING: f64 = 0.6;

/// The largest torque that the clamp of a case carries. Of the case's load only its direction matters: for a negative
/// primary torque it is the largest in engine braking.
///
/// # Errors
/// See [`DesignError`].
pub fn largest_torque(case: &Resolved, options: &LimitOptions) -> Result<(Limit, Branch), DesignError> {
    primary_speed(case)?;
    no_margin(case)?;
    in_balance(case, options, |case| torque_of(case, options))
}

pub(super) fn torque_of(case: &Resolved, options: &LimitOptions) -> Result<Found, DesignError> {
    let mut start = case.clone();
    // What the clamp suggests when nothing is known of the torque.
    start.operating_point.load = Load::SpeedRatio(1.0);
    let constants = Question::of(&start).constants;
    let easy = constants[Constant::PrimaryTorque];
    let (torque, driven) = match case.operating_point.load {
        Load::PrimaryTorque(torque) if torque > 0.0 => (torque.min(easy), true),
        Load::PrimaryTorque(torque) if torque < 0.0 => {
            let most = BRAKING * constants[Constant::SlackTension] * constants[Constant::PrimaryRadius];
            (torque.max(-most), false)
        }
        _ => (easy, true),
    };
    let mut first = None;
    for share in EASIER {
        start.operating_point.load = Load::PrimaryTorque(share * torque);
        match solve(&start, &options.solve) {
            Ok(solved) => {
                return limit(&start.model, &solved, (Constant::PrimaryTorque, Output::PrimaryTorque), driven, options);
            }
            Err(failure @ (Failure::Lost { .. } | Failure::Unreached { .. } | Failure::Start { .. })) => {
                _ = first.get_or_insert(failure);
            }
            Err(failure) => return Err(failure.into()),
        }
    }
    Err(first.unwrap_or(Failure::NoStart).into())
}

/// The smallest slack tension that carries the torque of a case; the case's clamp does not matter.
///
/// # Errors
/// See [`DesignError`].
pub fn smallest_slack_tension(case: &Resolved, options: &LimitOptions) -> Result<(Limit, Branch), DesignError> {
    primary_speed(case)?;
    let case = without_margin(case);
    in_balance(&case, options, |case| tension_of(case, options))
}

pub(super) fn tension_of(case: &Resolved, options: &LimitOptions) -> Result<Found, DesignError> {
    let (_, solved) = clamped(case, &options.solve)?;
    limit(&case.model, &solved, (Constant::SlackTension, Output::PrimaryExitTension), false, options)
}

/// The smallest clamps that carry the torque of a case; the case's clamp does not matter.
///
/// # Errors
/// See [`DesignError`].
pub fn smallest_clamps(case: &Resolved, options: &LimitOptions) -> Result<(ClampLimits, Branch), DesignError> {
    primary_speed(case)?;
    let case = without_margin(case);
    // At one temperature the start of all three curves is the same.
    let start = match case.thermal {
        None => Some(clamped(&case, &options.solve)?.1),
        Some(_) => None,
    };
    let smallest = |output| {
        in_balance(&case, options, |case| match &start {
            Some(start) => limit(&case.model, start, (Constant::SlackTension, output), false, options),
            None => {
                let (_, start) = clamped(case, &options.solve)?;
                limit(&case.model, &start, (Constant::SlackTension, output), false, options)
            }
        })
    };
    let (slack_tension, branch) = smallest(Output::PrimaryExitTension)?;
    let (primary_axial_force, _) = smallest(Output::PrimaryAxialForce)?;
    let (secondary_axial_force, _) = smallest(Output::SecondaryAxialForce)?;
    Ok((ClampLimits { slack_tension, primary_axial_force, secondary_axial_force }, branch))
}

/// A limit, the solution there and the curve on which it lies.
pub(super) struct Found {
    pub(super) limit: Limit,
    pub(super) solved: Solved,
    branch: Branch,
    /// What has its extremum, or its last value, at the limit.
    output: Output,
}

/// What is left of a curve in engine braking is judged by its last stretch from this multiple of the last speed
/// efficiency on.
const LAST_STRETCH: f64 = 1.5;

impl Found {
    /// Share by which the value would change on the rest of the curve, where it was left before the driven pulley stood
    /// still and goes on as on its last stretch. None if that is not known.
    pub(super) fn change_to_rest(&self) -> Option<f64> {
        if self.limit.kind == LimitKind::Fold {
            return Some(0.0);
        }
        let last = self.branch.points.last()?;
        if last.place == 0.0 {
            return Some(0.0);
        }
        let before = self.branch.points.iter().rev().find(|point| point.place >= LAST_STRETCH * last.place)?;
        let change = before.value(self.output).ok()? / last.value(self.output).ok()? - 1.0;
        Some(change.abs() * last.place / (before.place - last.place))
    }
}

/// Temperatures at most that are tried for the balance of a limit's heat, and how far the last may be from it, K.
const ROUNDS: usize = 20;
const BALANCED: f64 = 1e-3;
/// Largest change of temperature from one to the next, K.
const LARGEST_STEP: f64 = 40.0;

/// Finds a limit; where the belt's temperature is to be found, that at which the heat at the limit is in balance, by
/// the secant method.
fn in_balance(
    case: &Resolved,
    options: &LimitOptions,
    find: impl Fn(&Resolved) -> Result<Found, DesignError>,
) -> Result<(Limit, Branch), DesignError> {
    let Some(thermal) = &case.thermal else {
        return find(case).map(|found| (found.limit, found.branch));
    };
    let mut temperature = thermal.reference;
    let mut before: Option<(f64, f64)> = None;
    for _ in 0..ROUNDS {
        let found = find(&at_temperature(case, thermal, temperature))?;
        let heat = into_belt(case, thermal, &found.solved, temperature, options.solve.tolerance)?;
        let missing = thermal.ambient + heat / thermal.heat_transfer - temperature;
        if missing.abs() <= BALANCED {
            return Ok((Limit { belt_temperature: Some(temperature), ..found.limit }, found.branch));
        }
        let step = match before {
            Some((other, there)) if there != missing => missing * (temperature - other) / (there - missing),
            // As if the heat did not depend on the temperature.
            _ => missing,
        };
        before = Some((temperature, missing));
        temperature += step.clamp(-LARGEST_STEP, LARGEST_STEP);
        if !temperature.is_finite() || temperature <= 0.0 {
            break;
        }
    }
    Err(Failure::Temperature { temperature }.into())
}

/// The case with a slack tension at which its torque is carried, and the drive there. If it is carried at none that is
/// tried, the failure at the first is told: the case's own clamp, where that is tight enough to begin with.
pub(super) fn clamped(case: &Resolved, options: &SolveOptions) -> Result<(Resolved, Solved), DesignError> {
    let point = &case.operating_point;
    if let Load::SpeedRatio(_) | Load::SecondarySpeed(_) = point.load {
        let (key, _) = point.load.setting();
        return Err(DesignError::Given { key, expected: "the clamp for a torque needs a torque in its place" });
    }
    if point.fourth.is_some() {
        let expected = "the clamp cannot be sought while both radii are";
        return Err(DesignError::Given { key: Key::Free, expected });
    }
    let guess = Question::of(case).constants;
    // Where the secondary drives, the strand that leaves the primary is the tight one.
    let pull = guess[Constant::PrimaryTorque] / guess[Constant::PrimaryRadius];
    let least = TIGHT * pull.abs() + (-pull).max(0.0);
    let mut start = case.clone();
    let mut tension = guess[Constant::SlackTension].max(least);
    let mut first = None;
    for _ in 0..=TIGHTENED {
        start.operating_point.clamp = Clamp::SlackTension(tension);
        match solve(&start, options) {
            Ok(solved) => return Ok((start, solved)),
            // The case's own clamp may be below the limit that is sought.
            Err(failure @ (Failure::Lost { .. } | Failure::Unreached { .. } | Failure::Start { .. })) => {
                _ = first.get_or_insert(failure);
            }
            Err(failure) => return Err(failure.into()),
        }
        tension *= TIGHTER;
    }
    Err(first.unwrap_or(Failure::NoStart).into())
}

/// The case without a margin against slip in the place of its clamp, where the clamp is what is sought.
pub(super) fn without_margin(case: &Resolved) -> Resolved {
    let mut case = case.clone();
    case.operating_point.margin = None;
    case
}

/// The largest torque of a margin is that at which there is none left.
fn no_margin(case: &Resolved) -> Result<(), DesignError> {
    match case.operating_point.margin {
        None => Ok(()),
        Some(margin) => {
            let expected =
                "the largest torque is sought for a clamp; expected a tension or an axial force in its place";
            Err(DesignError::Given { key: margin.setting().0, expected })
        }
    }
}

/// A secondary that stands still has no speed to be given.
fn primary_speed(case: &Resolved) -> Result<(), DesignError> {
    match case.operating_point.speed {
        Speed::Primary(_) => Ok(()),
        Speed::Secondary(_) => Err(DesignError::Given {
            key: Key::SecondarySpeed,
            expected: "a limit is sought down to the stall of the secondary, at a given \
                `operating_point.primary_speed`",
        }),
    }
}

/// The largest (`upwards`) or smallest value of an output on the curve on which `free` moves: at its first extremum,
/// else at the curve's end.
fn limit(
    model: &ModelChoices,
    start: &Solved,
    (free, output): (Constant, Output),
    upwards: bool,
    options: &LimitOptions,
) -> Result<Found, DesignError> {
    let least = options.least_speed_efficiency;
    let branch = Branch::trace(model, start, (free, output), upwards, least, &options.solve)?;
    if let Some(state) = branch.points.first().map(|first| first.state).filter(|state| state.speed_efficiency < least) {
        return Err(DesignError::Beyond {
            asked: least,
            had: state.speed_efficiency,
            torque: state.primary_torque,
            slack_tension: state.slack_tension,
        });
    }
    let kind = match &branch.end {
        BranchEnd::Lost(Failure::Cancelled) => return Err(Failure::Cancelled.into()),
        BranchEnd::Lost(failure) => LimitKind::Lost(failure.to_string()),
        BranchEnd::Whole if least > 0.0 => LimitKind::SpeedEfficiency,
        BranchEnd::Whole => LimitKind::Collapse,
    };
    let Some(last) = branch.points.last() else { return Err(Failure::NoEquations.into()) };
    let end = last.value(output)?;
    // Near the stall curves are flat: a fold there is told from the end by more than the solutions' accuracy.
    let least = DISTINCT * options.solve.tolerance * end.abs();
    let is_distinct = |value: f64| matches!(kind, LimitKind::Lost(_)) || (value - end).abs() > least;
    let mut folds: Vec<BranchPoint> = branch.points.iter().filter(|point| point.is_extremum).cloned().collect();
    folds.extend(extrema(&branch, output, if upwards { 1.0 } else { -1.0 })?);
    let folds = folds.iter().map(|fold| Ok((fold, fold.value(output)?))).collect::<Result<Vec<_>, InternalError>>()?;
    let (value, kind, point) = match folds.into_iter().find(|(_, value)| is_distinct(*value)) {
        Some((fold, value)) => (value, LimitKind::Fold, fold),
        None => (end, kind, last),
    };
    let limit = Limit { value, kind, state: point.state, belt_temperature: None };
    let solved = point.solved.clone();
    Ok(Found { limit, solved, branch, output })
}

/// The extrema of an output where the speed efficiency is prescribed: maxima for `sign` 1, minima for −1.
fn extrema(branch: &Branch, output: Output, sign: f64) -> Result<Vec<BranchPoint>, DesignError> {
    let rate = |point: &BranchPoint| point.value_and_rate(output).map(|(_, rate)| sign * rate);
    let mut extrema = Vec::new();
    let mut before: Option<(&BranchPoint, f64)> = None;
    for point in branch.points.iter().filter(|point| point.parameter == Parameter::SpeedEfficiency) {
        let here = rate(point)?;
        if let Some((last, earlier)) = before.filter(|(_, earlier)| *earlier > 0.0 && here <= 0.0) {
            extrema.push(located(branch, (last, earlier), (point, here), &rate)?);
        }
        before = Some((point, here));
    }
    Ok(extrema)
}

/// Where the rate is zero between two points: regula falsi, the Illinois variant (M. Dowell and P. Jarratt, BIT 11,
/// 1971).
fn located(
    branch: &Branch,
    first: (&BranchPoint, f64),
    second: (&BranchPoint, f64),
    rate: &dyn Fn(&BranchPoint) -> Result<f64, DesignError>,
) -> Result<BranchPoint, DesignError> {
    let (mut a, mut b) = ((first.0.clone(), first.1), (second.0.clone(), second.1));
    for _ in 0..LOCATING {
        let (s, t) = (a.0.place, b.0.place);
        if (s - t).abs() <= LOCATED * s.abs().max(t.abs()) || b.1 == 0.0 {
            break;
        }
        let middle = (s * b.1 - t * a.1) / (b.1 - a.1);
        // From the side that has a solution nearby; without one, the bracket is as narrow as it will be.
        let near = branch.at(middle, &b.0.solved);
        let Ok(point) = near.or_else(|_| branch.at(middle, &a.0.solved)) else { break };
        let here = rate(&point)?;
        if (here > 0.0) == (b.1 > 0.0) {
            a.1 *= 0.5;
        } else {
            a = b;
        }
        b = (point, here);
    }
    Ok(b.0)
}
