//! What the test set holds, and how one of its problems is stated.

use serde_json::Value;
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Problem, Region, mesh};
use std::sync::LazyLock;

/// A solution in closed form.
pub trait Exact {
    /// States of the region at `x`, for these constants. Exact to first order in `x` is enough.
    fn exact<S: Scalar>(&self, region: usize, x: S, c: &[f64], y: &mut [S]);
}

type Start = Box<dyn Fn(usize, f64, &[f64], &mut [f64]) + Sync + Send>;
/// Region, `x`, constants: the states, and their derivatives with respect to `x`.
type Solved = Box<dyn Fn(usize, f64, &[f64]) -> (Vec<f64>, Vec<f64>) + Sync + Send>;

/// One problem with everything that a run needs.
pub struct Case {
    /// As in the data.
    pub id: &'static str,
    /// Name of the reference that is wanted, where a problem has several solutions and the guess decides.
    pub solution: Option<&'static str>,
    pub problem: Box<dyn Problem + Sync + Send>,
    /// Given values, and guesses of unknowns; the parameter's value is filled in.
    pub constants: Vec<f64>,
    /// Index of the constant that the data's parameter is.
    pub parameter: Option<usize>,
    pub unknowns: Vec<usize>,
    /// Intervals of the uniform starting mesh, in each region.
    pub intervals: usize,
    pub start: Start,
    pub exact: Option<Solved>,
    /// Where the data suggests continuation in the parameter: from here.
    pub continue_from: Option<f64>,
}

impl Case {
    /// A problem whose unknown constants are these, with their guesses. The guess of all states is zero.
    pub fn new<M: Model + Sync + Send + 'static>(id: &'static str, model: M, unknowns: &[(&str, f64)]) -> Self {
        let names: Vec<&str> = unknowns.iter().map(|&(name, _)| name).collect();
        let problem = Differentiated::with_default_unknowns(model, &names).unwrap();
        let layout = problem.layout();
        let mut constants = vec![0.0; layout.constants.len()];
        let indices: Vec<usize> = names.iter().map(|name| layout.constant(name).unwrap()).collect();
        indices.iter().zip(unknowns).for_each(|(&index, &(_, value))| constants[index] = value);
        let parameter = (0..constants.len()).find(|index| !indices.contains(index));
        let start: Start = Box::new(|_, _, _, y| y.fill(0.0));
        Self {
            id,
            solution: None,
            problem: Box::new(problem),
            constants,
            parameter,
            unknowns: indices,
            intervals: 20,
            start,
            exact: None,
            continue_from: None,
        }
    }

    /// A problem whose solution is known, by the same type.
    pub fn solved<M: Model + Exact + Copy + Sync + Send + 'static>(id: &'static str, model: M) -> Self {
        let mut case = Self::new(id, model, &[]);
        let sizes: Vec<usize> = case.problem.layout().regions.iter().map(|region| region.states.len()).collect();
        case.exact = Some(Box::new(move |region, x, c| {
            let mut y = vec![num_dual::Dual64::from_re(0.0); sizes[region]];
            model.exact(region, num_dual::Dual64::from_re(x).derivative(), c, &mut y);
            y.iter().map(|y| (y.re, y.eps)).unzip()
        }));
        case
    }

    /// The guess: `start(region, s, constants, y)`.
    pub fn start(mut self, start: impl Fn(usize, f64, &[f64], &mut [f64]) + Sync + Send + 'static) -> Self {
        self.start = Box::new(start);
        self
    }

    /// A constant guess.
    pub fn constant(self, values: &'static [f64]) -> Self {
        self.start(move |_, _, _, y| y.copy_from_slice(values))
    }

    /// The guess is linear in the first state.
    pub fn line(self, left: f64, right: f64) -> Self {
        let (a, b) = self.problem.layout().regions[0].interval;
        let slope = (right - left) / (b - a);
        self.start(move |_, s, _, y| (y[0], y[1]) = (left + slope * (s - a), slope))
    }

    pub fn continue_from(mut self, parameter: f64) -> Self {
        self.continue_from = Some(parameter);
        self
    }

    /// The starting mesh.
    pub fn intervals(mut self, intervals: usize) -> Self {
        self.intervals = intervals;
        self
    }

    /// Which of several solutions the guess is to lead to.
    pub fn wanting(mut self, solution: &'static str) -> Self {
        self.solution = Some(solution);
        self
    }

    /// The constants with the parameter's value filled in.
    pub fn constants_at(&self, parameter: Option<f64>) -> Vec<f64> {
        let mut constants = self.constants.clone();
        if let (Some(index), Some(value)) = (self.parameter, parameter) {
            constants[index] = value;
        }
        constants
    }

    /// The suggested guess at this parameter.
    pub fn guess(&self, parameter: Option<f64>) -> Guess {
        let layout = self.problem.layout();
        let constants = self.constants_at(parameter);
        let meshes = layout.regions.iter().map(|region| mesh::uniform(region.interval, self.intervals)).collect();
        Guess::on(layout, meshes, &constants, |region, s, y| (self.start)(region, s, &constants, y))
    }

    /// Name with the solution that is wanted.
    pub fn label(&self) -> String {
        self.solution.unwrap_or(self.id).to_owned()
    }

    /// The parameters of the data; `None` alone for a problem without one.
    pub fn parameters(&self) -> Vec<Option<f64>> {
        let listed: Vec<_> = record(self.id)["parameters"].as_array().unwrap().iter().map(Value::as_f64).collect();
        if listed.is_empty() { vec![None] } else { listed }
    }

    /// The reference solutions at this parameter: the wanted one, or all.
    pub fn references(&self, parameter: Option<f64>) -> Vec<Reference> {
        let all = record(self.id)["references"].as_array().unwrap().iter();
        let wanted = |r: &&Value| {
            r["x"].is_array()
                && r["parameter"].as_f64() == parameter
                && self.solution.is_none_or(|name| r["solution"].as_str() == Some(name))
        };
        all.filter(wanted).map(Reference::read).collect()
    }
}

/// Tabulated values of one solution.
pub struct Reference {
    pub solution: Option<String>,
    /// The independent variable; in `[0, 1]` across each region where there are several.
    pub x: Vec<f64>,
    /// Component by component, those of all regions in turn.
    pub y: Vec<Vec<f64>>,
    /// Largest magnitude of each component over the whole solution.
    pub peak: Vec<f64>,
    pub constants: Vec<f64>,
}

impl Reference {
    fn read(value: &Value) -> Self {
        Self {
            solution: value["solution"].as_str().map(str::to_owned),
            x: numbers(&value["x"]),
            y: value["y"].as_array().unwrap().iter().map(numbers).collect(),
            peak: numbers(&value["max_abs_component"]),
            constants: value["parameters_found"]
                .as_array()
                .map_or_else(Vec::new, |_| numbers(&value["parameters_found"])),
        }
    }
}

/// All of a JSON array's numbers.
pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// The data.
pub static DATA: LazyLock<Value> =
    LazyLock::new(|| serde_json::from_str(include_str!("../../data/bvp-testset.json")).unwrap());

/// The data of one problem.
pub fn record(id: &str) -> &'static Value {
    DATA["problems"].as_array().unwrap().iter().find(|problem| problem["id"] == id).unwrap()
}

/// One region of states `y1`, `y2`, ...
pub fn one_region(interval: (f64, f64), states: usize, constants: &[&str], equations: &[&str]) -> Layout {
    const NAMES: [&str; 6] = ["y1", "y2", "y3", "y4", "y5", "y6"];
    Layout::dense(vec![Region::dense("all", interval, &NAMES[..states], &[], constants.len())], constants, equations)
}

/// `u'' = rhs` with `u` given at both ends: a model of one parameter, or of none.
macro_rules! dirichlet {
    ($(#[$doc:meta])* $name:ident, $interval:expr, $parameters:expr,
     |$x:ident, $u:ident, $v:ident, $p:ident| $rhs:expr, $left:expr, $right:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy)]
        pub struct $name;

        impl Model for $name {
            fn layout(&self) -> Layout {
                one_region($interval, 2, &$parameters, &["left end", "right end"])
            }
            fn rhs<S: Scalar>(&self, _: usize, $x: S, y: &[S], c: &[S], f: &mut [S]) {
                let ($u, $v, $p) = (y[0], y[1], c.first().copied().unwrap_or(S::from(0.0)));
                let _ = ($x, $u, $v, $p);
                (f[0], f[1]) = ($v, $rhs);
            }
            fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], c: &[S], g: &mut [S]) {
                let $p = c.first().copied().unwrap_or(S::from(0.0));
                let _ = $p;
                (g[0], g[1]) = (ends[0] - $left, ends[2] - $right);
            }
        }
    };
}
pub(crate) use dirichlet;

/// The solution in closed form of a model made by [`dirichlet`].
macro_rules! exact {
    ($name:ident, |$x:ident, $p:ident| $y:expr) => {
        impl Exact for $name {
            fn exact<S: Scalar>(&self, _: usize, $x: S, c: &[f64], y: &mut [S]) {
                let $p = c.first().copied().unwrap_or(0.0);
                let _ = $p;
                y.copy_from_slice(&$y);
            }
        }
    };
}
pub(crate) use exact;
