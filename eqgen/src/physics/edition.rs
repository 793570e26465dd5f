//! Which choices make an edition, and the kernels that all editions together need.

use super::beam::Shear;
use super::boundary::{self, Belt, BoundaryModel, Ends};
use super::contact;
use super::friction::Law;
use super::span::{self, Equations};
use super::{outputs, string};
use crate::error::Error;
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

/// Choices that together make one model of the drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edition {
    /// Name in the case file.
    pub name: &'static str,
    /// Shear in the grooves.
    pub shear: Shear,
    /// Shear at the ends of the contact regions.
    pub ends: Ends,
    /// Equations of the spans.
    pub span: Equations,
    /// Friction.
    pub friction: Law,
}

/// The editions.
pub const EDITIONS: [Edition; 3] = [
    Edition {
        name: "published",
        shear: Shear::Linearised,
        ends: Ends::AsPrinted,
        span: Equations::AsPrinted,
        friction: Law::ViscousCoulomb,
    },
    Edition {
        name: "thesis",
        shear: Shear::Linearised,
        ends: Ends::Zero,
        span: Equations::Derived,
        friction: Law::ViscousCoulomb,
    },
    Edition {
        name: "consistent",
        shear: Shear::Full,
        ends: Ends::Continuous,
        span: Equations::Derived,
        friction: Law::ViscousCoulomb,
    },
];

/// All kernels, in the order in which they are emitted.
///
/// # Errors
/// The first inconsistency of any equation.
pub fn kernels() -> Result<Vec<Model>, Error> {
    let mut all = Vec::new();
    for shear in [Shear::Linearised, Shear::Full] {
        for law in [Law::ViscousCoulomb, Law::Tanh] {
            all.push(Model::Region(contact::model(shear, law)?));
        }
    }
    for equations in [Equations::Derived, Equations::AsPrinted] {
        all.push(Model::Region(span::model(equations)?));
    }
    for ends in [Ends::Zero, Ends::Continuous] {
        for shear in [Shear::Linearised, Shear::Full] {
            all.push(Model::Boundary(boundary::model(ends, shear)?));
        }
    }
    all.push(Model::Boundary(boundary::model(Ends::AsPrinted, Shear::Linearised)?));
    all.push(Model::Boundary(outputs::model(Belt::Beam)?));
    for law in [Law::ViscousCoulomb, Law::Tanh] {
        all.push(Model::Region(string::contact_model(law)?));
    }
    all.push(Model::Region(string::span_model()?));
    all.push(Model::Boundary(boundary::string_model()?));
    all.push(Model::Boundary(outputs::model(Belt::String)?));
    Ok(all)
}
