//! Tables of two measured columns, such as those of a testing machine.

use crate::bench::cells;
use crate::bench::error::{BenchError, BenchProblem};
use crate::quantity::{self, Dimension};
use std::path::Path;

/// Rows that a table may have.
const ROWS: usize = 10_000_000;

/// A table as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Rows in SI.
    pub rows: Vec<(f64, f64)>,
    /// Rows that could not be read, and the number of the first line of them.
    pub bad: Option<(usize, u64)>,
}

/// Reads two columns with a header that names units (`mm,N` or `extension (mm),load (N)`), into SI.
///
/// # Errors
/// A file that cannot be read, a header without units of these dimensions, no row that can be read.
pub fn read(path: &Path, dimensions: [Dimension; 2]) -> Result<Columns, BenchError> {
    let name = path.display().to_string();
    let text = std::fs::read(path).map_err(|error| BenchError::read(path, &error))?;
    parse(&name, &text, dimensions)
}

/// As `read`, from the bytes of a file.
///
/// # Errors
/// A header without units of these dimensions, no row that can be read.
pub fn parse(name: &str, bytes: &[u8], dimensions: [Dimension; 2]) -> Result<Columns, BenchError> {
    // Lines may end as they like here: the first two bytes tell the encoding.
    cells::check_encoding(name, bytes.get(..2).unwrap_or_default())?;
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).comment(Some(b'#')).from_reader(bytes);
    let (mut units, mut rows, mut bad) = (None, Vec::new(), None);
    let mut record = csv::ByteRecord::new();
    let (mut line, mut width) = (0_u64, 0);
    while reader.read_byte_record(&mut record).map_err(|error| unreadable(name, &error))? {
        if line.is_multiple_of(4096) && crate::cancel::is_cancelled() {
            return Err(BenchProblem::Cancelled.into());
        }
        line = record.position().map_or(line + 1, csv::Position::line);
        let cell = |at: usize| record.get(at).and_then(|cell| std::str::from_utf8(cell).ok()).map(str::trim);
        let Some(scales) = units else {
            units = Some(header(name, line, [cell(0), cell(1)], dimensions)?);
            width = record.len();
            continue;
        };
        // A row with decimal commas has more cells than the header, and none of them is what it seems.
        let wide = record.iter().skip(width).any(|cell| !cell.trim_ascii().is_empty());
        let number = |at: usize, scale: f64| {
            cell(at)
                .and_then(|cell| cell.parse::<f64>().ok())
                .filter(|value| value.is_finite())
                .map(|value| value * scale)
        };
        let [first, second]: [f64; 2] = scales;
        match (number(0, first), number(1, second)) {
            (Some(x), Some(y)) if rows.len() < ROWS && !wide => rows.push((x, y)),
            _ => {
                let (count, at) = bad.unwrap_or((0, line));
                bad = Some((count + 1, at));
            }
        }
    }
    if rows.is_empty() {
        let reason = "no row has two numbers, with decimal points, below a header with units such as `mm,N`".into();
        return Err(BenchProblem::NoData { path: name.into(), reason }.into());
    }
    Ok(Columns { rows, bad })
}

fn unreadable(name: &str, error: &csv::Error) -> BenchError {
    BenchProblem::Read { path: name.into(), reason: error.to_string() }.into()
}

/// How many SI units the units of a header are.
fn header(name: &str, line: u64, cells: [Option<&str>; 2], dimensions: [Dimension; 2]) -> Result<[f64; 2], BenchError> {
    let scale = |cell: Option<&str>, dimension: Dimension| {
        let cell = cell?.trim_start_matches('\u{feff}');
        let inside = |open: char, close: char| cell.rsplit_once(open)?.1.strip_suffix(close);
        let unit = inside('(', ')').or_else(|| inside('[', ']')).unwrap_or(cell);
        quantity::parse(&format!("1 {}", unit.trim())).ok()?.expect(dimension).ok()
    };
    match (scale(cells[0], dimensions[0]), scale(cells[1], dimensions[1])) {
        (Some(first), Some(second)) => Ok([first, second]),
        _ => {
            let reason = format!(
                "expected a header with the units of {} and {}, such as `mm,N` or `extension (mm),load (N)`",
                dimensions[0], dimensions[1]
            );
            Err(BenchProblem::Line { path: name.into(), line, reason }.into())
        }
    }
}
