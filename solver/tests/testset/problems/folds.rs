//! Folds as boundary value problems: the equations, their linearisation's null vector, and its norm.

use crate::problems::catalogue::record;
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Options, Order, Problem, Region, Solution, solve};
use std::f64::consts::PI;

/// `u'' = -λ exp(x^k u)`, `u(0) = u(1) = 0`, at its fold.
#[derive(Clone, Copy)]
pub struct Fold {
    pub id: &'static str,
    power: i32,
    /// Guess.
    height: f64,
    /// Guess.
    lambda: f64,
    /// Names of the reference's parameter, largest `u`, and slope at 0.
    names: [&'static str; 3],
}

pub const BRATU: Fold =
    Fold { id: "FOLD_BRATU", power: 0, height: 1.2, lambda: 3.4, names: ["lambda_fold", "u_max", "uprime0"] };
pub const NON: Fold =
    Fold { id: "FOLD_NON", power: 3, height: 3.5, lambda: 14.0, names: ["p1_fold", "u_max", "uprime0"] };

impl Model for Fold {
    fn layout(&self) -> Layout {
        let region = Region::dense("line", (0.0, 1.0), &["u", "slope", "null", "null slope"], &["norm"], 1);
        Layout::dense(vec![region], &["lambda"], &["left", "right", "left null", "right null", "unit norm"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        let weight = x.powi(self.power);
        let source = -c[0] * (weight * y[0]).exp();
        f.copy_from_slice(&[y[1], source, y[3], source * weight * y[2], y[2] * y[2]]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[4], ends[2], ends[6], integrals[0] - 1.0]);
    }
}

/// A fold found.
pub struct Found(pub Solution);

impl Found {
    /// Parameter, largest `u`, slope at 0.
    pub fn values(&self) -> [f64; 3] {
        let line = &self.0.regions()[0];
        let peak = (0..=20_000).map(|j| line.eval(f64::from(j) / 20_000.0)[0]).fold(0.0, f64::max);
        [self.0.constants()[0], peak, line.state(1)[0]]
    }
}

impl Fold {
    /// Parameter, largest `u`, slope at 0 from the data.
    pub fn reference(&self) -> [f64; 3] {
        self.names.map(|name| record(self.id)["references"][0][name].as_f64().unwrap())
    }

    /// Solves to a tolerance of 1e-10.
    pub fn locate(self) -> Found {
        let height = self.height;
        let problem = Differentiated::new(self).unwrap();
        let guess = Guess::uniform(problem.layout(), 20, &[self.lambda], |_, x, y| {
            let (sin, cos) = (PI * x).sin_cos();
            y.copy_from_slice(&[height * sin, PI * height * cos, 1.4 * sin, 1.4 * PI * cos]);
        });
        let options = Options { order: Order::Six, tolerance: 1e-10, ..Options::default() };
        Found(solve(&problem, &guess, &[0], &options).unwrap())
    }
}
