//! The arguments that say which case a command is about.

use super::stop::Stop;
use clap::Args;
use clap::builder::PossibleValue;
use clap::builder::PossibleValuesParser;
use sheave::case::{Case, CaseError, Edition, Include, Key, Resolved};
use sheave::study::{Axis, StudyError, StudyFile};
use std::io::{self, Read};
use std::path::PathBuf;

/// Which case; flattened into the arguments of every command that takes one.
#[derive(Debug, Args)]
pub struct CaseArguments {
    /// Case file, `-` for standard input; without one, the built-in base case (Table 6.1 of the thesis)
    #[arg(value_name = "CASE.toml")]
    file: Option<PathBuf>,
    /// Set a key of the case, in place of the file's value for it: operating_point.slack_tension="120 N"
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// Take a key out of the file's case, before any --set: another key can then fill its slot
    #[arg(long = "unset", value_name = "KEY")]
    unset: Vec<String>,
    /// Find a constant for an output that is prescribed: "belt.bending_stiffness for efficiency.overall = 0.96"; in a
    /// case file, swap = ["..."]
    #[arg(long = "swap", value_name = "KEY for OUTPUT = VALUE")]
    swap: Vec<String>,
    /// Edition of the equations, in place of the case's
    #[arg(long, value_name = "E", value_parser = edition_parser())]
    edition: Option<String>,
    /// Losses besides friction (hysteresis, drag, gears), in place of the case's losses.include
    #[arg(long, value_name = "on|off", value_parser = losses_parser())]
    losses: Option<String>,
}

/// Whether losses are told, by name.
fn losses_parser() -> PossibleValuesParser {
    let values = Include::CHOICES.iter().map(|choice| PossibleValue::new(choice.name).help(choice.doc));
    PossibleValuesParser::new(values)
}

/// How messages name standard input.
const STDIN: &str = "standard input";
/// Longest case that is read from standard input, bytes.
const LONGEST: u64 = 16 << 20;

/// All of standard input.
fn standard_input() -> Result<String, CaseError> {
    let mut text = String::new();
    match io::stdin().lock().take(LONGEST).read_to_string(&mut text) {
        Ok(_) => Ok(text),
        Err(error) => Err(CaseError::unreadable(STDIN, &error)),
    }
}

/// One of the editions, by name.
pub fn edition_parser() -> PossibleValuesParser {
    let values = Edition::CHOICES.iter().map(|choice| PossibleValue::new(choice.name).help(choice.doc));
    PossibleValuesParser::new(values)
}

impl CaseArguments {
    /// The case: the file, then --unset, --set and --edition, in this order.
    pub fn read(&self) -> Result<Case, CaseError> {
        let case = match &self.file {
            Some(path) if path.as_os_str() == "-" => Case::from_toml(STDIN, &standard_input()?)?,
            Some(path) => Case::read(path)?,
            None => Case::base(),
        };
        self.changed(case)
    }

    /// The same for a command that prescribes no outputs of the belt.
    pub fn read_unswapped(&self, command: &str) -> Result<Case, Stop> {
        let case = self.read()?;
        if let Some(swap) = case.swaps().next() {
            return Err(Stop::Usage(format!(
                "swap \"{swap}\": `sheave {command}` prescribes no output of the belt; expected a case without swap, \
                 or solve, sweep, limit, optimum or pulley"
            )));
        }
        Ok(case)
    }

    /// The case, and what the file says is to be varied in it.
    pub fn read_study(&self) -> Result<(Case, Vec<Axis>), StudyError> {
        let StudyFile { case, axes } = match &self.file {
            Some(path) if path.as_os_str() == "-" => StudyFile::from_toml(STDIN, &standard_input()?)?,
            Some(path) => StudyFile::read(path)?,
            None => StudyFile { case: Case::base(), axes: Vec::new() },
        };
        Ok((self.changed(case)?, axes))
    }

    /// The file's case with what the command line changes.
    fn changed(&self, mut case: Case) -> Result<Case, CaseError> {
        self.unset.iter().try_for_each(|key| case.unset(key))?;
        // What the command line sets takes the place of what the file says in another way.
        let key = |assignment: &String| Key::from_path(assignment.split('=').next().unwrap_or_default().trim());
        let set: Vec<Key> = self.set.iter().filter_map(key).collect();
        let before: Vec<Key> = case.keys().collect();
        case.make_room(&set);
        for key in before.into_iter().filter(|key| !case.has(*key)) {
            tracing::info!("`{}` of the file makes room for what --set says", key.path());
        }
        self.set.iter().try_for_each(|assignment| case.assign(assignment))?;
        self.swap.iter().try_for_each(|swap| case.swap(swap))?;
        if let Some(edition) = &self.edition {
            case.set(Key::Edition.path(), edition)?;
        }
        if let Some(losses) = &self.losses {
            case.set(Key::Losses.path(), losses)?;
        }
        Ok(case)
    }

    /// The case, resolved and fit for the solver.
    pub fn resolve(&self) -> Result<Resolved, CaseError> {
        Self::check(&self.read()?)
    }

    /// A case, resolved and fit for the solver; remarks on it go to standard error.
    pub fn check(case: &Case) -> Result<Resolved, CaseError> {
        let resolved = case.resolve()?;
        case.check_posed(&resolved)?;
        case.remarks().iter().for_each(|remark| tracing::warn!("{remark}"));
        Ok(resolved)
    }
}
