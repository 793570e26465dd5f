//! `cargo run -p eqgen -- write` writes the generated files; `-- --check` compares them.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const COMMAND: &str = "cargo run -p eqgen -- write";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["write"] => write(&golden()),
        ["--check"] => check(&golden()),
        _ => Err(format!("usage: {COMMAND} | cargo run -p eqgen -- --check")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn golden() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/golden")
}

fn write(folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for file in eqgen::generate().map_err(|error| error.to_string())? {
        let path = folder.join(&file.name);
        if std::fs::read_to_string(&path).is_ok_and(|text| text == file.text) {
            continue;
        }
        std::fs::write(&path, &file.text).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("wrote {}", path.display());
    }
    Ok(())
}

fn check(folder: &Path) -> Result<(), String> {
    let files = eqgen::generate().map_err(|error| error.to_string())?;
    let differs = |file: &&eqgen::SourceFile| {
        std::fs::read_to_string(folder.join(&file.name)).map_or(true, |text| text != file.text)
    };
    let stale: Vec<&str> = files.iter().filter(differs).map(|file| file.name.as_str()).collect();
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!("out of date in {}: {}\nmend it with: {COMMAND}", folder.display(), stale.join(", ")))
}
