//! What is integrated along a region, and where power goes.

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
    plan.primitive("loss", "2*mu*p*speed*sec_beta_s", "power of friction on the sheave's face")?;
    plan.primitive("M_hat_1", "Phi*2*mu*p*cos_beta_s*sin_gamma*r*arc", "(5.54)")?;
    plan.primitive("A_hat_1", "Phi*axial*arc", "(5.58)")?;
    plan.primitive("L_o_hat_1", "Phi*arc/stretch", "(5.55)")?;
    plan.primitive("W_hat_1", "Phi*loss*arc", "energy")?;
    plan.primitive("A_x_hat_1", "A_hat_1*r*cos(Phi*s)", "moment of (5.58)")?;
    plan.primitive("A_y_hat_1", "A_hat_1*r*sin(Phi*s)", "moment of (5.58)")
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
    plan.primitive("L_o_hat_1", "L/stretch", "(5.56)")
}
