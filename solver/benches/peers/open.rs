//! Problems whose solutions are not known in closed form: J. R. Cash's collection by its numbers
//! (https://archimede.uniba.it/~bvpsolvers/testsetbvpsolvers), COLSYS's examples (U. Ascher, J. Christiansen and R. D.
//! Russell, ACM Trans. Math. Softw. 7 (1981) 209-222), demos of AUTO, boundary layers of textbooks; equations of
//! orders 1 to 4, up to eight states. What errors are measured against is computed: see `reference.rs`.

use crate::cases::{Case, Derivatives, Equations, Guess, Many};
use std::f64::consts::FRAC_PI_2;

/// `u'' = F(x, u, u')` with u at both ends.
pub const fn one(
    name: &'static str,
    interval: (f64, f64),
    f: fn(f64, f64, f64) -> [f64; 3],
    ends: [f64; 2],
    guess: Guess,
) -> Case {
    Case { name, interval, linear: false, equations: Equations::Open(f, ends, guess) }
}

/// Equations of any orders.
pub const fn many(name: &'static str, interval: (f64, f64), many: &'static Many) -> Case {
    Case { name, interval, linear: false, equations: Equations::Many(many) }
}

/// All of them.
pub static CASES: &[Case] = &[
    one("19, ε = 1e-2", (0.0, 1.0), |x, u, v| cash19(x, u, v, 1e-2), [0.0, 0.0], Guess::Zero),
    one("19, ε = 1e-3", (0.0, 1.0), |x, u, v| cash19(x, u, v, 1e-3), [0.0, 0.0], Guess::Zero),
    one("22, ε = 0.025", (0.0, 1.0), |_, u, v| cash22(u, v, 0.025), [0.0, 0.5], Guess::Zero),
    one("22, ε = 1e-3", (0.0, 1.0), |_, u, v| cash22(u, v, 1e-3), [0.0, 0.5], Guess::Zero),
    one("23 (Troesch), μ = 5", (0.0, 1.0), |_, u, _| troesch(u, 5.0), [0.0, 1.0], Guess::Zero),
    one("23 (Troesch), μ = 9", (0.0, 1.0), |_, u, _| troesch(u, 9.0), [0.0, 1.0], Guess::Zero),
    one("24 (nozzle), ε = 0.05", (0.0, 1.0), |x, u, v| nozzle(x, u, v, 0.05), [0.9129, 0.375], Guess::Line),
    one("24 (nozzle), ε = 0.02", (0.0, 1.0), |x, u, v| nozzle(x, u, v, 0.02), [0.9129, 0.375], Guess::Line),
    one("25, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C25, Guess::Line),
    one("25, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C25, Guess::Line),
    one("26, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C26, Guess::Line),
    one("26, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C26, Guess::Line),
    one("27, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C27, Guess::Line),
    one("27, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C27, Guess::Line),
    one("28, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C28, Guess::Line),
    one("28, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C28, Guess::Line),
    one("29, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C29, Guess::Line),
    one("29, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C29, Guess::Line),
    one("30, ε = 0.1", (0.0, 1.0), |_, u, v| cole(u, v, 0.1), C30, Guess::Line),
    one("30, ε = 0.01", (0.0, 1.0), |_, u, v| cole(u, v, 0.01), C30, Guess::Line),
    many("31 (shell), ε = 0.1", (0.0, 1.0), &shell_by(|_, z, f, d| shell(z, f, d, 0.1))),
    many("31 (shell), ε = 0.025", (0.0, 1.0), &shell_by(|_, z, f, d| shell(z, f, d, 0.025))),
    many("32 (channel), R = 10", (0.0, 1.0), &channel_by(|_, z, f, d| channel(z, f, d, 10.0))),
    many("32 (channel), R = 100", (0.0, 1.0), &channel_by(|_, z, f, d| channel(z, f, d, 100.0))),
    many("32 (channel), R = 1000", (0.0, 1.0), &channel_by(|_, z, f, d| channel(z, f, d, 1e3))),
    many("33 (discs), ε = 0.05", (0.0, 1.0), &discs_by(|_, z, f, d| discs(z, f, d, 0.05))),
    many("33 (discs), ε = 0.01", (0.0, 1.0), &discs_by(|_, z, f, d| discs(z, f, d, 0.01))),
    one("AUTO's spb, ε = 0.1", (0.0, 1.0), |_, u, v| spb(u, v, 0.1), [1.5, 1.2], Guess::Line),
    one("u'' = cosh u / sinh³ u", (0.0, 1.0), |_, u, _| hyperbolic(u), [HYPERBOLIC; 2], Guess::Constant(1.0)),
    one("Pendulum", (0.0, 6.0), |_, u, _| [-u.sin(), -u.cos(), 0.0], [1.0, 1.5], Guess::Zero),
    one("Painlevé I", (0.0, 10.0), |x, u, _| [u * u - x, 2.0 * u, 0.0], [0.0, ROOT], Guess::Line),
    one("ε u'' = u u', ε = 0.05", (0.0, 1.0), |_, u, v| burgers(u, v, 0.05), [1.0, -0.9], Guess::Line),
    one("van der Pol, forced", (0.0, 3.0), van_der_pol, [2.0, -1.0], Guess::Line),
    many("Blasius", (0.0, 10.0), &BLASIUS),
    many("Falkner and Skan, β = 0.5", (0.0, 8.0), &FALKNER_SKAN),
    many("COLSYS 3 (disc), L = 60", (0.0, 1.0), &DISC),
    many("Rayleigh, controlled", (0.0, 2.5), &RAYLEIGH),
    many("Beam, large deflection", (0.0, 1.0), &BEAM),
    Case { name: "COLSYS 1 (beam)", interval: (1.0, 2.0), linear: true, equations: Equations::Many(&COLSYS_1) },
    Case { name: "Chain of four", interval: (0.0, 1.0), linear: true, equations: Equations::Many(&CHAIN) },
    Case { name: "Two of first order", interval: (0.0, 1.0), linear: true, equations: Equations::Many(&FIRST_ORDER) },
    Case {
        name: "u'' = 500 x u",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::Open(|x, u, _| [500.0 * x * u, 500.0 * x, 0.0], [1.0, 1.0], Guess::Zero),
    },
];

fn cash19(x: f64, u: f64, v: f64, e: f64) -> [f64; 3] {
    let (source, drag) = (FRAC_PI_2 * (FRAC_PI_2 * x).sin() * (2.0 * u).exp(), u.exp());
    [(source - drag * v) / e, (2.0 * source - drag * v) / e, -drag / e]
}

fn cash22(u: f64, v: f64, e: f64) -> [f64; 3] {
    [-(v + u * u) / e, -2.0 * u / e, -1.0 / e]
}

fn troesch(u: f64, mu: f64) -> [f64; 3] {
    [mu * (mu * u).sinh(), mu * mu * (mu * u).cosh(), 0.0]
}

/// Flow through a nozzle of area 1 + x² with a shock.
fn nozzle(x: f64, u: f64, v: f64, e: f64) -> [f64; 3] {
    let area = 1.0 + x * x;
    let (ea, slope) = (e * area, 1.2 - 2.0 * e * x);
    let widening = 2.0 * x / (area * ea);
    [
        slope * v / ea - v / (u * u * ea) - widening * (1.0 / u - 0.2 * u),
        2.0 * v / (u * u * u * ea) + widening * (1.0 / (u * u) + 0.2),
        (slope - 1.0 / (u * u)) / ea,
    ]
}

/// `ε u'' = u (1 - u')` (P. A. Lagerstrom and J. D. Cole): its solutions have layers, corners or shocks by their ends.
fn cole(u: f64, v: f64, e: f64) -> [f64; 3] {
    [u * (1.0 - v) / e, (1.0 - v) / e, -u / e]
}

const C25: [f64; 2] = [-1.0 / 3.0, 1.0 / 3.0];
const C26: [f64; 2] = [1.0, -1.0 / 3.0];
const C27: [f64; 2] = [1.0, 1.0 / 3.0];
const C28: [f64; 2] = [1.0, 1.5];
const C29: [f64; 2] = [0.0, 1.5];
const C30: [f64; 2] = [-7.0 / 6.0, 1.5];

fn spb(u: f64, v: f64, e: f64) -> [f64; 3] {
    [(u * (u * u - 1.0) * v + u) / e, ((3.0 * u * u - 1.0) * v + 1.0) / e, u * (u * u - 1.0) / e]
}

/// arccosh(√(5/3) cosh(√1.5 / 2)), which makes cosh u = √(5/3) cosh(√1.5 (x - 1/2)) a solution.
const HYPERBOLIC: f64 = 0.997_984_815_818_260_5;

fn hyperbolic(u: f64) -> [f64; 3] {
    let (c, s) = (u.cosh(), u.sinh());
    [c / s.powi(3), (s * s - 3.0 * c * c) / s.powi(4), 0.0]
}

/// √10.
const ROOT: f64 = 3.162_277_660_168_379_5;

fn burgers(u: f64, v: f64, e: f64) -> [f64; 3] {
    [u * v / e, v / e, u / e]
}

fn van_der_pol(x: f64, u: f64, v: f64) -> [f64; 3] {
    [2.0 * (1.0 - u * u) * v - u + x.sin(), -4.0 * u * v - 1.0, 2.0 * (1.0 - u * u)]
}

const fn shell_by(derivatives: Derivatives) -> Many {
    Many {
        orders: &[1, 1, 1, 1],
        derivatives,
        left: &[(0, 0.0), (2, 0.0)],
        right: &[(0, 0.0), (2, 0.0)],
        guess: |_, z| z.fill(0.0),
    }
}

fn shell(z: &[f64], f: &mut [f64], rows: &mut [f64], e: f64) {
    let (y, angle, m, q) = (z[0], z[1], z[2], z[3]);
    let (sin, cos) = angle.sin_cos();
    let (secant, tangent) = (1.0 / cos, sin / cos);
    let stiffness = secant + e * q * tangent;
    f.copy_from_slice(&[sin, m, -q / e, ((y - 1.0) * cos - m * stiffness) / e]);
    rows.fill(0.0);
    (rows[1], rows[6], rows[11]) = (cos, 1.0, -1.0 / e);
    let by_angle = -(y - 1.0) * sin - m * (secant * tangent + e * q * secant * secant);
    rows[12..16].copy_from_slice(&[cos / e, by_angle / e, -stiffness / e, -m * tangent]);
}

/// Flow through a channel with porous walls.
const fn channel_by(derivatives: Derivatives) -> Many {
    Many {
        orders: &[4],
        derivatives,
        left: &[(0, 0.0), (1, 0.0)],
        right: &[(0, 1.0), (1, 0.0)],
        guess: |_, z| z.fill(0.0),
    }
}

fn channel(z: &[f64], f: &mut [f64], rows: &mut [f64], reynolds: f64) {
    f[0] = reynolds * (z[1] * z[2] - z[0] * z[3]);
    rows.copy_from_slice(&[-reynolds * z[3], reynolds * z[2], reynolds * z[1], -reynolds * z[0]]);
}

/// Flow between rotating discs: g, g', f, f', f'', f'''.
const fn discs_by(derivatives: Derivatives) -> Many {
    Many {
        orders: &[2, 4],
        derivatives,
        left: &[(0, -1.0), (2, 0.0), (3, 0.0)],
        right: &[(0, 1.0), (2, 0.0), (3, 0.0)],
        guess: |x, z| z.copy_from_slice(&[2.0 * x - 1.0, 2.0, 0.0, 0.0, 0.0, 0.0]),
    }
}

fn discs(z: &[f64], f: &mut [f64], rows: &mut [f64], e: f64) {
    f.copy_from_slice(&[(z[0] * z[3] - z[2] * z[1]) / e, (-z[2] * z[5] - z[0] * z[1]) / e]);
    rows[..6].copy_from_slice(&[z[3] / e, -z[2] / e, -z[1] / e, z[0] / e, 0.0, 0.0]);
    rows[6..].copy_from_slice(&[-z[1] / e, -z[0] / e, -z[5] / e, 0.0, 0.0, -z[2] / e]);
}

static BLASIUS: Many = Many {
    orders: &[3],
    derivatives: |_, z, f, rows| {
        f[0] = -0.5 * z[0] * z[2];
        rows.copy_from_slice(&[-0.5 * z[2], 0.0, -0.5 * z[0]]);
    },
    left: &[(0, 0.0), (1, 0.0)],
    right: &[(1, 1.0)],
    guess: |x, z| z.copy_from_slice(&[x * x / 20.0, x / 10.0, 0.1]),
};

static FALKNER_SKAN: Many = Many {
    orders: &[3],
    derivatives: |_, z, f, rows| {
        f[0] = -z[0] * z[2] - 0.5 * (1.0 - z[1] * z[1]);
        rows.copy_from_slice(&[-z[2], z[1], -z[0]]);
    },
    left: &[(0, 0.0), (1, 0.0)],
    right: &[(1, 1.0)],
    guess: |x, z| z.copy_from_slice(&[x * x / 16.0, x / 8.0, 0.125]),
};

/// Flow over a rotating disc: G, G', H, H', H''.
static DISC: Many = Many {
    orders: &[2, 3],
    derivatives: |_, z, f, rows| {
        const L: f64 = 60.0;
        const S: f64 = 0.2;
        const N: f64 = 0.2;
        const C: f64 = 0.5 * (3.0 - N);
        let (g, dg, h, dh, ddh) = (z[0], z[1], z[2], z[3], z[4]);
        f[0] = L * L * S * (g - 1.0) - L * (C * h * dg + (N - 1.0) * dh * g);
        f[1] = L.powi(3) * (1.0 - g * g) + L * L * S * dh - L * (C * h * ddh + N * dh * dh);
        let first = [L * L * S - L * (N - 1.0) * dh, -L * C * h, -L * C * dg, -L * (N - 1.0) * g, 0.0];
        rows[..5].copy_from_slice(&first);
        rows[5..].copy_from_slice(&[-2.0 * L.powi(3) * g, 0.0, -L * C * ddh, L * L * S - 2.0 * L * N * dh, -L * C * h]);
    },
    left: &[(0, 0.0), (2, 0.0), (3, 0.0)],
    right: &[(0, 1.0), (3, 0.0)],
    guess: |x, z| {
        let (s, fading) = (60.0 * x, (-60.0 * x).exp());
        let (first, second) = (60.0 * s * (s - 2.0), 3600.0 * (4.0 * s - s * s - 2.0));
        z.copy_from_slice(&[1.0 - fading, 60.0 * fading, -s * s * fading, first * fading, second * fading]);
    },
};

/// Rayleigh's equation with the control that costs least: states and adjoint states.
static RAYLEIGH: Many = Many {
    orders: &[1, 1, 1, 1],
    derivatives: |_, z, f, rows| {
        let (x, v, p, q) = (z[0], z[1], z[2], z[3]);
        let damping = 0.42 * v * v - 1.4;
        f.copy_from_slice(&[v, -x + 1.4 * v - 0.14 * v.powi(3) - 8.0 * q, q - 2.0 * x, damping * q - p]);
        rows.copy_from_slice(&[
            0.0,
            1.0,
            0.0,
            0.0,
            -1.0,
            -damping,
            0.0,
            -8.0,
            -2.0,
            0.0,
            0.0,
            1.0,
            0.0,
            0.84 * v * q,
            -1.0,
            damping,
        ]);
    },
    left: &[(0, -5.0), (1, -5.0)],
    right: &[(2, 0.0), (3, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// A clamped beam under a load at its free end: place, angle and bending moment.
static BEAM: Many = Many {
    orders: &[1, 1, 1, 1],
    derivatives: |_, z, f, rows| {
        let (sin, cos) = z[2].sin_cos();
        f.copy_from_slice(&[cos, sin, z[3], -5.0 * cos]);
        rows.fill(0.0);
        (rows[2], rows[6], rows[11], rows[14]) = (-sin, cos, 1.0, 5.0 * sin);
    },
    left: &[(0, 0.0), (1, 0.0), (2, 0.0)],
    right: &[(3, 0.0)],
    guess: |_, z| z.fill(0.0),
};

static COLSYS_1: Many = Many {
    orders: &[4],
    derivatives: |x, z, f, rows| {
        f[0] = (1.0 - 6.0 * x * x * z[3] - 6.0 * x * z[2]) / x.powi(3);
        rows.copy_from_slice(&[0.0, 0.0, -6.0 / (x * x), -6.0 / x]);
    },
    left: &[(0, 0.0), (2, 0.0)],
    right: &[(0, 0.0), (2, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// `u_i'' = 100 (2 u_i - u_(i-1) - u_(i+1)) - s_i` for four u.
static CHAIN: Many = Many {
    orders: &[2, 2, 2, 2],
    derivatives: |x, z, f, rows| {
        let sources = [1.0, (3.0 * x).sin(), x, 1.0];
        rows.fill(0.0);
        for i in 0..4_usize {
            let neighbours = [i.checked_sub(1), Some(i + 1).filter(|&j| j < 4)].into_iter().flatten();
            rows[8 * i + 2 * i] = 200.0;
            f[i] = 200.0 * z[2 * i] - sources[i];
            for j in neighbours {
                rows[8 * i + 2 * j] = -100.0;
                f[i] -= 100.0 * z[2 * j];
            }
        }
    },
    left: &[(0, 1.0), (2, 0.0), (4, 0.0), (6, 1.0)],
    right: &[(0, 0.0), (2, 1.0), (4, 0.0), (6, -1.0)],
    guess: |_, z| z.fill(0.0),
};

static FIRST_ORDER: Many = Many {
    orders: &[1, 1],
    derivatives: |x, z, f, rows| {
        f.copy_from_slice(&[-50.0 * z[0] + 50.0 * z[1] + (5.0 * x).sin(), z[0] + 30.0 * z[1]]);
        rows.copy_from_slice(&[-50.0, 50.0, 1.0, 30.0]);
    },
    left: &[(0, 1.0)],
    right: &[(1, 2.0)],
    guess: |_, z| z.fill(0.0),
};
