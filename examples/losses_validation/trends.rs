//! Losses over the radius of small pulleys, and over the ratio.

use std::error::Error;

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::result::run;

/// Radii, mm, of the run-in belts measured in Proc. Instn Mech. Engrs D 201 (1987).
pub const RADII: [f64; 3] = [51.0, 36.0, 21.0];
/// Bending stiffnesses: the base case's belt, which is far stiffer than those measured, and a tenth of it. N·m².
pub const STIFFNESSES: [f64; 2] = [0.2602, 0.026];
/// The pull M/R and the slack tension are the same at all radii, N.
const PULL: f64 = 100.0;
const SLACK: f64 = 300.0;
const SPEED: &str = "2000 rpm";
const TOLERANCE: f64 = 1e-5;
/// Ratios between which the best is sought.
const RATIOS: (f64, f64, usize) = (0.75, 2.0, 51);

/// At one radius: slip, and torque lost without and with hysteresis, N·m.
pub type Lost = [f64; 3];

pub struct Scaling {
    pub stiffness: f64,
    pub lost: Vec<Lost>,
    /// Exponent of each over the radius, by least squares in logarithms; none if a loss is not positive.
    pub exponents: [Option<f64>; 3],
}

/// An edition, and at each ratio the elastic efficiency and that with losses.
pub type OverRatio = (&'static str, Vec<(f64, f64, f64)>);

pub struct Trends {
    pub scaling: Vec<Scaling>,
    pub ratios: Vec<OverRatio>,
}

pub fn trends() -> Result<Trends, Box<dyn Error>> {
    let scaling = STIFFNESSES.into_iter().map(scaling).collect::<Result<_, _>>()?;
    let ratios = ["thesis", "consistent"].into_iter().map(over_ratio).collect::<Result<_, _>>()?;
    Ok(Trends { scaling, ratios })
}

fn options() -> SolveOptions {
    SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() }
}

fn scaling(stiffness: f64) -> Result<Scaling, Box<dyn Error>> {
    let mut lost = Vec::new();
    for radius in RADII {
        let mut case = Case::base();
        case.set("belt.bending_stiffness", &stiffness.to_string())?;
        case.set("drive.primary_radius", &format!("{radius} mm"))?;
        case.set("drive.secondary_radius", &format!("{radius} mm"))?;
        case.set("operating_point.primary_speed", SPEED)?;
        case.set("operating_point.slack_tension", &SLACK.to_string())?;
        case.set("operating_point.primary_torque", &(PULL * radius * 1e-3).to_string())?;
        let result = run(&case.resolve()?, &options())?.result;
        let elastic = result.primary.torque - result.secondary.torque;
        let hysteresis = result.losses.as_ref().map_or(f64::NAN, |losses| losses.total);
        lost.push([
            1.0 - result.secondary.speed / result.primary.speed,
            elastic,
            elastic + hysteresis / result.secondary.speed,
        ]);
    }
    let exponent = |at: usize| {
        let points: Vec<(f64, f64)> = RADII
            .iter()
            .zip(&lost)
            .filter(|(_, lost)| lost[at] > 0.0)
            .map(|(r, lost)| (r.ln(), lost[at].ln()))
            .collect();
        let count = points.len() as f64;
        let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / count;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        let slope = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum::<f64>()
            / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>();
        (points.len() == RADII.len()).then_some(slope)
    };
    let exponents = [exponent(0), exponent(1), exponent(2)];
    Ok(Scaling { stiffness, lost, exponents })
}

fn over_ratio(edition: &'static str) -> Result<OverRatio, Box<dyn Error>> {
    let (low, high, count) = RATIOS;
    let mut points = Vec::new();
    for i in 0..count {
        let ratio = low + (high - low) * i as f64 / (count - 1) as f64;
        let mut case = Case::base();
        case.set("edition", edition)?;
        case.set("drive.ratio", &ratio.to_string())?;
        let efficiency = run(&case.resolve()?, &options())?.result.efficiency;
        points.push((
            ratio,
            efficiency.overall.unwrap_or(f64::NAN),
            efficiency.overall_with_losses.unwrap_or(f64::NAN),
        ));
    }
    Ok((edition, points))
}

/// Where a quantity is largest: of the parabola through the largest value and its neighbours.
pub fn best(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let at =
        (1..points.len().checked_sub(1)?).find(|&i| points[i].1 >= points[i - 1].1 && points[i].1 > points[i + 1].1)?;
    let [(_, a), (x, b), (next, c)] = [points[at - 1], points[at], points[at + 1]];
    let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
    Some((x + shift * (next - x), b - 0.25 * (a - c) * shift))
}
