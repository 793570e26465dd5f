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
    /// How many leading constants are the default unknowns.
    pub default_unknowns: usize,
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
    /// The equations: each is a step of the plan of that name.
    pub equations: Vec<Symbol>,
    /// What the values of the equations are.
    pub role: Role,
}

/// What a belt is taken for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeltTheory {
    /// A beam, which resists bending.
    Beam,
    /// A string, which does not.
    String,
}

/// What the values of a set of equations are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Residuals, which vanish at a solution.
    Conditions,
    /// Outputs of a drive with that belt.
    Outputs(BeltTheory),
    /// Formulae in inputs of their own; the names of the enums that identify inputs and outputs.
    Formulae {
        /// Enum of the inputs, which stand in place of the constants.
        inputs: &'static str,
        /// Enum of the outputs, which stand in place of the equations.
        outputs: &'static str,
    },
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
    /// How everything is computed.
    pub fn plan(&self) -> &Plan {
        match self {
            Model::Region(model) => &model.plan,
            Model::Boundary(model) => &model.plan,
        }
    }

    /// Name of the kernel.
    pub fn name(&self) -> &str {
        match self {
            Model::Region(model) => &model.name,
            Model::Boundary(model) => &model.name,
        }
    }
}
