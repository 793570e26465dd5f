//! Random designs of drives from scooters to snowmobiles.

use sheave::case::{Case, Resolved};
use sheave::random::Random;

const SLACK_TENSION: &str = "operating_point.slack_tension";
const TORQUE: &str = "operating_point.primary_torque";
/// Least radius of a design, m: that of a scooter's primary.
const LEAST_RADIUS: f64 = 0.018;

/// Key, from, to, and whether the logarithm is uniform.
const AXES: [(&str, f64, f64, bool); 11] = [
    ("belt.longitudinal_stiffness", 5e4, 8e5, true),
    ("belt.bending_stiffness", 0.005, 1.5, true),
    ("belt.radial_stiffness", 5e6, 60e6, true),
    ("belt.mass_per_length", 0.1, 1.0, true),
    ("sheave.half_angle", 0.139_626, 0.349_066, false),
    ("sheave.friction_coefficient", 0.2, 0.7, false),
    ("sheave.slip_threshold", 1e-5, 1e-2, true),
    ("operating_point.primary_speed", 31.4159, 942.478, false),
    (TORQUE, -40.0, 60.0, false),
    (SLACK_TENSION, 20.0, 1500.0, true),
    ("drive.center_distance", 0.15, 0.35, false),
];

/// A design: keys and values in SI.
pub type Design = Vec<(&'static str, f64)>;

fn value(design: &Design, key: &str) -> f64 {
    design.iter().find(|(other, _)| *other == key).map_or(f64::NAN, |(_, value)| *value)
}

/// The design `index` of a seed: radii of a ratio from 0.4 to 3.5 that stand apart.
pub fn design(seed: u64, index: u64) -> Design {
    let mut stream = Random::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ index);
    let mut design: Design = AXES.map(|(key, from, to, log)| (key, stream.between(from, to, log))).to_vec();
    let center = design.last().map_or(0.0, |(_, center)| *center);
    let (primary, secondary) = loop {
        let ratio = stream.between(0.4, 3.5, true);
        let sum = center * stream.between(0.45, 0.85, false);
        let (primary, secondary) = (sum / (1.0 + ratio), sum * ratio / (1.0 + ratio));
        if primary.min(secondary) >= LEAST_RADIUS {
            break (primary, secondary);
        }
    };
    design.push(("drive.primary_radius", primary));
    design.push(("drive.secondary_radius", secondary));
    // The tension of the axis is that of the looser strand, which in engine braking is not the one that leaves the
    // primary.
    let torque = value(&design, TORQUE);
    if let Some((_, tension)) = design.iter_mut().find(|(key, _)| *key == SLACK_TENSION) {
        *tension += (-torque / primary).max(0.0);
    }
    // The belt that closes.
    let slope = ((secondary - primary) / center).asin();
    let spans = 2.0 * center * slope.cos();
    let arcs = std::f64::consts::PI * (primary + secondary) + 2.0 * slope * (secondary - primary);
    design.push(("belt.length", spans + arcs));
    design
}

/// The case of a design.
///
/// # Errors
/// The refusal of its geometry.
pub fn case(edition: &str, design: &Design) -> Result<Resolved, String> {
    let mut case = Case::default();
    case.set("edition", edition).map_err(|error| error.to_string())?;
    for (key, value) in design {
        case.set(key, &value.to_string()).map_err(|error| error.to_string())?;
    }
    case.resolve().map_err(|error| error.to_string())
}

/// A design as options of the command line.
pub fn settings(design: &Design) -> String {
    design.iter().map(|(key, value)| format!("--set {key}={value:.6e}")).collect::<Vec<_>>().join(" ")
}
