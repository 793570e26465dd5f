// contact_full_viscous_coulomb: The belt in a groove: full shear, viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p eqgen -- write` writes it anew.
// Operations per point, and once a batch:
//   value: 31 add, 87 mul, 6 div, 2 sqrt, 2 fn; once 31
//   jacobian: 133 add, 365 mul, 7 div, 2 sqrt, 2 fn; once 89
//   full: 260 add, 585 mul, 7 div, 2 sqrt, 2 fn; once 140
//   fields: 16 add, 40 mul, 4 div, 2 sqrt, 3 fn; once 21

///The belt in a groove: full shear, viscous-coulomb friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_full_viscous_coulomb",
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
        (3, 3),
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
///Right-hand side and integrands. (31 add, 87 mul, 6 div, 2 sqrt, 2 fn; once 31)
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 24];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let EA = constants[3];
        let EI = constants[4];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let u2 = reciprocal(Phi);
        let u3 = u2 * u2;
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u4 = G * G;
        let u5 = reciprocal(EA * m_o - u4);
        let u6 = EA * u5;
        let V_T = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u7 = reciprocal(cos_beta);
        let u8 = u7 * u7;
        let u9 = sin_beta * sin_beta * u8;
        let v_thr = constants[11];
        let u10 = reciprocal(v_thr);
        let u11 = sin_beta * u7;
        let k = constants[5];
        let u12 = k * 0.5;
        let u13 = u2 * u3;
        let u14 = reciprocal(EI);
        let u15 = Phi * (Phi * Phi);
        let u16 = 2.0 * u8;
        let u17 = 0.5 * (u7 * (k * sin_beta));
        let u18 = EI * EI * (0.5 * u14);
        [
            Phi,
            EA,
            EI,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u3,
            u4,
            u6,
            V_T,
            omega,
            sin_beta,
            u9,
            u10,
            u11,
            u12,
            u13,
            u14,
            u15,
            u16,
            u17,
            u18,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let EA = Real::splat(uniforms[1]);
        let EI = Real::splat(uniforms[2]);
        let m_o = Real::splat(uniforms[3]);
        let R = Real::splat(uniforms[4]);
        let mu_k = Real::splat(uniforms[5]);
        let cos_beta = Real::splat(uniforms[6]);
        let u2 = Real::splat(uniforms[7]);
        let u3 = Real::splat(uniforms[8]);
        let u4 = Real::splat(uniforms[9]);
        let u6 = Real::splat(uniforms[10]);
        let V_T = Real::splat(uniforms[11]);
        let omega = Real::splat(uniforms[12]);
        let sin_beta = Real::splat(uniforms[13]);
        let u9 = Real::splat(uniforms[14]);
        let u10 = Real::splat(uniforms[15]);
        let u11 = Real::splat(uniforms[16]);
        let u12 = Real::splat(uniforms[17]);
        let u13 = Real::splat(uniforms[18]);
        let u14 = Real::splat(uniforms[19]);
        let u15 = Real::splat(uniforms[20]);
        let u16 = Real::splat(uniforms[21]);
        let u17 = Real::splat(uniforms[22]);
        let u18 = Real::splat(uniforms[23]);
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
        let face_speed = sqrt(u9 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let slip = u10 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let f_r = t3 * (v_r * mu);
        let p = u12 * (x * reciprocal(cos_beta + u11 * f_r));
        let q = Real::splat(2.0) * (r * p);
        let f_t = t3 * (v_t * mu);
        let t4 = reciprocal(cos_theta);
        let tan_theta = t4 * sin_theta;
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t5 = theta_1 - Real::splat(1.0);
        let arc = r * t4;
        let t6 = reciprocal(arc);
        let t7 = t6 * t6;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t8 = theta1 * theta1;
        let t9 = u3 * t8;
        let T_hat_1 = Phi
            * (t - t5 * (EI * (t7 * (theta_2 + tan_theta - tan_theta * t9))));
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let t10 = tan_theta * tan_theta;
        let t11 = u13 * (theta1 * t8);
        let t12 = t10 * t11 + (theta_1 + Real::splat(2.0) * (t9 * t10))
            - Real::splat(4.0) * (tan_theta * (u13 * (theta1 * theta2)));
        let t13 = t7
            * (t12 - theta_1 * t10 - Real::splat(2.0) * (theta_2 * tan_theta) - t11
                - Real::splat(2.0) * t10);
        let theta_3 = u14 * reciprocal(t7) * (n + T * theta_1 - EI * t13 - T);
        let theta_hat_3 = u15 * theta_3;
        at.write_f(3, theta_hat_3);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(4, x_hat_1);
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(5, M_hat_1);
        let axial = u12 * x;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(6, A_hat_1);
        let F = u6 * (u4 + m_o * T);
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(7, L_o_hat_1);
        let loss_radial = u16 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t14 = Phi * s;
        let (sin_t14, cos_t14) = sin_cos(t14);
        let t16 = r * A_hat_1;
        let A_x_hat_1 = cos_t14 * t16;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t16 * sin_t14;
        at.write_f(10, A_y_hat_1);
        let t17 = t6 * t5;
        let stored = u18 * (t17 * t17) - u17 * (x * x);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and usual constants. (133 add, 365 mul, 7 div, 2 sqrt, 2 fn; once 89)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 34;
    const DC: usize = 21;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 68];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let EA = constants[3];
        let EI = constants[4];
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
        let u12 = reciprocal(v_thr);
        let u13 = sin_beta * u9;
        let k = constants[5];
        let u14 = k * 0.5;
        let u15 = u2 * u3;
        let u16 = reciprocal(EI);
        let u17 = Phi * Phi;
        let u18 = Phi * u17;
        let u19 = 2.0 * u10;
        let u20 = u9 * (k * sin_beta);
        let u21 = 0.5 * u20;
        let u22 = EI * EI * (0.5 * u16);
        let u23 = omega_P * (m_o * R_P);
        let u24 = u6 * u6;
        let u25 = G * (EA * 2.0);
        let u26 = u24 * u25;
        let u27 = u6 * u25;
        let u28 = EA * EA;
        let u29 = u24 * (2.0 * u4);
        let u30 = 0.5 * (u10 * (2.0 * u8));
        let u31 = 2.0 * u14;
        let u32 = EI * 2.0;
        let u33 = 4.0 * u15;
        let u34 = 2.0 * u3;
        let u35 = u3 * 3.0;
        let u36 = u16 * u16;
        let u37 = Phi * EI;
        let u38 = u17 * 3.0;
        let u39 = Phi * u14;
        let u40 = Phi * EA;
        let u41 = EI * u16;
        let u42 = mu_k * u12;
        let u43 = Phi * reciprocal(EA);
        let u44 = u5 * u6 * u43;
        let u45 = u23 * (u6 + u29);
        let u46 = Phi * u19;
        let u47 = Phi * 2.0;
        let u48 = Phi * V_T;
        let u49 = u20 * u48;
        let u50 = u48 * (EI * u41);
        let u51 = 2.0 * u21;
        let u52 = 2.0 * u16;
        let u53 = EI * u3;
        let u54 = Phi * u53;
        let u55 = EI * (2.0 * u15);
        let u56 = Phi * u55;
        let u57 = Phi * u32;
        let u58 = u16 * u55;
        let u59 = u16 * u32;
        let u60 = u2 * u50;
        let u61 = u3 * u50;
        let u62 = Phi * u51;
        let u63 = u2 * u18;
        let u64 = u18 * (u16 * u53);
        let u65 = V_T * u18;
        let u66 = u2 * V_T;
        let u67 = V_T * u54;
        let u68 = omega * u18;
        let u69 = omega_P * u18;
        [
            Phi,
            EA,
            EI,
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
            u16,
            u18,
            u19,
            u21,
            u22,
            u23,
            u26,
            u27,
            u28,
            u29,
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
            u49,
            u50,
            u51,
            u52,
            u54,
            u56,
            u57,
            u58,
            u59,
            u60,
            u61,
            u62,
            u63,
            u64,
            u65,
            u66,
            u67,
            u68,
            u69,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let EA = Real::splat(uniforms[1]);
        let EI = Real::splat(uniforms[2]);
        let m_o = Real::splat(uniforms[3]);
        let R = Real::splat(uniforms[4]);
        let mu_k = Real::splat(uniforms[5]);
        let omega_P = Real::splat(uniforms[6]);
        let cos_beta = Real::splat(uniforms[7]);
        let u2 = Real::splat(uniforms[8]);
        let u3 = Real::splat(uniforms[9]);
        let u4 = Real::splat(uniforms[10]);
        let u6 = Real::splat(uniforms[11]);
        let u7 = Real::splat(uniforms[12]);
        let V_T = Real::splat(uniforms[13]);
        let omega = Real::splat(uniforms[14]);
        let sin_beta = Real::splat(uniforms[15]);
        let u11 = Real::splat(uniforms[16]);
        let u12 = Real::splat(uniforms[17]);
        let u13 = Real::splat(uniforms[18]);
        let u14 = Real::splat(uniforms[19]);
        let u15 = Real::splat(uniforms[20]);
        let u16 = Real::splat(uniforms[21]);
        let u18 = Real::splat(uniforms[22]);
        let u19 = Real::splat(uniforms[23]);
        let u21 = Real::splat(uniforms[24]);
        let u22 = Real::splat(uniforms[25]);
        let u23 = Real::splat(uniforms[26]);
        let u26 = Real::splat(uniforms[27]);
        let u27 = Real::splat(uniforms[28]);
        let u28 = Real::splat(uniforms[29]);
        let u29 = Real::splat(uniforms[30]);
        let u30 = Real::splat(uniforms[31]);
        let u31 = Real::splat(uniforms[32]);
        let u32 = Real::splat(uniforms[33]);
        let u33 = Real::splat(uniforms[34]);
        let u34 = Real::splat(uniforms[35]);
        let u35 = Real::splat(uniforms[36]);
        let u36 = Real::splat(uniforms[37]);
        let u37 = Real::splat(uniforms[38]);
        let u38 = Real::splat(uniforms[39]);
        let u39 = Real::splat(uniforms[40]);
        let u40 = Real::splat(uniforms[41]);
        let u41 = Real::splat(uniforms[42]);
        let u42 = Real::splat(uniforms[43]);
        let u43 = Real::splat(uniforms[44]);
        let u44 = Real::splat(uniforms[45]);
        let u45 = Real::splat(uniforms[46]);
        let u46 = Real::splat(uniforms[47]);
        let u47 = Real::splat(uniforms[48]);
        let u49 = Real::splat(uniforms[49]);
        let u50 = Real::splat(uniforms[50]);
        let u51 = Real::splat(uniforms[51]);
        let u52 = Real::splat(uniforms[52]);
        let u54 = Real::splat(uniforms[53]);
        let u56 = Real::splat(uniforms[54]);
        let u57 = Real::splat(uniforms[55]);
        let u58 = Real::splat(uniforms[56]);
        let u59 = Real::splat(uniforms[57]);
        let u60 = Real::splat(uniforms[58]);
        let u61 = Real::splat(uniforms[59]);
        let u62 = Real::splat(uniforms[60]);
        let u63 = Real::splat(uniforms[61]);
        let u64 = Real::splat(uniforms[62]);
        let u65 = Real::splat(uniforms[63]);
        let u66 = Real::splat(uniforms[64]);
        let u67 = Real::splat(uniforms[65]);
        let u68 = Real::splat(uniforms[66]);
        let u69 = Real::splat(uniforms[67]);
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
        let slip = u12 * speed;
        let saturation = saturate(slip);
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
        let arc = r * t11;
        let t15 = reciprocal(arc);
        let t16 = t15 * t15;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t17 = theta1 * theta1;
        let t18 = u3 * t17;
        let t19 = tan_theta * t18;
        let t20 = theta_2 + tan_theta - t19;
        let t21 = t16 * t20;
        let t22 = t - t14 * (EI * t21);
        let T_hat_1 = Phi * t22;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t23 = reciprocal(t16);
        let t24 = u16 * t23;
        let t25 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t25;
        let t26 = tan_theta * tan_theta;
        let t27 = u15 * (theta1 * t17);
        let t28 = t18 * t26;
        let t29 = theta1 * theta2;
        let t30 = theta_1 * t26;
        let t31 = t26 * t27 + (theta_1 + Real::splat(2.0) * t28)
            - Real::splat(4.0) * (tan_theta * (u15 * t29)) - t30;
        let t32 = theta_2 * tan_theta;
        let t33 = t31 - Real::splat(2.0) * t32 - t27 - Real::splat(2.0) * t26;
        let t34 = n + T * theta_1 - EI * (t16 * t33) - T;
        let theta_3 = t24 * t34;
        let theta_hat_3 = u18 * theta_3;
        at.write_f(3, theta_hat_3);
        let t35 = r * tan_theta;
        let x_hat_1 = -(Phi * t35);
        at.write_f(4, x_hat_1);
        let t36 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t36;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u14 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t37 = u4 + m_o * T;
        let F = u7 * t37;
        let t38 = reciprocal(EA + F);
        let d_L_o_hat_1_d_Phi = arc * (EA * t38);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t39 = v_r * f_r;
        let loss_radial = u19 * (p * t39);
        let t40 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t40);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t41 = Phi * s;
        let (sin_t41, cos_t41) = sin_cos(t41);
        let t43 = r * A_hat_1;
        let A_x_hat_1 = cos_t41 * t43;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t43 * sin_t41;
        at.write_f(10, A_y_hat_1);
        let t44 = t15 * t14;
        let stored = u22 * (t44 * t44) - u21 * (x * x);
        let t45 = T_hat_1 * stored;
        let E_hat_1 = V_T * t45;
        at.write_f(11, E_hat_1);
        let t46 = V_T * sin_theta;
        let t47 = mu * t5;
        let t48 = v_r * t5;
        let t49 = u30 * t48;
        let t50 = t5 * t5;
        let t51 = t6 * t50;
        let t52 = reciprocal(speed);
        let t53 = v_r * t52;
        let t54 = u42 * below_one(slip);
        let t55 = speed * t5;
        let t56 = t48 * t54 - t55 * t51;
        let t57 = t47 - t49 * t51 + t53 * t56;
        let t58 = tan_theta * q;
        let t59 = x * (t7 * t7);
        let t60 = r * t59;
        let t61 = Phi * t58 - u62 * (t13 * t60);
        let t62 = t10 * t50;
        let t63 = v_t * t5 * t54 - t55 * t62;
        let t64 = t53 * t63 - t49 * t62;
        let t65 = u47 * t9;
        let t66 = t57 * t61 + t64 * t65;
        let t67 = t46 * t66;
        let t68 = V_T * cos_theta;
        let t69 = v_t * t52;
        let t70 = t69 * t56;
        let t71 = t47 + t69 * t63;
        let t72 = t70 * t61 + t71 * t65;
        let d_T_hat_1_d_T = t67 + t68 * t72;
        at.write_dy(0, d_T_hat_1_d_T);
        let t73 = Real::splat(1.0) + t26;
        let t74 = t73 * (Phi * (q * t12))
            - Phi * t14 * (t73 * (EI * (t16 * (Real::splat(1.0) - t18))));
        let t75 = t11 * t11 * (r * sin_theta);
        let t76 = t15 * t16;
        let t77 = u57 * (t14 * (t20 * t76));
        let t78 = t74 + t4 * t66 + t75 * t77;
        let d_T_hat_1_d_theta = t78 - v_r * t72;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t79 = theta_1 * tan_theta;
        let t80 = u57 * (t14 * (t16 * t79)) - u37 * t21;
        let d_T_hat_1_d_theta1 = u2 * t80;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let t81 = t14 * t16;
        let d_T_hat_1_d_theta2 = -(u54 * t81);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t82 = u31 * (r * t7) - u31 * t8;
        let t83 = t82 * (Phi * t13) - t11 * t77;
        let d_T_hat_1_d_x = t83 + omega * t72;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t84 = t24 * t58;
        let t85 = t25 * t24;
        let t86 = u52 * (t9 * t23) + u51 * t60 * t85;
        let t87 = t64 * t84 - t57 * t86;
        let t88 = t71 * t84 - t70 * t86;
        let d_theta_hat_3_d_T = u18 * (t14 * t24) + u65 * (sin_theta * t87)
            + u65 * (cos_theta * t88);
        at.write_dy(7, d_theta_hat_3_d_T);
        let t89 = f_t * q;
        let t90 = Real::splat(4.0) * t19 + Real::splat(2.0) * (tan_theta * t27)
            - u33 * t29 - Real::splat(2.0) * t79 - u34 * theta2;
        let t91 = t73 * (t24 * t89)
            - t24 * (t73 * (EI * (t16 * (t90 - Real::splat(4.0) * tan_theta))));
        let t92 = u18 * t87;
        let t93 = u32 * t76 * (t34 * (u36 * (t23 * t23))) + u59 * (t23 * (t33 * t76));
        let t94 = u18 * t93;
        let t95 = u18 * t88;
        let d_theta_hat_3_d_theta = u18 * t91 + t4 * t92 + t75 * t94 - v_r * t95;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t96 = Real::splat(3.0) * t28 + (Real::splat(1.0) + Real::splat(4.0) * t30)
            - Real::splat(4.0) * t32 - u35 * t17 - t26;
        let t97 = T * t24 - u41 * (t23 * (t16 * t96));
        let d_theta_hat_3_d_theta1 = u63 * t97;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t98 = t16 * (Real::splat(4.0) * t79 + Real::splat(2.0) * tan_theta);
        let d_theta_hat_3_d_theta2 = u64 * (t23 * t98);
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let d_theta_hat_3_d_x = u18 * (t82 * t85) - t11 * t94 + u68 * t88;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t73 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let t99 = Phi * (arc * q);
        let t100 = u62 * (t36 * t60);
        let t101 = t99 * t64 - t57 * t100;
        let t102 = t99 * t71 - t70 * t100;
        let d_M_hat_1_d_T = t46 * t101 + t68 * t102;
        at.write_dy(14, d_M_hat_1_d_T);
        let t103 = Phi * t89;
        let d_M_hat_1_d_theta = t4 * t101 + t75 * t103 - v_r * t102;
        at.write_dy(15, d_M_hat_1_d_theta);
        let d_M_hat_1_d_x = Phi * t36 * t82 - t11 * t103 + omega * t102;
        at.write_dy(16, d_M_hat_1_d_x);
        let t104 = u39 * x;
        let d_A_hat_1_d_theta = t75 * t104;
        at.write_dy(17, d_A_hat_1_d_theta);
        let t105 = u39 * arc;
        let d_A_hat_1_d_x = t105 - t11 * t104;
        at.write_dy(18, d_A_hat_1_d_x);
        let t106 = arc * (u28 * (t38 * t38));
        let d_L_o_hat_1_d_T = -(u44 * t106);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t107 = u40 * t38;
        let d_L_o_hat_1_d_theta = t75 * t107;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t11 * t107);
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t108 = u46 * (arc * t39) + u47 * (arc * t40);
        let t109 = u46 * (arc * (v_r * p)) - u21 * t59 * t108;
        let t110 = u47 * (arc * (v_t * p));
        let t111 = u46 * (arc * (f_r * p)) + t57 * t109 + t110 * t64;
        let t112 = u47 * (arc * (f_t * p)) + t70 * t109 + t110 * t71;
        let d_W_hat_1_d_T = t46 * t111 + t68 * t112;
        at.write_dy(22, d_W_hat_1_d_T);
        let t113 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t111 + t75 * t113 - v_r * t112;
        at.write_dy(23, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = u14 * t7 * t108 - t11 * t113 + omega * t112;
        at.write_dy(24, d_W_hat_1_d_x);
        let t114 = r * cos_t41;
        let t115 = t104 * t114;
        let d_A_x_hat_1_d_theta = t75 * t115;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t114 * t105 - A_hat_1 * cos_t41 - t11 * t115;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t116 = r * sin_t41;
        let t117 = t104 * t116;
        let d_A_y_hat_1_d_theta = t75 * t117;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t116 * t105 - A_hat_1 * sin_t41 - t11 * t117;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t118 = V_T * stored;
        let t119 = t118 * t72;
        let d_E_hat_1_d_T = t118 * t67 + t68 * t119;
        at.write_dy(29, d_E_hat_1_d_T);
        let t120 = u50 * (t22 * (t44 * t81));
        let d_E_hat_1_d_theta = t118 * t78 - t75 * t120 - v_r * t119;
        at.write_dy(30, d_E_hat_1_d_theta);
        let t121 = t22 * (t15 * t44);
        let d_E_hat_1_d_theta1 = u60 * t121 + u66 * (stored * t80);
        at.write_dy(31, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u67 * (stored * t81));
        at.write_dy(32, d_E_hat_1_d_theta2);
        let d_E_hat_1_d_x = t11 * t120 - u49 * (x * t22) + t118 * t83 + omega * t119;
        at.write_dy(33, d_E_hat_1_d_x);
        let t122 = u3 * theta1;
        let d_T_hat_1_d_Phi = t22 + u56 * (t14 * (theta2 * t16)) - t122 * t80;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t123 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t123 * t72);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t124 = u23 * (u6 * t1 + u29 * t1);
        let t125 = sin_theta * t124;
        let t126 = t125 * t66;
        let t127 = cos_theta * t124;
        let d_T_hat_1_d_flow = t126 + t127 * t72;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u38 * theta_3
            - u18 * (u58 * (t23 * (theta2 * t98)) + t122 * t97);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(u69 * (r * t88));
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t125 * t92 + t127 * t95;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t35;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t123 * t102);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t125 * t101 + t127 * t102;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u23 * ((u26 * t37 + u27) * (u43 * t106)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t123 * t112);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t125 * t111 + t127 * t112;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t128 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t114 - sin_t41 * t128;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t41 * t128 + d_A_hat_1_d_Phi * t116;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t118 * d_T_hat_1_d_Phi - u61 * (theta1 * t121);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t123 * t119);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u45 * t45 + t118 * t126 + t127 * t119;
        at.write_dc(20, d_E_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (260 add, 585 mul, 7 div, 2 sqrt, 2 fn; once 140)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 34;
    const DC: usize = 81;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 103];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let sigma = constants[1];
        let EA = constants[3];
        let EI = constants[4];
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
        let u15 = sin_beta * u11;
        let k = constants[5];
        let u16 = k * 0.5;
        let u17 = u2 * u3;
        let u18 = reciprocal(EI);
        let u19 = Phi * Phi;
        let u20 = Phi * u19;
        let u21 = reciprocal(EA);
        let u22 = 2.0 * u12;
        let u23 = u11 * (k * sin_beta);
        let u24 = 0.5 * u23;
        let u25 = EI * EI;
        let u26 = u25 * (0.5 * u18);
        let u27 = omega_P * u4;
        let u28 = omega_P * (m_o * R_P);
        let u29 = omega_P * (flow * R_P);
        let u30 = u8 * u8;
        let u31 = u7 * u30;
        let u32 = G * (EA * 2.0);
        let u33 = u30 * u32;
        let u34 = u8 * u32;
        let u35 = EA * EA;
        let u36 = u30 * u35;
        let u37 = u30 * (m_o * G);
        let u38 = u30 * (2.0 * u6);
        let u39 = u30 * (EA * G);
        let u40 = u11 * (2.0 * sin_beta);
        let u41 = u11 * u12;
        let u42 = u41 * (2.0 * (sin_beta * u10));
        let u43 = 0.5 * (u12 * (2.0 * u10));
        let u44 = 2.0 * u16;
        let u45 = EI * 2.0;
        let u46 = 4.0 * u17;
        let u47 = 2.0 * u3;
        let u48 = u3 * 3.0;
        let u49 = u18 * u18;
        let u50 = Phi * EI;
        let u51 = u19 * 3.0;
        let u52 = u21 * u21;
        let u53 = Phi * u16;
        let u54 = Phi * EA;
        let u55 = u25 * (0.5 * u49);
        let u56 = EI * u18;
        let u57 = 0.5 * (u12 * (k * u10));
        let u58 = Phi * V_T;
        let u59 = mu_k * (u14 * u14);
        let u60 = mu_k * u14;
        let u61 = Phi * u21;
        let u62 = Phi * 0.5;
        let u63 = Phi * 2.0;
        let u64 = u7 * u8 * u61;
        let u65 = Phi * (u41 * (sin_beta * 4.0));
        let u66 = Phi * u22;
        let u67 = Phi * cos_beta;
        let u68 = EI * u3;
        let u69 = Phi * u68;
        let u70 = EI * (2.0 * u17);
        let u71 = Phi * u70;
        let u72 = Phi * u45;
        let u73 = u18 * u70;
        let u74 = u18 * u45;
        let u75 = EI * u56;
        let u76 = u58 * (u2 * u75);
        let u77 = u23 * u58;
        let u78 = u58 * (u3 * u75);
        let u79 = u15 * 0.5 * u58;
        let u80 = u58 * u75;
        let u81 = u2 * u20;
        let u82 = u20 * (u18 * u68);
        let u83 = u20 * (u18 * (cos_beta * 2.0));
        let u84 = u20 * (2.0 * u18);
        let u85 = V_T * u66;
        let u86 = Phi * u44;
        let u87 = 2.0 * u24;
        let u88 = Phi * u87;
        let u89 = u20 * u44;
        let u90 = u20 * u87;
        let u91 = u8 + u38;
        let u92 = u28 * u91;
        let u93 = u29 * u91;
        let u94 = u27 * u91;
        let u95 = u5 * u91;
        let u96 = u2 * V_T;
        let u97 = V_T * u69;
        let u98 = V_T * u86;
        let u99 = V_T * u72;
        let u100 = V_T * u63;
        let u101 = omega * u63;
        let u102 = omega_P * u63;
        let u103 = u28 * u63;
        let u104 = u27 * u63;
        let u105 = omega * u88;
        let u106 = omega * u20;
        let u107 = Phi * omega;
        let u108 = omega * u100;
        [
            Phi,
            sigma,
            EA,
            EI,
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
            u14,
            u15,
            u16,
            u17,
            u18,
            u20,
            u21,
            u22,
            u24,
            u26,
            u27,
            u28,
            u29,
            u31,
            u33,
            u34,
            u35,
            u36,
            u37,
            u38,
            u39,
            u40,
            u42,
            u43,
            u44,
            u45,
            u46,
            u47,
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
            u63,
            u64,
            u65,
            u66,
            u67,
            u69,
            u71,
            u72,
            u73,
            u74,
            u76,
            u77,
            u78,
            u79,
            u80,
            u81,
            u82,
            u83,
            u84,
            u85,
            u86,
            u88,
            u89,
            u90,
            u92,
            u93,
            u94,
            u95,
            u96,
            u97,
            u98,
            u99,
            u100,
            u101,
            u102,
            u103,
            u104,
            u105,
            u106,
            u107,
            u108,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let Phi = Real::splat(uniforms[0]);
        let sigma = Real::splat(uniforms[1]);
        let EA = Real::splat(uniforms[2]);
        let EI = Real::splat(uniforms[3]);
        let m_o = Real::splat(uniforms[4]);
        let R = Real::splat(uniforms[5]);
        let mu_k = Real::splat(uniforms[6]);
        let omega_P = Real::splat(uniforms[7]);
        let cos_beta = Real::splat(uniforms[8]);
        let u2 = Real::splat(uniforms[9]);
        let u3 = Real::splat(uniforms[10]);
        let u5 = Real::splat(uniforms[11]);
        let u6 = Real::splat(uniforms[12]);
        let u8 = Real::splat(uniforms[13]);
        let u9 = Real::splat(uniforms[14]);
        let V_T = Real::splat(uniforms[15]);
        let omega = Real::splat(uniforms[16]);
        let sin_beta = Real::splat(uniforms[17]);
        let u13 = Real::splat(uniforms[18]);
        let u14 = Real::splat(uniforms[19]);
        let u15 = Real::splat(uniforms[20]);
        let u16 = Real::splat(uniforms[21]);
        let u17 = Real::splat(uniforms[22]);
        let u18 = Real::splat(uniforms[23]);
        let u20 = Real::splat(uniforms[24]);
        let u21 = Real::splat(uniforms[25]);
        let u22 = Real::splat(uniforms[26]);
        let u24 = Real::splat(uniforms[27]);
        let u26 = Real::splat(uniforms[28]);
        let u27 = Real::splat(uniforms[29]);
        let u28 = Real::splat(uniforms[30]);
        let u29 = Real::splat(uniforms[31]);
        let u31 = Real::splat(uniforms[32]);
        let u33 = Real::splat(uniforms[33]);
        let u34 = Real::splat(uniforms[34]);
        let u35 = Real::splat(uniforms[35]);
        let u36 = Real::splat(uniforms[36]);
        let u37 = Real::splat(uniforms[37]);
        let u38 = Real::splat(uniforms[38]);
        let u39 = Real::splat(uniforms[39]);
        let u40 = Real::splat(uniforms[40]);
        let u42 = Real::splat(uniforms[41]);
        let u43 = Real::splat(uniforms[42]);
        let u44 = Real::splat(uniforms[43]);
        let u45 = Real::splat(uniforms[44]);
        let u46 = Real::splat(uniforms[45]);
        let u47 = Real::splat(uniforms[46]);
        let u48 = Real::splat(uniforms[47]);
        let u49 = Real::splat(uniforms[48]);
        let u50 = Real::splat(uniforms[49]);
        let u51 = Real::splat(uniforms[50]);
        let u52 = Real::splat(uniforms[51]);
        let u53 = Real::splat(uniforms[52]);
        let u54 = Real::splat(uniforms[53]);
        let u55 = Real::splat(uniforms[54]);
        let u56 = Real::splat(uniforms[55]);
        let u57 = Real::splat(uniforms[56]);
        let u58 = Real::splat(uniforms[57]);
        let u59 = Real::splat(uniforms[58]);
        let u60 = Real::splat(uniforms[59]);
        let u61 = Real::splat(uniforms[60]);
        let u62 = Real::splat(uniforms[61]);
        let u63 = Real::splat(uniforms[62]);
        let u64 = Real::splat(uniforms[63]);
        let u65 = Real::splat(uniforms[64]);
        let u66 = Real::splat(uniforms[65]);
        let u67 = Real::splat(uniforms[66]);
        let u69 = Real::splat(uniforms[67]);
        let u71 = Real::splat(uniforms[68]);
        let u72 = Real::splat(uniforms[69]);
        let u73 = Real::splat(uniforms[70]);
        let u74 = Real::splat(uniforms[71]);
        let u76 = Real::splat(uniforms[72]);
        let u77 = Real::splat(uniforms[73]);
        let u78 = Real::splat(uniforms[74]);
        let u79 = Real::splat(uniforms[75]);
        let u80 = Real::splat(uniforms[76]);
        let u81 = Real::splat(uniforms[77]);
        let u82 = Real::splat(uniforms[78]);
        let u83 = Real::splat(uniforms[79]);
        let u84 = Real::splat(uniforms[80]);
        let u85 = Real::splat(uniforms[81]);
        let u86 = Real::splat(uniforms[82]);
        let u88 = Real::splat(uniforms[83]);
        let u89 = Real::splat(uniforms[84]);
        let u90 = Real::splat(uniforms[85]);
        let u92 = Real::splat(uniforms[86]);
        let u93 = Real::splat(uniforms[87]);
        let u94 = Real::splat(uniforms[88]);
        let u95 = Real::splat(uniforms[89]);
        let u96 = Real::splat(uniforms[90]);
        let u97 = Real::splat(uniforms[91]);
        let u98 = Real::splat(uniforms[92]);
        let u99 = Real::splat(uniforms[93]);
        let u100 = Real::splat(uniforms[94]);
        let u101 = Real::splat(uniforms[95]);
        let u102 = Real::splat(uniforms[96]);
        let u103 = Real::splat(uniforms[97]);
        let u104 = Real::splat(uniforms[98]);
        let u105 = Real::splat(uniforms[99]);
        let u106 = Real::splat(uniforms[100]);
        let u107 = Real::splat(uniforms[101]);
        let u108 = Real::splat(uniforms[102]);
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
        let slip = u14 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t6 = v_r * mu;
        let f_r = t5 * t6;
        let t7 = reciprocal(cos_beta + u15 * f_r);
        let t8 = x * t7;
        let p = u16 * t8;
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
        let arc = r * t11;
        let t15 = reciprocal(arc);
        let t16 = t15 * t15;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t17 = theta1 * theta1;
        let t18 = u3 * t17;
        let t19 = tan_theta * t18;
        let t20 = theta_2 + tan_theta - t19;
        let t21 = t16 * t20;
        let t22 = t - t14 * (EI * t21);
        let T_hat_1 = Phi * t22;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t23 = reciprocal(t16);
        let t24 = u18 * t23;
        let t25 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t25;
        let t26 = tan_theta * tan_theta;
        let t27 = u17 * (theta1 * t17);
        let t28 = t18 * t26;
        let t29 = theta1 * theta2;
        let t30 = theta_1 * t26;
        let t31 = t26 * t27 + (theta_1 + Real::splat(2.0) * t28)
            - Real::splat(4.0) * (tan_theta * (u17 * t29)) - t30;
        let t32 = theta_2 * tan_theta;
        let t33 = t31 - Real::splat(2.0) * t32 - t27 - Real::splat(2.0) * t26;
        let t34 = t16 * t33;
        let t35 = n + T * theta_1 - EI * t34 - T;
        let theta_3 = t24 * t35;
        let theta_hat_3 = u20 * theta_3;
        at.write_f(3, theta_hat_3);
        let t36 = r * tan_theta;
        let x_hat_1 = -(Phi * t36);
        at.write_f(4, x_hat_1);
        let t37 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t37;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u16 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t38 = u6 + m_o * T;
        let F = u9 * t38;
        let t39 = EA + F;
        let t40 = reciprocal(t39);
        let d_L_o_hat_1_d_Phi = arc * (EA * t40);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t41 = v_r * f_r;
        let t42 = p * t41;
        let loss_radial = u22 * t42;
        let t43 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t43);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t44 = Phi * s;
        let (sin_t44, cos_t44) = sin_cos(t44);
        let t46 = r * A_hat_1;
        let A_x_hat_1 = cos_t44 * t46;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t46 * sin_t44;
        at.write_f(10, A_y_hat_1);
        let t47 = t15 * t14;
        let t48 = t47 * t47;
        let t49 = x * x;
        let stored = u26 * t48 - u24 * t49;
        let t50 = T_hat_1 * stored;
        let E_hat_1 = V_T * t50;
        at.write_f(11, E_hat_1);
        let t51 = tan_theta * q;
        let t52 = x * (t7 * t7);
        let t53 = r * t52;
        let t54 = Phi * t51 - u88 * (t13 * t53);
        let t55 = V_T * sin_theta;
        let t56 = mu * t5;
        let t57 = t5 * t5;
        let t58 = t6 * t57;
        let t59 = v_r * t5;
        let t60 = reciprocal(speed);
        let t61 = v_r * t60;
        let t62 = speed * t5;
        let t63 = u43 * t59 + t61 * t62;
        let t64 = below_one(slip);
        let t65 = u60 * t64;
        let t66 = t61 * t65;
        let t67 = t56 - t58 * t63 + t59 * t66;
        let t68 = V_T * cos_theta;
        let t69 = v_t * t60;
        let t70 = t69 * t65;
        let t71 = t69 * t62;
        let t72 = t59 * t70 - t58 * t71;
        let t73 = t55 * t67 + t68 * t72;
        let t74 = u63 * t9;
        let t75 = v_t * t5;
        let t76 = t10 * t57;
        let t77 = t75 * t66 - t76 * t63;
        let t78 = t56 - t76 * t71 + t75 * t70;
        let t79 = t55 * t77 + t68 * t78;
        let d_T_hat_1_d_T = t54 * t73 + t74 * t79;
        at.write_dy(0, d_T_hat_1_d_T);
        let t80 = Real::splat(1.0) + t26;
        let t81 = Phi * t14;
        let t82 = Phi * (t80 * (q * t12))
            - t81 * (t80 * (EI * (t16 * (Real::splat(1.0) - t18))));
        let t83 = t11 * t11 * (r * sin_theta);
        let t84 = t15 * t16;
        let t85 = t14 * (t20 * t84);
        let t86 = u72 * t85;
        let t87 = t4 * t67 - v_r * t72;
        let t88 = t4 * t77 - v_r * t78;
        let d_T_hat_1_d_theta = t82 + t83 * t86 + t54 * t87 + t74 * t88;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t89 = theta_1 * tan_theta;
        let t90 = u72 * (t14 * (t16 * t89)) - u50 * t21;
        let d_T_hat_1_d_theta1 = u2 * t90;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let t91 = t14 * t16;
        let d_T_hat_1_d_theta2 = -(u69 * t91);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t92 = Phi * t13;
        let t93 = u44 * (r * t7) - u44 * t8;
        let t94 = t92 * t93;
        let t95 = t11 * t86;
        let t96 = omega * t72;
        let t97 = t54 * t96;
        let t98 = u101 * (t9 * t78);
        let d_T_hat_1_d_x = t94 - t95 + t97 + t98;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t99 = t9 * t23;
        let t100 = t25 * t24;
        let t101 = u84 * t99 + u90 * (t100 * t53);
        let t102 = t24 * t51;
        let t103 = u20 * t102;
        let d_theta_hat_3_d_T = u20 * (t14 * t24) - t101 * t73 + t103 * t79;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t104 = f_t * q;
        let t105 = Real::splat(4.0) * t19 + Real::splat(2.0) * (tan_theta * t27)
            - u46 * t29 - Real::splat(2.0) * t89 - u47 * theta2;
        let t106 = t24 * (t80 * t104)
            - t24 * (t80 * (EI * (t16 * (t105 - Real::splat(4.0) * tan_theta))));
        let t107 = t35 * (u49 * (t23 * t23));
        let t108 = u20 * (u45 * t84 * t107 + u74 * (t23 * (t33 * t84)));
        let d_theta_hat_3_d_theta = u20 * t106 + t83 * t108 - t101 * t87 + t103 * t88;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t109 = Real::splat(3.0) * t28 + (Real::splat(1.0) + Real::splat(4.0) * t30)
            - Real::splat(4.0) * t32 - u48 * t17 - t26;
        let t110 = T * t24 - u56 * (t23 * (t16 * t109));
        let d_theta_hat_3_d_theta1 = u81 * t110;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t111 = t16 * (Real::splat(4.0) * t89 + Real::splat(2.0) * tan_theta);
        let d_theta_hat_3_d_theta2 = u82 * (t23 * t111);
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t112 = u20 * t100;
        let t113 = t11 * t108;
        let t114 = t101 * t96;
        let t115 = u106 * (t102 * t78);
        let d_theta_hat_3_d_x = t93 * t112 - t113 - t114 + t115;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t80 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let t116 = arc * q;
        let t117 = Phi * t116;
        let t118 = t37 * t53;
        let t119 = u88 * t118;
        let d_M_hat_1_d_T = t117 * t79 - t119 * t73;
        at.write_dy(14, d_M_hat_1_d_T);
        let t120 = Phi * t104;
        let d_M_hat_1_d_theta = t83 * t120 - t119 * t87 + t117 * t88;
        at.write_dy(15, d_M_hat_1_d_theta);
        let t121 = Phi * t37;
        let t122 = t11 * t120;
        let t123 = u105 * (t72 * t118);
        let t124 = u107 * (t116 * t78);
        let d_M_hat_1_d_x = t121 * t93 - t122 - t123 + t124;
        at.write_dy(16, d_M_hat_1_d_x);
        let t125 = u53 * x;
        let d_A_hat_1_d_theta = t83 * t125;
        at.write_dy(17, d_A_hat_1_d_theta);
        let t126 = u53 * arc;
        let d_A_hat_1_d_R = t11 * t125;
        let d_A_hat_1_d_x = t126 - d_A_hat_1_d_R;
        at.write_dy(18, d_A_hat_1_d_x);
        let t127 = arc * (u35 * (t40 * t40));
        let d_L_o_hat_1_d_T = -(u64 * t127);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t128 = u54 * t40;
        let d_L_o_hat_1_d_theta = t83 * t128;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t11 * t128;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t129 = arc * (f_r * p);
        let t130 = arc * (f_t * p);
        let t131 = u63 * (arc * t43) + u66 * (arc * t41);
        let t132 = u66 * (arc * (v_r * p)) - u24 * t52 * t131;
        let t133 = arc * (v_t * p);
        let t134 = u63 * t133;
        let d_W_hat_1_d_T = u85 * (sin_theta * t129) + u100 * (cos_theta * t130)
            + t132 * t73 + t134 * t79;
        at.write_dy(22, d_W_hat_1_d_T);
        let t135 = u66 * t129;
        let t136 = Phi * loss;
        let t137 = u63 * t130;
        let d_W_hat_1_d_theta = t4 * t135 + t83 * t136 - v_r * t137 + t132 * t87
            + t134 * t88;
        at.write_dy(23, d_W_hat_1_d_theta);
        let t138 = t11 * t136;
        let t139 = u101 * t130;
        let t140 = t132 * t96;
        let t141 = u101 * (t133 * t78);
        let d_W_hat_1_d_x = u16 * t7 * t131 - t138 + t139 + t140 + t141;
        at.write_dy(24, d_W_hat_1_d_x);
        let t142 = r * cos_t44;
        let t143 = t125 * t142;
        let d_A_x_hat_1_d_theta = t83 * t143;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let t144 = A_hat_1 * cos_t44;
        let t145 = t11 * t143;
        let d_A_x_hat_1_d_x = t142 * t126 - t144 - t145;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t146 = r * sin_t44;
        let t147 = t125 * t146;
        let d_A_y_hat_1_d_theta = t83 * t147;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let t148 = A_hat_1 * sin_t44;
        let t149 = t11 * t147;
        let d_A_y_hat_1_d_x = t146 * t126 - t148 - t149;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t150 = V_T * stored;
        let t151 = t150 * t54;
        let t152 = t9 * stored;
        let t153 = u100 * t152;
        let d_E_hat_1_d_T = t151 * t73 + t153 * t79;
        at.write_dy(29, d_E_hat_1_d_T);
        let t154 = u99 * (stored * t85) - u80 * (t22 * (t47 * t91));
        let d_E_hat_1_d_theta = t150 * t82 + t83 * t154 + t151 * t87 + t153 * t88;
        at.write_dy(30, d_E_hat_1_d_theta);
        let t155 = t15 * t47;
        let d_E_hat_1_d_theta1 = u76 * (t22 * t155) + u96 * (stored * t90);
        at.write_dy(31, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u97 * (stored * t91));
        at.write_dy(32, d_E_hat_1_d_theta2);
        let t156 = t11 * t154;
        let t157 = t151 * t96;
        let t158 = u108 * (t78 * t152);
        let d_E_hat_1_d_x = t150 * t94 - u77 * (x * t22) - t156 + t157 + t158;
        at.write_dy(33, d_E_hat_1_d_x);
        let t159 = u3 * theta1;
        let d_T_hat_1_d_Phi = t22 + u71 * (t14 * (theta2 * t16)) - t159 * t90;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t160 = omega_P * r;
        let t161 = t160 * t72;
        let t162 = t160 * t78;
        let d_T_hat_1_d_sigma = -(t54 * t161 + t74 * t162);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t163 = u8 * t1 + u38 * t1;
        let t164 = sin_theta * t163;
        let t165 = t164 * t67;
        let t166 = cos_theta * t163;
        let t167 = u28 * t166;
        let t168 = u28 * t165 + t72 * t167;
        let t169 = t164 * t77;
        let t170 = u28 * t169 + t78 * t167;
        let d_T_hat_1_d_flow = t54 * t168 + t74 * t170;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u51 * theta_3
            - u20 * (u73 * (t23 * (theta2 * t111)) + t159 * t110);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = t101 * t161 - t103 * t162;
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t103 * t170 - t101 * t168;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t36;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = t119 * t161 - t117 * t162;
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t117 * t170 - t119 * t168;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t171 = u61 * t127;
        let t172 = (u33 * t38 + u34) * t171;
        let d_L_o_hat_1_d_flow = -(u28 * t172);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(u102 * (r * t130) + t132 * t161 + t134 * t162);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let t173 = t135 * t164;
        let t174 = t130 * t166;
        let d_W_hat_1_d_flow = u28 * t173 + u103 * t174 + t132 * t168 + t134 * t170;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t175 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t142 - sin_t44 * t175;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t44 * t175 + d_A_hat_1_d_Phi * t146;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t150 * d_T_hat_1_d_Phi - u78 * (t22 * (theta1 * t155));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t151 * t161 + t153 * t162);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u92 * t50 + t151 * t168 + t153 * t170;
        at.write_dc(20, d_E_hat_1_d_flow);
        let t176 = V_T - u37 * t1;
        let t177 = sin_theta * t176;
        let t178 = cos_theta * t176;
        let t179 = t177 * t67 + t178 * t72;
        let t180 = t177 * t77 + t178 * t78;
        let d_T_hat_1_d_EA = t54 * t179 + t74 * t180;
        at.write_dc(21, d_T_hat_1_d_EA);
        let t181 = t21 * t81;
        let d_T_hat_1_d_EI = -t181;
        at.write_dc(22, d_T_hat_1_d_EI);
        let t182 = r * t8;
        let d_T_hat_1_d_k = t92 * t182;
        at.write_dc(23, d_T_hat_1_d_k);
        let t183 = u39 * t1;
        let t184 = sin_theta * t183;
        let t185 = u29 * t166 - cos_theta * t183;
        let t186 = u29 * t165 - t184 * t67 + t72 * t185;
        let t187 = u29 * t169 - t184 * t77 + t78 * t185;
        let d_T_hat_1_d_m_o = t54 * t186 + t74 * t187;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let t188 = t8 * t13;
        let d_T_hat_1_d_R = u86 * t188 + t95 - t97 - t98;
        at.write_dc(25, d_T_hat_1_d_R);
        let t189 = u27 * t166;
        let t190 = u27 * t165 + t72 * t189;
        let t191 = u27 * t169 + t78 * t189;
        let d_T_hat_1_d_R_P = t54 * t190 + t74 * t191;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t192 = (t12 + u13 * f_r) * t52;
        let t193 = r * t192;
        let t194 = u67 * t51 + u86 * (t13 * t193);
        let t195 = Real::splat(0.5) * t5 * (u40 * t3 + u42 * t3);
        let t196 = t195 * t58;
        let t197 = t195 * t76;
        let d_T_hat_1_d_beta = -(t194 + t196 * t54 + t74 * t197);
        at.write_dc(27, d_T_hat_1_d_beta);
        let t198 = saturation * t59;
        let t199 = saturation * t75;
        let d_T_hat_1_d_mu_k = t198 * t54 + t74 * t199;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let t200 = u59 * (speed * t64);
        let t201 = t59 * t200;
        let t202 = t75 * t200;
        let d_T_hat_1_d_v_thr = -(t201 * t54 + t74 * t202);
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let t203 = u5 * t166 - sigma * r;
        let t204 = u5 * t165 + t72 * t203;
        let t205 = u5 * t169 + t78 * t203;
        let d_T_hat_1_d_omega_P = t54 * t204 + t74 * t205;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t103 * t180 - t101 * t179;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(u20 * (t16 * t107 + t34 * t24));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let d_theta_hat_3_d_k = t182 * t112;
        at.write_dc(33, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = t103 * t187 - t101 * t186;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R = u89 * (t8 * t100) + t113 + t114 - t115;
        at.write_dc(35, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = t103 * t191 - t101 * t190;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_beta = u83 * t99 - u89 * (t100 * t193) + t196 * t101
            - t197 * t103;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = t199 * t103 - t198 * t101;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = t201 * t101 - t202 * t103;
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = t103 * t205 - t101 * t204;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t117 * t180 - t119 * t179;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = t121 * t182;
        at.write_dc(43, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = t117 * t187 - t119 * t186;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = u86 * (t8 * t37) + t122 + t123 - t124;
        at.write_dc(45, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = t117 * t191 - t119 * t190;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t196 * t119 - u86 * (t37 * t193) - t117 * t197;
        at.write_dc(47, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = t117 * t199 - t198 * t119;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = t201 * t119 - t117 * t202;
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = t117 * t205 - t119 * t204;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = u62 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        at.write_dc(52, d_A_hat_1_d_R);
        let t206 = (u21 - u52 * t39) * (Phi * t127) + (u8 * t38 - u31 * t38) * t171;
        let d_L_o_hat_1_d_EA = -t206;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u36 * t38) * t171 + u29 * t172);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u27 * t172);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t172);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t135 * t177 + t137 * t178 + t132 * t179 + t134 * t180;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = Real::splat(0.5) * t8 * t131;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = u29 * t173 - t135 * t184 + t137 * t185 + t132 * t186
            + t134 * t187;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t138 - t139 - t140 - t141;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = u27 * t173 + u104 * t174 + t132 * t190 + t134 * t191;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = u65 * (arc * t42) - u16 * t192 * t131 - t196 * t132
            - t134 * t197;
        at.write_dc(63, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = t198 * t132 + t134 * t199;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t201 * t132 + t134 * t202);
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = u5 * t173 + t137 * t203 + t132 * t204 + t134 * t205;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let d_A_x_hat_1_d_k = t142 * d_A_hat_1_d_k;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t144 + t145;
        at.write_dc(68, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t146 * d_A_hat_1_d_k;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t148 + t149;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_E_hat_1_d_EA = t151 * t179 - u37 * t50 + t153 * t180;
        at.write_dc(71, d_E_hat_1_d_EA);
        let t207 = u58 * t22;
        let d_E_hat_1_d_EI = t207 * (t47 * (u56 * t47) - u55 * t48) - t150 * t181;
        at.write_dc(72, d_E_hat_1_d_EI);
        let d_E_hat_1_d_k = t150 * d_T_hat_1_d_k - u79 * (t22 * t49);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_E_hat_1_d_m_o = u93 * t50 - u39 * t50 + t151 * t186 + t153 * t187;
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R = u98 * (stored * t188) + t156 - t157 - t158;
        at.write_dc(75, d_E_hat_1_d_R);
        let d_E_hat_1_d_R_P = u94 * t50 + t151 * t190 + t153 * t191;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t208 = (u16 * t49 + u57 * t49) * t207 + t150 * t194 + t196 * t151
            + t197 * t153;
        let d_E_hat_1_d_beta = -t208;
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_mu_k = t198 * t151 + t199 * t153;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let d_E_hat_1_d_v_thr = -(t201 * t151 + t202 * t153);
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_omega_P = u95 * t50 + t151 * t204 + t153 * t205;
        at.write_dc(80, d_E_hat_1_d_omega_P);
    }
}
///Derived fields. (16 add, 40 mul, 4 div, 2 sqrt, 3 fn; once 21)
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    type Uniforms = [f64; 17];
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
        let u3 = u2 * u2;
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u4 = G * G;
        let u5 = reciprocal(EA * m_o - u4);
        let u6 = EA * u5;
        let V_T = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u7 = reciprocal(cos_beta);
        let u8 = u7 * u7;
        let u9 = sin_beta * sin_beta * u8;
        let v_thr = constants[11];
        let u10 = reciprocal(v_thr);
        let u11 = sin_beta * u7;
        let k = constants[5];
        let u12 = k * 0.5;
        let u13 = 2.0 * u8;
        [
            EA,
            EI,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u3,
            u4,
            u6,
            V_T,
            omega,
            u9,
            u10,
            u11,
            u12,
            u13,
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
        let u4 = Real::splat(uniforms[8]);
        let u6 = Real::splat(uniforms[9]);
        let V_T = Real::splat(uniforms[10]);
        let omega = Real::splat(uniforms[11]);
        let u9 = Real::splat(uniforms[12]);
        let u10 = Real::splat(uniforms[13]);
        let u11 = Real::splat(uniforms[14]);
        let u12 = Real::splat(uniforms[15]);
        let u13 = Real::splat(uniforms[16]);
        let T = at.state::<Real>(0);
        let F = u6 * (u4 + m_o * T);
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
        let slip = u10 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let face_speed = sqrt(u9 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let f_r = t3 * (v_r * mu);
        let p = u12 * (x * reciprocal(cos_beta + u11 * f_r));
        at.write_field(7, p);
        let beta_s = angle(speed, u11 * v_r);
        at.write_field(8, beta_s);
        let t4 = reciprocal(cos_theta);
        let arc = r * t4;
        let t5 = reciprocal(arc);
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let tan_theta = t4 * sin_theta;
        let theta1 = at.state::<Real>(2);
        let Q = -(EI
            * (t5 * t5 * (theta_2 + tan_theta - tan_theta * (u3 * (theta1 * theta1)))));
        at.write_field(9, Q);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (t5 * (theta_1 - Real::splat(1.0))));
        at.write_field(10, M_b);
        let axial = u12 * x;
        at.write_field(11, axial);
        let loss_radial = u13 * (p * (v_r * f_r));
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
