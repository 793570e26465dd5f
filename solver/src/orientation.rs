//! Which of several solutions it is: the sign of the linearised problem's determinant, and what speaks against a
//! solution being the one that its start leads to.

/// Sign of the determinant of a problem linearised at a solution. It does not depend on the mesh, once that resolves
/// the solution. Along a branch it changes at folds and at simple branch points, and nowhere else: two solutions of
/// unlike orientation are not joined by a path without one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Orientation {
    /// The determinant is positive.
    Positive,
    /// The determinant is negative.
    Negative,
}

impl Orientation {
    /// Of a number that is not zero; none for zero and NaN.
    pub(crate) fn of(determinant: f64) -> Option<Self> {
        match determinant {
            d if d > 0.0 => Some(Self::Positive),
            d if d < 0.0 => Some(Self::Negative),
            _ => None,
        }
    }
}

/// A determinant that may be far from 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Determinant {
    /// Its sign.
    pub orientation: Option<Orientation>,
    /// Of its magnitude.
    pub logarithm: f64,
}

impl Determinant {
    pub(crate) const UNKNOWN: Self = Self::of_sign(None);

    /// One of which no more is known than its sign.
    pub(crate) const fn of_sign(orientation: Option<Orientation>) -> Self {
        Self { orientation, logarithm: f64::NAN }
    }

    /// Relative to the magnitude of another; NaN if it is singular or unknown.
    pub(crate) fn relative(&self, to: &Self) -> f64 {
        let size = if to.logarithm.is_finite() { libm::exp(self.logarithm - to.logarithm) } else { 1.0 };
        match self.orientation {
            Some(Orientation::Positive) => size,
            Some(Orientation::Negative) => -size,
            None => f64::NAN,
        }
    }
}

/// Whether a solution can be vouched for as the one that its guess, or the start of its path, leads to. Where a problem
/// has one solution only, this does not matter.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BranchCheck {
    /// Newton's iteration contracted at once, by half at least, wherever it was started, and the orientation stayed the
    /// same.
    Kept,
    /// Newton's iteration went a long way from a start: it took damped steps, contracted slowly at first, or had to be
    /// started anew. Another solution may be nearer to the start.
    Strayed {
        /// Path parameter of the step; 0 if there is no path.
        at: f64,
    },
    /// The orientation changed, between two meshes or two steps: a fold or a branch point was passed, or another branch
    /// was met.
    Turned {
        /// Path parameter of the step; 0 if there is no path.
        at: f64,
    },
}

/// The first contraction of Newton's iteration up to which its limit is taken for the solution nearest to its start. At
/// 1/2 the theorem of Newton and Mysovskikh gives uniqueness in a ball about the start (P. Deuflhard, "Newton Methods
/// for Nonlinear Problems", Springer 2004, section 2.1).
const NEAR: f64 = 0.5;

impl BranchCheck {
    /// One Newton iteration: its first contraction, and whether all its steps were full.
    pub(crate) fn of_iteration(contraction: f64, full_steps: bool) -> Self {
        if full_steps && contraction <= NEAR { Self::Kept } else { Self::Strayed { at: 0.0 } }
    }

    /// The graver of two; of two that are alike the earlier.
    #[must_use]
    pub(crate) fn and(self, later: Self) -> Self {
        if later.gravity() > self.gravity() { later } else { self }
    }

    /// The same, on a path.
    #[must_use]
    pub(crate) fn placed(self, at: f64) -> Self {
        match self {
            Self::Kept => Self::Kept,
            Self::Strayed { .. } => Self::Strayed { at },
            Self::Turned { .. } => Self::Turned { at },
        }
    }

    /// After a step between two orientations, as far as they are known.
    #[must_use]
    pub(crate) fn across(self, before: Option<Orientation>, after: Option<Orientation>) -> Self {
        match (before, after) {
            (Some(before), Some(after)) if before != after => self.and(Self::Turned { at: 0.0 }),
            _ => self,
        }
    }

    fn gravity(self) -> u8 {
        match self {
            Self::Kept => 0,
            Self::Strayed { .. } => 1,
            Self::Turned { .. } => 2,
        }
    }
}
