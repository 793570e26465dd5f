//! The calibration of the torque sensor: ADC = m T + b (9.1).

use crate::bench::cells;
use crate::bench::error::{BenchError, BenchProblem};
use crate::bench::statistics::Line;
use std::path::Path;

/// Rows that a calibration may have.
const ROWS: usize = 10_000_000;

/// Reads a calibration: rows of torque in N·m and ADC, which are fitted (a header such as `torque,adc` may stand in
/// front), or rows of slope, intercept and R² as the test stand keeps them, of which the last applies.
///
/// # Errors
/// A file that cannot be read; rows that are neither, or of which the header or R² says so; a line that does not rise.
pub fn read(path: &Path) -> Result<Line, BenchError> {
    let bytes = std::fs::read(path).map_err(|error| BenchError::read(path, &error))?;
    parse(&path.display().to_string(), &bytes)
}

/// As [`read`], from the bytes of a file.
///
/// # Errors
/// As [`read`].
pub fn parse(name: &str, bytes: &[u8]) -> Result<Line, BenchError> {
    cells::check_encoding(name, bytes)?;
    let (mut points, mut stored, mut measured, mut headed) = (Vec::new(), None, false, false);
    for (line, text) in (1_u64..).zip(bytes.split(|byte| *byte == b'\n')) {
        let bad =
            |reason: &str| BenchError::from(BenchProblem::Line { path: name.into(), line, reason: reason.into() });
        let text = std::str::from_utf8(text).map_err(|_| bad("this is no text"))?;
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let cells = cells::texts(text);
        let numbers: Vec<Option<f64>> =
            cells.iter().map(|cell| cell.parse::<f64>().ok().filter(|value| value.is_finite())).collect();
        match numbers.as_slice() {
            [Some(torque), Some(adc)] if stored.is_none() && points.len() < ROWS => points.push((*torque, *adc)),
            [Some(_), Some(_), Some(_)] if measured => {
                return Err(bad(
                    "there are three numbers below a header of torque and ADC: expected these two columns",
                ));
            }
            [Some(_), Some(_), Some(r_squared)] if !(0.0..=1.0).contains(r_squared) => {
                return Err(bad(&format!(
                    "three numbers are slope, intercept and R², and {r_squared} is no R²: expected one from 0 to 1; \
                     rows of torque and ADC have two columns"
                )));
            }
            [Some(slope), Some(intercept), Some(r_squared)] if points.is_empty() => {
                stored = Some(Line::given(*slope, *intercept, *r_squared));
            }
            // A header.
            _ if points.is_empty() && stored.is_none() && !headed && numbers.iter().all(Option::is_none) => {
                headed = true;
                measured |= cells.iter().any(|cell| cell.eq_ignore_ascii_case("adc"));
            }
            _ => {
                return Err(bad(
                    "expected torque and ADC, or slope, intercept and R², as numbers in every row, with commas between \
                     and decimal points",
                ));
            }
        }
    }
    let line = match stored {
        Some(line) => line,
        None => Line::fit(name, &points)?,
    };
    if line.slope == 0.0 {
        let reason = "the slope is zero: the sensor does not answer to torque".into();
        return Err(BenchProblem::Unusable { path: name.into(), reason }.into());
    }
    Ok(line)
}
