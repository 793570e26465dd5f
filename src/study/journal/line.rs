//! The lines of a journal: each carries a checksum of what it says, so that a damaged one is known as such.

use super::super::row::{Cell, Columns};
use serde_json::Value;

/// What the first line begins with; a file that begins otherwise is no journal.
pub(super) const MAGIC: &str = "sheave-sweep-journal 2 ";
/// Hexadecimal digits of a checksum.
const DIGITS: usize = 8;

/// A line that was read.
pub(super) enum Line {
    /// Names of columns, and the number by which rows refer to them.
    Columns(usize, Columns),
    /// A point's index, the number of its columns' names, and its cells.
    Row(usize, usize, Vec<Cell>),
}

/// The first line, for a study that `fingerprint` stands for.
pub(super) fn header(fingerprint: &str) -> String {
    format!("{MAGIC}{}", sealed(fingerprint))
}

/// The fingerprint in a first line without its line feed; nothing if it is damaged.
pub(super) fn fingerprint(line: &[u8]) -> Option<&str> {
    unsealed(line.strip_prefix(MAGIC.as_bytes())?)
}

/// A line about names of columns.
pub(super) fn columns(number: usize, names: &Columns) -> String {
    sealed(&serde_json::json!({ "set": number, "columns": names }).to_string())
}

/// A line about a row.
pub(super) fn row(index: usize, columns: usize, cells: &[Cell]) -> String {
    let cells: Vec<Value> = cells.iter().map(Cell::to_json).collect();
    sealed(&serde_json::json!([index, columns, cells]).to_string())
}

/// Reads a line without its line feed; nothing if it is damaged.
pub(super) fn read(line: &[u8]) -> Option<Line> {
    match serde_json::from_str(unsealed(line)?).ok()? {
        Value::Object(mut members) => {
            let Value::Array(names) = members.remove("columns")? else { return None };
            let number = usize::try_from(members.get("set")?.as_u64()?).ok()?;
            let name = |name: Value| name.as_str().map(str::to_owned);
            Some(Line::Columns(number, names.into_iter().map(name).collect::<Option<Columns>>()?))
        }
        Value::Array(parts) => {
            let [index, columns, Value::Array(cells)] = <[Value; 3]>::try_from(parts).ok()? else { return None };
            let number = |value: &Value| usize::try_from(value.as_u64()?).ok();
            let cells = cells.into_iter().map(Cell::from_json).collect::<Option<Vec<Cell>>>()?;
            Some(Line::Row(number(&index)?, number(&columns)?, cells))
        }
        _ => None,
    }
}

/// The cells in a row's line, and the number of its set of names.
pub(in crate::study) fn read_row(content: &[u8]) -> Option<(usize, Vec<Cell>)> {
    match read(content)? {
        Line::Row(_, layout, cells) => Some((layout, cells)),
        Line::Columns(..) => None,
    }
}

/// A text behind its checksum (CRC-32 of IEEE 802.3), with a line feed.
fn sealed(text: &str) -> String {
    format!("{:08x} {text}\n", crc32fast::hash(text.as_bytes()))
}

/// The text behind a checksum that is right.
fn unsealed(line: &[u8]) -> Option<&str> {
    let (checksum, rest) = line.split_at_checked(DIGITS)?;
    let text = rest.strip_prefix(b" ")?;
    let given = u32::from_str_radix(std::str::from_utf8(checksum).ok()?, 16).ok()?;
    (given == crc32fast::hash(text)).then(|| std::str::from_utf8(text).ok()).flatten()
}
