//! Linear algebra of bordered almost block diagonal systems.

pub(crate) mod chain;
pub(crate) mod dense;
pub(crate) mod memory;
pub(crate) mod qr;
pub(crate) mod reflect;
pub(crate) mod scalar;
pub(crate) mod simd;
