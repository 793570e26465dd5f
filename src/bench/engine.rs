//! The engine's curve: torque and power over speed, from a table.

use super::cells;
use super::error::{BenchError, BenchProblem};
use crate::quantity::{Dimension, Unit, rpm};
use crate::text::quoted;
use serde::Serialize;
use std::path::Path;

/// Mechanical horsepower, W.
const HORSEPOWER: f64 = Unit::HORSEPOWER.in_si();
/// Rows that a curve may have.
const ROWS: usize = 1_000_000;

/// Which quantity the table has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Tabulated {
    /// Power.
    Power,
    /// Torque.
    Torque,
}

/// A curve of full throttle, linear between its points in the quantity that is tabulated.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EngineCurve {
    /// What the second column is.
    pub tabulated: Tabulated,
    /// Speed in rad/s, and power in W or torque in N·m, in the order of speeds.
    pub points: Vec<(f64, f64)>,
    /// Whether the file says in which unit its second column is.
    pub named: bool,
}

impl EngineCurve {
    /// Reads rpm, and power or torque in the unit that the header names; without a header the second column is taken
    /// for hp, a column headed `power` for hp too and one headed `torque` for N·m.
    ///
    /// # Errors
    /// A file that cannot be read, a row that is not two numbers, a row with more cells than the header (two without
    /// one), two rows of one speed, fewer than two rows.
    pub fn read(path: &Path) -> Result<Self, BenchError> {
        let bytes = std::fs::read(path).map_err(|error| BenchError::read(path, &error))?;
        Self::parse(&path.display().to_string(), &bytes)
    }

    /// As [`EngineCurve::read`], from the bytes of a file.
    ///
    /// # Errors
    /// As [`EngineCurve::read`].
    pub fn parse(name: &str, bytes: &[u8]) -> Result<Self, BenchError> {
        cells::check_encoding(name, bytes)?;
        let mut second_column = Column::UNNAMED;
        let mut points: Vec<(f64, f64)> = Vec::new();
        let (mut width, mut headed) = (2, false);
        for (line, text) in (1_u64..).zip(bytes.split(|byte| *byte == b'\n')) {
            let bad = |reason: String| BenchError::from(BenchProblem::Line { path: name.into(), line, reason });
            let text = std::str::from_utf8(text).map_err(|_| bad("this is no text".into()))?;
            let text = text.trim_start_matches('\u{feff}').trim();
            if text.is_empty() || text.starts_with('#') {
                continue;
            }
            let cells = cells::texts(text);
            let cells: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
            let [first, second, ..] = cells.as_slice() else {
                return Err(bad("expected a speed in rpm and a power or torque, with a comma between".into()));
            };
            let filled = cells::filled(&cells).unwrap_or(0);
            let number = |cell: &str| cell.parse::<f64>().ok().filter(|value| value.is_finite());
            match (number(first), number(second)) {
                (Some(_), Some(_)) if filled > width => {
                    return Err(bad(format!(
                        "there are {filled} cells: expected {width}, a speed in rpm and a power or torque first, with \
                         points in decimal numbers, not commas"
                    )));
                }
                (Some(speed), Some(value)) if speed >= 0.0 && points.len() < ROWS => {
                    points.push((Unit::RPM.to_si(speed), value));
                }
                (None, None) if points.is_empty() && !headed => {
                    second_column = Column::of(second).ok_or_else(|| {
                        let second = quoted(second);
                        bad(format!(
                            "`{second}` is no unit of power or torque: expected one such as hp, kW, PS, N*m or lbf-ft"
                        ))
                    })?;
                    if let Some(other) = other_speed(first) {
                        return Err(bad(format!("`{}` is in {other}: expected a speed in rpm", quoted(first))));
                    }
                    (headed, width) = (true, cells.len());
                }
                _ => return Err(bad("expected two finite numbers, the first a speed in rpm".into())),
            }
        }
        let Column { tabulated, in_si, named } = second_column;
        points.iter_mut().for_each(|(_, value)| *value *= in_si);
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let same = points.windows(2).find(|pair| pair[0].0 == pair[1].0);
        match (points.len(), same) {
            (_, Some(pair)) => {
                let reason = format!("two rows have the speed {:.2} rpm", rpm(pair[0].0));
                Err(BenchProblem::Unusable { path: name.into(), reason }.into())
            }
            (0 | 1, None) => {
                let reason = "a curve needs at least two rows of speed and power or torque".into();
                Err(BenchProblem::NoData { path: name.into(), reason }.into())
            }
            (_, None) => Ok(Self { tabulated, points, named }),
        }
    }

    /// What its second column was taken for where the file does not say, as a warning.
    pub fn assumption(&self) -> Option<String> {
        let unit = match self.tabulated {
            Tabulated::Power => "hp",
            Tabulated::Torque => "N\u{b7}m",
        };
        (!self.named).then(|| format!("the engine's curve names no unit: its second column is taken for {unit}"))
    }

    /// Power in W at a speed in rad/s, and its slope in W·s/rad; `None` outside the table.
    pub fn power(&self, speed: f64) -> Option<(f64, f64)> {
        let above = self.points.iter().position(|(tabulated, _)| *tabulated >= speed)?;
        let (a, b) = match above.checked_sub(1) {
            Some(below) => (self.points.get(below)?, self.points.get(above)?),
            None if self.points.first()?.0 == speed => (self.points.first()?, self.points.get(1)?),
            None => return None,
        };
        let slope = (b.1 - a.1) / (b.0 - a.0);
        let value = a.1 + slope * (speed - a.0);
        Some(match self.tabulated {
            Tabulated::Power => (value, slope),
            Tabulated::Torque => (value * speed, value + slope * speed),
        })
    }

    /// The speeds of the table, rpm.
    pub fn range(&self) -> (f64, f64) {
        let speed = |point: Option<&(f64, f64)>| point.map_or(f64::NAN, |point| rpm(point.0));
        (speed(self.points.first()), speed(self.points.last()))
    }
}

/// What a header has in parentheses or brackets, or else behind its last underscore.
fn last_of(name: &str) -> &str {
    let inside = |open: char, close: char| name.rsplit_once(open)?.1.strip_suffix(close);
    let inside = inside('(', ')').or_else(|| inside('[', ']')).unwrap_or(name);
    inside.rsplit('_').next().unwrap_or(inside).trim()
}

/// The unit of a speed's header, if it is not rpm.
fn other_speed(name: &str) -> Option<&'static str> {
    let name = name.to_ascii_lowercase();
    let others = [("rad/s", "rad/s"), ("1/s", "1/s"), ("hz", "Hz"), ("rps", "rps"), ("deg/s", "deg/s")];
    others.into_iter().find(|(unit, _)| last_of(&name) == *unit).map(|(_, shown)| shown)
}

/// What the second column has.
struct Column {
    tabulated: Tabulated,
    /// Its unit in SI.
    in_si: f64,
    /// Whether its header names that.
    named: bool,
}

impl Column {
    /// Of a file without a header, or with one that says no more than that it is power.
    const UNNAMED: Self = Self { tabulated: Tabulated::Power, in_si: HORSEPOWER, named: false };

    /// By its header; nothing for what is neither power nor torque.
    fn of(header: &str) -> Option<Self> {
        let unit = last_of(header);
        match unit.to_ascii_lowercase().as_str() {
            "power" => return Some(Self::UNNAMED),
            "torque" => return Some(Self { tabulated: Tabulated::Torque, in_si: 1.0, named: false }),
            _ => {}
        }
        let quantity = cells::unit(unit)?;
        let tabulated = match quantity.dimension {
            Dimension::POWER => Tabulated::Power,
            Dimension::TORQUE => Tabulated::Torque,
            _ => return None,
        };
        Some(Self { tabulated, in_si: quantity.si, named: true })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn a_table_in_another_encoding_is_told_to_be_one() {
        let utf16: Vec<u8> = "\u{feff}rpm,hp\r\n1000,2\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
        let error = EngineCurve::parse("e", &utf16).unwrap_err().to_string();
        assert!(error.contains("`e`, line 1: it is written in UTF-16"), "{error}");
        let error = EngineCurve::parse("e", b"rpm,hp\r1000,2\r3000,4\r").unwrap_err().to_string();
        assert!(error.contains("carriage returns alone"), "{error}");
    }

    #[test]
    fn a_header_names_any_unit_of_power_or_torque_and_one_that_names_none_is_told() {
        let read = |header: &str| EngineCurve::parse("e", format!("{header}\n1000,10\n3000,20\n").as_bytes()).unwrap();
        for (header, tabulated, in_si) in [
            ("rpm,hp", Tabulated::Power, 745.699_871_582_270_2),
            ("rpm,HP", Tabulated::Power, 745.699_871_582_270_2),
            ("rpm,power (PS)", Tabulated::Power, 735.498_75),
            ("RPM,Power_KW", Tabulated::Power, 1e3),
            ("rpm,power [W]", Tabulated::Power, 1.0),
            ("rpm,torque_Nm", Tabulated::Torque, 1.0),
            ("rpm,n\u{b7}m", Tabulated::Torque, 1.0),
            ("rpm,Torque (lb-ft)", Tabulated::Torque, 1.355_817_948_331_400_4),
            ("rpm,TORQUE [LBF-FT]", Tabulated::Torque, 1.355_817_948_331_400_4),
            ("rpm,torque (lbf*in)", Tabulated::Torque, 0.112_984_829_027_616_7),
        ] {
            let curve = read(header);
            assert_eq!((curve.tabulated, curve.assumption()), (tabulated, None), "{header}");
            let (_, value) = curve.points[0];
            assert!((value / (10.0 * in_si) - 1.0).abs() < 1e-14, "{header}: {value}");
        }
        for (header, unit) in [("rpm,torque", "N\u{b7}m"), ("rpm,power", "hp"), ("speed_rpm,Power", "hp")] {
            let told = read(header).assumption().unwrap();
            assert!(told.ends_with(&format!("its second column is taken for {unit}")), "{header}: {told}");
        }
        assert!(EngineCurve::parse("e", b"1000,2\n3000,4\n").unwrap().assumption().is_some());
        for wrong in ["rpm,mm", "rpm,1", "rpm,%", "rpm,throttle", "rpm,pressure (bar)"] {
            assert!(EngineCurve::parse("e", format!("{wrong}\n1,2\n3,4\n").as_bytes()).is_err(), "{wrong}");
        }
    }

    #[test]
    fn both_kinds_of_tables_are_read() {
        let power = EngineCurve::parse("e", b"1000,2\n3000,4\n").unwrap();
        let (value, slope) = power.power(2000.0 * TAU / 60.0).unwrap();
        assert!((value - 3.0 * HORSEPOWER).abs() < 1e-9 && (slope - HORSEPOWER * 60.0 / (1000.0 * TAU)).abs() < 1e-9);
        let torque = EngineCurve::parse("e", "rpm,N\u{b7}m\r\n1000,10\r\n3000,20\r\n".as_bytes()).unwrap();
        let speed = 2000.0 * TAU / 60.0;
        let (value, slope) = torque.power(speed).unwrap();
        assert!((value - 15.0 * speed).abs() < 1e-9);
        let step = 1e-4;
        let difference = (torque.power(speed + step).unwrap().0 - torque.power(speed - step).unwrap().0) / (2.0 * step);
        assert!((slope - difference).abs() < 1e-5, "{slope} {difference}");
        assert_eq!(torque.power(0.0), None);
        assert!(torque.power(3000.0 * TAU / 60.0).is_some() && torque.power(1000.0 * TAU / 60.0).is_some());
        for wrong in [
            "speed (rad/s),N*m\n100,2\n300,4\n",
            "",
            "1000,2",
            "1000,2\n1000,3\n",
            "1000,2\nx,3\n",
            "rpm,furlong\n1,2\n3,4\n",
            "1000\n",
        ] {
            assert!(EngineCurve::parse("e", wrong.as_bytes()).is_err(), "{wrong}");
        }
    }

    #[test]
    fn decimal_commas_are_refused_by_line() {
        for (text, words) in [
            ("rpm,hp\n1000,2\n3000,4,5\n", "`e`, line 3: there are 3 cells: expected 2"),
            ("1000,2,5\n3000,4,5\n", "`e`, line 1: there are 3 cells: expected 2"),
        ] {
            let error = EngineCurve::parse("e", text.as_bytes()).unwrap_err().to_string();
            assert!(error.contains(words), "{error}");
        }
        // A third column that the header has, and empty cells at the end.
        for text in ["rpm,hp,note\n1000,2,5\n3000,4,\n", "1000,2,\n3000,4,,\n"] {
            assert_eq!(EngineCurve::parse("e", text.as_bytes()).unwrap().points.len(), 2, "{text}");
        }
    }
}
