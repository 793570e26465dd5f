//! The comparison for people.

use super::comparison::{Compared, Comparison};
use crate::bench::dyno::aired;
use crate::case::Key;
use crate::plot::{Axis, Figure, Look, Series};
use crate::quantity::Unit;
use crate::text::on_one_line;
use std::fmt::Write;

/// Radius in mm, ratio, measured and computed efficiency, interval of the measured one.
type Drawn = (f64, f64, f64, f64, (f64, f64));

/// Figures: measured and computed efficiency over the primary's radius with error bars, and what remains over the
/// ratio.
pub fn figures(comparison: &Comparison) -> Vec<Figure> {
    let used: Vec<&Compared> = comparison.points.iter().filter(|point| point.used).collect();
    let value = |point: &Compared| {
        Some((1e3 * point.primary_radius?, point.speed_ratio?, point.efficiency_measured?, point.efficiency_model?))
    };
    let mut rows: Vec<Drawn> = used
        .iter()
        .filter_map(|point| {
            let (radius, ratio, measured, model) = value(point)?;
            Some((radius, ratio, measured, model, point.efficiency_interval.unwrap_or((measured, measured))))
        })
        .collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    let scale = comparison.scale;
    let mut bars = Vec::new();
    for (radius, .., (low, high)) in &rows {
        let (low, high) = (low / scale, high / scale);
        bars.extend([(*radius, 100.0 * low), (*radius, 100.0 * high), (f64::NAN, f64::NAN)]);
    }
    let line = |at: &dyn Fn(&Drawn) -> (f64, f64)| rows.iter().map(at).collect::<Vec<_>>();
    let mut series = vec![
        Series::line("model", line(&|row| (row.0, 100.0 * row.3))).color(1).marked(),
        Series::line("", bars).color(6),
        Series::line(format!("measured, engine × {scale:.3}"), line(&|row| (row.0, 100.0 * row.2 / scale)))
            .look(Look::Dots)
            .color(0),
    ];
    if (scale - 1.0).abs() > 1e-9 {
        series.push(
            Series::line("measured, engine's curve as it is", line(&|row| (row.0, 100.0 * row.2)))
                .look(Look::Dots)
                .color(5),
        );
    }
    let caption = "Measured and computed overall efficiency over the primary's radius; bars are 95 % intervals of the \
        measurements";
    let radius = aired(Axis::new("primary radius R_{P} (mm)"), rows.iter().map(|row| row.0));
    let over_radius = Figure::new("efficiency", caption, radius, Axis::new("overall efficiency (%)"), series);
    let mut residual = line(&|row| (row.1, 100.0 * (row.3 - row.2 / scale)));
    residual.sort_by(|a, b| a.0.total_cmp(&b.0));
    let ends = [residual.first(), residual.last()].map(|end| (end.map_or(0.0, |end| end.0), 0.0));
    let series = vec![
        Series::line("", ends.to_vec()).look(Look::Guide),
        Series::line("model less measurement", residual).look(Look::Dots).color(0),
    ];
    let caption = "What remains of the difference with the engine's scale, over the speed ratio";
    let axes = (Axis::new("speed ratio ω_{P}/ω_{S}"), Axis::new("difference (percentage points)"));
    vec![over_radius, Figure::new("residual", caption, axes.0, axes.1, series)]
}

/// The comparison as a person reads it.
pub fn summary(comparison: &Comparison) -> String {
    let used = comparison.points.iter().filter(|point| point.used).count();
    let mut text = format!("{used} of {} points compared\n\n", comparison.points.len());
    let rpm = Unit::RPM.per_si();
    // Writing to a string does not fail.
    let _ = writeln!(
        text,
        "{:>8}{:>14}{:>16}{:>14}{:>9}{:>11}{:>13}{:>11}",
        "step", "primary (rpm)", "secondary (rpm)", "torque (N·m)", "ω_P/ω_S", "R_P (mm)", "measured (%)", "model (%)"
    );
    let percent = |value: Option<f64>| value.map_or_else(|| "-".into(), |value| format!("{:.2}", 100.0 * value));
    for point in &comparison.points {
        let step = point.step.map_or_else(|| on_one_line(&point.run), |step| step.to_string());
        let _ = writeln!(
            text,
            "{step:>8}{:>14.1}{:>16.1}{:>14.3}{:>9.3}{:>11}{:>13}{:>11}  {}",
            point.primary_speed * rpm,
            point.secondary_speed * rpm,
            point.secondary_torque,
            point.speed_ratio.unwrap_or(f64::NAN),
            point.primary_radius.map_or_else(|| "-".into(), |radius| format!("{:.2}", 1e3 * radius)),
            percent(point.efficiency_measured),
            percent(point.efficiency_model),
            point.reason.as_deref().unwrap_or_default(),
        );
    }
    let _ = writeln!(text, "\nmodel less measurement, mean   {:+.2} percentage points", 100.0 * comparison.mean_error);
    let _ = writeln!(text, "root mean square               {:.2} percentage points", 100.0 * comparison.rms);
    let _ = writeln!(text, "R²                             {}", determined(comparison.r_squared));
    let interval = scale_interval(comparison);
    let _ = writeln!(text, "scale of the engine's power    {:.4}  (95 %: {interval})", comparison.scale);
    let _ =
        writeln!(text, "root mean square with it       {:.2} percentage points", 100.0 * comparison.rms_after_scale);
    let _ = writeln!(text, "R² with it                     {}", determined(comparison.r_squared_after_scale));
    if let Some(fit) = &comparison.fit {
        let weights = if fit.weighted { "weighted by the points' errors" } else { "all points alike" };
        let _ = writeln!(text, "\nfit, {weights}, {} iterations", fit.iterations);
        for constant in &fit.constants {
            let readable =
                |si: f64| Key::from_path(&constant.key).map_or((si, String::new()), |key| key.entry().readable(si));
            let ((value, unit), start) = (readable(constant.value), readable(constant.start).0);
            let interval = constant.interval.map_or_else(
                || "not determined".to_owned(),
                |(low, high)| format!("95 %: {:.5} to {:.5}", readable(low).0, readable(high).0),
            );
            let end = if constant.at_end_of_range { "; at the end of its range" } else { "" };
            let _ = writeln!(text, "  {:<32}{value:>12.5} {unit:<8} ({interval}; from {start:.5}{end})", constant.key);
        }
        let _ = writeln!(text, "  root mean square               {:>12.3} percentage points", 100.0 * fit.rms);
    }
    text
}

/// A share as people read it.
pub fn determined(share: Option<f64>) -> String {
    share.map_or_else(|| "not determined".to_owned(), |share| format!("{share:.4}"))
}

/// The interval of the engine's scale as people read it.
pub fn scale_interval(comparison: &Comparison) -> String {
    match comparison.scale_interval {
        (low, Some(high)) => format!("{low:.4} to {high:.4}"),
        (low, None) => format!("from {low:.4} on"),
    }
}
