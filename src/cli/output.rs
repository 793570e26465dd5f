//! Writing results: to standard output, and to files that are never seen half-written.

use super::stop::Stop;
use rayon::prelude::*;
use serde::Serialize;
use sheave::plot::Figure;
use sheave::study::sync_folder;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

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

/// Prints one JSON object, piece by piece: it may be larger than what should be in memory at once.
pub fn print_object(object: &impl Serialize) -> Result<(), Stop> {
    let mut stdout = io::BufWriter::new(io::stdout().lock());
    let written = serde_json::to_writer_pretty(&mut stdout, object).map_err(io::Error::from);
    let written = written.and_then(|()| stdout.write_all(b"\n")).and_then(|()| stdout.flush());
    written.map_err(|error| Stop::Write("standard output".into(), error))
}

/// Creates a folder, with those above it.
pub fn create_folder(folder: &Path) -> Result<(), Stop> {
    std::fs::create_dir_all(folder).map_err(|error| Stop::Write(folder.display().to_string(), error))
}

/// Writes a file of `folder` beside its place and renames it: whoever looks sees the old content or the new. A symbolic
/// link is followed; what it leads to is replaced, not the link.
pub fn write_file(
    folder: &Path,
    name: &str,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> Result<(), Stop> {
    let path = folder.join(name);
    let write = || {
        let path = followed(&path)?;
        beside(&path, content)?.persist(&path).map_err(|error| error.error)?;
        sync_folder(&path);
        tracing::info!("wrote {}", path.display());
        Ok(())
    };
    write().map_err(|error| Stop::Write(path.display().to_string(), error))
}

/// Writes a file beside `path`, which [`followed`] has been asked about: the content is on the disk, the name is not
/// yet taken.
pub fn beside(
    path: &Path,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()>,
) -> io::Result<NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    let name = path.file_name().unwrap_or_default();
    let permissions = permissions(path);
    builder.prefix(name).suffix(".part");
    if let Some(permissions) = &permissions {
        builder.permissions(permissions.clone());
    }
    let mut writer = BufWriter::new(builder.tempfile_in(folder)?);
    content(&mut writer)?;
    let beside = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let (Some(permissions), true) = (permissions, path.exists()) {
        beside.as_file().set_permissions(permissions)?;
    }
    beside.as_file().sync_all()?;
    Ok(beside)
}

/// Where a file that is asked for goes, before anything is computed.
pub fn place(out: &Path) -> Result<PathBuf, Stop> {
    let path = followed(out).map_err(|error| Stop::Usage(format!("{}: {error}", out.display())))?;
    if path.is_dir() {
        return Err(Stop::Usage(format!("{} is a folder: expected the name of a file in it", out.display())));
    }
    Ok(path)
}

/// Whether a folder that is asked for can be one, before anything is computed.
pub fn folder_place(out: Option<&Path>) -> Result<(), Stop> {
    // The nearest that is there, of the folder and those above it, must be one.
    let there = out.into_iter().flat_map(Path::ancestors).find(|path| path.exists());
    match (out, there) {
        (Some(out), Some(there)) if !there.is_dir() => {
            let which = if there == out { String::new() } else { format!(" in {}", out.display()) };
            Err(Stop::Usage(format!("{}{which} is a file: expected the name of a folder", there.display())))
        }
        _ => Ok(()),
    }
}

/// Where a path leads, if it is a symbolic link.
///
/// # Errors
/// A link that leads nowhere, or to itself.
pub fn followed(path: &Path) -> io::Result<PathBuf> {
    match std::fs::symlink_metadata(path) {
        Ok(metadata) if metadata.file_type().is_symlink() => std::fs::canonicalize(path)
            .map_err(|error| io::Error::new(error.kind(), format!("a symbolic link that leads nowhere ({error})"))),
        _ => Ok(path.to_owned()),
    }
}

/// Permissions of a new file: those of the one it replaces, else what the user's mask leaves; temporary files would be
/// private.
#[cfg(unix)]
fn permissions(path: &Path) -> Option<std::fs::Permissions> {
    use std::os::unix::fs::PermissionsExt;
    let there = std::fs::metadata(path).ok().map(|metadata| metadata.permissions());
    Some(there.unwrap_or_else(|| std::fs::Permissions::from_mode(0o666)))
}

#[cfg(not(unix))]
fn permissions(_: &Path) -> Option<std::fs::Permissions> {
    None
}

/// Writes figures into a folder, each as SVG and as PNG.
pub fn write_figures(folder: &Path, figures: &[Figure]) -> Result<(), Stop> {
    figures.par_iter().try_for_each(|figure| {
        let (svg, png) = (figure.svg()?, figure.png()?);
        write_file(folder, &format!("{}.svg", figure.name), |to| to.write_all(svg.as_bytes()))?;
        write_file(folder, &format!("{}.png", figure.name), |to| to.write_all(&png))
    })
}
