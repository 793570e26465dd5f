// boundary_zero_full: Boundary equations: no shear where the belt meets a pulley, full shear.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 155 operations
//   jacobian: 449 operations
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
// - curvature_P1 (derived): (5.39)
// - curvature_P2 (derived): (5.40)
// - curvature_S1 (derived): (5.41)
// - curvature_S2 (derived): (5.42)
// - shear_P1 (derived): (5.43)
// - shear_P2 (derived): (5.44)
// - shear_S1 (derived): (5.45)
// - shear_S2 (derived): (5.46)
// - closure_X_s (typed in): (5.29) to (5.32)
// - closure_Y_s (typed in): (5.29) to (5.32)
// - closure_X_t (typed in): (5.27), (5.28), (5.33), (5.34)
// - closure_Y_t (typed in): (5.27), (5.28), (5.33), (5.34)
// - torque (typed in): 5.3.5
// - slack_tension (typed in): 5.3.5

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 4),
    (0, 70),
    (1, 9),
    (1, 70),
    (2, 22),
    (2, 71),
    (3, 27),
    (3, 71),
    (4, 0),
    (4, 32),
    (5, 5),
    (5, 10),
    (6, 14),
    (6, 18),
    (7, 23),
    (7, 28),
    (8, 1),
    (8, 33),
    (8, 62),
    (9, 6),
    (9, 11),
    (9, 60),
    (9, 62),
    (10, 15),
    (10, 19),
    (10, 61),
    (10, 63),
    (11, 24),
    (11, 29),
    (11, 63),
    (12, 1),
    (12, 2),
    (12, 4),
    (12, 34),
    (12, 60),
    (12, 64),
    (12, 70),
    (13, 6),
    (13, 7),
    (13, 9),
    (13, 12),
    (13, 60),
    (13, 65),
    (13, 70),
    (14, 16),
    (14, 19),
    (14, 20),
    (14, 22),
    (14, 61),
    (14, 65),
    (14, 71),
    (15, 24),
    (15, 25),
    (15, 27),
    (15, 30),
    (15, 61),
    (15, 64),
    (15, 71),
    (16, 1),
    (16, 2),
    (16, 3),
    (16, 4),
    (16, 60),
    (16, 70),
    (17, 6),
    (17, 7),
    (17, 8),
    (17, 9),
    (17, 60),
    (17, 70),
    (18, 19),
    (18, 20),
    (18, 21),
    (18, 22),
    (18, 61),
    (18, 71),
    (19, 24),
    (19, 25),
    (19, 26),
    (19, 27),
    (19, 61),
    (19, 71),
    (20, 43),
    (20, 60),
    (20, 61),
    (20, 62),
    (20, 63),
    (20, 65),
    (20, 70),
    (20, 71),
    (20, 72),
    (21, 44),
    (21, 60),
    (21, 61),
    (21, 62),
    (21, 63),
    (21, 65),
    (21, 70),
    (21, 71),
    (22, 54),
    (22, 62),
    (22, 63),
    (22, 64),
    (22, 70),
    (22, 71),
    (22, 72),
    (23, 55),
    (23, 62),
    (23, 63),
    (23, 64),
    (23, 70),
    (23, 71),
    (24, 36),
    (24, 77),
    (25, 5),
    (25, 78),
];
///Boundary equations: no shear where the belt meets a pulley, full shear.
pub(crate) const KERNEL: BoundaryKernel = BoundaryKernel {
    name: "boundary_zero_full",
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
            name: "curvature_P1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's curvature at P1 is that at t2, times R",
            source: "(5.39)",
        },
        Symbol {
            name: "curvature_P2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's curvature at P2 is that at s1, times R",
            source: "(5.40)",
        },
        Symbol {
            name: "curvature_S1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's curvature at S1 is that at s2, times R",
            source: "(5.41)",
        },
        Symbol {
            name: "curvature_S2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "the belt's curvature at S2 is that at t1, times R",
            source: "(5.42)",
        },
        Symbol {
            name: "shear_P1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "Q_P1 = 0, times R²/EI",
            source: "(5.43)",
        },
        Symbol {
            name: "shear_P2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "Q_P2 = 0, times R²/EI",
            source: "(5.44)",
        },
        Symbol {
            name: "shear_S1",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "Q_S1 = 0, times R²/EI",
            source: "(5.45)",
        },
        Symbol {
            name: "shear_S2",
            symbol: "",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "Q_S2 = 0, times R²/EI",
            source: "(5.46)",
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
            name: "theta1_P1",
            symbol: "θ\u{302}'_P1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region: entry of the primary",
            source: "(5.2)",
        },
        Symbol {
            name: "theta2_P1",
            symbol: "θ\u{302}''_P1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region: entry of the primary",
            source: "(5.3)",
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
            name: "theta1_P2",
            symbol: "θ\u{302}'_P2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region: exit of the primary",
            source: "(5.2)",
        },
        Symbol {
            name: "theta2_P2",
            symbol: "θ\u{302}''_P2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region: exit of the primary",
            source: "(5.3)",
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
            name: "vartheta1_s1",
            symbol: "ϑ\u{302}'_s1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span: entry of the slack span",
            source: "(5.10)",
        },
        Symbol {
            name: "vartheta2_s1",
            symbol: "ϑ\u{302}''_s1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span: entry of the slack span",
            source: "(5.11)",
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
            name: "vartheta1_s2",
            symbol: "ϑ\u{302}'_s2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span: exit of the slack span",
            source: "(5.10)",
        },
        Symbol {
            name: "vartheta2_s2",
            symbol: "ϑ\u{302}''_s2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span: exit of the slack span",
            source: "(5.11)",
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
            name: "theta1_S1",
            symbol: "θ\u{302}'_S1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region: entry of the secondary",
            source: "(5.2)",
        },
        Symbol {
            name: "theta2_S1",
            symbol: "θ\u{302}''_S1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region: entry of the secondary",
            source: "(5.3)",
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
            name: "theta1_S2",
            symbol: "θ\u{302}'_S2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of θ along the region: exit of the secondary",
            source: "(5.2)",
        },
        Symbol {
            name: "theta2_S2",
            symbol: "θ\u{302}''_S2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of θ along the region: exit of the secondary",
            source: "(5.3)",
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
            name: "vartheta1_t1",
            symbol: "ϑ\u{302}'_t1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span: entry of the tight span",
            source: "(5.10)",
        },
        Symbol {
            name: "vartheta2_t1",
            symbol: "ϑ\u{302}''_t1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span: entry of the tight span",
            source: "(5.11)",
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
        Symbol {
            name: "vartheta1_t2",
            symbol: "ϑ\u{302}'_t2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "first derivative of ϑ along the span: exit of the tight span",
            source: "(5.10)",
        },
        Symbol {
            name: "vartheta2_t2",
            symbol: "ϑ\u{302}''_t2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "second derivative of ϑ along the span: exit of the tight span",
            source: "(5.11)",
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
    assert!(ends.len() >= 36, "ends: too few values");
    assert!(integrals.len() >= 22, "integrals: too few values");
    assert!(constants.len() >= 21, "constants: too few values");
    let g = sized(g, 26, "g");
    let x_P1 = ends[4];
    let R_P = constants[12];
    let t1 = reciprocal(R_P);
    let penetration_P1 = x_P1 * t1;
    g[0] = penetration_P1;
    let x_P2 = ends[9];
    let penetration_P2 = x_P2 * t1;
    g[1] = penetration_P2;
    let x_S1 = ends[22];
    let R_S = constants[13];
    let t2 = reciprocal(R_S);
    let penetration_S1 = x_S1 * t2;
    g[2] = penetration_S1;
    let x_S2 = ends[27];
    let penetration_S2 = x_S2 * t2;
    g[3] = penetration_S2;
    let T_P1 = ends[0];
    let tau_t2 = ends[32];
    let tension_P1 = T_P1 - tau_t2;
    g[4] = tension_P1;
    let T_P2 = ends[5];
    let tau_s1 = ends[10];
    let tension_P2 = T_P2 - tau_s1;
    g[5] = tension_P2;
    let T_S1 = ends[18];
    let tau_s2 = ends[14];
    let tension_S1 = T_S1 - tau_s2;
    g[6] = tension_S1;
    let T_S2 = ends[23];
    let tau_t1 = ends[28];
    let tension_S2 = T_S2 - tau_t1;
    g[7] = tension_S2;
    let C_P = constants[4];
    let theta_P1 = ends[1];
    let vartheta_t2 = ends[33];
    let direction_P1 = C_P + 1.5707963267948966 - theta_P1 - vartheta_t2;
    g[8] = direction_P1;
    let Phi_P = constants[2];
    let t3 = Phi_P + C_P;
    let theta_P2 = ends[6];
    let vartheta_s1 = ends[11];
    let direction_P2 = t3 - theta_P2 - vartheta_s1 - 4.71238898038469;
    g[9] = direction_P2;
    let Phi_S = constants[3];
    let C_S = constants[5];
    let theta_S1 = ends[19];
    let vartheta_s2 = ends[15];
    let direction_S1 = 4.71238898038469 - Phi_S - C_S - theta_S1 - vartheta_s2;
    g[10] = direction_S1;
    let theta_S2 = ends[24];
    let vartheta_t1 = ends[29];
    let direction_S2 = 4.71238898038469 - C_S - theta_S2 - vartheta_t1;
    g[11] = direction_S2;
    let t4 = reciprocal(R_P - x_P1);
    let (sin_theta_P1, cos_theta_P1) = sin_cos(theta_P1);
    let theta1_P1 = ends[2];
    let t6 = reciprocal(Phi_P);
    let vartheta1_t2 = ends[34];
    let L_t = constants[6];
    let t7 = reciprocal(L_t);
    let curvature_P1 = R_P
        * (t4 * (cos_theta_P1 * (1.0 - theta1_P1 * t6)) - vartheta1_t2 * t7);
    g[12] = curvature_P1;
    let t8 = reciprocal(R_P - x_P2);
    let (sin_theta_P2, cos_theta_P2) = sin_cos(theta_P2);
    let theta1_P2 = ends[7];
    let vartheta1_s1 = ends[12];
    let L_s = constants[7];
    let t10 = reciprocal(L_s);
    let curvature_P2 = R_P
        * (t8 * (cos_theta_P2 * (1.0 - theta1_P2 * t6)) - vartheta1_s1 * t10);
    g[13] = curvature_P2;
    let t11 = reciprocal(R_S - x_S1);
    let (sin_theta_S1, cos_theta_S1) = sin_cos(theta_S1);
    let theta1_S1 = ends[20];
    let t13 = reciprocal(Phi_S);
    let vartheta1_s2 = ends[16];
    let curvature_S1 = R_S
        * (t11 * (cos_theta_S1 * (1.0 - theta1_S1 * t13)) - vartheta1_s2 * t10);
    g[14] = curvature_S1;
    let t14 = reciprocal(R_S - x_S2);
    let (sin_theta_S2, cos_theta_S2) = sin_cos(theta_S2);
    let theta1_S2 = ends[25];
    let vartheta1_t1 = ends[30];
    let curvature_S2 = R_S
        * (t14 * (cos_theta_S2 * (1.0 - theta1_S2 * t13)) - vartheta1_t1 * t7);
    g[15] = curvature_S2;
    let theta2_P1 = ends[3];
    let t16 = Phi_P * Phi_P;
    let t17 = t6 * t6;
    let t18 = R_P * R_P;
    let t19 = (theta2_P1 * cos_theta_P1 + t16 * sin_theta_P1
        - sin_theta_P1 * (theta1_P1 * theta1_P1))
        * (t4 * t4 * (t17 * (cos_theta_P1 * t18)));
    let shear_P1 = -t19;
    g[16] = shear_P1;
    let theta2_P2 = ends[8];
    let t20 = (theta2_P2 * cos_theta_P2 + t16 * sin_theta_P2
        - sin_theta_P2 * (theta1_P2 * theta1_P2))
        * (t8 * t8 * (t17 * (cos_theta_P2 * t18)));
    let shear_P2 = -t20;
    g[17] = shear_P2;
    let theta2_S1 = ends[21];
    let t21 = Phi_S * Phi_S;
    let t22 = R_S * R_S;
    let t23 = t13 * t13;
    let t24 = (theta2_S1 * cos_theta_S1 + t21 * sin_theta_S1
        - sin_theta_S1 * (theta1_S1 * theta1_S1))
        * (t11 * t11 * (t22 * (cos_theta_S1 * t23)));
    let shear_S1 = -t24;
    g[18] = shear_S1;
    let theta2_S2 = ends[26];
    let t25 = (theta2_S2 * cos_theta_S2 + t21 * sin_theta_S2
        - sin_theta_S2 * (theta1_S2 * theta1_S2))
        * (t14 * t14 * (t22 * (cos_theta_S2 * t23)));
    let shear_S2 = -t25;
    g[19] = shear_S2;
    let L_c = constants[14];
    let (sin_t3, cos_t3) = sin_cos(t3);
    let X_s = integrals[7];
    let t27 = Phi_S + C_S;
    let (sin_t27, cos_t27) = sin_cos(t27);
    let closure_X_s = t1 * (L_c - R_P * cos_t3 - X_s * L_s - R_S * cos_t27);
    g[20] = closure_X_s;
    let Y_s = integrals[8];
    let closure_Y_s = t1 * (R_S * sin_t27 - R_P * sin_t3 - Y_s * L_s);
    g[21] = closure_Y_s;
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let X_t = integrals[18];
    let (sin_C_S, cos_C_S) = sin_cos(C_S);
    let closure_X_t = t2 * (R_P * cos_C_P - X_t * L_t - (L_c - R_S * cos_C_S));
    g[22] = closure_X_t;
    let Y_t = integrals[19];
    let closure_Y_t = t2 * (R_P * sin_C_P - Y_t * L_t - R_S * sin_C_S);
    g[23] = closure_Y_t;
    let M_P = integrals[0];
    let M_in = constants[19];
    let torque = M_P + M_in;
    g[24] = torque;
    let T_slack = constants[20];
    let slack_tension = T_P2 - T_slack;
    g[25] = slack_tension;
}
///Residuals and their derivatives.
fn derivatives(
    ends: &[f64],
    integrals: &[f64],
    constants: &[f64],
    g: &mut [f64],
    dz: &mut [f64],
) {
    assert!(ends.len() >= 36, "ends: too few values");
    assert!(integrals.len() >= 22, "integrals: too few values");
    assert!(constants.len() >= 21, "constants: too few values");
    let g = sized(g, 26, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let x_P1 = ends[4];
    let R_P = constants[12];
    let d_penetration_P1_d_x_P1 = reciprocal(R_P);
    let penetration_P1 = x_P1 * d_penetration_P1_d_x_P1;
    g[0] = penetration_P1;
    let x_P2 = ends[9];
    let penetration_P2 = x_P2 * d_penetration_P1_d_x_P1;
    g[1] = penetration_P2;
    let x_S1 = ends[22];
    let R_S = constants[13];
    let d_penetration_S1_d_x_S1 = reciprocal(R_S);
    let penetration_S1 = x_S1 * d_penetration_S1_d_x_S1;
    g[2] = penetration_S1;
    let x_S2 = ends[27];
    let penetration_S2 = x_S2 * d_penetration_S1_d_x_S1;
    g[3] = penetration_S2;
    let T_P1 = ends[0];
    let tau_t2 = ends[32];
    let tension_P1 = T_P1 - tau_t2;
    g[4] = tension_P1;
    let T_P2 = ends[5];
    let tau_s1 = ends[10];
    let tension_P2 = T_P2 - tau_s1;
    g[5] = tension_P2;
    let T_S1 = ends[18];
    let tau_s2 = ends[14];
    let tension_S1 = T_S1 - tau_s2;
    g[6] = tension_S1;
    let T_S2 = ends[23];
    let tau_t1 = ends[28];
    let tension_S2 = T_S2 - tau_t1;
    g[7] = tension_S2;
    let C_P = constants[4];
    let theta_P1 = ends[1];
    let vartheta_t2 = ends[33];
    let direction_P1 = C_P + 1.5707963267948966 - theta_P1 - vartheta_t2;
    g[8] = direction_P1;
    let Phi_P = constants[2];
    let t1 = Phi_P + C_P;
    let theta_P2 = ends[6];
    let vartheta_s1 = ends[11];
    let direction_P2 = t1 - theta_P2 - vartheta_s1 - 4.71238898038469;
    g[9] = direction_P2;
    let Phi_S = constants[3];
    let C_S = constants[5];
    let theta_S1 = ends[19];
    let vartheta_s2 = ends[15];
    let direction_S1 = 4.71238898038469 - Phi_S - C_S - theta_S1 - vartheta_s2;
    g[10] = direction_S1;
    let theta_S2 = ends[24];
    let vartheta_t1 = ends[29];
    let direction_S2 = 4.71238898038469 - C_S - theta_S2 - vartheta_t1;
    g[11] = direction_S2;
    let t2 = reciprocal(R_P - x_P1);
    let (sin_theta_P1, cos_theta_P1) = sin_cos(theta_P1);
    let theta1_P1 = ends[2];
    let t4 = reciprocal(Phi_P);
    let t5 = 1.0 - theta1_P1 * t4;
    let vartheta1_t2 = ends[34];
    let L_t = constants[6];
    let t6 = reciprocal(L_t);
    let t7 = t2 * (cos_theta_P1 * t5) - vartheta1_t2 * t6;
    let curvature_P1 = R_P * t7;
    g[12] = curvature_P1;
    let t8 = reciprocal(R_P - x_P2);
    let (sin_theta_P2, cos_theta_P2) = sin_cos(theta_P2);
    let theta1_P2 = ends[7];
    let t10 = 1.0 - theta1_P2 * t4;
    let vartheta1_s1 = ends[12];
    let L_s = constants[7];
    let t11 = reciprocal(L_s);
    let t12 = t8 * (cos_theta_P2 * t10) - vartheta1_s1 * t11;
    let curvature_P2 = R_P * t12;
    g[13] = curvature_P2;
    let t13 = reciprocal(R_S - x_S1);
    let (sin_theta_S1, cos_theta_S1) = sin_cos(theta_S1);
    let theta1_S1 = ends[20];
    let t15 = reciprocal(Phi_S);
    let t16 = 1.0 - theta1_S1 * t15;
    let vartheta1_s2 = ends[16];
    let t17 = t13 * (cos_theta_S1 * t16) - vartheta1_s2 * t11;
    let curvature_S1 = R_S * t17;
    g[14] = curvature_S1;
    let t18 = reciprocal(R_S - x_S2);
    let (sin_theta_S2, cos_theta_S2) = sin_cos(theta_S2);
    let theta1_S2 = ends[25];
    let t20 = 1.0 - theta1_S2 * t15;
    let vartheta1_t1 = ends[30];
    let t21 = t18 * (cos_theta_S2 * t20) - vartheta1_t1 * t6;
    let curvature_S2 = R_S * t21;
    g[15] = curvature_S2;
    let theta2_P1 = ends[3];
    let t22 = Phi_P * Phi_P;
    let t23 = theta1_P1 * theta1_P1;
    let t24 = theta2_P1 * cos_theta_P1 + t22 * sin_theta_P1 - sin_theta_P1 * t23;
    let t25 = t2 * t2;
    let t26 = t4 * t4;
    let t27 = R_P * R_P;
    let t28 = cos_theta_P1 * t27;
    let t29 = t26 * t28;
    let t30 = t25 * t29;
    let shear_P1 = -(t24 * t30);
    g[16] = shear_P1;
    let theta2_P2 = ends[8];
    let t31 = theta1_P2 * theta1_P2;
    let t32 = theta2_P2 * cos_theta_P2 + t22 * sin_theta_P2 - sin_theta_P2 * t31;
    let t33 = t8 * t8;
    let t34 = cos_theta_P2 * t27;
    let t35 = t26 * t34;
    let t36 = t33 * t35;
    let shear_P2 = -(t32 * t36);
    g[17] = shear_P2;
    let theta2_S1 = ends[21];
    let t37 = Phi_S * Phi_S;
    let t38 = theta1_S1 * theta1_S1;
    let t39 = theta2_S1 * cos_theta_S1 + t37 * sin_theta_S1 - sin_theta_S1 * t38;
    let t40 = t13 * t13;
    let t41 = R_S * R_S;
    let t42 = t15 * t15;
    let t43 = t41 * (cos_theta_S1 * t42);
    let t44 = t40 * t43;
    let shear_S1 = -(t39 * t44);
    g[18] = shear_S1;
    let theta2_S2 = ends[26];
    let t45 = theta1_S2 * theta1_S2;
    let t46 = theta2_S2 * cos_theta_S2 + t37 * sin_theta_S2 - sin_theta_S2 * t45;
    let t47 = t18 * t18;
    let t48 = t41 * (cos_theta_S2 * t42);
    let t49 = t47 * t48;
    let shear_S2 = -(t46 * t49);
    g[19] = shear_S2;
    let L_c = constants[14];
    let (sin_t1, cos_t1) = sin_cos(t1);
    let X_s = integrals[7];
    let t51 = Phi_S + C_S;
    let (sin_t51, cos_t51) = sin_cos(t51);
    let t53 = L_c - R_P * cos_t1 - X_s * L_s - R_S * cos_t51;
    let closure_X_s = d_penetration_P1_d_x_P1 * t53;
    g[20] = closure_X_s;
    let Y_s = integrals[8];
    let t54 = R_S * sin_t51 - R_P * sin_t1 - Y_s * L_s;
    let closure_Y_s = d_penetration_P1_d_x_P1 * t54;
    g[21] = closure_Y_s;
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let X_t = integrals[18];
    let (sin_C_S, cos_C_S) = sin_cos(C_S);
    let t57 = R_P * cos_C_P - X_t * L_t - (L_c - R_S * cos_C_S);
    let closure_X_t = d_penetration_S1_d_x_S1 * t57;
    g[22] = closure_X_t;
    let Y_t = integrals[19];
    let t58 = R_P * sin_C_P - Y_t * L_t - R_S * sin_C_S;
    let closure_Y_t = d_penetration_S1_d_x_S1 * t58;
    g[23] = closure_Y_t;
    let M_P = integrals[0];
    let M_in = constants[19];
    let torque = M_P + M_in;
    g[24] = torque;
    let T_slack = constants[20];
    let slack_tension = T_P2 - T_slack;
    g[25] = slack_tension;
    dz[0] = d_penetration_P1_d_x_P1;
    let t59 = d_penetration_P1_d_x_P1 * d_penetration_P1_d_x_P1;
    let d_penetration_P1_d_R_P = -(x_P1 * t59);
    dz[1] = d_penetration_P1_d_R_P;
    dz[2] = d_penetration_P1_d_x_P1;
    let d_penetration_P2_d_R_P = -(x_P2 * t59);
    dz[3] = d_penetration_P2_d_R_P;
    dz[4] = d_penetration_S1_d_x_S1;
    let t60 = d_penetration_S1_d_x_S1 * d_penetration_S1_d_x_S1;
    let d_penetration_S1_d_R_S = -(x_S1 * t60);
    dz[5] = d_penetration_S1_d_R_S;
    dz[6] = d_penetration_S1_d_x_S1;
    let d_penetration_S2_d_R_S = -(x_S2 * t60);
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
    let d_curvature_P1_d_theta_P1 = -(sin_theta_P1 * (t2 * (R_P * t5)));
    dz[30] = d_curvature_P1_d_theta_P1;
    let t61 = R_P * cos_theta_P1;
    let d_curvature_P1_d_theta1_P1 = -(t2 * (t4 * t61));
    dz[31] = d_curvature_P1_d_theta1_P1;
    let d_curvature_P1_d_x_P1 = t25 * (t5 * t61);
    dz[32] = d_curvature_P1_d_x_P1;
    let d_curvature_P1_d_vartheta1_t2 = -(R_P * t6);
    dz[33] = d_curvature_P1_d_vartheta1_t2;
    let d_curvature_P1_d_Phi_P = t26 * (t2 * (cos_theta_P1 * (theta1_P1 * R_P)));
    dz[34] = d_curvature_P1_d_Phi_P;
    let t62 = t6 * t6;
    let d_curvature_P1_d_L_t = t62 * (vartheta1_t2 * R_P);
    dz[35] = d_curvature_P1_d_L_t;
    let d_curvature_P1_d_R_P = t7 - d_curvature_P1_d_x_P1;
    dz[36] = d_curvature_P1_d_R_P;
    let d_curvature_P2_d_theta_P2 = -(sin_theta_P2 * (t8 * (R_P * t10)));
    dz[37] = d_curvature_P2_d_theta_P2;
    let t63 = R_P * cos_theta_P2;
    let d_curvature_P2_d_theta1_P2 = -(t8 * (t4 * t63));
    dz[38] = d_curvature_P2_d_theta1_P2;
    let d_curvature_P2_d_x_P2 = t33 * (t10 * t63);
    dz[39] = d_curvature_P2_d_x_P2;
    let d_curvature_P2_d_vartheta1_s1 = -(R_P * t11);
    dz[40] = d_curvature_P2_d_vartheta1_s1;
    let d_curvature_P2_d_Phi_P = t26 * (t8 * (cos_theta_P2 * (theta1_P2 * R_P)));
    dz[41] = d_curvature_P2_d_Phi_P;
    let t64 = t11 * t11;
    let d_curvature_P2_d_L_s = t64 * (vartheta1_s1 * R_P);
    dz[42] = d_curvature_P2_d_L_s;
    let d_curvature_P2_d_R_P = t12 - d_curvature_P2_d_x_P2;
    dz[43] = d_curvature_P2_d_R_P;
    let d_curvature_S1_d_vartheta1_s2 = -(R_S * t11);
    dz[44] = d_curvature_S1_d_vartheta1_s2;
    let d_curvature_S1_d_theta_S1 = -(sin_theta_S1 * (t13 * (R_S * t16)));
    dz[45] = d_curvature_S1_d_theta_S1;
    let t65 = R_S * cos_theta_S1;
    let d_curvature_S1_d_theta1_S1 = -(t13 * (t15 * t65));
    dz[46] = d_curvature_S1_d_theta1_S1;
    let d_curvature_S1_d_x_S1 = t40 * (t16 * t65);
    dz[47] = d_curvature_S1_d_x_S1;
    let d_curvature_S1_d_Phi_S = t42 * (t13 * (cos_theta_S1 * (theta1_S1 * R_S)));
    dz[48] = d_curvature_S1_d_Phi_S;
    let d_curvature_S1_d_L_s = t64 * (vartheta1_s2 * R_S);
    dz[49] = d_curvature_S1_d_L_s;
    let d_curvature_S1_d_R_S = t17 - d_curvature_S1_d_x_S1;
    dz[50] = d_curvature_S1_d_R_S;
    let d_curvature_S2_d_theta_S2 = -(sin_theta_S2 * (t18 * (R_S * t20)));
    dz[51] = d_curvature_S2_d_theta_S2;
    let t66 = R_S * cos_theta_S2;
    let d_curvature_S2_d_theta1_S2 = -(t18 * (t15 * t66));
    dz[52] = d_curvature_S2_d_theta1_S2;
    let d_curvature_S2_d_x_S2 = t47 * (t20 * t66);
    dz[53] = d_curvature_S2_d_x_S2;
    let d_curvature_S2_d_vartheta1_t1 = -(R_S * t6);
    dz[54] = d_curvature_S2_d_vartheta1_t1;
    let d_curvature_S2_d_Phi_S = t42 * (t18 * (cos_theta_S2 * (theta1_S2 * R_S)));
    dz[55] = d_curvature_S2_d_Phi_S;
    let d_curvature_S2_d_L_t = t62 * (vartheta1_t1 * R_S);
    dz[56] = d_curvature_S2_d_L_t;
    let d_curvature_S2_d_R_S = t21 - d_curvature_S2_d_x_S2;
    dz[57] = d_curvature_S2_d_R_S;
    let t67 = t27 * t26;
    let t68 = t25 * t67;
    let d_shear_P1_d_theta_P1 = t24 * (sin_theta_P1 * t68)
        - t30 * (cos_theta_P1 * t22 - theta2_P1 * sin_theta_P1 - cos_theta_P1 * t23);
    dz[58] = d_shear_P1_d_theta_P1;
    let d_shear_P1_d_theta1_P1 = 2.0
        * (sin_theta_P1 * (t25 * (t26 * (t27 * (theta1_P1 * cos_theta_P1)))));
    dz[59] = d_shear_P1_d_theta1_P1;
    let d_shear_P1_d_theta2_P1 = -(cos_theta_P1 * cos_theta_P1 * t68);
    dz[60] = d_shear_P1_d_theta2_P1;
    let t69 = t2 * t25 * (2.0 * (t24 * t29));
    let d_shear_P1_d_x_P1 = -t69;
    dz[61] = d_shear_P1_d_x_P1;
    let t70 = t4 * t26;
    let d_shear_P1_d_Phi_P = t70 * (2.0 * (t24 * (t25 * t28)))
        - 2.0 * (sin_theta_P1 * (t25 * (t27 * (cos_theta_P1 * t4))));
    dz[62] = d_shear_P1_d_Phi_P;
    let d_shear_P1_d_R_P = t69 - 2.0 * (t24 * (t25 * (t26 * t61)));
    dz[63] = d_shear_P1_d_R_P;
    let t71 = t33 * t67;
    let d_shear_P2_d_theta_P2 = t32 * (sin_theta_P2 * t71)
        - t36 * (cos_theta_P2 * t22 - theta2_P2 * sin_theta_P2 - cos_theta_P2 * t31);
    dz[64] = d_shear_P2_d_theta_P2;
    let d_shear_P2_d_theta1_P2 = 2.0
        * (sin_theta_P2 * (t33 * (t26 * (t27 * (theta1_P2 * cos_theta_P2)))));
    dz[65] = d_shear_P2_d_theta1_P2;
    let d_shear_P2_d_theta2_P2 = -(cos_theta_P2 * cos_theta_P2 * t71);
    dz[66] = d_shear_P2_d_theta2_P2;
    let t72 = t8 * t33 * (2.0 * (t32 * t35));
    let d_shear_P2_d_x_P2 = -t72;
    dz[67] = d_shear_P2_d_x_P2;
    let d_shear_P2_d_Phi_P = t70 * (2.0 * (t32 * (t33 * t34)))
        - 2.0 * (sin_theta_P2 * (t33 * (t27 * (cos_theta_P2 * t4))));
    dz[68] = d_shear_P2_d_Phi_P;
    let d_shear_P2_d_R_P = t72 - 2.0 * (t32 * (t33 * (t26 * t63)));
    dz[69] = d_shear_P2_d_R_P;
    let t73 = t42 * t41;
    let t74 = t40 * t73;
    let d_shear_S1_d_theta_S1 = t39 * (sin_theta_S1 * t74)
        - t44 * (cos_theta_S1 * t37 - theta2_S1 * sin_theta_S1 - cos_theta_S1 * t38);
    dz[70] = d_shear_S1_d_theta_S1;
    let d_shear_S1_d_theta1_S1 = 2.0
        * (sin_theta_S1 * (t40 * (t41 * (t42 * (theta1_S1 * cos_theta_S1)))));
    dz[71] = d_shear_S1_d_theta1_S1;
    let d_shear_S1_d_theta2_S1 = -(cos_theta_S1 * cos_theta_S1 * t74);
    dz[72] = d_shear_S1_d_theta2_S1;
    let t75 = t13 * t40 * (2.0 * (t39 * t43));
    let d_shear_S1_d_x_S1 = -t75;
    dz[73] = d_shear_S1_d_x_S1;
    let t76 = t15 * t42;
    let d_shear_S1_d_Phi_S = t76 * (2.0 * (t39 * (t40 * (cos_theta_S1 * t41))))
        - 2.0 * (sin_theta_S1 * (t40 * (t41 * (cos_theta_S1 * t15))));
    dz[74] = d_shear_S1_d_Phi_S;
    let d_shear_S1_d_R_S = t75 - 2.0 * (t39 * (t40 * (t42 * t65)));
    dz[75] = d_shear_S1_d_R_S;
    let t77 = t47 * t73;
    let d_shear_S2_d_theta_S2 = t46 * (sin_theta_S2 * t77)
        - t49 * (cos_theta_S2 * t37 - theta2_S2 * sin_theta_S2 - cos_theta_S2 * t45);
    dz[76] = d_shear_S2_d_theta_S2;
    let d_shear_S2_d_theta1_S2 = 2.0
        * (sin_theta_S2 * (t47 * (t41 * (t42 * (theta1_S2 * cos_theta_S2)))));
    dz[77] = d_shear_S2_d_theta1_S2;
    let d_shear_S2_d_theta2_S2 = -(cos_theta_S2 * cos_theta_S2 * t77);
    dz[78] = d_shear_S2_d_theta2_S2;
    let t78 = t18 * t47 * (2.0 * (t46 * t48));
    let d_shear_S2_d_x_S2 = -t78;
    dz[79] = d_shear_S2_d_x_S2;
    let d_shear_S2_d_Phi_S = t76 * (2.0 * (t46 * (t47 * (cos_theta_S2 * t41))))
        - 2.0 * (sin_theta_S2 * (t47 * (t41 * (cos_theta_S2 * t15))));
    dz[80] = d_shear_S2_d_Phi_S;
    let d_shear_S2_d_R_S = t78 - 2.0 * (t46 * (t47 * (t42 * t66)));
    dz[81] = d_shear_S2_d_R_S;
    let d_closure_X_s_d_X_s = -(L_s * d_penetration_P1_d_x_P1);
    dz[82] = d_closure_X_s_d_X_s;
    dz[83] = sin_t1;
    let t79 = R_S * d_penetration_P1_d_x_P1;
    let d_closure_X_s_d_Phi_S = sin_t51 * t79;
    dz[84] = d_closure_X_s_d_Phi_S;
    dz[85] = sin_t1;
    dz[86] = d_closure_X_s_d_Phi_S;
    let d_closure_X_s_d_L_s = -(X_s * d_penetration_P1_d_x_P1);
    dz[87] = d_closure_X_s_d_L_s;
    let d_closure_X_s_d_R_P = -(d_penetration_P1_d_x_P1 * cos_t1 + t53 * t59);
    dz[88] = d_closure_X_s_d_R_P;
    let d_closure_X_s_d_R_S = -(d_penetration_P1_d_x_P1 * cos_t51);
    dz[89] = d_closure_X_s_d_R_S;
    dz[90] = d_penetration_P1_d_x_P1;
    dz[91] = d_closure_X_s_d_X_s;
    let d_closure_Y_s_d_Phi_P = -cos_t1;
    dz[92] = d_closure_Y_s_d_Phi_P;
    let d_closure_Y_s_d_Phi_S = cos_t51 * t79;
    dz[93] = d_closure_Y_s_d_Phi_S;
    dz[94] = d_closure_Y_s_d_Phi_P;
    dz[95] = d_closure_Y_s_d_Phi_S;
    let d_closure_Y_s_d_L_s = -(Y_s * d_penetration_P1_d_x_P1);
    dz[96] = d_closure_Y_s_d_L_s;
    let d_closure_Y_s_d_R_P = -(d_penetration_P1_d_x_P1 * sin_t1 + t54 * t59);
    dz[97] = d_closure_Y_s_d_R_P;
    let d_closure_Y_s_d_R_S = d_penetration_P1_d_x_P1 * sin_t51;
    dz[98] = d_closure_Y_s_d_R_S;
    let d_closure_X_t_d_X_t = -(L_t * d_penetration_S1_d_x_S1);
    dz[99] = d_closure_X_t_d_X_t;
    let t80 = R_P * d_penetration_S1_d_x_S1;
    let d_closure_X_t_d_C_P = -(sin_C_P * t80);
    dz[100] = d_closure_X_t_d_C_P;
    let d_closure_X_t_d_C_S = -sin_C_S;
    dz[101] = d_closure_X_t_d_C_S;
    let d_closure_X_t_d_L_t = -(X_t * d_penetration_S1_d_x_S1);
    dz[102] = d_closure_X_t_d_L_t;
    let d_closure_X_t_d_R_P = d_penetration_S1_d_x_S1 * cos_C_P;
    dz[103] = d_closure_X_t_d_R_P;
    let d_closure_X_t_d_R_S = d_penetration_S1_d_x_S1 * cos_C_S - t57 * t60;
    dz[104] = d_closure_X_t_d_R_S;
    let d_closure_X_t_d_L_c = -d_penetration_S1_d_x_S1;
    dz[105] = d_closure_X_t_d_L_c;
    dz[106] = d_closure_X_t_d_X_t;
    let d_closure_Y_t_d_C_P = cos_C_P * t80;
    dz[107] = d_closure_Y_t_d_C_P;
    let d_closure_Y_t_d_C_S = -cos_C_S;
    dz[108] = d_closure_Y_t_d_C_S;
    let d_closure_Y_t_d_L_t = -(Y_t * d_penetration_S1_d_x_S1);
    dz[109] = d_closure_Y_t_d_L_t;
    let d_closure_Y_t_d_R_P = d_penetration_S1_d_x_S1 * sin_C_P;
    dz[110] = d_closure_Y_t_d_R_P;
    let d_closure_Y_t_d_R_S = -(d_penetration_S1_d_x_S1 * sin_C_S + t58 * t60);
    dz[111] = d_closure_Y_t_d_R_S;
    dz[112] = 1.0;
    dz[113] = 1.0;
    dz[114] = 1.0;
    dz[115] = d_tension_P1_d_tau_t2;
}
