//! Operating points: windows of samples in which nothing changes, averaged.

use super::spectrum::{Order, Spectrum};
use super::{CHANNELS, Options};
use crate::bench::statistics::{Average, BATCHES, LEAST_MEASURED};
use crate::quantity::{Unit, rpm};
use serde::Serialize;

/// What makes a window steady; shares of the mean over the window.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Criteria {
    /// Largest trend of a speed.
    pub speed_trend: f64,
    /// Largest trend of the torque.
    pub torque_trend: f64,
    /// Largest standard deviation of a speed.
    pub speed_deviation: f64,
    /// Largest standard deviation of the torque: firing alone makes 15 to 35 % of it on the thesis's dynamometer.
    pub torque_deviation: f64,
}

impl Default for Criteria {
    fn default() -> Self {
        Self { speed_trend: 0.01, torque_trend: 0.1, speed_deviation: 0.02, torque_deviation: 0.4 }
    }
}

/// A value with its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Estimate {
    /// Value.
    pub value: f64,
    /// Standard error.
    pub error: f64,
}

/// One operating point, SI.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SteadyPoint {
    /// Which record it is from.
    pub record: String,
    /// Number of the step, for a record that is one step of a test.
    pub step: Option<u64>,
    /// Beginning, s.
    pub start: f64,
    /// s.
    pub duration: f64,
    /// ω_P, rad/s.
    pub primary_speed: Option<Average>,
    /// ω_S, rad/s.
    pub secondary_speed: Option<Average>,
    /// Torque out of the secondary, N·m; its error is that of the samples alone.
    pub secondary_torque: Option<Average>,
    /// ω_P/ω_S.
    pub speed_ratio: Option<f64>,
    /// ω_S M_out with the uncertainty of samples and calibration, W.
    pub output_power: Option<Estimate>,
    /// What the engine's curve says at ω_P, W.
    pub input_power: Option<Estimate>,
    /// Output over input power.
    pub efficiency: Option<Estimate>,
    /// Whether it is steady.
    pub steady: bool,
    /// Why it is not, or what could not be computed.
    pub reason: Option<String>,
    /// Lines of the torque's spectrum that shafts are expected to make.
    pub orders: Vec<Order>,
    /// The spectrum of the torque.
    #[serde(skip)]
    pub spectrum: Option<Spectrum>,
    /// The samples of the torque, N·m.
    #[serde(skip)]
    pub torque_samples: Vec<f64>,
}

/// Rise over all samples of the line through them.
fn trend(samples: &[f64]) -> f64 {
    let n = samples.len() as f64;
    let middle = 0.5 * (n - 1.0);
    let mean = samples.iter().sum::<f64>() / n;
    let (mut up, mut down) = (0.0, 0.0);
    for (at, value) in samples.iter().enumerate() {
        let x = at as f64 - middle;
        up += x * (value - mean);
        down += x * x;
    }
    up / down * (n - 1.0)
}

/// Why samples are not steady, if they are not.
fn unsteady(name: &str, samples: &[f64], average: &Average, trend_limit: f64, deviation_limit: f64) -> Option<String> {
    let size = average.mean.abs();
    let trend = trend(samples).abs();
    if trend > trend_limit * size {
        return Some(format!("{name} changes by {:.1} % of its mean", 100.0 * trend / size));
    }
    let deviation = average.deviation;
    (deviation > deviation_limit * size)
        .then(|| format!("{name} has a standard deviation of {:.1} % of its mean", 100.0 * deviation / size))
}

impl SteadyPoint {
    /// A point from uniform samples by channel, and how many were measured of each: speeds in rpm, torque in N·m as
    /// measured.
    pub fn of(
        record: &str,
        step: Option<u64>,
        start: f64,
        (samples, measured): (&[Vec<f64>; CHANNELS], [usize; CHANNELS]),
        options: &Options,
    ) -> Self {
        let [primary, secondary, torque] = samples;
        let scaled =
            |samples: &[f64], factor: f64| -> Vec<f64> { samples.iter().map(|value| value * factor).collect() };
        let factor = Unit::RPM.in_si();
        let primary = scaled(primary, factor);
        let secondary = scaled(secondary, factor * options.secondary_factor);
        let torque = scaled(torque, if options.torque_at_sensor { options.gear } else { 1.0 });
        let count = primary.len().max(secondary.len());
        let [of_primary, of_secondary, of_torque] = measured;
        let averages = [(&primary, of_primary), (&secondary, of_secondary), (&torque, of_torque)]
            .map(|(samples, measured)| Average::interpolated(samples, measured));
        let criteria = &options.criteria;
        let checks = [
            ("the primary's speed", &primary, criteria.speed_trend, criteria.speed_deviation),
            ("the secondary's speed", &secondary, criteria.speed_trend, criteria.speed_deviation),
            ("the torque", &torque, criteria.torque_trend, criteria.torque_deviation),
        ];
        let few = checks.iter().zip(measured).find_map(|((name, samples, ..), measured)| {
            (!samples.is_empty() && measured < LEAST_MEASURED).then(|| {
                format!(
                    "{name} has {measured} measured samples, too few for a standard error: expected {LEAST_MEASURED} \
                     or more (a longer --window)"
                )
            })
        });
        let unsteady = || {
            checks.iter().zip(&averages).find_map(|((name, samples, trend, deviation), average)| {
                unsteady(name, samples, average.as_ref()?, *trend, *deviation)
            })
        };
        let reason = few.or_else(unsteady);
        let speeds = || averages[..2].iter().flatten();
        let stands = speeds().next().is_some() && speeds().all(|speed| speed.mean == 0.0);
        let reason = reason.or_else(|| stands.then(|| "no pulley turns".to_owned()));
        let [primary_speed, secondary_speed, secondary_torque] = averages;
        let steady = reason.is_none() && primary_speed.or(secondary_speed).is_some();
        let mut point = Self {
            record: record.to_owned(),
            step,
            start,
            duration: count as f64 / options.rate,
            primary_speed,
            secondary_speed,
            secondary_torque,
            speed_ratio: primary_speed.zip(secondary_speed).map(|(p, s)| p.mean / s.mean).filter(|r| r.is_finite()),
            output_power: None,
            input_power: None,
            efficiency: None,
            steady,
            reason,
            orders: Vec::new(),
            spectrum: None,
            torque_samples: torque,
        };
        point.powers(options);
        point.order(options);
        point
    }

    /// Parts of which the point's standard errors are made: the fewest of its channels, which widens intervals most.
    pub fn parts(&self) -> usize {
        let averages = [self.primary_speed, self.secondary_speed, self.secondary_torque];
        averages.iter().flatten().map(|average| average.parts).min().unwrap_or(BATCHES)
    }

    /// Powers and efficiency, with the errors of independent quantities propagated to first order.
    fn powers(&mut self, options: &Options) {
        if let (Some(speed), Some(torque)) = (self.secondary_speed, self.secondary_torque) {
            let at_secondary = if options.torque_at_sensor { options.gear } else { 1.0 };
            let calibration = options.calibration.map_or(0.0, |line| {
                let measured = torque.mean / at_secondary;
                line.inverse_variance(line.intercept + line.slope * measured) * at_secondary.powi(2)
            });
            let variance = torque.error.powi(2) + calibration;
            let error = (variance * speed.mean.powi(2) + (torque.mean * speed.error).powi(2)).sqrt();
            self.output_power = Some(Estimate { value: torque.mean * speed.mean, error });
        }
        if let (Some(speed), Some(engine)) = (self.primary_speed, &options.engine) {
            match engine.power(speed.mean) {
                Some((value, slope)) => self.input_power = Some(Estimate { value, error: (slope * speed.error).abs() }),
                None if self.reason.is_none() => {
                    let (low, high) = engine.range();
                    self.reason = Some(format!(
                        "the engine's curve covers {low:.0} to {high:.0} rpm, and the primary turns at {:.0}",
                        rpm(speed.mean)
                    ));
                }
                None => {}
            }
        }
        if let (Some(output), Some(input)) = (self.output_power, self.input_power.filter(|input| input.value > 0.0)) {
            let value = output.value / input.value;
            let error = ((output.error / input.value).powi(2) + (value * input.error / input.value).powi(2)).sqrt();
            self.efficiency = Some(Estimate { value, error });
        }
    }

    fn order(&mut self, options: &Options) {
        if let (Some(primary), Some(secondary), Some(_)) =
            (self.primary_speed, self.secondary_speed, self.secondary_torque)
        {
            let spectrum = Spectrum::of(&self.torque_samples, options.rate);
            self.orders = spectrum.orders(primary.mean, secondary.mean, options.revolutions, options.gear);
            self.spectrum = Some(spectrum);
        }
    }

    /// Without what is only needed for a figure.
    pub fn forget_samples(&mut self) {
        self.spectrum = None;
        self.torque_samples = Vec::new();
    }
}
