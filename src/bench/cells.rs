//! Cells of a line of a table, separated by commas; what stands in quotes may have commas of its own (RFC 4180).

use crate::bench::error::{BenchError, BenchProblem};
use crate::quantity::{Quantity, parse};
use std::borrow::Cow;

/// The cells of a line as they stand there, quotes and all. Where a quote is not closed, none counts.
pub fn split(line: &str) -> impl Iterator<Item = &str> {
    let quotes = line.bytes().filter(|byte| *byte == b'"').count();
    let counts = quotes > 0 && quotes.is_multiple_of(2);
    let mut rest = Some(line);
    std::iter::from_fn(move || {
        let text = rest?;
        let mut inside = false;
        let ends = |byte: u8| {
            inside ^= byte == b'"';
            byte == b',' && !inside
        };
        // Logs have millions of rows, and hardly any has a quote.
        let end = if counts { text.bytes().position(ends) } else { text.find(',') };
        rest = end.and_then(|end| text.get(end + 1..));
        text.get(..end.unwrap_or(text.len()))
    })
}

/// The text of a cell: without the blanks around it, and without its quotes.
pub fn text(cell: &str) -> Cow<'_, str> {
    let cell = cell.trim();
    match cell.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inside) if inside.contains('"') => Cow::Owned(inside.replace("\"\"", "\"")),
        Some(inside) => Cow::Borrowed(inside),
        None => Cow::Borrowed(cell),
    }
}

/// What keeps the first line of a file from being read as that of a table, if anything does: how some programs for
/// spreadsheets save theirs. Without it every line would be told to be no text, or all of them to be one.
pub fn encoding_fault(first_line: &[u8]) -> Option<&'static str> {
    if first_line.starts_with(&[0xff, 0xfe]) || first_line.starts_with(&[0xfe, 0xff]) {
        Some("it is written in UTF-16: save it as text in UTF-8")
    } else if first_line.trim_ascii_end().contains(&b'\r') {
        Some("its lines end in carriage returns alone: save it with line feeds, as CSV for Windows or Unix")
    } else {
        None
    }
}

/// Refuses a table that [`encoding_fault`] speaks against.
pub fn check_encoding(name: &str, bytes: &[u8]) -> Result<(), BenchError> {
    match bytes.split(|byte| *byte == b'\n').next().and_then(encoding_fault) {
        Some(fault) => Err(BenchProblem::Line { path: name.into(), line: 1, reason: fault.into() }.into()),
        None => Ok(()),
    }
}

/// What is said of a header that is one cell because its columns are separated by something else than commas.
pub fn separator_fault<T: AsRef<str>>(cells: &[T]) -> Option<&'static str> {
    let [alone] = cells else { return None };
    alone
        .as_ref()
        .contains([';', '\t'])
        .then_some("its first line has no commas: expected columns with commas between, and decimal points")
}

/// A unit as headers have it, in capitals and small letters alike, as a quantity of one; `None` for what is none.
pub fn unit(text: &str) -> Option<Quantity> {
    let read = |text: &str| parse(&format!("1 {text}")).ok().filter(|quantity| !quantity.bare);
    let alike =
        ["hp", "kW", "W", "PS", "Nm", "N*m", "N·m", "N m"].into_iter().find(|known| known.eq_ignore_ascii_case(text));
    alike.and_then(read).or_else(|| read(text)).or_else(|| read(&text.to_ascii_lowercase()))
}

/// The texts of all cells of a line.
pub fn texts(line: &str) -> Vec<Cow<'_, str>> {
    split(line).map(text).collect()
}

/// How many cells there are to the last that is not empty; spreadsheets write empty ones at the end.
pub fn filled<T: AsRef<str>>(cells: &[T]) -> Option<usize> {
    Some(cells.iter().rposition(|cell| !cell.as_ref().is_empty())? + 1)
}

/// A text as a cell, on one line.
pub fn cell(text: &str) -> String {
    let text = text.replace(['\n', '\r'], "_");
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_other_encodings_are_told_from_tables() {
        let utf16: Vec<u8> = "\u{feff}rpm,torque\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert!(encoding_fault(&utf16).is_some_and(|fault| fault.contains("UTF-16")));
        assert!(encoding_fault(b"rpm,torque\r1000,20\r").is_some_and(|fault| fault.contains("carriage returns")));
        for sound in ["rpm,torque\r", "\u{feff}rpm,torque", "", "\r"] {
            assert_eq!(encoding_fault(sound.as_bytes()), None, "{sound:?}");
        }
    }

    #[test]
    fn quotes_keep_commas_and_are_taken_off() {
        assert_eq!(texts("a, b ,\"c, d\",\"e \"\"f\"\", g\","), ["a", "b", "c, d", "e \"f\", g", ""]);
        // A quote that is not closed is a letter as any other.
        assert_eq!(texts("5\" pulley,3,4"), ["5\" pulley", "3", "4"]);
        let header = "\"Interval\"|\"ms\"|0|0|1,\"Speed, wheel\"|\"rpm\"|0|8000|50";
        assert_eq!(split(header).nth(1), Some("\"Speed, wheel\"|\"rpm\"|0|8000|50"));
        for name in ["plain", "a, b", "the \"best\", so far"] {
            assert_eq!(texts(&cell(name)), [name]);
        }
    }
}
