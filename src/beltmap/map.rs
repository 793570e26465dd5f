//! A finished map: values and gradients at any point of it.

use super::axis::MapAxis;
use super::error::Outside;
use super::hermite::{Local, Shape, Weights, jets};
use super::quantity::{Node, Quantity, Sample};
use super::report::Report;
use crate::case::Key;

/// Rounding beyond an end of an axis that still counts as the end, as a share of the axis.
const ROUNDING: f64 = 1e-12;

/// A table of what a belt does over two or more keys of its case, with the error of what is read between its nodes.
///
/// Between nodes, every quantity is a cubic Hermite interpolant of the solver's values and exact derivatives. Where a
/// cell of the table has a corner beyond the slip limit, or without a solution, there is no value: see [`Outside`].
///
/// ```no_run
/// use sheave::beltmap::{BeltMap, Quantity};
/// let map = BeltMap::read("map.csv".as_ref())?;
/// // In the order of the map's axes, SI: ratio, torque in N·m, clamp in N.
/// let point = map.at(&[1.2, 18.0, 1500.0])?;
/// let force = point.value(Quantity::PrimaryAxialForce)?;
/// let by_clamp = point.slopes(Quantity::PrimaryAxialForce)?[2];
/// println!("{force:.0} N, {by_clamp:.3} N/N, efficiency {:.3}", point.efficiency()?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct BeltMap {
    pub(super) axes: Vec<MapAxis>,
    pub(super) quantities: Vec<Quantity>,
    pub(super) nodes: Vec<Node>,
    /// Cells, by their lowest corner, in which a held-out solution was not to be had.
    pub(super) excluded: Vec<usize>,
    pub(super) report: Report,
    /// The case in the middle of the map, as in the `inputs` of a result.
    pub(super) inputs: serde_json::Value,
    pub(super) shape: Shape,
    /// By cell, its lowest corner: whether all corners have a solution.
    usable: Vec<bool>,
    /// All derivatives: node by node, quantity by quantity, order by order.
    jets: Vec<f64>,
}

/// What a map says at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct MapPoint<'a> {
    quantities: &'a [Quantity],
    /// One a quantity.
    values: Vec<f64>,
    /// Quantity by quantity, one an axis.
    slopes: Vec<Vec<f64>>,
}

impl BeltMap {
    /// Of nodes in the order of the grid, the last axis running fastest.
    pub(super) fn new(
        axes: Vec<MapAxis>,
        quantities: Vec<Quantity>,
        nodes: Vec<Node>,
        excluded: Vec<usize>,
        report: Report,
        inputs: serde_json::Value,
    ) -> Self {
        let shape = Shape::new(axes.iter().map(MapAxis::len).collect());
        let places: Vec<&[f64]> = axes.iter().map(MapAxis::breakpoints).collect();
        let (many, count) = (axes.len(), quantities.len());
        let width = count << many;
        let mut all = vec![f64::NAN; shape.points() * width];
        for at in 0..count {
            let known: Vec<Option<(f64, &[f64])>> = nodes
                .iter()
                .map(|node| {
                    let sample = node.sample()?;
                    Some((*sample.values.get(at)?, sample.slopes.get(at * many..(at + 1) * many)?))
                })
                .collect();
            for (point, jet) in jets(&shape, &places, &known).into_iter().enumerate() {
                let begin = point * width + (at << many);
                if let Some(slot) = all.get_mut(begin..begin + jet.len()) {
                    slot.copy_from_slice(&jet);
                }
            }
        }
        let mut map = Self { axes, quantities, nodes, excluded, report, inputs, usable: Vec::new(), shape, jets: all };
        map.usable = (0..map.shape.points()).map(|corner| map.is_usable(corner)).collect();
        map
    }

    /// Whether the cell with this lowest corner has a solution at all its corners.
    fn is_usable(&self, corner: usize) -> bool {
        let mut corners = self.corners(corner);
        let inside = (0..self.axes.len()).all(|axis| self.shape.place(corner, axis) + 1 < self.shape.len(axis));
        inside
            && !self.excluded.contains(&corner)
            && corners.all(|node| self.nodes.get(node).is_some_and(|node| node.sample().is_some()))
    }

    /// Nodes at the corners of the cell with this lowest corner.
    pub(super) fn corners(&self, corner: usize) -> impl Iterator<Item = usize> + '_ {
        let axes = self.axes.len();
        (0..1_usize << axes).map(move |bits| {
            corner + (0..axes).filter(|axis| bits >> axis & 1 == 1).map(|axis| self.shape.stride(axis)).sum::<usize>()
        })
    }

    /// Cells, by their lowest corner, in which the map has values.
    pub(super) fn cells(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.usable.len()).filter(|corner| self.usable[*corner])
    }

    /// Number of cells, with values or without.
    pub fn all_cells(&self) -> usize {
        self.axes.iter().map(|axis| axis.len().saturating_sub(1)).product()
    }

    /// Number of cells in which the map has values.
    pub fn usable_cells(&self) -> usize {
        self.cells().count()
    }

    /// What the map is over, in the order of coordinates.
    pub fn axes(&self) -> &[MapAxis] {
        &self.axes
    }

    /// What the map tells.
    pub fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    /// What the interpolant is made of, for who reads the map elsewhere: all derivatives, node by node, quantity by
    /// quantity, order by order. Bit k of an order stands for a derivative along axis k; not numbers at nodes without a
    /// solution.
    pub fn derivatives(&self) -> &[f64] {
        &self.jets
    }

    /// Whether the map has values in the cell above each node, by node; false at the upper end of an axis.
    pub fn usable_above(&self) -> &[bool] {
        &self.usable
    }

    /// The case in the middle of the map with everything decided, as in the `inputs` of a result.
    pub fn inputs(&self) -> &serde_json::Value {
        &self.inputs
    }

    /// How the map was made, and how accurate it is.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Place of a key among the axes.
    pub fn axis(&self, key: Key) -> Option<usize> {
        self.axes.iter().position(|axis| axis.key() == key)
    }

    /// The cell in which a point lies, whether or not it has values there.
    pub(super) fn local(&self, at: &[f64]) -> Result<Local, Outside> {
        if at.len() != self.axes.len() {
            return Err(Outside::Coordinates { given: at.len(), expected: self.axes.len() });
        }
        let mut local = Local { corner: 0, shares: Vec::with_capacity(at.len()) };
        for (k, (axis, &value)) in self.axes.iter().zip(at).enumerate() {
            let (from, to) = axis.range();
            let slack = ROUNDING * (to - from);
            let near = if (from - slack..=to + slack).contains(&value) { value.clamp(from, to) } else { value };
            let outside = Outside::Range { key: axis.key(), value, from, to };
            let interval = axis.interval(near).ok_or(outside)?;
            let &[left, right] = axis.breakpoints().get(interval..interval + 2).unwrap_or_default() else {
                return Err(outside);
            };
            local.corner += interval * self.shape.stride(k);
            local.shares.push(((near - left) / (right - left), right - left));
        }
        Ok(local)
    }

    fn usable(&self, at: &[f64]) -> Result<Local, Outside> {
        let local = self.local(at)?;
        if self.usable.get(local.corner) == Some(&true) { Ok(local) } else { Err(Outside::Slipping) }
    }

    /// All quantities at a point: one coordinate an axis, in SI.
    ///
    /// # Errors
    /// See [`Outside`]: nothing is extrapolated.
    pub fn at(&self, at: &[f64]) -> Result<MapPoint<'_>, Outside> {
        let local = self.usable(at)?;
        let weights = Weights::new(&self.shape, &local);
        let many = 1 << self.axes.len();
        let width = self.quantities.len() * many;
        let of = |at: usize| weights.apply(&self.jets, local.corner, width, at * many);
        let (values, slopes) = (0..self.quantities.len()).map(of).unzip();
        Ok(MapPoint { quantities: &self.quantities, values, slopes })
    }

    /// What a sample says.
    pub(super) fn point_of(&self, sample: &Sample) -> MapPoint<'_> {
        let slopes = sample.slopes.chunks(self.axes.len().max(1)).map(<[f64]>::to_vec).collect();
        MapPoint { quantities: &self.quantities, values: sample.values.clone(), slopes }
    }

    /// Whether the map has values at a point.
    ///
    /// # Errors
    /// As [`BeltMap::at`].
    pub fn check(&self, at: &[f64]) -> Result<(), Outside> {
        self.usable(at).map(|_| ())
    }

    /// What interpolation linear in each coordinate makes of the nodes, as simulators have it that read the table
    /// without its derivatives.
    ///
    /// # Errors
    /// As [`BeltMap::at`].
    pub fn linear(&self, at: &[f64]) -> Result<Vec<f64>, Outside> {
        let local = self.usable(at)?;
        let mut values = vec![0.0; self.quantities.len()];
        for (bits, node) in self.corners(local.corner).enumerate() {
            let share = |(axis, (share, _)): (usize, &(f64, f64))| {
                if bits >> axis & 1 == 1 { *share } else { 1.0 - share }
            };
            let weight: f64 = local.shares.iter().enumerate().map(share).product();
            let Some(sample) = self.nodes.get(node).and_then(Node::sample) else { return Err(Outside::Slipping) };
            values.iter_mut().zip(&sample.values).for_each(|(sum, value)| *sum += weight * value);
        }
        Ok(values)
    }

    /// Largest size of each quantity at the nodes.
    pub(super) fn largest(&self) -> Vec<f64> {
        let mut largest = vec![0.0_f64; self.quantities.len()];
        for sample in self.nodes.iter().filter_map(Node::sample) {
            largest.iter_mut().zip(&sample.values).for_each(|(largest, value)| *largest = largest.max(value.abs()));
        }
        largest
    }
}

impl MapPoint<'_> {
    fn place(&self, quantity: Quantity) -> Result<usize, Outside> {
        let at = self.quantities.iter().position(|other| *other == quantity);
        at.ok_or(Outside::Quantity(quantity.name()))
    }

    /// All quantities, in the map's order.
    pub(super) fn all(&self) -> &[f64] {
        &self.values
    }

    /// A quantity, SI.
    ///
    /// # Errors
    /// [`Outside::Quantity`] for losses of a map without them.
    pub fn value(&self, quantity: Quantity) -> Result<f64, Outside> {
        let at = self.place(quantity)?;
        self.values.get(at).copied().ok_or(Outside::Quantity(quantity.name()))
    }

    /// A quantity's derivatives along the map's axes, SI.
    ///
    /// # Errors
    /// As [`MapPoint::value`].
    pub fn slopes(&self, quantity: Quantity) -> Result<&[f64], Outside> {
        let at = self.place(quantity)?;
        self.slopes.get(at).map(Vec::as_slice).ok_or(Outside::Quantity(quantity.name()))
    }

    /// ω_S, rad/s: from the primary's speed, both radii and the speed loss.
    ///
    /// # Errors
    /// None, for a map has all of these.
    pub fn secondary_speed(&self) -> Result<f64, Outside> {
        let rim = self.value(Quantity::PrimarySpeed)? * self.value(Quantity::PrimaryRadius)?;
        Ok(rim / self.value(Quantity::SecondaryRadius)? * (1.0 - self.value(Quantity::SpeedLoss)?))
    }

    /// Share of the friction at hand that is left over on the pulley that has less.
    ///
    /// # Errors
    /// As [`MapPoint::secondary_speed`].
    pub fn slip_reserve(&self) -> Result<f64, Outside> {
        let used = self.value(Quantity::PrimaryUtilization)?.abs();
        Ok(1.0 - used.max(self.value(Quantity::SecondaryUtilization)?.abs()))
    }

    /// Power into the primary and out of the secondary, W.
    ///
    /// # Errors
    /// As [`MapPoint::secondary_speed`].
    pub fn powers(&self) -> Result<(f64, f64), Outside> {
        let primary = self.value(Quantity::PrimarySpeed)? * self.value(Quantity::PrimaryTorque)?;
        Ok((primary, self.secondary_speed()? * self.value(Quantity::SecondaryTorque)?))
    }

    /// Power out over power in of the pulley that drives the other (6.9), friction alone counted; not a number where
    /// neither drives the other.
    ///
    /// # Errors
    /// As [`MapPoint::secondary_speed`].
    pub fn efficiency(&self) -> Result<f64, Outside> {
        let (primary, secondary) = self.powers()?;
        Ok(share(primary, secondary, 0.0))
    }

    /// The same with hysteresis, drag and gears taken off what arrives.
    ///
    /// # Errors
    /// [`Outside::Quantity`] of a map without losses.
    pub fn efficiency_with_losses(&self) -> Result<f64, Outside> {
        let (primary, secondary) = self.powers()?;
        Ok(share(primary, secondary, self.value(Quantity::Losses)?))
    }
}

/// What arrives, less losses, over what drives; not a number where neither pulley drives the other.
fn share(primary: f64, secondary: f64, lost: f64) -> f64 {
    if primary > 0.0 && secondary > 0.0 {
        (secondary - lost) / primary
    } else if primary < 0.0 && secondary < 0.0 {
        (-primary - lost) / -secondary
    } else {
        f64::NAN
    }
}
