//! A sweep over ratio, slack tension and torque: points per second on one and on two threads, peak memory, and whether
//! one that is killed half-way is completed to the same file.
//! `cargo bench --no-default-features --features full --bench sweep [-- POINTS]`.

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Points along the torque, solved one from the other.
const TORQUES: usize = 16;

/// Starts a sweep into `out`.
fn sweep(side: usize, jobs: &str, out: &Path, resume: bool) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.args(["sweep", "--tol", "1e-4", "--jobs", jobs]);
    command.arg("--over").arg(format!("drive.ratio=0.72..1.74:{side}"));
    command.arg("--over").arg(format!("operating_point.slack_tension=60..300 N:{side}"));
    command.arg("--over").arg(format!("operating_point.primary_torque=3..18:{TORQUES}"));
    command.arg("--out").arg(out).args(resume.then_some("--resume"));
    let child = command.stdout(Stdio::null()).spawn();
    child.unwrap_or_else(|error| unreachable!("the program was built with this bench: {error}"))
}

/// What a sweep took.
#[derive(Default)]
struct Cost {
    seconds: f64,
    /// Of all threads; what others do on the machine changes it little.
    processor: f64,
    /// Most memory, MiB.
    memory: f64,
}

/// Waits for a sweep.
fn wait(mut child: Child) -> Cost {
    let start = Instant::now();
    let mut cost = Cost::default();
    while matches!(child.try_wait(), Ok(None)) {
        cost.memory = cost.memory.max(memory(child.id()));
        cost.processor = cost.processor.max(processor(child.id()));
        std::thread::sleep(Duration::from_millis(20));
    }
    cost.seconds = start.elapsed().as_secs_f64();
    cost
}

/// Processor seconds of a process so far, in hundredths; zero where the system does not tell.
fn processor(process: u32) -> f64 {
    let stat = std::fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
    let behind_name = stat.rsplit(')').next().unwrap_or_default();
    let ticks = behind_name.split_whitespace().skip(11).take(2).filter_map(|ticks| ticks.parse::<f64>().ok());
    ticks.sum::<f64>() / 100.0
}

/// Most memory a process has had, MiB; zero where the system does not tell.
fn memory(process: u32) -> f64 {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kib.unwrap_or(0.0) / 1024.0
}

fn lines(path: &Path) -> usize {
    std::fs::read(path).map_or(0, |text| text.iter().filter(|byte| **byte == b'\n').count())
}

fn main() {
    let wanted = std::env::args().filter_map(|argument| argument.parse().ok()).next().unwrap_or(10_000);
    let side = ((wanted / TORQUES) as f64).sqrt().round().max(1.0) as usize;
    let points = side * side * TORQUES;
    let folder = tempfile::tempdir().unwrap_or_else(|error| unreachable!("no temporary folder: {error}"));
    let path = |name: &str| folder.path().join(name);

    let mut rates = Vec::new();
    for jobs in ["1", "2"] {
        let cost = wait(sweep(side, jobs, &path(&format!("{jobs}.csv")), false));
        let rate = points as f64 / cost.seconds;
        let each = 1e3 * cost.processor / points as f64;
        println!(
            "{points} points, {jobs} jobs: {:.1} s, {rate:.0} points/s; {:.1} processor seconds, {each:.2} ms a point; \
            {:.0} MiB",
            cost.seconds, cost.processor, cost.memory
        );
        rates.push((rate, cost.processor));
    }
    if let [(one, once), (two, twice)] = rates[..] {
        println!(
            "two jobs against one: {:.2} times as fast, {:.2} times the processor seconds",
            two / one,
            twice / once
        );
    }

    let mut child = sweep(side, "2", &path("killed.csv"), false);
    while lines(&path("killed.csv.journal")) < points / 2 && matches!(child.try_wait(), Ok(None)) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let killed = child.kill().is_ok() && child.wait().is_ok();
    let rows = lines(&path("killed.csv.journal"));
    let seconds = wait(sweep(side, "2", &path("killed.csv"), true)).seconds;
    let whole = std::fs::read(path("1.csv")).unwrap_or_default();
    let same = |name: &str| !whole.is_empty() && std::fs::read(path(name)).is_ok_and(|bytes| bytes == whole);
    println!("killed ({killed}) after {rows} lines, resumed in {seconds:.1} s");
    println!("same file: two jobs {}, killed and resumed {}", same("2.csv"), same("killed.csv"));
    let text = String::from_utf8_lossy(&whole);
    println!("points without a solution: {}", text.lines().skip(1).filter(|line| !line.contains(",true,")).count());
}
