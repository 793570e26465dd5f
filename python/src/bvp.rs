//! Boundary value problems whose formulas are functions of Python.

use crate::error;
use numpy::ndarray::{ArrayView2, ArrayView3};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArrayDyn, ToPyArray};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyList, PyTuple};
use sheave::Cancel;
use sheave::solver::problem::Constant;
use sheave::solver::{Accuracy, Guess, Layout, Options, Order, Points, Problem, Region, RegionGuess, Scope, Solution};
use std::cell::RefCell;
use std::sync::Arc;

/// Relative step of forward differences.
const STEP: f64 = 1.5e-8;

/// A problem that asks Python. The interpreter's lock is held throughout.
struct Callables<'py> {
    py: Python<'py>,
    /// `f(x, y[, p])` of `n × m` states gives `n × m` slopes.
    f: Bound<'py, PyAny>,
    /// `bc(ya, yb[, p])` gives `n + k` residuals.
    bc: Bound<'py, PyAny>,
    /// `(df/dy, df/dp)` of shapes `n × n × m` and `n × k × m`; the second only with parameters.
    jacobian: Option<Bound<'py, PyAny>>,
    /// `(dbc/dya, dbc/dyb, dbc/dp)`.
    boundary_jacobian: Option<Bound<'py, PyAny>>,
    layout: Layout,
    n: usize,
    k: usize,
    /// The first thing that Python raised: the solve is cancelled, and this is raised again.
    raised: RefCell<Option<PyErr>>,
    cancel: Cancel,
}

/// States by row, one column a point.
type Matrix<'py> = Bound<'py, PyArray2<f64>>;

impl<'py> Callables<'py> {
    fn layout(n: usize, k: usize, interval: (f64, f64)) -> Layout {
        let names: Vec<String> = (1..=n).map(|i| format!("y[{}]", i - 1)).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let equations: Vec<String> = (0..n + k).map(|row| format!("bc[{row}]")).collect();
        let equations: Vec<&str> = equations.iter().map(String::as_str).collect();
        let mut layout = Layout::dense(vec![Region::dense("interval", interval, &names, &[], k)], &[], &equations);
        layout.constants = (0..k).map(|i| Constant { name: format!("p[{i}]"), scale: None }).collect();
        let inputs = layout.inputs();
        layout.boundary_pattern = (0..n + k).flat_map(|row| (0..inputs).map(move |input| (row, input))).collect();
        layout
    }

    /// Keeps what was raised, ends the solve, and answers with what is no number.
    fn attempt(&self, out: &mut [f64], evaluate: impl FnOnce(&mut [f64]) -> PyResult<()>) {
        let refused = if self.cancel.is_cancelled() { true } else { self.keep(evaluate(out)) };
        if refused {
            out.fill(f64::NAN);
        }
    }

    fn keep(&self, outcome: PyResult<()>) -> bool {
        let Err(error) = outcome else { return false };
        self.raised.borrow_mut().get_or_insert(error);
        self.cancel.cancel();
        true
    }

    /// The values of a function of Python, with its shape checked.
    fn array(&self, value: &Bound<'py, PyAny>, name: &str, shape: &[usize]) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
        let numpy = self.py.import("numpy")?;
        // Its imaginary part would be lost.
        if numpy.call_method1("iscomplexobj", (value,))?.is_truthy()? {
            return Err(PyTypeError::new_err(format!(
                "{name} returned complex numbers: expected real ones; state real and imaginary parts as states"
            )));
        }
        let array = numpy.call_method1("asarray", (value, "float64"))?;
        let shaped: Vec<usize> = array.getattr("shape")?.extract()?;
        if shaped != shape {
            return Err(PyValueError::new_err(format!(
                "{name} returned an array of shape {shaped:?}: expected {shape:?}"
            )));
        }
        array.extract()
    }

    fn slopes(&self, x: &[f64], y: &Matrix<'py>, p: &[f64]) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
        let x = x.to_pyarray(self.py);
        let value = if self.k == 0 { self.f.call1((x, y))? } else { self.f.call1((x, y, p.to_pyarray(self.py)))? };
        self.array(&value, "f", &[self.n, y.dims()[1]])
    }

    /// The states of a batch as numpy has them: without what the stride leaves between rows.
    fn states(&self, at: &Points<'_>) -> PyResult<Matrix<'py>> {
        let rows: Vec<f64> = (0..self.n).flat_map(|i| at.y[i * at.stride..][..at.len].iter().copied()).collect();
        let view = ArrayView2::from_shape((self.n, at.len), &rows).map_err(shape)?;
        Ok(PyArray2::from_array(self.py, &view))
    }

    fn boundary_values(&self, ya: &[f64], yb: &[f64], p: &[f64]) -> PyResult<Vec<f64>> {
        let (a, b) = (ya.to_pyarray(self.py), yb.to_pyarray(self.py));
        let value = if self.k == 0 { self.bc.call1((a, b))? } else { self.bc.call1((a, b, p.to_pyarray(self.py)))? };
        Ok(self.array(&value, "bc", &[self.n + self.k])?.as_array().iter().copied().collect())
    }

    fn right_hand_side(&self, at: &Points<'_>, constants: &[f64], f: &mut [f64]) -> PyResult<()> {
        let values = self.slopes(&at.s[..at.len], &self.states(at)?, constants)?;
        for (i, row) in values.as_array().outer_iter().enumerate() {
            row.iter().zip(&mut f[i * at.stride..]).for_each(|(value, out)| *out = *value);
        }
        Ok(())
    }

    fn derivatives(&self, at: &Points<'_>, p: &[f64], f: &[f64], dy: &mut [f64], dc: &mut [f64]) -> PyResult<()> {
        if let Some(jacobian) = &self.jacobian {
            return self.given_derivatives(jacobian, at, p, dy, dc);
        }
        let (n, k) = (self.n, self.k);
        let x = &at.s[..at.len];
        let base: Vec<f64> = (0..n).flat_map(|i| at.y[i * at.stride..][..at.len].iter().copied()).collect();
        for j in 0..n {
            let mut moved = base.clone();
            let steps: Vec<f64> = moved[j * at.len..][..at.len]
                .iter_mut()
                .map(|value| {
                    let before = *value;
                    *value += STEP * (1.0 + before.abs());
                    *value - before
                })
                .collect();
            let view = ArrayView2::from_shape((n, at.len), &moved).map_err(shape)?;
            let values = self.slopes(x, &PyArray2::from_array(self.py, &view), p)?;
            for (i, row) in values.as_array().outer_iter().enumerate() {
                for (point, value) in row.iter().enumerate() {
                    dy[(i * n + j) * at.stride + point] = (value - f[i * at.stride + point]) / steps[point];
                }
            }
        }
        for j in 0..k {
            let mut moved = p.to_vec();
            moved[j] += STEP * (1.0 + p[j].abs());
            let step = moved[j] - p[j];
            let values = self.slopes(x, &self.states(at)?, &moved)?;
            for (i, row) in values.as_array().outer_iter().enumerate() {
                for (point, value) in row.iter().enumerate() {
                    dc[(i * k + j) * at.stride + point] = (value - f[i * at.stride + point]) / step;
                }
            }
        }
        Ok(())
    }

    fn given_derivatives(
        &self,
        jacobian: &Bound<'py, PyAny>,
        at: &Points<'_>,
        p: &[f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) -> PyResult<()> {
        let (n, k, m) = (self.n, self.k, at.len);
        let (x, y) = (at.s[..m].to_pyarray(self.py), self.states(at)?);
        let write = |value: &Bound<'py, PyAny>, name: &str, columns: usize, out: &mut [f64]| -> PyResult<()> {
            let array = self.array(value, name, &[n, columns, m])?;
            let array: ArrayView3<'_, f64> = array.as_array().into_dimensionality().map_err(shape)?;
            for ((i, j, point), value) in array.indexed_iter() {
                out[(i * columns + j) * at.stride + point] = *value;
            }
            Ok(())
        };
        if k == 0 {
            return write(&jacobian.call1((x, y))?, "jacobian", n, dy);
        }
        let both = jacobian.call1((x, y, p.to_pyarray(self.py)))?;
        // A pair may be a list; an array of two matrices is none.
        let pair = both.is_instance_of::<PyTuple>() || both.is_instance_of::<PyList>();
        let parts: Vec<Bound<'py, PyAny>> = if pair { both.extract()? } else { Vec::new() };
        let [by_states, by_parameters] = &parts[..] else {
            return Err(PyTypeError::new_err(
                "jacobian: with parameters, expected a pair of df/dy, of shape (n, n, m), and df/dp, of shape \
                 (n, k, m)",
            ));
        };
        write(by_states, "jacobian[0]", n, dy)?;
        write(by_parameters, "jacobian[1]", k, dc)
    }

    fn boundary_derivatives(&self, ends: &[f64], p: &[f64], g: &[f64], dz: &mut [f64]) -> PyResult<()> {
        let (n, k, rows) = (self.n, self.k, self.n + self.k);
        let inputs = 2 * n + k;
        let (ya, yb) = ends.split_at(n);
        if let Some(jacobian) = &self.boundary_jacobian {
            let (a, b) = (ya.to_pyarray(self.py), yb.to_pyarray(self.py));
            let value = if k == 0 { jacobian.call1((a, b))? } else { jacobian.call1((a, b, p.to_pyarray(self.py)))? };
            let parts: Vec<Bound<'py, PyAny>> = value.try_iter()?.collect::<PyResult<_>>()?;
            let widths: &[usize] = if k == 0 { &[n, n] } else { &[n, n, k] };
            if parts.len() != widths.len() {
                let (given, expected) = (parts.len(), widths.len());
                return Err(PyValueError::new_err(format!(
                    "boundary_jacobian returned {given} arrays: expected {expected}"
                )));
            }
            let mut first = 0;
            for (part, width) in parts.iter().zip(widths) {
                let array = self.array(part, "boundary_jacobian", &[rows, *width])?;
                for (row, values) in array.as_array().outer_iter().enumerate() {
                    values.iter().enumerate().for_each(|(j, value)| dz[row * inputs + first + j] = *value);
                }
                first += width;
            }
            return Ok(());
        }
        let all = [ends, p].concat();
        for input in 0..inputs {
            let mut moved = all.clone();
            moved[input] += STEP * (1.0 + all[input].abs());
            let step = moved[input] - all[input];
            let values = self.boundary_values(&moved[..n], &moved[n..2 * n], &moved[2 * n..])?;
            for (row, (value, base)) in values.iter().zip(g).enumerate() {
                dz[row * inputs + input] = (value - base) / step;
            }
        }
        Ok(())
    }
}

fn shape(error: numpy::ndarray::ShapeError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

impl Problem for Callables<'_> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, _region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        self.attempt(f, |f| self.right_hand_side(at, constants, f));
    }

    fn rhs_jacobian(
        &self,
        _region: usize,
        at: &Points<'_>,
        constants: &[f64],
        _scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        self.attempt(f, |f| self.right_hand_side(at, constants, f));
        self.attempt(dy, |dy| self.derivatives(at, constants, f, dy, dc));
    }

    fn boundary(&self, ends: &[f64], _integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (a, b) = ends.split_at(self.n);
        self.attempt(g, |g| {
            g.copy_from_slice(&self.boundary_values(a, b, constants)?);
            Ok(())
        });
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.boundary(ends, integrals, constants, g);
        self.attempt(dz, |dz| self.boundary_derivatives(ends, constants, g, dz));
    }
}

/// Solves a boundary value problem whose formulas are functions of Python; `sheave.bvp.solve` says how.
#[pyfunction]
pub fn solve_bvp<'py>(
    py: Python<'py>,
    f: Bound<'py, PyAny>,
    bc: Bound<'py, PyAny>,
    mesh: Vec<f64>,
    guess: Vec<Vec<f64>>,
    parameters: Vec<f64>,
    jacobian: Option<Bound<'py, PyAny>>,
    boundary_jacobian: Option<Bound<'py, PyAny>>,
    tolerance: f64,
    boundary_tolerance: Option<f64>,
    order: &str,
    max_intervals: usize,
    work_limit: Option<usize>,
) -> PyResult<BvpSolution> {
    let order = match order {
        "4" => Order::Four,
        "6" => Order::Six,
        "8" => Order::Eight,
        "gauss" => Order::SixGauss,
        other => return Err(PyValueError::new_err(format!("order = {other}: expected 4, 6, 8 or \"gauss\""))),
    };
    let (n, k) = (guess.len(), parameters.len());
    let (Some(first), Some(last)) = (mesh.first(), mesh.last()) else {
        return Err(PyValueError::new_err("mesh: expected at least two nodes"));
    };
    let cancel = Cancel::new();
    let problem = Callables {
        py,
        f,
        bc,
        jacobian,
        boundary_jacobian,
        layout: Callables::layout(n, k, (*first, *last)),
        n,
        k,
        raised: RefCell::new(None),
        cancel: cancel.clone(),
    };
    let guess = Guess { regions: vec![RegionGuess { mesh, states: guess }], constants: parameters };
    let unknowns: Vec<usize> = (0..k).collect();
    let cancel = Some(cancel);
    let options =
        Options { tolerance, boundary_tolerance, order, max_intervals, work_limit, cancel, ..Options::default() };
    let solved = sheave::solver::solve(&problem, &guess, &unknowns, &options);
    if let Some(error) = problem.raised.into_inner() {
        return Err(error);
    }
    solved.map(|solution| BvpSolution { solution: Arc::new(solution), n }).map_err(|error| error::bvp(&error))
}

/// The solution of a boundary value problem.
#[pyclass(frozen, module = "sheave.bvp")]
pub struct BvpSolution {
    solution: Arc<Solution>,
    n: usize,
}

#[pymethods]
impl BvpSolution {
    /// Nodes of the final mesh, shape (m,).
    #[getter]
    fn x<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        self.region().mesh().to_pyarray(py)
    }

    /// States at the nodes, shape (n, m).
    #[getter]
    fn y<'py>(&self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        self.rows(py, |i| self.region().state(i))
    }

    /// Derivatives of the states at the nodes, shape (n, m).
    #[getter]
    fn yp<'py>(&self, py: Python<'py>) -> PyResult<Matrix<'py>> {
        self.rows(py, |i| self.region().slope(i))
    }

    /// Parameters found, shape (k,); None without parameters, as SciPy has it.
    #[getter]
    fn p<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<f64>>> {
        let found = self.solution.constants();
        (!found.is_empty()).then(|| found.to_pyarray(py))
    }

    /// Largest relative defect on the final mesh.
    #[getter]
    fn max_defect(&self) -> f64 {
        self.solution.max_defect()
    }

    /// Largest boundary residual, relative to the largest term of its equation.
    #[getter]
    fn max_boundary_residual(&self) -> f64 {
        self.solution.max_boundary_residual()
    }

    /// Estimated true error at the nodes and in the parameters, relative to typical magnitudes.
    #[getter]
    fn error_estimate(&self) -> f64 {
        self.solution.error_estimate()
    }

    /// Whether the estimated error meets the tolerance.
    #[getter]
    fn accurate(&self) -> bool {
        matches!(self.solution.accuracy(), Accuracy::Met)
    }

    /// Newton iterations in all.
    #[getter]
    fn niter(&self) -> usize {
        self.solution.stats().newton_iterations
    }

    /// Number of meshes that it took.
    #[getter]
    fn meshes(&self) -> usize {
        self.solution.history().len()
    }

    /// Points at which the right-hand side was evaluated.
    #[getter]
    fn evaluations(&self) -> usize {
        self.solution.stats().points()
    }

    /// States at the places `x`, shape (n, len(x)), by the continuous extension of the method.
    fn evaluate<'py>(&self, py: Python<'py>, x: Vec<f64>) -> PyResult<Matrix<'py>> {
        let mut all = vec![0.0; self.n * x.len()];
        let mut y = vec![0.0; self.n];
        for (point, x_value) in x.iter().enumerate() {
            self.region().eval_into(*x_value, &mut y);
            y.iter().enumerate().for_each(|(i, value)| all[i * x.len() + point] = *value);
        }
        let view = ArrayView2::from_shape((self.n, x.len()), &all).map_err(shape)?;
        Ok(PyArray2::from_array(py, &view))
    }
}

impl BvpSolution {
    fn region(&self) -> &sheave::solver::RegionSolution {
        &self.solution.regions()[0]
    }

    fn rows<'a, 'py>(&'a self, py: Python<'py>, row: impl Fn(usize) -> &'a [f64]) -> PyResult<Matrix<'py>> {
        let all: Vec<f64> = (0..self.n).flat_map(|i| row(i).iter().copied()).collect();
        let view = ArrayView2::from_shape((self.n, self.region().mesh().len()), &all).map_err(shape)?;
        Ok(PyArray2::from_array(py, &view))
    }
}
