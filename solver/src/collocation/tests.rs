//! The linearisation against finite differences of the residual, and its elimination against a dense solve.

use super::coupled::Inward;
use super::defect::Defects;
use super::evaluate::{Derivatives, Work};
use super::factor::{Factorisation, Rhs};
use super::grid::Grid;
use super::interpolant::{Extended, Extension};
use super::plan::Plan;
use super::transpose::Weights;
use super::{Correction, Iterate, System};
use crate::by_region::ByRegion;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, W};
use crate::magnitude::Magnitudes;
use crate::measure::Error;
use crate::model::{Differentiated, Model, Scalar};
use crate::problem::{Layout, Problem, Region};
use crate::rows::Rows;
use crate::stats::Stats;
use crate::tableau::{GAUSS_6, ORDER_4, ORDER_6, ORDER_8, Tableau};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use std::sync::Arc;

/// Numbers that look random but are always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    }
}

/// A system whose right-hand sides, integrands and boundary equations mix everything, linearly or not.
struct Mixed {
    sizes: Vec<(usize, usize)>,
    constants: usize,
    nonlinear: bool,
    /// Whether of two states each the second is the derivative of the first.
    chained: bool,
    coefficients: Vec<f64>,
}

impl Mixed {
    fn new(sizes: &[(usize, usize)], constants: usize, (nonlinear, chained): (bool, bool), seed: u64) -> Self {
        let mut random = Random(seed);
        random.next();
        let coefficients = (0..4096).map(|_| random.next()).collect();
        Self { sizes: sizes.to_vec(), constants, nonlinear, chained, coefficients }
    }

    fn weight(&self, a: usize, b: usize, c: usize) -> f64 {
        self.coefficients[(a * 977 + b * 131 + c * 17) % self.coefficients.len()]
    }
}

impl Model for Mixed {
    fn layout(&self) -> Layout {
        let regions = self.sizes.iter().enumerate().map(|(r, &(n, k))| {
            let names: Vec<String> = (0..n).map(|i| format!("y{i}")).collect();
            let integrals: Vec<String> = (0..k).map(|i| format!("i{i}")).collect();
            let refs = |names: &'_ [String]| names.iter().map(String::as_str).map(str::to_owned).collect::<Vec<_>>();
            let (names, integrals) = (refs(&names), refs(&integrals));
            let interval = (r as f64, r as f64 + 1.0 + 0.3 * r as f64);
            Region::dense(
                &format!("r{r}"),
                interval,
                &names.iter().map(String::as_str).collect::<Vec<_>>(),
                &integrals.iter().map(String::as_str).collect::<Vec<_>>(),
                self.constants,
            )
        });
        let states: usize = self.sizes.iter().map(|size| size.0).sum();
        let constants: Vec<String> = (0..self.constants).map(|i| format!("c{i}")).collect();
        let equations: Vec<String> = (0..states + self.constants).map(|i| format!("e{i}")).collect();
        Layout::dense(
            regions.collect(),
            &constants.iter().map(String::as_str).collect::<Vec<_>>(),
            &equations.iter().map(String::as_str).collect::<Vec<_>>(),
        )
    }

    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        for (row, f) in f.iter_mut().enumerate() {
            *f = s * self.weight(region, row, 91);
            for (i, &y) in y.iter().enumerate() {
                let value = if self.nonlinear { (y * 0.7).sin() } else { y };
                *f += value * self.weight(region, row, i);
            }
            for (i, &c) in c.iter().enumerate() {
                let value = if self.nonlinear { c * (y[0] + 1.5) } else { c };
                *f += value * self.weight(region, row, 40 + i);
            }
        }
        if self.chained {
            for (f, y) in f[..y.len()].chunks_exact_mut(2).zip(y.chunks_exact(2)) {
                f[0] = y[1];
            }
        }
    }

    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        for (row, g) in g.iter_mut().enumerate() {
            *g = S::from(self.weight(7, row, 3));
            for (i, &z) in ends.iter().chain(integrals).chain(c).enumerate() {
                let value = if self.nonlinear { z + z * z * 0.1 } else { z };
                *g += value * self.weight(8, row, i);
            }
        }
    }
}

struct Setup<'a> {
    system: System<'a, Differentiated<Mixed>>,
    x: Iterate,
    work: Work,
}

fn setup<'a>(
    problem: &'a Differentiated<Mixed>,
    plan: Plan,
    intervals: &[usize],
    tableau: &'static Tableau,
    seed: u64,
) -> Setup<'a> {
    let layout = problem.layout();
    let mut random = Random(seed ^ 0x5555);
    let grids: Vec<Grid> = layout
        .regions
        .iter()
        .zip(intervals)
        .map(|(region, &intervals)| {
            let (a, b) = region.interval;
            let mut inner: Vec<f64> =
                (1..intervals).map(|j| a + (b - a) * (j as f64 + 0.3 * random.next()) / intervals as f64).collect();
            inner.insert(0, a);
            inner.push(b);
            Grid::new(inner)
        })
        .collect();
    let y = layout
        .regions
        .iter()
        .zip(&grids)
        .map(|(region, grid)| {
            (0..region.states.len())
                .flat_map(|_| {
                    let values: Vec<f64> = grid.mesh.iter().map(|_| random.next()).collect();
                    grid.pack(&values).to_vec()
                })
                .collect()
        })
        .collect();
    let constants = (0..layout.constants.len()).map(|_| random.next()).collect();
    let system = System {
        problem,
        layout,
        plan: Arc::new(plan),
        linear: false,
        tableau,
        magnitudes: Magnitudes::stated(layout),
        grids,
    };
    let work = system.work();
    Setup { system, x: Iterate { y, inner: ByRegion::default(), constants }, work }
}

/// With inner stages, where their states are unknowns, that follow from nodes and constants.
fn met(setup: &mut Setup<'_>, x: &Iterate) -> Iterate {
    let Setup { system, work, .. } = setup;
    let (mut x, mut stats) = (Iterate { inner: ByRegion::default(), ..x.clone() }, Stats::default());
    if system.tableau.coupled {
        system.complete(&mut x, &mut stats);
        system.evaluate(&x, Derivatives::None, work, &mut stats).unwrap();
        let psi = work.regions.iter().flat_map(|stages| &stages.psi);
        assert!(psi.fold(0.0, |max: f64, psi| max.max(psi.abs())) < 1e-12);
    }
    x
}

/// Residual in dimensionless equations, interval equations region by region and node by node, then boundary.
fn residual(setup: &mut Setup<'_>, x: &Iterate) -> Vec<f64> {
    let x = &met(setup, x);
    let Setup { system, work, .. } = setup;
    system.evaluate(x, Derivatives::None, work, &mut Stats::default()).unwrap();
    let mut out = Vec::new();
    for (region, grid) in system.grids.iter().enumerate() {
        let phi = &work.regions[region].phi;
        for j in 0..grid.intervals() {
            out.extend((0..system.plan.regions[region].n).map(|i| phi[i * grid.interval_stride() + grid.position(j)]));
        }
    }
    out.extend(&work.g);
    out
}

/// A direction in all unknowns, from a plain vector: nodes in order, then constants.
fn direction(system: &System<'_, Differentiated<Mixed>>, v: &[f64]) -> Correction {
    let mut rest = v;
    let u = system
        .grids
        .iter()
        .zip(&system.plan.regions)
        .map(|(grid, plan)| {
            let (mine, others) = rest.split_at(grid.mesh.len() * plan.n);
            rest = others;
            (0..grid.node_stride() / W)
                .flat_map(|t| (0..plan.n).map(move |i| (t, i)))
                .map(|(t, i)| Lane(std::array::from_fn(|l| mine[grid.index(t * W + l) * plan.n + i])))
                .collect()
        })
        .collect();
    Correction { u, inner: ByRegion::default(), c: rest.to_vec() }
}

fn flat(system: &System<'_, Differentiated<Mixed>>, dx: &Correction) -> Vec<f64> {
    let mut out = Vec::new();
    for ((grid, plan), u) in system.grids.iter().zip(&system.plan.regions).zip(&dx.u) {
        for j in 0..grid.mesh.len() {
            let p = grid.node(j);
            out.extend((0..plan.n).map(|i| u[p / W * plan.n + i].0[p % W]));
        }
    }
    out.extend(&dx.c);
    out
}

fn check(sizes: &[(usize, usize)], constants: usize, unknowns: usize, intervals: &[usize], nonlinear: bool, seed: u64) {
    let methods = [
        (&ORDER_4, false),
        (&ORDER_6, false),
        (&ORDER_6, true),
        (&ORDER_8, false),
        (&ORDER_8, true),
        (&GAUSS_6, false),
        (&GAUSS_6, true),
    ];
    for (tableau, chained) in methods {
        let mixed = Mixed::new(sizes, constants, (nonlinear, chained), seed);
        let problem = Differentiated::new(mixed).unwrap();
        let chosen: Vec<usize> = (0..unknowns).rev().collect();
        let plan = Plan::new(problem.layout(), &chosen);
        let mut setup = setup(&problem, plan, intervals, tableau, seed);
        let x = setup.x.clone();
        let x = met(&mut setup, &x);
        let size: usize =
            setup.system.grids.iter().zip(sizes).map(|(g, s)| g.mesh.len() * s.0).sum::<usize>() + unknowns;
        setup.system.evaluate(&x, Derivatives::Planned, &mut setup.work, &mut Stats::default()).unwrap();
        let mut factorisation = Factorisation::new(&setup.system);
        factorisation.factor(&setup.system, &setup.work, setup.system.scales(&x));
        let found = flat(&setup.system, &factorisation.newton_correction(&setup.system, &setup.work));
        check_transpose(&setup, &factorisation, seed);
        if tableau.coupled {
            check_stages(&setup, &factorisation, chained, seed);
        }
        if !nonlinear {
            one_step_suffices(&mut setup, &x, seed);
        }
        // The dense Newton matrix, column by column from differences of the residual.
        let base = residual(&mut setup, &x);
        let step = if nonlinear { 1e-6 } else { 1.0 };
        let mut matrix = DMatrix::zeros(size, size);
        for column in 0..size {
            let mut v = vec![0.0; size];
            v[column] = 1.0;
            let dx = direction(&setup.system, &v);
            let at = |factor: f64| setup.system.stepped(&x, &factorisation.scales, factor, &dx);
            let (plus, minus) = (at(step), at(-step));
            let (plus, minus) = (residual(&mut setup, &plus), residual(&mut setup, &minus));
            for row in 0..size {
                matrix[(row, column)] = (plus[row] - minus[row]) / (2.0 * step);
            }
        }
        let dense = matrix.lu().solve(&(-DVector::from_vec(base))).unwrap();
        let scale = dense.amax().max(1.0);
        let tolerance = if nonlinear { 1e-6 } else { 1e-9 };
        for (i, (a, b)) in found.iter().zip(dense.iter()).enumerate() {
            assert!((a - b).abs() <= tolerance * scale, "order {} unknown {i} of {size}: {a} {b}", tableau.order);
        }
    }
}

/// Newton's first step solves a linear problem, whatever the states at nodes and inner stages.
fn one_step_suffices(setup: &mut Setup<'_>, x: &Iterate, seed: u64) {
    let Setup { system, work, .. } = setup;
    let (mut x, mut random, mut stats) = (x.clone(), Random(seed ^ 0x1234), Stats::default());
    x.inner.iter_mut().flatten().for_each(|y| *y += random.next());
    system.evaluate(&x, Derivatives::Planned, work, &mut stats).unwrap();
    let mut factorisation = Factorisation::new(system);
    factorisation.factor(system, work, system.scales(&x));
    let dx = factorisation.newton_correction(system, work);
    let x = system.stepped(&x, &factorisation.scales, 1.0, &dx);
    system.evaluate(&x, Derivatives::None, work, &mut stats).unwrap();
    let scale = system.largest(&dx).max(1.0);
    for (stages, grid) in work.regions.iter().zip(&system.grids) {
        // Padding has no equations of its own.
        let rows =
            stages.phi.chunks_exact(grid.interval_stride()).chain(stages.psi.chunks_exact(grid.interval_stride()));
        for row in rows {
            assert!((0..grid.intervals()).all(|j| row[grid.position(j)].abs() < 1e-9 * scale), "{row:?}");
        }
    }
    assert!(work.g.iter().all(|g| g.abs() < 1e-9 * scale), "{:?}", work.g);
}

/// `w · solve(r) = solve_transposed(w) · r` for random weights and right-hand sides.
fn check_transpose(setup: &Setup<'_>, factorisation: &Factorisation, seed: u64) {
    let system = &setup.system;
    let mut random = Random(seed ^ 0xabcd);
    let mut values = |len: usize| -> Vec<f64> { (0..len).map(|_| random.next()).collect() };
    let rhs = Rhs {
        inner: ByRegion::default(),
        regions: system
            .grids
            .iter()
            .zip(&system.plan.regions)
            .map(|(grid, plan)| {
                (0..grid.steps * plan.n)
                    .map(|at| {
                        let values = values(W);
                        // Padding has no equations of its own.
                        Lane(std::array::from_fn(|l| {
                            if l * grid.steps + at / plan.n < grid.intervals() { values[l] } else { 0.0 }
                        }))
                    })
                    .collect()
            })
            .collect(),
        integrals: system.plan.regions.iter().map(|plan| values(plan.active.len()).into()).collect(),
        boundary: values(system.layout.equations.len()).into(),
    };
    let mut weights = Weights {
        unknowns: Correction {
            u: system
                .plan
                .regions
                .iter()
                .zip(&system.grids)
                .map(|(plan, grid)| Lanes::zeros((grid.steps + 1) * plan.n))
                .collect(),
            inner: ByRegion::default(),
            c: values(system.plan.unknowns.len()),
        },
        integrals: system.plan.regions.iter().map(|plan| Numbers::zeros(plan.active.len())).collect(),
    };
    for ((grid, plan), u) in system.grids.iter().zip(&system.plan.regions).zip(&mut weights.unknowns.u) {
        for j in 0..grid.mesh.len() {
            let p = if j == grid.intervals() { grid.last() } else { grid.position(j) };
            for (i, value) in values(plan.n).into_iter().enumerate() {
                u[p / W * plan.n + i].0[p % W] = value;
            }
        }
    }
    let dot = |a: &[Lanes], b: &[Lanes]| -> f64 {
        a.iter()
            .flatten()
            .zip(b.iter().flatten())
            .map(|(a, b)| a.0.iter().zip(b.0).map(|(a, b)| a * b).sum::<f64>())
            .sum()
    };
    let plain = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let solved = factorisation.solve(system, rhs.clone());
    let forward = dot(&weights.unknowns.u, &solved.u) + plain(&weights.unknowns.c, &solved.c);
    let transposed = factorisation.solve_transposed(system, weights);
    let backward = dot(&transposed.regions, &rhs.regions)
        + plain(&transposed.boundary, &rhs.boundary)
        + transposed.integrals.iter().zip(&rhs.integrals).map(|(a, b)| plain(a, b)).sum::<f64>();
    assert!((forward - backward).abs() <= 1e-9 * (1.0 + forward.abs()), "{forward} {backward}");
}

/// Equations of second order take one unknown a stage, and `w · solve(r) = solve_transposed(w) · r` for the stages'
/// equations.
fn check_stages(setup: &Setup<'_>, factorisation: &Factorisation, chained: bool, seed: u64) {
    let mut random = Random(seed ^ 0x77);
    for ((factor, grid), plan) in factorisation.regions.iter().zip(&setup.system.grids).zip(&setup.system.plan.regions)
    {
        let integrals = if chained { plan.n / 2 } else { 0 };
        assert_eq!(factor.coupling.roles.integrals.len(), integrals);
        assert_eq!(factor.coupling.roles.unknowns.len(), plan.n - integrals);
        let mut some = || -> Lanes {
            (0..grid.steps * factor.coupling.m).map(|_| Lane(std::array::from_fn(|_| random.next()))).collect()
        };
        let (right, mut weights) = (some(), some());
        let dot = |a: &Lanes, b: &Lanes| -> f64 { a.iter().zip(b).flat_map(|(a, b)| (*a * *b).0).sum() };
        let (mut solved, mut rhs) = (right.clone(), Lanes::zeros(grid.steps * plan.n));
        let mut functionals = vec![0.0; plan.active.len()];
        let inward = Inward {
            coupling: &factor.coupling,
            coupled: &factor.coupled,
            inner: &mut solved,
            rhs: &mut rhs,
            functionals: &mut functionals,
        };
        inward.vectorised();
        let forward = dot(&weights, &solved);
        factor.coupling.solve_stages_transposed(&factor.coupled, &mut weights);
        let backward = dot(&weights, &right);
        assert!((forward - backward).abs() <= 1e-9 * (1.0 + forward.abs()), "{forward} {backward}");
    }
}

/// The error that defects cause is linear in them: what a part of each causes, and what the rest does, are all of it.
#[test]
fn an_error_is_the_sum_of_what_parts_of_the_defects_cause() {
    for (tableau, chained) in
        [(&ORDER_4, false), (&ORDER_6, true), (&ORDER_8, true), (&ORDER_8, false), (&GAUSS_6, true), (&GAUSS_6, false)]
    {
        let mixed = Mixed::new(&[(2, 1), (3, 0)], 2, (true, chained), 11);
        let problem = Differentiated::new(mixed).unwrap();
        let plan = Plan::new(problem.layout(), &[0, 1]);
        let mut setup = setup(&problem, plan, &[9, 6], tableau, 3);
        let (x, mut stats) = (setup.x.clone(), Stats::default());
        let x = met(&mut setup, &x);
        setup.system.evaluate(&x, Derivatives::All, &mut setup.work, &mut stats).unwrap();
        setup.work.g.fill(0.0);
        let (system, work) = (&setup.system, &setup.work);
        let mut factorisation = Factorisation::new(system);
        factorisation.factor(system, work, system.scales(&x));
        let regions = work.regions.iter().enumerate();
        let judged = regions.map(|(region, stages)| {
            let extended = Extended { system, region, x: &x, stages };
            extended.judged(&factorisation.scales, f64::INFINITY, &mut stats).unwrap()
        });
        let (extensions, defects): (Vec<Extension>, Vec<Defects>) = judged.unzip();
        let error = |left: &[Numbers]| {
            Error::of(system, (&x, work), &factorisation, (&extensions, &defects), left, &mut Stats::default())
        };
        let mut random = Random(7);
        let parts: Vec<Numbers> =
            system.grids.iter().map(|grid| (0..grid.interval_stride()).map(|_| random.next()).collect()).collect();
        let rests: Vec<Numbers> = parts.iter().map(|part| part.iter().map(|part| 1.0 - part).collect()).collect();
        let (whole, part, rest) = (error(&[]), error(&parts), error(&rests));
        let all = |error: &Error| {
            let inner = error.correction.inner.iter().flatten().flat_map(|lane| lane.0);
            let integrals = error.integrals.iter().flat_map(Rows::iter).flatten().copied();
            flat(system, &error.correction).into_iter().chain(inner).chain(integrals).collect::<Vec<f64>>()
        };
        let (whole, part, rest) = (all(&whole), all(&part), all(&rest));
        let size = whole.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        for ((whole, part), rest) in whole.iter().zip(&part).zip(&rest) {
            assert!((whole - part - rest).abs() <= 1e-11 * size, "order {}: {whole} {part} {rest}", tableau.order);
        }
        assert!(whole.iter().zip(&part).any(|(whole, part)| (whole - part).abs() > 1e-3 * size));
    }
}

/// What corrects the continuous extension of order 8 solves linear equations exactly at its points: whether states are
/// all unknowns there, or some are found to be integrals of others, or all are in pairs.
#[test]
fn the_corrected_extension_meets_linear_equations_at_its_points() {
    for (n, integrals, constants, chained) in [
        (2, 0, 0, true),
        (4, 0, 0, true),
        (4, 2, 1, true),
        (2, 1, 2, true),
        (3, 1, 0, true),
        (5, 0, 2, true),
        (2, 0, 0, false),
        (3, 2, 1, false),
    ] {
        let mixed = Mixed::new(&[(n, integrals)], constants, (false, chained), 17 + n as u64);
        let problem = Differentiated::new(mixed).unwrap();
        let chosen: Vec<usize> = (0..constants).collect();
        let plan = Plan::new(problem.layout(), &chosen);
        let mut setup = setup(&problem, plan, &[7], &ORDER_8, 5);
        let (x, mut stats) = (setup.x.clone(), Stats::default());
        let x = met(&mut setup, &x);
        setup.system.evaluate(&x, Derivatives::Planned, &mut setup.work, &mut stats).unwrap();
        let (system, stages) = (&setup.system, &setup.work.regions[0]);
        assert_eq!(stages.roles.integrals.len(), if chained { n / 2 } else { 0 });
        let (extended, scales) = (Extended { system, region: 0, x: &x, stages }, system.scales(&x));
        let (mut extension, mut tally) = (extended.collocation_polynomial(), extended.tally());
        let mut lacking =
            |extension: &Extension| extended.lacking(extension, &scales.states[0], &mut tally, &mut stats).unwrap();
        let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let before = lacking(&extension);
        assert!(largest(&before) > 1e-6, "{n} states: nothing to correct");
        extended.correct(&mut extension, &scales.states[0], &before);
        let after = lacking(&extension);
        assert!(largest(&after) < 1e-12, "{n} states, {integrals} integrals: {:e}", largest(&after));
    }
}

#[test]
fn elimination_agrees_with_a_dense_solve_for_every_size() {
    // One and two equations of second order and nothing else.
    for (n, intervals) in [(2, 1), (2, 5), (2, 8), (4, 3), (4, 8), (4, 13)] {
        check(&[(n, 0)], 0, 0, &[intervals], false, 3 * n as u64 + intervals as u64);
        check(&[(n, 0)], 0, 0, &[intervals], true, 3 * n as u64 + intervals as u64);
    }
    for n in 1..=8 {
        for intervals in [1, 2, 3, 4, 5, 7, 8, 9, 13] {
            check(&[(n, 1)], 1, 1, &[intervals], false, 11 * n as u64 + intervals as u64);
        }
    }
    check(&[(2, 0), (5, 2), (1, 3)], 3, 3, &[6, 1, 11], false, 5);
    check(&[(4, 2), (3, 0)], 0, 0, &[5, 17], false, 6);
    check(&[(6, 0), (6, 1)], 2, 2, &[10, 3], false, 7);
}

#[test]
fn the_jacobian_is_the_derivative_of_the_residual() {
    check(&[(3, 1), (2, 2)], 2, 2, &[5, 6], true, 1);
    check(&[(7, 1)], 3, 3, &[6], true, 2);
    check(&[(1, 1), (4, 0), (5, 1)], 2, 2, &[3, 4, 9], true, 3);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]
    #[test]
    fn elimination_agrees_with_a_dense_solve(
        sizes in proptest::collection::vec((1_usize..6, 0_usize..3), 1..4),
        constants in 0_usize..4,
        intervals in proptest::collection::vec(1_usize..12, 3),
        seed in 0_u64..1000,
    ) {
        check(&sizes, constants, constants, &intervals, false, seed);
    }
}
