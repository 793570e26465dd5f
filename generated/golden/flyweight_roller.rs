// flyweight_roller: Axial force of pivoted arms whose rollers bear on ramps of the movable sheave.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 39 operations
//   jacobian: 147 operations
// Equations, with their numbers in the source:
// - tan_rho (typed in): ρ
// - sin_r (typed in): kinematics
// - cos_r (typed in): kinematics
// - gap (typed in): contact
// - along (typed in): kinematics
// - radius (typed in): kinematics
// - moment (typed in): centrifugal moment
// - h_t (typed in): ρ
// - theta_s (derived): contact
// - radius_s (derived): kinematics
// - force (derived): virtual work

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (0, 2),
    (0, 3),
    (0, 4),
    (0, 5),
    (0, 6),
    (0, 7),
    (0, 9),
    (0, 10),
    (1, 3),
    (1, 4),
    (1, 5),
    (1, 8),
    (2, 3),
    (2, 5),
    (3, 3),
    (3, 5),
    (3, 9),
    (4, 3),
    (4, 4),
    (4, 6),
    (4, 7),
    (5, 3),
    (5, 5),
    (5, 6),
    (5, 7),
    (5, 9),
    (6, 0),
    (6, 1),
    (6, 2),
    (6, 3),
    (6, 4),
    (6, 6),
    (6, 7),
];
///Axial force of pivoted arms whose rollers bear on ramps of the movable sheave.
pub(crate) const KERNEL: FormulaKernel<FlyweightRollerInput, FlyweightRollerOutput> = FormulaKernel::new(BoundaryKernel {
    name: "flyweight_roller",
    equations: FlyweightRollerOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: FlyweightRollerInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 11, "constants: too few values");
    let g = sized(g, 7, "g");
    let theta = constants[3];
    let (sin_theta, cos_theta) = sin_cos(theta);
    let h_x = constants[9];
    let rho = constants[10];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let h_t = reciprocal(1.0 + h_x * tan_rho) * (h_x - tan_rho);
    let l_roller = constants[5];
    let t3 = reciprocal(l_roller);
    let delta = constants[7];
    let t4 = theta + delta;
    let (sin_t4, cos_t4) = sin_cos(t4);
    let omega = constants[2];
    let R_pivot = constants[4];
    let l_m = constants[6];
    let radius = R_pivot + l_m * sin_t4;
    let N = constants[0];
    let m = constants[1];
    let moment = cos_t4 * (omega * omega * (radius * (l_m * (N * m))));
    let force = reciprocal(cos_theta - sin_theta * h_t) * (t3 * (moment * h_t));
    g[0] = force;
    let h = constants[8];
    let gap = R_pivot + l_roller * sin_theta - h;
    g[1] = gap;
    let along = l_roller * cos_theta;
    g[2] = along;
    let t6 = reciprocal(cos_theta - h_x * sin_theta);
    let theta_s = t6 * (h_x * t3);
    g[3] = theta_s;
    g[4] = radius;
    let radius_s = t6 * (t3 * (cos_t4 * (l_m * h_x)));
    g[5] = radius_s;
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
    assert!(constants.len() >= 11, "constants: too few values");
    let g = sized(g, 7, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let theta = constants[3];
    let (sin_theta, cos_theta) = sin_cos(theta);
    let h_x = constants[9];
    let rho = constants[10];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let t3 = reciprocal(1.0 + h_x * tan_rho);
    let t4 = h_x - tan_rho;
    let h_t = t3 * t4;
    let t5 = reciprocal(cos_theta - sin_theta * h_t);
    let l_roller = constants[5];
    let t6 = reciprocal(l_roller);
    let delta = constants[7];
    let t7 = theta + delta;
    let (sin_t7, cos_t7) = sin_cos(t7);
    let omega = constants[2];
    let t9 = omega * omega;
    let R_pivot = constants[4];
    let l_m = constants[6];
    let radius = R_pivot + l_m * sin_t7;
    let N = constants[0];
    let m = constants[1];
    let t10 = N * m;
    let t11 = l_m * t10;
    let moment = cos_t7 * (t9 * (radius * t11));
    let t12 = moment * h_t;
    let t13 = t6 * t12;
    let force = t5 * t13;
    g[0] = force;
    let t14 = l_roller * sin_theta;
    let h = constants[8];
    let gap = R_pivot + t14 - h;
    g[1] = gap;
    let along = l_roller * cos_theta;
    g[2] = along;
    let t15 = h_x * sin_theta;
    let t16 = reciprocal(cos_theta - t15);
    let t17 = h_x * t6;
    let theta_s = t16 * t17;
    g[3] = theta_s;
    g[4] = radius;
    let t18 = l_m * h_x;
    let t19 = cos_t7 * t18;
    let t20 = t6 * t19;
    let radius_s = t16 * t20;
    g[5] = radius_s;
    g[6] = moment;
    let d_moment_d_N = cos_t7 * (t9 * (radius * (m * l_m)));
    let t21 = t5 * (h_t * t6);
    let d_force_d_N = d_moment_d_N * t21;
    dz[0] = d_force_d_N;
    let d_moment_d_m = cos_t7 * (t9 * (radius * (N * l_m)));
    let d_force_d_m = d_moment_d_m * t21;
    dz[1] = d_force_d_m;
    let d_moment_d_omega = 2.0 * (cos_t7 * (radius * (l_m * (omega * t10))));
    let d_force_d_omega = d_moment_d_omega * t21;
    dz[2] = d_force_d_omega;
    let t22 = t5 * t5;
    let t23 = moment * t6;
    let d_radius_d_theta = l_m * cos_t7;
    let d_moment_d_R_pivot = cos_t7 * (t9 * t11);
    let d_moment_d_theta = d_radius_d_theta * d_moment_d_R_pivot
        - t9 * (radius * (sin_t7 * t11));
    let d_force_d_delta = t21 * d_moment_d_theta;
    let d_force_d_theta = cos_theta * (h_t * h_t * (t22 * t23)) + sin_theta * (t13 * t22)
        + d_force_d_delta;
    dz[3] = d_force_d_theta;
    let d_force_d_R_pivot = d_moment_d_R_pivot * t21;
    dz[4] = d_force_d_R_pivot;
    let t24 = t6 * t6;
    let d_force_d_l_roller = -(t24 * (t5 * t12));
    dz[5] = d_force_d_l_roller;
    let d_moment_d_l_m = cos_t7 * (t9 * (radius * t10)) + sin_t7 * d_moment_d_R_pivot;
    let d_force_d_l_m = t21 * d_moment_d_l_m;
    dz[6] = d_force_d_l_m;
    dz[7] = d_force_d_delta;
    let t25 = t3 * t3;
    let t26 = t22 * (t6 * (h_t * (sin_theta * moment))) + t5 * t23;
    let d_force_d_h_x = (t3 - t25 * (tan_rho * t4)) * t26;
    dz[8] = d_force_d_h_x;
    let d_force_d_rho = -(t26 * ((1.0 + tan_rho * tan_rho) * (t3 + t25 * (h_x * t4))));
    dz[9] = d_force_d_rho;
    dz[10] = along;
    dz[11] = 1.0;
    dz[12] = sin_theta;
    let d_gap_d_h = -1.0;
    dz[13] = d_gap_d_h;
    let d_along_d_theta = -t14;
    dz[14] = d_along_d_theta;
    dz[15] = cos_theta;
    let t27 = h_x * h_x;
    let t28 = t16 * t16;
    let d_theta_s_d_theta = cos_theta * (t27 * (t6 * t28)) + sin_theta * (t17 * t28);
    dz[16] = d_theta_s_d_theta;
    let d_theta_s_d_l_roller = -(t24 * (h_x * t16));
    dz[17] = d_theta_s_d_l_roller;
    let d_theta_s_d_h_x = t28 * (t15 * t6) + t6 * t16;
    dz[18] = d_theta_s_d_h_x;
    dz[19] = d_radius_d_theta;
    dz[20] = 1.0;
    dz[21] = sin_t7;
    dz[22] = d_radius_d_theta;
    let t29 = t6 * d_radius_d_theta;
    let t30 = t16 * (t6 * (sin_t7 * t18));
    let d_radius_s_d_theta = cos_theta * (t27 * (t28 * t29)) - t30
        + sin_theta * (t20 * t28);
    dz[23] = d_radius_s_d_theta;
    let d_radius_s_d_l_roller = -(t24 * (t16 * t19));
    dz[24] = d_radius_s_d_l_roller;
    let d_radius_s_d_l_m = t16 * (t6 * (h_x * cos_t7));
    dz[25] = d_radius_s_d_l_m;
    let d_radius_s_d_delta = -t30;
    dz[26] = d_radius_s_d_delta;
    let d_radius_s_d_h_x = t28 * (t6 * (cos_t7 * (sin_theta * t18))) + t16 * t29;
    dz[27] = d_radius_s_d_h_x;
    dz[28] = d_moment_d_N;
    dz[29] = d_moment_d_m;
    dz[30] = d_moment_d_omega;
    dz[31] = d_moment_d_theta;
    dz[32] = d_moment_d_R_pivot;
    dz[33] = d_moment_d_l_m;
    dz[34] = d_moment_d_theta;
}
