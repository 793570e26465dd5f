//! Which keys of the case file give which constants and prescribe which outputs, and how messages name both.

use super::keys::Key;
use crate::model::{Constant, Output};
use crate::text::subscripted;

impl Key {
    /// The key that gives a constant; `None` for those that are found unless something else is prescribed.
    pub const fn of_constant(constant: Constant) -> Option<Self> {
        match constant {
            Constant::SpeedRatio => Some(Self::SpeedRatio),
            Constant::LongitudinalStiffness => Some(Self::LongitudinalStiffness),
            Constant::BendingStiffness => Some(Self::BendingStiffness),
            Constant::RadialStiffness => Some(Self::RadialStiffness),
            Constant::MassPerLength => Some(Self::MassPerLength),
            Constant::PrimaryRadius => Some(Self::PrimaryRadius),
            Constant::SecondaryRadius => Some(Self::SecondaryRadius),
            Constant::CenterDistance => Some(Self::CenterDistance),
            Constant::HalfAngle => Some(Self::HalfAngle),
            Constant::FrictionCoefficient => Some(Self::FrictionCoefficient),
            Constant::SlipThreshold => Some(Self::SlipThreshold),
            Constant::PrimarySpeed => Some(Self::PrimarySpeed),
            Constant::PrimaryTorque => Some(Self::PrimaryTorque),
            Constant::SlackTension => Some(Self::SlackTension),
            Constant::Flow
            | Constant::PrimaryWrap
            | Constant::SecondaryWrap
            | Constant::PrimaryOrientation
            | Constant::SecondaryOrientation
            | Constant::TightLength
            | Constant::SlackLength => None,
        }
    }

    /// The output that the key prescribes, if it prescribes one.
    pub const fn output(self) -> Option<Output> {
        match self {
            Self::SecondarySpeed => Some(Output::SecondarySpeed),
            Self::SecondaryTorque => Some(Output::SecondaryTorque),
            Self::TightTension => Some(Output::PrimaryEntryTension),
            Self::PrimaryAxialForce => Some(Output::PrimaryAxialForce),
            Self::SecondaryAxialForce => Some(Output::SecondaryAxialForce),
            Self::BeltLength => Some(Output::BeltUnstretchedLength),
            _ => None,
        }
    }

    /// The key that prescribes an output, if there is one.
    pub fn of_output(output: Output) -> Option<Self> {
        super::keys::TABLE.iter().map(|entry| entry.key).find(|key| key.output() == Some(output))
    }
}

/// How messages name a constant: by its key of the case file, or by its symbol.
pub fn constant_label(constant: Constant) -> &'static str {
    Key::of_constant(constant).map_or(constant.name(), Key::path)
}

/// How messages name an output: by its key of the case file, or as in the result object.
pub fn output_label(output: Output) -> &'static str {
    Key::of_output(output).map_or(output.name(), Key::path)
}

/// What an axis of a figure over an output says: name, symbol, unit, as `primary axial force A_{P} (N)`.
pub fn output_axis_label(output: Output) -> String {
    let symbol = output.symbol();
    let place = ["primary.", "secondary.", "tight_span.", "slack_span."].iter().any(|of| symbol.name.starts_with(of));
    let what = if place { symbol.name.replace(['.', '_'], " ") } else { symbol.doc.to_owned() };
    let unit = if symbol.unit.is_empty() { String::new() } else { format!(" ({})", symbol.unit) };
    format!("{what} {}{unit}", subscripted(symbol.symbol))
}
