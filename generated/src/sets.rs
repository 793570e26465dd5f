//! Sets of equations whose values are asked for by name: outputs of a drive, formulae of the small models.

use std::marker::PhantomData;

use crate::types::BoundaryKernel;
use crate::vocabulary::Output;

/// What the belt is taken for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BeltTheory {
    /// A beam: it resists bending.
    Beam,
    /// A string: it does not.
    String,
}

/// The outputs of a drive whose belt is of one theory.
#[derive(Debug, Clone, Copy)]
pub struct OutputKernel {
    /// The belt's theory.
    pub theory: BeltTheory,
    /// The outputs that such a drive has, in the order of the set's equations.
    pub outputs: &'static [Output],
    /// Their values, one an equation.
    pub set: BoundaryKernel,
}

impl OutputKernel {
    /// Row of an output in the set; `None` if a drive of this theory does not have it.
    pub fn row(&self, output: Output) -> Option<usize> {
        self.outputs.iter().position(|other| *other == output)
    }
}

/// Formulae whose inputs `I` and outputs `O` are enums of their own: the set's constants are the inputs, all in order;
/// its equations are the outputs, all in order. There are neither ends nor integrals.
#[derive(Debug)]
pub struct FormulaKernel<I, O> {
    /// The formulae, one an equation.
    pub set: BoundaryKernel,
    typed: PhantomData<fn(I) -> O>,
}

impl<I, O> FormulaKernel<I, O> {
    pub(crate) const fn new(set: BoundaryKernel) -> Self {
        Self { set, typed: PhantomData }
    }
}
