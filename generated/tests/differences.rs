//! Every generated derivative against extrapolated central differences of the generated values.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Point, Random, Slip, at, point, ridders};
use generated::{BoundaryKernel, REGIONS, RegionKernel};

const POINTS: usize = 60;

#[derive(Default)]
struct Worst {
    relative: f64,
    entry: String,
}

/// A derivative may differ by this, relative to its own size or to what the row changes by when the input doubles.
const TOLERANCE: f64 = 1e-8;

fn step(value: f64, name: &str) -> f64 {
    match name {
        "theta" | "theta1" | "theta2" | "vartheta" | "vartheta1" | "vartheta2" => 1e-2,
        // Slow enough for the sliding speed to change by little.
        "sigma" | "flow" | "R" | "R_P" | "omega_P" | "x" => 2e-4 * value.abs(),
        _ => 2e-2 * value.abs(),
    }
}

#[test]
fn region_jacobians() {
    for kernel in REGIONS {
        let mut random = Random::new(7);
        let mut worst = Worst::default();
        for sample in 0..POINTS {
            let slip = if sample % 2 == 0 { Slip::Below } else { Slip::Beyond };
            check_point(kernel, &point(kernel, &mut random, slip), &mut worst);
        }
        println!("{}: {:.1e} at {}", kernel.name, worst.relative, worst.entry);
        assert!(worst.relative < TOLERANCE, "{}: {:.3e} at {}", kernel.name, worst.relative, worst.entry);
    }
}

fn check_point(kernel: &RegionKernel, point: &Point, worst: &mut Worst) {
    let exact = at(kernel, kernel.full, point);
    let inputs = common::inputs(kernel);
    for (input, symbol) in inputs.enumerate() {
        let moved = |value: f64| {
            let mut moved = point.clone();
            match input.checked_sub(kernel.states.len()) {
                None => moved.y[input] = value,
                Some(constant) => moved.constants[constant] = value,
            }
            at(kernel, kernel.value, &moved).f
        };
        let (pattern, values, column) = match input.checked_sub(kernel.states.len()) {
            None => (kernel.state_pattern, &exact.dy, input),
            Some(constant) => (kernel.constant_pattern, &exact.dc, constant),
        };
        let value = if input < kernel.states.len() { point.y[input] } else { point.constants[column] };
        let differences = ridders(moved, value, step(value, symbol.name));
        for (row, &(difference, error)) in differences.iter().enumerate() {
            let entry = pattern.iter().position(|&pair| pair == (row, column));
            let derivative = entry.map_or(0.0, |entry| values[entry]);
            let size = derivative.abs().max(exact.f[row].abs() / value.abs());
            let relative = (derivative - difference).abs() / size.max(f64::MIN_POSITIVE);
            assert!(error < 1e-4 * size || derivative == difference, "row {row}, {}: unusable difference", symbol.name);
            if relative > worst.relative {
                *worst =
                    Worst { relative, entry: format!("row {row}, {} (error {error:.1e} of {size:.1e})", symbol.name) };
            }
        }
    }
}

#[test]
fn boundary_jacobians() {
    for kernel in common::sets() {
        let mut random = Random::new(11);
        let mut worst = Worst::default();
        for _ in 0..POINTS {
            check_boundary(kernel, &mut random, &mut worst);
        }
        println!("{}: {:.1e} at {}", kernel.name, worst.relative, worst.entry);
        assert!(worst.relative < TOLERANCE, "{}: {:.3e} at {}", kernel.name, worst.relative, worst.entry);
    }
}

fn check_boundary(kernel: &BoundaryKernel, random: &mut Random, worst: &mut Worst) {
    let symbols = || kernel.ends.iter().chain(kernel.integrals).chain(kernel.constants);
    let inputs: Vec<f64> = symbols().map(|symbol| boundary_input(symbol.name, random)).collect();
    let split = |inputs: &[f64]| {
        let (ends, rest) = inputs.split_at(kernel.ends.len());
        let (integrals, constants) = rest.split_at(kernel.integrals.len());
        (ends.to_vec(), integrals.to_vec(), constants.to_vec())
    };
    let (ends, integrals, constants) = split(&inputs);
    let (mut g, mut dz) = (vec![0.0; kernel.equations.len()], vec![0.0; kernel.pattern.len()]);
    (kernel.jacobian)(&ends, &integrals, &constants, &mut g, &mut dz);
    for (column, symbol) in symbols().enumerate() {
        let residuals = |value: f64| {
            let mut moved = inputs.clone();
            moved[column] = value;
            let (ends, integrals, constants) = split(&moved);
            let mut g = vec![0.0; kernel.equations.len()];
            (kernel.value)(&ends, &integrals, &constants, &mut g);
            g
        };
        assert_eq!(residuals(inputs[column]), g, "{}: value and jacobian disagree", kernel.name);
        let differences = ridders(residuals, inputs[column], 1e-2 * inputs[column].abs());
        for (row, (difference, error)) in differences.into_iter().enumerate() {
            let entry = kernel.pattern.iter().position(|&pair| pair == (row, column));
            let derivative = entry.map_or(0.0, |entry| dz[entry]);
            let size = derivative.abs().max(g[row].abs() / inputs[column].abs()).max(1e-3);
            let relative = (derivative - difference).abs() / size;
            if relative > worst.relative {
                let entry = format!("{} by {} (error {error:.1e})", kernel.equations[row].name, symbol.name);
                *worst = Worst { relative, entry };
            }
        }
    }
}

fn boundary_input(name: &str, random: &mut Random) -> f64 {
    match name {
        _ if name.starts_with("x_") => random.between(1e-4, 5e-3),
        _ if name.starts_with("T_") || name.starts_with("tau") => random.between(50.0, 500.0),
        _ if name.starts_with("Phi") => random.between(2.0, 4.0),
        _ if name.starts_with("R_") => random.between(0.05, 0.1),
        _ => random.between(0.1, 0.9),
    }
}

#[test]
fn value_and_jacobian_agree_to_the_bit() {
    for kernel in REGIONS {
        let mut random = Random::new(3);
        for _ in 0..POINTS {
            let point = point(kernel, &mut random, Slip::Beyond);
            let value = at(kernel, kernel.value, &point).f;
            let default = at(kernel, kernel.jacobian, &point);
            let full = at(kernel, kernel.full, &point);
            assert_eq!(value, default.f, "{}", kernel.name);
            assert_eq!(value, full.f, "{}", kernel.name);
            // The order of elimination differs between the two, and with it the rounding.
            for (entry, (a, b)) in default.dc.iter().zip(&full.dc).take(kernel.default_entries).enumerate() {
                assert!((a - b).abs() <= 1e-8 * b.abs().max(1e-3), "{}: entry {entry}: {a} and {b}", kernel.name);
            }
        }
    }
}

#[test]
fn patterns_are_ordered() {
    for kernel in REGIONS {
        assert!(kernel.state_pattern.is_sorted(), "{}", kernel.name);
        let (default, rest) = kernel.constant_pattern.split_at(kernel.default_entries);
        assert!(default.is_sorted() && rest.is_sorted(), "{}", kernel.name);
        assert!(default.iter().all(|&(_, constant)| constant < kernel.default_unknowns), "{}", kernel.name);
        assert!(rest.iter().all(|&(_, constant)| constant >= kernel.default_unknowns), "{}", kernel.name);
    }
}
