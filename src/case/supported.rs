//! Valid cases that the solver does not take.

use super::error::{CaseError, Problem};
use super::file::Case;
use super::keys::Key;
use super::resolve::Resolved;
use crate::drive::Question;

impl Case {
    /// Refuses what cannot be solved for, at the place that asks for it: equations that do not exist, and questions that
    /// have no answer whatever the numbers.
    ///
    /// # Errors
    /// [`Problem::Unsupported`], [`Problem::IllPosed`].
    pub fn check_supported(&self, resolved: &Resolved) -> Result<(), CaseError> {
        if resolved.model.bending.is_none() {
            let (key, reason) = (Key::Edition, "the string belt has no kernels; take another edition");
            let given = self.written(key);
            return Err(CaseError::new(Problem::Unsupported { key, given, reason }, self.places([key])));
        }
        Question::of(resolved).check(&resolved.model).map_err(|reason| {
            let slots = resolved.operating_point.settings().map(|(key, _)| key).chain([Key::Free]);
            let places = self.swaps.iter().map(|(_, place)| place.clone());
            CaseError::new(Problem::IllPosed(reason), places.chain(self.places(slots)))
        })
    }
}
