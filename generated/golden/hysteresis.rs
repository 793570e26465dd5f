// hysteresis: Power that a harmonic of what runs around with the belt loses.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 20 operations
//   jacobian: 77 operations
// Equations, with their numbers in the source:
// - G (typed in): definition of the flow coefficient
// - revolutions (typed in): (3.5)
// - bending (derived): (3.26)
// - groove (derived): (3.16)
// - cord (derived): (3.9)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 2),
    (0, 3),
    (0, 4),
    (0, 8),
    (1, 0),
    (1, 2),
    (1, 3),
    (1, 4),
    (1, 5),
    (1, 8),
    (2, 0),
    (2, 2),
    (2, 3),
    (2, 4),
    (2, 6),
    (2, 7),
    (2, 8),
    (3, 0),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 4),
    (3, 8),
];
///Power that a harmonic of what runs around with the belt loses.
pub(crate) const KERNEL: FormulaKernel<HysteresisInput, HysteresisOutput> = FormulaKernel::new(BoundaryKernel {
    name: "hysteresis",
    equations: HysteresisOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: HysteresisInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 9, "constants: too few values");
    let g = sized(g, 4, "g");
    let L_0 = constants[8];
    let omega_P = constants[4];
    let R_P = constants[3];
    let flow = constants[0];
    let m_o = constants[2];
    let G = omega_P * (R_P * (flow * m_o));
    let revolutions = reciprocal(L_0) * (G * reciprocal(m_o));
    g[0] = revolutions;
    let EI = constants[5];
    let bending = 0.3183098861837907 * (revolutions * (EI * L_0));
    g[1] = bending;
    let beta = constants[7];
    let (sin_beta, cos_beta) = sin_cos(beta);
    let k = constants[6];
    let groove = reciprocal(cos_beta)
        * (sin_beta * (0.3183098861837907 * (revolutions * (k * L_0))));
    g[2] = groove;
    let EA = constants[1];
    let cord = 0.3183098861837907 * (revolutions * (EA * L_0));
    g[3] = cord;
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
    assert!(constants.len() >= 9, "constants: too few values");
    let g = sized(g, 4, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let L_0 = constants[8];
    let t1 = reciprocal(L_0);
    let omega_P = constants[4];
    let R_P = constants[3];
    let flow = constants[0];
    let m_o = constants[2];
    let t2 = flow * m_o;
    let t3 = R_P * t2;
    let G = omega_P * t3;
    let t4 = reciprocal(m_o);
    let t5 = G * t4;
    let revolutions = t1 * t5;
    g[0] = revolutions;
    let EI = constants[5];
    let t6 = EI * L_0;
    let bending = 0.3183098861837907 * (revolutions * t6);
    g[1] = bending;
    let beta = constants[7];
    let (sin_beta, cos_beta) = sin_cos(beta);
    let t8 = reciprocal(cos_beta);
    let k = constants[6];
    let t9 = k * L_0;
    let t10 = 0.3183098861837907 * (revolutions * t9);
    let groove = t8 * (sin_beta * t10);
    g[2] = groove;
    let EA = constants[1];
    let t11 = EA * L_0;
    let cord = 0.3183098861837907 * (revolutions * t11);
    g[3] = cord;
    let t12 = t4 * t1;
    let d_revolutions_d_flow = omega_P * (m_o * R_P) * t12;
    dz[0] = d_revolutions_d_flow;
    let d_revolutions_d_m_o = omega_P * (flow * R_P) * t12 - t4 * t4 * (G * t1);
    dz[1] = d_revolutions_d_m_o;
    let d_revolutions_d_R_P = omega_P * t2 * t12;
    dz[2] = d_revolutions_d_R_P;
    let d_revolutions_d_omega_P = t3 * t12;
    dz[3] = d_revolutions_d_omega_P;
    let t13 = t5 * (t1 * t1);
    let d_revolutions_d_L_0 = -t13;
    dz[4] = d_revolutions_d_L_0;
    let t14 = 0.3183098861837907 * t6;
    let d_bending_d_flow = t14 * d_revolutions_d_flow;
    dz[5] = d_bending_d_flow;
    let d_bending_d_m_o = t14 * d_revolutions_d_m_o;
    dz[6] = d_bending_d_m_o;
    let d_bending_d_R_P = t14 * d_revolutions_d_R_P;
    dz[7] = d_bending_d_R_P;
    let d_bending_d_omega_P = t14 * d_revolutions_d_omega_P;
    dz[8] = d_bending_d_omega_P;
    let d_bending_d_EI = 0.3183098861837907 * (L_0 * revolutions);
    dz[9] = d_bending_d_EI;
    let d_bending_d_L_0 = 0.3183098861837907 * (EI * revolutions) - t13 * t14;
    dz[10] = d_bending_d_L_0;
    let t15 = t8 * (sin_beta * (0.3183098861837907 * t9));
    let d_groove_d_flow = t15 * d_revolutions_d_flow;
    dz[11] = d_groove_d_flow;
    let d_groove_d_m_o = t15 * d_revolutions_d_m_o;
    dz[12] = d_groove_d_m_o;
    let d_groove_d_R_P = t15 * d_revolutions_d_R_P;
    dz[13] = d_groove_d_R_P;
    let d_groove_d_omega_P = t15 * d_revolutions_d_omega_P;
    dz[14] = d_groove_d_omega_P;
    let d_groove_d_k = t8 * (sin_beta * d_bending_d_EI);
    dz[15] = d_groove_d_k;
    let d_groove_d_beta = t10 + t8 * t8 * (t10 * (sin_beta * sin_beta));
    dz[16] = d_groove_d_beta;
    let d_groove_d_L_0 = t8 * (sin_beta * (0.3183098861837907 * (k * revolutions)))
        - t13 * t15;
    dz[17] = d_groove_d_L_0;
    let t16 = 0.3183098861837907 * t11;
    let d_cord_d_flow = t16 * d_revolutions_d_flow;
    dz[18] = d_cord_d_flow;
    dz[19] = d_bending_d_EI;
    let d_cord_d_m_o = t16 * d_revolutions_d_m_o;
    dz[20] = d_cord_d_m_o;
    let d_cord_d_R_P = t16 * d_revolutions_d_R_P;
    dz[21] = d_cord_d_R_P;
    let d_cord_d_omega_P = t16 * d_revolutions_d_omega_P;
    dz[22] = d_cord_d_omega_P;
    let d_cord_d_L_0 = 0.3183098861837907 * (EA * revolutions) - t13 * t16;
    dz[23] = d_cord_d_L_0;
}
