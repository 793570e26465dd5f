// outputs_string: Outputs of a drive as functions of its ends, integrals and constants.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 70 operations
//   jacobian: 142 operations
// Equations, with their numbers in the source:
// - s_2 (typed in): a region ends where its variable is 1
// - binding_P (typed in): 6.1.2
// - binding_S (typed in): 6.1.2
// - primary__speed (typed in): 5.1
// - primary__torque (typed in): (5.54)
// - primary__power (typed in): 6.2
// - primary__axial_force (typed in): (5.58)
// - primary__wrap_angle (typed in): (5.1)
// - primary__entry_angle (typed in): (3.2)
// - primary__exit_angle (typed in): (3.2)
// - primary__orientation_angle (typed in): (5.17) to (5.20)
// - primary__resultant_x (typed in): (6.3), (6.5)
// - primary__resultant_y (typed in): (6.4), (6.5)
// - primary__binding_moment (typed in): 6.1.2
// - primary__friction_loss (typed in): power of friction
// - primary__entry_tension (typed in): (3.6)
// - primary__exit_tension (typed in): (3.6)
// - secondary__speed (typed in): 5.1
// - secondary__torque (typed in): (5.54)
// - secondary__power (typed in): 6.2
// - secondary__axial_force (typed in): (5.58)
// - secondary__wrap_angle (typed in): (5.1)
// - secondary__entry_angle (typed in): (3.2)
// - secondary__exit_angle (typed in): (3.2)
// - secondary__orientation_angle (typed in): (5.17) to (5.20)
// - secondary__resultant_x (typed in): (6.3), (6.6)
// - secondary__resultant_y (typed in): (6.4), (6.6)
// - secondary__binding_moment (typed in): 6.1.2
// - secondary__friction_loss (typed in): power of friction
// - secondary__entry_tension (typed in): (3.6)
// - secondary__exit_tension (typed in): (3.6)
// - tight_span__arc_length (typed in): (5.9)
// - tight_span__unstretched_length (typed in): (5.56)
// - slack_span__arc_length (typed in): (5.9)
// - slack_span__unstretched_length (typed in): (5.56)
// - efficiency__speed (typed in): (6.7)
// - efficiency__torque (typed in): (6.8)
// - efficiency__overall (typed in): (6.9)
// - belt__mass_flow (typed in): (3.5)
// - belt__unstretched_length (typed in): (5.55), (5.56)
// - energy__power_in (typed in): energy balance
// - energy__power_out (typed in): energy balance
// - energy__friction_loss (typed in): power of friction
// - energy__stretch_work (typed in): energy balance
// - energy__imbalance (typed in): energy balance
// - energy__closure (typed in): energy balance

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[
    (0, 60),
    (1, 20),
    (2, 20),
    (2, 60),
    (3, 21),
    (4, 44),
    (5, 1),
    (6, 4),
    (7, 46),
    (8, 21),
    (8, 24),
    (8, 25),
    (8, 46),
    (9, 21),
    (9, 24),
    (9, 25),
    (9, 46),
    (10, 24),
    (10, 25),
    (11, 23),
    (12, 0),
    (13, 3),
    (14, 42),
    (14, 60),
    (15, 31),
    (16, 31),
    (16, 42),
    (16, 60),
    (17, 32),
    (18, 45),
    (19, 11),
    (20, 14),
    (21, 47),
    (22, 32),
    (22, 35),
    (22, 36),
    (22, 45),
    (22, 47),
    (23, 32),
    (23, 35),
    (23, 36),
    (23, 45),
    (23, 47),
    (24, 35),
    (24, 36),
    (25, 34),
    (26, 10),
    (27, 13),
    (28, 48),
    (29, 40),
    (30, 49),
    (31, 29),
    (32, 42),
    (32, 54),
    (32, 55),
    (33, 20),
    (33, 31),
    (33, 54),
    (33, 55),
    (34, 20),
    (34, 31),
    (34, 42),
    (35, 43),
    (35, 53),
    (35, 54),
    (35, 60),
    (36, 22),
    (36, 29),
    (36, 33),
    (36, 40),
    (37, 20),
    (37, 60),
    (38, 31),
    (38, 42),
    (38, 60),
    (39, 23),
    (39, 34),
    (40, 26),
    (40, 30),
    (40, 37),
    (40, 41),
    (41, 20),
    (41, 23),
    (41, 31),
    (41, 34),
    (41, 42),
    (41, 60),
    (42, 20),
    (42, 23),
    (42, 26),
    (42, 30),
    (42, 31),
    (42, 34),
    (42, 37),
    (42, 41),
    (42, 42),
    (42, 60),
];
///Outputs of a drive as functions of its ends, integrals and constants.
pub(crate) const KERNEL: OutputKernel = OutputKernel {
    theory: BeltTheory::String,
    outputs: &[
        Output::PrimarySpeed,
        Output::PrimaryTorque,
        Output::PrimaryPower,
        Output::PrimaryAxialForce,
        Output::PrimaryWrapAngle,
        Output::PrimaryEntryAngle,
        Output::PrimaryExitAngle,
        Output::PrimaryOrientationAngle,
        Output::PrimaryResultantX,
        Output::PrimaryResultantY,
        Output::PrimaryBindingMoment,
        Output::PrimaryFrictionLoss,
        Output::PrimaryEntryTension,
        Output::PrimaryExitTension,
        Output::SecondarySpeed,
        Output::SecondaryTorque,
        Output::SecondaryPower,
        Output::SecondaryAxialForce,
        Output::SecondaryWrapAngle,
        Output::SecondaryEntryAngle,
        Output::SecondaryExitAngle,
        Output::SecondaryOrientationAngle,
        Output::SecondaryResultantX,
        Output::SecondaryResultantY,
        Output::SecondaryBindingMoment,
        Output::SecondaryFrictionLoss,
        Output::SecondaryEntryTension,
        Output::SecondaryExitTension,
        Output::TightSpanArcLength,
        Output::TightSpanUnstretchedLength,
        Output::SlackSpanArcLength,
        Output::SlackSpanUnstretchedLength,
        Output::EfficiencySpeed,
        Output::EfficiencyTorque,
        Output::EfficiencyOverall,
        Output::BeltMassFlow,
        Output::BeltUnstretchedLength,
        Output::EnergyPowerIn,
        Output::EnergyPowerOut,
        Output::EnergyFrictionLoss,
        Output::EnergyStretchWork,
        Output::EnergyImbalance,
        Output::EnergyClosure,
    ],
    set: BoundaryKernel {
        name: "outputs_string",
        equations: &[
            *Output::PrimarySpeed.symbol(),
            *Output::PrimaryTorque.symbol(),
            *Output::PrimaryPower.symbol(),
            *Output::PrimaryAxialForce.symbol(),
            *Output::PrimaryWrapAngle.symbol(),
            *Output::PrimaryEntryAngle.symbol(),
            *Output::PrimaryExitAngle.symbol(),
            *Output::PrimaryOrientationAngle.symbol(),
            *Output::PrimaryResultantX.symbol(),
            *Output::PrimaryResultantY.symbol(),
            *Output::PrimaryBindingMoment.symbol(),
            *Output::PrimaryFrictionLoss.symbol(),
            *Output::PrimaryEntryTension.symbol(),
            *Output::PrimaryExitTension.symbol(),
            *Output::SecondarySpeed.symbol(),
            *Output::SecondaryTorque.symbol(),
            *Output::SecondaryPower.symbol(),
            *Output::SecondaryAxialForce.symbol(),
            *Output::SecondaryWrapAngle.symbol(),
            *Output::SecondaryEntryAngle.symbol(),
            *Output::SecondaryExitAngle.symbol(),
            *Output::SecondaryOrientationAngle.symbol(),
            *Output::SecondaryResultantX.symbol(),
            *Output::SecondaryResultantY.symbol(),
            *Output::SecondaryBindingMoment.symbol(),
            *Output::SecondaryFrictionLoss.symbol(),
            *Output::SecondaryEntryTension.symbol(),
            *Output::SecondaryExitTension.symbol(),
            *Output::TightSpanArcLength.symbol(),
            *Output::TightSpanUnstretchedLength.symbol(),
            *Output::SlackSpanArcLength.symbol(),
            *Output::SlackSpanUnstretchedLength.symbol(),
            *Output::EfficiencySpeed.symbol(),
            *Output::EfficiencyTorque.symbol(),
            *Output::EfficiencyOverall.symbol(),
            *Output::BeltMassFlow.symbol(),
            *Output::BeltUnstretchedLength.symbol(),
            *Output::EnergyPowerIn.symbol(),
            *Output::EnergyPowerOut.symbol(),
            *Output::EnergyFrictionLoss.symbol(),
            *Output::EnergyStretchWork.symbol(),
            *Output::EnergyImbalance.symbol(),
            *Output::EnergyClosure.symbol(),
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
    },
};
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 20, "ends: too few values");
    assert!(integrals.len() >= 22, "integrals: too few values");
    assert!(constants.len() >= 21, "constants: too few values");
    let g = sized(g, 43, "g");
    let omega_P = constants[18];
    g[0] = omega_P;
    let M_P = integrals[0];
    let primary__torque = -M_P;
    g[1] = primary__torque;
    let primary__power = -(M_P * omega_P);
    g[2] = primary__power;
    let A_P = integrals[1];
    g[3] = A_P;
    let Phi_P = constants[2];
    g[4] = Phi_P;
    let theta_P1 = ends[1];
    g[5] = theta_P1;
    let theta_P2 = ends[4];
    g[6] = theta_P2;
    let C_P = constants[4];
    g[7] = C_P;
    let t1 = reciprocal(A_P);
    let A_x_P = integrals[4];
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let A_y_P = integrals[5];
    let primary__resultant_x = t1 * (A_x_P * cos_C_P - A_y_P * sin_C_P);
    g[8] = primary__resultant_x;
    let primary__resultant_y = t1 * (A_x_P * sin_C_P + A_y_P * cos_C_P);
    g[9] = primary__resultant_y;
    let binding_P = sqrt(A_x_P * A_x_P + A_y_P * A_y_P);
    g[10] = binding_P;
    let W_P = integrals[3];
    g[11] = W_P;
    let T_P1 = ends[0];
    g[12] = T_P1;
    let T_P2 = ends[3];
    g[13] = T_P2;
    let speed_ratio = constants[0];
    let secondary__speed = speed_ratio * omega_P;
    g[14] = secondary__speed;
    let M_S = integrals[11];
    g[15] = M_S;
    let t3 = M_S * speed_ratio;
    let secondary__power = omega_P * t3;
    g[16] = secondary__power;
    let A_S = integrals[12];
    g[17] = A_S;
    let Phi_S = constants[3];
    g[18] = Phi_S;
    let theta_S1 = ends[11];
    g[19] = theta_S1;
    let theta_S2 = ends[14];
    g[20] = theta_S2;
    let C_S = constants[5];
    g[21] = C_S;
    let t4 = reciprocal(A_S);
    let A_x_S = integrals[15];
    let t5 = Phi_S + C_S;
    let (sin_t5, cos_t5) = sin_cos(t5);
    let A_y_S = integrals[16];
    let secondary__resultant_x = -(t4 * (A_x_S * cos_t5 + A_y_S * sin_t5));
    g[22] = secondary__resultant_x;
    let secondary__resultant_y = t4 * (A_x_S * sin_t5 - A_y_S * cos_t5);
    g[23] = secondary__resultant_y;
    let binding_S = sqrt(A_x_S * A_x_S + A_y_S * A_y_S);
    g[24] = binding_S;
    let W_S = integrals[14];
    g[25] = W_S;
    let T_S1 = ends[10];
    g[26] = T_S1;
    let T_S2 = ends[13];
    g[27] = T_S2;
    let L_t = constants[6];
    g[28] = L_t;
    let L_o_t = integrals[20];
    g[29] = L_o_t;
    let L_s = constants[7];
    g[30] = L_s;
    let L_o_s = integrals[9];
    g[31] = L_o_s;
    let R_P = constants[12];
    let R_S = constants[13];
    let efficiency__speed = reciprocal(R_P) * (speed_ratio * R_S);
    g[32] = efficiency__speed;
    let t7 = reciprocal(M_P);
    let efficiency__torque = -(t7 * (reciprocal(R_S) * (M_S * R_P)));
    g[33] = efficiency__torque;
    let efficiency__overall = -(t3 * t7);
    g[34] = efficiency__overall;
    let flow = constants[1];
    let m_o = constants[11];
    let belt__mass_flow = omega_P * (R_P * (flow * m_o));
    g[35] = belt__mass_flow;
    let L_o_S = integrals[13];
    let L_o_P = integrals[2];
    let belt__unstretched_length = L_o_t + (L_o_S + (L_o_P + L_o_s));
    g[36] = belt__unstretched_length;
    g[37] = primary__power;
    g[38] = secondary__power;
    let energy__friction_loss = W_P + W_S;
    g[39] = energy__friction_loss;
    let E_t = integrals[21];
    let E_S = integrals[17];
    let E_P = integrals[6];
    let E_s = integrals[10];
    let energy__stretch_work = E_t + (E_S + (E_P + E_s));
    g[40] = energy__stretch_work;
    let t8 = t7 * reciprocal(omega_P);
    let energy__imbalance = 1.0 + (secondary__power + energy__friction_loss) * t8;
    g[41] = energy__imbalance;
    let energy__closure = 1.0
        + t8 * (secondary__power + (E_t + (E_S + (W_S + (E_s + (W_P + E_P))))));
    g[42] = energy__closure;
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
    let g = sized(g, 43, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let omega_P = constants[18];
    g[0] = omega_P;
    let M_P = integrals[0];
    let primary__torque = -M_P;
    g[1] = primary__torque;
    let primary__power = -(M_P * omega_P);
    g[2] = primary__power;
    let A_P = integrals[1];
    g[3] = A_P;
    let Phi_P = constants[2];
    g[4] = Phi_P;
    let theta_P1 = ends[1];
    g[5] = theta_P1;
    let theta_P2 = ends[4];
    g[6] = theta_P2;
    let C_P = constants[4];
    g[7] = C_P;
    let t1 = reciprocal(A_P);
    let A_x_P = integrals[4];
    let (sin_C_P, cos_C_P) = sin_cos(C_P);
    let A_y_P = integrals[5];
    let t3 = A_x_P * cos_C_P - A_y_P * sin_C_P;
    let primary__resultant_x = t1 * t3;
    g[8] = primary__resultant_x;
    let t4 = A_x_P * sin_C_P + A_y_P * cos_C_P;
    let primary__resultant_y = t1 * t4;
    g[9] = primary__resultant_y;
    let binding_P = sqrt(A_x_P * A_x_P + A_y_P * A_y_P);
    g[10] = binding_P;
    let W_P = integrals[3];
    g[11] = W_P;
    let T_P1 = ends[0];
    g[12] = T_P1;
    let T_P2 = ends[3];
    g[13] = T_P2;
    let speed_ratio = constants[0];
    let secondary__speed = speed_ratio * omega_P;
    g[14] = secondary__speed;
    let M_S = integrals[11];
    g[15] = M_S;
    let d_secondary__power_d_omega_P = M_S * speed_ratio;
    let secondary__power = omega_P * d_secondary__power_d_omega_P;
    g[16] = secondary__power;
    let A_S = integrals[12];
    g[17] = A_S;
    let Phi_S = constants[3];
    g[18] = Phi_S;
    let theta_S1 = ends[11];
    g[19] = theta_S1;
    let theta_S2 = ends[14];
    g[20] = theta_S2;
    let C_S = constants[5];
    g[21] = C_S;
    let t5 = reciprocal(A_S);
    let A_x_S = integrals[15];
    let t6 = Phi_S + C_S;
    let (sin_t6, cos_t6) = sin_cos(t6);
    let A_y_S = integrals[16];
    let t8 = A_x_S * cos_t6 + A_y_S * sin_t6;
    let d_secondary__resultant_y_d_Phi_S = t5 * t8;
    let secondary__resultant_x = -d_secondary__resultant_y_d_Phi_S;
    g[22] = secondary__resultant_x;
    let t9 = A_x_S * sin_t6 - A_y_S * cos_t6;
    let secondary__resultant_y = t5 * t9;
    g[23] = secondary__resultant_y;
    let binding_S = sqrt(A_x_S * A_x_S + A_y_S * A_y_S);
    g[24] = binding_S;
    let W_S = integrals[14];
    g[25] = W_S;
    let T_S1 = ends[10];
    g[26] = T_S1;
    let T_S2 = ends[13];
    g[27] = T_S2;
    let L_t = constants[6];
    g[28] = L_t;
    let L_o_t = integrals[20];
    g[29] = L_o_t;
    let L_s = constants[7];
    g[30] = L_s;
    let L_o_s = integrals[9];
    g[31] = L_o_s;
    let R_P = constants[12];
    let t10 = reciprocal(R_P);
    let R_S = constants[13];
    let t11 = speed_ratio * R_S;
    let efficiency__speed = t10 * t11;
    g[32] = efficiency__speed;
    let t12 = reciprocal(M_P);
    let t13 = reciprocal(R_S);
    let t14 = M_S * R_P;
    let t15 = t13 * t14;
    let efficiency__torque = -(t12 * t15);
    g[33] = efficiency__torque;
    let t16 = d_secondary__power_d_omega_P * t12;
    let efficiency__overall = -t16;
    g[34] = efficiency__overall;
    let flow = constants[1];
    let m_o = constants[11];
    let t17 = flow * m_o;
    let d_belt__mass_flow_d_omega_P = R_P * t17;
    let belt__mass_flow = omega_P * d_belt__mass_flow_d_omega_P;
    g[35] = belt__mass_flow;
    let L_o_S = integrals[13];
    let L_o_P = integrals[2];
    let belt__unstretched_length = L_o_t + (L_o_S + (L_o_P + L_o_s));
    g[36] = belt__unstretched_length;
    g[37] = primary__power;
    g[38] = secondary__power;
    let energy__friction_loss = W_P + W_S;
    g[39] = energy__friction_loss;
    let E_t = integrals[21];
    let E_S = integrals[17];
    let E_P = integrals[6];
    let E_s = integrals[10];
    let energy__stretch_work = E_t + (E_S + (E_P + E_s));
    g[40] = energy__stretch_work;
    let t18 = secondary__power + energy__friction_loss;
    let t19 = reciprocal(omega_P);
    let d_energy__imbalance_d_W_P = t12 * t19;
    let energy__imbalance = 1.0 + t18 * d_energy__imbalance_d_W_P;
    g[41] = energy__imbalance;
    let t20 = secondary__power + (E_t + (E_S + (W_S + (E_s + (W_P + E_P)))));
    let energy__closure = 1.0 + d_energy__imbalance_d_W_P * t20;
    g[42] = energy__closure;
    dz[0] = 1.0;
    let d_primary__torque_d_M_P = -1.0;
    dz[1] = d_primary__torque_d_M_P;
    let d_primary__power_d_M_P = -omega_P;
    dz[2] = d_primary__power_d_M_P;
    dz[3] = primary__torque;
    dz[4] = 1.0;
    dz[5] = 1.0;
    dz[6] = 1.0;
    dz[7] = 1.0;
    dz[8] = 1.0;
    let t21 = t1 * t1;
    let d_primary__resultant_x_d_A_P = -(t3 * t21);
    dz[9] = d_primary__resultant_x_d_A_P;
    let d_primary__resultant_x_d_A_x_P = t1 * cos_C_P;
    dz[10] = d_primary__resultant_x_d_A_x_P;
    let d_primary__resultant_y_d_A_x_P = t1 * sin_C_P;
    let d_primary__resultant_x_d_A_y_P = -d_primary__resultant_y_d_A_x_P;
    dz[11] = d_primary__resultant_x_d_A_y_P;
    let d_primary__resultant_x_d_C_P = -primary__resultant_y;
    dz[12] = d_primary__resultant_x_d_C_P;
    let d_primary__resultant_y_d_A_P = -(t4 * t21);
    dz[13] = d_primary__resultant_y_d_A_P;
    dz[14] = d_primary__resultant_y_d_A_x_P;
    dz[15] = d_primary__resultant_x_d_A_x_P;
    dz[16] = primary__resultant_x;
    let t22 = 0.5 * reciprocal(binding_P);
    let d_primary__binding_moment_d_A_x_P = t22 * (A_x_P * 2.0);
    dz[17] = d_primary__binding_moment_d_A_x_P;
    let d_primary__binding_moment_d_A_y_P = t22 * (A_y_P * 2.0);
    dz[18] = d_primary__binding_moment_d_A_y_P;
    dz[19] = 1.0;
    dz[20] = 1.0;
    dz[21] = 1.0;
    dz[22] = omega_P;
    dz[23] = speed_ratio;
    dz[24] = 1.0;
    dz[25] = secondary__speed;
    let d_secondary__power_d_speed_ratio = M_S * omega_P;
    dz[26] = d_secondary__power_d_speed_ratio;
    dz[27] = d_secondary__power_d_omega_P;
    dz[28] = 1.0;
    dz[29] = 1.0;
    dz[30] = 1.0;
    dz[31] = 1.0;
    dz[32] = 1.0;
    let t23 = t5 * t5;
    let d_secondary__resultant_x_d_A_S = t8 * t23;
    dz[33] = d_secondary__resultant_x_d_A_S;
    let d_secondary__resultant_x_d_A_x_S = -(t5 * cos_t6);
    dz[34] = d_secondary__resultant_x_d_A_x_S;
    let d_secondary__resultant_y_d_A_x_S = t5 * sin_t6;
    let d_secondary__resultant_x_d_A_y_S = -d_secondary__resultant_y_d_A_x_S;
    dz[35] = d_secondary__resultant_x_d_A_y_S;
    dz[36] = secondary__resultant_y;
    dz[37] = secondary__resultant_y;
    let d_secondary__resultant_y_d_A_S = -(t9 * t23);
    dz[38] = d_secondary__resultant_y_d_A_S;
    dz[39] = d_secondary__resultant_y_d_A_x_S;
    dz[40] = d_secondary__resultant_x_d_A_x_S;
    dz[41] = d_secondary__resultant_y_d_Phi_S;
    dz[42] = d_secondary__resultant_y_d_Phi_S;
    let t24 = 0.5 * reciprocal(binding_S);
    let d_secondary__binding_moment_d_A_x_S = t24 * (A_x_S * 2.0);
    dz[43] = d_secondary__binding_moment_d_A_x_S;
    let d_secondary__binding_moment_d_A_y_S = t24 * (A_y_S * 2.0);
    dz[44] = d_secondary__binding_moment_d_A_y_S;
    dz[45] = 1.0;
    dz[46] = 1.0;
    dz[47] = 1.0;
    dz[48] = 1.0;
    dz[49] = 1.0;
    dz[50] = 1.0;
    dz[51] = 1.0;
    let d_efficiency__speed_d_speed_ratio = R_S * t10;
    dz[52] = d_efficiency__speed_d_speed_ratio;
    let d_efficiency__speed_d_R_P = -(t11 * (t10 * t10));
    dz[53] = d_efficiency__speed_d_R_P;
    let d_efficiency__speed_d_R_S = speed_ratio * t10;
    dz[54] = d_efficiency__speed_d_R_S;
    let t25 = t12 * t12;
    let d_efficiency__torque_d_M_P = t15 * t25;
    dz[55] = d_efficiency__torque_d_M_P;
    let d_efficiency__torque_d_M_S = -(t12 * (R_P * t13));
    dz[56] = d_efficiency__torque_d_M_S;
    let d_efficiency__torque_d_R_P = -(t12 * (M_S * t13));
    dz[57] = d_efficiency__torque_d_R_P;
    let d_efficiency__torque_d_R_S = t13 * t13 * (t12 * t14);
    dz[58] = d_efficiency__torque_d_R_S;
    let d_efficiency__overall_d_M_P = d_secondary__power_d_omega_P * t25;
    dz[59] = d_efficiency__overall_d_M_P;
    let d_energy__imbalance_d_M_S = speed_ratio * t12;
    let d_efficiency__overall_d_M_S = -d_energy__imbalance_d_M_S;
    dz[60] = d_efficiency__overall_d_M_S;
    let d_energy__imbalance_d_speed_ratio = M_S * t12;
    let d_efficiency__overall_d_speed_ratio = -d_energy__imbalance_d_speed_ratio;
    dz[61] = d_efficiency__overall_d_speed_ratio;
    let d_belt__mass_flow_d_flow = omega_P * (m_o * R_P);
    dz[62] = d_belt__mass_flow_d_flow;
    let d_belt__mass_flow_d_m_o = omega_P * (flow * R_P);
    dz[63] = d_belt__mass_flow_d_m_o;
    let d_belt__mass_flow_d_R_P = omega_P * t17;
    dz[64] = d_belt__mass_flow_d_R_P;
    dz[65] = d_belt__mass_flow_d_omega_P;
    dz[66] = 1.0;
    dz[67] = 1.0;
    dz[68] = 1.0;
    dz[69] = 1.0;
    dz[70] = d_primary__power_d_M_P;
    dz[71] = primary__torque;
    dz[72] = secondary__speed;
    dz[73] = d_secondary__power_d_speed_ratio;
    dz[74] = d_secondary__power_d_omega_P;
    dz[75] = 1.0;
    dz[76] = 1.0;
    dz[77] = 1.0;
    dz[78] = 1.0;
    dz[79] = 1.0;
    dz[80] = 1.0;
    let d_energy__imbalance_d_M_P = -(t25 * (t19 * t18));
    dz[81] = d_energy__imbalance_d_M_P;
    dz[82] = d_energy__imbalance_d_W_P;
    dz[83] = d_energy__imbalance_d_M_S;
    dz[84] = d_energy__imbalance_d_W_P;
    dz[85] = d_energy__imbalance_d_speed_ratio;
    let t26 = t16 * t19;
    let t27 = t19 * t19;
    let d_energy__imbalance_d_omega_P = t26 - t27 * (t12 * t18);
    dz[86] = d_energy__imbalance_d_omega_P;
    let d_energy__closure_d_M_P = -(t25 * (t19 * t20));
    dz[87] = d_energy__closure_d_M_P;
    dz[88] = d_energy__imbalance_d_W_P;
    dz[89] = d_energy__imbalance_d_W_P;
    dz[90] = d_energy__imbalance_d_W_P;
    dz[91] = d_energy__imbalance_d_M_S;
    dz[92] = d_energy__imbalance_d_W_P;
    dz[93] = d_energy__imbalance_d_W_P;
    dz[94] = d_energy__imbalance_d_W_P;
    dz[95] = d_energy__imbalance_d_speed_ratio;
    let d_energy__closure_d_omega_P = t26 - t27 * (t12 * t20);
    dz[96] = d_energy__closure_d_omega_P;
}
