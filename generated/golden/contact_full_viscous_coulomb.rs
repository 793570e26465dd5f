// contact_full_viscous_coulomb: The belt in a groove: full shear, viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
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
/// Right-hand side and integrands.
///
/// 31 add, 86 mul, 6 div, 2 sqrt, 2 fn a point; 31 once.
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
        let axial = u12 * x;
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let F = u6 * (u4 + m_o * T);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let v_t = cos_theta * V - omega * r;
        let t2 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        let face_speed = sqrt(u9 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let slip = u10 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let f_r = t3 * (v_r * mu);
        let f_t = t3 * (v_t * mu);
        let p = u12 * (x * reciprocal(cos_beta + u11 * f_r));
        let loss_radial = u16 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let q = Real::splat(2.0) * (r * p);
        let t4 = reciprocal(cos_theta);
        let tan_theta = t4 * sin_theta;
        let arc = r * t4;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(6, A_hat_1);
        let t5 = r * A_hat_1;
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(7, L_o_hat_1);
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(5, M_hat_1);
        let t6 = cos_theta * reciprocal(r);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(4, x_hat_1);
        let t7 = t6 * t6;
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let t8 = tan_theta * tan_theta;
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t9 = theta_1 - Real::splat(1.0);
        let t10 = t6 * t9;
        let stored = u18 * (t10 * t10) - u17 * (x * x);
        let t11 = theta1 * theta1;
        let t12 = u3 * t11;
        let t13 = u13 * (theta1 * t11);
        let theta2 = at.state::<Real>(3);
        at.write_f(2, theta2);
        let t14 = t8 * t13 + (theta_1 + Real::splat(2.0) * (t12 * t8))
            - Real::splat(4.0) * (tan_theta * (u13 * (theta1 * theta2)));
        let theta_2 = u3 * theta2;
        let theta_3 = u14 * reciprocal(t7) * (n + T * theta_1 - T)
            - (t14 - theta_1 * t8 - Real::splat(2.0) * (theta_2 * tan_theta) - t13
                - Real::splat(2.0) * t8);
        let T_hat_1 = Phi
            * (t - t9 * (EI * (t7 * (theta_2 + tan_theta - tan_theta * t12))));
        at.write_f(0, T_hat_1);
        let E_hat_1 = V_T * (T_hat_1 * stored);
        at.write_f(11, E_hat_1);
        let theta_hat_3 = u15 * theta_3;
        at.write_f(3, theta_hat_3);
        let s = at.position::<Real>();
        let t15 = Phi * s;
        let (sin_t15, cos_t15) = sin_cos(t15);
        let A_x_hat_1 = cos_t15 * t5;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t5 * sin_t15;
        at.write_f(10, A_y_hat_1);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 133 add, 349 mul, 7 div, 2 sqrt, 2 fn a point; 85 once.
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
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = omega_P * r;
        let axial = u14 * x;
        let t2 = u40 * x;
        let T = at.state::<Real>(0);
        let t3 = T + EA;
        let V = V_T * t3;
        let t4 = u24 * (u6 * t3 + u30 * t3);
        let t5 = u4 + m_o * T;
        let F = u7 * t5;
        let t6 = reciprocal(EA + F);
        let t7 = u41 * t6;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t9 = cos_theta * V;
        let v_t = t9 - omega * r;
        let t10 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t10));
        let face_speed = sqrt(u11 * t10 + speed * speed);
        let t11 = reciprocal(face_speed);
        let t12 = speed * t11;
        let t13 = t11 * t11;
        let t14 = v_r * t11;
        let t15 = u31 * t14;
        let slip = u12 * speed;
        let t16 = reciprocal(speed);
        let t17 = v_r * t16;
        let t18 = v_t * t16;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t19 = u43 * below_one(slip);
        let t20 = v_r * mu;
        let f_r = t11 * t20;
        let t21 = t20 * t13;
        let t22 = t14 * t19 - t12 * t21;
        let t23 = t18 * t22;
        let t24 = reciprocal(cos_beta + u13 * f_r);
        let t25 = x * t24;
        let p = u14 * t25;
        let t26 = u32 * (r * t24) - u32 * t25;
        let t27 = r * p;
        let q = Real::splat(2.0) * t27;
        let t28 = u48 * t27;
        let t29 = x * (t24 * t24);
        let t30 = r * t29;
        let t31 = f_r - sin_beta;
        let t32 = v_r * f_r;
        let loss_radial = u19 * (p * t32);
        let t33 = v_t * mu;
        let t34 = t33 * t13;
        let t35 = v_t * t11 * t19 - t12 * t34;
        let t36 = t17 * t35 - t15 * t34;
        let f_t = t11 * t33;
        let t37 = mu * t11;
        let t38 = t37 - t15 * t21 + t17 * t22;
        let t39 = t37 + t18 * t35;
        let t40 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t40);
        let loss = loss_radial + loss_tangential;
        let t41 = Phi * loss;
        let t42 = f_t * q;
        let t43 = Phi * t42;
        let t44 = reciprocal(cos_theta);
        let tan_theta = t44 * sin_theta;
        let t45 = f_t + tan_theta * t31;
        let t = q * t45;
        let t46 = Phi * t45 * t26;
        let t47 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t47;
        let t48 = tan_theta * tan_theta;
        let t49 = Real::splat(1.0) + t48;
        let d_x_hat_1_d_theta = -(t49 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let t50 = r * tan_theta;
        let x_hat_1 = -(Phi * t50);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t50;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t51 = tan_theta * q;
        let t52 = Phi * t51 - u56 * (t45 * t30);
        let t53 = t28 * t36 + t38 * t52;
        let t54 = t28 * t39 + t23 * t52;
        let d_T_hat_1_d_sigma = -(t1 * t54);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let arc = r * t44;
        let t55 = u48 * (arc * t40) + u49 * (arc * t32);
        let t56 = u49 * (arc * (v_r * p)) - u21 * t29 * t55;
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t57 = u48 * (arc * (v_t * p));
        let t58 = u49 * (arc * (f_r * p)) + t57 * t36 + t56 * t38;
        let t59 = u48 * (arc * (f_t * p)) + t57 * t39 + t56 * t23;
        let d_W_hat_1_d_x = u14 * t24 * t55 - t44 * t41 + omega * t59;
        at.write_dy(24, d_W_hat_1_d_x);
        let t60 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t60;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let t61 = u56 * (t60 * t30);
        let d_W_hat_1_d_sigma = -(t1 * t59);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t62 = r * A_hat_1;
        let d_L_o_hat_1_d_Phi = arc * (EA * t6);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t63 = arc * (u29 * (t6 * t6));
        let d_L_o_hat_1_d_flow = -(u24 * ((u27 * t5 + u28) * (u42 * t63)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_T = -(u47 * t63);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t64 = Phi * (arc * q);
        let t65 = u40 * arc;
        let d_A_hat_1_d_x = t65 - t44 * t2;
        at.write_dy(18, d_A_hat_1_d_x);
        let t66 = t64 * t36 - t38 * t61;
        let t67 = t64 * t39 - t23 * t61;
        let d_M_hat_1_d_x = Phi * t60 * t26 - t44 * t43 + omega * t67;
        at.write_dy(16, d_M_hat_1_d_x);
        let d_M_hat_1_d_sigma = -(t1 * t67);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t68 = t44 * t44 * (r * sin_theta);
        let d_M_hat_1_d_theta = t9 * t66 + t68 * t43 - v_r * t67;
        at.write_dy(15, d_M_hat_1_d_theta);
        let d_W_hat_1_d_theta = t9 * t58 + t68 * t41 - v_r * t59;
        at.write_dy(23, d_W_hat_1_d_theta);
        let d_A_hat_1_d_theta = t68 * t2;
        at.write_dy(17, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t68 * t7;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t44 * t7);
        at.write_dy(21, d_L_o_hat_1_d_x);
        let t69 = cos_theta * reciprocal(r);
        let t70 = t69 * t69;
        let t71 = reciprocal(t70);
        let t72 = u16 * t71;
        let t73 = t72 * t51;
        let t74 = t47 * t72;
        let t75 = u52 * (t27 * t71) + t74 * (u53 * t30);
        let t76 = t73 * t36 - t38 * t75;
        let t77 = t73 * t39 - t23 * t75;
        let t78 = u18 * t77;
        let d_theta_hat_3_d_sigma = -(u66 * (r * t77));
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let t79 = u18 * t76;
        let t80 = t69 * t70;
        let t81 = V_T * sin_theta;
        let t82 = t81 * t53;
        let t83 = V_T * cos_theta;
        let d_T_hat_1_d_T = t82 + t83 * t54;
        at.write_dy(0, d_T_hat_1_d_T);
        let d_M_hat_1_d_T = t81 * t66 + t83 * t67;
        at.write_dy(14, d_M_hat_1_d_T);
        let d_W_hat_1_d_T = t81 * t58 + t83 * t59;
        at.write_dy(22, d_W_hat_1_d_T);
        let t84 = sin_theta * t4;
        let t85 = cos_theta * t4;
        let d_M_hat_1_d_flow = t84 * t66 + t85 * t67;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_W_hat_1_d_flow = t84 * t58 + t85 * t59;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_theta_hat_3_d_flow = t84 * t79 + t85 * t78;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let t86 = t84 * t53;
        let d_T_hat_1_d_flow = t86 + t85 * t54;
        at.write_dc(2, d_T_hat_1_d_flow);
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t87 = n + T * theta_1 - T;
        let t88 = u18 * (u33 * t80 * (t87 * (u37 * (t71 * t71))));
        let d_theta_hat_3_d_x = u18 * (t74 * t26) - t44 * t88 + u65 * t77;
        at.write_dy(11, d_theta_hat_3_d_x);
        let t89 = theta_1 - Real::splat(1.0);
        let d_theta_hat_3_d_T = u18 * (t89 * t72) + u61 * (sin_theta * t76)
            + u61 * (cos_theta * t77);
        at.write_dy(7, d_theta_hat_3_d_T);
        let t90 = t69 * t89;
        let stored = u22 * (t90 * t90) - u21 * (x * x);
        let t91 = V_T * stored;
        let t92 = t91 * t54;
        let d_E_hat_1_d_T = t91 * t82 + t83 * t92;
        at.write_dy(29, d_E_hat_1_d_T);
        let d_E_hat_1_d_sigma = -(t1 * t92);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t93 = t89 * t70;
        let d_T_hat_1_d_theta2 = -(u54 * t93);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let d_E_hat_1_d_theta2 = -(u63 * (stored * t93));
        at.write_dy(32, d_E_hat_1_d_theta2);
        let t94 = theta_1 * t48;
        let t95 = theta_1 * tan_theta;
        let t96 = Real::splat(4.0) * t95 + Real::splat(2.0) * tan_theta;
        let d_theta_hat_3_d_theta2 = u60 * t96;
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t97 = theta1 * theta1;
        let t98 = u3 * t97;
        let t99 = t49
            * (Phi * (q * t31) - u38 * (t89 * (t70 * (Real::splat(1.0) - t98))))
            + t9 * t53;
        let t100 = tan_theta * t98;
        let t101 = t98 * t48;
        let t102 = u15 * (theta1 * t97);
        let t103 = u3 * theta1;
        let theta2 = at.state::<Real>(3);
        at.write_f(2, theta2);
        let theta_2 = u3 * theta2;
        let t104 = theta_2 + tan_theta - t100;
        let t105 = t89 * (t104 * t80);
        let t106 = t70 * t104;
        let t107 = t - t89 * (EI * t106);
        let t108 = u51 * (t89 * (t70 * t95)) - u38 * t106;
        let t109 = t90 * t107;
        let t110 = t69 * t109;
        let t111 = u64 * (stored * t105) - u46 * (t93 * t109);
        let d_E_hat_1_d_x = t91 * t46 - u45 * (x * t107) - t44 * t111 + omega * t92;
        at.write_dy(33, d_E_hat_1_d_x);
        let d_E_hat_1_d_theta = t91 * t99 + t68 * t111 - v_r * t92;
        at.write_dy(30, d_E_hat_1_d_theta);
        let d_T_hat_1_d_Phi = t107 + u55 * (theta2 * t93) - t103 * t108;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = t91 * d_T_hat_1_d_Phi - u58 * (theta1 * t110);
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_theta1 = u57 * t110 + u62 * (stored * t108);
        at.write_dy(31, d_E_hat_1_d_theta1);
        let d_T_hat_1_d_theta1 = u2 * t108;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let T_hat_1 = Phi * t107;
        at.write_f(0, T_hat_1);
        let t112 = T_hat_1 * stored;
        let d_E_hat_1_d_flow = u50 * t112 + t91 * t86 + t85 * t92;
        at.write_dc(20, d_E_hat_1_d_flow);
        let E_hat_1 = V_T * t112;
        at.write_f(11, E_hat_1);
        let t113 = u51 * t105;
        let d_T_hat_1_d_theta = t99 + t68 * t113 - v_r * t54;
        let d_T_hat_1_d_x = t46 - t44 * t113 + omega * t54;
        at.write_dy(4, d_T_hat_1_d_x);
        at.write_dy(1, d_T_hat_1_d_theta);
        let t114 = theta_2 * tan_theta;
        let t115 = Real::splat(3.0) * t101 + (Real::splat(1.0) + Real::splat(4.0) * t94)
            - Real::splat(4.0) * t114 - u36 * t97 - t48;
        let t116 = T * t72 - t115;
        let t117 = theta1 * theta2;
        let t118 = t48 * t102 + (theta_1 + Real::splat(2.0) * t101)
            - Real::splat(4.0) * (tan_theta * (u15 * t117)) - t94;
        let theta_3 = t72 * t87
            - (t118 - Real::splat(2.0) * t114 - t102 - Real::splat(2.0) * t48);
        let t119 = Real::splat(4.0) * t100 + Real::splat(2.0) * (tan_theta * t102)
            - u34 * t117 - Real::splat(2.0) * t95 - u35 * theta2;
        let t120 = u18 * (t49 * (t72 * t42 - (t119 - Real::splat(4.0) * tan_theta)))
            + t9 * t79 + t68 * t88;
        let d_theta_hat_3_d_theta = t120 - v_r * t78;
        let d_theta_hat_3_d_Phi = u39 * theta_3
            - u18 * (u23 * theta2 * t96 + t103 * t116);
        at.write_dc(3, d_theta_hat_3_d_Phi);
        at.write_dy(8, d_theta_hat_3_d_theta);
        let theta_hat_3 = u18 * theta_3;
        at.write_f(3, theta_hat_3);
        let d_theta_hat_3_d_theta1 = u59 * t116;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let s = at.position::<Real>();
        let t121 = Phi * s;
        let t122 = A_hat_1 * (s * r);
        let (sin_t121, cos_t121) = sin_cos(t121);
        let A_x_hat_1 = cos_t121 * t62;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t62 * sin_t121;
        at.write_f(10, A_y_hat_1);
        let t124 = r * cos_t121;
        let t125 = r * sin_t121;
        let t126 = t2 * t125;
        let t127 = t2 * t124;
        let d_A_x_hat_1_d_theta = t68 * t127;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t124 * t65 - A_hat_1 * cos_t121 - t44 * t127;
        let d_A_y_hat_1_d_x = t125 * t65 - A_hat_1 * sin_t121 - t44 * t126;
        at.write_dy(28, d_A_y_hat_1_d_x);
        at.write_dy(26, d_A_x_hat_1_d_x);
        let d_A_y_hat_1_d_theta = t68 * t126;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_Phi = cos_t121 * t122 + d_A_hat_1_d_Phi * t125;
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t124 - sin_t121 * t122;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        at.write_dc(17, d_A_y_hat_1_d_Phi);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 211 add, 521 mul, 7 div, 2 sqrt, 2 fn a point; 118 once.
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
        at.write_dy(5, Real::splat(1.0));
        at.write_dy(6, Real::splat(1.0));
        let x = at.state::<Real>(4);
        let r = R - x;
        let t1 = Real::splat(2.0) * r;
        let axial = u16 * x;
        let t2 = x * x;
        let t3 = u53 * x;
        let t4 = Real::splat(0.5) * x;
        let T = at.state::<Real>(0);
        let t5 = T + EA;
        let V = V_T * t5;
        let t6 = u8 * t5 + u38 * t5;
        let t7 = V_T - u37 * t5;
        let t8 = u39 * t5;
        let t9 = u6 + m_o * T;
        let F = u9 * t9;
        let t10 = EA + F;
        let t11 = reciprocal(t10);
        let t12 = u54 * t11;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t14 = cos_theta * V;
        let v_t = t14 - omega * r;
        let t15 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t15));
        let face_speed = sqrt(u13 * t15 + speed * speed);
        let t16 = reciprocal(face_speed);
        let t17 = Real::splat(0.5) * t16 * (u41 * t15 + u43 * t15);
        let t18 = v_t * t16;
        let t19 = v_r * t16;
        let t20 = u44 * t19;
        let t21 = speed * t16;
        let t22 = t16 * t16;
        let slip = u14 * speed;
        let saturation = saturate(slip);
        let t23 = below_one(slip);
        let mu = mu_k * saturation;
        let t24 = v_r * mu;
        let f_r = t16 * t24;
        let t25 = t24 * t22;
        let t26 = reciprocal(cos_beta + u15 * f_r);
        let t27 = x * t26;
        let p = u16 * t27;
        let t28 = r * p;
        let q = Real::splat(2.0) * t28;
        let t29 = u62 * t28;
        let t30 = u45 * t27;
        let t31 = Real::splat(0.5) * t27;
        let t32 = x * (t26 * t26);
        let t33 = u24 * t32;
        let t34 = u16 * t26;
        let t35 = f_r - sin_beta;
        let t36 = q * t35;
        let t37 = (t35 + u13 * f_r) * t32;
        let t38 = u16 * t37;
        let t39 = v_r * f_r;
        let t40 = p * t39;
        let loss_radial = u22 * t40;
        let t41 = v_t * mu;
        let t42 = t41 * t22;
        let f_t = t16 * t41;
        let t43 = mu * t16;
        let t44 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t44);
        let loss = loss_radial + loss_tangential;
        let t45 = Phi * loss;
        let t46 = f_t * q;
        let t47 = Phi * t46;
        let t48 = reciprocal(speed);
        let t49 = u40 * speed;
        let t50 = v_t * t48;
        let t51 = v_r * t48;
        let t52 = reciprocal(cos_theta);
        let tan_theta = t52 * sin_theta;
        let t53 = f_t + tan_theta * t35;
        let t = q * t53;
        let t54 = r * t53;
        let d_T_hat_1_d_k = u82 * (t27 * t54);
        at.write_dc(23, d_T_hat_1_d_k);
        let t55 = u80 * (t27 * t53);
        let t56 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t56;
        let t57 = tan_theta * tan_theta;
        let t58 = Real::splat(1.0) + t57;
        let d_x_hat_1_d_theta = -(t58 * (Phi * r));
        at.write_dy(12, d_x_hat_1_d_theta);
        let t59 = r * tan_theta;
        let x_hat_1 = -(Phi * t59);
        at.write_f(4, x_hat_1);
        let d_x_hat_1_d_Phi = -t59;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t60 = tan_theta * q;
        let t61 = Phi * t60 - u83 * (t32 * t54);
        let t62 = t18 * t29 + t19 * t61;
        let t63 = t23 * (mu_k * t62);
        let d_T_hat_1_d_mu_k = saturation * t62;
        at.write_dc(28, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(t49 * t63);
        at.write_dc(29, d_T_hat_1_d_v_thr);
        let t64 = t42 * t29 + t25 * t61;
        let t65 = u14 * t63 - t21 * t64;
        let t66 = t43 * t29 + t50 * t65;
        let t67 = t43 * t61 - t20 * t64 + t51 * t65;
        let d_T_hat_1_d_beta = -(u75 * t60 + u81 * (t37 * t54) + t17 * t64);
        at.write_dc(27, d_T_hat_1_d_beta);
        let t68 = cos_theta * t66 + sin_theta * t67;
        let d_T_hat_1_d_T = V_T * t68;
        at.write_dy(0, d_T_hat_1_d_T);
        let t69 = t6 * t68;
        let d_T_hat_1_d_flow = u28 * t69;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_T_hat_1_d_m_o = u29 * t69 - t8 * t68;
        at.write_dc(24, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_EA = t7 * t68;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_R_P = u27 * t69;
        at.write_dc(26, d_T_hat_1_d_R_P);
        let t70 = omega * t66;
        let t71 = r * t66;
        let d_T_hat_1_d_omega_P = u5 * t69 - sigma * t71;
        at.write_dc(30, d_T_hat_1_d_omega_P);
        let d_T_hat_1_d_sigma = -(omega_P * t71);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(13, d_x_hat_1_d_x);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(41, d_x_hat_1_d_R);
        let arc = r * t52;
        let t72 = u62 * (arc * t44) + u64 * (arc * t39);
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(8, W_hat_1);
        let t73 = u62 * (arc * (v_t * p));
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(6, A_hat_1);
        let t74 = r * A_hat_1;
        let t75 = u64 * (arc * (v_r * p)) - t33 * t72;
        let t76 = t18 * t73 + t19 * t75;
        let t77 = t23 * (mu_k * t76);
        let d_W_hat_1_d_mu_k = saturation * t76;
        at.write_dc(64, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t49 * t77);
        at.write_dc(65, d_W_hat_1_d_v_thr);
        let t78 = t42 * t73 + t25 * t75;
        let t79 = u14 * t77 - t21 * t78;
        let t80 = u64 * (arc * (f_r * p)) + t43 * t75 - t20 * t78 + t51 * t79;
        let t81 = u62 * (arc * (f_t * p)) + t43 * t73 + t50 * t79;
        let d_W_hat_1_d_beta = u63 * (arc * t40) - t38 * t72 - t17 * t78;
        at.write_dc(63, d_W_hat_1_d_beta);
        let t82 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t82;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(5, M_hat_1);
        let t83 = Phi * (arc * q);
        let t84 = r * t82;
        let t85 = u83 * (t32 * t84);
        let t86 = u80 * (t27 * t82);
        let d_M_hat_1_d_k = u82 * (t27 * t84);
        at.write_dc(43, d_M_hat_1_d_k);
        let t87 = t25 * t85 - t42 * t83;
        let d_M_hat_1_d_beta = t17 * t87 - u81 * (t37 * t84);
        at.write_dc(47, d_M_hat_1_d_beta);
        let t88 = t18 * t83 - t19 * t85;
        let t89 = t23 * (mu_k * t88);
        let d_M_hat_1_d_mu_k = saturation * t88;
        at.write_dc(48, d_M_hat_1_d_mu_k);
        let t90 = t21 * t87 + u14 * t89;
        let t91 = t20 * t87 - t43 * t85 + t51 * t90;
        let t92 = t43 * t83 + t50 * t90;
        let d_M_hat_1_d_v_thr = -(t49 * t89);
        at.write_dc(49, d_M_hat_1_d_v_thr);
        let t93 = cos_theta * t92 + sin_theta * t91;
        let d_M_hat_1_d_T = V_T * t93;
        at.write_dy(14, d_M_hat_1_d_T);
        let t94 = t6 * t93;
        let d_M_hat_1_d_flow = u28 * t94;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_M_hat_1_d_m_o = u29 * t94 - t8 * t93;
        at.write_dc(44, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_EA = t7 * t93;
        at.write_dc(42, d_M_hat_1_d_EA);
        let d_M_hat_1_d_R_P = u27 * t94;
        at.write_dc(46, d_M_hat_1_d_R_P);
        let t95 = omega * t92;
        let t96 = r * t92;
        let d_M_hat_1_d_omega_P = u5 * t94 - sigma * t96;
        at.write_dc(50, d_M_hat_1_d_omega_P);
        let d_M_hat_1_d_sigma = -(omega_P * t96);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t97 = cos_theta * t81 + sin_theta * t80;
        let d_W_hat_1_d_T = V_T * t97;
        at.write_dy(22, d_W_hat_1_d_T);
        let t98 = t6 * t97;
        let d_W_hat_1_d_flow = u28 * t98;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_W_hat_1_d_m_o = u29 * t98 - t8 * t97;
        at.write_dc(60, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_EA = t7 * t97;
        at.write_dc(58, d_W_hat_1_d_EA);
        let d_W_hat_1_d_R_P = u27 * t98;
        at.write_dc(62, d_W_hat_1_d_R_P);
        let t99 = omega * t81;
        let t100 = r * t81;
        let d_W_hat_1_d_omega_P = u5 * t98 - sigma * t100;
        at.write_dc(66, d_W_hat_1_d_omega_P);
        let d_W_hat_1_d_sigma = -(omega_P * t100);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_k = t31 * t72;
        at.write_dc(59, d_W_hat_1_d_k);
        let d_L_o_hat_1_d_Phi = arc * (EA * t11);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(7, L_o_hat_1);
        let t101 = arc * (u35 * (t11 * t11));
        let d_L_o_hat_1_d_T = -(u84 * t101);
        at.write_dy(19, d_L_o_hat_1_d_T);
        let t102 = u66 * t101;
        let t103 = (u21 - u52 * t10) * (Phi * t101) + (u8 * t9 - u31 * t9) * t102;
        let d_L_o_hat_1_d_EA = -t103;
        at.write_dc(53, d_L_o_hat_1_d_EA);
        let t104 = (u33 * t9 + u34) * t102;
        let d_L_o_hat_1_d_m_o = -((u9 * T - u36 * t9) * t102 + u29 * t104);
        at.write_dc(54, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_flow = -(u28 * t104);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u27 * t104);
        at.write_dc(56, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u5 * t104);
        at.write_dc(57, d_L_o_hat_1_d_omega_P);
        let t105 = Phi * arc;
        let d_A_hat_1_d_k = u65 * (x * arc);
        at.write_dc(51, d_A_hat_1_d_k);
        let t106 = t52 * t52 * (r * sin_theta);
        let d_M_hat_1_d_theta = t14 * t91 - v_r * t92 + t106 * t47;
        at.write_dy(15, d_M_hat_1_d_theta);
        let d_W_hat_1_d_theta = t14 * t80 - v_r * t81 + t106 * t45;
        at.write_dy(23, d_W_hat_1_d_theta);
        let t107 = t52 * t47;
        let d_M_hat_1_d_x = u81 * (t26 * t84) + t95 - t107 - t86;
        let d_M_hat_1_d_R = t86 + (t107 - t95);
        at.write_dc(45, d_M_hat_1_d_R);
        at.write_dy(16, d_M_hat_1_d_x);
        let t108 = t52 * t45;
        let d_W_hat_1_d_x = t34 * t72 + t99 - t108;
        at.write_dy(24, d_W_hat_1_d_x);
        let d_W_hat_1_d_R = t108 - t99;
        at.write_dc(61, d_W_hat_1_d_R);
        let d_A_hat_1_d_theta = t106 * t3;
        at.write_dy(17, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t106 * t12;
        at.write_dy(20, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t52 * t12;
        at.write_dc(55, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(21, d_L_o_hat_1_d_x);
        let d_A_hat_1_d_R = t52 * t3;
        let d_A_hat_1_d_x = u53 * arc - d_A_hat_1_d_R;
        at.write_dy(18, d_A_hat_1_d_x);
        at.write_dc(52, d_A_hat_1_d_R);
        let t109 = cos_theta * reciprocal(r);
        let t110 = t109 * t109;
        let t111 = reciprocal(t110);
        let t112 = u18 * t111;
        let t113 = u68 * t111;
        let t114 = t56 * t113;
        let t115 = t1 * t114;
        let t116 = t30 * t114;
        let d_theta_hat_3_d_k = t31 * t115;
        at.write_dc(33, d_theta_hat_3_d_k);
        let t117 = t60 * t113;
        let t118 = t28 * t111;
        let t119 = u79 * t118 + t33 * t115;
        let t120 = t25 * t119 - t42 * t117;
        let d_theta_hat_3_d_beta = u78 * t118 - t38 * t115 + t17 * t120;
        at.write_dc(37, d_theta_hat_3_d_beta);
        let t121 = t18 * t117 - t19 * t119;
        let t122 = t23 * (mu_k * t121);
        let d_theta_hat_3_d_mu_k = saturation * t121;
        at.write_dc(38, d_theta_hat_3_d_mu_k);
        let t123 = t21 * t120 + u14 * t122;
        let t124 = t20 * t120 - t43 * t119 + t51 * t123;
        let t125 = t43 * t117 + t50 * t123;
        let d_theta_hat_3_d_v_thr = -(t49 * t122);
        at.write_dc(39, d_theta_hat_3_d_v_thr);
        let t126 = cos_theta * t125 + sin_theta * t124;
        let t127 = t6 * t126;
        let d_theta_hat_3_d_flow = u28 * t127;
        at.write_dc(5, d_theta_hat_3_d_flow);
        let d_theta_hat_3_d_m_o = u29 * t127 - t8 * t126;
        at.write_dc(34, d_theta_hat_3_d_m_o);
        let d_theta_hat_3_d_R_P = u27 * t127;
        at.write_dc(36, d_theta_hat_3_d_R_P);
        let d_theta_hat_3_d_EA = t7 * t126;
        at.write_dc(31, d_theta_hat_3_d_EA);
        let t128 = omega * t125;
        let t129 = r * t125;
        let d_theta_hat_3_d_omega_P = u5 * t127 - sigma * t129;
        at.write_dc(40, d_theta_hat_3_d_omega_P);
        let d_theta_hat_3_d_sigma = -(omega_P * t129);
        at.write_dc(4, d_theta_hat_3_d_sigma);
        let t130 = t109 * t110;
        let theta1 = at.state::<Real>(2);
        at.write_f(1, theta1);
        let theta_1 = u2 * theta1;
        let t131 = n + T * theta_1 - T;
        let t132 = t131 * (u49 * (t111 * t111));
        let t133 = u70 * (t130 * t132);
        let d_theta_hat_3_d_EI = -(t110 * (u20 * t132));
        at.write_dc(32, d_theta_hat_3_d_EI);
        let t134 = t52 * t133;
        let d_theta_hat_3_d_x = t34 * t115 + t128 - t134 - t116;
        let d_theta_hat_3_d_R = t116 + (t134 - t128);
        at.write_dc(35, d_theta_hat_3_d_R);
        at.write_dy(11, d_theta_hat_3_d_x);
        let t135 = theta_1 - Real::splat(1.0);
        let d_theta_hat_3_d_T = u20 * (t135 * t112) + V_T * t126;
        at.write_dy(7, d_theta_hat_3_d_T);
        let t136 = t109 * t135;
        let t137 = t136 * t136;
        let stored = u26 * t137 - u24 * t2;
        let t138 = u77 * (t28 * stored);
        let t139 = u57 * stored;
        let t140 = t53 * t139;
        let t141 = t1 * t140;
        let t142 = t30 * t140;
        let t143 = t60 * t139 - t33 * t141;
        let t144 = t18 * t138 + t19 * t143;
        let t145 = t42 * t138 + t25 * t143;
        let t146 = t23 * (mu_k * t144);
        let d_E_hat_1_d_mu_k = saturation * t144;
        at.write_dc(78, d_E_hat_1_d_mu_k);
        let t147 = u14 * t146 - t21 * t145;
        let t148 = t43 * t143 - t20 * t145 + t51 * t147;
        let t149 = t43 * t138 + t50 * t147;
        let t150 = cos_theta * t149 + sin_theta * t148;
        let d_E_hat_1_d_v_thr = -(t49 * t146);
        at.write_dc(79, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_T = V_T * t150;
        at.write_dy(29, d_E_hat_1_d_T);
        let t151 = omega * t149;
        let t152 = r * t149;
        let d_E_hat_1_d_sigma = -(omega_P * t152);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t153 = t135 * stored;
        let t154 = t110 * t153;
        let d_E_hat_1_d_theta2 = -(u90 * t154);
        at.write_dy(32, d_E_hat_1_d_theta2);
        let t155 = t135 * t110;
        let d_T_hat_1_d_theta2 = -(u85 * t155);
        at.write_dy(3, d_T_hat_1_d_theta2);
        let t156 = theta_1 * t57;
        let t157 = theta_1 * tan_theta;
        let t158 = t110 * t157;
        let t159 = Real::splat(4.0) * t157 + Real::splat(2.0) * tan_theta;
        let d_theta_hat_3_d_theta2 = u88 * t159;
        at.write_dy(10, d_theta_hat_3_d_theta2);
        let t160 = theta1 * theta1;
        let t161 = u3 * t160;
        let t162 = tan_theta * t161;
        let t163 = t161 * t57;
        let t164 = t110 * (Real::splat(1.0) - t161);
        let t165 = t14 * t148 - v_r * t149 + t58 * (t36 * t139 - u73 * (t164 * t153));
        let t166 = t14 * t67 - v_r * t66 + t58 * (Phi * t36 - u50 * (t135 * t164));
        let t167 = u17 * (theta1 * t160);
        let t168 = u3 * theta1;
        let theta2 = at.state::<Real>(3);
        at.write_f(2, theta2);
        let t169 = theta1 * theta2;
        let t170 = t57 * t167 + (theta_1 + Real::splat(2.0) * t163)
            - Real::splat(4.0) * (tan_theta * (u17 * t169)) - t156;
        let t171 = Real::splat(4.0) * t162 + Real::splat(2.0) * (tan_theta * t167)
            - u46 * t169 - Real::splat(2.0) * t157 - u47 * theta2;
        let t172 = t14 * t124 - v_r * t125
            + t58 * (t46 * t113 - u20 * (t171 - Real::splat(4.0) * tan_theta));
        let d_theta_hat_3_d_theta = t172 + t106 * t133;
        at.write_dy(8, d_theta_hat_3_d_theta);
        let theta_2 = u3 * theta2;
        let t173 = theta_2 + tan_theta - t162;
        let t174 = theta_2 * tan_theta;
        let theta_3 = t112 * t131
            - (t170 - Real::splat(2.0) * t174 - t167 - Real::splat(2.0) * t57);
        let t175 = Real::splat(3.0) * t163 + (Real::splat(1.0) + Real::splat(4.0) * t156)
            - Real::splat(4.0) * t174 - u48 * t160 - t57;
        let t176 = u20 * (T * t112) - u20 * t175;
        let d_theta_hat_3_d_Phi = u51 * theta_3 - u89 * (theta2 * t159) - t168 * t176;
        at.write_dc(3, d_theta_hat_3_d_Phi);
        let d_theta_hat_3_d_theta1 = u2 * t176;
        at.write_dy(9, d_theta_hat_3_d_theta1);
        let theta_hat_3 = u20 * theta_3;
        at.write_f(3, theta_hat_3);
        let t177 = t110 * t173;
        let t178 = t173 * t130;
        let t179 = t - t135 * (EI * t177);
        let t180 = (u16 * t2 + u56 * t2) * (u57 * t179) + u76 * (stored * t60)
            + t38 * t141;
        let d_E_hat_1_d_beta = -(t180 + t17 * t145);
        at.write_dc(77, d_E_hat_1_d_beta);
        let d_E_hat_1_d_k = t31 * t141 - u60 * (t179 * t2);
        at.write_dc(73, d_E_hat_1_d_k);
        let T_hat_1 = Phi * t179;
        at.write_f(0, T_hat_1);
        let t181 = T_hat_1 * stored;
        let t182 = u55 * t181 + t6 * t150;
        let d_E_hat_1_d_m_o = u29 * t182 - (u39 * t181 + t8 * t150);
        at.write_dc(74, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_EA = t7 * t150 - u37 * t181;
        at.write_dc(71, d_E_hat_1_d_EA);
        let d_E_hat_1_d_omega_P = u5 * t182 - sigma * t152;
        at.write_dc(80, d_E_hat_1_d_omega_P);
        let E_hat_1 = V_T * t181;
        at.write_f(11, E_hat_1);
        let d_E_hat_1_d_flow = u28 * t182;
        at.write_dc(20, d_E_hat_1_d_flow);
        let d_E_hat_1_d_R_P = u27 * t182;
        at.write_dc(76, d_E_hat_1_d_R_P);
        let t183 = t136 * t179;
        let d_E_hat_1_d_EI = t136 * (u61 * t183)
            - (u59 * (t179 * t137) + t177 * (u57 * t153));
        at.write_dc(72, d_E_hat_1_d_EI);
        let t184 = u72 * (t158 * t153) - u67 * (t177 * stored) + u74 * (t109 * t183);
        let d_E_hat_1_d_Phi = t179 * (V_T * stored) + u91 * (theta2 * t154)
            - t168 * t184;
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t185 = u72 * (t178 * t153) - u74 * (t155 * t183);
        let d_E_hat_1_d_theta = t165 + t106 * t185;
        at.write_dy(30, d_E_hat_1_d_theta);
        let t186 = t52 * t185;
        let d_E_hat_1_d_x = t34 * t141 - u58 * (x * t179) + t151 - t186 - t142;
        let d_E_hat_1_d_R = t142 + (t186 - t151);
        at.write_dc(75, d_E_hat_1_d_R);
        at.write_dy(33, d_E_hat_1_d_x);
        let d_E_hat_1_d_theta1 = u2 * t184;
        at.write_dy(31, d_E_hat_1_d_theta1);
        let t187 = u71 * (t135 * t178);
        let d_T_hat_1_d_theta = t166 + t106 * t187;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t188 = t52 * t187;
        let d_T_hat_1_d_x = u81 * (t26 * t54) + t70 - t188 - t55;
        let d_T_hat_1_d_R = t55 + (t188 - t70);
        at.write_dc(25, d_T_hat_1_d_R);
        at.write_dy(4, d_T_hat_1_d_x);
        let t189 = u71 * (t135 * t158) - u50 * t177;
        let d_T_hat_1_d_Phi = t179 + u87 * (theta2 * t155) - t168 * t189;
        at.write_dc(0, d_T_hat_1_d_Phi);
        let d_T_hat_1_d_EI = -(t177 * (Phi * t135));
        at.write_dc(22, d_T_hat_1_d_EI);
        let d_T_hat_1_d_theta1 = u2 * t189;
        at.write_dy(2, d_T_hat_1_d_theta1);
        let s = at.position::<Real>();
        let t190 = Phi * s;
        let t191 = A_hat_1 * (s * r);
        let (sin_t190, cos_t190) = sin_cos(t190);
        let A_x_hat_1 = cos_t190 * t74;
        at.write_f(9, A_x_hat_1);
        let A_y_hat_1 = t74 * sin_t190;
        at.write_f(10, A_y_hat_1);
        let t193 = r * cos_t190;
        let t194 = r * sin_t190;
        let t195 = t3 * t194;
        let t196 = t3 * t193;
        let d_A_x_hat_1_d_theta = t106 * t196;
        at.write_dy(25, d_A_x_hat_1_d_theta);
        let t197 = t52 * t196;
        let d_A_y_hat_1_d_theta = t106 * t195;
        at.write_dy(27, d_A_y_hat_1_d_theta);
        let t198 = t52 * t195;
        let t199 = t105 * t194;
        let d_A_y_hat_1_d_Phi = cos_t190 * t191 + d_A_hat_1_d_Phi * t194;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t193 - sin_t190 * t191;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let t200 = t105 * t193;
        let t201 = A_hat_1 * cos_t190;
        let t202 = A_hat_1 * sin_t190;
        let d_A_y_hat_1_d_x = u16 * t199 - t198 - t202;
        at.write_dy(28, d_A_y_hat_1_d_x);
        let d_A_y_hat_1_d_R = t202 + t198;
        at.write_dc(70, d_A_y_hat_1_d_R);
        let d_A_y_hat_1_d_k = t4 * t199;
        at.write_dc(69, d_A_y_hat_1_d_k);
        let d_A_x_hat_1_d_k = t4 * t200;
        at.write_dc(67, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_x = u16 * t200 - t197 - t201;
        at.write_dy(26, d_A_x_hat_1_d_x);
        let d_A_x_hat_1_d_R = t201 + t197;
        at.write_dc(68, d_A_x_hat_1_d_R);
    }
}
/// Derived fields.
///
/// 16 add, 41 mul, 4 div, 2 sqrt, 3 fn a point; 21 once.
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
        let t2 = v_r * v_r;
        let t3 = reciprocal(cos_theta);
        let tan_theta = t3 * sin_theta;
        let x = at.state::<Real>(4);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        at.write_field(3, v_t);
        let t4 = cos_theta * reciprocal(r);
        let arc = r * t3;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        at.write_field(4, speed);
        let face_speed = sqrt(u9 * t2 + speed * speed);
        let t5 = reciprocal(face_speed);
        let slip = u10 * speed;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let beta_s = angle(speed, u11 * v_r);
        at.write_field(8, beta_s);
        let f_r = t5 * (v_r * mu);
        let f_t = t5 * (v_t * mu);
        let p = u12 * (x * reciprocal(cos_beta + u11 * f_r));
        at.write_field(7, p);
        let loss_radial = u13 * (p * (v_r * f_r));
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
        let axial = u12 * x;
        at.write_field(11, axial);
        let theta2 = at.state::<Real>(3);
        let theta_2 = u3 * theta2;
        let theta1 = at.state::<Real>(2);
        let Q = -(EI
            * (t4 * t4 * (theta_2 + tan_theta - tan_theta * (u3 * (theta1 * theta1)))));
        at.write_field(9, Q);
        let theta_1 = u2 * theta1;
        let M_b = -(EI * (t4 * (theta_1 - Real::splat(1.0))));
        at.write_field(10, M_b);
    }
}
