//! Compression springs.

use generated::{COMPRESSION_SPRING, CompressionSpringInput, CompressionSpringOutput};

use super::error::{ActuatorError, check};
use crate::formula::Inputs;

/// A compression spring as it is installed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Force at no travel, N: the preload.
    pub preload: f64,
    /// Rate, N/m.
    pub rate: f64,
    /// Length at no travel and solid length, m, where they are known: a spring is not compressed beyond.
    pub lengths: Option<(f64, f64)>,
}

/// A spring's force with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringForce {
    /// The force, N.
    pub value: f64,
    /// Its derivative with respect to the travel, N/m.
    pub by_travel: f64,
    /// Its derivative with respect to the rate, m.
    pub by_rate: f64,
    /// Its derivative with respect to the preload.
    pub by_preload: f64,
}

impl Spring {
    /// A spring from its free length, its rate and its length where the travel is zero, in metres and N/m.
    ///
    /// # Errors
    /// [`ActuatorError::Parameter`] for a rate that is not positive, or a spring longer than its free length.
    pub fn from_lengths(free: f64, rate: f64, installed: f64, solid: Option<f64>) -> Result<Self, ActuatorError> {
        check("the spring's rate", rate, rate > 0.0, "a positive rate in N/m")?;
        check("the spring's installed length", installed, installed > 0.0, "a positive length in m")?;
        check("the spring's free length", free, free >= installed, "at least the installed length")?;
        Ok(Self { preload: rate * (free - installed), rate, lengths: solid.map(|solid| (installed, solid)) })
    }

    /// The force where the spring is compressed further by `travel` in m.
    ///
    /// # Errors
    /// [`ActuatorError::SpringSolid`].
    pub fn force(&self, travel: f64) -> Result<SpringForce, ActuatorError> {
        use CompressionSpringInput as Input;
        if let Some((installed, solid)) = self.lengths {
            let length = installed - travel;
            if length < solid {
                return Err(ActuatorError::SpringSolid { travel, length, solid });
            }
        }
        let inputs = [(Input::Preload, self.preload), (Input::Rate, self.rate), (Input::Travel, travel)];
        let found = Inputs::new(&COMPRESSION_SPRING).with(&inputs).linearised();
        let by = |input| found.derivative(CompressionSpringOutput::Force, input);
        Ok(SpringForce {
            value: found.get(CompressionSpringOutput::Force),
            by_travel: by(Input::Travel),
            by_rate: by(Input::Rate),
            by_preload: by(Input::Preload),
        })
    }
}
