//! Losses besides friction: what they leave alone, what they add up to, and their derivatives.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::losses::Losses;
use sheave::result::{Outcome, run};
use support::{Read, assert_derivatives};

#[path = "support/derivatives.rs"]
mod support;

const TOLERANCE: f64 = 1e-6;

fn solve(settings: &[(&str, &str)], options: &SolveOptions) -> Outcome {
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    run(&case.resolve().unwrap(), options).unwrap()
}

fn base(settings: &[(&str, &str)]) -> Outcome {
    solve(settings, &SolveOptions { tolerance: TOLERANCE, ..SolveOptions::default() })
}

fn told(outcome: &Outcome) -> &Losses {
    outcome.result.losses.as_ref().expect("losses are told")
}

#[test]
fn elastic_figures_stay_as_they_are_bit_for_bit() {
    let [off, none, on] = [("losses.include", "off"), ("belt.loss_tangent", "0"), ("belt.loss_tangent", "0.2")]
        .map(|setting| base(&[setting]).result);
    assert!(off.losses.is_none() && off.efficiency.overall_with_losses.is_none());
    for other in [&none, &on] {
        assert_eq!((&off.primary, &off.secondary), (&other.primary, &other.secondary));
        assert_eq!((&off.slack_span, &off.tight_span), (&other.slack_span, &other.tight_span));
        assert_eq!((&off.energy, &off.belt), (&other.energy, &other.belt));
        assert_eq!(off.efficiency.overall, other.efficiency.overall);
    }
    // Without anything to lose, the efficiency with losses is the elastic one to the last bit.
    assert_eq!(none.efficiency.overall_with_losses, none.efficiency.overall);
    assert_eq!(none.losses.map(|losses| losses.total), Some(0.0));
}

#[test]
fn hysteresis_is_linear_in_the_loss_tangent() {
    let one = base(&[("belt.loss_tangent", "0.1"), ("belt.cord_loss_tangent", "0.01")]);
    let two = base(&[("belt.loss_tangent", "0.2"), ("belt.cord_loss_tangent", "0.02")]);
    let (one, two) = (told(&one), told(&two));
    for (one, two) in [(one.bending, two.bending), (one.groove, two.groove), (one.cord, two.cord)] {
        assert!(one > 0.0 && (two / one - 2.0).abs() < 1e-13, "{one} and {two}");
    }
}

/// power_in = power_out_with_losses + friction + hysteresis + drag + gears + strain energy flux.
#[test]
fn power_that_goes_in_comes_out_or_is_accounted_for() {
    let outcome = base(&[
        ("belt.cord_loss_tangent", "0.02"),
        ("losses.primary_drag", "0.3 N*m"),
        ("losses.secondary_drag", "0.2 N*m"),
        ("losses.primary_drag_per_speed", "1e-4 N*m*s"),
        ("losses.secondary_drag_per_speed", "2e-4 N*m*s"),
        ("losses.gear_efficiency", "0.97"),
    ]);
    let (result, losses) = (&outcome.result, told(&outcome));
    let energy = &result.energy;
    let hysteresis = losses.bending + losses.groove + losses.cord;
    let sum = losses.power_out + energy.friction_loss + hysteresis + losses.drag + losses.gears + energy.stretch_work;
    assert!((sum / energy.power_in - 1.0).abs() < 1e-8, "{sum} and {}", energy.power_in);
    let drag = (0.3 + 1e-4 * result.primary.speed) * result.primary.speed
        + (0.2 + 2e-4 * result.secondary.speed) * result.secondary.speed;
    assert!((losses.drag - drag).abs() < 1e-9 * drag);
    let overall = result.efficiency.overall_with_losses.unwrap();
    assert!((overall - losses.power_out / energy.power_in).abs() < 1e-12);
    // Every region's part is in the whole.
    let regions = [losses.primary, losses.slack_span, losses.secondary, losses.tight_span];
    let parts: f64 = regions.iter().map(|part| part.bending + part.groove + part.cord).sum();
    assert!((parts / hysteresis - 1.0).abs() < 1e-9);
    assert!(regions[1].groove == 0.0 && regions[3].groove == 0.0);
}

/// One harmonic for each pulley: P ≈ V (π/4) tan δ EI (1/R_P² + 1/R_S²), 260 W in the base case.
#[test]
fn bending_is_of_the_magnitude_of_one_harmonic_a_pulley() {
    let outcome = base(&[]);
    let (result, losses) = (&outcome.result, told(&outcome));
    let speed = result.belt.mass_flow / 0.4375;
    let curvature = 1.0 / result.primary.radius.powi(2) + 1.0 / result.secondary.radius.powi(2);
    let pocket = speed * std::f64::consts::FRAC_PI_4 / 8.2 * 0.2602 * curvature;
    assert!((250.0..275.0).contains(&pocket), "{pocket}");
    assert!((1.0..2.0).contains(&(losses.bending / pocket)), "{} of {pocket}", losses.bending);
    assert!(losses.harmonics.bending >= 32 && losses.harmonics.groove >= 32);
}

#[test]
fn losses_do_not_depend_on_the_mesh() {
    let at =
        |tolerance| solve(&[("belt.cord_loss_tangent", "0.02")], &SolveOptions { tolerance, ..Default::default() });
    let (coarse, fine) = (at(1e-4), at(1e-7));
    let (coarse, fine) = (told(&coarse), told(&fine));
    assert!((coarse.bending / fine.bending - 1.0).abs() < 3e-4, "{} and {}", coarse.bending, fine.bending);
    assert!((coarse.cord / fine.cord - 1.0).abs() < 1e-2, "{} and {}", coarse.cord, fine.cord);
}

#[test]
fn a_string_has_no_hysteresis_and_says_why() {
    let mut case = Case::base();
    case.set("edition", "string").unwrap();
    case.set("sheave.slip_threshold", "5e-3 m/s").unwrap();
    let outcome = run(&case.resolve().unwrap(), &SolveOptions { tolerance: 1e-3, ..Default::default() }).unwrap();
    assert!(outcome.result.losses.is_none());
    let said = sheave::result::warnings(&outcome);
    assert!(said.iter().any(|said| said.contains("diverges")), "{said:?}");
    case.set("losses.include", "on").unwrap();
    let refused = case.resolve().unwrap_err().to_string();
    assert!(refused.contains("losses.include") && refused.contains("diverges"), "{refused}");
}

/// Each derivative against a difference of two solutions.
#[test]
fn derivatives_are_those_of_finite_differences() {
    let settings = [
        ("belt.cord_loss_tangent", "0.02"),
        ("losses.primary_drag", "0.3 N*m"),
        ("losses.secondary_drag_per_speed", "2e-4 N*m*s"),
        ("losses.gear_efficiency", "0.97"),
        ("sheave.slip_threshold", "1e-2 m/s"),
    ];
    let options = SolveOptions { tolerance: 1e-7, ..SolveOptions::default() };
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    let at = run(&case.resolve().unwrap(), &SolveOptions { sensitivities: true, ..options }).unwrap();
    let sensitivities = at.result.sensitivities.as_ref().unwrap();
    for (key, value, step) in [
        ("belt.bending_stiffness", 0.2602, 2e-3),
        ("belt.radial_stiffness", 18.71e6, 2e-3),
        ("operating_point.slack_tension", 100.0, 2e-3),
        ("operating_point.primary_speed", 3400.0 * std::f64::consts::PI / 30.0, 2e-3),
        ("drive.secondary_radius", 0.068309, 1e-4),
    ] {
        let moved = |by: f64| {
            let mut case = case.clone();
            case.set(key, &format!("{:e}", value * (1.0 + by))).unwrap();
            run(&case.resolve().unwrap(), &options).unwrap().result
        };
        let (plus, minus) = (moved(step), moved(-step));
        let read: [(&str, Read); 6] = [
            ("losses.bending", |result| result.losses.as_ref().unwrap().bending),
            ("losses.groove", |result| result.losses.as_ref().unwrap().groove),
            ("losses.cord", |result| result.losses.as_ref().unwrap().cord),
            ("losses.drag", |result| result.losses.as_ref().unwrap().drag),
            ("losses.total", |result| result.losses.as_ref().unwrap().total),
            ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
        ];
        for (name, read) in read {
            let difference = (read(&plus) - read(&minus)) / (2.0 * step * value);
            let found = sensitivities[name][key];
            // Relative to the derivative, or to the loss itself where it hardly moves.
            let size = difference.abs().max(0.05 * read(&at.result).abs() / value);
            println!("{name} by {key}: {found:.6e} and {difference:.6e}");
            assert!((found - difference).abs() < 5e-3 * size, "{name} by {key}: {found} and {difference}");
        }
    }
}

/// h (T − T_a) is the heat, the stiffnesses are those at T, and all of it has its derivatives.
#[test]
fn the_belt_is_as_warm_as_what_it_loses_makes_it() {
    let settings = [
        ("thermal.ambient", "25 degC"),
        ("thermal.heat_transfer", "12 W/K"),
        ("thermal.friction_share", "0.4"),
        ("sheave.slip_threshold", "1e-2 m/s"),
    ];
    let options = SolveOptions { tolerance: 1e-7, ..SolveOptions::default() };
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    let at = run(&case.resolve().unwrap(), &SolveOptions { sensitivities: true, ..options }).unwrap();
    let (result, losses) = (&at.result, told(&at));
    let (temperature, heat) = (result.belt.temperature.unwrap(), result.thermal.unwrap());
    let into = 0.4 * result.energy.friction_loss + losses.bending + losses.groove;
    assert!((into - heat.belt).abs() < 1e-6 * into);
    assert!((12.0 * (temperature - 298.15) - into).abs() < 1e-5 * into, "{temperature} K, {into} W");
    let factor = (-0.0125 * (temperature - 333.15)).exp();
    assert!((heat.bending_stiffness / (0.2602 * factor) - 1.0).abs() < 1e-12);
    assert!((heat.primary + heat.secondary - 0.6 * result.energy.friction_loss).abs() < 1e-6);
    assert_eq!(heat.hotter == sheave::losses::Hotter::Primary, heat.primary > heat.secondary);
    // The same belt, given at its temperature, is the same drive.
    let stiffness = |value: f64| format!("{value:e}");
    let cold = solve(
        &[
            ("belt.bending_stiffness", &stiffness(heat.bending_stiffness)),
            ("belt.radial_stiffness", &stiffness(heat.radial_stiffness)),
            ("sheave.slip_threshold", "1e-2 m/s"),
        ],
        &options,
    );
    assert!((cold.result.primary.axial_force / result.primary.axial_force - 1.0).abs() < 1e-6);
    for (key, value, step) in [
        ("thermal.ambient", 298.15, 1e-3),
        ("thermal.heat_transfer", 12.0, 2e-3),
        ("belt.bending_stiffness", 0.2602, 2e-3),
        ("operating_point.slack_tension", 100.0, 2e-3),
    ] {
        let read: &[(&str, Read)] = &[
            ("belt.temperature", |result| result.belt.temperature.unwrap()),
            ("primary.axial_force", |result| result.primary.axial_force),
            ("losses.total", |result| result.losses.as_ref().unwrap().total),
            ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
        ];
        assert_derivatives(
            (&case, result),
            (key, value, step),
            |case| run(&case.resolve().unwrap(), &options).unwrap().result,
            read,
        );
    }
}

#[test]
fn a_hot_belt_is_warned_of() {
    let outcome = base(&[("thermal.ambient", "40 degC"), ("thermal.heat_transfer", "8 W/K")]);
    assert!(outcome.result.belt.temperature.unwrap() > 344.15);
    assert!(sheave::result::warnings(&outcome).iter().any(|said| said.contains("71 °C")));
    let mut case = Case::base();
    case.set("thermal.ambient", "25 degC").unwrap();
    assert!(case.resolve().unwrap_err().to_string().contains("thermal.heat_transfer"));
}

/// Of what the belt's equations do not know: loss tangents, drag, gears; at one temperature, and with it following.
#[test]
fn derivatives_by_the_constants_of_losses_are_those_of_finite_differences() {
    let constants = [
        ("belt.loss_tangent", 0.12),
        ("belt.cord_loss_tangent", 0.02),
        ("losses.primary_drag", 0.3),
        ("losses.secondary_drag", 0.2),
        ("losses.primary_drag_per_speed", 1e-4),
        ("losses.secondary_drag_per_speed", 2e-4),
        ("losses.gear_efficiency", 0.97),
    ];
    let heat = [("thermal.ambient", "25 degC"), ("thermal.heat_transfer", "14 W/K")];
    for settings in [&[][..], &heat] {
        let mut case = Case::base();
        constants.iter().for_each(|(key, value)| case.set(key, &value.to_string()).unwrap());
        case.set("sheave.slip_threshold", "1e-2 m/s").unwrap();
        settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
        let options = SolveOptions { tolerance: 1e-7, ..SolveOptions::default() };
        let with = SolveOptions { sensitivities: true, ..options };
        let at = run(&case.resolve().unwrap(), &with).unwrap().result;
        let read: [(&str, Read); 5] = [
            ("losses.bending", |result| result.losses.as_ref().unwrap().bending),
            ("losses.drag", |result| result.losses.as_ref().unwrap().drag),
            ("losses.gears", |result| result.losses.as_ref().unwrap().gears),
            ("losses.total", |result| result.losses.as_ref().unwrap().total),
            ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
        ];
        let solved = |case: &Case| run(&case.resolve().unwrap(), &options).unwrap().result;
        for (key, value) in constants {
            assert_derivatives((&case, &at), (key, value, 1e-2), solved, &read);
        }
        if !settings.is_empty() {
            let warm: [(&str, Read); 1] = [("belt.temperature", |result| result.belt.temperature.unwrap())];
            assert_derivatives((&case, &at), ("belt.loss_tangent", 0.12, 1e-2), solved, &warm);
        }
    }
    // Of what is zero no sum is formed.
    let none = solve(&[("belt.loss_tangent", "0")], &SolveOptions { sensitivities: true, ..SolveOptions::default() });
    assert!(!none.result.sensitivities.unwrap()["losses.total"].contains_key("belt.loss_tangent"));
}
