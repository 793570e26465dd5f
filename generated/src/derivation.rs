//! How the kernels came about: the derivation of each edition, written together with them.

/// How a derivation is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum DerivationFormat {
    /// Plain text with Unicode formulas.
    Text,
    /// A LaTeX document.
    Latex,
    /// Markdown with LaTeX formulas.
    Markdown,
}

macro_rules! text {
    ($name:expr) => {{
        #[cfg(feature = "regenerate")]
        const TEXT: &str = include_str!(concat!(env!("OUT_DIR"), "/", $name));
        #[cfg(not(feature = "regenerate"))]
        const TEXT: &str = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/", $name));
        TEXT
    }};
}

macro_rules! editions {
    ($($name:literal),*) => {
        /// The derivation of the edition of that name, step by step with the thesis's equation numbers.
        pub fn derivation(edition: &str, format: DerivationFormat) -> Option<&'static str> {
            match (edition, format) {
                $(
                    ($name, DerivationFormat::Text) => Some(text!(concat!("derivation_", $name, ".txt"))),
                    ($name, DerivationFormat::Latex) => Some(text!(concat!("derivation_", $name, ".tex"))),
                    ($name, DerivationFormat::Markdown) => Some(text!(concat!("derivation_", $name, ".md"))),
                )*
                _ => None,
            }
        }
    };
}

editions!("published", "thesis", "consistent", "string");
