//! What a map is to be of, and how accurate.

use std::io;

use super::axis::{MAX_AXES, MapAxis};
use super::error::MapError;
use super::quantity::Quantity;
use crate::case::{Case, Key, Resolved};
use crate::drive::SolveOptions;
use crate::study::{Axis, Journaled, Row, Study};

/// What a map is to be.
#[derive(Debug, Clone, PartialEq)]
pub struct MapOptions {
    /// Largest error at check points: see [`Report::accuracy`](super::Report::accuracy).
    pub accuracy: f64,
    /// For every solution.
    pub solve: SolveOptions,
    /// Nodes and check points at most.
    pub max_points: usize,
    /// Speed efficiency below which a drive counts as slipping, unless
    /// [`WANTED_RESERVE`](crate::result::WANTED_RESERVE) of the friction at hand is
    /// left: a belt that sinks into its groove has 0.94 at a ratio of 3 and less than 0.9 at 3.8 without slipping.
    pub least_speed_efficiency: f64,
    /// Threads; all cores if not given.
    pub jobs: Option<usize>,
}

impl Default for MapOptions {
    fn default() -> Self {
        Self {
            accuracy: 1e-3,
            solve: SolveOptions { tolerance: 1e-5, ..SolveOptions::default() },
            max_points: 20_000,
            least_speed_efficiency: 0.9,
            jobs: None,
        }
    }
}

/// What is to be mapped: a case, axes, options.
#[derive(Debug, Clone)]
pub struct MapPlan {
    pub(super) case: Case,
    pub(super) first: Resolved,
    pub(super) axes: Vec<MapAxis>,
    pub(super) quantities: Vec<Quantity>,
    pub(super) options: MapOptions,
}

/// How far a map is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Points of the grid.
    pub nodes: usize,
    /// Points solved so far, nodes and check points.
    pub solved: usize,
    /// The largest error so far: estimated before there are check points, then measured.
    pub error: f64,
}

/// Where points of a map are kept while it is made, so that whatever ends the program loses none.
pub trait Keep: Sync {
    /// The row of a point if it is there, by its number in order of construction.
    fn kept(&self, point: usize) -> Option<Row>;

    /// Keeps a row: in any order, from any thread.
    ///
    /// # Errors
    /// What the system says; it ends the work.
    fn keep(&self, row: Row) -> io::Result<()>;

    /// Hears how far the map is.
    fn progress(&self, _progress: Progress) {}
}

/// Keeps nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct KeepNothing;

impl Keep for KeepNothing {
    fn kept(&self, _point: usize) -> Option<Row> {
        None
    }

    fn keep(&self, _row: Row) -> io::Result<()> {
        Ok(())
    }
}

impl MapPlan {
    /// A map of a case over some axes. Where the ratio is an axis and the case does not say which radius is free, the
    /// primary's is: the map is of a closed belt, whose unstretched length is that of the case. The ratio is then that
    /// of the nominal radii (6.12), of which the secondary's stays.
    ///
    /// # Errors
    /// What is wrong with the case, the axes or the options: see [`MapError`].
    pub fn new(mut case: Case, axes: Vec<MapAxis>, options: MapOptions) -> Result<Self, MapError> {
        check(&options)?;
        if axes.is_empty() || axes.len() > MAX_AXES {
            return Err(MapError::Axes);
        }
        let keys: Vec<Key> = axes.iter().map(MapAxis::key).collect();
        if let Some((_, key)) = keys.iter().enumerate().find(|(at, key)| keys[..*at].contains(key)) {
            return Err(MapError::Twice { key: *key });
        }
        case.make_room(&keys);
        if keys.contains(&Key::Ratio) && !case.has(Key::Free) {
            case.set(Key::Free.path(), crate::case::Free::PrimaryRadius.name())?;
        }
        let middle: Vec<f64> = axes.iter().map(|axis| axis.breakpoints()[axis.len() / 2]).collect();
        let study = Study::new(case.clone(), [Axis::together(&keys, &middle)?], options.solve)?;
        let first = study.point(0)?.case?;
        if first.thermal.is_some() {
            return Err(MapError::Thermal);
        }
        if let Some(margin) = first.operating_point.margin {
            return Err(MapError::Margin { key: margin.setting().0 });
        }
        let quantities = Quantity::of_case(&first);
        Ok(Self { case, first, axes, quantities, options })
    }

    /// The case in the middle of the map, with everything decided.
    pub fn case(&self) -> &Resolved {
        &self.first
    }

    /// What the map is over, with its first breakpoints.
    pub fn axes(&self) -> &[MapAxis] {
        &self.axes
    }

    /// How it is to be made.
    pub fn options(&self) -> &MapOptions {
        &self.options
    }
}

impl Journaled for MapPlan {
    fn fingerprint(&self) -> String {
        let axes = self.axes.iter().map(|axis| serde_json::json!([axis.key().path(), axis.breakpoints()]));
        let options = &self.options;
        serde_json::json!({
            "version": env!("CARGO_PKG_VERSION"),
            "case": self.first,
            "axes": axes.collect::<Vec<_>>(),
            "options": [
                options.solve.order.number().to_string(), options.solve.tolerance.to_string(),
                options.accuracy.to_string(), options.least_speed_efficiency.to_string(),
                    options.max_points.to_string(),
            ],
        })
        .to_string()
    }

    fn points(&self) -> usize {
        2 * self.options.max_points
    }
}

fn check(options: &MapOptions) -> Result<(), MapError> {
    let parameter = |what, given, holds: bool, expected| {
        if holds { Ok(()) } else { Err(MapError::Parameter { what, given, expected }) }
    };
    let accuracy = options.accuracy;
    parameter("the accuracy", accuracy, (1e-8..=0.5).contains(&accuracy), "a number from 1e-8 to 0.5")?;
    let tolerance = options.solve.tolerance;
    let fine = tolerance <= 0.1 * accuracy;
    parameter("the tolerance of the solutions", tolerance, fine, "a tenth of the map's accuracy at most")?;
    let least = options.least_speed_efficiency;
    parameter("the least speed efficiency", least, (0.0..1.0).contains(&least), "a number from 0 to below 1")?;
    let most = options.max_points;
    let expected = "a number from 10 to 400000";
    parameter("the number of points", most as f64, (10..=400_000).contains(&most), expected)
}
