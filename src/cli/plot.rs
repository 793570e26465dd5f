//! `sheave plot`: figures of the table that a sweep wrote.

use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::case::{Key, output_axis_label};
use sheave::drive::Output;
use sheave::plot::{Axis, Figure, Series};
use std::path::PathBuf;

/// Draw columns of the table that a sweep wrote
///
/// One figure for each column, SVG and PNG, with a curve for each set of the other keys that were varied:
/// sheave plot table.csv --y efficiency.overall --out figures
#[derive(Debug, Args)]
#[command(after_long_help = super::STATUS)]
pub struct Arguments {
    /// Table of a sweep, CSV
    #[arg(value_name = "TABLE.csv")]
    table: PathBuf,
    /// Column across; without one, the last key that was varied
    #[arg(long, value_name = "COLUMN")]
    x: Option<String>,
    /// Column up, again for more; without any, efficiency and both axial forces
    #[arg(long, value_name = "COLUMN")]
    y: Vec<String>,
    /// Write the figures into this folder
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Columns that are drawn unless others are asked for.
const SHOWN: [Output; 3] = [Output::EfficiencyOverall, Output::PrimaryAxialForce, Output::SecondaryAxialForce];
/// The column behind those of the varied keys.
const CONVERGED: &str = "converged";
/// Curves in one figure at most: more colours cannot be distinguished.
const CURVES: usize = 12;

/// The values of the other keys, and the points.
type Curve<'a> = (Vec<&'a str>, Vec<(f64, f64)>);

/// A table as texts.
struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let table = Table::read(arguments)?;
    let varied = table.columns.iter().position(|column| column == CONVERGED).unwrap_or(0);
    let x = match &arguments.x {
        Some(name) => table.column(name)?,
        None => varied.checked_sub(1).ok_or_else(|| {
            let columns = table.columns.iter().map(|column| format!("`{column}`")).collect::<Vec<_>>().join(", ");
            Stop::Usage(format!(
                "no column stands before `{CONVERGED}`, where a sweep writes the keys that it varied: expected --x \
                 with one of the columns (separated by commas): {columns}"
            ))
        })?,
    };
    let asked: Vec<&str> = match arguments.y.as_slice() {
        [] => SHOWN.map(Output::name).to_vec(),
        given => given.iter().map(String::as_str).collect(),
    };
    table.of_numbers(x)?;
    let others: Vec<usize> = (0..varied).filter(|column| *column != x).collect();
    let figures = asked.into_iter().map(|name| table.figure(x, &others, name)).collect::<Result<Vec<_>, Stop>>()?;
    output::create_folder(&arguments.out)?;
    output::write_figures(&arguments.out, &figures)
}

impl Table {
    fn read(arguments: &Arguments) -> Result<Self, Stop> {
        let refuse = |error: csv::Error| Stop::Usage(format!("{}: {error}", arguments.table.display()));
        let mut reader = csv::Reader::from_path(&arguments.table).map_err(refuse)?;
        let columns = reader.headers().map_err(refuse)?.iter().map(str::to_owned).collect();
        let mut rows = Vec::new();
        for record in reader.records() {
            rows.push(record.map_err(refuse)?.iter().map(str::to_owned).collect());
        }
        Ok(Self { columns, rows })
    }

    fn column(&self, name: &str) -> Result<usize, Stop> {
        let at = self.columns.iter().position(|column| column == name);
        at.ok_or_else(|| {
            Stop::Usage(format!("the table has no column `{name}`; its columns: {}", self.columns.join(", ")))
        })
    }

    fn text(&self, row: usize, column: usize) -> &str {
        self.rows.get(row).and_then(|row| row.get(column)).map_or("", String::as_str)
    }

    /// Refuses a column of texts, of which a figure would be empty.
    fn of_numbers(&self, column: usize) -> Result<(), Stop> {
        let name = self.columns.get(column).map_or("", String::as_str);
        let texts = || (0..self.rows.len()).map(|row| self.text(row, column)).filter(|text| !text.is_empty());
        let wrong = |what: String| Err(Stop::Usage(format!("column `{name}` {what}: expected one of numbers")));
        match texts().find(|text| text.parse::<f64>().is_err()) {
            Some(text) => wrong(format!("holds `{text}`")),
            None if texts().next().is_none() => wrong("is empty".to_owned()),
            None => Ok(()),
        }
    }

    /// A number in the unit of its axis; NaN where there is none, as in the row of a point without a solution.
    fn number(&self, row: usize, column: usize) -> f64 {
        let value = self.text(row, column).parse().unwrap_or(f64::NAN);
        self.key(column).map_or(value, |key| key.entry().readable(value).0)
    }

    /// The key of a column that was varied, or of one of the inputs.
    fn key(&self, column: usize) -> Option<Key> {
        let name = self.columns.get(column)?;
        Key::from_path(name.strip_prefix("inputs.").unwrap_or(name))
    }

    /// A column over another: rows with the same values in `others` make a curve.
    fn figure(&self, x: usize, others: &[usize], name: &str) -> Result<Figure, Stop> {
        let y = self.column(name)?;
        self.of_numbers(y)?;
        let mut curves: Vec<Curve<'_>> = Vec::new();
        for row in 0..self.rows.len() {
            let of: Vec<&str> = others.iter().map(|&column| self.text(row, column)).collect();
            let point = (self.number(row, x), self.number(row, y));
            match curves.iter_mut().find(|(other, _)| *other == of) {
                Some((_, points)) => points.push(point),
                None => curves.push((of, vec![point])),
            }
        }
        if curves.len() > CURVES {
            let (made, most) = (curves.len(), CURVES);
            return Err(Stop::Usage(format!("{made} curves in one figure: expected at most {most}; vary fewer keys")));
        }
        let series = curves.into_iter().map(|(of, points)| Series::line(self.label(others, &of), points).marked());
        let across = self.axis(x);
        let caption = format!("{name} over {across}");
        let file = name.replace('.', "_");
        Ok(Figure::new(file, caption, Axis::new(across), Axis::new(self.axis(y)), series.collect()))
    }

    fn label(&self, columns: &[usize], of: &[&str]) -> String {
        let one = |(column, text): (&usize, &&str)| {
            let name = self.columns.get(*column).map_or("", String::as_str);
            match (Key::from_path(name), text.parse::<f64>()) {
                (Some(key), Ok(value)) => key.entry().label_at(value),
                _ => (*text).to_owned(),
            }
        };
        columns.iter().zip(of).map(one).collect::<Vec<_>>().join(", ")
    }

    /// A key's or an output's name, symbol and unit; else the column's name.
    fn axis(&self, column: usize) -> String {
        let name = self.columns.get(column).map_or("", String::as_str);
        let output = || name.parse::<Output>().map_or_else(|_| name.to_owned(), output_axis_label);
        self.key(column).map_or_else(output, |key| key.entry().axis_label())
    }
}
