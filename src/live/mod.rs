//! A drive that is changed while one looks at it: questions and answers as JSON, warm starts kept between them.
//!
//! The page in the browser asks this, compiled to WebAssembly in a worker or behind `sheave live`: both give the same
//! answers to the same questions. [`Live::answer`] takes a text such as
//! `{"ask": "solve", "case": "", "set": [["drive.ratio", "1.2"]], "tolerance": 1e-3}` and returns one JSON object.
//! What is wrong stands in `failure`, as for the command's `--json`; nothing that can be asked panics or runs without a
//! limit.
//!
//! | `ask` | answer |
//! |---|---|
//! | `keys` | every key of a case file: unit, range, default, choices, meaning, and how far a slider goes |
//! | `solve` | the case with what is changed in it, its result, what to draw, or what the belt does instead |
//! | `largest_torque` | the largest torque that the case's clamp carries, or none |
//! | `smallest_clamps` | the smallest clamps that carry the case's torque, or none |
//! | `shift` | the landmarks of a whole drive's shift curve in one direction, and how many points it has |
//! | `shift_next` | its next point, or none; with the last one, what there is to say of all of them |
//! | `tune` | the combinations of a box of parts that hold the engine at a speed best, each with its case |
//! | `profile` | every state and derived field along the belt of the last solution, as CSV |
//!
//! ```
//! let mut live = sheave::live::Live::default();
//! let answer = live.answer(r#"{"ask": "solve", "case": "", "set": [["drive.ratio", "1.2"]], "tolerance": 1e-3}"#);
//! let answer: serde_json::Value = serde_json::from_str(&answer)?;
//! assert!(answer["result"]["primary"]["axial_force"].as_f64().is_some_and(|force| force > 500.0));
//! # Ok::<(), serde_json::Error>(())
//! ```

mod ask;
mod change;
mod follow;
mod keys;
mod limit;
mod scene;
mod shift;
mod tune;
mod values;

use serde::Serialize;
use serde_json::{Value, json};

use crate::case::{Case, CaseError, Resolved};
use crate::drive::Failure;
use crate::model::InternalError;
use crate::result::{FailureKind, FailureReport, Light, Outcome, answers, envelope, warnings, write_profile};
use ask::{Ask, SolveAsk};
use follow::{Follower, Found, Lost};
use scene::{Detail, Scene};

/// Longest case that is read, bytes.
const LONGEST: usize = 1 << 20;

/// What is remembered between questions: the last solutions, from which the next is followed.
#[derive(Debug, Default)]
pub struct Live {
    follower: Follower,
    curves: shift::Curves,
}

/// Why a question has no answer.
enum Refused {
    Case(CaseError),
    Solve(Failure),
    TooLong(usize),
    Internal(String),
}

/// An answer.
#[derive(Debug, Serialize)]
struct Told {
    #[serde(flatten)]
    answer: Value,
    /// What is to be drawn. It is written out as it is: as a `Value` its numbers of single precision would get the
    /// digits of double precision, and three quarters of an answer are such numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<Scene>,
}

impl From<Value> for Told {
    fn from(answer: Value) -> Self {
        Self { answer, scene: None }
    }
}

impl From<CaseError> for Refused {
    fn from(error: CaseError) -> Self {
        Self::Case(error)
    }
}

impl From<Failure> for Refused {
    fn from(failure: Failure) -> Self {
        Self::Solve(failure)
    }
}

impl From<InternalError> for Refused {
    fn from(error: InternalError) -> Self {
        Self::Internal(error.to_string())
    }
}

impl From<serde_json::Error> for Refused {
    fn from(error: serde_json::Error) -> Self {
        Self::Internal(error.to_string())
    }
}

impl Refused {
    fn report(&self) -> FailureReport {
        match self {
            Self::Case(error) => {
                FailureReport { kind: FailureKind::Input, message: error.to_string(), hint: error.hint() }
            }
            Self::Solve(failure) => {
                let kind = if failure.is_bad_input() { FailureKind::Input } else { FailureKind::NoSolution };
                FailureReport { kind, message: failure.to_string(), hint: failure.hint().map(str::to_owned) }
            }
            Self::TooLong(length) => {
                let message = format!("a case of {length} bytes: expected at most {LONGEST}");
                FailureReport { kind: FailureKind::Input, message, hint: None }
            }
            Self::Internal(message) => {
                FailureReport { kind: FailureKind::Internal, message: message.clone(), hint: None }
            }
        }
    }

    fn answer(&self) -> Value {
        json!({ "failure": self.report() })
    }
}

impl Live {
    /// Answers a question. What cannot be answered is answered with a `failure`.
    pub fn answer(&mut self, question: &str) -> String {
        let told = match serde_json::from_str::<Ask>(question) {
            Err(error) => {
                let message = format!("a question that is not understood: {error}");
                Ok(json!({ "failure": FailureReport { kind: FailureKind::Usage, message, hint: None } }).into())
            }
            Ok(ask) => self.asked(ask),
        };
        let text = told.and_then(|told| Ok(serde_json::to_string(&told)?));
        text.unwrap_or_else(|refused| refused.answer().to_string())
    }

    fn asked(&mut self, ask: Ask) -> Result<Told, Refused> {
        let told = match ask {
            Ask::Keys => keys::table(),
            Ask::Solve(ask) => return self.solve(&ask),
            Ask::LargestTorque(ask) => limit::largest_torque(&posed(&read(&ask.case)?)?, &ask.options()),
            Ask::SmallestClamps(ask) => limit::smallest_clamps(&posed(&read(&ask.case)?)?, &ask.options()),
            Ask::Profile => self.profile()?,
            Ask::Shift(ask) => {
                let case = change::changed(&read(&ask.case)?, &ask.set, &ask.unset, None)?;
                // Posed or not: a whole drive finds its own operating point.
                self.curves.begin(&case, &case.resolve()?, &ask)?
            }
            Ask::ShiftNext(ask) => self.curves.next(ask.direction)?,
            Ask::Tune(ask) => tune::tune(&ask)?,
        };
        Ok(told.into())
    }

    fn solve(&mut self, ask: &SolveAsk) -> Result<Told, Refused> {
        let before = read(&ask.case)?;
        let case = change::changed(&before, &ask.set, &ask.unset, self.follower.last())?;
        let resolved = posed(&case)?;
        let options = ask.options();
        if ask.from_nothing {
            self.follower = Follower::default();
        }
        let found = if ask.follow {
            self.follower.follow(&resolved, &options)
        } else {
            self.follower.solve(&resolved, &options)
        };
        let mut answer = json!({
            "case": case.to_toml(),
            "given": case.keys().map(crate::case::Key::path).collect::<Vec<_>>(),
            "remarks": case.remarks(),
            "choices": values::choices(&resolved),
        });
        let drawn = match found {
            Found::Arrived(outcome) => {
                show(&mut answer, &outcome, Some(&resolved))?;
                Some(outcome)
            }
            Found::OnTheWay(outcome) => {
                show(&mut answer, &outcome, None)?;
                answer["values"] = json!(values::asked(&resolved, Some(&outcome.result)));
                answer["on_the_way"] = true.into();
                Some(outcome)
            }
            Found::Lost { failure, last } => {
                answer["values"] = json!(values::asked(&resolved, last.as_deref().map(|last| &last.result)));
                let changed = ask.set.last().map(|(key, _)| key.as_str());
                answer["failure"] = json!(limit::named(&failure, changed, last.as_deref()));
                if let Lost::Ended(cause) = &failure {
                    answer["cause"] = cause.as_str().into();
                }
                if let Some(last) = &last {
                    answer["light"] = json!(light(last));
                }
                last
            }
        };
        let detail = if ask.follow { Detail::Moving } else { Detail::Resting };
        let scene = drawn.filter(|_| ask.scene).map(|outcome| scene::scene(&outcome, detail)).transpose()?;
        Ok(Told { answer, scene })
    }

    fn profile(&self) -> Result<Value, Refused> {
        let mut csv = Vec::new();
        match self.follower.last() {
            None => Ok(json!({ "csv": "" })),
            Some(outcome) => {
                write_profile(outcome, &mut csv).map_err(|error| Refused::Internal(error.to_string()))?;
                Ok(json!({ "csv": String::from_utf8_lossy(&csv) }))
            }
        }
    }
}

/// A case from its text.
fn read(text: &str) -> Result<Case, Refused> {
    if text.len() > LONGEST {
        return Err(Refused::TooLong(text.len()));
    }
    // Whoever wrote it does not get to read files here.
    Ok(Case::from_toml_alone("case", text)?)
}

/// A case, resolved and fit for the solver.
fn posed(case: &Case) -> Result<Resolved, Refused> {
    let resolved = case.resolve()?;
    case.check_posed(&resolved)?;
    Ok(resolved)
}

fn light(outcome: &Outcome) -> &'static str {
    match Light::of_drive(&outcome.result) {
        Light::Green => "green",
        Light::Amber => "amber",
        Light::Red => "red",
    }
}

/// A solution's result, in numbers and in words.
fn show(answer: &mut Value, outcome: &Outcome, asked: Option<&Resolved>) -> Result<(), Refused> {
    let result = &outcome.result;
    answer["result"] = envelope("live", &result.inputs, &warnings(outcome), result)?;
    answer["answers"] = answers(result).iter().map(|each| json!([each.question, each.answer])).collect();
    answer["light"] = json!(light(outcome));
    if let Some(asked) = asked {
        answer["values"] = json!(values::asked(asked, Some(result)));
    }
    Ok(())
}
