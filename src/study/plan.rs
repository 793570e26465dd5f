//! The grid: which case stands at which point.

use super::axis::{Axis, MAX_POINTS, SOURCE};
use super::error::StudyError;
use crate::cancel::is_cancelled;
use crate::case::{Case, CaseError, Key, Resolved, Setting};
use crate::drive::SolveOptions;
use std::ops::Range;

/// Neighbours that are solved one from the other: short enough to keep all threads busy, long enough that the cold
/// start of the first hardly counts.
const CHAIN: usize = 16;
/// Chains whose heads are solved one from the other: few, for they are solved one after the other, and all again by
/// whoever wants a point of the last.
pub(super) const HEADS: usize = 16;

/// A case, what is varied in it, and how accurately it is solved.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    case: Case,
    axes: Vec<Axis>,
    options: SolveOptions,
}

/// The case at a point of the grid.
#[derive(Debug, Clone, PartialEq)]
pub struct GridPoint {
    /// What is varied, with its values here.
    pub varied: Vec<(Key, Setting)>,
    /// The case; or why there is no drive at this point, although there may be at others: pulleys that overlap, or a
    /// belt that fits none.
    pub case: Result<Resolved, CaseError>,
}

impl Study {
    /// The grid of all `axes` over `case`, checked at every point. A key that is varied takes the place of the keys of
    /// the case that say the same in another way: the ratio that of both radii, a tension that of an axial force.
    ///
    /// # Errors
    /// What is wrong with the grid, or with the case at some point of it: see [`StudyError`]. Checking a million points
    /// takes a while, and ends where it is cancelled (see [`cancellable`](crate::cancellable)).
    pub fn new(
        mut case: Case,
        axes: impl IntoIterator<Item = Axis>,
        options: SolveOptions,
    ) -> Result<Self, StudyError> {
        let axes: Vec<Axis> = axes.into_iter().collect();
        let mut varied: Vec<Key> = Vec::new();
        for key in axes.iter().flat_map(Axis::keys) {
            if varied.contains(key) {
                return Err(StudyError::Twice { key: *key });
            }
            varied.push(*key);
        }
        if axes.is_empty() {
            return Err(StudyError::NoAxis);
        }
        let points = axes.iter().try_fold(1_usize, |points, axis| points.checked_mul(axis.points()));
        if points.is_none_or(|points| points > MAX_POINTS) {
            return Err(StudyError::TooMany);
        }
        case.make_room(&varied);
        // A row holds values; their errors are told of single solutions.
        let options = SolveOptions { uncertainty: false, ..options };
        let study = Self { case, axes, options };
        study.check()?;
        Ok(study)
    }

    /// Resolves the case at every point. Whether a question has an answer whatever the numbers depends on which keys
    /// are given and on the names among them: it is asked once for each such set, for it takes far longer than
    /// resolving.
    fn check(&self) -> Result<(), StudyError> {
        let mut asked: Vec<Vec<(Key, Option<&str>)>> = Vec::new();
        for index in 0..self.points() {
            if is_cancelled() {
                return Err(StudyError::Cancelled);
            }
            let (_, case) = self.case_at(index)?;
            let Ok(resolved) = resolved(&case)? else { continue };
            let name = |setting: Setting| if let Setting::Name(name) = setting { Some(name) } else { None };
            let keys = resolved.settings().into_iter().map(|(key, setting)| (key, name(setting))).collect();
            if !asked.contains(&keys) {
                case.check_posed(&resolved)?;
                asked.push(keys);
            }
        }
        Ok(())
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.axes.iter().map(Axis::points).product()
    }

    /// What is varied.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// How the points are solved.
    pub fn options(&self) -> &SolveOptions {
        &self.options
    }

    /// The case at a point, counted in input order with the last axis fastest.
    ///
    /// # Errors
    /// A case that contradicts itself; [`Study::new`] has seen to it that there is none.
    pub fn point(&self, index: usize) -> Result<GridPoint, CaseError> {
        let (varied, case) = self.case_at(index)?;
        Ok(GridPoint { varied, case: resolved(&case)? })
    }

    /// What is varied at a point, and the case there, not yet resolved.
    fn case_at(&self, index: usize) -> Result<(Vec<(Key, Setting)>, Case), CaseError> {
        let mut places = Vec::with_capacity(self.axes.len());
        let mut rest = index;
        for axis in self.axes.iter().rev() {
            places.push(rest % axis.points());
            rest /= axis.points();
        }
        let varied: Vec<(Key, Setting)> =
            self.axes.iter().zip(places.iter().rev()).flat_map(|(axis, place)| axis.at(*place)).collect();
        let mut case = self.case.clone();
        for (key, setting) in &varied {
            case.put(SOURCE, *key, setting)?;
        }
        Ok((varied, case))
    }

    /// Points that are solved one from the other, in order: pieces of the lines along the last axis.
    pub(super) fn chains(&self) -> Vec<Range<usize>> {
        let line = self.axes.last().map_or(1, Axis::points);
        let starts = (0..self.points()).step_by(line.max(1));
        starts
            .flat_map(|start| {
                let pieces = (start..start + line).step_by(CHAIN);
                pieces.map(move |first| first..(first + CHAIN).min(start + line))
            })
            .collect()
    }

    /// The points in parts that can be computed apart, on other machines too, in order: [`run`](super::run) of one part
    /// solves nothing of another, and its rows are those of the whole. Each has at least `points` points, the last
    /// excepted; for none, the smallest such parts.
    pub fn parts(&self, points: usize) -> Vec<Range<usize>> {
        let mut parts: Vec<Range<usize>> = Vec::new();
        for group in self.chains().chunks(HEADS) {
            let (Some(first), Some(last)) = (group.first(), group.last()) else { continue };
            match parts.last_mut() {
                Some(part) if part.len() < points => part.end = last.end,
                _ => parts.push(first.start..last.end),
            }
        }
        parts
    }

    /// Everything the rows depend on, as one line of text; of each axis, keys, ends, number and checksum of its points.
    pub fn fingerprint(&self) -> String {
        let point = |axis: &Axis, at: usize| {
            axis.at(at).map(|(key, setting)| serde_json::json!([key.path(), setting])).collect::<Vec<_>>()
        };
        let axis = |axis: &Axis| {
            let mut checksum = crc32fast::Hasher::new();
            for (_, setting) in (0..axis.points()).flat_map(|at| axis.at(at)) {
                match setting {
                    Setting::Number(value) => checksum.update(&value.to_le_bytes()),
                    Setting::List(values) => values.iter().for_each(|value| checksum.update(&value.to_le_bytes())),
                    Setting::Name(name) => checksum.update(name.as_bytes()),
                    Setting::Table(grid) => checksum.update(grid.to_string().as_bytes()),
                }
            }
            let ends = [point(axis, 0), point(axis, axis.points().saturating_sub(1))];
            serde_json::json!({ "points": axis.points(), "ends": ends, "checksum": checksum.finalize() })
        };
        let case = self.point(0).ok().and_then(|point| point.case.ok());
        let settings = self.case.settings().map(|(key, setting)| serde_json::json!([key.path(), setting]));
        let swaps = self.case.swaps().map(|swap| serde_json::json!(swap.to_string()));
        let given: Vec<serde_json::Value> = settings.chain(swaps).collect();
        let axes: Vec<serde_json::Value> = self.axes.iter().map(axis).collect();
        let options = [self.options.order.number().to_string(), self.options.tolerance.to_string()];
        let version = env!("CARGO_PKG_VERSION");
        serde_json::json!({ "version": version, "case": case, "given": given, "axes": axes, "options": options })
            .to_string()
    }

    /// Whether the rows of all points that have a solution have the same columns: what is varied decides on values
    /// only.
    pub fn is_uniform(&self) -> bool {
        let mut columns: Option<Vec<String>> = None;
        for place in 0..self.axes.iter().filter(|axis| !axis.is_continuous()).map(Axis::points).product() {
            let (mut index, mut rest, mut stride) = (0, place, 1);
            for axis in self.axes.iter().rev() {
                if !axis.is_continuous() {
                    index += stride * (rest % axis.points());
                    rest /= axis.points();
                }
                stride *= axis.points();
            }
            let Ok(GridPoint { case: Ok(case), .. }) = self.point(index) else { continue };
            let here = case.settings().iter().map(|(key, _)| key.path().to_owned()).collect();
            match &columns {
                Some(columns) if *columns != here => return false,
                _ => columns = Some(here),
            }
        }
        true
    }
}

/// The case, resolved; or inside, why there is no drive with these numbers, although there may be one with others.
fn resolved(case: &Case) -> Result<Result<Resolved, CaseError>, CaseError> {
    match case.resolve() {
        Ok(resolved) => Ok(Ok(resolved)),
        Err(error) if error.problem().is_of_geometry() => Ok(Err(error)),
        Err(error) => Err(error),
    }
}
