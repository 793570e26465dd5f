//! The physics of a V-belt, one file per thing in nature. Equation numbers are those of B. Messick's thesis,
//! (C) and (D) its Appendices C and D.

pub mod beam;
pub mod boundary;
pub mod contact;
pub mod edition;
pub mod energy;
pub mod friction;
pub mod kinematics;
pub mod model;
pub mod notation;
pub mod outputs;
pub mod small;
pub mod span;
pub mod string;
