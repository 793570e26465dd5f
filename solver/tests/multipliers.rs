//! Floquet's multipliers: against an exact identity, integration from the left end, eigenvalues in closed form, and a
//! period doubling found by shooting.

#![allow(clippy::unwrap_used, clippy::disallowed_methods)]

use roessler::roessler;
use solver::bvp::{Bvp, Formulas};
use solver::continuation::{BranchOptions, PointKind, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Multipliers, Options, Orbit, Order, Problem, Region, Solution, SolveError, solve};
use std::f64::consts::{PI, TAU};

/// Rössler's equations; the example follows an orbit of theirs, and asserts where its period doubles.
#[path = "../examples/roessler.rs"]
mod roessler;

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::Eight, Order::SixGauss];

/// `u'' = μ (1 - u²) u' - u` in units of the unknown period, begun where u' = 0.
fn van_der_pol(mu: f64, period: f64) -> Bvp<impl Formulas> {
    Bvp::new(
        &["u", "v"],
        (0.0, 1.0),
        move |_, y, p, f| (f[0], f[1]) = (p[0] * y[1], p[0] * ((-y[0] * y[0] + 1.0) * y[1] * mu - y[0])),
        |a, b, _, g| (g[0], g[1], g[2]) = (a[1], b[0] - a[0], b[1] - a[1]),
    )
    .unknown("T", period)
    .guess(40, |x, y| (y[0], y[1]) = (2.0 * (TAU * x).cos(), -2.0 * (TAU * x).sin()))
}

/// Liouville: the product of all multipliers is exp(∫ trace) over a period, and one of them is 1.
#[test]
fn of_a_plane_orbit_one_is_1_and_the_other_as_liouville_says() {
    for (mu, period) in [(0.2, 6.3), (1.0, 6.5), (2.0, 7.6)] {
        for order in ORDERS {
            let problem = van_der_pol(mu, period);
            let solution = problem.solve(&Options { order, tolerance: 1e-9, ..Options::default() }).unwrap();
            let region = &solution.regions()[0];
            let count = 20_000;
            let mean: f64 =
                (0..count).map(|i| 1.0 - region.eval((f64::from(i) + 0.5) / f64::from(count))[0].powi(2)).sum();
            let wanted = (mu * solution.constants()[0] * mean / f64::from(count)).exp();
            let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Autonomous, 1e-9).unwrap();
            let [other] = multipliers.values() else { panic!("{multipliers:?}") };
            let trivial = multipliers.trivial().unwrap();
            assert!((trivial.re - 1.0).abs() < 3e-8 && trivial.im == 0.0, "{mu}, {order:?}: {trivial:?}");
            assert!((other.re - wanted).abs() < 3e-8, "{mu}, {order:?}: {other:?} for {wanted}");
            assert!(multipliers.is_stable() && multipliers.change() < 1e-9);
        }
    }
}

/// `y'' + 0.1 y' + (1.3 - 4 cos 2t) y = 0` beside the solution zero, which asks for no mesh: multipliers by classical
/// Runge-Kutta steps in place of collocation.
#[test]
fn meshes_are_halved_until_multipliers_have_settled() {
    let rates = |t: f64, y: [f64; 2]| [y[1], -0.1 * y[1] - (1.3 - 4.0 * (2.0 * t).cos()) * y[0]];
    let end = |mut y: [f64; 2]| {
        let steps = 4000;
        let h = PI / f64::from(steps);
        for i in 0..steps {
            let t = h * f64::from(i);
            let along = |k: [f64; 2], part: f64| [y[0] + part * h * k[0], y[1] + part * h * k[1]];
            let k1 = rates(t, y);
            let k2 = rates(t + 0.5 * h, along(k1, 0.5));
            let k3 = rates(t + 0.5 * h, along(k2, 0.5));
            let k4 = rates(t + h, along(k3, 1.0));
            let sum = |i: usize| (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]) / 6.0;
            y = [y[0] + h * sum(0), y[1] + h * sum(1)];
        }
        y
    };
    let [[a, c], [b, d]] = [end([1.0, 0.0]), end([0.0, 1.0])];
    let (half, root) = (0.5 * (a + d), (0.25 * (a + d).powi(2) - (a * d - b * c)).sqrt());
    let wanted = [half - root, half + root];
    for order in ORDERS {
        let problem = Bvp::new(
            &["y", "v"],
            (0.0, PI),
            |t, y, _, f| (f[0], f[1]) = (y[1], y[1] * -0.1 - y[0] * (1.3 - 4.0 * (2.0 * t).cos())),
            |a, b, _, g| (g[0], g[1]) = (b[0] - a[0], b[1] - a[1]),
        )
        .guess(4, |_, y| y.fill(0.0));
        let solution = problem.solve(&Options { order, ..Options::default() }).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Forced, 1e-7).unwrap();
        assert_eq!((solution.intervals(), multipliers.trivial()), (4, None));
        for (found, wanted) in multipliers.values().iter().zip(wanted) {
            assert!(
                (found.re - wanted).abs() < 1e-7 * wanted.abs().max(1.0) && found.im == 0.0,
                "{order:?}: {found:?}"
            );
        }
        assert!(!multipliers.is_stable() && (multipliers.largest() + wanted[0]).abs() < 1e-6);
        assert!(multipliers.change() <= 1e-7 && multipliers.stats().factorisations > 2);
        // One is beyond -1, the other within.
        assert!(multipliers.doubling() < 0.0);
    }
}

/// Growth by e^30, decay by e^-40, and between them a rotation that is known to rounding all the same.
#[test]
fn growth_and_decay_of_any_size_leave_those_on_the_unit_circle_alone() {
    for order in ORDERS {
        let problem = Bvp::new(
            &["grows", "decays", "x", "y"],
            (0.0, 1.0),
            |_, z, _, f| {
                // Mixed, so that no state is one of the four by itself.
                let [grows, decays] = [(z[0] - z[2]) * 30.0, (z[1] + z[3]) * -40.0];
                (f[2], f[3]) = (z[3] * -2.5, z[2] * 2.5);
                (f[0], f[1]) = (grows + f[2], decays - f[3]);
            },
            |a, b, _, g| (0..4).for_each(|i| g[i] = b[i] - a[i]),
        )
        .guess(64, |_, y| y.fill(0.0));
        let solution = problem.solve(&Options { order, ..Options::default() }).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Forced, 1e-9).unwrap();
        let [grows, first, second, decays] = multipliers.values() else { panic!("{multipliers:?}") };
        for (sign, value) in [(1.0, first), (-1.0, second)] {
            assert!((value.modulus() - 1.0).abs() < 1e-11, "{order:?}: {value:?}");
            assert!((value.angle() - sign * 2.5).abs() < 1e-8, "{order:?}: {value:?}");
        }
        // 1e13 is known to three digits, 4e-18 as nothing.
        assert!((grows.modulus().ln() - 30.0).abs() < 1e-2, "{order:?}: {grows:?}");
        assert!(decays.modulus() < 1e-13, "{order:?}: {decays:?}");
    }
}

/// A spiral with multipliers exp(a ± 2.5i).
#[test]
fn a_pair_that_crosses_the_unit_circle_changes_the_sign_of_its_test_function() {
    for growth in [-0.2_f64, -1e-3, 1e-3, 0.2] {
        let problem = Bvp::new(
            &["x", "y"],
            (0.0, 1.0),
            move |_, z, _, f| (f[0], f[1]) = (z[0] * growth - z[1] * 2.5, z[0] * 2.5 + z[1] * growth),
            |a, b, _, g| (g[0], g[1]) = (b[0] - a[0], b[1] - a[1]),
        );
        let solution = problem.solve(&Options::default()).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Forced, 1e-8).unwrap();
        let wanted = (1.0 - (2.0 * growth).exp()) / (1.0 + (2.0 * growth).exp());
        assert!((multipliers.torus() - wanted).abs() < 1e-7, "{growth}: {multipliers:?}");
        assert!(multipliers.doubling() > 0.0 && multipliers.is_stable() == (growth < 0.0));
        let [first, second] = multipliers.values() else { panic!("{multipliers:?}") };
        assert!(first.re == second.re && first.im == -second.im && first.im > 0.0);
    }
}

/// At c = 2.5, multipliers by shooting with SciPy's DOP853 at 1e-13: -0.769693642 and -5.174e-6.
#[test]
fn those_of_a_strongly_contracting_orbit_are_those_found_by_shooting() {
    for order in ORDERS {
        let problem = roessler(2.5);
        let solution = problem.solve(&Options { order, tolerance: 1e-8, ..Options::default() }).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Autonomous, 1e-8).unwrap();
        let [first, second] = multipliers.values() else { panic!("{multipliers:?}") };
        assert!((first.re + 0.769_693_642).abs() < 2e-7, "{order:?}: {multipliers:?}");
        assert!((second.re + 5.174e-6).abs() < 1e-7, "{order:?}: {multipliers:?}");
    }
}

/// Lorenz's equations beside their homoclinic orbit, by whose saddle an orbit grows and shrinks: three real multipliers
/// from 3e3 down to nothing. By Liouville their product is exp(-41/3 T), and no torus is born.
#[test]
fn three_real_ones_of_very_different_size_are_no_pair() {
    let orbit = Bvp::new(
        &["x", "y", "z"],
        (0.0, 1.0),
        |_, u, p, f| {
            f[0] = p[1] * (u[1] - u[0]) * 10.0;
            f[1] = p[1] * (p[0] * u[0] - u[1] - u[0] * u[2]);
            f[2] = p[1] * (u[0] * u[1] - u[2] * (8.0 / 3.0));
        },
        |a, b, _, g| {
            (0..3).for_each(|i| g[i] = b[i] - a[i]);
            g[3] = a[1] - a[0];
        },
    )
    .given("rho", 24.0)
    .unknown("T", 0.66)
    .guess(40, |t, u| {
        let (x, turn) = ((8.0_f64 / 3.0 * 23.0).sqrt(), TAU * t);
        u.copy_from_slice(&[x + 2.0 * turn.cos(), x + 2.0 * turn.cos() - 2.0 * turn.sin(), 23.0 + 3.0 * turn.sin()]);
    });
    let of = |solution: &Solution| Multipliers::new(&orbit, solution, 0, Orbit::Autonomous, 1e-6).unwrap();
    let torus = |solution: &Solution| of(solution).torus();
    let solve = Options { tolerance: 1e-5, ..Options::default() };
    let options =
        BranchOptions { solve, range: (13.96, 24.5), upwards: false, largest_step: 0.2, ..BranchOptions::default() };
    let branch = trace(&orbit, &orbit.start(), 0, orbit.unknowns(), &options, &[&torus]).unwrap();
    assert!(branch.points.iter().all(|point| !matches!(point.kind, PointKind::Event(_))));
    let largest = branch.points.iter().map(|point| {
        let multipliers = of(&point.solution);
        let trivial = multipliers.trivial().unwrap();
        assert!((trivial.re - 1.0).abs() < 0.05 && trivial.im == 0.0, "{}: {multipliers:?}", point.parameter);
        assert!(multipliers.values().iter().all(|value| value.im == 0.0 && value.re > -1e-8), "{multipliers:?}");
        multipliers.largest()
    });
    assert!(largest.fold(0.0, f64::max) > 500.0);
}

/// Growth by e^36 leaves a multiplier without a digit: no sign is taken from it.
#[test]
fn a_multiplier_without_a_digit_has_no_sign() {
    for (growth, known) in [(20.0, true), (36.0, false)] {
        let problem = Bvp::new(
            &["grows", "decays"],
            (0.0, 1.0),
            move |_, z, _, f| (f[0], f[1]) = (z[0] * growth - z[1], z[1] * -2.0 + z[0]),
            |a, b, _, g| (g[0], g[1]) = (b[0] - a[0], b[1] - a[1]),
        );
        let solution = problem.solve(&Options::default()).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Forced, 1e-8).unwrap();
        let signs = [multipliers.doubling(), multipliers.torus()];
        assert_eq!(signs.map(f64::is_nan), [!known; 2], "{multipliers:?}");
    }
}

#[test]
fn a_period_doubling_is_located_along_a_branch() {
    roessler::main().unwrap();
}

#[test]
fn what_there_is_not_is_said() {
    let problem = van_der_pol(1.0, 6.5);
    let solution = problem.solve(&Options::default()).unwrap();
    let error = Multipliers::new(&problem, &solution, 1, Orbit::Autonomous, 1e-6).unwrap_err();
    assert_eq!(error, SolveError::Region { index: 1, regions: 1 });
    assert!(error.to_string().contains("no region 1") && !error.advice().is_empty());
    for tolerance in [0.0, -1.0, f64::NAN] {
        let error = Multipliers::new(&problem, &solution, 0, Orbit::Autonomous, tolerance).unwrap_err();
        assert!(matches!(error, SolveError::Option { name: "tolerance", .. }), "{error}");
    }
    assert_eq!(problem.layout().regions.len(), 1);
}

/// Two states that follow a forcing of period 1, over (0, 1) and (1, 2): one orbit of period 2, or two of period 1.
struct Halves {
    one_orbit: bool,
}

impl Model for Halves {
    fn layout(&self) -> Layout {
        let half = |name: &str, interval| Region::dense(name, interval, &["x", "y"], &[], 1);
        Layout::dense(vec![half("first", (0.0, 1.0)), half("second", (1.0, 2.0))], &["kappa"], &["a", "b", "c", "d"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        let forcing = (s * TAU).cos();
        (f[0], f[1]) = (-c[0] * (y[0] - forcing), -c[0] * (y[1] - y[0]));
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        // Ends: entry and exit of the first, entry and exit of the second.
        let [of_first, of_second] = if self.one_orbit { [6, 2] } else { [2, 6] };
        for i in 0..2 {
            (g[i], g[i + 2]) = (e[of_first + i] - e[i], e[of_second + i] - e[4 + i]);
        }
    }
}

/// A region of an orbit in several has multipliers of its own, which are not the orbit's.
#[test]
fn an_orbit_in_several_regions_is_refused_and_several_orbits_are_not() {
    for one_orbit in [true, false] {
        // Patterns are dense: what ties regions together is what the derivatives say.
        let problem = Differentiated::new(Halves { one_orbit }).unwrap();
        let guess = Guess::uniform(problem.layout(), 10, &[2.0], |_, _, y| y.fill(0.0));
        let solution = solve(&problem, &guess, &[], &Options::default()).unwrap();
        for region in 0..2 {
            let found = Multipliers::new(&problem, &solution, region, Orbit::Forced, 1e-6);
            if one_orbit {
                let text = found.unwrap_err().to_string();
                assert!(text.contains("first") && text.contains("second"), "{text}");
            } else {
                let found = found.unwrap();
                assert!((found.largest() - (-2.0_f64).exp()).abs() < 1e-3, "{found:?}");
            }
        }
    }
}
