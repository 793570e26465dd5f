//! A drive as a combination of parts makes it, and where its sheaves come to their stops.

use super::unfit::ShiftPoint;
use crate::actuator::travel_by_radius;
use crate::case::geometry::{radii_of_ratio, radius_beside};
use crate::case::{Actuation, Resolved};
use crate::powertrain::Engine;

/// A drive as a combination of parts makes it.
pub(super) struct Drive<'a> {
    pub case: &'a Resolved,
    pub actuation: &'a Actuation,
    pub engine: &'a Engine,
}

impl Drive<'_> {
    /// How far a sheave is beyond its stop at high ratio: the one that is beyond it, or nearer to it; m.
    pub fn beyond(&self, point: &ShiftPoint) -> f64 {
        let Actuation { primary_travel, secondary_travel, .. } = self.actuation;
        let by = |travel: f64, most: Option<f64>| most.map(|most| travel - most);
        let all = [by(point.travels.0, *primary_travel), by(point.travels.1, *secondary_travel)];
        all.into_iter().flatten().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The ratio at which a sheave comes to its stop at high ratio if the belt stays as deep in its grooves as at a
    /// point; zero if it does at none.
    pub fn stop_ratio(&self, from: &ShiftPoint) -> f64 {
        let radii = radii_of_ratio(from.ratio, self.case.belt.length, self.case.drive.center_distance).ok();
        radii.and_then(|radii| stop_ratio(self.case, self.actuation, radii, from.travels)).unwrap_or(0.0)
    }
}

/// The nominal ratio at which the belt runs at a radius of the secondary.
pub(super) fn by_secondary(case: &Resolved, secondary: f64) -> Option<f64> {
    Some(secondary / radius_beside(secondary, case.belt.length, case.drive.center_distance).ok()?)
}

/// The nominal ratio at which the first sheave comes to its stop at high ratio, from nominal radii at which the primary
/// has closed and the secondary has opened so far, as if the belt stayed as deep in its grooves; none if none does.
pub(super) fn stop_ratio(
    case: &Resolved,
    actuation: &Actuation,
    (primary, secondary): (f64, f64),
    (closed, opened): (f64, f64),
) -> Option<f64> {
    let slope = travel_by_radius(case.sheave.half_angle);
    let of_primary = actuation.primary_travel.and_then(|travel| {
        let primary = primary + (travel - closed) / slope;
        Some(radius_beside(primary, case.belt.length, case.drive.center_distance).ok()? / primary)
    });
    let of_secondary =
        actuation.secondary_travel.and_then(|travel| by_secondary(case, secondary - (travel - opened) / slope));
    of_primary.into_iter().chain(of_secondary).reduce(f64::max)
}
