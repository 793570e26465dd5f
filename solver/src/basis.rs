//! What the continuous extension is a weighted sum of: see [`interpolant`](crate::collocation::interpolant).

/// What a continuous extension is made of beside `y_0`: see [`Basis`].
pub(crate) const PARTS: usize = 7;

/// Weights of `y_0`, `y_1 - y_0`, `h f_0`, `h f_1`, `α`, `β`, `γ`, `δ` in S and in its derivatives at one σ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Basis {
    pub rise: f64,
    pub left: f64,
    pub right: f64,
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    pub delta: f64,
}

impl Basis {
    /// Weights in S; that of `y_0` is 1.
    #[inline]
    pub(crate) fn value(x: f64) -> Self {
        let z = 1.0 - x;
        let (bump, t) = (x * x * z * z, x - 0.5);
        Self {
            rise: x * x * (3.0 - 2.0 * x),
            left: x * z * z,
            right: -x * x * z,
            alpha: bump,
            beta: bump * t,
            gamma: bump * t * t,
            delta: bump * t * t * t,
        }
    }

    /// Weights in dS/dσ; that of `y_0` is 0.
    #[inline]
    pub(crate) fn slope(x: f64) -> Self {
        let z = 1.0 - x;
        let (value, bump, t) = (x * x * z * z, 2.0 * x * z * (1.0 - 2.0 * x), x - 0.5);
        Self {
            rise: 6.0 * x * z,
            left: z * (1.0 - 3.0 * x),
            right: -x * (2.0 - 3.0 * x),
            alpha: bump,
            beta: bump * t + value,
            gamma: bump * t * t + 2.0 * value * t,
            delta: bump * t * t * t + 3.0 * value * t * t,
        }
    }

    /// All of them but that of `y_0`.
    pub(crate) fn weights(&self) -> [f64; PARTS] {
        let Self { rise, left, right, alpha, beta, gamma, delta } = *self;
        [rise, left, right, alpha, beta, gamma, delta]
    }

    /// Weights in d²S/dσ²; that of `y_0` is 0.
    pub(crate) fn curvature(x: f64) -> Self {
        let (slope, curvature) = (2.0 * x * (1.0 - x) * (1.0 - 2.0 * x), 2.0 - 12.0 * x * (1.0 - x));
        let (value, t) = (x * x * (1.0 - x) * (1.0 - x), x - 0.5);
        Self {
            rise: 6.0 - 12.0 * x,
            left: 6.0 * x - 4.0,
            right: 6.0 * x - 2.0,
            alpha: curvature,
            beta: curvature * t + 2.0 * slope,
            gamma: curvature * t * t + 4.0 * slope * t + 2.0 * value,
            delta: curvature * t * t * t + 6.0 * slope * t * t + 6.0 * value * t,
        }
    }
}
