//! Symbolica on one thread of one process.
//!
//! Without a licence key Symbolica runs one instance per machine and one thread in it. All symbolic work of a
//! process goes through the one worker thread here, and processes queue on a lock file in the temporary
//! directory; who has to wait says so on standard error.

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

/// The lock that lets one process on the machine at Symbolica; held until the process ends.
fn machine_lock() -> Result<File, String> {
    let folder = std::env::temp_dir();
    let (file, path) = lock_file(&folder).map_err(|error| format!("lock file in {}: {error}", folder.display()))?;
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

/// The lock file, which another user may have made: reading it is enough to lock it. If even that is denied, one of this
/// user's own, as Symbolica counts instances by user.
fn lock_file(folder: &Path) -> io::Result<(File, PathBuf)> {
    let shared = folder.join(LOCK_FILE);
    match open_or_create(&shared) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => {
            let user = ["USER", "LOGNAME"].iter().find_map(|name| std::env::var(name).ok()).unwrap_or_default();
            let user: String = user.chars().filter(char::is_ascii_alphanumeric).collect();
            let own = folder.join(format!("{user}-{LOCK_FILE}"));
            open_or_create(&own).map(|file| (file, own))
        }
        opened => opened.map(|file| (file, shared)),
    }
}

fn open_or_create(path: &Path) -> io::Result<File> {
    match File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        opened => return opened,
    }
    match File::create_new(path) {
        // Another process was faster.
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => File::open(path),
        created => created,
    }
}

#[cfg(test)]
mod tests {
    use super::{LOCK_FILE, lock_file};

    #[test]
    fn a_lock_file_that_cannot_be_written_locks() {
        let folder = std::env::temp_dir().join(format!("sheave-lock-{}", std::process::id()));
        std::fs::create_dir(&folder).unwrap();
        let (first, path) = lock_file(&folder).unwrap();
        assert_eq!(path, folder.join(LOCK_FILE));
        let mut permissions = std::fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        std::fs::set_permissions(&path, permissions).unwrap();
        let (second, _) = lock_file(&folder).unwrap();
        first.try_lock().unwrap();
        assert!(second.try_lock().is_err());
        drop(first);
        second.try_lock().unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
