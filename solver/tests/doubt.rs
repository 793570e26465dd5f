//! Linear problems whose conditions leave to rounding, or to meshes that are too coarse, what their equations amplify:
//! what is found is a solution, or none is.

use solver::bvp::{Bvp, Formulas, Number};
use solver::{BranchCheck, Options, Order, Solution, SolveError};

/// Two modes about (sin 3x, cos 2x), one that grows as exp(rate x) and one that decays half as fast, both of whose
/// amplitudes are stated at the left end.
fn from_the_left(rate: f64) -> Bvp<impl Formulas> {
    let (sine, cosine) = 0.7_f64.sin_cos();
    Bvp::new(
        &["u", "v"],
        (0.0, 1.0),
        move |x, y, _, f| {
            let (off_u, off_v) = (y[0] - (3.0 * x).sin(), y[1] - (2.0 * x).cos());
            let grows = (off_u * cosine + off_v * sine) * rate;
            let decays = (off_v * cosine - off_u * sine) * (-0.5 * rate);
            f[0] = grows * cosine - decays * sine + 3.0 * (3.0 * x).cos();
            f[1] = grows * sine + decays * cosine - 2.0 * (2.0 * x).sin();
        },
        |a, _, _, g| (g[0], g[1]) = (a[0], a[1] - 1.0),
    )
    .linear()
}

/// The largest distance from (sin 3x, cos 2x).
fn distance(solution: &Solution) -> f64 {
    let at = |i: usize| {
        let x = f64::from(i as u32) / 100.0;
        let y = solution.regions()[0].eval(x);
        (y[0] - (3.0 * x).sin()).abs().max((y[1] - (2.0 * x).cos()).abs())
    };
    (0..=100).map(at).fold(0.0, f64::max)
}

#[test]
fn a_mode_that_a_coarse_mesh_has_turned_round_is_seen_on_a_finer_one() -> Result<(), SolveError> {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for rate in [20.0, 25.0, 28.0, 30.0, 32.0] {
            for tolerance in [1e-2, 1e-4] {
                let options = Options { order, tolerance, ..Options::default() };
                match from_the_left(rate).solve(&options) {
                    Ok(solution) => {
                        let off = distance(&solution);
                        assert!(off <= 3.0 * tolerance, "{order:?} {rate} {tolerance}: {off:.1e}");
                    }
                    Err(SolveError::Newton { .. } | SolveError::Inaccurate { .. }) => {}
                    Err(error) => return Err(error),
                }
            }
        }
    }
    Ok(())
}

/// u = 1 and v = x, and two modes about them: exp(-sharp x²/2), which vanishes at both ends, and its inverse.
fn between(sharp: f64) -> Bvp<impl Formulas> {
    let (sine, cosine) = 0.7_f64.sin_cos();
    Bvp::new(
        &["u", "v"],
        (-1.0, 1.1),
        move |x, y, _, f| {
            let (off_u, off_v) = (y[0] - 1.0, y[1] - x);
            let bump = (off_u * cosine + off_v * sine) * (-sharp * x);
            let other = (off_v * cosine - off_u * sine) * (sharp * x);
            f[0] = bump * cosine - other * sine;
            f[1] = bump * sine + other * cosine + 1.0;
        },
        move |a, b, _, g| {
            let off = |y: &[Number], x: f64| (y[0] - 1.0, y[1] - x);
            let ((au, av), (bu, bv)) = (off(a, -1.0), off(b, 1.1));
            g[0] = au + av * 0.3;
            g[1] = bu - bv * 0.4;
        },
    )
    .guess(20, |_, y| y.fill(0.0))
    .linear()
}

#[test]
fn a_mode_that_vanishes_at_both_ends_is_no_part_of_a_solution() -> Result<(), SolveError> {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for sharp in [30.0, 40.0, 50.0, 60.0, 70.0, 100.0, 200.0, 400.0] {
            for tolerance in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
                let options = Options { order, tolerance, ..Options::default() };
                match between(sharp).solve(&options) {
                    // The determinant has had one sign on all meshes: nothing is known of it.
                    Ok(solution) if solution.branch_check() == BranchCheck::Kept => {}
                    Ok(solution) => {
                        let off = |x: f64| (solution.regions()[0].eval(x)[0] - 1.0).abs();
                        let off = (-50..=55).map(|i| off(f64::from(i) / 50.0)).fold(0.0, f64::max);
                        assert!(off <= 3.0 * tolerance, "{order:?} {sharp} {tolerance}: {off:.1e}");
                    }
                    Err(SolveError::Newton { .. } | SolveError::Inaccurate { .. } | SolveError::MeshLimit { .. }) => {}
                    Err(error) => return Err(error),
                }
            }
        }
    }
    Ok(())
}
