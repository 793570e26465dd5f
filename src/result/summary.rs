//! What a person reads at a glance, in engineering units.

use std::fmt::Write;

use super::answers::answers;
use super::schema::{DriveResult, Pulley, SolverReport};
use crate::case::Resolved;
use crate::quantity::unsigned_zero;

fn row(text: &mut String, name: &str, unit: &str, digits: usize, values: [f64; 2]) {
    let [primary, secondary] = values;
    // Writing to a string cannot fail.
    let _ = writeln!(text, "  {name:<26}{primary:>12.digits$}{secondary:>12.digits$}  {unit}");
}

fn pulleys(text: &mut String, primary: &Pulley, secondary: &Pulley) {
    let both = |value: fn(&Pulley) -> f64| [value(primary), value(secondary)];
    let _ = writeln!(text, "  {:<26}{:>12}{:>12}", "", "primary", "secondary");
    row(text, "axial force", "N", 1, both(|p| p.axial_force));
    row(text, "torque", "N·m", 3, both(|p| p.torque));
    row(text, "speed", "rpm", 1, both(|p| p.speed * 30.0 / std::f64::consts::PI));
    row(text, "power", "W", 1, both(|p| p.power));
    row(text, "friction loss", "W", 1, both(|p| p.friction_loss));
    row(text, "wrap angle", "deg", 2, both(|p| p.wrap_angle.to_degrees()));
    row(text, "entry tension", "N", 1, both(|p| p.entry_tension));
    row(text, "exit tension", "N", 1, both(|p| p.exit_tension));
    row(text, "largest penetration", "mm", 3, both(|p| p.max_penetration * 1e3));
    row(text, "smallest sliding speed", "mm/s", 4, both(|p| p.min_sliding_speed * 1e3));
    row(text, "adhesion", "% of wrap", 1, both(|p| p.adhesion_fraction * 100.0));
    row(text, "friction utilization", "%", 1, both(|p| p.friction_utilization * 100.0));
    row(text, "resultant x", "mm", 1, both(|p| p.resultant_x * 1e3));
    row(text, "resultant y", "mm", 1, both(|p| p.resultant_y * 1e3));
    row(text, "binding moment", "N·m", 1, both(|p| p.binding_moment));
}

/// What an engineer asks first, then axial forces, efficiencies, the energy audit and how well the solution holds.
pub fn summary(result: &DriveResult<Resolved>) -> String {
    let mut text = String::new();
    let (efficiency, energy, belt, solver) = (&result.efficiency, &result.energy, &result.belt, &result.solver);
    let _ = writeln!(text, "Belt drive, edition {}\n", result.edition);
    for answer in answers(result) {
        let _ = writeln!(text, "  {:<24}{}", answer.question, answer.answer);
    }
    text.push('\n');
    pulleys(&mut text, &result.primary, &result.secondary);
    let percent = |fraction: f64| 100.0 * fraction;
    match (efficiency.overall, efficiency.speed, efficiency.torque) {
        (Some(overall), Some(speed), Some(torque)) => {
            let driving = if result.primary.power < 0.0 { ", the secondary driving" } else { "" };
            let _ = writeln!(
                text,
                "\n  efficiency                {:>11.2} % overall = {:.2} % speed × {:.2} % torque{driving}",
                percent(overall),
                percent(speed),
                percent(torque),
            );
        }
        _ => {
            let _ = writeln!(text, "\n  efficiency                       none: neither pulley drives the other");
        }
    }
    // Of the larger power: without torque, the secondary alone covers the losses.
    let rest = energy.power_in - energy.power_out - energy.friction_loss - energy.stretch_work;
    let unaccounted = percent(rest / energy.power_in.abs().max(energy.power_out.abs()));
    let _ = writeln!(
        text,
        "  energy audit              {:>11.1} W in = {:.1} W out + {:.1} W friction {} {:.2} W stretch work; {} % unaccounted for",
        energy.power_in,
        energy.power_out,
        energy.friction_loss,
        if energy.stretch_work < 0.0 { '−' } else { '+' },
        energy.stretch_work.abs(),
        unsigned_zero(&format!("{unaccounted:.4}")),
    );
    if let (Some(losses), Some(overall)) = (&result.losses, efficiency.overall_with_losses) {
        let _ = writeln!(
            text,
            "  with all losses           {:>11.2} % overall: hysteresis {:.1} W (bending {:.1}, groove {:.1}, cord {:.1}), drag {:.1} W, \
             gears {:.1} W",
            percent(overall),
            losses.bending + losses.groove + losses.cord,
            losses.bending,
            losses.groove,
            losses.cord,
            losses.drag,
            losses.gears,
        );
    }
    if let (Some(heat), Some(temperature)) = (&result.thermal, belt.temperature) {
        let _ = writeln!(
            text,
            "  belt temperature          {:>11.1} °C: {:.1} W into the belt, {:.1} W into the primary's sheaves, {:.1} W into the secondary's",
            temperature - 273.15,
            heat.belt,
            heat.primary,
            heat.secondary,
        );
    }
    let _ = writeln!(
        text,
        "  belt                      {:>11.2} mm unstretched, {:+.2} mm against the belt given",
        belt.unstretched_length * 1e3,
        belt.length_error * 1e3,
    );
    let mesh = &solver.mesh_intervals;
    let _ = writeln!(
        text,
        "  solved                    {:>11} ms, order {}, residual {:.1e} of {:.0e}, {} intervals, {} steps, {} iterations",
        solver.milliseconds(),
        solver.order,
        solver.max_residual,
        solver.tolerance,
        mesh.primary + mesh.secondary + mesh.tight_span + mesh.slack_span,
        solver.continuation_steps,
        solver.newton_iterations,
    );
    text
}

impl SolverReport {
    /// The time that the solution took in milliseconds, or a dash where the target has no clock.
    pub(crate) fn milliseconds(&self) -> String {
        self.wall_time.map_or_else(|| "-".to_owned(), |seconds| format!("{:.1}", seconds * 1e3))
    }
}
