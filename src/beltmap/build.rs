//! Making a map: solve the nodes, estimate the error of each interval, halve those that are too long; then solve a
//! point inside every cell that took no part in this, and halve where the map is wrong there.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::axis::MapAxis;
use super::error::MapError;
use super::estimate::Estimates;
use super::hermite::Shape;
use super::map::BeltMap;
use super::plan::{Keep, MapOptions, MapPlan, Progress};
use super::quantity::{Node, Quantity, holds, sample};
use super::record::{self, PointRow};
use super::report::{ErrorReport, Report};
use super::utilization::utilization_slopes;
use crate::case::{Key, Resolved};
use crate::model::InternalError;
use crate::result::Outcome;
use crate::study::{Axis, Study, visit};

/// Share of the accuracy that an estimated error may have before check points are solved.
const ESTIMATE_SHARE: f64 = 0.5;
/// Intervals are halved whose error is at least this share of the largest.
const WORST_SHARE: f64 = 0.25;
/// Rounds of refinement at most.
const ROUNDS: usize = 60;
/// Check points lie in the inner part of each interval: from this share on, over this share.
const INNER: (f64, f64) = (0.3, 0.4);

/// A point that took no part in the construction.
struct Check {
    at: Vec<f64>,
    node: Node,
}

impl MapPlan {
    /// Makes the map. It is a function of the plan alone, whatever the number of threads and whatever `keep` has.
    ///
    /// # Errors
    /// See [`MapError`]. A map whose error is larger than was asked for, because it would have needed too many points,
    /// is no error: [`Report::reached`] says so.
    pub fn build(&self, keep: &dyn Keep) -> Result<BeltMap, MapError> {
        let inputs = serde_json::to_value(&self.first).map_err(|_| InternalError::Json("a case"))?;
        let axes = self.axes.clone();
        Builder { plan: self, keep, inputs, axes, nodes: BTreeMap::new(), checks: Vec::new(), solved: 0 }.build()
    }
}

struct Builder<'a> {
    plan: &'a MapPlan,
    keep: &'a dyn Keep,
    /// What the map is of.
    inputs: serde_json::Value,
    axes: Vec<MapAxis>,
    /// By the coordinates' bits.
    nodes: BTreeMap<Vec<u64>, Node>,
    checks: Vec<Check>,
    /// Points solved so far.
    solved: usize,
}

fn bits(at: &[f64]) -> Vec<u64> {
    at.iter().map(|value| value.to_bits()).collect()
}

impl Builder<'_> {
    fn build(mut self) -> Result<BeltMap, MapError> {
        let mut rounds = 0;
        loop {
            self.solve_nodes()?;
            let map = self.map();
            if map.usable_cells() == 0 && rounds == 0 {
                return Err(self.empty());
            }
            let estimates = Estimates::new(&map);
            self.tell(estimates.largest());
            let allowed = ESTIMATE_SHARE * self.plan.options.accuracy;
            let mut marks = estimates.worst(allowed, WORST_SHARE);
            let mut errors = None;
            if marks.is_empty() || rounds >= ROUNDS {
                self.solve_checks(&map)?;
                let map = self.map();
                let found = self.errors(&map);
                let largest = found.iter().flatten().copied().fold(0.0, f64::max);
                self.tell(largest);
                if largest <= self.plan.options.accuracy || rounds >= ROUNDS {
                    return Ok(self.finished(rounds));
                }
                marks = self.votes(&map, &Estimates::new(&map), &found);
                errors = Some(largest);
            }
            let kept = self.affordable(marks);
            if kept.is_empty() {
                // No point is left for another round: check what there is.
                if errors.is_none() {
                    let map = self.map();
                    self.solve_checks(&map)?;
                }
                return Ok(self.finished(rounds));
            }
            // From the last interval on, so that the numbers of those before stay.
            for (axis, interval) in kept.into_iter().rev() {
                if let Some(axis) = self.axes.get_mut(axis) {
                    axis.halve(interval);
                }
            }
            rounds += 1;
        }
    }

    /// Of intervals to halve, worst first, those for which there are points left, sorted.
    fn affordable(&self, marks: Vec<(usize, usize, f64)>) -> Vec<(usize, usize)> {
        let most = self.plan.options.max_points;
        let mut lens: Vec<usize> = self.axes.iter().map(MapAxis::len).collect();
        let mut kept: Vec<(usize, usize)> = Vec::new();
        for (axis, interval, _) in marks {
            lens[axis] += 1;
            let nodes: usize = lens.iter().product();
            let cells: usize = lens.iter().map(|len| len - 1).product();
            if nodes + cells.max(self.checks.len()) > most {
                lens[axis] -= 1;
                continue;
            }
            kept.push((axis, interval));
        }
        kept.sort_unstable();
        kept
    }

    fn tell(&self, error: f64) {
        let nodes = self.axes.iter().map(MapAxis::len).product();
        self.keep.progress(Progress { nodes, solved: self.solved, error });
    }

    fn shape(&self) -> Shape {
        Shape::new(self.axes.iter().map(MapAxis::len).collect())
    }

    /// The points in the order in which they are solved: each a neighbour of the one before it, most often along the
    /// axis along which a solution is followed most easily.
    fn order<'s>(&self, shape: &'s Shape) -> impl Iterator<Item = usize> + 's {
        let ease = |key: Key| match key {
            Key::SlackTension => 5,
            Key::PrimaryTorque => 4,
            Key::TightTension | Key::PrimaryAxialForce | Key::SecondaryAxialForce => 3,
            Key::PrimarySpeed | Key::SecondarySpeed => 2,
            Key::Ratio | Key::PrimaryRadius | Key::SecondaryRadius => 0,
            _ => 1,
        };
        let mut axes: Vec<usize> = (0..self.axes.len()).collect();
        axes.sort_by_key(|axis| ease(self.axes[*axis].key()));
        shape.snake(axes)
    }

    fn place(&self, shape: &Shape, point: usize) -> Vec<f64> {
        self.axes.iter().enumerate().map(|(k, axis)| axis.breakpoints()[shape.place(point, k)]).collect()
    }

    /// Solves what the grid does not have yet.
    fn solve_nodes(&mut self) -> Result<(), MapError> {
        let shape = self.shape();
        let missing = self.order(&shape).map(|point| self.place(&shape, point));
        let missing: Vec<Vec<f64>> = missing.filter(|at| !self.nodes.contains_key(&bits(at))).collect();
        let solved = self.solve(&missing)?;
        self.nodes.extend(missing.iter().map(|at| bits(at)).zip(solved));
        Ok(())
    }

    /// Solves a point inside each cell that has values and none yet.
    fn solve_checks(&mut self, map: &BeltMap) -> Result<(), MapError> {
        let mut seen = vec![false; map.shape.points()];
        for check in &self.checks {
            if let Some(cell) = map.local(&check.at).ok().and_then(|local| seen.get_mut(local.corner)) {
                *cell = true;
            }
        }
        let usable: Vec<bool> = {
            let mut usable = vec![false; map.shape.points()];
            map.cells().for_each(|cell| usable[cell] = true);
            usable
        };
        let cells: Vec<usize> = self.order(&map.shape).filter(|cell| usable[*cell] && !seen[*cell]).collect();
        let first = self.checks.len();
        let at = |(number, cell): (usize, &usize)| inside(map, *cell, first + number);
        let missing: Vec<Vec<f64>> = cells.iter().enumerate().map(at).collect();
        let solved = self.solve(&missing)?;
        self.checks.extend(missing.into_iter().zip(solved).map(|(at, node)| Check { at, node }));
        Ok(())
    }

    /// Solves points, each near the one before it; those that are kept are not solved again.
    fn solve(&mut self, points: &[Vec<f64>]) -> Result<Vec<Node>, MapError> {
        let first = self.solved;
        self.solved += points.len();
        if points.is_empty() {
            return Ok(Vec::new());
        }
        let plan = self.plan;
        let quantities = &plan.quantities;
        let kept: Vec<Option<Node>> = (first..self.solved)
            .map(|number| record::read(&self.keep.kept(number)?, quantities, plan.axes.len()))
            .collect();
        let found: Vec<Mutex<Option<Node>>> = kept.iter().cloned().map(Mutex::new).collect();
        let keys: Vec<Key> = plan.axes.iter().map(MapAxis::key).collect();
        let study = Study::new(plan.case.clone(), [Axis::together(&keys, &points.concat())?], plan.options.solve)?;
        let wanted = |index: usize| kept.get(index).is_some_and(Option::is_none);
        visit(&study, plan.options.jobs, wanted, |index, point, outcome| {
            let node = match (&point.case, outcome) {
                (Err(_), _) => Node::NoDrive,
                (Ok(_), Err(_)) => Node::Unsolved,
                (Ok(case), Ok(outcome)) => read(case, outcome, quantities, &keys, &plan.options),
            };
            let row = PointRow { number: first + index, keys: &keys, at: &points[index], node: &node };
            self.keep.keep(record::write(&row, quantities))?;
            *found[index].lock().unwrap_or_else(PoisonError::into_inner) = Some(node);
            Ok(())
        })?;
        let node = |found: Mutex<Option<Node>>| found.into_inner().unwrap_or_else(PoisonError::into_inner);
        Ok(found.into_iter().map(|found| node(found).unwrap_or(Node::Unsolved)).collect())
    }

    /// The map as it is, without its errors.
    fn map(&self) -> BeltMap {
        let shape = self.shape();
        let node = |point: usize| self.nodes.get(&bits(&self.place(&shape, point))).cloned().unwrap_or(Node::Unsolved);
        let mut nodes: Vec<Node> = (0..shape.points()).map(node).collect();
        let places: Vec<&[f64]> = self.axes.iter().map(MapAxis::breakpoints).collect();
        utilization_slopes(&mut nodes, &self.plan.quantities, &shape, &places);
        let map = |excluded: Vec<usize>| {
            let report = self.report(&nodes);
            BeltMap::new(
                self.axes.clone(),
                self.plan.quantities.clone(),
                nodes.clone(),
                excluded,
                report,
                self.inputs.clone(),
            )
        };
        let whole = map(Vec::new());
        // A cell in which the belt slips although it does not at the corners.
        let slips = self.checks.iter().filter(|check| check.node.sample().is_none());
        let mut excluded: Vec<usize> = slips.filter_map(|check| Some(whole.local(&check.at).ok()?.corner)).collect();
        excluded.sort_unstable();
        excluded.dedup();
        if excluded.is_empty() { whole } else { map(excluded) }
    }

    fn report(&self, nodes: &[Node]) -> Report {
        let count = |of: fn(&Node) -> bool| nodes.iter().filter(|node| of(node)).count();
        Report {
            accuracy: self.plan.options.accuracy,
            reached: false,
            error: ErrorReport::default(),
            linear_error: ErrorReport::default(),
            checks: 0,
            nodes: nodes.len(),
            solved: count(|node| matches!(node, Node::Solved(_))),
            slipping: count(|node| matches!(node, Node::Slipping)),
            unsolved: count(|node| matches!(node, Node::Unsolved)),
            no_drive: count(|node| matches!(node, Node::NoDrive)),
            cells: 0,
            usable_cells: 0,
            least_speed_efficiency: self.plan.options.least_speed_efficiency,
            tolerance: self.plan.options.solve.tolerance,
            rounds: 0,
        }
    }

    /// Errors at the check points in cells that have values: one a quantity, scaled.
    fn errors(&self, map: &BeltMap) -> Vec<Vec<f64>> {
        self.measured(map, &|at| map.at(at).ok().map(|point| point.all().to_vec()))
    }

    fn measured(&self, map: &BeltMap, values: &dyn Fn(&[f64]) -> Option<Vec<f64>>) -> Vec<Vec<f64>> {
        let largest = map.largest();
        let of = |check: &Check| {
            let sample = check.node.sample()?;
            let found = values(&check.at)?;
            let scaled = map.quantities.iter().enumerate().map(|(at, quantity)| {
                (found[at] - sample.values[at]).abs() / quantity.scale(sample.values[at], largest[at])
            });
            Some(scaled.collect())
        };
        self.checks.iter().filter_map(of).collect()
    }

    /// Which intervals to halve for the cells in which a check point fails: in each, along the axis on which the
    /// estimated error is largest there.
    fn votes(&self, map: &BeltMap, estimates: &Estimates, errors: &[Vec<f64>]) -> Vec<(usize, usize, f64)> {
        let mut votes: BTreeMap<(usize, usize), f64> = BTreeMap::new();
        let failing = self.checks.iter().filter(|check| check.node.sample().is_some() && map.check(&check.at).is_ok());
        for (check, errors) in failing.zip(errors) {
            let error = errors.iter().copied().fold(0.0, f64::max);
            let Some(local) = map.local(&check.at).ok().filter(|_| error > self.plan.options.accuracy) else {
                continue;
            };
            let axis = estimates.axis_of(map, local.corner);
            let vote = votes.entry((axis, map.shape.place(local.corner, axis))).or_default();
            *vote = vote.max(error);
        }
        super::estimate::worst(votes, WORST_SHARE)
    }

    fn empty(&self) -> MapError {
        let report = self.report(&self.nodes.values().cloned().collect::<Vec<_>>());
        MapError::Empty { nodes: report.nodes, solved: report.solved, slipping: report.slipping }
    }

    /// The map with its errors.
    fn finished(&self, rounds: usize) -> BeltMap {
        let mut map = self.map();
        let errors = self.errors(&map);
        let linear = self.measured(&map, &|at| map.linear(at).ok());
        let error = ErrorReport::of(&map.quantities, &errors);
        let report = Report {
            reached: error.largest <= map.report.accuracy,
            error,
            linear_error: ErrorReport::of(&map.quantities, &linear),
            checks: errors.len(),
            cells: map.all_cells(),
            usable_cells: map.usable_cells(),
            rounds,
            ..map.report.clone()
        };
        map.report = report;
        map
    }
}

/// A point in a cell, the `number`-th of a sequence that fills the inner part of a cube evenly.
fn inside(map: &BeltMap, cell: usize, number: usize) -> Vec<f64> {
    let axes = map.axes.len();
    // The root of x^(n+1) = x + 1: its powers make Weyl's sequence even in n dimensions.
    let root = (0..50).fold(1.5_f64, |x, _| libm::pow(1.0 + x, 1.0 / (axes as f64 + 1.0)));
    let coordinate = |(k, axis): (usize, &MapAxis)| {
        let interval = map.shape.place(cell, k);
        let (a, b) = (axis.breakpoints()[interval], axis.breakpoints()[interval + 1]);
        let even = (0.5 + (number as f64 + 1.0) * root.powi(-(k as i32 + 1))).fract();
        a + (b - a) * (INNER.0 + INNER.1 * even)
    };
    map.axes.iter().enumerate().map(coordinate).collect()
}

/// What a node has of a solution.
fn read(case: &Resolved, outcome: &Outcome, quantities: &[Quantity], axes: &[Key], options: &MapOptions) -> Node {
    match sample(case, &outcome.solved, quantities, axes, &options.solve) {
        Err(failure) => {
            tracing::debug!("a solution has no derivatives, and is left out: {failure}");
            Node::Unsolved
        }
        Ok(sample) => {
            let loss = quantities.iter().position(|quantity| *quantity == Quantity::SpeedLoss);
            let kept = 1.0 - loss.and_then(|at| sample.values.get(at)).copied().unwrap_or(f64::NAN);
            let used = |quantity: Quantity| {
                let at = quantities.iter().position(|other| *other == quantity);
                at.and_then(|at| sample.values.get(at)).map_or(f64::NAN, |used| used.abs())
            };
            let reserve = 1.0 - used(Quantity::PrimaryUtilization).max(used(Quantity::SecondaryUtilization));
            if holds(kept, reserve, options.least_speed_efficiency) { Node::Solved(sample) } else { Node::Slipping }
        }
    }
}
