//! Problems of other fields, written down when the solver's steps and limits had been chosen: nothing has been tuned on
//! them. Reaction and diffusion, semiconductors, membranes and cables, films and boundary layers, optimal control,
//! orbits, layers, peaks and oscillations. What errors are measured against is computed: see `reference.rs`.

use crate::cases::{Case, Equations, Guess, Many};
use crate::open::{many, one};

/// Linear: `u'' = F(x, u, u')` with u at both ends.
const fn linear(name: &'static str, interval: (f64, f64), f: fn(f64, f64, f64) -> [f64; 3], ends: [f64; 2]) -> Case {
    Case { name, interval, linear: true, equations: Equations::Open(f, ends, Guess::Zero) }
}

/// All of them.
pub static CASES: &[Case] = &[
    one("Bratu, λ = 3", (0.0, 1.0), |_, u, _| [-3.0 * u.exp(), -3.0 * u.exp(), 0.0], [0.0, 0.0], Guess::Zero),
    one("Reaction of order 2", (0.0, 1.0), |_, u, _| [100.0 * u * u, 200.0 * u, 0.0], [1.0, 1.0], Guess::Line),
    one(
        "Allen and Cahn, ε = 0.2",
        (-1.0, 1.0),
        |_, u, _| [25.0 * (u * u * u - u), 25.0 * (3.0 * u * u - 1.0), 0.0],
        [-1.0, 1.0],
        Guess::Line,
    ),
    one(
        "Poisson and Boltzmann",
        (0.0, 1.0),
        |_, u, _| [100.0 * u.sinh(), 100.0 * u.cosh(), 0.0],
        [2.0, -1.0],
        Guess::Zero,
    ),
    one(
        "Junction (pn)",
        (-1.0, 1.0),
        |x, u, _| [100.0 * (u.sinh() - 20.0 * (x / 0.1).tanh()), 100.0 * u.cosh(), 0.0],
        [-3.689_504_3, 3.689_504_3],
        Guess::Line,
    ),
    many("Radiating fin", (0.0, 1.0), &FIN),
    many("Tubular reactor", (0.0, 1.0), &REACTOR),
    one(
        "Meniscus",
        (0.0, 1.0),
        |_, u, v| {
            let r = (1.0 + v * v).sqrt();
            [4.0 * u * r * r * r, 4.0 * r * r * r, 12.0 * u * r * v]
        },
        [0.5, 0.6],
        Guess::Line,
    ),
    one(
        "Minimal surface",
        (0.0, 1.0),
        |_, u, v| [(1.0 + v * v) / u, -(1.0 + v * v) / (u * u), 2.0 * v / u],
        [1.0, 1.5],
        Guess::Line,
    ),
    one(
        "Hanging cable",
        (0.0, 1.0),
        |_, _, v| {
            let r = (1.0 + v * v).sqrt();
            [3.0 * r, 0.0, 3.0 * v / r]
        },
        [0.0, 0.2],
        Guess::Zero,
    ),
    one(
        "ε u'' = 1 - u'², ε = 0.05",
        (0.0, 1.0),
        |_, _, v| [20.0 * (1.0 - v * v), 0.0, -40.0 * v],
        [0.0, 0.3],
        Guess::Line,
    ),
    one(
        "ε u'' = 1 - u'², ε = 0.02",
        (-1.0, 1.0),
        |_, _, v| [50.0 * (1.0 - v * v), 0.0, -100.0 * v],
        [0.8, 0.7],
        Guess::Line,
    ),
    one(
        "ε u'' = u (u - 1) + (x - 0.3) u'",
        (0.0, 1.0),
        |x, u, v| [50.0 * (u * (u - 1.0) + v * (x - 0.3)), 50.0 * (2.0 * u - 1.0), 50.0 * (x - 0.3)],
        [1.2, 0.8],
        Guess::Line,
    ),
    many("Jeffery and Hamel", (0.0, 1.0), &HAMEL),
    many("Natural convection", (0.0, 10.0), &CONVECTION),
    many("Squeezed film", (0.0, 1.0), &FILM),
    many("Stretching sheet", (0.0, 8.0), &SHEET),
    many("von Kármán's disc", (0.0, 8.0), &KARMAN),
    many("Beam on a foundation", (0.0, 1.0), &FOUNDATION),
    many("van der Pol, controlled", (0.0, 5.0), &CONTROLLED),
    many("Transfer of orbits", (0.0, 2.0), &TRANSFER),
    many("Brusselator", (0.0, 1.0), &BRUSSELATOR),
    many("Hanging elastica", (0.0, 1.0), &ELASTICA),
    linear("u'' = -400 u + x", (0.0, 1.0), |x, u, _| [-400.0 * u + x, -400.0, 0.0], [1.0, 0.3]),
    linear("u'' = -3600 u + exp x", (0.0, 1.0), |x, u, _| [-3600.0 * u + x.exp(), -3600.0, 0.0], [1.0, 0.3]),
    linear(
        "Well",
        (0.0, 1.0),
        |x, u, _| {
            let q = 1e4 * (x - 0.5).powi(2) + 1.0;
            [q * u - 100.0, q, 0.0]
        },
        [0.0, 1.0],
    ),
    linear("Turning point, even", (-1.0, 1.0), |x, u, v| [1e3 * (u - x * x * v), 1e3, -1e3 * x * x], [1.0, 2.0]),
    linear(
        "Two peaks",
        (0.0, 1.0),
        |x, u, _| [200.0 * u - 1e3 * ((-1e3 * (x - 0.3).powi(2)).exp() - (-3e2 * (x - 0.7).powi(2)).exp()), 200.0, 0.0],
        [0.0, 0.0],
    ),
    Case { name: "Plate under tension", interval: (0.0, 1.0), linear: true, equations: Equations::Many(&PLATE) },
    Case { name: "Regulator", interval: (0.0, 1.0), linear: true, equations: Equations::Many(&REGULATOR) },
];

/// `u'' = 20 (u⁴ - 1/10)`: a fin that radiates, insulated at its tip.
static FIN: Many = Many {
    orders: &[2],
    derivatives: |_, z, f, rows| {
        f[0] = 20.0 * (z[0].powi(4) - 0.1);
        rows.copy_from_slice(&[80.0 * z[0].powi(3), 0.0]);
    },
    left: &[(0, 1.0)],
    right: &[(1, 0.0)],
    guess: |_, z| z.copy_from_slice(&[1.0, 0.0]),
};

/// `u''/50 - u' = 4 u²`: a reaction of second order in a tube with axial dispersion.
static REACTOR: Many = Many {
    orders: &[2],
    derivatives: |_, z, f, rows| {
        f[0] = 50.0 * (z[1] + 4.0 * z[0] * z[0]);
        rows.copy_from_slice(&[400.0 * z[0], 50.0]);
    },
    left: &[(0, 1.0)],
    right: &[(1, 0.0)],
    guess: |_, z| z.copy_from_slice(&[1.0, 0.0]),
};

/// Flow between plane walls that meet: `f''' + 2 α R f f' + 4 α² f' = 0`, α = 5°, R = 80.
static HAMEL: Many = Many {
    orders: &[3],
    derivatives: |_, z, f, rows| {
        let (a, b) = (2.0 * 0.0873 * 80.0, 4.0 * 0.0873 * 0.0873);
        f[0] = -a * z[0] * z[1] - b * z[1];
        rows.copy_from_slice(&[-a * z[1], -a * z[0] - b, 0.0]);
    },
    left: &[(0, 1.0), (1, 0.0)],
    right: &[(0, 0.0)],
    guess: |x, z| z.copy_from_slice(&[1.0 - x * x, -2.0 * x, -2.0]),
};

/// Along a heated vertical plate: `f''' + 3 f f'' - 2 f'² + T = 0`, `T'' + 3 P f T' = 0`, P = 0.7.
static CONVECTION: Many = Many {
    orders: &[3, 2],
    derivatives: |_, z, f, rows| {
        f[0] = -3.0 * z[0] * z[2] + 2.0 * z[1] * z[1] - z[3];
        f[1] = -2.1 * z[0] * z[4];
        rows.copy_from_slice(&[
            -3.0 * z[2],
            4.0 * z[1],
            -3.0 * z[0],
            -1.0,
            0.0,
            -2.1 * z[4],
            0.0,
            0.0,
            0.0,
            -2.1 * z[0],
        ]);
    },
    left: &[(0, 0.0), (1, 0.0), (3, 1.0)],
    right: &[(1, 0.0), (3, 0.0)],
    guess: |x, z| {
        let e = (-x).exp();
        z.copy_from_slice(&[0.5 * (1.0 - e * (1.0 + x)), 0.5 * x * e, 0.5 * e * (1.0 - x), e, -e]);
    },
};

/// Flow between plates that approach each other, in a magnetic field.
static FILM: Many = Many {
    orders: &[4],
    derivatives: |x, z, f, rows| {
        let (s, m) = (2.0, 4.0);
        f[0] = s * (x * z[3] + 3.0 * z[2] + z[1] * z[2] - z[0] * z[3]) + m * z[2];
        rows.copy_from_slice(&[-s * z[3], s * z[2], s * (3.0 + z[1]) + m, s * (x - z[0])]);
    },
    left: &[(0, 0.0), (2, 0.0)],
    right: &[(0, 1.0), (1, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// Above a sheet that is stretched: `f''' + f f'' - f'² = 0`.
static SHEET: Many = Many {
    orders: &[3],
    derivatives: |_, z, f, rows| {
        f[0] = z[1] * z[1] - z[0] * z[2];
        rows.copy_from_slice(&[-z[2], 2.0 * z[1], -z[0]]);
    },
    left: &[(0, 0.0), (1, 1.0)],
    right: &[(1, 0.0)],
    guess: |x, z| z.copy_from_slice(&[x - x * x / 16.0, 1.0 - x / 8.0, -0.125]),
};

/// Flow over a rotating disc, in T. von Kármán's variables: `f''' + 2 f f'' - f'² + g² = 0`,
/// `g'' + 2 f g' - 2 f' g = 0`.
static KARMAN: Many = Many {
    orders: &[3, 2],
    derivatives: |_, z, f, rows| {
        f[0] = z[1] * z[1] - 2.0 * z[0] * z[2] - z[3] * z[3];
        f[1] = 2.0 * z[1] * z[3] - 2.0 * z[0] * z[4];
        rows.copy_from_slice(&[
            -2.0 * z[2],
            2.0 * z[1],
            -2.0 * z[0],
            -2.0 * z[3],
            0.0,
            -2.0 * z[4],
            2.0 * z[3],
            0.0,
            2.0 * z[1],
            -2.0 * z[0],
        ]);
    },
    left: &[(0, 0.0), (1, 0.0), (3, 1.0)],
    right: &[(1, 0.0), (3, 0.0)],
    guess: |x, z| z.copy_from_slice(&[0.0, 0.0, 0.0, 1.0 - x / 8.0, -0.125]),
};

/// A beam, clamped and supported, on a foundation that stiffens.
static FOUNDATION: Many = Many {
    orders: &[4],
    derivatives: |x, z, f, rows| {
        f[0] = 5e3 * x - 400.0 * z[0] - 1e3 * z[0].powi(3);
        rows.copy_from_slice(&[-400.0 - 3e3 * z[0] * z[0], 0.0, 0.0, 0.0]);
    },
    left: &[(0, 0.0), (1, 0.0)],
    right: &[(0, 0.0), (2, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// Van der Pol's oscillator with the control that costs least: states and adjoint states.
static CONTROLLED: Many = Many {
    orders: &[1, 1, 1, 1],
    derivatives: |_, z, f, rows| {
        let (x, y, p, q) = (z[0], z[1], z[2], z[3]);
        f.copy_from_slice(&[
            (1.0 - y * y) * x - y - 0.5 * p,
            x,
            -2.0 * x - p * (1.0 - y * y) - q,
            -2.0 * y + p * (2.0 * x * y + 1.0),
        ]);
        rows.copy_from_slice(&[
            1.0 - y * y,
            -2.0 * x * y - 1.0,
            -0.5,
            0.0,
            1.0,
            0.0,
            0.0,
            0.0,
            -2.0,
            2.0 * p * y,
            -(1.0 - y * y),
            -1.0,
            2.0 * p * y,
            -2.0 + 2.0 * p * x,
            2.0 * x * y + 1.0,
            0.0,
        ]);
    },
    left: &[(0, 0.0), (1, 1.0)],
    right: &[(2, 0.0), (3, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// From one place to another about a centre of attraction, in a given time.
static TRANSFER: Many = Many {
    orders: &[2, 2],
    derivatives: |_, z, f, rows| {
        let (x, y) = (z[0], z[2]);
        let r2 = x * x + y * y;
        let r3 = r2 * r2.sqrt();
        let r5 = r3 * r2;
        f.copy_from_slice(&[-x / r3, -y / r3]);
        rows.copy_from_slice(&[
            3.0 * x * x / r5 - 1.0 / r3,
            0.0,
            3.0 * x * y / r5,
            0.0,
            3.0 * x * y / r5,
            0.0,
            3.0 * y * y / r5 - 1.0 / r3,
            0.0,
        ]);
    },
    left: &[(0, 1.0), (2, 0.0)],
    right: &[(0, 0.0), (2, 1.2)],
    guess: |x, z| z.copy_from_slice(&[1.0 - x / 2.0, -0.5, 0.6 * x, 0.6]),
};

/// Two substances that react and diffuse.
static BRUSSELATOR: Many = Many {
    orders: &[2, 2],
    derivatives: |_, z, f, rows| {
        let (u, v) = (z[0], z[2]);
        let (du, dv) = (0.01, 0.1);
        f.copy_from_slice(&[-(1.0 - 2.7 * u + u * u * v) / du, -(1.7 * u - u * u * v) / dv]);
        rows.copy_from_slice(&[
            (2.7 - 2.0 * u * v) / du,
            0.0,
            -u * u / du,
            0.0,
            -(1.7 - 2.0 * u * v) / dv,
            0.0,
            u * u / dv,
            0.0,
        ]);
    },
    left: &[(0, 1.3), (2, 1.5)],
    right: &[(0, 1.0), (2, 1.7)],
    guess: |_, z| z.copy_from_slice(&[1.0, 0.0, 1.7, 0.0]),
};

/// Weight and bending stiffness: angle, with the horizontal force and places as further states.
static ELASTICA: Many = Many {
    orders: &[2, 1, 1, 1],
    derivatives: |s, z, f, rows| {
        let (angle, h) = (z[0], z[4]);
        let (sin, cos) = angle.sin_cos();
        let (e, v) = (0.02, s - 0.5);
        f.copy_from_slice(&[(h * sin - v * cos) / e, cos, sin, 0.0]);
        rows.fill(0.0);
        (rows[0], rows[4]) = ((h * cos + v * sin) / e, sin / e);
        (rows[5], rows[10]) = (-sin, cos);
    },
    left: &[(0, -0.3), (2, 0.0), (3, 0.0)],
    right: &[(0, 0.3), (2, 0.8)],
    guess: |s, z| z.copy_from_slice(&[-0.3 + 0.6 * s, 0.6, 0.8 * s, 0.0, 0.3]),
};

/// A clamped plate under tension, and a load: layers at both ends.
static PLATE: Many = Many {
    orders: &[4],
    derivatives: |x, z, f, rows| {
        f[0] = (z[2] + 1.0 + x) / 4e-4;
        rows.copy_from_slice(&[0.0, 0.0, 1.0 / 4e-4, 0.0]);
    },
    left: &[(0, 0.0), (1, 0.0)],
    right: &[(0, 0.0), (1, 0.0)],
    guess: |_, z| z.fill(0.0),
};

/// A linear oscillator with the control that costs least.
static REGULATOR: Many = Many {
    orders: &[1, 1, 1, 1],
    derivatives: |x, z, f, rows| {
        f.copy_from_slice(&[z[1], -4.0 * z[0] - 100.0 * z[3], -25.0 * z[0] + 4.0 * z[3] + x.sin(), -z[1] - z[2]]);
        rows.fill(0.0);
        rows[1] = 1.0;
        (rows[4], rows[7]) = (-4.0, -100.0);
        (rows[8], rows[11]) = (-25.0, 4.0);
        (rows[13], rows[14]) = (-1.0, -1.0);
    },
    left: &[(0, 1.0), (1, 0.0)],
    right: &[(2, 0.0), (3, 0.0)],
    guess: |_, z| z.fill(0.0),
};
