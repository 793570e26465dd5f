//! Special functions for the closed-form solutions, to about 1e-14, and differentiable once.

use solver::model::Scalar;
use std::f64::consts::PI;

/// Nodes and weights of Gauss' rule of order 16 on [-1, 1], the positive half: Abramowitz and Stegun, table 25.4.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// `∫ f` from `a` to `b` by Gauss' rule on panels no longer than a quarter.
pub fn integral(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let panels = ((b - a).abs() / 0.25).ceil().max(1.0);
    let half = 0.5 * (b - a) / panels;
    let panel = |j: usize| {
        let middle = a + half * (2 * j + 1) as f64;
        GAUSS.iter().map(|(x, w)| w * (f(middle - half * x) + f(middle + half * x))).sum::<f64>()
    };
    half * (0..panels as usize).map(panel).sum::<f64>()
}

/// The value and slope at `x.re()` as a function of `x`.
fn first_order<S: Scalar>(x: S, value: f64, slope: f64) -> S {
    (x - x.re()) * slope + value
}

/// The error function.
pub fn erf<S: Scalar>(x: S) -> S {
    let re = x.re();
    let value = if re.abs() > 6.0 { re.signum() } else { 2.0 / PI.sqrt() * integral(|t| (-t * t).exp(), 0.0, re) };
    first_order(x, value, 2.0 / PI.sqrt() * (-re * re).exp())
}

/// Dawson's integral `exp(-x²) ∫ exp(t²)`.
pub fn dawson<S: Scalar>(x: S) -> S {
    let re = x.re();
    let value = integral(|t| ((t - re) * (t + re)).exp(), 0.0, re);
    first_order(x, value, 1.0 - 2.0 * re * value)
}

/// `J_ν(x)` by its power series; `gamma` is `Γ(ν+1)`.
pub fn bessel<S: Scalar>(nu: f64, gamma: f64, x: S) -> S {
    let half = x / 2.0;
    let (mut term, mut sum) = (half.powf(nu) / gamma, S::from(0.0));
    for k in 1..60 {
        sum += term;
        term = term * half * half / (-f64::from(k) * (f64::from(k) + nu));
    }
    sum
}

/// `θ` of Bratu's problem, lower branch: the smaller root of `θ = √(2λ) cosh(θ/4)`.
pub fn bratu_angle(lambda: f64) -> f64 {
    let mut theta = 0.0;
    for _ in 0..200 {
        let root = (2.0 * lambda).sqrt();
        let (f, slope) = (theta - root * (theta / 4.0_f64).cosh(), 1.0 - root * (theta / 4.0_f64).sinh() / 4.0);
        theta -= f / slope;
    }
    theta
}
