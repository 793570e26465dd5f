//! Valid cases that the solver does not take.

use super::error::{CaseError, Problem};
use super::file::Case;
use super::keys::Key;
use super::resolve::Resolved;

impl Case {
    /// Refuses what cannot be solved for, at the place that asks for it.
    ///
    /// # Errors
    /// [`Problem::Unsupported`].
    pub fn check_supported(&self, resolved: &Resolved) -> Result<(), CaseError> {
        if resolved.model.bending.is_some() {
            return Ok(());
        }
        let (key, reason) = (Key::Edition, "the string belt has no kernels; take another edition");
        Err(CaseError::new(Problem::Unsupported { key, given: self.written(key), reason }, self.places([key])))
    }
}
