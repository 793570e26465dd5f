//! A case as the text of a case file.

use std::fmt::Write;

use super::given::{Case, SWAP, Value};
use super::keys::{Entry, Key, ValueKind};
use crate::quantity;
use crate::text::unquoted;

/// Characters of a quantity that is kept as it was written; no TOML string needs to escape them.
fn is_plain(text: &str) -> bool {
    text.chars().all(|c| c.is_alphanumeric() || " .,+-*/^·²³°%µ_".contains(c))
}

impl Case {
    /// The text of a case file that says the same: what was given, by sections, in the order of the table. A quantity
    /// stands there as it was written, or in the unit of its key, or in SI: in the first of these that reads as exactly
    /// the same number.
    ///
    /// ```
    /// # use sheave::case::Case;
    /// let case = Case::base().with("drive.ratio", "1.2")?.with("operating_point.slack_tension", "120 N")?;
    /// let text = case.to_toml();
    /// assert_eq!(text, "[drive]\nratio = 1.2\n\n[operating_point]\nslack_tension = \"120 N\"\n");
    /// assert!(Case::from_toml("again", &text)?.settings().eq(case.settings()));
    /// # Ok::<(), sheave::case::CaseError>(())
    /// ```
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        if !self.swaps.is_empty() {
            // Writing to a string cannot fail.
            let swaps: Vec<String> = self.swaps.iter().map(|(exchange, _)| format!("\"{exchange}\"")).collect();
            let _ = writeln!(text, "{SWAP} = [{}]", swaps.join(", "));
        }
        let mut section = "";
        for key in self.keys() {
            let entry = key.entry();
            if entry.section() != section {
                section = entry.section();
                let _ = writeln!(text, "{}[{section}]", if text.is_empty() { "" } else { "\n" });
            }
            let _ = writeln!(text, "{} = {}", entry.name(), self.value_text(key));
        }
        text
    }

    /// The keys of one section as the text of a part in a file of its own, which a case names under that section with
    /// `file`.
    pub fn part_toml(&self, section: &str) -> String {
        let keys = self.keys().filter(|key| key.entry().section() == section);
        keys.map(|key| format!("{} = {}\n", key.entry().name(), self.value_text(key))).collect()
    }

    fn value_text(&self, key: Key) -> String {
        let Some(given) = self.given(key) else { return String::new() };
        match &given.value {
            Value::Choice(name) => format!("\"{name}\""),
            Value::Table(grid) => grid.to_string(),
            Value::List(values) => {
                let written = unquoted(given.place.given().trim());
                if is_plain(written) && reads_as_list(key, written).as_ref() == Some(values) {
                    return format!("\"{written}\"");
                }
                let texts: Vec<String> = values.iter().map(|si| format!("\"{}\"", in_si(key.entry(), *si))).collect();
                format!("[{}]", texts.join(", "))
            }
            &Value::Quantity(si) => {
                let written = unquoted(given.place.given().trim()).to_owned();
                let candidates = [written, in_unit(key.entry(), si)];
                let kept = candidates.into_iter().find(|text| is_plain(text) && reads_as(key, text) == Some(si));
                match kept {
                    // A plain decimal is a number of the file's own.
                    Some(text) if is_decimal(&text) => text,
                    Some(text) => format!("\"{text}\""),
                    None => format!("\"{}\"", in_si(key.entry(), si)),
                }
            }
        }
    }
}

/// Whether TOML reads the text as a number, to the same bits.
fn is_decimal(text: &str) -> bool {
    let digits = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let leading = |whole: &str| whole == "0" || !whole.starts_with('0');
    unsigned.split_once('.').is_some_and(|(whole, part)| digits(whole) && digits(part) && leading(whole))
}

fn in_unit(entry: &Entry, si: f64) -> String {
    match entry.kind {
        ValueKind::Quantity { unit, .. } => format!("{} {}", unit.from_si(si), unit.symbol).trim_end().to_owned(),
        ValueKind::List { .. } | ValueKind::Choice { .. } => String::new(),
    }
}

/// In SI; a speed in words, as a bare one that is surely in rpm is refused.
fn in_si(entry: &Entry, si: f64) -> String {
    match entry.kind {
        ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. }
            if unit.scale.dimension == quantity::Dimension::ANGULAR_SPEED =>
        {
            format!("{si:e} rad/s")
        }
        _ => format!("{si:e}"),
    }
}

/// What a text gives a key, SI.
fn reads_as(key: Key, text: &str) -> Option<f64> {
    let mut case = Case::base();
    case.set(key.path(), text).ok()?;
    case.quantity(key)
}

/// What a text gives a key with a list, SI.
fn reads_as_list(key: Key, text: &str) -> Option<Vec<f64>> {
    let mut case = Case::base();
    case.set(key.path(), text).ok()?;
    case.list(key).map(<[f64]>::to_vec)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_survives() {
        let numbers = [0.1, 1.0 / 3.0, 0.0123456789012345, 7.0];
        for number in numbers {
            let mut case = Case::base();
            for entry in &super::super::keys::TABLE {
                let _ = match entry.kind {
                    ValueKind::Quantity { .. } => case.set_si(entry.key, number),
                    ValueKind::List { .. } => case.set_list(entry.key, &[number, 2.0 * number]),
                    ValueKind::Choice { choices, .. } => case.set(entry.path, choices[0].name),
                };
            }
            let again = Case::from_toml("again", &case.to_toml()).expect("the text is a case");
            assert!(again.settings().eq(case.settings()), "{}", case.to_toml());
        }
    }

    #[test]
    fn what_was_written_is_kept_and_nothing_else_gets_in() {
        let text = "edition = \"thesis\"\n[belt]\nlength = '33.75 in'\n[drive]\nratio = 1.20\n";
        let case = Case::from_toml("a", text).expect("a case");
        let kept = "edition = \"thesis\"\n\n[belt]\nlength = \"33.75 in\"\n\n[drive]\nratio = 1.20\n";
        assert_eq!(case.to_toml(), kept);
        let escaped = Case::from_toml("a", "[belt]\nlength = \"\\u0038 m\"\n").expect("a case");
        assert_eq!(escaped.to_toml(), "[belt]\nlength = \"8000 mm\"\n");
        let table = "[belt]\nbending_stiffness = { temperature = [300, 340], value = [0.3, 0.2] }\n";
        let case = Case::from_toml("a", table).expect("a case");
        assert!(Case::from_toml("b", &case.to_toml()).expect("a case").settings().eq(case.settings()));
        let swap = Case::from_toml("a", "swap = [\"belt.bending_stiffness for efficiency.overall = 0.96\"]");
        let swap = swap.expect("a case").to_toml();
        assert_eq!(Case::from_toml("b", &swap).expect("a case").to_toml(), swap);
    }
}
