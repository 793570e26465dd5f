//! The figures of one solution.

use super::figure::{Axis, Figure, Look, Mark, Series};
use super::trajectory::{Rim, Trajectory};
use crate::drive::RegionId;
use crate::model::{Constant, Constants, Field, InternalError, State};
use crate::result::{Outcome, Sampled};
use std::f64::consts::TAU;

/// Points inside each mesh interval, besides its nodes.
const INNER: usize = 2;
/// Largest distance of points, as a share of the region.
const GAP: f64 = 1.0 / 300.0;
const WRAP: &str = "wrap angle φ (deg)";

/// A solution with its regions sampled.
struct View<'a> {
    outcome: &'a Outcome,
    constants: Constants,
    trajectory: Trajectory<'a>,
    /// In the order of [`RegionId`].
    regions: [Sampled; 4],
}

/// All figures of a solution: the belt's path, what happens along both contacts, both spans.
///
/// # Errors
/// None, unless this program is broken.
pub fn drive(outcome: &Outcome) -> Result<Vec<Figure>, InternalError> {
    let solved = &outcome.solved;
    let sample = |region: RegionId| {
        let mesh = solved.solution.regions().get(region.index()).map_or(&[][..], |part| part.mesh());
        Sampled::at(&solved.belt, &solved.solution, region, dense(mesh))
    };
    let constants = Constants::try_from(solved.solution.constants())?;
    let trajectory = Trajectory::new(solved)?;
    let view = View { outcome, constants, trajectory, regions: RegionId::ALL.map(sample) };
    let threshold = view.constant(Constant::SlipThreshold);
    let mut sliding = view.over_wrap(
        "sliding_speed",
        "Sliding speed over wrap angle; below the threshold the belt adheres",
        Axis::log("sliding speed |v| (m/s)"),
        |view, region| view.field(region, Field::SlidingSpeed),
    )?;
    let widest = view.wrap(RegionId::Primary).max(view.wrap(RegionId::Secondary)).to_degrees();
    sliding
        .series
        .push(Series::line("threshold v_{thr}", vec![(0.0, threshold), (widest, threshold)]).look(Look::Guide));
    let degrees = |values: Vec<f64>| values.into_iter().map(f64::to_degrees).collect::<Vec<_>>();
    let times = |values: Vec<f64>, factor: f64| values.into_iter().map(|value| value * factor).collect::<Vec<_>>();
    let mut figures = vec![
        view.trajectory_figure()?,
        view.over_wrap(
            "tension",
            "Tractive tension over wrap angle",
            Axis::new("tractive tension T (N)"),
            |view, region| view.state(region, State::Tension),
        )?,
        sliding,
        view.over_wrap(
            "sliding_angle",
            "Direction of sliding over wrap angle: 0° outward, 180° inward",
            Axis::new("sliding angle γ (deg)").over(-15.0, 375.0).every(90.0),
            move |view, region| Ok(unjumped(degrees(view.field(region, Field::SlidingAngle)?))),
        )?,
        view.over_wrap(
            "penetration",
            "Radial penetration over wrap angle",
            Axis::new("penetration x (mm)"),
            move |view, region| Ok(times(view.state(region, State::Penetration)?, 1e3)),
        )?,
        view.over_wrap(
            "inclination",
            "Inclination over wrap angle: negative seats, positive unseats",
            Axis::new("inclination θ (deg)"),
            move |view, region| Ok(degrees(view.state(region, State::Inclination)?)),
        )?,
        view.over_wrap(
            "axial_force",
            "Axial force on a sheave per length over wrap angle",
            Axis::new("axial force dA/ds (N/mm)"),
            move |view, region| Ok(times(view.field(region, Field::AxialForcePerLength)?, 1e-3)),
        )?,
        view.over_wrap(
            "friction_loss",
            "Power lost to friction per length over wrap angle",
            Axis::new("friction loss dW/ds (W/mm)"),
            move |view, region| Ok(times(view.field(region, Field::LossPerLength)?, 1e-3)),
        )?,
        view.span_shape()?,
    ];
    figures.extend(view.span_tension()?);
    Ok(figures)
}

/// An arrow around a pulley's centre in the sense in which it turns, counter-clockwise; mm.
fn rotation(Rim { radius, center, .. }: Rim) -> Vec<(f64, f64)> {
    const FROM: f64 = 30.0;
    const TO: f64 = 150.0;
    /// Radius of the arc and length of the head's strokes, over the pulley's radius.
    const ARC: f64 = 0.3;
    const HEAD: f64 = 0.11;
    let at = |degrees: f64, radius: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        (1e3 * (center + radius * cos), 1e3 * radius * sin)
    };
    let mut points: Vec<_> =
        (0..=30).map(|part| at(FROM + (TO - FROM) * f64::from(part) / 30.0, ARC * radius)).collect();
    let tip = at(TO, ARC * radius);
    // Strokes back along the arc, to either side of it.
    for side in [-55.0, -125.0_f64] {
        let (sin, cos) = libm::sincos((TO + side).to_radians());
        points.extend([(tip.0 + 1e3 * HEAD * radius * cos, tip.1 + 1e3 * HEAD * radius * sin), tip]);
    }
    points
}

/// The nodes, and between any two of them as many points as a smooth line needs.
fn dense(mesh: &[f64]) -> Vec<f64> {
    let between = |pair: &[f64]| {
        let (a, h) = (pair[0], pair[1] - pair[0]);
        let parts = ((h / GAP).ceil() as usize).max(INNER + 1);
        (0..parts).map(move |part| a + h * part as f64 / parts as f64).collect::<Vec<_>>()
    };
    mesh.windows(2).flat_map(between).chain(mesh.last().copied()).collect()
}

/// Angles without the jumps from 360° to 0° and back: they go on beyond.
fn unjumped(mut angles: Vec<f64>) -> Vec<f64> {
    let mut turns = 0.0;
    let mut before = angles.first().copied().unwrap_or(0.0);
    for angle in &mut angles {
        let jump = *angle - before;
        before = *angle;
        turns -= 360.0 * (jump / 360.0).round();
        *angle += turns;
    }
    angles
}

impl View<'_> {
    fn constant(&self, constant: Constant) -> f64 {
        self.constants[constant]
    }

    fn wrap(&self, region: RegionId) -> f64 {
        self.constant(if region == RegionId::Primary { Constant::PrimaryWrap } else { Constant::SecondaryWrap })
    }

    fn sampled(&self, region: RegionId) -> &Sampled {
        &self.regions[region.index()]
    }

    fn s(&self, region: RegionId) -> &[f64] {
        &self.sampled(region).s
    }

    fn state(&self, region: RegionId, state: State) -> Result<Vec<f64>, InternalError> {
        self.sampled(region).state(state).map(<[f64]>::to_vec)
    }

    fn field(&self, region: RegionId, field: Field) -> Result<Vec<f64>, InternalError> {
        self.sampled(region).field(field).map(<[f64]>::to_vec)
    }

    /// One quantity on both pulleys.
    fn over_wrap(
        &self,
        name: &str,
        caption: &str,
        y: Axis,
        values: impl Fn(&Self, RegionId) -> Result<Vec<f64>, InternalError>,
    ) -> Result<Figure, InternalError> {
        let series = [(RegionId::Primary, "primary"), (RegionId::Secondary, "secondary")].map(|(region, label)| {
            let wrap = self.wrap(region).to_degrees();
            let points = self.s(region).iter().map(|s| s * wrap).zip(values(self, region)?).collect();
            Ok(Series::line(label, points))
        });
        let series = series.into_iter().collect::<Result<Vec<_>, InternalError>>()?;
        let widest = self.wrap(RegionId::Primary).max(self.wrap(RegionId::Secondary)).to_degrees();
        Ok(Figure::new(name, caption, Axis::new(WRAP).over(0.0, widest).every(30.0), y, series))
    }

    /// The belt's path in a region, mm.
    fn path(&self, region: RegionId) -> Result<Vec<(f64, f64)>, InternalError> {
        let path = self.trajectory.path(region, self.s(region))?;
        Ok(path.points.into_iter().map(|(x, y)| (1e3 * x, 1e3 * y)).collect())
    }

    fn trajectory_figure(&self) -> Result<Figure, InternalError> {
        let circle = |Rim { radius, center, .. }| {
            let at = |part: usize| (TAU * part as f64 / 180.0).sin_cos();
            let points = (0..=180).map(at).map(|(sin, cos)| (1e3 * (center + radius * cos), 1e3 * radius * sin));
            Series::line("", points.collect()).look(Look::Guide)
        };
        let line = |label: &str, points, color| Series::line(label, points).color(color);
        let (primary, secondary) = (self.trajectory.primary(), self.trajectory.secondary());
        let result = &self.outcome.result;
        let center = self.constant(Constant::CenterDistance);
        let force = [
            (1e3 * result.primary.resultant_x, 1e3 * result.primary.resultant_y),
            (1e3 * (center + result.secondary.resultant_x), 1e3 * result.secondary.resultant_y),
        ];
        let mut nominal = circle(primary);
        nominal.label = "nominal radius".into();
        let series = vec![
            nominal,
            circle(secondary),
            line("", rotation(primary), 6),
            line("", rotation(secondary), 6),
            line("contact", self.path(RegionId::Primary)?, 0),
            line("", self.path(RegionId::Secondary)?, 0),
            line("tight span", self.path(RegionId::TightSpan)?, 1),
            line("slack span", self.path(RegionId::SlackSpan)?, 2),
            Series::line("resultant axial force", force.to_vec()).look(Look::Dots).color(3),
            Series::line("", vec![(0.0, 0.0), (1e3 * center, 0.0)]).look(Look::Dots).color(6),
        ];
        let caption =
            "The belt's path, where it touches the pulleys, which way they turn, and where the axial forces act";
        let mut figure = Figure::new("trajectory", caption, Axis::new("x (mm)"), Axis::new("y (mm)"), series);
        figure.equal = true;
        let under = |text: &str, x: f64| Mark { at: (x, -12.0), text: text.into() };
        figure.marks = vec![under("primary", 0.0), under("secondary", 1e3 * center)];
        Ok(figure)
    }

    /// How far each span lies outside the straight line between its ends.
    fn span_shape(&self) -> Result<Figure, InternalError> {
        let series = [(RegionId::TightSpan, "tight span", 1), (RegionId::SlackSpan, "slack span", 2)].map(
            |(region, label, color)| {
                let points = self.path(region)?;
                let (Some(first), Some(last)) = (points.first().copied(), points.last().copied()) else {
                    return Ok(Series::line(label, Vec::new()));
                };
                let (dx, dy) = (last.0 - first.0, last.1 - first.1);
                let chord = dx.hypot(dy);
                let over = |(x, y): (f64, f64)| {
                    let (x, y) = (x - first.0, y - first.1);
                    // The belt runs counter-clockwise: outside is on its right.
                    ((x * dx + y * dy) / chord, (y * dx - x * dy) / -chord)
                };
                Ok(Series::line(label, points.into_iter().map(over).collect()).color(color))
            },
        );
        Ok(Figure::new(
            "span_shape",
            "How far the spans bulge outward from the straight line between their ends",
            Axis::new("distance along the straight line (mm)"),
            Axis::new("bulge (mm)"),
            series.into_iter().collect::<Result<_, InternalError>>()?,
        ))
    }

    /// Along each span on its own: what bending does to the tension is little beside their difference.
    fn span_tension(&self) -> Result<Vec<Figure>, InternalError> {
        let spans = [
            (RegionId::TightSpan, "tight", Constant::TightLength, 1),
            (RegionId::SlackSpan, "slack", Constant::SlackLength, 2),
        ];
        let figure = |(region, which, length, color)| {
            let length = 1e3 * self.constant(length);
            let points =
                self.s(region).iter().map(|s| s * length).zip(self.state(region, State::SpanTension)?).collect();
            let series = Series::line(format!("{which} span"), points).color(color);
            let (x, y) = (Axis::new("arc length along the belt (mm)"), Axis::new("tractive tension T (N)"));
            let caption = format!("Tractive tension along the {which} span");
            Ok(Figure::new(format!("{which}_span_tension"), caption, x, y, vec![series]))
        };
        spans.into_iter().map(figure).collect()
    }
}
