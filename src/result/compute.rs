//! From a solution to what it means.

use std::borrow::Cow;

use generated::{RegionKernel, Symbol, sines_and_cosines};
use solver::{Points, Solution};

use super::schema::{BeltResult, Efficiency, Energy, Pulley, Span};
use crate::drive::{BeltProblem, OutputValues, PowerFlow, RegionId, Solved};
use crate::model::{Constant, Constants, Field, InternalError, Output, State};

/// Points inside each interval at which extremes are looked for, besides its nodes.
pub(super) const INNER: usize = 3;

/// A region's states and derived fields at its nodes and between them.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// Which region.
    pub region: RegionId,
    /// Independent variable in `[0, 1]`, increasing.
    pub s: Vec<f64>,
    kernel: &'static RegionKernel,
    /// State by state.
    states: Vec<f64>,
    /// Field by field.
    fields: Vec<f64>,
}

impl Sampled {
    /// Samples a region at its nodes and at `inner` points inside each interval.
    pub fn new(belt: &BeltProblem, solution: &Solution, region: RegionId, inner: usize) -> Self {
        let s = refined(solution.regions()[region.index()].mesh(), inner);
        Self::at(belt, solution, region, s)
    }

    /// Samples a region at some places.
    pub fn at(belt: &BeltProblem, solution: &Solution, region: RegionId, s: Vec<f64>) -> Self {
        let states = solution.regions()[region.index()].eval_many(&s);
        let points = Points { len: s.len(), stride: s.len(), s: &s, y: &states };
        let fields = belt.fields(region, &points, solution.constants());
        Self { region, s, kernel: belt.kernel(region), states, fields }
    }

    /// Mean over a contact, weighted by pressure, of the friction that acts along the rim.
    ///
    /// # Errors
    /// [`InternalError::Field`] of a span.
    pub(super) fn rim_friction(&self) -> Result<f64, InternalError> {
        let [_, cosines] = sines_and_cosines(self.field(Field::ApparentSheaveAngle)?);
        let [sines, _] = sines_and_cosines(self.field(Field::SlidingAngle)?);
        let along = self.field(Field::FrictionAtPoint)?.iter().zip(cosines).zip(sines);
        let along: Vec<f64> = along.map(|((mu, cosine), sine)| mu * cosine * sine).collect();
        Ok(weighted_mean(&self.s, &along, self.field(Field::Pressure)?))
    }

    /// The samples of a state.
    ///
    /// # Errors
    /// [`InternalError::State`] if the region does not have it.
    pub fn state(&self, state: State) -> Result<&[f64], InternalError> {
        let samples = self.kernel.state(state).and_then(|row| row_of(&self.states, row, self.s.len()));
        samples.ok_or(InternalError::State { region: self.region.name(), state })
    }

    /// The samples of a derived field.
    ///
    /// # Errors
    /// [`InternalError::Field`] if the region does not have it.
    pub fn field(&self, field: Field) -> Result<&[f64], InternalError> {
        let samples = self.kernel.field(field).and_then(|row| row_of(&self.fields, row, self.s.len()));
        samples.ok_or(InternalError::Field { region: self.region.name(), field })
    }

    /// All states, then all fields, each with what it is.
    pub fn columns(&self) -> impl Iterator<Item = (&'static Symbol, &[f64])> {
        let each = self.s.len().max(1);
        let states = self.kernel.states.iter().map(|state| state.symbol()).zip(self.states.chunks_exact(each));
        let fields = self.kernel.fields.iter().map(|field| field.symbol()).zip(self.fields.chunks_exact(each));
        states.chain(fields)
    }
}

/// Nodes, and `inner` equidistant points between each two.
pub fn refined(mesh: &[f64], inner: usize) -> Vec<f64> {
    let steps = inner + 1;
    let mut all = Vec::with_capacity(mesh.len() * steps);
    for ends in mesh.windows(2) {
        let (a, h) = (ends[0], ends[1] - ends[0]);
        all.extend((0..steps).map(|i| a + h * i as f64 / steps as f64));
    }
    all.extend(mesh.last());
    all
}

/// Rounds in which an extremum is sought between samples, and the parts into which each divides what is left.
const ROUNDS: usize = 4;
const PARTS: usize = 16;

/// One of many rows of so many values.
fn row_of(values: &[f64], row: usize, each: usize) -> Option<&[f64]> {
    values.get(row * each..(row + 1) * each)
}

/// What an extremum is sought of.
#[derive(Debug, Clone, Copy)]
enum Quantity {
    /// A state.
    State(State),
    /// A derived field.
    Field(Field),
}

impl Quantity {
    /// Its values at some places of a region.
    fn at(self, solved: &Solved, region: RegionId, s: &[f64]) -> Result<Vec<f64>, InternalError> {
        let (belt, solution) = (&solved.belt, &solved.solution);
        let part = &solution.regions()[region.index()];
        match self {
            Self::State(state) => {
                let row = belt.kernel(region).state(state);
                let row = row.ok_or(InternalError::State { region: region.name(), state })?;
                Ok(part.eval_state(row, s))
            }
            Self::Field(field) => belt
                .field(region, field, &part.eval_many(s), solution.constants())
                .ok_or(InternalError::Field { region: region.name(), field }),
        }
    }
}

/// The least (`sign` 1) or the largest (−1) of a quantity along a region, sought between samples around the extreme
/// one: `s` and `values` are the first of them. One that stays at an end of the region through a round is there.
fn extremum(
    solved: &Solved,
    region: RegionId,
    quantity: Quantity,
    sign: f64,
    (s, values): (&[f64], &[f64]),
) -> Result<f64, InternalError> {
    let least = |values: &[f64]| {
        let values = values.iter().map(|value| sign * value).enumerate();
        values.min_by(|(_, a), (_, b)| a.total_cmp(b)).unwrap_or((0, f64::INFINITY))
    };
    let (mut at, mut best) = least(values);
    let mut s = Cow::Borrowed(s);
    for _ in 0..ROUNDS {
        let (Some(&from), Some(&to)) = (s.get(at.saturating_sub(1)), s.get((at + 1).min(s.len() - 1))) else { break };
        let inner: Vec<f64> = (0..=PARTS).map(|part| from + (to - from) * part as f64 / PARTS as f64).collect();
        let (next, value) = least(&quantity.at(solved, region, &inner)?);
        let at_an_end = (at == 0 && next == 0) || (at + 1 == s.len() && next == PARTS);
        (at, best) = (next, best.min(value));
        if at_an_end {
            break;
        }
        s = Cow::Owned(inner);
    }
    Ok(sign * best)
}

/// Share of `[0, 1]` on which `v` lies below `threshold`, `v` taken as linear between its samples.
fn share_below(s: &[f64], v: &[f64], threshold: f64) -> f64 {
    let part = |(s, v): (&[f64], &[f64])| {
        let (a, b) = (v[0] - threshold, v[1] - threshold);
        let share = match (a < 0.0, b < 0.0) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            (true, false) => a / (a - b),
            (false, true) => b / (b - a),
        };
        share * (s[1] - s[0])
    };
    s.windows(2).zip(v.windows(2)).map(part).sum()
}

/// Mean of `v` over `s` with weights `w`, all taken as linear between samples.
fn weighted_mean(s: &[f64], v: &[f64], w: &[f64]) -> f64 {
    let parts = s.windows(2).zip(v.windows(2)).zip(w.windows(2));
    let (sum, weight) = parts.fold((0.0, 0.0), |(sum, weight), ((s, v), w)| {
        let half = 0.5 * (s[1] - s[0]);
        (sum + half * (v[0] * w[0] + v[1] * w[1]), weight + half * (w[0] + w[1]))
    });
    sum / weight
}

/// What a contact shows along its length.
struct Contact {
    penetration: f64,
    slowest: f64,
    fastest: f64,
    adhesion: f64,
    utilization: f64,
}

impl Contact {
    fn new(solved: &Solved, constants: &Constants, region: RegionId) -> Result<Self, InternalError> {
        let sampled = Sampled::new(&solved.belt, &solved.solution, region, INNER);
        let sliding = sampled.field(Field::SlidingSpeed)?;
        let speed = Quantity::Field(Field::SlidingSpeed);
        let fastest_or_slowest = |sign: f64| extremum(solved, region, speed, sign, (&sampled.s, sliding));
        let (slowest, fastest) = (fastest_or_slowest(1.0)?, fastest_or_slowest(-1.0)?);
        let penetration = sampled.state(State::Penetration)?;
        let deepest = Quantity::State(State::Penetration);
        let mean = sampled.rim_friction()?;
        Ok(Self {
            penetration: extremum(solved, region, deepest, -1.0, (&sampled.s, penetration))?,
            slowest,
            fastest,
            adhesion: share_below(&sampled.s, sliding, constants[Constant::SlipThreshold]),
            utilization: mean.abs() / constants[Constant::FrictionCoefficient],
        })
    }
}

/// What the two pulleys have in common: outputs of the same meaning.
struct PulleyOutputs {
    region: RegionId,
    radius: Constant,
    speed: Output,
    torque: Output,
    power: Output,
    axial_force: Output,
    wrap_angle: Output,
    entry_angle: Output,
    exit_angle: Output,
    orientation_angle: Output,
    resultant_x: Output,
    resultant_y: Output,
    binding_moment: Output,
    friction_loss: Output,
    entry_tension: Output,
    exit_tension: Output,
}

const PRIMARY: PulleyOutputs = PulleyOutputs {
    region: RegionId::Primary,
    radius: Constant::PrimaryRadius,
    speed: Output::PrimarySpeed,
    torque: Output::PrimaryTorque,
    power: Output::PrimaryPower,
    axial_force: Output::PrimaryAxialForce,
    wrap_angle: Output::PrimaryWrapAngle,
    entry_angle: Output::PrimaryEntryAngle,
    exit_angle: Output::PrimaryExitAngle,
    orientation_angle: Output::PrimaryOrientationAngle,
    resultant_x: Output::PrimaryResultantX,
    resultant_y: Output::PrimaryResultantY,
    binding_moment: Output::PrimaryBindingMoment,
    friction_loss: Output::PrimaryFrictionLoss,
    entry_tension: Output::PrimaryEntryTension,
    exit_tension: Output::PrimaryExitTension,
};

const SECONDARY: PulleyOutputs = PulleyOutputs {
    region: RegionId::Secondary,
    radius: Constant::SecondaryRadius,
    speed: Output::SecondarySpeed,
    torque: Output::SecondaryTorque,
    power: Output::SecondaryPower,
    axial_force: Output::SecondaryAxialForce,
    wrap_angle: Output::SecondaryWrapAngle,
    entry_angle: Output::SecondaryEntryAngle,
    exit_angle: Output::SecondaryExitAngle,
    orientation_angle: Output::SecondaryOrientationAngle,
    resultant_x: Output::SecondaryResultantX,
    resultant_y: Output::SecondaryResultantY,
    binding_moment: Output::SecondaryBindingMoment,
    friction_loss: Output::SecondaryFrictionLoss,
    entry_tension: Output::SecondaryEntryTension,
    exit_tension: Output::SecondaryExitTension,
};

/// What a solution is read from.
pub struct Reading<'a> {
    solved: &'a Solved,
    constants: Constants,
    outputs: OutputValues,
}

impl<'a> Reading<'a> {
    /// Of a solution.
    ///
    /// # Errors
    /// [`InternalError::Length`] if the solution is not one of its problem.
    pub fn new(solved: &'a Solved) -> Result<Self, InternalError> {
        let constants = Constants::try_from(solved.solution.constants())?;
        Ok(Self { solved, constants, outputs: solved.belt.output_values(&solved.solution)? })
    }

    /// The primary and its contact.
    pub fn primary(&self) -> Result<Pulley, InternalError> {
        self.pulley(&PRIMARY)
    }

    /// The secondary and its contact.
    pub fn secondary(&self) -> Result<Pulley, InternalError> {
        self.pulley(&SECONDARY)
    }

    fn pulley(&self, of: &PulleyOutputs) -> Result<Pulley, InternalError> {
        let contact = Contact::new(self.solved, &self.constants, of.region)?;
        let output = |output| self.outputs.get(output);
        Ok(Pulley {
            speed: output(of.speed)?,
            torque: output(of.torque)?,
            power: output(of.power)?,
            axial_force: output(of.axial_force)?,
            wrap_angle: output(of.wrap_angle)?,
            entry_angle: output(of.entry_angle)?,
            exit_angle: output(of.exit_angle)?,
            orientation_angle: output(of.orientation_angle)?,
            max_penetration: contact.penetration,
            min_sliding_speed: contact.slowest,
            max_sliding_speed: contact.fastest,
            adhesion_fraction: contact.adhesion,
            friction_utilization: contact.utilization,
            radius: self.constants[of.radius],
            resultant_x: output(of.resultant_x)?,
            resultant_y: output(of.resultant_y)?,
            binding_moment: output(of.binding_moment)?,
            friction_loss: output(of.friction_loss)?,
            entry_tension: output(of.entry_tension)?,
            exit_tension: output(of.exit_tension)?,
        })
    }

    /// The tight span.
    pub fn tight_span(&self) -> Result<Span, InternalError> {
        self.span(RegionId::TightSpan, Output::TightSpanArcLength, Output::TightSpanUnstretchedLength)
    }

    /// The slack span.
    pub fn slack_span(&self) -> Result<Span, InternalError> {
        self.span(RegionId::SlackSpan, Output::SlackSpanArcLength, Output::SlackSpanUnstretchedLength)
    }

    fn span(&self, region: RegionId, arc_length: Output, unstretched: Output) -> Result<Span, InternalError> {
        let s = refined(self.solved.solution.regions()[region.index()].mesh(), INNER);
        let quantity = Quantity::State(State::SpanTension);
        let values = quantity.at(self.solved, region, &s)?;
        let tension = |sign: f64| extremum(self.solved, region, quantity, sign, (&s, &values));
        let (min_tension, max_tension) = (tension(1.0)?, tension(-1.0)?);
        Ok(Span {
            arc_length: self.outputs.get(arc_length)?,
            unstretched_length: self.outputs.get(unstretched)?,
            min_tension,
            max_tension,
        })
    }

    /// Efficiencies, of the driven pulley over the driving one.
    pub fn efficiency(&self) -> Result<Efficiency, InternalError> {
        let flow = PowerFlow::of(self.outputs.get(Output::EnergyPowerIn)?, self.outputs.get(Output::EnergyPowerOut)?);
        let driven_over_driving = |secondary_over_primary: Output| -> Result<Option<f64>, InternalError> {
            let value = self.outputs.get(secondary_over_primary)?;
            Ok(match flow {
                PowerFlow::FromPrimary => Some(value),
                PowerFlow::FromSecondary => Some(1.0 / value),
                PowerFlow::IntoBoth | PowerFlow::Neither => None,
            })
        };
        Ok(Efficiency {
            speed: driven_over_driving(Output::EfficiencySpeed)?,
            torque: driven_over_driving(Output::EfficiencyTorque)?,
            overall: driven_over_driving(Output::EfficiencyOverall)?,
            overall_with_losses: None,
        })
    }

    /// The belt as a whole, `length` being what it measures unstretched, m.
    pub fn belt(&self, length: f64) -> Result<BeltResult, InternalError> {
        let unstretched_length = self.outputs.get(Output::BeltUnstretchedLength)?;
        let mass_flow = self.outputs.get(Output::BeltMassFlow)?;
        Ok(BeltResult { mass_flow, unstretched_length, length_error: unstretched_length - length, temperature: None })
    }

    /// The energy audit.
    pub fn energy(&self) -> Result<Energy, InternalError> {
        let (power_in, power_out) =
            (self.outputs.get(Output::EnergyPowerIn)?, self.outputs.get(Output::EnergyPowerOut)?);
        // What the solver's tolerance leaves of a power in is nothing to compare with.
        let without = PowerFlow::is_none(power_in, power_out);
        let share = |of: Output| if without { Ok(None) } else { self.outputs.get(of).map(Some) };
        Ok(Energy {
            power_in,
            power_out,
            friction_loss: self.outputs.get(Output::EnergyFrictionLoss)?,
            imbalance: share(Output::EnergyImbalance)?,
            stretch_work: self.outputs.get(Output::EnergyStretchWork)?,
            closure: share(Output::EnergyClosure)?,
        })
    }
}
