// hysteresis_span: What hysteresis follows along the free belt.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 27 operations
//   jacobian: 141 operations
// Equations, with their numbers in the source:
// - G (typed in): definition of the flow coefficient
// - F (derived): (3.10)
// - V (derived): (3.11)
// - stretch (typed in): (3.9)
// - material (typed in): (5.56)
// - curvature (typed in): (5.10)
// - curvature_slope (typed in): (5.11), (3.9)
// - strain (typed in): (3.9)
// - strain_slope (derived): (3.9), (3.10)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 4),
    (0, 5),
    (0, 6),
    (0, 7),
    (0, 8),
    (0, 9),
    (1, 1),
    (1, 4),
    (2, 0),
    (2, 2),
    (2, 4),
    (2, 5),
    (2, 6),
    (2, 7),
    (2, 8),
    (2, 9),
    (3, 0),
    (3, 5),
    (3, 6),
    (3, 7),
    (3, 8),
    (3, 9),
    (4, 0),
    (4, 3),
    (4, 4),
    (4, 5),
    (4, 6),
    (4, 7),
    (4, 8),
    (4, 9),
];
///What hysteresis follows along the free belt.
pub(crate) const KERNEL: FormulaKernel<HysteresisSpanInput, HysteresisSpanOutput> = FormulaKernel::new(BoundaryKernel {
    name: "hysteresis_span",
    equations: HysteresisSpanOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: HysteresisSpanInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 10, "constants: too few values");
    let g = sized(g, 5, "g");
    let L = constants[4];
    let EA = constants[6];
    let m_o = constants[7];
    let omega_P = constants[9];
    let R_P = constants[8];
    let flow = constants[5];
    let G = omega_P * (R_P * (flow * m_o));
    let t1 = G * G;
    let t2 = reciprocal(EA * m_o - t1);
    let tau = constants[0];
    let F = t2 * (EA * (t1 + tau * m_o));
    let t3 = EA + F;
    let material = L * (EA * reciprocal(t3));
    g[0] = material;
    let vartheta1 = constants[1];
    let t4 = reciprocal(L);
    let curvature = vartheta1 * t4;
    g[1] = curvature;
    let vartheta2 = constants[2];
    let t5 = reciprocal(EA);
    let stretch = t5 * t3;
    let curvature_slope = t4 * t4 * (vartheta2 * stretch);
    g[2] = curvature_slope;
    let strain = F * t5;
    g[3] = strain;
    let tau_hat_1 = constants[3];
    let strain_slope = stretch * t4 * (t2 * (tau_hat_1 * m_o));
    g[4] = strain_slope;
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
    assert!(constants.len() >= 10, "constants: too few values");
    let g = sized(g, 5, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let L = constants[4];
    let EA = constants[6];
    let m_o = constants[7];
    let t1 = EA * m_o;
    let omega_P = constants[9];
    let R_P = constants[8];
    let flow = constants[5];
    let t2 = flow * m_o;
    let t3 = R_P * t2;
    let G = omega_P * t3;
    let t4 = G * G;
    let t5 = reciprocal(t1 - t4);
    let tau = constants[0];
    let t6 = t4 + tau * m_o;
    let F = t5 * (EA * t6);
    let t7 = EA + F;
    let d_material_d_L = EA * reciprocal(t7);
    let material = L * d_material_d_L;
    g[0] = material;
    let vartheta1 = constants[1];
    let d_curvature_d_vartheta1 = reciprocal(L);
    let curvature = vartheta1 * d_curvature_d_vartheta1;
    g[1] = curvature;
    let t8 = d_curvature_d_vartheta1 * d_curvature_d_vartheta1;
    let vartheta2 = constants[2];
    let t9 = reciprocal(EA);
    let stretch = t9 * t7;
    let t10 = vartheta2 * stretch;
    let curvature_slope = t8 * t10;
    g[2] = curvature_slope;
    let strain = F * t9;
    g[3] = strain;
    let t11 = stretch * d_curvature_d_vartheta1;
    let tau_hat_1 = constants[3];
    let t12 = tau_hat_1 * m_o;
    let t13 = t5 * t12;
    let strain_slope = t11 * t13;
    g[4] = strain_slope;
    let t14 = t1 * t5;
    let t15 = L * (d_material_d_L * d_material_d_L);
    let t16 = t9 * t15;
    let d_material_d_tau = -(t14 * t16);
    dz[0] = d_material_d_tau;
    dz[1] = d_material_d_L;
    let t17 = omega_P * (m_o * R_P);
    let t18 = t5 * t5;
    let t19 = EA * G;
    let t20 = 2.0 * (t18 * (t6 * t19)) + 2.0 * (t5 * t19);
    let t21 = t17 * t20;
    let d_material_d_flow = -(t16 * t21);
    dz[2] = d_material_d_flow;
    let t22 = t9 * t9;
    let t23 = t9 - t7 * t22;
    let t24 = t23 * t15;
    let t25 = t6 * t5 - t18 * (t1 * t6);
    let d_material_d_EA = -(t24 + t25 * t16);
    dz[3] = d_material_d_EA;
    let t26 = omega_P * (flow * R_P);
    let t27 = t5 * (tau * EA) - EA * EA * (t6 * t18) + t26 * t20;
    let d_material_d_m_o = -(t16 * t27);
    dz[4] = d_material_d_m_o;
    let t28 = omega_P * t2;
    let t29 = t28 * t20;
    let d_material_d_R_P = -(t16 * t29);
    dz[5] = d_material_d_R_P;
    let t30 = t3 * t20;
    let d_material_d_omega_P = -(t16 * t30);
    dz[6] = d_material_d_omega_P;
    dz[7] = d_curvature_d_vartheta1;
    let d_curvature_d_L = -(vartheta1 * t8);
    dz[8] = d_curvature_d_L;
    let t31 = vartheta2 * t8;
    let t32 = t9 * t31;
    let d_curvature_slope_d_tau = t14 * t32;
    dz[9] = d_curvature_slope_d_tau;
    let d_curvature_slope_d_vartheta2 = stretch * t8;
    dz[10] = d_curvature_slope_d_vartheta2;
    let d_curvature_slope_d_L = -(d_curvature_d_vartheta1 * t8 * (t10 * 2.0));
    dz[11] = d_curvature_slope_d_L;
    let d_curvature_slope_d_flow = t32 * t21;
    dz[12] = d_curvature_slope_d_flow;
    let d_curvature_slope_d_EA = t23 * t31 + t25 * t32;
    dz[13] = d_curvature_slope_d_EA;
    let d_curvature_slope_d_m_o = t32 * t27;
    dz[14] = d_curvature_slope_d_m_o;
    let d_curvature_slope_d_R_P = t32 * t29;
    dz[15] = d_curvature_slope_d_R_P;
    let d_curvature_slope_d_omega_P = t32 * t30;
    dz[16] = d_curvature_slope_d_omega_P;
    let d_strain_d_tau = t9 * t14;
    dz[17] = d_strain_d_tau;
    let d_strain_d_flow = t9 * t21;
    dz[18] = d_strain_d_flow;
    let d_strain_d_EA = t9 * t25 - F * t22;
    dz[19] = d_strain_d_EA;
    let d_strain_d_m_o = t9 * t27;
    dz[20] = d_strain_d_m_o;
    let d_strain_d_R_P = t9 * t29;
    dz[21] = d_strain_d_R_P;
    let d_strain_d_omega_P = t9 * t30;
    dz[22] = d_strain_d_omega_P;
    let t33 = t13 * (t11 * t11);
    let t34 = t33 * t16;
    let d_strain_slope_d_tau = t14 * t34;
    dz[23] = d_strain_slope_d_tau;
    let d_strain_slope_d_tau_hat_1 = t11 * (m_o * t5);
    dz[24] = d_strain_slope_d_tau_hat_1;
    let d_strain_slope_d_L = -(d_material_d_L * t33);
    dz[25] = d_strain_slope_d_L;
    let t35 = 2.0 * (t18 * (t11 * (G * t12)));
    let d_strain_slope_d_flow = t17 * t35 + t34 * t21;
    dz[26] = d_strain_slope_d_flow;
    let d_strain_slope_d_EA = t33 * t24 - m_o * m_o * (t18 * (tau_hat_1 * t11))
        + t25 * t34;
    dz[27] = d_strain_slope_d_EA;
    let t36 = t11 * (tau_hat_1 * t5) - t18 * (t11 * (m_o * (tau_hat_1 * EA)))
        + t26 * t35;
    let d_strain_slope_d_m_o = t36 + t34 * t27;
    dz[28] = d_strain_slope_d_m_o;
    let d_strain_slope_d_R_P = t28 * t35 + t34 * t29;
    dz[29] = d_strain_slope_d_R_P;
    let d_strain_slope_d_omega_P = t3 * t35 + t34 * t30;
    dz[30] = d_strain_slope_d_omega_P;
}
