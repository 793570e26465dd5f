//! What a case says of losses besides friction.

use super::error::CaseError;
use super::given::Case;
use super::grid::Grid;
use super::keys::Key;
use super::loss_tangent::LossTangent;
use super::setting::Setting;
use crate::model::{Edition, Include};

/// Losses besides friction.
#[derive(Debug, Clone, PartialEq)]
pub struct Losses {
    /// Whether they were asked for; if nothing was said, they are told where there are any.
    pub include: Option<Include>,
    /// Of bending the belt and of squeezing it in the groove.
    pub loss_tangent: LossTangent,
    /// Of the cord's stretching.
    pub cord_loss_tangent: LossTangent,
    /// Torque that drags at the primary at every speed, N·m.
    pub primary_drag: f64,
    /// Torque that drags at the secondary at every speed, N·m.
    pub secondary_drag: f64,
    /// Torque that drags at the primary over its speed, N·m·s.
    pub primary_drag_per_speed: f64,
    /// Torque that drags at the secondary over its speed, N·m·s.
    pub secondary_drag_per_speed: f64,
    /// Efficiency of gears between the secondary and the shaft of interest.
    pub gear_efficiency: f64,
}

/// The losses of a case.
///
/// # Errors
/// [`CaseProblem::Conflict`](super::CaseProblem::Conflict) if they are asked of an edition that cannot tell them.
pub(super) fn losses(case: &Case, edition: Edition) -> Result<Losses, CaseError> {
    let include = case.choice(Key::Losses).and_then(Include::from_name);
    if include == Some(Include::On) && edition.model().bending.is_none() {
        let reason = "without bending stiffness the belt's curvature jumps where it meets a pulley, and what its \
            hysteresis dissipates diverges";
        return Err(case.conflict(Key::Edition, Key::Losses, reason));
    }
    let tangent = |key: Key| match case.table(key) {
        Some(grid) => LossTangent::Table(grid.clone()),
        None => LossTangent::Constant(case.value(key)),
    };
    Ok(Losses {
        include,
        loss_tangent: tangent(Key::LossTangent),
        cord_loss_tangent: tangent(Key::CordLossTangent),
        primary_drag: case.value(Key::PrimaryDrag),
        secondary_drag: case.value(Key::SecondaryDrag),
        primary_drag_per_speed: case.value(Key::PrimaryDragPerSpeed),
        secondary_drag_per_speed: case.value(Key::SecondaryDragPerSpeed),
        gear_efficiency: case.value(Key::GearEfficiency),
    })
}

impl Losses {
    /// Tables of tan δ over the temperature, with their keys.
    pub fn tables(&self) -> impl Iterator<Item = (Key, &Grid)> {
        let tangents = [(Key::LossTangent, &self.loss_tangent), (Key::CordLossTangent, &self.cord_loss_tangent)];
        tangents.into_iter().filter_map(|(key, tangent)| match tangent {
            LossTangent::Table(grid) => Some((key, grid)),
            LossTangent::Constant(_) => None,
        })
    }

    /// Whether they are to be told.
    pub fn wanted(&self) -> bool {
        self.include != Some(Include::Off)
    }

    /// Every key with its value.
    pub(super) fn settings(&self) -> Vec<(Key, Setting)> {
        let tangent = |tangent: &LossTangent| match tangent {
            LossTangent::Constant(value) => Setting::Number(*value),
            LossTangent::Table(grid) => Setting::Table(grid.clone()),
        };
        let numbers = [
            (Key::PrimaryDrag, self.primary_drag),
            (Key::SecondaryDrag, self.secondary_drag),
            (Key::PrimaryDragPerSpeed, self.primary_drag_per_speed),
            (Key::SecondaryDragPerSpeed, self.secondary_drag_per_speed),
            (Key::GearEfficiency, self.gear_efficiency),
        ];
        let tangents =
            [(Key::LossTangent, tangent(&self.loss_tangent)), (Key::CordLossTangent, tangent(&self.cord_loss_tangent))];
        let numbers = numbers.into_iter().map(|(key, value)| (key, Setting::Number(value)));
        tangents
            .into_iter()
            .chain(numbers)
            .chain(self.include.map(|include| (Key::Losses, Setting::Name(include.name()))))
            .collect()
    }
}
