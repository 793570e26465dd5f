//! Right-hand sides, boundary residuals and their derivatives, as `eqgen` emits them.
//!
//! Everything in the kernels is generated; written by hand here is only what they run on: the lanes they compute in,
//! the elementary functions, and the choice of vector instructions at run time. All choices give the same bits.

#![cfg_attr(not(test), deny(clippy::disallowed_methods))]

mod circle;
mod derivation;
mod function;
mod job;
mod kernels;
mod lane;
#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod lane_wasm;
#[cfg(target_arch = "x86_64")]
mod lane_x86;
mod sets;
mod sweep;
mod types;
mod vocabulary;

pub use circle::sines_and_cosines;
pub use derivation::{DerivationFormat, derivation};
pub use job::Job;
pub use kernels::{
    BELT_PULLEY, BELT_PULLEY_LIMITS, BOUNDARIES, BOUNDARY_AS_PRINTED, BOUNDARY_CONTINUOUS_FULL,
    BOUNDARY_CONTINUOUS_LINEARISED, BOUNDARY_STRING, BOUNDARY_ZERO_FULL, BOUNDARY_ZERO_LINEARISED, COMPRESSION_SPRING,
    CONTACT_FULL_TANH, CONTACT_FULL_VISCOUS_COULOMB, CONTACT_LINEARISED_TANH, CONTACT_LINEARISED_VISCOUS_COULOMB,
    CONTACT_STRING_TANH, CONTACT_STRING_VISCOUS_COULOMB, DRIVE_SIZING, DRIVE_SIZING_IDLER, FLYWEIGHT_ARM,
    FLYWEIGHT_RAMP, FLYWEIGHT_ROLLER, FLYWEIGHT_TABLE, FORMULAE, HELIX, HYSTERESIS, HYSTERESIS_CONTACT,
    HYSTERESIS_SPAN, LOSS_BALANCE, OUTPUT_SETS, OUTPUTS, OUTPUTS_STRING, REGIONS, SHEAVE_TRAVEL, SIMPLE_DRIVE,
    SIMPLE_DRIVE_CLOSED, SPAN_AS_PRINTED, SPAN_DERIVED, SPAN_STRING, VEHICLE_LOAD,
};
pub use sets::{BeltTheory, FormulaKernel, OutputKernel};
pub use sweep::Simd;
pub use types::{
    BoundaryFn, BoundaryJacobianFn, BoundaryKernel, Dimension, Identity, RegionFn, RegionKernel, RegionOut, Symbol,
};
pub use vocabulary::{
    BeltPulleyInput, BeltPulleyLimit, BeltPulleyLimitInput, BeltPulleyOutput, CompressionSpringInput,
    CompressionSpringOutput, Constant, DriveSizingIdlerOutput, DriveSizingInput, DriveSizingOutput, Field,
    FlyweightArmInput, FlyweightArmOutput, FlyweightRampInput, FlyweightRampOutput, FlyweightRollerInput,
    FlyweightRollerOutput, FlyweightTableInput, FlyweightTableOutput, HelixInput, HelixOutput, HysteresisContactInput,
    HysteresisContactOutput, HysteresisInput, HysteresisOutput, HysteresisSpanInput, HysteresisSpanOutput, Integral,
    LossBalanceInput, LossBalanceOutput, Output, RegionConstant, SheaveTravelInput, SheaveTravelOutput,
    SimpleDriveInput, SimpleDriveOutput, SimpleDriveResidual, State, UnknownOutput, VehicleLoadInput,
    VehicleLoadOutput,
};
