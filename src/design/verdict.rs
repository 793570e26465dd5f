//! Whether a case without a solution lies beyond a limit: proved by the curve of solutions that turns before it.

use std::fmt::{self, Display, Formatter};

use super::eased::{Easing, Sought, easy, followed};
use super::error::DesignError;
use super::limit::{Limit, LimitKind, LimitOptions, clamped, largest_torque, smallest_slack_tension};
use crate::case::{Clamp, Load, Resolved};
use crate::drive::{Constant, Failure, PRESSED_THROUGH, Question, SolveOptions, Trouble, solve, with_allowance};

/// Share by which a limit has to lie beyond the case: limits are known to the tolerance of the solutions.
const CLEAR: f64 = 1e-3;
/// What is added in engine braking, where the curve is not followed to its very end: so much of the speed efficiency η
/// at which it was left, and so much of its square. Of 22 limits of the survey that were followed to an η of 0.01, the
/// one that changed most changed by shares of 0.033, 0.053, 0.081 and 0.123 from 0.3, 0.4, 0.5 and 0.6 on; a quarter of
/// that is usual.
const CLEAR_BRAKING: [f64; 2] = [0.1, 0.5];

/// Tolerance of solutions for which a limit is sought anew where a case lies beyond it by less than that,
const SHARP: f64 = 1e-5;
/// the share by which it then has to lie beyond, ten tolerances,
const CLEAR_SHARP: f64 = 1e-4;
/// and how many times what the limit has changed by, and would change by on the rest of its curve, is added to that.
const CHANGES: f64 = 2.0;

/// Speed efficiency below which a curve in engine braking proves a limit, should it be lost,
const NEARLY_AT_REST: f64 = 0.2;
/// and below which it does so where no other proof is found.
const SLOW: f64 = 0.5;

/// Of the work that a proof may take, the share, one over this, that each of its solves may
const SOLVES: usize = 10;
/// and that each of its curves may: one that is given up slowly leaves the others their work.
const CURVES: usize = 4;

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
        /// How far it was followed in the slip threshold, if not to the case's.
        easing: Option<Easing>,
    },
    /// From an easier load, the curve on which the torque rises ends below the case's: it is the largest that the clamp
    /// carries.
    Torque {
        /// Primary torque of the case, N·m.
        given: f64,
        /// The largest, of the case's sign.
        limit: Limit,
        /// How far it was followed in the slip threshold, if not to the case's.
        easing: Option<Easing>,
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
/// and slack tension are given has one to look for. It may take as much work as the solve might:
/// [`SolveOptions::work_limit`], over all its solves.
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
    let each = SolveOptions { work_limit: options.work_limit / SOLVES, ..*options };
    let curve = options.work_limit / CURVES;
    let search =
        Search { case, tension, torque, options: LimitOptions { solve: each, ..LimitOptions::default() }, curve };
    with_allowance(options.work_limit, || search.verdict(failure))
}

/// Penetration over radius where the last solution was found, if the belt was pressed through its groove there.
fn pressed_through(failure: &Failure) -> Option<f64> {
    match failure.trouble() {
        Some(Trouble::Deep { share, .. }) if share > PRESSED_THROUGH => Some(share),
        _ => None,
    }
}

/// The search for a limit before a case.
struct Search<'a> {
    case: &'a Resolved,
    /// Slack tension given, N.
    tension: f64,
    /// Primary torque given, N·m.
    torque: f64,
    options: LimitOptions,
    /// Work that a curve may take.
    curve: usize,
}

impl Search<'_> {
    /// The first proof that is found; of a case that is carried where friction is less steep, only what is known.
    fn verdict(&self, failure: &Failure) -> Verdict {
        let sunk = pressed_through(failure).map(|share| Verdict::Sunk { share });
        if self.is_carried() {
            return sunk.unwrap_or(Verdict::Open);
        }
        let eased = || self.pressed_through().map(|share| Verdict::Sunk { share });
        self.limit().or(sunk).or_else(eased).unwrap_or(Verdict::Open)
    }

    /// Whether the case has a solution where friction is less steep: then a limit says nothing. There are drives beside
    /// the curve from an easier load, slipping on both pulleys, that carry more than any on it.
    fn is_carried(&self) -> bool {
        self.case.thermal.is_none() && solve(&easy(self.case), &self.options.solve).is_ok()
    }

    /// The same where friction is less steep and torque and tension rise together: a belt that is pressed through with
    /// less torque, and less tension in both strands together, is not there to be loosened.
    fn pressed_through(&self) -> Option<f64> {
        if self.case.thermal.is_some() || self.torque <= 0.0 {
            return None;
        }
        let radius = Question::of(self.case).constants[Constant::PrimaryRadius];
        let both = |torque: f64, slack: f64| 2.0 * slack + torque / radius;
        match clamped(&easy(self.case), &self.options.solve) {
            Err(DesignError::Start(failure @ Failure::Lost { torque, slack_tension, .. }))
                if torque < self.torque && both(torque, slack_tension) < both(self.torque, self.tension) =>
            {
                pressed_through(&failure)
            }
            _ => None,
        }
    }

    /// The limit before the case: at the slip threshold of the case itself, followed there from larger ones, or by a
    /// curve that is lost before the driven pulley has nearly come to rest.
    fn limit(&self) -> Option<Verdict> {
        let mut found = Vec::new();
        let at_case = [Sought::Tension, Sought::Torque].into_iter().find_map(|sought| {
            let limit = self.at_case(sought)?;
            found.push((sought, limit.clone()));
            self.beyond(sought, limit, None, NEARLY_AT_REST)
        });
        let sharp = || found.iter().find_map(|(sought, limit)| self.sharpened(*sought, limit));
        let slow = || found.iter().find_map(|(sought, limit)| self.beyond(*sought, limit.clone(), None, SLOW));
        at_case.or_else(sharp).or_else(|| self.eased()).or_else(slow)
    }

    /// A limit at the slip threshold of the case itself. That of a string is followed there from larger ones at once.
    fn at_case(&self, sought: Sought) -> Option<Limit> {
        if self.case.model.bending.is_none() && self.case.thermal.is_none() {
            return None;
        }
        let found = with_allowance(self.curve, || match sought {
            Sought::Tension => smallest_slack_tension(self.case, &self.options),
            Sought::Torque => largest_torque(self.case, &self.options),
        });
        found.ok().map(|(limit, _)| limit)
    }

    /// Limits that are followed from larger slip thresholds. Where the belt's temperature is to be found, every one is
    /// that of another belt.
    fn eased(&self) -> Option<Verdict> {
        if self.case.thermal.is_some() {
            return None;
        }
        [(Sought::Tension, self.tension), (Sought::Torque, self.torque)].into_iter().find_map(|(sought, given)| {
            let (limit, easing) = with_allowance(self.curve, || followed(self.case, sought, given, &self.options))?;
            self.beyond(sought, limit, easing, NEARLY_AT_REST)
        })
    }

    /// The proof that a limit is, if the case lies beyond it and its curve was followed as far as `slow` asks.
    fn beyond(&self, sought: Sought, limit: Limit, easing: Option<Easing>, slow: f64) -> Option<Verdict> {
        let [by_speed, by_square] = CLEAR_BRAKING;
        let left = if self.torque < 0.0 { left_at(&limit) } else { 0.0 };
        let braking = by_speed * left + by_square * left * left;
        let margin = CLEAR + braking + easing.map_or(0.0, |easing| easing.margin());
        let clear = sought.beyond(self.given(sought), limit.value) > margin;
        (ends(&limit, self.torque, slow) && clear).then(|| self.proved(sought, limit, easing))
    }

    /// The proof where the case lies beyond a limit by less than limits are known to: that limit anew, for a small
    /// tolerance.
    fn sharpened(&self, sought: Sought, limit: &Limit) -> Option<Verdict> {
        let near = sought.beyond(self.given(sought), limit.value) > 0.0 && ends(limit, self.torque, NEARLY_AT_REST);
        if self.case.thermal.is_some() || !near {
            return None;
        }
        let solve = SolveOptions { tolerance: SHARP.min(self.options.solve.tolerance), ..self.options.solve };
        let find = || sought.find(self.case, &LimitOptions { solve, ..self.options });
        let found = with_allowance(self.curve, find).ok()?;
        let ends = matches!(found.limit.kind, LimitKind::Fold | LimitKind::Collapse);
        let changes = (found.limit.value / limit.value - 1.0).abs() + found.change_to_rest()?;
        let clear = sought.beyond(self.given(sought), found.limit.value) > CLEAR_SHARP + CHANGES * changes;
        (ends && clear).then(|| self.proved(sought, found.limit, None))
    }

    const fn given(&self, sought: Sought) -> f64 {
        match sought {
            Sought::Tension => self.tension,
            Sought::Torque => self.torque,
        }
    }

    const fn proved(&self, sought: Sought, limit: Limit, easing: Option<Easing>) -> Verdict {
        let given = self.given(sought);
        match sought {
            Sought::Tension => Verdict::Tension { given, limit, easing },
            Sought::Torque => Verdict::Torque { given, limit, easing },
        }
    }
}

/// Whether a curve was followed so far that no more than the margin of a proof is left of it: in engine braking, to a
/// speed efficiency of `slow` at least.
fn ends(limit: &Limit, torque: f64, slow: f64) -> bool {
    match limit.kind {
        LimitKind::Fold | LimitKind::Collapse => true,
        LimitKind::Lost(_) => torque < 0.0 && limit.state.speed_efficiency <= slow,
        LimitKind::SpeedEfficiency => false,
    }
}

/// The speed efficiency at which a curve was left: none of it matters where the curve turned before.
const fn left_at(limit: &Limit) -> f64 {
    match limit.kind {
        LimitKind::Fold => 0.0,
        _ => limit.state.speed_efficiency,
    }
}

impl Display for Verdict {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let end = |limit: &Limit| match limit.kind {
            LimitKind::Fold => "below it no solution is left",
            LimitKind::Lost(_) if limit.state.speed_efficiency <= NEARLY_AT_REST => {
                "there the driven pulley has nearly come to rest"
            }
            LimitKind::Lost(_) => "there the driven pulley has lost more than half of its speed",
            _ => "there the driven pulley comes to rest",
        };
        let eased = |easing: &Option<Easing>| {
            easing.map_or(String::new(), |easing| {
                format!(
                    "; followed to a slip threshold of {:.1e} m/s, on the last decade to which it changes by {:.1e}",
                    easing.slip_threshold, easing.change
                )
            })
        };
        match self {
            Self::Sunk { share } => write!(
                to,
                "the belt is pressed through its groove: before it has this torque and tension it lies {:.0} % of the \
                 radius deep, more than the model or a belt bears",
                100.0 * share
            ),
            Self::Pushed => to.write_str("a strand of the belt would be pushed"),
            Self::Tension { given, limit, easing } => write!(
                to,
                "this torque takes a slack tension of at least {:.2} N, and {given:.2} N is given ({}{})",
                limit.value,
                end(limit),
                eased(easing)
            ),
            Self::Torque { given, limit, easing } => write!(
                to,
                "this clamp carries at most {:.2} N·m, and {given:.2} N·m is asked for ({}{})",
                limit.value,
                if limit.kind == LimitKind::Fold { "beyond it no solution is left" } else { end(limit) },
                eased(easing)
            ),
            Self::Open => to.write_str("no limit was found before the case: it may have a solution that was not found"),
        }
    }
}
