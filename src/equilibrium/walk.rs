//! A shift curve as it is computed: one point after the other, whenever the next is wanted.

use std::ops::ControlFlow;

use super::curve::{ShiftBranch, ShiftOptions, ShiftPoint, engagement_speed};
use super::ends::{Corners, Search};
use super::error::EquilibriumError;
use super::heat::{equilibrium_outcome, outcome_at_speed};
use super::phase::Direction;
use super::point::Equilibrium;
use super::question::has_all_parts;
use super::remarks::over_curve;
use super::report::DriveReport;
use super::search::SLOWEST;
use crate::case::Resolved;
use crate::threads;

/// The shift curve in one direction; `see` is shown each point as it is found, and may end the search, which keeps what
/// there is.
///
/// # Errors
/// A case that lacks a part, or that the search is cancelled: points without an equilibrium are told as such, and the
/// curve goes on.
pub fn shift_branch(
    case: &Resolved,
    direction: Direction,
    options: &ShiftOptions,
    see: &mut dyn FnMut(&ShiftPoint) -> ControlFlow<()>,
) -> Result<ShiftBranch, EquilibriumError> {
    let mut walk = ShiftWalk::begin(case, direction, options)?;
    while let Some(point) = walk.step()? {
        if see(point).is_break() {
            walk.end();
        }
    }
    Ok(walk.into_branch())
}

/// The shift curves of several cases, each in all directions of the options, side by side on all cores; `see` is shown
/// each point as it is found, with the number of its case, and may end the search in that direction, which keeps what
/// there is. The threads end their work when the calling thread's is [cancelled](crate::cancellable).
///
/// # Errors
/// As [`shift_branch`]; of several, those of the first case and direction.
pub fn shift_branches(
    cases: &[&Resolved],
    options: &ShiftOptions,
    see: &(dyn Fn(usize, &ShiftPoint) -> ControlFlow<()> + Sync),
) -> Result<Vec<Vec<ShiftBranch>>, EquilibriumError> {
    let of_case = |(at, case)| options.directions.iter().map(move |direction| (at, case, *direction));
    let jobs: Vec<(usize, &Resolved, Direction)> = cases.iter().copied().enumerate().flat_map(of_case).collect();
    let found = threads::collect(&jobs, |&(at, case, direction)| {
        shift_branch(case, direction, options, &mut |point| see(at, point))
    });
    let mut found = found.into_iter();
    cases.iter().map(|_| found.by_ref().take(options.directions.len()).collect()).collect()
}

/// The shift curve in one direction while it is computed.
#[derive(Debug, Clone)]
pub struct ShiftWalk {
    case: Resolved,
    options: ShiftOptions,
    branch: ShiftBranch,
    corners: Corners,
    /// Speeds of the secondary of all points, rad/s.
    speeds: Vec<f64>,
    ended: bool,
    /// The last equilibrium of a point.
    last: Option<Equilibrium>,
    /// Whether the equilibrium of each point is kept, and these.
    keeps: bool,
    found: Vec<Option<Equilibrium>>,
    /// Those of the curve of a drive nearby.
    beside: Vec<Option<Equilibrium>>,
}

impl ShiftWalk {
    /// Finds the ends of the curve's phases; its points are not yet computed.
    ///
    /// # Errors
    /// A case that lacks a part, or that the search is cancelled.
    pub fn begin(case: &Resolved, direction: Direction, options: &ShiftOptions) -> Result<Self, EquilibriumError> {
        Self::begun(case, direction, options, None)
    }

    /// The same, keeping the equilibrium of every point for [`ShiftWalk::begin_near`].
    #[must_use]
    pub fn keeping(mut self) -> Self {
        self.keeps = true;
        self
    }

    /// As [`ShiftWalk::begin`], from the curve of a drive nearby that keeps its equilibria, as this one does then: each
    /// point is sought from the one in its place there. Where the ends of the phases are not found from those, they are
    /// from nothing.
    ///
    /// # Errors
    /// As [`ShiftWalk::begin`].
    pub fn begin_near(&self, case: &Resolved, options: &ShiftOptions) -> Result<Self, EquilibriumError> {
        if self.case.model != case.model {
            return Self::begin(case, self.branch.direction, options).map(Self::keeping);
        }
        let begun = Self::begun(case, self.branch.direction, options, Some(self))?;
        if begun.branch.remarks.len() > self.branch.remarks.len() {
            return Self::begin(case, self.branch.direction, options).map(Self::keeping);
        }
        Ok(begun)
    }

    fn begun(
        case: &Resolved,
        direction: Direction,
        options: &ShiftOptions,
        near: Option<&Self>,
    ) -> Result<Self, EquilibriumError> {
        has_all_parts(case)?;
        let mut branch = ShiftBranch {
            direction,
            engagement: engagement_speed(case, direction)?,
            take_off: None,
            shift_out: None,
            full_shift: None,
            points: Vec::new(),
            remarks: Vec::new(),
        };
        let mut search = Search { case, direction, options, branch: &mut branch };
        let corners = search.corners(near.map(|near| &near.corners))?;
        let speeds = search.speeds(&corners);
        // What is found in another place of the curve is farther away than the point before.
        let beside = near.filter(|near| near.speeds.len() == speeds.len()).map(|near| near.found.clone());
        Ok(Self {
            case: case.clone(),
            options: options.clone(),
            branch,
            corners,
            speeds,
            ended: false,
            last: None,
            keeps: near.is_some(),
            found: Vec::new(),
            beside: beside.unwrap_or_default(),
        })
    }

    /// The next point, which may have no equilibrium; nothing behind the last.
    ///
    /// # Errors
    /// What is wrong with the case, or that the search is cancelled: the points before keep.
    pub fn step(&mut self) -> Result<Option<&ShiftPoint>, EquilibriumError> {
        let at = self.branch.points.len();
        let Some(speed) = self.speeds.get(at).copied().filter(|_| !self.ended) else { return Ok(None) };
        let before = self.last.clone().or_else(|| self.corners.begin());
        let near = self.beside.get(at).cloned().flatten().or(before);
        let direction = self.branch.direction;
        let solve = &self.options.solve;
        let found = if near.is_none() && self.was_slower_tried(at, speed) {
            outcome_at_speed(&self.case, speed, direction, solve)
        } else {
            equilibrium_outcome(near.as_ref(), &self.case, speed, direction, solve)
        };
        let (report, found) = match found {
            Ok((found, outcome)) => {
                let report = DriveReport::new(&self.case, &found, outcome, false);
                let report = report.map(|report| Box::new(self.branch.in_phases(report)));
                (report.map_err(|error| error.to_string()), Some(found))
            }
            Err(error) if error.is_bad_input() || error.is_cancelled() => return Err(error),
            Err(error) => (Err(error.to_string()), None),
        };
        if self.keeps {
            self.found.push(found.clone());
        }
        self.last = found.or(self.last.take());
        self.branch.points.push(ShiftPoint { direction, secondary_speed: speed, report });
        Ok(self.branch.points.last())
    }

    /// Whether an equilibrium was sought at a speed before that of the point `at`, and no farther below it than where
    /// one would be sought for this point.
    fn was_slower_tried(&self, at: usize, speed: f64) -> bool {
        let before = at.checked_sub(1).and_then(|before| self.speeds.get(before));
        before.is_some_and(|before| *before >= SLOWEST * speed)
    }

    /// Ends the curve before its last point; what there is stays.
    pub fn end(&mut self) {
        if self.remaining() > 0 {
            self.branch.remarks.push("the search was ended before its last point".to_owned());
        }
        self.ended = true;
    }

    /// What there is to say of the points so far together: see [`over_curve`].
    pub fn remarks(&self) -> Vec<String> {
        let reports = self.branch.points.iter().filter_map(|point| point.report.as_deref().ok());
        over_curve(&self.case, reports)
    }

    /// How many points are still to be computed.
    pub fn remaining(&self) -> usize {
        if self.ended { 0 } else { self.speeds.len() - self.branch.points.len() }
    }

    /// What is known so far.
    pub fn branch(&self) -> &ShiftBranch {
        &self.branch
    }

    /// The same, when no more points are wanted.
    pub fn into_branch(self) -> ShiftBranch {
        self.branch
    }
}
