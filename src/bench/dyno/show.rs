//! Operating points as a table and as figures.

use super::point::SteadyPoint;
use super::read::RecordReport;
use crate::bench::cells;
use crate::bench::statistics::student;
use crate::plot::{Axis, Figure, Look, Mark, Series};
use crate::quantity::Unit;
use std::fmt::Write;

/// Revolutions per minute in a radian per second.
const RPM: f64 = Unit::RPM.per_si();

/// Header of the table of operating points; the last columns are standard errors of the means, and of how many parts
/// they are.
const HEADER: &str = "run,step,primary_rpm,primary_rpm_sd,secondary_rpm,secondary_rpm_sd,secondary_torque_Nm,\
    secondary_torque_sd,n_torque,duration_s,primary_rpm_se,secondary_rpm_se,secondary_torque_se,n_parts";

/// The table of operating points that `sheave compare` reads; points that are not steady, or without both speeds and
/// torque, are left out, and counted.
pub fn points_csv(points: &[SteadyPoint]) -> (String, usize) {
    let (mut text, mut left_out) = (format!("{HEADER}\n"), 0);
    for (at, point) in points.iter().enumerate() {
        let (Some(primary), Some(secondary), Some(torque)) =
            (point.primary_speed, point.secondary_speed, point.secondary_torque.filter(|_| point.steady))
        else {
            left_out += 1;
            continue;
        };
        let step = point.step.unwrap_or(at as u64);
        // Writing to a string does not fail. Ten digits: more than any sensor has.
        let _ = writeln!(
            text,
            "{},{step},{:.4},{:.4},{:.4},{:.4},{:.6},{:.6},{},{:.4},{:.5},{:.5},{:.7},{}",
            cells::cell(&point.record),
            primary.mean * RPM,
            primary.deviation * RPM,
            secondary.mean * RPM,
            secondary.deviation * RPM,
            torque.mean,
            torque.deviation,
            torque.samples,
            point.duration,
            primary.error * RPM,
            secondary.error * RPM,
            torque.error,
            point.parts(),
        );
    }
    (text, left_out)
}

/// Points that a figure shows: more are more than there is room for.
const MOST_DOTS: usize = 3000;

/// Figures of all points, and of the records' speeds.
pub fn figures(points: &[SteadyPoint], records: &[RecordReport]) -> Vec<Figure> {
    let count = points.iter().filter(|point| point.steady).count();
    let every = count.div_ceil(MOST_DOTS).max(1);
    let steady: Vec<&SteadyPoint> = points.iter().filter(|point| point.steady).step_by(every).collect();
    let thinned = if every > 1 { format!(", one in {every} of them") } else { String::new() };
    let mut figures = Vec::new();
    let traces: Vec<Series> = records
        .iter()
        .filter(|record| record.trace.iter().any(|(_, p, s)| p.is_finite() && s.is_finite()))
        .filter(|record| record.trace.len() > 2)
        .map(|record| {
            let name = record.record.rsplit(['/', '\\']).next().unwrap_or_default();
            Series::line(name, record.trace.iter().map(|(_, primary, secondary)| (*secondary, *primary)).collect())
        })
        .collect();
    let secondary = || Axis::new("secondary speed (rpm)");
    if !traces.is_empty() && traces.len() <= 12 {
        let caption = "Primary over secondary speed along each record";
        figures.push(Figure::new("shift", caption, secondary(), Axis::new("primary speed (rpm)"), traces));
    }
    let mut over = |name: &str, caption: &str, axis: &str, value: &dyn Fn(&SteadyPoint) -> Option<(f64, f64)>| {
        let half = |point: &SteadyPoint| student(point.parts().saturating_sub(1));
        let drawn = |point: &&SteadyPoint| {
            let (value, error) = value(point)?;
            Some((point.secondary_speed?.mean * RPM, (value, half(point) * error)))
        };
        let values: Vec<(f64, (f64, f64))> = steady.iter().filter_map(drawn).collect();
        if values.is_empty() {
            return;
        }
        let dots = values.iter().map(|(x, (y, _))| (*x, *y)).collect();
        let mut bars = Vec::new();
        for (x, (y, half)) in &values {
            bars.extend([(*x, y - half), (*x, y + half), (f64::NAN, f64::NAN)]);
        }
        let series = vec![
            Series::line("95 % interval", bars).color(6),
            Series::line("steady points", dots).look(Look::Dots).color(0),
        ];
        let speeds = values.iter().map(|(speed, _)| *speed);
        let caption = format!("{caption}{thinned}");
        figures.push(Figure::new(name, caption, aired(secondary(), speeds), Axis::new(axis), series));
    };
    over("primary_speed", "Primary speed of the steady points", "primary speed (rpm)", &|point| {
        point.primary_speed.map(|speed| (speed.mean * RPM, speed.error * RPM))
    });
    over("torque", "Torque of the steady points", "torque of the secondary (N·m)", &|point| {
        point.secondary_torque.map(|torque| (torque.mean, torque.error))
    });
    over("power", "Output power of the steady points", "output power (W)", &|point| {
        point.output_power.map(|power| (power.value, power.error))
    });
    over("efficiency", "Overall efficiency of the steady points, by the engine's curve", "efficiency (%)", &|point| {
        point.efficiency.map(|efficiency| (100.0 * efficiency.value, 100.0 * efficiency.error))
    });
    figures
}

/// The axis over what the values span and a little more, so that no point lies on the frame.
pub(crate) fn aired(axis: Axis, values: impl Iterator<Item = f64>) -> Axis {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    let air = 0.04 * (high - low);
    if air > 0.0 { axis.over(low - air, high + air) } else { axis }
}

/// Torque over time and its spectrum with the lines of the shafts, as Figures 9.7 and 9.8; nothing without torque.
pub fn spectrum_figures(point: &SteadyPoint, rate: f64) -> Vec<Figure> {
    let Some(spectrum) = &point.spectrum else { return Vec::new() };
    let time = |at: usize| at as f64 / rate;
    let samples = point.torque_samples.iter().enumerate().map(|(at, torque)| (time(at), *torque)).collect();
    let speed = point.secondary_speed.map_or(f64::NAN, |speed| speed.mean * RPM);
    let engine = point.primary_speed.map_or(f64::NAN, |speed| speed.mean * RPM);
    let caption = format!("Torque in {}, at a secondary speed of {speed:.0} rpm", point.record);
    let axes = (Axis::new("time (s)"), Axis::new("torque of the secondary (N·m)"));
    let torque = Figure::new("torque_time", caption, axes.0, axes.1, vec![Series::line("", samples)]);
    let frequency = |at: usize| (at + 1) as f64 * spectrum.resolution;
    let lines: Vec<(f64, f64)> =
        spectrum.amplitudes.iter().enumerate().map(|(at, amplitude)| (frequency(at), *amplitude)).collect();
    let top = lines.iter().map(|(_, amplitude)| *amplitude).fold(0.0, f64::max).max(1e-9);
    let mut series = vec![Series::line("", lines)];
    let mut marks = Vec::new();
    for (at, order) in point.orders.iter().filter(|order| order.amplitude.is_some()).enumerate() {
        // Each name on a line of its own, so that lines close together keep theirs apart.
        let height = top * (1.12 + 0.09 * at as f64);
        series.push(
            Series::line("", vec![(order.frequency, 0.0), (order.frequency, height - 0.04 * top)]).look(Look::Guide),
        );
        // The text stays within the frame.
        let middle = order.frequency.clamp(0.13 * rate / 2.0, 0.87 * rate / 2.0);
        marks.push(Mark { at: (middle, height), text: format!("{} {:.1} Hz", order.name, order.frequency) });
    }
    let caption = format!(
        "Spectrum of the torque in {} without its mean, at {engine:.0} rpm of the primary and {speed:.0} rpm of the \
        secondary",
        point.record
    );
    let axes = (Axis::new("frequency (Hz)"), Axis::new("amplitude (N·m)"));
    let y = axes.1.over(0.0, top * (1.2 + 0.09 * marks.len() as f64));
    let mut figure = Figure::new("torque_spectrum", caption, axes.0.over(0.0, rate / 2.0), y, series);
    figure.marks = marks;
    vec![torque, figure]
}
