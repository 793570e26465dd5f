//! Inner stages that depend on each other: their states are unknowns, eliminated interval by interval.
//!
//! With `Y_i` the states at the inner stages and `ψ_i = Y_i - (1 - v_i) y_0 - v_i y_1 - h Σ_j x_ij K_j` their
//! residuals, the linearised stage equations of an interval
//!
//! ```text
//! dY_i - h Σ_j x_ij J_j dY_j = (1 - v_i + h x_i0 J_0) dy_0 + (v_i + h x_i1 J_1) dy_1 + h Σ_j x_ij ∂f_j/∂c dc - ψ_i
//! ```
//!
//! (j on the left over the inner stages) are solved for `dY = z + D [dy_0; dy_1; dc]`. What is left of the interval's
//! equations has nodes and constants only, and `h Σ_j b_j J_j z_j` on its right-hand side.
//!
//! An equation of second order is two states, of which one, u, has the other, v, for derivative. Its stage equations
//! say what `dU_i = h Σ_j x_ij dV_j + ...` is: put into those of the others they leave one unknown a stage, not two.

use super::grid::Grid;
use super::open_ends::OpenLanes;
use super::plan::RegionPlan;
use super::roles::Roles;
use super::stages::Stages;
use crate::linear::memory::Lanes;
use crate::linear::qr;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::tableau::{COUPLED, Tableau};
use std::sync::Arc;

/// The shape of one interval's share.
#[derive(Debug, Clone)]
pub(crate) struct Coupling {
    /// States at the interval's inner stages. 0 if they are functions of the nodes.
    pub m: usize,
    /// States.
    n: usize,
    /// Columns of D: both nodes, and the unknown constants.
    columns: usize,
    /// States and active integrals.
    all: usize,
    /// What each state is in the stage equations.
    pub roles: Arc<Roles>,
    /// Those of the method,
    pub weights: Weights<f64>,
    /// and where intervals have an open end.
    pub open: Vec<(OpenLanes, Weights<Lane>)>,
}

/// What the slopes at inner stages count for in one interval's equations, those at its nodes given or not.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weights<T> {
    /// x_ij, in the stage equations.
    pub x: [[T; COUPLED]; COUPLED],
    /// b_j, in the interval's own.
    pub b: [T; COUPLED],
    /// 1 / b_j.
    inverse: [T; COUPLED],
}

/// A number, or one a lane.
pub(crate) trait Weight: Copy {
    /// The product.
    fn of(self, value: Lane) -> Lane;
}

impl Weight for f64 {
    #[inline(always)]
    fn of(self, value: Lane) -> Lane {
        value.times(self)
    }
}

impl Weight for Lane {
    #[inline(always)]
    fn of(self, value: Lane) -> Lane {
        value * self
    }
}

impl Weights<f64> {
    /// Those of the method; zeros, where its inner stages are not coupled.
    fn new(tableau: &Tableau) -> Self {
        let mut weights = Self { x: [[0.0; COUPLED]; COUPLED], b: [0.0; COUPLED], inverse: [0.0; COUPLED] };
        if tableau.coupled {
            weights.x.iter_mut().zip(&tableau.x[2..]).for_each(|(weights, x)| weights.copy_from_slice(&x[2..]));
            weights.b.copy_from_slice(&tableau.b[2..]);
            weights.inverse = weights.b.map(|b| 1.0 / b);
        }
        weights
    }
}

impl Weights<Lane> {
    /// Slopes at open ends follow the others.
    fn open(tableau: &Tableau, lanes: &OpenLanes) -> Self {
        let [left, right] = &lanes.nodes;
        // What those at the nodes count for in one equation is added.
        let whole = |weights: &[f64], j: usize| {
            Lane([weights[j + 2]; W]) + left[j + 2].times(weights[0]) + right[j + 2].times(weights[1])
        };
        let b = std::array::from_fn(|j| whole(tableau.b, j));
        let x = std::array::from_fn(|i| std::array::from_fn(|j| whole(tableau.x[i + 2], j)));
        Self { x, b, inverse: b.map(Scalar::recip) }
    }
}

/// What is kept of one interval.
pub(crate) struct Parts<S> {
    /// The stage equations, factored.
    pub qr: S,
    /// D by columns of `m`.
    pub moves: S,
    /// `h b_j J_j` by columns of `all`, one a stage and state.
    pub slopes: S,
}

impl Coupling {
    pub(crate) fn new(tableau: &Tableau, plan: &RegionPlan) -> Self {
        let n = plan.n;
        Self {
            m: tableau.unknown_stages() * n,
            n,
            columns: 2 * n + plan.columns.len(),
            all: n + plan.active.len(),
            roles: Arc::default(),
            weights: Weights::new(tableau),
            open: Vec::new(),
        }
    }

    /// Says what is known of the stages since they were last evaluated.
    pub(super) fn adapt(&mut self, stages: &Stages, grid: &Grid, tableau: &Tableau) {
        self.roles = Arc::clone(&stages.roles);
        self.open.clear();
        // Where slopes at the nodes count for something.
        if tableau.coupled && tableau.b[0] != 0.0 {
            let open = OpenLanes::all(stages, grid, tableau).into_iter();
            self.open.extend(open.map(|lanes| {
                let weights = Weights::open(tableau, &lanes);
                (lanes, weights)
            }));
        }
    }

    /// What is different in interval `t` of every stretch, where one of these has an open end.
    #[inline(always)]
    pub(super) fn open(&self, t: usize) -> Option<&(OpenLanes, Weights<Lane>)> {
        self.open.iter().find(|(lanes, _)| lanes.t == t)
    }

    /// Values that are kept of one interval.
    pub(crate) fn len(&self) -> usize {
        qr::room(self.m) + self.m * (self.columns + self.all)
    }

    #[inline(always)]
    fn parts<'a, T>(&self, data: &'a [T]) -> Parts<&'a [T]> {
        let (qr, rest) = data.split_at(qr::room(self.m));
        let (moves, slopes) = rest.split_at(self.m * self.columns);
        Parts { qr, moves, slopes }
    }

    #[inline(always)]
    pub(crate) fn parts_mut<'a, T>(&self, data: &'a mut [T]) -> Parts<&'a mut [T]> {
        let (qr, rest) = data.split_at_mut(qr::room(self.m));
        let (moves, slopes) = rest.split_at_mut(self.m * self.columns);
        Parts { qr, moves, slopes }
    }

    /// Solves the stage equations of one interval in place, `q` unknowns a stage, `n` states, `all` rows. `unknowns`:
    /// room for those.
    #[inline(always)]
    pub(super) fn solve<T: Weight>(
        &self,
        weights: &Weights<T>,
        (q, n, all): (usize, usize, usize),
        (factored, slopes): (&[Lane], &[Lane]),
        unknowns: &mut [Lane],
        x: &mut [Lane],
    ) {
        let (m, weights, x) = (COUPLED * q, *weights, &mut x[..COUPLED * n]);
        if q == n {
            return qr::solve(m, factored, x);
        }
        let (slopes, unknowns) = (&slopes[..COUPLED * n * all], &mut unknowns[..m]);
        let rows = &self.roles.unknowns[..q];
        for i in 0..COUPLED {
            for (r, &row) in rows.iter().enumerate() {
                unknowns[i * q + r] = x[i * n + row];
            }
        }
        for &(u, _) in &self.roles.integrals {
            for j in 0..COUPLED {
                let known = x[j * n + u];
                for (r, &row) in rows.iter().enumerate() {
                    let moved = weights.entry(slopes, (n, all), (j, row, u)) * known;
                    for i in 0..COUPLED {
                        unknowns[i * q + r] += weights.x[i][j].of(moved);
                    }
                }
            }
        }
        qr::solve(m, factored, unknowns);
        for i in 0..COUPLED {
            for (r, &row) in rows.iter().enumerate() {
                x[i * n + row] = unknowns[i * q + r];
            }
        }
        for &(u, v) in &self.roles.integrals {
            let rise = weights.entry(slopes, (n, all), (0, u, v));
            for i in 0..COUPLED {
                for j in 0..COUPLED {
                    x[i * n + u] += weights.x[i][j].of(rise * x[j * n + v]);
                }
            }
        }
    }

    /// Solves the transposed stage equations of all intervals; `coupled`: what is kept of them, `weights`: `m` an
    /// interval.
    pub(super) fn solve_stages_transposed(&self, coupled: &[Lane], weights: &mut [Lane]) {
        let data = coupled.chunks_exact(self.len());
        for (t, (x, data)) in weights.chunks_exact_mut(self.m).zip(data).enumerate() {
            let parts = self.parts(data);
            match self.open(t) {
                None => self.solve_transposed(&self.weights, &parts, x),
                Some((_, weights)) => self.solve_transposed(weights, &parts, x),
            }
        }
    }

    /// Solves the transposed stage equations of one interval in place.
    fn solve_transposed<T: Weight>(
        &self,
        weights: &Weights<T>,
        Parts { qr: factored, slopes, .. }: &Parts<&[Lane]>,
        x: &mut [Lane],
    ) {
        let (q, n, all) = (self.roles.unknowns.len(), self.n, self.all);
        for &(u, v) in &self.roles.integrals {
            let rise = weights.entry(slopes, (n, all), (0, u, v));
            for j in 0..COUPLED {
                for i in 0..COUPLED {
                    let moved = weights.x[i][j].of(rise * x[i * n + u]);
                    x[j * n + v] += moved;
                }
            }
        }
        let at = (0..COUPLED).flat_map(|i| self.roles.unknowns.iter().map(move |row| i * n + row));
        let mut unknowns = Lanes::collected(COUPLED * q, at.clone().map(|at| x[at]));
        qr::solve_transposed(COUPLED * q, factored, &mut unknowns);
        at.zip(&unknowns).for_each(|(at, value)| x[at] = *value);
        for &(u, _) in &self.roles.integrals {
            for j in 0..COUPLED {
                for &row in &self.roles.unknowns {
                    let entry = weights.entry(slopes, (n, all), (j, row, u));
                    for i in 0..COUPLED {
                        let moved = weights.x[i][j].of(entry * x[i * n + row]);
                        x[j * n + u] += moved;
                    }
                }
            }
        }
    }
}

impl<T: Weight> Weights<T> {
    /// `h J_j`, the entry of a row and a state, as kept: by columns of `all`, `n` a stage.
    #[inline(always)]
    fn entry(&self, slopes: &[Lane], (n, all): (usize, usize), (j, row, state): (usize, usize, usize)) -> Lane {
        self.inverse[j].of(slopes[(j * n + state) * all + row])
    }
}

/// From the right-hand sides of the stage equations to z, and to what z adds to those of the intervals and integrals.
pub(super) struct Inward<'a> {
    pub coupling: &'a Coupling,
    /// What is kept, interval by interval.
    pub coupled: &'a [Lane],
    /// `m` an interval; on exit z.
    pub inner: &'a mut [Lane],
    /// `n` an interval.
    pub rhs: &'a mut [Lane],
    pub functionals: &'a mut [f64],
}

impl Inward<'_> {
    pub(super) fn vectorised(self) {
        vectorised(self);
    }
}

impl Job for Inward<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        // Compiled once more each where the sizes are those of one or two equations of second order, and of a branch of
        // one.
        let Coupling { roles, n, all, .. } = self.coupling;
        match (roles.unknowns.len(), *n, *all) {
            (1, 2, 2) => self.eliminate(1, 2, 2),
            (2, 4, 4) => self.eliminate(2, 4, 4),
            (1, 2, 3) => self.eliminate(1, 2, 3),
            (q, n, all) => self.eliminate(q, n, all),
        }
    }
}

/// Unknowns of an interval with two states,
const SMALL_M: usize = 2 * COUPLED;
/// and with four.
const MEDIUM_M: usize = 4 * COUPLED;

impl Inward<'_> {
    #[inline(always)]
    fn eliminate(self, q: usize, n: usize, all: usize) {
        let Self { coupling, coupled, .. } = self;
        let (mut sums, mut unknowns) = (Lanes::zeros(all - n), Lanes::unset(COUPLED * q));
        let steps = self.inner.chunks_exact_mut(COUPLED * n).zip(self.rhs.chunks_exact_mut(n));
        for (t, ((z, rhs), data)) in steps.zip(coupled.chunks_exact(coupling.len())).enumerate() {
            let Parts { qr, slopes, .. } = coupling.parts(data);
            let slopes = &slopes[..COUPLED * n * all];
            match coupling.open(t) {
                None => coupling.solve(&coupling.weights, (q, n, all), (qr, slopes), &mut unknowns, z),
                Some((_, weights)) => {
                    SolveOpen { coupling, weights, qr, slopes, unknowns: &mut unknowns, x: z }.vectorised();
                }
            }
            for (&z, slopes) in z.iter().zip(slopes.chunks_exact(all)) {
                for i in 0..n {
                    rhs[i] += slopes[i] * z;
                }
                for (sum, &slope) in sums.iter_mut().zip(&slopes[n..]) {
                    *sum += slope * z;
                }
            }
        }
        for (functional, sum) in self.functionals.iter_mut().zip(&sums) {
            *functional += sum.0.iter().sum::<f64>();
        }
    }
}

/// The stage equations of an interval of every stretch of which one has an open end: compiled once.
struct SolveOpen<'a> {
    coupling: &'a Coupling,
    weights: &'a Weights<Lane>,
    qr: &'a [Lane],
    slopes: &'a [Lane],
    unknowns: &'a mut [Lane],
    x: &'a mut [Lane],
}

impl SolveOpen<'_> {
    #[inline(never)]
    fn vectorised(self) {
        vectorised(self);
    }
}

impl Job for SolveOpen<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self { coupling, weights, qr, slopes, unknowns, x } = self;
        let sizes = (coupling.roles.unknowns.len(), coupling.n, coupling.all);
        coupling.solve(weights, sizes, (qr, slopes), unknowns, x);
    }
}

/// From z and the changes of nodes and constants to those of the inner stages.
pub(super) struct Outward<'a> {
    pub coupling: &'a Coupling,
    /// What is kept, interval by interval.
    pub coupled: &'a [Lane],
    /// `n` a node.
    pub u: &'a [Lane],
    pub constants: &'a [f64],
    /// `m` an interval: z, on exit dY.
    pub inner: &'a mut [Lane],
}

impl Outward<'_> {
    pub(super) fn vectorised(self) {
        vectorised(self);
    }
}

impl Job for Outward<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        match (self.coupling.m, self.coupling.n) {
            (SMALL_M, 2) => self.substitute(SMALL_M, 2),
            (MEDIUM_M, 4) => self.substitute(MEDIUM_M, 4),
            (m, n) => self.substitute(m, n),
        }
    }
}

impl Outward<'_> {
    #[inline(always)]
    fn substitute(self, m: usize, n: usize) {
        let Self { coupling, coupled, .. } = self;
        let data = coupled.chunks_exact(coupling.len());
        for (t, (inner, data)) in self.inner.chunks_exact_mut(m).zip(data).enumerate() {
            let moves = coupling.parts(data).moves;
            let (nodes, by_constant) = moves.split_at(2 * n * m);
            for (column, &u) in nodes.chunks_exact(m).zip(&self.u[t * n..(t + 2) * n]) {
                for i in 0..m {
                    inner[i] += column[i] * u;
                }
            }
            for (column, &c) in by_constant.chunks_exact(m).zip(self.constants) {
                for i in 0..m {
                    inner[i] += column[i].times(c);
                }
            }
        }
    }
}

/// Row by row in working order, `m * interval_stride`, to interval by interval in units of the scales.
pub(crate) fn scaled(values: &[f64], d: &[f64], m: usize, factor: f64) -> Lanes {
    let values = values.as_chunks::<W>().0;
    let mut out = Lanes::unset(values.len());
    for (row, values) in values.chunks_exact(values.len() / m).enumerate() {
        let factor = factor / d[row % d.len()];
        for (out, value) in out.chunks_exact_mut(m).zip(values) {
            out[row] = Lane(*value).times(factor);
        }
    }
    out
}

/// The reverse of [`scaled`].
pub(crate) fn unscaled(lanes: &[Lane], d: &[f64], m: usize) -> Vec<f64> {
    let steps = lanes.len() / m;
    let at = (0..m).flat_map(|row| (0..steps).map(move |t| (row, t)));
    at.flat_map(|(row, t)| lanes[t * m + row].times(d[row % d.len()]).0).collect()
}
