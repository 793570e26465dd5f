//! Files that appear whole.

use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file beside its place and renames it, so that whoever looks sees the old content or the new; other threads
/// of the interpreter run meanwhile.
///
/// # Errors
/// `OSError` that names the file; nothing is left of it then.
pub fn write(
    py: Python<'_>,
    path: &Path,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()> + Send,
) -> PyResult<()> {
    let write = || -> io::Result<()> {
        let mut name = path.as_os_str().to_owned();
        name.push(format!(".{}.part", std::process::id()));
        let beside = PathBuf::from(name);
        let written = std::fs::File::create(&beside).and_then(|file| {
            let mut writer = BufWriter::new(file);
            content(&mut writer)?;
            writer.into_inner().map_err(io::IntoInnerError::into_error)?.sync_all()?;
            std::fs::rename(&beside, path)
        });
        if written.is_err() {
            // What is left of a file that nobody asked for.
            let _ = std::fs::remove_file(&beside);
        }
        written
    };
    py.detach(write).map_err(|error| PyOSError::new_err(format!("cannot write {}: {error}", path.display())))
}
