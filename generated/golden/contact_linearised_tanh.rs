// contact_linearised_tanh: The belt in a groove: linearised shear, tanh friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p eqgen -- write` writes it anew.
// Operations per point, and once a batch:
//   value: 26 add, 73 mul, 6 div, 2 sqrt, 3 fn; once 39
//   jacobian: 114 add, 318 mul, 7 div, 2 sqrt, 3 fn; once 91
//   full: 245 add, 554 mul, 7 div, 2 sqrt, 3 fn; once 151
//   fields: 15 add, 37 mul, 4 div, 2 sqrt, 4 fn; once 27

///The belt in a groove: linearised shear, tanh friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_linearised_tanh",
    states: &[
        Symbol {
            name: "T",
            symbol: "T",
            unit: "N",
            doc: "tractive tension F − G V",
        },
        Symbol {
            name: "theta",
            symbol: "θ",
            unit: "rad",
            doc: "inclination of the belt against the pulley's circle; positive unseats",
        },
        Symbol {
            name: "theta1",
            symbol: "θ\u{302}'",
            unit: "rad",
            doc: "first derivative of θ along the region",
        },
        Symbol {
            name: "theta2",
            symbol: "θ\u{302}''",
            unit: "rad",
            doc: "second derivative of θ along the region",
        },
        Symbol {
            name: "x",
            symbol: "x",
            unit: "m",
            doc: "radial penetration R − r",
        },
    ],
    constants: &[
        Symbol {
            name: "Phi",
            symbol: "Φ",
            unit: "rad",
            doc: "wrap angle",
        },
        Symbol {
            name: "sigma",
            symbol: "ω/ω_P",
            unit: "",
            doc: "speed of the pulley over the primary's",
        },
        Symbol {
            name: "flow",
            symbol: "G/(m_o R_P ω_P)",
            unit: "",
            doc: "mass flow, over that of an unstretched belt at the primary's nominal speed",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            doc: "longitudinal stiffness",
        },
        Symbol {
            name: "EI",
            symbol: "EI",
            unit: "N·m²",
            doc: "bending stiffness",
        },
        Symbol {
            name: "k",
            symbol: "k",
            unit: "N/m²",
            doc: "radial stiffness: axial force per length and penetration, both sheaves together",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            doc: "mass per length, unloaded",
        },
        Symbol {
            name: "R",
            symbol: "R",
            unit: "m",
            doc: "nominal radius of the pulley",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            doc: "nominal radius of the primary",
        },
        Symbol {
            name: "beta",
            symbol: "β",
            unit: "rad",
            doc: "half angle of the sheave's groove",
        },
        Symbol {
            name: "mu_k",
            symbol: "μ_k",
            unit: "",
            doc: "kinetic coefficient of friction",
        },
        Symbol {
            name: "v_thr",
            symbol: "v_thr",
            unit: "m/s",
            doc: "slip threshold of the friction law",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            doc: "angular speed of the primary",
        },
    ],
    integrals: &[
        Symbol {
            name: "M",
            symbol: "M",
            unit: "N·m",
            doc: "torque of friction on the belt",
        },
        Symbol {
            name: "A",
            symbol: "A",
            unit: "N",
            doc: "axial force on one sheave",
        },
        Symbol {
            name: "L_o",
            symbol: "L_o",
            unit: "m",
            doc: "unstretched length of the belt in the region",
        },
        Symbol {
            name: "W",
            symbol: "W",
            unit: "W",
            doc: "power lost to friction",
        },
        Symbol {
            name: "A_x",
            symbol: "A_x",
            unit: "N·m",
            doc: "first moment of the axial force along the direction of the entry",
        },
        Symbol {
            name: "A_y",
            symbol: "A_y",
            unit: "N·m",
            doc: "first moment of the axial force across the direction of the entry",
        },
        Symbol {
            name: "E",
            symbol: "E",
            unit: "W",
            doc: "power that changes of speed take from the energy stored in bending and squeezing",
        },
    ],
    fields: &[
        Symbol {
            name: "F",
            symbol: "F",
            unit: "N",
            doc: "belt tension",
        },
        Symbol {
            name: "V",
            symbol: "V",
            unit: "m/s",
            doc: "belt speed",
        },
        Symbol {
            name: "v_r",
            symbol: "v_r",
            unit: "m/s",
            doc: "radial sliding speed",
        },
        Symbol {
            name: "v_t",
            symbol: "v_t",
            unit: "m/s",
            doc: "circumferential sliding speed",
        },
        Symbol {
            name: "speed",
            symbol: "|v|",
            unit: "m/s",
            doc: "sliding speed in the plane of the pulley",
        },
        Symbol {
            name: "gamma",
            symbol: "γ",
            unit: "rad",
            doc: "sliding angle from the outward radius, 0 to 2π",
        },
        Symbol {
            name: "mu",
            symbol: "μ",
            unit: "",
            doc: "coefficient of friction",
        },
        Symbol {
            name: "p",
            symbol: "p",
            unit: "N/m",
            doc: "normal pressure of one sheave on the belt, per length",
        },
        Symbol {
            name: "beta_s",
            symbol: "β_s",
            unit: "rad",
            doc: "apparent sheave angle",
        },
        Symbol {
            name: "Q",
            symbol: "Q",
            unit: "N",
            doc: "transverse shear force",
        },
        Symbol {
            name: "M_b",
            symbol: "M_b",
            unit: "N·m",
            doc: "bending moment",
        },
        Symbol {
            name: "axial",
            symbol: "dA/ds",
            unit: "N/m",
            doc: "axial force on one sheave per length",
        },
        Symbol {
            name: "loss",
            symbol: "dW/ds",
            unit: "W/m",
            doc: "power lost to friction per length",
        },
        Symbol {
            name: "loss_radial",
            symbol: "dW_r/ds",
            unit: "W/m",
            doc: "the part of dW/ds lost to sliding up and down the sheave",
        },
        Symbol {
            name: "loss_tangential",
            symbol: "dW_t/ds",
            unit: "W/m",
            doc: "the part of dW/ds lost to sliding around the pulley",
        },
        Symbol {
            name: "loss_phi",
            symbol: "dW/dφ",
            unit: "W/rad",
            doc: "power lost to friction per wrap angle",
        },
    ],
    usual: 3,
    state_pattern: &[
        (0, 0),
        (0, 1),
        (0, 2),
        (0, 3),
        (0, 4),
        (1, 2),
        (2, 3),
        (3, 0),
        (3, 1),
        (3, 2),
        (3, 4),
        (4, 1),
        (4, 4),
        (5, 0),
        (5, 1),
        (5, 4),
        (6, 1),
        (6, 4),
        (7, 0),
        (7, 1),
        (7, 4),
        (8, 0),
        (8, 1),
        (8, 4),
        (9, 1),
        (9, 4),
        (10, 1),
        (10, 4),
        (11, 0),
        (11, 1),
        (11, 2),
        (11, 3),
        (11, 4),
    ],
    constant_pattern: &[
        (0, 0),
        (0, 1),
        (0, 2),
        (3, 0),
        (3, 1),
        (3, 2),
        (4, 0),
        (5, 0),
        (5, 1),
        (5, 2),
        (6, 0),
        (7, 0),
        (7, 2),
        (8, 0),
        (8, 1),
        (8, 2),
        (9, 0),
        (10, 0),
        (11, 0),
        (11, 1),
        (11, 2),
        (0, 3),
        (0, 4),
        (0, 5),
        (0, 6),
        (0, 7),
        (0, 8),
        (0, 9),
        (0, 10),
        (0, 11),
        (0, 12),
        (3, 3),
        (3, 4),
        (3, 5),
        (3, 6),
        (3, 7),
        (3, 8),
        (3, 9),
        (3, 10),
        (3, 11),
        (3, 12),
        (4, 7),
        (5, 3),
        (5, 5),
        (5, 6),
        (5, 7),
        (5, 8),
        (5, 9),
        (5, 10),
        (5, 11),
        (5, 12),
        (6, 5),
        (6, 7),
        (7, 3),
        (7, 6),
        (7, 7),
        (7, 8),
        (7, 12),
        (8, 3),
        (8, 5),
        (8, 6),
        (8, 7),
        (8, 8),
        (8, 9),
        (8, 10),
        (8, 11),
        (8, 12),
        (9, 5),
        (9, 7),
        (10, 5),
        (10, 7),
        (11, 3),
        (11, 4),
        (11, 5),
        (11, 6),
        (11, 7),
        (11, 8),
        (11, 9),
        (11, 10),
        (11, 11),
        (11, 12),
    ],
    usual_entries: 21,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
///Right-hand side and integrands. (26 add, 73 mul, 6 div, 2 sqrt, 3 fn; once 39)
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 23];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let EA = constants[3];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let u2 = reciprocal(Phi);
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u3 = G * G;
        let u4 = reciprocal(EA * m_o - u3);
        let u5 = EA * u4;
        let V_T = G * u4;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u6 = reciprocal(cos_beta);
        let u7 = u6 * u6;
        let u8 = sin_beta * sin_beta * u7;
        let v_thr = constants[11];
        let u9 = reciprocal(v_thr) * 4.0;
        let u10 = sin_beta * u6;
        let k = constants[5];
        let u11 = k * 0.5;
        let u12 = R * (u2 * u2);
        let EI = constants[4];
        let u13 = reciprocal(R);
        let u14 = EI * (u13 * (u13 * u13));
        let u15 = reciprocal(EI);
        let u16 = u15 * (R * (R * R));
        let u17 = Phi * (Phi * Phi);
        let u18 = 2.0 * u7;
        let u19 = 0.5 * (u6 * (k * sin_beta));
        let u20 = EI * EI * (0.5 * u15);
        [
            Phi,
            EA,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u3,
            u5,
            V_T,
            omega,
            sin_beta,
            u8,
            u9,
            u10,
            u11,
            u12,
            u14,
            u16,
            u17,
            u18,
            u19,
            u20,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let EA = Real::splat(uniforms[1]);
        let m_o = Real::splat(uniforms[2]);
        let R = Real::splat(uniforms[3]);
        let mu_k = Real::splat(uniforms[4]);
        let cos_beta = Real::splat(uniforms[5]);
        let u2 = Real::splat(uniforms[6]);
        let u3 = Real::splat(uniforms[7]);
        let u5 = Real::splat(uniforms[8]);
        let V_T = Real::splat(uniforms[9]);
        let omega = Real::splat(uniforms[10]);
        let sin_beta = Real::splat(uniforms[11]);
        let u8 = Real::splat(uniforms[12]);
        let u9 = Real::splat(uniforms[13]);
        let u10 = Real::splat(uniforms[14]);
        let u11 = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let u14 = Real::splat(uniforms[17]);
        let u16 = Real::splat(uniforms[18]);
        let u17 = Real::splat(uniforms[19]);
        let u18 = Real::splat(uniforms[20]);
        let u19 = Real::splat(uniforms[21]);
        let u20 = Real::splat(uniforms[22]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t2 = v_r * v_r;
        let v_t = cos_theta * V - omega * r;
        let speed = sqrt(v_t * v_t + (Real::splat(0.000000000000000000000001) + t2));
        let face_speed = sqrt(u8 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        let f_r = t3 * (v_r * mu);
        let p = u11 * (x * reciprocal(cos_beta + u10 * f_r));
        let q = Real::splat(2.0) * (r * p);
        let f_t = t3 * (v_t * mu);
        let t4 = reciprocal(cos_theta);
        let tan_theta = t4 * sin_theta;
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t5 = theta_1 - Real::splat(1.0);
        let theta2 = at.state::<Real>(3);
        let T_hat_1 = Phi
            * (t - t5 * (u14 * (u12 * theta2 + R * tan_theta - x * tan_theta)));
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let t6 = tan_theta * tan_theta;
        let t7 = n + T * theta_1 - u14 * (r * (theta_1 * t6 + (theta_1 + t6))) - T;
        let theta_3 = u16 * reciprocal(R + Real::splat(2.0) * x) * t7;
        let theta_hat_3 = u17 * theta_3;
        at.write_f(3, theta_hat_3);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(4, x_hat_1);
        let arc = r * t4;
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(5, M_hat_1);
        let axial = u11 * x;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(6, A_hat_1);
        let F = u5 * (u3 + m_o * T);
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(7, L_o_hat_1);
        let loss_radial = u18 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t8 = Phi * s;
        let (sin_t8, cos_t8) = sin_cos(t8);
        let t10 = r * A_hat_1;
        let A_x_hat_1 = cos_t8 * t10;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t10 * sin_t8;
        at.write_f(10, A_y_hat_1);
        let t11 = reciprocal(arc) * t5;
        let stored = u20 * (t11 * t11) - u19 * (x * x);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and usual constants. (114 add, 318 mul, 7 div, 2 sqrt, 3 fn; once 91)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 33;
    const DC: usize = 21;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 60];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let EA = constants[3];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let omega_P = constants[12];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let u2 = reciprocal(Phi);
        let u3 = u2 * u2;
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u4 = G * G;
        let u5 = EA * m_o;
        let u6 = reciprocal(u5 - u4);
        let u7 = EA * u6;
        let V_T = G * u6;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u8 = sin_beta * sin_beta;
        let u9 = reciprocal(cos_beta);
        let u10 = u9 * u9;
        let u11 = u8 * u10;
        let v_thr = constants[11];
        let u12 = reciprocal(v_thr) * 4.0;
        let u13 = sin_beta * u9;
        let k = constants[5];
        let u14 = k * 0.5;
        let u15 = R * u3;
        let EI = constants[4];
        let u16 = reciprocal(R);
        let u17 = u16 * u16;
        let u18 = EI * (u16 * u17);
        let u19 = reciprocal(EI);
        let u20 = u19 * (R * (R * R));
        let u21 = Phi * Phi;
        let u22 = Phi * u21;
        let u23 = 2.0 * u10;
        let u24 = u9 * (k * sin_beta);
        let u25 = 0.5 * u24;
        let u26 = EI * EI * (0.5 * u19);
        let u27 = omega_P * (m_o * R_P);
        let u28 = u6 * u6;
        let u29 = G * (EA * 2.0);
        let u30 = u28 * u29;
        let u31 = u6 * u29;
        let u32 = EA * EA;
        let u33 = u28 * (2.0 * u4);
        let u34 = 0.5 * (u10 * (2.0 * u8));
        let u35 = 2.0 * u14;
        let u36 = 2.0 * u18;
        let u37 = u20 * u20;
        let u38 = Phi * u18;
        let u39 = u21 * 3.0;
        let u40 = Phi * u14;
        let u41 = Phi * EA;
        let u42 = mu_k * u12;
        let u43 = Phi * reciprocal(EA);
        let u44 = u5 * u6 * u43;
        let u45 = u27 * (u6 + u33);
        let u46 = u18 * u20;
        let u47 = Phi * u23;
        let u48 = Phi * 2.0;
        let u49 = Phi * V_T;
        let u50 = u24 * u49;
        let u51 = u49 * (EI * (EI * u19));
        let u52 = 2.0 * u25;
        let u53 = 2.0 * u20;
        let u54 = EI * u17;
        let u55 = Phi * (u3 * u54);
        let u56 = Phi * (2.0 * (u2 * u3) * u54);
        let u57 = u2 * u38;
        let u58 = u3 * u38;
        let u59 = u2 * u51;
        let u60 = u3 * u51;
        let u61 = Phi * u52;
        let u62 = u2 * u22;
        let u63 = V_T * u57;
        let u64 = V_T * u55;
        [
            Phi,
            EA,
            m_o,
            R,
            mu_k,
            omega_P,
            cos_beta,
            u2,
            u3,
            u4,
            u6,
            u7,
            V_T,
            omega,
            sin_beta,
            u11,
            u12,
            u13,
            u14,
            u15,
            u18,
            u20,
            u22,
            u23,
            u25,
            u26,
            u27,
            u30,
            u31,
            u32,
            u33,
            u34,
            u35,
            u36,
            u37,
            u38,
            u39,
            u40,
            u41,
            u42,
            u43,
            u44,
            u45,
            u46,
            u47,
            u48,
            u50,
            u51,
            u52,
            u53,
            u55,
            u56,
            u57,
            u58,
            u59,
            u60,
            u61,
            u62,
            u63,
            u64,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let EA = Real::splat(uniforms[1]);
        let m_o = Real::splat(uniforms[2]);
        let R = Real::splat(uniforms[3]);
        let mu_k = Real::splat(uniforms[4]);
        let omega_P = Real::splat(uniforms[5]);
        let cos_beta = Real::splat(uniforms[6]);
        let u2 = Real::splat(uniforms[7]);
        let u3 = Real::splat(uniforms[8]);
        let u4 = Real::splat(uniforms[9]);
        let u6 = Real::splat(uniforms[10]);
        let u7 = Real::splat(uniforms[11]);
        let V_T = Real::splat(uniforms[12]);
        let omega = Real::splat(uniforms[13]);
        let sin_beta = Real::splat(uniforms[14]);
        let u11 = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let u13 = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let u18 = Real::splat(uniforms[20]);
        let u20 = Real::splat(uniforms[21]);
        let u22 = Real::splat(uniforms[22]);
        let u23 = Real::splat(uniforms[23]);
        let u25 = Real::splat(uniforms[24]);
        let u26 = Real::splat(uniforms[25]);
        let u27 = Real::splat(uniforms[26]);
        let u30 = Real::splat(uniforms[27]);
        let u31 = Real::splat(uniforms[28]);
        let u32 = Real::splat(uniforms[29]);
        let u33 = Real::splat(uniforms[30]);
        let u34 = Real::splat(uniforms[31]);
        let u35 = Real::splat(uniforms[32]);
        let u36 = Real::splat(uniforms[33]);
        let u37 = Real::splat(uniforms[34]);
        let u38 = Real::splat(uniforms[35]);
        let u39 = Real::splat(uniforms[36]);
        let u40 = Real::splat(uniforms[37]);
        let u41 = Real::splat(uniforms[38]);
        let u42 = Real::splat(uniforms[39]);
        let u43 = Real::splat(uniforms[40]);
        let u44 = Real::splat(uniforms[41]);
        let u45 = Real::splat(uniforms[42]);
        let u46 = Real::splat(uniforms[43]);
        let u47 = Real::splat(uniforms[44]);
        let u48 = Real::splat(uniforms[45]);
        let u50 = Real::splat(uniforms[46]);
        let u51 = Real::splat(uniforms[47]);
        let u52 = Real::splat(uniforms[48]);
        let u53 = Real::splat(uniforms[49]);
        let u55 = Real::splat(uniforms[50]);
        let u56 = Real::splat(uniforms[51]);
        let u57 = Real::splat(uniforms[52]);
        let u58 = Real::splat(uniforms[53]);
        let u59 = Real::splat(uniforms[54]);
        let u60 = Real::splat(uniforms[55]);
        let u61 = Real::splat(uniforms[56]);
        let u62 = Real::splat(uniforms[57]);
        let u63 = Real::splat(uniforms[58]);
        let u64 = Real::splat(uniforms[59]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let T = at.state::<Real>(0);
        let t1 = T + EA;
        let V = V_T * t1;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t3 = v_r * v_r;
        let t4 = cos_theta * V;
        let v_t = t4 - omega * r;
        let speed = sqrt(v_t * v_t + (Real::splat(0.000000000000000000000001) + t3));
        let face_speed = sqrt(u11 * t3 + speed * speed);
        let t5 = reciprocal(face_speed);
        let saturation = tanh(u12 * speed);
        let mu = mu_k * saturation;
        let t6 = v_r * mu;
        let f_r = t5 * t6;
        let t7 = reciprocal(cos_beta + u13 * f_r);
        let t8 = x * t7;
        let p = u14 * t8;
        let t9 = r * p;
        let q = Real::splat(2.0) * t9;
        let t10 = v_t * mu;
        let f_t = t5 * t10;
        let t11 = reciprocal(cos_theta);
        let tan_theta = t11 * sin_theta;
        let t12 = f_r - sin_beta;
        let t13 = f_t + tan_theta * t12;
        let t = q * t13;
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t14 = theta_1 - Real::splat(1.0);
        let theta2 = at.state::<Real>(3);
        let t15 = u15 * theta2 + R * tan_theta - x * tan_theta;
        let t16 = t - t14 * (u18 * t15);
        let T_hat_1 = Phi * t16;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t17 = reciprocal(R + Real::splat(2.0) * x);
        let t18 = u20 * t17;
        let t19 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t19;
        let t20 = tan_theta * tan_theta;
        let t21 = theta_1 * t20 + (theta_1 + t20);
        let t22 = n + T * theta_1 - u18 * (r * t21) - T;
        let theta_3 = t18 * t22;
        let theta_hat_3 = u22 * theta_3;
        at.write_f(3, theta_hat_3);
        let t23 = r * tan_theta;
        let x_hat_1 = -(Phi * t23);
        at.write_f(4, x_hat_1);
        let arc = r * t11;
        let t24 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t24;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u14 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t25 = u4 + m_o * T;
        let F = u7 * t25;
        let t26 = reciprocal(EA + F);
        let d_L_o_hat_1_d_Phi = arc * (EA * t26);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t27 = v_r * f_r;
        let loss_radial = u23 * (p * t27);
        let t28 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t28);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t29 = Phi * s;
        let (sin_t29, cos_t29) = sin_cos(t29);
        let t31 = r * A_hat_1;
        let A_x_hat_1 = cos_t29 * t31;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t31 * sin_t29;
        at.write_f(10, A_y_hat_1);
        let t32 = reciprocal(arc);
        let t33 = t32 * t14;
        let stored = u26 * (t33 * t33) - u25 * (x * x);
        let t34 = T_hat_1 * stored;
        let E_hat_1 = V_T * t34;
        at.write_f(11, E_hat_1);
        let t35 = V_T * sin_theta;
        let t36 = mu * t5;
        let t37 = v_r * t5;
        let t38 = u34 * t37;
        let t39 = t5 * t5;
        let t40 = t6 * t39;
        let t41 = reciprocal(speed);
        let t42 = v_r * t41;
        let t43 = u42 * (Real::splat(1.0) - saturation * saturation);
        let t44 = speed * t5;
        let t45 = t37 * t43 - t44 * t40;
        let t46 = t36 - t38 * t40 + t42 * t45;
        let t47 = tan_theta * q;
        let t48 = x * (t7 * t7);
        let t49 = r * t48;
        let t50 = Phi * t47 - u61 * (t13 * t49);
        let t51 = t10 * t39;
        let t52 = v_t * t5 * t43 - t44 * t51;
        let t53 = t42 * t52 - t38 * t51;
        let t54 = u48 * t9;
        let t55 = t46 * t50 + t53 * t54;
        let t56 = t35 * t55;
        let t57 = V_T * cos_theta;
        let t58 = v_t * t41;
        let t59 = t58 * t45;
        let t60 = t36 + t58 * t52;
        let t61 = t59 * t50 + t60 * t54;
        let d_T_hat_1_d_T = t56 + t57 * t61;
        at.write_dy(0, d_T_hat_1_d_T);
        let t62 = Real::splat(1.0) + t20;
        let t63 = Phi * (t62 * (q * t12)) - Phi * t14 * (t62 * (u18 * r)) + t4 * t55;
        let d_T_hat_1_d_theta = t63 - v_r * t61;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u57 * t15);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = -(u55 * t14);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t64 = u35 * (r * t7) - u35 * t8;
        let t65 = u38 * (tan_theta * t14) + t64 * (Phi * t13);
        let d_T_hat_1_d_x = t65 + omega * t61;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t66 = u22 * (t18 * t47);
        let t67 = t19 * t18;
        let t68 = u22 * (u53 * (t9 * t17) + u52 * t49 * t67);
        let t69 = t53 * t66 - t46 * t68;
        let t70 = t60 * t66 - t59 * t68;
        let d_theta_hat_3_d_T = u22 * (t14 * t18) + t35 * t69 + t57 * t70;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t71 = f_t * q;
        let t72 = t18 * t71
            - u46
                * (t17
                    * (r
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = u22 * (t62 * t72) + t4 * t69 - v_r * t70;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t73 = T * t18 - u46 * (t17 * (r * t62));
        let d_theta_hat_3_d_theta1 = u62 * t73;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t74 = u46 * (t21 * t17) - u36 * (t22 * (u37 * (t17 * t17))) + t64 * t67;
        let d_theta_hat_3_d_x = u22 * t74 + omega * t70;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t62 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let t75 = Phi * (arc * q);
        let t76 = u61 * (t24 * t49);
        let t77 = t75 * t53 - t46 * t76;
        let t78 = t75 * t60 - t59 * t76;
        let d_M_hat_1_d_T = t35 * t77 + t57 * t78;
        at.write_dy(13, d_M_hat_1_d_T);
        let t79 = t11 * t11 * (r * sin_theta);
        let t80 = Phi * t71;
        let d_M_hat_1_d_theta = t4 * t77 + t79 * t80 - v_r * t78;
        at.write_dy(14, d_M_hat_1_d_theta);
        let d_M_hat_1_d_x = Phi * t24 * t64 - t11 * t80 + omega * t78;
        at.write_dy(15, d_M_hat_1_d_x);
        let t81 = u40 * x;
        let d_A_hat_1_d_theta = t79 * t81;
        at.write_dy(16, d_A_hat_1_d_theta);
        let t82 = u40 * arc;
        let d_A_hat_1_d_x = t82 - t11 * t81;
        at.write_dy(17, d_A_hat_1_d_x);
        let t83 = arc * (u32 * (t26 * t26));
        let d_L_o_hat_1_d_T = -(u44 * t83);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t84 = u41 * t26;
        let d_L_o_hat_1_d_theta = t79 * t84;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t11 * t84);
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t85 = u47 * (arc * t27) + u48 * (arc * t28);
        let t86 = u47 * (arc * (v_r * p)) - u25 * t48 * t85;
        let t87 = u48 * (arc * (v_t * p));
        let t88 = u47 * (arc * (f_r * p)) + t46 * t86 + t87 * t53;
        let t89 = u48 * (arc * (f_t * p)) + t59 * t86 + t87 * t60;
        let d_W_hat_1_d_T = t35 * t88 + t57 * t89;
        at.write_dy(21, d_W_hat_1_d_T);
        let t90 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t88 + t79 * t90 - v_r * t89;
        at.write_dy(22, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = u14 * t7 * t85 - t11 * t90 + omega * t89;
        at.write_dy(23, d_W_hat_1_d_x);
        let t91 = r * cos_t29;
        let t92 = t81 * t91;
        let d_A_x_hat_1_d_theta = t79 * t92;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t91 * t82 - A_hat_1 * cos_t29 - t11 * t92;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t93 = r * sin_t29;
        let t94 = t81 * t93;
        let d_A_y_hat_1_d_theta = t79 * t94;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t93 * t82 - A_hat_1 * sin_t29 - t11 * t94;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t95 = V_T * stored;
        let t96 = t95 * t61;
        let d_E_hat_1_d_T = t95 * t56 + t57 * t96;
        at.write_dy(28, d_E_hat_1_d_T);
        let t97 = u51 * (t16 * (t33 * (t14 * (t32 * t32))));
        let d_E_hat_1_d_theta = t95 * t63 - t79 * t97 - v_r * t96;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t98 = t16 * (t32 * t33);
        let d_E_hat_1_d_theta1 = u59 * t98 - u63 * (t15 * stored);
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u64 * (t14 * stored));
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_E_hat_1_d_x = t11 * t97 - u50 * (x * t16) + t95 * t65 + omega * t96;
        at.write_dy(32, d_E_hat_1_d_x);
        let d_T_hat_1_d_Phi = t16 + u56 * (theta2 * t14) + u58 * (theta1 * t15);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t99 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t99 * t61);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t100 = u27 * (u6 * t1 + u33 * t1);
        let t101 = sin_theta * t100;
        let t102 = t101 * t55;
        let t103 = cos_theta * t100;
        let d_T_hat_1_d_flow = t102 + t103 * t61;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u39 * theta_3 - u22 * (u3 * theta1 * t73);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(t99 * t70);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t101 * t69 + t103 * t70;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t23;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t99 * t78);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t101 * t77 + t103 * t78;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u27 * ((u30 * t25 + u31) * (u43 * t83)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t99 * t89);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t101 * t88 + t103 * t89;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t104 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t91 - sin_t29 * t104;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t29 * t104 + d_A_hat_1_d_Phi * t93;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t95 * d_T_hat_1_d_Phi - u60 * (theta1 * t98);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t99 * t96);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u45 * t34 + t95 * t102 + t103 * t96;
        at.write_dc(20, d_E_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (245 add, 554 mul, 7 div, 2 sqrt, 3 fn; once 151)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 33;
    const DC: usize = 81;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 102];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let sigma = constants[1];
        let EA = constants[3];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let omega_P = constants[12];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let u2 = reciprocal(Phi);
        let u3 = u2 * u2;
        let R_P = constants[8];
        let flow = constants[2];
        let u4 = flow * m_o;
        let u5 = R_P * u4;
        let G = omega_P * u5;
        let u6 = G * G;
        let u7 = EA * m_o;
        let u8 = reciprocal(u7 - u6);
        let u9 = EA * u8;
        let V_T = G * u8;
        let omega = sigma * omega_P;
        let u10 = sin_beta * sin_beta;
        let u11 = reciprocal(cos_beta);
        let u12 = u11 * u11;
        let u13 = u10 * u12;
        let v_thr = constants[11];
        let u14 = reciprocal(v_thr);
        let u15 = u14 * 4.0;
        let u16 = sin_beta * u11;
        let k = constants[5];
        let u17 = k * 0.5;
        let u18 = reciprocal(R);
        let u19 = u18 * u18;
        let u20 = u18 * u19;
        let u21 = R * u3;
        let EI = constants[4];
        let u22 = EI * u20;
        let u23 = reciprocal(EI);
        let u24 = u23 * (R * (R * R));
        let u25 = Phi * Phi;
        let u26 = Phi * u25;
        let u27 = reciprocal(EA);
        let u28 = 2.0 * u12;
        let u29 = u11 * (k * sin_beta);
        let u30 = 0.5 * u29;
        let u31 = EI * EI;
        let u32 = u31 * (0.5 * u23);
        let u33 = omega_P * u4;
        let u34 = omega_P * (m_o * R_P);
        let u35 = omega_P * (flow * R_P);
        let u36 = u8 * u8;
        let u37 = u7 * u36;
        let u38 = G * (EA * 2.0);
        let u39 = u36 * u38;
        let u40 = u8 * u38;
        let u41 = EA * EA;
        let u42 = u36 * u41;
        let u43 = u36 * (m_o * G);
        let u44 = u36 * (2.0 * u6);
        let u45 = u36 * (EA * G);
        let u46 = u11 * (2.0 * sin_beta);
        let u47 = u11 * u12;
        let u48 = u47 * (2.0 * (sin_beta * u10));
        let u49 = 0.5 * (u12 * (2.0 * u10));
        let u50 = 2.0 * u17;
        let u51 = u18 * u20 * (EI * 3.0);
        let u52 = 2.0 * u22;
        let u53 = u24 * u24;
        let u54 = Phi * u22;
        let u55 = u25 * 3.0;
        let u56 = u27 * u27;
        let u57 = Phi * u17;
        let u58 = Phi * EA;
        let u59 = u31 * (0.5 * (u23 * u23));
        let u60 = EI * u23;
        let u61 = 0.5 * (u12 * (k * u10));
        let u62 = Phi * V_T;
        let u63 = mu_k * 4.0;
        let u64 = u14 * u14 * u63;
        let u65 = u14 * u63;
        let u66 = Phi * u27;
        let u67 = Phi * 0.5;
        let u68 = Phi * 2.0;
        let u69 = u7 * u8 * u66;
        let u70 = Phi * (u47 * (sin_beta * 4.0));
        let u71 = Phi * u28;
        let u72 = Phi * cos_beta;
        let u73 = u22 * u24;
        let u74 = u20 * u24;
        let u75 = u2 * u54;
        let u76 = u3 * u54;
        let u77 = EI * u19;
        let u78 = Phi * (u3 * u77);
        let u79 = Phi * (2.0 * (u2 * u3) * u77);
        let u80 = Phi * u20;
        let u81 = EI * u60;
        let u82 = u62 * (u2 * u81);
        let u83 = u29 * u62;
        let u84 = u62 * (u3 * u81);
        let u85 = u16 * 0.5 * u62;
        let u86 = u62 * u81;
        let u87 = u2 * u26;
        let u88 = u26 * (u24 * (cos_beta * 2.0));
        let u89 = u26 * (2.0 * u24);
        let u90 = V_T * u71;
        let u91 = Phi * u50;
        let u92 = 2.0 * u30;
        let u93 = Phi * u92;
        let u94 = u26 * u50;
        let u95 = u26 * u92;
        let u96 = V_T * u75;
        let u97 = V_T * u78;
        let u98 = V_T * u80;
        let u99 = V_T * u68;
        let u100 = u8 + u44;
        let u101 = u34 * u100;
        let u102 = u35 * u100;
        let u103 = u33 * u100;
        let u104 = u5 * u100;
        let u105 = omega * u68;
        let u106 = omega_P * u68;
        let u107 = u34 * u68;
        let u108 = u33 * u68;
        let u109 = omega * u93;
        let u110 = omega * u26;
        let u111 = Phi * omega;
        let u112 = omega * u99;
        [
            Phi,
            sigma,
            EA,
            m_o,
            R,
            mu_k,
            omega_P,
            cos_beta,
            u2,
            u3,
            u5,
            u6,
            u8,
            u9,
            V_T,
            omega,
            sin_beta,
            u13,
            u15,
            u16,
            u17,
            u20,
            u21,
            u22,
            u24,
            u26,
            u27,
            u28,
            u30,
            u32,
            u33,
            u34,
            u35,
            u37,
            u39,
            u40,
            u41,
            u42,
            u43,
            u44,
            u45,
            u46,
            u48,
            u49,
            u50,
            u51,
            u52,
            u53,
            u54,
            u55,
            u56,
            u57,
            u58,
            u59,
            u60,
            u61,
            u62,
            u64,
            u65,
            u66,
            u67,
            u68,
            u69,
            u70,
            u71,
            u72,
            u73,
            u74,
            u75,
            u76,
            u78,
            u79,
            u80,
            u82,
            u83,
            u84,
            u85,
            u86,
            u87,
            u88,
            u89,
            u90,
            u91,
            u93,
            u94,
            u95,
            u96,
            u97,
            u98,
            u99,
            u101,
            u102,
            u103,
            u104,
            u105,
            u106,
            u107,
            u108,
            u109,
            u110,
            u111,
            u112,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let sigma = Real::splat(uniforms[1]);
        let EA = Real::splat(uniforms[2]);
        let m_o = Real::splat(uniforms[3]);
        let R = Real::splat(uniforms[4]);
        let mu_k = Real::splat(uniforms[5]);
        let omega_P = Real::splat(uniforms[6]);
        let cos_beta = Real::splat(uniforms[7]);
        let u2 = Real::splat(uniforms[8]);
        let u3 = Real::splat(uniforms[9]);
        let u5 = Real::splat(uniforms[10]);
        let u6 = Real::splat(uniforms[11]);
        let u8 = Real::splat(uniforms[12]);
        let u9 = Real::splat(uniforms[13]);
        let V_T = Real::splat(uniforms[14]);
        let omega = Real::splat(uniforms[15]);
        let sin_beta = Real::splat(uniforms[16]);
        let u13 = Real::splat(uniforms[17]);
        let u15 = Real::splat(uniforms[18]);
        let u16 = Real::splat(uniforms[19]);
        let u17 = Real::splat(uniforms[20]);
        let u20 = Real::splat(uniforms[21]);
        let u21 = Real::splat(uniforms[22]);
        let u22 = Real::splat(uniforms[23]);
        let u24 = Real::splat(uniforms[24]);
        let u26 = Real::splat(uniforms[25]);
        let u27 = Real::splat(uniforms[26]);
        let u28 = Real::splat(uniforms[27]);
        let u30 = Real::splat(uniforms[28]);
        let u32 = Real::splat(uniforms[29]);
        let u33 = Real::splat(uniforms[30]);
        let u34 = Real::splat(uniforms[31]);
        let u35 = Real::splat(uniforms[32]);
        let u37 = Real::splat(uniforms[33]);
        let u39 = Real::splat(uniforms[34]);
        let u40 = Real::splat(uniforms[35]);
        let u41 = Real::splat(uniforms[36]);
        let u42 = Real::splat(uniforms[37]);
        let u43 = Real::splat(uniforms[38]);
        let u44 = Real::splat(uniforms[39]);
        let u45 = Real::splat(uniforms[40]);
        let u46 = Real::splat(uniforms[41]);
        let u48 = Real::splat(uniforms[42]);
        let u49 = Real::splat(uniforms[43]);
        let u50 = Real::splat(uniforms[44]);
        let u51 = Real::splat(uniforms[45]);
        let u52 = Real::splat(uniforms[46]);
        let u53 = Real::splat(uniforms[47]);
        let u54 = Real::splat(uniforms[48]);
        let u55 = Real::splat(uniforms[49]);
        let u56 = Real::splat(uniforms[50]);
        let u57 = Real::splat(uniforms[51]);
        let u58 = Real::splat(uniforms[52]);
        let u59 = Real::splat(uniforms[53]);
        let u60 = Real::splat(uniforms[54]);
        let u61 = Real::splat(uniforms[55]);
        let u62 = Real::splat(uniforms[56]);
        let u64 = Real::splat(uniforms[57]);
        let u65 = Real::splat(uniforms[58]);
        let u66 = Real::splat(uniforms[59]);
        let u67 = Real::splat(uniforms[60]);
        let u68 = Real::splat(uniforms[61]);
        let u69 = Real::splat(uniforms[62]);
        let u70 = Real::splat(uniforms[63]);
        let u71 = Real::splat(uniforms[64]);
        let u72 = Real::splat(uniforms[65]);
        let u73 = Real::splat(uniforms[66]);
        let u74 = Real::splat(uniforms[67]);
        let u75 = Real::splat(uniforms[68]);
        let u76 = Real::splat(uniforms[69]);
        let u78 = Real::splat(uniforms[70]);
        let u79 = Real::splat(uniforms[71]);
        let u80 = Real::splat(uniforms[72]);
        let u82 = Real::splat(uniforms[73]);
        let u83 = Real::splat(uniforms[74]);
        let u84 = Real::splat(uniforms[75]);
        let u85 = Real::splat(uniforms[76]);
        let u86 = Real::splat(uniforms[77]);
        let u87 = Real::splat(uniforms[78]);
        let u88 = Real::splat(uniforms[79]);
        let u89 = Real::splat(uniforms[80]);
        let u90 = Real::splat(uniforms[81]);
        let u91 = Real::splat(uniforms[82]);
        let u93 = Real::splat(uniforms[83]);
        let u94 = Real::splat(uniforms[84]);
        let u95 = Real::splat(uniforms[85]);
        let u96 = Real::splat(uniforms[86]);
        let u97 = Real::splat(uniforms[87]);
        let u98 = Real::splat(uniforms[88]);
        let u99 = Real::splat(uniforms[89]);
        let u101 = Real::splat(uniforms[90]);
        let u102 = Real::splat(uniforms[91]);
        let u103 = Real::splat(uniforms[92]);
        let u104 = Real::splat(uniforms[93]);
        let u105 = Real::splat(uniforms[94]);
        let u106 = Real::splat(uniforms[95]);
        let u107 = Real::splat(uniforms[96]);
        let u108 = Real::splat(uniforms[97]);
        let u109 = Real::splat(uniforms[98]);
        let u110 = Real::splat(uniforms[99]);
        let u111 = Real::splat(uniforms[100]);
        let u112 = Real::splat(uniforms[101]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let T = at.state::<Real>(0);
        let t1 = T + EA;
        let V = V_T * t1;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t3 = v_r * v_r;
        let t4 = cos_theta * V;
        let v_t = t4 - omega * r;
        let speed = sqrt(v_t * v_t + (Real::splat(0.000000000000000000000001) + t3));
        let face_speed = sqrt(u13 * t3 + speed * speed);
        let t5 = reciprocal(face_speed);
        let saturation = tanh(u15 * speed);
        let mu = mu_k * saturation;
        let t6 = v_r * mu;
        let f_r = t5 * t6;
        let t7 = reciprocal(cos_beta + u16 * f_r);
        let t8 = x * t7;
        let p = u17 * t8;
        let t9 = r * p;
        let q = Real::splat(2.0) * t9;
        let t10 = v_t * mu;
        let f_t = t5 * t10;
        let t11 = reciprocal(cos_theta);
        let tan_theta = t11 * sin_theta;
        let t12 = f_r - sin_beta;
        let t13 = f_t + tan_theta * t12;
        let t = q * t13;
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t14 = theta_1 - Real::splat(1.0);
        let theta2 = at.state::<Real>(3);
        let t15 = u21 * theta2 + R * tan_theta - x * tan_theta;
        let t16 = t - t14 * (u22 * t15);
        let T_hat_1 = Phi * t16;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t17 = R + Real::splat(2.0) * x;
        let t18 = reciprocal(t17);
        let t19 = u24 * t18;
        let t20 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t20;
        let t21 = tan_theta * tan_theta;
        let t22 = theta_1 * t21 + (theta_1 + t21);
        let t23 = r * t22;
        let t24 = n + T * theta_1 - u22 * t23 - T;
        let theta_3 = t19 * t24;
        let theta_hat_3 = u26 * theta_3;
        at.write_f(3, theta_hat_3);
        let t25 = r * tan_theta;
        let x_hat_1 = -(Phi * t25);
        at.write_f(4, x_hat_1);
        let arc = r * t11;
        let t26 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t26;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u17 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t27 = u6 + m_o * T;
        let F = u9 * t27;
        let t28 = EA + F;
        let t29 = reciprocal(t28);
        let d_L_o_hat_1_d_Phi = arc * (EA * t29);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t30 = v_r * f_r;
        let t31 = p * t30;
        let loss_radial = u28 * t31;
        let t32 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t32);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t33 = Phi * s;
        let (sin_t33, cos_t33) = sin_cos(t33);
        let t35 = r * A_hat_1;
        let A_x_hat_1 = cos_t33 * t35;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t35 * sin_t33;
        at.write_f(10, A_y_hat_1);
        let t36 = reciprocal(arc);
        let t37 = t36 * t14;
        let t38 = t37 * t37;
        let t39 = x * x;
        let stored = u32 * t38 - u30 * t39;
        let t40 = T_hat_1 * stored;
        let E_hat_1 = V_T * t40;
        at.write_f(11, E_hat_1);
        let t41 = tan_theta * q;
        let t42 = x * (t7 * t7);
        let t43 = r * t42;
        let t44 = Phi * t41 - u93 * (t13 * t43);
        let t45 = V_T * sin_theta;
        let t46 = mu * t5;
        let t47 = t5 * t5;
        let t48 = t6 * t47;
        let t49 = v_r * t5;
        let t50 = reciprocal(speed);
        let t51 = v_r * t50;
        let t52 = speed * t5;
        let t53 = u49 * t49 + t51 * t52;
        let t54 = Real::splat(1.0) - saturation * saturation;
        let t55 = u65 * t54;
        let t56 = t51 * t55;
        let t57 = t46 - t48 * t53 + t49 * t56;
        let t58 = V_T * cos_theta;
        let t59 = v_t * t50;
        let t60 = t59 * t55;
        let t61 = t59 * t52;
        let t62 = t49 * t60 - t48 * t61;
        let t63 = t45 * t57 + t58 * t62;
        let t64 = u68 * t9;
        let t65 = v_t * t5;
        let t66 = t10 * t47;
        let t67 = t65 * t56 - t66 * t53;
        let t68 = t46 - t66 * t61 + t65 * t60;
        let t69 = t45 * t67 + t58 * t68;
        let d_T_hat_1_d_T = t44 * t63 + t64 * t69;
        at.write_dy(0, d_T_hat_1_d_T);
        let t70 = Real::splat(1.0) + t21;
        let t71 = Phi * t14;
        let t72 = Phi * (t70 * (q * t12)) - t71 * (t70 * (u22 * r));
        let t73 = t4 * t57 - v_r * t62;
        let t74 = t4 * t67 - v_r * t68;
        let d_T_hat_1_d_theta = t72 + t44 * t73 + t64 * t74;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u75 * t15);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = -(u78 * t14);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t75 = Phi * t13;
        let t76 = u50 * (r * t7) - u50 * t8;
        let t77 = u54 * (tan_theta * t14) + t75 * t76;
        let t78 = omega * t62;
        let t79 = t44 * t78;
        let t80 = u105 * (t9 * t68);
        let d_T_hat_1_d_x = t77 + t79 + t80;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t81 = t9 * t18;
        let t82 = t20 * t19;
        let t83 = u89 * t81 + u95 * (t82 * t43);
        let t84 = t19 * t41;
        let t85 = u26 * t84;
        let d_theta_hat_3_d_T = u26 * (t14 * t19) - t83 * t63 + t85 * t69;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t86 = f_t * q;
        let t87 = t19 * (t70 * t86)
            - t19
                * (t70
                    * (u22
                        * (r
                            * (Real::splat(2.0) * (theta_1 * tan_theta)
                                + Real::splat(2.0) * tan_theta))));
        let d_theta_hat_3_d_theta = u26 * t87 - t83 * t73 + t85 * t74;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t88 = T * t19 - u73 * (t18 * (r * t70));
        let d_theta_hat_3_d_theta1 = u87 * t88;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t89 = t24 * (u53 * (t18 * t18));
        let t90 = u26 * t82;
        let t91 = t83 * t78;
        let t92 = u110 * (t84 * t68);
        let d_theta_hat_3_d_x = u26 * (u73 * (t22 * t18) - u52 * t89) + t76 * t90 - t91
            + t92;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t70 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let t93 = arc * q;
        let t94 = Phi * t93;
        let t95 = t26 * t43;
        let t96 = u93 * t95;
        let d_M_hat_1_d_T = t94 * t69 - t96 * t63;
        at.write_dy(13, d_M_hat_1_d_T);
        let t97 = t11 * t11 * (r * sin_theta);
        let t98 = Phi * t86;
        let d_M_hat_1_d_theta = t97 * t98 - t96 * t73 + t94 * t74;
        at.write_dy(14, d_M_hat_1_d_theta);
        let t99 = Phi * t26;
        let t100 = t11 * t98;
        let t101 = u109 * (t62 * t95);
        let t102 = u111 * (t93 * t68);
        let d_M_hat_1_d_x = t99 * t76 - t100 - t101 + t102;
        at.write_dy(15, d_M_hat_1_d_x);
        let t103 = u57 * x;
        let d_A_hat_1_d_theta = t97 * t103;
        at.write_dy(16, d_A_hat_1_d_theta);
        let t104 = u57 * arc;
        let d_A_hat_1_d_R = t11 * t103;
        let d_A_hat_1_d_x = t104 - d_A_hat_1_d_R;
        at.write_dy(17, d_A_hat_1_d_x);
        let t105 = arc * (u41 * (t29 * t29));
        let d_L_o_hat_1_d_T = -(u69 * t105);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t106 = u58 * t29;
        let d_L_o_hat_1_d_theta = t97 * t106;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t11 * t106;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t107 = arc * (f_r * p);
        let t108 = arc * (f_t * p);
        let t109 = u68 * (arc * t32) + u71 * (arc * t30);
        let t110 = u71 * (arc * (v_r * p)) - u30 * t42 * t109;
        let t111 = arc * (v_t * p);
        let t112 = u68 * t111;
        let d_W_hat_1_d_T = u90 * (sin_theta * t107) + u99 * (cos_theta * t108)
            + t110 * t63 + t112 * t69;
        at.write_dy(21, d_W_hat_1_d_T);
        let t113 = u71 * t107;
        let t114 = Phi * loss;
        let t115 = u68 * t108;
        let d_W_hat_1_d_theta = t4 * t113 + t97 * t114 - v_r * t115 + t110 * t73
            + t112 * t74;
        at.write_dy(22, d_W_hat_1_d_theta);
        let t116 = t11 * t114;
        let t117 = u105 * t108;
        let t118 = t110 * t78;
        let t119 = u105 * (t111 * t68);
        let d_W_hat_1_d_x = u17 * t7 * t109 - t116 + t117 + t118 + t119;
        at.write_dy(23, d_W_hat_1_d_x);
        let t120 = r * cos_t33;
        let t121 = t103 * t120;
        let d_A_x_hat_1_d_theta = t97 * t121;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let t122 = A_hat_1 * cos_t33;
        let t123 = t11 * t121;
        let d_A_x_hat_1_d_x = t120 * t104 - t122 - t123;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t124 = r * sin_t33;
        let t125 = t103 * t124;
        let d_A_y_hat_1_d_theta = t97 * t125;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let t126 = A_hat_1 * sin_t33;
        let t127 = t11 * t125;
        let d_A_y_hat_1_d_x = t124 * t104 - t126 - t127;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t128 = V_T * stored;
        let t129 = t128 * t44;
        let t130 = t9 * stored;
        let t131 = u99 * t130;
        let d_E_hat_1_d_T = t129 * t63 + t131 * t69;
        at.write_dy(28, d_E_hat_1_d_T);
        let t132 = u86 * (t16 * (t37 * (t14 * (t36 * t36))));
        let d_E_hat_1_d_theta = t128 * t72 - t97 * t132 + t129 * t73 + t131 * t74;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t133 = t36 * t37;
        let d_E_hat_1_d_theta1 = u82 * (t16 * t133) - u96 * (t15 * stored);
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u97 * (t14 * stored));
        at.write_dy(31, d_E_hat_1_d_theta2);
        let t134 = t11 * t132;
        let t135 = t129 * t78;
        let t136 = u112 * (t68 * t130);
        let d_E_hat_1_d_x = t134 - u83 * (x * t16) + t128 * t77 + t135 + t136;
        at.write_dy(32, d_E_hat_1_d_x);
        let d_T_hat_1_d_Phi = t16 + u76 * (theta1 * t15) + u79 * (theta2 * t14);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t137 = omega_P * r;
        let t138 = t137 * t62;
        let t139 = t137 * t68;
        let d_T_hat_1_d_sigma = -(t44 * t138 + t64 * t139);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t140 = u8 * t1 + u44 * t1;
        let t141 = sin_theta * t140;
        let t142 = t141 * t57;
        let t143 = cos_theta * t140;
        let t144 = u34 * t143;
        let t145 = u34 * t142 + t62 * t144;
        let t146 = t141 * t67;
        let t147 = u34 * t146 + t68 * t144;
        let d_T_hat_1_d_flow = t44 * t145 + t64 * t147;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u55 * theta_3 - u26 * (u3 * theta1 * t88);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = t83 * t138 - t85 * t139;
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t85 * t147 - t83 * t145;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t25;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = t96 * t138 - t94 * t139;
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t94 * t147 - t96 * t145;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t148 = u66 * t105;
        let t149 = (u39 * t27 + u40) * t148;
        let d_L_o_hat_1_d_flow = -(u34 * t149);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(u106 * (r * t108) + t110 * t138 + t112 * t139);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let t150 = t113 * t141;
        let t151 = t108 * t143;
        let d_W_hat_1_d_flow = u34 * t150 + u107 * t151 + t110 * t145 + t112 * t147;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t152 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t120 - sin_t33 * t152;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t33 * t152 + d_A_hat_1_d_Phi * t124;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t128 * d_T_hat_1_d_Phi - u84 * (t16 * (theta1 * t133));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t129 * t138 + t131 * t139);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u101 * t40 + t129 * t145 + t131 * t147;
        at.write_dc(20, d_E_hat_1_d_flow);
        let t153 = V_T - u43 * t1;
        let t154 = sin_theta * t153;
        let t155 = cos_theta * t153;
        let t156 = t154 * t57 + t155 * t62;
        let t157 = t154 * t67 + t155 * t68;
        let d_T_hat_1_d_EA = t44 * t156 + t64 * t157;
        at.write_dc(21, d_T_hat_1_d_EA);
        let t158 = t14 * t15;
        let d_T_hat_1_d_EI = -(u80 * t158);
        at.write_dc(22, d_T_hat_1_d_EI);
        let t159 = r * t8;
        let d_T_hat_1_d_k = t75 * t159;
        at.write_dc(23, d_T_hat_1_d_k);
        let t160 = u45 * t1;
        let t161 = sin_theta * t160;
        let t162 = u35 * t143 - cos_theta * t160;
        let t163 = u35 * t142 - t161 * t57 + t62 * t162;
        let t164 = u35 * t146 - t161 * t67 + t68 * t162;
        let d_T_hat_1_d_m_o = t44 * t163 + t64 * t164;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let theta_2 = u3 * theta2;
        let t165 = (u51 * t15 - u22 * (theta_2 + tan_theta)) * t71 + u91 * (t8 * t13);
        let d_T_hat_1_d_R = t165 - t79 - t80;
        at.write_dc(25, d_T_hat_1_d_R);
        let t166 = u33 * t143;
        let t167 = u33 * t142 + t62 * t166;
        let t168 = u33 * t146 + t68 * t166;
        let d_T_hat_1_d_R_P = t44 * t167 + t64 * t168;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t169 = (t12 + u13 * f_r) * t42;
        let t170 = r * t169;
        let t171 = u72 * t41 + u91 * (t13 * t170);
        let t172 = Real::splat(0.5) * t5 * (u46 * t3 + u48 * t3);
        let t173 = t172 * t48;
        let t174 = t172 * t66;
        let d_T_hat_1_d_beta = -(t171 + t173 * t44 + t64 * t174);
        at.write_dc(27, d_T_hat_1_d_beta);
        let t175 = saturation * t49;
        let t176 = saturation * t65;
        let d_T_hat_1_d_mu_k = t175 * t44 + t64 * t176;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let t177 = u64 * (speed * t54);
        let t178 = t49 * t177;
        let t179 = t65 * t177;
        let d_T_hat_1_d_v_thr = -(t178 * t44 + t64 * t179);
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let t180 = u5 * t143 - sigma * r;
        let t181 = u5 * t142 + t62 * t180;
        let t182 = u5 * t146 + t68 * t180;
        let d_T_hat_1_d_omega_P = t44 * t181 + t64 * t182;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t85 * t157 - t83 * t156;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(u26 * (u20 * t17 * t89 + u74 * (t23 * t18)));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let d_theta_hat_3_d_k = t159 * t90;
        at.write_dc(33, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = t85 * t164 - t83 * t163;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let t183 = u26 * ((u51 * t17 - u22) * t89 + t19 * (u51 * t23 - u22 * t22));
        let d_theta_hat_3_d_R = t183 + u94 * (t8 * t82) + t91 - t92;
        at.write_dc(35, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = t85 * t168 - t83 * t167;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_beta = u88 * t81 - u94 * (t82 * t170) + t173 * t83
            - t174 * t85;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = t176 * t85 - t175 * t83;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = t178 * t83 - t179 * t85;
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = t85 * t182 - t83 * t181;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t94 * t157 - t96 * t156;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = t99 * t159;
        at.write_dc(43, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = t94 * t164 - t96 * t163;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = u91 * (t8 * t26) + t100 + t101 - t102;
        at.write_dc(45, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = t94 * t168 - t96 * t167;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t173 * t96 - u91 * (t26 * t170) - t94 * t174;
        at.write_dc(47, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = t94 * t176 - t175 * t96;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = t178 * t96 - t94 * t179;
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = t94 * t182 - t96 * t181;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = u67 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        at.write_dc(52, d_A_hat_1_d_R);
        let t184 = (u27 - u56 * t28) * (Phi * t105) + (u8 * t27 - u37 * t27) * t148;
        let d_L_o_hat_1_d_EA = -t184;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u42 * t27) * t148 + u35 * t149);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u33 * t149);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t149);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t113 * t154 + t115 * t155 + t110 * t156 + t112 * t157;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = Real::splat(0.5) * t8 * t109;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = u35 * t150 - t113 * t161 + t115 * t162 + t110 * t163
            + t112 * t164;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t116 - t117 - t118 - t119;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = u33 * t150 + u108 * t151 + t110 * t167 + t112 * t168;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = u70 * (arc * t31) - u17 * t169 * t109 - t173 * t110
            - t112 * t174;
        at.write_dc(63, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = t175 * t110 + t112 * t176;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t178 * t110 + t112 * t179);
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = u5 * t150 + t115 * t180 + t110 * t181 + t112 * t182;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let d_A_x_hat_1_d_k = t120 * d_A_hat_1_d_k;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t122 + t123;
        at.write_dc(68, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t124 * d_A_hat_1_d_k;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t126 + t127;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_E_hat_1_d_EA = t129 * t156 - u43 * t40 + t131 * t157;
        at.write_dc(71, d_E_hat_1_d_EA);
        let t185 = u62 * t16;
        let d_E_hat_1_d_EI = t185 * (t37 * (u60 * t37) - u59 * t38)
            - u98 * (stored * t158);
        at.write_dc(72, d_E_hat_1_d_EI);
        let d_E_hat_1_d_k = t128 * d_T_hat_1_d_k - u85 * (t16 * t39);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_E_hat_1_d_m_o = u102 * t40 - u45 * t40 + t129 * t163 + t131 * t164;
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R = t128 * t165 - t134 - t135 - t136;
        at.write_dc(75, d_E_hat_1_d_R);
        let d_E_hat_1_d_R_P = u103 * t40 + t129 * t167 + t131 * t168;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t186 = (u17 * t39 + u61 * t39) * t185 + t128 * t171 + t173 * t129
            + t174 * t131;
        let d_E_hat_1_d_beta = -t186;
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_mu_k = t175 * t129 + t176 * t131;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let d_E_hat_1_d_v_thr = -(t178 * t129 + t179 * t131);
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_omega_P = u104 * t40 + t129 * t181 + t131 * t182;
        at.write_dc(80, d_E_hat_1_d_omega_P);
    }
}
///Derived fields. (15 add, 37 mul, 4 div, 2 sqrt, 4 fn; once 27)
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    type Uniforms = [f64; 18];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[3];
        let EI = constants[4];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let Phi = constants[0];
        let u2 = reciprocal(Phi);
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u3 = G * G;
        let u4 = reciprocal(EA * m_o - u3);
        let u5 = EA * u4;
        let V_T = G * u4;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u6 = reciprocal(cos_beta);
        let u7 = u6 * u6;
        let u8 = sin_beta * sin_beta * u7;
        let v_thr = constants[11];
        let u9 = reciprocal(v_thr) * 4.0;
        let u10 = sin_beta * u6;
        let k = constants[5];
        let u11 = k * 0.5;
        let u12 = R * (u2 * u2);
        let u13 = reciprocal(R);
        let u14 = EI * (u13 * (u13 * u13));
        let u15 = 2.0 * u7;
        [
            EA,
            EI,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u3,
            u5,
            V_T,
            omega,
            u8,
            u9,
            u10,
            u11,
            u12,
            u14,
            u15,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let EI = Real::splat(uniforms[1]);
        let m_o = Real::splat(uniforms[2]);
        let R = Real::splat(uniforms[3]);
        let mu_k = Real::splat(uniforms[4]);
        let cos_beta = Real::splat(uniforms[5]);
        let u2 = Real::splat(uniforms[6]);
        let u3 = Real::splat(uniforms[7]);
        let u5 = Real::splat(uniforms[8]);
        let V_T = Real::splat(uniforms[9]);
        let omega = Real::splat(uniforms[10]);
        let u8 = Real::splat(uniforms[11]);
        let u9 = Real::splat(uniforms[12]);
        let u10 = Real::splat(uniforms[13]);
        let u11 = Real::splat(uniforms[14]);
        let u12 = Real::splat(uniforms[15]);
        let u14 = Real::splat(uniforms[16]);
        let u15 = Real::splat(uniforms[17]);
        let T = at.state::<Real>(0);
        let F = u5 * (u3 + m_o * T);
        at.write_field(0, F);
        let V = V_T * (T + EA);
        at.write_field(1, V);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        at.write_field(2, v_r);
        let x = at.state::<Real>(4);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        at.write_field(3, v_t);
        let t2 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(0.000000000000000000000001) + t2));
        at.write_field(4, speed);
        let gamma_a = angle(v_r, v_t);
        let gamma = turn(gamma_a);
        at.write_field(5, gamma);
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let face_speed = sqrt(u8 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let f_r = t3 * (v_r * mu);
        let p = u11 * (x * reciprocal(cos_beta + u10 * f_r));
        at.write_field(7, p);
        let beta_s = angle(speed, u10 * v_r);
        at.write_field(8, beta_s);
        let theta2 = at.state::<Real>(3);
        let t4 = reciprocal(cos_theta);
        let tan_theta = t4 * sin_theta;
        let Q = -(u14 * (u12 * theta2 + R * tan_theta - x * tan_theta));
        at.write_field(9, Q);
        let arc = r * t4;
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (reciprocal(arc) * (theta_1 - Real::splat(1.0))));
        at.write_field(10, M_b);
        let axial = u11 * x;
        at.write_field(11, axial);
        let loss_radial = u15 * (p * (v_r * f_r));
        let f_t = t3 * (v_t * mu);
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        at.write_field(12, loss);
        at.write_field(13, loss_radial);
        at.write_field(14, loss_tangential);
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
