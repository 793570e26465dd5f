//! The belt's temperature: what friction and hysteresis heat it with, it gives off to the air, and its stiffnesses are
//! those at that temperature.
//!
//! ```text
//! h (T − T_a) = a W + P_bend + P_groove + P_cord,      EI = EI(T),   k = k(T)
//! ```
//!
//! The right-hand side is a functional of the whole path, with harmonics of it: no function of ends, integrals and
//! constants, as the boundary equations are. So the temperature is found by Newton's method around the belt's
//! equations, with the exact derivative of the heat by it, which comes of the linearisation at each solution. A few
//! iterations close it to rounding.

use std::collections::BTreeMap;

use serde::Serialize;
use solver::{Functional, Linearisation};

use super::{LossOutput, LossValues, NoDerivatives, NoLosses, gradients, losses};
use crate::case::{Resolved, Softened, Surface, Thermal};
use crate::drive::{Failure, SolveOptions, Solved, solve, solve_from};
use crate::model::{Constant, InternalError, Output};

/// Newton iterations at most.
const MAX_ITERATIONS: usize = 30;
/// Largest step in temperature, K: beyond it, stiffnesses change by a factor that a warm start does not bridge.
const LARGEST_STEP: f64 = 40.0;
/// Share of the heat, times the solution's tolerance, that may be missing in the balance.
const BALANCED: f64 = 10.0;
/// The least that is asked of the balance: the heat is computed from solutions that are no better.
const LEAST_BALANCED: f64 = 1e-6;

/// Heat of a solved case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Heat {
    /// Temperature of the belt, K.
    #[serde(skip)]
    pub temperature: f64,
    /// Heat that goes into the belt, W.
    pub belt: f64,
    /// Friction's heat that goes into the sheaves of the primary, W.
    pub primary: f64,
    /// Friction's heat that goes into the sheaves of the secondary, W.
    pub secondary: f64,
    /// The pulley whose sheaves take more heat.
    pub hotter: Hotter,
    /// Bending stiffness at the temperature, N·m².
    pub bending_stiffness: f64,
    /// Radial stiffness at the temperature, N/m².
    pub radial_stiffness: f64,
    /// d(heat into the belt)/d(temperature), W/K.
    #[serde(skip)]
    pub slope: f64,
    /// What the temperature makes of both stiffnesses.
    #[serde(skip)]
    pub softened: [Rates; 2],
}

/// A stiffness over that at the reference temperature, and the derivative of the stiffness by the temperature.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rates {
    /// Over that at the reference temperature.
    pub factor: f64,
    /// d(stiffness)/d(temperature), SI.
    pub by_temperature: f64,
}

/// One of the two pulleys.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Hotter {
    /// The driving one.
    Primary,
    /// The driven one.
    Secondary,
}

/// The heat into the belt, and its derivatives by all constants and by the temperature itself.
struct Rate {
    heat: f64,
    by_constant: Vec<f64>,
    by_temperature: f64,
}

impl Rate {
    /// d(heat)/d(temperature), the stiffnesses following it.
    fn slope(&self, softened: &[Rates; 2]) -> f64 {
        let through = SOFTENED.iter().zip(softened).map(|(stiffness, rates)| {
            self.by_constant.get(stiffness.index()).copied().unwrap_or(f64::NAN) * rates.by_temperature
        });
        self.by_temperature + through.sum::<f64>()
    }
}

/// How the belt's temperature follows the constants of a solution, and what it makes of the belt.
#[derive(Debug, Clone, PartialEq)]
pub struct Warming {
    /// d(temperature)/d(constant) by each constant of the problem, in its order, K over the constant's SI unit.
    pub by_constant: Vec<f64>,
    /// What the temperature makes of the stiffnesses.
    pub softened: [(Constant, Rates); 2],
}

/// The stiffnesses that follow the temperature, in the order of their [`Rates`].
const SOFTENED: [Constant; 2] = [Constant::BendingStiffness, Constant::RadialStiffness];

/// How the belt's temperature follows the constants at a solution whose heat is in balance at a temperature in K: to
/// first order, by `(h − dQ/dT) dT = Σ ∂Q/∂c dc` with Q the heat into the belt.
///
/// # Errors
/// [`Failure::Sensitivities`] where the equations are singular at the solution.
pub fn warming(
    case: &Resolved,
    thermal: &Thermal,
    solved: &Solved,
    temperature: f64,
    tolerance: f64,
) -> Result<Warming, Failure> {
    let rate = rate(&at_temperature(case, thermal, temperature), thermal, solved, temperature, tolerance)?;
    let softened = rates(case, thermal, solved, temperature);
    let per_heat = 1.0 / (thermal.heat_transfer - rate.slope(&softened));
    let by_constant = rate.by_constant.into_iter().map(|by| by * per_heat).collect();
    let [bending, radial] = softened;
    Ok(Warming { by_constant, softened: [(SOFTENED[0], bending), (SOFTENED[1], radial)] })
}

/// The case with its belt at a temperature.
pub fn at_temperature(case: &Resolved, thermal: &Thermal, temperature: f64) -> Resolved {
    let [bending, radial] = thermal.softened(&case.stiffnesses, temperature);
    let mut warm = case.clone();
    warm.belt.bending_stiffness *= bending.factor;
    warm.belt.radial_stiffness *= radial.factor;
    warm
}

/// The case with its belt as warm as at a solution nearby, and that temperature, K; at the reference without heat.
pub fn warm_start(case: &Resolved, heat: Option<&Heat>) -> (Resolved, f64) {
    match (&case.thermal, heat) {
        (Some(thermal), Some(heat)) => (at_temperature(case, thermal, heat.temperature), heat.temperature),
        _ => (case.clone(), case.stiffnesses.reference),
    }
}

/// The stiffnesses' rates at a solution with them.
fn rates(case: &Resolved, thermal: &Thermal, solved: &Solved, temperature: f64) -> [Rates; 2] {
    let [bending, radial] = thermal.softened(&case.stiffnesses, temperature);
    let of = |softened: Softened, stiffness: Constant| Rates {
        factor: softened.factor,
        by_temperature: softened.rate * solved.constant(stiffness),
    };
    [of(bending, SOFTENED[0]), of(radial, SOFTENED[1])]
}

/// Finds the temperature of the belt of a case with heat, from a solution of it with its stiffnesses at some
/// temperature in K; the solution there.
///
/// # Errors
/// As [`solve`]; [`Failure::Sensitivities`]; [`Failure::Temperature`] where the balance has no end.
pub fn settle(
    case: &Resolved,
    thermal: &Thermal,
    (solved, temperature): (Solved, f64),
    options: &SolveOptions,
) -> Result<(Solved, Heat), Failure> {
    let (mut temperature, mut solved) = (temperature, solved);
    let balanced = (BALANCED * options.tolerance).max(LEAST_BALANCED);
    for _ in 0..MAX_ITERATIONS {
        let warm = at_temperature(case, thermal, temperature);
        let rate = rate(&warm, thermal, &solved, temperature, options.tolerance)?;
        let softened = rates(case, thermal, &solved, temperature);
        let slope = rate.slope(&softened);
        let missing = rate.heat - thermal.heat_transfer * (temperature - thermal.ambient);
        if missing.abs() <= balanced * rate.heat.abs() {
            let heat = told(thermal, &solved, temperature, rate.heat, slope)?;
            return Ok((solved, Heat { softened, ..heat }));
        }
        let step = missing / (thermal.heat_transfer - slope);
        if !step.is_finite() {
            break;
        }
        temperature += step.clamp(-LARGEST_STEP, LARGEST_STEP);
        let warm = at_temperature(case, thermal, temperature);
        let next = solve_from(&solved, &warm, options).or_else(|_| solve(&warm, options))?;
        let (work, steps) = (solved.stats, solved.continuation_steps);
        solved = next;
        solved.stats += work;
        solved.continuation_steps += steps;
    }
    Err(Failure::Temperature { temperature })
}

fn told(thermal: &Thermal, solved: &Solved, temperature: f64, heat: f64, slope: f64) -> Result<Heat, InternalError> {
    let outputs = solved.belt.output_values(&solved.solution)?;
    let sheaves = |loss: Output| outputs.get(loss).map(|loss| (1.0 - thermal.friction_share) * loss);
    let (primary, secondary) = (sheaves(Output::PrimaryFrictionLoss)?, sheaves(Output::SecondaryFrictionLoss)?);
    Ok(Heat {
        temperature,
        belt: heat,
        primary,
        secondary,
        hotter: if primary > secondary { Hotter::Primary } else { Hotter::Secondary },
        bending_stiffness: solved.constant(Constant::BendingStiffness),
        radial_stiffness: solved.constant(Constant::RadialStiffness),
        slope,
        softened: Default::default(),
    })
}

/// Heat into the belt at a solution, W, loss tangents taken at a temperature in K.
///
/// # Errors
/// None, unless this program is broken.
pub fn into_belt(
    case: &Resolved,
    thermal: &Thermal,
    solved: &Solved,
    temperature: f64,
    tolerance: f64,
) -> Result<f64, InternalError> {
    let outputs = solved.belt.output_values(&solved.solution)?;
    let friction = thermal.friction_share * outputs.get(Output::EnergyFrictionLoss)?;
    // Whether losses are told or not: the belt is as warm either way.
    match losses(case, solved, temperature, tolerance) {
        Ok(losses) => Ok(friction + losses.bending + losses.groove + losses.cord),
        Err(NoLosses::Internal(error)) => Err(error),
        // A belt that has none to tell is heated by friction alone.
        Err(NoLosses::String | NoLosses::Endless { .. }) => Ok(friction),
    }
}

/// Heat into the belt at a solution.
fn rate(
    case: &Resolved,
    thermal: &Thermal,
    solved: &Solved,
    temperature: f64,
    tolerance: f64,
) -> Result<Rate, Failure> {
    let (values, outputs) = solved.belt.output_gradients(&solved.solution)?;
    let functional = Functional { inputs: outputs.get(Output::EnergyFrictionLoss)?.to_vec(), ..Functional::default() };
    let linearisation = Linearisation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let mut by_constant = linearisation.gradient(&functional);
    by_constant.iter_mut().for_each(|by| *by *= thermal.friction_share);
    let mut heat = thermal.friction_share * values.get(Output::EnergyFrictionLoss)?;
    let mut by_temperature = 0.0;
    if let Ok(losses) = losses(case, solved, temperature, tolerance) {
        heat += losses.bending + losses.groove + losses.cord;
        match gradients(case, solved, temperature, tolerance) {
            Ok(gradients) => {
                by_temperature = LossOutput::HYSTERESIS.map(|output| gradients.by_temperature[output]).iter().sum();
                for output in LossOutput::HYSTERESIS {
                    let row = &gradients.by_constant[output];
                    by_constant.iter_mut().zip(row).for_each(|(sum, by)| *sum += by);
                }
            }
            Err(NoDerivatives::Solve(error)) => return Err(Failure::Sensitivities(error)),
            Err(NoDerivatives::Internal(error) | NoDerivatives::Losses(NoLosses::Internal(error))) => {
                return Err(error.into());
            }
            // Losses that can be told have derivatives.
            Err(NoDerivatives::Losses(NoLosses::String | NoLosses::Endless { .. })) => {}
        }
    }
    Ok(Rate { heat, by_constant, by_temperature })
}

/// Makes derivatives at a fixed temperature those at which the temperature follows; adds its own. `direct` has what
/// changes with the temperature of the loss tangents itself, W/K or 1/K; nothing where there are no losses to tell.
pub fn close(
    derivatives: &mut BTreeMap<String, BTreeMap<String, f64>>,
    thermal: &Thermal,
    heat: &Heat,
    direct: Option<&LossValues<f64>>,
) {
    const STIFFNESSES: [&str; 2] = ["belt.bending_stiffness", "belt.radial_stiffness"];
    let row = |name: &str| derivatives.get(name).cloned().unwrap_or_default();
    let mut by: BTreeMap<String, f64> = row(Output::EnergyFrictionLoss.name());
    by.values_mut().for_each(|value| *value *= thermal.friction_share);
    for output in LossOutput::HYSTERESIS {
        for (key, value) in row(output.name()) {
            *by.entry(key).or_default() += value;
        }
    }
    let factor = 1.0 / (thermal.heat_transfer - heat.slope);
    by.values_mut().for_each(|value| *value *= factor);
    by.insert("thermal.ambient".into(), thermal.heat_transfer * factor);
    let by_transfer = -(heat.temperature - thermal.ambient) * factor;
    match thermal.surface {
        None => _ = by.insert("thermal.heat_transfer".into(), by_transfer),
        Some(Surface { per_area, perimeter, length }) => {
            by.insert("thermal.heat_transfer_per_area".into(), by_transfer * perimeter * length);
            by.insert("belt.perimeter".into(), by_transfer * per_area * length);
            *by.entry("belt.length".into()).or_default() += by_transfer * per_area * perimeter;
        }
    }
    let given = |row: &mut BTreeMap<String, f64>| {
        for (key, softened) in STIFFNESSES.into_iter().zip(heat.softened) {
            row.entry(key.into()).and_modify(|value| *value *= softened.factor);
        }
    };
    let direct = direct.map(|values| LossOutput::ALL.map(|output| (output.name(), values[output])));
    let direct: BTreeMap<&str, f64> = direct.into_iter().flatten().collect();
    for (name, row) in derivatives.iter_mut() {
        let softened = STIFFNESSES.iter().zip(heat.softened);
        let through = softened.map(|(key, softened)| row.get(*key).copied().unwrap_or(0.0) * softened.by_temperature);
        let per_kelvin = through.sum::<f64>() + direct.get(name.as_str()).copied().unwrap_or(0.0);
        for (key, by) in &by {
            *row.entry(key.clone()).or_default() += per_kelvin * by;
        }
        given(row);
    }
    given(&mut by);
    derivatives.insert("belt.temperature".into(), by);
}
