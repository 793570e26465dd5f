//! Laws that close a drive: one more boundary equation each, "law − target = 0", with a constant unknown for it.
//!
//! An output that is prescribed is such an equation whose target is the value asked for. A law is a function of several
//! outputs and constants at once, say of an axial force, a speed and a radius; it is met where it vanishes. Its target
//! begins at what the law is at the solution nearby and goes to zero with everything else that moves, so that belt,
//! actuators and engine are one boundary value problem on the whole way.

use std::fmt::Debug;
use std::sync::Arc;

use generated::OutputKernel;

use super::outputs::OutputValues;
use crate::model::{Constant, InternalError, Output};

/// What a law depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Argument {
    /// An output of the drive.
    Output(Output),
    /// A constant of the drive, given or found.
    Constant(Constant),
}

/// A function of outputs and constants that vanishes where the drive obeys it.
pub trait Law: Debug + Send + Sync {
    /// How messages name it.
    fn name(&self) -> &'static str;

    /// What it depends on.
    fn arguments(&self) -> &[Argument];

    /// A typical magnitude of its terms, by which its residual is measured.
    fn scale(&self) -> f64;

    /// Its value at the arguments' values in SI, and its derivatives in their order; not a number where it has none,
    /// and the solver steps back.
    fn residual(&self, at: &[f64], partials: &mut [f64]) -> f64;
}

/// A law, and the given constant that is found for it.
#[derive(Debug, Clone)]
pub struct Closing {
    /// The constant that is found.
    pub free: Constant,
    /// What determines it.
    pub law: Arc<dyn Law>,
}

impl PartialEq for Closing {
    /// Whether it is the same law: laws have no values to compare.
    fn eq(&self, other: &Self) -> bool {
        self.free == other.free && Arc::ptr_eq(&self.law, &other.law)
    }
}

/// A law with its arguments' places among the outputs and inputs of a drive.
#[derive(Debug, Clone)]
pub(super) struct BoundLaw {
    pub law: Arc<dyn Law>,
    arguments: Vec<Place>,
    /// Inputs of the boundary equations on which the law depends, each once: those of its outputs, and its constants.
    pub inputs: Vec<usize>,
}

#[derive(Debug, Clone, Copy)]
enum Place {
    /// Row among the outputs.
    Output(usize),
    /// Index among the constants.
    Constant(usize),
}

impl BoundLaw {
    /// `constants` is the place of the first constant among the inputs.
    pub fn new(law: Arc<dyn Law>, outputs: &OutputKernel, constants: usize) -> Result<Self, InternalError> {
        let place = |argument: &Argument| match *argument {
            Argument::Output(output) => outputs.row(output).map(Place::Output).ok_or(InternalError::Output(output)),
            Argument::Constant(constant) => Ok(Place::Constant(constant.index())),
        };
        let arguments: Vec<Place> = law.arguments().iter().map(place).collect::<Result<_, _>>()?;
        let mut inputs: Vec<usize> = Vec::new();
        for argument in &arguments {
            match *argument {
                Place::Output(row) => {
                    inputs
                        .extend(outputs.set.pattern.iter().filter(|(other, _)| *other == row).map(|(_, input)| *input));
                }
                Place::Constant(at) => inputs.push(constants + at),
            }
        }
        inputs.sort_unstable();
        inputs.dedup();
        Ok(Self { law, arguments, inputs })
    }

    /// The law's value, and its derivatives with respect to its arguments; `rows` are all outputs.
    pub fn value(&self, rows: &[f64], constants: &[f64]) -> (f64, Vec<f64>) {
        let value = |place: &Place| match *place {
            Place::Output(row) => rows.get(row),
            Place::Constant(at) => constants.get(at),
        };
        let at: Vec<f64> = self.arguments.iter().map(|place| value(place).copied().unwrap_or(f64::NAN)).collect();
        let mut partials = vec![0.0; at.len()];
        let residual = self.law.residual(&at, &mut partials);
        (residual, partials)
    }

    /// The derivatives of the law with respect to [`inputs`](Self::inputs), from those of its arguments and of all
    /// outputs, whose entries `partials` are those of the kernel's pattern.
    pub fn gradient(&self, own: &[f64], outputs: &OutputKernel, partials: &[f64], constants: usize) -> Vec<f64> {
        let mut gradient = vec![0.0; self.inputs.len()];
        let mut add = |input: usize, value: f64| {
            if let Ok(at) = self.inputs.binary_search(&input) {
                gradient[at] += value;
            }
        };
        for (place, own) in self.arguments.iter().zip(own) {
            match *place {
                Place::Constant(at) => add(constants + at, *own),
                Place::Output(row) => {
                    let entries = outputs.set.pattern.iter().zip(partials).filter(|((other, _), _)| *other == row);
                    entries.for_each(|((_, input), partial)| add(*input, own * partial));
                }
            }
        }
        gradient
    }
}

/// What a law is at a solution with these outputs and constants.
pub(super) fn residual(law: &dyn Law, outputs: &OutputValues, constants: &[f64]) -> Result<f64, InternalError> {
    let value = |argument: &Argument| match *argument {
        Argument::Output(output) => outputs.get(output),
        Argument::Constant(constant) => {
            let short = InternalError::Length {
                what: "the vector of constants",
                found: constants.len(),
                expected: Constant::ALL.len(),
            };
            constants.get(constant.index()).copied().ok_or(short)
        }
    };
    let at: Vec<f64> = law.arguments().iter().map(value).collect::<Result<_, _>>()?;
    Ok(law.residual(&at, &mut vec![0.0; at.len()]))
}
