//! Grammar of a quantity:
//!
//! ```text
//! quantity = number [ product | a unit as workshops write it, such as ft-lb ]
//! product  = factor { ( "*" | "·" | "⋅" | "/" | " " ) factor }      from left to right: kg/m*s is (kg/m)*s
//! factor   = ( symbol | "(" product ")" ) [ exponent ]
//! exponent = "^" [ "-" | "+" ] digit | superscript
//! ```

use super::unit::{self, Scale};
use super::{Dimension, Quantity, QuantityError};

/// Deepest nesting of parentheses.
const DEPTH: usize = 8;

pub(super) fn quantity(text: &str) -> Result<Quantity, QuantityError> {
    let text = text.trim();
    let (number, rest) = split_number(text);
    let value = number.parse::<f64>().map_err(|_| no_number(text))?;
    let rest = rest.trim();
    if let Some(si) = on_shifted_scale(value, rest) {
        let dimension = Dimension::TEMPERATURE;
        return if si.is_finite() {
            Ok(Quantity { si, dimension, bare: false })
        } else {
            Err(QuantityError::NotFinite)
        };
    }
    let scale = match unit::workshop(rest) {
        Some(scale) => scale,
        None if rest.is_empty() => Scale::ONE,
        None => Reader { rest, depth: 0 }.all()?,
    };
    let si = scale.to_si(value);
    if !si.is_finite() {
        return Err(QuantityError::NotFinite);
    }
    Ok(Quantity { si, dimension: scale.dimension, bare: rest.is_empty() })
}

/// A temperature on a scale whose zero is not the absolute one, in K; such a unit stands alone.
pub(crate) fn on_shifted_scale(value: f64, unit: &str) -> Option<f64> {
    match unit {
        "degC" | "°C" => Some(value + super::ZERO_CELSIUS),
        "degF" | "°F" => Some((value - 32.0) / 1.8 + super::ZERO_CELSIUS),
        _ => None,
    }
}

fn no_number(text: &str) -> QuantityError {
    match text.trim_start_matches(['+', '-']).to_ascii_lowercase() {
        name if name.starts_with("inf") || name.starts_with("nan") => QuantityError::NotFinite,
        _ => QuantityError::NoNumber,
    }
}

/// Splits after the longest number at the front: digits, a point, an exponent.
pub(super) fn split_number(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let sign = |at: usize| usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let mut end = sign(0);
    end += digits(end);
    if bytes.get(end) == Some(&b'.') {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent = end + 1 + sign(end + 1);
        if digits(exponent) > 0 {
            end = exponent + digits(exponent);
        }
    }
    text.split_at(end)
}

/// What is left of a unit's text.
struct Reader<'a> {
    rest: &'a str,
    depth: usize,
}

impl Reader<'_> {
    fn all(mut self) -> Result<Scale, QuantityError> {
        let product = self.product()?;
        match self.rest.chars().next() {
            None => Ok(product),
            Some(found) => Err(QuantityError::Unexpected { found }),
        }
    }

    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    fn skip(&mut self, c: char) {
        self.rest = self.rest.get(c.len_utf8()..).unwrap_or_default();
    }

    fn product(&mut self) -> Result<Scale, QuantityError> {
        let mut product = self.factor()?;
        loop {
            self.rest = self.rest.trim_start();
            let sign = match self.peek() {
                Some(c @ ('*' | '·' | '⋅')) => {
                    self.skip(c);
                    1
                }
                Some('/') => {
                    self.skip('/');
                    -1
                }
                Some(c) if c == '(' || is_symbol(c) => 1,
                _ => return Ok(product),
            };
            let factor = self.factor()?;
            product = product.times(factor, sign).ok_or(QuantityError::Exponent)?;
        }
    }

    fn factor(&mut self) -> Result<Scale, QuantityError> {
        self.rest = self.rest.trim_start();
        let base = match self.peek() {
            Some('(') => self.parenthesis()?,
            Some(c) if is_symbol(c) || c == '1' => self.symbol()?,
            Some(found) => return Err(QuantityError::Unexpected { found }),
            None => return Err(QuantityError::Incomplete),
        };
        let exponent = self.exponent()?;
        Scale::ONE.times(base, exponent).ok_or(QuantityError::Exponent)
    }

    fn parenthesis(&mut self) -> Result<Scale, QuantityError> {
        if self.depth == DEPTH {
            return Err(QuantityError::Unexpected { found: '(' });
        }
        self.depth += 1;
        self.skip('(');
        let product = self.product()?;
        self.depth -= 1;
        match self.peek() {
            Some(')') => self.skip(')'),
            Some(found) => return Err(QuantityError::Unexpected { found }),
            None => return Err(QuantityError::Incomplete),
        }
        Ok(product)
    }

    fn symbol(&mut self) -> Result<Scale, QuantityError> {
        let length = match self.rest.find(|c| !is_symbol(c)) {
            // The "1" of "1/s", and of nothing else: "0.4 1" is no number.
            Some(0) if self.rest.get(1..).is_some_and(|rest| rest.trim_start().starts_with('/')) => 1,
            Some(0) => return Err(QuantityError::Unexpected { found: '1' }),
            Some(length) => length,
            None if self.rest == "1" => return Err(QuantityError::Unexpected { found: '1' }),
            None => self.rest.len(),
        };
        let (symbol, rest) = self.rest.split_at(length);
        let known = unit::find(symbol).ok_or_else(|| QuantityError::unknown_unit(symbol))?;
        self.rest = rest;
        Ok(known)
    }

    /// The exponent behind a factor, 1 without one.
    fn exponent(&mut self) -> Result<i8, QuantityError> {
        if self.peek() == Some('^') {
            self.skip('^');
            let negative = self.peek() == Some('-');
            if let Some(sign @ ('-' | '+')) = self.peek() {
                self.skip(sign);
            }
            let length = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
            let (digits, rest) = self.rest.split_at(length);
            self.rest = rest;
            return checked_exponent(digits, negative);
        }
        let superscript = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip('0'..='9').find(|(s, _)| *s == c).map(|(_, digit)| digit);
        let negative = self.peek() == Some('⁻');
        if negative {
            self.skip('⁻');
        }
        let mut digits = String::new();
        while let Some((c, digit)) = self.peek().and_then(|c| Some((c, superscript(c)?))) {
            digits.push(digit);
            self.skip(c);
        }
        if digits.is_empty() && !negative { Ok(1) } else { checked_exponent(&digits, negative) }
    }
}

fn is_symbol(c: char) -> bool {
    c.is_alphabetic() || matches!(c, '°' | 'µ' | '%')
}

/// Exponents of one digit are all that physics asks for.
fn checked_exponent(digits: &str, negative: bool) -> Result<i8, QuantityError> {
    match digits.parse::<i8>() {
        Ok(exponent @ 0..=9) => Ok(if negative { -exponent } else { exponent }),
        _ => Err(QuantityError::Exponent),
    }
}
