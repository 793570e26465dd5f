//! What is a large and what a small change of each component: how tolerances become typical magnitudes.
//!
//! A component `y` with relative tolerance r and absolute tolerance a is to be known to `max(r |y|, a)`, with |y| its
//! largest magnitude over the region. Divided by the solve's tolerance this is its typical magnitude: every error,
//! defect and correction is measured in units of it, and held to the one tolerance.

use crate::by_region::ByRegion;
use crate::error::SolveError;
use crate::options::{ComponentTolerance, Options, Which};
use crate::problem::Layout;

/// Typical magnitude of one component: `max(factor * |y|, floor)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Magnitude {
    factor: f64,
    floor: f64,
}

impl Magnitude {
    /// As a layout states it; 1 at least where it states nothing.
    pub(crate) fn stated(scale: Option<f64>) -> Self {
        Self { factor: 1.0, floor: scale.unwrap_or(1.0) }
    }

    /// At the largest magnitude found.
    pub(crate) fn of(self, found: f64) -> f64 {
        (self.factor * found).max(self.floor)
    }
}

/// Of all components.
#[derive(Debug, Clone)]
pub(crate) struct Magnitudes {
    /// By region and state.
    pub states: ByRegion<Vec<Magnitude>>,
    /// All constants of the layout.
    pub constants: Vec<Magnitude>,
    /// Of every integral, at its largest from the beginning of its region to anywhere: as of a state that states
    /// nothing. None where they are not held to the tolerance.
    pub integrals: Option<Magnitude>,
}

impl Magnitudes {
    /// As the layout states them.
    pub(crate) fn stated(layout: &Layout) -> Self {
        let states = layout.regions.iter().map(|region| {
            let states = region.states.iter();
            states.map(|state| Magnitude::stated(state.scale)).collect()
        });
        let constants = layout.constants.iter().map(|constant| Magnitude::stated(constant.scale));
        Self { states: states.collect(), constants: constants.collect(), integrals: None }
    }

    /// As the layout and the options state them. Options that do not fit the layout have no effect.
    pub(crate) fn new(layout: &Layout, options: &Options) -> Self {
        let mut magnitudes = Self::stated(layout);
        magnitudes.integrals = options.integrals.then(|| Magnitude::stated(None));
        if let Some(absolute) = options.absolute_tolerance {
            let floor = absolute / options.tolerance;
            let states = layout.regions.iter().flat_map(|region| region.states.iter().map(|state| state.scale));
            let unstated = |(magnitude, scale): (&mut Magnitude, Option<f64>)| {
                if scale.is_none() {
                    magnitude.floor = floor;
                }
            };
            magnitudes.states.iter_mut().flatten().zip(states).for_each(unstated);
            let constants = layout.constants.iter().map(|constant| constant.scale);
            magnitudes.constants.iter_mut().zip(constants).for_each(unstated);
            magnitudes.integrals.iter_mut().for_each(|magnitude| magnitude.floor = floor);
        }
        for component in &options.components {
            if let Some(magnitude) = magnitudes.component(component.of) {
                component.apply(magnitude, options.tolerance);
            }
        }
        magnitudes
    }

    fn component(&mut self, of: Which) -> Option<&mut Magnitude> {
        match of {
            Which::State { region, state } => self.states.get_mut(region)?.get_mut(state),
            Which::Constant(index) => self.constants.get_mut(index),
        }
    }
}

impl ComponentTolerance {
    fn apply(&self, magnitude: &mut Magnitude, tolerance: f64) {
        if let Some(relative) = self.relative {
            magnitude.factor = relative / tolerance;
        }
        if let Some(absolute) = self.absolute {
            magnitude.floor = absolute / tolerance;
        }
    }
}

/// # Errors
/// A component, or a region of one, that the layout does not have.
pub(crate) fn check(layout: &Layout, options: &Options) -> Result<(), SolveError> {
    for component in &options.components {
        let (value, count) = match component.of {
            Which::State { region: index, state } => match layout.regions.get(index) {
                Some(region) => (state, region.states.len()),
                None => return Err(SolveError::Region { index, regions: layout.regions.len() }),
            },
            Which::Constant(index) => (index, layout.constants.len()),
        };
        if value >= count {
            let expected = "a state or a constant that the layout has";
            return Err(SolveError::Option { name: "components", value: value as f64, expected });
        }
    }
    Ok(())
}
