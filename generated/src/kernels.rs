//! The generated modules: derived anew at build time, or as committed in `golden/`.

use crate::types::{BoundaryKernel, RegionKernel};

/// What generated boundary sets call to check a slice once.
pub(crate) fn sized<'a>(slice: &'a mut [f64], size: usize, name: &str) -> &'a mut [f64] {
    assert!(slice.len() >= size, "{name}: {} of {size} values", slice.len());
    &mut slice[..size]
}

macro_rules! generated {
    ($name:ident) => {
        #[cfg(feature = "regenerate")]
        include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        #[cfg(not(feature = "regenerate"))]
        include!(concat!(env!("CARGO_MANIFEST_DIR"), "/golden/", stringify!($name), ".rs"));
    };
}

macro_rules! regions {
    ($($name:ident $constant:ident $doc:literal),* $(,)?) => {
        $(
            #[allow(non_snake_case, clippy::all)]
            mod $name {
                use crate::function::*;
                use crate::lane::Lane;
                use crate::sweep::{Chunk, Sweep, sweep};
                use crate::types::{RegionKernel, Symbol};
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: RegionKernel = $name::KERNEL;
        )*
        /// All region kernels.
        pub static REGIONS: &[&RegionKernel] = &[$(&$constant),*];
    };
}

macro_rules! boundaries {
    ($($name:ident $constant:ident $doc:literal),* $(,)?) => {
        $(
            #[allow(non_snake_case, unused_variables, clippy::all)]
            mod $name {
                use super::sized;
                use crate::function::*;
                use crate::types::{BoundaryKernel, Equation, Symbol};
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: BoundaryKernel = $name::KERNEL;
        )*
        /// All boundary sets.
        pub static BOUNDARIES: &[&BoundaryKernel] = &[$(&$constant),*];
    };
}

macro_rules! formulae {
    ($($name:ident $constant:ident $doc:literal),* $(,)?) => {
        $(
            #[allow(non_snake_case, unused_variables, unused_comparisons, unused_imports, clippy::all)]
            mod $name {
                use super::sized;
                use crate::function::*;
                use crate::types::{BoundaryKernel, Equation, Symbol};
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: BoundaryKernel = $name::KERNEL;
        )*
        /// All formulae of the small models: sets without ends and integrals, their inputs are the constants.
        pub static FORMULAE: &[&BoundaryKernel] = &[$(&$constant),*];
    };
}

regions! {
    contact_linearised_viscous_coulomb CONTACT_LINEARISED_VISCOUS_COULOMB
        "The belt in a groove: linearised shear (3.38), (3.40), viscous Coulomb friction.",
    contact_linearised_tanh CONTACT_LINEARISED_TANH
        "The belt in a groove: linearised shear (3.38), (3.40), smooth friction.",
    contact_full_viscous_coulomb CONTACT_FULL_VISCOUS_COULOMB
        "The belt in a groove: full shear (3.33), (3.35), viscous Coulomb friction.",
    contact_full_tanh CONTACT_FULL_TANH
        "The belt in a groove: full shear (3.33), (3.35), smooth friction.",
    span_derived SPAN_DERIVED
        "The free belt, (3.43) to (3.48).",
    span_as_printed SPAN_AS_PRINTED
        "The free belt as Appendix C prints it.",
    contact_string_viscous_coulomb CONTACT_STRING_VISCOUS_COULOMB
        "The belt in a groove without bending stiffness (3.22) to (3.24), viscous Coulomb friction.",
    contact_string_tanh CONTACT_STRING_TANH
        "The belt in a groove without bending stiffness (3.22) to (3.24), smooth friction.",
    span_string SPAN_STRING
        "The free belt without bending stiffness: a straight line at constant tension.",
}

boundaries! {
    boundary_zero_linearised BOUNDARY_ZERO_LINEARISED
        "No shear where the belt meets a pulley; linearised shear.",
    boundary_zero_full BOUNDARY_ZERO_FULL
        "No shear where the belt meets a pulley; full shear.",
    boundary_continuous_linearised BOUNDARY_CONTINUOUS_LINEARISED
        "Shear continuous where the belt meets a pulley; linearised shear.",
    boundary_continuous_full BOUNDARY_CONTINUOUS_FULL
        "Shear continuous where the belt meets a pulley; full shear.",
    boundary_as_printed BOUNDARY_AS_PRINTED
        "Conditions as Appendix D prints them.",
    outputs OUTPUTS
        "What a drive is asked for: each equation's residual is an output.",
    boundary_string BOUNDARY_STRING
        "Conditions of a belt without bending stiffness.",
    outputs_string OUTPUTS_STRING
        "What a drive is asked for, without bending stiffness: each equation's residual is an output.",
}

formulae! {
    simple_drive SIMPLE_DRIVE
        "A belt drive that adheres, then slides: residuals in two speeds, two torques, two axial forces and v_0.",
    simple_drive_closed SIMPLE_DRIVE_CLOSED
        "A belt drive that adheres, then slides: what follows without iteration.",
    belt_pulley BELT_PULLEY
        "A pulley wrapped by a belt: residuals in its ports, and its power balance.",
    belt_pulley_limits BELT_PULLEY_LIMITS
        "A pulley wrapped by a belt: how much of its friction a pair of tensions takes.",
    drive_sizing DRIVE_SIZING
        "Torques and inertia at the input of a belt drive (3.21) to (3.27); each equation's residual is an output.",
    drive_sizing_idler DRIVE_SIZING_IDLER
        "Inertia of an idler at the input of a belt drive; each equation's residual is an output.",
    flyweight_table FLYWEIGHT_TABLE
        "Axial force of flyweights whose radius times its slope over the shift is known (9.2).",
    flyweight_ramp FLYWEIGHT_RAMP
        "Axial force of flyweights that slide along a radius against a ramp.",
    flyweight_arm FLYWEIGHT_ARM
        "Axial force of pivoted cam arms that bear on rollers.",
    compression_spring COMPRESSION_SPRING
        "Force of a compression spring.",
    helix HELIX
        "Axial force of a helix and its torsion spring.",
    sheave_travel SHEAVE_TRAVEL
        "Travel of a movable sheave from the belt's radius.",
    vehicle_load VEHICLE_LOAD
        "Torque that a vehicle takes from the secondary.",
}
