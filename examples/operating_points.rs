//! Section 7.3 of the thesis turned round, and the two friction laws: axial forces prescribed, slack tensions found.
//! `cargo run --release --example operating_points -- FOLDER` writes the figures into a folder.

use std::error::Error;
use std::path::Path;

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::plot::{Axis as Scale, Figure, Look, Series};
use sheave::study::{Axis, Study, Table, table};

const TENSION: &str = "primary.exit_tension";
const RATIOS: [&str; 3] = ["1.74", "1", "0.72"];

fn solve(edition: &str, friction: &str, axes: &[&str]) -> Result<Table, Box<dyn Error>> {
    let mut case = Case::base();
    case.set("edition", edition)?;
    case.set("model.friction", friction)?;
    let axes = axes.iter().map(|axis| Axis::parse(axis)).collect::<Result<Vec<_>, _>>()?;
    Ok(table(&Study::new(case, axes, SolveOptions { tolerance: 1e-5, ..SolveOptions::default() })?, None)?)
}

fn points(table: &Table, x: &str, y: &str, scale: f64) -> Vec<(f64, f64)> {
    (0..table.rows.len()).map(|row| (table.number(row, x), scale * table.number(row, y))).collect()
}

/// Largest distance from the straight line of least squares, over the range of y.
fn bend(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x));
    let off = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).abs()).fold(0.0, f64::max);
    let range = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.1), b.max(p.1)));
    off / (range.1 - range.0)
}

/// Figures 7.14 and 7.15: axial forces are prescribed, slack tensions found.
fn axial_forces(edition: &str) -> Result<Vec<Figure>, Box<dyn Error>> {
    let mut figures = Vec::new();
    for (pulley, range) in [("primary", "950..3400 N:15"), ("secondary", "750..2900 N:15")] {
        let force = format!("operating_point.{pulley}_axial_force");
        let mut series = Vec::new();
        for ratio in RATIOS {
            let table =
                solve(edition, "viscous-coulomb", &[&format!("drive.ratio={ratio}"), &format!("{force}={range}")])?;
            let line = points(&table, TENSION, &force, 1.0);
            println!(
                "{edition}, {pulley}, ratio {ratio}: {} failures, off a straight line by {:.2} %",
                table.failures(),
                100.0 * bend(&line)
            );
            series.push(Series::line(format!("ratio {ratio}"), line));
        }
        figures.push(Figure::new(
            format!("swap_axial_force_{pulley}_{edition}"),
            format!("Axial force of the {pulley}, prescribed, over the slack tension found, edition {edition}"),
            Scale::new("slack tension T_{slack} (N)"),
            Scale::new("axial force A (N)"),
            series,
        ));
    }
    Ok(figures)
}

/// Slack tension and efficiency at prescribed axial forces, with both friction laws.
fn friction_laws() -> Result<Figure, Box<dyn Error>> {
    println!("\nfriction laws, 18 N·m, edition consistent:");
    println!("{:>8}{:>6}{:>24}{:>24}", "A_P", "ratio", "T_slack, N (vc, tanh)", "efficiency, % (vc, tanh)");
    let mut series = Vec::new();
    for ratio in RATIOS {
        let axes = [format!("drive.ratio={ratio}"), "operating_point.primary_axial_force=600..2400 N:37".to_owned()];
        let axes = axes.each_ref().map(String::as_str);
        let [viscous, smooth] = [solve("consistent", "viscous-coulomb", &axes)?, solve("consistent", "tanh", &axes)?];
        for row in [0, 9, 18, 36] {
            let force = viscous.number(row, "operating_point.primary_axial_force");
            let pair = |column: &str, scale: f64| [&viscous, &smooth].map(|table| scale * table.number(row, column));
            let ([a, b], [c, d]) = (pair(TENSION, 1.0), pair("efficiency.overall", 100.0));
            println!("{force:>8.0}{ratio:>6}{a:>12.2}{b:>12.2}{c:>12.3}{d:>12.3}");
        }
        let color = series.len() / 2;
        let line = |table: &Table| points(table, "operating_point.primary_axial_force", "efficiency.overall", 100.0);
        series.push(Series::line(format!("ratio {ratio}, viscous-coulomb"), line(&viscous)).color(color));
        let sparse = line(&smooth).into_iter().step_by(3).collect();
        series.push(Series::line(format!("ratio {ratio}, tanh"), sparse).color(color).look(Look::Dots));
    }
    Ok(Figure::new(
        "swap_friction_laws",
        "Overall efficiency over the prescribed axial force, by friction law",
        Scale::new("axial force A_{P} (N)"),
        Scale::new("overall efficiency η (%)"),
        series,
    ))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut figures = axial_forces("published")?;
    figures.extend(axial_forces("consistent")?);
    figures.push(friction_laws()?);
    if let Some(folder) = std::env::args().nth(1) {
        std::fs::create_dir_all(&folder)?;
        for figure in figures {
            let path = Path::new(&folder);
            std::fs::write(path.join(format!("{}.svg", figure.name)), figure.svg()?)?;
            std::fs::write(path.join(format!("{}.png", figure.name)), figure.png()?)?;
        }
    }
    Ok(())
}
