//! The keys of a case. All that is known of them stands in one table: parsing, defaults, ranges, messages, help and
//! documentation come from it.

mod table;

pub use table::TABLE;

use super::range::{Range, RangeEnd};
use crate::model::Choice;
use crate::quantity::Unit;
use crate::text::subscripted;
use std::borrow::Cow;

/// A key of the case file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "each key is documented by its entry in TABLE")]
pub enum Key {
    Edition,
    Shear,
    Ends,
    Spans,
    Friction,
    BeltLength,
    MassPerLength,
    LongitudinalStiffness,
    BendingStiffness,
    RadialStiffness,
    Perimeter,
    LossTangent,
    CordLossTangent,
    HalfAngle,
    FrictionCoefficient,
    SlipThreshold,
    CenterDistance,
    PrimaryRadius,
    SecondaryRadius,
    Ratio,
    Free,
    PrimarySpeed,
    SecondarySpeed,
    PrimaryTorque,
    SecondaryTorque,
    SpeedRatio,
    SlackTension,
    TightTension,
    PrimaryAxialForce,
    SecondaryAxialForce,
    SlipReserve,
    FrictionUtilization,
    Losses,
    PrimaryDrag,
    SecondaryDrag,
    PrimaryDragPerSpeed,
    SecondaryDragPerSpeed,
    GearEfficiency,
    Ambient,
    HeatTransfer,
    HeatTransferPerArea,
    FrictionShare,
    ReferenceTemperature,
    BendingSoftening,
    RadialSoftening,
    StartRadius,
    PrimaryTravel,
    Flyweights,
    FlyweightCount,
    FlyweightMass,
    FlyweightFriction,
    FlyweightLost,
    FlyweightTravels,
    FlyweightCoefficients,
    FlyweightRadii,
    PivotRadius,
    ArmLength,
    MassDistance,
    MassAngle,
    RampStart,
    RampPlaces,
    RampRadii,
    RollerRadius,
    RollerStart,
    PitchDistances,
    PitchAngles,
    PrimaryServoForce,
    PrimaryServoPosition,
    PrimarySpringRate,
    PrimarySpringPreload,
    PrimarySpringFree,
    PrimarySpringInstalled,
    PrimarySpringSolid,
    ClosedRadius,
    SecondaryTravel,
    SecondaryActuator,
    HelixRadius,
    HelixAngle,
    HelixOpenings,
    HelixAngles,
    HelixAngleFrom,
    HelixFriction,
    TorqueShare,
    SecondaryServoForce,
    SecondarySpringRate,
    SecondarySpringPreload,
    SecondarySpringFree,
    SecondarySpringInstalled,
    SecondarySpringSolid,
    TorsionRate,
    Pretension,
    EngineSpeeds,
    EngineTorques,
    Throttle,
    GovernedSpeed,
    NoLoadSpeed,
    VehicleMass,
    FinalRatio,
    WheelRadius,
    RollingResistance,
    DragArea,
    Grade,
    AirDensity,
    FinalEfficiency,
}

/// What is known of a key.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// The key.
    pub key: Key,
    /// Its name in the case file, with dots: `belt.length`.
    pub path: &'static str,
    /// Its symbol in the thesis; empty if it has none.
    pub symbol: &'static str,
    /// What it means, in one line.
    pub doc: &'static str,
    /// What values it takes.
    pub kind: ValueKind,
}

/// What values a key takes.
#[derive(Debug, Clone, Copy)]
pub enum ValueKind {
    /// A number with a unit.
    Quantity {
        /// Unit in which people read it, and its dimension.
        unit: Unit,
        /// Allowed values, in that unit.
        range: Range,
        /// A value that is typical, in that unit; the base case's (Table 6.1) where that has the key.
        example: f64,
        /// Whether the base case has the key, so that `example` applies when it is not given.
        base: bool,
    },
    /// Several numbers with one unit: a column of a table.
    List {
        /// Unit in which people read them, and their dimension.
        unit: Unit,
        /// Allowed values, in that unit.
        range: Range,
        /// A typical list, as it may be written.
        example: &'static str,
    },
    /// One of several names.
    Choice {
        /// The names.
        choices: &'static [Choice],
        /// The name that applies when none is given; `None` when that depends on other keys.
        default: Option<&'static str>,
    },
}

/// Letters of a name that must be there for it to count as cut short.
const SHORTEST_START: usize = 4;
/// No key is longer.
const LONGEST_KEY: usize = 50;

impl Key {
    /// What is known of the key.
    pub fn entry(self) -> &'static Entry {
        &TABLE[self as usize]
    }

    /// Its name in the case file, with dots.
    pub fn path(self) -> &'static str {
        self.entry().path
    }

    /// The key with this name.
    pub fn from_path(path: &str) -> Option<Self> {
        TABLE.iter().find(|entry| entry.path == path).map(|entry| entry.key)
    }

    /// The known key whose name looks most like `path`, if one does.
    pub fn nearest(path: &str) -> Option<Self> {
        // No slip of the pen is as long as that; the distance takes time with the length of both.
        if path.len() > 2 * LONGEST_KEY {
            return None;
        }
        let distance = |entry: &Entry| {
            let whole = strsim::damerau_levenshtein(entry.path, path);
            // A name without its section, or in the wrong one.
            let last = path.rsplit('.').next().unwrap_or(path);
            // A name cut short is near however much is missing.
            let cut = last.len() >= SHORTEST_START && entry.name().starts_with(last);
            let alone = if cut { 0 } else { strsim::damerau_levenshtein(entry.name(), last) };
            whole.min(alone + 1)
        };
        // Of names that are equally near, the one whose section is, too.
        let whole = |entry: &Entry| strsim::damerau_levenshtein(entry.path, path);
        let (distance, entry) =
            TABLE.iter().map(|entry| (distance(entry), entry)).min_by_key(|(d, entry)| (*d, whole(entry)))?;
        (distance <= 1 + entry.name().len() / 3).then_some(entry.key)
    }

    /// What is added to a message about a name that is no key: the key that may have been meant, or nothing.
    ///
    /// ```
    /// use sheave::case::Key;
    /// assert_eq!(Key::suggestion("belt.lenght"), "; did you mean `belt.length`?");
    /// ```
    pub fn suggestion(path: &str) -> String {
        Self::nearest(path).map_or_else(String::new, |key| format!("; did you mean `{}`?", key.path()))
    }
}

impl Entry {
    /// The section of the case file it stands in; empty at the top.
    pub fn section(&self) -> &'static str {
        self.path.rsplit_once('.').map_or("", |(section, _)| section)
    }

    /// Its name within its section.
    pub fn name(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |(_, name)| name)
    }

    /// The base case's value in SI, for a quantity that it has.
    pub fn base(&self) -> Option<f64> {
        match self.kind {
            ValueKind::Quantity { unit, example, base: true, .. } => Some(unit.to_si(example)),
            _ => None,
        }
    }

    /// Its symbol with every index as `_{..}`, as figures are labelled: `R_{S}/R_{P}`.
    pub fn marked_symbol(&self) -> String {
        subscripted(self.symbol)
    }

    /// A value in SI as people read it: the number, and its unit as it is printed.
    pub fn readable(&self, si: f64) -> (f64, String) {
        let number = match self.kind {
            ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. } => unit.from_si(si),
            ValueKind::Choice { .. } => si,
        };
        (number, self.printed_unit())
    }

    /// What a curve at a value in SI is called in a figure: `M_{in} = 18 N·m`.
    pub fn label_at(&self, si: f64) -> String {
        format!("{} = {}", self.marked_symbol(), self.rounded(si))
    }

    /// A value in SI as people read it, to six decimals, with its unit: `18 N·m`.
    pub fn rounded(&self, si: f64) -> String {
        let (number, unit) = self.readable(si);
        format!("{} {unit}", (number * 1e6).round() / 1e6).trim_end().to_owned()
    }

    /// What an axis of a figure is called: `slack tension T_{slack} (N)`.
    pub fn axis_label(&self) -> String {
        let unit = self.printed_unit();
        let unit = if unit.is_empty() { unit } else { format!(" ({unit})") };
        format!("{} {}{unit}", self.name().replace('_', " "), self.marked_symbol())
    }

    /// SI unit of its values, as files state it; `1` for a pure number or a name.
    pub fn si_unit(&self) -> Cow<'static, str> {
        match self.kind {
            ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. } => unit.scale.dimension.si_unit(),
            ValueKind::Choice { .. } => Cow::Borrowed("1"),
        }
    }

    fn printed_unit(&self) -> String {
        match self.kind {
            ValueKind::Quantity { unit, .. } | ValueKind::List { unit, .. } => unit.printed(),
            ValueKind::Choice { .. } => String::new(),
        }
    }

    /// A value that could be written in a case file.
    pub fn example(&self) -> String {
        match self.kind {
            ValueKind::Quantity { unit: Unit { symbol: "", .. }, example, .. } => example.to_string(),
            ValueKind::Quantity { unit, example, .. } => format!("\"{example} {}\"", unit.symbol),
            ValueKind::List { example, .. } => format!("\"{example}\""),
            ValueKind::Choice { choices, default } => {
                let name = default.or(choices.first().map(|choice| choice.name)).unwrap_or_default();
                format!("\"{name}\"")
            }
        }
    }

    /// What is expected as a value, in words.
    pub fn expected(&self) -> String {
        match self.kind {
            ValueKind::Quantity { unit, range, .. } => {
                let (words, example) = (range.words(unit.symbol), self.example());
                format!("{} {words}, such as {example}", unit.scale.dimension)
            }
            ValueKind::List { unit, range, .. } => {
                let words = match (range.low, range.high) {
                    (RangeEnd::None, RangeEnd::None) => String::new(),
                    _ => format!(", each {}", range.words(unit.symbol)),
                };
                format!("numbers with one unit{words}, such as {}", self.example())
            }
            ValueKind::Choice { choices, .. } => {
                let names: Vec<_> = choices.iter().map(|choice| format!("\"{}\"", choice.name)).collect();
                format!("one of {}", names.join(", "))
            }
        }
    }
}

/// The names of all sections, in the order of the table.
pub fn sections() -> impl Iterator<Item = &'static str> {
    let mut last = "";
    TABLE.iter().map(Entry::section).filter(move |section| std::mem::replace(&mut last, section) != *section)
}

/// Whether a name is that of a section, or of one that has sections within it.
///
/// ```
/// use sheave::case::is_section;
/// assert!(is_section("primary") && is_section("primary.actuator") && !is_section("primary.act"));
/// ```
pub fn is_section(name: &str) -> bool {
    let within =
        |section: &str| section.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
    !name.is_empty() && sections().any(within)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::parse;

    #[test]
    fn the_table_is_in_the_order_of_the_keys() {
        for (index, entry) in TABLE.iter().enumerate() {
            assert_eq!(entry.key as usize, index, "{}", entry.path);
            assert_eq!(Key::from_path(entry.path), Some(entry.key));
        }
        assert_eq!(
            sections().collect::<Vec<_>>(),
            [
                "model",
                "belt",
                "sheave",
                "drive",
                "operating_point",
                "losses",
                "thermal",
                "primary",
                "primary.actuator",
                "primary.spring",
                "secondary",
                "secondary.actuator",
                "secondary.spring",
                "engine",
                "vehicle"
            ]
        );
    }

    #[test]
    fn every_example_can_be_written_and_lies_in_its_range() {
        for entry in &TABLE {
            let example = entry.example();
            match entry.kind {
                ValueKind::Quantity { unit, range, example: value, .. } => {
                    let read = parse(example.trim_matches('"')).and_then(|read| read.expect(unit.scale.dimension));
                    assert_eq!(read, Ok(unit.to_si(value)), "{}", entry.path);
                    assert!(range.contains(unit.to_si(value), |bound| unit.to_si(bound)), "{}", entry.path);
                }
                ValueKind::List { unit, range, .. } => {
                    let read = crate::quantity::parse_list(example.trim_matches('"'), unit.scale.dimension);
                    for value in read.unwrap() {
                        assert!(range.contains(value, |bound| unit.to_si(bound)), "{}: {value}", entry.path);
                    }
                }
                ValueKind::Choice { choices, .. } => {
                    assert!(choices.iter().any(|choice| example.trim_matches('"') == choice.name), "{}", entry.path);
                }
            }
        }
    }

    #[test]
    fn figures_are_labelled_with_indices_below_the_line() {
        assert_eq!(Key::Ratio.entry().axis_label(), "ratio R_{S}/R_{P}");
        assert_eq!(Key::SlackTension.entry().axis_label(), "slack tension T_{slack} (N)");
        assert_eq!(Key::BendingStiffness.entry().label_at(0.14), "EI = 0.14 N·m²");
        assert_eq!(Key::PrimarySpeed.entry().label_at(std::f64::consts::TAU), "ω_{P} = 60 rpm");
        assert_eq!(Key::Edition.entry().marked_symbol(), "");
    }

    #[test]
    fn a_slip_of_the_pen_finds_its_key() {
        let nearest = |path| Key::nearest(path).map(Key::path);
        assert_eq!(nearest("belt.lenght"), Some("belt.length"));
        assert_eq!(nearest("slack_tension"), Some("operating_point.slack_tension"));
        assert_eq!(nearest("drive.slack_tension"), Some("operating_point.slack_tension"));
        assert_eq!(nearest("sheave.friction_coeff"), Some("sheave.friction_coefficient"));
        assert_eq!(nearest("editon"), Some("edition"));
        assert_eq!(nearest("colour"), None);
    }
}
