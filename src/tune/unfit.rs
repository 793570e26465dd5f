//! A point of a drive's shift on a map, or why there is none.

use crate::actuator::ActuatorError;
use crate::case::Key;
use crate::quantity::rpm;

/// A point of the shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShiftPoint {
    /// Nominal ratio R_S/R_P.
    pub ratio: f64,
    /// Speed of the primary, rad/s.
    pub primary_speed: f64,
    /// Speed of the secondary, rad/s.
    pub secondary_speed: f64,
    /// Slack tension, N.
    pub slack_tension: f64,
    /// Share of the friction at hand that is left over.
    pub slip_reserve: f64,
    /// Power out over power in, with losses where the map has them.
    pub efficiency: f64,
    /// How far the primary has closed and the secondary has opened, m.
    pub travels: (f64, f64),
}

/// Why a combination of parts has no shift on the map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unfit {
    /// An actuator gives no force.
    #[error("at ratio {ratio:.2}, {error}")]
    Actuator {
        /// Nominal ratio.
        ratio: f64,
        /// Why.
        error: ActuatorError,
    },
    /// What presses on the secondary is below the slip limit.
    #[error(
        "at ratio {ratio:.2}, the belt slips: at {:.0} rpm helix and spring press the secondary with {presses:.0} N, \
         and a belt that hardly carries the engine's {torque:.1} N·m takes {needs:.0} N", rpm(*speed)
    )]
    Slips {
        /// Nominal ratio.
        ratio: f64,
        /// Speed of the primary, rad/s.
        speed: f64,
        /// Torque of the engine there, N·m.
        torque: f64,
        /// Force of helix and spring, N.
        presses: f64,
        /// Axial force of the loosest belt that does not slip, N.
        needs: f64,
    },
    /// The flyweights do not hold the belt at any speed of the map.
    #[error(
        "at ratio {ratio:.2}, the engine would have to turn faster than {:.0} rpm: there the flyweights less their \
         spring press with {presses:.0} N, and the belt takes {needs:.0} N", rpm(*speed)
    )]
    TooLight {
        /// Nominal ratio.
        ratio: f64,
        /// Largest speed of the map, rad/s.
        speed: f64,
        /// Force of flyweights less spring, N.
        presses: f64,
        /// Axial force of the belt that the secondary's actuator holds, N.
        needs: f64,
    },
    /// The flyweights press with too much at every speed of the map.
    #[error(
        "at ratio {ratio:.2}, the drive shifts out below {:.0} rpm: there the flyweights less their spring press with \
         {presses:.0} N, and the belt takes {needs:.0} N", rpm(*speed)
    )]
    TooHeavy {
        /// Nominal ratio.
        ratio: f64,
        /// Least speed of the map, rad/s.
        speed: f64,
        /// Force of flyweights less spring, N.
        presses: f64,
        /// Axial force of the belt that the secondary's actuator holds, N.
        needs: f64,
    },
    /// No belt holds at a speed, whatever the tension.
    #[error(
        "at ratio {ratio:.2}, no belt was found that holds at {:.0} rpm, with slack tensions up to {tension:.0} N",
        rpm(*speed)
    )]
    Untold {
        /// Nominal ratio.
        ratio: f64,
        /// Speed of the primary, rad/s.
        speed: f64,
        /// Largest slack tension of the map, N.
        tension: f64,
    },
    /// A map that does not reach as far as the drive may have to.
    #[error("at ratio {ratio:.2}, the map does not reach to `{}` = {value:.4}: expected one that does", key.path())]
    Beyond {
        /// Nominal ratio.
        ratio: f64,
        /// Key of the axis.
        key: Key,
        /// Where on it, SI.
        value: f64,
    },
    /// A clamp beyond the map.
    #[error("at ratio {ratio:.2}, the parts press with more than the map has: over {tension:.0} N of slack tension")]
    Tight {
        /// Nominal ratio.
        ratio: f64,
        /// Largest slack tension of the map, N.
        tension: f64,
    },
    /// A clamp below the map.
    #[error(
        "at ratio {ratio:.2}, the parts press with less than the map has: below {tension:.0} N of slack tension at \
        {:.0} rpm",
        rpm(*speed)
    )]
    Loose {
        /// Nominal ratio.
        ratio: f64,
        /// Speed of the primary, rad/s.
        speed: f64,
        /// Least slack tension of the map, N.
        tension: f64,
    },
    /// The map has no values, and the full solution was not found.
    #[error("at ratio {ratio:.2}, where the map has no values, {reason}")]
    Unsolved {
        /// Nominal ratio.
        ratio: f64,
        /// Why.
        reason: String,
    },
    /// The primary is closed before the shift begins.
    #[error("at ratio {ratio:.2}, where the shift would begin, the sheaves would be beyond their stop at high ratio")]
    Closed {
        /// Nominal ratio.
        ratio: f64,
    },
    /// The balance was not found.
    #[error("at ratio {ratio:.2}, no balance of forces was found")]
    Lost {
        /// Nominal ratio.
        ratio: f64,
    },
}

impl Unfit {
    /// In a word, for counts.
    pub const fn kind(&self) -> &'static str {
        match self {
            Self::Actuator { error: ActuatorError::SpringSolid { .. }, .. } => "spring beyond its solid length",
            Self::Actuator { error: ActuatorError::HelixContact { .. }, .. } => "helix without contact",
            Self::Actuator { .. } => "actuator without force",
            Self::Slips { .. } => "belt slips",
            Self::Untold { .. } => "no belt that holds",
            Self::Beyond { .. } => "beyond the map",
            Self::TooLight { .. } => "flyweights too light",
            Self::TooHeavy { .. } => "flyweights too heavy",
            Self::Tight { .. } => "clamp beyond the map",
            Self::Loose { .. } => "clamp below the map",
            Self::Closed { .. } => "no travel left",
            Self::Unsolved { .. } | Self::Lost { .. } => "balance not found",
        }
    }
}
