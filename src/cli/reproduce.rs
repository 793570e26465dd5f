//! `sheave reproduce`: chapters 6 and 7 of the thesis.

use super::output;
use super::stop::Stop;
use clap::Args;
use rayon::prelude::*;
use sheave::case::Edition;
use sheave::plot::PlotError;
use sheave::study::thesis::{Chapters, ChaptersError, Check, chapters, checks, figures};
use sheave::study::write_csv;
use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Compute chapters 6 and 7 of the thesis again
///
/// Base case, operating range, half angle, bending stiffness, slack tension and friction coefficient, in the editions
/// `published`, `thesis` and `consistent`: every figure as SVG and PNG, the tables as CSV, every number of the text beside
/// ours with a verdict (checks.json, checks.md, report.html). Without --out only the verdicts are printed.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Folder to write into, a folder within for each edition
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
}

const EDITIONS: [Edition; 3] = [Edition::Published, Edition::Thesis, Edition::Consistent];

/// An edition's chapters, their checks, the seconds they took.
struct Done {
    chapters: Chapters,
    checks: Vec<Check>,
    seconds: f64,
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    if let Some(folder) = &arguments.out {
        output::create_folder(folder)?;
    }
    let jobs = arguments.jobs.map(NonZeroUsize::get);
    let mut all = Vec::new();
    for edition in EDITIONS {
        let start = Instant::now();
        let chapters = chapters(edition, jobs)?;
        let checks = checks(&chapters);
        all.push(Done { chapters, checks, seconds: start.elapsed().as_secs_f64() });
    }
    let text = verdicts(&all);
    if let Some(folder) = &arguments.out {
        let start = Instant::now();
        all.iter().try_for_each(|done| write_edition(folder, done))?;
        let name = |done: &Done| done.chapters.edition.name().to_owned();
        let object: serde_json::Map<String, serde_json::Value> =
            all.iter().map(|done| (name(done), serde_json::to_value(&done.checks).unwrap_or_default())).collect();
        let json = output::json(&object)?;
        output::write_file(folder, "checks.json", |to| to.write_all(json.as_bytes()))?;
        output::write_file(folder, "checks.md", |to| to.write_all(text.as_bytes()))?;
        let page = page(&all)?;
        output::write_file(folder, "report.html", |to| to.write_all(page.as_bytes()))?;
        tracing::info!("drawn and written in {:.2} s", start.elapsed().as_secs_f64());
    }
    output::print(&text)
}

fn write_edition(folder: &Path, done: &Done) -> Result<(), Stop> {
    let folder = folder.join(done.chapters.edition.name());
    output::create_folder(&folder)?;
    output::write_figures(&folder, &figures(&done.chapters))?;
    output::write_file(&folder, "operating_range.csv", |to| write_csv(&done.chapters.range, to))?;
    done.chapters.families.iter().try_for_each(|family| {
        output::write_file(&folder, &format!("{}.csv", family.name), |to| write_csv(&family.table, to))
    })?;
    let json = output::json(&done.chapters.base.result)?;
    output::write_file(&folder, "base.json", |to| to.write_all(json.as_bytes()))
}

/// Four significant digits.
fn short(value: f64) -> String {
    let digits = if value == 0.0 { 0.0 } else { (3.0 - value.abs().log10().floor()).clamp(0.0, 6.0) };
    let text = format!("{value:.*}", digits as usize);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Rows of the table of verdicts: cells, and whether the published edition meets it.
fn rows(all: &[Done]) -> Vec<([String; 6], bool)> {
    let Some(first) = all.first() else { return Vec::new() };
    let row = |(at, check): (usize, &Check)| {
        let ours = |edition: usize| {
            all.get(edition).and_then(|done| done.checks.get(at)).map_or(String::new(), |check| short(check.ours))
        };
        let published = format!("{} ± {} {}", short(check.published), short(check.tolerance), check.unit);
        let verdict = if check.met { "met" } else { "MISSED" };
        let what = format!("{} {}", check.section, check.what);
        ([what, published.trim_end().to_owned(), ours(0), verdict.into(), ours(1), ours(2)], check.met)
    };
    first.checks.iter().enumerate().map(row).collect()
}

fn headline(all: &[Done]) -> String {
    let (points, seconds) = all.iter().fold((0, 0.0), |sum, done| (sum.0 + done.chapters.points, sum.1 + done.seconds));
    let rows = rows(all);
    let met = rows.iter().filter(|(_, met)| *met).count();
    format!(
        "{met} of {} numbers and statements of the thesis met by edition published; {points} solutions in {seconds:.2} s",
        rows.len()
    )
}

/// Markdown.
fn verdicts(all: &[Done]) -> String {
    let mut text = format!("{}\n\n", headline(all));
    text += "| section, quantity | thesis | published | verdict | thesis, slips mended | consistent |\n|---|---|---|---|---|---|\n";
    for (cells, _) in rows(all) {
        let _ = writeln!(text, "| {} |", cells.join(" | ")); // writing to a string does not fail
    }
    for done in all {
        for failure in &done.chapters.failures {
            let _ = writeln!(text, "\n{}: a point without a solution: {failure}", done.chapters.edition.name());
        }
    }
    text
}

/// One page, its figures within.
fn page(all: &[Done]) -> Result<String, Stop> {
    let mut body = format!("<h1>Chapters 6 and 7</h1><p class=\"lead\">{}</p>\n<table>", headline(all));
    body += "<tr><th>section, quantity</th><th>thesis</th><th class=\"n\">published</th><th>verdict</th>\
             <th class=\"n\">thesis, slips mended</th><th class=\"n\">consistent</th></tr>";
    for ([what, thesis, ours, verdict, mended, consistent], met) in rows(all) {
        let class = if met { "" } else { " class=\"warn\"" };
        let _ = write!(
            body,
            "<tr{class}><td>{what}</td><td>{thesis}</td><td class=\"n\">{ours}</td><td>{verdict}</td><td class=\"n\">{mended}</td>\
             <td class=\"n\">{consistent}</td></tr>"
        );
    }
    body += "</table>\n";
    for done in all {
        let name = done.chapters.edition.name();
        let _ = write!(body, "<h2 id=\"{name}\">Edition {name}</h2><div class=\"figures\">");
        let drawn = figures(&done.chapters)
            .par_iter()
            .map(|figure| {
                let class = if figure.equal { " class=\"wide\"" } else { "" };
                Ok(format!("<figure{class}>{}<figcaption>{}</figcaption></figure>\n", figure.svg()?, figure.caption))
            })
            .collect::<Result<Vec<_>, PlotError>>()?;
        body.extend(drawn);
        body += "</div>\n";
    }
    Ok(sheave::report::document("Chapters 6 and 7", &body))
}

impl From<ChaptersError> for Stop {
    fn from(error: ChaptersError) -> Self {
        match error {
            ChaptersError::Study(error) => error.into(),
            other => Self::NoSolution(other.to_string()),
        }
    }
}
