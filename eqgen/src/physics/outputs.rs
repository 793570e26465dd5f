//! What a drive is asked for: every output that is a function of ends, integrals and constants, with its derivatives.

use super::boundary::{CONSTANTS, end_symbols, integral_symbols};
use super::model::{BeltTheory, BoundaryModel, Role};
use super::notation::{self, Symbol};
use crate::dimension::{Dimension, Dimensions};
use crate::error::Error;
use crate::plan::{Function, Plan};

/// One output.
#[derive(Debug, Clone, Copy)]
struct Row {
    /// Group and key of the result object, joined by a dot.
    path: &'static str,
    /// As it is printed.
    symbol: &'static str,
    /// What it is in ends, integrals and constants.
    expression: &'static str,
    /// SI unit, empty for a pure number.
    unit: &'static str,
    /// What it means.
    doc: &'static str,
    /// Where it is defined.
    source: &'static str,
    /// The belts whose drives have it.
    belts: &'static [BeltTheory],
}

/// An output of every drive.
const fn output(
    path: &'static str,
    symbol: &'static str,
    expression: &'static str,
    unit: &'static str,
    doc: &'static str,
    source: &'static str,
) -> Row {
    Row { path, symbol, expression, unit, doc, source, belts: &[BeltTheory::Beam, BeltTheory::String] }
}

impl Row {
    /// Name of its step in the plan.
    fn step(&self) -> String {
        self.path.replace('.', "__")
    }

    fn dimension(&self) -> Dimension {
        Dimension::of_unit(self.unit).unwrap_or_else(|| unreachable!("unit of {}", self.path))
    }
}

/// All outputs, in the order of the generated enum: to add one, add its row. An output that only beams have is
/// `Row { belts: &[BeltTheory::Beam], ..output(…) }`.
const OUTPUTS: &[Row] = &[
    output("primary.speed", "ω_P", "omega_P", "rad/s", "speed of rotation", "5.1"),
    // Friction on the belt drives it backwards on the primary: M_P < 0.
    output("primary.torque", "M_P", "-M_P", "N m", "torque that drives the pulley", "(5.54)"),
    output("primary.power", "P_P", "-M_P*omega_P", "W", "power into the pulley", "6.2"),
    output("primary.axial_force", "A_P", "A_P", "N", "axial force on a sheave", "(5.58)"),
    output("primary.wrap_angle", "Φ_P", "Phi_P*s_2", "rad", "wrap angle", "(5.1)"),
    output("primary.entry_angle", "θ_P1", "theta_P1", "rad", "inclination where the belt enters", "(3.2)"),
    output("primary.exit_angle", "θ_P2", "theta_P2", "rad", "inclination where the belt leaves", "(3.2)"),
    output("primary.orientation_angle", "C_P", "C_P", "rad", "orientation angle", "(5.17) to (5.20)"),
    // The moments turn with the entry, which stands at C_P.
    output(
        "primary.resultant_x",
        "x_AP",
        "(cos(C_P)*A_x_P - sin(C_P)*A_y_P)/A_P",
        "m",
        "where the axial force acts",
        "(6.3), (6.5)",
    ),
    output(
        "primary.resultant_y",
        "y_AP",
        "(sin(C_P)*A_x_P + cos(C_P)*A_y_P)/A_P",
        "m",
        "where the axial force acts",
        "(6.4), (6.5)",
    ),
    output("primary.binding_moment", "B_P", "binding_P", "N m", "moment of the axial force about the centre", "6.1.2"),
    output("primary.friction_loss", "W_P", "W_P", "W", "power lost to friction", "power of friction"),
    output("primary.entry_tension", "T_P1", "T_P1", "N", "tractive tension where the belt enters", "(3.6)"),
    output("primary.exit_tension", "T_P2", "T_P2", "N", "tractive tension where the belt leaves", "(3.6)"),
    output("secondary.speed", "ω_S", "speed_ratio*omega_P", "rad/s", "speed of rotation", "5.1"),
    output("secondary.torque", "M_S", "M_S", "N m", "torque that the pulley delivers", "(5.54)"),
    output("secondary.power", "P_S", "M_S*speed_ratio*omega_P", "W", "power out of the pulley", "6.2"),
    output("secondary.axial_force", "A_S", "A_S", "N", "axial force on a sheave", "(5.58)"),
    output("secondary.wrap_angle", "Φ_S", "Phi_S*s_2", "rad", "wrap angle", "(5.1)"),
    output("secondary.entry_angle", "θ_S1", "theta_S1", "rad", "inclination where the belt enters", "(3.2)"),
    output("secondary.exit_angle", "θ_S2", "theta_S2", "rad", "inclination where the belt leaves", "(3.2)"),
    output("secondary.orientation_angle", "C_S", "C_S", "rad", "orientation angle", "(5.17) to (5.20)"),
    // Here the entry stands at π − C_S − Φ_S.
    output(
        "secondary.resultant_x",
        "x_AS",
        "(sin(C_S + Phi_S*s_2)*(-A_y_S) - cos(C_S + Phi_S*s_2)*A_x_S)/A_S",
        "m",
        "where the axial force acts",
        "(6.3), (6.6)",
    ),
    output(
        "secondary.resultant_y",
        "y_AS",
        "(sin(C_S + Phi_S*s_2)*A_x_S - cos(C_S + Phi_S*s_2)*A_y_S)/A_S",
        "m",
        "where the axial force acts",
        "(6.4), (6.6)",
    ),
    output(
        "secondary.binding_moment",
        "B_S",
        "binding_S",
        "N m",
        "moment of the axial force about the centre",
        "6.1.2",
    ),
    output("secondary.friction_loss", "W_S", "W_S", "W", "power lost to friction", "power of friction"),
    output("secondary.entry_tension", "T_S1", "T_S1", "N", "tractive tension where the belt enters", "(3.6)"),
    output("secondary.exit_tension", "T_S2", "T_S2", "N", "tractive tension where the belt leaves", "(3.6)"),
    output("tight_span.arc_length", "L_t", "L_t*s_2", "m", "arc length", "(5.9)"),
    output("tight_span.unstretched_length", "L_ot", "L_o_t", "m", "length when unloaded", "(5.56)"),
    output("slack_span.arc_length", "L_s", "L_s*s_2", "m", "arc length", "(5.9)"),
    output("slack_span.unstretched_length", "L_os", "L_o_s", "m", "length when unloaded", "(5.56)"),
    output("efficiency.speed", "η_ω", "speed_ratio*R_S/R_P", "", "speed efficiency", "(6.7)"),
    output("efficiency.torque", "η_M", "-M_S*R_P/(M_P*R_S)", "", "torque efficiency", "(6.8)"),
    output("efficiency.overall", "η", "-M_S*speed_ratio/M_P", "", "overall efficiency", "(6.9)"),
    output("belt.mass_flow", "G", "flow*m_o*R_P*omega_P", "kg/s", "mass flow", "(3.5)"),
    output(
        "belt.unstretched_length",
        "L_o",
        "L_o_P + L_o_s + L_o_S + L_o_t",
        "m",
        "length of the loop when unloaded",
        "(5.55), (5.56)",
    ),
    output("energy.power_in", "P_in", "-M_P*omega_P", "W", "power into the drive", "energy balance"),
    output("energy.power_out", "P_out", "M_S*speed_ratio*omega_P", "W", "power out of the drive", "energy balance"),
    output("energy.friction_loss", "W", "W_P + W_S", "W", "power lost to friction", "power of friction"),
    output(
        "energy.stretch_work",
        "E",
        "E_P + E_s + E_S + E_t",
        "W",
        "strain energy flux: power that bending and squeezing take as the belt changes its speed",
        "energy balance",
    ),
    output(
        "energy.imbalance",
        "1 − (P_out + W)/P_in",
        "1 + (M_S*speed_ratio*omega_P + W_P + W_S)/(M_P*omega_P)",
        "",
        "power in that is neither power out nor friction loss, over power in",
        "energy balance",
    ),
    output(
        "energy.closure",
        "1 − (P_out + W + E)/P_in",
        "1 + (M_S*speed_ratio*omega_P + W_P + W_S + E_P + E_s + E_S + E_t)/(M_P*omega_P)",
        "",
        "power in that nothing accounts for, over power in",
        "energy balance",
    ),
];

/// All outputs as symbols, whatever the belt.
pub fn all() -> Vec<Symbol> {
    OUTPUTS.iter().map(Symbol::from).collect()
}

/// The outputs of drives with that belt.
pub fn of(belt: BeltTheory) -> Vec<Symbol> {
    OUTPUTS.iter().filter(|row| row.belts.contains(&belt)).map(Symbol::from).collect()
}

impl From<&Row> for Symbol {
    fn from(row: &Row) -> Self {
        let Row { path, symbol, unit, doc, source, .. } = *row;
        Self {
            name: row.step(),
            symbol: symbol.into(),
            unit,
            dimension: row.dimension(),
            doc: doc.into(),
            variant: notation::camel_case(path),
            source,
        }
    }
}

/// The outputs of a drive.
///
/// # Errors
/// If an expression is inconsistent; the message names it.
pub fn model(belt: BeltTheory) -> Result<BoundaryModel, Error> {
    let (ends, integrals) = (end_symbols(belt), integral_symbols());
    let symbols = || ends.iter().chain(&integrals);
    let moment = Dimension::of_unit("N m").unwrap_or_else(|| unreachable!("a unit"));
    let moments = ["binding_P", "binding_S"].map(|name| (name.to_owned(), moment));
    let own = symbols().map(|symbol| (symbol.name.clone(), symbol.dimension));
    let rows = || OUTPUTS.iter().filter(|row| row.belts.contains(&belt));
    let outputs = rows().map(|row| (row.step(), row.dimension()));
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
    for row in rows() {
        plan.primitive(&row.step(), row.expression, row.source)?;
    }
    Ok(BoundaryModel {
        name: if belt == BeltTheory::Beam { "outputs" } else { "outputs_string" }.into(),
        doc: "Outputs of a drive as functions of its ends, integrals and constants.".into(),
        plan,
        ends,
        integrals,
        constants: CONSTANTS.iter().filter_map(|name| notation::find(name)).collect(),
        equations: of(belt),
        role: Role::Outputs(belt),
    })
}
