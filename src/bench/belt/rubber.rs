//! Moduli of the rubber over temperature.

use crate::bench::error::BenchError;
use crate::bench::sheet::Sheet;
use crate::quantity::celsius;
use serde::Serialize;

/// Storage over loss modulus from which on the elastic model is a fair one: the thesis relies on 8.2 (section 4.1).
const ELASTIC: f64 = 5.0;

/// One test of the rubber, SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Test {
    /// K.
    pub temperature: f64,
    /// G', Pa; not known where Young's modulus was given.
    pub storage_modulus: Option<f64>,
    /// G'', Pa.
    pub loss_modulus: Option<f64>,
    /// E = 2 G' (1 + ν) (4.3), Pa.
    pub youngs_modulus: f64,
    /// G'/G''.
    pub storage_over_loss: Option<f64>,
}

/// The rubber: tests in the order of their temperatures.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Rubber {
    /// ν.
    pub poisson_ratio: f64,
    /// Tests.
    pub tests: Vec<Test>,
}

/// The rubber at a temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct AtTemperature {
    /// K.
    pub temperature: f64,
    /// G', Pa.
    pub storage_modulus: Option<f64>,
    /// E, Pa.
    pub youngs_modulus: f64,
    /// G'/G''.
    pub storage_over_loss: Option<f64>,
}

impl Rubber {
    /// Reads `[rubber]` and its tests; `None` without any.
    ///
    /// # Errors
    /// A test without a modulus, or with two, or with two losses; two tests of one temperature.
    pub fn read(sheet: &Sheet, warnings: &mut Vec<String>) -> Result<Option<Self>, BenchError> {
        let poisson_ratio = sheet.get("rubber.poisson_ratio").unwrap_or(0.5);
        let mut tests = (0..sheet.count("rubber.test"))
            .map(|at| test(sheet, &format!("rubber.test.{at}"), poisson_ratio))
            .collect::<Result<Vec<Test>, BenchError>>()?;
        if tests.is_empty() {
            return match sheet.get("rubber.poisson_ratio") {
                Some(_) => Err(sheet.unusable("rubber.poisson_ratio", "there is no [[rubber.test]]: leave it out")),
                None => Ok(None),
            };
        }
        tests.sort_by(|a, b| a.temperature.total_cmp(&b.temperature));
        if let Some(pair) = tests.windows(2).find(|pair| pair[0].temperature == pair[1].temperature) {
            let reason = format!("two tests at {:.2} °C", celsius(pair[0].temperature));
            return Err(sheet.unusable("rubber.test.0.temperature", reason));
        }
        for test in &tests {
            if let Some(ratio) = test.storage_over_loss.filter(|ratio| *ratio < ELASTIC) {
                warnings.push(format!(
                    "at {:.1} °C the storage modulus is only {ratio:.2} times the loss modulus; below {ELASTIC} an \
                     elastic belt is a poor model of the rubber",
                    celsius(test.temperature)
                ));
            }
        }
        if tests.iter().all(|test| test.storage_over_loss.is_none()) {
            warnings.push(
                "no loss modulus is given: whether the rubber is nearly elastic is not checked, and a case has the \
                 loss tangent of the thesis's rubber"
                    .into(),
            );
        }
        if sheet.get("rubber.poisson_ratio").is_some() && tests.iter().all(|test| test.storage_modulus.is_none()) {
            let reason = "it makes Young's modulus of a modulus in shear, and none is given: leave it out";
            return Err(sheet.unusable("rubber.poisson_ratio", reason));
        }
        Ok(Some(Self { poisson_ratio, tests }))
    }

    /// Share by which E falls per kelvin from the coldest test to the warmest, 1/K; nothing of a single test, or of a
    /// rubber that stiffens as it warms.
    pub fn softening(&self) -> Option<f64> {
        let (first, last) = (self.tests.first()?, self.tests.last()?);
        let softening = (first.youngs_modulus / last.youngs_modulus).ln() / (last.temperature - first.temperature);
        Some(softening).filter(|softening| *softening >= 0.0)
    }

    /// The rubber at a temperature in K: between two tests, moduli are geometric means, ln E linear in the temperature.
    /// This is exact at the tests, never negative, and levels off as measured moduli do.
    ///
    /// # Errors
    /// A temperature outside the tests: nothing is extrapolated.
    pub fn at(&self, sheet: &Sheet, temperature: f64) -> Result<AtTemperature, BenchError> {
        let tests = &self.tests;
        let range = || {
            let [first, last] = [tests.first(), tests.last()].map(|t| t.map_or(f64::NAN, |t| celsius(t.temperature)));
            let reason = format!(
                "the rubber was tested from {first:.1} °C to {last:.1} °C, and {:.1} °C lies outside; moduli are not \
                 extrapolated",
                celsius(temperature)
            );
            sheet.unusable("temperature", reason).advise("test the rubber there, or choose a temperature between")
        };
        if let Some(test) = tests.iter().find(|test| (test.temperature - temperature).abs() < 1e-6) {
            let Test { storage_modulus, youngs_modulus, storage_over_loss, .. } = *test;
            return Ok(AtTemperature { temperature, storage_modulus, youngs_modulus, storage_over_loss });
        }
        let between = |pair: &&[Test]| pair[0].temperature < temperature && temperature < pair[1].temperature;
        let Some([a, b]) = tests.windows(2).find(between) else { return Err(range()) };
        let share = (temperature - a.temperature) / (b.temperature - a.temperature);
        let mean = |a: f64, b: f64| (a.ln() + share * (b.ln() - a.ln())).exp();
        let both = |a: Option<f64>, b: Option<f64>| Some(mean(a?, b?));
        Ok(AtTemperature {
            temperature,
            storage_modulus: both(a.storage_modulus, b.storage_modulus),
            youngs_modulus: mean(a.youngs_modulus, b.youngs_modulus),
            storage_over_loss: both(a.storage_over_loss, b.storage_over_loss),
        })
    }
}

fn test(sheet: &Sheet, path: &str, poisson_ratio: f64) -> Result<Test, BenchError> {
    let key = |name: &str| format!("{path}.{name}");
    let get = |name: &str| sheet.get(&key(name));
    let temperature = sheet.need(&key("temperature"))?;
    let amplitude = ["stress_amplitude", "strain_amplitude", "phase"].into_iter().any(|name| get(name).is_some());
    let ways = [get("storage_modulus").is_some(), amplitude, get("youngs_modulus").is_some()];
    if ways.iter().filter(|given| **given).count() > 1 {
        let reason =
            "give the storage modulus, or the amplitudes with their phase, or Young's modulus, and one of these only";
        return Err(sheet.unusable(&key("temperature"), reason));
    }
    let loss = get("loss_modulus").is_some();
    let reason = match (get("storage_over_loss").is_some(), loss) {
        (true, true) => Some("the ratio of both moduli is given, too: leave one out"),
        (_, true) if get("youngs_modulus").is_some() => Some("it belongs to a storage modulus: give storage_over_loss"),
        (ratio, loss) if amplitude && (ratio || loss) => Some("it follows from the phase: leave it out"),
        _ => None,
    };
    if let Some(reason) = reason {
        return Err(sheet.unusable(&key(if loss { "loss_modulus" } else { "storage_over_loss" }), reason));
    }
    if let Some(youngs_modulus) = get("youngs_modulus") {
        let storage_over_loss = get("storage_over_loss");
        return Ok(Test { temperature, storage_modulus: None, loss_modulus: None, youngs_modulus, storage_over_loss });
    }
    let (storage, loss) = if amplitude {
        let modulus = sheet.need(&key("stress_amplitude"))? / sheet.need(&key("strain_amplitude"))?;
        let phase = sheet.need(&key("phase"))?;
        (modulus * phase.cos(), Some(modulus * phase.sin())) // (4.1), (4.2)
    } else {
        let storage = sheet.need(&key("storage_modulus"))?;
        (storage, get("loss_modulus").or(get("storage_over_loss").map(|ratio| storage / ratio)))
    };
    Ok(Test {
        temperature,
        storage_modulus: Some(storage),
        loss_modulus: loss,
        youngs_modulus: 2.0 * storage * (1.0 + poisson_ratio), // (4.3)
        storage_over_loss: loss.filter(|loss| *loss > 0.0).map(|loss| storage / loss),
    })
}
