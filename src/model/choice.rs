//! Settings that are chosen from a list of names.

use serde::{Serialize, Serializer};

/// One name that may be chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// As written in the case file.
    pub name: &'static str,
    /// What choosing it means.
    pub doc: &'static str,
}

/// An enum whose variants have names in the case file; names and meanings are written once, here.
macro_rules! choices {
    ($(#[$outer:meta])* $type:ident { $($(#[doc = $doc:literal])+ $variant:ident = $name:literal,)+ }) => {
        $(#[$outer])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $type { $($(#[doc = $doc])+ $variant,)+ }

        impl $type {
            /// All names with their meaning.
            pub const CHOICES: &'static [Choice] =
                &[$(Choice { name: $name, doc: concat!($($doc),+).trim_ascii() }),+];

            /// Name in the case file.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }

            /// The variant with this name.
            pub fn from_name(name: &str) -> Option<Self> {
                match name { $($name => Some(Self::$variant),)+ _ => None }
            }
        }

        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(self.name())
            }
        }
    };
}

choices! {
    /// A set of modelling choices with a purpose.
    Edition {
        /// the thesis's printed code with its slips: reproduces its chapters 6 and 7
        Published = "published",
        /// the thesis's model done right: linearised shear, zero at the contact ends
        Thesis = "thesis",
        /// full shear, continuous at the contact ends: conserves energy, for design
        Consistent = "consistent",
        /// no bending stiffness, straight spans (Kong and Parker)
        String = "string",
    }
}

choices! {
    /// Form of the shear force in the contact regions.
    Shear {
        /// linear in inclination and penetration (3.38), (3.40)
        Linearised = "linearised",
        /// as it follows from the beam (3.34), (3.36)
        Full = "full",
    }
}

choices! {
    /// Shear force at the ends of the contact regions.
    Ends {
        /// none on the pulley's side
        Zero = "zero",
        /// that of the span: an elastic groove carries no point load
        Continuous = "continuous",
        /// none, with the slips of the printed code; goes with linearised shear only
        AsPrinted = "as-printed",
    }
}

choices! {
    /// Equations of the free spans.
    Spans {
        /// as they follow from the beam (3.43) to (3.48)
        Derived = "derived",
        /// with the square of the arc length on the wrong side, as in the printed code
        AsPrinted = "as-printed",
    }
}

choices! {
    /// Friction coefficient over sliding speed.
    Friction {
        /// proportional to the sliding speed up to the threshold, constant beyond
        ViscousCoulomb = "viscous-coulomb",
        /// a hyperbolic tangent of four times the sliding speed over the threshold
        Tanh = "tanh",
    }
}

choices! {
    /// Nominal radii that follow from unstretched belt length = `belt.length`.
    Free {
        /// the primary's radius
        PrimaryRadius = "primary_radius",
        /// the secondary's radius
        SecondaryRadius = "secondary_radius",
        /// both: a fourth key of the operating point closes the drive
        Both = "both",
    }
}

choices! {
    /// Whether losses besides friction are told.
    Include {
        /// hysteresis, drag and gears are taken off what arrives
        On = "on",
        /// friction is the only loss
        Off = "off",
    }
}

choices! {
    /// What presses the sheaves of the primary together.
    FlyweightKind {
        /// flyweights whose r dr/ds over the travel is known, as a bench measures it
        Table = "table",
        /// wedges or rollers that slide along a radius against a ramp
        Ramp = "ramp",
        /// pivoted arms with a roller at their end, on a ramp of the movable sheave
        Arm = "arm",
        /// pivoted arms with a cam, against rollers
        Cam = "cam",
        /// a force or a position, as a motor holds it
        Servo = "servo",
    }
}

choices! {
    /// What presses the sheaves of the secondary together.
    SecondaryKind {
        /// a helix that turns torque into axial force, and a spring
        Helix = "helix",
        /// a force, as a motor holds it
        Servo = "servo",
    }
}

choices! {
    /// From where helix angles are measured.
    HelixAngleFrom {
        /// from the plane of rotation: a helix of 90° would press with nothing
        Rotation = "rotation",
        /// from the shaft's axis: a helix of 0° would press with nothing
        Axis = "axis",
    }
}

/// What is computed: the edition's choices, or finer ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct ModelChoices {
    /// How the belt bends; `None` for a string.
    #[serde(flatten)]
    pub bending: Option<Bending>,
    /// Friction law.
    pub friction: Friction,
}

/// Choices that matter for a belt with bending stiffness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Bending {
    /// Form of the shear force in the contact regions.
    pub shear: Shear,
    /// Shear force at the ends of the contact regions.
    pub ends: Ends,
    /// Equations of the free spans.
    pub spans: Spans,
}

impl Edition {
    /// The model that the edition stands for.
    pub const fn model(self) -> ModelChoices {
        let bending = match self {
            Self::Published => {
                Some(Bending { shear: Shear::Linearised, ends: Ends::AsPrinted, spans: Spans::AsPrinted })
            }
            Self::Thesis => Some(Bending { shear: Shear::Linearised, ends: Ends::Zero, spans: Spans::Derived }),
            Self::Consistent => Some(Bending { shear: Shear::Full, ends: Ends::Continuous, spans: Spans::Derived }),
            Self::String => None,
        };
        ModelChoices { bending, friction: Friction::ViscousCoulomb }
    }
}
