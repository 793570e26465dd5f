//! Work that Ctrl-C ends, with the interpreter free for other threads meanwhile.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use sheave::{Cancel, cancellable};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How often signals are looked for, and progress is told.
const TICK: Duration = Duration::from_millis(50);

type Job = Box<dyn FnOnce() + Send>;

/// A thread that waits for work, of this process: a fork has none of its parent's threads.
struct Worker {
    process: u32,
    jobs: Sender<Job>,
}

/// Threads that wait, kept because starting one takes longer than handing work to it.
static IDLE: Mutex<Vec<Worker>> = Mutex::new(Vec::new());

fn idle() -> std::sync::MutexGuard<'static, Vec<Worker>> {
    IDLE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Stack of a worker, as large as that of a main thread.
const STACK: usize = 8 << 20;

fn worker() -> std::io::Result<Worker> {
    let process = std::process::id();
    let mut waiting = idle();
    waiting.retain(|worker| worker.process == process);
    if let Some(worker) = waiting.pop() {
        return Ok(worker);
    }
    drop(waiting);
    let (jobs, todo) = channel::<Job>();
    std::thread::Builder::new()
        .name("sheave".into())
        .stack_size(STACK)
        .spawn(move || todo.into_iter().for_each(|job| job()))?;
    Ok(Worker { process, jobs })
}

/// Does `work` without holding the interpreter's lock, on the calling thread; on the main thread, which alone receives
/// signals, Ctrl-C ends it: Newton's iterations ask for signals now and then. For work that starts no threads of its
/// own, for these would be asked in its place.
///
/// # Errors
/// `KeyboardInterrupt`, or what a handler of signals raises.
pub fn run<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let asked = Arc::new(Mutex::new(Asked { last: Instant::now(), raised: None }));
    let held = asked.clone();
    let cancel = Cancel::asking(move || held.lock().unwrap_or_else(PoisonError::into_inner).signals());
    let result = py.detach(|| catch_unwind(AssertUnwindSafe(|| cancellable(&cancel, work))));
    let raised = asked.lock().unwrap_or_else(PoisonError::into_inner).raised.take();
    match (raised, result) {
        (Some(error), _) => Err(error),
        (None, Ok(result)) => Ok(result),
        (None, Err(_)) => Err(panicked()),
    }
}

/// When signals were last looked for, and what their handler raised.
struct Asked {
    last: Instant,
    raised: Option<PyErr>,
}

impl Asked {
    /// Whether a signal ends the work.
    fn signals(&mut self) -> bool {
        if self.last.elapsed() < TICK {
            return false;
        }
        self.raised = Python::attach(|py| py.check_signals()).err();
        self.last = Instant::now();
        self.raised.is_some()
    }
}

fn panicked() -> PyErr {
    PyRuntimeError::new_err("the computation panicked: a defect of sheave")
}

/// As [`run`], with the work on another thread and those that it starts, telling `tick` that time goes by; what that
/// raises ends the work, too. `cancel` is for work that looks at it itself.
///
/// # Errors
/// As [`run`], and what `tick` raises.
pub fn watched<T: Send + 'static>(
    py: Python<'_>,
    cancel: &Cancel,
    work: impl FnOnce() -> T + Send + 'static,
    mut tick: impl FnMut(Python<'_>) -> PyResult<()>,
) -> PyResult<T> {
    let worker = worker()?;
    let (done, ended) = channel();
    let held = cancel.clone();
    let job = move || {
        // Whoever waits is told of a panic by the missing result.
        let result = catch_unwind(AssertUnwindSafe(|| cancellable(&held, work)));
        let _ = done.send(result.ok());
    };
    if worker.jobs.send(Box::new(job)).is_err() {
        return Err(PyRuntimeError::new_err("the computation's thread has ended"));
    }
    let ended = Mutex::new(ended);
    let wait = |time: Duration| {
        let ended = ended.lock().unwrap_or_else(PoisonError::into_inner);
        ended.recv_timeout(time)
    };
    let mut raised = None;
    let result = loop {
        match py.detach(|| wait(TICK)) {
            Ok(result) => break result,
            Err(RecvTimeoutError::Disconnected) => break None,
            Err(RecvTimeoutError::Timeout) if raised.is_some() => {}
            Err(RecvTimeoutError::Timeout) => {
                if let Err(error) = py.check_signals().and_then(|()| tick(py)) {
                    cancel.cancel();
                    raised = Some(error);
                }
            }
        }
    };
    idle().push(worker);
    match (raised, result) {
        (Some(error), _) => Err(error),
        (None, Some(result)) => Ok(result),
        (None, None) => Err(panicked()),
    }
}
