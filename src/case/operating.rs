//! The operating point: a speed, a load and a clamp, each given in one of several ways.

use super::error::CaseError;
use super::file::Case;
use super::keys::Key;
use crate::model::Free;

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
        let mut loads = given(&[Key::PrimaryTorque, Key::SecondaryTorque, Key::SpeedRatio]);
        let clamps = given(&[Key::SlackTension, Key::TightTension, Key::PrimaryAxialForce, Key::SecondaryAxialForce]);
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
        })
    }

    /// Keys and values in SI.
    pub fn settings(&self) -> impl Iterator<Item = (Key, f64)> {
        let slots = [self.speed.setting(), self.load.setting(), self.clamp.setting()];
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
