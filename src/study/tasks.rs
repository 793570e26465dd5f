//! Chains of points, in the order in which they are solved.
//!
//! The way from a tight belt to a looser one takes a third to a half less work than the way back, and so does one whose
//! steps begin small. So each chain begins at its tight end, or where that is the same, where its steps are smaller;
//! so do the heads of a group. Rows are in the order of the study whatever is solved first.

use super::error::StudyError;
use super::plan::{GridPoint, HEADS, Study};
use crate::drive::{SolveOptions, apart, tightness};
use std::ops::Range;

/// A chain of points to solve one from the other.
#[derive(Debug, Clone)]
pub(super) struct Task {
    /// The study whose points are solved.
    pub study: usize,
    chain: Range<usize>,
    /// Where the same points stand in other studies: their numbers, and the first point there.
    elsewhere: Vec<(usize, usize)>,
    /// Whether the chain begins at its last point.
    backward: bool,
    /// How many points are wanted, or have others behind them that are.
    needed: usize,
}

impl Task {
    /// Of one of some studies.
    fn new(studies: &[Study], study: usize, chain: Range<usize>) -> Self {
        let backward = studies.get(study).is_some_and(|study| begins_at_the_end(study, &chain));
        Self { study, needed: chain.len(), chain, elsewhere: Vec::new(), backward }
    }

    fn nth(&self, n: usize) -> usize {
        if self.backward { self.chain.end - 1 - n } else { self.chain.start + n }
    }

    /// The point that is solved first.
    pub fn head(&self) -> usize {
        self.nth(0)
    }

    /// The points to be solved, in that order.
    pub fn points(&self) -> impl ExactSizeIterator<Item = usize> {
        (0..self.needed).map(|n| self.nth(n))
    }

    /// In which studies one of the points stands, and where there.
    pub fn places(&self, point: usize) -> impl Iterator<Item = (usize, usize)> {
        let elsewhere = self.elsewhere.iter().map(move |(study, first)| (*study, first + (point - self.chain.start)));
        std::iter::once((self.study, point)).chain(elsewhere)
    }
}

/// The chains of a study, in groups, without what no point that is wanted depends on. A group is put into order as it
/// is asked for: that resolves some of its cases.
pub(super) fn wanted<'a>(
    study: &'a Study,
    wanted: &'a (impl Fn(usize) -> bool + Sync),
) -> impl Iterator<Item = Vec<Task>> + Send + 'a {
    let task = move |chain: Range<usize>| {
        let mut task = Task::new(std::slice::from_ref(study), 0, chain);
        task.needed = (0..task.needed).rev().find(|n| wanted(task.nth(*n))).map_or(0, |last| last + 1);
        task
    };
    let chains = study.chains();
    let groups = chains.chunks(HEADS).map(<[Range<usize>]>::to_vec).collect::<Vec<_>>();
    groups.into_iter().map(move |chains| {
        let mut group = chains.into_iter().map(task).collect();
        tightest_first(std::slice::from_ref(study), &mut group);
        let needed = group.iter().rposition(|task| task.needed > 0).map_or(0, |last| last + 1);
        group.truncate(needed);
        group
    })
}

/// The chains of all studies, those of the same cases and options together, in groups of one model.
///
/// # Errors
/// A case that contradicts itself.
pub(super) fn all(studies: &[Study]) -> Result<Vec<Vec<Task>>, StudyError> {
    let mut known: Vec<(SolveOptions, Vec<GridPoint>)> = Vec::new();
    let mut tasks: Vec<Task> = Vec::new();
    for (at, study) in studies.iter().enumerate() {
        for chain in study.chains() {
            let cases = chain.clone().map(|index| study.point(index)).collect::<Result<Vec<GridPoint>, _>>()?;
            let same = |(options, others): &(SolveOptions, Vec<GridPoint>)| {
                options == study.options()
                    && others.len() == cases.len()
                    && others.iter().zip(&cases).all(|(a, b)| matches!((&a.case, &b.case), (Ok(a), Ok(b)) if a == b))
            };
            match known.iter().position(same) {
                Some(place) => tasks.get_mut(place).into_iter().for_each(|task| task.elsewhere.push((at, chain.start))),
                None => {
                    tasks.push(Task::new(studies, at, chain));
                    known.push((*study.options(), cases));
                }
            }
        }
    }
    let head = |(options, points): &(SolveOptions, Vec<GridPoint>)| {
        let case = points.first().and_then(|point| point.case.as_ref().ok());
        (*options, case.map(|case| case.model))
    };
    let mut groups: Vec<Vec<Task>> = Vec::new();
    let mut last = None;
    for (task, chain) in tasks.into_iter().zip(&known) {
        let this = head(chain);
        match groups.last_mut() {
            Some(group) if last == Some(this) && group.len() < HEADS => group.push(task),
            _ => groups.push(vec![task]),
        }
        last = Some(this);
    }
    groups.iter_mut().for_each(|group| tightest_first(studies, group));
    Ok(groups)
}

/// Whether a chain is better begun at its last point. Where there is no drive at an end it begins at the first.
fn begins_at_the_end(study: &Study, chain: &Range<usize>) -> bool {
    if chain.len() < 2 {
        return false;
    }
    let ends = [chain.start, chain.start + 1, chain.end - 2, chain.end - 1];
    let case = |index: usize| study.point(index).ok()?.case.ok();
    let [Some(first), Some(second), Some(before), Some(last)] = ends.map(case) else { return false };
    let (from, to) = (tightness(&first), tightness(&last));
    if from == to { apart(&before, &last) < apart(&first, &second) } else { to > from }
}

/// Puts the chains of a group into the order in which their heads are solved. What there is no drive for comes last.
fn tightest_first(studies: &[Study], group: &mut Vec<Task>) {
    let tight = |task: &Task| {
        let point = studies.get(task.study)?.point(task.head()).ok()?;
        point.case.as_ref().map(tightness).ok()
    };
    let known = group.drain(..).map(|task| (tight(&task).unwrap_or(f64::NEG_INFINITY), task));
    let mut known: Vec<(f64, Task)> = known.collect();
    known.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    group.extend(known.into_iter().map(|(_, task)| task));
}
