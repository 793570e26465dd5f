//! What a computation cost, counted.

use std::ops::{AddAssign, Sub};

/// Work done. Deterministic: the same problem costs the same on every machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stats {
    /// Points at which the right-hand side alone was evaluated.
    pub rhs_points: usize,
    /// Points at which the right-hand side and its derivatives were evaluated.
    pub jacobian_points: usize,
    /// Factorisations of the Newton matrix.
    pub factorisations: usize,
    /// Linear systems solved with a held factorisation.
    pub linear_solves: usize,
    /// Newton iterations: each evaluates derivatives and factors once.
    pub newton_iterations: usize,
    /// Corrections that reused the factorisation of an earlier iteration and were kept.
    pub simplified_corrections: usize,
    /// Meshes on which the equations were solved.
    pub meshes: usize,
}

impl Stats {
    /// Points at which the right-hand side was evaluated, with its derivatives or without: the unit of
    /// [`Options::work_limit`](crate::Options::work_limit).
    pub fn points(&self) -> usize {
        self.rhs_points + self.jacobian_points
    }
}

impl AddAssign for Stats {
    fn add_assign(&mut self, other: Self) {
        self.rhs_points += other.rhs_points;
        self.jacobian_points += other.jacobian_points;
        self.factorisations += other.factorisations;
        self.linear_solves += other.linear_solves;
        self.newton_iterations += other.newton_iterations;
        self.simplified_corrections += other.simplified_corrections;
        self.meshes += other.meshes;
    }
}

impl Sub for Stats {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            rhs_points: self.rhs_points - other.rhs_points,
            jacobian_points: self.jacobian_points - other.jacobian_points,
            factorisations: self.factorisations - other.factorisations,
            linear_solves: self.linear_solves - other.linear_solves,
            newton_iterations: self.newton_iterations - other.newton_iterations,
            simplified_corrections: self.simplified_corrections - other.simplified_corrections,
            meshes: self.meshes - other.meshes,
        }
    }
}
