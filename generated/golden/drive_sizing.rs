// drive_sizing: Torques and inertia at the input of a belt drive.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 28 operations
//   jacobian: 69 operations
// Equations, with their numbers in the source:
// - ratio (derived): (3.25)
// - load_inertia (derived): (3.22)
// - rotating_inertia (derived): (3.21), (3.27)
// - total_inertia (typed in): (3.21), (3.27)
// - external_torque (derived): (3.23)
// - friction_torque (derived): (3.24)
// - input_torque (derived): (3.26)
// - steady_torque (typed in): 3.3
// - acceleration_torque (typed in): 3.3
// - drive_torque (typed in): 3.3

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 2),
    (0, 3),
    (1, 0),
    (1, 1),
    (1, 2),
    (2, 2),
    (2, 3),
    (2, 7),
    (2, 8),
    (2, 9),
    (2, 10),
    (3, 0),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 7),
    (3, 8),
    (3, 9),
    (3, 10),
    (4, 2),
    (4, 4),
    (5, 2),
    (5, 5),
    (6, 2),
    (6, 3),
    (6, 6),
    (7, 2),
    (7, 3),
    (7, 4),
    (7, 5),
    (7, 6),
    (8, 0),
    (8, 1),
    (8, 2),
    (8, 3),
    (8, 7),
    (8, 8),
    (8, 9),
    (8, 10),
    (8, 11),
    (9, 0),
    (9, 1),
    (9, 2),
    (9, 3),
    (9, 4),
    (9, 5),
    (9, 6),
    (9, 7),
    (9, 8),
    (9, 9),
    (9, 10),
    (9, 11),
];
///Torques and inertia at the input of a belt drive.
pub(crate) const KERNEL: FormulaKernel<DriveSizingInput, DriveSizingOutput> = FormulaKernel::new(BoundaryKernel {
    name: "drive_sizing",
    equations: DriveSizingOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: DriveSizingInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 14, "constants: too few values");
    let g = sized(g, 10, "g");
    let D_out = constants[3];
    let D_in = constants[2];
    let ratio = D_out * reciprocal(D_in);
    g[0] = ratio;
    let M_belt = constants[0];
    let M_load = constants[1];
    let t1 = D_in * D_in;
    let load_inertia = (M_belt + M_load) * (0.25 * t1);
    g[1] = load_inertia;
    let t2 = reciprocal(D_out);
    let I_idlers = constants[10];
    let t3 = D_out * D_out;
    let I_p1 = constants[7];
    let I_RL = constants[9];
    let I_p2 = constants[8];
    let rotating_inertia = t2 * t2
        * (I_idlers * t3 + (I_p1 * t3 + (I_RL * t1 + I_p2 * t1)));
    g[2] = rotating_inertia;
    let total_inertia = load_inertia + rotating_inertia;
    g[3] = total_inertia;
    let F = constants[4];
    let external_torque = 0.5 * (D_in * F);
    g[4] = external_torque;
    let F_f = constants[5];
    let friction_torque = 0.5 * (D_in * F_f);
    g[5] = friction_torque;
    let T_out = constants[6];
    let input_torque = t2 * (D_in * T_out);
    g[6] = input_torque;
    let steady_torque = input_torque + (external_torque + friction_torque);
    g[7] = steady_torque;
    let alpha = constants[11];
    let acceleration_torque = alpha * total_inertia;
    g[8] = acceleration_torque;
    let drive_torque = steady_torque + acceleration_torque;
    g[9] = drive_torque;
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
    assert!(constants.len() >= 14, "constants: too few values");
    let g = sized(g, 10, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let D_out = constants[3];
    let D_in = constants[2];
    let d_ratio_d_D_out = reciprocal(D_in);
    let ratio = D_out * d_ratio_d_D_out;
    g[0] = ratio;
    let M_belt = constants[0];
    let M_load = constants[1];
    let t1 = M_belt + M_load;
    let t2 = D_in * D_in;
    let d_load_inertia_d_M_belt = 0.25 * t2;
    let load_inertia = t1 * d_load_inertia_d_M_belt;
    g[1] = load_inertia;
    let t3 = reciprocal(D_out);
    let t4 = t3 * t3;
    let I_idlers = constants[10];
    let t5 = D_out * D_out;
    let I_p1 = constants[7];
    let I_RL = constants[9];
    let I_p2 = constants[8];
    let t6 = I_idlers * t5 + (I_p1 * t5 + (I_RL * t2 + I_p2 * t2));
    let rotating_inertia = t4 * t6;
    g[2] = rotating_inertia;
    let total_inertia = load_inertia + rotating_inertia;
    g[3] = total_inertia;
    let F = constants[4];
    let external_torque = 0.5 * (D_in * F);
    g[4] = external_torque;
    let F_f = constants[5];
    let friction_torque = 0.5 * (D_in * F_f);
    g[5] = friction_torque;
    let T_out = constants[6];
    let t7 = D_in * T_out;
    let input_torque = t3 * t7;
    g[6] = input_torque;
    let steady_torque = input_torque + (external_torque + friction_torque);
    g[7] = steady_torque;
    let alpha = constants[11];
    let acceleration_torque = alpha * total_inertia;
    g[8] = acceleration_torque;
    let drive_torque = steady_torque + acceleration_torque;
    g[9] = drive_torque;
    let d_ratio_d_D_in = -(D_out * (d_ratio_d_D_out * d_ratio_d_D_out));
    dz[0] = d_ratio_d_D_in;
    dz[1] = d_ratio_d_D_out;
    dz[2] = d_load_inertia_d_M_belt;
    dz[3] = d_load_inertia_d_M_belt;
    let d_load_inertia_d_D_in = 0.5 * (D_in * t1);
    dz[4] = d_load_inertia_d_D_in;
    let d_rotating_inertia_d_D_in = t4 * (2.0 * (D_in * I_RL) + 2.0 * (D_in * I_p2));
    dz[5] = d_rotating_inertia_d_D_in;
    let d_rotating_inertia_d_D_out = t4
        * (2.0 * (D_out * I_p1) + 2.0 * (D_out * I_idlers)) - t3 * t4 * (t6 * 2.0);
    dz[6] = d_rotating_inertia_d_D_out;
    dz[7] = 1.0;
    let d_rotating_inertia_d_I_p2 = t2 * t4;
    dz[8] = d_rotating_inertia_d_I_p2;
    dz[9] = d_rotating_inertia_d_I_p2;
    dz[10] = 1.0;
    dz[11] = d_load_inertia_d_M_belt;
    dz[12] = d_load_inertia_d_M_belt;
    let d_total_inertia_d_D_in = d_load_inertia_d_D_in + d_rotating_inertia_d_D_in;
    dz[13] = d_total_inertia_d_D_in;
    dz[14] = d_rotating_inertia_d_D_out;
    dz[15] = 1.0;
    dz[16] = d_rotating_inertia_d_I_p2;
    dz[17] = d_rotating_inertia_d_I_p2;
    dz[18] = 1.0;
    let d_external_torque_d_D_in = F * 0.5;
    dz[19] = d_external_torque_d_D_in;
    let d_external_torque_d_F = D_in * 0.5;
    dz[20] = d_external_torque_d_F;
    let d_friction_torque_d_D_in = F_f * 0.5;
    dz[21] = d_friction_torque_d_D_in;
    dz[22] = d_external_torque_d_F;
    let d_input_torque_d_D_in = T_out * t3;
    dz[23] = d_input_torque_d_D_in;
    let t8 = t4 * t7;
    let d_input_torque_d_D_out = -t8;
    dz[24] = d_input_torque_d_D_out;
    let d_input_torque_d_T_out = D_in * t3;
    dz[25] = d_input_torque_d_T_out;
    let d_steady_torque_d_D_in = d_input_torque_d_D_in
        + (d_external_torque_d_D_in + d_friction_torque_d_D_in);
    dz[26] = d_steady_torque_d_D_in;
    dz[27] = d_input_torque_d_D_out;
    dz[28] = d_external_torque_d_F;
    dz[29] = d_external_torque_d_F;
    dz[30] = d_input_torque_d_T_out;
    let d_acceleration_torque_d_M_belt = alpha * d_load_inertia_d_M_belt;
    dz[31] = d_acceleration_torque_d_M_belt;
    dz[32] = d_acceleration_torque_d_M_belt;
    let t9 = alpha * d_load_inertia_d_D_in;
    let t10 = alpha * d_rotating_inertia_d_D_in;
    let d_acceleration_torque_d_D_in = t9 + t10;
    dz[33] = d_acceleration_torque_d_D_in;
    let d_acceleration_torque_d_D_out = alpha * d_rotating_inertia_d_D_out;
    dz[34] = d_acceleration_torque_d_D_out;
    dz[35] = alpha;
    let d_acceleration_torque_d_I_p2 = alpha * d_rotating_inertia_d_I_p2;
    dz[36] = d_acceleration_torque_d_I_p2;
    dz[37] = d_acceleration_torque_d_I_p2;
    dz[38] = alpha;
    dz[39] = total_inertia;
    dz[40] = d_acceleration_torque_d_M_belt;
    dz[41] = d_acceleration_torque_d_M_belt;
    let d_drive_torque_d_D_in = d_steady_torque_d_D_in + t9 + t10;
    dz[42] = d_drive_torque_d_D_in;
    let d_drive_torque_d_D_out = d_acceleration_torque_d_D_out - t8;
    dz[43] = d_drive_torque_d_D_out;
    dz[44] = d_external_torque_d_F;
    dz[45] = d_external_torque_d_F;
    dz[46] = d_input_torque_d_T_out;
    dz[47] = alpha;
    dz[48] = d_acceleration_torque_d_I_p2;
    dz[49] = d_acceleration_torque_d_I_p2;
    dz[50] = alpha;
    dz[51] = total_inertia;
}
