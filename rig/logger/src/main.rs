//! `sheave-rig`: runs the dynamometer, or a simulated one.

use std::io::BufRead;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex};

use clap::{Args, Parser, Subcommand};
use rig_logger::calibrate::{self, Rope};
use rig_logger::calibration::{Calibration, last_of_csv};
use rig_logger::hardware::Hardware;
use rig_logger::interlock::{Cause, Command};
use rig_logger::journal::Recorder;
use rig_logger::session::{OperatingLimits, Session, Status};
use rig_logger::simulated::SimulatedRig;
use rig_logger::steady::{Operator, Plan, run};
use rig_logger::{old_runs, runs, web};

/// The dynamometer: automated steady-state test, calibration, recording, replay.
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
        /// Let time pass as it does outside instead of as fast as can be.
        #[arg(long)]
        real_time: bool,
        #[command(flatten)]
        test: Test,
    },
    /// Run the steady-state test on the real rig and record it in a new folder.
    #[cfg(feature = "linux")]
    Run {
        #[command(flatten)]
        test: Test,
        #[command(flatten)]
        wiring: Wiring,
    },
    /// Calibrate the torque sensor with known weights on a rope around the brake's rotor.
    Calibrate {
        /// A mass, kg; give at least two, 0 among them.
        #[arg(long = "mass", required = true, num_args = 1.., value_parser = mass)]
        masses: Vec<f64>,
        /// Radius at which the rope leaves the rotor, m.
        #[arg(long, value_parser = radius)]
        radius: f64,
        /// The line is added to this file as its last row; the readings stay in a file of their own beside it.
        #[arg(long, default_value = "cal_values.csv")]
        out: PathBuf,
        /// Calibrate the simulated rig.
        #[cfg_attr(not(feature = "linux"), arg(long, required = true))]
        #[cfg_attr(feature = "linux", arg(long))]
        simulated: bool,
        #[cfg(feature = "linux")]
        #[command(flatten)]
        wiring: Wiring,
    },
    /// Make the files that `sheave dyno` reads from a run's journal, also after a power cut; of an old run with the
    /// files of Appendix H, its operating points.
    Export {
        /// The run's folder.
        run: PathBuf,
        /// For an old run: its calibration, a file as the thesis's cal_values.csv.
        #[arg(long)]
        calibration: Option<PathBuf>,
        /// For an old run: where its points are written, a file that does not exist yet.
        #[arg(long, default_value = "points.csv")]
        points: PathBuf,
    },
    /// Show a recorded run again, one line a second; also an old run with the files of Appendix H.
    Replay {
        /// The run's folder.
        run: PathBuf,
        /// For an old run: its calibration, a file as the thesis's cal_values.csv.
        #[arg(long)]
        calibration: Option<PathBuf>,
    },
}

#[derive(Args)]
struct Test {
    /// Where the run's folder is made.
    #[arg(long, default_value = "runs")]
    out: PathBuf,
    /// Calibration: a file as the thesis's cal_values.csv, whose last row counts; without it, that of the thesis.
    #[arg(long)]
    calibration: Option<PathBuf>,
    /// How long the brake moves for each step, ms.
    #[arg(long, default_value_t = 50, value_parser = clap::value_parser!(u64).range(1..=5000))]
    brake_step: u64,
    /// How long each operating point is read, s.
    #[arg(long, default_value_t = 3.0, value_parser = seconds)]
    read: f64,
    /// How often the whole test is repeated.
    #[arg(long, default_value_t = 1)]
    passes: u32,
    /// Show the state on a read-only page at this port of 127.0.0.1.
    #[arg(long)]
    web: Option<u16>,
    /// Show the state in the terminal; s stops, g opens the throttle where that is asked for.
    #[cfg(feature = "display")]
    #[arg(long)]
    display: bool,
}

/// Where the real rig is wired to.
#[cfg(feature = "linux")]
#[derive(Args)]
struct Wiring {
    /// The I2C bus.
    #[arg(long, default_value = "/dev/i2c-1")]
    bus: PathBuf,
    /// The chip of the lines of brake and emergency stop.
    #[arg(long, default_value = "/dev/gpiochip0")]
    lines: PathBuf,
    /// Folder of the servo's pulse-width output.
    #[arg(long, default_value = "/sys/class/pwm/pwmchip0/pwm0")]
    servo: PathBuf,
}

fn within(text: &str, least: f64, most: f64) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| format!("'{text}' is no number"))?;
    if (least..=most).contains(&value) { Ok(value) } else { Err(format!("it must be within {least} and {most}")) }
}

fn seconds(text: &str) -> Result<f64, String> {
    within(text, 0.1, 3600.0)
}

fn mass(text: &str) -> Result<f64, String> {
    within(text, 0.0, 500.0)
}

fn radius(text: &str) -> Result<f64, String> {
    within(text, 0.005, 1.0)
}

/// Passes the state on to the displays, and what the operator asks for back.
struct Shown {
    status: Arc<Mutex<Status>>,
    commands: Receiver<Command>,
}

impl Operator for Shown {
    fn command(&mut self, status: &Status) -> Option<Command> {
        // A display that is just looking is passed by: the interlock does not wait for it.
        if let Ok(mut shown) = self.status.try_lock() {
            shown.clone_from(status);
        }
        self.commands.try_recv().ok()
    }
}

type Failure = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    match task(Arguments::parse().command) {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(1)
        }
    }
}

fn task(task: Task) -> Result<ExitCode, Failure> {
    match task {
        Task::Simulate { real_time, test } => record(SimulatedRig::new(real_time), "simulated", &test),
        #[cfg(feature = "linux")]
        Task::Run { test, wiring } => record(open(wiring)?, "linux", &test),
        Task::Calibrate {
            masses,
            radius,
            out,
            simulated,
            #[cfg(feature = "linux")]
            wiring,
        } => {
            let rope = Rope { radius, gears: (32.0, 61.0) };
            if simulated {
                return calibrate(SimulatedRig::new(false), &masses, rope, &out, |rig, torque| {
                    rig.hung_load = Some(torque);
                    let settled = rig.now() + 500_000;
                    rig.wait_until(settled);
                    Ok(())
                });
            }
            #[cfg(feature = "linux")]
            return calibrate(open(wiring)?, &masses, rope, &out, |_, _| {
                let mut line = String::new();
                std::io::stdin().lock().read_line(&mut line)?;
                Ok(())
            });
            #[cfg(not(feature = "linux"))]
            Err("this program was built without the feature `linux`: only --simulated can be calibrated".into())
        }
        Task::Export { run, calibration, points } => {
            if old_runs::is_one(&run) {
                let calibration = calibration_of(calibration.as_deref())?;
                let read: Vec<_> = old_runs::read(&run)?.iter().map(|point| point.reduce(&calibration)).collect();
                runs::write_new(&points, &runs::points_table(&read))?;
                println!("{} operating points in {}", read.len(), points.display());
                return Ok(ExitCode::SUCCESS);
            }
            let done = runs::export(&run)?;
            println!("{} frames, {} operating points, {} incomplete lines", done.frames, done.points, done.bad_lines);
            Ok(ExitCode::SUCCESS)
        }
        Task::Replay { run, calibration } => {
            let output = &mut std::io::stdout().lock();
            if old_runs::is_one(&run) {
                old_runs::replay(&run, &calibration_of(calibration.as_deref())?, output)?;
            } else {
                rig_logger::replay::replay(&run, output)?;
            }
            Ok(ExitCode::SUCCESS)
        }
    }
}

#[cfg(feature = "linux")]
fn open(wiring: Wiring) -> Result<rig_logger::wired::LinuxRig, Failure> {
    use rig_logger::wired::{Devices, open};
    let Wiring { bus, lines, servo } = wiring;
    Ok(open(&Devices { bus, lines, servo, ..Devices::default() })?)
}

fn calibration_of(file: Option<&Path>) -> Result<Calibration, Failure> {
    let Some(path) = file else { return Ok(Calibration::THESIS) };
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(last_of_csv(&text).map_err(|error| format!("{}: {error}", path.display()))?)
}

/// Asks for one weight after the other and keeps the line through the readings.
fn calibrate<H: Hardware>(
    mut rig: H,
    masses: &[f64],
    rope: Rope,
    out: &Path,
    mut hang: impl FnMut(&mut H, f64) -> std::io::Result<()>,
) -> Result<ExitCode, Failure> {
    let ask = |rig: &mut H, mass: f64, torque: f64| {
        println!(
            "Hold the secondary and hang {mass} kg on the rope ({torque:.3} N·m at the secondary), then press Enter."
        );
        hang(rig, torque)
    };
    let tell = |values: &[u16]| {
        let mean = values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64;
        println!("  {} values, mean {mean:.1}", values.len());
    };
    let (fit, beside) = calibrate::run(&mut rig, masses, rope, out, ask, tell)?;
    println!(
        "ADC = ({:.3} ± {:.3}) T + ({:.1} ± {:.1}), R² = {:.6}, intervals at 95 %",
        fit.slope, fit.slope_interval, fit.intercept, fit.intercept_interval, fit.r_squared
    );
    println!("added to {}, readings in {}", out.display(), beside.display());
    Ok(ExitCode::SUCCESS)
}

fn record<H: Hardware>(mut rig: H, kind: &str, test: &Test) -> Result<ExitCode, Failure> {
    let calibration = calibration_of(test.calibration.as_deref())?;
    let plan = Plan {
        brake_step_ms: test.brake_step,
        read_ms: (test.read * 1e3) as u64,
        passes: test.passes,
        ask_before_opening: kind != "simulated",
        ..Plan::THESIS
    };
    let folder = runs::create(&test.out, &runs::Metadata::now(kind, &rig.identity()?, calibration))?;
    println!("recording in {}", folder.display());
    let recorder = Recorder::create(&folder)?;
    let limits = OperatingLimits::RIG;
    let mut session = Session::new(rig, calibration, limits, recorder);
    let (keys, commands) = channel();
    let shown = Shown { status: Arc::new(Mutex::new(session.status().clone())), commands };
    if let Some(port) = test.web {
        println!("http://{}/", web::serve(port, Arc::clone(&shown.status))?);
    }
    let points = operate(&mut session, &plan, shown, keys, test)?;
    let seconds = session.status().time as f64 * 1e-6;
    let (cause, message) = (session.cause(), session.status().message.clone());
    let (_, written) = session.finish();
    let exported = runs::export(&folder)?;
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

/// Runs the test with the display that was asked for.
fn operate<H: Hardware>(
    session: &mut Session<H>,
    plan: &Plan,
    mut shown: Shown,
    keys: std::sync::mpsc::Sender<Command>,
    test: &Test,
) -> Result<Vec<rig_logger::steady::Point>, Failure> {
    #[cfg(feature = "display")]
    if test.display {
        let _display = rig_logger::display::Display::start(Arc::clone(&shown.status), OperatingLimits::RIG, keys)?;
        return Ok(run(session, plan, &mut shown));
    }
    // Without the display a line on standard input does what its keys do.
    if plan.ask_before_opening {
        std::thread::spawn(move || {
            for line in std::io::stdin().lock().lines().map_while(Result::ok) {
                let command = if line.trim() == "g" { Command::Go } else { Command::Stop };
                if keys.send(command).is_err() {
                    break;
                }
            }
        });
        println!("Type g and Enter to open the throttle once the engine idles, anything else to stop.");
    }
    Ok(run(session, plan, &mut shown))
}
