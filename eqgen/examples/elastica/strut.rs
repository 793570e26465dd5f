// strut: A thin elastic strut under a load at its ends.
// Generated from eqgen/examples/elastica/equations.rs. Do not edit:
// `cargo run -p sheave-eqgen --example elastica_write` writes it anew.
// Operations:
//   value: 1 add, 1 mul, 0 div, 0 sqrt, 1 fn a point; 4 once
//   jacobian: 4 add, 3 mul, 0 div, 0 sqrt, 1 fn a point; 5 once
//   full: 5 add, 5 mul, 0 div, 0 sqrt, 1 fn a point; 10 once
//   fields: 0 add, 1 mul, 0 div, 0 sqrt, 0 fn a point; 2 once
// Equations, with their numbers in the source:
// - kappa (typed in): definition
// - M (typed in): Bernoulli and Euler
// - kappa_s (derived): equilibrium of moments
// - theta_hat_2 (typed in): definition
// - X_hat_1 (typed in): definition
// - Y_hat_1 (typed in): definition

///A thin elastic strut under a load at its ends.
pub(crate) const KERNEL: RegionKernel = RegionKernel {
    name: "strut",
    states: &[State::Direction, State::DirectionDerivative],
    constants: &[
        RegionConstant::Load,
        RegionConstant::Length,
        RegionConstant::BendingStiffness,
    ],
    integrals: &[Integral::DistanceAlong, Integral::DistanceAcross],
    fields: &[Field::BendingMoment],
    default_unknowns: 1,
    state_pattern: &[(0, 1), (1, 0), (2, 0), (3, 0)],
    constant_pattern: &[(1, 0), (1, 1), (1, 2)],
    default_entries: 1,
    value: sweep::<Value>,
    jacobian: sweep::<Derivatives>,
    full: sweep::<AllDerivatives>,
    fields_fn: sweep::<Fields>,
};
/// Right-hand side and integrands.
///
/// 1 add, 1 mul, 0 div, 0 sqrt, 1 fn a point; 4 once.
pub(crate) struct Value;
impl Sweep for Value {
    const STATES: usize = 2;
    const CONSTANTS: usize = 3;
    const F: usize = 4;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 1];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let P = constants[0];
        let EI = constants[2];
        let L = constants[1];
        let u1 = P * reciprocal(EI) * (L * L);
        [u1]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let u1 = Real::splat(uniforms[0]);
        let theta1 = at.state::<Real>(1);
        at.write_f(0, theta1);
        let theta = at.state::<Real>(0);
        let (sin_theta, cos_theta) = sin_cos(theta);
        at.write_f(2, cos_theta);
        at.write_f(3, sin_theta);
        let theta_hat_2 = -(u1 * sin_theta);
        at.write_f(1, theta_hat_2);
    }
}
/// Right-hand side, integrands, and their derivatives in states and default unknowns.
///
/// 4 add, 3 mul, 0 div, 0 sqrt, 1 fn a point; 5 once.
pub(crate) struct Derivatives;
impl Sweep for Derivatives {
    const STATES: usize = 2;
    const CONSTANTS: usize = 3;
    const F: usize = 4;
    const DY: usize = 4;
    const DC: usize = 1;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = [f64; 2];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let P = constants[0];
        let EI = constants[2];
        let u1 = reciprocal(EI);
        let L = constants[1];
        let u2 = L * L;
        let u3 = P * u1 * u2;
        let u4 = u1 * u2;
        [u3, u4]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let u3 = Real::splat(uniforms[0]);
        let u4 = Real::splat(uniforms[1]);
        at.write_dy(0, Real::splat(1.0));
        let theta1 = at.state::<Real>(1);
        at.write_f(0, theta1);
        let theta = at.state::<Real>(0);
        let (sin_theta, cos_theta) = sin_cos(theta);
        at.write_f(2, cos_theta);
        at.write_f(3, sin_theta);
        at.write_dy(3, cos_theta);
        let d_theta_hat_2_d_theta = -(u3 * cos_theta);
        at.write_dy(1, d_theta_hat_2_d_theta);
        let theta_hat_2 = -(u3 * sin_theta);
        at.write_f(1, theta_hat_2);
        let d_X_hat_1_d_theta = -sin_theta;
        at.write_dy(2, d_X_hat_1_d_theta);
        let d_theta_hat_2_d_P = -(u4 * sin_theta);
        at.write_dc(0, d_theta_hat_2_d_P);
    }
}
/// Right-hand side, integrands, and their derivatives in states and all constants.
///
/// 5 add, 5 mul, 0 div, 0 sqrt, 1 fn a point; 10 once.
pub(crate) struct AllDerivatives;
impl Sweep for AllDerivatives {
    const STATES: usize = 2;
    const CONSTANTS: usize = 3;
    const F: usize = 4;
    const DY: usize = 4;
    const DC: usize = 3;
    const FIELDS: usize = 0;
    const WIDE: bool = false;
    type Uniforms = [f64; 4];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let P = constants[0];
        let EI = constants[2];
        let u1 = reciprocal(EI);
        let u2 = P * u1;
        let L = constants[1];
        let u3 = L * L;
        let u4 = u2 * u3;
        let u5 = u2 * (L * 2.0);
        let u6 = u1 * u3;
        let u7 = u3 * (P * (u1 * u1));
        [u4, u5, u6, u7]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let u4 = Real::splat(uniforms[0]);
        let u5 = Real::splat(uniforms[1]);
        let u6 = Real::splat(uniforms[2]);
        let u7 = Real::splat(uniforms[3]);
        at.write_dy(0, Real::splat(1.0));
        let theta1 = at.state::<Real>(1);
        at.write_f(0, theta1);
        let theta = at.state::<Real>(0);
        let (sin_theta, cos_theta) = sin_cos(theta);
        at.write_f(2, cos_theta);
        at.write_f(3, sin_theta);
        at.write_dy(3, cos_theta);
        let d_theta_hat_2_d_theta = -(u4 * cos_theta);
        at.write_dy(1, d_theta_hat_2_d_theta);
        let theta_hat_2 = -(u4 * sin_theta);
        at.write_f(1, theta_hat_2);
        let d_X_hat_1_d_theta = -sin_theta;
        at.write_dy(2, d_X_hat_1_d_theta);
        let d_theta_hat_2_d_P = -(u6 * sin_theta);
        at.write_dc(0, d_theta_hat_2_d_P);
        let d_theta_hat_2_d_L = -(u5 * sin_theta);
        at.write_dc(1, d_theta_hat_2_d_L);
        let d_theta_hat_2_d_EI = u7 * sin_theta;
        at.write_dc(2, d_theta_hat_2_d_EI);
    }
}
/// Derived fields.
///
/// 0 add, 1 mul, 0 div, 0 sqrt, 0 fn a point; 2 once.
pub(crate) struct Fields;
impl Sweep for Fields {
    const STATES: usize = 2;
    const CONSTANTS: usize = 3;
    const F: usize = 0;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 1;
    const WIDE: bool = false;
    type Uniforms = [f64; 1];
    #[inline]
    fn uniforms(constants: &[f64]) -> Self::Uniforms {
        let EI = constants[2];
        let L = constants[1];
        let u1 = EI * reciprocal(L);
        [u1]
    }
    #[inline(always)]
    fn chunk<Real: Lane>(uniforms: &Self::Uniforms, at: Chunk<'_>) {
        let u1 = Real::splat(uniforms[0]);
        let theta1 = at.state::<Real>(1);
        let M = u1 * theta1;
        at.write_field(0, M);
    }
}
