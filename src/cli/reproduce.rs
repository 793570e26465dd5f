//! `sheave reproduce`: chapters 6 and 7 of the thesis.

use super::output;
use super::solve::jobs;
use super::stop::Stop;
use clap::Args;
use sheave::model::InternalError;
use sheave::report::{REPRODUCED, Reproduction};
use sheave::study::thesis::{Chapters, ChaptersError, RATIOS, chapters};
use sheave::study::write_csv;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Compute chapters 6 and 7 of the thesis again
///
/// Base case, operating range, half angle, bending stiffness, slack tension and friction coefficient, in the editions
/// `published`, `thesis` and `consistent`: every number of the text beside ours with a verdict. With --out also
/// report.html with all figures, verdicts.md, verdicts.json, and a folder for each edition with its figures (SVG, PNG)
/// and tables (CSV).
#[derive(Debug, Args)]
pub struct Arguments {
    /// Folder to write into
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = jobs)]
    jobs: Option<NonZeroUsize>,
    /// Points over the operating range
    #[arg(long, value_name = "N", default_value_t = RATIOS as u64,
        value_parser = clap::value_parser!(u64).range(2..=1000))]
    points: u64,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
    }
    let start = Instant::now();
    let ratios = usize::try_from(arguments.points).unwrap_or(RATIOS);
    let jobs = arguments.jobs.map(NonZeroUsize::get);
    let (all, points) = chapters(&REPRODUCED, ratios, jobs)?;
    let seconds = start.elapsed().as_secs_f64();
    let reproduction = Reproduction::new(all, format!("{points} solutions computed in {seconds:.2} s."))?;
    if let Some(folder) = &arguments.out {
        write(folder, &reproduction)?;
        tracing::info!("all done in {:.2} s", start.elapsed().as_secs_f64());
    }
    output::print(&reproduction.markdown())
}

fn write(folder: &Path, reproduction: &Reproduction) -> Result<(), Stop> {
    for (chapters, _, figures) in &reproduction.editions {
        let folder = folder.join(chapters.edition.name());
        output::create_folder(&folder)?;
        output::write_figures(&folder, figures)?;
        write_tables(&folder, chapters)?;
    }
    let together = folder.join("editions");
    output::create_folder(&together)?;
    output::write_figures(&together, &reproduction.comparison)?;
    let verdicts = reproduction.editions.iter().map(|(chapters, checks, _)| {
        let checks = serde_json::to_value(checks).map_err(|_| InternalError::Json("a verdict"))?;
        Ok((chapters.edition.name().to_owned(), checks))
    });
    let verdicts = verdicts.collect::<Result<serde_json::Map<_, _>, InternalError>>()?;
    for (name, text) in [
        ("verdicts.json", output::json(&verdicts)?),
        ("verdicts.md", reproduction.markdown()),
        ("report.html", reproduction.page()?),
    ] {
        output::write_file(folder, name, |to| to.write_all(text.as_bytes()))?;
    }
    Ok(())
}

fn write_tables(folder: &Path, chapters: &Chapters) -> Result<(), Stop> {
    output::write_file(folder, "operating_range.csv", |to| write_csv(&chapters.range, to))?;
    chapters.families.iter().try_for_each(|family| {
        output::write_file(folder, &format!("{}.csv", family.name), |to| write_csv(&family.table, to))
    })?;
    let json = output::json(&chapters.base.result)?;
    output::write_file(folder, "base.json", |to| to.write_all(json.as_bytes()))
}

impl From<ChaptersError> for Stop {
    fn from(error: ChaptersError) -> Self {
        match error {
            ChaptersError::Study(error) => error.into(),
            other => Self::NoSolution(other.to_string()),
        }
    }
}
