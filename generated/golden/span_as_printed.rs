// span_as_printed: The free belt as Appendix C prints it: L² on the wrong side.
// Generated from eqgen/src/physics. Do not edit; `cargo run -p eqgen -- write` writes it anew.
// Operations per point, and once a batch:
//   value: 3 add, 7 mul, 1 div, 0 sqrt, 1 fn; once 15
//   jacobian: 11 add, 20 mul, 1 div, 0 sqrt, 1 fn; once 32
//   full: 22 add, 36 mul, 1 div, 0 sqrt, 1 fn; once 41
//   fields: 2 add, 5 mul, 0 div, 0 sqrt, 0 fn; once 13

///The free belt as Appendix C prints it: L² on the wrong side.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "span_as_printed",
    states: &[
        Symbol {
            name: "tau",
            symbol: "τ",
            unit: "N",
            doc: "tractive tension in a span",
        },
        Symbol {
            name: "vartheta",
            symbol: "ϑ",
            unit: "rad",
            doc: "direction of the belt in a span against the line of centres",
        },
        Symbol {
            name: "vartheta1",
            symbol: "ϑ\u{302}'",
            unit: "rad",
            doc: "first derivative of ϑ along the span",
        },
        Symbol {
            name: "vartheta2",
            symbol: "ϑ\u{302}''",
            unit: "rad",
            doc: "second derivative of ϑ along the span",
        },
    ],
    constants: &[
        Symbol {
            name: "L",
            symbol: "L",
            unit: "m",
            doc: "arc length of the span",
        },
        Symbol {
            name: "flow",
            symbol: "G/(m_o R_P ω_P)",
            unit: "",
            doc: "mass flow, over that of an unstretched belt at the primary's nominal speed",
        },
        Symbol {
            name: "EA",
            symbol: "EA",
            unit: "N",
            doc: "longitudinal stiffness",
        },
        Symbol {
            name: "EI",
            symbol: "EI",
            unit: "N·m²",
            doc: "bending stiffness",
        },
        Symbol {
            name: "m_o",
            symbol: "m_o",
            unit: "kg/m",
            doc: "mass per length, unloaded",
        },
        Symbol {
            name: "R_P",
            symbol: "R_P",
            unit: "m",
            doc: "nominal radius of the primary",
        },
        Symbol {
            name: "omega_P",
            symbol: "ω_P",
            unit: "rad/s",
            doc: "angular speed of the primary",
        },
    ],
    integrals: &[
        Symbol {
            name: "X",
            symbol: "X\u{302}",
            unit: "",
            doc: "progress along the line of centres over L",
        },
        Symbol {
            name: "Y",
            symbol: "Ŷ",
            unit: "",
            doc: "progress across the line of centres over L",
        },
        Symbol {
            name: "L_o",
            symbol: "L_o",
            unit: "m",
            doc: "unstretched length of the belt in the region",
        },
    ],
    fields: &[
        Symbol {
            name: "F",
            symbol: "F",
            unit: "N",
            doc: "belt tension",
        },
        Symbol {
            name: "V",
            symbol: "V",
            unit: "m/s",
            doc: "belt speed",
        },
        Symbol {
            name: "M_b",
            symbol: "M_b",
            unit: "N·m",
            doc: "bending moment",
        },
        Symbol {
            name: "Q",
            symbol: "Q",
            unit: "N",
            doc: "transverse shear force",
        },
    ],
    usual: 2,
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
    ],
    constant_pattern: &[
        (0, 0),
        (3, 0),
        (6, 0),
        (6, 1),
        (0, 3),
        (3, 3),
        (6, 2),
        (6, 4),
        (6, 5),
        (6, 6),
    ],
    usual_entries: 4,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
///Right-hand side and integrands. (3 add, 7 mul, 1 div, 0 sqrt, 1 fn; once 15)
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 7;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 7];
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
        let EI = constants[3];
        let L = constants[0];
        let u3 = EI * (L * L);
        let u4 = reciprocal(L);
        let u5 = u4 * u4 * reciprocal(EI);
        let u6 = L * EA;
        [EA, m_o, u1, u2, u3, u5, u6]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u1 = Real::splat(uniforms[2]);
        let u2 = Real::splat(uniforms[3]);
        let u3 = Real::splat(uniforms[4]);
        let u5 = Real::splat(uniforms[5]);
        let u6 = Real::splat(uniforms[6]);
        let vartheta1 = at.state::<Real>(2);
        let vartheta2 = at.state::<Real>(3);
        let tau_hat_1 = -(u3 * (vartheta1 * vartheta2));
        at.write_f(0, tau_hat_1);
        at.write_f(1, vartheta1);
        at.write_f(2, vartheta2);
        let tau = at.state::<Real>(0);
        let vartheta_hat_3 = u5 * (tau * vartheta1);
        at.write_f(3, vartheta_hat_3);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_f(5, sin_vartheta);
        let F = u2 * (u1 + m_o * tau);
        let L_o_hat_1 = u6 * reciprocal(EA + F);
        at.write_f(6, L_o_hat_1);
    }
}
///Right-hand side, integrands, and their derivatives in states and usual constants. (11 add, 20 mul, 1 div, 0 sqrt, 1 fn; once 32)
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 7;
    const DY: usize = 9;
    const DC: usize = 4;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 14];
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
        let u11 = omega_P * (m_o * R_P);
        let u12 = EA * G;
        let u13 = u3 * u3 * (2.0 * u12);
        let u14 = 2.0 * (u3 * u12);
        let u15 = 2.0 * (L * EI);
        let u16 = u6 * u7 * (u8 * 2.0);
        let u17 = L * reciprocal(EA);
        let u18 = u2 * u3 * u17;
        [EA, m_o, u1, u4, u5, u9, u10, u11, u13, u14, u15, u16, u17, u18]
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
        let u11 = Real::splat(uniforms[7]);
        let u13 = Real::splat(uniforms[8]);
        let u14 = Real::splat(uniforms[9]);
        let u15 = Real::splat(uniforms[10]);
        let u16 = Real::splat(uniforms[11]);
        let u17 = Real::splat(uniforms[12]);
        let u18 = Real::splat(uniforms[13]);
        let vartheta1 = at.state::<Real>(2);
        let vartheta2 = at.state::<Real>(3);
        let t1 = vartheta1 * vartheta2;
        let tau_hat_1 = -(u5 * t1);
        at.write_f(0, tau_hat_1);
        at.write_f(1, vartheta1);
        at.write_f(2, vartheta2);
        let tau = at.state::<Real>(0);
        let t2 = tau * vartheta1;
        let vartheta_hat_3 = u9 * t2;
        at.write_f(3, vartheta_hat_3);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_f(5, sin_vartheta);
        let t4 = u1 + m_o * tau;
        let F = u4 * t4;
        let t5 = reciprocal(EA + F);
        let L_o_hat_1 = u10 * t5;
        at.write_f(6, L_o_hat_1);
        let d_tau_hat_1_d_vartheta1 = -(u5 * vartheta2);
        at.write_dy(0, d_tau_hat_1_d_vartheta1);
        let d_tau_hat_1_d_vartheta2 = -(u5 * vartheta1);
        at.write_dy(1, d_tau_hat_1_d_vartheta2);
        at.write_dy(2, Real::splat(1.0));
        at.write_dy(3, Real::splat(1.0));
        let d_vartheta_hat_3_d_tau = u9 * vartheta1;
        at.write_dy(4, d_vartheta_hat_3_d_tau);
        let d_vartheta_hat_3_d_vartheta1 = u9 * tau;
        at.write_dy(5, d_vartheta_hat_3_d_vartheta1);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(6, d_X_hat_1_d_vartheta);
        at.write_dy(7, cos_vartheta);
        let d_L_o_hat_1_d_L = EA * t5;
        let t6 = d_L_o_hat_1_d_L * d_L_o_hat_1_d_L;
        let d_L_o_hat_1_d_tau = -(u18 * t6);
        at.write_dy(8, d_L_o_hat_1_d_tau);
        let d_tau_hat_1_d_L = -(u15 * t1);
        at.write_dc(0, d_tau_hat_1_d_L);
        let d_vartheta_hat_3_d_L = -(u16 * t2);
        at.write_dc(1, d_vartheta_hat_3_d_L);
        at.write_dc(2, d_L_o_hat_1_d_L);
        let d_L_o_hat_1_d_flow = -(u11 * (u13 * t4 + u14) * (u17 * t6));
        at.write_dc(3, d_L_o_hat_1_d_flow);
    }
}
///Right-hand side, integrands, and their derivatives in states and all constants. (22 add, 36 mul, 1 div, 0 sqrt, 1 fn; once 41)
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 7;
    const DY: usize = 9;
    const DC: usize = 10;
    const FIELDS: usize = 0;
    type Uniforms = [f64; 25];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let L = constants[0];
        let EA = constants[2];
        let m_o = constants[4];
        let R_P = constants[5];
        let flow = constants[1];
        let u1 = flow * m_o;
        let u2 = R_P * u1;
        let omega_P = constants[6];
        let G = omega_P * u2;
        let u3 = G * G;
        let u4 = EA * m_o;
        let u5 = reciprocal(u4 - u3);
        let u6 = EA * u5;
        let u7 = L * L;
        let EI = constants[3];
        let u8 = EI * u7;
        let u9 = reciprocal(L);
        let u10 = u9 * u9;
        let u11 = reciprocal(EI);
        let u12 = u10 * u11;
        let u13 = reciprocal(EA);
        let u14 = L * EA;
        let u15 = omega_P * u1;
        let u16 = omega_P * (m_o * R_P);
        let u17 = omega_P * (flow * R_P);
        let u18 = u5 * u5;
        let u19 = u4 * u18;
        let u20 = EA * G;
        let u21 = u18 * (2.0 * u20);
        let u22 = 2.0 * (u5 * u20);
        let u23 = u18 * (EA * EA);
        let u24 = 2.0 * (L * EI);
        let u25 = u10 * (u11 * u11);
        let u26 = u9 * u10 * (u11 * 2.0);
        let u27 = u13 * u13;
        let u28 = L * u13;
        let u29 = u4 * u5 * u28;
        [
            L,
            EA,
            m_o,
            u2,
            u3,
            u5,
            u6,
            u7,
            u8,
            u12,
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
            u25,
            u26,
            u27,
            u28,
            u29,
        ]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let L = Real::splat(uniforms[0]);
        let EA = Real::splat(uniforms[1]);
        let m_o = Real::splat(uniforms[2]);
        let u2 = Real::splat(uniforms[3]);
        let u3 = Real::splat(uniforms[4]);
        let u5 = Real::splat(uniforms[5]);
        let u6 = Real::splat(uniforms[6]);
        let u7 = Real::splat(uniforms[7]);
        let u8 = Real::splat(uniforms[8]);
        let u12 = Real::splat(uniforms[9]);
        let u13 = Real::splat(uniforms[10]);
        let u14 = Real::splat(uniforms[11]);
        let u15 = Real::splat(uniforms[12]);
        let u16 = Real::splat(uniforms[13]);
        let u17 = Real::splat(uniforms[14]);
        let u19 = Real::splat(uniforms[15]);
        let u21 = Real::splat(uniforms[16]);
        let u22 = Real::splat(uniforms[17]);
        let u23 = Real::splat(uniforms[18]);
        let u24 = Real::splat(uniforms[19]);
        let u25 = Real::splat(uniforms[20]);
        let u26 = Real::splat(uniforms[21]);
        let u27 = Real::splat(uniforms[22]);
        let u28 = Real::splat(uniforms[23]);
        let u29 = Real::splat(uniforms[24]);
        let vartheta1 = at.state::<Real>(2);
        let vartheta2 = at.state::<Real>(3);
        let t1 = vartheta1 * vartheta2;
        let tau_hat_1 = -(u8 * t1);
        at.write_f(0, tau_hat_1);
        at.write_f(1, vartheta1);
        at.write_f(2, vartheta2);
        let tau = at.state::<Real>(0);
        let t2 = tau * vartheta1;
        let vartheta_hat_3 = u12 * t2;
        at.write_f(3, vartheta_hat_3);
        let vartheta = at.state::<Real>(1);
        let (sin_vartheta, cos_vartheta) = sin_cos(vartheta);
        at.write_f(4, cos_vartheta);
        at.write_f(5, sin_vartheta);
        let t4 = u3 + m_o * tau;
        let F = u6 * t4;
        let t5 = EA + F;
        let t6 = reciprocal(t5);
        let L_o_hat_1 = u14 * t6;
        at.write_f(6, L_o_hat_1);
        let d_tau_hat_1_d_vartheta1 = -(u8 * vartheta2);
        at.write_dy(0, d_tau_hat_1_d_vartheta1);
        let d_tau_hat_1_d_vartheta2 = -(u8 * vartheta1);
        at.write_dy(1, d_tau_hat_1_d_vartheta2);
        at.write_dy(2, Real::splat(1.0));
        at.write_dy(3, Real::splat(1.0));
        let d_vartheta_hat_3_d_tau = u12 * vartheta1;
        at.write_dy(4, d_vartheta_hat_3_d_tau);
        let d_vartheta_hat_3_d_vartheta1 = u12 * tau;
        at.write_dy(5, d_vartheta_hat_3_d_vartheta1);
        let d_X_hat_1_d_vartheta = -sin_vartheta;
        at.write_dy(6, d_X_hat_1_d_vartheta);
        at.write_dy(7, cos_vartheta);
        let d_L_o_hat_1_d_L = EA * t6;
        let t7 = d_L_o_hat_1_d_L * d_L_o_hat_1_d_L;
        let d_L_o_hat_1_d_tau = -(u29 * t7);
        at.write_dy(8, d_L_o_hat_1_d_tau);
        let d_tau_hat_1_d_L = -(u24 * t1);
        at.write_dc(0, d_tau_hat_1_d_L);
        let d_vartheta_hat_3_d_L = -(u26 * t2);
        at.write_dc(1, d_vartheta_hat_3_d_L);
        at.write_dc(2, d_L_o_hat_1_d_L);
        let t8 = u28 * t7;
        let t9 = u21 * t4 + u22;
        let d_L_o_hat_1_d_flow = -(t8 * (u16 * t9));
        at.write_dc(3, d_L_o_hat_1_d_flow);
        let d_tau_hat_1_d_EI = -(u7 * t1);
        at.write_dc(4, d_tau_hat_1_d_EI);
        let d_vartheta_hat_3_d_EI = -(u25 * t2);
        at.write_dc(5, d_vartheta_hat_3_d_EI);
        let t10 = (u13 - u27 * t5) * (L * t7) + (u5 * t4 - u19 * t4) * t8;
        let d_L_o_hat_1_d_EA = -t10;
        at.write_dc(6, d_L_o_hat_1_d_EA);
        let d_L_o_hat_1_d_m_o = -(t8 * (u6 * tau - u23 * t4 + u17 * t9));
        at.write_dc(7, d_L_o_hat_1_d_m_o);
        let d_L_o_hat_1_d_R_P = -(t8 * (u15 * t9));
        at.write_dc(8, d_L_o_hat_1_d_R_P);
        let d_L_o_hat_1_d_omega_P = -(t8 * (u2 * t9));
        at.write_dc(9, d_L_o_hat_1_d_omega_P);
    }
}
///Derived fields. (2 add, 5 mul, 0 div, 0 sqrt, 0 fn; once 13)
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 4;
    const CONSTANTS: usize = 7;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 4;
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
        let u7 = G * u5;
        [EA, m_o, u2, u3, u4, u6, u7]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let EA = Real::splat(uniforms[0]);
        let m_o = Real::splat(uniforms[1]);
        let u2 = Real::splat(uniforms[2]);
        let u3 = Real::splat(uniforms[3]);
        let u4 = Real::splat(uniforms[4]);
        let u6 = Real::splat(uniforms[5]);
        let u7 = Real::splat(uniforms[6]);
        let tau = at.state::<Real>(0);
        let F = u6 * (u4 + m_o * tau);
        at.write_field(0, F);
        let V = u7 * (tau + EA);
        at.write_field(1, V);
        let vartheta1 = at.state::<Real>(2);
        let M_b = u2 * vartheta1;
        at.write_field(2, M_b);
        let vartheta2 = at.state::<Real>(3);
        let Q = u3 * vartheta2;
        at.write_field(3, Q);
    }
}
