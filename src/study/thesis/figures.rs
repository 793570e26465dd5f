//! The figures of chapters 6 and 7.

use super::{Chapters, Family};
use crate::case::{Key, Kind};
use crate::plot::{self, Axis, Figure, Series};
use crate::result::Outcome;
use crate::study::Table;

const RATIO: &str = "ratio R_S/R_P";

/// All of them, named by what they show: those of the base case, of the operating range, of each family.
pub fn figures(chapters: &Chapters) -> Vec<Figure> {
    let mut figures = plot::drive(&chapters.base);
    for figure in &mut figures {
        figure.name = format!("base_{}", figure.name);
    }
    figures.extend(range(&chapters.range));
    figures.extend(ends(chapters));
    figures.extend(chapters.families.iter().flat_map(family));
    figures
}

fn points(table: &Table, rows: std::ops::Range<usize>, x: &str, y: &str, scale: f64) -> Vec<(f64, f64)> {
    rows.map(|row| (table.number(row, x), scale * table.number(row, y))).collect()
}

fn over_ratio(name: &str, caption: &str, y: Axis, series: Vec<Series>) -> Figure {
    Figure::new(name, caption, Axis::new(RATIO).over(0.7, 1.76), y, series)
}

fn range(table: &Table) -> Vec<Figure> {
    let line = |label: &str, column: &str, scale: f64| {
        Series::line(label, points(table, 0..table.rows.len(), "drive.ratio", column, scale))
    };
    vec![
        over_ratio(
            "range_axial_force",
            "Axial forces over the operating range",
            Axis::new("axial force A (N)"),
            vec![line("primary", "primary.axial_force", 1.0), line("secondary", "secondary.axial_force", 1.0)],
        ),
        over_ratio(
            "range_efficiency",
            "Efficiencies over the operating range",
            Axis::new("efficiency η (%)"),
            vec![
                line("speed", "efficiency.speed", 100.0),
                line("torque", "efficiency.torque", 100.0),
                line("overall", "efficiency.overall", 100.0),
            ],
        ),
        over_ratio(
            "range_loss",
            "Friction loss by pulley over the operating range",
            Axis::new("friction loss W (W)"),
            vec![
                line("primary", "primary.friction_loss", 1.0),
                line("secondary", "secondary.friction_loss", 1.0),
                line("both", "energy.friction_loss", 1.0),
            ],
        ),
    ]
}

/// Both ends of the range side by side: the fields of the base belt, the penetration of all belts.
fn ends(chapters: &Chapters) -> Vec<Figure> {
    let mut figures = Vec::new();
    let fields = ["tension", "sliding_speed", "axial_force"];
    if let Some([Some(low), Some(high)]) = chapters.ends.get(1) {
        let cases: [(&Outcome, &str); 2] = [(low, "low range, 1.74"), (high, "high range, 0.72")];
        for field in fields {
            for (pulley, name) in [(0, "primary"), (1, "secondary")] {
                figures.extend(beside(field, pulley, &format!("range_{field}_{name}"), &cases));
            }
        }
    }
    for (end, name) in [(0, "low range"), (1, "high range")] {
        let labels = ["EI = 0.025 N·m²", "EI = 0.2602 N·m²", "EI = 0.5 N·m²"];
        let cases: Vec<(&Outcome, &str)> = chapters
            .ends
            .iter()
            .zip(labels)
            .filter_map(|(ends, label)| Some((ends.get(end)?.as_ref()?, label)))
            .collect();
        for (pulley, which) in [(0, "primary"), (1, "secondary")] {
            let file = format!("bending_stiffness_penetration_{which}_{}", name.replace(' ', "_"));
            figures.extend(beside("penetration", pulley, &file, &cases).map(|mut figure| {
                figure.caption = format!("Penetration on the {which} in {name}, by bending stiffness");
                figure
            }));
        }
    }
    figures
}

/// One field of one pulley, of several solutions.
fn beside(field: &str, pulley: usize, name: &str, cases: &[(&Outcome, &str)]) -> Option<Figure> {
    let mut together: Option<Figure> = None;
    for (outcome, label) in cases {
        let figure = plot::drive(outcome).into_iter().find(|figure| figure.name == field)?;
        let mut series = figure.series.get(pulley)?.clone();
        series.label = (*label).to_owned();
        let frame = together.get_or_insert_with(|| {
            let which = if pulley == 0 { "primary" } else { "secondary" };
            let guides = figure.series.get(2..).unwrap_or_default().to_vec();
            let caption = format!("{}, {which}", figure.caption);
            let mut frame = Figure::new(name, caption, Axis::new(figure.x.label.clone()), figure.y.clone(), guides);
            frame.x.range = figure.x.range;
            frame
        });
        frame.x.range = match (frame.x.range, figure.x.range) {
            (Some((low, a)), Some((_, b))) => Some((low, a.max(b))),
            (range, _) => range,
        };
        let at = frame.series.iter().filter(|series| series.color.is_some()).count();
        frame.series.insert(at, series.color(at));
    }
    together
}

/// Efficiencies over the ratio, curve by curve; for the slack tension, axial forces over it as well.
fn family(family: &Family) -> Vec<Figure> {
    let curve = |value: f64| {
        let entry = family.key.entry();
        let (number, unit) = match entry.kind {
            Kind::Quantity { unit, .. } => (unit.from_si(value), unit.symbol.replace('*', "·").replace("^2", "²")),
            Kind::Choice { .. } => (value, String::new()),
        };
        format!("{} = {} {unit}", entry.symbol, (number * 1e6).round() / 1e6).trim_end().to_owned()
    };
    let mut figures: Vec<Figure> = ["overall", "speed", "torque"]
        .map(|which| {
            let column = format!("efficiency.{which}");
            let line = |(value, rows): (f64, std::ops::Range<usize>)| {
                Series::line(curve(value), points(&family.table, rows, "drive.ratio", &column, 100.0))
            };
            let series = family.curves().into_iter().map(line).collect();
            let mut start = which.to_owned();
            start.get_mut(..1).map(str::make_ascii_uppercase).unwrap_or_default();
            over_ratio(
                &format!("{}_{which}_efficiency", family.name),
                &format!("{start} efficiency over the operating range, by {}", family.title),
                Axis::new(format!("{which} efficiency η (%)")),
                series,
            )
        })
        .into();
    if family.key == Key::SlackTension {
        figures.extend(["primary", "secondary"].map(|pulley| forces(family, pulley)));
    }
    figures
}

fn forces(family: &Family, pulley: &str) -> Figure {
    let curves = family.curves();
    let width = curves.first().map_or(0, |(_, rows)| rows.len());
    let column = format!("{pulley}.axial_force");
    let line = |at: usize| {
        let points: Vec<(f64, f64)> =
            curves.iter().map(|(value, rows)| (*value, family.table.number(rows.start + at, &column))).collect();
        let ratio = curves.first().map_or(f64::NAN, |(_, rows)| family.table.number(rows.start + at, "drive.ratio"));
        Series::line(format!("ratio {ratio:.2}"), points)
    };
    let series = [0, width / 2, width.saturating_sub(1)].map(line).into();
    Figure::new(
        format!("slack_tension_axial_force_{pulley}"),
        format!("Axial force of the {pulley} over slack tension"),
        Axis::new("slack tension T_slack (N)"),
        Axis::new("axial force A (N)"),
        series,
    )
}
