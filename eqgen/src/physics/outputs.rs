//! What a drive is asked for: every output that is a function of ends, integrals and constants, with its derivatives.

use super::boundary::{Belt, CONSTANTS, end_symbols, integral_symbols};
use super::model::BoundaryModel;
use super::notation;
use crate::dimension::{Dimension, Dimensions};
use crate::error::Error;
use crate::plan::{Function, Plan};

/// (name, expression, unit, what it is)
type Row = (&'static str, &'static str, &'static str, &'static str);

/// Outputs, in order: region and key of the result object, joined by two underscores.
const OUTPUTS: &[Row] = &[
    ("primary__speed", "omega_P", "rad/s", "speed of rotation"),
    // Friction on the belt drives it backwards on the primary: M_P < 0.
    ("primary__torque", "-M_P", "N m", "torque that drives the pulley (5.54)"),
    ("primary__power", "-M_P*omega_P", "W", "power into the pulley"),
    ("primary__axial_force", "A_P", "N", "axial force on a sheave (5.58)"),
    ("primary__wrap_angle", "Phi_P*s_2", "rad", "wrap angle"),
    ("primary__entry_angle", "theta_P1", "rad", "inclination where the belt enters"),
    ("primary__exit_angle", "theta_P2", "rad", "inclination where the belt leaves"),
    ("primary__orientation_angle", "C_P", "rad", "orientation angle"),
    // The moments turn with the entry, which stands at C_P.
    ("primary__resultant_x", "(cos(C_P)*A_x_P - sin(C_P)*A_y_P)/A_P", "m", "where the axial force acts (6.3), (6.5)"),
    ("primary__resultant_y", "(sin(C_P)*A_x_P + cos(C_P)*A_y_P)/A_P", "m", "where the axial force acts (6.4), (6.5)"),
    ("primary__binding_moment", "binding_P", "N m", "moment of the axial force about the centre"),
    ("primary__friction_loss", "W_P", "W", "power lost to friction"),
    ("primary__entry_tension", "T_P1", "N", "tractive tension where the belt enters"),
    ("primary__exit_tension", "T_P2", "N", "tractive tension where the belt leaves"),
    ("secondary__speed", "speed_ratio*omega_P", "rad/s", "speed of rotation"),
    ("secondary__torque", "M_S", "N m", "torque that the pulley delivers (5.54)"),
    ("secondary__power", "M_S*speed_ratio*omega_P", "W", "power out of the pulley"),
    ("secondary__axial_force", "A_S", "N", "axial force on a sheave (5.58)"),
    ("secondary__wrap_angle", "Phi_S*s_2", "rad", "wrap angle"),
    ("secondary__entry_angle", "theta_S1", "rad", "inclination where the belt enters"),
    ("secondary__exit_angle", "theta_S2", "rad", "inclination where the belt leaves"),
    ("secondary__orientation_angle", "C_S", "rad", "orientation angle"),
    // Here the entry stands at π − C_S − Φ_S.
    (
        "secondary__resultant_x",
        "(sin(C_S + Phi_S*s_2)*(-A_y_S) - cos(C_S + Phi_S*s_2)*A_x_S)/A_S",
        "m",
        "where the axial force acts (6.3), (6.6)",
    ),
    (
        "secondary__resultant_y",
        "(sin(C_S + Phi_S*s_2)*A_x_S - cos(C_S + Phi_S*s_2)*A_y_S)/A_S",
        "m",
        "where the axial force acts (6.4), (6.6)",
    ),
    ("secondary__binding_moment", "binding_S", "N m", "moment of the axial force about the centre"),
    ("secondary__friction_loss", "W_S", "W", "power lost to friction"),
    ("secondary__entry_tension", "T_S1", "N", "tractive tension where the belt enters"),
    ("secondary__exit_tension", "T_S2", "N", "tractive tension where the belt leaves"),
    ("tight_span__arc_length", "L_t*s_2", "m", "arc length"),
    ("tight_span__unstretched_length", "L_o_t", "m", "length when unloaded (5.56)"),
    ("slack_span__arc_length", "L_s*s_2", "m", "arc length"),
    ("slack_span__unstretched_length", "L_o_s", "m", "length when unloaded (5.56)"),
    ("efficiency__speed", "speed_ratio*R_S/R_P", "", "speed efficiency (6.7)"),
    ("efficiency__torque", "-M_S*R_P/(M_P*R_S)", "", "torque efficiency (6.8)"),
    ("efficiency__overall", "-M_S*speed_ratio/M_P", "", "overall efficiency (6.9)"),
    ("belt__mass_flow", "flow*m_o*R_P*omega_P", "kg/s", "mass flow (3.5)"),
    ("belt__unstretched_length", "L_o_P + L_o_s + L_o_S + L_o_t", "m", "length of the loop when unloaded"),
    ("energy__power_in", "-M_P*omega_P", "W", "power into the drive"),
    ("energy__power_out", "M_S*speed_ratio*omega_P", "W", "power out of the drive"),
    ("energy__friction_loss", "W_P + W_S", "W", "power lost to friction"),
    ("energy__stretch_work", "E_P + E_s + E_S + E_t", "W", "power that stretching takes from stored energy"),
    (
        "energy__imbalance",
        "1 + (M_S*speed_ratio*omega_P + W_P + W_S)/(M_P*omega_P)",
        "",
        "power in that is neither power out nor friction loss, over power in",
    ),
    (
        "energy__closure",
        "1 + (M_S*speed_ratio*omega_P + W_P + W_S + E_P + E_s + E_S + E_t)/(M_P*omega_P)",
        "",
        "power in that nothing accounts for, over power in",
    ),
];

/// The outputs of a drive.
///
/// # Errors
/// If an expression is inconsistent; the message names it.
pub fn model(belt: Belt) -> Result<BoundaryModel, Error> {
    let (ends, integrals) = (end_symbols(belt), integral_symbols());
    let symbols = || ends.iter().chain(&integrals);
    let dimension = |unit: &str| Dimension::of_unit(if unit.is_empty() { "1" } else { unit }).unwrap_or(Dimension::ONE);
    let moments = ["binding_P", "binding_S"].map(|name| (name.to_owned(), dimension("N m")));
    let own = symbols().map(|symbol| (symbol.name.clone(), symbol.dimension));
    let outputs = OUTPUTS.iter().map(|(name, _, unit, _)| ((*name).to_owned(), dimension(unit)));
    let extra: Dimensions = own.chain(outputs).chain(moments).collect();
    let inputs = symbols().map(|symbol| symbol.name.clone()).chain(CONSTANTS.iter().map(|&name| name.into())).collect();
    let mut plan = Plan::new(inputs, extra)?;
    plan.number("s_2", 1.0, "a region ends where its variable is 1")?;
    for (text, reason) in [
        ("R_P", "a length"),
        ("R_S", "a length"),
        ("omega_P", "the drive turns"),
        ("M_P", "the drive is driven"),
        ("A_P", "the belt is squeezed"),
        ("A_S", "the belt is squeezed"),
        ("binding_P", "a belt wraps one side of a pulley"),
        ("binding_S", "a belt wraps one side of a pulley"),
        ("A_x_P^2 + A_y_P^2", "a belt wraps one side of a pulley"),
        ("A_x_S^2 + A_y_S^2", "a belt wraps one side of a pulley"),
    ] {
        plan.nonzero(text, reason)?;
    }
    plan.apply("binding_P", Function::Sqrt, &["A_x_P^2 + A_y_P^2"], "6.1.2")?;
    plan.apply("binding_S", Function::Sqrt, &["A_x_S^2 + A_y_S^2"], "6.1.2")?;
    for (name, expression, _, _) in OUTPUTS {
        plan.primitive(name, expression, "chapter 6")?;
    }
    Ok(BoundaryModel {
        name: if belt == Belt::Beam { "outputs" } else { "outputs_string" }.into(),
        doc: "Outputs of a drive as functions of its ends, integrals and constants.".into(),
        plan,
        ends,
        integrals,
        constants: CONSTANTS.iter().filter_map(|name| notation::find(name)).collect(),
        equations: OUTPUTS.iter().map(|(name, _, _, doc)| ((*name).to_owned(), (*doc).to_owned())).collect(),
    })
}
