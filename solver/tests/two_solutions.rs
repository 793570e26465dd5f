//! Problems of the literature with two solutions: from whatever guess, the solution is one of them, and the branch
//! check says when it cannot be vouched for.

#![allow(clippy::unwrap_used)]

use solver::bvp::{Bvp, Formulas};
use solver::{BranchCheck, Options, Order, Orientation};

/// A shallow spherical cap under load (U. Ascher, J. Christiansen and R. D. Russell, ACM Trans. Math. Softw. 7 (1981),
/// example 2), divided by x: `φ = x a`, `ψ = x b` with `ε⁴/μ (a'' + 3a'/x) = a - b (1 - a) - γ (1 - x²/2)`,
/// `μ (b'' + 3b'/x) = a (1 - a/2)`; `a(1) = 0`, `b'(1) + 0.7 b(1) = -0.7`.
fn cap(mu: f64) -> Bvp<impl Formulas> {
    let (epsilon, gamma) = (0.01_f64, 1.1);
    let bending = epsilon.powi(4) / mu;
    Bvp::new(
        &["a", "a'", "b", "b'"],
        (0.0, 1.0),
        move |x, y, _, f| {
            (f[0], f[2]) = (y[1], y[3]);
            f[1] = (y[0] - y[2] * (1.0 - y[0]) - gamma * (1.0 - 0.5 * x * x)) / bending;
            f[3] = y[0] * (1.0 - 0.5 * y[0]) / mu;
        },
        |a, b, _, g| (g[0], g[1], g[2], g[3]) = (a[1], a[3], b[0], b[3] + 0.7 * b[2] + 0.7),
    )
    .singular_term(&[&[0.0; 4], &[0.0, -3.0, 0.0, 0.0], &[0.0; 4], &[0.0, 0.0, 0.0, -3.0]])
    .unwrap()
}

#[test]
fn the_cap_has_two_solutions_and_zero_is_near_neither() {
    let mut found = Vec::new();
    for order in [Order::Four, Order::Six, Order::Eight] {
        for (guess, intervals) in [(0, 20), (0, 40), (1, 20), (1, 40)] {
            let cap = cap(0.01).guess(intervals, move |x, y| {
                y.fill(0.0);
                if guess == 1 {
                    // The second guess of the reference: dimpled up to where a shell without bending would be.
                    let (a, sign) = if x <= (0.2_f64 / 1.1).sqrt() { (2.0, 1.0) } else { (0.0, -1.0) };
                    (y[0], y[2], y[3]) = (a, -a + sign * 1.1 * (1.0 - 0.5 * x * x), -sign * 1.1 * x);
                }
            });
            let solution = cap.solve(&Options { order, ..Options::default() }).unwrap();
            let height = solution.regions()[0].eval(0.0)[0];
            println!(
                "{order:?} guess {guess} on {intervals}: a(0) = {height}, {:?}, {:?}",
                solution.branch_check(),
                solution.orientation()
            );
            found.push((guess, height, solution.branch_check()));
        }
    }
    assert_eq!(found.len(), 12);
    for (guess, height, check) in found {
        // The cap is slightly bent, or dimpled: nothing else is called a solution.
        assert!((height - 0.04738).abs() < 1e-4 || (height - 2.0414).abs() < 1e-4, "{height}");
        if guess == 0 {
            // Zero is near neither.
            assert_ne!(check, BranchCheck::Kept, "{height}");
        } else if check == BranchCheck::Kept {
            assert!((height - 2.0414).abs() < 1e-4, "kept, and yet {height}");
        }
    }
}

/// Painlevé's first transcendent between 0 and 10: `y'' = y² - x`, `y(0) = 0`, `y(10) = √10`. One solution rises at
/// once, y'(0) = 0.92437548 (P. Holmes and D. Spence, Q. J. Mech. Appl. Math. 37 (1984) 525-538); others fall first.
#[test]
fn painleve_s_equation_has_its_two_solutions_and_says_which_was_not_near() {
    let line = |intervals: usize, slope: f64| {
        Bvp::new(
            &["y", "slope"],
            (0.0, 10.0),
            |x, y, _, f| (f[0], f[1]) = (y[1], y[0] * y[0] - x),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - 10.0_f64.sqrt()),
        )
        .guess(intervals, move |x, y| {
            let dip = slope * x * (-x).exp();
            (y[0], y[1]) = (x.sqrt() + dip, 0.5 / x.max(0.05).sqrt() + slope * (1.0 - x) * (-x).exp());
        })
    };
    let mut slopes = Vec::new();
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for tolerance in [1e-6, 1e-11] {
            for slope in [0.0, -7.0] {
                for intervals in [20, 40, 80] {
                    let options = Options { order, tolerance, ..Options::default() };
                    let solution = line(intervals, slope).solve(&options).unwrap();
                    let (found, check) = (solution.regions()[0].state(1)[0], solution.branch_check());
                    println!("{order:?} {tolerance:e} {slope} on {intervals}: {found}, {check:?}");
                    if slope == 0.0 {
                        assert_eq!(check, BranchCheck::Kept);
                    }
                    let rising = (found - 0.92437548).abs() < 1e-5;
                    assert!(rising || found < 0.0, "{found}");
                    if check == BranchCheck::Kept {
                        assert_eq!(rising, slope == 0.0, "kept, and yet {found}");
                    }
                    slopes.push((rising, solution.orientation()));
                }
            }
        }
    }
    // Unlike orientations: no path without a fold joins the one that rises to those that were found beside it.
    for (rising, orientation) in slopes {
        assert_eq!(orientation, Some(if rising { Orientation::Positive } else { Orientation::Negative }));
    }
}
