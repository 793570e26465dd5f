//! The clamp of best overall efficiency for a torque and a ratio.
//!
//! A tight belt sinks deep and wastes power on its way in and out of the grooves; a loose one wastes it by slipping.
//! The efficiency has one maximum between, where its derivative with respect to the slack tension is zero. That
//! derivative comes of the factorisation that Newton's method holds, by one transposed solve. A case that asks for
//! losses besides friction (`losses.include = "on"`) has the efficiency with these maximised. Where the belt's
//! temperature is to be found, every belt that is tried is as warm as its losses make it, and the derivative has the
//! temperature follow.

use serde::{Serialize, Serializer};
use solver::{Functional, Linearisation};

use super::error::DesignError;
use super::limit::{clamped, without_margin};
use super::state::DriveState;
use crate::case::{Clamp, Key, Resolved};
use crate::drive::{Failure, SolveOptions, Solved, solve, solve_from};
use crate::losses::{Heat, LossOutput, NoDerivatives, NoLosses, gradients, losses, warm_start};
use crate::model::{Constant, Constants, Include, Output};
use crate::result::{BeltTemperature, derivatives, warmed};

/// Factor on the slack tension from one trial to the next, and that below which a march ends.
const FACTOR: f64 = 1.4;
const LEAST_FACTOR: f64 = 1.01;
/// Slack tensions over M_in/R_P between which the maximum is sought.
const RANGE: (f64, f64) = (5e-3, 30.0);
/// Evaluations that locate a maximum, and the bracket in the logarithm of the slack tension at which the maximum counts
/// as located.
const LOCATING: usize = 30;
const LOCATED: f64 = 1e-8;

/// Where the best clamp lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OptimumPlace {
    /// At a maximum of the efficiency.
    Inner,
    /// At the loosest belt that has a solution: the efficiency rises up to there.
    Loosest,
    /// At the tightest.
    Tightest,
}

impl Serialize for OptimumPlace {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(match self {
            Self::Inner => "inner",
            Self::Loosest => "loosest",
            Self::Tightest => "tightest",
        })
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for OptimumPlace {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "OptimumPlace".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "string", "enum": ["inner", "loosest", "tightest"] })
    }
}

/// The best clamp.
#[derive(Debug, Clone)]
pub struct Optimum {
    /// The drive there.
    pub state: DriveState,
    /// Whether it is a maximum.
    pub bound: OptimumPlace,
    /// d(overall efficiency)/d(slack tension) there, 1/N.
    pub gradient: f64,
    /// Efficiency with losses besides friction, if that was sought.
    pub efficiency_with_losses: Option<f64>,
    /// Temperature of the belt, K, if it was to be found.
    pub belt_temperature: Option<f64>,
    /// Solutions it took.
    pub evaluations: usize,
    /// The solution.
    pub solved: Solved,
}

/// A slack tension tried.
#[derive(Debug, Clone)]
struct Trial {
    solved: Solved,
    heat: Option<Heat>,
    /// ln T_slack.
    place: f64,
    /// dη/d ln T_slack.
    slope: f64,
}

/// Finds the clamp of best overall efficiency for the torque of a case; the case's clamp does not matter. Where the
/// efficiency has several maxima, as it may when a belt hardly wraps, the highest is taken.
///
/// # Errors
/// See [`DesignError`].
pub fn optimum(case: &Resolved, options: &SolveOptions) -> Result<Optimum, DesignError> {
    if let (key @ (Key::PrimaryTorque | Key::SecondaryTorque), torque) = case.operating_point.load.setting()
        && torque <= 0.0
    {
        let expected = "the clamp of best efficiency is sought where the primary drives, for a torque above zero";
        return Err(DesignError::Given { key, expected });
    }
    // The clamp is what is sought: a margin against slip in its place does not matter, no more than a tension would.
    let (case, start) = clamped(&without_margin(case), options)?;
    let mut search = Search { case, options: *options, evaluations: 0 };
    let reference = search.case.stiffnesses.reference;
    let start = search.trial((start, reference))?;
    let mut trials = search.march(&start, 1.0)?;
    trials.reverse();
    trials.push(start.clone());
    trials.extend(search.march(&start, -1.0)?);
    // From tight to loose, the efficiency has a maximum where its slope turns from negative to positive.
    let mut best: Option<(f64, Trial, OptimumPlace)> = None;
    let told = search.case.clone();
    let mut offer = |trial: Trial, bound: OptimumPlace| -> Result<(), DesignError> {
        let efficiency = efficiency(&told, &trial, options)?;
        if best.as_ref().is_none_or(|(other, ..)| efficiency > *other) {
            best = Some((efficiency, trial, bound));
        }
        Ok(())
    };
    for pair in trials.windows(2) {
        if let [tight, loose] = pair
            && tight.slope <= 0.0
            && loose.slope > 0.0
        {
            offer(search.located(tight.clone(), loose.clone())?, OptimumPlace::Inner)?;
        }
    }
    if let Some(loosest) = trials.last().filter(|trial| trial.slope < 0.0) {
        offer(loosest.clone(), OptimumPlace::Loosest)?;
    }
    if let Some(tightest) = trials.first().filter(|trial| trial.slope > 0.0) {
        offer(tightest.clone(), OptimumPlace::Tightest)?;
    }
    match best {
        Some((_, trial, bound)) => search.finish(trial, bound),
        None => Err(Failure::NoEquations.into()),
    }
}

struct Search {
    case: Resolved,
    options: SolveOptions,
    evaluations: usize,
}

impl Search {
    /// From a solution with the belt at a temperature in K.
    fn trial(&mut self, from: (Solved, f64)) -> Result<Trial, DesignError> {
        self.evaluations += 1;
        let (solved, heat) = warmed(&self.case, &self.options, from)?;
        let tension = solved.constant(Constant::SlackTension);
        let slope = tension * gradient(&self.case, &solved, heat.as_ref(), &self.options)?;
        Ok(Trial { solved, heat, place: libm::log(tension), slope })
    }

    fn at(&mut self, place: f64, from: &Trial) -> Result<Trial, DesignError> {
        self.case.operating_point.clamp = Clamp::SlackTension(libm::exp(place));
        let (warm, temperature) = warm_start(&self.case, from.heat.as_ref());
        // Where the kinks of a string lie, a string nearby hardly says: see docs/string.md.
        let solved = match solve_from(&from.solved, &warm, &self.options) {
            Err(failure) if warm.model.bending.is_none() && !failure.is_cancelled() => solve(&warm, &self.options)?,
            other => other?,
        };
        self.trial((solved, temperature))
    }

    /// Goes to tighter (`direction` 1) belts until that costs efficiency, or to looser ones (−1) as far as there are
    /// any.
    fn march(&mut self, start: &Trial, direction: f64) -> Result<Vec<Trial>, DesignError> {
        let scale = start.solved.constant(Constant::PrimaryTorque) / start.solved.constant(Constant::PrimaryRadius);
        let range = libm::log(RANGE.0 * scale)..libm::log(RANGE.1 * scale);
        let (mut trials, mut here, mut step) = (Vec::new(), start.clone(), libm::log(FACTOR));
        while step >= libm::log(LEAST_FACTOR) && (direction < 0.0 || here.slope > 0.0) {
            let place = here.place + direction * step;
            if !range.contains(&place) {
                break;
            }
            match self.at(place, &here) {
                Ok(next) => {
                    trials.push(next.clone());
                    here = next;
                }
                // There may be no such belt; an end that was asked for says nothing of it.
                Err(DesignError::Start(failure)) if !failure.is_cancelled() => step *= 0.5,
                Err(error) => return Err(error),
            }
        }
        Ok(trials)
    }

    /// Where the slope is zero: regula falsi, the Illinois variant.
    fn located(&mut self, mut a: Trial, mut b: Trial) -> Result<Trial, DesignError> {
        let most = self.evaluations + LOCATING;
        while self.evaluations < most && (a.place - b.place).abs() > LOCATED && b.slope != 0.0 {
            let middle = (a.place * b.slope - b.place * a.slope) / (b.slope - a.slope);
            if (middle - b.place).abs() <= LOCATED {
                break;
            }
            let next = self.at(middle, &b).or_else(|_| self.at(middle, &a))?;
            if (next.slope < 0.0) == (b.slope < 0.0) {
                a.slope *= 0.5;
            } else {
                a = b;
            }
            b = next;
        }
        Ok(b)
    }

    fn finish(&self, best: Trial, bound: OptimumPlace) -> Result<Optimum, DesignError> {
        let with_losses = with_losses(&self.case).then(|| efficiency(&self.case, &best, &self.options)).transpose()?;
        Ok(Optimum {
            state: DriveState::of(&best.solved)?,
            bound,
            efficiency_with_losses: with_losses,
            belt_temperature: best.heat.map(|heat| heat.temperature),
            gradient: best.slope / best.solved.constant(Constant::SlackTension),
            evaluations: self.evaluations,
            solved: best.solved,
        })
    }
}

/// Whether the efficiency sought is that with losses besides friction: if the case asks for them.
fn with_losses(case: &Resolved) -> bool {
    case.losses.include == Some(Include::On)
}

/// The efficiency sought.
fn efficiency(case: &Resolved, trial: &Trial, options: &SolveOptions) -> Result<f64, DesignError> {
    if with_losses(case) {
        let temperature = BeltTemperature::from(trial.heat).kelvin(case);
        return Ok(losses(case, &trial.solved, temperature, options.tolerance)?.efficiency);
    }
    Ok(DriveState::of(&trial.solved)?.overall_efficiency)
}

/// d(efficiency sought)/d(slack tension), 1/N.
fn gradient(case: &Resolved, solved: &Solved, heat: Option<&Heat>, options: &SolveOptions) -> Result<f64, DesignError> {
    if let Some(heat) = heat {
        let sought = if with_losses(case) { LossOutput::Efficiency.name() } else { Output::EfficiencyOverall.name() };
        let rows = derivatives(case, options, solved, &BeltTemperature::Balanced(*heat))?;
        return match rows.get(sought).and_then(|row| row.get(Key::SlackTension.path())) {
            Some(found) => Ok(*found),
            // Only an efficiency with losses that cannot be told has no derivatives; the losses say why.
            None => {
                losses(case, solved, heat.temperature, options.tolerance)?;
                Err(DesignError::Losses(NoLosses::String))
            }
        };
    }
    if with_losses(case) {
        return match gradients(case, solved, case.stiffnesses.reference, options.tolerance) {
            Ok(gradients) => {
                let by_constant = gradients.by_constant[LossOutput::Efficiency].as_slice();
                Ok(Constants::try_from(by_constant)?[Constant::SlackTension])
            }
            Err(NoDerivatives::Losses(reason)) => Err(DesignError::Losses(reason)),
            Err(NoDerivatives::Internal(error)) => Err(error.into()),
            Err(NoDerivatives::Solve(error)) => Err(error.into()),
        };
    }
    let (_, gradients) = solved.belt.output_gradients(&solved.solution)?;
    let inputs = gradients.get(Output::EfficiencyOverall)?.to_vec();
    let functional = Functional { inputs, ..Functional::default() };
    let gradient = Linearisation::new(&solved.belt, &solved.solution)?.gradient(&functional);
    Ok(Constants::try_from(gradient.as_slice())?[Constant::SlackTension])
}
