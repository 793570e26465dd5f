//! From an evaluation plan to a formatted source file.

mod body;
mod boundary;
mod graph;
mod import;
mod jacobian;
mod region;
mod schedule;
mod twin;
mod vocabulary;

pub use body::Count;
pub use graph::{Graph, Node, Operation};
pub use import::Import;
pub use jacobian::{Jacobian, jacobian};
pub use twin::file as twin;
pub use vocabulary::file as vocabulary;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::error::Error;
use crate::physics::model::Model;
use crate::physics::notation;
use crate::plan::{Origin, Plan};

/// A kernel as tokens.
#[derive(Debug)]
pub struct Emitted {
    /// Name of the kernel.
    pub name: String,
    /// What it is.
    pub doc: String,
    /// The module's items.
    pub tokens: TokenStream,
    /// Operations of each function.
    pub counts: Vec<(String, Count)>,
}

/// One generated file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceFile {
    /// Name with extension.
    pub name: String,
    /// Text.
    pub text: String,
}

/// Where a file comes from; its header says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Provenance {
    /// What it is generated from.
    pub source: &'static str,
    /// The command that writes it anew.
    pub command: &'static str,
}

/// Provenance of the belt's kernels.
pub const BELT: Provenance = Provenance { source: "eqgen/src/physics", command: "cargo run -p sheave-eqgen -- write" };

/// The source file of one kernel.
///
/// # Errors
/// If the kernel cannot be emitted.
pub fn file(model: &Model, provenance: Provenance) -> Result<SourceFile, Error> {
    let emitted = match model {
        Model::Region(model) => region::emit(model)?,
        Model::Boundary(model) => boundary::emit(model)?,
    };
    let name = format!("{}.rs", emitted.name);
    let tokens = |error: syn::Error| Error::Tokens { file: name.clone(), message: error.to_string() };
    let parsed: syn::File = syn::parse2(emitted.tokens.clone()).map_err(tokens)?;
    let text = format!("{}\n{}", header(&emitted, model.plan(), provenance), prettyplease::unparse(&parsed));
    Ok(SourceFile { name, text })
}

/// How an equation came about, in words.
fn origin(origin: Origin) -> &'static str {
    match origin {
        Origin::Primitive => "(typed in)",
        Origin::Derived => "(derived)",
        Origin::Printed => "(as printed)",
    }
}

fn header(emitted: &Emitted, plan: &Plan, provenance: Provenance) -> String {
    let Provenance { source, command } = provenance;
    let mut lines = vec![
        format!("// {}: {}", emitted.name, emitted.doc),
        format!("// Generated from {source}. Do not edit:"),
        format!("// `{command}` writes it anew."),
        "// Operations:".to_owned(),
    ];
    lines.extend(emitted.counts.iter().map(|(name, count)| format!("//   {name}: {count}")));
    lines.push("// Equations, with their numbers in the source:".to_owned());
    lines.extend(plan.steps.iter().map(|step| format!("// - {} {}: {}", step.name, origin(step.origin), step.source)));
    lines.join("\n") + "\n"
}

/// A list of symbols, spelled out.
fn symbols(rows: &[notation::Symbol]) -> TokenStream {
    let rows = rows.iter().map(literal);
    quote!(&[#(#rows),*])
}

/// A symbol, spelled out.
fn literal(row: &notation::Symbol) -> TokenStream {
    let notation::Symbol { name, symbol, unit, dimension, doc, source, .. } = row;
    let angle = unit_angle(unit);
    let number = |exponent: i8| Literal::i8_unsuffixed(exponent);
    let (length, mass, time) = (number(dimension.length), number(dimension.mass), number(dimension.time));
    let (unit, angle) = (printed_unit(unit), number(angle));
    let dimension = quote!(Dimension { length: #length, mass: #mass, time: #time, angle: #angle });
    quote!(Symbol { name: #name, symbol: #symbol, unit: #unit, dimension: #dimension, doc: #doc, source: #source })
}

/// A unit as it is printed.
fn printed_unit(unit: &str) -> String {
    unit.replace(' ', "·").replace("^2", "²").replace("^3", "³")
}

/// Exponent of the radian in a unit: symbolic work takes angles for pure numbers, users do not.
fn unit_angle(unit: &str) -> i8 {
    let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
    let count = |part: &str| part.split_whitespace().filter(|factor| *factor == "rad").count() as i8;
    count(above) - count(below)
}

fn pairs(pairs: impl Iterator<Item = (usize, usize)>) -> TokenStream {
    let number = Literal::usize_unsuffixed;
    let pairs = pairs.map(|(row, column)| (number(row), number(column))).map(|(row, column)| quote!((#row, #column)));
    quote!(&[#(#pairs),*])
}
