// flyweight_arm: Axial force of pivoted cam arms that bear on rollers.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 43 operations
//   jacobian: 176 operations
// Equations, with their numbers in the source:
// - tan_rho (typed in): ρ
// - z (typed in): kinematics
// - distance (typed in): kinematics
// - chi (typed in): kinematics
// - theta (typed in): kinematics
// - phi_m (typed in): kinematics
// - sin_m (typed in): kinematics
// - cos_m (typed in): kinematics
// - radius (typed in): kinematics
// - moment (typed in): centrifugal moment
// - tan_e (typed in): pitch curve
// - tan_t (derived): ρ
// - distance_s (typed in): kinematics
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
    (0, 8),
    (0, 9),
    (0, 10),
    (0, 11),
    (1, 3),
    (1, 4),
    (1, 5),
    (1, 6),
    (2, 3),
    (2, 4),
    (2, 5),
    (2, 6),
    (3, 3),
    (3, 4),
    (3, 5),
    (3, 6),
    (3, 7),
    (3, 8),
    (3, 9),
    (4, 3),
    (4, 4),
    (4, 5),
    (4, 6),
    (4, 7),
    (4, 8),
    (4, 9),
    (4, 10),
    (5, 0),
    (5, 1),
    (5, 2),
    (5, 3),
    (5, 4),
    (5, 5),
    (5, 6),
    (5, 7),
    (5, 8),
    (5, 9),
];
///Axial force of pivoted cam arms that bear on rollers.
pub(crate) const KERNEL: FormulaKernel<FlyweightArmInput, FlyweightArmOutput> = FormulaKernel::new(BoundaryKernel {
    name: "flyweight_arm",
    equations: FlyweightArmOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: FlyweightArmInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 12, "constants: too few values");
    let g = sized(g, 6, "g");
    let R_roller = constants[6];
    let R_pivot = constants[5];
    let t1 = R_roller - R_pivot;
    let s = constants[3];
    let z_0 = constants[4];
    let z = s + z_0;
    let distance = sqrt(z * z + t1 * t1);
    let t2 = reciprocal(distance);
    let t3 = t1 * t2;
    let rho = constants[11];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let xi_d = constants[10];
    let tan_e = xi_d * distance;
    let tan_t = reciprocal(1.0 - tan_rho * tan_e) * (tan_rho + tan_e);
    let omega = constants[2];
    let l_m = constants[7];
    let delta = constants[8];
    let chi = angle(z, t1);
    let xi = constants[9];
    let theta = chi - xi;
    let phi_m = delta + theta;
    let (sin_phi_m, cos_phi_m) = sin_cos(phi_m);
    let radius = R_pivot + l_m * sin_phi_m;
    let N = constants[0];
    let m = constants[1];
    let moment = omega * omega * (radius * (cos_phi_m * (l_m * (N * m))));
    let force = -((t3 + t2 * (z * tan_t)) * (moment * t2));
    g[0] = force;
    g[1] = distance;
    let distance_s = z * t2;
    g[2] = distance_s;
    g[3] = radius;
    let radius_s = -((t2 * (z * tan_e) + t3) * (t2 * (l_m * cos_phi_m)));
    g[4] = radius_s;
    g[5] = moment;
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
    assert!(constants.len() >= 12, "constants: too few values");
    let g = sized(g, 6, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let R_roller = constants[6];
    let R_pivot = constants[5];
    let t1 = R_roller - R_pivot;
    let s = constants[3];
    let z_0 = constants[4];
    let z = s + z_0;
    let t2 = z * z + t1 * t1;
    let distance = sqrt(t2);
    let t3 = reciprocal(distance);
    let t4 = t1 * t3;
    let rho = constants[11];
    let (sin_rho, cos_rho) = sin_cos(rho);
    let tan_rho = sin_rho * reciprocal(cos_rho);
    let xi_d = constants[10];
    let tan_e = xi_d * distance;
    let t6 = reciprocal(1.0 - tan_rho * tan_e);
    let t7 = tan_rho + tan_e;
    let tan_t = t6 * t7;
    let t8 = z * tan_t;
    let t9 = t4 + t3 * t8;
    let omega = constants[2];
    let t10 = omega * omega;
    let l_m = constants[7];
    let delta = constants[8];
    let chi = angle(z, t1);
    let xi = constants[9];
    let theta = chi - xi;
    let phi_m = delta + theta;
    let (sin_phi_m, cos_phi_m) = sin_cos(phi_m);
    let radius = R_pivot + l_m * sin_phi_m;
    let N = constants[0];
    let m = constants[1];
    let t12 = N * m;
    let t13 = l_m * t12;
    let t14 = cos_phi_m * t13;
    let moment = t10 * (radius * t14);
    let t15 = moment * t3;
    let force = -(t9 * t15);
    g[0] = force;
    g[1] = distance;
    let distance_s = z * t3;
    g[2] = distance_s;
    g[3] = radius;
    let t16 = z * tan_e;
    let t17 = t3 * t16 + t4;
    let d_radius_d_delta = l_m * cos_phi_m;
    let t18 = t3 * d_radius_d_delta;
    let radius_s = -(t17 * t18);
    g[4] = radius_s;
    g[5] = moment;
    let d_moment_d_N = t10 * (radius * (cos_phi_m * (m * l_m)));
    let t19 = t3 * t9;
    let d_force_d_N = -(d_moment_d_N * t19);
    dz[0] = d_force_d_N;
    let d_moment_d_m = t10 * (radius * (cos_phi_m * (N * l_m)));
    let d_force_d_m = -(d_moment_d_m * t19);
    dz[1] = d_force_d_m;
    let d_moment_d_omega = 2.0 * (radius * (cos_phi_m * (l_m * (omega * t12))));
    let d_force_d_omega = -(d_moment_d_omega * t19);
    dz[2] = d_force_d_omega;
    let t20 = t3 * 0.5;
    let d_distance_d_s = t20 * (z * 2.0);
    let t21 = t3 * t3;
    let t22 = t1 * t21;
    let t23 = t6 * t6;
    let t24 = t21 * (z * moment);
    let t25 = (t6 + t23 * (tan_rho * t7)) * t24;
    let t26 = t15 * (t22 + t8 * t21) + t21 * (moment * t9) - xi_d * t25;
    let t27 = reciprocal(t2);
    let t28 = t1 * t27;
    let t29 = t10 * t14;
    let d_moment_d_delta = d_radius_d_delta * t29 - sin_phi_m * (t10 * (radius * t13));
    let d_force_d_xi = t19 * d_moment_d_delta;
    let d_force_d_s = d_distance_d_s * t26 - t21 * (moment * tan_t) + t28 * d_force_d_xi;
    dz[3] = d_force_d_s;
    dz[4] = d_force_d_s;
    let t30 = moment * t21;
    let d_distance_d_R_roller = t20 * (t1 * 2.0);
    let t31 = d_distance_d_R_roller * t26;
    let t32 = z * t27;
    let t33 = t32 * d_force_d_xi;
    let d_force_d_R_pivot = t30 - t29 * t19 - t31 + t33;
    dz[5] = d_force_d_R_pivot;
    let d_force_d_R_roller = t31 - t30 - t33;
    dz[6] = d_force_d_R_roller;
    let d_moment_d_l_m = t10 * (radius * (cos_phi_m * t12)) + sin_phi_m * t29;
    let d_force_d_l_m = -(t19 * d_moment_d_l_m);
    dz[7] = d_force_d_l_m;
    let d_force_d_delta = -d_force_d_xi;
    dz[8] = d_force_d_delta;
    dz[9] = d_force_d_xi;
    let d_force_d_xi_d = -(distance * t25);
    dz[10] = d_force_d_xi_d;
    let d_force_d_rho = -(t24 * ((1.0 + tan_rho * tan_rho) * (t6 + t23 * (tan_e * t7))));
    dz[11] = d_force_d_rho;
    dz[12] = d_distance_d_s;
    dz[13] = d_distance_d_s;
    let d_distance_d_R_pivot = -d_distance_d_R_roller;
    dz[14] = d_distance_d_R_pivot;
    dz[15] = d_distance_d_R_roller;
    let t34 = z * t21;
    let d_distance_s_d_s = t3 - d_distance_d_s * t34;
    dz[16] = d_distance_s_d_s;
    dz[17] = d_distance_s_d_s;
    let d_distance_s_d_R_pivot = d_distance_d_R_roller * t34;
    dz[18] = d_distance_s_d_R_pivot;
    let d_distance_s_d_R_roller = -d_distance_s_d_R_pivot;
    dz[19] = d_distance_s_d_R_roller;
    let d_radius_d_s = -(d_radius_d_delta * t28);
    dz[20] = d_radius_d_s;
    dz[21] = d_radius_d_s;
    let d_radius_d_R_roller = d_radius_d_delta * t32;
    let d_radius_d_R_pivot = 1.0 - d_radius_d_R_roller;
    dz[22] = d_radius_d_R_pivot;
    dz[23] = d_radius_d_R_roller;
    dz[24] = sin_phi_m;
    dz[25] = d_radius_d_delta;
    let d_radius_d_xi = -d_radius_d_delta;
    dz[26] = d_radius_d_xi;
    let t35 = t21 * (cos_phi_m * (l_m * z));
    let t36 = t18 * (t16 * t21 + t22) + t21 * (t17 * d_radius_d_delta) - xi_d * t35;
    let d_radius_s_d_delta = sin_phi_m * (t17 * (l_m * t3));
    let d_radius_s_d_s = d_distance_d_s * t36 - t21 * (tan_e * d_radius_d_delta)
        - t28 * d_radius_s_d_delta;
    dz[27] = d_radius_s_d_s;
    dz[28] = d_radius_s_d_s;
    let d_radius_s_d_R_pivot = d_radius_d_delta * t21 - d_distance_d_R_roller * t36
        - t32 * d_radius_s_d_delta;
    dz[29] = d_radius_s_d_R_pivot;
    let d_radius_s_d_R_roller = -d_radius_s_d_R_pivot;
    dz[30] = d_radius_s_d_R_roller;
    let d_radius_s_d_l_m = -(t17 * (cos_phi_m * t3));
    dz[31] = d_radius_s_d_l_m;
    dz[32] = d_radius_s_d_delta;
    let d_radius_s_d_xi = -d_radius_s_d_delta;
    dz[33] = d_radius_s_d_xi;
    let d_radius_s_d_xi_d = -(distance * t35);
    dz[34] = d_radius_s_d_xi_d;
    dz[35] = d_moment_d_N;
    dz[36] = d_moment_d_m;
    dz[37] = d_moment_d_omega;
    let d_moment_d_s = -(t28 * d_moment_d_delta);
    dz[38] = d_moment_d_s;
    dz[39] = d_moment_d_s;
    let d_moment_d_R_roller = t32 * d_moment_d_delta;
    let d_moment_d_R_pivot = t29 - d_moment_d_R_roller;
    dz[40] = d_moment_d_R_pivot;
    dz[41] = d_moment_d_R_roller;
    dz[42] = d_moment_d_l_m;
    dz[43] = d_moment_d_delta;
    let d_moment_d_xi = -d_moment_d_delta;
    dz[44] = d_moment_d_xi;
}
