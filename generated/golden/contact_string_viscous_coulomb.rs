// contact_string_viscous_coulomb: The belt in a groove, without bending stiffness: viscous-coulomb friction.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 18 add, 56 mul, 5 div, 2 sqrt, 2 fn a point; 24 once
//   jacobian: 92 add, 251 mul, 6 div, 2 sqrt, 2 fn a point; 58 once
//   full: 162 add, 409 mul, 6 div, 2 sqrt, 2 fn a point; 87 once
//   fields: 11 add, 29 mul, 3 div, 2 sqrt, 3 fn a point; 19 once
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
// - saturation (typed in): Fig. 3.6
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

///The belt in a groove, without bending stiffness: viscous-coulomb friction.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "contact_string_viscous_coulomb",
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
/// 18 add, 56 mul, 5 div, 2 sqrt, 2 fn a point; 24 once.
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
        let u8 = reciprocal(v_thr);
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
        let slip = u8 * speed;
        let saturation = saturate(slip);
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
/// 92 add, 251 mul, 6 div, 2 sqrt, 2 fn a point; 58 once.
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
        let u9 = reciprocal(v_thr);
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
        let slip = u9 * speed;
        let t20 = reciprocal(speed);
        let t21 = v_r * t20;
        let t22 = v_t * t20;
        let saturation = saturate(slip);
        let mu = mu_k * saturation;
        let t23 = u30 * below_one(slip);
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
/// 162 add, 409 mul, 6 div, 2 sqrt, 2 fn a point; 87 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 3;
    const CONSTANTS: usize = 13;
    const F: usize = 10;
    const DY: usize = 26;
    const DC: usize = 78;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 65];
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
        let u13 = sin_beta * u9;
        let k = constants[5];
        let u14 = k * 0.5;
        let u15 = reciprocal(EA);
        let u16 = u10 * 2.0;
        let u17 = u9 * (k * sin_beta);
        let u18 = 0.5 * u17;
        let u19 = Phi * u18;
        let u20 = V_T * u19;
        let u21 = omega_P * u2;
        let u22 = omega_P * (m_o * R_P);
        let u23 = omega_P * (flow * R_P);
        let u24 = u6 * u6;
        let u25 = u5 * u24;
        let u26 = EA * G;
        let u27 = u24 * (2.0 * u26);
        let u28 = 2.0 * (u6 * u26);
        let u29 = EA * EA;
        let u30 = u24 * u29;
        let u31 = u24 * (m_o * G);
        let u32 = u24 * (u4 * 2.0);
        let u33 = u24 * u26;
        let u34 = u12 * u12;
        let u35 = u13 * 2.0;
        let u36 = u9 * u10;
        let u37 = u36 * (2.0 * (sin_beta * u8));
        let u38 = 0.5 * (u11 * 2.0);
        let u39 = u14 * 2.0;
        let u40 = u15 * u15;
        let u41 = Phi * u14;
        let u42 = Phi * EA;
        let u43 = 0.5 * (u10 * (k * u8));
        let u44 = V_T * u18;
        let u45 = Phi * V_T;
        let u46 = u17 * u45;
        let u47 = u13 * 0.5 * u45;
        let u48 = u19 * u31;
        let u49 = u19 * u33;
        let u50 = u19 * (u6 + u32);
        let u51 = Phi * 2.0;
        let u52 = Phi * (4.0 * (sin_beta * u36));
        let u53 = Phi * u16;
        let u54 = Phi * 0.5;
        let u55 = Phi * u15;
        let u56 = Phi * u44;
        let u57 = Phi * cos_beta;
        let u58 = cos_beta * u56;
        let u59 = 2.0 * u56;
        let u60 = Phi * (cos_beta * 2.0);
        let u61 = Phi * u39;
        let u62 = u14 * u51;
        let u63 = 0.5 * u51;
        let u64 = u18 * u51;
        let u65 = u5 * u6 * u55;
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
            u12,
            u13,
            u14,
            u15,
            u16,
            u18,
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
            u65,
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
        let u12 = Real::splat(uniforms[16]);
        let u13 = Real::splat(uniforms[17]);
        let u14 = Real::splat(uniforms[18]);
        let u15 = Real::splat(uniforms[19]);
        let u16 = Real::splat(uniforms[20]);
        let u18 = Real::splat(uniforms[21]);
        let u20 = Real::splat(uniforms[22]);
        let u21 = Real::splat(uniforms[23]);
        let u22 = Real::splat(uniforms[24]);
        let u23 = Real::splat(uniforms[25]);
        let u25 = Real::splat(uniforms[26]);
        let u27 = Real::splat(uniforms[27]);
        let u28 = Real::splat(uniforms[28]);
        let u29 = Real::splat(uniforms[29]);
        let u30 = Real::splat(uniforms[30]);
        let u31 = Real::splat(uniforms[31]);
        let u32 = Real::splat(uniforms[32]);
        let u33 = Real::splat(uniforms[33]);
        let u34 = Real::splat(uniforms[34]);
        let u35 = Real::splat(uniforms[35]);
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
        let x = at.state::<Real>(2);
        let r = R - x;
        let t1 = Real::splat(2.0) * r;
        let axial = u14 * x;
        let t2 = x * x;
        let t3 = u56 * t2;
        let t4 = u41 * x;
        let t5 = Real::splat(0.5) * x;
        let T = at.state::<Real>(0);
        let t6 = T + EA;
        let V = V_T * t6;
        let t7 = u6 * t6 + u32 * t6;
        let t8 = V_T - u31 * t6;
        let t9 = u33 * t6;
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
        let slip = u12 * speed;
        let saturation = saturate(slip);
        let t26 = below_one(slip);
        let mu = mu_k * saturation;
        let t27 = v_r * mu;
        let f_r = t19 * t27;
        let t28 = t27 * t25;
        let t29 = reciprocal(cos_beta + u13 * f_r);
        let t30 = x * t29;
        let p = u14 * t30;
        let t31 = r * p;
        let q = Real::splat(2.0) * t31;
        let t32 = u51 * t31;
        let t33 = t31 * t10;
        let t34 = u59 * (t31 * t2);
        let t35 = u39 * t30;
        let t36 = Real::splat(0.5) * t30;
        let t37 = x * (t29 * t29);
        let t38 = u18 * t37;
        let t39 = u14 * t29;
        let t40 = f_r - sin_beta;
        let t41 = q * t40;
        let t42 = (t40 + u11 * f_r) * t37;
        let t43 = u14 * t42;
        let t44 = v_r * f_r;
        let t45 = p * t44;
        let loss_radial = u16 * t45;
        let t46 = v_t * mu;
        let t47 = t46 * t25;
        let f_t = t19 * t46;
        let t48 = mu * t19;
        let t49 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t49);
        let loss = loss_radial + loss_tangential;
        let t50 = Phi * loss;
        let t51 = f_t * q;
        let t52 = Phi * t51;
        let t53 = reciprocal(speed);
        let t54 = u34 * speed;
        let t55 = v_t * t53;
        let t56 = v_r * t53;
        let t57 = reciprocal(cos_theta);
        let tan_theta = t57 * sin_theta;
        let t58 = f_t + tan_theta * t40;
        let t = q * t58;
        at.write_dc(0, t);
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let t59 = t * t2;
        let E_hat_1 = -(u20 * t59);
        at.write_f(9, E_hat_1);
        let d_E_hat_1_d_Phi = -(t * (u44 * t2));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t60 = r * t58;
        let d_T_hat_1_d_k = u63 * (t30 * t60);
        at.write_dc(22, d_T_hat_1_d_k);
        let t61 = u61 * (t30 * t58);
        let t62 = t58 * t3;
        let t63 = t1 * t62;
        let t64 = t35 * t62;
        let d_E_hat_1_d_k = -(u47 * t59 + t36 * t63);
        at.write_dc(70, d_E_hat_1_d_k);
        let t65 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t65;
        let t66 = T - n;
        let t67 = t65 * t11;
        let t68 = t1 * t67;
        let t69 = t35 * t67;
        let t70 = u51 * t33 + t38 * t68;
        let d_theta_hat_1_d_k = -(t36 * t68);
        at.write_dc(31, d_theta_hat_1_d_k);
        let theta_1 = t10 * t66;
        at.write_dc(3, theta_1);
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let t71 = r * tan_theta;
        let x_hat_1 = -(Phi * t71);
        at.write_f(2, x_hat_1);
        let d_x_hat_1_d_Phi = -t71;
        at.write_dc(6, d_x_hat_1_d_Phi);
        let t72 = tan_theta * q;
        let t73 = u58 * (t2 * t72) - (u14 * t2 + u43 * t2) * (u45 * t) + t43 * t63;
        let t74 = Phi * t72 - u64 * (t37 * t60);
        let t75 = t21 * t32 + t22 * t74;
        let t76 = t26 * (mu_k * t75);
        let d_T_hat_1_d_mu_k = saturation * t75;
        at.write_dc(27, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(t54 * t76);
        at.write_dc(28, d_T_hat_1_d_v_thr);
        let t77 = t47 * t32 + t28 * t74;
        let t78 = u12 * t76 - t24 * t77;
        let t79 = t48 * t32 + t55 * t78;
        let t80 = t48 * t74 - t23 * t77 + t56 * t78;
        let d_T_hat_1_d_beta = -(u57 * t72 + u62 * (t42 * t60) + t20 * t77);
        at.write_dc(26, d_T_hat_1_d_beta);
        let t81 = cos_theta * t79 + sin_theta * t80;
        let d_T_hat_1_d_T = V_T * t81;
        at.write_dy(0, d_T_hat_1_d_T);
        let t82 = t7 * t81;
        let d_T_hat_1_d_flow = u22 * t82;
        at.write_dc(2, d_T_hat_1_d_flow);
        let d_T_hat_1_d_m_o = u23 * t82 - t9 * t81;
        at.write_dc(23, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_EA = t8 * t81;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_R_P = u21 * t82;
        at.write_dc(25, d_T_hat_1_d_R_P);
        let t83 = omega * t79;
        let d_T_hat_1_d_x = u62 * (t29 * t60) + t83 - t61;
        at.write_dy(2, d_T_hat_1_d_x);
        let d_T_hat_1_d_R = t61 - t83;
        at.write_dc(24, d_T_hat_1_d_R);
        let t84 = r * t79;
        let d_T_hat_1_d_omega_P = u3 * t82 - sigma * t84;
        at.write_dc(29, d_T_hat_1_d_omega_P);
        let d_T_hat_1_d_sigma = -(omega_P * t84);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t85 = t72 * t11;
        let t86 = t38 * t63 - t72 * t3;
        let t87 = t47 * t34 - t28 * t86;
        let d_E_hat_1_d_beta = t73 + t20 * t87;
        at.write_dc(74, d_E_hat_1_d_beta);
        let t88 = t22 * t86 - t21 * t34;
        let t89 = t26 * (mu_k * t88);
        let d_E_hat_1_d_mu_k = saturation * t88;
        at.write_dc(75, d_E_hat_1_d_mu_k);
        let t90 = t24 * t87 + u12 * t89;
        let t91 = t48 * t86 + t23 * t87 + t56 * t90;
        let t92 = t55 * t90 - t48 * t34;
        let d_E_hat_1_d_v_thr = -(t54 * t89);
        at.write_dc(76, d_E_hat_1_d_v_thr);
        let t93 = cos_theta * t92 + sin_theta * t91;
        let d_E_hat_1_d_T = V_T * t93;
        at.write_dy(23, d_E_hat_1_d_T);
        let t94 = t7 * t93 - u50 * t59;
        let d_E_hat_1_d_flow = u22 * t94;
        at.write_dc(20, d_E_hat_1_d_flow);
        let d_E_hat_1_d_m_o = u49 * t59 - t9 * t93 + u23 * t94;
        at.write_dc(71, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_EA = u48 * t59 + t8 * t93;
        at.write_dc(69, d_E_hat_1_d_EA);
        let d_E_hat_1_d_R_P = u21 * t94;
        at.write_dc(73, d_E_hat_1_d_R_P);
        let t95 = omega * t92;
        let d_E_hat_1_d_x = t64 + (t95 - (u46 * (x * t) + t39 * t63));
        at.write_dy(25, d_E_hat_1_d_x);
        let d_E_hat_1_d_R = -(t64 + t95);
        at.write_dc(72, d_E_hat_1_d_R);
        let t96 = r * t92;
        let d_E_hat_1_d_omega_P = u3 * t94 - sigma * t96;
        at.write_dc(77, d_E_hat_1_d_omega_P);
        let d_E_hat_1_d_sigma = -(omega_P * t96);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t97 = t47 * t85 - t28 * t70;
        let d_theta_hat_1_d_beta = t43 * t68 - u60 * t33 + t20 * t97;
        at.write_dc(35, d_theta_hat_1_d_beta);
        let t98 = t22 * t70 - t21 * t85;
        let t99 = t26 * (mu_k * t98);
        let d_theta_hat_1_d_mu_k = saturation * t98;
        at.write_dc(36, d_theta_hat_1_d_mu_k);
        let t100 = t24 * t97 + u12 * t99;
        let t101 = t48 * t70 + t23 * t97 + t56 * t100;
        let t102 = t55 * t100 - t48 * t85;
        let d_theta_hat_1_d_v_thr = -(t54 * t99);
        at.write_dc(37, d_theta_hat_1_d_v_thr);
        let t103 = cos_theta * t102 + sin_theta * t101;
        let d_theta_hat_1_d_T = Phi * (t10 - t66 * (t10 * t10)) + V_T * t103;
        at.write_dy(3, d_theta_hat_1_d_T);
        let t104 = t7 * t103;
        let d_theta_hat_1_d_flow = u22 * t104;
        at.write_dc(5, d_theta_hat_1_d_flow);
        let d_theta_hat_1_d_m_o = u23 * t104 - t9 * t103;
        at.write_dc(32, d_theta_hat_1_d_m_o);
        let d_theta_hat_1_d_EA = t8 * t103;
        at.write_dc(30, d_theta_hat_1_d_EA);
        let d_theta_hat_1_d_R_P = u21 * t104;
        at.write_dc(34, d_theta_hat_1_d_R_P);
        let t105 = omega * t102;
        let d_theta_hat_1_d_x = t69 + (t105 - t39 * t68);
        at.write_dy(5, d_theta_hat_1_d_x);
        let d_theta_hat_1_d_R = -(t69 + t105);
        at.write_dc(33, d_theta_hat_1_d_R);
        let t106 = r * t102;
        let d_theta_hat_1_d_omega_P = u3 * t104 - sigma * t106;
        at.write_dc(38, d_theta_hat_1_d_omega_P);
        let d_theta_hat_1_d_sigma = -(omega_P * t106);
        at.write_dc(4, d_theta_hat_1_d_sigma);
        let t107 = Real::splat(1.0) + tan_theta * tan_theta;
        let d_theta_hat_1_d_theta = t17 * t101 - v_r * t102 - t107 * (t51 * t11);
        let d_E_hat_1_d_theta = t17 * t91 - v_r * t92 - t107 * (t41 * t3);
        let d_T_hat_1_d_theta = t17 * t80 - v_r * t79 + t107 * (Phi * t41);
        at.write_dy(1, d_T_hat_1_d_theta);
        at.write_dy(24, d_E_hat_1_d_theta);
        at.write_dy(4, d_theta_hat_1_d_theta);
        let d_x_hat_1_d_theta = -(t107 * (Phi * r));
        at.write_dy(6, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(7, d_x_hat_1_d_x);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(39, d_x_hat_1_d_R);
        let arc = r * t57;
        let t108 = u51 * (arc * t49) + u53 * (arc * t44);
        let t109 = u53 * (arc * (v_r * p)) - t38 * t108;
        let d_W_hat_1_d_k = t36 * t108;
        at.write_dc(57, d_W_hat_1_d_k);
        let d_A_hat_1_d_Phi = arc * axial;
        at.write_dc(10, d_A_hat_1_d_Phi);
        let loss_phi = arc * loss;
        at.write_dc(13, loss_phi);
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let t110 = u51 * (arc * (v_t * p));
        let d_A_hat_1_d_k = u54 * (x * arc);
        at.write_dc(49, d_A_hat_1_d_k);
        let t111 = t21 * t110 + t22 * t109;
        let t112 = t26 * (mu_k * t111);
        let d_W_hat_1_d_mu_k = saturation * t111;
        at.write_dc(62, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(t54 * t112);
        at.write_dc(63, d_W_hat_1_d_v_thr);
        let t113 = t47 * t110 + t28 * t109;
        let d_W_hat_1_d_beta = u52 * (arc * t45) - t43 * t108 - t20 * t113;
        at.write_dc(61, d_W_hat_1_d_beta);
        let t114 = u12 * t112 - t24 * t113;
        let t115 = u53 * (arc * (f_r * p)) + t48 * t109 - t23 * t113 + t56 * t114;
        let t116 = u51 * (arc * (f_t * p)) + t48 * t110 + t55 * t114;
        let t117 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t117;
        at.write_dc(7, d_M_hat_1_d_Phi);
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(3, M_hat_1);
        let t118 = Phi * (arc * q);
        let t119 = r * t117;
        let t120 = u64 * (t37 * t119);
        let t121 = t28 * t120 - t47 * t118;
        let d_M_hat_1_d_beta = t20 * t121 - u62 * (t42 * t119);
        at.write_dc(45, d_M_hat_1_d_beta);
        let t122 = t21 * t118 - t22 * t120;
        let t123 = t26 * (mu_k * t122);
        let d_M_hat_1_d_mu_k = saturation * t122;
        at.write_dc(46, d_M_hat_1_d_mu_k);
        let t124 = t24 * t121 + u12 * t123;
        let t125 = t23 * t121 - t48 * t120 + t56 * t124;
        let t126 = t48 * t118 + t55 * t124;
        let d_M_hat_1_d_v_thr = -(t54 * t123);
        at.write_dc(47, d_M_hat_1_d_v_thr);
        let t127 = u61 * (t30 * t117);
        let d_M_hat_1_d_k = u63 * (t30 * t119);
        at.write_dc(41, d_M_hat_1_d_k);
        let t128 = cos_theta * t126 + sin_theta * t125;
        let t129 = cos_theta * t116 + sin_theta * t115;
        let t130 = t57 * t57 * (r * sin_theta);
        let d_M_hat_1_d_theta = t17 * t125 - v_r * t126 + t130 * t52;
        let d_W_hat_1_d_theta = t17 * t115 - v_r * t116 + t130 * t50;
        at.write_dy(17, d_W_hat_1_d_theta);
        at.write_dy(9, d_M_hat_1_d_theta);
        let t131 = t57 * t52;
        let t132 = t57 * t50;
        let d_A_hat_1_d_theta = t130 * t4;
        at.write_dy(11, d_A_hat_1_d_theta);
        let d_L_o_hat_1_d_theta = t130 * t15;
        at.write_dy(14, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t57 * t15;
        at.write_dc(53, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(15, d_L_o_hat_1_d_x);
        let d_W_hat_1_d_T = V_T * t129;
        at.write_dy(16, d_W_hat_1_d_T);
        let t133 = t7 * t129;
        let t134 = t7 * t128;
        let d_M_hat_1_d_flow = u22 * t134;
        at.write_dc(9, d_M_hat_1_d_flow);
        let d_M_hat_1_d_m_o = u23 * t134 - t9 * t128;
        at.write_dc(42, d_M_hat_1_d_m_o);
        let d_W_hat_1_d_m_o = u23 * t133 - t9 * t129;
        at.write_dc(58, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_EA = t8 * t129;
        at.write_dc(56, d_W_hat_1_d_EA);
        let d_M_hat_1_d_EA = t8 * t128;
        at.write_dc(40, d_M_hat_1_d_EA);
        let d_M_hat_1_d_T = V_T * t128;
        at.write_dy(8, d_M_hat_1_d_T);
        let d_M_hat_1_d_R_P = u21 * t134;
        at.write_dc(44, d_M_hat_1_d_R_P);
        let d_W_hat_1_d_flow = u22 * t133;
        at.write_dc(15, d_W_hat_1_d_flow);
        let d_W_hat_1_d_R_P = u21 * t133;
        at.write_dc(60, d_W_hat_1_d_R_P);
        let t135 = omega * t126;
        let d_M_hat_1_d_x = u62 * (t29 * t119) + t135 - t131 - t127;
        let d_M_hat_1_d_R = t127 + (t131 - t135);
        at.write_dc(43, d_M_hat_1_d_R);
        at.write_dy(10, d_M_hat_1_d_x);
        let t136 = r * t126;
        let d_M_hat_1_d_omega_P = u3 * t134 - sigma * t136;
        at.write_dc(48, d_M_hat_1_d_omega_P);
        let d_M_hat_1_d_sigma = -(omega_P * t136);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t137 = omega * t116;
        let d_W_hat_1_d_x = t39 * t108 + t137 - t132;
        at.write_dy(18, d_W_hat_1_d_x);
        let d_W_hat_1_d_R = t132 - t137;
        at.write_dc(59, d_W_hat_1_d_R);
        let t138 = r * t116;
        let d_W_hat_1_d_omega_P = u3 * t133 - sigma * t138;
        at.write_dc(64, d_W_hat_1_d_omega_P);
        let d_W_hat_1_d_sigma = -(omega_P * t138);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(4, A_hat_1);
        let t139 = r * A_hat_1;
        let d_L_o_hat_1_d_Phi = arc * (EA * t14);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(5, L_o_hat_1);
        let t140 = arc * (u29 * (t14 * t14));
        let d_L_o_hat_1_d_T = -(u65 * t140);
        at.write_dy(13, d_L_o_hat_1_d_T);
        let t141 = u55 * t140;
        let t142 = (u15 - u40 * t13) * (Phi * t140) + (u6 * t12 - u25 * t12) * t141;
        let d_L_o_hat_1_d_EA = -t142;
        at.write_dc(51, d_L_o_hat_1_d_EA);
        let t143 = (u27 * t12 + u28) * t141;
        let d_L_o_hat_1_d_m_o = -((u7 * T - u30 * t12) * t141 + u23 * t143);
        at.write_dc(52, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_flow = -(u22 * t143);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u21 * t143);
        at.write_dc(54, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u3 * t143);
        at.write_dc(55, d_L_o_hat_1_d_omega_P);
        let t144 = Phi * arc;
        let d_A_hat_1_d_R = t57 * t4;
        let d_A_hat_1_d_x = u41 * arc - d_A_hat_1_d_R;
        at.write_dy(12, d_A_hat_1_d_x);
        at.write_dc(50, d_A_hat_1_d_R);
        let s = at.position::<Real>();
        let t145 = Phi * s;
        let t146 = A_hat_1 * (s * r);
        let (sin_t145, cos_t145) = sin_cos(t145);
        let A_x_hat_1 = cos_t145 * t139;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t139 * sin_t145;
        at.write_f(8, A_y_hat_1);
        let t148 = r * cos_t145;
        let t149 = r * sin_t145;
        let t150 = t4 * t149;
        let t151 = t4 * t148;
        let d_A_x_hat_1_d_theta = t130 * t151;
        at.write_dy(19, d_A_x_hat_1_d_theta);
        let t152 = t57 * t151;
        let d_A_y_hat_1_d_theta = t130 * t150;
        at.write_dy(21, d_A_y_hat_1_d_theta);
        let t153 = t57 * t150;
        let t154 = t144 * t149;
        let d_A_y_hat_1_d_Phi = cos_t145 * t146 + d_A_hat_1_d_Phi * t149;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t148 - sin_t145 * t146;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let t155 = t144 * t148;
        let t156 = A_hat_1 * cos_t145;
        let t157 = A_hat_1 * sin_t145;
        let d_A_y_hat_1_d_x = u14 * t154 - t153 - t157;
        at.write_dy(22, d_A_y_hat_1_d_x);
        let d_A_y_hat_1_d_R = t157 + t153;
        at.write_dc(68, d_A_y_hat_1_d_R);
        let d_A_y_hat_1_d_k = t5 * t154;
        at.write_dc(67, d_A_y_hat_1_d_k);
        let d_A_x_hat_1_d_k = t5 * t155;
        at.write_dc(65, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_x = u14 * t155 - t152 - t156;
        at.write_dy(20, d_A_x_hat_1_d_x);
        let d_A_x_hat_1_d_R = t156 + t152;
        at.write_dc(66, d_A_x_hat_1_d_R);
    }
}
/// Derived fields.
///
/// 11 add, 29 mul, 3 div, 2 sqrt, 3 fn a point; 19 once.
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
        let u8 = reciprocal(v_thr);
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
        let slip = u8 * speed;
        let saturation = saturate(slip);
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
