//! A made data set: logs as a test stand would write them, from the model with known constants. Whoever reads it back
//! knows what should come out.

use super::compare::REPLACED;
use super::engine::EngineCurve;
use super::error::{BenchError, BenchProblem};
use crate::case::geometry::radii_of_ratio;
use crate::case::{Case, Free, Include, Key};
use crate::drive::{Constant, SolveOptions};
use crate::quantity::{Unit, rpm};
use crate::random::Random;
use crate::result;
use serde::Serialize;
use std::f64::consts::TAU;
use std::fmt::Write;

/// What is known of the data.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Known {
    /// Factor of the true engine's power on that of the curve.
    pub engine_scale: f64,
    /// ADC per N·m.
    pub slope: f64,
    /// ADC without torque.
    pub intercept: f64,
    /// Operating points, SI.
    pub steps: Vec<Step>,
}

/// A true operating point, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Step {
    /// R_S/R_P.
    pub ratio: f64,
    /// rad/s.
    pub primary_speed: f64,
    /// rad/s.
    pub secondary_speed: f64,
    /// N·m.
    pub primary_torque: f64,
    /// That which arrives, N·m: without what losses besides friction take, if the case asks for them.
    pub secondary_torque: f64,
    /// The model's, with the same losses.
    pub efficiency: f64,
}

/// What disturbs the logs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Disturbance {
    /// Standard deviation of the torque's noise, N·m.
    pub torque_noise: f64,
    /// Standard deviation of a speed's noise, share of the speed.
    pub speed_noise: f64,
    /// Amplitude of the firing in the torque, share of the torque.
    pub firing: f64,
    /// Amplitude of the brake's shaft in the torque, share of the torque.
    pub shaft: f64,
    /// Probability that the slip ring lifts off in a sample; it then stays off for a few.
    pub dropout: f64,
    /// Probability that a row is garbled on its way: a flipped bit that the checksum misses, or broken text.
    pub transmission: f64,
}

impl Default for Disturbance {
    fn default() -> Self {
        Self { torque_noise: 0.6, speed_noise: 0.002, firing: 0.25, shaft: 0.08, dropout: 0.004, transmission: 0.003 }
    }
}

/// Calibration of the made sensor: that of the thesis (9.1).
const SLOPE: f64 = 108.19;
const INTERCEPT: f64 = 35_145.0;
/// Teeth of the secondary's gear over those of the brake's (section 8.1).
const GEAR: f64 = 32.0 / 61.0;
/// Polls of the logger, and conversions, in a second (sections 8.2.2 and 9.1).
const POLLS: f64 = 150.0;
const CONVERSIONS: f64 = 125.0;
/// Time of a step and between steps, s (section 9.1).
const READ: f64 = 3.0;
const SETTLE: f64 = 4.0;
/// µs on the counter when the first step begins: it wraps in the third.
const BEGIN: f64 = 4_294_967_296.0 - 15.2e6;

/// Solves the model at `steps` ratios from `high` to `low` range, the engine a little slower in low range, and its
/// power `engine_scale` times that of the curve.
///
/// # Errors
/// Points that the case has no solution for ([`BenchProblem::NoSolution`]), or at which the engine's curve has no
/// power.
pub fn truth(
    case: &Case,
    engine: &EngineCurve,
    engine_scale: f64,
    (low, high): (f64, f64),
    steps: usize,
) -> Result<Known, BenchError> {
    let mut known = Known { engine_scale, slope: SLOPE, intercept: INTERCEPT, steps: Vec::new() };
    for at in 0..steps {
        let share = at as f64 / (steps.max(2) - 1) as f64;
        let ratio = high + share * (low - high);
        let primary_speed = Unit::RPM.to_si(3250.0 - 450.0 * share);
        let path = || format!("step {at}, ratio {ratio:.3}");
        let fails = |reason: String| BenchError::from(BenchProblem::Unusable { path: path(), reason });
        let unsolved = |reason: String| BenchError::from(BenchProblem::NoSolution { path: path(), reason });
        let power = engine.power(primary_speed).map(|(power, _)| engine_scale * power).filter(|power| *power > 0.0);
        let (first, last) = engine.range();
        let missing = || {
            let speed = rpm(primary_speed);
            fails(format!(
                "the engine's curve, from {first:.0} to {last:.0} rpm, has no power at the {speed:.0} rpm of this step"
            ))
        };
        let power = power.ok_or_else(missing)?;
        let mut point = case.clone();
        for key in REPLACED {
            point.unset(key.path()).map_err(|error| fails(error.to_string()))?;
        }
        // The radii are those of the belt's length, which the tensions stretch: one of them is given, the other free.
        let resolved = case.resolve().map_err(|error| fails(error.to_string()))?;
        let nominal = radii_of_ratio(ratio, resolved.belt.length, resolved.drive.center_distance);
        let (primary_radius, _) = nominal.map_err(|error| fails(error.to_string()))?;
        let values = [
            (Key::PrimarySpeed, primary_speed),
            (Key::PrimaryTorque, power / primary_speed),
            (Key::PrimaryRadius, primary_radius),
        ];
        let free = point.set(Key::Free.path(), Free::SecondaryRadius.name());
        free.map_err(|error| fails(error.to_string()))?;
        for (key, value) in values {
            point.set_si(key, value).map_err(|error| fails(error.to_string()))?;
        }
        let resolved = point.resolve().map_err(|error| fails(error.to_string()))?;
        let outcome = result::run(&resolved, &SolveOptions { tolerance: 1e-5, ..SolveOptions::default() });
        let outcome = outcome.map_err(|failure| {
            if failure.is_cancelled() { BenchProblem::Cancelled.into() } else { unsolved(failure.to_string()) }
        })?;
        let result = outcome.result;
        let elastic = result.efficiency.overall;
        let elastic = elastic.ok_or_else(|| unsolved("the drive takes power from its output".into()))?;
        // What arrives at the brake is what losses besides friction leave.
        let efficiency = match (resolved.losses.include, result.efficiency.overall_with_losses) {
            (Some(Include::On), Some(efficiency)) => efficiency,
            (Some(Include::On), None) => {
                let reason = outcome.no_losses.map(|reason| reason.to_string());
                return Err(unsolved(reason.unwrap_or_else(|| "nothing is left of its power after the losses".into())));
            }
            (Some(Include::Off) | None, _) => elastic,
        };
        known.steps.push(Step {
            ratio: outcome.solved.constant(Constant::SecondaryRadius) / primary_radius,
            primary_speed,
            secondary_speed: result.secondary.speed,
            primary_torque: result.primary.torque,
            secondary_torque: result.secondary.torque * efficiency / elastic,
            efficiency,
        });
    }
    Ok(known)
}

/// Kinds of the files of a step.
const KINDS: [&str; 3] = ["P", "S", "ADC"];
/// The file with the calibration.
const CALIBRATION: &str = "calibration.csv";

fn name(kind: &str, step: usize) -> String {
    format!("{kind}_{step}.csv")
}

/// The names of the files of a test with so many steps.
pub fn names(steps: usize) -> Vec<String> {
    let steps = (0..steps).flat_map(|step| KINDS.map(|kind| name(kind, step)));
    std::iter::once(CALIBRATION.to_owned()).chain(steps).collect()
}

/// The files of a test: names and contents. The same seed gives the same bytes.
pub fn files(known: &Known, disturbance: &Disturbance, seed: u64) -> Vec<(String, String)> {
    let mut random = Random::new(seed);
    let mut files = vec![(CALIBRATION.to_owned(), calibration(known, &mut random))];
    let mut begin = BEGIN;
    for (at, step) in known.steps.iter().enumerate() {
        let firing = step.primary_speed / TAU / 2.0;
        let shaft = step.secondary_speed / TAU * GEAR;
        let phases = [random.uniform() * TAU, random.uniform() * TAU];
        let torque = |time: f64| {
            let firing = disturbance.firing * (TAU * firing * time + phases[0]).sin();
            step.secondary_torque * (1.0 + firing + disturbance.shaft * (TAU * shaft * time + phases[1]).sin())
        };
        let noise = disturbance.speed_noise;
        let [primary, secondary, converter] = KINDS;
        for (kind, speed) in [(primary, step.primary_speed), (secondary, step.secondary_speed)] {
            let turn = TAU / speed;
            let events = events(turn, &mut random, |random| {
                // The Arduino divides integers, which cuts off what is left: half a revolution a minute, on average.
                (rpm(speed) * (1.0 + noise * random.normal())).floor()
            });
            files.push((name(kind, at), polled(&events, begin, disturbance, &mut random)));
        }
        let mut off = 0_u32;
        let mut time = 0.0;
        let conversions: Vec<(f64, f64)> = (0..(READ * CONVERSIONS) as usize)
            .map(|_| {
                // The converter's clock is not exact.
                time += (1.0 + 0.01 * random.normal()) / CONVERSIONS;
                if random.chance(disturbance.dropout) {
                    off = 2 + (random.bits() % 6) as u32;
                }
                let value = torque(time) + disturbance.torque_noise * random.normal();
                off = off.saturating_sub(1);
                (time, if off > 0 { 0.0 } else { (known.slope * value + known.intercept).round().clamp(0.0, 65_535.0) })
            })
            .collect();
        files.push((name(converter, at), polled(&conversions, begin, disturbance, &mut random)));
        begin += 1e6 * (READ + SETTLE);
    }
    files
}

/// Known torques and what the converter says of them, as section 9.2 has it.
fn calibration(known: &Known, random: &mut Random) -> String {
    let mut text = "torque_Nm,adc\n".to_owned();
    for load in 0..10 {
        let torque = 5.0 * f64::from(load);
        for _ in 0..30 {
            let adc = known.slope * (torque + 0.15 * random.normal()) + known.intercept;
            let _ = writeln!(text, "{torque},{adc:.0}"); // writing to a string does not fail
        }
    }
    text
}

/// Times and values of a shaft's sensor: one for each turn.
fn events(turn: f64, random: &mut Random, value: impl Fn(&mut Random) -> f64) -> Vec<(f64, f64)> {
    let mut time = turn * (random.uniform() - 1.0);
    let mut events = Vec::new();
    while time < READ && events.len() < 100_000 {
        events.push((time, value(random)));
        time += turn;
    }
    events
}

/// What the logger writes that asks for the last value at its own rate.
fn polled(events: &[(f64, f64)], begin: f64, disturbance: &Disturbance, random: &mut Random) -> String {
    let mut text = String::new();
    let mut last = 0;
    for poll in 0..(READ * POLLS) as usize {
        let now = poll as f64 / POLLS + 0.002;
        while events.get(last + 1).is_some_and(|(time, _)| *time <= now) {
            last += 1;
        }
        let Some((time, value)) = events.get(last).filter(|(time, _)| *time <= now) else { continue };
        // micros() has a resolution of 4 µs and 32 bits.
        let micros = ((begin + 1e6 * time) / 4.0).floor() * 4.0;
        let (mut stamp, mut value) = ((micros % 4_294_967_296.0) as u64, *value as u64);
        // Writing to a string does not fail.
        if random.chance(disturbance.transmission) {
            match random.bits() % 3 {
                0 => stamp ^= 1 << (20 + random.bits() % 12),
                1 => value ^= 1 << (9 + random.bits() % 7),
                _ => {
                    let _ = writeln!(text, "{stamp},{value:x}?");
                    continue;
                }
            }
        }
        let _ = writeln!(text, "{stamp},{value}");
    }
    text
}
