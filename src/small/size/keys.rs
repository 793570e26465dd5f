//! The one table of the keys: reading, ranges, messages, help and the inputs of a result come from it.

use super::error::{Problem, SizeError};
use super::{BeltDrive, Idler};
use crate::case::{Range, RangeEnd};
use crate::quantity::{Dimension, Unit};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// What is known of a key; `T` is what it is a key of.
#[derive(Debug)]
pub struct Entry<T: 'static> {
    /// Name with its section: `linear.mass`.
    pub path: &'static str,
    /// Symbol of the source.
    pub symbol: &'static str,
    /// What it means, in one line.
    pub doc: &'static str,
    /// Unit in which people read it, and its dimension.
    pub unit: Unit,
    /// Allowed values, in that unit.
    pub range: Range,
    /// A value that could be written, in that unit.
    pub example: f64,
    /// Where it goes.
    pub(super) field: fn(&mut T) -> &mut f64,
}

const INERTIA: Dimension = Dimension::new(2, 1, 0, 0);
const KG: Unit = Unit::decimal("kg", 0, Dimension::MASS);
const MM: Unit = Unit::decimal("mm", -3, Dimension::LENGTH);
const N: Unit = Unit::decimal("N", 0, Dimension::FORCE);
const NM: Unit = Unit::decimal("N*m", 0, Dimension::TORQUE);
const KG_M2: Unit = Unit::decimal("kg*m^2", 0, INERTIA);
const RAD_PER_S2: Unit = Unit::decimal("rad/s^2", 0, Dimension::new(0, 0, -2, 1));

const ANY: Range = Range { low: RangeEnd::None, high: RangeEnd::None };
const FROM_ZERO: Range = Range { low: RangeEnd::Closed(0.0), high: RangeEnd::None };

/// The keys of a drive.
#[rustfmt::skip]
pub static TABLE: [Entry<BeltDrive>; 11] = [
    Entry { path: "belt.mass", symbol: "M", doc: "mass of the belt", unit: KG, range: FROM_ZERO, example: 0.4,
        field: |drive| &mut drive.belt_mass },
    Entry { path: "linear.mass", symbol: "M", doc: "mass that the belt moves in a straight line", unit: KG,
        range: FROM_ZERO, example: 50.0, field: |drive| &mut drive.linear_mass },
    Entry { path: "linear.force", symbol: "F", doc: "external force on the belt, against its motion", unit: N,
        range: ANY, example: 120.0, field: |drive| &mut drive.force },
    Entry { path: "linear.friction_force", symbol: "F_f", doc: "friction force on what moves in a straight \
        line", unit: N,
        range: FROM_ZERO, example: 20.0, field: |drive| &mut drive.friction_force },
    Entry { path: "input.diameter", symbol: "D_in", doc: "diameter of the input pulley; must be given", unit: MM,
        range: Range::POSITIVE, example: 100.0, field: |drive| &mut drive.input_diameter },
    Entry { path: "input.inertia", symbol: "I_p1", doc: "inertia of the input pulley", unit: KG_M2,
        range: FROM_ZERO, example: 2e-3, field: |drive| &mut drive.input_inertia },
    Entry { path: "output.diameter", symbol: "D_out", doc: "diameter of the output pulley; the input's if not given",
        unit: MM, range: Range::POSITIVE, example: 250.0, field: |drive| &mut drive.output_diameter },
    Entry { path: "output.inertia", symbol: "I_p2", doc: "inertia of the output pulley itself", unit: KG_M2,
        range: FROM_ZERO, example: 2e-2, field: |drive| &mut drive.output_inertia },
    Entry { path: "output.load_inertia", symbol: "I_RL", doc: "inertia of the rotary load on the output pulley",
        unit: KG_M2, range: FROM_ZERO, example: 0.5, field: |drive| &mut drive.load_inertia },
    Entry { path: "output.load_torque", symbol: "T_out", doc: "torque that the application takes from the output \
        pulley",
        unit: NM, range: ANY, example: 40.0, field: |drive| &mut drive.load_torque },
    Entry { path: "motion.acceleration", symbol: "α", doc: "angular acceleration of the input pulley", unit: RAD_PER_S2,
        range: ANY, example: 30.0, field: |drive| &mut drive.acceleration },
];

/// The keys of an idler: one table `[[idler]]` for each.
#[rustfmt::skip]
pub static IDLER: [Entry<Idler>; 2] = [
    Entry { path: "idler.inertia", symbol: "I", doc: "inertia of an \
        idler", unit: KG_M2, range: FROM_ZERO, example: 3e-4,
        field: |idler| &mut idler.inertia },
    Entry { path: "idler.diameter", symbol: "D", doc: "diameter of an idler", unit: MM, range: Range::POSITIVE,
        example: 60.0, field: |idler| &mut idler.diameter },
];

impl<T> Entry<T> {
    /// Section of the file.
    pub fn section(&self) -> &'static str {
        self.path.split_once('.').map_or("", |(section, _)| section)
    }

    /// Name within its section.
    pub fn name(&self) -> &'static str {
        self.path.split_once('.').map_or(self.path, |(_, name)| name)
    }

    /// What is expected as a value, in words.
    pub fn expected(&self) -> String {
        let (unit, example) = (self.unit.symbol, self.example);
        let range = match (self.range.low, self.range.high) {
            (RangeEnd::None, RangeEnd::None) => String::new(),
            _ => format!(" {}", self.range.words(unit)),
        };
        let dimension = match self.unit.scale.dimension {
            INERTIA => "a moment of inertia".into(),
            dimension => dimension.to_string(),
        };
        format!("{dimension}{range}, such as \"{example} {unit}\"")
    }

    pub(super) fn allows(&self, si: f64) -> bool {
        si.is_finite() && self.range.contains(si, |bound| self.unit.to_si(bound))
    }
}

fn check_table<T: Clone>(table: &[Entry<T>], of: &T) -> Result<(), SizeError> {
    let mut of = of.clone();
    for entry in table {
        let value = *(entry.field)(&mut of);
        if !entry.allows(value) {
            let (path, given, expected) = (entry.path, format!("{value} in SI units"), entry.expected());
            return Err(SizeError::new(Problem::OutOfRange { path, given, expected }, None));
        }
    }
    Ok(())
}

/// Checks all quantities of a drive against their ranges.
pub(super) fn check(drive: &BeltDrive) -> Result<(), SizeError> {
    check_table(&TABLE, drive)?;
    drive.idlers.iter().try_for_each(|idler| check_table(&IDLER, idler))
}

impl Serialize for BeltDrive {
    /// Sections and keys as in the file, SI.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for section in TABLE.chunk_by(|a, b| a.section() == b.section()) {
            if let [first, ..] = section {
                map.serialize_entry(first.section(), &Section(self, section))?;
            }
        }
        map.serialize_entry("idler", &self.idlers)?;
        map.end()
    }
}

struct Section<'a>(&'a BeltDrive, &'a [Entry<BeltDrive>]);

impl Serialize for Section<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut drive = self.0.clone();
        serializer.collect_map(self.1.iter().map(|entry| (entry.name(), *(entry.field)(&mut drive))))
    }
}
