//! How far the simple belt drive of `sheave init` is from the full model over the operating range: torque and one axial
//! force are given to both. `cargo run --release --example simple_and_full -- FOLDER` writes table and figures.

use std::error::Error;
use std::path::Path;

use sheave::case::{Case, Resolved};
use sheave::drive::SolveOptions;
use sheave::plot::{Axis as Scale, Figure, Look, Series};
use sheave::small::init::{InitialState, SimpleDrive, Situation, solve};
use sheave::study::{Axis, Study, table};

const EDITIONS: [&str; 2] = ["consistent", "thesis"];
const CLAMPS: [&str; 2] = ["primary", "secondary"];
const RATIOS: [f64; 3] = [0.72, 1.0, 1.74];
const FORCES: [f64; 3] = [600.0, 1050.0, 2400.0];
const TORQUES: &str = "operating_point.primary_torque = 3..30 N*m : 10";

/// What both models find, in the order of a [`Found`].
const QUANTITIES: [&str; 8] = [
    "belt_speed",
    "secondary_speed",
    "speed_loss",
    "secondary_torque",
    "overall_efficiency",
    "tight_tension",
    "slack_tension",
    "other_axial_force",
];
const SPEED_LOSS: usize = 2;
const EFFICIENCY: usize = 4;
const TIGHT: usize = 5;
const SLACK: usize = 6;
/// Overall efficiency of the full model below which an operating point is left out of the summary.
const USEFUL: f64 = 0.8;

/// SI; not a number where a model has no solution.
type Found = [f64; 8];

/// One operating point.
struct Row {
    edition: &'static str,
    clamp: &'static str,
    ratio: f64,
    force: f64,
    torque: f64,
    full: Found,
    simple: Found,
}

/// What the simple drive finds.
fn simple(case: &Resolved) -> Found {
    let find = || -> Option<(InitialState, bool)> {
        let situation = Situation::of_case(case, false).ok()?;
        let on_primary = matches!(situation, Situation::Seven { .. });
        Some((solve(&SimpleDrive::of_case(case), situation).ok()?, on_primary))
    };
    let Some((state, on_primary)) = find() else { return [f64::NAN; 8] };
    let ratio = case.drive.secondary_radius / case.drive.primary_radius;
    [
        state.belt_speed,
        state.output_speed,
        1.0 - ratio * state.output_speed / state.input_speed,
        state.output_torque,
        -state.output_torque * state.output_speed / (state.input_torque * state.input_speed),
        state.tight_tension,
        state.slack_tension,
        if on_primary { state.output_axial_force } else { state.input_axial_force },
    ]
}

/// All torques at one ratio, clamp and force, by both models.
fn line(edition: &'static str, clamp: &'static str, ratio: f64, force: f64) -> Result<Vec<Row>, Box<dyn Error>> {
    let mut case = Case::base();
    case.set("edition", edition)?;
    case.set("drive.ratio", &ratio.to_string())?;
    case.set(&format!("operating_point.{clamp}_axial_force"), &force.to_string())?;
    let study = Study::new(case, [Axis::parse(TORQUES)?], SolveOptions { tolerance: 1e-5, ..SolveOptions::default() })?;
    let full = table(&study, None)?;
    let other = if clamp == "primary" { "secondary" } else { "primary" };
    let row = |index: usize| {
        let case = study.point(index)?.case?;
        let number = |column: &str| full.number(index, column);
        Ok(Row {
            edition,
            clamp,
            ratio,
            force,
            torque: number("operating_point.primary_torque"),
            full: [
                number("belt.mass_flow") / case.belt.mass_per_length,
                number("secondary.speed"),
                1.0 - number("efficiency.speed"),
                number("secondary.torque"),
                number("efficiency.overall"),
                number("primary.entry_tension"),
                number("primary.exit_tension"),
                number(&format!("{other}.axial_force")),
            ],
            simple: simple(&case),
        })
    };
    (0..study.points()).map(row).collect()
}

/// Simple less full: over the full model's value, for the slack tension over its tight tension; speed losses as they
/// are.
fn differences(row: &Row) -> Found {
    std::array::from_fn(|index| {
        let scale = match index {
            SPEED_LOSS => 1.0,
            SLACK => row.full[TIGHT],
            _ => row.full[index],
        };
        (row.simple[index] - row.full[index]) / scale
    })
}

fn write(rows: &[Row], path: &Path) -> Result<(), Box<dyn Error>> {
    let mut writer = csv::Writer::from_path(path)?;
    let header = ["edition", "clamp", "ratio", "axial_force", "primary_torque"].map(str::to_owned).into_iter();
    let blocks = ["full", "simple", "difference"];
    let named = blocks.iter().flat_map(|block| QUANTITIES.map(|quantity| format!("{block}.{quantity}")));
    writer.write_record(header.chain(named))?;
    let field = |value: f64| if value.is_finite() { format!("{value:.6}") } else { String::new() };
    for row in rows {
        let point = [row.edition.to_owned(), row.clamp.to_owned()].into_iter();
        let numbers = [row.ratio, row.force, row.torque].map(|value| value.to_string()).into_iter();
        let found = [row.full, row.simple, differences(row)].concat().into_iter().map(field);
        writer.write_record(point.chain(numbers).chain(found))?;
    }
    Ok(writer.flush()?)
}

/// Where both models have a solution, and the full one is a useful drive: smallest, median and largest difference, in
/// percent.
fn summarise(rows: &[Row]) {
    println!("| edition | axial force given | | smallest, % | median, % | largest, % |\n|---|---|---|---|---|---|");
    for (edition, clamp) in EDITIONS.iter().flat_map(|edition| CLAMPS.map(|clamp| (*edition, clamp))) {
        let here = || rows.iter().filter(move |row| (row.edition, row.clamp) == (edition, clamp));
        let useful = || here().filter(|row| row.full[EFFICIENCY] >= USEFUL);
        for (index, quantity) in QUANTITIES.iter().enumerate() {
            let percent = |row: &Row| 100.0 * differences(row)[index];
            let mut found: Vec<f64> = useful().map(percent).filter(|value| value.is_finite()).collect();
            found.sort_by(f64::total_cmp);
            if let (Some(least), Some(median), Some(most)) = (found.first(), found.get(found.len() / 2), found.last()) {
                println!("| `{edition}` | {clamp} | {quantity} | {least:.2} | {median:.2} | {most:.2} |");
            }
        }
        let solved = |of: fn(&Row) -> Found| here().filter(|row| of(row).iter().all(|value| value.is_finite())).count();
        let (full, simple) = (solved(|row| row.full), solved(|row| row.simple));
        let (all, useful) = (here().count(), useful().count());
        println!("{edition}, {clamp}: of {all} points full solves {full}, simple {simple}; {useful} are useful drives");
    }
}

/// A quantity over the torque by both models, at the ratio 1, for each axial force.
fn figure(rows: &[Row], clamp: &str, quantity: &str, axis: Scale, scale: f64) -> Figure {
    let index = QUANTITIES.iter().position(|name| *name == quantity).unwrap_or_default();
    let mut series = Vec::new();
    for (color, force) in FORCES.into_iter().enumerate() {
        let at = |row: &&Row| (row.edition, row.clamp, row.ratio, row.force) == ("consistent", clamp, 1.0, force);
        let points = |of: fn(&Row) -> Found| -> Vec<(f64, f64)> {
            let value = |row: &Row| scale * of(row)[index];
            rows.iter().filter(at).map(|row| (row.torque, value(row))).collect()
        };
        let symbol = if clamp == "primary" { "A_{P}" } else { "A_{S}" };
        series.push(Series::line(format!("{symbol} = {force} N, full"), points(|row| row.full)).color(color));
        let dashed = Series::line(format!("{symbol} = {force} N, simple"), points(|row| row.simple));
        series.push(dashed.color(color).look(Look::Dashed));
    }
    Figure::new(
        format!("simple_{}_{clamp}", quantity),
        format!("The simple drive beside the full model, edition consistent, ratio 1: {}", axis.label),
        Scale::new("torque M_{in} (N·m)"),
        axis,
        series,
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut rows = Vec::new();
    for (edition, clamp) in EDITIONS.iter().flat_map(|edition| CLAMPS.map(|clamp| (*edition, clamp))) {
        for (ratio, force) in RATIOS.iter().flat_map(|ratio| FORCES.map(|force| (*ratio, force))) {
            rows.extend(line(edition, clamp, ratio, force)?);
        }
    }
    summarise(&rows);
    if let Some(folder) = std::env::args().nth(1) {
        let folder = Path::new(&folder);
        std::fs::create_dir_all(folder)?;
        write(&rows, &folder.join("simple-and-full.csv"))?;
        for figure in [
            figure(&rows, "primary", "slack_tension", Scale::new("slack tension T_{slack} (N)"), 1.0),
            figure(&rows, "secondary", "slack_tension", Scale::new("slack tension T_{slack} (N)"), 1.0),
            figure(&rows, "primary", "speed_loss", Scale::log("speed loss 1 − ω_{S} R_{S}/(ω_{P} R_{P}) (%)"), 100.0),
            figure(&rows, "primary", "other_axial_force", Scale::new("axial force A_{S} (N)"), 1.0),
        ] {
            std::fs::write(folder.join(format!("{}.svg", figure.name)), figure.svg()?)?;
            std::fs::write(folder.join(format!("{}.png", figure.name)), figure.png()?)?;
        }
    }
    Ok(())
}
