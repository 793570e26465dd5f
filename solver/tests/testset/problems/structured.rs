//! Singular endpoints, periodic conditions, unknown constants, several regions.

use crate::problems::catalogue::{Case, Exact, one_region};
use crate::problems::special::bessel;
use solver::model::{Model, Scalar};
use solver::{Layout, Region};
use std::f64::consts::{FRAC_PI_2, PI};

pub fn cases() -> Vec<Case> {
    vec![
        Case::solved("EMDEN", Emden).constant(&[0.866_025_403_784_438_6, 1e-4]),
        Case::new("ESI", Esi, &[]).start(|_, x, _, y| {
            (y[0], y[1]) = if x <= 1.5 { (2.0, 0.0) } else { (2.0 * (1.5 - x).exp(), -2.0 * (1.5 - x).exp()) };
        }),
        Case::new("CATALYST", Catalyst, &[]).constant(&[1.0, 0.0]).wanting("CATALYST1"),
        Case::new("CATALYST", Catalyst, &[]).constant(&[0.5, 0.0]).wanting("CATALYST2"),
        Case::new("CATALYST", Catalyst, &[]).constant(&[0.0, 0.0]).wanting("CATALYST3"),
        Case::new("MEASLES", Measles, &[]).constant(&[0.07, 5e-4, 2e-3]),
        Case::new("MATHIEU", Mathieu, &[("eigenvalue", 15.0)])
            .start(|_, x, _, y| (y[0], y[1]) = ((4.0 * x).cos(), -4.0 * (4.0 * x).sin())),
        Case::new("LUBRICATION", Lubrication, &[("flow", 1.0)]).constant(&[0.5]).continue_from(0.1),
        Case::new("ELASTICA", Elastica, &[("force", -10.0)]),
        Case::new("NERVE", Nerve, &[("period", 2.0 * PI)])
            .intervals(4)
            .start(|_, x, _, y| (y[0], y[1]) = (2.0 * PI * x).sin_cos()),
        Case::new("THREEBVP", Flow, &[]).constant(&[1.0, 1.0]),
        Case::solved("BESSEL_MP", BesselPoints),
    ]
}

/// `-k v/x + q` with `v(0) = 0`: at `x = 0` its limit `q/(1 + k)`.
fn singular<S: Scalar>(x: S, k: f64, v: S, q: S) -> S {
    if x.re() == 0.0 { q / (1.0 + k) } else { q - v * k / x }
}

/// Emden's equation of index 5.
#[derive(Clone, Copy)]
pub struct Emden;

impl Model for Emden {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &[], &["centre", "surface"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], singular(x, 2.0, y[1], -y[0].powi(5)));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[1], ends[2] - 0.75_f64.sqrt());
    }
}

impl Exact for Emden {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        let u = (x * x / 3.0 + 1.0).sqrt().recip();
        (y[0], y[1]) = (u, -x * u.powi(3) / 3.0);
    }
}

/// Electromagnetic self-interaction; the infinite interval ends at 20.
pub struct Esi;

impl Model for Esi {
    fn layout(&self) -> Layout {
        one_region((0.0, 20.0), 2, &[], &["centre", "decay"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], singular(x, 4.0, y[1], -(x * y[0] - 1.0) * y[0]));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[1], ends[2] + ends[3]);
    }
}

/// Reaction and diffusion in a catalyst pellet: three solutions.
pub struct Catalyst;

impl Model for Catalyst {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &["phi"], &["centre", "surface"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        const GAMMA: f64 = 40.0;
        const BETA: f64 = 0.2;
        let heat = (-y[0] + 1.0) * BETA;
        let rate = c[0] * c[0] * y[0] * (heat * GAMMA / (heat + 1.0)).exp();
        (f[0], f[1]) = (y[1], singular(x, 2.0, y[1], rate));
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[1], ends[2] - 1.0);
    }
}

/// An epidemic with the seasons: periodic.
pub struct Measles;

impl Model for Measles {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 3, &["eta"], &["y1 periodic", "y2 periodic", "y3 periodic"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        const LATENCY: f64 = 0.0279;
        let infections = ((x * (2.0 * PI)).cos() + 1.0) * y[0] * y[2] * 1575.0;
        f[0] = -infections + 0.02;
        f[1] = infections - y[1] / LATENCY;
        f[2] = y[1] / LATENCY - y[2] / c[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (0..3).for_each(|i| g[i] = ends[i] - ends[3 + i]);
    }
}

/// Mathieu's equation, `q = 5`.
pub struct Mathieu;

impl Model for Mathieu {
    fn layout(&self) -> Layout {
        one_region((0.0, PI), 2, &["eigenvalue"], &["left slope", "right slope", "amplitude"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1], -(c[0] - (x * 2.0).cos() * 10.0) * y[0]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (ends[1], ends[3], ends[0] - 1.0);
    }
}

/// Reynolds' equation with an unknown flow.
pub struct Lubrication;

impl Model for Lubrication {
    fn layout(&self) -> Layout {
        one_region((-FRAC_PI_2, FRAC_PI_2), 1, &["eps", "flow"], &["left end", "right end"])
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        let square = x.sin().powi(2);
        f[0] = (square - c[1] * square * square / y[0]) / c[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0] - 1.0, ends[1] - 1.0);
    }
}

/// A bent rod under an unknown force.
pub struct Elastica;

impl Model for Elastica {
    fn layout(&self) -> Layout {
        one_region((0.0, 0.5), 4, &["force"], &["left x", "left y", "left moment", "right y", "right angle"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        let (sin, cos) = y[2].sin_cos();
        f.copy_from_slice(&[cos, sin, y[3], c[0] * cos]);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[1], ends[3], ends[5], ends[6] + FRAC_PI_2]);
    }
}

/// A periodic orbit of unknown period.
pub struct Nerve;

impl Model for Nerve {
    fn layout(&self) -> Layout {
        one_region((0.0, 1.0), 2, &["period"], &["y1 periodic", "y2 periodic", "phase"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = c[0] * (y[0] + y[1] - y[0].powi(3) / 3.0 - 1.3) * 3.0;
        f[1] = -c[0] * (y[0] - 0.7 + y[1] * 0.8) / 3.0;
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1]) = (ends[0] - ends[2], ends[1] - ends[3]);
        g[2] = -c[0] * (ends[0] - 0.7 + ends[1] * 0.8) / 3.0 - 1.0;
    }
}

/// Flow in a long channel whose inflow ends at `x = 1`.
pub struct Flow;

impl Model for Flow {
    fn layout(&self) -> Layout {
        let inflow = Region::dense("inflow", (0.0, 1.0), &["v", "C"], &[], 1);
        let outflow = Region::dense("outflow", (1.0, 2.0), &["v", "C"], &[], 1);
        Layout::dense(vec![inflow, outflow], &["kappa"], &["closed end", "v continuous", "C continuous", "open end"])
    }
    fn rhs<S: Scalar>(&self, region: usize, x: S, y: &[S], c: &[S], f: &mut [S]) {
        const N: f64 = 0.05;
        let eta = (c[0] * c[0] * N).recip() * 4.0;
        let source = if region == 0 { x } else { S::from(1.0) };
        (f[0], f[1]) = ((y[1] - 1.0) / N, (y[0] * y[1] - source) / eta);
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g.copy_from_slice(&[ends[0], ends[2] - ends[4], ends[3] - ends[5], ends[7] - 1.0]);
    }
}

/// Bessel's equation with a condition on an integral at an inner point.
#[derive(Clone, Copy)]
pub struct BesselPoints;

impl BesselPoints {
    const NU: f64 = 3.4123;
    /// `Γ(ν + 1)`.
    const GAMMA: f64 = 10.307_750_572_695_34;
}

impl Model for BesselPoints {
    fn layout(&self) -> Layout {
        let left = Region::dense("left", (1.0, 5.0), &["u", "w", "v"], &[], 0);
        let right = Region::dense("right", (5.0, 10.0), &["u", "w", "v"], &[], 0);
        let equations = ["u at 1", "u continuous", "w continuous", "v continuous", "v at 5", "u at 10"];
        Layout::dense(vec![left, right], &[], &equations)
    }
    fn rhs<S: Scalar>(&self, _: usize, x: S, y: &[S], _: &[S], f: &mut [S]) {
        f[0] = y[1];
        f[1] = -y[1] / x + (x.powi(-2) * (Self::NU * Self::NU) - 1.0) * y[0];
        f[2] = x.powf(Self::NU + 1.0) * y[0];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = ends[0] - 0.008_607_837_654_606_705;
        (0..3).for_each(|i| g[1 + i] = ends[3 + i] - ends[6 + i]);
        g[4] = ends[5] - 419.220_352_531_309_4;
        g[5] = ends[9] + 0.073_266_828_046_235_27;
    }
}

impl Exact for BesselPoints {
    fn exact<S: Scalar>(&self, _: usize, x: S, _: &[f64], y: &mut [S]) {
        let (nu, gamma) = (Self::NU, Self::GAMMA);
        y[0] = bessel(nu, gamma, x);
        let next = bessel(nu + 1.0, gamma * (nu + 1.0), x);
        y[1] = y[0] * nu / x - next;
        y[2] = x.powf(nu + 1.0) * next;
    }
}
