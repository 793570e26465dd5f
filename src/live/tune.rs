//! The search for a tune in a box of parts.

use serde_json::{Value, json};

use super::ask::TuneAsk;
use super::{LONGEST, Refused, read};
use crate::beltmap::{KeepNothing, MapOptions};
use crate::case::Case;
use crate::drive::SolveOptions;
use crate::quantity::{self, Dimension};
use crate::result::{FailureKind, FailureReport};
use crate::tune::{PartsBox, Tune, TuneError, TuneOptions, TunePlan};

/// Tunes that are told; how many of the best are confirmed by full solutions.
const TOLD: usize = 20;
const CONFIRMED: usize = 3;
/// Points of the shift.
const POINTS: usize = 7;
/// Combinations and points of the map at most: what one waits for while looking. Where a map ends for its points, cells
/// beside the slip limit, in which drives run, are left without values, and each point in them takes a full solution.
const MOST: usize = 20_000;
const MAP_POINTS: usize = 2000;
/// Accuracy of the map, and of its solutions.
const ACCURACY: f64 = 5e-2;
const TOLERANCE: f64 = 1e-4;

/// The best combinations of parts, each with its case; or why there is none.
pub(super) fn tune(ask: &TuneAsk) -> Result<Value, Refused> {
    if ask.parts.len() > LONGEST {
        return Err(Refused::TooLong(ask.parts.len()));
    }
    let case = read(&ask.case)?;
    Ok(search(&case, ask).unwrap_or_else(|error| json!({ "failure": report(&error) })))
}

fn search(case: &Case, ask: &TuneAsk) -> Result<Value, TuneError> {
    let wrong = |reason: String| TuneError::Parts { path: "target".to_owned(), reason };
    let target = quantity::parse(&ask.target).and_then(|quantity| quantity.expect(Dimension::ANGULAR_SPEED));
    let target = target.map_err(|error| wrong(format!("{error}; expected a speed such as \"3400 rpm\"")))?;
    let parts = PartsBox::from_toml("parts", &ask.parts)?;
    if parts.candidates() > MOST {
        let reason = format!("{} combinations: `sheave tune` searches more than {MOST}", parts.candidates());
        return Err(TuneError::Parts { path: "parts".to_owned(), reason });
    }
    let options = TuneOptions { points: POINTS, confirmed: CONFIRMED, ..TuneOptions::new(target) };
    let plan = TunePlan::new(case.clone(), parts, options)?;
    let solve = SolveOptions { tolerance: TOLERANCE, uncertainty: false, ..SolveOptions::default() };
    let options = MapOptions { accuracy: ACCURACY, solve, max_points: MAP_POINTS, ..MapOptions::default() };
    let map = plan.map(options)?.build(&KeepNothing)?;
    let ranking = plan.search(&map, &|| ())?;
    let told = |tune: &Tune| -> Result<Value, TuneError> {
        let mut told = json!(tune);
        told["case"] = plan.parts().case(case, tune.candidate)?.to_toml().into();
        Ok(told)
    };
    Ok(json!({
        "target": ranking.target,
        "candidates": ranking.candidates,
        "shifting": ranking.tunes.len(),
        "refused": ranking.refused,
        "map_error": map.report().error.largest,
        "tunes": ranking.tunes.iter().take(TOLD).map(told).collect::<Result<Vec<_>, _>>()?,
    }))
}

fn report(error: &TuneError) -> FailureReport {
    let kind = match error {
        TuneError::Map(_) | TuneError::Threads(_) => FailureKind::NoSolution,
        _ => FailureKind::Input,
    };
    FailureReport { kind, message: error.to_string(), hint: None }
}
