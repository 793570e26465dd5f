//! Numbers that are not finite, as JSON and other formats without them can carry them: as nothing.

use serde::{Deserialize, Deserializer, Serialize, Serializer};

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// An estimate: what was not finite is read as NaN, an estimate that is not known.
pub(crate) mod estimate {
    use super::{Deserialize, Deserializer, Serialize, Serializer, finite};

    pub(crate) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        finite(*value).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::<f64>::deserialize(deserializer)?.unwrap_or(f64::NAN))
    }
}

/// Defects: what was not finite is read as infinite, the mark of a mesh on which Newton's iteration failed.
pub(crate) mod defects {
    use super::{Deserialize, Deserializer, Serializer, finite};

    pub(crate) fn serialize<S: Serializer>(values: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(values.iter().map(|&value| finite(value)))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<f64>, D::Error> {
        let values = Vec::<Option<f64>>::deserialize(deserializer)?;
        Ok(values.into_iter().map(|value| value.unwrap_or(f64::INFINITY)).collect())
    }
}
