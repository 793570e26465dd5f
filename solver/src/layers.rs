//! Where layers may be, as the linearised equations tell before any mesh resolves them.
//!
//! A layer much thinner than the intervals spoils the solution on all of them: what does not decay along the layer is
//! carried on from node to node, and the defects are as large where nothing happens as where the layer is. The
//! derivatives at the nodes say more. A mode, an eigenvector of ∂f/∂y with the eigenvalue λ, that decays within a
//! fraction of an interval may have a layer of width 1/|Re λ| at the left end, and one that grows at the right end. In
//! between, where modes grow before a place and decay behind it (a turning point), they meet in a layer: with
//! λ = -c (s - s*) its width is c^(-1/2). See U. M. Ascher, R. M. M. Mattheij and R. D. Russell, "Numerical Solution of
//! Boundary Value Problems for Ordinary Differential Equations", SIAM 1995, sections 10.1 and 10.4.
//!
//! Whether the solution has a layer there only its boundary values and sources decide, which are not looked at: the
//! intervals that are made for it cost little, and where they are not needed they go again.

use crate::collocation::System;
use crate::collocation::evaluate::Work;
use crate::linear::scalar::W;
use crate::mesh::{distinct, equidistribute, needed};
use crate::problem::Problem;
use nalgebra::{DMatrix, Schur};

/// A mode is fast if it changes by this power of e, or more, over the intervals beside a node: no mesh of such
/// intervals resolves it.
const FAST: f64 = 6.0;
/// Eigenvalues are sought at so many nodes at most.
const MOST_NODES: usize = 17;
/// Steps of the iteration for the eigenvalues of one matrix at most.
const STEPS: usize = 1000;
/// How much longer intervals are, per distance from a layer.
const GRADATION: f64 = 0.4;
/// Ratio of the lengths of neighbouring intervals on which wanted lengths are constant.
const RATIO: f64 = 1.5;
/// Thinner layers are taken to be as wide as this, relative to the region's length.
const THINNEST: f64 = 1e-10;

/// Where a solution may vary within a distance that the mesh does not resolve.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Layer {
    place: f64,
    width: f64,
}

/// The fast modes at a node.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Modes {
    /// How many of them grow with s.
    growing: usize,
    /// How many of them decay with s.
    decaying: usize,
    /// The largest rate at which one grows; 0 if none does.
    growth: f64,
    /// The largest rate at which one decays; 0 if none does.
    decay: f64,
}

impl Modes {
    /// Those of the derivatives `a` of `n` states, `a[j * n + i]` being ∂f_i/∂y_j, beside intervals of length `h`. None
    /// if there are no eigenvalues to be had.
    fn of(n: usize, a: &[f64], h: f64) -> Option<Self> {
        let mut modes = Self::default();
        let mut count = |rate: f64| {
            if rate * h > FAST {
                (modes.growing, modes.growth) = (modes.growing + 1, modes.growth.max(rate));
            } else if rate * h < -FAST {
                (modes.decaying, modes.decay) = (modes.decaying + 1, modes.decay.max(-rate));
            }
        };
        if let &[a, b, c, d] = a {
            let (mean, half) = (0.5 * (a + d), 0.5 * (a - d));
            let root = (half * half + b * c).max(0.0).sqrt();
            count(mean + root);
            count(mean - root);
        } else {
            let schur = Schur::try_new(DMatrix::from_column_slice(n, n, a), f64::EPSILON, STEPS)?;
            schur.complex_eigenvalues().iter().for_each(|value| count(value.re));
        }
        Some(modes)
    }

    fn fast(&self) -> usize {
        self.growing + self.decaying
    }
}

/// A mesh on which the layers that a region may have are resolved roughly, at the ends and at turning points, and which
/// is as fine as the present one elsewhere. None if there may be no layers thinner than the intervals, or if the mesh
/// would have more than `most` intervals.
pub(crate) fn graded<P: Problem + ?Sized>(
    system: &System<'_, P>,
    region: usize,
    work: &Work,
    most: usize,
) -> Option<Vec<f64>> {
    let (grid, n) = (&system.grids[region], system.plan.regions[region].n);
    let pattern = &system.layout.regions[region].state_pattern;
    let (dy, stride, mesh) = (&work.regions[region].nodes.dy, grid.node_stride(), &grid.mesh);
    let (last, mut a) = (grid.intervals(), vec![0.0; n * n]);
    let mut modes_at = |j: usize| {
        a.fill(0.0);
        for (entry, &(row, state)) in pattern.iter().enumerate().filter(|(_, (row, _))| *row < n) {
            a[state * n + row] = dy[entry * stride + grid.node(j)];
        }
        // Of the intervals beside a node, the shorter: neighbours' lengths may differ much.
        let before = if j > 0 { mesh[j] - mesh[j - 1] } else { f64::INFINITY };
        let after = if j < last { mesh[j + 1] - mesh[j] } else { f64::INFINITY };
        Some((mesh[j], Modes::of(n, &a, before.min(after))?))
    };
    let pieces = last.min(MOST_NODES - 1);
    let modes: Option<Vec<(f64, Modes)>> = (0..=pieces).map(|k| modes_at(k * last / pieces)).collect();
    let layers = layers(&modes?);
    let new = (!layers.is_empty()).then(|| resolving(mesh, &layers, most)).flatten()?;
    (new.len() > mesh.len()).then_some(new)
}

/// From the modes at places in increasing order, the region's ends among them.
fn layers(modes: &[(f64, Modes)]) -> Vec<Layer> {
    let (Some(&(start, first)), Some(&(end, last))) = (modes.first(), modes.last()) else { return Vec::new() };
    let at_start = (first.decaying > 0).then(|| Layer { place: start, width: 1.0 / first.decay });
    let at_end = (last.growing > 0).then(|| Layer { place: end, width: 1.0 / last.growth });
    let mut out: Vec<Layer> = at_start.into_iter().chain(at_end).collect();
    // The last place at which no fast mode has slowed down: at a turning point itself they are slow.
    let mut before = (start, first);
    for &(place, modes) in modes {
        let (from, last) = before;
        if modes.growing < last.growing && modes.decaying > last.decaying {
            let (change, distance) = (last.growth + modes.decay, place - from);
            out.push(Layer { place: from + distance * (last.growth / change), width: (distance / change).sqrt() });
        }
        if modes.fast() >= last.fast() {
            before = (place, modes);
        }
    }
    out
}

/// Intervals no longer than those of the mesh, nor than the width of a layer and a part of the distance from it. None
/// if they would be more than `most`.
fn resolving(mesh: &[f64], layers: &[Layer], most: usize) -> Option<Vec<f64>> {
    let (a, b) = (mesh[0], mesh[mesh.len() - 1]);
    let width = |layer: &Layer| layer.width.max(THINNEST * (b - a));
    let mut nodes = mesh.to_vec();
    for layer in layers {
        let (mut length, mut distance) = (width(layer), width(layer));
        while distance < b - a {
            let sides = [layer.place - distance, layer.place + distance];
            nodes.extend(sides.into_iter().filter(|&s| a < s && s < b));
            length *= RATIO;
            distance += length;
        }
    }
    nodes.sort_by(f64::total_cmp);
    let nodes = distinct(nodes);
    let mut old = 1;
    let wanted = nodes.windows(2).map(|pair| {
        let middle = 0.5 * (pair[0] + pair[1]);
        while old + 1 < mesh.len() && mesh[old] < middle {
            old += 1;
        }
        let near = layers.iter().map(|layer| width(layer) + GRADATION * (middle - layer.place).abs());
        near.fold(mesh[old] - mesh[old - 1], f64::min)
    });
    let wanted: Vec<f64> = wanted.collect();
    let count = needed(&nodes, &wanted).ceil();
    // So many are worked on side by side: filling up costs nothing.
    let count = (count <= most as f64).then(|| (count as usize).next_multiple_of(W).min(most))?;
    Some(distinct(equidistribute(&nodes, &wanted, count)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::uniform;
    use proptest::prelude::*;

    /// Modes of one equation y' = λ y.
    fn of_rate(rate: f64, h: f64) -> Modes {
        Modes::of(1, &[rate], h).unwrap()
    }

    #[test]
    fn fast_modes_are_counted_whatever_the_number_of_states() {
        assert_eq!(of_rate(-5.0, 1.0), Modes::default());
        assert_eq!(of_rate(-7.0, 1.0), Modes { decaying: 1, decay: 7.0, ..Modes::default() });
        // u'' = 1e4 u - 1e-3 u', and oscillation, which is no layer.
        let both = Modes::of(2, &[0.0, 1e4, 1.0, -1e-3], 1.0).unwrap();
        assert!(both.growing == 1 && both.decaying == 1 && (both.growth - 100.0).abs() < 1e-2, "{both:?}");
        assert_eq!(Modes::of(2, &[0.0, -1e4, 1.0, 0.0], 1.0), Some(Modes::default()));
        // Eigenvalues -1e3, 50 and 1, by columns.
        let three = Modes::of(3, &[-1e3, 0.0, 0.0, 5.0, 50.0, 0.0, -3.0, 2.0, 1.0], 1.0).unwrap();
        assert_eq!((three.growing, three.decaying), (1, 1));
        assert!((three.growth - 50.0).abs() < 1e-9 && (three.decay - 1e3).abs() < 1e-9, "{three:?}");
        // Two widths, 1e-2 and 1e-4 of a region, with derivatives of very different sizes.
        let a = [0.0, 2e4, 0.0, -1e8, 1.0, 0.0, 0.0, 0.0, 0.0, -1e4, 0.0, 2e8, 0.0, 0.0, 1.0, 0.0];
        let four = Modes::of(4, &a, 1.0).unwrap();
        assert!(four.growing == 2 && four.decaying == 2 && (four.growth / 14142.3 - 1.0).abs() < 1e-5, "{four:?}");
        assert_eq!(Modes::of(3, &[f64::NAN; 9], 1.0), None);
    }

    #[test]
    fn layers_are_at_ends_that_modes_decay_from_and_at_turning_points() {
        let along = |rate: &dyn Fn(f64) -> f64| -> Vec<Layer> {
            let mesh = uniform((0.0, 1.0), 8);
            layers(&mesh.iter().map(|&s| (s, of_rate(rate(s), 0.125))).collect::<Vec<_>>())
        };
        assert_eq!(along(&|_| -100.0), [Layer { place: 0.0, width: 0.01 }]);
        assert_eq!(along(&|_| 100.0), [Layer { place: 1.0, width: 0.01 }]);
        assert_eq!(along(&|_| 10.0), []);
        // Modes that grow before 0.3, and decay behind it; slow at the node beside it; then the other way round.
        for turn in [0.3, 0.25] {
            let found = along(&|s| -1e4 * (s - turn));
            let [Layer { place, width }] = found[..] else { panic!("{found:?}") };
            assert!((place - turn).abs() < 1e-12 && (width - 0.01).abs() < 1e-12, "{found:?}");
            let found = along(&|s| 1e4 * (s - turn));
            let places: Vec<f64> = found.iter().map(|layer| layer.place).collect();
            assert_eq!(places, [0.0, 1.0]);
        }
    }

    proptest! {
        #[test]
        fn meshes_resolve_layers_and_are_no_coarser_elsewhere(
            place in 0.0..1.0_f64,
            digits in 0.0..14.0_f64,
            intervals in 1_usize..40,
        ) {
            let layer = Layer { place, width: 10.0_f64.powf(-digits) };
            let mesh = uniform((0.0, 1.0), intervals);
            let Some(new) = resolving(&mesh, &[layer], 10_000) else { panic!("refused") };
            prop_assert!(new.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert_eq!((new[0], new[new.len() - 1]), (0.0, 1.0));
            prop_assert!(new.len() < intervals + 250, "{}", new.len());
            for pair in new.windows(2) {
                let (length, distance) = (pair[1] - pair[0], (0.5 * (pair[0] + pair[1]) - place).abs());
                prop_assert!(length <= 1.001 / intervals as f64, "{length}");
                let most = 1.25 * layer.width.max(THINNEST) + distance;
                prop_assert!(length <= most, "{length} at {distance} from {layer:?}");
            }
            prop_assert_eq!(resolving(&mesh, &[layer], intervals.saturating_sub(1)), None);
        }
    }
}
