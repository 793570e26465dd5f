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

/// Adds μ, the direction of friction and the pressure to a plan.
///
/// The belt slides on a cone: beside v_r and v_t it moves v_r tanβ along the pulley's axis, altogether at |v|/cosβ_s
/// with the apparent sheave angle tanβ_s = tanβ cosγ of (3.14). Friction opposes that velocity.
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_friction(plan: &mut Plan, law: Law) -> Result<(), Error> {
    plan.nonzero("v_thr", "the friction law has a threshold")?;
    plan.nonzero("cos(beta)", "a groove is narrower than a half-plane")?;
    plan.nonzero("speed^2 + (v_r*sin(beta)/cos(beta))^2", "|v| ≥ v_0 > 0")?;
    plan.nonzero("face_speed", "|v| ≥ v_0 > 0")?;
    plan.nonzero("cos(beta) + f_r*sin(beta)/cos(beta)", "no self-locking: β + atan μ < 90°")?;
    plan.primitive("slip", "speed/v_thr", "Fig. 3.6")?;
    match law {
        Law::ViscousCoulomb => plan.apply("saturation", Function::Saturate, &["slip"], "Fig. 3.6")?,
        Law::Tanh => plan.apply("saturation", Function::Tanh, &["4*slip"], "smooth law")?,
    }
    plan.primitive("mu", "mu_k*saturation", "Fig. 3.6")?;
    plan.apply("face_speed", Function::Sqrt, &["speed^2 + (v_r*sin(beta)/cos(beta))^2"], "(3.13), (3.14)")?;
    plan.primitive("f_r", "mu*v_r/face_speed", "(3.13) to (3.15)")?;
    plan.primitive("f_t", "mu*v_t/face_speed", "(3.13) to (3.15)")?;
    // μ sinβ_s = tanβ f_r by (3.14).
    plan.primitive("p", "k*x/(2*(cos(beta) + f_r*sin(beta)/cos(beta)))", "(3.16) to (3.18)")
}

/// Adds the loads on the belt per wrap angle, outward and along it, (3.20) and (3.21) with (3.4).
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_loads(plan: &mut Plan) -> Result<(), Error> {
    plan.primitive("q", "2*p*r", "(3.7)")?;
    plan.primitive("n", "q*(sin(beta) - f_r + f_t*tan_theta)", "(3.20)")?;
    plan.primitive("t", "q*(f_t + (f_r - sin(beta))*tan_theta)", "(3.21)")
}
