//! Tight tolerances where layers are thin: rounding is judged interval by interval, and meshes do not creep.

#![allow(clippy::unwrap_used, clippy::panic)]

use solver::bvp::{Bvp, Number};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Accuracy, Guess, Layout, Options, Order, Problem, Region, Shortfall, Solution, SolveError, solve};
use std::f64::consts::PI;

/// Cash's T14: `ε u'' = u - (ε π² + 1) cos πx` on (-1, 1), two layers of width √ε.
struct Layers;

impl Layers {
    fn exact(x: f64, e: f64) -> f64 {
        let layer = |distance: f64| (-distance / e.sqrt()).exp();
        (PI * x).cos() + layer(1.0 - x) + layer(1.0 + x)
    }

    /// u at the ends, less what it is to be there.
    fn ends<S: Scalar>(left: S, right: S, eps: S, g: &mut [S]) {
        let end = (eps.sqrt().recip() * -2.0).exp();
        (g[0], g[1]) = (left - end, right - end);
    }

    /// The largest at all nodes.
    fn error(solution: &Solution, eps: f64) -> f64 {
        let errors = solution.regions().iter().flat_map(|region| {
            region.mesh().iter().zip(region.state(0)).map(|(&x, u)| (u - Self::exact(x, eps)).abs())
        });
        errors.fold(0.0, f64::max)
    }
}

impl Model for Layers {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("all", (-1.0, 1.0), &["u", "slope"], &[], 1)], &["eps"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = (y[0] - (c[0] * (PI * PI) + 1.0) * (x * PI).cos()) / c[0];
    }
    fn boundary<S: Scalar>(&self, z: &[S], _: &[S], c: &[S], g: &mut [S]) {
        Self::ends(z[0], z[2], c[0], g);
    }
}

/// On 6,000 intervals 8 ε N is 1e-11: defects of a tenth of that are met in layers, where intervals are short because
/// the solution varies, and not because they are many.
#[test]
fn tighter_tolerances_give_smaller_errors_down_to_1e_12() {
    let problem = Differentiated::new(Layers).unwrap();
    let eps = 1e-6;
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for tolerance in [1e-8, 1e-9, 1e-10, 1e-11, 1e-12] {
            let guess = Guess::uniform(problem.layout(), 20, &[eps], |_, _, y| y.fill(0.0));
            let solution = solve(&problem, &guess, &[], &Options { order, tolerance, ..Options::default() }).unwrap();
            assert_eq!(solution.accuracy(), Accuracy::Met);
            let error = Layers::error(&solution, eps);
            println!("{order:?} {tolerance:e}: {error:e}, {:?}", solution.stats());
            assert!(error <= tolerance, "{order:?} {tolerance:e}: {error:e}");
            assert!(solution.stats().meshes <= 30, "{order:?} {tolerance:e}: {:?}", solution.stats());
        }
    }
}

/// The same in three regions, which the solution passes smoothly.
struct Three;

impl Model for Three {
    fn layout(&self) -> Layout {
        let third = |name, from| Region::dense(name, (from, from + 2.0 / 3.0), &["u", "slope"], &[], 1);
        let regions = vec![third("left", -1.0), third("middle", -1.0 / 3.0), third("right", 1.0 / 3.0)];
        let equations = ["left", "right", "u at -1/3", "slope at -1/3", "u at 1/3", "slope at 1/3"];
        Layout::dense(regions, &["eps"], &equations)
    }
    fn rhs<S: Scalar>(&self, region: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        Layers.rhs(region, x, y, c, f);
    }
    fn boundary<S: Scalar>(&self, z: &[S], _: &[S], c: &[S], g: &mut [S]) {
        Layers::ends(z[0], z[10], c[0], g);
        (g[2], g[3]) = (z[4] - z[2], z[5] - z[3]);
        (g[4], g[5]) = (z[8] - z[6], z[9] - z[7]);
    }
}

/// Where splitting a few intervals more does not bring a smaller error, all are halved: without that three of these are
/// refused, as if what is left were due to rounding.
#[test]
fn layers_are_resolved_in_several_regions_as_in_one() {
    let problem = Differentiated::new(Three).unwrap();
    let eps = 1e-6;
    for intervals in [6, 7, 8] {
        for tolerance in [1e-7, 5e-8, 1e-9] {
            let guess = Guess::uniform(problem.layout(), intervals, &[eps], |_, _, y| y.fill(0.0));
            let solution = solve(&problem, &guess, &[], &Options { tolerance, ..Options::default() }).unwrap();
            let error = Layers::error(&solution, eps);
            println!("{intervals} {tolerance:e}: {error:e}, {:?}", solution.stats());
            assert!(error <= tolerance, "{intervals} {tolerance:e}: {error:e}");
        }
    }
}

/// Where meshes may not have as many intervals as halving all of them takes, it is their limit that is in the way of a
/// smaller error, and not rounding.
#[test]
fn what_a_meshs_limit_prevents_is_not_put_down_to_rounding() {
    let problem = Differentiated::new(Three).unwrap();
    let mut refused = 0;
    for intervals in [6, 7, 8] {
        for max_intervals in [200, 300, 400, 500, 600, 800] {
            let guess = Guess::uniform(problem.layout(), intervals, &[1e-6], |_, _, y| y.fill(0.0));
            for tolerance in [1e-7, 5e-8] {
                match solve(&problem, &guess, &[], &Options { tolerance, max_intervals, ..Options::default() }) {
                    Err(SolveError::Inaccurate { because, .. }) => {
                        assert_eq!(because, Shortfall::Mesh, "{intervals}, {max_intervals}, {tolerance:e}");
                        refused += 1;
                    }
                    solved => assert!(!matches!(solved, Err(SolveError::Newton { .. })), "{intervals}, {tolerance:e}"),
                }
            }
        }
    }
    assert!(refused > 0);
}

/// At order 6 a layer that intervals are far too long for does not spoil the solution away from it where one state is
/// the derivative of another: few intervals find it.
#[test]
fn thin_layers_of_equations_of_second_order_are_found_with_few_intervals() {
    let problem = Differentiated::new(Layers).unwrap();
    let eps = 1e-6;
    let guess = Guess::uniform(problem.layout(), 8, &[eps], |_, _, y| y.fill(0.0));
    let options = Options { order: Order::Six, tolerance: 1e-6, ..Options::default() };
    let solution = solve(&problem, &guess, &[], &options).unwrap();
    let error = Layers::error(&solution, eps);
    let intervals: Vec<usize> = solution.history().iter().map(|mesh| mesh.intervals[0]).collect();
    println!("{error:e}, {intervals:?}");
    assert!(error <= 1e-6, "{error:e}");
    // As a system of first order takes 412.
    assert!(intervals.iter().sum::<usize>() <= 200, "{intervals:?}");
}

/// `ε u'' = p(x) u' - u` on (0, 1), u = 1 at both ends: a layer of width ε/|p| at one end, or where p changes its sign.
struct Flow {
    p: fn(f64) -> f64,
    eps: f64,
}

impl solver::bvp::Formulas for Flow {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        (f[0], f[1]) = (y[1], ((self.p)(x) * y[1] - y[0]) / self.eps);
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], c: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs(x, y, c, f);
        columns.copy_from_slice(&[0.0, -1.0 / self.eps, 1.0, (self.p)(x) / self.eps]);
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = (a[0] - 1.0, b[0] - 2.0);
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], c: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, c, g);
        columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
}

/// Where a layer may be the derivatives tell, at either end or in between, so that the mesh after the first resolves
/// it: without that, meshes grow by factors of 2 or 3 until one of their nodes happens to lie in it, and the sums are
/// 236 to 2,265.
#[test]
fn the_second_mesh_is_fine_where_a_layer_may_be() {
    for (name, p, place) in [
        ("left", (|_| -1.0) as fn(f64) -> f64, 0.0),
        ("right", |_| 1.0, 1.0),
        ("turning point", |x| -4.0 * (x - 0.4), 0.4),
        ("turning point at the left end", |x| -4.0 * x, 0.0),
        ("turning point at the right end", |x| 4.0 * (1.0 - x), 1.0),
    ] {
        for (order, eps, most) in [(Order::Four, 1e-3, 180), (Order::Six, 1e-4, 210), (Order::Eight, 1e-5, 300)] {
            let options = Options { order, tolerance: 1e-4, ..Options::default() };
            let problem = Bvp::with(&["u", "slope"], (0.0, 1.0), Flow { p, eps }).guess(8, |_, y| y.fill(0.0));
            let solution = problem.solve(&options).unwrap();
            let intervals: Vec<usize> = solution.history().iter().map(|mesh| mesh.intervals[0]).collect();
            println!("{name}, {order:?}: {intervals:?}");
            let mesh = solution.regions()[0].mesh();
            let shortest = mesh.windows(2).min_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0]))).unwrap();
            assert!((shortest[0] - place).abs() < 0.03, "{name}: {shortest:?}");
            assert!(intervals.iter().sum::<usize>() <= most, "{name}, {order:?}: {intervals:?}");
        }
    }
}

/// Layers of widths 3e-6 to 4e-7, at the orders that let modes fade slowly: intervals beside a layer stay short on
/// later meshes, what asks for most does not take them, and meshes whose matrix is singular to rounding say where they
/// are to be finer. Without that the first sum is 314, the next three are 724 to 2,201, the fifth is 12,415, and the
/// sixth problem is said not to be linear.
#[test]
fn what_is_left_of_a_thin_layer_does_not_spoil_the_rest() {
    for (name, p, eps, order, most) in [
        ("right", (|x| 2.0 + x) as fn(f64) -> f64, 1e-5, Order::Four, [420, 420]),
        ("right", |x| 2.0 + x, 1e-5, Order::Six, [480, 240]),
        ("strong", |x| -(1.0 + x).exp(), 1e-6, Order::Four, [1300, 1300]),
        ("strong", |x| -(1.0 + x).exp(), 1e-6, Order::Six, [1600, 560]),
    ] {
        for (said, most) in [false, true].into_iter().zip(most) {
            let problem = Bvp::with(&["u", "slope"], (0.0, 1.0), Flow { p, eps }).guess(4, |_, y| y.fill(0.0));
            let problem = if said { problem.linear() } else { problem };
            let solution = problem.solve(&Options { order, tolerance: 1e-5, ..Options::default() }).unwrap();
            let intervals: Vec<usize> = solution.history().iter().map(|mesh| mesh.intervals[0]).collect();
            println!("{name}, {order:?}, {said}: {intervals:?}");
            assert!(intervals.iter().sum::<usize>() <= most, "{name}, {order:?}, {said}: {intervals:?}");
        }
    }
}

/// `ε u'' = -u' + u + u³ - g`, whose solution is `cos 3x + exp(-x/ε)` but for what is exponentially small.
struct Reaction(f64);

impl solver::bvp::Formulas for Reaction {
    fn rhs(&self, x: f64, y: &[f64], _: &[f64], f: &mut [f64]) {
        let (c, s, layer) = ((3.0 * x).cos(), (3.0 * x).sin(), (-x / self.0).exp());
        let u = c + layer;
        // ε u'' + u' of the layer cancel.
        let source = -9.0 * self.0 * c - 3.0 * s - u - u.powi(3);
        (f[0], f[1]) = (y[1], (-y[1] + y[0] + y[0].powi(3) + source) / self.0);
    }
    fn rhs_derivatives(&self, x: f64, y: &[f64], c: &[f64], f: &mut [f64], columns: &mut [f64]) {
        self.rhs(x, y, c, f);
        columns.copy_from_slice(&[0.0, (1.0 + 3.0 * y[0] * y[0]) / self.0, 1.0, -1.0 / self.0]);
    }
    fn boundary(&self, a: &[f64], b: &[f64], _: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = (a[0] - 2.0, b[0] - 3.0_f64.cos());
    }
    fn boundary_derivatives(&self, a: &[f64], b: &[f64], c: &[f64], g: &mut [f64], columns: &mut [f64]) {
        self.boundary(a, b, c, g);
        columns.copy_from_slice(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    }
}

/// From zero, on a mesh that does not resolve the layer, the iteration is led astray at every order. The derivatives at
/// the guess tell where meshes are to be fine, and there it converges.
#[test]
fn an_iteration_that_a_thin_layer_leads_astray_starts_again_on_a_mesh_for_it() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = Options { order, tolerance: 1e-4, ..Options::default() };
        let problem = Bvp::with(&["u", "slope"], (0.0, 1.0), Reaction(1e-6)).guess(4, |_, y| y.fill(0.0));
        let solution = problem.solve(&options).unwrap();
        let line = &solution.regions()[0];
        let exact = |x: f64| (3.0 * x).cos() + (-x * 1e6).exp();
        let error = line.mesh().iter().zip(line.state(0)).map(|(&x, u)| (u - exact(x)).abs()).fold(0.0, f64::max);
        println!("{order:?}: {error:e}, {:?}", solution.history());
        assert!(error <= 2e-4, "{order:?}: {error:e}");
    }
}

/// A problem of Cash's with its solution.
#[derive(Clone, Copy)]
enum Cash {
    /// T5: `ε u'' = x u' + u - (1 + ε π²) cos πx + π x sin πx`, `u = cos πx`: smooth, but ill-conditioned.
    Five,
    /// T9: `(ε + x²) u'' + 4 x u' + 2 u = 0`, `u = 1/(ε + x²)`: a narrow peak.
    Nine,
}

impl Cash {
    fn curvature(self, x: f64, eps: f64, y: &[Number]) -> Number {
        match self {
            Self::Five => (y[1] * x + y[0] - (1.0 + eps * PI * PI) * (PI * x).cos() + PI * x * (PI * x).sin()) / eps,
            Self::Nine => -(y[1] * (4.0 * x) + y[0] * 2.0) / (eps + x * x),
        }
    }

    fn exact(self, x: f64, eps: f64) -> f64 {
        match self {
            Self::Five => (PI * x).cos(),
            Self::Nine => 1.0 / (eps + x * x),
        }
    }
}

/// Where intervals are ten thousand times as long as a layer would be, and there is none, few of them suffice; that
/// they do is known from the estimate of the error, which follows the defects through stages and nodes. Cash's T3:
/// `ε u'' + (2 + cos πx) u' - u = -(1 + ε π²) cos πx - (2 + cos πx) π sin πx`, `u = cos πx`.
#[test]
fn smooth_solutions_of_stiff_equations_take_few_intervals() {
    for (eps, most) in [(1e-4, 200), (1e-5, 400)] {
        let line = Bvp::new(
            &["u", "slope"],
            (-1.0, 1.0),
            move |x, y, _, f| {
                let (sin, cos) = ((PI * x).sin(), (PI * x).cos());
                let forcing = (1.0 + eps * PI * PI) * cos + (cos + 2.0) * PI * sin;
                (f[0], f[1]) = (y[1], (y[0] - (cos + 2.0) * y[1] - forcing) / eps);
            },
            |a, b, _, g| (g[0], g[1]) = (a[0] + 1.0, b[0] + 1.0),
        );
        let solution = line.solve(&Options { order: Order::Six, tolerance: 1e-6, ..Options::default() }).unwrap();
        assert!(solution.intervals() <= most, "{eps:e}: {} intervals", solution.intervals());
        let line = &solution.regions()[0];
        let at_node = |k: usize| {
            let (sin, cos) = (PI * line.mesh()[k]).sin_cos();
            (line.state(0)[k] - cos).abs().max((line.state(1)[k] + PI * sin).abs() / (1.0 + PI))
        };
        let error = (0..line.mesh().len()).map(at_node).fold(0.0, f64::max);
        let estimate = solution.error_estimate();
        println!("{eps:e}: {} intervals, error {error:e}, estimated {estimate:e}", solution.intervals());
        assert!(error <= 1e-6 && error <= 3.0 * estimate, "{eps:e}: {error:e}, {estimate:e}");
    }
}

/// `y' = -λ (y - cos x) - sin x` from `y(0) = 1` is solved by `cos x`, which has no layer. What the rounding of the one
/// correction that a linear problem takes leaves in y is multiplied by λ in the defects, and with it powers of λ h at
/// the stages between nodes: meshes with thousands of intervals were made to lower it, and it takes another correction.
#[test]
fn rounding_of_stiff_equations_is_not_met_with_finer_meshes() {
    for (rate, tolerance, most) in [(1e8, 1e-3, 9_000), (1e8, 1e-6, 40_000), (1e9, 1e-3, 50_000), (1e9, 1e-6, 300_000)]
    {
        let problem = Bvp::new(
            &["y"],
            (0.0, 1.0),
            move |x: f64, y, _, f| f[0] = (y[0] - x.cos()) * -rate - x.sin(),
            |a, _, _, g| g[0] = a[0] - 1.0,
        );
        for problem in [problem.clone(), problem.linear()] {
            let solution = problem.solve(&Options { order: Order::Six, tolerance, ..Options::default() }).unwrap();
            let error = (0..=1000).map(|k| f64::from(k) / 1000.0).map(|x| {
                let y = solution.regions()[0].eval(x)[0];
                (y - x.cos()).abs()
            });
            let (error, points) = (error.fold(0.0, f64::max), solution.stats().points());
            assert!(error <= 2.0 * tolerance && points <= most, "{rate} {tolerance}: {error} {points}");
        }
    }
}

/// Of these equations the estimated error is an upper bound. Taken off, it changes the slopes by λ times as much, and
/// with them all that is between the nodes.
#[test]
fn an_estimate_is_not_taken_off_where_it_spoils_what_is_between_the_nodes() {
    for order in [Order::Four, Order::Six, Order::SixGauss, Order::Eight] {
        let problem = Bvp::new(
            &["y"],
            (0.0, 1.0),
            |x: f64, y, _, f| f[0] = (y[0] - x.cos()) * -1e6 - x.sin(),
            |a, _, _, g| g[0] = a[0] - 1.0,
        );
        let tolerance = 1e-4;
        let solution = problem.solve(&Options { order, tolerance, defect_correction: true, ..Options::default() });
        let solution = solution.unwrap();
        let error = (0..=1000).map(|k| f64::from(k) / 1000.0);
        let error = error.map(|x| (solution.regions()[0].eval(x)[0] - x.cos()).abs()).fold(0.0, f64::max);
        assert!(error <= tolerance, "{order:?}: {error}");
    }
}

/// From zero on eight intervals, Newton's iteration at orders 4 and 6 fails at layers that no mesh resolves yet: order
/// 8 finds where they are to start from. `ε u'' = p u' + u + s u³ - g`, whose one solution has waves, and hardly a
/// layer.
#[test]
fn another_order_finds_the_start_where_the_one_that_is_wanted_is_led_astray() {
    for (eps, p, s, amplitude, wave) in [(3.24e-5, 0.806, 0.487, 2.4, 10.0), (3.93e-6, 0.473, 0.775, 0.914, 11.8)] {
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            let line = Bvp::new(
                &["u", "slope"],
                (0.0, 1.0),
                move |x, y, _, f| {
                    let (u, slope) = ((x * wave).sin() * amplitude, (x * wave).cos() * (amplitude * wave));
                    let forcing = slope * p + u * (1.0 + eps * wave * wave) + u.powi(3) * s;
                    (f[0], f[1]) = (y[1], (y[1] * p + y[0] + y[0].powi(3) * s - forcing) / eps);
                },
                move |a, b, _, g| (g[0], g[1]) = (a[0], b[0] - amplitude * wave.sin()),
            );
            let line = line.guess(8, |_, y| y.fill(0.0));
            let options = Options { order, tolerance: 1e-6, work_limit: Some(200_000), ..Options::default() };
            let solution = line.solve(&options).unwrap_or_else(|error| panic!("{order:?} {eps:e}: {error}"));
            let line = &solution.regions()[0];
            let error = line.mesh().iter().zip(line.state(0)).map(|(x, u)| (u - amplitude * (wave * x).sin()).abs());
            let error = error.fold(0.0, f64::max) / amplitude;
            println!("{order:?} {eps:e}: {error:e}, {:?}", solution.stats());
            assert!(error <= 1e-6, "{order:?} {eps:e}: {error:e}");
        }
    }
}

/// Close to rounding a solution is as good as asked for, or refused.
#[test]
fn tolerances_near_rounding_are_met_or_refused() {
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for (cash, eps, tolerance) in [
            (Cash::Nine, 1e-2, 1e-11),
            (Cash::Nine, 1e-2, 1e-12),
            (Cash::Nine, 1e-3, 1e-12),
            (Cash::Five, 1e-1, 1e-8),
            (Cash::Five, 1e-2, 1e-8),
            (Cash::Five, 1e-3, 1e-8),
        ] {
            let line = Bvp::new(
                &["u", "slope"],
                (-1.0, 1.0),
                move |x, y, _, f| (f[0], f[1]) = (y[1], cash.curvature(x, eps, y)),
                move |a, b, _, g| (g[0], g[1]) = (a[0] - cash.exact(-1.0, eps), b[0] - cash.exact(1.0, eps)),
            );
            let solution = match line.solve(&Options { order, tolerance, ..Options::default() }) {
                Ok(solution) => solution,
                // 20,000 intervals of order 4 do not suffice for 1e-12.
                Err(SolveError::Inaccurate { .. }) if tolerance == 1e-12 && order == Order::Four => continue,
                Err(error) => panic!("{order:?} {tolerance:e}: {error}"),
            };
            let line = &solution.regions()[0];
            let largest = line.state(0).iter().fold(1.0_f64, |max, u| max.max(u.abs()));
            let error = line.mesh().iter().zip(line.state(0)).map(|(&x, u)| (u - cash.exact(x, eps)).abs());
            let error = error.fold(0.0, f64::max) / largest;
            println!("{order:?} {tolerance:e}: {error:e}, {} intervals", solution.intervals());
            assert!(error <= tolerance, "{order:?} {tolerance:e}: {error:e}");
        }
    }
}
