//! Files that appear whole.

use pyo3::prelude::*;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Writes a file beside its place and renames it, so that whoever looks sees the old content or the new, whatever other
/// threads and processes write there; other threads of the interpreter run meanwhile.
///
/// # Errors
/// `OSError` that names the file; nothing is left of it then.
pub fn write(
    py: Python<'_>,
    path: &Path,
    content: impl FnOnce(&mut (dyn Write + Send)) -> io::Result<()> + Send,
) -> PyResult<()> {
    let write = || -> io::Result<()> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let mut builder = tempfile::Builder::new();
        builder.prefix(path.file_name().unwrap_or_default()).suffix(".part");
        // As any file that is made: what nobody else may see, the mask of the process says.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut writer = BufWriter::new(builder.tempfile_in(folder)?);
        content(&mut writer)?;
        let beside = writer.into_inner().map_err(io::IntoInnerError::into_error)?;
        beside.as_file().sync_all()?;
        beside.persist(path)?;
        Ok(())
    };
    // Of the type that says what is wrong: `FileNotFoundError`, `PermissionError`.
    let named = |error: io::Error| io::Error::new(error.kind(), format!("cannot write {}: {error}", path.display()));
    Ok(py.detach(write).map_err(named)?)
}
