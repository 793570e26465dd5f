// contact_full_viscous_coulomb: The belt in a groove: full shear, viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p eqgen -- write` writes it anew.
// Operations per point, and once a batch:
//   value: 29 add, 91 mul, 7 div, 2 sqrt, 2 fn; once 21
//   jacobian: 139 add, 423 mul, 7 div, 2 sqrt, 2 fn; once 45
//   full: 207 add, 567 mul, 7 div, 2 sqrt, 2 fn; once 64
//   fields: 13 add, 46 mul, 5 div, 2 sqrt, 3 fn; once 19

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
///Right-hand side and integrands. (29 add, 91 mul, 7 div, 2 sqrt, 2 fn; once 21)
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
        let u7 = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u8 = reciprocal(v_thr);
        let u9 = sin_beta * reciprocal(cos_beta);
        let k = constants[5];
        let u10 = k * 0.5;
        let u11 = reciprocal(EI);
        let u12 = Phi * (Phi * Phi);
        let u13 = Phi * 2.0;
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
            u7,
            omega,
            u8,
            sin_beta,
            u9,
            u10,
            u11,
            u12,
            u13,
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
        let u7 = Real::splat(uniforms[11]);
        let omega = Real::splat(uniforms[12]);
        let u8 = Real::splat(uniforms[13]);
        let sin_beta = Real::splat(uniforms[14]);
        let u9 = Real::splat(uniforms[15]);
        let u10 = Real::splat(uniforms[16]);
        let u11 = Real::splat(uniforms[17]);
        let u12 = Real::splat(uniforms[18]);
        let u13 = Real::splat(uniforms[19]);
        let x = at.state::<Real>(4);
        let r = R - x;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let arc = r * reciprocal(cos_theta);
        let T = at.state::<Real>(0);
        let V = u7 * (T + EA);
        let v_t = cos_theta * V - omega * r;
        let v_r = V * sin_theta;
        let speed = sqrt(
            v_t * v_t + (Real::splat(0.000000000000000000000001) + v_r * v_r),
        );
        let slip = u8 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t2 = reciprocal(speed);
        let cos_gamma = v_r * t2;
        let tan_beta_s = u9 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let p = u10 * (x * reciprocal(cos_beta + mu * sin_beta_s));
        let t3 = arc * p;
        let t4 = mu * cos_beta_s;
        let sin_gamma = v_t * t2;
        let t = Real::splat(2.0)
            * (t3
                * (t4 * (sin_theta * cos_gamma + cos_theta * sin_gamma)
                    - sin_beta * sin_theta));
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t5 = theta_1 * theta_1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t6 = cos_theta * theta_2;
        let t7 = reciprocal(r);
        let t8 = t7 * t7;
        let Q = EI * ((sin_theta * t5 - t6 - sin_theta) * (cos_theta * t8));
        let T_hat_1 = Phi * (t - (Real::splat(1.0) - theta_1) * Q);
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t9 = cos_theta * cos_theta;
        let n = Real::splat(2.0)
            * ((sin_beta * cos_theta
                - (cos_theta * cos_gamma - sin_theta * sin_gamma) * t4) * t3);
        let t10 = sin_theta * sin_theta;
        let t11 = theta_1 * t5;
        let t12 = t10 * t11 + (theta_1 * t9 + Real::splat(2.0) * (t5 * t10))
            - Real::splat(4.0) * (sin_theta * (theta_2 * (cos_theta * theta_1)));
        let t13 = t12 - theta_1 * t10 - Real::splat(2.0) * (sin_theta * t6) - t9 * t11
            - Real::splat(2.0) * t10;
        let theta_3 = u11 * reciprocal(t8 * t9)
            * (n + T * theta_1 - EI * (t8 * t13) - T);
        let theta_hat_3 = u12 * theta_3;
        at.write_f(3, theta_hat_3);
        let x_hat_1 = -(Phi * (arc * sin_theta));
        at.write_f(4, x_hat_1);
        let M_hat_1 = u13 * (p * (cos_beta_s * (mu * (sin_gamma * (r * arc)))));
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
        let t14 = Phi * s;
        let (sin_t14, cos_t14) = sin_cos(t14);
        let t16 = r * A_hat_1;
        let A_x_hat_1 = cos_t14 * t16;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t16 * sin_t14;
        at.write_f(10, A_y_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and usual constants. (139 add, 423 mul, 7 div, 2 sqrt, 2 fn; once 45)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 11;
    const DY: usize = 29;
    const DC: usize = 18;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 38];
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
        let u8 = G * u6;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u9 = reciprocal(v_thr);
        let u10 = sin_beta * reciprocal(cos_beta);
        let k = constants[5];
        let u11 = k * 0.5;
        let u12 = reciprocal(EI);
        let u13 = Phi * Phi;
        let u14 = Phi * u13;
        let u15 = Phi * 2.0;
        let u16 = 2.0 * (u2 * u3);
        let u17 = omega_P * (m_o * R_P);
        let u18 = u6 * u6;
        let u19 = G * (EA * 2.0);
        let u20 = u18 * u19;
        let u21 = u6 * u19;
        let u22 = u18 * (2.0 * u4);
        let u23 = 2.0 * u10;
        let u24 = EI * 2.0;
        let u25 = Phi * EI;
        let u26 = u13 * 3.0;
        let u27 = Phi * u11;
        let u28 = Phi * EA;
        let u29 = mu_k * u9;
        let u30 = Phi * reciprocal(EA);
        let u31 = u5 * u6 * u30;
        let u32 = EI * u3;
        let u33 = u2 * u14;
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
            u8,
            omega,
            u9,
            sin_beta,
            u10,
            u11,
            u12,
            u14,
            u15,
            u16,
            u17,
            u20,
            u21,
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
            u33,
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
        let u8 = Real::splat(uniforms[13]);
        let omega = Real::splat(uniforms[14]);
        let u9 = Real::splat(uniforms[15]);
        let sin_beta = Real::splat(uniforms[16]);
        let u10 = Real::splat(uniforms[17]);
        let u11 = Real::splat(uniforms[18]);
        let u12 = Real::splat(uniforms[19]);
        let u14 = Real::splat(uniforms[20]);
        let u15 = Real::splat(uniforms[21]);
        let u16 = Real::splat(uniforms[22]);
        let u17 = Real::splat(uniforms[23]);
        let u20 = Real::splat(uniforms[24]);
        let u21 = Real::splat(uniforms[25]);
        let u22 = Real::splat(uniforms[26]);
        let u23 = Real::splat(uniforms[27]);
        let u24 = Real::splat(uniforms[28]);
        let u25 = Real::splat(uniforms[29]);
        let u26 = Real::splat(uniforms[30]);
        let u27 = Real::splat(uniforms[31]);
        let u28 = Real::splat(uniforms[32]);
        let u29 = Real::splat(uniforms[33]);
        let u30 = Real::splat(uniforms[34]);
        let u31 = Real::splat(uniforms[35]);
        let u32 = Real::splat(uniforms[36]);
        let u33 = Real::splat(uniforms[37]);
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
        let slip = u9 * speed;
        let saturation = saturate(slip);
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
        let t12 = theta_1 * theta_1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t13 = cos_theta * theta_2;
        let t14 = sin_theta * t12 - t13 - sin_theta;
        let t15 = reciprocal(r);
        let t16 = t15 * t15;
        let t17 = cos_theta * t16;
        let t18 = t14 * t17;
        let Q = EI * t18;
        let t19 = t - t11 * Q;
        let T_hat_1 = Phi * t19;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t20 = cos_theta * cos_theta;
        let t21 = t16 * t20;
        let t22 = u12 * reciprocal(t21);
        let t23 = cos_theta * cos_gamma - sin_theta * sin_gamma;
        let t24 = sin_beta * cos_theta - t23 * t8;
        let t25 = t24 * t7;
        let n = Real::splat(2.0) * t25;
        let t26 = sin_theta * sin_theta;
        let t27 = theta_1 * t12;
        let t28 = t12 * t26;
        let t29 = cos_theta * theta_1;
        let t30 = t26 * t27 + (theta_1 * t20 + Real::splat(2.0) * t28)
            - Real::splat(4.0) * (sin_theta * (theta_2 * t29));
        let t31 = theta_1 * t26;
        let t32 = sin_theta * t13;
        let t33 = t30 - t31 - Real::splat(2.0) * t32 - t20 * t27
            - Real::splat(2.0) * t26;
        let t34 = n + T * theta_1 - EI * (t16 * t33) - T;
        let theta_3 = t22 * t34;
        let theta_hat_3 = u14 * theta_3;
        at.write_f(3, theta_hat_3);
        let t35 = arc * sin_theta;
        let x_hat_1 = -(Phi * t35);
        at.write_f(4, x_hat_1);
        let t36 = r * arc;
        let t37 = sin_gamma * t36;
        let t38 = mu * t37;
        let t39 = cos_beta_s * t38;
        let t40 = p * t39;
        let M_hat_1 = u15 * t40;
        at.write_f(5, M_hat_1);
        let axial = u11 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t41 = u4 + m_o * T;
        let F = u7 * t41;
        let t42 = reciprocal(EA + F);
        let t43 = EA * t42;
        let d_L_o_hat_1_d_Phi = arc * t43;
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t44 = speed * mu;
        let t45 = sec_beta_s * t44;
        let t46 = p * t45;
        let loss = Real::splat(2.0) * t46;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t47 = Phi * s;
        let (sin_t47, cos_t47) = sin_cos(t47);
        let t49 = r * A_hat_1;
        let A_x_hat_1 = cos_t47 * t49;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t49 * sin_t47;
        at.write_f(10, A_y_hat_1);
        let t50 = u8 * sin_theta;
        let t51 = t5 * t50;
        let t52 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t35)));
        let t53 = p * (arc * mu);
        let t54 = u10 * (Real::splat(0.5) * cos_beta_s * (u23 * cos_gamma));
        let t55 = cos_beta_s * cos_beta_s * t54;
        let t56 = t6 * t6;
        let t57 = u11 * (t56 * (x * mu));
        let t58 = t55 * (tan_beta_s * t57) - t57 * (u10 * cos_beta_s);
        let t59 = u15 * (arc * t10);
        let t60 = Phi * (t52 - Real::splat(2.0) * (t9 * t53) * t55) + t58 * t59;
        let t61 = Real::splat(0.5) * t5;
        let t62 = t61 * (Real::splat(2.0) * v_r);
        let t63 = t62 * t50;
        let t64 = p * (arc * cos_beta_s);
        let t65 = u29 * below_one(slip);
        let t66 = t5 * t5;
        let t67 = v_t * t66;
        let t68 = Real::splat(2.0) * (p * (cos_beta_s * (mu * (cos_theta * arc))));
        let t69 = u11 * (t56 * (x * sin_beta_s)) * t65;
        let t70 = v_r * t66;
        let t71 = Phi * (Real::splat(2.0) * (t9 * t64) * t65 - t67 * t68) - t69 * t59
            - t70 * t60;
        let t72 = u8 * cos_theta;
        let t73 = t61 * (Real::splat(2.0) * v_t);
        let t74 = Phi * (t5 * t68) + t73 * t71;
        let d_T_hat_1_d_T = t51 * t60 + t63 * t71 + t72 * t74;
        at.write_dy(0, d_T_hat_1_d_T);
        let t75 = t2 * t2;
        let t76 = t75 * (r * sin_theta);
        let t77 = u15 * (p * t10);
        let t78 = EI * (t17 * (theta_2 * sin_theta + cos_theta * t12 - cos_theta))
            - EI * (t14 * (sin_theta * t16));
        let t79 = Phi * t11;
        let t80 = t4 * t5;
        let t81 = t4 * t62;
        let t82 = t76 * t77 - (t78 * t79 + u15 * t25) + t80 * t60 + t81 * t71;
        let d_T_hat_1_d_theta = t82 - v_r * t74;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t83 = sin_theta * t29;
        let t84 = u25 * t18 - u24 * (t16 * t83) * t79;
        let d_T_hat_1_d_theta1 = u2 * t84;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = t79 * (u32 * t21);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t85 = u11 * t6;
        let t86 = t15 * t16;
        let d_T_hat_1_d_x = t85 * t59 - u24 * (t86 * (cos_theta * t14)) * t79 - t2 * t77
            + omega * t74;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t87 = u14 * (t22 * (Real::splat(2.0) * (arc * t24)));
        let t88 = u14 * (t22 * (Real::splat(2.0) * (t23 * t53) * t55 - t68)) + t58 * t87;
        let t89 = u14 * (t22 * (Real::splat(2.0) * (t23 * t64) * t65 + t67 * t52))
            + t69 * t87;
        let t90 = t89 + t70 * t88;
        let t91 = u14 * (t22 * (t5 * t52)) - t73 * t90;
        let d_theta_hat_3_d_T = t51 * t88 - u14 * (t11 * t22) - t63 * t90 + t72 * t91;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t92 = cos_theta * sin_theta;
        let t93 = t34 * (t22 * t22);
        let t94 = theta_1 * theta_2;
        let t95 = Real::splat(4.0) * (t27 * t92)
            + (Real::splat(4.0) * (t12 * t92)
                + (Real::splat(4.0) * (t26 * t94) + Real::splat(2.0) * (theta_2 * t26)));
        let t96 = Real::splat(4.0) * t83;
        let t97 = t95 - Real::splat(4.0) * (t20 * t94) - t96
            - Real::splat(2.0) * (theta_2 * t20) - Real::splat(4.0) * t92;
        let t98 = u24 * (t16 * t92) * t93 - t22 * (EI * (t16 * t97)) + t * t22;
        let t99 = u14 * (t22 * (Real::splat(2.0) * (p * t24)));
        let d_theta_hat_3_d_theta = u14 * t98 + t76 * t99 + t80 * t88 - t81 * t90
            - v_r * t91;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t100 = Real::splat(3.0) * t28 + (t20 + Real::splat(4.0) * t31)
            - Real::splat(4.0) * t32 - Real::splat(3.0) * (t12 * t20);
        let t101 = T * t22 - t22 * (EI * (t16 * (t100 - t26)));
        let d_theta_hat_3_d_theta1 = u33 * t101;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t102 = t16 * (t96 + Real::splat(2.0) * t92);
        let d_theta_hat_3_d_theta2 = u14 * (t22 * (u32 * t102));
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t103 = t85 * t87
            - u14 * (u24 * (t20 * t86) * t93 + t22 * (u24 * (t33 * t86)));
        let d_theta_hat_3_d_x = t103 - t2 * t99 + omega * t91;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(Phi * r + Phi * (t75 * (r * t26)));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * (t2 * sin_theta);
        at.write_dy(13, d_x_hat_1_d_x);
        let t104 = u15 * t39;
        let t105 = t104 * t58 - u15 * (p * t38) * t55;
        let t106 = u15 * (p * (cos_beta_s * (mu * t36)));
        let t107 = u15 * (p * (cos_beta_s * t37)) * t65 - t67 * t106 - t104 * t69
            - t70 * t105;
        let t108 = t5 * t106 + t73 * t107;
        let d_M_hat_1_d_T = t51 * t105 + t63 * t107 + t72 * t108;
        at.write_dy(14, d_M_hat_1_d_T);
        let t109 = u15 * (p * (cos_beta_s * (mu * (r * sin_gamma))));
        let d_M_hat_1_d_theta = t76 * t109 + t80 * t105 + t81 * t107 - v_r * t108;
        at.write_dy(15, d_M_hat_1_d_theta);
        let t110 = t85 * t104 - u15 * (p * (cos_beta_s * (mu * (arc * sin_gamma))))
            - t2 * t109;
        let d_M_hat_1_d_x = t110 + omega * t108;
        at.write_dy(16, d_M_hat_1_d_x);
        let t111 = u27 * x;
        let d_A_hat_1_d_theta = t76 * t111;
        at.write_dy(17, d_A_hat_1_d_theta);
        let t112 = u27 * arc;
        let d_A_hat_1_d_x = t112 - t2 * t111;
        at.write_dy(18, d_A_hat_1_d_x);
        let t113 = arc * (t43 * t43);
        let d_L_o_hat_1_d_T = -(u31 * t113);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t114 = u28 * t42;
        let d_L_o_hat_1_d_theta = t76 * t114;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t2 * t114);
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t115 = Phi * arc;
        let t116 = Real::splat(2.0) * t45 * t115;
        let t117 = t115 * (Real::splat(2.0) * (p * t44) * t54) + t58 * t116;
        let t118 = Real::splat(2.0) * (p * (mu * sec_beta_s)) * t115
            + t65 * (Real::splat(2.0) * (p * (speed * sec_beta_s)) * t115);
        let t119 = t118 - t116 * t69 - t70 * t117;
        let t120 = t73 * t119;
        let d_W_hat_1_d_T = t51 * t117 + t63 * t119 + t72 * t120;
        at.write_dy(22, d_W_hat_1_d_T);
        let t121 = u15 * t46;
        let d_W_hat_1_d_theta = t76 * t121 + t80 * t117 + t81 * t119 - v_r * t120;
        at.write_dy(23, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = t85 * t116 - t2 * t121 + omega * t120;
        at.write_dy(24, d_W_hat_1_d_x);
        let t122 = r * cos_t47;
        let t123 = t111 * t122;
        let d_A_x_hat_1_d_theta = t76 * t123;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t122 * t112 - A_hat_1 * cos_t47 - t2 * t123;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t124 = r * sin_t47;
        let t125 = t111 * t124;
        let d_A_y_hat_1_d_theta = t76 * t125;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t124 * t112 - A_hat_1 * sin_t47 - t2 * t125;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t126 = u16 * theta2;
        let t127 = u3 * theta1;
        let d_T_hat_1_d_Phi = t19 - t79 * (EI * t21 * t126) - t127 * t84;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t128 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t128 * t74);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t129 = u17 * (u6 * t3 + u22 * t3);
        let t130 = sin_theta * t129;
        let t131 = t5 * t130;
        let t132 = t62 * t130;
        let t133 = cos_theta * t129;
        let d_T_hat_1_d_flow = t131 * t60 + t132 * t71 + t133 * t74;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u26 * theta_3
            - u14 * (t22 * (t126 * (EI * t102)) + t127 * t101);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(t128 * t91);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t131 * t88 - t132 * t90 + t133 * t91;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t35;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let d_M_hat_1_d_Phi = Real::splat(2.0) * t40;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t128 * t108);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t131 * t105 + t132 * t107 + t133 * t108;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u30 * t113 * (u17 * (u20 * t41 + u21)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t128 * t120);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t131 * t117 + t132 * t119 + t133 * t120;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t134 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t122 - sin_t47 * t134;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t47 * t134 + d_A_hat_1_d_Phi * t124;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (207 add, 567 mul, 7 div, 2 sqrt, 2 fn; once 64)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 11;
    const DY: usize = 29;
    const DC: usize = 68;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 53];
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
        let u10 = G * u8;
        let omega = sigma * omega_P;
        let v_thr = constants[11];
        let u11 = reciprocal(v_thr);
        let u12 = reciprocal(cos_beta);
        let u13 = sin_beta * u12;
        let k = constants[5];
        let u14 = k * 0.5;
        let u15 = reciprocal(EI);
        let u16 = Phi * Phi;
        let u17 = Phi * u16;
        let u18 = reciprocal(EA);
        let u19 = Phi * 2.0;
        let u20 = 2.0 * (u2 * u3);
        let u21 = omega_P * u4;
        let u22 = omega_P * (m_o * R_P);
        let u23 = omega_P * (flow * R_P);
        let u24 = u8 * u8;
        let u25 = u7 * u24;
        let u26 = G * (EA * 2.0);
        let u27 = u24 * u26;
        let u28 = u8 * u26;
        let u29 = u24 * (EA * EA);
        let u30 = u24 * (m_o * G);
        let u31 = u24 * (2.0 * u6);
        let u32 = u24 * (EA * G);
        let u33 = u11 * u11;
        let u34 = u12 * u12 * (sin_beta * sin_beta);
        let u35 = 2.0 * u13;
        let u36 = 0.5 * (k * sin_beta);
        let u37 = cos_beta * 2.0;
        let u38 = EI * 2.0;
        let u39 = Phi * EI;
        let u40 = u16 * 3.0;
        let u41 = u18 * u18;
        let u42 = Phi * u14;
        let u43 = Phi * EA;
        let u44 = mu_k * u11;
        let u45 = Phi * u18;
        let u46 = EI * u3;
        let u47 = u7 * u8 * u45;
        let u48 = EI * u2;
        let u49 = Phi * u37;
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
            u10,
            omega,
            u11,
            sin_beta,
            u13,
            u14,
            u15,
            u17,
            u18,
            u19,
            u20,
            u21,
            u22,
            u23,
            u25,
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
            u48,
            u49,
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
        let u10 = Real::splat(uniforms[15]);
        let omega = Real::splat(uniforms[16]);
        let u11 = Real::splat(uniforms[17]);
        let sin_beta = Real::splat(uniforms[18]);
        let u13 = Real::splat(uniforms[19]);
        let u14 = Real::splat(uniforms[20]);
        let u15 = Real::splat(uniforms[21]);
        let u17 = Real::splat(uniforms[22]);
        let u18 = Real::splat(uniforms[23]);
        let u19 = Real::splat(uniforms[24]);
        let u20 = Real::splat(uniforms[25]);
        let u21 = Real::splat(uniforms[26]);
        let u22 = Real::splat(uniforms[27]);
        let u23 = Real::splat(uniforms[28]);
        let u25 = Real::splat(uniforms[29]);
        let u27 = Real::splat(uniforms[30]);
        let u28 = Real::splat(uniforms[31]);
        let u29 = Real::splat(uniforms[32]);
        let u30 = Real::splat(uniforms[33]);
        let u31 = Real::splat(uniforms[34]);
        let u32 = Real::splat(uniforms[35]);
        let u33 = Real::splat(uniforms[36]);
        let u34 = Real::splat(uniforms[37]);
        let u35 = Real::splat(uniforms[38]);
        let u36 = Real::splat(uniforms[39]);
        let u37 = Real::splat(uniforms[40]);
        let u38 = Real::splat(uniforms[41]);
        let u39 = Real::splat(uniforms[42]);
        let u40 = Real::splat(uniforms[43]);
        let u41 = Real::splat(uniforms[44]);
        let u42 = Real::splat(uniforms[45]);
        let u43 = Real::splat(uniforms[46]);
        let u44 = Real::splat(uniforms[47]);
        let u45 = Real::splat(uniforms[48]);
        let u46 = Real::splat(uniforms[49]);
        let u47 = Real::splat(uniforms[50]);
        let u48 = Real::splat(uniforms[51]);
        let u49 = Real::splat(uniforms[52]);
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
        let slip = u11 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t5 = reciprocal(speed);
        let cos_gamma = v_r * t5;
        let tan_beta_s = u13 * cos_gamma;
        let sec_beta_s = sqrt(Real::splat(1.0) + tan_beta_s * tan_beta_s);
        let cos_beta_s = reciprocal(sec_beta_s);
        let sin_beta_s = tan_beta_s * cos_beta_s;
        let t6 = reciprocal(cos_beta + mu * sin_beta_s);
        let t7 = x * t6;
        let p = u14 * t7;
        let t8 = arc * p;
        let t9 = mu * cos_beta_s;
        let sin_gamma = v_t * t5;
        let t10 = sin_theta * cos_gamma + cos_theta * sin_gamma;
        let t11 = t9 * t10 - sin_beta * sin_theta;
        let t = Real::splat(2.0) * (t8 * t11);
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let t12 = Real::splat(1.0) - theta_1;
        let t13 = theta_1 * theta_1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t14 = cos_theta * theta_2;
        let t15 = sin_theta * t13 - t14 - sin_theta;
        let t16 = reciprocal(r);
        let t17 = t16 * t16;
        let t18 = cos_theta * t17;
        let t19 = t15 * t18;
        let Q = EI * t19;
        let t20 = t - t12 * Q;
        let T_hat_1 = Phi * t20;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t21 = cos_theta * cos_theta;
        let t22 = t17 * t21;
        let t23 = u15 * reciprocal(t22);
        let t24 = cos_theta * cos_gamma - sin_theta * sin_gamma;
        let t25 = sin_beta * cos_theta - t24 * t9;
        let n = Real::splat(2.0) * (t25 * t8);
        let t26 = sin_theta * sin_theta;
        let t27 = theta_1 * t13;
        let t28 = t13 * t26;
        let t29 = cos_theta * theta_1;
        let t30 = t26 * t27 + (theta_1 * t21 + Real::splat(2.0) * t28)
            - Real::splat(4.0) * (sin_theta * (theta_2 * t29));
        let t31 = theta_1 * t26;
        let t32 = sin_theta * t14;
        let t33 = t30 - t31 - Real::splat(2.0) * t32 - t21 * t27
            - Real::splat(2.0) * t26;
        let t34 = t17 * t33;
        let t35 = n + T * theta_1 - EI * t34 - T;
        let theta_3 = t23 * t35;
        let theta_hat_3 = u17 * theta_3;
        at.write_f(3, theta_hat_3);
        let t36 = arc * sin_theta;
        let x_hat_1 = -(Phi * t36);
        at.write_f(4, x_hat_1);
        let t37 = r * arc;
        let t38 = sin_gamma * t37;
        let t39 = mu * t38;
        let t40 = cos_beta_s * t39;
        let t41 = p * t40;
        let M_hat_1 = u19 * t41;
        at.write_f(5, M_hat_1);
        let axial = u14 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t42 = u6 + m_o * T;
        let F = u9 * t42;
        let t43 = EA + F;
        let t44 = reciprocal(t43);
        let t45 = EA * t44;
        let d_L_o_hat_1_d_Phi = arc * t45;
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t46 = speed * mu;
        let t47 = sec_beta_s * t46;
        let t48 = p * t47;
        let loss = Real::splat(2.0) * t48;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t49 = Phi * s;
        let (sin_t49, cos_t49) = sin_cos(t49);
        let t51 = r * A_hat_1;
        let A_x_hat_1 = cos_t49 * t51;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t51 * sin_t49;
        at.write_f(10, A_y_hat_1);
        let t52 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t36)));
        let t53 = sin_theta * t5;
        let t54 = Real::splat(0.5) * t5;
        let t55 = t54 * (Real::splat(2.0) * v_r);
        let t56 = sin_theta * t55;
        let t57 = below_one(slip);
        let t58 = u44 * t57;
        let t59 = p * (arc * cos_beta_s);
        let t60 = u19 * (t10 * t59);
        let t61 = t5 * t5;
        let t62 = v_t * t61;
        let t63 = cos_theta * arc;
        let t64 = Real::splat(2.0) * (p * (cos_beta_s * (mu * t63)));
        let t65 = v_r * t61;
        let t66 = t58 * t60 - Phi * (t62 * t64 + t65 * t52);
        let t67 = p * (arc * mu);
        let t68 = Real::splat(0.5) * cos_beta_s * (u35 * cos_gamma);
        let t69 = t68 * (cos_beta_s * cos_beta_s);
        let t70 = Phi * (Real::splat(2.0) * (t10 * t67) * t69);
        let t71 = u13 * t65;
        let t72 = u13 * t53 - t56 * t71;
        let t73 = t54 * (Real::splat(2.0) * v_t);
        let t74 = t73 * t71;
        let t75 = Phi * (t5 * t64) + t73 * t66 + t70 * t74;
        let t76 = Phi * (t52 * t53) + t56 * t66 - t70 * t72 + cos_theta * t75;
        let t77 = u19 * (arc * t11);
        let t78 = t6 * t6;
        let t79 = u14 * (t78 * (x * mu));
        let t80 = t69 * (tan_beta_s * t79) - cos_beta_s * t79;
        let t81 = u14 * (t78 * (x * sin_beta_s));
        let t82 = t81 * t58;
        let t83 = t73 * t82 + t80 * t74;
        let t84 = t80 * t72 - t56 * t82 - cos_theta * t83;
        let t85 = u10 * t84;
        let d_T_hat_1_d_T = u10 * t76 + t77 * t85;
        at.write_dy(0, d_T_hat_1_d_T);
        let t86 = t4 * t5;
        let t87 = EI * (t18 * (theta_2 * sin_theta + cos_theta * t13 - cos_theta))
            - EI * (t15 * (sin_theta * t17));
        let t88 = Phi * t12;
        let t89 = t4 * t55;
        let t90 = u13 * t86 - t89 * t71;
        let t91 = Phi * (t52 * t86 - n) - t87 * t88 + t89 * t66 - t70 * t90;
        let t92 = t2 * t2;
        let t93 = t92 * (r * sin_theta);
        let t94 = u19 * (p * t11);
        let t95 = t80 * t90 - t89 * t82 + v_r * t83;
        let d_T_hat_1_d_theta = t91 + t93 * t94 - v_r * t75 + t77 * t95;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t96 = sin_theta * t29;
        let t97 = u39 * t19 - u38 * (t17 * t96) * t88;
        let d_T_hat_1_d_theta1 = u2 * t97;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = t88 * (u46 * t22);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t98 = t16 * t17;
        let t99 = omega * t75 - (u38 * (t98 * (cos_theta * t15)) * t88 + t2 * t94);
        let t100 = omega * t83;
        let t101 = u14 * t6 - t100;
        let d_T_hat_1_d_x = t99 + t77 * t101;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t102 = t23 * (Real::splat(2.0) * (t24 * t59));
        let t103 = u17 * (t23 * (t65 * t64 - t62 * t52) - t58 * t102);
        let t104 = u17 * (t23 * (Real::splat(2.0) * (t24 * t67) * t69));
        let t105 = u17 * (t23 * (t5 * t52)) + t73 * t103 - t104 * t74;
        let t106 = t56 * t103 - u17 * (t23 * (t64 * t53)) + t104 * t72
            + cos_theta * t105;
        let t107 = u17 * (t23 * (Real::splat(2.0) * (arc * t25)));
        let d_theta_hat_3_d_T = u10 * t106 - u17 * (t12 * t23) + t107 * t85;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t108 = cos_theta * sin_theta;
        let t109 = t35 * (t23 * t23);
        let t110 = theta_1 * theta_2;
        let t111 = Real::splat(4.0) * (t27 * t108)
            + (Real::splat(4.0) * (t13 * t108)
                + (Real::splat(4.0) * (t26 * t110)
                    + Real::splat(2.0) * (theta_2 * t26)));
        let t112 = Real::splat(4.0) * t96;
        let t113 = t111 - Real::splat(4.0) * (t21 * t110) - t112
            - Real::splat(2.0) * (theta_2 * t21) - Real::splat(4.0) * t108;
        let t114 = u38 * (t17 * t108) * t109 - t23 * (EI * (t17 * t113))
            + t23 * (t - t64 * t86);
        let t115 = u17 * (t23 * (Real::splat(2.0) * (p * t25)));
        let t116 = u17 * t114 + t89 * t103 + t104 * t90 + t93 * t115 - v_r * t105;
        let d_theta_hat_3_d_theta = t116 + t107 * t95;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t117 = T * t23;
        let t118 = Real::splat(3.0) * t28 + (t21 + Real::splat(4.0) * t31)
            - Real::splat(4.0) * t32 - Real::splat(3.0) * (t13 * t21);
        let t119 = t17 * (t118 - t26);
        let d_theta_hat_3_d_theta1 = u17 * (u2 * t117 - t23 * (u48 * t119));
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t120 = t17 * (t112 + Real::splat(2.0) * t108);
        let d_theta_hat_3_d_theta2 = u17 * (t23 * (u46 * t120));
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t121 = u17 * (u38 * (t21 * t98) * t109 + t23 * (u38 * (t33 * t98)))
            + t2 * t115;
        let t122 = omega * t105 - t121;
        let d_theta_hat_3_d_x = t122 + t107 * t101;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(Phi * r + Phi * (t92 * (r * t26)));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * (t2 * sin_theta);
        at.write_dy(13, d_x_hat_1_d_x);
        let t123 = u19 * (p * (cos_beta_s * t38));
        let t124 = u19 * (p * (cos_beta_s * (mu * t37)));
        let t125 = t123 * t58 - t62 * t124;
        let t126 = u19 * (p * t39) * t69;
        let t127 = t5 * t124 + t73 * t125 + t126 * t74;
        let t128 = t56 * t125 - t126 * t72 + cos_theta * t127;
        let t129 = u19 * t40;
        let d_M_hat_1_d_T = u10 * t128 + t129 * t85;
        at.write_dy(14, d_M_hat_1_d_T);
        let t130 = u19 * (p * (cos_beta_s * (mu * (r * sin_gamma))));
        let d_M_hat_1_d_theta = t89 * t125 - t126 * t90 + t93 * t130 - v_r * t127
            + t129 * t95;
        at.write_dy(15, d_M_hat_1_d_theta);
        let t131 = omega * t127
            - (u19 * (p * (cos_beta_s * (mu * (arc * sin_gamma)))) + t2 * t130);
        let d_M_hat_1_d_x = t131 + t129 * t101;
        at.write_dy(16, d_M_hat_1_d_x);
        let t132 = u42 * x;
        let d_A_hat_1_d_theta = t93 * t132;
        at.write_dy(17, d_A_hat_1_d_theta);
        let t133 = u42 * arc;
        let d_A_hat_1_d_R = t2 * t132;
        let d_A_hat_1_d_x = t133 - d_A_hat_1_d_R;
        at.write_dy(18, d_A_hat_1_d_x);
        let t134 = arc * (t45 * t45);
        let d_L_o_hat_1_d_T = -(u47 * t134);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t135 = u43 * t44;
        let d_L_o_hat_1_d_theta = t93 * t135;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t2 * t135;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t136 = Phi * arc;
        let t137 = Real::splat(2.0) * (p * (speed * sec_beta_s)) * t136;
        let t138 = Real::splat(2.0) * (p * (mu * sec_beta_s)) * t136 + t58 * t137;
        let t139 = t136 * (t68 * (Real::splat(2.0) * (p * t46)));
        let t140 = t73 * t138 - t139 * t74;
        let t141 = t56 * t138 + t139 * t72 + cos_theta * t140;
        let t142 = Real::splat(2.0) * t47 * t136;
        let d_W_hat_1_d_T = u10 * t141 + t142 * t85;
        at.write_dy(22, d_W_hat_1_d_T);
        let t143 = u19 * t48;
        let d_W_hat_1_d_theta = t89 * t138 + t139 * t90 + t93 * t143 - v_r * t140
            + t142 * t95;
        at.write_dy(23, d_W_hat_1_d_theta);
        let t144 = omega * t140 - t2 * t143;
        let d_W_hat_1_d_x = t144 + t142 * t101;
        at.write_dy(24, d_W_hat_1_d_x);
        let t145 = r * cos_t49;
        let t146 = t132 * t145;
        let d_A_x_hat_1_d_theta = t93 * t146;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let t147 = A_hat_1 * cos_t49;
        let t148 = t2 * t146;
        let d_A_x_hat_1_d_x = t145 * t133 - t147 - t148;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t149 = r * sin_t49;
        let t150 = t132 * t149;
        let d_A_y_hat_1_d_theta = t93 * t150;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let t151 = A_hat_1 * sin_t49;
        let t152 = t2 * t150;
        let d_A_y_hat_1_d_x = t149 * t133 - t151 - t152;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t153 = u20 * theta2;
        let t154 = u3 * theta1;
        let d_T_hat_1_d_Phi = t20 - t88 * (EI * t22 * t153) - t154 * t97;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t155 = omega_P * r;
        let t156 = t155 * t83;
        let d_T_hat_1_d_sigma = t77 * t156 - t155 * t75;
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t157 = u8 * t3 + u31 * t3;
        let t158 = u22 * t157;
        let t159 = t158 * t84;
        let d_T_hat_1_d_flow = t158 * t76 + t77 * t159;
        at.write_dc(2, d_T_hat_1_d_flow);
        let t160 = u17 * (t23 * (t154 * (EI * t119) - t153 * (EI * t120)) - t154 * t117);
        let d_theta_hat_3_d_Phi = u40 * theta_3 + t160;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = t107 * t156 - t155 * t105;
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t158 * t106 + t107 * t159;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t36;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let d_M_hat_1_d_Phi = Real::splat(2.0) * t41;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = t129 * t156 - t155 * t127;
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t158 * t128 + t129 * t159;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t161 = u45 * t134;
        let t162 = (u27 * t42 + u28) * t161;
        let d_L_o_hat_1_d_flow = -(u22 * t162);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = t142 * t156 - t155 * t140;
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t158 * t141 + t142 * t159;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t163 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t145 - sin_t49 * t163;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t49 * t163 + d_A_hat_1_d_Phi * t149;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let t164 = u10 - u30 * t3;
        let t165 = t164 * t84;
        let d_T_hat_1_d_EA = t164 * t76 + t77 * t165;
        at.write_dc(18, d_T_hat_1_d_EA);
        let d_T_hat_1_d_EI = -(t19 * t88);
        at.write_dc(19, d_T_hat_1_d_EI);
        let t166 = Real::splat(0.5) * t7;
        let d_T_hat_1_d_k = t166 * t77;
        at.write_dc(20, d_T_hat_1_d_k);
        let t167 = u23 * t157 - u32 * t3;
        let t168 = t167 * t84;
        let d_T_hat_1_d_m_o = t167 * t76 + t77 * t168;
        at.write_dc(21, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_R = t77 * t100 - t99;
        at.write_dc(22, d_T_hat_1_d_R);
        let t169 = u21 * t157;
        let t170 = t169 * t84;
        let d_T_hat_1_d_R_P = t169 * t76 + t77 * t170;
        at.write_dc(23, d_T_hat_1_d_R_P);
        let t171 = cos_gamma + u34 * cos_gamma;
        let t172 = u36 * (x * t78) + t171 * t80;
        let d_T_hat_1_d_beta = t77 * t172 - (u49 * (p * t36) + t171 * t70);
        at.write_dc(24, d_T_hat_1_d_beta);
        let t173 = saturation * t81;
        let d_T_hat_1_d_mu_k = saturation * t60 - t77 * t173;
        at.write_dc(25, d_T_hat_1_d_mu_k);
        let t174 = u33 * speed * (mu_k * t57);
        let t175 = t81 * t174;
        let d_T_hat_1_d_v_thr = t77 * t175 - t174 * t60;
        at.write_dc(26, d_T_hat_1_d_v_thr);
        let t176 = u5 * t157;
        let t177 = sigma * r;
        let t178 = t177 * t83 + t176 * t84;
        let d_T_hat_1_d_omega_P = t176 * t76 - t177 * t75 + t77 * t178;
        at.write_dc(27, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t164 * t106 + t107 * t165;
        at.write_dc(28, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(u17 * (t22 * t109 + t34 * t23));
        at.write_dc(29, d_theta_hat_3_d_EI);
        let d_theta_hat_3_d_k = t166 * t107;
        at.write_dc(30, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = t167 * t106 + t107 * t168;
        at.write_dc(31, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R = t107 * t100 - t122;
        at.write_dc(32, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = t169 * t106 + t107 * t170;
        at.write_dc(33, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_beta = u17 * (t23 * (u37 * (p * t63))) + t171 * t104
            + t107 * t172;
        at.write_dc(34, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = -(u17 * (saturation * t102) + t173 * t107);
        at.write_dc(35, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = u17 * (t174 * t102) + t175 * t107;
        at.write_dc(36, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = t176 * t106 - t177 * t105 + t107 * t178;
        at.write_dc(37, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(38, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t164 * t128 + t129 * t165;
        at.write_dc(39, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = t166 * t129;
        at.write_dc(40, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = t167 * t128 + t129 * t168;
        at.write_dc(41, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = t129 * t100 - t131;
        at.write_dc(42, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = t169 * t128 + t129 * t170;
        at.write_dc(43, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t129 * t172 - t171 * t126;
        at.write_dc(44, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = saturation * t123 - t129 * t173;
        at.write_dc(45, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = t129 * t175 - t123 * t174;
        at.write_dc(46, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = t176 * t128 - t177 * t127 + t129 * t178;
        at.write_dc(47, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = Real::splat(0.5) * x * t136;
        at.write_dc(48, d_A_hat_1_d_k);
        at.write_dc(49, d_A_hat_1_d_R);
        let t179 = (u18 - u41 * t43) * (Phi * t134) + (u8 * t42 - u25 * t42) * t161;
        let d_L_o_hat_1_d_EA = -t179;
        at.write_dc(50, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u29 * t42) * t161 + u23 * t162);
        at.write_dc(51, d_L_o_hat_1_d_m_o);
        at.write_dc(52, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u21 * t162);
        at.write_dc(53, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t162);
        at.write_dc(54, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t164 * t141 + t142 * t165;
        at.write_dc(55, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = t166 * t142;
        at.write_dc(56, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = t167 * t141 + t142 * t168;
        at.write_dc(57, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t142 * t100 - t144;
        at.write_dc(58, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = t169 * t141 + t142 * t170;
        at.write_dc(59, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = t171 * t139 + t142 * t172;
        at.write_dc(60, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = saturation * t137 - t142 * t173;
        at.write_dc(61, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = t142 * t175 - t174 * t137;
        at.write_dc(62, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = t176 * t141 - t177 * t140 + t142 * t178;
        at.write_dc(63, d_W_hat_1_d_omega_P);
        let d_A_x_hat_1_d_k = t145 * d_A_hat_1_d_k;
        at.write_dc(64, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t147 + t148;
        at.write_dc(65, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t149 * d_A_hat_1_d_k;
        at.write_dc(66, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t151 + t152;
        at.write_dc(67, d_A_y_hat_1_d_R);
    }
}
///Derived fields. (13 add, 46 mul, 5 div, 2 sqrt, 3 fn; once 19)
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    type Uniforms = [f64; 16];
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
        let u8 = reciprocal(v_thr);
        let u9 = reciprocal(cos_beta);
        let u10 = sin_beta * u9;
        let k = constants[5];
        let u11 = k * 0.5;
        let u12 = 2.0 * (u9 * u9);
        [EA, EI, m_o, R, mu_k, cos_beta, u2, u3, u4, u6, u7, omega, u8, u10, u11, u12]
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
        let u12 = Real::splat(uniforms[15]);
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
        let slip = u8 * speed;
        let saturation = saturate(slip);
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
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t5 = reciprocal(r);
        let Q = EI
            * ((sin_theta * (theta_1 * theta_1) - cos_theta * theta_2 - sin_theta)
                * (cos_theta * (t5 * t5)));
        at.write_field(9, Q);
        let M_b = EI * (t5 * (cos_theta * (Real::splat(1.0) - theta_1)));
        at.write_field(10, M_b);
        let axial = u11 * x;
        at.write_field(11, axial);
        let loss = Real::splat(2.0) * (p * (sec_beta_s * (speed * mu)));
        at.write_field(12, loss);
        let loss_radial = u12 * (p * (cos_beta_s * (mu * (t3 * t4))));
        at.write_field(13, loss_radial);
        let loss_tangential = Real::splat(2.0) * (p * (cos_beta_s * (mu * (t2 * t4))));
        at.write_field(14, loss_tangential);
        let arc = r * reciprocal(cos_theta);
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
