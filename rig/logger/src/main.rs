//! `sheave-rig`: runs the dynamometer, or a simulated one.

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::{Arc, Mutex};

use clap::{Parser, Subcommand};
use rig_logger::calibration::{Calibration, last_of_csv};
use rig_logger::hardware::Hardware;
use rig_logger::interlock::{Cause, Command};
use rig_logger::journal::Recorder;
use rig_logger::session::{OperatingLimits, Session, Status};
use rig_logger::simulated::SimulatedRig;
use rig_logger::steady::{Operator, Plan, run};
use rig_logger::{runs, web};

/// The dynamometer: automated steady-state test, recording, replay.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Run the steady-state test on the simulated rig and record it in a new folder.
    Simulate {
        /// Where the run's folder is made.
        #[arg(long, default_value = "runs")]
        out: PathBuf,
        /// Let time pass as it does outside instead of as fast as can be.
        #[arg(long)]
        real_time: bool,
        /// Calibration: a file as the thesis's cal_values.csv, whose last row counts.
        #[arg(long)]
        calibration: Option<PathBuf>,
        /// How long the brake moves for each step, ms.
        #[arg(long, default_value_t = 50)]
        brake_step: u64,
        /// How long each operating point is read, s.
        #[arg(long, default_value_t = 3.0)]
        read: f64,
        /// How often the whole test is repeated.
        #[arg(long, default_value_t = 1)]
        passes: u32,
        /// Show the state on a read-only page at this port of 127.0.0.1.
        #[arg(long)]
        web: Option<u16>,
    },
    /// Make the files that `sheave dyno` reads from a run's journal, also after a power cut.
    Export {
        /// The run's folder.
        run: PathBuf,
    },
    /// Show a recorded run again, one line a second.
    Replay {
        /// The run's folder.
        run: PathBuf,
    },
}

struct Shown(Arc<Mutex<Status>>);

impl Operator for Shown {
    fn command(&mut self, status: &Status) -> Option<Command> {
        if let Ok(mut shown) = self.0.lock() {
            shown.clone_from(status);
        }
        None
    }
}

fn main() -> ExitCode {
    match task(Arguments::parse().command) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(1)
        }
    }
}

fn task(task: Task) -> Result<ExitCode, Box<dyn std::error::Error>> {
    match task {
        Task::Simulate { out, real_time, calibration, brake_step, read, passes, web } => {
            if !(read.is_finite() && read > 0.0 && read <= 3600.0) || brake_step == 0 {
                return Err("--read must be within 0 to 3600 s and --brake-step at least 1 ms".into());
            }
            let calibration = match calibration {
                Some(path) => last_of_csv(&std::fs::read_to_string(&path)?)
                    .ok_or_else(|| format!("{}: the last row is not slope,intercept,R2", path.display()))?,
                None => Calibration::THESIS,
            };
            let plan = Plan { brake_step_ms: brake_step, read_ms: (read * 1e3) as u64, passes, ..Plan::THESIS };
            simulate(&out, real_time, calibration, &plan, web)
        }
        Task::Export { run } => {
            let done = runs::export(&run)?;
            println!("{} frames, {} operating points, {} incomplete lines", done.frames, done.points, done.bad_lines);
            Ok(ExitCode::SUCCESS)
        }
        Task::Replay { run } => {
            rig_logger::replay::replay(&run, &mut std::io::stdout().lock())?;
            Ok(ExitCode::SUCCESS)
        }
    }
}

fn simulate(
    out: &std::path::Path,
    real_time: bool,
    calibration: Calibration,
    plan: &Plan,
    port: Option<u16>,
) -> Result<ExitCode, Box<dyn std::error::Error>> {
    let mut rig = SimulatedRig::new(real_time);
    let folder = runs::create(out, &runs::Metadata::now("simulated", &rig.identity()?, calibration))?;
    println!("recording in {}", folder.display());
    let recorder = Recorder::create(&folder)?;
    let mut session = Session::new(rig, calibration, OperatingLimits::RIG, recorder);
    let shown = Arc::new(Mutex::new(session.status().clone()));
    if let Some(port) = port {
        println!("http://{}/", web::serve(port, Arc::clone(&shown))?);
    }
    let points = run(&mut session, plan, &mut Shown(shown));
    let seconds = session.status().time as f64 * 1e-6;
    let (cause, message) = (session.cause(), session.status().message.clone());
    let (_, written) = session.finish();
    let exported = runs::export(&folder)?;
    runs::write_points(&folder, &points)?;
    println!("{} operating points in {seconds:.0} s, {} frames", points.len(), exported.frames);
    if !written {
        return Err("the recording is not complete: the disk is full or gone".into());
    }
    Ok(match cause {
        None | Some(Cause::Ended) => ExitCode::SUCCESS,
        Some(_) => {
            eprintln!("{message}");
            ExitCode::from(3)
        }
    })
}
