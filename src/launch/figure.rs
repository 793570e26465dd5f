//! The figure of a launch: speed, distance, engine and heat over time.

use super::run::{Launch, LaunchPoint};
use crate::plot::{Axis, Figure, Look, Mark as Text, Series};
use crate::quantity::{km_per_h, rpm};

/// The panels, the topmost first.
pub fn launch_figures(launch: &Launch) -> Vec<Figure> {
    let last = launch.points.last().map_or(1.0, |point| point.time);
    let line = |name: &str, of: &dyn Fn(&LaunchPoint) -> f64| {
        Series::line(name, launch.points.iter().map(|point| (point.time, of(point))).collect())
    };
    let panel = |name: &str, caption: &str, y: &str, series: Vec<Series>| {
        let x = Axis::new("time (s)").over(0.0, last);
        let mut figure = Figure::new(name, caption, x, Axis::new(y), series);
        // Where the clutch no longer slips.
        let highest = figure.series.iter().flat_map(|series| &series.points).map(|point| point.1).fold(0.0, f64::max);
        let at = launch.lock_up.time;
        figure.series.push(Series::line("", vec![(at, 0.0), (at, highest)]).look(Look::Guide));
        figure
    };
    let mut distance =
        panel("launch_distance", "Distance over time", "distance (m)", vec![line("", &|point| point.distance)]);
    for mark in &launch.marks {
        distance
            .series
            .push(Series::line("", vec![(0.0, mark.distance), (mark.time, mark.distance)]).look(Look::Guide));
        distance.series.push(Series::line("", vec![(mark.time, mark.distance)]).look(Look::Dots).color(1));
        let text = format!("{:.0} ft: {:.2} s", mark.distance / 0.3048, mark.time);
        // Beside the dot, below the curve, which rises.
        distance.marks.push(Text { at: (mark.time + 0.12 * last, mark.distance - 3.0), text });
    }
    vec![
        panel(
            "launch_speed",
            "Speed of the vehicle over time",
            "speed (km/h)",
            vec![line("", &|point| km_per_h(point.speed))],
        ),
        distance,
        panel(
            "launch_engine",
            "Speed of engine and secondary over time",
            "speed (rpm)",
            vec![
                line("engine", &|point| rpm(point.engine_speed)),
                line("secondary", &|point| rpm(point.secondary_speed)),
            ],
        ),
        panel(
            "launch_power",
            "Power into and out of the CVT over time",
            "power (kW)",
            vec![
                line("from the engine", &|point| 1e-3 * point.power_in),
                line("out of the secondary", &|point| 1e-3 * point.power_out),
            ],
        ),
    ]
}
