//! Derivatives of the small models' formulae against dual numbers through their slow twins.
#![allow(non_snake_case, unused_variables, clippy::all, clippy::unwrap_used, clippy::panic)]

mod common;
mod dual;

use common::Random;
use dual::{Dual, Number};
use generated::{BoundaryKernel, FORMULAE};

mod twin {
    use super::Number;
    include!("../golden/twin_small.rs");
}

/// Of the derivative, or of what the row changes by when the input doubles.
const TOLERANCE: f64 = 1e-9;
const POINTS: usize = 500;

/// Random inputs of a belt that is tight and of a pulley that creeps.
fn inputs(kernel: &BoundaryKernel, random: &mut Random) -> Vec<f64> {
    let (v_0, r_I, r_O) = (random.between(10.0, 25.0), random.between(0.05, 0.1), random.between(0.05, 0.1));
    let mut draw = |name: &str| match name {
        "v_0" => v_0,
        "u" => v_0 * random.between(1.002, 1.004),
        "r_I" => r_I,
        "r_O" => r_O,
        "omega_I" => v_0 / r_I * random.between(1.002, 1.004),
        "omega_O" => v_0 / r_O * random.between(1.002, 1.004),
        "M_O" => random.between(0.5, 5.0),
        "M_I" => random.between(-5.0, -0.5),
        "F_CI" | "F_CO" => random.between(200.0, 900.0),
        "phi_O" | "wrap" => random.between(1.2, 1.9),
        "EA" => random.between(2e5, 3e5),
        "m_star" | "rho" => random.between(0.2, 0.5),
        "mu_star" => random.between(1.0, 2.5),
        "delta_0" | "groove" => random.between(0.2, 0.6),
        "V_A" | "V_B" => random.between(9.99, 10.01),
        "omega" => random.between(99.9, 100.1),
        "R" => 0.1,
        "F_A" | "F_B" | "T_tight" => random.between(100.0, 200.0),
        "T_slack" => random.between(70.0, 90.0),
        "f" | "f_face" => random.between(1.0, 1.5),
        "V_thr" => random.between(1e-2, 1e-1),
        "F_thr" => random.between(1.0, 100.0),
        _ => random.between(0.1, 0.9),
    };
    kernel.constants.iter().map(|symbol| draw(symbol.name)).collect()
}

#[test]
fn formulae() {
    assert_eq!(FORMULAE.len(), twin::all::<Dual>().len());
    for kernel in FORMULAE {
        assert!(kernel.ends.is_empty() && kernel.integrals.is_empty());
        let (_, twin) = twin::all::<Dual>().into_iter().find(|(name, _)| *name == kernel.name).unwrap();
        let mut random = Random::new(45);
        let mut worst = 0.0f64;
        for _ in 0..POINTS {
            let values = inputs(kernel, &mut random);
            let (mut g, mut dz) = (vec![0.0; kernel.equations.len()], vec![0.0; kernel.pattern.len()]);
            (kernel.jacobian)(&[], &[], &values, &mut g, &mut dz);
            let mut alone = vec![0.0; g.len()];
            (kernel.value)(&[], &[], &values, &mut alone);
            assert_eq!(g, alone, "{}", kernel.name);
            for column in 0..values.len() {
                let seeded: Vec<Dual> =
                    values.iter().enumerate().map(|(i, v)| Dual(*v, f64::from(i == column))).collect();
                for (row, Dual(value, derivative)) in twin(&seeded).into_iter().enumerate() {
                    let what =
                        format!("{}.{} by {}", kernel.name, kernel.equations[row].name, kernel.constants[column].name);
                    assert!(g[row].is_finite(), "{what}: {values:?}");
                    let entry = kernel.pattern.iter().position(|&pair| pair == (row, column));
                    let found = entry.map_or(0.0, |entry| dz[entry]);
                    let size = derivative.abs().max(g[row].abs() / values[column].abs()).max(1e-12);
                    worst = worst.max((found - derivative).abs() / size);
                    assert!((found - derivative).abs() <= TOLERANCE * size, "{what}: {found} and {derivative}");
                    // Residuals are differences of what their inputs carry.
                    let carried = (derivative * values[column]).abs().max(g[row].abs());
                    assert!((g[row] - value).abs() <= TOLERANCE * carried.max(1.0), "{what}: {} and {value}", g[row]);
                }
            }
        }
        println!("{}: {worst:.1e}", kernel.name);
    }
}

/// A belt that is slack has no sliding angle: not a number, and no panic.
#[test]
fn a_slack_belt_is_not_a_number() {
    let kernel = FORMULAE.iter().find(|kernel| kernel.name == "simple_drive").unwrap();
    let mut values = inputs(kernel, &mut Random::new(3));
    let place = kernel.constants.iter().position(|symbol| symbol.name == "M_O").unwrap();
    values[place] = -1e4;
    let mut g = vec![0.0; kernel.equations.len()];
    (kernel.value)(&[], &[], &values, &mut g);
    let row = |name: &str| kernel.equations.iter().position(|equation| equation.name == name).unwrap();
    assert!(g[row("axial_O")].is_nan() && g[row("speed_O")].is_finite());
}
