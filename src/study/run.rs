//! Solving the points of studies, on several threads.

use super::error::StudyError;
use super::plan::{GridPoint, Study};
use super::row::{Row, Table, TableBuilder};
use super::tasks::{self, Task};
use crate::cancel::is_cancelled;
use crate::case::Resolved;
use crate::clock::Stopwatch;
use crate::drive::{Failure, SolveOptions, Solved, TRAIL, remoteness, solve_along};
use crate::result::{self, Outcome};
use crate::threads::{self, Scope};
use std::io;
use std::sync::{Mutex, PoisonError};

/// Heads that are more [remote](remoteness) are not solved one from the other.
const FARTHEST: f64 = 1.8;
/// Points in a row whose neighbours were too far away, after which the others of the chain are solved from nothing.
const PATIENCE: usize = 2;

/// Solves all points of which `wanted` says so, on `jobs` threads (all cores if none are given, and no more than that),
/// and hands each row to `keep` as soon as it is there: in any order, from any thread. What a point is solved from
/// depends on the study alone, so that rows are the same whoever asks.
///
/// # Errors
/// [`StudyError::Keep`] ends the run; [`StudyError::Threads`]. A point without a solution has a row that says why.
pub fn run(
    study: &Study,
    jobs: Option<usize>,
    wanted: impl Fn(usize) -> bool + Sync,
    keep: impl Fn(Row) -> io::Result<()> + Sync,
) -> Result<(), StudyError> {
    visit(study, jobs, wanted, |index, point, outcome| keep(Row::new(index, point, outcome)))
}

/// As [`run`], and hands over each point's number, the point and its solution, or why there is none, in place of a row.
///
/// # Errors
/// As [`run`].
pub fn visit(
    study: &Study,
    jobs: Option<usize>,
    wanted: impl Fn(usize) -> bool + Sync,
    see: impl Fn(usize, &GridPoint, Result<&Outcome, String>) -> io::Result<()> + Sync,
) -> Result<(), StudyError> {
    let groups = tasks::wanted(study, &wanted);
    let take = |_: &Task, index: usize, point: &GridPoint, outcome: Found<'_>| {
        if wanted(index) { see(index, point, outcome) } else { Ok(()) }
    };
    let chains = study.chains().len();
    Work { studies: std::slice::from_ref(study), take: &take, failed: Mutex::default() }.run(groups, chains, jobs)
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
    see: impl Fn(usize, usize, &GridPoint, Result<&Outcome, String>) + Sync,
) -> Result<(Vec<Table>, usize), StudyError> {
    let groups = tasks::all(studies)?;
    let points = groups.iter().flatten().map(|task| task.points().len()).sum();
    let rows: Vec<Mutex<TableBuilder>> =
        studies.iter().map(|study| Mutex::new(TableBuilder::new(study.points()))).collect();
    let take = |task: &Task, index: usize, _: &GridPoint, outcome: Found<'_>| {
        for (at, place) in task.places(index) {
            let (Some(study), Some(rows)) = (studies.get(at), rows.get(at)) else { continue };
            let Ok(point) = study.point(place) else { continue };
            see(at, place, &point, outcome.clone());
            let row = Row::new(place, &point, outcome.clone());
            rows.lock().unwrap_or_else(PoisonError::into_inner).insert(row);
        }
        Ok(())
    };
    let chains = groups.iter().map(Vec::len).sum();
    Work { studies, take: &take, failed: Mutex::default() }.run(groups.into_iter(), chains, jobs)?;
    let table = |rows: Mutex<TableBuilder>| rows.into_inner().unwrap_or_else(PoisonError::into_inner).finish();
    Ok((rows.into_iter().map(table).collect(), points))
}

/// Threads that are of use: as many as are asked for, but no more than there are cores and chains to solve.
fn useful_threads(jobs: Option<usize>, chains: usize) -> usize {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let most = cores.min(chains).max(1);
    jobs.unwrap_or(most).clamp(1, most)
}

/// What a point gave: a result, or why there is none.
type Found<'a> = Result<&'a Outcome, String>;

/// What is done with a point: its task, its number, itself, what it gave.
type Take<'a> = dyn Fn(&Task, usize, &GridPoint, Found<'_>) -> io::Result<()> + Sync + 'a;

/// A solved case.
type Known = (Resolved, Outcome);

/// What the threads share.
struct Work<'a> {
    studies: &'a [Study],
    take: &'a Take<'a>,
    /// Why everything was given up.
    failed: Mutex<Option<StudyError>>,
}

impl Work<'_> {
    /// Solves so many chains, in groups.
    fn run(
        self,
        groups: impl Iterator<Item = Vec<Task>> + Send,
        chains: usize,
        jobs: Option<usize>,
    ) -> Result<(), StudyError> {
        let threads = useful_threads(jobs, chains);
        let work = &self;
        let waiting = &Mutex::new(groups);
        // First come, first served: rows are wanted in the order of the points. A group begins when the chains of one
        // before it have begun, so that the first rows are there, and kept, long before the last heads.
        threads::scope(threads, |scope| {
            for _ in 0..threads {
                scope.spawn_fifo(move |scope| work.group(scope, waiting));
            }
        })
        .map_err(|_| StudyError::Threads(threads))?;
        self.failed.into_inner().unwrap_or_else(PoisonError::into_inner).map_or(Ok(()), Err)
    }

    /// Has the next group solved that waits, and then the one after it.
    fn group<'s>(&'s self, scope: &Scope<'s>, waiting: &'s Mutex<impl Iterator<Item = Vec<Task>> + Send>) {
        let next = waiting.lock().unwrap_or_else(PoisonError::into_inner).next();
        let Some(group) = next else { return };
        self.heads(scope, group);
        scope.spawn_fifo(move |scope| self.group(scope, waiting));
    }

    /// Solves the heads of a group, and has the rest of each chain solved as soon as its head is known.
    fn heads<'s>(&'s self, scope: &Scope<'s>, group: Vec<Task>) {
        let mut heads: Vec<Known> = Vec::new();
        for task in group {
            let Some(study) = self.studies.get(task.study) else { continue };
            let begun = self.checked(|| {
                let point = study.point(task.head())?;
                let head = attempt(&point, |case| head(case, study.options(), &heads));
                uncancelled()?;
                Ok((point, head))
            });
            let Some((point, head)) = begun else { return };
            heads.extend(head.as_ref().ok().cloned());
            if task.points().len() > 0 {
                scope.spawn_fifo(move |_| {
                    self.checked(|| self.along(study, &task, &point, head));
                });
            }
        }
    }

    /// Solves a chain behind its head, each point from the last solutions before it if that can be.
    fn along(
        &self,
        study: &Study,
        task: &Task,
        first: &GridPoint,
        head: Result<Known, String>,
    ) -> Result<(), StudyError> {
        (self.take)(task, task.head(), first, found(&head))?;
        let mut trail: Vec<Known> = head.into_iter().collect();
        let mut too_far = 0;
        for index in task.points().skip(1) {
            if self.failed.lock().unwrap_or_else(PoisonError::into_inner).is_some() {
                return Ok(());
            }
            let point = study.point(index)?;
            let solved = attempt(&point, |case| {
                let near = trail.iter().filter(|(before, _)| too_far < PATIENCE && before.model == case.model);
                let near: Vec<&Solved> = near.map(|(_, outcome)| &outcome.solved).collect();
                solve(case, study.options(), &near, &mut too_far)
            });
            uncancelled()?;
            (self.take)(task, index, &point, found(&solved))?;
            if let Ok(solved) = solved {
                if trail.len() == TRAIL {
                    trail.remove(0);
                }
                trail.push(solved);
            }
        }
        Ok(())
    }

    /// What `part` gives, unless everything is given up, or is from here on.
    fn checked<T>(&self, part: impl FnOnce() -> Result<T, StudyError>) -> Option<T> {
        if self.failed.lock().unwrap_or_else(PoisonError::into_inner).is_some() {
            return None;
        }
        match part() {
            Ok(value) => Some(value),
            Err(error) => {
                self.failed.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                None
            }
        }
    }
}

/// # Errors
/// [`StudyError::Cancelled`]: what was being solved then says nothing of its point.
fn uncancelled() -> Result<(), StudyError> {
    if is_cancelled() { Err(StudyError::Cancelled) } else { Ok(()) }
}

fn found(solved: &Result<Known, String>) -> Found<'_> {
    solved.as_ref().map(|(_, outcome)| outcome).map_err(Clone::clone)
}

/// The point's case solved, or why there is no solution.
fn attempt(point: &GridPoint, solve: impl FnOnce(&Resolved) -> Result<Outcome, Failure>) -> Result<Known, String> {
    let case = point.case.as_ref().map_err(ToString::to_string)?;
    solve(case).map(|outcome| (case.clone(), outcome)).map_err(|failure| failure.to_string())
}

/// Solves the head of a chain from the nearest of the heads before it, if that is near enough.
fn head(case: &Resolved, options: &SolveOptions, heads: &[Known]) -> Result<Outcome, Failure> {
    let near = heads
        .iter()
        .filter(|(before, _)| before.model == case.model)
        .map(|(_, outcome)| (remoteness(&outcome.solved, case), &outcome.solved))
        .filter(|(remoteness, _)| *remoteness <= FARTHEST)
        .min_by(|(a, _), (b, _)| a.total_cmp(b));
    let near: Vec<&Solved> = near.into_iter().map(|(_, solved)| solved).collect();
    solve(case, options, &near, &mut 0)
}

/// From the solutions nearby, else from nothing; counts how often in a row they were too far away.
fn solve(case: &Resolved, options: &SolveOptions, near: &[&Solved], too_far: &mut usize) -> Result<Outcome, Failure> {
    let start = Stopwatch::start();
    // A clamp that is found for a margin takes several solutions, each from the one before it.
    let near = if case.operating_point.margin.is_some() { &[] } else { near };
    if !near.is_empty() {
        match solve_along(near, case, options) {
            Ok(solved) => {
                *too_far = 0;
                return result::interpret(case, options, solved, start);
            }
            Err(Failure::Cancelled) => return Err(Failure::Cancelled),
            Err(_) => *too_far += 1,
        }
    }
    result::run(case, options)
}
