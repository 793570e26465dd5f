//! What a generated kernel looks like to its caller.

use crate::vocabulary::{Field, Integral, RegionConstant, State};

/// Exponents of length, mass, time and plane angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponent of the metre.
    pub length: i8,
    /// Exponent of the kilogram.
    pub mass: i8,
    /// Exponent of the second.
    pub time: i8,
    /// Exponent of the radian.
    pub angle: i8,
}

/// What a quantity is: a state, constant, integral, derived field, equation or output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symbol {
    /// Name in Rust, and in tables and files.
    pub name: &'static str,
    /// Symbol as the thesis prints it; empty for a residual.
    pub symbol: &'static str,
    /// SI unit; empty for a pure number.
    pub unit: &'static str,
    /// Dimension, angles included.
    pub dimension: Dimension,
    /// What it is, in one line.
    pub doc: &'static str,
    /// The equation that introduces it: its number in the thesis, or what it is; empty if there is none.
    pub source: &'static str,
}

/// An enum whose variants stand in the order of some vector.
pub trait Identity: Copy {
    /// How many variants there are.
    const COUNT: usize;
    /// Place of a variant, below [`Self::COUNT`].
    fn place(self) -> usize;
}

/// A batch of points in, values and derivatives out.
///
/// Structure of arrays: component `i` of point `j` stands at `[i * stride + j]`, `j < m <= stride`.
/// `s` holds at least `m` values of the independent variable, `y` the `n * stride` states, `constants` one value
/// for each of the kernel's constants. Entries beyond `m` are left alone.
///
/// # Panics
/// If a slice that the function needs is too short, with a message that names it.
pub type RegionFn = fn(m: usize, stride: usize, s: &[f64], y: &[f64], constants: &[f64], out: &mut RegionOut<'_>);

/// Where a [`RegionFn`] writes; slices that the function does not need may be empty.
#[derive(Debug)]
pub struct RegionOut<'a> {
    /// Right-hand side, then integrands: `(n + k) * stride`.
    pub f: &'a mut [f64],
    /// Derivatives with respect to states: one row of `stride` an entry of `state_pattern`.
    pub dy: &'a mut [f64],
    /// Derivatives with respect to constants: one row of `stride` an entry of `constant_pattern`.
    pub dc: &'a mut [f64],
    /// Derived fields: one row of `stride` a field.
    pub fields: &'a mut [f64],
}

/// One region's right-hand side with its integrands, as generated.
#[derive(Debug, Clone, Copy)]
pub struct RegionKernel {
    /// Name, as in `contact_full_tanh`.
    pub name: &'static str,
    /// The `n` states.
    pub states: &'static [State],
    /// Constants, the default unknowns first.
    pub constants: &'static [RegionConstant],
    /// The `k` integrals.
    pub integrals: &'static [Integral],
    /// Derived fields.
    pub fields: &'static [Field],
    /// How many leading constants are the default unknowns.
    pub default_unknowns: usize,
    /// Structurally nonzero derivatives `(row, state)`; rows `0..n` are the right-hand side, `n..n+k` the integrands.
    pub state_pattern: &'static [(usize, usize)],
    /// Structurally nonzero derivatives `(row, constant)`; those of the default unknowns stand first.
    pub constant_pattern: &'static [(usize, usize)],
    /// How many leading entries of `constant_pattern` belong to default unknowns.
    pub default_entries: usize,
    /// Writes `f`.
    pub value: RegionFn,
    /// Writes `f`, `dy` and the leading `default_entries` rows of `dc`.
    pub jacobian: RegionFn,
    /// Writes `f`, `dy` and all of `dc`.
    pub full: RegionFn,
    /// Writes `fields`.
    pub fields_fn: RegionFn,
}

impl RegionKernel {
    /// Row of a state; `None` if the region does not have it.
    pub fn state(&self, state: State) -> Option<usize> {
        self.states.iter().position(|other| *other == state)
    }

    /// Row of a derived field; `None` if the region does not have it.
    pub fn field(&self, field: Field) -> Option<usize> {
        self.fields.iter().position(|other| *other == field)
    }

    /// Row of an integral; `None` if the region does not have it.
    pub fn integral(&self, integral: Integral) -> Option<usize> {
        self.integrals.iter().position(|other| *other == integral)
    }
}

/// `(ends, integrals, constants, g)`: writes one residual an equation.
///
/// # Panics
/// If a slice is too short, with a message that names it.
pub type BoundaryFn = fn(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]);

/// `(ends, integrals, constants, g, dz)`: writes one residual an equation, one derivative an entry of the pattern.
///
/// # Panics
/// If a slice is too short, with a message that names it.
pub type BoundaryJacobianFn = fn(ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]);

/// A set of equations in ends, integrals and constants, as generated: the boundary equations of a drive; within an
/// [`OutputKernel`](crate::OutputKernel) or a [`FormulaKernel`](crate::FormulaKernel), each equation's value is an
/// output.
#[derive(Debug, Clone, Copy)]
pub struct BoundaryKernel {
    /// Name, as in `boundary_continuous_full`.
    pub name: &'static str,
    /// The equations, in the order of the residuals.
    pub equations: &'static [Symbol],
    /// Ends: region by region, all entry states, then all exit states.
    pub ends: &'static [Symbol],
    /// Integrals over each region, region by region.
    pub integrals: &'static [Symbol],
    /// Constants of the whole drive, in the order of [`Constant`](crate::Constant); inputs of a formula.
    pub constants: &'static [Symbol],
    /// Structurally nonzero derivatives `(equation, input)`; inputs are ends, then integrals, then constants.
    pub pattern: &'static [(usize, usize)],
    /// Writes the residuals.
    pub value: BoundaryFn,
    /// Writes the residuals and their derivatives.
    pub jacobian: BoundaryJacobianFn,
}
