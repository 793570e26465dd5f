//! Where power goes besides friction: hysteresis of the belt, drag, gears.
//!
//! The belt's hysteresis is what its material dissipates when curvature, penetration and cord strain change as it runs
//! around, evaluated on the elastic solution: first order in the loss tangent. Derivation and assumptions:
//! `docs/losses.md`.

#[cfg(test)]
mod checks;
mod gradient;
mod heat;
mod output;
mod sensitivity;
mod series;
mod tracks;

use generated::{FormulaKernel, HYSTERESIS, Identity, LOSS_BALANCE};
use serde::Serialize;

pub use gradient::TrackGradient;
pub use heat::{Heat, Hotter, Rates, Warming, at_temperature, close, into_belt, settle, warm_start, warming};
pub use output::{LossOutput, LossValues};
pub use sensitivity::{Gradients, NoDerivatives, gradients};
pub use series::{MAX_HARMONICS, Series, Track, series};

use crate::case::{LossTangent, Resolved};
use crate::drive::{RegionId, Solved};
use crate::model::{Constant, InternalError, Output};
use series::{Summand, side_by_side};
use tracks::Tracks;

/// Loss tangent of the rubber that the thesis measured (4.1). Sums end where what is missing, were this the loss
/// tangent, is below the tolerance: as many harmonics at any loss tangent, so that losses are exactly linear in it.
const TYPICAL_TANGENT: f64 = 1.0 / 8.2;

/// Share of the power that a drive takes in that sums may leave out at any tolerance when all harmonics are summed: the
/// terms of a field with kinks fall as n⁻³, and a tenth of what is left out takes three times as many.
const ENOUGH: f64 = 1e-6;

/// What sums may leave out, W.
#[derive(Debug, Clone, Copy)]
struct LeftOut {
    /// Where they end.
    wanted: f64,
    /// What is borne after the last harmonic.
    most: f64,
}

impl LeftOut {
    /// For a solution's relative tolerance and the power that its drive takes in.
    fn new(tolerance: f64, driving: f64) -> Self {
        Self { wanted: tolerance * driving, most: tolerance.max(ENOUGH) * driving }
    }
}

/// Why there are no losses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NoLosses {
    /// The belt does not resist bending.
    #[error(
        "edition \"string\" has no hysteresis: without bending stiffness the belt's curvature jumps where it meets a \
         pulley, and the sum over its harmonics diverges"
    )]
    String,
    /// A sum does not end.
    #[error(
        "the sum over the harmonics of the {field} did not end within {MAX_HARMONICS} of them: what is followed along \
         the belt jumps, or the solution's tolerance is too large"
    )]
    Endless {
        /// What was summed.
        field: &'static str,
    },
    /// What must not happen.
    #[error(transparent)]
    Internal(#[from] InternalError),
}

/// Power that hysteresis takes in one region, W.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Hysteresis {
    /// Of bending the belt.
    pub bending: f64,
    /// Of squeezing it in the groove.
    pub groove: f64,
    /// Of stretching its cord.
    pub cord: f64,
}

/// How many harmonics were summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Harmonics {
    /// Of the curvature.
    pub bending: usize,
    /// Of the penetration.
    pub groove: usize,
    /// Of the strain.
    pub cord: usize,
}

/// Power that is lost besides friction, W. What hysteresis takes in a region is the power of the stress that leads the
/// strain by a quarter of a cycle over the rate of strain there: it may be negative, where the belt gives back more
/// than it takes.
#[derive(Debug, Clone, PartialEq, Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Losses {
    /// Of bending the belt.
    pub bending: f64,
    /// Of squeezing it in the groove.
    pub groove: f64,
    /// Of stretching its cord.
    pub cord: f64,
    /// Of drag at both pulleys.
    pub drag: f64,
    /// Of gears behind the secondary.
    pub gears: f64,
    /// All of these.
    pub total: f64,
    /// Hysteresis in the primary's contact.
    pub primary: Hysteresis,
    /// Hysteresis in the span from the primary to the secondary.
    pub slack_span: Hysteresis,
    /// Hysteresis in the secondary's contact.
    pub secondary: Hysteresis,
    /// Hysteresis in the span from the secondary to the primary.
    pub tight_span: Hysteresis,
    /// Power that drags at the primary.
    pub primary_drag: f64,
    /// Power that drags at the secondary.
    pub secondary_drag: f64,
    /// Power that arrives.
    pub power_out: f64,
    /// How many harmonics were summed.
    pub harmonics: Harmonics,
    /// Overall efficiency with all of it.
    #[serde(skip)]
    pub efficiency: f64,
}

impl Losses {
    /// What comes out behind the gears where the belt gives the secondary a power, W; negative where the secondary has
    /// to be driven, as in engine braking. What the belt and the pulleys lose has to be put in there, too, and the
    /// gears take their share of all of it.
    pub fn behind_gears(&self, secondary: f64, gear_efficiency: f64) -> f64 {
        let left = secondary - (self.bending + self.groove + self.cord + self.drag);
        left * gears(gear_efficiency, left)
    }
}

/// What gears multiply a power with: where it is negative it comes in through them, and more of it.
fn gears(efficiency: f64, power: f64) -> f64 {
    if power < 0.0 { 1.0 / efficiency } else { efficiency }
}

/// A sum by what it is of.
struct Sums {
    bending: Series,
    groove: Series,
    cord: Series,
}

/// The losses of a solved case besides friction, loss tangents taken at a temperature in K, sums to `tolerance` times
/// the power that the drive takes in, as far as [`MAX_HARMONICS`] lead.
///
/// # Errors
/// [`NoLosses`], if what the case asks for cannot be told of this solution.
pub fn losses(case: &Resolved, solved: &Solved, temperature: f64, tolerance: f64) -> Result<Losses, NoLosses> {
    let outputs = solved.belt.output_values(&solved.solution)?;
    let (power_in, power_out) = (outputs.get(Output::EnergyPowerIn)?, outputs.get(Output::EnergyPowerOut)?);
    let driving = power_in.max(-power_out);
    let overall = outputs.get(Output::EfficiencyOverall)?;
    let overall = if power_in >= -power_out { overall } else { 1.0 / overall };
    let sums = hysteresis(case, solved, temperature, LeftOut::new(tolerance, driving))?;
    let sum = |part: fn(&Hysteresis) -> f64| sums.as_ref().map_or(0.0, |(total, ..)| part(total));
    let total = Hysteresis { bending: sum(|h| h.bending), groove: sum(|h| h.groove), cord: sum(|h| h.cord) };
    let taken = total.bending + total.groove + total.cord;
    let balance = balance_inputs(case, solved, driving, overall, taken);
    let [primary_drag, secondary_drag, gears, all, power_out, efficiency] = evaluate(&LOSS_BALANCE, &balance);
    let region =
        |region: RegionId| sums.as_ref().map_or(Hysteresis::default(), |(_, regions, _)| regions[region.index()]);
    Ok(Losses {
        bending: total.bending,
        groove: total.groove,
        cord: total.cord,
        drag: primary_drag + secondary_drag,
        gears,
        total: all,
        primary: region(RegionId::Primary),
        slack_span: region(RegionId::SlackSpan),
        secondary: region(RegionId::Secondary),
        tight_span: region(RegionId::TightSpan),
        primary_drag,
        secondary_drag,
        power_out,
        harmonics: sums.as_ref().map_or(Harmonics::default(), |(.., harmonics)| *harmonics),
        efficiency,
    })
}

/// The inputs of the balance's formulae. Where less than nothing arrives, gears have the reciprocal of their
/// efficiency.
fn balance_inputs(case: &Resolved, solved: &Solved, driving: f64, overall: f64, hysteresis: f64) -> [f64; 10] {
    let given = &case.losses;
    let primary = solved.constant(Constant::PrimarySpeed);
    let secondary = primary * solved.constant(Constant::SpeedRatio);
    let mut inputs = [
        driving,
        overall,
        hysteresis,
        primary,
        secondary,
        given.primary_drag,
        given.secondary_drag,
        given.primary_drag_per_speed,
        given.secondary_drag_per_speed,
        1.0,
    ];
    // What arrives without gears says which way power goes through them.
    let [.., arriving, _] = evaluate::<_, _, 6>(&LOSS_BALANCE, &inputs);
    inputs[9] = gears(given.gear_efficiency, arriving);
    inputs
}

/// Values of generated formulae.
fn evaluate<I, O: Identity, const N: usize>(kernel: &FormulaKernel<I, O>, inputs: &[f64]) -> [f64; N] {
    const { assert!(N == O::COUNT, "as many values as outputs") };
    let mut values = [0.0; N];
    (kernel.set.value)(&[], &[], inputs, &mut values);
    values
}

/// What hysteresis takes: in all, region by region, and with how many harmonics; nothing where no loss tangent is
/// given.
type Dissipated = Option<(Hysteresis, [Hysteresis; 4], Harmonics)>;

fn hysteresis(case: &Resolved, solved: &Solved, temperature: f64, left_out: LeftOut) -> Result<Dissipated, NoLosses> {
    let given = &case.losses;
    if given.loss_tangent.is_zero() && given.cord_loss_tangent.is_zero() {
        return Ok(None);
    }
    let tracks = Tracks::new(&solved.belt, &solved.solution).ok_or(NoLosses::String)?;
    let sums = sums(&tracks, &weights(solved, tracks.length), case, temperature, left_out)?;
    let of = |part: &dyn Fn(&Series) -> f64| Hysteresis {
        bending: part(&sums.bending),
        groove: part(&sums.groove),
        cord: part(&sums.cord),
    };
    let regions = RegionId::ALL.map(|region| of(&|sum| sum.regions.get(region.index()).copied().unwrap_or(f64::NAN)));
    let harmonics =
        Harmonics { bending: sums.bending.harmonics, groove: sums.groove.harmonics, cord: sums.cord.harmonics };
    Ok(Some((of(&|sum| sum.total), regions, harmonics)))
}

/// Revolutions of the belt a second, and what multiplies tan δ_n |B_n|²/n of each field.
struct Weights {
    revolutions: f64,
    bending: f64,
    groove: f64,
    cord: f64,
}

/// The constants on which the weights depend, in the order of the formulae's inputs; the loop's length follows.
const WEIGHT_CONSTANTS: [Constant; 8] = [
    Constant::Flow,
    Constant::LongitudinalStiffness,
    Constant::MassPerLength,
    Constant::PrimaryRadius,
    Constant::PrimarySpeed,
    Constant::BendingStiffness,
    Constant::RadialStiffness,
    Constant::HalfAngle,
];

/// The inputs of the weights' formulae.
fn weight_inputs(solved: &Solved, length: f64) -> Vec<f64> {
    WEIGHT_CONSTANTS.into_iter().map(|constant| solved.constant(constant)).chain([length]).collect()
}

fn weights(solved: &Solved, length: f64) -> Weights {
    let [revolutions, bending, groove, cord] = evaluate(&HYSTERESIS, &weight_inputs(solved, length));
    Weights { revolutions, bending, groove, cord }
}

fn sums(
    tracks: &Tracks,
    weights: &Weights,
    case: &Resolved,
    temperature: f64,
    left_out: LeftOut,
) -> Result<Sums, NoLosses> {
    let (rubber, cord) = (&case.losses.loss_tangent, &case.losses.cord_loss_tangent);
    let fields: [(&'static str, &[Track], f64, &LossTangent); 3] = [
        ("curvature", &tracks.curvature, weights.bending, rubber),
        ("penetration", &tracks.penetration, weights.groove, rubber),
        ("cord's strain", &tracks.strain, weights.cord, cord),
    ];
    let at = fields.map(|(.., weight, tangent)| {
        move |n: usize| weight * tangent.at(n as f64 * weights.revolutions, temperature).value
    });
    let summands = fields.iter().zip(&at).filter(|((.., tangent), _)| !tangent.is_zero());
    let summands: Vec<Summand<'_>> = summands
        .map(|(&(_, tracks, _, tangent), weight)| {
            let share = tangent.largest() / TYPICAL_TANGENT;
            Summand { tracks, weight, tolerance: left_out.wanted * share, most: left_out.most * share }
        })
        .collect();
    let mut found = side_by_side(&summands).into_iter();
    let mut next = |(field, tracks, _, tangent): (&'static str, &[Track], f64, &LossTangent)| {
        if tangent.is_zero() {
            return Ok(Series::nothing(tracks.len()));
        }
        found.next().flatten().ok_or(NoLosses::Endless { field })
    };
    let [bending, groove, cord] = fields;
    Ok(Sums { bending: next(bending)?, groove: next(groove)?, cord: next(cord)? })
}
