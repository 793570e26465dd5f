//! Values of a drive's constants.

use super::{Constant, InternalError};

/// Values of all constants, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Constants(pub [f64; Constant::ALL.len()]);

impl std::ops::Index<Constant> for Constants {
    type Output = f64;
    fn index(&self, constant: Constant) -> &f64 {
        &self.0[constant.index()]
    }
}

impl std::ops::IndexMut<Constant> for Constants {
    fn index_mut(&mut self, constant: Constant) -> &mut f64 {
        &mut self.0[constant.index()]
    }
}

impl TryFrom<&[f64]> for Constants {
    type Error = InternalError;

    /// The leading values of a vector of the problem's constants.
    fn try_from(values: &[f64]) -> Result<Self, InternalError> {
        let expected = Constant::ALL.len();
        let short = InternalError::Length { what: "the vector of constants", found: values.len(), expected };
        values.first_chunk().copied().map(Self).ok_or(short)
    }
}
