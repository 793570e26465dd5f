//! `sheave bench-data`: a made set of dynamometer logs.

use super::case::CaseArguments;
use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::bench::dyno::step_file;
use sheave::bench::engine::EngineCurve;
use sheave::bench::made::{Disturbance, files, truth};
use sheave::case::Case;
use std::io;
use std::path::{Path, PathBuf};

/// Make a set of dynamometer logs from the model
///
/// Solves the case at several ratios and writes what a test stand would have logged there, with noise, firing, dropouts
/// of the slip ring and errors of the transmission; and what is known: known.json. For trying out, and for testing,
/// `sheave dyno` and `sheave compare`. The same seed makes the same files.
#[derive(Debug, Args)]
#[command(after_help = super::STATUS)]
pub struct Arguments {
    #[command(flatten)]
    case: CaseArguments,
    /// The engine's curve
    #[arg(long, value_name = "ENGINE.csv")]
    engine: PathBuf,
    /// True over tabulated power of the engine
    #[arg(long, value_name = "X", default_value_t = 0.95, value_parser = scale)]
    engine_scale: f64,
    /// Number of operating points, from 2 to 1000
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u16).range(2..=1000))]
    steps: u16,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Folder for the files
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Lowest and highest range of the steps, R_S/R_P.
const RANGE: (f64, f64) = (1.7, 0.75);

const MADE: &str = "\
# Made data

No test stand wrote these files: `sheave bench-data` made them from the model, with the constants in `known.json`, and \
    disturbed
them. They are for trying out and testing `sheave dyno` and `sheave compare`, and say nothing about any real drive.
";

fn scale(text: &str) -> Result<f64, String> {
    text.parse().ok().filter(|x| (0.1..=10.0).contains(x)).ok_or_else(|| "expected a number from 0.1 to 10".into())
}

/// The first log by name in the folder that none of the files made replaces.
fn other_log(folder: &Path, made: &[(String, String)]) -> io::Result<Option<String>> {
    let mut first: Option<String> = None;
    for entry in std::fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        let is_other = step_file(&name).is_some() && !made.iter().any(|(own, _)| *own == name);
        if is_other && first.as_ref().is_none_or(|first| name < *first) {
            first = Some(name);
        }
    }
    Ok(first)
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case: Case = arguments.case.read()?;
    let engine = EngineCurve::read(&arguments.engine)?;
    let known = truth(&case, &engine, arguments.engine_scale, RANGE, arguments.steps.into())?;
    let folder = &arguments.out;
    output::create_folder(folder)?;
    let made = files(&known, &Disturbance::default(), arguments.seed);
    if let Some(other) = other_log(folder, &made).map_err(|error| Stop::Write(folder.display().to_string(), error))? {
        return Err(Stop::Usage(format!(
            "{} has the log {other} of another test, which `sheave dyno` would read with these: expected a folder \
             without other logs",
            folder.display()
        )));
    }
    for (name, text) in made {
        output::write_file(folder, &name, |to| to.write_all(text.as_bytes()))?;
    }
    let resolved = case.resolve()?;
    let object = serde_json::json!({
        "made_by": "sheave bench-data",
        "seed": arguments.seed,
        "disturbance": Disturbance::default(),
        "known": known,
        "case": resolved,
    });
    let json = output::json(&object)?;
    output::write_file(folder, "known.json", |to| to.write_all(json.as_bytes()))?;
    output::write_file(folder, "README.md", |to| to.write_all(MADE.as_bytes()))?;
    output::print(&format!("{} steps made in {}\n", known.steps.len(), folder.display()))
}
