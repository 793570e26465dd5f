//! Figures as SVG and PNG.

use super::canvas::{Canvas, MARKS, plain, size};
use super::figure::Figure;
use crate::model::InternalError;
use plotters::backend::{BitMapBackend, SVGBackend};
use plotters::drawing::IntoDrawingArea;
use plotters::style::{FontStyle, WHITE, register_font};
use std::sync::Once;

/// Steps of the SVG's coordinates for one of the figure's points.
const STEPS: u32 = 10;
/// Points that a PNG has for one of the figure's.
const RESOLUTION: u32 = 2;
/// Points drawn for one of the PNG's, whose mean it is.
const SAMPLES: u32 = 3;

/// A figure that could not be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("figure `{figure}` cannot be drawn: {reason}")]
pub struct PlotError {
    /// The figure's name.
    pub figure: String,
    /// Why not.
    pub reason: String,
}

impl From<InternalError> for PlotError {
    fn from(error: InternalError) -> Self {
        Self { figure: "of the solution".into(), reason: error.to_string() }
    }
}

/// DejaVu Sans, Latin, Greek and what indices and exponents need (licenses/DejaVu-Fonts.md).
fn fonts() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        // A font that cannot be read shows when a text is drawn.
        let _ = register_font("sans-serif", FontStyle::Normal, include_bytes!("font/DejaVuSans.ttf"));
    });
}

impl Figure {
    /// The figure as SVG, with texts as texts.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn svg(&self) -> Result<String, PlotError> {
        fonts();
        let mut text = String::new();
        let (width, height) = size(self);
        let area = SVGBackend::with_string(&mut text, (width * STEPS, height * STEPS)).into_drawing_area();
        let drawn = area
            .fill(&WHITE)
            .and_then(|()| Canvas::new(self, &area, STEPS as i32, false).draw())
            .and_then(|()| area.present())
            .map_err(|error| error.to_string());
        drop(area);
        drawn.map_err(|reason| self.error(reason))?;
        let fine = format!("width=\"{}\" height=\"{}\"", width * STEPS, height * STEPS);
        let name = escape(&plain(&self.caption));
        let own = format!("role=\"img\" aria-label=\"{name}\" width=\"{width}\" height=\"{height}\"");
        let [begin, end, close] = MARKS;
        let text = text.replacen(&fine, &own, 1).replace(begin, "<tspan dy=\"0.25em\" font-size=\"72%\">");
        Ok(text.replace(end, "</tspan><tspan dy=\"-0.18em\">").replace(close, "</tspan>"))
    }

    /// Width and height.
    pub fn size(&self) -> (u32, u32) {
        size(self)
    }

    /// The figure as PNG, two points for one.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let (mean, width, height) = self.pixels()?;
        encode(&mean, width, height).map_err(|error| self.error(error.to_string()))
    }

    /// Its pixels, and how many there are across and down.
    fn pixels(&self) -> Result<(Vec<u8>, u32, u32), PlotError> {
        fonts();
        let factor = RESOLUTION * SAMPLES;
        let (width, height) = size(self);
        let (wide, high) = (width * factor, height * factor);
        // White.
        let mut fine = vec![255_u8; 3 * wide as usize * high as usize];
        {
            let area = BitMapBackend::with_buffer(&mut fine, (wide, high)).into_drawing_area();
            let drawn = Canvas::new(self, &area, factor as i32, true).draw().and_then(|()| area.present());
            drawn.map_err(|error| self.error(error.to_string()))?;
        }
        let (width, height) = (width * RESOLUTION, height * RESOLUTION);
        Ok((means(&fine, wide as usize), width, height))
    }

    fn error(&self, reason: String) -> PlotError {
        PlotError { figure: self.name.clone(), reason }
    }
}

/// The pixels of a figure, three bytes each, and how many there are across and down.
pub(super) fn pixels(figure: &Figure) -> Result<(Vec<u8>, u32, u32), PlotError> {
    figure.pixels()
}

/// Pixels as PNG.
pub(super) fn encoded(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, String> {
    encode(pixels, width, height).map_err(|error| error.to_string())
}

/// The mean of each square of samples.
fn means(fine: &[u8], wide: usize) -> Vec<u8> {
    let samples = SAMPLES as usize;
    let mut mean = Vec::with_capacity(fine.len() / (samples * samples));
    for rows in fine.chunks_exact(3 * wide * samples) {
        let mut sums = vec![[0_u32; 3]; wide / samples];
        for row in rows.chunks_exact(3 * wide) {
            for (sum, square) in sums.iter_mut().zip(row.chunks_exact(3 * samples)) {
                for pixel in square.as_chunks::<3>().0 {
                    sum.iter_mut().zip(pixel).for_each(|(sum, color)| *sum += u32::from(*color));
                }
            }
        }
        mean.extend(sums.as_flattened().iter().map(|sum| (sum / (SAMPLES * SAMPLES)) as u8));
    }
    mean
}

fn encode(pixels: &[u8], width: u32, height: u32) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(bytes)
}

/// A text within an XML attribute.
pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
