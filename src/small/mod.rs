//! Small models that stand beside the full one, each a few formulae: where a drive starts ([`init`]), one pulley as a
//! component of a drive line ([`pulley`]), and what a motor has to deliver ([`size`]).
//!
//! Their equations are derived and emitted by `eqgen` as the full model's are; `docs/small-models.md` lists them.

pub mod init;
pub mod pulley;
pub mod size;
