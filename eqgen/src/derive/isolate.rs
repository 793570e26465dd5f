//! Linear equations solved for one unknown.

use symbolica::atom::{Atom, AtomCore};
use symbolica::{parse, symbol};

use crate::error::Error;

/// `coefficient · unknown + rest`.
#[derive(Debug, Clone)]
pub struct Linear {
    /// What multiplies the unknown.
    pub coefficient: Atom,
    /// What stands without it.
    pub rest: Atom,
}

/// Splits an expression that is linear in `unknown`; both parts come factored.
///
/// # Errors
/// [`Error::NotLinear`].
pub fn linear_in(expression: &Atom, unknown: &str) -> Result<Linear, Error> {
    let variable = symbol!(unknown);
    let coefficient = expression.derivative(variable).factor();
    if coefficient.contains_symbol(variable) {
        return Err(Error::NotLinear { unknown: unknown.into(), equation: expression.to_string() });
    }
    let rest = expression.replace(parse!(unknown)).with(Atom::num(0)).factor();
    Ok(Linear { coefficient, rest })
}

/// `square · unknown² + linear · unknown + constant`.
#[derive(Debug, Clone)]
pub struct Quadratic {
    /// What multiplies the unknown's square.
    pub square: Atom,
    /// What multiplies the unknown.
    pub linear: Atom,
    /// What stands without it.
    pub constant: Atom,
}

/// Splits a polynomial of second degree in `unknown`; the parts come factored.
///
/// # Errors
/// [`Error::NotQuadratic`].
pub fn quadratic_in(expression: &Atom, unknown: &str) -> Result<Quadratic, Error> {
    let variable = symbol!(unknown);
    let at_zero = |value: &Atom| value.replace(parse!(unknown)).with(Atom::num(0)).factor();
    let slope = expression.derivative(variable);
    let square = (slope.derivative(variable) / Atom::num(2)).factor();
    if square.is_zero() || square.contains_symbol(variable) {
        return Err(Error::NotQuadratic { unknown: unknown.into(), equation: expression.to_string() });
    }
    Ok(Quadratic { square, linear: at_zero(&slope), constant: at_zero(expression) })
}

/// The `unknown` for which `residual` vanishes.
///
/// # Errors
/// [`Error::NotLinear`], also if the unknown does not occur.
pub fn solve_linear(residual: &Atom, unknown: &str) -> Result<Atom, Error> {
    let Linear { coefficient, rest } = linear_in(residual, unknown)?;
    if coefficient.is_zero() {
        return Err(Error::NotLinear { unknown: unknown.into(), equation: residual.to_string() });
    }
    Ok((-rest / coefficient).factor())
}
