//! Limits and optima over a grid of keys, as a table and as figures.

use serde::Serialize;
use serde_json::Value;

use super::error::DesignError;
use super::limit::{LimitKind, LimitOptions, largest_torque, smallest_clamps};
use super::optimum::optimum;
use crate::case::{Key, Resolved, Setting};
use crate::drive::{Failure, SolveOptions};
use crate::model::InternalError;
use crate::plot::{Axis, Figure, Look, Series};
use crate::study::{Cell, GridPoint, Row, Study, StudyError, Table, TableBuilder};

/// Keys of the load and of the clamp: what is varied is not sought.
const LOADS: [Key; 2] = [Key::PrimaryTorque, Key::SecondaryTorque];
const CLAMPS: [Key; 4] = [Key::SlackTension, Key::TightTension, Key::PrimaryAxialForce, Key::SecondaryAxialForce];

/// A column of a map, and how a figure shows it.
#[derive(Debug, Clone, Copy)]
struct Shown {
    column: &'static str,
    name: &'static str,
    caption: &'static str,
    axis: &'static str,
    scale: f64,
}

const LIMITS: [Shown; 4] = [
    Shown {
        column: "smallest_clamp.slack_tension.value",
        name: "smallest_slack_tension",
        caption: "Smallest slack tension that carries the torque",
        axis: "slack tension T_{slack} (N)",
        scale: 1.0,
    },
    Shown {
        column: "smallest_clamp.primary_axial_force.value",
        name: "smallest_primary_axial_force",
        caption: "Smallest axial force on the primary that carries the torque",
        axis: "axial force A_{P} (N)",
        scale: 1.0,
    },
    Shown {
        column: "smallest_clamp.secondary_axial_force.value",
        name: "smallest_secondary_axial_force",
        caption: "Smallest axial force on the secondary that carries the torque",
        axis: "axial force A_{S} (N)",
        scale: 1.0,
    },
    Shown {
        column: "largest_torque.value",
        name: "largest_torque",
        caption: "Largest torque that the clamp carries",
        axis: "torque M_{in} (N·m)",
        scale: 1.0,
    },
];

const OPTIMA: [Shown; 4] = [
    Shown {
        column: "state.slack_tension",
        name: "best_slack_tension",
        caption: "Slack tension of best overall efficiency",
        axis: "slack tension T_{slack} (N)",
        scale: 1.0,
    },
    Shown {
        column: "state.primary_axial_force",
        name: "best_primary_axial_force",
        caption: "Axial force on the primary at the best overall efficiency",
        axis: "axial force A_{P} (N)",
        scale: 1.0,
    },
    Shown {
        column: "state.secondary_axial_force",
        name: "best_secondary_axial_force",
        caption: "Axial force on the secondary at the best overall efficiency",
        axis: "axial force A_{S} (N)",
        scale: 1.0,
    },
    Shown {
        column: "state.overall_efficiency",
        name: "best_efficiency",
        caption: "Best overall efficiency",
        axis: "overall efficiency η (%)",
        scale: 100.0,
    },
];

/// The limits of one case: the largest torque, unless the load is what varies; the smallest clamps, unless the clamp
/// is.
///
/// # Errors
/// See [`DesignError`].
pub fn limits(case: &Resolved, varied: &[Key], options: &LimitOptions) -> Result<Value, DesignError> {
    let varies = |keys: &[Key]| keys.iter().any(|key| varied.contains(key));
    let mut object = serde_json::Map::new();
    if !varies(&LOADS) {
        let (limit, _) = largest_torque(case, options)?;
        object.insert("largest_torque".into(), json(&limit)?);
    }
    if !varies(&CLAMPS) {
        let (limits, _) = smallest_clamps(case, options)?;
        object.insert("smallest_clamp".into(), json(&limits)?);
    }
    Ok(Value::Object(object))
}

fn json(limit: &impl Serialize) -> Result<Value, InternalError> {
    serde_json::to_value(limit).map_err(|_| InternalError::Json("a limit"))
}

/// A table of [`limits`] over a grid, on `jobs` threads (all cores if none are given).
///
/// # Errors
/// [`StudyError::Threads`]. A point without an answer has a row that says why.
pub fn limit_map(study: &Study, jobs: Option<usize>, options: &LimitOptions) -> Result<Table, StudyError> {
    let varied: Vec<Key> = study.axes().iter().flat_map(|axis| axis.keys().iter().copied()).collect();
    map(study, jobs, |case| limits(case, &varied, options))
}

/// A table of the best clamps over a grid.
///
/// # Errors
/// As [`limit_map`].
pub fn optimum_map(study: &Study, jobs: Option<usize>, options: &SolveOptions) -> Result<Table, StudyError> {
    map(study, jobs, |case| {
        let best = optimum(case, options)?;
        let mut object = serde_json::json!({
            "state": best.state, "bound": best.bound, "gradient": best.gradient, "evaluations": best.evaluations,
        });
        for (name, value) in
            [("efficiency_with_losses", best.efficiency_with_losses), ("belt_temperature", best.belt_temperature)]
        {
            if let (Some(members), Some(value)) = (object.as_object_mut(), value) {
                members.insert(name.into(), value.into());
            }
        }
        Ok(object)
    })
}

fn map(
    study: &Study,
    jobs: Option<usize>,
    answer: impl Fn(&Resolved) -> Result<Value, DesignError> + Sync,
) -> Result<Table, StudyError> {
    let threads = jobs.unwrap_or(0);
    let row = |index: usize| -> Result<Row, StudyError> {
        let point = study.point(index)?;
        let answer = match &point.case {
            Ok(case) => match answer(case) {
                Err(DesignError::Start(Failure::Cancelled)) => return Err(StudyError::Cancelled),
                answer => answer.map_err(|error| error.to_string()),
            },
            Err(error) => Err(error.to_string()),
        };
        Ok(table_row(index, &point, answer))
    };
    let rows = crate::threads::map(threads, study.points(), row).map_err(|_| StudyError::Threads(threads))?;
    let mut table = TableBuilder::new(study.points());
    for row in rows {
        table.insert(row?);
    }
    Ok(table.finish())
}

fn table_row(index: usize, point: &GridPoint, answer: Result<Value, String>) -> Row {
    let mut cells: Vec<(String, Cell)> = Vec::new();
    for (key, setting) in &point.varied {
        cells.push((key.path().to_owned(), Cell::of_setting(setting).unwrap_or(Cell::Empty)));
    }
    cells.push(("converged".into(), Cell::Truth(answer.is_ok())));
    let failure = match answer {
        Ok(value) => {
            flatten("", value, &mut cells);
            Cell::Empty
        }
        Err(reason) => Cell::Text(reason.into()),
    };
    cells.push(("failure".into(), failure));
    let (columns, cells) = cells.into_iter().unzip();
    Row { index, columns, cells }
}

/// The scalars of a value by their names with dots.
fn flatten(name: &str, value: Value, cells: &mut Vec<(String, Cell)>) {
    match value {
        Value::Object(members) => {
            let dot = if name.is_empty() { "" } else { "." };
            members.into_iter().for_each(|(member, value)| flatten(&format!("{name}{dot}{member}"), value, cells));
        }
        value => cells.push((name.to_owned(), cell(value))),
    }
}

fn cell(value: Value) -> Cell {
    match value {
        Value::Bool(truth) => Cell::Truth(truth),
        Value::Number(number) => Cell::Number(number),
        Value::String(text) => Cell::Text(text.into()),
        Value::Null | Value::Array(_) | Value::Object(_) => Cell::Empty,
    }
}

/// Figures of a map of limits: over the grid's last axis, a curve for each point of the others.
pub fn limit_figures(study: &Study, table: &Table) -> Vec<Figure> {
    figures(study, table, &LIMITS)
}

/// Figures of a map of optima.
pub fn optimum_figures(study: &Study, table: &Table) -> Vec<Figure> {
    figures(study, table, &OPTIMA)
}

fn figures(study: &Study, table: &Table, shown: &[Shown]) -> Vec<Figure> {
    let Some(axis) = study.axes().last() else { return Vec::new() };
    let Some(across) = axis.keys().first().filter(|_| axis.points() > 1 && axis.is_continuous()) else {
        return Vec::new();
    };
    // Where a curve was lost, its last value is a bound: shown, and not as a limit.
    let is_bound = |row: usize, column: &str| {
        let kind = column.strip_suffix("value").map(|stem| format!("{stem}kind"));
        let cell = kind.and_then(|kind| table.rows.get(row)?.get(table.column(&kind)?));
        cell == Some(&Cell::Text(LimitKind::LOST.into()))
    };
    let line = |(color, first): (usize, usize), column: &str, scale: f64| {
        let varied = study.point(first).map(|point| point.varied).unwrap_or_default();
        let others = varied.iter().take(varied.len().saturating_sub(axis.keys().len()));
        let label: Vec<String> = others.map(|(key, setting)| label(*key, setting)).collect();
        let rows = first..first + axis.points();
        let x = |row: usize| across.entry().readable(table.number(row, across.path())).0;
        let y = |row: usize, bounds: bool| {
            let shown = is_bound(row, column) == bounds;
            if shown { scale * table.number(row, column) } else { f64::NAN }
        };
        let points = |bounds: bool| rows.clone().map(|row| (x(row), y(row, bounds))).collect::<Vec<_>>();
        let bounds: Vec<(f64, f64)> = points(true).into_iter().filter(|(_, y)| y.is_finite()).collect();
        let limits = Series::line(label.join(", "), points(false)).color(color);
        let bounds = (!bounds.is_empty()).then(|| Series::line("", bounds).look(Look::Dots).color(color));
        std::iter::once(limits).chain(bounds)
    };
    let there = shown.iter().filter(|shown| table.column(shown.column).is_some());
    there
        .map(|shown| {
            let starts = (0..study.points()).step_by(axis.points()).enumerate();
            let series: Vec<Series> = starts.flat_map(|start| line(start, shown.column, shown.scale)).collect();
            let has_bounds = series.iter().any(|series| series.look == Look::Dots);
            let dots = if has_bounds { "; dots are bounds, where the limit lies beyond" } else { "" };
            Figure::new(
                shown.name,
                format!("{}{dots}", shown.caption),
                Axis::new(across.entry().axis_label()),
                Axis::new(shown.axis),
                series,
            )
        })
        .collect()
}

/// `M_{in} = 18 N·m`.
fn label(key: Key, setting: &Setting) -> String {
    match setting {
        Setting::Number(value) => key.entry().label_at(*value),
        Setting::List(values) => format!("{} of {} values", key.path(), values.len()),
        Setting::Name(name) => (*name).to_owned(),
        Setting::Table(grid) => grid.to_string(),
    }
}
