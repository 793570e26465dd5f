//! Compiles the shared library of Functional Mock-up Units, which depends on nothing but the standard library.

use std::path::Path;
use std::process::Command;

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=fmu");
    let variable = |name: &str| std::env::var(name).map_err(|error| format!("{name}: {error}"));
    let library = Path::new(&variable("OUT_DIR")?).join("sheave_fmu.library");
    let mut compile = Command::new(variable("RUSTC")?);
    compile.args(["--edition", "2024", "--crate-type", "cdylib", "--crate-name", "sheave_fmu", "fmu/lib.rs"]);
    compile
        .args(["-C", "opt-level=3", "-C", "strip=symbols", "--target", &variable("TARGET")?])
        .arg("-o")
        .arg(&library);
    let status = compile.status().map_err(|error| format!("rustc: {error}"))?;
    if !status.success() {
        return Err(format!("the library of Functional Mock-up Units does not compile: {status}"));
    }
    println!("cargo::rustc-env=SHEAVE_FMU={}", library.display());
    Ok(())
}
