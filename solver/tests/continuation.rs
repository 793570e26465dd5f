//! Following paths through the constants.

use solver::continuation::{PathOptions, Ramp, follow};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Points, Problem, Region, Scope, solve};

/// Lagerstrom and Cole: `ε u'' = u (1 - u')`, `u(0) = -1/3`, `u(1) = 1/3`: corner layers at 1/3 and 2/3.
struct Corners;

impl Model for Corners {
    fn layout(&self) -> Layout {
        let region = Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![region], &["epsilon"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], y[0] * (-y[1] + 1.0) / c[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0] + 1.0 / 3.0, e[2] - 1.0 / 3.0);
    }
}

fn straight(_: usize, s: f64, y: &mut [f64]) {
    (y[0], y[1]) = (-1.0 / 3.0 + 2.0 / 3.0 * s, 2.0 / 3.0);
}

#[test]
fn layers_sharpen_along_the_path() {
    let problem = Differentiated::new(Corners).unwrap();
    let guess = Guess::uniform(solver::Problem::layout(&problem), 10, &[1.0], straight);
    let mut found = Vec::new();
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = PathOptions { solve: Options { order, ..Options::default() }, ..PathOptions::default() };
        let followed = follow(&problem, &guess, &Ramp::new().geometric(0, 1.0, 1e-5), &[], &options).unwrap();
        for step in &followed.steps {
            println!("{step:?}");
        }
        let line = &followed.solution.regions()[0];
        println!("{order:?} {:?} {} {:?}", followed.solution.stats(), line.intervals(), followed.solution.history());
        assert_eq!(followed.solution.constants(), [1e-5]);
        found.push((1..100).map(|i| line.eval(f64::from(i) / 100.0)[0]).collect::<Vec<_>>());
    }
    for other in &found[1..] {
        for (i, (a, b)) in (1..100).zip(found[0].iter().zip(other)) {
            let s = f64::from(i) / 100.0;
            let outer = if s < 1.0 / 3.0 { s - 1.0 / 3.0 } else { (s - 2.0 / 3.0).max(0.0) };
            assert!((a - b).abs() < 2e-6 && (a - outer).abs() < 1e-2, "{s}: {a} {b}");
        }
    }
}

#[test]
fn solving_again_costs_one_iteration() {
    let problem = Differentiated::new(Corners).unwrap();
    let layout = solver::Problem::layout(&problem).clone();
    let guess = Guess::uniform(&layout, 10, &[0.1], straight);
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = Options { order, tolerance: 1e-7, ..Options::default() };
        let first = solve(&problem, &guess, &[], &options).unwrap();
        println!("{:?}", first.history());
        let again = solve(&problem, &Guess::from(&first), &[], &options).unwrap();
        assert_eq!(again.stats().newton_iterations, 1);
        assert_eq!(again.stats().meshes, 1);
        assert_eq!(again.regions()[0].mesh(), first.regions()[0].mesh());
    }
}

/// `y' = 0` with `y + saw(y) = c`: slopes of 1/10 and 19/10 by turns, two hundred kinks.
struct Saw(Layout);

const TOOTH: f64 = 0.01;

impl Problem for Saw {
    fn layout(&self) -> &Layout {
        &self.0
    }
    fn rhs(&self, _: usize, _: &Points<'_>, _: &[f64], f: &mut [f64]) {
        f.fill(0.0);
    }
    fn rhs_jacobian(
        &self,
        _: usize,
        _: &Points<'_>,
        _: &[f64],
        _: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        [f, dy, dc].into_iter().for_each(|values| values.fill(0.0));
    }
    fn boundary(&self, ends: &[f64], _: &[f64], constants: &[f64], g: &mut [f64]) {
        let place = (ends[0] / TOOTH).rem_euclid(1.0);
        g[0] = ends[0] + 0.9 * TOOTH * place.min(1.0 - place) - constants[0];
    }
    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.boundary(ends, integrals, constants, g);
        let rises = (ends[0] / TOOTH).rem_euclid(1.0) < 0.5;
        dz.copy_from_slice(&[if rises { 1.9 } else { 0.1 }, 0.0, -1.0]);
    }
}

/// Where every step crosses kinks, no step is short enough for the first correction to contract; how long the iteration
/// takes says how long the next may be.
#[test]
fn kinks_do_not_shorten_the_steps_of_a_path_without_end() {
    let region = Region::dense("line", (0.0, 1.0), &["y"], &[], 1);
    let problem = Saw(Layout::dense(vec![region], &["c"], &["saw"]));
    let guess = Guess::uniform(problem.layout(), 4, &[0.0], |_, _, y| y[0] = 0.0);
    let followed = follow(&problem, &guess, &Ramp::new().linear(0, 0.0, 1.0), &[], &PathOptions::default()).unwrap();
    let crossed = followed.steps.iter().filter(|step| step.accepted && step.contraction >= 1.0).count();
    println!("{} steps, {crossed} across kinks", followed.steps.len());
    assert!((followed.solution.regions()[0].state(0)[0] - 1.0).abs() < 1e-6);
    assert!(crossed >= 3 && followed.steps.len() < 70, "{crossed} of {}", followed.steps.len());
}
