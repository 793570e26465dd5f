//! What the commands share; each command has a file of its own.

mod belt;
mod bench_data;
mod beside;
mod case;
mod compare;
mod completions;
mod derive;
mod design;
mod drive;
mod dyno;
mod envelope;
mod init;
mod inverse;
mod keeping;
mod keys;
mod launch;
mod limit;
#[cfg(feature = "live")]
mod live;
mod map;
mod measured;
mod optimum;
mod output;
mod plot;
mod pulley;
mod radii;
mod reproduce;
mod schema;
mod shift;
mod size;
mod solve;
mod stop;
mod sweep;
mod tune;

use clap::{ArgAction, Parser, Subcommand};
use sheave::result::{FailureKind, FailureReport};
use sheave::text::printable;
use std::process::ExitCode;
use tracing_subscriber::filter::{LevelFilter, Targets};
use tracing_subscriber::layer::SubscriberExt;
use tracing_subscriber::util::SubscriberInitExt;

/// Rubber V-belt CVTs computed: axial forces, efficiency and belt path from one boundary value problem.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true, max_term_width = 110, after_help = STATUS)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// Say on standard error what is being done; twice for more, three times for everything
    #[arg(short, long, global = true, action = ArgAction::Count)]
    verbose: u8,
}

#[derive(Debug, Subcommand)]
enum Command {
    Solve(solve::Arguments),
    Beside(beside::Arguments),
    Drive(drive::Arguments),
    Shift(shift::Arguments),
    Launch(launch::Arguments),
    Sweep(sweep::Arguments),
    Plot(plot::Arguments),
    Limit(limit::Arguments),
    Optimum(optimum::Arguments),
    Map(map::Arguments),
    Tune(tune::Arguments),
    Ramp(inverse::RampArguments),
    Helix(inverse::HelixArguments),
    Reproduce(reproduce::Arguments),
    Derive(derive::Arguments),
    Init(init::Arguments),
    Pulley(pulley::Arguments),
    Size(size::Arguments),
    Belt(belt::Arguments),
    Radii(radii::Arguments),
    Dyno(dyno::Arguments),
    Compare(compare::Arguments),
    BenchData(bench_data::Arguments),
    Keys(keys::Arguments),
    Schema(schema::Arguments),
    Completions(completions::CompletionsArguments),
    Man(completions::ManArguments),
    #[cfg(feature = "live")]
    Live(live::Arguments),
}

/// What the exit status means.
const STATUS: &str = "\
Exit status: 0 solved; 2 bad input, nothing computed; 3 no solution found; 130 cancelled by Ctrl-C; 1 anything
else.
Results go to standard output, all else to standard error.";

/// Runs the command that the arguments name.
pub fn run() -> ExitCode {
    let asked = envelope::Asked::of_arguments();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(stop) => {
            if stop.use_stderr() {
                let message = printable(&stop.render().to_string()).into_owned();
                asked.tell(&FailureReport { kind: FailureKind::Usage, message, hint: None });
            }
            return misunderstood(&stop);
        }
    };
    log_to_stderr(arguments.verbose);
    // A panic is a defect of this program; its message is on standard error by then.
    let outcome = std::panic::catch_unwind(|| match &arguments.command {
        Command::Solve(arguments) => in_order(|| solve::run(arguments)),
        Command::Drive(arguments) => in_order(|| drive::run(arguments)),
        Command::Shift(arguments) => in_order(|| shift::run(arguments)),
        Command::Launch(arguments) => in_order(|| launch::run(arguments)),
        Command::Beside(arguments) => in_order(|| beside::run(arguments)),
        Command::Sweep(arguments) => in_order(|| sweep::run(arguments)),
        Command::Plot(arguments) => plot::run(arguments),
        Command::Limit(arguments) => in_order(|| limit::run(arguments)),
        Command::Optimum(arguments) => in_order(|| optimum::run(arguments)),
        Command::Map(arguments) => in_order(|| map::run(arguments)),
        Command::Tune(arguments) => in_order(|| tune::run(arguments)),
        Command::Ramp(arguments) => in_order(|| inverse::ramp(arguments)),
        Command::Helix(arguments) => in_order(|| inverse::helix(arguments)),
        Command::Reproduce(arguments) => in_order(|| reproduce::run(arguments)),
        Command::Derive(arguments) => derive::run(arguments),
        Command::Init(arguments) => init::run(arguments),
        Command::Pulley(arguments) => in_order(|| pulley::run(arguments)),
        Command::Size(arguments) => size::run(arguments),
        Command::Belt(arguments) => in_order(|| belt::run(arguments)),
        Command::Radii(arguments) => radii::run(arguments),
        Command::Dyno(arguments) => in_order(|| dyno::run(arguments)),
        Command::Compare(arguments) => in_order(|| compare::run(arguments)),
        Command::BenchData(arguments) => in_order(|| bench_data::run(arguments)),
        Command::Keys(arguments) => keys::run(arguments),
        Command::Schema(arguments) => schema::run(arguments),
        Command::Completions(arguments) => completions::completions(arguments),
        Command::Man(arguments) => completions::man(arguments),
        #[cfg(feature = "live")]
        Command::Live(arguments) => live::run(arguments),
    });
    match outcome {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(stop)) => {
            asked.tell(&stop.failure());
            stop.report()
        }
        Err(_) => {
            let message = "a defect of the program; its message is on standard error".to_owned();
            asked.tell(&FailureReport { kind: FailureKind::Internal, message, hint: None });
            ExitCode::from(1)
        }
    }
}

/// A command that Ctrl-C ends at the next step of what is being solved, rather than the program at once.
fn in_order(command: impl FnOnce() -> Result<(), stop::Stop>) -> Result<(), stop::Stop> {
    let cancel = stop::cancel_on_interrupt();
    match sheave::cancellable(&cancel, command) {
        // That no solution was found says nothing then.
        Err(stop::Stop::NoSolution(_) | stop::Stop::Advised(..)) if cancel.is_cancelled() => Err(stop::Stop::Cancelled),
        done => done,
    }
}

/// Help and version, or what is wrong with the arguments; in plain text if one of them holds what a terminal would act
/// on.
fn misunderstood(stop: &clap::Error) -> ExitCode {
    let acts = |argument: std::ffi::OsString| {
        let argument = argument.to_string_lossy();
        argument.contains('\n') || matches!(printable(&argument), std::borrow::Cow::Owned(_))
    };
    if stop.use_stderr() && std::env::args_os().any(acts) {
        stop::tell(&printable(&stop.render().to_string()));
    } else {
        // Where it goes is full or closed: the exit status has to do.
        let _ = stop.print();
    }
    ExitCode::from(u8::try_from(stop.exit_code()).unwrap_or(1))
}

/// Whether standard error shows colours: on a terminal, unless NO_COLOR is set (no-color.org).
fn colours() -> bool {
    let declined = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    !declined && std::io::IsTerminal::is_terminal(&std::io::stderr())
}

/// Warnings always; more with `-v`, or as the environment variable RUST_LOG says.
fn log_to_stderr(verbose: u8) {
    let level = match verbose {
        0 => LevelFilter::WARN,
        1 => LevelFilter::INFO,
        2 => LevelFilter::DEBUG,
        _ => LevelFilter::TRACE,
    };
    let asked = std::env::var("RUST_LOG").ok().and_then(|text| text.parse::<Targets>().ok());
    let filter = asked.unwrap_or_else(|| Targets::new().with_default(level));
    let lines = tracing_subscriber::fmt::layer()
        .with_writer(|| stop::Diagnostics)
        .with_ansi(colours())
        .without_time()
        .with_target(verbose > 1);
    // Fails only if a subscriber is set already, and then logs go there.
    let _ = tracing_subscriber::registry().with(filter).with(lines).try_init();
}
