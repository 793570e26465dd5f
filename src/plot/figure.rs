//! What is drawn, without how.

/// One axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity, symbol and unit.
    pub label: String,
    /// Whether equal distances are equal ratios.
    pub logarithmic: bool,
    /// What is shown; what the data span if it is not given.
    pub range: Option<(f64, f64)>,
    /// Distance of the ticks; a round number that suits the range if it is not given. Whole units, linear axes only.
    pub step: Option<f64>,
}

impl Axis {
    /// A linear axis over the data.
    pub fn new(label: impl Into<String>) -> Self {
        Self { label: label.into(), logarithmic: false, range: None, step: None }
    }

    /// A logarithmic axis over the data.
    pub fn log(label: impl Into<String>) -> Self {
        Self { logarithmic: true, ..Self::new(label) }
    }

    /// The axis with its ticks at the multiples of a step.
    #[must_use]
    pub fn every(mut self, step: f64) -> Self {
        self.step = Some(step);
        self
    }

    /// The axis with its range fixed.
    #[must_use]
    pub fn over(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }
}

/// How a series looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// A line.
    Line,
    /// A dashed line.
    Dashed,
    /// A thin dashed line in grey, for what only guides the eye.
    Guide,
    /// Round dots.
    Dots,
}

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Its name in the legend; not in it if empty.
    pub label: String,
    /// Its colour, by number; series count up from 0 by themselves.
    pub color: Option<usize>,
    /// How it looks.
    pub look: Look,
    /// In the units of the axes; a line is broken where a number is missing.
    pub points: Vec<(f64, f64)>,
    /// Whether a line shows its points.
    pub marked: bool,
}

impl Series {
    /// A line.
    pub fn line(label: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), color: None, look: Look::Line, points, marked: false }
    }

    /// The series with another look.
    #[must_use]
    pub fn look(mut self, look: Look) -> Self {
        self.look = look;
        self
    }

    /// The line with its points shown.
    #[must_use]
    pub fn marked(mut self) -> Self {
        self.marked = true;
        self
    }

    /// The series in a colour of the palette.
    #[must_use]
    pub fn color(mut self, color: usize) -> Self {
        self.color = Some(color);
        self
    }
}

/// A text at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Where, in the units of the axes: the middle of the text.
    pub at: (f64, f64),
    /// What.
    pub text: String,
}

/// One figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Name of its files, without extension.
    pub name: String,
    /// What it shows, in a sentence.
    pub caption: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// What is drawn, in this order.
    pub series: Vec<Series>,
    /// Texts.
    pub marks: Vec<Mark>,
    /// Whether a unit is as long on both axes.
    pub equal: bool,
}

impl Figure {
    /// A figure without marks and with independent axes.
    pub fn new(name: impl Into<String>, caption: impl Into<String>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self { name: name.into(), caption: caption.into(), x, y, series, marks: Vec::new(), equal: false }
    }
}
