//! What happened to the belt where no solution was found, told from the last solution on the path to the case.

use std::fmt::{self, Display, Formatter};

use solver::{Points, Solution, SolveError};

use super::belt::BeltProblem;
use super::region::RegionId;
use super::tension::Compressed;
use crate::model::{Constant, Constants, Field, State};

/// Share of the friction at hand that a pulley uses, from which on it is about to slip as a whole.
const SLIPPING: f64 = 0.9;
/// The same, from which on it slips whatever else its belt does.
const SLIPS: f64 = 0.95;
/// Share of the deepest penetration by which another may be negative before the belt counts as lifted: ends have
/// defects.
const LIFTED: f64 = 1e-2;
/// Penetration over radius beyond which the belt sinks faster than its torque rises.
const DEEP: f64 = 0.3;
/// Penetration over radius beyond which the belt counts as pressed through its groove: the model's equations hold for
/// small penetrations.
pub(crate) const PRESSED_THROUGH: f64 = 1.0 / 3.0;
/// T R²/EI of the smaller pulley below which a belt is too stiff to wrap.
const STIFF: f64 = 0.1;

/// What happened to the belt where no solution was found.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Trouble {
    /// The torque takes more difference of tensions than the strand that is not given has: it would be pushed.
    Pushed {
        /// Difference of tensions that the torque takes on the primary's radius, N.
        pull: f64,
        /// Slack tension that is given, N: where the secondary drives, that of the tight strand.
        given: f64,
    },
    /// A pulley uses nearly all friction at hand.
    Slip {
        /// The pulley.
        pulley: RegionId,
        /// Share of the friction at hand that is used.
        used: f64,
    },
    /// The belt is pressed so deep into a groove that its lever arm shrinks as fast as its tension rises.
    Deep {
        /// The pulley.
        pulley: RegionId,
        /// Penetration over radius.
        share: f64,
    },
    /// The belt lifts out of a groove.
    Lifted {
        /// The pulley.
        pulley: RegionId,
    },
    /// The belt is too stiff for its tension to bend it round the smaller pulley.
    Stiff {
        /// Tension times the square of the radius over the bending stiffness.
        group: f64,
    },
    /// The belt is pushed somewhere, but for what its own inertia adds: only its speed holds it there.
    Buckles {
        /// Where.
        region: RegionId,
        /// Its tractive tension there, N: a negative one.
        tension: f64,
    },
    /// The search reached its work limit on the path.
    Work,
    /// Nothing that a belt shows: the search was lost.
    Unknown,
}

impl Trouble {
    /// In one word, for tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pushed { .. } => "pushed",
            Self::Slip { .. } => "slip",
            Self::Deep { .. } => "deep",
            Self::Lifted { .. } => "lifted",
            Self::Stiff { .. } => "stiff",
            Self::Buckles { .. } => "buckles",
            Self::Work => "work_limit",
            Self::Unknown => "unknown",
        }
    }

    /// The likely cause, and what to try.
    pub const fn advice(self) -> &'static str {
        match self {
            Self::Pushed { .. } => {
                "where the secondary drives, `slack_tension` is that of the tight strand, which leaves the primary: \
                 give one above the difference of tensions, or less braking torque"
            }
            Self::Slip { .. } => {
                "clamp the belt tighter, ask for less torque, or check `sheave.friction_coefficient`; `sheave limit` \
                 finds the largest torque for a clamp and the smallest clamp for a torque"
            }
            Self::Deep { .. } => {
                "check the units of `belt.radial_stiffness` and of the clamp; ask for less torque or tension, or take \
                 a larger pulley"
            }
            Self::Lifted { .. } | Self::Buckles { .. } => {
                "clamp the belt tighter, take a belt that bends more easily or a larger pulley, or a lower speed"
            }
            Self::Stiff { .. } => {
                "check the unit of `belt.bending_stiffness`; clamp the belt tighter, or take a larger pulley"
            }
            Self::Work => "allow more work with `--work-limit`; a drive that takes so much may have no solution",
            Self::Unknown => {
                "`sheave limit` finds the largest torque for a clamp and the smallest clamp for a torque: the case \
                 may lie beyond them; `-v` says what the solver met"
            }
        }
    }

    /// Whether a pulley slips, and not for a guess: no other way to the same torque and tension finds friction.
    pub(super) fn slips(self) -> bool {
        matches!(self, Self::Slip { used, .. } if used >= SLIPS)
    }

    /// What holds of the case itself, whatever was solved on the path: a strand that would be pushed.
    ///
    /// On the primary, M_in is at most R_P times the difference of the tractive tensions, for a belt that sinks has a
    /// shorter lever arm; so the strand whose tension is not given has at most T + M_in/R_P.
    pub(super) fn of_case(target: &Constants) -> Option<Self> {
        let (torque, given) = (target[Constant::PrimaryTorque], target[Constant::SlackTension]);
        let pull = -torque / target[Constant::PrimaryRadius];
        (torque < 0.0 && pull > given).then_some(Self::Pushed { pull, given })
    }

    /// What the last solution on the path to `target` shows, after which the solver failed for `cause`.
    pub(super) fn of(belt: &BeltProblem, last: Option<&Solution>, target: &Constants, cause: &SolveError) -> Self {
        if let Some(pushed) = Self::of_case(target) {
            return pushed;
        }
        // A search that runs out of work often does so beside a limit of the belt: what the belt shows comes first.
        let shown = last.and_then(|last| Self::of_solution(belt, last));
        let buckles = || last.and_then(|last| Self::of_tension(belt, last));
        match cause {
            SolveError::Cancelled | SolveError::WorkLimit { .. } => shown.or_else(buckles).unwrap_or(Self::Work),
            _ => shown.or_else(|| Self::of_groups(target)).or_else(buckles).unwrap_or(Self::Unknown),
        }
    }

    fn of_groups(target: &Constants) -> Option<Self> {
        let radius = target[Constant::PrimaryRadius].min(target[Constant::SecondaryRadius]);
        let group = target[Constant::SlackTension] * radius * radius / target[Constant::BendingStiffness];
        (group < STIFF).then_some(Self::Stiff { group })
    }

    fn of_tension(belt: &BeltProblem, last: &Solution) -> Option<Self> {
        let Compressed { region, tension } = Compressed::of(belt, last)?;
        Some(Self::Buckles { region, tension })
    }

    fn of_solution(belt: &BeltProblem, last: &Solution) -> Option<Self> {
        let constants = Constants::try_from(last.constants()).ok()?;
        let contacts = [(RegionId::Primary, Constant::PrimaryRadius), (RegionId::Secondary, Constant::SecondaryRadius)];
        let grips: Vec<(RegionId, Grip)> = contacts
            .into_iter()
            .filter_map(|(region, radius)| Some((region, Grip::of(belt, last, &constants, region, constants[radius])?)))
            .collect();
        let most = |value: fn(&Grip) -> f64| {
            grips.iter().map(|(pulley, grip)| (*pulley, value(grip))).max_by(|(_, a), (_, b)| a.total_cmp(b))
        };
        let over = |least: f64| move |(_, value): &(RegionId, f64)| *value >= least;
        let deep =
            |least| most(|grip| grip.depth).filter(over(least)).map(|(pulley, share)| Self::Deep { pulley, share });
        let slips =
            |least| most(|grip| grip.used).filter(over(least)).map(|(pulley, used)| Self::Slip { pulley, used });
        // Whatever else happens to a belt that is pressed through, the model does not hold for it any more. One that
        // hardly slips yet may be about to buckle.
        deep(PRESSED_THROUGH)
            .or_else(|| slips(SLIPS))
            .or_else(|| slips(SLIPPING).map(|slips| Self::of_tension(belt, last).unwrap_or(slips)))
            .or_else(|| deep(DEEP))
            .or_else(|| most(|grip| grip.lift).filter(over(LIFTED)).map(|(pulley, _)| Self::Lifted { pulley }))
    }
}

/// What a contact shows.
struct Grip {
    /// Share of the friction at hand that acts along the rim.
    used: f64,
    /// Deepest penetration over the radius.
    depth: f64,
    /// How far the belt is out of the groove, over the deepest penetration.
    lift: f64,
}

impl Grip {
    /// Of a contact, at the nodes of its mesh; nothing if the belt does not have the fields.
    fn of(
        belt: &BeltProblem,
        solution: &Solution,
        constants: &Constants,
        region: RegionId,
        radius: f64,
    ) -> Option<Self> {
        let part = solution.regions().get(region.index())?;
        let kernel = belt.kernel(region);
        let s = part.mesh();
        let y: Vec<f64> = (0..part.states()).flat_map(|state| part.state(state).iter().copied()).collect();
        let at = Points { len: s.len(), stride: s.len(), s, y: &y };
        let fields = belt.fields(region, &at, solution.constants());
        let row = |field: Field| fields.chunks_exact(s.len()).nth(kernel.field(field)?);
        let (pressure, friction) = (row(Field::Pressure)?, row(Field::FrictionAtPoint)?);
        let (apparent, sliding) = (row(Field::ApparentSheaveAngle)?, row(Field::SlidingAngle)?);
        let along = |at: usize| Some(friction.get(at)? * libm::cos(*apparent.get(at)?) * libm::sin(*sliding.get(at)?));
        let (mut used, mut weight) = (0.0, 0.0);
        for (at, ends) in s.windows(2).enumerate() {
            let h = ends[1] - ends[0];
            let (p, q) = (pressure.get(at)?, pressure.get(at + 1)?);
            used += h * (p * along(at)? + q * along(at + 1)?);
            weight += h * (p + q);
        }
        let x = part.state(kernel.state(State::Penetration)?);
        let [lowest, deepest] = [f64::min, f64::max].map(|extreme| x.iter().copied().fold(0.0, extreme));
        Some(Self {
            used: (used / weight).abs() / constants[Constant::FrictionCoefficient],
            depth: deepest / radius,
            lift: -lowest / deepest,
        })
    }
}

/// A pulley's name in a sentence.
const fn pulley_name(region: RegionId) -> &'static str {
    match region {
        RegionId::Primary => "primary",
        RegionId::Secondary => "secondary",
        RegionId::SlackSpan => "slack span",
        RegionId::TightSpan => "tight span",
    }
}

impl Display for Trouble {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Pushed { pull, given } => write!(
                to,
                "the belt would be pushed: the braking torque takes {pull:.1} N of difference between the strands on \
                 the primary's radius, and the strand that leaves it has {given:.1} N, so that {:.1} N are left for \
                 the other",
                given - pull
            ),
            Self::Slip { pulley, used } => write!(
                to,
                "the belt slips on the {}: {:.1} % of the friction at hand is used where the last solution was found",
                pulley_name(pulley),
                100.0 * used
            ),
            Self::Deep { pulley, share } => write!(
                to,
                "the belt is pressed through its groove: it sinks into the {} by {:.0} % of the radius, and the \
                 deeper it sinks, the more tension its torque takes",
                pulley_name(pulley),
                100.0 * share
            ),
            Self::Lifted { pulley } => {
                write!(to, "the belt lifts out of the groove of the {}", pulley_name(pulley))
            }
            Self::Stiff { group } => write!(
                to,
                "the belt is too stiff to wrap the smaller pulley: its tension times the square of the radius is \
                 {group:.3} of its bending stiffness"
            ),
            Self::Buckles { region, tension } => write!(
                to,
                "the belt buckles: where the last solution was found its tractive tension falls to {tension:.1} N {}, \
                 and only its speed holds it",
                region.place()
            ),
            Self::Work => to.write_str("the search reached its work limit before the case"),
            Self::Unknown => to.write_str("the search for a solution was lost, and the belt shows no reason"),
        }
    }
}
