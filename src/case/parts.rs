//! Parts of a whole drive that a case may have: actuators, engine, vehicle.

use super::error::{CaseError, CaseProblem};
use super::geometry::radius_beside;
use super::given::Case;
use super::keys::{Key, TABLE};
use super::setting::Setting;
use crate::actuator::{
    ActuatorError, AngleFrom, CamArm, Flyweights, Helix, Mechanism, PrimaryActuator, Profile, ProfileError, RollerArm,
    SecondaryActuator, Shift, Spring, travel, travel_by_radius,
};
use crate::model::{FlyweightKind, HelixAngleFrom, SecondaryKind};
use crate::powertrain::{Engine, Governor, Vehicle};

/// Density of the air where none is given, kg/m³.
const AIR: f64 = 1.2;
/// Travels at which parts are tried before anything is computed.
const TRIED: usize = 41;
/// Speed in rad/s and torque in N·m at which they are: forces of a sound mechanism are positive at every speed.
const TRIED_SPEED: f64 = 300.0;
/// How far both radii at the low stop may miss a belt of the given length, m: they are measured, and rounded.
const STOPS_MISS: f64 = 5e-4;

/// Parts of a whole drive, as far as the case has them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Parts {
    /// What presses the sheaves together.
    pub actuation: Option<Actuation>,
    /// The engine.
    pub engine: Option<Engine>,
    /// The vehicle.
    pub vehicle: Option<Vehicle>,
    /// The keys that say so.
    settings: Vec<(Key, Setting)>,
}

/// What presses the sheaves together, and where their stops are.
#[derive(Debug, Clone, PartialEq)]
pub struct Actuation {
    /// What presses on the primary.
    pub primary: PrimaryActuator,
    /// What presses on the secondary.
    pub secondary: SecondaryActuator,
    /// Radius of the belt on the primary where its travel is zero, m.
    pub start_radius: f64,
    /// Radius of the belt on the secondary where it is closed to its stop, m.
    pub closed_radius: f64,
    /// Travel of the primary at which it is closed to its stop, m, if it has one.
    pub primary_travel: Option<f64>,
    /// Opening of the secondary at which it is open to its stop, m, if it has one.
    pub secondary_travel: Option<f64>,
    /// From where the case's helix angles are measured.
    pub angle_from: AngleFrom,
}

impl Parts {
    /// Whether the case gave a key of its parts.
    pub fn has(&self, key: Key) -> bool {
        self.settings.iter().any(|(other, _)| *other == key)
    }

    /// Every key with its value.
    pub(super) fn settings(&self) -> impl Iterator<Item = (Key, Setting)> + '_ {
        self.settings.iter().cloned()
    }
}

/// What is wrong with the parts, as it is found.
struct Reading<'a> {
    case: &'a Case,
    errors: Vec<CaseError>,
}

/// The parts of a case.
///
/// # Errors
/// All that is wrong with them: [`CaseProblem::Needs`], [`CaseProblem::Conflict`], [`CaseProblem::Part`].
pub(super) fn parts(case: &Case) -> Result<Parts, CaseError> {
    let mut reading = Reading { case, errors: Vec::new() };
    let has = |sections: &[&str]| case.keys().any(|key| sections.contains(&key.entry().section()));
    let actuators =
        ["primary", "primary.actuator", "primary.spring", "secondary", "secondary.actuator", "secondary.spring"];
    let actuation = if has(&actuators) { reading.actuation() } else { None };
    let engine = if has(&["engine"]) { reading.engine() } else { None };
    let vehicle = if has(&["vehicle"]) { reading.vehicle() } else { None };
    if let Some(error) = CaseError::all(reading.errors) {
        return Err(error);
    }
    let sections = ["engine", "vehicle"];
    let of_parts = |key: Key| [actuators.as_slice(), &sections].concat().contains(&key.entry().section());
    let settings = case.settings().filter(|(key, _)| of_parts(*key)).collect();
    Ok(Parts { actuation, engine, vehicle, settings })
}

impl Reading<'_> {
    /// A quantity that `by` calls for.
    fn need(&mut self, by: Key, key: Key) -> Option<f64> {
        let found = self.case.quantity(key);
        if found.is_none() {
            self.missing(by, key);
        }
        found
    }

    fn missing(&mut self, by: Key, key: Key) {
        let given = self.case.has(by).then(|| self.case.written(by));
        self.errors.push(CaseError::new(CaseProblem::Needs { key: by, given, needs: key }, self.case.places([by])));
    }

    fn value(&self, key: Key, otherwise: f64) -> f64 {
        self.case.quantity(key).unwrap_or(otherwise)
    }

    fn wrong(&mut self, key: Key, reason: impl std::fmt::Display) {
        let problem = CaseProblem::Part { key, reason: reason.to_string() };
        self.errors.push(CaseError::new(problem, self.case.places([key])));
    }

    /// The value, or its error told at the key.
    fn sound<T>(&mut self, key: Key, made: Result<T, ActuatorError>) -> Option<T> {
        made.map_err(|error| self.wrong(key, error)).ok()
    }

    /// Two lists of equal length as a curve.
    fn curve(&mut self, by: Key, places: Key, values: Key) -> Option<Profile> {
        for key in [places, values].into_iter().filter(|key| !self.case.has(*key)) {
            self.missing(by, key);
        }
        let (at, of) = (self.case.list(places)?.to_vec(), self.case.list(values)?.to_vec());
        match Profile::new(at, of) {
            // Told in the unit of the key.
            Err(ProfileError::Order { point, place, before }) => {
                let [here, before] = [place, before].map(|si| places.entry().rounded(si));
                let reason = format!("number {point} is {here}, not beyond {before}: expected increasing values");
                self.wrong(places, reason);
                None
            }
            made => self.sound(places, made.map_err(ActuatorError::from)),
        }
    }

    /// Keys of a section that its type does not take are refused, lest they be thought to count.
    fn only(&mut self, by: Key, taken: &[Key]) {
        let section = by.entry().section();
        let others = TABLE.iter().filter(|entry| entry.section() == section && entry.key != by);
        let unused: Vec<Key> =
            others.map(|entry| entry.key).filter(|key| self.case.has(*key) && !taken.contains(key)).collect();
        for key in unused {
            let error = self.case.conflict(by, key, "an actuator of this type does not take it");
            self.errors.push(error);
        }
    }

    fn actuation(&mut self) -> Option<Actuation> {
        let (start_radius, closed_radius) = self.stops()?;
        let primary = self.primary();
        let secondary = self.secondary();
        let angle_from = self.angle_from();
        let (primary_travel, secondary_travel) =
            (self.case.quantity(Key::PrimaryTravel), self.case.quantity(Key::SecondaryTravel));
        let (primary, secondary) = (primary?, secondary?);
        let actuation =
            Actuation { primary, secondary, start_radius, closed_radius, primary_travel, secondary_travel, angle_from };
        self.try_out(&actuation);
        Some(actuation)
    }

    /// The radii at the low stop: as given, or from one another by the pitch length (6.12).
    fn stops(&mut self) -> Option<(f64, f64)> {
        let (start, closed) = (self.case.quantity(Key::StartRadius), self.case.quantity(Key::ClosedRadius));
        let (length, center) = (self.case.value(Key::BeltLength), self.case.value(Key::CenterDistance));
        let beside = |radius: f64| if radius < center { radius_beside(radius, length, center).ok() } else { None };
        let (key, found) = match (start, closed) {
            (Some(start), Some(closed)) => match beside(closed) {
                Some(low) if low < start - STOPS_MISS => {
                    let reason = format!(
                        "a belt of {:.1} mm lies at a radius of {:.1} mm on the primary where the secondary is closed; \
                         expected at most that: a primary that is open there would hold the secondary open",
                        1e3 * length,
                        1e3 * low
                    );
                    self.wrong(Key::StartRadius, reason);
                    return None;
                }
                low => (Key::ClosedRadius, low.map(|_| (start, closed))),
            },
            (Some(start), None) => (Key::StartRadius, beside(start).map(|closed| (start, closed))),
            (None, Some(closed)) => (Key::ClosedRadius, beside(closed).map(|start| (start, closed))),
            (None, None) => {
                let by = self.case.keys().find(|key| key.entry().section().starts_with("primary"));
                let by = by.unwrap_or(Key::SecondaryActuator);
                self.missing(by, Key::ClosedRadius);
                return None;
            }
        };
        if found.is_none() {
            let reason = format!(
                "a belt of {:.1} mm fits no other pulley {:.1} mm away from it; expected a radius at which it does",
                1e3 * length,
                1e3 * center
            );
            self.wrong(key, reason);
        }
        found
    }

    fn primary(&mut self) -> Option<PrimaryActuator> {
        let by = Key::Flyweights;
        let Some(kind) = self.case.choice(by).and_then(FlyweightKind::from_name) else {
            let given = self.case.keys().find(|key| key.entry().section().starts_with("primary"));
            self.missing(given.unwrap_or(Key::SecondaryActuator), by);
            return None;
        };
        let common = [Key::FlyweightCount, Key::FlyweightMass];
        let mechanism = match kind {
            FlyweightKind::Servo => return self.servo(),
            FlyweightKind::Table => {
                let own = [Key::FlyweightLost, Key::FlyweightTravels, Key::FlyweightCoefficients];
                self.only(by, &[common.as_slice(), &own].concat());
                let lost = self.value(Key::FlyweightLost, 0.0);
                let curve = self.curve(by, Key::FlyweightTravels, Key::FlyweightCoefficients);
                curve.map(|coefficient| Mechanism::Coefficient { coefficient, lost })
            }
            FlyweightKind::Ramp => {
                let own = [Key::FlyweightFriction, Key::FlyweightTravels, Key::FlyweightRadii];
                self.only(by, &[common.as_slice(), &own].concat());
                let friction_angle = self.value(Key::FlyweightFriction, 0.0);
                let curve = self.curve(by, Key::FlyweightTravels, Key::FlyweightRadii);
                curve.map(|radius| Mechanism::Ramp { radius, friction_angle })
            }
            FlyweightKind::Arm => self.arm(by, &common),
            FlyweightKind::Cam => self.cam(by, &common),
        };
        let count = self.need(by, Key::FlyweightCount).and_then(|count| self.whole(count));
        let mass = self.need(by, Key::FlyweightMass);
        let spring = self.spring([
            Key::PrimarySpringRate,
            Key::PrimarySpringPreload,
            Key::PrimarySpringFree,
            Key::PrimarySpringInstalled,
            Key::PrimarySpringSolid,
        ]);
        let flyweights = Flyweights { count: count?, mass: mass?, mechanism: mechanism? };
        Some(PrimaryActuator::Flyweights { flyweights, spring: spring? })
    }

    /// A number of flyweights.
    fn whole(&mut self, count: f64) -> Option<u32> {
        if count.fract() != 0.0 || count < 1.0 {
            self.wrong(Key::FlyweightCount, format!("{count} is no number of flyweights; expected a whole number"));
            return None;
        }
        // At most 100, by the key's range.
        Some(count as u32)
    }

    fn arm(&mut self, by: Key, common: &[Key]) -> Option<Mechanism> {
        let own = [
            Key::FlyweightFriction,
            Key::PivotRadius,
            Key::ArmLength,
            Key::MassDistance,
            Key::MassAngle,
            Key::RampStart,
            Key::RampPlaces,
            Key::RampRadii,
        ];
        self.only(by, &[common, &own].concat());
        let ramp = self.curve(by, Key::RampPlaces, Key::RampRadii);
        let [pivot, arm, mass, start] =
            [Key::PivotRadius, Key::ArmLength, Key::MassDistance, Key::RampStart].map(|key| self.need(by, key));
        Some(Mechanism::RollerArm(RollerArm {
            pivot_radius: pivot?,
            arm_length: arm?,
            mass_distance: mass?,
            mass_angle: self.value(Key::MassAngle, 0.0),
            ramp: ramp?,
            ramp_start: start?,
            friction_angle: self.value(Key::FlyweightFriction, 0.0),
        }))
    }

    fn cam(&mut self, by: Key, common: &[Key]) -> Option<Mechanism> {
        let own = [
            Key::FlyweightFriction,
            Key::PivotRadius,
            Key::RollerRadius,
            Key::RollerStart,
            Key::MassDistance,
            Key::MassAngle,
            Key::PitchDistances,
            Key::PitchAngles,
        ];
        self.only(by, &[common, &own].concat());
        let pitch_curve = self.curve(by, Key::PitchDistances, Key::PitchAngles);
        let [pivot, roller, start, mass] =
            [Key::PivotRadius, Key::RollerRadius, Key::RollerStart, Key::MassDistance].map(|key| self.need(by, key));
        Some(Mechanism::CamArm(CamArm {
            pivot_radius: pivot?,
            roller_radius: roller?,
            start: start?,
            mass_distance: mass?,
            mass_angle: self.value(Key::MassAngle, 0.0),
            pitch_curve: pitch_curve?,
            friction_angle: self.value(Key::FlyweightFriction, 0.0),
        }))
    }

    fn servo(&mut self) -> Option<PrimaryActuator> {
        self.only(Key::Flyweights, &[Key::PrimaryServoForce, Key::PrimaryServoPosition]);
        match (self.case.quantity(Key::PrimaryServoForce), self.case.quantity(Key::PrimaryServoPosition)) {
            (Some(force), None) => Some(PrimaryActuator::Force(force)),
            (None, Some(position)) => Some(PrimaryActuator::Position(position)),
            (Some(_), Some(_)) => {
                let reason = "a servo holds a force or a position";
                let error = self.case.conflict(Key::PrimaryServoForce, Key::PrimaryServoPosition, reason);
                self.errors.push(error);
                None
            }
            (None, None) => {
                self.missing(Key::Flyweights, Key::PrimaryServoForce);
                None
            }
        }
    }

    /// A spring from rate, preload, free, installed and solid length; no spring if none of its keys is given.
    fn spring(&mut self, keys: [Key; 5]) -> Option<Option<Spring>> {
        let [rate, preload, free, installed, solid] = keys;
        let Some(first) = keys.into_iter().find(|key| self.case.has(*key)) else { return Some(None) };
        if self.case.has(preload) && self.case.has(free) {
            let error = self.case.conflict(preload, free, "the preload follows from the free and the installed length");
            self.errors.push(error);
            return None;
        }
        let secondary = rate == Key::SecondarySpringRate;
        let found = if secondary { Some(self.value(rate, 0.0)) } else { self.need(first, rate) };
        let made = if self.case.has(free) {
            let (free_length, length) = (self.value(free, 0.0), self.need(free, installed));
            let solid = self.case.quantity(solid);
            let made = Spring::from_lengths(free_length, found?, length?, solid);
            self.sound(free, made)?
        } else {
            let held = if secondary { Some(self.value(preload, 0.0)) } else { self.need(first, preload) };
            let lengths = match (self.case.quantity(installed), self.case.quantity(solid)) {
                (Some(length), Some(solid)) => Some((length, solid)),
                (None, Some(_)) => {
                    self.missing(solid, installed);
                    None
                }
                _ => None,
            };
            Spring { preload: held?, rate: found?, lengths }
        };
        Some(Some(made))
    }

    fn angle_from(&self) -> AngleFrom {
        match self.case.choice(Key::HelixAngleFrom).and_then(HelixAngleFrom::from_name) {
            Some(HelixAngleFrom::Axis) => AngleFrom::Axis,
            Some(HelixAngleFrom::Rotation) | None => AngleFrom::Rotation,
        }
    }

    fn secondary(&mut self) -> Option<SecondaryActuator> {
        let by = Key::SecondaryActuator;
        let Some(kind) = self.case.choice(by).and_then(SecondaryKind::from_name) else {
            let given = self.case.keys().find(|key| key.entry().section().starts_with("secondary"));
            self.missing(given.unwrap_or(Key::Flyweights), by);
            return None;
        };
        match kind {
            SecondaryKind::Servo => {
                self.only(by, &[Key::SecondaryServoForce]);
                self.need(by, Key::SecondaryServoForce).map(SecondaryActuator::Force)
            }
            SecondaryKind::Helix => {
                let own = [
                    Key::HelixRadius,
                    Key::HelixAngle,
                    Key::HelixOpenings,
                    Key::HelixAngles,
                    Key::HelixAngleFrom,
                    Key::HelixFriction,
                    Key::TorqueShare,
                ];
                self.only(by, &own);
                let helix = self.helix(by);
                let spring = self.spring([
                    Key::SecondarySpringRate,
                    Key::SecondarySpringPreload,
                    Key::SecondarySpringFree,
                    Key::SecondarySpringInstalled,
                    Key::SecondarySpringSolid,
                ]);
                Some(SecondaryActuator::Helix { helix: helix?, spring: spring? })
            }
        }
    }

    fn helix(&mut self, by: Key) -> Option<Helix> {
        let radius = self.need(by, Key::HelixRadius);
        let from = self.angle_from();
        let made = match (self.case.quantity(Key::HelixAngle), self.case.has(Key::HelixAngles)) {
            (Some(_), true) => {
                let error =
                    self.case.conflict(Key::HelixAngle, Key::HelixAngles, "a helix has one angle or a list of them");
                self.errors.push(error);
                return None;
            }
            (Some(_), false) if self.case.has(Key::HelixOpenings) => {
                let reason = "openings belong to a list of angles, and a helix of one angle has none";
                let error = self.case.conflict(Key::HelixAngle, Key::HelixOpenings, reason);
                self.errors.push(error);
                return None;
            }
            (Some(angle), false) => {
                let made = Helix::constant(radius?, from.from_rotation(angle));
                self.sound(Key::HelixAngle, made)
            }
            (None, true) => {
                let angles = self.curve(Key::HelixAngles, Key::HelixOpenings, Key::HelixAngles)?;
                let values = angles.values().iter().map(|angle| from.from_rotation(*angle)).collect();
                let made = Profile::new(angles.places().to_vec(), values).map_err(ActuatorError::from);
                let angles = self.sound(Key::HelixAngles, made)?;
                let made = Helix::varying(radius?, &angles);
                self.sound(Key::HelixAngles, made)
            }
            (None, false) => {
                self.missing(by, Key::HelixAngle);
                None
            }
        };
        let mut helix = made?;
        helix.torsion_rate = self.value(Key::TorsionRate, 0.0);
        helix.pretension = self.value(Key::Pretension, 0.0);
        helix.friction_angle = self.value(Key::HelixFriction, 0.0);
        helix.torque_share = self.value(Key::TorqueShare, 0.5);
        Some(helix)
    }

    /// Whether the parts work over the whole travel: each force exists where the sheave may stand.
    fn try_out(&mut self, actuation: &Actuation) {
        let (length, center) = (self.case.value(Key::BeltLength), self.case.value(Key::CenterDistance));
        let half_angle = self.case.value(Key::HalfAngle);
        let (key, full) = match (&actuation.primary, actuation.primary_travel) {
            (PrimaryActuator::Position(held), Some(full)) if *held > full => {
                let (held, full) = (1e3 * held, 1e3 * full);
                let reason =
                    format!("a motor cannot hold the sheave {held:.1} mm closed where it stops at {full:.1} mm");
                return self.wrong(Key::PrimaryServoPosition, reason);
            }
            (_, Some(full)) => (Key::PrimaryTravel, full),
            (PrimaryActuator::Position(held), None) => (Key::PrimaryServoPosition, *held),
            (PrimaryActuator::Flyweights { .. } | PrimaryActuator::Force(_), None) => return,
        };
        let closed = actuation.start_radius + full / travel_by_radius(half_angle);
        let open = (closed < center).then(|| radius_beside(closed, length, center).ok()).flatten();
        for at in 0..TRIED {
            let share = at as f64 / (TRIED - 1) as f64;
            if let PrimaryActuator::Flyweights { flyweights, spring } = &actuation.primary {
                for shift in [Shift::Closing, Shift::Opening] {
                    if let Err(error) = flyweights.force(TRIED_SPEED, share * full, shift) {
                        return self.wrong(Key::Flyweights, error);
                    }
                }
                if let Some(Err(error)) = spring.map(|spring| spring.force(share * full)) {
                    return self.wrong(Key::PrimarySpringSolid, error);
                }
            }
            let Some(open) = open else { continue };
            let opening = share * travel(half_angle, open, actuation.closed_radius);
            if let SecondaryActuator::Helix { helix, spring } = &actuation.secondary {
                for shift in [Shift::Closing, Shift::Opening] {
                    match helix.force(0.0, opening, shift) {
                        Ok(_) => {}
                        Err(error @ ActuatorError::HelixLocks { .. }) => return self.wrong(Key::HelixFriction, error),
                        Err(error) => return self.wrong(Key::SecondaryActuator, error),
                    }
                }
                if let Some(Err(error)) = spring.map(|spring| spring.force(opening)) {
                    return self.wrong(Key::SecondarySpringSolid, error);
                }
            }
        }
        if open.is_none() {
            let reason = format!(
                "at the end of its travel the belt would lie at a radius of {:.1} mm on the primary, where a belt of \
                 {:.1} mm fits no other pulley {:.1} mm away",
                1e3 * closed,
                1e3 * length,
                1e3 * center
            );
            self.wrong(key, reason);
        }
    }

    fn engine(&mut self) -> Option<Engine> {
        let by = self.case.keys().find(|key| key.entry().section() == "engine").unwrap_or(Key::EngineSpeeds);
        let torque = self.curve(by, Key::EngineSpeeds, Key::EngineTorques);
        let governor = match (self.case.quantity(Key::GovernedSpeed), self.case.quantity(Key::NoLoadSpeed)) {
            (None, None) => None,
            (Some(_), None) => {
                self.missing(Key::GovernedSpeed, Key::NoLoadSpeed);
                return None;
            }
            (None, Some(_)) => {
                self.missing(Key::NoLoadSpeed, Key::GovernedSpeed);
                return None;
            }
            (Some(governed), Some(no_load)) if no_load <= governed => {
                let (low, high) = (self.case.written(Key::NoLoadSpeed), self.case.written(Key::GovernedSpeed));
                self.wrong(Key::NoLoadSpeed, format!("{low} is not above `engine.governed_speed` = {high}"));
                return None;
            }
            (Some(governed), Some(no_load)) => {
                let at = torque.as_ref().map(|torque| torque.at(governed).value);
                if let Some(at) = at.filter(|at| *at <= 0.0) {
                    let reason = format!(
                        "the engine has {at:.2} N·m at {}: a governor takes away a torque that drives",
                        self.case.written(Key::GovernedSpeed)
                    );
                    self.wrong(Key::GovernedSpeed, reason);
                    return None;
                }
                Some(Governor { governed, no_load })
            }
        };
        Some(Engine { torque: torque?, throttle: self.value(Key::Throttle, 1.0), governor })
    }

    fn vehicle(&mut self) -> Option<Vehicle> {
        let by = self.case.keys().find(|key| key.entry().section() == "vehicle").unwrap_or(Key::VehicleMass);
        let [mass, ratio, wheel] = [Key::VehicleMass, Key::FinalRatio, Key::WheelRadius].map(|key| self.need(by, key));
        Some(Vehicle {
            mass: mass?,
            final_ratio: ratio?,
            wheel_radius: wheel?,
            rolling_resistance: self.value(Key::RollingResistance, 0.0),
            drag_area: self.value(Key::DragArea, 0.0),
            grade: self.value(Key::Grade, 0.0),
            air_density: self.value(Key::AirDensity, AIR),
            final_efficiency: self.value(Key::FinalEfficiency, 1.0),
        })
    }
}
