//! Whether belt, radii and centre distance that are given go together, and what is only partly given.

use super::geometry::pitch_length;
use super::given::Case;
use super::keys::Key;
use crate::model::Free;

/// Share of the pitch length (6.12) by which `belt.length` may differ from that of both radii before it is said. A belt
/// that bends is not as long as arcs and tangents, and the radii of a drive are seldom known better.
pub const PITCH_TOLERANCE: f64 = 0.02;

impl Case {
    /// A belt that cannot lie around both radii that are given beside it.
    fn contradiction(&self) -> Option<String> {
        let all = [Key::BeltLength, Key::PrimaryRadius, Key::SecondaryRadius];
        if !all.into_iter().all(|key| self.has(key)) {
            return None;
        }
        let [length, primary, secondary] = all.map(|key| self.value(key));
        let pitch = pitch_length(primary, secondary, self.value(Key::CenterDistance));
        // Written so that no number, of pulleys that overlap, is none.
        ((length - pitch).abs() > PITCH_TOLERANCE * pitch).then(|| {
            format!(
                "`belt.length` = {:.1} mm contradicts the radii, around which a belt is {:.1} mm long (6.12). The \
                 radii hold, and the length is only compared with; to hold the length, give `drive.free` in place of \
                 one radius, or `drive.ratio` in place of both.",
                1e3 * length,
                1e3 * pitch
            )
        })
    }

    /// What a case leaves to the base case although it gives what goes with it, and what it gives twice and
    /// differently: worth knowing before a result is used.
    pub fn remarks(&self) -> Vec<String> {
        let free = self.choice(Key::Free).and_then(Free::from_name);
        let one = |given: Key, other: Key, free_other: Free| {
            let alone = self.has(given) && !self.has(other) && !self.has(Key::Ratio) && free != Some(free_other);
            alone.then(|| {
                format!(
                    "Only `{}` is given: `{}` stays at the base case's {}. With `drive.free` = \"{}\" it follows from \
                     the belt's length, with `drive.ratio` both radii do.",
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
        radii.into_iter().flatten().chain(self.contradiction()).collect()
    }
}
