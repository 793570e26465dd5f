// contact_string_tanh: The belt in a groove, without bending stiffness: tanh friction.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p sheave-eqgen -- write` writes it anew.
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
///Right-hand side and integrands. (17 add, 56 mul, 5 div, 2 sqrt, 3 fn a point; 25 once)
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
        let T = at.state::<Real>(0);
        let V = V_T * (T + EA);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        let t2 = v_r * v_r;
        let v_t = cos_theta * V - omega * r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        let face_speed = sqrt(u7 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        let f_r = t3 * (v_r * mu);
        let p = u10 * (x * reciprocal(cos_beta + u9 * f_r));
        let q = Real::splat(2.0) * (r * p);
        let f_t = t3 * (v_t * mu);
        let t4 = reciprocal(cos_theta);
        let tan_theta = t4 * sin_theta;
        let t = q * (f_t + tan_theta * (f_r - sin_beta));
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let n = q * (sin_beta + tan_theta * f_t - f_r);
        let theta_1 = reciprocal(T) * (T - n);
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let x_hat_1 = -(Phi * (r * tan_theta));
        at.write_f(2, x_hat_1);
        let arc = r * t4;
        let M_hat_1 = Phi * (q * (arc * f_t));
        at.write_f(3, M_hat_1);
        let axial = u10 * x;
        let A_hat_1 = Phi * (arc * axial);
        at.write_f(4, A_hat_1);
        let F = u4 * (u2 + m_o * T);
        let L_o_hat_1 = Phi * (arc * (EA * reciprocal(EA + F)));
        at.write_f(5, L_o_hat_1);
        let loss_radial = u11 * (p * (v_r * f_r));
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let s = at.position::<Real>();
        let t5 = Phi * s;
        let (sin_t5, cos_t5) = sin_cos(t5);
        let t7 = r * A_hat_1;
        let A_x_hat_1 = cos_t5 * t7;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t7 * sin_t5;
        at.write_f(8, A_y_hat_1);
        let E_hat_1 = -(u12 * (t * (x * x)));
        at.write_f(9, E_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and default unknowns. (91 add, 252 mul, 6 div, 2 sqrt, 3 fn a point; 59 once)
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
        let face_speed = sqrt(u8 * t3 + speed * speed);
        let t5 = reciprocal(face_speed);
        let saturation = tanh(u9 * speed);
        let mu = mu_k * saturation;
        let t6 = v_r * mu;
        let f_r = t5 * t6;
        let t7 = reciprocal(cos_beta + u10 * f_r);
        let t8 = x * t7;
        let p = u11 * t8;
        let t9 = r * p;
        let q = Real::splat(2.0) * t9;
        let t10 = v_t * mu;
        let f_t = t5 * t10;
        let t11 = reciprocal(cos_theta);
        let tan_theta = t11 * sin_theta;
        let t12 = f_r - sin_beta;
        let t13 = f_t + tan_theta * t12;
        let t = q * t13;
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let t14 = reciprocal(T);
        let t15 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t15;
        let t16 = T - n;
        let theta_1 = t14 * t16;
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let t17 = r * tan_theta;
        let x_hat_1 = -(Phi * t17);
        at.write_f(2, x_hat_1);
        let arc = r * t11;
        let t18 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t18;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(3, M_hat_1);
        let axial = u11 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(4, A_hat_1);
        let t19 = u2 + m_o * T;
        let F = u5 * t19;
        let t20 = reciprocal(EA + F);
        let d_L_o_hat_1_d_Phi = arc * (EA * t20);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(5, L_o_hat_1);
        let t21 = v_r * f_r;
        let loss_radial = u12 * (p * t21);
        let t22 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t22);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let s = at.position::<Real>();
        let t23 = Phi * s;
        let (sin_t23, cos_t23) = sin_cos(t23);
        let t25 = r * A_hat_1;
        let A_x_hat_1 = cos_t23 * t25;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t25 * sin_t23;
        at.write_f(8, A_y_hat_1);
        let t26 = x * x;
        let t27 = t * t26;
        let E_hat_1 = -(u16 * t27);
        at.write_f(9, E_hat_1);
        let t28 = mu * t5;
        let t29 = v_r * t5;
        let t30 = u24 * t29;
        let t31 = t5 * t5;
        let t32 = t6 * t31;
        let t33 = reciprocal(speed);
        let t34 = v_r * t33;
        let t35 = u30 * (Real::splat(1.0) - saturation * saturation);
        let t36 = speed * t5;
        let t37 = t29 * t35 - t36 * t32;
        let t38 = t28 - t30 * t32 + t34 * t37;
        let t39 = tan_theta * q;
        let t40 = x * (t7 * t7);
        let t41 = r * t40;
        let t42 = u38 * t41;
        let t43 = t39 - t13 * t42;
        let t44 = t10 * t31;
        let t45 = v_t * t5 * t35 - t36 * t44;
        let t46 = t34 * t45 - t30 * t44;
        let t47 = t38 * t43 + q * t46;
        let t48 = v_t * t33;
        let t49 = t48 * t37;
        let t50 = t28 + t48 * t45;
        let t51 = t49 * t43 + q * t50;
        let d_T_hat_1_d_T = u29 * (sin_theta * t47) + u29 * (cos_theta * t51);
        at.write_dy(0, d_T_hat_1_d_T);
        let t52 = Real::splat(1.0) + tan_theta * tan_theta;
        let t53 = t52 * (q * t12);
        let t54 = Phi * t47;
        let t55 = Phi * t51;
        let d_T_hat_1_d_theta = Phi * t53 + t4 * t54 - v_r * t55;
        at.write_dy(1, d_T_hat_1_d_theta);
        let t56 = u25 * (r * t7) - u25 * t8;
        let t57 = t13 * t56;
        let d_T_hat_1_d_x = Phi * t57 + u40 * t51;
        at.write_dy(2, d_T_hat_1_d_x);
        let t58 = V_T * sin_theta;
        let t59 = Phi * t14;
        let t60 = t15 * t59;
        let t61 = u36 * (t9 * t14) + t42 * t60;
        let t62 = t39 * t59;
        let t63 = t38 * t61 - t46 * t62;
        let t64 = V_T * cos_theta;
        let t65 = t49 * t61 - t50 * t62;
        let d_theta_hat_1_d_T = Phi * (t14 - t16 * (t14 * t14)) + t58 * t63 + t64 * t65;
        at.write_dy(3, d_theta_hat_1_d_T);
        let t66 = f_t * q;
        let d_theta_hat_1_d_theta = t4 * t63 - t59 * (t52 * t66) - v_r * t65;
        at.write_dy(4, d_theta_hat_1_d_theta);
        let d_theta_hat_1_d_x = omega * t65 - t56 * t60;
        at.write_dy(5, d_theta_hat_1_d_x);
        let d_x_hat_1_d_theta = -(t52 * (Phi * r));
        at.write_dy(6, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(7, d_x_hat_1_d_x);
        let t67 = Phi * (arc * q);
        let t68 = u39 * (t18 * t41);
        let t69 = t67 * t46 - t38 * t68;
        let t70 = t67 * t50 - t49 * t68;
        let d_M_hat_1_d_T = t58 * t69 + t64 * t70;
        at.write_dy(8, d_M_hat_1_d_T);
        let t71 = t11 * t11 * (r * sin_theta);
        let t72 = Phi * t66;
        let d_M_hat_1_d_theta = t71 * t72 + t4 * t69 - v_r * t70;
        at.write_dy(9, d_M_hat_1_d_theta);
        let d_M_hat_1_d_x = Phi * t18 * t56 - t11 * t72 + omega * t70;
        at.write_dy(10, d_M_hat_1_d_x);
        let t73 = u26 * x;
        let d_A_hat_1_d_theta = t71 * t73;
        at.write_dy(11, d_A_hat_1_d_theta);
        let d_A_hat_1_d_x = u26 * arc - t11 * t73;
        at.write_dy(12, d_A_hat_1_d_x);
        let t74 = arc * (u22 * (t20 * t20));
        let d_L_o_hat_1_d_T = -(u33 * t74);
        at.write_dy(13, d_L_o_hat_1_d_T);
        let t75 = u27 * t20;
        let d_L_o_hat_1_d_theta = t71 * t75;
        at.write_dy(14, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_x = -(t11 * t75);
        at.write_dy(15, d_L_o_hat_1_d_x);
        let t76 = u35 * (arc * t21) + u36 * (arc * t22);
        let t77 = u35 * (arc * (v_r * p)) - u14 * t40 * t76;
        let t78 = u36 * (arc * (v_t * p));
        let t79 = u35 * (arc * (f_r * p)) + t38 * t77 + t78 * t46;
        let t80 = u36 * (arc * (f_t * p)) + t49 * t77 + t78 * t50;
        let d_W_hat_1_d_T = t58 * t79 + t64 * t80;
        at.write_dy(16, d_W_hat_1_d_T);
        let t81 = Phi * loss;
        let d_W_hat_1_d_theta = t71 * t81 + t4 * t79 - v_r * t80;
        at.write_dy(17, d_W_hat_1_d_theta);
        let d_W_hat_1_d_x = u11 * t7 * t76 - t11 * t81 + omega * t80;
        at.write_dy(18, d_W_hat_1_d_x);
        let t82 = r * cos_t23;
        let d_A_x_hat_1_d_theta = t82 * d_A_hat_1_d_theta;
        at.write_dy(19, d_A_x_hat_1_d_theta);
        let d_A_x_hat_1_d_x = t82 * d_A_hat_1_d_x - A_hat_1 * cos_t23;
        at.write_dy(20, d_A_x_hat_1_d_x);
        let t83 = r * sin_t23;
        let d_A_y_hat_1_d_theta = t83 * d_A_hat_1_d_theta;
        at.write_dy(21, d_A_y_hat_1_d_theta);
        let d_A_y_hat_1_d_x = t83 * d_A_hat_1_d_x - A_hat_1 * sin_t23;
        at.write_dy(22, d_A_y_hat_1_d_x);
        let t84 = u37 * t26;
        let t85 = t84 * t47;
        let t86 = t84 * t51;
        let d_E_hat_1_d_T = -(t58 * t85 + t64 * t86);
        at.write_dy(23, d_E_hat_1_d_T);
        let d_E_hat_1_d_theta = v_r * t86 - (t53 * t84 + t4 * t85);
        at.write_dy(24, d_E_hat_1_d_theta);
        let d_E_hat_1_d_x = -(u32 * (x * t) + t84 * t57 + omega * t86);
        at.write_dy(25, d_E_hat_1_d_x);
        at.write_dc(0, t);
        let d_T_hat_1_d_sigma = -(u41 * (r * t51));
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t87 = u17 * (u4 * t1 + u23 * t1);
        let t88 = sin_theta * t87;
        let t89 = cos_theta * t87;
        let d_T_hat_1_d_flow = t88 * t54 + t89 * t55;
        at.write_dc(2, d_T_hat_1_d_flow);
        at.write_dc(3, theta_1);
        let t90 = omega_P * r;
        let d_theta_hat_1_d_sigma = -(t90 * t65);
        at.write_dc(4, d_theta_hat_1_d_sigma);
        let d_theta_hat_1_d_flow = t88 * t63 + t89 * t65;
        at.write_dc(5, d_theta_hat_1_d_flow);
        let d_x_hat_1_d_Phi = -t17;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let d_M_hat_1_d_sigma = -(t90 * t70);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let d_M_hat_1_d_flow = t88 * t69 + t89 * t70;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let d_L_o_hat_1_d_flow = -(u17 * ((u20 * t19 + u21) * (u31 * t74)));
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let d_W_hat_1_d_sigma = -(t90 * t80);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let d_W_hat_1_d_flow = t88 * t79 + t89 * t80;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t91 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t82 - sin_t23 * t91;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t23 * t91 + d_A_hat_1_d_Phi * t83;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = -(t * (u28 * t26));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let d_E_hat_1_d_sigma = t90 * t86;
        at.write_dc(19, d_E_hat_1_d_sigma);
        let d_E_hat_1_d_flow = -(u34 * t27 + t88 * t85 + t89 * t86);
        at.write_dc(20, d_E_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (161 add, 409 mul, 6 div, 2 sqrt, 3 fn a point; 91 once)
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
        let saturation = tanh(u13 * speed);
        let mu = mu_k * saturation;
        let t6 = v_r * mu;
        let f_r = t5 * t6;
        let t7 = reciprocal(cos_beta + u14 * f_r);
        let t8 = x * t7;
        let p = u15 * t8;
        let t9 = r * p;
        let q = Real::splat(2.0) * t9;
        let t10 = v_t * mu;
        let f_t = t5 * t10;
        let t11 = reciprocal(cos_theta);
        let tan_theta = t11 * sin_theta;
        let t12 = f_r - sin_beta;
        let t13 = f_t + tan_theta * t12;
        let t = q * t13;
        let T_hat_1 = Phi * t;
        at.write_f(0, T_hat_1);
        let t14 = reciprocal(T);
        let t15 = sin_beta + tan_theta * f_t - f_r;
        let n = q * t15;
        let t16 = T - n;
        let theta_1 = t14 * t16;
        let theta_hat_1 = Phi * theta_1;
        at.write_f(1, theta_hat_1);
        let t17 = r * tan_theta;
        let x_hat_1 = -(Phi * t17);
        at.write_f(2, x_hat_1);
        let arc = r * t11;
        let t18 = arc * f_t;
        let d_M_hat_1_d_Phi = q * t18;
        let M_hat_1 = Phi * d_M_hat_1_d_Phi;
        at.write_f(3, M_hat_1);
        let axial = u15 * x;
        let d_A_hat_1_d_Phi = arc * axial;
        let A_hat_1 = Phi * d_A_hat_1_d_Phi;
        at.write_f(4, A_hat_1);
        let t19 = u4 + m_o * T;
        let F = u7 * t19;
        let t20 = EA + F;
        let t21 = reciprocal(t20);
        let d_L_o_hat_1_d_Phi = arc * (EA * t21);
        let L_o_hat_1 = Phi * d_L_o_hat_1_d_Phi;
        at.write_f(5, L_o_hat_1);
        let t22 = v_r * f_r;
        let t23 = p * t22;
        let loss_radial = u17 * t23;
        let t24 = v_t * f_t;
        let loss_tangential = Real::splat(2.0) * (p * t24);
        let loss = loss_radial + loss_tangential;
        let loss_phi = arc * loss;
        let W_hat_1 = Phi * loss_phi;
        at.write_f(6, W_hat_1);
        let s = at.position::<Real>();
        let t25 = Phi * s;
        let (sin_t25, cos_t25) = sin_cos(t25);
        let t27 = r * A_hat_1;
        let A_x_hat_1 = cos_t25 * t27;
        at.write_f(7, A_x_hat_1);
        let A_y_hat_1 = t27 * sin_t25;
        at.write_f(8, A_y_hat_1);
        let t28 = x * x;
        let t29 = t * t28;
        let E_hat_1 = -(u21 * t29);
        at.write_f(9, E_hat_1);
        let t30 = mu * t5;
        let t31 = u51 * t9;
        let t32 = reciprocal(speed);
        let t33 = v_t * t32;
        let t34 = Real::splat(1.0) - saturation * saturation;
        let t35 = v_t * t5;
        let t36 = v_r * t5;
        let t37 = tan_theta * q;
        let t38 = x * (t7 * t7);
        let t39 = r * t13;
        let t40 = Phi * t37 - u64 * (t38 * t39);
        let t41 = t35 * t31 + t36 * t40;
        let t42 = t34 * t41;
        let t43 = speed * t5;
        let t44 = t5 * t5;
        let t45 = t10 * t44;
        let t46 = t6 * t44;
        let t47 = t45 * t31 + t46 * t40;
        let t48 = u67 * t42 - t43 * t47;
        let t49 = t30 * t31 + t33 * t48;
        let t50 = u38 * t36;
        let t51 = v_r * t32;
        let t52 = t30 * t40 - t50 * t47 + t51 * t48;
        let t53 = cos_theta * t49 + sin_theta * t52;
        let d_T_hat_1_d_T = V_T * t53;
        at.write_dy(0, d_T_hat_1_d_T);
        let t54 = Real::splat(1.0) + tan_theta * tan_theta;
        let t55 = q * t12;
        let d_T_hat_1_d_theta = t4 * t52 - v_r * t49 + t54 * (Phi * t55);
        at.write_dy(1, d_T_hat_1_d_theta);
        let t56 = omega * t49;
        let t57 = u61 * (t8 * t13);
        let d_T_hat_1_d_x = u62 * (t7 * t39) + t56 - t57;
        at.write_dy(2, d_T_hat_1_d_x);
        let t58 = Phi * t14;
        let t59 = t37 * t58;
        let t60 = t9 * t14;
        let t61 = u19 * t38;
        let t62 = Real::splat(2.0) * r;
        let t63 = t15 * t58;
        let t64 = t62 * t63;
        let t65 = u51 * t60 + t61 * t64;
        let t66 = t45 * t59 - t46 * t65;
        let t67 = t36 * t65 - t35 * t59;
        let t68 = t34 * t67;
        let t69 = t43 * t66 + u67 * t68;
        let t70 = t33 * t69 - t30 * t59;
        let t71 = t30 * t65 + t50 * t66 + t51 * t69;
        let t72 = cos_theta * t70 + sin_theta * t71;
        let d_theta_hat_1_d_T = Phi * (t14 - t16 * (t14 * t14)) + V_T * t72;
        at.write_dy(3, d_theta_hat_1_d_T);
        let t73 = f_t * q;
        let d_theta_hat_1_d_theta = t4 * t71 - v_r * t70 - t54 * (t73 * t58);
        at.write_dy(4, d_theta_hat_1_d_theta);
        let t74 = u39 * t8;
        let t75 = t74 * t63;
        let t76 = omega * t70;
        let t77 = u15 * t7;
        let d_theta_hat_1_d_x = t75 + (t76 - t77 * t64);
        at.write_dy(5, d_theta_hat_1_d_x);
        let d_x_hat_1_d_theta = -(t54 * (Phi * r));
        at.write_dy(6, d_x_hat_1_d_theta);
        let d_x_hat_1_d_x = Phi * tan_theta;
        at.write_dy(7, d_x_hat_1_d_x);
        let t78 = Phi * (arc * q);
        let t79 = r * t18;
        let t80 = u64 * (t38 * t79);
        let t81 = t46 * t80 - t45 * t78;
        let t82 = t35 * t78 - t36 * t80;
        let t83 = t34 * t82;
        let t84 = t43 * t81 + u67 * t83;
        let t85 = t30 * t78 + t33 * t84;
        let t86 = t50 * t81 - t30 * t80 + t51 * t84;
        let t87 = cos_theta * t85 + sin_theta * t86;
        let d_M_hat_1_d_T = V_T * t87;
        at.write_dy(8, d_M_hat_1_d_T);
        let t88 = t11 * t11 * (r * sin_theta);
        let t89 = Phi * t73;
        let d_M_hat_1_d_theta = t4 * t86 - v_r * t85 + t88 * t89;
        at.write_dy(9, d_M_hat_1_d_theta);
        let t90 = omega * t85;
        let t91 = t11 * t89;
        let t92 = u61 * (t8 * t18);
        let d_M_hat_1_d_x = u62 * (t7 * t79) + t90 - t91 - t92;
        at.write_dy(10, d_M_hat_1_d_x);
        let t93 = u41 * x;
        let d_A_hat_1_d_theta = t88 * t93;
        at.write_dy(11, d_A_hat_1_d_theta);
        let d_A_hat_1_d_R = t11 * t93;
        let d_A_hat_1_d_x = u41 * arc - d_A_hat_1_d_R;
        at.write_dy(12, d_A_hat_1_d_x);
        let t94 = arc * (u30 * (t21 * t21));
        let d_L_o_hat_1_d_T = -(u68 * t94);
        at.write_dy(13, d_L_o_hat_1_d_T);
        let t95 = u42 * t21;
        let d_L_o_hat_1_d_theta = t88 * t95;
        at.write_dy(14, d_L_o_hat_1_d_theta);
        let d_L_o_hat_1_d_R = t11 * t95;
        let d_L_o_hat_1_d_x = -d_L_o_hat_1_d_R;
        at.write_dy(15, d_L_o_hat_1_d_x);
        let t96 = u51 * (arc * (v_t * p));
        let t97 = u51 * (arc * t24) + u53 * (arc * t22);
        let t98 = u53 * (arc * (v_r * p)) - t61 * t97;
        let t99 = t35 * t96 + t36 * t98;
        let t100 = t34 * t99;
        let t101 = t45 * t96 + t46 * t98;
        let t102 = u67 * t100 - t43 * t101;
        let t103 = u51 * (arc * (f_t * p)) + t30 * t96 + t33 * t102;
        let t104 = u53 * (arc * (f_r * p)) + t30 * t98 - t50 * t101 + t51 * t102;
        let t105 = cos_theta * t103 + sin_theta * t104;
        let d_W_hat_1_d_T = V_T * t105;
        at.write_dy(16, d_W_hat_1_d_T);
        let t106 = Phi * loss;
        let d_W_hat_1_d_theta = t4 * t104 - v_r * t103 + t88 * t106;
        at.write_dy(17, d_W_hat_1_d_theta);
        let t107 = omega * t103;
        let t108 = t11 * t106;
        let d_W_hat_1_d_x = t77 * t97 + t107 - t108;
        at.write_dy(18, d_W_hat_1_d_x);
        let t109 = r * cos_t25;
        let t110 = t93 * t109;
        let d_A_x_hat_1_d_theta = t88 * t110;
        at.write_dy(19, d_A_x_hat_1_d_theta);
        let t111 = Phi * arc;
        let t112 = t111 * t109;
        let t113 = t11 * t110;
        let t114 = A_hat_1 * cos_t25;
        let d_A_x_hat_1_d_x = u15 * t112 - t113 - t114;
        at.write_dy(20, d_A_x_hat_1_d_x);
        let t115 = r * sin_t25;
        let t116 = t93 * t115;
        let d_A_y_hat_1_d_theta = t88 * t116;
        at.write_dy(21, d_A_y_hat_1_d_theta);
        let t117 = t111 * t115;
        let t118 = t11 * t116;
        let t119 = A_hat_1 * sin_t25;
        let d_A_y_hat_1_d_x = u15 * t117 - t118 - t119;
        at.write_dy(22, d_A_y_hat_1_d_x);
        let t120 = u59 * (t9 * t28);
        let t121 = u56 * t28;
        let t122 = t13 * t121;
        let t123 = t62 * t122;
        let t124 = t61 * t123 - t37 * t121;
        let t125 = t45 * t120 - t46 * t124;
        let t126 = t36 * t124 - t35 * t120;
        let t127 = t34 * t126;
        let t128 = t43 * t125 + u67 * t127;
        let t129 = t33 * t128 - t30 * t120;
        let t130 = t30 * t124 + t50 * t125 + t51 * t128;
        let t131 = cos_theta * t129 + sin_theta * t130;
        let d_E_hat_1_d_T = V_T * t131;
        at.write_dy(23, d_E_hat_1_d_T);
        let d_E_hat_1_d_theta = t4 * t130 - v_r * t129 - t54 * (t55 * t121);
        at.write_dy(24, d_E_hat_1_d_theta);
        let t132 = t74 * t122;
        let t133 = omega * t129;
        let d_E_hat_1_d_x = t132 + (t133 - (u46 * (x * t) + t77 * t123));
        at.write_dy(25, d_E_hat_1_d_x);
        at.write_dc(0, t);
        let t134 = r * t49;
        let d_T_hat_1_d_sigma = -(omega_P * t134);
        at.write_dc(1, d_T_hat_1_d_sigma);
        let t135 = u6 * t1 + u33 * t1;
        let t136 = t135 * t53;
        let d_T_hat_1_d_flow = u23 * t136;
        at.write_dc(2, d_T_hat_1_d_flow);
        at.write_dc(3, theta_1);
        let t137 = r * t70;
        let d_theta_hat_1_d_sigma = -(omega_P * t137);
        at.write_dc(4, d_theta_hat_1_d_sigma);
        let t138 = t135 * t72;
        let d_theta_hat_1_d_flow = u23 * t138;
        at.write_dc(5, d_theta_hat_1_d_flow);
        let d_x_hat_1_d_Phi = -t17;
        at.write_dc(6, d_x_hat_1_d_Phi);
        at.write_dc(7, d_M_hat_1_d_Phi);
        let t139 = r * t85;
        let d_M_hat_1_d_sigma = -(omega_P * t139);
        at.write_dc(8, d_M_hat_1_d_sigma);
        let t140 = t135 * t87;
        let d_M_hat_1_d_flow = u23 * t140;
        at.write_dc(9, d_M_hat_1_d_flow);
        at.write_dc(10, d_A_hat_1_d_Phi);
        at.write_dc(11, d_L_o_hat_1_d_Phi);
        let t141 = u55 * t94;
        let t142 = (u28 * t19 + u29) * t141;
        let d_L_o_hat_1_d_flow = -(u23 * t142);
        at.write_dc(12, d_L_o_hat_1_d_flow);
        at.write_dc(13, loss_phi);
        let t143 = r * t103;
        let d_W_hat_1_d_sigma = -(omega_P * t143);
        at.write_dc(14, d_W_hat_1_d_sigma);
        let t144 = t135 * t105;
        let d_W_hat_1_d_flow = u23 * t144;
        at.write_dc(15, d_W_hat_1_d_flow);
        let t145 = A_hat_1 * (s * r);
        let d_A_x_hat_1_d_Phi = d_A_hat_1_d_Phi * t109 - sin_t25 * t145;
        at.write_dc(16, d_A_x_hat_1_d_Phi);
        let d_A_y_hat_1_d_Phi = cos_t25 * t145 + d_A_hat_1_d_Phi * t115;
        at.write_dc(17, d_A_y_hat_1_d_Phi);
        let d_E_hat_1_d_Phi = -(t * (u44 * t28));
        at.write_dc(18, d_E_hat_1_d_Phi);
        let t146 = r * t129;
        let d_E_hat_1_d_sigma = -(omega_P * t146);
        at.write_dc(19, d_E_hat_1_d_sigma);
        let t147 = t135 * t131 - u50 * t29;
        let d_E_hat_1_d_flow = u23 * t147;
        at.write_dc(20, d_E_hat_1_d_flow);
        let t148 = V_T - u32 * t1;
        let d_T_hat_1_d_EA = t148 * t53;
        at.write_dc(21, d_T_hat_1_d_EA);
        let d_T_hat_1_d_k = u63 * (t8 * t39);
        at.write_dc(22, d_T_hat_1_d_k);
        let t149 = u34 * t1;
        let d_T_hat_1_d_m_o = u24 * t136 - t149 * t53;
        at.write_dc(23, d_T_hat_1_d_m_o);
        let d_T_hat_1_d_R = t57 - t56;
        at.write_dc(24, d_T_hat_1_d_R);
        let d_T_hat_1_d_R_P = u22 * t136;
        at.write_dc(25, d_T_hat_1_d_R_P);
        let t150 = (t12 + u11 * f_r) * t38;
        let t151 = Real::splat(0.5) * t5 * (u35 * t3 + u37 * t3);
        let d_T_hat_1_d_beta = -(u57 * t37 + u62 * (t150 * t39) + t151 * t47);
        at.write_dc(26, d_T_hat_1_d_beta);
        let d_T_hat_1_d_mu_k = saturation * t41;
        at.write_dc(27, d_T_hat_1_d_mu_k);
        let d_T_hat_1_d_v_thr = -(u66 * (speed * t42));
        at.write_dc(28, d_T_hat_1_d_v_thr);
        let d_T_hat_1_d_omega_P = u3 * t136 - sigma * t134;
        at.write_dc(29, d_T_hat_1_d_omega_P);
        let d_theta_hat_1_d_EA = t148 * t72;
        at.write_dc(30, d_theta_hat_1_d_EA);
        let t152 = Real::splat(0.5) * t8;
        let d_theta_hat_1_d_k = -(t152 * t64);
        at.write_dc(31, d_theta_hat_1_d_k);
        let d_theta_hat_1_d_m_o = u24 * t138 - t149 * t72;
        at.write_dc(32, d_theta_hat_1_d_m_o);
        let d_theta_hat_1_d_R = -(t75 + t76);
        at.write_dc(33, d_theta_hat_1_d_R);
        let d_theta_hat_1_d_R_P = u22 * t138;
        at.write_dc(34, d_theta_hat_1_d_R_P);
        let t153 = u15 * t150;
        let d_theta_hat_1_d_beta = t153 * t64 - u60 * t60 + t151 * t66;
        at.write_dc(35, d_theta_hat_1_d_beta);
        let d_theta_hat_1_d_mu_k = saturation * t67;
        at.write_dc(36, d_theta_hat_1_d_mu_k);
        let d_theta_hat_1_d_v_thr = -(u66 * (speed * t68));
        at.write_dc(37, d_theta_hat_1_d_v_thr);
        let d_theta_hat_1_d_omega_P = u3 * t138 - sigma * t137;
        at.write_dc(38, d_theta_hat_1_d_omega_P);
        let d_x_hat_1_d_R = -d_x_hat_1_d_x;
        at.write_dc(39, d_x_hat_1_d_R);
        let d_M_hat_1_d_EA = t148 * t87;
        at.write_dc(40, d_M_hat_1_d_EA);
        let d_M_hat_1_d_k = u63 * (t8 * t79);
        at.write_dc(41, d_M_hat_1_d_k);
        let d_M_hat_1_d_m_o = u24 * t140 - t149 * t87;
        at.write_dc(42, d_M_hat_1_d_m_o);
        let d_M_hat_1_d_R = t92 + (t91 - t90);
        at.write_dc(43, d_M_hat_1_d_R);
        let d_M_hat_1_d_R_P = u22 * t140;
        at.write_dc(44, d_M_hat_1_d_R_P);
        let d_M_hat_1_d_beta = t151 * t81 - u62 * (t150 * t79);
        at.write_dc(45, d_M_hat_1_d_beta);
        let d_M_hat_1_d_mu_k = saturation * t82;
        at.write_dc(46, d_M_hat_1_d_mu_k);
        let d_M_hat_1_d_v_thr = -(u66 * (speed * t83));
        at.write_dc(47, d_M_hat_1_d_v_thr);
        let d_M_hat_1_d_omega_P = u3 * t140 - sigma * t139;
        at.write_dc(48, d_M_hat_1_d_omega_P);
        let d_A_hat_1_d_k = u54 * (x * arc);
        at.write_dc(49, d_A_hat_1_d_k);
        at.write_dc(50, d_A_hat_1_d_R);
        let t154 = (u16 - u40 * t20) * (Phi * t94) + (u6 * t19 - u26 * t19) * t141;
        let d_L_o_hat_1_d_EA = -t154;
        at.write_dc(51, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -((u7 * T - u31 * t19) * t141 + u24 * t142);
        at.write_dc(52, d_L_o_hat_1_d_m_o);
        at.write_dc(53, d_L_o_hat_1_d_R);
        let d_L_o_hat_1_d_R_P = -(u22 * t142);
        at.write_dc(54, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u3 * t142);
        at.write_dc(55, d_L_o_hat_1_d_omega_P);
        let d_W_hat_1_d_EA = t148 * t105;
        at.write_dc(56, d_W_hat_1_d_EA);
        let d_W_hat_1_d_k = t152 * t97;
        at.write_dc(57, d_W_hat_1_d_k);
        let d_W_hat_1_d_m_o = u24 * t144 - t149 * t105;
        at.write_dc(58, d_W_hat_1_d_m_o);
        let d_W_hat_1_d_R = t108 - t107;
        at.write_dc(59, d_W_hat_1_d_R);
        let d_W_hat_1_d_R_P = u22 * t144;
        at.write_dc(60, d_W_hat_1_d_R_P);
        let d_W_hat_1_d_beta = u52 * (arc * t23) - t153 * t97 - t151 * t101;
        at.write_dc(61, d_W_hat_1_d_beta);
        let d_W_hat_1_d_mu_k = saturation * t99;
        at.write_dc(62, d_W_hat_1_d_mu_k);
        let d_W_hat_1_d_v_thr = -(u66 * (speed * t100));
        at.write_dc(63, d_W_hat_1_d_v_thr);
        let d_W_hat_1_d_omega_P = u3 * t144 - sigma * t143;
        at.write_dc(64, d_W_hat_1_d_omega_P);
        let t155 = Real::splat(0.5) * x;
        let d_A_x_hat_1_d_k = t155 * t112;
        at.write_dc(65, d_A_x_hat_1_d_k);
        let d_A_x_hat_1_d_R = t114 + t113;
        at.write_dc(66, d_A_x_hat_1_d_R);
        let d_A_y_hat_1_d_k = t155 * t117;
        at.write_dc(67, d_A_y_hat_1_d_k);
        let d_A_y_hat_1_d_R = t119 + t118;
        at.write_dc(68, d_A_y_hat_1_d_R);
        let d_E_hat_1_d_EA = u48 * t29 + t148 * t131;
        at.write_dc(69, d_E_hat_1_d_EA);
        let d_E_hat_1_d_k = -(u47 * t29 + t152 * t123);
        at.write_dc(70, d_E_hat_1_d_k);
        let d_E_hat_1_d_m_o = u49 * t29 - t149 * t131 + u24 * t147;
        at.write_dc(71, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R = -(t132 + t133);
        at.write_dc(72, d_E_hat_1_d_R);
        let d_E_hat_1_d_R_P = u22 * t147;
        at.write_dc(73, d_E_hat_1_d_R_P);
        let t156 = u58 * (t28 * t37) - (u15 * t28 + u43 * t28) * (u45 * t) + t153 * t123;
        let d_E_hat_1_d_beta = t156 + t151 * t125;
        at.write_dc(74, d_E_hat_1_d_beta);
        let d_E_hat_1_d_mu_k = saturation * t126;
        at.write_dc(75, d_E_hat_1_d_mu_k);
        let d_E_hat_1_d_v_thr = -(u66 * (speed * t127));
        at.write_dc(76, d_E_hat_1_d_v_thr);
        let d_E_hat_1_d_omega_P = u3 * t147 - sigma * t146;
        at.write_dc(77, d_E_hat_1_d_omega_P);
    }
}
///Derived fields. (10 add, 29 mul, 3 div, 2 sqrt, 4 fn a point; 20 once)
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
        let T = at.state::<Real>(0);
        let F = u4 * (u2 + m_o * T);
        at.write_field(0, F);
        let V = V_T * (T + EA);
        at.write_field(1, V);
        let theta = at.state::<Real>(1);
        let (sin_theta, cos_theta) = sin_cos(theta);
        let v_r = V * sin_theta;
        at.write_field(2, v_r);
        let x = at.state::<Real>(2);
        let r = R - x;
        let v_t = cos_theta * V - omega * r;
        at.write_field(3, v_t);
        let t2 = v_r * v_r;
        let speed = sqrt(v_t * v_t + (Real::splat(1e-24) + t2));
        at.write_field(4, speed);
        let gamma_a = angle(v_r, v_t);
        let gamma = turn(gamma_a);
        at.write_field(5, gamma);
        let saturation = tanh(u8 * speed);
        let mu = mu_k * saturation;
        at.write_field(6, mu);
        let face_speed = sqrt(u7 * t2 + speed * speed);
        let t3 = reciprocal(face_speed);
        let f_r = t3 * (v_r * mu);
        let p = u10 * (x * reciprocal(cos_beta + u9 * f_r));
        at.write_field(7, p);
        let beta_s = angle(speed, u9 * v_r);
        at.write_field(8, beta_s);
        at.write_field(9, Real::splat(0.0));
        at.write_field(10, Real::splat(0.0));
        let axial = u10 * x;
        at.write_field(11, axial);
        let loss_radial = u11 * (p * (v_r * f_r));
        let f_t = t3 * (v_t * mu);
        let loss_tangential = Real::splat(2.0) * (p * (v_t * f_t));
        let loss = loss_radial + loss_tangential;
        at.write_field(12, loss);
        at.write_field(13, loss_radial);
        at.write_field(14, loss_tangential);
        let arc = r * reciprocal(cos_theta);
        let loss_phi = arc * loss;
        at.write_field(15, loss_phi);
    }
}
