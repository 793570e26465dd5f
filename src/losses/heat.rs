//! The belt's temperature: what friction and hysteresis heat it with, it gives off to the air, and its stiffnesses are
//! those at that temperature.
//!
//! ```text
//! h (T − T_a) = a W + P_bend + P_groove + P_cord,      EI = EI_0 exp(−s_b (T − T_0)),   k = k_0 exp(−s_k (T − T_0))
//! ```
//!
//! The right-hand side is a functional of the whole path, with harmonics of it: no function of ends, integrals and
//! constants, as the boundary equations are. So the temperature is found by Newton's method around the belt's
//! equations, with the exact derivative of the heat by it, which comes of the linearisation at each solution. A few
//! iterations close it to rounding.

use std::collections::BTreeMap;

use serde::Serialize;
use solver::{Functional, Linearisation};

use super::{NoDerivatives, gradients, losses};
use crate::case::{Resolved, Thermal};
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

/// The case with its belt at a temperature.
pub fn at_temperature(case: &Resolved, thermal: &Thermal, temperature: f64) -> Resolved {
    let [bending, radial] = thermal.softened(temperature);
    let mut warm = case.clone();
    warm.belt.bending_stiffness *= bending;
    warm.belt.radial_stiffness *= radial;
    warm
}

/// Finds the temperature of the belt of a case with heat, from a solution of it with its stiffnesses at the reference;
/// the solution there.
///
/// # Errors
/// As [`solve`]; [`Failure::Sensitivities`]; [`Failure::Temperature`] where the balance has no end.
pub fn settle(
    case: &Resolved,
    thermal: &Thermal,
    solved: Solved,
    options: &SolveOptions,
) -> Result<(Solved, Heat), Failure> {
    let (mut temperature, mut solved) = (thermal.reference, solved);
    let balanced = (BALANCED * options.tolerance).max(LEAST_BALANCED);
    for _ in 0..MAX_ITERATIONS {
        let warm = at_temperature(case, thermal, temperature);
        let rate = rate(&warm, thermal, &solved, temperature, options)?;
        let by = |constant: Constant| rate.by_constant.get(constant.index()).copied().unwrap_or(f64::NAN);
        let slope = rate.by_temperature
            - by(Constant::BendingStiffness) * thermal.bending_softening * solved.constant(Constant::BendingStiffness)
            - by(Constant::RadialStiffness) * thermal.radial_softening * solved.constant(Constant::RadialStiffness);
        let missing = rate.heat - thermal.heat_transfer * (temperature - thermal.ambient);
        if missing.abs() <= balanced * rate.heat.abs() {
            let heat = told(thermal, &solved, temperature, rate.heat, slope)?;
            return Ok((solved, heat));
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
    })
}

/// Heat into the belt at a solution.
fn rate(
    case: &Resolved,
    thermal: &Thermal,
    solved: &Solved,
    temperature: f64,
    options: &SolveOptions,
) -> Result<Rate, Failure> {
    let (values, outputs) = solved.belt.output_gradients(&solved.solution)?;
    let functional = Functional { inputs: outputs.get(Output::EnergyFrictionLoss)?.to_vec(), ..Functional::default() };
    let linearisation = Linearisation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let mut by_constant = linearisation.gradient(&functional);
    by_constant.iter_mut().for_each(|by| *by *= thermal.friction_share);
    let mut heat = thermal.friction_share * values.get(Output::EnergyFrictionLoss)?;
    let mut by_temperature = 0.0;
    if case.losses.wanted()
        && let Ok(losses) = losses(case, solved, temperature, options.tolerance)
    {
        heat += losses.bending + losses.groove + losses.cord;
        let gradients = match gradients(case, solved, temperature, options.tolerance) {
            Ok(gradients) => gradients,
            Err(NoDerivatives::Solve(error)) => return Err(Failure::Sensitivities(error)),
            Err(NoDerivatives::Internal(error)) => return Err(error.into()),
            Err(NoDerivatives::Losses(_)) => Default::default(),
        };
        by_temperature = gradients.by_temperature;
        for name in HYSTERESIS {
            let rows = gradients.by_constant.get(name).into_iter().flatten();
            by_constant.iter_mut().zip(rows).for_each(|(sum, by)| *sum += by);
        }
    }
    Ok(Rate { heat, by_constant, by_temperature })
}

const HYSTERESIS: [&str; 3] = ["losses.bending", "losses.groove", "losses.cord"];

/// Makes derivatives at a fixed temperature those at which the temperature follows; adds its own.
pub fn close(derivatives: &mut BTreeMap<String, BTreeMap<String, f64>>, thermal: &Thermal, heat: &Heat) {
    const STIFFNESSES: [&str; 2] = ["belt.bending_stiffness", "belt.radial_stiffness"];
    let row = |name: &str| derivatives.get(name).cloned().unwrap_or_default();
    let mut by: BTreeMap<String, f64> = row("energy.friction_loss");
    by.values_mut().for_each(|value| *value *= thermal.friction_share);
    for name in HYSTERESIS {
        for (key, value) in row(name) {
            *by.entry(key).or_default() += value;
        }
    }
    let factor = 1.0 / (thermal.heat_transfer - heat.slope);
    by.values_mut().for_each(|value| *value *= factor);
    by.insert("thermal.ambient".into(), thermal.heat_transfer * factor);
    by.insert("thermal.heat_transfer".into(), -(heat.temperature - thermal.ambient) * factor);
    let rates =
        [-thermal.bending_softening * heat.bending_stiffness, -thermal.radial_softening * heat.radial_stiffness];
    let softened = thermal.softened(heat.temperature);
    let given = |row: &mut BTreeMap<String, f64>| {
        for (key, factor) in STIFFNESSES.into_iter().zip(softened) {
            row.entry(key.into()).and_modify(|value| *value *= factor);
        }
    };
    for row in derivatives.values_mut() {
        let per_kelvin: f64 =
            STIFFNESSES.iter().zip(rates).map(|(key, rate)| row.get(*key).copied().unwrap_or(0.0) * rate).sum();
        for (key, by) in &by {
            *row.entry(key.clone()).or_default() += per_kelvin * by;
        }
        given(row);
    }
    given(&mut by);
    derivatives.insert("belt.temperature".into(), by);
}
