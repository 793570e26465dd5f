//! Geometry of the belt in the groove, its stretch and speed, and how it slides.

use symbolica::atom::Atom;

use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::plan::{Function, Plan, read};

/// Keeps |v| away from zero, m/s: a thousandth of what rounding leaves of V cosθ − r ω at 25 m/s.
pub const GUARD_SPEED: f64 = 1e-12;

/// Arc length per wrap angle ds/dφ (3.4), with r = R − x (3.1).
pub const ARC: &str = "(R - x)/cos(theta)";

/// Direction of the belt against a fixed one, ψ = φ − θ (3.2).
pub const PSI: &str = "phi - theta";

/// x' = −(R − x) tanθ (3.24): the belt's inclination is how its radius changes.
pub const SLOPE: &str = "-(R - x)*sin(theta)/cos(theta)";

/// V = V_o (1 + F/EA) (3.9) with V_o = G/m_o (3.5): Hooke's law.
pub const SPEED: &str = "G/m_o*(1 + F/EA)";

/// Tension F and speed V from the tractive tension, (3.10) and (3.11).
///
/// # Errors
/// Only if the relations typed in here are not linear in F.
pub fn stretch(tractive: &str) -> Result<(Atom, Atom), Error> {
    let speed = read("V", SPEED)?;
    // T = F − G V (3.6).
    let balance = read("F", &format!("F - G*V - {tractive}"))?;
    let tension = solve_linear(&substitute(&balance, &[("V", speed.clone())]), "F")?;
    let speed = substitute(&speed, &[("F", tension.clone())]);
    Ok((tension, symbolica::atom::AtomCore::factor(&speed)))
}

/// Adds mass flow, F and V to a plan.
///
/// # Errors
/// As [`Plan::derived`].
pub fn add_stretch(plan: &mut Plan, tractive: &str) -> Result<(), Error> {
    plan.nonzero("m_o", "a belt has mass")?;
    plan.nonzero("EA", "a belt is stiff")?;
    plan.nonzero("EA*m_o - G^2", "G² = m_o EA is a belt at the speed of its own longitudinal waves")?;
    plan.primitive("G", "flow*m_o*R_P*omega_P", "definition of the flow coefficient")?;
    plan.law(tractive, "F - G*V", "(3.6)")?;
    plan.law("V", SPEED, "(3.5), (3.8), (3.9)")?;
    let (tension, speed) = stretch(tractive)?;
    plan.derived("F", tension, "(3.10)")?;
    plan.derived("V", speed, "(3.11)")
}

/// Adds the sliding velocity to a plan, (3.12).
///
/// # Errors
/// As [`Plan::primitive`].
pub fn add_sliding(plan: &mut Plan) -> Result<(), Error> {
    plan.nonzero("cos(theta)", "a belt at θ = ±90° would point at the pulley's centre")?;
    plan.nonzero("arc", "the belt runs around the pulley's centre")?;
    plan.nonzero("speed", "|v| ≥ v_0 > 0")?;
    plan.nonzero("v_0^2 + v_r^2 + v_t^2", "v_0 > 0")?;
    plan.primitive("omega", "sigma*omega_P", "definition of the speed ratio")?;
    plan.primitive("r", "R - x", "(3.1)")?;
    plan.primitive("arc", ARC, "(3.4)")?;
    plan.apply("tan_theta", Function::Tan, &["theta"], "(3.24)")?;
    plan.primitive("v_r", "V*sin(theta)", "(3.12)")?;
    plan.primitive("v_t", "V*cos(theta) - (R - x)*omega", "(3.12)")?;
    plan.number("v_0", GUARD_SPEED, "guard: replaces |v| = 0 by 1e-12 m/s; smooth, and without effect elsewhere")?;
    plan.apply("speed", Function::Sqrt, &["v_r^2 + v_t^2 + v_0^2"], "(3.12)")
}
