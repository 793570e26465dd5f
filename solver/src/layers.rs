//! Where layers may be, as the linearised equations tell before any mesh resolves them.
//!
//! A layer much thinner than the intervals spoils the solution on all of them: what does not decay along the layer is
//! carried on from node to node, and the defects are as large where nothing happens as where the layer is. The
//! derivatives at the nodes say more. A mode, an eigenvector of ∂f/∂y with the eigenvalue λ, that decays within a
//! fraction of an interval may have a layer of width 1/|Re λ| at the left end, and one that grows at the right end. In
//! between, where modes grow before a place and decay behind it (a turning point), they meet in a layer: with
//! λ = -c (s - s*) its width is c^(-1/2). The same holds where an end is such a place, as of a problem that symmetry
//! has halved: modes are slow there, and fast within the region. See U. M. Ascher, R. M. M. Mattheij and R. D. Russell,
//! "Numerical Solution of Boundary Value Problems for Ordinary Differential Equations", SIAM 1995, sections 10.1 and
//! 10.4.
//!
//! Whether the solution has a layer there only its boundary values and sources decide, which are not looked at.
//!
//! Where a layer has faded to nothing is not where intervals may be long. Collocation at Lobatto's points makes of a
//! mode that changes by e^-z over an interval a diagonal Padé approximation R(z) of that, and |R| is 1 where z is
//! large: what is left of the layer where the intervals become longer than it is wide is carried on through the whole
//! region, and its slope is z times as large. Beyond the layer itself there are therefore intervals of the length for
//! which |R| is small, as many as it takes, before they grow; later meshes keep them.

use crate::collocation::System;
use crate::collocation::evaluate::Work;
use crate::linear::scalar::W;
use crate::mesh::{distinct, equidistribute, needed};
use crate::options::Order;
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
const RATIO: f64 = 1.25;
/// Thinner layers are taken to be as wide as this, relative to the region's length.
const THINNEST: f64 = 1e-10;

/// What is left of a layer where intervals begin to grow, times its slope.
const LEFT: f64 = 1e-3;
/// How many times the width of a layer it takes at most, on such intervals, to fade by e.
const SLOWNESS: f64 = 1.5;
/// Layers are not resolved for tolerances below this, before anything is known of the solution beside them.
const TIGHTEST: f64 = 1e-6;
/// Defect in a layer, beyond order 4, of intervals that are as long as it is wide.
const DEFECT_AT_WIDTH: f64 = 1e-3;

/// Where a solution may vary within a distance that the mesh does not resolve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Layer {
    place: f64,
    width: f64,
    /// Longest interval within its extent.
    longest: f64,
    /// Distance from its place beyond which intervals may grow.
    extent: f64,
}

impl Layer {
    /// Longest interval at this distance from its place.
    fn longest(&self, distance: f64) -> f64 {
        self.longest + GRADATION * (distance - self.extent).max(0.0)
    }
}

/// Longest interval at `s` beside layers.
pub(crate) fn longest(layers: &[Layer], s: f64) -> f64 {
    layers.iter().map(|layer| layer.longest((s - layer.place).abs())).fold(f64::INFINITY, f64::min)
}

/// How fine a mesh is to be in layers and beside them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fineness {
    order: Order,
    linear: bool,
    /// Length of the shortest intervals, relative to the width of a layer.
    shortest: f64,
}

impl Fineness {
    /// To see that there is a layer.
    pub(crate) fn rough(order: Order) -> Self {
        Self { order, linear: false, shortest: 1.0 }
    }

    /// To resolve one of a linear problem, so that defects are `target`: as no iteration can fail on such a mesh, it
    /// may be the last.
    pub(crate) fn for_defects(order: Order, target: f64) -> Self {
        let rough = Self { linear: true, ..Self::rough(order) };
        if order == Order::Four {
            return rough;
        }
        let shortest = libm::pow(target.max(TIGHTEST) / DEFECT_AT_WIDTH, 1.0 / rough.growing()).min(1.0);
        Self { shortest, ..rough }
    }

    /// Over so many widths the lengths that a layer needs grow by e.
    fn growing(&self) -> f64 {
        self.order.tableau().defect_order
    }

    /// Whether intervals stay short until layers have faded. Beyond order 4 only where the problem is linear: there
    /// matrices are so nearly singular on such meshes that other iterations fail more often.
    fn is_fading(&self) -> bool {
        self.linear || self.order == Order::Four
    }

    /// Longest interval at this distance from the place of a layer.
    fn longest(&self, layer: &Layer, distance: f64) -> f64 {
        let needed = self.shortest * layer.width * libm::exp(distance / (self.growing() * layer.width));
        layer.longest(distance).min(needed)
    }
}

/// What makes layers in a region of this length.
#[derive(Debug, Clone, Copy)]
struct Making {
    fineness: Fineness,
    length: f64,
}

impl Making {
    /// Of a mode that decays from an end at a rate of 1/`width`. Its extent is that within which it fades in the
    /// discretisation, which is not as quick as it at order 4, and quicker at order 8.
    fn at_end(&self, place: f64, width: f64) -> Layer {
        // Where |R(z)| is small, and how many times the width it takes to fade by e.
        let (z, slowness) = match self.fineness.order {
            Order::Four => (3.0, SLOWNESS),
            Order::Six | Order::SixGauss => (4.5, SLOWNESS),
            Order::Eight => (7.0, 0.5),
        };
        self.layer(place, width, z, |powers| slowness * powers)
    }

    /// Of modes that meet, and decay as e^(-(s/width)²/2).
    fn at_turn(&self, place: f64, width: f64) -> Layer {
        self.layer(place, width, 1.0, |powers| SLOWNESS * (2.0 * powers).sqrt())
    }

    /// `longest` and what `extent` makes of the power of e by which it is to fade are relative to the layer's width.
    fn layer(&self, place: f64, width: f64, longest: f64, extent: impl Fn(f64) -> f64) -> Layer {
        let width = width.max(THINNEST * self.length);
        if !self.fineness.is_fading() {
            return Layer { place, width, longest: width, extent: 0.0 };
        }
        let powers = libm::log(self.length / (LEFT * width)).max(0.0);
        Layer { place, width, longest: longest * width, extent: extent(powers) * width }
    }
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

/// A mesh on which the layers that a region may have are resolved, at the ends and at turning points, and which is as
/// fine as the present one elsewhere; and the layers. None if there may be no layers thinner than the intervals, or if
/// the mesh would have more than `most` intervals.
pub(crate) fn graded<P: Problem + ?Sized>(
    system: &System<'_, P>,
    region: usize,
    work: &Work,
    most: usize,
    fineness: Fineness,
) -> Option<(Vec<f64>, Vec<Layer>)> {
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
    let layers = layers(&modes?, Making { fineness, length: mesh[last] - mesh[0] });
    let new = (!layers.is_empty()).then(|| resolving(mesh, &layers, most, fineness)).flatten()?;
    (new.len() > mesh.len()).then_some((new, layers))
}

/// From the modes at places in increasing order, the region's ends among them.
fn layers(modes: &[(f64, Modes)], making: Making) -> Vec<Layer> {
    let (Some(&(start, first)), Some(&(end, last))) = (modes.first(), modes.last()) else { return Vec::new() };
    let at_start = (first.decaying > 0).then(|| making.at_end(start, 1.0 / first.decay));
    let at_end = (last.growing > 0).then(|| making.at_end(end, 1.0 / last.growth));
    let mut out: Vec<Layer> = at_start.into_iter().chain(at_end).collect();
    // An end that is a turning point itself: modes are slow there, and fast at the next place within.
    let mut half = |end: f64, place: f64, rate: f64| out.push(making.at_turn(end, ((place - end).abs() / rate).sqrt()));
    if let &[_, (place, next), ..] = modes
        && next.decaying > first.decaying
    {
        half(start, place, next.decay);
    }
    if let &[.., (place, previous), _] = modes
        && previous.growing > last.growing
    {
        half(end, place, previous.growth);
    }
    // The last place at which no fast mode has slowed down: at a turning point itself they are slow.
    let mut before = (start, first);
    for &(place, modes) in modes {
        let (from, last) = before;
        if modes.growing < last.growing && modes.decaying > last.decaying {
            let (change, distance) = (last.growth + modes.decay, place - from);
            out.push(making.at_turn(from + distance * (last.growth / change), (distance / change).sqrt()));
        }
        if modes.fast() >= last.fast() {
            before = (place, modes);
        }
    }
    out
}

/// Intervals no longer than those of the mesh, nor than layers ask for. None if they would be more than `most`.
fn resolving(mesh: &[f64], layers: &[Layer], most: usize, fineness: Fineness) -> Option<Vec<f64>> {
    let (a, b) = (mesh[0], mesh[mesh.len() - 1]);
    let mut nodes = mesh.to_vec();
    for layer in layers {
        let mut length = fineness.shortest * layer.width;
        let mut distance = length;
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
        let near = layers.iter().map(|layer| fineness.longest(layer, (middle - layer.place).abs()));
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

    fn making(fineness: Fineness) -> Making {
        Making { fineness, length: 1.0 }
    }

    #[test]
    fn layers_are_at_ends_that_modes_decay_from_and_at_turning_points() {
        let along = |rate: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
            let mesh = uniform((0.0, 1.0), 8);
            let found = layers(
                &mesh.iter().map(|&s| (s, of_rate(rate(s), 0.125))).collect::<Vec<_>>(),
                making(Fineness::rough(Order::Four)),
            );
            found.iter().map(|layer| (layer.place, layer.width)).collect()
        };
        assert_eq!(along(&|_| -100.0), [(0.0, 0.01)]);
        assert_eq!(along(&|_| 100.0), [(1.0, 0.01)]);
        assert_eq!(along(&|_| 10.0), []);
        // Modes that grow before 0.3, and decay behind it; slow at the node beside it; then the other way round.
        for turn in [0.3, 0.25] {
            let found = along(&|s| -1e4 * (s - turn));
            let [(place, width)] = found[..] else { panic!("{found:?}") };
            assert!((place - turn).abs() < 1e-12 && (width - 0.01).abs() < 1e-12, "{found:?}");
            let places: Vec<f64> = along(&|s| 1e4 * (s - turn)).iter().map(|(place, _)| *place).collect();
            assert_eq!(places, [0.0, 1.0]);
        }
        // Half of it, on either side of such a place.
        for (end, sign) in [(0.0, -1.0), (1.0, 1.0)] {
            let found = along(&|s| sign * 1e4 * (s - end).abs());
            let [(place, width)] = found[..] else { panic!("{found:?}") };
            assert!(place == end && (width - 0.01).abs() < 1e-12, "{found:?}");
            assert_eq!(along(&|s| -sign * 1e4 * (s - end).abs()), [(1.0 - end, 1e-4)]);
        }
    }

    /// The diagonal Padé approximation of e^-z that collocation at Lobatto's points makes of a mode.
    fn damping(order: Order, z: f64) -> f64 {
        let terms: &[f64] = match order {
            Order::Four => &[1.0, 1.0 / 2.0, 1.0 / 12.0],
            Order::Six | Order::SixGauss => &[1.0, 1.0 / 2.0, 1.0 / 10.0, 1.0 / 120.0],
            Order::Eight => &[1.0, 1.0 / 2.0, 3.0 / 28.0, 1.0 / 84.0, 1.0 / 1680.0],
        };
        let sum = |z: f64| terms.iter().rev().fold(0.0, |sum, term| sum * z + term);
        (sum(-z) / sum(z)).abs()
    }

    /// Over the intervals of a mesh that is made for it, a mode fades at every order, however thin its layer is.
    #[test]
    fn what_is_left_of_a_layer_fades_before_intervals_are_long() {
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            for width in [1e-3, 1e-5, 1e-7] {
                let mesh = uniform((0.0, 1.0), 8);
                let rough = Fineness { linear: true, ..Fineness::rough(order) };
                for fineness in [rough, Fineness::for_defects(order, 1e-5)] {
                    let layer = making(fineness).at_end(0.0, width);
                    let new = resolving(&mesh, &[layer], 10_000, fineness).unwrap();
                    let left: f64 = new.windows(2).map(|pair| damping(order, (pair[1] - pair[0]) / width)).product();
                    assert!(left < 10.0 * LEFT * width, "{order:?} {width:e}: {left:e} {new:?}");
                    assert!(new.len() < 80, "{order:?} {width:e}: {}", new.len());
                }
            }
        }
    }

    #[test]
    fn tighter_defects_ask_for_shorter_intervals_down_to_a_limit() {
        for order in [Order::Six, Order::Eight] {
            let of = |target| Fineness::for_defects(order, target).shortest;
            assert!(of(1e-2) == 1.0 && of(1e-4) < 0.8 && of(1e-6) < 0.6 * of(1e-4).sqrt(), "{order:?} {}", of(1e-6));
            assert_eq!(of(1e-9), of(1e-6));
        }
    }

    proptest! {
        #[test]
        fn meshes_resolve_layers_and_are_no_coarser_elsewhere(
            place in 0.0..1.0_f64,
            digits in 0.0..14.0_f64,
            intervals in 1_usize..40,
        ) {
            let fineness = Fineness::rough(Order::Four);
            let layer = making(fineness).at_turn(place, 10.0_f64.powf(-digits));
            let mesh = uniform((0.0, 1.0), intervals);
            let Some(new) = resolving(&mesh, &[layer], 10_000, fineness) else { panic!("refused") };
            prop_assert!(new.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert_eq!((new[0], new[new.len() - 1]), (0.0, 1.0));
            prop_assert!(new.len() < intervals + 250, "{}", new.len());
            for pair in new.windows(2) {
                let (length, distance) = (pair[1] - pair[0], (0.5 * (pair[0] + pair[1]) - place).abs());
                prop_assert!(length <= 1.001 / intervals as f64, "{length}");
                let most = 1.25 * layer.width + distance;
                prop_assert!(length <= most, "{length} at {distance} from {layer:?}");
            }
            prop_assert_eq!(resolving(&mesh, &[layer], intervals.saturating_sub(1), fineness), None);
        }
    }
}
