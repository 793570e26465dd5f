//! The figures of chapters 6 and 7.

use super::{Chapters, Ends, Family};
use crate::case::Key;
use crate::model::{InternalError, Output};
use crate::plot::{self, Axis, Figure, Look, Series};
use crate::result::Outcome;
use crate::study::Table;

pub(super) const RATIO: &str = "ratio R_{S}/R_{P}";

/// All of them, named by what they show: those of the base case, of the operating range, of each family.
///
/// # Errors
/// None, unless this program is broken.
pub fn figures(chapters: &Chapters) -> Result<Vec<Figure>, InternalError> {
    let mut figures = plot::drive(&chapters.base)?;
    for figure in &mut figures {
        figure.name = format!("base_{}", figure.name);
    }
    figures.extend(radii(&chapters.ends)?);
    figures.extend(range(&chapters.range));
    figures.extend(ends(chapters)?);
    figures.extend(chapters.families.iter().flat_map(family));
    Ok(figures)
}

/// An output over the ratio, in some rows.
pub(super) fn points(table: &Table, rows: std::ops::Range<usize>, output: Output, scale: f64) -> Vec<(f64, f64)> {
    rows.map(|row| (table.number(row, Key::Ratio.path()), scale * table.output(row, output))).collect()
}

pub(super) fn over_ratio(name: &str, caption: &str, y: Axis, series: Vec<Series>) -> Figure {
    Figure::new(name, caption, Axis::new(RATIO).over(0.7, 1.76), y, series)
}

fn range(table: &Table) -> Vec<Figure> {
    let line = |label: &str, output: Output, scale: f64| {
        Series::line(label, points(table, 0..table.rows.len(), output, scale)).marked()
    };
    vec![
        over_ratio(
            "range_axial_force",
            "Axial forces over the operating range",
            Axis::new("axial force A (N)"),
            vec![line("primary", Output::PrimaryAxialForce, 1.0), line("secondary", Output::SecondaryAxialForce, 1.0)],
        ),
        over_ratio(
            "range_efficiency",
            "Efficiencies over the operating range",
            Axis::new("efficiency η (%)"),
            vec![
                line("speed", Output::EfficiencySpeed, 100.0),
                line("torque", Output::EfficiencyTorque, 100.0),
                line("overall", Output::EfficiencyOverall, 100.0),
            ],
        ),
        over_ratio(
            "range_loss",
            "Friction loss by pulley over the operating range",
            Axis::new("friction loss W (W)"),
            vec![
                line("primary", Output::PrimaryFrictionLoss, 1.0),
                line("secondary", Output::SecondaryFrictionLoss, 1.0),
                line("both", Output::EnergyFrictionLoss, 1.0),
            ],
        ),
    ]
}

/// The pulleys' nominal radii and the belt at both ends of the range.
fn radii(ends: &Ends) -> Result<Option<Figure>, InternalError> {
    let (Some(low), Some(high)) = (&ends.low, &ends.high) else { return Ok(None) };
    let mut both: Option<Figure> = None;
    for (outcome, label) in [(low, "low range, 1.74"), (high, "high range, 0.72")] {
        let Some(figure) = plot::drive(outcome)?.into_iter().find(|figure| figure.equal) else { return Ok(None) };
        let frame = both.get_or_insert_with(|| {
            let caption = "The operating range: the belt's path at both ends, and the pulleys' nominal radii";
            let mut frame = Figure::new("range_radii", caption, figure.x.clone(), figure.y.clone(), Vec::new());
            frame.marks.clone_from(&figure.marks);
            frame.equal = true;
            frame
        });
        let color = usize::from(!frame.series.is_empty());
        let mut label = label.to_owned();
        for series in figure.series.into_iter().filter(|series| matches!(series.look, Look::Guide | Look::Line)) {
            let name = match series.look {
                Look::Line => std::mem::take(&mut label),
                _ if color == 0 => series.label.clone(),
                _ => String::new(),
            };
            frame.series.push(Series { label: name, ..series.color(color) });
        }
    }
    Ok(both)
}

/// Both ends of the range side by side: the fields of the base belt, the penetration of belts of other stiffness.
fn ends(chapters: &Chapters) -> Result<Vec<Figure>, InternalError> {
    let mut figures = Vec::new();
    if let Ends { low: Some(low), high: Some(high), .. } = &chapters.ends {
        let cases = [(low, "low range, 1.74".to_owned()), (high, "high range, 0.72".to_owned())];
        for (field, file) in
            [("axial_force", "axial_pressure"), ("sliding_speed", "sliding_speed"), ("tension", "tension")]
        {
            for (pulley, name) in [(0, "primary"), (1, "secondary")] {
                figures.extend(beside(field, pulley, &format!("range_{file}_{name}"), &cases)?);
            }
        }
    }
    type End = (fn(&Ends) -> Option<&Outcome>, &'static str);
    let ends: [End; 2] = [(|ends| ends.low.as_ref(), "low range"), (|ends| ends.high.as_ref(), "high range")];
    for (end, name) in ends {
        let case = |ends| Some((end(ends)?, format!("EI = {} N·m²", ends.bending_stiffness)));
        let cases: Vec<(&Outcome, String)> = chapters.belts.iter().filter_map(case).collect();
        for (pulley, which) in [(0, "primary"), (1, "secondary")] {
            let file = format!("bending_stiffness_penetration_{which}_{}", name.replace(' ', "_"));
            figures.extend(beside("penetration", pulley, &file, &cases)?.map(|mut figure| {
                figure.caption = format!("Penetration on the {which} in {name}, by bending stiffness");
                figure
            }));
        }
    }
    Ok(figures)
}

/// One field of one pulley, of several solutions.
fn beside(
    field: &str,
    pulley: usize,
    name: &str,
    cases: &[(&Outcome, String)],
) -> Result<Option<Figure>, InternalError> {
    let mut together: Option<Figure> = None;
    for (outcome, label) in cases {
        let Some(figure) = plot::drive(outcome)?.into_iter().find(|figure| figure.name == field) else {
            return Ok(None);
        };
        let Some(mut series) = figure.series.get(pulley).cloned() else { return Ok(None) };
        series.label.clone_from(label);
        let frame = together.get_or_insert_with(|| {
            let which = if pulley == 0 { "primary" } else { "secondary" };
            let guides = figure.series.get(2..).unwrap_or_default().to_vec();
            let caption = format!("{}, {which}", figure.caption);
            Figure::new(name, caption, figure.x.clone(), figure.y.clone(), guides)
        });
        frame.x.range = match (frame.x.range, figure.x.range) {
            (Some((low, a)), Some((_, b))) => Some((low, a.max(b))),
            (range, _) => range,
        };
        let at = frame.series.iter().filter(|series| series.color.is_some()).count();
        frame.series.insert(at, series.color(at));
    }
    Ok(together)
}

/// Efficiencies over the ratio, curve by curve; for the slack tension, axial forces over it as well.
fn family(family: &Family) -> Vec<Figure> {
    let entry = family.key.entry();
    let efficiencies = [
        ("overall", Output::EfficiencyOverall),
        ("speed", Output::EfficiencySpeed),
        ("torque", Output::EfficiencyTorque),
    ];
    let mut figures: Vec<Figure> = efficiencies
        .map(|(which, output)| {
            let line = |(value, rows): (f64, std::ops::Range<usize>)| {
                Series::line(entry.label_at(value), points(&family.table, rows, output, 100.0)).marked()
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
        let pulleys = [("primary", Output::PrimaryAxialForce), ("secondary", Output::SecondaryAxialForce)];
        figures.extend(pulleys.map(|(pulley, force)| forces(family, pulley, force)));
    }
    figures
}

fn forces(family: &Family, pulley: &str, force: Output) -> Figure {
    let curves = family.curves();
    let width = curves.first().map_or(0, |(_, rows)| rows.len());
    let line = |at: usize| {
        let points: Vec<(f64, f64)> =
            curves.iter().map(|(value, rows)| (*value, family.table.output(rows.start + at, force))).collect();
        let ratio =
            curves.first().map_or(f64::NAN, |(_, rows)| family.table.number(rows.start + at, Key::Ratio.path()));
        Series::line(format!("ratio {ratio:.2}"), points).marked()
    };
    let series = [0, width / 2, width.saturating_sub(1)].map(line).into();
    Figure::new(
        format!("slack_tension_axial_force_{pulley}"),
        format!("Axial force of the {pulley} over slack tension"),
        Axis::new("slack tension T_{slack} (N)").over(50.0, 800.0),
        Axis::new("axial force A (N)"),
        series,
    )
}

/// Which figures of the thesis a figure of [`figures`] stands for.
pub fn number_in_thesis(name: &str) -> Option<&'static str> {
    let (_, number) = NUMBERS.iter().find(|(known, _)| *known == name)?;
    Some(number)
}

const NUMBERS: [(&str, &str); 37] = [
    ("base_trajectory", "Figures 6.1, 6.14"),
    ("base_tension", "Figures 6.2, 6.4"),
    ("base_sliding_speed", "Figures 6.3, 6.5"),
    ("base_penetration", "Figures 6.6, 6.7"),
    ("base_sliding_angle", "Figures 6.8, 6.9"),
    ("base_inclination", "Figures 6.10, 6.11"),
    ("base_axial_force", "Figures 6.12, 6.13"),
    ("base_span_shape", "Figures 6.15, 6.16"),
    ("base_tight_span_tension", "Figure 6.17"),
    ("base_slack_span_tension", "Figure 6.18"),
    ("range_radii", "Figure 6.20"),
    ("range_axial_force", "Figure 6.21"),
    ("range_axial_pressure_primary", "Figure 6.22"),
    ("range_axial_pressure_secondary", "Figure 6.23"),
    ("range_efficiency", "Figure 6.24"),
    ("range_sliding_speed_primary", "Figure 6.25"),
    ("range_sliding_speed_secondary", "Figure 6.26"),
    ("range_tension_primary", "Figure 6.27"),
    ("range_tension_secondary", "Figure 6.28"),
    ("sheave_angle_overall_efficiency", "Figure 7.1"),
    ("sheave_angle_speed_efficiency", "Figure 7.2"),
    ("sheave_angle_torque_efficiency", "Figure 7.3"),
    ("bending_stiffness_overall_efficiency", "Figure 7.4"),
    ("bending_stiffness_speed_efficiency", "Figure 7.5"),
    ("bending_stiffness_torque_efficiency", "Figure 7.6"),
    ("bending_stiffness_penetration_primary_low_range", "Figure 7.7"),
    ("bending_stiffness_penetration_primary_high_range", "Figure 7.8"),
    ("bending_stiffness_penetration_secondary_low_range", "Figure 7.9"),
    ("bending_stiffness_penetration_secondary_high_range", "Figure 7.10"),
    ("slack_tension_overall_efficiency", "Figure 7.11"),
    ("slack_tension_speed_efficiency", "Figure 7.12"),
    ("slack_tension_torque_efficiency", "Figure 7.13"),
    ("slack_tension_axial_force_primary", "Figure 7.14"),
    ("slack_tension_axial_force_secondary", "Figure 7.15"),
    ("friction_overall_efficiency", "Figure 7.16"),
    ("friction_speed_efficiency", "Figure 7.17"),
    ("friction_torque_efficiency", "Figure 7.18"),
];
