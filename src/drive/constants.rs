//! The constants of the belt problem, in the order in which every kernel of the boundary set knows them.

use crate::case::Key;

/// A constant of the drive: the first eight are unknown by default, the others given (model: unknowns and givens).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[repr(usize)]
pub enum Constant {
    /// σ = ω_S/ω_P, speed of the secondary over that of the primary.
    SpeedRatio,
    /// g = G/(m_o R_P ω_P), mass flow over that of an unstretched belt at the primary's nominal radius.
    Flow,
    /// Φ_P, wrap angle of the primary, rad.
    PrimaryWrap,
    /// Φ_S, wrap angle of the secondary, rad.
    SecondaryWrap,
    /// C_P, orientation angle of the primary, rad.
    PrimaryOrientation,
    /// C_S, orientation angle of the secondary, rad.
    SecondaryOrientation,
    /// L_t, arc length of the tight span, m.
    TightLength,
    /// L_s, arc length of the slack span, m.
    SlackLength,
    /// EA, longitudinal stiffness, N.
    LongitudinalStiffness,
    /// EI, bending stiffness, N·m².
    BendingStiffness,
    /// k, radial stiffness, N/m².
    RadialStiffness,
    /// m_o, unstretched mass per length, kg/m.
    MassPerLength,
    /// R_P, nominal radius of the primary, m.
    PrimaryRadius,
    /// R_S, nominal radius of the secondary, m.
    SecondaryRadius,
    /// L_c, centre distance, m.
    CenterDistance,
    /// β, half the wedge angle, rad.
    HalfAngle,
    /// μ_k, friction coefficient.
    FrictionCoefficient,
    /// v_thr, slip threshold, m/s.
    SlipThreshold,
    /// ω_P, speed of the primary, rad/s.
    PrimarySpeed,
    /// M_in, torque into the primary, N·m.
    PrimaryTorque,
    /// T_slack, tractive tension at the primary's exit, N.
    SlackTension,
}

impl Constant {
    /// All constants, in order.
    pub const ALL: [Self; 21] = [
        Self::SpeedRatio,
        Self::Flow,
        Self::PrimaryWrap,
        Self::SecondaryWrap,
        Self::PrimaryOrientation,
        Self::SecondaryOrientation,
        Self::TightLength,
        Self::SlackLength,
        Self::LongitudinalStiffness,
        Self::BendingStiffness,
        Self::RadialStiffness,
        Self::MassPerLength,
        Self::PrimaryRadius,
        Self::SecondaryRadius,
        Self::CenterDistance,
        Self::HalfAngle,
        Self::FrictionCoefficient,
        Self::SlipThreshold,
        Self::PrimarySpeed,
        Self::PrimaryTorque,
        Self::SlackTension,
    ];

    /// How many of [`ALL`](Self::ALL), from the front, are unknown by default.
    pub const UNKNOWN: usize = 8;

    /// Place in the vector of constants.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Name in the generated notation table.
    pub const fn name(self) -> &'static str {
        match self {
            Self::SpeedRatio => "speed_ratio",
            Self::Flow => "flow",
            Self::PrimaryWrap => "Phi_P",
            Self::SecondaryWrap => "Phi_S",
            Self::PrimaryOrientation => "C_P",
            Self::SecondaryOrientation => "C_S",
            Self::TightLength => "L_t",
            Self::SlackLength => "L_s",
            Self::LongitudinalStiffness => "EA",
            Self::BendingStiffness => "EI",
            Self::RadialStiffness => "k",
            Self::MassPerLength => "m_o",
            Self::PrimaryRadius => "R_P",
            Self::SecondaryRadius => "R_S",
            Self::CenterDistance => "L_c",
            Self::HalfAngle => "beta",
            Self::FrictionCoefficient => "mu_k",
            Self::SlipThreshold => "v_thr",
            Self::PrimarySpeed => "omega_P",
            Self::PrimaryTorque => "M_in",
            Self::SlackTension => "T_slack",
        }
    }

    /// The key of the case file that gives it; `None` for those that are found by default and have no key.
    pub const fn key(self) -> Option<Key> {
        match self {
            Self::SpeedRatio => Some(Key::SpeedRatio),
            Self::LongitudinalStiffness => Some(Key::LongitudinalStiffness),
            Self::BendingStiffness => Some(Key::BendingStiffness),
            Self::RadialStiffness => Some(Key::RadialStiffness),
            Self::MassPerLength => Some(Key::MassPerLength),
            Self::PrimaryRadius => Some(Key::PrimaryRadius),
            Self::SecondaryRadius => Some(Key::SecondaryRadius),
            Self::CenterDistance => Some(Key::CenterDistance),
            Self::HalfAngle => Some(Key::HalfAngle),
            Self::FrictionCoefficient => Some(Key::FrictionCoefficient),
            Self::SlipThreshold => Some(Key::SlipThreshold),
            Self::PrimarySpeed => Some(Key::PrimarySpeed),
            Self::PrimaryTorque => Some(Key::PrimaryTorque),
            Self::SlackTension => Some(Key::SlackTension),
            Self::Flow
            | Self::PrimaryWrap
            | Self::SecondaryWrap
            | Self::PrimaryOrientation
            | Self::SecondaryOrientation
            | Self::TightLength
            | Self::SlackLength => None,
        }
    }

    /// How messages name it: by its key, or by its symbol.
    pub fn label(self) -> String {
        self.key().map_or(self.name(), Key::path).to_owned()
    }
}

/// Values of all constants, SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Constants(pub [f64; Constant::ALL.len()]);

impl std::ops::Index<Constant> for Constants {
    type Output = f64;
    fn index(&self, constant: Constant) -> &f64 {
        &self.0[constant.index()]
    }
}

impl std::ops::IndexMut<Constant> for Constants {
    fn index_mut(&mut self, constant: Constant) -> &mut f64 {
        &mut self.0[constant.index()]
    }
}
