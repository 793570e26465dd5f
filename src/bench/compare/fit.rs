//! Least squares: the engine's scale in closed form, and constants of the model by Levenberg's and Marquardt's method.

use crate::bench::statistics::student;
use nalgebra::{DMatrix, DVector};
use serde::Serialize;

/// A factor on the engine's power that makes model and measurement agree best.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Scale {
    /// True over tabulated power.
    pub value: f64,
    /// Interval that contains it with 95 % confidence, by the scatter of the points; `None` if they allow any larger
    /// value.
    pub interval: (f64, Option<f64>),
    /// Root of the mean square of what remains of the efficiencies' differences.
    pub rms: f64,
}

/// The scale s for which Σ (measured/s − model)² is least: linear in 1/s. `None` for fewer than two points.
pub fn scale(measured: &[f64], model: &[f64]) -> Option<Scale> {
    let count = measured.len().min(model.len());
    if count < 2 {
        return None;
    }
    let pairs = || measured.iter().zip(model);
    let square = measured.iter().map(|d| d * d).sum::<f64>();
    let inverse = pairs().map(|(d, m)| d * m).sum::<f64>() / square;
    let left = pairs().map(|(d, m)| (inverse * d - m).powi(2)).sum::<f64>();
    let half = student(count - 1) * (left / (count as f64 - 1.0) / square).sqrt();
    let least = inverse - half;
    Some(Scale {
        value: 1.0 / inverse,
        interval: (1.0 / (inverse + half), (least > 0.0).then(|| 1.0 / least)),
        rms: (left / count as f64).sqrt(),
    })
}

/// Residuals and their derivatives, one row for each point, in the logarithms of the parameters.
pub struct Linearised {
    /// Residuals.
    pub residuals: Vec<f64>,
    /// Derivatives: one vector for each residual.
    pub rows: Vec<Vec<f64>>,
}

/// The values that a parameter can have, both ends included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// The smallest; above it the logarithm is searched.
    pub low: f64,
    /// The largest.
    pub high: f64,
}

impl Bounds {
    /// Every value above zero.
    pub const POSITIVE: Self = Self { low: 0.0, high: f64::INFINITY };

    /// A value's steps of the logarithm to both ends: the first is not above zero, the second not below.
    fn room(self, value: f64) -> (f64, f64) {
        let step = |end: f64| if end == value { 0.0 } else { (end / value).ln() };
        (step(self.low).min(0.0), step(self.high).max(0.0))
    }

    /// Whether a step of the logarithm leads outward from an end at which the value is.
    fn is_left_by(self, value: f64, step: f64) -> bool {
        step > 0.0 && value >= self.high || step < 0.0 && value <= self.low
    }
}

/// What a fit ends with.
#[derive(Debug, Clone, PartialEq)]
pub struct Fitted {
    /// Parameters.
    pub values: Vec<f64>,
    /// Of each, whether it is held at an end of its bounds beyond which the residuals would become smaller.
    pub held: Vec<bool>,
    /// Standard errors of their logarithms; `None` where the data do not determine them.
    pub errors: Option<Vec<f64>>,
    /// Correlations of the logarithms.
    pub correlation: Vec<Vec<f64>>,
    /// Factor by which a standard error becomes half an interval.
    pub quantile: f64,
    /// Iterations.
    pub iterations: usize,
    /// Whether the last step was small.
    pub converged: bool,
    /// Why the model has no solution where the last step would have led, if that ended the search.
    pub obstacle: Option<String>,
    /// Ratio of the largest to the smallest singular value of the derivatives with columns of length one.
    pub condition: f64,
}

const ITERATIONS: usize = 40;
/// Largest change of a logarithm in one step.
const LARGEST: f64 = 0.4;
/// Change of the logarithms at which a fit has converged.
const SMALL: f64 = 1e-6;
/// Largest damping tried in an iteration.
const DAMPED: f64 = 1e8;

/// Why the model says nothing with some parameters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoModel {
    /// There is no solution, for this reason; with others there may be one.
    Unsolved(String),
    /// The work was cancelled.
    Cancelled,
}

/// Fits positive parameters within their bounds. `evaluate` may have no solution for some of them; then a shorter step
/// is tried. A step that is small for that reason alone is no convergence: [`Fitted::obstacle`] has the reason.
///
/// # Errors
/// What `evaluate` says of the start; [`NoModel::Cancelled`] whenever it says so.
pub fn fit(
    start: &[(f64, Bounds)],
    mut evaluate: impl FnMut(&[f64]) -> Result<Linearised, NoModel>,
) -> Result<Fitted, NoModel> {
    let (mut values, bounds): (Vec<f64>, Vec<Bounds>) = start.iter().copied().unzip();
    let mut here = evaluate(&values)?;
    let cost = |residuals: &[f64]| residuals.iter().map(|r| r * r).sum::<f64>();
    let (mut damping, mut iterations, mut converged, mut obstacle) = (1e-3, 0, false, None);
    while iterations < ITERATIONS && !converged {
        iterations += 1;
        let (matrix, residuals) = system(&here, values.len());
        let (normal, slope) = (matrix.transpose() * &matrix, matrix.transpose() * &residuals);
        let mut moved = false;
        obstacle = None;
        while !moved && damping < DAMPED {
            let Some(step) = bounded_step(&normal, &slope, damping, &values, &bounds) else {
                damping *= 10.0;
                continue;
            };
            let largest = step.amax();
            let step = if largest > LARGEST { step * (LARGEST / largest) } else { step };
            if step.amax() < SMALL {
                converged = obstacle.is_none();
                break;
            }
            let at = |((value, bounds), step): ((&f64, &Bounds), &f64)| {
                (value * step.exp()).max(bounds.low).min(bounds.high)
            };
            let next: Vec<f64> = values.iter().zip(&bounds).zip(step.iter()).map(at).collect();
            match evaluate(&next) {
                Ok(there) if cost(&there.residuals) < cost(&here.residuals) => {
                    (values, here, moved) = (next, there, true);
                    damping = (damping / 10.0).max(1e-9);
                }
                // No descent to the precision with which the model is solved: this is the bottom.
                Ok(there)
                    if cost(&there.residuals) <= cost(&here.residuals) * (1.0 + 1e-7)
                        && step.amax() < 1e-3
                        && obstacle.is_none() =>
                {
                    converged = true;
                    break;
                }
                Err(NoModel::Cancelled) => return Err(NoModel::Cancelled),
                Err(NoModel::Unsolved(reason)) => {
                    obstacle = Some(reason);
                    damping *= 10.0;
                }
                Ok(_) => damping *= 10.0,
            }
        }
        if !moved {
            break;
        }
    }
    // An obstacle that was gone around is none.
    let obstacle = obstacle.filter(|_| !converged && iterations < ITERATIONS);
    Ok(Fitted { iterations, converged, obstacle, ..finished(&here, values, &bounds) })
}

/// Of each parameter, whether it is at an end of its bounds that the slope of the residuals' squares leads out of.
fn held(values: &[f64], bounds: &[Bounds], slope: &DVector<f64>) -> Vec<bool> {
    let all = values.iter().zip(bounds).zip(slope.iter());
    all.map(|((value, bounds), slope)| bounds.is_left_by(*value, -slope)).collect()
}

/// A damped step of the logarithms that stays within the bounds; `None` where its equations have no solution. What is
/// at an end of its bounds that the slope leads out of is held there; what would go beyond an end goes as far as that;
/// the others go where it is best for them with these.
fn bounded_step(
    normal: &DMatrix<f64>,
    slope: &DVector<f64>,
    damping: f64,
    values: &[f64],
    bounds: &[Bounds],
) -> Option<DVector<f64>> {
    let held = held(values, bounds, slope);
    let mut fixed: Vec<Option<f64>> = held.into_iter().map(|held| held.then_some(0.0)).collect();
    loop {
        let free: Vec<usize> = fixed.iter().enumerate().filter(|(_, step)| step.is_none()).map(|(at, _)| at).collect();
        let mut step = DVector::from_iterator(fixed.len(), fixed.iter().map(|step| step.unwrap_or(0.0)));
        if free.is_empty() {
            return Some(step);
        }
        let right = -(slope + normal * &step);
        let damped = DMatrix::from_fn(free.len(), free.len(), |row, column| {
            let (row, column) = (free[row], free[column]);
            let more = if row == column { damping * normal[(row, row)].max(1e-30) } else { 0.0 };
            normal[(row, column)] + more
        });
        let right = DVector::from_iterator(free.len(), free.iter().map(|at| right[*at]));
        let solved = damped.lu().solve(&right).filter(|step| step.iter().all(|value| value.is_finite()))?;
        free.iter().zip(solved.iter()).for_each(|(at, value)| step[*at] = *value);
        // One at a time: what goes beyond its end with another may not go there without it.
        let beyond = free.iter().filter_map(|at| {
            let (low, high) = bounds.get(*at)?.room(*values.get(*at)?);
            let over = (step[*at] - high).max(low - step[*at]);
            (over > 0.0).then_some((*at, over, step[*at].clamp(low, high)))
        });
        let Some((at, _, end)) = beyond.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Some(step) };
        *fixed.get_mut(at)? = Some(end);
    }
}

fn system(here: &Linearised, parameters: usize) -> (DMatrix<f64>, DVector<f64>) {
    let entry = |row: usize, column: usize| here.rows.get(row).and_then(|row| row.get(column)).copied().unwrap_or(0.0);
    let matrix = DMatrix::from_fn(here.residuals.len(), parameters, entry);
    (matrix, DVector::from_column_slice(&here.residuals))
}

/// Condition beyond which the data determine some combination of the parameters only.
pub const SINGULAR: f64 = 1e6;

/// What a fit has found, before anything is known of how it went.
fn finished(here: &Linearised, values: Vec<f64>, bounds: &[Bounds]) -> Fitted {
    let (matrix, residuals) = system(here, values.len());
    let held = held(&values, bounds, &(matrix.transpose() * &residuals));
    let (count, parameters) = (residuals.len(), values.len());
    let lengths: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
    let mut unit = matrix;
    for (mut column, length) in unit.column_iter_mut().zip(&lengths) {
        column /= length.max(1e-300);
    }
    let singular = unit.clone().svd(false, false).singular_values;
    let (largest, smallest) = (singular.max(), singular.min());
    let condition = if smallest > 0.0 { largest / smallest } else { f64::MAX };
    let degrees = count.saturating_sub(parameters);
    let enough = degrees > 0 && condition < SINGULAR && lengths.iter().all(|length| *length > 0.0);
    let inverse = if enough { (unit.transpose() * &unit).try_inverse() } else { None };
    let variance = residuals.norm_squared() / degrees.max(1) as f64;
    let errors = inverse.as_ref().map(|inverse| {
        let error = |(at, length): (usize, &f64)| (variance * inverse[(at, at)]).max(0.0).sqrt() / length;
        lengths.iter().enumerate().map(error).collect()
    });
    let correlation = inverse.map_or_else(Vec::new, |inverse| {
        let entry = |a: usize, b: usize| inverse[(a, b)] / (inverse[(a, a)] * inverse[(b, b)]).sqrt();
        (0..parameters).map(|a| (0..parameters).map(|b| entry(a, b)).collect()).collect()
    });
    let quantile = student(degrees);
    Fitted { values, held, errors, correlation, quantile, iterations: 0, converged: false, obstacle: None, condition }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn free(start: [f64; 2]) -> [(f64, Bounds); 2] {
        start.map(|value| (value, Bounds::POSITIVE))
    }

    /// y = a exp(−b x), fitted to itself with a disturbance; the known answer is that of the undisturbed curve.
    fn curve(parameters: &[f64], noise: f64) -> Linearised {
        let (a, b) = (parameters[0], parameters[1]);
        let mut out = Linearised { residuals: Vec::new(), rows: Vec::new() };
        for at in 0..20 {
            let x = f64::from(at) * 0.1;
            let model = a * (-b * x).exp();
            let data = 3.0 * (-0.7 * x).exp() + noise * if at % 2 == 0 { 1.0 } else { -1.0 };
            out.residuals.push(data - model);
            out.rows.push(vec![-model, b * x * model]);
        }
        out
    }

    #[test]
    fn a_curve_is_found_again() {
        let found = fit(&free([1.0, 2.0]), |p| Ok(curve(p, 0.0))).unwrap();
        assert!(
            found.converged && (found.values[0] - 3.0).abs() < 1e-6 && (found.values[1] - 0.7).abs() < 1e-6,
            "{found:?}"
        );
        let noisy = fit(&free([1.0, 2.0]), |p| Ok(curve(p, 0.02))).unwrap();
        let half = noisy.errors.as_ref().unwrap()[0] * noisy.quantile;
        assert!((noisy.values[0] / 3.0).ln().abs() < half, "{noisy:?}");
    }

    #[test]
    fn a_shorter_step_is_tried_where_there_is_no_solution_but_none_after_an_interrupt() {
        let mut calls = 0;
        let beyond = |p: &[f64]| p[0] > 1.2;
        let found = fit(&free([1.0, 2.0]), |p| match beyond(p) && p[0] < 1.3 {
            true => Err(NoModel::Unsolved("a gap".into())),
            false => Ok(curve(p, 0.0)),
        });
        assert!(found.is_ok_and(|found| found.converged));
        let ended = fit(&free([1.0, 2.0]), |p| {
            calls += 1;
            if calls > 1 { Err(NoModel::Cancelled) } else { Ok(curve(p, 0.0)) }
        });
        assert_eq!((ended.unwrap_err(), calls), (NoModel::Cancelled, 2));
    }

    #[test]
    fn a_parameter_is_held_at_the_end_of_its_bounds_and_the_others_go_on() {
        let within = |p: &[f64], bounds: Bounds| match p[0] < bounds.low || p[0] > bounds.high {
            true => Err(NoModel::Unsolved("out of range".into())),
            false => Ok(curve(p, 0.0)),
        };
        // The best a is 3; with a at an end b is what is best with it, whether a starts there or comes there.
        for (low, high, end) in [(0.5, 2.0, 2.0), (4.0, 9.0, 4.0)] {
            let bounds = Bounds { low, high };
            let mut best = 1.0;
            for _ in 0..50 {
                let here = curve(&[end, best], 0.0);
                let slope: f64 = here.rows.iter().zip(&here.residuals).map(|(row, left)| row[1] * left).sum();
                let square: f64 = here.rows.iter().map(|row| row[1] * row[1]).sum();
                best *= (-slope / square).exp();
            }
            for start in [[low, 2.0], [high, 2.0], [(low * high).sqrt(), 0.1]] {
                let start = [(start[0], bounds), (start[1], Bounds::POSITIVE)];
                let found = fit(&start, |p| within(p, bounds)).unwrap();
                assert!(found.converged && found.obstacle.is_none(), "{found:?}");
                assert_eq!((found.values[0], found.held.as_slice()), (end, &[true, false][..]), "{found:?}");
                assert!((found.values[1] / best - 1.0).abs() < 1e-5, "{best} {found:?}");
            }
        }
        // Bounds that the best value lies within change nothing.
        let start = [(2.0, Bounds { low: 2.0, high: 4.0 }), (2.0, Bounds::POSITIVE)];
        let found = fit(&start, |p| Ok(curve(p, 0.0))).unwrap();
        assert!(found.converged && found.held == [false, false], "{found:?}");
        assert!((found.values[0] - 3.0).abs() < 1e-6 && (found.values[1] - 0.7).abs() < 1e-6, "{found:?}");
    }

    #[test]
    fn a_step_that_is_short_for_want_of_a_solution_is_no_convergence() {
        let found = fit(&free([1.0, 2.0]), |p| match p[0] > 2.0 {
            true => Err(NoModel::Unsolved("a wall".into())),
            false => Ok(curve(p, 0.0)),
        });
        let found = found.unwrap();
        assert!(!found.converged && found.obstacle.as_deref() == Some("a wall"), "{found:?}");
    }

    #[test]
    fn parameters_that_act_alike_are_found_out() {
        let alike = |p: &[f64]| {
            let residuals = (0..5).map(|at| f64::from(at) + 1.0 - p[0] * p[1] * f64::from(at)).collect();
            let rows = (0..5).map(|at| vec![-p[0] * p[1] * f64::from(at); 2]).collect();
            Ok(Linearised { residuals, rows })
        };
        let found = fit(&free([1.0, 1.5]), alike).unwrap();
        assert!(found.errors.is_none() && found.condition > SINGULAR, "{found:?}");
    }

    #[test]
    fn the_scale_in_closed_form() {
        let found = scale(&[0.8, 0.82, 0.84], &[0.88, 0.902, 0.924]).unwrap();
        assert!((found.value - 1.0 / 1.1).abs() < 1e-12 && found.rms < 1e-12, "{found:?}");
        assert!(scale(&[0.8], &[0.9]).is_none());
    }
}
