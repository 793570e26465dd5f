//! First-order Taylor expansion about zero, (3.37).

use symbolica::atom::{Atom, AtomCore};
use symbolica::symbol;

use super::substitute;

/// f(0) + Σ ∂f/∂v(0) · v over `small`; every other symbol is kept as it stands.
pub fn linearise(expression: &Atom, small: &[&str]) -> Atom {
    let zeros: Vec<_> = small.iter().map(|&name| (name, Atom::num(0))).collect();
    let at_zero = |term: &Atom| substitute(term, &zeros);
    small.iter().fold(at_zero(expression), |sum, &name| {
        let variable = symbol!(name);
        sum + at_zero(&expression.derivative(variable)) * Atom::var(variable)
    })
}
