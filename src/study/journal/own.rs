//! Opening files that have to be this program's own: regular files, reached without a symbolic link, held by one
//! process.

use std::fs::{File, Metadata, OpenOptions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// What stands at a path.
pub(super) enum Found {
    /// Nothing.
    Nothing,
    /// A regular file, open for reading and writing, and locked until it is closed.
    Ours(File),
    /// A regular file that another process holds.
    Busy,
    /// Something else: a symbolic link, a folder, a pipe, a device; never opened.
    Foreign(&'static str),
}

/// Opens and locks the regular file at `path`, if there is one; changes nothing.
pub(super) fn find(path: &Path) -> io::Result<Found> {
    match std::fs::symlink_metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Found::Nothing),
        Err(error) => return Err(error),
        Ok(metadata) => {
            if let Some(kind) = foreign(&metadata) {
                return Ok(Found::Foreign(kind));
            }
        }
    }
    match OpenOptions::new().read(true).write(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Found::Nothing),
        Err(error) => Err(error),
        Ok(file) => held(file, path),
    }
}

/// Makes a file at `path` and locks it; nothing is made where something stands.
pub(super) fn create(path: &Path) -> io::Result<Found> {
    held(OpenOptions::new().read(true).write(true).create_new(true).open(path)?, path)
}

/// Locks a file that was opened at `path`, and looks whether it still stands there.
fn held(file: File, path: &Path) -> io::Result<Found> {
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Ok(Found::Busy),
        // A file system without locks; there, nobody is kept out.
        Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
            tracing::warn!("{} cannot be locked: start no second sweep on it", path.display());
        }
        Err(TryLockError::Error(error)) => return Err(error),
    }
    match std::fs::symlink_metadata(path) {
        // Its process was done with it between the two calls.
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(Found::Busy),
        Err(error) => Err(error),
        Ok(there) => match foreign(&there) {
            Some(kind) => Ok(Found::Foreign(kind)),
            None if same(&there, &file.metadata()?) => Ok(Found::Ours(file)),
            None => Ok(Found::Busy),
        },
    }
}

/// What something is that is no regular file.
fn foreign(metadata: &Metadata) -> Option<&'static str> {
    let kind = metadata.file_type();
    match () {
        () if kind.is_symlink() => Some("a symbolic link"),
        () if kind.is_dir() => Some("a folder"),
        () if kind.is_file() => None,
        () => Some("no regular file"),
    }
}

#[cfg(unix)]
fn same(a: &Metadata, b: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn same(_: &Metadata, _: &Metadata) -> bool {
    true
}

/// Gives the file at `path` the first free name of `path.old.1`, `path.old.2` and so on; no file is overwritten.
///
/// # Errors
/// What the system says.
pub fn set_aside(path: &Path) -> io::Result<PathBuf> {
    for number in 1..=MOST_OLD {
        let mut old = path.as_os_str().to_owned();
        old.push(format!(".old.{number}"));
        let old = PathBuf::from(old);
        match std::fs::hard_link(path, &old) {
            Ok(()) => {
                std::fs::remove_file(path)?;
                return Ok(old);
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Err(error),
            // A file system without hard links.
            Err(_) if std::fs::symlink_metadata(&old).is_err() => {
                std::fs::rename(path, &old)?;
                return Ok(old);
            }
            Err(_) => {}
        }
    }
    Err(io::Error::other(format!("there are {MOST_OLD} older ones beside it already")))
}

/// Older files of one name that are kept.
const MOST_OLD: usize = 10_000;

/// Has the system put a folder's entries on the disk, where a system can.
pub fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // Some systems cannot sync folders, and need not: nothing to say.
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}
