//! Boundary value problems for ordinary differential equations in several regions, with unknown constants and
//! integral conditions, by collocation.
//!
//! Bratu's problem `u'' = -λ exp(u)`, `u(0) = u(1) = 0` at λ = 1:
//!
//! ```
//! use solver::model::{Differentiated, Model, Scalar};
//! use solver::{Guess, Layout, Options, Problem, Region, solve};
//!
//! struct Bratu;
//!
//! impl Model for Bratu {
//!     fn layout(&self) -> Layout {
//!         let string = Region::dense("string", (0.0, 1.0), &["u", "slope"], &[], 1);
//!         Layout::dense(vec![string], &["lambda"], &["left end", "right end"])
//!     }
//!     fn rhs<S: Scalar>(&self, _region: usize, _s: S, y: &[S], c: &[S], f: &mut [S]) {
//!         f[0] = y[1];
//!         f[1] = -c[0] * y[0].exp();
//!     }
//!     fn boundary<S: Scalar>(&self, ends: &[S], _integrals: &[S], _c: &[S], g: &mut [S]) {
//!         (g[0], g[1]) = (ends[0], ends[2]);
//!     }
//! }
//!
//! let problem = Differentiated::new(Bratu)?;
//! let guess = Guess::uniform(problem.layout(), 10, &[1.0], |_, _, y| y.fill(0.0));
//! let solution = solve(&problem, &guess, &[], &Options::default())?;
//! assert!((solution.regions()[0].eval(0.5)[0] - 0.14053921).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`bvp`]: a problem stated by two closures, in a few lines.
//! - [`problem`]: what a boundary value problem is, and how one is stated in batches; [`model`]: by its formulas alone.
//! - [`dae`]: algebraic equations beside the differential ones.
//! - [`solve()`] from a [`Guess`] to a [`Solution`], or to a [`SolveError`] that says where, what, and what to try.
//! - [`continuation`]: along paths, along branches through folds, and to solutions that no guess reaches.
//! - [`check_derivatives`]: which of the derivatives that are written by hand is wrong.
//! - [`Condensation`]: all sensitivities of ends, integrals and unknown constants at once. [`Linearisation`]: of the
//!   whole solution, one by one; adjoints; conditioning. [`Multipliers`]: whether a periodic solution is stable.
//!
//! Method, references, and a guide for those who come from SciPy or bvp4c: `docs/guide.md`. How well it does on 48
//! problems of the literature: `docs/testset.md`.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]
// Negated comparisons are meant: NaN must fail.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

mod accuracy;
mod basis;
mod budget;
pub mod bvp;
mod by_region;
mod cancel;
mod collocation;
mod condensation;
mod conditioning;
pub mod continuation;
pub mod dae;
mod derivatives;
pub mod error;
mod guess;
mod layers;
mod linear;
mod linearisation;
mod magnitude;
#[cfg(feature = "rayon")]
mod many;
mod measure;
pub mod mesh;
pub mod model;
mod multipliers;
mod newton;
mod observer;
mod options;
mod orientation;
mod phase;
pub mod problem;
mod progress;
mod refine;
mod rows;
mod run;
#[cfg(feature = "serde")]
mod serialised;
mod solution;
mod solve;
mod start;
mod stats;
mod tableau;

/// The guide's programs are compiled and run with the tests.
#[cfg(doctest)]
#[doc = include_str!("../docs/guide.md")]
struct Guide;

/// The README's program too.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub use accuracy::{Accuracy, Shortfall};
pub use cancel::Cancel;
pub use condensation::Condensation;
pub use conditioning::Conditioning;
pub use derivatives::{WrongDerivative, check_derivatives};
pub use error::{Component, GuessError, MeshBound, NewtonError, NonFinite, SolveError};
pub use guess::{Guess, RegionGuess};
pub use linearisation::{Functional, Linearisation, Tangent, TangentRegion};
#[cfg(feature = "rayon")]
pub use many::solve_many;
pub use multipliers::{Multiplier, Multipliers, Orbit};
pub use observer::{Event, Observer, Silent};
pub use options::{ComponentTolerance, Control, Options, Order, Which};
pub use orientation::{BranchCheck, Orientation};
pub use problem::{Constant, Layout, LayoutError, Points, Problem, Region, Scope, State};
pub use solution::{MeshRecord, RegionSolution, Solution};
pub use solve::{solve, solve_observed};
pub use stats::Stats;
