//! The free belt between the pulleys: four states along the arc length.

use symbolica::atom::{Atom, AtomCore};

use super::energy::add_span_integrands;
use super::kinematics::add_stretch;
use super::model::RegionModel;
use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::plan::{Plan, read};

/// States, in order.
pub const STATES: [&str; 4] = ["tau", "vartheta", "vartheta1", "vartheta2"];
/// Integrals, in order.
pub const INTEGRALS: [&str; 4] = ["X", "Y", "L_o", "E"];
/// Constants, in order; the first two are the default unknowns.
pub const CONSTANTS: [&str; 7] = ["L", "flow", "EA", "EI", "m_o", "R_P", "omega_P"];
const ROWS: [&str; 8] =
    ["tau_hat_1", "vartheta1", "vartheta2", "vartheta_hat_3", "X_hat_1", "Y_hat_1", "L_o_hat_1", "E_hat_1"];
/// Derived fields, in order.
pub(super) const FIELDS: [&str; 4] = ["F", "V", "M_b", "Q"];

/// M_b = EI dϑ/ds, (3.26) with ψ = ϑ.
pub const MOMENT: &str = "EI*vartheta_1";
/// Q = dM_b/ds (3.43).
pub const SHEAR: &str = "EI*vartheta_2";
/// Along the belt (3.44): dT = −Q dϑ.
pub const TANGENTIAL_MOMENTUM: &str = "tau_1 + Q*vartheta_1";
/// Across it (3.47): T dϑ = dQ, with dQ/ds = EI ϑ'''.
pub const NORMAL_MOMENTUM: &str = "tau*vartheta_1 - EI*vartheta_3";

/// Which span equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equations {
    /// (3.43) to (3.48), made non-dimensional.
    Derived,
    /// As Appendix C prints them: L² on the wrong side.
    AsPrinted,
}

/// The span with these equations.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn model(equations: Equations) -> Result<RegionModel, Error> {
    let inputs = ["s"].iter().chain(&STATES).chain(&CONSTANTS).map(|&name| name.into()).collect();
    let mut plan = Plan::new(inputs, Default::default())?;
    plan.nonzero("L", "a span has a length")?;
    plan.nonzero("EI", "the belt resists bending")?;
    // s = L ŝ (5.9) to (5.12).
    plan.primitive("vartheta_1", "vartheta1/L", "(5.10)")?;
    plan.primitive("vartheta_2", "vartheta2/L^2", "(5.11)")?;
    plan.primitive("M_b", MOMENT, "(3.26)")?;
    plan.primitive("Q", SHEAR, "(3.43)")?;
    add_stretch(&mut plan, "tau")?;
    match equations {
        Equations::Derived => add_system(&mut plan)?,
        Equations::AsPrinted => {
            plan.as_printed("tau_hat_1", read("tau", "-L^2*EI*vartheta1*vartheta2")?, "(C) rhs(21)")?;
            plan.as_printed("vartheta_hat_3", read("vartheta", "tau/(L^2*EI)*vartheta1")?, "(C) rhs(24)")?;
        }
    }
    add_span_integrands(&mut plan)?;
    let (name, doc) = match equations {
        Equations::Derived => ("span_derived", "The free belt."),
        Equations::AsPrinted => ("span_as_printed", "The free belt as Appendix C prints it: L² on the wrong side."),
    };
    Ok(RegionModel {
        name: name.into(),
        doc: doc.into(),
        plan,
        states: &STATES,
        constants: &CONSTANTS,
        default_unknowns: 2,
        integrals: &INTEGRALS,
        rows: &ROWS,
        fields: &FIELDS,
    })
}

fn add_system(plan: &mut Plan) -> Result<(), Error> {
    plan.law("tau_1", "-Q*vartheta_1", "(3.44)")?;
    plan.law("tau*vartheta_1", "EI*vartheta_3", "(3.47)")?;
    let in_states = |text: &str, unknown: &str| -> Result<Atom, Error> {
        let solved = solve_linear(&substitute(&read(unknown, text)?, &[("Q", read("Q", SHEAR)?)]), unknown)?;
        let hats = [("vartheta_1", read("hat", "vartheta1/L")?), ("vartheta_2", read("hat", "vartheta2/L^2")?)];
        Ok(substitute(&solved, &hats).factor())
    };
    let tension = read("L", "L")? * in_states(TANGENTIAL_MOMENTUM, "tau_1")?;
    let bend = read("L", "L^3")? * in_states(NORMAL_MOMENTUM, "vartheta_3")?;
    plan.derived("tau_hat_1", tension, "(3.45), (5.13)")?;
    plan.derived("vartheta_hat_3", bend, "(3.48), (5.14)")
}
