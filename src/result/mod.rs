//! What a solution means: the result object, the profile along the belt, the summary.

mod answers;
mod beside;
mod component;
mod compute;
mod doubt;
mod envelope;
mod margin;
mod profile;
mod schema;
mod sensitivity;
mod summary;
mod units;
mod utilization;
mod warnings;

use std::collections::BTreeMap;

pub(crate) use answers::slip;
pub use answers::{Answer, Light, WANTED_RESERVE, answers, answers_in, tension_for};
pub use beside::beside;
pub use component::{Comparison, Grip, PulleyComparison, compare};
pub use compute::Sampled;
pub use doubt::Doubt;
#[cfg(feature = "ode")]
pub(crate) use doubt::is_buckled;
pub use envelope::{FailureKind, FailureReport, envelope, failed};
pub use profile::write_profile;
pub use schema::{
    BeltResult, DriveResult, Efficiency, Energy, MeshIntervals, OtherSolution, Pulley, SCHEMA, SolverReport, Span,
};
use sensitivity::add_losses;
pub use sensitivity::{Sensitivities, sensitivities};
pub use summary::{summary, summary_in};
pub use units::Units;
pub use utilization::{slip_reserve, utilizations};
pub(crate) use warnings::HOT;
pub use warnings::warnings;

use crate::case::{Clamp, Key, Resolved};
use crate::clock::Stopwatch;
use crate::drive::{Branch, Failure, RegionId, SolveOptions, Solved, branch, other_solution, refined, solve};
use crate::losses::{Heat, LossOutput, NoLosses, close, losses, settle};
use crate::model::{Constant, InternalError, Output};

/// A solved case: the result object, and the solution it was read from.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The result object.
    pub result: DriveResult<Resolved>,
    /// The solution.
    pub solved: Solved,
    /// Why losses are not told although nobody declined them.
    pub no_losses: Option<NoLosses>,
}

/// Solves a case from nothing and reads the solution; if its clamp is to be found for a margin against slip, at the
/// slack tension at which that margin holds.
///
/// # Errors
/// See [`Failure`].
pub fn run(case: &Resolved, options: &SolveOptions) -> Result<Outcome, Failure> {
    if let Some(margin) = case.operating_point.margin {
        return margin::run(case, margin, options);
    }
    let start = Stopwatch::start();
    let solved = solve(case, options)?;
    // Of two solutions the tighter, whichever the search has met.
    let loose = matches!(branch(&solved), Ok(Some(Branch::Loose)));
    let tight = if loose { other_solution(&case.model, &solved, options)? } else { None };
    interpret(case, options, tight.unwrap_or(solved), start)
}

/// As [`run`]; where the clamp is an axial force that belongs to two solutions, the one that `wanted` says, and the
/// other beside it.
///
/// # Errors
/// As [`run`].
pub fn run_on_branch(case: &Resolved, wanted: Branch, options: &SolveOptions) -> Result<Outcome, Failure> {
    let start = Stopwatch::start();
    if case.operating_point.margin.is_some()
        || !matches!(case.operating_point.clamp, Clamp::PrimaryAxialForce(_) | Clamp::SecondaryAxialForce(_))
    {
        return run(case, options);
    }
    interpret_on_branch(case, wanted, options, solve(case, options)?, start)
}

/// As [`interpret`]; where the clamp is an axial force that belongs to two solutions, whichever `solved` is, the one
/// that `wanted` says, and the other beside it.
///
/// # Errors
/// As [`run`].
pub fn interpret_on_branch(
    case: &Resolved,
    wanted: Branch,
    options: &SolveOptions,
    solved: Solved,
    start: Stopwatch,
) -> Result<Outcome, Failure> {
    let other = other_solution(&case.model, &solved, options)?;
    let is_tighter = |a: &Solved, b: &Solved| a.constant(Constant::SlackTension) > b.constant(Constant::SlackTension);
    let (chosen, other) = match other {
        Some(other) if is_tighter(&other, &solved) == (wanted == Branch::Tight) => (other, Some(solved)),
        other => (solved, other),
    };
    let mut outcome = interpret(case, options, chosen, start)?;
    if let Some(other) = other {
        let friction_utilization = margin::utilization(&other)?;
        let slack_tension = other.constant(Constant::SlackTension);
        outcome.result.other_solution = Some(OtherSolution { slack_tension, friction_utilization });
    }
    Ok(outcome)
}

/// Reads a solution of a case, found since `start`; where the case asks for the belt's temperature, the solution at
/// that.
///
/// # Errors
/// [`Failure::Sensitivities`]; with heat, as [`run`].
pub fn interpret(
    case: &Resolved,
    options: &SolveOptions,
    solved: Solved,
    start: Stopwatch,
) -> Result<Outcome, Failure> {
    let reference = case.stiffnesses.reference;
    let (solved, heat) = warmed(case, options, (solved, reference))?;
    read_at(case, options, (solved, heat.into()), start)
}

/// What is known of the belt's temperature at a solution.
#[derive(Debug, Clone, Copy)]
pub(crate) enum BeltTemperature {
    /// That at which its properties are given: nothing is known of another.
    Reference,
    /// This one, K, whatever heats the belt.
    Held(f64),
    /// That at which its heat is in balance.
    Balanced(Heat),
}

impl BeltTemperature {
    /// In K.
    pub fn kelvin(&self, case: &Resolved) -> f64 {
        match self {
            Self::Reference => case.stiffnesses.reference,
            Self::Held(temperature) => *temperature,
            Self::Balanced(heat) => heat.temperature,
        }
    }
}

impl From<Option<Heat>> for BeltTemperature {
    fn from(heat: Option<Heat>) -> Self {
        heat.map_or(Self::Reference, Self::Balanced)
    }
}

/// A solution of a case with its stiffnesses at some temperature in K, and that at which its heat is in balance where
/// the case asks for it.
pub(crate) fn warmed(
    case: &Resolved,
    options: &SolveOptions,
    from: (Solved, f64),
) -> Result<(Solved, Option<Heat>), Failure> {
    match &case.thermal {
        Some(thermal) => settle(case, thermal, from, options).map(|(solved, heat)| (solved, Some(heat))),
        None => Ok((from.0, None)),
    }
}

/// Derivatives of all outputs at a solution, the temperature following where there is heat.
pub(crate) fn derivatives(
    case: &Resolved,
    options: &SolveOptions,
    solved: &Solved,
    warmth: &BeltTemperature,
) -> Result<Sensitivities, Failure> {
    let temperature = warmth.kelvin(case);
    let mut derivatives = sensitivities(solved)?;
    let mut direct = None;
    // What losses heat the belt with counts whether they are told or not.
    if case.losses.wanted() || case.thermal.is_some() {
        direct = add_losses(&mut derivatives, case, options, temperature, solved)?;
    }
    if let (Some(thermal), BeltTemperature::Balanced(heat)) = (&case.thermal, warmth) {
        close(&mut derivatives, thermal, heat, direct.as_ref());
    }
    if !case.losses.wanted() {
        LossOutput::ALL.iter().for_each(|output| _ = derivatives.remove(output.name()));
    }
    Ok(derivatives)
}

/// Reads a solution whose temperature is known.
///
/// # Errors
/// [`Failure::Sensitivities`].
pub(crate) fn read_at(
    case: &Resolved,
    options: &SolveOptions,
    (solved, warmth): (Solved, BeltTemperature),
    start: Stopwatch,
) -> Result<Outcome, Failure> {
    let temperature = warmth.kelvin(case);
    let (solved, errors) = if options.uncertainty { refined(solved, options)? } else { (solved, None) };
    let mut result = read(case, options, &solved, start)?;
    result.uncertainty = errors.map(|errors| uncertainty(&result, &errors));
    (result.belt.temperature, result.thermal) = match warmth {
        BeltTemperature::Reference => (None, None),
        BeltTemperature::Held(temperature) => (Some(temperature), None),
        BeltTemperature::Balanced(heat) => (Some(heat.temperature), Some(heat)),
    };
    if options.sensitivities {
        result.sensitivities = Some(derivatives(case, options, &solved, &warmth)?);
    }
    let told = case.losses.wanted().then(|| losses(case, &solved, temperature, options.tolerance));
    let no_losses = match told {
        None => None,
        Some(Err(NoLosses::Internal(error))) => return Err(error.into()),
        Some(Err(reason)) => Some(reason),
        Some(Ok(losses)) => {
            result.efficiency.overall_with_losses = result.efficiency.overall.map(|_| losses.efficiency);
            result.losses = Some(losses);
            None
        }
    };
    Ok(Outcome { result, solved, no_losses })
}

/// The errors of the outputs as those of the result: in engine braking efficiencies are reciprocals.
fn uncertainty(result: &DriveResult<Resolved>, errors: &[(Output, f64)]) -> BTreeMap<String, f64> {
    let efficiency = &result.efficiency;
    let braking = result.energy.power_in < 0.0;
    let scale = |output: Output| {
        match output {
            Output::EfficiencyOverall => efficiency.overall,
            Output::EfficiencySpeed => efficiency.speed,
            Output::EfficiencyTorque => efficiency.torque,
            _ => return Some(1.0),
        }
        .map(|value| if braking { value * value } else { 1.0 })
    };
    let error = |(output, error): &(Output, f64)| Some((output.name().to_owned(), (error * scale(*output)?).abs()));
    errors.iter().filter_map(error).collect()
}

fn read(
    case: &Resolved,
    options: &SolveOptions,
    solved: &Solved,
    start: Stopwatch,
) -> Result<DriveResult<Resolved>, InternalError> {
    let reading = compute::Reading::new(solved)?;
    let intervals = |region: RegionId| solved.solution.regions()[region.index()].intervals();
    let primary = reading.primary()?;
    let secondary = reading.secondary()?;
    let friction_utilization = primary.friction_utilization.max(secondary.friction_utilization);
    let mut result = DriveResult {
        schema: SCHEMA,
        edition: case.edition.name().to_owned(),
        converged: true,
        inputs: case.clone(),
        found: BTreeMap::new(),
        primary,
        secondary,
        tight_span: reading.tight_span()?,
        slack_span: reading.slack_span()?,
        efficiency: reading.efficiency()?,
        slip_reserve: 1.0 - friction_utilization,
        friction_utilization,
        belt: reading.belt(case.belt.length)?,
        energy: reading.energy()?,
        losses: None,
        thermal: None,
        solver: SolverReport {
            order: options.order.number(),
            tolerance: options.tolerance,
            mesh_intervals: MeshIntervals {
                primary: intervals(RegionId::Primary),
                secondary: intervals(RegionId::Secondary),
                tight_span: intervals(RegionId::TightSpan),
                slack_span: intervals(RegionId::SlackSpan),
            },
            max_residual: solved.solution.max_defect(),
            max_boundary_residual: solved.solution.max_boundary_residual(),
            newton_iterations: solved.stats.newton_iterations,
            continuation_steps: solved.continuation_steps,
            wall_time: start.seconds(),
        },
        uncertainty: None,
        other_solution: None,
        sensitivities: None,
    };
    for constant in solved.question.swaps.iter().map(|swap| swap.free) {
        if let Some(key) = Key::of_constant(constant) {
            result.add_found(key, solved.constant(constant));
        }
    }
    Ok(result)
}

impl DriveResult<Resolved> {
    /// Notes what was found for a key that was solved for, among the inputs too.
    fn add_found(&mut self, key: Key, value: f64) {
        self.found.insert(key.path().to_owned(), value);
        self.inputs.found.retain(|(other, _)| *other != key);
        self.inputs.found.push((key, value));
    }
}
