//! What is integrated along a region, and where power goes.
//!
//! Multiplying the tangential momentum balance by V and integrating around the loop gives, for full shear with
//! continuous ends and without further assumption,
//!
//! ```text
//! M_in ω_P − M_out ω_S = W + E,      E = ∮ (M_b²/(2 EI) − k tanβ x²/2) dV
//! ```
//!
//! W is what friction turns to heat. E is left over because (3.26) and (3.16) state moment and pressure per stretched
//! length while the belt's speed, and with it the length that a piece of belt has, changes with its tension: the flow
//! of bent and squeezed belt carries V times the energy per length, which is not the work done on it. E is of the order
//! of the belt's strain times the flow of bending energy, 1e-5 to 1e-4 of the power.

use symbolica::atom::Atom;

use super::kinematics::stretch;
use crate::derive::linear_in;
use crate::error::Error;
use crate::plan::Plan;

/// Adds the integrands of a contact region to a plan, each times Φ.
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_contact_integrands(plan: &mut Plan) -> Result<(), Error> {
    plan.nonzero("EA + F", "the belt is not compressed to nothing")?;
    plan.primitive("stretch", "(EA + F)/EA", "(3.9)")?;
    plan.nonzero("stretch", "the belt is not compressed to nothing")?;
    plan.primitive("axial", "k*x/2", "(5.57)")?;
    // 2 p μ |v|/cosβ_s: the velocity on the sheave's face is v_r/cosβ up the face and v_t around it.
    plan.primitive("loss_radial", "2*p*f_r*v_r/cos(beta)^2", "power of friction")?;
    plan.primitive("loss_tangential", "2*p*f_t*v_t", "power of friction")?;
    plan.primitive("loss", "loss_radial + loss_tangential", "power of friction")?;
    plan.primitive("M_hat_1", "Phi*q*f_t*arc", "(5.54)")?;
    plan.primitive("A_hat_1", "Phi*axial*arc", "(5.58)")?;
    plan.primitive("L_o_hat_1", "Phi*arc/stretch", "(5.55)")?;
    plan.primitive("W_hat_1", "Phi*loss*arc", "energy")?;
    plan.primitive("A_x_hat_1", "A_hat_1*r*cos(Phi*s)", "moment of (5.58)")?;
    plan.primitive("A_y_hat_1", "A_hat_1*r*sin(Phi*s)", "moment of (5.58)")?;
    plan.derived("V_T", speed_slope("T")?, "(3.11)")?;
    plan.primitive("stored", "M_b^2/(2*EI) - k*x^2*sin(beta)/cos(beta)/2", "energy of bending less that of squeezing")?;
    plan.primitive("E_hat_1", "stored*V_T*T_hat_1", "energy")
}

/// dV/dT along the belt.
fn speed_slope(tractive: &str) -> Result<Atom, Error> {
    let (_, speed) = stretch(tractive)?;
    Ok(linear_in(&speed, tractive)?.coefficient)
}

/// Adds the integrands of a span to a plan.
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_span_integrands(plan: &mut Plan) -> Result<(), Error> {
    plan.primitive("stretch", "(EA + F)/EA", "(3.9)")?;
    plan.nonzero("stretch", "the belt is not compressed to nothing")?;
    plan.primitive("X_hat_1", "cos(vartheta)", "(5.25)")?;
    plan.primitive("Y_hat_1", "sin(vartheta)", "(5.26)")?;
    plan.primitive("L_o_hat_1", "L/stretch", "(5.56)")?;
    plan.derived("V_T", speed_slope("tau")?, "(3.11)")?;
    plan.primitive("stored", "M_b^2/(2*EI)", "energy of bending")?;
    plan.primitive("E_hat_1", "stored*V_T*tau_hat_1", "energy")
}
