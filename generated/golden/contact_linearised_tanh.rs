// contact_linearised_tanh: The belt in a groove: linearised shear, tanh friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it anew.
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
///Right-hand side and integrands. (26 add, 74 mul, 6 div, 2 sqrt, 3 fn a point; 39 once)
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
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t2 = v_r * v_r;
        let v_t = cos_theta * V - omega * r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
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
        let t6 = reciprocal(R + Real::splat(2.0) * x);
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let t7 = tan_theta * tan_theta;
        let theta_3 = u16 * t6 * (n + T * theta_1 - T)
            - (theta_1 * t7 + (theta_1 + t7)) * (r * t6);
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
        let t11 = cos_theta * reciprocal(r) * t5;
        let stored = u20 * (t11 * t11) - u19 * (x * x);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and default unknowns. (115 add, 313 mul, 7 div, 2 sqrt, 3 fn a point; 92 once)
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
        let face_speed = sqrt(u10 * t3 + speed * speed);
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
        let t15 = u16 * theta2 + R * tan_theta - x * tan_theta;
        let t16 = t - t14 * (u19 * t15);
        let T_hat_1 = Phi * t16;
        at.write_f(0, T_hat_1);
        at.write_f(1, theta1);
        at.write_f(2, theta2);
        let t17 = reciprocal(R + Real::splat(2.0) * x);
        let t18 = u21 * t17;
        let t19 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t19;
        let t20 = n + T * theta_1 - T;
        let t21 = tan_theta * tan_theta;
        let t22 = theta_1 * t21 + (theta_1 + t21);
        let t23 = r * t17;
        let theta_3 = t18 * t20 - t22 * t23;
        let theta_hat_3 = u23 * theta_3;
        at.write_f(3, theta_hat_3);
        let t24 = r * tan_theta;
        let x_hat_1 = -(Phi * t24);
        at.write_f(4, x_hat_1);
        let arc = r * t11;
        let t25 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t25;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let axial = u14 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t26 = u3 + m_o * T;
        let F = u6 * t26;
        let t27 = reciprocal(EA + F);
        let d_L_o_hat_1_d_Phi = arc * (EA * t27);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t28 = v_r * f_r;
        let loss_radial = u24 * (p * t28);
        let t29 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t29);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let s = at.position::<Real>();
        let t30 = Phi * s;
        let (sin_t30, cos_t30) = sin_cos(t30);
        let t32 = r * A_hat_1;
        let A_x_hat_1 = cos_t30 * t32;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t32 * sin_t30;
        at.write_f(10, A_y_hat_1);
        let t33 = cos_theta * reciprocal(r);
        let t34 = t33 * t14;
        let stored = u27 * (t34 * t34) - u26 * (x * x);
        let t35 = T_hat_1 * stored;
        let E_hat_1 = V_T * t35;
        at.write_f(11, E_hat_1);
        let t36 = V_T * sin_theta;
        let t37 = u49 * t9;
        let t38 = reciprocal(speed);
        let t39 = v_r * t38;
        let t40 = u44 * (Real::splat(1.0) - saturation * saturation);
        let t41 = speed * t5;
        let t42 = t5 * t5;
        let t43 = t10 * t42;
        let t44 = v_t * t5 * t40 - t41 * t43;
        let t45 = v_r * t5;
        let t46 = u35 * t45;
        let t47 = t39 * t44 - t46 * t43;
        let t48 = mu * t5;
        let t49 = t6 * t42;
        let t50 = t45 * t40 - t41 * t49;
        let t51 = t48 - t46 * t49 + t39 * t50;
        let t52 = tan_theta * q;
        let t53 = x * (t7 * t7);
        let t54 = r * t53;
        let t55 = Phi * t52 - u57 * (t13 * t54);
        let t56 = t37 * t47 + t51 * t55;
        let t57 = t36 * t56;
        let t58 = V_T * cos_theta;
        let t59 = v_t * t38;
        let t60 = t48 + t59 * t44;
        let t61 = t59 * t50;
        let t62 = t37 * t60 + t61 * t55;
        let d_T_hat_1_d_T = t57 + t58 * t62;
        at.write_dy(0, d_T_hat_1_d_T);
        let t63 = Real::splat(1.0) + t21;
        let t64 = t63 * (Phi * (q * t12) - u39 * (r * t14)) + t4 * t56;
        let d_T_hat_1_d_theta = t64 - v_r * t62;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u58 * t15);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = -(u53 * t14);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t65 = u36 * (r * t7) - u36 * t8;
        let t66 = u39 * (tan_theta * t14) + Phi * t13 * t65;
        let d_T_hat_1_d_x = t66 + omega * t62;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t67 = u23 * (t18 * t52);
        let t68 = t19 * t18;
        let t69 = u23 * (u55 * (t9 * t17) + t68 * (u56 * t54));
        let t70 = t47 * t67 - t51 * t69;
        let t71 = t60 * t67 - t61 * t69;
        let d_theta_hat_3_d_T = u23 * (t14 * t18) + t36 * t70 + t58 * t71;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t72 = f_t * q;
        let t73 = u23
            * (t63
                * (t18 * t72
                    - t23
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t73 + t4 * t70 - v_r * t71;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t74 = T * t18 - t23 * t63;
        let d_theta_hat_3_d_theta1 = u60 * t74;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t75 = t17 * t17;
        let t76 = t17 * t22 + Real::splat(2.0) * (t75 * (r * t22))
            - u37 * (t20 * (u38 * t75));
        let d_theta_hat_3_d_x = u23 * (t76 + t68 * t65) + omega * t71;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t63 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let t77 = Phi * (arc * q);
        let t78 = u57 * (t25 * t54);
        let t79 = t77 * t47 - t51 * t78;
        let t80 = t77 * t60 - t61 * t78;
        let d_M_hat_1_d_T = t36 * t79 + t58 * t80;
        at.write_dy(13, d_M_hat_1_d_T);
        let t81 = t11 * t11 * (r * sin_theta);
        let t82 = Phi * t72;
        let d_M_hat_1_d_theta = t4 * t79 + t81 * t82 - v_r * t80;
        at.write_dy(14, d_M_hat_1_d_theta);
        let d_M_hat_1_d_x = Phi * t25 * t65 - t11 * t82 + omega * t80;
        at.write_dy(15, d_M_hat_1_d_x);
        let t83 = u41 * x;
        let d_A_hat_1_d_theta = t81 * t83;
        at.write_dy(16, d_A_hat_1_d_theta);
        let t84 = u41 * arc;
        let d_A_hat_1_d_x = t84 - t11 * t83;
        at.write_dy(17, d_A_hat_1_d_x);
        let t85 = arc * (u33 * (t27 * t27));
        let d_L_o_hat_1_d_T = -(u48 * t85);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t86 = u42 * t27;
        let d_L_o_hat_1_d_theta = t81 * t86;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t11 * t86);
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t87 = u49 * (arc * (v_t * p));
        let t88 = u49 * (arc * t29) + u50 * (arc * t28);
        let t89 = u50 * (arc * (v_r * p)) - u26 * t53 * t88;
        let t90 = u50 * (arc * (f_r * p)) + t87 * t47 + t89 * t51;
        let t91 = u49 * (arc * (f_t * p)) + t87 * t60 + t89 * t61;
        let d_W_hat_1_d_T = t36 * t90 + t58 * t91;
        at.write_dy(21, d_W_hat_1_d_T);
        let t92 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t90 + t81 * t92 - v_r * t91;
        at.write_dy(22, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = u14 * t7 * t88 - t11 * t92 + omega * t91;
        at.write_dy(23, d_W_hat_1_d_x);
        let t93 = r * cos_t30;
        let t94 = t83 * t93;
        let d_A_x_hat_1_d_theta = t81 * t94;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t93 * t84 - A_hat_1 * cos_t30 - t11 * t94;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t95 = r * sin_t30;
        let t96 = t83 * t95;
        let d_A_y_hat_1_d_theta = t81 * t96;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t95 * t84 - A_hat_1 * sin_t30 - t11 * t96;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t97 = V_T * stored;
        let t98 = t97 * t62;
        let d_E_hat_1_d_T = t97 * t57 + t58 * t98;
        at.write_dy(28, d_E_hat_1_d_T);
        let t99 = t34 * t16;
        let t100 = u47 * (t14 * (t33 * t33) * t99);
        let d_E_hat_1_d_theta = t97 * t64 - t81 * t100 - v_r * t98;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t101 = t33 * t99;
        let d_E_hat_1_d_theta1 = u62 * t101 - u64 * (t15 * stored);
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u65 * (t14 * stored));
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_E_hat_1_d_x = t11 * t100 - u46 * (x * t16) + t97 * t66 + omega * t98;
        at.write_dy(32, d_E_hat_1_d_x);
        let d_T_hat_1_d_Phi = t16 + u54 * (theta2 * t14) + u59 * (theta1 * t15);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t102 = omega_P * r;
        let d_T_hat_1_d_sigma = -(t102 * t62);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t103 = u28 * (u5 * t1 + u34 * t1);
        let t104 = sin_theta * t103;
        let t105 = t104 * t56;
        let t106 = cos_theta * t103;
        let d_T_hat_1_d_flow = t105 + t106 * t62;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_theta_hat_3_d_Phi = u40 * theta_3 - u61 * (theta1 * t74);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_sigma = -(t102 * t71);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_theta_hat_3_d_flow = t104 * t70 + t106 * t71;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t24;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t102 * t80);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t104 * t79 + t106 * t80;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u28 * ((u31 * t26 + u32) * (u43 * t85)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t102 * t91);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t104 * t90 + t106 * t91;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t107 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t93 - sin_t30 * t107;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t30 * t107 + d_A_hat_1_d_Phi * t95;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t97 * d_T_hat_1_d_Phi - u63 * (theta1 * t101);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = -(t102 * t98);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = u51 * t35 + t97 * t105 + t106 * t98;
        at.write_dc(20, d_E_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (199 add, 500 mul, 7 div, 2 sqrt, 3 fn a point; 135 once)
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
        let t15 = u18 * theta2 + R * tan_theta - x * tan_theta;
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
        let t21 = n + T * theta_1 - T;
        let t22 = tan_theta * tan_theta;
        let t23 = theta_1 * t22 + (theta_1 + t22);
        let t24 = r * t18;
        let theta_3 = t19 * t21 - t23 * t24;
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
        let t36 = cos_theta * reciprocal(r);
        let t37 = t36 * t14;
        let t38 = t37 * t37;
        let t39 = x * x;
        let stored = u32 * t38 - u30 * t39;
        let t40 = T_hat_1 * stored;
        let E_hat_1 = V_T * t40;
        at.write_f(11, E_hat_1);
        let t41 = mu * t5;
        let t42 = u65 * t9;
        let t43 = reciprocal(speed);
        let t44 = v_t * t43;
        let t45 = Real::splat(1.0) - saturation * saturation;
        let t46 = v_t * t5;
        let t47 = v_r * t5;
        let t48 = tan_theta * q;
        let t49 = x * (t7 * t7);
        let t50 = r * t13;
        let t51 = Phi * t48 - u86 * (t49 * t50);
        let t52 = t46 * t42 + t47 * t51;
        let t53 = t45 * t52;
        let t54 = speed * t5;
        let t55 = t5 * t5;
        let t56 = t10 * t55;
        let t57 = t6 * t55;
        let t58 = t56 * t42 + t57 * t51;
        let t59 = u89 * t53 - t54 * t58;
        let t60 = t41 * t42 + t44 * t59;
        let t61 = u49 * t47;
        let t62 = v_r * t43;
        let t63 = t41 * t51 - t61 * t58 + t62 * t59;
        let t64 = cos_theta * t60 + sin_theta * t63;
        let d_T_hat_1_d_T = V_T * t64;
        at.write_dy(0, d_T_hat_1_d_T);
        let t65 = Real::splat(1.0) + t22;
        let t66 = q * t12;
        let d_T_hat_1_d_theta = t4 * t63 - v_r * t60
            + t65 * (Phi * t66 - u53 * (r * t14));
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_theta1 = -(u99 * t15);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let d_T_hat_1_d_theta2 = -(u93 * t14);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t67 = omega * t60;
        let t68 = u83 * (t8 * t13);
        let d_T_hat_1_d_x = u53 * (tan_theta * t14) + u84 * (t7 * t50) + t67 - t68;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let t69 = u71 * t18;
        let t70 = t48 * t69;
        let t71 = t9 * t18;
        let t72 = u30 * t49;
        let t73 = Real::splat(2.0) * r;
        let t74 = t20 * t69;
        let t75 = t73 * t74;
        let t76 = u82 * t71 + t72 * t75;
        let t77 = t57 * t76 - t56 * t70;
        let t78 = t46 * t70 - t47 * t76;
        let t79 = t45 * t78;
        let t80 = t54 * t77 + u89 * t79;
        let t81 = t41 * t70 + t44 * t80;
        let t82 = t61 * t77 - t41 * t76 + t62 * t80;
        let t83 = cos_theta * t81 + sin_theta * t82;
        let d_theta_hat_3_d_T = u26 * (t14 * t19) + V_T * t83;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t84 = f_t * q;
        let t85 = t65
            * (t84 * t69
                - u26
                    * (t24
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t4 * t82 - v_r * t81 + t85;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t86 = u26 * (T * t19) - u26 * (t24 * t65);
        let d_theta_hat_3_d_theta1 = u2 * t86;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let t87 = t18 * t23;
        let t88 = t18 * t18;
        let t89 = t88 * (r * t23);
        let t90 = t21 * (u52 * t88);
        let t91 = u17 * t7;
        let t92 = omega * t81;
        let t93 = u50 * t8;
        let t94 = t93 * t74;
        let d_theta_hat_3_d_x = u26 * (t87 + Real::splat(2.0) * t89) - u72 * t90
            + t91 * t75 + t92 - t94;
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_x_hat_1_d_theta = -(t65 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let t95 = Phi * (arc * q);
        let t96 = r * t26;
        let t97 = u86 * (t49 * t96);
        let t98 = t57 * t97 - t56 * t95;
        let t99 = t46 * t95 - t47 * t97;
        let t100 = t45 * t99;
        let t101 = t54 * t98 + u89 * t100;
        let t102 = t41 * t95 + t44 * t101;
        let t103 = t61 * t98 - t41 * t97 + t62 * t101;
        let t104 = cos_theta * t102 + sin_theta * t103;
        let d_M_hat_1_d_T = V_T * t104;
        at.write_dy(13, d_M_hat_1_d_T);
        let t105 = t11 * t11 * (r * sin_theta);
        let t106 = Phi * t84;
        let d_M_hat_1_d_theta = t4 * t103 - v_r * t102 + t105 * t106;
        at.write_dy(14, d_M_hat_1_d_theta);
        let t107 = omega * t102;
        let t108 = t11 * t106;
        let t109 = u83 * (t8 * t26);
        let d_M_hat_1_d_x = u84 * (t7 * t96) + t107 - t108 - t109;
        at.write_dy(15, d_M_hat_1_d_x);
        let t110 = u56 * x;
        let d_A_hat_1_d_theta = t105 * t110;
        at.write_dy(16, d_A_hat_1_d_theta);
        let d_A_hat_1_d_R = t11 * t110;
        let d_A_hat_1_d_x = u56 * arc - d_A_hat_1_d_R;
        at.write_dy(17, d_A_hat_1_d_x);
        let t111 = arc * (u41 * (t29 * t29));
        let d_L_o_hat_1_d_T = -(u90 * t111);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t112 = u57 * t29;
        let d_L_o_hat_1_d_theta = t105 * t112;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t11 * t112;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(20, d_L_o_hat_1_d_x);
        let t113 = u65 * (arc * (v_t * p));
        let t114 = u65 * (arc * t32) + u67 * (arc * t30);
        let t115 = u67 * (arc * (v_r * p)) - t72 * t114;
        let t116 = t46 * t113 + t47 * t115;
        let t117 = t45 * t116;
        let t118 = t56 * t113 + t57 * t115;
        let t119 = u89 * t117 - t54 * t118;
        let t120 = u65 * (arc * (f_t * p)) + t41 * t113 + t44 * t119;
        let t121 = u67 * (arc * (f_r * p)) + t41 * t115 - t61 * t118 + t62 * t119;
        let t122 = cos_theta * t120 + sin_theta * t121;
        let d_W_hat_1_d_T = V_T * t122;
        at.write_dy(21, d_W_hat_1_d_T);
        let t123 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t121 - v_r * t120 + t105 * t123;
        at.write_dy(22, d_W_hat_1_d_theta);
        let t124 = omega * t120;
        let t125 = t11 * t123;
        let d_W_hat_1_d_x = t91 * t114 + t124 - t125;
        at.write_dy(23, d_W_hat_1_d_x);
        let t126 = r * cos_t33;
        let t127 = t110 * t126;
        let d_A_x_hat_1_d_theta = t105 * t127;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let t128 = Phi * arc;
        let t129 = t128 * t126;
        let t130 = t11 * t127;
        let t131 = A_hat_1 * cos_t33;
        let d_A_x_hat_1_d_x = u17 * t129 - t130 - t131;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let t132 = r * sin_t33;
        let t133 = t110 * t132;
        let d_A_y_hat_1_d_theta = t105 * t133;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let t134 = t128 * t132;
        let t135 = t11 * t133;
        let t136 = A_hat_1 * sin_t33;
        let d_A_y_hat_1_d_x = u17 * t134 - t135 - t136;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let t137 = u80 * (t9 * stored);
        let t138 = u60 * stored;
        let t139 = t13 * t138;
        let t140 = t73 * t139;
        let t141 = t48 * t138 - t72 * t140;
        let t142 = t46 * t137 + t47 * t141;
        let t143 = t45 * t142;
        let t144 = t56 * t137 + t57 * t141;
        let t145 = u89 * t143 - t54 * t144;
        let t146 = t41 * t137 + t44 * t145;
        let t147 = t41 * t141 - t61 * t144 + t62 * t145;
        let t148 = cos_theta * t146 + sin_theta * t147;
        let d_E_hat_1_d_T = V_T * t148;
        at.write_dy(28, d_E_hat_1_d_T);
        let t149 = t14 * stored;
        let t150 = t4 * t147 - v_r * t146 + t65 * (t66 * t138 - u75 * (r * t149));
        let t151 = t37 * t16;
        let t152 = u77 * (t14 * (t36 * t36) * t151);
        let d_E_hat_1_d_theta = t150 - t105 * t152;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t153 = u77 * (t36 * t151) - u70 * (t15 * stored);
        let d_E_hat_1_d_theta1 = u2 * t153;
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta2 = -(u97 * t149);
        at.write_dy(31, d_E_hat_1_d_theta2);
        let t154 = omega * t146;
        let t155 = t11 * t152;
        let t156 = u75 * (tan_theta * t149) - u61 * (x * t16) + t91 * t140 + t154 + t155;
        let t157 = t93 * t139;
        let d_E_hat_1_d_x = t156 - t157;
        at.write_dy(32, d_E_hat_1_d_x);
        let d_T_hat_1_d_Phi = t16 + u95 * (theta2 * t14) + u100 * (theta1 * t15);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t158 = r * t60;
        let d_T_hat_1_d_sigma = -(omega_P * t158);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t159 = u8 * t1 + u44 * t1;
        let t160 = t159 * t64;
        let d_T_hat_1_d_flow = u34 * t160;
        at.write_dc(2, d_T_hat_1_d_flow);
        let t161 = u3 * theta1;
        let d_theta_hat_3_d_Phi = u54 * theta_3 - t161 * t86;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let t162 = r * t81;
        let d_theta_hat_3_d_sigma = -(omega_P * t162);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let t163 = t159 * t83;
        let d_theta_hat_3_d_flow = u34 * t163;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_x_hat_1_d_Phi = -t25;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let t164 = r * t102;
        let d_M_hat_1_d_sigma = -(omega_P * t164);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t165 = t159 * t104;
        let d_M_hat_1_d_flow = u34 * t165;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t166 = u69 * t111;
        let t167 = (u39 * t27 + u40) * t166;
        let d_L_o_hat_1_d_flow = -(u34 * t167);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let t168 = r * t120;
        let d_W_hat_1_d_sigma = -(omega_P * t168);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let t169 = t159 * t122;
        let d_W_hat_1_d_flow = u34 * t169;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t170 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t126 - sin_t33 * t170;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t33 * t170 + d_A_hat_1_d_Phi * t132;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t16 * (V_T * stored) + u98 * (theta2 * t149) - t161 * t153;
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t171 = r * t146;
        let d_E_hat_1_d_sigma = -(omega_P * t171);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t172 = u58 * t40 + t159 * t148;
        let d_E_hat_1_d_flow = u34 * t172;
        at.write_dc(20, d_E_hat_1_d_flow);
        let t173 = V_T - u43 * t1;
        let d_T_hat_1_d_EA = t173 * t64;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_EI = -(u74 * (t14 * t15));
        at.write_dc(22, d_T_hat_1_d_EI);
        let d_T_hat_1_d_k = u85 * (t8 * t50);
        at.write_dc(23, d_T_hat_1_d_k);
        let t174 = u45 * t1;
        let d_T_hat_1_d_m_o = u35 * t160 - t174 * t64;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let theta_2 = u3 * theta2;
        let t175 = u51 * t15 - u22 * (theta_2 + tan_theta);
        let d_T_hat_1_d_R = t68 + (t175 * (Phi * t14) - t67);
        at.write_dc(25, d_T_hat_1_d_R);
        let d_T_hat_1_d_R_P = u33 * t160;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t176 = (t12 + u13 * f_r) * t49;
        let t177 = Real::splat(0.5) * t5 * (u46 * t3 + u48 * t3);
        let d_T_hat_1_d_beta = -(u78 * t48 + u84 * (t176 * t50) + t177 * t58);
        at.write_dc(27, d_T_hat_1_d_beta);
        let d_T_hat_1_d_mu_k = saturation * t52;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(u88 * (speed * t53));
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let d_T_hat_1_d_omega_P = u5 * t160 - sigma * t158;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_theta_hat_3_d_EA = t173 * t83;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let d_theta_hat_3_d_EI = -(u73 * (t17 * t90));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let t178 = Real::splat(0.5) * t8;
        let d_theta_hat_3_d_k = t178 * t75;
        at.write_dc(33, d_theta_hat_3_d_k);
        let d_theta_hat_3_d_m_o = u35 * t163 - t174 * t83;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R = t94
            + ((u51 * t17 - u22) * (u26 * t90) + u26 * (t89 - t87) - t92);
        at.write_dc(35, d_theta_hat_3_d_R);
        let d_theta_hat_3_d_R_P = u33 * t163;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let t179 = u17 * t176;
        let d_theta_hat_3_d_beta = u81 * t71 - t179 * t75 + t177 * t77;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let d_theta_hat_3_d_mu_k = saturation * t78;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let d_theta_hat_3_d_v_thr = -(u88 * (speed * t79));
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let d_theta_hat_3_d_omega_P = u5 * t163 - sigma * t162;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t173 * t104;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = u85 * (t8 * t96);
        at.write_dc(43, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = u35 * t165 - t174 * t104;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = t109 + (t108 - t107);
        at.write_dc(45, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = u33 * t165;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t177 * t98 - u84 * (t176 * t96);
        at.write_dc(47, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = saturation * t99;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = -(u88 * (speed * t100));
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = u5 * t165 - sigma * t164;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = u68 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        at.write_dc(52, d_A_hat_1_d_R);
        let t180 = (u27 - u55 * t28) * (Phi * t111) + (u8 * t27 - u37 * t27) * t166;
        let d_L_o_hat_1_d_EA = -t180;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u9 * T - u42 * t27) * t166 + u35 * t167);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u33 * t167);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t167);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t173 * t122;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = t178 * t114;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = u35 * t169 - t174 * t122;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t125 - t124;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = u33 * t169;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = u66 * (arc * t31) - t179 * t114 - t177 * t118;
        at.write_dc(63, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = saturation * t116;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(u88 * (speed * t117));
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = u5 * t169 - sigma * t168;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let t181 = Real::splat(0.5) * x;
        let d_A_x_hat_1_d_k = t181 * t129;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t131 + t130;
        at.write_dc(68, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t181 * t134;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t136 + t135;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_E_hat_1_d_EA = t173 * t148 - u43 * t40;
        at.write_dc(71, d_E_hat_1_d_EA);
        let d_E_hat_1_d_EI = t37 * (u64 * t151)
            - (u62 * (t16 * t38) + u76 * (t15 * t149));
        at.write_dc(72, d_E_hat_1_d_EI);
        let d_E_hat_1_d_k = t178 * t140 - u63 * (t16 * t39);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_E_hat_1_d_m_o = u35 * t172 - (u45 * t40 + t174 * t148);
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R = t157 + (t175 * (u60 * t149) - t154 - t155);
        at.write_dc(75, d_E_hat_1_d_R);
        let d_E_hat_1_d_R_P = u33 * t172;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t182 = (u17 * t39 + u59 * t39) * (u60 * t16) + u79 * (stored * t48)
            + t179 * t140;
        let d_E_hat_1_d_beta = -(t182 + t177 * t144);
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_mu_k = saturation * t142;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let d_E_hat_1_d_v_thr = -(u88 * (speed * t143));
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_omega_P = u5 * t172 - sigma * t171;
        at.write_dc(80, d_E_hat_1_d_omega_P);
    }
}
///Derived fields. (15 add, 38 mul, 4 div, 2 sqrt, 4 fn a point; 27 once)
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
        let theta1 = at.state::<Real>(2);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (cos_theta * reciprocal(r) * (theta_1 - Real::splat(1.0))));
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
        let arc = r * t4;
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
