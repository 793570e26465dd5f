//! `sheave compare`: measured operating points against the model.

use super::case::CaseArguments;
use super::measured::{object, refused, warn};
use super::output;
use super::stop::Stop;
use clap::{Args, ValueEnum};
use sheave::bench::compare::{
    ACTUATOR_KEYS, Actuator, Clamp, Comparison, Options, Radii, compare, determined, figures, read, scale_interval,
    summary,
};
use sheave::bench::engine::EngineCurve;
use sheave::bench::{BenchError, PageTable, keys, page};
use sheave::case::Case;
use sheave::text::on_one_line;
use std::path::PathBuf;

/// Compare measured operating points with the model
///
/// Each point is solved with its measured speeds and output torque and with the case's clamp, or that of the primary's
/// flyweights and spring (9.3). Points that are not steady are named and left out. The scale of the
/// engine's curve is found by least squares, and constants of the model with --fit. With --losses on, the model's
/// efficiency is that with hysteresis, drag and gears.
#[derive(Debug, Args)]
#[command(after_long_help = help() + "\n" + super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// Table of operating points, as `sheave dyno --out` writes it: primary_rpm, secondary_rpm, secondary_torque_Nm;
    /// with their standard deviations (_sd) and errors (_se, of the means of n_parts parts), run, step,
    /// primary_torque_Nm where there are
    #[arg(long, value_name = "POINTS.csv")]
    data: PathBuf,
    /// The engine's curve: rpm, and power or torque in the unit that a header names; hp without one
    #[arg(long, value_name = "ENGINE.csv")]
    engine: Option<PathBuf>,
    /// Flyweights and spring of the primary, which then take the place of the case's clamp
    #[arg(long, value_name = "FILE.toml")]
    flyweights: Option<PathBuf>,
    /// What the radii follow from
    #[arg(long, value_name = "FROM", default_value = "speeds")]
    radii: RadiiFrom,
    /// Fit a constant to the data: a key of belt or sheave, the case's clamp, engine.scale, or with --losses on a loss
    /// tangent or a key of losses; may be given several times
    #[arg(long, value_name = "KEY")]
    fit: Vec<String>,
    /// Relative tolerance of the solutions, from 1e-12 to 0.1
    #[arg(long, value_name = "T", default_value = "1e-4", value_parser = super::solve::tolerance)]
    tol: f64,
    /// Print the result as one JSON object, in SI units
    #[arg(long, conflicts_with = "out")]
    json: bool,
    /// Write result.json, figures (SVG, PNG) and report.html into this folder, and print the summary
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What the radii of a point follow from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum RadiiFrom {
    /// Both speeds and the belt's length, slip included
    Speeds,
    /// The ratio of the speeds as if nothing slipped (6.12), as the thesis has it
    Ratio,
}

fn help() -> String {
    format!("Keys of --flyweights:\n{}", keys(&ACTUATOR_KEYS))
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case = arguments.case.read()?;
    output::folder_place(arguments.out.as_deref())?;
    let found = arguments.find(&case).map_err(|error| refused("compare", arguments.json, error))?;
    warn(&found.warnings);
    arguments.deliver(&case, &found)
}

impl Arguments {
    fn find(&self, case: &Case) -> Result<Comparison, BenchError> {
        let engine = self.engine.as_deref().map(EngineCurve::read).transpose()?;
        let table = read(&self.data, engine.as_ref())?;
        let clamp = match &self.flyweights {
            Some(path) => Clamp::Actuator(Actuator::read(path)?),
            None => Clamp::OfCase,
        };
        let radii = match self.radii {
            RadiiFrom::Speeds => Radii::Speeds,
            RadiiFrom::Ratio => Radii::Ratio,
        };
        let options = Options { tolerance: self.tol, radii, clamp, fit: self.fit.clone() };
        let mut comparison = compare(case, table, &options)?;
        comparison.warnings.extend(engine.as_ref().and_then(EngineCurve::assumption));
        Ok(comparison)
    }

    fn deliver(&self, case: &Case, found: &Comparison) -> Result<(), Stop> {
        let inputs = serde_json::json!({
            "case": case.resolve().ok(),
            "data": self.data,
            "engine": self.engine,
            "flyweights": self.flyweights,
            "fit": self.fit,
            "tolerance": self.tol,
        });
        let json = || object("compare", inputs, &found.warnings, found);
        if self.json {
            return output::print(&json()?);
        }
        let text = summary(found);
        if let Some(folder) = &self.out {
            output::create_folder(folder)?;
            let json = json()?;
            output::write_file(folder, "result.json", |to| to.write_all(json.as_bytes()))?;
            let all = figures(found);
            output::write_figures(folder, &all)?;
            let page = page("Model and measurement", "", &found.warnings, &tables(found), &all)?;
            output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
        }
        output::print(&text)
    }
}

fn tables(found: &Comparison) -> Vec<PageTable> {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
    let percent = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{:.2}", 100.0 * value));
    let row = |point: &sheave::bench::compare::Compared| {
        vec![
            on_one_line(&point.run),
            point.step.map_or_else(String::new, |step| step.to_string()),
            point.speed_ratio.map_or_else(String::new, |ratio| format!("{ratio:.3}")),
            point.primary_radius.map_or_else(String::new, |radius| format!("{:.2}", 1e3 * radius)),
            point.primary_axial_force.map_or_else(String::new, |force| format!("{force:.0}")),
            percent(point.efficiency_measured),
            percent(point.efficiency_model),
            percent(point.efficiency_elastic),
            point.reason.clone().unwrap_or_default(),
        ]
    };
    let columns = names(&[
        "run",
        "step",
        "ω_P/ω_S",
        "R_P (mm)",
        "A_P (N)",
        "measured (%)",
        "model (%)",
        "friction alone (%)",
        "left out, why",
    ]);
    let mut tables = vec![PageTable { title: "Points".into(), columns, rows: found.points.iter().map(row).collect() }];
    let value = |name: &str, value: String| vec![name.to_owned(), value];
    let rows = vec![
        value("model less measurement, mean (percentage points)", format!("{:.3}", 100.0 * found.mean_error)),
        value("root mean square (percentage points)", format!("{:.3}", 100.0 * found.rms)),
        value("R²", determined(found.r_squared)),
        value("scale of the engine's power", format!("{:.4}", found.scale)),
        value("its 95 % interval", scale_interval(found)),
        value("root mean square with it (percentage points)", format!("{:.3}", 100.0 * found.rms_after_scale)),
        value("R² with it", determined(found.r_squared_after_scale)),
    ];
    tables.push(PageTable { title: "Agreement".into(), columns: names(&["", "value"]), rows });
    if let Some(fit) = &found.fit {
        let row = |constant: &sheave::bench::compare::FittedConstant| {
            let mut interval =
                constant.interval.map_or("not determined".into(), |(low, high)| format!("{low:.6e} to {high:.6e}"));
            if constant.at_end_of_range {
                interval.push_str(", at the end of its range");
            }
            vec![constant.key.clone(), format!("{:.6e}", constant.value), interval, format!("{:.6e}", constant.start)]
        };
        let columns = names(&["constant (SI)", "value", "95 % interval", "started from"]);
        let rows = fit.constants.iter().map(row).collect();
        tables.push(PageTable { title: "Fit".into(), columns, rows });
    }
    tables
}
