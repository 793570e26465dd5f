//! Whether belt, radii and centre distance that are given go together, and what is only partly given.

use super::choice::Free;
use super::error::{CaseError, Problem};
use super::file::Case;
use super::geometry::pitch_length;
use super::keys::Key;

/// Share of the pitch length by which `belt.length` may differ from that of both radii before the case is refused. Less is
/// reported with the result: a belt that bends is not as long as arcs and tangents, and the radii of a drive are seldom known
/// better.
pub const PITCH_TOLERANCE: f64 = 0.1;

impl Case {
    /// Refuses a belt that cannot lie in a drive of which everything is given.
    pub(super) fn check_pitch(&self, primary: f64, secondary: f64, center_distance: f64) -> Result<(), CaseError> {
        let all = [Key::BeltLength, Key::PrimaryRadius, Key::SecondaryRadius];
        if !all.into_iter().all(|key| self.has(key)) {
            return Ok(());
        }
        let (length, pitch) = (self.value(Key::BeltLength), pitch_length(primary, secondary, center_distance));
        if (length - pitch).abs() <= PITCH_TOLERANCE * pitch {
            return Ok(());
        }
        let places = self.places(all.into_iter().chain([Key::CenterDistance]));
        let given = self.written(Key::BeltLength);
        Err(CaseError::new(Problem::Contradiction { given, pitch, center_distance }, places))
    }

    /// What a case leaves to the base case although it gives what goes with it: worth knowing before a result is used.
    pub fn remarks(&self) -> Vec<String> {
        let free = self.choice(Key::Free).and_then(Free::from_name);
        let one = |given: Key, other: Key, free_other: Free| {
            let alone = self.has(given) && !self.has(other) && !self.has(Key::Ratio) && free != Some(free_other);
            alone.then(|| {
                format!(
                    "Only `{}` is given: `{}` stays at the base case's {}. With `drive.free` = \"{}\" it follows from the \
                     belt's length, with `drive.ratio` both radii do.",
                    given.path(),
                    other.path(),
                    other.entry().example(),
                    other.entry().name()
                )
            })
        };
        let radii = [
            one(Key::PrimaryRadius, Key::SecondaryRadius, Free::SecondaryRadius),
            one(Key::SecondaryRadius, Key::PrimaryRadius, Free::PrimaryRadius),
        ];
        radii.into_iter().flatten().collect()
    }
}
