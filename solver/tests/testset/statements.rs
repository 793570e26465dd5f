//! The test set's transcription, checked without solving: against closed-form solutions, against tabulated values,
//! and against a second transcription (`benches/testset_scipy.py samples`).

use crate::problems;
use crate::problems::catalogue::{Case, DATA, numbers};
use serde_json::Value;
use solver::{Points, Problem};

/// Right-hand side at one point.
fn rhs(problem: &dyn Problem, region: usize, x: f64, y: &[f64], c: &[f64]) -> Vec<f64> {
    let mut f = vec![0.0; problem.layout().regions[region].rows()];
    problem.rhs(region, &Points { len: 1, stride: 1, s: &[x], y }, c, &mut f);
    f
}

fn boundary(case: &Case, ends: &[f64], c: &[f64]) -> Vec<f64> {
    let mut g = vec![0.0; case.problem.layout().equations.len()];
    case.problem.boundary(ends, &[], c, &mut g);
    g
}

/// Difference relative to `1 + |expected|`.
fn deviation(value: f64, expected: f64) -> f64 {
    (value - expected).abs() / (1.0 + expected.abs())
}

fn all() -> Vec<Case> {
    let mut cases = problems::cases();
    cases.extend(problems::folds());
    cases.push(problems::nonlinear::corner());
    cases
}

#[test]
fn every_problem_is_there() {
    let cases = all();
    let ids: Vec<_> =
        DATA["problems"].as_array().unwrap().iter().map(|problem| problem["id"].as_str().unwrap()).collect();
    assert_eq!(ids.len(), 48);
    for id in ids {
        assert!(cases.iter().any(|case| case.id == id), "{id} is missing");
    }
    for case in &cases {
        let layout = case.problem.layout();
        assert_eq!(layout.equations.len(), layout.states() + case.unknowns.len(), "{}", case.id);
        for parameter in case.parameters() {
            case.guess(parameter).check(layout).unwrap();
        }
    }
}

/// `y' = f` and `g = 0` on closed-form solutions, which equal the tabulated ones.
#[test]
fn closed_form_solutions_satisfy_their_problems() {
    for case in all() {
        let Some(exact) = &case.exact else { continue };
        for parameter in case.parameters() {
            let c = case.constants_at(parameter);
            let layout = case.problem.layout();
            let (mut ends, mut rounding) = (Vec::new(), 0.0);
            for (index, region) in layout.regions.iter().enumerate() {
                let (a, b) = region.interval;
                for j in 0..=40 {
                    let x = a + (b - a) * f64::from(j) / 40.0;
                    let (y, slope) = exact(index, x, &c);
                    let f = rhs(&*case.problem, index, x, &y, &c);
                    // Rounding in y enters f with the size of its derivatives: at most 1e8 here.
                    let size = f.iter().chain(&slope).fold(1.0_f64, |max, value| max.max(value.abs()));
                    let stiffness = parameter.map_or(1.0, |p| p.max(1.0 / p).powi(2)).max(1e3);
                    for (f, slope) in f.iter().zip(&slope) {
                        let residual = (f - slope).abs() / (size + stiffness);
                        assert!(residual < 2e-12, "{} at {parameter:?}, x = {x}: {f} is not {slope}", case.id);
                    }
                }
                for x in [a, b] {
                    let (y, slope) = exact(index, x, &c);
                    rounding = slope.iter().fold(rounding, |max: f64, slope| max.max(2e-15 * slope.abs()));
                    ends.extend(y);
                }
            }
            let size = ends.iter().fold(1.0_f64, |max, value| max.max(value.abs()));
            for g in boundary(&case, &ends, &c) {
                assert!(g.abs() < 1e-12 * size + rounding, "{} at {parameter:?}: boundary residual {g}", case.id);
            }
            compare_with_table(&case, parameter);
        }
    }
}

fn compare_with_table(case: &Case, parameter: Option<f64>) {
    let (layout, c) = (case.problem.layout(), case.constants_at(parameter));
    for reference in case.references(parameter) {
        let mut rows = reference.y.iter().zip(&reference.peak);
        for (index, region) in layout.regions.iter().enumerate() {
            let (a, b) = region.interval;
            for state in 0..region.states.len() {
                let (row, peak) = rows.next().unwrap();
                for (&x, &tabulated) in reference.x.iter().zip(row) {
                    let x = if layout.regions.len() > 1 { a + (b - a) * x } else { x };
                    let (y, slope) = case.exact.as_ref().unwrap()(index, x, &c);
                    let (y, rounding) = (y[state], 2e-15 * slope[state].abs());
                    let error = (y - tabulated).abs() / (1.0 + peak);
                    assert!(error < 2e-12 + rounding, "{} at {parameter:?}, x = {x}: {y} is not {tabulated}", case.id);
                }
            }
        }
    }
}

/// The ends of tabulated solutions satisfy the boundary conditions.
#[test]
fn tabulated_ends_satisfy_the_conditions() {
    for case in problems::cases() {
        for parameter in case.parameters() {
            for reference in case.references(parameter) {
                let mut c = case.constants_at(parameter);
                case.unknowns.iter().zip(&reference.constants).for_each(|(&index, &value)| c[index] = value);
                let mut rows = reference.y.iter();
                let mut ends = Vec::new();
                for region in &case.problem.layout().regions {
                    let rows: Vec<_> = rows.by_ref().take(region.states.len()).collect();
                    ends.extend(rows.iter().map(|row| row[0]));
                    ends.extend(rows.iter().map(|row| row[row.len() - 1]));
                }
                let size = ends.iter().fold(1.0_f64, |max, value| max.max(value.abs()));
                for g in boundary(&case, &ends, &c) {
                    assert!(g.abs() < 2e-12 * size, "{} at {parameter:?}: boundary residual {g}", case.id);
                }
            }
        }
    }
}

#[test]
fn a_second_transcription_agrees() {
    let samples: Value = serde_json::from_str(include_str!("../data/bvp-testset-samples.json")).unwrap();
    let cases = all();
    for sample in samples.as_array().unwrap() {
        let id = sample["id"].as_str().unwrap();
        let case = cases.iter().find(|case| case.id == id).unwrap();
        let layout = case.problem.layout();
        let mut c = case.constants_at(sample["parameter"].as_f64());
        case.unknowns.iter().zip(numbers(&sample["p"])).for_each(|(&index, value)| c[index] = value);
        let (y, x) = (numbers(&sample["y"]), sample["x"].as_f64().unwrap());
        let (entry, exit) = (numbers(&sample["ya"]), numbers(&sample["yb"]));
        let (mut f, mut ends, mut first) = (Vec::new(), Vec::new(), 0);
        for (index, region) in layout.regions.iter().enumerate() {
            let (a, b) = region.interval;
            let states = first..first + region.states.len();
            // Stacked problems run from 0 to 1 and carry the length of the region in the right-hand side.
            let (x, length) = if layout.regions.len() > 1 { (a + (b - a) * x, b - a) } else { (x, 1.0) };
            f.extend(rhs(&*case.problem, index, x, &y[states.clone()], &c).iter().map(|f| f * length));
            ends.extend_from_slice(&entry[states.clone()]);
            ends.extend_from_slice(&exit[states.clone()]);
            first = states.end;
        }
        for (value, expected) in f.iter().zip(numbers(&sample["f"])) {
            assert!(deviation(*value, expected) < 1e-13, "{id}: right-hand side {value} is not {expected}");
        }
        for (value, expected) in boundary(case, &ends, &c).iter().zip(numbers(&sample["g"])) {
            assert!(deviation(*value, expected) < 1e-12, "{id}: boundary {value} is not {expected}");
        }
    }
}
