//! What is worth knowing of a whole drive beside its numbers.

use super::report::DriveReport;
use crate::actuator::{Mechanism, PrimaryActuator, SecondaryActuator};
use crate::case::{Case, Key, Resolved};
use crate::quantity::{ZERO_CELSIUS, celsius, rpm};
use crate::result::{Doubt, HOT};

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
fn beyond_open(primary_travel: f64) -> Option<String> {
    (primary_travel < -SUNK).then(|| {
        format!(
            "The belt has sunk below the radius at which the primary is open, as if that stood {:.2} mm farther open: \
             a belt that slips like a clutch is not what the model is for.",
            -1e3 * primary_travel
        )
    })
}

/// What there is to say of the equilibria of a shift curve together: where the sheaves stand, as [`beyond_travel`] says
/// it, between which speeds of the secondary the belt is none that is sound, and how hot it becomes.
pub fn over_curve<'a>(case: &Resolved, reports: impl IntoIterator<Item = &'a DriveReport>) -> Vec<String> {
    let reports: Vec<&DriveReport> = reports.into_iter().collect();
    let mut said = beyond_travel(case, reports.iter().map(|report| (report.primary_travel, report.secondary_travel)));
    said.extend(Doubt::ALL.into_iter().filter_map(|doubt| doubtful(doubt, &reports)));
    said.extend(hot(&reports));
    said
}

/// A sentence about the points of a shift curve that are doubtful in one way, and do not slip besides.
fn doubtful(doubt: Doubt, reports: &[&DriveReport]) -> Option<String> {
    let speeds = || reports.iter().filter(|report| report.doubt == Some(doubt) && !report.slipping);
    let speeds = || speeds().map(|report| report.secondary_speed);
    let (slowest, fastest) = (speeds().reduce(f64::min)?, speeds().reduce(f64::max)?);
    let what = match doubt {
        Doubt::Buckled => "the belt buckles: it is wound round both pulleys as no belt is",
        Doubt::Pushed => "a strand of the belt is pushed: held by its speed alone, a belt buckles or jumps there",
        Doubt::Driven => "both pulleys have to be driven: what the engine gives does not cover the losses",
        Doubt::Sliding => "the belt adheres on neither pulley: it slides into its grooves and out of them all along",
    };
    Some(format!(
        "At {} of {} points, with the secondary at {}, {what}.",
        speeds().count(),
        reports.len(),
        between(rpm(slowest), rpm(fastest))
    ))
}

/// Speeds in rpm as a sentence has them.
fn between(slowest: f64, fastest: f64) -> String {
    let (slowest, fastest) = (format!("{slowest:.0}"), format!("{fastest:.0}"));
    if slowest == fastest { format!("{slowest} rpm") } else { format!("{slowest} to {fastest} rpm") }
}

/// A sentence about a belt that will not last.
fn hot(reports: &[&DriveReport]) -> Option<String> {
    let temperatures = || reports.iter().filter_map(|report| report.belt_temperature).filter(|warm| *warm > HOT);
    let hottest = temperatures().reduce(f64::max)?;
    Some(format!(
        "The belt is hot at {} of {} points, up to {:.1} °C: above the {:.0} °C up to which it lasts long.",
        temperatures().count(),
        reports.len(),
        celsius(hottest),
        HOT - ZERO_CELSIUS
    ))
}

/// What there is to say of where the sheaves of whole drives stand, by the travels in m of the primary and of the
/// secondary: of the primary that is farthest open, where that is farther than it can; and of parts whose tables end
/// before.
pub fn beyond_travel(case: &Resolved, travels: impl IntoIterator<Item = (f64, f64)>) -> Vec<String> {
    let travels: Vec<(f64, f64)> = travels.into_iter().collect();
    let open = travels.iter().map(|(primary, _)| *primary).reduce(f64::min).and_then(beyond_open);
    open.into_iter().chain(beyond_parts(case, &travels)).collect()
}

/// A sentence for each part whose table does not reach as far as its sheave travels, by the travels in m of the primary
/// and of the secondary: beyond its ends a table goes on as straight as it ends.
fn beyond_parts(case: &Resolved, travels: &[(f64, f64)]) -> Vec<String> {
    /// Share of a table's length by which a travel may lie beyond its ends.
    const BESIDE: f64 = 0.02;
    let Some(actuation) = &case.parts.actuation else { return Vec::new() };
    let flyweights = match &actuation.primary {
        PrimaryActuator::Flyweights { flyweights, .. } => match &flyweights.mechanism {
            Mechanism::Coefficient { coefficient: table, .. } | Mechanism::Ramp { radius: table, .. } => {
                Some(table.domain())
            }
            Mechanism::RollerArm(_) | Mechanism::CamArm(_) => None,
        },
        PrimaryActuator::Force(_) | PrimaryActuator::Position(_) => None,
    };
    let helix = match &actuation.secondary {
        SecondaryActuator::Helix { helix, .. } => Some(helix.openings()),
        SecondaryActuator::Force(_) => None,
    };
    let told = |key: Key, table: Option<(f64, f64)>, of: fn(&(f64, f64)) -> f64| {
        let (first, last) = table?;
        // A belt that has sunk below the radius at which the primary is open is another matter.
        let reached = || travels.iter().map(|pair| of(pair).max(0.0));
        let (least, most) = (reached().reduce(f64::min)?, reached().reduce(f64::max)?);
        let beside = BESIDE * (last - first);
        (least < first - beside || most > last + beside).then(|| {
            let [first, last, least, most] = [first, last, least, most].map(|at| format!("{:.2}", 1e3 * at));
            let stands =
                if least == most { format!("stands at {most}") } else { format!("travels from {least} to {most}") };
            format!(
                "`{}` is given from {first} to {last} mm, and the sheave {stands} mm: beyond its ends the table goes \
                 on as straight as it ends.",
                key.path()
            )
        })
    };
    let primary = told(Key::FlyweightTravels, flyweights, |pair| pair.0);
    primary.into_iter().chain(told(Key::HelixOpenings, helix, |pair| pair.1)).collect()
}
