//! The invariants that ARCHITECTURE.md states, held by `cargo metadata` and by reading the sources.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};

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
