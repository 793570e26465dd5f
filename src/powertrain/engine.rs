//! An engine: torque over speed, with a governor.

use crate::actuator::Profile;

/// An engine in steady running.
#[derive(Debug, Clone, PartialEq)]
pub struct Engine {
    /// Torque at full throttle in N·m over speed in rad/s.
    pub torque: Profile,
    /// Factor on that torque: part throttle.
    pub throttle: f64,
    /// What takes torque away at high speed.
    pub governor: Option<Governor>,
}

/// A governor: from one speed on the torque falls in a straight line, to none at another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Governor {
    /// Speed from which it takes torque away, rad/s.
    pub governed: f64,
    /// Speed at which it leaves none, rad/s.
    pub no_load: f64,
}

/// A torque of the engine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EngineTorque {
    /// The torque, N·m.
    pub value: f64,
    /// Its derivative with respect to the speed, N·m·s.
    pub by_speed: f64,
    /// Its derivative with respect to the throttle, N·m.
    pub by_throttle: f64,
}

impl Engine {
    /// The torque at a speed in rad/s. Below the table its first torque holds; beyond it the last slope goes on.
    pub fn torque(&self, speed: f64) -> EngineTorque {
        let full = |speed: f64| {
            let (first, _) = self.torque.domain();
            let jet = self.torque.at(speed.max(first));
            (jet.value, if speed < first { 0.0 } else { jet.slope })
        };
        let (torque, slope) = match self.governor {
            Some(Governor { governed, no_load }) if speed > governed => {
                let (at, _) = full(governed);
                (at * (no_load - speed) / (no_load - governed), -at / (no_load - governed))
            }
            _ => full(speed),
        };
        EngineTorque { value: self.throttle * torque, by_speed: self.throttle * slope, by_throttle: torque }
    }

    /// Speeds in rad/s between which the engine is known: those of the table, and up to where the governor leaves no
    /// torque.
    pub fn range(&self) -> (f64, f64) {
        let (first, last) = self.torque.domain();
        (first, self.governor.map_or(last, |governor| governor.no_load))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_governor_takes_the_torque_away_in_a_straight_line() {
        let torque = Profile::new(vec![200.0, 300.0, 380.0], vec![25.0, 26.0, 24.0]).unwrap();
        let governor = Some(Governor { governed: 380.0, no_load: 400.0 });
        let engine = Engine { torque, throttle: 0.5, governor };
        for (speed, value) in [(100.0, 12.5), (300.0, 13.0), (380.0, 12.0), (390.0, 6.0), (400.0, 0.0)] {
            let found = engine.torque(speed);
            assert!((found.value - value).abs() < 1e-12, "{speed}: {found:?}");
            assert!((found.by_throttle - 2.0 * value).abs() < 1e-12, "{speed}: {found:?}");
        }
        for speed in [150.0, 250.0, 350.0, 395.0] {
            let difference = (engine.torque(speed + 1e-4).value - engine.torque(speed - 1e-4).value) / 2e-4;
            assert!((engine.torque(speed).by_speed - difference).abs() < 1e-7, "{speed}: {difference}");
        }
        assert_eq!(engine.range(), (200.0, 400.0));
    }
}
