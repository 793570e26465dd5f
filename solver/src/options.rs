//! What a solve may be told.

use crate::cancel::Cancel;
use crate::error::SolveError;
use crate::tableau::{GAUSS_6, ORDER_4, ORDER_6, ORDER_8, Tableau};

/// Order of the collocation method: of node values, dense output and integrals where the solution is smooth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Order {
    /// Three-stage Lobatto IIIA: for right-hand sides with kinks, and for low accuracy.
    #[default]
    Four,
    /// Five-stage mono-implicit Runge-Kutta: fewer intervals where the solution is smooth.
    Six,
    /// Five-stage Lobatto IIIA: a third of the intervals of order 6 where solutions are smooth, and half of its
    /// evaluations to nine digits. Each interval has three points inside whose states are unknowns, which are
    /// eliminated interval by interval. Where the iteration fails, order 6 finds where it is to start from;
    /// where it fails with a lower order, this one does.
    ///
    /// The right-hand side need not be defined at the ends of a region, where an equation may be singular (`2 u'/x` at
    /// 0): the interval beside such an end is collocated at its other points alone, and what is said of slopes there is
    /// extrapolated from these.
    Eight,
    /// Collocation at three Gauss points, order 6: none of them is an end, so that there, too, the right-hand side need
    /// not be defined. Inner points are unknowns, as at order 8; no other order is tried where the iteration fails. The
    /// other orders do more for as much work.
    SixGauss,
}

impl Order {
    /// As a number.
    pub fn number(self) -> usize {
        self.tableau().order
    }

    /// The power of the intervals' length that their defects go with, where the solution is smooth.
    pub fn defect_exponent(self) -> u32 {
        self.tableau().defect_order as u32
    }

    pub(crate) fn tableau(self) -> &'static Tableau {
        match self {
            Self::Four => &ORDER_4,
            Self::Six => &ORDER_6,
            Self::Eight => &ORDER_8,
            Self::SixGauss => &GAUSS_6,
        }
    }
}

/// What the tolerance bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Control {
    /// The defect.
    Defect,
    /// The defect, and where that is not enough also the estimated true error: the defect is then held to less, as far
    /// as the mesh may grow and rounding allows. A solution whose error could not be brought down is refused, unless
    /// [`Options::accept_inaccurate`] is set.
    #[default]
    Error,
}

/// One component of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// A state, by the indices of its region and within the region.
    State {
        /// Index of the region.
        region: usize,
        /// Index of the state in the region.
        state: usize,
    },
    /// A constant, by its index in the layout.
    Constant(usize),
}

/// Tolerances of one component, in place of those for all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComponentTolerance {
    /// Whose.
    pub of: Which,
    /// Relative to the component's largest magnitude over its region. Default: [`Options::tolerance`].
    pub relative: Option<f64>,
    /// In the component's own unit. Default: `tolerance` times the scale that the layout states for the component; if
    /// it states none, [`Options::absolute_tolerance`].
    pub absolute: Option<f64>,
}

/// Tolerances and limits.
///
/// A component is held to `max(relative * |y|, absolute)`, with |y| its largest magnitude over the region. By default
/// both tolerances are [`tolerance`](Self::tolerance), so that what is much smaller than 1 is known to 1e-6 only,
/// however small it is: where such a component matters, state its [`scale`](crate::State::scale) in the layout, or
/// lower the absolute tolerance here.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Order of the method.
    pub order: Order,
    /// What `tolerance` bounds.
    pub control: Control,
    /// Relative tolerance: largest relative defect of the solution (see
    /// [`Solution::max_defect`](crate::Solution::max_defect)) and, as `control` says, largest error.
    pub tolerance: f64,
    /// Absolute tolerance of all components for which the layout states no scale: SciPy's and SUNDIALS' `atol`.
    /// Default: as `tolerance`.
    pub absolute_tolerance: Option<f64>,
    /// Components with tolerances of their own; the later entry counts.
    pub components: Vec<ComponentTolerance>,
    /// Whether a solution whose estimated error exceeds the tolerance, and could not be brought below it, is a success
    /// all the same. It says so then: [`Accuracy::Short`](crate::Accuracy::Short). If not, it is
    /// [`SolveError::Inaccurate`]. Default: false.
    pub accept_inaccurate: bool,
    /// Whether integrals are held to the tolerance as states are: what quadrature adds to their errors counts in the
    /// estimated error, and intervals are divided where integrands ask for it. Without, that is left to the caller, who
    /// has [`Linearisation::error`](crate::Linearisation::error). Default: yes.
    pub integrals: bool,
    /// Largest boundary residual, relative to the largest term of its equation. Default: as `tolerance`.
    pub boundary_tolerance: Option<f64>,
    /// Largest component of the last Newton correction, relative to typical magnitudes. Default: a hundredth of
    /// `tolerance`, but at least 1e-13.
    pub newton_tolerance: Option<f64>,
    /// Newton iterations on one mesh.
    pub max_iterations: usize,
    /// Damping factor below which Newton's iteration counts as stalled.
    pub smallest_damping: f64,
    /// Intervals up to which the mesh of a region may be refined; one that is given may have more, and keeps them.
    pub max_intervals: usize,
    /// Meshes in one solve.
    pub max_meshes: usize,
    /// How often meshes are halved when Newton's iteration fails on them. If that does not help, and unless this is 0,
    /// the iteration starts again from the guess, with another order, and without insisting on progress at every step.
    pub rescues: usize,
    /// Whether, when Newton's iteration fails, it may start again from the guess on meshes for the layers that the
    /// derivatives there allow, order 8 may find where the others start, and finer meshes may be given up for the
    /// guess. It helps where layers are not resolved yet. Where what fails is a step across kinks, or a caller has
    /// other ways to a solution, it only costs time. (Order 8 may always start from order 6.) Default: true.
    pub other_orders: bool,
    /// Whether the estimated error is taken off the solution in the end: off its states at the nodes, its constants and
    /// its integrals (defect correction: H. J. Stetter, Numer. Math. 29 (1978) 425-443). Where solutions are smooth and
    /// meshes resolve them, what is left there is smaller by two orders in the length of the intervals; where problems
    /// are nonlinear, besides it as much of the error as the last iteration's matrix is off. Where the nodes are far
    /// better than the estimate says, it makes them worse, by no more than the tolerance. Between nodes the solution
    /// moves with them, and is no better than it was; where it would move farther, as where equations are stiff,
    /// nothing is taken off. The collocation equations hold no more exactly then than the error was large; the boundary
    /// equations are met as before, or nothing is taken off; defects and error estimates are those of what was found:
    /// see [`Solution::is_corrected`](crate::Solution::is_corrected). The points of a branch, from which it goes on,
    /// are not corrected; what a continuation leads to is. Default: false.
    ///
    /// Bratu's problem on ten intervals:
    ///
    /// ```
    /// use solver::{Options, bvp::Bvp};
    ///
    /// let string = Bvp::new(
    ///     &["u", "slope"],
    ///     (0.0, 1.0),
    ///     |_, y, _, f| (f[0], f[1]) = (y[1], -y[0].exp()),
    ///     |a, b, _, g| (g[0], g[1]) = (a[0], b[0]),
    /// );
    /// let middle = |defect_correction| {
    ///     let options = Options { tolerance: 1e-4, defect_correction, ..Options::default() };
    ///     string.solve(&options).map(|solution| solution.regions()[0].state(0)[5])
    /// };
    /// let error = |u: f64| (u - 0.140_539_214_400_472).abs();
    /// assert!(error(middle(true)?) < 0.03 * error(middle(false)?));
    /// # Ok::<(), solver::SolveError>(())
    /// ```
    pub defect_correction: bool,
    /// Points at which the right-hand side may be evaluated, with its derivatives or without
    /// ([`Stats::points`](crate::Stats::points)), by the whole call: by all meshes of a solve, all steps of a
    /// continuation, all attempts of an automatic solve. Beyond it the call ends with [`SolveError::WorkLimit`].
    /// Default: 1000 times `max_intervals`: a few seconds for 20,000 intervals, minutes for a million.
    pub work_limit: Option<usize>,
    /// Ends the whole call from outside, with [`SolveError::Cancelled`]. Default: none.
    pub cancel: Option<Cancel>,
}

/// Points that each interval a region may have stands for in the default of the work limit.
const POINTS_PER_INTERVAL: usize = 1000;

impl Default for Options {
    fn default() -> Self {
        Self {
            order: Order::default(),
            control: Control::default(),
            tolerance: 1e-6,
            absolute_tolerance: None,
            components: Vec::new(),
            accept_inaccurate: false,
            integrals: true,
            boundary_tolerance: None,
            newton_tolerance: None,
            max_iterations: 50,
            smallest_damping: 1e-5,
            max_intervals: 20_000,
            max_meshes: 40,
            rescues: 2,
            other_orders: true,
            defect_correction: false,
            work_limit: None,
            cancel: None,
        }
    }
}

impl Options {
    /// The boundary tolerance in force.
    pub fn boundary_tolerance(&self) -> f64 {
        self.boundary_tolerance.unwrap_or(self.tolerance)
    }

    /// The Newton tolerance in force.
    pub fn newton_tolerance(&self) -> f64 {
        self.newton_tolerance.unwrap_or_else(|| (0.01 * self.tolerance).max(1e-13))
    }

    /// For a tolerance that is not tighter than this one: those of components grow in proportion. What is said of the
    /// boundary residuals and of Newton's corrections stays.
    pub(crate) fn loosened(&self, tolerance: f64) -> Self {
        let mut options = self.clone();
        options.tolerance = tolerance.max(self.tolerance);
        let factor = options.tolerance / self.tolerance;
        let loosen = |value: &mut Option<f64>| *value = value.map(|value| value * factor);
        loosen(&mut options.absolute_tolerance);
        for component in &mut options.components {
            loosen(&mut component.relative);
            loosen(&mut component.absolute);
        }
        options
    }

    /// The work limit in force.
    pub fn work_limit(&self) -> usize {
        self.work_limit.unwrap_or_else(|| POINTS_PER_INTERVAL.saturating_mul(self.max_intervals))
    }

    /// Corrections of this size are accepted where rounding prevents smaller ones.
    pub(crate) fn stagnation_tolerance(&self) -> f64 {
        self.newton_tolerance.unwrap_or(0.1 * self.tolerance)
    }

    pub(crate) fn check(&self) -> Result<(), SolveError> {
        let of_all = [
            ("tolerance", self.tolerance),
            ("boundary_tolerance", self.boundary_tolerance()),
            ("newton_tolerance", self.newton_tolerance()),
            ("smallest_damping", self.smallest_damping),
        ];
        let stated = [("absolute_tolerance", self.absolute_tolerance)];
        let components = self.components.iter().flat_map(|component| {
            [("relative tolerance of a component", component.relative), ("its absolute tolerance", component.absolute)]
        });
        let stated = stated.into_iter().chain(components).filter_map(|(name, value)| Some((name, value?)));
        positive(of_all.into_iter().chain(stated))?;
        at_least_one([
            ("max_iterations", self.max_iterations),
            ("max_meshes", self.max_meshes),
            ("max_intervals", self.max_intervals),
        ])
    }
}

/// # Errors
/// The first that is zero.
pub(crate) fn at_least_one(limits: impl IntoIterator<Item = (&'static str, usize)>) -> Result<(), SolveError> {
    match limits.into_iter().find(|(_, value)| *value == 0) {
        Some((name, _)) => Err(SolveError::Option { name, value: 0.0, expected: "at least 1" }),
        None => Ok(()),
    }
}

/// # Errors
/// The first that is not a positive number.
pub(crate) fn positive(options: impl IntoIterator<Item = (&'static str, f64)>) -> Result<(), SolveError> {
    match options.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
        Some((name, value)) => Err(SolveError::Option { name, value, expected: "a positive number" }),
        None => Ok(()),
    }
}
