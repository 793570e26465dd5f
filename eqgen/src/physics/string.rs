//! A belt without bending stiffness (Kong and Parker; thesis 3.1.1): a string in the grooves, straight spans.
//!
//! The same constants, integrals and fields as with bending, so that a drive is put together in the same way: EI is
//! without effect, moment and shear vanish.

use super::contact::{self, TANGENTIAL_MOMENTUM, add_fields, add_path};
use super::energy::{add_contact_integrands, add_span_integrands};
use super::friction::{Law, add_friction, add_loads};
use super::kinematics::{add_sliding, add_stretch};
use super::model::RegionModel;
use super::span;
use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::plan::{Plan, read};

/// States in a groove.
pub const CONTACT_STATES: [&str; 3] = ["T", "theta", "x"];
/// States of a span: both are constant along it.
pub const SPAN_STATES: [&str; 2] = ["tau", "vartheta"];

const CONTACT_ROWS: [&str; 10] = [
    "T_hat_1",
    "theta_hat_1",
    "x_hat_1",
    "M_hat_1",
    "A_hat_1",
    "L_o_hat_1",
    "W_hat_1",
    "A_x_hat_1",
    "A_y_hat_1",
    "E_hat_1",
];
const SPAN_ROWS: [&str; 6] = ["tau_hat_1", "vartheta_hat_1", "X_hat_1", "Y_hat_1", "L_o_hat_1", "E_hat_1"];

/// Normal momentum (3.20) with T = F − G V and (3.2): T (1 − θ') = n.
pub const NORMAL_MOMENTUM: &str = "T*(1 - theta_1) - n";

const NO_MOMENT: &str = "a string carries no moment";

/// The contact region of a string with that friction.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn contact_model(law: Law) -> Result<RegionModel, Error> {
    let inputs = ["s"].iter().chain(&CONTACT_STATES).chain(&contact::CONSTANTS).map(|&name| name.into()).collect();
    let mut plan = Plan::new(inputs, Default::default())?;
    plan.nonzero("T", "a string is in tension")?;
    plan.nonzero("EI", "named for the sake of the energy, whose share it has vanishes")?;
    add_stretch(&mut plan, "T")?;
    add_sliding(&mut plan)?;
    add_friction(&mut plan, law)?;
    add_loads(&mut plan)?;
    plan.number("M_b", 0.0, NO_MOMENT)?;
    plan.number("Q", 0.0, NO_MOMENT)?;
    plan.law("T*(1 - theta_1)", "n", "(3.20)")?;
    plan.law("T_1", "t", "(3.21)")?;
    let turn = solve_linear(&read("theta_1", NORMAL_MOMENTUM)?, "theta_1")?;
    plan.derived("theta_1", turn, "(3.22)")?;
    let along = substitute(&read("T", TANGENTIAL_MOMENTUM)?, &[("Q", read("Q", "0")?)]);
    plan.derived("T_hat_1", read("Phi", "Phi")? * along, "(3.23)")?;
    plan.primitive("theta_hat_1", "Phi*theta_1", "(5.2)")?;
    add_path(&mut plan)?;
    add_contact_integrands(&mut plan)?;
    add_fields(&mut plan)?;
    Ok(RegionModel {
        name: format!("contact_string_{}", law.name()),
        doc: format!("The belt in a groove, without bending stiffness: {} friction.", law.name().replace('_', "-")),
        plan,
        states: &CONTACT_STATES,
        constants: &contact::CONSTANTS,
        default_unknowns: 3,
        integrals: &contact::INTEGRALS,
        rows: &CONTACT_ROWS,
        fields: &contact::FIELDS,
    })
}

/// A straight span at constant tension.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn span_model() -> Result<RegionModel, Error> {
    let inputs = ["s"].iter().chain(&SPAN_STATES).chain(&span::CONSTANTS).map(|&name| name.into()).collect();
    let mut plan = Plan::new(inputs, Default::default())?;
    plan.nonzero("EI", "named for the sake of the energy, whose share it has vanishes")?;
    add_stretch(&mut plan, "tau")?;
    for name in ["M_b", "Q"] {
        plan.number(name, 0.0, NO_MOMENT)?;
    }
    for name in ["tau_hat_1", "vartheta_hat_1"] {
        plan.number(name, 0.0, "a free string is straight, its tension constant")?;
    }
    add_span_integrands(&mut plan)?;
    Ok(RegionModel {
        name: "span_string".into(),
        doc: "The free belt without bending stiffness: a straight line.".into(),
        plan,
        states: &SPAN_STATES,
        constants: &span::CONSTANTS,
        default_unknowns: 2,
        integrals: &span::INTEGRALS,
        rows: &SPAN_ROWS,
        fields: &span::FIELDS,
    })
}
