//! The generated modules: derived anew at build time, or as committed in `golden/`.

use crate::sets::{FormulaKernel, OutputKernel};
use crate::types::{BoundaryKernel, RegionKernel};
use crate::vocabulary::*;

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
                use crate::types::RegionKernel;
                use crate::vocabulary::{Field, Integral, RegionConstant, State};
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
                use crate::types::{BoundaryKernel, Dimension, Symbol};
                use crate::vocabulary::Constant;
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: BoundaryKernel = $name::KERNEL;
        )*
        /// All sets of boundary equations.
        pub static BOUNDARIES: &[&BoundaryKernel] = &[$(&$constant),*];
    };
}

macro_rules! outputs {
    ($($name:ident $constant:ident $doc:literal),* $(,)?) => {
        $(
            #[allow(non_snake_case, unused_variables, clippy::all)]
            mod $name {
                use super::sized;
                use crate::function::*;
                use crate::sets::{BeltTheory, OutputKernel};
                use crate::types::{BoundaryKernel, Dimension, Symbol};
                use crate::vocabulary::{Constant, Output};
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: OutputKernel = $name::KERNEL;
        )*
        /// The outputs of all drives.
        pub static OUTPUT_SETS: &[&OutputKernel] = &[$(&$constant),*];
    };
}

macro_rules! formulae {
    ($($name:ident $constant:ident $input:ident $output:ident $doc:literal),* $(,)?) => {
        $(
            #[allow(non_snake_case, unused_variables, unused_comparisons, unused_imports, clippy::all)]
            mod $name {
                use super::sized;
                use crate::function::*;
                use crate::sets::FormulaKernel;
                use crate::types::BoundaryKernel;
                use crate::vocabulary::{$input, $output};
                generated!($name);
            }
            #[doc = $doc]
            pub static $constant: FormulaKernel<$input, $output> = $name::KERNEL;
        )*
        /// All formulae of the small models: sets without ends and integrals, their inputs are the constants.
        pub static FORMULAE: &[&BoundaryKernel] = &[$(&$constant.set),*];
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
    boundary_string BOUNDARY_STRING
        "Conditions of a belt without bending stiffness.",
}

outputs! {
    outputs OUTPUTS
        "What a drive is asked for.",
    outputs_string OUTPUTS_STRING
        "What a drive is asked for, without bending stiffness.",
}

formulae! {
    simple_drive SIMPLE_DRIVE SimpleDriveInput SimpleDriveResidual
        "A belt drive that adheres, then slides: residuals in two speeds, two torques, two axial forces and v_0.",
    simple_drive_closed SIMPLE_DRIVE_CLOSED SimpleDriveInput SimpleDriveOutput
        "A belt drive that adheres, then slides: what follows without iteration.",
    belt_pulley BELT_PULLEY BeltPulleyInput BeltPulleyOutput
        "A pulley wrapped by a belt: residuals in its ports, and its power balance.",
    belt_pulley_limits BELT_PULLEY_LIMITS BeltPulleyLimitInput BeltPulleyLimit
        "A pulley wrapped by a belt: how much of its friction a pair of tensions takes.",
    drive_sizing DRIVE_SIZING DriveSizingInput DriveSizingOutput
        "Torques and inertia at the input of a belt drive (3.21) to (3.27).",
    drive_sizing_idler DRIVE_SIZING_IDLER DriveSizingInput DriveSizingIdlerOutput
        "Inertia of an idler at the input of a belt drive.",
    hysteresis_contact HYSTERESIS_CONTACT HysteresisContactInput HysteresisContactOutput
        "What hysteresis follows along the belt in a groove.",
    hysteresis_span HYSTERESIS_SPAN HysteresisSpanInput HysteresisSpanOutput
        "What hysteresis follows along the free belt.",
    hysteresis HYSTERESIS HysteresisInput HysteresisOutput
        "Power that a harmonic of what runs around with the belt loses.",
    loss_balance LOSS_BALANCE LossBalanceInput LossBalanceOutput
        "What arrives once hysteresis, drag and gears have had their share.",
    flyweight_table FLYWEIGHT_TABLE FlyweightTableInput FlyweightTableOutput
        "Axial force of flyweights whose radius times its slope over the shift is known (9.2).",
    flyweight_ramp FLYWEIGHT_RAMP FlyweightRampInput FlyweightRampOutput
        "Axial force of flyweights that slide along a radius against a ramp.",
    flyweight_arm FLYWEIGHT_ARM FlyweightArmInput FlyweightArmOutput
        "Axial force of pivoted cam arms that bear on rollers.",
    flyweight_roller FLYWEIGHT_ROLLER FlyweightRollerInput FlyweightRollerOutput
        "Axial force of pivoted arms whose rollers bear on ramps of the movable sheave.",
    compression_spring COMPRESSION_SPRING CompressionSpringInput CompressionSpringOutput
        "Force of a compression spring.",
    helix HELIX HelixInput HelixOutput
        "Axial force of a helix and its torsion spring.",
    sheave_travel SHEAVE_TRAVEL SheaveTravelInput SheaveTravelOutput
        "Travel of a movable sheave from the belt's radius.",
    vehicle_load VEHICLE_LOAD VehicleLoadInput VehicleLoadOutput
        "Torque that a vehicle takes from the secondary.",
}
