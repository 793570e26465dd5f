//! What a boundary value problem is.
//!
//! ```text
//! region r:   y_r' = f_r(s, y_r, c),          s in [a_r, b_r],   n_r states
//!             I_r  = ∫ q_r(s, y_r, c) ds,     k_r integrals
//! boundary:   g(y_1(a), y_1(b), ..., I, c) = 0,    Σ n_r + (number of unknown constants) equations
//! ```
//!
//! Regions meet only in the boundary equations, which may mix all ends, all integrals and all constants:
//! interface, multi-point, periodic and integral conditions are all of this kind. A region of unknown
//! length is written on a fixed interval with its length among the constants.

use thiserror::Error;

/// One state of a region.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Name that messages use.
    pub name: String,
    /// Typical magnitude, positive; the solver scales by the larger of this and what it finds.
    pub scale: Option<f64>,
}

/// A constant of the problem: given, or unknown and found by the solver.
#[derive(Debug, Clone, PartialEq)]
pub struct Constant {
    /// Name that messages use.
    pub name: String,
    /// Typical magnitude, positive; the solver scales by the larger of this and what it finds.
    pub scale: Option<f64>,
}

/// One region: an interval with its own states, integrals and mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Name that messages use.
    pub name: String,
    /// Interval `(a, b)` of the independent variable, `a < b`.
    pub interval: (f64, f64),
    /// The `n` states.
    pub states: Vec<State>,
    /// Names of the `k` integrals.
    pub integrals: Vec<String>,
    /// Structurally nonzero derivatives `(row, state)`; rows `0..n` are the right-hand side, rows `n..n+k` the
    /// integrands.
    pub state_pattern: Vec<(usize, usize)>,
    /// Structurally nonzero derivatives `(row, constant)`, rows as in `state_pattern`.
    pub constant_pattern: Vec<(usize, usize)>,
    /// How many leading entries of `constant_pattern` belong to the default unknowns: those constants that are unknown
    /// in most questions. They are what is written under [`Scope::DefaultUnknowns`].
    pub default_entries: usize,
}

impl Region {
    /// A region with dense patterns: every row depends on every state and on the first `constants` constants. Of what a
    /// formula owes to constants beyond these nothing is known: Newton's iteration lacks it where one of them is
    /// unknown, and so do sensitivities to it. [`check_derivatives`](crate::check_derivatives) names what is lacking.
    pub fn dense(name: &str, interval: (f64, f64), states: &[&str], integrals: &[&str], constants: usize) -> Self {
        let rows = states.len() + integrals.len();
        let all = |columns: usize| (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))).collect();
        let state_pattern = all(states.len());
        let constant_pattern: Vec<_> = all(constants);
        Self {
            name: name.to_owned(),
            interval,
            states: states.iter().map(|&name| State { name: name.to_owned(), scale: None }).collect(),
            integrals: integrals.iter().map(|&name| name.to_owned()).collect(),
            state_pattern,
            default_entries: constant_pattern.len(),
            constant_pattern,
        }
    }

    /// Rows of the kernel: states, then integrals.
    pub fn rows(&self) -> usize {
        self.states.len() + self.integrals.len()
    }
}

/// Names, sizes and sparsity of a problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// The regions, in the order in which ends and integrals are stacked.
    pub regions: Vec<Region>,
    /// All constants, given and unknown alike; which are unknown is chosen at solve time.
    pub constants: Vec<Constant>,
    /// Names of the boundary equations.
    pub equations: Vec<String>,
    /// Structurally nonzero derivatives `(equation, input)`; inputs are ends, then integrals, then constants.
    pub boundary_pattern: Vec<(usize, usize)>,
}

impl Layout {
    /// A layout whose boundary equations depend on every end, integral and constant.
    pub fn dense(regions: Vec<Region>, constants: &[&str], equations: &[&str]) -> Self {
        let mut layout = Self {
            regions,
            constants: constants.iter().map(|&name| Constant { name: name.to_owned(), scale: None }).collect(),
            equations: equations.iter().map(|&name| name.to_owned()).collect(),
            boundary_pattern: Vec::new(),
        };
        let inputs = layout.inputs();
        layout.boundary_pattern =
            (0..equations.len()).flat_map(|row| (0..inputs).map(move |input| (row, input))).collect();
        layout
    }

    /// Σ n_r.
    pub fn states(&self) -> usize {
        self.regions.iter().map(|region| region.states.len()).sum()
    }

    /// Number of end values: 2 Σ n_r.
    pub fn ends(&self) -> usize {
        2 * self.states()
    }

    /// Σ k_r.
    pub fn integrals(&self) -> usize {
        self.regions.iter().map(|region| region.integrals.len()).sum()
    }

    /// Inputs of the boundary equations: ends, integrals, constants.
    pub fn inputs(&self) -> usize {
        self.ends() + self.integrals() + self.constants.len()
    }

    /// Index among the ends of the entry (`exit = false`) or exit value of a state.
    pub fn end(&self, region: usize, state: usize, exit: bool) -> usize {
        let before: usize = self.regions.iter().take(region).map(|region| 2 * region.states.len()).sum();
        let here = self.regions.get(region).map_or(0, |region| region.states.len());
        before + state + if exit { here } else { 0 }
    }

    /// How messages name an input of the boundary equations.
    pub fn input_name(&self, input: usize) -> String {
        let mut rest = input;
        for region in &self.regions {
            let n = region.states.len();
            if rest < 2 * n {
                let end = if rest < n { "entry" } else { "exit" };
                return format!("{} at the {end} of {}", region.states[rest % n].name, region.name);
            }
            rest -= 2 * n;
        }
        for region in &self.regions {
            match region.integrals.get(rest) {
                Some(name) => return format!("integral {name} of {}", region.name),
                None => rest -= region.integrals.len(),
            }
        }
        self.constants.get(rest).map_or_else(|| format!("input {input}"), |c| format!("constant {}", c.name))
    }

    /// Index of the constant of this name.
    pub fn constant(&self, name: &str) -> Option<usize> {
        self.constants.iter().position(|constant| constant.name == name)
    }

    /// Index of the region of this name.
    pub fn region(&self, name: &str) -> Option<usize> {
        self.regions.iter().position(|region| region.name == name)
    }

    /// Checks every index, interval and scale, so that nothing later can run out of bounds or overflow for them, and
    /// that a name means one region, one constant, or one state or integral of its region.
    ///
    /// # Errors
    /// The first inconsistency found.
    pub fn check(&self) -> Result<(), LayoutError> {
        unrepeated(self.regions.iter().map(|region| &region.name), "regions")?;
        unrepeated(self.constants.iter().map(|constant| &constant.name), "constants")?;
        let constants = self.constants.len();
        for region in &self.regions {
            unrepeated(region.states.iter().map(|state| &state.name), "states")?;
            unrepeated(region.integrals.iter(), "integrals")?;
            let (a, b) = region.interval;
            if !(a.is_finite() && b.is_finite() && a < b) {
                return Err(LayoutError::Interval { region: region.name.clone(), a, b });
            }
            let scaled = region.states.iter().map(|state| (&state.name, state.scale));
            if let Some((name, scale)) = refused_scale(scaled) {
                return Err(LayoutError::Scale { of: format!("{name} in region {}", region.name), scale });
            }
            if region.states.is_empty() {
                return Err(LayoutError::NoStates { region: region.name.clone() });
            }
            let (n, rows) = (region.states.len(), region.rows());
            let outside = |pattern: &[(usize, usize)], columns| {
                pattern.iter().find(|&&(row, column)| row >= rows || column >= columns).copied()
            };
            let found = outside(&region.state_pattern, n).or_else(|| outside(&region.constant_pattern, constants));
            if let Some((row, column)) = found {
                return Err(LayoutError::RegionPattern { region: region.name.clone(), row, column });
            }
            if region.default_entries > region.constant_pattern.len() {
                return Err(LayoutError::DefaultEntries { region: region.name.clone() });
            }
        }
        let scaled = self.constants.iter().map(|constant| (&constant.name, constant.scale));
        if let Some((name, scale)) = refused_scale(scaled) {
            return Err(LayoutError::Scale { of: name.clone(), scale });
        }
        let inputs = self.inputs();
        let outside = |&&(row, input): &&(usize, usize)| row >= self.equations.len() || input >= inputs;
        match self.boundary_pattern.iter().find(outside) {
            Some(&(row, input)) => Err(LayoutError::BoundaryPattern { row, input }),
            None => Ok(()),
        }
    }
}

/// # Errors
/// The first name that two of them have.
pub(crate) fn unrepeated<'a>(
    mut names: impl Iterator<Item = &'a String> + Clone,
    among: &'static str,
) -> Result<(), LayoutError> {
    while let Some(name) = names.next() {
        if names.clone().any(|other| other == name) {
            return Err(LayoutError::Repeated { name: name.clone(), among });
        }
    }
    Ok(())
}

/// The first scale that is stated and is no positive number.
fn refused_scale<'a>(stated: impl Iterator<Item = (&'a String, Option<f64>)>) -> Option<(&'a String, f64)> {
    let mut scales = stated.filter_map(|(name, scale)| Some((name, scale?)));
    scales.find(|(_, scale)| !is_scale(*scale))
}

/// Whether a number may be a typical magnitude.
pub(crate) fn is_scale(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

/// A layout that contradicts itself.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LayoutError {
    /// The interval is empty, reversed or not finite.
    #[error("region {region}: [{a}, {b}] is no interval")]
    Interval {
        /// Region.
        region: String,
        /// Start.
        a: f64,
        /// End.
        b: f64,
    },
    /// A region must have at least one state.
    #[error("region {region} has no states")]
    NoStates {
        /// Region.
        region: String,
    },
    /// A typical magnitude is to be a positive number.
    #[error("{of}: a scale of {scale} is given, and a positive number is expected")]
    Scale {
        /// The state, with its region, or the constant.
        of: String,
        /// What is given.
        scale: f64,
    },
    /// Something is said of a state or parameter that there is not.
    #[error("{name}: no state and no parameter has this name")]
    Unnamed {
        /// The name given.
        name: String,
    },
    /// What has a name is asked for by it, and told by it in messages.
    #[error("{name}: two of the {among} have this name, and one is expected")]
    Repeated {
        /// The name.
        name: String,
        /// What they are, as `"states"`.
        among: &'static str,
    },
    /// A function is to have a derivative that an equation is stated for.
    #[error("{function}: an order of 0 is given, and at least 1 is expected")]
    Order {
        /// The function.
        function: String,
    },
    /// What each value depends on is to be said of all of them.
    #[error("what {given} values depend on is given, and that of {expected} is expected")]
    Dependences {
        /// As given.
        given: usize,
        /// Values that the right-hand side has.
        expected: usize,
    },
    /// An entry of a region's pattern lies outside the kernel's rows or columns.
    #[error("region {region}: pattern entry ({row}, {column}) lies outside the right-hand side's derivatives")]
    RegionPattern {
        /// Region.
        region: String,
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        column: usize,
    },
    /// More algebraic equations than states.
    #[error("region {region}: {algebraic} of its {states} states are to be algebraic")]
    Algebraic {
        /// Region.
        region: String,
        /// Algebraic states.
        algebraic: usize,
        /// States.
        states: usize,
    },
    /// More entries of default unknowns than entries.
    #[error("region {region}: more entries of default unknowns than entries in the constants' pattern")]
    DefaultEntries {
        /// Region.
        region: String,
    },
    /// An entry of the boundary pattern lies outside the equations or inputs.
    #[error("boundary pattern entry ({row}, {input}) lies outside the boundary equations' derivatives")]
    BoundaryPattern {
        /// Equation.
        row: usize,
        /// Input.
        input: usize,
    },
}

/// Points of one region, structure of arrays: component `i` of point `j` is `y[i * stride + j]`, `j < len <= stride`.
#[derive(Debug, Clone, Copy)]
pub struct Points<'a> {
    /// Number of points.
    pub len: usize,
    /// Distance between components; every output of the same call uses it too.
    pub stride: usize,
    /// Independent variable, at least `len` values.
    pub s: &'a [f64],
    /// States, `n * stride` values.
    pub y: &'a [f64],
}

impl Points<'_> {
    /// Component `i` of point `j`.
    #[inline]
    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.y[i * self.stride + j]
    }
}

/// Which derivatives with respect to constants are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// The leading `default_entries` of the region's constant pattern.
    DefaultUnknowns,
    /// All of the pattern: tangents and sensitivities.
    All,
}

/// A boundary value problem: see the module's head for the mathematics.
///
/// All arrays of a batch share the stride of its [`Points`]. Values are unspecified on entry; every entry of the
/// pattern must be written. A point where the function is undefined is answered with NaN: the solver steps back.
pub trait Problem {
    /// Names, sizes and sparsity. Must not change between calls.
    fn layout(&self) -> &Layout;

    /// Whether right-hand side and integrands are linear in the states and, together with them, in the constants whose
    /// indices are given: the unknown ones of a solve. Boundary equations need not be.
    ///
    /// What a correction makes of a linear right-hand side follows from its derivatives, which must be exact, so that
    /// it is evaluated less often. Defects are still those of the right-hand side itself: a problem that is not what it
    /// says ends in [`SolveError::NotLinear`](crate::SolveError::NotLinear) unless the difference meets the tolerance.
    fn is_linear(&self, _unknowns: &[usize]) -> bool {
        false
    }

    /// How many functions of independent variable, states and constants the right-hand side leaves as they are along a
    /// region, whatever the solution, without a bearing on it: as [`dae::Reduced`](crate::dae::Reduced) leaves each
    /// algebraic equation. Each has a multiplier 1, which [`Multipliers`](crate::Multipliers) leave out.
    fn conserved(&self, _region: usize) -> usize {
        0
    }

    /// Right-hand side, then integrands: `f[row * stride + j]`, `(n + k) * stride` values.
    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]);

    /// As [`rhs`](Self::rhs), and the derivatives: `dy[entry * stride + j]` for the entries of `state_pattern`,
    /// `dc[entry * stride + j]` for those of `constant_pattern` that `scope` names.
    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    );

    /// Boundary residuals `g`, one an equation. `ends`: region by region, all entry states, then all exit states.
    /// `integrals`: region by region, over the full region.
    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]);

    /// As [`boundary`](Self::boundary), and the derivatives: one for each entry of `boundary_pattern`.
    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]);
}

/// A reference to a problem is one. Made an object, it lets the solver be compiled once for all problems; what is
/// called works on whole batches of points.
impl<P: Problem + ?Sized> Problem for &P {
    fn layout(&self) -> &Layout {
        (**self).layout()
    }

    fn is_linear(&self, unknowns: &[usize]) -> bool {
        (**self).is_linear(unknowns)
    }

    fn conserved(&self, region: usize) -> usize {
        (**self).conserved(region)
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        (**self).rhs(region, at, constants, f);
    }

    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        (**self).rhs_jacobian(region, at, constants, scope, f, dy, dc);
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        (**self).boundary(ends, integrals, constants, g);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        (**self).boundary_jacobian(ends, integrals, constants, g, dz);
    }
}
