//! A solution written and read again is the same solution.

#![allow(clippy::unwrap_used)]

use solver::bvp::{Bvp, Formulas};
use solver::continuation::{Branch, BranchOptions, trace, trace_crossing};
use solver::{Accuracy, Guess, MeshRecord, Options, Order, Shortfall, Solution, solve};

#[test]
fn a_solution_comes_back_as_it_was_and_can_be_gone_on_from() {
    let bratu = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 1.0);
    for order in [Order::Six, Order::Eight] {
        comes_back(&bratu, order);
    }
    // A guess too; and what is no solution is refused.
    let guess: Guess = serde_json::from_str(&serde_json::to_string(&bratu.start()).unwrap()).unwrap();
    assert_eq!(guess, bratu.start());
    let text = serde_json::to_string(&bratu.solve(&Options::default()).unwrap()).unwrap();
    assert!(serde_json::from_str::<Solution>(&text.replace("\"constants\"", "\"constant\"")).is_err());
    // So are tables that do not fit the mesh: a row too short, a row too few, no mesh.
    let changed = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        change(&mut value["regions"][0]);
        serde_json::from_value::<Solution>(value).unwrap_err().to_string()
    };
    let short = changed(&|region| drop(region["y"][1].as_array_mut().unwrap().pop()));
    assert!(short.contains("values of y") && short.contains("are expected"), "{short}");
    let few = changed(&|region| drop(region["alpha"].as_array_mut().unwrap().pop()));
    assert!(few.contains("1 rows of alpha; 2 are expected"), "{few}");
    let one = changed(&|region| region["defects"].as_array_mut().unwrap().truncate(1));
    assert!(one.starts_with("1 defects; one for each of"), "{one}");
    let none = changed(&|region| region["mesh"].as_array_mut().unwrap().truncate(1));
    assert!(none.contains("a mesh of 1 nodes"), "{none}");
}

fn comes_back<M: Formulas>(bratu: &Bvp<M>, order: Order) {
    let options = Options { order, tolerance: 1e-10, ..Options::default() };
    let solution = bratu.solve(&options).unwrap();
    let text = serde_json::to_string(&solution).unwrap();
    let again: Solution = serde_json::from_str(&text).unwrap();
    for s in [0.0, 0.1, 0.377, 1.0] {
        assert_eq!(again.regions()[0].eval(s), solution.regions()[0].eval(s));
    }
    let defects = solution.regions()[0].defects();
    assert_eq!(defects.len(), solution.intervals());
    assert_eq!(defects.iter().copied().fold(0.0, f64::max), solution.max_defect());
    assert_eq!(again.regions()[0].defects(), defects);
    // They may be missing, as where they are not known.
    let mut without: serde_json::Value = serde_json::from_str(&text).unwrap();
    without["regions"][0].as_object_mut().unwrap().remove("defects").unwrap();
    assert!(serde_json::from_value::<Solution>(without).unwrap().regions()[0].defects().is_empty());
    assert_eq!(again.constants(), solution.constants());
    assert_eq!(
        (again.order(), again.accuracy(), again.stats()),
        (solution.order(), solution.accuracy(), solution.stats())
    );
    assert_eq!(again.history(), solution.history());
    let warm = solve(bratu, &Guess::from(&again), &[], &options).unwrap();
    assert_eq!(warm.stats().newton_iterations, 1);
}

/// JSON has no infinity and no NaN; a mesh that failed and an estimate that is not known have them.
#[test]
fn numbers_that_are_not_finite_survive_json() {
    let failed = MeshRecord { intervals: vec![10, 20], defects: vec![f64::INFINITY, 0.5], newton_iterations: 3 };
    let text = serde_json::to_string(&failed).unwrap();
    assert_eq!(serde_json::from_str::<MeshRecord>(&text).unwrap(), failed);
    let short = Accuracy::Short { estimate: f64::NAN, tolerance: 1e-6, because: Shortfall::Mesh };
    let again: Accuracy = serde_json::from_str(&serde_json::to_string(&short).unwrap()).unwrap();
    assert!(
        matches!(again, Accuracy::Short { estimate, tolerance: 1e-6, because: Shortfall::Mesh } if estimate.is_nan())
    );
}

/// Euler's strut from straight to buckled, by way of a text.
#[test]
fn a_branch_comes_back_and_its_branch_point_is_switched_at() {
    let strut = Bvp::new(
        &["angle", "curvature"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].sin()),
        |a, b, _, g| (g[0], g[1]) = (a[1], b[1]),
    )
    .given("load", 5.0);
    let options = BranchOptions { range: (5.0, 15.0), max_points: 40, ..BranchOptions::default() };
    let straight = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
    let text = serde_json::to_string(&straight).unwrap();
    let again: Branch = serde_json::from_str(&text).unwrap();
    assert_eq!(serde_json::to_string(&again).unwrap(), text);
    assert_eq!((again.check, again.stats, again.points.len()), (straight.check, straight.stats, straight.points.len()));
    let told = |branch: &Branch| -> Vec<(f64, f64)> {
        let [left, right] =
            trace_crossing(&strut, branch.branch_points().next().unwrap(), 0, &[], &options, &[]).unwrap();
        let both = left.points.iter().chain(&right.points);
        both.map(|point| (point.parameter, point.solution.regions()[0].eval(0.0)[0])).collect()
    };
    let buckled = told(&straight);
    assert!(buckled.iter().any(|(_, angle)| *angle > 0.5) && buckled.iter().any(|(_, angle)| *angle < -0.5));
    assert_eq!(told(&again), buckled);
    // A direction that is not the solution's is refused.
    let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
    for point in value["points"].as_array_mut().unwrap() {
        if let Some(states) = point["direction"].get_mut("states") {
            states[0][0].as_array_mut().unwrap().pop();
        }
    }
    let other: Branch = serde_json::from_value(value).unwrap();
    assert!(trace_crossing(&strut, other.branch_points().next().unwrap(), 0, &[], &options, &[]).is_err());
}
