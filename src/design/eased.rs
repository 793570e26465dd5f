//! Limits where friction is too steep for a curve to be followed: found at larger slip thresholds, and followed to the
//! case's from there.
//!
//! Where a pulley slips as a whole, its friction is μ_k everywhere, whatever the slip threshold is; that is why limits
//! hardly depend on it, while solutions at small ones are hard to come by.

use super::error::DesignError;
use super::limit::{Found, Limit, LimitKind, LimitOptions, tension_of, torque_of};
use super::state::DriveState;
use crate::case::Resolved;
use crate::drive::{Constant, Output, Question, Solved, approach_question};

/// Slip threshold over the belt's speed R_P ω_P from which on limits are sought: solutions are easily found there, and
/// limits of the survey change by a share of 1e-4 at most from there on.
const EASY: f64 = 1e-3;
/// The same for a belt without bending stiffness: near that of the start, for every curve below is seldom found whole.
/// In engine braking five limits of six change by a share of 1e-3 at most from there on.
const EASY_STRING: f64 = 0.04;
/// Share of the limit by which a case may lie within it at a larger slip threshold, for it to be sought at smaller
/// ones.
const NEAR: f64 = 0.05;
/// What is added to the share by which a case must lie beyond its limit, for every decade of the slip threshold that
/// the limit was not followed, over the share by which it changed on the decade before.
const UNFOLLOWED: f64 = 10.0;

/// Of what a limit is sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sought {
    /// The smallest slack tension.
    Tension,
    /// The largest torque.
    Torque,
}

impl Sought {
    pub(super) fn find(self, case: &Resolved, options: &LimitOptions) -> Result<Found, DesignError> {
        match self {
            Self::Tension => tension_of(case, options),
            Self::Torque => torque_of(case, options),
        }
    }

    /// The constant that is found at the limit, and the output that has its value there.
    const fn of(self) -> (Constant, Output) {
        match self {
            Self::Tension => (Constant::SlackTension, Output::PrimaryExitTension),
            Self::Torque => (Constant::PrimaryTorque, Output::PrimaryTorque),
        }
    }

    /// The share by which the value given lies beyond the limit; negative within.
    pub(super) fn beyond(self, given: f64, limit: f64) -> f64 {
        match self {
            Self::Tension => limit / given - 1.0,
            Self::Torque => (given / limit).abs() - 1.0,
        }
    }
}

/// How far a limit was followed in the slip threshold, where that is not to the case's.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Easing {
    /// The smallest slip threshold to which it was followed, m/s.
    pub slip_threshold: f64,
    /// Share by which the limit changed on the last part of the way, a decade or less.
    pub change: f64,
    /// Decades from there to the case's slip threshold.
    pub decades: f64,
}

impl Easing {
    /// What is added to the share by which a case must lie beyond the limit.
    pub(super) const fn margin(&self) -> f64 {
        UNFOLLOWED * self.change * self.decades.max(1.0)
    }
}

/// A limit, and the solution there.
struct Place {
    limit: Limit,
    solved: Solved,
}

/// A case at a slip threshold at which it is solved if it has a solution, or its own if that is larger.
pub(super) fn easy(case: &Resolved) -> Resolved {
    let constants = Question::of(case).constants;
    let share = if case.model.bending.is_some() { EASY } else { EASY_STRING };
    let easy = share * constants[Constant::PrimaryRadius] * constants[Constant::PrimarySpeed];
    let mut easier = case.clone();
    easier.sheave.slip_threshold = easy.max(case.sheave.slip_threshold);
    easier
}

/// A limit, followed from large slip thresholds as near to the case's as possible; nothing if none was found, if the
/// case lies clearly within, or if it is not known how the limit depends on the slip threshold.
pub(super) fn followed(
    case: &Resolved,
    sought: Sought,
    given: f64,
    options: &LimitOptions,
) -> Option<(Limit, Option<Easing>)> {
    let (own, easy) = (case.sheave.slip_threshold, easy(case).sheave.slip_threshold);
    let parts = libm::log10(easy / own).ceil();
    let at = |part: f64| if part == 0.0 { own } else { own * libm::pow(easy / own, part / parts) };
    let (mut last, mut easing) = (None::<Place>, None::<Easing>);
    for part in (0..=parts as u32).rev().map(f64::from) {
        let threshold = at(part);
        let mut easier = case.clone();
        easier.sheave.slip_threshold = threshold;
        let moved = last.as_ref().and_then(|last| last.moved(&easier, sought, options));
        // At a beam's own slip threshold it was sought before.
        let is_new = part > 0.0 || case.model.bending.is_none();
        let found = || if is_new { Place::found(&easier, sought, options) } else { None };
        let Some(here) = moved.or_else(found) else {
            if last.is_some() {
                break;
            }
            continue;
        };
        if sought.beyond(given, here.limit.value) < -NEAR {
            return None;
        }
        easing = last.map(|last| Easing {
            slip_threshold: threshold,
            change: (last.limit.value / here.limit.value - 1.0).abs(),
            decades: libm::log10(threshold / own),
        });
        last = Some(here);
        if threshold == own {
            return last.map(|place| (place.limit, None));
        }
    }
    Some((last?.limit, Some(easing?)))
}

impl Place {
    /// A limit, followed from an easier load at the slip threshold of a case.
    fn found(case: &Resolved, sought: Sought, options: &LimitOptions) -> Option<Self> {
        let Found { limit, solved, .. } = sought.find(case, options).ok()?;
        matches!(limit.kind, LimitKind::Fold | LimitKind::Collapse).then_some(Self { limit, solved })
    }

    /// The limit at the slip threshold of another case, where it is that of a driven pulley at rest: the drive there at
    /// the same speed efficiency.
    fn moved(&self, case: &Resolved, sought: Sought, options: &LimitOptions) -> Option<Self> {
        if self.limit.kind != LimitKind::Collapse {
            return None;
        }
        let (free, output) = sought.of();
        let value = |solved: &Solved, output| solved.belt.output_values(&solved.solution)?.get(output);
        let mut constants = self.solved.question.constants.clone();
        constants[Constant::SlipThreshold] = case.sheave.slip_threshold;
        let efficiency = value(&self.solved, Output::EfficiencySpeed).ok()?;
        let question = Question::new(constants).swap(free, Output::EfficiencySpeed, efficiency);
        let solved = approach_question(&self.solved, &case.model, &question, &options.solve).ok()?;
        let limit = Limit {
            value: value(&solved, output).ok()?,
            kind: LimitKind::Collapse,
            state: DriveState::of(&solved).ok()?,
            belt_temperature: None,
        };
        Some(Self { limit, solved })
    }
}
