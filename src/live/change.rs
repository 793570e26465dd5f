//! Changes to a case that keep the rest of the drive as it is.

use crate::case::{Case, CaseError, Key};
use crate::model::Free;
use crate::result::Outcome;

/// The case with keys taken out, then others set in place of what they exclude. Where a radius takes the place of the
/// ratio, the other radius stays what it was in the last solution: what moves is what was changed.
pub(super) fn changed(
    case: &Case,
    set: &[(String, String)],
    unset: &[String],
    last: Option<&Outcome>,
) -> Result<Case, CaseError> {
    let mut case = case.clone();
    unset.iter().try_for_each(|key| case.unset(key))?;
    let keys: Vec<Key> = set.iter().filter_map(|(key, _)| Key::from_path(key)).collect();
    let both = [Key::PrimaryRadius, Key::SecondaryRadius];
    let ratio_ends = case.has(Key::Ratio) && both.iter().any(|key| keys.contains(key));
    if let (true, Some(last)) = (ratio_ends, last) {
        let radii = [last.result.primary.radius, last.result.secondary.radius];
        case.make_room(&both);
        for (key, radius) in both.into_iter().zip(radii) {
            case.set_si(key, radius)?;
        }
    }
    case.make_room(&keys);
    for key in &keys {
        only_one(&mut case, *key)?;
    }
    set.iter().try_for_each(|(key, value)| case.set(key, value))?;
    if keys.contains(&Key::Free) {
        let free =
            set.iter().rev().find(|(key, _)| key == Key::Free.path()).and_then(|(_, name)| Free::from_name(name));
        let out: &[Key] = match free {
            Some(Free::PrimaryRadius) => &[Key::PrimaryRadius],
            Some(Free::SecondaryRadius) => &[Key::SecondaryRadius],
            Some(Free::Both) => &[Key::PrimaryRadius, Key::SecondaryRadius, Key::Ratio],
            None => &[],
        };
        out.iter().try_for_each(|key| case.unset(key.path()))?;
    } else if both.iter().any(|key| keys.contains(key)) && case.has(Key::Free) {
        // A radius that is set is not solved for.
        case.unset(Key::Free.path())?;
    }
    Ok(case)
}

/// A speed takes the place of the other speed, unless both are given as speed and load; so does one way to say how heat
/// is given off of the other.
fn only_one(case: &mut Case, key: Key) -> Result<(), CaseError> {
    let other = match key {
        Key::HeatTransfer => return case.unset(Key::HeatTransferPerArea.path()),
        Key::HeatTransferPerArea => return case.unset(Key::HeatTransfer.path()),
        Key::PrimarySpeed => Key::SecondarySpeed,
        Key::SecondarySpeed => Key::PrimarySpeed,
        // A load takes the place of a second speed that was one.
        Key::PrimaryTorque | Key::SecondaryTorque | Key::SpeedRatio
            if case.has(Key::PrimarySpeed) && case.has(Key::SecondarySpeed) =>
        {
            return case.unset(Key::SecondarySpeed.path());
        }
        _ => return Ok(()),
    };
    if case.has(key) && case.has(other) { Ok(()) } else { case.unset(other.path()) }
}
