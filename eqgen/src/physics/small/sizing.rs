//! Sizing of a belt drive: what its input sees. Equation numbers (3.21) to (3.27) are those of the chapter on power
//! transmission in R. Crowder, *Electric Drives and Electromechanical Systems*. All follow from one rigid belt: kinetic
//! energy gives the inertia, power gives the torques.

use symbolica::atom::{Atom, AtomCore};

use super::{Row, Sheet, row};
use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::physics::model::BoundaryModel;
use crate::plan::read;

const INPUTS: &[Row] = &[
    row("M_belt", "M_b", "kg", "mass of the belt").identity("BeltMass", ""),
    row("M_load", "M_l", "kg", "mass that the belt moves in a straight line").identity("LoadMass", ""),
    row("D_in", "D_in", "m", "diameter of the input pulley").identity("InputDiameter", ""),
    row("D_out", "D_out", "m", "diameter of the output pulley").identity("OutputDiameter", ""),
    row("F", "F", "N", "external force on the belt, against its motion").identity("ExternalForce", ""),
    row("F_f", "F_f", "N", "friction force on the linear load").identity("FrictionForce", ""),
    row("T_out", "T_out", "N m", "torque that the application takes from the output pulley")
        .identity("OutputTorque", ""),
    row("I_p1", "I_p1", "kg m^2", "inertia of the input pulley").identity("InputPulleyInertia", ""),
    row("I_p2", "I_p2", "kg m^2", "inertia of the output pulley").identity("OutputPulleyInertia", ""),
    row("I_RL", "I_RL", "kg m^2", "inertia of the rotary load on the output pulley").identity("RotaryLoadInertia", ""),
    row("I_idlers", "I_i", "kg m^2", "inertia of all idlers as seen at the input").identity("IdlerInertia", ""),
    row("alpha", "dω/dt", "rad/s^2", "angular acceleration of the input").identity("Acceleration", ""),
    row("D", "D", "m", "diameter of an idler").identity("IdlerDiameter", ""),
    row("I_idler", "I", "kg m^2", "inertia of an idler").identity("OwnInertia", ""),
];

const OUTPUTS: &[Row] = &[
    row("ratio", "", "", "diameter of the output over that of the input pulley, n (3.25)"),
    row("load_inertia", "", "kg m^2", "inertia of belt and linear load at the input, I_L (3.22)"),
    row("rotating_inertia", "", "kg m^2", "inertia of all that rotates at the input, I_p (3.21)"),
    row("total_inertia", "", "kg m^2", "inertia at the input, I_tot (3.21), (3.27)"),
    row("external_torque", "", "N m", "torque of the external force at the input, T_ext (3.23)"),
    row("friction_torque", "", "N m", "torque of the friction force at the input, T_f (3.24)"),
    row("input_torque", "", "N m", "torque that the load torque takes at the input, T_i (3.26)"),
    row("steady_torque", "", "N m", "torque at the input at constant speed"),
    row("acceleration_torque", "", "N m", "torque at the input that accelerates the inertia"),
    row("drive_torque", "", "N m", "torque at the input, all together"),
];

const IDLER: &[Row] = &[row("reflected_inertia", "", "kg m^2", "inertia of an idler as seen at the input")];

/// A text in speeds of belt, output and idler, over what turns it into a quantity at the input: speeds cancel.
fn at_input(text: &str, over: &str) -> Result<Atom, Error> {
    // One rigid belt: v = ω_in D_in/2 = ω_out D_out/2 = ω D/2.
    let rim = |speed: &str, diameter: &str| solve_linear(&read(speed, &format!("v - {speed}*{diameter}/2"))?, speed);
    let speeds = [("omega_out", rim("omega_out", "D_out")?), ("omega_idler", rim("omega_idler", "D")?)];
    let in_belt = substitute(&read("at the input", text)?, &speeds) / read("over", over)?;
    Ok(substitute(&in_belt, &[("v", read("v", "omega_in*D_in/2")?)]).factor())
}

/// I = 2 E/ω_in² of a kinetic energy.
fn inertia(energy: &str) -> Result<Atom, Error> {
    at_input(energy, "omega_in^2/2")
}

/// T = P/ω_in of a power.
fn torque(power: &str) -> Result<Atom, Error> {
    at_input(power, "omega_in")
}

/// Torques and inertia at the input.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn model() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("DriveSizingInput", INPUTS), &[], ("DriveSizingOutput", OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("D_in", "a diameter")?;
    plan.nonzero("D_out", "a diameter")?;
    let ratio = solve_linear(&read("n", "n*omega_out*D_in - omega_in*D_in")?, "n")?;
    let ratio = substitute(&ratio, &[("omega_in", read("n", "2*v/D_in")?), ("omega_out", read("n", "2*v/D_out")?)]);
    plan.derived("ratio", ratio.factor(), "(3.25)")?;
    plan.derived("load_inertia", inertia("(M_belt + M_load)*v^2/2")?, "(3.22)")?;
    let rotating = inertia("(I_p1 + I_idlers)*omega_in^2/2 + (I_RL + I_p2)*omega_out^2/2")?;
    plan.derived("rotating_inertia", rotating, "(3.21), (3.27)")?;
    plan.primitive("total_inertia", "rotating_inertia + load_inertia", "(3.21), (3.27)")?;
    plan.derived("external_torque", torque("F*v")?, "(3.23)")?;
    plan.derived("friction_torque", torque("F_f*v")?, "(3.24)")?;
    plan.derived("input_torque", torque("T_out*omega_out")?, "(3.26)")?;
    plan.primitive("steady_torque", "external_torque + friction_torque + input_torque", "3.3")?;
    plan.primitive("acceleration_torque", "total_inertia*alpha", "3.3")?;
    plan.primitive("drive_torque", "steady_torque + acceleration_torque", "3.3")?;
    Ok(sheet.finish("drive_sizing", "Torques and inertia at the input of a belt drive."))
}

/// Inertia of one idler at the input.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn idler() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("DriveSizingInput", INPUTS), &[], ("DriveSizingIdlerOutput", IDLER))?;
    sheet.plan.nonzero("D", "a diameter")?;
    sheet.plan.derived("reflected_inertia", inertia("I_idler*omega_idler^2/2")?, "(3.21)")?;
    Ok(sheet.finish("drive_sizing_idler", "Inertia of an idler at the input of a belt drive."))
}
