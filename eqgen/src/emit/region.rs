//! A region's kernel as a Rust module.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::{Count, Outputs, batch};
use super::import::Import;
use super::jacobian::{Jacobian, jacobian};
use super::{Emitted, pairs, vocabulary};
use crate::error::Error;
use crate::physics::model::RegionModel;
use crate::physics::notation;

/// Emits value, Jacobian, full Jacobian and fields.
///
/// # Errors
/// If a derivative or an operation has no form in the emitted code.
pub fn emit(model: &RegionModel) -> Result<Emitted, Error> {
    let first_constant = 1 + model.states.len();
    let base = Import::new(&model.plan, first_constant)?;
    let places = |constants: usize| (1..first_constant + constants).collect::<Vec<_>>();
    let mut default = base.clone();
    let default_entries = Entries::split(jacobian(&mut default, model.rows, &places(model.default_unknowns))?, model);
    let mut full = base.clone();
    let full_entries = Entries::split(jacobian(&mut full, model.rows, &places(model.constants.len()))?, model);

    let nothing = Entries::default();
    let (value, value_count) = function(model, "Value", &base, model.rows, &nothing, &[]);
    let (short, short_count) = function(model, "Derivatives", &default, model.rows, &default_entries, &[]);
    let (long, long_count) = function(model, "AllDerivatives", &full, model.rows, &full_entries, &[]);
    let (fields, fields_count) = function(model, "Fields", &base, &[], &nothing, model.fields);
    let kernel = kernel(model, &full_entries, default_entries.constants.len())?;
    let counts = vec![
        ("value".to_owned(), value_count),
        ("jacobian".to_owned(), short_count),
        ("full".to_owned(), long_count),
        ("fields".to_owned(), fields_count),
    ];
    let tokens = quote!(#kernel #value #short #long #fields);
    Ok(Emitted { name: model.name.clone(), doc: model.doc.clone(), tokens, counts })
}

/// Entries of the Jacobian in the order in which they are written.
#[derive(Debug, Default)]
struct Entries {
    /// ((row, state), node), row by row.
    states: Vec<((usize, usize), super::graph::Node)>,
    /// ((row, constant), node): default unknowns first, row by row in both groups.
    constants: Vec<((usize, usize), super::graph::Node)>,
}

impl Entries {
    fn split(jacobian: Jacobian, model: &RegionModel) -> Self {
        let mut entries = Self::default();
        let states = model.states.len();
        for ((row, place), node) in jacobian {
            match place.checked_sub(1 + states) {
                None => entries.states.push(((row, place - 1), node)),
                Some(constant) => entries.constants.push(((row, constant), node)),
            }
        }
        entries.constants.sort_by_key(|((row, constant), _)| (*constant >= model.default_unknowns, *row, *constant));
        entries
    }
}

fn function(
    model: &RegionModel,
    name: &str,
    import: &Import<'_>,
    rows: &[&str],
    entries: &Entries,
    fields: &[&str],
) -> (TokenStream, Count) {
    let mut outputs: Outputs<'_> = Vec::new();
    let mut write = |node, target: &'static str, row: usize| {
        let (target, row) = (format_ident!("write_{target}"), Literal::usize_unsuffixed(row));
        outputs.push((node, Box::new(move |value: TokenStream| quote!(at.#target(#row, #value);))));
    };
    for (row, symbol) in rows.iter().enumerate() {
        write(import.nodes[*symbol], "f", row);
    }
    for (row, (_, node)) in entries.states.iter().enumerate() {
        write(*node, "dy", row);
    }
    for (row, (_, node)) in entries.constants.iter().enumerate() {
        write(*node, "dc", row);
    }
    for (row, symbol) in fields.iter().enumerate() {
        write(import.nodes[*symbol], "field", row);
    }
    let load = |place: usize| match place.checked_sub(1) {
        None => quote!(at.position::<Real>()),
        Some(state) => {
            let state = Literal::usize_unsuffixed(state);
            quote!(at.state::<Real>(#state))
        }
    };
    let halves = batch(&import.graph, &model.plan.inputs, outputs, &load);
    let (sizes, name_ident) = (sizes(model, rows, entries, fields), format_ident!("{name}"));
    let (once, values, each) = (halves.uniform_statements, halves.uniform_values, halves.statements);
    let shared = Literal::usize_unsuffixed(values.len());
    // Newton's iteration lives in these two; the others run once a solution.
    let wide = matches!(name, "Value" | "Derivatives");
    let (summary, count) = (format!(" {}", summary(name)), format!(" {}.", halves.count));
    let tokens = quote! {
        #[doc = #summary]
        #[doc = ""]
        #[doc = #count]
        pub(crate) struct #name_ident;

        impl Sweep for #name_ident {
            #sizes
            const WIDE: bool = #wide;
            type Uniforms = [f64; #shared];

            #[inline]
            fn uniforms(constants: &[f64]) -> Self::Uniforms {
                #once
                [#(#values),*]
            }

            #[inline(always)]
            fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
                #each
            }
        }
    };
    (tokens, halves.count)
}

fn summary(name: &str) -> &'static str {
    match name {
        "Value" => "Right-hand side and integrands.",
        "Derivatives" => "Right-hand side, integrands, and their derivatives in states and default unknowns.",
        "AllDerivatives" => "Right-hand side, integrands, and their derivatives in states and all constants.",
        _ => "Derived fields.",
    }
}

fn sizes(model: &RegionModel, rows: &[&str], entries: &Entries, fields: &[&str]) -> TokenStream {
    let size = |name: &str, value: usize| {
        let (name, value) = (format_ident!("{name}"), Literal::usize_unsuffixed(value));
        quote!(const #name: usize = #value;)
    };
    let all = [
        size("STATES", model.states.len()),
        size("CONSTANTS", model.constants.len()),
        size("F", rows.len()),
        size("DY", entries.states.len()),
        size("DC", entries.constants.len()),
        size("FIELDS", fields.len()),
    ];
    quote!(#(#all)*)
}

fn kernel(model: &RegionModel, entries: &Entries, default_entries: usize) -> Result<TokenStream, Error> {
    let table = |vocabulary: &str, names: &[&str]| {
        let rows: Vec<notation::Symbol> = names.iter().filter_map(|name| model.plan.symbol(name)).collect();
        vocabulary::list(vocabulary, &rows)
    };
    let (states, constants) = (table("State", model.states)?, table("RegionConstant", model.constants)?);
    let (integrals, fields) = (table("Integral", model.integrals)?, table("Field", model.fields)?);
    let (name, default_unknowns) = (&model.name, Literal::usize_unsuffixed(model.default_unknowns));
    let state_pattern = pairs(entries.states.iter().map(|(pair, _)| *pair));
    let constant_pattern = pairs(entries.constants.iter().map(|(pair, _)| *pair));
    let default_entries = Literal::usize_unsuffixed(default_entries);
    let doc = &model.doc;
    Ok(quote! {
        #[doc = #doc]
        pub(crate) const KERNEL: RegionKernel = RegionKernel {
            name: #name,
            states: #states,
            constants: #constants,
            integrals: #integrals,
            fields: #fields,
            default_unknowns: #default_unknowns,
            state_pattern: #state_pattern,
            constant_pattern: #constant_pattern,
            default_entries: #default_entries,
            value: sweep::<Value>,
            jacobian: sweep::<Derivatives>,
            full: sweep::<AllDerivatives>,
            fields_fn: sweep::<Fields>,
        };
    })
}
