//! The interval equations of order 4 (Hermite-Simpson), whose one inner stage follows from the nodes: what
//! [`Assembly::linearise`] does for any method, for a number of states that is known when compiled. Derivatives at the
//! nodes are put where they belong entry by entry, and each row of those at the stage is summed up in registers.

use super::{Assembly, add_row, add_to_diagonal};
use crate::linear::chain::Block;
use crate::linear::scalar::{Lane, Scalar};

/// Stages.
pub(super) const STAGES: usize = 3;
/// Where the inner one stands among them.
const INNER: usize = 2;

impl Assembly<'_> {
    /// Writes interval `t` of every stretch. `N` states.
    #[inline(always)]
    pub(super) fn linearise_simpson<const N: usize>(&mut self, t: usize, block: &mut Block<&mut [Lane]>) {
        self.make_room();
        let mut values = std::mem::take(&mut self.values);
        for (value, entry) in values.iter_mut().zip(&self.states) {
            *value = self.by_state(entry, INNER, t);
        }
        self.write_by_states::<N>(t, &values, block);
        if !self.plan.columns.is_empty() {
            self.write_by_constants::<N>(t, &values, block);
        }
        self.values = values;
    }

    /// Coefficients of the states at both nodes, with the entries' `values` at the inner stage.
    #[inline(always)]
    fn write_by_states<const N: usize>(&self, t: usize, mut values: &[Lane], block: &mut Block<&mut [Lane]>) {
        let (h, method) = (Lane(self.h[t]), self.tableau);
        // What the states at the inner stage move by with those at each node.
        let mut moves = [[[Lane::ZERO; N]; 2]; N];
        for node in 0..2 {
            let weight = h.times(method.x[INNER][node]);
            for entry in &self.states {
                if let Some(moves) = moves.get_mut(entry.row) {
                    moves[node][entry.column] += weight * self.by_state(entry, node, t);
                }
            }
        }
        let v = method.v[INNER];
        for (state, [left, right]) in moves.iter_mut().enumerate() {
            left[state] += Lane::ONE.times(1.0 - v);
            right[state] += Lane::ONE.times(v);
        }
        let mut nodes = [(&mut block.a, &mut block.fa), (&mut block.b, &mut block.fb)];
        let (weight, mut entries) = (h.times(method.b[INNER]), self.states.as_slice());
        for row in 0..N + self.plan.active.len() {
            let count = entries.iter().take_while(|entry| entry.row == row).count();
            let ((own, rest), (own_values, rest_values)) = (entries.split_at(count), values.split_at(count));
            (entries, values) = (rest, rest_values);
            for (node, (equations, functionals)) in nodes.iter_mut().enumerate() {
                let mut sum = [Lane::ZERO; N];
                for (entry, &value) in own.iter().zip(own_values) {
                    for (sum, &moved) in sum.iter_mut().zip(&moves[entry.column][node]) {
                        *sum += value * moved;
                    }
                }
                for (j, &slope) in sum.iter().enumerate() {
                    let value = weight * slope;
                    match row.checked_sub(N) {
                        Some(row) => functionals[row * N + j] = value,
                        None => equations[j * N + row] = -value,
                    }
                }
            }
        }
        for (node, (equations, functionals)) in nodes.into_iter().enumerate() {
            let weight = h.times(method.b[node]);
            for entry in &self.states {
                let value = weight * self.by_state(entry, node, t);
                match entry.row.checked_sub(N) {
                    Some(row) => functionals[row * N + entry.column] += value,
                    None => equations[entry.column * N + entry.row] -= value,
                }
            }
            add_to_diagonal(equations, N, if node == 0 { -1.0 } else { 1.0 });
        }
    }

    /// Coefficients of the constants, likewise.
    #[inline(always)]
    fn write_by_constants<const N: usize>(&mut self, t: usize, values: &[Lane], block: &mut Block<&mut [Lane]>) {
        let (h, method, p) = (Lane(self.h[t]), self.tableau, self.plan.columns.len());
        let all = N + self.plan.active.len();
        let (moves, slopes, sum) =
            (&mut self.arguments[..N * p], &mut self.slopes[..all * p], &mut self.sum[..all * p]);
        moves.fill(Lane::ZERO);
        slopes.fill(Lane::ZERO);
        sum.fill(Lane::ZERO);
        for (node, view) in self.views.iter().enumerate().take(2) {
            let (weight, moved) = (h.times(method.b[node]), h.times(method.x[INNER][node]));
            for entry in &self.constants {
                let (value, at) = (view.dc(entry.from, t).times(entry.factor), entry.row * p + entry.column);
                sum[at] += weight * value;
                if let Some(moves) = moves.get_mut(at) {
                    *moves += moved * value;
                }
            }
        }
        let view = self.views[INNER];
        for entry in &self.constants {
            slopes[entry.row * p + entry.column] += view.dc(entry.from, t).times(entry.factor);
        }
        for (entry, &value) in self.states.iter().zip(values) {
            add_row(value, &moves[entry.column * p..][..p], &mut slopes[entry.row * p..][..p]);
        }
        add_row(h.times(method.b[INNER]), slopes, sum);
        let (equations, functionals) = sum.split_at(N * p);
        for (row, equation) in equations.chunks_exact(p).enumerate() {
            for (column, &value) in equation.iter().enumerate() {
                block.c[column * N + row] = -value;
            }
        }
        block.fc.copy_from_slice(functionals);
    }
}
