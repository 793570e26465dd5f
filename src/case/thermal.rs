//! What a case says of the belt's temperature: how its stiffnesses change with it, and of heat.

use super::error::CaseError;
use super::given::Case;
use super::grid::Grid;
use super::keys::Key;
use super::setting::Setting;

/// Stiffnesses of the belt that are given over its temperature, and the temperature at which all are given that are
/// not.
#[derive(Debug, Clone, PartialEq)]
pub struct Stiffnesses {
    /// T_0, K. Where no temperature is solved for, tables are read at this one.
    pub reference: f64,
    /// EI over the temperature, N·m²; nothing if it was given as a number.
    pub bending: Option<Grid>,
    /// k over the temperature, N/m²; nothing if it was given as a number.
    pub radial: Option<Grid>,
}

/// What the temperature makes of a stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softened {
    /// The stiffness over that at the reference temperature.
    pub factor: f64,
    /// Derivative of its logarithm by the temperature, 1/K.
    pub rate: f64,
}

impl Stiffnesses {
    /// Of a case.
    ///
    /// # Errors
    /// [`CaseProblem::Conflict`](super::CaseProblem::Conflict) for a softening beside a table, which says it already.
    pub(super) fn of(case: &Case) -> Result<Self, CaseError> {
        let pairs = [(Key::BendingStiffness, Key::BendingSoftening), (Key::RadialStiffness, Key::RadialSoftening)];
        let both = pairs.into_iter().find(|(table, softening)| case.table(*table).is_some() && case.has(*softening));
        if let Some((table, softening)) = both {
            let reason = "the table says how the stiffness changes with the temperature";
            return Err(case.conflict(table, softening, reason));
        }
        Ok(Self {
            reference: case.value(Key::ReferenceTemperature),
            bending: case.table(Key::BendingStiffness).cloned(),
            radial: case.table(Key::RadialStiffness).cloned(),
        })
    }

    pub(super) fn bending_at_reference(&self, number: f64) -> f64 {
        self.bending.as_ref().map_or(number, |grid| libm::exp(grid.logarithm(self.reference).0))
    }

    pub(super) fn radial_at_reference(&self, number: f64) -> f64 {
        self.radial.as_ref().map_or(number, |grid| libm::exp(grid.logarithm(self.reference).0))
    }

    /// The tables with their keys.
    pub fn tables(&self) -> impl Iterator<Item = (Key, &Grid)> {
        let tables = [(Key::BendingStiffness, &self.bending), (Key::RadialStiffness, &self.radial)];
        tables.into_iter().filter_map(|(key, grid)| Some((key, grid.as_ref()?)))
    }

    /// A stiffness at a temperature in K: along its table, or falling by a share per kelvin. Both are exponentials,
    /// which are positive at all temperatures.
    fn softened(&self, table: Option<&Grid>, softening: f64, temperature: f64) -> Softened {
        match table {
            Some(grid) => {
                let (here, rate) = grid.logarithm(temperature);
                Softened { factor: libm::exp(here - grid.logarithm(self.reference).0), rate }
            }
            None => Softened { factor: libm::exp(-softening * (temperature - self.reference)), rate: -softening },
        }
    }
}

/// What heats the belt and what cools it; SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thermal {
    /// Temperature of the air, K.
    pub ambient: f64,
    /// Heat that the belt gives off over its excess of temperature, W/K.
    pub heat_transfer: f64,
    /// Of what it was computed, if it was given over the belt's surface.
    pub surface: Option<Surface>,
    /// Share of the friction loss that heats the belt.
    pub friction_share: f64,
    /// Temperature at which the belt's stiffnesses are given, K.
    pub reference: f64,
    /// Share by which the bending stiffness falls per kelvin, 1/K, where no table says it.
    pub bending_softening: f64,
    /// The same of the radial stiffness.
    pub radial_softening: f64,
}

/// Heat transfer over the belt's surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surface {
    /// Heat over area and excess of temperature, W/(m²·K).
    pub per_area: f64,
    /// Length around the belt's section, m.
    pub perimeter: f64,
    /// Length of the belt, m.
    pub length: f64,
}

/// What a case says of heat; nothing unless both the air and the heat transfer are given.
///
/// # Errors
/// [`CaseProblem::Missing`](super::CaseProblem::Missing) if one is given without the other;
/// [`CaseProblem::Conflict`](super::CaseProblem::Conflict) for a heat transfer that is given twice.
pub(super) fn thermal(case: &Case) -> Result<Option<Thermal>, CaseError> {
    if case.has(Key::HeatTransfer) && case.has(Key::HeatTransferPerArea) {
        let reason = "one is that of the whole belt, the other that of each square metre of it";
        return Err(case.conflict(Key::HeatTransfer, Key::HeatTransferPerArea, reason));
    }
    let surface = case.quantity(Key::HeatTransferPerArea).map(|per_area| Surface {
        per_area,
        perimeter: case.value(Key::Perimeter),
        length: case.value(Key::BeltLength),
    });
    let whole = surface.map(|surface| surface.per_area * surface.perimeter * surface.length);
    match (case.quantity(Key::Ambient), case.quantity(Key::HeatTransfer).or(whole)) {
        (None, None) => Ok(None),
        (Some(_), None) => Err(case.missing(
            Key::Ambient,
            "the belt's temperature needs `thermal.heat_transfer` or `thermal.heat_transfer_per_area` as well",
        )),
        (None, Some(_)) => {
            let given = if surface.is_some() { Key::HeatTransferPerArea } else { Key::HeatTransfer };
            Err(case.missing(given, "the belt's temperature needs `thermal.ambient` as well"))
        }
        (Some(ambient), Some(heat_transfer)) => Ok(Some(Thermal {
            ambient,
            heat_transfer,
            surface,
            friction_share: case.value(Key::FrictionShare),
            reference: case.value(Key::ReferenceTemperature),
            bending_softening: case.value(Key::BendingSoftening),
            radial_softening: case.value(Key::RadialSoftening),
        })),
    }
}

impl Thermal {
    /// What a temperature in K makes of the stiffnesses: bending, radial.
    pub fn softened(&self, stiffnesses: &Stiffnesses, temperature: f64) -> [Softened; 2] {
        [
            stiffnesses.softened(stiffnesses.bending.as_ref(), self.bending_softening, temperature),
            stiffnesses.softened(stiffnesses.radial.as_ref(), self.radial_softening, temperature),
        ]
    }

    /// Every key with its value; a softening only where no table stands in its place.
    pub(super) fn settings(&self, stiffnesses: &Stiffnesses) -> Vec<(Key, Setting)> {
        let mut settings = vec![
            (Key::Ambient, self.ambient),
            (Key::FrictionShare, self.friction_share),
            (Key::ReferenceTemperature, self.reference),
        ];
        match self.surface {
            Some(Surface { per_area, perimeter, .. }) => {
                settings.extend([(Key::HeatTransferPerArea, per_area), (Key::Perimeter, perimeter)]);
            }
            None => settings.push((Key::HeatTransfer, self.heat_transfer)),
        }
        if stiffnesses.bending.is_none() {
            settings.push((Key::BendingSoftening, self.bending_softening));
        }
        if stiffnesses.radial.is_none() {
            settings.push((Key::RadialSoftening, self.radial_softening));
        }
        settings.into_iter().map(|(key, value)| (key, Setting::Number(value))).collect()
    }
}
