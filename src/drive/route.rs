//! The routes from the start to a case: from which easy drive, and in which order its constants become those of the
//! case.

use solver::continuation::Ramp;

use super::start;
use super::tuning::{
    DEEPEST, FINE_TOLERANCE, HARD_BENDING, KINK_PARTS, LARGE_THRESHOLD, LATE_THRESHOLD, LEAST_WRAPPED, LIGHT, LOOSE,
    SMOOTH_THRESHOLD, STRING_FINE_TOLERANCE, STRING_SMOOTH_THRESHOLD, THRESHOLD, TIGHT, TORQUE, TWO_PARTS,
};
use crate::case::{Friction, ModelChoices};
use crate::model::{Constant, Constants};

/// A route from the start to a case. Those tried first are those that solve most drives for the least work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Route {
    /// At the case's slack tension, or as near to it as the straight belt permits.
    Direct,
    /// The same on meshes that are fine before the slip threshold is small.
    Fine,
    /// From a tighter belt.
    Tight,
    /// From a larger slip threshold.
    Threshold,
    /// From a lighter belt: the same as from a lower speed, where inertia counts less.
    Speed,
    /// From a belt that bends more easily.
    Bending,
    /// With the bending stiffness behind torque and tension, where the start's belt is softer than the case's: a loose
    /// belt that is stiff does not wrap, and one under torque may.
    Stiff,
    /// From a looser belt.
    Loose,
    /// With the last of the slip threshold's way behind that of the tension.
    Late,
    /// With a friction law without kinks, on fine meshes, to which the case's own is the last step.
    Smooth,
    /// With the kinks of the friction law at nodes, for belts without bending stiffness.
    Kinks,
}

impl Route {
    /// All routes, in the order in which they are tried.
    pub const ALL: [Self; 11] = [
        Self::Kinks,
        Self::Direct,
        Self::Fine,
        Self::Smooth,
        Self::Tight,
        Self::Late,
        Self::Threshold,
        Self::Speed,
        Self::Bending,
        Self::Stiff,
        Self::Loose,
    ];

    /// Name in messages and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Fine => "fine meshes",
            Self::Tight => "tight",
            Self::Threshold => "slip threshold",
            Self::Speed => "speed",
            Self::Bending => "bending stiffness",
            Self::Stiff => "stiffness after torque",
            Self::Loose => "loose",
            Self::Late => "late",
            Self::Smooth => "smooth friction",
            Self::Kinks => "kinks at nodes",
        }
    }

    /// Whether the route is another than the direct one for a drive: only friction with kinks can be smoothed or have
    /// its kinks at nodes, the meshes of a string are fine on every route, and only what moves can be moved late.
    pub(super) fn is_for(self, model: &ModelChoices, target: &Constants) -> bool {
        match self {
            Self::Late => Self::splits(&self.begin(target), target),
            Self::Stiff => {
                // In engine braking a soft belt carries what the case's does not: the loose strand would be led beyond
                // its limit, to where it buckles.
                let (bending, driven) = (Constant::BendingStiffness, target[Constant::PrimaryTorque] >= 0.0);
                model.bending.is_some() && driven && self.begin(target)[bending] < target[bending]
            }
            Self::Smooth => model.friction == Friction::ViscousCoulomb,
            Self::Fine => model.bending.is_some(),
            Self::Kinks => model.bending.is_none() && model.friction == Friction::ViscousCoulomb,
            _ => true,
        }
    }

    /// So many parts of a solve's work may this route take, of those of all routes together.
    pub(super) const fn parts(self) -> usize {
        match self {
            Self::Kinks => KINK_PARTS,
            Self::Direct | Self::Fine | Self::Smooth => TWO_PARTS,
            Self::Tight | Self::Late | Self::Threshold | Self::Speed | Self::Bending | Self::Stiff | Self::Loose => 1,
        }
    }

    /// The tolerance of the slip threshold's way, if it is tighter than on other routes. Where the belt adheres at a
    /// small threshold, a node that is added to the mesh lies many thresholds beside the solution, which Newton's
    /// iteration does not survive: nodes are to be there before.
    pub(super) fn tolerance(self, model: &ModelChoices) -> Option<f64> {
        let fine = if model.bending.is_some() { FINE_TOLERANCE } else { STRING_FINE_TOLERANCE };
        matches!(self, Self::Fine | Self::Smooth).then_some(fine)
    }

    /// The drive with the friction law of which the route is followed, and what the constants are at its end, if that
    /// law is not the case's: μ tanh(8|v|/v_thr).
    pub(super) fn smoothed(self, model: &ModelChoices, target: &Constants) -> Option<(ModelChoices, Constants)> {
        if self != Self::Smooth {
            return None;
        }
        let (model, threshold) = smooth_law(model)?;
        let mut target = target.clone();
        target[Constant::SlipThreshold] *= threshold;
        Some((model, target))
    }

    /// The easy drive from which the case is approached.
    pub(super) fn begin(self, target: &Constants) -> Constants {
        let mut easy = target.clone();
        let threshold = if self == Self::Threshold { LARGE_THRESHOLD * THRESHOLD } else { THRESHOLD };
        let speed = target[Constant::PrimaryRadius] * target[Constant::PrimarySpeed];
        easy[Constant::SlipThreshold] = target[Constant::SlipThreshold].max(threshold * speed);
        let factor = match self {
            Self::Tight => TIGHT,
            Self::Loose => LOOSE,
            _ => 1.0,
        };
        let radius = target[Constant::PrimaryRadius].min(target[Constant::SecondaryRadius]);
        let square = radius * radius;
        let highest = DEEPEST * target[Constant::RadialStiffness] * square * libm::tan(target[Constant::HalfAngle]);
        let lowest = LEAST_WRAPPED * target[Constant::BendingStiffness] / square;
        let tension = factor * target[Constant::SlackTension].clamp(lowest.min(highest), highest);
        easy[Constant::SlackTension] = tension;
        let softest = if self == Self::Bending { HARD_BENDING } else { 1.0 };
        easy[Constant::BendingStiffness] =
            softest * target[Constant::BendingStiffness].min(tension / factor * square / LEAST_WRAPPED);
        if self == Self::Speed {
            easy[Constant::MassPerLength] *= LIGHT;
        }
        let torque = target[Constant::PrimaryTorque];
        let most = TORQUE * tension * target[Constant::PrimaryRadius];
        easy[Constant::PrimaryTorque] = torque.clamp(-most, most);
        start::stretched(&easy)
    }

    /// Whether the slip threshold's way can be split by that of the tension.
    fn splits(begin: &Constants, target: &Constants) -> bool {
        let threshold = Constant::SlipThreshold;
        LATE_THRESHOLD * target[threshold] < begin[threshold]
            && target[Constant::SlackTension] < begin[Constant::SlackTension]
    }

    /// The stages of the route, in order: each moves some constants to where the case has them.
    pub(super) fn stages(self, begin: &Constants, target: &Constants) -> Vec<Ramp> {
        let moves = |constant: Constant| begin[constant] != target[constant];
        let linear = |ramp: Ramp, at: Constant| ramp.linear(at.index(), begin[at], target[at]);
        let geometric = |ramp: Ramp, at: Constant| ramp.geometric(at.index(), begin[at], target[at]);
        let mut stages = Vec::new();
        let first = match self {
            Self::Stiff => &[Constant::MassPerLength][..],
            _ => &[Constant::BendingStiffness, Constant::MassPerLength],
        };
        let tighter = target[Constant::SlackTension] > begin[Constant::SlackTension];
        let driven = target[Constant::PrimaryTorque] >= 0.0;
        let torque = linear(Ramp::new(), Constant::PrimaryTorque);
        if tighter && !driven {
            // The loose strand of an engine that brakes is the one whose tension is not given.
            stages.push(geometric(Ramp::new(), Constant::SlackTension));
        }
        stages.extend(first.iter().filter(|at| moves(**at)).map(|at| geometric(Ramp::new(), *at)));
        if tighter && driven {
            stages.push(geometric(torque, Constant::SlackTension));
        } else if moves(Constant::PrimaryTorque) {
            stages.push(torque);
        }
        let threshold = Constant::SlipThreshold;
        if self == Self::Late && Self::splits(begin, target) {
            let late = LATE_THRESHOLD * target[threshold];
            let stage = |from: f64, to: f64| Ramp::new().geometric(threshold.index(), from, to);
            stages.push(stage(begin[threshold], late));
            stages.push(geometric(Ramp::new(), Constant::SlackTension));
            stages.push(stage(late, target[threshold]));
            return stages;
        }
        if self == Self::Stiff {
            stages.push(geometric(Ramp::new(), Constant::BendingStiffness));
        }
        if moves(threshold) || stages.is_empty() {
            stages.push(geometric(Ramp::new(), Constant::SlipThreshold));
        }
        if !tighter && moves(Constant::SlackTension) {
            // A loose belt may transmit the torque only once friction is what the case says.
            stages.push(geometric(Ramp::new(), Constant::SlackTension));
        }
        stages
    }
}

/// A model with the friction law μ tanh(4|v|/v_thr), which has no kinks, in place of that of `model`, and its slip
/// threshold over the case's; nothing if its own has none.
pub(super) fn smooth_law(model: &ModelChoices) -> Option<(ModelChoices, f64)> {
    let threshold = if model.bending.is_some() { SMOOTH_THRESHOLD } else { STRING_SMOOTH_THRESHOLD };
    let smooth = ModelChoices { friction: Friction::Tanh, ..*model };
    (model.friction == Friction::ViscousCoulomb).then_some((smooth, threshold))
}
