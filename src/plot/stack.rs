//! Figures below one another, as one.

use super::figure::Figure;
#[cfg(feature = "figures")]
use super::render::{PlotError, encoded, pixels};

/// Figures of one width that share what goes to the right.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    /// Name of its files, without extension.
    pub name: String,
    /// What it shows, in a sentence.
    pub caption: String,
    /// The figures, the topmost first.
    pub panels: Vec<Figure>,
}

#[cfg(feature = "figures")]
impl Stack {
    /// All panels as one SVG.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn svg(&self) -> Result<String, PlotError> {
        let (mut inner, mut width, mut height) = (String::new(), 0, 0);
        for panel in &self.panels {
            let (wide, high) = panel.size();
            inner += &panel.svg()?.replacen("<svg ", &format!("<svg x=\"0\" y=\"{height}\" "), 1);
            (width, height) = (width.max(wide), height + high);
        }
        let name = super::render::escape(&self.caption);
        Ok(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" aria-label=\"{name}\" width=\"{width}\" \
             height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n{inner}</svg>\n"
        ))
    }

    /// All panels as one PNG, two points for one.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn png(&self) -> Result<Vec<u8>, PlotError> {
        let (mut bytes, mut width, mut height) = (Vec::new(), 0, 0);
        for panel in &self.panels {
            let (own, wide, high) = pixels(panel)?;
            bytes.extend(own);
            (width, height) = (wide, height + high);
        }
        encoded(&bytes, width, height).map_err(|reason| PlotError { figure: self.name.clone(), reason })
    }
}
