//! What keeps a drive from being sound, however much friction it has in reserve.

use std::f64::consts::PI;

use serde::Serialize;

use super::schema::{DriveResult, Energy, Pulley};
use crate::drive::{COMPRESSION, PowerFlow};

/// Share of a contact in adhesion, on both pulleys, below which the belt counts as adhering nowhere.
const LITTLE_ADHESION: f64 = 0.02;
/// Sum of both wrap angles, rad, beyond which a belt has buckled: round both pulleys and back it turns by 2 π, and a
/// quarter of a turn more has to be turned back by the spans.
const BUCKLED: f64 = 2.5 * PI;

/// What keeps a drive from being sound; the worst first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Doubt {
    /// The belt is wound round its pulleys as none is whose spans are nearly straight.
    Buckled,
    /// A span is pushed, but for what the belt's inertia adds.
    Pushed,
    /// Power has to be put in on both sides.
    Driven,
    /// The belt slides everywhere, on both pulleys.
    Sliding,
}

impl Doubt {
    /// All, the worst first.
    pub const ALL: [Self; 4] = [Self::Buckled, Self::Pushed, Self::Driven, Self::Sliding];

    /// The worst about a drive, if there is any.
    pub fn about<I>(result: &DriveResult<I>) -> Option<Self> {
        let (primary, secondary) = (&result.primary, &result.secondary);
        let spans = [&result.tight_span, &result.slack_span];
        let tensions = [spans.map(|span| span.min_tension), spans.map(|span| span.max_tension)];
        let [least, largest] = [f64::min, f64::max]
            .map(|extreme: fn(f64, f64) -> f64| tensions.iter().flatten().copied().fold(0.0, extreme));
        let doubts = [
            (is_buckled(primary.wrap_angle, secondary.wrap_angle), Self::Buckled),
            (least < -COMPRESSION * largest, Self::Pushed),
            (is_driven_on_both_sides(&result.energy), Self::Driven),
            (adheres_nowhere(primary, secondary), Self::Sliding),
        ];
        doubts.into_iter().find_map(|(holds, doubt)| holds.then_some(doubt))
    }

    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Buckled => "buckled",
            Self::Pushed => "pushed",
            Self::Driven => "driven",
            Self::Sliding => "sliding",
        }
    }

    /// As the end of a sentence that begins with what is well.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Buckled => "the belt buckles",
            Self::Pushed => "a strand of the belt is pushed",
            Self::Driven => "both pulleys have to be driven",
            Self::Sliding => "the belt adheres on neither pulley",
        }
    }
}

/// Whether a belt is wound round its pulleys by so much that its spans turn back, by its wrap angles in rad. Its
/// equations hold; beyond the limit of a drive, and pressed through a groove, such a belt is all that is left.
pub(crate) fn is_buckled(primary_wrap: f64, secondary_wrap: f64) -> bool {
    primary_wrap + secondary_wrap > BUCKLED
}

/// Whether power is put in on both sides.
pub(super) fn is_driven_on_both_sides(energy: &Energy) -> bool {
    PowerFlow::of(energy.power_in, energy.power_out) == PowerFlow::IntoBoth
}

/// Whether hardly any of the belt adheres.
pub(super) fn adheres_nowhere(primary: &Pulley, secondary: &Pulley) -> bool {
    primary.adhesion_fraction < LITTLE_ADHESION && secondary.adhesion_fraction < LITTLE_ADHESION
}
