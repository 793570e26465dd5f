//! Friction in the groove: coefficient, direction, normal pressure and the loads on the belt.

use crate::error::Error;
use crate::plan::{Function, Plan};

/// How the coefficient of friction depends on the sliding speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// μ = μ_k min(1, |v|/v_thr), Fig. 3.6.
    ViscousCoulomb,
    /// μ = μ_k tanh(4 |v|/v_thr).
    Tanh,
}

impl Law {
    /// As in the case file, with underscores.
    pub fn name(self) -> &'static str {
        match self {
            Law::ViscousCoulomb => "viscous_coulomb",
            Law::Tanh => "tanh",
        }
    }
}

/// Adds μ, the apparent sheave angle and the pressure to a plan.
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_friction(plan: &mut Plan, law: Law) -> Result<(), Error> {
    plan.nonzero("v_thr", "the friction law has a threshold")?;
    plan.nonzero("cos(beta)", "a groove is narrower than a half-plane")?;
    plan.nonzero("1 + tan_beta_s^2", "a sum of squares with 1")?;
    plan.nonzero("sec_beta_s", "a secant is at least 1")?;
    plan.nonzero("cos(beta) + mu*sin_beta_s", "no self-locking: β + atan μ < 90°")?;
    plan.primitive("slip", "speed/v_thr", "Fig. 3.6")?;
    match law {
        Law::ViscousCoulomb => plan.apply("saturation", Function::Saturate, &["slip"], "Fig. 3.6")?,
        Law::Tanh => plan.apply("saturation", Function::Tanh, &["4*slip"], "smooth law")?,
    }
    plan.primitive("mu", "mu_k*saturation", "Fig. 3.6")?;
    plan.primitive("tan_beta_s", "sin(beta)/cos(beta)*cos_gamma", "(3.14)")?;
    plan.apply("sec_beta_s", Function::Sqrt, &["1 + tan_beta_s^2"], "(3.14)")?;
    plan.primitive("cos_beta_s", "1/sec_beta_s", "(3.14)")?;
    plan.primitive("sin_beta_s", "tan_beta_s*cos_beta_s", "(3.14)")?;
    plan.primitive("p", "k*x/(2*(cos(beta) + mu*sin_beta_s))", "(3.16) to (3.18)")
}

/// Adds the loads on the belt per wrap angle, outward and along it, (3.20) and (3.21) with (3.4).
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_loads(plan: &mut Plan) -> Result<(), Error> {
    let cos_sum = "(cos(theta)*cos_gamma - sin(theta)*sin_gamma)";
    let sin_sum = "(sin(theta)*cos_gamma + cos(theta)*sin_gamma)";
    let outward = format!("2*p*(sin(beta)*cos(theta) - mu*cos_beta_s*{cos_sum})*arc");
    let along = format!("2*p*(mu*cos_beta_s*{sin_sum} - sin(beta)*sin(theta))*arc");
    plan.primitive("n", &outward, "(3.20)")?;
    plan.primitive("t", &along, "(3.21)")
}
