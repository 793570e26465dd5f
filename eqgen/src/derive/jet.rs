//! Derivatives along the belt: θ and x are functions of the wrap angle φ, their derivatives symbols of their own.

use symbolica::atom::{Atom, AtomCore, Symbol};
use symbolica::symbol;

use super::substitute;
use crate::error::Error;

/// θ, θ', θ'', θ''' and x, x', x''.
const JETS: [&[&str]; 2] = [&["theta", "theta_1", "theta_2", "theta_3"], &["x", "x_1", "x_2"]];

/// D = ∂/∂φ + Σ θ⁽ᵏ⁺¹⁾ ∂/∂θ⁽ᵏ⁾ + Σ x⁽ᵏ⁺¹⁾ ∂/∂x⁽ᵏ⁾.
///
/// # Errors
/// [`Error::JetOrder`] if a derivative beyond θ''' or x'' would be needed.
pub fn total_derivative(expression: &Atom) -> Result<Atom, Error> {
    let mut total = expression.derivative(symbol!("phi"));
    for jet in JETS {
        for (index, &name) in jet.iter().enumerate() {
            let partial = expression.derivative(name_symbol(name));
            if partial.is_zero() {
                continue;
            }
            let Some(&next) = jet.get(index + 1) else {
                return Err(Error::JetOrder { expression: expression.to_string(), highest: name.into() });
            };
            total += partial * Atom::var(name_symbol(next));
        }
    }
    Ok(total)
}

/// `expression` with x' and x'' as functions of θ, θ' and x; `slope` is x'(θ, x).
///
/// # Errors
/// As [`total_derivative`].
pub fn on_path(expression: &Atom, slope: &Atom) -> Result<Atom, Error> {
    let bend = total_derivative(slope)?;
    let bend = substitute(&bend, &[("x_1", slope.clone())]);
    Ok(substitute(expression, &[("x_2", bend), ("x_1", slope.clone())]).factor())
}

fn name_symbol(name: &str) -> Symbol {
    symbol!(name)
}
