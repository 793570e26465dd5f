//! A slow twin of every kernel, for tests only: each step as it is written, generic over the kind of number, nothing
//! shared and nothing reordered. With dual numbers it gives derivatives that owe nothing to the chain rule over steps.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};
use symbolica::atom::{Atom, AtomView};

use super::SourceFile;
use crate::error::Error;
use crate::physics::model::Model;
use crate::plan::{Definition, Function, Plan};

/// The file of that name, with the twins of those kernels.
///
/// # Errors
/// [`Error::Unsupported`] for a construct that has no form in it.
pub fn file(name: &str, models: &[Model]) -> Result<SourceFile, Error> {
    let name = name.to_owned();
    let functions = models.iter().map(function).collect::<Result<Vec<_>, _>>()?;
    let table = models.iter().map(|model| {
        let (text, ident) = (model.name(), format_ident!("{}", model.name()));
        quote!((#text, #ident::<N>))
    });
    let tokens = quote! {
        #(#functions)*

        /// All twins by the names of their kernels.
        #[allow(clippy::type_complexity)]
        pub fn all<N: Number>() -> Vec<(&'static str, fn(&[N]) -> Vec<N>)> {
            vec![#(#table),*]
        }
    };
    let error = |error: syn::Error| Error::Tokens { file: name.clone(), message: error.to_string() };
    let parsed: syn::File = syn::parse2(tokens).map_err(error)?;
    let head = "// Slow twins of all kernels, for tests: inputs in the plan's order, then rows or equations.\n\
                // Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it \
                anew.\n";
    Ok(SourceFile { name, text: format!("{head}\n{}", prettyplease::unparse(&parsed)) })
}

fn function(model: &Model) -> Result<TokenStream, Error> {
    let (plan, rows): (&Plan, Vec<&str>) = match model {
        Model::Region(model) => (&model.plan, model.rows.to_vec()),
        Model::Boundary(model) => (&model.plan, model.equations.iter().map(|row| row.name.as_str()).collect()),
    };
    let mut statements = Vec::new();
    for (place, name) in plan.inputs.iter().enumerate() {
        let (name, place) = (ident(name), Literal::usize_unsuffixed(place));
        statements.push(quote!(let #name = inputs[#place];));
    }
    for step in &plan.steps {
        let (name, value) = (ident(&step.name), definition(&step.name, &step.definition)?);
        statements.push(quote!(let #name = #value;));
    }
    let (name, rows) = (format_ident!("{}", model.name()), rows.into_iter().map(ident));
    Ok(quote!(pub fn #name<N: Number>(inputs: &[N]) -> Vec<N> { #(#statements)* vec![#(#rows),*] }))
}

fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

fn definition(step: &str, definition: &Definition) -> Result<TokenStream, Error> {
    match definition {
        Definition::Number(value) => {
            let literal = Literal::f64_unsuffixed(*value);
            Ok(quote!(N::number(#literal)))
        }
        Definition::Expression(value) => expression(step, value),
        Definition::Function(function, arguments) => {
            let method = format_ident!(
                "{}",
                match function {
                    Function::Sqrt => "sqrt",
                    Function::Tan => "tan",
                    Function::Tanh => "tanh",
                    Function::Exp => "exp",
                    Function::Ln => "ln",
                    Function::Saturate => "saturate",
                    Function::Angle => "angle",
                    Function::Turn => "turn",
                }
            );
            let arguments = arguments.iter().map(|value| expression(step, value)).collect::<Result<Vec<_>, _>>()?;
            let (first, rest) = arguments.split_at(1);
            Ok(quote!((#(#first)*).#method(#(#rest),*)))
        }
    }
}

fn expression(step: &str, value: &Atom) -> Result<TokenStream, Error> {
    view(step, value.as_view())
}

fn view(step: &str, value: AtomView<'_>) -> Result<TokenStream, Error> {
    let unsupported = || Error::Unsupported { step: step.into(), expression: value.to_string() };
    let parts = |parts: &mut dyn Iterator<Item = AtomView<'_>>| {
        parts.map(|part| view(step, part)).collect::<Result<Vec<TokenStream>, Error>>()
    };
    match value {
        AtomView::Num(_) => number(&value.to_string()).ok_or_else(unsupported),
        AtomView::Var(variable) => match variable.get_symbol().get_stripped_name() {
            "𝜋" => Ok(quote!(N::number(std::f64::consts::PI))),
            name => {
                let name = ident(name);
                Ok(quote!(#name))
            }
        },
        AtomView::Fun(function) => {
            let name = format_ident!("{}", function.get_symbol().get_stripped_name());
            let arguments = parts(&mut function.iter())?;
            Ok(quote!((#(#arguments)*).#name()))
        }
        AtomView::Pow(power) => {
            let (base, exponent) = power.get_base_exp();
            let exponent: i32 = exponent.to_string().parse().map_err(|_| unsupported())?;
            let (base, exponent) = (view(step, base)?, Literal::i32_unsuffixed(exponent));
            Ok(quote!((#base).power(#exponent)))
        }
        AtomView::Mul(product) => {
            let factors = parts(&mut product.iter())?;
            factors
                .into_iter()
                .map(|factor| quote!((#factor)))
                .reduce(|all, factor| quote!(#all * #factor))
                .ok_or_else(unsupported)
        }
        AtomView::Add(sum) => {
            let terms = parts(&mut sum.iter())?;
            terms
                .into_iter()
                .map(|term| quote!((#term)))
                .reduce(|all, term| quote!(#all + #term))
                .ok_or_else(unsupported)
        }
    }
}

fn number(text: &str) -> Option<TokenStream> {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    let (above, below) = (above.parse::<f64>().ok()?, Literal::f64_unsuffixed(below.parse().ok()?));
    let size = Literal::f64_unsuffixed(above.abs());
    Some(if above < 0.0 { quote!(N::number(-#size / #below)) } else { quote!(N::number(#size / #below)) })
}
