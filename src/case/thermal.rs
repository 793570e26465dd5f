//! What a case says of heat.

use super::error::CaseError;
use super::file::Case;
use super::keys::Key;
use super::resolve::Setting;

/// What heats the belt and what cools it; SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thermal {
    /// Temperature of the air, K.
    pub ambient: f64,
    /// Heat that the belt gives off over its excess of temperature, W/K.
    pub heat_transfer: f64,
    /// Share of the friction loss that heats the belt.
    pub friction_share: f64,
    /// Temperature at which the belt's stiffnesses are given, K.
    pub reference: f64,
    /// Share by which the bending stiffness falls per kelvin, 1/K.
    pub bending_softening: f64,
    /// The same of the radial stiffness.
    pub radial_softening: f64,
}

/// What a case says of heat; nothing unless both the air and the heat transfer are given.
///
/// # Errors
/// [`CaseProblem::Missing`](super::CaseProblem::Missing) if one is given without the other;
/// [`CaseProblem::Conflict`](super::CaseProblem::Conflict) beside a margin against slip.
pub(super) fn thermal(case: &Case) -> Result<Option<Thermal>, CaseError> {
    let margin = [Key::SlipReserve, Key::FrictionUtilization].into_iter().find(|key| case.has(*key));
    if let Some(margin) = margin.filter(|_| case.has(Key::Ambient)) {
        let reason = "a margin against slip is found at the stiffnesses that are given, not at those of a warm belt";
        return Err(case.conflict(margin, Key::Ambient, reason));
    }
    match (case.quantity(Key::Ambient), case.quantity(Key::HeatTransfer)) {
        (None, None) => Ok(None),
        (Some(_), None) => {
            Err(case.missing(Key::Ambient, "the belt's temperature needs `thermal.heat_transfer` as well"))
        }
        (None, Some(_)) => {
            Err(case.missing(Key::HeatTransfer, "the belt's temperature needs `thermal.ambient` as well"))
        }
        (Some(ambient), Some(heat_transfer)) => Ok(Some(Thermal {
            ambient,
            heat_transfer,
            friction_share: case.value(Key::FrictionShare),
            reference: case.value(Key::ReferenceTemperature),
            bending_softening: case.value(Key::BendingSoftening),
            radial_softening: case.value(Key::RadialSoftening),
        })),
    }
}

impl Thermal {
    /// The stiffnesses at a temperature over those at the reference: bending, radial.
    ///
    /// Exponential, which through two measured temperatures is positive at all others.
    pub fn softened(&self, temperature: f64) -> [f64; 2] {
        let above = temperature - self.reference;
        [(-self.bending_softening * above).exp(), (-self.radial_softening * above).exp()]
    }

    /// Every key with its value.
    pub(super) fn settings(&self) -> [(Key, Setting); 6] {
        [
            (Key::Ambient, self.ambient),
            (Key::HeatTransfer, self.heat_transfer),
            (Key::FrictionShare, self.friction_share),
            (Key::ReferenceTemperature, self.reference),
            (Key::BendingSoftening, self.bending_softening),
            (Key::RadialSoftening, self.radial_softening),
        ]
        .map(|(key, value)| (key, Setting::Number(value)))
    }
}
