//! What is emitted: the equations of a region, and those of its boundaries.

use super::notation::Symbol;
use crate::plan::Plan;

/// One region, ready to be emitted.
#[derive(Debug, Clone)]
pub struct RegionModel {
    /// Name of the kernel.
    pub name: String,
    /// What it is.
    pub doc: String,
    /// How everything is computed.
    pub plan: Plan,
    /// States.
    pub states: &'static [&'static str],
    /// Constants.
    pub constants: &'static [&'static str],
    /// How many leading constants are usually unknown.
    pub usual: usize,
    /// Integrals.
    pub integrals: &'static [&'static str],
    /// Symbols of the plan that are the right-hand side and the integrands.
    pub rows: &'static [&'static str],
    /// Symbols of the plan that are derived fields.
    pub fields: &'static [&'static str],
}

/// A set of boundary equations, ready to be emitted.
#[derive(Debug, Clone)]
pub struct BoundaryModel {
    /// Name of the kernel.
    pub name: String,
    /// What it is.
    pub doc: String,
    /// How everything is computed; each equation is a step of its own name.
    pub plan: Plan,
    /// Ends: region by region, all entry states, then all exit states.
    pub ends: Vec<Symbol>,
    /// Integrals, region by region.
    pub integrals: Vec<Symbol>,
    /// Constants of the drive.
    pub constants: Vec<Symbol>,
    /// Name and meaning of the equations.
    pub equations: Vec<(String, String)>,
}

/// A kernel to emit.
#[derive(Debug, Clone)]
pub enum Model {
    /// A region.
    Region(RegionModel),
    /// A set of boundary equations.
    Boundary(BoundaryModel),
}

impl Model {
    /// Name of the kernel.
    pub fn name(&self) -> &str {
        match self {
            Model::Region(model) => &model.name,
            Model::Boundary(model) => &model.name,
        }
    }
}
