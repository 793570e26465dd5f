// sheave_travel: Travel of a movable sheave from the belt's radius.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 6 operations
//   jacobian: 11 operations
// Equations, with their numbers in the source:
// - tan_beta (typed in): β
// - travel (typed in): (9.2)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 0), (0, 1), (0, 2)];
///Travel of a movable sheave from the belt's radius.
pub(crate) const KERNEL: FormulaKernel<SheaveTravelInput, SheaveTravelOutput> = FormulaKernel::new(BoundaryKernel {
    name: "sheave_travel",
    equations: SheaveTravelOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: SheaveTravelInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 3, "constants: too few values");
    let g = sized(g, 1, "g");
    let R = constants[1];
    let R_0 = constants[2];
    let beta = constants[0];
    let (sin_beta, cos_beta) = sin_cos(beta);
    let tan_beta = sin_beta * reciprocal(cos_beta);
    let travel = (R - R_0) * (tan_beta * 2.0);
    g[0] = travel;
}
///Residuals and their derivatives.
fn derivatives(
    ends: &[f64],
    integrals: &[f64],
    constants: &[f64],
    g: &mut [f64],
    dz: &mut [f64],
) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 3, "constants: too few values");
    let g = sized(g, 1, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let R = constants[1];
    let R_0 = constants[2];
    let t1 = R - R_0;
    let beta = constants[0];
    let (sin_beta, cos_beta) = sin_cos(beta);
    let tan_beta = sin_beta * reciprocal(cos_beta);
    let d_travel_d_R = tan_beta * 2.0;
    let travel = t1 * d_travel_d_R;
    g[0] = travel;
    let d_travel_d_beta = (1.0 + tan_beta * tan_beta) * (2.0 * t1);
    dz[0] = d_travel_d_beta;
    dz[1] = d_travel_d_R;
    let d_travel_d_R_0 = -d_travel_d_R;
    dz[2] = d_travel_d_R_0;
}
