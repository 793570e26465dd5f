//! Faults that must cost nothing: kills, two sweeps at once, files of other people, damaged journals, full disks,
//! closed pipes. Prints one line for each; `SHEAVE_FAULTS=60 cargo test --test faults` tries each kill sixty times.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::study::{Axis, Cell, Format, Journal, JournalError, Row, Rows, Study, table};
use std::io::{BufRead, BufReader, Read};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Output, Stdio};
use std::time::Duration;

type Fault = (&'static str, fn(&Path) -> String);

const FAULTS: &[Fault] = &[
    ("a sweep killed at any moment is completed to the same file", killed),
    ("a second sweep on one file is refused", second),
    ("what is no journal is left alone", foreign),
    ("a journal cut anywhere is gone on with", truncated),
    ("a journal with a digit flipped anywhere costs that line and no wrong row", flipped),
    ("journals of ended sweeps are kept, each under its number", old_journals),
    ("an earlier table is kept, and an equal one not twice", old_tables),
    ("a symbolic link as output is followed, a folder and a dangling link are refused", outputs),
    ("the user's mask and the old file's permissions hold", permissions),
    ("a full disk loses nothing that was solved", full_disk),
    ("a closed pipe stops a sweep", closed_pipe),
    ("a full or closed standard error changes no exit status", full_stderr),
    ("a sweep of which no point is solved is status 3", nothing_solved),
    ("many rows take little memory", memory),
];

fn main() -> ExitCode {
    let mut failed = 0;
    let only = std::env::args().skip(1).find(|argument| !argument.starts_with('-')).unwrap_or_default();
    for (name, fault) in FAULTS.iter().filter(|(name, _)| name.contains(&only)) {
        let folder = tempfile::tempdir().unwrap();
        match catch_unwind(AssertUnwindSafe(|| fault(folder.path()))) {
            Ok(said) => println!("ok      {name}: {said}"),
            Err(_) => {
                failed += 1;
                println!("FAILED  {name}");
            }
        }
    }
    println!("{} faults, {failed} failed", FAULTS.len());
    ExitCode::from(u8::from(failed > 0))
}

/// How often what depends on chance is tried.
fn trials(quick: usize) -> usize {
    std::env::var("SHEAVE_FAULTS").ok().and_then(|text| text.parse().ok()).unwrap_or(quick)
}

fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.args(arguments).env_remove("RUST_LOG").env("NO_COLOR", "1").stdin(Stdio::null());
    command
}

fn sweep(arguments: &[&str]) -> Output {
    program(&[&["sweep", "--tol", "1e-1"], arguments].concat()).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn text(path: &Path) -> &str {
    path.to_str().unwrap()
}

const QUICK: [&str; 2] = ["--over", "drive.ratio=1,1.1"];

/// A small study with its rows, and the path of a journal.
fn study() -> Study {
    let axes = [Axis::parse("drive.ratio=0.9..1.1:5").unwrap()];
    Study::new(Case::base(), axes, SolveOptions { tolerance: 1e-1, ..SolveOptions::default() }).unwrap()
}

fn rows(study: &Study) -> Vec<Row> {
    let table = table(study, Some(1)).unwrap();
    let row = |(index, cells): (usize, &Vec<Cell>)| Row { index, columns: table.columns.clone(), cells: cells.clone() };
    table.rows.iter().enumerate().map(row).collect()
}

fn journal_of(path: &Path, study: &Study, rows: &[Row]) -> Vec<u8> {
    let (mut journal, _) = Journal::begin(path, study).unwrap();
    rows.iter().for_each(|row| journal.add(row.clone()).unwrap());
    drop(journal);
    std::fs::read(path).unwrap()
}

fn killed(folder: &Path) -> String {
    let grid =
        ["--over", "drive.ratio=0.8,1.2", "--over", "operating_point.slack_tension=100..200 N:300", "--jobs", "2"];
    let (whole, out) = (folder.join("whole.csv"), folder.join("ended.csv"));
    assert!(sweep(&[&grid[..], &["--out", text(&whole)]].concat()).status.success());
    let whole = std::fs::read(whole).unwrap();
    let trials = trials(3);
    let mut kills = 0;
    for trial in 0..trials {
        let mut resumes = 0;
        loop {
            let arguments = [&["sweep", "--tol", "1e-1"], &grid[..], &["--out", text(&out), "--resume"]].concat();
            let mut child = program(&arguments).stderr(Stdio::null()).spawn().unwrap();
            // Early, late and in between; in the end it is let finish.
            std::thread::sleep(Duration::from_millis(20 + 60 * (trial as u64 % 7) + 40 * resumes));
            if resumes < 6 {
                let _ = child.kill();
            }
            resumes += 1;
            if child.wait().unwrap().success() {
                break;
            }
            kills += 1;
        }
        assert!(std::fs::read(&out).unwrap() == whole, "another table");
        std::fs::remove_file(&out).unwrap();
        assert_eq!(std::fs::read_dir(folder).unwrap().count(), 1, "something is left over");
    }
    assert!(kills >= trials, "{kills} kills: the sweeps were over before");
    format!("{kills} kills in {trials} sweeps")
}

fn second(folder: &Path) -> String {
    let out = folder.join("a.csv");
    let journal = folder.join("a.csv.journal");
    let study = study();
    let (mut held, _) = Journal::begin(&journal, &study).unwrap();
    held.add(rows(&study).remove(0)).unwrap();
    let before = std::fs::read(&journal).unwrap();
    for resume in [&[][..], &["--resume"]] {
        let output = sweep(&[&QUICK[..], &["--out", text(&out)], resume].concat());
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(said(&output).contains("another sweep is writing"), "{output:?}");
    }
    assert!(std::fs::read(&journal).unwrap() == before && !out.exists());
    // And really two at once, over and over: one of them does it, neither spoils it.
    drop(held);
    std::fs::remove_file(&journal).unwrap();
    let mut refused = 0;
    let trials = trials(4);
    for _ in 0..trials {
        let arguments = [&["sweep", "--tol", "1e-1"], &QUICK[..], &["--out", text(&out), "--resume"]].concat();
        let children = [0, 1].map(|_| program(&arguments).stderr(Stdio::null()).spawn().unwrap());
        for mut child in children {
            match child.wait().unwrap().code() {
                Some(0) => {}
                Some(2) => refused += 1,
                other => panic!("{other:?}"),
            }
        }
        assert!(!journal.exists());
    }
    format!("with and without --resume; of {trials} pairs at once {refused} refused")
}

fn foreign(folder: &Path) -> String {
    let (out, journal) = (folder.join("z.csv"), folder.join("z.csv.journal"));
    let precious = folder.join("precious");
    for content in ["precious", "", "{\"version\":1}\n", "sheave-sweep-journal 2 00000000 {}\n"] {
        for linked in [false, true] {
            std::fs::write(&precious, content).unwrap();
            if linked {
                #[cfg(unix)]
                std::os::unix::fs::symlink(&precious, &journal).unwrap();
                #[cfg(not(unix))]
                continue;
            } else {
                std::fs::write(&journal, content).unwrap();
            }
            for resume in [&["--resume"][..], &[]] {
                let ours = content.starts_with("sheave") && resume.is_empty();
                if (content.is_empty() || ours) && !linked {
                    // Nothing to lose, or the beginning of a journal, which is set aside.
                    continue;
                }
                let output = sweep(&[&QUICK[..], &["--out", text(&out)], resume].concat());
                assert_eq!(output.status.code(), Some(2), "{content:?} {linked} {resume:?}: {output:?}");
                assert!(said(&output).contains("left alone"), "{output:?}");
                assert_eq!(std::fs::read_to_string(&journal).unwrap(), content);
                assert_eq!(std::fs::read_to_string(&precious).unwrap(), content);
            }
            std::fs::remove_file(&journal).unwrap();
        }
    }
    std::fs::create_dir(&journal).unwrap();
    assert_eq!(sweep(&[&QUICK[..], &["--out", text(&out), "--resume"]].concat()).status.code(), Some(2));
    std::fs::remove_dir(&journal).unwrap();
    #[cfg(unix)]
    {
        assert!(Command::new("mkfifo").arg(&journal).status().unwrap().success());
        assert_eq!(sweep(&[&QUICK[..], &["--out", text(&out), "--resume"]].concat()).status.code(), Some(2));
    }
    "texts, links, a folder, a pipe".into()
}

fn truncated(folder: &Path) -> String {
    let (path, study) = (folder.join("journal"), study());
    let rows = rows(&study);
    let whole = journal_of(&path, &study, &rows);
    let header = whole.iter().position(|byte| *byte == b'\n').unwrap();
    let (mut kept, step) = (0, 97);
    for length in (0..=whole.len()).step_by(step).chain([header, header + 1, whole.len()]) {
        std::fs::write(&path, &whole[..length]).unwrap();
        let mut journal = Journal::resume(&path, &study).unwrap();
        assert!(journal.damaged().is_empty());
        kept = kept.max(journal.len());
        rows.iter().for_each(|row| journal.add(row.clone()).unwrap());
        check_rows(&journal.finish().unwrap(), &rows);
    }
    assert_eq!(kept, rows.len());
    format!("{} places in {} bytes", whole.len() / step + 3, whole.len())
}

fn check_rows(found: &dyn Rows, expected: &[Row]) {
    let mut index = 0;
    found
        .each(&mut |cells| {
            assert_eq!(cells, expected[index].cells);
            index += 1;
            Ok(())
        })
        .unwrap();
    assert_eq!(index, expected.len());
}

fn flipped(folder: &Path) -> String {
    let (path, study) = (folder.join("journal"), study());
    let rows = rows(&study);
    let whole = journal_of(&path, &study, &rows);
    let header = whole.iter().position(|byte| *byte == b'\n').unwrap();
    let mut tried = 0;
    for at in (header + 1..whole.len()).filter(|at| whole[*at].is_ascii_digit()).step_by(101) {
        let mut damaged = whole.clone();
        damaged[at] = if damaged[at] == b'7' { b'8' } else { b'7' };
        std::fs::write(&path, &damaged).unwrap();
        let mut journal = Journal::resume(&path, &study).unwrap();
        let line = 1 + whole[..at].iter().filter(|byte| **byte == b'\n').count();
        assert_eq!(journal.damaged(), [line]);
        // Names stand twice; of rows, one is lost.
        assert_eq!(journal.len(), if line <= 3 { rows.len() } else { rows.len() - 1 }, "line {line}");
        rows.iter().for_each(|row| journal.add(row.clone()).unwrap());
        check_rows(&journal.finish().unwrap(), &rows);
        tried += 1;
    }
    // A first line that is damaged says nothing of whose journal this is.
    let mut damaged = whole.clone();
    damaged[header - 3] ^= 1;
    std::fs::write(&path, &damaged).unwrap();
    assert!(matches!(Journal::resume(&path, &study), Err(JournalError::Foreign { .. })));
    assert!(std::fs::read(&path).unwrap() == damaged);
    format!("{tried} digits")
}

fn old_journals(folder: &Path) -> String {
    let (out, journal, study) = (folder.join("a.csv"), folder.join("a.csv.journal"), study());
    let rows = rows(&study);
    let mut contents = Vec::new();
    for count in 1..=3 {
        contents.push(journal_of(&journal, &study, &rows[..count]));
    }
    let output = sweep(&[&QUICK[..], &["--out", text(&out)]].concat());
    assert!(output.status.success() && said(&output).contains("a.csv.journal.old.3"), "{output:?}");
    for (number, content) in contents.iter().enumerate() {
        assert!(std::fs::read(folder.join(format!("a.csv.journal.old.{}", number + 1))).unwrap() == *content);
    }
    format!("{} journals", contents.len())
}

fn old_tables(folder: &Path) -> String {
    let out = folder.join("a.csv");
    let run = |grid: &[&str]| {
        let output = sweep(&[grid, &["--out", text(&out)]].concat());
        assert!(output.status.success(), "{output:?}");
        said(&output)
    };
    assert_eq!(run(&QUICK), "");
    let first = std::fs::read(&out).unwrap();
    assert_eq!(run(&QUICK), "");
    assert!(run(&["--over", "drive.ratio=1,1.2"]).contains("a.csv.old.1"));
    assert!(std::fs::read(folder.join("a.csv.old.1")).unwrap() == first);
    assert!(run(&QUICK).contains("a.csv.old.2"));
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 3);
    "two different, one equal".into()
}

#[cfg(unix)]
fn outputs(folder: &Path) -> String {
    use std::os::unix::fs::symlink;
    let (target, link) = (folder.join("target.csv"), folder.join("link.csv"));
    std::fs::write(&target, "old").unwrap();
    symlink(&target, &link).unwrap();
    assert!(sweep(&[&QUICK[..], &["--out", text(&link)]].concat()).status.success());
    assert!(std::fs::symlink_metadata(&link).unwrap().file_type().is_symlink());
    assert!(std::fs::read_to_string(&target).unwrap().starts_with("drive.ratio"));
    assert_eq!(std::fs::read_to_string(folder.join("target.csv.old.1")).unwrap(), "old");
    let (dangling, directory) = (folder.join("dangling.csv"), folder.join("folder.csv"));
    symlink(folder.join("nowhere"), &dangling).unwrap();
    std::fs::create_dir(&directory).unwrap();
    for (out, reason) in [(&dangling, "leads nowhere"), (&directory, "is a folder")] {
        let output = sweep(&[&QUICK[..], &["--out", text(out)]].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(said(&output).contains(reason), "{output:?}");
    }
    // Results of one case, too.
    let (results, elsewhere) = (folder.join("results"), folder.join("elsewhere.json"));
    std::fs::create_dir(&results).unwrap();
    std::fs::write(&elsewhere, "").unwrap();
    symlink(&elsewhere, results.join("result.json")).unwrap();
    assert!(program(&["solve", "--tol", "1e-1", "--out", text(&results)]).output().unwrap().status.success());
    assert!(std::fs::read_to_string(&elsewhere).unwrap().contains("\"converged\": true"));
    "sweep and solve".into()
}

#[cfg(not(unix))]
fn outputs(_: &Path) -> String {
    "not tried: no symbolic links here".into()
}

#[cfg(unix)]
fn permissions(folder: &Path) -> String {
    use std::os::unix::fs::PermissionsExt;
    let out = folder.join("a.csv");
    let mode = || std::fs::metadata(&out).unwrap().permissions().mode() & 0o777;
    let run = |mask: &str, grid: &str| {
        let command = format!("umask {mask}; exec \"$@\"");
        let mut shell = Command::new("sh");
        shell.args(["-c", &command, "sh", env!("CARGO_BIN_EXE_sheave"), "sweep", "--tol", "1e-1", "--over", grid]);
        assert!(shell.args(["--out", text(&out)]).output().unwrap().status.success());
    };
    run("027", "drive.ratio=1,1.1");
    assert_eq!(mode(), 0o640);
    std::fs::remove_file(&out).unwrap();
    run("022", "drive.ratio=1,1.1");
    assert_eq!(mode(), 0o644);
    std::fs::set_permissions(&out, std::fs::Permissions::from_mode(0o600)).unwrap();
    run("022", "drive.ratio=1,1.2");
    assert_eq!(mode(), 0o600);
    "027, 022, and 600 kept".into()
}

#[cfg(not(unix))]
fn permissions(_: &Path) -> String {
    "not tried: no such permissions here".into()
}

fn full_disk(folder: &Path) -> String {
    // A limit on the size of files stands in for a full disk.
    if !cfg!(unix) {
        return "not tried here".into();
    }
    let out = folder.join("a.csv");
    let grid = ["--over", "operating_point.slack_tension=100..200 N:40"];
    let whole = folder.join("whole.csv");
    assert!(sweep(&[&grid[..], &["--out", text(&whole)]].concat()).status.success());
    let mut shell = Command::new("sh");
    let limited = "trap '' XFSZ; ulimit -f 40; exec \"$@\"";
    shell.args(["-c", limited, "sh", env!("CARGO_BIN_EXE_sheave"), "sweep", "--tol", "1e-1"]).args(grid);
    let output = shell.args(["--out", text(&out)]).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let kept = std::fs::metadata(folder.join("a.csv.journal")).unwrap().len();
    assert!(kept > 0 && !out.exists());
    assert!(sweep(&[&grid[..], &["--out", text(&out), "--resume"]].concat()).status.success());
    assert!(std::fs::read(&out).unwrap() == std::fs::read(&whole).unwrap());
    format!("ended with {kept} bytes of journal, completed after it")
}

fn closed_pipe(_: &Path) -> String {
    // So many points that it would run for minutes.
    let mut child = program(&["sweep", "--tol", "1e-1", "--over", "operating_point.slack_tension=100..200 N:20000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let mut reader = BufReader::new(child.stdout.take().unwrap());
    let mut line = String::new();
    for _ in 0..3 {
        line.clear();
        reader.read_line(&mut line).unwrap();
    }
    assert!(line.contains("true"), "rows come while the sweep runs: {line}");
    drop(reader);
    assert_eq!(child.wait().unwrap().code(), Some(1));
    "after two rows of 20,000".into()
}

fn full_stderr(_: &Path) -> String {
    if !Path::new("/dev/full").exists() {
        return "not tried: there is no /dev/full here".into();
    }
    let full = || Stdio::from(std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap());
    let cases: [(&[&str], i32); 5] = [
        (&["solve", "--set", "a=b"], 2),
        (&["solve", "--frobnicate"], 2),
        (&["sweep", "--over", "drive.ratio"], 2),
        (&["solve", "--tol", "1e-1", "--edition", "published", "--json"], 0),
        (&["solve", "--tol", "1e-1", "--set", "operating_point.slack_tension=1 N", "--edition", "thesis"], 3),
    ];
    for (arguments, status) in cases {
        let output = program(arguments).stderr(full()).output().unwrap();
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
        let quoted = arguments.iter().map(|argument| format!("'{argument}'")).collect::<Vec<_>>().join(" ");
        let closed = format!("\"$0\" {quoted} >/dev/null 2>&-");
        let closed = Command::new("sh").args(["-c", &closed, env!("CARGO_BIN_EXE_sheave")]).status().unwrap();
        assert_eq!(closed.code(), Some(status), "{arguments:?}");
    }
    let output = program(&["keys"]).stdout(full()).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    format!("{} commands", cases.len())
}

fn nothing_solved(folder: &Path) -> String {
    let out = folder.join("a.csv");
    let grid = ["--over", "drive.primary_radius=150,160 mm"];
    for to in [&[][..], &["--out", text(&out)]] {
        let output = sweep(&[&grid[..], to].concat());
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        assert!(said(&output).contains("none of the 2 points"), "{output:?}");
        let table = if to.is_empty() { output.stdout } else { std::fs::read(&out).unwrap() };
        assert_eq!(String::from_utf8(table).unwrap().matches("overlap").count(), 2);
    }
    "on standard output and in a file".into()
}

/// Most memory that this process ever had, MiB.
fn most_memory() -> Option<usize> {
    let mut status = String::new();
    std::fs::File::open("/proc/self/status").ok()?.read_to_string(&mut status).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().trim_end_matches("kB").trim().parse::<usize>().ok()? / 1024)
}

/// Rows as wide as those of a result go through the journal into a table: `SHEAVE_ROWS=1000000` for a large one.
fn memory(folder: &Path) -> String {
    let rows = std::env::var("SHEAVE_ROWS").ok().and_then(|text| text.parse().ok()).unwrap_or(20_000);
    let axes = [Axis::parse(&format!("operating_point.slack_tension=100..200 N:{rows}")).unwrap()];
    let study = Study::new(Case::base(), axes, SolveOptions::default()).unwrap();
    let one = Study::new(Case::base(), [Axis::parse("drive.ratio=1,1").unwrap()], SolveOptions::default()).unwrap();
    let template = table(&one, Some(1)).unwrap();
    let (columns, cells) = (template.columns.clone(), template.rows[0].clone());
    let path = folder.join("a.csv.journal");
    let (mut journal, _) = Journal::begin(&path, &study).unwrap();
    for index in (0..rows).rev() {
        let mut cells = cells.clone();
        cells[0] = Cell::Number((index as u64).into());
        journal.add(Row { index, columns: columns.clone(), cells }).unwrap();
    }
    let journal_size = std::fs::metadata(&path).unwrap().len() >> 20;
    let stored = journal.finish().unwrap();
    let mut out: Vec<PathBuf> = Vec::new();
    for name in ["a.csv", "a.parquet"] {
        let path = folder.join(name);
        let mut file = std::fs::File::create(&path).unwrap();
        Format::of(&path).unwrap().write(&stored, &mut file).unwrap();
        out.push(path);
    }
    stored.remove().unwrap();
    let lines = BufReader::new(std::fs::File::open(&out[0]).unwrap()).lines().count();
    assert_eq!(lines, rows + 1);
    let Some(most) = most_memory() else { return "memory is not told here".into() };
    assert!(most <= 300, "{most} MiB");
    format!("{rows} rows of {} columns, {journal_size} MiB of journal: {most} MiB at most", columns.len())
}
