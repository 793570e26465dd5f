//! Solving the points of a study, on several threads.

use super::error::StudyError;
use super::plan::{Point, Study};
use super::row::{Row, Table, TableBuilder};
use crate::case::Resolved;
use crate::drive::{Failure, SolveOptions, solve_from};
use crate::result::{self, Outcome};
use rayon::prelude::*;
use std::io;
use std::ops::Range;
use std::sync::Mutex;
use std::time::Instant;

/// Solves all points of which `wanted` says so, on `jobs` threads (all cores if none are given), and hands each row to
/// `keep` as soon as it is there: in any order, from any thread. A chain with a wanted point is solved from its start
/// up to its last wanted point, so that rows are the same whoever asks.
///
/// # Errors
/// [`StudyError::Keep`] ends the run; [`StudyError::Threads`]. A point without a solution has a row that says why.
pub fn run(
    study: &Study,
    jobs: Option<usize>,
    wanted: impl Fn(usize) -> bool + Sync,
    keep: impl Fn(Row) -> io::Result<()> + Sync,
) -> Result<(), StudyError> {
    each(study, jobs, &wanted, &|index, point, outcome| keep(Row::new(index, point, outcome)))
}

/// Solves all points and makes a table of them.
///
/// # Errors
/// [`StudyError::Threads`].
pub fn table(study: &Study, jobs: Option<usize>) -> Result<Table, StudyError> {
    let rows = Mutex::new(TableBuilder::new(study.points()));
    run(
        study,
        jobs,
        |_| true,
        |row| {
            rows.lock().unwrap_or_else(std::sync::PoisonError::into_inner).insert(row);
            Ok(())
        },
    )?;
    Ok(rows.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).finish())
}

/// Solves all points; `read` takes from each outcome what is of interest, `None` standing for a point without one.
///
/// # Errors
/// [`StudyError::Threads`].
pub fn outcomes<T: Send>(
    study: &Study,
    jobs: Option<usize>,
    read: impl Fn(&Point, Result<&Outcome, String>) -> T + Sync,
) -> Result<Vec<T>, StudyError> {
    let taken: Mutex<Vec<(usize, T)>> = Mutex::new(Vec::with_capacity(study.points()));
    each(study, jobs, &|_| true, &|index, point, outcome| {
        let value = read(point, outcome);
        taken.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push((index, value));
        Ok(())
    })?;
    let mut taken = taken.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    taken.sort_by_key(|(index, _)| *index);
    Ok(taken.into_iter().map(|(_, value)| value).collect())
}

/// What is done with a point: its place, itself, what it gave.
type Take<'a> = dyn Fn(usize, &Point, Result<&Outcome, String>) -> io::Result<()> + Sync + 'a;

fn each(
    study: &Study,
    jobs: Option<usize>,
    wanted: &(dyn Fn(usize) -> bool + Sync),
    take: &Take<'_>,
) -> Result<(), StudyError> {
    let threads = jobs.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|_| StudyError::Threads(threads))?;
    let chains: Vec<Range<usize>> = study
        .chains()
        .into_iter()
        .filter_map(|chain| {
            let last = chain.clone().rev().find(|index| wanted(*index))?;
            Some(chain.start..last + 1)
        })
        .collect();
    pool.install(|| chains.into_par_iter().with_max_len(1).try_for_each(|chain| along(study, chain, wanted, take)))
}

/// Solves a chain, each point from the last solution before it if that can be.
fn along(
    study: &Study,
    chain: Range<usize>,
    wanted: &(dyn Fn(usize) -> bool + Sync),
    take: &Take<'_>,
) -> Result<(), StudyError> {
    let mut last: Option<(Resolved, Outcome)> = None;
    // Once a neighbour is too far away, the others of the chain are as well.
    let mut near_enough = true;
    for index in chain {
        let point = study.point(index)?;
        let solved = match &point.case {
            Ok(case) => {
                let near = last.as_ref().filter(|(before, _)| near_enough && before.model == case.model);
                solve(case, study.options(), near.map(|(_, outcome)| outcome), &mut near_enough)
                    .map(|outcome| (case.clone(), outcome))
                    .map_err(|failure| failure.to_string())
            }
            Err(error) => Err(error.to_string()),
        };
        if wanted(index) {
            take(index, &point, solved.as_ref().map(|(_, outcome)| outcome).map_err(Clone::clone))?;
        }
        last = solved.ok().or(last);
    }
    Ok(())
}

/// From the solution nearby, else from nothing; says if that was not near enough.
fn solve(
    case: &Resolved,
    options: &SolveOptions,
    near: Option<&Outcome>,
    near_enough: &mut bool,
) -> Result<Outcome, Failure> {
    let start = Instant::now();
    match near.map(|near| solve_from(&near.solved, case, options)) {
        Some(Ok(solved)) => return result::interpret(case, options, solved, start),
        Some(Err(_)) => *near_enough = false,
        None => {}
    }
    result::run(case, options)
}
