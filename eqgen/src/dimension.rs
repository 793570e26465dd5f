//! Physical dimensions, and the check that every term has the right one.

use std::collections::BTreeMap;
use std::fmt;

use symbolica::atom::{Atom, AtomView};

use crate::error::Error;

/// Exponents of mass, length and time, and of the region's own unit: what its non-dimensional independent
/// variable runs over. Wrap angles and arc lengths Φ, L are "per region", hatted derivatives too, so that a
/// missing factor Φ is as wrong as a missing metre.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Dimension {
    /// Exponent of kg.
    pub mass: i8,
    /// Exponent of m.
    pub length: i8,
    /// Exponent of s.
    pub time: i8,
    /// Exponent of the region.
    pub region: i8,
}

impl Dimension {
    /// A pure number, angles included.
    pub const ONE: Self = Self { mass: 0, length: 0, time: 0, region: 0 };

    /// Reads a unit such as `N m^2`, `kg/m`, `rad/s`; `1` or nothing is a pure number.
    pub fn of_unit(unit: &str) -> Option<Self> {
        let (above, below) = unit.split_once('/').unwrap_or((unit, ""));
        Some(Self::product(above)?.times(Self::product(below)?.power(-1)))
    }

    fn product(text: &str) -> Option<Self> {
        text.split_whitespace().try_fold(Self::ONE, |all, factor| Some(all.times(Self::factor(factor)?)))
    }

    fn factor(text: &str) -> Option<Self> {
        let (base, exponent) = match text.split_once('^') {
            Some((base, exponent)) => (base, exponent.parse().ok()?),
            None => (text, 1),
        };
        let of = |mass, length, time| Self { mass, length, time, region: 0 };
        let base = match base {
            "1" | "rad" => Self::ONE,
            "kg" => of(1, 0, 0),
            "m" => of(0, 1, 0),
            "s" => of(0, 0, 1),
            "N" => of(1, 1, -2),
            "W" => of(1, 2, -3),
            _ => return None,
        };
        Some(base.power(exponent))
    }

    /// With this exponent of the region.
    pub const fn per_region(self, region: i8) -> Self {
        Self { region, ..self }
    }

    /// Of the square.
    pub fn squared(self) -> Self {
        self.power(2)
    }

    fn times(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            length: self.length + other.length,
            time: self.time + other.time,
            region: self.region + other.region,
        }
    }

    fn power(self, exponent: i8) -> Self {
        Self {
            mass: self.mass * exponent,
            length: self.length * exponent,
            time: self.time * exponent,
            region: self.region * exponent,
        }
    }

    fn root(self) -> Option<Self> {
        let half = |exponent: i8| (exponent % 2 == 0).then_some(exponent / 2);
        Some(Self {
            mass: half(self.mass)?,
            length: half(self.length)?,
            time: half(self.time)?,
            region: half(self.region)?,
        })
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts = [("kg", self.mass), ("m", self.length), ("s", self.time), ("region", self.region)];
        let text: Vec<String> = parts
            .iter()
            .filter(|(_, exponent)| *exponent != 0)
            .map(|(unit, exponent)| if *exponent == 1 { (*unit).to_owned() } else { format!("{unit}^{exponent}") })
            .collect();
        if text.is_empty() { write!(f, "[1]") } else { write!(f, "[{}]", text.join(" ")) }
    }
}

/// Dimensions of the symbols that an expression may use.
pub type Dimensions = BTreeMap<String, Dimension>;

/// Dimension of `expression`, for the step of that name.
///
/// # Errors
/// [`Error::Dimension`] names the first term that does not fit its neighbours; [`Error::UnknownSymbol`].
pub fn dimension(step: &str, expression: &Atom, known: &Dimensions) -> Result<Dimension, Error> {
    Walk { step, known }.of(expression.as_view())
}

/// Checks that `expression` has the dimension `expected`.
///
/// # Errors
/// As [`dimension`].
pub fn check(step: &str, expression: &Atom, expected: Dimension, known: &Dimensions) -> Result<(), Error> {
    let walk = Walk { step, known };
    walk.expect(expression.as_view(), expected)
}

struct Walk<'a> {
    step: &'a str,
    known: &'a Dimensions,
}

impl Walk<'_> {
    fn of(&self, expression: AtomView<'_>) -> Result<Dimension, Error> {
        match expression {
            AtomView::Num(_) => Ok(Dimension::ONE),
            AtomView::Var(variable) => self.symbol(variable.get_symbol().get_stripped_name()),
            AtomView::Fun(function) => {
                function.iter().try_for_each(|argument| self.expect(argument, Dimension::ONE))?;
                Ok(Dimension::ONE)
            }
            AtomView::Pow(power) => {
                let (base, exponent) = power.get_base_exp();
                self.power(expression, self.of(base)?, exponent)
            }
            AtomView::Mul(product) => {
                product.iter().try_fold(Dimension::ONE, |all, factor| Ok(all.times(self.of(factor)?)))
            }
            AtomView::Add(sum) => {
                let mut terms = sum.iter();
                let Some(first) = terms.next() else { return Ok(Dimension::ONE) };
                let expected = self.of(first)?;
                terms.try_for_each(|term| self.expect(term, expected))?;
                Ok(expected)
            }
        }
    }

    fn symbol(&self, name: &str) -> Result<Dimension, Error> {
        if name == "𝜋" {
            return Ok(Dimension::ONE);
        }
        let unknown = || Error::UnknownSymbol { step: self.step.into(), symbol: name.into() };
        self.known.get(name).copied().ok_or_else(unknown)
    }

    fn power(&self, whole: AtomView<'_>, base: Dimension, exponent: AtomView<'_>) -> Result<Dimension, Error> {
        let unsupported = || Error::Unsupported { step: self.step.into(), expression: whole.to_string() };
        let raised = match exponent.to_string().as_str() {
            "1/2" => base.root(),
            "-1/2" => base.root().map(|root| root.power(-1)),
            integer => integer.parse().ok().map(|exponent| base.power(exponent)),
        };
        raised.ok_or_else(unsupported)
    }

    fn expect(&self, term: AtomView<'_>, expected: Dimension) -> Result<(), Error> {
        // A sum of the wrong dimension is blamed on its terms, one by one.
        if let AtomView::Add(sum) = term {
            return sum.iter().try_for_each(|term| self.expect(term, expected));
        }
        let found = self.of(term)?;
        if found == expected || term.to_owned().is_zero() {
            return Ok(());
        }
        Err(Error::Dimension {
            step: self.step.into(),
            term: term.to_string(),
            found: found.to_string(),
            expected: expected.to_string(),
        })
    }
}
