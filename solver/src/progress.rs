//! Where a solve stands between two meshes.

use crate::accuracy::Shortfall;
use crate::collocation::grid::intervals;
use crate::error::NewtonError;
use crate::layers::Layer;
use crate::measure::{Measures, Solved};
use crate::options::{Options, Order};
use crate::phase::Phase;
use crate::problem::Problem;
use crate::refine::{Measure, Rounding, measure};
use crate::start::{Start, halved, transfer, twice};
use std::rc::Rc;

/// State of one solve.
pub(crate) struct Progress<'a, P: Problem + ?Sized> {
    pub(crate) phase: Phase,
    /// Whether no mesh has been tried yet.
    pub(crate) first: bool,
    pub(crate) rescue: Rescue,
    /// What defects are held to at present.
    pub(crate) target: f64,
    /// What they are held to at first.
    pub(crate) tolerance: f64,
    /// What they aim at until they meet the tolerance, once the error has been foreseen: less than that, where it would
    /// exceed it.
    pub(crate) aim: Option<f64>,
    /// A solution that meets the tolerance, while a better one, or one on coarser meshes, is sought.
    pub(crate) fallback: Option<Solved<'a, P>>,
    /// Least estimated error so far that exceeds the tolerance: the fallback's.
    pub(crate) error: f64,
    /// Meshes since it last fell.
    pub(crate) stalled: usize,
    /// The solution that the present meshes were made from, while the tolerance is not met.
    coarser: Option<Solved<'a, P>>,
    pub(crate) fallback_doubled: bool,
    max_intervals: usize,
    /// Whether the present meshes are finer for the sake of integrals, of whose quadrature defects say nothing.
    pub(crate) for_integrals: bool,
    /// Whether meshes have had fewer intervals than those they were made from. Once is enough: what makes them grow
    /// again would do so again.
    pub(crate) shrunk: bool,
    /// The solution on the meshes that had more, while the tolerance is not met.
    before_shrinking: Option<Solved<'a, P>>,
    /// By region the layers that it may have and that its meshes are made for; none where they have not been sought,
    /// which is done once in a solve.
    pub(crate) layers: Vec<Option<Vec<Layer>>>,
    /// What the defects were held to on the last meshes that were too coarse, and the largest there.
    last_defect: Option<(f64, f64)>,
    /// Meshes in a row on which the largest defect has hardly fallen.
    creeping: usize,
    /// Whether a region's defects were far from the asymptotic regime on most of its intervals there.
    rough_throughout: bool,
}

/// A largest defect that is still more than this fraction of the last has hardly fallen: one halved interval brings a
/// factor of 16, a kink in it of 2.
const SLOW: f64 = 0.9;
/// After so many meshes in a row on which the largest defect hardly falls, splitting a few intervals more is given up:
/// those beside them will be next. All intervals are redistributed; once, as long as defects are held to the tolerance,
const CREEPING: usize = 2;
/// and until this many, where they are held to less: rounding is what is left of them then.
const STUCK: usize = 5;

impl<'a, P: Problem + ?Sized> Progress<'a, P> {
    pub(crate) fn new(options: &Options, regions: usize) -> Self {
        Self {
            phase: Phase::Search,
            first: true,
            rescue: Rescue {
                halvings: 0,
                refinements: 0,
                begun: false,
                insistent: true,
                origin: None,
                layers_sought: false,
                undefined: None,
                attempts: attempts(options),
            },
            target: options.tolerance,
            tolerance: options.tolerance,
            aim: None,
            fallback: None,
            error: f64::INFINITY,
            stalled: 0,
            coarser: None,
            fallback_doubled: false,
            max_intervals: options.max_intervals,
            for_integrals: false,
            shrunk: false,
            before_shrinking: None,
            layers: vec![None; regions],
            last_defect: None,
            creeping: 0,
            rough_throughout: false,
        }
    }

    /// Notes the largest defect on meshes that are too coarse.
    pub(crate) fn note(&mut self, measures: &[Measure]) {
        let largest = measures.iter().fold(0.0, |max: f64, measure| max.max(measure.largest));
        self.rough_throughout = measures.iter().any(Measure::is_rough_throughout);
        let slow = self.last_defect.is_some_and(|(target, last)| target == self.target && largest > SLOW * last);
        self.creeping = if slow { self.creeping + 1 } else { 0 };
        self.last_defect = Some((self.target, largest));
    }

    /// Whether the last meshes were finer than those before, and defects as large as before on most of their intervals:
    /// it may be rounding rather than the meshes.
    pub(crate) fn is_lost_in_rounding(&self) -> bool {
        self.creeping > 0 && self.rough_throughout
    }

    /// Whether a few intervals are to be split where only few are too long.
    pub(crate) fn split_few(&self) -> bool {
        let since = if self.target < self.tolerance { self.creeping } else { self.creeping % (CREEPING + 1) };
        since < CREEPING
    }

    /// Whether finer meshes do not lower the defects any more, although they meet the tolerance.
    pub(crate) fn is_stuck(&self) -> bool {
        self.target < self.tolerance && self.creeping >= STUCK
    }

    /// Rounding excuses defects only where they are held to less than the tolerance, and only up to the tolerance.
    pub(crate) fn rounding(&self) -> Rounding {
        self.rounding_at(self.target)
    }

    /// The same, for defects that are held to `target`.
    pub(crate) fn rounding_at(&self, target: f64) -> Rounding {
        if target < self.tolerance { Rounding::Excused(self.tolerance) } else { Rounding::Counted }
    }

    /// Notes the solution that the next meshes, of so many intervals, are made from while the tolerance is not met.
    pub(crate) fn refined_from(&mut self, solved: Solved<'a, P>, next: usize) {
        if next < intervals(&solved.system.grids) {
            self.shrunk = true;
            self.before_shrinking = Some(solved);
        } else {
            self.coarser = Some(solved);
        }
    }

    /// Notes that the tolerance is met.
    pub(crate) fn tolerance_met(&mut self) {
        (self.coarser, self.before_shrinking) = (None, None);
    }

    /// Where refined meshes have lost a solution: the one they were made from, on its own meshes doubled; once. Of
    /// meshes that were made smaller on the way, those before that: intervals that had become too long are what may
    /// have lost it.
    pub(crate) fn doubled(&mut self) -> Option<Start> {
        if let Some(coarser) = self.before_shrinking.take().or(self.coarser.take()) {
            return Some(transfer(&coarser, twice(&coarser)));
        }
        let doubled = self.fallback_doubled;
        let fallback = self.fallback.take_if(|_| !doubled)?;
        Some(self.double(fallback))
    }

    /// A solution that is gone back to, on its own meshes doubled, once: where smaller defects in a few intervals at a
    /// time bring hardly smaller errors, that does, unless what is left is due to rounding. Then, or if meshes may not
    /// have so many intervals, the solution itself; and which of both stands in the way of a smaller error.
    pub(crate) fn doubled_or_done(&mut self, fallback: Solved<'a, P>) -> (Next<'a, P>, Shortfall) {
        let fits = fallback.system.grids.iter().all(|grid| 2 * grid.intervals() <= self.max_intervals);
        match (self.fallback_doubled, fits) {
            (true, _) => (Next::done(fallback), Shortfall::Rounding),
            (false, false) => (Next::done(fallback), Shortfall::Mesh),
            (false, true) => (Next::On(self.double(fallback)), Shortfall::Rounding),
        }
    }

    fn double(&mut self, fallback: Solved<'a, P>) -> Start {
        let start = transfer(&fallback, twice(&fallback));
        (self.fallback, self.fallback_doubled) = (Some(fallback), true);
        start
    }
}

/// What is tried when Newton's iteration fails: halved meshes, then what is still to be tried from the guess.
pub(crate) struct Rescue {
    pub(crate) halvings: usize,
    /// How often the guess has been put on halved meshes, and all tried again.
    pub(crate) refinements: usize,
    /// Whether an iteration has begun: at a guess that is defined.
    pub(crate) begun: bool,
    /// Whether every step must be progress.
    pub(crate) insistent: bool,
    /// The guess, unless it was a solution already, or the problem is linear as far as is known. It is returned to,
    /// too, where its own mesh brought convergence and a finer one has not.
    pub(crate) origin: Option<Start>,
    /// Whether meshes for the layers that there may be beside the guess have been asked for.
    pub(crate) layers_sought: bool,
    /// What the order that is wanted last found undefined.
    pub(crate) undefined: Option<NewtonError>,
    /// Orders to begin with from the guess, and whether every step must be progress then.
    pub(crate) attempts: &'static [(Order, bool)],
}

impl Rescue {
    /// The guess on halved meshes, where all is tried again: what is undefined between the nodes of rough meshes need
    /// not be on finer ones. None if the guess itself is undefined.
    pub(crate) fn again(&mut self, options: &Options) -> Option<Start> {
        let origin = self.origin.as_ref().filter(|_| self.begun)?;
        let fits = origin.grids.iter().all(|grid| 2 * grid.intervals() <= options.max_intervals);
        if self.refinements >= options.rescues || !fits {
            return None;
        }
        let finer = halved(origin);
        self.refinements += 1;
        (self.halvings, self.insistent, self.attempts) = (0, true, attempts(options));
        self.origin = Some(finer.clone());
        Some(finer)
    }
}

/// What is tried from the guess after an iteration that insists on progress: another order finds where the one that is
/// wanted is to start from. Where one is led astray by layers that a rough mesh does not resolve, another may not be.
fn attempts(options: &Options) -> &'static [(Order, bool)] {
    match options.order {
        Order::Four if !options.other_orders => &[(Order::Four, false)],
        Order::Six if !options.other_orders => &[(Order::Six, false)],
        Order::Four => &[(Order::Eight, true), (Order::Four, false), (Order::Eight, false)],
        Order::Six => &[(Order::Eight, true), (Order::Six, false), (Order::Eight, false)],
        Order::SixGauss if !options.other_orders => &[(Order::SixGauss, false)],
        Order::SixGauss => &[(Order::Eight, true), (Order::SixGauss, false), (Order::Eight, false)],
        Order::Eight => &[(Order::Six, true), (Order::Six, false), (Order::Eight, false)],
    }
}

/// What one set of meshes has brought.
pub(crate) enum Found<'a, P: Problem + ?Sized> {
    /// A converged iterate, and the error estimated where it was asked for.
    Solved(Box<Solved<'a, P>>),
    /// None.
    Failed(Box<Failed>),
}

/// Why a set of meshes has brought nothing.
pub(crate) struct Failed {
    /// Where the iteration began, or where it converged to.
    pub(crate) start: Start,
    pub(crate) error: NewtonError,
    /// Whether it converged, to what is undefined between the collocation points.
    pub(crate) converged: bool,
}

/// How a solve goes on.
pub(crate) enum Next<'a, P: Problem + ?Sized> {
    On(Start),
    Done(Box<Solved<'a, P>>),
}

impl<'a, P: Problem + ?Sized> Next<'a, P> {
    pub(crate) fn done(solved: Solved<'a, P>) -> Self {
        Self::Done(Box::new(solved))
    }
}

/// The defects, as they are held to `target`: computed once for each.
pub(crate) fn measured<P: Problem + ?Sized>(solved: &Solved<'_, P>, target: f64, rounding: Rounding) -> Rc<[Measure]> {
    let mut known = solved.measures.borrow_mut();
    if let Some(known) = known.as_ref().filter(|known| known.target == target && known.rounding == rounding) {
        return Rc::clone(&known.all);
    }
    let all: Rc<[Measure]> = solved.defects.iter().map(|defects| measure(defects, target, rounding)).collect();
    *known = Some(Measures { target, rounding, all: Rc::clone(&all) });
    all
}
