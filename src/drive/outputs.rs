//! Values of a drive's outputs, and their gradients.

use generated::OutputKernel;

use crate::model::{InternalError, Output};

/// The values of all outputs that a drive has.
#[derive(Debug, Clone)]
pub struct OutputValues {
    kernel: &'static OutputKernel,
    /// One an equation of the kernel's set.
    values: Vec<f64>,
}

impl OutputValues {
    pub(super) fn new(kernel: &'static OutputKernel, values: Vec<f64>) -> Self {
        Self { kernel, values }
    }

    /// An output, SI.
    ///
    /// # Errors
    /// [`InternalError::Output`] if drives with this belt do not have it: see [`Output::theories`].
    pub fn get(&self, output: Output) -> Result<f64, InternalError> {
        let value = self.kernel.row(output).and_then(|row| self.values.get(row));
        value.copied().ok_or(InternalError::Output(output))
    }

    /// All outputs that the drive has, in order.
    pub fn iter(&self) -> impl Iterator<Item = (Output, f64)> + '_ {
        self.kernel.outputs.iter().copied().zip(self.values.iter().copied())
    }
}

/// The gradients of all outputs that a drive has.
#[derive(Debug, Clone)]
pub struct OutputGradients {
    kernel: &'static OutputKernel,
    /// One an equation of the kernel's set: derivatives with respect to ends, integrals and constants.
    rows: Vec<Vec<f64>>,
}

impl OutputGradients {
    pub(super) fn new(kernel: &'static OutputKernel, rows: Vec<Vec<f64>>) -> Self {
        Self { kernel, rows }
    }

    /// Derivatives of an output with respect to ends, integrals and constants, SI.
    ///
    /// # Errors
    /// [`InternalError::Output`] if drives with this belt do not have it: see [`Output::theories`].
    pub fn get(&self, output: Output) -> Result<&[f64], InternalError> {
        let gradient = self.kernel.row(output).and_then(|row| self.rows.get(row));
        gradient.map(Vec::as_slice).ok_or(InternalError::Output(output))
    }

    /// All outputs that the drive has, in order.
    pub fn iter(&self) -> impl Iterator<Item = (Output, &[f64])> + '_ {
        self.kernel.outputs.iter().copied().zip(self.rows.iter().map(Vec::as_slice))
    }
}
