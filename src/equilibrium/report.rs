//! The equilibrium of a drive as an object of numbers, SI, and as people read it.

use std::fmt::Write;

use serde::Serialize;

use super::error::EquilibriumError;
use super::phase::{Direction, ReportedPhase, Stop};
use super::point::{ARRIVING, Equilibrium};
use super::sensitivity::{PartSensitivity, sensitivities};
use crate::actuator::{PrimaryActuator, SecondaryActuator};
use crate::case::Resolved;
use crate::drive::PowerFlow;
use crate::quantity::{celsius, km_per_h, rpm, unsigned_zero};
use crate::result::{Doubt, DriveResult, Outcome, slip};

/// Share of the friction at hand below which the belt counts as slipping: what presses does not carry the torque, or
/// hardly does.
pub const SLIPPING: f64 = 0.05;

/// The equilibrium of a drive, SI.
#[derive(Debug, Clone, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct DriveReport {
    /// Name of the edition of the equations.
    pub edition: &'static str,
    /// Where the sheaves stand.
    pub phase: ReportedPhase,
    /// The stop on which a sheave rests.
    pub stop: Option<Stop>,
    /// Force on that stop, N.
    pub stop_force: Option<f64>,
    /// Which way friction in the actuators acts.
    pub direction: Direction,
    /// Speed of the secondary, rad/s.
    pub secondary_speed: f64,
    /// Speed of the primary, rad/s.
    pub primary_speed: f64,
    /// Speed of the vehicle, m/s, if the case has one.
    pub vehicle_speed: Option<f64>,
    /// What the vehicle's acceleration would be, m/s².
    pub acceleration: Option<f64>,
    /// ω_P/ω_S.
    pub speed_ratio: f64,
    /// R_S/R_P.
    pub ratio: f64,
    /// Torque into the primary, N·m.
    pub primary_torque: f64,
    /// Travel of the primary from its start, m.
    pub primary_travel: f64,
    /// Opening of the secondary from where it is closed, m.
    pub secondary_travel: f64,
    /// What presses on the primary.
    pub primary_actuator: &'static str,
    /// What presses on the secondary.
    pub secondary_actuator: &'static str,
    /// Force of the flyweights, or that a motor holds, N; nothing where a motor holds the primary's position.
    pub flyweight_force: Option<f64>,
    /// Force of the primary's spring, N, negative as it opens the sheaves.
    pub primary_spring_force: Option<f64>,
    /// Axial force of the belt on the primary, N.
    pub primary_axial_force: f64,
    /// Force of the helix with its torsion spring, or that a motor holds, N.
    pub helix_force: f64,
    /// Force of the secondary's spring in compression, N.
    pub secondary_spring_force: f64,
    /// Axial force of the belt on the secondary, N.
    pub secondary_axial_force: f64,
    /// Difference of actuator and belt where they balance, over the belt's force.
    pub force_residual: f64,
    /// Share of the friction at hand that is left over.
    pub slip_reserve: f64,
    /// Whether the belt slips as a whole, or is about to: its slip reserve is below [`SLIPPING`], or its speed
    /// efficiency below [`ARRIVING`].
    pub slipping: bool,
    /// What else keeps the drive from being sound, the worst of it.
    pub doubt: Option<Doubt>,
    /// Speed efficiency.
    pub speed_efficiency: Option<f64>,
    /// Overall efficiency, with losses besides friction where they are told; nothing where losses take all of the
    /// power.
    pub efficiency: Option<f64>,
    /// Power from the engine, W.
    pub power_in: f64,
    /// Power out of the secondary, W.
    pub power_out: f64,
    /// Temperature of the belt, K, if the case has heat.
    pub belt_temperature: Option<f64>,
    /// What the belt does, as `sheave solve` tells it.
    pub drive: DriveResult<Resolved>,
    /// What each part does to speed and ratio.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<PartSensitivity>,
}

/// The power out of the secondary in W with all losses, and the share of the power put in that it is; none where
/// nothing arrives. The engine's torque is what it is, so that losses lessen what comes out of the secondary: where the
/// secondary is driven, more has to be put in there.
fn delivered(case: &Resolved, drive: &DriveResult<Resolved>) -> (f64, Option<f64>) {
    let (power_in, power_out) = (drive.energy.power_in, drive.energy.power_out);
    let efficiency = drive.efficiency.overall_with_losses.or(drive.efficiency.overall);
    match &drive.losses {
        None => (power_out, efficiency),
        Some(losses) if PowerFlow::of(power_in, power_out) == PowerFlow::FromPrimary => {
            (losses.power_out, efficiency.filter(|share| *share > 0.0))
        }
        Some(losses) => {
            let delivered = losses.behind_gears(power_out, case.losses.gear_efficiency);
            (delivered, drive.efficiency.overall.map(|_| power_in / delivered))
        }
    }
}

impl DriveReport {
    /// Of an equilibrium.
    ///
    /// # Errors
    /// As [`sensitivities`].
    pub fn new(
        case: &Resolved,
        found: &Equilibrium,
        outcome: Outcome,
        with_parts: bool,
    ) -> Result<Self, EquilibriumError> {
        let drive = outcome.result;
        let secondary_speed = drive.secondary.speed;
        let vehicle = case.parts.vehicle.as_ref();
        let (delivered, efficiency) = delivered(case, &drive);
        let forces = &found.forces;
        let actuators = case
            .parts
            .actuation
            .as_ref()
            .map_or(("none", "none"), |parts| (primary_name(&parts.primary), secondary_name(&parts.secondary)));
        Ok(Self {
            edition: case.edition.name(),
            phase: found.phase.reported(),
            stop: found.phase.stop(),
            stop_force: forces.stop,
            direction: found.direction,
            secondary_speed,
            primary_speed: drive.primary.speed,
            vehicle_speed: vehicle.map(|vehicle| vehicle.load(secondary_speed).speed),
            acceleration: vehicle.map(|vehicle| vehicle.acceleration(secondary_speed, delivered / secondary_speed)),
            speed_ratio: drive.primary.speed / secondary_speed,
            ratio: drive.secondary.radius / drive.primary.radius,
            primary_torque: drive.primary.torque,
            primary_travel: found.primary_travel,
            secondary_travel: found.secondary_travel,
            primary_actuator: actuators.0,
            secondary_actuator: actuators.1,
            flyweight_force: forces.primary.map(|force| force.mechanism),
            primary_spring_force: forces.primary.map(|force| force.spring),
            primary_axial_force: forces.primary_belt,
            helix_force: forces.secondary.mechanism,
            secondary_spring_force: forces.secondary.spring,
            secondary_axial_force: forces.secondary_belt,
            force_residual: forces.residual,
            slip_reserve: drive.slip_reserve,
            slipping: drive.slip_reserve < SLIPPING || drive.efficiency.speed.is_some_and(|share| share < ARRIVING),
            doubt: Doubt::about(&drive),
            speed_efficiency: drive.efficiency.speed,
            efficiency,
            power_in: drive.energy.power_in,
            power_out: delivered,
            belt_temperature: drive.belt.temperature,
            parts: if with_parts { sensitivities(case, found, &drive)? } else { Vec::new() },
            drive,
        })
    }

    /// How the drive stands against slip, in words.
    pub fn slip_words(&self) -> String {
        if self.slipping {
            let arrives = |share: f64| format!(", and {:.1} % of the speed arrives", 100.0 * share);
            return format!(
                "it slips: {:.1} % of the friction at hand is in reserve{}",
                100.0 * self.slip_reserve,
                self.speed_efficiency.map(arrives).unwrap_or_default()
            );
        }
        slip(&self.drive)
    }

    /// What a person reads at a glance, in engineering units.
    pub fn summary(&self) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "Whole drive, edition {}\n", self.edition);
        let mut line = |name: &str, value: String| {
            let _ = writeln!(text, "  {name:<26}{value}");
        };
        line("where?", self.place());
        line("does it slip?", self.slip_words());
        line("engine and primary", format!("{:.1} rpm, {:.2} N·m", rpm(self.primary_speed), self.drive.primary.torque));
        line("secondary", format!("{:.1} rpm, {:.2} N·m", rpm(self.secondary_speed), self.drive.secondary.torque));
        if let (Some(speed), Some(acceleration)) = (self.vehicle_speed, self.acceleration) {
            line("vehicle", format!("{:.1} km/h, {acceleration:.2} m/s² at this throttle", km_per_h(speed)));
        }
        let mm = |value: f64| 1e3 * value;
        line(
            "radii and ratio",
            format!(
                "R_P = {:.3} mm, R_S = {:.3} mm, R_S/R_P = {:.4}",
                mm(self.drive.primary.radius),
                mm(self.drive.secondary.radius),
                self.ratio
            ),
        );
        line(
            "travel",
            format!(
                "primary {:.2} mm closed, secondary {:.2} mm open",
                mm(self.primary_travel),
                mm(self.secondary_travel)
            ),
        );
        line("presses on the primary", self.presses_on_primary());
        line("presses on the secondary", self.presses_on_secondary());
        line(
            "the belt pushes back",
            format!("primary {:.1} N, secondary {:.1} N", self.primary_axial_force, self.secondary_axial_force),
        );
        line("forces balance to", format!("{:.1e} of the belt's", self.force_residual));
        line("power", self.power());
        if let Some(temperature) = self.belt_temperature {
            line("belt", format!("{:.1} °C", celsius(temperature)));
        }
        text += &self.table_of_parts();
        text
    }

    fn presses_on_primary(&self) -> String {
        match (self.flyweight_force, self.primary_spring_force) {
            (Some(fly), Some(spring)) if self.primary_actuator == FLYWEIGHTS => format!(
                "{:.1} N: flyweights {fly:.1} N, spring {} N",
                fly + spring,
                unsigned_zero(&format!("{spring:.1}"))
            ),
            (Some(force), _) => format!("{force:.1} N, which a motor holds"),
            (None, _) => format!("{:.1} N, which the motor takes to hold its place", self.primary_axial_force),
        }
    }

    fn presses_on_secondary(&self) -> String {
        if self.secondary_actuator == HELIX {
            let (helix, spring) = (self.helix_force, self.secondary_spring_force);
            return format!("{:.1} N: helix {helix:.1} N, spring {spring:.1} N", helix + spring);
        }
        format!("{:.1} N, which a motor holds", self.helix_force)
    }

    fn place(&self) -> String {
        let stop = |what: &str| format!("at the {what}, which carries {:.1} N", self.stop_force.unwrap_or(0.0));
        match self.stop {
            Some(Stop::SecondaryClosed) => stop("low stop of the secondary"),
            Some(Stop::PrimaryClosed) => stop("high stop of the primary"),
            Some(Stop::SecondaryOpen) => stop("high stop of the secondary"),
            None if self.phase == ReportedPhase::Held => "where the motor holds the primary".to_owned(),
            None => match self.direction {
                Direction::Up => "between the stops, shifting up".to_owned(),
                Direction::Back => "between the stops, shifting back".to_owned(),
                Direction::Frictionless => "between the stops, friction in the actuators left out".to_owned(),
            },
        }
    }

    fn power(&self) -> String {
        let share =
            self.efficiency.map_or_else(|| "no efficiency".to_owned(), |share| format!("{:.1} %", 100.0 * share));
        let lost = self.power_in - self.power_out;
        format!("{:.0} W in, {:.0} W out, {share}; {lost:.0} W become heat", self.power_in, self.power_out)
    }

    /// What each part does, a table for the workshop.
    pub fn table_of_parts(&self) -> String {
        if self.parts.is_empty() {
            return String::new();
        }
        let mut text = format!(
            "\n  {:<42}{:>14}{:>14}{:>12}\n  {:<42}{:>14}{:>14}{:>12}\n",
            "a part changes by one unit",
            "engine speed",
            "engine speed",
            "ratio",
            "",
            "same road",
            "same ratio",
            "same road"
        );
        for part in &self.parts {
            let entry = part.key.entry();
            // How much of the SI unit one unit is.
            let (unit, symbol) = match entry.kind {
                crate::case::ValueKind::Quantity { unit, .. } | crate::case::ValueKind::List { unit, .. } => {
                    (unit.to_si(1.0), unit.printed())
                }
                crate::case::ValueKind::Choice { .. } => continue,
            };
            let symbol = if symbol.is_empty() { "1".to_owned() } else { symbol };
            let rpm = |by: f64| signed(rpm(by * unit));
            let name = format!("{} ({symbol})", entry.path);
            let shift = part.shift_speed.map_or_else(|| "-".to_owned(), |by| rpm(by) + " rpm");
            let _ = writeln!(
                text,
                "  {name:<42}{:>14}{shift:>14}{:>12}",
                rpm(part.primary_speed) + " rpm",
                format!("{:+.4}", part.ratio * unit)
            );
        }
        text
    }
}

/// Kinds of actuators, as the report names them.
const FLYWEIGHTS: &str = "flyweights";
const HELIX: &str = "helix";

const fn primary_name(actuator: &PrimaryActuator) -> &'static str {
    match actuator {
        PrimaryActuator::Flyweights { .. } => FLYWEIGHTS,
        PrimaryActuator::Force(_) => "servo_force",
        PrimaryActuator::Position(_) => "servo_position",
    }
}

const fn secondary_name(actuator: &SecondaryActuator) -> &'static str {
    match actuator {
        SecondaryActuator::Helix { .. } => HELIX,
        SecondaryActuator::Force(_) => "servo_force",
    }
}

/// Three digits that count, with a sign.
fn signed(value: f64) -> String {
    let digits = (2.0 - libm::log10(value.abs()).floor()).clamp(0.0, 4.0);
    format!("{value:+.*}", if digits.is_finite() { digits as usize } else { 1 })
}
