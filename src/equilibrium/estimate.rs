//! Where an equilibrium is sought first: forces of actuators against those of a belt of rough proportions.

use std::f64::consts::PI;

use super::phase::{Direction, Phase, Stop};
use crate::actuator::{PrimaryActuator, travel, travel_by_radius};
use crate::case::geometry::{radii_of_ratio, radius_beside, wrap_angles};
use crate::case::{Actuation, Resolved};
use crate::powertrain::Engine;

/// Axial force over that of a frictionless wedge at the mean tension, Φ T/(2 tan β), on the primary and the secondary:
/// what equilibria of a Baja car's drive have between ratios of 1 and 2 (0.53 to 0.69, 0.37 to 0.45).
const SHARES: (f64, f64) = (0.62, 0.42);
/// Shares of the engine's last speed at which an equilibrium is sought where the rough one leads nowhere.
const SPEEDS: [f64; 3] = [0.8, 0.65, 0.92];
/// Torque of a start, at least, over the engine's largest: a belt that is hardly loaded is another problem.
const LEAST_TORQUE: f64 = 0.3;
/// Slack tension of a start over M_in/R_P: at least this, for a looser belt may slip.
const LEAST_TENSION: f64 = 0.35;
/// Over the slack tension that the actuators leave, that of a start at the high stop: a looser belt may be led to a
/// state in which it is pushed.
const TIGHTER: f64 = 2.0;
/// Overall efficiency.
const EFFICIENCY: f64 = 0.95;
/// Bisections of the range of radii.
const HALVINGS: usize = 40;

/// A rough equilibrium.
#[derive(Debug, Clone, Copy)]
pub(super) struct Estimate {
    pub phase: Phase,
    pub primary_radius: f64,
    pub secondary_radius: f64,
    pub speed: f64,
    pub torque: f64,
    pub slack_tension: f64,
}

/// The drive of which a rough equilibrium is sought.
struct Rough<'a> {
    case: &'a Resolved,
    actuation: &'a Actuation,
    engine: &'a Engine,
    secondary_speed: f64,
    direction: Direction,
}

/// A rough equilibrium at a speed of the secondary.
pub(super) fn estimate(
    case: &Resolved,
    actuation: &Actuation,
    engine: &Engine,
    secondary_speed: f64,
    direction: Direction,
) -> Estimate {
    let rough = Rough { case, actuation, engine, secondary_speed, direction };
    let slope = travel_by_radius(case.sheave.half_angle);
    let low = rough.primary_beside(actuation.closed_radius).unwrap_or(actuation.start_radius);
    let held = match actuation.primary {
        PrimaryActuator::Position(travel) => Some(actuation.start_radius + travel / slope),
        PrimaryActuator::Flyweights { .. } | PrimaryActuator::Force(_) => None,
    };
    if let Some(radius) = held {
        return rough.at(radius, Phase::Held);
    }
    let (high, stop) = rough.high(low, slope);
    if rough.excess(low) <= 0.0 {
        return rough.at(low, Phase::Low);
    }
    if let Some(stop) = stop.filter(|_| rough.excess(high) >= 0.0) {
        return rough.at(high, Phase::High(stop));
    }
    let (mut below, mut above) = (low, high);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        if rough.excess(middle) > 0.0 { below = middle } else { above = middle }
    }
    rough.at(0.5 * (below + above), Phase::Shift)
}

/// R_S/R_P where the sheaves stand at the high stop, and that stop; without one, as far as the belt lets them.
pub(super) fn highest_ratio(
    case: &Resolved,
    actuation: &Actuation,
    engine: &Engine,
    secondary_speed: f64,
    direction: Direction,
) -> (f64, Option<Stop>) {
    let rough = Rough { case, actuation, engine, secondary_speed, direction };
    let low = rough.primary_beside(actuation.closed_radius).unwrap_or(actuation.start_radius);
    let (primary, stop) = rough.high(low, travel_by_radius(case.sheave.half_angle));
    (rough.secondary_beside(primary) / primary, stop)
}

/// Other places at which an equilibrium may be sought: between the stops where the engine would turn at usual speeds,
/// and at the high stop.
pub(super) fn elsewhere(
    case: &Resolved,
    actuation: &Actuation,
    engine: &Engine,
    secondary_speed: f64,
    direction: Direction,
) -> Vec<Estimate> {
    let rough = Rough { case, actuation, engine, secondary_speed, direction };
    let slope = travel_by_radius(case.sheave.half_angle);
    let low = rough.primary_beside(actuation.closed_radius).unwrap_or(actuation.start_radius);
    let (high, stop) = rough.high(low, slope);
    let at = |share: &f64| {
        let ratio = share * engine.range().1 / secondary_speed;
        let radii = radii_of_ratio(ratio, case.belt.length, case.drive.center_distance).ok();
        let primary = radii.map_or(if ratio > 1.0 { low } else { high }, |(primary, _)| primary);
        rough.at(primary.clamp(low, high.max(low)), Phase::Shift)
    };
    let at_stop = stop.map(|stop| {
        let near = rough.at(high, Phase::High(stop));
        Estimate { slack_tension: TIGHTER * near.slack_tension, ..near }
    });
    SPEEDS.iter().map(at).chain(at_stop).collect()
}

impl Rough<'_> {
    fn primary_beside(&self, secondary: f64) -> Option<f64> {
        radius_beside(secondary, self.case.belt.length, self.case.drive.center_distance).ok()
    }

    /// The largest radius on the primary, and the stop there; without one, as far as the belt closes.
    fn high(&self, low: f64, slope: f64) -> (f64, Option<Stop>) {
        let closed = self.actuation.primary_travel.map(|travel| self.actuation.start_radius + travel / slope);
        let open = self
            .actuation
            .secondary_travel
            .and_then(|travel| self.primary_beside(self.actuation.closed_radius - travel / slope));
        match (closed, open) {
            (Some(closed), Some(open)) if open < closed => (open, Some(Stop::SecondaryOpen)),
            (Some(closed), _) => (closed, Some(Stop::PrimaryClosed)),
            (None, Some(open)) => (open, Some(Stop::SecondaryOpen)),
            // A ratio of 1/4 is beyond every drive.
            (None, None) => {
                (low.max(0.8 * (self.case.belt.length / (2.0 * PI)).min(self.case.drive.center_distance)), None)
            }
        }
    }

    fn secondary_beside(&self, primary: f64) -> f64 {
        let (length, center) = (self.case.belt.length, self.case.drive.center_distance);
        radius_beside(primary, length, center).unwrap_or(self.actuation.closed_radius)
    }

    /// Speed, torque, and the forces that press on primary and secondary at a radius on the primary.
    fn forces(&self, primary: f64) -> (f64, f64, f64, f64) {
        let secondary = self.secondary_beside(primary);
        let (half_angle, ratio) = (self.case.sheave.half_angle, secondary / primary);
        let speed = self.secondary_speed * ratio;
        let torque = self.engine.torque(speed).value;
        let at = travel(half_angle, self.actuation.start_radius, primary);
        let press = self.actuation.primary.force(speed, at, self.direction.primary());
        let opening = travel(half_angle, secondary, self.actuation.closed_radius);
        let squeeze = self.actuation.secondary.force(EFFICIENCY * torque * ratio, opening, self.direction.secondary());
        let press = press.ok().flatten().map_or(f64::NAN, |force| force.value);
        (speed, torque, press, squeeze.map_or(f64::NAN, |force| force.value))
    }

    /// Axial force over mean tension on both pulleys.
    fn per_tension(&self, primary: f64) -> (f64, f64) {
        let center = self.case.drive.center_distance;
        let (on_primary, on_secondary) = wrap_angles(primary, self.secondary_beside(primary), center);
        let wedge = 2.0 * libm::tan(self.case.sheave.half_angle);
        (SHARES.0 * on_primary / wedge, SHARES.1 * on_secondary / wedge)
    }

    /// How much more tension the primary would make than the secondary: positive where the drive would shift up.
    fn excess(&self, primary: f64) -> f64 {
        let (_, _, press, squeeze) = self.forces(primary);
        let (on_primary, on_secondary) = self.per_tension(primary);
        press / on_primary - squeeze / on_secondary
    }

    fn at(&self, primary: f64, phase: Phase) -> Estimate {
        let (speed, torque, press, squeeze) = self.forces(primary);
        let largest = self.engine.torque.values().iter().fold(0.0, |largest: f64, torque| largest.max(*torque));
        let torque = torque.max(LEAST_TORQUE * self.engine.throttle * largest);
        let (on_primary, on_secondary) = self.per_tension(primary);
        // At a stop the other pulley's actuator decides.
        let mean = match phase {
            Phase::Low | Phase::High(Stop::SecondaryOpen | Stop::SecondaryClosed) => press / on_primary,
            Phase::Shift | Phase::Held | Phase::High(Stop::PrimaryClosed) => squeeze / on_secondary,
        };
        let least = LEAST_TENSION * torque.abs() / primary;
        let tension = (mean - 0.5 * torque.abs() / primary).max(least);
        Estimate {
            phase,
            primary_radius: primary,
            secondary_radius: self.secondary_beside(primary),
            speed,
            torque,
            slack_tension: if tension.is_finite() && tension > 0.0 { tension } else { 100.0 },
        }
    }
}
