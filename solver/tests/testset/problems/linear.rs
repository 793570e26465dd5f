//! Linear problems: layers, oscillations, resonance, and the classics of the solvers' own documentation.

use crate::problems::catalogue::{Case, Exact, dirichlet, exact, one_region};
use crate::problems::special::{dawson, erf};
use solver::Layout;
use solver::model::{Model, Scalar};
use std::f64::consts::{LN_2, PI};

pub fn cases() -> Vec<Case> {
    vec![
        Case::solved("T01", T01),
        Case::solved("T02", T02).continue_from(0.01),
        Case::solved("T03", T03),
        Case::solved("T04", T04).continue_from(0.025),
        Case::solved("T06", T06),
        Case::solved("T07", T07),
        Case::solved("T08", T08).continue_from(0.01),
        Case::solved("T10", T10),
        Case::solved("T11", T11),
        Case::solved("T12", T12),
        Case::solved("T13", T13),
        Case::solved("T16", T16),
        Case::solved("T17", T17),
        Case::solved("T18", T18).continue_from(0.01),
        Case::solved("T35", T35),
        Case::solved("RCBVP", Rcbvp).constant(&[1.0, 1.0]),
        Case::solved("BESSEL_HALF", BesselHalf),
        Case::solved("COLSYS1", Colsys1),
        Case::solved("MUSL", Musl).constant(&[1.0, 1.0, 1.0]),
        Case::solved("MAT3", Mat3),
    ]
}

/// `(π² ε + 1) cos πx`, which turns up in several.
fn forcing<S: Scalar>(x: S, e: S) -> S {
    (e * (PI * PI) + 1.0) * (x * PI).cos()
}

dirichlet!(T01, (0.0, 1.0), ["eps"], |x, u, v, e| u / e, 1.0, 0.0);
exact!(T01, |x, e| {
    let s = e.sqrt();
    let (a, b) = ((-x / s).exp(), ((x - 2.0) / s).exp());
    let d = 1.0 - (-2.0 / s).exp();
    [(a - b) / d, -(a + b) / (s * d)]
});

dirichlet!(T02, (0.0, 1.0), ["eps"], |x, u, v, e| v / e, 1.0, 0.0);
exact!(T02, |x, e| {
    let a = ((x - 1.0) / e).exp();
    let d = 1.0 - (-1.0 / e).exp();
    [(-a + 1.0) / d, -a / (e * d)]
});

dirichlet!(
    T03,
    (-1.0, 1.0),
    ["eps"],
    |x, u, v, e| (-((x * PI).cos() + 2.0) * (v + (x * PI).sin() * PI) + u - forcing(x, e)) / e,
    -1.0,
    -1.0
);
exact!(T03, |x, e| [(x * PI).cos(), -(x * PI).sin() * PI]);

dirichlet!(
    T04,
    (-1.0, 1.0),
    ["eps"],
    |x, u, v, e| ((e + 1.0) * u - v) / e,
    1.0 + (-2.0_f64).exp(),
    ((e + 1.0) * -2.0 / e).exp() + 1.0
);
exact!(T04, |x, e| {
    let rate = (1.0 + e) / e;
    let (a, b) = ((x - 1.0).exp(), (-(x + 1.0) * rate).exp());
    [a + b, a - b * rate]
});

dirichlet!(
    T06,
    (-1.0, 1.0),
    ["eps"],
    |x, u, v, e| (-x * v - e * (x * PI).cos() * (PI * PI) - x * (x * PI).sin() * PI) / e,
    -2.0,
    0.0
);
exact!(T06, |x, e| {
    let k = (2.0 * e).sqrt();
    let d = erf(1.0 / k);
    [(x * PI).cos() + erf(x / k) / d, -(x * PI).sin() * PI + (-x * x / (k * k)).exp() * (2.0 / (PI.sqrt() * k * d))]
});

dirichlet!(
    T07,
    (-1.0, 1.0),
    ["eps"],
    |x, u, v, e| (-x * v + u - forcing(x, e) - x * (x * PI).sin() * PI) / e,
    -1.0,
    1.0
);
exact!(T07, |x, e| {
    let (k, q) = ((2.0 * e).sqrt(), (2.0 * e / PI).sqrt());
    let d = erf(1.0 / k) + q * (-1.0 / (2.0 * e)).exp();
    let bell = (-x * x / (k * k)).exp();
    [(x * PI).cos() + x + (x * erf(x / k) + bell * q) / d, -(x * PI).sin() * PI + erf(x / k) / d + 1.0]
});

dirichlet!(T08, (0.0, 1.0), ["eps"], |x, u, v, e| -v / e, 1.0, 2.0);
exact!(T08, |x, e| {
    let (a, b) = ((-x / e).exp(), (-1.0 / e).exp());
    [(-a + (2.0 - b)) / (1.0 - b), a / (e * (1.0 - b))]
});

dirichlet!(T10, (-1.0, 1.0), ["eps"], |x, u, v, e| -x * v / e, 0.0, 2.0);
exact!(T10, |x, e| {
    let k = (2.0 * e).sqrt();
    let d = erf(1.0 / k);
    [erf(x / k) / d + 1.0, (-x * x / (k * k)).exp() * (2.0 / (PI.sqrt() * k * d))]
});

dirichlet!(T11, (-1.0, 1.0), ["eps"], |x, u, v, e| (u - forcing(x, e)) / e, -1.0, -1.0);
exact!(T11, |x, e| [(x * PI).cos(), -(x * PI).sin() * PI]);

dirichlet!(T12, (-1.0, 1.0), ["eps"], |x, u, v, e| (u - forcing(x, e)) / e, -1.0, 0.0);
exact!(T12, |x, e| {
    let s = e.sqrt();
    let (a, b) = (((x - 1.0) / s).exp(), (-(x + 3.0) / s).exp());
    let d = 1.0 - (-4.0 / s).exp();
    [(x * PI).cos() + (a - b) / d, -(x * PI).sin() * PI + (a + b) / (s * d)]
});

dirichlet!(T13, (-1.0, 1.0), ["eps"], |x, u, v, e| (u - forcing(x, e)) / e, 0.0, -1.0);
exact!(T13, |x, e| {
    let s = e.sqrt();
    let (a, b) = ((-(x + 1.0) / s).exp(), ((x - 3.0) / s).exp());
    let d = 1.0 - (-4.0 / s).exp();
    [(x * PI).cos() + (a - b) / d, -(x * PI).sin() * PI - (a + b) / (s * d)]
});

dirichlet!(T16, (0.0, 1.0), ["eps"], |x, u, v, e| -u * (PI * PI / 4.0) / (e * e), 0.0, (e.recip() * (PI / 2.0)).sin());
exact!(T16, |x, e| {
    let rate = PI / (2.0 * e);
    [(x * rate).sin(), (x * rate).cos() * rate]
});

dirichlet!(
    T17,
    (-0.1, 0.1),
    ["eps"],
    |x, u, v, e| e * u * -3.0 / (e + x * x).powi(2),
    (e + 0.01).sqrt().recip() * -0.1,
    (e + 0.01).sqrt().recip() * 0.1
);
exact!(T17, |x, e| {
    let r = (x * x + e).sqrt();
    [x / r, r.powi(-3) * e]
});

dirichlet!(T18, (0.0, 1.0), ["eps"], |x, u, v, e| -v / e, 1.0, (-e.recip()).exp());
exact!(T18, |x, e| [(-x / e).exp(), -(-x / e).exp() / e]);

dirichlet!(
    /// Ackerberg-O'Malley resonance: exponentially ill-conditioned.
    T35, (-1.0, 1.0), ["eps"], |x, u, v, e| (x * v - u) / e, 1.0, 2.0);
exact!(T35, |x, e| {
    let k = (2.0 * e).sqrt();
    let y = |z: S| (z * z).exp() * (-z * dawson(z) * 2.0 + 1.0);
    let z = x / k;
    let one = y(S::from(1.0 / k)).re() / 1.5;
    [x / 2.0 + y(z) / one, (z * z).exp() * dawson(z) * (-2.0 / (k * one)) + 0.5]
});

dirichlet!(Rcbvp, (1.0 / (3.0 * PI), 1.0), [], |x, u, v, e| -v * 2.0 / x - u / x.powi(4), 0.0, 1.0_f64.sin());
exact!(Rcbvp, |x, e| [x.recip().sin(), -x.recip().cos() / (x * x)]);

dirichlet!(
    BesselHalf,
    (1.0, 6.0),
    [],
    |x, u, v, e| -v / x - (-(x * x * 4.0).recip() + 1.0) * u + x.sqrt() * x.cos(),
    1.0,
    -0.5
);
impl Exact for BesselHalf {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        // a(x) c1 + b(x) c2 + p(x), the constants from the values at 1 and 6.
        let parts = |x: f64| {
            let r = x.sqrt();
            (x.cos() / r, x.sin() / r, r * x.cos() / 4.0 + x * r * x.sin() / 4.0)
        };
        let ((a1, b1, p1), (a6, b6, p6)) = (parts(1.0), parts(6.0));
        let (r1, r6) = (1.0 - p1, -0.5 - p6);
        let determinant = a1 * b6 - a6 * b1;
        let (c1, c2) = ((r1 * b6 - r6 * b1) / determinant, (a1 * r6 - a6 * r1) / determinant);
        let (r, sin, cos) = (x.sqrt(), x.sin(), x.cos());
        y[0] = (cos * c1 + sin * c2) / r + r * cos / 4.0 + x * r * sin / 4.0;
        y[1] = (-sin * c1 + cos * c2) / r - (cos * c1 + sin * c2) / (x * r * 2.0) + cos / (r * 8.0) - r * sin / 4.0
            + r * sin * 0.375
            + x * r * cos / 4.0;
    }
}

/// A beam of changing stiffness.
#[derive(Clone, Copy)]
pub struct Colsys1;

impl Model for Colsys1 {
    fn layout(&self) -> Layout {
        one_region((1.0, 2.0), 4, &[], &["left rest", "left moment", "right rest", "right moment"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        f[..3].copy_from_slice(&y[1..]);
        f[3] = (-x * x * y[3] * 6.0 - x * y[2] * 6.0 + 1.0) / x.powi(3);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[2], ends[4], ends[6]]);
    }
}

impl Exact for Colsys1 {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        let q = (10.0 * LN_2 - 3.0) / 4.0;
        y[0] = (-x + 1.0) * q + (x.recip() + (x + 3.0) * x.ln() - x) / 2.0;
        y[1] = (-(x * x).recip() + x.ln() + x.recip() * 3.0) / 2.0 - q;
        y[2] = (x.powi(-3) * 2.0 + x.recip() - x.powi(-2) * 3.0) / 2.0;
        y[3] = (x.powi(-4) * -6.0 - x.powi(-2) + x.powi(-3) * 6.0) / 2.0;
    }
}

/// Conditions that couple both ends.
#[derive(Clone, Copy)]
pub struct Musl;

impl Model for Musl {
    fn layout(&self) -> Layout {
        one_region((0.0, 6.0), 3, &[], &["sum of y1", "sum of y2", "sum of y3"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        let (s, c) = (x * 2.0).sin_cos();
        let (s, c, e) = (s * 2.0, c * 2.0, x.exp());
        f[0] = (-c + 1.0) * y[0] + (s + 1.0) * y[2] + (c - s - 1.0) * e;
        f[1] = y[1] * 2.0 - e;
        f[2] = (s - 1.0) * y[0] + (c + 1.0) * y[2] + (-c - s + 1.0) * e;
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (0..3).for_each(|i| g[i] = ends[i] + ends[3 + i] - (1.0 + 6.0_f64.exp()));
    }
}

impl Exact for Musl {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        y.fill(x.exp());
    }
}

/// Constant coefficients, full boundary matrices.
#[derive(Clone, Copy)]
pub struct Mat3;

const A: [[f64; 3]; 3] = [[0.0, 1.0, 2.0], [1.0, 0.0, 3.0], [2.0, 3.0, 4.0]];

/// The solution at 0: the boundary conditions' linear system solved with 40 digits.
const INITIAL: [f64; 3] = [-0.675_388_234_120_061_4, 2.151_414_928_461_959, -0.875_813_874_267_952_3];

fn apply<S: Scalar>(rows: &[[f64; 3]; 3], y: &[S]) -> [S; 3] {
    [0, 1, 2].map(|i| y[0] * rows[i][0] + y[1] * rows[i][1] + y[2] * rows[i][2])
}

impl Model for Mat3 {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 3, &[], &["at 0", "at 1, first", "at 1, second"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        f.copy_from_slice(&apply(&A, y));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = ends[0] + ends[1] * 2.0 + ends[2] * 3.0 - 1.0;
        g[1] = ends[3] * 4.0 + ends[4] * 5.0 + ends[5] * 6.0 - 2.0;
        g[2] = ends[3] * 7.0 + ends[4] * 8.0 + ends[5] * 9.0 - 3.0;
    }
}

impl Mat3 {
    /// `exp(A x) y` by its series.
    fn flow<S: Scalar>(x: S, y: [S; 3]) -> [S; 3] {
        let (mut term, mut sum) = (y, y);
        for k in 1..60 {
            term = apply(&A, &term).map(|value| value * x / f64::from(k));
            (0..3).for_each(|i| sum[i] += term[i]);
        }
        sum
    }
}

impl Exact for Mat3 {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        y.copy_from_slice(&Self::flow(x, INITIAL.map(S::from)));
    }
}
