//! Which way power goes through a drive.

use crate::model::Output;

/// Share of the larger power below which the other counts as none: a torque of zero is met to the solver's tolerance,
/// and what is left of its power has no direction.
const NO_POWER: f64 = 1e-5;

/// Which way power goes through a drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PowerFlow {
    /// The primary drives the secondary.
    FromPrimary,
    /// The secondary drives the primary, as in engine braking.
    FromSecondary,
    /// None comes out on either side: the secondary has to be driven, and the primary too unless its torque is zero.
    IntoBoth,
    /// None comes out of the secondary, or what comes out of both sides comes from nowhere, or it is not known.
    Neither,
}

/// Whether an output is what the secondary has over what the primary has, of which the reciprocal is told where the
/// secondary drives.
pub(crate) const fn is_efficiency(output: Output) -> bool {
    matches!(output, Output::EfficiencyOverall | Output::EfficiencySpeed | Output::EfficiencyTorque)
}

/// An output as it is told, or the output of what is told: see [`is_efficiency`].
pub(super) fn told(output: Output, value: f64, brakes: bool) -> f64 {
    if brakes && is_efficiency(output) { 1.0 / value } else { value }
}

impl PowerFlow {
    /// By the power into the primary and the power out of the secondary.
    pub fn of(power_in: f64, power_out: f64) -> Self {
        let none = NO_POWER * power_in.abs().max(power_out.abs());
        let is = |power: f64| power > none;
        match (is(power_in), is(-power_in), is(power_out), is(-power_out)) {
            (true, _, true, _) => Self::FromPrimary,
            (_, true, _, true) => Self::FromSecondary,
            (_, false, _, true) => Self::IntoBoth,
            _ => Self::Neither,
        }
    }

    /// Whether a power is none beside the one on the other side.
    pub fn is_none(power: f64, other: f64) -> bool {
        power.is_nan() || power.abs() <= NO_POWER * power.abs().max(other.abs())
    }

    /// Whether one pulley drives the other, so that there is an efficiency.
    pub fn is_through(self) -> bool {
        matches!(self, Self::FromPrimary | Self::FromSecondary)
    }
}

#[cfg(test)]
mod tests {
    use super::PowerFlow::{FromPrimary, FromSecondary, IntoBoth, Neither};
    use super::*;

    #[test]
    fn a_power_that_is_none_has_no_direction() {
        for (power_in, power_out, flow) in [
            (100.0, 90.0, FromPrimary),
            (-90.0, -100.0, FromSecondary),
            (10.0, -100.0, IntoBoth),
            (0.0, -100.0, IntoBoth),
            (1e-9, -100.0, IntoBoth),
            (-1e-9, -100.0, IntoBoth),
            (100.0, -1e-9, Neither),
            (100.0, 0.0, Neither),
            (-100.0, 100.0, Neither),
            (0.0, 0.0, Neither),
            (f64::NAN, 100.0, Neither),
        ] {
            assert_eq!(PowerFlow::of(power_in, power_out), flow, "{power_in} {power_out}");
            assert_eq!(flow.is_through(), matches!(flow, FromPrimary | FromSecondary));
            assert!(!flow.is_through() || !PowerFlow::is_none(power_in, power_out));
        }
    }
}
