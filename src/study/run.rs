//! Solving the points of a study, on several threads.

use super::error::StudyError;
use super::plan::{Point, Study};
use super::row::{Row, Table, TableBuilder};
use crate::case::Resolved;
use crate::drive::{Failure, SolveOptions, Solved, solve_from};
use crate::result::{self, Outcome};
use rayon::prelude::*;
use std::io;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Solutions that tell where a chain goes.
const TRAIL: usize = 2;

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
    let chains = study.chains().into_iter().filter_map(|chain| {
        let last = chain.clone().rev().find(|index| wanted(*index))?;
        Some(chain.start..last + 1)
    });
    let chains: Vec<Range<usize>> = chains.collect();
    let take = |index: usize, point: &Point, outcome: Solution<'_>| {
        if wanted(index) { keep(Row::new(index, point, outcome)) } else { Ok(()) }
    };
    let solve = || chains.into_par_iter().with_max_len(1).try_for_each(|chain| along(study, chain, &take));
    pool(jobs)?.install(solve)
}

/// Solves all points and makes a table of them.
///
/// # Errors
/// [`StudyError::Threads`].
pub fn table(study: &Study, jobs: Option<usize>) -> Result<Table, StudyError> {
    Ok(tables(std::slice::from_ref(study), jobs)?.0.pop().unwrap_or_default())
}

/// Solves several studies at once and makes a table of each; says also how many points were solved: a chain of the same
/// cases that two studies have in common is solved once.
///
/// # Errors
/// [`StudyError::Threads`].
pub fn tables(studies: &[Study], jobs: Option<usize>) -> Result<(Vec<Table>, usize), StudyError> {
    each(studies, jobs, |_, _, _, _| ())
}

/// As [`tables`], and shows every point to `see`, with the number of its study, in any order, from any thread.
///
/// # Errors
/// [`StudyError::Threads`].
pub fn each(
    studies: &[Study],
    jobs: Option<usize>,
    see: impl Fn(usize, usize, &Point, Result<&Outcome, String>) + Sync,
) -> Result<(Vec<Table>, usize), StudyError> {
    let shared = shared(studies)?;
    let rows: Vec<Mutex<TableBuilder>> =
        studies.iter().map(|study| Mutex::new(TableBuilder::new(study.points()))).collect();
    let points = shared.iter().flat_map(|places| places.first()).map(|(_, chain)| chain.len()).sum();
    let solve = |places: Vec<Place>| {
        let Some((first, chain)) = places.first().cloned() else { return Ok(()) };
        let Some(study) = studies.get(first) else { return Ok(()) };
        let take = |index: usize, _: &Point, outcome: Solution<'_>| {
            for (at, range) in &places {
                let place = range.start + (index - chain.start);
                let (Some(study), Some(rows)) = (studies.get(*at), rows.get(*at)) else { continue };
                let Ok(point) = study.point(place) else { continue };
                see(*at, place, &point, outcome.clone());
                let row = Row::new(place, &point, outcome.clone());
                rows.lock().unwrap_or_else(PoisonError::into_inner).insert(row);
            }
            Ok(())
        };
        along(study, chain.clone(), &take)
    };
    pool(jobs)?.install(|| shared.into_par_iter().with_max_len(1).try_for_each(solve))?;
    let table = |rows: Mutex<TableBuilder>| rows.into_inner().unwrap_or_else(PoisonError::into_inner).finish();
    Ok((rows.into_iter().map(table).collect(), points))
}

/// A chain: the number of its study, and its points.
type Place = (usize, Range<usize>);

/// The chains of all studies, those of the same cases and options together: each by its study and its points.
fn shared(studies: &[Study]) -> Result<Vec<Vec<Place>>, StudyError> {
    let mut known: Vec<(SolveOptions, Vec<Point>)> = Vec::new();
    let mut shared: Vec<Vec<Place>> = Vec::new();
    for (at, study) in studies.iter().enumerate() {
        for chain in study.chains() {
            let cases = chain.clone().map(|index| study.point(index)).collect::<Result<Vec<Point>, _>>()?;
            let same = |(options, others): &(SolveOptions, Vec<Point>)| {
                options == study.options()
                    && others.len() == cases.len()
                    && others.iter().zip(&cases).all(|(a, b)| matches!((&a.case, &b.case), (Ok(a), Ok(b)) if a == b))
            };
            match known.iter().position(same) {
                Some(place) => shared.get_mut(place).into_iter().for_each(|places| places.push((at, chain.clone()))),
                None => {
                    known.push((*study.options(), cases));
                    shared.push(vec![(at, chain)]);
                }
            }
        }
    }
    Ok(shared)
}

fn pool(jobs: Option<usize>) -> Result<rayon::ThreadPool, StudyError> {
    let threads = jobs.unwrap_or(0);
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|_| StudyError::Threads(threads))
}

/// What a point gave: a result, or why there is none.
type Solution<'a> = Result<&'a Outcome, String>;

/// What is done with a point: its place, itself, what it gave.
type Take<'a> = dyn Fn(usize, &Point, Solution<'_>) -> io::Result<()> + Sync + 'a;

/// Solves a chain, each point from the last solution before it if that can be.
fn along(study: &Study, chain: Range<usize>, take: &Take<'_>) -> Result<(), StudyError> {
    let mut trail: Vec<(Resolved, Outcome)> = Vec::new();
    // Once a neighbour is too far away, the others of the chain are as well.
    let mut near_enough = true;
    for index in chain {
        let point = study.point(index)?;
        let solved = match &point.case {
            Ok(case) => {
                let near = trail.iter().filter(|(before, _)| near_enough && before.model == case.model);
                let near: Vec<&Solved> = near.map(|(_, outcome)| &outcome.solved).collect();
                solve(case, study.options(), &near, &mut near_enough)
                    .map(|outcome| (case.clone(), outcome))
                    .map_err(|failure| failure.to_string())
            }
            Err(error) => Err(error.to_string()),
        };
        take(index, &point, solved.as_ref().map(|(_, outcome)| outcome).map_err(Clone::clone))?;
        if let Ok(solved) = solved {
            if trail.len() == TRAIL {
                trail.remove(0);
            }
            trail.push(solved);
        }
    }
    Ok(())
}

/// From the solution nearby, else from nothing; says if that was not near enough.
fn solve(
    case: &Resolved,
    options: &SolveOptions,
    near: &[&Solved],
    near_enough: &mut bool,
) -> Result<Outcome, Failure> {
    let start = Instant::now();
    if !near.is_empty() {
        match solve_from(near, case, options) {
            Ok(solved) => return result::interpret(case, options, solved, start),
            Err(_) => *near_enough = false,
        }
    }
    result::run(case, options)
}
