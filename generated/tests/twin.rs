//! Generated derivatives against dual numbers through the slow twins, at ordinary states and in the hard corners.
#![allow(non_snake_case, unused_variables, clippy::all, clippy::unwrap_used, clippy::panic)]

mod common;
mod dual;

use common::{Point, Random, Slip, at, point};
use dual::{Dual, Number};
use generated::{Field, REGIONS, RegionConstant, RegionKernel};

mod twin {
    use super::Number;
    include!("../golden/twin.rs");
}

/// Of the largest thing that a derivative is the sum of: its row over the input, or itself.
const TOLERANCE: f64 = 1e-12;
const POINTS: usize = 1000;

fn twin_of(name: &str) -> fn(&[Dual]) -> Vec<Dual> {
    twin::all::<Dual>().into_iter().find(|(twin, _)| *twin == name).map(|(_, function)| function).unwrap()
}

/// Moves a state into a corner where something vanishes or switches.
fn corner(kernel: &RegionKernel, point: &mut Point, which: usize) {
    let mut set = |name: &str, value: &dyn Fn(f64) -> f64| {
        let values = point.y.iter_mut().chain(&mut point.constants);
        common::inputs(kernel)
            .zip(values)
            .filter(|(symbol, _)| symbol.name == name)
            .for_each(|(_, old)| *old = value(*old));
    };
    match which {
        0 => set("x", &|_| 0.0),
        1 => set("theta", &|_| 0.0),
        2 => set("T", &|old| 1e-3 * old),
        3 => set("beta", &|old| 1e-2 * old),
        4 => {
            set("theta1", &|_| 0.0);
            set("vartheta1", &|_| 0.0);
        }
        _ => {}
    }
}

/// Puts |v| at a multiple of the threshold, by way of the pulley's speed and the threshold.
fn slide(kernel: &RegionKernel, point: &mut Point, share: f64) {
    let speed = kernel.field(Field::SlidingSpeed);
    let (Some(speed), Some(threshold)) =
        (speed, kernel.constants.iter().position(|constant| *constant == RegionConstant::SlipThreshold))
    else {
        return;
    };
    let found = at(kernel, kernel.fields_fn, point).fields[speed];
    point.constants[threshold] = found / share;
}

#[test]
fn regions() {
    for kernel in REGIONS {
        let (mut random, mut worst) = (Random::new(41), (0.0, String::new()));
        for sample in 0..POINTS {
            let slip = if sample % 2 == 0 { Slip::Below } else { Slip::Beyond };
            let mut point = point(kernel, &mut random, slip);
            corner(kernel, &mut point, sample % 8);
            match sample % 5 {
                0 => slide(kernel, &mut point, 1.0 - 1e-9),
                1 => slide(kernel, &mut point, 1.0 + 1e-9),
                _ => {}
            }
            check(kernel, &point, &mut worst);
        }
        println!("{}: {:.1e} {}", kernel.name, worst.0, worst.1);
        assert!(worst.0 < TOLERANCE, "{}: {:.3e} {}", kernel.name, worst.0, worst.1);
    }
}

fn check(kernel: &RegionKernel, point: &Point, worst: &mut (f64, String)) {
    let full = at(kernel, kernel.full, point);
    let twin = twin_of(kernel.name);
    let values: Vec<f64> = [point.s].into_iter().chain(point.y.iter().chain(&point.constants).copied()).collect();
    let states = kernel.states.len();
    for (column, value) in values.iter().enumerate().skip(1) {
        let inputs: Vec<Dual> = values.iter().enumerate().map(|(i, v)| Dual(*v, f64::from(i == column))).collect();
        for (row, Dual(twin_value, derivative)) in twin(&inputs).into_iter().enumerate() {
            let entry = match (column - 1).checked_sub(states) {
                None => kernel.state_pattern.iter().position(|&pair| pair == (row, column - 1)).map(|e| full.dy[e]),
                Some(constant) => {
                    kernel.constant_pattern.iter().position(|&pair| pair == (row, constant)).map(|e| full.dc[e])
                }
            };
            let found = entry.unwrap_or(0.0);
            let size =
                derivative.abs().max(full.f[row].abs() / value.abs().max(1e-3)).max(sensitivity(kernel, &full.dy, row));
            let relative = (found - derivative).abs() / size.max(f64::MIN_POSITIVE);
            if !(relative <= worst.0) {
                let name = common::inputs(kernel).nth(column - 1).map(|symbol| symbol.name);
                *worst = (relative, format!("row {row} by {}: {found:e}, {derivative:e}", name.unwrap_or("?")));
            }
            let size = full.f[row].abs().max(sensitivity(kernel, &full.dy, row));
            let error = (full.f[row] - twin_value).abs();
            assert!(error <= 1e-11 * size, "{}, row {row}: {} and {twin_value}", kernel.name, full.f[row]);
        }
    }
}

/// What a row changes by over a typical angle: terms of this size cancel in it.
fn sensitivity(kernel: &RegionKernel, dy: &[f64], row: usize) -> f64 {
    let entries = kernel.state_pattern.iter().zip(dy).filter(|((of, _), _)| *of == row);
    entries
        .map(
            |((_, state), value)| {
                if kernel.states[*state].name() == "x" { value.abs() * 1e-4 } else { value.abs() * 1e-2 }
            },
        )
        .fold(0.0, f64::max)
}

#[test]
fn boundaries() {
    for kernel in common::sets() {
        let twin = twin_of(kernel.name);
        let mut random = Random::new(43);
        for _ in 0..POINTS / 10 {
            let symbols = || kernel.ends.iter().chain(kernel.integrals).chain(kernel.constants);
            let mut draw = |name: &str| match name {
                _ if name.starts_with("x_") => random.between(-1e-3, 1e-3),
                _ if name.starts_with("R_") => random.between(0.05, 0.1),
                _ => random.between(0.1, 0.9),
            };
            let values: Vec<f64> = symbols().map(|symbol| draw(symbol.name)).collect();
            let (ends, rest) = values.split_at(kernel.ends.len());
            let (integrals, constants) = rest.split_at(kernel.integrals.len());
            let (mut g, mut dz) = (vec![0.0; kernel.equations.len()], vec![0.0; kernel.pattern.len()]);
            (kernel.jacobian)(ends, integrals, constants, &mut g, &mut dz);
            for column in 0..values.len() {
                let inputs: Vec<Dual> =
                    values.iter().enumerate().map(|(i, v)| Dual(*v, f64::from(i == column))).collect();
                for (row, Dual(value, derivative)) in twin(&inputs).into_iter().enumerate() {
                    let entry = kernel.pattern.iter().position(|&pair| pair == (row, column));
                    let found = entry.map_or(0.0, |entry| dz[entry]);
                    let size = derivative.abs().max(g[row].abs()).max(1.0);
                    let what = kernel.equations[row].name;
                    assert!(
                        (g[row] - value).abs() <= TOLERANCE * size,
                        "{}, {what}: {} and {value}",
                        kernel.name,
                        g[row]
                    );
                    assert!(
                        (found - derivative).abs() <= TOLERANCE * size,
                        "{}, {what} by {column}: {found} and {derivative}",
                        kernel.name
                    );
                }
            }
        }
    }
}

/// At |v| = 0 the guard makes everything finite: no friction, and the slope of the linear law.
#[test]
fn standstill() {
    for kernel in REGIONS.iter().filter(|kernel| kernel.name.starts_with("contact")) {
        let mut random = Random::new(47);
        for _ in 0..100 {
            let mut point = point(kernel, &mut random, Slip::Below);
            corner(kernel, &mut point, 1);
            let field = |name: &str| kernel.fields.iter().position(|field| field.name() == name).unwrap();
            let index = |name: &str| kernel.constants.iter().position(|constant| constant.name() == name).unwrap();
            // σ such that v_t = 0: the speed is linear in it.
            let fields = at(kernel, kernel.fields_fn, &point).fields;
            let (V, v_t) = (fields[field("V")], fields[field("v_t")]);
            point.constants[index("sigma")] *= V / (V - v_t);
            let fields = at(kernel, kernel.fields_fn, &point).fields;
            assert!(fields[field("speed")] < 1e-13 * V + 2e-12, "{}", fields[field("speed")]);
            assert!(fields[field("mu")] < 1e-12, "{}", fields[field("mu")]);
            let full = at(kernel, kernel.full, &point);
            let all = full.f.iter().chain(&full.dy).chain(&full.dc);
            assert!(all.into_iter().all(|value| value.is_finite()), "{}", kernel.name);
        }
    }
}
