// compression_spring: Force of a compression spring.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 7 operations
//   jacobian: 8 operations
// Equations, with their numbers in the source:
// - force (typed in): (9.3)
// - energy (typed in): energy

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)];
///Force of a compression spring.
pub(crate) const KERNEL: FormulaKernel<
    CompressionSpringInput,
    CompressionSpringOutput,
> = FormulaKernel::new(BoundaryKernel {
    name: "compression_spring",
    equations: CompressionSpringOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: CompressionSpringInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 3, "constants: too few values");
    let g = sized(g, 2, "g");
    let F_0 = constants[0];
    let c = constants[1];
    let s = constants[2];
    let force = F_0 + c * s;
    g[0] = force;
    let energy = F_0 * s + s * s * (c * 0.5);
    g[1] = energy;
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
    let g = sized(g, 2, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let F_0 = constants[0];
    let c = constants[1];
    let s = constants[2];
    let force = F_0 + c * s;
    g[0] = force;
    let t1 = s * s;
    let energy = F_0 * s + t1 * (c * 0.5);
    g[1] = energy;
    dz[0] = 1.0;
    dz[1] = s;
    dz[2] = c;
    dz[3] = s;
    let d_energy_d_c = 0.5 * t1;
    dz[4] = d_energy_d_c;
    dz[5] = force;
}
