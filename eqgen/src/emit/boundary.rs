//! A boundary set as a Rust module.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::{Outputs, scalar};
use super::import::Import;
use super::jacobian::{Jacobian, jacobian};
use super::{Emitted, pairs, symbols, vocabulary};
use crate::error::Error;
use crate::physics::model::BeltTheory;
use crate::physics::model::{BoundaryModel, Role};

/// Emits residuals and their derivatives in all ends, integrals and constants.
///
/// # Errors
/// If a derivative or an operation has no form in the emitted code.
pub fn emit(model: &BoundaryModel) -> Result<Emitted, Error> {
    let base = Import::new(&model.plan, 0)?;
    let rows: Vec<&str> = model.equations.iter().map(|equation| equation.name.as_str()).collect();
    let places: Vec<usize> = (0..model.plan.inputs.len()).collect();
    let mut with_derivatives = base.clone();
    let entries = jacobian(&mut with_derivatives, &rows, &places)?;

    let load = |place: usize| load(model, place);
    let inputs = &model.plan.inputs;
    let (value, value_count) = scalar(&base.graph, inputs, outputs(&base, &rows, None), &load);
    let outputs = outputs(&with_derivatives, &rows, Some(&entries));
    let (derivatives, count) = scalar(&with_derivatives.graph, inputs, outputs, &load);
    let kernel = kernel(model, &entries)?;
    let integrals = quote!(integrals: &[f64]);
    let checks = checks(model, entries.len());
    let tokens = quote! {
        #kernel

        #[doc = "Residuals."]
        fn value(ends: &[f64], #integrals, constants: &[f64], g: &mut [f64]) {
            #checks
            #value
        }

        #[doc = "Residuals and their derivatives."]
        fn derivatives(ends: &[f64], #integrals, constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
            #checks
            let dz = sized(dz, PATTERN.len(), "dz");
            #derivatives
        }
    };
    let counts = vec![("value".to_owned(), value_count), ("jacobian".to_owned(), count)];
    Ok(Emitted { name: model.name.clone(), doc: model.doc.clone(), tokens, counts })
}

fn outputs<'a>(import: &Import<'_>, rows: &[&str], entries: Option<&Jacobian>) -> Outputs<'a> {
    let mut outputs: Outputs<'a> = Vec::new();
    let mut write = |node, target: &str, row: usize| {
        let (target, row) = (format_ident!("{target}"), Literal::usize_unsuffixed(row));
        outputs.push((node, Box::new(move |value: TokenStream| quote!(#target[#row] = #value;))));
    };
    for (row, name) in rows.iter().enumerate() {
        write(import.nodes[*name], "g", row);
    }
    for (place, node) in entries.into_iter().flat_map(|entries| entries.values().enumerate()) {
        write(*node, "dz", place);
    }
    outputs
}

/// Where an input stands.
fn load(model: &BoundaryModel, place: usize) -> TokenStream {
    let (ends, integrals) = (model.ends.len(), model.integrals.len());
    let (slice, index) = match place {
        _ if place < ends => ("ends", place),
        _ if place < ends + integrals => ("integrals", place - ends),
        _ => ("constants", place - ends - integrals),
    };
    let (slice, index) = (format_ident!("{slice}"), Literal::usize_unsuffixed(index));
    quote!(#slice[#index])
}

/// Fixed sizes: one check here instead of one at every access.
fn checks(model: &BoundaryModel, _entries: usize) -> TokenStream {
    let size = |count: usize| Literal::usize_unsuffixed(count);
    let (ends, integrals) = (size(model.ends.len()), size(model.integrals.len()));
    let (constants, equations) = (size(model.constants.len()), size(model.equations.len()));
    quote! {
        assert!(ends.len() >= #ends, "ends: too few values");
        assert!(integrals.len() >= #integrals, "integrals: too few values");
        assert!(constants.len() >= #constants, "constants: too few values");
        let g = sized(g, #equations, "g");
    }
}

fn kernel(model: &BoundaryModel, entries: &Jacobian) -> Result<TokenStream, Error> {
    let pattern = pairs(entries.keys().copied());
    let (ends, integrals) = (symbols(&model.ends), symbols(&model.integrals));
    let (constants, equations) = match model.role {
        Role::Conditions => (quote!(Constant::SYMBOLS), symbols(&model.equations)),
        Role::Outputs(_) => (quote!(Constant::SYMBOLS), outputs_of(model)),
        Role::Formulae { inputs, outputs } => {
            let (inputs, outputs) = (format_ident!("{inputs}"), format_ident!("{outputs}"));
            (quote!(#inputs::SYMBOLS), quote!(#outputs::SYMBOLS))
        }
    };
    let (name, doc) = (&model.name, &model.doc);
    let set = quote!(BoundaryKernel {
        name: #name,
        equations: #equations,
        ends: #ends,
        integrals: #integrals,
        constants: #constants,
        pattern: PATTERN,
        value,
        jacobian: derivatives,
    });
    let (kind, set) = match model.role {
        Role::Conditions => (quote!(BoundaryKernel), set),
        Role::Outputs(belt) => {
            let belt = format_ident!("{}", if belt == BeltTheory::Beam { "Beam" } else { "String" });
            let outputs = vocabulary::list("Output", &model.equations)?;
            let set = quote!(OutputKernel { theory: BeltTheory::#belt, outputs: #outputs, set: #set });
            (quote!(OutputKernel), set)
        }
        Role::Formulae { inputs, outputs } => {
            let (inputs, outputs) = (format_ident!("{inputs}"), format_ident!("{outputs}"));
            (quote!(FormulaKernel<#inputs, #outputs>), quote!(FormulaKernel::new(#set)))
        }
    };
    Ok(quote! {
        #[doc = "Structurally nonzero derivatives."]
        const PATTERN: &[(usize, usize)] = #pattern;

        #[doc = #doc]
        pub(crate) const KERNEL: #kind = #set;
    })
}

/// The symbols of the outputs that a set has.
fn outputs_of(model: &BoundaryModel) -> TokenStream {
    let variants = model.equations.iter().map(|output| format_ident!("{}", output.variant));
    quote!(&[#(*Output::#variants.symbol()),*])
}
