//! The dynamometer's steps, solved in every edition.

use std::error::Error;
use std::f64::consts::PI;

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::result::run;

const POINTS: &str = include_str!("../../tests/data/vt-dyno/operating-points.csv");
const ENGINE: &str = include_str!("../../tests/data/vt-dyno/engine-power.csv");
/// Steps that were not steady.
const LEFT_OUT: fn(usize) -> bool = |step| step < 9 || step == 15;
const HORSEPOWER: f64 = 745.699_871_582_270_2;
const TOLERANCE: f64 = 1e-4;
/// Steps in which the belt's torque is found of which losses leave the measured one, and part of this to which it is.
const TORQUE_STEPS: usize = 20;
const TORQUE: f64 = 1e-5;
/// Editions, and where one needs it another slip threshold than the base case's.
const EDITIONS: [(&str, Option<&str>); 4] =
    [("published", None), ("thesis", None), ("consistent", None), ("string", Some("5e-3 m/s"))];
/// Slack tensions with which the default edition is solved again: the thesis saw 100 N to 200 N (9.4.1).
pub const TENSIONS: [&str; 2] = ["150 N", "200 N"];

/// One step of the dynamometer.
#[derive(Debug, Clone)]
pub struct Step {
    pub number: usize,
    /// Speeds, rpm.
    pub primary: f64,
    pub secondary: f64,
    /// Torque behind the secondary, N·m.
    pub torque: f64,
    /// Power out over the power that the engine's curve gives at this speed.
    pub measured: f64,
    /// Standard error of `measured`, from that of the torque's mean.
    pub error: f64,
}

/// What a model says of a step.
#[derive(Debug, Clone, Copy)]
pub struct Said {
    /// R_S/R_P.
    pub ratio: f64,
    pub elastic: f64,
    /// With hysteresis, where it is told.
    pub with_losses: Option<f64>,
    pub friction: f64,
    pub bending: f64,
    pub groove: f64,
}

/// A model over all steps; `None` where it has no solution.
#[derive(Debug, Clone)]
pub struct Model {
    pub name: String,
    pub said: Vec<Option<Said>>,
}

/// A scale for the engine's curve, fitted to a model.
#[derive(Debug, Clone, Copy)]
pub struct Fit {
    pub points: usize,
    /// Model less measured, before any fit.
    pub mean_error: f64,
    pub rms: f64,
    /// True over borrowed power of the engine, and half the width of its interval of 95 %.
    pub scale: f64,
    pub half_width: f64,
    pub rms_after: f64,
}

pub struct Bench {
    pub steps: Vec<Step>,
    pub models: Vec<Model>,
    /// The default edition with the ratio of the speeds taken for that of the radii, as the thesis has it (9.4).
    pub by_ratio: Model,
    /// Power that edition `published` loses in the base case beside friction, W.
    pub slips: f64,
    /// The default edition at other slack tensions.
    pub tensions: Vec<Model>,
}

/// Reads the steps, and solves them in every edition.
pub fn compare() -> Result<Bench, Box<dyn Error>> {
    let steps = steps()?;
    let model =
        |edition: &str, threshold: Option<&str>, tension: &str, name: String| -> Result<Model, Box<dyn Error>> {
            eprintln!("{name}");
            let said = steps.iter().map(|step| solve(step, edition, threshold, tension)).collect::<Result<_, _>>()?;
            Ok(Model { name, said })
        };
    let of = |(edition, threshold): (&str, Option<&str>)| model(edition, threshold, "100 N", edition.to_owned());
    let models = EDITIONS.into_iter().map(of).collect::<Result<_, _>>()?;
    let at = |tension: &str| model("consistent", None, tension, format!("consistent, slack tension {tension}"));
    let tensions = TENSIONS.into_iter().map(at).collect::<Result<_, _>>()?;
    let said = steps.iter().map(solve_by_ratio).collect::<Result<_, Box<dyn Error>>>()?;
    let by_ratio = Model { name: "consistent, radii from the ratio of speeds".to_owned(), said };
    Ok(Bench { steps, models, by_ratio, slips: slips()?, tensions })
}

/// What edition `published` loses in the base case that is not friction.
fn slips() -> Result<f64, Box<dyn Error>> {
    let mut case = Case::base();
    case.set("edition", "published")?;
    let energy = run(&case.resolve()?, &options())?.result.energy;
    Ok(energy.power_in - energy.power_out - energy.friction_loss)
}

fn options() -> SolveOptions {
    SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() }
}

fn steps() -> Result<Vec<Step>, Box<dyn Error>> {
    let mut engine = Vec::new();
    for record in csv::ReaderBuilder::new().has_headers(false).from_reader(ENGINE.as_bytes()).records() {
        let record = record?;
        engine.push((record[0].parse::<f64>()?, record[1].parse::<f64>()? * HORSEPOWER));
    }
    let mut steps = Vec::new();
    for record in csv::Reader::from_reader(POINTS.as_bytes()).records() {
        let record = record?;
        let number: usize = record[1].parse()?;
        if LEFT_OUT(number) {
            continue;
        }
        let value = |column: usize| record[column].parse::<f64>();
        let (primary, secondary, torque, spread, count) = (value(2)?, value(4)?, value(6)?, value(7)?, value(8)?);
        let engine = interpolated(&engine, primary).ok_or("a speed beyond the engine's curve")?;
        let measured = torque * secondary * PI / 30.0 / engine;
        let error = measured * spread / count.sqrt() / torque;
        steps.push(Step { number, primary, secondary, torque, measured, error });
    }
    Ok(steps)
}

fn interpolated(curve: &[(f64, f64)], at: f64) -> Option<f64> {
    let pair = curve.windows(2).find(|pair| (pair[0].0..=pair[1].0).contains(&at))?;
    Some(pair[0].1 + (at - pair[0].0) / (pair[1].0 - pair[0].0) * (pair[1].1 - pair[0].1))
}

/// Both speeds and the torque out prescribed; both radii follow, from the belt's length and the speeds.
fn solve(step: &Step, edition: &str, threshold: Option<&str>, tension: &str) -> Result<Option<Said>, Box<dyn Error>> {
    let mut case = Case::base();
    case.set("edition", edition)?;
    case.set("drive.free", "both")?;
    case.set("operating_point.primary_speed", &format!("{} rpm", step.primary))?;
    case.set("operating_point.secondary_speed", &format!("{} rpm", step.secondary))?;
    case.set("operating_point.secondary_torque", &format!("{} N*m", step.torque))?;
    case.set("operating_point.slack_tension", tension)?;
    if let Some(threshold) = threshold {
        case.set("sheave.slip_threshold", threshold)?;
    }
    told(&mut case, step.torque)
}

/// The primary's speed and the torque out prescribed; the radii are those of the speeds' ratio, and the secondary
/// slips.
fn solve_by_ratio(step: &Step) -> Result<Option<Said>, Box<dyn Error>> {
    let mut case = Case::base();
    case.set("drive.ratio", &(step.primary / step.secondary).to_string())?;
    case.set("operating_point.primary_speed", &format!("{} rpm", step.primary))?;
    case.set("operating_point.secondary_torque", &format!("{} N*m", step.torque))?;
    told(&mut case, step.torque)
}

/// With friction alone the belt has the torque that was measured behind it; with hysteresis it has so much that this is
/// what is left of it.
fn told(case: &mut Case, measured: f64) -> Result<Option<Said>, Box<dyn Error>> {
    let Ok(alone) = run(&case.resolve()?, &options()) else { return Ok(None) };
    let elastic = alone.result.efficiency.overall.unwrap_or(f64::NAN);
    let (mut outcome, mut torque, mut with_losses) = (alone, measured, None);
    for _ in 0..TORQUE_STEPS {
        let efficiency = &outcome.result.efficiency;
        let (Some(all), Some(friction)) = (efficiency.overall_with_losses, efficiency.overall) else { break };
        let missing = measured - torque * all / friction;
        if missing.abs() < TORQUE * measured {
            with_losses = Some(all);
            break;
        }
        torque += missing;
        case.set("operating_point.secondary_torque", &format!("{torque} N*m"))?;
        outcome = match run(&case.resolve()?, &options()) {
            Ok(outcome) => outcome,
            Err(_) => return Ok(None),
        };
    }
    let result = &outcome.result;
    let losses = result.losses.as_ref();
    Ok(Some(Said {
        ratio: result.secondary.radius / result.primary.radius,
        elastic,
        with_losses,
        friction: result.energy.friction_loss,
        bending: losses.map_or(f64::NAN, |losses| losses.bending),
        groove: losses.map_or(f64::NAN, |losses| losses.groove),
    }))
}

/// Fits the scale s of the engine's curve, Σ (model − measured/s)² least, and nothing else.
pub fn fit(steps: &[Step], model: &Model, pick: impl Fn(&Said) -> Option<f64>) -> Option<Fit> {
    let pairs: Vec<(f64, f64)> =
        steps.iter().zip(&model.said).filter_map(|(step, said)| Some((step.measured, pick(said.as_ref()?)?))).collect();
    let count = pairs.len() as f64;
    let sum = |term: &dyn Fn(&(f64, f64)) -> f64| pairs.iter().map(term).sum::<f64>();
    if pairs.len() < 3 {
        return None;
    }
    let inverse = sum(&|(y, m)| y * m) / sum(&|(y, _)| y * y);
    let squares = sum(&|(y, m)| (m - inverse * y).powi(2));
    let deviation = (squares / (count - 1.0) / sum(&|(y, _)| y * y)).sqrt();
    Some(Fit {
        points: pairs.len(),
        mean_error: sum(&|(y, m)| m - y) / count,
        rms: (sum(&|(y, m)| (m - y).powi(2)) / count).sqrt(),
        scale: 1.0 / inverse,
        // Student's t at 24 degrees of freedom.
        half_width: 2.064 * deviation / (inverse * inverse),
        rms_after: (squares / count).sqrt(),
    })
}
