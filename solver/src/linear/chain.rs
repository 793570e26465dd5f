//! Elimination of a chain of blocks to its two ends by structured orthogonal factorisation (SQR).
//!
//! S. J. Wright, "Stable parallel algorithms for two-point boundary value problems", SIAM J. Sci. Stat.
//! Comput. 13 (1992) 742-764. The interval equations `A_t u_t + B_t u_{t+1} + C_t c = r_t` are combined two
//! block rows at a time: Householder reflections of the `2n x n` pivot block `[Q; A_t]` on `u_t` leave
//!
//! ```text
//! R u_t + E u_0 + F u_{t+1} + G c = r          (kept, for back substitution)
//!         P u_0 + Q u_{t+1} + C c = r          (the new carry)
//! ```
//!
//! Functionals `Σ_t (FA_t u_t + FB_t u_{t+1} + FC_t c)` are reduced with the same pivots, so that an integral
//! too becomes a combination of the two ends and the constants.

use super::memory::{Array, Kept as Reused};
use super::reflect::{Rows, make_reflector};
use super::scalar::{Lane, Scalar};

/// Sizes of a chain: `n` unknowns a node, `p` constants, `k` functionals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Sizes {
    pub n: usize,
    pub p: usize,
    pub k: usize,
}

/// Coefficients of one interval, or of a whole chain once reduced. `a`, `b`, `c` by columns of `n`;
/// functional rows `fa`, `fb` by rows of `n`, `fc` by rows of `p`.
pub(crate) struct Block<S> {
    pub a: S,
    pub b: S,
    pub c: S,
    pub fa: S,
    pub fb: S,
    pub fc: S,
}

fn block_len(Sizes { n, p, k }: Sizes) -> usize {
    (n + k) * (2 * n + p)
}

#[inline(always)]
fn block<T>(Sizes { n, p, k }: Sizes, data: &[T]) -> Block<&[T]> {
    let (a, rest) = data.split_at(n * n);
    let (b, rest) = rest.split_at(n * n);
    let (c, rest) = rest.split_at(n * p);
    let (fa, rest) = rest.split_at(k * n);
    let (fb, fc) = rest.split_at(k * n);
    Block { a, b, c, fa, fb, fc }
}

#[inline(always)]
fn block_mut<T>(Sizes { n, p, k }: Sizes, data: &mut [T]) -> Block<&mut [T]> {
    let (a, rest) = data.split_at_mut(n * n);
    let (b, rest) = rest.split_at_mut(n * n);
    let (c, rest) = rest.split_at_mut(n * p);
    let (fa, rest) = rest.split_at_mut(k * n);
    let (fb, fc) = rest.split_at_mut(k * n);
    Block { a, b, c, fa, fb, fc }
}

/// What back substitution keeps of one eliminated node.
struct Kept<S> {
    /// `n` reflectors of `2n`.
    reflectors: S,
    /// R by columns; entries below the diagonal are not defined.
    r: S,
    /// Reciprocals of R's diagonal.
    inverse: S,
    e: S,
    f: S,
    g: S,
    /// Multipliers of the functionals, by rows of `n`.
    x: S,
}

fn kept_len(Sizes { n, p, k }: Sizes) -> usize {
    5 * n * n + n + n * p + k * n
}

#[inline(always)]
fn kept<T>(Sizes { n, p, .. }: Sizes, data: &[T]) -> Kept<&[T]> {
    let (reflectors, rest) = data.split_at(2 * n * n);
    let (r, rest) = rest.split_at(n * n);
    let (inverse, rest) = rest.split_at(n);
    let (e, rest) = rest.split_at(n * n);
    let (f, rest) = rest.split_at(n * n);
    let (g, x) = rest.split_at(n * p);
    Kept { reflectors, r, inverse, e, f, g, x }
}

#[inline(always)]
fn kept_mut<T>(Sizes { n, p, .. }: Sizes, data: &mut [T]) -> Kept<&mut [T]> {
    let (reflectors, rest) = data.split_at_mut(2 * n * n);
    let (r, rest) = rest.split_at_mut(n * n);
    let (inverse, rest) = rest.split_at_mut(n);
    let (e, rest) = rest.split_at_mut(n * n);
    let (f, rest) = rest.split_at_mut(n * n);
    let (g, x) = rest.split_at_mut(n * p);
    Kept { reflectors, r, inverse, e, f, g, x }
}

/// Where a chain has its coefficients from. Not a closure: those cannot be told to be inlined, and on their own they
/// are compiled without the vectors of their caller.
pub(crate) trait Intervals<T: Reused> {
    /// Writes the coefficients of interval `t`. Must be `#[inline(always)]`.
    fn fill<R: Rows>(&mut self, rows: R, t: usize, block: &mut Block<&mut [T]>);
}

/// Chains reduced side by side, as the intervals of one more chain.
pub(crate) struct Reduced<'a>(pub Block<&'a [Lane]>);

impl Intervals<f64> for Reduced<'_> {
    #[inline(always)]
    fn fill<R: Rows>(&mut self, _: R, l: usize, to: &mut Block<&mut [f64]>) {
        let from = &self.0;
        let pairs = [
            (from.a, &mut to.a),
            (from.b, &mut to.b),
            (from.c, &mut to.c),
            (from.fa, &mut to.fa),
            (from.fb, &mut to.fb),
            (from.fc, &mut to.fc),
        ];
        for (from, to) in pairs {
            for (to, from) in to.iter_mut().zip(from) {
                *to = from.0[l];
            }
        }
    }
}

/// A factored chain.
#[derive(Debug, Clone)]
pub(crate) struct Chain<T: Reused> {
    sizes: Sizes,
    /// The whole chain, reduced; room for one interval; what is kept of every node.
    data: Array<T>,
}

impl<T: Reused> Chain<T> {
    pub(crate) fn new(sizes: Sizes, steps: usize) -> Self {
        Self { sizes, data: Array::unset(2 * block_len(sizes) + kept_len(sizes) * steps.saturating_sub(1)) }
    }

    pub(crate) fn sizes(&self) -> Sizes {
        self.sizes
    }

    /// The whole chain, reduced: `a u_0 + b u_steps + c constants = r`, and the functionals.
    #[inline(always)]
    pub(crate) fn end(&self) -> Block<&[T]> {
        block(self.sizes, &self.data[..block_len(self.sizes)])
    }

    /// What is kept of the interior nodes.
    #[inline(always)]
    fn nodes(&self) -> std::slice::ChunksExact<'_, T> {
        self.data[2 * block_len(self.sizes)..].chunks_exact(kept_len(self.sizes))
    }

    /// Reciprocals of all diagonal entries of R.
    pub(crate) fn inverse_pivots(&self) -> impl Iterator<Item = &T> {
        self.nodes().flat_map(|data| kept(self.sizes, data).inverse)
    }

    /// Eliminates the interior nodes `1..steps`.
    #[inline(always)]
    pub(crate) fn factor<R: Rows>(&mut self, rows: R, mut intervals: impl Intervals<T>) {
        let sizes = self.sizes;
        let (end, rest) = self.data.split_at_mut(block_len(sizes));
        let (next, nodes) = rest.split_at_mut(block_len(sizes));
        let (mut end, mut next) = (block_mut(sizes, end), block_mut(sizes, next));
        intervals.fill(rows, 0, &mut end);
        for (t, data) in nodes.chunks_exact_mut(kept_len(sizes)).enumerate() {
            intervals.fill(rows, t + 1, &mut next);
            eliminate(rows, sizes, kept_mut(sizes, data), &mut end, &mut next);
        }
    }

    /// Carries right-hand sides through the reflections: `rhs[t * n..]` belongs to interval `t` on entry; on
    /// exit to eliminated node `t + 1`, and the last to the reduced equation. `functionals` are added to.
    #[inline(always)]
    pub(crate) fn forward<R: Rows>(&self, rows: R, rhs: &mut [T], functionals: &mut [T]) {
        let n = rows.n();
        for (t, data) in self.nodes().enumerate() {
            let kept = kept(self.sizes, data);
            let (top, bottom) = rhs[t * n..(t + 2) * n].split_at_mut(n);
            rows.apply(kept.reflectors, n, top, bottom);
            for (functional, x) in functionals.iter_mut().zip(kept.x.chunks_exact(n)) {
                for i in 0..n {
                    *functional += x[i] * top[i];
                }
            }
        }
    }

    /// Fills the interior nodes of `u` (`(steps + 1) * n`), its first and last given, from what
    /// [`forward`](Self::forward) left.
    #[inline(always)]
    pub(crate) fn backward<R: Rows>(&self, rows: R, rhs: &[T], constants: &[T], u: &mut [T]) {
        let n = rows.n();
        for (t, data) in self.nodes().enumerate().rev() {
            let kept = kept(self.sizes, data);
            let (first, rest) = u.split_at_mut(n);
            let (here, next) = rest[t * n..(t + 2) * n].split_at_mut(n);
            here.copy_from_slice(&rhs[t * n..(t + 1) * n]);
            subtract(kept.e, first, here);
            subtract(kept.f, next, here);
            subtract(kept.g, constants, here);
            for i in (0..n).rev() {
                here[i] = here[i] * kept.inverse[i];
                let pivot = here[i];
                for (above, &r) in here[..i].iter_mut().zip(&kept.r[i * n..]) {
                    *above -= r * pivot;
                }
            }
        }
    }
}

impl<T: Reused> Chain<T> {
    /// Transpose of [`backward`](Self::backward): weights `u` on all nodes become weights on its inputs. On exit
    /// `u`'s first and last node and `constants` hold theirs, `rhs` (`steps * n`, overwritten) those of the
    /// eliminated nodes; its last block is left alone.
    #[inline(always)]
    pub(crate) fn backward_transposed<R: Rows>(&self, rows: R, rhs: &mut [T], constants: &mut [T], u: &mut [T]) {
        let n = rows.n();
        for (t, data) in self.nodes().enumerate() {
            let kept = kept(self.sizes, data);
            let (first, rest) = u.split_at_mut(n);
            let (here, next) = rest[t * n..(t + 2) * n].split_at_mut(n);
            for i in 0..n {
                let mut value = here[i];
                for (&r, &x) in kept.r[i * n..i * n + i].iter().zip(&here[..i]) {
                    value -= r * x;
                }
                here[i] = value * kept.inverse[i];
            }
            subtract_row(here, kept.e, first);
            subtract_row(here, kept.f, next);
            subtract_row(here, kept.g, constants);
            rhs[t * n..(t + 1) * n].copy_from_slice(here);
        }
    }

    /// Transpose of [`forward`](Self::forward): weights on what it leaves, in `rhs`, become weights on the interval
    /// equations; `functionals` are the weights of the functionals.
    #[inline(always)]
    pub(crate) fn forward_transposed<R: Rows>(&self, rows: R, rhs: &mut [T], functionals: &[T]) {
        let n = rows.n();
        for (t, data) in self.nodes().enumerate().rev() {
            let kept = kept(self.sizes, data);
            let (top, bottom) = rhs[t * n..(t + 2) * n].split_at_mut(n);
            for (&weight, x) in functionals.iter().zip(kept.x.chunks_exact(n)) {
                for i in 0..n {
                    top[i] += weight * x[i];
                }
            }
            rows.apply_transposed(kept.reflectors, top, bottom);
        }
    }
}

/// `out -= M x` for M by columns.
#[inline(always)]
fn subtract<T: Scalar>(matrix: &[T], x: &[T], out: &mut [T]) {
    for (column, &x) in matrix.chunks_exact(out.len()).zip(x) {
        for i in 0..out.len() {
            out[i] -= column[i] * x;
        }
    }
}

#[inline(always)]
fn eliminate<T: Scalar, R: Rows>(
    rows: R,
    sizes: Sizes,
    kept: Kept<&mut [T]>,
    carry: &mut Block<&mut [T]>,
    block: &mut Block<&mut [T]>,
) {
    let n = rows.n();
    for j in 0..n {
        let top = &mut carry.b[j * n..(j + 1) * n];
        let bottom = &mut block.a[j * n..(j + 1) * n];
        rows.apply(kept.reflectors, j, top, bottom);
        let diagonal = make_reflector(j, top, bottom, &mut kept.reflectors[j * 2 * n..(j + 1) * 2 * n]);
        top[j] = diagonal;
        kept.r[j * n..(j + 1) * n].copy_from_slice(top);
        kept.inverse[j] = diagonal.recip();
    }
    let all = &*kept.reflectors;
    for (e, p) in kept.e.chunks_exact_mut(n).zip(carry.a.chunks_exact_mut(n)) {
        e.copy_from_slice(p);
        p.fill(T::ZERO);
        rows.apply(all, n, e, p);
    }
    for ((f, q), b) in kept.f.chunks_exact_mut(n).zip(carry.b.chunks_exact_mut(n)).zip(block.b.chunks_exact(n)) {
        f.fill(T::ZERO);
        q.copy_from_slice(b);
        rows.apply(all, n, f, q);
    }
    for ((g, c), b) in kept.g.chunks_exact_mut(n).zip(carry.c.chunks_exact_mut(n)).zip(block.c.chunks_exact(n)) {
        g.copy_from_slice(c);
        c.copy_from_slice(b);
        rows.apply(all, n, g, c);
    }
    if sizes.k > 0 {
        eliminate_functionals(n, sizes.p, kept, carry, block);
    }
}

/// Replaces `u_t` in the functionals by the kept equation: `X = w R⁻¹`, then `row -= X [E F G]`.
#[inline(always)]
fn eliminate_functionals<T: Scalar>(
    n: usize,
    p: usize,
    kept: Kept<&mut [T]>,
    carry: &mut Block<&mut [T]>,
    block: &Block<&mut [T]>,
) {
    for (row, x) in kept.x.chunks_exact_mut(n).enumerate() {
        let span = row * n..(row + 1) * n;
        for c in 0..n {
            let mut value = carry.fb[row * n + c] + block.fa[row * n + c];
            for (&x, &r) in x[..c].iter().zip(&kept.r[c * n..]) {
                value -= x * r;
            }
            x[c] = value * kept.inverse[c];
        }
        carry.fb[span.clone()].copy_from_slice(&block.fb[span.clone()]);
        subtract_row(x, kept.e, &mut carry.fa[span.clone()]);
        subtract_row(x, kept.f, &mut carry.fb[span]);
        let constants = &mut carry.fc[row * p..(row + 1) * p];
        for (sum, &here) in constants.iter_mut().zip(&block.fc[row * p..(row + 1) * p]) {
            *sum += here;
        }
        subtract_row(x, kept.g, constants);
    }
}

/// `out -= x M` for M by columns.
#[inline(always)]
fn subtract_row<T: Scalar>(x: &[T], matrix: &[T], out: &mut [T]) {
    for (out, column) in out.iter_mut().zip(matrix.chunks_exact(x.len())) {
        for i in 0..x.len() {
            *out -= x[i] * column[i];
        }
    }
}
