//! Reading a case file, with the files of parts that it names.

use super::error::{CaseError, CaseProblem};
use super::given::{Case, SWAP};
use super::keys::is_section;
use super::place::{Place, Source};
use super::raw::{in_order, kind, raw};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The key of a section under which a file with that section's keys is named.
const PART: &str = "file";

/// A text that is being read.
struct TextReader<'a> {
    source: &'a Arc<Source>,
    /// Where files of parts are looked for; empty within a part, which names no others.
    folder: &'a Path,
}

impl TextReader<'_> {
    fn place(&self, key: &Spanned<Cow<'_, str>>, value: &Spanned<DeValue<'_>>) -> Place {
        Place { source: self.source.clone(), key: key.span(), value: value.span() }
    }

    fn within_part(&self) -> bool {
        self.folder.as_os_str().is_empty()
    }
}

/// The folder of a file, in which the parts that it names are looked for; the present one for a text without a file.
fn folder_of(name: &str) -> PathBuf {
    let parent = Path::new(name).parent().filter(|parent| !parent.as_os_str().is_empty());
    parent.unwrap_or(Path::new(".")).to_owned()
}

fn syntax(source: &Arc<Source>, error: &toml::de::Error) -> CaseError {
    let span = error.span().unwrap_or(0..0);
    let message = error.message().trim().replace('\n', ", ");
    CaseError::new(CaseProblem::Syntax { message }, [Place { source: source.clone(), key: span.clone(), value: span }])
}

impl Case {
    /// Reads a case file.
    ///
    /// # Errors
    /// [`CaseProblem::Read`] if the file cannot be read, else as [`Case::from_toml`].
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Self::from_toml(&name, &text),
            Err(error) => Err(CaseError::unreadable(&name, &error)),
        }
    }

    /// Reads a case from the text of a case file; `name` is shown in errors.
    ///
    /// # Errors
    /// Everything that is wrong as far as one key alone is concerned, in the order of the text: see [`CaseProblem`] and
    /// [`CaseError::others`].
    pub fn from_toml(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_text(name, text, &folder_of(name))
    }

    /// As [`Case::from_toml`], for a text that is not trusted with this computer's files: it names no parts in files of
    /// their own.
    ///
    /// # Errors
    /// As [`Case::from_toml`]; [`CaseProblem::UnknownKey`] for a key `file`.
    pub fn from_toml_alone(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::from_text(name, text, Path::new(""))
    }

    fn from_text(name: &str, text: &str, folder: &Path) -> Result<Self, CaseError> {
        let mut case = Self::base();
        // What some editors put at the front of a file.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let source = Arc::new(Source::new(name, text));
        let table = DeTable::parse(text).map_err(|error| syntax(&source, &error))?;
        let mut errors = Vec::new();
        let reader = TextReader { source: &source, folder };
        for (key, value) in in_order(table.get_ref()) {
            case.read_top(&reader, key, value, &mut errors);
        }
        CaseError::all(errors).map_or(Ok(case), Err)
    }

    /// A key at the top of a file: `edition`, or a section with its keys.
    fn read_top(
        &mut self,
        reader: &TextReader<'_>,
        key: &Spanned<Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        errors: &mut Vec<CaseError>,
    ) {
        let name = key.get_ref();
        let place = reader.place(key, value);
        if name == SWAP {
            errors.extend(self.read_swaps(reader.source, value, place).err());
            return;
        }
        if !is_section(name) {
            errors.extend(self.insert(name, raw(value.get_ref()), place).err());
            return;
        }
        let DeValue::Table(table) = value.get_ref() else {
            let (path, given) = (name.to_string(), kind(value.get_ref()));
            errors.push(CaseError::new(CaseProblem::Type { path, given, expected: "a table of keys".into() }, [place]));
            return;
        };
        self.read_section(reader, name, table, errors);
    }

    /// The keys of a section, and the sections within it; first those of the part that its key `file` names, so that
    /// what stands in the case itself takes their place.
    fn read_section(
        &mut self,
        reader: &TextReader<'_>,
        section: &str,
        table: &DeTable<'_>,
        errors: &mut Vec<CaseError>,
    ) {
        let entries = in_order(table);
        let is_file = |key: &Spanned<Cow<'_, str>>| key.get_ref() == PART;
        for (key, value) in entries.iter().filter(|(key, _)| is_file(key)) {
            self.read_part(reader, section, key, value, errors);
        }
        for (key, value) in entries.into_iter().filter(|(key, _)| !is_file(key)) {
            let path = format!("{section}.{}", key.get_ref());
            match value.get_ref() {
                DeValue::Table(table) if is_section(&path) => self.read_section(reader, &path, table, errors),
                _ => errors.extend(self.insert_value(&path, value.get_ref(), reader.place(key, value), 0).err()),
            }
        }
    }

    /// A part in a file of its own: the keys of the section that names it.
    fn read_part(
        &mut self,
        reader: &TextReader<'_>,
        section: &str,
        key: &Spanned<Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        errors: &mut Vec<CaseError>,
    ) {
        let place = reader.place(key, value);
        let DeValue::String(file) = value.get_ref() else {
            let (path, given) = (format!("{section}.{PART}"), kind(value.get_ref()));
            let expected = "the name of a file with the keys of this section, such as \"parts/spring.toml\"".to_owned();
            errors.push(CaseError::new(CaseProblem::Type { path, given, expected }, [place]));
            return;
        };
        if reader.within_part() {
            let (path, nearest) = (format!("{section}.{PART}"), None);
            errors.push(CaseError::new(CaseProblem::UnknownKey { path, nearest }, [place]));
            return;
        }
        let path = reader.folder.join(file.as_ref());
        let name = path.display().to_string();
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) => {
                errors.push(CaseError::new(CaseProblem::Read { path: name, reason: error.to_string() }, [place]));
                return;
            }
        };
        let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
        let source = Arc::new(Source::new(name, text));
        match DeTable::parse(text) {
            Ok(table) => {
                let part = TextReader { source: &source, folder: Path::new("") };
                self.read_section(&part, section, table.get_ref(), errors);
            }
            Err(error) => errors.push(syntax(&source, &error)),
        }
    }

    /// The key `swap`: a list of texts.
    fn read_swaps(
        &mut self,
        source: &Arc<Source>,
        value: &Spanned<DeValue<'_>>,
        place: Place,
    ) -> Result<(), CaseError> {
        let wrong = |given, place| {
            let expected = "a list of texts, such as [\"belt.bending_stiffness for efficiency.overall = 0.96\"]".into();
            CaseError::new(CaseProblem::Type { path: SWAP.into(), given, expected }, [place])
        };
        let DeValue::Array(items) = value.get_ref() else { return Err(wrong(kind(value.get_ref()), place)) };
        for item in items.iter() {
            let place = Place { source: source.clone(), key: item.span(), value: item.span() };
            let DeValue::String(text) = item.get_ref() else { return Err(wrong(kind(item.get_ref()), place)) };
            self.add_swap(text, place)?;
        }
        Ok(())
    }
}
