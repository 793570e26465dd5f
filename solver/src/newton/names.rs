//! What an iteration that failed says: the largest components of its vectors, by name and place.

use crate::collocation::factor::Factorisation;
use crate::collocation::{Correction, System};
use crate::error::{Component, NewtonError, shown};
use crate::linear::scalar::W;
use crate::problem::Problem;

/// How many components a message shows.
const SHOWN: usize = 4;

impl<P: Problem + ?Sized> System<'_, P> {
    /// The largest components of a vector over ends and unknowns, by name.
    pub(crate) fn border_components(&self, vector: &[f64]) -> Vec<Component> {
        let ends = self.layout.ends();
        let mut components: Vec<Component> = vector
            .iter()
            .enumerate()
            .map(|(i, &value)| {
                let name = match i.checked_sub(ends).and_then(|u| self.plan.unknowns.get(u)) {
                    Some(&constant) => format!("constant {}", self.layout.constants[constant].name),
                    None => self.layout.input_name(i),
                };
                Component { name, value }
            })
            .collect();
        components.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        let least = components.first().map_or(0.0, |first| 1e-3 * first.value.abs());
        components.retain(|component| component.value.abs() >= least && component.value != 0.0);
        components.truncate(SHOWN);
        components
    }

    /// The largest components of a correction, by name and position: the largest of each state, and the constants.
    pub(crate) fn largest_components(&self, dx: &Correction) -> Vec<Component> {
        let mut components = Vec::new();
        for (region, (u, grid)) in self.layout.regions.iter().zip(dx.u.iter().zip(&self.grids)) {
            let n = region.states.len();
            for (i, state) in region.states.iter().enumerate() {
                let at = |j: usize| {
                    let p = grid.node(j);
                    u[p / W * n + i].0[p % W]
                };
                let nodes = 0..grid.mesh.len();
                let Some(j) = nodes.max_by(|&a, &b| at(a).abs().total_cmp(&at(b).abs())) else { continue };
                let name = format!("{} at {} of {}", state.name, shown(grid.mesh[j]), region.name);
                components.push(Component { name, value: at(j) });
            }
        }
        for (&constant, &value) in self.plan.unknowns.iter().zip(&dx.c) {
            components.push(Component { name: format!("constant {}", self.layout.constants[constant].name), value });
        }
        components.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        components.truncate(SHOWN);
        components
    }
}

impl Factorisation {
    /// Whether the matrix determines all ends and unknowns.
    ///
    /// # Errors
    /// It is not finite, or leaves something undetermined.
    pub(crate) fn determined<P: Problem + ?Sized>(&self, system: &System<'_, P>) -> Result<(), NewtonError> {
        self.of_full_rank(system, self.rank())
    }

    /// As [`determined`](Self::determined), of a matrix whose singular values are known to `least` times the largest.
    pub(crate) fn determined_to<P: Problem + ?Sized>(
        &self,
        system: &System<'_, P>,
        least: f64,
    ) -> Result<(), NewtonError> {
        self.of_full_rank(system, self.rank_to(least))
    }

    fn of_full_rank<P: Problem + ?Sized>(
        &self,
        system: &System<'_, P>,
        (rank, size): (usize, usize),
    ) -> Result<(), NewtonError> {
        if rank == size {
            return Ok(());
        }
        let finite = self.dense.iter().all(|value| value.is_finite());
        Err(if finite { self.singular(system, rank) } else { NewtonError::Overflow })
    }

    /// What the matrix, of lower rank than size, leaves undetermined, by name.
    pub(crate) fn singular<P: Problem + ?Sized>(&self, system: &System<'_, P>, rank: usize) -> NewtonError {
        let equations = &system.layout.equations;
        let first = system.plan.states();
        let empty = (0..equations.len()).filter(|&row| self.row_is_empty(first + row));
        NewtonError::Singular {
            rank,
            size: self.border.size(),
            null_vector: system.border_components(&self.null_vector()),
            empty_equations: empty.map(|row| equations[row].clone()).collect(),
        }
    }
}
