//! Many problems solved side by side: the same answers as one by one, in the same order.

#![allow(clippy::unwrap_used)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{Cancel, Guess, Layout, Options, Order, Problem, Region, SolveError, solve, solve_many};

/// `u'' = -λ exp(u)` or, without the exponential, `u'' = -λ (1 + u)`.
struct Bratu {
    linear: bool,
}

impl Model for Bratu {
    fn layout(&self) -> Layout {
        let line = Region::dense("line", (0.0, 1.0), &["u", "slope"], &[], 1);
        Layout::dense(vec![line], &["lambda"], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        let source = if self.linear { y[0] + 1.0 } else { y[0].exp() };
        (f[0], f[1]) = (y[1], -c[0] * source);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0], ends[2]);
    }
}

fn guess(problem: &dyn Problem, lambda: f64) -> Guess {
    Guess::uniform(problem.layout(), 10, &[lambda], |_, _, y| y.fill(0.0))
}

#[test]
fn answers_have_the_order_of_the_tasks_and_the_bits_of_one_by_one() {
    let bratu = Differentiated::new(Bratu { linear: false }).unwrap();
    let linear = Differentiated::new(Bratu { linear: true }).unwrap();
    // No solution beyond 3.5138: the failure stands in its place.
    let lambdas = [0.5, 3.4, 4.0, 1.0, 0.1, 2.0, 3.0, 2.5];
    let problems: [&(dyn Problem + Sync); 2] = [&bratu, &linear];
    let cases: Vec<_> =
        lambdas.iter().flat_map(|&lambda| problems.map(|problem| (problem, guess(problem, lambda)))).collect();
    let tasks: Vec<_> = cases.iter().map(|(problem, guess)| (*problem, guess)).collect();
    for order in [Order::Four, Order::Eight] {
        let options = Options { order, tolerance: 1e-8, ..Options::default() };
        let found = solve_many(&tasks, &[], &options);
        assert_eq!(found.len(), tasks.len());
        let mut failed = 0;
        for (found, (problem, guess)) in found.iter().zip(&tasks) {
            match (found, solve(*problem, guess, &[], &options)) {
                (Ok(found), Ok(alone)) => {
                    assert_eq!(found.constants(), guess.constants);
                    assert_eq!(found.stats(), alone.stats());
                    assert_eq!(Guess::from(found), Guess::from(&alone));
                }
                (Err(found), Err(alone)) => {
                    failed += 1;
                    assert_eq!(found.to_string(), alone.to_string());
                }
                (found, alone) => panic!("{found:?} side by side, {alone:?} alone"),
            }
        }
        assert_eq!(failed, 1, "{order:?}");
    }
}

#[test]
fn one_handle_cancels_all() {
    let bratu = Differentiated::new(Bratu { linear: false }).unwrap();
    let guess = guess(&bratu, 1.0);
    let tasks = [(&bratu, &guess); 5];
    let cancel = Cancel::new();
    let options = Options { cancel: Some(cancel.clone()), ..Options::default() };
    assert!(solve_many(&tasks, &[], &options).iter().all(Result::is_ok));
    cancel.cancel();
    let found = solve_many(&tasks, &[], &options);
    assert!(found.iter().all(|found| matches!(found, Err(SolveError::Cancelled))), "{found:?}");
}
