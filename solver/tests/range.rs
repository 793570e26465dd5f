//! The ends of the range in which a branch is followed.

#![allow(clippy::unwrap_used, clippy::unwrap_in_result)]

use solver::bvp::Bvp;
use solver::continuation::{Branch, BranchError, BranchOptions, PointKind, trace};
use solver::{Options, Order};

/// `u'' = -(p - least)^power eᵘ`, `u(0) = u(1) = 0`, from `p = start`. Unless the power is an integer, the equations
/// are undefined for `p < least`; there is a fold where `(p - least)^power` is 3.5138307.
fn traced((least, power): (f64, f64), start: f64, options: &BranchOptions) -> Result<Branch, BranchError> {
    let bratu = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -(p[0] - least).powf(power) * y[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("p", start);
    trace(&bratu, &bratu.start(), 0, &[], options, &[])
}

#[test]
fn a_branch_ends_exactly_where_its_equations_do() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let solve = Options { order, ..Options::default() };
        let options = BranchOptions { solve, range: (0.0, 4.0), upwards: false, ..BranchOptions::default() };
        for power in [1.0, 1.5, 2.5] {
            let branch = traced((0.0, power), 1.0, &options).unwrap();
            let end = branch.points.last().unwrap();
            println!("{order:?}, power {power}: {:?} at {:e}", end.kind, end.parameter);
            assert_eq!((end.kind, end.parameter), (PointKind::End, 0.0), "{order:?}, power {power}");
            assert!(end.solution.regions()[0].eval(0.5)[0].abs() < 1e-9);
            assert!(branch.points.iter().all(|point| (0.0..=4.0).contains(&point.parameter)));
            assert!(branch.points.windows(2).all(|pair| pair[0].arclength <= pair[1].arclength));
        }
    }
}

#[test]
fn the_end_is_what_the_range_says_to_the_last_digit() {
    let at = |range: (f64, f64), start: f64, upwards: bool| {
        let branch = traced((0.0, 1.0), start, &BranchOptions { range, upwards, ..BranchOptions::default() }).unwrap();
        let end = branch.points.last().unwrap();
        assert_eq!(end.kind, PointKind::End, "{range:?}");
        (end.parameter, branch.folds().count())
    };
    assert_eq!(at((0.5, 0.5), 0.5, true), (0.5, 0));
    assert_eq!(at((0.1, 0.5), 0.5, true), (0.5, 0));
    assert_eq!(at((0.3, 2.0), 1.0, true), (2.0, 0));
    assert_eq!(at((0.3, 2.0), 1.0, false), (0.3, 0));
    // A fold just before the end is told, and one just behind it is not.
    assert_eq!(at((0.5, 3.51384), 1.0, true), (0.5, 1));
    assert_eq!(at((0.5, 3.51383), 1.0, true), (3.51383, 0));
}

#[test]
fn a_branch_whose_equations_end_before_the_range_does_is_lost() {
    let options = BranchOptions { range: (0.0, 4.0), upwards: false, ..BranchOptions::default() };
    let lost = traced((0.1, 1.5), 1.0, &options).unwrap_err();
    let last = lost.points.last().unwrap();
    assert!(last.kind == PointKind::Regular && (last.parameter - 0.1).abs() < 1e-4, "{}", last.parameter);
}
