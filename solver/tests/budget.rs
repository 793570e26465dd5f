//! Work limits and cancellation from outside: every long computation ends when it is told to.

#![allow(clippy::unwrap_used)]

use solver::continuation::{
    Automatic, BranchOptions, How, PathOptions, Ramp, Stiffness, follow, solve_automatically,
    solve_automatically_observed, trace,
};
use solver::model::{Differentiated, Model, Scalar};
use solver::{Cancel, Event, Guess, Layout, Options, Order, Problem, Region, SolveError, solve};
use std::cell::Cell;
use std::ops::ControlFlow;

/// `u'' = -λ exp(u)`, `u(0) = u(1) = 0`: no solution for λ above 3.51. Counts the points it is evaluated at.
struct Bratu(Cell<usize>);

impl Model for Bratu {
    fn layout(&self) -> Layout {
        let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        self.0.set(self.0.get() + 1);
        (f[0], f[1]) = (y[1], -c[0] * y[0].exp());
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

fn bratu(lambda: f64) -> (Differentiated<Bratu>, Guess) {
    let problem = Differentiated::new(Bratu(Cell::new(0))).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[lambda], |_, _, y| y.fill(0.0));
    (problem, guess)
}

/// A batch of points may be under way when the limit is passed: one Newton iteration on ten or twenty intervals, with
/// its defects.
const SLACK: usize = 2000;

#[test]
fn every_computation_ends_at_its_work_limit() {
    let limit = 3000;
    let options = Options { work_limit: Some(limit), ..Options::default() };
    let spent = |error: &SolveError, problem: &Differentiated<Bratu>| {
        let SolveError::WorkLimit { points, limit: told } = error else { panic!("{error}") };
        assert!(error.is_final() && *told == limit && *points > limit, "{error}");
        // Derivatives of two states and one constant take one pass, of four at most.
        let counted = problem.model().0.get();
        assert!(counted > limit && counted < limit + SLACK, "{counted}");
    };
    // Beyond the fold there is no solution: the limit must hold over all attempts together.
    let (problem, guess) = bratu(4.0);
    spent(&solve(&problem, &guess, &[], &options).unwrap_err(), &problem);
    let (problem, guess) = bratu(4.0);
    let stiffness = Some(Stiffness { constant: 0, easy: None });
    spent(&solve_automatically(&problem, &guess, &[], stiffness, &options).unwrap_err(), &problem);
    let (problem, guess) = bratu(0.5);
    let path = PathOptions { solve: options.clone(), ..PathOptions::default() };
    let error = follow(&problem, &guess, &Ramp::new().linear(0, 0.5, 4.0), &[], &path).unwrap_err();
    assert!(error.last.is_some() && error.lambda > 0.5, "what was reached is kept");
    spent(&error.cause, &problem);
    let (problem, guess) = bratu(0.5);
    let branch = BranchOptions { solve: options, ..BranchOptions::default() };
    let error = trace(&problem, &guess, 0, &[], &branch, &[]).unwrap_err();
    assert!(error.points.len() > 2, "what was reached is kept");
    spent(&error.cause, &problem);
}

/// `ε u'' = (1 + x) u - u u'` with `u(0) = -0.8` and `∫u = 0.42`: an interior layer, which is come by from zero as the
/// guess is deformed. The integrand may be written such that it is undefined at the left end. Counts the points it is
/// evaluated at.
struct Layer {
    undefined: bool,
    points: Cell<usize>,
}

impl Model for Layer {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &["area"], 2);
        Layout::dense(vec![line], &["epsilon", "u at the right"], &["left", "right", "whole area"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        self.points.set(self.points.get() + 1);
        (f[0], f[1]) = (y[1], (y[0] * (x + 1.0) - y[0] * y[1]) / c[0]);
        f[2] = if self.undefined { y[0] * x / x } else { y[0] };
    }
    fn boundary<S: Scalar>(&self, e: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (e[0] + 0.8, e[2] - c[1], integrals[0] - 0.42);
    }
}

impl Layer {
    /// By order 6 at Gauss points alone, for with others it is come by directly; and the points at which it was
    /// evaluated.
    fn solve(undefined: bool, work_limit: Option<usize>) -> (Result<Automatic, SolveError>, usize) {
        let problem = Differentiated::new(Self { undefined, points: Cell::new(0) }).unwrap();
        let guess = Guess::uniform(problem.layout(), 10, &[3e-3, 0.0], |_, _, y| y.fill(0.0));
        let options = Options { order: Order::SixGauss, other_orders: false, work_limit, ..Options::default() };
        let found = solve_automatically(&problem, &guess, &[1], None, &options);
        (found, problem.model().points.get())
    }
}

/// A deformation evaluates the right-hand side at the guess as well: that counts.
#[test]
fn what_a_deformation_evaluates_at_the_guess_is_counted() {
    let (found, points) = Layer::solve(false, None);
    let found = found.unwrap();
    assert!(matches!(found.how, How::Homotopy { .. }), "{:?}", found.how);
    let (enough, again) = Layer::solve(false, Some(points));
    assert!(enough.is_ok() && again == points, "{again} of {points}");
    for limit in [points / 2, points * 9 / 10, points * 19 / 20] {
        let (found, spent) = Layer::solve(false, Some(limit));
        assert!(matches!(found, Err(SolveError::WorkLimit { .. })), "{limit} of {points}: {spent}");
        assert!(spent > limit && spent < limit + SLACK, "{limit} of {points}: {spent}");
    }
}

/// Orders that need nothing of the right-hand side at ends do not need it of a guess either.
#[test]
fn a_guess_is_deformed_where_an_integrand_is_undefined_at_an_end() {
    let [defined, undefined] = [false, true].map(|undefined| Layer::solve(undefined, None).0.unwrap());
    assert!(matches!(undefined.how, How::Homotopy { .. }), "{:?}", undefined.how);
    let [known, found] = [&defined, &undefined].map(|found| found.solution.constants()[1]);
    // By order 8, directly: 1.52527043.
    assert!((found - known).abs() < 1e-6 && (found - 1.525_270_43).abs() < 2e-6, "{found} {known}");
}

#[test]
fn the_work_limit_leaves_alone_what_needs_less() {
    let (problem, guess) = bratu(1.0);
    let free = solve(&problem, &guess, &[], &Options::default()).unwrap();
    let enough = Options { work_limit: Some(free.stats().points()), ..Options::default() };
    let (problem, guess) = bratu(1.0);
    assert_eq!(solve(&problem, &guess, &[], &enough).unwrap().stats(), free.stats());
    assert_eq!(Options { max_intervals: 7, ..Options::default() }.work_limit(), 7000);
    // To take off the estimated error in the end is work like any other.
    let correcting = |work_limit| {
        let (problem, guess) = bratu(1.0);
        solve(&problem, &guess, &[], &Options { defect_correction: true, work_limit, ..Options::default() })
    };
    let points = correcting(None).unwrap().stats().points();
    assert!(points > free.stats().points() && correcting(Some(points)).is_ok());
    let error = correcting(Some(points - 1)).unwrap_err();
    assert!(matches!(error, SolveError::WorkLimit { .. }), "{error}");
}

#[test]
fn a_handle_cancels_at_the_next_step_and_stays_cancelled() {
    let cancel = Cancel::new();
    let options = Options { cancel: Some(cancel.clone()), ..Options::default() };
    let (problem, guess) = bratu(4.0);
    let mut iterations = 0;
    let mut watch = |event: &Event| {
        if matches!(event, Event::Newton { .. }) {
            iterations += 1;
            if iterations == 5 {
                cancel.cancel();
            }
        }
        ControlFlow::Continue(())
    };
    let stiffness = Some(Stiffness { constant: 0, easy: None });
    let error = solve_automatically_observed(&problem, &guess, &[], stiffness, &options, &mut watch).unwrap_err();
    assert_eq!(error, SolveError::Cancelled);
    assert_eq!(iterations, 5);
    assert!(cancel.is_cancelled());
    // A cancelled handle stops a computation before its first iteration, and others that hold it too.
    let (problem, guess) = bratu(1.0);
    assert_eq!(solve(&problem, &guess, &[], &options).unwrap_err(), SolveError::Cancelled);
    assert!(problem.model().0.get() < 100, "{}", problem.model().0.get());
}

#[test]
fn a_handle_asks_on_the_computing_thread() {
    let computing = std::thread::current().id();
    let asked = std::sync::Arc::new(std::sync::atomic::AtomicUsize::new(0));
    let count = asked.clone();
    let cancel = Cancel::asking(move || {
        assert_eq!(std::thread::current().id(), computing);
        count.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 3
    });
    let options = Options { cancel: Some(cancel.clone()), ..Options::default() };
    let (problem, guess) = bratu(4.0);
    let stiffness = Some(Stiffness { constant: 0, easy: None });
    let mut ignored = |_: &Event| ControlFlow::Continue(());
    let error = solve_automatically_observed(&problem, &guess, &[], stiffness, &options, &mut ignored).unwrap_err();
    assert_eq!(error, SolveError::Cancelled);
    // What has said "stop" once is not asked again.
    assert!(cancel.is_cancelled());
    assert_eq!(asked.load(std::sync::atomic::Ordering::Relaxed), 4);
}

#[test]
fn a_handle_cancels_from_another_thread() {
    let cancel = Cancel::new();
    let options = Options { cancel: Some(cancel.clone()), work_limit: Some(usize::MAX), ..Options::default() };
    let (sender, receiver) = std::sync::mpsc::channel();
    let error = std::thread::scope(|scope| {
        let solving = scope.spawn(move || {
            // Solved over and over, until the other thread has seen it running and has cancelled.
            loop {
                let (problem, guess) = bratu(1.0);
                if let Err(error) = solve(&problem, &guess, &[], &options) {
                    return error;
                }
                // The receiver is gone once it has heard this.
                let _ = sender.send(());
            }
        });
        receiver.recv().unwrap();
        cancel.cancel();
        solving.join().unwrap()
    });
    assert_eq!(error, SolveError::Cancelled);
}
