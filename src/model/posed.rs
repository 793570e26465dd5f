//! Why a question has no answer whatever the numbers.

use thiserror::Error;

/// Why a question has no answer whatever the numbers.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum IllPosed {
    /// A constant is to be made unknown that is unknown already.
    #[error("`{constant}` is unknown already: expected a given constant in its place")]
    Unknown {
        /// The constant.
        constant: String,
    },
    /// A constant is prescribed that is given already, or twice.
    #[error("`{constant}` is given already: expected another output in its place")]
    Given {
        /// The constant.
        constant: String,
    },
    /// An output is prescribed that the equations of this edition do not have.
    #[error("`{name}` is no output of this edition: expected one of its results")]
    NoOutput {
        /// The output.
        name: String,
    },
    /// Not all that is given and prescribed is independent.
    #[error("{} cannot all be given: each follows from the others, and {} would be left \
        undetermined", listed(.names), listed(.free))]
    Dependent {
        /// Keys, or outputs, that depend on each other.
        names: Vec<String>,
        /// The constants that were made unknown.
        free: Vec<String>,
    },
    /// What is prescribed is the same whatever the constants are that were made unknown for it.
    #[error("`{name}` does not depend on {}: expected a constant in its place that changes it", listed(.free))]
    NoInfluence {
        /// What is prescribed.
        name: String,
        /// The constants that were made unknown.
        free: Vec<String>,
    },
    /// A prescribed value is no number.
    #[error("`{name}` = {value}: expected a finite number")]
    Value {
        /// What is prescribed.
        name: String,
        /// As given.
        value: f64,
    },
}

/// Names in quotes, with commas.
fn listed(names: &[String]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
