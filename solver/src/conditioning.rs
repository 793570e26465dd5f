//! Conditioning of a problem at a solution.

use crate::by_region::ByRegion;
use crate::collocation::Correction;
use crate::collocation::factor::Rhs;
use crate::collocation::transpose::Weights;
use crate::linear::memory::{Lanes, Numbers};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linearisation::Linearisation;
use crate::problem::Problem;

/// How strongly solutions react, in units of typical magnitudes. F. Mazzia and D. Trigiante, J. Comput. Appl. Math. 169
/// (2004) 313-326; J. R. Cash and F. Mazzia, J. Comput. Appl. Math. 184 (2005) 362-381.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditioning {
    /// Largest reaction to a change of the boundary equations (each relative to its largest term).
    pub kappa1: f64,
    /// Mean of that reaction over the regions.
    pub gamma1: f64,
    /// Largest reaction to a defect of 1 everywhere (estimated, a lower bound that is seldom off by more than 3).
    pub kappa2: f64,
}

impl Conditioning {
    /// κ1 + κ2: errors are at most about this times the tolerance.
    pub fn kappa(&self) -> f64 {
        self.kappa1 + self.kappa2
    }

    /// κ1/γ1: large where the solution varies fast in a small part of the regions only.
    pub fn stiffness(&self) -> f64 {
        self.kappa1 / self.gamma1
    }
}

impl<P: Problem + ?Sized> Linearisation<'_, P> {
    /// Conditioning of the problem at this solution.
    pub fn conditioning(&self) -> Conditioning {
        let (kappa1, gamma1) = self.boundary_reaction();
        Conditioning { kappa1, gamma1, kappa2: self.defect_reaction() }
    }

    fn no_rhs(&self) -> Rhs {
        let grids = self.system.grids.iter().zip(&self.system.plan.regions);
        Rhs {
            regions: grids.clone().map(|(grid, plan)| Lanes::zeros(grid.steps * plan.n)).collect(),
            inner: ByRegion::default(),
            integrals: grids.map(|(_, plan)| Numbers::zeros(plan.active.len())).collect(),
            boundary: Numbers::zeros(self.system.layout.equations.len()),
        }
    }

    /// κ1 and γ1: row sums of the inverse's columns that belong to the boundary equations.
    fn boundary_reaction(&self) -> (f64, f64) {
        let mut sums: Option<Correction> = None;
        let sizes = self.system.boundary_sizes(&self.work, &self.factorisation.scales);
        for (equation, size) in sizes.iter().enumerate() {
            let mut rhs = self.no_rhs();
            rhs.boundary[equation] = size.terms;
            let mut dx = self.factorisation.solve(&self.system, rhs);
            dx.u.iter_mut().flatten().for_each(|lane| *lane = lane.abs());
            dx.c.iter_mut().for_each(|c| *c = c.abs());
            // Nodes stand for what is between them.
            dx.inner = ByRegion::default();
            match &mut sums {
                None => sums = Some(dx),
                Some(sums) => {
                    sums.u.iter_mut().flatten().zip(dx.u.iter().flatten()).for_each(|(sum, u)| *sum += *u);
                    sums.c.iter_mut().zip(&dx.c).for_each(|(sum, c)| *sum += c);
                }
            }
        }
        let Some(sums) = sums else { return (0.0, 0.0) };
        let mut gamma = 0.0;
        for (region, grid) in self.system.grids.iter().enumerate() {
            let n = self.system.plan.regions[region].n;
            let norm = |j: usize| {
                let p = grid.node(j);
                sums.u[region][p / W * n..(p / W + 1) * n].iter().map(|lane| lane.0[p % W]).fold(0.0, f64::max)
            };
            let length = grid.mesh[grid.intervals()] - grid.mesh[0];
            let each = grid.mesh.windows(2).enumerate();
            gamma += each.map(|(j, pair)| (pair[1] - pair[0]) / length * norm(j).max(norm(j + 1))).sum::<f64>();
        }
        (self.system.largest(&sums), gamma / self.system.grids.len() as f64)
    }

    /// κ2 by the 1-norm estimator of N. J. Higham, ACM Trans. Math. Softw. 14 (1988) 381-396, applied to the transpose.
    fn defect_reaction(&self) -> f64 {
        let mut weights = self.no_rhs_weights();
        let unknowns: usize =
            self.system.grids.iter().zip(&self.system.plan.regions).map(|(g, p)| g.mesh.len() * p.n).sum();
        for (region, plan) in self.system.plan.regions.iter().enumerate() {
            let grid = &self.system.grids[region];
            for j in 0..grid.mesh.len() {
                for i in 0..plan.n {
                    self.put(&mut weights.unknowns.u[region], region, j, i, 1.0 / unknowns as f64);
                }
            }
        }
        let mut estimate = 0.0;
        for _ in 0..4 {
            let multipliers = self.factorisation.solve_transposed(&self.system, weights);
            let mut rhs = self.no_rhs();
            let mut sum = 0.0;
            for (region, plan) in self.system.plan.regions.iter().enumerate() {
                let grid = &self.system.grids[region];
                let length = grid.mesh[grid.intervals()] - grid.mesh[0];
                let lanes = rhs.regions[region].iter_mut().zip(&multipliers.regions[region]).enumerate();
                for (at, (out, multiplier)) in lanes {
                    for l in 0..W {
                        let share = grid.h[at / plan.n * W + l] / length;
                        sum += share * multiplier.0[l].abs();
                        out.0[l] = share * 1.0_f64.copysign(multiplier.0[l]);
                    }
                }
            }
            if sum <= estimate {
                break;
            }
            estimate = sum;
            let dx = self.factorisation.solve(&self.system, rhs);
            weights = self.no_rhs_weights();
            let (mut best, mut at) = (0.0, None);
            for (region, plan) in self.system.plan.regions.iter().enumerate() {
                let grid = &self.system.grids[region];
                for j in 0..grid.mesh.len() {
                    let p = grid.node(j);
                    for i in 0..plan.n {
                        let value = dx.u[region][p / W * plan.n + i].0[p % W].abs();
                        if value > best {
                            (best, at) = (value, Some((region, j, i)));
                        }
                    }
                }
            }
            let Some((region, j, i)) = at else { break };
            self.put(&mut weights.unknowns.u[region], region, j, i, 1.0);
        }
        estimate
    }

    fn no_rhs_weights(&self) -> Weights {
        let grids = self.system.grids.iter().zip(&self.system.plan.regions);
        Weights {
            unknowns: Correction {
                u: grids.clone().map(|(grid, plan)| Lanes::zeros((grid.steps + 1) * plan.n)).collect(),
                inner: ByRegion::default(),
                c: vec![0.0; self.system.plan.unknowns.len()],
            },
            integrals: grids.map(|(_, plan)| Numbers::zeros(plan.active.len())).collect(),
        }
    }

    fn put(&self, u: &mut [Lane], region: usize, node: usize, state: usize, value: f64) {
        let grid = &self.system.grids[region];
        let p = if node == grid.intervals() { grid.last() } else { grid.position(node) };
        u[p / W * self.system.plan.regions[region].n + state].0[p % W] += value;
    }
}
