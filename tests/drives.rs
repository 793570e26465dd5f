//! Drives far from the base case, each from nothing, and torques of either sign.

#![allow(clippy::unwrap_used, clippy::panic)]

use sheave::case::{Case, Resolved};
use sheave::design::{DesignError, LimitOptions, largest_torque};
use sheave::drive::{Failure, SolveOptions, Trouble, solve, solve_from};
use sheave::result::{Outcome, run};

const ROUGH: SolveOptions = SolveOptions {
    tolerance: 1e-3,
    order: solver::Order::Four,
    sensitivities: false,
    work_limit: sheave::drive::WORK_LIMIT,
    uncertainty: false,
};

fn case(settings: &[(&str, &str)]) -> Resolved {
    let mut case = Case::base();
    for (key, value) in settings {
        case.assign(&format!("{key}={value}")).unwrap();
    }
    case.resolve().unwrap()
}

fn outcome(settings: &[(&str, &str)], options: &SolveOptions) -> Outcome {
    run(&case(settings), options).unwrap_or_else(|failure| panic!("{settings:?}: {failure}"))
}

#[test]
fn a_sled_is_solved_at_every_ratio() {
    for ratio in ["0.98", "0.95", "0.9", "0.8", "0.7"] {
        let sled = [
            ("belt.length", "1181.1 mm"),
            ("drive.center_distance", "292.1 mm"),
            ("drive.ratio", ratio),
            ("operating_point.primary_speed", "8300 rpm"),
            ("operating_point.primary_torque", "103.04 N*m"),
            ("operating_point.slack_tension", "300 N"),
        ];
        let result = outcome(&sled, &ROUGH).result;
        assert!(result.slip_reserve > 0.3 && result.efficiency.overall.unwrap() > 0.9, "{ratio}");
    }
}

#[test]
fn fast_and_slow_drives_are_solved() {
    for (speed, ratio) in [
        ("12000 rpm", "1"),
        ("10000 rpm", "0.72"),
        ("8000 rpm", "0.9"),
        ("1 rpm", "1"),
        ("5 rpm", "1"),
        ("20 rpm", "1"),
    ] {
        outcome(&[("operating_point.primary_speed", speed), ("drive.ratio", ratio)], &ROUGH);
    }
}

#[test]
fn stiff_belts_on_small_pulleys_are_solved() {
    for ratio in ["0.5", "1", "2", "3"] {
        outcome(&[("belt.bending_stiffness", "1.5 N*m^2"), ("drive.ratio", ratio)], &ROUGH);
    }
}

/// Speeds and slip threshold times λ, mass over λ²: the steady problem is the same, at any λ.
#[test]
fn a_drive_in_scaled_time_is_the_same_drive() {
    let tight = SolveOptions { tolerance: 1e-7, ..ROUGH };
    let forces = |scale: f64| {
        let speed = (3400.0 * scale).to_string() + " rpm";
        let threshold = (1e-4 * scale).to_string();
        let mass = (0.4375 / (scale * scale)).to_string();
        let scaled = [
            ("operating_point.primary_speed", speed.as_str()),
            ("sheave.slip_threshold", &threshold),
            ("belt.mass_per_length", &mass),
        ];
        let result = outcome(&scaled, &tight).result;
        [result.primary.axial_force, result.secondary.axial_force, result.efficiency.overall.unwrap()]
    };
    let base = forces(1.0);
    for scale in [0.05, 3.0] {
        for (found, expected) in forces(scale).into_iter().zip(base) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{scale}: {found} for {expected}");
        }
    }
}

/// A step of 25 % to a tight tolerance finds a coarse solution first: on the fine mesh of the last solution it would
/// take as many evaluations as a cold start.
#[test]
fn a_far_step_costs_less_than_a_cold_start() {
    let options = SolveOptions { tolerance: 1e-6, ..ROUGH };
    for (edition, share) in [("published", 0.5), ("thesis", 0.75), ("consistent", 0.85)] {
        let cold = solve(&case(&[("edition", edition)]), &options).unwrap();
        let there = case(&[("edition", edition), ("operating_point.slack_tension", "125 N")]);
        let warm = solve_from(&cold, &there, &options).unwrap();
        let (warm, cold) = (warm.stats.jacobian_points as f64, cold.stats.jacobian_points as f64);
        assert!(warm < share * cold, "{edition}: {warm} evaluations with derivatives, {cold} from nothing");
    }
}

/// The base case's work, which no wider start may raise.
#[test]
fn the_base_case_costs_what_it_did() {
    for (edition, iterations, steps) in [("consistent", 65, 14), ("thesis", 44, 17), ("published", 42, 15)] {
        let solved = solve(&case(&[("edition", edition)]), &ROUGH).unwrap();
        let work = (solved.stats.newton_iterations, solved.continuation_steps);
        assert!(work.0 <= iterations && work.1 <= steps, "{edition}: {work:?}");
    }
}

#[test]
fn torque_passes_through_zero_without_a_gap() {
    for edition in ["consistent", "thesis", "published"] {
        let mut last = f64::NEG_INFINITY;
        for torque in [-40.0, -20.0, -5.0, -0.1, 0.0, 0.1, 5.0, 20.0, 40.0] {
            let text = torque.to_string();
            let point = [
                ("edition", edition),
                ("operating_point.primary_torque", text.as_str()),
                ("operating_point.slack_tension", "800 N"),
            ];
            let result = outcome(&point, &ROUGH).result;
            let (primary, secondary) = (&result.primary, &result.secondary);
            assert!((primary.torque - torque).abs() < 1e-3, "{edition} {torque}: {}", primary.torque);
            assert!(secondary.torque > last, "{edition} {torque}");
            last = secondary.torque;
            match result.efficiency.overall {
                Some(overall) => {
                    assert!(overall > 0.0 && overall < 1.0, "{edition} {torque}: {overall}");
                    assert!(primary.power * secondary.power > 0.0 && primary.power * torque > 0.0);
                }
                None => assert!(torque == 0.0 || primary.power * secondary.power <= 0.0, "{edition} {torque}"),
            }
        }
    }
}

/// A handle that is cancelled ends a solve from nothing, a swap and a limit, each as cancelled and as nothing else.
#[test]
fn a_solve_is_cancelled_from_elsewhere() {
    let cancel = sheave::Cancel::new();
    let force = [("operating_point.primary_axial_force", "800 N")];
    let work = |settings: &[(&str, &str)]| sheave::cancellable(&cancel, || run(&case(settings), &ROUGH));
    assert!(work(&[]).is_ok());
    cancel.cancel();
    for settings in [&[][..], &force, &[("operating_point.slip_reserve", "0.4")]] {
        assert!(matches!(work(settings), Err(Failure::Cancelled)), "{settings:?}");
    }
    let limits = LimitOptions { solve: ROUGH, least_speed_efficiency: 0.0 };
    let limit = sheave::cancellable(&cancel, || largest_torque(&case(&[]), &limits));
    assert!(matches!(limit, Err(DesignError::Start(Failure::Cancelled))));
}

#[test]
fn a_solve_keeps_to_its_work_limit_and_says_so() {
    for (work_limit, settings) in [(2_000, &[][..]), (100_000, &[("sheave.friction_coefficient", "5")])] {
        let options = SolveOptions { work_limit, ..ROUGH };
        match solve(&case(settings), &options) {
            Ok(solved) => assert!(work_limit > 2_000 && solved.stats.newton_iterations < work_limit),
            Err(failure) => assert!(failure.trouble().is_some(), "{failure}"),
        }
    }
    let short = solve(&case(&[]), &SolveOptions { work_limit: 2_000, ..ROUGH }).unwrap_err();
    assert_eq!(short.trouble(), Some(Trouble::Work));
}

/// A search that runs out of work beside the slip limit says that the belt slips: more work would not help.
#[test]
fn what_the_belt_shows_comes_before_the_work_limit() {
    let slips = case(&[("operating_point.primary_torque", "60 N*m"), ("sheave.friction_coefficient", "0.1")]);
    for work_limit in [20_000, 30_000] {
        let failure = solve(&slips, &SolveOptions { work_limit, ..ROUGH }).unwrap_err();
        let out_of_work = solver::SolveError::Cancelled;
        assert_eq!(failure.solver().map(ToString::to_string), Some(out_of_work.to_string()));
        assert!(matches!(failure.trouble(), Some(Trouble::Slip { .. })), "{failure}");
    }
}

/// What the result says of its errors, against a solution that is much more accurate.
#[test]
fn outputs_are_as_uncertain_as_they_say() {
    for ratio in ["0.8", "1.6"] {
        let settings = [("drive.ratio", ratio)];
        let exact = SolveOptions { tolerance: 1e-8, order: solver::Order::Six, ..ROUGH };
        let exact = serde_json::to_value(&outcome(&settings, &exact).result).unwrap();
        for tolerance in [1e-3, 1e-5] {
            let options = SolveOptions { tolerance, uncertainty: true, ..ROUGH };
            let result = outcome(&settings, &options).result;
            let uncertainty = result.uncertainty.clone().unwrap();
            let found = serde_json::to_value(&result).unwrap();
            let value = |of: &serde_json::Value, name: &str| {
                name.split('.').try_fold(of, |at, part| at.get(part)).and_then(serde_json::Value::as_f64)
            };
            let mut held = 0;
            for (name, stated) in &uncertainty {
                let (Some(found), Some(exact)) = (value(&found, name), value(&exact, name)) else { continue };
                let error = (found - exact).abs();
                assert!(
                    error <= 3.0 * stated + 1e-8 * exact.abs().max(1e-3),
                    "{ratio} {tolerance} {name}: {error} {stated}"
                );
                held += 1;
            }
            assert!(held > 30, "{held}");
            for name in ["efficiency.overall", "primary.axial_force", "secondary.axial_force", "secondary.torque"] {
                let (found, exact) = (value(&found, name).unwrap(), value(&exact, name).unwrap());
                assert!((found / exact - 1.0).abs() <= tolerance, "{ratio} {tolerance} {name}: {found} {exact}");
            }
        }
    }
}

/// An axial force that a drive was found to press with leads back to its slack tension, also where friction is so steep
/// in engine braking that a path over a tenth of the tension is too long.
#[test]
fn a_prescribed_axial_force_leads_back_to_the_slack_tension() {
    let drive = [
        ("belt.longitudinal_stiffness", "82367.6 N"),
        ("belt.bending_stiffness", "0.0118857 N*m^2"),
        ("belt.radial_stiffness", "5.22597 MPa"),
        ("belt.mass_per_length", "0.313404 kg/m"),
        ("belt.length", "1.18888 m"),
        ("sheave.half_angle", "0.230839 rad"),
        ("sheave.friction_coefficient", "0.420837"),
        ("sheave.slip_threshold", "3.35653e-4 m/s"),
        ("operating_point.primary_speed", "724.913 rad/s"),
        ("operating_point.primary_torque", "-24.5598 N*m"),
        ("drive.center_distance", "0.285335 m"),
        ("drive.primary_radius", "53.4236 mm"),
        ("drive.secondary_radius", "135.745 mm"),
    ];
    let with = |key, value: f64| {
        let clamp = format!("{value} N");
        outcome(&[&drive[..], &[(key, clamp.as_str())]].concat(), &ROUGH)
    };
    let there = with("operating_point.slack_tension", 1069.74);
    let back = with("operating_point.primary_axial_force", there.result.primary.axial_force);
    let found = back.solved.constant(sheave::drive::Constant::SlackTension);
    assert!((found / 1069.74 - 1.0).abs() < 1e-3, "{found}");
}
