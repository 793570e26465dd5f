// simple_drive: Residuals of a belt drive whose belt adheres, then slides.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 73 operations
//   jacobian: 286 operations
// Equations, with their numbers in the source:
// - tan_delta (typed in): (5)
// - K (derived): formula of K, 1.2
// - L_Oin (derived): (2.218)
// - L_Iin (derived): (7)
// - ratio_O (derived): (2.216)
// - ratio_I (derived): (10)
// - log_O (typed in): (2.221), (16)
// - Phi_O (derived): (2.221), (16)
// - log_I (typed in): (2.221), (16)
// - Phi_I (derived): (2.221), (16)
// - speed_O (derived): (2)
// - speed_I (derived): (18)
// - axial_O (derived): (5)
// - axial_I (derived): (13)

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (0, 3),
    (0, 6),
    (0, 8),
    (0, 9),
    (0, 11),
    (1, 0),
    (1, 1),
    (1, 2),
    (1, 6),
    (1, 8),
    (1, 9),
    (1, 11),
    (2, 1),
    (2, 3),
    (2, 5),
    (2, 6),
    (2, 9),
    (2, 10),
    (2, 11),
    (2, 12),
    (2, 13),
    (2, 14),
    (3, 0),
    (3, 2),
    (3, 4),
    (3, 6),
    (3, 8),
    (3, 10),
    (3, 11),
    (3, 12),
    (3, 13),
    (3, 14),
];
///Residuals of a belt drive whose belt adheres, then slides.
pub(crate) const KERNEL: FormulaKernel<SimpleDriveInput, SimpleDriveResidual> = FormulaKernel::new(BoundaryKernel {
    name: "simple_drive",
    equations: SimpleDriveResidual::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: SimpleDriveInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 15, "constants: too few values");
    let g = sized(g, 4, "g");
    let omega_I = constants[0];
    let r_I = constants[8];
    let t1 = omega_I * r_I;
    let omega_O = constants[1];
    let r_O = constants[9];
    let t2 = omega_O * r_O;
    let EA = constants[11];
    let t3 = reciprocal(EA);
    let t4 = reciprocal(r_O);
    let M_O = constants[3];
    let v_0 = constants[6];
    let speed_O = t1 - (t2 + t3 * (t4 * (M_O * v_0)));
    g[0] = speed_O;
    let t5 = reciprocal(r_I);
    let M_I = constants[2];
    let speed_I = t1 - (t2 - t3 * (t5 * (M_I * v_0)));
    g[1] = speed_I;
    let F_CO = constants[5];
    let mu_star = constants[13];
    let t6 = reciprocal(mu_star);
    let m_star = constants[12];
    let t7 = v_0 * v_0;
    let t8 = EA - m_star * t7;
    let K = reciprocal(t8) * (t7 * (EA * m_star));
    let t9 = EA * reciprocal(v_0);
    let t10 = (v_0 - t2) * t9;
    let t11 = K + t10;
    let phi_O = constants[10];
    let ratio_O = -((M_O - r_O * t10 - r_O * K) * (t4 * reciprocal(t11)));
    let log_O = ln(ratio_O);
    let Phi_O = log_O * t6;
    let delta_0 = constants[14];
    let (sin_delta_0, cos_delta_0) = sin_cos(delta_0);
    let t13 = cos_delta_0 * reciprocal(sin_delta_0) * (0.5 * (t8 * t3));
    let axial_O = F_CO - (t6 * (M_O * t4) - t11 * (phi_O * 2.0 - Phi_O)) * t13;
    g[2] = axial_O;
    let F_CI = constants[4];
    let t14 = t9 * (v_0 - t1);
    let t15 = K + t14;
    let ratio_I = (r_I * K + r_I * t14 - M_I) * (t5 * reciprocal(t15));
    let log_I = ln(ratio_I);
    let t16 = t13
        * (t15 * (t6 * log_I + 2.0 * (3.141592653589793 - phi_O)) + t6 * (M_I * t5));
    let axial_I = F_CI + t16;
    g[3] = axial_I;
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
    assert!(constants.len() >= 15, "constants: too few values");
    let g = sized(g, 4, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let omega_I = constants[0];
    let r_I = constants[8];
    let t1 = omega_I * r_I;
    let omega_O = constants[1];
    let r_O = constants[9];
    let t2 = omega_O * r_O;
    let EA = constants[11];
    let t3 = reciprocal(EA);
    let t4 = reciprocal(r_O);
    let M_O = constants[3];
    let v_0 = constants[6];
    let t5 = M_O * v_0;
    let t6 = t4 * t5;
    let speed_O = t1 - (t2 + t3 * t6);
    g[0] = speed_O;
    let t7 = reciprocal(r_I);
    let M_I = constants[2];
    let t8 = M_I * v_0;
    let t9 = t7 * t8;
    let speed_I = t1 - (t2 - t3 * t9);
    g[1] = speed_I;
    let F_CO = constants[5];
    let mu_star = constants[13];
    let t10 = reciprocal(mu_star);
    let t11 = M_O * t4;
    let m_star = constants[12];
    let t12 = v_0 * v_0;
    let t13 = m_star * t12;
    let t14 = EA - t13;
    let t15 = reciprocal(t14);
    let t16 = EA * m_star;
    let t17 = t12 * t16;
    let K = t15 * t17;
    let t18 = v_0 - t2;
    let t19 = reciprocal(v_0);
    let t20 = EA * t19;
    let t21 = t18 * t20;
    let t22 = K + t21;
    let phi_O = constants[10];
    let t23 = M_O - r_O * t21 - r_O * K;
    let t24 = reciprocal(t22);
    let t25 = t4 * t24;
    let ratio_O = -(t23 * t25);
    let log_O = ln(ratio_O);
    let Phi_O = log_O * t10;
    let t26 = phi_O * 2.0 - Phi_O;
    let t27 = t10 * t11 - t22 * t26;
    let delta_0 = constants[14];
    let (sin_delta_0, cos_delta_0) = sin_cos(delta_0);
    let t29 = cos_delta_0 * reciprocal(sin_delta_0);
    let t30 = 0.5 * (t14 * t3);
    let t31 = t29 * t30;
    let axial_O = F_CO - t27 * t31;
    g[2] = axial_O;
    let F_CI = constants[4];
    let t32 = v_0 - t1;
    let t33 = t20 * t32;
    let t34 = K + t33;
    let t35 = r_I * K + r_I * t33 - M_I;
    let t36 = reciprocal(t34);
    let t37 = t7 * t36;
    let ratio_I = t35 * t37;
    let log_I = ln(ratio_I);
    let t38 = t10 * log_I + 2.0 * (3.141592653589793 - phi_O);
    let t39 = M_I * t7;
    let t40 = t34 * t38 + t10 * t39;
    let axial_I = F_CI + t31 * t40;
    g[3] = axial_I;
    dz[0] = r_I;
    let d_speed_O_d_omega_O = -r_O;
    dz[1] = d_speed_O_d_omega_O;
    let d_speed_O_d_M_O = -(t3 * (v_0 * t4));
    dz[2] = d_speed_O_d_M_O;
    let d_speed_O_d_v_0 = -(t3 * t11);
    dz[3] = d_speed_O_d_v_0;
    dz[4] = omega_I;
    let t41 = t4 * t4;
    let d_speed_O_d_r_O = -(omega_O - t41 * (t3 * t5));
    dz[5] = d_speed_O_d_r_O;
    let t42 = t3 * t3;
    let d_speed_O_d_EA = t6 * t42;
    dz[6] = d_speed_O_d_EA;
    dz[7] = r_I;
    dz[8] = d_speed_O_d_omega_O;
    let d_speed_I_d_M_I = t3 * (v_0 * t7);
    dz[9] = d_speed_I_d_M_I;
    let d_speed_I_d_v_0 = t3 * t39;
    dz[10] = d_speed_I_d_v_0;
    let t43 = t7 * t7;
    let d_speed_I_d_r_I = omega_I - t43 * (t3 * t8);
    dz[11] = d_speed_I_d_r_I;
    let d_speed_I_d_r_O = -omega_O;
    dz[12] = d_speed_I_d_r_O;
    let d_speed_I_d_EA = -(t9 * t42);
    dz[13] = d_speed_I_d_EA;
    let t44 = t3 * (t14 * t22);
    let t45 = t29 * (0.5 * t44);
    let t46 = t45 * (t10 * (reciprocal(t23) * (r_O * t22)));
    let t47 = t26 * t31 + (t24 + t24 * t24 * (t4 * t23)) * t46;
    let d_axial_O_d_omega_O = -(t19 * (r_O * EA) * t47);
    dz[14] = d_axial_O_d_omega_O;
    let d_axial_O_d_M_O = -(t29 * (0.5 * (t3 * (t10 * (t14 * t4)))) + t25 * t46);
    dz[15] = d_axial_O_d_M_O;
    dz[16] = 1.0;
    let t48 = t29 * (t3 * (v_0 * m_star));
    let t49 = t19 * t19;
    let t50 = v_0 * t12;
    let t51 = t15 * t15;
    let t52 = 2.0 * (t15 * (m_star * (v_0 * EA)))
        + m_star * m_star * (t50 * (t51 * (EA * 2.0)));
    let d_axial_O_d_v_0 = t27 * t48 - (t49 * (EA * t18) - t20) * t47 + t52 * t47;
    dz[17] = d_axial_O_d_v_0;
    let t53 = M_O * t14;
    let t54 = t41 * (t29 * (0.5 * (t3 * (t10 * t53)))) + (t4 + t41 * (t24 * t23)) * t46;
    let d_axial_O_d_r_O = t54 - t19 * (omega_O * EA) * t47;
    dz[18] = d_axial_O_d_r_O;
    let d_axial_O_d_phi_O = t29 * t44;
    dz[19] = d_axial_O_d_phi_O;
    let t55 = t29 * (t14 * 0.5);
    let t56 = t29 * (t3 * 0.5);
    let t57 = t13 * t15 - t17 * t51;
    let d_axial_O_d_EA = t42 * (t27 * t55) - t27 * t56 + t19 * t18 * t47 + t57 * t47;
    dz[20] = d_axial_O_d_EA;
    let t58 = t29 * (0.5 * (t12 * t3));
    let t59 = t15 * (EA * t12) + v_0 * t50 * (t16 * t51);
    let d_axial_O_d_m_star = t27 * t58 + t59 * t47;
    dz[21] = d_axial_O_d_m_star;
    let t60 = t10 * t10;
    let d_axial_O_d_mu_star = t60 * (t29 * (0.5 * (t3 * (t4 * t53))))
        + log_O * t60 * t45;
    dz[22] = d_axial_O_d_mu_star;
    let tan_delta = sin_delta_0 * reciprocal(cos_delta_0);
    let t61 = 1.0 + tan_delta * tan_delta;
    let t62 = t29 * t29;
    let d_axial_O_d_delta_0 = t61 * (t62 * (t27 * t30));
    dz[23] = d_axial_O_d_delta_0;
    let t63 = t3 * (t14 * t34);
    let t64 = t29 * (0.5 * t63);
    let t65 = t64 * (t10 * (reciprocal(t35) * (r_I * t34)));
    let t66 = t31 * t38 + (t36 - t36 * t36 * (t7 * t35)) * t65;
    let d_axial_I_d_omega_I = -(t19 * (r_I * EA) * t66);
    dz[24] = d_axial_I_d_omega_I;
    let d_axial_I_d_M_I = t29 * (0.5 * (t3 * (t10 * (t14 * t7)))) - t37 * t65;
    dz[25] = d_axial_I_d_M_I;
    dz[26] = 1.0;
    let d_axial_I_d_v_0 = t52 * t66 - (t40 * t48 + (t49 * (EA * t32) - t20) * t66);
    dz[27] = d_axial_I_d_v_0;
    let t67 = M_I * t14;
    let t68 = (t7 - t43 * (t36 * t35)) * t65 - t43 * (t29 * (0.5 * (t3 * (t10 * t67))));
    let d_axial_I_d_r_I = t68 - t19 * (omega_I * EA) * t66;
    dz[28] = d_axial_I_d_r_I;
    let d_axial_I_d_phi_O = -(t29 * t63);
    dz[29] = d_axial_I_d_phi_O;
    let d_axial_I_d_EA = t40 * t56 - t42 * (t40 * t55) + t19 * t32 * t66 + t57 * t66;
    dz[30] = d_axial_I_d_EA;
    let d_axial_I_d_m_star = t59 * t66 - t40 * t58;
    dz[31] = d_axial_I_d_m_star;
    let d_axial_I_d_mu_star = -(t60 * (t29 * (0.5 * (t3 * (t7 * t67))))
        + log_I * t60 * t64);
    dz[32] = d_axial_I_d_mu_star;
    let d_axial_I_d_delta_0 = -(t61 * (t62 * (t30 * t40)));
    dz[33] = d_axial_I_d_delta_0;
}
