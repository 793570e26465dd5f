//! Derivatives of the losses with respect to what is given: exactly those of the sums, which are functions of the
//! solution's states at its nodes, of the unstretched lengths of its intervals and of the drive's constants.

use generated::{BoundaryKernel, HYSTERESIS, HysteresisOutput, LOSS_BALANCE, LossBalanceOutput};
use solver::{Functional, Linearisation, Points, Problem, Scope, SolveError};

use super::output::{LossOutput, LossValues};
use super::series::{Series, Track};
use super::tracks::{CURVATURE, CURVATURE_SLOPE, Followed, Input, PENETRATION_SLOPE, STRAIN, STRAIN_SLOPE, Tracks};
use super::{
    LeftOut, NoLosses, Sums, TrackGradient, WEIGHT_CONSTANTS, Weights, balance_inputs, sums, weight_inputs, weights,
};
use crate::case::{Key, LossTangent, Rated, Resolved};
use crate::drive::{RegionId, Solved};
use crate::model::{Constant, InternalError, Output};

/// Why there are no derivatives.
#[derive(Debug, thiserror::Error)]
pub enum NoDerivatives {
    /// There are no losses.
    #[error(transparent)]
    Losses(#[from] NoLosses),
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
    /// The equations are singular at the solution.
    #[error(transparent)]
    Solve(#[from] SolveError),
}

/// Derivatives of one of the sums by what it depends on.
struct Adjoint {
    functional: Functional,
    /// By the temperature at which the loss tangent is taken.
    temperature: f64,
}

/// Derivatives of all losses by the constants of the problem, in its order (zero for unknown ones); by the temperature
/// at which the loss tangents are taken; and by what the case says of losses, which the problem does not know.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradients {
    /// By each constant.
    pub by_constant: LossValues<Vec<f64>>,
    /// By the temperature, W/K or 1/K.
    pub by_temperature: LossValues<f64>,
    /// By the constants of the losses themselves. A loss tangent that is a table, or zero, is not among them: of one
    /// that is zero no sum is formed.
    pub by_given: Vec<(Key, LossValues<f64>)>,
}

/// Places of the constants of drag and gears among the inputs of the balance.
const BALANCE_KEYS: [(Key, usize); 5] = [
    (Key::PrimaryDrag, 5),
    (Key::SecondaryDrag, 6),
    (Key::PrimaryDragPerSpeed, 7),
    (Key::SecondaryDragPerSpeed, 8),
    (Key::GearEfficiency, 9),
];

/// Derivatives of a solved case's losses, sums as those of [`losses`](super::losses).
///
/// # Errors
/// [`NoDerivatives`].
pub fn gradients(
    case: &Resolved,
    solved: &Solved,
    temperature: f64,
    tolerance: f64,
) -> Result<Gradients, NoDerivatives> {
    let (values, outputs) = solved.belt.output_gradients(&solved.solution)?;
    let output = |output: Output| -> Result<Functional, InternalError> {
        Ok(Functional { inputs: outputs.get(output)?.to_vec(), ..Functional::default() })
    };
    let linearisation = Linearisation::new(&solved.belt, &solved.solution)?;
    let (power_in, power_out) = (values.get(Output::EnergyPowerIn)?, values.get(Output::EnergyPowerOut)?);
    let driving = power_in.max(-power_out);
    let left_out = LeftOut::new(tolerance, driving);
    let (taken, adjoints) = adjoints(case, solved, temperature, left_out)?;
    let dissipated: f64 = taken.iter().sum();
    let [bending, groove, cord] = adjoints.each_ref().map(|adjoint| linearisation.gradient(&adjoint.functional));
    let hysteresis: Vec<f64> = bending.iter().zip(&groove).zip(&cord).map(|((a, b), c)| a + b + c).collect();
    let (side, sign) =
        if power_in >= -power_out { (Output::EnergyPowerIn, 1.0) } else { (Output::EnergyPowerOut, -1.0) };
    let mut driving_gradient = linearisation.gradient(&output(side)?);
    driving_gradient.iter_mut().for_each(|by| *by *= sign);
    // Driven over driving: the output is the secondary's over the primary's.
    let overall = values.get(Output::EfficiencyOverall)?;
    let (overall, turned) = if sign > 0.0 { (overall, 1.0) } else { (1.0 / overall, -1.0 / (overall * overall)) };
    let mut overall_gradient = linearisation.gradient(&output(Output::EfficiencyOverall)?);
    overall_gradient.iter_mut().for_each(|by| *by *= turned);
    let unit = |constant: Constant| {
        let given = !solved.question.unknowns().contains(&constant);
        let mut row = vec![0.0; hysteresis.len()];
        match row.get_mut(constant.index()) {
            Some(entry) if given => *entry = 1.0,
            _ => return linearisation.gradient(&of_constant(solved, constant)),
        }
        row
    };
    // In the order of the balance's leading inputs, of which the others are given numbers.
    let speed = unit(Constant::PrimarySpeed);
    let ratio = unit(Constant::SpeedRatio);
    let (omega, sigma) = (solved.constant(Constant::PrimarySpeed), solved.constant(Constant::SpeedRatio));
    let secondary: Vec<f64> = speed.iter().zip(&ratio).map(|(speed, ratio)| sigma * speed + omega * ratio).collect();
    let leading = [driving_gradient, overall_gradient, hysteresis, speed, secondary];
    let balance = balance_inputs(case, solved, driving, overall, dissipated);
    let partial = Partials::of(&LOSS_BALANCE.set, &balance);
    let row = |output: LossBalanceOutput| -> Vec<f64> {
        let size = leading.first().map_or(0, Vec::len);
        let term = |at: usize| leading.iter().enumerate().map(|(i, row)| partial.at(output.index(), i) * row[at]).sum();
        (0..size).map(term).collect()
    };
    let drag = || {
        let (primary, secondary) = (row(LossBalanceOutput::PrimaryDrag), row(LossBalanceOutput::SecondaryDrag));
        primary.iter().zip(&secondary).map(|(a, b)| a + b).collect()
    };
    let by_constant = LossValues::new(|output| match output {
        LossOutput::Bending => bending.clone(),
        LossOutput::Groove => groove.clone(),
        LossOutput::Cord => cord.clone(),
        LossOutput::Drag => drag(),
        LossOutput::Gears => row(LossBalanceOutput::Gears),
        LossOutput::Total => row(LossBalanceOutput::Total),
        LossOutput::Efficiency => row(LossBalanceOutput::Efficiency),
    });
    let by_temperature = by_hysteresis(&partial, adjoints.each_ref().map(|adjoint| adjoint.temperature));
    Ok(Gradients { by_constant, by_temperature, by_given: by_given(case, &partial, taken, by_gears(case, &balance)) })
}

/// What the losses change by where hysteresis changes by so much in bending, groove and cord.
fn by_hysteresis(partial: &Partials, [bending, groove, cord]: [f64; 3]) -> LossValues<f64> {
    // Hysteresis is the third of the balance's inputs.
    let through = |output: LossBalanceOutput| partial.at(output.index(), 2) * (bending + groove + cord);
    LossValues::new(|output| match output {
        LossOutput::Bending => bending,
        LossOutput::Groove => groove,
        LossOutput::Cord => cord,
        // No hysteresis is in it.
        LossOutput::Drag => 0.0,
        LossOutput::Gears => through(LossBalanceOutput::Gears),
        LossOutput::Total => through(LossBalanceOutput::Total),
        LossOutput::Efficiency => through(LossBalanceOutput::Efficiency),
    })
}

/// Derivative of the balance's last input by the gears' efficiency, of which it is the reciprocal where less than
/// nothing arrives.
fn by_gears(case: &Resolved, balance: &[f64; 10]) -> f64 {
    let (given, [.., input]) = (case.losses.gear_efficiency, *balance);
    if input == given { 1.0 } else { -input / given }
}

/// Derivatives by the constants of the losses; `taken` is what hysteresis takes in bending, groove and cord, each of
/// which is linear in its loss tangent.
fn by_given(
    case: &Resolved,
    partial: &Partials,
    [bending, groove, cord]: [f64; 3],
    by_gears: f64,
) -> Vec<(Key, LossValues<f64>)> {
    let given = &case.losses;
    let tangents = [
        (Key::LossTangent, &given.loss_tangent, [bending, groove, 0.0]),
        (Key::CordLossTangent, &given.cord_loss_tangent, [0.0, 0.0, cord]),
    ];
    let tangents = tangents.into_iter().filter_map(|(key, tangent, parts)| match tangent {
        LossTangent::Constant(value) if *value > 0.0 => {
            Some((key, by_hysteresis(partial, parts.map(|part| part / value))))
        }
        LossTangent::Constant(_) | LossTangent::Table(_) => None,
    });
    let others = BALANCE_KEYS.into_iter().map(|(key, input)| {
        let rate = if key == Key::GearEfficiency { by_gears } else { 1.0 };
        let by = |output: LossBalanceOutput| rate * partial.at(output.index(), input);
        let values = LossValues::new(|output| match output {
            LossOutput::Bending | LossOutput::Groove | LossOutput::Cord => 0.0,
            LossOutput::Drag => by(LossBalanceOutput::PrimaryDrag) + by(LossBalanceOutput::SecondaryDrag),
            LossOutput::Gears => by(LossBalanceOutput::Gears),
            LossOutput::Total => by(LossBalanceOutput::Total),
            LossOutput::Efficiency => by(LossBalanceOutput::Efficiency),
        });
        (key, values)
    });
    tangents.chain(others).collect()
}

/// The functional that is an unknown constant itself.
fn of_constant(solved: &Solved, constant: Constant) -> Functional {
    let layout = solved.belt.layout();
    let mut inputs = vec![0.0; layout.inputs()];
    if let Some(entry) = inputs.get_mut(layout.ends() + layout.integrals() + constant.index()) {
        *entry = 1.0;
    }
    Functional { inputs, ..Functional::default() }
}

/// Partial derivatives of generated formulae at some inputs.
struct Partials {
    kernel: &'static BoundaryKernel,
    values: Vec<f64>,
}

impl Partials {
    fn of(kernel: &'static BoundaryKernel, inputs: &[f64]) -> Self {
        let (mut outputs, mut values) = (vec![0.0; kernel.equations.len()], vec![0.0; kernel.pattern.len()]);
        (kernel.jacobian)(&[], &[], inputs, &mut outputs, &mut values);
        Self { kernel, values }
    }

    fn entries(&self) -> impl Iterator<Item = ((usize, usize), f64)> + '_ {
        self.kernel.pattern.iter().copied().zip(self.values.iter().copied())
    }

    /// Of the output in a row of the formulae, by an input.
    fn at(&self, row: usize, input: usize) -> f64 {
        self.entries().filter(|((r, i), _)| *r == row && *i == input).map(|(_, value)| value).sum()
    }
}

/// What hysteresis takes in bending, groove and cord, and the derivatives of these.
fn adjoints(
    case: &Resolved,
    solved: &Solved,
    temperature: f64,
    left_out: LeftOut,
) -> Result<([f64; 3], [Adjoint; 3]), NoDerivatives> {
    let given = &case.losses;
    let nothing = || Adjoint { functional: Functional::default(), temperature: 0.0 };
    if given.loss_tangent.is_zero() && given.cord_loss_tangent.is_zero() {
        return Ok(([0.0; 3], [nothing(), nothing(), nothing()]));
    }
    let tracks = Tracks::new(&solved.belt, &solved.solution).ok_or(NoLosses::String)?;
    let weights = weights(solved, tracks.length);
    let Sums { bending, groove, cord } = sums(&tracks, &weights, case, temperature, left_out)?;
    let (rubber, core) = (&given.loss_tangent, &given.cord_loss_tangent);
    let of = |sum: &Series, tracks_of: &[Track], what: What, weight: f64, tangent: &LossTangent| {
        if tangent.is_zero() {
            return nothing();
        }
        let chain = Chain { solved, tracks: &tracks, weights: &weights, temperature };
        chain.adjoint(sum, tracks_of, what, weight, tangent)
    };
    let adjoints = [
        of(&bending, &tracks.curvature, What::Curvature, weights.bending, rubber),
        of(&groove, &tracks.penetration, What::Penetration, weights.groove, rubber),
        of(&cord, &tracks.strain, What::Strain, weights.cord, core),
    ];
    Ok(([bending.total, groove.total, cord.total], adjoints))
}

/// What a sum is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum What {
    Curvature,
    Penetration,
    Strain,
}

impl What {
    /// The formula that gives its value (a penetration is a state) and its slope.
    fn places(self) -> (Option<usize>, usize) {
        match self {
            Self::Curvature => (Some(CURVATURE), CURVATURE_SLOPE),
            Self::Penetration => (None, PENETRATION_SLOPE),
            Self::Strain => (Some(STRAIN), STRAIN_SLOPE),
        }
    }

    /// Its weight among the outputs of the formulae.
    fn weight(self) -> HysteresisOutput {
        match self {
            Self::Curvature => HysteresisOutput::Bending,
            Self::Penetration => HysteresisOutput::Groove,
            Self::Strain => HysteresisOutput::Cord,
        }
    }
}

/// From derivatives by the tracks to derivatives by what the solver knows.
struct Chain<'a> {
    solved: &'a Solved,
    tracks: &'a Tracks,
    weights: &'a Weights,
    temperature: f64,
}

impl Chain<'_> {
    fn adjoint(&self, sum: &Series, tracks: &[Track], what: What, weight: f64, tangent: &LossTangent) -> Adjoint {
        let layout = self.solved.belt.layout();
        let first = layout.ends() + layout.integrals();
        let mut functional = Functional { inputs: vec![0.0; layout.inputs()], ..Functional::default() };
        let at = |n: usize| tangent.at(n as f64 * self.weights.revolutions, self.temperature);
        let gradients = sum.gradient(tracks, |n| weight * at(n).value);
        // By the loop's length: u = S/L_0 and da/du = L_0 da/dS.
        let mut by_length = self.by_weights(sum, what, weight, &at, functional.inputs.get_mut(first..));
        let length = self.tracks.length;
        for (track, gradient) in tracks.iter().zip(&gradients) {
            by_length -= gradient.u.iter().zip(&track.u).map(|(by, u)| by * u).sum::<f64>() / length;
            by_length += gradient.slope.iter().zip(&track.slope).map(|(by, slope)| by * slope).sum::<f64>() / length;
        }
        // From the loop's end backwards: a longer interval moves all that follows it.
        let mut behind = by_length;
        for region in RegionId::ALL.into_iter().rev() {
            let (Some(gradient), Some(part)) =
                (gradients.get(region.index()), self.solved.solution.regions().get(region.index()))
            else {
                continue;
            };
            let Some(followed) = Followed::new(region, self.solved.belt.kernel(region)) else { continue };
            for interval in (0..part.intervals()).rev() {
                behind += gradient.u.get(interval + 1).copied().unwrap_or(0.0) / length;
                functional.intervals.push((region.index(), interval, followed.length, behind));
            }
            behind += gradient.u.first().copied().unwrap_or(0.0) / length;
            self.nodes(region, what, gradient, &mut functional);
        }
        Adjoint { functional, temperature: weight * sum.by_weight(|n| at(n).by_temperature) }
    }

    /// Adds what the weights depend on to the constants' derivatives; gives the derivative by the loop's length.
    fn by_weights(
        &self,
        sum: &Series,
        what: What,
        weight: f64,
        at: &dyn Fn(usize) -> Rated,
        constants: Option<&mut [f64]>,
    ) -> f64 {
        let by_weight = sum.total / weight;
        let by_revolutions = weight * sum.by_weight(|n| n as f64 * at(n).by_frequency);
        let partial = Partials::of(&HYSTERESIS.set, &weight_inputs(self.solved, self.tracks.length));
        let by = |input: usize| {
            by_weight * partial.at(what.weight().index(), input)
                + by_revolutions * partial.at(HysteresisOutput::Revolutions.index(), input)
        };
        let constants = constants.unwrap_or_default();
        for (input, constant) in WEIGHT_CONSTANTS.into_iter().enumerate() {
            if let Some(entry) = constants.get_mut(constant.index()) {
                *entry += by(input);
            }
        }
        by(WEIGHT_CONSTANTS.len())
    }

    /// Adds the derivatives by values and slopes at the nodes of a region.
    fn nodes(&self, region: RegionId, what: What, gradient: &TrackGradient, functional: &mut Functional) {
        let (belt, solution) = (&self.solved.belt, &self.solved.solution);
        let Some(followed) = Followed::new(region, belt.kernel(region)) else { return };
        let Some(part) = solution.regions().get(region.index()) else { return };
        let (columns, layout) = (followed.columns(part, solution.constants()), belt.layout());
        let first = layout.ends() + layout.integrals();
        let (value, slope) = what.places();
        let mut inputs = Vec::new();
        for (node, (by_value, by_slope)) in gradient.value.iter().zip(&gradient.slope).enumerate() {
            if value.is_none() {
                followed
                    .penetration
                    .into_iter()
                    .for_each(|x| functional.nodes.push((region.index(), node, x, *by_value)));
            }
            columns.at(node, &mut inputs);
            for ((output, input), partial) in Partials::of(followed.kernel, &inputs).entries() {
                let by = match output {
                    output if Some(output) == value => *by_value,
                    output if output == slope => by_slope * self.tracks.length,
                    _ => continue,
                };
                match followed.inputs.get(input) {
                    Some(Input::State(state)) => functional.nodes.push((region.index(), node, *state, by * partial)),
                    Some(Input::Constant(constant)) => {
                        if let Some(entry) = functional.inputs.get_mut(first + constant) {
                            *entry += by * partial;
                        }
                    }
                    Some(Input::Slope(state)) => self.rate(region, node, *state, by * partial, functional),
                    Some(Input::One) | None => {}
                }
            }
        }
    }

    /// Adds the derivative by the rate at which a state changes along its region at a node.
    fn rate(&self, region: RegionId, node: usize, state: usize, by: f64, functional: &mut Functional) {
        let (belt, solution) = (&self.solved.belt, &self.solved.solution);
        let layout = belt.layout();
        let (Some(shape), Some(part)) = (layout.regions.get(region.index()), solution.regions().get(region.index()))
        else {
            return;
        };
        let Some(&s) = part.mesh().get(node) else { return };
        let y: Vec<f64> = (0..part.states()).filter_map(|i| part.state(i).get(node).copied()).collect();
        let points = Points { len: 1, stride: 1, s: &[s], y: &y };
        let mut f = vec![0.0; shape.rows()];
        let (mut dy, mut dc) = (vec![0.0; shape.state_pattern.len()], vec![0.0; shape.constant_pattern.len()]);
        belt.rhs_jacobian(region.index(), &points, solution.constants(), Scope::All, &mut f, &mut dy, &mut dc);
        let row = |(row, _): &(usize, usize)| *row == state;
        for ((_, other), partial) in shape.state_pattern.iter().zip(&dy).filter(|(entry, _)| row(entry)) {
            functional.nodes.push((region.index(), node, *other, by * partial));
        }
        let first = layout.ends() + layout.integrals();
        for ((_, constant), partial) in shape.constant_pattern.iter().zip(&dc).filter(|(entry, _)| row(entry)) {
            if let Some(entry) = functional.inputs.get_mut(first + constant) {
                *entry += by * partial;
            }
        }
    }
}
