//! What a drive is asked for, against its meaning: point loads on the pulleys, sums written out.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;

use approx::assert_relative_eq;
use common::Random;
use generated::{OUTPUTS, OUTPUTS_STRING, Output, OutputKernel, Symbol};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Loads on a sheave: force, radius, angle from the belt's entry.
fn loads(random: &mut Random, wrap: f64) -> Vec<[f64; 3]> {
    (0..5).map(|_| [random.between(10.0, 100.0), random.between(0.06, 0.07), random.between(0.0, wrap)]).collect()
}

fn sum(loads: &[[f64; 3]], term: impl Fn(&[f64; 3]) -> f64) -> f64 {
    loads.iter().map(term).sum()
}

#[test]
fn outputs_mean_what_they_say() {
    let mut random = Random::new(5);
    for kernel in [&OUTPUTS, &OUTPUTS_STRING] {
        for _ in 0..100 {
            check(kernel, &mut random);
        }
    }
}

fn check(outputs: &OutputKernel, random: &mut Random) {
    let kernel = &outputs.set;
    let mut given: BTreeMap<String, f64> = BTreeMap::new();
    for symbol in kernel.ends.iter().chain(kernel.integrals).chain(kernel.constants) {
        given.insert(symbol.name.into(), random.between(0.1, 0.9));
    }
    let (torque_in, torque_out, speed, ratio) = (18.0, random.between(10.0, 30.0), 356.0, random.between(0.5, 2.0));
    let pulleys: Vec<_> = ["P", "S"]
        .into_iter()
        .map(|pulley| {
            let (wrap, orientation) = (random.between(2.0, 4.0), random.between(1.0, 2.0));
            let loads = loads(random, wrap);
            let moment = |axis: fn(f64) -> f64| sum(&loads, |[force, radius, angle]| force * radius * axis(*angle));
            given.insert(format!("Phi_{pulley}"), wrap);
            given.insert(format!("C_{pulley}"), orientation);
            given.insert(format!("A_{pulley}"), sum(&loads, |[force, ..]| *force));
            given.insert(format!("A_x_{pulley}"), moment(f64::cos));
            given.insert(format!("A_y_{pulley}"), moment(f64::sin));
            (loads, wrap, orientation)
        })
        .collect();
    for (name, value) in [("M_P", -torque_in), ("M_S", torque_out), ("omega_P", speed), ("speed_ratio", ratio)] {
        given.insert(name.into(), value);
    }
    let values = |symbols: &[Symbol]| symbols.iter().map(|symbol| given[symbol.name]).collect::<Vec<f64>>();
    let mut found = vec![f64::NAN; kernel.equations.len()];
    (kernel.value)(&values(kernel.ends), &values(kernel.integrals), &values(kernel.constants), &mut found);
    let output = |name: &str| found[outputs.row(name.parse::<Output>().unwrap()).unwrap()];
    let is = |name: &str, value: f64| {
        println!("{name}");
        assert_relative_eq!(output(name), value, max_relative = 1e-12, epsilon = 1e-13);
    };
    let g = |name: &str| given[name];

    // Angles from the line of centres: the primary's from its entry on, the secondary's towards its exit.
    for (name, (loads, wrap, orientation)) in ["primary", "secondary"].into_iter().zip(&pulleys) {
        let place = |angle: f64| {
            if name == "primary" { orientation + angle } else { PI - orientation - wrap + angle }
        };
        let force = sum(loads, |[force, ..]| *force);
        let x = sum(loads, |[force, radius, angle]| force * radius * place(*angle).cos()) / force;
        let y = sum(loads, |[force, radius, angle]| force * radius * place(*angle).sin()) / force;
        is(&format!("{name}.resultant_x"), x);
        is(&format!("{name}.resultant_y"), y);
        is(&format!("{name}.binding_moment"), force * x.hypot(y));
        is(&format!("{name}.axial_force"), force);
        is(&format!("{name}.wrap_angle"), *wrap);
        is(&format!("{name}.orientation_angle"), *orientation);
        let pulley = if name == "primary" { "P" } else { "S" };
        for (end, at) in [("entry", 1), ("exit", 2)] {
            is(&format!("{name}.{end}_angle"), g(&format!("theta_{pulley}{at}")));
            is(&format!("{name}.{end}_tension"), g(&format!("T_{pulley}{at}")));
        }
        is(&format!("{name}.friction_loss"), g(&format!("W_{pulley}")));
    }
    for (name, span) in [("tight_span", "t"), ("slack_span", "s")] {
        is(&format!("{name}.arc_length"), g(&format!("L_{span}")));
        is(&format!("{name}.unstretched_length"), g(&format!("L_o_{span}")));
    }
    let all = |letter: &str| ["P", "s", "S", "t"].iter().map(|at| g(&format!("{letter}_{at}"))).sum::<f64>();
    let (power_in, power_out, loss) = (torque_in * speed, torque_out * ratio * speed, g("W_P") + g("W_S"));
    // Friction and output take power from the belt: M_P < 0, and the integrals are of power into it.
    let (primary, secondary) = (g("R_P"), g("R_S"));
    for (name, value) in [
        ("primary.speed", speed),
        ("primary.torque", torque_in),
        ("primary.power", power_in),
        ("secondary.speed", ratio * speed),
        ("secondary.torque", torque_out),
        ("secondary.power", power_out),
        ("efficiency.speed", ratio * secondary / primary),
        ("efficiency.torque", torque_out / secondary * primary / torque_in),
        ("efficiency.overall", power_out / power_in),
        ("belt.mass_flow", g("flow") * g("m_o") * primary * speed),
        ("belt.unstretched_length", all("L_o")),
        ("energy.power_in", power_in),
        ("energy.power_out", power_out),
        ("energy.friction_loss", loss),
        ("energy.stretch_work", all("E")),
        ("energy.imbalance", (power_in - power_out - loss) / power_in),
        ("energy.closure", (power_in - power_out - loss - all("E")) / power_in),
    ] {
        is(name, value);
    }
    assert!(outputs.outputs.iter().all(|output| output.theories().contains(&outputs.theory)));
    assert_eq!(kernel.equations.len(), 2 * 11 + 2 * 2 + 17, "an output without a test");
}
