//! Small models beside the full one: formulae in named inputs, without regions and ends.

pub mod actuator;
pub mod drive;
pub mod pulley;
pub mod sizing;

use super::model::{BoundaryModel, Model};
use super::notation::Symbol;
use crate::dimension::{Dimension, Dimensions};
use crate::error::Error;
use crate::plan::Plan;

/// (name, symbol, SI unit, meaning)
pub type Row = (&'static str, &'static str, &'static str, &'static str);

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
    Ok(models.into_iter().map(Model::Boundary).collect())
}

/// A set of formulae on the way: inputs from outside, steps between, and outputs, each a step of its own name.
struct Sheet {
    plan: Plan,
    inputs: &'static [Row],
    outputs: &'static [Row],
}

impl Sheet {
    /// An empty sheet; `steps` are the symbols between inputs and outputs.
    fn new(inputs: &'static [Row], steps: &[Row], outputs: &'static [Row]) -> Result<Self, Error> {
        let dimensions = |rows: &[Row]| rows.iter().map(|row| (row.0.to_owned(), symbol(row).dimension)).collect();
        let mut extra: Dimensions = dimensions(inputs);
        extra.extend::<Dimensions>(dimensions(steps));
        extra.extend::<Dimensions>(dimensions(outputs));
        let plan = Plan::new(inputs.iter().map(|row| row.0.to_owned()).collect(), extra)?;
        Ok(Self { plan, inputs, outputs })
    }

    fn finish(self, name: &str, doc: &str) -> BoundaryModel {
        let equation = |row: &Row| match row.2 {
            "" => (row.0.to_owned(), row.3.to_owned()),
            unit => (row.0.to_owned(), format!("{}, {}", row.3, unit.replace(' ', "·"))),
        };
        BoundaryModel {
            name: name.to_owned(),
            doc: doc.to_owned(),
            plan: self.plan,
            ends: Vec::new(),
            integrals: Vec::new(),
            constants: self.inputs.iter().map(symbol).collect(),
            equations: self.outputs.iter().map(equation).collect(),
        }
    }
}

fn symbol(&(name, symbol, unit, doc): &Row) -> Symbol {
    let dimension = Dimension::of_unit(unit).unwrap_or_else(|| unreachable!("unit of {name}"));
    Symbol { name: name.to_owned(), symbol: symbol.to_owned(), unit, dimension, doc: doc.to_owned() }
}
