//! What is worth knowing of a whole drive beside its numbers.

use crate::case::{Case, Key, Resolved};
use crate::quantity::rpm;

/// A sentence for each key of a case that its equilibrium does not use, lest it be thought to count.
pub fn unused_keys(case: &Case) -> Vec<String> {
    let found = |key: &Key| {
        let section = key.entry().section();
        let radii = [Key::PrimaryRadius, Key::SecondaryRadius, Key::Ratio, Key::Free];
        (section == "operating_point" && *key != Key::SecondarySpeed) || radii.contains(key)
    };
    let told = |key: Key| format!("`{}` is not used: actuators, engine and belt determine it.", key.path());
    case.keys().filter(found).map(told).collect()
}

/// A sentence where an engine would have to run at speeds in rad/s for which its torque is not given.
pub fn beyond_engine(case: &Resolved, speeds: impl IntoIterator<Item = f64>) -> Option<String> {
    let (low, high) = case.parts.engine.as_ref()?.range();
    let ends = |ends: Option<(f64, f64)>, speed: f64| {
        let (slowest, fastest) = ends.unwrap_or((speed, speed));
        Some((slowest.min(speed), fastest.max(speed)))
    };
    let (slowest, fastest) = speeds.into_iter().fold(None, ends)?;
    let at = match (slowest < low, fastest > high) {
        (false, false) => return None,
        _ if slowest == fastest => format!("at {:.0} rpm", rpm(slowest)),
        (true, false) => format!("down to {:.0} rpm", rpm(slowest)),
        (false, true) => format!("up to {:.0} rpm", rpm(fastest)),
        (true, true) => format!("from {:.0} to {:.0} rpm", rpm(slowest), rpm(fastest)),
    };
    Some(format!(
        "The engine would run {at}, outside of the {:.0} to {:.0} rpm for which its torque is given.",
        rpm(low),
        rpm(high)
    ))
}

/// What a belt sinks on a primary that is open, m.
pub(super) const SUNK: f64 = 1e-4;

/// A sentence where a primary would have to stand farther open than it can, its travel in m being negative: the belt
/// has sunk below the radius at which the sheaves are open, as where it slips like a clutch.
pub fn beyond_open(primary_travel: f64) -> Option<String> {
    (primary_travel < -SUNK).then(|| {
        format!(
            "The belt has sunk below the radius at which the primary is open, as if that stood {:.2} mm farther open: \
             a belt that slips like a clutch is not what the model is for.",
            -1e3 * primary_travel
        )
    })
}
