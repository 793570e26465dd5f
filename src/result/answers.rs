//! What an engineer asks first of a solved drive.

use std::fmt::Write;

use super::doubt::Doubt;
use super::schema::DriveResult;
use super::units::{Measured, Units};
use crate::case::{Key, Resolved};
use crate::drive::PowerFlow;

/// Share of the friction at hand that ought to be left over; below, a drive is at the mercy of dust and damp.
pub const WANTED_RESERVE: f64 = 0.2;
/// Share below which the belt is about to slip as a whole.
const SCANT_RESERVE: f64 = 0.05;

/// How a drive stands against slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Light {
    /// The reserve is at least [`WANTED_RESERVE`].
    Green,
    /// There is a reserve, and not much.
    Amber,
    /// Nearly all friction is used: a little more torque, or a little less friction, and the belt slips.
    Red,
}

impl Light {
    /// By the share of the friction at hand that is left over.
    pub fn of(slip_reserve: f64) -> Self {
        match slip_reserve {
            reserve if reserve >= WANTED_RESERVE => Self::Green,
            reserve if reserve >= SCANT_RESERVE => Self::Amber,
            _ => Self::Red,
        }
    }

    /// By that share, and by what else keeps a drive from being sound: that is amber at best.
    pub fn of_drive<I>(result: &DriveResult<I>) -> Self {
        if doubt(result).is_some() { Self::Amber } else { Self::of(result.slip_reserve) }
    }

    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Green => "green: it does not slip",
            Self::Amber => "amber: it holds with little to spare",
            Self::Red => "red: it slips, or is about to",
        }
    }
}

/// A question and its answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Short, as a heading.
    pub question: &'static str,
    /// One line.
    pub answer: String,
}

/// Does it slip, where do the watts go, what clamp does it take, what are the radii, and what was solved for.
pub fn answers(result: &DriveResult<Resolved>) -> Vec<Answer> {
    answers_in(Units::Workshop, result)
}

/// As [`answers`], in other units.
pub fn answers_in(units: Units, result: &DriveResult<Resolved>) -> Vec<Answer> {
    let mut answers = vec![
        Answer { question: "does it slip?", answer: slip(result) },
        Answer { question: "where do the watts go?", answer: watts(units, result) },
        Answer { question: "what clamp?", answer: clamp(units, result) },
        Answer { question: "radii and ratio", answer: radii(units, result) },
    ];
    answers.extend(found(result).map(|answer| Answer { question: "solved for", answer }));
    answers
}

/// What is to be said of a drive that has friction enough in reserve, and is not sound.
fn doubt<I>(result: &DriveResult<I>) -> Option<Doubt> {
    Doubt::about(result).filter(|_| Light::of(result.slip_reserve) == Light::Green)
}

/// How a drive stands against slip.
pub(crate) fn slip<I>(result: &DriveResult<I>) -> String {
    let words = match doubt(result) {
        Some(doubt) => format!("amber: it does not slip, but {}", doubt.words()),
        None => Light::of(result.slip_reserve).words().to_owned(),
    };
    format!("{words}; {:.1} % of the friction at hand is in reserve", 100.0 * result.slip_reserve)
}

fn watts(units: Units, result: &DriveResult<Resolved>) -> String {
    let energy = &result.energy;
    let [primary, secondary] = [&result.primary, &result.secondary].map(|pulley| pulley.friction_loss);
    let show = |power: f64| units.show(Measured::Power, power, 0);
    let driving = if PowerFlow::of(energy.power_in, energy.power_out) == PowerFlow::FromSecondary {
        format!("{} from the secondary, {} to the primary", show(-energy.power_out), show(-energy.power_in))
    } else {
        format!("{} in, {} out", show(energy.power_in), show(energy.power_out))
    };
    let total = primary + secondary;
    let besides = result
        .losses
        .as_ref()
        .map_or(String::new(), |losses| format!("; besides, {} of hysteresis, drag and gears", show(losses.total)));
    format!(
        "{driving}; {} of friction, {} on the primary and {} on the secondary{besides}",
        show(total),
        show(primary),
        show(secondary)
    )
}

fn clamp(units: Units, result: &DriveResult<Resolved>) -> String {
    let (primary, secondary) = (&result.primary, &result.secondary);
    let show = |force: f64| units.show(Measured::Force, force, 0);
    let mut text = format!(
        "{} axial on the primary, {} on the secondary, {} slack tension",
        show(primary.axial_force),
        show(secondary.axial_force),
        show(primary.exit_tension)
    );
    if let Some(tension) = tension_for(result, WANTED_RESERVE) {
        let (percent, tension) = (100.0 * WANTED_RESERVE, show(rounded(tension)));
        let _ =
            write!(text, "; for {percent:.0} % reserve about {tension} slack (--reserve {percent:.0}% solves for it)");
    }
    text
}

/// The slack tension at which about `reserve` of the friction at hand is left over, N, for the same torque: the
/// pressure, and with it the friction at hand, goes with the mean tension less the centrifugal one. Nothing if the
/// drive has that reserve already, or without torque.
pub fn tension_for(result: &DriveResult<Resolved>, reserve: f64) -> Option<f64> {
    let primary = &result.primary;
    let (used, wanted) = (1.0 - result.slip_reserve, 1.0 - reserve);
    let centrifugal = result.belt.mass_flow.powi(2) / result.inputs.belt.mass_per_length;
    let carried = primary.entry_tension - primary.exit_tension;
    let pressing = 0.5 * (primary.entry_tension + primary.exit_tension) - centrifugal;
    let tension = pressing * used / wanted + centrifugal - 0.5 * carried;
    (used > wanted && carried != 0.0 && tension.is_finite() && tension > primary.exit_tension).then_some(tension)
}

/// To two digits: an estimate is not better.
fn rounded(value: f64) -> f64 {
    let unit = libm::pow(10_f64, libm::log10(value).floor() - 1.0);
    (value / unit).round() * unit
}

fn radii(units: Units, result: &DriveResult<Resolved>) -> String {
    let (primary, secondary) = (&result.primary, &result.secondary);
    format!(
        "{} and {}, ratio {:.4}; {} and {}, speed ratio {:.4}",
        units.show(Measured::Length, primary.radius, 2),
        units.show(Measured::Length, secondary.radius, 2),
        secondary.radius / primary.radius,
        units.of(Measured::Speed).number(primary.speed, 0),
        units.show(Measured::Speed, secondary.speed, 0),
        secondary.speed / primary.speed,
    )
}

/// Every value that was found for a key, in the key's own unit.
fn found(result: &DriveResult<Resolved>) -> Option<String> {
    let value = |(path, si): (&String, &f64)| {
        let (number, unit) = Key::from_path(path).map_or((*si, String::new()), |key| key.entry().readable(*si));
        format!("{path} = {number:.6} {unit}").trim_end().to_owned()
    };
    let all: Vec<String> = result.found.iter().map(value).collect();
    (!all.is_empty()).then(|| all.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lights_change_at_their_reserves() {
        let lights = [0.9, 0.2, 0.199, 0.05, 0.049, 0.0, -0.1, f64::NAN].map(Light::of);
        use Light::{Amber, Green, Red};
        assert_eq!(lights, [Green, Green, Amber, Amber, Red, Red, Red, Red]);
    }
}
