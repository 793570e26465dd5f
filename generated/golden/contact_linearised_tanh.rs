// contact_linearised_tanh: The belt in a groove: linearised shear, tanh friction.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 26 add, 74 mul, 6 div, 2 sqrt, 3 fn a point; 39 once
//   jacobian: 115 add, 313 mul, 7 div, 2 sqrt, 3 fn a point; 92 once
//   full: 199 add, 500 mul, 7 div, 2 sqrt, 3 fn a point; 135 once
//   fields: 15 add, 38 mul, 4 div, 2 sqrt, 4 fn a point; 27 once
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
// - saturation (typed in): smooth law
// - mu (typed in): Fig. 3.6
// - face_speed (typed in): (3.13), (3.14)
// - f_r (typed in): (3.13) to (3.15)
// - f_t (typed in): (3.13) to (3.15)
// - p (typed in): (3.16) to (3.18)
// - q (typed in): (3.7)
// - n (typed in): (3.20)
// - t (typed in): (3.21)
// - M_b (derived): (3.32)
// - Q (derived): (3.38)
// - theta_30 (derived): (3.40)
// - Q_theta3 (derived): (3.40)
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

///The belt in a groove: linearised shear, tanh friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_linearised_tanh",
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
/// Right-hand side and integrands.
///
/// 26 add, 74 mul, 6 div, 2 sqrt, 3 fn a point; 39 once.
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
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
        let t1 = reciprocal(R + Real::splat(2.0) * x);
        let axial = u11 * x;
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let F = u5 * (u3 + m_o * T);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let v_t = cos_theta * V - omega * r;
        let t3 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t3));
        let face_speed = sqrt(u8 * t3 + speed * speed);
        let t4 = reciprocal(face_speed);
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        let f_r = t4 * (v_r * mu);
        let f_t = t4 * (v_t * mu);
        let p = u11 * (x * reciprocal(cos_beta + u10 * f_r));
        let loss_radial = u18 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let q = Real::splat(2.0) * (r * p);
        let t5 = reciprocal(cos_theta);
        let tan_theta = t5 * sin_theta;
        let arc = r * t5;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(6, A_hat_1);
        let t6 = r * A_hat_1;
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(7, L_o_hat_1);
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(5, M_hat_1);
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let t7 = tan_theta * tan_theta;
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(4, x_hat_1);
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let theta_3 = u16 * t1 * (n + T * theta_1 - T)
            - (theta_1 * t7 + (theta_1 + t7)) * (r * t1);
        let theta_hat_3 = u17 * theta_3;
        at.write_f(3, theta_hat_3);
        let t8 = theta_1 - Real::splat(1.0);
        let t9 = cos_theta * reciprocal(r) * t8;
        let stored = u20 * (t9 * t9) - u19 * (x * x);
        let theta2 = at.state::<Real>(3);
        let T_hat_1 = Phi
            * (t - t8 * (u14 * (u12 * theta2 + R * tan_theta - x * tan_theta)));
        at.write_f(2, theta2);
        at.write_f(0, T_hat_1);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
        let s = at.position::<Real>();
        let t10 = Phi * s;
        let (sin_t10, cos_t10) = sin_cos(t10);
        let A_x_hat_1 = cos_t10 * t6;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t6 * sin_t10;
        at.write_f(10, A_y_hat_1);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 115 add, 313 mul, 7 div, 2 sqrt, 3 fn a point; 92 once.
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 33;
    const DC: usize = 21;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 59];
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
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u3 = G * G;
        let u4 = EA * m_o;
        let u5 = reciprocal(u4 - u3);
        let u6 = EA * u5;
        let V_T = G * u5;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u7 = sin_beta * sin_beta;
        let u8 = reciprocal(cos_beta);
        let u9 = u8 * u8;
        let u10 = u7 * u9;
        let v_thr = constants[11];
        let u11 = reciprocal(v_thr);
        let u12 = u11 * 4.0;
        let u13 = sin_beta * u8;
        let k = constants[5];
        let u14 = k * 0.5;
        let u15 = u2 * u2;
        let u16 = R * u15;
        let EI = constants[4];
        let u17 = reciprocal(R);
        let u18 = u17 * u17;
        let u19 = EI * (u17 * u18);
        let u20 = reciprocal(EI);
        let u21 = u20 * (R * (R * R));
        let u22 = Phi * Phi;
        let u23 = Phi * u22;
        let u24 = 2.0 * u9;
        let u25 = u8 * (k * sin_beta);
        let u26 = 0.5 * u25;
        let u27 = EI * EI * (0.5 * u20);
        let u28 = omega_P * (m_o * R_P);
        let u29 = u5 * u5;
        let u30 = G * (EA * 2.0);
        let u31 = u29 * u30;
        let u32 = u5 * u30;
        let u33 = EA * EA;
        let u34 = u29 * (2.0 * u3);
        let u35 = 0.5 * (u9 * (2.0 * u7));
        let u36 = 2.0 * u14;
        let u37 = 2.0 * u19;
        let u38 = u21 * u21;
        let u39 = Phi * u19;
        let u40 = u22 * 3.0;
        let u41 = Phi * u14;
        let u42 = Phi * EA;
        let u43 = Phi * reciprocal(EA);
        let u44 = u11 * (mu_k * 4.0);
        let u45 = Phi * V_T;
        let u46 = u25 * u45;
        let u47 = EI * (EI * u20 * u45);
        let u48 = u4 * u5 * u43;
        let u49 = Phi * 2.0;
        let u50 = Phi * u24;
        let u51 = u28 * (u5 + u34);
        let u52 = EI * u18;
        let u53 = Phi * (u15 * u52);
        let u54 = Phi * (2.0 * (u2 * u15) * u52);
        let u55 = 2.0 * u21;
        let u56 = 2.0 * u26;
        let u57 = Phi * u56;
        let u58 = u2 * u39;
        let u59 = u15 * u39;
        let u60 = u2 * u23;
        let u61 = u15 * u23;
        let u62 = u2 * u47;
        let u63 = u15 * u47;
        let u64 = V_T * u58;
        let u65 = V_T * u53;
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
            u5,
            u6,
            V_T,
            omega,
            sin_beta,
            u10,
            u12,
            u13,
            u14,
            u16,
            u19,
            u21,
            u23,
            u24,
            u26,
            u27,
            u28,
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
            u46,
            u47,
            u48,
            u49,
            u50,
            u51,
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
        let u5 = Real::splat(uniforms[9]);
        let u6 = Real::splat(uniforms[10]);
        let V_T = Real::splat(uniforms[11]);
        let omega = Real::splat(uniforms[12]);
        let sin_beta = Real::splat(uniforms[13]);
        let u10 = Real::splat(uniforms[14]);
        let u12 = Real::splat(uniforms[15]);
        let u13 = Real::splat(uniforms[16]);
        let u14 = Real::splat(uniforms[17]);
        let u16 = Real::splat(uniforms[18]);
        let u19 = Real::splat(uniforms[19]);
        let u21 = Real::splat(uniforms[20]);
        let u23 = Real::splat(uniforms[21]);
        let u24 = Real::splat(uniforms[22]);
        let u26 = Real::splat(uniforms[23]);
        let u27 = Real::splat(uniforms[24]);
        let u28 = Real::splat(uniforms[25]);
        let u31 = Real::splat(uniforms[26]);
        let u32 = Real::splat(uniforms[27]);
        let u33 = Real::splat(uniforms[28]);
        let u34 = Real::splat(uniforms[29]);
        let u35 = Real::splat(uniforms[30]);
        let u36 = Real::splat(uniforms[31]);
        let u37 = Real::splat(uniforms[32]);
        let u38 = Real::splat(uniforms[33]);
        let u39 = Real::splat(uniforms[34]);
        let u40 = Real::splat(uniforms[35]);
        let u41 = Real::splat(uniforms[36]);
        let u42 = Real::splat(uniforms[37]);
        let u43 = Real::splat(uniforms[38]);
        let u44 = Real::splat(uniforms[39]);
        let u46 = Real::splat(uniforms[40]);
        let u47 = Real::splat(uniforms[41]);
        let u48 = Real::splat(uniforms[42]);
        let u49 = Real::splat(uniforms[43]);
        let u50 = Real::splat(uniforms[44]);
        let u51 = Real::splat(uniforms[45]);
        let u53 = Real::splat(uniforms[46]);
        let u54 = Real::splat(uniforms[47]);
        let u55 = Real::splat(uniforms[48]);
        let u56 = Real::splat(uniforms[49]);
        let u57 = Real::splat(uniforms[50]);
        let u58 = Real::splat(uniforms[51]);
        let u59 = Real::splat(uniforms[52]);
        let u60 = Real::splat(uniforms[53]);
        let u61 = Real::splat(uniforms[54]);
        let u62 = Real::splat(uniforms[55]);
        let u63 = Real::splat(uniforms[56]);
        let u64 = Real::splat(uniforms[57]);
        let u65 = Real::splat(uniforms[58]);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = omega_P * r;
        let t2 = reciprocal(R + Real::splat(2.0) * x);
        let t3 = u21 * t2;
        let t4 = r * t2;
        let t5 = t2 * t2;
        let axial = u14 * x;
        let t6 = u41 * x;
        let T = at.state::<Real>(0);
        let t7 = T + EA;
        let V = V_T * t7;
        let t8 = u28 * (u5 * t7 + u34 * t7);
        let t9 = u3 + m_o * T;
        let F = u6 * t9;
        let t10 = reciprocal(EA + F);
        let t11 = u42 * t10;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t13 = cos_theta * V;
        let v_t = t13 - omega * r;
        let t14 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t14));
        let face_speed = sqrt(u10 * t14 + speed * speed);
        let t15 = reciprocal(face_speed);
        let t16 = speed * t15;
        let t17 = t15 * t15;
        let t18 = v_r * t15;
        let t19 = u35 * t18;
        let saturation = tanh(u12 * speed);
        let t20 = reciprocal(speed);
        let t21 = v_r * t20;
        let t22 = v_t * t20;
        let mu = mu_k * saturation;
        let t23 = u44 * (Real::splat(1.0) - saturation * saturation);
        let t24 = v_r * mu;
        let f_r = t15 * t24;
        let t25 = t24 * t17;
        let t26 = t18 * t23 - t16 * t25;
        let t27 = t22 * t26;
        let t28 = reciprocal(cos_beta + u13 * f_r);
        let t29 = x * t28;
        let p = u14 * t29;
        let t30 = u36 * (r * t28) - u36 * t29;
        let t31 = r * p;
        let q = Real::splat(2.0) * t31;
        let t32 = u49 * t31;
        let t33 = x * (t28 * t28);
        let t34 = r * t33;
        let t35 = f_r - sin_beta;
        let t36 = v_r * f_r;
        let loss_radial = u24 * (p * t36);
        let t37 = v_t * mu;
        let t38 = t37 * t17;
        let t39 = v_t * t15 * t23 - t16 * t38;
        let t40 = t21 * t39 - t19 * t38;
        let f_t = t15 * t37;
        let t41 = mu * t15;
        let t42 = t41 - t19 * t25 + t21 * t26;
        let t43 = t41 + t22 * t39;
        let t44 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t44);
        let loss = loss_radial + loss_tangential;
        let t45 = Phi * loss;
        let t46 = f_t * q;
        let t47 = Phi * t46;
        let t48 = reciprocal(cos_theta);
        let tan_theta = t48 * sin_theta;
        let t49 = f_t + tan_theta * t35;
        let t = q * t49;
        let t50 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t50;
        let t51 = t50 * t3;
        let t52 = u23 * (u55 * (t31 * t2) + t51 * (u56 * t34));
        let t53 = tan_theta * tan_theta;
        let t54 = Real::splat(1.0) + t53;
        let t55 = T * t3 - t4 * t54;
        let d_theta_hat_3_d_theta1 = u60 * t55;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let d_x_hat_1_d_theta = -(t54 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let t56 = r * tan_theta;
        let x_hat_1 = -(Phi * t56);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t56;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t57 = tan_theta * q;
        let t58 = Phi * t57 - u57 * (t49 * t34);
        let t59 = u23 * (t3 * t57);
        let t60 = t40 * t59 - t42 * t52;
        let t61 = t43 * t59 - t27 * t52;
        let d_theta_hat_3_d_sigma = -(t1 * t61);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let t62 = t32 * t40 + t42 * t58;
        let t63 = t32 * t43 + t27 * t58;
        let d_T_hat_1_d_sigma = -(t1 * t63);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let arc = r * t48;
        let t64 = u49 * (arc * t44) + u50 * (arc * t36);
        let t65 = u50 * (arc * (v_r * p)) - u26 * t33 * t64;
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t66 = u49 * (arc * (v_t * p));
        let t67 = u50 * (arc * (f_r * p)) + t66 * t40 + t65 * t42;
        let t68 = u49 * (arc * (f_t * p)) + t66 * t43 + t65 * t27;
        let d_W_hat_1_d_x = u14 * t28 * t64 - t48 * t45 + omega * t68;
        at.write_dy(23, d_W_hat_1_d_x);
        let t69 = arc * f_t;
        let t70 = u57 * (t69 * t34);
        let d_M_hat_1_d_Phi = q * t69;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let d_W_hat_1_d_sigma = -(t1 * t68);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t71 = r * A_hat_1;
        let d_L_o_hat_1_d_Phi = arc * (EA * t10);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t72 = arc * (u33 * (t10 * t10));
        let d_L_o_hat_1_d_flow = -(u28 * ((u31 * t9 + u32) * (u43 * t72)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_T = -(u48 * t72);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t73 = Phi * (arc * q);
        let t74 = t73 * t40 - t42 * t70;
        let t75 = t73 * t43 - t27 * t70;
        let d_M_hat_1_d_x = Phi * t69 * t30 - t48 * t47 + omega * t75;
        at.write_dy(15, d_M_hat_1_d_x);
        let t76 = u41 * arc;
        let d_A_hat_1_d_x = t76 - t48 * t6;
        at.write_dy(17, d_A_hat_1_d_x);
        let d_M_hat_1_d_sigma = -(t1 * t75);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t77 = t48 * t48 * (r * sin_theta);
        let d_M_hat_1_d_theta = t13 * t74 + t77 * t47 - v_r * t75;
        at.write_dy(14, d_M_hat_1_d_theta);
        let d_W_hat_1_d_theta = t13 * t67 + t77 * t45 - v_r * t68;
        at.write_dy(22, d_W_hat_1_d_theta);
        let d_A_hat_1_d_theta = t77 * t6;
        at.write_dy(16, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t77 * t11;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t48 * t11);
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t78 = cos_theta * reciprocal(r);
        let t79 = V_T * sin_theta;
        let t80 = sin_theta * t8;
        let t81 = cos_theta * t8;
        let t82 = V_T * cos_theta;
        let d_M_hat_1_d_T = t79 * t74 + t82 * t75;
        at.write_dy(13, d_M_hat_1_d_T);
        let d_M_hat_1_d_flow = t80 * t74 + t81 * t75;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_W_hat_1_d_T = t79 * t67 + t82 * t68;
        at.write_dy(21, d_W_hat_1_d_T);
        let d_W_hat_1_d_flow = t80 * t67 + t81 * t68;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_theta_hat_3_d_flow = t80 * t60 + t81 * t61;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let t83 = t80 * t62;
        let d_T_hat_1_d_flow = t83 + t81 * t63;
        at.write_dc(2, d_T_hat_1_d_flow);
        let t84 = t79 * t62;
        let d_T_hat_1_d_T = t84 + t82 * t63;
        at.write_dy(0, d_T_hat_1_d_T);
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t85 = n + T * theta_1 - T;
        let t86 = theta_1 * t53 + (theta_1 + t53);
        let t87 = t2 * t86 + Real::splat(2.0) * (t5 * (r * t86))
            - u37 * (t85 * (u38 * t5));
        let d_theta_hat_3_d_x = u23 * (t87 + t51 * t30) + omega * t61;
        at.write_dy(10, d_theta_hat_3_d_x);
        let theta_3 = t3 * t85 - t86 * t4;
        let t88 = u23
            * (t54
                * (t3 * t46
                    - t4
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t88 + t13 * t60 - v_r * t61;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let d_theta_hat_3_d_Phi = u40 * theta_3 - u61 * (theta1 * t55);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let theta_hat_3 = u23 * theta_3;
        at.write_f(3, theta_hat_3);
        let t89 = theta_1 - Real::splat(1.0);
        let t90 = t54 * (Phi * (q * t35) - u39 * (r * t89)) + t13 * t62;
        let d_theta_hat_3_d_T = u23 * (t89 * t3) + t79 * t60 + t82 * t61;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t91 = u39 * (tan_theta * t89) + Phi * t49 * t30;
        let d_T_hat_1_d_x = t91 + omega * t63;
        at.write_dy(4, d_T_hat_1_d_x);
        let d_T_hat_1_d_theta = t90 - v_r * t63;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t92 = t78 * t89;
        let stored = u27 * (t92 * t92) - u26 * (x * x);
        let t93 = V_T * stored;
        let t94 = t93 * t63;
        let d_E_hat_1_d_T = t93 * t84 + t82 * t94;
        at.write_dy(28, d_E_hat_1_d_T);
        let d_E_hat_1_d_sigma = -(t1 * t94);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_theta2 = -(u65 * (t89 * stored));
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_T_hat_1_d_theta2 = -(u53 * t89);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let theta2 = at.state::<Real>(3);
        let t95 = u16 * theta2 + R * tan_theta - x * tan_theta;
        let t96 = t - t89 * (u19 * t95);
        let t97 = t92 * t96;
        at.write_f(2, theta2);
        let d_T_hat_1_d_Phi = t96 + u54 * (theta2 * t89) + u59 * (theta1 * t95);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t98 = u47 * (t89 * (t78 * t78) * t97);
        let d_E_hat_1_d_theta = t93 * t90 - t77 * t98 - v_r * t94;
        let d_E_hat_1_d_x = t48 * t98 - u46 * (x * t96) + t93 * t91 + omega * t94;
        at.write_dy(32, d_E_hat_1_d_x);
        at.write_dy(29, d_E_hat_1_d_theta);
        let t99 = t78 * t97;
        let d_E_hat_1_d_Phi = t93 * d_T_hat_1_d_Phi - u63 * (theta1 * t99);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_theta1 = u62 * t99 - u64 * (t95 * stored);
        at.write_dy(30, d_E_hat_1_d_theta1);
        let T_hat_1 = Phi * t96;
        at.write_f(0, T_hat_1);
        let t100 = T_hat_1 * stored;
        let d_E_hat_1_d_flow = u51 * t100 + t93 * t83 + t81 * t94;
        at.write_dc(20, d_E_hat_1_d_flow);
        let E_hat_1 = V_T * t100;
        at.write_f(11, E_hat_1);
        let d_T_hat_1_d_theta1 = -(u58 * t95);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let s = at.position::<Real>();
        let t101 = Phi * s;
        let t102 = A_hat_1 * (s * r);
        let (sin_t101, cos_t101) = sin_cos(t101);
        let A_x_hat_1 = cos_t101 * t71;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t71 * sin_t101;
        at.write_f(10, A_y_hat_1);
        let t104 = r * cos_t101;
        let t105 = r * sin_t101;
        let t106 = t6 * t105;
        let t107 = t6 * t104;
        let d_A_x_hat_1_d_theta = t77 * t107;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t104 * t76 - A_hat_1 * cos_t101 - t48 * t107;
        let d_A_y_hat_1_d_x = t105 * t76 - A_hat_1 * sin_t101 - t48 * t106;
        at.write_dy(27, d_A_y_hat_1_d_x);
        at.write_dy(25, d_A_x_hat_1_d_x);
        let d_A_y_hat_1_d_theta = t77 * t106;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_Phi = cos_t101 * t102 + d_A_hat_1_d_Phi * t105;
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t104 - sin_t101 * t102;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        at.write_dc(17, d_A_y_hat_1_d_Phi);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 199 add, 500 mul, 7 div, 2 sqrt, 3 fn a point; 135 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 33;
    const DC: usize = 81;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 89];
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
        let u18 = R * u3;
        let EI = constants[4];
        let u19 = reciprocal(R);
        let u20 = u19 * u19;
        let u21 = u19 * u20;
        let u22 = EI * u21;
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
        let u51 = u19 * u21 * (EI * 3.0);
        let u52 = u24 * u24;
        let u53 = Phi * u22;
        let u54 = u25 * 3.0;
        let u55 = u27 * u27;
        let u56 = Phi * u17;
        let u57 = Phi * EA;
        let u58 = u8 + u44;
        let u59 = 0.5 * (u12 * (k * u10));
        let u60 = Phi * V_T;
        let u61 = u29 * u60;
        let u62 = u31 * (0.5 * (u23 * u23)) * u60;
        let u63 = u16 * 0.5 * u60;
        let u64 = EI * u23 * u60;
        let u65 = Phi * 2.0;
        let u66 = Phi * (u47 * (sin_beta * 4.0));
        let u67 = Phi * u28;
        let u68 = Phi * 0.5;
        let u69 = Phi * u27;
        let u70 = V_T * u53;
        let u71 = u24 * u26;
        let u72 = u26 * (2.0 * u22);
        let u73 = u21 * u26;
        let u74 = Phi * u21;
        let u75 = u22 * u60;
        let u76 = u21 * u60;
        let u77 = EI * u64;
        let u78 = Phi * cos_beta;
        let u79 = cos_beta * u60;
        let u80 = 2.0 * u60;
        let u81 = cos_beta * 2.0 * u71;
        let u82 = 2.0 * u71;
        let u83 = Phi * u50;
        let u84 = u17 * u65;
        let u85 = 0.5 * u65;
        let u86 = u30 * u65;
        let u87 = mu_k * 4.0;
        let u88 = u14 * u14 * u87;
        let u89 = u14 * u87;
        let u90 = u7 * u8 * u69;
        let u91 = EI * u20;
        let u92 = Phi * u91;
        let u93 = u3 * u92;
        let u94 = 2.0 * (u2 * u3);
        let u95 = u94 * u92;
        let u96 = u91 * u60;
        let u97 = u3 * u96;
        let u98 = u94 * u96;
        let u99 = u2 * u53;
        let u100 = u3 * u53;
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
            u18,
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
            u63,
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
            u93,
            u95,
            u97,
            u98,
            u99,
            u100,
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
        let u18 = Real::splat(uniforms[21]);
        let u22 = Real::splat(uniforms[22]);
        let u24 = Real::splat(uniforms[23]);
        let u26 = Real::splat(uniforms[24]);
        let u27 = Real::splat(uniforms[25]);
        let u28 = Real::splat(uniforms[26]);
        let u30 = Real::splat(uniforms[27]);
        let u32 = Real::splat(uniforms[28]);
        let u33 = Real::splat(uniforms[29]);
        let u34 = Real::splat(uniforms[30]);
        let u35 = Real::splat(uniforms[31]);
        let u37 = Real::splat(uniforms[32]);
        let u39 = Real::splat(uniforms[33]);
        let u40 = Real::splat(uniforms[34]);
        let u41 = Real::splat(uniforms[35]);
        let u42 = Real::splat(uniforms[36]);
        let u43 = Real::splat(uniforms[37]);
        let u44 = Real::splat(uniforms[38]);
        let u45 = Real::splat(uniforms[39]);
        let u46 = Real::splat(uniforms[40]);
        let u48 = Real::splat(uniforms[41]);
        let u49 = Real::splat(uniforms[42]);
        let u50 = Real::splat(uniforms[43]);
        let u51 = Real::splat(uniforms[44]);
        let u52 = Real::splat(uniforms[45]);
        let u53 = Real::splat(uniforms[46]);
        let u54 = Real::splat(uniforms[47]);
        let u55 = Real::splat(uniforms[48]);
        let u56 = Real::splat(uniforms[49]);
        let u57 = Real::splat(uniforms[50]);
        let u58 = Real::splat(uniforms[51]);
        let u59 = Real::splat(uniforms[52]);
        let u60 = Real::splat(uniforms[53]);
        let u61 = Real::splat(uniforms[54]);
        let u62 = Real::splat(uniforms[55]);
        let u63 = Real::splat(uniforms[56]);
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
        let u77 = Real::splat(uniforms[70]);
        let u78 = Real::splat(uniforms[71]);
        let u79 = Real::splat(uniforms[72]);
        let u80 = Real::splat(uniforms[73]);
        let u81 = Real::splat(uniforms[74]);
        let u82 = Real::splat(uniforms[75]);
        let u83 = Real::splat(uniforms[76]);
        let u84 = Real::splat(uniforms[77]);
        let u85 = Real::splat(uniforms[78]);
        let u86 = Real::splat(uniforms[79]);
        let u88 = Real::splat(uniforms[80]);
        let u89 = Real::splat(uniforms[81]);
        let u90 = Real::splat(uniforms[82]);
        let u93 = Real::splat(uniforms[83]);
        let u95 = Real::splat(uniforms[84]);
        let u97 = Real::splat(uniforms[85]);
        let u98 = Real::splat(uniforms[86]);
        let u99 = Real::splat(uniforms[87]);
        let u100 = Real::splat(uniforms[88]);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = Real::splat(2.0) * r;
        let t2 = R + Real::splat(2.0) * x;
        let t3 = reciprocal(t2);
        let t4 = u24 * t3;
        let t5 = r * t3;
        let t6 = u71 * t3;
        let t7 = t3 * t3;
        let axial = u17 * x;
        let t8 = x * x;
        let t9 = u56 * x;
        let t10 = Real::splat(0.5) * x;
        let T = at.state::<Real>(0);
        let t11 = T + EA;
        let V = V_T * t11;
        let t12 = u8 * t11 + u44 * t11;
        let t13 = V_T - u43 * t11;
        let t14 = u45 * t11;
        let t15 = u6 + m_o * T;
        let F = u9 * t15;
        let t16 = EA + F;
        let t17 = reciprocal(t16);
        let t18 = u57 * t17;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t20 = cos_theta * V;
        let v_t = t20 - omega * r;
        let t21 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t21));
        let face_speed = sqrt(u13 * t21 + speed * speed);
        let t22 = reciprocal(face_speed);
        let t23 = Real::splat(0.5) * t22 * (u46 * t21 + u48 * t21);
        let t24 = v_t * t22;
        let t25 = v_r * t22;
        let t26 = u49 * t25;
        let t27 = speed * t22;
        let t28 = t22 * t22;
        let saturation = tanh(u15 * speed);
        let mu = mu_k * saturation;
        let t29 = v_r * mu;
        let f_r = t22 * t29;
        let t30 = t29 * t28;
        let t31 = reciprocal(cos_beta + u16 * f_r);
        let t32 = x * t31;
        let p = u17 * t32;
        let t33 = r * p;
        let q = Real::splat(2.0) * t33;
        let t34 = u65 * t33;
        let t35 = t33 * t3;
        let t36 = u50 * t32;
        let t37 = Real::splat(0.5) * t32;
        let t38 = x * (t31 * t31);
        let t39 = u30 * t38;
        let t40 = u17 * t31;
        let t41 = f_r - sin_beta;
        let t42 = q * t41;
        let t43 = (t41 + u13 * f_r) * t38;
        let t44 = u17 * t43;
        let t45 = v_r * f_r;
        let t46 = p * t45;
        let loss_radial = u28 * t46;
        let t47 = v_t * mu;
        let t48 = t47 * t28;
        let f_t = t22 * t47;
        let t49 = mu * t22;
        let t50 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t50);
        let loss = loss_radial + loss_tangential;
        let t51 = Phi * loss;
        let t52 = f_t * q;
        let t53 = Phi * t52;
        let t54 = Real::splat(1.0) - saturation * saturation;
        let t55 = reciprocal(speed);
        let t56 = v_t * t55;
        let t57 = v_r * t55;
        let t58 = reciprocal(cos_theta);
        let tan_theta = t58 * sin_theta;
        let t59 = f_t + tan_theta * t41;
        let t = q * t59;
        let t60 = r * t59;
        let d_T_hat_1_d_k = u85 * (t32 * t60);
        at.write_dc(23, d_T_hat_1_d_k);
        let t61 = u83 * (t32 * t59);
        let t62 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t62;
        let t63 = t62 * t6;
        let t64 = t1 * t63;
        let t65 = t36 * t63;
        let t66 = u82 * t35 + t39 * t64;
        let d_theta_hat_3_d_k = t37 * t64;
        at.write_dc(33, d_theta_hat_3_d_k);
        let t67 = tan_theta * tan_theta;
        let t68 = Real::splat(1.0) + t67;
        let t69 = u26 * (T * t4) - u26 * (t5 * t68);
        let d_theta_hat_3_d_theta1 = u2 * t69;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let d_x_hat_1_d_theta = -(t68 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let t70 = r * tan_theta;
        let x_hat_1 = -(Phi * t70);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t70;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t71 = tan_theta * q;
        let t72 = Phi * t71 - u86 * (t38 * t60);
        let t73 = t24 * t34 + t25 * t72;
        let t74 = t54 * t73;
        let d_T_hat_1_d_mu_k = saturation * t73;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(u88 * (speed * t74));
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let t75 = t48 * t34 + t30 * t72;
        let t76 = u89 * t74 - t27 * t75;
        let t77 = t49 * t34 + t56 * t76;
        let t78 = t49 * t72 - t26 * t75 + t57 * t76;
        let d_T_hat_1_d_beta = -(u78 * t71 + u84 * (t43 * t60) + t23 * t75);
        at.write_dc(27, d_T_hat_1_d_beta);
        let t79 = cos_theta * t77 + sin_theta * t78;
        let d_T_hat_1_d_T = V_T * t79;
        at.write_dy(0, d_T_hat_1_d_T);
        let t80 = t12 * t79;
        let d_T_hat_1_d_flow = u34 * t80;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_T_hat_1_d_m_o = u35 * t80 - t14 * t79;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_EA = t13 * t79;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_R_P = u33 * t80;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t81 = omega * t77;
        let t82 = r * t77;
        let d_T_hat_1_d_omega_P = u5 * t80 - sigma * t82;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_T_hat_1_d_sigma = -(omega_P * t82);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t83 = t71 * t6;
        let t84 = t30 * t66 - t48 * t83;
        let d_theta_hat_3_d_beta = u81 * t35 - t44 * t64 + t23 * t84;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let t85 = t24 * t83 - t25 * t66;
        let t86 = t54 * t85;
        let d_theta_hat_3_d_mu_k = saturation * t85;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let t87 = t27 * t84 + u89 * t86;
        let t88 = t26 * t84 - t49 * t66 + t57 * t87;
        let t89 = t49 * t83 + t56 * t87;
        let d_theta_hat_3_d_v_thr = -(u88 * (speed * t86));
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let t90 = cos_theta * t89 + sin_theta * t88;
        let t91 = t12 * t90;
        let d_theta_hat_3_d_flow = u34 * t91;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_theta_hat_3_d_m_o = u35 * t91 - t14 * t90;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R_P = u33 * t91;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_EA = t13 * t90;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let t92 = omega * t89;
        let t93 = r * t89;
        let d_theta_hat_3_d_omega_P = u5 * t91 - sigma * t93;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_theta_hat_3_d_sigma = -(omega_P * t93);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let arc = r * t58;
        let t94 = u65 * (arc * t50) + u67 * (arc * t45);
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t95 = u65 * (arc * (v_t * p));
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t96 = r * A_hat_1;
        let t97 = u67 * (arc * (v_r * p)) - t39 * t94;
        let t98 = t24 * t95 + t25 * t97;
        let t99 = t54 * t98;
        let d_W_hat_1_d_mu_k = saturation * t98;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(u88 * (speed * t99));
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let t100 = t48 * t95 + t30 * t97;
        let t101 = u89 * t99 - t27 * t100;
        let t102 = u67 * (arc * (f_r * p)) + t49 * t97 - t26 * t100 + t57 * t101;
        let t103 = u65 * (arc * (f_t * p)) + t49 * t95 + t56 * t101;
        let d_W_hat_1_d_beta = u66 * (arc * t46) - t44 * t94 - t23 * t100;
        at.write_dc(63, d_W_hat_1_d_beta);
        let t104 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t104;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let t105 = Phi * (arc * q);
        let t106 = r * t104;
        let t107 = u86 * (t38 * t106);
        let t108 = u83 * (t32 * t104);
        let d_M_hat_1_d_k = u85 * (t32 * t106);
        at.write_dc(43, d_M_hat_1_d_k);
        let t109 = t30 * t107 - t48 * t105;
        let d_M_hat_1_d_beta = t23 * t109 - u84 * (t43 * t106);
        at.write_dc(47, d_M_hat_1_d_beta);
        let t110 = t24 * t105 - t25 * t107;
        let t111 = t54 * t110;
        let d_M_hat_1_d_mu_k = saturation * t110;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let t112 = t27 * t109 + u89 * t111;
        let t113 = t26 * t109 - t49 * t107 + t57 * t112;
        let t114 = t49 * t105 + t56 * t112;
        let d_M_hat_1_d_v_thr = -(u88 * (speed * t111));
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let t115 = cos_theta * t114 + sin_theta * t113;
        let d_M_hat_1_d_T = V_T * t115;
        at.write_dy(13, d_M_hat_1_d_T);
        let t116 = t12 * t115;
        let d_M_hat_1_d_flow = u34 * t116;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_M_hat_1_d_m_o = u35 * t116 - t14 * t115;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_EA = t13 * t115;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_R_P = u33 * t116;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let t117 = omega * t114;
        let t118 = r * t114;
        let d_M_hat_1_d_omega_P = u5 * t116 - sigma * t118;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_M_hat_1_d_sigma = -(omega_P * t118);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t119 = cos_theta * t103 + sin_theta * t102;
        let d_W_hat_1_d_T = V_T * t119;
        at.write_dy(21, d_W_hat_1_d_T);
        let t120 = t12 * t119;
        let d_W_hat_1_d_flow = u34 * t120;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_W_hat_1_d_m_o = u35 * t120 - t14 * t119;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_EA = t13 * t119;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_R_P = u33 * t120;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let t121 = omega * t103;
        let t122 = r * t103;
        let d_W_hat_1_d_omega_P = u5 * t120 - sigma * t122;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let d_W_hat_1_d_sigma = -(omega_P * t122);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_k = t37 * t94;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_L_o_hat_1_d_Phi = arc * (EA * t17);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t123 = arc * (u41 * (t17 * t17));
        let d_L_o_hat_1_d_T = -(u90 * t123);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t124 = u69 * t123;
        let t125 = (u27 - u55 * t16) * (Phi * t123) + (u8 * t15 - u37 * t15) * t124;
        let d_L_o_hat_1_d_EA = -t125;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let t126 = (u39 * t15 + u40) * t124;
        let d_L_o_hat_1_d_m_o = -((u9 * T - u42 * t15) * t124 + u35 * t126);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_flow = -(u34 * t126);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u33 * t126);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t126);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let t127 = Phi * arc;
        let d_A_hat_1_d_k = u68 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        let t128 = t58 * t58 * (r * sin_theta);
        let d_M_hat_1_d_theta = t20 * t113 - v_r * t114 + t128 * t53;
        at.write_dy(14, d_M_hat_1_d_theta);
        let d_W_hat_1_d_theta = t20 * t102 - v_r * t103 + t128 * t51;
        at.write_dy(22, d_W_hat_1_d_theta);
        let t129 = t58 * t53;
        let d_M_hat_1_d_x = u84 * (t31 * t106) + t117 - t129 - t108;
        let d_M_hat_1_d_R = t108 + (t129 - t117);
        at.write_dc(45, d_M_hat_1_d_R);
        at.write_dy(15, d_M_hat_1_d_x);
        let t130 = t58 * t51;
        let d_W_hat_1_d_x = t40 * t94 + t121 - t130;
        at.write_dy(23, d_W_hat_1_d_x);
        let d_W_hat_1_d_R = t130 - t121;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_A_hat_1_d_theta = t128 * t9;
        at.write_dy(16, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t128 * t18;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t58 * t18;
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(20, d_L_o_hat_1_d_x);
        let d_A_hat_1_d_R = t58 * t9;
        let d_A_hat_1_d_x = u56 * arc - d_A_hat_1_d_R;
        at.write_dy(17, d_A_hat_1_d_x);
        at.write_dc(52, d_A_hat_1_d_R);
        let t131 = cos_theta * reciprocal(r);
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t132 = n + T * theta_1 - T;
        let t133 = t68
            * (t52 * t6
                - u26
                    * (t5
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t20 * t88 - v_r * t89 + t133;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t134 = theta_1 * t67 + (theta_1 + t67);
        let theta_3 = t4 * t132 - t134 * t5;
        let t135 = t3 * t134;
        let t136 = t7 * (r * t134);
        let t137 = t132 * (u52 * t7);
        let d_theta_hat_3_d_x = u26 * (t135 + Real::splat(2.0) * t136) - u72 * t137
            + t40 * t64 + t92 - t65;
        let d_theta_hat_3_d_R = t65
            + ((u51 * t2 - u22) * (u26 * t137) + u26 * (t136 - t135) - t92);
        at.write_dc(35, d_theta_hat_3_d_R);
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_theta_hat_3_d_EI = -(u73 * (t2 * t137));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let t138 = theta_1 - Real::splat(1.0);
        let d_T_hat_1_d_theta = t20 * t78 - v_r * t77
            + t68 * (Phi * t42 - u53 * (r * t138));
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_x = u53 * (tan_theta * t138) + u84 * (t31 * t60) + t81 - t61;
        at.write_dy(4, d_T_hat_1_d_x);
        let d_theta_hat_3_d_T = u26 * (t138 * t4) + V_T * t90;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t139 = t131 * t138;
        let t140 = t139 * t139;
        let stored = u32 * t140 - u30 * t8;
        let t141 = u80 * (t33 * stored);
        let t142 = u60 * stored;
        let t143 = t59 * t142;
        let t144 = t1 * t143;
        let t145 = t36 * t143;
        let t146 = t71 * t142 - t39 * t144;
        let t147 = t24 * t141 + t25 * t146;
        let t148 = t48 * t141 + t30 * t146;
        let t149 = t54 * t147;
        let d_E_hat_1_d_mu_k = saturation * t147;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let t150 = u89 * t149 - t27 * t148;
        let t151 = t49 * t146 - t26 * t148 + t57 * t150;
        let t152 = t49 * t141 + t56 * t150;
        let t153 = cos_theta * t152 + sin_theta * t151;
        let d_E_hat_1_d_v_thr = -(u88 * (speed * t149));
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_T = V_T * t153;
        at.write_dy(28, d_E_hat_1_d_T);
        let t154 = omega * t152;
        let t155 = r * t152;
        let d_E_hat_1_d_sigma = -(omega_P * t155);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t156 = t138 * stored;
        let t157 = t20 * t151 - v_r * t152 + t68 * (t42 * t142 - u75 * (r * t156));
        let d_E_hat_1_d_theta2 = -(u97 * t156);
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_T_hat_1_d_theta2 = -(u93 * t138);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let theta_hat_3 = u26 * theta_3;
        at.write_f(3, theta_hat_3);
        let t158 = u3 * theta1;
        let d_theta_hat_3_d_Phi = u54 * theta_3 - t158 * t69;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let theta2 = at.state::<Real>(3);
        at.write_f(2, theta2);
        let t159 = u18 * theta2 + R * tan_theta - x * tan_theta;
        let t160 = t - t138 * (u22 * t159);
        let t161 = (u17 * t8 + u59 * t8) * (u60 * t160) + u79 * (stored * t71)
            + t44 * t144;
        let d_E_hat_1_d_beta = -(t161 + t23 * t148);
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_k = t37 * t144 - u63 * (t160 * t8);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_T_hat_1_d_Phi = t160 + u95 * (theta2 * t138) + u100 * (theta1 * t159);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let T_hat_1 = Phi * t160;
        at.write_f(0, T_hat_1);
        let t162 = T_hat_1 * stored;
        let t163 = u58 * t162 + t12 * t153;
        let d_E_hat_1_d_m_o = u35 * t163 - (u45 * t162 + t14 * t153);
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_EA = t13 * t153 - u43 * t162;
        at.write_dc(71, d_E_hat_1_d_EA);
        let d_E_hat_1_d_omega_P = u5 * t163 - sigma * t155;
        at.write_dc(80, d_E_hat_1_d_omega_P);
        let E_hat_1 = V_T * t162;
        at.write_f(11, E_hat_1);
        let d_E_hat_1_d_flow = u34 * t163;
        at.write_dc(20, d_E_hat_1_d_flow);
        let d_E_hat_1_d_R_P = u33 * t163;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t164 = t139 * t160;
        let d_E_hat_1_d_EI = t139 * (u64 * t164)
            - (u62 * (t160 * t140) + u76 * (t159 * t156));
        at.write_dc(72, d_E_hat_1_d_EI);
        let t165 = u77 * (t138 * (t131 * t131) * t164);
        let t166 = u77 * (t131 * t164) - u70 * (t159 * stored);
        let d_E_hat_1_d_Phi = t160 * (V_T * stored) + u98 * (theta2 * t156)
            - t158 * t166;
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_theta1 = u2 * t166;
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta = t157 - t128 * t165;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t167 = t58 * t165;
        let t168 = u75 * (tan_theta * t156) - u61 * (x * t160) + t40 * t144 + t154
            + t167;
        let d_E_hat_1_d_x = t168 - t145;
        at.write_dy(32, d_E_hat_1_d_x);
        let theta_2 = u3 * theta2;
        let t169 = u51 * t159 - u22 * (theta_2 + tan_theta);
        let d_E_hat_1_d_R = t145 + (t169 * (u60 * t156) - t154 - t167);
        let d_T_hat_1_d_R = t61 + (t169 * (Phi * t138) - t81);
        at.write_dc(25, d_T_hat_1_d_R);
        at.write_dc(75, d_E_hat_1_d_R);
        let d_T_hat_1_d_EI = -(u74 * (t138 * t159));
        at.write_dc(22, d_T_hat_1_d_EI);
        let d_T_hat_1_d_theta1 = -(u99 * t159);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let s = at.position::<Real>();
        let t170 = Phi * s;
        let t171 = A_hat_1 * (s * r);
        let (sin_t170, cos_t170) = sin_cos(t170);
        let A_x_hat_1 = cos_t170 * t96;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t96 * sin_t170;
        at.write_f(10, A_y_hat_1);
        let t173 = r * cos_t170;
        let t174 = r * sin_t170;
        let t175 = t9 * t174;
        let t176 = t9 * t173;
        let d_A_x_hat_1_d_theta = t128 * t176;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let t177 = t58 * t176;
        let d_A_y_hat_1_d_theta = t128 * t175;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let t178 = t58 * t175;
        let t179 = t127 * t174;
        let d_A_y_hat_1_d_Phi = cos_t170 * t171 + d_A_hat_1_d_Phi * t174;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t173 - sin_t170 * t171;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let t180 = t127 * t173;
        let t181 = A_hat_1 * cos_t170;
        let t182 = A_hat_1 * sin_t170;
        let d_A_y_hat_1_d_x = u17 * t179 - t178 - t182;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let d_A_y_hat_1_d_R = t182 + t178;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_A_y_hat_1_d_k = t10 * t179;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_x_hat_1_d_k = t10 * t180;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_x = u17 * t180 - t177 - t181;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let d_A_x_hat_1_d_R = t181 + t177;
        at.write_dc(68, d_A_x_hat_1_d_R);
    }
}
/// Derived fields.
///
/// 15 add, 38 mul, 4 div, 2 sqrt, 4 fn a point; 27 once.
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    const WIDE: bool = false;
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
        let t2 = v_r * v_r;
        let t3 = reciprocal(cos_theta);
        let tan_theta = t3 * sin_theta;
        let x = at.state::<Real>(4);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        at.write_field(3, v_t);
        let arc = r * t3;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        at.write_field(4, speed);
        let face_speed = sqrt(u8 * t2 + speed * speed);
        let t4 = reciprocal(face_speed);
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let beta_s = angle(speed, u10 * v_r);
        at.write_field(8, beta_s);
        let f_r = t4 * (v_r * mu);
        let f_t = t4 * (v_t * mu);
        let p = u11 * (x * reciprocal(cos_beta + u10 * f_r));
        at.write_field(7, p);
        let loss_radial = u15 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let gamma_a = angle(v_r, v_t);
        let gamma = turn(gamma_a);
        at.write_field(5, gamma);
        at.write_field(14, loss_tangential);
        let loss = loss_radial + loss_tangential;
        at.write_field(13, loss_radial);
        at.write_field(12, loss);
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
        let axial = u11 * x;
        at.write_field(11, axial);
        let theta2 = at.state::<Real>(3);
        let Q = -(u14 * (u12 * theta2 + R * tan_theta - x * tan_theta));
        at.write_field(9, Q);
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (cos_theta * reciprocal(r) * (theta_1 - Real::splat(1.0))));
        at.write_field(10, M_b);
    }
}
