//! Branches through folds, events, checkpoints, and the ways around a failing guess.

use solver::continuation::{
    BranchOptions, Checkpoint, How, PathOptions, PointKind, Ramp, Stiffness, follow, follow_observed, resume_observed,
    solve_automatically, trace,
};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Event, Guess, Layout, Linearisation, Observer, Options, Order, Problem, Region, Silent, Solution, SolveError, solve,
};
use std::ops::ControlFlow;

/// Bratu: `u'' = -λ exp(u)`, `u(0) = u(1) = 0`; a fold at λ = 3.51383...
struct Bratu;

impl Model for Bratu {
    fn layout(&self) -> Layout {
        let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &["area"], 1);
        Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], -c[0] * y[0].exp(), y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

/// λ and u(1/2) at the fold: λ = 8 θ²/cosh² θ, u(1/2) = 2 ln cosh θ with θ tanh θ = 1.
fn bratu_fold() -> (f64, f64) {
    let mut theta = 1.2_f64;
    for _ in 0..50 {
        let f = theta * theta.tanh() - 1.0;
        theta -= f / (theta.tanh() + theta / theta.cosh().powi(2));
    }
    (8.0 * (theta / theta.cosh()).powi(2), 2.0 * theta.cosh().ln())
}

fn middle(solution: &Solution) -> f64 {
    solution.regions()[0].eval(0.5)[0]
}

#[test]
fn a_fold_and_events_are_located() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    for order in [Order::Four, Order::Six] {
        let options = BranchOptions {
            solve: Options { order, tolerance: 1e-10, ..Options::default() },
            range: (0.5, 10.0),
            ..BranchOptions::default()
        };
        let peak = |solution: &Solution| middle(solution) - 3.0;
        let branch = trace(&problem, &guess, 0, &[], &options, &[&peak]).unwrap();
        for point in &branch.points {
            println!("{:?} {:.10} rate {:+.3e} at {:.4}", point.kind, point.parameter, point.rate, point.arclength);
        }
        println!("{order:?} {:?}", branch.stats);
        let folds: Vec<_> = branch.folds().collect();
        let (lambda, height) = bratu_fold();
        assert_eq!(folds.len(), 1);
        assert!((folds[0].parameter - lambda).abs() < 1e-8 * lambda, "{} {lambda}", folds[0].parameter);
        assert!((middle(&folds[0].solution) - height).abs() < 1e-6, "{} {height}", middle(&folds[0].solution));
        let event = branch.points.iter().find(|point| point.kind == PointKind::Event(0)).unwrap();
        assert!((middle(&event.solution) - 3.0).abs() < 1e-8);
        let end = branch.points.last().unwrap();
        assert_eq!(end.kind, PointKind::End);
        assert!((end.parameter - 0.5).abs() < 1e-8);
        assert!(middle(&end.solution) > 4.0, "the upper branch");
        assert_eq!(end.solution.regions()[0].integrals().len(), 1);
        assert!(branch.points.windows(2).all(|pair| pair[0].arclength <= pair[1].arclength));
        // A point of the branch is a solution of the problem with the parameter given.
        let again = solve(&problem, &Guess::from(&end.solution), &[], &options.solve).unwrap();
        assert!(again.stats().newton_iterations <= 2);
    }
}

#[test]
fn at_a_fold_there_is_no_tangent_in_the_parameter() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[3.0], |_, _, y| y.fill(0.0));
    let options = BranchOptions { solve: Options { tolerance: 1e-9, ..Options::default() }, range: (3.0, 4.0), ..BranchOptions::default() };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let fold = branch.folds().next().unwrap();
    let conditioning = Linearisation::new(&problem, &fold.solution).map(|linearisation| linearisation.conditioning());
    assert!(conditioning.is_err() || conditioning.is_ok_and(|conditioning| conditioning.kappa() > 1e4));
}

/// Keeps the checkpoint of one step and stops there.
struct StopAt {
    step: usize,
    kept: Option<Checkpoint>,
}

impl Observer for StopAt {
    fn notify(&mut self, event: &Event) -> ControlFlow<()> {
        match event {
            Event::Step { step, .. } if *step > self.step => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
    fn wants_checkpoints(&self) -> bool {
        true
    }
    fn checkpoint(&mut self, checkpoint: &Checkpoint) {
        self.kept = Some(checkpoint.clone());
    }
}

/// `ε u'' = u (1 - u')`.
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
        (g[0], g[1]) = (e[0] - 1.0, e[2] + 1.0 / 3.0);
    }
}

fn straight(_: usize, s: f64, y: &mut [f64]) {
    (y[0], y[1]) = (1.0 - 4.0 / 3.0 * s, -4.0 / 3.0);
}

#[test]
fn a_continuation_resumes_from_a_checkpoint_as_if_it_had_not_stopped() {
    let problem = Differentiated::new(Corners).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], straight);
    let path = Ramp::new().geometric(0, 1.0, 1e-4);
    let options = PathOptions::default();
    let whole = follow(&problem, &guess, &path, &[], &options).unwrap();
    let mut stop = StopAt { step: 2, kept: None };
    let error = follow_observed(&problem, &guess, &path, &[], &options, &mut stop).unwrap_err();
    assert_eq!(*error.cause, SolveError::Cancelled);
    assert!(error.last.is_some() && error.lambda > 0.0 && error.lambda < 1.0);
    let kept = stop.kept.unwrap();
    let mut text = Vec::new();
    kept.write(&mut text).unwrap();
    let read = Checkpoint::read(text.as_slice()).unwrap();
    assert_eq!(read, kept);
    let resumed = resume_observed(&problem, &read, &path, &[], &options, &mut Silent).unwrap();
    let rest = &whole.steps[whole.steps.len() + 1 - resumed.steps.len()..];
    assert_eq!(resumed.steps[1..].iter().map(|step| step.lambda).collect::<Vec<_>>(), rest.iter().map(|step| step.lambda).collect::<Vec<_>>());
    assert_eq!(resumed.solution.regions()[0].mesh(), whole.solution.regions()[0].mesh());
    assert!(Checkpoint::read(&b"something else\n"[..]).is_err());
}

#[test]
fn a_stiff_problem_is_solved_by_continuation_in_its_stiffness() {
    let problem = Differentiated::new(Corners).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1e-4], straight);
    assert!(solve(&problem, &guess, &[], &Options::default()).is_err());
    for easy in [Some(1.0), None] {
        let stiffness = Stiffness { constant: 0, easy };
        let found = solve_automatically(&problem, &guess, &[], Some(stiffness), &Options::default()).unwrap();
        println!("{:?} {:?}", found.how, found.stats);
        assert!(matches!(found.how, How::Stiffness { .. }));
        assert_eq!(found.solution.constants(), [1e-4]);
    }
}

/// Seydel's nerve impulse: a periodic orbit of unknown period, from a poor guess.
struct Nerve;

impl Model for Nerve {
    fn layout(&self) -> Layout {
        let region = Region::dense("period", (0.0, 1.0), &["v", "w"], &[], 1);
        Layout::dense(vec![region], &["T"], &["v closes", "w closes", "phase"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = (y[0] + y[1] - y[0].powi(3) / 3.0 - 1.3) * c[0] * 3.0;
        f[1] = -(y[0] - 0.7 + y[1] * 0.8) * c[0] / 3.0;
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[2] - e[0], e[3] - e[1]);
        g[2] = -(e[0] - 0.7 + e[1] * 0.8) * c[0] / 3.0 - 1.0;
    }
}

#[test]
fn a_poor_guess_is_deformed_into_a_solution() {
    let problem = Differentiated::new(Nerve).unwrap();
    for intervals in [5, 12, 20] {
        let guess = Guess::uniform(problem.layout(), intervals, &[std::f64::consts::TAU], |_, s, y| {
            (y[1], y[0]) = (std::f64::consts::TAU * s).sin_cos();
            y.swap(0, 1);
        });
        let found = solve_automatically(&problem, &guess, &[0], None, &Options { rescues: 0, ..Options::default() });
        match found {
            Ok(found) => println!("{intervals}: {:?} T = {} {:?}", found.how, found.solution.constants()[0], found.stats),
            Err(error) => println!("{intervals}: {error}"),
        }
    }
}
