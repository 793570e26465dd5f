//! Linear equations of second order that are singular at an end, stated as they are: what they divide by is zero there.

#[path = "../../tests/testset/problems/special.rs"]
#[allow(dead_code, reason = "the test set's, of which one function is wanted")]
mod special;

use crate::cases::{Case, Equations};
use special::bessel;

/// Of orders n: `u'' + u'/x + (1 - n²/x²) u = 0`.
fn bessel_equation(x: f64, u: f64, slope: f64, order: i32) -> [f64; 3] {
    let factor = f64::from(order).powi(2) / (x * x) - 1.0;
    [factor * u - slope / x, factor, -1.0 / x]
}

/// `3 (z cosh z - sinh z)/z²`, a modified spherical Bessel function of order 1, without cancellation near 0.
fn spherical(z: f64) -> f64 {
    if z < 0.1 { z * (1.0 + z * z * (0.1 + z * z / 280.0)) } else { 3.0 * (z * z.cosh() - z.sinh()) / (z * z) }
}

const fn singular(
    name: &'static str,
    interval: (f64, f64),
    f: fn(f64, f64, f64) -> [f64; 3],
    exact: fn(f64) -> f64,
) -> Case {
    Case { name, interval, linear: true, equations: Equations::One(f, exact) }
}

/// All of them.
pub static CASES: &[Case] = &[
    singular("Bessel, order 2", (0.0, 8.0), |x, u, v| bessel_equation(x, u, v, 2), |x| bessel(2.0, 2.0, x)),
    singular("Bessel, order 5", (0.0, 8.0), |x, u, v| bessel_equation(x, u, v, 5), |x| bessel(5.0, 120.0, x)),
    // Diffusion and reaction in a sphere, of degree 1.
    singular(
        "Sphere",
        (0.0, 1.0),
        |x, u, v| {
            let factor = 2.0 / (x * x) + 100.0;
            [factor * u - 2.0 * v / x, factor, -2.0 / x]
        },
        |x| spherical(10.0 * x),
    ),
    // x² u'' = 2 u + 7/4 x^(5/2), whose solution is not smooth.
    singular("Euler", (0.0, 1.0), |x, u, _| [2.0 * u / (x * x) + 1.75 * x.sqrt(), 2.0 / (x * x), 0.0], |x| x.powf(2.5)),
    // Of order 2, singular at both ends, with a source that makes (1 - x²) e^x the solution.
    singular(
        "Legendre, order 2",
        (-1.0, 1.0),
        |x, u, v| {
            let (q, source) = (1.0 - x * x, x.exp() * (-5.0 + x * (-6.0 + x * (4.0 + x * (6.0 + x)))));
            [(2.0 * x * v + 4.0 * u / q + source) / q, 4.0 / (q * q), 2.0 * x / q]
        },
        |x| (1.0 - x * x) * x.exp(),
    ),
];
