//! What presses the sheaves together: flyweights and springs on the primary, a spring and a helix on the secondary.
//!
//! Every centrifugal mechanism without friction obeys one law of virtual work: turning at ω, masses at the radius r
//! whose radius changes by dr when the movable sheave closes by ds press with N m ω² r dr/ds. The kinds of mechanism
//! differ in how r follows from s; friction turns the force of each contact by its friction angle ρ, positive where the
//! sheave closes against friction and negative where it opens.
//!
//! (9.2) and (9.3) are the thesis's. Helix angles are measured from the plane of rotation.

use symbolica::atom::{Atom, AtomCore};

use super::{Row, Sheet, row};
use crate::derive::{solve_linear, substitute};
use crate::error::Error;
use crate::physics::model::BoundaryModel;
use crate::plan::{Function, read};

const COUNT: Row = row("N", "N", "", "number of flyweights").identity("Count", "");
const MASS: Row = row("m", "m", "kg", "mass of one flyweight").identity("Mass", "");
const SPEED: Row = row("omega", "ω", "rad/s", "speed of the pulley that carries the flyweights").identity("Speed", "");
const FRICTION: Row = row("rho", "ρ", "rad", "friction angle of the contact, negative where the sheave opens")
    .identity("FrictionAngle", "");
const TANGENT: Row = row("tan_rho", "tan ρ", "", "friction coefficient of the contact, with the sign of ρ");
const FORCE: Row =
    row("force", "F_fly", "N", "axial force of all flyweights on the movable sheave").identity("Force", "");

const TABLE_INPUTS: &[Row] = &[
    COUNT,
    MASS,
    SPEED,
    row("C", "C", "m", "r dr/ds of a flyweight, measured or from its mechanism; r sin θ of a bench")
        .identity("Coefficient", ""),
    row("lost", "f", "", "share of the force that friction takes, negative where the sheave opens")
        .identity("Lost", ""),
];

/// A flyweight of which only r dr/ds is known, as (9.2) states it.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn flyweight_table() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("FlyweightTableInput", TABLE_INPUTS), &[], ("FlyweightTableOutput", &[FORCE]))?;
    sheet.plan.primitive("force", "N*m*omega^2*C*(1 - lost)", "(9.2)")?;
    Ok(sheet
        .finish("flyweight_table", "Axial force of flyweights whose radius times its slope over the shift is known."))
}

const RAMP_INPUTS: &[Row] = &[
    COUNT,
    MASS,
    SPEED,
    row("r", "r", "m", "radius of a flyweight's centre of mass").identity("Radius", ""),
    row(
        "r_s",
        "dr/ds",
        "",
        "slope of that radius over the sheave's travel: 1/tan λ of a ramp inclined by λ against the radius",
    )
    .identity("RadiusSlope", ""),
    FRICTION,
];

/// A wedge or a roller that slides outwards along a radius against a ramp of the movable sheave.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn flyweight_ramp() -> Result<BoundaryModel, Error> {
    let steps = &[TANGENT, row("radial", "N m r ω²", "N", "centrifugal force of all flyweights")];
    let mut sheet = Sheet::new(("FlyweightRampInput", RAMP_INPUTS), steps, ("FlyweightRampOutput", &[FORCE]))?;
    let plan = &mut sheet.plan;
    plan.nonzero("cos(rho)", "a friction angle stays below 90°")?;
    plan.nonzero("1 + r_s*tan_rho", "the friction angle stays below the ramp's complement")?;
    plan.apply("tan_rho", Function::Tan, &["rho"], "ρ")?;
    plan.primitive("radial", "N*m*r*omega^2", "centrifugal force")?;
    // The contact's force is inclined by λ + ρ: F_fly tan(λ + ρ) = N m r ω², with tan λ = 1/r_s.
    let tangent = tangent_of_sum("1/r_s");
    let force = solve_linear(&(read("force", "F")? * tangent? - read("force", "radial")?), "F")?;
    plan.derived("force", force.factor(), "balance on the ramp")?;
    Ok(sheet.finish("flyweight_ramp", "Axial force of flyweights that slide along a radius against a ramp."))
}

/// tan(a + ρ) of an angle whose tangent is `tangent`.
fn tangent_of_sum(tangent: &str) -> Result<Atom, Error> {
    read("tan(a + ρ)", &format!("({tangent} + tan_rho)/(1 - ({tangent})*tan_rho)"))
}

const ARM_INPUTS: &[Row] = &[
    COUNT,
    MASS,
    SPEED,
    row("s", "s", "m", "travel of the movable sheave, positive where it closes").identity("Travel", ""),
    row("z_0", "z_0", "m", "axial distance from the arm's pivot to the roller's centre at s = 0").identity("Start", ""),
    row("R_pivot", "R_p", "m", "radius of the arm's pivot from the shaft").identity("PivotRadius", ""),
    row("R_roller", "R_r", "m", "radius of the roller's centre from the shaft").identity("RollerRadius", ""),
    row("l_m", "l_m", "m", "distance of the arm's centre of mass from its pivot").identity("MassDistance", ""),
    row("delta", "δ", "rad", "angle of the centre of mass in the arm").identity("MassAngle", ""),
    row(
        "xi",
        "ξ",
        "rad",
        "angle of the roller's centre in the arm at its present distance from the pivot: the cam's pitch curve",
    )
    .identity("PitchAngle", ""),
    row("xi_d", "dξ/dd", "rad/m", "slope of the pitch curve over the distance").identity("PitchSlope", ""),
    FRICTION,
];

const ARM_STEPS: &[Row] = &[
    TANGENT,
    row("z", "z", "m", "axial distance from the pivot to the roller's centre"),
    row("chi", "χ", "rad", "direction from the pivot to the roller's centre, from the shaft's axis outwards"),
    row("theta", "θ", "rad", "angle of the arm").identity("ArmAngle", ""),
    row("phi_m", "θ + δ", "rad", "direction from the pivot to the centre of mass, from the shaft's axis outwards"),
    row("sin_m", "sin(θ + δ)", "", "its sine"),
    row("cos_m", "cos(θ + δ)", "", "its cosine"),
    row("tan_e", "tan ε", "", "tangent of the angle from the line between pivot and roller to the pitch curve"),
    row("tan_t", "tan(ε + ρ)", "", "the same, turned by friction"),
];

const ARM_OUTPUTS: &[Row] = &[
    FORCE,
    row("distance", "d", "m", "distance from the pivot to the roller's centre, at which the pitch curve is to be read")
        .identity("Distance", ""),
    row("distance_s", "dd/ds", "", "its slope over the travel").identity("DistanceSlope", ""),
    row("radius", "r_m", "m", "radius of the centre of mass from the shaft").identity("Radius", ""),
    row("radius_s", "dr_m/ds", "", "its slope over the travel without friction").identity("RadiusSlope", ""),
    row("moment", "M_c", "N m", "moment of the centrifugal forces about the pivots").identity("Moment", ""),
];

/// A pivoted cam arm against a roller. The pitch curve ξ(d) is where the roller's centre may lie in the arm's own polar
/// coordinates about its pivot.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn flyweight_arm() -> Result<BoundaryModel, Error> {
    let mut sheet = Sheet::new(("FlyweightArmInput", ARM_INPUTS), ARM_STEPS, ("FlyweightArmOutput", ARM_OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("cos(rho)", "a friction angle stays below 90°")?;
    plan.nonzero("distance", "pivot and roller stand apart")?;
    plan.nonzero("(R_roller - R_pivot)^2 + z^2", "pivot and roller stand apart")?;
    plan.nonzero("1 - tan_e*tan_rho", "the friction angle stays below the pressure angle's complement")?;
    plan.apply("tan_rho", Function::Tan, &["rho"], "ρ")?;
    plan.primitive("z", "z_0 + s", "kinematics")?;
    plan.apply("distance", Function::Sqrt, &["(R_roller - R_pivot)^2 + z^2"], "kinematics")?;
    plan.apply("chi", Function::Angle, &["z", "R_roller - R_pivot"], "kinematics")?;
    plan.primitive("theta", "chi - xi", "kinematics")?;
    plan.primitive("phi_m", "theta + delta", "kinematics")?;
    plan.primitive("sin_m", "sin(phi_m)", "kinematics")?;
    plan.primitive("cos_m", "cos(phi_m)", "kinematics")?;
    plan.primitive("radius", "R_pivot + l_m*sin_m", "kinematics")?;
    plan.primitive("moment", "N*m*omega^2*radius*l_m*cos_m", "centrifugal moment")?;
    plan.primitive("tan_e", "distance*xi_d", "pitch curve")?;
    plan.derived("tan_t", tangent_of_sum("tan_e")?, "ρ")?;
    // d² = (R_r − R_p)² + z², so d dd/ds = z; and d χ' = −(R_r − R_p)/d.
    plan.primitive("distance_s", "z/distance", "kinematics")?;
    // The arm turns by dθ/ds = dχ/ds − ξ_d dd/ds; virtual work makes M_c dθ = F ds. With friction the contact's force
    // is turned by ρ, which turns ε into ε + ρ.
    let turn =
        |tangent: &str| read("dθ/ds", &format!("-((R_roller - R_pivot)/distance + {tangent}*z/distance)/distance"));
    let slope = read("slope", "l_m*cos_m")? * turn("tan_e")?;
    plan.derived("radius_s", slope, "kinematics")?;
    plan.derived("force", read("force", "moment")? * turn("tan_t")?, "virtual work")?;
    Ok(sheet.finish("flyweight_arm", "Axial force of pivoted cam arms that bear on rollers."))
}

const ROLLER_INPUTS: &[Row] = &[
    COUNT,
    MASS,
    SPEED,
    row("theta", "θ", "rad", "angle of the arm from the shaft's axis outwards, pivot to roller")
        .identity("ArmAngle", ""),
    row("R_pivot", "R_p", "m", "radius of the arm's pivot from the shaft").identity("PivotRadius", ""),
    row("l_roller", "l_r", "m", "distance of the roller's centre from the pivot").identity("ArmLength", ""),
    row("l_m", "l_m", "m", "distance of the arm's centre of mass from its pivot").identity("MassDistance", ""),
    row("delta", "δ", "rad", "angle from the line to the roller to that to the centre of mass")
        .identity("MassAngle", ""),
    row("h", "h", "m", "radius from the shaft to which the ramp lets the roller's centre, where the roller is")
        .identity("RampRadius", ""),
    row("h_x", "dh/dx", "", "slope of that radius along the ramp").identity("RampSlope", ""),
    FRICTION,
];

const ROLLER_STEPS: &[Row] = &[
    TANGENT,
    row("sin_r", "sin θ", "", "sine of the arm's angle"),
    row("cos_r", "cos θ", "", "cosine of the arm's angle"),
    row("h_t", "", "", "slope of the ramp, turned by friction"),
];

const ROLLER_OUTPUTS: &[Row] = &[
    FORCE,
    row("gap", "", "m", "radius that the roller's centre has beyond the ramp: zero where it bears on it")
        .identity("Gap", ""),
    row("along", "", "m", "how far the roller's centre lies from the pivot along the shaft").identity("Along", ""),
    row("theta_s", "dθ/ds", "rad/m", "turn of the arm over the travel, without friction").identity("AngleSlope", ""),
    row("radius", "r_m", "m", "radius of the centre of mass from the shaft").identity("Radius", ""),
    row("radius_s", "dr_m/ds", "", "its slope over the travel without friction").identity("RadiusSlope", ""),
    row("moment", "M_c", "N m", "moment of the centrifugal forces about the pivots").identity("Moment", ""),
];

/// A pivoted arm whose roller bears on a ramp of the movable sheave: at the travel s the roller stands at
/// x = x_0 + s − l_r cos θ on the ramp.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn flyweight_roller() -> Result<BoundaryModel, Error> {
    let mut sheet =
        Sheet::new(("FlyweightRollerInput", ROLLER_INPUTS), ROLLER_STEPS, ("FlyweightRollerOutput", ROLLER_OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("l_roller", "the roller stands off the pivot")?;
    plan.nonzero("cos(rho)", "a friction angle stays below 90°")?;
    plan.nonzero("1 + h_x*tan_rho", "the friction angle stays below the ramp's complement")?;
    plan.nonzero("cos_r - h_x*sin_r", "the arm is not at right angles to the ramp")?;
    plan.nonzero("cos_r - h_t*sin_r", "the arm is not at right angles to the ramp, friction included")?;
    plan.apply("tan_rho", Function::Tan, &["rho"], "ρ")?;
    plan.primitive("sin_r", "sin(theta)", "kinematics")?;
    plan.primitive("cos_r", "cos(theta)", "kinematics")?;
    plan.primitive("gap", "R_pivot + l_roller*sin_r - h", "contact")?;
    plan.primitive("along", "l_roller*cos_r", "kinematics")?;
    plan.primitive("radius", "R_pivot + l_m*sin(theta + delta)", "kinematics")?;
    plan.primitive("moment", "N*m*omega^2*radius*l_m*cos(theta + delta)", "centrifugal moment")?;
    plan.primitive("h_t", "(h_x - tan_rho)/(1 + h_x*tan_rho)", "ρ")?;
    // The roller stays on the ramp: l_r cos θ θ' = h_x (1 + l_r sin θ θ').
    let turn = |slope: &str| {
        let contact = format!("l_roller*cos_r*p - {slope}*(1 + l_roller*sin_r*p)");
        solve_linear(&read("dθ/ds", &contact)?, "p")
    };
    plan.derived("theta_s", turn("h_x")?, "contact")?;
    plan.derived("radius_s", read("slope", "l_m*cos(theta + delta)")? * turn("h_x")?, "kinematics")?;
    plan.derived("force", read("force", "moment")? * turn("h_t")?, "virtual work")?;
    Ok(sheet
        .finish("flyweight_roller", "Axial force of pivoted arms whose rollers bear on ramps of the movable sheave."))
}

const SPRING_INPUTS: &[Row] = &[
    row("F_0", "F_0", "N", "force of the spring at s = 0").identity("Preload", ""),
    row("c", "c", "N/m", "rate of the spring").identity("Rate", ""),
    row("s", "s", "m", "travel by which the spring is compressed further").identity("Travel", ""),
];

/// A compression spring.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn spring() -> Result<BoundaryModel, Error> {
    const OUTPUTS: &[Row] = &[
        row("force", "F_spring", "N", "force of the spring").identity("Force", ""),
        row("energy", "", "N m", "energy taken since s = 0").identity("Energy", ""),
    ];
    let mut sheet = Sheet::new(("CompressionSpringInput", SPRING_INPUTS), &[], ("CompressionSpringOutput", OUTPUTS))?;
    sheet.plan.primitive("force", "F_0 + c*s", "(9.3)")?;
    sheet.plan.primitive("energy", "F_0*s + c*s^2/2", "energy")?;
    Ok(sheet.finish("compression_spring", "Force of a compression spring."))
}

const HELIX_INPUTS: &[Row] = &[
    row("kappa", "κ_t", "N m/rad", "rate of the spring in torsion").identity("TorsionRate", ""),
    row("phi_0", "φ_0", "rad", "angle by which the spring is wound up when installed").identity("Pretension", ""),
    row("phi", "φ", "rad", "angle by which the movable sheave has turned on its helix").identity("Turn", ""),
    row("r_h", "r_h", "m", "radius of the helix").identity("Radius", ""),
    row("tan_alpha", "tan α", "", "tangent of the helix angle, measured from the plane of rotation")
        .identity("Tangent", ""),
    row("share", "ζ", "", "share of the torque that the movable sheave carries").identity("Share", ""),
    row("M", "M", "N m", "torque of the belt on the secondary").identity("Torque", ""),
    FRICTION,
];

/// A helix that turns torque into axial force.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn helix() -> Result<BoundaryModel, Error> {
    const OUTPUTS: &[Row] = &[
        row("torque", "T_h", "N m", "torque that the helix carries").identity("Torque", ""),
        row("force", "F_helix", "N", "axial force of the helix on the movable sheave, positive where it closes")
            .identity("Force", ""),
        row("turn", "dφ/ds", "rad/m", "turn of the movable sheave over its travel").identity("TurnSlope", ""),
    ];
    let mut sheet = Sheet::new(("HelixInput", HELIX_INPUTS), &[TANGENT], ("HelixOutput", OUTPUTS))?;
    let plan = &mut sheet.plan;
    plan.nonzero("r_h", "a radius")?;
    plan.nonzero("cos(rho)", "a friction angle stays below 90°")?;
    plan.nonzero("tan_alpha", "a helix is inclined")?;
    plan.nonzero("tan_alpha + tan_rho", "the friction angle of opening stays below the helix angle")?;
    plan.apply("tan_rho", Function::Tan, &["rho"], "ρ")?;
    plan.primitive("torque", "share*M + kappa*(phi_0 + phi)", "moments on the movable sheave")?;
    // A flank inclined by α + ρ: F r_h tan(α + ρ) = T_h.
    let balance = read("force", "F*r_h")? * tangent_of_sum("tan_alpha")? - read("force", "torque")?;
    plan.derived("force", solve_linear(&balance, "F")?.factor(), "balance on the helix")?;
    plan.derived("turn", solve_linear(&read("turn", "1 - p*r_h*tan_alpha")?, "p")?, "kinematics")?;
    Ok(sheet.finish("helix", "Axial force of a helix and its torsion spring."))
}

const TRAVEL_INPUTS: &[Row] = &[
    row("beta", "β", "rad", "half angle of the groove").identity("HalfAngle", ""),
    row("R", "R", "m", "radius of the belt on the pulley").identity("Radius", ""),
    row("R_0", "R_0", "m", "radius of the belt where the travel is zero").identity("Start", ""),
];

/// Travel of the one movable sheave of a pulley: the groove's two faces move apart by 2 tan β for each radius.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn travel() -> Result<BoundaryModel, Error> {
    let steps = &[row("tan_beta", "tan β", "", "tangent of the half angle")];
    const OUTPUTS: &[Row] =
        &[row("travel", "s", "m", "axial travel of the movable sheave, positive where it closes")
            .identity("Travel", "")];
    let mut sheet = Sheet::new(("SheaveTravelInput", TRAVEL_INPUTS), steps, ("SheaveTravelOutput", OUTPUTS))?;
    sheet.plan.nonzero("cos(beta)", "a groove is open")?;
    sheet.plan.apply("tan_beta", Function::Tan, &["beta"], "β")?;
    sheet.plan.primitive("travel", "2*tan_beta*(R - R_0)", "(9.2)")?;
    Ok(sheet.finish("sheave_travel", "Travel of a movable sheave from the belt's radius."))
}

const VEHICLE_INPUTS: &[Row] = &[
    row("omega_S", "ω_S", "rad/s", "speed of the secondary").identity("SecondarySpeed", ""),
    row("i_f", "i_f", "", "turns of the secondary for a turn of the wheel").identity("FinalRatio", ""),
    row("r_w", "r_w", "m", "rolling radius of the wheel").identity("WheelRadius", ""),
    row("m_v", "m_v", "kg", "mass of the vehicle with its driver").identity("Mass", ""),
    row("g_0", "g", "m/s^2", "acceleration of gravity").identity("Gravity", ""),
    row("c_r", "c_r", "", "coefficient of rolling resistance").identity("RollingResistance", ""),
    row("tan_slope", "tan α_g", "", "grade of the ground, rise over run").identity("Grade", ""),
    row("rho_air", "ρ_air", "kg/m^3", "density of the air").identity("AirDensity", ""),
    row("CdA", "C_d A", "m^2", "drag area").identity("DragArea", ""),
    row("eta_f", "η_f", "", "efficiency of the final drive").identity("FinalEfficiency", ""),
    row("a", "a", "m/s^2", "acceleration of the vehicle").identity("Acceleration", ""),
];

/// What the road asks of the secondary.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn vehicle() -> Result<BoundaryModel, Error> {
    let steps = &[
        row("tilt", "", "", "square of 1/cos of the grade's angle"),
        row("incline", "1/cos α_g", "", "length of the road over its run"),
    ];
    const OUTPUTS: &[Row] = &[
        row("speed", "v", "m/s", "speed of the vehicle").identity("Speed", ""),
        row("resistance", "", "N", "force of rolling, grade and air against the vehicle").identity("Resistance", ""),
        row("torque", "", "N m", "torque that the vehicle takes from the secondary").identity("Torque", ""),
        row("torque_a", "", "kg m", "change of that torque with acceleration").identity("TorquePerAcceleration", ""),
    ];
    let mut sheet = Sheet::new(("VehicleLoadInput", VEHICLE_INPUTS), steps, ("VehicleLoadOutput", OUTPUTS))?;
    let plan = &mut sheet.plan;
    for (text, reason) in
        [("i_f", "a ratio"), ("eta_f", "an efficiency"), ("incline", "at least one"), ("tilt", "at least one")]
    {
        plan.nonzero(text, reason)?;
    }
    plan.primitive("tilt", "1 + tan_slope^2", "grade")?;
    plan.apply("incline", Function::Sqrt, &["tilt"], "grade")?;
    plan.primitive("speed", "omega_S*r_w/i_f", "kinematics")?;
    plan.primitive("resistance", "m_v*g_0*(c_r + tan_slope)/incline + rho_air*CdA*speed^2/2", "resistance")?;
    // Power: η_f M ω_S = (resistance + m a) v.
    let power = read("power", "eta_f*M*omega_S - (resistance + m_v*a)*v")?;
    let power = substitute(&power, &[("v", read("power", "omega_S*r_w/i_f")?)]);
    let torque = solve_linear(&power, "M")?.factor();
    plan.derived("torque", torque.clone(), "power")?;
    plan.derived("torque_a", derivative(&torque, "a"), "power")?;
    Ok(sheet.finish("vehicle_load", "Torque that a vehicle takes from the secondary."))
}

fn derivative(value: &Atom, name: &str) -> Atom {
    value.derivative(symbolica::symbol!(name))
}
