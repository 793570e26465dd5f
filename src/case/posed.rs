//! Valid cases whose question has no answer whatever the numbers.

use super::error::{CaseError, Problem};
use super::file::Case;
use super::keys::Key;
use super::resolve::Resolved;
use crate::drive::Question;

impl Case {
    /// Refuses a question that has no answer whatever the numbers, at the places that ask it.
    ///
    /// # Errors
    /// [`Problem::IllPosed`].
    pub fn check_posed(&self, resolved: &Resolved) -> Result<(), CaseError> {
        Question::of(resolved).check(&resolved.model).map_err(|reason| {
            let slots = resolved.operating_point.settings().map(|(key, _)| key).chain([Key::Free]);
            let places = self.swaps.iter().map(|(_, place)| place.clone());
            CaseError::new(Problem::IllPosed(reason), places.chain(self.places(slots)))
        })
    }
}
