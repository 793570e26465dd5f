//! What most programs need, in a few calls.

use crate::case::{Case, CaseError, Key, Resolved};
use crate::clock::Stopwatch;
use crate::design::{self, ClampLimits, DesignError, Limit, LimitOptions, Optimum};
use crate::drive::{Failure, SolveOptions, TRAIL, solve_along};
use crate::result::{Outcome, interpret, run};
use crate::study::{self, Axis, GridPoint, Study, StudyError, Table};

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The case is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// There is no solution, or none was found.
    #[error(transparent)]
    Solve(#[from] Failure),
    /// There is no limit or optimum, or none was found.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// The study is wrong.
    #[error(transparent)]
    Study(#[from] StudyError),
}

impl Error {
    /// What to try, where there is more to say than the message says.
    pub fn hint(&self) -> Option<String> {
        match self {
            Self::Case(error) | Self::Study(StudyError::Case(error)) => error.hint(),
            Self::Solve(failure) => failure.hint().map(str::to_owned),
            Self::Design(_) | Self::Study(_) => None,
        }
    }
}

impl Case {
    /// The case with a key of the case file set as text with its unit:
    /// `with("operating_point.slack_tension", "120 N")`.
    ///
    /// # Errors
    /// As [`Case::set`].
    pub fn with(mut self, key: &str, value: &str) -> Result<Self, CaseError> {
        self.set(key, value)?;
        Ok(self)
    }

    /// The case with a key set in SI units: `with_si(Key::SlackTension, 120.0)`.
    ///
    /// # Errors
    /// As [`Case::set_si`].
    pub fn with_si(mut self, key: Key, value: f64) -> Result<Self, CaseError> {
        self.set_si(key, value)?;
        Ok(self)
    }

    /// The case, resolved and fit for the solver.
    fn posed(&self) -> Result<Resolved, CaseError> {
        let resolved = self.resolve()?;
        self.check_posed(&resolved)?;
        Ok(resolved)
    }
}

/// Solves a case from nothing, to a relative tolerance of 1e-6.
///
/// # Errors
/// [`Error::Case`], [`Error::Solve`].
pub fn solve(case: &Case) -> Result<Outcome, Error> {
    solve_with(case, &SolveOptions::default())
}

/// Solves a case from nothing; with [`SolveOptions::sensitivities`], the result has the derivatives of every output
/// with respect to everything given.
///
/// # Errors
/// [`Error::Case`], [`Error::Solve`].
pub fn solve_with(case: &Case, options: &SolveOptions) -> Result<Outcome, Error> {
    Ok(run(&case.posed()?, options)?)
}

/// The largest torque that the clamp of a case carries, and the drive there.
///
/// # Errors
/// [`Error::Case`], [`Error::Design`].
pub fn largest_torque(case: &Case, options: &LimitOptions) -> Result<Limit, Error> {
    Ok(design::largest_torque(&case.posed()?, options)?.0)
}

/// The smallest clamps that carry the torque of a case, and the drive there.
///
/// # Errors
/// [`Error::Case`], [`Error::Design`].
pub fn smallest_clamps(case: &Case, options: &LimitOptions) -> Result<ClampLimits, Error> {
    Ok(design::smallest_clamps(&case.posed()?, options)?.0)
}

/// The clamp of best overall efficiency for the torque of a case.
///
/// # Errors
/// [`Error::Case`], [`Error::Design`].
pub fn optimum(case: &Case, options: &SolveOptions) -> Result<Optimum, Error> {
    Ok(design::optimum(&case.posed()?, options)?)
}

/// A case over a grid of its keys, as a table: one row a point, on all cores with the feature `parallel`.
///
/// # Errors
/// [`Error::Study`]. A point without a solution has a row that says why.
pub fn sweep_table(case: Case, axes: impl IntoIterator<Item = Axis>, options: SolveOptions) -> Result<Table, Error> {
    Ok(study::table(&Study::new(case, axes, options)?, None)?)
}

/// A case over a grid of its keys, point by point, the last axis fastest; each point starts from the solutions before
/// it.
///
/// # Errors
/// [`Error::Study`]. A point without a solution is an item that says why.
pub fn sweep(case: Case, axes: impl IntoIterator<Item = Axis>, options: SolveOptions) -> Result<Sweep, Error> {
    Ok(Sweep { study: Study::new(case, axes, options)?, next: 0, trail: Vec::new() })
}

/// The points of a grid with their solutions, computed as they are asked for.
#[derive(Debug)]
pub struct Sweep {
    study: Study,
    next: usize,
    /// The last solutions, with their cases.
    trail: Vec<(Resolved, Outcome)>,
}

impl Sweep {
    fn solve(&mut self, point: &GridPoint) -> Result<Outcome, Error> {
        let (case, options) = (point.case.clone()?, self.study.options());
        let near: Vec<_> = self.trail.iter().filter(|(before, _)| before.model == case.model).collect();
        let near: Vec<_> = near.iter().map(|(_, outcome)| &outcome.solved).collect();
        let start = Stopwatch::start();
        let warm = if near.is_empty() { None } else { solve_along(&near, &case, options).ok() };
        let outcome = match warm {
            Some(solved) => interpret(&case, options, solved, start)?,
            None => run(&case, options)?,
        };
        if self.trail.len() == TRAIL {
            self.trail.remove(0);
        }
        self.trail.push((case, outcome.clone()));
        Ok(outcome)
    }
}

impl Iterator for Sweep {
    type Item = Result<(GridPoint, Result<Outcome, Error>), Error>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.next >= self.study.points() {
            return None;
        }
        let point = self.study.point(self.next);
        self.next += 1;
        Some(match point {
            Ok(point) => {
                let outcome = self.solve(&point);
                Ok((point, outcome))
            }
            Err(error) => Err(error.into()),
        })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.study.points().saturating_sub(self.next);
        (left, Some(left))
    }
}
