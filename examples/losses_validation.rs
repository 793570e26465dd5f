//! The losses against a dynamometer and against scaling laws:
//! `cargo run --release --no-default-features --features figures --example losses_validation` writes
//! `docs/validation.md` with its tables and figures anew.

mod losses_validation {
    pub mod bench;
    pub mod page;
    pub mod trends;
}

use std::error::Error;
use std::path::Path;

use losses_validation::{bench, page, trends};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let bench = bench::compare()?;
    let trends = trends::trends()?;
    page::write(&folder, &bench, &trends)?;
    print!("{}", page::summary(&bench));
    Ok(())
}
