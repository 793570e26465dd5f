//! What is to be known before a result is used.

use super::Outcome;
use crate::drive::RegionId;

/// Share of a contact in adhesion, both pulleys together, below which the drive is near gross slip.
const LITTLE_ADHESION: f64 = 0.02;
/// Share of the deepest penetration by which another may be negative before it is said: the ends' defects are.
const NEGATIVE: f64 = 1e-3;
/// Share of the power that may go missing before it is said.
const IMBALANCE: f64 = 0.01;
/// Share of the belt's length by which the drive's may differ before it is said.
const LENGTH_ERROR: f64 = 0.005;

/// Zero of the Celsius scale, K.
const CELSIUS: f64 = 273.15;
/// Temperature, K, up to which a maker of belts promises a long life: 71 °C.
const HOT: f64 = 71.0 + CELSIUS;

/// What a careful reader of the result would want to know first; nothing for a healthy drive.
pub fn warnings(outcome: &Outcome) -> Vec<String> {
    let result = &outcome.result;
    let mut said = Vec::new();
    let threshold = result.inputs.sheave.slip_threshold;
    if result.primary.adhesion_fraction < LITTLE_ADHESION && result.secondary.adhesion_fraction < LITTLE_ADHESION {
        let slowest = result.primary.min_sliding_speed.min(result.secondary.min_sliding_speed);
        said.push(format!(
            "Little slip reserve: the belt adheres on neither pulley (slowest sliding {:.2e} m/s, threshold {threshold:.0e} m/s). \
             More clamping brings adhesion back.",
            slowest
        ));
    }
    for (name, region) in [("primary", RegionId::Primary), ("secondary", RegionId::Secondary)] {
        let at = outcome.solved.belt.kernel(region).states.iter().position(|symbol| symbol.name == "x");
        let part = outcome.solved.solution.regions().get(region.index());
        let x = at.and_then(|at| Some(part?.state(at))).unwrap_or_default();
        said.extend(pulled(name, x));
    }
    let (belt, length) = (&result.belt, result.inputs.belt.length);
    if belt.length_error.abs() > LENGTH_ERROR * length {
        said.push(format!(
            "The belt does not fit: this drive needs {:.1} mm, the belt has {:.1} mm unstretched.",
            1e3 * belt.unstretched_length,
            1e3 * length
        ));
    }
    if let Some(reason) = outcome.no_losses {
        said.push(format!("No losses besides friction are told: {reason}."));
    }
    if let Some(temperature) = result.belt.temperature.filter(|temperature| *temperature > HOT) {
        said.push(format!(
            "The belt is hot: {:.1} °C, above the 71 °C up to which it lasts long.",
            temperature - CELSIUS
        ));
    }
    let imbalance = result.energy.imbalance;
    if imbalance.abs() > IMBALANCE {
        said.push(format!(
            "Energy is not conserved: {:.1} W of {:.1} W in ({:.1} %) go where no friction explains it; this is the \
             edition's doing.",
            imbalance * result.energy.power_in,
            result.energy.power_in,
            100.0 * imbalance
        ));
    }
    said
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
    use super::pulled;

    /// No drive was found that does it: those of 1 to 18 N·m, up to 9500 rpm, with EI up to 1 N·m² do not.
    #[test]
    fn a_groove_that_pulls_is_told_from_rounding_at_the_ends() {
        assert_eq!(pulled("primary", &[-1e-9, 4e-4, 7e-4, 0.0]), None);
        assert_eq!(pulled("primary", &[]), None);
        let said = pulled("secondary", &[0.0, 7e-4, -2e-5, 0.0]);
        assert!(said.is_some_and(|said| said.contains("on the secondary") && said.contains("-0.0200 mm")));
    }
}
