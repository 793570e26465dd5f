//! The derivation of an edition, step by step, from the relations typed in to the first-order system.

mod formula;

pub use formula::{Style, Writer, latex};

use std::collections::BTreeSet;

use symbolica::atom::{Atom, AtomCore};

use crate::derive::linearise;
use crate::emit::SourceFile;
use crate::error::Error;
use crate::physics::beam::{Bending, SMALL, Shear};
use crate::physics::edition::{EDITIONS, Edition};
use crate::physics::model::{BoundaryModel, RegionModel};
use crate::physics::{beam, notation};
use crate::plan::{Definition, Guard, Origin, Plan, Step, read};

/// How a derivation is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Plain text with Unicode formulas.
    Text,
    /// A LaTeX document.
    Latex,
    /// Markdown with LaTeX formulas.
    Markdown,
}

impl Format {
    /// All formats.
    pub const ALL: [Format; 3] = [Format::Text, Format::Latex, Format::Markdown];

    /// Extension of a file.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Text => "txt",
            Format::Latex => "tex",
            Format::Markdown => "md",
        }
    }

    fn style(self) -> Style {
        if self == Format::Text { Style::Unicode } else { Style::Latex }
    }
}

/// The derivations of all editions in all formats.
///
/// # Errors
/// As the models they describe.
pub fn files() -> Result<Vec<SourceFile>, Error> {
    let mut files = Vec::new();
    for edition in &EDITIONS {
        let derivation = Derivation::of(edition)?;
        for format in Format::ALL {
            let name = format!("derivation_{}.{}", edition.name, format.extension());
            files.push(SourceFile { name, text: derivation.write(format) });
        }
    }
    Ok(files)
}

/// One line: `left = right`, and where it comes from.
struct Line {
    left: Side,
    right: Side,
    source: String,
    origin: Origin,
}

enum Side {
    Symbol(String),
    /// The derivative of a state or an integral along its region.
    Derivative(String),
    Expression(Atom),
    Definition(Definition),
}

struct Section {
    title: &'static str,
    text: String,
    lines: Vec<Line>,
}

/// A derivation, before it is written in some format.
struct Derivation {
    title: String,
    sections: Vec<Section>,
    guards: Vec<Guard>,
    symbols: Vec<notation::Symbol>,
}

impl Derivation {
    fn of(edition: &Edition) -> Result<Self, Error> {
        let (groove, span, ends) = (edition.contact()?, edition.span()?, edition.boundary()?);
        let plans = [&groove.plan, &span.plan, &ends.plan];
        let mut sections = vec![typed_in(plans)];
        if let Some(bending) = edition.bending {
            sections.push(bending_off_path()?);
            sections.push(bending_on_path(bending.shear)?);
        }
        sections.push(region("The belt in a groove", GROOVE, &groove));
        sections.push(region("The free belt", SPAN, &span));
        sections.push(conditions(&ends));
        sections.push(system(&groove, &span, &ends));
        let mut seen = BTreeSet::new();
        let guards = plans.iter().flat_map(|plan| plan.guards.iter().cloned());
        let guards = guards.filter(|guard| seen.insert(guard.divisor.to_string())).collect();
        let mut symbols = notation::all();
        symbols.extend(ends.ends.iter().chain(&ends.integrals).cloned());
        Ok(Self { title: format!("Derivation of the edition `{}`", edition.name), sections, guards, symbols })
    }

    fn write(&self, format: Format) -> String {
        let symbols = self.symbols.iter().map(|symbol| (symbol.name.clone(), symbol.symbol.clone()));
        let writer = Writer::new(format.style(), symbols);
        let page = Page { format, writer };
        let mut text = page.head(&self.title);
        for section in &self.sections {
            text += &page.section(section);
        }
        text += &page.guards(&self.guards);
        text += &page.notation(&self.used());
        text + page.foot()
    }

    /// Symbols of the notation that the derivation uses, in the notation's order.
    fn used(&self) -> Vec<&notation::Symbol> {
        let mut names = BTreeSet::new();
        let mut note = |atom: &Atom| {
            names.extend(atom.get_all_symbols(false).into_iter().map(|symbol| symbol.get_stripped_name().to_owned()));
        };
        for line in self.sections.iter().flat_map(|section| &section.lines) {
            for side in [&line.left, &line.right] {
                match side {
                    Side::Expression(atom) | Side::Definition(Definition::Expression(atom)) => note(atom),
                    Side::Definition(Definition::Function(_, arguments)) => arguments.iter().for_each(&mut note),
                    _ => {}
                }
            }
        }
        let table = notation::all().into_iter().map(|symbol| symbol.name).collect::<BTreeSet<_>>();
        self.symbols.iter().filter(|symbol| names.contains(&symbol.name) && table.contains(&symbol.name)).collect()
    }
}

const GROOVE: &str = "States are derivatives with respect to φ̂, φ = Φ φ̂; each step uses those before it.";
const SPAN: &str = "States are derivatives with respect to ŝ, s = L ŝ.";

fn line(left: &str, right: Atom, source: &str, origin: Origin) -> Line {
    Line { left: Side::Symbol(left.into()), right: Side::Expression(right), source: source.into(), origin }
}

/// The laws and the steps of the plans that are typed in, each once.
fn typed_in(plans: [&Plan; 3]) -> Section {
    let mut lines: Vec<Line> = Vec::new();
    let mut seen = BTreeSet::new();
    let laws = plans.into_iter().flat_map(|plan| &plan.laws);
    for law in laws.filter(|law| seen.insert((law.left.to_string(), law.right.to_string()))) {
        let (left, right) = (Side::Expression(law.left.clone()), Side::Expression(law.right.clone()));
        lines.push(Line { left, right, source: law.source.into(), origin: Origin::Primitive });
    }
    let count = |origin: Origin| {
        let mut names = BTreeSet::new();
        let steps = plans.into_iter().flat_map(|plan| &plan.steps).filter(|step| step.origin == origin);
        steps.filter(|step| names.insert(&step.name)).count()
    };
    let text = format!(
        "These are the laws from which equations are derived. Beside them {} definitions, friction laws and \
         conditions are typed in where they are used, {} steps are derived, and {} stand as a source prints them.",
        count(Origin::Primitive),
        count(Origin::Derived),
        count(Origin::Printed),
    );
    Section { title: "Laws", text, lines }
}

/// The first-order system that the kernels compute: each derivative along the region is the step named.
fn system(groove: &RegionModel, span: &RegionModel, ends: &BoundaryModel) -> Section {
    let mut lines = Vec::new();
    for model in [groove, span] {
        let of = model.states.iter().chain(model.integrals);
        for (name, row) in of.zip(model.rows) {
            let step = model.plan.step(row);
            let right = step.map_or(Side::Symbol((*row).into()), |step| Side::Definition(step.definition.clone()));
            let source = step.map_or("definition", |step| step.source).to_owned();
            let origin = step.map_or(Origin::Primitive, |step| step.origin);
            lines.push(Line { left: Side::Derivative((*name).into()), right, source, origin });
        }
    }
    let (states, conditions) = (2 * (groove.states.len() + span.states.len()), ends.equations.len());
    let text = format!(
        "Two grooves and two spans: {states} states, and {conditions} conditions where they meet, which determine {} \
         unknown constants too. The rates of the states come first in each kind of region, then those of its \
         integrals.",
        conditions - states
    );
    Section { title: "The assembled system", text, lines }
}

fn bending_off_path() -> Result<Section, Error> {
    let Bending { curvature, moment, moment_1, moment_2, shear, shear_1 } = Bending::derive()?;
    // Sums multiplied out, but for R − x.
    let (radius, difference) = (read("r", "r")?, read("r", "R - x")?);
    let derived = |left: &str, value: Atom, source: &str| {
        let flat = value.replace(difference.clone()).with(radius.clone()).expand();
        line(left, flat.replace(radius.clone()).with(difference.clone()), source, Origin::Derived)
    };
    let lines = vec![
        derived("psi_s", curvature, "(3.2), (3.4)"),
        derived("M_b", moment, "(3.32)"),
        derived("M_b_1", moment_1, "(3.34)"),
        derived("M_b_2", moment_2, "(3.36)"),
        derived("Q", shear, "(3.33)"),
        derived("Q_1", shear_1, "(3.35)"),
    ];
    let text = "Total derivatives with respect to φ, θ and x being functions of it.".into();
    Ok(Section { title: "Bending", text, lines })
}

fn bending_on_path(form: Shear) -> Result<Section, Error> {
    let bending = Bending::derive()?;
    let mut lines = Vec::new();
    let text = match form {
        Shear::Linearised => {
            let small = |exact: &Atom| linearise(exact, &SMALL);
            lines.push(line("Q", small(&bending.shear), "(3.38)", Origin::Derived));
            lines.push(line("Q_1", small(&bending.shear_1), "(3.40)", Origin::Derived));
            "To first order in θ, θ', θ'', x, x', x'' (3.37), θ''' kept as it stands; then x' = −(R − x) tanθ put in."
        }
        Shear::Full => "x' = −(R − x) tanθ and its derivative put in; in tanθ and ds/dφ the shear is short.",
    };
    let (shear, shear_1) = beam::Bending::on_path(&bending, form)?;
    lines.push(line("Q", shear, "(3.24)", Origin::Derived));
    lines.push(line("Q_1", shear_1, "(3.24), (3.42)", Origin::Derived));
    Ok(Section { title: "Shear along the belt's path", text: text.into(), lines })
}

fn region(title: &'static str, text: &str, model: &RegionModel) -> Section {
    let lines = model.plan.steps.iter().map(step_line).collect();
    Section { title, text: format!("{} {text}", model.doc), lines }
}

fn step_line(step: &Step) -> Line {
    Line {
        left: Side::Symbol(step.name.clone()),
        right: Side::Definition(step.definition.clone()),
        source: step.source.into(),
        origin: step.origin,
    }
}

fn conditions(model: &BoundaryModel) -> Section {
    let zero = |step: &Step| Line {
        left: Side::Definition(step.definition.clone()),
        right: Side::Expression(Atom::num(0)),
        source: step.source.into(),
        origin: step.origin,
    };
    let is_equation = |step: &&Step| model.equations.iter().any(|equation| equation.name == step.name);
    let lines = model.plan.steps.iter().filter(is_equation).map(zero).collect();
    let text = format!("{} 1 is an entry, 2 an exit; P, s, S, t are the regions in the belt's order.", model.doc);
    Section { title: "Where the regions meet", text, lines }
}

/// Name of the figure in `docs/figures` that shows what acts on an element of the belt.
const FIGURE: &str = "belt_element";

/// What that figure shows, in Markdown as in LaTeX.
const CAPTION: &str = "An element of the belt in a groove, as everything is counted positive: $\\varphi$ in the \
    direction of travel, the penetration $x$ from the pulley's radius $R$ inwards, the inclination $\\theta$ outwards, \
    shear outwards on the front face, the groove's $n$ outwards and its $t$ against the travel. $T$ is the tractive \
    tension, in which the belt's momentum is counted; a span has neither $n$ nor $t$.";

/// Lays lines out in one format.
struct Page {
    format: Format,
    writer: Writer,
}

impl Page {
    fn head(&self, title: &str) -> String {
        let note = "Generated from eqgen/src/physics; numbers are those of the thesis, (C) and (D) its appendices.";
        let marks = "Each equation says whether it is typed in or derived, or stands as the thesis prints it.";
        match self.format {
            Format::Text => format!("{}\n\n{note}\n{marks}\n", title.replace('`', "")),
            Format::Markdown => format!(
                "# {title}\n\n{note}\n{marks}\n\n![Forces on an element of the belt](figures/{FIGURE}.svg)\n\n\
                 *{CAPTION}*\n"
            ),
            Format::Latex => {
                let title = title.replace('`', "");
                format!(
                    "\\documentclass{{article}}\n\\usepackage{{amsmath}}\n\\usepackage{{graphicx}}\n\
                     \\begin{{document}}\n\\title{{{title}}}\n\\maketitle\n{note}\n{marks}\n\n\
                     % docs/figures/{FIGURE}.svg as a PDF file\n\\begin{{figure}}[ht]\n\\centering\n\
                     \\IfFileExists{{{FIGURE}.pdf}}{{\\includegraphics[width=0.8\\linewidth]{{{FIGURE}}}}}{{}}\n\
                     \\caption{{{CAPTION}}}\n\\end{{figure}}\n"
                )
            }
        }
    }

    fn foot(&self) -> &'static str {
        if self.format == Format::Latex { "\\end{document}\n" } else { "" }
    }

    fn title(&self, title: &str) -> String {
        match self.format {
            Format::Text => format!("\n{title}\n{}\n", "-".repeat(title.chars().count())),
            Format::Markdown => format!("\n## {title}\n"),
            Format::Latex => format!("\n\\section{{{title}}}\n"),
        }
    }

    fn section(&self, section: &Section) -> String {
        let lines: Vec<String> = section.lines.iter().filter_map(|line| self.line(line)).collect();
        let formulas = match self.format {
            Format::Text => lines.concat(),
            _ if lines.is_empty() => String::new(),
            Format::Markdown => format!("$$\n\\begin{{align}}\n{}\n\\end{{align}}\n$$\n", lines.join(" \\\\\n")),
            Format::Latex => format!("\\begin{{align}}\n{}\n\\end{{align}}\n", lines.join(" \\\\\n")),
        };
        format!("{}\n{}\n\n{formulas}", self.title(section.title), self.prose(&section.text))
    }

    /// A line of an aligned block; nothing for a function that has a name of its own for the generated code's sake.
    fn line(&self, line: &Line) -> Option<String> {
        let (left, right) = (self.side(&line.left), self.side(&line.right));
        if left == right {
            return None;
        }
        let origin = match line.origin {
            Origin::Primitive => "typed in",
            Origin::Derived => "derived",
            Origin::Printed => "as printed",
        };
        let source = &line.source;
        Some(match self.format {
            Format::Text => format!("  {left} = {right}    [{source}; {origin}]\n"),
            Format::Markdown => format!("{left} &= {} \\tag*{{{source}; {origin}}}", broken(&right)),
            Format::Latex => format!("{left} &= {} \\tag*{{{}; {origin}}}", broken(&right), self.prose(source)),
        })
    }

    fn side(&self, side: &Side) -> String {
        match side {
            Side::Symbol(name) => self.writer.symbol(name),
            Side::Derivative(name) => self.writer.rate(name),
            Side::Expression(value) => self.writer.expression(value),
            Side::Definition(definition) => self.writer.definition(definition),
        }
    }

    fn guards(&self, guards: &[Guard]) -> String {
        let mut text = self.title("What must not vanish");
        text += "\nGeneration fails if anything else is divided by.\n";
        for guard in guards {
            let formula = self.writer.expression(&guard.divisor);
            text += &match self.format {
                Format::Text => format!("  {formula}: {}\n", guard.reason),
                Format::Markdown => format!("- ${formula}$: {}\n", guard.reason),
                Format::Latex => format!("\n\\noindent ${formula}$: {}\n", self.prose(guard.reason)),
            };
        }
        text
    }

    fn notation(&self, symbols: &[&notation::Symbol]) -> String {
        let mut text = self.title("Notation");
        if self.format == Format::Markdown {
            text += "\n| symbol | name | unit | meaning |\n|---|---|---|---|\n";
        }
        for symbol in symbols {
            let printed = self.writer.symbol(&symbol.name);
            let (name, unit, doc) = (&symbol.name, symbol.unit, &symbol.doc);
            text += &match self.format {
                Format::Text => format!("  {printed:<16} {name:<16} {unit:<8} {doc}\n"),
                Format::Markdown => {
                    format!("| ${}$ | `{name}` | {unit} | {} |\n", bars(&printed), doc.replace('|', r"\|"))
                }
                Format::Latex => format!("\n\\noindent ${printed}$ [{unit}]: {}\n", self.prose(doc)),
            };
        }
        text
    }

    /// Running text; LaTeX wants its mathematics marked.
    fn prose(&self, text: &str) -> String {
        if self.format != Format::Latex {
            return text.to_owned();
        }
        let special = |word: &str| !word.is_ascii() || word.contains(['_', '^', '\'', '|']);
        let words = text.split(' ').map(|word| {
            let formula = word.trim_end_matches([',', ';', ':', '.']);
            let rest = &word[formula.len()..];
            if special(formula) { format!("${}${rest}", latex(formula)) } else { word.to_owned() }
        });
        words.collect::<Vec<String>>().join(" ")
    }
}

/// A long sum on several lines of an aligned block: broken before a term, outside all brackets.
fn broken(formula: &str) -> String {
    const LONGEST: usize = 150;
    let (mut text, mut line, mut depth) = (String::new(), 0, 0_i32);
    for word in formula.split_inclusive(' ') {
        if line > LONGEST && depth == 0 && matches!(word.trim_end(), "+" | "-") {
            text += "\\notag \\\\\n&\\quad {} ";
            line = 0;
        }
        depth += word.matches(['{', '(', '[']).count() as i32 - word.matches(['}', ')', ']']).count() as i32;
        line += word.len();
        text += word;
    }
    text
}

/// Absolute values without the bar that ends a table's cell.
fn bars(formula: &str) -> String {
    let mut parts = formula.split('|');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for (index, part) in parts.enumerate() {
        text += if index % 2 == 0 { r"\lvert " } else { r"\rvert " };
        text += part;
    }
    text
}
