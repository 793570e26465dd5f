// belt_pulley_limits: How much of its friction a pair of tensions takes on a pulley.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 22 operations
//   jacobian: 67 operations
// Equations, with their numbers in the source:
// - ratio (typed in): F_fr
// - log_ratio (typed in): F_fr
// - capstan (typed in): F_fr
// - wedge_coefficient (typed in): f'
// - tension_ratio (typed in): F_fr
// - largest_ratio (typed in): F_fr
// - mean_coefficient (typed in): F_fr
// - used (typed in): μ
// - share (typed in): μ
// - odds (typed in): μ
// - log_odds (typed in): μ
// - creep (typed in): μ
// - moment (derived): T_S

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (1, 4),
    (1, 5),
    (2, 2),
    (2, 3),
    (3, 3),
    (3, 4),
    (3, 5),
    (4, 2),
    (4, 3),
    (4, 4),
    (4, 5),
    (5, 2),
    (5, 3),
    (5, 4),
    (5, 5),
    (5, 7),
    (6, 4),
    (6, 5),
    (6, 6),
];
///How much of its friction a pair of tensions takes on a pulley.
pub(crate) const KERNEL: FormulaKernel<BeltPulleyLimitInput, BeltPulleyLimit> = FormulaKernel::new(BoundaryKernel {
    name: "belt_pulley_limits",
    equations: BeltPulleyLimit::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: BeltPulleyLimitInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 8, "constants: too few values");
    let g = sized(g, 7, "g");
    let f_face = constants[0];
    let groove = constants[1];
    let (sin_0, _) = sin_cos(groove * 0.5);
    let wedge_coefficient = f_face * reciprocal(sin_0);
    g[0] = wedge_coefficient;
    let T_tight = constants[4];
    let T_slack = constants[5];
    let ratio = T_tight * reciprocal(T_slack);
    g[1] = ratio;
    let f = constants[2];
    let wrap = constants[3];
    let capstan = exp(f * wrap);
    g[2] = capstan;
    let log_ratio = ln(ratio);
    let mean_coefficient = log_ratio * reciprocal(wrap);
    g[3] = mean_coefficient;
    let used = mean_coefficient * reciprocal(f);
    g[4] = used;
    let V_thr = constants[7];
    let odds = (1.0 + used) * reciprocal(1.0 - used);
    let log_odds = ln(odds);
    let creep = 0.125 * (V_thr * log_odds);
    g[5] = creep;
    let R = constants[6];
    let moment = R * (T_tight - T_slack);
    g[6] = moment;
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
    let g = sized(g, 7, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let f_face = constants[0];
    let groove = constants[1];
    let t1 = groove * 0.5;
    let (sin_t1, cos_t1) = sin_cos(t1);
    let d_wedge_coefficient_d_f_face = reciprocal(sin_t1);
    let wedge_coefficient = f_face * d_wedge_coefficient_d_f_face;
    g[0] = wedge_coefficient;
    let T_tight = constants[4];
    let T_slack = constants[5];
    let d_tension_ratio_d_T_tight = reciprocal(T_slack);
    let ratio = T_tight * d_tension_ratio_d_T_tight;
    g[1] = ratio;
    let f = constants[2];
    let wrap = constants[3];
    let capstan = exp(f * wrap);
    g[2] = capstan;
    let log_ratio = ln(ratio);
    let t3 = reciprocal(wrap);
    let mean_coefficient = log_ratio * t3;
    g[3] = mean_coefficient;
    let t4 = reciprocal(f);
    let used = mean_coefficient * t4;
    g[4] = used;
    let V_thr = constants[7];
    let t5 = 1.0 + used;
    let t6 = 1.0 - used;
    let t7 = reciprocal(t6);
    let odds = t5 * t7;
    let log_odds = ln(odds);
    let creep = 0.125 * (V_thr * log_odds);
    g[5] = creep;
    let R = constants[6];
    let d_moment_d_R = T_tight - T_slack;
    let moment = R * d_moment_d_R;
    g[6] = moment;
    dz[0] = d_wedge_coefficient_d_f_face;
    let d_wedge_coefficient_d_groove = -(cos_t1
        * (d_wedge_coefficient_d_f_face * d_wedge_coefficient_d_f_face
            * (f_face * 0.5)));
    dz[1] = d_wedge_coefficient_d_groove;
    dz[2] = d_tension_ratio_d_T_tight;
    let t8 = T_tight * (d_tension_ratio_d_T_tight * d_tension_ratio_d_T_tight);
    let d_tension_ratio_d_T_slack = -t8;
    dz[3] = d_tension_ratio_d_T_slack;
    let d_largest_ratio_d_f = wrap * capstan;
    dz[4] = d_largest_ratio_d_f;
    let d_largest_ratio_d_wrap = f * capstan;
    dz[5] = d_largest_ratio_d_wrap;
    let t9 = log_ratio * (t3 * t3);
    let d_mean_coefficient_d_wrap = -t9;
    dz[6] = d_mean_coefficient_d_wrap;
    let t10 = t3 * (T_slack * reciprocal(T_tight));
    let d_mean_coefficient_d_T_tight = d_tension_ratio_d_T_tight * t10;
    dz[7] = d_mean_coefficient_d_T_tight;
    let t11 = t8 * t10;
    let d_mean_coefficient_d_T_slack = -t11;
    dz[8] = d_mean_coefficient_d_T_slack;
    let t12 = mean_coefficient * (t4 * t4);
    let d_share_d_f = -t12;
    dz[9] = d_share_d_f;
    let d_share_d_wrap = -(t4 * t9);
    dz[10] = d_share_d_wrap;
    let d_share_d_T_tight = t4 * d_mean_coefficient_d_T_tight;
    dz[11] = d_share_d_T_tight;
    let d_share_d_T_slack = -(t4 * t11);
    dz[12] = d_share_d_T_slack;
    let t13 = V_thr * 0.125 * ((t7 + t5 * (t7 * t7)) * (t6 * reciprocal(t5)));
    let d_creep_d_f = -(t12 * t13);
    dz[13] = d_creep_d_f;
    let t14 = t4 * t13;
    let d_creep_d_wrap = -(t9 * t14);
    dz[14] = d_creep_d_wrap;
    let d_creep_d_T_tight = d_mean_coefficient_d_T_tight * t14;
    dz[15] = d_creep_d_T_tight;
    let d_creep_d_T_slack = -(t11 * t14);
    dz[16] = d_creep_d_T_slack;
    let d_creep_d_V_thr = log_odds * 0.125;
    dz[17] = d_creep_d_V_thr;
    dz[18] = R;
    let d_moment_d_T_slack = -R;
    dz[19] = d_moment_d_T_slack;
    dz[20] = d_moment_d_R;
}
