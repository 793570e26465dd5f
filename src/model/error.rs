//! What must not happen.

use thiserror::Error;

use super::{Field, Integral, Output, State};

/// A broken promise between two parts of this program. No input may cause it; where it is met, it is told instead of
/// a number that would be wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum InternalError {
    /// An output was asked of a drive whose equations do not have it.
    #[error("internal error: the equations of this drive have no output `{}`; please report this case", .0.name())]
    Output(Output),
    /// A state was asked of a region that does not have it.
    #[error("internal error: the {region} has no state `{}`; please report this case", .state.name())]
    State {
        /// The region's name.
        region: &'static str,
        /// The state.
        state: State,
    },
    /// A derived field was asked of a region that does not have it.
    #[error("internal error: the {region} has no field `{}`; please report this case", .field.name())]
    Field {
        /// The region's name.
        region: &'static str,
        /// The field.
        field: Field,
    },
    /// An integral was asked of a region that does not have it.
    #[error("internal error: the {region} has no integral `{}`; please report this case", .integral.name())]
    Integral {
        /// The region's name.
        region: &'static str,
        /// The integral.
        integral: Integral,
    },
    /// A vector is shorter than its layout says.
    #[error("internal error: {what} holds {found} values where {expected} are needed; please report this case")]
    Length {
        /// The vector.
        what: &'static str,
        /// Values that it holds.
        found: usize,
        /// Values that it must hold.
        expected: usize,
    },
    /// What this program writes or brings along as JSON is none.
    #[error("internal error: {0} is not to be had as JSON; please report this case")]
    Json(&'static str),
}
