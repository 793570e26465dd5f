//! Derivatives of a result held against differences of two solutions.

use sheave::case::{Case, Resolved};
use sheave::result::DriveResult;

/// Reads a number of a result.
pub type Read = fn(&DriveResult<Resolved>) -> f64;

/// Holds the derivatives of `result`, the solution of `case`, by `key` against central differences. The key has the
/// value
/// `value` in SI and is moved by the share `step` of it; `solve` solves the moved case, in which all else follows.
pub fn assert_derivatives(
    (case, result): (&Case, &DriveResult<Resolved>),
    (key, value, step): (&str, f64, f64),
    solve: impl Fn(&Case) -> DriveResult<Resolved>,
    read: &[(&str, Read)],
) {
    let sensitivities = result.sensitivities.as_ref().unwrap();
    let moved = |by: f64| {
        let mut case = case.clone();
        let unit = if key == "thermal.ambient" { " K" } else { "" };
        case.set(key, &format!("{:e}{unit}", value * (1.0 + by))).unwrap();
        solve(&case)
    };
    let (plus, minus) = (moved(step), moved(-step));
    for (name, read) in read {
        let difference = (read(&plus) - read(&minus)) / (2.0 * step * value);
        let found = sensitivities[*name][key];
        let size = difference.abs().max(0.01 * read(result).abs() / value);
        println!("{name} by {key}: {found:.6e} and {difference:.6e}");
        assert!((found - difference).abs() < 5e-3 * size, "{name} by {key}: {found} and {difference}");
    }
}
