// The enums by which callers of the kernels name quantities.
// Generated from eqgen/examples/elastica/equations.rs. Do not edit:
// `cargo run -p sheave-eqgen --example elastica_write` writes it anew.

/// A state of a region: what its differential equations are of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum State {
    /// θ: direction of the strut against the load, rad; Euler
    Direction,
    /// θ̂': dθ/dŝ, rad; Euler
    DirectionDerivative,
}
impl State {
    /// All of them, in order.
    pub const ALL: [Self; 2] = [Self::Direction, Self::DirectionDerivative];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 2] = &[
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
            doc: "direction of the strut against the load",
            source: "Euler",
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
            doc: "dθ/dŝ",
            source: "Euler",
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
    const COUNT: usize = 2;
    fn place(self) -> usize {
        self as usize
    }
}
/// A constant as a single region knows it; the drive's constants give it its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum RegionConstant {
    /// P: load along the line of the ends, N; Euler
    Load,
    /// L: length of the strut, m; Euler
    Length,
    /// EI: bending stiffness, N·m²; Euler
    BendingStiffness,
}
impl RegionConstant {
    /// All of them, in order.
    pub const ALL: [Self; 3] = [Self::Load, Self::Length, Self::BendingStiffness];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 3] = &[
        Symbol {
            name: "P",
            symbol: "P",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "load along the line of the ends",
            source: "Euler",
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
            doc: "length of the strut",
            source: "Euler",
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
            source: "Euler",
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
    const COUNT: usize = 3;
    fn place(self) -> usize {
        self as usize
    }
}
/// An integral along a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Integral {
    /// X̂: distance of the ends over L; Euler
    DistanceAlong,
    /// Ŷ: distance of the ends across the load over L; Euler
    DistanceAcross,
}
impl Integral {
    /// All of them, in order.
    pub const ALL: [Self; 2] = [Self::DistanceAlong, Self::DistanceAcross];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 2] = &[
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
            doc: "distance of the ends over L",
            source: "Euler",
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
            doc: "distance of the ends across the load over L",
            source: "Euler",
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
    const COUNT: usize = 2;
    fn place(self) -> usize {
        self as usize
    }
}
/// A quantity along a region that follows from its states and constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Field {
    /// M: bending moment, N·m; Euler
    BendingMoment,
}
impl Field {
    /// All of them, in order.
    pub const ALL: [Self; 1] = [Self::BendingMoment];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 1] = &[
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
            doc: "bending moment",
            source: "Euler",
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
    const COUNT: usize = 1;
    fn place(self) -> usize {
        self as usize
    }
}
/// A constant of the whole drive, given or unknown, in the order of every vector of constants.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Constant {
    /// P: load along the line of the ends, N; Euler
    Load,
    /// L: length of the strut, m; Euler
    Length,
    /// EI: bending stiffness, N·m²; Euler
    BendingStiffness,
    /// α: direction of the strut at its first end, rad; Euler
    EndDirection,
}
impl Constant {
    /// All of them, in order.
    pub const ALL: [Self; 4] = [
        Self::Load,
        Self::Length,
        Self::BendingStiffness,
        Self::EndDirection,
    ];
    /// What they are, in the same order.
    pub const SYMBOLS: &'static [Symbol; 4] = &[
        Symbol {
            name: "P",
            symbol: "P",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "load along the line of the ends",
            source: "Euler",
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
            doc: "length of the strut",
            source: "Euler",
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
            source: "Euler",
        },
        Symbol {
            name: "alpha",
            symbol: "α",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the strut at its first end",
            source: "Euler",
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
    const COUNT: usize = 4;
    fn place(self) -> usize {
        self as usize
    }
}
