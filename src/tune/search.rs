//! The search through a box of parts: every combination screened on the map, the best confirmed by full solutions.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use serde::Serialize;

use super::belongs;
use super::error::TuneError;
use super::full::{efficiency, solved_point};
use super::parts::PartsBox;
use super::screen::{Screen, Work, ends, ratios};
use super::unfit::ShiftPoint;
use crate::beltmap::{BeltMap, MapAxis, MapError, MapOptions, MapPlan};
use crate::cancel::is_cancelled;
use crate::case::{Case, Key, Resolved};
use crate::drive::SolveOptions;
use crate::equilibrium::{Direction, Equilibrium, equilibrium, equilibrium_from};
use crate::powertrain::{Engine, Governor};
use crate::quantity::rpm;
use crate::study::StudyError;
use crate::threads;

/// Speeds of the map around the target, as shares of it.
const SPEEDS: (f64, f64) = (0.6, 1.25);
/// Slack tensions of the map, N over the largest torque over the smallest radius of the primary.
const TENSIONS: (f64, f64) = (0.03, 0.6);
/// Least span of the map's torques, as a share of the largest.
const TORQUES: f64 = 0.1;
/// How far the map's torques reach beyond those of the curve's samples, as a share of the largest.
const BEYOND: f64 = 0.01;
/// Share of the torque that the governor leaves at the largest speed of the map.
const LEFT: f64 = 0.4;
/// How much the map reaches beyond both ends of the shift, as a share of the ratio.
const MARGIN: f64 = 1e-9;

/// What is searched for, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct TuneOptions {
    /// Speed that the engine is to hold over the shift, rad/s.
    pub target: f64,
    /// Points of the shift.
    pub points: usize,
    /// Least slip reserve over the shift of a tune that is ranked.
    pub least_reserve: f64,
    /// How many of the best are confirmed by full solutions.
    pub confirmed: usize,
    /// For these.
    pub solve: SolveOptions,
    /// Threads; all cores if not given.
    pub jobs: Option<usize>,
}

impl TuneOptions {
    /// For a target speed in rad/s.
    pub fn new(target: f64) -> Self {
        let solve = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
        Self { target, points: 11, least_reserve: 0.0, confirmed: 10, solve, jobs: None }
    }
}

/// What a combination of parts does over the shift.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Merits {
    /// Root mean square of the primary's speed less the target, rad/s.
    pub rms_deviation: f64,
    /// Mean of the primary's speed, rad/s.
    pub mean_speed: f64,
    /// Smallest share of the friction at hand that is left over.
    pub smallest_slip_reserve: f64,
    /// Mean of power out over power in, with losses besides friction where the case has them.
    pub mean_efficiency: f64,
}

impl Merits {
    /// The smaller deviation first; of equal ones the larger slip reserve, and then the larger efficiency.
    fn better_first(&self, other: &Self) -> Ordering {
        let by_reserve = other.smallest_slip_reserve.total_cmp(&self.smallest_slip_reserve);
        let by_efficiency = other.mean_efficiency.total_cmp(&self.mean_efficiency);
        self.rms_deviation.total_cmp(&other.rms_deviation).then(by_reserve).then(by_efficiency)
    }
}

/// A combination of parts that shifts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Tune {
    /// Its number: the combinations in the order of the names of kinds and parts, the last kind fastest.
    pub candidate: usize,
    /// Names of its parts, by kind.
    pub parts: BTreeMap<String, String>,
    /// As screened on the map.
    #[serde(flatten)]
    pub merits: Merits,
    /// Points over which these are: fewer than were asked for where a sheave comes to its stop before the last but one.
    pub points: usize,
    /// Nominal ratio of the last: where a sheave comes to its stop at high ratio, at the latest where the shifts end of
    /// belts without load.
    pub last_ratio: f64,
    /// Whether no other beats it: is no worse in deviation, slip reserve and efficiency, and better in one of them.
    pub pareto: bool,
    /// As full solutions have it, of the best.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub confirmed: Option<Confirmed>,
    /// The shift on the map.
    #[serde(skip)]
    pub shift: Vec<ShiftPoint>,
}

/// What full solutions say of a combination.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Confirmed {
    /// Over the points of the shift on the map that have a solution at their speed of the secondary.
    #[serde(flatten)]
    pub merits: Option<Merits>,
    /// How many of the points have one.
    pub points: usize,
    /// How many of these rest on a stop: the first and the last point of a shift may lie where a sheave touches one.
    pub at_stop: usize,
    /// Largest difference of the primary's speed between map and full solution, rad/s.
    pub largest_difference: f64,
    /// Why points have none.
    pub failures: Vec<String>,
}

/// Why combinations were refused.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Refused {
    /// What is wrong with them, in a word.
    pub reason: String,
    /// How many.
    pub count: usize,
    /// The first of them.
    pub candidate: usize,
    /// What is wrong with that.
    pub example: String,
}

/// What was found in a box of parts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Ranking {
    /// Speed asked for, rad/s.
    pub target: f64,
    /// Combinations.
    pub candidates: usize,
    /// Points of the shift of each, at most.
    pub points: usize,
    /// Nominal ratios of these; the shift of a combination ends before the last where a sheave comes to its stop.
    pub ratios: Vec<f64>,
    /// Readings of the map.
    pub readings: usize,
    /// Points that were sought by full solutions while the combinations were screened, because the map has no values
    /// there.
    pub in_full: usize,
    /// Combinations that shift on the map with the reserve asked for, the smallest deviation first.
    pub tunes: Vec<Tune>,
    /// The others.
    pub refused: Vec<Refused>,
}

/// A drive with a box of parts.
#[derive(Debug, Clone)]
pub struct TunePlan {
    case: Case,
    parts: PartsBox,
    options: TuneOptions,
    /// The first combination that makes a drive.
    first_case: Case,
    first: Resolved,
    ratios: Vec<f64>,
}

impl TunePlan {
    /// A search. The case has all of a drive that no kind of part sets: belt, sheaves, stops, engine.
    ///
    /// # Errors
    /// See [`TuneError`].
    pub fn new(case: Case, parts: PartsBox, options: TuneOptions) -> Result<Self, TuneError> {
        check(&options)?;
        parts.check()?;
        let mut reason = None;
        let first = (0..parts.candidates()).find_map(|candidate| {
            let made = parts.case(&case, candidate).and_then(|case| Ok((case.resolve()?, case)));
            made.map_err(|error| _ = reason.get_or_insert(error.to_string())).ok()
        });
        let count = parts.candidates();
        let (first, first_case) =
            first.ok_or_else(|| TuneError::NoDrive { count, reason: reason.unwrap_or_default() })?;
        let actuation = first.parts.actuation.as_ref().ok_or(TuneError::Missing {
            what: "actuators",
            needs: "give [primary.actuator] and [secondary.actuator] in the case or in the file of parts",
        })?;
        let engine = first.parts.engine.as_ref();
        let engine =
            engine.ok_or(TuneError::Missing { what: "engine", needs: "give [engine] with speeds and torques" })?;
        speeds(engine, options.target)?;
        let ratios = ratios(ends(&first, actuation)?, options.points);
        Ok(Self { case, parts, options, first_case, first, ratios })
    }

    /// The first combination of parts that makes a drive, with everything decided.
    pub fn case(&self) -> &Resolved {
        &self.first
    }

    /// The box of parts.
    pub fn parts(&self) -> &PartsBox {
        &self.parts
    }

    /// The map on which combinations are screened: of the drive's belt over ratio, torque and speed of the primary and
    /// slack tension, as far as its shifts may lead.
    ///
    /// # Errors
    /// See [`TuneError`].
    pub fn map(&self, options: MapOptions) -> Result<MapPlan, TuneError> {
        let engine = self.first.parts.engine.as_ref();
        let engine = engine.ok_or(TuneError::Missing { what: "engine", needs: "give [engine]" })?;
        let (from, to) = speeds(engine, self.options.target)?;
        let speed = |share: f64| from + share * (to - from);
        let torques = (0..=200).map(|i| engine.torque(speed(f64::from(i) / 200.0)).value);
        let (low, high) = torques.fold((f64::INFINITY, 0.0_f64), |(low, high), at| (low.min(at), high.max(at)));
        // The curve may pass its samples a little.
        let (low, high) = (low.min((1.0 - TORQUES) * high) - BEYOND * high, (1.0 + BEYOND) * high);
        let ends = (self.ratios.first().copied().unwrap_or(1.0), self.ratios.last().copied().unwrap_or(1.0));
        let (slow, fast) = (ends.0 * (1.0 + MARGIN), ends.1 * (1.0 - MARGIN));
        let pull = high / self.smallest_radius();
        let first = [fast, (fast * slow).sqrt(), slow];
        let axes = vec![
            MapAxis::new(Key::Ratio, first)?,
            MapAxis::new(Key::PrimarySpeed, [from, to])?,
            MapAxis::new(Key::PrimaryTorque, [low, high])?,
            MapAxis::new(Key::SlackTension, [TENSIONS.0, 0.1, 0.2, 0.35, TENSIONS.1].map(|share| share * pull))?,
        ];
        Ok(MapPlan::new(self.first_case.clone(), axes, options)?)
    }

    /// Whether a map is one on which this drive can be screened: over what the search needs, and made with this case's
    /// belt, sheaves, edition and losses.
    ///
    /// # Errors
    /// [`TuneError::Axis`], [`TuneError::OtherMap`], and those of [`TunePlan::map`].
    pub fn check_map(&self, map: &BeltMap) -> Result<(), TuneError> {
        Screen::new(map)?;
        belongs::check(map, self.map(MapOptions::default())?.case())
    }

    /// Radius of the primary at low ratio, m.
    fn smallest_radius(&self) -> f64 {
        let ratio = self.ratios.first().copied().unwrap_or(1.0);
        let (length, center) = (self.first.belt.length, self.first.drive.center_distance);
        crate::case::geometry::radii_of_ratio(ratio, length, center)
            .map_or(self.first.drive.primary_radius, |radii| radii.0)
    }

    /// Screens every combination on a map, and confirms the best. `done` hears of each screened combination.
    ///
    /// # Errors
    /// Those of [`TunePlan::check_map`], [`TuneError::Threads`], and cancellation. A combination that makes no drive is
    /// counted among the refused.
    pub fn search(&self, map: &BeltMap, done: &(dyn Fn() + Sync)) -> Result<Ranking, TuneError> {
        self.check_map(map)?;
        let screen = Screen::new(map)?;
        let jobs = self.options.jobs.unwrap_or(0);
        let cancelled = || TuneError::from(MapError::Study(StudyError::Cancelled));
        let screened = threads::map(jobs, self.parts.candidates(), |candidate| {
            let found = (!is_cancelled()).then(|| self.screened(&screen, candidate));
            done();
            found
        });
        let screened: Option<Vec<_>> = screened.map_err(|_| TuneError::Threads(jobs))?.into_iter().collect();
        let screened = screened.ok_or_else(cancelled)?;
        let mut ranking = Ranking {
            target: self.options.target,
            candidates: self.parts.candidates(),
            points: self.ratios.len(),
            ratios: self.ratios.clone(),
            readings: screened.iter().map(|(work, _)| work.readings).sum(),
            in_full: screened.iter().map(|(work, _)| work.in_full).sum(),
            tunes: Vec::new(),
            refused: Vec::new(),
        };
        for (candidate, (_, found)) in screened.into_iter().enumerate() {
            match found {
                Ok(tune) => ranking.tunes.push(tune),
                Err((reason, example)) => match ranking.refused.iter_mut().find(|refused| refused.reason == reason) {
                    Some(refused) => refused.count += 1,
                    None => ranking.refused.push(Refused { reason, count: 1, candidate, example }),
                },
            }
        }
        ranking.tunes.sort_by(|a, b| a.merits.better_first(&b.merits));
        mark_pareto(&mut ranking.tunes);
        let best = ranking.tunes.len().min(self.options.confirmed);
        let confirmed = threads::map(jobs, best, |at| ranking.tunes.get(at).map(|tune| self.confirm(tune)));
        let confirmed = confirmed.map_err(|_| TuneError::Threads(jobs))?;
        if is_cancelled() {
            return Err(cancelled());
        }
        for (tune, confirmed) in ranking.tunes.iter_mut().zip(confirmed) {
            tune.confirmed = confirmed;
        }
        Ok(ranking)
    }

    /// A combination on the map, with the work it took; or why it is refused, in a word and in full.
    fn screened(&self, screen: &Screen<'_>, candidate: usize) -> (Work, Result<Tune, (String, String)>) {
        let mut work = Work::default();
        let found = self.shift(screen, candidate, &mut work);
        (work, found)
    }

    fn shift(&self, screen: &Screen<'_>, candidate: usize, work: &mut Work) -> Result<Tune, (String, String)> {
        let of_case = |error: crate::case::CaseError| ("parts that make no drive".to_owned(), error.to_string());
        let case = self.parts.case(&self.case, candidate).and_then(|case| case.resolve()).map_err(of_case)?;
        let none = || ("parts that make no drive".to_owned(), "it has no actuators, or no engine".to_owned());
        let (actuation, engine) = (case.parts.actuation.as_ref(), case.parts.engine.as_ref());
        let (actuation, engine) = (actuation.ok_or_else(none)?, engine.ok_or_else(none)?);
        let asked = (self.ratios.as_slice(), self.options.target);
        let shift = screen.shift(&case, actuation, engine, asked, work);
        let shift = shift.map_err(|unfit| (unfit.kind().to_owned(), unfit.to_string()))?;
        let merits = merits(&shift, self.options.target);
        if merits.smallest_slip_reserve < self.options.least_reserve {
            let reserve = format!("its smallest slip reserve is {:.1} %", 100.0 * merits.smallest_slip_reserve);
            return Err(("slip reserve below what is asked for".to_owned(), reserve));
        }
        let names = self.parts.kinds.iter().zip(self.parts.parts(candidate));
        let parts = names.map(|(kind, part)| (kind.name.clone(), part.name.clone())).collect();
        let (points, last_ratio) = (shift.len(), shift.last().map_or(f64::NAN, |last| last.ratio));
        Ok(Tune { candidate, parts, merits, points, last_ratio, pareto: false, confirmed: None, shift })
    }

    /// The equilibrium of the whole drive at every secondary speed of a shift.
    fn confirm(&self, tune: &Tune) -> Confirmed {
        let mut confirmed =
            Confirmed { merits: None, points: 0, at_stop: 0, largest_difference: 0.0, failures: Vec::new() };
        let case = match self.parts.case(&self.case, tune.candidate).and_then(|case| case.resolve()) {
            Ok(case) => case,
            Err(error) => {
                confirmed.failures.push(error.to_string());
                return confirmed;
            }
        };
        let mut shift = Vec::new();
        let mut near: Option<Equilibrium> = None;
        for point in &tune.shift {
            let (speed, options) = (point.secondary_speed, &self.options.solve);
            let found = match &near {
                Some(near) => equilibrium_from(near, &case, speed, Direction::Up, options),
                None => equilibrium(&case, speed, Direction::Up, options),
            };
            match found {
                Ok(found) => {
                    let efficiency = match efficiency(&case, &found, self.options.solve.tolerance) {
                        Ok(efficiency) => efficiency,
                        Err(reason) => {
                            confirmed.failures.push(format!("at ratio {:.2}: {reason}", point.ratio));
                            continue;
                        }
                    };
                    let here = solved_point(&found, (point.ratio, speed), efficiency);
                    confirmed.largest_difference =
                        confirmed.largest_difference.max((here.primary_speed - point.primary_speed).abs());
                    confirmed.at_stop += usize::from(found.phase.stop().is_some());
                    shift.push(here);
                    near = Some(found);
                }
                Err(error) => confirmed.failures.push(format!("at ratio {:.2}: {error}", point.ratio)),
            }
        }
        confirmed.points = shift.len();
        confirmed.merits = (!shift.is_empty()).then(|| merits(&shift, self.options.target));
        confirmed
    }
}

fn check(options: &TuneOptions) -> Result<(), TuneError> {
    let parameter = |what, given: String, holds: bool, expected: &str| {
        if holds { Ok(()) } else { Err(TuneError::Parameter { what, given, expected: expected.to_owned() }) }
    };
    let target = options.target;
    let above = target.is_finite() && target > 0.0;
    parameter("the target", in_rpm(target), above, "a speed above zero, such as \"3400 rpm\"")?;
    let points = options.points;
    parameter("the number of points", points.to_string(), (2..=1000).contains(&points), "a number from 2 to 1000")?;
    let reserve = options.least_reserve;
    let share = (0.0..1.0).contains(&reserve);
    parameter("the least slip reserve", reserve.to_string(), share, "a share from 0 to below 1, such as 0.3 or 30%")
}

/// The speeds between which the drive is looked at for a target, rad/s.
///
/// # Errors
/// [`TuneError::Parameter`] for a target at which the engine is not known.
fn speeds(engine: &Engine, target: f64) -> Result<(f64, f64), TuneError> {
    let (least, most) = engine.range();
    // An engine whose flyweights are too light for its full torque runs into the governor, and settles where that
    // leaves as much torque as they hold.
    let last = engine.governor.map_or(most, |Governor { governed, no_load }| no_load - LEFT * (no_load - governed));
    if !(least < target && target < last) {
        let left = match engine.governor {
            Some(_) => format!(", at which its governor leaves {:.0} % of the torque", 100.0 * LEFT),
            None => String::new(),
        };
        let (least, last) = (in_rpm(least), in_rpm(last));
        let expected = format!("a speed above {least}, from which the engine is known, and below {last}{left}");
        return Err(TuneError::Parameter { what: "the target", given: in_rpm(target), expected });
    }
    Ok(((SPEEDS.0 * target).max(least), (SPEEDS.1 * target).min(last)))
}

/// What a shift is worth.
fn merits(shift: &[ShiftPoint], target: f64) -> Merits {
    let count = shift.len() as f64;
    let mean = |of: &dyn Fn(&ShiftPoint) -> f64| shift.iter().map(of).sum::<f64>() / count;
    Merits {
        rms_deviation: mean(&|point| (point.primary_speed - target).powi(2)).sqrt(),
        mean_speed: mean(&|point| point.primary_speed),
        smallest_slip_reserve: shift.iter().map(|point| point.slip_reserve).fold(f64::INFINITY, f64::min),
        mean_efficiency: mean(&|point| point.efficiency),
    }
}

/// Marks the tunes, the better first, that no other beats in all three merits.
fn mark_pareto(tunes: &mut [Tune]) {
    // Those before are no worse in deviation: one is beaten if one of them is no worse in the other two, and differs.
    let mut front: Vec<(f64, f64, f64)> = Vec::new();
    for tune in tunes {
        let Merits { rms_deviation, smallest_slip_reserve, mean_efficiency, .. } = tune.merits;
        let here = (smallest_slip_reserve, mean_efficiency, rms_deviation);
        let beaten = front.iter().any(|other| other.0 >= here.0 && other.1 >= here.1 && *other != here);
        tune.pareto = !beaten;
        if !beaten {
            front.retain(|(reserve, efficiency, _)| *reserve > here.0 || *efficiency > here.1);
            front.push(here);
        }
    }
}

/// A speed in rad/s as people read it.
fn in_rpm(speed: f64) -> String {
    format!("{} rpm", (10.0 * rpm(speed)).round() / 10.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tune((rms_deviation, smallest_slip_reserve, mean_efficiency): (f64, f64, f64)) -> Tune {
        Tune {
            candidate: 0,
            parts: BTreeMap::new(),
            merits: Merits { rms_deviation, mean_speed: 0.0, smallest_slip_reserve, mean_efficiency },
            points: 0,
            last_ratio: 0.6,
            pareto: false,
            confirmed: None,
            shift: Vec::new(),
        }
    }

    #[test]
    fn the_pareto_front_is_what_nothing_beats() {
        let mut tunes = [
            (1.0, 0.2, 0.90),
            (2.0, 0.1, 0.95),
            (3.0, 0.15, 0.93),
            (4.0, 0.1, 0.94),
            (5.0, 0.3, 0.80),
            (6.0, 0.2, 0.8),
        ]
        .map(tune);
        mark_pareto(&mut tunes);
        assert_eq!(tunes.map(|tune| tune.pareto), [true, true, true, false, true, false]);
    }

    /// Of combinations that do the same, none beats another, and what beats one of them beats all; of two with one
    /// deviation, the one that is better elsewhere beats the other, whichever was found first.
    #[test]
    fn equals_do_not_beat_one_another() {
        let mut tunes = [
            (2.0, 0.2, 0.9),
            (1.0, 0.1, 0.9),
            (2.0, 0.2, 0.9),
            (1.0, 0.2, 0.8),
            (3.0, 0.2, 0.9),
            (1.0, 0.1, 0.85),
            (3.0, 0.2, 0.9),
        ]
        .map(tune);
        tunes.sort_by(|a, b| a.merits.better_first(&b.merits));
        mark_pareto(&mut tunes);
        let marked = tunes.map(|tune| (tune.merits.rms_deviation, tune.merits.mean_efficiency, tune.pareto));
        let front = [(1.0, 0.8, true), (1.0, 0.9, true), (1.0, 0.85, false), (2.0, 0.9, true), (2.0, 0.9, true)];
        assert_eq!(marked[..5], front);
        assert_eq!(marked[5..], [(3.0, 0.9, false); 2]);
    }
}
