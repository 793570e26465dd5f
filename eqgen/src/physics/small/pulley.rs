//! The belt pulley of a drive line: a rigid belt that wraps a pulley, Euler's relation with centrifugal tension,
//! friction that is smooth in the sliding speed. The belt runs from branch A over the pulley to branch B where V_B > 0
//! and ω > 0.

use symbolica::atom::AtomCore;

use super::{Row, Sheet, row};
use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::physics::model::BoundaryModel;
use crate::plan::{Function, read};

const INPUTS: &[Row] = &[
    row("V_A", "V_A", "m/s", "velocity of branch A along its port").identity("VelocityA", ""),
    row("F_A", "F_A", "N", "tension of branch A").identity("TensionA", ""),
    row("V_B", "V_B", "m/s", "velocity of branch B, away from the pulley").identity("VelocityB", ""),
    row("F_B", "F_B", "N", "tension of branch B").identity("TensionB", ""),
    row("omega", "ω_S", "rad/s", "speed of the pulley").identity("ShaftSpeed", ""),
    row("alpha", "dω_S/dt", "rad/s^2", "angular acceleration of the pulley").identity("ShaftAcceleration", ""),
    row("T_S", "T_S", "N m", "torque of the pulley on its shaft").identity("ShaftTorque", ""),
    row("R", "R", "m", "radius of the pulley").identity("Radius", ""),
    row("J", "J", "kg m^2", "moment of inertia of the pulley").identity("Inertia", ""),
    row("b", "b", "N m s", "viscous damping of the bearing").identity("BearingDamping", ""),
    row("rho", "ρ", "kg/m", "mass per length of the belt").identity("MassPerLength", ""),
    row("wrap", "θ", "rad", "wrap angle").identity("WrapAngle", ""),
    row("f", "f", "", "coefficient of friction of belt on pulley; f' of a V-belt").identity("FrictionCoefficient", ""),
    row("V_thr", "V_thr", "m/s", "friction velocity threshold").identity("VelocityThreshold", ""),
    row("F_thr", "F_thr", "N", "force below which a branch counts as slack").identity("ForceThreshold", ""),
];

const STEPS: &[Row] = &[
    row("V_rel", "V_rel", "m/s", "velocity of the belt against the rim"),
    row("F_C", "F_C", "N", "centrifugal tension"),
    row("reached", "tanh(4 V_rel/V_thr)", "", "share of the friction that is reached"),
    row("mu", "μ", "", "instantaneous coefficient of friction"),
    row("euler", "e^(μ θ)", "", "Euler's ratio"),
    row("excess", "F_B − F_C", "N", "tension of branch B that presses the belt on the rim"),
    row("size", "", "N", "the excess's size, rounded off at the force threshold"),
    row("pressing", "", "N", "the excess where it is positive, 0 where it is not, rounded off at the force threshold"),
];

const OUTPUTS: &[Row] = &[
    row("opposite", "", "m/s", "the ends move in opposite directions: V_A + V_B"),
    row("equal", "", "m/s", "the ends move in the same direction: V_A − V_B"),
    row("adhesion", "", "m/s", "an ideal belt does not slip: V_B − ω R"),
    row("friction", "", "N", "Euler's relation between the tensions"),
    row("torque", "", "N m", "balance of moments on the pulley"),
    row("relative_velocity", "", "m/s", "velocity of the belt against the rim"),
    row("centrifugal_tension", "", "N", "centrifugal tension"),
    row("friction_coefficient", "", "", "instantaneous coefficient of friction"),
    row("belt_power", "", "W", "power that the branches deliver"),
    row("shaft_power", "", "W", "power that the shaft takes"),
    row("friction_loss", "", "W", "power lost to sliding"),
    row("bearing_loss", "", "W", "power lost in the bearing"),
    row("kinetic_power", "", "W", "power that accelerates the pulley"),
];

/// Moments on the pulley: branches, shaft, bearing.
pub const MOMENTS: &str = "(F_B - F_A)*R - T_S - b*omega - J*alpha";

/// The component's equations and its power balance.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn model() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("BeltPulleyInput", INPUTS), STEPS, ("BeltPulleyOutput", OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("V_thr", "a threshold is positive")?;
    plan.nonzero("excess^2 + F_thr^2", "a threshold is positive")?;
    plan.nonzero("size", "a threshold is positive")?;
    plan.primitive("V_rel", "V_B - omega*R", "V_rel")?;
    plan.primitive("F_C", "rho*V_B^2", "F_C")?;
    plan.apply("reached", Function::Tanh, &["4*V_rel/V_thr"], "μ")?;
    plan.primitive("mu", "-f*reached", "μ")?;
    plan.apply("euler", Function::Exp, &["mu*wrap"], "F_fr")?;
    plan.primitive("excess", "F_B - F_C", "F_fr")?;
    plan.apply("size", Function::Sqrt, &["excess^2 + F_thr^2"], "F_thr")?;
    plan.primitive("pressing", "(excess + size)/2", "F_thr")?;
    plan.primitive("opposite", "V_A + V_B", "belt direction")?;
    plan.primitive("equal", "V_A - V_B", "belt direction")?;
    plan.primitive("adhesion", "V_rel", "ideal belt")?;
    // (F_A − F_C) = (F_B − F_C) e^(μ θ) where the belt is tight; F_A = F_B where it is slack.
    plan.primitive("friction", "F_A - F_B - pressing*(euler - 1)", "F_fr")?;
    let torque = solve_linear(&read("T_S", MOMENTS)?, "T_S")?;
    plan.derived("torque", read("T_S", "T_S")? - torque.clone(), "T_S")?;
    plan.primitive("relative_velocity", "V_rel", "V_rel")?;
    plan.primitive("centrifugal_tension", "F_C", "F_C")?;
    plan.primitive("friction_coefficient", "mu", "μ")?;
    plan.primitive("belt_power", "(F_B - F_A)*V_B", "power")?;
    plan.derived("shaft_power", (torque * read("power", "omega")?).expand(), "power")?;
    plan.primitive("friction_loss", "(F_B - F_A)*V_rel", "power")?;
    plan.primitive("bearing_loss", "b*omega^2", "power")?;
    plan.primitive("kinetic_power", "J*alpha*omega", "power")?;
    Ok(sheet.finish("belt_pulley", "A pulley wrapped by a belt: residuals in its ports, and its power balance."))
}

const LIMIT_INPUTS: &[Row] = &[
    row("f_face", "f", "", "coefficient of friction of belt on sheave face").identity("FaceFriction", ""),
    row("groove", "Φ", "rad", "angle between the faces of a V-belt's sheave").identity("GrooveAngle", ""),
    row("f", "f", "", "coefficient of friction of belt on pulley; f' of a V-belt").identity("FrictionCoefficient", ""),
    row("wrap", "θ", "rad", "wrap angle").identity("WrapAngle", ""),
    row("T_tight", "T_1", "N", "tension of the tight branch less the centrifugal tension").identity("TightTension", ""),
    row("T_slack", "T_2", "N", "tension of the slack branch less the centrifugal tension").identity("SlackTension", ""),
    row("R", "R", "m", "radius of the pulley").identity("Radius", ""),
    row("V_thr", "V_thr", "m/s", "friction velocity threshold").identity("VelocityThreshold", ""),
];

const LIMIT_STEPS: &[Row] = &[
    row("ratio", "T_1/T_2", "", "tension ratio"),
    row("log_ratio", "", "", "logarithm of the tension ratio"),
    row("odds", "", "", "(1 + share)/(1 − share)"),
    row("log_odds", "", "", "logarithm of the odds"),
    row("capstan", "e^(f θ)", "", "largest tension ratio, computed first"),
    row("used", "", "", "share, computed first"),
];

const LIMITS: &[Row] = &[
    row("wedge_coefficient", "", "", "effective coefficient of friction of a V-belt, f'"),
    row("tension_ratio", "", "", "tension ratio"),
    row("largest_ratio", "", "", "tension ratio at which the whole contact slides: Euler's"),
    row("mean_coefficient", "", "", "coefficient of friction that the tension ratio takes on the whole contact"),
    row("share", "", "", "mean coefficient over the coefficient of friction"),
    row("creep", "", "m/s", "size of V_rel at which the smooth law reaches that share"),
    row("moment", "", "N m", "moment of the two tensions"),
];

/// What Euler's relation says of two tensions on a pulley.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn limits() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("BeltPulleyLimitInput", LIMIT_INPUTS), LIMIT_STEPS, ("BeltPulleyLimit", LIMITS))?;
    let plan = &mut sheet.plan;
    for (text, reason) in [
        ("sin(groove/2)", "a groove is open"),
        ("T_slack", "the belt is tight"),
        ("ratio", "the belt is tight"),
        ("wrap", "the belt wraps the pulley"),
        ("f", "there is friction"),
        ("1 - used", "the friction suffices"),
        ("odds", "the friction suffices"),
    ] {
        plan.nonzero(text, reason)?;
    }
    plan.primitive("ratio", "T_tight/T_slack", "F_fr")?;
    plan.apply("log_ratio", Function::Ln, &["ratio"], "F_fr")?;
    plan.apply("capstan", Function::Exp, &["f*wrap"], "F_fr")?;
    plan.primitive("wedge_coefficient", "f_face/sin(groove/2)", "f'")?;
    plan.primitive("tension_ratio", "ratio", "F_fr")?;
    plan.primitive("largest_ratio", "capstan", "F_fr")?;
    plan.primitive("mean_coefficient", "log_ratio/wrap", "F_fr")?;
    plan.primitive("used", "mean_coefficient/f", "μ")?;
    plan.primitive("share", "used", "μ")?;
    // artanh u = ½ ln((1 + u)/(1 − u))
    plan.primitive("odds", "(1 + used)/(1 - used)", "μ")?;
    plan.apply("log_odds", Function::Ln, &["odds"], "μ")?;
    plan.primitive("creep", "V_thr*log_odds/8", "μ")?;
    let moments = substitute(&read("moment", MOMENTS)?, &[("b", read("b", "0")?), ("J", read("J", "0")?)]);
    let branches = [("F_B", read("F_B", "T_tight")?), ("F_A", read("F_A", "T_slack")?)];
    plan.derived("moment", substitute(&solve_linear(&moments, "T_S")?, &branches), "T_S")?;
    Ok(sheet.finish("belt_pulley_limits", "How much of its friction a pair of tensions takes on a pulley."))
}
