//! The demos, solved here.

use crate::Run;
use crate::demos::{Demo, Located, Stated, Wanted};
use solver::continuation::{Branch, BranchOptions, BranchPoint, EventFunction, PointKind, trace_observed};
use solver::{Event, Options, Order, Solution};
use std::fmt;
use std::ops::ControlFlow;
use std::time::Instant;

#[derive(Debug, Clone, Copy)]
pub struct Configuration {
    pub order: Order,
    pub tolerance: f64,
    pub intervals: usize,
    pub largest_step: f64,
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { order, tolerance, intervals, largest_step } = self;
        write!(f, "order {}, {tolerance:.0e}, from {intervals}, step {largest_step}", order.number())
    }
}

pub fn configurations(demo: &Demo) -> Vec<Configuration> {
    let mut all = Vec::new();
    for order in [Order::Four, Order::Six, Order::Eight] {
        for digits in 3..=11 {
            for intervals in [4, 8, 12, 16, 24, 32, 48] {
                all.extend(demo.largest_steps_here.iter().map(|&largest_step| Configuration {
                    order,
                    tolerance: 10.0_f64.powi(-digits),
                    intervals,
                    largest_step,
                }));
            }
        }
    }
    all
}

/// What is to be located, at much tighter settings.
pub fn reference(demo: &'static Demo) -> Option<Located> {
    let tight = Configuration { order: Order::Eight, tolerance: 1e-12, intervals: 32, largest_step: 0.1 };
    trace(demo, &tight).map(|points| located(&points))
}

/// `None` if the branch is lost.
pub fn run(demo: &'static Demo, configuration: &Configuration, reference: &Located) -> Option<Run> {
    let begun = Instant::now();
    let points = trace(demo, configuration)?;
    let seconds = begun.elapsed().as_secs_f64();
    Some(Run { seconds, error: demo.wanted.error(&located(&points), reference), points: points.len() })
}

fn located(points: &[BranchPoint]) -> Located {
    let of = |kind: PointKind| points.iter().filter(move |point| point.kind == kind);
    Located {
        folds: of(PointKind::Fold).map(|point| point.parameter).collect(),
        met: of(PointKind::Event(0)).map(|point| [point.parameter, slope(&point.solution)]).collect(),
        branch_points: of(PointKind::BranchPoint).map(|point| point.parameter).collect(),
    }
}

fn slope(solution: &Solution) -> f64 {
    solution.regions()[0].state(1)[0]
}

fn trace(demo: &'static Demo, configuration: &Configuration) -> Option<Vec<BranchPoint>> {
    let &Configuration { order, tolerance, intervals, largest_step } = configuration;
    let problem = Stated::new(demo);
    let solve = Options { order, tolerance, ..Options::default() };
    let options = BranchOptions { solve, largest_step, ..BranchOptions::default() };
    let start = problem.start(intervals);
    match demo.wanted {
        Wanted::Fold { at, .. } => {
            let met = |solution: &Solution| solution.constants()[0] - at;
            let events: [EventFunction<'_>; 1] = [&met];
            // The branch ends where the value has been met for the second time.
            let mut above = false;
            let mut stop = |event: &Event| match *event {
                Event::Step { lambda, .. } if above && lambda < at => ControlFlow::Break(()),
                Event::Step { lambda, .. } => {
                    above |= lambda > at;
                    ControlFlow::Continue(())
                }
                _ => ControlFlow::Continue(()),
            };
            let options = BranchOptions { branch_points: false, ..options };
            match trace_observed(&problem, &start, 0, &[], &options, &events, &mut stop) {
                Ok(Branch { .. }) => None,
                Err(ended) => above.then_some(ended.points),
            }
        }
        Wanted::BranchPoints { to, .. } => {
            // On the mesh and in the steps that the configuration says, as AUTO does.
            let options = BranchOptions {
                range: (0.0, to),
                settle_branch_points: false,
                resolve_branch_points: false,
                ..options
            };
            let mut silent = |_: &Event| ControlFlow::Continue(());
            trace_observed(&problem, &start, 0, &[], &options, &[], &mut silent).ok().map(|branch| branch.points)
        }
    }
}
