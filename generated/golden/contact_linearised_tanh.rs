// contact_linearised_tanh: The belt in a groove: linearised shear, tanh friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p eqgen -- write` writes it anew.
// Operations per point, and once a batch:
//   value: 24 add, 80 mul, 6 div, 2 sqrt, 3 fn; once 29
//   jacobian: 121 add, 374 mul, 6 div, 2 sqrt, 3 fn; once 57
//   full: 196 add, 519 mul, 6 div, 2 sqrt, 3 fn; once 81
//   fields: 13 add, 45 mul, 5 div, 2 sqrt, 4 fn; once 24

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
    ],
    usual_entries: 18,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
///Right-hand side and integrands. (24 add, 80 mul, 6 div, 2 sqrt, 3 fn; once 29)
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 11;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 20];
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
        let u3 = u2 * u2;
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u4 = G * G;
        let u5 = reciprocal(EA * m_o - u4);
        let u6 = EA * u5;
        let u7 = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u8 = reciprocal(v_thr) * 4.0;
        let u9 = sin_beta * reciprocal(cos_beta);
        let k = constants[5];
        let u10 = k * 0.5;
        let EI = constants[4];
        let u11 = reciprocal(R);
        let u12 = EI * (u11 * (u11 * u11));
        let u13 = reciprocal(EI) * (R * (R * R));
        let u14 = Phi * (Phi * Phi);
        let u15 = Phi * 2.0;
        [
            Phi,
            EA,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u3,
            u4,
            u6,
            u7,
            omega,
            u8,
            sin_beta,
            u9,
            u10,
            u12,
            u13,
            u14,
            u15,
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
        let u4 = Real::splat(uniforms[8]);
        let u6 = Real::splat(uniforms[9]);
        let u7 = Real::splat(uniforms[10]);
        let omega = Real::splat(uniforms[11]);
        let u8 = Real::splat(uniforms[12]);
        let sin_beta = Real::splat(uniforms[13]);
        let u9 = Real::splat(uniforms[14]);
        let u10 = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let u13 = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let t2 = reciprocal(cos_theta);
        let arc = r * t2;
        let T = at.state::<Real>(0);
        let V = u7 * (T + EA);
        let v_t = cos_theta * V - omega * r;
        let v_r = V * sin_theta;
        let speed = sqrt(
            v_t * v_t + (Real::splat(0.000000000000000000000001) + v_r * v_r),
        );
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        let t3 = reciprocal(speed);
        let cos_gamma = v_r * t3;
        let tan_beta_s = u9 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let p = u10 * (x * reciprocal(cos_beta + mu * sin_beta_s));
        let t4 = arc * p;
        let t5 = mu * cos_beta_s;
        let sin_gamma = v_t * t3;
        let t = Real::splat(2.0)
            * (t4
                * (t5 * (sin_theta * cos_gamma + cos_theta * sin_gamma)
                    - sin_beta * sin_theta));
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t6 = (Real::splat(1.0) - theta_1)
            * (u12 * (t2 * (R * (cos_theta * theta_2) + R * sin_theta - x * sin_theta)));
        let T_hat_1 = Phi * (t + t6);
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let n = Real::splat(2.0)
            * ((sin_beta * cos_theta
                - (cos_theta * cos_gamma - sin_theta * sin_gamma) * t5) * t4);
        let t7 = sin_theta * sin_theta;
        let t8 = u12
            * (t2 * t2
                * (r * (theta_1 * (cos_theta * cos_theta) + (t7 + theta_1 * t7))));
        let theta_3 = u13 * reciprocal(R + Real::splat(2.0) * x)
            * (n + T * theta_1 - t8 - T);
        let theta_hat_3 = u14 * theta_3;
        at.write_f(3, theta_hat_3);
        let x_hat_1 = -(Phi * (arc * sin_theta));
        at.write_f(4, x_hat_1);
        let M_hat_1 = u15 * (p * (cos_beta_s * (mu * (sin_gamma * (r * arc)))));
        at.write_f(5, M_hat_1);
        let axial = u10 * x;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(6, A_hat_1);
        let F = u6 * (u4 + m_o * T);
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(7, L_o_hat_1);
        let loss = Real::splat(2.0) * (p * (sec_beta_s * (speed * mu)));
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t9 = Phi * s;
        let (sin_t9, cos_t9) = sin_cos(t9);
        let t11 = r * A_hat_1;
        let A_x_hat_1 = cos_t9 * t11;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t11 * sin_t9;
        at.write_f(10, A_y_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and usual constants. (121 add, 374 mul, 6 div, 2 sqrt, 3 fn; once 57)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 11;
    const DY: usize = 28;
    const DC: usize = 18;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 39];
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
        let u8 = G * u6;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u9 = reciprocal(v_thr) * 4.0;
        let u10 = sin_beta * reciprocal(cos_beta);
        let k = constants[5];
        let u11 = k * 0.5;
        let EI = constants[4];
        let u12 = reciprocal(R);
        let u13 = u12 * u12;
        let u14 = EI * (u12 * u13);
        let u15 = reciprocal(EI) * (R * (R * R));
        let u16 = Phi * Phi;
        let u17 = Phi * u16;
        let u18 = Phi * 2.0;
        let u19 = omega_P * (m_o * R_P);
        let u20 = u6 * u6;
        let u21 = G * (EA * 2.0);
        let u22 = u20 * u21;
        let u23 = u6 * u21;
        let u24 = u20 * (2.0 * u4);
        let u25 = 2.0 * u10;
        let u26 = 2.0 * u14;
        let u27 = Phi * u14;
        let u28 = u16 * 3.0;
        let u29 = Phi * u11;
        let u30 = Phi * EA;
        let u31 = mu_k * u9;
        let u32 = Phi * reciprocal(EA);
        let u33 = EI * u13;
        let u34 = 2.0 * (u2 * u3) * u33;
        let u35 = u5 * u6 * u32;
        let u36 = u2 * u27;
        let u37 = Phi * (u3 * u33);
        let u38 = u2 * u17;
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
            u8,
            omega,
            u9,
            sin_beta,
            u10,
            u11,
            u14,
            u15,
            u17,
            u18,
            u19,
            u22,
            u23,
            u24,
            u25,
            u26,
            u27,
            u28,
            u29,
            u30,
            u31,
            u32,
            u34,
            u35,
            u36,
            u37,
            u38,
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
        let u8 = Real::splat(uniforms[12]);
        let omega = Real::splat(uniforms[13]);
        let u9 = Real::splat(uniforms[14]);
        let sin_beta = Real::splat(uniforms[15]);
        let u10 = Real::splat(uniforms[16]);
        let u11 = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let u17 = Real::splat(uniforms[20]);
        let u18 = Real::splat(uniforms[21]);
        let u19 = Real::splat(uniforms[22]);
        let u22 = Real::splat(uniforms[23]);
        let u23 = Real::splat(uniforms[24]);
        let u24 = Real::splat(uniforms[25]);
        let u25 = Real::splat(uniforms[26]);
        let u26 = Real::splat(uniforms[27]);
        let u27 = Real::splat(uniforms[28]);
        let u28 = Real::splat(uniforms[29]);
        let u29 = Real::splat(uniforms[30]);
        let u30 = Real::splat(uniforms[31]);
        let u31 = Real::splat(uniforms[32]);
        let u32 = Real::splat(uniforms[33]);
        let u34 = Real::splat(uniforms[34]);
        let u35 = Real::splat(uniforms[35]);
        let u36 = Real::splat(uniforms[36]);
        let u37 = Real::splat(uniforms[37]);
        let u38 = Real::splat(uniforms[38]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let t2 = reciprocal(cos_theta);
        let arc = r * t2;
        let T = at.state::<Real>(0);
        let t3 = T + EA;
        let V = u8 * t3;
        let t4 = cos_theta * V;
        let v_t = t4 - omega * r;
        let v_r = V * sin_theta;
        let speed = sqrt(
            v_t * v_t + (Real::splat(0.000000000000000000000001) + v_r * v_r),
        );
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        let t5 = reciprocal(speed);
        let cos_gamma = v_r * t5;
        let tan_beta_s = u10 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let t6 = reciprocal(cos_beta + mu * sin_beta_s);
        let p = u11 * (x * t6);
        let t7 = arc * p;
        let t8 = mu * cos_beta_s;
        let sin_gamma = v_t * t5;
        let t9 = sin_theta * cos_gamma + cos_theta * sin_gamma;
        let t10 = t8 * t9 - sin_beta * sin_theta;
        let t = Real::splat(2.0) * (t7 * t10);
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t11 = Real::splat(1.0) - theta_1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t12 = R * (cos_theta * theta_2) + R * sin_theta - x * sin_theta;
        let t13 = t2 * t12;
        let t14 = t + t11 * (u14 * t13);
        let T_hat_1 = Phi * t14;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t15 = u15 * reciprocal(R + Real::splat(2.0) * x);
        let t16 = cos_theta * cos_gamma - sin_theta * sin_gamma;
        let t17 = sin_beta * cos_theta - t16 * t8;
        let t18 = t17 * t7;
        let n = Real::splat(2.0) * t18;
        let t19 = t2 * t2;
        let t20 = cos_theta * cos_theta;
        let t21 = sin_theta * sin_theta;
        let t22 = theta_1 * t20 + (t21 + theta_1 * t21);
        let t23 = n + T * theta_1 - u14 * (t19 * (r * t22)) - T;
        let theta_3 = t15 * t23;
        let theta_hat_3 = u17 * theta_3;
        at.write_f(3, theta_hat_3);
        let t24 = arc * sin_theta;
        let x_hat_1 = -(Phi * t24);
        at.write_f(4, x_hat_1);
        let t25 = r * arc;
        let t26 = sin_gamma * t25;
        let t27 = mu * t26;
        let t28 = cos_beta_s * t27;
        let t29 = p * t28;
        let M_hat_1 = u18 * t29;
        at.write_f(5, M_hat_1);
        let axial = u11 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t30 = u4 + m_o * T;
        let F = u7 * t30;
        let t31 = reciprocal(EA + F);
        let t32 = EA * t31;
        let d_L_o_hat_1_d_Phi = arc * t32;
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t33 = speed * mu;
        let t34 = sec_beta_s * t33;
        let t35 = p * t34;
        let loss = Real::splat(2.0) * t35;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t36 = Phi * s;
        let (sin_t36, cos_t36) = sin_cos(t36);
        let t38 = r * A_hat_1;
        let A_x_hat_1 = cos_t36 * t38;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t38 * sin_t36;
        at.write_f(10, A_y_hat_1);
        let t39 = u8 * sin_theta;
        let t40 = t5 * t39;
        let t41 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t24)));
        let t42 = p * (arc * mu);
        let t43 = u10 * (Real::splat(0.5) * cos_beta_s * (u25 * cos_gamma));
        let t44 = cos_beta_s * cos_beta_s * t43;
        let t45 = t6 * t6;
        let t46 = u11 * (t45 * (x * mu));
        let t47 = t44 * (tan_beta_s * t46) - t46 * (u10 * cos_beta_s);
        let t48 = u18 * (arc * t10);
        let t49 = Phi * (t41 - Real::splat(2.0) * (t9 * t42) * t44) + t47 * t48;
        let t50 = Real::splat(0.5) * t5;
        let t51 = t50 * (Real::splat(2.0) * v_r);
        let t52 = t51 * t39;
        let t53 = p * (arc * cos_beta_s);
        let t54 = u31 * (Real::splat(1.0) - saturation * saturation);
        let t55 = t5 * t5;
        let t56 = v_t * t55;
        let t57 = Real::splat(2.0) * (p * (cos_beta_s * (mu * (cos_theta * arc))));
        let t58 = u11 * (t45 * (x * sin_beta_s)) * t54;
        let t59 = v_r * t55;
        let t60 = Phi * (Real::splat(2.0) * (t9 * t53) * t54 - t56 * t57) - t58 * t48
            - t59 * t49;
        let t61 = u8 * cos_theta;
        let t62 = t50 * (Real::splat(2.0) * v_t);
        let t63 = Phi * (t5 * t57) + t62 * t60;
        let d_T_hat_1_d_T = t40 * t49 + t52 * t60 + t61 * t63;
        at.write_dy(0, d_T_hat_1_d_T);
        let t64 = u14 * (t19 * (sin_theta * t12))
            + u14 * (t2 * (R * cos_theta - x * cos_theta - R * (theta_2 * sin_theta)));
        let t65 = Phi * t11;
        let t66 = r * sin_theta;
        let t67 = t19 * t66;
        let t68 = u18 * (p * t10);
        let t69 = t4 * t5;
        let t70 = t4 * t51;
        let t71 = t64 * t65 - u18 * t18 + t67 * t68 + t69 * t49 + t70 * t60;
        let d_T_hat_1_d_theta = t71 - v_r * t63;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u36 * t13);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = u37 * t11;
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t72 = u11 * t6;
        let t73 = t2 * sin_theta;
        let d_T_hat_1_d_x = t72 * t48 - u14 * t73 * t65 - t2 * t68 + omega * t63;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t74 = u17 * (t15 * (Real::splat(2.0) * (arc * t17)));
        let t75 = u17 * (t15 * (Real::splat(2.0) * (t16 * t42) * t44 - t57)) + t47 * t74;
        let t76 = u17 * (t15 * (Real::splat(2.0) * (t16 * t53) * t54 + t56 * t41))
            + t58 * t74;
        let t77 = t76 + t59 * t75;
        let t78 = u17 * (t15 * (t5 * t41)) - t62 * t77;
        let d_theta_hat_3_d_T = t40 * t75 - u17 * (t11 * t15) - t52 * t77 + t61 * t78;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t79 = t * t15 - t15 * (u26 * t24 + u26 * (t2 * t19 * (t22 * t66)));
        let t80 = u17 * (t15 * (Real::splat(2.0) * (p * t17)));
        let d_theta_hat_3_d_theta = u17 * t79 + t67 * t80 + t69 * t75 - t70 * t77
            - v_r * t78;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t81 = T * t15 - t15 * (u14 * ((t21 + t20) * (r * t19)));
        let d_theta_hat_3_d_theta1 = u38 * t81;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t82 = u17 * (t15 * (u14 * (t22 * t19)) - u26 * (t23 * (t15 * t15)))
            + t72 * t74;
        let d_theta_hat_3_d_x = t82 - t2 * t80 + omega * t78;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(Phi * r + Phi * (t19 * (r * t21)));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * t73;
        at.write_dy(12, d_x_hat_1_d_x);
        let t83 = u18 * t28;
        let t84 = t83 * t47 - u18 * (p * t27) * t44;
        let t85 = u18 * (p * (cos_beta_s * (mu * t25)));
        let t86 = u18 * (p * (cos_beta_s * t26)) * t54 - t56 * t85 - t83 * t58
            - t59 * t84;
        let t87 = t5 * t85 + t62 * t86;
        let d_M_hat_1_d_T = t40 * t84 + t52 * t86 + t61 * t87;
        at.write_dy(13, d_M_hat_1_d_T);
        let t88 = u18 * (p * (cos_beta_s * (mu * (r * sin_gamma))));
        let d_M_hat_1_d_theta = t67 * t88 + t69 * t84 + t70 * t86 - v_r * t87;
        at.write_dy(14, d_M_hat_1_d_theta);
        let t89 = t72 * t83 - u18 * (p * (cos_beta_s * (mu * (arc * sin_gamma))))
            - t2 * t88;
        let d_M_hat_1_d_x = t89 + omega * t87;
        at.write_dy(15, d_M_hat_1_d_x);
        let t90 = u29 * x;
        let d_A_hat_1_d_theta = t67 * t90;
        at.write_dy(16, d_A_hat_1_d_theta);
        let t91 = u29 * arc;
        let d_A_hat_1_d_x = t91 - t2 * t90;
        at.write_dy(17, d_A_hat_1_d_x);
        let t92 = arc * (t32 * t32);
        let d_L_o_hat_1_d_T = -(u35 * t92);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t93 = u30 * t31;
        let d_L_o_hat_1_d_theta = t67 * t93;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t2 * t93);
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t94 = Phi * arc;
        let t95 = Real::splat(2.0) * t34 * t94;
        let t96 = t94 * (Real::splat(2.0) * (p * t33) * t43) + t47 * t95;
        let t97 = Real::splat(2.0) * (p * (mu * sec_beta_s)) * t94
            + t54 * (Real::splat(2.0) * (p * (speed * sec_beta_s)) * t94);
        let t98 = t97 - t95 * t58 - t59 * t96;
        let t99 = t62 * t98;
        let d_W_hat_1_d_T = t40 * t96 + t52 * t98 + t61 * t99;
        at.write_dy(21, d_W_hat_1_d_T);
        let t100 = u18 * t35;
        let d_W_hat_1_d_theta = t67 * t100 + t69 * t96 + t70 * t98 - v_r * t99;
        at.write_dy(22, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = t72 * t95 - t2 * t100 + omega * t99;
        at.write_dy(23, d_W_hat_1_d_x);
        let t101 = r * cos_t36;
        let t102 = t90 * t101;
        let d_A_x_hat_1_d_theta = t67 * t102;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t101 * t91 - A_hat_1 * cos_t36 - t2 * t102;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t103 = r * sin_t36;
        let t104 = t90 * t103;
        let d_A_y_hat_1_d_theta = t67 * t104;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t103 * t91 - A_hat_1 * sin_t36 - t2 * t104;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t105 = u3 * theta1;
        let d_T_hat_1_d_Phi = t14 + t105 * (u27 * t13) - t65 * (u34 * theta2);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t106 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t106 * t63);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t107 = u19 * (u6 * t3 + u24 * t3);
        let t108 = sin_theta * t107;
        let t109 = t5 * t108;
        let t110 = t51 * t108;
        let t111 = cos_theta * t107;
        let d_T_hat_1_d_flow = t109 * t49 + t110 * t60 + t111 * t63;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u28 * theta_3 - u17 * (t105 * t81);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(t106 * t78);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t109 * t75 - t110 * t77 + t111 * t78;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t24;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let d_M_hat_1_d_Phi = Real::splat(2.0) * t29;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t106 * t87);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t109 * t84 + t110 * t86 + t111 * t87;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u32 * t92 * (u19 * (u22 * t30 + u23)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t106 * t99);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t109 * t96 + t110 * t98 + t111 * t99;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t112 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t101 - sin_t36 * t112;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t36 * t112 + d_A_hat_1_d_Phi * t103;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (196 add, 519 mul, 6 div, 2 sqrt, 3 fn; once 81)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 11;
    const DY: usize = 28;
    const DC: usize = 68;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 58];
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
        let u10 = G * u8;
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u11 = reciprocal(v_thr);
        let u12 = u11 * 4.0;
        let u13 = reciprocal(cos_beta);
        let u14 = sin_beta * u13;
        let k = constants[5];
        let u15 = k * 0.5;
        let u16 = reciprocal(R);
        let u17 = u16 * u16;
        let u18 = u16 * u17;
        let EI = constants[4];
        let u19 = EI * u18;
        let u20 = reciprocal(EI) * (R * (R * R));
        let u21 = Phi * Phi;
        let u22 = Phi * u21;
        let u23 = reciprocal(EA);
        let u24 = Phi * 2.0;
        let u25 = omega_P * u4;
        let u26 = omega_P * (m_o * R_P);
        let u27 = omega_P * (flow * R_P);
        let u28 = u8 * u8;
        let u29 = u7 * u28;
        let u30 = G * (EA * 2.0);
        let u31 = u28 * u30;
        let u32 = u8 * u30;
        let u33 = u28 * (EA * EA);
        let u34 = u28 * (m_o * G);
        let u35 = u28 * (2.0 * u6);
        let u36 = u28 * (EA * G);
        let u37 = u11 * u11;
        let u38 = u13 * u13 * (sin_beta * sin_beta);
        let u39 = 2.0 * u14;
        let u40 = 0.5 * (k * sin_beta);
        let u41 = cos_beta * 2.0;
        let u42 = u16 * u18 * (EI * 3.0);
        let u43 = 2.0 * u19;
        let u44 = Phi * u19;
        let u45 = u21 * 3.0;
        let u46 = u23 * u23;
        let u47 = Phi * u15;
        let u48 = Phi * EA;
        let u49 = mu_k * 4.0;
        let u50 = EI * u17;
        let u51 = 2.0 * (u2 * u3) * u50;
        let u52 = u11 * u49;
        let u53 = Phi * u23;
        let u54 = u7 * u8 * u53;
        let u55 = u2 * u44;
        let u56 = Phi * (u3 * u50);
        let u57 = u2 * u22;
        let u58 = u20 * u22;
        let u59 = Phi * u41;
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
            u10,
            omega,
            u12,
            sin_beta,
            u14,
            u15,
            u18,
            u19,
            u20,
            u22,
            u23,
            u24,
            u25,
            u26,
            u27,
            u29,
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
            u49,
            u51,
            u52,
            u53,
            u54,
            u55,
            u56,
            u57,
            u58,
            u59,
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
        let u10 = Real::splat(uniforms[14]);
        let omega = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let sin_beta = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let u18 = Real::splat(uniforms[20]);
        let u19 = Real::splat(uniforms[21]);
        let u20 = Real::splat(uniforms[22]);
        let u22 = Real::splat(uniforms[23]);
        let u23 = Real::splat(uniforms[24]);
        let u24 = Real::splat(uniforms[25]);
        let u25 = Real::splat(uniforms[26]);
        let u26 = Real::splat(uniforms[27]);
        let u27 = Real::splat(uniforms[28]);
        let u29 = Real::splat(uniforms[29]);
        let u31 = Real::splat(uniforms[30]);
        let u32 = Real::splat(uniforms[31]);
        let u33 = Real::splat(uniforms[32]);
        let u34 = Real::splat(uniforms[33]);
        let u35 = Real::splat(uniforms[34]);
        let u36 = Real::splat(uniforms[35]);
        let u37 = Real::splat(uniforms[36]);
        let u38 = Real::splat(uniforms[37]);
        let u39 = Real::splat(uniforms[38]);
        let u40 = Real::splat(uniforms[39]);
        let u41 = Real::splat(uniforms[40]);
        let u42 = Real::splat(uniforms[41]);
        let u43 = Real::splat(uniforms[42]);
        let u44 = Real::splat(uniforms[43]);
        let u45 = Real::splat(uniforms[44]);
        let u46 = Real::splat(uniforms[45]);
        let u47 = Real::splat(uniforms[46]);
        let u48 = Real::splat(uniforms[47]);
        let u49 = Real::splat(uniforms[48]);
        let u51 = Real::splat(uniforms[49]);
        let u52 = Real::splat(uniforms[50]);
        let u53 = Real::splat(uniforms[51]);
        let u54 = Real::splat(uniforms[52]);
        let u55 = Real::splat(uniforms[53]);
        let u56 = Real::splat(uniforms[54]);
        let u57 = Real::splat(uniforms[55]);
        let u58 = Real::splat(uniforms[56]);
        let u59 = Real::splat(uniforms[57]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let t2 = reciprocal(cos_theta);
        let arc = r * t2;
        let T = at.state::<Real>(0);
        let t3 = T + EA;
        let V = u10 * t3;
        let t4 = cos_theta * V;
        let v_t = t4 - omega * r;
        let v_r = V * sin_theta;
        let speed = sqrt(
            v_t * v_t + (Real::splat(0.000000000000000000000001) + v_r * v_r),
        );
        let saturation = tanh(u12 * speed);
        let mu = mu_k * saturation;
        let t5 = reciprocal(speed);
        let cos_gamma = v_r * t5;
        let tan_beta_s = u14 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let t6 = reciprocal(cos_beta + mu * sin_beta_s);
        let t7 = x * t6;
        let p = u15 * t7;
        let t8 = arc * p;
        let t9 = mu * cos_beta_s;
        let sin_gamma = v_t * t5;
        let t10 = sin_theta * cos_gamma + cos_theta * sin_gamma;
        let t11 = t9 * t10 - sin_beta * sin_theta;
        let t = Real::splat(2.0) * (t8 * t11);
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t12 = Real::splat(1.0) - theta_1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t13 = cos_theta * theta_2;
        let t14 = R * t13 + R * sin_theta - x * sin_theta;
        let t15 = t2 * t14;
        let t16 = t + t12 * (u19 * t15);
        let T_hat_1 = Phi * t16;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t17 = R + Real::splat(2.0) * x;
        let t18 = reciprocal(t17);
        let t19 = u20 * t18;
        let t20 = cos_theta * cos_gamma - sin_theta * sin_gamma;
        let t21 = sin_beta * cos_theta - t20 * t9;
        let n = Real::splat(2.0) * (t21 * t8);
        let t22 = t2 * t2;
        let t23 = cos_theta * cos_theta;
        let t24 = sin_theta * sin_theta;
        let t25 = theta_1 * t23 + (t24 + theta_1 * t24);
        let t26 = t22 * (r * t25);
        let t27 = n + T * theta_1 - u19 * t26 - T;
        let theta_3 = t19 * t27;
        let theta_hat_3 = u22 * theta_3;
        at.write_f(3, theta_hat_3);
        let t28 = arc * sin_theta;
        let x_hat_1 = -(Phi * t28);
        at.write_f(4, x_hat_1);
        let t29 = r * arc;
        let t30 = sin_gamma * t29;
        let t31 = mu * t30;
        let t32 = cos_beta_s * t31;
        let t33 = p * t32;
        let M_hat_1 = u24 * t33;
        at.write_f(5, M_hat_1);
        let axial = u15 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t34 = u6 + m_o * T;
        let F = u9 * t34;
        let t35 = EA + F;
        let t36 = reciprocal(t35);
        let t37 = EA * t36;
        let d_L_o_hat_1_d_Phi = arc * t37;
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t38 = speed * mu;
        let t39 = sec_beta_s * t38;
        let t40 = p * t39;
        let loss = Real::splat(2.0) * t40;
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
        let t44 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t28)));
        let t45 = sin_theta * t5;
        let t46 = Real::splat(0.5) * t5;
        let t47 = t46 * (Real::splat(2.0) * v_r);
        let t48 = sin_theta * t47;
        let t49 = Real::splat(1.0) - saturation * saturation;
        let t50 = u52 * t49;
        let t51 = p * (arc * cos_beta_s);
        let t52 = u24 * (t10 * t51);
        let t53 = t5 * t5;
        let t54 = v_t * t53;
        let t55 = cos_theta * arc;
        let t56 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t55)));
        let t57 = v_r * t53;
        let t58 = t50 * t52 - Phi * (t54 * t56 + t57 * t44);
        let t59 = p * (arc * mu);
        let t60 = Real::splat(0.5) * cos_beta_s * (u39 * cos_gamma);
        let t61 = t60 * (cos_beta_s * cos_beta_s);
        let t62 = Phi * (Real::splat(2.0) * (t10 * t59) * t61);
        let t63 = u14 * t57;
        let t64 = u14 * t45 - t48 * t63;
        let t65 = t46 * (Real::splat(2.0) * v_t);
        let t66 = t65 * t63;
        let t67 = Phi * (t5 * t56) + t65 * t58 + t62 * t66;
        let t68 = Phi * (t44 * t45) + t48 * t58 - t62 * t64 + cos_theta * t67;
        let t69 = u24 * (arc * t11);
        let t70 = t6 * t6;
        let t71 = u15 * (t70 * (x * mu));
        let t72 = t61 * (tan_beta_s * t71) - cos_beta_s * t71;
        let t73 = u15 * (t70 * (x * sin_beta_s));
        let t74 = t73 * t50;
        let t75 = t65 * t74 + t72 * t66;
        let t76 = t72 * t64 - t48 * t74 - cos_theta * t75;
        let t77 = u10 * t76;
        let d_T_hat_1_d_T = u10 * t68 + t69 * t77;
        at.write_dy(0, d_T_hat_1_d_T);
        let t78 = u19 * (t22 * (sin_theta * t14))
            + u19 * (t2 * (R * cos_theta - x * cos_theta - R * (theta_2 * sin_theta)));
        let t79 = Phi * t12;
        let t80 = t4 * t5;
        let t81 = t4 * t47;
        let t82 = u14 * t80 - t81 * t63;
        let t83 = t78 * t79 + Phi * (t44 * t80 - n) + t81 * t58 - t62 * t82;
        let t84 = r * sin_theta;
        let t85 = t22 * t84;
        let t86 = u24 * (p * t11);
        let t87 = t72 * t82 - t81 * t74 + v_r * t75;
        let d_T_hat_1_d_theta = t83 + t85 * t86 - v_r * t67 + t69 * t87;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u55 * t15);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = u56 * t12;
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t88 = omega * t67;
        let t89 = t2 * sin_theta;
        let t90 = t2 * t86;
        let t91 = omega * t75;
        let t92 = u15 * t6 - t91;
        let d_T_hat_1_d_x = t88 - (u19 * t89 * t79 + t90) + t69 * t92;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t93 = u58 * t18;
        let t94 = Real::splat(2.0) * (t20 * t51) * t93;
        let t95 = t93 * (t57 * t56 - t54 * t44) - t50 * t94;
        let t96 = Real::splat(2.0) * (t20 * t59) * t61 * t93;
        let t97 = t5 * t44 * t93 + t65 * t95 - t96 * t66;
        let t98 = t48 * t95 - t93 * (t56 * t45) + t96 * t64 + cos_theta * t97;
        let t99 = Real::splat(2.0) * (arc * t21) * t93;
        let d_theta_hat_3_d_T = u10 * t98 - u22 * (t12 * t19) + t99 * t77;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t100 = t93 * (t - t56 * t80)
            - u22 * (t19 * (u43 * t28 + u43 * (t2 * t22 * (t25 * t84))));
        let t101 = Real::splat(2.0) * (p * t21) * t93;
        let d_theta_hat_3_d_theta = t100 + t81 * t95 + t96 * t82 + t85 * t101 - v_r * t97
            + t99 * t87;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t102 = T * t19 - t19 * (u19 * ((t24 + t23) * (r * t22)));
        let d_theta_hat_3_d_theta1 = u57 * t102;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t103 = u19 * (t25 * t22);
        let t104 = t27 * (t19 * t19);
        let t105 = t2 * t101;
        let t106 = omega * t97;
        let d_theta_hat_3_d_x = u22 * (t19 * t103 - u43 * t104) - t105 + t106
            + t99 * t92;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(Phi * r + Phi * (t22 * (r * t24)));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * t89;
        at.write_dy(12, d_x_hat_1_d_x);
        let t107 = u24 * (p * (cos_beta_s * t30));
        let t108 = u24 * (p * (cos_beta_s * (mu * t29)));
        let t109 = t107 * t50 - t54 * t108;
        let t110 = u24 * (p * t31) * t61;
        let t111 = t5 * t108 + t65 * t109 + t110 * t66;
        let t112 = t48 * t109 - t110 * t64 + cos_theta * t111;
        let t113 = u24 * t32;
        let d_M_hat_1_d_T = u10 * t112 + t113 * t77;
        at.write_dy(13, d_M_hat_1_d_T);
        let t114 = u24 * (p * (cos_beta_s * (mu * (r * sin_gamma))));
        let d_M_hat_1_d_theta = t81 * t109 - t110 * t82 + t85 * t114 - v_r * t111
            + t113 * t87;
        at.write_dy(14, d_M_hat_1_d_theta);
        let t115 = omega * t111
            - (u24 * (p * (cos_beta_s * (mu * (arc * sin_gamma)))) + t2 * t114);
        let d_M_hat_1_d_x = t115 + t113 * t92;
        at.write_dy(15, d_M_hat_1_d_x);
        let t116 = u47 * x;
        let d_A_hat_1_d_theta = t85 * t116;
        at.write_dy(16, d_A_hat_1_d_theta);
        let t117 = u47 * arc;
        let d_A_hat_1_d_R = t2 * t116;
        let d_A_hat_1_d_x = t117 - d_A_hat_1_d_R;
        at.write_dy(17, d_A_hat_1_d_x);
        let t118 = arc * (t37 * t37);
        let d_L_o_hat_1_d_T = -(u54 * t118);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t119 = u48 * t36;
        let d_L_o_hat_1_d_theta = t85 * t119;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t2 * t119;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t120 = Phi * arc;
        let t121 = Real::splat(2.0) * (p * (speed * sec_beta_s)) * t120;
        let t122 = Real::splat(2.0) * (p * (mu * sec_beta_s)) * t120 + t50 * t121;
        let t123 = t120 * (t60 * (Real::splat(2.0) * (p * t38)));
        let t124 = t65 * t122 - t123 * t66;
        let t125 = t48 * t122 + t123 * t64 + cos_theta * t124;
        let t126 = Real::splat(2.0) * t39 * t120;
        let d_W_hat_1_d_T = u10 * t125 + t126 * t77;
        at.write_dy(21, d_W_hat_1_d_T);
        let t127 = u24 * t40;
        let d_W_hat_1_d_theta = t81 * t122 + t123 * t82 + t85 * t127 - v_r * t124
            + t126 * t87;
        at.write_dy(22, d_W_hat_1_d_theta);
        let t128 = omega * t124 - t2 * t127;
        let d_W_hat_1_d_x = t128 + t126 * t92;
        at.write_dy(23, d_W_hat_1_d_x);
        let t129 = r * cos_t41;
        let t130 = t116 * t129;
        let d_A_x_hat_1_d_theta = t85 * t130;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let t131 = A_hat_1 * cos_t41;
        let t132 = t2 * t130;
        let d_A_x_hat_1_d_x = t129 * t117 - t131 - t132;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t133 = r * sin_t41;
        let t134 = t116 * t133;
        let d_A_y_hat_1_d_theta = t85 * t134;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let t135 = A_hat_1 * sin_t41;
        let t136 = t2 * t134;
        let d_A_y_hat_1_d_x = t133 * t117 - t135 - t136;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t137 = u3 * theta1;
        let d_T_hat_1_d_Phi = t16 + t137 * (u44 * t15) - t79 * (u51 * theta2);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t138 = omega_P * r;
        let t139 = t138 * t75;
        let d_T_hat_1_d_sigma = t69 * t139 - t138 * t67;
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t140 = u8 * t3 + u35 * t3;
        let t141 = u26 * t140;
        let t142 = t141 * t76;
        let d_T_hat_1_d_flow = t141 * t68 + t69 * t142;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u45 * theta_3 - u22 * (t137 * t102);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = t99 * t139 - t138 * t97;
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t141 * t98 + t99 * t142;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t28;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let d_M_hat_1_d_Phi = Real::splat(2.0) * t33;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = t113 * t139 - t138 * t111;
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t141 * t112 + t113 * t142;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t143 = u53 * t118;
        let t144 = (u31 * t34 + u32) * t143;
        let d_L_o_hat_1_d_flow = -(u26 * t144);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = t126 * t139 - t138 * t124;
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t141 * t125 + t126 * t142;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t145 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t129 - sin_t41 * t145;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t41 * t145 + d_A_hat_1_d_Phi * t133;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let t146 = u10 - u34 * t3;
        let t147 = t146 * t76;
        let d_T_hat_1_d_EA = t146 * t68 + t69 * t147;
        at.write_dc(18, d_T_hat_1_d_EA);
        let d_T_hat_1_d_EI = u18 * t15 * t79;
        at.write_dc(19, d_T_hat_1_d_EI);
        let t148 = Real::splat(0.5) * t7;
        let d_T_hat_1_d_k = t148 * t69;
        at.write_dc(20, d_T_hat_1_d_k);
        let t149 = u27 * t140 - u36 * t3;
        let t150 = t149 * t76;
        let d_T_hat_1_d_m_o = t149 * t68 + t69 * t150;
        at.write_dc(21, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_R = t90 - (u42 * t15 - u19 * (t2 * (sin_theta + t13))) * t79
            - t88 + t69 * t91;
        at.write_dc(22, d_T_hat_1_d_R);
        let t151 = u25 * t140;
        let t152 = t151 * t76;
        let d_T_hat_1_d_R_P = t151 * t68 + t69 * t152;
        at.write_dc(23, d_T_hat_1_d_R_P);
        let t153 = cos_gamma + u38 * cos_gamma;
        let t154 = u40 * (x * t70) + t153 * t72;
        let d_T_hat_1_d_beta = t69 * t154 - (u59 * (p * t28) + t153 * t62);
        at.write_dc(24, d_T_hat_1_d_beta);
        let t155 = saturation * t73;
        let d_T_hat_1_d_mu_k = saturation * t52 - t69 * t155;
        at.write_dc(25, d_T_hat_1_d_mu_k);
        let t156 = u37 * speed * (u49 * t49);
        let t157 = t73 * t156;
        let d_T_hat_1_d_v_thr = t69 * t157 - t156 * t52;
        at.write_dc(26, d_T_hat_1_d_v_thr);
        let t158 = u5 * t140;
        let t159 = sigma * r;
        let t160 = t159 * t75 + t158 * t76;
        let d_T_hat_1_d_omega_P = t158 * t68 - t159 * t67 + t69 * t160;
        at.write_dc(27, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t146 * t98 + t99 * t147;
        at.write_dc(28, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(u22 * (u18 * t17 * t104 + t19 * (u18 * t26)));
        at.write_dc(29, d_theta_hat_3_d_EI);
        let d_theta_hat_3_d_k = t148 * t99;
        at.write_dc(30, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = t149 * t98 + t99 * t150;
        at.write_dc(31, d_theta_hat_3_d_m_o);
        let t161 = u22 * ((u42 * t17 - u19) * t104 + t19 * (u42 * t26 - t103)) + t105;
        let d_theta_hat_3_d_R = t161 - t106 + t99 * t91;
        at.write_dc(32, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = t151 * t98 + t99 * t152;
        at.write_dc(33, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_beta = u41 * (p * t55) * t93 + t153 * t96 + t99 * t154;
        at.write_dc(34, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = -(saturation * t94 + t99 * t155);
        at.write_dc(35, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = t156 * t94 + t99 * t157;
        at.write_dc(36, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = t158 * t98 - t159 * t97 + t99 * t160;
        at.write_dc(37, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(38, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t146 * t112 + t113 * t147;
        at.write_dc(39, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = t148 * t113;
        at.write_dc(40, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = t149 * t112 + t113 * t150;
        at.write_dc(41, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = t113 * t91 - t115;
        at.write_dc(42, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = t151 * t112 + t113 * t152;
        at.write_dc(43, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t113 * t154 - t153 * t110;
        at.write_dc(44, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = saturation * t107 - t113 * t155;
        at.write_dc(45, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = t113 * t157 - t107 * t156;
        at.write_dc(46, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = t158 * t112 - t159 * t111 + t113 * t160;
        at.write_dc(47, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = Real::splat(0.5) * x * t120;
        at.write_dc(48, d_A_hat_1_d_k);
        at.write_dc(49, d_A_hat_1_d_R);
        let t162 = (u23 - u46 * t35) * (Phi * t118) + (u8 * t34 - u29 * t34) * t143;
        let d_L_o_hat_1_d_EA = -t162;
        at.write_dc(50, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u33 * t34) * t143 + u27 * t144);
        at.write_dc(51, d_L_o_hat_1_d_m_o);
        at.write_dc(52, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u25 * t144);
        at.write_dc(53, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t144);
        at.write_dc(54, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t146 * t125 + t126 * t147;
        at.write_dc(55, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = t148 * t126;
        at.write_dc(56, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = t149 * t125 + t126 * t150;
        at.write_dc(57, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t126 * t91 - t128;
        at.write_dc(58, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = t151 * t125 + t126 * t152;
        at.write_dc(59, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = t153 * t123 + t126 * t154;
        at.write_dc(60, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = saturation * t121 - t126 * t155;
        at.write_dc(61, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = t126 * t157 - t156 * t121;
        at.write_dc(62, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = t158 * t125 - t159 * t124 + t126 * t160;
        at.write_dc(63, d_W_hat_1_d_omega_P);
        let d_A_x_hat_1_d_k = t129 * d_A_hat_1_d_k;
        at.write_dc(64, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t131 + t132;
        at.write_dc(65, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t133 * d_A_hat_1_d_k;
        at.write_dc(66, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t135 + t136;
        at.write_dc(67, d_A_y_hat_1_d_R);
    }
}
///Derived fields. (13 add, 45 mul, 5 div, 2 sqrt, 4 fn; once 24)
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
        let u7 = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u8 = reciprocal(v_thr) * 4.0;
        let u9 = reciprocal(cos_beta);
        let u10 = sin_beta * u9;
        let k = constants[5];
        let u11 = k * 0.5;
        let u12 = reciprocal(R);
        let u13 = EI * (u12 * (u12 * u12));
        let u14 = 2.0 * (u9 * u9);
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
            u7,
            omega,
            u8,
            u10,
            u11,
            u13,
            u14,
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
        let u7 = Real::splat(uniforms[10]);
        let omega = Real::splat(uniforms[11]);
        let u8 = Real::splat(uniforms[12]);
        let u10 = Real::splat(uniforms[13]);
        let u11 = Real::splat(uniforms[14]);
        let u13 = Real::splat(uniforms[15]);
        let u14 = Real::splat(uniforms[16]);
        let T = at.state::<Real>(0);
        let F = u6 * (u4 + m_o * T);
        at.write_field(0, F);
        let V = u7 * (T + EA);
        at.write_field(1, V);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        at.write_field(2, v_r);
        let x = at.state::<Real>(4);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        at.write_field(3, v_t);
        let t2 = v_t * v_t;
        let t3 = v_r * v_r;
        let speed = sqrt(t2 + (Real::splat(0.000000000000000000000001) + t3));
        at.write_field(4, speed);
        let gamma_a = angle(v_r, v_t);
        let gamma = turn(gamma_a);
        at.write_field(5, gamma);
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let t4 = reciprocal(speed);
        let cos_gamma = v_r * t4;
        let tan_beta_s = u10 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let p = u11 * (x * reciprocal(cos_beta + mu * sin_beta_s));
        at.write_field(7, p);
        let beta_s = angle(cos_beta_s, sin_beta_s);
        at.write_field(8, beta_s);
        let t5 = reciprocal(cos_theta);
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let Q = -(u13
            * (t5 * (R * (cos_theta * theta_2) + R * sin_theta - x * sin_theta)));
        at.write_field(9, Q);
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let M_b = EI * (reciprocal(r) * (cos_theta * (Real::splat(1.0) - theta_1)));
        at.write_field(10, M_b);
        let axial = u11 * x;
        at.write_field(11, axial);
        let loss = Real::splat(2.0) * (p * (sec_beta_s * (speed * mu)));
        at.write_field(12, loss);
        let loss_radial = u14 * (p * (cos_beta_s * (mu * (t3 * t4))));
        at.write_field(13, loss_radial);
        let loss_tangential = Real::splat(2.0) * (p * (cos_beta_s * (mu * (t2 * t4))));
        at.write_field(14, loss_tangential);
        let arc = r * t5;
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
