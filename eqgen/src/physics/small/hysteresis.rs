//! Hysteresis of a belt that runs around: what is followed along the material, what a harmonic of it dissipates, and
//! the balance of power with all losses.
//!
//! S is the unstretched coordinate along the belt. A piece of belt passes every place of the loop in turn, so that what
//! it is subjected to is periodic in S with the loop's unstretched length L_0, and passes G/(m_o L_0) times a second.

use symbolica::atom::{Atom, AtomCore};
use symbolica::symbol;

use super::{Row, Sheet, row};
use crate::derive::{on_path, substitute, total_derivative};
use crate::error::Error;
use crate::physics::beam::Bending;
use crate::physics::kinematics::{ARC, SLOPE, add_stretch, stretch};
use crate::physics::model::BoundaryModel;
use crate::plan::{Plan, read};

const SHARED: [Row; 5] = [
    row("flow", "g", "", "mass flow over that of an unstretched belt at the primary's nominal speed"),
    row("EA", "EA", "N", "longitudinal stiffness"),
    row("m_o", "m_o", "kg/m", "mass per length, unloaded"),
    row("R_P", "R_P", "m", "nominal radius of the primary"),
    row("omega_P", "ω_P", "rad/s", "angular speed of the primary"),
];

const CONTACT_INPUTS: &[Row] = &[
    row("T", "T", "N", "tractive tension"),
    row("theta", "θ", "rad", "inclination of the belt"),
    row("theta1", "θ̂'", "rad", "first derivative of θ along the region"),
    row("theta2", "θ̂''", "rad", "second derivative of θ along the region"),
    row("x", "x", "m", "radial penetration"),
    row("T_hat_1", "T̂'", "N", "derivative of T along the region"),
    row("Phi", "Φ", "rad", "wrap angle"),
    row("R", "R", "m", "nominal radius of the pulley"),
    SHARED[0],
    SHARED[1],
    SHARED[2],
    SHARED[3],
    SHARED[4],
];

const SPAN_INPUTS: &[Row] = &[
    row("tau", "τ", "N", "tractive tension"),
    row("vartheta1", "ϑ̂'", "rad", "first derivative of ϑ along the span"),
    row("vartheta2", "ϑ̂''", "rad", "second derivative of ϑ along the span"),
    row("tau_hat_1", "τ̂'", "N", "derivative of τ along the span"),
    row("L", "L", "m", "arc length of the span"),
    SHARED[0],
    SHARED[1],
    SHARED[2],
    SHARED[3],
    SHARED[4],
];

/// What is followed in a groove; a span has all but the penetration's slope.
const CONTACT_OUTPUTS: &[Row] = &[
    row("material", "dS/dŝ", "m", "unstretched length passed along the region"),
    row("curvature", "κ", "rad/m", "curvature of the belt, M_b/EI"),
    row("curvature_slope", "dκ/dS", "rad/m^2", "its slope along the unstretched belt"),
    row("strain", "ε", "", "strain of the cord, F/EA"),
    row("strain_slope", "dε/dS", "1/m", "its slope along the unstretched belt"),
    row("penetration_slope", "dx/dS", "", "slope of the penetration along the unstretched belt"),
];

const WEIGHT_INPUTS: &[Row] = &[
    SHARED[0],
    SHARED[1],
    SHARED[2],
    SHARED[3],
    SHARED[4],
    row("EI", "EI", "N m^2", "bending stiffness"),
    row("k", "k", "N/m^2", "radial stiffness"),
    row("beta", "β", "rad", "half angle of the sheave's groove"),
    row("L_0", "L_0", "m", "unstretched length of the loop"),
];

const WEIGHT_OUTPUTS: &[Row] = &[
    row("revolutions", "f_1", "1/s", "revolutions of the belt a second, G/(m_o L_0)"),
    row("bending", "", "W m^2", "power that bending loses, over tan δ_n |B_n|²/n, B_n of the curvature"),
    row(
        "groove",
        "",
        "W/m^2",
        "power that the groove's squeezing loses, over tan δ_n |B_n|²/n, B_n of the penetration",
    ),
    row("cord", "", "W", "power that the cord's stretching loses, over tan δ_n |B_n|²/n, B_n of the strain"),
];

const BALANCE_INPUTS: &[Row] = &[
    row("driving", "P_1", "W", "power that the driving pulley takes in"),
    row(
        "overall",
        "η",
        "",
        "power that the driven pulley gives, but for the losses here, over that which the driving one takes",
    ),
    row("hysteresis", "P_h", "W", "power that hysteresis takes"),
    row("omega_P", "ω_P", "rad/s", "speed of the primary"),
    row("omega_S", "ω_S", "rad/s", "speed of the secondary"),
    row("drag_P", "M_dP", "N m", "torque that drags at the primary at every speed"),
    row("drag_S", "M_dS", "N m", "torque that drags at the secondary at every speed"),
    row("viscous_P", "c_P", "N m s", "torque that drags at the primary, per speed"),
    row("viscous_S", "c_S", "N m s", "torque that drags at the secondary, per speed"),
    row("gear_efficiency", "η_g", "", "efficiency of what stands between the secondary and the shaft of interest"),
];

const BALANCE_STEPS: &[Row] =
    &[row("driven", "P_2", "W", "power that the driven pulley gives, but for the losses here")];

const BALANCE_OUTPUTS: &[Row] = &[
    row("primary_drag", "", "W", "power that drags at the primary"),
    row("secondary_drag", "", "W", "power that drags at the secondary"),
    row("gears", "", "W", "power lost between the secondary and the shaft of interest"),
    row("total", "", "W", "power that hysteresis, drag and gears take"),
    row("delivered", "", "W", "power that arrives"),
    row("efficiency", "", "", "power that arrives over power that goes in"),
];

/// All of it, in the order in which it is emitted.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn models() -> Result<[BoundaryModel; 4], Error> {
    Ok([contact()?, span()?, weights()?, balance()?])
}

/// F/EA, and how it changes with S as the tractive tension does.
fn add_strain(plan: &mut Plan, tractive: &str, rate: &str) -> Result<(), Error> {
    let (tension, _) = stretch(tractive)?;
    let slope = tension.derivative(symbol!(tractive)) * read("rate", rate)? / read("rate", "material*EA")?;
    plan.primitive("strain", "F/EA", "(3.9)")?;
    plan.derived("strain_slope", slope.factor(), "(3.9), (3.10)")
}

fn contact() -> Result<BoundaryModel, Error> {
    let mut sheet =
        Sheet::new(("HysteresisContactInput", CONTACT_INPUTS), &[], ("HysteresisContactOutput", CONTACT_OUTPUTS))?;
    let plan = &mut sheet.plan;
    for (text, reason) in [
        ("Phi", "the belt wraps around the pulley"),
        ("arc", "the belt runs around the pulley's centre"),
        ("stretch", "the belt is not compressed to nothing"),
        ("material", "the belt runs around the pulley's centre"),
        ("R - x", "x stays far below R"),
        ("cos(theta)", "a belt at θ = ±90° would point at the pulley's centre"),
    ] {
        plan.nonzero(text, reason)?;
    }
    plan.primitive("theta_1", "theta1/Phi", "(5.2)")?;
    plan.primitive("theta_2", "theta2/Phi^2", "(5.3)")?;
    plan.primitive("arc", ARC, "(3.4)")?;
    add_stretch(plan, "T")?;
    plan.primitive("stretch", "(EA + F)/EA", "(3.9)")?;
    plan.primitive("material", "Phi*arc/stretch", "(5.55)")?;
    let (slope, arc) = (read("x_1", SLOPE)?, read("arc", ARC)?);
    let along_belt = |rate: Atom| read("stretch", "stretch").map(|stretch| rate / &arc * stretch);
    let bending = Bending::derive()?;
    let turn = on_path(&total_derivative(&bending.curvature)?, &slope)?;
    plan.derived("curvature", bending.curvature, "(3.26)")?;
    plan.derived("curvature_slope", along_belt(turn)?.factor(), "(3.26), (3.9)")?;
    plan.derived("penetration_slope", along_belt(slope.clone())?.factor(), "(3.24), (3.9)")?;
    add_strain(plan, "T", "T_hat_1")?;
    Ok(sheet.finish("hysteresis_contact", "What hysteresis follows along the belt in a groove."))
}

fn span() -> Result<BoundaryModel, Error> {
    let outputs = CONTACT_OUTPUTS.split_last().map_or(CONTACT_OUTPUTS, |(_, rest)| rest);
    let mut sheet = Sheet::new(("HysteresisSpanInput", SPAN_INPUTS), &[], ("HysteresisSpanOutput", outputs))?;
    let plan = &mut sheet.plan;
    plan.nonzero("L", "a span has a length")?;
    plan.nonzero("stretch", "the belt is not compressed to nothing")?;
    plan.nonzero("material", "a span has a length")?;
    add_stretch(plan, "tau")?;
    plan.primitive("stretch", "(EA + F)/EA", "(3.9)")?;
    plan.primitive("material", "L/stretch", "(5.56)")?;
    plan.primitive("curvature", "vartheta1/L", "(5.10)")?;
    plan.primitive("curvature_slope", "vartheta2/L^2*stretch", "(5.11), (3.9)")?;
    add_strain(plan, "tau", "tau_hat_1")?;
    Ok(sheet.finish("hysteresis_span", "What hysteresis follows along the free belt."))
}

/// Power per tan δ_n |B_n|²/n of a field whose energy per length is `energy` in `field`.
///
/// A cycle of amplitude a_n costs π K tan δ a_n² per length; there are n cycles a revolution, and L_0 of belt. As the
/// amplitude of the field is that of its slope over the wave number 2πn/L_0, a_n = |B_n|/(πn).
fn weight(energy: &str, field: &str) -> Result<Atom, Error> {
    let variable = symbol!(field);
    let stiffness = read("energy", energy)?.derivative(variable).derivative(variable);
    let per_cycle = read("cycle", "pi*stiffness*tan_delta*amplitude^2")?;
    let power = per_cycle * read("passes", "n*revolutions*L_0")?;
    let amplitude = read("amplitude", "integral/(pi*n)")?;
    let power = substitute(&power, &[("amplitude", amplitude), ("stiffness", stiffness)]);
    Ok((power / read("over", "tan_delta*integral^2/n")?).factor())
}

fn weights() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("HysteresisInput", WEIGHT_INPUTS), &[], ("HysteresisOutput", WEIGHT_OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("m_o", "a belt has mass")?;
    plan.nonzero("L_0", "a belt has a length")?;
    plan.nonzero("cos(beta)", "a groove is not flat")?;
    plan.primitive("G", "flow*m_o*R_P*omega_P", "definition of the flow coefficient")?;
    plan.primitive("revolutions", "G/(m_o*L_0)", "(3.5)")?;
    plan.derived("bending", weight("EI*a^2/2", "a")?, "(3.26)")?;
    plan.derived("groove", weight("k*sin(beta)/cos(beta)*a^2/2", "a")?, "(3.16)")?;
    plan.derived("cord", weight("EA*a^2/2", "a")?, "(3.9)")?;
    Ok(sheet.finish("hysteresis", "Power that a harmonic of what runs around with the belt loses."))
}

fn balance() -> Result<BoundaryModel, Error> {
    let mut sheet =
        Sheet::new(("LossBalanceInput", BALANCE_INPUTS), BALANCE_STEPS, ("LossBalanceOutput", BALANCE_OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("driving", "the drive is driven")?;
    plan.primitive("driven", "overall*driving", "(6.9)")?;
    plan.primitive("primary_drag", "(drag_P + viscous_P*omega_P)*omega_P", "drag")?;
    plan.primitive("secondary_drag", "(drag_S + viscous_S*omega_S)*omega_S", "drag")?;
    plan.primitive("gears", "(1 - gear_efficiency)*(driven - hysteresis - primary_drag - secondary_drag)", "gears")?;
    plan.primitive("total", "hysteresis + primary_drag + secondary_drag + gears", "balance of power")?;
    plan.primitive("delivered", "driven - total", "balance of power")?;
    plan.primitive("efficiency", "overall - total/driving", "(6.9) with losses")?;
    Ok(sheet.finish("loss_balance", "What arrives once hysteresis, drag and gears have had their share."))
}
