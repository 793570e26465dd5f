// hysteresis_contact: What hysteresis follows along the belt in a groove.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 49 operations
//   jacobian: 229 operations
// Equations, with their numbers in the source:
// - theta_1 (typed in): (5.2)
// - theta_2 (typed in): (5.3)
// - arc (typed in): (3.4)
// - G (typed in): definition of the flow coefficient
// - F (derived): (3.10)
// - V (derived): (3.11)
// - stretch (typed in): (3.9)
// - material (typed in): (5.55)
// - curvature (derived): (3.26)
// - curvature_slope (derived): (3.26), (3.9)
// - penetration_slope (derived): (3.24), (3.9)
// - strain (typed in): (3.9)
// - strain_slope (derived): (3.9), (3.10)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (0, 4),
    (0, 6),
    (0, 7),
    (0, 8),
    (0, 9),
    (0, 10),
    (0, 11),
    (0, 12),
    (1, 1),
    (1, 2),
    (1, 4),
    (1, 6),
    (1, 7),
    (2, 0),
    (2, 1),
    (2, 2),
    (2, 3),
    (2, 4),
    (2, 6),
    (2, 7),
    (2, 8),
    (2, 9),
    (2, 10),
    (2, 11),
    (2, 12),
    (3, 0),
    (3, 8),
    (3, 9),
    (3, 10),
    (3, 11),
    (3, 12),
    (4, 0),
    (4, 1),
    (4, 4),
    (4, 5),
    (4, 6),
    (4, 7),
    (4, 8),
    (4, 9),
    (4, 10),
    (4, 11),
    (4, 12),
    (5, 0),
    (5, 1),
    (5, 8),
    (5, 9),
    (5, 10),
    (5, 11),
    (5, 12),
];
///What hysteresis follows along the belt in a groove.
pub(crate) const KERNEL: FormulaKernel<
    HysteresisContactInput,
    HysteresisContactOutput,
> = FormulaKernel::new(BoundaryKernel {
    name: "hysteresis_contact",
    equations: HysteresisContactOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: HysteresisContactInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 13, "constants: too few values");
    let g = sized(g, 6, "g");
    let EA = constants[9];
    let m_o = constants[10];
    let omega_P = constants[12];
    let R_P = constants[11];
    let flow = constants[8];
    let G = omega_P * (R_P * (flow * m_o));
    let t1 = G * G;
    let t2 = reciprocal(EA * m_o - t1);
    let T = constants[0];
    let F = t2 * (EA * (t1 + T * m_o));
    let t3 = EA + F;
    let Phi = constants[6];
    let R = constants[7];
    let x = constants[4];
    let t4 = R - x;
    let theta = constants[1];
    let (sin_theta, cos_theta) = sin_cos(theta);
    let arc = t4 * reciprocal(cos_theta);
    let material = EA * reciprocal(t3) * (Phi * arc);
    g[0] = material;
    let t6 = reciprocal(t4);
    let theta1 = constants[2];
    let t7 = reciprocal(Phi);
    let theta_1 = theta1 * t7;
    let curvature = t6 * (cos_theta * (1.0 - theta_1));
    g[1] = curvature;
    let theta2 = constants[3];
    let theta_2 = theta2 * (t7 * t7);
    let t8 = reciprocal(EA);
    let stretch = t8 * t3;
    let t9 = (cos_theta * theta_2 + sin_theta - sin_theta * (theta_1 * theta_1))
        * (t6 * t6 * (cos_theta * stretch));
    let curvature_slope = -t9;
    g[2] = curvature_slope;
    let strain = F * t8;
    g[3] = strain;
    let T_hat_1 = constants[5];
    let strain_slope = stretch * (t7 * (cos_theta * t6)) * (t2 * (T_hat_1 * m_o));
    g[4] = strain_slope;
    let penetration_slope = -(stretch * sin_theta);
    g[5] = penetration_slope;
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
    assert!(constants.len() >= 13, "constants: too few values");
    let g = sized(g, 6, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let EA = constants[9];
    let m_o = constants[10];
    let t1 = EA * m_o;
    let omega_P = constants[12];
    let R_P = constants[11];
    let flow = constants[8];
    let t2 = flow * m_o;
    let t3 = R_P * t2;
    let G = omega_P * t3;
    let t4 = G * G;
    let t5 = reciprocal(t1 - t4);
    let T = constants[0];
    let t6 = t4 + T * m_o;
    let F = t5 * (EA * t6);
    let t7 = EA + F;
    let t8 = EA * reciprocal(t7);
    let Phi = constants[6];
    let R = constants[7];
    let x = constants[4];
    let t9 = R - x;
    let theta = constants[1];
    let (sin_theta, cos_theta) = sin_cos(theta);
    let t11 = reciprocal(cos_theta);
    let arc = t9 * t11;
    let t12 = Phi * arc;
    let material = t8 * t12;
    g[0] = material;
    let t13 = reciprocal(t9);
    let theta1 = constants[2];
    let t14 = reciprocal(Phi);
    let theta_1 = theta1 * t14;
    let t15 = 1.0 - theta_1;
    let t16 = cos_theta * t15;
    let curvature = t13 * t16;
    g[1] = curvature;
    let theta2 = constants[3];
    let t17 = t14 * t14;
    let theta_2 = theta2 * t17;
    let t18 = theta_1 * theta_1;
    let t19 = cos_theta * theta_2 + sin_theta - sin_theta * t18;
    let t20 = t13 * t13;
    let t21 = reciprocal(EA);
    let stretch = t21 * t7;
    let t22 = cos_theta * stretch;
    let t23 = t20 * t22;
    let curvature_slope = -(t19 * t23);
    g[2] = curvature_slope;
    let strain = F * t21;
    g[3] = strain;
    let t24 = cos_theta * t13;
    let t25 = t14 * t24;
    let t26 = stretch * t25;
    let T_hat_1 = constants[5];
    let t27 = T_hat_1 * m_o;
    let t28 = t5 * t27;
    let strain_slope = t26 * t28;
    g[4] = strain_slope;
    let penetration_slope = -(stretch * sin_theta);
    g[5] = penetration_slope;
    let t29 = t1 * t5;
    let t30 = t12 * (t8 * t8);
    let t31 = t21 * t30;
    let d_material_d_T = -(t29 * t31);
    dz[0] = d_material_d_T;
    let t32 = Phi * t8;
    let d_material_d_theta = t11 * t11 * (t9 * sin_theta) * t32;
    dz[1] = d_material_d_theta;
    let d_material_d_R = t11 * t32;
    let d_material_d_x = -d_material_d_R;
    dz[2] = d_material_d_x;
    let d_material_d_Phi = arc * t8;
    dz[3] = d_material_d_Phi;
    dz[4] = d_material_d_R;
    let t33 = omega_P * (m_o * R_P);
    let t34 = t5 * t5;
    let t35 = EA * G;
    let t36 = t34 * (2.0 * (t6 * t35)) + 2.0 * (t5 * t35);
    let t37 = t33 * t36;
    let d_material_d_flow = -(t31 * t37);
    dz[5] = d_material_d_flow;
    let t38 = t21 * t21;
    let t39 = t21 - t7 * t38;
    let t40 = t39 * t30;
    let t41 = t6 * t5 - t34 * (t1 * t6);
    let d_material_d_EA = -(t40 + t41 * t31);
    dz[6] = d_material_d_EA;
    let t42 = omega_P * (flow * R_P);
    let t43 = t5 * (T * EA) - EA * EA * (t6 * t34) + t42 * t36;
    let d_material_d_m_o = -(t31 * t43);
    dz[7] = d_material_d_m_o;
    let t44 = omega_P * t2;
    let t45 = t44 * t36;
    let d_material_d_R_P = -(t31 * t45);
    dz[8] = d_material_d_R_P;
    let t46 = t3 * t36;
    let d_material_d_omega_P = -(t31 * t46);
    dz[9] = d_material_d_omega_P;
    let d_curvature_d_theta = -(sin_theta * (t15 * t13));
    dz[10] = d_curvature_d_theta;
    let d_curvature_d_theta1 = -t25;
    dz[11] = d_curvature_d_theta1;
    let d_curvature_d_x = t16 * t20;
    dz[12] = d_curvature_d_x;
    let t47 = theta1 * t17;
    let d_curvature_d_Phi = t24 * t47;
    dz[13] = d_curvature_d_Phi;
    let d_curvature_d_R = -d_curvature_d_x;
    dz[14] = d_curvature_d_R;
    let t48 = t19 * (cos_theta * t20);
    let t49 = t21 * t48;
    let d_curvature_slope_d_T = -(t29 * t49);
    dz[15] = d_curvature_slope_d_T;
    let t50 = stretch * t20;
    let d_curvature_slope_d_theta = t19 * (sin_theta * t50)
        - t23 * (cos_theta - theta_2 * sin_theta - cos_theta * t18);
    dz[16] = d_curvature_slope_d_theta;
    let t51 = 2.0 * (sin_theta * (t20 * (stretch * (cos_theta * theta_1))));
    let d_curvature_slope_d_theta1 = t14 * t51;
    dz[17] = d_curvature_slope_d_theta1;
    let t52 = t50 * (cos_theta * cos_theta);
    let d_curvature_slope_d_theta2 = -(t17 * t52);
    dz[18] = d_curvature_slope_d_theta2;
    let d_curvature_slope_d_R = t13 * t20 * (2.0 * (t19 * t22));
    let d_curvature_slope_d_x = -d_curvature_slope_d_R;
    dz[19] = d_curvature_slope_d_x;
    let d_curvature_slope_d_Phi = t14 * t17 * (theta2 * 2.0) * t52 - t47 * t51;
    dz[20] = d_curvature_slope_d_Phi;
    dz[21] = d_curvature_slope_d_R;
    let d_curvature_slope_d_flow = -(t49 * t37);
    dz[22] = d_curvature_slope_d_flow;
    let d_curvature_slope_d_EA = -(t39 * t48 + t41 * t49);
    dz[23] = d_curvature_slope_d_EA;
    let d_curvature_slope_d_m_o = -(t49 * t43);
    dz[24] = d_curvature_slope_d_m_o;
    let d_curvature_slope_d_R_P = -(t49 * t45);
    dz[25] = d_curvature_slope_d_R_P;
    let d_curvature_slope_d_omega_P = -(t49 * t46);
    dz[26] = d_curvature_slope_d_omega_P;
    let d_strain_d_T = t21 * t29;
    dz[27] = d_strain_d_T;
    let d_strain_d_flow = t21 * t37;
    dz[28] = d_strain_d_flow;
    let d_strain_d_EA = t21 * t41 - F * t38;
    dz[29] = d_strain_d_EA;
    let d_strain_d_m_o = t21 * t43;
    dz[30] = d_strain_d_m_o;
    let d_strain_d_R_P = t21 * t45;
    dz[31] = d_strain_d_R_P;
    let d_strain_d_omega_P = t21 * t46;
    dz[32] = d_strain_d_omega_P;
    let t53 = t28 * (t26 * t26);
    let t54 = t53 * t31;
    let d_strain_slope_d_T = t29 * t54;
    dz[33] = d_strain_slope_d_T;
    let d_strain_slope_d_theta = -(t53 * d_material_d_theta);
    dz[34] = d_strain_slope_d_theta;
    let d_strain_slope_d_x = t53 * d_material_d_R;
    dz[35] = d_strain_slope_d_x;
    let d_strain_slope_d_T_hat_1 = t26 * (m_o * t5);
    dz[36] = d_strain_slope_d_T_hat_1;
    let d_strain_slope_d_Phi = -(d_material_d_Phi * t53);
    dz[37] = d_strain_slope_d_Phi;
    let d_strain_slope_d_R = -d_strain_slope_d_x;
    dz[38] = d_strain_slope_d_R;
    let t55 = t34 * (2.0 * (t26 * (G * t27)));
    let d_strain_slope_d_flow = t33 * t55 + t37 * t54;
    dz[39] = d_strain_slope_d_flow;
    let d_strain_slope_d_EA = t53 * t40 - m_o * m_o * (t34 * (T_hat_1 * t26))
        + t41 * t54;
    dz[40] = d_strain_slope_d_EA;
    let t56 = t26 * (T_hat_1 * t5) - t34 * (t26 * (m_o * (T_hat_1 * EA))) + t42 * t55;
    let d_strain_slope_d_m_o = t56 + t43 * t54;
    dz[41] = d_strain_slope_d_m_o;
    let d_strain_slope_d_R_P = t44 * t55 + t45 * t54;
    dz[42] = d_strain_slope_d_R_P;
    let d_strain_slope_d_omega_P = t3 * t55 + t46 * t54;
    dz[43] = d_strain_slope_d_omega_P;
    let t57 = t21 * sin_theta;
    let d_penetration_slope_d_T = -(t29 * t57);
    dz[44] = d_penetration_slope_d_T;
    let d_penetration_slope_d_theta = -t22;
    dz[45] = d_penetration_slope_d_theta;
    let d_penetration_slope_d_flow = -(t57 * t37);
    dz[46] = d_penetration_slope_d_flow;
    let d_penetration_slope_d_EA = -(sin_theta * t39 + t41 * t57);
    dz[47] = d_penetration_slope_d_EA;
    let d_penetration_slope_d_m_o = -(t57 * t43);
    dz[48] = d_penetration_slope_d_m_o;
    let d_penetration_slope_d_R_P = -(t57 * t45);
    dz[49] = d_penetration_slope_d_R_P;
    let d_penetration_slope_d_omega_P = -(t57 * t46);
    dz[50] = d_penetration_slope_d_omega_P;
}
