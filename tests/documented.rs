//! Every command that the documentation shows: the subcommand, its options and the keys it sets exist.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::case::Key;
use sheave::small::size;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A command as a page shows it, with the page.
struct Shown {
    page: PathBuf,
    words: Vec<String>,
}

/// The Markdown files that people read: what stands at the top, the book, and the packages' own pages.
fn pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages = Vec::new();
    for folder in [root.to_owned(), root.join("docs"), root.join("docs/rig"), root.join("solver/docs")] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            // What changed in former versions may name what is no longer there.
            if path.extension().is_some_and(|ending| ending == "md") && !path.ends_with("CHANGELOG.md") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    pages
}

/// The words of a line as a shell splits it, without pipes and redirections.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quote, mut begun) = (Vec::new(), String::new(), None, false);
    for c in line.chars().chain([' ']) {
        match (quote, c) {
            (Some(end), c) if c == end => quote = None,
            (Some(_), c) => word.push(c),
            (None, '"' | '\'') => (quote, begun) = (Some(c), true),
            (None, '#' | '|' | '>' | ';' | '&') if word.is_empty() => break,
            (None, c) if c.is_whitespace() => {
                if begun || !word.is_empty() {
                    words.push(std::mem::take(&mut word));
                }
                begun = false;
            }
            (None, c) => word.push(c),
        }
    }
    words
}

/// Lines of code that run the program, continued over line ends.
fn shown() -> Vec<Shown> {
    let mut all = Vec::new();
    for page in pages() {
        let text = std::fs::read_to_string(&page).unwrap().replace("\\\n", " ");
        let mut fenced = false;
        for line in text.lines() {
            if line.trim_start().starts_with("```") {
                fenced = !fenced;
                continue;
            }
            let line = if fenced { line } else { line.strip_prefix("    ").unwrap_or_default() };
            let line = line.trim().trim_start_matches("$ ");
            if line.starts_with("sheave ") {
                all.push(Shown { page: page.clone(), words: words(line) });
            }
        }
    }
    all
}

fn help(arguments: &[&str]) -> Option<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_sheave")).args(arguments).arg("--help").output().unwrap();
    output.status.success().then(|| String::from_utf8(output.stdout).unwrap())
}

/// Options that a help text names: `--set`, `-v`.
fn options(help: &str) -> BTreeSet<String> {
    let ends = |c: char| !(c.is_ascii_alphanumeric() || c == '-');
    help.split(ends).filter(|word| word.starts_with('-') && word.len() > 1).map(str::to_owned).collect()
}

/// Whether a case has the key, or a belt drive to be sized.
fn is_key(path: &str) -> bool {
    let sizes = size::TABLE.iter().map(|entry| entry.path).chain(size::IDLER.iter().map(|entry| entry.path));
    Key::from_path(path).is_some() || sizes.into_iter().any(|other| other == path)
}

/// What is wrong with the keys of an assignment such as `belt.length=850 mm`, or `ratio,speed=1:2,3:4` of a study.
fn unknown_key(assignment: &str) -> Option<String> {
    let (keys, _) = assignment.split_once('=')?;
    keys.split([',', '+']).map(str::trim).find(|key| key.contains('.') && !is_key(key)).map(str::to_owned)
}

#[test]
fn every_command_option_and_key_that_the_documentation_shows_exists() {
    let shown = shown();
    assert!(shown.len() > 40, "only {} commands were found in the documentation", shown.len());
    let mut helps: BTreeMap<Vec<String>, BTreeSet<String>> = BTreeMap::new();
    let mut wrong = Vec::new();
    for Shown { page, words } in &shown {
        let line = words.join(" ");
        let mut fails = |what: String| wrong.push(format!("{}: {what}: {line}", page.display()));
        // A subcommand may have subcommands of its own.
        let names: Vec<String> = words
            .iter()
            .skip(1)
            .take_while(|word| word.chars().all(|c| c.is_ascii_lowercase() || c == '-'))
            .cloned()
            .collect();
        let known = (0..=names.len().min(2)).rev().find_map(|length| {
            let path = names.get(..length)?.to_vec();
            if !helps.contains_key(&path) {
                let arguments: Vec<&str> = path.iter().map(String::as_str).collect();
                helps.insert(path.clone(), options(&help(&arguments)?));
            }
            Some(path)
        });
        let Some(path) =
            known.filter(|path| !path.is_empty() || words.get(1).is_some_and(|word| word.starts_with('-')))
        else {
            fails("no such subcommand".into());
            continue;
        };
        for (at, word) in words.iter().enumerate() {
            let option = word.split_once('=').map_or(word.as_str(), |(option, _)| option);
            let is_option = option.starts_with("--") || (option.len() == 2 && option.starts_with('-'));
            if is_option
                && option != "--"
                && !option[1..].starts_with(|c: char| c.is_ascii_digit())
                && !helps[&path].contains(option)
            {
                fails(format!("`{}` has no option {option}", path.join(" ")));
            }
            if matches!(option, "--set" | "--over") {
                let assignment = word.split_once('=').map(|(_, rest)| rest.to_owned()).filter(|_| option != word);
                let assignment = assignment.or_else(|| words.get(at + 1).cloned()).unwrap_or_default();
                if let Some(key) = unknown_key(&assignment) {
                    fails(format!("there is no key {key}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_not_there_is_noticed() {
    assert_eq!(unknown_key("belt.lenght=1 m").as_deref(), Some("belt.lenght"));
    assert_eq!(unknown_key("belt.length=1 m"), None);
    assert_eq!(
        words("sheave solve --set \"belt.length=1 m\" | jq '.a b' # x"),
        ["sheave", "solve", "--set", "belt.length=1 m"]
    );
    let options = options(&help(&["solve"]).unwrap());
    assert!(options.contains("--set") && !options.contains("--sett"), "{options:?}");
}
