//! The shift of a drive on a map of its belt: where flyweights, springs and helix balance the belt.

use super::drive::{Drive, by_secondary, stop_ratio};
use super::error::TuneError;
use super::full::InFull;
use super::unfit::{ShiftPoint, Unfit};
use crate::actuator::{Shift, travel, travel_by_radius};
use crate::beltmap::{BeltMap, MapPoint, Outside, Quantity};
use crate::case::{Actuation, Key, Resolved};
use crate::powertrain::Engine;

/// Newton steps at a point of the shift, and how often one of them is halved to stay on the map.
const STEPS: usize = 30;
const HALVINGS: usize = 12;
/// Forces balance to this share of the belt's.
const BALANCED: f64 = 1e-8;
/// Largest step of the speed in a Newton step, as a share of it.
const STRIDE: f64 = 0.25;
/// Bisections of the speed, steps of regula falsi for the slack tension at each, and the share of the force to which
/// the secondary balances there: Newton's method goes on from there.
const BISECTIONS: usize = 12;
const SECANTS: usize = 20;
const NEARLY: f64 = 1e-4;

/// How closely the stop is met at which a shift ends, m, and steps towards it at most.
const MET: f64 = 1e-6;
const STOP_STEPS: usize = 30;

/// What a search needs of the map: places of its axes. Where the map has no values, full solutions take its place.
#[derive(Debug)]
pub struct Screen<'a> {
    map: &'a BeltMap,
    ratio: usize,
    torque: usize,
    speed: usize,
    tension: usize,
    full: InFull,
}

/// How much work a search was.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Readings of the map.
    pub readings: usize,
    /// Points that were sought by full solutions, because the map has no values there.
    pub in_full: usize,
}

/// The nominal ratios at the ends of the shift, low first: where the secondary is closed, and where the first of the
/// other stops is met.
///
/// # Errors
/// [`TuneError::Missing`] without a stop at high ratio.
pub fn ends(case: &Resolved, actuation: &Actuation) -> Result<(f64, f64), TuneError> {
    let missing = TuneError::Missing {
        what: "stop at high ratio",
        needs: "give primary.travel, or secondary.travel, so that the end of the shift is known",
    };
    let low = by_secondary(case, actuation.closed_radius);
    let from = (actuation.start_radius, actuation.closed_radius);
    match (low, stop_ratio(case, actuation, from, (0.0, 0.0))) {
        (Some(low), Some(high)) if high < low => Ok((low, high)),
        _ => Err(missing),
    }
}

/// `count` nominal ratios from low to high, evenly spaced in the speed of the vehicle at one speed of the engine.
pub fn ratios((low, high): (f64, f64), count: usize) -> Vec<f64> {
    let last = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|i| 1.0 / (1.0 / low + (1.0 / high - 1.0 / low) * i as f64 / last)).collect()
}

impl<'a> Screen<'a> {
    /// For a map over ratio, torque and speed of the primary, and slack tension.
    ///
    /// # Errors
    /// [`TuneError::Axis`].
    pub fn new(map: &'a BeltMap) -> Result<Self, TuneError> {
        let expected = "ratio, torque, speed and slack_tension";
        let axis = |key: Key| map.axis(key).ok_or(TuneError::Axis { key, expected });
        let [ratio, torque] = [axis(Key::Ratio)?, axis(Key::PrimaryTorque)?];
        let [speed, tension] = [axis(Key::PrimarySpeed)?, axis(Key::SlackTension)?];
        let range = |axis: usize| map.axes()[axis].range();
        let full = InFull::new(range(speed), range(tension), map.report());
        let screen = Self { map, ratio, torque, speed, tension, full };
        match map
            .axes()
            .iter()
            .find(|axis| ![Key::Ratio, Key::PrimaryTorque, Key::PrimarySpeed, Key::SlackTension].contains(&axis.key()))
        {
            Some(axis) => {
                Err(TuneError::Axis { key: axis.key(), expected: "ratio, torque, speed and slack_tension alone" })
            }
            None => Ok(screen),
        }
    }

    /// Follows the shift through some nominal ratios, upshift, the engine at its throttle; counts the work. Where a
    /// sheave comes to its stop at high ratio before the last of them, because the belt sinks into its grooves, the
    /// last point is there: beyond, the stop carries what the belt does not, and the parts no longer decide the
    /// engine's speed.
    ///
    /// # Errors
    /// See [`Unfit`].
    pub fn shift(
        &self,
        case: &Resolved,
        actuation: &Actuation,
        engine: &Engine,
        (ratios, target): (&[f64], f64),
        work: &mut Work,
    ) -> Result<Vec<ShiftPoint>, Unfit> {
        let drive = Drive { case, actuation, engine };
        let mut points: Vec<ShiftPoint> = Vec::with_capacity(ratios.len());
        for &ratio in ratios {
            let found = self.point(&drive, ratio, points.last(), target, work);
            match found {
                Ok(point) if drive.beyond(&point) <= MET => points.push(point),
                Ok(_) if points.is_empty() => return Err(Unfit::Closed { ratio }),
                beyond => {
                    let last = points.last().copied();
                    points.extend(self.full_shift(&drive, last, (ratio, beyond), target, work)?);
                    break;
                }
            }
        }
        Ok(points)
    }

    /// The point at which a sheave comes to its stop, between the last point before it and a ratio at which there is
    /// one beyond it, or at which the combination is refused: nothing is asked of parts beyond the stop. None if the
    /// last point is at the stop itself. Each ratio is that at which the nominal radii have moved by what is left of
    /// the travel: how deep the belt sinks changes slowly.
    fn full_shift(
        &self,
        drive: &Drive<'_>,
        last: Option<ShiftPoint>,
        (ratio, found): (f64, Result<ShiftPoint, Unfit>),
        target: f64,
        work: &mut Work,
    ) -> Result<Option<ShiftPoint>, Unfit> {
        let Some(last) = last else { return found.map(Some) };
        if drive.beyond(&last) >= -MET {
            return Ok(None);
        }
        let mut here = last;
        for _ in 0..STOP_STEPS {
            let there = drive.stop_ratio(&here);
            if let (Err(unfit), true) = (&found, there <= ratio) {
                return Err(unfit.clone());
            }
            here = self.point(drive, there.max(ratio).min(last.ratio), Some(&here), target, work)?;
            if drive.beyond(&here).abs() <= MET {
                return Ok(Some(here));
            }
        }
        Err(Unfit::Lost { ratio })
    }

    fn at(&self, drive: &Drive<'_>, ratio: f64, (speed, tension): (f64, f64)) -> Result<MapPoint<'a>, Outside> {
        let mut at = [0.0; 4];
        at[self.ratio] = ratio;
        at[self.torque] = drive.engine.torque(speed).value;
        at[self.speed] = speed;
        at[self.tension] = tension;
        self.map.at(&at)
    }

    /// The point at which both pulleys balance: on the map, and where that does not tell it, by full solutions.
    fn point(
        &self,
        drive: &Drive<'_>,
        ratio: f64,
        near: Option<&ShiftPoint>,
        target: f64,
        work: &mut Work,
    ) -> Result<ShiftPoint, Unfit> {
        let near = near.map(|point| (point.primary_speed, point.slack_tension));
        match self.balance(drive, ratio, near, target, &mut work.readings) {
            Err(Unfit::Untold { .. } | Unfit::Lost { .. }) => {
                work.in_full += 1;
                self.full.point(drive, ratio)
            }
            told => told,
        }
    }

    /// The speed and the slack tension at which both pulleys balance: by Newton's method from a point nearby, and where
    /// that leaves the map, by bisection.
    fn balance(
        &self,
        drive: &Drive<'_>,
        ratio: f64,
        near: Option<(f64, f64)>,
        target: f64,
        readings: &mut usize,
    ) -> Result<ShiftPoint, Unfit> {
        if let Some(start) = self.start(drive, ratio, near, target, readings)
            && let Some(found) = self.newton(drive, ratio, start, readings)?
        {
            return Ok(found);
        }
        let start = self.bracket(drive, ratio, readings)?;
        *readings += 1;
        let point = self.at(drive, ratio, start).map_err(|_| Unfit::Lost { ratio })?;
        self.newton(drive, ratio, (start, point), readings)?.ok_or(Unfit::Lost { ratio })
    }

    /// Newton's method; nothing where it leaves the map, which says where it went and not where the balance is.
    fn newton(
        &self,
        drive: &Drive<'_>,
        ratio: f64,
        (mut here, mut point): ((f64, f64), MapPoint<'a>),
        readings: &mut usize,
    ) -> Result<Option<ShiftPoint>, Unfit> {
        for _ in 0..STEPS {
            let balance = drive.balance(self, ratio, here, &point)?;
            if balance.missed <= BALANCED {
                return Ok(Some(read(&point, ratio, here, balance.travels)));
            }
            let Some((mut speed, mut tension)) = balance.step() else { return Ok(None) };
            let stride = (STRIDE * here.0 / speed.abs()).min(0.5 * here.1 / tension.abs()).min(1.0);
            (speed, tension) = (stride * speed, stride * tension);
            let mut moved = None;
            for _ in 0..HALVINGS {
                let there = (here.0 + speed, here.1 + tension);
                *readings += 1;
                moved = self.at(drive, ratio, there).ok().map(|point| (there, point));
                if moved.is_some() {
                    break;
                }
                (speed, tension) = (0.5 * speed, 0.5 * tension);
            }
            let Some(next) = moved else { return Ok(None) };
            (here, point) = next;
        }
        Ok(None)
    }

    /// A point of the map to begin with: the one before, or one at the target's speed.
    fn start(
        &self,
        drive: &Drive<'_>,
        ratio: f64,
        near: Option<(f64, f64)>,
        target: f64,
        readings: &mut usize,
    ) -> Option<((f64, f64), MapPoint<'a>)> {
        let tensions = self.map.axes()[self.tension].breakpoints();
        let tight = tensions.iter().rev().map(|tension| (target, *tension));
        let middle = tensions.get(tensions.len() / 2).map(|tension| (target, *tension));
        near.into_iter().chain(middle).chain(tight).find_map(|there| {
            *readings += 1;
            Some((there, self.at(drive, ratio, there).ok()?))
        })
    }

    /// A speed and a slack tension near the balance, by bisection over the speed: at each the slack tension is the one
    /// at which the secondary balances, and the sign of what is left over on the primary says on which side it lies. At
    /// speeds at which the map has no belt that the secondary holds, the balance lies higher, or the map does not tell
    /// it.
    fn bracket(&self, drive: &Drive<'_>, ratio: f64, readings: &mut usize) -> Result<(f64, f64), Unfit> {
        let (from, to) = self.map.axes()[self.speed].range();
        let above = self.on_secondary(drive, ratio, to, readings)?;
        if above.rest < 0.0 {
            let (presses, needs) = (above.presses, above.presses - above.rest);
            return Err(Unfit::TooLight { ratio, speed: to, presses, needs });
        }
        let (mut low, mut high, mut best) = (from, to, (to, above.tension));
        let mut below = match self.on_secondary(drive, ratio, from, readings) {
            Ok(found) if found.rest > 0.0 => {
                let (presses, needs) = (found.presses, found.presses - found.rest);
                return Err(Unfit::TooHeavy { ratio, speed: from, presses, needs });
            }
            other => other.err(),
        };
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            match self.on_secondary(drive, ratio, middle, readings) {
                Ok(found) if found.rest >= 0.0 => (high, best) = (middle, (middle, found.tension)),
                other => (low, below) = (middle, other.err()),
            }
        }
        // Where the map does not tell the lower end, there is no balance between: it may lie where nothing is told.
        below.map_or(Ok(best), Err)
    }

    /// The slack tension at which the secondary balances at a speed, and what is left over on the primary.
    fn on_secondary(
        &self,
        drive: &Drive<'_>,
        ratio: f64,
        speed: f64,
        readings: &mut usize,
    ) -> Result<OnSecondary, Unfit> {
        let tensions = self.map.axes()[self.tension].breakpoints();
        let mut at = |tension: f64| -> Result<Option<Balance>, Unfit> {
            *readings += 1;
            match self.at(drive, ratio, (speed, tension)) {
                Ok(point) => drive.balance(self, ratio, (speed, tension), &point).map(Some),
                Err(Outside::Range { key, value, .. }) => Err(Unfit::Beyond { ratio, key, value }),
                Err(_) => Ok(None),
            }
        };
        let largest = tensions.last().copied().unwrap_or(f64::NAN);
        let mut loosest = None;
        for tension in tensions {
            if let Some(balance) = at(*tension)? {
                loosest = Some((*tension, balance));
                break;
            }
        }
        let (mut low, loose) = loosest.ok_or(Unfit::Untold { ratio, speed, tension: largest })?;
        if loose.rest[1] < 0.0 {
            // The loosest belt that a cell of the map tells is not the loosest that holds: looser ones lie in the cell
            // below, which has no values because one of its corners slips.
            return Err(match tensions.first() == Some(&low) {
                true => Unfit::Loose { ratio, speed, tension: low },
                false => Unfit::Untold { ratio, speed, tension: largest },
            });
        }
        let tight = Unfit::Tight { ratio, tension: largest };
        let mut here = at(largest)?.ok_or(tight.clone())?;
        if here.rest[1] > 0.0 {
            return Err(tight);
        }
        let (mut high, mut left, mut right) = (largest, loose.rest[1], here.rest[1]);
        let mut tension = high;
        // Regula falsi; an end that stays counts half (the Illinois rule).
        for _ in 0..SECANTS {
            tension = low + (high - low) * left / (left - right);
            here = at(tension)?.ok_or(Unfit::Lost { ratio })?;
            let rest = here.rest[1];
            if rest.abs() <= NEARLY * here.presses[1].abs() {
                break;
            }
            if rest > 0.0 {
                (low, left, right) = (tension, rest, 0.5 * right);
            } else {
                (high, right, left) = (tension, rest, 0.5 * left);
            }
        }
        Ok(OnSecondary { tension, presses: here.presses[0], rest: here.rest[0] })
    }
}

/// Where the secondary balances.
struct OnSecondary {
    /// Slack tension, N.
    tension: f64,
    /// What presses on the primary, N.
    presses: f64,
    /// That less the belt's axial force, N.
    rest: f64,
}

/// What is left over on both pulleys, N, and its derivatives.
struct Balance {
    /// What the actuators press with, N.
    presses: [f64; 2],
    rest: [f64; 2],
    /// By pulley: with respect to speed and slack tension.
    slopes: [[f64; 2]; 2],
    missed: f64,
    /// How far the primary has closed and the secondary has opened, m.
    travels: (f64, f64),
}

impl Balance {
    fn step(&self) -> Option<(f64, f64)> {
        let [[a, b], [c, d]] = self.slopes;
        let determinant = a * d - b * c;
        let [p, q] = self.rest;
        let step = ((b * q - d * p) / determinant, (c * p - a * q) / determinant);
        (step.0.is_finite() && step.1.is_finite()).then_some(step)
    }
}

impl Drive<'_> {
    fn balance(
        &self,
        screen: &Screen<'_>,
        ratio: f64,
        (speed, _): (f64, f64),
        point: &MapPoint<'_>,
    ) -> Result<Balance, Unfit> {
        let told = |error| Unfit::Actuator { ratio, error };
        let lost = |_: Outside| Unfit::Lost { ratio };
        let half_angle = self.case.sheave.half_angle;
        let by_radius = travel_by_radius(half_angle);
        let torque_slope = self.engine.torque(speed).by_speed;
        // The map's derivatives along speed, on which the torque hangs, and slack tension.
        let along = |quantity: Quantity| -> Result<(f64, [f64; 2]), Unfit> {
            let slopes = point.slopes(quantity).map_err(lost)?;
            let by_speed = slopes[screen.speed] + slopes[screen.torque] * torque_slope;
            Ok((point.value(quantity).map_err(lost)?, [by_speed, slopes[screen.tension]]))
        };
        let (primary_belt, primary_slopes) = along(Quantity::PrimaryAxialForce)?;
        let (secondary_belt, secondary_slopes) = along(Quantity::SecondaryAxialForce)?;
        let (primary_radius, primary_moves) = along(Quantity::PrimaryRadius)?;
        let (secondary_radius, secondary_moves) = along(Quantity::SecondaryRadius)?;
        let (torque, torque_slopes) = along(Quantity::SecondaryTorque)?;
        let closed = travel(half_angle, self.actuation.start_radius, primary_radius);
        let opened = travel(half_angle, secondary_radius, self.actuation.closed_radius);
        let primary = self.actuation.primary.force(speed, closed, Shift::Closing).map_err(told)?;
        let primary = primary.ok_or(Unfit::Lost { ratio })?;
        let secondary = self.actuation.secondary.force(torque, opened, Shift::Opening).map_err(told)?;
        let rest = [primary.value - primary_belt, secondary.value - secondary_belt];
        let on_primary = |k: usize| {
            let own = if k == 0 { primary.by_drive } else { 0.0 };
            own + primary.by_travel * by_radius * primary_moves[k] - primary_slopes[k]
        };
        let on_secondary = |k: usize| {
            secondary.by_drive * torque_slopes[k]
                - secondary.by_travel * by_radius * secondary_moves[k]
                - secondary_slopes[k]
        };
        let missed = (rest[0] / primary_belt).abs().max((rest[1] / secondary_belt).abs());
        Ok(Balance {
            presses: [primary.value, secondary.value],
            rest,
            slopes: [[0, 1].map(on_primary), [0, 1].map(on_secondary)],
            missed,
            travels: (closed, opened),
        })
    }
}

fn read(
    point: &MapPoint<'_>,
    ratio: f64,
    (primary_speed, slack_tension): (f64, f64),
    travels: (f64, f64),
) -> ShiftPoint {
    let efficiency = point.efficiency_with_losses().or_else(|_| point.efficiency());
    ShiftPoint {
        ratio,
        primary_speed,
        secondary_speed: point.secondary_speed().unwrap_or(f64::NAN),
        slack_tension,
        slip_reserve: point.slip_reserve().unwrap_or(f64::NAN),
        efficiency: efficiency.unwrap_or(f64::NAN),
        travels,
    }
}
