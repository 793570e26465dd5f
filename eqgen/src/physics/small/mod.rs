//! Small models beside the full one: formulae in named inputs, without regions and ends.

pub mod actuator;
pub mod drive;
pub mod hysteresis;
pub mod pulley;
pub mod sizing;

use super::model::{BoundaryModel, Model, Role};
pub use super::notation::Row;
use super::notation::{self, Symbol};
use crate::dimension::Dimensions;
use crate::error::Error;
use crate::plan::Plan;

/// A table of symbols, and the name of the generated enum that identifies them.
type Table = (&'static str, &'static [Row]);

/// A row from name, printed symbol, SI unit and meaning.
const fn row(name: &'static str, symbol: &'static str, unit: &'static str, doc: &'static str) -> Row {
    notation::row(name, symbol, unit, 0, doc)
}

/// All small models, in the order in which they are emitted.
///
/// # Errors
/// The first inconsistency of any equation.
pub fn kernels() -> Result<Vec<Model>, Error> {
    let models = [
        drive::residuals()?,
        drive::closed()?,
        pulley::model()?,
        pulley::limits()?,
        sizing::model()?,
        sizing::idler()?,
        actuator::flyweight_table()?,
        actuator::flyweight_ramp()?,
        actuator::flyweight_arm()?,
        actuator::flyweight_roller()?,
        actuator::spring()?,
        actuator::helix()?,
        actuator::travel()?,
        actuator::vehicle()?,
    ];
    Ok(models.into_iter().chain(hysteresis::models()?).map(Model::Boundary).collect())
}

/// A set of formulae on the way: inputs from outside, steps between, and outputs, each a step of its own name.
struct Sheet {
    plan: Plan,
    inputs: Table,
    outputs: Table,
}

impl Sheet {
    /// An empty sheet; `steps` are the symbols between inputs and outputs.
    fn new(inputs: Table, steps: &[Row], outputs: Table) -> Result<Self, Error> {
        let rows = inputs.1.iter().chain(steps).chain(outputs.1);
        let extra: Dimensions = rows.map(|row| (row.name.to_owned(), Symbol::from(row).dimension)).collect();
        let plan = Plan::new(inputs.1.iter().map(|row| row.name.to_owned()).collect(), extra)?;
        Ok(Self { plan, inputs, outputs })
    }

    fn finish(self, name: &str, doc: &str) -> BoundaryModel {
        let output = |row: &Row| {
            let source = self.plan.step(row.name).map_or("", |step| step.source);
            Symbol { source, ..identified(row) }
        };
        BoundaryModel {
            name: name.to_owned(),
            doc: doc.to_owned(),
            ends: Vec::new(),
            integrals: Vec::new(),
            constants: self.inputs.1.iter().map(identified).collect(),
            equations: self.outputs.1.iter().map(output).collect(),
            role: Role::Formulae { inputs: self.inputs.0, outputs: self.outputs.0 },
            plan: self.plan,
        }
    }
}

/// The symbol of a row; without a variant of its own it is known by its name's words.
fn identified(row: &Row) -> Symbol {
    let symbol = Symbol::from(row);
    if symbol.variant.is_empty() { Symbol { variant: notation::camel_case(row.name), ..symbol } } else { symbol }
}
