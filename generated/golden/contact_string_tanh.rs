// contact_string_tanh: The belt in a groove, without bending stiffness: tanh friction.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 17 add, 56 mul, 5 div, 2 sqrt, 3 fn a point; 25 once
//   jacobian: 91 add, 252 mul, 6 div, 2 sqrt, 3 fn a point; 59 once
//   full: 161 add, 409 mul, 6 div, 2 sqrt, 3 fn a point; 91 once
//   fields: 10 add, 29 mul, 3 div, 2 sqrt, 4 fn a point; 20 once
// Equations, with their numbers in the source:
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
// - M_b (typed in): a string carries no moment
// - Q (typed in): a string carries no moment
// - theta_1 (derived): (3.22)
// - T_hat_1 (derived): (3.23)
// - theta_hat_1 (typed in): (5.2)
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

///The belt in a groove, without bending stiffness: tanh friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_string_tanh",
    states: &[State::Tension, State::Inclination, State::Penetration],
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
        (1, 0),
        (1, 1),
        (1, 2),
        (2, 1),
        (2, 2),
        (3, 0),
        (3, 1),
        (3, 2),
        (4, 1),
        (4, 2),
        (5, 0),
        (5, 1),
        (5, 2),
        (6, 0),
        (6, 1),
        (6, 2),
        (7, 1),
        (7, 2),
        (8, 1),
        (8, 2),
        (9, 0),
        (9, 1),
        (9, 2),
    ],
    constant_pattern: &[
        (0, 0),
        (0, 1),
        (0, 2),
        (1, 0),
        (1, 1),
        (1, 2),
        (2, 0),
        (3, 0),
        (3, 1),
        (3, 2),
        (4, 0),
        (5, 0),
        (5, 2),
        (6, 0),
        (6, 1),
        (6, 2),
        (7, 0),
        (8, 0),
        (9, 0),
        (9, 1),
        (9, 2),
        (0, 3),
        (0, 5),
        (0, 6),
        (0, 7),
        (0, 8),
        (0, 9),
        (0, 10),
        (0, 11),
        (0, 12),
        (1, 3),
        (1, 5),
        (1, 6),
        (1, 7),
        (1, 8),
        (1, 9),
        (1, 10),
        (1, 11),
        (1, 12),
        (2, 7),
        (3, 3),
        (3, 5),
        (3, 6),
        (3, 7),
        (3, 8),
        (3, 9),
        (3, 10),
        (3, 11),
        (3, 12),
        (4, 5),
        (4, 7),
        (5, 3),
        (5, 6),
        (5, 7),
        (5, 8),
        (5, 12),
        (6, 3),
        (6, 5),
        (6, 6),
        (6, 7),
        (6, 8),
        (6, 9),
        (6, 10),
        (6, 11),
        (6, 12),
        (7, 5),
        (7, 7),
        (8, 5),
        (8, 7),
        (9, 3),
        (9, 5),
        (9, 6),
        (9, 7),
        (9, 8),
        (9, 9),
        (9, 10),
        (9, 11),
        (9, 12),
    ],
    default_entries: 21,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
/// Right-hand side and integrands.
///
/// 17 add, 56 mul, 5 div, 2 sqrt, 3 fn a point; 25 once.
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 3;
    const CONSTANTS: usize = 13;
    const F: usize = 10;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 17];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let Phi = constants[0];
        let EA = constants[3];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u2 = G * G;
        let u3 = reciprocal(EA * m_o - u2);
        let u4 = EA * u3;
        let V_T = G * u3;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u5 = reciprocal(cos_beta);
        let u6 = u5 * u5;
        let u7 = sin_beta * sin_beta * u6;
        let v_thr = constants[11];
        let u8 = reciprocal(v_thr) * 4.0;
        let u9 = sin_beta * u5;
        let k = constants[5];
        let u10 = k * 0.5;
        let u11 = u6 * 2.0;
        let u12 = V_T * (Phi * (0.5 * (u5 * (k * sin_beta))));
        [
            Phi,
            EA,
            m_o,
            R,
            mu_k,
            cos_beta,
            u2,
            u4,
            V_T,
            omega,
            sin_beta,
            u7,
            u8,
            u9,
            u10,
            u11,
            u12,
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
        let u4 = Real::splat(uniforms[7]);
        let V_T = Real::splat(uniforms[8]);
        let omega = Real::splat(uniforms[9]);
        let sin_beta = Real::splat(uniforms[10]);
        let u7 = Real::splat(uniforms[11]);
        let u8 = Real::splat(uniforms[12]);
        let u9 = Real::splat(uniforms[13]);
        let u10 = Real::splat(uniforms[14]);
        let u11 = Real::splat(uniforms[15]);
        let u12 = Real::splat(uniforms[16]);
        let x = at.state::<Real>(2);
        let r = R - x;
        let axial = u10 * x;
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let F = u4 * (u2 + m_o * T);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let v_t = cos_theta * V - omega * r;
        let t2 = reciprocal(cos_theta);
        let tan_theta = t2 * sin_theta;
        let arc = r * t2;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(4, A_hat_1);
        let t3 = r * A_hat_1;
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(5, L_o_hat_1);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(2, x_hat_1);
        let t4 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t4));
        let face_speed = sqrt(u7 * t4 + speed * speed);
        let t5 = reciprocal(face_speed);
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        let f_r = t5 * (v_r * mu);
        let f_t = t5 * (v_t * mu);
        let p = u10 * (x * reciprocal(cos_beta + u9 * f_r));
        let q = Real::splat(2.0) * (r * p);
        let loss_radial = u11 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(3, M_hat_1);
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let theta_1 = reciprocal(T) * (T - n);
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let E_hat_1 = -(u12 * (t * (x * x)));
        at.write_f(9, E_hat_1);
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let s = at.position::<Real>();
        let t6 = Phi * s;
        let (sin_t6, cos_t6) = sin_cos(t6);
        let A_x_hat_1 = cos_t6 * t3;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t3 * sin_t6;
        at.write_f(8, A_y_hat_1);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 91 add, 252 mul, 6 div, 2 sqrt, 3 fn a point; 59 once.
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 3;
    const CONSTANTS: usize = 13;
    const F: usize = 10;
    const DY: usize = 26;
    const DC: usize = 21;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 43];
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
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u2 = G * G;
        let u3 = EA * m_o;
        let u4 = reciprocal(u3 - u2);
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
        let u12 = u7 * 2.0;
        let u13 = u6 * (k * sin_beta);
        let u14 = 0.5 * u13;
        let u15 = Phi * u14;
        let u16 = V_T * u15;
        let u17 = omega_P * (m_o * R_P);
        let u18 = u4 * u4;
        let u19 = EA * G;
        let u20 = u18 * (2.0 * u19);
        let u21 = 2.0 * (u4 * u19);
        let u22 = EA * EA;
        let u23 = u18 * (u2 * 2.0);
        let u24 = 0.5 * (u8 * 2.0);
        let u25 = u11 * 2.0;
        let u26 = Phi * u11;
        let u27 = Phi * EA;
        let u28 = V_T * u14;
        let u29 = Phi * V_T;
        let u30 = mu_k * u9;
        let u31 = Phi * reciprocal(EA);
        let u32 = u13 * u29;
        let u33 = u3 * u4 * u31;
        let u34 = u17 * (u15 * (u4 + u23));
        let u35 = Phi * u12;
        let u36 = Phi * 2.0;
        let u37 = Phi * u28;
        let u38 = 2.0 * u14;
        let u39 = Phi * u38;
        let u40 = Phi * omega;
        let u41 = Phi * omega_P;
        [
            Phi,
            EA,
            m_o,
            R,
            mu_k,
            omega_P,
            cos_beta,
            u2,
            u4,
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
            u34,
            u35,
            u36,
            u37,
            u38,
            u39,
            u40,
            u41,
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
        let u4 = Real::splat(uniforms[8]);
        let u5 = Real::splat(uniforms[9]);
        let V_T = Real::splat(uniforms[10]);
        let omega = Real::splat(uniforms[11]);
        let sin_beta = Real::splat(uniforms[12]);
        let u8 = Real::splat(uniforms[13]);
        let u9 = Real::splat(uniforms[14]);
        let u10 = Real::splat(uniforms[15]);
        let u11 = Real::splat(uniforms[16]);
        let u12 = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u16 = Real::splat(uniforms[19]);
        let u17 = Real::splat(uniforms[20]);
        let u20 = Real::splat(uniforms[21]);
        let u21 = Real::splat(uniforms[22]);
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
        let u33 = Real::splat(uniforms[34]);
        let u34 = Real::splat(uniforms[35]);
        let u35 = Real::splat(uniforms[36]);
        let u36 = Real::splat(uniforms[37]);
        let u37 = Real::splat(uniforms[38]);
        let u38 = Real::splat(uniforms[39]);
        let u39 = Real::splat(uniforms[40]);
        let u40 = Real::splat(uniforms[41]);
        let u41 = Real::splat(uniforms[42]);
        let x = at.state::<Real>(2);
        let r = R - x;
        let t1 = omega_P * r;
        let axial = u11 * x;
        let t2 = x * x;
        let t3 = u37 * t2;
        let t4 = u26 * x;
        let T = at.state::<Real>(0);
        let t5 = T + EA;
        let V = V_T * t5;
        let t6 = u17 * (u4 * t5 + u23 * t5);
        let t7 = reciprocal(T);
        let t8 = Phi * t7;
        let t9 = u2 + m_o * T;
        let F = u5 * t9;
        let t10 = reciprocal(EA + F);
        let t11 = u27 * t10;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t13 = cos_theta * V;
        let v_t = t13 - omega * r;
        let t14 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t14));
        let face_speed = sqrt(u8 * t14 + speed * speed);
        let t15 = reciprocal(face_speed);
        let t16 = v_r * t15;
        let t17 = u24 * t16;
        let t18 = t15 * t15;
        let t19 = speed * t15;
        let saturation = tanh(u9 * speed);
        let t20 = reciprocal(speed);
        let t21 = v_r * t20;
        let t22 = v_t * t20;
        let mu = mu_k * saturation;
        let t23 = u30 * (Real::splat(1.0) - saturation * saturation);
        let t24 = v_r * mu;
        let f_r = t15 * t24;
        let t25 = t24 * t18;
        let t26 = t16 * t23 - t19 * t25;
        let t27 = t22 * t26;
        let t28 = reciprocal(cos_beta + u10 * f_r);
        let t29 = x * t28;
        let p = u11 * t29;
        let t30 = u25 * (r * t28) - u25 * t29;
        let t31 = r * p;
        let q = Real::splat(2.0) * t31;
        let t32 = x * (t28 * t28);
        let t33 = r * t32;
        let t34 = u38 * t33;
        let t35 = f_r - sin_beta;
        let t36 = v_r * f_r;
        let loss_radial = u12 * (p * t36);
        let t37 = v_t * mu;
        let t38 = t37 * t18;
        let t39 = v_t * t15 * t23 - t19 * t38;
        let t40 = t21 * t39 - t17 * t38;
        let f_t = t15 * t37;
        let t41 = mu * t15;
        let t42 = t41 - t17 * t25 + t21 * t26;
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
        at.write_dc(0, t);
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let t50 = t * t2;
        let d_E_hat_1_d_Phi = -(t * (u28 * t2));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let E_hat_1 = -(u16 * t50);
        at.write_f(9, E_hat_1);
        let t51 = t49 * t30;
        let t52 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t52;
        let t53 = T - n;
        let t54 = t52 * t8;
        let t55 = u36 * (t31 * t7) + t34 * t54;
        let theta_1 = t7 * t53;
        at.write_dc(3, theta_1);
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let t56 = r * tan_theta;
        let x_hat_1 = -(Phi * t56);
        at.write_f(2, x_hat_1);
        let d_x_hat_1_d_Phi = -t56;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t57 = tan_theta * q;
        let t58 = t57 - t49 * t34;
        let t59 = t57 * t8;
        let t60 = t42 * t55 - t40 * t59;
        let t61 = t27 * t55 - t43 * t59;
        let d_theta_hat_1_d_x = omega * t61 - t30 * t54;
        at.write_dy(5, d_theta_hat_1_d_x);
        let d_theta_hat_1_d_sigma = -(t1 * t61);
        at.write_dc(4, d_theta_hat_1_d_sigma);
        let t62 = t42 * t58 + q * t40;
        let t63 = t27 * t58 + q * t43;
        let d_T_hat_1_d_T = u29 * (sin_theta * t62) + u29 * (cos_theta * t63);
        at.write_dy(0, d_T_hat_1_d_T);
        let t64 = Phi * t63;
        let d_T_hat_1_d_x = Phi * t51 + u40 * t63;
        at.write_dy(2, d_T_hat_1_d_x);
        let t65 = t3 * t63;
        let d_E_hat_1_d_x = -(u32 * (x * t) + t3 * t51 + omega * t65);
        at.write_dy(25, d_E_hat_1_d_x);
        let d_T_hat_1_d_sigma = -(u41 * (r * t63));
        at.write_dc(1, d_T_hat_1_d_sigma);
        let d_E_hat_1_d_sigma = t1 * t65;
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t66 = Phi * t62;
        let t67 = t3 * t62;
        let t68 = Real::splat(1.0) + tan_theta * tan_theta;
        let d_theta_hat_1_d_theta = t13 * t60 - t8 * (t68 * t46) - v_r * t61;
        at.write_dy(4, d_theta_hat_1_d_theta);
        let t69 = t68 * (q * t35);
        let d_E_hat_1_d_theta = v_r * t65 - (t69 * t3 + t13 * t67);
        at.write_dy(24, d_E_hat_1_d_theta);
        let d_T_hat_1_d_theta = Phi * t69 + t13 * t66 - v_r * t64;
        at.write_dy(1, d_T_hat_1_d_theta);
        let d_x_hat_1_d_theta = -(t68 * (Phi * r));
        at.write_dy(6, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(7, d_x_hat_1_d_x);
        let arc = r * t48;
        let t70 = u35 * (arc * t36) + u36 * (arc * t44);
        let t71 = u35 * (arc * (v_r * p)) - u14 * t32 * t70;
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let t72 = u36 * (arc * (v_t * p));
        let t73 = u35 * (arc * (f_r * p)) + t42 * t71 + t72 * t40;
        let t74 = u36 * (arc * (f_t * p)) + t27 * t71 + t72 * t43;
        let d_W_hat_1_d_x = u11 * t28 * t70 - t48 * t45 + omega * t74;
        at.write_dy(18, d_W_hat_1_d_x);
        let t75 = arc * f_t;
        let t76 = u39 * (t75 * t33);
        let d_M_hat_1_d_Phi = q * t75;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(3, M_hat_1);
        let t77 = Phi * (arc * q);
        let t78 = t77 * t40 - t42 * t76;
        let t79 = t77 * t43 - t27 * t76;
        let d_M_hat_1_d_x = Phi * t75 * t30 - t48 * t47 + omega * t79;
        at.write_dy(10, d_M_hat_1_d_x);
        let d_M_hat_1_d_sigma = -(t1 * t79);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_W_hat_1_d_sigma = -(t1 * t74);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(4, A_hat_1);
        let t80 = r * A_hat_1;
        let d_L_o_hat_1_d_Phi = arc * (EA * t10);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(5, L_o_hat_1);
        let t81 = arc * (u22 * (t10 * t10));
        let d_L_o_hat_1_d_flow = -(u17 * ((u20 * t9 + u21) * (u31 * t81)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_T = -(u33 * t81);
        at.write_dy(13, d_L_o_hat_1_d_T);
        let d_A_hat_1_d_x = u26 * arc - t48 * t4;
        at.write_dy(12, d_A_hat_1_d_x);
        let t82 = t48 * t48 * (r * sin_theta);
        let d_M_hat_1_d_theta = t82 * t47 + t13 * t78 - v_r * t79;
        let d_W_hat_1_d_theta = t82 * t45 + t13 * t73 - v_r * t74;
        at.write_dy(17, d_W_hat_1_d_theta);
        at.write_dy(9, d_M_hat_1_d_theta);
        let d_A_hat_1_d_theta = t82 * t4;
        at.write_dy(11, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t82 * t11;
        at.write_dy(14, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t48 * t11);
        at.write_dy(15, d_L_o_hat_1_d_x);
        let t83 = V_T * sin_theta;
        let t84 = sin_theta * t6;
        let t85 = cos_theta * t6;
        let d_T_hat_1_d_flow = t84 * t66 + t85 * t64;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_E_hat_1_d_flow = -(u34 * t50 + t84 * t67 + t85 * t65);
        at.write_dc(20, d_E_hat_1_d_flow);
        let t86 = V_T * cos_theta;
        let d_theta_hat_1_d_T = Phi * (t7 - t53 * (t7 * t7)) + t83 * t60 + t86 * t61;
        at.write_dy(3, d_theta_hat_1_d_T);
        let d_E_hat_1_d_T = -(t83 * t67 + t86 * t65);
        at.write_dy(23, d_E_hat_1_d_T);
        let d_theta_hat_1_d_flow = t84 * t60 + t85 * t61;
        at.write_dc(5, d_theta_hat_1_d_flow);
        let d_M_hat_1_d_T = t83 * t78 + t86 * t79;
        at.write_dy(8, d_M_hat_1_d_T);
        let d_W_hat_1_d_T = t83 * t73 + t86 * t74;
        at.write_dy(16, d_W_hat_1_d_T);
        let d_M_hat_1_d_flow = t84 * t78 + t85 * t79;
        let d_W_hat_1_d_flow = t84 * t73 + t85 * t74;
        at.write_dc(15, d_W_hat_1_d_flow);
        at.write_dc(9, d_M_hat_1_d_flow);
        let s = at.position::<Real>();
        let t87 = Phi * s;
        let t88 = A_hat_1 * (s * r);
        let (sin_t87, cos_t87) = sin_cos(t87);
        let A_x_hat_1 = cos_t87 * t80;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t80 * sin_t87;
        at.write_f(8, A_y_hat_1);
        let t90 = r * cos_t87;
        let t91 = r * sin_t87;
        let d_A_y_hat_1_d_theta = t91 * d_A_hat_1_d_theta;
        at.write_dy(21, d_A_y_hat_1_d_theta);
        let d_A_x_hat_1_d_theta = t90 * d_A_hat_1_d_theta;
        at.write_dy(19, d_A_x_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t91 * d_A_hat_1_d_x - A_hat_1 * sin_t87;
        at.write_dy(22, d_A_y_hat_1_d_x);
        let d_A_x_hat_1_d_x = t90 * d_A_hat_1_d_x - A_hat_1 * cos_t87;
        at.write_dy(20, d_A_x_hat_1_d_x);
        let d_A_y_hat_1_d_Phi = cos_t87 * t88 + d_A_hat_1_d_Phi * t91;
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t90 - sin_t87 * t88;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        at.write_dc(17, d_A_y_hat_1_d_Phi);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 161 add, 409 mul, 6 div, 2 sqrt, 3 fn a point; 91 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 3;
    const CONSTANTS: usize = 13;
    const F: usize = 10;
    const DY: usize = 26;
    const DC: usize = 78;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 66];
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
        let R_P = constants[8];
        let flow = constants[2];
        let u2 = flow * m_o;
        let u3 = R_P * u2;
        let G = omega_P * u3;
        let u4 = G * G;
        let u5 = EA * m_o;
        let u6 = reciprocal(u5 - u4);
        let u7 = EA * u6;
        let V_T = G * u6;
        let omega = sigma * omega_P;
        let u8 = sin_beta * sin_beta;
        let u9 = reciprocal(cos_beta);
        let u10 = u9 * u9;
        let u11 = u8 * u10;
        let v_thr = constants[11];
        let u12 = reciprocal(v_thr);
        let u13 = u12 * 4.0;
        let u14 = sin_beta * u9;
        let k = constants[5];
        let u15 = k * 0.5;
        let u16 = reciprocal(EA);
        let u17 = u10 * 2.0;
        let u18 = u9 * (k * sin_beta);
        let u19 = 0.5 * u18;
        let u20 = Phi * u19;
        let u21 = V_T * u20;
        let u22 = omega_P * u2;
        let u23 = omega_P * (m_o * R_P);
        let u24 = omega_P * (flow * R_P);
        let u25 = u6 * u6;
        let u26 = u5 * u25;
        let u27 = EA * G;
        let u28 = u25 * (2.0 * u27);
        let u29 = 2.0 * (u6 * u27);
        let u30 = EA * EA;
        let u31 = u25 * u30;
        let u32 = u25 * (m_o * G);
        let u33 = u25 * (u4 * 2.0);
        let u34 = u25 * u27;
        let u35 = u14 * 2.0;
        let u36 = u9 * u10;
        let u37 = u36 * (2.0 * (sin_beta * u8));
        let u38 = 0.5 * (u11 * 2.0);
        let u39 = u15 * 2.0;
        let u40 = u16 * u16;
        let u41 = Phi * u15;
        let u42 = Phi * EA;
        let u43 = 0.5 * (u10 * (k * u8));
        let u44 = V_T * u19;
        let u45 = Phi * V_T;
        let u46 = u18 * u45;
        let u47 = u14 * 0.5 * u45;
        let u48 = u20 * u32;
        let u49 = u20 * u34;
        let u50 = u20 * (u6 + u33);
        let u51 = Phi * 2.0;
        let u52 = Phi * (u36 * (sin_beta * 4.0));
        let u53 = Phi * u17;
        let u54 = Phi * 0.5;
        let u55 = Phi * u16;
        let u56 = Phi * u44;
        let u57 = Phi * cos_beta;
        let u58 = cos_beta * u56;
        let u59 = 2.0 * u56;
        let u60 = Phi * (cos_beta * 2.0);
        let u61 = Phi * u39;
        let u62 = u15 * u51;
        let u63 = 0.5 * u51;
        let u64 = u19 * u51;
        let u65 = mu_k * 4.0;
        let u66 = u12 * u12 * u65;
        let u67 = u12 * u65;
        let u68 = u5 * u6 * u55;
        [
            Phi,
            sigma,
            EA,
            m_o,
            R,
            mu_k,
            omega_P,
            cos_beta,
            u3,
            u4,
            u6,
            u7,
            V_T,
            omega,
            sin_beta,
            u11,
            u13,
            u14,
            u15,
            u16,
            u17,
            u19,
            u21,
            u22,
            u23,
            u24,
            u26,
            u28,
            u29,
            u30,
            u31,
            u32,
            u33,
            u34,
            u35,
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
            u66,
            u67,
            u68,
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
        let u3 = Real::splat(uniforms[8]);
        let u4 = Real::splat(uniforms[9]);
        let u6 = Real::splat(uniforms[10]);
        let u7 = Real::splat(uniforms[11]);
        let V_T = Real::splat(uniforms[12]);
        let omega = Real::splat(uniforms[13]);
        let sin_beta = Real::splat(uniforms[14]);
        let u11 = Real::splat(uniforms[15]);
        let u13 = Real::splat(uniforms[16]);
        let u14 = Real::splat(uniforms[17]);
        let u15 = Real::splat(uniforms[18]);
        let u16 = Real::splat(uniforms[19]);
        let u17 = Real::splat(uniforms[20]);
        let u19 = Real::splat(uniforms[21]);
        let u21 = Real::splat(uniforms[22]);
        let u22 = Real::splat(uniforms[23]);
        let u23 = Real::splat(uniforms[24]);
        let u24 = Real::splat(uniforms[25]);
        let u26 = Real::splat(uniforms[26]);
        let u28 = Real::splat(uniforms[27]);
        let u29 = Real::splat(uniforms[28]);
        let u30 = Real::splat(uniforms[29]);
        let u31 = Real::splat(uniforms[30]);
        let u32 = Real::splat(uniforms[31]);
        let u33 = Real::splat(uniforms[32]);
        let u34 = Real::splat(uniforms[33]);
        let u35 = Real::splat(uniforms[34]);
        let u37 = Real::splat(uniforms[35]);
        let u38 = Real::splat(uniforms[36]);
        let u39 = Real::splat(uniforms[37]);
        let u40 = Real::splat(uniforms[38]);
        let u41 = Real::splat(uniforms[39]);
        let u42 = Real::splat(uniforms[40]);
        let u43 = Real::splat(uniforms[41]);
        let u44 = Real::splat(uniforms[42]);
        let u45 = Real::splat(uniforms[43]);
        let u46 = Real::splat(uniforms[44]);
        let u47 = Real::splat(uniforms[45]);
        let u48 = Real::splat(uniforms[46]);
        let u49 = Real::splat(uniforms[47]);
        let u50 = Real::splat(uniforms[48]);
        let u51 = Real::splat(uniforms[49]);
        let u52 = Real::splat(uniforms[50]);
        let u53 = Real::splat(uniforms[51]);
        let u54 = Real::splat(uniforms[52]);
        let u55 = Real::splat(uniforms[53]);
        let u56 = Real::splat(uniforms[54]);
        let u57 = Real::splat(uniforms[55]);
        let u58 = Real::splat(uniforms[56]);
        let u59 = Real::splat(uniforms[57]);
        let u60 = Real::splat(uniforms[58]);
        let u61 = Real::splat(uniforms[59]);
        let u62 = Real::splat(uniforms[60]);
        let u63 = Real::splat(uniforms[61]);
        let u64 = Real::splat(uniforms[62]);
        let u66 = Real::splat(uniforms[63]);
        let u67 = Real::splat(uniforms[64]);
        let u68 = Real::splat(uniforms[65]);
        let x = at.state::<Real>(2);
        let r = R - x;
        let t1 = Real::splat(2.0) * r;
        let axial = u15 * x;
        let t2 = x * x;
        let t3 = u56 * t2;
        let t4 = u41 * x;
        let t5 = Real::splat(0.5) * x;
        let T = at.state::<Real>(0);
        let t6 = T + EA;
        let V = V_T * t6;
        let t7 = u6 * t6 + u33 * t6;
        let t8 = V_T - u32 * t6;
        let t9 = u34 * t6;
        let t10 = reciprocal(T);
        let t11 = Phi * t10;
        let t12 = u4 + m_o * T;
        let F = u7 * t12;
        let t13 = EA + F;
        let t14 = reciprocal(t13);
        let t15 = u42 * t14;
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t17 = cos_theta * V;
        let v_t = t17 - omega * r;
        let t18 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t18));
        let face_speed = sqrt(u11 * t18 + speed * speed);
        let t19 = reciprocal(face_speed);
        let t20 = Real::splat(0.5) * t19 * (u35 * t18 + u37 * t18);
        let t21 = v_t * t19;
        let t22 = v_r * t19;
        let t23 = u38 * t22;
        let t24 = speed * t19;
        let t25 = t19 * t19;
        let saturation = tanh(u13 * speed);
        let mu = mu_k * saturation;
        let t26 = v_r * mu;
        let f_r = t19 * t26;
        let t27 = t26 * t25;
        let t28 = reciprocal(cos_beta + u14 * f_r);
        let t29 = x * t28;
        let p = u15 * t29;
        let t30 = r * p;
        let q = Real::splat(2.0) * t30;
        let t31 = u51 * t30;
        let t32 = t30 * t10;
        let t33 = u59 * (t30 * t2);
        let t34 = u39 * t29;
        let t35 = Real::splat(0.5) * t29;
        let t36 = x * (t28 * t28);
        let t37 = u19 * t36;
        let t38 = u15 * t28;
        let t39 = f_r - sin_beta;
        let t40 = q * t39;
        let t41 = (t39 + u11 * f_r) * t36;
        let t42 = u15 * t41;
        let t43 = v_r * f_r;
        let t44 = p * t43;
        let loss_radial = u17 * t44;
        let t45 = v_t * mu;
        let t46 = t45 * t25;
        let f_t = t19 * t45;
        let t47 = mu * t19;
        let t48 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t48);
        let loss = loss_radial + loss_tangential;
        let t49 = Phi * loss;
        let t50 = f_t * q;
        let t51 = Phi * t50;
        let t52 = Real::splat(1.0) - saturation * saturation;
        let t53 = reciprocal(speed);
        let t54 = v_t * t53;
        let t55 = v_r * t53;
        let t56 = reciprocal(cos_theta);
        let tan_theta = t56 * sin_theta;
        let t57 = f_t + tan_theta * t39;
        let t = q * t57;
        at.write_dc(0, t);
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let t58 = t * t2;
        let E_hat_1 = -(u21 * t58);
        at.write_f(9, E_hat_1);
        let d_E_hat_1_d_Phi = -(t * (u44 * t2));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t59 = r * t57;
        let d_T_hat_1_d_k = u63 * (t29 * t59);
        at.write_dc(22, d_T_hat_1_d_k);
        let t60 = u61 * (t29 * t57);
        let t61 = t57 * t3;
        let t62 = t1 * t61;
        let t63 = t34 * t61;
        let d_E_hat_1_d_k = -(u47 * t58 + t35 * t62);
        at.write_dc(70, d_E_hat_1_d_k);
        let t64 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t64;
        let t65 = T - n;
        let t66 = t64 * t11;
        let t67 = t1 * t66;
        let t68 = t34 * t66;
        let t69 = u51 * t32 + t37 * t67;
        let d_theta_hat_1_d_k = -(t35 * t67);
        at.write_dc(31, d_theta_hat_1_d_k);
        let theta_1 = t10 * t65;
        at.write_dc(3, theta_1);
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let t70 = r * tan_theta;
        let x_hat_1 = -(Phi * t70);
        at.write_f(2, x_hat_1);
        let d_x_hat_1_d_Phi = -t70;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t71 = tan_theta * q;
        let t72 = u58 * (t2 * t71) - (u15 * t2 + u43 * t2) * (u45 * t) + t42 * t62;
        let t73 = Phi * t71 - u64 * (t36 * t59);
        let t74 = t21 * t31 + t22 * t73;
        let t75 = t52 * t74;
        let d_T_hat_1_d_mu_k = saturation * t74;
        at.write_dc(27, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(u66 * (speed * t75));
        at.write_dc(28, d_T_hat_1_d_v_thr);
        let t76 = t46 * t31 + t27 * t73;
        let t77 = u67 * t75 - t24 * t76;
        let t78 = t47 * t31 + t54 * t77;
        let t79 = t47 * t73 - t23 * t76 + t55 * t77;
        let d_T_hat_1_d_beta = -(u57 * t71 + u62 * (t41 * t59) + t20 * t76);
        at.write_dc(26, d_T_hat_1_d_beta);
        let t80 = cos_theta * t78 + sin_theta * t79;
        let d_T_hat_1_d_T = V_T * t80;
        at.write_dy(0, d_T_hat_1_d_T);
        let t81 = t7 * t80;
        let d_T_hat_1_d_flow = u23 * t81;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_T_hat_1_d_m_o = u24 * t81 - t9 * t80;
        at.write_dc(23, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_EA = t8 * t80;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_R_P = u22 * t81;
        at.write_dc(25, d_T_hat_1_d_R_P);
        let t82 = omega * t78;
        let d_T_hat_1_d_x = u62 * (t28 * t59) + t82 - t60;
        at.write_dy(2, d_T_hat_1_d_x);
        let d_T_hat_1_d_R = t60 - t82;
        at.write_dc(24, d_T_hat_1_d_R);
        let t83 = r * t78;
        let d_T_hat_1_d_omega_P = u3 * t81 - sigma * t83;
        at.write_dc(29, d_T_hat_1_d_omega_P);
        let d_T_hat_1_d_sigma = -(omega_P * t83);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t84 = t71 * t11;
        let t85 = t37 * t62 - t71 * t3;
        let t86 = t46 * t33 - t27 * t85;
        let d_E_hat_1_d_beta = t72 + t20 * t86;
        at.write_dc(74, d_E_hat_1_d_beta);
        let t87 = t22 * t85 - t21 * t33;
        let t88 = t52 * t87;
        let d_E_hat_1_d_mu_k = saturation * t87;
        at.write_dc(75, d_E_hat_1_d_mu_k);
        let t89 = t24 * t86 + u67 * t88;
        let t90 = t47 * t85 + t23 * t86 + t55 * t89;
        let t91 = t54 * t89 - t47 * t33;
        let d_E_hat_1_d_v_thr = -(u66 * (speed * t88));
        at.write_dc(76, d_E_hat_1_d_v_thr);
        let t92 = cos_theta * t91 + sin_theta * t90;
        let d_E_hat_1_d_T = V_T * t92;
        at.write_dy(23, d_E_hat_1_d_T);
        let t93 = t7 * t92 - u50 * t58;
        let d_E_hat_1_d_flow = u23 * t93;
        at.write_dc(20, d_E_hat_1_d_flow);
        let d_E_hat_1_d_m_o = u49 * t58 - t9 * t92 + u24 * t93;
        at.write_dc(71, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_EA = u48 * t58 + t8 * t92;
        at.write_dc(69, d_E_hat_1_d_EA);
        let d_E_hat_1_d_R_P = u22 * t93;
        at.write_dc(73, d_E_hat_1_d_R_P);
        let t94 = omega * t91;
        let d_E_hat_1_d_x = t63 + (t94 - (u46 * (x * t) + t38 * t62));
        at.write_dy(25, d_E_hat_1_d_x);
        let d_E_hat_1_d_R = -(t63 + t94);
        at.write_dc(72, d_E_hat_1_d_R);
        let t95 = r * t91;
        let d_E_hat_1_d_omega_P = u3 * t93 - sigma * t95;
        at.write_dc(77, d_E_hat_1_d_omega_P);
        let d_E_hat_1_d_sigma = -(omega_P * t95);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t96 = t46 * t84 - t27 * t69;
        let d_theta_hat_1_d_beta = t42 * t67 - u60 * t32 + t20 * t96;
        at.write_dc(35, d_theta_hat_1_d_beta);
        let t97 = t22 * t69 - t21 * t84;
        let t98 = t52 * t97;
        let d_theta_hat_1_d_mu_k = saturation * t97;
        at.write_dc(36, d_theta_hat_1_d_mu_k);
        let t99 = t24 * t96 + u67 * t98;
        let t100 = t47 * t69 + t23 * t96 + t55 * t99;
        let t101 = t54 * t99 - t47 * t84;
        let d_theta_hat_1_d_v_thr = -(u66 * (speed * t98));
        at.write_dc(37, d_theta_hat_1_d_v_thr);
        let t102 = cos_theta * t101 + sin_theta * t100;
        let d_theta_hat_1_d_T = Phi * (t10 - t65 * (t10 * t10)) + V_T * t102;
        at.write_dy(3, d_theta_hat_1_d_T);
        let t103 = t7 * t102;
        let d_theta_hat_1_d_flow = u23 * t103;
        at.write_dc(5, d_theta_hat_1_d_flow);
        let d_theta_hat_1_d_m_o = u24 * t103 - t9 * t102;
        at.write_dc(32, d_theta_hat_1_d_m_o);
        let d_theta_hat_1_d_EA = t8 * t102;
        at.write_dc(30, d_theta_hat_1_d_EA);
        let d_theta_hat_1_d_R_P = u22 * t103;
        at.write_dc(34, d_theta_hat_1_d_R_P);
        let t104 = omega * t101;
        let d_theta_hat_1_d_x = t68 + (t104 - t38 * t67);
        at.write_dy(5, d_theta_hat_1_d_x);
        let d_theta_hat_1_d_R = -(t68 + t104);
        at.write_dc(33, d_theta_hat_1_d_R);
        let t105 = r * t101;
        let d_theta_hat_1_d_omega_P = u3 * t103 - sigma * t105;
        at.write_dc(38, d_theta_hat_1_d_omega_P);
        let d_theta_hat_1_d_sigma = -(omega_P * t105);
        at.write_dc(4, d_theta_hat_1_d_sigma);
        let t106 = Real::splat(1.0) + tan_theta * tan_theta;
        let d_theta_hat_1_d_theta = t17 * t100 - v_r * t101 - t106 * (t50 * t11);
        let d_E_hat_1_d_theta = t17 * t90 - v_r * t91 - t106 * (t40 * t3);
        let d_T_hat_1_d_theta = t17 * t79 - v_r * t78 + t106 * (Phi * t40);
        at.write_dy(1, d_T_hat_1_d_theta);
        at.write_dy(24, d_E_hat_1_d_theta);
        at.write_dy(4, d_theta_hat_1_d_theta);
        let d_x_hat_1_d_theta = -(t106 * (Phi * r));
        at.write_dy(6, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(7, d_x_hat_1_d_x);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(39, d_x_hat_1_d_R);
        let arc = r * t56;
        let t107 = u51 * (arc * t48) + u53 * (arc * t43);
        let t108 = u53 * (arc * (v_r * p)) - t37 * t107;
        let d_W_hat_1_d_k = t35 * t107;
        at.write_dc(57, d_W_hat_1_d_k);
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let t109 = u51 * (arc * (v_t * p));
        let d_A_hat_1_d_k = u54 * (x * arc);
        at.write_dc(49, d_A_hat_1_d_k);
        let t110 = t21 * t109 + t22 * t108;
        let t111 = t52 * t110;
        let d_W_hat_1_d_mu_k = saturation * t110;
        at.write_dc(62, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(u66 * (speed * t111));
        at.write_dc(63, d_W_hat_1_d_v_thr);
        let t112 = t46 * t109 + t27 * t108;
        let d_W_hat_1_d_beta = u52 * (arc * t44) - t42 * t107 - t20 * t112;
        at.write_dc(61, d_W_hat_1_d_beta);
        let t113 = u67 * t111 - t24 * t112;
        let t114 = u53 * (arc * (f_r * p)) + t47 * t108 - t23 * t112 + t55 * t113;
        let t115 = u51 * (arc * (f_t * p)) + t47 * t109 + t54 * t113;
        let t116 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t116;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(3, M_hat_1);
        let t117 = Phi * (arc * q);
        let t118 = r * t116;
        let t119 = u64 * (t36 * t118);
        let t120 = t27 * t119 - t46 * t117;
        let d_M_hat_1_d_beta = t20 * t120 - u62 * (t41 * t118);
        at.write_dc(45, d_M_hat_1_d_beta);
        let t121 = t21 * t117 - t22 * t119;
        let t122 = t52 * t121;
        let d_M_hat_1_d_mu_k = saturation * t121;
        at.write_dc(46, d_M_hat_1_d_mu_k);
        let t123 = t24 * t120 + u67 * t122;
        let t124 = t23 * t120 - t47 * t119 + t55 * t123;
        let t125 = t47 * t117 + t54 * t123;
        let d_M_hat_1_d_v_thr = -(u66 * (speed * t122));
        at.write_dc(47, d_M_hat_1_d_v_thr);
        let t126 = u61 * (t29 * t116);
        let d_M_hat_1_d_k = u63 * (t29 * t118);
        at.write_dc(41, d_M_hat_1_d_k);
        let t127 = cos_theta * t125 + sin_theta * t124;
        let t128 = cos_theta * t115 + sin_theta * t114;
        let t129 = t56 * t56 * (r * sin_theta);
        let d_M_hat_1_d_theta = t17 * t124 - v_r * t125 + t129 * t51;
        let d_W_hat_1_d_theta = t17 * t114 - v_r * t115 + t129 * t49;
        at.write_dy(17, d_W_hat_1_d_theta);
        at.write_dy(9, d_M_hat_1_d_theta);
        let t130 = t56 * t51;
        let t131 = t56 * t49;
        let d_A_hat_1_d_theta = t129 * t4;
        at.write_dy(11, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t129 * t15;
        at.write_dy(14, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t56 * t15;
        at.write_dc(53, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(15, d_L_o_hat_1_d_x);
        let d_W_hat_1_d_T = V_T * t128;
        at.write_dy(16, d_W_hat_1_d_T);
        let t132 = t7 * t128;
        let t133 = t7 * t127;
        let d_M_hat_1_d_flow = u23 * t133;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_M_hat_1_d_m_o = u24 * t133 - t9 * t127;
        at.write_dc(42, d_M_hat_1_d_m_o);
        let d_W_hat_1_d_m_o = u24 * t132 - t9 * t128;
        at.write_dc(58, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_EA = t8 * t128;
        at.write_dc(56, d_W_hat_1_d_EA);
        let d_M_hat_1_d_EA = t8 * t127;
        at.write_dc(40, d_M_hat_1_d_EA);
        let d_M_hat_1_d_T = V_T * t127;
        at.write_dy(8, d_M_hat_1_d_T);
        let d_M_hat_1_d_R_P = u22 * t133;
        at.write_dc(44, d_M_hat_1_d_R_P);
        let d_W_hat_1_d_flow = u23 * t132;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_W_hat_1_d_R_P = u22 * t132;
        at.write_dc(60, d_W_hat_1_d_R_P);
        let t134 = omega * t125;
        let d_M_hat_1_d_x = u62 * (t28 * t118) + t134 - t130 - t126;
        let d_M_hat_1_d_R = t126 + (t130 - t134);
        at.write_dc(43, d_M_hat_1_d_R);
        at.write_dy(10, d_M_hat_1_d_x);
        let t135 = r * t125;
        let d_M_hat_1_d_omega_P = u3 * t133 - sigma * t135;
        at.write_dc(48, d_M_hat_1_d_omega_P);
        let d_M_hat_1_d_sigma = -(omega_P * t135);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t136 = omega * t115;
        let d_W_hat_1_d_x = t38 * t107 + t136 - t131;
        at.write_dy(18, d_W_hat_1_d_x);
        let d_W_hat_1_d_R = t131 - t136;
        at.write_dc(59, d_W_hat_1_d_R);
        let t137 = r * t115;
        let d_W_hat_1_d_omega_P = u3 * t132 - sigma * t137;
        at.write_dc(64, d_W_hat_1_d_omega_P);
        let d_W_hat_1_d_sigma = -(omega_P * t137);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(4, A_hat_1);
        let t138 = r * A_hat_1;
        let d_L_o_hat_1_d_Phi = arc * (EA * t14);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(5, L_o_hat_1);
        let t139 = arc * (u30 * (t14 * t14));
        let d_L_o_hat_1_d_T = -(u68 * t139);
        at.write_dy(13, d_L_o_hat_1_d_T);
        let t140 = u55 * t139;
        let t141 = (u16 - u40 * t13) * (Phi * t139) + (u6 * t12 - u26 * t12) * t140;
        let d_L_o_hat_1_d_EA = -t141;
        at.write_dc(51, d_L_o_hat_1_d_EA);
        let t142 = (u28 * t12 + u29) * t140;
        let d_L_o_hat_1_d_m_o = -((u7 * T - u31 * t12) * t140 + u24 * t142);
        at.write_dc(52, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_flow = -(u23 * t142);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u22 * t142);
        at.write_dc(54, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u3 * t142);
        at.write_dc(55, d_L_o_hat_1_d_omega_P);
        let t143 = Phi * arc;
        let d_A_hat_1_d_R = t56 * t4;
        let d_A_hat_1_d_x = u41 * arc - d_A_hat_1_d_R;
        at.write_dy(12, d_A_hat_1_d_x);
        at.write_dc(50, d_A_hat_1_d_R);
        let s = at.position::<Real>();
        let t144 = Phi * s;
        let t145 = A_hat_1 * (s * r);
        let (sin_t144, cos_t144) = sin_cos(t144);
        let A_x_hat_1 = cos_t144 * t138;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t138 * sin_t144;
        at.write_f(8, A_y_hat_1);
        let t147 = r * cos_t144;
        let t148 = r * sin_t144;
        let t149 = t4 * t148;
        let t150 = t4 * t147;
        let d_A_x_hat_1_d_theta = t129 * t150;
        at.write_dy(19, d_A_x_hat_1_d_theta);
        let t151 = t56 * t150;
        let d_A_y_hat_1_d_theta = t129 * t149;
        at.write_dy(21, d_A_y_hat_1_d_theta);
        let t152 = t56 * t149;
        let t153 = t143 * t148;
        let d_A_y_hat_1_d_Phi = cos_t144 * t145 + d_A_hat_1_d_Phi * t148;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t147 - sin_t144 * t145;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let t154 = t143 * t147;
        let t155 = A_hat_1 * cos_t144;
        let t156 = A_hat_1 * sin_t144;
        let d_A_y_hat_1_d_x = u15 * t153 - t152 - t156;
        at.write_dy(22, d_A_y_hat_1_d_x);
        let d_A_y_hat_1_d_R = t156 + t152;
        at.write_dc(68, d_A_y_hat_1_d_R);
        let d_A_y_hat_1_d_k = t5 * t153;
        at.write_dc(67, d_A_y_hat_1_d_k);
        let d_A_x_hat_1_d_k = t5 * t154;
        at.write_dc(65, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_x = u15 * t154 - t151 - t155;
        at.write_dy(20, d_A_x_hat_1_d_x);
        let d_A_x_hat_1_d_R = t155 + t151;
        at.write_dc(66, d_A_x_hat_1_d_R);
    }
}
/// Derived fields.
///
/// 10 add, 29 mul, 3 div, 2 sqrt, 4 fn a point; 20 once.
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 3;
    const CONSTANTS: usize = 13;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 16;
    const WIDE: bool = false;
    type Uniforms = [f64; 14];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[3];
        let m_o = constants[6];
        let R = constants[7];
        let mu_k = constants[10];
        let beta = constants[9];
        let (sin_beta, cos_beta) = sin_cos(beta);
        let omega_P = constants[12];
        let R_P = constants[8];
        let flow = constants[2];
        let G = omega_P * (R_P * (flow * m_o));
        let u2 = G * G;
        let u3 = reciprocal(EA * m_o - u2);
        let u4 = EA * u3;
        let V_T = G * u3;
        let sigma = constants[1];
        let omega = sigma * omega_P;
        let u5 = reciprocal(cos_beta);
        let u6 = u5 * u5;
        let u7 = sin_beta * sin_beta * u6;
        let v_thr = constants[11];
        let u8 = reciprocal(v_thr) * 4.0;
        let u9 = sin_beta * u5;
        let k = constants[5];
        let u10 = k * 0.5;
        let u11 = u6 * 2.0;
        [EA, m_o, R, mu_k, cos_beta, u2, u4, V_T, omega, u7, u8, u9, u10, u11]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let R = Real::splat(uniforms[2]);
        let mu_k = Real::splat(uniforms[3]);
        let cos_beta = Real::splat(uniforms[4]);
        let u2 = Real::splat(uniforms[5]);
        let u4 = Real::splat(uniforms[6]);
        let V_T = Real::splat(uniforms[7]);
        let omega = Real::splat(uniforms[8]);
        let u7 = Real::splat(uniforms[9]);
        let u8 = Real::splat(uniforms[10]);
        let u9 = Real::splat(uniforms[11]);
        let u10 = Real::splat(uniforms[12]);
        let u11 = Real::splat(uniforms[13]);
        at.write_field(9, Real::splat(0.0));
        at.write_field(10, Real::splat(0.0));
        let T = at.state::<Real>(0);
        let F = u4 * (u2 + m_o * T);
        at.write_field(0, F);
        let V = V_T * (T + EA);
        at.write_field(1, V);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        at.write_field(2, v_r);
        let t2 = v_r * v_r;
        let x = at.state::<Real>(2);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        let arc = r * reciprocal(cos_theta);
        at.write_field(3, v_t);
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        at.write_field(4, speed);
        let face_speed = sqrt(u7 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let beta_s = angle(speed, u9 * v_r);
        at.write_field(8, beta_s);
        let f_r = t3 * (v_r * mu);
        let f_t = t3 * (v_t * mu);
        let p = u10 * (x * reciprocal(cos_beta + u9 * f_r));
        at.write_field(7, p);
        let loss_radial = u11 * (p * (v_r * f_r));
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
        let axial = u10 * x;
        at.write_field(11, axial);
    }
}
