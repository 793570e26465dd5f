//! The page and its figures.

use std::error::Error;
use std::fmt::Write;
use std::path::Path;

use sheave::plot::{Axis, Figure, Look, Series};

use super::bench::{Bench, Fit, Model, Said, Step, fit};
use super::trends::{RADII, Scaling, Trends, best};

/// The model whose fitted scale the first figure takes.
const SHOWN: &str = "consistent";
/// Longest line of a paragraph, in characters.
const WIDTH: usize = 120;

type Pick = fn(&Said) -> Option<f64>;
const ELASTIC: Pick = |said| Some(said.elastic);
const WITH_LOSSES: Pick = |said| said.with_losses;

fn rows(bench: &Bench) -> Vec<(String, &'static str, Fit)> {
    let kinds: [(&'static str, Pick); 2] = [("friction alone", ELASTIC), ("with hysteresis", WITH_LOSSES)];
    let models = bench.models.iter().chain([&bench.by_ratio]).chain(&bench.tensions);
    models
        .flat_map(|model| {
            kinds.iter().filter_map(|(kind, pick)| Some((model.name.clone(), *kind, fit(&bench.steps, model, pick)?)))
        })
        .collect()
}

fn line(text: &mut String, cells: &[String]) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "| {} |", cells.join(" | "));
}

fn rms_table(bench: &Bench) -> String {
    let mut text = String::from(
        "| edition | losses | steps | mean error, points | rms, points | scale of the engine's curve | rms after the \
        fit, points |\n\
         |---|---|---|---|---|---|---|\n",
    );
    for (name, kind, fit) in rows(bench) {
        line(
            &mut text,
            &[
                name,
                kind.to_owned(),
                fit.points.to_string(),
                format!("{:+.1}", 100.0 * fit.mean_error),
                format!("{:.1}", 100.0 * fit.rms),
                format!("{:.3} ± {:.3}", fit.scale, fit.half_width),
                format!("{:.2}", 100.0 * fit.rms_after),
            ],
        );
    }
    text
}

/// What a reader at the terminal wants to see first.
pub fn summary(bench: &Bench) -> String {
    rms_table(bench)
}

fn point_table(bench: &Bench, model: &Model, scale: f64) -> String {
    let mut text = String::from(
        "| step | ω_P / rpm | ω_S / rpm | M_S / N·m | R_S/R_P | friction / W | bending / W | groove / W | model, \
         friction alone | model, with hysteresis | measured, scaled | standard error | residual, points |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for (step, said) in bench.steps.iter().zip(&model.said) {
        let Some(said) = said else { continue };
        let (measured, modelled) = (step.measured / scale, said.with_losses.unwrap_or(f64::NAN));
        line(
            &mut text,
            &[
                step.number.to_string(),
                format!("{:.0}", step.primary),
                format!("{:.0}", step.secondary),
                format!("{:.2}", step.torque),
                format!("{:.3}", said.ratio),
                format!("{:.0}", said.friction),
                format!("{:.0}", said.bending),
                format!("{:.0}", said.groove),
                format!("{:.1} %", 100.0 * said.elastic),
                format!("{:.1} %", 100.0 * modelled),
                format!("{:.1} %", 100.0 * measured),
                format!("{:.1}", 100.0 * step.error / scale),
                format!("{:+.1}", 100.0 * (modelled - measured)),
            ],
        );
    }
    text
}

/// Over the ratio of speeds.
fn curve(steps: &[Step], model: &Model, pick: Pick, value: impl Fn(&Step, f64) -> f64) -> Vec<(f64, f64)> {
    let points = steps
        .iter()
        .zip(&model.said)
        .filter_map(|(step, said)| Some((step.primary / step.secondary, 100.0 * value(step, pick(said.as_ref()?)?))));
    points.collect()
}

fn bars(steps: &[Step], middle: impl Fn(&Step) -> f64, scale: f64) -> Vec<(f64, f64)> {
    let bar = |step: &Step| {
        let (x, y, error) = (step.primary / step.secondary, middle(step), step.error / scale);
        [(x, 100.0 * (y - error)), (x, 100.0 * (y + error)), (f64::NAN, f64::NAN)]
    };
    steps.iter().flat_map(bar).collect()
}

fn figures(bench: &Bench, trends: &Trends) -> Option<Vec<Figure>> {
    let steps = &bench.steps;
    let shown = bench.models.iter().find(|model| model.name == SHOWN)?;
    let scale = fit(steps, shown, WITH_LOSSES)?.scale;
    let same = |_: &Step, value: f64| value;
    let measured = steps.iter().map(|step| (step.primary / step.secondary, 100.0 * step.measured / scale)).collect();
    let efficiency = Figure::new(
        "validation_efficiency",
        "Overall efficiency over the ratio of speeds: the dynamometer's, with the engine's curve scaled once, beside \
        edition consistent.",
        Axis::new("ratio of speeds ω_{P}/ω_{S}").over(0.5, 2.5),
        Axis::new("overall efficiency (%)").over(74.0, 98.0),
        vec![
            Series::line("friction alone", curve(steps, shown, ELASTIC, same)).color(0).look(Look::Dashed),
            Series::line("with hysteresis", curve(steps, shown, WITH_LOSSES, same)).color(0),
            Series::line("measured, with standard error", measured).color(1).look(Look::Dots),
            Series::line("", bars(steps, |step| step.measured / scale, scale)).color(1),
        ],
    );
    let mut series = vec![Series::line("", vec![(0.5, 0.0), (2.5, 0.0)]).look(Look::Guide)];
    let residual = |model: &Model, pick: Pick| -> Option<Vec<(f64, f64)>> {
        let scale = fit(steps, model, pick)?.scale;
        Some(curve(steps, model, pick, |step, value| value - step.measured / scale))
    };
    for (color, model) in bench.models.iter().enumerate() {
        if let Some(points) = residual(model, WITH_LOSSES) {
            series.push(Series::line(format!("{}, with hysteresis", model.name), points).color(color).marked());
        }
    }
    series
        .push(Series::line(format!("{SHOWN}, friction alone"), residual(shown, ELASTIC)?).color(6).look(Look::Dashed));
    let residuals = Figure::new(
        "validation_residual",
        "What is left of the efficiency, model less measured, over the ratio of speeds; each model with its own scale \
        of the engine's curve.",
        Axis::new("ratio of speeds ω_{P}/ω_{S}").over(0.5, 2.5),
        Axis::new("model less measured (points)"),
        series,
    );
    let mut series = Vec::new();
    for (color, (edition, points)) in trends.ratios.iter().enumerate() {
        let elastic = points.iter().map(|(ratio, elastic, _)| (*ratio, 100.0 * elastic)).collect();
        let with = points.iter().map(|(ratio, _, with)| (*ratio, 100.0 * with)).collect();
        series.push(Series::line(format!("{edition}, friction alone"), elastic).color(color).look(Look::Dashed));
        series.push(Series::line(format!("{edition}, with hysteresis"), with).color(color));
    }
    let ratio = Figure::new(
        "validation_ratio",
        "Overall efficiency of the base case over the ratio of the radii, without and with hysteresis.",
        Axis::new("ratio R_{S}/R_{P}").over(0.7, 2.05),
        Axis::new("overall efficiency (%)"),
        series,
    );
    Some(vec![efficiency, residuals, ratio])
}

fn scaling_table(scaling: &[Scaling]) -> String {
    let mut text = String::from("| EI / N·m² | loss |");
    RADII.iter().for_each(|radius| text += &format!(" R = {radius} mm |"));
    text += " exponent | measured |\n|---|---|---|---|---|---|---|\n";
    for belt in scaling {
        for (at, (name, unit, law)) in
            [("speed", 100.0, "−2"), ("torque, friction alone", 1.0, ""), ("torque, with hysteresis", 1.0, "−1")]
                .into_iter()
                .enumerate()
        {
            let mut cells = vec![belt.stiffness.to_string(), name.to_owned()];
            let suffix = if at == 0 { " %" } else { " N·m" };
            cells.extend(belt.lost.iter().map(|lost| format!("{:.3}{suffix}", unit * lost[at])));
            cells.push(belt.exponents[at].map_or("none".to_owned(), |exponent| format!("{exponent:.2}")));
            cells.push(law.to_owned());
            line(&mut text, &cells);
        }
    }
    text
}

fn best_table(trends: &Trends) -> String {
    let mut text = String::from("| edition | friction alone | with hysteresis |\n|---|---|---|\n");
    for (edition, points) in &trends.ratios {
        let of = |pick: fn(&(f64, f64, f64)) -> f64| {
            let points: Vec<(f64, f64)> = points.iter().map(|point| (point.0, pick(point))).collect();
            let said = |(ratio, value): (f64, f64)| format!("{:.2} % at {ratio:.2}", 100.0 * value);
            best(&points).map_or("none between".to_owned(), said)
        };
        line(&mut text, &[format!("`{edition}`"), of(|point| point.1), of(|point| point.2)]);
    }
    text
}

/// Ratio of the radii at the step at which a model has its largest efficiency.
fn peak(model: &Model, pick: Pick) -> f64 {
    let said = model.said.iter().flatten().filter_map(|said| Some((said.ratio, pick(said)?)));
    said.fold((f64::NAN, f64::NEG_INFINITY), |best, next| if next.1 > best.1 { next } else { best }).0
}

/// What friction alone and hysteresis leave, in points, when the first step is left out, which stands apart.
fn without_the_first(bench: &Bench, model: &Model) -> Option<String> {
    let said = Model { name: String::new(), said: model.said.get(1..)?.to_vec() };
    let rms = |pick: Pick| Some(100.0 * fit(bench.steps.get(1..)?, &said, pick)?.rms_after);
    Some(format!("{:.2} with friction alone and {:.2} with hysteresis", rms(ELASTIC)?, rms(WITH_LOSSES)?))
}

/// The page with its paragraphs in lines of at most [`WIDTH`] characters; headings, figures and rows of tables stay as
/// they are.
fn wrapped(page: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut in_paragraph = false;
    for line in page.lines() {
        if line.is_empty() || line.starts_with(['#', '|', '!']) {
            lines.push(line.to_owned());
            in_paragraph = false;
            continue;
        }
        for word in line.split_whitespace() {
            match lines.last_mut() {
                Some(last) if in_paragraph && last.chars().count() + 1 + word.chars().count() <= WIDTH => {
                    last.push(' ');
                    last.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
            in_paragraph = true;
        }
    }
    lines.iter().fold(String::new(), |page, line| page + line + "\n")
}

/// Writes the page and its figures.
pub fn write(folder: &Path, bench: &Bench, trends: &Trends) -> Result<(), Box<dyn Error>> {
    let figures = figures(bench, trends).ok_or("no solution to show")?;
    let own = folder.join("validation");
    std::fs::create_dir_all(&own)?;
    for figure in &figures {
        put(&own.join(format!("{}.svg", figure.name)), figure.svg()?.as_bytes())?;
    }
    let shown = bench.models.iter().find(|model| model.name == SHOWN).ok_or("no such edition")?;
    let fitted = fit(&bench.steps, shown, WITH_LOSSES).ok_or("no solutions")?;
    let rms = |model: &Model, pick: Pick| fit(&bench.steps, model, pick).map(|fit| 100.0 * fit.rms_after);
    let elastic = rms(shown, ELASTIC).ok_or("no solutions")?;
    let by_ratio = rms(&bench.by_ratio, ELASTIC).ok_or("no solutions")?;
    let page = include_str!("page.md")
        .replace("{elastic}", &format!("{elastic:.2}"))
        .replace("{by_ratio}", &format!("{by_ratio:.2}"))
        .replace("{without}", &without_the_first(bench, shown).ok_or("no solutions")?)
        .replace("{slips}", &format!("{:.0}", bench.slips))
        .replace("{rms}", &rms_table(bench))
        .replace("{points}", &point_table(bench, shown, fitted.scale))
        .replace("{scale}", &format!("{:.3}", fitted.scale))
        .replace("{after}", &format!("{:.2}", 100.0 * fitted.rms_after))
        .replace("{missing}", &format!("{:.1}", 100.0 * (1.0 - fitted.scale)))
        .replace("{peak_elastic}", &format!("{:.2}", peak(shown, ELASTIC)))
        .replace("{peak}", &format!("{:.2}", peak(shown, WITH_LOSSES)))
        .replace("{scaling}", &scaling_table(&trends.scaling))
        .replace("{best}", &best_table(trends));
    put(&folder.join("validation.md"), wrapped(&page).as_bytes())
}

/// Writes a file beside its place and renames it.
fn put(path: &Path, content: &[u8]) -> Result<(), Box<dyn Error>> {
    let beside = path.with_extension("part");
    std::fs::write(&beside, content)?;
    Ok(std::fs::rename(beside, path)?)
}
