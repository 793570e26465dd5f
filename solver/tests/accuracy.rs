//! Success that is none is told from success; problems are solved side by side.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use solver::bvp::{Bvp, Number};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Accuracy, Control, Guess, Layout, Linearisation, Options, Order, Problem, Region, Shortfall, Solution, SolveError,
    solve,
};
use std::f64::consts::PI;

/// Linear problems `u'' = a(s) u' + b(s) u` on (-1, 1), both ends given. Constants: ε.
#[derive(Clone, Copy)]
enum Linear {
    /// Cash's T09: `(ε + s²) u'' + 4 s u' + 2 u = 0`, `u = 1/(ε + s²)`.
    Peak,
    /// Cash's T15: `ε u'' = s u`, `u(±1) = 1`: a turning point.
    Airy,
    /// `u'' = -(1 - ε)² π²/4 u`: nearly resonant.
    Resonant,
}

impl Model for Linear {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (-1.0, 1.0), &["u", "slope"], &[], 1)], &["eps"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = match self {
            Self::Peak => -(s * y[1] * 4.0 + y[0] * 2.0) / (s * s + c[0]),
            Self::Airy => s * y[0] / c[0],
            Self::Resonant => -y[0] * (-c[0] + 1.0).powi(2) * (PI * PI / 4.0),
        };
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], c: &[S], g: &mut [S]) {
        let end = if matches!(self, Self::Peak) { (c[0] + 1.0).recip() } else { S::from(1.0) };
        (g[0], g[1]) = (e[0] - end, e[2] - end);
    }
}

fn attempted(model: Linear, eps: f64, options: &Options) -> Result<Solution, SolveError> {
    let problem = Differentiated::new(model).unwrap();
    let guess = Guess::uniform(problem.layout(), 20, &[eps], |_, _, y| y.fill(0.0));
    solve(&problem, &guess, &[], options)
}

fn solved(model: Linear, eps: f64, options: &Options) -> Solution {
    attempted(model, eps, options).unwrap()
}

/// Both amplify defects a thousandfold: holding the defects to the tolerance leaves an error of 300 tolerances.
#[test]
fn defects_are_held_to_less_until_the_error_is_small() {
    for (model, eps) in [(Linear::Peak, 1e-6), (Linear::Airy, 1e-6)] {
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            let options = Options { order, max_intervals: 200_000, ..Options::default() };
            let solution = solved(model, eps, &options);
            let line = &solution.regions()[0];
            assert_eq!(solution.accuracy(), Accuracy::Met);
            if let Linear::Peak = model {
                let exact = |s: f64| 1.0 / (eps + s * s);
                let error = line.mesh().iter().zip(line.state(0)).map(|(&s, u)| (u - exact(s)).abs() * eps);
                assert!(error.fold(0.0, f64::max) < 1e-5);
            }
        }
    }
}

/// `ε u'' = -cos(1.7 πx) u' + ε (u - x)`: modes meet in a layer, and part elsewhere, so that defects are amplified. The
/// error is often small before they are as small as they are held to for its sake, and that is the end: without it all
/// meshes together have 20,640 intervals, not 11,289.
#[test]
fn defects_are_held_to_less_only_until_the_error_is_small() {
    let mut sum = 0;
    for (eps, at_two_fifths) in [(1e-4, 0.294_119_666_466_8), (1e-5, 0.294_117_848_918_9)] {
        let line = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            move |x, y, _, f| (f[0], f[1]) = (y[1], y[1] * (-(x * (1.7 * PI)).cos() / eps) + y[0] - x),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - 1.0),
        );
        for order in [Order::Four, Order::Six, Order::Eight] {
            for tolerance in [1e-3, 1e-6] {
                let solution = line.solve(&Options { order, tolerance, ..Options::default() }).unwrap();
                let intervals: Vec<usize> = solution.history().iter().map(|mesh| mesh.intervals[0]).collect();
                println!("{eps:e} {order:?} {tolerance:e}: {intervals:?}, {:e}", solution.error_estimate());
                assert_eq!(solution.accuracy(), Accuracy::Met);
                assert!((solution.regions()[0].eval(0.4)[0] - at_two_fifths).abs() <= tolerance);
                sum += intervals.iter().sum::<usize>();
            }
        }
    }
    assert!(sum <= 12_500, "{sum}");
}

#[test]
fn a_solution_that_misses_its_tolerance_is_refused_and_says_why() {
    let short = |options: &Options, eps: f64| {
        let accepting = Options { accept_inaccurate: true, ..options.clone() };
        let Accuracy::Short { estimate, tolerance, because } = solved(Linear::Resonant, eps, &accepting).accuracy()
        else {
            panic!("met")
        };
        assert!(estimate > tolerance && tolerance == options.tolerance);
        let refused = attempted(Linear::Resonant, eps, options).unwrap_err();
        assert_eq!(refused, SolveError::Inaccurate { estimate, tolerance, because });
        assert!(refused.to_string().contains(&because.to_string()), "{refused}");
        because
    };
    let few = Options { max_intervals: 100, ..Options::default() };
    assert_eq!(short(&few, 1e-5), Shortfall::Mesh);
    let all = Options { tolerance: 1e-10, newton_tolerance: Some(1e-6), order: Order::Six, ..Options::default() };
    assert_eq!(short(&all, 1e-9), Shortfall::Rounding);
    // Whoever asks for small defects only has what was asked for.
    let loose = Options { control: Control::Defect, ..Options::default() };
    let first = solved(Linear::Resonant, 1e-5, &loose);
    assert!(matches!(first.accuracy(), Accuracy::Short { because: Shortfall::Uncontrolled, .. }));
    let problem = Differentiated::new(Linear::Resonant).unwrap();
    let kappa = Linearisation::new(&problem, &first).unwrap().conditioning().kappa();
    assert!(kappa > 1e4, "{kappa}");
    // From there on the error is brought down; unless inaccurate solutions do, which keep their mesh.
    let better = solve(&problem, &Guess::from(&first), &[], &Options::default()).unwrap();
    assert_eq!(better.accuracy(), Accuracy::Met);
    assert!(better.intervals() > first.intervals());
    let accepting = Options { accept_inaccurate: true, ..Options::default() };
    let again = solve(&problem, &Guess::from(&first), &[], &accepting).unwrap();
    assert_eq!((again.stats().newton_iterations, again.intervals()), (1, first.intervals()));
    assert!(matches!(again.accuracy(), Accuracy::Short { because: Shortfall::WarmStart, .. }));
}

/// `y' = |x - c|`, `y(0) = 0`, on ten intervals: the whole error is made where the kink is, and depends on where in its
/// interval that lies.
#[test]
fn the_estimated_error_knows_where_in_an_interval_a_kink_lies() {
    let (mut made, mut missed) = (0.0, 0.0);
    for place in 1..40 {
        let c = 0.4 + 0.0025 * f64::from(place);
        let problem =
            Bvp::new(&["y"], (0.0, 1.0), |x, _, _, f| f[0] = Number::from((x - c).abs()), |a, _, _, g| g[0] = a[0])
                .guess(10, |_, y| y[0] = 0.0);
        let options = Options { tolerance: 0.1, control: Control::Defect, ..Options::default() };
        let solution = problem.solve(&options).unwrap();
        let line = &solution.regions()[0];
        assert_eq!(line.intervals(), 10);
        let error = line.state(0)[10] - 0.5 * (c * c + (1.0 - c) * (1.0 - c));
        let estimate = Linearisation::new(&problem, &solution).unwrap().error().unwrap();
        made += error.abs();
        missed += (estimate.regions[0].states[0][10] - error).abs();
    }
    assert!(made > 1e-3 && missed < 0.05 * made, "{missed:e} of {made:e}");
}

/// The solver starts no threads; whoever wants them solves in several.
#[test]
fn problems_are_solved_in_parallel_and_alike() {
    fn parallel<T: Send + Sync>(_: &T) {}
    let problem = Differentiated::new(Linear::Airy).unwrap();
    parallel(&problem);
    let widths = [1e-2, 1e-3, 1e-4, 1e-5];
    let options = Options::default();
    let alone: Vec<Solution> = widths.iter().map(|&eps| solved(Linear::Airy, eps, &options)).collect();
    parallel(&alone);
    let together: Vec<Solution> = std::thread::scope(|scope| {
        let threads: Vec<_> = widths
            .iter()
            .map(|&eps| {
                let (problem, options) = (&problem, &options);
                scope.spawn(move || {
                    let guess = Guess::uniform(problem.layout(), 20, &[eps], |_, _, y| y.fill(0.0));
                    let solution = solve(problem, &guess, &[], options).unwrap();
                    let conditioning = Linearisation::new(problem, &solution).unwrap().conditioning();
                    assert!(conditioning.kappa().is_finite());
                    solution
                })
            })
            .collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    for (a, b) in alone.iter().zip(&together) {
        assert_eq!(a.regions()[0].mesh(), b.regions()[0].mesh());
        assert_eq!(a.regions()[0].state(0), b.regions()[0].state(0));
        assert_eq!(a.stats(), b.stats());
    }
}
