//! What Newton's iteration ends with.

use crate::collocation::evaluate::Work;
use crate::collocation::factor::Factorisation;
use crate::collocation::{Correction, Iterate, Scales, System};
use crate::error::NewtonError;
use crate::problem::Problem;

/// Where the iteration ended, with what it held.
#[derive(Debug, Clone)]
pub(crate) struct Converged {
    pub x: Iterate,
    /// Residual at `x`; its derivatives belong to the last factored iterate.
    pub work: Work,
    pub factorisation: Factorisation,
    /// Typical magnitudes at `x`, where those of the factorisation are far larger or far smaller.
    pub(super) own: Option<OwnScales>,
    /// First observed contraction `‖Δx̄‖ / ‖Δx‖`; 0 if the first correction was already negligible.
    pub contraction: f64,
    /// Whether the problem is linear for sure: so little was left of a first correction that was large, on these meshes
    /// or on those before.
    pub linear: bool,
    /// The first correction was already negligible.
    pub at_once: bool,
    /// Newton iterations that it took.
    pub iterations: usize,
    /// No step was damped, and none was taken away from a singular matrix.
    pub full_steps: bool,
    /// The iteration ended short of its tolerance, at a correction small enough to go on with.
    pub stagnated: Option<NewtonError>,
}

/// Typical magnitudes of the iterate that an iteration led to, which differ by far from those that corrections are in.
#[derive(Debug, Clone)]
pub(super) struct OwnScales {
    pub scales: Scales,
    /// Whether any is far smaller.
    pub smaller: bool,
}

/// Where the first step of Newton's iteration leaves no more than this of its correction, the problem is taken for a
/// linear one: what is left is rounding.
pub(super) const LINEAR: f64 = 1e-9;
/// Near its solution every problem looks like one. From here on, in typical magnitudes, it does not.
pub(super) const FAR: f64 = 0.01;

impl Converged {
    /// Whether the problem is linear as far as the iteration tells.
    pub(crate) fn seems_linear(&self) -> bool {
        self.contraction <= LINEAR
    }

    /// An iterate known to be converged, and the residual there. Nothing is factored: of the factorisation there are
    /// the scales only.
    pub(crate) fn known<P: Problem + ?Sized>(system: &System<'_, P>, x: Iterate, work: Work) -> Self {
        let mut factorisation = Factorisation::new(system);
        factorisation.scales = system.scales(&x);
        Self {
            x,
            work,
            factorisation,
            own: None,
            contraction: 0.0,
            linear: false,
            at_once: true,
            iterations: 0,
            full_steps: true,
            stagnated: None,
        }
    }

    /// Whether all states of a region are the same everywhere to `tolerance`: zero, or an equilibrium. In their typical
    /// magnitudes, or in those of the iterate before: beside that rounding about zero is at rest.
    pub(crate) fn rests(&self, tolerance: f64) -> bool {
        let mut regions = self.x.y.iter().zip(self.scales().states.iter().zip(&self.factorisation.scales.states));
        regions.any(|(y, (scales, before))| {
            let scales = scales.iter().zip(before).map(|(scale, before)| scale.max(*before));
            let mut states = y.chunks_exact(y.len() / before.len().max(1)).zip(scales);
            let rests = |(y, scale): (&[f64], f64)| y.iter().all(|value| (value - y[0]).abs() <= tolerance * scale);
            !before.is_empty() && states.all(rests)
        })
    }

    /// Typical magnitudes, for what is said of the solution. Corrections are in those of the factorisation.
    pub(crate) fn scales(&self) -> &Scales {
        self.own.as_ref().map_or(&self.factorisation.scales, |own| &own.scales)
    }

    /// The largest component of what is given in the factorisation's magnitudes, in those of the solution.
    pub(crate) fn largest<P: Problem + ?Sized>(&self, system: &System<'_, P>, dx: &Correction) -> f64 {
        let Some(own) = &self.own else { return system.largest(dx) };
        let mut rescaled = dx.clone();
        system.rescale(&mut rescaled, &self.factorisation.scales, &own.scales);
        system.largest(&rescaled)
    }
}
