// flyweight_table: Axial force of flyweights whose radius times its slope over the shift is known.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 6 operations
//   jacobian: 19 operations
// Equations, with their numbers in the source:
// - force (typed in): (9.2)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4)];
///Axial force of flyweights whose radius times its slope over the shift is known.
pub(crate) const KERNEL: FormulaKernel<FlyweightTableInput, FlyweightTableOutput> = FormulaKernel::new(BoundaryKernel {
    name: "flyweight_table",
    equations: FlyweightTableOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: FlyweightTableInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 5, "constants: too few values");
    let g = sized(g, 1, "g");
    let lost = constants[4];
    let omega = constants[2];
    let C = constants[3];
    let N = constants[0];
    let m = constants[1];
    let force = (1.0 - lost) * (omega * omega * (C * (N * m)));
    g[0] = force;
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
    assert!(constants.len() >= 5, "constants: too few values");
    let g = sized(g, 1, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let lost = constants[4];
    let t1 = 1.0 - lost;
    let omega = constants[2];
    let t2 = omega * omega;
    let C = constants[3];
    let N = constants[0];
    let m = constants[1];
    let t3 = N * m;
    let t4 = t2 * (C * t3);
    let force = t1 * t4;
    g[0] = force;
    let d_force_d_N = t1 * (t2 * (m * C));
    dz[0] = d_force_d_N;
    let d_force_d_m = t1 * (t2 * (N * C));
    dz[1] = d_force_d_m;
    let d_force_d_omega = 2.0 * (t1 * (C * (omega * t3)));
    dz[2] = d_force_d_omega;
    let d_force_d_C = t1 * (t2 * t3);
    dz[3] = d_force_d_C;
    let d_force_d_lost = -t4;
    dz[4] = d_force_d_lost;
}
