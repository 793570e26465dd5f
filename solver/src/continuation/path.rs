//! Paths through the given constants.

/// A curve `constants(λ)`, `λ` from 0 to 1.
pub trait Path {
    /// Writes the constants that vary; leaves the others.
    fn constants(&self, lambda: f64, constants: &mut [f64]);

    /// Writes d(constant)/dλ of those that vary; the others stay 0.
    fn slope(&self, lambda: f64, slope: &mut [f64]);

    /// Bends a prediction: `predicted` are the constants on the tangent at the solution with constants `from`, given
    /// and unknown alike. Where a product of constants matters more than each of them, its curvature can be put right
    /// here.
    fn bend(&self, from: &[f64], predicted: &mut [f64]) {
        let _ = (from, predicted);
    }

    /// Indices of the constants that vary, where they are known beforehand: a continuation refuses those that the
    /// layout does not have, or that are unknowns.
    fn varied(&self) -> Vec<usize> {
        Vec::new()
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Law {
    Linear,
    Geometric,
}

/// Several constants that move together, each linearly or geometrically.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Ramp {
    stages: Vec<(usize, f64, f64, Law)>,
}

impl Ramp {
    /// A path on which nothing moves.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lets a constant (index in the layout) go in proportion to λ.
    #[must_use]
    pub fn linear(mut self, constant: usize, from: f64, to: f64) -> Self {
        self.stages.push((constant, from, to, Law::Linear));
        self
    }

    /// Lets a constant's logarithm go in proportion to λ. Ends of unlike sign, or zero, make it linear.
    #[must_use]
    pub fn geometric(mut self, constant: usize, from: f64, to: f64) -> Self {
        let law = if from != 0.0 && to != 0.0 && (from > 0.0) == (to > 0.0) { Law::Geometric } else { Law::Linear };
        self.stages.push((constant, from, to, law));
        self
    }
}

impl Path for Ramp {
    fn varied(&self) -> Vec<usize> {
        self.stages.iter().map(|&(constant, ..)| constant).collect()
    }

    fn constants(&self, lambda: f64, constants: &mut [f64]) {
        for &(index, from, to, law) in &self.stages {
            let Some(constant) = constants.get_mut(index) else { continue };
            *constant = match law {
                _ if lambda == 1.0 => to,
                Law::Linear => from + lambda * (to - from),
                Law::Geometric => from * libm::pow(to / from, lambda),
            };
        }
    }

    fn slope(&self, lambda: f64, slope: &mut [f64]) {
        for &(index, from, to, law) in &self.stages {
            let Some(slope) = slope.get_mut(index) else { continue };
            *slope = match law {
                Law::Linear => to - from,
                Law::Geometric => from * libm::pow(to / from, lambda) * libm::log(to / from),
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithm_that_does_not_exist_makes_the_ramp_linear() {
        for (from, to, middle) in
            [(1.0, 4.0, 2.0), (-1.0, -4.0, -2.0), (0.0, 3.0, 1.5), (3.0, 0.0, 1.5), (-1.0, 3.0, 1.0)]
        {
            let ramp = Ramp::new().geometric(0, from, to);
            let at = |lambda: f64| {
                let mut constants = [9.0];
                ramp.constants(lambda, &mut constants);
                constants[0]
            };
            let (mut slope, h) = ([9.0], 1e-6);
            ramp.slope(0.5, &mut slope);
            assert!((at(0.5) - middle).abs() < 1e-14, "{from} to {to}: {}", at(0.5));
            assert_eq!((at(0.0), at(1.0)), (from, to));
            assert!((slope[0] - (at(0.5 + h) - at(0.5 - h)) / (2.0 * h)).abs() < 1e-8, "{from} to {to}");
        }
    }
}
