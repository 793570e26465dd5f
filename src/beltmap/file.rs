//! Maps as files: CSV and Parquet with one row a node, NetCDF with one array a quantity.
//!
//! Every file says what it is of, and how accurate: a line of JSON, which is the first line of CSV behind `# `, the
//! metadata `sheave_belt_map` of Parquet, the global attribute of the same name of NetCDF.

use super::axis::MapAxis;
use super::error::MapFileError;
use super::map::BeltMap;
use super::quantity::{Node, Quantity, Sample};
#[cfg(feature = "parquet")]
use super::record::ATTRIBUTE;
use super::record::{STATUS, cells, columns, slope_name};
use super::report::Report;
use crate::case::Key;
use crate::losses::LossOutput;
use crate::model::Output;
use crate::study::{Cell, Table, write_csv};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;

/// What the first line of a map as CSV begins with.
const MAGIC: &str = "# sheave belt map ";
/// Version of the format.
const VERSION: usize = 1;
/// Longest first line, and most nodes, that are read.
const LONGEST: u64 = 16 << 20;
const MOST: usize = 1 << 20;
/// Columns that follow from others, for those who read the table only.
const EFFICIENCY: &str = Output::EfficiencyOverall.name();
const WITH_LOSSES: &str = LossOutput::Efficiency.name();
const RESERVE: &str = "slip_reserve";

/// How a map is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MapFormat {
    /// Comma-separated values.
    Csv,
    /// Apache Parquet.
    #[cfg(feature = "parquet")]
    Parquet,
    /// NetCDF, classic format.
    #[cfg(feature = "netcdf")]
    NetCdf,
}

/// What a file says of its map.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Head {
    version: usize,
    program: String,
    axes: Vec<Named>,
    quantities: Vec<Named>,
    excluded_cells: Vec<usize>,
    report: Report,
    inputs: serde_json::Value,
}

/// A name and its unit.
#[derive(Debug, Serialize, Deserialize)]
struct Named {
    name: String,
    unit: String,
}

impl MapFormat {
    /// The format that a file's name asks for: .csv, .parquet or .nc.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "csv" => Some(Self::Csv),
            #[cfg(feature = "parquet")]
            "parquet" => Some(Self::Parquet),
            #[cfg(feature = "netcdf")]
            "nc" => Some(Self::NetCdf),
            _ => None,
        }
    }

    /// Writes a map.
    ///
    /// # Errors
    /// What the writer says.
    pub fn write(self, map: &BeltMap, to: &mut (dyn Write + Send + '_)) -> io::Result<()> {
        match self {
            Self::Csv => {
                writeln!(to, "{MAGIC}{}", map.head()?)?;
                write_csv(&map.table(), to)
            }
            #[cfg(feature = "parquet")]
            Self::Parquet => crate::study::write_parquet_with(&map.table(), &[(ATTRIBUTE.to_owned(), map.head()?)], to),
            #[cfg(feature = "netcdf")]
            Self::NetCdf => super::netcdf::write(map, to),
        }
    }
}

impl BeltMap {
    /// What a file says of the map, as one line.
    pub(super) fn head(&self) -> io::Result<String> {
        let axis = |axis: &MapAxis| Named { name: axis.key().path().to_owned(), unit: axis.unit().into_owned() };
        let quantity = |quantity: &Quantity| Named { name: quantity.name().into(), unit: quantity.unit().into() };
        let head = Head {
            version: VERSION,
            program: concat!("sheave ", env!("CARGO_PKG_VERSION")).to_owned(),
            axes: self.axes.iter().map(axis).collect(),
            quantities: self.quantities.iter().map(quantity).collect(),
            excluded_cells: self.excluded.clone(),
            report: self.report.clone(),
            inputs: self.inputs.clone(),
        };
        serde_json::to_string(&head).map_err(io::Error::other)
    }

    fn keys(&self) -> Vec<Key> {
        self.axes.iter().map(MapAxis::key).collect()
    }

    /// Names of the columns that follow from others.
    pub(super) fn derived_names(&self) -> &'static [&'static str] {
        if self.quantities.contains(&Quantity::Losses) {
            &[RESERVE, EFFICIENCY, WITH_LOSSES]
        } else {
            &[RESERVE, EFFICIENCY]
        }
    }

    /// Their values at a node.
    pub(super) fn derived(&self, node: &Node) -> Vec<f64> {
        let Some(sample) = node.sample() else { return vec![f64::NAN; self.derived_names().len()] };
        let point = self.point_of(sample);
        let all = [point.slip_reserve(), point.efficiency(), point.efficiency_with_losses()];
        // Losses that are not told are the last.
        all.into_iter().take(self.derived_names().len()).map(|value| value.unwrap_or(f64::NAN)).collect()
    }

    /// Coordinates of a node.
    pub(super) fn place(&self, node: usize) -> Vec<f64> {
        self.axes.iter().enumerate().map(|(k, axis)| axis.breakpoints()[self.shape.place(node, k)]).collect()
    }

    /// The nodes as a table, in the order of the grid: coordinates, what the node has, quantities, slip reserve and
    /// efficiencies, exact derivatives.
    pub fn table(&self) -> Table {
        let row = |(at, node): (usize, &Node)| cells(&self.place(at), node, self.quantities.len(), &self.derived(node));
        Table {
            columns: columns(&self.quantities, &self.keys(), self.derived_names()),
            rows: self.nodes.iter().enumerate().map(row).collect(),
        }
    }

    /// Reads a map that was written as CSV.
    ///
    /// # Errors
    /// See [`MapFileError`].
    pub fn read(path: &Path) -> Result<Self, MapFileError> {
        let name = path.display().to_string();
        let system = |error| MapFileError::Read { path: name.clone(), error };
        let bytes = std::fs::File::open(path).map_err(system)?;
        Self::from_csv(BufReader::new(bytes)).map_err(|reason| match reason {
            Wrong::System(error) => system(error),
            Wrong::Format(reason) => MapFileError::Format { path: name.clone(), reason },
        })
    }

    fn from_csv(mut from: impl BufRead) -> Result<Self, Wrong> {
        let mut first = String::new();
        io::Read::take(&mut from, LONGEST).read_line(&mut first).map_err(Wrong::System)?;
        let head = first.strip_prefix(MAGIC).ok_or_else(|| Wrong::of("it does not begin as a belt map"))?;
        let head: Head =
            serde_json::from_str(head).map_err(|error| Wrong::Format(format!("its first line: {error}")))?;
        let mut reader = csv::Reader::from_reader(from);
        let columns: Vec<String> = reader.headers().map_err(Wrong::csv)?.iter().map(str::to_owned).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record.map_err(Wrong::csv)?;
            if rows.len() == MOST {
                return Err(Wrong::of("it has too many rows"));
            }
            let cell = |field: &str| match field.parse::<f64>() {
                Ok(value) => serde_json::Number::from_f64(value).map_or(Cell::Empty, Cell::Number),
                Err(_) if field.is_empty() => Cell::Empty,
                Err(_) => Cell::Text(field.into()),
            };
            rows.push(record.iter().map(cell).collect());
        }
        Self::from_table(head, &Table { columns, rows })
    }

    /// A map of what a file says.
    fn from_table(head: Head, table: &Table) -> Result<Self, Wrong> {
        if head.version != VERSION {
            return Err(Wrong::Format(format!("it is of version {}, and {VERSION} is read", head.version)));
        }
        let key = |named: &Named| Key::from_path(&named.name).ok_or_else(|| Wrong::unknown(&named.name));
        let keys = head.axes.iter().map(key).collect::<Result<Vec<Key>, Wrong>>()?;
        let quantity = |named: &Named| Quantity::from_name(&named.name).ok_or_else(|| Wrong::unknown(&named.name));
        let quantities = head.quantities.iter().map(quantity).collect::<Result<Vec<Quantity>, Wrong>>()?;
        let column =
            |name: &str| table.column(name).ok_or_else(|| Wrong::Format(format!("column `{name}` is missing")));
        let values = |name: &str| -> Result<Vec<f64>, Wrong> {
            let at = column(name)?;
            Ok(table.rows.iter().map(|row| row.get(at).and_then(Cell::number).unwrap_or(f64::NAN)).collect())
        };
        let mut places = Vec::new();
        for key in &keys {
            places.push(values(key.path())?);
        }
        let axes = keys.iter().zip(&places).map(|(key, places)| MapAxis::new(*key, places.iter().copied()));
        let axes = axes.collect::<Result<Vec<_>, _>>().map_err(|error| Wrong::Format(error.to_string()))?;
        let all: usize = axes.iter().map(MapAxis::len).product();
        if axes.is_empty() || axes.len() > super::MAX_AXES || all != table.rows.len() {
            return Err(Wrong::of("its rows are not those of a grid"));
        }
        let status = column(STATUS)?;
        let mut samples: Vec<Sample> = vec![Sample { values: Vec::new(), slopes: Vec::new() }; all];
        for quantity in &quantities {
            for (sample, value) in samples.iter_mut().zip(values(quantity.name())?) {
                sample.values.push(value);
            }
            for key in &keys {
                for (sample, slope) in samples.iter_mut().zip(values(&slope_name(*quantity, *key))?) {
                    sample.slopes.push(slope);
                }
            }
        }
        // Rows may stand in any order.
        let numbers: Vec<HashMap<u64, usize>> = axes
            .iter()
            .map(|axis| axis.breakpoints().iter().enumerate().map(|(at, value)| (value.to_bits(), at)).collect())
            .collect();
        let mut nodes: Vec<Option<Node>> = vec![None; all];
        for ((at, row), sample) in table.rows.iter().enumerate().zip(samples) {
            let place = axes.iter().enumerate().try_fold(0, |place, (k, axis)| {
                Some(place * axis.len() + numbers[k].get(&places[k].get(at)?.to_bits())?)
            });
            let finite = sample.values.iter().chain(&sample.slopes).all(|value| value.is_finite());
            let node = match row.get(status) {
                Some(Cell::Text(name)) => Node::named(name, finite.then_some(sample)),
                _ => None,
            };
            let slot = place.and_then(|place| nodes.get_mut(place));
            match (slot, node) {
                (Some(slot @ None), Some(node)) => *slot = Some(node),
                _ => return Err(Wrong::Format(format!("row {} is not one of its grid", at + 1))),
            }
        }
        let nodes = nodes.into_iter().collect::<Option<Vec<Node>>>();
        let nodes = nodes.ok_or_else(|| Wrong::of("its rows are not those of a grid"))?;
        Ok(Self::new(axes, quantities, nodes, head.excluded_cells, head.report, head.inputs))
    }
}

/// What is wrong with a file.
enum Wrong {
    System(io::Error),
    Format(String),
}

impl Wrong {
    fn of(reason: &str) -> Self {
        Self::Format(reason.to_owned())
    }

    fn unknown(name: &str) -> Self {
        Self::Format(format!("`{name}` is not known"))
    }

    fn csv(error: csv::Error) -> Self {
        match error.kind() {
            csv::ErrorKind::Io(_) => match error.into_kind() {
                csv::ErrorKind::Io(error) => Self::System(error),
                _ => Self::of("it cannot be read"),
            },
            _ => Self::Format(error.to_string()),
        }
    }
}
