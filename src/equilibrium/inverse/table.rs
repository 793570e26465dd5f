//! Made profiles as a table, as figures and in words.

use std::fmt::Write;

use serde_json::Number;

use super::{Inverse, InversePoint, Made, Outline, Shape};
use crate::actuator::AngleFrom;
use crate::plot::{Axis, Figure, Look, Series};
use crate::quantity::{Unit, rpm};
use crate::study::{Cell, Table};

fn number(value: f64) -> Cell {
    Number::from_f64(value).map_or(Cell::Empty, Cell::Number)
}

/// A column of the belt along the shift: its header, and what stands in it.
type Column = (&'static str, fn(&InversePoint) -> f64);

/// Columns of the belt along the shift.
const BELT: [Column; 10] = [
    ("primary_travel", |point| point.primary_travel),
    ("secondary_travel", |point| point.secondary_travel),
    ("ratio", |point| point.ratio),
    ("secondary_speed", |point| point.secondary_speed),
    ("secondary_torque", |point| point.secondary_torque),
    ("primary_axial_force", |point| point.primary_axial_force),
    ("secondary_axial_force", |point| point.secondary_axial_force),
    ("slack_tension", |point| point.slack_tension),
    ("slip_reserve", |point| point.slip_reserve),
    // Not a number, which becomes an empty cell, where neither end drives the other.
    ("efficiency", |point| point.efficiency.unwrap_or(f64::NAN)),
];

/// The belt along the shift, and behind it the profiles at the same travels of the primary, one row a travel; SI, helix
/// angles from the plane of rotation. Where a profile has a place before the belt's first point, the row of that has no
/// more of the belt than the travel.
pub fn inverse_table(made: &Inverse) -> Table {
    let mut columns: Vec<String> = BELT.map(|(header, _)| header.to_owned()).into();
    let row = |point| BELT.map(|(_, value)| number(value(point))).into();
    let mut rows: Vec<Vec<Cell>> = made.points.iter().map(row).collect();
    let profiles: Vec<_> = made.parts.iter().map(|part| (part, part.along())).collect();
    let first = made.points.first().map_or(f64::NEG_INFINITY, |point| point.primary_travel);
    let longest = profiles.iter().map(|(_, along)| along.as_slice()).max_by_key(|along| along.len());
    let before = longest.unwrap_or_default().iter().map(|(travel, ..)| *travel).take_while(|travel| *travel < first);
    let before: Vec<Vec<Cell>> = before
        .map(|travel| std::iter::once(number(travel)).chain(BELT.iter().skip(1).map(|_| Cell::Empty)).collect())
        .collect();
    rows.splice(0..0, before);
    for (part, along) in &profiles {
        let names = match &part.shape {
            Shape::Coefficient(_) => ["travel", "coefficient"],
            Shape::Ramp(_) => ["travel", "radius"],
            Shape::Roller(_) => ["ramp_place", "ramp_radius"],
            Shape::Cam(_) => ["pitch_distance", "pitch_angle"],
            Shape::Helix(..) => ["helix_opening", "helix_angle"],
        };
        columns.extend(names.map(str::to_owned));
        let without = rows.len().saturating_sub(along.len());
        let cells = along.iter().map(|(_, place, value)| [*place, *value].map(number));
        let cells = std::iter::repeat_n([Cell::Empty, Cell::Empty], without).chain(cells);
        rows.iter_mut().zip(cells).for_each(|(row, cells)| row.extend(cells));
    }
    Table { columns, rows }
}

/// The panels of a figure: each profile, the forces along the shift, and the drive solved forward.
pub fn inverse_figures(made: &Inverse, outlines: &[Outline]) -> Vec<Figure> {
    // What stands on the same axes, as a ramp and the path of its roller, in one panel.
    let mut figures: Vec<Figure> = Vec::new();
    for outline in outlines {
        let figure = outline_figure(outline);
        match figures.iter_mut().find(|other| other.x == figure.x) {
            Some(other) => {
                other.y = Axis::new("radius from the shaft (mm)");
                other.series.extend(figure.series);
            }
            None => figures.push(figure),
        }
    }
    let mm = |value: f64| 1e3 * value;
    for part in &made.parts {
        let (name, caption, y, scale, profile) = match &part.shape {
            Shape::Coefficient(profile) => {
                ("coefficient", "Coefficient of the flyweights over the travel", "r dr/ds (mm)", 1e3, profile)
            }
            Shape::Helix(profile, _) => (
                "helix_angle",
                "Helix angle over the opening",
                "angle from the plane of rotation (°)",
                Unit::DEGREE.per_si(),
                profile,
            ),
            Shape::Ramp(_) | Shape::Roller(_) | Shape::Cam(_) => continue,
        };
        let points = profile.places().iter().zip(profile.values()).map(|(x, y)| (mm(*x), scale * y)).collect();
        let x = if name == "helix_angle" { "opening of the secondary (mm)" } else { "travel of the primary (mm)" };
        figures.push(Figure::new(name, caption, Axis::new(x), Axis::new(y), vec![Series::line("", points)]));
    }
    let along = |name: &str, of: &dyn Fn(&InversePoint) -> f64| {
        Series::line(name, made.points.iter().map(|point| (mm(point.primary_travel), of(point))).collect())
    };
    let travel = || Axis::new("travel of the primary (mm)");
    figures.push(Figure::new(
        "forces",
        "Axial forces of the belt along the shift",
        travel(),
        Axis::new("axial force (N)"),
        vec![
            along("primary", &|point| point.primary_axial_force),
            along("secondary", &|point| point.secondary_axial_force),
        ],
    ));
    let checked = made.check.points.iter().map(|point| (point.ratio, rpm(point.primary_speed - made.options.target)));
    let ratios = made.points.iter().map(|point| point.ratio);
    let (low, high) = ratios.fold((f64::INFINITY, 0.0_f64), |(low, high), ratio| (low.min(ratio), high.max(ratio)));
    figures.push(Figure::new(
        "check",
        "The drive solved forward with the profile: engine speed less the target",
        Axis::new("ratio R_{S}/R_{P}"),
        Axis::new("deviation (rpm)"),
        vec![
            Series::line("", vec![(low, 0.0), (high, 0.0)]).look(Look::Guide),
            Series::line("", checked.collect()).look(Look::Dots).color(0),
        ],
    ));
    figures
}

fn outline_figure(outline: &Outline) -> Figure {
    let points = outline.points.iter().map(|(x, y)| (1e3 * x, 1e3 * y)).collect();
    let [x, y] = outline.axes.map(|axis| Axis::new(format!("{axis} (mm)")));
    let name = words(outline.name);
    let caption = format!("The {name} to scale");
    let mut figure = Figure::new(outline.name.to_lowercase(), caption, x, y, vec![Series::line(name, points)]);
    figure.equal = true;
    figure
}

/// A layer's name in words.
fn words(layer: &str) -> String {
    match layer {
        "RAMP" => "ramp".into(),
        "ROLLER_CENTRE" => "path of the roller's centre".into(),
        "PITCH_CURVE" => "cam's pitch curve".into(),
        "HELIX_UNROLLED" => "helix, unrolled".into(),
        other => other.to_lowercase(),
    }
}

/// What a person reads at a glance.
pub fn inverse_summary(made: &Inverse, angle_from: AngleFrom) -> String {
    let what = match made.options.made {
        Made::Ramp => "The flyweights' profile",
        Made::Helix => "The helix",
        Made::Both => "Helix and flyweights' profile",
    };
    let mut text = format!("{what} for {:.0} rpm at {:.2} N·m\n\n", rpm(made.options.target), made.torque);
    let mut line = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:<28}{value}");
    };
    if let (Some(low), Some(high)) = (made.points.first(), made.points.last()) {
        line("ratio", format!("{:.3} to {:.3}", low.ratio, high.ratio));
        line(
            "travel",
            format!(
                "primary {:.2} to {:.2} mm, secondary 0 to {:.2} mm",
                1e3 * low.primary_travel,
                1e3 * high.primary_travel,
                1e3 * high.secondary_travel
            ),
        );
        let forces = |of: &dyn Fn(&InversePoint) -> f64| {
            let range = made
                .points
                .iter()
                .map(of)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), force| (low.min(force), high.max(force)));
            format!("{:.0} to {:.0} N", range.0, range.1)
        };
        line("belt on the primary", forces(&|point| point.primary_axial_force));
        line("belt on the secondary", forces(&|point| point.secondary_axial_force));
    }
    line("smallest slip reserve", format!("{:.1} % of the friction at hand", 100.0 * made.smallest_reserve()));
    for part in &made.parts {
        let (name, scale, unit) = match &part.shape {
            Shape::Coefficient(_) => ("r dr/ds", 1e3, "mm"),
            Shape::Ramp(_) => ("radius of the flyweights", 1e3, "mm"),
            Shape::Roller(_) => ("radius of the roller", 1e3, "mm"),
            Shape::Cam(_) => ("angle of the cam", Unit::DEGREE.per_si(), "°"),
            Shape::Helix(..) => ("helix angle", Unit::DEGREE.per_si(), "°"),
        };
        // What stands before the belt's first point is below the low ratio.
        let along = part.along();
        let mut shifting = along.iter().skip(along.len().saturating_sub(made.points.len()));
        let Some((_, _, first)) = shifting.next() else { continue };
        let last = shifting.last().map_or(first, |(_, _, last)| last);
        let shown = |value: f64| match part.shape {
            Shape::Helix(..) => scale * angle_from.from_rotation(value),
            _ => scale * value,
        };
        let from = match part.shape {
            Shape::Helix(..) => format!(", {}", super::drawing::from_words(angle_from)),
            _ => String::new(),
        };
        line(
            name,
            format!("{:.2} {unit} at low ratio to {:.2} {unit} at high ratio{from}", shown(*first), shown(*last)),
        );
    }
    line(
        "solved forward",
        format!(
            "within {:.2} rpm of the target at {} places between the profile's points, {:.2} rpm rms",
            rpm(made.check.largest_deviation),
            made.check.points.len(),
            rpm(made.check.rms_deviation)
        ),
    );
    text
}
