//! The formats of logs: which columns a file has, and what they mean.

use super::CHANNELS;
use crate::bench::cells;
use crate::quantity::Dimension;
use crate::text::quoted;
use serde::Serialize;

/// What is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Speed of the primary, rpm.
    Primary,
    /// Speed of the secondary, rpm.
    Secondary,
    /// Torque, N·m.
    Torque,
}

impl Channel {
    /// All channels, in the order in which samples carry them.
    pub const ALL: [Self; CHANNELS] = [Self::Primary, Self::Secondary, Self::Torque];
}

/// A column that is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Its place in a row, from 0.
    pub place: usize,
    /// What it measures.
    pub channel: Channel,
    /// The values that can have been measured, both ends included, as the file has them.
    pub range: (f64, f64),
    /// Whether the values are raw ones of an analogue-to-digital converter.
    pub raw: bool,
    /// What a value is multiplied by to be in the unit of its channel.
    pub factor: f64,
}

/// How a file is to be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Format {
    /// Seconds per tick of the first column.
    pub tick: f64,
    /// Columns that are read.
    pub columns: Vec<Column>,
    /// Whether a cell may be empty: the channel has no sample at that time.
    pub sparse: bool,
    /// Whether the first line is a header.
    pub header: bool,
    /// How many columns a row has; cells behind them are empty.
    pub width: usize,
    /// Columns whose unit, as the header has it, is not the one in which they are read, and columns of torque that are
    /// not read; with their channel.
    pub units: Vec<(Channel, String)>,
}

/// Speeds that a sensor can have measured, rpm.
const SPEEDS: (f64, f64) = (0.0, 20_000.0);
/// Torques that a sensor can have measured, N·m.
const TORQUES: (f64, f64) = (-1000.0, 1000.0);
/// What a converter of 16 bits gives off its rails.
const CONVERTER: (f64, f64) = (1.0, 65_534.0);

/// The name of a file without an ending, in small letters or capitals.
pub(super) fn without<'a>(name: &'a str, ending: &str) -> Option<&'a str> {
    let (stem, end) = name.split_at_checked(name.len().checked_sub(ending.len())?)?;
    end.eq_ignore_ascii_case(ending).then_some(stem)
}

/// The kind and the number of a file of one channel: `P_12.csv`, `ADC_0.csv.gz`.
pub fn step_file(name: &str) -> Option<(StepChannel, u64)> {
    let stem = without(without(name, ".gz").unwrap_or(name), ".csv")?;
    let (kind, number) = stem.rsplit_once('_')?;
    let kind = match kind {
        "P" => StepChannel::Primary,
        "S" => StepChannel::Secondary,
        "ADC" => StepChannel::Converter,
        "TORQUE" => StepChannel::Torque,
        _ => return None,
    };
    number.parse().ok().filter(|_| number.bytes().all(|byte| byte.is_ascii_digit())).map(|number| (kind, number))
}

/// What a file of one channel has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum StepChannel {
    /// Speed of the primary.
    Primary,
    /// Speed of the secondary.
    Secondary,
    /// Raw values of the converter.
    Converter,
    /// Torque.
    Torque,
}

impl StepChannel {
    /// How such a file is read: time in µs, value.
    pub fn format(self) -> Format {
        let (channel, range, raw) = match self {
            Self::Primary => (Channel::Primary, SPEEDS, false),
            Self::Secondary => (Channel::Secondary, SPEEDS, false),
            Self::Converter => (Channel::Torque, CONVERTER, true),
            Self::Torque => (Channel::Torque, TORQUES, false),
        };
        let columns = vec![Column { place: 1, channel, range, raw, factor: 1.0 }];
        Format { tick: 1e-6, columns, sparse: false, header: false, width: 2, units: Vec::new() }
    }
}

/// Names of columns that are read from a log with a header.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Names {
    /// Speed of the primary, or of the engine.
    pub primary: Option<String>,
    /// Speed of the secondary, or of a shaft behind it.
    pub secondary: Option<String>,
    /// Torque.
    pub torque: Option<String>,
}

/// Names that need not be given, for each channel.
const KNOWN: [&[&str]; CHANNELS] = [
    &["primary_rpm", "primary", "engine_rpm"],
    &["secondary_rpm", "secondary"],
    &["torque", "torque_nm", "secondary_torque", "secondary_torque_nm", "adc"],
];

/// How a file with this first line is read.
///
/// # Errors
/// What the header lacks, and what it has.
pub fn by_header(line: &[u8], names: &Names) -> Result<Format, String> {
    header(line, names, false)
}

/// As [`by_header`]; with a calibration, the column that is named for the torque has raw values.
pub(super) fn header(line: &[u8], names: &Names, calibrated: bool) -> Result<Format, String> {
    if let Some(fault) = cells::encoding_fault(line) {
        return Err(fault.to_owned());
    }
    let text = std::str::from_utf8(line).map_err(|_| "the first line is no text".to_owned())?;
    let cells: Vec<Cell> = cells::split(text.trim_start_matches('\u{feff}')).map(Cell::read).collect();
    let rich = cells.iter().any(|cell| cell.range.is_some());
    let tick = match cells.first() {
        Some(cell) if rich && cell.unit == "ms" => 1e-3,
        Some(cell) if !rich => match cell.name.as_str() {
            "timestamp_ms" | "time_ms" => 1e-3,
            "timestamp_us" | "time_us" => 1e-6,
            "timestamp_s" | "time_s" => 1.0,
            other => {
                let names: Vec<&str> = cells.iter().map(|cell| cell.name.as_str()).collect();
                if let Some(fault) = cells::separator_fault(&names) {
                    return Err(fault.to_owned());
                }
                let other = quoted(other);
                return Err(format!("the first column is `{other}`: expected a time such as `timestamp_ms`"));
            }
        },
        _ => return Err("the first column is no time in ms".into()),
    };
    let mut columns = Vec::new();
    let asked = [&names.primary, &names.secondary, &names.torque];
    for ((channel, asked), known) in Channel::ALL.into_iter().zip(asked).zip(KNOWN) {
        let named = |name: &str| cells.iter().position(|cell| cell.name.eq_ignore_ascii_case(name));
        let without_unit = |name: &str| cells.iter().position(|cell| cell.without_unit().eq_ignore_ascii_case(name));
        let place = match asked {
            Some(name) => Some(named(name).or_else(|| without_unit(name)).ok_or_else(|| {
                let all: Vec<&str> = cells.iter().map(|cell| cell.name.as_str()).collect();
                format!("there is no column `{name}`: the header has {}", all.join(", "))
            })?),
            None => {
                known.iter().find_map(|name| named(name)).or_else(|| known.iter().find_map(|name| without_unit(name)))
            }
        };
        let Some(place) = place else { continue };
        let raw = channel == Channel::Torque
            && (calibrated && asked.is_some()
                || cells.get(place).is_some_and(|cell| cell.without_unit().eq_ignore_ascii_case("adc")));
        let cell = cells.get(place);
        let factor =
            cell.and_then(Cell::unit).filter(|_| !raw).and_then(|unit| conversion(channel, unit)).unwrap_or(1.0);
        let usual = match channel {
            Channel::Primary | Channel::Secondary => SPEEDS,
            Channel::Torque if raw => CONVERTER,
            Channel::Torque => TORQUES,
        };
        let usual = (usual.0 / factor, usual.1 / factor);
        let range = cell.and_then(|cell| cell.range).unwrap_or(usual);
        columns.push(Column { place, channel, range, raw, factor });
    }
    if columns.is_empty() {
        let all: Vec<&str> = cells.iter().map(|cell| cell.name.as_str()).collect();
        return Err(format!(
            "none of its columns is known ({}); say which are the speeds with --primary and --secondary",
            all.join(", ")
        ));
    }
    if let Some(twice) = columns
        .iter()
        .enumerate()
        .find_map(|(at, column)| columns.get(at + 1..)?.iter().find(|other| other.place == column.place))
    {
        let name = cells.get(twice.place).map_or("", |cell| cell.name.as_str());
        return Err(format!("the column `{}` is asked for twice: expected one for each quantity", quoted(name)));
    }
    let other = |column: &Column| {
        let cell = cells.get(column.place)?;
        let (unit, read) = (cell.unit()?, if column.channel == Channel::Torque { "N·m" } else { "rpm" });
        let unlike = !column.raw && conversion(column.channel, unit).is_none();
        let name = quoted(&cell.name);
        unlike.then(|| (column.channel, format!("`{name}` is in {} by its header and is read as {read}", quoted(unit))))
    };
    let mut units: Vec<(Channel, String)> = columns.iter().filter_map(other).collect();
    if columns.iter().all(|column| column.channel != Channel::Torque) {
        let torque = cells.iter().find(|cell| cell.name.to_ascii_lowercase().contains("torque"));
        let words =
            |cell: &Cell| format!("`{}` is not read as a torque, which is named with --torque", quoted(&cell.name));
        units.extend(torque.map(|cell| (Channel::Torque, words(cell))));
    }
    Ok(Format { tick, columns, sparse: rich, header: true, width: cells.len(), units })
}

/// One cell of a header: a name, or as RaceCapture writes them `"RPM2"|"rpm"|0|8000|50`: name, unit, smallest and
/// largest value, samples per second.
struct Cell {
    name: String,
    unit: String,
    range: Option<(f64, f64)>,
}

/// What values in a unit are multiplied by to be in that of the channel: torque in any unit of torque is converted,
/// speeds are those in rpm alone, for what another one is the speed of is told by a factor. `None` for other units.
fn conversion(channel: Channel, unit: &str) -> Option<f64> {
    let plain: String = unit.to_lowercase().chars().filter(|c| !" *.·⋅-".contains(*c)).collect();
    match channel {
        Channel::Primary | Channel::Secondary => {
            let same = ["rpm", "1/min", "/min", "r/min", "rev/min", "u/min", "min^1", "min1"];
            same.contains(&plain.as_str()).then_some(1.0)
        }
        Channel::Torque if plain == "nm" => Some(1.0),
        Channel::Torque => {
            cells::unit(unit).filter(|quantity| quantity.dimension == Dimension::TORQUE).map(|quantity| quantity.si)
        }
    }
}

impl Cell {
    /// The unit that the header has: of its own, or in parentheses or brackets behind the name.
    fn unit(&self) -> Option<&str> {
        let inside = |open: char, close: char| self.name.rsplit_once(open)?.1.strip_suffix(close);
        let own = Some(self.unit.as_str()).filter(|unit| !unit.is_empty());
        own.or_else(|| inside('(', ')').or_else(|| inside('[', ']'))).map(str::trim).filter(|unit| !unit.is_empty())
    }

    /// The name without what stands in parentheses or brackets behind it.
    fn without_unit(&self) -> &str {
        let before = |open: char, close: char| Some(self.name.strip_suffix(close)?.rsplit_once(open)?.0.trim_end());
        before('(', ')').or_else(|| before('[', ']')).unwrap_or(&self.name)
    }

    fn read(text: &str) -> Self {
        let mut parts = text.split('|').map(|part| cells::text(part).into_owned());
        let name = parts.next().unwrap_or_default();
        let unit = parts.next().unwrap_or_default();
        let mut number = || parts.next().and_then(|part| part.parse::<f64>().ok()).filter(|value| value.is_finite());
        let range = number().zip(number());
        Self { name, unit, range }
    }
}
