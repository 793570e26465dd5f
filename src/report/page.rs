//! The page itself.

use super::loss::{LossSplit, Mechanisms, losses};
use crate::case::Setting;
use crate::plot::{Figure, PlotError};
use crate::quantity::{rpm, unsigned_zero};
use crate::result::{Outcome, Pulley, warnings};
use std::fmt::Write;

const STYLE: &str = ":root{color-scheme:light \
    dark;--ink:#222;--page:#fff;--line:#ddd;--soft:#666;--warn:#b45000}\
    @media(prefers-color-scheme:dark){:root{--ink:#e6e6e6;--page:#16181b;--line:#3a3d42;--soft:#a0a0a0;\
    --warn:#ffb066}}body{font:15px/1.45 \
    system-ui,sans-serif;color:var(--ink);background:var(--page);max-width:1270px;margin:2em auto;padding:0 \
    1.2em}h1{font-size:1.5em;margin:0}h2{font-size:1.1em;margin:1.8em 0 .5em;border-bottom:1px solid \
    var(--line)}p.lead{color:var(--soft);margin:.2em 0 1em}table{border-collapse:collapse}td,th{padding:.16em .7em \
    .16em \
    0;text-align:left;font-weight:normal}th{color:var(--soft)}td.n,th.n{text-align:right;\
    font-variant-numeric:tabular-nums}.key{display:flex;flex-wrap:wrap;gap:.6em \
    2.4em;margin:1em 0}.key div{min-width:7em}.key b{display:block;font-size:1.5em;font-weight:600}.key \
    span{color:var(--soft)}.two{display:flex;flex-wrap:wrap;gap:0 \
    1.8em}sub{font-size:.72em;line-height:0}ul.warn{padding-left:1.2em}.warn{color:var(--warn)}\
    .figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(430px,1fr));gap:1.4em}figure{margin:0}\
    figure \
    svg{width:100%;height:auto;background:#fff;border-radius:4px}figcaption{color:var(--soft);font-size:.92em}\
    figure.wide{grid-column:1/-1;max-width:760px}.beside{display:grid;grid-template-columns:repeat(3,1fr);\
    gap:1em}.beside \
    b{color:var(--soft)}@media print{body{margin:0}figure{break-inside:avoid}}";

/// The report of a solution with its figures: one HTML page that needs nothing else.
///
/// # Errors
/// A figure that could not be drawn.
pub fn page(outcome: &Outcome, figures: &[Figure]) -> Result<String, PlotError> {
    let result = &outcome.result;
    let mut html = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        html,
        "<h1>Belt drive</h1><p class=\"lead\">Edition {}; ratio R<sub>S</sub>/R<sub>P</sub> = {:.3}; \
         {:.2} N·m at {:.0} rpm</p>",
        result.edition,
        result.inputs.drive.secondary_radius / result.inputs.drive.primary_radius,
        result.primary.torque,
        rpm(result.primary.speed),
    );
    headline(&mut html, outcome);
    let said = warnings(outcome);
    if !said.is_empty() {
        html += "<ul class=\"warn\">";
        html.extend(said.iter().map(|text| format!("<li>{text}</li>")));
        html += "</ul>\n";
    }
    html += "<div class=\"two\"><div><h2>Pulleys</h2>";
    pulleys(&mut html, &result.primary, &result.secondary);
    html += "</div><div><h2>Energy</h2>";
    energy(&mut html, outcome, &losses(outcome)?);
    html += "</div><div><h2>Given</h2>";
    inputs(&mut html, outcome);
    html += "</div></div>\n<h2>Figures</h2><div class=\"figures\">";
    for figure in figures {
        let class = if figure.equal { " class=\"wide\"" } else { "" };
        let _ = writeln!(
            html,
            "<figure id=\"{}\"{class}>{}<figcaption>{}</figcaption></figure>",
            figure.name,
            figure.svg()?,
            figure.caption
        );
    }
    html += "</div>";
    footer(&mut html, outcome);
    Ok(document("Belt drive", &html))
}

/// A whole HTML document in the style of the reports, that refers to nothing outside itself.
pub fn document(title: &str, body: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" \
         content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>{title}</title>\
         <style>{STYLE}</style></head>\n<body>{body}</body></html>\n"
    )
}

fn headline(html: &mut String, outcome: &Outcome) {
    let result = &outcome.result;
    // Where neither pulley drives the other, there is none.
    let share = |share: Option<f64>| share.map_or_else(|| "none".to_owned(), |share| format!("{:.2} %", 100.0 * share));
    let items = [
        (share(result.efficiency.overall), "overall efficiency"),
        (share(result.efficiency.speed), "speed efficiency"),
        (share(result.efficiency.torque), "torque efficiency"),
        (format!("{:.1} N", result.primary.axial_force), "axial force, primary"),
        (format!("{:.1} N", result.secondary.axial_force), "axial force, secondary"),
        (format!("{:+.2} mm", 1e3 * result.belt.length_error), "drive against belt length"),
    ];
    *html += "<div class=\"key\">";
    html.extend(items.map(|(value, name)| format!("<div><b>{}</b><span>{name}</span></div>", signed(&value))));
    *html += "</div>\n";
}

/// A number with a true minus sign, unless all its digits are zero; any other text as it is.
pub(super) fn signed(text: &str) -> String {
    let text = unsigned_zero(text);
    text.strip_prefix('-').map_or_else(|| text.to_owned(), |number| format!("\u{2212}{number}"))
}

fn row(html: &mut String, name: &str, cells: &[String], unit: &str) {
    let _ = write!(html, "<tr><th>{name}</th>");
    html.extend(cells.iter().map(|cell| format!("<td class=\"n\">{}</td>", signed(cell))));
    let _ = write!(html, "<td>{unit}</td></tr>");
}

fn pulleys(html: &mut String, primary: &Pulley, secondary: &Pulley) {
    *html += "<table><tr><th></th><th class=\"n\">primary</th><th class=\"n\">secondary</th><th></th></tr>";
    type Quantity = (&'static str, &'static str, usize, fn(&Pulley) -> f64);
    let rows: [Quantity; 16] = [
        ("axial force A", "N", 1, |p| p.axial_force),
        ("torque", "N·m", 3, |p| p.torque),
        ("speed", "rpm", 1, |p| rpm(p.speed)),
        ("power", "W", 1, |p| p.power),
        ("wrap angle Φ", "deg", 2, |p| p.wrap_angle.to_degrees()),
        ("inclination θ at entry", "deg", 2, |p| p.entry_angle.to_degrees()),
        ("inclination θ at exit", "deg", 2, |p| p.exit_angle.to_degrees()),
        ("tractive tension at entry", "N", 1, |p| p.entry_tension),
        ("tractive tension at exit", "N", 1, |p| p.exit_tension),
        ("largest penetration", "mm", 3, |p| 1e3 * p.max_penetration),
        ("slowest sliding", "mm/s", 3, |p| 1e3 * p.min_sliding_speed),
        ("fastest sliding", "mm/s", 0, |p| 1e3 * p.max_sliding_speed),
        ("adhesion", "% of wrap", 1, |p| 100.0 * p.adhesion_fraction),
        ("resultant x", "mm", 1, |p| 1e3 * p.resultant_x),
        ("resultant y", "mm", 1, |p| 1e3 * p.resultant_y),
        ("binding moment", "N·m", 1, |p| p.binding_moment),
    ];
    for (name, unit, digits, value) in rows {
        let cells = [primary, secondary].map(|pulley| format!("{:.digits$}", value(pulley)));
        row(html, name, &cells, unit);
    }
    *html += "</table>";
}

fn energy(html: &mut String, outcome: &Outcome, split: &LossSplit) {
    let energy = &outcome.result.energy;
    let watt = |value: f64| [format!("{value:.1}"), format!("{:.3} %", 100.0 * value / energy.power_in)];
    *html += "<table><tr><th></th><th class=\"n\">W</th><th class=\"n\">of power in</th><th></th></tr>";
    row(html, "power in", &watt(energy.power_in), "");
    row(html, "power out", &watt(energy.power_out), "");
    row(html, "friction loss", &watt(energy.friction_loss), "");
    row(html, "strain energy flux", &watt(energy.stretch_work), "");
    row(
        html,
        "unaccounted for",
        &watt(energy.power_in - energy.power_out - energy.friction_loss - energy.stretch_work),
        "",
    );
    *html += "</table><h2>Friction loss</h2><table><tr><th>W</th><th class=\"n\">primary</th><th \
        class=\"n\">secondary</th><th class=\"n\">both</th><th></th></tr>";
    type Part = (&'static str, fn(&Mechanisms) -> f64);
    let parts: [Part; 6] = [
        ("at entry", |m| m.entry),
        ("seated", |m| m.seated),
        ("at exit", |m| m.exit),
        ("sliding radially", |m| m.radial),
        ("sliding around", |m| m.tangential),
        ("in all", |m| m.radial + m.tangential),
    ];
    for (name, part) in parts {
        let (primary, secondary) = (part(&split.primary), part(&split.secondary));
        row(html, name, &[primary, secondary, primary + secondary].map(|value| format!("{value:.2}")), "");
    }
    *html += "</table>";
}

fn inputs(html: &mut String, outcome: &Outcome) {
    *html += "<table>";
    for (key, setting) in outcome.result.inputs.settings() {
        let entry = key.entry();
        let (value, unit) = match setting {
            Setting::Number(si) => {
                let (number, unit) = entry.readable(si);
                (short(number), unit)
            }
            Setting::List(values) => {
                let numbers: Vec<String> = values.iter().map(|si| short(entry.readable(*si).0)).collect();
                (numbers.join(", "), entry.readable(0.0).1)
            }
            Setting::Name(name) => (name.to_owned(), String::new()),
            Setting::Table(grid) => (grid.to_string(), "SI".into()),
        };
        let symbol = entry.marked_symbol().replace("_{", "<sub>").replace('}', "</sub>");
        let name = entry.name().replace('_', " ");
        row(html, format!("{name} {symbol}").trim_end(), &[value], &unit);
    }
    *html += "</table>";
}

/// Six digits, without zeros at the end.
fn short(value: f64) -> String {
    let digits = (5.0 - value.abs().log10().floor()).clamp(0.0, 9.0) as usize;
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn footer(html: &mut String, outcome: &Outcome) {
    let solver = &outcome.result.solver;
    let mesh = &solver.mesh_intervals;
    let _ = write!(
        html,
        "<p class=\"lead\">Solved in {} ms: order {}, largest relative residual {:.1e} of {:.0e}\
, boundary residual {:.1e}, \
         {} intervals, {} continuation steps, {} Newton iterations. sheave {}.</p>",
        solver.milliseconds(),
        solver.order,
        solver.max_residual,
        solver.tolerance,
        solver.max_boundary_residual,
        mesh.primary + mesh.secondary + mesh.tight_span + mesh.slack_span,
        solver.continuation_steps,
        solver.newton_iterations,
        env!("CARGO_PKG_VERSION"),
    );
}
