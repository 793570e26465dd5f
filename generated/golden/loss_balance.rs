// loss_balance: What arrives once hysteresis, drag and gears have had their share.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 19 operations
//   jacobian: 78 operations
// Equations, with their numbers in the source:
// - driven (typed in): (6.9)
// - primary_drag (typed in): drag
// - secondary_drag (typed in): drag
// - gears (typed in): gears
// - total (typed in): balance of power
// - delivered (typed in): balance of power
// - efficiency (typed in): (6.9) with losses

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 3),
    (0, 5),
    (0, 7),
    (1, 4),
    (1, 6),
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
    (3, 0),
    (3, 1),
    (3, 2),
    (3, 3),
    (3, 4),
    (3, 5),
    (3, 6),
    (3, 7),
    (3, 8),
    (3, 9),
    (4, 0),
    (4, 1),
    (4, 2),
    (4, 3),
    (4, 4),
    (4, 5),
    (4, 6),
    (4, 7),
    (4, 8),
    (4, 9),
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
///What arrives once hysteresis, drag and gears have had their share.
pub(crate) const KERNEL: FormulaKernel<LossBalanceInput, LossBalanceOutput> = FormulaKernel::new(BoundaryKernel {
    name: "loss_balance",
    equations: LossBalanceOutput::SYMBOLS,
    ends: &[],
    integrals: &[],
    constants: LossBalanceInput::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
});
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 0, "ends: too few values");
    assert!(integrals.len() >= 0, "integrals: too few values");
    assert!(constants.len() >= 10, "constants: too few values");
    let g = sized(g, 6, "g");
    let omega_P = constants[3];
    let drag_P = constants[5];
    let viscous_P = constants[7];
    let primary_drag = omega_P * (drag_P + omega_P * viscous_P);
    g[0] = primary_drag;
    let omega_S = constants[4];
    let drag_S = constants[6];
    let viscous_S = constants[8];
    let secondary_drag = omega_S * (drag_S + omega_S * viscous_S);
    g[1] = secondary_drag;
    let gear_efficiency = constants[9];
    let driving = constants[0];
    let overall = constants[1];
    let driven = driving * overall;
    let hysteresis = constants[2];
    let gears = (1.0 - gear_efficiency)
        * (driven - hysteresis - primary_drag - secondary_drag);
    g[2] = gears;
    let total = gears + (secondary_drag + (hysteresis + primary_drag));
    g[3] = total;
    let delivered = driven - total;
    g[4] = delivered;
    let efficiency = overall - total * reciprocal(driving);
    g[5] = efficiency;
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
    let g = sized(g, 6, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let omega_P = constants[3];
    let drag_P = constants[5];
    let viscous_P = constants[7];
    let t1 = omega_P * viscous_P;
    let primary_drag = omega_P * (drag_P + t1);
    g[0] = primary_drag;
    let omega_S = constants[4];
    let drag_S = constants[6];
    let viscous_S = constants[8];
    let t2 = omega_S * viscous_S;
    let secondary_drag = omega_S * (drag_S + t2);
    g[1] = secondary_drag;
    let gear_efficiency = constants[9];
    let t3 = 1.0 - gear_efficiency;
    let driving = constants[0];
    let overall = constants[1];
    let driven = driving * overall;
    let hysteresis = constants[2];
    let d_delivered_d_gear_efficiency = driven - hysteresis - primary_drag
        - secondary_drag;
    let gears = t3 * d_delivered_d_gear_efficiency;
    g[2] = gears;
    let total = gears + (secondary_drag + (hysteresis + primary_drag));
    g[3] = total;
    let delivered = driven - total;
    g[4] = delivered;
    let t4 = reciprocal(driving);
    let efficiency = overall - total * t4;
    g[5] = efficiency;
    let d_primary_drag_d_omega_P = drag_P + t1 * 2.0;
    dz[0] = d_primary_drag_d_omega_P;
    dz[1] = omega_P;
    let d_primary_drag_d_viscous_P = omega_P * omega_P;
    dz[2] = d_primary_drag_d_viscous_P;
    let d_secondary_drag_d_omega_S = drag_S + t2 * 2.0;
    dz[3] = d_secondary_drag_d_omega_S;
    dz[4] = omega_S;
    let d_secondary_drag_d_viscous_S = omega_S * omega_S;
    dz[5] = d_secondary_drag_d_viscous_S;
    let d_gears_d_driving = overall * t3;
    dz[6] = d_gears_d_driving;
    let d_gears_d_overall = driving * t3;
    dz[7] = d_gears_d_overall;
    let d_gears_d_hysteresis = -t3;
    dz[8] = d_gears_d_hysteresis;
    let t5 = t3 * d_primary_drag_d_omega_P;
    let d_gears_d_omega_P = -t5;
    dz[9] = d_gears_d_omega_P;
    let t6 = t3 * d_secondary_drag_d_omega_S;
    let d_gears_d_omega_S = -t6;
    dz[10] = d_gears_d_omega_S;
    let t7 = omega_P * t3;
    let d_gears_d_drag_P = -t7;
    dz[11] = d_gears_d_drag_P;
    let t8 = omega_S * t3;
    let d_gears_d_drag_S = -t8;
    dz[12] = d_gears_d_drag_S;
    let t9 = t3 * d_primary_drag_d_viscous_P;
    let d_gears_d_viscous_P = -t9;
    dz[13] = d_gears_d_viscous_P;
    let t10 = t3 * d_secondary_drag_d_viscous_S;
    let d_gears_d_viscous_S = -t10;
    dz[14] = d_gears_d_viscous_S;
    let d_gears_d_gear_efficiency = -d_delivered_d_gear_efficiency;
    dz[15] = d_gears_d_gear_efficiency;
    dz[16] = d_gears_d_driving;
    dz[17] = d_gears_d_overall;
    let d_total_d_hysteresis = 1.0 - t3;
    dz[18] = d_total_d_hysteresis;
    let d_total_d_omega_P = d_primary_drag_d_omega_P - t5;
    dz[19] = d_total_d_omega_P;
    let d_total_d_omega_S = d_secondary_drag_d_omega_S - t6;
    dz[20] = d_total_d_omega_S;
    let d_total_d_drag_P = omega_P - t7;
    dz[21] = d_total_d_drag_P;
    let d_total_d_drag_S = omega_S - t8;
    dz[22] = d_total_d_drag_S;
    let d_total_d_viscous_P = d_primary_drag_d_viscous_P - t9;
    dz[23] = d_total_d_viscous_P;
    let d_total_d_viscous_S = d_secondary_drag_d_viscous_S - t10;
    dz[24] = d_total_d_viscous_S;
    dz[25] = d_gears_d_gear_efficiency;
    let d_delivered_d_driving = overall - d_gears_d_driving;
    dz[26] = d_delivered_d_driving;
    let d_delivered_d_overall = driving - d_gears_d_overall;
    dz[27] = d_delivered_d_overall;
    let d_delivered_d_hysteresis = -d_total_d_hysteresis;
    dz[28] = d_delivered_d_hysteresis;
    let d_delivered_d_omega_P = -d_total_d_omega_P;
    dz[29] = d_delivered_d_omega_P;
    let d_delivered_d_omega_S = -d_total_d_omega_S;
    dz[30] = d_delivered_d_omega_S;
    let d_delivered_d_drag_P = -d_total_d_drag_P;
    dz[31] = d_delivered_d_drag_P;
    let d_delivered_d_drag_S = -d_total_d_drag_S;
    dz[32] = d_delivered_d_drag_S;
    let d_delivered_d_viscous_P = -d_total_d_viscous_P;
    dz[33] = d_delivered_d_viscous_P;
    let d_delivered_d_viscous_S = -d_total_d_viscous_S;
    dz[34] = d_delivered_d_viscous_S;
    dz[35] = d_delivered_d_gear_efficiency;
    let d_efficiency_d_driving = total * (t4 * t4) - t4 * d_gears_d_driving;
    dz[36] = d_efficiency_d_driving;
    let d_efficiency_d_overall = 1.0 - t4 * d_gears_d_overall;
    dz[37] = d_efficiency_d_overall;
    let d_efficiency_d_hysteresis = -(t4 * d_total_d_hysteresis);
    dz[38] = d_efficiency_d_hysteresis;
    let d_efficiency_d_omega_P = -(t4 * d_total_d_omega_P);
    dz[39] = d_efficiency_d_omega_P;
    let d_efficiency_d_omega_S = -(t4 * d_total_d_omega_S);
    dz[40] = d_efficiency_d_omega_S;
    let d_efficiency_d_drag_P = -(t4 * d_total_d_drag_P);
    dz[41] = d_efficiency_d_drag_P;
    let d_efficiency_d_drag_S = -(t4 * d_total_d_drag_S);
    dz[42] = d_efficiency_d_drag_S;
    let d_efficiency_d_viscous_P = -(t4 * d_total_d_viscous_P);
    dz[43] = d_efficiency_d_viscous_P;
    let d_efficiency_d_viscous_S = -(t4 * d_total_d_viscous_S);
    dz[44] = d_efficiency_d_viscous_S;
    let d_efficiency_d_gear_efficiency = d_delivered_d_gear_efficiency * t4;
    dz[45] = d_efficiency_d_gear_efficiency;
}
