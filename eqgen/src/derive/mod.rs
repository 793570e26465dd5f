//! Symbolic work: what turns primitive relations into first-order systems.

mod isolate;
mod jet;
mod linearise;

pub use isolate::{Linear, Quadratic, linear_in, quadratic_in, solve_linear};
pub use jet::{on_path, total_derivative};
pub use linearise::linearise;

use symbolica::atom::{Atom, AtomCore};
use symbolica::parse;

/// `expression` with every symbol `from` replaced by `to`, all at once.
pub fn substitute(expression: &Atom, replacements: &[(&str, Atom)]) -> Atom {
    // In two rounds, so that a symbol that stands in a replacement is not replaced in turn.
    let mark = |index: usize| parse!(&format!("mark_{index}"));
    let marked = replacements
        .iter()
        .enumerate()
        .fold(expression.clone(), |all, (index, (from, _))| all.replace(parse!(*from)).with(mark(index)));
    replacements.iter().enumerate().fold(marked, |all, (index, (_, to))| all.replace(mark(index)).with(to.clone()))
}
