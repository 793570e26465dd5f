// strut_ends: What holds at the ends of the strut.
// Generated from eqgen/examples/elastica/equations.rs. Do not edit:
// `cargo run -p sheave-eqgen --example elastica_write` writes it anew.
// Operations:
//   value: 1 operations
//   jacobian: 2 operations
// Equations, with their numbers in the source:
// - direction (typed in): θ = α at the first end
// - moment_1 (typed in): M = 0 at the first end
// - moment_2 (typed in): M = 0 at the second end

///Structurally nonzero derivatives.
const PATTERN: &[(usize, usize)] = &[(0, 0), (0, 9), (1, 1), (2, 3)];
///What holds at the ends of the strut.
pub(crate) const KERNEL: BoundaryKernel = BoundaryKernel {
    name: "strut_ends",
    equations: &[
        Symbol {
            name: "direction",
            symbol: "",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "θ = α at the first end",
            source: "",
        },
        Symbol {
            name: "moment_1",
            symbol: "",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "M = 0 at the first end",
            source: "",
        },
        Symbol {
            name: "moment_2",
            symbol: "",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "M = 0 at the second end",
            source: "",
        },
    ],
    ends: &[
        Symbol {
            name: "theta_1",
            symbol: "θ_1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "θ at the first end",
            source: "",
        },
        Symbol {
            name: "theta1_1",
            symbol: "θ\u{302}'_1",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "θ\u{302}' at the first end",
            source: "",
        },
        Symbol {
            name: "theta_2",
            symbol: "θ_2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "θ at the second end",
            source: "",
        },
        Symbol {
            name: "theta1_2",
            symbol: "θ\u{302}'_2",
            unit: "rad",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 1,
            },
            doc: "θ\u{302}' at the second end",
            source: "",
        },
    ],
    integrals: &[
        Symbol {
            name: "X",
            symbol: "X\u{302}",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance of the ends over L",
            source: "Euler",
        },
        Symbol {
            name: "Y",
            symbol: "Ŷ",
            unit: "",
            dimension: Dimension {
                length: 0,
                mass: 0,
                time: 0,
                angle: 0,
            },
            doc: "distance of the ends across the load over L",
            source: "Euler",
        },
    ],
    constants: Constant::SYMBOLS,
    pattern: PATTERN,
    value,
    jacobian: derivatives,
};
///Residuals.
fn value(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
    assert!(ends.len() >= 4, "ends: too few values");
    assert!(integrals.len() >= 2, "integrals: too few values");
    assert!(constants.len() >= 4, "constants: too few values");
    let g = sized(g, 3, "g");
    let theta_1 = ends[0];
    let alpha = constants[3];
    let direction = theta_1 - alpha;
    g[0] = direction;
    let theta1_1 = ends[1];
    g[1] = theta1_1;
    let theta1_2 = ends[3];
    g[2] = theta1_2;
}
///Residuals and their derivatives.
fn derivatives(
    ends: &[f64],
    integrals: &[f64],
    constants: &[f64],
    g: &mut [f64],
    dz: &mut [f64],
) {
    assert!(ends.len() >= 4, "ends: too few values");
    assert!(integrals.len() >= 2, "integrals: too few values");
    assert!(constants.len() >= 4, "constants: too few values");
    let g = sized(g, 3, "g");
    let dz = sized(dz, PATTERN.len(), "dz");
    let theta_1 = ends[0];
    let alpha = constants[3];
    let direction = theta_1 - alpha;
    g[0] = direction;
    let theta1_1 = ends[1];
    g[1] = theta1_1;
    let theta1_2 = ends[3];
    g[2] = theta1_2;
    dz[0] = 1.0;
    let d_direction_d_alpha = -1.0;
    dz[1] = d_direction_d_alpha;
    dz[2] = 1.0;
    dz[3] = 1.0;
}
