//! Tables that stand in place of a number: `loss_tangent = { frequency = [..], temperature = [..], value = [[..]] }`.

use super::error::{CaseError, CaseProblem};
use super::grid::{Grid, GridError, KEYS};
use super::keys::Key;
use super::place::Place;
use super::raw::{Raw, in_order, kind, raw};
use super::value::quantity_value;
use crate::quantity::{self, Dimension};
use crate::text::quoted;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// What a key's quantity may be given over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// Nothing: it is a number.
    Nothing,
    /// The belt's temperature.
    Temperature,
    /// The frequency at which the belt's material is strained, and the belt's temperature.
    FrequencyAndTemperature,
}

impl Over {
    /// In words, for messages and help.
    pub const fn words(self) -> Option<&'static str> {
        match self {
            Self::Nothing => None,
            Self::Temperature => Some("or a table over the temperature, { temperature = [..], value = [..] }"),
            Self::FrequencyAndTemperature => Some(
                "or a table over frequency, temperature or both, { frequency = [..], temperature = [..], value = \
                [[..]] }",
            ),
        }
    }
}

impl Key {
    /// What its quantity may be given over, in a table that stands in place of a number.
    pub const fn over(self) -> Over {
        match self {
            Self::BendingStiffness | Self::RadialStiffness => Over::Temperature,
            Self::LossTangent | Self::CordLossTangent => Over::FrequencyAndTemperature,
            _ => Over::Nothing,
        }
    }
}

/// A table being read: its key, the place of the whole, and what is added to spans within it.
pub(super) struct Reader<'a> {
    pub key: Key,
    pub place: &'a Place,
    pub offset: usize,
}

impl Reader<'_> {
    /// Reads the table of a key.
    ///
    /// # Errors
    /// [`CaseProblem::Table`], or what is wrong with a quantity in it, at its own place.
    pub fn read(&self, table: &DeTable<'_>) -> Result<Grid, CaseError> {
        let [frequency, temperature, _] = KEYS;
        let (mut frequencies, mut temperatures, mut values) = (Vec::new(), Vec::new(), None);
        for (name, value) in in_order(table) {
            match name.get_ref().as_ref() {
                name if name == frequency && self.key.over() == Over::FrequencyAndTemperature => {
                    frequencies = self.axis(frequency, value, Dimension::FREQUENCY)?;
                }
                name if name == temperature => {
                    temperatures = self.axis(temperature, value, Dimension::TEMPERATURE)?;
                }
                "value" => values = Some(value),
                other => {
                    let reason = format!("`{}` has no place in it", quoted(other));
                    return Err(self.wrong(reason, name.span()));
                }
            }
        }
        let whole =
            self.place.value.start.saturating_sub(self.offset)..self.place.value.end.saturating_sub(self.offset);
        let Some(values) = values else { return Err(self.wrong("`value` is not given".into(), whole)) };
        let rows = self.rows(values, frequencies.is_empty(), temperatures.is_empty())?;
        Grid::new(frequencies, temperatures, rows).map_err(|error| match error {
            GridError::Empty | GridError::Order { .. } => self.wrong(error.to_string(), whole),
            GridError::Rows { .. } | GridError::Columns { .. } | GridError::Value { .. } => {
                self.wrong(error.to_string(), values.span())
            }
        })
    }

    fn wrong(&self, reason: String, span: std::ops::Range<usize>) -> CaseError {
        let expected = self.key.over().words().unwrap_or_default();
        CaseError::new(CaseProblem::Table { key: self.key, reason, expected }, [self.at(span)])
    }

    fn at(&self, span: std::ops::Range<usize>) -> Place {
        let value = span.start + self.offset..span.end + self.offset;
        Place { source: self.place.source.clone(), key: self.place.key.clone(), value }
    }

    fn items<'t, 'i>(
        &self,
        name: &str,
        value: &'t Spanned<DeValue<'i>>,
    ) -> Result<Vec<&'t Spanned<DeValue<'i>>>, CaseError> {
        match value.get_ref() {
            DeValue::Array(items) => Ok(items.iter().collect()),
            other => Err(self.wrong(format!("`{name}` is {}: expected a list", kind(other)), value.span())),
        }
    }

    /// Frequencies or temperatures.
    fn axis(&self, name: &str, value: &Spanned<DeValue<'_>>, dimension: Dimension) -> Result<Vec<f64>, CaseError> {
        let one = |item: &Spanned<DeValue<'_>>| {
            let place = self.at(item.span());
            let read = match raw(item.get_ref()) {
                Raw::Text(text) => quantity::parse(&text).and_then(|read| read.expect(dimension)),
                Raw::Number(si) if si.is_finite() => Ok(si),
                Raw::Number(_) => Err(quantity::QuantityError::NotFinite),
                Raw::List(_) => {
                    return Err(
                        self.wrong(format!("an item of `{name}` is an array: expected {dimension}"), item.span())
                    );
                }
                Raw::Other(given) => {
                    return Err(
                        self.wrong(format!("an item of `{name}` is {given}: expected {dimension}"), item.span())
                    );
                }
            };
            read.map_err(|reason| {
                let given = quoted(place.given());
                self.wrong(format!("`{name}` has {given}, and {reason}"), item.span())
            })
        };
        self.items(name, value)?.into_iter().map(one).collect()
    }

    /// A row for each frequency with a value for each temperature.
    fn rows(&self, value: &Spanned<DeValue<'_>>, one_row: bool, one_column: bool) -> Result<Vec<Vec<f64>>, CaseError> {
        let items = self.items("value", value)?;
        if one_row || one_column {
            let flat = items.into_iter().map(|item| self.quantity(item)).collect::<Result<Vec<f64>, _>>()?;
            return Ok(if one_row { vec![flat] } else { flat.into_iter().map(|value| vec![value]).collect() });
        }
        let row = |item| self.items("value", item)?.into_iter().map(|item| self.quantity(item)).collect();
        items.into_iter().map(row).collect()
    }

    fn quantity(&self, item: &Spanned<DeValue<'_>>) -> Result<f64, CaseError> {
        let place = self.at(item.span());
        let given = quoted(place.given()).into_owned();
        match raw(item.get_ref()) {
            Raw::Other(given) => Err(self.wrong(format!("an item of `value` is {given}"), item.span())),
            raw => quantity_value(self.key, raw, &given).map_err(|problem| CaseError::new(problem, [place])),
        }
    }
}
