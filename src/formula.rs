//! Generated formulae, called by the identities of their inputs and outputs.

use generated::{FormulaKernel, Identity};

/// A set of formulae with values for its inputs; an input that is not given is not a number, and so is all that needs
/// it.
#[derive(Debug)]
pub struct Inputs<I: 'static, O: 'static> {
    kernel: &'static FormulaKernel<I, O>,
    values: Vec<f64>,
}

impl<I, O> Clone for Inputs<I, O> {
    fn clone(&self) -> Self {
        Self { kernel: self.kernel, values: self.values.clone() }
    }
}

/// What the formulae give.
#[derive(Debug)]
pub struct Outputs<I: 'static, O: 'static> {
    kernel: &'static FormulaKernel<I, O>,
    values: Vec<f64>,
}

impl<I: Identity, O: Identity> Inputs<I, O> {
    /// No input given.
    pub fn new(kernel: &'static FormulaKernel<I, O>) -> Self {
        Self { kernel, values: vec![f64::NAN; I::COUNT] }
    }

    /// With these inputs, in SI.
    pub fn with(mut self, given: &[(I, f64)]) -> Self {
        given.iter().for_each(|(input, value)| self.set(*input, *value));
        self
    }

    /// Gives an input its value.
    pub fn set(&mut self, input: I, value: f64) {
        self.values[input.place()] = value;
    }

    /// The value of an input; not a number if it is not given.
    pub fn get(&self, input: I) -> f64 {
        self.values[input.place()]
    }

    /// All outputs.
    pub fn outputs(&self) -> Outputs<I, O> {
        let mut values = vec![0.0; O::COUNT];
        (self.kernel.set.value)(&[], &[], &self.values, &mut values);
        Outputs { kernel: self.kernel, values }
    }

    /// All outputs with their derivatives.
    pub fn linearised(&self) -> Linearised<I, O> {
        let mut values = vec![0.0; O::COUNT];
        let mut derivatives = vec![0.0; self.kernel.set.pattern.len()];
        (self.kernel.set.jacobian)(&[], &[], &self.values, &mut values, &mut derivatives);
        Linearised { outputs: Outputs { kernel: self.kernel, values }, derivatives }
    }
}

impl<I: Identity, O: Identity> Outputs<I, O> {
    /// An output.
    pub fn get(&self, output: O) -> f64 {
        self.values[output.place()]
    }
}

/// What the formulae give, with derivatives.
#[derive(Debug)]
pub struct Linearised<I: 'static, O: 'static> {
    outputs: Outputs<I, O>,
    /// In the order of the kernel's pattern.
    derivatives: Vec<f64>,
}

impl<I: Identity, O: Identity> Linearised<I, O> {
    /// An output.
    pub fn get(&self, output: O) -> f64 {
        self.outputs.get(output)
    }

    /// The derivative of an output in an input: 0 where it does not depend on it.
    pub fn derivative(&self, output: O, input: I) -> f64 {
        let entry = (output.place(), input.place());
        let entries = self.outputs.kernel.set.pattern.iter().zip(&self.derivatives);
        entries.filter(|(other, _)| **other == entry).map(|(_, derivative)| derivative).sum()
    }
}
