//! What every key of a case stands at in a drive.

use std::collections::BTreeMap;

use super::keys::shown;
use crate::case::{Key, Resolved, Setting, TABLE};
use crate::result::DriveResult;

/// The value of every quantity, in the unit in which it is shown: as given, else as the drive has it, else as the base
/// case has it. A key without any of these is left out.
pub(super) fn asked(case: &Resolved, result: Option<&DriveResult<Resolved>>) -> BTreeMap<&'static str, f64> {
    let mut values: BTreeMap<Key, f64> = BTreeMap::new();
    values.extend(TABLE.iter().filter_map(|entry| Some((entry.key, entry.base()?))));
    values.extend(result.into_iter().flat_map(found));
    let settings = case.settings().into_iter().filter_map(|(key, setting)| match setting {
        Setting::Number(value) => Some((key, value)),
        Setting::Name(_) | Setting::List(_) | Setting::Table(_) => None,
    });
    values.extend(settings);
    if case.drive.free.is_none() {
        values.insert(Key::Ratio, case.drive.secondary_radius / case.drive.primary_radius);
    }
    values.into_iter().filter_map(|(key, si)| Some((key.path(), shown(key)?.in_unit(si)))).collect()
}

/// What a solved drive has in place of what was not given, SI.
fn found(result: &DriveResult<Resolved>) -> [(Key, f64); 14] {
    let (primary, secondary) = (&result.primary, &result.secondary);
    [
        (Key::PrimaryRadius, primary.radius),
        (Key::SecondaryRadius, secondary.radius),
        (Key::Ratio, secondary.radius / primary.radius),
        (Key::PrimarySpeed, primary.speed),
        (Key::SecondarySpeed, secondary.speed),
        (Key::PrimaryTorque, primary.torque),
        (Key::SecondaryTorque, secondary.torque),
        (Key::SpeedRatio, secondary.speed / primary.speed),
        (Key::SlackTension, primary.exit_tension),
        (Key::TightTension, primary.entry_tension),
        (Key::PrimaryAxialForce, primary.axial_force),
        (Key::SecondaryAxialForce, secondary.axial_force),
        (Key::SlipReserve, result.slip_reserve),
        (Key::FrictionUtilization, result.friction_utilization),
    ]
}

/// The choices that apply, given or not.
pub(super) fn choices(case: &Resolved) -> BTreeMap<&'static str, &'static str> {
    let names = case.settings().into_iter().filter_map(|(key, setting)| match setting {
        Setting::Name(name) => Some((key.path(), name)),
        Setting::Number(_) | Setting::List(_) | Setting::Table(_) => None,
    });
    names.collect()
}
