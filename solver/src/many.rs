//! Many problems solved side by side, by rayon.

use crate::error::SolveError;
use crate::guess::Guess;
use crate::options::Options;
use crate::problem::Problem;
use crate::solution::Solution;
use crate::solve::solve;
use rayon::prelude::*;

/// Solves several tasks in parallel: each a problem and the guess to start from, which also has the values of the
/// constants that are given. So one problem may be solved from several guesses or at several values of its constants,
/// and, by `&(dyn Problem + Sync)`, several problems at once.
///
/// The answers stand in the order of the tasks, and each has the same bits as [`solve`] would give. `unknowns` and
/// `options` are those of every task; the work limit bounds each task on its own, and what cancels
/// [`Options::cancel`] ends all: tasks that have not ended by then answer [`SolveError::Cancelled`]. The threads are
/// those of the rayon pool this is called in.
///
/// Tasks do not help each other. Where the next parameter value is better solved from the last one's solution, that is
/// [`continuation`](crate::continuation), one after the other.
///
/// ```
/// use solver::bvp::Bvp;
/// use solver::{Guess, Options, solve_many};
///
/// // Bratu's problem for several λ.
/// let bratu = Bvp::new(
///     &["u", "slope"],
///     (0.0, 1.0),
///     |_x, y, p, f| (f[0], f[1]) = (y[1], -p[0] * y[0].exp()),
///     |a, b, _p, g| (g[0], g[1]) = (a[0], b[0]),
/// )
/// .given("lambda", 1.0);
/// let guesses = [0.5, 1.0, 2.0].map(|lambda| Guess { constants: vec![lambda], ..bratu.start() });
/// let tasks: Vec<_> = guesses.iter().map(|guess| (&bratu, guess)).collect();
/// for solution in solve_many(&tasks, &[], &Options::default()) {
///     println!("{}", solution?.regions()[0].eval(0.5)[0]);
/// }
/// # Ok::<(), solver::SolveError>(())
/// ```
pub fn solve_many<P: Problem + Sync + ?Sized>(
    tasks: &[(&P, &Guess)],
    unknowns: &[usize],
    options: &Options,
) -> Vec<Result<Solution, SolveError>> {
    tasks.par_iter().map(|(problem, guess)| solve(*problem, guess, unknowns, options)).collect()
}
