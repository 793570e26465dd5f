//! Which choices make an edition, and the kernels that all editions together need.

use super::beam::Shear;
use super::boundary::{self, Ends};
use super::contact;
use super::friction::Law;
use super::model::{BeltTheory, BoundaryModel, Model, RegionModel};
use super::span::{self, Equations};
use super::{outputs, string};
use crate::error::Error;

/// Choices that together make one model of the drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edition {
    /// Name in the case file.
    pub name: &'static str,
    /// What belongs to bending; a string has none of it.
    pub bending: Option<Bending>,
    /// Friction.
    pub friction: Law,
}

/// Choices of a belt that resists bending.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bending {
    /// Shear in the grooves.
    pub shear: Shear,
    /// Shear at the ends of the contact regions.
    pub ends: Ends,
    /// Equations of the spans.
    pub span: Equations,
}

impl Edition {
    const fn beam(name: &'static str, shear: Shear, ends: Ends, span: Equations) -> Self {
        Self { name, bending: Some(Bending { shear, ends, span }), friction: Law::ViscousCoulomb }
    }

    /// Its contact regions.
    ///
    /// # Errors
    /// If an equation is inconsistent; the message names it.
    pub fn contact(&self) -> Result<RegionModel, Error> {
        match self.bending {
            Some(bending) => contact::model(bending.shear, self.friction),
            None => string::contact_model(self.friction),
        }
    }

    /// Its spans.
    ///
    /// # Errors
    /// If an equation is inconsistent; the message names it.
    pub fn span(&self) -> Result<RegionModel, Error> {
        self.bending.map_or_else(string::span_model, |bending| span::model(bending.span))
    }

    /// Its boundary equations.
    ///
    /// # Errors
    /// If an equation is inconsistent; the message names it.
    pub fn boundary(&self) -> Result<BoundaryModel, Error> {
        self.bending.map_or_else(boundary::string_model, |bending| boundary::model(bending.ends, bending.shear))
    }
}

/// The editions.
pub const EDITIONS: [Edition; 4] = [
    Edition::beam("published", Shear::Linearised, Ends::AsPrinted, Equations::AsPrinted),
    Edition::beam("thesis", Shear::Linearised, Ends::Zero, Equations::Derived),
    Edition::beam("consistent", Shear::Full, Ends::Continuous, Equations::Derived),
    Edition { name: "string", bending: None, friction: Law::ViscousCoulomb },
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
    all.push(Model::Boundary(outputs::model(BeltTheory::Beam)?));
    for law in [Law::ViscousCoulomb, Law::Tanh] {
        all.push(Model::Region(string::contact_model(law)?));
    }
    all.push(Model::Region(string::span_model()?));
    all.push(Model::Boundary(boundary::string_model()?));
    all.push(Model::Boundary(outputs::model(BeltTheory::String)?));
    Ok(all)
}
