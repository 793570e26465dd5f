// drive_sizing_idler: Inertia of an idler at the input of a belt drive.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 5 operations
//   jacobian: 13 operations
// Equations, with their numbers in the source:
// - reflected_inertia (derived): (3.21)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 2), (0, 12), (0, 13)];
///Inertia of an idler at the input of a belt drive.
pub(crate) const KERNEL: FormulaKernel<DriveSizingInput, DriveSizingIdlerOutput> = FormulaKernel::new(BoundaryKernel {
    name: "drive_sizing_idler",
    equations: DriveSizingIdlerOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: DriveSizingInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 14, "constants: too few values");
    let g = sized(g, 1, "g");
    let D = constants[12];
    let t1 = reciprocal(D);
    let I_idler = constants[13];
    let D_in = constants[2];
    let reflected_inertia = t1 * t1 * (I_idler * (D_in * D_in));
    g[0] = reflected_inertia;
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
    assert!(constants.len() >= 14, "constants: too few values");
    let g = sized(g, 1, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let D = constants[12];
    let t1 = reciprocal(D);
    let t2 = t1 * t1;
    let I_idler = constants[13];
    let D_in = constants[2];
    let t3 = D_in * D_in;
    let t4 = I_idler * t3;
    let reflected_inertia = t2 * t4;
    g[0] = reflected_inertia;
    let d_reflected_inertia_d_D_in = 2.0 * (t2 * (D_in * I_idler));
    dz[0] = d_reflected_inertia_d_D_in;
    let d_reflected_inertia_d_D = -(t1 * t2 * (t4 * 2.0));
    dz[1] = d_reflected_inertia_d_D;
    let d_reflected_inertia_d_I_idler = t3 * t2;
    dz[2] = d_reflected_inertia_d_I_idler;
}
