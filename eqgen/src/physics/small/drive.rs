//! The simple belt drive: where the belt enters a pulley it adheres, towards the exit it slides, and nowhere does it
//! move up or down its groove. Numbers without a point are those of Z. Wang, *Belt Velocity Initialization* (2012);
//! those from 2.211 to 2.221 are of the work that it continues, rebuilt from what it says of them.
//!
//! I is the input pulley, O the output pulley; L is the longitudinal force, v_0 the speed of the unstretched belt.
//! Torques are those of the belt on the pulleys in the direction of rotation: M_O > 0 > M_I where the input drives.

use symbolica::atom::{Atom, AtomCore};

use super::{Row, Sheet, Table, row};
use crate::derive::{Quadratic, linear_in, quadratic_in, solve_linear, substitute};
use crate::error::Error;
use crate::physics::model::BoundaryModel;
use crate::plan::{Function, read};

/// Speeds, torques, forces, v_0, then the drive.
const INPUTS: &[Row] = &[
    row("omega_I", "ω_I", "rad/s", "speed of the input pulley").identity("InputSpeed", ""),
    row("omega_O", "ω_O", "rad/s", "speed of the output pulley").identity("OutputSpeed", ""),
    row("M_I", "M_I", "N m", "torque of the belt on the input pulley, negative where it drives")
        .identity("InputTorque", ""),
    row("M_O", "M_O", "N m", "torque of the belt on the output pulley, positive where it is driven")
        .identity("OutputTorque", ""),
    row("F_CI", "F_CI", "N", "axial force on the input pulley").identity("InputAxialForce", ""),
    row("F_CO", "F_CO", "N", "axial force on the output pulley").identity("OutputAxialForce", ""),
    row("v_0", "v_0", "m/s", "speed of the unstretched belt").identity("BeltSpeed", ""),
    row("u", "r ω", "m/s", "speed of both rims at no torque (2.219)").identity("RimSpeed", ""),
    row("r_I", "r_I", "m", "radius of the input pulley").identity("InputRadius", ""),
    row("r_O", "r_O", "m", "radius of the output pulley").identity("OutputRadius", ""),
    row("phi_O", "φ", "rad", "half the contact angle on the output pulley; on the input pulley it is π − φ")
        .identity("HalfContactAngle", ""),
    row("EA", "EA", "N", "longitudinal stiffness of the belt").identity("LongitudinalStiffness", ""),
    row("m_star", "m*", "kg/m", "mass per length of the unstretched belt").identity("MassPerLength", ""),
    row("mu_star", "μ*", "", "coefficient of friction in the groove; negative where the output drives")
        .identity("GrooveFriction", ""),
    row("delta_0", "δ_0", "rad", "half angle of the groove").identity("HalfAngle", ""),
];

const STEPS: &[Row] = &[
    row("tan_delta", "tan δ_0", "", "tangent of the half angle"),
    row("K", "K", "N", "longitudinal force at which the belt lifts off"),
    row("L_Oin", "L_Oin", "N", "longitudinal force where the belt enters the output pulley"),
    row("L_Iin", "L_Iin", "N", "longitudinal force where the belt enters the input pulley"),
    row("ratio_O", "e^(μ* Φ_O)", "", "ratio of the forces in excess of K, exit over entry of the output pulley"),
    row("ratio_I", "e^(−μ* Φ_I)", "", "ratio of the forces in excess of K, exit over entry of the input pulley"),
    row("log_O", "μ* Φ_O", "", "logarithm of ratio_O"),
    row("log_I", "−μ* Φ_I", "", "logarithm of ratio_I"),
    row("Phi_O", "Φ_O", "rad", "angle on which the belt slides on the output pulley"),
    row("Phi_I", "Φ_I", "rad", "angle on which the belt slides on the input pulley"),
];

const RESIDUALS: &[Row] = &[
    row("speed_O", "", "m/s", "speeds and M_O (2)").identity("OutputSpeedBalance", ""),
    row("speed_I", "", "m/s", "speeds and M_I (18)").identity("InputSpeedBalance", ""),
    row("axial_O", "", "N", "axial force on the output pulley (5)").identity("OutputAxialBalance", ""),
    row("axial_I", "", "N", "axial force on the input pulley (13)").identity("InputAxialBalance", ""),
];

const CLOSED_STEPS: &[Row] = &[
    row("a_O", "", "kg/s", "quadratic coefficient of (6)"),
    row("a_I", "", "kg/s", "quadratic coefficient of (14)"),
    row("b_O", "", "N", "linear coefficient of (6)"),
    row("b_I", "", "N", "linear coefficient of (14)"),
    row("c_O", "", "W", "constant coefficient of (6)"),
    row("c_I", "", "W", "constant coefficient of (14)"),
    row("root_O", "", "N", "root of the discriminant of (6)"),
    row("root_I", "", "N", "root of the discriminant of (14)"),
];

const CLOSED: &[Row] = &[
    row("v_0_O", "", "m/s", "v_0 at no torque, from F_CO and r ω (2.220)").identity("BeltSpeedFromOutputForce", ""),
    row("v_0_I", "", "m/s", "v_0 at no torque, from F_CI and r ω (15)").identity("BeltSpeedFromInputForce", ""),
    row("omega_O_of_M_O", "", "rad/s", "ω_O from ω_I, M_O and v_0 (21)").identity("OutputSpeedFromTorque", ""),
    row("omega_I_of_M_O", "", "rad/s", "ω_I from ω_O, M_O and v_0 (2)").identity("InputSpeedFromTorque", ""),
    row("M_O_of_speeds", "", "N m", "M_O from both speeds and v_0 (17)").identity("OutputTorqueFromSpeeds", ""),
    row("M_I_of_speeds", "", "N m", "M_I from both speeds and v_0 (19)").identity("InputTorqueFromSpeeds", ""),
    row("M_O_of_M_I", "", "N m", "M_O from M_I (11)").identity("OutputTorqueFromInput", ""),
    row("M_I_of_M_O", "", "N m", "M_I from M_O (20)").identity("InputTorqueFromOutput", ""),
    row("lift_off", "", "N", "longitudinal force at which the belt lifts off, K").identity("LiftOffForce", ""),
    row("slack_force", "", "N", "longitudinal force where the belt enters the output pulley (2.218)"),
    row("tight_force", "", "N", "longitudinal force where the belt enters the input pulley (7)"),
    row("slack_tension", "", "N", "tractive tension where the belt enters the output pulley"),
    row("tight_tension", "", "N", "tractive tension where the belt enters the input pulley"),
    row("sliding_O", "", "rad", "Φ_O from both speeds and v_0 (22)").identity("OutputSlidingAngle", ""),
    row("sliding_I", "", "rad", "Φ_I from both speeds and v_0 (25)").identity("InputSlidingAngle", ""),
    row("F_CO_of_speeds", "", "N", "F_CO from both speeds and v_0 (23)").identity("OutputForceFromSpeeds", ""),
    row("F_CI_of_speeds", "", "N", "F_CI from both speeds and v_0 (26)").identity("InputForceFromSpeeds", ""),
    row("F_slip_O", "", "N", "F_CO at which the belt slides on all of the output pulley, from M_O and v_0")
        .identity("OutputSlipForce", ""),
    row("F_slip_I", "", "N", "F_CI at which the belt slides on all of the input pulley, from M_I and v_0")
        .identity("InputSlipForce", ""),
];

/// The pulleys: suffix, half contact angle, sign of friction on the sliding arc.
const OUTPUT: Side = Side { suffix: "O", half: "phi_O", friction: "mu_star" };
const INPUT: Side = Side { suffix: "I", half: "(pi - phi_O)", friction: "(-mu_star)" };

/// One of the two pulleys.
#[derive(Debug, Clone, Copy)]
struct Side {
    suffix: &'static str,
    /// Half the contact angle.
    half: &'static str,
    /// dL/dθ over L − K where the belt slides (2.211): L rises along the output pulley and falls along the input
    /// pulley.
    friction: &'static str,
}

/// Excess of a force over that which centrifugal force takes, per angle: what presses the belt into the groove.
const LOAD: &str = "L - m_star*v_0^2*(1 + L/EA)";

/// K: the longitudinal force under which nothing presses the belt into the groove.
///
/// # Errors
/// If the relation cannot be solved.
pub fn lift_off() -> Result<Atom, Error> {
    solve_linear(&read("K", LOAD)?, "L")
}

/// L where the belt adheres to a rim of that speed: a stretched belt is faster by its strain, (2.214), (2.218), (7).
///
/// # Errors
/// If the relation cannot be solved.
pub fn adhering(rim: &str) -> Result<Atom, Error> {
    solve_linear(&read("L", &format!("{rim} - v_0*(1 + L/EA)"))?, "L")
}

impl Side {
    /// What stands for `#`, `half` and `friction` in a text.
    fn read(self, text: &str) -> Result<Atom, Error> {
        let text = text.replace('#', self.suffix).replace("half", self.half).replace("friction", self.friction);
        read(self.suffix, &text)
    }

    /// M − r (L_out − L_in), (9), (10); the loop closes: each pulley's exit force is the other's entry force.
    fn torque(self) -> Result<Atom, Error> {
        let (out, into) = if self.suffix == "O" { ("L_Iin", "L_Oin") } else { ("L_Oin", "L_Iin") };
        self.read(&format!("M_# - r_#*({out} - {into})"))
    }

    /// The torque balance in speeds: M − r (L_out − L_in) with L as the belt adheres.
    fn torque_of_speeds(self) -> Result<Atom, Error> {
        let entries = [("L_Oin", adhering("r_O*omega_O")?), ("L_Iin", adhering("r_I*omega_I")?)];
        Ok(substitute(&self.torque()?, &entries))
    }

    /// e^(μ* Φ), as the torque has it (2.216), (10): L − K at the exit over L − K at the entry.
    fn ratio(self) -> Result<Atom, Error> {
        let out = solve_linear(&self.read("M_# - r_#*(L_out - L_#in)")?, "L_out")?;
        Ok(substitute(&self.read("(L_out - K)/(L_#in - K)")?, &[("L_out", out)]).factor())
    }

    /// F = ∫ S' dθ with S' = LOAD/(2 tan δ_0), (2.217), (12): on the entry's arc L is constant, and on the sliding arc
    /// dL/dθ = ±μ*(L − K) integrates to L_out − L_in = ±μ* ∫ (L − K) dθ.
    fn axial(self) -> Result<Atom, Error> {
        let load = linear_in(&read("load", LOAD)?, "L")?;
        let adhesion = self.read("(2*half - Phi_#)*(L_#in - K)")?;
        let sliding = self.read("M_#/(r_#*friction)")?;
        let force = load.coefficient * (adhesion + sliding) / self.read("2*tan_delta")?;
        Ok(self.read("F_C#")? - force)
    }

    /// v_0 at no torque, (2.220), (15): the positive root, in the form that does not cancel.
    fn no_load(self) -> Result<Quadratic, Error> {
        let adhering = adhering("u")?;
        let load = substitute(&read("load", LOAD)?, &[("L", adhering)]);
        // (6), (14): F tan δ_0 = half · load, times v_0.
        let balance = self.read("F_C#*tan_delta")? - self.read("half")? * load;
        quadratic_in(&(balance * read("v_0", "v_0")?).expand(), "v_0")
    }
}

fn sheet(steps: &[Row], outputs: Table) -> Result<Sheet, Error> {
    let steps: Vec<Row> = STEPS.iter().chain(steps).copied().collect();
    let mut sheet = Sheet::new(("SimpleDriveInput", INPUTS), &steps, outputs)?;
    let plan = &mut sheet.plan;
    for (text, reason) in [
        ("r_I", "a length"),
        ("r_O", "a length"),
        ("EA", "a stiffness"),
        ("mu_star", "friction carries the torque"),
        ("v_0", "the belt runs"),
        ("cos(delta_0)", "0 < δ_0 < 90°"),
        ("tan_delta", "0 < δ_0 < 90°"),
        ("EA - m_star*v_0^2", "the belt runs more slowly than a wave along it"),
        ("L_Oin - K", "the belt is pressed into its groove"),
        ("L_Iin - K", "the belt is pressed into its groove"),
        ("ratio_O", "the belt is pressed into its groove at the exit, too"),
        ("ratio_I", "the belt is pressed into its groove at the exit, too"),
    ] {
        plan.nonzero(text, reason)?;
    }
    plan.apply("tan_delta", Function::Tan, &["delta_0"], "(5)")?;
    plan.derived("K", lift_off()?, "formula of K, 1.2")?;
    plan.derived("L_Oin", adhering("r_O*omega_O")?, "(2.218)")?;
    plan.derived("L_Iin", adhering("r_I*omega_I")?, "(7)")?;
    Ok(sheet)
}

/// The equations that Newton's method solves for v_0 and one more unknown.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn residuals() -> Result<BoundaryModel, Error> {
    let mut sheet = sheet(&[], ("SimpleDriveResidual", RESIDUALS))?;
    let plan = &mut sheet.plan;
    plan.derived("ratio_O", OUTPUT.ratio()?, "(2.216)")?;
    plan.derived("ratio_I", INPUT.ratio()?, "(10)")?;
    sliding(&mut sheet)?;
    let plan = &mut sheet.plan;
    // r_I ω_I less what the torque balance makes of it.
    let rim = |side: Side| Ok::<_, Error>(read("2", "r_I")? * solve_linear(&side.torque_of_speeds()?, "omega_I")?);
    plan.derived("speed_O", read("(2)", "r_I*omega_I")? - rim(OUTPUT)?.expand(), "(2)")?;
    plan.derived("speed_I", read("(18)", "r_I*omega_I")? - rim(INPUT)?.expand(), "(18)")?;
    plan.derived("axial_O", OUTPUT.axial()?, "(5)")?;
    plan.derived("axial_I", INPUT.axial()?, "(13)")?;
    Ok(sheet.finish("simple_drive", "Residuals of a belt drive whose belt adheres, then slides."))
}

/// What follows without iteration.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn closed() -> Result<BoundaryModel, Error> {
    let mut sheet = sheet(CLOSED_STEPS, ("SimpleDriveOutput", CLOSED))?;
    no_load(&mut sheet, OUTPUT, "2.220")?;
    no_load(&mut sheet, INPUT, "(15)")?;
    let plan = &mut sheet.plan;
    plan.derived("omega_O_of_M_O", solve_linear(&OUTPUT.torque_of_speeds()?, "omega_O")?, "(21)")?;
    plan.derived("omega_I_of_M_O", solve_linear(&OUTPUT.torque_of_speeds()?, "omega_I")?, "(2)")?;
    plan.derived("M_O_of_speeds", solve_linear(&OUTPUT.torque_of_speeds()?, "M_O")?, "(17)")?;
    plan.derived("M_I_of_speeds", solve_linear(&INPUT.torque_of_speeds()?, "M_I")?, "(19)")?;
    // (9) and (10) differ in nothing but radius and sign of L_out − L_in.
    let tight = solve_linear(&OUTPUT.torque()?, "L_Iin")?;
    let loop_torque = substitute(&INPUT.torque()?, &[("L_Iin", tight)]);
    plan.derived("M_O_of_M_I", solve_linear(&loop_torque, "M_O")?, "(11)")?;
    plan.derived("M_I_of_M_O", solve_linear(&loop_torque, "M_I")?, "(20)")?;
    for (name, text) in [("lift_off", "K"), ("slack_force", "L_Oin"), ("tight_force", "L_Iin")] {
        plan.primitive(name, text, "1.2")?;
    }
    for (name, force) in [("slack_tension", "L_Oin"), ("tight_tension", "L_Iin")] {
        plan.derived(name, substitute(&read(name, LOAD)?, &[("L", read(name, force)?)]), "(12)")?;
    }
    plan.primitive("ratio_O", "(L_Iin - K)/(L_Oin - K)", "(22)")?;
    plan.primitive("ratio_I", "(L_Oin - K)/(L_Iin - K)", "(25)")?;
    sliding(&mut sheet)?;
    let plan = &mut sheet.plan;
    for (side, angle, force, torque, slip) in [
        (OUTPUT, "sliding_O", "F_CO_of_speeds", "M_O_of_speeds", "F_slip_O"),
        (INPUT, "sliding_I", "F_CI_of_speeds", "M_I_of_speeds", "F_slip_I"),
    ] {
        plan.derived(angle, side.read("Phi_#")?, "(22), (25)")?;
        let (axial, unknown) = (side.axial()?, format!("F_C{}", side.suffix));
        let of =
            |replacement: (&str, Atom)| Ok::<_, Error>(-(substitute(&axial, &[replacement]) - read("F", &unknown)?));
        plan.derived(force, of((&format!("M_{}", side.suffix), read(force, torque)?))?, "(23), (26)")?;
        let all = of((&format!("Phi_{}", side.suffix), side.read("2*half")?))?.expand().factor();
        plan.derived(slip, all, "(5) and (13) where all of the contact slides")?;
    }
    Ok(sheet
        .finish("simple_drive_closed", "What follows without iteration in a drive whose belt adheres, then slides."))
}

/// Φ of both pulleys from the ratios of their forces, (2.221), (16), (22), (25).
fn sliding(sheet: &mut Sheet) -> Result<(), Error> {
    for side in [OUTPUT, INPUT] {
        let [ratio, log, angle] = ["ratio_", "log_", "Phi_"].map(|name| format!("{name}{}", side.suffix));
        sheet.plan.apply(&log, Function::Ln, &[&ratio], "(2.221), (16)")?;
        sheet.plan.derived(&angle, side.read("log_#/friction")?, "(2.221), (16)")?;
    }
    Ok(())
}

fn no_load(sheet: &mut Sheet, side: Side, source: &'static str) -> Result<(), Error> {
    let Quadratic { square, linear, constant } = side.no_load()?;
    let [a, b, c, root, v_0] = ["a_", "b_", "c_", "root_", "v_0_"].map(|name| format!("{name}{}", side.suffix));
    let plan = &mut sheet.plan;
    let discriminant = format!("{b}^2 - 4*{a}*{c}");
    plan.nonzero(&discriminant, "the constant coefficient is negative, the others are positive")?;
    plan.nonzero(&root, "the root of something positive")?;
    plan.nonzero(&format!("{b} + {root}"), "both are positive")?;
    plan.derived(&a, square, source)?;
    plan.derived(&b, linear, source)?;
    plan.derived(&c, constant, source)?;
    plan.apply(&root, Function::Sqrt, &[&discriminant], source)?;
    plan.primitive(&v_0, &format!("-2*{c}/({b} + {root})"), source)
}
