//! Derives the equations anew (feature `regenerate`); without it the committed copy in `golden/` is used.

#[cfg(not(feature = "regenerate"))]
fn main() {
    println!("cargo:rerun-if-changed=build.rs");
}

#[cfg(feature = "regenerate")]
fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A change of eqgen recompiles this script, and so runs it.
    println!("cargo:rerun-if-changed=build.rs");
    eqgen::on_wait(|message| println!("cargo:warning={message}"));
    let folder = std::path::PathBuf::from(std::env::var("OUT_DIR")?);
    for file in eqgen::generate()? {
        let path = folder.join(&file.name);
        if !std::fs::read_to_string(&path).is_ok_and(|text| text == file.text) {
            std::fs::write(&path, &file.text)?;
        }
    }
    Ok(())
}
