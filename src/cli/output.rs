//! Writing results: to standard output, and to files that are never seen half-written.

use super::stop::Stop;
use rayon::prelude::*;
use serde::Serialize;
use sheave::plot::Figure;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Prints a text on standard output.
pub fn print(text: &str) -> Result<(), Stop> {
    let mut stdout = io::stdout().lock();
    let written = stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush());
    written.map_err(|error| Stop::Write("standard output".into(), error))
}

/// One JSON object, readable, with a line's end.
pub fn json(object: &impl Serialize) -> Result<String, Stop> {
    let text = serde_json::to_string_pretty(object).map_err(|error| Stop::Write("JSON".into(), error.into()))?;
    Ok(text + "\n")
}

/// Creates a folder, with those above it.
pub fn create_folder(folder: &Path) -> Result<(), Stop> {
    std::fs::create_dir_all(folder).map_err(|error| Stop::Write(folder.display().to_string(), error))
}

/// Writes a file of `folder` beside its place and renames it: whoever looks sees the old content or the new.
pub fn write_file(
    folder: &Path,
    name: &str,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), Stop> {
    let path = folder.join(name);
    let write = || {
        let beside = tempfile::Builder::new().prefix(name).suffix(".part").tempfile_in(folder)?;
        readable_as_others(beside.as_file())?;
        let mut writer = BufWriter::new(beside);
        content(&mut writer)?;
        let beside = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
        beside.as_file().sync_all()?;
        beside.persist(&path).map_err(|error| error.error)?;
        tracing::info!("wrote {}", path.display());
        Ok(())
    };
    write().map_err(|error| Stop::Write(path.display().to_string(), error))
}

/// Writes figures into a folder, each as SVG and as PNG.
pub fn write_figures(folder: &Path, figures: &[Figure]) -> Result<(), Stop> {
    figures.par_iter().try_for_each(|figure| {
        let (svg, png) = (figure.svg()?, figure.png()?);
        write_file(folder, &format!("{}.svg", figure.name), |to| to.write_all(svg.as_bytes()))?;
        write_file(folder, &format!("{}.png", figure.name), |to| to.write_all(&png))
    })
}

/// Temporary files are private; results are not.
fn readable_as_others(file: &std::fs::File) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.set_permissions(std::fs::Permissions::from_mode(0o644))?;
    }
    #[cfg(not(unix))]
    let _ = file;
    Ok(())
}
