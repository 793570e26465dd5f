//! Why a command ends without a result, and what the exit status says of it.

use sheave::Cancel;
use sheave::case::CaseError;
use sheave::drive::Failure;
use sheave::model::InternalError;
use sheave::plot::PlotError;
use sheave::study::StudyError;
use sheave::text::printable;
use std::io::{self, Write};
use std::process::ExitCode;

/// Why a command ends without a result.
#[derive(Debug)]
pub enum Stop {
    /// Bad input: nothing was computed.
    Input(CaseError),
    /// Bad input other than a case's: nothing was computed.
    Usage(String),
    /// Bad input with its place: nothing was computed.
    Refused(miette::Report),
    /// There is no solution, or none was found; the reason.
    NoSolution(String),
    /// There is no solution, or none was found: the reason, and what to try.
    Advised(String, &'static str),
    /// Ctrl-C.
    Cancelled,
    /// A result was told, and is not what was asked for; the reason.
    Unreached(String),
    /// A file, or standard output, could not be written.
    Write(String, io::Error),
}

impl Stop {
    /// Tells people on standard error, and everyone by the exit status.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Input(error) => {
                for error in error.into_each() {
                    tell(&format!("{:?}", miette::Report::new(error)));
                }
                ExitCode::from(2)
            }
            Self::Refused(report) => {
                tell(&format!("{report:?}"));
                ExitCode::from(2)
            }
            Self::Usage(reason) => {
                tell(&(printable(&reason) + "\n"));
                ExitCode::from(2)
            }
            Self::NoSolution(reason) | Self::Unreached(reason) => {
                tell(&(printable(&reason) + "\n"));
                ExitCode::from(3)
            }
            Self::Advised(reason, hint) => {
                tell(&(printable(&format!("{reason}\n{hint}")) + "\n"));
                ExitCode::from(3)
            }
            Self::Cancelled => {
                tell(&format!("{CANCELLED}\n"));
                ExitCode::from(INTERRUPTED)
            }
            // Whoever reads has enough: nobody to tell.
            Self::Write(_, error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::from(1),
            Self::Write(what, error) => {
                tell(&(printable(&format!("cannot write {what}: {error}")) + "\n"));
                ExitCode::from(1)
            }
        }
    }
}

/// What is said of a command that Ctrl-C has ended.
pub const CANCELLED: &str = "cancelled";
/// Exit status of a command that an interrupt has ended: 128 and the number of the signal, as shells have it.
const INTERRUPTED: u8 = 130;

/// A handle that Ctrl-C cancels, so that the command ends in order; a second Ctrl-C ends the program at once.
pub fn cancel_on_interrupt() -> Cancel {
    let cancel = Cancel::new();
    let handle = cancel.clone();
    let interrupted = move || {
        if handle.is_cancelled() {
            std::process::exit(i32::from(INTERRUPTED));
        }
        // Once it is cancelled the program may end before anything more is said.
        tell("stopping; Ctrl-C once more stops at once\n");
        handle.cancel();
    };
    if let Err(error) = ctrlc::set_handler(interrupted) {
        // An interrupt then ends the program as it does by default.
        tracing::debug!("Ctrl-C is not caught: {error}");
    }
    cancel
}

/// Says it on standard error. If that is full or closed there is nobody to tell, and the exit status has to do.
pub fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Standard error for whoever must not fail because of it.
pub struct Diagnostics;

impl Write for Diagnostics {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        let _ = io::stderr().write_all(text);
        Ok(text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl From<CaseError> for Stop {
    fn from(error: CaseError) -> Self {
        Self::Input(error)
    }
}

impl From<StudyError> for Stop {
    fn from(error: StudyError) -> Self {
        match error {
            StudyError::Case(error) => Self::Input(error),
            StudyError::Keep(error) => Self::Write("the journal".into(), error),
            StudyError::Cancelled => Self::Cancelled,
            other => Self::Usage(other.to_string()),
        }
    }
}

/// What the solver met, for whoever asks with `-v`.
pub fn solver_words(failure: &Failure) {
    if let Some(words) = failure.solver() {
        tracing::info!("the solver says: {words}");
    }
}

impl From<&Failure> for Stop {
    fn from(failure: &Failure) -> Self {
        solver_words(failure);
        if failure.is_cancelled() {
            Self::Cancelled
        } else if failure.is_bad_input() {
            Self::Usage(failure.to_string())
        } else {
            Self::NoSolution(failure.to_string())
        }
    }
}

impl From<InternalError> for Stop {
    fn from(error: InternalError) -> Self {
        Self::NoSolution(error.to_string())
    }
}

impl From<PlotError> for Stop {
    fn from(error: PlotError) -> Self {
        Self::Write(format!("figure `{}`", error.figure), io::Error::other(error.reason))
    }
}
