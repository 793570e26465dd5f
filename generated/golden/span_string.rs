// span_string: The free belt without bending stiffness: a straight line.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 2 add, 3 mul, 1 div, 0 sqrt, 1 fn a point; 9 once
//   jacobian: 6 add, 9 mul, 1 div, 0 sqrt, 1 fn a point; 24 once
//   full: 15 add, 22 mul, 1 div, 0 sqrt, 1 fn a point; 32 once
//   fields: 2 add, 3 mul, 0 div, 0 sqrt, 0 fn a point; 9 once
// Equations, with their numbers in the source:
// - G (typed in): definition of the flow coefficient
// - F (derived): (3.10)
// - V (derived): (3.11)
// - M_b (typed in): a string carries no moment
// - Q (typed in): a string carries no moment
// - tau_hat_1 (typed in): a free string is straight, its tension constant
// - vartheta_hat_1 (typed in): a free string is straight, its tension constant
// - stretch (typed in): (3.9)
// - X_hat_1 (typed in): (5.25)
// - Y_hat_1 (typed in): (5.26)
// - L_o_hat_1 (typed in): (5.56)
// - V_T (derived): (3.11)
// - stored (typed in): energy of bending
// - E_hat_1 (typed in): energy

///The free belt without bending stiffness: a straight line.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "span_string",
    states: &[State::SpanTension, State::Direction],
    constants: &[
        RegionConstant::SpanLength,
        RegionConstant::Flow,
        RegionConstant::LongitudinalStiffness,
        RegionConstant::BendingStiffness,
        RegionConstant::MassPerLength,
        RegionConstant::PrimaryRadius,
        RegionConstant::PrimarySpeed,
    ],
    integrals: &[
        Integral::PositionAlong,
        Integral::PositionAcross,
        Integral::UnstretchedLength,
        Integral::StrainEnergyFlux,
    ],
    fields: &[Field::BeltTension, Field::BeltSpeed, Field::BendingMoment, Field::Shear],
    default_unknowns: 2,
    state_pattern: &[(2, 1), (3, 1), (4, 0)],
    constant_pattern: &[(4, 0), (4, 1), (4, 2), (4, 4), (4, 5), (4, 6)],
    default_entries: 2,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
/// Right-hand side and integrands.
///
/// 2 add, 3 mul, 1 div, 0 sqrt, 1 fn a point; 9 once.
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 2;
    const CONSTANTS: usize = 7;
    const F: usize = 6;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 5];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[2];
        let m_o = constants[4];
        let omega_P = constants[6];
        let R_P = constants[5];
        let flow = constants[1];
        let G = omega_P * (R_P * (flow * m_o));
        let u1 = G * G;
        let u2 = EA * reciprocal(EA * m_o - u1);
        let L = constants[0];
        let u3 = L * EA;
        [EA, m_o, u1, u2, u3]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u2 = Real::splat(uniforms[3]);
        let u3 = Real::splat(uniforms[4]);
        at.write_f(0, Real::splat(0.0));
        at.write_f(1, Real::splat(0.0));
        at.write_f(5, Real::splat(0.0));
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(2, cos_vartheta);
        at.write_f(3, sin_vartheta);
        let tau = at.state::<Real>(0);
        let F = u2 * (u1 + m_o * tau);
        let L_o_hat_1 = u3 * reciprocal(EA + F);
        at.write_f(4, L_o_hat_1);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 6 add, 9 mul, 1 div, 0 sqrt, 1 fn a point; 24 once.
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 2;
    const CONSTANTS: usize = 7;
    const F: usize = 6;
    const DY: usize = 3;
    const DC: usize = 2;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 9];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[2];
        let m_o = constants[4];
        let omega_P = constants[6];
        let R_P = constants[5];
        let flow = constants[1];
        let G = omega_P * (R_P * (flow * m_o));
        let u1 = G * G;
        let u2 = EA * m_o;
        let u3 = reciprocal(u2 - u1);
        let u4 = EA * u3;
        let L = constants[0];
        let u5 = L * EA;
        let u6 = EA * G;
        let u7 = 2.0 * (u3 * u3 * u6);
        let u8 = 2.0 * (u3 * u6);
        let u9 = reciprocal(EA) * (L * (EA * EA));
        let u10 = u2 * u3 * u9;
        let u11 = omega_P * (m_o * R_P) * u9;
        [EA, m_o, u1, u4, u5, u7, u8, u10, u11]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u4 = Real::splat(uniforms[3]);
        let u5 = Real::splat(uniforms[4]);
        let u7 = Real::splat(uniforms[5]);
        let u8 = Real::splat(uniforms[6]);
        let u10 = Real::splat(uniforms[7]);
        let u11 = Real::splat(uniforms[8]);
        at.write_f(0, Real::splat(0.0));
        at.write_f(1, Real::splat(0.0));
        at.write_f(5, Real::splat(0.0));
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(2, cos_vartheta);
        at.write_dy(1, cos_vartheta);
        at.write_f(3, sin_vartheta);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(0, d_X_hat_1_d_vartheta);
        let tau = at.state::<Real>(0);
        let t2 = u1 + m_o * tau;
        let F = u4 * t2;
        let t3 = reciprocal(EA + F);
        let L_o_hat_1 = u5 * t3;
        at.write_f(4, L_o_hat_1);
        let t4 = t3 * t3;
        let d_L_o_hat_1_d_flow = -(u11 * ((u7 * t2 + u8) * t4));
        at.write_dc(1, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_tau = -(u10 * t4);
        at.write_dy(2, d_L_o_hat_1_d_tau);
        let d_L_o_hat_1_d_L = EA * t3;
        at.write_dc(0, d_L_o_hat_1_d_L);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 15 add, 22 mul, 1 div, 0 sqrt, 1 fn a point; 32 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 2;
    const CONSTANTS: usize = 7;
    const F: usize = 6;
    const DY: usize = 3;
    const DC: usize = 6;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 19];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[2];
        let m_o = constants[4];
        let omega_P = constants[6];
        let R_P = constants[5];
        let flow = constants[1];
        let u1 = flow * m_o;
        let u2 = R_P * u1;
        let G = omega_P * u2;
        let u3 = G * G;
        let u4 = EA * m_o;
        let u5 = reciprocal(u4 - u3);
        let u6 = EA * u5;
        let u7 = reciprocal(EA);
        let L = constants[0];
        let u8 = L * EA;
        let u9 = omega_P * (flow * R_P);
        let u10 = u5 * u5;
        let u11 = u4 * u10;
        let u12 = EA * G;
        let u13 = 2.0 * (u10 * u12);
        let u14 = 2.0 * (u5 * u12);
        let u15 = EA * EA;
        let u16 = u10 * u15;
        let u17 = u7 * u7;
        let u18 = L * u15;
        let u19 = u7 * u18;
        let u20 = u4 * u5 * u19;
        let u21 = omega_P * (m_o * R_P) * u19;
        let u22 = omega_P * u1 * u19;
        let u23 = u2 * u19;
        [
            EA,
            m_o,
            u3,
            u5,
            u6,
            u7,
            u8,
            u9,
            u11,
            u13,
            u14,
            u16,
            u17,
            u18,
            u19,
            u20,
            u21,
            u22,
            u23,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u3 = Real::splat(uniforms[2]);
        let u5 = Real::splat(uniforms[3]);
        let u6 = Real::splat(uniforms[4]);
        let u7 = Real::splat(uniforms[5]);
        let u8 = Real::splat(uniforms[6]);
        let u9 = Real::splat(uniforms[7]);
        let u11 = Real::splat(uniforms[8]);
        let u13 = Real::splat(uniforms[9]);
        let u14 = Real::splat(uniforms[10]);
        let u16 = Real::splat(uniforms[11]);
        let u17 = Real::splat(uniforms[12]);
        let u18 = Real::splat(uniforms[13]);
        let u19 = Real::splat(uniforms[14]);
        let u20 = Real::splat(uniforms[15]);
        let u21 = Real::splat(uniforms[16]);
        let u22 = Real::splat(uniforms[17]);
        let u23 = Real::splat(uniforms[18]);
        at.write_f(0, Real::splat(0.0));
        at.write_f(1, Real::splat(0.0));
        at.write_f(5, Real::splat(0.0));
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(2, cos_vartheta);
        at.write_dy(1, cos_vartheta);
        at.write_f(3, sin_vartheta);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(0, d_X_hat_1_d_vartheta);
        let tau = at.state::<Real>(0);
        let t2 = u3 + m_o * tau;
        let F = u6 * t2;
        let t3 = EA + F;
        let t4 = reciprocal(t3);
        let L_o_hat_1 = u8 * t4;
        at.write_f(4, L_o_hat_1);
        let t5 = t4 * t4;
        let d_L_o_hat_1_d_L = EA * t4;
        at.write_dc(0, d_L_o_hat_1_d_L);
        let d_L_o_hat_1_d_tau = -(u20 * t5);
        at.write_dy(2, d_L_o_hat_1_d_tau);
        let t6 = u19 * t5;
        let t7 = (u7 - u17 * t3) * (u18 * t5) + (u5 * t2 - u11 * t2) * t6;
        let d_L_o_hat_1_d_EA = -t7;
        at.write_dc(2, d_L_o_hat_1_d_EA);
        let t8 = u13 * t2 + u14;
        let d_L_o_hat_1_d_m_o = -(t6 * (u6 * tau - u16 * t2 + u9 * t8));
        at.write_dc(3, d_L_o_hat_1_d_m_o);
        let t9 = t8 * t5;
        let d_L_o_hat_1_d_flow = -(u21 * t9);
        at.write_dc(1, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u22 * t9);
        at.write_dc(4, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u23 * t9);
        at.write_dc(5, d_L_o_hat_1_d_omega_P);
    }
}
/// Derived fields.
///
/// 2 add, 3 mul, 0 div, 0 sqrt, 0 fn a point; 9 once.
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 2;
    const CONSTANTS: usize = 7;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 4;
    const WIDE: bool = false;
    type Uniforms = [f64; 5];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[2];
        let m_o = constants[4];
        let omega_P = constants[6];
        let R_P = constants[5];
        let flow = constants[1];
        let G = omega_P * (R_P * (flow * m_o));
        let u1 = G * G;
        let u2 = reciprocal(EA * m_o - u1);
        let u3 = EA * u2;
        let V_T = G * u2;
        [EA, m_o, u1, u3, V_T]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u3 = Real::splat(uniforms[3]);
        let V_T = Real::splat(uniforms[4]);
        at.write_field(2, Real::splat(0.0));
        at.write_field(3, Real::splat(0.0));
        let tau = at.state::<Real>(0);
        let F = u3 * (u1 + m_o * tau);
        at.write_field(0, F);
        let V = V_T * (tau + EA);
        at.write_field(1, V);
    }
}
