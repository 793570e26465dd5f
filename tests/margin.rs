//! What is found is said: keys that were solved for, and clamps that are found for a margin against slip.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::case::{Case, Resolved};
use sheave::drive::SolveOptions;
use sheave::result::{Outcome, run, tension_for};

fn case(settings: &[(&str, &str)]) -> Resolved {
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    case.resolve().unwrap()
}

fn solved(settings: &[(&str, &str)], tolerance: f64) -> Outcome {
    run(&case(settings), &SolveOptions { tolerance, ..SolveOptions::default() }).unwrap()
}

#[test]
fn what_was_solved_for_is_found_and_stands_among_the_inputs() {
    let force = solved(&[("operating_point.primary_axial_force", "1050 N")], 1e-6);
    let object = serde_json::to_value(&force.result).unwrap();
    let tension = object["primary"]["exit_tension"].as_f64().unwrap();
    let found = &object["found"]["operating_point.slack_tension"];
    assert!((found.as_f64().unwrap() / tension - 1.0).abs() < 1e-6);
    let point = &object["inputs"]["operating_point"];
    assert_eq!(&point["slack_tension"], found);
    assert_eq!(point["primary_axial_force"], 1050.0);

    let mut case = Case::base();
    case.swap("belt.bending_stiffness for efficiency.overall = 0.96").unwrap();
    let outcome = run(&case.resolve().unwrap(), &SolveOptions::default()).unwrap();
    let object = serde_json::to_value(&outcome.result).unwrap();
    let found = object["found"]["belt.bending_stiffness"].as_f64().unwrap();
    assert!(found < 0.2602 && object["inputs"]["belt"]["bending_stiffness"] == found);

    let ordinary = serde_json::to_value(solved(&[], 1e-3).result).unwrap();
    assert_eq!(ordinary["found"], serde_json::json!({}));
    let (used, left) = (&ordinary["friction_utilization"], &ordinary["slip_reserve"]);
    assert!((used.as_f64().unwrap() + left.as_f64().unwrap() - 1.0).abs() < 1e-15);
}

#[test]
fn a_margin_against_slip_is_met_by_the_clamp_that_is_found() {
    for (edition, reserve, torque) in
        [("consistent", 0.2, 18.0), ("consistent", 0.6, 18.0), ("consistent", 0.35, 60.0), ("thesis", 0.3, 18.0)]
    {
        let (reserve_text, torque_text) = (format!("{reserve}"), format!("{torque}"));
        let load = ("operating_point.primary_torque", torque_text.as_str());
        let margin = ("operating_point.slip_reserve", reserve_text.as_str());
        let outcome = solved(&[("edition", edition), load, margin], 1e-6);
        let result = &outcome.result;
        assert!((result.slip_reserve - reserve).abs() < 1e-5, "{edition} {reserve}: {}", result.slip_reserve);
        // Asked again with the clamp that was found, the same margin comes back.
        let tension = format!("{:e}", result.found["operating_point.slack_tension"]);
        let again = solved(&[("edition", edition), load, ("operating_point.slack_tension", &tension)], 1e-6);
        // It is a mean over samples, which lie elsewhere on another mesh.
        assert!((again.result.slip_reserve - reserve).abs() < 1e-4, "{edition} {reserve}");
        let object = serde_json::to_value(result).unwrap();
        assert_eq!(object["inputs"]["operating_point"]["slip_reserve"], reserve);
        assert!(object["inputs"]["operating_point"]["slack_tension"].is_number());
    }
    let used = solved(&[("operating_point.friction_utilization", "75 %")], 1e-6);
    assert!((used.result.friction_utilization - 0.75).abs() < 1e-5);
}

#[test]
fn the_estimate_of_the_clamp_for_a_margin_is_near_it() {
    let loose =
        solved(&[("operating_point.primary_torque", "40"), ("operating_point.slip_reserve", "0.1")], 1e-4).result;
    let estimate = tension_for(&loose, 0.2).unwrap();
    let found = solved(&[("operating_point.primary_torque", "40"), ("operating_point.slip_reserve", "0.2")], 1e-4);
    let found = found.result.found["operating_point.slack_tension"];
    assert!((estimate / found - 1.0).abs() < 0.3, "{estimate} for {found}");
    assert_eq!(tension_for(&loose, 0.05), None);
}
