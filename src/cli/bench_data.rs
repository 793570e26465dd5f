//! `sheave bench-data`: a made set of dynamometer logs.

use super::case::CaseArguments;
use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::bench::dyno::is_log;
use sheave::bench::engine::EngineCurve;
use sheave::bench::made::{Disturbance, files, names, truth};
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

/// What is known of the data, and what says so.
const KNOWN: &str = "known.json";
const README: &str = "README.md";
const MADE_BY: &str = "sheave bench-data";

/// The first file by name in the folder that is a log of another test, or that would be lost: none of the files made
/// replaces it, or it is not one that was made before.
fn in_the_way(folder: &Path, made: &[String]) -> io::Result<Option<(String, &'static str)>> {
    if !folder.exists() {
        return Ok(None);
    }
    let known = std::fs::read(folder.join(KNOWN)).ok();
    let known = known.and_then(|known| serde_json::from_slice::<serde_json::Value>(&known).ok());
    let again = known.is_some_and(|known| known["made_by"] == MADE_BY);
    let mut names: Vec<String> = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        names.push(entry?.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    let found = names.into_iter().find_map(|name| {
        let own = [KNOWN, README].contains(&name.as_str()) || made.contains(&name);
        if own && !again {
            Some((name, "which would be replaced"))
        } else if !own && is_log(&name) {
            Some((name, "of another test, which `sheave dyno` would read with these"))
        } else {
            None
        }
    });
    Ok(found)
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let case: Case = arguments.case.read()?;
    let engine = EngineCurve::read(&arguments.engine)?;
    let folder = &arguments.out;
    // Before the points are solved: that may take long.
    output::folder_place(Some(folder))?;
    let found = in_the_way(folder, &names(arguments.steps.into()));
    if let Some((name, why)) = found.map_err(|error| Stop::Write(folder.display().to_string(), error))? {
        return Err(Stop::Usage(format!(
            "{} has the file {name}, {why}: expected a folder without other logs, or one that `sheave bench-data` made",
            folder.display()
        )));
    }
    let known = truth(&case, &engine, arguments.engine_scale, RANGE, arguments.steps.into())?;
    output::create_folder(folder)?;
    let made = files(&known, &Disturbance::default(), arguments.seed);
    let resolved = case.resolve()?;
    let object = serde_json::json!({
        "made_by": MADE_BY,
        "seed": arguments.seed,
        "disturbance": Disturbance::default(),
        "known": known,
        "case": resolved,
    });
    let json = output::json(&object)?;
    // First, so that a set that is not whole may be made again.
    output::write_file(folder, KNOWN, |to| to.write_all(json.as_bytes()))?;
    for (name, text) in made {
        output::write_file(folder, &name, |to| to.write_all(text.as_bytes()))?;
    }
    output::write_file(folder, README, |to| to.write_all(MADE.as_bytes()))?;
    output::print(&format!("{} steps made in {}\n", known.steps.len(), folder.display()))
}
