//! Whether a case without a solution lies beyond a limit: proved by the curve of solutions that turns before it.

use std::fmt::{self, Display, Formatter};

use super::limit::{Limit, LimitKind, LimitOptions, largest_torque, smallest_slack_tension};
use crate::case::{Clamp, Load, Resolved};
use crate::drive::{Failure, SolveOptions, Trouble};

/// Share by which a limit has to lie beyond the case: limits are known to the tolerance of the solutions.
const CLEAR: f64 = 1e-3;
/// What is added in engine braking, where the curve is not followed to its very end, over the speed efficiency at which
/// it was left: of 11 limits of the survey that were followed on from 0.1, the one that changed most changed by a share
/// of 0.09 of the speed efficiency's change.
const CLEAR_BRAKING: f64 = 0.1;

/// Penetration over radius beyond which a belt counts as pressed through.
const SUNK: f64 = 1.0 / 3.0;

/// What can be said of a case for which no solution was found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Verdict {
    /// A strand would be pushed: no equations are needed to see it.
    Pushed,
    /// The belt sinks into a groove by more than a third of the radius before it has the case's torque and tension: it
    /// is pressed through, and the equations, which hold for small penetrations, are not asked any further.
    Sunk {
        /// Penetration over radius where the last solution was found.
        share: f64,
    },
    /// From a tighter belt, the curve on which the slack tension falls ends above the case's: it is the smallest that
    /// carries the torque.
    Tension {
        /// Slack tension of the case, N.
        given: f64,
        /// The smallest.
        limit: Limit,
    },
    /// From an easier load, the curve on which the torque rises ends below the case's: it is the largest that the clamp
    /// carries.
    Torque {
        /// Primary torque of the case, N·m.
        given: f64,
        /// The largest, of the case's sign.
        limit: Limit,
    },
    /// Neither limit was found to lie before the case: it may have a solution.
    Open,
}

impl Verdict {
    /// Whether it is shown that no drive of use is to be found on the curves from easier cases.
    pub const fn is_settled(&self) -> bool {
        !matches!(self, Self::Open)
    }
}

/// Looks for the limit beyond which a case lies that `failure` has left without a solution. Only a case whose torque
/// and slack tension are given has one to look for.
pub fn verdict(case: &Resolved, failure: &Failure, options: &SolveOptions) -> Verdict {
    if matches!(failure.trouble(), Some(Trouble::Pushed { .. })) {
        return Verdict::Pushed;
    }
    let point = &case.operating_point;
    let (Load::PrimaryTorque(torque), Clamp::SlackTension(tension), None) = (point.load, point.clamp, point.margin)
    else {
        return Verdict::Open;
    };
    if failure.trouble().is_none() || case.drive.free.is_some() || !case.swaps.is_empty() {
        return Verdict::Open;
    }
    let options = LimitOptions { solve: *options, least_speed_efficiency: 0.0 };
    let clear = |limit: &Limit| 1.0 + CLEAR + if torque < 0.0 { CLEAR_BRAKING * left_at(limit) } else { 0.0 };
    let ends = |limit: &Limit| matches!(limit.kind, LimitKind::Fold | LimitKind::Collapse);
    if let Ok((limit, _)) = smallest_slack_tension(case, &options)
        && ends(&limit)
        && limit.value > tension * clear(&limit)
    {
        return Verdict::Tension { given: tension, limit };
    }
    if let Ok((limit, _)) = largest_torque(case, &options)
        && ends(&limit)
        && limit.value.abs() * clear(&limit) < torque.abs()
    {
        return Verdict::Torque { given: torque, limit };
    }
    match failure.trouble() {
        Some(Trouble::Deep { share, .. }) if share > SUNK => Verdict::Sunk { share },
        _ => Verdict::Open,
    }
}

/// The speed efficiency at which a curve was left: none of it matters where the curve turned before.
const fn left_at(limit: &Limit) -> f64 {
    match limit.kind {
        LimitKind::Collapse => limit.state.speed_efficiency,
        _ => 0.0,
    }
}

impl Display for Verdict {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let end = |limit: &Limit| match limit.kind {
            LimitKind::Fold => "below it no solution is left",
            _ => "there the driven pulley comes to rest",
        };
        match self {
            Self::Sunk { share } => write!(
                to,
                "the belt is pressed through its groove: before it has this torque and tension it lies {:.0} % of the \
                 radius deep, more than the model or a belt bears",
                100.0 * share
            ),
            Self::Pushed => to.write_str("a strand of the belt would be pushed"),
            Self::Tension { given, limit } => write!(
                to,
                "this torque takes a slack tension of at least {:.2} N, and {given:.2} N is given ({})",
                limit.value,
                end(limit)
            ),
            Self::Torque { given, limit } => write!(
                to,
                "this clamp carries at most {:.2} N·m, and {given:.2} N·m is asked for ({})",
                limit.value,
                if limit.kind == LimitKind::Fold { "beyond it no solution is left" } else { end(limit) }
            ),
            Self::Open => to.write_str("no limit was found before the case: it may have a solution that was not found"),
        }
    }
}
