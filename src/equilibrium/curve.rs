//! The shift curve: equilibria over the speed of the secondary, up and back, in the phases of a launch.

use std::ops::ControlFlow;

use serde::Serialize;

use super::error::EquilibriumError;
use super::heat::warm_corner;
use super::point::{Direction, Equilibrium, Phase, ReportedPhase, Stop};
use super::question::{Given, Whole};
use super::report::DriveReport;
use super::search::{equilibrium, equilibrium_from};
use super::walk::ShiftWalk;
use crate::actuator::PrimaryActuator;
use crate::case::Resolved;
use crate::drive::{Constant, SolveOptions};
use crate::model::Output;
use crate::quantity::rpm;

/// How a shift curve is computed.
#[derive(Debug, Clone)]
pub struct ShiftOptions {
    /// Points of each direction, shared among low ratio, shifting and high ratio.
    pub points: usize,
    /// The directions.
    pub directions: Vec<Direction>,
    /// Speed of the secondary in rad/s at which the curve begins; where the belt takes off, if not given.
    pub from: Option<f64>,
    /// Speed of the secondary in rad/s at which it ends; where the engine's torque is known no farther, if not given.
    pub to: Option<f64>,
    /// How each point is solved.
    pub solve: SolveOptions,
}

impl Default for ShiftOptions {
    fn default() -> Self {
        Self {
            points: 24,
            directions: vec![Direction::Up, Direction::Back],
            from: None,
            to: None,
            solve: SolveOptions::default(),
        }
    }
}

/// Speeds of a point of a shift curve that means something by itself, rad/s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Landmark {
    /// Speed of the primary.
    pub primary_speed: f64,
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// R_S/R_P.
    pub ratio: f64,
}

impl Landmark {
    fn of(found: &Equilibrium) -> Result<Self, EquilibriumError> {
        let solved = &found.solved;
        Ok(Self {
            primary_speed: found.primary_speed(),
            secondary_speed: found.output(Output::SecondarySpeed)?,
            ratio: solved.constant(Constant::SecondaryRadius) / solved.constant(Constant::PrimaryRadius),
        })
    }
}

/// One point of a shift curve.
#[derive(Debug, Clone)]
pub struct ShiftPoint {
    /// Which way the drive shifts.
    pub direction: Direction,
    /// Speed of the secondary, rad/s.
    pub secondary_speed: f64,
    /// The equilibrium, or why there is none.
    pub report: Result<Box<DriveReport>, String>,
}

/// The shift curve in one direction.
#[derive(Debug, Clone)]
pub struct ShiftBranch {
    /// Which way the drive shifts.
    pub direction: Direction,
    /// Speed of the primary in rad/s from which flyweights overcome their spring.
    pub engagement: Option<f64>,
    /// Where the belt carries the engine's torque with a twentieth of the speed lost beyond what is lost where the
    /// drive shifts out: the clutch slips until then.
    pub take_off: Option<Landmark>,
    /// Where the drive leaves the low stop.
    pub shift_out: Option<Landmark>,
    /// Where it arrives at the high stop.
    pub full_shift: Option<Landmark>,
    /// The points, by increasing speed of the secondary.
    pub points: Vec<ShiftPoint>,
    /// Why something is missing.
    pub remarks: Vec<String>,
}

impl ShiftBranch {
    /// A report of one of its points, which knows where the belt takes off: like the other phases, that of engagement
    /// has its end for its last point.
    pub(super) fn in_phases(&self, report: DriveReport) -> DriveReport {
        let engaging = self.take_off.is_some_and(|at| report.secondary_speed <= at.secondary_speed * (1.0 + SAME));
        let phase =
            if engaging && report.phase == ReportedPhase::Low { ReportedPhase::Engagement } else { report.phase };
        DriveReport { phase, ..report }
    }
}

/// Share of a speed by which two that are one differ, each solved to a tolerance of its own.
const SAME: f64 = 1e-6;
/// Speeds of the secondary at which a first equilibrium is sought.
const FIRST: usize = 24;
/// Speed efficiency at take-off over that at shift-out, where a belt that sinks into small radii loses some as well.
const TAKE_OFF: f64 = 0.95;
/// Steps towards the end of a phase at most, and by what the secondary's speed changes with each.
const APPROACHES: usize = 8;
const APPROACH: f64 = 0.85;
/// Share of the engine's last speed at which the curve ends.
const LAST_SPEED: f64 = 0.995;

/// The speed in rad/s from which the flyweights of a case overcome their spring at no travel; nothing for a servo, and
/// for flyweights without a spring.
///
/// # Errors
/// [`EquilibriumError::Actuator`] if they do not press.
pub fn engagement_speed(case: &Resolved, direction: Direction) -> Result<Option<f64>, EquilibriumError> {
    let Some(actuation) = &case.parts.actuation else { return Ok(None) };
    let PrimaryActuator::Flyweights { flyweights, spring: Some(spring) } = &actuation.primary else { return Ok(None) };
    let told = |error| EquilibriumError::Actuator { phase: Phase::Low, error };
    // Flyweights press with the square of the speed.
    let at_one = flyweights.force(1.0, 0.0, direction.primary()).map_err(told)?.value;
    let against = spring.force(0.0).map_err(told)?.value;
    Ok((at_one > 0.0).then(|| (against / at_one).sqrt()))
}

/// The shift curve in one direction; `see` is shown each point as it is found, and may end the search, which keeps what
/// there is.
///
/// # Errors
/// A case that lacks a part, or that the search is cancelled: points without an equilibrium are told as such, and the
/// curve goes on.
pub fn shift_branch(
    case: &Resolved,
    direction: Direction,
    options: &ShiftOptions,
    see: &mut dyn FnMut(&ShiftPoint) -> ControlFlow<()>,
) -> Result<ShiftBranch, EquilibriumError> {
    let mut walk = ShiftWalk::begin(case, direction, options)?;
    while let Some(point) = walk.step()? {
        if see(point).is_break() {
            walk.end();
        }
    }
    Ok(walk.into_branch())
}

/// Equilibria at the ends of the phases.
#[derive(Debug, Clone, Default)]
pub(super) struct Corners {
    take_off: Option<Equilibrium>,
    low: Option<Equilibrium>,
    first: Option<Equilibrium>,
    high: Option<Equilibrium>,
}

impl Corners {
    /// From where the curve's first point is sought.
    pub(super) fn begin(&self) -> Option<Equilibrium> {
        [&self.take_off, &self.low, &self.first, &self.high].into_iter().find_map(Clone::clone)
    }
}

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
        corners.low = self.corner(&first, Given::Corner(Stop::SecondaryClosed), "shift-out");
        let from = corners.low.as_ref().unwrap_or(&first).clone();
        let holding = from.output(Output::EfficiencySpeed)?;
        let from = near.take_off.as_ref().unwrap_or(&from);
        corners.take_off = self.corner(from, Given::SpeedEfficiency(TAKE_OFF * holding), "take-off");
        let first = near.high.unwrap_or(first);
        let actuation = self.case.parts.actuation.as_ref();
        let stops = [
            actuation.and_then(|parts| parts.primary_travel).map(|_| Stop::PrimaryClosed),
            actuation.and_then(|parts| parts.secondary_travel).map(|_| Stop::SecondaryOpen),
        ];
        for stop in stops.into_iter().flatten() {
            let found = self.corner(&first, Given::Corner(stop), "full shift");
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
        const ATTEMPTS: usize = 6;
        for (speed, _) in ordered.into_iter().step_by(2).take(ATTEMPTS) {
            match equilibrium(self.case, speed, self.direction, &self.options.solve) {
                Ok(found) => return Ok(Some(found)),
                Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
                Err(error) => last = Some(error),
            }
        }
        self.branch.remarks.extend(last.map(|error| format!("no equilibrium was found to begin with: {error}")));
        Ok(None)
    }

    /// An end of a phase; where it is out of reach at once, from states ever nearer to it.
    fn corner(&mut self, from: &Equilibrium, given: Given, what: &str) -> Option<Equilibrium> {
        let solve = &self.options.solve;
        let end = |from: &Equilibrium| warm_corner(from, self.case, given, self.direction, solve);
        let error = match end(from) {
            Ok(found) => return Some(found),
            Err(error) => error,
        };
        let toward = match given {
            Given::Corner(Stop::PrimaryClosed | Stop::SecondaryOpen) => 1.0 / APPROACH,
            Given::Corner(Stop::SecondaryClosed) | Given::SpeedEfficiency(_) | Given::SecondarySpeed(_) => APPROACH,
        };
        let mut here = from.clone();
        for _ in 0..APPROACHES {
            let Ok(speed) = here.output(Output::SecondarySpeed) else { break };
            let Ok(next) = equilibrium_from(&here, self.case, toward * speed, self.direction, solve) else { break };
            here = next;
            if let Ok(found) = end(&here) {
                return Some(found);
            }
        }
        self.branch.remarks.push(format!("no {what}: {error}"));
        None
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
        // At the high stop the engine's last speed ends the curve.
        let ratio = corners.high.as_ref().or(corners.first.as_ref()).map_or(1.0, |found| {
            found.solved.constant(Constant::SecondaryRadius) / found.solved.constant(Constant::PrimaryRadius)
        });
        let from = self.options.from.or(speed(&corners.take_off)).unwrap_or(slowest);
        let to = self.options.to.unwrap_or(LAST_SPEED * last / ratio);
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
