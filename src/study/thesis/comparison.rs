//! The editions in one figure: what the printed slips did.

use super::Chapters;
use super::figures::{over_ratio, points};
use crate::model::Output;
use crate::plot::{Axis, Figure, Series};

/// Quantities over the operating range, one line an edition.
pub fn comparison(all: &[Chapters]) -> Vec<Figure> {
    let figure = |name: &str, caption: &str, axis: &str, output: Output, scale: f64| {
        let line = |chapters: &Chapters| {
            let rows = 0..chapters.range.rows.len();
            Series::line(chapters.edition.name(), points(&chapters.range, rows, output, scale)).marked()
        };
        over_ratio(&format!("editions_{name}"), caption, Axis::new(axis), all.iter().map(line).collect())
    };
    vec![
        figure(
            "overall_efficiency",
            "Overall efficiency over the operating range, by edition",
            "overall efficiency η (%)",
            Output::EfficiencyOverall,
            100.0,
        ),
        figure(
            "imbalance",
            "Share of the power that neither comes out nor is friction\u{2019}s, by edition",
            "power unaccounted for (%)",
            Output::EnergyImbalance,
            100.0,
        ),
        figure(
            "axial_force_primary",
            "Axial force of the primary over the operating range, by edition",
            "axial force A (N)",
            Output::PrimaryAxialForce,
            1.0,
        ),
        figure(
            "axial_force_secondary",
            "Axial force of the secondary over the operating range, by edition",
            "axial force A (N)",
            Output::SecondaryAxialForce,
            1.0,
        ),
    ]
}
