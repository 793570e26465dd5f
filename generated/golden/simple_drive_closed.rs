// simple_drive_closed: What follows without iteration in a drive whose belt adheres, then slides.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 141 operations
//   jacobian: 632 operations
// Equations, with their numbers in the source:
// - tan_delta (typed in): (5)
// - K (derived): formula of K, 1.2
// - L_Oin (derived): (2.218)
// - L_Iin (derived): (7)
// - a_O (derived): 2.220
// - b_O (derived): 2.220
// - c_O (derived): 2.220
// - root_O (typed in): 2.220
// - v_0_O (typed in): 2.220
// - a_I (derived): (15)
// - b_I (derived): (15)
// - c_I (derived): (15)
// - root_I (typed in): (15)
// - v_0_I (typed in): (15)
// - omega_O_of_M_O (derived): (21)
// - omega_I_of_M_O (derived): (2)
// - M_O_of_speeds (derived): (17)
// - M_I_of_speeds (derived): (19)
// - M_O_of_M_I (derived): (11)
// - M_I_of_M_O (derived): (20)
// - lift_off (typed in): 1.2
// - slack_force (typed in): 1.2
// - tight_force (typed in): 1.2
// - slack_tension (derived): (12)
// - tight_tension (derived): (12)
// - ratio_O (typed in): (22)
// - ratio_I (typed in): (25)
// - log_O (typed in): (2.221), (16)
// - Phi_O (derived): (2.221), (16)
// - log_I (typed in): (2.221), (16)
// - Phi_I (derived): (2.221), (16)
// - sliding_O (derived): (22), (25)
// - F_CO_of_speeds (derived): (23), (26)
// - F_slip_O (derived): (5) and (13) where all of the contact slides
// - sliding_I (derived): (22), (25)
// - F_CI_of_speeds (derived): (23), (26)
// - F_slip_I (derived): (5) and (13) where all of the contact slides

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 5),
    (0, 7),
    (0, 10),
    (0, 11),
    (0, 12),
    (0, 14),
    (1, 4),
    (1, 7),
    (1, 10),
    (1, 11),
    (1, 12),
    (1, 14),
    (2, 0),
    (2, 3),
    (2, 6),
    (2, 8),
    (2, 9),
    (2, 11),
    (3, 1),
    (3, 3),
    (3, 6),
    (3, 8),
    (3, 9),
    (3, 11),
    (4, 0),
    (4, 1),
    (4, 6),
    (4, 8),
    (4, 9),
    (4, 11),
    (5, 0),
    (5, 1),
    (5, 6),
    (5, 8),
    (5, 9),
    (5, 11),
    (6, 2),
    (6, 8),
    (6, 9),
    (7, 3),
    (7, 8),
    (7, 9),
    (8, 6),
    (8, 11),
    (8, 12),
    (9, 1),
    (9, 6),
    (9, 9),
    (9, 11),
    (10, 0),
    (10, 6),
    (10, 8),
    (10, 11),
    (11, 1),
    (11, 6),
    (11, 9),
    (11, 11),
    (11, 12),
    (12, 0),
    (12, 6),
    (12, 8),
    (12, 11),
    (12, 12),
    (13, 0),
    (13, 1),
    (13, 6),
    (13, 8),
    (13, 9),
    (13, 11),
    (13, 12),
    (13, 13),
    (14, 0),
    (14, 1),
    (14, 6),
    (14, 8),
    (14, 9),
    (14, 11),
    (14, 12),
    (14, 13),
    (15, 0),
    (15, 1),
    (15, 6),
    (15, 8),
    (15, 9),
    (15, 10),
    (15, 11),
    (15, 12),
    (15, 13),
    (15, 14),
    (16, 0),
    (16, 1),
    (16, 6),
    (16, 8),
    (16, 9),
    (16, 10),
    (16, 11),
    (16, 12),
    (16, 13),
    (16, 14),
    (17, 3),
    (17, 6),
    (17, 9),
    (17, 11),
    (17, 12),
    (17, 13),
    (17, 14),
    (18, 2),
    (18, 6),
    (18, 8),
    (18, 11),
    (18, 12),
    (18, 13),
    (18, 14),
];
///What follows without iteration in a drive whose belt adheres, then slides.
pub(crate) const KERNEL: FormulaKernel<SimpleDriveInput, SimpleDriveOutput> = FormulaKernel::new(BoundaryKernel {
    name: "simple_drive_closed",
    equations: SimpleDriveOutput::SYMBOLS,
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
    let g = sized(g, 19, "g");
    let phi_O = constants[10];
    let EA = constants[11];
    let t1 = phi_O * EA;
    let F_CO = constants[5];
    let delta_0 = constants[14];
    let (sin_delta_0, cos_delta_0) = sin_cos(delta_0);
    let tan_delta = sin_delta_0 * reciprocal(cos_delta_0);
    let b_O = t1 + F_CO * tan_delta;
    let m_star = constants[12];
    let u = constants[7];
    let t3 = u * phi_O;
    let a_O = m_star * t3;
    let t4 = EA * t3;
    let root_O = sqrt(4.0 * (a_O * t4) + b_O * b_O);
    let v_0_O = reciprocal(b_O + root_O) * (t4 * 2.0);
    g[0] = v_0_O;
    let t5 = phi_O - 3.141592653589793;
    let c_I = t5 * (u * EA);
    let F_CI = constants[4];
    let t6 = t1 - F_CI * tan_delta - EA * 3.141592653589793;
    let root_I = sqrt(c_I * (4.0 * (t5 * (u * m_star))) + t6 * t6);
    let v_0_I = -(reciprocal(root_I - t6) * (2.0 * c_I));
    g[1] = v_0_I;
    let r_O = constants[9];
    let omega_I = constants[0];
    let r_I = constants[8];
    let t7 = omega_I * r_I;
    let M_O = constants[3];
    let v_0 = constants[6];
    let t8 = M_O * v_0;
    let t9 = reciprocal(EA);
    let t10 = reciprocal(r_O);
    let omega_O_of_M_O = (EA * (r_O * t7) - t8) * (t9 * (t10 * t10));
    g[2] = omega_O_of_M_O;
    let omega_O = constants[1];
    let t11 = reciprocal(r_I);
    let omega_I_of_M_O = (t8 + r_O * r_O * (omega_O * EA)) * (t11 * (t9 * t10));
    g[3] = omega_I_of_M_O;
    let t12 = omega_O * r_O;
    let t13 = t12 - t7;
    let t14 = reciprocal(v_0);
    let t15 = t13 * (t14 * (r_O * EA));
    let M_O_of_speeds = -t15;
    g[4] = M_O_of_speeds;
    let M_I_of_speeds = t13 * (t14 * (r_I * EA));
    g[5] = M_I_of_speeds;
    let M_I = constants[2];
    let M_O_of_M_I = -(t11 * (M_I * r_O));
    g[6] = M_O_of_M_I;
    let M_I_of_M_O = -(t10 * (M_O * r_I));
    g[7] = M_I_of_M_O;
    let t16 = v_0 * v_0;
    let t17 = m_star * t16;
    let t18 = EA - t17;
    let K = reciprocal(t18) * (t16 * (EA * m_star));
    g[8] = K;
    let t19 = EA * t14;
    let t20 = (v_0 - t12) * t19;
    let L_Oin = -t20;
    g[9] = L_Oin;
    let t21 = t19 * (v_0 - t7);
    let L_Iin = -t21;
    g[10] = L_Iin;
    let slack_tension = -(t20 + t17 * (1.0 - t20 * t9));
    g[11] = slack_tension;
    let tight_tension = -(t21 + t17 * (1.0 - t21 * t9));
    g[12] = tight_tension;
    let t22 = K + t21;
    let t23 = K + t20;
    let ratio_O = t22 * reciprocal(t23);
    let log_O = ln(ratio_O);
    let mu_star = constants[13];
    let t24 = reciprocal(mu_star);
    let Phi_O = log_O * t24;
    g[13] = Phi_O;
    let ratio_I = t23 * reciprocal(t22);
    let log_I = ln(ratio_I);
    let t25 = t24 * log_I;
    let Phi_I = -t25;
    g[14] = Phi_I;
    let t26 = cos_delta_0 * reciprocal(sin_delta_0);
    let t27 = t26 * (0.5 * (t18 * t9));
    let F_CO_of_speeds = -((t23 * (phi_O * 2.0 - Phi_O) + t24 * (t10 * t15)) * t27);
    g[15] = F_CO_of_speeds;
    let F_CI_of_speeds = -(t27 * (t22 * (t25 - 2.0 * t5) + t24 * (t11 * M_I_of_speeds)));
    g[16] = F_CI_of_speeds;
    let F_slip_O = t26 * (0.5 * (t24 * (t10 * (t9 * (M_O * t18)))));
    g[17] = F_slip_O;
    let F_slip_I = -(0.5 * (t26 * (t24 * (t11 * (t9 * (M_I * t18))))));
    g[18] = F_slip_I;
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
    let g = sized(g, 19, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let phi_O = constants[10];
    let EA = constants[11];
    let t1 = phi_O * EA;
    let F_CO = constants[5];
    let delta_0 = constants[14];
    let (sin_delta_0, cos_delta_0) = sin_cos(delta_0);
    let tan_delta = sin_delta_0 * reciprocal(cos_delta_0);
    let b_O = t1 + F_CO * tan_delta;
    let m_star = constants[12];
    let u = constants[7];
    let t3 = u * phi_O;
    let a_O = m_star * t3;
    let t4 = EA * t3;
    let root_O = sqrt(4.0 * (a_O * t4) + b_O * b_O);
    let t5 = reciprocal(b_O + root_O);
    let t6 = t4 * 2.0;
    let v_0_O = t5 * t6;
    g[0] = v_0_O;
    let t7 = phi_O - 3.141592653589793;
    let t8 = u * EA;
    let c_I = t7 * t8;
    let t9 = u * m_star;
    let t10 = 4.0 * (t7 * t9);
    let F_CI = constants[4];
    let t11 = t1 - F_CI * tan_delta - EA * 3.141592653589793;
    let root_I = sqrt(c_I * t10 + t11 * t11);
    let t12 = reciprocal(root_I - t11);
    let t13 = 2.0 * c_I;
    let v_0_I = -(t12 * t13);
    g[1] = v_0_I;
    let r_O = constants[9];
    let omega_I = constants[0];
    let r_I = constants[8];
    let t14 = omega_I * r_I;
    let M_O = constants[3];
    let v_0 = constants[6];
    let t15 = M_O * v_0;
    let t16 = EA * (r_O * t14) - t15;
    let t17 = reciprocal(EA);
    let t18 = reciprocal(r_O);
    let t19 = t18 * t18;
    let t20 = t17 * t19;
    let omega_O_of_M_O = t16 * t20;
    g[2] = omega_O_of_M_O;
    let t21 = r_O * r_O;
    let omega_O = constants[1];
    let t22 = omega_O * EA;
    let t23 = t15 + t21 * t22;
    let t24 = reciprocal(r_I);
    let t25 = t17 * t18;
    let omega_I_of_M_O = t23 * (t24 * t25);
    g[3] = omega_I_of_M_O;
    let t26 = omega_O * r_O;
    let t27 = t26 - t14;
    let t28 = reciprocal(v_0);
    let t29 = r_O * EA;
    let d_slack_force_d_omega_O = t28 * t29;
    let t30 = t27 * d_slack_force_d_omega_O;
    let M_O_of_speeds = -t30;
    g[4] = M_O_of_speeds;
    let t31 = r_I * EA;
    let d_tight_force_d_omega_I = t28 * t31;
    let M_I_of_speeds = t27 * d_tight_force_d_omega_I;
    g[5] = M_I_of_speeds;
    let M_I = constants[2];
    let t32 = M_I * r_O;
    let M_O_of_M_I = -(t24 * t32);
    g[6] = M_O_of_M_I;
    let t33 = M_O * r_I;
    let M_I_of_M_O = -(t18 * t33);
    g[7] = M_I_of_M_O;
    let t34 = v_0 * v_0;
    let t35 = m_star * t34;
    let t36 = EA - t35;
    let t37 = reciprocal(t36);
    let t38 = EA * m_star;
    let t39 = t34 * t38;
    let K = t37 * t39;
    g[8] = K;
    let t40 = v_0 - t26;
    let t41 = EA * t28;
    let t42 = t40 * t41;
    let L_Oin = -t42;
    g[9] = L_Oin;
    let t43 = v_0 - t14;
    let t44 = t41 * t43;
    let L_Iin = -t44;
    g[10] = L_Iin;
    let t45 = 1.0 - t42 * t17;
    let slack_tension = -(t42 + t35 * t45);
    g[11] = slack_tension;
    let t46 = 1.0 - t44 * t17;
    let tight_tension = -(t44 + t35 * t46);
    g[12] = tight_tension;
    let t47 = K + t44;
    let t48 = K + t42;
    let t49 = reciprocal(t48);
    let ratio_O = t47 * t49;
    let log_O = ln(ratio_O);
    let mu_star = constants[13];
    let t50 = reciprocal(mu_star);
    let Phi_O = log_O * t50;
    g[13] = Phi_O;
    let t51 = reciprocal(t47);
    let ratio_I = t48 * t51;
    let log_I = ln(ratio_I);
    let t52 = t50 * log_I;
    let Phi_I = -t52;
    g[14] = Phi_I;
    let t53 = phi_O * 2.0 - Phi_O;
    let t54 = t48 * t53 + t50 * (t18 * t30);
    let t55 = cos_delta_0 * reciprocal(sin_delta_0);
    let t56 = t36 * t17;
    let t57 = t55 * (0.5 * t56);
    let F_CO_of_speeds = -(t54 * t57);
    g[15] = F_CO_of_speeds;
    let t58 = t52 - 2.0 * t7;
    let t59 = t47 * t58 + t50 * (t24 * M_I_of_speeds);
    let F_CI_of_speeds = -(t57 * t59);
    g[16] = F_CI_of_speeds;
    let t60 = M_O * t36;
    let t61 = t17 * t60;
    let t62 = t18 * t61;
    let t63 = 0.5 * (t50 * t62);
    let F_slip_O = t55 * t63;
    g[17] = F_slip_O;
    let t64 = M_I * t36;
    let t65 = t17 * t64;
    let t66 = t24 * t65;
    let t67 = t50 * t66;
    let F_slip_I = -(0.5 * (t55 * t67));
    g[18] = F_slip_I;
    let t68 = t6 * (t5 * t5);
    let t69 = 0.5 * reciprocal(root_O);
    let t70 = t68 + t69 * (b_O * 2.0) * t68;
    let d_v_0_O_d_F_CO = -(tan_delta * t70);
    dz[0] = d_v_0_O_d_F_CO;
    let t71 = t69 * (t4 * 4.0);
    let t72 = t69 * (a_O * 4.0) * t68 - 2.0 * t5;
    let d_v_0_O_d_u = -(t68 * (phi_O * m_star * t71) + t1 * t72);
    dz[1] = d_v_0_O_d_u;
    let d_v_0_O_d_phi_O = -(t68 * (t9 * t71) + t8 * t72 + EA * t70);
    dz[2] = d_v_0_O_d_phi_O;
    let d_v_0_O_d_EA = -(t3 * t72 + phi_O * t70);
    dz[3] = d_v_0_O_d_EA;
    let d_v_0_O_d_m_star = -(t68 * (t3 * t71));
    dz[4] = d_v_0_O_d_m_star;
    let t73 = 1.0 + tan_delta * tan_delta;
    let d_v_0_O_d_delta_0 = -(t73 * (F_CO * t70));
    dz[5] = d_v_0_O_d_delta_0;
    let t74 = t13 * (t12 * t12);
    let t75 = 0.5 * reciprocal(root_I);
    let t76 = t74 - t75 * (2.0 * t11) * t74;
    let d_v_0_I_d_F_CI = tan_delta * t76;
    dz[6] = d_v_0_I_d_F_CI;
    let t77 = t75 * (4.0 * c_I);
    let t78 = t10 * t75 * t74 - 2.0 * t12;
    let d_v_0_I_d_u = t74 * (m_star * t7 * t77) + EA * t7 * t78;
    dz[7] = d_v_0_I_d_u;
    let d_v_0_I_d_phi_O = t74 * (t9 * t77) + t8 * t78 - EA * t76;
    dz[8] = d_v_0_I_d_phi_O;
    let t79 = u * t7;
    let d_v_0_I_d_EA = t79 * t78 - t7 * t76;
    dz[9] = d_v_0_I_d_EA;
    let d_v_0_I_d_m_star = t74 * (t79 * t77);
    dz[10] = d_v_0_I_d_m_star;
    let d_v_0_I_d_delta_0 = t73 * (F_CI * t76);
    dz[11] = d_v_0_I_d_delta_0;
    let d_omega_O_of_M_O_d_omega_I = r_I * t18;
    dz[12] = d_omega_O_of_M_O_d_omega_I;
    let t80 = v_0 * t17;
    let d_omega_O_of_M_O_d_M_O = -(t19 * t80);
    dz[13] = d_omega_O_of_M_O_d_M_O;
    let t81 = M_O * t17;
    let d_omega_O_of_M_O_d_v_0 = -(t19 * t81);
    dz[14] = d_omega_O_of_M_O_d_v_0;
    let d_omega_O_of_M_O_d_r_I = omega_I * t18;
    dz[15] = d_omega_O_of_M_O_d_r_I;
    let d_omega_O_of_M_O_d_r_O = t14 * t19 - t18 * t19 * (t16 * (2.0 * t17));
    dz[16] = d_omega_O_of_M_O_d_r_O;
    let t82 = t17 * t17;
    let d_omega_O_of_M_O_d_EA = t18 * (t14 * t17) - t82 * (t19 * t16);
    dz[17] = d_omega_O_of_M_O_d_EA;
    let d_omega_I_of_M_O_d_omega_O = r_O * t24;
    dz[18] = d_omega_I_of_M_O_d_omega_O;
    let d_omega_I_of_M_O_d_M_O = t24 * (t18 * t80);
    dz[19] = d_omega_I_of_M_O_d_M_O;
    let t83 = t18 * t81;
    let d_omega_I_of_M_O_d_v_0 = t24 * t83;
    dz[20] = d_omega_I_of_M_O_d_v_0;
    let t84 = t24 * t24;
    let d_omega_I_of_M_O_d_r_I = -(t84 * (t23 * t25));
    dz[21] = d_omega_I_of_M_O_d_r_I;
    let d_omega_I_of_M_O_d_r_O = t24 * (omega_O * 2.0) - t23 * (t20 * t24);
    dz[22] = d_omega_I_of_M_O_d_r_O;
    let d_omega_I_of_M_O_d_EA = t24 * (t26 * t17) - t82 * (t23 * (t18 * t24));
    dz[23] = d_omega_I_of_M_O_d_EA;
    let d_M_O_of_speeds_d_omega_I = t28 * (EA * (r_I * r_O));
    dz[24] = d_M_O_of_speeds_d_omega_I;
    let t85 = t41 * t21;
    let d_M_O_of_speeds_d_omega_O = -t85;
    dz[25] = d_M_O_of_speeds_d_omega_O;
    let t86 = t28 * t28;
    let d_M_O_of_speeds_d_v_0 = t86 * (t27 * t29);
    dz[26] = d_M_O_of_speeds_d_v_0;
    let d_M_O_of_speeds_d_r_I = t28 * (EA * (omega_I * r_O));
    dz[27] = d_M_O_of_speeds_d_r_I;
    let t87 = t41 * t27;
    let t88 = t28 * (EA * t26) + t87;
    let d_M_O_of_speeds_d_r_O = -t88;
    dz[28] = d_M_O_of_speeds_d_r_O;
    let t89 = t27 * (r_O * t28);
    let d_M_O_of_speeds_d_EA = -t89;
    dz[29] = d_M_O_of_speeds_d_EA;
    let t90 = t41 * (r_I * r_I);
    let d_M_I_of_speeds_d_omega_I = -t90;
    dz[30] = d_M_I_of_speeds_d_omega_I;
    dz[31] = d_M_O_of_speeds_d_omega_I;
    let t91 = t86 * (t27 * t31);
    let d_M_I_of_speeds_d_v_0 = -t91;
    dz[32] = d_M_I_of_speeds_d_v_0;
    let d_M_I_of_speeds_d_r_I = t87 - t28 * (EA * t14);
    dz[33] = d_M_I_of_speeds_d_r_I;
    let d_M_I_of_speeds_d_r_O = t28 * (EA * (omega_O * r_I));
    dz[34] = d_M_I_of_speeds_d_r_O;
    let d_M_I_of_speeds_d_EA = t27 * (r_I * t28);
    dz[35] = d_M_I_of_speeds_d_EA;
    let d_M_O_of_M_I_d_M_I = -d_omega_I_of_M_O_d_omega_O;
    dz[36] = d_M_O_of_M_I_d_M_I;
    let d_M_O_of_M_I_d_r_I = t32 * t84;
    dz[37] = d_M_O_of_M_I_d_r_I;
    let d_M_O_of_M_I_d_r_O = -(M_I * t24);
    dz[38] = d_M_O_of_M_I_d_r_O;
    let d_M_I_of_M_O_d_M_O = -d_omega_O_of_M_O_d_omega_I;
    dz[39] = d_M_I_of_M_O_d_M_O;
    let d_M_I_of_M_O_d_r_I = -(M_O * t18);
    dz[40] = d_M_I_of_M_O_d_r_I;
    let d_M_I_of_M_O_d_r_O = t19 * t33;
    dz[41] = d_M_I_of_M_O_d_r_O;
    let t92 = v_0 * t34;
    let t93 = t37 * t37;
    let d_lift_off_d_v_0 = 2.0 * (t37 * (m_star * (v_0 * EA)))
        + m_star * m_star * (t92 * (t93 * (EA * 2.0)));
    dz[42] = d_lift_off_d_v_0;
    let d_lift_off_d_EA = t35 * t37 - t39 * t93;
    dz[43] = d_lift_off_d_EA;
    let d_lift_off_d_m_star = t37 * (EA * t34) + v_0 * t92 * (t38 * t93);
    dz[44] = d_lift_off_d_m_star;
    dz[45] = d_slack_force_d_omega_O;
    let d_slack_force_d_v_0 = t86 * (EA * t40) - t41;
    dz[46] = d_slack_force_d_v_0;
    let d_slack_force_d_r_O = t28 * t22;
    dz[47] = d_slack_force_d_r_O;
    let t94 = t28 * t40;
    let d_slack_force_d_EA = -t94;
    dz[48] = d_slack_force_d_EA;
    dz[49] = d_tight_force_d_omega_I;
    let d_tight_force_d_v_0 = t86 * (EA * t43) - t41;
    dz[50] = d_tight_force_d_v_0;
    let d_tight_force_d_r_I = t28 * (omega_I * EA);
    dz[51] = d_tight_force_d_r_I;
    let t95 = t28 * t43;
    let d_tight_force_d_EA = -t95;
    dz[52] = d_tight_force_d_EA;
    let t96 = 1.0 - t35 * t17;
    let d_slack_tension_d_omega_O = d_slack_force_d_omega_O * t96;
    dz[53] = d_slack_tension_d_omega_O;
    let t97 = v_0 * m_star;
    let t98 = 2.0 * t97;
    let d_slack_tension_d_v_0 = d_slack_force_d_v_0 * t96 - t45 * t98;
    dz[54] = d_slack_tension_d_v_0;
    let d_slack_tension_d_r_O = d_slack_force_d_r_O * t96;
    dz[55] = d_slack_tension_d_r_O;
    let d_slack_tension_d_EA = -(t82 * (t35 * t42) + t94 * t96);
    dz[56] = d_slack_tension_d_EA;
    let d_slack_tension_d_m_star = -(t34 * t45);
    dz[57] = d_slack_tension_d_m_star;
    let d_tight_tension_d_omega_I = d_tight_force_d_omega_I * t96;
    dz[58] = d_tight_tension_d_omega_I;
    let d_tight_tension_d_v_0 = d_tight_force_d_v_0 * t96 - t46 * t98;
    dz[59] = d_tight_tension_d_v_0;
    let d_tight_tension_d_r_I = d_tight_force_d_r_I * t96;
    dz[60] = d_tight_tension_d_r_I;
    let d_tight_tension_d_EA = -(t82 * (t35 * t44) + t95 * t96);
    dz[61] = d_tight_tension_d_EA;
    let d_tight_tension_d_m_star = -(t34 * t46);
    dz[62] = d_tight_tension_d_m_star;
    let t99 = ratio_I * t50;
    let t100 = t49 * t99;
    let d_sliding_O_d_omega_I = -(d_tight_force_d_omega_I * t100);
    dz[63] = d_sliding_O_d_omega_I;
    let t101 = t47 * (t49 * t49);
    let t102 = t101 * t99;
    let d_sliding_O_d_omega_O = d_slack_force_d_omega_O * t102;
    dz[64] = d_sliding_O_d_omega_O;
    let t103 = (t49 - t101) * t99;
    let d_sliding_O_d_v_0 = d_lift_off_d_v_0 * t103 + d_slack_force_d_v_0 * t102
        - d_tight_force_d_v_0 * t100;
    dz[65] = d_sliding_O_d_v_0;
    let d_sliding_O_d_r_I = -(d_tight_force_d_r_I * t100);
    dz[66] = d_sliding_O_d_r_I;
    let d_sliding_O_d_r_O = d_slack_force_d_r_O * t102;
    dz[67] = d_sliding_O_d_r_O;
    let d_sliding_O_d_EA = d_lift_off_d_EA * t103 - t94 * t102 + t95 * t100;
    dz[68] = d_sliding_O_d_EA;
    let d_sliding_O_d_m_star = d_lift_off_d_m_star * t103;
    dz[69] = d_sliding_O_d_m_star;
    let t104 = t50 * t50;
    let t105 = log_O * t104;
    let d_sliding_O_d_mu_star = -t105;
    dz[70] = d_sliding_O_d_mu_star;
    let t106 = t48 * (t51 * t51);
    let t107 = ratio_O * t50;
    let t108 = t106 * t107;
    let d_sliding_I_d_omega_I = -(d_tight_force_d_omega_I * t108);
    dz[71] = d_sliding_I_d_omega_I;
    let t109 = t51 * t107;
    let d_sliding_I_d_omega_O = d_slack_force_d_omega_O * t109;
    dz[72] = d_sliding_I_d_omega_O;
    let t110 = (t51 - t106) * t107;
    let d_sliding_I_d_v_0 = d_slack_force_d_v_0 * t109 - d_lift_off_d_v_0 * t110
        - d_tight_force_d_v_0 * t108;
    dz[73] = d_sliding_I_d_v_0;
    let d_sliding_I_d_r_I = -(d_tight_force_d_r_I * t108);
    dz[74] = d_sliding_I_d_r_I;
    let d_sliding_I_d_r_O = d_slack_force_d_r_O * t109;
    dz[75] = d_sliding_I_d_r_O;
    let d_sliding_I_d_EA = t95 * t108 - (d_lift_off_d_EA * t110 + t94 * t109);
    dz[76] = d_sliding_I_d_EA;
    let d_sliding_I_d_m_star = -(d_lift_off_d_m_star * t110);
    dz[77] = d_sliding_I_d_m_star;
    let d_sliding_I_d_mu_star = log_I * t104;
    dz[78] = d_sliding_I_d_mu_star;
    let t111 = t18 * t56;
    let d_F_slip_O_d_M_O = t55 * (0.5 * (t50 * t111));
    let t112 = t55 * (t17 * (t36 * t48));
    let t113 = 0.5 * t112;
    let t114 = t113 * t100;
    let d_F_CO_of_speeds_d_omega_I = d_M_O_of_speeds_d_omega_I * d_F_slip_O_d_M_O
        - d_tight_force_d_omega_I * t114;
    dz[79] = d_F_CO_of_speeds_d_omega_I;
    let t115 = t53 * t57 + t113 * t102;
    let d_F_CO_of_speeds_d_omega_O = d_slack_force_d_omega_O * t115
        - t85 * d_F_slip_O_d_M_O;
    dz[80] = d_F_CO_of_speeds_d_omega_O;
    let t116 = t55 * (t17 * t97);
    let t117 = t55 * t56;
    let t118 = t113 * t103 - 0.5 * (t53 * t117);
    let d_F_CO_of_speeds_d_v_0 = t54 * t116 + d_M_O_of_speeds_d_v_0 * d_F_slip_O_d_M_O
        + d_lift_off_d_v_0 * t118 + d_slack_force_d_v_0 * t115
        - d_tight_force_d_v_0 * t114;
    dz[81] = d_F_CO_of_speeds_d_v_0;
    let d_F_CO_of_speeds_d_r_I = d_M_O_of_speeds_d_r_I * d_F_slip_O_d_M_O
        - d_tight_force_d_r_I * t114;
    dz[82] = d_F_CO_of_speeds_d_r_I;
    let d_F_CO_of_speeds_d_r_O = 0.5 * (t55 * (t50 * (t30 * (t19 * t56))))
        - t88 * d_F_slip_O_d_M_O + d_slack_force_d_r_O * t115;
    dz[83] = d_F_CO_of_speeds_d_r_O;
    let d_F_CO_of_speeds_d_phi_O = -t112;
    dz[84] = d_F_CO_of_speeds_d_phi_O;
    let t119 = t36 * t55;
    let t120 = t55 * (t17 * 0.5);
    let t121 = t82 * (0.5 * (t54 * t119)) - t54 * t120 - t89 * d_F_slip_O_d_M_O
        + d_lift_off_d_EA * t118;
    let d_F_CO_of_speeds_d_EA = t121 - t94 * t115 + t95 * t114;
    dz[85] = d_F_CO_of_speeds_d_EA;
    let t122 = t55 * (t34 * t17);
    let d_F_CO_of_speeds_d_m_star = 0.5 * (t54 * t122) + d_lift_off_d_m_star * t118;
    dz[86] = d_F_CO_of_speeds_d_m_star;
    let d_F_CO_of_speeds_d_mu_star = t104 * (0.5 * (t55 * (t30 * t111))) - t105 * t113;
    dz[87] = d_F_CO_of_speeds_d_mu_star;
    let t123 = t55 * t55;
    let d_F_CO_of_speeds_d_delta_0 = t73 * (t123 * (0.5 * (t54 * t56)));
    dz[88] = d_F_CO_of_speeds_d_delta_0;
    let t124 = t24 * t56;
    let t125 = 0.5 * (t55 * (t50 * t124));
    let d_F_CI_of_speeds_d_phi_O = t55 * (t17 * (t36 * t47));
    let t126 = 0.5 * d_F_CI_of_speeds_d_phi_O;
    let t127 = t57 * t58 - t126 * t108;
    let d_F_CI_of_speeds_d_omega_I = t90 * t125 + d_tight_force_d_omega_I * t127;
    dz[89] = d_F_CI_of_speeds_d_omega_I;
    let t128 = t126 * t109;
    let d_F_CI_of_speeds_d_omega_O = d_slack_force_d_omega_O * t128
        - d_M_O_of_speeds_d_omega_I * t125;
    dz[90] = d_F_CI_of_speeds_d_omega_O;
    let t129 = 0.5 * (t58 * t117) + t126 * t110;
    let d_F_CI_of_speeds_d_v_0 = t59 * t116 + t91 * t125 - d_lift_off_d_v_0 * t129
        + d_slack_force_d_v_0 * t128 + d_tight_force_d_v_0 * t127;
    dz[91] = d_F_CI_of_speeds_d_v_0;
    let d_F_CI_of_speeds_d_r_I = t84 * (t55 * (0.5 * (t50 * (M_I_of_speeds * t56))))
        - d_M_I_of_speeds_d_r_I * t125 + d_tight_force_d_r_I * t127;
    dz[92] = d_F_CI_of_speeds_d_r_I;
    let d_F_CI_of_speeds_d_r_O = d_slack_force_d_r_O * t128
        - d_M_I_of_speeds_d_r_O * t125;
    dz[93] = d_F_CI_of_speeds_d_r_O;
    dz[94] = d_F_CI_of_speeds_d_phi_O;
    let t130 = t82 * (0.5 * (t59 * t119)) - t59 * t120 - d_M_I_of_speeds_d_EA * t125
        - d_lift_off_d_EA * t129;
    let d_F_CI_of_speeds_d_EA = t130 - t94 * t128 - t95 * t127;
    dz[95] = d_F_CI_of_speeds_d_EA;
    let d_F_CI_of_speeds_d_m_star = 0.5 * (t59 * t122) - d_lift_off_d_m_star * t129;
    dz[96] = d_F_CI_of_speeds_d_m_star;
    let d_F_CI_of_speeds_d_mu_star = t104 * (t55 * (0.5 * (M_I_of_speeds * t124)))
        + d_sliding_I_d_mu_star * t126;
    dz[97] = d_F_CI_of_speeds_d_mu_star;
    let d_F_CI_of_speeds_d_delta_0 = t73 * (t123 * (0.5 * (t56 * t59)));
    dz[98] = d_F_CI_of_speeds_d_delta_0;
    dz[99] = d_F_slip_O_d_M_O;
    let d_F_slip_O_d_v_0 = -(t55 * (t50 * (t18 * (t17 * (m_star * t15)))));
    dz[100] = d_F_slip_O_d_v_0;
    let d_F_slip_O_d_r_O = -(0.5 * (t55 * (t50 * (t19 * t61))));
    dz[101] = d_F_slip_O_d_r_O;
    let d_F_slip_O_d_EA = t55 * (0.5 * (t50 * t83))
        - t82 * (0.5 * (t55 * (t50 * (t18 * t60))));
    dz[102] = d_F_slip_O_d_EA;
    let d_F_slip_O_d_m_star = -(0.5 * (t55 * (t50 * (t18 * (t17 * (M_O * t34))))));
    dz[103] = d_F_slip_O_d_m_star;
    let d_F_slip_O_d_mu_star = -(t104 * (0.5 * (t55 * t62)));
    dz[104] = d_F_slip_O_d_mu_star;
    let d_F_slip_O_d_delta_0 = -(t73 * (t63 * t123));
    dz[105] = d_F_slip_O_d_delta_0;
    let d_F_slip_I_d_M_I = -t125;
    dz[106] = d_F_slip_I_d_M_I;
    let d_F_slip_I_d_v_0 = t55 * (t50 * (t24 * (t17 * (m_star * (M_I * v_0)))));
    dz[107] = d_F_slip_I_d_v_0;
    let d_F_slip_I_d_r_I = t84 * (t55 * (0.5 * (t50 * t65)));
    dz[108] = d_F_slip_I_d_r_I;
    let d_F_slip_I_d_EA = t82 * (t55 * (0.5 * (t50 * (t24 * t64))))
        - 0.5 * (t55 * (t50 * (t24 * (M_I * t17))));
    dz[109] = d_F_slip_I_d_EA;
    let d_F_slip_I_d_m_star = t55 * (0.5 * (t50 * (t24 * (t17 * (M_I * t34)))));
    dz[110] = d_F_slip_I_d_m_star;
    let d_F_slip_I_d_mu_star = t104 * (t55 * (0.5 * t66));
    dz[111] = d_F_slip_I_d_mu_star;
    let d_F_slip_I_d_delta_0 = t73 * (t123 * (0.5 * t67));
    dz[112] = d_F_slip_I_d_delta_0;
}
