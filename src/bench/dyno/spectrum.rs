//! The spectrum of the torque, and which shafts are in it.

use rustfft::FftPlanner;
use rustfft::num_complex::Complex;
use serde::Serialize;

/// A line that a shaft is expected to make.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Order {
    /// What turns.
    pub name: &'static str,
    /// Hz.
    pub frequency: f64,
    /// Amplitude of the largest line within one resolution of it, N·m; `None` beyond half the sampling rate.
    pub amplitude: Option<f64>,
}

/// Single-sided amplitudes of samples without their mean.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Spectrum {
    /// Hz between lines.
    pub resolution: f64,
    /// Amplitudes, from the first line above zero on: a sine of amplitude 1 at a line gives 1.
    pub amplitudes: Vec<f64>,
}

impl Spectrum {
    /// Of equally spaced samples, `rate` in a second.
    pub fn of(samples: &[f64], rate: f64) -> Self {
        let count = samples.len();
        let mean = samples.iter().sum::<f64>() / count.max(1) as f64;
        let mut values: Vec<Complex<f64>> = samples.iter().map(|value| Complex::new(value - mean, 0.0)).collect();
        if count > 1 {
            FftPlanner::new().plan_fft_forward(count).process(&mut values);
        }
        let half = count / 2;
        let amplitude = |(at, value): (usize, &Complex<f64>)| {
            // The line at half the rate stands alone; every other has a twin.
            let twin = if 2 * (at + 1) == count { 1.0 } else { 2.0 };
            twin * value.norm() / count as f64
        };
        let amplitudes = values.iter().skip(1).take(half).enumerate().map(amplitude).collect();
        Self { resolution: rate / count.max(1) as f64, amplitudes }
    }

    /// Largest amplitude within one resolution of a frequency.
    pub fn near(&self, frequency: f64) -> Option<f64> {
        let line = (frequency / self.resolution).round();
        if !(line >= 1.0 && line <= self.amplitudes.len() as f64) {
            return None;
        }
        let at = line as usize - 1;
        let around = self.amplitudes.get(at.saturating_sub(1)..(at + 2).min(self.amplitudes.len()))?;
        around.iter().copied().reduce(f64::max)
    }

    /// The lines of an engine that fires every `revolutions` turns, of both pulleys, and of a shaft that turns
    /// `brake` times as fast as the secondary; speeds in rad/s.
    pub fn orders(&self, primary: f64, secondary: f64, revolutions: f64, brake: f64) -> Vec<Order> {
        let turns = |speed: f64| speed / std::f64::consts::TAU;
        let order = |name, frequency| Order { name, frequency, amplitude: self.near(frequency) };
        let mut orders = vec![
            order("firing", turns(primary) / revolutions),
            order("primary shaft", turns(primary)),
            order("secondary shaft", turns(secondary)),
        ];
        if brake != 1.0 {
            orders.push(order("brake shaft", brake * turns(secondary)));
        }
        orders
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn sines_come_out_with_their_amplitudes() {
        let sine = |at: u32| {
            let time = f64::from(at) / 125.0;
            40.0 + 7.0 * (TAU * 25.0 * time).sin() + 2.0 * (TAU * 13.0 * time + 1.0).cos()
        };
        let samples: Vec<f64> = (0..375).map(sine).collect();
        let spectrum = Spectrum::of(&samples, 125.0);
        assert!((spectrum.near(25.0).unwrap() - 7.0).abs() < 1e-9);
        assert!((spectrum.near(13.0).unwrap() - 2.0).abs() < 1e-9);
        assert!(spectrum.near(40.0).unwrap() < 1e-9);
        assert_eq!((spectrum.near(0.0), spectrum.near(80.0)), (None, None));
        // Parseval: the variance is half the sum of squares.
        let variance = (7.0f64.powi(2) + 2.0f64.powi(2)) / 2.0;
        let sum = spectrum.amplitudes.iter().map(|a| a * a).sum::<f64>() / 2.0;
        assert!((sum - variance).abs() < 1e-9);
        assert!(Spectrum::of(&[], 1.0).amplitudes.is_empty() && Spectrum::of(&[1.0], 1.0).amplitudes.is_empty());
    }

    #[test]
    fn orders_are_those_of_the_thesis() {
        // Figures 9.7 and 9.8: 2991 and 1585 rpm, firing at 24.9 Hz, rotor at 13.9 Hz, gears 32:61.
        let rpm = TAU / 60.0;
        let orders = Spectrum::of(&[0.0; 375], 125.0).orders(2991.0 * rpm, 1585.0 * rpm, 2.0, 32.0 / 61.0);
        let [firing, _, _, brake] = orders.as_slice() else { panic!("{orders:?}") };
        assert!((firing.frequency - 24.9).abs() < 0.05 && (brake.frequency - 13.9).abs() < 0.05, "{orders:?}");
    }
}
