//! Chapters 6 and 7 beside what the editions give: as text, and as one page with all figures.

use super::page::{document, signed};
use crate::case::Edition;
use crate::plot::{Figure, PlotError};
use crate::study::thesis::{Chapters, Check, checks, comparison, figures, number_in_thesis};
use crate::threads;
use std::fmt::Write;

/// Chapters in several editions, their checks and their figures.
#[derive(Debug, Clone)]
pub struct Reproduction {
    /// Each edition's chapters, checks and figures; checks and figures of all editions in the same order.
    pub editions: Vec<(Chapters, Vec<Check>, Vec<Figure>)>,
    /// Figures that show the editions together.
    pub comparison: Vec<Figure>,
    /// What it took, in a sentence.
    pub effort: String,
}

/// One line of the table of verdicts.
struct Line<'a> {
    first: &'a Check,
    /// What each edition gives.
    ours: Vec<String>,
}

impl Reproduction {
    /// Checks the chapters and draws up their figures.
    ///
    /// # Errors
    /// None, unless this program is broken.
    pub fn new(chapters: Vec<Chapters>, effort: String) -> Result<Self, PlotError> {
        let comparison = comparison(&chapters);
        let with = |chapters: Chapters| {
            let (checks, figures) = (checks(&chapters)?, figures(&chapters)?);
            Ok((chapters, checks, figures))
        };
        let editions = chapters.into_iter().map(with).collect::<Result<_, PlotError>>()?;
        Ok(Self { editions, comparison, effort })
    }

    /// Checks of the first edition that are met, and all.
    pub fn met(&self) -> (usize, usize) {
        let checks = self.editions.first().map_or(&[][..], |(_, checks, _)| checks);
        (checks.iter().filter(|check| check.met).count(), checks.len())
    }

    fn names(&self) -> Vec<&'static str> {
        self.editions.iter().map(|(chapters, ..)| chapters.edition.name()).collect()
    }

    fn lines(&self) -> Vec<Line<'_>> {
        let Some((_, checks, _)) = self.editions.first() else { return Vec::new() };
        let ours = |at: usize| {
            let value =
                |(_, checks, _): &(Chapters, Vec<Check>, Vec<Figure>)| checks.get(at).map_or(String::new(), value);
            self.editions.iter().map(value).collect()
        };
        checks.iter().enumerate().map(|(at, first)| Line { first, ours: ours(at) }).collect()
    }

    fn headline(&self) -> String {
        let (met, all) = self.met();
        let name = self.names().first().copied().unwrap_or_default();
        format!("{met} of {all} numbers and statements of chapters 6 and 7 met by edition {name}. {}", self.effort)
    }

    /// Points without a solution.
    fn failures(&self) -> Vec<String> {
        let mut failures = Vec::new();
        for (chapters, ..) in &self.editions {
            let name = chapters.edition.name();
            failures.extend(chapters.failures.iter().map(|why| format!("{name}: a point without a solution: {why}")));
        }
        failures
    }

    /// The energy audit of the base case: name, and each edition's watts.
    fn audit(&self) -> Vec<(&'static str, Vec<String>)> {
        let row = |name, watts: fn(&Chapters) -> f64| {
            (name, self.editions.iter().map(|(chapters, ..)| signed(&format!("{:.2}", watts(chapters)))).collect())
        };
        vec![
            row("power in", |chapters| chapters.base.result.energy.power_in),
            row("power out", |chapters| chapters.base.result.energy.power_out),
            row("friction loss", |chapters| chapters.base.result.energy.friction_loss),
            row("strain energy flux", |chapters| chapters.base.result.energy.stretch_work),
            row("unaccounted for", |chapters| {
                let energy = &chapters.base.result.energy;
                energy.power_in - energy.power_out - energy.friction_loss - energy.stretch_work
            }),
        ]
    }

    /// All numbers and statements as Markdown.
    pub fn markdown(&self) -> String {
        let names = self.names();
        let mut text = format!("{}\n\n| section | quantity | the thesis says | verdict |", self.headline());
        // Writing to a string cannot fail.
        names.iter().for_each(|name| text += &format!(" {name} |"));
        text += &format!("\n|---|---|---|---|{}\n", "---:|".repeat(names.len()));
        for line in self.lines() {
            let (said, verdict) = (said(line.first), verdict(line.first));
            let _ = writeln!(
                text,
                "| {} | {} | {said} | {verdict} | {} |",
                line.first.section,
                line.first.what,
                line.ours.join(" | ")
            );
        }
        text += "\nEnergy audit of the base case, W:\n\n| |";
        names.iter().for_each(|name| text += &format!(" {name} |"));
        text += &format!("\n|---|{}\n", "---:|".repeat(names.len()));
        for (name, watts) in self.audit() {
            let _ = writeln!(text, "| {name} | {} |", watts.join(" | "));
        }
        self.failures().iter().for_each(|failure| text += &format!("\n{failure}\n"));
        text
    }

    /// All numbers, statements and figures as one page that needs nothing else.
    ///
    /// # Errors
    /// A figure that could not be drawn.
    pub fn page(&self) -> Result<String, PlotError> {
        let mut body = format!(
            "<h1>Chapters 6 and 7, computed</h1><p class=\"lead\">M. J. Messick, <i>An Experimentally-Validated \
             V-Belt Model for Axial Force and Efficiency in a Continuously Variable Transmission</i>, Virginia Tech, \
             2018. {}</p>\n{}",
            self.headline(),
            EDITIONS
        );
        body += "<p><a href=\"#numbers\">Numbers</a> · <a href=\"#together\">The editions together</a> · \
                 <a href=\"#figures\">Figures</a></p>\n";
        self.numbers(&mut body);
        body += "<h2 id=\"together\">The editions together</h2><div class=\"figures\">";
        for figure in threads::collect(&self.comparison, element) {
            body += &figure?;
        }
        body += "</div>\n<h2 id=\"figures\">Figures, edition by edition</h2><div class=\"beside\">";
        self.names().iter().for_each(|name| body += &format!("<b>{name}</b>"));
        let count = self.editions.first().map_or(0, |(_, _, figures)| figures.len());
        let rows = (0..count).flat_map(|at| self.editions.iter().map(move |(_, _, figures)| figures.get(at)));
        let rows: Vec<Option<&Figure>> = rows.collect();
        for figure in threads::collect(&rows, |figure| figure.map_or(Ok("<figure></figure>".to_owned()), element)) {
            body += &figure?;
        }
        body += "</div>\n";
        Ok(document("Chapters 6 and 7, computed", &body))
    }

    fn numbers(&self, body: &mut String) {
        *body += "<h2 id=\"numbers\">Numbers</h2><table><tr><th>section</th><th>quantity</th><th>the thesis \
            says</th><th>verdict</th>";
        self.names().iter().for_each(|name| *body += &format!("<th class=\"n\">{name}</th>"));
        *body += "</tr>";
        for line in self.lines() {
            let class = if line.first.met { "" } else { " class=\"warn\"" };
            let _ = write!(
                body,
                "<tr{class}><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
                line.first.section,
                line.first.what,
                said(line.first),
                verdict(line.first)
            );
            line.ours.iter().for_each(|ours| *body += &format!("<td class=\"n\">{ours}</td>"));
            *body += "</tr>";
        }
        *body += "</table>\n<h2>Energy audit of the base case, W</h2><table><tr><th></th>";
        self.names().iter().for_each(|name| *body += &format!("<th class=\"n\">{name}</th>"));
        for (name, watts) in self.audit() {
            *body += &format!("</tr><tr><td>{name}</td>");
            watts.iter().for_each(|watts| *body += &format!("<td class=\"n\">{}</td>", watts));
        }
        *body += "</tr></table>\n";
        for failure in self.failures() {
            *body += &format!("<p class=\"warn\">{failure}</p>");
        }
    }
}

/// What the columns stand for.
const EDITIONS: &str = "<p>Edition <b>published</b> solves the equations exactly as the thesis's code prints them, \
    slips included, and must give its numbers. Edition <b>thesis</b> is the same model without the slips, edition \
    <b>consistent</b> the model without its linearisation, which conserves energy. Where these differ from the first, \
    the printed slips made the thesis's result.</p>\n";

fn element(figure: &Figure) -> Result<String, PlotError> {
    let number = number_in_thesis(&figure.name).map_or(String::new(), |number| format!("<b>{number}</b> "));
    Ok(format!(
        "<figure id=\"{}\">{}<figcaption>{number}{}</figcaption></figure>\n",
        figure.name,
        figure.svg()?,
        figure.caption
    ))
}

/// The thesis's number with its tolerance; of a statement, the number of places that may contradict it.
fn said(check: &Check) -> String {
    match check.unit.as_str() {
        "contradictions" => "so it is".to_owned(),
        _ if check.published == 0.0 => format!("below {} {}", short(check.tolerance), check.unit),
        unit => format!("{} ± {} {unit}", short(check.published), short(check.tolerance)).trim_end().to_owned(),
    }
}

fn verdict(check: &Check) -> &'static str {
    if check.met { "met" } else { "MISSED" }
}

/// What an edition gives; of a statement, how often it is contradicted.
fn value(check: &Check) -> String {
    match check.unit.as_str() {
        "contradictions" if check.met => "so it is".to_owned(),
        "contradictions" => format!("not at {} points", check.ours),
        _ => short(check.ours),
    }
}

/// Four significant digits, with a true minus sign.
fn short(value: f64) -> String {
    let digits = if value == 0.0 { 0.0 } else { (3.0 - value.abs().log10().floor()).clamp(0.0, 6.0) };
    let text = format!("{value:.*}", digits as usize);
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text };
    signed(&text)
}

/// The editions that the thesis is reproduced in, its own first.
pub const REPRODUCED: [Edition; 3] = [Edition::Published, Edition::Thesis, Edition::Consistent];
