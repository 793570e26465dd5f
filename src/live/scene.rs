//! What is drawn of a solution: the drive in its plane, and what happens along the belt.

use serde::Serialize;

use crate::drive::RegionId;
use crate::model::{Field, InternalError, State};
use crate::plot::{Path, Rim, Trajectory};
use crate::result::{Outcome, Sampled};

/// How closely a contact is sampled.
#[derive(Debug, Clone, Copy)]
pub(super) enum Detail {
    /// As the eye sees a line that rests.
    Resting,
    /// As it sees one that moves.
    Moving,
}

impl Detail {
    /// Largest distance of samples, as a share of the contact.
    fn gap(self) -> f64 {
        match self {
            Self::Resting => 1.0 / 160.0,
            Self::Moving => 1.0 / 100.0,
        }
    }
}

/// Smallest distance of samples in a contact, as a share of it.
const NEAREST: f64 = 1.0 / 500.0;
/// Samples of a span, about.
const SPAN_SAMPLES: usize = 120;

/// Everything that is drawn, SI. Samples are of single precision: they are looked at.
#[derive(Debug, Serialize)]
pub(super) struct Scene {
    center_distance: f64,
    slip_threshold: f64,
    primary: Pulley,
    secondary: Pulley,
    slack_span: Span,
    tight_span: Span,
}

/// A pulley, and the belt on it.
#[derive(Debug, Serialize)]
struct Pulley {
    radius: f64,
    center: f64,
    entry: f64,
    wrap: f64,
    speed: f64,
    /// Wrap angle from the entry, rad.
    angle: Vec<f32>,
    x: Vec<f32>,
    y: Vec<f32>,
    tension: Vec<f32>,
    sliding_speed: Vec<f32>,
    sliding_angle: Vec<f32>,
    penetration: Vec<f32>,
    inclination: Vec<f32>,
    axial_force: Vec<f32>,
    friction_loss: Vec<f32>,
}

/// The belt between the pulleys.
#[derive(Debug, Serialize)]
struct Span {
    /// Arc length from where the belt leaves the pulley before, m.
    arc: Vec<f32>,
    x: Vec<f32>,
    y: Vec<f32>,
    tension: Vec<f32>,
}

fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|value| *value as f32).collect()
}

/// What is to be drawn of a solution.
///
/// # Errors
/// None, unless this program is broken.
pub(super) fn scene(outcome: &Outcome, detail: Detail) -> Result<Scene, InternalError> {
    let trajectory = Trajectory::new(&outcome.solved)?;
    let (primary, secondary) = (&outcome.result.primary, &outcome.result.secondary);
    let contact = |region, rim, speed| pulley(outcome, &trajectory, (region, detail), rim, speed);
    Ok(Scene {
        center_distance: outcome.result.inputs.drive.center_distance,
        slip_threshold: outcome.result.inputs.sheave.slip_threshold,
        primary: contact(RegionId::Primary, trajectory.primary(), primary.speed)?,
        secondary: contact(RegionId::Secondary, trajectory.secondary(), secondary.speed)?,
        slack_span: span(outcome, &trajectory, RegionId::SlackSpan, outcome.result.slack_span.arc_length)?,
        tight_span: span(outcome, &trajectory, RegionId::TightSpan, outcome.result.tight_span.arc_length)?,
    })
}

/// The nodes of a region that are not too close to others, and as many places between them as a smooth line needs.
fn places(outcome: &Outcome, region: RegionId, detail: Detail) -> Vec<f64> {
    let mesh = outcome.solved.solution.regions().get(region.index()).map_or(&[][..], |part| part.mesh());
    let mut places = vec![0.0];
    let mut last = 0.0;
    for &node in mesh.iter().filter(|node| **node <= 1.0 - NEAREST).chain(&[1.0]) {
        let gap = node - last;
        if gap < NEAREST {
            continue;
        }
        let parts = (gap / detail.gap()).ceil();
        places.extend((1..=parts as usize).map(|part| last + gap * part as f64 / parts));
        last = node;
    }
    places
}

/// Some of the points of a path, its ends with them.
fn thinned(path: Path) -> Path {
    let last = path.s.len().saturating_sub(1);
    let stride = path.s.len().div_ceil(SPAN_SAMPLES).max(1);
    let kept = |index: &usize| index.is_multiple_of(stride) || *index == last;
    let pick = |values: &[f64]| (0..values.len()).filter(kept).map(|index| values[index]).collect();
    let points = (0..path.points.len()).filter(kept).map(|index| path.points[index]).collect();
    Path { s: pick(&path.s), points }
}

fn pulley(
    outcome: &Outcome,
    trajectory: &Trajectory<'_>,
    (region, detail): (RegionId, Detail),
    rim: Rim,
    speed: f64,
) -> Result<Pulley, InternalError> {
    let solved = &outcome.solved;
    let sampled = Sampled::at(&solved.belt, &solved.solution, region, places(outcome, region, detail));
    let path = trajectory.path(region, &sampled.s)?;
    let state = |state| sampled.state(state).map(single);
    let field = |field| sampled.field(field).map(single);
    Ok(Pulley {
        radius: rim.radius,
        center: rim.center,
        entry: rim.entry,
        wrap: rim.wrap,
        speed,
        angle: sampled.s.iter().map(|s| (s * rim.wrap) as f32).collect(),
        x: path.points.iter().map(|(x, _)| *x as f32).collect(),
        y: path.points.iter().map(|(_, y)| *y as f32).collect(),
        tension: state(State::Tension)?,
        sliding_speed: field(Field::SlidingSpeed)?,
        sliding_angle: field(Field::SlidingAngle)?,
        penetration: state(State::Penetration)?,
        inclination: state(State::Inclination)?,
        axial_force: field(Field::AxialForcePerLength)?,
        friction_loss: field(Field::LossPerLength)?,
    })
}

fn span(outcome: &Outcome, trajectory: &Trajectory<'_>, region: RegionId, length: f64) -> Result<Span, InternalError> {
    let path = thinned(trajectory.path(region, &[])?);
    let solved = &outcome.solved;
    let sampled = Sampled::at(&solved.belt, &solved.solution, region, path.s);
    Ok(Span {
        arc: sampled.s.iter().map(|s| (s * length) as f32).collect(),
        x: path.points.iter().map(|(x, _)| *x as f32).collect(),
        y: path.points.iter().map(|(_, y)| *y as f32).collect(),
        tension: sampled.state(State::SpanTension).map(single)?,
    })
}
