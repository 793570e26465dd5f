//! Solutions from nothing against the converged solutions of an independent code.

use serde_json::Value;
use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::result::run;

fn data(name: &str) -> Value {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A value of the result object by its key with dots.
fn lookup(object: &Value, key: &str) -> f64 {
    key.split('.').fold(object, |value, part| &value[part]).as_f64().unwrap_or_else(|| panic!("no number {key}"))
}

fn solve(case: &Case, tolerance: f64) -> Value {
    let options = SolveOptions { tolerance, ..SolveOptions::default() };
    let outcome = run(&case.resolve().unwrap(), &options).unwrap();
    serde_json::to_value(outcome.result).unwrap()
}

/// Relative for most; of the scale of the drive for angles at the ends and places of resultants, which pass zero.
fn error(key: &str, found: f64, expected: f64) -> f64 {
    let name = key.rsplit('.').next().unwrap_or(key);
    let scale = match name {
        "entry_angle" | "exit_angle" | "resultant_x" | "resultant_y" => 0.01,
        _ => expected.abs(),
    };
    (found - expected).abs() / scale
}

#[test]
fn every_reference_case_is_met_from_a_cold_start() {
    let reference = data("reference.json");
    let mut misses = Vec::new();
    let mut worst: f64 = 0.0;
    for entry in reference["cases"].as_array().unwrap() {
        let mut case = Case::default();
        case.set("edition", entry["edition"].as_str().unwrap()).unwrap();
        for (key, value) in entry["inputs"].as_object().unwrap() {
            case.set(key, &value.to_string()).unwrap();
        }
        let result = solve(&case, 1e-6);
        for (key, expected) in entry["expected"].as_object().unwrap() {
            let (found, expected) = (lookup(&result, key), expected.as_f64().unwrap());
            let error = error(key, found, expected);
            worst = worst.max(error);
            if !(error <= 1e-4) {
                misses.push(format!("{} {}: {key} {found} for {expected}: {error:.1e}", entry["edition"], entry["case"]));
            }
        }
    }
    println!("largest error {worst:.2e}");
    assert!(misses.is_empty(), "{}", misses.join("\n"));
}

/// Units in which the thesis states its numbers, over SI.
fn unit(name: &str) -> f64 {
    match name {
        "deg" => std::f64::consts::PI / 180.0,
        "mm" => 1e-3,
        "%" => 1e-2,
        _ => 1.0,
    }
}

#[test]
fn the_published_base_case_is_reproduced_at_the_tolerance_it_was_computed_with() {
    let published = data("published.json");
    let mut case = Case::default();
    case.set("edition", "published").unwrap();
    let result = solve(&case, 1e-3);
    let entries = published["base_case"].as_array().unwrap();
    assert_eq!(entries.len(), 18);
    for entry in entries {
        let key = entry["key"].as_str().unwrap();
        let found = lookup(&result, key) / unit(entry["unit"].as_str().unwrap());
        let (value, tolerance) = (entry["value"].as_f64().unwrap(), entry["tol"].as_f64().unwrap());
        assert!((found - value).abs() <= tolerance, "{key}: {found} for {value} ± {tolerance}");
    }
}
