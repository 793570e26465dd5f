//! The invariants that ARCHITECTURE.md states, held by `cargo metadata` and by reading the sources.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};
use sheave::model::{Constant, Field, Integral, Output, RegionConstant, State};

/// The four packages of the workspace.
const SHEAVE: &str = "sheave";
const SOLVER: &str = "sheave-solver";
const GENERATED: &str = "sheave-kernels";
const EQGEN: &str = "sheave-eqgen";

fn metadata() -> Metadata {
    MetadataCommand::new().no_deps().other_options(vec!["--offline".to_owned()]).exec().unwrap()
}

/// Direct dependencies of every package of the workspace.
fn dependencies(metadata: &Metadata) -> BTreeMap<String, Vec<(String, DependencyKind)>> {
    let of = |package: &cargo_metadata::Package| {
        package.dependencies.iter().map(|dependency| (dependency.name.clone(), dependency.kind)).collect()
    };
    metadata.packages.iter().map(|package| (package.name.to_string(), of(package))).collect()
}

fn depends(all: &BTreeMap<String, Vec<(String, DependencyKind)>>, package: &str, on: &str) -> bool {
    all[package].iter().any(|(name, _)| name == on)
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ["rs", "md", "toml"].iter().any(|known| ending == *known)) {
            found.push(path);
        }
    }
}

#[test]
fn the_solver_knows_no_equations() {
    let all = dependencies(&metadata());
    for other in [EQGEN, GENERATED, SHEAVE] {
        assert!(!depends(&all, SOLVER, other), "{SOLVER} depends on {other}");
    }
    let mut sources = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join("solver"), &mut sources);
    assert!(sources.len() > 10, "the solver's sources were not found");
    for path in sources {
        // The name under which it is published may be said.
        let text = std::fs::read_to_string(&path).unwrap().to_lowercase().replace(SOLVER, "");
        for word in ["belt", "pulley", "sheave"] {
            assert!(!text.contains(word), "{} speaks of a {word}", path.display());
        }
    }
}

#[test]
fn only_eqgen_depends_on_the_symbolic_engine() {
    for (package, dependencies) in dependencies(&metadata()) {
        let symbolic = dependencies.iter().any(|(name, _)| name == "symbolica" || name == "numerica");
        assert_eq!(symbolic, package == EQGEN, "{package}");
    }
}

#[test]
fn eqgen_is_needed_at_build_time_only() {
    for (package, dependencies) in dependencies(&metadata()) {
        for (name, kind) in dependencies {
            let build = name != EQGEN || kind != DependencyKind::Normal;
            assert!(build, "{package} depends on {EQGEN} at run time");
        }
    }
}

#[test]
fn only_the_drive_joins_equations_and_solver() {
    let all = dependencies(&metadata());
    for package in all.keys() {
        let joins = depends(&all, package, GENERATED) && depends(&all, package, SOLVER);
        assert_eq!(joins, package == SHEAVE, "{package}");
    }
}

/// The code of `src/`, file by file: path within it, and its lines without comments and without tests.
fn code() -> Vec<(String, Vec<String>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut paths = Vec::new();
    files(&root, &mut paths);
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "rs"));
    assert!(paths.len() > 50, "the sources were not found");
    let lines = |path: &PathBuf| {
        let text = std::fs::read_to_string(path).unwrap();
        let name = path.strip_prefix(&root).unwrap().to_str().unwrap().replace('\\', "/");
        let code = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
        let lines = code.lines().filter(|line| !line.trim_start().starts_with("//")).map(str::to_owned);
        (name, lines.collect())
    };
    paths.iter().map(lines).collect()
}

/// The top modules of `src/` and those that each refers to by `crate::`.
fn imports(code: &[(String, Vec<String>)]) -> BTreeMap<String, BTreeSet<String>> {
    let top = |path: &str| path.split('/').next().unwrap_or_default().trim_end_matches(".rs").to_owned();
    let modules: BTreeSet<String> = code.iter().map(|(path, _)| top(path)).collect();
    let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    // `cli` and `main` are the program, not the library.
    for (path, lines) in
        code.iter().filter(|(path, _)| !path.starts_with("cli/") && path != "main.rs" && path != "lib.rs")
    {
        let from = top(path);
        for line in lines {
            let targets = line
                .split("crate::")
                .skip(1)
                .map(|rest| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>());
            let others = targets.filter(|to| modules.contains(to) && *to != from);
            graph.entry(from.clone()).or_default().extend(others);
        }
    }
    graph
}

/// A circle of modules, if there is one.
fn circle(graph: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    let mut left = graph.clone();
    // A module that imports nothing that is left is on no circle.
    loop {
        let names: BTreeSet<String> = left.keys().cloned().collect();
        let free: Vec<String> =
            left.iter().filter(|(_, to)| to.is_disjoint(&names)).map(|(name, _)| name.clone()).collect();
        if free.is_empty() {
            break;
        }
        left.retain(|name, _| !free.contains(name));
    }
    (!left.is_empty()).then(|| left.into_keys().collect())
}

#[test]
fn modules_import_each_other_in_one_direction() {
    let graph = imports(&code());
    assert!(graph["drive"].contains("case") && graph["result"].contains("drive"), "imports were not read: {graph:?}");
    assert_eq!(circle(&graph), None, "modules of src import each other in a circle: {graph:#?}");
    // The check itself can fail.
    let mut broken = graph;
    broken.entry("case".into()).or_default().insert("drive".into());
    assert!(circle(&broken).is_some_and(|names| names.contains(&"case".to_owned())));
}

/// Names of all generated states, fields, integrals, constants and outputs.
fn generated_names() -> BTreeSet<&'static str> {
    let mut names = BTreeSet::new();
    names.extend(State::ALL.map(State::name));
    names.extend(Field::ALL.map(Field::name));
    names.extend(Integral::ALL.map(Integral::name));
    names.extend(RegionConstant::ALL.map(RegionConstant::name));
    names.extend(Constant::ALL.map(Constant::name));
    names.extend(Output::ALL.map(Output::name));
    names
}

/// Whether a text is an output's name, or a pattern that becomes one: `efficiency.{which}`. Only outputs have names
/// with a dot, so that such a text names nothing else wherever it stands.
fn names_an_output(text: &str) -> bool {
    let open = |part: &str| part.starts_with('{') && part.ends_with('}');
    let Some((group, member)) = text.split_once('.') else { return false };
    let fits = |name: &str| match name.split_once('.') {
        Some((of, what)) => (of == group || open(group)) && (what == member || open(member)),
        None => false,
    };
    !(open(group) && open(member)) && Output::ALL.into_iter().any(|output| fits(output.name()))
}

/// Whether a line decides by a generated name: compares one with a text, matches one, looks one up, or writes an
/// output's name out.
fn matches_a_name(line: &str, names: &BTreeSet<&str>) -> bool {
    let compared = ["symbol.name ==", ".name() ==", "equation.name ==", "name() == name"];
    if compared.iter().any(|text| line.contains(text)) {
        return true;
    }
    let parts: Vec<&str> = line.split('"').collect();
    parts.windows(3).enumerate().filter(|(at, _)| at % 2 == 0).any(|(_, part)| {
        let (before, text, after) = (part[0].trim_end(), part[1], part[2].trim_start());
        let looked_up = [".get(", ".state(", ".field(", ".integral(", ".set(", "named(", "column("];
        let arm = after.starts_with("=>") || after.starts_with("| \"") || after.starts_with(", Self::");
        names_an_output(text) || names.contains(text) && (arm || looked_up.iter().any(|call| before.ends_with(call)))
    })
}

#[test]
fn no_generated_name_is_matched_as_a_string() {
    let names = generated_names();
    let mut found = Vec::new();
    for (path, lines) in code() {
        // A unit of temperature, not the belt's tension.
        let unit = |line: &str| path == "bench/sheet.rs" && line.contains("\"degF\"");
        // A type that reads its own names, and keys of the case file, which are not generated.
        let own = |line: &str| line.contains("Self::ALL.into_iter().find(") || line.contains("case::TABLE.iter()");
        let lines = lines.iter().filter(|line| !unit(line) && !own(line) && matches_a_name(line, &names));
        found.extend(lines.map(|line| format!("{path}: {}", line.trim())));
    }
    assert!(found.is_empty(), "generated names are matched as strings:\n{}", found.join("\n"));
    // The check itself can fail.
    for line in [
        "let x = kernel.states.iter().position(|symbol| symbol.name == \"x\")?;",
        "\"T\" | \"tau\" => tension,",
        "(\"sigma\", Self::Primary) => return Some(Source::One),",
        "let value = outputs.get(\"efficiency.overall\");",
        "const EFFICIENCY: &str = \"efficiency.overall\";",
        "let value = table.number(rows.start + at, \"efficiency.overall\");",
        "let value = table.number(row, &format!(\"efficiency.{which}\"));",
        "let name = format!(\"{pulley}.axial_force\");",
    ] {
        assert!(matches_a_name(line, &names), "{line}");
    }
    for line in ["format!(\"{pulley}.max_penetration\")", "\"losses.total\"", "&format!(\"{}.svg\", figure.name)"] {
        assert!(!matches_a_name(line, &names), "{line}");
    }
}
