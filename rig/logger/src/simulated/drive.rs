//! Engine, CVT, brake and rotor of the simulated rig.

/// The CVT as `sheave` solves it: rows of ratio, torque, primary radius, axial force, efficiency.
const MAP: &str = include_str!("../../data/cvt-map.csv");
/// Engine power in hp over rpm, wide open.
const ENGINE: &str = include_str!("../../data/engine-power.csv");

const RPM: f64 = std::f64::consts::PI / 30.0;
/// Inertia of engine and primary, and of everything behind the belt, kg·m².
const INERTIA: [f64; 2] = [0.02, 0.03];
/// Stiffness of the belt's grip, N·m for each rad/s of slip.
const GRIP: f64 = 10.0;
/// The primary begins to clamp at this speed, rpm, and holds all of the engine's torque 300 rpm above.
const ENGAGEMENT: f64 = 1900.0;
/// The actuator's travel to where the pads touch, s, and the braking torque at the secondary beyond, N·m/s.
const PADS_TOUCH: f64 = 2.6;
const BRAKE_GAIN: f64 = 13.0;

/// A table over ratio and torque, on a rectangular grid.
struct Map {
    ratios: Vec<f64>,
    torques: Vec<f64>,
    rows: Vec<[f64; 3]>,
}

fn numbers(text: &str) -> Vec<Vec<f64>> {
    text.lines()
        .map(|line| line.split(',').filter_map(|field| field.trim().parse().ok()).collect::<Vec<f64>>())
        .filter(|row| !row.is_empty())
        .collect()
}

fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// The place of a value in a sorted list: index below, and fraction of the way to the next; held at the ends.
fn place(list: &[f64], value: f64) -> (usize, f64) {
    let above = list.partition_point(|entry| *entry <= value).clamp(1, list.len().saturating_sub(1).max(1));
    match (list.get(above - 1), list.get(above)) {
        (Some(low), Some(high)) => (above - 1, ((value - low) / (high - low)).clamp(0.0, 1.0)),
        _ => (0, 0.0),
    }
}

impl Map {
    fn new() -> Self {
        let rows = numbers(MAP);
        let column = |number: usize| rows.iter().filter_map(move |row| row.get(number).copied());
        let (ratios, torques) = (distinct(column(0)), distinct(column(1)));
        let values = rows.iter().filter_map(|row| row.get(2..5).and_then(|rest| rest.try_into().ok())).collect();
        Self { ratios, torques, rows: values }
    }

    /// Primary radius, axial force and efficiency.
    fn at(&self, ratio: f64, torque: f64) -> [f64; 3] {
        let ((i, u), (j, v)) = (place(&self.ratios, ratio), place(&self.torques, torque));
        let row = |i: usize, j: usize| self.rows.get(i * self.torques.len() + j).copied().unwrap_or([0.0; 3]);
        let (a, b, c, d) = (row(i, j), row(i, j + 1), row(i + 1, j), row(i + 1, j + 1));
        std::array::from_fn(|k| (1.0 - u) * ((1.0 - v) * a[k] + v * b[k]) + u * ((1.0 - v) * c[k] + v * d[k]))
    }
}

/// Overall efficiency of the simulated CVT at a speed ratio (primary over secondary) and a primary torque, N·m.
#[must_use]
pub fn efficiency(ratio: f64, torque: f64) -> f64 {
    let [_, _, efficiency] = Map::new().at(ratio, torque);
    efficiency
}

/// What drives the plant for one step.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    /// The throttle is open.
    pub throttle_open: bool,
    /// The engine has ignition.
    pub ignition: bool,
    /// How fast the actuator moves, in seconds of travel a second: 1 applies, −1 releases.
    pub actuator: f64,
    /// The governor has failed.
    pub no_governor: bool,
}

/// The plant's state.
pub struct Plant {
    map: Map,
    engine: Vec<(f64, f64)>,
    /// Speeds of primary and secondary, rad/s.
    pub speeds: [f64; 2],
    /// R_S/R_P.
    pub ratio: f64,
    /// Actuator travel, s.
    pub travel: f64,
    /// Rotor temperature, °C.
    pub rotor: f64,
    /// Braking torque at the secondary, N·m.
    pub brake_torque: f64,
    /// Engine torque, N·m.
    pub engine_torque: f64,
    /// Overall efficiency of the CVT at present.
    pub efficiency: f64,
    /// Angle of the crankshaft, rad.
    pub angles: [f64; 2],
}

impl Plant {
    /// An engine that idles (the operator has started it), brake off.
    #[must_use]
    pub fn new() -> Self {
        let engine = numbers(ENGINE)
            .iter()
            .filter_map(|row| Some((*row.first()?, row.get(1)? * 745.7 / (row.first()? * RPM))))
            .collect();
        Self {
            map: Map::new(),
            engine,
            speeds: [0.0; 2],
            ratio: 2.2,
            travel: 0.0,
            rotor: 20.0,
            brake_torque: 0.0,
            engine_torque: 0.0,
            efficiency: 0.0,
            angles: [0.0; 2],
        }
    }

    fn wide_open(&self, rpm: f64, no_governor: bool) -> f64 {
        let speeds: Vec<f64> = self.engine.iter().map(|point| point.0).collect();
        let governed = rpm > 3550.0 && !no_governor;
        let (i, u) = place(&speeds, if rpm > 3550.0 && no_governor { 3550.0 } else { rpm });
        let torque = |i: usize| self.engine.get(i).map_or(0.0, |point| point.1);
        let curve = (1.0 - u) * torque(i) + u * torque(i + 1);
        if governed && rpm > 3798.0 { curve - 0.05 * (rpm - 3798.0) } else { curve }
    }

    fn engine(&self, rpm: f64, drive: &Drive) -> f64 {
        match (drive.ignition, drive.throttle_open) {
            (false, _) => -4.0 * (rpm / 300.0).tanh(),
            (true, true) => self.wide_open(rpm, drive.no_governor),
            (true, false) => (0.02 * (1700.0 - rpm)).clamp(-4.0, 6.0),
        }
    }

    /// One step of `dt` seconds.
    pub fn step(&mut self, drive: &Drive, dt: f64) {
        self.travel = (self.travel + drive.actuator * dt).clamp(0.0, 12.0);
        let [primary, secondary] = self.speeds;
        let rpm = primary / RPM;
        self.engine_torque = self.engine(rpm, drive);
        let capacity = ((rpm - ENGAGEMENT) / 300.0).clamp(0.0, 1.0) * 40.0;
        let belt = (GRIP * (primary - secondary * self.ratio)).clamp(-capacity, capacity);
        let [radius, required, efficiency] = self.map.at(self.ratio, belt.abs());
        self.efficiency = efficiency;
        // Power behind the belt is the map's efficiency times power before it; at the start the ratio of torques is
        // held.
        let step_up = (primary / secondary.max(20.0)).min(self.ratio * 1.05);
        let delivered = belt * step_up * efficiency;
        let grip_of_pads = BRAKE_GAIN * (self.travel - PADS_TOUCH).max(0.0);
        self.brake_torque = grip_of_pads * (secondary / 2.0).tanh();
        let drag = 0.002 * secondary;
        self.speeds = [
            (primary + (self.engine_torque - belt) / INERTIA[0] * dt).max(0.0),
            (secondary + (delivered - self.brake_torque - drag) / INERTIA[1] * dt).max(0.0),
        ];
        self.shift(radius, required, primary, dt);
        let heat = self.brake_torque * secondary;
        self.rotor += (heat / 900.0 - (self.rotor - 20.0) * 20.0 / 900.0) * dt;
        for (angle, speed) in self.angles.iter_mut().zip(self.speeds) {
            *angle += speed * dt;
        }
    }

    /// The flyweights' axial force by (9.2) and (9.3) against what the belt needs; radius times mechanical advantage
    /// of the
    /// flyweights is chosen (the thesis shows it in Figure 9.10 only).
    fn shift(&mut self, radius: f64, required: f64, primary: f64, dt: f64) {
        let advantage = 0.0313 - 0.0047 * (radius - 0.043) / 0.041;
        let spring = 950.0 - 18_200.0 * 2.0 * 12f64.to_radians().tan() * (0.093 - radius);
        let surplus = 3.0 * 0.228 * advantage * primary * primary - spring - required;
        self.ratio = (self.ratio - 0.002 * surplus * dt).clamp(0.6, 2.2);
    }
}

impl Default for Plant {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_map_is_read_whole_and_interpolated() {
        let map = Map::new();
        assert_eq!((map.ratios.len(), map.torques.len(), map.rows.len()), (17, 4, 68));
        let [radius, force, efficiency] = map.at(1.0, 15.0);
        assert!(
            (radius - 0.06831).abs() < 1e-5 && (force - 1128.56).abs() < 0.01 && (efficiency - 0.94387).abs() < 1e-5
        );
    }

    #[test]
    fn a_loaded_drive_settles_where_power_balances() {
        let mut plant = Plant::new();
        let mut drive = Drive { throttle_open: false, ignition: true, actuator: 1.0, no_governor: false };
        plant.speeds[0] = 1700.0 * RPM;
        for _ in 0..7000 {
            plant.step(&drive, 5e-4);
        }
        drive.actuator = 0.0;
        drive.throttle_open = true;
        for _ in 0..60_000 {
            plant.step(&drive, 5e-4);
        }
        let [primary, secondary] = plant.speeds;
        let (before, behind) =
            (plant.engine_torque * primary, plant.brake_torque * secondary + 0.002 * secondary * secondary);
        assert!((behind / before - plant.efficiency).abs() < 0.002, "{behind} {before} {}", plant.efficiency);
        assert!((2500.0..3800.0).contains(&(primary / RPM)), "{}", primary / RPM);
        assert!((10.0..15.0).contains(&plant.brake_torque));
    }
}
