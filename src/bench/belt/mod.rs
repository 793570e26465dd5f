//! Properties of a belt from bench tests, as the thesis's chapter 4 has them: what a case's `[belt]` needs, with every
//! value on the way.
//!
//! ```
//! use sheave::bench::belt::Description;
//! let text = "[tension]\nforce = \"500 N\"\nelongation = \"0.05 mm\"\nlength = \"100 mm\"\n\
//!             [bending]\nmoment = \"0.1 N*m\"\nradius = \"1.8 m\"\n\
//!             [lateral]\nslope = \"1.8 kN/mm\"\nsample_length = \"50 mm\"\nhalf_angle = \"13 deg\"\n\
//!             [length]\npitch_length = \"900 mm\"\nmass = \"0.4 kg\"";
//! let properties = Description::parse("belt.toml", text)?.evaluate(None)?;
//! assert!((properties.belt.longitudinal_stiffness - 1e6).abs() < 1e-3); // 500 N · 100 mm/0.05 mm
//! assert!((properties.belt.bending_stiffness - 0.18).abs() < 1e-12); // 0.1 N·m · 1.8 m
//! # Ok::<(), sheave::bench::BenchError>(())
//! ```

mod keys;
mod rubber;
mod section;
mod show;
mod table;

pub use keys::TABLE;
pub use rubber::{AtTemperature, Rubber, Test};
pub use section::Section;
pub use table::{Columns, parse as parse_columns};

use super::error::BenchError;
use super::sheet::Sheet;
use super::statistics::Line;
use crate::quantity::{Dimension, celsius};
use serde::Serialize;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

/// Standard gravity, m/s² (3rd CGPM, 1901).
const GRAVITY: f64 = 9.806_65;
/// Coefficient of determination below which a line is a poor description of its data.
pub(in crate::bench) const POOR_FIT: f64 = 0.98;

/// A description of a belt's tests.
#[derive(Debug, Clone)]
pub struct Description {
    sheet: Sheet,
    /// Where files it names are looked for.
    folder: PathBuf,
}

/// The belt as a case has it, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BeltTable {
    /// L_p, m.
    pub length: f64,
    /// m_o, kg/m.
    pub mass_per_length: f64,
    /// EA, N.
    pub longitudinal_stiffness: f64,
    /// EI, N·m².
    pub bending_stiffness: f64,
    /// k, N/m².
    pub radial_stiffness: f64,
    /// Length around the section, m; `None` where the section is not known.
    pub perimeter: Option<f64>,
    /// tan δ = G''/G' of the rubber; `None` where it was not measured at this temperature.
    pub loss_tangent: Option<f64>,
}

/// All that follows from a description, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Properties {
    /// What the belt is called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// K; `None` where nothing depends on it.
    pub temperature: Option<f64>,
    /// The table for a case.
    pub belt: BeltTable,
    /// The rubber at that temperature.
    pub rubber: Option<AtTemperature>,
    /// Tests of the rubber.
    pub rubber_tests: Vec<Test>,
    /// Share by which E, and with it EI and k, falls per kelvin from the coldest test of the rubber to the warmest,
    /// 1/K; `None` where it was tested at one temperature, or not at all.
    pub softening: Option<f64>,
    /// The yarns.
    pub yarns: Option<Yarns>,
    /// The tension test.
    pub tension: Tension,
    /// The bending test.
    pub bending: Bending,
    /// The equivalent section.
    pub section: Option<Section>,
    /// The test of the lateral stiffness.
    pub lateral: Lateral,
    /// Length and mass.
    pub length: Length,
    /// What a reader should know.
    #[serde(skip)]
    pub warnings: Vec<String>,
    /// Corners of the real section, m.
    #[serde(skip)]
    pub outline: Vec<(f64, f64)>,
}

/// The yarns (section 4.2), SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Yarns {
    /// Across the belt.
    pub count: f64,
    /// Of one, kg/m.
    pub linear_density: f64,
    /// EA over linear density, m²/s².
    pub specific_modulus: f64,
    /// EA of one, N.
    pub one: f64,
    /// EA of all, N.
    pub all: f64,
}

/// The tension test (section 4.3), SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Tension {
    /// Whether rubber alone was tested, and the yarns' stiffness comes on top.
    pub of_rubber: bool,
    /// ε = ΔL/L; `None` where a stiffness was given.
    pub strain: Option<f64>,
    /// EA = F L/ΔL (4.5) at the test's temperature, N.
    pub as_tested: f64,
    /// The same at the belt's temperature, N.
    pub stiffness: f64,
    /// The line through raw data, N over m.
    pub line: Option<Line>,
}

/// The bending test (section 4.4), SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Bending {
    /// E of the rubber at the test's temperature, Pa.
    pub youngs_modulus: Option<f64>,
    /// I = M ρ/E about the neutral axis of the rubber alone (4.6), m⁴.
    pub second_moment: Option<f64>,
    /// EI, N·m².
    pub stiffness: f64,
}

/// The lateral test (section 4.5), SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Lateral {
    /// m, N/m.
    pub slope: f64,
    /// The line through raw data, N over m.
    pub line: Option<Line>,
    /// k = 4 m tan(β)/L_S with the wedges' β (4.11), N/m².
    pub as_tested: f64,
    /// β of the sheaves, rad.
    pub sheave_half_angle: f64,
    /// The same for the sheaves' β, N/m².
    pub at_sheave_angle: f64,
    /// E at the belt's over E at the test's temperature.
    pub modulus_ratio: f64,
    /// k, N/m².
    pub stiffness: f64,
}

/// Length and mass (section 4.6), SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Length {
    /// m; `None` where the pitch length was given.
    pub outside_circumference: Option<f64>,
    /// L_p, m.
    pub pitch_length: f64,
    /// kg.
    pub mass: f64,
}

impl Description {
    /// Reads a description; files it names are looked for beside it.
    ///
    /// # Errors
    /// What is wrong with the file: see [`super::BenchProblem`].
    pub fn read(path: &Path) -> Result<Self, BenchError> {
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
        Ok(Self { sheet: Sheet::read(path, &TABLE)?, folder })
    }

    /// Reads the text of a description; `name` is shown in errors.
    ///
    /// # Errors
    /// As [`Description::read`].
    pub fn parse(name: &str, text: &str) -> Result<Self, BenchError> {
        Ok(Self { sheet: Sheet::parse(name, text, &TABLE)?, folder: PathBuf::new() })
    }

    /// All numbers that were given, SI, by their keys.
    pub fn inputs(&self) -> BTreeMap<&str, f64> {
        self.sheet.inputs()
    }

    /// Computes the belt at a temperature in K, the description's own if none is given.
    ///
    /// # Errors
    /// Tests that are missing, contradict each other, or give no belt.
    pub fn evaluate(&self, temperature: Option<f64>) -> Result<Properties, BenchError> {
        let sheet = &self.sheet;
        let mut warnings = Vec::new();
        let rubber = Rubber::read(sheet, &mut warnings)?;
        let temperature = self.temperature(temperature, rubber.as_ref())?;
        let state = match (&rubber, temperature) {
            (Some(rubber), Some(temperature)) => Some(rubber.at(sheet, temperature)?),
            _ => None,
        };
        if let (Some(state), Some(rubber)) = (&state, &rubber)
            && state.storage_over_loss.is_none()
            && rubber.tests.iter().any(|test| test.storage_over_loss.is_some())
        {
            warnings.push(format!(
                "no loss tangent is known at {:.1} °C, for the loss modulus was not measured there or on both sides: a \
                 case has that of the thesis's rubber",
                celsius(state.temperature)
            ));
        }
        let thermal = Thermal { sheet, rubber: rubber.as_ref(), state };
        let yarns = yarns(sheet)?;
        let tension = self.tension(&thermal, yarns.is_some(), &mut warnings)?;
        let (bending, section) = bending(&thermal, &mut warnings)?;
        let lateral = self.lateral(&thermal, &mut warnings)?;
        let length = length(sheet)?;
        let belt = BeltTable {
            length: length.pitch_length,
            mass_per_length: length.mass / length.pitch_length,
            longitudinal_stiffness: tension.stiffness + yarns.map_or(0.0, |yarns| yarns.all),
            bending_stiffness: bending.stiffness,
            radial_stiffness: lateral.stiffness,
            perimeter: section.map(|section| section.perimeter()),
            loss_tangent: state.and_then(|state| state.storage_over_loss).map(|ratio| 1.0 / ratio),
        };
        let properties = Properties {
            name: sheet.text("name").map(str::to_owned),
            temperature,
            belt,
            rubber: state,
            softening: rubber.as_ref().and_then(Rubber::softening),
            rubber_tests: rubber.map_or_else(Vec::new, |rubber| rubber.tests),
            yarns,
            tension,
            bending,
            section,
            lateral,
            length,
            warnings,
            outline: sheet.outline("section.outline").to_vec(),
        };
        self.check(&properties)?;
        Ok(properties)
    }

    fn temperature(&self, asked: Option<f64>, rubber: Option<&Rubber>) -> Result<Option<f64>, BenchError> {
        let own = self.sheet.get("temperature");
        match (asked.or(own), rubber) {
            (Some(temperature), Some(_)) => Ok(Some(temperature)),
            (Some(_), None) => {
                let reason = "nothing says how this belt's properties depend on temperature";
                let error = self.sheet.unusable("temperature", reason);
                Err(error
                    .advise("give moduli of the rubber at several temperatures in [[rubber.test]], or no temperature"))
            }
            (None, Some(rubber)) => match rubber.tests.as_slice() {
                [only] => Ok(Some(only.temperature)),
                _ => Err(self.sheet.missing("temperature").advise("or give --temperature on the command line")),
            },
            (None, None) => Ok(None),
        }
    }

    /// A line through raw data of a section, load over displacement.
    fn line(&self, section: &str, warnings: &mut Vec<String>) -> Result<Option<Line>, BenchError> {
        let key = format!("{section}.csv");
        let Some(file) = self.sheet.text(&key) else { return Ok(None) };
        let path = self.folder.join(file);
        let columns = table::read(&path, [Dimension::LENGTH, Dimension::FORCE])?;
        if let Some((count, line)) = columns.bad {
            warnings.push(format!("{file}: {count} rows could not be read, the first of them line {line}"));
        }
        let (from, to) = (self.sheet.get(&format!("{section}.from")), self.sheet.get(&format!("{section}.to")));
        let within = |load: f64| from.is_none_or(|from| load >= from) && to.is_none_or(|to| load <= to);
        let points: Vec<(f64, f64)> = columns.rows.into_iter().filter(|(_, load)| within(*load)).collect();
        let line = Line::fit(file, &points)?;
        if line.slope <= 0.0 {
            return Err(self
                .sheet
                .unusable(&key, "the load falls as the displacement grows; are the columns the right way round?"));
        }
        if line.r_squared < POOR_FIT {
            warnings.push(format!("{file}: the line describes the data poorly, R² = {:.4}", line.r_squared));
        }
        Ok(Some(line))
    }

    fn tension(
        &self,
        thermal: &Thermal<'_>,
        of_rubber: bool,
        warnings: &mut Vec<String>,
    ) -> Result<Tension, BenchError> {
        let sheet = &self.sheet;
        let length = sheet.need("tension.length")?;
        if sheet.text("tension.csv").is_some() || sheet.get("tension.stiffness").is_some() {
            let way = if sheet.text("tension.csv").is_some() { "a table" } else { "the stiffness" };
            for key in ["tension.force", "tension.elongation"] {
                if sheet.get(key).is_some() {
                    return Err(sheet.unusable(key, format!("{way} of the same test is given, too: leave one out")));
                }
            }
        }
        let line = self.line("tension", warnings)?;
        let (strain, as_tested) = match (line, sheet.get("tension.stiffness")) {
            (Some(_), Some(_)) => {
                return Err(
                    sheet.unusable("tension.stiffness", "a table of the same test is given, too: leave one out")
                );
            }
            (Some(line), None) => (None, line.slope * length),
            (None, Some(stiffness)) => (None, stiffness * length),
            (None, None) => {
                let strain = sheet.need("tension.elongation")? / length;
                (Some(strain), sheet.need("tension.force")? / strain)
            }
        };
        // A belt with its cords stretches as they do, and they hardly feel its temperature (section 4.2).
        if !of_rubber && sheet.get("tension.temperature").is_some() {
            let reason = "without [yarns] the belt was stretched with its cords, which hardly feel its temperature: \
                leave it out";
            return Err(sheet.unusable("tension.temperature", reason));
        }
        let ratio = if of_rubber { thermal.ratio("tension")? } else { 1.0 };
        Ok(Tension { of_rubber, strain, as_tested, stiffness: as_tested * ratio, line })
    }

    fn lateral(&self, thermal: &Thermal<'_>, warnings: &mut Vec<String>) -> Result<Lateral, BenchError> {
        let sheet = &self.sheet;
        let (from, to) = (sheet.get("lateral.from"), sheet.get("lateral.to"));
        for (key, bound) in [("lateral.from", from), ("lateral.to", to)] {
            if bound.is_some() && sheet.text("lateral.csv").is_none() {
                let reason = "it chooses rows of a table, and lateral.csv is not given: leave it out";
                return Err(sheet.unusable(key, reason));
            }
        }
        if let (Some(from), Some(to)) = (from, to)
            && from >= to
        {
            let reason = format!("the smallest load, {from} N, is not below the largest, lateral.to = {to} N");
            return Err(sheet.unusable("lateral.from", reason));
        }
        let line = self.line("lateral", warnings)?;
        let slope = match (line, sheet.get("lateral.slope")) {
            (Some(_), Some(_)) => {
                return Err(sheet.unusable("lateral.slope", "a table of the same test is given, too: leave one out"));
            }
            (Some(line), None) => line.slope,
            (None, _) => sheet.need("lateral.slope")?,
        };
        let wedges = sheet.need("lateral.half_angle")?;
        let sheave_half_angle = sheet.get("lateral.sheave_half_angle").unwrap_or(wedges);
        // (4.8) to (4.11): x = D_L/(2 tan β), k = 2 p_z/x, p_z = F/L_S.
        let radial = |half_angle: f64| 4.0 * slope * half_angle.tan();
        let sample = sheet.need("lateral.sample_length")?;
        let at_sheave_angle = radial(sheave_half_angle) / sample;
        let modulus_ratio = thermal.ratio("lateral")?;
        Ok(Lateral {
            slope,
            line,
            as_tested: radial(wedges) / sample,
            sheave_half_angle,
            at_sheave_angle,
            modulus_ratio,
            stiffness: at_sheave_angle * modulus_ratio,
        })
    }

    /// The tables must be such as a case takes.
    fn check(&self, properties: &Properties) -> Result<(), BenchError> {
        let case = crate::case::Case::from_toml("belt", &properties.tables());
        case.map(|_| ()).map_err(|error| {
            let reason = format!("these tests give a belt that no case takes: {error}");
            self.sheet.unusable("belt", reason).advise("check the units of what was measured")
        })
    }
}

/// What depends on temperature.
struct Thermal<'a> {
    sheet: &'a Sheet,
    rubber: Option<&'a Rubber>,
    state: Option<AtTemperature>,
}

impl Thermal<'_> {
    /// The rubber as a section's test had it; `None` for a belt whose rubber was not tested.
    fn at_test(&self, section: &str) -> Result<Option<AtTemperature>, BenchError> {
        let key = format!("{section}.temperature");
        match self.rubber {
            Some(rubber) => rubber.at(self.sheet, self.sheet.need(&key)?).map(Some),
            None => match self.sheet.get(&key) {
                Some(_) => Err(self.sheet.unusable(&key, "nothing says how the rubber depends on temperature")),
                None => Ok(None),
            },
        }
    }

    /// Young's modulus in use over that in a section's test.
    fn ratio(&self, section: &str) -> Result<f64, BenchError> {
        match (self.at_test(section)?, self.state) {
            (Some(test), Some(state)) => Ok(state.youngs_modulus / test.youngs_modulus),
            _ => Ok(1.0),
        }
    }
}

fn yarns(sheet: &Sheet) -> Result<Option<Yarns>, BenchError> {
    if !sheet.has("yarns") {
        return Ok(None);
    }
    let count = sheet.need("yarns.count")?;
    if count.fract() != 0.0 {
        return Err(sheet.unusable("yarns.count", "a belt has a whole number of yarns"));
    }
    let linear_density = sheet.need("yarns.linear_density")?;
    let modulus = sheet.need("yarns.specific_modulus")?;
    // Grams per denier are a length; gravity makes a force of the grams.
    let gravity = sheet.get("yarns.gravity");
    let specific_modulus = match (sheet.dimension("yarns.specific_modulus"), gravity) {
        (Some(Dimension::LENGTH), gravity) => modulus * gravity.unwrap_or(GRAVITY),
        (_, None) => modulus,
        (_, Some(_)) => {
            return Err(sheet.unusable("yarns.gravity", "the specific modulus is a force already: gravity has no use"));
        }
    };
    let one = specific_modulus * linear_density;
    Ok(Some(Yarns { count, linear_density, specific_modulus, one, all: count * one }))
}

fn bending(thermal: &Thermal<'_>, warnings: &mut Vec<String>) -> Result<(Bending, Option<Section>), BenchError> {
    let sheet = thermal.sheet;
    if let Some(stiffness) = sheet.get("bending.angular_stiffness") {
        let moment = sheet.get("bending.moment").or_else(|| sheet.get("bending.radius"));
        if sheet.has("section") || moment.is_some() {
            let reason = "the stiffness between nodes is the whole belt's: leave out [section], moment and radius";
            return Err(sheet.unusable("bending.angular_stiffness", reason));
        }
        let stiffness = stiffness * sheet.need("bending.length")? * thermal.ratio("bending")?;
        return Ok((Bending { youngs_modulus: None, second_moment: None, stiffness }, None));
    }
    if sheet.get("bending.length").is_some() {
        let reason =
            "it belongs to bending.angular_stiffness, and moment and radius are expected without it: leave it out";
        return Err(sheet.unusable("bending.length", reason));
    }
    let product = sheet.need("bending.moment")? * sheet.need("bending.radius")?; // EI of what was tested (4.6)
    if !sheet.has("section") {
        let ratio = thermal.ratio("bending")?;
        return Ok((Bending { youngs_modulus: None, second_moment: None, stiffness: product * ratio }, None));
    }
    let (Some(test), Some(state)) = (thermal.at_test("bending")?, thermal.state) else {
        return Err(sheet
            .unusable("section", "without a test of the rubber its second moment of area is not known")
            .advise("add [[rubber.test]], or leave out [section] if the belt was bent with its cords"));
    };
    let second_moment = product / test.youngs_modulus;
    let (width, depth) = (sheet.need("section.width")?, sheet.need("section.cord_depth")?);
    let section = Section::equivalent(width, depth, sheet.need("section.half_angle")?, second_moment)?;
    if section.above_cords < 0.0 {
        warnings.push("the equivalent section's neutral axis lies outside the cords: most of the rubber does".into());
    }
    let stiffness = state.youngs_modulus * section.about_cords;
    Ok((
        Bending { youngs_modulus: Some(test.youngs_modulus), second_moment: Some(second_moment), stiffness },
        Some(section),
    ))
}

fn length(sheet: &Sheet) -> Result<Length, BenchError> {
    let mass = sheet.need("length.mass")?;
    let outside = sheet.get("length.outside_circumference");
    let pitch_length = match (sheet.get("length.pitch_length"), outside) {
        (Some(_), Some(_)) => {
            return Err(sheet.unusable("length.pitch_length", "the outside circumference is given, too: leave one out"));
        }
        (Some(_), None) if sheet.get("length.cord_depth").is_some() => {
            let reason = "it makes a pitch length of the outside circumference, and length.pitch_length is given: \
                leave one out";
            return Err(sheet.unusable("length.cord_depth", reason));
        }
        (Some(pitch), None) => pitch,
        (None, _) => {
            let depth = sheet.get("length.cord_depth").or(sheet.get("section.cord_depth"));
            let depth = depth.ok_or_else(|| sheet.missing("length.cord_depth"))?;
            let outside = outside.ok_or_else(|| sheet.missing("length.outside_circumference"))?;
            // Laid out as a circle, the cords run on a circle of a radius smaller by their depth (section 4.6).
            let pitch = outside - 2.0 * PI * depth;
            if pitch <= 0.0 {
                let reason = "the cords lie deeper than the belt laid out as a circle is wide";
                return Err(sheet.unusable("length.outside_circumference", reason));
            }
            pitch
        }
    };
    Ok(Length { outside_circumference: outside, pitch_length, mass })
}

impl Properties {
    /// The temperature in words.
    pub(super) fn at(&self) -> String {
        self.temperature.map_or_else(String::new, |kelvin| format!(" at {:.1} °C", celsius(kelvin)))
    }
}
