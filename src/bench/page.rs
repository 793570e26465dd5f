//! Pages about what a bench gave: one HTML file that needs nothing else.

use crate::plot::{Figure, PlotError};
use crate::report::document;
use std::fmt::Write;

/// A table of a page: its heading, the names of its columns, and its rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PageTable {
    /// Heading.
    pub title: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// Cells.
    pub rows: Vec<Vec<String>>,
}

/// A page with tables and figures.
///
/// # Errors
/// A figure that could not be drawn.
pub fn page(
    title: &str,
    lead: &str,
    warnings: &[String],
    tables: &[PageTable],
    figures: &[Figure],
) -> Result<String, PlotError> {
    // Writing to a string cannot fail.
    let mut html = format!("<h1>{}</h1><p class=\"lead\">{}</p>\n", escape(title), escape(lead));
    if !warnings.is_empty() {
        html += "<ul class=\"warn\">";
        html.extend(warnings.iter().map(|text| format!("<li>{}</li>", escape(text))));
        html += "</ul>\n";
    }
    for table in tables {
        let _ = write!(html, "<h2>{}</h2><table><tr>", escape(&table.title));
        html.extend(table.columns.iter().map(|name| format!("<th>{}</th>", escape(name))));
        html += "</tr>\n";
        for row in &table.rows {
            html += "<tr>";
            for cell in row {
                let class = if cell.parse::<f64>().is_ok() { " class=\"n\"" } else { "" };
                let _ = write!(html, "<td{class}>{}</td>", escape(cell));
            }
            html += "</tr>\n";
        }
        html += "</table>\n";
    }
    html += "<h2>Figures</h2><div class=\"figures\">";
    for figure in figures {
        let class = if figure.equal { " class=\"wide\"" } else { "" };
        let (name, svg, caption) = (&figure.name, figure.svg()?, escape(&figure.caption));
        let _ = writeln!(html, "<figure id=\"{name}\"{class}>{svg}<figcaption>{caption}</figcaption></figure>");
    }
    Ok(document(title, &(html + "</div>")))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
