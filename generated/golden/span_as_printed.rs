// span_as_printed: The free belt as Appendix C prints it: L² on the wrong side.
// Generated from eqgen/src/physics. Do not edit:
// `cargo run -p sheave-eqgen -- write` writes it anew.
// Operations:
//   value: 4 add, 10 mul, 1 div, 0 sqrt, 1 fn a point; 22 once
//   jacobian: 17 add, 31 mul, 1 div, 0 sqrt, 1 fn a point; 58 once
//   full: 34 add, 55 mul, 1 div, 0 sqrt, 1 fn a point; 86 once
//   fields: 2 add, 5 mul, 0 div, 0 sqrt, 0 fn a point; 13 once
// Equations, with their numbers in the source:
// - vartheta_1 (typed in): (5.10)
// - vartheta_2 (typed in): (5.11)
// - M_b (typed in): (3.26)
// - Q (typed in): (3.43)
// - G (typed in): definition of the flow coefficient
// - F (derived): (3.10)
// - V (derived): (3.11)
// - tau_hat_1 (as printed): (C) rhs(21)
// - vartheta_hat_3 (as printed): (C) rhs(24)
// - stretch (typed in): (3.9)
// - X_hat_1 (typed in): (5.25)
// - Y_hat_1 (typed in): (5.26)
// - L_o_hat_1 (typed in): (5.56)
// - V_T (derived): (3.11)
// - stored (typed in): energy of bending
// - E_hat_1 (typed in): energy

///The free belt as Appendix C prints it: L² on the wrong side.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "span_as_printed",
    states: &[
        State::SpanTension,
        State::Direction,
        State::DirectionDerivative,
        State::DirectionSecondDerivative,
    ],
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
    state_pattern: &[
        (0, 2),
        (0, 3),
        (1, 2),
        (2, 3),
        (3, 0),
        (3, 2),
        (4, 1),
        (5, 1),
        (6, 0),
        (7, 2),
        (7, 3),
    ],
    constant_pattern: &[
        (0, 0),
        (3, 0),
        (6, 0),
        (6, 1),
        (7, 0),
        (7, 1),
        (0, 3),
        (3, 3),
        (6, 2),
        (6, 4),
        (6, 5),
        (6, 6),
        (7, 2),
        (7, 3),
        (7, 4),
        (7, 5),
        (7, 6),
    ],
    default_entries: 6,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
/// Right-hand side and integrands.
///
/// 4 add, 10 mul, 1 div, 0 sqrt, 1 fn a point; 22 once.
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 8;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 8];
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
        let EI = constants[3];
        let L = constants[0];
        let u4 = EI * (L * L);
        let u5 = reciprocal(L);
        let u6 = reciprocal(EI);
        let u7 = u5 * u5 * u6;
        let u8 = L * EA;
        let V_T = G * u2;
        let u9 = EI * u5;
        let u10 = V_T * (u4 * (u9 * u9 * (u6 * 0.5)));
        [EA, m_o, u1, u3, u4, u7, u8, u10]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u3 = Real::splat(uniforms[3]);
        let u4 = Real::splat(uniforms[4]);
        let u7 = Real::splat(uniforms[5]);
        let u8 = Real::splat(uniforms[6]);
        let u10 = Real::splat(uniforms[7]);
        let vartheta1 = at.state::<Real>(2);
        at.write_f(1, vartheta1);
        let vartheta2 = at.state::<Real>(3);
        at.write_f(2, vartheta2);
        let t1 = vartheta1 * vartheta2;
        let tau_hat_1 = -(u4 * t1);
        at.write_f(0, tau_hat_1);
        let E_hat_1 = -(u10 * (t1 * (vartheta1 * vartheta1)));
        at.write_f(7, E_hat_1);
        let tau = at.state::<Real>(0);
        let vartheta_hat_3 = u7 * (tau * vartheta1);
        at.write_f(3, vartheta_hat_3);
        let F = u3 * (u1 + m_o * tau);
        let L_o_hat_1 = u8 * reciprocal(EA + F);
        at.write_f(6, L_o_hat_1);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_f(5, sin_vartheta);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 17 add, 31 mul, 1 div, 0 sqrt, 1 fn a point; 58 once.
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 8;
    const DY: usize = 11;
    const DC: usize = 6;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 19];
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
        let EI = constants[3];
        let L = constants[0];
        let u5 = EI * (L * L);
        let u6 = reciprocal(L);
        let u7 = u6 * u6;
        let u8 = reciprocal(EI);
        let u9 = u7 * u8;
        let u10 = L * EA;
        let V_T = G * u3;
        let u11 = EI * u6;
        let u12 = u11 * u11 * (u8 * 0.5);
        let u13 = u5 * u12;
        let u14 = V_T * u13;
        let u15 = u3 * u3;
        let u16 = EA * G;
        let u17 = u15 * (2.0 * u16);
        let u18 = 2.0 * (u3 * u16);
        let u19 = 2.0 * (L * EI);
        let u20 = u6 * u7 * (u8 * 2.0);
        let u21 = V_T * u12;
        let u22 = u5 * u21;
        let u23 = u19 * u21;
        let u24 = L * (EA * EA);
        let u25 = reciprocal(EA);
        let u26 = u24 * (u25 * (u2 * u3));
        let u27 = omega_P * (m_o * R_P);
        let u28 = u24 * (u25 * u27);
        let u29 = u13 * (u27 * (u3 + u15 * (u1 * 2.0)));
        let u30 = V_T * u5;
        let u31 = u11 * u8;
        let u32 = u30 * (u11 * u31);
        let u33 = u30 * (EI * u7 * u31);
        [
            EA,
            m_o,
            u1,
            u4,
            u5,
            u9,
            u10,
            u14,
            u17,
            u18,
            u19,
            u20,
            u22,
            u23,
            u26,
            u28,
            u29,
            u32,
            u33,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u4 = Real::splat(uniforms[3]);
        let u5 = Real::splat(uniforms[4]);
        let u9 = Real::splat(uniforms[5]);
        let u10 = Real::splat(uniforms[6]);
        let u14 = Real::splat(uniforms[7]);
        let u17 = Real::splat(uniforms[8]);
        let u18 = Real::splat(uniforms[9]);
        let u19 = Real::splat(uniforms[10]);
        let u20 = Real::splat(uniforms[11]);
        let u22 = Real::splat(uniforms[12]);
        let u23 = Real::splat(uniforms[13]);
        let u26 = Real::splat(uniforms[14]);
        let u28 = Real::splat(uniforms[15]);
        let u29 = Real::splat(uniforms[16]);
        let u32 = Real::splat(uniforms[17]);
        let u33 = Real::splat(uniforms[18]);
        at.write_dy(2, Real::splat(1.0));
        at.write_dy(3, Real::splat(1.0));
        let vartheta1 = at.state::<Real>(2);
        at.write_f(1, vartheta1);
        let t1 = vartheta1 * vartheta1;
        let d_E_hat_1_d_vartheta2 = -(u22 * (vartheta1 * t1));
        at.write_dy(10, d_E_hat_1_d_vartheta2);
        let d_tau_hat_1_d_vartheta2 = -(u5 * vartheta1);
        at.write_dy(1, d_tau_hat_1_d_vartheta2);
        let d_vartheta_hat_3_d_tau = u9 * vartheta1;
        at.write_dy(4, d_vartheta_hat_3_d_tau);
        let vartheta2 = at.state::<Real>(3);
        at.write_f(2, vartheta2);
        let t2 = vartheta1 * vartheta2;
        let tau_hat_1 = -(u5 * t2);
        at.write_f(0, tau_hat_1);
        let t3 = t2 * t1;
        let d_E_hat_1_d_vartheta1 = -(u22 * (vartheta2 * t1) + u32 * (vartheta1 * t2));
        at.write_dy(9, d_E_hat_1_d_vartheta1);
        let d_tau_hat_1_d_L = -(u19 * t2);
        at.write_dc(0, d_tau_hat_1_d_L);
        let d_tau_hat_1_d_vartheta1 = -(u5 * vartheta2);
        at.write_dy(0, d_tau_hat_1_d_vartheta1);
        let E_hat_1 = -(u14 * t3);
        at.write_f(7, E_hat_1);
        let d_E_hat_1_d_L = u33 * t3 - u23 * t3;
        at.write_dc(4, d_E_hat_1_d_L);
        let d_E_hat_1_d_flow = -(u29 * t3);
        at.write_dc(5, d_E_hat_1_d_flow);
        let tau = at.state::<Real>(0);
        let t4 = tau * vartheta1;
        let vartheta_hat_3 = u9 * t4;
        at.write_f(3, vartheta_hat_3);
        let d_vartheta_hat_3_d_L = -(u20 * t4);
        at.write_dc(1, d_vartheta_hat_3_d_L);
        let t5 = u1 + m_o * tau;
        let d_vartheta_hat_3_d_vartheta1 = u9 * tau;
        at.write_dy(5, d_vartheta_hat_3_d_vartheta1);
        let F = u4 * t5;
        let t6 = reciprocal(EA + F);
        let L_o_hat_1 = u10 * t6;
        at.write_f(6, L_o_hat_1);
        let t7 = t6 * t6;
        let d_L_o_hat_1_d_flow = -(u28 * ((u17 * t5 + u18) * t7));
        at.write_dc(3, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_tau = -(u26 * t7);
        at.write_dy(8, d_L_o_hat_1_d_tau);
        let d_L_o_hat_1_d_L = EA * t6;
        at.write_dc(2, d_L_o_hat_1_d_L);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_dy(7, cos_vartheta);
        at.write_f(5, sin_vartheta);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(6, d_X_hat_1_d_vartheta);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 34 add, 55 mul, 1 div, 0 sqrt, 1 fn a point; 86 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 8;
    const DY: usize = 11;
    const DC: usize = 17;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 39];
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
        let L = constants[0];
        let u7 = L * L;
        let EI = constants[3];
        let u8 = EI * u7;
        let u9 = reciprocal(L);
        let u10 = u9 * u9;
        let u11 = reciprocal(EI);
        let u12 = u10 * u11;
        let u13 = reciprocal(EA);
        let u14 = L * EA;
        let V_T = G * u5;
        let u15 = EI * u9;
        let u16 = u15 * u15;
        let u17 = u16 * (u11 * 0.5);
        let u18 = u8 * u17;
        let u19 = V_T * u18;
        let u20 = omega_P * (flow * R_P);
        let u21 = u5 * u5;
        let u22 = u4 * u21;
        let u23 = EA * G;
        let u24 = u21 * (2.0 * u23);
        let u25 = 2.0 * (u5 * u23);
        let u26 = EA * EA;
        let u27 = u21 * u26;
        let u28 = 2.0 * (L * EI);
        let u29 = u11 * u11;
        let u30 = u10 * u29;
        let u31 = u9 * u10 * (u11 * 2.0);
        let u32 = u13 * u13;
        let u33 = L * u26;
        let u34 = u16 * (0.5 * u29);
        let u35 = V_T * u8;
        let u36 = u15 * u11;
        let u37 = u9 * u36;
        let u38 = V_T * u17;
        let u39 = u8 * u38;
        let u40 = u28 * u38;
        let u41 = u7 * u38;
        let u42 = u33 * (u13 * (u4 * u5));
        let u43 = omega_P * (m_o * R_P);
        let u44 = u33 * (u13 * u43);
        let u45 = u13 * u33;
        let u46 = omega_P * u1;
        let u47 = u33 * (u13 * u46);
        let u48 = u33 * (u2 * u13);
        let u49 = u5 + u21 * (u3 * 2.0);
        let u50 = u18 * (u43 * u49);
        let u51 = u18 * (u21 * (m_o * G));
        let u52 = u18 * (u20 * u49 - u21 * u23);
        let u53 = u18 * (u46 * u49);
        let u54 = u18 * (u2 * u49);
        let u55 = u35 * (u15 * u36);
        let u56 = u35 * (EI * u10 * u36);
        [
            EA,
            m_o,
            u3,
            u5,
            u6,
            u7,
            u8,
            u12,
            u13,
            u14,
            u19,
            u20,
            u22,
            u24,
            u25,
            u27,
            u28,
            u30,
            u31,
            u32,
            u33,
            u34,
            u35,
            u37,
            u39,
            u40,
            u41,
            u42,
            u44,
            u45,
            u47,
            u48,
            u50,
            u51,
            u52,
            u53,
            u54,
            u55,
            u56,
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
        let u12 = Real::splat(uniforms[7]);
        let u13 = Real::splat(uniforms[8]);
        let u14 = Real::splat(uniforms[9]);
        let u19 = Real::splat(uniforms[10]);
        let u20 = Real::splat(uniforms[11]);
        let u22 = Real::splat(uniforms[12]);
        let u24 = Real::splat(uniforms[13]);
        let u25 = Real::splat(uniforms[14]);
        let u27 = Real::splat(uniforms[15]);
        let u28 = Real::splat(uniforms[16]);
        let u30 = Real::splat(uniforms[17]);
        let u31 = Real::splat(uniforms[18]);
        let u32 = Real::splat(uniforms[19]);
        let u33 = Real::splat(uniforms[20]);
        let u34 = Real::splat(uniforms[21]);
        let u35 = Real::splat(uniforms[22]);
        let u37 = Real::splat(uniforms[23]);
        let u39 = Real::splat(uniforms[24]);
        let u40 = Real::splat(uniforms[25]);
        let u41 = Real::splat(uniforms[26]);
        let u42 = Real::splat(uniforms[27]);
        let u44 = Real::splat(uniforms[28]);
        let u45 = Real::splat(uniforms[29]);
        let u47 = Real::splat(uniforms[30]);
        let u48 = Real::splat(uniforms[31]);
        let u50 = Real::splat(uniforms[32]);
        let u51 = Real::splat(uniforms[33]);
        let u52 = Real::splat(uniforms[34]);
        let u53 = Real::splat(uniforms[35]);
        let u54 = Real::splat(uniforms[36]);
        let u55 = Real::splat(uniforms[37]);
        let u56 = Real::splat(uniforms[38]);
        at.write_dy(2, Real::splat(1.0));
        at.write_dy(3, Real::splat(1.0));
        let vartheta1 = at.state::<Real>(2);
        at.write_f(1, vartheta1);
        let t1 = vartheta1 * vartheta1;
        let d_E_hat_1_d_vartheta2 = -(u39 * (vartheta1 * t1));
        at.write_dy(10, d_E_hat_1_d_vartheta2);
        let d_tau_hat_1_d_vartheta2 = -(u8 * vartheta1);
        at.write_dy(1, d_tau_hat_1_d_vartheta2);
        let d_vartheta_hat_3_d_tau = u12 * vartheta1;
        at.write_dy(4, d_vartheta_hat_3_d_tau);
        let vartheta2 = at.state::<Real>(3);
        at.write_f(2, vartheta2);
        let t2 = vartheta1 * vartheta2;
        let tau_hat_1 = -(u8 * t2);
        at.write_f(0, tau_hat_1);
        let t3 = t2 * t1;
        let E_hat_1 = -(u19 * t3);
        at.write_f(7, E_hat_1);
        let d_E_hat_1_d_L = u56 * t3 - u40 * t3;
        at.write_dc(4, d_E_hat_1_d_L);
        let d_E_hat_1_d_flow = -(u50 * t3);
        at.write_dc(5, d_E_hat_1_d_flow);
        let d_E_hat_1_d_EA = u51 * t3;
        at.write_dc(12, d_E_hat_1_d_EA);
        let d_E_hat_1_d_EI = -(u41 * t3 + u35 * t2 * (u37 * t1 - u34 * t1));
        at.write_dc(13, d_E_hat_1_d_EI);
        let d_E_hat_1_d_vartheta1 = -(u39 * (vartheta2 * t1) + u55 * (vartheta1 * t2));
        at.write_dy(9, d_E_hat_1_d_vartheta1);
        let d_tau_hat_1_d_vartheta1 = -(u8 * vartheta2);
        at.write_dy(0, d_tau_hat_1_d_vartheta1);
        let d_E_hat_1_d_m_o = -(u52 * t3);
        at.write_dc(14, d_E_hat_1_d_m_o);
        let d_E_hat_1_d_R_P = -(u53 * t3);
        at.write_dc(15, d_E_hat_1_d_R_P);
        let d_E_hat_1_d_omega_P = -(u54 * t3);
        at.write_dc(16, d_E_hat_1_d_omega_P);
        let d_tau_hat_1_d_L = -(u28 * t2);
        at.write_dc(0, d_tau_hat_1_d_L);
        let d_tau_hat_1_d_EI = -(u7 * t2);
        at.write_dc(6, d_tau_hat_1_d_EI);
        let tau = at.state::<Real>(0);
        let t4 = tau * vartheta1;
        let vartheta_hat_3 = u12 * t4;
        at.write_f(3, vartheta_hat_3);
        let d_vartheta_hat_3_d_L = -(u31 * t4);
        at.write_dc(1, d_vartheta_hat_3_d_L);
        let d_vartheta_hat_3_d_EI = -(u30 * t4);
        at.write_dc(7, d_vartheta_hat_3_d_EI);
        let t5 = u3 + m_o * tau;
        let F = u6 * t5;
        let t6 = EA + F;
        let t7 = reciprocal(t6);
        let L_o_hat_1 = u14 * t7;
        at.write_f(6, L_o_hat_1);
        let t8 = t7 * t7;
        let t9 = u33 * t8 * (u13 - u32 * t6 + u13 * (u5 * t5 - u22 * t5));
        let d_L_o_hat_1_d_EA = -t9;
        at.write_dc(8, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_L = EA * t7;
        at.write_dc(2, d_L_o_hat_1_d_L);
        let d_L_o_hat_1_d_tau = -(u42 * t8);
        at.write_dy(8, d_L_o_hat_1_d_tau);
        let t10 = u24 * t5 + u25;
        let d_L_o_hat_1_d_m_o = -(u45 * (t8 * (u6 * tau - u27 * t5 + u20 * t10)));
        at.write_dc(9, d_L_o_hat_1_d_m_o);
        let t11 = t10 * t8;
        let d_vartheta_hat_3_d_vartheta1 = u12 * tau;
        at.write_dy(5, d_vartheta_hat_3_d_vartheta1);
        let d_L_o_hat_1_d_flow = -(u44 * t11);
        at.write_dc(3, d_L_o_hat_1_d_flow);
        let d_L_o_hat_1_d_R_P = -(u47 * t11);
        at.write_dc(10, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(u48 * t11);
        at.write_dc(11, d_L_o_hat_1_d_omega_P);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_dy(7, cos_vartheta);
        at.write_f(5, sin_vartheta);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(6, d_X_hat_1_d_vartheta);
    }
}
/// Derived fields.
///
/// 2 add, 5 mul, 0 div, 0 sqrt, 0 fn a point; 13 once.
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 4;
    const WIDE: bool = false;
    type Uniforms = [f64; 7];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EA = constants[2];
        let m_o = constants[4];
        let EI = constants[3];
        let L = constants[0];
        let u1 = reciprocal(L);
        let u2 = EI * u1;
        let u3 = EI * (u1 * u1);
        let omega_P = constants[6];
        let R_P = constants[5];
        let flow = constants[1];
        let G = omega_P * (R_P * (flow * m_o));
        let u4 = G * G;
        let u5 = reciprocal(EA * m_o - u4);
        let u6 = EA * u5;
        let V_T = G * u5;
        [EA, m_o, u2, u3, u4, u6, V_T]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u2 = Real::splat(uniforms[2]);
        let u3 = Real::splat(uniforms[3]);
        let u4 = Real::splat(uniforms[4]);
        let u6 = Real::splat(uniforms[5]);
        let V_T = Real::splat(uniforms[6]);
        let tau = at.state::<Real>(0);
        let F = u6 * (u4 + m_o * tau);
        at.write_field(0, F);
        let V = V_T * (tau + EA);
        at.write_field(1, V);
        let vartheta1 = at.state::<Real>(2);
        let M_b = u2 * vartheta1;
        at.write_field(2, M_b);
        let vartheta2 = at.state::<Real>(3);
        let Q = u3 * vartheta2;
        at.write_field(3, Q);
    }
}
