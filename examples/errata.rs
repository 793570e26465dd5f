//! What the slips of the thesis amount to at its base case: the numbers of docs/errata.md.
//!
//! `cargo run --release --example errata`

use sheave::case::Case;
use sheave::drive::{Constant, RegionId, SolveOptions};
use sheave::model::{Field, InternalError, State};
use sheave::result::{Outcome, Sampled, run};
use std::error::Error;

const TOLERANCE: f64 = 1e-6;

fn solve(settings: &[(&str, &str)]) -> Result<Outcome, Box<dyn Error>> {
    let mut case = Case::base();
    settings.iter().try_for_each(|(key, value)| case.set(key, value))?;
    Ok(run(&case.resolve()?, &SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() })?)
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("printed slips                 F_P/N    F_S/N   efficiency  loss/W  imbalance");
    let thesis = ("edition", "thesis");
    for (name, settings) in [
        ("none (thesis)", vec![thesis]),
        ("spans: L² on the wrong side", vec![thesis, ("model.spans", "as-printed")]),
        ("ends: no Φ, x' of the entry", vec![thesis, ("model.ends", "as-printed")]),
        ("all (published)", vec![("edition", "published")]),
    ] {
        let result = solve(&settings)?.result;
        let energy = &result.energy;
        println!(
            "{name:28} {:7.2}  {:7.2}  {:9.4} %  {:6.2}  {:+9.2e}",
            result.primary.axial_force,
            result.secondary.axial_force,
            100.0 * result.efficiency.overall.unwrap_or(f64::NAN),
            energy.power_in - energy.power_out,
            energy.imbalance.unwrap_or(f64::NAN),
        );
    }
    let solution = solve(&[thesis])?;
    for region in [RegionId::Primary, RegionId::Secondary] {
        contact(&solution, region)?;
    }
    let entry = solution.result.secondary.entry_angle.to_degrees();
    println!("sign of θ_S1 in (5.23): the belt would break by 2 θ_S1 = {:+.3}° where it enters", 2.0 * entry);
    geometry(&solution);
    Ok(())
}

/// Sign of Q' in (3.28), the second derivative of x in (5.7) and cos φ in (5.59), along a contact.
fn contact(solution: &Outcome, region: RegionId) -> Result<(), InternalError> {
    let (belt, solved) = (&solution.solved.belt, &solution.solved.solution);
    let sampled = Sampled::new(belt, solved, region, 3);
    let (tension, theta) = (sampled.state(State::Tension)?, sampled.state(State::Inclination)?);
    let (theta1, x) = (sampled.state(State::InclinationDerivative)?, sampled.state(State::Penetration)?);
    let shear = sampled.field(Field::Shear)?;
    let (wrap, radius) = match region {
        RegionId::Primary => (Constant::PrimaryWrap, Constant::PrimaryRadius),
        _ => (Constant::SecondaryWrap, Constant::SecondaryRadius),
    };
    let (wrap, radius) = (solution.solved.constant(wrap), solution.solved.constant(radius));
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |most, value| most.max(value.abs()));
    let slopes = (1..sampled.s.len()).map(|at| {
        let slope = (shear[at] - shear[at - 1]) / (sampled.s[at] - sampled.s[at - 1]) / wrap;
        (slope, tension[at] * (1.0 - theta1[at] / wrap))
    });
    let (slope, curvature): (Vec<f64>, Vec<f64>) = slopes.unzip();
    println!(
        "{}: sign of Q' in (3.28): |2 Q'| up to {:.1} N, beside T (1 − θ') up to {:.1} N",
        region.name(),
        2.0 * largest(&mut slope.into_iter()),
        largest(&mut curvature.into_iter()),
    );
    let second = (0..x.len()).map(|at| {
        let (tan, turn) = (theta[at].tan(), theta1[at] / theta[at].cos().powi(2));
        let first = -(radius - x[at]) * tan;
        (2.0 * wrap * wrap * tan * first, wrap * ((radius - x[at]) * turn) - wrap * wrap * tan * first)
    });
    let (slip, right): (Vec<f64>, Vec<f64>) = second.unzip();
    println!(
        "{}: sign in (5.7): x̂'' off by up to {:.2e} m of up to {:.2e} m; its largest x is {:.2e} m",
        region.name(),
        largest(&mut slip.into_iter()),
        largest(&mut right.into_iter()),
        largest(&mut x.iter().copied()),
    );
    println!(
        "{}: cos φ for cos θ in (5.59): the wrap of {:.1}° runs over the pole at 90°; cos θ ≥ {:.5}",
        region.name(),
        wrap.to_degrees(),
        largest(&mut theta.iter().copied()).cos(),
    );
    Ok(())
}

/// (6.10) as printed, sin⁻¹(θ_T) = (R_S − R_P)/L_c, at a ratio of 1.74.
fn geometry(solution: &Outcome) {
    let center = solution.solved.constant(Constant::CenterDistance);
    let (primary, secondary) = (0.0487, 0.0848);
    let slope: f64 = (secondary - primary) / center;
    let length = |turn: f64| {
        let (wrap, span) = (2.0 * turn, center * turn.cos());
        primary * (std::f64::consts::PI - wrap) + secondary * (std::f64::consts::PI + wrap) + 2.0 * span
    };
    let (right, printed) = (slope.asin(), slope.sin());
    println!(
        "(6.10): θ_T = {:.3}° for {:.3}°, belt length {:+.3} mm, at radii of {primary} m and {secondary} m",
        printed.to_degrees(),
        right.to_degrees(),
        1e3 * (length(printed) - length(right)),
    );
}
