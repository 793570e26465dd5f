//! The box of parts: kinds, each with the parts among which one is chosen.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::error::{PartsProblem, TuneError};
use crate::case::{Case, Key, is_section};

/// Combinations at most.
pub const MAX_CANDIDATES: usize = 1_000_000;

/// Sections of a case whose keys parts set: neither the belt's map nor the ends of the shift depend on these.
const SECTIONS: [&str; 4] = ["primary.actuator", "primary.spring", "secondary.actuator", "secondary.spring"];

/// A box of parts.
#[derive(Debug, Clone, PartialEq)]
pub struct PartsBox {
    /// Kinds, in the order of their names.
    pub kinds: Vec<PartKind>,
}

/// A kind of part: flyweights, springs, helices.
#[derive(Debug, Clone, PartialEq)]
pub struct PartKind {
    /// Its name.
    pub name: String,
    /// The parts among which one is chosen.
    pub parts: Vec<Part>,
}

/// One part.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Keys of the case that it sets, with their values as in a case file.
    pub settings: Vec<(String, String)>,
}

impl PartsBox {
    /// Reads a file of parts: a table for each kind, in it a table for each part with the keys of the case that it
    /// sets, or one key with a list of values.
    ///
    /// # Errors
    /// [`TuneError::Parts`] says what is wrong, and where.
    pub fn read(path: &Path) -> Result<Self, TuneError> {
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path)
            .map_err(|error| TuneError::Parts { path: name.clone(), reason: error.to_string() })?;
        Self::from_toml(&name, &text)
    }

    /// As [`PartsBox::read`], from the text of a file.
    ///
    /// # Errors
    /// As [`PartsBox::read`].
    pub fn from_toml(path: &str, text: &str) -> Result<Self, TuneError> {
        let wrong = |reason: String| TuneError::Parts { path: path.to_owned(), reason };
        let file: toml::Table = text.parse().map_err(|error: toml::de::Error| wrong(error.to_string()))?;
        let mut kinds = Vec::new();
        for (name, content) in file {
            let toml::Value::Table(content) = content else {
                return Err(wrong(format!("`{name}`: expected a table of parts, such as [{name}]")));
            };
            kinds.push(kind(name, content).map_err(wrong)?);
        }
        let all = kinds.iter().try_fold(1_usize, |all, kind| all.checked_mul(kind.parts.len()));
        let parts = match all {
            _ if kinds.is_empty() => return Err(wrong("there are no parts in it".into())),
            Some(1..=MAX_CANDIDATES) => Self { kinds },
            _ => return Err(wrong(format!("there are more than {MAX_CANDIDATES} combinations, or none"))),
        };
        parts.check().map_err(|problem| wrong(problem.to_string()))?;
        Ok(parts)
    }

    /// Whether every key is one that parts may set, set by one kind alone, and every value one that its key takes.
    ///
    /// # Errors
    /// See [`PartsProblem`].
    pub fn check(&self) -> Result<(), PartsProblem> {
        let mut set: BTreeMap<Key, &str> = BTreeMap::new();
        let mut scratch = Case::base();
        for kind in &self.kinds {
            for (path, value) in kind.parts.iter().flat_map(|part| &part.settings) {
                let wrong = |error| PartsProblem::Value { kind: kind.name.clone(), error };
                if let Some(key) = Key::from_path(path) {
                    if !SECTIONS.contains(&key.entry().section()) {
                        return Err(PartsProblem::Shared { kind: kind.name.clone(), key });
                    }
                    let first = *set.entry(key).or_insert(&kind.name);
                    if first != kind.name {
                        let (first, second) = (first.to_owned(), kind.name.clone());
                        return Err(PartsProblem::Twice { key, first, second });
                    }
                }
                scratch.set_from("part", path, value).map_err(wrong)?;
            }
        }
        Ok(())
    }

    /// Number of combinations.
    pub fn candidates(&self) -> usize {
        self.kinds.iter().map(|kind| kind.parts.len()).product()
    }

    /// The parts of a combination, one of each kind, counted with the last kind fastest; kinds and parts stand
    /// in the order of their names.
    pub fn parts(&self, candidate: usize) -> Vec<&Part> {
        let mut rest = candidate;
        let mut parts: Vec<&Part> = Vec::with_capacity(self.kinds.len());
        for kind in self.kinds.iter().rev() {
            parts.extend(kind.parts.get(rest % kind.parts.len().max(1)));
            rest /= kind.parts.len().max(1);
        }
        parts.reverse();
        parts
    }

    /// A case with the parts of a combination in it.
    ///
    /// # Errors
    /// What the case says of a key or its value.
    pub fn case(&self, base: &Case, candidate: usize) -> Result<Case, crate::case::CaseError> {
        let mut case = base.clone();
        for (key, value) in self.parts(candidate).into_iter().flat_map(|part| &part.settings) {
            case.set_from("part", key, value)?;
        }
        Ok(case)
    }
}

/// The parts of a kind.
fn kind(name: String, content: toml::Table) -> Result<PartKind, String> {
    let mut parts = Vec::new();
    for (entry, value) in content {
        let toml::Value::Table(table) = value else {
            // A key that is not named in full looks like a part.
            let near = if value.is_array() { Key::suggestion(&entry) } else { String::new() };
            return Err(format!(
                "`{name}.{entry}`: expected the keys that the part sets, in braces, or a key of a case with a list of \
                 values{near}"
            ));
        };
        let mut leaves = Vec::new();
        if is_section(&entry) {
            // One key with a list of its values.
            leaves_of(&entry, table, &mut leaves);
            let [(path, toml::Value::Array(values))] = leaves.as_slice() else {
                return Err(format!("`{name}.{entry}`: expected one key of the case with a list of values"));
            };
            for value in values {
                let text =
                    text(value).ok_or_else(|| format!("`{name}`: a value of `{path}` is neither text nor a number"))?;
                parts.push(Part { name: text.clone(), settings: vec![(path.clone(), text)] });
            }
            continue;
        }
        leaves_of("", table, &mut leaves);
        let settings = leaves.iter().map(|(path, value)| {
            let text = text(value).ok_or_else(|| format!("`{name}.{entry}`: `{path}` is neither text nor a number"))?;
            Ok((path.clone(), text))
        });
        let settings: Vec<(String, String)> = settings.collect::<Result<_, String>>()?;
        let mut seen = BTreeSet::new();
        if let Some((path, _)) = settings.iter().find(|(path, _)| !seen.insert(path)) {
            return Err(format!("`{name}.{entry}` sets `{path}` twice: expected it once"));
        }
        parts.push(Part { settings, name: entry });
    }
    for (path, _) in parts.iter().flat_map(|part| &part.settings) {
        if Key::from_path(path).is_none() {
            return Err(format!("`{name}`: `{path}` is no key of a case{}", Key::suggestion(path)));
        }
    }
    if parts.is_empty() { Err(format!("`{name}` has no parts")) } else { Ok(PartKind { name, parts }) }
}

fn leaves_of(path: &str, table: toml::Table, leaves: &mut Vec<(String, toml::Value)>) {
    for (name, value) in table {
        let path = if path.is_empty() { name } else { format!("{path}.{name}") };
        match value {
            toml::Value::Table(table) => leaves_of(&path, table, leaves),
            value => leaves.push((path, value)),
        }
    }
}

/// A value as a case takes it.
fn text(value: &toml::Value) -> Option<String> {
    match value {
        toml::Value::String(text) => Some(text.clone()),
        toml::Value::Integer(number) => Some(number.to_string()),
        toml::Value::Float(number) => Some(number.to_string()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
        [flyweight]
        "1045" = { primary.actuator.mass = "45 g" }
        "1072" = { primary.actuator.mass = "72 g", primary.actuator.count = 3 }

        [helix]
        secondary.actuator.helix_angle = ["32 deg", "34 deg", "36 deg"]
    "#;

    #[test]
    fn kinds_and_lists_are_read() {
        let parts = PartsBox::from_toml("parts.toml", TEXT).unwrap();
        assert_eq!(parts.candidates(), 6);
        let names = |candidate: usize| parts.parts(candidate).iter().map(|part| part.name.clone()).collect::<Vec<_>>();
        assert_eq!([names(0), names(4)], [["1045", "32 deg"], ["1072", "34 deg"]]);
        let settings = &parts.kinds[0].parts[1].settings;
        assert!(settings.contains(&("primary.actuator.count".into(), "3".into())), "{settings:?}");
        assert!(settings.contains(&("primary.actuator.mass".into(), "72 g".into())), "{settings:?}");
    }

    #[test]
    fn what_is_wrong_is_said() {
        let said = |text: &str| PartsBox::from_toml("parts.toml", text).unwrap_err().to_string();
        assert!(said("").contains("no parts"));
        assert!(said("a = 1").contains("expected a table of parts"));
        assert!(said("[a]").contains("has no parts"));
        assert!(said("[a]\nb = 1").contains("in braces"));
        let shortened = said("[helix]\nhelix_angle = [\"31 deg\"]");
        let reason = "or a key of a case with a list of values; did you mean `secondary.actuator.helix_angle`?";
        assert!(shortened.contains("`helix.helix_angle`") && shortened.contains(reason), "{shortened}");
        assert!(said("[a]\nb = { primary.actuator.mas = \"1 g\" }").contains("primary.actuator.mass"));
        assert!(said("[a]\nsecondary.actuator.helix_angle = \"32 deg\"").contains("a list of values"));
        assert!(said("[a").contains("parts.toml"));
        let twice = "[a]\nb = { primary.actuator.mass = \"1 g\", \"primary.actuator.mass\" = \"2 g\" }";
        assert!(said(twice).contains("`a.b` sets `primary.actuator.mass` twice"), "{}", said(twice));
    }

    /// A part with a value that its key does not take is refused before anything is computed, however many others fit.
    #[test]
    fn values_that_no_part_can_have_are_refused() {
        let said = |text: &str| PartsBox::from_toml("parts.toml", text).unwrap_err().to_string();
        let dimension = said("[a]\nprimary.actuator.mass = [\"1 m\", \"2 g\"]");
        for word in ["parts.toml", "`a`", "`primary.actuator.mass`", "1 m", "expected a mass"] {
            assert!(dimension.contains(word), "{word}: {dimension}");
        }
        let range =
            said("[helix]\nb = { secondary.actuator.helix_angle = \"32 deg\", primary.actuator.mass = \"-1 g\" }");
        assert!(range.contains("`helix`") && range.contains("out of range"), "{range}");
    }

    /// What one map serves, and the ends of the shift, no part may set.
    #[test]
    fn keys_that_parts_do_not_set_are_refused() {
        let shared = [
            ("belt.bending_stiffness", "0.5 N*m^2"),
            ("belt.length", "1 m"),
            ("sheave.friction_coefficient", "0.2"),
            ("drive.center_distance", "250 mm"),
            ("edition", "thesis"),
            ("losses.include", "off"),
            ("operating_point.slack_tension", "100 N"),
            ("engine.throttle", "0.5"),
            ("primary.travel", "20 mm"),
            ("secondary.closed_radius", "80 mm"),
        ];
        for (key, value) in shared {
            let said = PartsBox::from_toml("parts.toml", &format!("[a]\nb = {{ {key} = \"{value}\" }}")).unwrap_err();
            let said = said.to_string();
            assert!(said.contains(&format!("`a` sets `{key}`: expected keys of [primary.actuator]")), "{said}");
        }
        for section in SECTIONS {
            assert!(crate::case::sections().any(|known| known == section), "{section}");
        }
    }

    /// Of two kinds that set one key, the later would take the place of the earlier, whichever part of it is chosen.
    #[test]
    fn a_key_that_two_kinds_set_is_refused() {
        let text = "[a]\nprimary.actuator.mass = [\"1 g\", \"2 g\"]\n[b]\nc = { primary.actuator.mass = \"3 g\" }";
        let said = PartsBox::from_toml("parts.toml", text).unwrap_err().to_string();
        assert!(said.contains("`primary.actuator.mass` is set by two kinds of parts, `a` and `b`"), "{said}");
        // Made by hand, a box is refused as well.
        let kind = |name: &str| PartKind {
            name: name.to_owned(),
            parts: vec![Part { name: "c".into(), settings: vec![("primary.actuator.mass".into(), "1 g".into())] }],
        };
        assert_eq!(PartsBox { kinds: vec![kind("a")] }.check(), Ok(()));
        let twice = PartsBox { kinds: vec![kind("a"), kind("b")] }.check();
        assert!(matches!(twice, Err(PartsProblem::Twice { key: Key::FlyweightMass, .. })), "{twice:?}");
    }
}
