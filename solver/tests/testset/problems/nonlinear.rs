//! Nonlinear problems, most of them singularly perturbed.

use crate::problems::catalogue::{Case, Exact, dirichlet, exact, one_region};
use crate::problems::special::{bratu_angle, integral};
use solver::Layout;
use solver::model::{Model, Scalar};
use std::f64::consts::FRAC_PI_2;

pub fn cases() -> Vec<Case> {
    let lagerstrom =
        |id, left, right| Case::new(id, Lagerstrom { left, right }, &[]).line(left, right).continue_from(0.01);
    let spb = |id, right| Case::new(id, Spb { right }, &[]).line(1.5, right).continue_from(0.1);
    vec![
        Case::new("T19", T19, &[]).continue_from(0.01),
        Case::solved("T21", T21).continue_from(1e-4),
        Case::new("T22", T22, &[]).continue_from(1e-3),
        Case::solved("T23", Troesch).continue_from(9.0),
        lagerstrom("T25", -1.0 / 3.0, 1.0 / 3.0),
        lagerstrom("T26", 1.0, -1.0 / 3.0),
        lagerstrom("T28", 1.0, 1.5),
        lagerstrom("T29", 0.0, 1.5),
        Case::new("T31", Shell, &[]),
        Case::new("T33", Swirl, &[]).start(|_, x, _, y| {
            y.fill(0.0);
            (y[0], y[1]) = (2.0 * x - 1.0, 2.0);
        }),
        Case::solved("T34", Bratu),
        Case::new("COSH3", Cosh3, &[]).constant(&[1.0, 0.0]),
        spb("SPB", 1.2),
        spb("SPB_M", -1.2),
        Case::new("COLSYS3", Disk, &[]).start(Disk::start).continue_from(60.0),
        Case::solved("BUTLERVOLMER", Butler),
    ]
}

dirichlet!(
    T19,
    (0.0, 1.0),
    ["eps"],
    |x, u, v, e| ((x * FRAC_PI_2).sin() * (u * 2.0).exp() * FRAC_PI_2 - u.exp() * v) / e,
    0.0,
    0.0
);

dirichlet!(
    T21,
    (0.0, 1.0),
    ["eps"],
    |x, u, v, e| (u + u * u - (x * -2.0 / e.sqrt()).exp()) / e,
    1.0,
    (-e.sqrt().recip()).exp()
);
exact!(T21, |x, e| {
    let u = (-x / e.sqrt()).exp();
    [u, -u / e.sqrt()]
});

dirichlet!(T22, (0.0, 1.0), ["eps"], |x, u, v, e| -(v + u * u) / e, 0.0, 0.5);

dirichlet!(Troesch, (0.0, 1.0), ["mu"], |x, u, v, mu| mu * (mu * u).sinh(), 0.0, 1.0);
impl Exact for Troesch {
    /// With `sinh(μ u/2) = (s/2) sinh w` the first integral becomes `dw/dx = μ √(1 + (s/2)² sinh² w)`.
    fn exact<S: Scalar>(&self, _: usize, x: S, c: &[f64], y: &mut [S]) {
        let mu = c[0];
        let half_slope = if mu == 9.0 { 0.000_965_584_541_076_173_8 } else { 1.648_773_182_780_404e-8 } / 2.0;
        let rate = |w: f64| (1.0 + (half_slope * w.sinh()).powi(2)).sqrt();
        // The travel time ∫ dw/rate is concave: Newton's iteration ascends to the root.
        let (target, mut w) = (mu * x.re(), mu * x.re());
        for _ in 0..60 {
            w += (target - integral(|w| 1.0 / rate(w), 0.0, w)) * rate(w);
        }
        let w = (x - x.re()) * (mu * rate(w)) + w;
        y[0] = (w.sinh() * half_slope).asinh() * (2.0 / mu);
        y[1] = w.cosh() * (2.0 * half_slope);
    }
}

/// `ε u'' = u (1 - u')`.
pub struct Lagerstrom {
    left: f64,
    right: f64,
}

impl Model for Lagerstrom {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &["eps"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], y[0] * (-y[1] + 1.0) / c[0]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0] - self.left, ends[2] - self.right);
    }
}

/// An elastic shell.
pub struct Shell;

impl Model for Shell {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 4, &["eps"], &["left y1", "left y3", "right y1", "right y3"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        let (sin, cos) = y[1].sin_cos();
        f[0] = sin;
        f[1] = y[2];
        f[2] = -y[3] / c[0];
        f[3] = ((y[0] - 1.0) * cos - y[2] * (cos.recip() + c[0] * y[3] * sin / cos)) / c[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[2], ends[4], ends[6]]);
    }
}

/// Flow between disks that turn in opposite directions.
pub struct Swirl;

impl Model for Swirl {
    fn layout(&self) -> Layout {
        let equations = ["left y1", "left y3", "left y4", "right y1", "right y3", "right y4"];
        one_region((0.0, 1.0), 6, &["eps"], &equations)
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = (y[0] * y[3] - y[2] * y[1]) / c[0];
        f[2..5].copy_from_slice(&y[3..]);
        f[5] = -(y[2] * y[5] + y[0] * y[1]) / c[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0] + 1.0, ends[2], ends[3], ends[6] - 1.0, ends[8], ends[9]]);
    }
}

dirichlet!(Bratu, (0.0, 1.0), ["lambda"], |x, u, v, lambda| -lambda * u.exp(), 0.0, 0.0);
exact!(Bratu, |x, lambda| {
    let theta = bratu_angle(lambda);
    let z = (x - 0.5) * (theta / 2.0);
    [(z.cosh() / (theta / 4.0).cosh()).ln() * -2.0, z.tanh() * -theta]
});

/// Two solutions: [`Cosh3::corner`] is one of them.
#[derive(Clone, Copy)]
pub struct Cosh3;

impl Model for Cosh3 {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &["C"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], y[0].cosh() * y[0].sinh().powi(-3));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], c: &[S], g: &mut [S]) {
        let end = (((c[0] + 1.0) / c[0]).sqrt() * (c[0].sqrt() / 2.0).cosh()).acosh();
        (g[0], g[1]) = (ends[0] - end, ends[2] - end);
    }
}

impl Exact for Cosh3 {
    fn exact<S: Scalar>(&self, _: usize, x: S, c: &[f64], y: &mut [S]) {
        let (a, root) = (((1.0 + c[0]) / c[0]).sqrt(), c[0].sqrt());
        let z = (x - 0.5) * root;
        y[0] = (z.cosh() * a).acosh();
        y[1] = z.sinh() * (a * root) / ((z.cosh() * a).powi(2) - 1.0).sqrt();
    }
}

/// A singularly perturbed problem whose solution changes type with the right end's value.
pub struct Spb {
    right: f64,
}

impl Model for Spb {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &["eps"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], (y[0] * (y[0] * y[0] - 1.0) * y[1] + y[0]) / c[0]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0] - 1.5, ends[2] - self.right);
    }
}

/// Rotating flow over a disk; states `G, G', H, H', H''`. The second parameter `s` follows the first, `L`.
pub struct Disk;

impl Disk {
    fn start(_: usize, x: f64, c: &[f64], y: &mut [f64]) {
        let (l, z) = (c[0], c[0] * x);
        let e = (-z).exp();
        y[0] = 1.0 - e;
        y[1] = l * e;
        y[2] = -z * z * e;
        y[3] = l * (z * z - 2.0 * z) * e;
        y[4] = l * l * (-z * z + 4.0 * z - 2.0) * e;
    }
}

impl Model for Disk {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 5, &["L"], &["left G", "left H", "left H'", "right G", "right H'"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], constants: &[S], f: &mut [S]) {
        const N: f64 = 0.2;
        const C: f64 = (3.0 - N) / 2.0;
        let l = constants[0];
        let s = if l <= 120.0 { l.recip() * 12.0 } else { -(l - 120.0) * (0.05 / 80.0) + 0.1 };
        let (g, h) = (&y[..2], &y[2..]);
        f[0] = g[1];
        f[1] = l * l * s * (g[0] - 1.0) - l * (h[0] * g[1] * C + h[1] * g[0] * (N - 1.0));
        (f[2], f[3]) = (h[1], h[2]);
        f[4] = l.powi(3) * (-g[0] * g[0] + 1.0) + l * l * s * h[1] - l * (h[0] * h[2] * C + h[1] * h[1] * N);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[2], ends[3], ends[5] - 1.0, ends[8]]);
    }
}

/// Laplace's equation between electrodes whose currents are exponential in the potential.
#[derive(Clone, Copy)]
pub struct Butler;

impl Model for Butler {
    fn layout(&self) -> Layout {
        one_region((0.0, 0.1), 2, &[], &["anode", "cathode"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], S::from(0.0));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        const K: f64 = 1.64;
        const F: f64 = 38.9;
        let current = |potential: S| (potential * F).exp() - (-potential * F).exp();
        g[0] = -current(ends[0]) * 0.01 + ends[1] * K;
        g[1] = current(-ends[2] - 0.5) * 1e-4 - ends[3] * K;
    }
}

impl Exact for Butler {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        const SLOPE: f64 = -1.130_871_606_066_207_1;
        (y[0], y[1]) = (x * SLOPE - 0.134_264_374_485_371_6, S::from(SLOPE));
    }
}

/// `u'' = -p exp(x³ u)`: AUTO's demo `non`.
pub mod fold {
    use super::*;
    dirichlet!(Non, (0.0, 1.0), ["p"], |x, u, v, p| -p * (x.powi(3) * u).exp(), 0.0, 0.0);
}

/// The two whose reference is a fold.
pub fn fold_cases() -> Vec<Case> {
    vec![Case::solved("FOLD_BRATU", Bratu), Case::new("FOLD_NON", fold::Non, &[])]
}

/// The curve of corner-shaped solutions of [`Cosh3`].
pub fn corner() -> Case {
    Case::solved("COSH3", Cosh3).wanting("COSH3_EX").constant(&[1.0, 0.0]).continue_from(1.5)
}
