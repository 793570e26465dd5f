// flyweight_ramp: Axial force of flyweights that slide along a radius against a ramp.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 13 operations
//   jacobian: 39 operations
// Equations, with their numbers in the source:
// - tan_rho (typed in): ρ
// - radial (typed in): centrifugal force
// - force (derived): balance on the ramp

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (0, 5)];
///Axial force of flyweights that slide along a radius against a ramp.
pub(crate) const KERNEL: FormulaKernel<FlyweightRampInput, FlyweightRampOutput> = FormulaKernel::new(BoundaryKernel {
    name: "flyweight_ramp",
    equations: FlyweightRampOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: FlyweightRampInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 6, "constants: too few values");
    let g = sized(g, 1, "g");
    let r_s = constants[4];
    let rho = constants[5];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let omega = constants[2];
    let r = constants[3];
    let N = constants[0];
    let m = constants[1];
    let radial = omega * omega * (r * (N * m));
    let force = (r_s - tan_rho) * (radial * reciprocal(1.0 + r_s * tan_rho));
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
    assert!(constants.len() >= 6, "constants: too few values");
    let g = sized(g, 1, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let r_s = constants[4];
    let rho = constants[5];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let t2 = r_s - tan_rho;
    let omega = constants[2];
    let t3 = omega * omega;
    let r = constants[3];
    let N = constants[0];
    let m = constants[1];
    let t4 = N * m;
    let radial = t3 * (r * t4);
    let t5 = reciprocal(1.0 + r_s * tan_rho);
    let t6 = radial * t5;
    let force = t2 * t6;
    g[0] = force;
    let t7 = t5 * t2;
    let d_force_d_N = t3 * (m * r) * t7;
    dz[0] = d_force_d_N;
    let d_force_d_m = t3 * (N * r) * t7;
    dz[1] = d_force_d_m;
    let d_force_d_omega = 2.0 * (r * (omega * t4)) * t7;
    dz[2] = d_force_d_omega;
    let d_force_d_r = t3 * t4 * t7;
    dz[3] = d_force_d_r;
    let t8 = t5 * t5;
    let d_force_d_r_s = t6 - t8 * (t2 * (tan_rho * radial));
    dz[4] = d_force_d_r_s;
    let d_force_d_rho = -((1.0 + tan_rho * tan_rho) * (t6 + t8 * (t2 * (r_s * radial))));
    dz[5] = d_force_d_rho;
}
