//! Terms `S y/x` that are singular at the left end, against exact solutions.

#![allow(clippy::unwrap_used)]

use solver::bvp::{Bvp, SingularTermError};
use solver::{Accuracy, Options, Order};

/// Emden's equation `u'' + 2 u'/x + u⁵ = 0`: `u = (1 + x²/3)^(-1/2)`.
#[test]
fn emden_s_equation_is_solved_to_its_tolerance_at_both_orders() {
    let edge = 0.75_f64.sqrt();
    for (order, tolerance) in [(Order::Four, 1e-6), (Order::Four, 1e-9), (Order::Six, 1e-6), (Order::Six, 1e-11)] {
        let star = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, _, f| (f[0], f[1]) = (y[1], -y[0].powi(5)),
            move |a, b, _, g| (g[0], g[1]) = (a[1], b[0] - edge),
        )
        .singular_term(&[&[0.0, 0.0], &[0.0, -2.0]])
        .unwrap()
        .guess(5, |_, y| (y[0], y[1]) = (edge, 0.0));
        let solution = star.solve(&Options { order, tolerance, ..Options::default() }).unwrap();
        assert_eq!(solution.accuracy(), Accuracy::Met);
        let line = &solution.regions()[0];
        let exact = |x: f64| (1.0 + x * x / 3.0).powf(-0.5);
        let error = (0..=100).map(|k| f64::from(k) / 100.0).map(|x| (line.eval(x)[0] - exact(x)).abs());
        let error = error.fold(0.0, f64::max);
        println!("{order:?} {tolerance:e}: {error:e}, {} intervals", solution.intervals());
        assert!(error <= tolerance, "{order:?} {tolerance:e}: {error:e}");
        // The second derivative at the centre is -1/3; each derivative costs an order.
        assert!((line.eval_curvature(0.0)[0] + 1.0 / 3.0).abs() < tolerance.sqrt());
    }
}

/// Bessel's equation of order ν with an unknown wave number: `u'' + u'/x + (k² - ν²/x²) u = 0`. With `u = x^ν w`
/// it is `w'' + (1 + 2ν) w'/x + k² w = 0`, and `w(1) = 0` at the zeros of J_ν; the interval begins at 1 here to see
/// that the distance from the end counts.
#[test]
fn zeros_of_bessel_functions_are_found() {
    for (order, half_waves, near, zero) in [
        (0.0, 0.5, 2.3, 2.404_825_557_695_773),
        (0.0, 1.5, 5.4, 5.520_078_110_286_311),
        (1.0, 0.5, 3.7, 3.831_705_970_207_512),
    ] {
        let wave = half_waves * std::f64::consts::PI;
        let drum = Bvp::new(
            &["w", "slope"],
            (1.0, 2.0),
            |_, y, p, f| (f[0], f[1]) = (y[1], -p[0].powi(2) * y[0]),
            |a, b, _, g| (g[0], g[1], g[2]) = (a[0] - 1.0, a[1], b[0]),
        )
        .unknown("k", near)
        .singular_term(&[&[0.0, 0.0], &[0.0, -1.0 - 2.0 * order]])
        .unwrap()
        .guess(10, |x, y| (y[0], y[1]) = ((wave * (x - 1.0)).cos(), -wave * (wave * (x - 1.0)).sin()));
        let solution = drum.solve(&Options { order: Order::Six, tolerance: 1e-9, ..Options::default() }).unwrap();
        assert!((solution.constants()[0] - zero).abs() < 1e-8, "{} for {zero}", solution.constants()[0]);
    }
}

#[test]
fn a_matrix_that_does_not_suit_is_refused() {
    let line = || {
        Bvp::new(
            &["u", "v"],
            (0.0, 1.0),
            |_, y, _, f| (f[0], f[1]) = (y[1], y[0]),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        )
    };
    let refused = |matrix: &[&[f64]]| line().singular_term(matrix).err();
    assert_eq!(refused(&[&[0.0, 0.0]]), Some(SingularTermError::Shape { states: 2 }));
    assert_eq!(refused(&[&[0.0, 0.0], &[0.0]]), Some(SingularTermError::Shape { states: 2 }));
    assert_eq!(refused(&[&[0.0, f64::NAN], &[0.0, 0.0]]), Some(SingularTermError::NotFinite));
    assert_eq!(refused(&[&[0.0, 0.0], &[0.0, 1.0]]), Some(SingularTermError::EigenvalueOne));
    assert_eq!(refused(&[&[0.0, 0.0], &[0.0, -2.0]]), None);
}
