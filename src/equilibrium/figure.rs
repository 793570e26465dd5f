//! The figure of a shift curve: engine speed over road speed, and below it efficiency, slip, forces, temperature.

use super::curve::{ShiftBranch, ShiftPoint};
use super::phase::Direction;
use super::report::DriveReport;
use super::table::Measured;
use crate::plot::{Axis, Figure, Look, Mark, Series};
use crate::powertrain::Vehicle;
use crate::quantity::{Unit, celsius, km_per_h, rpm};

/// Ratios whose lines may be drawn.
const RATIOS: [f64; 9] = [0.6, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0];
/// Least distance of a ratio's name from the curve, in widths and heights of the figure.
const CLEAR: f64 = 0.05;

/// A shift curve that is drawn.
#[derive(Debug, Clone)]
pub struct ShiftCurve<'a> {
    /// Its name in the legend, where there are several.
    pub name: &'a str,
    /// Its branches.
    pub branches: &'a [ShiftBranch],
}

/// The panels of a figure of shift curves, the topmost first: the first curve in full, others beside it.
pub fn shift_figures(curves: &[ShiftCurve<'_>], vehicle: Option<&Vehicle>, measured: &[Measured]) -> Vec<Figure> {
    let view = View { curves, vehicle };
    let engine = |report: &DriveReport| rpm(report.primary_speed);
    let mut top = view.panel(
        "shift",
        "Engine speed over road speed along the shift curve",
        Axis::new("engine speed (rpm)"),
        &[("", &|report| Some(engine(report)))],
    );
    let highest = top.series.iter().flat_map(|series| &series.points).map(|point| point.1).filter(|y| y.is_finite());
    let highest = highest.fold(0.0, f64::max);
    view.ratio_lines(&mut top, highest);
    if !measured.is_empty() {
        let points = measured.iter().map(|point| (view.x(point.secondary_speed), rpm(point.primary_speed)));
        // Beneath the curves.
        top.series.insert(0, Series::line("measured", points.collect()).look(Look::Dots).color(6));
    }
    let percent = |share: f64| 100.0 * share;
    let mut figures = vec![
        top,
        view.panel(
            "shift_efficiency",
            "Overall efficiency along the shift curve",
            Axis::new("efficiency (%)"),
            &[("", &|report| report.efficiency.map(percent))],
        ),
        view.panel(
            "shift_slip",
            "Friction at hand that is left along the shift curve",
            Axis::new("slip reserve (%)"),
            &[("", &|report| Some(percent(report.slip_reserve)))],
        ),
        view.panel(
            "shift_forces",
            "Axial forces of the belt along the shift curve",
            Axis::new("axial force (N)"),
            &[
                ("primary", &|report| Some(report.primary_axial_force)),
                ("secondary", &|report| Some(report.secondary_axial_force)),
            ],
        ),
    ];
    let warm = |report: &DriveReport| report.belt_temperature.map(celsius);
    let temperature = view.panel(
        "shift_temperature",
        "Temperature of the belt along the shift curve",
        Axis::new("belt (°C)"),
        &[("", &warm)],
    );
    if temperature.series.iter().any(|series| series.points.iter().any(|point| point.1.is_finite())) {
        figures.push(temperature);
    }
    let span = view.span(measured);
    for figure in &mut figures {
        figure.x.range = Some(span);
    }
    figures
}

/// What is drawn of a point.
type Quantity<'a> = &'a dyn Fn(&DriveReport) -> Option<f64>;

struct View<'a> {
    curves: &'a [ShiftCurve<'a>],
    vehicle: Option<&'a Vehicle>,
}

impl View<'_> {
    fn x(&self, secondary: f64) -> f64 {
        self.vehicle.map_or(rpm(secondary), |vehicle| km_per_h(vehicle.load(secondary).speed))
    }

    fn axis(&self) -> Axis {
        Axis::new(if self.vehicle.is_some() { "speed of the vehicle (km/h)" } else { "speed of the secondary (rpm)" })
    }

    /// From a round speed below the first point to one above the last.
    fn span(&self, measured: &[Measured]) -> (f64, f64) {
        let points = self.curves.iter().flat_map(|curve| curve.branches).flat_map(|branch| &branch.points);
        let speeds =
            points.map(|point| point.secondary_speed).chain(measured.iter().map(|point| point.secondary_speed));
        (0.0, speeds.map(|speed| self.x(speed)).fold(0.0, f64::max) * 1.02)
    }

    fn panel(&self, name: &str, caption: &str, y: Axis, quantities: &[(&str, Quantity<'_>)]) -> Figure {
        let mut series = Vec::new();
        let mut color = 0;
        for curve in self.curves {
            for (what, quantity) in quantities {
                for branch in curve.branches {
                    series.push(self.line(curve, branch, what, *quantity).color(color));
                }
                color += 1;
            }
        }
        Figure::new(name, caption, self.axis(), y, series)
    }

    fn line(&self, curve: &ShiftCurve<'_>, branch: &ShiftBranch, what: &str, quantity: Quantity<'_>) -> Series {
        let value = |point: &ShiftPoint| {
            let value = point.report.as_ref().ok().and_then(|report| quantity(report));
            (self.x(point.secondary_speed), value.unwrap_or(f64::NAN))
        };
        let direction = match branch.direction {
            Direction::Up => "up",
            Direction::Back => "back",
            Direction::Frictionless => "",
        };
        let named = if self.curves.len() > 1 { curve.name } else { "" };
        let label: Vec<&str> = [named, what, direction].into_iter().filter(|part| !part.is_empty()).collect();
        let look = if branch.direction == Direction::Back { Look::Dashed } else { Look::Line };
        Series::line(label.join(", "), branch.points.iter().map(value).collect()).look(look)
    }

    /// Lines of equal ratio with their names, and the speed of engagement.
    fn ratio_lines(&self, figure: &mut Figure, highest: f64) {
        let (_, last) = self.span(&[]);
        let per_rpm = self.x(Unit::RPM.in_si());
        let top = 1.06 * highest;
        figure.y.range = Some((0.0, top));
        let curve: Vec<(f64, f64)> = figure.series.iter().flat_map(|series| series.points.clone()).collect();
        // How far a place is from the curve, in widths and heights of the figure.
        let clear = |place: (f64, f64)| {
            let far = curve.iter().map(|point| libm::hypot((point.0 - place.0) / last, (point.1 - place.1) / top));
            far.fold(f64::INFINITY, f64::min)
        };
        for (number, ratio) in RATIOS.into_iter().enumerate() {
            let (x, y) = (last, last / per_rpm * ratio);
            let end = if y > top { (top * per_rpm / ratio, top) } else { (x, y) };
            let label = if number == 0 { "ratio R_{S}/R_{P}" } else { "" };
            figure.series.push(Series::line(label, vec![(0.0, 0.0), end]).look(Look::Guide));
            let places = [0.93, 0.84, 0.75, 0.66].map(|share| (share * end.0, share * end.1));
            let at = places.into_iter().find(|place| clear(*place) > CLEAR).unwrap_or(places[0]);
            figure.marks.push(Mark { at, text: format!("{ratio}") });
        }
        let engagement = self.curves.first().and_then(|curve| curve.branches.first()?.engagement);
        if let Some(speed) = engagement {
            let y = rpm(speed);
            let end = 0.16 * last;
            figure.series.push(Series::line("engagement", vec![(0.0, y), (end, y)]).look(Look::Dashed).color(3));
        }
    }
}
