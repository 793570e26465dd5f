//! Valid cases that the solver does not take.

use super::error::{CaseError, Problem};
use super::file::Case;
use super::keys::Key;
use super::operating::{Clamp, Load, Speed};
use super::resolve::Resolved;

impl Case {
    /// Refuses what cannot be solved for, at the place that asks for it.
    ///
    /// # Errors
    /// [`Problem::Unsupported`].
    pub fn check_supported(&self, resolved: &Resolved) -> Result<(), CaseError> {
        let point = &resolved.operating_point;
        let unsupported = if resolved.model.bending.is_none() {
            Some((Key::Edition, "the string belt has no kernels; take another edition"))
        } else if resolved.drive.free.is_some() {
            Some((Key::Free, "give both radii or their ratio"))
        } else if !matches!(point.speed, Speed::Primary(_)) {
            Some((point.speed.setting().0, "give `operating_point.primary_speed`"))
        } else if !matches!(point.load, Load::PrimaryTorque(_)) {
            Some((point.load.setting().0, "give `operating_point.primary_torque`"))
        } else if !matches!(point.clamp, Clamp::SlackTension(_)) {
            Some((point.clamp.setting().0, "give `operating_point.slack_tension`"))
        } else {
            None
        };
        match unsupported {
            None => Ok(()),
            Some((key, reason)) => {
                Err(CaseError::new(Problem::Unsupported { key, given: self.written(key), reason }, self.places([key])))
            }
        }
    }
}
