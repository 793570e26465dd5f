//! What can be asked.

use serde::Deserialize;

use crate::drive::SolveOptions;
use crate::equilibrium::Direction;

/// A question.
#[derive(Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "snake_case")]
pub(super) enum Ask {
    /// The keys of a case file.
    Keys,
    /// A case, with something changed in it.
    Solve(SolveAsk),
    /// The largest torque of a case's clamp.
    LargestTorque(LimitAsk),
    /// The smallest clamps of a case's torque.
    SmallestClamps(LimitAsk),
    /// The last solution along the belt.
    Profile,
    /// The shift curve of a whole drive, with something changed in its case: its landmarks.
    Shift(ShiftAsk),
    /// Its next point.
    ShiftNext(ShiftNextAsk),
    /// The best combination of a box of parts.
    Tune(TuneAsk),
}

/// A case to solve.
#[derive(Debug, Deserialize)]
pub(super) struct SolveAsk {
    /// The text of a case file.
    #[serde(default)]
    pub case: String,
    /// Keys to set, each with its value as in a case file; they take the place of what they exclude.
    #[serde(default)]
    pub set: Vec<(String, String)>,
    /// Keys to take out.
    #[serde(default)]
    pub unset: Vec<String>,
    /// Relative tolerance on the defect.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Work at most of a start from nothing, see [`SolveOptions::work_limit`].
    pub work_limit: Option<usize>,
    /// Whether to go from the last solution, step by step, as far as there are solutions; nothing far away is looked
    /// for.
    #[serde(default)]
    pub follow: bool,
    /// Whether to forget the solutions before.
    #[serde(default)]
    pub from_nothing: bool,
    /// Whether what is to be drawn is wanted.
    #[serde(default = "yes")]
    pub scene: bool,
}

/// A case whose limit is sought.
#[derive(Debug, Deserialize)]
pub(super) struct LimitAsk {
    /// The text of a case file.
    #[serde(default)]
    pub case: String,
    /// Relative tolerance on the defect.
    #[serde(default)]
    pub tolerance: Tolerance,
}

/// A whole drive whose shift curve is wanted.
#[derive(Debug, Deserialize)]
pub(super) struct ShiftAsk {
    /// The text of a case file.
    #[serde(default)]
    pub case: String,
    /// Keys to set, each with its value as in a case file; they take the place of what they exclude.
    #[serde(default)]
    pub set: Vec<(String, String)>,
    /// Keys to take out.
    #[serde(default)]
    pub unset: Vec<String>,
    /// Which way the drive shifts.
    pub direction: Direction,
    /// Points, half of them between the stops.
    pub points: usize,
    /// Relative tolerance on the defect.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Whether to forget the curve before.
    #[serde(default)]
    pub from_nothing: bool,
}

/// The curve whose next point is wanted.
#[derive(Debug, Deserialize)]
pub(super) struct ShiftNextAsk {
    /// Which way the drive shifts.
    pub direction: Direction,
}

/// A box of parts that is searched.
#[derive(Debug, Deserialize)]
pub(super) struct TuneAsk {
    /// The text of a case file.
    #[serde(default)]
    pub case: String,
    /// The text of a file of parts.
    pub parts: String,
    /// Speed at which the engine is to be held, with its unit.
    pub target: String,
}

/// A relative tolerance on the defect, from 1e-10 to 1e-1.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(try_from = "f64")]
pub(super) struct Tolerance(f64);

impl Default for Tolerance {
    fn default() -> Self {
        Self(SolveOptions::default().tolerance)
    }
}

impl Tolerance {
    pub(super) const fn value(self) -> f64 {
        self.0
    }
}

impl TryFrom<f64> for Tolerance {
    type Error = String;

    fn try_from(value: f64) -> Result<Self, String> {
        let within = (1e-10..=1e-1).contains(&value);
        within.then_some(Self(value)).ok_or_else(|| format!("a tolerance of {value}: expected 1e-10 to 1e-1"))
    }
}

fn yes() -> bool {
    true
}

impl LimitAsk {
    pub(super) fn options(&self) -> SolveOptions {
        SolveOptions { tolerance: self.tolerance.value(), uncertainty: false, ..SolveOptions::default() }
    }
}

impl ShiftAsk {
    pub(super) fn options(&self) -> SolveOptions {
        SolveOptions { tolerance: self.tolerance.value(), uncertainty: false, ..SolveOptions::default() }
    }
}

impl SolveAsk {
    pub(super) fn options(&self) -> SolveOptions {
        let default = SolveOptions::default();
        let work_limit = self.work_limit.map_or(default.work_limit, |limit| limit.min(default.work_limit));
        // What is looked at is not refined further for the errors of its outputs.
        SolveOptions { tolerance: self.tolerance.value(), work_limit, uncertainty: false, ..default }
    }
}
