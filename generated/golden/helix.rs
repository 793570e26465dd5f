// helix: Axial force of a helix and its torsion spring.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 18 operations
//   jacobian: 50 operations
// Equations, with their numbers in the source:
// - tan_rho (typed in): ρ
// - torque (typed in): moments on the movable sheave
// - force (derived): balance on the helix
// - turn (derived): kinematics

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (0, 2),
    (0, 5),
    (0, 6),
    (1, 0),
    (1, 1),
    (1, 2),
    (1, 3),
    (1, 4),
    (1, 5),
    (1, 6),
    (1, 7),
    (2, 3),
    (2, 4),
];
///Axial force of a helix and its torsion spring.
pub(crate) const KERNEL: FormulaKernel<HelixInput, HelixOutput> = FormulaKernel::new(BoundaryKernel {
    name: "helix",
    equations: HelixOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: HelixInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 8, "constants: too few values");
    let g = sized(g, 3, "g");
    let share = constants[5];
    let M = constants[6];
    let kappa = constants[0];
    let phi_0 = constants[1];
    let phi = constants[2];
    let torque = share * M + kappa * (phi_0 + phi);
    g[0] = torque;
    let tan_alpha = constants[4];
    let rho = constants[7];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let r_h = constants[3];
    let t2 = reciprocal(r_h);
    let force = -(reciprocal(tan_alpha + tan_rho)
        * ((tan_alpha * tan_rho - 1.0) * (torque * t2)));
    g[1] = force;
    let turn = t2 * reciprocal(tan_alpha);
    g[2] = turn;
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
    assert!(constants.len() >= 8, "constants: too few values");
    let g = sized(g, 3, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let share = constants[5];
    let M = constants[6];
    let kappa = constants[0];
    let phi_0 = constants[1];
    let phi = constants[2];
    let d_torque_d_kappa = phi_0 + phi;
    let torque = share * M + kappa * d_torque_d_kappa;
    g[0] = torque;
    let tan_alpha = constants[4];
    let rho = constants[7];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let t2 = reciprocal(tan_alpha + tan_rho);
    let t3 = tan_alpha * tan_rho - 1.0;
    let r_h = constants[3];
    let t4 = reciprocal(r_h);
    let t5 = t3 * (torque * t4);
    let force = -(t2 * t5);
    g[1] = force;
    let t6 = reciprocal(tan_alpha);
    let turn = t4 * t6;
    g[2] = turn;
    dz[0] = d_torque_d_kappa;
    dz[1] = kappa;
    dz[2] = kappa;
    dz[3] = M;
    dz[4] = share;
    let t7 = t2 * (t4 * t3);
    let d_force_d_kappa = -(d_torque_d_kappa * t7);
    dz[5] = d_force_d_kappa;
    let d_force_d_phi_0 = -(kappa * t7);
    dz[6] = d_force_d_phi_0;
    dz[7] = d_force_d_phi_0;
    let t8 = t4 * t4;
    let d_force_d_r_h = t8 * (t2 * (torque * t3));
    dz[8] = d_force_d_r_h;
    let t9 = t5 * (t2 * t2);
    let d_force_d_tan_alpha = t9 - t2 * (t4 * (tan_rho * torque));
    dz[9] = d_force_d_tan_alpha;
    let d_force_d_share = -(M * t7);
    dz[10] = d_force_d_share;
    let d_force_d_M = -(share * t7);
    dz[11] = d_force_d_M;
    let d_force_d_rho = (1.0 + tan_rho * tan_rho)
        * (t9 - t2 * (t4 * (tan_alpha * torque)));
    dz[12] = d_force_d_rho;
    let d_turn_d_r_h = -(t6 * t8);
    dz[13] = d_turn_d_r_h;
    let d_turn_d_tan_alpha = -(t4 * (t6 * t6));
    dz[14] = d_turn_d_tan_alpha;
}
