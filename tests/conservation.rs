//! What must hold of a solution whatever the drive, and sensitivities against whole solves.

#![allow(clippy::unwrap_used, clippy::panic)]

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::result::{Outcome, run};
use solver::Order;

fn solve(settings: &[(&str, &str)], options: &SolveOptions) -> Outcome {
    let mut case = Case::default();
    for (key, value) in settings {
        case.set(key, value).unwrap();
    }
    run(&case.resolve().unwrap(), options).unwrap()
}

fn tight() -> SolveOptions {
    SolveOptions { tolerance: 1e-8, ..SolveOptions::default() }
}

#[test]
fn consistent_equations_account_for_all_power() {
    for ratio in ["0.75", "1.0", "1.6"] {
        let result = solve(&[("edition", "consistent"), ("drive.ratio", ratio)], &tight()).result;
        let energy = &result.energy;
        let (closure, imbalance) = (energy.closure.unwrap(), energy.imbalance.unwrap());
        assert!(closure.abs() <= 1e-8, "ratio {ratio}: {energy:?}");
        // Without the work of stretching, the audit closes to the belt's strain.
        let stretched = energy.stretch_work / energy.power_in;
        assert!((imbalance - stretched).abs() <= 1e-8 && imbalance.abs() < 2e-4, "ratio {ratio}: {energy:?}");
    }
}

#[test]
fn linearised_shear_loses_little_and_the_printed_equations_most() {
    let thesis = solve(&[("edition", "thesis")], &tight()).result;
    assert!(thesis.energy.imbalance.unwrap().abs() < 0.05);
    let published = solve(&[("edition", "published")], &tight()).result.energy;
    let lost = published.power_in - published.power_out;
    // 634 W vanish, friction explains 201 W.
    assert!((lost - 633.6).abs() < 1.0 && (published.friction_loss - 201.4).abs() < 1.0, "{published:?}");
}

#[test]
fn torque_and_force_balance_on_the_whole_drive() {
    for edition in ["thesis", "consistent"] {
        let outcome = solve(&[("edition", edition), ("drive.ratio", "1.4")], &tight());
        let constants = outcome.solved.solution.constants();
        assert!(constants[..8].iter().all(|constant| *constant > 0.0), "{constants:?}");
        let result = &outcome.result;
        assert!((result.primary.torque - 18.0).abs() < 1e-6);
        assert!((result.primary.exit_tension - 100.0).abs() < 1e-6);
        assert!((result.efficiency.overall.unwrap() - result.energy.power_out / result.energy.power_in).abs() < 1e-12);
    }
}

#[test]
fn sensitivities_agree_with_differences_of_whole_solves() {
    let options = SolveOptions { tolerance: 1e-10, order: Order::Six, sensitivities: true, ..SolveOptions::default() };
    // The smooth law with a wide threshold: sliding speeds are small differences of large ones, and at 1e-4 m/s their
    // rounding alone limits differences of whole solves to about 1e-5.
    let base = [("edition", "consistent"), ("model.friction", "tanh"), ("sheave.slip_threshold", "1e-2")];
    let result = solve(&base, &options).result;
    let sensitivities = result.sensitivities.clone().unwrap();
    let value = |outcome: &Outcome| {
        let result = &outcome.result;
        [
            ("primary.axial_force", result.primary.axial_force),
            ("secondary.axial_force", result.secondary.axial_force),
            ("efficiency.overall", result.efficiency.overall.unwrap()),
            ("secondary.exit_tension", result.secondary.exit_tension),
            ("belt.unstretched_length", result.belt.unstretched_length),
            ("primary.resultant_y", result.primary.resultant_y),
            ("energy.friction_loss", result.energy.friction_loss),
        ]
    };
    for (key, at) in [
        ("operating_point.slack_tension", 100.0),
        ("operating_point.primary_torque", 18.0),
        ("belt.bending_stiffness", 0.2602),
        ("drive.primary_radius", 0.068309),
        ("sheave.half_angle", 12.0_f64.to_radians()),
        ("sheave.friction_coefficient", 0.4),
    ] {
        let step = 2e-3 * at;
        let moved = |by: f64| value(&solve(&[base[0], base[1], base[2], (key, &format!("{}", at + by))], &options));
        let (up, down, up2, down2) = (moved(step), moved(-step), moved(2.0 * step), moved(-2.0 * step));
        for i in 0..up.len() {
            let (name, centre) = (up[i].0, (up[i].1 + down[i].1) / 2.0);
            let difference = (8.0 * (up[i].1 - down[i].1) - (up2[i].1 - down2[i].1)) / (12.0 * step);
            let found = sensitivities[name][key];
            let scale = difference.abs().max(1e-2 * centre.abs() / at);
            assert!((found - difference).abs() <= 1e-6 * scale, "d({name})/d({key}): {found} for {difference}");
        }
    }
}
