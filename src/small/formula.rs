//! Generated formulae, called by the names of their inputs and outputs.

use generated::BoundaryKernel;

/// A set of formulae with values for its inputs; an input that is not given is not a number, and so is all that needs it.
#[derive(Debug, Clone)]
pub struct Inputs {
    kernel: &'static BoundaryKernel,
    values: Vec<f64>,
}

/// What the formulae give.
#[derive(Debug, Clone)]
pub struct Outputs {
    kernel: &'static BoundaryKernel,
    values: Vec<f64>,
    derivatives: Vec<f64>,
}

impl Inputs {
    /// No input given.
    pub fn new(kernel: &'static BoundaryKernel) -> Self {
        Self { kernel, values: vec![f64::NAN; kernel.constants.len()] }
    }

    /// With these inputs, by name, in SI.
    pub fn with(mut self, given: &[(&str, f64)]) -> Self {
        given.iter().for_each(|(name, value)| self.set(name, *value));
        self
    }

    /// Gives an input its value.
    pub fn set(&mut self, name: &str, value: f64) {
        let place = self.kernel.constants.iter().position(|symbol| symbol.name == name);
        debug_assert!(place.is_some(), "{} has no input {name}", self.kernel.name);
        if let Some(input) = place.and_then(|place| self.values.get_mut(place)) {
            *input = value;
        }
    }

    /// The value of an input.
    pub fn get(&self, name: &str) -> f64 {
        let place = self.kernel.constants.iter().position(|symbol| symbol.name == name);
        debug_assert!(place.is_some(), "{} has no input {name}", self.kernel.name);
        place.and_then(|place| self.values.get(place).copied()).unwrap_or(f64::NAN)
    }

    /// All outputs.
    pub fn outputs(&self) -> Outputs {
        let mut values = vec![0.0; self.kernel.equations.len()];
        (self.kernel.value)(&[], &[], &self.values, &mut values);
        Outputs { kernel: self.kernel, values, derivatives: Vec::new() }
    }

    /// All outputs with their derivatives.
    pub fn linearised(&self) -> Outputs {
        let mut values = vec![0.0; self.kernel.equations.len()];
        let mut derivatives = vec![0.0; self.kernel.pattern.len()];
        (self.kernel.jacobian)(&[], &[], &self.values, &mut values, &mut derivatives);
        Outputs { kernel: self.kernel, values, derivatives }
    }
}

impl Outputs {
    fn row(&self, name: &str) -> usize {
        let row = self.kernel.equations.iter().position(|equation| equation.name == name);
        debug_assert!(row.is_some(), "{} has no output {name}", self.kernel.name);
        row.unwrap_or(usize::MAX)
    }

    /// An output.
    pub fn get(&self, name: &str) -> f64 {
        self.values.get(self.row(name)).copied().unwrap_or(f64::NAN)
    }

    /// The derivative of an output in an input; 0 where it does not depend on it.
    pub fn derivative(&self, output: &str, input: &str) -> f64 {
        let column = self.kernel.constants.iter().position(|symbol| symbol.name == input);
        debug_assert!(column.is_some(), "{} has no input {input}", self.kernel.name);
        let entry = column.map(|column| (self.row(output), column));
        let place = self.kernel.pattern.iter().position(|pair| Some(*pair) == entry);
        place.map_or(0.0, |place| self.derivatives.get(place).copied().unwrap_or(f64::NAN))
    }
}
