//! `sheave derive`: how an edition's equations follow from what is typed in.

use super::case::edition_parser;
use super::output;
use super::stop::Stop;
use clap::{Args, ValueEnum};
use generated::DerivationFormat;
use sheave::case::Edition;
use std::io;

/// Print the derivation of an edition, from primitive relations to the first-order system
///
/// Each step carries its equation number in the thesis and whether it was typed in (p), derived (d), or taken as the
/// thesis prints it (!). Conditions at the ends, guards and the notation stand at its end.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Edition of the equations
    #[arg(long, value_name = "E", default_value = Edition::Consistent.name(), value_parser = edition_parser())]
    edition: String,
    /// How it is written
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum Format {
    /// Plain text with Unicode formulas
    Text,
    /// A LaTeX document
    Latex,
    /// Markdown with LaTeX formulas
    Markdown,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let format = match arguments.format {
        Format::Text => DerivationFormat::Text,
        Format::Latex => DerivationFormat::Latex,
        Format::Markdown => DerivationFormat::Markdown,
    };
    let text = generated::derivation(&arguments.edition, format).ok_or_else(|| {
        let missing = format!("no derivation of the edition `{}`", arguments.edition);
        Stop::Write("the derivation".into(), io::Error::new(io::ErrorKind::NotFound, missing))
    })?;
    output::print(text)
}
