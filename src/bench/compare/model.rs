//! The model at measured operating points.

use super::ENGINE_SCALE;
use super::actuator::Actuator;
use super::comparison::{Clamp, Compared, Comparison, Fit, FittedConstant, Options, Radii};
use super::fit::{self, Bounds, Linearised, NoModel, Scale};
use super::measured::{BadRow, Measured, Table};
use crate::bench::error::{BenchError, BenchProblem};
use crate::bench::statistics::AboveOne;
use crate::case::{Case, Free, Include, Key, Range, RangeEnd, Resolved, Setting, ValueKind};
use crate::clock::Stopwatch;
use crate::drive::{Constant, Failure, SolveOptions, Solved, solve, solve_along};
use crate::losses::LossOutput;
use crate::model::Output;
use crate::result::interpret;

/// A point on its way through the model.
struct Point<'a> {
    /// Its place in the table.
    place: usize,
    /// With the torque of the belt where the search for it begins: that which was measured, or was found last.
    case: Case,
    /// The torque that was measured, N·m: what arrives.
    arriving: f64,
    /// What clamps the belt in the place of the case's clamp.
    actuated: Option<Actuated<'a>>,
    /// The last solution.
    solved: Option<Solved>,
}

impl Point<'_> {
    /// Keeps what was found, for the next search to begin there.
    fn keep(&mut self, said: Said) -> Result<(), NoModel> {
        self.solved = Some(said.solved);
        self.case.set_si(Key::SecondaryTorque, said.torque).map_err(unsolved)
    }
}

/// An actuator where a point has it.
struct Actuated<'a> {
    actuator: &'a Actuator,
    /// Radius of the belt by the ratio of the speeds, m. It follows from the belt's length and the distance of the
    /// shafts, which are not fitted. Slip moves the belt by less than the table of flyweights is exact to.
    radius: f64,
    /// rad/s.
    speed: f64,
}

impl Actuated<'_> {
    /// Sets the axial force that a case has with this actuator. Of the keys that are fitted it depends on the half
    /// angle alone, through the spring's travel; what is returned is its derivative by that.
    fn clamp(&self, case: &mut Case) -> Result<f64, String> {
        let said = |error: crate::case::CaseError| error.to_string();
        let half_angle = case.resolve().map_err(said)?.sheave.half_angle;
        let force = self.actuator.axial_force(self.radius, self.speed, half_angle)?;
        case.set_si(Key::PrimaryAxialForce, force).map_err(said)?;
        Ok(self.actuator.force_by_half_angle(self.radius, half_angle))
    }
}

/// A fitted key of the case.
struct Fitting {
    key: Key,
    /// Where the search starts.
    start: f64,
    bounds: Bounds,
}

/// What the model says of a point.
struct Said {
    efficiency: f64,
    elastic: f64,
    /// Of the belt, N·m.
    torque: f64,
    temperature: Option<f64>,
    /// Derivatives by the fitted keys of the case.
    gradient: Vec<f64>,
    axial_force: f64,
    primary_radius: f64,
    solved: Solved,
}

/// Keys that measured points take the place of.
pub(in crate::bench) const REPLACED: [Key; 9] = [
    Key::PrimarySpeed,
    Key::SecondarySpeed,
    Key::PrimaryTorque,
    Key::SecondaryTorque,
    Key::SpeedRatio,
    Key::PrimaryRadius,
    Key::SecondaryRadius,
    Key::Ratio,
    Key::Free,
];
/// Half an interval of a constant's logarithm from which on it says nothing: e to it is more than a million million.
const WIDEST: f64 = 30.0;
/// Keys of the clamp.
const CLAMPS: [Key; 6] = [
    Key::SlackTension,
    Key::TightTension,
    Key::PrimaryAxialForce,
    Key::SecondaryAxialForce,
    Key::SlipReserve,
    Key::FrictionUtilization,
];
/// Keys of losses besides friction.
const LOSSES: [Key; 7] = [
    Key::LossTangent,
    Key::CordLossTangent,
    Key::PrimaryDrag,
    Key::SecondaryDrag,
    Key::PrimaryDragPerSpeed,
    Key::SecondaryDragPerSpeed,
    Key::GearEfficiency,
];
/// Correlation from which on two constants can hardly be told from each other.
const CORRELATED: f64 = 0.95;

/// Compares a table of points with the model: each is solved with its measured speeds and the torque that arrives.
///
/// # Errors
/// A key that cannot be fitted, a case that cannot be read with the points' values, fewer than two points that the
/// model can solve, fewer points than constants to fit, or [`BenchProblem::Cancelled`].
pub fn compare(base: &Case, table: Table, options: &Options) -> Result<Comparison, BenchError> {
    let keys = keys(base, &table, options)?;
    let mut warnings = Vec::from_iter(repetitions(&table.repeated));
    let mut points: Vec<Compared> = table.points.iter().map(compared).collect();
    let mut ways = Vec::new();
    for (place, measured) in table.points.iter().enumerate() {
        if measured.reason.is_some() {
            continue;
        }
        let Some(point) = points.get_mut(place) else { continue };
        match set_up(base, measured, options) {
            Ok((case, actuated)) => {
                ways.push(Point { place, case, arriving: measured.secondary_torque, actuated, solved: None });
            }
            Err(reason) => point.exclude(reason),
        }
    }
    // Neighbours are solved from each other.
    let ratio = |point: &Point<'_>| points.get(point.place).and_then(|point| point.speed_ratio).unwrap_or(0.0);
    ways.sort_by(|a, b| ratio(a).total_cmp(&ratio(b)));
    let mut trail: Option<Solved> = None;
    for point in &mut ways {
        let Some(compared) = points.get_mut(point.place) else { continue };
        match evaluate(&point.case, point.arriving, trail.as_ref(), options.tolerance, &[]) {
            Ok(said) => {
                trail = Some(said.solved.clone());
                compared.take(&said);
                point.keep(said).map_err(unfitted)?;
            }
            Err(NoModel::Unsolved(reason)) => compared.exclude(format!("the model has no solution: {reason}")),
            Err(NoModel::Cancelled) => return Err(BenchProblem::Cancelled.into()),
        }
    }
    let tried = ways.len();
    let unsolved: Vec<usize> = ways.iter().filter(|point| point.solved.is_none()).map(|point| point.place).collect();
    ways.retain(|point| point.solved.is_some());
    let parameters = keys.len() + usize::from(options.fit.iter().any(|key| key == ENGINE_SCALE));
    if ways.len() < 2.max(parameters + 1) {
        let wanted = 2.max(parameters + 1);
        let path = "the table of points".to_owned();
        let said = |place: Option<usize>| points.get(place?)?.reason.as_deref();
        if tried >= wanted {
            let first = said(unsolved.iter().min().copied()).unwrap_or("the model has no solution");
            let reason =
                format!("{} of {tried} points are left, too few: this takes {wanted}; of one, {first}", ways.len());
            return Err(BenchProblem::NoSolution { path, reason }.into());
        }
        let mut reason = format!("{} of {} points are left, too few: this takes {wanted}", ways.len(), points.len());
        if let Some(first) = points.iter().find_map(|point| point.reason.as_deref()) {
            reason.push_str("; the first is left out because ");
            reason.push_str(first);
        }
        return Err(BenchProblem::NoData { path, reason }.into());
    }
    let of_engine: Vec<bool> = table.points.iter().map(|point| point.of_engine).collect();
    let fit = if options.fit.is_empty() {
        None
    } else {
        Some(fitted(&mut ways, (&mut points, &of_engine), &keys, options, &mut warnings)?)
    };
    let mut comparison = statistics(points, &of_engine, table.bad, fit, warnings);
    for bad in comparison.bad_rows.iter().take(5) {
        comparison.warnings.push(format!("line {} is no operating point: {}", bad.line, bad.reason));
    }
    Ok(comparison)
}

/// The keys of the case that are fitted.
fn keys(base: &Case, table: &Table, options: &Options) -> Result<Vec<Fitting>, BenchError> {
    let resolved = base.resolve().map_err(|error| BenchError::from(unusable("case", error.to_string())))?;
    let settings = resolved.settings();
    let mut keys: Vec<Fitting> = Vec::new();
    for name in options.fit.iter().filter(|name| *name != ENGINE_SCALE) {
        let key = Key::from_path(name).filter(|key| {
            let section = key.entry().section();
            let clamp = CLAMPS.contains(key) && options.clamp == Clamp::OfCase;
            let constant = ["belt", "sheave"].contains(&section) || LOSSES.contains(key);
            matches!(key.entry().kind, ValueKind::Quantity { .. }) && (constant || clamp)
        });
        let setting = key.and_then(|key| settings.iter().find(|(other, _)| *other == key));
        let refused = |reason: String| Err(unusable("--fit", format!("`{name}` {reason}")).into());
        let (key, value) = match setting {
            Some((key, Setting::Number(value))) if *key != Key::BeltLength => (*key, *value),
            Some((_, Setting::Table(_))) => {
                return refused("cannot be fitted, for the case has a table of it: give a number".into());
            }
            Some((_, Setting::Number(_) | Setting::List(_) | Setting::Name(_))) | None => {
                return refused(format!(
                    "cannot be fitted: expected {ENGINE_SCALE}, a constant of belt, sheave or losses other than \
                     belt.length, or the case's own clamp, such as operating_point.slack_tension"
                ));
            }
        };
        if LOSSES.contains(&key) && resolved.losses.include != Some(Include::On) {
            return refused(
                "cannot be fitted to an efficiency with friction alone, in which it is not: expected --losses on"
                    .into(),
            );
        }
        if value <= 0.0 {
            return refused(format!(
                "= {value} cannot be fitted: the search is one in logarithms, and starts from a value above zero \
                 (--set {name}=...)"
            ));
        }
        if keys.iter().any(|other| other.key == key) {
            return refused("is given twice".into());
        }
        keys.push(Fitting { key, start: value, bounds: bounds_of(key) });
    }
    if options.fit.iter().any(|name| name == ENGINE_SCALE) && !table.points.iter().any(|point| point.of_engine) {
        let reason = format!(
            "{ENGINE_SCALE} needs points whose input torque is that of the engine's curve (--engine): that of all is \
             measured"
        );
        return Err(unusable("--fit", reason).into());
    }
    Ok(keys)
}

/// The values above zero that a key takes, SI. What is searched comes as near to an end that is not allowed itself as a
/// billionth of it.
fn bounds_of(key: Key) -> Bounds {
    const NEAR: f64 = 1e-9;
    let ValueKind::Quantity { unit, range: Range { low, high }, .. } = key.entry().kind else {
        return Bounds::POSITIVE;
    };
    let end = |end: RangeEnd, near: f64| match end {
        RangeEnd::None => None,
        RangeEnd::Open(end) => Some(unit.to_si(end) * near),
        RangeEnd::Closed(end) => Some(unit.to_si(end)),
    };
    let low = end(low, 1.0 + NEAR).map_or(0.0, |low| low.max(0.0));
    Bounds { low, high: end(high, 1.0 - NEAR).unwrap_or(f64::INFINITY) }
}

fn unusable(path: &str, reason: String) -> BenchProblem {
    BenchProblem::Unusable { path: path.into(), reason }
}

fn compared(measured: &Measured) -> Compared {
    let finite = |value: f64| Some(value).filter(|value| value.is_finite());
    Compared {
        run: measured.run.clone(),
        step: measured.step,
        primary_speed: measured.primary_speed,
        secondary_speed: measured.secondary_speed,
        secondary_torque: measured.secondary_torque,
        primary_torque: finite(measured.primary_torque),
        speed_ratio: finite(measured.primary_speed / measured.secondary_speed),
        primary_radius: None,
        primary_axial_force: None,
        efficiency_measured: finite(measured.efficiency),
        efficiency_error: measured.efficiency_error,
        efficiency_interval: measured.efficiency_interval,
        efficiency_model: None,
        efficiency_elastic: None,
        belt_temperature: None,
        used: measured.reason.is_none(),
        reason: measured.reason.clone(),
    }
}

impl Compared {
    fn exclude(&mut self, reason: String) {
        self.used = false;
        self.reason = Some(reason);
    }

    fn take(&mut self, said: &Said) {
        self.efficiency_model = Some(said.efficiency);
        self.efficiency_elastic = Some(said.elastic);
        self.belt_temperature = said.temperature;
        self.primary_axial_force = Some(said.axial_force);
        self.primary_radius = Some(said.primary_radius);
    }
}

/// The case of a point, and what clamps its belt in the place of the case's clamp.
fn set_up<'a>(base: &Case, measured: &Measured, options: &'a Options) -> Result<(Case, Option<Actuated<'a>>), String> {
    let mut case = base.clone();
    let said = |error: crate::case::CaseError| error.to_string();
    for key in REPLACED {
        case.unset(key.path()).map_err(said)?;
    }
    case.set_si(Key::PrimarySpeed, measured.primary_speed).map_err(said)?;
    case.set_si(Key::SecondaryTorque, measured.secondary_torque).map_err(said)?;
    case.set_si(Key::Ratio, measured.primary_speed / measured.secondary_speed).map_err(said)?;
    let resolved = case.resolve().map_err(said)?;
    if options.radii == Radii::Speeds {
        case.unset(Key::Ratio.path()).map_err(said)?;
        case.set(Key::Free.path(), Free::Both.name()).map_err(said)?;
        case.set_si(Key::SecondarySpeed, measured.secondary_speed).map_err(said)?;
    }
    let Clamp::Actuator(actuator) = &options.clamp else { return Ok((case, None)) };
    for key in CLAMPS {
        case.unset(key.path()).map_err(said)?;
    }
    let actuated = Actuated { actuator, radius: resolved.drive.primary_radius, speed: measured.primary_speed };
    actuated.clamp(&mut case)?;
    Ok((case, Some(actuated)))
}

/// Steps in which the belt's torque is found of which losses leave what arrives: each leaves some twentieth of what is
/// missing, for what losses take hardly depends on the torque.
const TORQUE_STEPS: usize = 20;
/// Part of the tolerance to which that torque is found.
const TORQUE: f64 = 0.1;

/// What the model says where so much torque arrives: without losses besides friction it is the belt's, with them it is
/// what they leave of the belt's. From a solution nearby if that can be; derivatives by `keys`, each with the
/// derivative of the primary's axial force by it where an actuator makes that force.
fn evaluate(
    case: &Case,
    arriving: f64,
    near: Option<&Solved>,
    tolerance: f64,
    keys: &[(Key, f64)],
) -> Result<Said, NoModel> {
    if case.resolve().map_err(unsolved)?.losses.include != Some(Include::On) {
        return at_torque(case, near, tolerance, keys);
    }
    let (mut case, mut near) = (case.clone(), near.cloned());
    for _ in 0..TORQUE_STEPS {
        let said = at_torque(&case, near.as_ref(), tolerance, &[])?;
        let missing = arriving - said.torque * said.efficiency / said.elastic;
        if missing.abs() <= TORQUE * tolerance * arriving.abs() {
            return if keys.is_empty() { Ok(said) } else { at_torque(&case, Some(&said.solved), tolerance, keys) };
        }
        case.set_si(Key::SecondaryTorque, said.torque + missing).map_err(unsolved)?;
        near = Some(said.solved);
    }
    Err(unsolved("there is no torque of the belt of which the losses besides friction leave what was measured"))
}

/// The same where the case has the belt's torque. With losses, derivatives are those at the torque that arrives.
fn at_torque(case: &Case, near: Option<&Solved>, tolerance: f64, keys: &[(Key, f64)]) -> Result<Said, NoModel> {
    let resolved: Resolved = case.resolve().map_err(unsolved)?;
    case.check_posed(&resolved).map_err(unsolved)?;
    let options = SolveOptions { tolerance, sensitivities: !keys.is_empty(), ..SolveOptions::default() };
    let warm = near.and_then(|near| solve_along(&[near], &resolved, &options).ok());
    let solved = match warm {
        Some(solved) => solved,
        None => solve(&resolved, &options).map_err(failed)?,
    };
    let outcome = interpret(&resolved, &options, solved, Stopwatch::start()).map_err(failed)?;
    let result = &outcome.result;
    let takes_power = || unsolved("the drive takes power from its output: it has no efficiency");
    let elastic = result.efficiency.overall.ok_or_else(takes_power)?;
    let with_losses = resolved.losses.include == Some(Include::On);
    let efficiency = match (with_losses, result.efficiency.overall_with_losses) {
        (true, Some(efficiency)) => efficiency,
        (true, None) => {
            let reason = outcome.no_losses.map(unsolved);
            return Err(reason.unwrap_or_else(|| unsolved("it has no efficiency with losses besides friction")));
        }
        (false, _) => elastic,
    };
    let (_, torque) = resolved.operating_point.load.setting();
    let (of_belt, of_drive) = (Output::EfficiencyOverall.name(), LossOutput::Efficiency.name());
    let slope = |output: &str, key: Key| {
        let row = result.sensitivities.as_ref().and_then(|rows| rows.get(output));
        match row.and_then(|row| row.get(key.path())).copied() {
            Some(value) if value.is_finite() => Ok(value),
            // What friction takes does not depend on what else is lost.
            None if output == of_belt && LOSSES.contains(&key) => Ok(0.0),
            Some(_) | None => {
                Err(unsolved(format!("nothing is known of the derivative of {output} by {}", key.path())))
            }
        }
    };
    let by = |output: &str, &(key, force): &(Key, f64)| {
        let through_force = if force == 0.0 { 0.0 } else { force * slope(output, Key::PrimaryAxialForce)? };
        Ok::<f64, NoModel>(slope(output, key)? + through_force)
    };
    // What arrives is M η/η_e, with the belt's torque M, and stays what it is.
    let left = |of_belt: f64, of_drive: f64| torque * (of_drive - efficiency / elastic * of_belt) / elastic;
    let derivative = |key: &(Key, f64)| {
        if !with_losses {
            return by(of_belt, key);
        }
        let by_torque = (Key::SecondaryTorque, 0.0);
        let (belt_by_torque, drive_by_torque) = (by(of_belt, &by_torque)?, by(of_drive, &by_torque)?);
        let (belt_by_key, drive_by_key) = (by(of_belt, key)?, by(of_drive, key)?);
        let left_by_torque = efficiency / elastic + left(belt_by_torque, drive_by_torque);
        Ok(drive_by_key - drive_by_torque * left(belt_by_key, drive_by_key) / left_by_torque)
    };
    Ok(Said {
        efficiency,
        elastic,
        torque,
        temperature: result.belt.temperature,
        gradient: keys.iter().map(derivative).collect::<Result<_, _>>()?,
        axial_force: result.primary.axial_force,
        primary_radius: outcome.solved.constant(Constant::PrimaryRadius),
        solved: outcome.solved,
    })
}

fn unsolved(reason: impl ToString) -> NoModel {
    NoModel::Unsolved(reason.to_string())
}

fn failed(failure: Failure) -> NoModel {
    if failure.is_cancelled() { NoModel::Cancelled } else { unsolved(failure) }
}

fn unfitted(none: NoModel) -> BenchError {
    match none {
        NoModel::Unsolved(reason) => unusable("--fit", reason).into(),
        NoModel::Cancelled => BenchProblem::Cancelled.into(),
    }
}

/// Fits constants to the points; they then have what the model says with the fitted ones.
fn fitted(
    ways: &mut [Point<'_>],
    (points, of_engine): (&mut [Compared], &[bool]),
    keys: &[Fitting],
    options: &Options,
    warnings: &mut Vec<String>,
) -> Result<Fit, BenchError> {
    let scaled = options.fit.iter().any(|key| key == ENGINE_SCALE);
    let data: Vec<(f64, Option<f64>)> = ways
        .iter()
        .map(|way| {
            points
                .get(way.place)
                .map_or((f64::NAN, None), |p| (p.efficiency_measured.unwrap_or(f64::NAN), p.efficiency_error))
        })
        .collect();
    let of_engine: Vec<bool> = ways.iter().map(|way| of_engine.get(way.place) == Some(&true)).collect();
    // What is measured of the input stands as it is.
    let scale_of = |of_engine: bool, values: &[f64]| {
        if scaled && of_engine { values.last().copied().unwrap_or(1.0) } else { 1.0 }
    };
    let weighted = data.iter().all(|(_, error)| error.is_some_and(|error| error > 0.0));
    // Errors of a few samples are uncertain themselves: beside the typical one, none makes a point count for all.
    let typical = data.iter().filter_map(|(_, error)| *error).sum::<f64>() / data.len() as f64;
    let weight = |error: Option<f64>| if weighted { typical / typical.hypot(error.unwrap_or(typical)) } else { 1.0 };
    let mut start: Vec<(f64, Bounds)> = keys.iter().map(|fitting| (fitting.start, fitting.bounds)).collect();
    if scaled {
        let model = ways.iter().map(|way| points.get(way.place)?.efficiency_model);
        let pairs = data.iter().zip(model).zip(&of_engine).filter(|(_, of_engine)| **of_engine);
        let (measured, model): (Vec<f64>, Vec<f64>) =
            pairs.filter_map(|(((value, _), model), _)| Some((*value, model?))).unzip();
        start.push((fit::scale(&measured, &model).map_or(1.0, |scale| scale.value), Bounds::POSITIVE));
    }
    let found = fit::fit(&start, |values| {
        let said = all(ways, keys, values, options.tolerance)?;
        let mut out = Linearised { residuals: Vec::new(), rows: Vec::new() };
        for ((said, (measured, error)), of_engine) in said.iter().zip(&data).zip(&of_engine) {
            let (weight, scale) = (weight(*error), scale_of(*of_engine, values));
            out.residuals.push(weight * (measured / scale - said.efficiency));
            let mut row: Vec<f64> =
                said.gradient.iter().zip(values).map(|(slope, value)| -weight * slope * value).collect();
            if scaled {
                row.push(if *of_engine { -weight * measured / scale } else { 0.0 });
            }
            out.rows.push(row);
        }
        for (way, said) in ways.iter_mut().zip(said) {
            way.keep(said)?;
        }
        Ok(out)
    });
    let found = found.map_err(unfitted)?;
    let said = all(ways, keys, &found.values, options.tolerance).map_err(unfitted)?;
    let mut square = 0.0;
    for (((way, said), (measured, _)), of_engine) in ways.iter().zip(&said).zip(&data).zip(&of_engine) {
        square += (measured / scale_of(*of_engine, &found.values) - said.efficiency).powi(2);
        if let Some(point) = points.get_mut(way.place) {
            point.take(said);
        }
    }
    let mut names: Vec<&str> = keys.iter().map(|fitting| fitting.key.path()).collect();
    names.extend(scaled.then_some(ENGINE_SCALE));
    say(&names, &found, warnings);
    let constant = |(at, name): (usize, &&str)| {
        let ((start, bounds), value) = (start.get(at).copied()?, found.values.get(at).copied()?);
        let error = found.errors.as_ref().and_then(|errors| errors.get(at).copied());
        let half = error.map(|error| error * found.quantile).filter(|half| *half < WIDEST);
        let interval =
            half.map(|half| ((value * (-half).exp()).max(bounds.low), (value * half.exp()).min(bounds.high)));
        Some(FittedConstant {
            key: (*name).into(),
            start,
            value,
            standard_error: error.map(|e| e * value),
            interval,
            at_end_of_range: found.held.get(at) == Some(&true),
        })
    };
    Ok(Fit {
        constants: names.iter().enumerate().filter_map(constant).collect(),
        correlation: found.correlation.clone(),
        iterations: found.iterations,
        converged: found.converged,
        obstacle: found.obstacle.clone(),
        condition: found.condition,
        weighted,
        rms: (square / data.len() as f64).sqrt(),
    })
}

/// The model at all points with other values of the fitted keys.
fn all(ways: &[Point<'_>], keys: &[Fitting], values: &[f64], tolerance: f64) -> Result<Vec<Said>, NoModel> {
    let said = crate::threads::collect(ways, |way| {
        let mut case = way.case.clone();
        for (fitting, value) in keys.iter().zip(values) {
            case.set_si(fitting.key, *value).map_err(unsolved)?;
        }
        let clamp = way.actuated.as_ref().map(|actuated| actuated.clamp(&mut case));
        let by_half_angle = clamp.transpose().map_err(unsolved)?.unwrap_or(0.0);
        let force = |key: Key| if key == Key::HalfAngle { by_half_angle } else { 0.0 };
        let keys: Vec<(Key, f64)> = keys.iter().map(|fitting| (fitting.key, force(fitting.key))).collect();
        evaluate(&case, way.arriving, way.solved.as_ref(), tolerance, &keys)
    });
    said.into_iter().collect()
}

/// What the data cannot tell.
fn say(names: &[&str], found: &fit::Fitted, warnings: &mut Vec<String>) {
    if !found.converged {
        let mut warning = format!("the fit has not converged in {} iterations", found.iterations);
        if let Some(obstacle) = &found.obstacle {
            warning += &format!(": where its next step leads the model has no solution ({obstacle})");
        }
        warnings.push(warning);
    }
    for ((name, value), _) in names.iter().zip(&found.values).zip(&found.held).filter(|(_, held)| **held) {
        let readable = Key::from_path(name).map_or((*value, String::new()), |key| key.entry().readable(*value));
        warnings.push(format!(
            "{name} is held at the end of its range, {}: beyond it the model would agree better with the data",
            format!("{} {}", readable.0, readable.1).trim_end()
        ));
    }
    if found.errors.is_none() {
        warnings.push(format!(
            "the data do not determine {} together: some combination of them leaves all efficiencies as they are; fit \
            fewer",
            names.join(", ")
        ));
    }
    for (a, row) in found.correlation.iter().enumerate() {
        for (b, correlation) in row.iter().enumerate().skip(a + 1) {
            if let (true, Some(one), Some(other)) = (correlation.abs() > CORRELATED, names.get(a), names.get(b)) {
                warnings.push(format!(
                    "the data can hardly tell {one} from {other}: their estimates are correlated by {correlation:+.3}"
                ));
            }
        }
    }
    for (name, error) in names.iter().zip(found.errors.iter().flatten()) {
        if error * found.quantile > 1.0 {
            warnings.push(format!("the data hardly determine {name}: its interval spans more than a factor of seven"));
        }
    }
}

/// Rows that the table has more than once.
fn repetitions(lines: &[u64]) -> Option<String> {
    let rows = match (lines.first()?, lines.len()) {
        (first, 1) => format!("1 row of the table is identical with an earlier one (line {first})"),
        (first, count) => {
            format!("{count} rows of the table are identical with earlier ones, the first in line {first}")
        }
    };
    Some(format!("{rows}: each counts as a measurement of its own, and makes intervals narrower"))
}

/// Points that are compared though more power was measured to leave than to go in.
fn beyond_one(points: &[Compared]) -> Option<String> {
    let used = points.iter().filter(|point| point.used).filter_map(|point| point.efficiency_measured);
    let AboveOne { count, of, largest } = AboveOne::among(used)?;
    Some(format!(
        "at {count} of {of} points the measured efficiency is above 100 %, up to {:.0} %: more power leaves than goes \
         in; check the engine's curve, and the units of speeds and torque",
        100.0 * largest
    ))
}

fn statistics(
    points: Vec<Compared>,
    of_engine: &[bool],
    bad_rows: Vec<BadRow>,
    fit: Option<Fit>,
    mut warnings: Vec<String>,
) -> Comparison {
    warnings.extend(beyond_one(&points));
    let used = points.iter().zip(of_engine).filter(|(point, _)| point.used);
    let pair = |(point, of_engine): (&Compared, &bool)| {
        Some((point.efficiency_measured?, point.efficiency_model?, *of_engine))
    };
    let pairs: Vec<(f64, f64, bool)> = used.filter_map(pair).collect();
    let count = pairs.len().max(1) as f64;
    let sum = |value: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|(d, m, _)| value(*d, *m)).sum::<f64>();
    let mean = sum(&|d, _| d) / count;
    let spread = sum(&|d, _| (d - mean).powi(2));
    let share = |left: f64| (spread > 0.0).then(|| 1.0 - left / spread);
    let square = sum(&|d, m| (m - d).powi(2));
    let mean_error = sum(&|d, m| m - d) / count;
    let rms = (square / count).sqrt();
    let one = Scale { value: 1.0, interval: (1.0, Some(1.0)), rms };
    let of_engine = pairs.iter().filter(|(.., of_engine)| *of_engine);
    let (measured, model): (Vec<f64>, Vec<f64>) = of_engine.map(|(d, m, _)| (*d, *m)).unzip();
    let best = fit::scale(&measured, &model).unwrap_or(one);
    let scaled = |(d, m, of_engine): &(f64, f64, bool)| (if *of_engine { best.value } else { 1.0 }, *d, *m);
    let after = |weight: &dyn Fn(f64) -> f64| {
        pairs.iter().map(scaled).map(|(scale, d, m)| weight(scale) * (m - d / scale).powi(2)).sum::<f64>()
    };
    Comparison {
        points,
        bad_rows,
        scale: best.value,
        scale_interval: best.interval,
        mean_error,
        rms,
        rms_after_scale: (after(&|_| 1.0) / count).sqrt(),
        r_squared: share(square),
        r_squared_after_scale: share(after(&|scale| scale * scale)),
        fit,
        warnings,
    }
}
