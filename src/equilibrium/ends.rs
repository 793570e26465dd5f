//! The ends of the phases of a shift curve, and the speeds at which its points are computed.

use super::curve::{Landmark, ShiftBranch, ShiftOptions};
use super::error::EquilibriumError;
use super::heat::warm_corner;
use super::phase::{Direction, Phase, Stop};
use super::point::Equilibrium;
use super::question::{Given, Whole};
use super::search::at_speed;
use crate::case::Resolved;
use crate::drive::Constant;
use crate::model::Output;
use crate::quantity::rpm;

/// Speeds of the secondary at which a first equilibrium is sought.
const FIRST: usize = 24;
/// Speed efficiency at take-off over that at shift-out, where a belt that sinks into small radii loses some as well.
const TAKE_OFF: f64 = 0.95;
/// Steps towards the end of a phase at most, and by what the secondary's speed changes with each.
const APPROACHES: usize = 10;
const APPROACH: f64 = 0.85;
/// The logarithm of the least such change: one that leads nowhere is halved.
const LEAST_APPROACH: f64 = 5e-3;
/// Shares of the speed of the secondary at which the engine comes to its last speed, from which the high stop is sought
/// where it is not found from below: a belt that sinks into its grooves makes the ratio smaller than the sheaves'.
const FROM_ABOVE: [f64; 2] = [1.0, 1.06];
/// Share of the engine's last speed at which the curve ends.
const LAST_SPEED: f64 = 0.995;

/// Equilibria at the ends of the phases.
#[derive(Debug, Clone, Default)]
pub(super) struct Corners {
    take_off: Option<Equilibrium>,
    low: Option<Equilibrium>,
    first: Option<Equilibrium>,
    high: Option<Equilibrium>,
    /// One at the high stop, where no state leads to it from between the stops.
    resting: Option<Equilibrium>,
}

impl Corners {
    /// From where the curve's first point is sought.
    pub(super) fn begin(&self) -> Option<Equilibrium> {
        [&self.take_off, &self.low, &self.first, &self.high].into_iter().find_map(Clone::clone)
    }
}

/// The search for the ends of a curve; why one is missing becomes a remark of its branch.
pub(super) struct Search<'a> {
    pub case: &'a Resolved,
    pub direction: Direction,
    pub options: &'a ShiftOptions,
    pub branch: &'a mut ShiftBranch,
}

impl Search<'_> {
    /// Take-off, shift-out and full shift, from a first equilibrium wherever there is one; or from those of a drive
    /// nearby.
    pub(super) fn corners(&mut self, near: Option<&Corners>) -> Result<Corners, EquilibriumError> {
        let near = near.cloned().unwrap_or_default();
        let first = if near.low.is_some() { near.low.clone() } else { self.first()? };
        let mut corners = Corners { first, ..Corners::default() };
        let Some(first) = corners.first.clone() else { return Ok(corners) };
        if first.phase == Phase::Held {
            return Ok(corners);
        }
        let low = self.corner(&first, Given::Corner(Stop::SecondaryClosed));
        corners.low = self.or_remark("shift-out", low)?;
        let from = corners.low.as_ref().unwrap_or(&first).clone();
        let holding = from.output(Output::EfficiencySpeed)?;
        let from = near.take_off.as_ref().unwrap_or(&from);
        let take_off = self.corner(from, Given::SpeedEfficiency(TAKE_OFF * holding));
        corners.take_off = self.or_remark("take-off", take_off)?;
        let first = near.high.unwrap_or(first);
        let actuation = self.case.parts.actuation.as_ref();
        let stops = [
            actuation.and_then(|parts| parts.primary_travel).map(|_| Stop::PrimaryClosed),
            actuation.and_then(|parts| parts.secondary_travel).map(|_| Stop::SecondaryOpen),
        ];
        for stop in stops.into_iter().flatten() {
            let mut found = self.corner(&first, Given::Corner(stop));
            if found.as_ref().is_err_and(|error| !error.is_cancelled()) {
                // Between the stops a belt may buckle before it comes to the one at which it is held.
                let resting = self.at_high_stop(stop)?;
                let from_above = resting.as_ref().map(|resting| self.corner(resting, Given::Corner(stop)));
                found = from_above.and_then(Result::ok).map_or(found, Ok);
                corners.resting = corners.resting.or(resting);
            }
            let found = self.or_remark("full shift", found)?;
            // The stop that is met first.
            let earlier = match (&corners.high, &found) {
                (Some(old), Some(new)) => new.primary_travel < old.primary_travel,
                (None, Some(_)) => true,
                (_, None) => false,
            };
            if earlier {
                corners.high = found;
            }
        }
        let landmark = |found: &Option<Equilibrium>| found.as_ref().map(Landmark::of).transpose();
        self.branch.take_off = landmark(&corners.take_off)?;
        self.branch.shift_out = landmark(&corners.low)?;
        self.branch.full_shift = landmark(&corners.high)?;
        Ok(corners)
    }

    /// An equilibrium to begin with, best one between the stops.
    fn first(&mut self) -> Result<Option<Equilibrium>, EquilibriumError> {
        let (slowest, fastest) = self.range();
        let mut last = None;
        let speeds = (0..FIRST).map(|at| slowest * libm::pow(fastest / slowest, (at as f64 + 0.5) / FIRST as f64));
        let whole = |speed| Whole::new(self.case, Given::SecondarySpeed(speed), self.direction);
        let mut ordered: Vec<(f64, bool)> = Vec::new();
        for speed in speeds {
            ordered.push((speed, whole(speed)?.rough().phase == Phase::Shift));
        }
        // From the middle of those that seem to lie between the stops.
        let between: Vec<f64> = ordered.iter().filter(|(_, between)| *between).map(|(speed, _)| *speed).collect();
        let middle = between.get(between.len() / 2).copied().unwrap_or((slowest * fastest).sqrt());
        let near = |speed: f64| libm::log(speed / middle).abs();
        ordered.sort_by(|(a, _), (b, _)| near(*a).total_cmp(&near(*b)));
        // One after the other ever farther from there, and then those between.
        const ATTEMPTS: usize = 6;
        let between = ordered.iter().skip(1).step_by(2).take(ATTEMPTS);
        for (speed, _) in ordered.iter().step_by(2).take(ATTEMPTS).chain(between).copied() {
            match at_speed(self.case, speed, self.direction, &self.options.solve) {
                Ok(found) => return Ok(Some(found)),
                Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
                Err(error) => last = Some(error),
            }
        }
        self.branch.remarks.extend(last.map(|error| format!("no equilibrium was found to begin with: {error}")));
        Ok(None)
    }

    /// An end of a phase; where there is none, a remark that says why.
    fn or_remark(
        &mut self,
        what: &str,
        found: Result<Equilibrium, EquilibriumError>,
    ) -> Result<Option<Equilibrium>, EquilibriumError> {
        match found {
            Ok(found) => Ok(Some(found)),
            Err(error) if error.is_cancelled() => Err(error),
            Err(error) => {
                self.branch.remarks.push(format!("no {what}: {error}"));
                Ok(None)
            }
        }
    }

    /// A state at a high stop, near the last speed at which the drive rests there.
    fn at_high_stop(&self, stop: Stop) -> Result<Option<Equilibrium>, EquilibriumError> {
        let Some(last) = self.last_at_high_stop() else { return Ok(None) };
        for share in FROM_ABOVE {
            match at_speed(self.case, share * last, self.direction, &self.options.solve) {
                Ok(found) if found.phase == Phase::High(stop) => return Ok(Some(found)),
                Err(error) if error.is_cancelled() => return Err(error),
                Ok(_) | Err(_) => {}
            }
        }
        Ok(None)
    }

    /// Speed of the secondary in rad/s at which the engine comes to the last speed for which its torque is given, with
    /// the sheaves at their high stop; nothing for a drive without one.
    fn last_at_high_stop(&self) -> Option<f64> {
        let whole = Whole::new(self.case, Given::Corner(Stop::PrimaryClosed), self.direction).ok()?;
        let last = whole.engine.range().1;
        let (ratio, stop) = whole.highest_ratio(last);
        stop.map(|_| LAST_SPEED * last / ratio)
    }

    /// An end of a phase; where it is out of reach at once, from states ever nearer to it.
    fn corner(&self, from: &Equilibrium, given: Given) -> Result<Equilibrium, EquilibriumError> {
        let solve = &self.options.solve;
        let end = |from: &Equilibrium| warm_corner(from, self.case, given, self.direction, solve);
        let error = match end(from) {
            Err(error) if !error.is_cancelled() => error,
            done => return done,
        };
        let toward = match given {
            Given::Corner(Stop::PrimaryClosed | Stop::SecondaryOpen) => 1.0 / APPROACH,
            Given::Corner(Stop::SecondaryClosed) | Given::SpeedEfficiency(_) | Given::SecondarySpeed(_) => APPROACH,
        };
        let (mut here, mut step) = (from.clone(), libm::log(toward));
        for _ in 0..APPROACHES {
            if step.abs() < LEAST_APPROACH {
                break;
            }
            let Ok(speed) = here.output(Output::SecondarySpeed) else { break };
            let speed = libm::exp(step) * speed;
            let Ok(whole) = Whole::new(self.case, Given::SecondarySpeed(speed), self.direction) else { break };
            let Ok(next) = whole.settle_from(&here.solved, here.phase, solve) else {
                step *= 0.5;
                continue;
            };
            here = next;
            if let Ok(found) = end(&here) {
                return Ok(found);
            }
        }
        Err(error)
    }

    /// Speeds of the secondary between which a first equilibrium may lie.
    fn range(&self) -> (f64, f64) {
        let (slowest, fastest) = self.case.parts.engine.as_ref().map_or((100.0, 400.0), |engine| engine.range());
        let engaged = self.branch.engagement.unwrap_or(slowest).clamp(slowest, fastest);
        (engaged / 4.0, fastest * 1.5)
    }

    /// Speeds of the secondary at which points are computed.
    pub(super) fn speeds(&mut self, corners: &Corners) -> Vec<f64> {
        let speed =
            |found: &Option<Equilibrium>| found.as_ref().and_then(|found| found.output(Output::SecondarySpeed).ok());
        let (slowest, fastest) = self.range();
        let last = self.case.parts.engine.as_ref().map_or(fastest, |engine| engine.range().1);
        // At the high stop the engine's last speed ends the curve, whether or not a state was found there; in a drive
        // without such a stop, at the ratio of whatever state there is.
        let last_at = |found: &Equilibrium| {
            let radius = |constant: Constant| found.solved.constant(constant);
            LAST_SPEED * last * radius(Constant::PrimaryRadius) / radius(Constant::SecondaryRadius)
        };
        let first = corners.first.as_ref();
        let held = first.filter(|found| found.phase == Phase::Held);
        let end = corners
            .high
            .as_ref()
            .or(corners.resting.as_ref())
            .or(held)
            .map(last_at)
            .or_else(|| self.last_at_high_stop());
        let end = end.or(first.map(last_at)).unwrap_or(LAST_SPEED * last);
        let from = self.options.from.or(speed(&corners.take_off)).unwrap_or(slowest);
        let to = self.options.to.unwrap_or(end);
        if from > to {
            self.branch.remarks.push(format!(
                "the curve would begin at a secondary speed of {:.0} rpm and end at {:.0} rpm, {}",
                rpm(from),
                rpm(to),
                if self.options.to.is_some() {
                    "which is below where the belt takes off: name where it begins as well"
                } else {
                    "where the engine's torque is known no farther: name where it ends as well"
                }
            ));
        }
        let mut ends = vec![from];
        ends.extend([speed(&corners.low), speed(&corners.high)].into_iter().flatten());
        ends.push(to);
        ends.retain(|speed| *speed >= from && *speed <= to);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        if ends.len() < 2 {
            return ends;
        }
        // Half of the points lie between the stops.
        let phases = ends.len() - 1;
        let share = |piece: usize| match (phases, piece) {
            (3, 1) => 0.5,
            (3, _) => 0.25,
            _ => 1.0 / phases as f64,
        };
        let mut speeds = vec![from];
        for (piece, pair) in ends.windows(2).enumerate() {
            let &[begin, end] = pair else { continue };
            let count = ((self.options.points as f64 * share(piece)).round() as usize).max(1);
            speeds.extend((1..=count).map(|at| begin + (end - begin) * at as f64 / count as f64));
        }
        speeds
    }
}
