//! Equations that are defined for some values of their states only: rough meshes lead to where they are not.

#![allow(clippy::unwrap_used, clippy::panic)]

use solver::bvp::{Bvp, Number};
use solver::{Options, Order, Solution};

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

/// `u'' = rhs(u, u')` with u(0) = 1 and u(1) = 0.5, from a constant guess, by each order from few intervals and more.
fn from_everywhere(rhs: fn(Number, Number) -> Number) -> Vec<(String, Solution)> {
    let bvp = || {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            move |_, y, _, f| (f[0], f[1]) = (y[1], rhs(y[0], y[1])),
            |a, b, _, g| (g[0], g[1]) = (a[0] - 1.0, b[0] - 0.5),
        )
    };
    let mut found = Vec::new();
    for order in ORDERS {
        for (intervals, value) in [(4, 1.0), (4, 0.2), (10, 1.0), (20, 0.2)] {
            let what = format!("{order:?} from {intervals} intervals and {value}");
            let options = Options { order, ..Options::default() };
            match bvp().guess(intervals, |_, y| y[0] = value).solve(&options) {
                Ok(solution) => found.push((what, solution)),
                Err(error) => panic!("{what}: {error}"),
            }
        }
    }
    found
}

fn agree(found: &[(String, Solution)]) {
    let at = |solution: &Solution| [0.01, 0.3, 0.9, 0.99].map(|s| solution.regions()[0].eval(s)[0]);
    let first = at(&found[0].1);
    for (what, solution) in found {
        for (a, b) in at(solution).iter().zip(first) {
            assert!((a - b).abs() < 1e-4, "{what}: {a} for {b}");
        }
    }
}

/// A logarithm with a layer at the right end, where rough meshes go below zero between their nodes.
#[test]
fn a_logarithm_is_solved_from_rough_meshes() {
    agree(&from_everywhere(|u, _| u.ln() * 1e4));
}

/// Two roots: a reaction that stops when nothing is left, and a flow.
#[test]
fn roots_are_solved_from_rough_meshes() {
    agree(&from_everywhere(|u, _| ((u + 1e-2).sqrt() - 0.1) * 1e3));
    agree(&from_everywhere(|u, slope| u - u.sqrt() * slope * 100.0));
}

/// Where it loses its way, the method of Gauss points begins with another order, as orders 4, 6 and 8 do: the boundary
/// layer on a flat plate, from zero on ten intervals for a length of 300.
#[test]
fn gauss_points_begin_with_another_order() {
    let plate = Bvp::of_higher_order(
        &[("f", 3)],
        (0.0, 300.0),
        |_, z, _, h| h[0] = z[0] * z[2] * -0.5,
        |a, b, _, g| (g[0], g[1], g[2]) = (a[0], a[1], b[1] - 1.0),
    );
    let plate = plate.unwrap().guess(10, |_, y| y.fill(0.0));
    let found = plate.solve(&Options { order: Order::SixGauss, ..Options::default() }).unwrap();
    assert!((found.regions()[0].state(2)[0] - 0.332057336215195).abs() < 1e-5);
    let alone = Options { order: Order::SixGauss, other_orders: false, ..Options::default() };
    assert!(plate.solve(&alone).is_err());
}
