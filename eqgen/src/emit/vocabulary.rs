//! The enums by which callers of the kernels name quantities: states, fields, integrals, constants, outputs.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::{Provenance, SourceFile, literal};
use crate::error::Error;
use crate::physics::model::BeltTheory;
use crate::physics::model::{Model, Role};
use crate::physics::notation::Symbol;
use crate::physics::outputs;

/// Name of the generated file.
pub const FILE: &str = "vocabulary.rs";

/// One enum: its name, what it is, and its variants in order.
#[derive(Debug, Clone)]
struct Vocabulary {
    name: &'static str,
    doc: &'static str,
    symbols: Vec<Symbol>,
}

/// The vocabulary of these kernels. `notation` gives the order of states, fields, integrals and constants of a region;
/// constants of the drive stand in the order of the boundary sets.
///
/// # Errors
/// [`Error::Variant`] for a symbol that a kernel names and that has no variant; [`Error::Tokens`].
pub fn file(models: &[Model], notation: &[Symbol], provenance: Provenance) -> Result<SourceFile, Error> {
    let mut all = regions(models, notation);
    let constants = models.iter().find_map(|model| match model {
        Model::Boundary(set) if set.role == Role::Conditions => Some(set.constants.clone()),
        _ => None,
    });
    all.push(Vocabulary {
        name: "Constant",
        doc: "A constant of the whole drive, given or unknown, in the order of every vector of constants.",
        symbols: constants.unwrap_or_default(),
    });
    let mut extra = TokenStream::new();
    if models.iter().any(|model| matches!(model, Model::Boundary(set) if matches!(set.role, Role::Outputs(_)))) {
        let mut symbols = outputs::all();
        symbols.iter_mut().for_each(|symbol| symbol.name = symbol.name.replace("__", "."));
        extra = belts(&symbols);
        let doc = "What a drive is asked for. Its name is its group and its key in the result object.";
        all.push(Vocabulary { name: "Output", doc, symbols });
    }
    formulae(models, &mut all);
    let items = all.iter().map(item).collect::<Result<Vec<_>, _>>()?;
    let tokens = quote!(#(#items)* #extra);
    let error = |error: syn::Error| Error::Tokens { file: FILE.into(), message: error.to_string() };
    let parsed: syn::File = syn::parse2(tokens).map_err(error)?;
    let Provenance { source, command } = provenance;
    let head = format!(
        "// The enums by which callers of the kernels name quantities.\n\
         // Generated from {source}. Do not edit:\n// `{command}` writes it anew.\n"
    );
    Ok(SourceFile { name: FILE.into(), text: format!("{head}\n{}", prettyplease::unparse(&parsed)) })
}

/// What regions have, each in the order of the notation.
fn regions(models: &[Model], notation: &[Symbol]) -> Vec<Vocabulary> {
    let mut used: [BTreeSet<&str>; 4] = Default::default();
    for model in models {
        let Model::Region(model) = model else { continue };
        let lists = [model.states, model.constants, model.integrals, model.fields];
        used.iter_mut().zip(lists).for_each(|(used, names)| used.extend(names));
    }
    let [states, constants, integrals, fields] = used
        .map(|used| notation.iter().filter(|symbol| used.contains(symbol.name.as_str())).cloned().collect::<Vec<_>>());
    vec![
        Vocabulary {
            name: "State",
            doc: "A state of a region: what its differential equations are of.",
            symbols: states,
        },
        Vocabulary {
            name: "RegionConstant",
            doc: "A constant as a single region knows it; the drive's constants give it its value.",
            symbols: constants,
        },
        Vocabulary { name: "Integral", doc: "An integral along a region.", symbols: integrals },
        Vocabulary {
            name: "Field",
            doc: "A quantity along a region that follows from its states and constants.",
            symbols: fields,
        },
    ]
}

/// Inputs and outputs of the small models; a table that several sets share is one enum.
fn formulae(models: &[Model], all: &mut Vec<Vocabulary>) {
    for model in models {
        let Model::Boundary(set) = model else { continue };
        let Role::Formulae { inputs, outputs } = set.role else { continue };
        let tables = [
            (inputs, "An input of a set of formulae.", &set.constants),
            (outputs, "What a set of formulae gives.", &set.equations),
        ];
        for (name, doc, symbols) in tables {
            if all.iter().all(|other| other.name != name) {
                all.push(Vocabulary { name, doc, symbols: symbols.clone() });
            }
        }
    }
}

fn item(vocabulary: &Vocabulary) -> Result<TokenStream, Error> {
    let Vocabulary { name, doc, symbols } = vocabulary;
    let variants = symbols.iter().map(variant).collect::<Result<Vec<_>, _>>()?;
    let docs = symbols.iter().map(|symbol| {
        let printed = if symbol.symbol.is_empty() { String::new() } else { format!("{}: ", symbol.symbol) };
        let unit =
            if symbol.unit.is_empty() { String::new() } else { format!(", {}", super::printed_unit(symbol.unit)) };
        let source = if symbol.source.is_empty() { String::new() } else { format!("; {}", symbol.source) };
        format!(" {printed}{}{unit}{source}", symbol.doc)
    });
    let literals = symbols.iter().map(literal);
    let (ident, count, doc) = (format_ident!("{name}"), Literal::usize_unsuffixed(symbols.len()), format!(" {doc}"));
    Ok(quote! {
        #[doc = #doc]
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(u8)]
        pub enum #ident { #(#[doc = #docs] #variants),* }

        impl #ident {
            /// All of them, in order.
            pub const ALL: [Self; #count] = [#(Self::#variants),*];
            /// What they are, in the same order.
            pub const SYMBOLS: &'static [Symbol; #count] = &[#(#literals),*];

            /// Its place in [`Self::ALL`].
            pub const fn index(self) -> usize {
                self as usize
            }

            /// What it is: name, printed symbol, unit, dimension, meaning and source.
            pub const fn symbol(self) -> &'static Symbol {
                &Self::SYMBOLS[self as usize]
            }

            /// Its name in tables and files.
            pub const fn name(self) -> &'static str {
                self.symbol().name
            }
        }

        impl Identity for #ident {
            const COUNT: usize = #count;

            fn place(self) -> usize {
                self as usize
            }
        }
    })
}

/// Which outputs which belts have.
fn belts(symbols: &[Symbol]) -> TokenStream {
    let sets = [BeltTheory::Beam, BeltTheory::String].map(outputs::of);
    let arms = symbols.iter().map(|symbol| {
        let variant = Ident::new(&symbol.variant, Span::call_site());
        let has = sets.each_ref().map(|set| set.iter().any(|other| other.variant == symbol.variant));
        let list = match has {
            [true, true] => quote!(&[BeltTheory::Beam, BeltTheory::String]),
            [true, false] => quote!(&[BeltTheory::Beam]),
            [false, true] => quote!(&[BeltTheory::String]),
            [false, false] => quote!(&[]),
        };
        quote!(Self::#variant => #list)
    });
    quote! {
        impl Output {
            /// The belts whose drives have this output.
            pub const fn theories(self) -> &'static [BeltTheory] {
                match self { #(#arms),* }
            }
        }
    }
}

fn variant(symbol: &Symbol) -> Result<Ident, Error> {
    if symbol.variant.is_empty() {
        return Err(Error::Variant { symbol: symbol.name.clone() });
    }
    Ok(Ident::new(&symbol.variant, Span::call_site()))
}

/// Variants of an enum, as a list.
///
/// # Errors
/// [`Error::Variant`].
pub(super) fn list(name: &str, symbols: &[Symbol]) -> Result<TokenStream, Error> {
    let ident = format_ident!("{name}");
    let variants = symbols.iter().map(variant).collect::<Result<Vec<_>, _>>()?;
    Ok(quote!(&[#(#ident::#variants),*]))
}
