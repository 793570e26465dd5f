//! What a map is over: keys of the case, each with its breakpoints.

use super::error::MapError;
use crate::case::geometry::radii_of_ratio;
use crate::case::{Key, Resolved, Setting};
use crate::drive::Solved;
use crate::model::{Constant, Output};
use crate::study::Axis;
use std::borrow::Cow;
use std::f64::consts::PI;

/// Breakpoints of a range whose number is not given.
pub const FIRST_BREAKPOINTS: usize = 3;
/// Axes at most: a cell has 2ⁿ corners with 2ⁿ derivatives each.
pub const MAX_AXES: usize = 6;

/// Short names of keys that maps are usually over.
const SHORT: [(&str, Key); 4] = [
    ("ratio", Key::Ratio),
    ("torque", Key::PrimaryTorque),
    ("speed", Key::PrimarySpeed),
    ("clamp", Key::SecondaryAxialForce),
];

/// One direction of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapAxis {
    key: Key,
    breakpoints: Vec<f64>,
}

/// How a key enters the boundary value problem.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Entry {
    /// Through both nominal radii (6.12).
    Ratio,
    /// As a given constant.
    Constant(Constant),
    /// As the value of a prescribed output.
    Output(Output),
}

impl MapAxis {
    /// Reads `KEY=FROM..TO[:N]` or `KEY=A,B,C` as [`Axis::parse`] does. The key may be shortened to its last part
    /// (`slack_tension`), and `ratio`, `torque`, `speed` and `clamp` stand for the nominal ratio, the primary's torque
    /// and speed, and the axial force on the secondary. N is [`FIRST_BREAKPOINTS`] when it is not given: the map sets
    /// more breakpoints where it needs them.
    ///
    /// # Errors
    /// [`MapError::Study`], [`MapError::NotAnAxis`], [`MapError::TooShort`].
    pub fn parse(text: &str) -> Result<Self, MapError> {
        let (name, values) = text.split_once('=').unwrap_or((text, ""));
        let count = if values.contains("..") && !values.contains(':') {
            format!(":{FIRST_BREAKPOINTS}")
        } else {
            String::new()
        };
        let path: &str = match Self::key_named(name.trim()) {
            Some(key) => key.path(),
            None => name.trim(),
        };
        let axis = Axis::parse(&format!("{path}={values}{count}"))?;
        let [key] = axis.keys() else { return Err(MapError::Together { text: text.into() }) };
        let value = |setting: Setting| if let Setting::Number(value) = setting { Some(value) } else { None };
        let number = |point: usize| axis.at(point).find_map(|(_, setting)| value(setting));
        Self::new(*key, (0..axis.points()).filter_map(number))
    }

    /// The key that a map knows by a name: its path, its last part where that says which, or one of the usual short
    /// names (see [`MapAxis::parse`]).
    pub fn key_named(name: &str) -> Option<Key> {
        let short = SHORT.iter().find(|(short, _)| *short == name).map(|(_, key)| *key);
        let mut alike = crate::case::TABLE.iter().filter(|entry| entry.name() == name);
        let only = alike.next().filter(|_| alike.next().is_none()).map(|entry| entry.key);
        Key::from_path(name).or(short).or(only)
    }

    /// The axis of a key with breakpoints in SI, in any order.
    ///
    /// # Errors
    /// [`MapError::NotAnAxis`], [`MapError::TooShort`].
    pub fn new(key: Key, breakpoints: impl IntoIterator<Item = f64>) -> Result<Self, MapError> {
        if entry(key).is_none() {
            return Err(MapError::NotAnAxis { key });
        }
        let mut breakpoints: Vec<f64> = breakpoints.into_iter().collect();
        breakpoints.sort_by(f64::total_cmp);
        breakpoints.dedup();
        let (Some(first), Some(last)) = (breakpoints.first().copied(), breakpoints.last().copied()) else {
            return Err(MapError::TooShort { key });
        };
        if first == last || breakpoints.iter().any(|value| !value.is_finite()) {
            return Err(MapError::TooShort { key });
        }
        // What the error is estimated from takes three.
        if breakpoints.len() == 2 {
            breakpoints.insert(1, 0.5 * (first + last));
        }
        Ok(Self { key, breakpoints })
    }

    /// The key.
    pub fn key(&self) -> Key {
        self.key
    }

    /// SI unit of the breakpoints, as files state it; `1` for a pure number.
    pub fn unit(&self) -> Cow<'static, str> {
        self.key.entry().si_unit()
    }

    /// Where the map has nodes, SI, increasing; three at the least.
    pub fn breakpoints(&self) -> &[f64] {
        &self.breakpoints
    }

    /// First and last breakpoint, SI.
    pub fn range(&self) -> (f64, f64) {
        let first = self.breakpoints.first().copied().unwrap_or(f64::NAN);
        (first, self.breakpoints.last().copied().unwrap_or(f64::NAN))
    }

    /// Number of breakpoints.
    pub fn len(&self) -> usize {
        self.breakpoints.len()
    }

    /// Never: an axis has three breakpoints at the least.
    pub fn is_empty(&self) -> bool {
        self.breakpoints.is_empty()
    }

    /// Halves the interval behind a breakpoint.
    pub(super) fn halve(&mut self, interval: usize) {
        if let (Some(a), Some(b)) = (self.breakpoints.get(interval), self.breakpoints.get(interval + 1)) {
            let middle = 0.5 * (a + b);
            self.breakpoints.insert(interval + 1, middle);
        }
    }

    /// The interval in which a value lies.
    pub(super) fn interval(&self, value: f64) -> Option<usize> {
        let (first, last) = self.range();
        let inside = first <= value && value <= last;
        inside.then(|| self.breakpoints.partition_point(|at| *at <= value).clamp(1, self.len() - 1) - 1)
    }
}

/// How a key enters the problem; none for those that a map cannot be over.
fn entry(key: Key) -> Option<Entry> {
    match key {
        Key::Ratio => Some(Entry::Ratio),
        // Nominal radii follow from both, too.
        Key::BeltLength | Key::CenterDistance => None,
        key => {
            let constant = Constant::ALL.into_iter().find(|constant| Key::of_constant(*constant) == Some(key));
            constant.map(Entry::Constant).or_else(|| key.output().map(Entry::Output))
        }
    }
}

/// Rates of the problem's constants where the value of a key moves, in the order of the problem's layout; those of
/// unknown constants do not matter.
pub(super) fn direction(key: Key, case: &Resolved, solved: &Solved) -> Vec<f64> {
    let mut direction = vec![0.0; Constant::ALL.len() + solved.belt.prescribed().count()];
    let mut set = |at: Option<usize>, rate: f64| {
        if let Some(entry) = at.and_then(|at| direction.get_mut(at)) {
            *entry = rate;
        }
    };
    match entry(key) {
        None => {}
        Some(Entry::Constant(constant)) => set(Some(constant.index()), 1.0),
        Some(Entry::Output(output)) => {
            let at = solved.belt.prescribed().position(|other| other == output);
            set(at.map(|at| Constant::ALL.len() + at), 1.0);
        }
        Some(Entry::Ratio) => {
            let (primary, secondary) = radius_rates(case);
            set(Some(Constant::PrimaryRadius.index()), primary);
            set(Some(Constant::SecondaryRadius.index()), secondary);
        }
    }
    direction
}

/// dR_P/dρ and dR_S/dρ of the nominal radii with R_S = ρ R_P at a constant pitch length (6.12), m.
fn radius_rates(case: &Resolved) -> (f64, f64) {
    let ratio = case.drive.secondary_radius / case.drive.primary_radius;
    let found = radii_of_ratio(ratio, case.belt.length, case.drive.center_distance);
    let (primary, secondary) = found.unwrap_or((case.drive.primary_radius, case.drive.secondary_radius));
    let tangent = libm::asin((secondary - primary) / case.drive.center_distance);
    // The pitch length grows by 2 θ_T where R_S − R_P does, and by π where R_P + R_S does.
    let by_ratio = primary * (PI + 2.0 * tangent);
    let by_primary = PI * (1.0 + ratio) + 2.0 * tangent * (ratio - 1.0);
    let rate = -by_ratio / by_primary;
    (rate, primary + ratio * rate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    #[test]
    fn short_names_and_ranges_are_read() {
        let read = |text: &str| MapAxis::parse(text).map(|axis| (axis.key, axis.breakpoints));
        assert_eq!(read("ratio=0.7..3.1:4").unwrap(), (Key::Ratio, vec![0.7, 1.5, 2.3, 3.1]));
        assert_eq!(read("torque=0..30 N*m").unwrap(), (Key::PrimaryTorque, vec![0.0, 15.0, 30.0]));
        assert_eq!(read("clamp=2,1 kN").unwrap(), (Key::SecondaryAxialForce, vec![1000.0, 1500.0, 2000.0]));
        assert_eq!(read("slack_tension=300,100,200 N").unwrap().0, Key::SlackTension);
        assert_eq!(read("operating_point.tight_tension=300..100 N").unwrap().1, [100.0, 200.0, 300.0]);
        for (text, said) in [
            ("ratio=1", "a range"),
            ("ration=1..2", "drive.ratio"),
            ("edition=thesis,published", "no axis of a map"),
            ("slip_reserve=10..20 %", "no axis of a map"),
            ("belt.length=800..900 mm", "no axis of a map"),
            ("ratio", "KEY=FROM..TO"),
        ] {
            let message = read(text).unwrap_err().to_string();
            assert!(message.contains(said), "{text}: {message}");
        }
    }

    #[test]
    fn radii_move_with_the_ratio_as_differences_say() {
        for ratio in [0.6, 1.0, 2.4] {
            let radii = |ratio: f64| radii_of_ratio(ratio, 0.8572, 0.214).unwrap();
            let case = Case::base().with_si(Key::Ratio, ratio).unwrap().resolve().unwrap();
            let h = 1e-6;
            let ((a, b), (c, d)) = (radii(ratio - h), radii(ratio + h));
            let (primary, secondary) = radius_rates(&case);
            assert!((primary - (c - a) / (2.0 * h)).abs() < 1e-8 && (secondary - (d - b) / (2.0 * h)).abs() < 1e-8);
        }
    }
}
