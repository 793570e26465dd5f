//! What a person reads at a glance, in engineering units.

use std::fmt::Write;

use super::answers::answers_in;
use super::schema::{DriveResult, Pulley, SolverReport};
use super::units::{Measured, Units};
use crate::case::Resolved;
use crate::quantity::unsigned_zero;

/// Rows of the table of both pulleys.
struct Rows<'a> {
    text: &'a mut String,
    units: Units,
    primary: &'a Pulley,
    secondary: &'a Pulley,
}

impl Rows<'_> {
    fn row(&mut self, name: &str, what: Measured, digits: usize, value: fn(&Pulley) -> f64) {
        let unit = self.units.of(what);
        let [primary, secondary] = [self.primary, self.secondary].map(|pulley| unit.number(value(pulley), digits));
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {name:<26}{primary:>12}{secondary:>12}  {}", unit.symbol);
    }

    fn share(&mut self, name: &str, unit: &str, value: fn(&Pulley) -> f64) {
        let [primary, secondary] = [self.primary, self.secondary].map(|pulley| 100.0 * value(pulley));
        let _ = writeln!(self.text, "  {name:<26}{primary:>12.1}{secondary:>12.1}  {unit}");
    }
}

fn pulleys(text: &mut String, units: Units, primary: &Pulley, secondary: &Pulley) {
    let _ = writeln!(text, "  {:<26}{:>12}{:>12}", "", "primary", "secondary");
    let mut rows = Rows { text, units, primary, secondary };
    rows.row("axial force", Measured::Force, 1, |p| p.axial_force);
    rows.row("torque", Measured::Torque, 3, |p| p.torque);
    rows.row("speed", Measured::Speed, 1, |p| p.speed);
    rows.row("power", Measured::Power, 1, |p| p.power);
    rows.row("friction loss", Measured::Power, 1, |p| p.friction_loss);
    rows.row("wrap angle", Measured::Angle, 2, |p| p.wrap_angle);
    rows.row("entry tension", Measured::Force, 1, |p| p.entry_tension);
    rows.row("exit tension", Measured::Force, 1, |p| p.exit_tension);
    rows.row("largest penetration", Measured::Length, 3, |p| p.max_penetration);
    rows.row("smallest sliding speed", Measured::Sliding, 4, |p| p.min_sliding_speed);
    rows.share("adhesion", "% of wrap", |p| p.adhesion_fraction);
    rows.share("friction utilization", "%", |p| p.friction_utilization);
    rows.row("resultant x", Measured::Length, 1, |p| p.resultant_x);
    rows.row("resultant y", Measured::Length, 1, |p| p.resultant_y);
    rows.row("binding moment", Measured::Torque, 1, |p| p.binding_moment);
}

/// What an engineer asks first, then axial forces, efficiencies, the energy audit and how well the solution holds.
pub fn summary(result: &DriveResult<Resolved>) -> String {
    summary_in(Units::Workshop, &[], result)
}

/// As [`summary`], in other units, with warnings behind the answers.
pub fn summary_in(units: Units, warnings: &[String], result: &DriveResult<Resolved>) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "Belt drive, edition {}\n", result.edition);
    for answer in answers_in(units, result) {
        let _ = writeln!(text, "  {:<24}{}", answer.question, answer.answer);
    }
    if !warnings.is_empty() {
        text.push('\n');
        warnings.iter().for_each(|warning| text += &format!("  warning: {warning}\n"));
    }
    text.push('\n');
    pulleys(&mut text, units, &result.primary, &result.secondary);
    text.push('\n');
    efficiencies(&mut text, result);
    energy_audit(&mut text, units, result);
    losses(&mut text, units, result);
    temperature(&mut text, units, result);
    belt(&mut text, units, result);
    solved(&mut text, &result.solver);
    text
}

fn percent(fraction: f64) -> f64 {
    100.0 * fraction
}

fn efficiencies(text: &mut String, result: &DriveResult<Resolved>) {
    let efficiency = &result.efficiency;
    let _ = match (efficiency.overall, efficiency.speed, efficiency.torque) {
        (Some(overall), Some(speed), Some(torque)) => {
            let driving = if result.primary.power < 0.0 { ", the secondary driving" } else { "" };
            writeln!(
                text,
                "  efficiency                {:>11.2} % overall = {:.2} % speed × {:.2} % torque{driving}",
                percent(overall),
                percent(speed),
                percent(torque),
            )
        }
        _ => writeln!(text, "  efficiency                       none: neither pulley drives the other"),
    };
}

fn energy_audit(text: &mut String, units: Units, result: &DriveResult<Resolved>) {
    let (energy, watt) = (&result.energy, units.of(Measured::Power).symbol);
    let power = |watts: f64, digits: usize| units.of(Measured::Power).number(watts, digits);
    // Of the larger power: without torque, the secondary alone covers the losses.
    let rest = energy.power_in - energy.power_out - energy.friction_loss - energy.stretch_work;
    let unaccounted = percent(rest / energy.power_in.abs().max(energy.power_out.abs()));
    let _ = writeln!(
        text,
        "  energy audit              {:>11} {watt} in = {} {watt} out + {} {watt} friction {} {} {watt} strain energy \
        flux; {} % unaccounted for",
        power(energy.power_in, 1),
        power(energy.power_out, 1),
        power(energy.friction_loss, 1),
        if energy.stretch_work < 0.0 { '−' } else { '+' },
        power(energy.stretch_work.abs(), 2),
        unsigned_zero(&format!("{unaccounted:.4}")),
    );
}

/// Losses besides friction, if they were asked for.
fn losses(text: &mut String, units: Units, result: &DriveResult<Resolved>) {
    let (Some(losses), Some(overall)) = (&result.losses, result.efficiency.overall_with_losses) else { return };
    let watt = units.of(Measured::Power).symbol;
    let power = |watts: f64| units.of(Measured::Power).number(watts, 1);
    let _ = writeln!(
        text,
        "  with all losses           {:>11.2} % overall: hysteresis {} {watt} (bending {}, groove {}, cord {}), drag \
        {} {watt}, gears {} {watt}",
        percent(overall),
        power(losses.bending + losses.groove + losses.cord),
        power(losses.bending),
        power(losses.groove),
        power(losses.cord),
        power(losses.drag),
        power(losses.gears),
    );
}

/// The belt's temperature, if it was found.
fn temperature(text: &mut String, units: Units, result: &DriveResult<Resolved>) {
    let (Some(heat), Some(temperature)) = (&result.thermal, result.belt.temperature) else { return };
    let (watt, degree) = (units.of(Measured::Power).symbol, units.of(Measured::Temperature));
    let power = |watts: f64| units.of(Measured::Power).number(watts, 1);
    let _ = writeln!(
        text,
        "  belt temperature          {:>11} {}: {} {watt} into the belt, {} {watt} into the primary's sheaves, {} \
        {watt} into the secondary's",
        degree.number(temperature, 1),
        degree.symbol,
        power(heat.belt),
        power(heat.primary),
        power(heat.secondary),
    );
}

fn belt(text: &mut String, units: Units, result: &DriveResult<Resolved>) {
    let belt = &result.belt;
    let _ = writeln!(
        text,
        "  belt                      {:>14} unstretched, {}{} against the belt given",
        units.show(Measured::Length, belt.unstretched_length, 2),
        if belt.length_error < 0.0 { "" } else { "+" },
        units.show(Measured::Length, belt.length_error, 2),
    );
}

fn solved(text: &mut String, solver: &SolverReport) {
    let mesh = &solver.mesh_intervals;
    let _ = writeln!(
        text,
        "  solved                    {:>11} ms, order {}, residual {:.1e} of {:.0e}, {} intervals, {} steps, {} \
        iterations",
        solver.milliseconds(),
        solver.order,
        solver.max_residual,
        solver.tolerance,
        mesh.primary + mesh.secondary + mesh.tight_span + mesh.slack_span,
        solver.continuation_steps,
        solver.newton_iterations,
    );
}

impl SolverReport {
    /// The time that the solution took in milliseconds, or a dash where the target has no clock.
    pub(crate) fn milliseconds(&self) -> String {
        self.wall_time.map_or_else(|| "-".to_owned(), |seconds| format!("{:.1}", seconds * 1e3))
    }
}
