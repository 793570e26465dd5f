//! Derives the elastica's kernels and writes them beside its equations.

mod equations;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/elastica");
    for file in equations::files()? {
        std::fs::write(folder.join(&file.name), &file.text)?;
    }
    Ok(())
}
