// vehicle_load: Torque that a vehicle takes from the secondary.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 25 operations
//   jacobian: 82 operations
// Equations, with their numbers in the source:
// - tilt (typed in): grade
// - incline (typed in): grade
// - speed (typed in): kinematics
// - resistance (typed in): resistance
// - torque (derived): power
// - torque_a (derived): power

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 1),
    (0, 2),
    (1, 0),
    (1, 1),
    (1, 2),
    (1, 3),
    (1, 4),
    (1, 5),
    (1, 6),
    (1, 7),
    (1, 8),
    (2, 0),
    (2, 1),
    (2, 2),
    (2, 3),
    (2, 4),
    (2, 5),
    (2, 6),
    (2, 7),
    (2, 8),
    (2, 9),
    (2, 10),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 9),
];
///Torque that a vehicle takes from the secondary.
pub(crate) const KERNEL: FormulaKernel<VehicleLoadInput, VehicleLoadOutput> = FormulaKernel::new(BoundaryKernel {
    name: "vehicle_load",
    equations: VehicleLoadOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: VehicleLoadInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 11, "constants: too few values");
    let g = sized(g, 4, "g");
    let i_f = constants[1];
    let t1 = reciprocal(i_f);
    let omega_S = constants[0];
    let r_w = constants[2];
    let speed = t1 * (omega_S * r_w);
    g[0] = speed;
    let rho_air = constants[7];
    let CdA = constants[8];
    let c_r = constants[5];
    let tan_slope = constants[6];
    let tilt = 1.0 + tan_slope * tan_slope;
    let incline = sqrt(tilt);
    let m_v = constants[3];
    let g_0 = constants[4];
    let resistance = speed * speed * (0.5 * (rho_air * CdA))
        + (c_r + tan_slope) * (reciprocal(incline) * (m_v * g_0));
    g[1] = resistance;
    let a = constants[10];
    let eta_f = constants[9];
    let t2 = reciprocal(eta_f);
    let torque = (resistance + m_v * a) * (t2 * (r_w * t1));
    g[2] = torque;
    let torque_a = t2 * (t1 * (r_w * m_v));
    g[3] = torque_a;
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
    let g = sized(g, 4, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let i_f = constants[1];
    let t1 = reciprocal(i_f);
    let omega_S = constants[0];
    let r_w = constants[2];
    let t2 = omega_S * r_w;
    let speed = t1 * t2;
    g[0] = speed;
    let t3 = speed * speed;
    let rho_air = constants[7];
    let CdA = constants[8];
    let t4 = rho_air * CdA;
    let c_r = constants[5];
    let tan_slope = constants[6];
    let t5 = c_r + tan_slope;
    let tilt = 1.0 + tan_slope * tan_slope;
    let incline = sqrt(tilt);
    let t6 = reciprocal(incline);
    let m_v = constants[3];
    let g_0 = constants[4];
    let t7 = m_v * g_0;
    let d_resistance_d_c_r = t6 * t7;
    let resistance = t3 * (0.5 * t4) + t5 * d_resistance_d_c_r;
    g[1] = resistance;
    let a = constants[10];
    let t8 = resistance + m_v * a;
    let eta_f = constants[9];
    let t9 = reciprocal(eta_f);
    let d_speed_d_omega_S = r_w * t1;
    let d_torque_a_d_m_v = t9 * d_speed_d_omega_S;
    let torque = t8 * d_torque_a_d_m_v;
    g[2] = torque;
    let t10 = r_w * m_v;
    let t11 = t1 * t10;
    let torque_a = t9 * t11;
    g[3] = torque_a;
    dz[0] = d_speed_d_omega_S;
    let t12 = t1 * t1;
    let t13 = t2 * t12;
    let d_speed_d_i_f = -t13;
    dz[1] = d_speed_d_i_f;
    let d_speed_d_r_w = omega_S * t1;
    dz[2] = d_speed_d_r_w;
    let t14 = speed * t4;
    let d_resistance_d_omega_S = d_speed_d_omega_S * t14;
    dz[3] = d_resistance_d_omega_S;
    let t15 = t13 * t14;
    let d_resistance_d_i_f = -t15;
    dz[4] = d_resistance_d_i_f;
    let d_resistance_d_r_w = d_speed_d_r_w * t14;
    dz[5] = d_resistance_d_r_w;
    let d_resistance_d_m_v = t5 * (g_0 * t6);
    dz[6] = d_resistance_d_m_v;
    let d_resistance_d_g_0 = t5 * (m_v * t6);
    dz[7] = d_resistance_d_g_0;
    dz[8] = d_resistance_d_c_r;
    let d_resistance_d_tan_slope = d_resistance_d_c_r
        - t6 * t6 * (t5 * t7) * (tan_slope * 2.0 * (0.5 * t6));
    dz[9] = d_resistance_d_tan_slope;
    let d_resistance_d_rho_air = t3 * (CdA * 0.5);
    dz[10] = d_resistance_d_rho_air;
    let d_resistance_d_CdA = t3 * (rho_air * 0.5);
    dz[11] = d_resistance_d_CdA;
    let d_torque_d_omega_S = d_torque_a_d_m_v * d_resistance_d_omega_S;
    dz[12] = d_torque_d_omega_S;
    let d_torque_d_i_f = -(t12 * (t8 * (r_w * t9)) + d_torque_a_d_m_v * t15);
    dz[13] = d_torque_d_i_f;
    let d_torque_d_r_w = t8 * (t1 * t9) + d_torque_a_d_m_v * d_resistance_d_r_w;
    dz[14] = d_torque_d_r_w;
    let d_torque_d_m_v = t9 * (t1 * (r_w * a)) + d_torque_a_d_m_v * d_resistance_d_m_v;
    dz[15] = d_torque_d_m_v;
    let d_torque_d_g_0 = d_torque_a_d_m_v * d_resistance_d_g_0;
    dz[16] = d_torque_d_g_0;
    let d_torque_d_c_r = d_resistance_d_c_r * d_torque_a_d_m_v;
    dz[17] = d_torque_d_c_r;
    let d_torque_d_tan_slope = d_torque_a_d_m_v * d_resistance_d_tan_slope;
    dz[18] = d_torque_d_tan_slope;
    let d_torque_d_rho_air = d_torque_a_d_m_v * d_resistance_d_rho_air;
    dz[19] = d_torque_d_rho_air;
    let d_torque_d_CdA = d_torque_a_d_m_v * d_resistance_d_CdA;
    dz[20] = d_torque_d_CdA;
    let t16 = t9 * t9;
    let d_torque_d_eta_f = -(t16 * (t8 * d_speed_d_omega_S));
    dz[21] = d_torque_d_eta_f;
    dz[22] = torque_a;
    let d_torque_a_d_i_f = -(t12 * (t9 * t10));
    dz[23] = d_torque_a_d_i_f;
    let d_torque_a_d_r_w = t9 * (m_v * t1);
    dz[24] = d_torque_a_d_r_w;
    dz[25] = d_torque_a_d_m_v;
    let d_torque_a_d_eta_f = -(t11 * t16);
    dz[26] = d_torque_a_d_eta_f;
}
