//! Coefficients of the linearised interval equations: the chain rule through the stages.

mod pairs;
mod simpson;

use super::coupled::{Coupling, Parts, Weight, Weights};
use super::open_ends::OpenLanes;
use super::plan::RegionPlan;
use super::roles::{Role, Roles};
use super::stages::{MOST_STAGES, Stages, View};
use super::{Scales, System};
use crate::linear::chain::Block;
use crate::linear::memory::Lanes;
use crate::linear::qr;
use crate::linear::reflect::{BySize, Rows};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::problem::Problem;
use crate::tableau::{COUPLED, Tableau};
use pairs::Pairs;

/// Entries of a sparse Jacobian: where they stand, where they go, and the factor that makes them dimensionless.
#[derive(Debug, Clone)]
struct Entry {
    /// Index in the pattern.
    from: usize,
    row: usize,
    column: usize,
    factor: f64,
}

/// One region's linearised interval equations, in dimensionless unknowns, interval by interval.
pub(crate) struct Assembly<'a> {
    plan: &'a RegionPlan,
    tableau: &'static Tableau,
    /// Values at the stages.
    views: [View<'a>; MOST_STAGES],
    /// Interval lengths.
    h: &'a [[f64; W]],
    /// Typical magnitudes of the states.
    magnitudes: &'a [f64],
    /// Row by row.
    states: Vec<Entry>,
    constants: Vec<Entry>,
    /// dK: derivatives of the slopes of all rows with respect to the left node, the right one and the constants, one
    /// after the other in each row, stage by stage.
    slopes: Lanes,
    /// dY of one stage: the same of the states.
    arguments: Lanes,
    /// Sums of dK over the stages.
    sum: Lanes,
    /// Room for the unknowns at the inner stages of one interval.
    unknowns: Lanes,
    /// Room for the entries of the states at the inner stage of order 4.
    values: Lanes,
    /// States whose derivative is another, that other, and the factor that makes it dimensionless.
    chained: Vec<(usize, usize, f64)>,
}

/// The inner stages of one interval of every stretch. It is compiled once, and not for every number of states as what
/// it is called from: compiling those is what most of the crate's build time goes into.
struct Couple<'a, 'b> {
    assembly: &'a mut Assembly<'b>,
    t: usize,
    inner: Inner<'a>,
}

/// What is kept of the inner stages of one interval of every stretch, if their states are unknowns.
pub(crate) struct Inner<'a> {
    pub coupling: &'a Coupling,
    pub kept: &'a mut [Lane],
}

impl Inner<'_> {
    fn reborrowed(&mut self) -> Inner<'_> {
        Inner { coupling: self.coupling, kept: self.kept }
    }
}

impl Couple<'_, '_> {
    #[inline(never)]
    fn vectorised(self) {
        vectorised(self);
    }
}

impl Job for Couple<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { assembly, t, inner } = self;
        let (plan, coupling) = (assembly.plan, inner.coupling);
        let (q, sizes) = (coupling.roles.unknowns.len(), (plan.n, plan.active.len(), plan.columns.len()));
        if let Some((lanes, weights)) = coupling.open(t) {
            return assembly.differentiate_coupled(weights, Some(lanes), q, sizes, t, inner);
        }
        // Compiled once more for the sizes of a branch of one equation of second order in one constant.
        match (q, sizes) {
            (1, (2, 1, 1)) => assembly.differentiate_coupled(&coupling.weights, None, 1, (2, 1, 1), t, inner),
            _ => assembly.differentiate_coupled(&coupling.weights, None, q, sizes, t, inner),
        }
    }
}

/// The equations of one interval of every stretch.
struct Linearise<'a, 'b, 'c> {
    assembly: &'a mut Assembly<'b>,
    t: usize,
    block: &'a mut Block<&'c mut [Lane]>,
    inner: Inner<'a>,
}

impl BySize for Linearise<'_, '_, '_> {
    type Output = ();

    #[inline(always)]
    fn fixed<const N: usize>(self) {
        let Self { assembly, t, block, inner } = self;
        let (k, p) = (assembly.plan.active.len(), assembly.plan.columns.len());
        // Compiled once more where there are no integrals and constants, for one or two equations of second order.
        match (N, assembly.tableau.coupled) {
            (2 | 4, false) if k + p == 0 => assembly.linearise_alone::<N>(t, block),
            (_, false) if assembly.tableau.stages() == simpson::STAGES => assembly.linearise_simpson::<N>(t, block),
            _ => assembly.linearise((N, k, p), t, block, inner),
        }
    }

    #[inline(always)]
    fn any(self, n: usize) {
        let Self { assembly, t, block, inner } = self;
        assembly.linearise((n, assembly.plan.active.len(), assembly.plan.columns.len()), t, block, inner);
    }
}

impl<'a> Assembly<'a> {
    pub(crate) fn new<P: Problem + ?Sized>(
        system: &'a System<'_, P>,
        region: usize,
        stages: &'a Stages,
        scales: &'a Scales,
    ) -> Self {
        let plan = &system.plan.regions[region];
        let grid = &system.grids[region];
        let d = &scales.states[region];
        let row_scale = |row: usize| d.get(row).copied().unwrap_or(1.0);
        let states = plan.state_entries.iter();
        let constants = plan.constant_entries.iter();
        let constant_scale = |column: usize| scales.constants[system.plan.unknowns[plan.columns[column]]];
        Self {
            plan,
            tableau: system.tableau,
            views: stages.views(grid.steps),
            h: grid.h.as_chunks::<W>().0,
            magnitudes: d,
            states: states
                .map(|&(from, row, column)| Entry { from, row, column, factor: d[column] / row_scale(row) })
                .collect(),
            constants: constants
                .map(|&(from, row, column)| Entry {
                    from,
                    row,
                    column,
                    factor: constant_scale(column) / row_scale(row),
                })
                .collect(),
            slopes: Lanes::default(),
            arguments: Lanes::default(),
            sum: Lanes::default(),
            unknowns: Lanes::default(),
            values: Lanes::default(),
            chained: stages.chained.iter().map(|&(u, v)| (u, v, d[v] / d[u])).collect(),
        }
    }

    /// Room for sums along the way, which only equations need whose sizes are not all known when compiled.
    fn make_room(&mut self) {
        if self.slopes.is_empty() {
            let (plan, stages, n) = (self.plan, self.tableau.stages(), self.plan.n);
            let (rows, width) = (n + plan.active.len(), 2 * n + plan.columns.len());
            self.slopes = Lanes::unset(stages * rows * width);
            self.arguments = Lanes::unset(n * width);
            self.sum = Lanes::unset(rows * width);
            self.unknowns = Lanes::unset(self.tableau.unknown_stages() * n);
            self.values = Lanes::unset(if stages == simpson::STAGES { plan.state_entries.len() } else { 0 });
        }
    }

    /// Writes interval `t` of every stretch, its equations divided by `row_scale` (out, `n` entries) so that no
    /// coefficient of a node exceeds 1.
    #[inline(always)]
    pub(crate) fn fill<R: Rows>(
        &mut self,
        rows: R,
        t: usize,
        block: &mut Block<&mut [Lane]>,
        row_scale: &mut [Lane],
        inner: Inner<'_>,
    ) {
        rows.choose(Linearise { assembly: self, t, block, inner });
        scale_rows(rows.n(), self.plan.columns.len(), block, row_scale);
    }

    /// As [`linearise`](Self::linearise), where there are neither integrals nor constants and stages follow those
    /// before them: all sizes are known when compiled.
    #[inline(always)]
    fn linearise_alone<const N: usize>(&self, t: usize, block: &mut Block<&mut [Lane]>) {
        let h = Lane(self.h[t]);
        let stages = self.tableau.stages().min(MOST_STAGES);
        // By sides, stages, rows.
        let mut moves = [[[[Lane::ZERO; N]; N]; MOST_STAGES]; 2];
        moves[0][0] = self.jacobian(0, t);
        moves[1][1] = self.jacobian(1, t);
        for stage in 2..stages {
            let jacobian: [[Lane; N]; N] = self.jacobian(stage, t);
            let v = self.tableau.v[stage];
            for (side, (moves, own)) in moves.iter_mut().zip([1.0 - v, v]).enumerate() {
                let mut sum = [[Lane::ZERO; N]; N];
                for (earlier, &weight) in self.tableau.x[stage].iter().enumerate() {
                    // Neither node moves the other.
                    if weight != 0.0 && earlier != 1 - side {
                        add_times(&mut sum, h.times(weight), &moves[earlier]);
                    }
                }
                for (i, row) in sum.iter_mut().enumerate() {
                    row[i] += Lane::ONE.times(own);
                }
                if let Some(odd) = self.tableau.odd_part(stage) {
                    let sign = if side == 0 { -1.0 } else { 1.0 };
                    for &(u, v, factor) in &self.chained {
                        let (once, twice) = (h.times(-6.0 * odd), (h * h).times(sign * odd * factor));
                        for q in 0..N {
                            sum[u][q] += once * moves[side][u][q] + twice * moves[side][v][q];
                        }
                        sum[u][u] += Lane::ONE.times(12.0 * sign * odd);
                    }
                }
                for (row, by) in moves[stage].iter_mut().zip(&jacobian) {
                    for (by, argument) in by.iter().zip(&sum) {
                        for q in 0..N {
                            row[q] += *by * argument[q];
                        }
                    }
                }
            }
        }
        for (side, (moves, out)) in moves.iter().zip([&mut block.a, &mut block.b]).enumerate() {
            let mut sum = [[Lane::ZERO; N]; N];
            for (moves, &b) in moves.iter().zip(self.tableau.b).take(stages) {
                add_times(&mut sum, h.times(b), moves);
            }
            if self.tableau.has_odd_parts() {
                for &(u, v, factor) in &self.chained {
                    sum[u] = moves[side][u].map(|slope| h.times(0.5) * slope);
                    for (stage, moves) in moves.iter().enumerate().take(stages) {
                        let weight = (h * h).times(factor * self.tableau.twice_integrated(stage));
                        for q in 0..N {
                            sum[u][q] += weight * moves[v][q];
                        }
                    }
                }
            }
            for (i, row) in sum.iter().enumerate() {
                for (j, &value) in row.iter().enumerate() {
                    out[j * N + i] = -value;
                }
                out[i * N + i] += Lane::ONE.times(if side == 0 { -1.0 } else { 1.0 });
            }
        }
    }

    /// Derivatives of the right-hand side at one stage, dimensionless.
    #[inline(always)]
    fn jacobian<const N: usize>(&self, stage: usize, t: usize) -> [[Lane; N]; N] {
        let mut out = [[Lane::ZERO; N]; N];
        for entry in &self.states {
            out[entry.row][entry.column] += self.by_state(entry, stage, t);
        }
        out
    }

    /// The derivative of an entry of a state at a stage, dimensionless.
    #[inline(always)]
    fn by_state(&self, entry: &Entry, stage: usize, t: usize) -> Lane {
        self.views[stage].dy(entry.from, t).times(entry.factor)
    }

    /// `n` states, `k` active integrals, `p` constants.
    #[inline(always)]
    fn linearise(
        &mut self,
        (n, k, p): (usize, usize, usize),
        t: usize,
        block: &mut Block<&mut [Lane]>,
        mut inner: Inner<'_>,
    ) {
        if self.tableau.coupled && (Pairs { assembly: self, t, inner: inner.reborrowed(), block }).vectorised() {
            return;
        }
        self.make_room();
        let (h, all) = (Lane(self.h[t]), n + k);
        let known = if self.tableau.coupled { 2 } else { self.tableau.stages() };
        for stage in 0..known {
            self.differentiate_stage(n, all, p, t, stage, h);
        }
        if self.tableau.coupled {
            Couple { assembly: self, t, inner }.vectorised();
        }
        self.combine(n, all, p, h, block);
    }

    /// dK = J dY + dJ/dc of one stage.
    #[inline(always)]
    fn differentiate_stage(&mut self, n: usize, all: usize, p: usize, t: usize, stage: usize, h: Lane) {
        let (width, view) = (2 * n + p, self.views[stage]);
        let (known, rest) = self.slopes.split_at_mut(stage * all * width);
        let out = &mut rest[..all * width];
        out.fill(Lane::ZERO);
        for entry in &self.constants {
            out[entry.row * width + 2 * n + entry.column] += view.dc(entry.from, t).times(entry.factor);
        }
        if stage < 2 {
            for entry in &self.states {
                out[entry.row * width + stage * n + entry.column] += view.dy(entry.from, t).times(entry.factor);
            }
            return;
        }
        let arguments = &mut self.arguments[..n * width];
        arguments.fill(Lane::ZERO);
        for (known, &weight) in known.chunks_exact(all * width).zip(self.tableau.x[stage]) {
            if weight != 0.0 {
                add_row(h.times(weight), &known[..n * width], arguments);
            }
        }
        let v = self.tableau.v[stage];
        for i in 0..n {
            arguments[i * width + i] += Lane::ONE.times(1.0 - v);
            arguments[i * width + n + i] += Lane::ONE.times(v);
        }
        if let Some(odd) = self.tableau.odd_part(stage) {
            let nodes = [&known[..n * width], &known[all * width..][..n * width]];
            Odd { odd, chained: &self.chained, h }.add(n, width, nodes, arguments);
        }
        for entry in &self.states {
            let value = view.dy(entry.from, t).times(entry.factor);
            add_row(value, &arguments[entry.column * width..][..width], &mut out[entry.row * width..][..width]);
        }
    }

    /// dK of all inner stages, whose states are unknowns: see [`coupled`](super::coupled). `q` unknowns a stage, `n`
    /// states, `k` active integrals, `p` constants.
    #[inline(always)]
    fn differentiate_coupled<T: Weight>(
        &mut self,
        weights: &Weights<T>,
        open: Option<&OpenLanes>,
        q: usize,
        (n, k, p): (usize, usize, usize),
        t: usize,
        Inner { coupling, kept }: Inner<'_>,
    ) {
        let (h, all, width, m) = (Lane(self.h[t]), n + k, 2 * n + p, COUPLED * n);
        self.slopes[2 * all * width..].fill(Lane::ZERO);
        let Parts { qr, moves, slopes } = coupling.parts_mut(kept);
        slopes.fill(Lane::ZERO);
        let matrix = qr::matrix(COUPLED * q, qr);
        matrix.fill(Lane::ZERO);
        add_to_diagonal(matrix, COUPLED * q, 1.0);
        for j in 0..COUPLED {
            let view = self.views[j + 2];
            for entry in &self.constants {
                let at = ((j + 2) * all + entry.row) * width + 2 * n + entry.column;
                self.slopes[at] += view.dc(entry.from, t).times(entry.factor);
            }
            for entry in &self.states {
                let value = view.dy(entry.from, t).times(entry.factor) * h;
                slopes[(j * n + entry.column) * all + entry.row] += weights.b[j].of(value);
                if entry.row < n {
                    self.insert(weights, (q, &coupling.roles), (j, entry.row, entry.column), value, h, matrix);
                }
            }
        }
        qr::factor(COUPLED * q, qr);
        if let Some(open) = open {
            open.follow(all * width, &mut self.slopes);
        }
        self.move_stages(n, all, p, h, moves);
        for column in moves.chunks_exact_mut(m) {
            coupling.solve(weights, (q, n, all), (qr, slopes), &mut self.unknowns, column);
        }
        for j in 0..COUPLED {
            let view = self.views[j + 2];
            for entry in &self.states {
                let value = view.dy(entry.from, t).times(entry.factor);
                let (row, at) = (((j + 2) * all + entry.row) * width, j * n + entry.column);
                for q in 0..width {
                    self.slopes[row + q] += value * moves[q * m + at];
                }
            }
        }
        if let Some(open) = open {
            open.follow(all * width, &mut self.slopes);
        }
    }

    /// Takes `h J_j`, the entry of a row and a state, off the matrix of the stage equations.
    #[inline(always)]
    fn insert<T: Weight>(
        &self,
        weights: &Weights<T>,
        (q, roles): (usize, &Roles),
        (j, row, state): (usize, usize, usize),
        value: Lane,
        h: Lane,
        matrix: &mut [Lane],
    ) {
        let (m, x) = (COUPLED * q, weights.x);
        match (roles.of[row], roles.of[state]) {
            (Role::IntegralOf(_), _) => {}
            (Role::Unknown(row), Role::Unknown(column)) => {
                for i in 0..COUPLED {
                    matrix[(j * q + column) * m + i * q + row] -= x[i][j].of(value);
                }
            }
            (Role::Unknown(row), Role::IntegralOf(column)) => {
                let of = roles.unknowns[column];
                let moved = value * h.times(self.magnitudes[of] / self.magnitudes[state]);
                for l in 0..COUPLED {
                    let moved = x[j][l].of(moved);
                    for i in 0..COUPLED {
                        matrix[(l * q + column) * m + i * q + row] -= x[i][j].of(moved);
                    }
                }
            }
        }
    }

    /// The right-hand sides of the stage equations when nodes and constants move, by columns of `m`.
    #[inline(always)]
    fn move_stages(&self, n: usize, all: usize, p: usize, h: Lane, moves: &mut [Lane]) {
        let (m, width) = (COUPLED * n, 2 * n + p);
        for (q, column) in moves.chunks_exact_mut(m).enumerate() {
            // What nodes do to the slopes of inner stages is what is sought.
            let known = if q < 2 * n { 2 } else { COUPLED + 2 };
            for (i, column) in column.chunks_exact_mut(n).enumerate() {
                let (x, v) = (self.tableau.x[i + 2], self.tableau.v[i + 2]);
                for (row, out) in column.iter_mut().enumerate() {
                    let mut sum = Lane::ZERO;
                    for (j, &x) in x.iter().enumerate().take(known) {
                        sum += self.slopes[(j * all + row) * width + q].times(x);
                    }
                    *out = h * sum;
                }
                if q < 2 * n {
                    column[q % n] += Lane::ONE.times(if q < n { 1.0 - v } else { v });
                }
            }
        }
    }

    /// `A = -I - h Σ b dK/dy_0`, `B = I - h Σ b dK/dy_1`, `C = -h Σ b dK/dc`; functionals `h Σ b dQ`.
    #[inline(always)]
    fn combine(&mut self, n: usize, all: usize, p: usize, h: Lane, block: &mut Block<&mut [Lane]>) {
        let (width, sum) = (2 * n + p, &mut self.sum[..all * (2 * n + p)]);
        sum.fill(Lane::ZERO);
        for (slopes, &b) in self.slopes.chunks_exact(all * width).zip(self.tableau.b) {
            add_row(h.times(b), slopes, sum);
        }
        Twice { tableau: self.tableau, chained: &self.chained, all, h }.integrate(width, &self.slopes, sum);
        let (equations, functionals) = sum.split_at(n * width);
        for (i, row) in equations.chunks_exact(width).enumerate() {
            for j in 0..n {
                (block.a[j * n + i], block.b[j * n + i]) = (-row[j], -row[n + j]);
            }
            for j in 0..p {
                block.c[j * n + i] = -row[2 * n + j];
            }
        }
        for (i, row) in functionals.chunks_exact(width).enumerate() {
            block.fa[i * n..(i + 1) * n].copy_from_slice(&row[..n]);
            block.fb[i * n..(i + 1) * n].copy_from_slice(&row[n..2 * n]);
            block.fc[i * p..(i + 1) * p].copy_from_slice(&row[2 * n..]);
        }
        add_to_diagonal(block.a, n, -1.0);
        add_to_diagonal(block.b, n, 1.0);
    }
}

/// What order 6 adds at a stage to states whose derivative is another: see [`ODD`](crate::tableau::ODD).
struct Odd<'a> {
    odd: f64,
    chained: &'a [(usize, usize, f64)],
    h: Lane,
}

impl Odd<'_> {
    /// To dY, `sum`, for dK at both nodes, by rows of `width` for `n` states.
    #[inline(always)]
    fn add(&self, n: usize, width: usize, nodes: [&[Lane]; 2], sum: &mut [Lane]) {
        let once = self.h.times(-6.0 * self.odd);
        for (side, (slopes, sign)) in nodes.into_iter().zip([-1.0, 1.0]).enumerate() {
            for &(u, v, factor) in self.chained {
                let twice = (self.h * self.h).times(sign * self.odd * factor);
                let sum = &mut sum[u * width..][..width];
                add_row(twice, &slopes[v * width..][..width], sum);
                add_row(once, &slopes[u * width..][..width], sum);
                sum[side * n + u] += Lane::ONE.times(12.0 * sign * self.odd);
            }
        }
    }
}

/// The interval equations of such states.
struct Twice<'a> {
    tableau: &'a Tableau,
    chained: &'a [(usize, usize, f64)],
    all: usize,
    h: Lane,
}

impl Twice<'_> {
    /// In place of `h Σ b dK`, for all stages' dK by rows of `width`.
    #[inline(always)]
    fn integrate(&self, width: usize, slopes: &[Lane], sum: &mut [Lane]) {
        if !self.tableau.has_odd_parts() {
            return;
        }
        for &(u, v, factor) in self.chained {
            for q in 0..width {
                let of = |stage: usize, row: usize| slopes[(stage * self.all + row) * width + q];
                let mut total = self.h.times(0.5) * (of(0, u) + of(1, u));
                for stage in 0..self.tableau.stages() {
                    let weight = (self.h * self.h).times(factor * self.tableau.twice_integrated(stage));
                    total += weight * of(stage, v);
                }
                sum[u * width + q] = total;
            }
        }
    }
}

/// Divides the equations so that no coefficient of a node exceeds 1.
#[inline(always)]
fn scale_rows(n: usize, p: usize, block: &mut Block<&mut [Lane]>, row_scale: &mut [Lane]) {
    for (i, scale) in row_scale.iter_mut().enumerate() {
        let mut largest = Lane::ONE;
        for j in 0..n {
            largest = largest.or_larger(block.a[j * n + i].abs()).or_larger(block.b[j * n + i].abs());
        }
        *scale = largest.recip();
        for j in 0..n {
            block.a[j * n + i] = block.a[j * n + i] * *scale;
            block.b[j * n + i] = block.b[j * n + i] * *scale;
        }
        for j in 0..p {
            block.c[j * n + i] = block.c[j * n + i] * *scale;
        }
    }
}

/// `sum += weight * matrix`
#[inline(always)]
fn add_times<const N: usize>(sum: &mut [[Lane; N]; N], weight: Lane, matrix: &[[Lane; N]; N]) {
    for (sum, row) in sum.iter_mut().zip(matrix) {
        for q in 0..N {
            sum[q] += weight * row[q];
        }
    }
}

/// `out += value * row`
#[inline(always)]
fn add_row(value: Lane, row: &[Lane], out: &mut [Lane]) {
    for (out, argument) in out.iter_mut().zip(row) {
        *out += value * *argument;
    }
}

#[inline(always)]
fn add_to_diagonal(matrix: &mut [Lane], n: usize, value: f64) {
    for i in 0..n {
        matrix[i * n + i] += Lane::ONE.times(value);
    }
}
