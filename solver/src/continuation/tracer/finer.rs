//! Branch points on finer meshes.
//!
//! The mesh of a branch resolves its solutions; at a branch point, what bifurcates there has to be resolved as well.
//! Along a trivial solution, which asks for no mesh, a buckling load would be as exact as the mesh of the guess makes
//! it. Where the determinant vanishes is therefore sought on halved intervals, too, until the parameter there settles.

use super::places::{DISTANCE, SETTLED};
use super::{Advanced, Care, Reference, Tracer};
use crate::error::SolveError;
use crate::orientation::Determinant;
use crate::start::{self, Start};

/// Times that all intervals are halved at most.
const HALVINGS: usize = 6;
/// What is left of the error on a halved mesh is the last change over this at most: the methods' orders are four and
/// more, for which it is a fifteenth of it.
const SHRINKS: f64 = 8.0;
/// Looks for one place at most.
const LOOKS: usize = 16;
/// A finer mesh may move a branch point by so much of arclength, or by a step that is longer.
const REACH: f64 = 0.1;
/// Two branch points that are close may be one on either side of where they are sought. On a finer mesh the determinant
/// rises or falls through the same one as on the coarser, and not with much less than its slope there.
const FLATTEST: f64 = 0.25;

/// The determinant at one place beside a branch point.
struct Look {
    at: f64,
    /// Relative to that of the point where the step begins.
    value: f64,
    advanced: Advanced,
}

impl Tracer<'_, '_> {
    /// A branch point as exact as the tolerance asks, and its place: of one that leaves the step, the end of the step,
    /// for points are told in their order.
    pub(super) fn settled(
        &mut self,
        (here, step): (&Reference, f64),
        (mut place, mut point): (f64, Reference),
        slope: f64,
    ) -> Result<(f64, Reference), SolveError> {
        let scale = self.problem.layout().constants[self.parameter].scale.unwrap_or(1.0);
        let tolerance = self.options.solve.tolerance * point.value(self.parameter).abs().max(scale);
        for _ in 0..HALVINGS {
            let most = point.solution.regions().iter().map(|region| 2 * region.intervals()).max();
            if most.is_none_or(|most| most > self.options.solve.max_intervals) {
                break;
            }
            let finer = match self.finer((here, step), (place, &point), slope, tolerance) {
                Err(cause) if cause.is_interruption() => return Err(cause),
                // What was found on the coarser mesh stands.
                Err(_) | Ok(None) => break,
                Ok(Some(finer)) => finer,
            };
            let change = (finer.1.value(self.parameter) - point.value(self.parameter)).abs();
            (place, point) = finer;
            if change <= SHRINKS * tolerance {
                break;
            }
        }
        Ok((place.clamp(0.0, step), point))
    }

    /// The branch point on halved intervals; none if the coarser mesh has it to the tolerance, or it is not found.
    fn finer(
        &mut self,
        (here, step): (&Reference, f64),
        (place, point): (f64, &Reference),
        slope: f64,
        tolerance: f64,
    ) -> Result<Option<(f64, Reference)>, SolveError> {
        let Some((finer, look)) = self.place_on_halved((here, step), (place, point), slope)? else { return Ok(None) };
        let near = look.advanced.near(look.at);
        let parameter = near.point.moved(near.speed * (finer - near.at)).constants[self.parameter];
        if (parameter - point.value(self.parameter)).abs() <= tolerance {
            return Ok(None);
        }
        let judged = self.advance_from(here, look.at, (near, None), Care::Between)?;
        Ok(Some((finer, self.moved(&judged.point, judged.speed * (finer - look.at))?)))
    }

    /// Where the determinant vanishes on halved intervals, by secants from where it does on those of a point; and the
    /// last look beside it.
    fn place_on_halved(
        &mut self,
        (here, step): (&Reference, f64),
        (place, point): (f64, &Reference),
        slope: f64,
    ) -> Result<Option<(f64, Look)>, SolveError> {
        let (beside, reach) = (DISTANCE * step, REACH.max(step));
        let mut guess = point.moved(beside);
        guess.constants.push(place + beside);
        let halved = start::halved(&Start::from(&guess));
        let expected = point.solution.constants();
        let first = self.advance_with(here, halved, Care::Glance)?;
        let first = self.between(first, expected, reach)?;
        let unit = here.determinant;
        let mut last = Look::new(&unit, place + beside, first);
        let (mut zero, mut next) = (place, place - beside);
        for _ in 0..LOOKS {
            let near = (last.advanced.near(last.at), None);
            let advanced = self.advance_from(here, next, near, Care::Glance)?;
            let advanced = self.between(advanced, expected, reach)?;
            let look = Look::new(&unit, next, advanced);
            let (before, secant) = (zero, (look.value - last.value) / (look.at - last.at));
            let is_steep = secant / slope >= FLATTEST;
            zero = look.at - look.value / if is_steep { secant } else { slope };
            if !zero.is_finite() || (zero - place).abs() > reach {
                break;
            }
            if is_steep && (zero - before).abs() <= SETTLED * step {
                return Ok(Some((zero, look)));
            }
            next = zero + beside;
            last = look;
        }
        Ok(None)
    }
}

impl Look {
    fn new(unit: &Determinant, at: f64, advanced: Advanced) -> Self {
        Self { at, value: advanced.point.determinant.relative(unit), advanced }
    }
}
