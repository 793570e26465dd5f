//! `cargo run -p sheave-eqgen -- write` writes the generated files; `-- --check` compares them.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const COMMAND: &str = "cargo run -p sheave-eqgen -- write";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["write"] => write(),
        ["--check"] => check(),
        _ => Err(format!("usage: {COMMAND} | cargo run -p sheave-eqgen -- --check")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Generated file that the documentation holds a copy of, and the copy.
const PAGE: (&str, &str) = ("derivation_consistent.md", "../docs/derivation.md");

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/golden")
}

/// Where a generated file is kept.
fn places(file: &eqgen::SourceFile) -> Vec<PathBuf> {
    let copy = (file.name == PAGE.0).then(|| Path::new(env!("CARGO_MANIFEST_DIR")).join(PAGE.1));
    std::iter::once(golden().join(&file.name)).chain(copy).collect()
}

fn write() -> Result<(), String> {
    let failed = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    std::fs::create_dir_all(golden()).map_err(|error| failed(&golden(), error))?;
    for file in eqgen::generate().map_err(|error| error.to_string())? {
        for path in places(&file).iter().filter(|path| !holds(path, &file)) {
            replace(path, &file.text).map_err(|error| failed(path, error))?;
            println!("wrote {}", path.display());
        }
    }
    Ok(())
}

/// Writes beside, then renames: whoever stops this finds the old file or the new one.
fn replace(path: &Path, text: &str) -> std::io::Result<()> {
    let beside = path.with_extension("new");
    let written = std::fs::write(&beside, text).and_then(|()| std::fs::rename(&beside, path));
    written.inspect_err(|_| drop(std::fs::remove_file(&beside)))
}

fn check() -> Result<(), String> {
    let files = eqgen::generate().map_err(|error| error.to_string())?;
    let stale = |file: &eqgen::SourceFile| places(file).into_iter().find(|path| !holds(path, file));
    let stale: Vec<String> = files.iter().filter_map(stale).map(|path| path.display().to_string()).collect();
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!("out of date: {}\nwrite it anew with: {COMMAND}", stale.join(", ")))
}

fn holds(path: &Path, file: &eqgen::SourceFile) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text == file.text)
}
