//! The divided problem's derivatives against differences, and its residuals against the drive's own.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use solver::{Points, Problem, Scope};

use super::division::{Joint, Sliding, Structure};
use super::problem::Kinked;
use crate::case::Case;
use crate::drive::{BeltProblem, Question};
use crate::model::{Constant, Constants};
use crate::random::Random;

const JOINTS: [(Sliding, Option<Joint>); 5] = [
    (Sliding::Slipping, Some(Joint::Kink)),
    (Sliding::Adhering, Some(Joint::Reversal)),
    (Sliding::Adhering, Some(Joint::Kink)),
    (Sliding::Slipping, Some(Joint::Unseating(0.02))),
    (Sliding::Slipping, None),
];

fn string() -> (BeltProblem, Constants) {
    let mut case = Case::default();
    case.set("edition", "string").unwrap();
    let case = case.resolve().unwrap();
    let given = crate::drive::start::stretched(&Question::of(&case).constants);
    (BeltProblem::new(&case.model, &given).unwrap(), given)
}

/// Constants with wrap angles that do not add up, and ends that do not meet: nothing vanishes by accident.
fn point(kinked: &Kinked<'_>, constants: &Constants) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
    let mut random = Random::new(7);
    let layout = kinked.layout();
    let mut all = constants.0.to_vec();
    all.extend(kinked.wraps().map(|_| random.between(0.1, 1.0, false)));
    let ends = layout.regions.iter().flat_map(|region| {
        let states = region.states.len();
        let mut values = Vec::new();
        for at in 0..2 * states {
            values.push(match (states, at % states) {
                (3, 1) => random.between(-0.02, 0.02, false),
                (3, 2) => random.between(2e-4, 4e-4, false),
                (_, 0) => random.between(200.0, 400.0, false),
                _ => random.between(0.1, 3.0, false),
            });
        }
        values
    });
    let ends: Vec<f64> = ends.collect();
    let integrals = (0..layout.integrals()).map(|_| random.between(1.0, 20.0, false)).collect();
    (ends, integrals, all)
}

/// A step that rounding and curvature leave about six digits of.
fn step(value: f64) -> f64 {
    1e-6 * value.abs().max(1e-4)
}

fn near(exact: f64, difference: f64, scale: f64, what: &str) {
    assert!((exact - difference).abs() <= 2e-4 * (exact.abs() + scale), "{what}: {exact} and {difference}");
}

#[test]
fn boundary_equations_have_the_derivatives_that_differences_show() {
    let (own, constants) = string();
    let structure: Structure = [JOINTS.to_vec(), JOINTS.to_vec()];
    let kinked = Kinked::new(&own, &structure, &constants).unwrap();
    let (ends, integrals, all) = point(&kinked, &constants);
    let layout = kinked.layout().clone();
    layout.check().unwrap();
    assert_eq!(layout.equations.len(), layout.states() + kinked.unknowns().len());
    let rows = layout.equations.len();
    let (mut g, mut dz) = (vec![0.0; rows], vec![0.0; layout.boundary_pattern.len()]);
    kinked.boundary_jacobian(&ends, &integrals, &all, &mut g, &mut dz);
    let inputs = [ends, integrals, all].concat();
    let (count_ends, count) = (layout.ends(), layout.ends() + layout.integrals());
    let residuals = |inputs: &[f64]| {
        let mut g = vec![0.0; rows];
        kinked.boundary(&inputs[..count_ends], &inputs[count_ends..count], &inputs[count..], &mut g);
        g
    };
    assert_eq!(residuals(&inputs), g);
    for input in 0..inputs.len() {
        let h = step(inputs[input]);
        let [up, down] = [h, -h].map(|h| {
            let mut moved = inputs.clone();
            moved[input] += h;
            residuals(&moved)
        });
        for row in 0..rows {
            let entries = layout.boundary_pattern.iter().zip(&dz).filter(|(entry, _)| **entry == (row, input));
            let exact: f64 = entries.map(|(_, value)| value).sum();
            let rounding = 1e-9 * g[row].abs().max(1.0) / h;
            let what = format!("{} by {}", layout.equations[row], layout.input_name(input));
            near(exact, (up[row] - down[row]) / (2.0 * h), rounding, &what);
        }
    }
}

/// Each branch of the law, with respect to every constant: the tangents of the path use them all.
#[test]
fn both_branches_of_the_law_have_the_derivatives_that_differences_show() {
    let (own, constants) = string();
    let structure: Structure = [JOINTS.to_vec(), JOINTS.to_vec()];
    let kinked = Kinked::new(&own, &structure, &constants).unwrap();
    let (_, _, all) = point(&kinked, &constants);
    for part in [0, 1] {
        let region = &kinked.layout().regions[part];
        let rows = region.rows();
        let y = [300.0, -2e-3, 3e-4];
        let at = Points { len: 1, stride: 1, s: &[0.3], y: &y };
        let (mut f, mut dy) = (vec![0.0; rows], vec![0.0; region.state_pattern.len()]);
        let mut dc = vec![0.0; region.constant_pattern.len()];
        kinked.rhs_jacobian(part, &at, &all, Scope::All, &mut f, &mut dy, &mut dc);
        let rhs = |all: &[f64]| {
            let mut f = vec![0.0; rows];
            kinked.rhs(part, &at, all, &mut f);
            f
        };
        for (&(row, constant), exact) in region.constant_pattern.iter().zip(&dc) {
            let h = 1e-5 * all[constant].abs().max(1e-6);
            let [up, down] = [h, -h].map(|h| {
                let mut moved = all.clone();
                moved[constant] += h;
                rhs(&moved)[row]
            });
            near(*exact, (up - down) / (2.0 * h), 1e-9 * f[row].abs().max(1.0) / h, &format!("{row} by {constant}"));
        }
    }
}

/// Where |v| is the threshold both branches are the law itself, and a kink's equation holds; elsewhere one of them is.
#[test]
fn a_kink_is_where_both_branches_are_the_law() {
    let (own, mut constants) = string();
    let structure: Structure = [JOINTS.to_vec(), JOINTS.to_vec()];
    let y = [300.0, -2e-3, 3e-4];
    let s = [0.3];
    let at = Points { len: 1, stride: 1, s: &s, y: &y };
    let fields = own.fields(crate::drive::RegionId::Primary, &at, &constants.0);
    let speed = own.kernel(crate::drive::RegionId::Primary).field(crate::model::Field::SlidingSpeed).unwrap();
    for (factor, alike) in [(0.5, [true, false]), (1.0, [true, true]), (2.0, [false, true])] {
        constants[Constant::SlipThreshold] = factor * fields[speed];
        let kinked = Kinked::new(&own, &structure, &constants).unwrap();
        let (_, _, mut all) = point(&kinked, &constants);
        for (_, wrap) in kinked.wraps() {
            all[wrap] = constants[Constant::PrimaryWrap];
        }
        let rows = kinked.layout().regions[0].rows();
        let mut law = vec![0.0; rows];
        own.rhs(0, &at, &constants.0, &mut law);
        for (part, alike) in alike.into_iter().enumerate() {
            let mut f = vec![0.0; rows];
            kinked.rhs(part, &at, &all, &mut f);
            let differs = f.iter().zip(&law).take(2).any(|(f, law)| (f - law).abs() > 1e-6 * law.abs());
            assert_eq!(!differs, alike, "{factor}: part {part}, {f:?} and {law:?}");
        }
    }
}
