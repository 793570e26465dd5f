//! Solutions as they are written, and numbers that are not finite, as JSON and other formats without them can carry
//! them: as nothing.

use crate::rows::Rows;
use crate::solution::RegionSolution;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A [`RegionSolution`], row by row.
#[derive(Serialize, Deserialize)]
pub(crate) struct Region {
    mesh: Vec<f64>,
    y: Vec<Vec<f64>>,
    f: Vec<Vec<f64>>,
    alpha: Vec<Vec<f64>>,
    beta: Vec<Vec<f64>>,
    #[serde(default)]
    gamma: Vec<Vec<f64>>,
    #[serde(default)]
    delta: Vec<Vec<f64>>,
    integrals: Vec<f64>,
    cumulative: Vec<Vec<f64>>,
    #[serde(default, with = "defects")]
    defects: Vec<f64>,
}

impl From<RegionSolution> for Region {
    fn from(region: RegionSolution) -> Self {
        let [alpha, beta, gamma, delta] = region.extension.each_ref().map(Rows::to_vecs);
        let (y, f, cumulative) = (region.y.to_vecs(), region.f.to_vecs(), region.cumulative.to_vecs());
        let RegionSolution { mesh, integrals, defects, .. } = region;
        Self { mesh, y, f, alpha, beta, gamma, delta, integrals, cumulative, defects }
    }
}

impl TryFrom<Region> for RegionSolution {
    type Error = String;

    /// # Errors
    /// Which rows do not fit the mesh or the number of states or integrals.
    fn try_from(region: Region) -> Result<Self, String> {
        let Region { mesh, y, f, alpha, beta, gamma, delta, integrals, cumulative, defects } = region;
        if mesh.len() < 2 {
            return Err(format!("a mesh of {} nodes; at least 2 are expected", mesh.len()));
        }
        let (states, nodes, intervals) = (y.len(), mesh.len(), mesh.len() - 1);
        let rows = |what: &str, rows: Vec<Vec<f64>>, count: usize, width: usize| {
            let found = || rows.iter().map(Vec::len).find(|len| *len != width);
            match (rows.len() == count).then(found) {
                None => Err(format!("{} rows of {what}; {count} are expected", rows.len())),
                Some(Some(len)) => Err(format!("a row of {len} values of {what}; {width} are expected")),
                Some(None) => Ok(Rows::new(rows.concat(), width)),
            }
        };
        if !defects.is_empty() && defects.len() != intervals {
            return Err(format!("{} defects; one for each of {intervals} intervals is expected", defects.len()));
        }
        // γ and δ come together, at order 8.
        let higher = if gamma.is_empty() && delta.is_empty() { 0 } else { states };
        Ok(Self {
            y: rows("y", y, states, nodes)?,
            f: rows("f", f, states, nodes)?,
            extension: [
                rows("alpha", alpha, states, intervals)?,
                rows("beta", beta, states, intervals)?,
                rows("gamma", gamma, higher, intervals)?,
                rows("delta", delta, higher, intervals)?,
            ],
            cumulative: rows("cumulative", cumulative, integrals.len(), nodes)?,
            mesh,
            integrals,
            defects,
        })
    }
}

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
