//! From what was written to a case in which everything is decided, in SI.

use super::error::{CaseError, CaseProblem};
use super::geometry::{NoRadii, radii_of_ratio, radius_beside};
use super::given::{Case, SWAP};
use super::keys::Key;
use super::losses::{Losses, losses};
use super::operating::OperatingPoint;
use super::parts::{Parts, parts};
use super::setting::Setting;
use super::swap::GivenSwap;
use super::thermal::{Stiffnesses, Thermal, thermal};
use crate::model::{Bending, Edition, Ends, Free, Friction, ModelChoices, Shear, Spans};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// A case with everything decided, in SI units. Serialises to the `inputs` of a result: sections and keys as in the
/// case file. A case that is not solved yet can be read as a case again; radii that are solved for are left out. In the
/// `inputs` of a result what was found stands beside what it was found for; without it, the same can be asked again.
#[derive(Debug, Clone, PartialEq)]
pub struct Resolved {
    /// The edition that was asked for.
    pub edition: Edition,
    /// What it stands for, finer choices applied.
    pub model: ModelChoices,
    /// The belt.
    pub belt: BeltProperties,
    /// The sheaves, of both pulleys.
    pub sheave: Sheave,
    /// The drive.
    pub drive: Drive,
    /// The operating point.
    pub operating_point: OperatingPoint,
    /// Losses besides friction.
    pub losses: Losses,
    /// The belt's stiffnesses over its temperature, as far as they were given so.
    pub stiffnesses: Stiffnesses,
    /// Heat, if the belt's temperature is to be found.
    pub thermal: Option<Thermal>,
    /// Actuators, engine and vehicle, as far as the case has them.
    pub parts: Parts,
    /// Constants that are found for outputs that are prescribed.
    pub swaps: Vec<GivenSwap>,
    /// What was found, SI, for keys that were solved for; nothing before a case is solved.
    pub found: Vec<(Key, f64)>,
}

/// The belt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltProperties {
    /// L_belt, unstretched length, m.
    pub length: f64,
    /// m_o, mass per length, unstretched, kg/m.
    pub mass_per_length: f64,
    /// EA, N.
    pub longitudinal_stiffness: f64,
    /// EI, N·m², at the reference temperature where it is given over the temperature.
    pub bending_stiffness: f64,
    /// k, N/m², as the bending stiffness.
    pub radial_stiffness: f64,
}

/// The sheaves, of both pulleys.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheave {
    /// β, half the angle of the groove, rad.
    pub half_angle: f64,
    /// μ_k.
    pub friction_coefficient: f64,
    /// v_thr, m/s.
    pub slip_threshold: f64,
}

/// The drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// L_c, m.
    pub center_distance: f64,
    /// R_P, m; where the search starts if it is free.
    pub primary_radius: f64,
    /// R_S, m; where the search starts if it is free.
    pub secondary_radius: f64,
    /// The radii that are solved for.
    pub free: Option<Free>,
}

impl Case {
    /// Decides everything: the base case's values for keys that were not given, the edition's choices, the radii.
    ///
    /// # Errors
    /// What holds between several keys and does not here: [`CaseProblem::Conflict`], [`CaseProblem::Missing`],
    /// [`CaseProblem::Overlap`], [`CaseProblem::NoRadii`].
    pub fn resolve(&self) -> Result<Resolved, CaseError> {
        let edition = self.choice(Key::Edition).and_then(Edition::from_name).unwrap_or(Edition::Consistent);
        let drive = self.drive()?;
        let stiffnesses = Stiffnesses::of(self)?;
        Ok(Resolved {
            edition,
            model: self.model(edition)?,
            belt: BeltProperties {
                length: self.value(Key::BeltLength),
                mass_per_length: self.value(Key::MassPerLength),
                longitudinal_stiffness: self.value(Key::LongitudinalStiffness),
                bending_stiffness: stiffnesses.bending_at_reference(self.value(Key::BendingStiffness)),
                radial_stiffness: stiffnesses.radial_at_reference(self.value(Key::RadialStiffness)),
            },
            sheave: Sheave {
                half_angle: self.value(Key::HalfAngle),
                friction_coefficient: self.value(Key::FrictionCoefficient),
                slip_threshold: self.value(Key::SlipThreshold),
            },
            drive,
            operating_point: OperatingPoint::resolve(self, drive.free)?,
            losses: losses(self, edition)?,
            stiffnesses,
            thermal: thermal(self)?,
            parts: parts(self)?,
            swaps: self.swaps.iter().map(|(swap, _)| swap.clone()).collect(),
            found: Vec::new(),
        })
    }

    fn model(&self, edition: Edition) -> Result<ModelChoices, CaseError> {
        let mut model = edition.model();
        model.friction = self.choice(Key::Friction).and_then(Friction::from_name).unwrap_or(model.friction);
        model.bending = match model.bending {
            Some(bending) => Some(self.bending(bending)?),
            None => {
                let unused = [Key::Shear, Key::Ends, Key::Spans].into_iter().find(|key| self.has(*key));
                if let Some(key) = unused {
                    return Err(self.conflict(Key::Edition, key, "a string does not bend, and carries no shear"));
                }
                None
            }
        };
        Ok(model)
    }

    fn bending(&self, edition: Bending) -> Result<Bending, CaseError> {
        let bending = Bending {
            shear: self.choice(Key::Shear).and_then(Shear::from_name).unwrap_or(edition.shear),
            ends: self.choice(Key::Ends).and_then(Ends::from_name).unwrap_or(edition.ends),
            spans: self.choice(Key::Spans).and_then(Spans::from_name).unwrap_or(edition.spans),
        };
        match (bending.shear, bending.ends) {
            (Shear::Full, Ends::AsPrinted) if self.has(Key::Ends) => {
                Err(self.missing(Key::Ends, "the printed end conditions need `model.shear` = \"linearised\""))
            }
            (Shear::Full, Ends::AsPrinted) => Err(self.missing(
                Key::Shear,
                "the edition's end conditions as printed are for linearised shear; give `model.ends` too",
            )),
            _ => Ok(bending),
        }
    }

    fn drive(&self) -> Result<Drive, CaseError> {
        let free = self.choice(Key::Free).and_then(Free::from_name);
        for radius in [Key::PrimaryRadius, Key::SecondaryRadius] {
            if self.has(Key::Ratio) && self.has(radius) {
                return Err(self.conflict(radius, Key::Ratio, "the ratio alone determines both radii"));
            }
            if self.has(radius) && is_free(free, radius) {
                return Err(self.conflict(radius, Key::Free, "a radius that is free is solved for"));
            }
        }
        if self.has(Key::Ratio) && free == Some(Free::Both) {
            return Err(self.conflict(Key::Ratio, Key::Free, "with both radii free, their ratio is solved for"));
        }
        let center_distance = self.value(Key::CenterDistance);
        let (primary_radius, secondary_radius) = self.radii(center_distance, free)?;
        if primary_radius + secondary_radius >= center_distance {
            let (primary, secondary) = (primary_radius, secondary_radius);
            let places = self.places([Key::PrimaryRadius, Key::SecondaryRadius, Key::CenterDistance]);
            return Err(CaseError::new(CaseProblem::Overlap { primary, secondary, center_distance }, places));
        }
        Ok(Drive { center_distance, primary_radius, secondary_radius, free })
    }

    /// Whether the radii are those of a whole drive, which its parts determine: nobody gave any, and what the base case
    /// has in their place need not fit.
    fn finds_its_radii(&self) -> bool {
        let radii = [Key::PrimaryRadius, Key::SecondaryRadius].into_iter().any(|key| self.has(key));
        !radii && self.has(Key::Flyweights) && self.has(Key::SecondaryActuator)
    }

    /// R_P and R_S: as given, or from (6.12) with the belt's length as pitch length.
    fn radii(&self, center_distance: f64, free: Option<Free>) -> Result<(f64, f64), CaseError> {
        let (primary, secondary) = (self.value(Key::PrimaryRadius), self.value(Key::SecondaryRadius));
        let length = self.value(Key::BeltLength);
        let fails = |key: Key| {
            move |reason: NoRadii| {
                let given = self.written(key);
                let places = self.places([key, Key::BeltLength, Key::CenterDistance]);
                CaseError::new(CaseProblem::NoRadii { key, given, length, center_distance, reason }, places)
            }
        };
        let beside = |key, fixed: f64| {
            let room = fixed < center_distance; // else the pulleys overlap whatever the other radius is
            if room { radius_beside(fixed, length, center_distance).map_err(fails(key)) } else { Ok(0.0) }
        };
        match (self.quantity(Key::Ratio), free) {
            (Some(ratio), _) => radii_of_ratio(ratio, length, center_distance).map_err(fails(Key::Ratio)),
            (None, None) if primary + secondary >= center_distance && self.finds_its_radii() => {
                radii_of_ratio(1.0, length, center_distance).map_err(fails(Key::BeltLength))
            }
            (None, None) => Ok((primary, secondary)),
            (None, Some(Free::PrimaryRadius)) => Ok((beside(Key::Free, secondary)?, secondary)),
            (None, Some(Free::SecondaryRadius)) => Ok((primary, beside(Key::Free, primary)?)),
            (None, Some(Free::Both)) => radii_of_ratio(1.0, length, center_distance).map_err(fails(Key::Free)),
        }
    }
}

/// Whether a radius is solved for.
fn is_free(free: Option<Free>, radius: Key) -> bool {
    match free {
        None => false,
        Some(Free::Both) => true,
        Some(Free::PrimaryRadius) => radius == Key::PrimaryRadius,
        Some(Free::SecondaryRadius) => radius == Key::SecondaryRadius,
    }
}

impl Resolved {
    /// Every key with its value, in the order of the table; given to [`Case::set`], they make the same case again.
    pub fn settings(&self) -> Vec<(Key, Setting)> {
        let Self { edition, model, belt, sheave, drive, operating_point, losses, stiffnesses, thermal, parts, .. } =
            self;
        let mut settings = vec![(Key::Edition, Setting::Name(edition.name()))];
        if let Some(bending) = model.bending {
            settings.push((Key::Shear, Setting::Name(bending.shear.name())));
            settings.push((Key::Ends, Setting::Name(bending.ends.name())));
            settings.push((Key::Spans, Setting::Name(bending.spans.name())));
        }
        settings.push((Key::Friction, Setting::Name(model.friction.name())));
        let given = [
            (Key::BeltLength, belt.length),
            (Key::MassPerLength, belt.mass_per_length),
            (Key::LongitudinalStiffness, belt.longitudinal_stiffness),
            (Key::BendingStiffness, belt.bending_stiffness),
            (Key::RadialStiffness, belt.radial_stiffness),
            (Key::HalfAngle, sheave.half_angle),
            (Key::FrictionCoefficient, sheave.friction_coefficient),
            (Key::SlipThreshold, sheave.slip_threshold),
            (Key::CenterDistance, drive.center_distance),
            (Key::PrimaryRadius, drive.primary_radius),
            (Key::SecondaryRadius, drive.secondary_radius),
        ];
        let numbers = given.into_iter().filter(|(key, _)| !is_free(drive.free, *key)).chain(operating_point.settings());
        settings.extend(numbers.map(|(key, value)| (key, Setting::Number(value))));
        settings.extend(losses.settings());
        for (key, grid) in stiffnesses.tables() {
            settings.retain(|(other, _)| *other != key);
            settings.push((key, Setting::Table(grid.clone())));
        }
        match thermal {
            Some(thermal) => settings.extend(thermal.settings(stiffnesses)),
            // Without a balance of heat, tables are read at the reference temperature.
            None if stiffnesses.tables().chain(losses.tables()).next().is_some()
                || Key::ReferenceTemperature.entry().base() != Some(stiffnesses.reference) =>
            {
                settings.push((Key::ReferenceTemperature, Setting::Number(stiffnesses.reference)));
            }
            None => {}
        }
        settings.extend(parts.settings());
        settings.extend(drive.free.map(|free| (Key::Free, Setting::Name(free.name()))));
        settings.sort_by_key(|(key, _)| *key);
        settings
    }
}

impl Serialize for Resolved {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut settings = self.settings();
        settings.retain(|(key, _)| !self.found.iter().any(|(found, _)| found == key));
        settings.extend(self.found.iter().map(|(key, value)| (*key, Setting::Number(*value))));
        settings.sort_by_key(|(key, _)| *key);
        let mut map = serializer.serialize_map(None)?;
        if !self.swaps.is_empty() {
            map.serialize_entry(SWAP, &self.swaps.iter().map(GivenSwap::to_string).collect::<Vec<_>>())?;
        }
        serialize_within(&mut map, 0, &settings)?;
        map.end()
    }
}

/// Settings as entries of a map, nested by the names of their paths from the one numbered `depth` on.
fn serialize_within<M: SerializeMap>(map: &mut M, depth: usize, settings: &[(Key, Setting)]) -> Result<(), M::Error> {
    let name = |key: Key| key.path().split('.').nth(depth).unwrap_or_default();
    for part in settings.chunk_by(|(a, _), (b, _)| name(*a) == name(*b)) {
        let Some((key, value)) = part.first() else { continue };
        if key.path().split('.').count() == depth + 1 {
            map.serialize_entry(name(*key), value)?;
        } else {
            map.serialize_entry(name(*key), &Section { depth: depth + 1, settings: part })?;
        }
    }
    Ok(())
}

/// The settings of one section.
struct Section<'a> {
    depth: usize,
    settings: &'a [(Key, Setting)],
}

impl Serialize for Section<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        serialize_within(&mut map, self.depth, self.settings)?;
        map.end()
    }
}
