//! What a map tells, and what is solved for it at a node.

use super::axis::direction;
use crate::case::{Key, Resolved};
use crate::drive::{Failure, SolveOptions, Solved};
use crate::losses::{LossOutput, NoDerivatives, NoLosses, gradients, losses};
use crate::model::{Constant, Constants, InternalError, Output};
use crate::result::{WANTED_RESERVE, utilizations};
use solver::Linearisation;

/// A quantity that a map interpolates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Quantity {
    /// Axial force on the primary, N.
    PrimaryAxialForce,
    /// Axial force on the secondary, N.
    SecondaryAxialForce,
    /// Speed of the primary, rad/s.
    PrimarySpeed,
    /// Torque into the primary, N·m.
    PrimaryTorque,
    /// Torque out of the secondary, N·m.
    SecondaryTorque,
    /// 1 − ω_S R_S/(ω_P R_P): share of the primary's rim speed that the secondary's lacks (6.7).
    SpeedLoss,
    /// Share of the friction at hand that the primary uses; negative where the secondary drives.
    PrimaryUtilization,
    /// Share of the friction at hand that the secondary uses; negative where the secondary drives.
    SecondaryUtilization,
    /// Radius of the primary, as found, m.
    PrimaryRadius,
    /// Radius of the secondary, as found, m.
    SecondaryRadius,
    /// Tractive tension at the exit of the primary, N.
    SlackTension,
    /// Tractive tension at the entry of the primary, N.
    TightTension,
    /// Power lost to hysteresis, drag and gears, W; in maps of cases that tell losses.
    Losses,
}

/// How the error of a quantity is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Over the quantity's size there, and at least a tenth of its largest on the map.
    Relative,
    /// As it is: the quantity is a share.
    Absolute,
}

/// Share of the largest size on the map below which a size does not count.
const FLOOR: f64 = 0.1;

impl Quantity {
    /// All, in the order of a map's columns.
    pub const ALL: [Self; 13] = [
        Self::PrimaryAxialForce,
        Self::SecondaryAxialForce,
        Self::PrimarySpeed,
        Self::PrimaryTorque,
        Self::SecondaryTorque,
        Self::SpeedLoss,
        Self::PrimaryUtilization,
        Self::SecondaryUtilization,
        Self::PrimaryRadius,
        Self::SecondaryRadius,
        Self::SlackTension,
        Self::TightTension,
        Self::Losses,
    ];

    /// Its name in files, as in the result object where that has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PrimaryAxialForce => Output::PrimaryAxialForce.name(),
            Self::SecondaryAxialForce => Output::SecondaryAxialForce.name(),
            Self::PrimarySpeed => Output::PrimarySpeed.name(),
            Self::PrimaryTorque => Output::PrimaryTorque.name(),
            Self::SecondaryTorque => Output::SecondaryTorque.name(),
            Self::SpeedLoss => "speed_loss",
            Self::PrimaryUtilization => "primary.friction_utilization",
            Self::SecondaryUtilization => "secondary.friction_utilization",
            Self::PrimaryRadius => "primary.radius",
            Self::SecondaryRadius => "secondary.radius",
            Self::SlackTension => Output::PrimaryExitTension.name(),
            Self::TightTension => Output::PrimaryEntryTension.name(),
            Self::Losses => LossOutput::Total.name(),
        }
    }

    /// Its unit as files state it: SI, `1` for a share.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::PrimaryAxialForce | Self::SecondaryAxialForce | Self::SlackTension | Self::TightTension => "N",
            Self::PrimarySpeed => "rad/s",
            Self::PrimaryTorque | Self::SecondaryTorque => "N*m",
            Self::SpeedLoss | Self::PrimaryUtilization | Self::SecondaryUtilization => "1",
            Self::PrimaryRadius | Self::SecondaryRadius => "m",
            Self::Losses => "W",
        }
    }

    /// The quantity with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|quantity| quantity.name() == name)
    }

    /// How its error is measured.
    pub const fn measure(self) -> Measure {
        match self {
            Self::SpeedLoss | Self::PrimaryUtilization | Self::SecondaryUtilization => Measure::Absolute,
            _ => Measure::Relative,
        }
    }

    /// What an error is divided by where the quantity has a value and a largest size on the map.
    pub(super) fn scale(self, value: f64, largest: f64) -> f64 {
        match self.measure() {
            Measure::Absolute => 1.0,
            Measure::Relative => value.abs().max(FLOOR * largest).max(f64::MIN_POSITIVE),
        }
    }

    /// Those of a case: losses only where they are told.
    pub(crate) fn of_case(case: &Resolved) -> Vec<Self> {
        let told = case.losses.wanted() && case.model.bending.is_some();
        Self::ALL.into_iter().filter(|quantity| told || *quantity != Self::Losses).collect()
    }

    fn source(self) -> Source {
        match self {
            Self::PrimaryAxialForce => Source::Output(Output::PrimaryAxialForce),
            Self::SecondaryAxialForce => Source::Output(Output::SecondaryAxialForce),
            Self::PrimarySpeed => Source::Constant(Constant::PrimarySpeed),
            Self::PrimaryTorque => Source::Output(Output::PrimaryTorque),
            Self::SecondaryTorque => Source::Output(Output::SecondaryTorque),
            Self::SpeedLoss => Source::SpeedLoss,
            Self::PrimaryUtilization => Source::Utilization(0),
            Self::SecondaryUtilization => Source::Utilization(1),
            Self::PrimaryRadius => Source::Constant(Constant::PrimaryRadius),
            Self::SecondaryRadius => Source::Constant(Constant::SecondaryRadius),
            Self::SlackTension => Source::Output(Output::PrimaryExitTension),
            Self::TightTension => Source::Output(Output::PrimaryEntryTension),
            Self::Losses => Source::Losses,
        }
    }
}

/// From what of a solution a quantity is read.
#[derive(Debug, Clone, Copy)]
enum Source {
    Output(Output),
    Constant(Constant),
    SpeedLoss,
    /// Of the primary, or of the secondary.
    Utilization(usize),
    Losses,
}

/// The quantities of a solution, and their derivatives.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sample {
    /// One a quantity.
    pub values: Vec<f64>,
    /// Quantity by quantity, one an axis.
    pub slopes: Vec<f64>,
}

/// What a node of a map has.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Node {
    /// A solution.
    Solved(Sample),
    /// None that counts: the belt slips beyond what is allowed.
    Slipping,
    /// No solution was found: the belt slips grossly, or the search failed.
    Unsolved,
    /// No drive with these numbers: pulleys that overlap, or a belt that fits none.
    NoDrive,
}

impl Node {
    pub fn sample(&self) -> Option<&Sample> {
        match self {
            Self::Solved(sample) => Some(sample),
            Self::Slipping | Self::Unsolved | Self::NoDrive => None,
        }
    }
}

/// Whether a belt is within the slip limit: by the share of the speed that it keeps, or by that of the friction at hand
/// that is left over.
pub(crate) fn holds(speed_efficiency: f64, slip_reserve: f64, least_speed_efficiency: f64) -> bool {
    speed_efficiency.min(1.0 / speed_efficiency) >= least_speed_efficiency || slip_reserve >= WANTED_RESERVE
}

/// Reads the quantities and their derivatives along the axes; those of the friction's utilization are left zero.
pub(super) fn sample(
    case: &Resolved,
    solved: &Solved,
    quantities: &[Quantity],
    axes: &[Key],
    options: &SolveOptions,
) -> Result<Sample, Failure> {
    let (values, partials) = solved.belt.output_gradients(&solved.solution)?;
    let constants = Constants::try_from(solved.solution.constants())?;
    let linearisation = Linearisation::new(&solved.belt, &solved.solution).map_err(Failure::Sensitivities)?;
    let directions: Vec<Vec<f64>> = axes.iter().map(|key| direction(*key, case, solved)).collect();
    let tangents: Vec<_> = directions.iter().map(|direction| linearisation.tangent(direction)).collect();
    let inputs: Vec<Vec<f64>> = tangents.iter().map(solver::Tangent::inputs).collect();
    let used = utilizations(solved)?;
    let lost = match quantities.contains(&Quantity::Losses) {
        true => Some(lost(case, solved, options)?),
        false => None,
    };
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut sample = Sample { values: Vec::new(), slopes: Vec::new() };
    for quantity in quantities {
        let output = |output: Output, factor: f64| -> Result<Vec<f64>, InternalError> {
            let partial = partials.get(output)?;
            Ok(inputs.iter().map(|rates| factor * dot(partial, rates)).collect())
        };
        let (value, slopes) = match quantity.source() {
            Source::Output(of) => (values.get(of)?, output(of, 1.0)?),
            Source::SpeedLoss => (1.0 - values.get(Output::EfficiencySpeed)?, output(Output::EfficiencySpeed, -1.0)?),
            Source::Constant(constant) => {
                let rate = |tangent: &solver::Tangent| tangent.constants.get(constant.index()).copied();
                (constants[constant], tangents.iter().map(|tangent| rate(tangent).unwrap_or(f64::NAN)).collect())
            }
            // Its derivatives are found when all nodes are known.
            Source::Utilization(pulley) => (used[pulley], vec![0.0; axes.len()]),
            Source::Losses => {
                let Some((value, gradient)) = &lost else { continue };
                (*value, directions.iter().map(|direction| dot(gradient, direction)).collect::<Vec<f64>>())
            }
        };
        sample.values.push(value);
        sample.slopes.extend(slopes);
    }
    let finite = sample.values.iter().chain(&sample.slopes).all(|value| value.is_finite());
    if finite { Ok(sample) } else { Err(Failure::NoStart) }
}

/// Losses besides friction, W, and their derivatives by the problem's constants.
fn lost(case: &Resolved, solved: &Solved, options: &SolveOptions) -> Result<(f64, Vec<f64>), Failure> {
    let none = |reason: NoLosses| match reason {
        NoLosses::Internal(error) => Failure::Internal(error),
        NoLosses::String | NoLosses::Endless { .. } => Failure::NoEquations,
    };
    let total = losses(case, solved, case.stiffnesses.reference, options.tolerance).map_err(none)?.total;
    let found =
        gradients(case, solved, case.stiffnesses.reference, options.tolerance).map_err(|error| match error {
            NoDerivatives::Losses(reason) => none(reason),
            NoDerivatives::Internal(error) => error.into(),
            NoDerivatives::Solve(error) => Failure::Sensitivities(error),
        })?;
    Ok((total, found.by_constant[LossOutput::Total].clone()))
}
