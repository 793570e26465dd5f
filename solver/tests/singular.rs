//! Equations that are singular at an end, against exact solutions: terms `S y/x`, and whatever else open ends do
//! without.

#![allow(clippy::unwrap_used)]

#[path = "testset/problems/special.rs"]
#[allow(dead_code, reason = "the test set's, of which one function is wanted")]
mod special;

use solver::bvp::{Bvp, Formulas, SingularTermError};
use solver::continuation::{BranchOptions, trace};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Accuracy, Control, Guess, Layout, Linearisation, NewtonError, Options, Order, Problem, Region, Solution,
    SolveError, solve,
};

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

/// `J_n(x)`.
fn bessel(order: i32, x: f64) -> f64 {
    special::bessel(f64::from(order), (1..=order).map(f64::from).product(), x)
}

/// The largest error of the first state at a thousand places, relative to its largest magnitude there, or to 1.
fn error(solution: &Solution, exact: impl Fn(f64) -> f64) -> f64 {
    let line = &solution.regions()[0];
    let (a, b) = (line.mesh()[0], line.mesh()[line.intervals()]);
    let places = || (0..=1000).map(|k| a + (b - a) * f64::from(k) / 1000.0);
    let size = places().fold(0.0, |size: f64, x| size.max(exact(x).abs()));
    places().fold(0.0, |error: f64, x| error.max((line.eval(x)[0] - exact(x)).abs())) / size.max(1.0)
}

/// Methods whose ends may be open.
const OPEN: [Order; 2] = [Order::Eight, Order::SixGauss];

fn to(order: Order, tolerance: f64) -> Options {
    Options { order, tolerance, ..Options::default() }
}

/// By both methods, from several meshes, of which stretches are filled up or not, with and without defect correction.
fn is_solved<M: Formulas>(name: &str, tolerances: &[f64], problem: impl Fn(usize) -> Bvp<M>, exact: fn(f64) -> f64) {
    for (order, &tolerance) in OPEN.into_iter().flat_map(|order| tolerances.iter().map(move |at| (order, at))) {
        for intervals in [4, 7, 10, 33] {
            for defect_correction in [false, true] {
                let case = format!("{name}, {order:?}, {tolerance:e} from {intervals}");
                let options = Options { defect_correction, ..to(order, tolerance) };
                println!("{case}");
                let solution = problem(intervals).solve(&options).unwrap();
                let error = error(&solution, exact);
                println!("{error:e} on {}", solution.intervals());
                assert_eq!(solution.accuracy(), Accuracy::Met);
                assert!(error <= tolerance, "{case}: {error:e}");
                let line = &solution.regions()[0];
                let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
                assert!((0..line.states()).all(|i| finite(line.state(i)) && finite(line.slope(i))));
            }
        }
    }
}

/// Emden's equation as it stands: 0/0 at the centre, which lies at the left end, at the right one, or far from 0.
#[test]
fn what_is_0_over_0_at_an_end_is_solved() {
    let edge = 0.75_f64.sqrt();
    let star = |centre: f64, (a, b): (f64, f64), intervals: usize| {
        let on_the_left = a == centre;
        Bvp::new(
            &["u", "slope"],
            (a, b),
            move |x, y, _, f| (f[0], f[1]) = (y[1], -(y[1] * (2.0 / (x - centre))) - y[0].powi(5)),
            move |a, b, _, g| {
                let (inner, outer) = if on_the_left { (a, b) } else { (b, a) };
                (g[0], g[1]) = (inner[1], outer[0] - edge);
            },
        )
        .guess(intervals, |_, y| (y[0], y[1]) = (1.0, 0.0))
    };
    let tolerances = [1e-3, 1e-6, 1e-10];
    let exact = |x: f64| (1.0 + x * x / 3.0).powf(-0.5);
    is_solved("left", &tolerances, |intervals| star(0.0, (0.0, 1.0), intervals), exact);
    is_solved("right", &tolerances, |intervals| star(0.0, (-1.0, 0.0), intervals), exact);
    is_solved(
        "away",
        &tolerances,
        |intervals| star(50.0, (50.0, 51.0), intervals),
        |x| (1.0 + (x - 50.0).powi(2) / 3.0).powf(-0.5),
    );
}

/// `u'' + u'/x + (1 - n²/x²) u = 0`, said to be linear or not: terms that are infinite, and cancel.
#[test]
fn poles_whose_terms_cancel_are_solved() {
    fn wave<const ORDER: i32>(intervals: usize) -> Bvp<impl Formulas> {
        let pole = f64::from(ORDER * ORDER);
        Bvp::new(
            &["u", "slope"],
            (0.0, 8.0),
            move |x, y, _, f| (f[0], f[1]) = (y[1], y[0] * (pole / (x * x) - 1.0) - y[1] / x),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - bessel(ORDER, 8.0)),
        )
        .guess(intervals, |_, y| y.fill(0.0))
    }
    let tolerances = [1e-3, 1e-6, 1e-9];
    is_solved("order 1", &tolerances, wave::<1>, |x| bessel(1, x));
    is_solved("order 2, linear", &tolerances, |intervals| wave::<2>(intervals).linear(), |x| bessel(2, x));
    is_solved("order 5", &tolerances, wave::<5>, |x| bessel(5, x));
    is_solved("order 5, linear", &tolerances, |intervals| wave::<5>(intervals).linear(), |x| bessel(5, x));
    // Slopes at the end do not depend on what is said.
    for order in OPEN {
        let options = to(order, 1e-6);
        let [plain, linear] = [wave::<2>(20), wave::<2>(20).linear()].map(|wave| wave.solve(&options).unwrap());
        for state in [0, 1] {
            let [plain, linear] = [&plain, &linear].map(|solution| solution.regions()[0].slope(state)[0]);
            assert!((plain - linear).abs() < 1e-9, "{order:?}: {plain} and {linear}");
        }
    }
}

/// `x² u'' = 2 u + 7/4 x^(5/2)`, `u = x^(5/2)`: what is said to be linear is looked at where it is defined alone.
#[test]
fn what_is_not_smooth_may_be_said_to_be_linear() {
    let euler = |intervals: usize| {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |x, y, _, f| (f[0], f[1]) = (y[1], y[0] * (2.0 / (x * x)) + 1.75 * x.sqrt()),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - 1.0),
        )
        .guess(intervals, |_, y| y.fill(0.0))
        .linear()
    };
    is_solved("Euler", &[1e-3, 1e-6, 1e-8, 1e-9], euler, |x| x.powf(2.5));
}

/// Legendre's equation on (-1, 1), with an unknown eigenvalue near that of P₄; and slopes that are infinite.
#[test]
fn both_ends_may_be_singular_and_slopes_infinite() {
    let polynomial = |x: f64| (35.0 * x.powi(4) - 30.0 * x * x + 3.0) / 8.0;
    let legendre = |intervals: usize| {
        Bvp::new(
            &["u", "slope"],
            (-1.0, 1.0),
            |x, y, p, f| (f[0], f[1]) = (y[1], (y[1] * (2.0 * x) - p[0] * y[0]) / (1.0 - x * x)),
            |a, b, p, g| {
                (g[0], g[1], g[2]) = (a[0] - 1.0, a[1] * 2.0 + p[0] * a[0], b[1] * 2.0 - p[0] * b[0]);
            },
        )
        .unknown("eigenvalue", 19.0)
        .guess(intervals, move |x, y| (y[0], y[1]) = (polynomial(x), (140.0 * x.powi(3) - 60.0 * x) / 8.0))
    };
    is_solved("Legendre", &[1e-4, 1e-6, 1e-9], legendre, polynomial);
    for order in OPEN {
        let solution = legendre(10).solve(&to(order, 1e-10)).unwrap();
        assert!((solution.constants()[0] - 20.0).abs() < 1e-8, "{order:?}: {}", solution.constants()[0]);
    }
    // Legendre's of order 2 with a source: both open ends in one interval, or in one vector of them.
    let associated = |intervals: usize| {
        Bvp::new(
            &["u", "slope"],
            (-1.0, 1.0),
            |x, y, _, f| {
                let (q, source) = (1.0 - x * x, x.exp() * (x * (x * (x * (x + 6.0) + 4.0) - 6.0) - 5.0));
                (f[0], f[1]) = (y[1], (y[1] * (2.0 * x) + y[0] * (4.0 / q) + source) / q);
            },
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        )
        .guess(intervals, |_, y| y.fill(0.0))
    };
    let source = |x: f64| (1.0 - x * x) * x.exp();
    for (order, intervals) in OPEN.into_iter().flat_map(|order| [1, 2, 3, 5].map(|intervals| (order, intervals))) {
        for problem in [associated(intervals), associated(intervals).linear()] {
            let rough = Options { control: Control::Defect, newton_tolerance: Some(1e-12), ..to(order, 10.0) };
            assert_eq!(problem.solve(&rough).unwrap().stats().newton_iterations, 1, "{order:?} on {intervals}");
            let error = error(&problem.solve(&to(order, 1e-8)).unwrap(), source);
            assert!(error <= 1e-8, "{order:?} from {intervals}: {error:e}");
        }
    }
    let root = |intervals: usize| {
        Bvp::new(&["u"], (0.0, 1.0), |x, y, _, f| f[0] = y[0] * 0.0 + 0.5 / x.sqrt(), |a, _, _, g| g[0] = a[0])
            .guess(intervals, |_, y| y[0] = 0.0)
    };
    is_solved("√x", &[1e-3, 1e-6], root, f64::sqrt);
}

/// Of halved intervals nodes are 2⁶ times better by either method: what is left of order 8 in the interval beside an
/// open end is of that order, too.
#[test]
fn nodes_are_of_order_6_beside_a_singular_end_too() {
    let worst = |order: Order, intervals: usize| {
        let wave = Bvp::new(
            &["u", "slope"],
            (0.0, 2.0),
            |x, y, _, f| (f[0], f[1]) = (y[1], -(y[1] / x) - y[0]),
            |a, b, _, g| (g[0], g[1]) = (a[1], b[0] - bessel(0, 2.0)),
        )
        .guess(intervals, |_, y| y.fill(0.0));
        let options = to(order, 1.0);
        let rough = Options { control: Control::Defect, newton_tolerance: Some(1e-12), ..options };
        let solution = wave.solve(&rough).unwrap();
        assert_eq!(solution.intervals(), intervals);
        let line = &solution.regions()[0];
        line.mesh().iter().zip(line.state(0)).fold(0.0, |worst: f64, (&x, u)| worst.max((u - bessel(0, x)).abs()))
    };
    for intervals in [2, 4, 8] {
        let errors = OPEN.map(|order| worst(order, intervals));
        let ratios = OPEN.map(|order| worst(order, intervals) / worst(order, 2 * intervals));
        println!("{intervals}: {errors:?}, {ratios:?}");
        assert!(ratios.iter().all(|ratio| (45.0..90.0).contains(ratio)), "{intervals}: {ratios:?}");
        assert!(errors[0] < errors[1], "{intervals}: {errors:?}");
    }
}

#[test]
fn what_is_undefined_elsewhere_or_at_other_orders_is_told() {
    let star = |singular: f64| {
        Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            move |x, y, _, f| (f[0], f[1]) = (y[1], -(y[1] * (2.0 / (x - singular).max(0.0).sqrt())) - y[0]),
            |a, b, _, g| (g[0], g[1]) = (a[1], b[0] - 1.0),
        )
    };
    for order in [Order::Four, Order::Six] {
        let error = star(0.0).solve(&Options { order, ..Options::default() }).unwrap_err();
        let SolveError::Newton { error: NewtonError::NonFinite(what), .. } = &error else { panic!("{error}") };
        assert_eq!(what.position, Some(0.0), "{order:?}: {error}");
        assert!(error.advice().contains("Order::Eight"), "{}", error.advice());
    }
    for order in OPEN {
        assert!(star(0.0).solve(&to(order, 1e-6)).is_ok());
        let error = star(0.3).solve(&to(order, 1e-6)).unwrap_err();
        let SolveError::Newton { error: NewtonError::NonFinite(what), .. } = &error else { panic!("{error}") };
        assert!(what.position.is_some_and(|x| 0.0 < x && x < 0.301), "{error}");
    }
}

/// `u'' + u'/x + k² u = 0` with u = 1 at 1: `J₀(k x)/J₀(k)`, and its rate with k.
#[test]
fn sensitivities_are_those_of_the_exact_solution() {
    let drum = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |x, y, p, f| (f[0], f[1]) = (y[1], -(y[1] / x) - p[0] * p[0] * y[0]),
        |a, b, _, g| (g[0], g[1]) = (a[1], b[0] - 1.0),
    )
    .given("k", 1.5);
    // d(1/J₀(k))/dk.
    let exact = bessel(1, 1.5) / bessel(0, 1.5).powi(2);
    for order in OPEN {
        let solution = drum.solve(&to(order, 1e-10)).unwrap();
        let linearisation = Linearisation::new(&drum, &solution).unwrap();
        let rate = linearisation.sensitivity(0).regions[0].states[0][0];
        assert!((rate - exact).abs() < 1e-8, "{order:?}: {rate} for {exact}");
        let inputs = [1.0, 0.0, 0.0, 0.0, 0.0];
        let functional = solver::Functional { inputs: inputs.to_vec(), ..solver::Functional::default() };
        let gradient = linearisation.gradient(&functional)[0];
        assert!((gradient - exact).abs() < 1e-8, "{order:?}: {gradient} for {exact}");
    }
}

/// Gelfand's problem in a ball, `u'' + 2 u'/x + λ e^u = 0`: its first fold lies at λ = 3.32199.
#[test]
fn branches_are_traced_through_folds() {
    let ball = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |x, y, p, f| (f[0], f[1]) = (y[1], -(y[1] * (2.0 / x)) - p[0] * y[0].exp()),
        |a, b, _, g| (g[0], g[1]) = (a[1], b[0]),
    )
    .given("lambda", 0.5);
    for order in OPEN {
        let solve = to(order, 1e-6);
        let options = BranchOptions { solve, range: (0.0, 10.0), max_points: 20, ..BranchOptions::default() };
        let branch = trace(&ball, &ball.start(), 0, &[], &options, &[]).unwrap();
        let fold = branch.folds().next().unwrap();
        assert!((fold.parameter - 3.321_992).abs() < 1e-5, "{order:?}: {}", fold.parameter);
    }
}

/// A ball that is heated by 1, of conductivity 2 within and 1 beyond 1/2: `u' = -x/(3k)`. Of `∫ u'/x` the integrand,
/// too, is undefined at the centre.
struct TwoMaterials;

impl Model for TwoMaterials {
    fn layout(&self) -> Layout {
        let core = Region::dense("core", (0.0, 0.5), &["u", "flux"], &["mean"], 1);
        let shell = Region::dense("shell", (0.5, 1.0), &["u", "flux"], &[], 1);
        let equations = ["centre", "temperature", "flux", "surface", "mean"];
        Layout::dense(vec![core, shell], &["mean"], &equations)
    }

    fn rhs<S: Scalar>(&self, region: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        let conductivity = if region == 0 { 2.0 } else { 1.0 };
        let slope = y[1] / conductivity;
        (f[0], f[1]) = (slope, -(y[1] / x) * 2.0 - 1.0);
        if region == 0 {
            f[2] = slope / x;
        }
    }

    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        let [_, centre, inner, flux, outer, outer_flux, surface, _] = ends else { return };
        (g[0], g[1], g[2]) = (*centre, *inner - *outer, *flux - *outer_flux);
        (g[3], g[4]) = (*surface, integrals[0] - c[0]);
    }
}

#[test]
fn several_regions_and_integrals_may_have_singular_ends() {
    let problem = Differentiated::new(TwoMaterials).unwrap();
    for (order, intervals) in OPEN.into_iter().flat_map(|order| [3, 8].map(|intervals| (order, intervals))) {
        let guess = Guess::uniform(problem.layout(), intervals, &[0.0], |_, _, y| y.fill(0.0));
        let solution = solve(&problem, &guess, &[0], &to(order, 1e-9)).unwrap();
        let centre = solution.regions()[0].eval(0.0)[0];
        assert!((centre - (0.125 + 0.25 / 12.0)).abs() < 1e-9, "{order:?}: {centre}");
        assert!((solution.constants()[0] + 1.0 / 12.0).abs() < 1e-9, "{order:?}: {}", solution.constants()[0]);
    }
}

/// A smooth problem that is 0/0 at its ends: what the error estimate says of it is what the error is.
#[test]
fn errors_are_estimated_beside_an_open_end() {
    let exact = |x: f64| [(4.0 * x).cos(), -4.0 * (4.0 * x).sin()];
    for (linear, intervals) in [(false, 4), (false, 8), (true, 4), (true, 8)] {
        let wave = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |x, y, _, f| (f[0], f[1]) = (y[1], -(y[0] * (x / x) * 9.0) - (x * 4.0).cos() * 7.0),
            move |a, b, _, g| (g[0], g[1]) = (a[0] - exact(0.0)[0], b[0] - exact(1.0)[0]),
        )
        .guess(intervals, |_, y| y.fill(0.0));
        let wave = if linear { wave.linear() } else { wave };
        let rough = Options { newton_tolerance: Some(1e-13), ..to(Order::Eight, 0.09) };
        let solution = wave.solve(&rough).unwrap();
        assert_eq!(solution.intervals(), intervals);
        let line = &solution.regions()[0];
        let places = || (0..=400).map(|k| f64::from(k) / 400.0);
        let worst = [0, 1].map(|i| {
            let error = places().fold(0.0, |worst: f64, x| worst.max((line.eval(x)[i] - exact(x)[i]).abs()));
            error / places().fold(0.0, |size: f64, x| size.max(exact(x)[i].abs()))
        });
        let ratio = solution.error_estimate() / worst[0].max(worst[1]);
        println!("{intervals}: {ratio} of {worst:?}");
        assert!((ratio - 1.0).abs() < 0.03, "{intervals}, linear {linear}: {ratio} of {worst:?}");
    }
}
