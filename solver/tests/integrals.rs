//! Integrals are as accurate as a solution says it is, whether or not a condition uses them.

#![allow(clippy::unwrap_used)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{Accuracy, Guess, Layout, Options, Order, Problem, Region, solve};

const ORDERS: [Order; 4] = [Order::Four, Order::Six, Order::SixGauss, Order::Eight];

/// `y' = -y`, `y(0) = 1`, with the integral of `y eˣ/((x - 1/2)² + w²)`: 2/w atan(1/(2w)), of a peak of which y knows
/// nothing. `condition`: the constant c is that integral.
struct Peak {
    width: f64,
    condition: bool,
}

impl Peak {
    fn exact(&self) -> f64 {
        2.0 / self.width * (0.5 / self.width).atan()
    }
}

impl Model for Peak {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["y"], &["peak"], 1);
        let equations: &[&str] = if self.condition { &["start", "size"] } else { &["start"] };
        Layout::dense(vec![line], &["c"], equations)
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        f[0] = -y[0];
        f[1] = y[0] * s.exp() / ((s - 0.5) * (s - 0.5) + self.width * self.width);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        g[0] = ends[0] - 1.0;
        if self.condition {
            g[1] = c[0] - integrals[0];
        }
    }
}

#[test]
fn an_integral_is_as_accurate_as_is_said() {
    for condition in [false, true] {
        for (width, order) in [0.1, 0.03, 0.01].into_iter().flat_map(|width| ORDERS.map(|order| (width, order))) {
            for tolerance in [1e-4, 1e-6, 1e-8] {
                let peak = Peak { width, condition };
                let exact = peak.exact();
                let problem = Differentiated::new(peak).unwrap();
                let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
                let unknowns: &[usize] = if condition { &[0] } else { &[] };
                let solution =
                    solve(&problem, &guess, unknowns, &Options { order, tolerance, ..Options::default() }).unwrap();
                let error = solution.regions()[0].integrals()[0] / exact - 1.0;
                println!(
                    "{condition} {width} {order:?} {tolerance:e}: {} intervals, {error:.1e}",
                    solution.intervals()
                );
                assert_eq!(solution.accuracy(), Accuracy::Met);
                assert!(error.abs() <= tolerance, "{condition} {width} {order:?} {tolerance:e}: {error}");
                // As a state would: some ten times as many intervals as the rest of the solution takes.
                assert!(solution.intervals() <= 400, "{} intervals", solution.intervals());
            }
        }
    }
}

/// Where a mesh may not be as fine as an integral asks for, that is what is said.
#[test]
fn an_integral_that_is_not_had_is_told() {
    let problem = Differentiated::new(Peak { width: 0.003, condition: false }).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
    let options = Options { order: Order::Eight, tolerance: 1e-8, max_intervals: 20, ..Options::default() };
    let error = solve(&problem, &guess, &[], &options).unwrap_err().to_string();
    assert!(error.contains("finer meshes are not allowed"), "{error}");
    let short = solve(&problem, &guess, &[], &Options { accept_inaccurate: true, ..options }).unwrap();
    assert!(matches!(short.accuracy(), Accuracy::Short { estimate, .. } if estimate > 1e-4));
}

/// Whoever sees to integrals by other means need not pay for them.
#[test]
fn integrals_may_be_left_to_the_caller() {
    let peak = Peak { width: 0.01, condition: false };
    let exact = peak.exact();
    let problem = Differentiated::new(peak).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(1.0));
    let options = Options { tolerance: 1e-4, integrals: false, ..Options::default() };
    let solution = solve(&problem, &guess, &[], &options).unwrap();
    assert_eq!((solution.accuracy(), solution.intervals()), (Accuracy::Met, 10));
    assert!((solution.regions()[0].integrals()[0] / exact - 1.0).abs() > 0.1);
}

/// `u' = c` with `u(0) = 0`, or `u' = 0` with `u(0) = c`, and an integral of `u/(1 + k (s - m)²)` that makes c what is
/// stated. A state that is a polynomial leaves no defect: all that is in the way of c is quadrature.
struct Against {
    sharpness: f64,
    place: f64,
    slope: bool,
    constant: f64,
}

impl Against {
    fn integral(&self) -> f64 {
        let (k, m) = (self.sharpness, self.place);
        let r = k.sqrt();
        let flat = ((r * (1.0 - m)).atan() + (r * m).atan()) / r;
        let rising = ((1.0 + k * (1.0 - m).powi(2)) / (1.0 + k * m * m)).ln() / (2.0 * k) + m * flat;
        self.constant * if self.slope { rising } else { flat }
    }

    fn solve(self, intervals: usize, options: &Options) -> Result<solver::Solution, solver::SolveError> {
        let problem = Differentiated::new(self).unwrap();
        let guess = Guess::uniform(problem.layout(), intervals, &[0.0], |_, _, y| y.fill(0.0));
        solve(&problem, &guess, &[0], options)
    }
}

impl Model for Against {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u"], &["I"], 1)], &["c"], &["start", "integral"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        let from = s - self.place;
        f[0] = if self.slope { c[0] } else { y[0] * 0.0 };
        f[1] = y[0] / (from * from * self.sharpness + 1.0);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        g[0] = if self.slope { ends[0] } else { ends[0] - c[0] };
        g[1] = integrals[0] - self.integral();
    }
}

/// An error of an integral that is within the tolerance may do more than that to what the integral determines: the mesh
/// is made fine enough for that too.
#[test]
fn what_an_integral_determines_is_as_accurate_as_is_said() {
    for (sharpness, place, intervals) in [(1e3, 0.5, 10), (1e4, 0.37, 10), (1e2, 0.81, 2), (1e4, 0.5, 20)] {
        for (order, tolerance) in ORDERS.into_iter().flat_map(|order| [1e-6, 1e-3].map(|tolerance| (order, tolerance)))
        {
            let against = Against { sharpness, place, slope: true, constant: 1.0 };
            let solution = against.solve(intervals, &Options { order, tolerance, ..Options::default() }).unwrap();
            let error = solution.constants()[0] - 1.0;
            println!("{sharpness} {place} {order:?} {tolerance:e}: {} intervals, {error:.1e}", solution.intervals());
            assert_eq!(solution.accuracy(), Accuracy::Met);
            assert!(error.abs() <= tolerance, "{sharpness} {place} {order:?} {tolerance:e}: {error}");
            assert!(solution.intervals() <= 300, "{} intervals", solution.intervals());
        }
    }
}

/// Where the mesh may not be as fine as that, it is not rounding that is in the way.
#[test]
fn quadrature_is_not_taken_for_rounding() {
    for (order, max_intervals) in
        ORDERS.into_iter().flat_map(|order| (10..40).step_by(2).map(move |most| (order, most)))
    {
        let against = Against { sharpness: 1e3, place: 0.5, slope: true, constant: 1.0 };
        match against.solve(10, &Options { order, max_intervals, ..Options::default() }) {
            Ok(solution) => assert!((solution.constants()[0] - 1.0).abs() <= 1e-6, "{order:?} {max_intervals}"),
            Err(error) => {
                let error = error.to_string();
                assert!(error.contains("finer meshes are not allowed"), "{order:?} {max_intervals}: {error}");
            }
        }
    }
}

/// The difference of two rules vanishes by accident on some intervals, on which neither is right. Here it does so where
/// the peak is.
#[test]
fn a_peak_that_two_rules_agree_about_is_not_missed() {
    let settings = [
        (Order::Six, 1e-3, 300.0, 0.5, 3),
        (Order::Six, 1e-8, 300.0, 0.5, 3),
        (Order::Six, 1e-10, 300.0, 0.5, 3),
        (Order::Six, 1e-2, 30.0, 0.5, 1),
        (Order::Eight, 1e-4, 1000.0, 0.37, 7),
    ];
    for (order, tolerance, sharpness, place, intervals) in settings {
        let against = Against { sharpness, place, slope: false, constant: 100.0 };
        let exact = against.integral();
        let options = Options { order, tolerance, ..Options::default() };
        // What the integral determines, and the integral of what is known.
        let solution = against.solve(intervals, &options).unwrap();
        let error = solution.constants()[0] / 100.0 - 1.0;
        println!("{order:?} {tolerance:e} {sharpness}: {} intervals, {error:.1e}", solution.intervals());
        assert_eq!(solution.accuracy(), Accuracy::Met);
        assert!(error.abs() <= 2.0 * tolerance, "{order:?} {tolerance:e} {sharpness}: {error}");
        let problem = Differentiated::new(Known { sharpness, place }).unwrap();
        let guess = Guess::uniform(problem.layout(), intervals, &[], |_, _, y| y.fill(100.0));
        let solution = solve(&problem, &guess, &[], &options).unwrap();
        let error = solution.regions()[0].integrals()[0] / exact - 1.0;
        assert_eq!(solution.accuracy(), Accuracy::Met);
        assert!(error.abs() <= 2.0 * tolerance, "{order:?} {tolerance:e} {sharpness}: {error}");
    }
}

/// `u' = 0`, `u(0) = 100`, with an integral that no condition uses.
struct Known {
    sharpness: f64,
    place: f64,
}

impl Model for Known {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u"], &["I"], 0)], &[], &["start"])
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        let from = s - self.place;
        (f[0], f[1]) = (y[0] * 0.0, y[0] / (from * from * self.sharpness + 1.0));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = ends[0] - 100.0;
    }
}
