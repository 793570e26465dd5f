//! The linearised equations at more points, solved for what the collocation polynomial lacks there.

use super::{OFFSETS, POINTS, PointWeights, STAGES};
use crate::basis::Basis;
use crate::collocation::roles::{Role, Roles};
use crate::collocation::stages::View;
use crate::linear::memory::Lanes;
use crate::linear::qr;
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};

/// Solves for E at the points, interval by interval, and adds what has these values to α to δ.
pub(super) struct Correct<'a> {
    pub pattern: &'a [(usize, usize)],
    /// Values at the stages.
    pub views: [View<'a>; STAGES],
    pub h: &'a [[f64; W]],
    pub scales: &'a [f64],
    pub weights: PointWeights,
    /// What each state is in the equations for E.
    pub roles: &'a Roles,
    /// Point by point, component by component in working order: the slopes wanted of E.
    pub lacking: &'a [[f64; W]],
    /// α, β, γ, δ.
    pub bump: [&'a mut [[f64; W]]; 4],
}

impl Correct<'_> {
    /// Not generic, so that it is compiled once and not with every problem.
    #[inline(never)]
    pub(super) fn vectorised(self) {
        vectorised(self);
    }

    /// Derivatives of one entry at the points, in vectors.
    #[inline(always)]
    fn derivatives(&self, entry: usize, t: usize) -> [Lane; POINTS] {
        let mut out = [Lane::ZERO; POINTS];
        for (stage, view) in self.views.iter().enumerate() {
            let known = view.dy(entry, t);
            for (out, weights) in out.iter_mut().zip(self.weights.of_stages) {
                *out += known.times(weights[stage]);
            }
        }
        out
    }
}

impl Job for Correct<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        // Compiled once more each where the sizes are those of one or two equations of second order.
        match (self.roles.unknowns.len(), self.scales.len()) {
            (1, 2) => self.solve(1, 2),
            (2, 4) => self.solve(2, 4),
            (q, n) => self.solve(q, n),
        }
    }
}

impl Correct<'_> {
    /// The slopes wanted of E, taken to the points: `values_of_slopes` times them, of state `i`.
    #[inline(always)]
    fn wanted(&self, i: usize, t: usize) -> [Lane; POINTS] {
        let (n, steps) = (self.scales.len(), self.h.len());
        let (mut out, factor) = ([Lane::ZERO; POINTS], 1.0 / self.scales[i]);
        for l in 0..POINTS {
            let lacking = Lane(self.lacking[(l * n + i) * steps + t]);
            for (out, weights) in out.iter_mut().zip(self.weights.of_slopes) {
                *out += lacking.times(weights[l]);
            }
        }
        out.iter_mut().for_each(|out| *out = out.times(factor));
        out
    }

    /// Finds E at the points, interval by interval: `q` unknowns a point, `n` states.
    #[inline(always)]
    fn solve(mut self, q: usize, n: usize) {
        let (m, steps) = (POINTS * q, self.h.len());
        let (roles, from_slopes) = (self.roles, self.weights.of_slopes);
        let mut room = Lanes::unset(qr::room(m) + POINTS * n + m);
        let (data, rest) = room.split_at_mut(qr::room(m));
        let (e, unknowns) = rest.split_at_mut(POINTS * n);
        for t in 0..steps {
            let h = Lane(self.h[t]);
            for i in 0..n {
                for (k, wanted) in self.wanted(i, t).into_iter().enumerate() {
                    e[k * n + i] = wanted;
                }
            }
            self.assemble((q, n), t, h, qr::matrix(m, data), e);
            qr::factor(m, data);
            for k in 0..POINTS {
                for (r, &row) in roles.unknowns.iter().enumerate() {
                    unknowns[k * q + r] = e[k * n + row];
                }
            }
            qr::solve(m, data, unknowns);
            for k in 0..POINTS {
                for (r, &row) in roles.unknowns.iter().enumerate() {
                    e[k * n + row] = unknowns[k * q + r];
                }
            }
            for &(u, v) in &roles.integrals {
                let rise = h.times(self.scales[v] / self.scales[u]);
                for (k, weights) in from_slopes.iter().enumerate() {
                    for (l, &weight) in weights.iter().enumerate() {
                        let risen = (rise * e[l * n + v]).times(weight);
                        e[k * n + u] += risen;
                    }
                }
            }
            for (i, &scale) in self.scales.iter().enumerate() {
                let mut bump = [Lane::ZERO; POINTS];
                bump.iter_mut().zip(e[i..].chunks(n)).for_each(|(bump, e)| *bump = e[0].times(scale));
                self.add(i * steps + t, bump);
            }
        }
    }

    /// The matrix of the equations for the unknowns among E at the points of one interval. What is known of the others,
    /// in `e`, goes to the right-hand sides there.
    #[inline(always)]
    fn assemble(&self, (q, n): (usize, usize), t: usize, h: Lane, matrix: &mut [Lane], e: &mut [Lane]) {
        let (m, roles, from_slopes) = (POINTS * q, self.roles, self.weights.of_slopes);
        matrix.fill(Lane::ZERO);
        for i in 0..m {
            matrix[i * m + i] = Lane::ONE;
        }
        for (entry, &(row, state)) in self.pattern.iter().enumerate().filter(|(_, (row, _))| *row < n) {
            let Role::Unknown(r) = roles.of[row] else { continue };
            let factor = h.times(self.scales[state] / self.scales[row]);
            let mut derivatives = self.derivatives(entry, t);
            derivatives.iter_mut().for_each(|derivative| *derivative = *derivative * factor);
            match roles.of[state] {
                Role::Unknown(column) => {
                    for (l, &value) in derivatives.iter().enumerate() {
                        for (k, weights) in from_slopes.iter().enumerate() {
                            matrix[(l * q + column) * m + k * q + r] -= value.times(weights[l]);
                        }
                    }
                }
                Role::IntegralOf(column) => {
                    let rise = h.times(self.scales[roles.unknowns[column]] / self.scales[state]);
                    for (j, &value) in derivatives.iter().enumerate() {
                        let (known, moved) = (value * e[j * n + state], value * rise);
                        for (k, weights) in from_slopes.iter().enumerate() {
                            e[k * n + row] += known.times(weights[j]);
                            let moved = moved.times(weights[j]);
                            for (l, &weight) in from_slopes[j].iter().enumerate() {
                                matrix[(l * q + column) * m + k * q + r] -= moved.times(weight);
                            }
                        }
                    }
                }
            }
        }
    }

    /// Adds what has the values `e` at the points.
    #[inline(always)]
    fn add(&mut self, at: usize, e: [Lane; POINTS]) {
        let square = OFFSETS.map(|t| t * t);
        // a + c τ² and b + d τ² at both offsets, and from them a, b, c, d.
        let bump = OFFSETS.map(|t| Basis::value(0.5 + t).alpha);
        let (mut even, mut odd) = ([Lane::ZERO; 2], [Lane::ZERO; 2]);
        for k in 0..2 {
            even[k] = (e[k + 2] + e[k]).map(|sum| 0.5 * sum / bump[k]);
            odd[k] = (e[k + 2] - e[k]).map(|difference| 0.5 * difference / (bump[k] * OFFSETS[k]));
        }
        let bend = |at: [Lane; 2]| (at[1] - at[0]).map(|rise| rise / (square[1] - square[0]));
        let (even_bend, odd_bend) = (bend(even), bend(odd));
        let [alpha, beta, gamma, delta] = &mut self.bump;
        alpha[at] = (Lane(alpha[at]) + even[0] - even_bend.times(square[0])).0;
        beta[at] = (Lane(beta[at]) + odd[0] - odd_bend.times(square[0])).0;
        (gamma[at], delta[at]) = (even_bend.0, odd_bend.0);
    }
}
