//! What can go wrong between an equation and its source text.

use thiserror::Error;

/// Generation stops at the first of these.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// An expression that cannot be read.
    #[error("step {step}: cannot read `{text}`: {message}")]
    Parse {
        /// Step that holds it.
        step: String,
        /// The text.
        text: String,
        /// What the parser says.
        message: String,
    },
    /// A symbol that the notation does not list, or that is used before it is defined.
    #[error("step {step}: `{symbol}` is not in the notation or not defined before this step")]
    UnknownSymbol {
        /// Step that uses it.
        step: String,
        /// The symbol.
        symbol: String,
    },
    /// A step that is defined twice.
    #[error("step {step} is defined twice")]
    Redefined {
        /// Step.
        step: String,
    },
    /// A term of the wrong dimension.
    #[error("step {step}: the term `{term}` has dimension {found} where {expected} is needed")]
    Dimension {
        /// Step that holds it.
        step: String,
        /// The offending term.
        term: String,
        /// Its dimension.
        found: String,
        /// The dimension of the terms beside it, or of the step.
        expected: String,
    },
    /// A symbol that callers of the kernels name, without a variant in the generated enums.
    #[error("`{symbol}` has no variant: its row of the notation needs `.identity(…)`")]
    Variant {
        /// The symbol.
        symbol: String,
    },
    /// A divisor, or the argument of a square root, that nobody declared to stay away from zero.
    #[error("step {step}: divides by (or takes the root of) `{divisor}`, which is not declared nonzero")]
    UndeclaredDivisor {
        /// Step that divides.
        step: String,
        /// The divisor.
        divisor: String,
    },
    /// An equation that should be linear in an unknown is not.
    #[error("not linear in {unknown}: {equation}")]
    NotLinear {
        /// The unknown.
        unknown: String,
        /// The equation.
        equation: String,
    },
    /// An equation that should be of second degree in an unknown is not.
    #[error("not quadratic in {unknown}: {equation}")]
    NotQuadratic {
        /// The unknown.
        unknown: String,
        /// The equation.
        equation: String,
    },
    /// A jet of higher order than the notation has symbols for.
    #[error("the total derivative of `{expression}` needs a derivative of {highest}")]
    JetOrder {
        /// What was to be differentiated.
        expression: String,
        /// Highest derivative that has a symbol.
        highest: String,
    },
    /// A construct that no emitted operation stands for.
    #[error("step {step}: no operation for `{expression}`")]
    Unsupported {
        /// Step that holds it.
        step: String,
        /// The construct.
        expression: String,
    },
    /// The emitted tokens are not Rust.
    #[error("the emitted tokens of {file} do not parse: {message}")]
    Tokens {
        /// File being emitted.
        file: String,
        /// What `syn` says.
        message: String,
    },
    /// The symbolic engine could not be started or has gone.
    #[error("the symbolic engine: {0}")]
    Engine(String),
}
