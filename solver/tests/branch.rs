//! Branches through folds, events, checkpoints, and the ways around a failing guess.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use solver::bvp::Bvp;
use solver::continuation::{
    BranchOptions, Checkpoint, Direction, How, PathOptions, PointKind, Ramp, Saved, Side, Stiffness, follow,
    follow_observed, resume_follow, resume_trace, solve_automatically, trace, trace_crossing, trace_crossing_observed,
    trace_observed,
};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Accuracy, BranchCheck, Event, Guess, Layout, LayoutError, Linearisation, Observer, Options, Order, Problem, Region,
    RegionGuess, Silent, Solution, SolveError, solve,
};
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

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
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let options = BranchOptions {
            solve: Options { order, tolerance: 1e-10, ..Options::default() },
            range: (0.5, 10.0),
            ..BranchOptions::default()
        };
        let peak = |solution: &Solution| middle(solution) - 3.0;
        let branch = trace(&problem, &guess, 0, &[], &options, &[&peak]).unwrap();
        println!("{order:?} {:?}", branch.stats);
        // Some ten steps, and as many iterations to locate a fold, an event and the end.
        assert!(branch.points.len() <= 20 && branch.stats.newton_iterations <= 75, "{:?}", branch.stats);
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

/// Going up and coming back: λ = 2 is met on both sides of the fold.
#[test]
fn an_event_whose_function_jumps_is_told_at_the_jump_and_a_pole_is_not_told() {
    let string = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -y[0].exp() * p[0]),
        |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    )
    .given("lambda", 1.0);
    let options = BranchOptions { range: (0.5, 3.9), ..BranchOptions::default() };
    let beyond = |solution: &Solution| solution.constants()[0] - 2.0;
    let flag = |solution: &Solution| if beyond(solution) > 0.0 { 1.0 } else { -1.0 };
    let uneven = |solution: &Solution| if beyond(solution) > 0.0 { 3.0 } else { -1.0 };
    // Larger at the jump than at both ends of a step, as an angle that passes π.
    let wrapped = |solution: &Solution| 0.5 * beyond(solution) - flag(solution);
    let steep = |solution: &Solution| (1e6 * beyond(solution)).tanh();
    let pole = |solution: &Solution| 1.0 / beyond(solution);
    let weak_pole = |solution: &Solution| 1.0 / beyond(solution).cbrt();
    let smooth = |solution: &Solution| beyond(solution);
    let count = 7;
    let branch = trace(
        &string,
        &string.start(),
        0,
        &[],
        &options,
        &[&flag, &uneven, &wrapped, &steep, &smooth, &pole, &weak_pole],
    )
    .unwrap();
    println!("{:?}", branch.stats);
    assert_eq!(branch.folds().count(), 1);
    for event in 0..count {
        let told = branch.points.iter().filter(|point| point.kind == PointKind::Event(event));
        let places: Vec<f64> = told.map(|point| point.parameter).collect();
        assert_eq!(places.len(), if event < 5 { 2 } else { 0 }, "{event}: {places:?}");
        let exact = if event == 3 { 1e-6 } else { 1e-8 };
        assert!(places.iter().all(|place| (place - 2.0).abs() < exact), "{event}: {places:?}");
    }
}

/// What comes before the point at which it is to end is the same as without.
#[test]
fn a_tracing_ends_where_it_is_to() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (0.5, 10.0), ..BranchOptions::default() };
    let (low, high) = (|solution: &Solution| middle(solution) - 0.5, |solution: &Solution| middle(solution) - 3.0);
    let traced = |stop_at: &[PointKind]| {
        let options = BranchOptions { stop_at: stop_at.to_vec(), ..options.clone() };
        trace(&problem, &guess, 0, &[], &options, &[&low, &high])
    };
    let whole = traced(&[]).unwrap();
    let (fold, branch_point) = (PointKind::Fold, PointKind::BranchPoint);
    for (stop_at, last) in [
        (&[fold][..], fold),
        (&[PointKind::Event(1)], PointKind::Event(1)),
        (&[PointKind::Event(1), fold], fold),
        (&[fold, PointKind::Event(0)], PointKind::Event(0)),
        (&[branch_point], PointKind::End),
    ] {
        let branch = traced(stop_at).unwrap();
        let place = whole.points.iter().position(|point| point.kind == last).unwrap();
        let told = |points: &[solver::continuation::BranchPoint]| -> Vec<(PointKind, f64)> {
            points.iter().map(|point| (point.kind, point.parameter)).collect()
        };
        assert_eq!(told(&branch.points), told(&whole.points[..=place]), "{stop_at:?}");
    }
    let error = traced(&[PointKind::Event(2)]).unwrap_err();
    assert!(error.points.is_empty() && error.to_string().contains("stop_at"), "{error}");
}

#[test]
fn at_a_fold_there_is_no_tangent_in_the_parameter() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[3.0], |_, _, y| y.fill(0.0));
    let options = BranchOptions {
        solve: Options { tolerance: 1e-9, ..Options::default() },
        range: (3.0, 4.0),
        ..BranchOptions::default()
    };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let fold = branch.folds().next().unwrap();
    let conditioning = Linearisation::new(&problem, &fold.solution).map(|linearisation| linearisation.conditioning());
    assert!(conditioning.is_err() || conditioning.is_ok_and(|conditioning| conditioning.kappa() > 1e4));
}

/// Between folds that are closer than steps are long the parameter goes back a little: `λ = x³ - δ x` from far below,
/// with folds at `λ = ±2 (δ/3)^(3/2)`, and the same where λ is as small as 1e-9.
#[test]
fn two_folds_within_one_step_are_seen_by_what_the_parameter_does_at_its_ends() {
    for (apart, size) in [(0.1, 1.0), (1e-2, 1.0), (1e-3, 1.0), (1e-2, 1e-9)] {
        let cubic = Bvp::new(
            &["x"],
            (0.0, 1.0),
            |_, _, _, f| f[0] = solver::bvp::Number::from(0.0),
            move |a, _, p, g| g[0] = a[0].powi(3) - a[0] * apart - p[0] / size,
        );
        let cubic = cubic.given("load", -size).guess(4, |_, y| y[0] = -1.0).typical("load", size).unwrap();
        let options = BranchOptions { range: (-size, size), ..BranchOptions::default() };
        let branch = trace(&cubic, &cubic.start(), 0, &[], &options, &[]).unwrap();
        let folds: Vec<f64> = branch.folds().map(|fold| fold.parameter / size).collect();
        let fold = 2.0 * (apart / 3.0_f64).powf(1.5);
        assert_eq!(folds.len(), 2, "{apart} {size}: {folds:?}");
        assert!((folds[0] - fold).abs() < 1e-6 && (folds[1] + fold).abs() < 1e-6, "{apart} {size}: {folds:?}");
    }
    let unknown = Bvp::new(&["x"], (0.0, 1.0), |_, y, _, f| f[0] = y[0], |a, _, _, g| g[0] = a[0] - 1.0);
    assert!(matches!(unknown.clone().typical("y", 1.0), Err(LayoutError::Unnamed { name }) if name == "y"));
    assert!(matches!(unknown.typical("x", -1.0), Err(LayoutError::Scale { .. })));
}

/// Stops after so many steps; checkpoints go to a file.
struct Stop {
    after: usize,
    saved: Saved,
}

impl Observer for Stop {
    fn notify(&mut self, event: &Event) -> ControlFlow<()> {
        match event {
            Event::Step { step, .. } if *step > self.after => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
    fn wants_checkpoints(&self) -> bool {
        true
    }
    fn checkpoint(&mut self, checkpoint: &Checkpoint) {
        self.saved.checkpoint(checkpoint);
    }
}

fn stop_after(steps: usize, file: &str) -> (Stop, PathBuf) {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(file);
    (Stop { after: steps, saved: Saved::to(&path) }, path)
}

#[test]
fn a_branch_resumes_from_a_file_next_to_its_fold() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    // Seven steps as long as the iteration allows lead there.
    let options = BranchOptions { range: (0.5, 10.0), resolve_branch_points: false, ..BranchOptions::default() };
    let whole = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let (mut stop, path) = stop_after(7, "bratu.checkpoint");
    let error = trace_observed(&problem, &guess, 0, &[], &options, &[], &mut stop).unwrap_err();
    assert_eq!(*error.cause, SolveError::Cancelled);
    assert!(stop.saved.failure.is_none());
    let last = error.points.last().unwrap();
    assert!(last.parameter > 3.5, "close to the fold, where the parameter determines nothing: {}", last.parameter);
    let kept = Checkpoint::load(&path).unwrap();
    assert_eq!(kept.position, last.arclength);
    let rest = resume_trace(&problem, &kept, 0, &[], &options, &[], &mut Silent).unwrap();
    let (a, b) = (rest.folds().next().unwrap(), whole.folds().next().unwrap());
    assert!((a.parameter - b.parameter).abs() < 1e-7 && (a.arclength - b.arclength).abs() < 1e-4);
    let (end, whole_end) = (rest.points.last().unwrap(), whole.points.last().unwrap());
    assert_eq!(end.kind, PointKind::End);
    assert!((middle(&end.solution) - middle(&whole_end.solution)).abs() < 1e-4);
    assert!(rest.points.len() <= whole.points.len() - 8, "{} {}", rest.points.len(), whole.points.len());
    // A path's checkpoint is none of a branch.
    let path = Checkpoint { direction: None, ..kept };
    let error = resume_trace(&problem, &path, 0, &[], &options, &[], &mut Silent).unwrap_err();
    assert!(matches!(*error.cause, SolveError::Option { .. }), "{error}");
}

/// Euler's strut, from its straight state: one side of the buckled branch alone, interrupted, and gone on with.
#[test]
fn a_crossing_branch_is_watched_and_resumes_from_a_file() {
    let strut = Bvp::new(
        &["angle", "curvature"],
        (0.0, 1.0),
        |_, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].sin()),
        |a, b, _, g| (g[0], g[1]) = (a[1], b[1]),
    )
    .given("load", 5.0);
    let options = BranchOptions { range: (5.0, 15.0), ..BranchOptions::default() };
    let straight = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
    let buckling = straight.branch_points().next().unwrap();
    let wanted = trace_crossing(&strut, buckling, 0, &[], &options, &[]).unwrap();
    for (side, wanted) in [Side::First, Side::Second].into_iter().zip(wanted) {
        let (mut stop, path) = stop_after(4, &format!("crossing-{side:?}.checkpoint"));
        let lost = trace_crossing_observed(&strut, (buckling, side), 0, &[], &options, &[], &mut stop).unwrap_err();
        assert!(matches!(*lost.cause, SolveError::Cancelled) && lost.points.len() < wanted.points.len(), "{lost}");
        let from = Checkpoint::load(&path).unwrap();
        let rest = resume_trace(&strut, &from, 0, &[], &options, &[], &mut Silent).unwrap();
        let [end, whole] = [&rest, &wanted].map(|branch| branch.points.last().unwrap());
        assert!(end.kind == PointKind::End && rest.points[0].arclength == from.position);
        let [end, whole] = [end, whole].map(|point| point.solution.regions()[0].eval(0.0)[0]);
        assert!((end - whole).abs() < 1e-4 && whole.abs() > 1.0, "{end} {whole}");
    }
}

#[test]
fn a_damaged_checkpoint_is_refused_by_line() {
    let guess = Guess {
        regions: vec![RegionGuess { mesh: vec![0.0, 0.1, 1.0], states: vec![vec![1.0 / 3.0, -0.0, 5e-324]] }],
        constants: vec![std::f64::consts::PI, f64::MAX],
    };
    let direction = Direction { states: vec![vec![vec![1e-17, 0.1, 0.3]]], constants: vec![1.0, 0.0] };
    let checkpoint = Checkpoint { position: 0.1, step: 1e-3, guess, direction: Some(direction) };
    let mut text = Vec::new();
    checkpoint.write(&mut text).unwrap();
    assert_eq!(Checkpoint::read(text.as_slice()).unwrap(), checkpoint);
    let text = String::from_utf8(text).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for (line, replacement) in [(1, "something else"), (2, "1 2 3"), (3, "1 x"), (5, "0 NaN 1"), (6, "1 2")] {
        let mut damaged = lines.clone();
        damaged[line - 1] = replacement;
        let error = Checkpoint::read(damaged.join("\n").as_bytes()).unwrap_err();
        assert!(error.to_string().starts_with(&format!("line {line} ")), "{error}");
    }
    for kept in 0..lines.len() {
        assert!(Checkpoint::read(lines[..kept].join("\n").as_bytes()).is_err(), "{kept} lines");
    }
    // A number that is cut off is another number.
    for kept in 0..text.len() {
        assert!(Checkpoint::read(&text.as_bytes()[..kept]).is_err(), "{kept} characters");
    }
    let path = Checkpoint { direction: None, ..checkpoint };
    let mut text = Vec::new();
    path.write(&mut text).unwrap();
    assert_eq!(Checkpoint::read(text.as_slice()).unwrap(), path);
    for kept in 0..text.len() {
        assert!(Checkpoint::read(&text[..kept]).is_err(), "{kept} characters");
    }
}

/// `u'' = -λ exp(x³ u)`, `u(0) = u(1) = 0`: a fold of the test set.
struct Cubic;

impl Model for Cubic {
    fn layout(&self) -> Layout {
        Bratu.layout()
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], -c[0] * (x.powi(3) * y[0]).exp(), y[0]);
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], c: &[S], g: &mut [S]) {
        Bratu.boundary(e, i, c, g);
    }
}

#[test]
fn the_test_set_s_second_fold_has_eight_digits() {
    let data: serde_json::Value = serde_json::from_str(include_str!("data/bvp-testset.json")).unwrap();
    let record = data["problems"].as_array().unwrap().iter().find(|problem| problem["id"] == "FOLD_NON").unwrap();
    let reference = record["references"][0]["p1_fold"].as_f64().unwrap();
    let problem = Differentiated::new(Cubic).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(0.0));
    let solve = Options { order: Order::Six, tolerance: 1e-9, ..Options::default() };
    let options = BranchOptions { solve, range: (0.5, 20.0), ..BranchOptions::default() };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let folds: Vec<f64> = branch.folds().map(|fold| fold.parameter).collect();
    println!("{folds:?} {reference} {:?}", branch.stats);
    assert!((folds[0] - reference).abs() < 1e-8 * reference);
}

/// `u'' = -λ exp(u / (1 + μ u))`, `u(0) = u(1) = 0`: two folds if μ is small, an S.
struct Ignition;

impl Model for Ignition {
    fn layout(&self) -> Layout {
        let slab = Region::dense("slab", (0.0, 1.0), &["u", "slope"], &[], 2);
        Layout::dense(vec![slab], &["lambda", "mu"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], -c[0] * (y[0] / (c[1] * y[0] + 1.0)).exp());
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2]);
    }
}

#[test]
fn a_branch_turns_twice_and_goes_on_in_another_constant() {
    let problem = Differentiated::new(Ignition).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5, 0.2], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (0.1, 8.0), ..BranchOptions::default() };
    let hot = |solution: &Solution| middle(solution) - 10.0;
    let branch = trace(&problem, &guess, 0, &[], &options, &[&hot]).unwrap();
    let folds: Vec<f64> = branch.folds().map(|fold| fold.parameter).collect();
    println!("{folds:?} {:?}", branch.stats);
    assert!(folds.len() == 2 && folds[0] > folds[1], "{folds:?}");
    let event = branch.points.iter().find(|point| point.kind == PointKind::Event(0)).unwrap();
    // From there, with λ held, in μ: the other way round, u grows as μ falls.
    let options = BranchOptions { range: (0.15, 0.25), upwards: false, ..options };
    let other = trace(&problem, &Guess::from(&event.solution), 1, &[], &options, &[]).unwrap();
    let end = other.points.last().unwrap();
    assert_eq!(end.kind, PointKind::End);
    assert!(other.points.iter().all(|point| point.solution.constants()[0] == event.parameter));
    let direct = solve(&problem, &Guess::from(&end.solution), &[], &Options::default()).unwrap();
    assert_eq!(direct.constants(), end.solution.constants());
    assert!(direct.stats().newton_iterations <= 2);
}

#[test]
fn senseless_options_of_a_continuation_are_refused() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    let refused = |options: &BranchOptions, parameter: usize| {
        let error = trace(&problem, &guess, parameter, &[], options, &[]).unwrap_err();
        assert!(error.cause.is_final() && error.points.is_empty(), "{error}");
    };
    refused(&BranchOptions { range: (1.0, 2.0), ..BranchOptions::default() }, 0);
    refused(&BranchOptions { first_step: -0.1, ..BranchOptions::default() }, 0);
    refused(&BranchOptions { smallest_step: f64::NAN, ..BranchOptions::default() }, 0);
    refused(&BranchOptions::default(), 1);
    let path = Ramp::new().linear(0, 0.5, 1.0);
    let few = PathOptions { first_step: 0.01, largest_step: 0.01, max_steps: 3, ..PathOptions::default() };
    let error = follow(&problem, &guess, &path, &[], &few).unwrap_err();
    assert_eq!(*error.cause, SolveError::Steps { steps: 3 });
    assert!(error.last.is_some());
    let none = PathOptions { max_iterations: 0, ..PathOptions::default() };
    let error = follow(&problem, &guess, &path, &[], &none).unwrap_err();
    assert!(matches!(*error.cause, SolveError::Option { name: "max_iterations", .. }), "{error}");
    // The position of a branch's checkpoint is no place on a path.
    let direction = Direction { states: vec![vec![vec![0.0; 11]; 2]], constants: vec![1.0] };
    let on_branch = Checkpoint { position: 0.5, step: 0.1, guess: guess.clone(), direction: Some(direction) };
    let error = resume_follow(&problem, &on_branch, &path, &[], &PathOptions::default(), &mut Silent).unwrap_err();
    assert!(matches!(*error.cause, SolveError::Option { name: "position", .. }), "{error}");
    let still = PathOptions { first_step: 0.0, ..PathOptions::default() };
    assert!(matches!(*follow(&problem, &guess, &path, &[], &still).unwrap_err().cause, SolveError::Option { .. }));
    for easy in [f64::NAN, f64::INFINITY] {
        let stiffness = Some(Stiffness { constant: 0, easy: Some(easy) });
        let error = solve_automatically(&problem, &guess, &[], stiffness, &Options::default()).unwrap_err();
        assert!(matches!(error, SolveError::Option { name: "easy", .. }), "{error}");
    }
}

#[test]
fn a_range_that_ends_where_the_branch_begins() {
    let problem = Differentiated::new(Bratu).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[0.5], |_, _, y| y.fill(0.0));
    let options = BranchOptions { range: (0.1, 0.5), ..BranchOptions::default() };
    let branch = trace(&problem, &guess, 0, &[], &options, &[]).unwrap();
    let kinds: Vec<PointKind> = branch.points.iter().map(|point| point.kind).collect();
    assert_eq!(kinds, [PointKind::Regular, PointKind::End]);
    assert!((branch.points[1].parameter - 0.5).abs() < 1e-6);
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
fn a_path_resumes_from_a_file() {
    let problem = Differentiated::new(Corners).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1.0], straight);
    let path = Ramp::new().geometric(0, 1.0, 1e-4);
    let options = PathOptions::default();
    let whole = follow(&problem, &guess, &path, &[], &options).unwrap();
    let (mut stop, file) = stop_after(2, "corners.checkpoint");
    let error = follow_observed(&problem, &guess, &path, &[], &options, &mut stop).unwrap_err();
    assert_eq!(*error.cause, SolveError::Cancelled);
    assert!(error.last.is_some() && error.lambda > 0.0 && error.lambda < 1.0);
    let kept = Checkpoint::load(&file).unwrap();
    assert_eq!(kept.position, error.lambda);
    let resumed = resume_follow(&problem, &kept, &path, &[], &options, &mut Silent).unwrap();
    assert_eq!(resumed.solution.constants(), whole.solution.constants());
    assert!(resumed.steps.len() < whole.steps.len(), "{:?} {:?}", resumed.steps, whole.steps);
    assert!(resumed.solution.stats().newton_iterations < whole.solution.stats().newton_iterations);
    let (a, b) = (&resumed.solution.regions()[0], &whole.solution.regions()[0]);
    assert!((1..10).map(|i| 0.1 * f64::from(i)).all(|s| (a.eval(s)[0] - b.eval(s)[0]).abs() < 1e-5));
}

/// And directly, where meshes may be made for the layers that the derivatives allow beside the guess.
#[test]
fn a_stiff_problem_is_solved_by_continuation_in_its_stiffness() {
    let problem = Differentiated::new(Corners).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[1e-4], straight);
    let options = Options { other_orders: false, ..Options::default() };
    assert!(solve(&problem, &guess, &[], &options).is_err());
    let direct = solve(&problem, &guess, &[], &Options::default()).unwrap();
    for easy in [Some(1.0), None] {
        let stiffness = Stiffness { constant: 0, easy };
        let found = solve_automatically(&problem, &guess, &[], Some(stiffness), &options).unwrap();
        println!("{:?} {:?}", found.how, found.stats);
        assert!(matches!(found.how, How::Stiffness { .. }));
        assert_eq!(found.solution.constants(), [1e-4]);
        let (a, b) = (&found.solution.regions()[0], &direct.regions()[0]);
        assert!((1..10).map(|i| 0.1 * f64::from(i)).all(|s| (a.eval(s)[0] - b.eval(s)[0]).abs() < 1e-5));
    }
}

/// A shock inside: `ε u'' + u u' - u = 0`, `u(0) = -1`, `u(1) = 3/2`; it stands at 1/4, where `ε u' = 9/32`.
struct Shock;

impl Model for Shock {
    fn layout(&self) -> Layout {
        Corners.layout()
    }
    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        Corners.rhs(region, s, y, c, f);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0] + 1.0, e[2] - 1.5);
    }
}

#[test]
fn a_shock_is_followed_until_it_is_a_millionth_wide() {
    let problem = Differentiated::new(Shock).unwrap();
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        for epsilon in [1e-4, 1e-5, 1e-6] {
            let guess = Guess::uniform(problem.layout(), 20, &[epsilon], |_, s, y| (y[0], y[1]) = (2.5 * s - 1.0, 2.5));
            let options = Options { order, ..Options::default() };
            let stiffness = Stiffness { constant: 0, easy: Some(1.0) };
            let found = solve_automatically(&problem, &guess, &[], Some(stiffness), &options).unwrap();
            println!("{order:?} {epsilon:e} {:?} {:?}", found.how, found.stats);
            assert_eq!(found.solution.accuracy(), Accuracy::Met, "{order:?} {epsilon}");
            // Intervals may be as wide as the peak.
            let line = &found.solution.regions()[0];
            let inside = |pair: &[f64]| (0..20).map(|k| pair[0] + (pair[1] - pair[0]) * f64::from(k) / 20.0).collect();
            let places = line.mesh().windows(2).flat_map(|pair| -> Vec<f64> { inside(pair) });
            let slope = places.fold(0.0, |max: f64, s| max.max(line.eval(s)[1].abs()));
            assert!((epsilon * slope - 9.0 / 32.0).abs() < 1e-3 + 3.0 * epsilon, "{}", epsilon * slope);
        }
    }
}

/// Troesch: `u'' = μ sinh(μ u)`, `u(0) = 0`, `u(1) = 1`; a steep layer for large μ.
struct Troesch(f64);

impl Model for Troesch {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 0)], &[], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], (y[0] * self.0).sinh() * self.0);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0], e[2] - 1.0);
    }
}

#[test]
fn where_no_parameter_is_named_the_guess_is_deformed_into_a_solution() {
    let problem = Differentiated::new(Troesch(20.0)).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, _, y| y.fill(0.0));
    assert!(solve(&problem, &guess, &[], &Options::default()).is_err());
    let found = solve_automatically(&problem, &guess, &[], None, &Options::default()).unwrap();
    let How::Homotopy { points } = found.how else { panic!("{:?}", found.how) };
    assert!(points <= 12 && found.stats.newton_iterations <= 100, "{points} {:?}", found.stats);
    // The slope at the left end: test set, T23 at 20.
    let data: serde_json::Value = serde_json::from_str(include_str!("data/bvp-testset.json")).unwrap();
    let record = data["problems"].as_array().unwrap().iter().find(|problem| problem["id"] == "T23").unwrap();
    let reference = record["references"].as_array().unwrap().iter().find(|one| one["parameter"] == 20.0).unwrap();
    let [x, u] = [&reference["x"], &reference["y"][0]].map(|values| values.as_array().unwrap());
    for (x, u) in x.iter().zip(u) {
        let (x, u) = (x.as_f64().unwrap(), u.as_f64().unwrap());
        assert!((found.solution.regions()[0].eval(x)[0] - u).abs() < 1e-5, "{x}");
    }
}

/// `u'' + 2u'/x + λ e^u = 0` in the unit ball (Gelfand; D. D. Joseph and T. S. Lundgren, Arch. Rational Mech. Anal. 49
/// (1973) 241-269): folds without end about λ = 2, ever closer in λ, as u(0) grows and a layer about the centre thins.
/// From a fold long steps lead to parts of the branch that lie beyond the next ones: they are rejected.
#[test]
fn no_fold_of_many_is_passed_over_by_a_step_that_goes_astray() {
    let known = [3.321_992, 1.664_156, 2.108_541, 1.967_466, 2.009_976, 1.996_962, 2.000_927, 1.999_717];
    let term: [&[f64]; 2] = [&[0.0, 0.0], &[0.0, -2.0]];
    // It takes more points for the determinant to be known between them.
    for (order, tolerance, intervals, points, resolve_branch_points) in [
        (Order::Four, 1e-4, 20, 41, false),
        (Order::Six, 1e-6, 8, 41, false),
        (Order::Eight, 1e-6, 8, 41, false),
        (Order::Four, 1e-4, 20, 60, true),
        (Order::Six, 1e-6, 8, 60, true),
        (Order::Eight, 1e-6, 8, 60, true),
    ] {
        let ball = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, p, f| (f[0], f[1]) = (y[1], -(y[0].exp() * p[0])),
            |a, b, _, g| (g[0], g[1]) = (a[1], b[0]),
        );
        let ball = ball.given("lambda", 0.0).singular_term(&term).unwrap().guess(intervals, |_, y| y.fill(0.0));
        let solve = Options { order, tolerance, ..Options::default() };
        let options = BranchOptions {
            solve,
            range: (-0.1, 5.0),
            max_points: points,
            resolve_branch_points,
            ..BranchOptions::default()
        };
        let branch = trace(&ball, &ball.start(), 0, &[], &options, &[]).unwrap();
        let folds: Vec<f64> = branch.folds().map(|point| point.parameter).collect();
        assert!(folds.len() >= known.len(), "{order:?}: {folds:?}");
        for (found, known) in folds.iter().zip(known) {
            assert!((found - known).abs() < 20.0 * tolerance.max(1e-7), "{order:?}: {found} for {known}");
        }
        // Between folds u at the centre goes on growing.
        let centre: Vec<f64> = branch.points.iter().map(|point| point.solution.regions()[0].state(0)[0]).collect();
        assert!(centre.is_sorted(), "{order:?}: {centre:?}");
    }
}

/// `u'' + λ (u - u³) + 0.01 = 0`, u = 0 at both ends: the pitchfork at π² has come apart, and the part that turns at
/// λ = 10.07 passes close to the other one on its way to a branch point at 4π².
#[test]
fn a_step_that_crosses_to_a_near_branch_is_made_shorter() {
    for (order, tolerance, intervals) in [
        (Order::Four, 1e-4, 8),
        (Order::Six, 1e-4, 8),
        (Order::Eight, 1e-4, 8),
        (Order::Eight, 1e-4, 20),
        (Order::Eight, 1e-6, 20),
    ] {
        let beam = Bvp::new(
            &["u", "slope"],
            (0.0, 1.0),
            |_, y, p, f| (f[0], f[1]) = (y[1], -(p[0] * (y[0] - y[0].powi(3))) - 0.01),
            |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
        );
        let beam = beam.given("lambda", 20.0).guess(intervals, |x, y| {
            let (sine, cosine) = (PI * x).sin_cos();
            (y[0], y[1]) = (-0.8 * sine, -0.8 * PI * cosine);
        });
        let solve = Options { order, tolerance, ..Options::default() };
        let options = BranchOptions { solve, range: (2.0, 30.0), upwards: false, ..BranchOptions::default() };
        let branch = trace(&beam, &beam.start(), 0, &[], &options, &[]).unwrap();
        let folds: Vec<f64> = branch.folds().map(|point| point.parameter).collect();
        assert!(folds.len() == 1 && (folds[0] - 10.0718).abs() < 2e-3, "{order:?}: {folds:?}");
        assert_eq!(branch.branch_points().count(), 0, "{order:?}");
        let end = branch.points.last().unwrap();
        assert!((end.parameter - 30.0).abs() < 1e-6 && end.solution.regions()[0].eval(0.5)[0].abs() < 1e-2);
    }
}

/// The Brusselator at rest, x = 2 and y = 2.3, in a reactor of length L with those values at its ends. Patterns of k
/// half waves branch off where `(3.6 - 0.0016 s) (4 + 0.008 s) = 18.4` with `s = (kπ/L)²`.
#[test]
fn patterns_branch_off_where_linear_stability_says() {
    let lengths = |k: f64| {
        let root = (0.0224_f64.powi(2) - 4.0 * 1.28e-5 * 4.0).sqrt();
        [0.0224 + root, 0.0224 - root].map(|sum| k * PI / (sum / 2.56e-5).sqrt())
    };
    let mut known: Vec<f64> = (1..=5).flat_map(|k| lengths(f64::from(k))).filter(|length| *length < 0.4).collect();
    known.sort_by(f64::total_cmp);
    let reactor = Bvp::new(
        &["x", "x'", "y", "y'"],
        (0.0, 1.0),
        |_, z, p, f| {
            let (reaction, square) = (z[0] * z[0] * z[2], p[0] * p[0]);
            (f[0], f[1]) = (z[1], -(square * (2.0 - z[0] * 5.6 + reaction)) / 0.0016);
            (f[2], f[3]) = (z[3], -(square * (z[0] * 4.6 - reaction)) / 0.008);
        },
        |a, b, _, g| g.copy_from_slice(&[a[0] - 2.0, b[0] - 2.0, a[2] - 2.3, b[2] - 2.3]),
    );
    let reactor = reactor.given("length", 0.05).guess(20, |_, z| z.copy_from_slice(&[2.0, 0.0, 2.3, 0.0]));
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let solve = Options { order, ..Options::default() };
        let traced = |from: f64, step: f64| {
            let mut start = reactor.start();
            start.constants[0] = from;
            let options = BranchOptions {
                solve: solve.clone(),
                range: (0.04, 0.4),
                first_step: step,
                largest_step: step,
                ..BranchOptions::default()
            };
            let branch = trace(&reactor, &start, 0, &[], &options, &[]).unwrap();
            assert_eq!(branch.check, BranchCheck::Kept);
            branch.branch_points().map(|point| point.parameter).collect::<Vec<f64>>()
        };
        let found = traced(0.05, 0.01);
        assert_eq!(found.len(), 6, "{order:?}: {found:?} for {known:?}");
        assert!(found.iter().zip(&known).all(|(found, known)| (found - known).abs() < 2e-5), "{order:?}: {found:?}");
        // One that is followed by the range's end within the same step.
        let last = traced(0.385, 0.05);
        assert!(last.len() == 1 && (last[0] - known[5]).abs() < 2e-5, "{order:?}: {last:?}");
    }
}

/// The buckled strut `θ'' + P sin θ = 0`, θ' = 0 at both ends, up to ten times its buckling load: `P = 4 K(k)²` with
/// `k = sin(θ(0)/2)`. Long steps begin on meshes on which the sign of the determinant is another.
#[test]
fn a_step_on_whose_meshes_the_orientation_changes_is_made_shorter() {
    let mean = |mut a: f64, mut b: f64| {
        (0..40).for_each(|_| (a, b) = (0.5 * (a + b), (a * b).sqrt()));
        a
    };
    let load = |k: f64| (PI / mean(1.0, (1.0 - k * k).sqrt())).powi(2);
    let (mut low, mut high) = (0.5, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if load(middle) < 100.0 { low = middle } else { high = middle }
    }
    let known = 2.0 * low.asin();
    for (order, tolerance, intervals) in [
        (Order::Four, 1e-4, 20),
        (Order::Four, 1e-6, 8),
        (Order::Four, 1e-6, 20),
        (Order::Eight, 1e-4, 20),
        (Order::Eight, 1e-6, 8),
    ] {
        let strut = Bvp::new(
            &["angle", "curvature", "x", "y"],
            (0.0, 1.0),
            |_, z, p, f| {
                (f[0], f[1]) = (z[1], -(p[0] * z[0].sin()));
                (f[2], f[3]) = (z[0].cos(), z[0].sin());
            },
            |a, b, _, g| g.copy_from_slice(&[a[1], b[1], a[2], a[3]]),
        );
        let strut = strut.given("load", 10.5).guess(intervals, |s, z| {
            let (sine, cosine) = (PI * s).sin_cos();
            z.copy_from_slice(&[0.7 * cosine, -0.7 * PI * sine, 0.9 * s, 0.2]);
        });
        let solve = Options { order, tolerance, ..Options::default() };
        let options = BranchOptions { solve, range: (9.0, 100.0), ..BranchOptions::default() };
        let branch = trace(&strut, &strut.start(), 0, &[], &options, &[]).unwrap();
        assert_eq!((branch.check, branch.branch_points().count()), (BranchCheck::Kept, 0), "{order:?} {tolerance:e}");
        let found = branch.points.last().unwrap().solution.regions()[0].state(0)[0];
        assert!((found - known).abs() < 5.0 * tolerance, "{order:?}: {found} for {known}");
    }
}
