// contact_linearised_viscous_coulomb: The belt in a groove: linearised shear, viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 27 add, 74 mul, 6 div, 2 sqrt, 2 fn a point; 38 once
//   jacobian: 116 add, 312 mul, 7 div, 2 sqrt, 2 fn a point; 90 once
//   full: 200 add, 500 mul, 7 div, 2 sqrt, 2 fn a point; 131 once
//   fields: 16 add, 38 mul, 4 div, 2 sqrt, 3 fn a point; 26 once
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

///The belt in a groove: linearised shear, viscous-coulomb friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_linearised_viscous_coulomb",
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
/// 27 add, 74 mul, 6 div, 2 sqrt, 2 fn a point; 38 once.
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
        let u9 = reciprocal(v_thr);
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
        let slip = u9 * speed;
        let saturation = saturate(slip);
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
/// 116 add, 312 mul, 7 div, 2 sqrt, 2 fn a point; 90 once.
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
        let u12 = sin_beta * u8;
        let k = constants[5];
        let u13 = k * 0.5;
        let u14 = u2 * u2;
        let u15 = R * u14;
        let EI = constants[4];
        let u16 = reciprocal(R);
        let u17 = u16 * u16;
        let u18 = EI * (u16 * u17);
        let u19 = reciprocal(EI);
        let u20 = u19 * (R * (R * R));
        let u21 = Phi * Phi;
        let u22 = Phi * u21;
        let u23 = 2.0 * u9;
        let u24 = u8 * (k * sin_beta);
        let u25 = 0.5 * u24;
        let u26 = EI * EI * (0.5 * u19);
        let u27 = omega_P * (m_o * R_P);
        let u28 = u5 * u5;
        let u29 = G * (EA * 2.0);
        let u30 = u28 * u29;
        let u31 = u5 * u29;
        let u32 = EA * EA;
        let u33 = u28 * (2.0 * u3);
        let u34 = 0.5 * (u9 * (2.0 * u7));
        let u35 = 2.0 * u13;
        let u36 = 2.0 * u18;
        let u37 = u20 * u20;
        let u38 = Phi * u18;
        let u39 = u21 * 3.0;
        let u40 = Phi * u13;
        let u41 = Phi * EA;
        let u42 = Phi * reciprocal(EA);
        let u43 = mu_k * u11;
        let u44 = Phi * V_T;
        let u45 = u24 * u44;
        let u46 = EI * (EI * u19 * u44);
        let u47 = u4 * u5 * u42;
        let u48 = Phi * 2.0;
        let u49 = Phi * u23;
        let u50 = u27 * (u5 + u33);
        let u51 = EI * u17;
        let u52 = Phi * (u14 * u51);
        let u53 = Phi * (2.0 * (u2 * u14) * u51);
        let u54 = 2.0 * u20;
        let u55 = 2.0 * u25;
        let u56 = Phi * u55;
        let u57 = u2 * u38;
        let u58 = u14 * u38;
        let u59 = u2 * u22;
        let u60 = u14 * u22;
        let u61 = u2 * u46;
        let u62 = u14 * u46;
        let u63 = V_T * u57;
        let u64 = V_T * u52;
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
            u11,
            u12,
            u13,
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
            u45,
            u46,
            u47,
            u48,
            u49,
            u50,
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
        let u11 = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let u13 = Real::splat(uniforms[17]);
        let u15 = Real::splat(uniforms[18]);
        let u18 = Real::splat(uniforms[19]);
        let u20 = Real::splat(uniforms[20]);
        let u22 = Real::splat(uniforms[21]);
        let u23 = Real::splat(uniforms[22]);
        let u25 = Real::splat(uniforms[23]);
        let u26 = Real::splat(uniforms[24]);
        let u27 = Real::splat(uniforms[25]);
        let u30 = Real::splat(uniforms[26]);
        let u31 = Real::splat(uniforms[27]);
        let u32 = Real::splat(uniforms[28]);
        let u33 = Real::splat(uniforms[29]);
        let u34 = Real::splat(uniforms[30]);
        let u35 = Real::splat(uniforms[31]);
        let u36 = Real::splat(uniforms[32]);
        let u37 = Real::splat(uniforms[33]);
        let u38 = Real::splat(uniforms[34]);
        let u39 = Real::splat(uniforms[35]);
        let u40 = Real::splat(uniforms[36]);
        let u41 = Real::splat(uniforms[37]);
        let u42 = Real::splat(uniforms[38]);
        let u43 = Real::splat(uniforms[39]);
        let u45 = Real::splat(uniforms[40]);
        let u46 = Real::splat(uniforms[41]);
        let u47 = Real::splat(uniforms[42]);
        let u48 = Real::splat(uniforms[43]);
        let u49 = Real::splat(uniforms[44]);
        let u50 = Real::splat(uniforms[45]);
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
        let u63 = Real::splat(uniforms[57]);
        let u64 = Real::splat(uniforms[58]);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = omega_P * r;
        let t2 = reciprocal(R + Real::splat(2.0) * x);
        let t3 = u20 * t2;
        let t4 = r * t2;
        let t5 = t2 * t2;
        let axial = u13 * x;
        let t6 = u40 * x;
        let T = at.state::<Real>(0);
        let t7 = T + EA;
        let V = V_T * t7;
        let t8 = u27 * (u5 * t7 + u33 * t7);
        let t9 = u3 + m_o * T;
        let F = u6 * t9;
        let t10 = reciprocal(EA + F);
        let t11 = u41 * t10;
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
        let t19 = u34 * t18;
        let slip = u11 * speed;
        let t20 = reciprocal(speed);
        let t21 = v_r * t20;
        let t22 = v_t * t20;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t23 = u43 * below_one(slip);
        let t24 = v_r * mu;
        let f_r = t15 * t24;
        let t25 = t24 * t17;
        let t26 = t18 * t23 - t16 * t25;
        let t27 = t22 * t26;
        let t28 = reciprocal(cos_beta + u12 * f_r);
        let t29 = x * t28;
        let p = u13 * t29;
        let t30 = u35 * (r * t28) - u35 * t29;
        let t31 = r * p;
        let q = Real::splat(2.0) * t31;
        let t32 = u48 * t31;
        let t33 = x * (t28 * t28);
        let t34 = r * t33;
        let t35 = f_r - sin_beta;
        let t36 = v_r * f_r;
        let loss_radial = u23 * (p * t36);
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
        let t52 = u22 * (u54 * (t31 * t2) + t51 * (u55 * t34));
        let t53 = tan_theta * tan_theta;
        let t54 = Real::splat(1.0) + t53;
        let t55 = T * t3 - t4 * t54;
        let d_theta_hat_3_d_theta1 = u59 * t55;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let d_x_hat_1_d_theta = -(t54 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let t56 = r * tan_theta;
        let x_hat_1 = -(Phi * t56);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t56;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t57 = tan_theta * q;
        let t58 = Phi * t57 - u56 * (t49 * t34);
        let t59 = u22 * (t3 * t57);
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
        let t64 = u48 * (arc * t44) + u49 * (arc * t36);
        let t65 = u49 * (arc * (v_r * p)) - u25 * t33 * t64;
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t66 = u48 * (arc * (v_t * p));
        let t67 = u49 * (arc * (f_r * p)) + t66 * t40 + t65 * t42;
        let t68 = u48 * (arc * (f_t * p)) + t66 * t43 + t65 * t27;
        let d_W_hat_1_d_x = u13 * t28 * t64 - t48 * t45 + omega * t68;
        at.write_dy(23, d_W_hat_1_d_x);
        let t69 = arc * f_t;
        let t70 = u56 * (t69 * t34);
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
        let t72 = arc * (u32 * (t10 * t10));
        let d_L_o_hat_1_d_flow = -(u27 * ((u30 * t9 + u31) * (u42 * t72)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_T = -(u47 * t72);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t73 = Phi * (arc * q);
        let t74 = t73 * t40 - t42 * t70;
        let t75 = t73 * t43 - t27 * t70;
        let d_M_hat_1_d_x = Phi * t69 * t30 - t48 * t47 + omega * t75;
        at.write_dy(15, d_M_hat_1_d_x);
        let t76 = u40 * arc;
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
            - u36 * (t85 * (u37 * t5));
        let d_theta_hat_3_d_x = u22 * (t87 + t51 * t30) + omega * t61;
        at.write_dy(10, d_theta_hat_3_d_x);
        let theta_3 = t3 * t85 - t86 * t4;
        let t88 = u22
            * (t54
                * (t3 * t46
                    - t4
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t88 + t13 * t60 - v_r * t61;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let d_theta_hat_3_d_Phi = u39 * theta_3 - u60 * (theta1 * t55);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let theta_hat_3 = u22 * theta_3;
        at.write_f(3, theta_hat_3);
        let t89 = theta_1 - Real::splat(1.0);
        let t90 = t54 * (Phi * (q * t35) - u38 * (r * t89)) + t13 * t62;
        let d_theta_hat_3_d_T = u22 * (t89 * t3) + t79 * t60 + t82 * t61;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t91 = u38 * (tan_theta * t89) + Phi * t49 * t30;
        let d_T_hat_1_d_x = t91 + omega * t63;
        at.write_dy(4, d_T_hat_1_d_x);
        let d_T_hat_1_d_theta = t90 - v_r * t63;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t92 = t78 * t89;
        let stored = u26 * (t92 * t92) - u25 * (x * x);
        let t93 = V_T * stored;
        let t94 = t93 * t63;
        let d_E_hat_1_d_T = t93 * t84 + t82 * t94;
        at.write_dy(28, d_E_hat_1_d_T);
        let d_E_hat_1_d_sigma = -(t1 * t94);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_theta2 = -(u64 * (t89 * stored));
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_T_hat_1_d_theta2 = -(u52 * t89);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let theta2 = at.state::<Real>(3);
        let t95 = u15 * theta2 + R * tan_theta - x * tan_theta;
        let t96 = t - t89 * (u18 * t95);
        let t97 = t92 * t96;
        at.write_f(2, theta2);
        let d_T_hat_1_d_Phi = t96 + u53 * (theta2 * t89) + u58 * (theta1 * t95);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let t98 = u46 * (t89 * (t78 * t78) * t97);
        let d_E_hat_1_d_theta = t93 * t90 - t77 * t98 - v_r * t94;
        let d_E_hat_1_d_x = t48 * t98 - u45 * (x * t96) + t93 * t91 + omega * t94;
        at.write_dy(32, d_E_hat_1_d_x);
        at.write_dy(29, d_E_hat_1_d_theta);
        let t99 = t78 * t97;
        let d_E_hat_1_d_Phi = t93 * d_T_hat_1_d_Phi - u62 * (theta1 * t99);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_theta1 = u61 * t99 - u63 * (t95 * stored);
        at.write_dy(30, d_E_hat_1_d_theta1);
        let T_hat_1 = Phi * t96;
        at.write_f(0, T_hat_1);
        let t100 = T_hat_1 * stored;
        let d_E_hat_1_d_flow = u50 * t100 + t93 * t83 + t81 * t94;
        at.write_dc(20, d_E_hat_1_d_flow);
        let E_hat_1 = V_T * t100;
        at.write_f(11, E_hat_1);
        let d_T_hat_1_d_theta1 = -(u57 * t95);
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
/// 200 add, 500 mul, 7 div, 2 sqrt, 2 fn a point; 131 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 5;
    const CONSTANTS: usize = 13;
    const F: usize = 12;
    const DY: usize = 33;
    const DC: usize = 81;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 88];
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
        let u15 = sin_beta * u11;
        let k = constants[5];
        let u16 = k * 0.5;
        let u17 = R * u3;
        let EI = constants[4];
        let u18 = reciprocal(R);
        let u19 = u18 * u18;
        let u20 = u18 * u19;
        let u21 = EI * u20;
        let u22 = reciprocal(EI);
        let u23 = u22 * (R * (R * R));
        let u24 = Phi * Phi;
        let u25 = Phi * u24;
        let u26 = reciprocal(EA);
        let u27 = 2.0 * u12;
        let u28 = u11 * (k * sin_beta);
        let u29 = 0.5 * u28;
        let u30 = EI * EI;
        let u31 = u30 * (0.5 * u22);
        let u32 = omega_P * u4;
        let u33 = omega_P * (m_o * R_P);
        let u34 = omega_P * (flow * R_P);
        let u35 = u8 * u8;
        let u36 = u7 * u35;
        let u37 = G * (EA * 2.0);
        let u38 = u35 * u37;
        let u39 = u8 * u37;
        let u40 = EA * EA;
        let u41 = u35 * u40;
        let u42 = u35 * (m_o * G);
        let u43 = u35 * (2.0 * u6);
        let u44 = u35 * (EA * G);
        let u45 = u14 * u14;
        let u46 = u11 * (2.0 * sin_beta);
        let u47 = u11 * u12;
        let u48 = u47 * (2.0 * (sin_beta * u10));
        let u49 = 0.5 * (u12 * (2.0 * u10));
        let u50 = 2.0 * u16;
        let u51 = u18 * u20 * (EI * 3.0);
        let u52 = u23 * u23;
        let u53 = Phi * u21;
        let u54 = u24 * 3.0;
        let u55 = u26 * u26;
        let u56 = Phi * u16;
        let u57 = Phi * EA;
        let u58 = u8 + u43;
        let u59 = 0.5 * (u12 * (k * u10));
        let u60 = Phi * V_T;
        let u61 = u28 * u60;
        let u62 = u30 * (0.5 * (u22 * u22)) * u60;
        let u63 = u15 * 0.5 * u60;
        let u64 = EI * u22 * u60;
        let u65 = Phi * 2.0;
        let u66 = Phi * (4.0 * (sin_beta * u47));
        let u67 = Phi * u27;
        let u68 = Phi * 0.5;
        let u69 = Phi * u26;
        let u70 = V_T * u53;
        let u71 = u23 * u25;
        let u72 = u25 * (2.0 * u21);
        let u73 = u20 * u25;
        let u74 = Phi * u20;
        let u75 = u21 * u60;
        let u76 = u20 * u60;
        let u77 = EI * u64;
        let u78 = Phi * cos_beta;
        let u79 = cos_beta * u60;
        let u80 = 2.0 * u60;
        let u81 = cos_beta * 2.0 * u71;
        let u82 = 2.0 * u71;
        let u83 = Phi * u50;
        let u84 = u16 * u65;
        let u85 = 0.5 * u65;
        let u86 = u29 * u65;
        let u87 = u7 * u8 * u69;
        let u88 = EI * u19;
        let u89 = Phi * u88;
        let u90 = u3 * u89;
        let u91 = 2.0 * (u2 * u3);
        let u92 = u91 * u89;
        let u93 = u88 * u60;
        let u94 = u3 * u93;
        let u95 = u91 * u93;
        let u96 = u2 * u53;
        let u97 = u3 * u53;
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
            u14,
            u15,
            u16,
            u17,
            u21,
            u23,
            u25,
            u26,
            u27,
            u29,
            u31,
            u32,
            u33,
            u34,
            u36,
            u38,
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
            u87,
            u90,
            u92,
            u94,
            u95,
            u96,
            u97,
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
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let u16 = Real::splat(uniforms[20]);
        let u17 = Real::splat(uniforms[21]);
        let u21 = Real::splat(uniforms[22]);
        let u23 = Real::splat(uniforms[23]);
        let u25 = Real::splat(uniforms[24]);
        let u26 = Real::splat(uniforms[25]);
        let u27 = Real::splat(uniforms[26]);
        let u29 = Real::splat(uniforms[27]);
        let u31 = Real::splat(uniforms[28]);
        let u32 = Real::splat(uniforms[29]);
        let u33 = Real::splat(uniforms[30]);
        let u34 = Real::splat(uniforms[31]);
        let u36 = Real::splat(uniforms[32]);
        let u38 = Real::splat(uniforms[33]);
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
        let u63 = Real::splat(uniforms[57]);
        let u64 = Real::splat(uniforms[58]);
        let u65 = Real::splat(uniforms[59]);
        let u66 = Real::splat(uniforms[60]);
        let u67 = Real::splat(uniforms[61]);
        let u68 = Real::splat(uniforms[62]);
        let u69 = Real::splat(uniforms[63]);
        let u70 = Real::splat(uniforms[64]);
        let u71 = Real::splat(uniforms[65]);
        let u72 = Real::splat(uniforms[66]);
        let u73 = Real::splat(uniforms[67]);
        let u74 = Real::splat(uniforms[68]);
        let u75 = Real::splat(uniforms[69]);
        let u76 = Real::splat(uniforms[70]);
        let u77 = Real::splat(uniforms[71]);
        let u78 = Real::splat(uniforms[72]);
        let u79 = Real::splat(uniforms[73]);
        let u80 = Real::splat(uniforms[74]);
        let u81 = Real::splat(uniforms[75]);
        let u82 = Real::splat(uniforms[76]);
        let u83 = Real::splat(uniforms[77]);
        let u84 = Real::splat(uniforms[78]);
        let u85 = Real::splat(uniforms[79]);
        let u86 = Real::splat(uniforms[80]);
        let u87 = Real::splat(uniforms[81]);
        let u90 = Real::splat(uniforms[82]);
        let u92 = Real::splat(uniforms[83]);
        let u94 = Real::splat(uniforms[84]);
        let u95 = Real::splat(uniforms[85]);
        let u96 = Real::splat(uniforms[86]);
        let u97 = Real::splat(uniforms[87]);
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = Real::splat(2.0) * r;
        let t2 = R + Real::splat(2.0) * x;
        let t3 = reciprocal(t2);
        let t4 = u23 * t3;
        let t5 = r * t3;
        let t6 = u71 * t3;
        let t7 = t3 * t3;
        let axial = u16 * x;
        let t8 = x * x;
        let t9 = u56 * x;
        let t10 = Real::splat(0.5) * x;
        let T = at.state::<Real>(0);
        let t11 = T + EA;
        let V = V_T * t11;
        let t12 = u8 * t11 + u43 * t11;
        let t13 = V_T - u42 * t11;
        let t14 = u44 * t11;
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
        let slip = u14 * speed;
        let saturation = saturate(slip);
        let t29 = below_one(slip);
        let mu = mu_k * saturation;
        let t30 = v_r * mu;
        let f_r = t22 * t30;
        let t31 = t30 * t28;
        let t32 = reciprocal(cos_beta + u15 * f_r);
        let t33 = x * t32;
        let p = u16 * t33;
        let t34 = r * p;
        let q = Real::splat(2.0) * t34;
        let t35 = u65 * t34;
        let t36 = t34 * t3;
        let t37 = u50 * t33;
        let t38 = Real::splat(0.5) * t33;
        let t39 = x * (t32 * t32);
        let t40 = u29 * t39;
        let t41 = u16 * t32;
        let t42 = f_r - sin_beta;
        let t43 = q * t42;
        let t44 = (t42 + u13 * f_r) * t39;
        let t45 = u16 * t44;
        let t46 = v_r * f_r;
        let t47 = p * t46;
        let loss_radial = u27 * t47;
        let t48 = v_t * mu;
        let t49 = t48 * t28;
        let f_t = t22 * t48;
        let t50 = mu * t22;
        let t51 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t51);
        let loss = loss_radial + loss_tangential;
        let t52 = Phi * loss;
        let t53 = f_t * q;
        let t54 = Phi * t53;
        let t55 = reciprocal(speed);
        let t56 = u45 * speed;
        let t57 = v_t * t55;
        let t58 = v_r * t55;
        let t59 = reciprocal(cos_theta);
        let tan_theta = t59 * sin_theta;
        let t60 = f_t + tan_theta * t42;
        let t = q * t60;
        let t61 = r * t60;
        let d_T_hat_1_d_k = u85 * (t33 * t61);
        at.write_dc(23, d_T_hat_1_d_k);
        let t62 = u83 * (t33 * t60);
        let t63 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t63;
        let t64 = t63 * t6;
        let t65 = t1 * t64;
        let t66 = t37 * t64;
        let t67 = u82 * t36 + t40 * t65;
        let d_theta_hat_3_d_k = t38 * t65;
        at.write_dc(33, d_theta_hat_3_d_k);
        let t68 = tan_theta * tan_theta;
        let t69 = Real::splat(1.0) + t68;
        let t70 = u25 * (T * t4) - u25 * (t5 * t69);
        let d_theta_hat_3_d_theta1 = u2 * t70;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let d_x_hat_1_d_theta = -(t69 * (Phi * r));
        at.write_dy(11, d_x_hat_1_d_theta);
        let t71 = r * tan_theta;
        let x_hat_1 = -(Phi * t71);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t71;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t72 = tan_theta * q;
        let t73 = Phi * t72 - u86 * (t39 * t61);
        let t74 = t24 * t35 + t25 * t73;
        let t75 = t29 * (mu_k * t74);
        let d_T_hat_1_d_mu_k = saturation * t74;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(t56 * t75);
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let t76 = t49 * t35 + t31 * t73;
        let t77 = u14 * t75 - t27 * t76;
        let t78 = t50 * t35 + t57 * t77;
        let t79 = t50 * t73 - t26 * t76 + t58 * t77;
        let d_T_hat_1_d_beta = -(u78 * t72 + u84 * (t44 * t61) + t23 * t76);
        at.write_dc(27, d_T_hat_1_d_beta);
        let t80 = cos_theta * t78 + sin_theta * t79;
        let d_T_hat_1_d_T = V_T * t80;
        at.write_dy(0, d_T_hat_1_d_T);
        let t81 = t12 * t80;
        let d_T_hat_1_d_flow = u33 * t81;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_T_hat_1_d_m_o = u34 * t81 - t14 * t80;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_EA = t13 * t80;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_R_P = u32 * t81;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t82 = omega * t78;
        let t83 = r * t78;
        let d_T_hat_1_d_omega_P = u5 * t81 - sigma * t83;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_T_hat_1_d_sigma = -(omega_P * t83);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t84 = t72 * t6;
        let t85 = t31 * t67 - t49 * t84;
        let d_theta_hat_3_d_beta = u81 * t36 - t45 * t65 + t23 * t85;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let t86 = t24 * t84 - t25 * t67;
        let t87 = t29 * (mu_k * t86);
        let d_theta_hat_3_d_mu_k = saturation * t86;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let t88 = t27 * t85 + u14 * t87;
        let t89 = t26 * t85 - t50 * t67 + t58 * t88;
        let t90 = t50 * t84 + t57 * t88;
        let d_theta_hat_3_d_v_thr = -(t56 * t87);
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let t91 = cos_theta * t90 + sin_theta * t89;
        let t92 = t12 * t91;
        let d_theta_hat_3_d_flow = u33 * t92;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_theta_hat_3_d_m_o = u34 * t92 - t14 * t91;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R_P = u32 * t92;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_EA = t13 * t91;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let t93 = omega * t90;
        let t94 = r * t90;
        let d_theta_hat_3_d_omega_P = u5 * t92 - sigma * t94;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_theta_hat_3_d_sigma = -(omega_P * t94);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(12, d_x_hat_1_d_x);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let arc = r * t59;
        let t95 = u65 * (arc * t51) + u67 * (arc * t46);
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t96 = u65 * (arc * (v_t * p));
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t97 = r * A_hat_1;
        let t98 = u67 * (arc * (v_r * p)) - t40 * t95;
        let t99 = t24 * t96 + t25 * t98;
        let t100 = t29 * (mu_k * t99);
        let d_W_hat_1_d_mu_k = saturation * t99;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t56 * t100);
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let t101 = t49 * t96 + t31 * t98;
        let t102 = u14 * t100 - t27 * t101;
        let t103 = u67 * (arc * (f_r * p)) + t50 * t98 - t26 * t101 + t58 * t102;
        let t104 = u65 * (arc * (f_t * p)) + t50 * t96 + t57 * t102;
        let d_W_hat_1_d_beta = u66 * (arc * t47) - t45 * t95 - t23 * t101;
        at.write_dc(63, d_W_hat_1_d_beta);
        let t105 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t105;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let t106 = Phi * (arc * q);
        let t107 = r * t105;
        let t108 = u86 * (t39 * t107);
        let t109 = u83 * (t33 * t105);
        let d_M_hat_1_d_k = u85 * (t33 * t107);
        at.write_dc(43, d_M_hat_1_d_k);
        let t110 = t31 * t108 - t49 * t106;
        let d_M_hat_1_d_beta = t23 * t110 - u84 * (t44 * t107);
        at.write_dc(47, d_M_hat_1_d_beta);
        let t111 = t24 * t106 - t25 * t108;
        let t112 = t29 * (mu_k * t111);
        let d_M_hat_1_d_mu_k = saturation * t111;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let t113 = t27 * t110 + u14 * t112;
        let t114 = t26 * t110 - t50 * t108 + t58 * t113;
        let t115 = t50 * t106 + t57 * t113;
        let d_M_hat_1_d_v_thr = -(t56 * t112);
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let t116 = cos_theta * t115 + sin_theta * t114;
        let d_M_hat_1_d_T = V_T * t116;
        at.write_dy(13, d_M_hat_1_d_T);
        let t117 = t12 * t116;
        let d_M_hat_1_d_flow = u33 * t117;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_M_hat_1_d_m_o = u34 * t117 - t14 * t116;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_EA = t13 * t116;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_R_P = u32 * t117;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let t118 = omega * t115;
        let t119 = r * t115;
        let d_M_hat_1_d_omega_P = u5 * t117 - sigma * t119;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_M_hat_1_d_sigma = -(omega_P * t119);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t120 = cos_theta * t104 + sin_theta * t103;
        let d_W_hat_1_d_T = V_T * t120;
        at.write_dy(21, d_W_hat_1_d_T);
        let t121 = t12 * t120;
        let d_W_hat_1_d_flow = u33 * t121;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_W_hat_1_d_m_o = u34 * t121 - t14 * t120;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_EA = t13 * t120;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_R_P = u32 * t121;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let t122 = omega * t104;
        let t123 = r * t104;
        let d_W_hat_1_d_omega_P = u5 * t121 - sigma * t123;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let d_W_hat_1_d_sigma = -(omega_P * t123);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_k = t38 * t95;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_L_o_hat_1_d_Phi = arc * (EA * t17);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t124 = arc * (u40 * (t17 * t17));
        let d_L_o_hat_1_d_T = -(u87 * t124);
        at.write_dy(18, d_L_o_hat_1_d_T);
        let t125 = u69 * t124;
        let t126 = (u26 - u55 * t16) * (Phi * t124) + (u8 * t15 - u36 * t15) * t125;
        let d_L_o_hat_1_d_EA = -t126;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let t127 = (u38 * t15 + u39) * t125;
        let d_L_o_hat_1_d_m_o = -((u9 * T - u41 * t15) * t125 + u34 * t127);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_flow = -(u33 * t127);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u32 * t127);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t127);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let t128 = Phi * arc;
        let d_A_hat_1_d_k = u68 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        let t129 = t59 * t59 * (r * sin_theta);
        let d_M_hat_1_d_theta = t20 * t114 - v_r * t115 + t129 * t54;
        at.write_dy(14, d_M_hat_1_d_theta);
        let d_W_hat_1_d_theta = t20 * t103 - v_r * t104 + t129 * t52;
        at.write_dy(22, d_W_hat_1_d_theta);
        let t130 = t59 * t54;
        let d_M_hat_1_d_x = u84 * (t32 * t107) + t118 - t130 - t109;
        let d_M_hat_1_d_R = t109 + (t130 - t118);
        at.write_dc(45, d_M_hat_1_d_R);
        at.write_dy(15, d_M_hat_1_d_x);
        let t131 = t59 * t52;
        let d_W_hat_1_d_x = t41 * t95 + t122 - t131;
        at.write_dy(23, d_W_hat_1_d_x);
        let d_W_hat_1_d_R = t131 - t122;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_A_hat_1_d_theta = t129 * t9;
        at.write_dy(16, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t129 * t18;
        at.write_dy(19, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t59 * t18;
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(20, d_L_o_hat_1_d_x);
        let d_A_hat_1_d_R = t59 * t9;
        let d_A_hat_1_d_x = u56 * arc - d_A_hat_1_d_R;
        at.write_dy(17, d_A_hat_1_d_x);
        at.write_dc(52, d_A_hat_1_d_R);
        let t132 = cos_theta * reciprocal(r);
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t133 = n + T * theta_1 - T;
        let t134 = t69
            * (t53 * t6
                - u25
                    * (t5
                        * (Real::splat(2.0) * (theta_1 * tan_theta)
                            + Real::splat(2.0) * tan_theta)));
        let d_theta_hat_3_d_theta = t20 * t89 - v_r * t90 + t134;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let t135 = theta_1 * t68 + (theta_1 + t68);
        let theta_3 = t4 * t133 - t135 * t5;
        let t136 = t3 * t135;
        let t137 = t7 * (r * t135);
        let t138 = t133 * (u52 * t7);
        let d_theta_hat_3_d_x = u25 * (t136 + Real::splat(2.0) * t137) - u72 * t138
            + t41 * t65 + t93 - t66;
        let d_theta_hat_3_d_R = t66
            + ((u51 * t2 - u21) * (u25 * t138) + u25 * (t137 - t136) - t93);
        at.write_dc(35, d_theta_hat_3_d_R);
        at.write_dy(10, d_theta_hat_3_d_x);
        let d_theta_hat_3_d_EI = -(u73 * (t2 * t138));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let t139 = theta_1 - Real::splat(1.0);
        let d_T_hat_1_d_theta = t20 * t79 - v_r * t78
            + t69 * (Phi * t43 - u53 * (r * t139));
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_T_hat_1_d_x = u53 * (tan_theta * t139) + u84 * (t32 * t61) + t82 - t62;
        at.write_dy(4, d_T_hat_1_d_x);
        let d_theta_hat_3_d_T = u25 * (t139 * t4) + V_T * t91;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t140 = t132 * t139;
        let t141 = t140 * t140;
        let stored = u31 * t141 - u29 * t8;
        let t142 = u80 * (t34 * stored);
        let t143 = u60 * stored;
        let t144 = t60 * t143;
        let t145 = t1 * t144;
        let t146 = t37 * t144;
        let t147 = t72 * t143 - t40 * t145;
        let t148 = t24 * t142 + t25 * t147;
        let t149 = t49 * t142 + t31 * t147;
        let t150 = t29 * (mu_k * t148);
        let d_E_hat_1_d_mu_k = saturation * t148;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let t151 = u14 * t150 - t27 * t149;
        let t152 = t50 * t147 - t26 * t149 + t58 * t151;
        let t153 = t50 * t142 + t57 * t151;
        let t154 = cos_theta * t153 + sin_theta * t152;
        let d_E_hat_1_d_v_thr = -(t56 * t150);
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_T = V_T * t154;
        at.write_dy(28, d_E_hat_1_d_T);
        let t155 = omega * t153;
        let t156 = r * t153;
        let d_E_hat_1_d_sigma = -(omega_P * t156);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t157 = t139 * stored;
        let t158 = t20 * t152 - v_r * t153 + t69 * (t43 * t143 - u75 * (r * t157));
        let d_E_hat_1_d_theta2 = -(u94 * t157);
        at.write_dy(31, d_E_hat_1_d_theta2);
        let d_T_hat_1_d_theta2 = -(u90 * t139);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let theta_hat_3 = u25 * theta_3;
        at.write_f(3, theta_hat_3);
        let t159 = u3 * theta1;
        let d_theta_hat_3_d_Phi = u54 * theta_3 - t159 * t70;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let theta2 = at.state::<Real>(3);
        at.write_f(2, theta2);
        let t160 = u17 * theta2 + R * tan_theta - x * tan_theta;
        let t161 = t - t139 * (u21 * t160);
        let t162 = (u16 * t8 + u59 * t8) * (u60 * t161) + u79 * (stored * t72)
            + t45 * t145;
        let d_E_hat_1_d_beta = -(t162 + t23 * t149);
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_k = t38 * t145 - u63 * (t161 * t8);
        at.write_dc(73, d_E_hat_1_d_k);
        let d_T_hat_1_d_Phi = t161 + u92 * (theta2 * t139) + u97 * (theta1 * t160);
        at.write_dc(0, d_T_hat_1_d_Phi);
        let T_hat_1 = Phi * t161;
        at.write_f(0, T_hat_1);
        let t163 = T_hat_1 * stored;
        let t164 = u58 * t163 + t12 * t154;
        let d_E_hat_1_d_m_o = u34 * t164 - (u44 * t163 + t14 * t154);
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_EA = t13 * t154 - u42 * t163;
        at.write_dc(71, d_E_hat_1_d_EA);
        let d_E_hat_1_d_omega_P = u5 * t164 - sigma * t156;
        at.write_dc(80, d_E_hat_1_d_omega_P);
        let E_hat_1 = V_T * t163;
        at.write_f(11, E_hat_1);
        let d_E_hat_1_d_flow = u33 * t164;
        at.write_dc(20, d_E_hat_1_d_flow);
        let d_E_hat_1_d_R_P = u32 * t164;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t165 = t140 * t161;
        let d_E_hat_1_d_EI = t140 * (u64 * t165)
            - (u62 * (t161 * t141) + u76 * (t160 * t157));
        at.write_dc(72, d_E_hat_1_d_EI);
        let t166 = u77 * (t139 * (t132 * t132) * t165);
        let t167 = u77 * (t132 * t165) - u70 * (t160 * stored);
        let d_E_hat_1_d_Phi = t161 * (V_T * stored) + u95 * (theta2 * t157)
            - t159 * t167;
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_theta1 = u2 * t167;
        at.write_dy(30, d_E_hat_1_d_theta1);
        let d_E_hat_1_d_theta = t158 - t129 * t166;
        at.write_dy(29, d_E_hat_1_d_theta);
        let t168 = t59 * t166;
        let t169 = u75 * (tan_theta * t157) - u61 * (x * t161) + t41 * t145 + t155
            + t168;
        let d_E_hat_1_d_x = t169 - t146;
        at.write_dy(32, d_E_hat_1_d_x);
        let theta_2 = u3 * theta2;
        let t170 = u51 * t160 - u21 * (theta_2 + tan_theta);
        let d_E_hat_1_d_R = t146 + (t170 * (u60 * t157) - t155 - t168);
        let d_T_hat_1_d_R = t62 + (t170 * (Phi * t139) - t82);
        at.write_dc(25, d_T_hat_1_d_R);
        at.write_dc(75, d_E_hat_1_d_R);
        let d_T_hat_1_d_EI = -(u74 * (t139 * t160));
        at.write_dc(22, d_T_hat_1_d_EI);
        let d_T_hat_1_d_theta1 = -(u96 * t160);
        at.write_dy(2, d_T_hat_1_d_theta1);
        let s = at.position::<Real>();
        let t171 = Phi * s;
        let t172 = A_hat_1 * (s * r);
        let (sin_t171, cos_t171) = sin_cos(t171);
        let A_x_hat_1 = cos_t171 * t97;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t97 * sin_t171;
        at.write_f(10, A_y_hat_1);
        let t174 = r * cos_t171;
        let t175 = r * sin_t171;
        let t176 = t9 * t175;
        let t177 = t9 * t174;
        let d_A_x_hat_1_d_theta = t129 * t177;
        at.write_dy(24, d_A_x_hat_1_d_theta);
        let t178 = t59 * t177;
        let d_A_y_hat_1_d_theta = t129 * t176;
        at.write_dy(26, d_A_y_hat_1_d_theta);
        let t179 = t59 * t176;
        let t180 = t128 * t175;
        let d_A_y_hat_1_d_Phi = cos_t171 * t172 + d_A_hat_1_d_Phi * t175;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t174 - sin_t171 * t172;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let t181 = t128 * t174;
        let t182 = A_hat_1 * cos_t171;
        let t183 = A_hat_1 * sin_t171;
        let d_A_y_hat_1_d_x = u16 * t180 - t179 - t183;
        at.write_dy(27, d_A_y_hat_1_d_x);
        let d_A_y_hat_1_d_R = t183 + t179;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_A_y_hat_1_d_k = t10 * t180;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_x_hat_1_d_k = t10 * t181;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_x = u16 * t181 - t178 - t182;
        at.write_dy(25, d_A_x_hat_1_d_x);
        let d_A_x_hat_1_d_R = t182 + t178;
        at.write_dc(68, d_A_x_hat_1_d_R);
    }
}
/// Derived fields.
///
/// 16 add, 38 mul, 4 div, 2 sqrt, 3 fn a point; 26 once.
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
        let u9 = reciprocal(v_thr);
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
        let slip = u9 * speed;
        let saturation = saturate(slip);
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
