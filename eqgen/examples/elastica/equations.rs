//! Euler's elastica: a strut, pinned at both ends and pushed together until its ends have turned by a given angle.

use eqgen::Error;
use eqgen::derive::solve_linear;
use eqgen::emit::{self, Provenance, SourceFile};
use eqgen::physics::model::{BoundaryModel, Model, RegionModel, Role};
use eqgen::physics::notation::{Row, Symbol, row};
use eqgen::plan::{Plan, read};

/// All symbols: name, as printed, unit, exponent of the region's own unit, meaning.
const NOTATION: &[Row] = &[
    row("s", "ŝ", "", 1, "position along the strut over its length"),
    row("theta", "θ", "rad", 0, "direction of the strut against the load").identity("Direction", "Euler"),
    row("theta1", "θ̂'", "rad", -1, "dθ/dŝ").identity("DirectionDerivative", "Euler"),
    row("P", "P", "N", 0, "load along the line of the ends").identity("Load", "Euler"),
    row("alpha", "α", "rad", 0, "direction of the strut at its first end").identity("EndDirection", "Euler"),
    row("L", "L", "m", -1, "length of the strut").identity("Length", "Euler"),
    row("EI", "EI", "N m^2", 0, "bending stiffness").identity("BendingStiffness", "Euler"),
    row("kappa", "κ", "rad/m", 0, "curvature dθ/ds"),
    row("kappa_s", "κ'", "rad/m^2", 0, "dκ/ds"),
    row("M", "M", "N m", 0, "bending moment").identity("BendingMoment", "Euler"),
    row("theta_hat_2", "θ̂''", "rad", -2, "d²θ/dŝ²"),
    row("X", "X̂", "", 1, "distance of the ends over L").identity("DistanceAlong", "Euler"),
    row("Y", "Ŷ", "", 1, "distance of the ends across the load over L").identity("DistanceAcross", "Euler"),
    row("X_hat_1", "X̂'", "", 0, "dX̂/dŝ"),
    row("Y_hat_1", "Ŷ'", "", 0, "dŶ/dŝ"),
];

/// States and residuals at the ends.
const ENDS: &[Row] = &[
    row("theta_1", "θ_1", "rad", 0, "θ at the first end"),
    row("theta1_1", "θ̂'_1", "rad", -1, "θ̂' at the first end"),
    row("theta_2", "θ_2", "rad", 0, "θ at the second end"),
    row("theta1_2", "θ̂'_2", "rad", -1, "θ̂' at the second end"),
    row("direction", "", "rad", 0, "residual"),
    row("moment_1", "", "rad", -1, "residual"),
    row("moment_2", "", "rad", -1, "residual"),
];

const PROVENANCE: Provenance = Provenance {
    source: "eqgen/examples/elastica/equations.rs",
    command: "cargo run -p sheave-eqgen --example elastica_write",
};

fn notation(rows: &[&[Row]]) -> Vec<Symbol> {
    rows.iter().copied().flatten().map(Symbol::from).collect()
}

/// The strut: M = EI κ and M' = −P sinθ.
fn strut() -> Result<RegionModel, Error> {
    let mut plan = Plan::in_notation_of(&["s", "theta", "theta1", "P", "L", "EI"], notation(&[NOTATION]))?;
    plan.nonzero("L", "a strut has a length")?;
    plan.nonzero("EI", "a strut resists bending")?;
    plan.primitive("kappa", "theta1/L", "definition")?;
    plan.primitive("M", "EI*kappa", "Bernoulli and Euler")?;
    let balance = read("equilibrium of moments", "EI*kappa_s + P*sin(theta)")?;
    plan.derived("kappa_s", solve_linear(&balance, "kappa_s")?, "equilibrium of moments")?;
    plan.primitive("theta_hat_2", "L^2*kappa_s", "definition")?;
    plan.primitive("X_hat_1", "cos(theta)", "definition")?;
    plan.primitive("Y_hat_1", "sin(theta)", "definition")?;
    Ok(RegionModel {
        name: "strut".into(),
        doc: "A thin elastic strut under a load at its ends.".into(),
        plan,
        states: &["theta", "theta1"],
        constants: &["P", "L", "EI"],
        default_unknowns: 1,
        integrals: &["X", "Y"],
        rows: &["theta1", "theta_hat_2", "X_hat_1", "Y_hat_1"],
        fields: &["M"],
    })
}

/// Pinned ends carry no moment; the first has turned by α.
fn ends() -> Result<BoundaryModel, Error> {
    let inputs = ["theta_1", "theta1_1", "theta_2", "theta1_2", "X", "Y", "P", "L", "EI", "alpha"];
    let mut plan = Plan::in_notation_of(&inputs, notation(&[NOTATION, ENDS]))?;
    let equations = [
        ("direction", "theta_1 - alpha", "θ = α at the first end"),
        ("moment_1", "theta1_1", "M = 0 at the first end"),
        ("moment_2", "theta1_2", "M = 0 at the second end"),
    ];
    for (name, residual, doc) in equations {
        plan.primitive(name, residual, doc)?;
    }
    let rows = |names: &[&str]| names.iter().filter_map(|name| plan.symbol(name)).collect::<Vec<_>>();
    let (ends, integrals, constants) = (rows(&inputs[..4]), rows(&inputs[4..6]), rows(&inputs[6..]));
    Ok(BoundaryModel {
        name: "strut_ends".into(),
        doc: "What holds at the ends of the strut.".into(),
        ends,
        integrals,
        constants,
        equations: equations.iter().filter_map(|(name, _, doc)| described(&plan, name, doc)).collect(),
        role: Role::Conditions,
        plan,
    })
}

/// The symbol of a residual, with what it says.
fn described(plan: &Plan, name: &str, doc: &str) -> Option<Symbol> {
    Some(Symbol { doc: doc.into(), ..plan.symbol(name)? })
}

/// The generated files.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn files() -> Result<Vec<SourceFile>, Error> {
    eqgen::symbolic(|| {
        let models = [Model::Region(strut()?), Model::Boundary(ends()?)];
        let kernels = models.iter().map(|model| emit::file(model, PROVENANCE));
        kernels.chain([emit::vocabulary(&models, &notation(&[NOTATION]), PROVENANCE)]).collect()
    })?
}
