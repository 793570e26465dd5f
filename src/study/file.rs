//! Study files: a case file with a section `[sweep]` that says what is varied.
//!
//! ```toml
//! edition = "published"
//! [sweep]
//! over = ["operating_point.slack_tension = 100..750 N : 14", "drive.ratio = 0.72..1.74 : 13"]
//! ```

use super::axis::Axis;
use super::error::StudyError;
use crate::case::Case;
use serde::Deserialize;
use std::path::Path;

/// What a study file says.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyFile {
    /// The case.
    pub case: Case,
    /// What is varied in it; nothing if the file is a case file.
    pub axes: Vec<Axis>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sections {
    sweep: Section,
}

/// The section `[sweep]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Section {
    over: Vec<String>,
}

impl StudyFile {
    /// Reads a study file, or a case file.
    ///
    /// # Errors
    /// What is wrong with the case or the axes: see [`StudyError`].
    pub fn read(path: &Path) -> Result<Self, StudyError> {
        let Ok(text) = std::fs::read_to_string(path) else {
            // The case says why.
            return Ok(Self { case: Case::read(path)?, axes: Vec::new() });
        };
        Self::from_toml(&path.display().to_string(), &text)
    }

    /// Reads the text of a study file; `name` is shown in errors.
    ///
    /// # Errors
    /// As [`StudyFile::read`].
    pub fn from_toml(name: &str, text: &str) -> Result<Self, StudyError> {
        let (case, sweep) = split(text.strip_prefix('\u{feff}').unwrap_or(text));
        let case = Case::from_toml(name, &case)?;
        if sweep.trim().is_empty() {
            return Ok(Self { case, axes: Vec::new() });
        }
        let sections: Sections = toml::from_str(&sweep).map_err(|error| StudyError::File {
            path: name.into(),
            reason: format!("in [sweep]: {}", error.message().trim()),
        })?;
        let axes = sections.sweep.over.iter().map(|over| Axis::parse(over)).collect::<Result<_, _>>()?;
        Ok(Self { case, axes })
    }
}

/// The text without its section `[sweep]`, and that section alone; lines keep their numbers in both.
fn split(text: &str) -> (String, String) {
    let (mut case, mut sweep) = (String::new(), String::new());
    let mut within = false;
    for line in text.split_inclusive('\n') {
        let header = line.trim_start();
        if within && header.starts_with('[') && !header.starts_with("[\"") && line.starts_with('[') {
            within = false;
        }
        within = within || is_header(line);
        let (to, other) = if within { (&mut sweep, &mut case) } else { (&mut case, &mut sweep) };
        to.push_str(line);
        other.push('\n');
    }
    (case, sweep)
}

/// Whether the line is `[sweep]`.
fn is_header(line: &str) -> bool {
    line.split('#').next().is_some_and(|text| text.trim() == "[sweep]")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Key;

    #[test]
    fn a_study_file_is_a_case_file_with_a_section_more() {
        let text = "edition = \"thesis\"\n[sweep] # what varies\nover = [\n  \"drive.ratio = 0.8..1.2 : \
            3\",\n]\n[belt]\nlength = \"850 mm\"\n";
        let file = StudyFile::from_toml("study.toml", text).unwrap();
        assert_eq!(file.axes.len(), 1);
        assert!(file.case.has(Key::BeltLength) && file.case.has(Key::Edition));
        assert!(StudyFile::from_toml("case.toml", "edition = \"thesis\"").unwrap().axes.is_empty());
    }

    #[test]
    fn mistakes_stand_in_their_line() {
        let error = StudyFile::from_toml("s.toml", "[sweep]\nover = []\n[belt]\nlength = \"3 kg\"\n").unwrap_err();
        let StudyError::Case(error) = error else { panic!("{error}") };
        assert_eq!(error.places()[0].source.text.lines().nth(3), Some("length = \"3 kg\""));
        for text in ["[sweep]\nunder = 3\n", "[sweep]\nover = 3\n", "[sweep]\nover = [\"colour=1,2\"]\n", "[sweep\n"] {
            assert!(StudyFile::from_toml("s.toml", text).is_err(), "{text}");
        }
    }
}
