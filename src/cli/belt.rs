//! `sheave belt`: the properties of a belt from bench tests.

use super::measured::{object, refused, warn};
use super::output;
use super::stop::Stop;
use clap::Args;
use sheave::bench::belt::{Description, Properties, TABLE};
use sheave::bench::{BenchError, BenchProblem, PageTable, keys, page, temperature};
use std::path::PathBuf;

/// Find a belt's properties from bench tests
///
/// From moduli of the rubber, data of the yarns, a tension, a bending and a lateral test, length and mass to what a
/// case needs of a belt, as in chapter 4 of the thesis. What it prints is a case file: everything on the way as
/// comments, then the tables [belt], [sheave] with the half angle for which the radial stiffness holds, and [thermal]
/// with the temperature of the stiffnesses where it is known.
///
///     sheave belt examples/belts/cvtech.toml > belt.toml && sheave solve belt.toml
#[derive(Debug, Args)]
#[command(after_long_help = help() + "\n" + super::STATUS, verbatim_doc_comment)]
pub struct Arguments {
    /// File with what was measured
    #[arg(value_name = "BELT.toml")]
    file: PathBuf,
    /// Temperature of the belt in use, between those at which the rubber was tested: "60 degC"
    #[arg(long, value_name = "T", value_parser = |text: &str| temperature(text), allow_hyphen_values = true)]
    temperature: Option<f64>,
    /// Print the result as one JSON object, in SI units
    #[arg(long, conflicts_with = "out")]
    json: bool,
    /// Write belt.toml, result.json, figures (SVG, PNG) and report.html into this folder, and print what belt.toml has
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn help() -> String {
    format!(
        "Keys of the file; a quantity is a string with a unit or a bare number in SI units. Without [yarns], [section] \
        and\n\
         [[rubber.test]] the tests are those of the whole belt.\n{}",
        keys(&TABLE)
    )
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    output::folder_place(arguments.out.as_deref())?;
    let evaluated = Description::read(&arguments.file).and_then(|description| {
        description.evaluate(arguments.temperature).map(|properties| (description, properties))
    });
    match evaluated {
        Ok((description, properties)) => arguments.deliver(&description, &properties),
        Err(error) => Err(refused("belt", arguments.json, error)),
    }
}

impl Arguments {
    fn deliver(&self, description: &Description, properties: &Properties) -> Result<(), Stop> {
        warn(&properties.warnings);
        let inputs = serde_json::json!(description.inputs());
        let json = || object("belt", inputs, &properties.warnings, properties);
        if self.json {
            return output::print(&json()?);
        }
        let case_file = properties.case_file();
        if let Some(folder) = &self.out {
            output::create_folder(folder)?;
            let json = json()?;
            output::write_file(folder, "result.json", |to| to.write_all(json.as_bytes()))?;
            output::write_file(folder, "belt.toml", |to| to.write_all(case_file.as_bytes()))?;
            let figures = properties.figures();
            output::write_figures(folder, &figures)?;
            let name = properties.name.as_deref().unwrap_or("Belt");
            let page = page(name, "Properties from bench tests", &properties.warnings, &tables(properties), &figures)?;
            output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
        }
        output::print(&case_file)
    }
}

fn tables(properties: &Properties) -> [PageTable; 2] {
    let columns = || ["quantity", "value", "unit"].map(String::from).to_vec();
    let cells = |(name, value, unit): (String, f64, &str)| vec![name, format!("{value:.6}"), unit.into()];
    let belt = &properties.belt;
    let mut table = vec![
        ("length", 1e3 * belt.length, "mm"),
        ("mass per length", belt.mass_per_length, "kg/m"),
        ("longitudinal stiffness EA", 1e-3 * belt.longitudinal_stiffness, "kN"),
        ("bending stiffness EI", belt.bending_stiffness, "N·m²"),
        ("radial stiffness k", 1e-6 * belt.radial_stiffness, "MPa"),
    ];
    table.extend(belt.perimeter.map(|perimeter| ("perimeter of the section", 1e3 * perimeter, "mm")));
    table.extend(belt.loss_tangent.map(|tangent| ("loss tangent", tangent, "")));
    table.push(("half angle of the sheaves", properties.lateral.sheave_half_angle.to_degrees(), "deg"));
    let table = table.into_iter().map(|(name, value, unit)| cells((name.into(), value, unit))).collect();
    let way = properties.rows().into_iter().map(cells).collect();
    [
        PageTable { title: "The belt".into(), columns: columns(), rows: table },
        PageTable { title: "On the way".into(), columns: columns(), rows: way },
    ]
}

impl From<BenchError> for Stop {
    fn from(error: BenchError) -> Self {
        match error.problem() {
            BenchProblem::Cancelled => Self::Cancelled,
            BenchProblem::NoSolution { .. } => Self::NoSolution(error.to_string()),
            _ => Self::Refused(miette::Report::new(error)),
        }
    }
}
