//! Where the mesh must be finer, and where it may be coarser.
//!
//! The defect of the solution is measured as J. Kierzenka and L. F. Shampine do (ACM Trans. Math. Softw. 27 (2001)
//! 299-316), relative to the right-hand side, with one relaxation: where the right-hand side has a kink, the
//! defect falls only in proportion to the interval, but what it does to the solution falls with its square. As the
//! error is bounded by ∫|G| |defect| for a Green's function G, the defect is split into a part that is small
//! everywhere and one whose integral is small; both are held to the tolerance.

use crate::collocation::defect::Defects;
use crate::collocation::grid::Grid;
use crate::layers::{Layer, longest};
use crate::linear::memory::Numbers;
use crate::linear::scalar::W;
use crate::mesh::{distinct, equidistribute, grade, needed, split};

/// Defects aim at this fraction of the tolerance.
const SAFETY: f64 = 0.4;
/// At higher orders and where the problem is linear, intervals aim at this fraction of the length that would just do:
/// some more intervals cost less than one mesh more on which a few are still too long.
const SHORTER: f64 = 0.725;
/// A mesh with more than this many times the needed intervals is coarsened.
const GROSSLY: f64 = 4.0;
/// If at most this fraction of the intervals fails, they are split where they are.
const FEW: f64 = 0.1;
/// Parts of one interval at most: where they are no better than hoped for, they lower its defect to a 256th at order 4,
const MOST_PIECES: f64 = 4.0;
/// and to an 8,000th part at order 6, whose intervals are longer.
const MOST_PIECES_HIGH: f64 = 6.0;
/// Intervals grow at most by this factor: a small defect says little about much longer intervals.
const LONGER: f64 = 8.0;
/// Larger defects are far from the asymptotic regime: what they say of other lengths is not to be trusted.
pub(crate) const ASYMPTOTIC: f64 = 0.1;
/// How many times as many intervals there may be on the next mesh: within the asymptotic regime,
const GROWTH: f64 = 4.0;
/// outside of it,
const GROWTH_UNRESOLVED: f64 = 2.0;
/// and there at the higher orders, where a rough mesh has few intervals, if the problem is linear.
const GROWTH_LINEAR: f64 = 3.0;
/// On such a mesh of a linear problem, intervals whose defects are that large want to be divided by this,
const PIECES_UNRESOLVED: f64 = 8.0;
/// and others aim at this defect at least.
const ROUGH_GOAL: f64 = 1e-3;
/// Where no more than this fraction of the intervals is needed, all are redistributed, even if few fail.
const SPARSE: f64 = 0.6;
/// Exponent of the interval length in the defect at order 4.
const LOW: f64 = 4.0;
/// Fewest intervals that redistribution makes.
pub(crate) const FEWEST: usize = 4;

/// What a region's mesh should become.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Verdict {
    Keep,
    Coarsen(Vec<f64>),
    Refine(Vec<f64>),
    /// Refinement is needed, but the intervals are down to rounding or their number at its limit.
    Exhausted,
}

/// The measure of a region's defects that is held to the tolerance, and the intervals that exceed it.
#[derive(Debug, Clone)]
pub(crate) struct Measure {
    /// At most the tolerance if and only if the region passes.
    pub largest: f64,
    /// Interval of the largest relative defect among those not excused.
    pub worst: usize,
    /// Relative defects; those of excused intervals are set to the tolerance.
    defects: Vec<f64>,
}

impl Measure {
    /// Whether defects are far from the asymptotic regime on more than half of the intervals, so that they do not tell
    /// where the mesh is to be finer.
    pub(crate) fn is_rough_throughout(&self) -> bool {
        2 * self.defects.iter().filter(|&&defect| !(defect <= ASYMPTOTIC)).count() > self.defects.len()
    }

    /// Whether so few intervals exceed `target`, by which they are measured, that they are split where they are.
    pub(crate) fn exceeds_on_few(&self, target: f64) -> bool {
        let failing = self.defects.iter().filter(|&&defect| !(defect <= target)).count();
        failing as f64 <= FEW * self.defects.len() as f64 || failing <= 2
    }

    /// What is left of the defects of each interval, in working order, where none exceeds `target`.
    pub(crate) fn left(&self, grid: &Grid, target: f64) -> Numbers {
        let left = |p: usize| {
            let defect = self.defects[grid.index(p).min(self.defects.len() - 1)];
            if defect <= target { 1.0 } else { target / defect }
        };
        Numbers::collected(grid.interval_stride(), (0..grid.interval_stride()).map(left))
    }
}

/// Whether defects that rounding explains count.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rounding {
    Counted,
    /// Not those up to this size: finer meshes would only raise them.
    Excused(f64),
}

pub(crate) fn measure(defects: &Defects, tolerance: f64, rounding: Rounding) -> Measure {
    let known = |(&defect, &floor): (&f64, &f64)| match rounding {
        Rounding::Excused(most) if defect <= floor.min(most) => defect.min(tolerance),
        Rounding::Excused(_) | Rounding::Counted => defect,
    };
    let relative: Vec<f64> = defects.relative.iter().zip(&defects.rounding).map(known).collect();
    let mut controlled = relative.clone();
    let mut failing = Vec::with_capacity(controlled.iter().filter(|&&defect| !(defect <= tolerance)).count());
    failing.extend((0..controlled.len()).filter(|&j| !(controlled[j] <= tolerance)));
    failing.sort_by(|&i, &j| defects.contribution[i].total_cmp(&defects.contribution[j]));
    let mut integral = 0.0;
    for j in failing {
        if !(integral + defects.contribution[j] <= tolerance) {
            break;
        }
        integral += defects.contribution[j];
        controlled[j] = tolerance;
    }
    let worst = (0..controlled.len()).max_by(|&i, &j| controlled[i].total_cmp(&controlled[j])).unwrap_or(0);
    let excused = (0..controlled.len()).any(|j| relative[j] > controlled[j]);
    let largest = controlled.iter().zip(&relative).filter(|(c, r)| c == r);
    let largest = largest.fold(0.0_f64, |max, (c, _)| if c.is_nan() { f64::INFINITY } else { max.max(*c) });
    Measure { largest: if excused { largest.max(integral) } else { largest }, worst, defects: controlled }
}

/// What is wanted of a region's mesh.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wish<'a> {
    /// Largest defect.
    pub tolerance: f64,
    /// Exponent of the interval length in the defect.
    pub order: f64,
    pub max_intervals: usize,
    /// Whether intervals are split where they are if few are too long; if not, as that has not helped, all are
    /// redistributed, and there are no fewer.
    pub split_few: bool,
    /// Whether intervals are redistributed, even if few are too long, where far fewer would do.
    pub shrink: bool,
    /// Whether the problem is linear as far as is known: then no iteration can fail to follow from one mesh to the
    /// next.
    pub linear: bool,
    /// Layers that the solution may have, and that meshes have been made for.
    pub layers: &'a [Layer],
}

impl Wish<'_> {
    /// Whether meshes may be chosen freely: see [`linear`](Self::linear).
    fn is_free(&self) -> bool {
        self.linear && self.order > LOW
    }

    /// The fraction of the tolerance that defects aim at.
    fn safety(&self) -> f64 {
        if self.is_free() { libm::pow(SHORTER, self.order) } else { SAFETY }
    }
}

/// Decides on one region's mesh.
pub(crate) fn verdict(mesh: &[f64], measure: &Measure, wish: &Wish<'_>) -> Verdict {
    let &Wish { tolerance, order, max_intervals, split_few, shrink, .. } = wish;
    let intervals = mesh.len() - 1;
    if measure.largest <= tolerance {
        if intervals <= 4 * FEWEST || surely_fits(measure, wish) {
            return Verdict::Keep;
        }
        let (wanted, count) = wanted(mesh, measure, wish);
        let coarse = (1.2 * count) as usize;
        let grossly = intervals as f64 > GROSSLY * count;
        return if grossly { Verdict::Coarsen(equidistribute(mesh, &wanted, coarse)) } else { Verdict::Keep };
    }
    // Right after a redistribution, the intervals that still fail are all of the same kind.
    let few = split_few && measure.exceeds_on_few(tolerance);
    // Meshes that had to grow to find a layer are too fine elsewhere: at high orders it shows.
    let trusted = shrink && measure.largest <= ASYMPTOTIC;
    let lengths = (!few || trusted).then(|| wanted(mesh, measure, wish));
    let few = few && !lengths.as_ref().is_some_and(|(_, count)| trusted && *count < SPARSE * intervals as f64);
    let safety = wish.safety();
    let most_pieces = if order > LOW { MOST_PIECES_HIGH } else { MOST_PIECES };
    let split_into = |&defect: &f64| {
        if defect <= tolerance {
            1
        } else {
            libm::pow(defect / (safety * tolerance), 1.0 / order).ceil().clamp(2.0, most_pieces) as usize
        }
    };
    let pieces: Vec<usize> = if few { measure.defects.iter().map(split_into).collect() } else { Vec::new() };
    // What would be more intervals than may be is redistributed over as many as may be.
    let new = if few && (pieces.iter().sum::<usize>() <= max_intervals || intervals >= max_intervals) {
        split(mesh, &pieces)
    } else {
        let (mut wanted, count) = lengths.unwrap_or_else(|| wanted(mesh, measure, wish));
        let growth = match measure.largest > ASYMPTOTIC {
            false => GROWTH,
            true if wish.is_free() => GROWTH_LINEAR,
            true => GROWTH_UNRESOLVED,
        };
        let most = (growth * intervals as f64).min(max_intervals as f64);
        let least = (0.5 * intervals as f64).max(FEWEST as f64);
        // If splitting a few has not helped, defects within the asymptotic regime do not follow from lengths as they
        // should, and fewer intervals need not do.
        let more = count >= 0.9 * intervals as f64 || (!split_few && measure.largest <= ASYMPTOTIC);
        let target = if more { count.max(1.1 * intervals as f64 + 1.0) } else { count };
        // Where there may be no more intervals at all, those that others need are taken from wherever they are; and
        // where there is no layer to be spoiled, for what kinks ask for is more than is to be had.
        let spoiling = measure.largest > ASYMPTOTIC || !wish.layers.is_empty();
        if target > most && most < max_intervals as f64 && spoiling {
            divide_into_fewer(mesh, &mut wanted, most);
        }
        let count = target.clamp(least.min(most), most) as usize;
        // So many are worked on side by side: filling up costs nothing.
        let full = if wish.is_free() { count.next_multiple_of(W).min(max_intervals) } else { count };
        equidistribute(mesh, &wanted, full)
    };
    let new = distinct(new);
    if new.len() - 1 > max_intervals || (new.len() == mesh.len() && intervals >= max_intervals) || new == mesh {
        return Verdict::Exhausted;
    }
    Verdict::Refine(new)
}

/// The lengths that intervals are wanted to have where they stand, and how many of them there will be.
fn wanted(mesh: &[f64], measure: &Measure, wish: &Wish<'_>) -> (Vec<f64>, f64) {
    let &Wish { tolerance, order, .. } = wish;
    let intervals = mesh.len() - 1;
    let length = mesh[intervals] - mesh[0];
    let negligible = libm::pow(LONGER, -order);
    let goal = wish.safety() * tolerance;
    // What the mesh is to find first is where the solution varies: elsewhere it need not be good yet.
    let rough = wish.is_free() && measure.largest > ASYMPTOTIC;
    let goal = if rough { goal.max(ROUGH_GOAL) } else { goal };
    let length_of = |j: usize| {
        let excess = measure.defects[j] / goal;
        if rough && measure.defects[j] > ASYMPTOTIC {
            return (mesh[j + 1] - mesh[j]) / PIECES_UNRESOLVED;
        }
        (mesh[j + 1] - mesh[j]) * if excess > negligible { libm::pow(excess, -1.0 / order) } else { LONGER }
    };
    let mut wanted: Vec<f64> = (0..intervals).map(|j| length_of(j).min(length / FEWEST as f64)).collect();
    if !wish.layers.is_empty() {
        for (wanted, pair) in wanted.iter_mut().zip(mesh.windows(2)) {
            *wanted = wanted.min(longest(wish.layers, 0.5 * (pair[0] + pair[1])));
        }
    }
    grade(mesh, &mut wanted);
    let count = needed(mesh, &wanted).ceil();
    (wanted, count)
}

/// Where more than `most` intervals are wanted, lengthens those that are to be divided into the most, so that the rest
/// gets what it wants: what all have to give way by would be missing first where the mesh is fine enough already, as in
/// layers, and what they spoil then is the solution everywhere.
fn divide_into_fewer(mesh: &[f64], wanted: &mut [f64], most: f64) {
    let length = |j: usize| mesh[j + 1] - mesh[j];
    let mut pieces: Vec<f64> = wanted.iter().enumerate().map(|(j, wanted)| length(j) / wanted).collect();
    pieces.sort_unstable_by(f64::total_cmp);
    let (mut left, mut others) = (most, pieces.len());
    for pieces in pieces {
        if pieces * others as f64 >= left {
            break;
        }
        (left, others) = (left - pieces, others - 1);
    }
    let pieces = left / others.max(1) as f64;
    for (j, wanted) in wanted.iter_mut().enumerate() {
        *wanted = wanted.max(length(j) / pieces);
    }
    grade(mesh, wanted);
}

/// Whether a mesh is needed as it is without counting: half of its intervals may not grow to more than twice their
/// length, so that more than a quarter of their number is needed.
fn surely_fits(measure: &Measure, wish: &Wish<'_>) -> bool {
    let least = libm::pow(0.5 * GROSSLY, -wish.order) * 1.01 * wish.safety() * wish.tolerance;
    2 * measure.defects.iter().filter(|&&defect| defect >= least).count() >= measure.defects.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(relative: Vec<f64>, wish: &Wish<'_>) -> Measure {
        let (rounding, state) = (Numbers::zeros(relative.len()), vec![0; relative.len()]);
        // Whatever is too large moves the solution by more than the tolerance.
        let contribution = vec![1.0; relative.len()].into();
        let defects = Defects { relative: relative.into(), contribution, rounding, state, ..Defects::default() };
        measure(&defects, wish.tolerance, Rounding::Counted)
    }

    const WISH: Wish<'_> = Wish {
        tolerance: 1e-6,
        order: 4.0,
        max_intervals: 12,
        split_few: true,
        shrink: false,
        linear: false,
        layers: &[],
    };

    #[test]
    fn a_mesh_that_would_be_too_large_is_made_as_large_as_may_be() {
        let mesh: Vec<f64> = (0..=10).map(f64::from).collect();
        let mut relative = vec![1e-7; 10];
        relative[3] = 1.0;
        // Four parts of one interval would make thirteen.
        let Verdict::Refine(new) = verdict(&mesh, &measured(relative.clone(), &WISH), &WISH) else { panic!("refused") };
        assert_eq!(new.len() - 1, 12);
        let shortest = new.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        assert!(shortest < 0.5, "{new:?}");
        let room = Wish { max_intervals: 13, ..WISH };
        let split = verdict(&mesh, &measured(relative.clone(), &room), &room);
        assert!(matches!(split, Verdict::Refine(new) if new.len() - 1 == 13));
        let full = Wish { max_intervals: 10, ..WISH };
        assert_eq!(verdict(&mesh, &measured(relative, &full), &full), Verdict::Exhausted);
    }

    /// One interval is too long, and splitting it has not helped: there are not fewer for what the others' defects say.
    #[test]
    fn where_splitting_a_few_has_not_helped_there_are_more_intervals() {
        let mesh: Vec<f64> = (0..=16).map(f64::from).collect();
        let wish = Wish { split_few: false, max_intervals: 1_000, ..WISH };
        let mut relative = vec![1e-12; 16];
        relative[3] = 5e-6;
        let Verdict::Refine(new) = verdict(&mesh, &measured(relative, &wish), &wish) else { panic!("refused") };
        assert!((18..=20).contains(&(new.len() - 1)), "{}", new.len() - 1);
    }

    #[test]
    fn intervals_down_to_rounding_do_not_keep_others_from_being_split() {
        let next = 1.0 + 4.0 * f64::EPSILON;
        let mesh = vec![0.0, 0.5, 1.0, next, 1.5, 2.0];
        let Verdict::Refine(new) = verdict(&mesh, &measured(vec![1.0, 1e-7, 1.0, 1e-7, 1e-7], &WISH), &WISH) else {
            panic!("refused")
        };
        assert!(new.len() > mesh.len() && new.windows(2).all(|pair| pair[0] < pair[1]), "{new:?}");
        assert!(new.contains(&0.25), "{new:?}");
        // Where nothing can be split, there is nothing to be had.
        let verdict = verdict(&[1.0, next], &measured(vec![1.0], &WISH), &WISH);
        assert_eq!(verdict, Verdict::Exhausted);
    }

    /// One interval of eight asks for a hundred times what the mesh may have: the others stay as short as they are.
    #[test]
    fn what_a_mesh_may_not_have_is_missing_where_most_is_wanted() {
        let mesh: Vec<f64> = (0..=8).map(f64::from).collect();
        let mut relative = vec![0.4e-6; 8];
        relative[7] = 1e6;
        let wish = Wish { split_few: false, max_intervals: 1_000, ..WISH };
        let Verdict::Refine(new) = verdict(&mesh, &measured(relative, &wish), &wish) else { panic!("refused") };
        assert_eq!(new.len() - 1, 16);
        assert!(new[1..8].iter().filter(|&&s| s < 6.0).count() >= 5, "{new:?}");
        let mut wanted = vec![1.0, 0.5, 0.01, 0.02];
        divide_into_fewer(&[0.0, 1.0, 2.0, 3.0, 4.0], &mut wanted, 9.0);
        assert!(wanted.iter().zip([1.0, 0.5, 1.0 / 3.0, 1.0 / 3.0]).all(|(a, b)| (a - b).abs() < 1e-12), "{wanted:?}");
    }

    #[test]
    fn rounding_excuses_a_defect_up_to_a_limit_and_no_further() {
        let defects = |relative: f64| Defects {
            relative: vec![relative].into(),
            contribution: vec![1.0].into(),
            rounding: vec![1e-9].into(),
            state: vec![0],
            ..Defects::default()
        };
        let largest = |relative, rounding| measure(&defects(relative), 1e-12, rounding).largest;
        assert!(largest(5e-10, Rounding::Excused(1e-6)) <= 1e-12);
        assert_eq!(largest(5e-10, Rounding::Counted), 5e-10);
        assert_eq!(largest(2e-9, Rounding::Excused(1e-6)), 2e-9);
        assert_eq!(largest(5e-10, Rounding::Excused(1e-10)), 5e-10);
    }
}
