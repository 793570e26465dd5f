//! Symbolica on one thread of one process.
//!
//! Without a licence key Symbolica runs one instance for each user and one thread in it. All symbolic work of a
//! process goes through the one worker thread here, and processes queue on a lock file in a folder of the
//! user's; who has to wait says so on standard error.

use std::fs::{File, TryLockError};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, mpsc};

use crate::error::Error;
use crate::physics::notation;

type Job = Box<dyn FnOnce() + Send>;

const LOCK_FILE: &str = "sheave-symbolica.lock";

static NOTICE: OnceLock<fn(&str)> = OnceLock::new();

/// Says who is told when this process has to wait for another one; standard error by default. The first call counts.
pub fn on_wait(notice: fn(&str)) {
    // A second caller loses; it is told the same either way.
    let _ = NOTICE.set(notice);
}

/// Runs `work` on the one thread that may touch Symbolica and returns its result.
///
/// # Errors
/// [`Error::Engine`] if the lock file cannot be had or `work` panics.
pub fn symbolic<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Result<T, Error> {
    let (send, receive) = mpsc::channel();
    let job: Job = Box::new(move || {
        // The receiver waits below; it can only be gone if the process is ending.
        let _ = send.send(catch_unwind(AssertUnwindSafe(work)));
    });
    worker()?.send(job).map_err(|_| Error::Engine("its thread has ended".into()))?;
    match receive.recv() {
        Ok(Ok(result)) => Ok(result),
        Ok(Err(panic)) => {
            let text = panic.downcast_ref::<String>().cloned();
            let text = text.or_else(|| panic.downcast_ref::<&str>().map(|&text| text.to_owned()));
            Err(Error::Engine(format!("the work panicked: {}", text.unwrap_or_default())))
        }
        Err(_) => Err(Error::Engine("its thread has ended".into())),
    }
}

fn worker() -> Result<mpsc::Sender<Job>, Error> {
    static WORKER: OnceLock<Result<Mutex<mpsc::Sender<Job>>, String>> = OnceLock::new();
    match WORKER.get_or_init(start) {
        Ok(sender) => Ok(sender.lock().map_err(|_| Error::Engine("its queue is poisoned".into()))?.clone()),
        Err(message) => Err(Error::Engine(message.clone())),
    }
}

fn start() -> Result<Mutex<mpsc::Sender<Job>>, String> {
    let (send, receive) = mpsc::channel::<Job>();
    let (ready, started) = mpsc::channel();
    let body = move || {
        let lock = machine_lock();
        let held = lock.is_ok();
        let _ = ready.send(lock.as_ref().map(|_| ()).map_err(Clone::clone));
        if held {
            notation::register();
            receive.into_iter().for_each(|job| job());
        }
    };
    std::thread::Builder::new()
        .name("symbolica".into())
        .stack_size(64 << 20)
        .spawn(body)
        .map_err(|error| error.to_string())?;
    started.recv().map_err(|error| error.to_string())??;
    Ok(Mutex::new(send))
}

/// The lock that lets one process of this user at Symbolica; held until the process ends. Symbolica counts instances by
/// user.
fn machine_lock() -> Result<File, String> {
    let mut refused = Vec::new();
    let opened = folders().into_iter().find_map(|folder| match lock_file(&folder) {
        Ok(opened) => Some(opened),
        Err(error) => {
            refused.push(format!("{}: {error}", folder.display()));
            None
        }
    });
    let (file, path) = opened.ok_or_else(|| format!("no lock file can be had: {}", refused.join("; ")))?;
    let describe = |error: io::Error| format!("lock file {}: {error}", path.display());
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => {
            let notice = NOTICE.get_or_init(|| |message| eprintln!("eqgen: {message}"));
            notice(&format!("another process uses Symbolica; waited for {}", path.display()));
            file.lock().map_err(describe)?;
        }
        Err(TryLockError::Error(error)) => return Err(describe(error)),
    }
    Ok(file)
}

/// Folders for the lock file, the best first: places of this user alone, where nobody else can put a pipe or a link in
/// its way, and for users without a home one of their own among the temporary files.
fn folders() -> Vec<PathBuf> {
    let variable = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let user = ["USER", "LOGNAME", "USERNAME"].iter().find_map(|name| std::env::var(name).ok()).unwrap_or_default();
    let user: String = user.chars().filter(char::is_ascii_alphanumeric).collect();
    let own = [
        variable("XDG_RUNTIME_DIR"),
        variable("XDG_CACHE_HOME"),
        variable("HOME").map(|home| home.join(".cache")),
        variable("LOCALAPPDATA"),
    ];
    let own = own.into_iter().flatten().map(|folder| folder.join("sheave"));
    own.chain([std::env::temp_dir().join(format!("sheave-{user}"))]).collect()
}

/// Opens the lock file in a folder, and makes both where they are missing. Nothing is opened that is no regular file: a
/// pipe would block, a link lead elsewhere. Reading is enough to lock.
fn lock_file(folder: &Path) -> io::Result<(File, PathBuf)> {
    make_private(folder)?;
    if !std::fs::symlink_metadata(folder)?.is_dir() {
        return Err(io::Error::other("this is no folder"));
    }
    let path = folder.join(LOCK_FILE);
    match File::create_new(&path) {
        Ok(file) => return Ok((file, path)),
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
        Err(error) => return Err(error),
    }
    if !std::fs::symlink_metadata(&path)?.is_file() {
        return Err(io::Error::other(format!("{LOCK_FILE} is no regular file; remove it")));
    }
    File::open(&path).map(|file| (file, path))
}

/// A folder, with those above it, that only this user enters.
fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = std::fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)
}

#[cfg(test)]
mod tests {
    use super::{LOCK_FILE, folders, lock_file};
    use std::path::PathBuf;

    fn folder(name: &str) -> PathBuf {
        std::env::temp_dir().join(format!("sheave-lock-{name}-{}", std::process::id()))
    }

    #[test]
    fn a_lock_file_that_cannot_be_written_locks() {
        let folder = folder("read-only");
        let (first, path) = lock_file(&folder).unwrap();
        assert_eq!(path, folder.join(LOCK_FILE));
        let mut permissions = std::fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        std::fs::set_permissions(&path, permissions).unwrap();
        let (second, _) = lock_file(&folder).unwrap();
        first.try_lock().unwrap();
        assert!(second.try_lock().is_err());
        // Closing it would free the lock only once no child that is just being started holds a copy of the handle.
        first.unlock().unwrap();
        second.try_lock().unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn what_is_no_file_neither_blocks_nor_is_followed() {
        let folder = folder("foreign");
        std::fs::create_dir(&folder).unwrap();
        let path = folder.join(LOCK_FILE);
        assert!(std::process::Command::new("mkfifo").arg(&path).status().unwrap().success());
        assert!(lock_file(&folder).unwrap_err().to_string().contains("no regular file"));
        std::fs::remove_file(&path).unwrap();
        let target = folder.join("nowhere");
        std::os::unix::fs::symlink(&target, &path).unwrap();
        assert!(lock_file(&folder).unwrap_err().to_string().contains("no regular file"));
        assert!(!target.exists());
        std::fs::remove_file(&path).unwrap();
        // Nor a folder that is a link, and there is always another to try.
        let link = folder.join("link");
        std::os::unix::fs::symlink(&folder, &link).unwrap();
        assert!(lock_file(&link).is_err());
        assert!(!folders().is_empty());
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
