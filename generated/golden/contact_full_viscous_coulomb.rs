// contact_full_viscous_coulomb: The belt in a groove: full shear, viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 31 add, 86 mul, 6 div, 2 sqrt, 2 fn a point; 31 once
//   jacobian: 133 add, 349 mul, 7 div, 2 sqrt, 2 fn a point; 85 once
//   full: 211 add, 521 mul, 7 div, 2 sqrt, 2 fn a point; 118 once
//   fields: 16 add, 41 mul, 4 div, 2 sqrt, 3 fn a point; 21 once
// Equations, with their numbers in the source:
// - theta_1 (typed in): (5.2)
// - theta_2 (typed in): (5.3)
// - G (typed in): definition of the flow coefficient
// - F (derived): (3.10)
// - V (derived): (3.11)
// - omega (typed in): definition of the speed ratio
// - r (typed in): (3.1)
// - arc (typed in): (3.4)
// - tan_theta (typed in): (3.24)
// - v_r (typed in): (3.12)
// - v_t (typed in): (3.12)
// - v_0 (typed in): guard: replaces |v| = 0 by 1e-12 m/s; smooth, and without effect elsewhere
// - speed (typed in): (3.12)
// - slip (typed in): Fig. 3.6
// - saturation (typed in): Fig. 3.6
// - mu (typed in): Fig. 3.6
// - face_speed (typed in): (3.13), (3.14)
// - f_r (typed in): (3.13) to (3.15)
// - f_t (typed in): (3.13) to (3.15)
// - p (typed in): (3.16) to (3.18)
// - q (typed in): (3.7)
// - n (typed in): (3.20)
// - t (typed in): (3.21)
// - M_b (derived): (3.32)
// - Q (derived): (3.33)
// - theta_30 (derived): (3.35)
// - Q_theta3 (derived): (3.35)
// - theta_3 (derived): (3.41)
// - T_hat_1 (derived): (3.31), (5.5)
// - theta_hat_3 (derived): (5.4), (5.6)
// - x_hat_1 (derived): (3.24)
// - stretch (typed in): (3.9)
// - axial (typed in): (5.57)
// - loss_radial (typed in): power of friction
// - loss_tangential (typed in): power of friction
// - loss (typed in): power of friction
// - M_hat_1 (typed in): (5.54)
// - A_hat_1 (typed in): (5.58)
// - L_o_hat_1 (typed in): (5.55)
// - W_hat_1 (typed in): energy
// - A_x_hat_1 (typed in): moment of (5.58)
// - A_y_hat_1 (typed in): moment of (5.58)
// - V_T (derived): (3.11)
// - stored (typed in): energy of bending less that of squeezing
// - E_hat_1 (typed in): energy
// - gamma_a (typed in): (3.13)
// - gamma (typed in): Fig. 6.8
// - beta_s (typed in): (3.14)
// - loss_phi (typed in): power of friction

///The belt in a groove: full shear, viscous-coulomb friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_full_viscous_coulomb",
    states: &[
        State::Tension,
        State::Inclination,
        State::InclinationDerivative,
        State::InclinationSecondDerivative,
        State::Penetration,
    ],
    constants: &[
        RegionConstant::WrapAngle,
        RegionConstant::PulleySpeedRatio,
        RegionConstant::Flow,
        RegionConstant::LongitudinalStiffness,
        RegionConstant::BendingStiffness,
        RegionConstant::RadialStiffness,
        RegionConstant::MassPerLength,
        RegionConstant::PulleyRadius,
        RegionConstant::PrimaryRadius,
        RegionConstant::HalfAngle,
        RegionConstant::FrictionCoefficient,
        RegionConstant::SlipThreshold,
        RegionConstant::PrimarySpeed,
    ],
    integrals: &[
        Integral::Torque,
        Integral::AxialForce,
        Integral::UnstretchedLength,
        Integral::FrictionLoss,
        Integral::AxialMomentAlong,
        Integral::AxialMomentAcross,
        Integral::StrainEnergyFlux,
    ],
    fields: &[
        Field::BeltTension,
        Field::BeltSpeed,
        Field::RadialSlidingSpeed,
        Field::TangentialSlidingSpeed,
        Field::SlidingSpeed,
        Field::SlidingAngle,
        Field::FrictionAtPoint,
        Field::Pressure,
        Field::ApparentSheaveAngle,
        Field::Shear,
        Field::BendingMoment,
        Field::AxialForcePerLength,
        Field::LossPerLength,
        Field::RadialLossPerLength,
        Field::TangentialLossPerLength,
        Field::LossPerWrap,
    ],
    default_unknowns: 3,
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
    default_entries: 21,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
///Right-hand side and integrands. (31 add, 86 mul, 6 div, 2 sqrt, 2 fn a point; 31 once)
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
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
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
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
        let t6 = cos_theta * reciprocal(r);
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
        let theta_3 = u14 * reciprocal(t7) * (n + T * theta_1 - T)
            - (t12 - theta_1 * t10 - Real::splat(2.0) * (theta_2 * tan_theta) - t11
                - Real::splat(2.0) * t10);
        let theta_hat_3 = u15 * theta_3;
        at.write_f(3, theta_hat_3);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(4, x_hat_1);
        let arc = r * t4;
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
        let t13 = Phi * s;
        let (sin_t13, cos_t13) = sin_cos(t13);
        let t15 = r * A_hat_1;
        let A_x_hat_1 = cos_t13 * t15;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t15 * sin_t13;
        at.write_f(10, A_y_hat_1);
        let t16 = t6 * t5;
        let stored = u18 * (t16 * t16) - u17 * (x * x);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and default unknowns. (133 add, 349 mul, 7 div, 2 sqrt, 2 fn a point; 85 once)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 34;
    const DC: usize = 21;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 67];
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
        let u23 = 2.0 * u15;
        let u24 = omega_P * (m_o * R_P);
        let u25 = u6 * u6;
        let u26 = G * (EA * 2.0);
        let u27 = u25 * u26;
        let u28 = u6 * u26;
        let u29 = EA * EA;
        let u30 = u25 * (2.0 * u4);
        let u31 = 0.5 * (u10 * (2.0 * u8));
        let u32 = 2.0 * u14;
        let u33 = EI * 2.0;
        let u34 = 4.0 * u15;
        let u35 = 2.0 * u3;
        let u36 = u3 * 3.0;
        let u37 = u16 * u16;
        let u38 = Phi * EI;
        let u39 = u17 * 3.0;
        let u40 = Phi * u14;
        let u41 = Phi * EA;
        let u42 = Phi * reciprocal(EA);
        let u43 = mu_k * u12;
        let u44 = Phi * V_T;
        let u45 = u20 * u44;
        let u46 = EI * (EI * u16 * u44);
        let u47 = u5 * u6 * u42;
        let u48 = Phi * 2.0;
        let u49 = Phi * u19;
        let u50 = u24 * (u6 + u30);
        let u51 = Phi * u33;
        let u52 = 2.0 * u16;
        let u53 = 2.0 * u21;
        let u54 = u3 * u38;
        let u55 = u23 * u38;
        let u56 = Phi * u53;
        let u57 = u2 * u46;
        let u58 = u3 * u46;
        let u59 = u2 * u18;
        let u60 = u3 * u18;
        let u61 = V_T * u18;
        let u62 = u2 * V_T;
        let u63 = V_T * u54;
        let u64 = V_T * u51;
        let u65 = omega * u18;
        let u66 = omega_P * u18;
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
            u24,
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
        let u24 = Real::splat(uniforms[27]);
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
        let u45 = Real::splat(uniforms[45]);
        let u46 = Real::splat(uniforms[46]);
        let u47 = Real::splat(uniforms[47]);
        let u48 = Real::splat(uniforms[48]);
        let u49 = Real::splat(uniforms[49]);
        let u50 = Real::splat(uniforms[50]);
        let u51 = Real::splat(uniforms[51]);
        let u52 = Real::splat(uniforms[52]);
        let u53 = Real::splat(uniforms[53]);
        let u54 = Real::splat(uniforms[54]);
        let u55 = Real::splat(uniforms[55]);
        let u56 = Real::splat(uniforms[56]);
        let u57 = Real::splat(uniforms[57]);
        let u58 = Real::splat(uniforms[58]);
        let u59 = Real::splat(uniforms[59]);
        let u60 = Real::splat(uniforms[60]);
        let u61 = Real::splat(uniforms[61]);
        let u62 = Real::splat(uniforms[62]);
        let u63 = Real::splat(uniforms[63]);
        let u64 = Real::splat(uniforms[64]);
        let u65 = Real::splat(uniforms[65]);
        let u66 = Real::splat(uniforms[66]);
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
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t3));
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
        let t15 = cos_theta * reciprocal(r);
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
        let t26 = n + T * theta_1 - T;
        let t27 = tan_theta * tan_theta;
        let t28 = u15 * (theta1 * t17);
        let t29 = t18 * t27;
        let t30 = theta1 * theta2;
        let t31 = theta_1 * t27;
        let t32 = t27 * t28 + (theta_1 + Real::splat(2.0) * t29)
            - Real::splat(4.0) * (tan_theta * (u15 * t30)) - t31;
        let t33 = theta_2 * tan_theta;
        let theta_3 = t24 * t26
            - (t32 - Real::splat(2.0) * t33 - t28 - Real::splat(2.0) * t27);
        let theta_hat_3 = u18 * theta_3;
        at.write_f(3, theta_hat_3);
        let t34 = r * tan_theta;
        let x_hat_1 = -(Phi * t34);
        at.write_f(4, x_hat_1);
        let arc = r * t11;
        let t35 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t35;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u14 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t36 = u4 + m_o * T;
        let F = u7 * t36;
        let t37 = reciprocal(EA + F);
        let d_L_o_hat_1_d_Phi = arc * (EA * t37);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t38 = v_r * f_r;
        let loss_radial = u19 * (p * t38);
        let t39 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t39);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t40 = Phi * s;
        let (sin_t40, cos_t40) = sin_cos(t40);
        let t42 = r * A_hat_1;
        let A_x_hat_1 = cos_t40 * t42;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t42 * sin_t40;
        at.write_f(10, A_y_hat_1);
        let t43 = t15 * t14;
        let stored = u22 * (t43 * t43) - u21 * (x * x);
        let t44 = T_hat_1 * stored;
        let E_hat_1 = V_T * t44;
        at.write_f(11, E_hat_1);
        let t45 = V_T * sin_theta;
        let t46 = u48 * t9;
        let t47 = reciprocal(speed);
        let t48 = v_r * t47;
        let t49 = u43 * below_one(slip);
        let t50 = speed * t5;
        let t51 = t5 * t5;
        let t52 = t10 * t51;
        let t53 = v_t * t5 * t49 - t50 * t52;
        let t54 = v_r * t5;
        let t55 = u31 * t54;
        let t56 = t48 * t53 - t55 * t52;
        let t57 = mu * t5;
        let t58 = t6 * t51;
        let t59 = t54 * t49 - t50 * t58;
        let t60 = t57 - t55 * t58 + t48 * t59;
        let t61 = tan_theta * q;
        let t62 = x * (t7 * t7);
        let t63 = r * t62;
        let t64 = Phi * t61 - u56 * (t13 * t63);
        let t65 = t46 * t56 + t60 * t64;
        let t66 = t45 * t65;
        let t67 = V_T * cos_theta;
        let t68 = v_t * t47;
        let t69 = t57 + t68 * t53;
        let t70 = t68 * t59;
        let t71 = t46 * t69 + t70 * t64;
        let d_T_hat_1_d_T = t66 + t67 * t71;
        at.write_dy(0, d_T_hat_1_d_T);
        let t72 = Real::splat(1.0) + t27;
        let t73 = t72
            * (Phi * (q * t12) - u38 * (t14 * (t16 * (Real::splat(1.0) - t18))))
            + t4 * t65;
        let t74 = t11 * t11 * (r * sin_theta);
        let t75 = t15 * t16;
        let t76 = t14 * (t20 * t75);
        let t77 = u51 * t76;
        let d_T_hat_1_d_theta = t73 + t74 * t77 - v_r * t71;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t78 = theta_1 * tan_theta;
        let t79 = u51 * (t14 * (t16 * t78)) - u38 * t21;
        let d_T_hat_1_d_theta1 = u2 * t79;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let t80 = t14 * t16;
        let d_T_hat_1_d_theta2 = -(u54 * t80);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t81 = u32 * (r * t7) - u32 * t8;
        let t82 = Phi * t13 * t81;
        let d_T_hat_1_d_x = t82 - t11 * t77 + omega * t71;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t83 = t24 * t61;
        let t84 = t25 * t24;
        let t85 = u52 * (t9 * t23) + t84 * (u53 * t63);
        let t86 = t83 * t56 - t60 * t85;
        let t87 = t83 * t69 - t70 * t85;
        let d_theta_hat_3_d_T = u18 * (t14 * t24) + u61 * (sin_theta * t86)
            + u61 * (cos_theta * t87);
        at.write_dy(7, d_theta_hat_3_d_T);
        let t88 = f_t * q;
        let t89 = Real::splat(4.0) * t19 + Real::splat(2.0) * (tan_theta * t28)
            - u34 * t30 - Real::splat(2.0) * t78 - u35 * theta2;
        let t90 = u18 * t86;
        let t91 = u18 * (u33 * t75 * (t26 * (u37 * (t23 * t23))));
        let t92 = u18 * (t72 * (t24 * t88 - (t89 - Real::splat(4.0) * tan_theta)))
            + t4 * t90 + t74 * t91;
        let t93 = u18 * t87;
        let d_theta_hat_3_d_theta = t92 - v_r * t93;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t94 = Real::splat(3.0) * t29 + (Real::splat(1.0) + Real::splat(4.0) * t31)
            - Real::splat(4.0) * t33 - u36 * t17 - t27;
        let t95 = T * t24 - t94;
        let d_theta_hat_3_d_theta1 = u59 * t95;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t96 = Real::splat(4.0) * t78 + Real::splat(2.0) * tan_theta;
        let d_theta_hat_3_d_theta2 = u60 * t96;
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let d_theta_hat_3_d_x = u18 * (t84 * t81) - t11 * t91 + u65 * t87;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t72 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let t97 = Phi * (arc * q);
        let t98 = u56 * (t35 * t63);
        let t99 = t97 * t56 - t60 * t98;
        let t100 = t97 * t69 - t70 * t98;
        let d_M_hat_1_d_T = t45 * t99 + t67 * t100;
        at.write_dy(14, d_M_hat_1_d_T);
        let t101 = Phi * t88;
        let d_M_hat_1_d_theta = t4 * t99 + t74 * t101 - v_r * t100;
        at.write_dy(15, d_M_hat_1_d_theta);
        let d_M_hat_1_d_x = Phi * t35 * t81 - t11 * t101 + omega * t100;
        at.write_dy(16, d_M_hat_1_d_x);
        let t102 = u40 * x;
        let d_A_hat_1_d_theta = t74 * t102;
        at.write_dy(17, d_A_hat_1_d_theta);
        let t103 = u40 * arc;
        let d_A_hat_1_d_x = t103 - t11 * t102;
        at.write_dy(18, d_A_hat_1_d_x);
        let t104 = arc * (u29 * (t37 * t37));
        let d_L_o_hat_1_d_T = -(u47 * t104);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t105 = u41 * t37;
        let d_L_o_hat_1_d_theta = t74 * t105;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t11 * t105);
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t106 = u48 * (arc * (v_t * p));
        let t107 = u48 * (arc * t39) + u49 * (arc * t38);
        let t108 = u49 * (arc * (v_r * p)) - u21 * t62 * t107;
        let t109 = u49 * (arc * (f_r * p)) + t106 * t56 + t108 * t60;
        let t110 = u48 * (arc * (f_t * p)) + t106 * t69 + t108 * t70;
        let d_W_hat_1_d_T = t45 * t109 + t67 * t110;
        at.write_dy(22, d_W_hat_1_d_T);
        let t111 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t109 + t74 * t111 - v_r * t110;
        at.write_dy(23, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = u14 * t7 * t107 - t11 * t111 + omega * t110;
        at.write_dy(24, d_W_hat_1_d_x);
        let t112 = r * cos_t40;
        let t113 = t102 * t112;
        let d_A_x_hat_1_d_theta = t74 * t113;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t112 * t103 - A_hat_1 * cos_t40 - t11 * t113;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t114 = r * sin_t40;
        let t115 = t102 * t114;
        let d_A_y_hat_1_d_theta = t74 * t115;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t114 * t103 - A_hat_1 * sin_t40 - t11 * t115;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t116 = V_T * stored;
        let t117 = t116 * t71;
        let d_E_hat_1_d_T = t116 * t66 + t67 * t117;
        at.write_dy(29, d_E_hat_1_d_T);
        let t118 = t43 * t22;
        let t119 = u64 * (stored * t76) - u46 * (t80 * t118);
        let d_E_hat_1_d_theta = t116 * t73 + t74 * t119 - v_r * t117;
        at.write_dy(30, d_E_hat_1_d_theta);
        let t120 = t15 * t118;
        let d_E_hat_1_d_theta1 = u57 * t120 + u62 * (stored * t79);
        at.write_dy(31, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u63 * (stored * t80));
        at.write_dy(32, d_E_hat_1_d_theta2);
        let d_E_hat_1_d_x = t116 * t82 - u45 * (x * t22) - t11 * t119 + omega * t117;
        at.write_dy(33, d_E_hat_1_d_x);
        let t121 = u3 * theta1;
        let d_T_hat_1_d_Phi = t22 + u55 * (theta2 * t80) - t121 * t79;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t122 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t122 * t71);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t123 = u24 * (u6 * t1 + u30 * t1);
        let t124 = sin_theta * t123;
        let t125 = t124 * t65;
        let t126 = cos_theta * t123;
        let d_T_hat_1_d_flow = t125 + t126 * t71;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u39 * theta_3
            - u18 * (u23 * theta2 * t96 + t121 * t95);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(u66 * (r * t87));
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t124 * t90 + t126 * t93;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t34;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t122 * t100);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t124 * t99 + t126 * t100;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u24 * ((u27 * t36 + u28) * (u42 * t104)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t122 * t110);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t124 * t109 + t126 * t110;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t127 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t112 - sin_t40 * t127;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t40 * t127 + d_A_hat_1_d_Phi * t114;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t116 * d_T_hat_1_d_Phi - u58 * (theta1 * t120);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t122 * t117);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u50 * t44 + t116 * t125 + t126 * t117;
        at.write_dc(20, d_E_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (211 add, 521 mul, 7 div, 2 sqrt, 2 fn a point; 118 once)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 34;
    const DC: usize = 81;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 89];
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
        let u40 = u14 * u14;
        let u41 = u11 * (2.0 * sin_beta);
        let u42 = u11 * u12;
        let u43 = u42 * (2.0 * (sin_beta * u10));
        let u44 = 0.5 * (u12 * (2.0 * u10));
        let u45 = 2.0 * u16;
        let u46 = 4.0 * u17;
        let u47 = 2.0 * u3;
        let u48 = u3 * 3.0;
        let u49 = u18 * u18;
        let u50 = Phi * EI;
        let u51 = u19 * 3.0;
        let u52 = u21 * u21;
        let u53 = Phi * u16;
        let u54 = Phi * EA;
        let u55 = u8 + u38;
        let u56 = 0.5 * (u12 * (k * u10));
        let u57 = Phi * V_T;
        let u58 = u23 * u57;
        let u59 = u25 * (0.5 * u49) * u57;
        let u60 = u15 * 0.5 * u57;
        let u61 = EI * u18 * u57;
        let u62 = Phi * 2.0;
        let u63 = Phi * (u42 * (sin_beta * 4.0));
        let u64 = Phi * u22;
        let u65 = Phi * 0.5;
        let u66 = Phi * u21;
        let u67 = V_T * u50;
        let u68 = u18 * u20;
        let u69 = EI * 2.0;
        let u70 = u20 * u69;
        let u71 = Phi * u69;
        let u72 = u69 * u57;
        let u73 = EI * u57;
        let u74 = EI * u61;
        let u75 = Phi * cos_beta;
        let u76 = cos_beta * u57;
        let u77 = 2.0 * u57;
        let u78 = cos_beta * 2.0 * u68;
        let u79 = 2.0 * u68;
        let u80 = Phi * u45;
        let u81 = u16 * u62;
        let u82 = 0.5 * u62;
        let u83 = u24 * u62;
        let u84 = u7 * u8 * u66;
        let u85 = u3 * u50;
        let u86 = 2.0 * u17;
        let u87 = u86 * u50;
        let u88 = u3 * u20;
        let u89 = u20 * u86;
        let u90 = u3 * u73;
        let u91 = u86 * u73;
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
            u41,
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
            u68,
            u70,
            u71,
            u72,
            u73,
            u74,
            u75,
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
            u87,
            u88,
            u89,
            u90,
            u91,
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
        let u41 = Real::splat(uniforms[41]);
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
        let u68 = Real::splat(uniforms[67]);
        let u70 = Real::splat(uniforms[68]);
        let u71 = Real::splat(uniforms[69]);
        let u72 = Real::splat(uniforms[70]);
        let u73 = Real::splat(uniforms[71]);
        let u74 = Real::splat(uniforms[72]);
        let u75 = Real::splat(uniforms[73]);
        let u76 = Real::splat(uniforms[74]);
        let u77 = Real::splat(uniforms[75]);
        let u78 = Real::splat(uniforms[76]);
        let u79 = Real::splat(uniforms[77]);
        let u80 = Real::splat(uniforms[78]);
        let u81 = Real::splat(uniforms[79]);
        let u82 = Real::splat(uniforms[80]);
        let u83 = Real::splat(uniforms[81]);
        let u84 = Real::splat(uniforms[82]);
        let u85 = Real::splat(uniforms[83]);
        let u87 = Real::splat(uniforms[84]);
        let u88 = Real::splat(uniforms[85]);
        let u89 = Real::splat(uniforms[86]);
        let u90 = Real::splat(uniforms[87]);
        let u91 = Real::splat(uniforms[88]);
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
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t3));
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
        let t15 = cos_theta * reciprocal(r);
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
        let t26 = n + T * theta_1 - T;
        let t27 = tan_theta * tan_theta;
        let t28 = u17 * (theta1 * t17);
        let t29 = t18 * t27;
        let t30 = theta1 * theta2;
        let t31 = theta_1 * t27;
        let t32 = t27 * t28 + (theta_1 + Real::splat(2.0) * t29)
            - Real::splat(4.0) * (tan_theta * (u17 * t30)) - t31;
        let t33 = theta_2 * tan_theta;
        let theta_3 = t24 * t26
            - (t32 - Real::splat(2.0) * t33 - t28 - Real::splat(2.0) * t27);
        let theta_hat_3 = u20 * theta_3;
        at.write_f(3, theta_hat_3);
        let t34 = r * tan_theta;
        let x_hat_1 = -(Phi * t34);
        at.write_f(4, x_hat_1);
        let arc = r * t11;
        let t35 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t35;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u16 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t36 = u6 + m_o * T;
        let F = u9 * t36;
        let t37 = EA + F;
        let t38 = reciprocal(t37);
        let d_L_o_hat_1_d_Phi = arc * (EA * t38);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t39 = v_r * f_r;
        let t40 = p * t39;
        let loss_radial = u22 * t40;
        let t41 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t41);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t42 = Phi * s;
        let (sin_t42, cos_t42) = sin_cos(t42);
        let t44 = r * A_hat_1;
        let A_x_hat_1 = cos_t42 * t44;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t44 * sin_t42;
        at.write_f(10, A_y_hat_1);
        let t45 = t15 * t14;
        let t46 = t45 * t45;
        let t47 = x * x;
        let stored = u26 * t46 - u24 * t47;
        let t48 = T_hat_1 * stored;
        let E_hat_1 = V_T * t48;
        at.write_f(11, E_hat_1);
        let t49 = mu * t5;
        let t50 = u62 * t9;
        let t51 = reciprocal(speed);
        let t52 = v_t * t51;
        let t53 = below_one(slip);
        let t54 = v_t * t5;
        let t55 = v_r * t5;
        let t56 = tan_theta * q;
        let t57 = x * (t7 * t7);
        let t58 = r * t13;
        let t59 = Phi * t56 - u83 * (t57 * t58);
        let t60 = t54 * t50 + t55 * t59;
        let t61 = t53 * (mu_k * t60);
        let t62 = speed * t5;
        let t63 = t5 * t5;
        let t64 = t10 * t63;
        let t65 = t6 * t63;
        let t66 = t64 * t50 + t65 * t59;
        let t67 = u14 * t61 - t62 * t66;
        let t68 = t49 * t50 + t52 * t67;
        let t69 = u44 * t55;
        let t70 = v_r * t51;
        let t71 = t49 * t59 - t69 * t66 + t70 * t67;
        let t72 = cos_theta * t68 + sin_theta * t71;
        let d_T_hat_1_d_T = V_T * t72;
        at.write_dy(0, d_T_hat_1_d_T);
        let t73 = Real::splat(1.0) + t27;
        let t74 = q * t12;
        let t75 = t16 * (Real::splat(1.0) - t18);
        let t76 = t4 * t71 - v_r * t68 + t73 * (Phi * t74 - u50 * (t14 * t75));
        let t77 = t11 * t11 * (r * sin_theta);
        let t78 = t15 * t16;
        let t79 = t20 * t78;
        let t80 = u71 * (t14 * t79);
        let d_T_hat_1_d_theta = t76 + t77 * t80;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t81 = theta_1 * tan_theta;
        let t82 = t16 * t81;
        let t83 = u71 * (t14 * t82) - u50 * t21;
        let d_T_hat_1_d_theta1 = u2 * t83;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let t84 = t14 * t16;
        let d_T_hat_1_d_theta2 = -(u85 * t84);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t85 = omega * t68;
        let t86 = t11 * t80;
        let t87 = u80 * (t8 * t13);
        let d_T_hat_1_d_x = u81 * (t7 * t58) + t85 - t86 - t87;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t88 = u68 * t23;
        let t89 = t56 * t88;
        let t90 = t9 * t23;
        let t91 = u24 * t57;
        let t92 = Real::splat(2.0) * r;
        let t93 = t25 * t88;
        let t94 = t92 * t93;
        let t95 = u79 * t90 + t91 * t94;
        let t96 = t65 * t95 - t64 * t89;
        let t97 = t54 * t89 - t55 * t95;
        let t98 = t53 * (mu_k * t97);
        let t99 = t62 * t96 + u14 * t98;
        let t100 = t49 * t89 + t52 * t99;
        let t101 = t69 * t96 - t49 * t95 + t70 * t99;
        let t102 = cos_theta * t100 + sin_theta * t101;
        let d_theta_hat_3_d_T = u20 * (t14 * t24) + V_T * t102;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t103 = f_t * q;
        let t104 = Real::splat(4.0) * t19 + Real::splat(2.0) * (tan_theta * t28)
            - u46 * t30 - Real::splat(2.0) * t81 - u47 * theta2;
        let t105 = t4 * t101 - v_r * t100
            + t73 * (t103 * t88 - u20 * (t104 - Real::splat(4.0) * tan_theta));
        let t106 = t26 * (u49 * (t23 * t23));
        let t107 = u70 * (t78 * t106);
        let d_theta_hat_3_d_theta = t105 + t77 * t107;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t108 = Real::splat(3.0) * t29 + (Real::splat(1.0) + Real::splat(4.0) * t31)
            - Real::splat(4.0) * t33 - u48 * t17 - t27;
        let t109 = u20 * (T * t24) - u20 * t108;
        let d_theta_hat_3_d_theta1 = u2 * t109;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t110 = Real::splat(4.0) * t81 + Real::splat(2.0) * tan_theta;
        let d_theta_hat_3_d_theta2 = u88 * t110;
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t111 = u16 * t7;
        let t112 = omega * t100;
        let t113 = t11 * t107;
        let t114 = u45 * t8;
        let t115 = t114 * t93;
        let d_theta_hat_3_d_x = t111 * t94 + t112 - t113 - t115;
        at.write_dy(11, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t73 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let t116 = Phi * (arc * q);
        let t117 = r * t35;
        let t118 = u83 * (t57 * t117);
        let t119 = t65 * t118 - t64 * t116;
        let t120 = t54 * t116 - t55 * t118;
        let t121 = t53 * (mu_k * t120);
        let t122 = t62 * t119 + u14 * t121;
        let t123 = t49 * t116 + t52 * t122;
        let t124 = t69 * t119 - t49 * t118 + t70 * t122;
        let t125 = cos_theta * t123 + sin_theta * t124;
        let d_M_hat_1_d_T = V_T * t125;
        at.write_dy(14, d_M_hat_1_d_T);
        let t126 = Phi * t103;
        let d_M_hat_1_d_theta = t4 * t124 - v_r * t123 + t77 * t126;
        at.write_dy(15, d_M_hat_1_d_theta);
        let t127 = omega * t123;
        let t128 = t11 * t126;
        let t129 = u80 * (t8 * t35);
        let d_M_hat_1_d_x = u81 * (t7 * t117) + t127 - t128 - t129;
        at.write_dy(16, d_M_hat_1_d_x);
        let t130 = u53 * x;
        let d_A_hat_1_d_theta = t77 * t130;
        at.write_dy(17, d_A_hat_1_d_theta);
        let d_A_hat_1_d_R = t11 * t130;
        let d_A_hat_1_d_x = u53 * arc - d_A_hat_1_d_R;
        at.write_dy(18, d_A_hat_1_d_x);
        let t131 = arc * (u35 * (t38 * t38));
        let d_L_o_hat_1_d_T = -(u84 * t131);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t132 = u54 * t38;
        let d_L_o_hat_1_d_theta = t77 * t132;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t11 * t132;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t133 = u62 * (arc * (v_t * p));
        let t134 = u62 * (arc * t41) + u64 * (arc * t39);
        let t135 = u64 * (arc * (v_r * p)) - t91 * t134;
        let t136 = t54 * t133 + t55 * t135;
        let t137 = t53 * (mu_k * t136);
        let t138 = t64 * t133 + t65 * t135;
        let t139 = u14 * t137 - t62 * t138;
        let t140 = u62 * (arc * (f_t * p)) + t49 * t133 + t52 * t139;
        let t141 = u64 * (arc * (f_r * p)) + t49 * t135 - t69 * t138 + t70 * t139;
        let t142 = cos_theta * t140 + sin_theta * t141;
        let d_W_hat_1_d_T = V_T * t142;
        at.write_dy(22, d_W_hat_1_d_T);
        let t143 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t141 - v_r * t140 + t77 * t143;
        at.write_dy(23, d_W_hat_1_d_theta);
        let t144 = omega * t140;
        let t145 = t11 * t143;
        let d_W_hat_1_d_x = t111 * t134 + t144 - t145;
        at.write_dy(24, d_W_hat_1_d_x);
        let t146 = r * cos_t42;
        let t147 = t130 * t146;
        let d_A_x_hat_1_d_theta = t77 * t147;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let t148 = Phi * arc;
        let t149 = t148 * t146;
        let t150 = t11 * t147;
        let t151 = A_hat_1 * cos_t42;
        let d_A_x_hat_1_d_x = u16 * t149 - t150 - t151;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let t152 = r * sin_t42;
        let t153 = t130 * t152;
        let d_A_y_hat_1_d_theta = t77 * t153;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let t154 = t148 * t152;
        let t155 = t11 * t153;
        let t156 = A_hat_1 * sin_t42;
        let d_A_y_hat_1_d_x = u16 * t154 - t155 - t156;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let t157 = u77 * (t9 * stored);
        let t158 = u57 * stored;
        let t159 = t13 * t158;
        let t160 = t92 * t159;
        let t161 = t56 * t158 - t91 * t160;
        let t162 = t54 * t157 + t55 * t161;
        let t163 = t53 * (mu_k * t162);
        let t164 = t64 * t157 + t65 * t161;
        let t165 = u14 * t163 - t62 * t164;
        let t166 = t49 * t157 + t52 * t165;
        let t167 = t49 * t161 - t69 * t164 + t70 * t165;
        let t168 = cos_theta * t166 + sin_theta * t167;
        let d_E_hat_1_d_T = V_T * t168;
        at.write_dy(29, d_E_hat_1_d_T);
        let t169 = t14 * stored;
        let t170 = t4 * t167 - v_r * t166 + t73 * (t74 * t158 - u73 * (t75 * t169));
        let t171 = t45 * t22;
        let t172 = u72 * (t79 * t169) - u74 * (t84 * t171);
        let d_E_hat_1_d_theta = t170 + t77 * t172;
        at.write_dy(30, d_E_hat_1_d_theta);
        let t173 = u72 * (t82 * t169) - u67 * (t21 * stored) + u74 * (t15 * t171);
        let d_E_hat_1_d_theta1 = u2 * t173;
        at.write_dy(31, d_E_hat_1_d_theta1);
        let t174 = t16 * t169;
        let d_E_hat_1_d_theta2 = -(u90 * t174);
        at.write_dy(32, d_E_hat_1_d_theta2);
        let t175 = omega * t166;
        let t176 = t11 * t172;
        let t177 = t114 * t159;
        let d_E_hat_1_d_x = t111 * t160 - u58 * (x * t22) + t175 - t176 - t177;
        at.write_dy(33, d_E_hat_1_d_x);
        let t178 = u3 * theta1;
        let d_T_hat_1_d_Phi = t22 + u87 * (theta2 * t84) - t178 * t83;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t179 = r * t68;
        let d_T_hat_1_d_sigma = -(omega_P * t179);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t180 = u8 * t1 + u38 * t1;
        let t181 = t180 * t72;
        let d_T_hat_1_d_flow = u28 * t181;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u51 * theta_3 - u89 * (theta2 * t110) - t178 * t109;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let t182 = r * t100;
        let d_theta_hat_3_d_sigma = -(omega_P * t182);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let t183 = t180 * t102;
        let d_theta_hat_3_d_flow = u28 * t183;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t34;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let t184 = r * t123;
        let d_M_hat_1_d_sigma = -(omega_P * t184);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t185 = t180 * t125;
        let d_M_hat_1_d_flow = u28 * t185;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t186 = u66 * t131;
        let t187 = (u33 * t36 + u34) * t186;
        let d_L_o_hat_1_d_flow = -(u28 * t187);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let t188 = r * t140;
        let d_W_hat_1_d_sigma = -(omega_P * t188);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let t189 = t180 * t142;
        let d_W_hat_1_d_flow = u28 * t189;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t190 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t146 - sin_t42 * t190;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t42 * t190 + d_A_hat_1_d_Phi * t152;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t22 * (V_T * stored) + u91 * (theta2 * t174) - t178 * t173;
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t191 = r * t166;
        let d_E_hat_1_d_sigma = -(omega_P * t191);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t192 = u55 * t48 + t180 * t168;
        let d_E_hat_1_d_flow = u28 * t192;
        at.write_dc(20, d_E_hat_1_d_flow);
        let t193 = V_T - u37 * t1;
        let d_T_hat_1_d_EA = t193 * t72;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_EI = -(t21 * (Phi * t14));
        at.write_dc(22, d_T_hat_1_d_EI);
        let d_T_hat_1_d_k = u82 * (t8 * t58);
        at.write_dc(23, d_T_hat_1_d_k);
        let t194 = u39 * t1;
        let d_T_hat_1_d_m_o = u29 * t181 - t194 * t72;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_R = t87 + (t86 - t85);
        at.write_dc(25, d_T_hat_1_d_R);
        let d_T_hat_1_d_R_P = u27 * t181;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t195 = (t12 + u13 * f_r) * t57;
        let t196 = Real::splat(0.5) * t5 * (u41 * t3 + u43 * t3);
        let d_T_hat_1_d_beta = -(u75 * t56 + u81 * (t195 * t58) + t196 * t66);
        at.write_dc(27, d_T_hat_1_d_beta);
        let d_T_hat_1_d_mu_k = saturation * t60;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let t197 = u40 * speed;
        let d_T_hat_1_d_v_thr = -(t197 * t61);
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let d_T_hat_1_d_omega_P = u5 * t181 - sigma * t179;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t193 * t102;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(t16 * (u20 * t106));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let t198 = Real::splat(0.5) * t8;
        let d_theta_hat_3_d_k = t198 * t94;
        at.write_dc(33, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = u29 * t183 - t194 * t102;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R = t115 + (t113 - t112);
        at.write_dc(35, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = u27 * t183;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let t199 = u16 * t195;
        let d_theta_hat_3_d_beta = u78 * t90 - t199 * t94 + t196 * t96;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = saturation * t97;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = -(t197 * t98);
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = u5 * t183 - sigma * t182;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t193 * t125;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = u82 * (t8 * t117);
        at.write_dc(43, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = u29 * t185 - t194 * t125;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = t129 + (t128 - t127);
        at.write_dc(45, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = u27 * t185;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t196 * t119 - u81 * (t195 * t117);
        at.write_dc(47, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = saturation * t120;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = -(t197 * t121);
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = u5 * t185 - sigma * t184;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = u65 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        at.write_dc(52, d_A_hat_1_d_R);
        let t200 = (u21 - u52 * t37) * (Phi * t131) + (u8 * t36 - u31 * t36) * t186;
        let d_L_o_hat_1_d_EA = -t200;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u36 * t36) * t186 + u29 * t187);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u27 * t187);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t187);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t193 * t142;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = t198 * t134;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = u29 * t189 - t194 * t142;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t145 - t144;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = u27 * t189;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = u63 * (arc * t40) - t199 * t134 - t196 * t138;
        at.write_dc(63, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = saturation * t136;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t197 * t137);
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = u5 * t189 - sigma * t188;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let t201 = Real::splat(0.5) * x;
        let d_A_x_hat_1_d_k = t201 * t149;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t151 + t150;
        at.write_dc(68, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t201 * t154;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t156 + t155;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_E_hat_1_d_EA = t193 * t168 - u37 * t48;
        at.write_dc(71, d_E_hat_1_d_EA);
        let d_E_hat_1_d_EI = t45 * (u61 * t171)
            - (u59 * (t22 * t46) + t21 * (u57 * t169));
        at.write_dc(72, d_E_hat_1_d_EI);
        let d_E_hat_1_d_k = t198 * t160 - u60 * (t22 * t47);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_E_hat_1_d_m_o = u29 * t192 - (u39 * t48 + t194 * t168);
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R = t177 + (t176 - t175);
        at.write_dc(75, d_E_hat_1_d_R);
        let d_E_hat_1_d_R_P = u27 * t192;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t202 = (u16 * t47 + u56 * t47) * (u57 * t22) + u76 * (stored * t56)
            + t199 * t160;
        let d_E_hat_1_d_beta = -(t202 + t196 * t164);
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_mu_k = saturation * t162;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let d_E_hat_1_d_v_thr = -(t197 * t163);
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_omega_P = u5 * t192 - sigma * t191;
        at.write_dc(80, d_E_hat_1_d_omega_P);
    }
}
///Derived fields. (16 add, 41 mul, 4 div, 2 sqrt, 3 fn a point; 21 once)
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    const WIDE: bool = false;
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
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
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
        let t4 = cos_theta * reciprocal(r);
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let t5 = reciprocal(cos_theta);
        let tan_theta = t5 * sin_theta;
        let theta1 = at.state::<Real>(2);
        let Q = -(EI
            * (t4 * t4 * (theta_2 + tan_theta - tan_theta * (u3 * (theta1 * theta1)))));
        at.write_field(9, Q);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (t4 * (theta_1 - Real::splat(1.0))));
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
        let arc = r * t5;
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
