//! Expressions as text for people: Unicode or LaTeX, in the thesis's symbols.

use std::collections::BTreeMap;

use symbolica::atom::{Atom, AtomView};

use crate::plan::{Definition, Function};

/// How formulas are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// Unicode, one line.
    Unicode,
    /// LaTeX mathematics.
    Latex,
}

/// Writes formulas in one style.
pub struct Writer {
    style: Style,
    /// Symbols as the notation has them, by name.
    symbols: BTreeMap<String, String>,
}

/// How tightly a formula binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Whole,
}

impl Writer {
    /// A writer that knows the symbols `(name, symbol)`.
    pub fn new(style: Style, symbols: impl Iterator<Item = (String, String)>) -> Self {
        Self { style, symbols: symbols.collect() }
    }

    /// A symbol of the notation.
    pub fn symbol(&self, name: &str) -> String {
        let symbol = self.symbols.get(name).map_or(name, String::as_str);
        if self.style == Style::Latex { latex(symbol) } else { symbol.to_owned() }
    }

    /// The derivative of a symbol along its region.
    pub fn rate(&self, name: &str) -> String {
        let (symbol, along) = (self.symbol(name), self.symbol("s"));
        match self.style {
            Style::Latex => format!(r"\frac{{\mathrm{{d}} {symbol}}}{{\mathrm{{d}} {along}}}"),
            Style::Unicode => format!("d{symbol}/d{along}"),
        }
    }

    /// The right side of a step.
    pub fn definition(&self, definition: &Definition) -> String {
        match definition {
            Definition::Expression(value) => self.expression(value),
            Definition::Number(value) if *value == 0.0 || value.abs() >= 1e-3 => value.to_string(),
            Definition::Number(value) => {
                let text = format!("{value:e}");
                match (text.split_once('e'), self.style) {
                    (Some(("1", exponent)), Style::Latex) => format!("10^{{{exponent}}}"),
                    (Some((digits, exponent)), Style::Latex) => format!(r"{digits} \cdot 10^{{{exponent}}}"),
                    _ => text,
                }
            }
            Definition::Function(function, arguments) => {
                let arguments: Vec<String> = arguments.iter().map(|argument| self.expression(argument)).collect();
                self.function(*function, &arguments)
            }
        }
    }

    /// An expression.
    pub fn expression(&self, expression: &Atom) -> String {
        let text = self.view(expression.as_view()).0;
        if self.style == Style::Unicode { text.replace('-', "−") } else { text }
    }

    fn function(&self, function: Function, arguments: &[String]) -> String {
        let first = arguments.first().map_or("", String::as_str);
        let all = arguments.join(", ");
        match (function, self.style) {
            (Function::Sqrt, Style::Unicode) => format!("√({first})"),
            (Function::Sqrt, Style::Latex) => format!(r"\sqrt{{{first}}}"),
            (Function::Tan, Style::Unicode) => format!("tan {first}"),
            (Function::Tan, Style::Latex) => format!(r"\tan {first}"),
            (Function::Tanh, Style::Unicode) => format!("tanh({first})"),
            (Function::Tanh, Style::Latex) => format!(r"\tanh\left({first}\right)"),
            (Function::Exp, Style::Unicode) => format!("exp({first})"),
            (Function::Exp, Style::Latex) => format!(r"\exp\left({first}\right)"),
            (Function::Ln, Style::Unicode) => format!("ln({first})"),
            (Function::Ln, Style::Latex) => format!(r"\ln\left({first}\right)"),
            (Function::Saturate, Style::Unicode) => format!("min(1, {first})"),
            (Function::Saturate, Style::Latex) => format!(r"\min\left(1, {first}\right)"),
            (Function::Angle, Style::Unicode) => format!("angle of ({all})"),
            (Function::Angle, Style::Latex) => format!(r"\angle\left({all}\right)"),
            (Function::Turn, Style::Unicode) => format!("{first} mod 2π"),
            (Function::Turn, Style::Latex) => format!(r"{first} \bmod 2\pi"),
        }
    }

    fn view(&self, view: AtomView<'_>) -> (String, Binding) {
        match view {
            AtomView::Num(_) => self.number(&view.to_string()),
            AtomView::Var(variable) => self.variable(variable.get_symbol().get_stripped_name()),
            AtomView::Fun(function) => {
                let name = function.get_symbol().get_stripped_name().to_owned();
                let argument = function.iter().next().map(|argument| self.view(argument));
                let argument = argument.map_or(String::new(), |(text, binding)| match binding {
                    Binding::Whole => text,
                    _ => self.parenthesised(&text),
                });
                let name = if self.style == Style::Latex { format!("\\{name}") } else { name };
                (format!("{name} {argument}"), Binding::Product)
            }
            AtomView::Add(sum) => (self.sum(sum.iter()), Binding::Sum),
            AtomView::Mul(_) | AtomView::Pow(_) => self.product(view),
        }
    }

    fn number(&self, text: &str) -> (String, Binding) {
        match (text.split_once('/'), self.style) {
            (Some((above, below)), Style::Latex) => (format!(r"\frac{{{above}}}{{{below}}}"), Binding::Whole),
            (Some(_), Style::Unicode) => (text.to_owned(), Binding::Product),
            (None, _) => (text.to_owned(), Binding::Whole),
        }
    }

    fn variable(&self, name: &str) -> (String, Binding) {
        if name == "𝜋" {
            return (if self.style == Style::Latex { r"\pi" } else { "π" }.to_owned(), Binding::Whole);
        }
        let symbol = self.symbol(name);
        // Symbols such as dψ/ds and tanθ are more than one letter.
        let kept = self.symbols.get(name).map_or("", String::as_str);
        match () {
            () if kept.starts_with("tan") => (symbol.replace("tanθ", "tan θ"), Binding::Product),
            () if kept.contains('/') => (self.parenthesised(&symbol), Binding::Whole),
            () => (symbol, Binding::Whole),
        }
    }

    fn sum<'a>(&self, terms: impl Iterator<Item = AtomView<'a>>) -> String {
        // A positive term first, where there is one.
        let (mut plain, mut negative) = (Vec::new(), Vec::new());
        for (text, _) in terms.map(|term| self.view(term)) {
            match text.strip_prefix('-') {
                Some(rest) => negative.push(rest.trim_start().to_owned()),
                None => plain.push(text),
            }
        }
        let minus = if self.style == Style::Latex { "-" } else { "−" };
        let mut text = plain.join(" + ");
        for term in negative {
            let joint = if text.is_empty() { minus.to_owned() } else { format!(" {minus} ") };
            text = format!("{text}{joint}{term}");
        }
        text
    }

    /// cos² θ
    fn function_power(&self, base: AtomView<'_>, exponent: &str) -> Option<(String, Binding)> {
        let (text, Binding::Product) = self.view(base) else { return None };
        let (name, argument) = text.split_once(' ')?;
        if !matches!(base, AtomView::Fun(_) | AtomView::Var(_)) {
            return None;
        }
        let raised = match self.style {
            Style::Latex => format!("{name}^{{{exponent}}} {argument}"),
            Style::Unicode => format!("{name}{} {argument}", superscript(exponent)),
        };
        (exponent != "1").then_some((raised, Binding::Product))
    }

    /// A product with its denominator; a negative one starts with `-`.
    fn product(&self, view: AtomView<'_>) -> (String, Binding) {
        let factors: Vec<AtomView<'_>> = match view {
            AtomView::Mul(product) => product.iter().collect(),
            _ => vec![view],
        };
        let (mut above, mut below, mut sign) = (Vec::new(), Vec::new(), "");
        for factor in factors {
            self.factor(factor, &mut above, &mut below, &mut sign);
        }
        if let ([], [(single, Binding::Power)], "") = (below.as_slice(), above.as_slice(), sign) {
            return (single.clone(), Binding::Power);
        }
        let numerator = self.factors(&above, below.is_empty());
        let text = match (below.is_empty(), self.style) {
            (true, _) => numerator,
            (false, Style::Latex) => format!(r"\frac{{{numerator}}}{{{}}}", self.factors(&below, false)),
            (false, Style::Unicode) => {
                let numerator = self.factors(&above, true);
                let single = below.len() == 1;
                let denominator = self.factors(&below, true);
                format!("{numerator}/{}", if single { denominator } else { self.parenthesised(&denominator) })
            }
        };
        (format!("{sign}{text}"), Binding::Product)
    }

    fn factor(
        &self,
        factor: AtomView<'_>,
        above: &mut Vec<(String, Binding)>,
        below: &mut Vec<(String, Binding)>,
        sign: &mut &str,
    ) {
        match factor {
            AtomView::Num(_) => {
                let text = factor.to_string();
                let (minus, size) = text.strip_prefix('-').map_or((false, text.as_str()), |size| (true, size));
                if minus {
                    *sign = if sign.is_empty() { "-" } else { "" };
                }
                let (numerator, denominator) = size.split_once('/').unwrap_or((size, "1"));
                if numerator != "1" {
                    above.insert(0, (numerator.to_owned(), Binding::Whole));
                }
                if denominator != "1" {
                    below.insert(0, (denominator.to_owned(), Binding::Whole));
                }
            }
            AtomView::Pow(power) => {
                let (base, exponent) = power.get_base_exp();
                let exponent = exponent.to_string();
                let size = exponent.trim_start_matches('-');
                let raised = self.function_power(base, size).unwrap_or_else(|| self.power(self.view(base), size));
                if exponent.starts_with('-') { below.push(raised) } else { above.push(raised) }
            }
            _ => above.push(self.view(factor)),
        }
    }

    fn power(&self, (base, binding): (String, Binding), exponent: &str) -> (String, Binding) {
        if exponent == "1" {
            return (base, binding);
        }
        let base = if binding == Binding::Whole && !base.contains('\'') { base } else { self.parenthesised(&base) };
        let text = match self.style {
            Style::Latex => format!("{base}^{{{exponent}}}"),
            Style::Unicode => format!("{base}{}", superscript(exponent)),
        };
        (text, Binding::Power)
    }

    fn factors(&self, factors: &[(String, Binding)], in_product: bool) -> String {
        let alone = factors.len() == 1 && !in_product;
        let texts: Vec<String> = factors
            .iter()
            .map(
                |(text, binding)| {
                    if *binding == Binding::Sum && !alone { self.parenthesised(text) } else { text.clone() }
                },
            )
            .collect();
        if texts.is_empty() {
            "1".to_owned()
        } else {
            texts.join(if self.style == Style::Latex { r"\, " } else { " " })
        }
    }

    fn parenthesised(&self, text: &str) -> String {
        if self.style == Style::Latex { format!(r"\left({text}\right)") } else { format!("({text})") }
    }
}

fn superscript(exponent: &str) -> String {
    let digit = |digit: char| match digit {
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    };
    exponent.chars().map(digit).collect()
}

const GREEK: [(char, &str); 18] = [
    ('λ', "lambda"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('θ', "theta"),
    ('ϑ', "vartheta"),
    ('μ', "mu"),
    ('π', "pi"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "varphi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Φ', "Phi"),
    ('∂', "partial"),
    ('−', "-"),
    ('²', "^2"),
    ('³', "^3"),
    ('√', "sqrt"),
];

/// A symbol of the notation in LaTeX: `θ̂''_P1` → `\hat{\theta}''_{P1}`.
pub fn latex(symbol: &str) -> String {
    // A derivative, and stiffnesses whose names are two letters.
    if let Some((above, below)) = symbol.strip_prefix('d').and_then(|rest| rest.split_once("/d")) {
        return format!(r"\frac{{\mathrm{{d}} {}}}{{\mathrm{{d}} {}}}", latex(above), latex(below));
    }
    if matches!(symbol, "EA" | "EI") {
        return format!(r"\mathit{{{symbol}}}");
    }
    let words = ["sin", "cos", "tan"]
        .into_iter()
        .fold(symbol.to_owned(), |text, word| text.replace(word, &format!("\\{word} ")));
    let mut out = String::new();
    let mut last = String::new();
    let mut characters = words.chars().peekable();
    while let Some(character) = characters.next() {
        let next = match character {
            '\u{302}' => format!(r"\hat{{{}}}", std::mem::take(&mut last).trim_end()),
            // Composed letters of the notation.
            'Â' | 'Ê' | 'Ŵ' | 'Ŷ' | 'ŝ' => {
                let plain = match character {
                    'Â' => 'A',
                    'Ê' => 'E',
                    'Ŵ' => 'W',
                    'Ŷ' => 'Y',
                    _ => 's',
                };
                format!(r"\hat{{{plain}}}")
            }
            '_' => {
                let mut index = String::new();
                while let Some(part) = characters.next_if(|next| next.is_alphanumeric()) {
                    index.push_str(&greek(part));
                }
                // A word is upright, a variable is not.
                let is_word = index.len() > 1 && index.chars().all(|letter| letter.is_ascii_lowercase());
                if is_word { format!(r"_{{\mathrm{{{index}}}}}") } else { format!("_{{{}}}", index.trim_end()) }
            }
            other => greek(other),
        };
        out.push_str(&std::mem::replace(&mut last, next));
    }
    out.push_str(&last);
    [" '", " _", " ^", " }"].into_iter().fold(out.trim_end().to_owned(), |text, gap| text.replace(gap, &gap[1..]))
}

fn greek(character: char) -> String {
    match GREEK.iter().find(|(letter, _)| *letter == character) {
        Some((_, name)) if name.starts_with(['-', '^']) => (*name).to_owned(),
        Some((_, name)) => format!("\\{name} "),
        None => character.to_string(),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::physics::notation;
    use crate::plan::read;
    use crate::symbolic;

    fn written(style: Style, text: &'static str) -> String {
        symbolic(move || {
            let symbols = notation::all().into_iter().map(|symbol| (symbol.name, symbol.symbol));
            Writer::new(style, symbols).expression(&read("", text).unwrap())
        })
        .unwrap()
    }

    #[test]
    fn formulas() {
        assert_eq!(written(Style::Unicode, "-EI/R^2*theta_2 + EI/R^3*x_1"), "EI x'/R³ − EI θ''/R²");
        assert_eq!(written(Style::Unicode, "cos(theta)^2/(R - x)^2"), "cos² θ/(R − x)²");
        assert_eq!(written(Style::Unicode, "tan_theta^2*theta_1^2/2"), "(θ')² tan² θ/2");
        assert_eq!(written(Style::Latex, "cos(theta)/(R - x)"), r"\frac{\cos \theta}{R - x}");
        assert_eq!(written(Style::Latex, "3/2*pi - theta1"), r"\frac{3\, \pi}{2} - \hat{\theta}'");
    }

    #[test]
    fn symbols_in_latex() {
        assert_eq!(latex("θ̂''_P1"), r"\hat{\theta}''_{P1}");
        assert_eq!(latex("L̂_o'"), r"\hat{L}_{o}'");
        assert_eq!(latex("Φ_P"), r"\Phi_{P}");
        assert_eq!(latex("tanθ"), r"\tan \theta");
    }
}
