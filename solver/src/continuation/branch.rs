//! A branch of solutions in one constant: what its points are, and how it is traced.

use super::arclength::Direction;
use crate::error::SolveError;
use crate::options::{Options, at_least_one, positive};
use crate::orientation::BranchCheck;
use crate::solution::Solution;
use crate::stats::Stats;
use thiserror::Error;

/// How a branch is traced.
#[derive(Debug, Clone, PartialEq)]
pub struct BranchOptions {
    /// For every point of the branch.
    pub solve: Options,
    /// The branch is followed while the parameter is in this range. Where it leaves it, the last point is at exactly
    /// the end of the range; the equations need not be defined beyond.
    pub range: (f64, f64),
    /// Whether the parameter grows at first.
    pub upwards: bool,
    /// First step, in arclength: about the relative change of solution and parameter.
    pub first_step: f64,
    /// Smallest step: one that fails at this length ends the tracing.
    pub smallest_step: f64,
    /// Largest step.
    pub largest_step: f64,
    /// The first contraction of Newton's iteration that steps aim at.
    pub contraction: f64,
    /// A step whose first contraction is larger is halved, twice at most in a row, as is one on whose meshes the sign
    /// of the determinant changes: it may lead to another part of the branch, or to another branch. Infinite where
    /// kinks of the right-hand side leave both without a meaning: no step is halved for them then.
    pub largest_contraction: f64,
    /// Newton iterations on each mesh of a step.
    pub max_iterations: usize,
    /// Points, located ones included.
    pub max_points: usize,
    /// What else ends the tracing: the first point of one of these kinds is its last. To go on from there, trace from
    /// its solution; across a fold, from a checkpoint or a point beside it. Default: nothing.
    pub stop_at: Vec<PointKind>,
    /// Whether branch points, where another branch crosses, are looked for and located. Simple ones are seen by the
    /// orientation of the problem that arclength extends, which changes there; those of even multiplicity, where it
    /// does not, by the determinant whose sign it is: see
    /// [`resolve_branch_points`](Self::resolve_branch_points).
    pub branch_points: bool,
    /// Whether steps are made so short that the determinant whose sign is the orientation is known between their ends:
    /// two branch points within one step leave its sign as it was, and are seen as none, as is one where several
    /// branches leave and the determinant touches zero. It takes shorter steps, and looks into their middle, where the
    /// determinant is not what it was expected to be, and nothing where it grows or decays steadily. Without,
    /// `largest_step` must be short enough to part the branch points. Not done where `largest_contraction` is infinite,
    /// for kinks make the determinant jump. Default: yes.
    pub resolve_branch_points: bool,
    /// Whether each branch point is located anew on meshes of halved intervals, six times over at most, until its
    /// parameter has settled to the tolerance: what bifurcates may ask for a finer mesh than the branch does. Without,
    /// it is the branch point of the mesh on which it is met. Default: yes.
    pub settle_branch_points: bool,
}

impl Default for BranchOptions {
    fn default() -> Self {
        Self {
            solve: Options::default(),
            range: (f64::NEG_INFINITY, f64::INFINITY),
            upwards: true,
            first_step: 0.05,
            smallest_step: 1e-6,
            largest_step: 0.5,
            contraction: 0.1,
            largest_contraction: 1.0,
            max_iterations: 12,
            max_points: 200,
            stop_at: Vec::new(),
            branch_points: true,
            resolve_branch_points: true,
            settle_branch_points: true,
        }
    }
}

impl BranchOptions {
    pub(super) fn check(&self, start: f64, events: usize) -> Result<(), SolveError> {
        let unknown = |kind: &PointKind| match kind {
            PointKind::Event(index) if *index >= events => Some(*index),
            _ => None,
        };
        if let Some(index) = self.stop_at.iter().find_map(unknown) {
            let expected = "the index of an event that is given";
            return Err(SolveError::Option { name: "stop_at", value: index as f64, expected });
        }
        positive([
            ("first_step", self.first_step),
            ("smallest_step", self.smallest_step),
            ("largest_step", self.largest_step),
            ("contraction", self.contraction),
        ])?;
        if !(self.largest_contraction > 0.0) {
            let (name, value) = ("largest_contraction", self.largest_contraction);
            return Err(SolveError::Option { name, value, expected: "a positive number, or infinity" });
        }
        if self.smallest_step > self.largest_step {
            let expected = "no more than largest_step";
            return Err(SolveError::Option { name: "smallest_step", value: self.smallest_step, expected });
        }
        at_least_one([("max_iterations", self.max_iterations)])?;
        let (low, high) = self.range;
        if (low..=high).contains(&start) {
            return Ok(());
        }
        Err(SolveError::Option {
            name: "range",
            value: start,
            expected: "a range that holds the parameter at the start",
        })
    }
}

/// What is special about a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum PointKind {
    /// A step ended here.
    Regular,
    /// The parameter turns round.
    Fold,
    /// Another branch crosses: see [`BranchOptions::branch_points`].
    BranchPoint,
    /// The event of this index crosses zero.
    Event(usize),
    /// The parameter reaches the end of its range, which is its value here to the last digit.
    End,
}

/// One solution of a branch.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BranchPoint {
    /// What is special about it.
    pub kind: PointKind,
    /// Value of the parameter.
    pub parameter: f64,
    /// d(parameter)/d(arclength); 0 at a fold.
    pub rate: f64,
    /// Arclength from the start.
    pub arclength: f64,
    /// The solution.
    pub solution: Solution,
    /// Whether the parameter of a branch point has settled on halved meshes, as
    /// [`BranchOptions::settle_branch_points`] asks. Where it has not, it is no more exact than the mesh of the branch
    /// happens to be for what bifurcates, whatever the error estimate of its solution is. True of every other point.
    pub is_settled: bool,
    /// Of a branch point, the direction of the branch that it was found on.
    pub(super) direction: Option<Direction>,
}

/// A branch that crosses another leaves the branch point to two sides. Which of them is which means nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The one that [`trace_crossing`](super::trace_crossing) traces first.
    First,
    /// The other.
    Second,
}

/// A branch traced to the end of its range, to the wanted number of points, or to what it was to stop at.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Branch {
    /// In order of arclength.
    pub points: Vec<BranchPoint>,
    /// Work of all points.
    pub stats: Stats,
    /// Whether the branch has been kept from its start to its end.
    pub check: BranchCheck,
}

impl Branch {
    /// The branch points, in order.
    pub fn branch_points(&self) -> impl Iterator<Item = &BranchPoint> {
        self.points.iter().filter(|point| point.kind == PointKind::BranchPoint)
    }

    /// The folds, in order.
    pub fn folds(&self) -> impl Iterator<Item = &BranchPoint> {
        self.points.iter().filter(|point| point.kind == PointKind::Fold)
    }
}

/// A branch that could not be traced further.
#[derive(Debug, Clone, Error)]
#[error("the branch was lost after {} points: {cause}", .points.len())]
pub struct BranchError {
    /// As far as it was traced.
    pub points: Vec<BranchPoint>,
    /// Why the next step failed, however short it was made.
    pub cause: Box<SolveError>,
}

/// A function of a solution whose zeros along the branch are located, and the places where it jumps from one sign to
/// the other; its poles are not.
pub type EventFunction<'a> = &'a dyn Fn(&Solution) -> f64;
