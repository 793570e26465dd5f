//! Solved drives.

use crate::profile::Profile;
use crate::{case, convert, error, figure, interrupt};
use pyo3::exceptions::{PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use sheave::case::Clamp;
use sheave::clock::Stopwatch;
use sheave::design::{Verdict, verdict};
use sheave::drive::{Branch, Failure, SolveOptions, WORK_LIMIT, branch, solve_from};
use sheave::result::{self, Outcome};
use sheave::solver::Order;
use std::sync::Arc;

/// Solves a case.
///
/// `case` is a path, the text of a case file, a dictionary of keys or a Case; without it, the base case is solved.
/// `tolerance` bounds the relative defect (1e-12 to 0.1), `order` is that of the collocation (4, 6 or 8). With
/// `sensitivities`, the result has the derivatives of all outputs with respect to everything given. `near` is a result
/// of a similar case from which the search starts; if that does not lead to a solution, it starts from nothing. Where
/// an axial force is given that belongs to two operating points, `branch` says which is meant: that of the tighter belt
/// ("tight", as without a word) or of the looser ("loose"); `other_solution` has what is known of the other. From a
/// result nearby, the other is looked for only where `branch` is given. `work_limit` is the work that
/// the search may take, in Newton iterations, each counted once for every interval of the mesh. All other arguments are
/// keys of the case. Other threads run meanwhile; Ctrl-C ends the search.
///
/// Raises CaseError, SolveError.
#[pyfunction]
#[pyo3(signature = (case=None, /, *, tolerance=1e-6, order=4, sensitivities=false, near=None, branch=None,
    work_limit=WORK_LIMIT, **keys))]
pub fn solve(
    py: Python<'_>,
    case: Option<&Bound<'_, PyAny>>,
    tolerance: f64,
    order: i64,
    sensitivities: bool,
    near: Option<&Bound<'_, Result>>,
    branch: Option<&str>,
    work_limit: usize,
    keys: Option<&Bound<'_, PyDict>>,
) -> PyResult<Result> {
    let wanted = match branch {
        None => None,
        Some("tight") => Some(Branch::Tight),
        Some("loose") => Some(Branch::Loose),
        Some(other) => {
            return Err(PyValueError::new_err(format!("branch = \"{other}\": expected \"tight\" or \"loose\"")));
        }
    };
    if work_limit == 0 {
        return Err(PyValueError::new_err(format!(
            "work_limit = 0: expected a whole number above 0, such as {WORK_LIMIT}"
        )));
    }
    let case = case::read(py, case, keys)?;
    let resolved = case::resolved(py, &case)?;
    let options = SolveOptions { sensitivities, work_limit, ..options(tolerance, order)? };
    let near = near.map(|near| near.get().outcome.clone());
    let work = move || {
        let solved = solved(&resolved, near.as_deref(), wanted, &options);
        solved.map_err(|failure| match verdict(&resolved, &failure, &options) {
            // The message of these says so already.
            Verdict::Pushed | Verdict::Open => error::solve(&failure),
            proof => error::unsolved(&proof),
        })
    };
    let outcome = interrupt::run(py, work)??;
    Ok(Result { outcome: Arc::new(outcome), wanted: wanted.unwrap_or_default() })
}

/// The case's solution: from one nearby if that leads to it, else from nothing.
fn solved(
    case: &sheave::case::Resolved,
    near: Option<&Outcome>,
    wanted: Option<Branch>,
    options: &SolveOptions,
) -> std::result::Result<Outcome, Failure> {
    let near = near.filter(|near| near.result.inputs.model == case.model && case.operating_point.margin.is_none());
    let warm = near.and_then(|near| {
        let start = Stopwatch::start();
        let solved = solve_from(&near.solved, case, options).ok()?;
        // The look for another solution takes far longer than a step from nearby: without a word, only from the looser.
        let loose = || matches!(branch(&solved), Ok(Some(Branch::Loose)));
        Some(match wanted {
            None if !loose() => result::interpret(case, options, solved, start),
            _ => result::interpret_on_branch(case, wanted.unwrap_or_default(), options, solved, start),
        })
    });
    warm.unwrap_or_else(|| result::run_on_branch(case, wanted.unwrap_or_default(), options))
}

/// Seconds of each of some solutions of a case near a result by the library alone, to hold a call against; and of these
/// the seconds from the resolved case to the result.
#[pyfunction]
pub fn bare_seconds(
    py: Python<'_>,
    case: &Bound<'_, case::Case>,
    near: &Bound<'_, Result>,
    repeats: usize,
    tolerance: f64,
) -> PyResult<Vec<(f64, f64)>> {
    let (case, options, near) = (&case.get().0, options(tolerance, 4)?, &near.get().outcome);
    let one = |_| {
        let start = std::time::Instant::now();
        let resolved = case.resolve()?;
        case.check_posed(&resolved)?;
        let outcome = solved(&resolved, Some(near), None, &options)?;
        let seconds = start.elapsed().as_secs_f64();
        Ok((seconds, outcome.result.solver.wall_time.unwrap_or(f64::NAN)))
    };
    py.detach(|| (0..repeats).map(one).collect::<std::result::Result<_, _>>())
        .map_err(|error: sheave::Error| PyValueError::new_err(error.to_string()))
}

/// What a solve is told, checked.
///
/// # Errors
/// `ValueError`.
pub fn options(tolerance: f64, order: i64) -> PyResult<SolveOptions> {
    if !(1e-12..=1e-1).contains(&tolerance) {
        return Err(PyValueError::new_err(format!(
            "tolerance = {tolerance}: expected a number from 1e-12 to 1e-1, such as 1e-6"
        )));
    }
    let order = match order {
        4 => Order::Four,
        6 => Order::Six,
        8 => Order::Eight,
        other => return Err(PyValueError::new_err(format!("order = {other}: expected 4, 6 or 8"))),
    };
    Ok(SolveOptions { tolerance, order, ..SolveOptions::default() })
}

/// A solved drive. SI units, ratios as fractions.
#[pyclass(frozen, module = "sheave")]
pub struct Result {
    pub(crate) outcome: Arc<Outcome>,
    /// The operating point that was asked for, where an axial force belongs to two.
    pub(crate) wanted: Branch,
}

#[pymethods]
impl Result {
    /// The driving pulley.
    #[getter]
    fn primary(&self) -> Pulley {
        Pulley(self.outcome.result.primary.clone())
    }

    /// The driven pulley.
    #[getter]
    fn secondary(&self) -> Pulley {
        Pulley(self.outcome.result.secondary.clone())
    }

    /// The span from the secondary to the primary.
    #[getter]
    fn tight_span(&self) -> Span {
        Span(self.outcome.result.tight_span.clone())
    }

    /// The span from the primary to the secondary.
    #[getter]
    fn slack_span(&self) -> Span {
        Span(self.outcome.result.slack_span.clone())
    }

    /// Efficiencies (6.7) to (6.9).
    #[getter]
    fn efficiency(&self) -> Efficiency {
        Efficiency(self.outcome.result.efficiency.clone())
    }

    /// The belt as a whole.
    #[getter]
    fn belt(&self) -> BeltResult {
        BeltResult(self.outcome.result.belt.clone())
    }

    /// The energy audit.
    #[getter]
    fn energy(&self) -> Energy {
        Energy(self.outcome.result.energy.clone())
    }

    /// Power lost besides friction; None where it is not told.
    #[getter]
    fn losses(&self) -> Option<Losses> {
        self.outcome.result.losses.clone().map(Losses)
    }

    /// Heat; None where the case does not say what cools the belt.
    #[getter]
    fn thermal(&self) -> Option<Heat> {
        self.outcome.result.thermal.map(Heat)
    }

    /// How the solution was found.
    #[getter]
    fn solver(&self) -> SolverReport {
        SolverReport(self.outcome.result.solver.clone())
    }

    /// Name of the edition of the equations.
    #[getter]
    fn edition(&self) -> &str {
        &self.outcome.result.edition
    }

    /// Share of the friction at hand that is not yet used.
    #[getter]
    fn slip_reserve(&self) -> f64 {
        self.outcome.result.slip_reserve
    }

    /// Share of the friction at hand that is used: 1 less the slip reserve.
    #[getter]
    fn friction_utilization(&self) -> f64 {
        self.outcome.result.friction_utilization
    }

    /// What was solved for in place of what was prescribed: value in SI units by key of the case file.
    #[getter]
    fn found(&self) -> std::collections::BTreeMap<String, f64> {
        self.outcome.result.found.clone()
    }

    /// The case, resolved to SI units, with what was found.
    #[getter]
    fn inputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        convert::object(py, &self.outcome.result.inputs)
    }

    /// The other operating point of an axial force that belongs to two: `branch` of `sheave.solve` gives all of it.
    /// None where only one was found.
    #[getter]
    fn other_solution(&self) -> Option<OtherSolution> {
        self.outcome.result.other_solution.map(OtherSolution)
    }

    /// Estimated errors of the outputs, SI, without sign, by output with dots; extremes along a contact or a span have
    /// none. None where the equations are singular.
    #[getter]
    fn uncertainty(&self) -> Option<std::collections::BTreeMap<String, f64>> {
        self.outcome.result.uncertainty.clone()
    }

    /// Derivatives of the outputs with respect to everything given, SI over SI: by output with dots, then by key. None
    /// unless they were asked for.
    #[getter]
    fn sensitivities<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.outcome.result.sensitivities.as_ref().map(|all| convert::object(py, all)).transpose()
    }

    /// One derivative: that of an output ("efficiency.overall") with respect to a key ("belt.bending_stiffness").
    fn sensitivity(&self, output: &str, key: &str) -> PyResult<f64> {
        let all = self.outcome.result.sensitivities.as_ref();
        let all = all.ok_or_else(|| PyValueError::new_err("solve with sensitivities=True to have derivatives"))?;
        let row = all.get(output).ok_or_else(|| PyKeyError::new_err(format!("no derivatives of `{output}`")))?;
        let path = case::path_of(key)?;
        let value = row.get(&path).copied();
        value.ok_or_else(|| PyKeyError::new_err(format!("`{path}` is not among what is given: {}", listed(row))))
    }

    /// What is to be known before the result is used.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        let result = &self.outcome.result;
        let clamp = &result.inputs.operating_point.clamp;
        let force = matches!(clamp, Clamp::PrimaryAxialForce(_) | Clamp::SecondaryAxialForce(_));
        let only = force && self.wanted == Branch::Loose && result.other_solution.is_none();
        let only = only.then(|| "Only one operating point was found for this axial force: this one.".to_owned());
        result::warnings(&self.outcome).iter().map(|said| error::for_python(said)).chain(only).collect()
    }

    /// The result as the one JSON object that `sheave solve --json` prints.
    #[getter]
    fn json(&self) -> PyResult<String> {
        let object = self.object().map_err(|error| PyValueError::new_err(error.to_string()))?;
        serde_json::to_string_pretty(&object).map_err(|error| PyValueError::new_err(error.to_string()))
    }

    /// The same as dictionaries.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let object = self.object().map_err(|error| PyValueError::new_err(error.to_string()))?;
        convert::python(py, &object)
    }

    /// A summary in engineering units, as a person reads it.
    #[getter]
    fn summary(&self) -> String {
        error::for_python(&result::summary(&self.outcome.result))
    }

    /// Every state and derived field along the belt, at the nodes of the meshes and at `between` points between each
    /// two of them.
    #[pyo3(signature = (between=1))]
    fn profile(&self, py: Python<'_>, between: i64) -> PyResult<Profile> {
        /// Points between two nodes: a picture needs some ten.
        const MOST: usize = 1000;
        match usize::try_from(between) {
            Ok(between) if between <= MOST => Profile::new(py, &self.outcome, between),
            _ => Err(PyValueError::new_err(format!("between = {between}: expected a number from 0 to {MOST}"))),
        }
    }

    /// The figures of the result as data: name, caption, axes and series, in the units of the axes.
    fn figures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let figures = sheave::plot::drive(&self.outcome).map_err(|error| error::internal(&error))?;
        figure::figures(py, &figures)
    }

    /// A figure as SVG: "trajectory" is the belt's path; `figures()` has the names of the others.
    #[pyo3(signature = (name="trajectory"))]
    fn svg(&self, name: &str) -> PyResult<String> {
        let figures = sheave::plot::drive(&self.outcome).map_err(|error| error::internal(&error))?;
        figure::svg(&figures, name)
    }

    /// The page about the result, with all figures, as HTML.
    fn report(&self, py: Python<'_>) -> PyResult<String> {
        let outcome = self.outcome.clone();
        let page = move || {
            let figures = sheave::plot::drive(&outcome).map_err(|error| error.to_string())?;
            let page = sheave::report::page(&outcome, &figures).map_err(|error| error.to_string())?;
            Ok::<_, String>(error::in_page(&page))
        };
        py.detach(page).map_err(PyValueError::new_err)
    }

    /// Refused: a result holds the solution with all that the solver knows of it.
    fn __reduce__(&self) -> PyResult<()> {
        Err(PyTypeError::new_err("a result cannot be pickled: send its `to_dict()` or its `json`"))
    }

    fn _repr_html_(&self) -> PyResult<String> {
        let svg = self.svg("trajectory")?;
        let cell = |answer: &result::Answer| {
            format!(
                "<tr><th style=\"text-align:left\">{}</th><td style=\"text-align:left\">{}</td></tr>",
                escaped(answer.question),
                escaped(&error::in_page(&answer.answer))
            )
        };
        let rows: String = result::answers(&self.outcome.result).iter().map(cell).collect();
        let warnings: String = self
            .warnings()
            .iter()
            .map(|warning| format!("<p><strong>Warning.</strong> {}</p>", escaped(warning)))
            .collect();
        Ok(format!(
            "<div class=\"sheave\"><div style=\"max-width:640px\">{svg}</div><table>{rows}</table>{warnings}</div>"
        ))
    }

    fn __repr__(&self) -> String {
        let result = &self.outcome.result;
        let efficiency = result.efficiency.overall;
        let efficiency = efficiency.map_or("none".into(), |share| format!("{:.2} %", 100.0 * share));
        format!(
            "<sheave.Result: {} edition, axial forces {:.1} N, {:.1} N, efficiency {efficiency}, slip reserve {:.1} %>",
            result.edition,
            result.primary.axial_force,
            result.secondary.axial_force,
            100.0 * result.slip_reserve
        )
    }

    fn __str__(&self) -> String {
        self.summary()
    }
}

impl Result {
    fn object(&self) -> std::result::Result<serde_json::Value, serde_json::Error> {
        let result = &self.outcome.result;
        result::envelope("solve", &result.inputs, &self.warnings(), result)
    }
}

fn listed<V>(row: &std::collections::BTreeMap<String, V>) -> String {
    row.keys().map(String::as_str).collect::<Vec<_>>().join(", ")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// A field as it is, or as a dictionary where it has fields of its own.
fn plain(field: Bound<'_, PyAny>) -> PyResult<Bound<'_, PyAny>> {
    if field.hasattr("to_dict")? { field.call_method0("to_dict") } else { Ok(field) }
}

/// A class of Python with the fields of a struct of the library.
macro_rules! view {
    ($(#[$about:meta])* $name:ident of $inner:ty { $($(#[$doc:meta])* $field:ident : $kind:ty,)* }) => {
        $(#[$about])*
        #[pyclass(frozen, module = "sheave")]
        pub struct $name($inner);

        impl From<$inner> for $name {
            fn from(inner: $inner) -> Self {
                Self(inner)
            }
        }

        #[pymethods]
        impl $name {
            $(
                $(#[$doc])*
                #[getter]
                fn $field(&self) -> $kind {
                    self.0.$field.clone().into()
                }
            )*

            /// All fields by name.
            fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
                let dict = PyDict::new(py);
                $(dict.set_item(stringify!($field), plain(self.$field().into_pyobject(py)?.into_any())?)?;)*
                Ok(dict)
            }

            fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
                let mut fields = Vec::new();
                $(
                    let value = self.$field().into_pyobject(py)?.into_any().repr()?;
                    fields.push(format!("{}={value}", stringify!($field)));
                )*
                Ok(format!("{}({})", stringify!($name), fields.join(", ")))
            }
        }
    };
}

view! {
    /// One pulley and its contact.
    Pulley of result::Pulley {
        /// Speed of rotation, rad/s.
        speed: f64,
        /// Torque, N·m (5.54): into the primary, out of the secondary; negative where the secondary drives.
        torque: f64,
        /// Power, W: into the primary, out of the secondary; negative where the secondary drives.
        power: f64,
        /// Axial force between the sheaves, N (5.58).
        axial_force: f64,
        /// Wrap angle, rad.
        wrap_angle: f64,
        /// Angle of inclination where the belt enters, rad.
        entry_angle: f64,
        /// Angle of inclination where the belt leaves, rad.
        exit_angle: f64,
        /// Orientation angle, rad (5.17) to (5.20).
        orientation_angle: f64,
        /// Largest radial penetration, m.
        max_penetration: f64,
        /// Smallest sliding speed, m/s.
        min_sliding_speed: f64,
        /// Largest sliding speed, m/s.
        max_sliding_speed: f64,
        /// Share of the wrap angle on which the belt slides more slowly than the slip threshold.
        adhesion_fraction: f64,
        /// Share of the friction at hand that drives or brakes the pulley.
        friction_utilization: f64,
        /// Nominal radius, m.
        radius: f64,
        /// Where the axial force acts, m from the pulley's centre, towards the secondary's centre from the primary's.
        resultant_x: f64,
        /// Where the axial force acts, m from the pulley's centre, towards the tight span.
        resultant_y: f64,
        /// Moment of the axial force about the pulley's centre, N·m.
        binding_moment: f64,
        /// Power lost to friction, W.
        friction_loss: f64,
        /// Tractive tension where the belt enters, N.
        entry_tension: f64,
        /// Tractive tension where the belt leaves, N.
        exit_tension: f64,
    }
}

view! {
    /// One span.
    Span of result::Span {
        /// Arc length, m.
        arc_length: f64,
        /// Length when unloaded, m (5.56).
        unstretched_length: f64,
        /// Smallest tractive tension, N.
        min_tension: f64,
        /// Largest tractive tension, N.
        max_tension: f64,
    }
}

view! {
    /// Efficiencies as fractions, of the driven pulley over the driving one; None where neither drives the other.
    Efficiency of result::Efficiency {
        /// Rim speed of the driven pulley over that of the driving one (6.7).
        speed: Option<f64>,
        /// Rim force of the driven pulley over that of the driving one (6.8).
        torque: Option<f64>,
        /// Power out over power in (6.9).
        overall: Option<f64>,
        /// The same with hysteresis, drag and gears, where they are told.
        overall_with_losses: Option<f64>,
    }
}

view! {
    /// The other of two operating points of a prescribed axial force.
    OtherSolution of result::OtherSolution {
        /// Tractive tension at the exit of the primary, N.
        slack_tension: f64,
        /// Share of the friction at hand that is used.
        friction_utilization: f64,
    }
}

view! {
    /// The belt as a whole.
    BeltResult of result::BeltResult {
        /// Mass flow, kg/s (3.5).
        mass_flow: f64,
        /// Length of the loop when unloaded, m.
        unstretched_length: f64,
        /// What the drive needs less what the belt has, m.
        length_error: f64,
        /// Temperature, K; None where the case does not say what cools the belt.
        temperature: Option<f64>,
    }
}

view! {
    /// The energy audit, for full shear with continuous ends:
    /// power in = power out + friction loss + strain energy flux.
    Energy of result::Energy {
        /// Power into the primary, W.
        power_in: f64,
        /// Power out of the secondary, W.
        power_out: f64,
        /// Power that friction turns to heat, W.
        friction_loss: f64,
        /// (power_in - power_out - friction_loss)/power_in; None without power in.
        imbalance: Option<f64>,
        /// Power that the belt's stretching takes from the energy of bending and squeezing, W.
        stretch_work: f64,
        /// What nothing accounts for, over power_in; None without power in.
        closure: Option<f64>,
    }
}

view! {
    /// Power that hysteresis takes in one region, W.
    Hysteresis of sheave::losses::Hysteresis {
        /// Of bending the belt.
        bending: f64,
        /// Of squeezing it in the groove.
        groove: f64,
        /// Of stretching its cord.
        cord: f64,
    }
}

view! {
    /// How many harmonics were summed.
    Harmonics of sheave::losses::Harmonics {
        /// Of the curvature.
        bending: usize,
        /// Of the penetration.
        groove: usize,
        /// Of the strain.
        cord: usize,
    }
}

view! {
    /// Power lost besides friction, W. What hysteresis takes in a region may be negative, where the belt gives back
    /// more than it takes.
    Losses of sheave::losses::Losses {
        /// Of bending the belt.
        bending: f64,
        /// Of squeezing it in the groove.
        groove: f64,
        /// Of stretching its cord.
        cord: f64,
        /// Of drag at both pulleys.
        drag: f64,
        /// Of gears behind the secondary.
        gears: f64,
        /// All of these.
        total: f64,
        /// Hysteresis in the primary's contact.
        primary: Hysteresis,
        /// Hysteresis in the span from the primary to the secondary.
        slack_span: Hysteresis,
        /// Hysteresis in the secondary's contact.
        secondary: Hysteresis,
        /// Hysteresis in the span from the secondary to the primary.
        tight_span: Hysteresis,
        /// Power that drags at the primary.
        primary_drag: f64,
        /// Power that drags at the secondary.
        secondary_drag: f64,
        /// Power that arrives.
        power_out: f64,
        /// How many harmonics were summed.
        harmonics: Harmonics,
    }
}

/// A pulley by its name.
#[derive(IntoPyObject)]
#[pyo3(transparent)]
pub struct Hotter(&'static str);

impl From<sheave::losses::Hotter> for Hotter {
    fn from(hotter: sheave::losses::Hotter) -> Self {
        Self(match hotter {
            sheave::losses::Hotter::Primary => "primary",
            sheave::losses::Hotter::Secondary => "secondary",
        })
    }
}

view! {
    /// Heat, W, and the stiffnesses at the belt's temperature.
    Heat of sheave::losses::Heat {
        /// Heat that goes into the belt, W.
        belt: f64,
        /// Friction's heat that goes into the sheaves of the primary, W.
        primary: f64,
        /// Friction's heat that goes into the sheaves of the secondary, W.
        secondary: f64,
        /// The pulley whose sheaves take more heat: "primary" or "secondary".
        hotter: Hotter,
        /// Bending stiffness at the temperature, N·m².
        bending_stiffness: f64,
        /// Radial stiffness at the temperature, N/m².
        radial_stiffness: f64,
    }
}

view! {
    /// Intervals of the meshes by region.
    MeshIntervals of result::MeshIntervals {
        /// Contact with the primary.
        primary: usize,
        /// Contact with the secondary.
        secondary: usize,
        /// Span from the secondary to the primary.
        tight_span: usize,
        /// Span from the primary to the secondary.
        slack_span: usize,
    }
}

view! {
    /// How the solution was found, and how well it holds.
    SolverReport of result::SolverReport {
        /// Order of the collocation.
        order: usize,
        /// Relative tolerance on the defect.
        tolerance: f64,
        /// Intervals of the final meshes.
        mesh_intervals: MeshIntervals,
        /// Largest relative defect on the final meshes.
        max_residual: f64,
        /// Largest boundary residual, scaled.
        max_boundary_residual: f64,
        /// Newton iterations in all.
        newton_iterations: usize,
        /// Continuation steps in all.
        continuation_steps: usize,
        /// Seconds from the resolved case to the result.
        wall_time: Option<f64>,
    }
}
