//! What the commands about measurements share: their objects and how they end.

use super::envelope;
use super::stop::Stop;
use serde::Serialize;
use serde_json::Value;
use sheave::bench::{BenchError, BenchProblem};
use sheave::result::{FailureKind, FailureReport};

/// The object of a command that has a result.
pub fn object(command: &str, inputs: Value, warnings: &[String], result: &impl Serialize) -> Result<String, Stop> {
    envelope::object(command, &inputs, warnings, result)
}

/// Tells people of warnings.
pub fn warn(warnings: &[String]) {
    for warning in warnings {
        tracing::warn!("{warning}");
    }
}

/// Bad input: whoever asked for JSON gets an object, too. Of what Ctrl-C has ended that is told where all commands end.
pub fn refused(command: &str, json: bool, error: BenchError) -> Stop {
    if matches!(error.problem(), BenchProblem::Cancelled) {
        return Stop::Cancelled;
    }
    let kind = match error.problem() {
        BenchProblem::Read { .. } => FailureKind::Unreadable,
        BenchProblem::NoData { .. } => FailureKind::NoData,
        BenchProblem::NoSolution { .. } => FailureKind::NoSolution,
        _ => FailureKind::Input,
    };
    let hint = error.advice().map(str::to_owned);
    let report = FailureReport { kind, message: error.to_string(), hint };
    let told = if json { envelope::tell(command, &(), &report) } else { Ok(()) };
    told.err().unwrap_or_else(|| error.into())
}
