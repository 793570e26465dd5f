//! Why a command ends without a result, and what the exit status says of it.

use sheave::case::CaseError;
use sheave::plot::PlotError;
use sheave::study::StudyError;
use std::io;
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
    /// A file, or standard output, could not be written.
    Write(String, io::Error),
}

impl Stop {
    /// Tells people on standard error, and everyone by the exit status.
    pub fn report(self) -> ExitCode {
        match self {
            Self::Input(error) => {
                eprint!("{:?}", miette::Report::new(error));
                ExitCode::from(2)
            }
            Self::Refused(report) => {
                eprint!("{report:?}");
                ExitCode::from(2)
            }
            Self::Usage(reason) => {
                eprintln!("{reason}");
                ExitCode::from(2)
            }
            Self::NoSolution(reason) => {
                eprintln!("{reason}");
                ExitCode::from(3)
            }
            // Whoever reads has enough: nobody to tell.
            Self::Write(_, error) if error.kind() == io::ErrorKind::BrokenPipe => ExitCode::from(1),
            Self::Write(what, error) => {
                eprintln!("cannot write {what}: {error}");
                ExitCode::from(1)
            }
        }
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
            other => Self::Usage(other.to_string()),
        }
    }
}

impl From<PlotError> for Stop {
    fn from(error: PlotError) -> Self {
        Self::Write(format!("figure `{}`", error.figure), io::Error::other(error.reason))
    }
}
