//! The belt drive's equations, and how they become Rust.
//!
//! ```text
//! physics  what is typed in: notation, primitive relations, end conditions
//! derive   symbolic work: total derivatives, linearisation, isolation of unknowns
//! plan     named steps, each checked for its dimension
//! emit     steps → shared operations and derivatives → tokens → formatted files
//! document the same steps as text, LaTeX and Markdown
//! ```
//!
//! A pure library: models in, text out. The build script of `generated` and the command of this package are thin.

pub mod derive;
pub mod dimension;
pub mod document;
pub mod emit;
mod engine;
mod error;
pub mod physics;
pub mod plan;

pub use emit::SourceFile;
pub use engine::{on_wait, symbolic};
pub use error::Error;

/// All generated files, in a fixed order; the same text on every run.
///
/// # Errors
/// The first inconsistency of any equation, or what keeps the symbolic engine from starting.
pub fn generate() -> Result<Vec<SourceFile>, Error> {
    symbolic(|| {
        let kernels = physics::edition::kernels()?;
        let emitted = |kernels: &[physics::model::Model]| {
            kernels.iter().map(|kernel| emit::file(kernel, emit::BELT)).collect::<Result<Vec<_>, _>>()
        };
        let mut files = emitted(&kernels)?;
        files.push(emit::twin("twin.rs", &kernels)?);
        files.extend(document::files()?);
        let small = physics::small::kernels()?;
        files.extend(emitted(&small)?);
        files.push(emit::twin("twin_small.rs", &small)?);
        let all: Vec<_> = kernels.into_iter().chain(small).collect();
        files.push(emit::vocabulary(&all, &physics::notation::all(), emit::BELT)?);
        Ok(files)
    })?
}
