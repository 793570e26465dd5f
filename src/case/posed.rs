//! Valid cases whose question has no answer whatever the numbers.

use super::error::{CaseError, CaseProblem};
use super::given::Case;
use super::keys::Key;
use super::resolve::Resolved;
use crate::model::IllPosed;

impl Case {
    /// The error for a question that has no answer, at the places that ask it.
    pub(crate) fn ill_posed(&self, resolved: &Resolved, reason: IllPosed) -> CaseError {
        let slots = resolved.operating_point.settings().map(|(key, _)| key).chain([Key::Free]);
        let places = self.swaps.iter().map(|(_, place)| place.clone());
        CaseError::new(CaseProblem::IllPosed(reason), places.chain(self.places(slots)))
    }
}
