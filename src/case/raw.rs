//! Values as they stand in a text, before anything is known of their keys.

use std::borrow::Cow;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value as it stands in a text.
pub(crate) enum Raw<'a> {
    /// A TOML string, or the value of an argument, which may be a number as well.
    Text(Cow<'a, str>),
    /// A TOML number.
    Number(f64),
    /// A TOML array.
    List(Vec<Raw<'a>>),
    /// Anything else.
    Other(&'static str),
}

/// A value as a file has it.
pub(crate) fn raw<'a>(value: &'a DeValue<'_>) -> Raw<'a> {
    match value {
        DeValue::String(text) => Raw::Text(text.as_ref().into()),
        // Integers too long for a float become infinite, and are refused as such.
        DeValue::Integer(integer) if integer.radix() == 10 => {
            integer.as_str().parse().map_or(Raw::Other("an integer"), Raw::Number)
        }
        DeValue::Float(float) => float.as_str().parse().map_or(Raw::Other("a number"), Raw::Number),
        DeValue::Array(items) => Raw::List(items.iter().map(|item| raw(item.get_ref())).collect()),
        other => Raw::Other(kind(other)),
    }
}

/// What a value is, in words.
pub(crate) fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a string",
        DeValue::Integer(integer) if integer.radix() == 10 => "an integer",
        DeValue::Integer(_) => "an integer that is not decimal",
        DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "a boolean",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "an array",
        DeValue::Table(_) => "a table",
    }
}

/// Entries of a table in the order of the text.
pub(crate) fn in_order<'a, 'i>(table: &'a DeTable<'i>) -> Vec<(&'a Spanned<Cow<'i, str>>, &'a Spanned<DeValue<'i>>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}
