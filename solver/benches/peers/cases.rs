//! What a case is, and equations of second order with known solutions: J. R. Cash's collection
//! (https://archimede.uniba.it/~bvpsolvers/testsetbvpsolvers) by its numbers, and more: nonlinear ones, and pairs of
//! equations with layers of two widths.

use std::f64::consts::PI;

/// Equations of orders 1 to 4, with values given at both ends.
pub struct Case {
    pub name: &'static str,
    pub interval: (f64, f64),
    pub linear: bool,
    pub equations: Equations,
}

/// The right-hand side with its derivatives.
pub enum Equations {
    /// `u'' = F(x, u, u')` by F, ∂F/∂u, ∂F/∂u', and the solution, whose values at the ends are the boundary conditions.
    One(fn(f64, f64, f64) -> [f64; 3], fn(f64) -> f64),
    /// Two of them, of states u₁, u₁', u₂, u₂': both F, each with its derivatives with respect to the states.
    Two(fn(f64, [f64; 4]) -> [[f64; 5]; 2], fn(f64) -> [f64; 2]),
    /// As `One`, with the values of u at the ends, and a guess: the solution is not known.
    Open(fn(f64, f64, f64) -> [f64; 3], [f64; 2], Guess),
    /// Of any orders.
    Many(&'static Many),
}

/// Of u and u'.
#[derive(Debug, Clone, Copy)]
pub enum Guess {
    Zero,
    /// The straight line between the values at the ends.
    Line,
    Constant(f64),
}

/// At x and states z, into values and into rows.
pub type Derivatives = fn(f64, &[f64], &mut [f64], &mut [f64]);

/// Equations of any orders, whose solution is not known. States: of each equation u, and its derivatives up to one less
/// than its order.
pub struct Many {
    pub orders: &'static [usize],
    /// The highest derivatives, and their derivatives with respect to the states, by rows.
    pub derivatives: Derivatives,
    /// What is given at the left end: states and their values,
    pub left: &'static [(usize, f64)],
    /// and at the right end.
    pub right: &'static [(usize, f64)],
    pub guess: fn(f64, &mut [f64]),
}

/// Most states.
pub const STATES: usize = 8;

/// What is given at one end.
#[derive(Debug, Clone, Copy)]
pub struct Condition {
    pub on_the_right: bool,
    pub state: usize,
    pub value: f64,
}

impl Case {
    /// The order of each equation.
    pub fn orders(&self) -> &'static [usize] {
        match self.equations {
            Equations::One(..) | Equations::Open(..) => &[2],
            Equations::Two(..) => &[2, 2],
            Equations::Many(many) => many.orders,
        }
    }

    /// How many equations.
    pub fn equations(&self) -> usize {
        self.orders().len()
    }

    pub fn states(&self) -> usize {
        self.orders().iter().sum()
    }

    /// The first state of each equation: its u.
    pub fn unknowns(&self) -> impl Iterator<Item = usize> + Clone {
        self.orders().iter().scan(0, |next, order| {
            let first = *next;
            *next += order;
            Some(first)
        })
    }

    /// u at x, where it is known.
    pub fn exact(&self, x: f64) -> Option<[f64; 2]> {
        match self.equations {
            Equations::One(_, exact) => Some([exact(x), 0.0]),
            Equations::Two(_, exact) => Some(exact(x)),
            Equations::Open(..) | Equations::Many(_) => None,
        }
    }

    /// Those at the left end first.
    pub fn conditions(&self) -> Vec<Condition> {
        let all = |left: &[(usize, f64)], right: &[(usize, f64)]| {
            let at = |on_the_right| move |&(state, value): &(usize, f64)| Condition { on_the_right, state, value };
            left.iter().map(at(false)).chain(right.iter().map(at(true))).collect()
        };
        let (left, right) = self.interval;
        match self.equations {
            Equations::One(_, exact) => all(&[(0, exact(left))], &[(0, exact(right))]),
            Equations::Two(_, exact) => {
                let ([a1, a2], [b1, b2]) = (exact(left), exact(right));
                all(&[(0, a1), (2, a2)], &[(0, b1), (2, b2)])
            }
            Equations::Open(_, [a, b], _) => all(&[(0, a)], &[(0, b)]),
            Equations::Many(many) => all(many.left, many.right),
        }
    }

    /// Whether the equations are undefined at an end.
    pub fn is_singular(&self) -> bool {
        let Equations::One(f, _) = self.equations else { return false };
        let (a, b) = self.interval;
        [a, b].iter().any(|x| f(*x, 1.0, 1.0).iter().any(|value| !value.is_finite()))
    }

    /// Of all states at x.
    pub fn guess(&self, x: f64, z: &mut [f64]) {
        match self.equations {
            Equations::One(..) | Equations::Two(..) => z.fill(0.0),
            Equations::Open(_, [left, right], guess) => {
                let (a, b) = self.interval;
                let slope = (right - left) / (b - a);
                z.copy_from_slice(&match guess {
                    Guess::Zero => [0.0; 2],
                    Guess::Line => [left + slope * (x - a), slope],
                    Guess::Constant(u) => [u, 0.0],
                });
            }
            Equations::Many(many) => (many.guess)(x, z),
        }
    }

    /// The highest derivatives at states z.
    #[inline]
    pub fn values(&self, x: f64, z: &[f64], out: &mut [f64]) {
        match self.equations {
            Equations::One(f, _) | Equations::Open(f, ..) => out[0] = f(x, z[0], z[1])[0],
            Equations::Two(f, _) => {
                let rows = f(x, [z[0], z[1], z[2], z[3]]);
                (out[0], out[1]) = (rows[0][0], rows[1][0]);
            }
            Equations::Many(many) => {
                let mut rows = [0.0; STATES * STATES];
                (many.derivatives)(x, z, out, &mut rows[..out.len() * z.len()]);
            }
        }
    }

    /// Their derivatives with respect to z, by rows; they themselves into `values`.
    #[inline]
    pub fn derivatives(&self, x: f64, z: &[f64], values: &mut [f64], rows: &mut [f64]) {
        match self.equations {
            Equations::One(f, _) | Equations::Open(f, ..) => {
                let [value, by_u, by_slope] = f(x, z[0], z[1]);
                (values[0], rows[0], rows[1]) = (value, by_u, by_slope);
            }
            Equations::Two(f, _) => {
                for (i, [value, by @ ..]) in f(x, [z[0], z[1], z[2], z[3]]).into_iter().enumerate() {
                    values[i] = value;
                    rows[4 * i..4 * i + 4].copy_from_slice(&by);
                }
            }
            Equations::Many(many) => (many.derivatives)(x, z, values, rows),
        }
    }
}

/// The error function: its series, or the continued fraction of its complement.
fn erf(x: f64) -> f64 {
    let a = x.abs();
    let value = if a < 2.5 {
        let (mut term, mut sum) = (a, a);
        for n in 1..120 {
            term *= -a * a / f64::from(n);
            sum += term / f64::from(2 * n + 1);
        }
        2.0 / PI.sqrt() * sum
    } else {
        let mut fraction = a;
        for n in (1..=200).rev() {
            fraction = a + 0.5 * f64::from(n) / fraction;
        }
        1.0 - (-a * a).exp() / (PI.sqrt() * fraction)
    };
    value.copysign(x)
}

fn cos(x: f64) -> f64 {
    (PI * x).cos()
}

fn sin(x: f64) -> f64 {
    (PI * x).sin()
}

/// Those with known solutions.
pub static CASES: &[Case] = &[
    Case {
        name: "1, ε = 1e-4",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 1.0, 0.0);
                [(source + a * u + b * v) / 1e-4, a / 1e-4, b / 1e-4]
            },
            |x| {
                let d = 1e-4_f64.sqrt();
                ((-x / d).exp() - ((x - 2.0) / d).exp()) / (1.0 - (-2.0 / d).exp())
            },
        ),
    },
    Case {
        name: "1, ε = 1e-6",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 1.0, 0.0);
                [(source + a * u + b * v) / 1e-6, a / 1e-6, b / 1e-6]
            },
            |x| {
                let d = 1e-6_f64.sqrt();
                ((-x / d).exp() - ((x - 2.0) / d).exp()) / (1.0 - (-2.0 / d).exp())
            },
        ),
    },
    Case {
        name: "2, ε = 1e-1",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 0.0, 1.0);
                [(source + a * u + b * v) / 1e-1, a / 1e-1, b / 1e-1]
            },
            |x| (1.0 - ((x - 1.0) / 1e-1).exp()) / (1.0 - (-1.0_f64 / 1e-1).exp()),
        ),
    },
    Case {
        name: "2, ε = 1e-3",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 0.0, 1.0);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| (1.0 - ((x - 1.0) / 1e-3).exp()) / (1.0 - (-1.0_f64 / 1e-3).exp()),
        ),
    },
    Case {
        name: "3, ε = 1e-3",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) =
                    (-(1.0 + 1e-3 * PI * PI) * cos(x) - (2.0 + cos(x)) * PI * sin(x), 1.0, -(2.0 + cos(x)));
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            cos,
        ),
    },
    Case {
        name: "4, ε = 1e-2",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 1.0 + 1e-2, -1.0);
                [(source + a * u + b * v) / 1e-2, a / 1e-2, b / 1e-2]
            },
            |x| (x - 1.0).exp() + (-(1.0 + 1e-2) * (1.0 + x) / 1e-2).exp(),
        ),
    },
    Case {
        name: "5, ε = 1e-2",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-2 * PI * PI) * cos(x) + PI * x * sin(x), 1.0, x);
                [(source + a * u + b * v) / 1e-2, a / 1e-2, b / 1e-2]
            },
            cos,
        ),
    },
    Case {
        name: "6, ε = 1e-3",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-1e-3 * PI * PI * cos(x) - PI * x * sin(x), 0.0, -x);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| cos(x) + erf(x / 2e-3_f64.sqrt()) / erf(1.0 / 2e-3_f64.sqrt()),
        ),
    },
    Case {
        name: "7, ε = 1e-3",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-3 * PI * PI) * cos(x) - PI * x * sin(x), 1.0, -x);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| {
                let (d, tail) = (2e-3_f64.sqrt(), |x: f64| (2e-3 / PI).sqrt() * (-x * x / 2e-3).exp());
                cos(x) + x + (x * erf(x / d) + tail(x)) / (erf(1.0 / d) + tail(1.0))
            },
        ),
    },
    Case {
        name: "8, ε = 1e-3",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 0.0, -1.0);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| (2.0 - (-1e3_f64).exp() - (-x / 1e-3).exp()) / (1.0 - (-1e3_f64).exp()),
        ),
    },
    Case {
        name: "9, ε = 1e-2",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let d = 1e-2 + x * x;
                [-(4.0 * x * v + 2.0 * u) / d, -2.0 / d, -4.0 * x / d]
            },
            |x| 1.0 / (1e-2 + x * x),
        ),
    },
    Case {
        name: "9, ε = 1e-4",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let d = 1e-4 + x * x;
                [-(4.0 * x * v + 2.0 * u) / d, -2.0 / d, -4.0 * x / d]
            },
            |x| 1.0 / (1e-4 + x * x),
        ),
    },
    Case {
        name: "10, ε = 1e-3",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0, 0.0, -x);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| 1.0 + erf(x / (2.0_f64 * 1e-3).sqrt()) / erf(1.0 / (2.0_f64 * 1e-3).sqrt()),
        ),
    },
    Case {
        name: "10, ε = 1e-5",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0, 0.0, -x);
                [(source + a * u + b * v) / 1e-5, a / 1e-5, b / 1e-5]
            },
            |x| 1.0 + erf(x / (2.0_f64 * 1e-5).sqrt()) / erf(1.0 / (2.0_f64 * 1e-5).sqrt()),
        ),
    },
    Case {
        name: "11, ε = 1e-3",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-3 * PI * PI) * cos(x), 1.0, 0.0);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            cos,
        ),
    },
    Case {
        name: "12, ε = 1e-4",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-4 * PI * PI) * cos(x), 1.0, 0.0);
                [(source + a * u + b * v) / 1e-4, a / 1e-4, b / 1e-4]
            },
            |x| cos(x) + ((x - 1.0) / 1e-2).exp(),
        ),
    },
    Case {
        name: "13, ε = 1e-4",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-4 * PI * PI) * cos(x), 1.0, 0.0);
                [(source + a * u + b * v) / 1e-4, a / 1e-4, b / 1e-4]
            },
            |x| cos(x) + (-(1.0 + x) / 1e-2).exp(),
        ),
    },
    Case {
        name: "14, ε = 1e-4",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-4 * PI * PI) * cos(x), 1.0, 0.0);
                [(source + a * u + b * v) / 1e-4, a / 1e-4, b / 1e-4]
            },
            |x| cos(x) + ((x - 1.0) / 1e-2).exp() + (-(1.0 + x) / 1e-2).exp(),
        ),
    },
    Case {
        name: "14, ε = 1e-6",
        interval: (-1.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (-(1.0 + 1e-6 * PI * PI) * cos(x), 1.0, 0.0);
                [(source + a * u + b * v) / 1e-6, a / 1e-6, b / 1e-6]
            },
            |x| cos(x) + ((x - 1.0) / 1e-3).exp() + (-(1.0 + x) / 1e-3).exp(),
        ),
    },
    Case {
        name: "16, ε = 0.11",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, -PI * PI / 4.0, 0.0);
                [(source + a * u + b * v) / 0.0121, a / 0.0121, b / 0.0121]
            },
            |x| (PI * x / 0.22).sin(),
        ),
    },
    Case {
        name: "17, ε = 1e-4",
        interval: (-0.1, 0.1),
        linear: true,
        equations: Equations::One(
            |x, u, _| {
                let a = -3e-4 / (1e-4 + x * x).powi(2);
                [a * u, a, 0.0]
            },
            |x| x / (1e-4 + x * x).sqrt(),
        ),
    },
    Case {
        name: "18, ε = 1e-3",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (0.0 * x, 0.0, -1.0);
                [(source + a * u + b * v) / 1e-3, a / 1e-3, b / 1e-3]
            },
            |x| (-x / 1e-3).exp(),
        ),
    },
    Case {
        name: "Stoer and Bulirsch, μ = 20",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) = (20.0 * 20.0 * cos(x).powi(2) + 2.0 * PI * PI * cos(2.0 * x), 20.0 * 20.0, 0.0);
                [(source + a * u + b * v) / 1.0, a / 1.0, b / 1.0]
            },
            |x| ((20.0 * (x - 1.0)).exp() + (-20.0 * x).exp()) / (1.0 + (-20.0_f64).exp()) - cos(x).powi(2),
        ),
    },
    Case {
        name: "Stoer and Bulirsch, μ = 400",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::One(
            |x, u, v| {
                let (source, a, b) =
                    (400.0 * 400.0 * cos(x).powi(2) + 2.0 * PI * PI * cos(2.0 * x), 400.0 * 400.0, 0.0);
                [(source + a * u + b * v) / 1.0, a / 1.0, b / 1.0]
            },
            |x| ((400.0 * (x - 1.0)).exp() + (-400.0 * x).exp()) / (1.0 + (-400.0_f64).exp()) - cos(x).powi(2),
        ),
    },
    Case {
        name: "20, ε = 0.5",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::One(
            |x, u, v| [(1.0 - v * v) / 0.5 + 0.0 * (x + u), 0.0, -2.0 * v / 0.5],
            |x| 1.0 + 0.5 * ((x - 0.745) / 0.5).cosh().ln(),
        ),
    },
    Case {
        name: "21, ε = 1e-3",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::One(
            |x, u, v| [(u + u * u - (-2.0 * x / 1e-3_f64.sqrt()).exp()) / 1e-3 + 0.0 * v, (1.0 + 2.0 * u) / 1e-3, 0.0],
            |x| (-x / 1e-3_f64.sqrt()).exp(),
        ),
    },
    Case {
        name: "Bratu, λ = 1",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::One(
            |x, u, v| [-u.exp() + 0.0 * (x + v), -u.exp(), 0.0],
            |x| {
                // λ = 8 θ²/cosh² θ = 1.
                const THETA: f64 = 0.379_291_149_762_689_5;
                2.0 * (THETA.cosh() / (THETA * (1.0 - 2.0 * x)).cosh()).ln()
            },
        ),
    },
    Case {
        name: "u'' = 3/2 u²",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::One(|x, u, v| [1.5 * u * u + 0.0 * (x + v), 3.0 * u, 0.0], |x| 4.0 / (1.0 + x).powi(2)),
    },
    Case {
        name: "u'' = 2 u³",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::One(|x, u, v| [2.0 * u * u * u + 0.0 * (x + v), 6.0 * u * u, 0.0], |x| 1.0 / (1.0 + x)),
    },
    Case {
        name: "u'' = -u'² - u + ln x",
        interval: (1.0, 2.0),
        linear: false,
        equations: Equations::One(|x, u, v| [-v * v - u + x.ln(), -1.0, -2.0 * v], |x| x.ln()),
    },
    Case {
        name: "u'' = 4 + x³/4 - u u'/8",
        interval: (1.0, 3.0),
        linear: false,
        equations: Equations::One(
            |x, u, v| [4.0 + x.powi(3) / 4.0 - u * v / 8.0, -v / 8.0, -u / 8.0],
            |x| x * x + 16.0 / x,
        ),
    },
    Case {
        name: "Two layers at each end, ε = 1e-2, 1e-3",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::Two(|x, z| two_layers(x, z, 1e-2, 1e-3), |x| two_widths(x, 1e-2, 1e-3)),
    },
    Case {
        name: "Two layers at each end, ε = 1e-2, 1e-4",
        interval: (0.0, 1.0),
        linear: true,
        equations: Equations::Two(|x, z| two_layers(x, z, 1e-2, 1e-4), |x| two_widths(x, 1e-2, 1e-4)),
    },
    Case {
        name: "Flow and heat, ε = 0.2",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::Two(|x, z| flow_and_heat(x, z, 0.2), |x| flow_and_heat_exact(x, 0.2)),
    },
    Case {
        name: "Flow and heat, ε = 0.1",
        interval: (0.0, 1.0),
        linear: false,
        equations: Equations::Two(|x, z| flow_and_heat(x, z, 0.1), |x| flow_and_heat_exact(x, 0.1)),
    },
];

/// `d² u₁'' = 2 u₁ - u₂ - s₁`, `e² u₂'' = 2 u₂ - u₁ - s₂`, whose sources make [`two_widths`] the solution: reaction and
/// diffusion of two substances (N. Madden and M. Stynes, IMA J. Numer. Anal. 23 (2003) 627-644).
fn two_layers(x: f64, z: [f64; 4], d: f64, e: f64) -> [[f64; 5]; 2] {
    let [u1, u2] = two_widths(x, d, e);
    let (wide, thin) = (layers(x, d), layers(x, e));
    let [c1, c2] = [wide / (d * d) + thin / (e * e) - PI * PI * cos(x), thin / (e * e) - PI * PI * sin(x)];
    let [s1, s2] = [2.0 * u1 - u2 - d * d * c1, 2.0 * u2 - u1 - e * e * c2];
    let (dd, ee) = (d * d, e * e);
    [
        [(2.0 * z[0] - z[2] - s1) / dd, 2.0 / dd, 0.0, -1.0 / dd, 0.0],
        [(2.0 * z[2] - z[0] - s2) / ee, -1.0 / ee, 0.0, 2.0 / ee, 0.0],
    ]
}

fn layers(x: f64, width: f64) -> f64 {
    (-x / width).exp() + ((x - 1.0) / width).exp()
}

fn two_widths(x: f64, d: f64, e: f64) -> [f64; 2] {
    [layers(x, d) + layers(x, e) + cos(x), layers(x, e) + sin(x)]
}

/// `ε u'' = u u' + θ - s₁` and `θ'' = u θ' + s₂`: a shock in u and what it does to θ.
fn flow_and_heat(x: f64, z: [f64; 4], e: f64) -> [[f64; 5]; 2] {
    let (t, theta, by_theta) = (((x - 0.5) / (2.0 * e)).tanh(), sin(x), PI * cos(x));
    let [u, _] = flow_and_heat_exact(x, e);
    // -tanh((x - 1/2)/2ε) satisfies ε u'' = u u'.
    debug_assert!((u + t).abs() < 1e-12);
    let (s1, s2) = (theta, -PI * PI * theta + t * by_theta);
    [[(z[0] * z[1] + z[2] - s1) / e, z[1] / e, z[0] / e, 1.0 / e, 0.0], [z[0] * z[3] + s2, z[3], 0.0, 0.0, z[0]]]
}

fn flow_and_heat_exact(x: f64, e: f64) -> [f64; 2] {
    [-((x - 0.5) / (2.0 * e)).tanh(), sin(x)]
}
