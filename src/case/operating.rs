//! The operating point: a speed, a load and a clamp, each given in one of several ways.

use super::error::CaseError;
use super::given::Case;
use super::keys::Key;
use crate::model::Free;

/// Keys that give the clamp.
pub(super) const CLAMPS: &[Key] = &[
    Key::SlackTension,
    Key::TightTension,
    Key::PrimaryAxialForce,
    Key::SecondaryAxialForce,
    Key::SlipReserve,
    Key::FrictionUtilization,
];
/// Keys that give the load, besides a second speed.
const LOADS: &[Key] = &[Key::PrimaryTorque, Key::SecondaryTorque, Key::SpeedRatio];

/// The speed that is given, rad/s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Speed {
    /// ω_P.
    Primary(f64),
    /// ω_S.
    Secondary(f64),
}

/// The load that is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Load {
    /// M_in, torque into the primary, N·m.
    PrimaryTorque(f64),
    /// Torque out of the secondary, N·m.
    SecondaryTorque(f64),
    /// ω_S in rad/s, beside [`Speed::Primary`].
    SecondarySpeed(f64),
    /// ω_S/ω_P.
    SpeedRatio(f64),
}

/// The clamp that is given, N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Clamp {
    /// Tractive tension at the exit of the primary.
    SlackTension(f64),
    /// Tractive tension at the entry of the primary.
    TightTension(f64),
    /// Axial force on the primary.
    PrimaryAxialForce(f64),
    /// Axial force on the secondary.
    SecondaryAxialForce(f64),
}

/// What else is given when both radii are solved for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fourth {
    /// A second load.
    Load(Load),
    /// A second clamp.
    Clamp(Clamp),
}

/// What the drive is asked to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// The speed.
    pub speed: Speed,
    /// The load.
    pub load: Load,
    /// The clamp.
    pub clamp: Clamp,
    /// What closes the drive when both radii are free, and only then.
    pub fourth: Option<Fourth>,
    /// What the clamp is found for; `clamp` is then where the search starts.
    pub margin: Option<Margin>,
}

/// A margin against slip for which the clamp is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Margin {
    /// Share of the friction at hand that is left over.
    SlipReserve(f64),
    /// Share of the friction at hand that is used.
    FrictionUtilization(f64),
}

impl Margin {
    /// Its key and its value.
    pub const fn setting(self) -> (Key, f64) {
        match self {
            Self::SlipReserve(value) => (Key::SlipReserve, value),
            Self::FrictionUtilization(value) => (Key::FrictionUtilization, value),
        }
    }

    /// Share of the friction at hand that is used.
    pub const fn utilization(self) -> f64 {
        match self {
            Self::SlipReserve(reserve) => 1.0 - reserve,
            Self::FrictionUtilization(utilization) => utilization,
        }
    }

    fn of(case: &Case, key: Key) -> Option<Self> {
        match key {
            Key::SlipReserve => Some(Self::SlipReserve(case.value(key))),
            Key::FrictionUtilization => Some(Self::FrictionUtilization(case.value(key))),
            _ => None,
        }
    }
}

impl Speed {
    /// Its key and its value in SI.
    pub const fn setting(self) -> (Key, f64) {
        match self {
            Self::Primary(value) => (Key::PrimarySpeed, value),
            Self::Secondary(value) => (Key::SecondarySpeed, value),
        }
    }
}

impl Load {
    /// Its key and its value in SI.
    pub const fn setting(self) -> (Key, f64) {
        match self {
            Self::PrimaryTorque(value) => (Key::PrimaryTorque, value),
            Self::SecondaryTorque(value) => (Key::SecondaryTorque, value),
            Self::SecondarySpeed(value) => (Key::SecondarySpeed, value),
            Self::SpeedRatio(value) => (Key::SpeedRatio, value),
        }
    }

    fn of(case: &Case, key: Key) -> Self {
        let value = case.value(key);
        match key {
            Key::SecondaryTorque => Self::SecondaryTorque(value),
            Key::SecondarySpeed => Self::SecondarySpeed(value),
            Key::SpeedRatio => Self::SpeedRatio(value),
            _ => Self::PrimaryTorque(value),
        }
    }
}

impl Clamp {
    /// Its key and its value in SI.
    pub const fn setting(self) -> (Key, f64) {
        match self {
            Self::SlackTension(value) => (Key::SlackTension, value),
            Self::TightTension(value) => (Key::TightTension, value),
            Self::PrimaryAxialForce(value) => (Key::PrimaryAxialForce, value),
            Self::SecondaryAxialForce(value) => (Key::SecondaryAxialForce, value),
        }
    }

    fn of(case: &Case, key: Key) -> Self {
        let value = case.value(key);
        match key {
            Key::TightTension => Self::TightTension(value),
            Key::PrimaryAxialForce => Self::PrimaryAxialForce(value),
            Key::SecondaryAxialForce => Self::SecondaryAxialForce(value),
            _ => Self::SlackTension(value),
        }
    }
}

impl Fourth {
    /// Its key and its value in SI.
    pub const fn setting(self) -> (Key, f64) {
        match self {
            Self::Load(load) => load.setting(),
            Self::Clamp(clamp) => clamp.setting(),
        }
    }
}

impl OperatingPoint {
    /// Fills the three slots, and the fourth if both radii are free. A key that is given takes the place of the base
    /// case's in its slot.
    pub(super) fn resolve(case: &Case, free: Option<Free>) -> Result<Self, CaseError> {
        let given = |keys: &[Key]| keys.iter().copied().filter(|key| case.has(*key)).collect::<Vec<_>>();
        let speeds = given(&[Key::PrimarySpeed, Key::SecondarySpeed]);
        let mut loads = given(LOADS);
        let clamps = given(CLAMPS);
        let margin = clamps.iter().find_map(|clamp| Margin::of(case, *clamp));
        if let (Some(margin), Some(Free::Both)) = (margin, free) {
            let reason = "with both radii free, four other keys of [operating_point] have to close the drive";
            return Err(case.conflict(margin.setting().0, Key::Free, reason));
        }
        if speeds.len() == 2 {
            if case.has(Key::SpeedRatio) {
                return Err(case.conflict(Key::SecondarySpeed, Key::SpeedRatio, "the two speeds have one ratio"));
            }
            loads.push(Key::SecondarySpeed);
        }
        let speed = match speeds.as_slice() {
            [Key::SecondarySpeed] => Speed::Secondary(case.value(Key::SecondarySpeed)),
            _ => Speed::Primary(case.value(Key::PrimarySpeed)),
        };
        let fourth = fourth(case, &loads, &clamps, free)?;
        Ok(Self {
            speed,
            load: Load::of(case, loads.first().copied().unwrap_or(Key::PrimaryTorque)),
            clamp: Clamp::of(case, clamps.first().copied().unwrap_or(Key::SlackTension)),
            fourth,
            margin,
        })
    }

    /// Keys and values in SI.
    pub fn settings(&self) -> impl Iterator<Item = (Key, f64)> {
        let clamp = self.margin.map_or_else(|| self.clamp.setting(), Margin::setting);
        let slots = [self.speed.setting(), self.load.setting(), clamp];
        slots.into_iter().chain(self.fourth.map(Fourth::setting))
    }
}

/// The one key too many that closes a drive with two free radii; an error for any other one too many.
fn fourth(case: &Case, loads: &[Key], clamps: &[Key], free: Option<Free>) -> Result<Option<Fourth>, CaseError> {
    match (free, loads, clamps) {
        (Some(Free::Both), [_, load], [] | [_]) => Ok(Some(Fourth::Load(Load::of(case, *load)))),
        (Some(Free::Both), [] | [_], [_, clamp]) => Ok(Some(Fourth::Clamp(Clamp::of(case, *clamp)))),
        (Some(Free::Both), [] | [_], [] | [_]) => Err(case.missing(
            Key::Free,
            "with both radii free, a fourth key of [operating_point] has to close the drive, say both axial forces",
        )),
        (Some(Free::Both), [_, second, third, ..], _) | (Some(Free::Both), _, [_, second, third, ..]) => {
            Err(case.conflict(*second, *third, "four keys of [operating_point] close a drive with both radii free"))
        }
        (Some(Free::Both), [_, load, ..], [_, clamp, ..]) => {
            Err(case.conflict(*load, *clamp, "four keys of [operating_point] close a drive with both radii free"))
        }
        (_, [first, second, ..], _) => Err(case.conflict(*first, *second, "the load is given by one key")),
        (_, _, [first, second, ..]) => Err(case.conflict(*first, *second, "the clamp is given by one key")),
        _ => Ok(None),
    }
}

impl Case {
    /// Takes out what the keys in `given` stand in place of: the ratio in place of both radii, a clamp or a load in
    /// place of another. Keys in `given` stay.
    pub fn make_room(&mut self, given: &[Key]) {
        let radii = [Key::PrimaryRadius, Key::SecondaryRadius];
        let mut out: Vec<Key> = Vec::new();
        if given.contains(&Key::Ratio) {
            out.extend(radii);
        } else if radii.iter().any(|key| given.contains(key)) {
            out.push(Key::Ratio);
        }
        // With both radii free, two keys of one slot may stand side by side.
        if !self.has(Key::Free) {
            for slot in [LOADS, CLAMPS] {
                if slot.iter().any(|key| given.contains(key)) {
                    out.extend(slot);
                }
            }
        }
        out.into_iter().filter(|key| !given.contains(key)).for_each(|key| self.remove(key));
    }
}
