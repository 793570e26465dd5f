//! The one style in which figures are drawn.

use super::figure::{Axis, Figure, Look, Series};
use super::path::{between_corners, clipped, dashed, thinned};
use super::ticks::{Tick, decades, linear, multiples};
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind as Error};
use plotters::element::{Circle, PathElement, Rectangle, Text};
use plotters::prelude::{DrawingBackend, IntoFont, RGBColor};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, TextStyle, WHITE};

/// Colours that people of any colour vision tell apart (M. Okabe, K. Ito, "Color Universal Design", 2008).
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(60, 60, 60),
];
const INK: RGBColor = RGBColor(34, 34, 34);
const GUIDE: RGBColor = RGBColor(130, 130, 130);
const GRID: RGBColor = RGBColor(228, 228, 228);

const WIDTH: u32 = 560;
const HEIGHT: u32 = 360;
/// Around the frame: left, right, top without legend, bottom.
const MARGINS: [i32; 4] = [66, 18, 14, 48];
const TEXT: i32 = 15;
const LEGEND_LINE: i32 = 20;
const SWATCH: i32 = 24;
/// How far a line may be from its points, in the figure's points.
const THIN: f64 = 0.08;
/// Size of a subscript, and how far it stands below the line, of the text's size.
const SUBSCRIPT: (f64, f64) = (0.72, 0.18);

/// Width and height of a figure.
pub fn size(figure: &Figure) -> (u32, u32) {
    if !figure.equal {
        return (WIDTH, HEIGHT);
    }
    let [left, right, top, bottom] = MARGINS;
    let ((x0, x1), (y0, y1)) = (shown(figure, true, 8).0, shown(figure, false, 5).0);
    let inner = f64::from(WIDTH as i32 - left - right) * (y1 - y0) / (x1 - x0);
    let inner = if inner.is_finite() { inner.clamp(60.0, 900.0) } else { 300.0 };
    (WIDTH, inner.round() as u32 + (top + bottom + LEGEND_LINE) as u32)
}

/// What an axis shows, as places on it, and its ticks.
fn shown(figure: &Figure, horizontal: bool, count: usize) -> ((f64, f64), Vec<Tick>) {
    let axis = if horizontal { &figure.x } else { &figure.y };
    let values = figure.series.iter().flat_map(|series| &series.points);
    let values = values.map(|(x, y)| place(axis, if horizontal { *x } else { *y })).filter(|value| value.is_finite());
    let span = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    let given = axis.range.map(|(low, high)| (place(axis, low), place(axis, high)));
    let span = match () {
        () if axis.logarithmic => (span.0 - 0.05, span.1 + 0.05),
        () if figure.equal => (span.0 - 0.05 * (span.1 - span.0), span.1 + 0.05 * (span.1 - span.0)),
        () if horizontal => span,
        () => with_air(span),
    };
    let (low, high) = given.unwrap_or(if span.0 <= span.1 { span } else { (0.0, 1.0) });
    match axis.step {
        _ if axis.logarithmic => decades(low, high),
        Some(step) => multiples(low, high, step),
        None => linear(low, high, count, given.is_none() && !horizontal && !figure.equal),
    }
}

/// A little more than the data span, so that no line lies on the frame; but zero, if the data end there, is an end.
fn with_air((low, high): (f64, f64)) -> (f64, f64) {
    let air = 0.01 * (high - low);
    let ends = |value: f64| value.abs() < air;
    (if ends(low) { low } else { low - air }, if ends(high) { high } else { high + air })
}

/// Where a value stands on its axis.
fn place(axis: &Axis, value: f64) -> f64 {
    if axis.logarithmic { value.log10() } else { value }
}

/// Marks of a subscript in a text: where it begins, where it ends, where the text ends.
pub const MARKS: [char; 3] = ['\u{e000}', '\u{e001}', '\u{e002}'];

/// The text with its subscripts marked.
fn marked(text: &str) -> String {
    let [begin, end, close] = MARKS;
    let mut count = 0;
    let mut out = String::new();
    for (piece, below) in parts(text) {
        if below {
            count += 1;
            out.extend([begin.to_string().as_str(), piece, end.to_string().as_str()]);
        } else {
            out += piece;
        }
    }
    out.extend(std::iter::repeat_n(close, count));
    out
}

/// The text without marks: `T_slack` for `T_{slack}`.
pub fn plain(text: &str) -> String {
    parts(text).map(|(piece, below)| if below { format!("_{piece}") } else { piece.to_owned() }).collect()
}

/// The pieces of a text, and whether each is a subscript.
fn parts(text: &str) -> impl Iterator<Item = (&str, bool)> {
    let mut rest = text;
    let mut below = false;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let mark = if below { "}" } else { "_{" };
        let (piece, after) = rest.split_once(mark).unwrap_or((rest, ""));
        rest = after;
        below = !below;
        Some((piece, !below))
    })
}

/// A figure on its way to an area.
pub struct Canvas<'a, B: DrawingBackend> {
    figure: &'a Figure,
    /// Whether subscripts are drawn piece by piece, at the sizes that the area tells; otherwise they are marked in the
    /// text.
    pieces: bool,
    area: &'a DrawingArea<B, Shift>,
    /// Points of the area for one of the figure.
    scale: i32,
    x: ((f64, f64), Vec<Tick>),
    y: ((f64, f64), Vec<Tick>),
    /// Left, right, top, bottom of the frame.
    frame: [i32; 4],
}

type Drawn<B> = Result<(), Error<<B as DrawingBackend>::ErrorType>>;

impl<'a, B: DrawingBackend> Canvas<'a, B> {
    pub fn new(figure: &'a Figure, area: &'a DrawingArea<B, Shift>, scale: i32, pieces: bool) -> Self {
        let (x, y) = (shown(figure, true, 8), shown(figure, false, 5));
        let (width, height) = area.dim_in_pixel();
        let [left, right, top, bottom] = MARGINS;
        let mut canvas = Self { figure, pieces, area, scale, x, y, frame: [0; 4] };
        let lines = canvas.legend().last().map_or(0, |(_, _, line)| line + 1);
        let frame_top = (top + lines * LEGEND_LINE) * scale;
        canvas.frame = [left * scale, width as i32 - right * scale, frame_top, height as i32 - bottom * scale];
        canvas
    }

    pub fn draw(&self) -> Drawn<B> {
        self.grid()?;
        let mut next = 0;
        for series in &self.figure.series {
            let color = self.color(series, &mut next);
            self.series(series, color)?;
        }
        self.names()?;
        self.draw_legend()?;
        self.figure.marks.iter().try_for_each(|mark| self.mark(&mark.text, self.at(mark.at)))
    }

    /// A text around a point, on the colour of the paper: what it covers does not strike it through.
    fn mark(&self, text: &str, (x, y): (i32, i32)) -> Drawn<B> {
        let (across, up) = (self.width(text, TEXT) / 2 + self.scale, TEXT * self.scale / 2);
        self.area.draw(&Rectangle::new([(x - across, y - up), (x + across, y + up)], WHITE.filled()))?;
        self.write(text, (x, y), TEXT, HPos::Center, VPos::Center)
    }

    fn color(&self, series: &Series, next: &mut usize) -> RGBColor {
        if series.look == Look::Guide {
            return GUIDE;
        }
        let number = series.color.unwrap_or(*next);
        if series.color.is_none() {
            *next += 1;
        }
        PALETTE.get(number % PALETTE.len()).copied().unwrap_or(INK)
    }

    /// Where a point of the axes lies in the area, without rounding.
    fn exact(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let [left, right, top, bottom] = self.frame.map(f64::from);
        let part = |axis: &Axis, (low, high): (f64, f64), value: f64| (place(axis, value) - low) / (high - low);
        let (u, v) = (part(&self.figure.x, self.x.0, x), part(&self.figure.y, self.y.0, y));
        (left + u * (right - left), bottom + v * (top - bottom))
    }

    fn at(&self, point: (f64, f64)) -> (i32, i32) {
        let (x, y) = self.exact(point);
        (x.round() as i32, y.round() as i32)
    }

    /// Writes a text in which `_{..}` is a subscript.
    fn write(&self, text: &str, (x, y): (i32, i32), size: i32, horizontal: HPos, vertical: VPos) -> Drawn<B> {
        if !self.pieces {
            let style = self.text(size).pos(Pos::new(horizontal, vertical));
            return self.area.draw(&Text::new(marked(text), (x, y), style));
        }
        // The area centres a line's box, which is higher above the letters' middle than below.
        let lower = if matches!(vertical, VPos::Center) { size * self.scale / 6 } else { 0 };
        let width = self.width(text, size);
        let x = match horizontal {
            HPos::Left => x,
            HPos::Center => x - width / 2,
            HPos::Right => x - width,
        };
        self.write_pieces(text, size, |style, along, drop| {
            ((x + along, y + lower + drop), style.pos(Pos::new(HPos::Left, vertical)))
        })
    }

    /// Writes such a text upwards, its middle beside a point.
    fn write_upwards(&self, text: &str, (x, y): (i32, i32), size: i32) -> Drawn<B> {
        let turned = FontTransform::Rotate270;
        if !self.pieces {
            let style = self.text(size).pos(Pos::new(HPos::Center, VPos::Top)).transform(turned);
            return self.area.draw(&Text::new(marked(text), (x, y), style));
        }
        let start = y + self.width(text, size) / 2;
        self.write_pieces(text, size, |style, along, drop| {
            ((x + drop, start - along), style.pos(Pos::new(HPos::Left, VPos::Top)).transform(turned.clone()))
        })
    }

    /// Draws the pieces of a text where `at` puts each of them, by how far along the text and how much lower it stands.
    fn write_pieces<'s>(
        &self,
        text: &str,
        size: i32,
        at: impl Fn(TextStyle<'s>, i32, i32) -> ((i32, i32), TextStyle<'s>),
    ) -> Drawn<B> {
        let mut along = 0;
        for (piece, below) in parts(text) {
            let (height, drop) = self.sizes(size, below);
            let (point, style) = at(self.sized(height), along, drop);
            self.area.draw(&Text::new(piece.to_owned(), point, style))?;
            along += self.extent(piece, height);
        }
        Ok(())
    }

    /// Height of a piece of text, and how much lower it stands.
    fn sizes(&self, size: i32, below: bool) -> (f64, i32) {
        let whole = f64::from(size * self.scale);
        if below {
            (SUBSCRIPT.0 * whole, ((SUBSCRIPT.1 + 0.5 * (1.0 - SUBSCRIPT.0)) * whole).round() as i32)
        } else {
            (whole, 0)
        }
    }

    fn width(&self, text: &str, size: i32) -> i32 {
        parts(text).map(|(piece, below)| self.extent(piece, self.sizes(size, below).0)).sum()
    }

    fn extent(&self, piece: &str, height: f64) -> i32 {
        self.area.estimate_text_size(piece, &self.sized(height)).map_or(0, |(width, _)| width as i32)
    }

    fn sized(&self, height: f64) -> TextStyle<'static> {
        ("sans-serif", height).into_font().color(&INK)
    }

    fn text(&self, size: i32) -> TextStyle<'static> {
        ("sans-serif", size * self.scale).into_font().color(&INK)
    }

    fn line(&self, points: &[(i32, i32)], color: RGBColor, width: f64) -> Drawn<B> {
        let stroke = (width * f64::from(self.scale)).round().max(1.0) as u32;
        // A mitre of two segments that meet at a sharp angle stands out far beyond the point: rounded joins do not.
        let parts = between_corners(points);
        for corner in parts.iter().skip(1).filter_map(|part| part.first()) {
            self.area.draw(&Circle::new(*corner, (stroke as i32 + 1) / 2, color.filled()))?;
        }
        for part in parts {
            self.area.draw(&PathElement::new(part, color.stroke_width(stroke)))?;
        }
        Ok(())
    }

    fn grid(&self) -> Drawn<B> {
        let [left, right, top, bottom] = self.frame;
        let along = |((low, high), ticks): &((f64, f64), Vec<Tick>), from: i32, to: i32| {
            let spot = |tick: f64| from + ((tick - low) / (high - low) * f64::from(to - from)).round() as i32;
            ticks.iter().map(|(tick, text)| (spot(*tick), text.clone())).collect::<Vec<_>>()
        };
        let (columns, rows) = (along(&self.x, left, right), along(&self.y, bottom, top));
        for (x, _) in &columns {
            self.line(&[(*x, top), (*x, bottom)], GRID, 1.0)?;
        }
        for (y, _) in &rows {
            self.line(&[(left, *y), (right, *y)], GRID, 1.0)?;
        }
        let gap = 5 * self.scale;
        for (x, text) in columns {
            self.write(&text, (x, bottom + gap), TEXT - 1, HPos::Center, VPos::Top)?;
        }
        for (y, text) in rows {
            self.write(&text, (left - gap, y), TEXT - 1, HPos::Right, VPos::Center)?;
        }
        let frame = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        self.line(&frame, INK, 1.0)
    }

    /// The names of the axes.
    fn names(&self) -> Drawn<B> {
        let [left, right, top, bottom] = self.frame;
        let below = ((left + right) / 2, bottom + 25 * self.scale);
        self.write(&self.figure.x.label, below, TEXT, HPos::Center, VPos::Top)?;
        self.write_upwards(&self.figure.y.label, (6 * self.scale, (top + bottom) / 2), TEXT)
    }

    fn series(&self, series: &Series, color: RGBColor) -> Drawn<B> {
        let scale = f64::from(self.scale);
        let frame = self.frame.map(f64::from);
        if series.look == Look::Dots {
            return self.dots(series, color, 4.0);
        }
        if series.marked {
            self.dots(series, color, 2.5)?;
        }
        let exact: Vec<(f64, f64)> = series.points.iter().map(|point| self.exact(*point)).collect();
        for part in clipped(&exact, frame) {
            let part = thinned(&part, THIN * scale);
            let (pieces, width) = match series.look {
                Look::Dashed => (dashed(&part, 6.0 * scale, 4.0 * scale), 1.8),
                Look::Guide => (dashed(&part, 3.0 * scale, 3.0 * scale), 1.0),
                Look::Line | Look::Dots => (vec![part], 1.8),
            };
            for piece in pieces {
                let points: Vec<_> = piece.iter().map(|(x, y)| (x.round() as i32, y.round() as i32)).collect();
                self.line(&points, color, width)?;
            }
        }
        Ok(())
    }

    fn dots(&self, series: &Series, color: RGBColor, radius: f64) -> Drawn<B> {
        let radius = (radius * f64::from(self.scale)).round() as i32;
        let places = series.points.iter().map(|point| self.exact(*point));
        for (x, y) in places.filter(|(x, y)| x.is_finite() && y.is_finite()) {
            self.area.draw(&Circle::new((x.round() as i32, y.round() as i32), radius, color.filled()))?;
        }
        Ok(())
    }

    /// The entries of the legend: series, left edge, line.
    fn legend(&self) -> Vec<(&'a Series, i32, i32)> {
        let [left, right, ..] = MARGINS.map(|margin| margin * self.scale);
        let end = self.area.dim_in_pixel().0 as i32 - right;
        let (mut x, mut line) = (left, 0);
        let mut entries = Vec::new();
        for series in self.figure.series.iter().filter(|series| !series.label.is_empty()) {
            let width = self.width(&series.label, TEXT) + (SWATCH + 22) * self.scale;
            if x + width - 16 * self.scale > end && x > left {
                (x, line) = (left, line + 1);
            }
            entries.push((series, x, line));
            x += width;
        }
        entries
    }

    fn draw_legend(&self) -> Drawn<B> {
        let mut colors = Vec::new();
        let mut next = 0;
        for series in &self.figure.series {
            colors.push((series, self.color(series, &mut next)));
        }
        for (series, x, line) in self.legend() {
            let color = colors.iter().find(|(other, _)| std::ptr::eq(*other, series)).map_or(INK, |(_, color)| *color);
            let y = (MARGINS[2] - 5 + line * LEGEND_LINE + LEGEND_LINE / 2) * self.scale;
            let end = x + SWATCH * self.scale;
            match series.look {
                Look::Dots => self.area.draw(&Circle::new(((x + end) / 2, y), 4 * self.scale, color.filled()))?,
                look => {
                    let on_off = if look == Look::Guide { (3.0, 3.0) } else { (6.0, 4.0) };
                    let (a, b) = ((f64::from(x), f64::from(y)), (f64::from(end), f64::from(y)));
                    let scale = f64::from(self.scale);
                    let pieces = match look {
                        Look::Line => vec![vec![a, b]],
                        _ => dashed(&[a, b], on_off.0 * scale, on_off.1 * scale),
                    };
                    for piece in pieces {
                        let points: Vec<_> = piece.iter().map(|(x, y)| (x.round() as i32, y.round() as i32)).collect();
                        self.line(&points, color, if look == Look::Guide { 1.0 } else { 1.8 })?;
                    }
                }
            }
            self.write(&series.label, (end + 6 * self.scale, y), TEXT, HPos::Left, VPos::Center)?;
        }
        Ok(())
    }
}
