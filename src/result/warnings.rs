//! What is to be known before a result is used.

use super::Outcome;
use super::answers::Light;
use super::doubt::{adheres_nowhere, is_buckled, is_driven_on_both_sides};
use super::schema::Pulley;
use crate::drive::{Branch, Compressed, PowerFlow, RegionId};
use crate::model::{Constant, State};
use crate::quantity::{ZERO_CELSIUS, celsius};

/// Share of the deepest penetration by which another may be negative before it is said: the ends' defects are.
const NEGATIVE: f64 = 1e-3;
/// Share of the power that nothing accounts for before it is said.
const UNACCOUNTED: f64 = 0.01;
/// Share of the belt's length by which the drive's may differ before it is said.
const LENGTH_ERROR: f64 = 0.005;
/// Penetration over radius beyond which the belt no longer lies at its nominal radius.
const DEEP: f64 = 0.3;

/// Temperature, K, up to which a maker of belts promises a long life: 71 °C.
pub(crate) const HOT: f64 = 71.0 + ZERO_CELSIUS;

/// What a careful reader of the result would want to know first; nothing for a healthy drive.
pub fn warnings(outcome: &Outcome) -> Vec<String> {
    let mut said = Vec::new();
    said.extend(two_solutions(outcome));
    said.extend(adhesion(outcome));
    said.extend(powers(outcome));
    said.extend(compression(outcome));
    said.extend(buckled(outcome.result.primary.wrap_angle, outcome.result.secondary.wrap_angle));
    for (name, region) in [("primary", RegionId::Primary), ("secondary", RegionId::Secondary)] {
        said.extend(pulled(name, &states(outcome, region, State::Penetration)));
    }
    let result = &outcome.result;
    said.extend(deep("primary", &result.primary));
    said.extend(deep("secondary", &result.secondary));
    said.extend(length(outcome));
    said.extend(energy(outcome));
    said.extend(outcome.no_losses.map(|reason| format!("No losses besides friction are told: {reason}.")));
    said.extend(overtaken(outcome));
    said.extend(hot(outcome));
    said.extend(beyond_tables(outcome));
    said
}

/// An axial force that belongs to two operating points.
fn two_solutions(outcome: &Outcome) -> Option<String> {
    let other = outcome.result.other_solution?;
    let tension = outcome.solved.constant(Constant::SlackTension);
    let (key, force) = outcome.result.inputs.operating_point.clamp.setting();
    let which = if tension > other.slack_tension { Branch::Tight } else { Branch::Loose };
    let wanted = if which == Branch::Tight { Branch::Loose } else { Branch::Tight };
    Some(format!(
        "`{}` = {force:.2} N belongs to two operating points: this one, the {} one, at {tension:.2} N of slack \
         tension, where {:.1} % of the friction at hand is used, and another at {:.2} N, where {:.1} % is. `--branch \
         {}` gives the other.",
        key.path(),
        which.name(),
        100.0 * outcome.result.friction_utilization,
        other.slack_tension,
        100.0 * other.friction_utilization,
        wanted.name(),
    ))
}

/// Losses that take more than the belt brings: nothing would arrive, and the drive would not turn as was given.
fn overtaken(outcome: &Outcome) -> Option<String> {
    let losses = outcome.result.losses.as_ref().filter(|losses| losses.power_out < 0.0)?;
    let energy = &outcome.result.energy;
    let brought = match PowerFlow::of(energy.power_in, energy.power_out) {
        PowerFlow::FromSecondary => -energy.power_in,
        PowerFlow::FromPrimary | PowerFlow::IntoBoth | PowerFlow::Neither => energy.power_out,
    };
    (brought > 0.0).then(|| {
        format!(
            "Losses besides friction take {:.0} W, and the belt brings {brought:.0} W: nothing arrives. Check the \
             units of the drags and of what the belt's losses are made of.",
            losses.total
        )
    })
}

/// A belt that will not last.
fn hot(outcome: &Outcome) -> Option<String> {
    let temperature = outcome.result.belt.temperature.filter(|temperature| *temperature > HOT)?;
    let celsius = celsius(temperature);
    Some(format!("The belt is hot: {celsius:.1} °C, above the 71 °C up to which it lasts long."))
}

/// A temperature at which nothing was measured.
fn beyond_tables(outcome: &Outcome) -> Option<String> {
    let inputs = &outcome.result.inputs;
    let temperature = outcome.result.belt.temperature.unwrap_or(inputs.stiffnesses.reference);
    let tables = inputs.stiffnesses.tables().chain(inputs.losses.tables());
    let (key, (low, high)) = tables
        .filter_map(|(key, grid)| Some((key, grid.temperatures()?)))
        .find(|(_, (low, high))| !(*low..=*high).contains(&temperature))?;
    Some(format!(
        "The belt's temperature, {:.1} °C, is beyond those at which `{}` was measured, {:.1} to {:.1} °C: stiffnesses \
         go on as they fell at the nearest, loss tangents stay as they were there.",
        celsius(temperature),
        key.path(),
        celsius(low),
        celsius(high)
    ))
}

/// A state at the nodes of a region.
fn states(outcome: &Outcome, region: RegionId, state: State) -> Vec<f64> {
    let at = outcome.solved.belt.kernel(region).state(state);
    let part = outcome.solved.solution.regions().get(region.index());
    at.and_then(|at| Some(part?.state(at).to_vec())).unwrap_or_default()
}

fn adhesion(outcome: &Outcome) -> Option<String> {
    let (primary, secondary) = (&outcome.result.primary, &outcome.result.secondary);
    adheres_nowhere(primary, secondary).then(|| {
        let slowest = primary.min_sliding_speed.min(secondary.min_sliding_speed);
        let threshold = outcome.result.inputs.sheave.slip_threshold;
        let sliding = format!("(slowest sliding {slowest:.2e} m/s, threshold {threshold:.0e} m/s)");
        match Light::of(outcome.result.slip_reserve) {
            Light::Green => format!(
                "The belt adheres on neither pulley {sliding}, though {:.0} % of the friction at hand is in reserve: \
                 it slides into its grooves and out of them all along. A belt that bends more easily adheres again.",
                100.0 * outcome.result.slip_reserve
            ),
            Light::Amber | Light::Red => format!(
                "Little slip reserve: the belt adheres on neither pulley {sliding}. More clamping brings adhesion back."
            ),
        }
    })
}

/// Powers that no drive has at work: one that has to be driven from both sides, or gives more than it takes.
fn powers(outcome: &Outcome) -> Option<String> {
    let energy = &outcome.result.energy;
    let (power_in, power_out) = (energy.power_in, energy.power_out);
    if is_driven_on_both_sides(energy) {
        return Some(format!(
            "The secondary has to be driven: {power_in:.1} W into the primary do not cover the losses, and {:.1} W go \
             into the secondary; there is no efficiency to tell. The belt is clamped too tightly for so little torque, \
             or it is too stiff.",
            -power_out
        ));
    }
    let (driving, driven) = if power_in >= 0.0 { (power_in, power_out) } else { (-power_out, -power_in) };
    (driving >= 0.0 && driven > driving).then(|| {
        format!(
            "More power out than in: {driven:.1} W of {driving:.1} W; no drive does that. Use `edition = \
             \"consistent\"`, in which energy is conserved."
        )
    })
}

/// A belt that is pushed somewhere, which a belt does not bear: by its whole tension, or by the tractive one, without
/// what the belt's own inertia adds.
fn compression(outcome: &Outcome) -> Option<String> {
    let Compressed { region, tension } = Compressed::of(&outcome.solved.belt, &outcome.solved.solution)?;
    let place = region.place();
    let centrifugal = outcome.result.belt.mass_flow.powi(2) / outcome.result.inputs.belt.mass_per_length;
    let whole = tension + centrifugal;
    let consequence = if whole < 0.0 {
        format!("The belt is in compression {place}: its tension falls to {whole:.1} N there, of which")
    } else {
        format!("The belt is held {place} by its speed alone: of a tension of {whole:.1} N")
    };
    Some(format!(
        "{consequence} {tension:.1} N are tractive and {centrifugal:.1} N centrifugal. A belt buckles or jumps at such \
         a place; clamp it tighter, or use one that bends more easily."
    ))
}

/// A belt that is wound round its pulleys as none is whose spans are nearly straight.
fn buckled(primary_wrap: f64, secondary_wrap: f64) -> Option<String> {
    let wrap = primary_wrap + secondary_wrap;
    is_buckled(primary_wrap, secondary_wrap).then(|| {
        format!(
            "The belt buckles: it is wound round both pulleys by {:.0}° in all, and its spans turn back what is more \
             than 360°. No drive has such a belt; clamp it tighter, or ask for less torque.",
            wrap.to_degrees()
        )
    })
}

/// A belt that lies much deeper than the radius at which it is said to lie.
fn deep(name: &str, pulley: &Pulley) -> Option<String> {
    let share = pulley.max_penetration / pulley.radius;
    (share > DEEP).then(|| {
        format!(
            "The belt is pressed {:.1} mm into the {name}, {:.0} % of its radius: more than the model, or a belt, \
             bears. Check belt.radial_stiffness, belt.bending_stiffness and the clamp.",
            1e3 * pulley.max_penetration,
            100.0 * share
        )
    })
}

fn length(outcome: &Outcome) -> Option<String> {
    let (belt, length) = (&outcome.result.belt, outcome.result.inputs.belt.length);
    (belt.length_error.abs() > LENGTH_ERROR * length).then(|| {
        format!(
            "The belt does not fit: this drive needs {:.1} mm, the belt has {:.1} mm unstretched. The radii hold; with \
             `drive.free` one of them follows from the belt.",
            1e3 * belt.unstretched_length,
            1e3 * length
        )
    })
}

fn energy(outcome: &Outcome) -> Option<String> {
    let energy = &outcome.result.energy;
    let missing = energy.power_in - energy.power_out - energy.friction_loss - energy.stretch_work;
    // Of the largest, which is not that into the primary where the secondary drives or no torque is asked for.
    let powers = [(energy.power_in, "in"), (energy.power_out, "out"), (energy.friction_loss, "of friction")];
    let powers = powers.into_iter().map(|(power, what)| (power.abs(), what));
    let (passing, what) = powers.reduce(|one, other| if other.0 > one.0 { other } else { one })?;
    (missing.abs() > UNACCOUNTED * passing).then(|| {
        format!(
            "Energy is not conserved: {missing:.1} W of {passing:.1} W {what} ({:.1} %) go where neither friction nor \
             stretch explains it; this is the doing of the equations of edition `{}`.",
            100.0 * missing / passing,
            outcome.result.edition
        )
    })
}

/// A pulley that would have to pull the belt into its groove, by the penetrations along its contact.
fn pulled(pulley: &str, penetration: &[f64]) -> Option<String> {
    let [lowest, deepest] = [f64::min, f64::max].map(|extreme| penetration.iter().copied().fold(0.0, extreme));
    (lowest < -NEGATIVE * deepest).then(|| {
        format!(
            "Negative penetration on the {pulley}: down to {:.4} mm, where the groove would have to pull the belt in.",
            1e3 * lowest
        )
    })
}

#[cfg(test)]
mod tests {
    use super::{buckled, pulled};

    /// No drive was found that does it: those of 1 to 18 N·m, up to 9500 rpm, with EI up to 1 N·m² do not.
    #[test]
    fn a_groove_that_pulls_is_told_from_rounding_at_the_ends() {
        assert_eq!(pulled("primary", &[-1e-9, 4e-4, 7e-4, 0.0]), None);
        assert_eq!(pulled("primary", &[]), None);
        let said = pulled("secondary", &[0.0, 7e-4, -2e-5, 0.0]);
        assert!(said.is_some_and(|said| said.contains("on the secondary") && said.contains("-0.0200 mm")));
    }

    /// Met in engine braking, beyond the limit of a drive, and on pulleys of soft grooves.
    #[test]
    fn a_belt_that_is_wound_round_its_pulleys_has_buckled() {
        let told = |degrees: [f64; 2]| buckled(degrees[0].to_radians(), degrees[1].to_radians());
        assert_eq!(told([150.0, 200.0]), None);
        assert_eq!(told([182.0, 184.0]), None);
        assert!(told([260.0, 277.0]).is_some_and(|said| said.contains("537° in all")));
    }
}
