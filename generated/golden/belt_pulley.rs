// belt_pulley: A pulley wrapped by a belt: residuals in its ports, and its power balance.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 49 operations
//   jacobian: 110 operations
// Equations, with their numbers in the source:
// - V_rel (typed in): V_rel
// - F_C (typed in): F_C
// - reached (typed in): μ
// - mu (typed in): μ
// - euler (typed in): F_fr
// - excess (typed in): F_fr
// - size (typed in): F_thr
// - pressing (typed in): F_thr
// - opposite (typed in): belt direction
// - equal (typed in): belt direction
// - adhesion (typed in): ideal belt
// - friction (typed in): F_fr
// - torque (derived): T_S
// - relative_velocity (typed in): V_rel
// - centrifugal_tension (typed in): F_C
// - friction_coefficient (typed in): μ
// - belt_power (typed in): power
// - shaft_power (derived): power
// - friction_loss (typed in): power
// - bearing_loss (typed in): power
// - kinetic_power (typed in): power

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 0),
    (0, 2),
    (1, 0),
    (1, 2),
    (2, 2),
    (2, 4),
    (2, 7),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 4),
    (3, 7),
    (3, 10),
    (3, 11),
    (3, 12),
    (3, 13),
    (3, 14),
    (4, 1),
    (4, 3),
    (4, 4),
    (4, 5),
    (4, 6),
    (4, 7),
    (4, 8),
    (4, 9),
    (5, 2),
    (5, 4),
    (5, 7),
    (6, 2),
    (6, 10),
    (7, 2),
    (7, 4),
    (7, 7),
    (7, 12),
    (7, 13),
    (8, 1),
    (8, 2),
    (8, 3),
    (9, 1),
    (9, 3),
    (9, 4),
    (9, 5),
    (9, 7),
    (9, 8),
    (9, 9),
    (10, 1),
    (10, 2),
    (10, 3),
    (10, 4),
    (10, 7),
    (11, 4),
    (11, 9),
    (12, 4),
    (12, 5),
    (12, 8),
];
///A pulley wrapped by a belt: residuals in its ports, and its power balance.
pub(crate) const KERNEL: FormulaKernel<BeltPulleyInput, BeltPulleyOutput> = FormulaKernel::new(BoundaryKernel {
    name: "belt_pulley",
    equations: BeltPulleyOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: BeltPulleyInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 15, "constants: too few values");
    let g = sized(g, 13, "g");
    let V_A = constants[0];
    let V_B = constants[2];
    let opposite = V_A + V_B;
    g[0] = opposite;
    let equal = V_A - V_B;
    g[1] = equal;
    let omega = constants[4];
    let R = constants[7];
    let V_rel = V_B - omega * R;
    g[2] = V_rel;
    let F_A = constants[1];
    let F_B = constants[3];
    let t1 = F_A - F_B;
    let rho = constants[10];
    let F_C = rho * (V_B * V_B);
    let excess = F_B - F_C;
    let F_thr = constants[14];
    let size = sqrt(excess * excess + F_thr * F_thr);
    let pressing = 0.5 * (excess + size);
    let wrap = constants[11];
    let f = constants[12];
    let V_thr = constants[13];
    let reached = tanh(reciprocal(V_thr) * (V_rel * 4.0));
    let t2 = f * reached;
    let euler = exp(-(wrap * t2));
    let friction = t1 - pressing * (euler - 1.0);
    g[3] = friction;
    let T_S = constants[6];
    let b = constants[9];
    let alpha = constants[5];
    let J = constants[8];
    let torque = T_S - (F_B * R - F_A * R - omega * b - alpha * J);
    g[4] = torque;
    g[5] = V_rel;
    g[6] = F_C;
    let mu = -t2;
    g[7] = mu;
    let belt_power = -(V_B * t1);
    g[8] = belt_power;
    let kinetic_power = J * (omega * alpha);
    let bearing_loss = b * (omega * omega);
    let shaft_power = R * (F_B * omega) - R * (F_A * omega) - kinetic_power
        - bearing_loss;
    g[9] = shaft_power;
    let friction_loss = -(V_rel * t1);
    g[10] = friction_loss;
    g[11] = bearing_loss;
    g[12] = kinetic_power;
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
    let g = sized(g, 13, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let V_A = constants[0];
    let V_B = constants[2];
    let opposite = V_A + V_B;
    g[0] = opposite;
    let equal = V_A - V_B;
    g[1] = equal;
    let omega = constants[4];
    let R = constants[7];
    let d_shaft_power_d_F_B = omega * R;
    let V_rel = V_B - d_shaft_power_d_F_B;
    g[2] = V_rel;
    let F_A = constants[1];
    let F_B = constants[3];
    let d_torque_d_R = F_A - F_B;
    let rho = constants[10];
    let d_centrifugal_tension_d_rho = V_B * V_B;
    let F_C = rho * d_centrifugal_tension_d_rho;
    let excess = F_B - F_C;
    let F_thr = constants[14];
    let size = sqrt(excess * excess + F_thr * F_thr);
    let pressing = 0.5 * (excess + size);
    let wrap = constants[11];
    let f = constants[12];
    let V_thr = constants[13];
    let t1 = reciprocal(V_thr);
    let t2 = V_rel * 4.0;
    let reached = tanh(t1 * t2);
    let t3 = f * reached;
    let euler = exp(-(wrap * t3));
    let t4 = euler - 1.0;
    let friction = d_torque_d_R - pressing * t4;
    g[3] = friction;
    let T_S = constants[6];
    let t5 = F_B * R - F_A * R;
    let b = constants[9];
    let t6 = omega * b;
    let alpha = constants[5];
    let J = constants[8];
    let d_kinetic_power_d_omega = alpha * J;
    let torque = T_S - (t5 - t6 - d_kinetic_power_d_omega);
    g[4] = torque;
    g[5] = V_rel;
    g[6] = F_C;
    let mu = -t3;
    g[7] = mu;
    let belt_power = -(V_B * d_torque_d_R);
    g[8] = belt_power;
    let t7 = F_B * omega;
    let t8 = F_A * omega;
    let d_kinetic_power_d_J = omega * alpha;
    let kinetic_power = J * d_kinetic_power_d_J;
    let d_bearing_loss_d_b = omega * omega;
    let bearing_loss = b * d_bearing_loss_d_b;
    let shaft_power = R * t7 - R * t8 - kinetic_power - bearing_loss;
    g[9] = shaft_power;
    let friction_loss = -(V_rel * d_torque_d_R);
    g[10] = friction_loss;
    g[11] = bearing_loss;
    g[12] = kinetic_power;
    dz[0] = 1.0;
    dz[1] = 1.0;
    dz[2] = 1.0;
    let d_equal_d_V_B = -1.0;
    dz[3] = d_equal_d_V_B;
    dz[4] = 1.0;
    let d_adhesion_d_omega = -R;
    dz[5] = d_adhesion_d_omega;
    let d_adhesion_d_R = -omega;
    dz[6] = d_adhesion_d_R;
    dz[7] = 1.0;
    let d_centrifugal_tension_d_V_B = 2.0 * (V_B * rho);
    let t9 = 0.5 * reciprocal(size);
    let t10 = t4 * (0.5 + 0.5 * (t9 * (excess * 2.0)));
    let t11 = 1.0 - reached * reached;
    let t12 = f * (t11 * (4.0 * t1));
    let t13 = pressing * (wrap * euler);
    let t14 = t12 * t13;
    let d_friction_d_V_B = d_centrifugal_tension_d_V_B * t10 + t14;
    dz[8] = d_friction_d_V_B;
    let d_friction_d_F_B = -(1.0 + t10);
    dz[9] = d_friction_d_F_B;
    let d_friction_d_omega = -(R * t14);
    dz[10] = d_friction_d_omega;
    let d_friction_d_R = -(omega * t14);
    dz[11] = d_friction_d_R;
    let d_friction_d_rho = d_centrifugal_tension_d_rho * t10;
    dz[12] = d_friction_d_rho;
    let d_friction_d_wrap = pressing * (t3 * euler);
    dz[13] = d_friction_d_wrap;
    let d_friction_d_f = reached * t13;
    dz[14] = d_friction_d_f;
    let d_friction_coefficient_d_V_thr = f * (t11 * (t2 * (t1 * t1)));
    let d_friction_d_V_thr = -(d_friction_coefficient_d_V_thr * t13);
    dz[15] = d_friction_d_V_thr;
    let d_friction_d_F_thr = -(t4 * (0.5 * (t9 * (F_thr * 2.0))));
    dz[16] = d_friction_d_F_thr;
    dz[17] = R;
    dz[18] = d_adhesion_d_omega;
    dz[19] = b;
    dz[20] = J;
    dz[21] = 1.0;
    dz[22] = d_torque_d_R;
    dz[23] = alpha;
    dz[24] = omega;
    dz[25] = 1.0;
    dz[26] = d_adhesion_d_omega;
    dz[27] = d_adhesion_d_R;
    dz[28] = d_centrifugal_tension_d_V_B;
    dz[29] = d_centrifugal_tension_d_rho;
    let d_friction_coefficient_d_V_B = -t12;
    dz[30] = d_friction_coefficient_d_V_B;
    let d_friction_coefficient_d_omega = R * t12;
    dz[31] = d_friction_coefficient_d_omega;
    let d_friction_coefficient_d_R = omega * t12;
    dz[32] = d_friction_coefficient_d_R;
    let d_friction_coefficient_d_f = -reached;
    dz[33] = d_friction_coefficient_d_f;
    dz[34] = d_friction_coefficient_d_V_thr;
    let d_belt_power_d_F_A = -V_B;
    dz[35] = d_belt_power_d_F_A;
    let d_belt_power_d_V_B = -d_torque_d_R;
    dz[36] = d_belt_power_d_V_B;
    dz[37] = V_B;
    let d_shaft_power_d_F_A = -d_shaft_power_d_F_B;
    dz[38] = d_shaft_power_d_F_A;
    dz[39] = d_shaft_power_d_F_B;
    let d_bearing_loss_d_omega = t6 * 2.0;
    let d_shaft_power_d_omega = t5 - d_kinetic_power_d_omega - d_bearing_loss_d_omega;
    dz[40] = d_shaft_power_d_omega;
    let d_kinetic_power_d_alpha = omega * J;
    let d_shaft_power_d_alpha = -d_kinetic_power_d_alpha;
    dz[41] = d_shaft_power_d_alpha;
    let d_shaft_power_d_R = t7 - t8;
    dz[42] = d_shaft_power_d_R;
    let d_shaft_power_d_J = -d_kinetic_power_d_J;
    dz[43] = d_shaft_power_d_J;
    let d_shaft_power_d_b = -d_bearing_loss_d_b;
    dz[44] = d_shaft_power_d_b;
    let d_friction_loss_d_F_A = -V_rel;
    dz[45] = d_friction_loss_d_F_A;
    dz[46] = d_belt_power_d_V_B;
    dz[47] = V_rel;
    let d_friction_loss_d_omega = R * d_torque_d_R;
    dz[48] = d_friction_loss_d_omega;
    let d_friction_loss_d_R = omega * d_torque_d_R;
    dz[49] = d_friction_loss_d_R;
    dz[50] = d_bearing_loss_d_omega;
    dz[51] = d_bearing_loss_d_b;
    dz[52] = d_kinetic_power_d_omega;
    dz[53] = d_kinetic_power_d_alpha;
    dz[54] = d_kinetic_power_d_J;
}
