//! A vehicle: what the road asks of the secondary.

use generated::{VEHICLE_LOAD, VehicleLoadInput, VehicleLoadOutput};

use crate::formula::Inputs;

/// Standard acceleration of gravity, m/s² (3rd CGPM, 1901).
const GRAVITY: f64 = 9.80665;

/// A vehicle on a road; SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vehicle {
    /// Mass with its driver, kg.
    pub mass: f64,
    /// Turns of the secondary for a turn of the wheel.
    pub final_ratio: f64,
    /// Rolling radius of the wheel, m.
    pub wheel_radius: f64,
    /// Coefficient of rolling resistance.
    pub rolling_resistance: f64,
    /// C_d A, m².
    pub drag_area: f64,
    /// Grade of the ground, rise over run.
    pub grade: f64,
    /// Density of the air, kg/m³.
    pub air_density: f64,
    /// Efficiency of the final drive.
    pub final_efficiency: f64,
}

/// What a vehicle takes from the secondary at a speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Speed of the vehicle, m/s.
    pub speed: f64,
    /// Resistance of rolling, grade and air, N.
    pub resistance: f64,
    /// Torque that steady running takes from the secondary, N·m.
    pub torque: f64,
    /// Torque that an acceleration takes beyond that, over the acceleration, N·m·s²/m.
    pub torque_per_acceleration: f64,
}

impl Vehicle {
    /// The load at a speed of the secondary in rad/s.
    pub fn load(&self, secondary: f64) -> Load {
        use VehicleLoadInput as Input;
        use VehicleLoadOutput as Output;
        let found = Inputs::new(&VEHICLE_LOAD)
            .with(&[
                (Input::SecondarySpeed, secondary),
                (Input::FinalRatio, self.final_ratio),
                (Input::WheelRadius, self.wheel_radius),
                (Input::Mass, self.mass),
                (Input::Gravity, GRAVITY),
                (Input::RollingResistance, self.rolling_resistance),
                (Input::Grade, self.grade),
                (Input::AirDensity, self.air_density),
                (Input::DragArea, self.drag_area),
                (Input::FinalEfficiency, self.final_efficiency),
                (Input::Acceleration, 0.0),
            ])
            .outputs();
        Load {
            speed: found.get(Output::Speed),
            resistance: found.get(Output::Resistance),
            torque: found.get(Output::Torque),
            torque_per_acceleration: found.get(Output::TorquePerAcceleration),
        }
    }

    /// Speed of the secondary in rad/s at a speed of the vehicle in m/s.
    pub fn secondary_speed(&self, speed: f64) -> f64 {
        speed * self.final_ratio / self.wheel_radius
    }

    /// Acceleration in m/s² when the secondary, turning at a speed in rad/s, delivers a torque in N·m.
    pub fn acceleration(&self, secondary: f64, torque: f64) -> f64 {
        let load = self.load(secondary);
        (self.driving(torque) - load.torque) / load.torque_per_acceleration
    }

    /// The torque at the secondary in N·m that holds a speed, at the secondary's in rad/s: a negative one downhill.
    pub fn holding_torque(&self, secondary: f64) -> f64 {
        let load = self.load(secondary).torque;
        if load < 0.0 { load * self.final_efficiency * self.final_efficiency } else { load }
    }

    /// Power in W that becomes heat in the final drive where the secondary delivers so much; where that is negative,
    /// the axle drives.
    pub fn final_drive_heat(&self, secondary: f64) -> f64 {
        let efficiency = self.final_efficiency;
        secondary * if secondary < 0.0 { 1.0 - 1.0 / efficiency } else { 1.0 - efficiency }
    }

    /// A torque at the secondary as the load counts it, which pays for the final drive as one that drives does: where
    /// the secondary brakes the axle, the final drive's loss adds to it.
    fn driving(&self, torque: f64) -> f64 {
        if torque < 0.0 { torque / (self.final_efficiency * self.final_efficiency) } else { torque }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_load_is_what_the_road_asks_by_hand() {
        let vehicle = Vehicle {
            mass: 227.0,
            final_ratio: 8.32,
            wheel_radius: 0.279,
            rolling_resistance: 0.03,
            drag_area: 0.546,
            grade: 0.1,
            air_density: 1.2,
            final_efficiency: 0.95,
        };
        let secondary = vehicle.secondary_speed(10.0);
        let load = vehicle.load(secondary);
        let slope = 0.1f64.atan();
        let resistance = 227.0 * GRAVITY * (0.03 * slope.cos() + slope.sin()) + 0.5 * 1.2 * 0.546 * 100.0;
        assert!((load.speed - 10.0).abs() < 1e-12 && (load.resistance - resistance).abs() < 1e-9, "{load:?}");
        assert!((load.torque - resistance * 10.0 / (secondary * 0.95)).abs() < 1e-12, "{load:?}");
        assert!(vehicle.acceleration(secondary, load.torque).abs() < 1e-12);
        let faster = load.torque + 227.0 * 10.0 / (secondary * 0.95);
        assert!((vehicle.acceleration(secondary, faster) - 1.0).abs() < 1e-12);
        assert_eq!(vehicle.holding_torque(secondary), load.torque);
    }

    /// Downhill the final drive's loss brakes as well: of what the axle gives less arrives at the secondary.
    #[test]
    fn where_the_secondary_brakes_the_final_drive_brakes_as_well() {
        let vehicle = Vehicle {
            mass: 227.0,
            final_ratio: 8.32,
            wheel_radius: 0.279,
            rolling_resistance: 0.0,
            drag_area: 0.0,
            grade: -0.1,
            air_density: 1.2,
            final_efficiency: 0.8,
        };
        let secondary = vehicle.secondary_speed(10.0);
        let held = vehicle.holding_torque(secondary);
        let pull = 227.0 * GRAVITY * 0.1f64.atan().sin();
        assert!((held * secondary / (-0.8 * pull * 10.0) - 1.0).abs() < 1e-12, "{held}");
        assert!((vehicle.final_drive_heat(held * secondary) / (0.2 * pull * 10.0) - 1.0).abs() < 1e-12);
        assert!(vehicle.acceleration(secondary, held).abs() < 1e-12);
        assert!(vehicle.acceleration(secondary, 1.1 * held) < 0.0 && vehicle.acceleration(secondary, 0.0) > 0.0);
    }
}
