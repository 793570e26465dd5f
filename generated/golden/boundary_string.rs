// boundary_string: Boundary equations of a belt without bending stiffness.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 57 operations
//   jacobian: 111 operations
// Equations, with their numbers in the source:
// - s_2 (typed in): a region ends where its variable is 1
// - penetration_P1 (typed in): (5.51)
// - penetration_P2 (typed in): (5.51)
// - penetration_S1 (typed in): (5.51)
// - penetration_S2 (typed in): (5.51)
// - tension_P1 (typed in): (5.47)
// - tension_P2 (typed in): (5.48)
// - tension_S1 (typed in): (5.49)
// - tension_S2 (typed in): (5.50)
// - direction_P1 (typed in): (5.21), (5.35)
// - direction_P2 (typed in): (5.22), (5.36)
// - direction_S1 (typed in): (5.23), (5.37)
// - direction_S2 (typed in): (5.24), (5.38)
// - closure_X_s (typed in): (5.29) to (5.32)
// - closure_Y_s (typed in): (5.29) to (5.32)
// - closure_X_t (typed in): (5.27), (5.28), (5.33), (5.34)
// - closure_Y_t (typed in): (5.27), (5.28), (5.33), (5.34)
// - torque (typed in): 5.3.5
// - slack_tension (typed in): 5.3.5

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 2),
    (0, 54),
    (1, 5),
    (1, 54),
    (2, 12),
    (2, 55),
    (3, 15),
    (3, 55),
    (4, 0),
    (4, 18),
    (5, 3),
    (5, 6),
    (6, 8),
    (6, 10),
    (7, 13),
    (7, 16),
    (8, 1),
    (8, 19),
    (8, 46),
    (9, 4),
    (9, 7),
    (9, 44),
    (9, 46),
    (10, 9),
    (10, 11),
    (10, 45),
    (10, 47),
    (11, 14),
    (11, 17),
    (11, 47),
    (12, 27),
    (12, 44),
    (12, 45),
    (12, 46),
    (12, 47),
    (12, 49),
    (12, 54),
    (12, 55),
    (12, 56),
    (13, 28),
    (13, 44),
    (13, 45),
    (13, 46),
    (13, 47),
    (13, 49),
    (13, 54),
    (13, 55),
    (14, 38),
    (14, 46),
    (14, 47),
    (14, 48),
    (14, 54),
    (14, 55),
    (14, 56),
    (15, 39),
    (15, 46),
    (15, 47),
    (15, 48),
    (15, 54),
    (15, 55),
    (16, 20),
    (16, 61),
    (17, 3),
    (17, 62),
];
///Boundary equations of a belt without bending stiffness.
pub(crate) const KERNEL: BoundaryKernel = BoundaryKernel {
    name: "boundary_string",
    equations: &[
        Symbol {
            name: "penetration_P1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "x_P1 = 0, over R",
            source: "(5.51)",
        },
        Symbol {
            name: "penetration_P2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "x_P2 = 0, over R",
            source: "(5.51)",
        },
        Symbol {
            name: "penetration_S1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "x_S1 = 0, over R",
            source: "(5.51)",
        },
        Symbol {
            name: "penetration_S2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "x_S2 = 0, over R",
            source: "(5.51)",
        },
        Symbol {
            name: "tension_P1",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "T_P1 = τ_t2",
            source: "(5.47)",
        },
        Symbol {
            name: "tension_P2",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "T_P2 = τ_s1",
            source: "(5.48)",
        },
        Symbol {
            name: "tension_S1",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "T_S1 = τ_s2",
            source: "(5.49)",
        },
        Symbol {
            name: "tension_S2",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "T_S2 = τ_t1",
            source: "(5.50)",
        },
        Symbol {
            name: "direction_P1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's direction at P1 is ϑ_t2",
            source: "(5.21), (5.35)",
        },
        Symbol {
            name: "direction_P2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's direction at P2 is ϑ_s1",
            source: "(5.22), (5.36)",
        },
        Symbol {
            name: "direction_S1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's direction at S1 is ϑ_s2",
            source: "(5.23), (5.37)",
        },
        Symbol {
            name: "direction_S2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's direction at S2 is ϑ_t1",
            source: "(5.24), (5.38)",
        },
        Symbol {
            name: "closure_X_s",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the X span s covers leads from P2 to S1, over R",
            source: "(5.29) to (5.32)",
        },
        Symbol {
            name: "closure_Y_s",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the Y span s covers leads from P2 to S1, over R",
            source: "(5.29) to (5.32)",
        },
        Symbol {
            name: "closure_X_t",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the X span t covers leads from S2 to P1, over R",
            source: "(5.27), (5.28), (5.33), (5.34)",
        },
        Symbol {
            name: "closure_Y_t",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the Y span t covers leads from S2 to P1, over R",
            source: "(5.27), (5.28), (5.33), (5.34)",
        },
        Symbol {
            name: "torque",
            symbol: "",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "M_P = −M_in: friction on the belt drives it backwards",
            source: "5.3.5",
        },
        Symbol {
            name: "slack_tension",
            symbol: "",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "T_P2 = T_slack",
            source: "5.3.5",
        },
    ],
    ends: &[
        Symbol {
            name: "T_P1",
            symbol: "T_P1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension F − G V: entry of the primary",
            source: "(3.6)",
        },
        Symbol {
            name: "theta_P1",
            symbol: "θ_P1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt against the pulley's circle; positive unseats: entry of the primary",
            source: "(3.2)",
        },
        Symbol {
            name: "x_P1",
            symbol: "x_P1",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration R − r: entry of the primary",
            source: "(3.24)",
        },
        Symbol {
            name: "T_P2",
            symbol: "T_P2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension F − G V: exit of the primary",
            source: "(3.6)",
        },
        Symbol {
            name: "theta_P2",
            symbol: "θ_P2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt against the pulley's circle; positive unseats: exit of the primary",
            source: "(3.2)",
        },
        Symbol {
            name: "x_P2",
            symbol: "x_P2",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration R − r: exit of the primary",
            source: "(3.24)",
        },
        Symbol {
            name: "tau_s1",
            symbol: "τ_s1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension in a span: entry of the slack span",
            source: "(3.45)",
        },
        Symbol {
            name: "vartheta_s1",
            symbol: "ϑ_s1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the belt in a span against the line of centres: entry of the slack span",
            source: "(3.43)",
        },
        Symbol {
            name: "tau_s2",
            symbol: "τ_s2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension in a span: exit of the slack span",
            source: "(3.45)",
        },
        Symbol {
            name: "vartheta_s2",
            symbol: "ϑ_s2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the belt in a span against the line of centres: exit of the slack span",
            source: "(3.43)",
        },
        Symbol {
            name: "T_S1",
            symbol: "T_S1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension F − G V: entry of the secondary",
            source: "(3.6)",
        },
        Symbol {
            name: "theta_S1",
            symbol: "θ_S1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt against the pulley's circle; positive unseats: entry of the secondary",
            source: "(3.2)",
        },
        Symbol {
            name: "x_S1",
            symbol: "x_S1",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration R − r: entry of the secondary",
            source: "(3.24)",
        },
        Symbol {
            name: "T_S2",
            symbol: "T_S2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension F − G V: exit of the secondary",
            source: "(3.6)",
        },
        Symbol {
            name: "theta_S2",
            symbol: "θ_S2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "inclination of the belt against the pulley's circle; positive unseats: exit of the secondary",
            source: "(3.2)",
        },
        Symbol {
            name: "x_S2",
            symbol: "x_S2",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "radial penetration R − r: exit of the secondary",
            source: "(3.24)",
        },
        Symbol {
            name: "tau_t1",
            symbol: "τ_t1",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension in a span: entry of the tight span",
            source: "(3.45)",
        },
        Symbol {
            name: "vartheta_t1",
            symbol: "ϑ_t1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the belt in a span against the line of centres: entry of the tight span",
            source: "(3.43)",
        },
        Symbol {
            name: "tau_t2",
            symbol: "τ_t2",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "tractive tension in a span: exit of the tight span",
            source: "(3.45)",
        },
        Symbol {
            name: "vartheta_t2",
            symbol: "ϑ_t2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "direction of the belt in a span against the line of centres: exit of the tight span",
            source: "(3.43)",
        },
    ],
    integrals: &[
        Symbol {
            name: "M_P",
            symbol: "M_P",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of friction on the belt: the whole primary",
            source: "(5.54)",
        },
        Symbol {
            name: "A_P",
            symbol: "A_P",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on one sheave: the whole primary",
            source: "(5.58)",
        },
        Symbol {
            name: "L_o_P",
            symbol: "L_o_P",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the belt in the region: the whole primary",
            source: "(5.55)",
        },
        Symbol {
            name: "W_P",
            symbol: "W_P",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction: the whole primary",
            source: "power of friction",
        },
        Symbol {
            name: "A_x_P",
            symbol: "A_x_P",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force along the direction of the entry: the whole primary",
            source: "(6.1)",
        },
        Symbol {
            name: "A_y_P",
            symbol: "A_y_P",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force across the direction of the entry: the whole primary",
            source: "(6.2)",
        },
        Symbol {
            name: "E_P",
            symbol: "E_P",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that changes of speed take from the energy stored in bending and squeezing: the whole primary",
            source: "energy balance",
        },
        Symbol {
            name: "X_s",
            symbol: "X\u{302}_s",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress along the line of centres over L: the whole slack span",
            source: "(5.25)",
        },
        Symbol {
            name: "Y_s",
            symbol: "Ŷ_s",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress across the line of centres over L: the whole slack span",
            source: "(5.26)",
        },
        Symbol {
            name: "L_o_s",
            symbol: "L_o_s",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the belt in the region: the whole slack span",
            source: "(5.55)",
        },
        Symbol {
            name: "E_s",
            symbol: "E_s",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that changes of speed take from the energy stored in bending and squeezing: the whole slack span",
            source: "energy balance",
        },
        Symbol {
            name: "M_S",
            symbol: "M_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "torque of friction on the belt: the whole secondary",
            source: "(5.54)",
        },
        Symbol {
            name: "A_S",
            symbol: "A_S",
            unit: "N",
            dimension: Dimension {
                length: 1,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "axial force on one sheave: the whole secondary",
            source: "(5.58)",
        },
        Symbol {
            name: "L_o_S",
            symbol: "L_o_S",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the belt in the region: the whole secondary",
            source: "(5.55)",
        },
        Symbol {
            name: "W_S",
            symbol: "W_S",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power lost to friction: the whole secondary",
            source: "power of friction",
        },
        Symbol {
            name: "A_x_S",
            symbol: "A_x_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force along the direction of the entry: the whole secondary",
            source: "(6.1)",
        },
        Symbol {
            name: "A_y_S",
            symbol: "A_y_S",
            unit: "N·m",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -2,
                angle: 0,
            },
            doc: "first moment of the axial force across the direction of the entry: the whole secondary",
            source: "(6.2)",
        },
        Symbol {
            name: "E_S",
            symbol: "E_S",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that changes of speed take from the energy stored in bending and squeezing: the whole secondary",
            source: "energy balance",
        },
        Symbol {
            name: "X_t",
            symbol: "X\u{302}_t",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress along the line of centres over L: the whole tight span",
            source: "(5.25)",
        },
        Symbol {
            name: "Y_t",
            symbol: "Ŷ_t",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "progress across the line of centres over L: the whole tight span",
            source: "(5.26)",
        },
        Symbol {
            name: "L_o_t",
            symbol: "L_o_t",
            unit: "m",
            dimension: Dimension {
                length: 1,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "unstretched length of the belt in the region: the whole tight span",
            source: "(5.55)",
        },
        Symbol {
            name: "E_t",
            symbol: "E_t",
            unit: "W",
            dimension: Dimension {
                length: 2,
                mass: 1,
                time: -3,
                angle: 0,
            },
            doc: "power that changes of speed take from the energy stored in bending and squeezing: the whole tight span",
            source: "energy balance",
        },
    ],
    constants: Constant::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
};
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 20, "ends: too few values");
    assert!(integrals.len() >= 22, "integrals: too few values");
    assert!(constants.len() >= 21, "constants: too few values");
    let g = sized(g, 18, "g");
    let x_P1 = ends[2];
    let R_P = constants[12];
    let t1 = reciprocal(R_P);
    let penetration_P1 = x_P1 * t1;
    g[0] = penetration_P1;
    let x_P2 = ends[5];
    let penetration_P2 = x_P2 * t1;
    g[1] = penetration_P2;
    let x_S1 = ends[12];
    let R_S = constants[13];
    let t2 = reciprocal(R_S);
    let penetration_S1 = x_S1 * t2;
    g[2] = penetration_S1;
    let x_S2 = ends[15];
    let penetration_S2 = x_S2 * t2;
    g[3] = penetration_S2;
    let T_P1 = ends[0];
    let tau_t2 = ends[18];
    let tension_P1 = T_P1 - tau_t2;
    g[4] = tension_P1;
    let T_P2 = ends[3];
    let tau_s1 = ends[6];
    let tension_P2 = T_P2 - tau_s1;
    g[5] = tension_P2;
    let T_S1 = ends[10];
    let tau_s2 = ends[8];
    let tension_S1 = T_S1 - tau_s2;
    g[6] = tension_S1;
    let T_S2 = ends[13];
    let tau_t1 = ends[16];
    let tension_S2 = T_S2 - tau_t1;
    g[7] = tension_S2;
    let C_P = constants[4];
    let theta_P1 = ends[1];
    let vartheta_t2 = ends[19];
    let direction_P1 = C_P + 1.5707963267948966 - theta_P1 - vartheta_t2;
    g[8] = direction_P1;
    let Phi_P = constants[2];
    let t3 = Phi_P + C_P;
    let theta_P2 = ends[4];
    let vartheta_s1 = ends[7];
    let direction_P2 = t3 - theta_P2 - vartheta_s1 - 4.71238898038469;
    g[9] = direction_P2;
    let Phi_S = constants[3];
    let C_S = constants[5];
    let theta_S1 = ends[11];
    let vartheta_s2 = ends[9];
    let direction_S1 = 4.71238898038469 - Phi_S - C_S - theta_S1 - vartheta_s2;
    g[10] = direction_S1;
    let theta_S2 = ends[14];
    let vartheta_t1 = ends[17];
    let direction_S2 = 4.71238898038469 - C_S - theta_S2 - vartheta_t1;
    g[11] = direction_S2;
    let L_c = constants[14];
    let (sin_t3, cos_t3) = sin_cos(t3);
    let X_s = integrals[7];
    let L_s = constants[7];
    let t5 = Phi_S + C_S;
    let (sin_t5, cos_t5) = sin_cos(t5);
    let closure_X_s = t1 * (L_c - R_P * cos_t3 - X_s * L_s - R_S * cos_t5);
    g[12] = closure_X_s;
    let Y_s = integrals[8];
    let closure_Y_s = t1 * (R_S * sin_t5 - R_P * sin_t3 - Y_s * L_s);
    g[13] = closure_Y_s;
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let X_t = integrals[18];
    let L_t = constants[6];
    let (sin_C_S, cos_C_S) = sin_cos(C_S);
    let closure_X_t = t2 * (R_P * cos_C_P - X_t * L_t - (L_c - R_S * cos_C_S));
    g[14] = closure_X_t;
    let Y_t = integrals[19];
    let closure_Y_t = t2 * (R_P * sin_C_P - Y_t * L_t - R_S * sin_C_S);
    g[15] = closure_Y_t;
    let M_P = integrals[0];
    let M_in = constants[19];
    let torque = M_P + M_in;
    g[16] = torque;
    let T_slack = constants[20];
    let slack_tension = T_P2 - T_slack;
    g[17] = slack_tension;
}
///Residuals and their derivatives.
fn derivatives(
    ends: &[f64],
    integrals: &[f64],
    constants: &[f64],
    g: &mut [f64],
    dz: &mut [f64],
) {
    assert!(ends.len() >= 20, "ends: too few values");
    assert!(integrals.len() >= 22, "integrals: too few values");
    assert!(constants.len() >= 21, "constants: too few values");
    let g = sized(g, 18, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let x_P1 = ends[2];
    let R_P = constants[12];
    let d_penetration_P1_d_x_P1 = reciprocal(R_P);
    let penetration_P1 = x_P1 * d_penetration_P1_d_x_P1;
    g[0] = penetration_P1;
    let x_P2 = ends[5];
    let penetration_P2 = x_P2 * d_penetration_P1_d_x_P1;
    g[1] = penetration_P2;
    let x_S1 = ends[12];
    let R_S = constants[13];
    let d_penetration_S1_d_x_S1 = reciprocal(R_S);
    let penetration_S1 = x_S1 * d_penetration_S1_d_x_S1;
    g[2] = penetration_S1;
    let x_S2 = ends[15];
    let penetration_S2 = x_S2 * d_penetration_S1_d_x_S1;
    g[3] = penetration_S2;
    let T_P1 = ends[0];
    let tau_t2 = ends[18];
    let tension_P1 = T_P1 - tau_t2;
    g[4] = tension_P1;
    let T_P2 = ends[3];
    let tau_s1 = ends[6];
    let tension_P2 = T_P2 - tau_s1;
    g[5] = tension_P2;
    let T_S1 = ends[10];
    let tau_s2 = ends[8];
    let tension_S1 = T_S1 - tau_s2;
    g[6] = tension_S1;
    let T_S2 = ends[13];
    let tau_t1 = ends[16];
    let tension_S2 = T_S2 - tau_t1;
    g[7] = tension_S2;
    let C_P = constants[4];
    let theta_P1 = ends[1];
    let vartheta_t2 = ends[19];
    let direction_P1 = C_P + 1.5707963267948966 - theta_P1 - vartheta_t2;
    g[8] = direction_P1;
    let Phi_P = constants[2];
    let t1 = Phi_P + C_P;
    let theta_P2 = ends[4];
    let vartheta_s1 = ends[7];
    let direction_P2 = t1 - theta_P2 - vartheta_s1 - 4.71238898038469;
    g[9] = direction_P2;
    let Phi_S = constants[3];
    let C_S = constants[5];
    let theta_S1 = ends[11];
    let vartheta_s2 = ends[9];
    let direction_S1 = 4.71238898038469 - Phi_S - C_S - theta_S1 - vartheta_s2;
    g[10] = direction_S1;
    let theta_S2 = ends[14];
    let vartheta_t1 = ends[17];
    let direction_S2 = 4.71238898038469 - C_S - theta_S2 - vartheta_t1;
    g[11] = direction_S2;
    let L_c = constants[14];
    let (sin_t1, cos_t1) = sin_cos(t1);
    let X_s = integrals[7];
    let L_s = constants[7];
    let t3 = Phi_S + C_S;
    let (sin_t3, cos_t3) = sin_cos(t3);
    let t5 = L_c - R_P * cos_t1 - X_s * L_s - R_S * cos_t3;
    let closure_X_s = d_penetration_P1_d_x_P1 * t5;
    g[12] = closure_X_s;
    let Y_s = integrals[8];
    let t6 = R_S * sin_t3 - R_P * sin_t1 - Y_s * L_s;
    let closure_Y_s = d_penetration_P1_d_x_P1 * t6;
    g[13] = closure_Y_s;
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let X_t = integrals[18];
    let L_t = constants[6];
    let (sin_C_S, cos_C_S) = sin_cos(C_S);
    let t9 = R_P * cos_C_P - X_t * L_t - (L_c - R_S * cos_C_S);
    let closure_X_t = d_penetration_S1_d_x_S1 * t9;
    g[14] = closure_X_t;
    let Y_t = integrals[19];
    let t10 = R_P * sin_C_P - Y_t * L_t - R_S * sin_C_S;
    let closure_Y_t = d_penetration_S1_d_x_S1 * t10;
    g[15] = closure_Y_t;
    let M_P = integrals[0];
    let M_in = constants[19];
    let torque = M_P + M_in;
    g[16] = torque;
    let T_slack = constants[20];
    let slack_tension = T_P2 - T_slack;
    g[17] = slack_tension;
    dz[0] = d_penetration_P1_d_x_P1;
    let t11 = d_penetration_P1_d_x_P1 * d_penetration_P1_d_x_P1;
    let d_penetration_P1_d_R_P = -(x_P1 * t11);
    dz[1] = d_penetration_P1_d_R_P;
    dz[2] = d_penetration_P1_d_x_P1;
    let d_penetration_P2_d_R_P = -(x_P2 * t11);
    dz[3] = d_penetration_P2_d_R_P;
    dz[4] = d_penetration_S1_d_x_S1;
    let t12 = d_penetration_S1_d_x_S1 * d_penetration_S1_d_x_S1;
    let d_penetration_S1_d_R_S = -(x_S1 * t12);
    dz[5] = d_penetration_S1_d_R_S;
    dz[6] = d_penetration_S1_d_x_S1;
    let d_penetration_S2_d_R_S = -(x_S2 * t12);
    dz[7] = d_penetration_S2_d_R_S;
    dz[8] = 1.0;
    let d_tension_P1_d_tau_t2 = -1.0;
    dz[9] = d_tension_P1_d_tau_t2;
    dz[10] = 1.0;
    dz[11] = d_tension_P1_d_tau_t2;
    dz[12] = d_tension_P1_d_tau_t2;
    dz[13] = 1.0;
    dz[14] = 1.0;
    dz[15] = d_tension_P1_d_tau_t2;
    dz[16] = d_tension_P1_d_tau_t2;
    dz[17] = d_tension_P1_d_tau_t2;
    dz[18] = 1.0;
    dz[19] = d_tension_P1_d_tau_t2;
    dz[20] = d_tension_P1_d_tau_t2;
    dz[21] = 1.0;
    dz[22] = 1.0;
    dz[23] = d_tension_P1_d_tau_t2;
    dz[24] = d_tension_P1_d_tau_t2;
    dz[25] = d_tension_P1_d_tau_t2;
    dz[26] = d_tension_P1_d_tau_t2;
    dz[27] = d_tension_P1_d_tau_t2;
    dz[28] = d_tension_P1_d_tau_t2;
    dz[29] = d_tension_P1_d_tau_t2;
    let d_closure_X_s_d_X_s = -(L_s * d_penetration_P1_d_x_P1);
    dz[30] = d_closure_X_s_d_X_s;
    dz[31] = sin_t1;
    let t13 = R_S * d_penetration_P1_d_x_P1;
    let d_closure_X_s_d_Phi_S = sin_t3 * t13;
    dz[32] = d_closure_X_s_d_Phi_S;
    dz[33] = sin_t1;
    dz[34] = d_closure_X_s_d_Phi_S;
    let d_closure_X_s_d_L_s = -(X_s * d_penetration_P1_d_x_P1);
    dz[35] = d_closure_X_s_d_L_s;
    let d_closure_X_s_d_R_P = -(d_penetration_P1_d_x_P1 * cos_t1 + t5 * t11);
    dz[36] = d_closure_X_s_d_R_P;
    let d_closure_X_s_d_R_S = -(d_penetration_P1_d_x_P1 * cos_t3);
    dz[37] = d_closure_X_s_d_R_S;
    dz[38] = d_penetration_P1_d_x_P1;
    dz[39] = d_closure_X_s_d_X_s;
    let d_closure_Y_s_d_Phi_P = -cos_t1;
    dz[40] = d_closure_Y_s_d_Phi_P;
    let d_closure_Y_s_d_Phi_S = cos_t3 * t13;
    dz[41] = d_closure_Y_s_d_Phi_S;
    dz[42] = d_closure_Y_s_d_Phi_P;
    dz[43] = d_closure_Y_s_d_Phi_S;
    let d_closure_Y_s_d_L_s = -(Y_s * d_penetration_P1_d_x_P1);
    dz[44] = d_closure_Y_s_d_L_s;
    let d_closure_Y_s_d_R_P = -(d_penetration_P1_d_x_P1 * sin_t1 + t6 * t11);
    dz[45] = d_closure_Y_s_d_R_P;
    let d_closure_Y_s_d_R_S = d_penetration_P1_d_x_P1 * sin_t3;
    dz[46] = d_closure_Y_s_d_R_S;
    let d_closure_X_t_d_X_t = -(L_t * d_penetration_S1_d_x_S1);
    dz[47] = d_closure_X_t_d_X_t;
    let t14 = R_P * d_penetration_S1_d_x_S1;
    let d_closure_X_t_d_C_P = -(sin_C_P * t14);
    dz[48] = d_closure_X_t_d_C_P;
    let d_closure_X_t_d_C_S = -sin_C_S;
    dz[49] = d_closure_X_t_d_C_S;
    let d_closure_X_t_d_L_t = -(X_t * d_penetration_S1_d_x_S1);
    dz[50] = d_closure_X_t_d_L_t;
    let d_closure_X_t_d_R_P = d_penetration_S1_d_x_S1 * cos_C_P;
    dz[51] = d_closure_X_t_d_R_P;
    let d_closure_X_t_d_R_S = d_penetration_S1_d_x_S1 * cos_C_S - t9 * t12;
    dz[52] = d_closure_X_t_d_R_S;
    let d_closure_X_t_d_L_c = -d_penetration_S1_d_x_S1;
    dz[53] = d_closure_X_t_d_L_c;
    dz[54] = d_closure_X_t_d_X_t;
    let d_closure_Y_t_d_C_P = cos_C_P * t14;
    dz[55] = d_closure_Y_t_d_C_P;
    let d_closure_Y_t_d_C_S = -cos_C_S;
    dz[56] = d_closure_Y_t_d_C_S;
    let d_closure_Y_t_d_L_t = -(Y_t * d_penetration_S1_d_x_S1);
    dz[57] = d_closure_Y_t_d_L_t;
    let d_closure_Y_t_d_R_P = d_penetration_S1_d_x_S1 * sin_C_P;
    dz[58] = d_closure_Y_t_d_R_P;
    let d_closure_Y_t_d_R_S = -(d_penetration_S1_d_x_S1 * sin_C_S + t10 * t12);
    dz[59] = d_closure_Y_t_d_R_S;
    dz[60] = 1.0;
    dz[61] = 1.0;
    dz[62] = 1.0;
    dz[63] = d_tension_P1_d_tau_t2;
}
