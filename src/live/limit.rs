//! What stands between a case and a solution, by name.

use serde_json::{Value, json};

use super::follow::Lost;
use super::keys::shown;
use crate::case::{Key, Resolved};
use crate::design::{self, DesignError, Limit, LimitOptions};
use crate::drive::SolveOptions;
use crate::result::{FailureKind, FailureReport, Light, Outcome};

/// What a limit is, as a sentence.
fn words(kind: &design::LimitKind) -> &'static str {
    match kind {
        design::LimitKind::Fold => "Beyond this limit there is no steady state near it.",
        design::LimitKind::Collapse => "At this limit the belt slips until the secondary stands still.",
        design::LimitKind::SpeedEfficiency => "At this limit the speed efficiency falls below what was asked for.",
        design::LimitKind::Lost(_) => "Beyond it, no solution was found.",
    }
}

fn object(limit: &Limit) -> Value {
    json!({ "value": limit.value, "kind": limit.kind, "words": words(&limit.kind) })
}

fn options(solve: &SolveOptions) -> LimitOptions {
    LimitOptions { solve: *solve, ..LimitOptions::default() }
}

fn none(error: &DesignError) -> Value {
    let kind = if error.is_bad_input() { FailureKind::Input } else { FailureKind::NoSolution };
    json!({ "failure": FailureReport { kind, message: error.to_string(), hint: None } })
}

/// The largest torque of a case's clamp, N·m.
pub(super) fn largest_torque(case: &Resolved, solve: &SolveOptions) -> Value {
    match design::largest_torque(case, &options(solve)) {
        Ok((limit, _)) => json!({ "torque": object(&limit) }),
        Err(error) => none(&error),
    }
}

/// The smallest clamps of a case's torque, N.
pub(super) fn smallest_clamps(case: &Resolved, solve: &SolveOptions) -> Value {
    match design::smallest_clamps(case, &options(solve)) {
        Ok((limits, _)) => json!({
            Key::SlackTension.path(): object(&limits.slack_tension),
            Key::PrimaryAxialForce.path(): object(&limits.primary_axial_force),
            Key::SecondaryAxialForce.path(): object(&limits.secondary_axial_force),
        }),
        Err(error) => none(&error),
    }
}

/// Why there is no solution: where the way ended that was followed to the case, and what the belt does there.
pub(super) fn named(lost: &Lost, changed: Option<&str>, last: Option<&Outcome>) -> FailureReport {
    match lost {
        Lost::Failure(failure) => {
            let kind = if failure.is_bad_input() { FailureKind::Input } else { FailureKind::NoSolution };
            FailureReport { kind, message: failure.to_string(), hint: failure.hint().map(str::to_owned) }
        }
        Lost::Ended(_) => {
            let end = last.and_then(|last| Some(where_it_ended(Key::from_path(changed?)?, last)));
            let state = match last.map(|last| Light::of(last.result.slip_reserve)) {
                Some(Light::Red) => "the belt slips",
                Some(Light::Amber | Light::Green) | None => "the solution is lost",
            };
            let message = end.map_or_else(|| format!("{state} on the way"), |end| format!("{state} beyond {end}"));
            let hint = last.map(|_| "what is drawn is the last solution on the way there".to_owned());
            FailureReport { kind: FailureKind::NoSolution, message, hint }
        }
    }
}

/// A key with its value in the last solution.
fn where_it_ended(key: Key, last: &Outcome) -> String {
    let values = super::values::asked(&last.result.inputs, Some(&last.result));
    match (values.get(key.path()), shown(key)) {
        (Some(value), Some(shown)) => {
            let value = format!("{value:.4}");
            let value = value.trim_end_matches('0').trim_end_matches('.');
            format!("{} = {value} {}", key.entry().name().replace('_', " "), shown.printed()).trim_end().to_owned()
        }
        _ => key.path().to_owned(),
    }
}
