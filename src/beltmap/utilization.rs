//! Derivatives of the friction's utilization at a map's nodes.
//!
//! A pulley's utilization is a mean over its contact, not a function of what the solver differentiates. It goes nearly
//! with the torque over radius and axial force, whose derivatives are exact: v = M/(R A). With c from a least-squares
//! line through all nodes, what remains, u − c v, is small, and its derivatives are differences between neighbours.

use super::hermite::{Shape, difference};
use super::quantity::{Node, Quantity, Sample};

/// Utilizations, each with the torque, radius and force of its pulley.
const PULLEYS: [[Quantity; 4]; 2] = [
    [Quantity::PrimaryUtilization, Quantity::PrimaryTorque, Quantity::PrimaryRadius, Quantity::PrimaryAxialForce],
    [
        Quantity::SecondaryUtilization,
        Quantity::SecondaryTorque,
        Quantity::SecondaryRadius,
        Quantity::SecondaryAxialForce,
    ],
];

/// Fills in the derivatives of both utilizations.
pub(super) fn utilization_slopes(nodes: &mut [Node], quantities: &[Quantity], shape: &Shape, places: &[&[f64]]) {
    let axes = shape.axes();
    for pulley in PULLEYS {
        let Some(at) = all_places(quantities, pulley) else { continue };
        let known: Vec<Option<(f64, f64)>> = nodes
            .iter()
            .map(|node| node.sample().map(|sample| (sample.values[at[0]], grip(sample, at, axes).0)))
            .collect();
        let (products, squares) = known.iter().flatten().fold((0.0, 0.0), |(a, b), (u, v)| (a + u * v, b + v * v));
        let factor = if squares > 0.0 { products / squares } else { 0.0 };
        let rest: Vec<f64> = known.iter().map(|known| known.map_or(f64::NAN, |(u, v)| u - factor * v)).collect();
        for (point, node) in nodes.iter_mut().enumerate() {
            let Node::Solved(sample) = node else { continue };
            let (_, slopes) = grip(sample, at, axes);
            for (axis, slope) in slopes.into_iter().enumerate() {
                let change = difference(shape, places[axis], point, axis, |point| rest[point]);
                sample.slopes[at[0] * axes + axis] = factor * slope + change;
            }
        }
    }
}

fn all_places(quantities: &[Quantity], wanted: [Quantity; 4]) -> Option<[usize; 4]> {
    let mut at = [0; 4];
    for (at, wanted) in at.iter_mut().zip(wanted) {
        *at = quantities.iter().position(|quantity| *quantity == wanted)?;
    }
    Some(at)
}

/// M/(R A) and its derivatives along the axes.
fn grip(sample: &Sample, [_, torque, radius, force]: [usize; 4], axes: usize) -> (f64, Vec<f64>) {
    let value = |at: usize| sample.values[at];
    let grip = value(torque) / (value(radius) * value(force));
    let slope = |axis: usize| {
        let by = |at: usize| sample.slopes[at * axes + axis];
        by(torque) / (value(radius) * value(force)) - grip * (by(radius) / value(radius) + by(force) / value(force))
    };
    (grip, (0..axes).map(slope).collect())
}
