//! Whether what is given and prescribed is independent, whatever the belt does between the ends of its regions.
//!
//! The boundary equations, the given constants and the prescribed outputs are functions of ends, integrals and
//! constants. If their gradients depend on each other linearly at a generic point, one of them says nothing new: a
//! speed that is given twice, a power beside its torque and its speed. What the differential equations add to that is
//! seen only in solving.

use generated::BoundaryKernel;
use nalgebra::DMatrix;

use super::model::Kernels;
use super::question::{Known, Question};
use crate::case::constant_label;
use crate::model::{Constant, IllPosed, ModelChoices};

/// Singular values below this count as zero; rows have length 1.
const ZERO: f64 = 1e-10;
/// Shares of a row in a dependence below this do not count.
const SHARE: f64 = 1e-6;

impl Question {
    /// Refuses a question that has no answer whatever the numbers: two conditions that determine the same thing, or one
    /// that says what the given constants say already.
    ///
    /// # Errors
    /// [`IllPosed`] names the keys. What depends on the numbers shows only in solving, as a singular system.
    pub fn check(&self, model: &ModelChoices) -> Result<(), IllPosed> {
        let default = |constant: Constant| constant.index() < Constant::UNKNOWN;
        for (at, swap) in self.swaps.iter().enumerate() {
            let before = self.swaps.get(..at).unwrap_or_default();
            if default(swap.free) || before.iter().any(|other| other.free == swap.free) {
                return Err(IllPosed::Unknown { constant: constant_label(swap.free).to_owned() });
            }
            if let Known::Constant(constant) = swap.known
                && (!default(constant) || before.iter().any(|other| other.known == swap.known))
            {
                return Err(IllPosed::Given { constant: constant_label(constant).to_owned() });
            }
            if !swap.value.is_finite() {
                return Err(IllPosed::Value { name: swap.known.name(), value: swap.value });
            }
        }
        for (at, closing) in self.closings.iter().enumerate() {
            let before = self.closings.get(..at).unwrap_or_default();
            let twice = before.iter().any(|other| other.free == closing.free)
                || self.swaps.iter().any(|swap| swap.free == closing.free);
            if default(closing.free) || twice {
                return Err(IllPosed::Unknown { constant: constant_label(closing.free).to_owned() });
            }
        }
        let Some(kernels) = Kernels::of(model).filter(|_| !self.swaps.is_empty()) else { return Ok(()) };
        if let Some((output, _)) = self.conditions().find(|(output, _)| kernels.outputs.row(*output).is_none()) {
            return Err(IllPosed::NoOutput { name: Known::Output(output).name() });
        }
        let free = self.swaps.iter().map(|swap| constant_label(swap.free).to_owned()).collect();
        match dependence(&kernels, self) {
            Some(names) => Err(IllPosed::Dependent { names, free }),
            None => Ok(()),
        }
    }
}

/// Those of the given constants and prescribed outputs that depend on each other; `None` if all are independent.
fn dependence(kernels: &Kernels, question: &Question) -> Option<Vec<String>> {
    let point = Point::generic(kernels.boundary);
    let mut rows: Vec<(Option<String>, Vec<f64>)> =
        point.gradients(kernels.boundary).into_iter().map(|gradient| (None, gradient)).collect();
    let unknowns = question.unknowns();
    let first = point.ends.len() + point.integrals.len();
    for constant in Constant::ALL.into_iter().filter(|constant| !unknowns.contains(constant)) {
        let mut gradient = vec![0.0; point.inputs()];
        if let Some(entry) = gradient.get_mut(first + constant.index()) {
            *entry = 1.0;
        }
        rows.push((Some(constant_label(constant).to_owned()), gradient));
    }
    let outputs = point.gradients(&kernels.outputs.set);
    for (output, _) in question.conditions() {
        // An output that the drive does not have is refused before.
        let gradient = kernels.outputs.row(output).and_then(|row| outputs.get(row)).cloned();
        rows.extend(gradient.map(|gradient| (Some(Known::Output(output).name()), gradient)));
    }
    if rows.iter().any(|(_, row)| row.iter().any(|entry| !entry.is_finite())) {
        return None;
    }
    let matrix = DMatrix::from_fn(rows.len(), point.inputs(), |row, column| {
        let row = &rows[row].1;
        row[column] / row.iter().map(|entry| entry * entry).sum::<f64>().sqrt().max(f64::MIN_POSITIVE)
    });
    let svd = matrix.svd(true, false);
    let left = svd.u?;
    let (at, smallest) = svd.singular_values.argmin();
    if smallest > ZERO {
        return None;
    }
    let shares = left.column(at);
    let involved = rows.iter().zip(shares.iter()).filter(|(_, share)| share.abs() > SHARE);
    let mut names: Vec<String> = involved.filter_map(|((name, _), _)| name.clone()).collect();
    names.dedup();
    Some(names)
}

/// Ends, integrals and constants without meaning and without special relations.
struct Point {
    ends: Vec<f64>,
    integrals: Vec<f64>,
    constants: Vec<f64>,
}

impl Point {
    fn generic(kernel: &BoundaryKernel) -> Self {
        // Weyl's sequence, scaled so that penetrations stay below radii.
        let value = |i: usize| 0.3 + 0.5 * (0.618_033_988_749_894_9 * (i + 1) as f64).fract();
        let (ends, integrals) = (kernel.ends.len(), kernel.integrals.len());
        Self {
            ends: (0..ends).map(|i| 0.1 * value(i)).collect(),
            integrals: (ends..ends + integrals).map(value).collect(),
            constants: (0..kernel.constants.len()).map(|i| value(ends + integrals + i)).collect(),
        }
    }

    fn inputs(&self) -> usize {
        self.ends.len() + self.integrals.len() + self.constants.len()
    }

    /// Gradient of each equation.
    fn gradients(&self, kernel: &BoundaryKernel) -> Vec<Vec<f64>> {
        let mut values = vec![0.0; kernel.equations.len()];
        let mut partials = vec![0.0; kernel.pattern.len()];
        (kernel.jacobian)(&self.ends, &self.integrals, &self.constants, &mut values, &mut partials);
        let mut rows = vec![vec![0.0; self.inputs()]; kernel.equations.len()];
        for (&(row, input), partial) in kernel.pattern.iter().zip(&partials) {
            if let Some(entry) = rows.get_mut(row).and_then(|row| row.get_mut(input)) {
                *entry += partial;
            }
        }
        rows
    }
}
