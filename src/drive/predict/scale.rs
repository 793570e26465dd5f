//! Scales on which constants are predicted.

use crate::model::Constant;

/// Change of the speed ratio, as a share of it, up to which it is predicted by its logarithm.
const LARGEST_CHANGE: f64 = 0.5;

/// The scale on which a constant is predicted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Linear,
    Logarithmic,
}

impl Scale {
    /// The speed ratio is predicted by its logarithm; unless it goes to nothing, as where the secondary comes to rest,
    /// or begins there.
    pub fn of(constant: Constant, value: f64, change: f64) -> Self {
        let proportional = constant == Constant::SpeedRatio && change.abs() < LARGEST_CHANGE * value;
        if proportional { Self::Logarithmic } else { Self::Linear }
    }

    pub fn to(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => libm::log(value),
        }
    }

    pub fn from(self, scaled: f64) -> f64 {
        match self {
            Self::Linear => scaled,
            Self::Logarithmic => libm::exp(scaled),
        }
    }

    /// A rate of change on this scale.
    pub fn rate(self, value: f64, rate: f64) -> f64 {
        match self {
            Self::Linear => rate,
            Self::Logarithmic => rate / value,
        }
    }
}
