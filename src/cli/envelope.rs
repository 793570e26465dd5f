//! The one object that `--json` prints, whatever happens.

use super::output;
use super::stop::{CANCELLED, Stop};
use serde::Serialize;
use sheave::result::{FailureKind, FailureReport, envelope, failed};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether standard output has its object: there is one, whoever says first why there is no result.
static TOLD: AtomicBool = AtomicBool::new(false);

/// The object of a command that has a result, as text.
pub fn object(
    command: &str,
    inputs: &impl Serialize,
    warnings: &[String],
    result: &impl Serialize,
) -> Result<String, Stop> {
    let object = envelope(command, inputs, warnings, result);
    output::json(&object.map_err(|error| Stop::Write("JSON".into(), error.into()))?)
}

/// The object of a command that has none, as text; `known` is what can be said nevertheless.
pub fn failure(command: &str, known: &impl Serialize, failure: &FailureReport) -> Result<String, Stop> {
    let object = failed(command, known, failure);
    output::json(&object.map_err(|error| Stop::Write("JSON".into(), error.into()))?)
}

/// Prints the object of a command that failed, unless that was done before.
pub fn tell(command: &str, known: &impl Serialize, report: &FailureReport) -> Result<(), Stop> {
    if TOLD.swap(true, Ordering::Relaxed) {
        return Ok(());
    }
    output::print(&failure(command, known, report)?)
}

/// What the arguments ask for, read before they are understood: arguments that are not understood end a command, too.
pub struct Asked {
    command: String,
    json: bool,
}

impl Asked {
    /// Of this process.
    pub fn of_arguments() -> Self {
        let arguments: Vec<String> =
            std::env::args_os().skip(1).map(|argument| argument.to_string_lossy().into_owned()).collect();
        let command = arguments.iter().find(|argument| !argument.starts_with('-')).cloned().unwrap_or_default();
        Self { command, json: arguments.iter().any(|argument| argument == "--json") }
    }

    /// Prints the object of a command that failed if JSON was asked for and none was printed.
    pub fn tell(&self, report: &FailureReport) {
        if self.json {
            // Where it goes is full or closed: the exit status has to do.
            let _ = tell(&self.command, &(), report);
        }
    }
}

impl Stop {
    /// For the object.
    pub fn failure(&self) -> FailureReport {
        let report = |kind, message: String, hint: Option<String>| FailureReport { kind, message, hint };
        match self {
            Self::Input(error) => {
                let unreadable = matches!(error.problem(), sheave::case::CaseProblem::Read { .. });
                let kind = if unreadable { FailureKind::Unreadable } else { FailureKind::Input };
                report(kind, error.to_string(), error.hint())
            }
            Self::Refused(error) => {
                report(FailureKind::Input, error.to_string(), error.help().map(|help| help.to_string()))
            }
            Self::Usage(reason) => report(FailureKind::Input, reason.clone(), None),
            Self::NoSolution(reason) | Self::Unreached(reason) => report(FailureKind::NoSolution, reason.clone(), None),
            Self::Advised(reason, hint) => report(FailureKind::NoSolution, reason.clone(), Some((*hint).to_owned())),
            Self::Cancelled => report(FailureKind::Cancelled, CANCELLED.to_owned(), None),
            Self::Write(what, error) => report(FailureKind::Output, format!("cannot write {what}: {error}"), None),
        }
    }
}
