//! Tunes as tables and as a figure.

use super::search::{Ranking, Tune};
use crate::plot::{Axis, Figure, Look, Series};
use crate::quantity::rpm;
use crate::study::{Cell, Table};
use serde_json::Number;
use std::fmt::Write;

/// Tunes in the summary.
const SHOWN: usize = 10;
/// Deviation in rpm beyond which the figure does not reach, over that of the median.
const REACH: f64 = 2.0;

/// All tunes with their parts and merits, best first: speeds in rad/s.
pub fn table(ranking: &Ranking, pareto: bool) -> Table {
    let kinds: Vec<String> = ranking.tunes.first().map(|tune| tune.parts.keys().cloned().collect()).unwrap_or_default();
    let merits = ["rms_deviation", "mean_speed", "smallest_slip_reserve", "mean_efficiency", "last_ratio"];
    let confirmed = ["confirmed.rms_deviation", "confirmed.smallest_slip_reserve", "confirmed.mean_efficiency"];
    let number = |value: Option<f64>| value.and_then(Number::from_f64).map_or(Cell::Empty, Cell::Number);
    let row = |tune: &Tune| {
        let names = kinds.iter().map(|kind| Cell::Text(tune.parts.get(kind).map_or("", String::as_str).into()));
        let m = &tune.merits;
        let screened = [m.rms_deviation, m.mean_speed, m.smallest_slip_reserve, m.mean_efficiency, tune.last_ratio];
        let full = tune.confirmed.as_ref().and_then(|confirmed| confirmed.merits);
        let full =
            [full.map(|m| m.rms_deviation), full.map(|m| m.smallest_slip_reserve), full.map(|m| m.mean_efficiency)];
        let cells = [Cell::Number(tune.candidate.into())].into_iter().chain(names);
        let cells = cells.chain(screened.map(|value| number(Some(value)))).chain([Cell::Truth(tune.pareto)]);
        cells.chain(full.map(number)).collect()
    };
    let columns = ["candidate".to_owned()].into_iter().chain(kinds.iter().cloned());
    let columns = columns.chain(merits.map(str::to_owned)).chain(["pareto".to_owned()]);
    let tunes = ranking.tunes.iter().filter(|tune| !pareto || tune.pareto);
    Table { columns: columns.chain(confirmed.map(str::to_owned)).collect(), rows: tunes.map(row).collect() }
}

/// Deviation from the target over the smallest slip reserve: every tune, and those that no other beats.
pub fn pareto_figure(ranking: &Ranking) -> Figure {
    let at = |tune: &Tune| (100.0 * tune.merits.smallest_slip_reserve, rpm(tune.merits.rms_deviation));
    let median = ranking.tunes.get(ranking.tunes.len() / 2).map_or(0.0, |tune| rpm(tune.merits.rms_deviation));
    let shown = || ranking.tunes.iter().filter(|tune| rpm(tune.merits.rms_deviation) <= REACH * median.max(1.0));
    let all = Series::line("all that shift", shown().filter(|tune| !tune.pareto).map(at).collect()).look(Look::Dots);
    let front = Series::line("beaten by none", shown().filter(|tune| tune.pareto).map(at).collect());
    Figure::new(
        "pareto",
        format!(
            "Deviation from {:.0} rpm over the shift, and the smallest slip reserve; beaten by none in these two and \
             the mean efficiency",
            rpm(ranking.target)
        ),
        Axis::new("smallest slip reserve (%)"),
        Axis::new("rms deviation (rpm)"),
        vec![all.color(7), front.look(Look::Dots).color(1)],
    )
}

/// The best in words.
pub fn summary(ranking: &Ranking) -> String {
    let mut text = format!(
        "{} combinations of parts for {:.0} rpm over {} points of the shift, ratio {:.2} to {:.2}\n",
        ranking.candidates,
        rpm(ranking.target),
        ranking.points,
        ranking.ratios.first().copied().unwrap_or(f64::NAN),
        ranking.ratios.last().copied().unwrap_or(f64::NAN),
    );
    let pareto = ranking.tunes.iter().filter(|tune| tune.pareto).count();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{} shift, {pareto} of them are beaten by none; {} readings of the map{}",
        ranking.tunes.len(),
        ranking.readings,
        match ranking.in_full {
            0 => String::new(),
            1 => ", and 1 point beside it in full".to_owned(),
            points => format!(", and {points} points beside it in full"),
        }
    );
    let last = ranking.ratios.last().copied().unwrap_or(f64::NAN);
    let stopped = ranking.tunes.iter().filter(|tune| tune.last_ratio > last).count();
    let _ = match stopped {
        0 => Ok(()),
        1 => writeln!(text, "1 comes to a stop before that ratio, where its last point is"),
        many => writeln!(text, "{many} come to a stop before that ratio, where their last point is"),
    };
    text.push('\n');
    for refused in &ranking.refused {
        let _ = writeln!(
            text,
            "  {:>6} refused: {} (number {}: {})",
            refused.count, refused.reason, refused.candidate, refused.example
        );
    }
    let _ = writeln!(
        text,
        "\n{:>4}  {:>9} {:>9} {:>9} {:>10}   {:>9} {:>9}  parts",
        "", "rms rpm", "mean rpm", "reserve", "efficiency", "full: rms", "reserve"
    );
    for (at, tune) in ranking.tunes.iter().take(SHOWN).enumerate() {
        let full = tune.confirmed.as_ref().and_then(|confirmed| confirmed.merits);
        let full = full.map_or_else(
            || format!("{:>9} {:>9}", "", ""),
            |m| format!("{:>9.1} {:>7.1} %", rpm(m.rms_deviation), 100.0 * m.smallest_slip_reserve),
        );
        let names: Vec<String> = tune.parts.iter().map(|(kind, name)| format!("{kind} {name}")).collect();
        let m = &tune.merits;
        let _ = writeln!(
            text,
            "{:>4}{} {:>9.1} {:>9.0} {:>7.1} % {:>8.2} %   {full}  {}",
            at + 1,
            if tune.pareto { "*" } else { " " },
            rpm(m.rms_deviation),
            rpm(m.mean_speed),
            100.0 * m.smallest_slip_reserve,
            100.0 * m.mean_efficiency,
            names.join(", ")
        );
    }
    text += "\n* beaten by none in deviation, reserve and efficiency\n";
    text
}
