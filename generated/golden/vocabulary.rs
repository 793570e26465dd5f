// The enums by which callers of the kernels name quantities.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.

/// A state of a region: what its differential equations are of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum State {
    /// T: tractive tension F − G V, N; (3.6)
    Tension,
    /// θ: inclination of the belt against the pulley's circle; positive unseats, rad; (3.2)
    Inclination,
    /// θ̂': first derivative of θ along the region, rad; (5.2)
    InclinationDerivative,
    /// θ̂'': second derivative of θ along the region, rad; (5.3)
    InclinationSecondDerivative,
    /// x: radial penetration R − r, m; (3.24)
    Penetration,
    /// τ: tractive tension in a span, N; (3.45)
    SpanTension,
    /// ϑ: direction of the belt in a span against the line of centres, rad; (3.43)
    Direction,
    /// ϑ̂': first derivative of ϑ along the span, rad; (5.10)
    DirectionDerivative,
    /// ϑ̂'': second derivative of ϑ along the span, rad; (5.11)
    DirectionSecondDerivative,
}
impl State {
    /// All of them, in order.
    pub const ALL: [Self; 9] = [
        Self::Tension,
        Self::Inclination,
        Self::InclinationDerivative,
        Self::InclinationSecondDerivative,
        Self::Penetration,
        Self::SpanTension,
        Self::Direction,
        Self::DirectionDerivative,
        Self::DirectionSecondDerivative,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 9] = &[
        Symbol {
            name: "T",
            symbol: "T",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension F − G V",
            source: "(3.6)",
        },
        Symbol {
            name: "theta",
            symbol: "θ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt against the pulley's circle; positive unseats",
            source: "(3.2)",
        },
        Symbol {
            name: "theta1",
            symbol: "θ\u{302}'",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region",
            source: "(5.2)",
        },
        Symbol {
            name: "theta2",
            symbol: "θ\u{302}''",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region",
            source: "(5.3)",
        },
        Symbol {
            name: "x",
            symbol: "x",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration R − r",
            source: "(3.24)",
        },
        Symbol {
            name: "tau",
            symbol: "τ",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension in a span",
            source: "(3.45)",
        },
        Symbol {
            name: "vartheta",
            symbol: "ϑ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the belt in a span against the line of centres",
            source: "(3.43)",
        },
        Symbol {
            name: "vartheta1",
            symbol: "ϑ\u{302}'",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span",
            source: "(5.10)",
        },
        Symbol {
            name: "vartheta2",
            symbol: "ϑ\u{302}''",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span",
            source: "(5.11)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for State {
    const COUNT: usize = 9;
    fn place(self) -> usize {
        self as usize
    }
}
/// A constant as a single region knows it; the drive's constants give it its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum RegionConstant {
    /// Φ: wrap angle, rad; (5.1)
    WrapAngle,
    /// L: arc length of the span, m; (5.9)
    SpanLength,
    /// σ: speed of the pulley over the primary's, ω/ω_P; (3.12)
    PulleySpeedRatio,
    /// g: mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P); (3.5)
    Flow,
    /// EA: longitudinal stiffness, N; (3.8)
    LongitudinalStiffness,
    /// EI: bending stiffness, N·m²; (3.26)
    BendingStiffness,
    /// k: radial stiffness: axial force per length and penetration, both sheaves together, N/m²; (3.16)
    RadialStiffness,
    /// m_o: mass per length, unloaded, kg/m; (3.5)
    MassPerLength,
    /// R: nominal radius of the pulley, m; (3.12)
    PulleyRadius,
    /// R_P: nominal radius of the primary, m; Table 6.1
    PrimaryRadius,
    /// β: half angle of the sheave's groove, rad; (3.7)
    HalfAngle,
    /// μ_k: kinetic coefficient of friction; Fig. 3.6
    FrictionCoefficient,
    /// v_thr: slip threshold of the friction law, m/s; Fig. 3.6
    SlipThreshold,
    /// ω_P: angular speed of the primary, rad/s; Table 6.1
    PrimarySpeed,
}
impl RegionConstant {
    /// All of them, in order.
    pub const ALL: [Self; 14] = [
        Self::WrapAngle,
        Self::SpanLength,
        Self::PulleySpeedRatio,
        Self::Flow,
        Self::LongitudinalStiffness,
        Self::BendingStiffness,
        Self::RadialStiffness,
        Self::MassPerLength,
        Self::PulleyRadius,
        Self::PrimaryRadius,
        Self::HalfAngle,
        Self::FrictionCoefficient,
        Self::SlipThreshold,
        Self::PrimarySpeed,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 14] = &[
        Symbol {
            name: "Phi",
            symbol: "Φ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "(5.1)",
        },
        Symbol {
            name: "L",
            symbol: "L",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length of the span",
            source: "(5.9)",
        },
        Symbol {
            name: "sigma",
            symbol: "σ",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "speed of the pulley over the primary's, ω/ω_P",
            source: "(3.12)",
        },
        Symbol {
            name: "flow",
            symbol: "g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P)",
            source: "(3.5)",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness",
            source: "(3.8)",
        },
        Symbol {
            name: "EI",
            symbol: "EI",
            unit: "N·m²",
            dimension: Dimension {
                length: 3,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "bending stiffness",
            source: "(3.26)",
        },
        Symbol {
            name: "k",
            symbol: "k",
            unit: "N/m²",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "radial stiffness: axial force per length and penetration, both sheaves together",
            source: "(3.16)",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length, unloaded",
            source: "(3.5)",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the pulley",
            source: "(3.12)",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the primary",
            source: "Table 6.1",
        },
        Symbol {
            name: "beta",
            symbol: "β",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half angle of the sheave's groove",
            source: "(3.7)",
        },
        Symbol {
            name: "mu_k",
            symbol: "μ_k",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "kinetic coefficient of friction",
            source: "Fig. 3.6",
        },
        Symbol {
            name: "v_thr",
            symbol: "v_thr",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "slip threshold of the friction law",
            source: "Fig. 3.6",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "angular speed of the primary",
            source: "Table 6.1",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for RegionConstant {
    const COUNT: usize = 14;
    fn place(self) -> usize {
        self as usize
    }
}
/// An integral along a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Integral {
    /// M: torque of friction on the belt, N·m; (5.54)
    Torque,
    /// A: axial force on one sheave, N; (5.58)
    AxialForce,
    /// L_o: unstretched length of the belt in the region, m; (5.55)
    UnstretchedLength,
    /// W: power lost to friction, W; power of friction
    FrictionLoss,
    /// E: power that changes of speed take from the energy stored in bending and squeezing, W; energy balance
    StrainEnergyFlux,
    /// A_x: first moment of the axial force along the direction of the entry, N·m; (6.1)
    AxialMomentAlong,
    /// A_y: first moment of the axial force across the direction of the entry, N·m; (6.2)
    AxialMomentAcross,
    /// X̂: progress along the line of centres over L; (5.25)
    PositionAlong,
    /// Ŷ: progress across the line of centres over L; (5.26)
    PositionAcross,
}
impl Integral {
    /// All of them, in order.
    pub const ALL: [Self; 9] = [
        Self::Torque,
        Self::AxialForce,
        Self::UnstretchedLength,
        Self::FrictionLoss,
        Self::StrainEnergyFlux,
        Self::AxialMomentAlong,
        Self::AxialMomentAcross,
        Self::PositionAlong,
        Self::PositionAcross,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 9] = &[
        Symbol {
            name: "M",
            symbol: "M",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of friction on the belt",
            source: "(5.54)",
        },
        Symbol {
            name: "A",
            symbol: "A",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on one sheave",
            source: "(5.58)",
        },
        Symbol {
            name: "L_o",
            symbol: "L_o",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the belt in the region",
            source: "(5.55)",
        },
        Symbol {
            name: "W",
            symbol: "W",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction",
            source: "power of friction",
        },
        Symbol {
            name: "E",
            symbol: "E",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that changes of speed take from the energy stored in bending and squeezing",
            source: "energy balance",
        },
        Symbol {
            name: "A_x",
            symbol: "A_x",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force along the direction of the entry",
            source: "(6.1)",
        },
        Symbol {
            name: "A_y",
            symbol: "A_y",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force across the direction of the entry",
            source: "(6.2)",
        },
        Symbol {
            name: "X",
            symbol: "X\u{302}",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress along the line of centres over L",
            source: "(5.25)",
        },
        Symbol {
            name: "Y",
            symbol: "Ŷ",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress across the line of centres over L",
            source: "(5.26)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for Integral {
    const COUNT: usize = 9;
    fn place(self) -> usize {
        self as usize
    }
}
/// A quantity along a region that follows from its states and constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Field {
    /// F: belt tension, N; (3.10)
    BeltTension,
    /// V: belt speed, m/s; (3.11)
    BeltSpeed,
    /// v_r: radial sliding speed, m/s; (3.12)
    RadialSlidingSpeed,
    /// v_t: circumferential sliding speed, m/s; (3.12)
    TangentialSlidingSpeed,
    /// |v|: sliding speed in the plane of the pulley, m/s; (3.12)
    SlidingSpeed,
    /// γ: sliding angle from the outward radius, 0 to 2π, rad; (3.13)
    SlidingAngle,
    /// μ: coefficient of friction; Fig. 3.6
    FrictionAtPoint,
    /// β_s: apparent sheave angle, rad; (3.14)
    ApparentSheaveAngle,
    /// p: normal pressure of one sheave on the belt, per length, N/m; (3.18)
    Pressure,
    /// M_b: bending moment, N·m; (3.26)
    BendingMoment,
    /// Q: transverse shear force, N; (3.27)
    Shear,
    /// dA/ds: axial force on one sheave per length, N/m; (5.58)
    AxialForcePerLength,
    /// dW/ds: power lost to friction per length, W/m; power of friction
    LossPerLength,
    /// dW_r/ds: the part of dW/ds lost to sliding up and down the sheave, W/m; power of friction
    RadialLossPerLength,
    /// dW_t/ds: the part of dW/ds lost to sliding around the pulley, W/m; power of friction
    TangentialLossPerLength,
    /// dW/dφ: power lost to friction per wrap angle, W/rad; power of friction
    LossPerWrap,
}
impl Field {
    /// All of them, in order.
    pub const ALL: [Self; 16] = [
        Self::BeltTension,
        Self::BeltSpeed,
        Self::RadialSlidingSpeed,
        Self::TangentialSlidingSpeed,
        Self::SlidingSpeed,
        Self::SlidingAngle,
        Self::FrictionAtPoint,
        Self::ApparentSheaveAngle,
        Self::Pressure,
        Self::BendingMoment,
        Self::Shear,
        Self::AxialForcePerLength,
        Self::LossPerLength,
        Self::RadialLossPerLength,
        Self::TangentialLossPerLength,
        Self::LossPerWrap,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 16] = &[
        Symbol {
            name: "F",
            symbol: "F",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "belt tension",
            source: "(3.10)",
        },
        Symbol {
            name: "V",
            symbol: "V",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "belt speed",
            source: "(3.11)",
        },
        Symbol {
            name: "v_r",
            symbol: "v_r",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "radial sliding speed",
            source: "(3.12)",
        },
        Symbol {
            name: "v_t",
            symbol: "v_t",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "circumferential sliding speed",
            source: "(3.12)",
        },
        Symbol {
            name: "speed",
            symbol: "|v|",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "sliding speed in the plane of the pulley",
            source: "(3.12)",
        },
        Symbol {
            name: "gamma",
            symbol: "γ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "sliding angle from the outward radius, 0 to 2π",
            source: "(3.13)",
        },
        Symbol {
            name: "mu",
            symbol: "μ",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction",
            source: "Fig. 3.6",
        },
        Symbol {
            name: "beta_s",
            symbol: "β_s",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "apparent sheave angle",
            source: "(3.14)",
        },
        Symbol {
            name: "p",
            symbol: "p",
            unit: "N/m",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "normal pressure of one sheave on the belt, per length",
            source: "(3.18)",
        },
        Symbol {
            name: "M_b",
            symbol: "M_b",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "bending moment",
            source: "(3.26)",
        },
        Symbol {
            name: "Q",
            symbol: "Q",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "transverse shear force",
            source: "(3.27)",
        },
        Symbol {
            name: "axial",
            symbol: "dA/ds",
            unit: "N/m",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on one sheave per length",
            source: "(5.58)",
        },
        Symbol {
            name: "loss",
            symbol: "dW/ds",
            unit: "W/m",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction per length",
            source: "power of friction",
        },
        Symbol {
            name: "loss_radial",
            symbol: "dW_r/ds",
            unit: "W/m",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "the part of dW/ds lost to sliding up and down the sheave",
            source: "power of friction",
        },
        Symbol {
            name: "loss_tangential",
            symbol: "dW_t/ds",
            unit: "W/m",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "the part of dW/ds lost to sliding around the pulley",
            source: "power of friction",
        },
        Symbol {
            name: "loss_phi",
            symbol: "dW/dφ",
            unit: "W/rad",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: -1,
            },
            doc: "power lost to friction per wrap angle",
            source: "power of friction",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for Field {
    const COUNT: usize = 16;
    fn place(self) -> usize {
        self as usize
    }
}
/// A constant of the whole drive, given or unknown, in the order of every vector of constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Constant {
    /// σ_S: speed of the secondary over the primary's, ω_S/ω_P; (6.7)
    SpeedRatio,
    /// g: mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P); (3.5)
    Flow,
    /// Φ_P: wrap angle of the primary, rad; (5.17)
    PrimaryWrap,
    /// Φ_S: wrap angle of the secondary, rad; (5.19)
    SecondaryWrap,
    /// C_P: orientation of the primary: from the line of centres to the belt's entry, rad; (5.17)
    PrimaryOrientation,
    /// C_S: orientation of the secondary: from the line of centres to the belt's exit, rad; (5.19)
    SecondaryOrientation,
    /// L_t: arc length of the tight span, m; (5.27)
    TightLength,
    /// L_s: arc length of the slack span, m; (5.29)
    SlackLength,
    /// EA: longitudinal stiffness, N; (3.8)
    LongitudinalStiffness,
    /// EI: bending stiffness, N·m²; (3.26)
    BendingStiffness,
    /// k: radial stiffness: axial force per length and penetration, both sheaves together, N/m²; (3.16)
    RadialStiffness,
    /// m_o: mass per length, unloaded, kg/m; (3.5)
    MassPerLength,
    /// R_P: nominal radius of the primary, m; Table 6.1
    PrimaryRadius,
    /// R_S: nominal radius of the secondary, m; Table 6.1
    SecondaryRadius,
    /// L_c: distance between the pulleys' centres, m; Table 6.1
    CenterDistance,
    /// β: half angle of the sheave's groove, rad; (3.7)
    HalfAngle,
    /// μ_k: kinetic coefficient of friction; Fig. 3.6
    FrictionCoefficient,
    /// v_thr: slip threshold of the friction law, m/s; Fig. 3.6
    SlipThreshold,
    /// ω_P: angular speed of the primary, rad/s; Table 6.1
    PrimarySpeed,
    /// M_in: torque that drives the primary, N·m; 5.3.5
    PrimaryTorque,
    /// T_slack: tractive tension where the belt leaves the primary, N; 5.3.5
    SlackTension,
}
impl Constant {
    /// All of them, in order.
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
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 21] = &[
        Symbol {
            name: "speed_ratio",
            symbol: "σ_S",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "speed of the secondary over the primary's, ω_S/ω_P",
            source: "(6.7)",
        },
        Symbol {
            name: "flow",
            symbol: "g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P)",
            source: "(3.5)",
        },
        Symbol {
            name: "Phi_P",
            symbol: "Φ_P",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle of the primary",
            source: "(5.17)",
        },
        Symbol {
            name: "Phi_S",
            symbol: "Φ_S",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle of the secondary",
            source: "(5.19)",
        },
        Symbol {
            name: "C_P",
            symbol: "C_P",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "orientation of the primary: from the line of centres to the belt's entry",
            source: "(5.17)",
        },
        Symbol {
            name: "C_S",
            symbol: "C_S",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "orientation of the secondary: from the line of centres to the belt's exit",
            source: "(5.19)",
        },
        Symbol {
            name: "L_t",
            symbol: "L_t",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length of the tight span",
            source: "(5.27)",
        },
        Symbol {
            name: "L_s",
            symbol: "L_s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length of the slack span",
            source: "(5.29)",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness",
            source: "(3.8)",
        },
        Symbol {
            name: "EI",
            symbol: "EI",
            unit: "N·m²",
            dimension: Dimension {
                length: 3,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "bending stiffness",
            source: "(3.26)",
        },
        Symbol {
            name: "k",
            symbol: "k",
            unit: "N/m²",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "radial stiffness: axial force per length and penetration, both sheaves together",
            source: "(3.16)",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length, unloaded",
            source: "(3.5)",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the primary",
            source: "Table 6.1",
        },
        Symbol {
            name: "R_S",
            symbol: "R_S",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the secondary",
            source: "Table 6.1",
        },
        Symbol {
            name: "L_c",
            symbol: "L_c",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance between the pulleys' centres",
            source: "Table 6.1",
        },
        Symbol {
            name: "beta",
            symbol: "β",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half angle of the sheave's groove",
            source: "(3.7)",
        },
        Symbol {
            name: "mu_k",
            symbol: "μ_k",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "kinetic coefficient of friction",
            source: "Fig. 3.6",
        },
        Symbol {
            name: "v_thr",
            symbol: "v_thr",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "slip threshold of the friction law",
            source: "Fig. 3.6",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "angular speed of the primary",
            source: "Table 6.1",
        },
        Symbol {
            name: "M_in",
            symbol: "M_in",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that drives the primary",
            source: "5.3.5",
        },
        Symbol {
            name: "T_slack",
            symbol: "T_slack",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt leaves the primary",
            source: "5.3.5",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for Constant {
    const COUNT: usize = 21;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a drive is asked for. Its name is its group and its key in the result object.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Output {
    /// ω_P: speed of rotation, rad/s; 5.1
    PrimarySpeed,
    /// M_P: torque that drives the pulley, N·m; (5.54)
    PrimaryTorque,
    /// P_P: power into the pulley, W; 6.2
    PrimaryPower,
    /// A_P: axial force on a sheave, N; (5.58)
    PrimaryAxialForce,
    /// Φ_P: wrap angle, rad; (5.1)
    PrimaryWrapAngle,
    /// θ_P1: inclination where the belt enters, rad; (3.2)
    PrimaryEntryAngle,
    /// θ_P2: inclination where the belt leaves, rad; (3.2)
    PrimaryExitAngle,
    /// C_P: orientation angle, rad; (5.17) to (5.20)
    PrimaryOrientationAngle,
    /// x_AP: where the axial force acts, m; (6.3), (6.5)
    PrimaryResultantX,
    /// y_AP: where the axial force acts, m; (6.4), (6.5)
    PrimaryResultantY,
    /// B_P: moment of the axial force about the centre, N·m; 6.1.2
    PrimaryBindingMoment,
    /// W_P: power lost to friction, W; power of friction
    PrimaryFrictionLoss,
    /// T_P1: tractive tension where the belt enters, N; (3.6)
    PrimaryEntryTension,
    /// T_P2: tractive tension where the belt leaves, N; (3.6)
    PrimaryExitTension,
    /// ω_S: speed of rotation, rad/s; 5.1
    SecondarySpeed,
    /// M_S: torque that the pulley delivers, N·m; (5.54)
    SecondaryTorque,
    /// P_S: power out of the pulley, W; 6.2
    SecondaryPower,
    /// A_S: axial force on a sheave, N; (5.58)
    SecondaryAxialForce,
    /// Φ_S: wrap angle, rad; (5.1)
    SecondaryWrapAngle,
    /// θ_S1: inclination where the belt enters, rad; (3.2)
    SecondaryEntryAngle,
    /// θ_S2: inclination where the belt leaves, rad; (3.2)
    SecondaryExitAngle,
    /// C_S: orientation angle, rad; (5.17) to (5.20)
    SecondaryOrientationAngle,
    /// x_AS: where the axial force acts, m; (6.3), (6.6)
    SecondaryResultantX,
    /// y_AS: where the axial force acts, m; (6.4), (6.6)
    SecondaryResultantY,
    /// B_S: moment of the axial force about the centre, N·m; 6.1.2
    SecondaryBindingMoment,
    /// W_S: power lost to friction, W; power of friction
    SecondaryFrictionLoss,
    /// T_S1: tractive tension where the belt enters, N; (3.6)
    SecondaryEntryTension,
    /// T_S2: tractive tension where the belt leaves, N; (3.6)
    SecondaryExitTension,
    /// L_t: arc length, m; (5.9)
    TightSpanArcLength,
    /// L_ot: length when unloaded, m; (5.56)
    TightSpanUnstretchedLength,
    /// L_s: arc length, m; (5.9)
    SlackSpanArcLength,
    /// L_os: length when unloaded, m; (5.56)
    SlackSpanUnstretchedLength,
    /// η_ω: speed efficiency; (6.7)
    EfficiencySpeed,
    /// η_M: torque efficiency; (6.8)
    EfficiencyTorque,
    /// η: overall efficiency; (6.9)
    EfficiencyOverall,
    /// G: mass flow, kg/s; (3.5)
    BeltMassFlow,
    /// L_o: length of the loop when unloaded, m; (5.55), (5.56)
    BeltUnstretchedLength,
    /// P_in: power into the drive, W; energy balance
    EnergyPowerIn,
    /// P_out: power out of the drive, W; energy balance
    EnergyPowerOut,
    /// W: power lost to friction, W; power of friction
    EnergyFrictionLoss,
    /// E: strain energy flux: power that bending and squeezing take as the belt changes its speed, W; energy balance
    EnergyStretchWork,
    /// 1 − (P_out + W)/P_in: power in that is neither power out nor friction loss, over power in; energy balance
    EnergyImbalance,
    /// 1 − (P_out + W + E)/P_in: power in that nothing accounts for, over power in; energy balance
    EnergyClosure,
}
impl Output {
    /// All of them, in order.
    pub const ALL: [Self; 43] = [
        Self::PrimarySpeed,
        Self::PrimaryTorque,
        Self::PrimaryPower,
        Self::PrimaryAxialForce,
        Self::PrimaryWrapAngle,
        Self::PrimaryEntryAngle,
        Self::PrimaryExitAngle,
        Self::PrimaryOrientationAngle,
        Self::PrimaryResultantX,
        Self::PrimaryResultantY,
        Self::PrimaryBindingMoment,
        Self::PrimaryFrictionLoss,
        Self::PrimaryEntryTension,
        Self::PrimaryExitTension,
        Self::SecondarySpeed,
        Self::SecondaryTorque,
        Self::SecondaryPower,
        Self::SecondaryAxialForce,
        Self::SecondaryWrapAngle,
        Self::SecondaryEntryAngle,
        Self::SecondaryExitAngle,
        Self::SecondaryOrientationAngle,
        Self::SecondaryResultantX,
        Self::SecondaryResultantY,
        Self::SecondaryBindingMoment,
        Self::SecondaryFrictionLoss,
        Self::SecondaryEntryTension,
        Self::SecondaryExitTension,
        Self::TightSpanArcLength,
        Self::TightSpanUnstretchedLength,
        Self::SlackSpanArcLength,
        Self::SlackSpanUnstretchedLength,
        Self::EfficiencySpeed,
        Self::EfficiencyTorque,
        Self::EfficiencyOverall,
        Self::BeltMassFlow,
        Self::BeltUnstretchedLength,
        Self::EnergyPowerIn,
        Self::EnergyPowerOut,
        Self::EnergyFrictionLoss,
        Self::EnergyStretchWork,
        Self::EnergyImbalance,
        Self::EnergyClosure,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 43] = &[
        Symbol {
            name: "primary.speed",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of rotation",
            source: "5.1",
        },
        Symbol {
            name: "primary.torque",
            symbol: "M_P",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that drives the pulley",
            source: "(5.54)",
        },
        Symbol {
            name: "primary.power",
            symbol: "P_P",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power into the pulley",
            source: "6.2",
        },
        Symbol {
            name: "primary.axial_force",
            symbol: "A_P",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on a sheave",
            source: "(5.58)",
        },
        Symbol {
            name: "primary.wrap_angle",
            symbol: "Φ_P",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "(5.1)",
        },
        Symbol {
            name: "primary.entry_angle",
            symbol: "θ_P1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination where the belt enters",
            source: "(3.2)",
        },
        Symbol {
            name: "primary.exit_angle",
            symbol: "θ_P2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination where the belt leaves",
            source: "(3.2)",
        },
        Symbol {
            name: "primary.orientation_angle",
            symbol: "C_P",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "orientation angle",
            source: "(5.17) to (5.20)",
        },
        Symbol {
            name: "primary.resultant_x",
            symbol: "x_AP",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "where the axial force acts",
            source: "(6.3), (6.5)",
        },
        Symbol {
            name: "primary.resultant_y",
            symbol: "y_AP",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "where the axial force acts",
            source: "(6.4), (6.5)",
        },
        Symbol {
            name: "primary.binding_moment",
            symbol: "B_P",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "moment of the axial force about the centre",
            source: "6.1.2",
        },
        Symbol {
            name: "primary.friction_loss",
            symbol: "W_P",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction",
            source: "power of friction",
        },
        Symbol {
            name: "primary.entry_tension",
            symbol: "T_P1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt enters",
            source: "(3.6)",
        },
        Symbol {
            name: "primary.exit_tension",
            symbol: "T_P2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt leaves",
            source: "(3.6)",
        },
        Symbol {
            name: "secondary.speed",
            symbol: "ω_S",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of rotation",
            source: "5.1",
        },
        Symbol {
            name: "secondary.torque",
            symbol: "M_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that the pulley delivers",
            source: "(5.54)",
        },
        Symbol {
            name: "secondary.power",
            symbol: "P_S",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power out of the pulley",
            source: "6.2",
        },
        Symbol {
            name: "secondary.axial_force",
            symbol: "A_S",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on a sheave",
            source: "(5.58)",
        },
        Symbol {
            name: "secondary.wrap_angle",
            symbol: "Φ_S",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "(5.1)",
        },
        Symbol {
            name: "secondary.entry_angle",
            symbol: "θ_S1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination where the belt enters",
            source: "(3.2)",
        },
        Symbol {
            name: "secondary.exit_angle",
            symbol: "θ_S2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination where the belt leaves",
            source: "(3.2)",
        },
        Symbol {
            name: "secondary.orientation_angle",
            symbol: "C_S",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "orientation angle",
            source: "(5.17) to (5.20)",
        },
        Symbol {
            name: "secondary.resultant_x",
            symbol: "x_AS",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "where the axial force acts",
            source: "(6.3), (6.6)",
        },
        Symbol {
            name: "secondary.resultant_y",
            symbol: "y_AS",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "where the axial force acts",
            source: "(6.4), (6.6)",
        },
        Symbol {
            name: "secondary.binding_moment",
            symbol: "B_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "moment of the axial force about the centre",
            source: "6.1.2",
        },
        Symbol {
            name: "secondary.friction_loss",
            symbol: "W_S",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction",
            source: "power of friction",
        },
        Symbol {
            name: "secondary.entry_tension",
            symbol: "T_S1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt enters",
            source: "(3.6)",
        },
        Symbol {
            name: "secondary.exit_tension",
            symbol: "T_S2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt leaves",
            source: "(3.6)",
        },
        Symbol {
            name: "tight_span.arc_length",
            symbol: "L_t",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length",
            source: "(5.9)",
        },
        Symbol {
            name: "tight_span.unstretched_length",
            symbol: "L_ot",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "length when unloaded",
            source: "(5.56)",
        },
        Symbol {
            name: "slack_span.arc_length",
            symbol: "L_s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length",
            source: "(5.9)",
        },
        Symbol {
            name: "slack_span.unstretched_length",
            symbol: "L_os",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "length when unloaded",
            source: "(5.56)",
        },
        Symbol {
            name: "efficiency.speed",
            symbol: "η_ω",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "speed efficiency",
            source: "(6.7)",
        },
        Symbol {
            name: "efficiency.torque",
            symbol: "η_M",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "torque efficiency",
            source: "(6.8)",
        },
        Symbol {
            name: "efficiency.overall",
            symbol: "η",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "overall efficiency",
            source: "(6.9)",
        },
        Symbol {
            name: "belt.mass_flow",
            symbol: "G",
            unit: "kg/s",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: -1,
                angle: 0,
            },
            doc: "mass flow",
            source: "(3.5)",
        },
        Symbol {
            name: "belt.unstretched_length",
            symbol: "L_o",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "length of the loop when unloaded",
            source: "(5.55), (5.56)",
        },
        Symbol {
            name: "energy.power_in",
            symbol: "P_in",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power into the drive",
            source: "energy balance",
        },
        Symbol {
            name: "energy.power_out",
            symbol: "P_out",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power out of the drive",
            source: "energy balance",
        },
        Symbol {
            name: "energy.friction_loss",
            symbol: "W",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction",
            source: "power of friction",
        },
        Symbol {
            name: "energy.stretch_work",
            symbol: "E",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "strain energy flux: power that bending and squeezing take as the belt changes its speed",
            source: "energy balance",
        },
        Symbol {
            name: "energy.imbalance",
            symbol: "1 − (P_out + W)/P_in",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "power in that is neither power out nor friction loss, over power in",
            source: "energy balance",
        },
        Symbol {
            name: "energy.closure",
            symbol: "1 − (P_out + W + E)/P_in",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "power in that nothing accounts for, over power in",
            source: "energy balance",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for Output {
    const COUNT: usize = 43;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SimpleDriveInput {
    /// ω_I: speed of the input pulley, rad/s
    InputSpeed,
    /// ω_O: speed of the output pulley, rad/s
    OutputSpeed,
    /// M_I: torque of the belt on the input pulley, negative where it drives, N·m
    InputTorque,
    /// M_O: torque of the belt on the output pulley, positive where it is driven, N·m
    OutputTorque,
    /// F_CI: axial force on the input pulley, N
    InputAxialForce,
    /// F_CO: axial force on the output pulley, N
    OutputAxialForce,
    /// v_0: speed of the unstretched belt, m/s
    BeltSpeed,
    /// r ω: speed of both rims at no torque (2.219), m/s
    RimSpeed,
    /// r_I: radius of the input pulley, m
    InputRadius,
    /// r_O: radius of the output pulley, m
    OutputRadius,
    /// φ: half the contact angle on the output pulley; on the input pulley it is π − φ, rad
    HalfContactAngle,
    /// EA: longitudinal stiffness of the belt, N
    LongitudinalStiffness,
    /// m*: mass per length of the unstretched belt, kg/m
    MassPerLength,
    /// μ*: coefficient of friction in the groove; negative where the output drives
    GrooveFriction,
    /// δ_0: half angle of the groove, rad
    HalfAngle,
}
impl SimpleDriveInput {
    /// All of them, in order.
    pub const ALL: [Self; 15] = [
        Self::InputSpeed,
        Self::OutputSpeed,
        Self::InputTorque,
        Self::OutputTorque,
        Self::InputAxialForce,
        Self::OutputAxialForce,
        Self::BeltSpeed,
        Self::RimSpeed,
        Self::InputRadius,
        Self::OutputRadius,
        Self::HalfContactAngle,
        Self::LongitudinalStiffness,
        Self::MassPerLength,
        Self::GrooveFriction,
        Self::HalfAngle,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 15] = &[
        Symbol {
            name: "omega_I",
            symbol: "ω_I",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the input pulley",
            source: "",
        },
        Symbol {
            name: "omega_O",
            symbol: "ω_O",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the output pulley",
            source: "",
        },
        Symbol {
            name: "M_I",
            symbol: "M_I",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the belt on the input pulley, negative where it drives",
            source: "",
        },
        Symbol {
            name: "M_O",
            symbol: "M_O",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the belt on the output pulley, positive where it is driven",
            source: "",
        },
        Symbol {
            name: "F_CI",
            symbol: "F_CI",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on the input pulley",
            source: "",
        },
        Symbol {
            name: "F_CO",
            symbol: "F_CO",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on the output pulley",
            source: "",
        },
        Symbol {
            name: "v_0",
            symbol: "v_0",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "speed of the unstretched belt",
            source: "",
        },
        Symbol {
            name: "u",
            symbol: "r ω",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "speed of both rims at no torque (2.219)",
            source: "",
        },
        Symbol {
            name: "r_I",
            symbol: "r_I",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the input pulley",
            source: "",
        },
        Symbol {
            name: "r_O",
            symbol: "r_O",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the output pulley",
            source: "",
        },
        Symbol {
            name: "phi_O",
            symbol: "φ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half the contact angle on the output pulley; on the input pulley it is π − φ",
            source: "",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness of the belt",
            source: "",
        },
        Symbol {
            name: "m_star",
            symbol: "m*",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length of the unstretched belt",
            source: "",
        },
        Symbol {
            name: "mu_star",
            symbol: "μ*",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction in the groove; negative where the output drives",
            source: "",
        },
        Symbol {
            name: "delta_0",
            symbol: "δ_0",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half angle of the groove",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for SimpleDriveInput {
    const COUNT: usize = 15;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SimpleDriveResidual {
    /// speeds and M_O (2), m/s; (2)
    OutputSpeedBalance,
    /// speeds and M_I (18), m/s; (18)
    InputSpeedBalance,
    /// axial force on the output pulley (5), N; (5)
    OutputAxialBalance,
    /// axial force on the input pulley (13), N; (13)
    InputAxialBalance,
}
impl SimpleDriveResidual {
    /// All of them, in order.
    pub const ALL: [Self; 4] = [
        Self::OutputSpeedBalance,
        Self::InputSpeedBalance,
        Self::OutputAxialBalance,
        Self::InputAxialBalance,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 4] = &[
        Symbol {
            name: "speed_O",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "speeds and M_O (2)",
            source: "(2)",
        },
        Symbol {
            name: "speed_I",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "speeds and M_I (18)",
            source: "(18)",
        },
        Symbol {
            name: "axial_O",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on the output pulley (5)",
            source: "(5)",
        },
        Symbol {
            name: "axial_I",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on the input pulley (13)",
            source: "(13)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for SimpleDriveResidual {
    const COUNT: usize = 4;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SimpleDriveOutput {
    /// v_0 at no torque, from F_CO and r ω (2.220), m/s; 2.220
    BeltSpeedFromOutputForce,
    /// v_0 at no torque, from F_CI and r ω (15), m/s; (15)
    BeltSpeedFromInputForce,
    /// ω_O from ω_I, M_O and v_0 (21), rad/s; (21)
    OutputSpeedFromTorque,
    /// ω_I from ω_O, M_O and v_0 (2), rad/s; (2)
    InputSpeedFromTorque,
    /// M_O from both speeds and v_0 (17), N·m; (17)
    OutputTorqueFromSpeeds,
    /// M_I from both speeds and v_0 (19), N·m; (19)
    InputTorqueFromSpeeds,
    /// M_O from M_I (11), N·m; (11)
    OutputTorqueFromInput,
    /// M_I from M_O (20), N·m; (20)
    InputTorqueFromOutput,
    /// longitudinal force at which the belt lifts off, K, N; 1.2
    LiftOffForce,
    /// longitudinal force where the belt enters the output pulley (2.218), N; 1.2
    SlackForce,
    /// longitudinal force where the belt enters the input pulley (7), N; 1.2
    TightForce,
    /// tractive tension where the belt enters the output pulley, N; (12)
    SlackTension,
    /// tractive tension where the belt enters the input pulley, N; (12)
    TightTension,
    /// Φ_O from both speeds and v_0 (22), rad; (22), (25)
    OutputSlidingAngle,
    /// Φ_I from both speeds and v_0 (25), rad; (22), (25)
    InputSlidingAngle,
    /// F_CO from both speeds and v_0 (23), N; (23), (26)
    OutputForceFromSpeeds,
    /// F_CI from both speeds and v_0 (26), N; (23), (26)
    InputForceFromSpeeds,
    /// F_CO at which the belt slides on all of the output pulley, from M_O and v_0, N; (5) and (13) where all of the contact slides
    OutputSlipForce,
    /// F_CI at which the belt slides on all of the input pulley, from M_I and v_0, N; (5) and (13) where all of the contact slides
    InputSlipForce,
}
impl SimpleDriveOutput {
    /// All of them, in order.
    pub const ALL: [Self; 19] = [
        Self::BeltSpeedFromOutputForce,
        Self::BeltSpeedFromInputForce,
        Self::OutputSpeedFromTorque,
        Self::InputSpeedFromTorque,
        Self::OutputTorqueFromSpeeds,
        Self::InputTorqueFromSpeeds,
        Self::OutputTorqueFromInput,
        Self::InputTorqueFromOutput,
        Self::LiftOffForce,
        Self::SlackForce,
        Self::TightForce,
        Self::SlackTension,
        Self::TightTension,
        Self::OutputSlidingAngle,
        Self::InputSlidingAngle,
        Self::OutputForceFromSpeeds,
        Self::InputForceFromSpeeds,
        Self::OutputSlipForce,
        Self::InputSlipForce,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 19] = &[
        Symbol {
            name: "v_0_O",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "v_0 at no torque, from F_CO and r ω (2.220)",
            source: "2.220",
        },
        Symbol {
            name: "v_0_I",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "v_0 at no torque, from F_CI and r ω (15)",
            source: "(15)",
        },
        Symbol {
            name: "omega_O_of_M_O",
            symbol: "",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "ω_O from ω_I, M_O and v_0 (21)",
            source: "(21)",
        },
        Symbol {
            name: "omega_I_of_M_O",
            symbol: "",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "ω_I from ω_O, M_O and v_0 (2)",
            source: "(2)",
        },
        Symbol {
            name: "M_O_of_speeds",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "M_O from both speeds and v_0 (17)",
            source: "(17)",
        },
        Symbol {
            name: "M_I_of_speeds",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "M_I from both speeds and v_0 (19)",
            source: "(19)",
        },
        Symbol {
            name: "M_O_of_M_I",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "M_O from M_I (11)",
            source: "(11)",
        },
        Symbol {
            name: "M_I_of_M_O",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "M_I from M_O (20)",
            source: "(20)",
        },
        Symbol {
            name: "lift_off",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal force at which the belt lifts off, K",
            source: "1.2",
        },
        Symbol {
            name: "slack_force",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal force where the belt enters the output pulley (2.218)",
            source: "1.2",
        },
        Symbol {
            name: "tight_force",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal force where the belt enters the input pulley (7)",
            source: "1.2",
        },
        Symbol {
            name: "slack_tension",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt enters the output pulley",
            source: "(12)",
        },
        Symbol {
            name: "tight_tension",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension where the belt enters the input pulley",
            source: "(12)",
        },
        Symbol {
            name: "sliding_O",
            symbol: "",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "Φ_O from both speeds and v_0 (22)",
            source: "(22), (25)",
        },
        Symbol {
            name: "sliding_I",
            symbol: "",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "Φ_I from both speeds and v_0 (25)",
            source: "(22), (25)",
        },
        Symbol {
            name: "F_CO_of_speeds",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "F_CO from both speeds and v_0 (23)",
            source: "(23), (26)",
        },
        Symbol {
            name: "F_CI_of_speeds",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "F_CI from both speeds and v_0 (26)",
            source: "(23), (26)",
        },
        Symbol {
            name: "F_slip_O",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "F_CO at which the belt slides on all of the output pulley, from M_O and v_0",
            source: "(5) and (13) where all of the contact slides",
        },
        Symbol {
            name: "F_slip_I",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "F_CI at which the belt slides on all of the input pulley, from M_I and v_0",
            source: "(5) and (13) where all of the contact slides",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for SimpleDriveOutput {
    const COUNT: usize = 19;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum BeltPulleyInput {
    /// V_A: velocity of branch A along its port, m/s
    VelocityA,
    /// F_A: tension of branch A, N
    TensionA,
    /// V_B: velocity of branch B, away from the pulley, m/s
    VelocityB,
    /// F_B: tension of branch B, N
    TensionB,
    /// ω_S: speed of the pulley, rad/s
    ShaftSpeed,
    /// dω_S/dt: angular acceleration of the pulley, rad/s²
    ShaftAcceleration,
    /// T_S: torque of the pulley on its shaft, N·m
    ShaftTorque,
    /// R: radius of the pulley, m
    Radius,
    /// J: moment of inertia of the pulley, kg·m²
    Inertia,
    /// b: viscous damping of the bearing, N·m·s
    BearingDamping,
    /// ρ: mass per length of the belt, kg/m
    MassPerLength,
    /// θ: wrap angle, rad
    WrapAngle,
    /// f: coefficient of friction of belt on pulley; f' of a V-belt
    FrictionCoefficient,
    /// V_thr: friction velocity threshold, m/s
    VelocityThreshold,
    /// F_thr: force below which a branch counts as slack, N
    ForceThreshold,
}
impl BeltPulleyInput {
    /// All of them, in order.
    pub const ALL: [Self; 15] = [
        Self::VelocityA,
        Self::TensionA,
        Self::VelocityB,
        Self::TensionB,
        Self::ShaftSpeed,
        Self::ShaftAcceleration,
        Self::ShaftTorque,
        Self::Radius,
        Self::Inertia,
        Self::BearingDamping,
        Self::MassPerLength,
        Self::WrapAngle,
        Self::FrictionCoefficient,
        Self::VelocityThreshold,
        Self::ForceThreshold,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 15] = &[
        Symbol {
            name: "V_A",
            symbol: "V_A",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "velocity of branch A along its port",
            source: "",
        },
        Symbol {
            name: "F_A",
            symbol: "F_A",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tension of branch A",
            source: "",
        },
        Symbol {
            name: "V_B",
            symbol: "V_B",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "velocity of branch B, away from the pulley",
            source: "",
        },
        Symbol {
            name: "F_B",
            symbol: "F_B",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tension of branch B",
            source: "",
        },
        Symbol {
            name: "omega",
            symbol: "ω_S",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the pulley",
            source: "",
        },
        Symbol {
            name: "alpha",
            symbol: "dω_S/dt",
            unit: "rad/s²",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -2,
                angle: 1,
            },
            doc: "angular acceleration of the pulley",
            source: "",
        },
        Symbol {
            name: "T_S",
            symbol: "T_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the pulley on its shaft",
            source: "",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the pulley",
            source: "",
        },
        Symbol {
            name: "J",
            symbol: "J",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "moment of inertia of the pulley",
            source: "",
        },
        Symbol {
            name: "b",
            symbol: "b",
            unit: "N·m·s",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -1,
                angle: 0,
            },
            doc: "viscous damping of the bearing",
            source: "",
        },
        Symbol {
            name: "rho",
            symbol: "ρ",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length of the belt",
            source: "",
        },
        Symbol {
            name: "wrap",
            symbol: "θ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "",
        },
        Symbol {
            name: "f",
            symbol: "f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction of belt on pulley; f' of a V-belt",
            source: "",
        },
        Symbol {
            name: "V_thr",
            symbol: "V_thr",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "friction velocity threshold",
            source: "",
        },
        Symbol {
            name: "F_thr",
            symbol: "F_thr",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "force below which a branch counts as slack",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for BeltPulleyInput {
    const COUNT: usize = 15;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum BeltPulleyOutput {
    /// the ends move in opposite directions: V_A + V_B, m/s; belt direction
    Opposite,
    /// the ends move in the same direction: V_A − V_B, m/s; belt direction
    Equal,
    /// an ideal belt does not slip: V_B − ω R, m/s; ideal belt
    Adhesion,
    /// Euler's relation between the tensions, N; F_fr
    Friction,
    /// balance of moments on the pulley, N·m; T_S
    Torque,
    /// velocity of the belt against the rim, m/s; V_rel
    RelativeVelocity,
    /// centrifugal tension, N; F_C
    CentrifugalTension,
    /// instantaneous coefficient of friction; μ
    FrictionCoefficient,
    /// power that the branches deliver, W; power
    BeltPower,
    /// power that the shaft takes, W; power
    ShaftPower,
    /// power lost to sliding, W; power
    FrictionLoss,
    /// power lost in the bearing, W; power
    BearingLoss,
    /// power that accelerates the pulley, W; power
    KineticPower,
}
impl BeltPulleyOutput {
    /// All of them, in order.
    pub const ALL: [Self; 13] = [
        Self::Opposite,
        Self::Equal,
        Self::Adhesion,
        Self::Friction,
        Self::Torque,
        Self::RelativeVelocity,
        Self::CentrifugalTension,
        Self::FrictionCoefficient,
        Self::BeltPower,
        Self::ShaftPower,
        Self::FrictionLoss,
        Self::BearingLoss,
        Self::KineticPower,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 13] = &[
        Symbol {
            name: "opposite",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "the ends move in opposite directions: V_A + V_B",
            source: "belt direction",
        },
        Symbol {
            name: "equal",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "the ends move in the same direction: V_A − V_B",
            source: "belt direction",
        },
        Symbol {
            name: "adhesion",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "an ideal belt does not slip: V_B − ω R",
            source: "ideal belt",
        },
        Symbol {
            name: "friction",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "Euler's relation between the tensions",
            source: "F_fr",
        },
        Symbol {
            name: "torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "balance of moments on the pulley",
            source: "T_S",
        },
        Symbol {
            name: "relative_velocity",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "velocity of the belt against the rim",
            source: "V_rel",
        },
        Symbol {
            name: "centrifugal_tension",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "centrifugal tension",
            source: "F_C",
        },
        Symbol {
            name: "friction_coefficient",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "instantaneous coefficient of friction",
            source: "μ",
        },
        Symbol {
            name: "belt_power",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that the branches deliver",
            source: "power",
        },
        Symbol {
            name: "shaft_power",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that the shaft takes",
            source: "power",
        },
        Symbol {
            name: "friction_loss",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to sliding",
            source: "power",
        },
        Symbol {
            name: "bearing_loss",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost in the bearing",
            source: "power",
        },
        Symbol {
            name: "kinetic_power",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that accelerates the pulley",
            source: "power",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for BeltPulleyOutput {
    const COUNT: usize = 13;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum BeltPulleyLimitInput {
    /// f: coefficient of friction of belt on sheave face
    FaceFriction,
    /// Φ: angle between the faces of a V-belt's sheave, rad
    GrooveAngle,
    /// f: coefficient of friction of belt on pulley; f' of a V-belt
    FrictionCoefficient,
    /// θ: wrap angle, rad
    WrapAngle,
    /// T_1: tension of the tight branch less the centrifugal tension, N
    TightTension,
    /// T_2: tension of the slack branch less the centrifugal tension, N
    SlackTension,
    /// R: radius of the pulley, m
    Radius,
    /// V_thr: friction velocity threshold, m/s
    VelocityThreshold,
}
impl BeltPulleyLimitInput {
    /// All of them, in order.
    pub const ALL: [Self; 8] = [
        Self::FaceFriction,
        Self::GrooveAngle,
        Self::FrictionCoefficient,
        Self::WrapAngle,
        Self::TightTension,
        Self::SlackTension,
        Self::Radius,
        Self::VelocityThreshold,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 8] = &[
        Symbol {
            name: "f_face",
            symbol: "f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction of belt on sheave face",
            source: "",
        },
        Symbol {
            name: "groove",
            symbol: "Φ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle between the faces of a V-belt's sheave",
            source: "",
        },
        Symbol {
            name: "f",
            symbol: "f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction of belt on pulley; f' of a V-belt",
            source: "",
        },
        Symbol {
            name: "wrap",
            symbol: "θ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "",
        },
        Symbol {
            name: "T_tight",
            symbol: "T_1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tension of the tight branch less the centrifugal tension",
            source: "",
        },
        Symbol {
            name: "T_slack",
            symbol: "T_2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tension of the slack branch less the centrifugal tension",
            source: "",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the pulley",
            source: "",
        },
        Symbol {
            name: "V_thr",
            symbol: "V_thr",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "friction velocity threshold",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for BeltPulleyLimitInput {
    const COUNT: usize = 8;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum BeltPulleyLimit {
    /// effective coefficient of friction of a V-belt, f'; f'
    WedgeCoefficient,
    /// tension ratio; F_fr
    TensionRatio,
    /// tension ratio at which the whole contact slides: Euler's; F_fr
    LargestRatio,
    /// coefficient of friction that the tension ratio takes on the whole contact; F_fr
    MeanCoefficient,
    /// mean coefficient over the coefficient of friction; μ
    Share,
    /// size of V_rel at which the smooth law reaches that share, m/s; μ
    Creep,
    /// moment of the two tensions, N·m; T_S
    Moment,
}
impl BeltPulleyLimit {
    /// All of them, in order.
    pub const ALL: [Self; 7] = [
        Self::WedgeCoefficient,
        Self::TensionRatio,
        Self::LargestRatio,
        Self::MeanCoefficient,
        Self::Share,
        Self::Creep,
        Self::Moment,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 7] = &[
        Symbol {
            name: "wedge_coefficient",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "effective coefficient of friction of a V-belt, f'",
            source: "f'",
        },
        Symbol {
            name: "tension_ratio",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "tension ratio",
            source: "F_fr",
        },
        Symbol {
            name: "largest_ratio",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "tension ratio at which the whole contact slides: Euler's",
            source: "F_fr",
        },
        Symbol {
            name: "mean_coefficient",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of friction that the tension ratio takes on the whole contact",
            source: "F_fr",
        },
        Symbol {
            name: "share",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mean coefficient over the coefficient of friction",
            source: "μ",
        },
        Symbol {
            name: "creep",
            symbol: "",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "size of V_rel at which the smooth law reaches that share",
            source: "μ",
        },
        Symbol {
            name: "moment",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "moment of the two tensions",
            source: "T_S",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for BeltPulleyLimit {
    const COUNT: usize = 7;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum DriveSizingInput {
    /// M_b: mass of the belt, kg
    BeltMass,
    /// M_l: mass that the belt moves in a straight line, kg
    LoadMass,
    /// D_in: diameter of the input pulley, m
    InputDiameter,
    /// D_out: diameter of the output pulley, m
    OutputDiameter,
    /// F: external force on the belt, against its motion, N
    ExternalForce,
    /// F_f: friction force on the linear load, N
    FrictionForce,
    /// T_out: torque that the application takes from the output pulley, N·m
    OutputTorque,
    /// I_p1: inertia of the input pulley, kg·m²
    InputPulleyInertia,
    /// I_p2: inertia of the output pulley, kg·m²
    OutputPulleyInertia,
    /// I_RL: inertia of the rotary load on the output pulley, kg·m²
    RotaryLoadInertia,
    /// I_i: inertia of all idlers as seen at the input, kg·m²
    IdlerInertia,
    /// dω/dt: angular acceleration of the input, rad/s²
    Acceleration,
    /// D: diameter of an idler, m
    IdlerDiameter,
    /// I: inertia of an idler, kg·m²
    OwnInertia,
}
impl DriveSizingInput {
    /// All of them, in order.
    pub const ALL: [Self; 14] = [
        Self::BeltMass,
        Self::LoadMass,
        Self::InputDiameter,
        Self::OutputDiameter,
        Self::ExternalForce,
        Self::FrictionForce,
        Self::OutputTorque,
        Self::InputPulleyInertia,
        Self::OutputPulleyInertia,
        Self::RotaryLoadInertia,
        Self::IdlerInertia,
        Self::Acceleration,
        Self::IdlerDiameter,
        Self::OwnInertia,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 14] = &[
        Symbol {
            name: "M_belt",
            symbol: "M_b",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of the belt",
            source: "",
        },
        Symbol {
            name: "M_load",
            symbol: "M_l",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass that the belt moves in a straight line",
            source: "",
        },
        Symbol {
            name: "D_in",
            symbol: "D_in",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "diameter of the input pulley",
            source: "",
        },
        Symbol {
            name: "D_out",
            symbol: "D_out",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "diameter of the output pulley",
            source: "",
        },
        Symbol {
            name: "F",
            symbol: "F",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "external force on the belt, against its motion",
            source: "",
        },
        Symbol {
            name: "F_f",
            symbol: "F_f",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "friction force on the linear load",
            source: "",
        },
        Symbol {
            name: "T_out",
            symbol: "T_out",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that the application takes from the output pulley",
            source: "",
        },
        Symbol {
            name: "I_p1",
            symbol: "I_p1",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of the input pulley",
            source: "",
        },
        Symbol {
            name: "I_p2",
            symbol: "I_p2",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of the output pulley",
            source: "",
        },
        Symbol {
            name: "I_RL",
            symbol: "I_RL",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of the rotary load on the output pulley",
            source: "",
        },
        Symbol {
            name: "I_idlers",
            symbol: "I_i",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of all idlers as seen at the input",
            source: "",
        },
        Symbol {
            name: "alpha",
            symbol: "dω/dt",
            unit: "rad/s²",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -2,
                angle: 1,
            },
            doc: "angular acceleration of the input",
            source: "",
        },
        Symbol {
            name: "D",
            symbol: "D",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "diameter of an idler",
            source: "",
        },
        Symbol {
            name: "I_idler",
            symbol: "I",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of an idler",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for DriveSizingInput {
    const COUNT: usize = 14;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum DriveSizingOutput {
    /// diameter of the output over that of the input pulley, n (3.25); (3.25)
    Ratio,
    /// inertia of belt and linear load at the input, I_L (3.22), kg·m²; (3.22)
    LoadInertia,
    /// inertia of all that rotates at the input, I_p (3.21), kg·m²; (3.21), (3.27)
    RotatingInertia,
    /// inertia at the input, I_tot (3.21), (3.27), kg·m²; (3.21), (3.27)
    TotalInertia,
    /// torque of the external force at the input, T_ext (3.23), N·m; (3.23)
    ExternalTorque,
    /// torque of the friction force at the input, T_f (3.24), N·m; (3.24)
    FrictionTorque,
    /// torque that the load torque takes at the input, T_i (3.26), N·m; (3.26)
    InputTorque,
    /// torque at the input at constant speed, N·m; 3.3
    SteadyTorque,
    /// torque at the input that accelerates the inertia, N·m; 3.3
    AccelerationTorque,
    /// torque at the input, all together, N·m; 3.3
    DriveTorque,
}
impl DriveSizingOutput {
    /// All of them, in order.
    pub const ALL: [Self; 10] = [
        Self::Ratio,
        Self::LoadInertia,
        Self::RotatingInertia,
        Self::TotalInertia,
        Self::ExternalTorque,
        Self::FrictionTorque,
        Self::InputTorque,
        Self::SteadyTorque,
        Self::AccelerationTorque,
        Self::DriveTorque,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 10] = &[
        Symbol {
            name: "ratio",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "diameter of the output over that of the input pulley, n (3.25)",
            source: "(3.25)",
        },
        Symbol {
            name: "load_inertia",
            symbol: "",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of belt and linear load at the input, I_L (3.22)",
            source: "(3.22)",
        },
        Symbol {
            name: "rotating_inertia",
            symbol: "",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of all that rotates at the input, I_p (3.21)",
            source: "(3.21), (3.27)",
        },
        Symbol {
            name: "total_inertia",
            symbol: "",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia at the input, I_tot (3.21), (3.27)",
            source: "(3.21), (3.27)",
        },
        Symbol {
            name: "external_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the external force at the input, T_ext (3.23)",
            source: "(3.23)",
        },
        Symbol {
            name: "friction_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the friction force at the input, T_f (3.24)",
            source: "(3.24)",
        },
        Symbol {
            name: "input_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that the load torque takes at the input, T_i (3.26)",
            source: "(3.26)",
        },
        Symbol {
            name: "steady_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque at the input at constant speed",
            source: "3.3",
        },
        Symbol {
            name: "acceleration_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque at the input that accelerates the inertia",
            source: "3.3",
        },
        Symbol {
            name: "drive_torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque at the input, all together",
            source: "3.3",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for DriveSizingOutput {
    const COUNT: usize = 10;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum DriveSizingIdlerOutput {
    /// inertia of an idler as seen at the input, kg·m²; (3.21)
    ReflectedInertia,
}
impl DriveSizingIdlerOutput {
    /// All of them, in order.
    pub const ALL: [Self; 1] = [Self::ReflectedInertia];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 1] = &[
        Symbol {
            name: "reflected_inertia",
            symbol: "",
            unit: "kg·m²",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "inertia of an idler as seen at the input",
            source: "(3.21)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for DriveSizingIdlerOutput {
    const COUNT: usize = 1;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightTableInput {
    /// N: number of flyweights
    Count,
    /// m: mass of one flyweight, kg
    Mass,
    /// ω: speed of the pulley that carries the flyweights, rad/s
    Speed,
    /// C: r dr/ds of a flyweight, measured or from its mechanism; r sin θ of a bench, m
    Coefficient,
    /// f: share of the force that friction takes, negative where the sheave opens
    Lost,
}
impl FlyweightTableInput {
    /// All of them, in order.
    pub const ALL: [Self; 5] = [
        Self::Count,
        Self::Mass,
        Self::Speed,
        Self::Coefficient,
        Self::Lost,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 5] = &[
        Symbol {
            name: "N",
            symbol: "N",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "number of flyweights",
            source: "",
        },
        Symbol {
            name: "m",
            symbol: "m",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of one flyweight",
            source: "",
        },
        Symbol {
            name: "omega",
            symbol: "ω",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the pulley that carries the flyweights",
            source: "",
        },
        Symbol {
            name: "C",
            symbol: "C",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "r dr/ds of a flyweight, measured or from its mechanism; r sin θ of a bench",
            source: "",
        },
        Symbol {
            name: "lost",
            symbol: "f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "share of the force that friction takes, negative where the sheave opens",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightTableInput {
    const COUNT: usize = 5;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightTableOutput {
    /// F_fly: axial force of all flyweights on the movable sheave, N; (9.2)
    Force,
}
impl FlyweightTableOutput {
    /// All of them, in order.
    pub const ALL: [Self; 1] = [Self::Force];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 1] = &[
        Symbol {
            name: "force",
            symbol: "F_fly",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force of all flyweights on the movable sheave",
            source: "(9.2)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightTableOutput {
    const COUNT: usize = 1;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightRampInput {
    /// N: number of flyweights
    Count,
    /// m: mass of one flyweight, kg
    Mass,
    /// ω: speed of the pulley that carries the flyweights, rad/s
    Speed,
    /// r: radius of a flyweight's centre of mass, m
    Radius,
    /// dr/ds: slope of that radius over the sheave's travel: 1/tan λ of a ramp inclined by λ against the radius
    RadiusSlope,
    /// ρ: friction angle of the contact, negative where the sheave opens, rad
    FrictionAngle,
}
impl FlyweightRampInput {
    /// All of them, in order.
    pub const ALL: [Self; 6] = [
        Self::Count,
        Self::Mass,
        Self::Speed,
        Self::Radius,
        Self::RadiusSlope,
        Self::FrictionAngle,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 6] = &[
        Symbol {
            name: "N",
            symbol: "N",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "number of flyweights",
            source: "",
        },
        Symbol {
            name: "m",
            symbol: "m",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of one flyweight",
            source: "",
        },
        Symbol {
            name: "omega",
            symbol: "ω",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the pulley that carries the flyweights",
            source: "",
        },
        Symbol {
            name: "r",
            symbol: "r",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of a flyweight's centre of mass",
            source: "",
        },
        Symbol {
            name: "r_s",
            symbol: "dr/ds",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "slope of that radius over the sheave's travel: 1/tan λ of a ramp inclined by λ against the radius",
            source: "",
        },
        Symbol {
            name: "rho",
            symbol: "ρ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "friction angle of the contact, negative where the sheave opens",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightRampInput {
    const COUNT: usize = 6;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightRampOutput {
    /// F_fly: axial force of all flyweights on the movable sheave, N; balance on the ramp
    Force,
}
impl FlyweightRampOutput {
    /// All of them, in order.
    pub const ALL: [Self; 1] = [Self::Force];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 1] = &[
        Symbol {
            name: "force",
            symbol: "F_fly",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force of all flyweights on the movable sheave",
            source: "balance on the ramp",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightRampOutput {
    const COUNT: usize = 1;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightArmInput {
    /// N: number of flyweights
    Count,
    /// m: mass of one flyweight, kg
    Mass,
    /// ω: speed of the pulley that carries the flyweights, rad/s
    Speed,
    /// s: travel of the movable sheave, positive where it closes, m
    Travel,
    /// z_0: axial distance from the arm's pivot to the roller's centre at s = 0, m
    Start,
    /// R_p: radius of the arm's pivot from the shaft, m
    PivotRadius,
    /// R_r: radius of the roller's centre from the shaft, m
    RollerRadius,
    /// l_m: distance of the arm's centre of mass from its pivot, m
    MassDistance,
    /// δ: angle of the centre of mass in the arm, rad
    MassAngle,
    /// ξ: angle of the roller's centre in the arm at its present distance from the pivot: the cam's pitch curve, rad
    PitchAngle,
    /// dξ/dd: slope of the pitch curve over the distance, rad/m
    PitchSlope,
    /// ρ: friction angle of the contact, negative where the sheave opens, rad
    FrictionAngle,
}
impl FlyweightArmInput {
    /// All of them, in order.
    pub const ALL: [Self; 12] = [
        Self::Count,
        Self::Mass,
        Self::Speed,
        Self::Travel,
        Self::Start,
        Self::PivotRadius,
        Self::RollerRadius,
        Self::MassDistance,
        Self::MassAngle,
        Self::PitchAngle,
        Self::PitchSlope,
        Self::FrictionAngle,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 12] = &[
        Symbol {
            name: "N",
            symbol: "N",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "number of flyweights",
            source: "",
        },
        Symbol {
            name: "m",
            symbol: "m",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of one flyweight",
            source: "",
        },
        Symbol {
            name: "omega",
            symbol: "ω",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the pulley that carries the flyweights",
            source: "",
        },
        Symbol {
            name: "s",
            symbol: "s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "travel of the movable sheave, positive where it closes",
            source: "",
        },
        Symbol {
            name: "z_0",
            symbol: "z_0",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "axial distance from the arm's pivot to the roller's centre at s = 0",
            source: "",
        },
        Symbol {
            name: "R_pivot",
            symbol: "R_p",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the arm's pivot from the shaft",
            source: "",
        },
        Symbol {
            name: "R_roller",
            symbol: "R_r",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the roller's centre from the shaft",
            source: "",
        },
        Symbol {
            name: "l_m",
            symbol: "l_m",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance of the arm's centre of mass from its pivot",
            source: "",
        },
        Symbol {
            name: "delta",
            symbol: "δ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle of the centre of mass in the arm",
            source: "",
        },
        Symbol {
            name: "xi",
            symbol: "ξ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle of the roller's centre in the arm at its present distance from the pivot: the cam's pitch curve",
            source: "",
        },
        Symbol {
            name: "xi_d",
            symbol: "dξ/dd",
            unit: "rad/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "slope of the pitch curve over the distance",
            source: "",
        },
        Symbol {
            name: "rho",
            symbol: "ρ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "friction angle of the contact, negative where the sheave opens",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightArmInput {
    const COUNT: usize = 12;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightArmOutput {
    /// F_fly: axial force of all flyweights on the movable sheave, N; virtual work
    Force,
    /// d: distance from the pivot to the roller's centre, at which the pitch curve is to be read, m; kinematics
    Distance,
    /// dd/ds: its slope over the travel; kinematics
    DistanceSlope,
    /// r_m: radius of the centre of mass from the shaft, m; kinematics
    Radius,
    /// dr_m/ds: its slope over the travel without friction; kinematics
    RadiusSlope,
    /// M_c: moment of the centrifugal forces about the pivots, N·m; centrifugal moment
    Moment,
}
impl FlyweightArmOutput {
    /// All of them, in order.
    pub const ALL: [Self; 6] = [
        Self::Force,
        Self::Distance,
        Self::DistanceSlope,
        Self::Radius,
        Self::RadiusSlope,
        Self::Moment,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 6] = &[
        Symbol {
            name: "force",
            symbol: "F_fly",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force of all flyweights on the movable sheave",
            source: "virtual work",
        },
        Symbol {
            name: "distance",
            symbol: "d",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance from the pivot to the roller's centre, at which the pitch curve is to be read",
            source: "kinematics",
        },
        Symbol {
            name: "distance_s",
            symbol: "dd/ds",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "its slope over the travel",
            source: "kinematics",
        },
        Symbol {
            name: "radius",
            symbol: "r_m",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the centre of mass from the shaft",
            source: "kinematics",
        },
        Symbol {
            name: "radius_s",
            symbol: "dr_m/ds",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "its slope over the travel without friction",
            source: "kinematics",
        },
        Symbol {
            name: "moment",
            symbol: "M_c",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "moment of the centrifugal forces about the pivots",
            source: "centrifugal moment",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightArmOutput {
    const COUNT: usize = 6;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightRollerInput {
    /// N: number of flyweights
    Count,
    /// m: mass of one flyweight, kg
    Mass,
    /// ω: speed of the pulley that carries the flyweights, rad/s
    Speed,
    /// θ: angle of the arm from the shaft's axis outwards, pivot to roller, rad
    ArmAngle,
    /// R_p: radius of the arm's pivot from the shaft, m
    PivotRadius,
    /// l_r: distance of the roller's centre from the pivot, m
    ArmLength,
    /// l_m: distance of the arm's centre of mass from its pivot, m
    MassDistance,
    /// δ: angle from the line to the roller to that to the centre of mass, rad
    MassAngle,
    /// h: radius from the shaft to which the ramp lets the roller's centre, where the roller is, m
    RampRadius,
    /// dh/dx: slope of that radius along the ramp
    RampSlope,
    /// ρ: friction angle of the contact, negative where the sheave opens, rad
    FrictionAngle,
}
impl FlyweightRollerInput {
    /// All of them, in order.
    pub const ALL: [Self; 11] = [
        Self::Count,
        Self::Mass,
        Self::Speed,
        Self::ArmAngle,
        Self::PivotRadius,
        Self::ArmLength,
        Self::MassDistance,
        Self::MassAngle,
        Self::RampRadius,
        Self::RampSlope,
        Self::FrictionAngle,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 11] = &[
        Symbol {
            name: "N",
            symbol: "N",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "number of flyweights",
            source: "",
        },
        Symbol {
            name: "m",
            symbol: "m",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of one flyweight",
            source: "",
        },
        Symbol {
            name: "omega",
            symbol: "ω",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the pulley that carries the flyweights",
            source: "",
        },
        Symbol {
            name: "theta",
            symbol: "θ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle of the arm from the shaft's axis outwards, pivot to roller",
            source: "",
        },
        Symbol {
            name: "R_pivot",
            symbol: "R_p",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the arm's pivot from the shaft",
            source: "",
        },
        Symbol {
            name: "l_roller",
            symbol: "l_r",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance of the roller's centre from the pivot",
            source: "",
        },
        Symbol {
            name: "l_m",
            symbol: "l_m",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance of the arm's centre of mass from its pivot",
            source: "",
        },
        Symbol {
            name: "delta",
            symbol: "δ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle from the line to the roller to that to the centre of mass",
            source: "",
        },
        Symbol {
            name: "h",
            symbol: "h",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius from the shaft to which the ramp lets the roller's centre, where the roller is",
            source: "",
        },
        Symbol {
            name: "h_x",
            symbol: "dh/dx",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "slope of that radius along the ramp",
            source: "",
        },
        Symbol {
            name: "rho",
            symbol: "ρ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "friction angle of the contact, negative where the sheave opens",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightRollerInput {
    const COUNT: usize = 11;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum FlyweightRollerOutput {
    /// F_fly: axial force of all flyweights on the movable sheave, N; virtual work
    Force,
    /// radius that the roller's centre has beyond the ramp: zero where it bears on it, m; contact
    Gap,
    /// how far the roller's centre lies from the pivot along the shaft, m; kinematics
    Along,
    /// dθ/ds: turn of the arm over the travel, without friction, rad/m; contact
    AngleSlope,
    /// r_m: radius of the centre of mass from the shaft, m; kinematics
    Radius,
    /// dr_m/ds: its slope over the travel without friction; kinematics
    RadiusSlope,
    /// M_c: moment of the centrifugal forces about the pivots, N·m; centrifugal moment
    Moment,
}
impl FlyweightRollerOutput {
    /// All of them, in order.
    pub const ALL: [Self; 7] = [
        Self::Force,
        Self::Gap,
        Self::Along,
        Self::AngleSlope,
        Self::Radius,
        Self::RadiusSlope,
        Self::Moment,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 7] = &[
        Symbol {
            name: "force",
            symbol: "F_fly",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force of all flyweights on the movable sheave",
            source: "virtual work",
        },
        Symbol {
            name: "gap",
            symbol: "",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius that the roller's centre has beyond the ramp: zero where it bears on it",
            source: "contact",
        },
        Symbol {
            name: "along",
            symbol: "",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "how far the roller's centre lies from the pivot along the shaft",
            source: "kinematics",
        },
        Symbol {
            name: "theta_s",
            symbol: "dθ/ds",
            unit: "rad/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "turn of the arm over the travel, without friction",
            source: "contact",
        },
        Symbol {
            name: "radius",
            symbol: "r_m",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the centre of mass from the shaft",
            source: "kinematics",
        },
        Symbol {
            name: "radius_s",
            symbol: "dr_m/ds",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "its slope over the travel without friction",
            source: "kinematics",
        },
        Symbol {
            name: "moment",
            symbol: "M_c",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "moment of the centrifugal forces about the pivots",
            source: "centrifugal moment",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for FlyweightRollerOutput {
    const COUNT: usize = 7;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum CompressionSpringInput {
    /// F_0: force of the spring at s = 0, N
    Preload,
    /// c: rate of the spring, N/m
    Rate,
    /// s: travel by which the spring is compressed further, m
    Travel,
}
impl CompressionSpringInput {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::Preload, Self::Rate, Self::Travel];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 3] = &[
        Symbol {
            name: "F_0",
            symbol: "F_0",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "force of the spring at s = 0",
            source: "",
        },
        Symbol {
            name: "c",
            symbol: "c",
            unit: "N/m",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "rate of the spring",
            source: "",
        },
        Symbol {
            name: "s",
            symbol: "s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "travel by which the spring is compressed further",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for CompressionSpringInput {
    const COUNT: usize = 3;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum CompressionSpringOutput {
    /// F_spring: force of the spring, N; (9.3)
    Force,
    /// energy taken since s = 0, N·m; energy
    Energy,
}
impl CompressionSpringOutput {
    /// All of them, in order.
    pub const ALL: [Self; 2] = [Self::Force, Self::Energy];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 2] = &[
        Symbol {
            name: "force",
            symbol: "F_spring",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "force of the spring",
            source: "(9.3)",
        },
        Symbol {
            name: "energy",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "energy taken since s = 0",
            source: "energy",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for CompressionSpringOutput {
    const COUNT: usize = 2;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HelixInput {
    /// κ_t: rate of the spring in torsion, N·m/rad
    TorsionRate,
    /// φ_0: angle by which the spring is wound up when installed, rad
    Pretension,
    /// φ: angle by which the movable sheave has turned on its helix, rad
    Turn,
    /// r_h: radius of the helix, m
    Radius,
    /// tan α: tangent of the helix angle, measured from the plane of rotation
    Tangent,
    /// ζ: share of the torque that the movable sheave carries
    Share,
    /// M: torque of the belt on the secondary, N·m
    Torque,
    /// ρ: friction angle of the contact, negative where the sheave opens, rad
    FrictionAngle,
}
impl HelixInput {
    /// All of them, in order.
    pub const ALL: [Self; 8] = [
        Self::TorsionRate,
        Self::Pretension,
        Self::Turn,
        Self::Radius,
        Self::Tangent,
        Self::Share,
        Self::Torque,
        Self::FrictionAngle,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 8] = &[
        Symbol {
            name: "kappa",
            symbol: "κ_t",
            unit: "N·m/rad",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: -1,
            },
            doc: "rate of the spring in torsion",
            source: "",
        },
        Symbol {
            name: "phi_0",
            symbol: "φ_0",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle by which the spring is wound up when installed",
            source: "",
        },
        Symbol {
            name: "phi",
            symbol: "φ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "angle by which the movable sheave has turned on its helix",
            source: "",
        },
        Symbol {
            name: "r_h",
            symbol: "r_h",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the helix",
            source: "",
        },
        Symbol {
            name: "tan_alpha",
            symbol: "tan α",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "tangent of the helix angle, measured from the plane of rotation",
            source: "",
        },
        Symbol {
            name: "share",
            symbol: "ζ",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "share of the torque that the movable sheave carries",
            source: "",
        },
        Symbol {
            name: "M",
            symbol: "M",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of the belt on the secondary",
            source: "",
        },
        Symbol {
            name: "rho",
            symbol: "ρ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "friction angle of the contact, negative where the sheave opens",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HelixInput {
    const COUNT: usize = 8;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HelixOutput {
    /// T_h: torque that the helix carries, N·m; moments on the movable sheave
    Torque,
    /// F_helix: axial force of the helix on the movable sheave, positive where it closes, N; balance on the helix
    Force,
    /// dφ/ds: turn of the movable sheave over its travel, rad/m; kinematics
    TurnSlope,
}
impl HelixOutput {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::Torque, Self::Force, Self::TurnSlope];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 3] = &[
        Symbol {
            name: "torque",
            symbol: "T_h",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that the helix carries",
            source: "moments on the movable sheave",
        },
        Symbol {
            name: "force",
            symbol: "F_helix",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force of the helix on the movable sheave, positive where it closes",
            source: "balance on the helix",
        },
        Symbol {
            name: "turn",
            symbol: "dφ/ds",
            unit: "rad/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "turn of the movable sheave over its travel",
            source: "kinematics",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HelixOutput {
    const COUNT: usize = 3;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SheaveTravelInput {
    /// β: half angle of the groove, rad
    HalfAngle,
    /// R: radius of the belt on the pulley, m
    Radius,
    /// R_0: radius of the belt where the travel is zero, m
    Start,
}
impl SheaveTravelInput {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::HalfAngle, Self::Radius, Self::Start];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 3] = &[
        Symbol {
            name: "beta",
            symbol: "β",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half angle of the groove",
            source: "",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the belt on the pulley",
            source: "",
        },
        Symbol {
            name: "R_0",
            symbol: "R_0",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radius of the belt where the travel is zero",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for SheaveTravelInput {
    const COUNT: usize = 3;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SheaveTravelOutput {
    /// s: axial travel of the movable sheave, positive where it closes, m; (9.2)
    Travel,
}
impl SheaveTravelOutput {
    /// All of them, in order.
    pub const ALL: [Self; 1] = [Self::Travel];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 1] = &[
        Symbol {
            name: "travel",
            symbol: "s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "axial travel of the movable sheave, positive where it closes",
            source: "(9.2)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for SheaveTravelOutput {
    const COUNT: usize = 1;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum VehicleLoadInput {
    /// ω_S: speed of the secondary, rad/s
    SecondarySpeed,
    /// i_f: turns of the secondary for a turn of the wheel
    FinalRatio,
    /// r_w: rolling radius of the wheel, m
    WheelRadius,
    /// m_v: mass of the vehicle with its driver, kg
    Mass,
    /// g: acceleration of gravity, m/s²
    Gravity,
    /// c_r: coefficient of rolling resistance
    RollingResistance,
    /// tan α_g: grade of the ground, rise over run
    Grade,
    /// ρ_air: density of the air, kg/m³
    AirDensity,
    /// C_d A: drag area, m²
    DragArea,
    /// η_f: efficiency of the final drive
    FinalEfficiency,
    /// a: acceleration of the vehicle, m/s²
    Acceleration,
}
impl VehicleLoadInput {
    /// All of them, in order.
    pub const ALL: [Self; 11] = [
        Self::SecondarySpeed,
        Self::FinalRatio,
        Self::WheelRadius,
        Self::Mass,
        Self::Gravity,
        Self::RollingResistance,
        Self::Grade,
        Self::AirDensity,
        Self::DragArea,
        Self::FinalEfficiency,
        Self::Acceleration,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 11] = &[
        Symbol {
            name: "omega_S",
            symbol: "ω_S",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the secondary",
            source: "",
        },
        Symbol {
            name: "i_f",
            symbol: "i_f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "turns of the secondary for a turn of the wheel",
            source: "",
        },
        Symbol {
            name: "r_w",
            symbol: "r_w",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "rolling radius of the wheel",
            source: "",
        },
        Symbol {
            name: "m_v",
            symbol: "m_v",
            unit: "kg",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass of the vehicle with its driver",
            source: "",
        },
        Symbol {
            name: "g_0",
            symbol: "g",
            unit: "m/s²",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -2,
                angle: 0,
            },
            doc: "acceleration of gravity",
            source: "",
        },
        Symbol {
            name: "c_r",
            symbol: "c_r",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "coefficient of rolling resistance",
            source: "",
        },
        Symbol {
            name: "tan_slope",
            symbol: "tan α_g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "grade of the ground, rise over run",
            source: "",
        },
        Symbol {
            name: "rho_air",
            symbol: "ρ_air",
            unit: "kg/m³",
            dimension: Dimension {
                length: -3,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "density of the air",
            source: "",
        },
        Symbol {
            name: "CdA",
            symbol: "C_d A",
            unit: "m²",
            dimension: Dimension {
                length: 2,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "drag area",
            source: "",
        },
        Symbol {
            name: "eta_f",
            symbol: "η_f",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "efficiency of the final drive",
            source: "",
        },
        Symbol {
            name: "a",
            symbol: "a",
            unit: "m/s²",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -2,
                angle: 0,
            },
            doc: "acceleration of the vehicle",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for VehicleLoadInput {
    const COUNT: usize = 11;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum VehicleLoadOutput {
    /// v: speed of the vehicle, m/s; kinematics
    Speed,
    /// force of rolling, grade and air against the vehicle, N; resistance
    Resistance,
    /// torque that the vehicle takes from the secondary, N·m; power
    Torque,
    /// change of that torque with acceleration, kg·m; power
    TorquePerAcceleration,
}
impl VehicleLoadOutput {
    /// All of them, in order.
    pub const ALL: [Self; 4] = [
        Self::Speed,
        Self::Resistance,
        Self::Torque,
        Self::TorquePerAcceleration,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 4] = &[
        Symbol {
            name: "speed",
            symbol: "v",
            unit: "m/s",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "speed of the vehicle",
            source: "kinematics",
        },
        Symbol {
            name: "resistance",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "force of rolling, grade and air against the vehicle",
            source: "resistance",
        },
        Symbol {
            name: "torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that the vehicle takes from the secondary",
            source: "power",
        },
        Symbol {
            name: "torque_a",
            symbol: "",
            unit: "kg·m",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "change of that torque with acceleration",
            source: "power",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for VehicleLoadOutput {
    const COUNT: usize = 4;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisContactInput {
    /// T: tractive tension, N
    T,
    /// θ: inclination of the belt, rad
    Theta,
    /// θ̂': first derivative of θ along the region, rad
    Theta1,
    /// θ̂'': second derivative of θ along the region, rad
    Theta2,
    /// x: radial penetration, m
    X,
    /// T̂': derivative of T along the region, N
    THat1,
    /// Φ: wrap angle, rad
    Phi,
    /// R: nominal radius of the pulley, m
    R,
    /// g: mass flow over that of an unstretched belt at the primary's nominal speed
    Flow,
    /// EA: longitudinal stiffness, N
    EA,
    /// m_o: mass per length, unloaded, kg/m
    MO,
    /// R_P: nominal radius of the primary, m
    RP,
    /// ω_P: angular speed of the primary, rad/s
    OmegaP,
}
impl HysteresisContactInput {
    /// All of them, in order.
    pub const ALL: [Self; 13] = [
        Self::T,
        Self::Theta,
        Self::Theta1,
        Self::Theta2,
        Self::X,
        Self::THat1,
        Self::Phi,
        Self::R,
        Self::Flow,
        Self::EA,
        Self::MO,
        Self::RP,
        Self::OmegaP,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 13] = &[
        Symbol {
            name: "T",
            symbol: "T",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension",
            source: "",
        },
        Symbol {
            name: "theta",
            symbol: "θ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt",
            source: "",
        },
        Symbol {
            name: "theta1",
            symbol: "θ\u{302}'",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region",
            source: "",
        },
        Symbol {
            name: "theta2",
            symbol: "θ\u{302}''",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region",
            source: "",
        },
        Symbol {
            name: "x",
            symbol: "x",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration",
            source: "",
        },
        Symbol {
            name: "T_hat_1",
            symbol: "T\u{302}'",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "derivative of T along the region",
            source: "",
        },
        Symbol {
            name: "Phi",
            symbol: "Φ",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "wrap angle",
            source: "",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the pulley",
            source: "",
        },
        Symbol {
            name: "flow",
            symbol: "g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mass flow over that of an unstretched belt at the primary's nominal speed",
            source: "",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness",
            source: "",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length, unloaded",
            source: "",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the primary",
            source: "",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "angular speed of the primary",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisContactInput {
    const COUNT: usize = 13;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisContactOutput {
    /// dS/dŝ: unstretched length passed along the region, m; (5.55)
    Material,
    /// κ: curvature of the belt, M_b/EI, rad/m; (3.26)
    Curvature,
    /// dκ/dS: its slope along the unstretched belt, rad/m²; (3.26), (3.9)
    CurvatureSlope,
    /// ε: strain of the cord, F/EA; (3.9)
    Strain,
    /// dε/dS: its slope along the unstretched belt, 1/m; (3.9), (3.10)
    StrainSlope,
    /// dx/dS: slope of the penetration along the unstretched belt; (3.24), (3.9)
    PenetrationSlope,
}
impl HysteresisContactOutput {
    /// All of them, in order.
    pub const ALL: [Self; 6] = [
        Self::Material,
        Self::Curvature,
        Self::CurvatureSlope,
        Self::Strain,
        Self::StrainSlope,
        Self::PenetrationSlope,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 6] = &[
        Symbol {
            name: "material",
            symbol: "dS/dŝ",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length passed along the region",
            source: "(5.55)",
        },
        Symbol {
            name: "curvature",
            symbol: "κ",
            unit: "rad/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "curvature of the belt, M_b/EI",
            source: "(3.26)",
        },
        Symbol {
            name: "curvature_slope",
            symbol: "dκ/dS",
            unit: "rad/m²",
            dimension: Dimension {
                length: -2,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "its slope along the unstretched belt",
            source: "(3.26), (3.9)",
        },
        Symbol {
            name: "strain",
            symbol: "ε",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "strain of the cord, F/EA",
            source: "(3.9)",
        },
        Symbol {
            name: "strain_slope",
            symbol: "dε/dS",
            unit: "1/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "its slope along the unstretched belt",
            source: "(3.9), (3.10)",
        },
        Symbol {
            name: "penetration_slope",
            symbol: "dx/dS",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "slope of the penetration along the unstretched belt",
            source: "(3.24), (3.9)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisContactOutput {
    const COUNT: usize = 6;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisSpanInput {
    /// τ: tractive tension, N
    Tau,
    /// ϑ̂': first derivative of ϑ along the span, rad
    Vartheta1,
    /// ϑ̂'': second derivative of ϑ along the span, rad
    Vartheta2,
    /// τ̂': derivative of τ along the span, N
    TauHat1,
    /// L: arc length of the span, m
    L,
    /// g: mass flow over that of an unstretched belt at the primary's nominal speed
    Flow,
    /// EA: longitudinal stiffness, N
    EA,
    /// m_o: mass per length, unloaded, kg/m
    MO,
    /// R_P: nominal radius of the primary, m
    RP,
    /// ω_P: angular speed of the primary, rad/s
    OmegaP,
}
impl HysteresisSpanInput {
    /// All of them, in order.
    pub const ALL: [Self; 10] = [
        Self::Tau,
        Self::Vartheta1,
        Self::Vartheta2,
        Self::TauHat1,
        Self::L,
        Self::Flow,
        Self::EA,
        Self::MO,
        Self::RP,
        Self::OmegaP,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 10] = &[
        Symbol {
            name: "tau",
            symbol: "τ",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension",
            source: "",
        },
        Symbol {
            name: "vartheta1",
            symbol: "ϑ\u{302}'",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span",
            source: "",
        },
        Symbol {
            name: "vartheta2",
            symbol: "ϑ\u{302}''",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span",
            source: "",
        },
        Symbol {
            name: "tau_hat_1",
            symbol: "τ\u{302}'",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "derivative of τ along the span",
            source: "",
        },
        Symbol {
            name: "L",
            symbol: "L",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "arc length of the span",
            source: "",
        },
        Symbol {
            name: "flow",
            symbol: "g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mass flow over that of an unstretched belt at the primary's nominal speed",
            source: "",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness",
            source: "",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length, unloaded",
            source: "",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the primary",
            source: "",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "angular speed of the primary",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisSpanInput {
    const COUNT: usize = 10;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisSpanOutput {
    /// dS/dŝ: unstretched length passed along the region, m; (5.56)
    Material,
    /// κ: curvature of the belt, M_b/EI, rad/m; (5.10)
    Curvature,
    /// dκ/dS: its slope along the unstretched belt, rad/m²; (5.11), (3.9)
    CurvatureSlope,
    /// ε: strain of the cord, F/EA; (3.9)
    Strain,
    /// dε/dS: its slope along the unstretched belt, 1/m; (3.9), (3.10)
    StrainSlope,
}
impl HysteresisSpanOutput {
    /// All of them, in order.
    pub const ALL: [Self; 5] = [
        Self::Material,
        Self::Curvature,
        Self::CurvatureSlope,
        Self::Strain,
        Self::StrainSlope,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 5] = &[
        Symbol {
            name: "material",
            symbol: "dS/dŝ",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length passed along the region",
            source: "(5.56)",
        },
        Symbol {
            name: "curvature",
            symbol: "κ",
            unit: "rad/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "curvature of the belt, M_b/EI",
            source: "(5.10)",
        },
        Symbol {
            name: "curvature_slope",
            symbol: "dκ/dS",
            unit: "rad/m²",
            dimension: Dimension {
                length: -2,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "its slope along the unstretched belt",
            source: "(5.11), (3.9)",
        },
        Symbol {
            name: "strain",
            symbol: "ε",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "strain of the cord, F/EA",
            source: "(3.9)",
        },
        Symbol {
            name: "strain_slope",
            symbol: "dε/dS",
            unit: "1/m",
            dimension: Dimension {
                length: -1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "its slope along the unstretched belt",
            source: "(3.9), (3.10)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisSpanOutput {
    const COUNT: usize = 5;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisInput {
    /// g: mass flow over that of an unstretched belt at the primary's nominal speed
    Flow,
    /// EA: longitudinal stiffness, N
    EA,
    /// m_o: mass per length, unloaded, kg/m
    MO,
    /// R_P: nominal radius of the primary, m
    RP,
    /// ω_P: angular speed of the primary, rad/s
    OmegaP,
    /// EI: bending stiffness, N·m²
    EI,
    /// k: radial stiffness, N/m²
    K,
    /// β: half angle of the sheave's groove, rad
    Beta,
    /// L_0: unstretched length of the loop, m
    L0,
}
impl HysteresisInput {
    /// All of them, in order.
    pub const ALL: [Self; 9] = [
        Self::Flow,
        Self::EA,
        Self::MO,
        Self::RP,
        Self::OmegaP,
        Self::EI,
        Self::K,
        Self::Beta,
        Self::L0,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 9] = &[
        Symbol {
            name: "flow",
            symbol: "g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "mass flow over that of an unstretched belt at the primary's nominal speed",
            source: "",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "longitudinal stiffness",
            source: "",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: 0,
                angle: 0,
            },
            doc: "mass per length, unloaded",
            source: "",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "nominal radius of the primary",
            source: "",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "angular speed of the primary",
            source: "",
        },
        Symbol {
            name: "EI",
            symbol: "EI",
            unit: "N·m²",
            dimension: Dimension {
                length: 3,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "bending stiffness",
            source: "",
        },
        Symbol {
            name: "k",
            symbol: "k",
            unit: "N/m²",
            dimension: Dimension {
                length: -1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "radial stiffness",
            source: "",
        },
        Symbol {
            name: "beta",
            symbol: "β",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "half angle of the sheave's groove",
            source: "",
        },
        Symbol {
            name: "L_0",
            symbol: "L_0",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the loop",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisInput {
    const COUNT: usize = 9;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum HysteresisOutput {
    /// f_1: revolutions of the belt a second, G/(m_o L_0), 1/s; (3.5)
    Revolutions,
    /// power that bending loses, over tan δ_n |B_n|²/n, B_n of the curvature, W·m²; (3.26)
    Bending,
    /// power that the groove's squeezing loses, over tan δ_n |B_n|²/n, B_n of the penetration, W/m²; (3.16)
    Groove,
    /// power that the cord's stretching loses, over tan δ_n |B_n|²/n, B_n of the strain, W; (3.9)
    Cord,
}
impl HysteresisOutput {
    /// All of them, in order.
    pub const ALL: [Self; 4] = [
        Self::Revolutions,
        Self::Bending,
        Self::Groove,
        Self::Cord,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 4] = &[
        Symbol {
            name: "revolutions",
            symbol: "f_1",
            unit: "1/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 0,
            },
            doc: "revolutions of the belt a second, G/(m_o L_0)",
            source: "(3.5)",
        },
        Symbol {
            name: "bending",
            symbol: "",
            unit: "W·m²",
            dimension: Dimension {
                length: 4,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that bending loses, over tan δ_n |B_n|²/n, B_n of the curvature",
            source: "(3.26)",
        },
        Symbol {
            name: "groove",
            symbol: "",
            unit: "W/m²",
            dimension: Dimension {
                length: 0,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that the groove's squeezing loses, over tan δ_n |B_n|²/n, B_n of the penetration",
            source: "(3.16)",
        },
        Symbol {
            name: "cord",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that the cord's stretching loses, over tan δ_n |B_n|²/n, B_n of the strain",
            source: "(3.9)",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for HysteresisOutput {
    const COUNT: usize = 4;
    fn place(self) -> usize {
        self as usize
    }
}
/// An input of a set of formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum LossBalanceInput {
    /// P_1: power that the driving pulley takes in, W
    Driving,
    /// η: power that the driven pulley gives, but for the losses here, over that which the driving one takes
    Overall,
    /// P_h: power that hysteresis takes, W
    Hysteresis,
    /// ω_P: speed of the primary, rad/s
    OmegaP,
    /// ω_S: speed of the secondary, rad/s
    OmegaS,
    /// M_dP: torque that drags at the primary at every speed, N·m
    DragP,
    /// M_dS: torque that drags at the secondary at every speed, N·m
    DragS,
    /// c_P: torque that drags at the primary, per speed, N·m·s
    ViscousP,
    /// c_S: torque that drags at the secondary, per speed, N·m·s
    ViscousS,
    /// η_g: efficiency of what stands between the secondary and the shaft of interest
    GearEfficiency,
}
impl LossBalanceInput {
    /// All of them, in order.
    pub const ALL: [Self; 10] = [
        Self::Driving,
        Self::Overall,
        Self::Hysteresis,
        Self::OmegaP,
        Self::OmegaS,
        Self::DragP,
        Self::DragS,
        Self::ViscousP,
        Self::ViscousS,
        Self::GearEfficiency,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 10] = &[
        Symbol {
            name: "driving",
            symbol: "P_1",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that the driving pulley takes in",
            source: "",
        },
        Symbol {
            name: "overall",
            symbol: "η",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "power that the driven pulley gives, but for the losses here, over that which the driving one takes",
            source: "",
        },
        Symbol {
            name: "hysteresis",
            symbol: "P_h",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that hysteresis takes",
            source: "",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the primary",
            source: "",
        },
        Symbol {
            name: "omega_S",
            symbol: "ω_S",
            unit: "rad/s",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: -1,
                angle: 1,
            },
            doc: "speed of the secondary",
            source: "",
        },
        Symbol {
            name: "drag_P",
            symbol: "M_dP",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that drags at the primary at every speed",
            source: "",
        },
        Symbol {
            name: "drag_S",
            symbol: "M_dS",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque that drags at the secondary at every speed",
            source: "",
        },
        Symbol {
            name: "viscous_P",
            symbol: "c_P",
            unit: "N·m·s",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -1,
                angle: 0,
            },
            doc: "torque that drags at the primary, per speed",
            source: "",
        },
        Symbol {
            name: "viscous_S",
            symbol: "c_S",
            unit: "N·m·s",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -1,
                angle: 0,
            },
            doc: "torque that drags at the secondary, per speed",
            source: "",
        },
        Symbol {
            name: "gear_efficiency",
            symbol: "η_g",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "efficiency of what stands between the secondary and the shaft of interest",
            source: "",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for LossBalanceInput {
    const COUNT: usize = 10;
    fn place(self) -> usize {
        self as usize
    }
}
/// What a set of formulae gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum LossBalanceOutput {
    /// power that drags at the primary, W; drag
    PrimaryDrag,
    /// power that drags at the secondary, W; drag
    SecondaryDrag,
    /// power lost between the secondary and the shaft of interest, W; gears
    Gears,
    /// power that hysteresis, drag and gears take, W; balance of power
    Total,
    /// power that arrives, W; balance of power
    Delivered,
    /// power that arrives over power that goes in; (6.9) with losses
    Efficiency,
}
impl LossBalanceOutput {
    /// All of them, in order.
    pub const ALL: [Self; 6] = [
        Self::PrimaryDrag,
        Self::SecondaryDrag,
        Self::Gears,
        Self::Total,
        Self::Delivered,
        Self::Efficiency,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 6] = &[
        Symbol {
            name: "primary_drag",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that drags at the primary",
            source: "drag",
        },
        Symbol {
            name: "secondary_drag",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that drags at the secondary",
            source: "drag",
        },
        Symbol {
            name: "gears",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost between the secondary and the shaft of interest",
            source: "gears",
        },
        Symbol {
            name: "total",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that hysteresis, drag and gears take",
            source: "balance of power",
        },
        Symbol {
            name: "delivered",
            symbol: "",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that arrives",
            source: "balance of power",
        },
        Symbol {
            name: "efficiency",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "power that arrives over power that goes in",
            source: "(6.9) with losses",
        },
    ];
    /// Its place in [`Self::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }
    /// What it is: name, printed symbol, unit, dimension, meaning and source.
    pub const fn symbol(self) -> &'static Symbol {
        &Self::SYMBOLS[self as usize]
    }
    /// Its name in tables and files.
    pub const fn name(self) -> &'static str {
        self.symbol().name
    }
}
impl Identity for LossBalanceOutput {
    const COUNT: usize = 6;
    fn place(self) -> usize {
        self as usize
    }
}
impl Output {
    /// The belts whose drives have this output.
    pub const fn theories(self) -> &'static [BeltTheory] {
        match self {
            Self::PrimarySpeed => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryTorque => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryPower => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryAxialForce => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryWrapAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryEntryAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryExitAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryOrientationAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryResultantX => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryResultantY => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryBindingMoment => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryFrictionLoss => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryEntryTension => &[BeltTheory::Beam, BeltTheory::String],
            Self::PrimaryExitTension => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondarySpeed => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryTorque => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryPower => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryAxialForce => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryWrapAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryEntryAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryExitAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryOrientationAngle => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryResultantX => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryResultantY => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryBindingMoment => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryFrictionLoss => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryEntryTension => &[BeltTheory::Beam, BeltTheory::String],
            Self::SecondaryExitTension => &[BeltTheory::Beam, BeltTheory::String],
            Self::TightSpanArcLength => &[BeltTheory::Beam, BeltTheory::String],
            Self::TightSpanUnstretchedLength => &[BeltTheory::Beam, BeltTheory::String],
            Self::SlackSpanArcLength => &[BeltTheory::Beam, BeltTheory::String],
            Self::SlackSpanUnstretchedLength => &[BeltTheory::Beam, BeltTheory::String],
            Self::EfficiencySpeed => &[BeltTheory::Beam, BeltTheory::String],
            Self::EfficiencyTorque => &[BeltTheory::Beam, BeltTheory::String],
            Self::EfficiencyOverall => &[BeltTheory::Beam, BeltTheory::String],
            Self::BeltMassFlow => &[BeltTheory::Beam, BeltTheory::String],
            Self::BeltUnstretchedLength => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyPowerIn => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyPowerOut => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyFrictionLoss => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyStretchWork => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyImbalance => &[BeltTheory::Beam, BeltTheory::String],
            Self::EnergyClosure => &[BeltTheory::Beam, BeltTheory::String],
        }
    }
}
