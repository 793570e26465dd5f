//! The belt in a pulley's groove: five states along the wrap angle.

use super::beam::{Shear, add_bending};
use super::energy::add_contact_integrands;
use super::friction::{Law, add_friction, add_loads};
use super::kinematics::{SLOPE, add_sliding, add_stretch};
use super::model::RegionModel;
use symbolica::atom::AtomCore;

use crate::derive::{Linear, linear_in};
use crate::error::Error;
use crate::plan::{Function, Plan, read};

/// States, in order.
pub const STATES: [&str; 5] = ["T", "theta", "theta1", "theta2", "x"];
/// Integrals, in order.
pub const INTEGRALS: [&str; 7] = ["M", "A", "L_o", "W", "A_x", "A_y", "E"];
/// Constants, in order; the first three are the default unknowns.
pub const CONSTANTS: [&str; 13] =
    ["Phi", "sigma", "flow", "EA", "EI", "k", "m_o", "R", "R_P", "beta", "mu_k", "v_thr", "omega_P"];
const ROWS: [&str; 12] = [
    "T_hat_1",
    "theta1",
    "theta2",
    "theta_hat_3",
    "x_hat_1",
    "M_hat_1",
    "A_hat_1",
    "L_o_hat_1",
    "W_hat_1",
    "A_x_hat_1",
    "A_y_hat_1",
    "E_hat_1",
];
/// Derived fields, in order.
pub(super) const FIELDS: [&str; 16] = [
    "F",
    "V",
    "v_r",
    "v_t",
    "speed",
    "gamma",
    "mu",
    "p",
    "beta_s",
    "Q",
    "M_b",
    "axial",
    "loss",
    "loss_radial",
    "loss_tangential",
    "loss_phi",
];

/// Normal momentum (3.28) with T = F − G V and (3.2): T (1 − θ') = n + Q'.
pub const NORMAL_MOMENTUM: &str = "T*(1 - theta_1) - n - Q_theta3*(theta_3 - theta_30)";
/// Tangential momentum (3.29): T' = t − Q (1 − θ').
pub const TANGENTIAL_MOMENTUM: &str = "t - Q*(1 - theta_1)";

/// The contact region with that shear and friction.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn model(shear: Shear, law: Law) -> Result<RegionModel, Error> {
    let inputs = ["s"].iter().chain(&STATES).chain(&CONSTANTS).map(|&name| name.into()).collect();
    let mut plan = Plan::new(inputs, Default::default())?;
    plan.nonzero("Phi", "the belt wraps around the pulley")?;
    // φ = Φ φ̂ (5.1) to (5.4): hatted states are derivatives with respect to φ̂.
    plan.primitive("theta_1", "theta1/Phi", "(5.2)")?;
    plan.primitive("theta_2", "theta2/Phi^2", "(5.3)")?;
    add_stretch(&mut plan, "T")?;
    add_sliding(&mut plan)?;
    add_friction(&mut plan, law)?;
    add_loads(&mut plan)?;
    add_bending(&mut plan, shear)?;
    add_system(&mut plan)?;
    add_contact_integrands(&mut plan)?;
    add_fields(&mut plan)?;
    Ok(RegionModel {
        name: format!("contact_{}_{}", shear.name(), law.name()),
        doc: format!("The belt in a groove: {} shear, {} friction.", shear.name(), law.name().replace('_', "-")),
        plan,
        states: &STATES,
        constants: &CONSTANTS,
        default_unknowns: 3,
        integrals: &INTEGRALS,
        rows: &ROWS,
        fields: &FIELDS,
    })
}

/// Solves the momentum balances for the highest derivatives and writes them in φ̂.
fn add_system(plan: &mut Plan) -> Result<(), Error> {
    plan.nonzero("Q_theta3", "a multiple of EI")?;
    plan.law("T*(1 - theta_1)", "n + Q_1", "(3.28), with the sign of Q' that (3.47) has")?;
    plan.law("T_1", TANGENTIAL_MOMENTUM, "(3.29)")?;
    let Linear { coefficient, rest } = linear_in(&read("theta_3", NORMAL_MOMENTUM)?, "theta_3")?;
    let load = linear_in(&rest, "theta_30")?;
    let highest = read("theta_30", "theta_30")? - load.rest / coefficient;
    plan.derived("theta_3", highest, "(3.41)")?;
    let rate = |text: &str| read("rate", text);
    plan.derived("T_hat_1", rate("Phi")? * rate(TANGENTIAL_MOMENTUM)?, "(3.31), (5.5)")?;
    plan.derived("theta_hat_3", rate("Phi^3*theta_3")?, "(5.4), (5.6)")?;
    add_path(plan)
}

/// x' (3.24) in φ̂.
pub(super) fn add_path(plan: &mut Plan) -> Result<(), Error> {
    plan.law("x_1", SLOPE, "(3.24)")?;
    let slope = read("x_1", SLOPE)?.replace(read("", "sin(theta)")?).with(read("", "tan_theta*cos(theta)")?);
    plan.derived("x_hat_1", read("Phi", "Phi")? * slope, "(3.24)")
}

/// Adds derived fields to a plan.
pub(super) fn add_fields(plan: &mut Plan) -> Result<(), Error> {
    plan.apply("gamma_a", Function::Angle, &["v_r", "v_t"], "(3.13)")?;
    plan.apply("gamma", Function::Turn, &["gamma_a"], "Fig. 6.8")?;
    plan.apply("beta_s", Function::Angle, &["speed", "v_r*sin(beta)/cos(beta)"], "(3.14)")?;
    plan.primitive("loss_phi", "loss*arc", "power of friction")
}
