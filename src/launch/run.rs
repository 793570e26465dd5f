//! The launch itself.

use differential_equations::prelude::{CrossingDirection, Event, EventConfig, ExplicitRungeKutta, IVP};
use serde::Serialize;

use super::curve::{Delivered, LaunchCurve, LaunchError};
use crate::integrator;
use crate::powertrain::Vehicle;

/// Tolerances of the integration, relative and absolute (m/s, m, J).
const RELATIVE: f64 = 1e-8;
const ABSOLUTE: f64 = 1e-8;
/// Rows of the table between standstill and the end.
const ROWS: usize = 400;
/// Halvings of the range of speeds in which the top speed lies.
const HALVINGS: usize = 60;
/// Share by which the last point may miss what ended the launch, as the integrator locates it.
const ENDED: f64 = 1e-6;
/// Longest launch and longest step of its integration, s: two hours, in which a slow vehicle covers 20 km.
const LONGEST: f64 = 7200.0;
const LONGEST_STEP: f64 = 0.25;
/// Over the time of the top speed, how far a table of what comes before goes.
const LATER: f64 = 1.05;
/// Speeds at which the sign of the acceleration is looked at.
const LOOKED: usize = 400;

/// What is asked of a launch.
#[derive(Debug, Clone, PartialEq)]
pub struct LaunchOptions {
    /// Distances of which the time is told, m.
    pub distances: Vec<f64>,
    /// Share of the top speed at which the launch counts as done: the top speed itself is never reached.
    pub share_of_top: f64,
}

impl Default for LaunchOptions {
    /// 100 ft and 150 ft, the distances over which Baja SAE and its teams time an acceleration run, and 99 % of the top
    /// speed.
    fn default() -> Self {
        Self { distances: vec![30.48, 45.72], share_of_top: 0.99 }
    }
}

/// Where the drive is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum LaunchPhase {
    /// The clutch slips.
    Clutch,
    /// The belt carries the torque.
    Belt,
}

/// A moment of a launch; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LaunchPoint {
    /// Since standstill.
    pub time: f64,
    /// Speed of the vehicle.
    pub speed: f64,
    /// Distance from the start.
    pub distance: f64,
    /// Acceleration of the vehicle.
    pub acceleration: f64,
    /// Where the drive is.
    pub phase: LaunchPhase,
    /// Speed of the engine.
    pub engine_speed: f64,
    /// Speed of the secondary.
    pub secondary_speed: f64,
    /// R_S/R_P.
    pub ratio: f64,
    /// Power from the engine.
    pub power_in: f64,
    /// Power out of the secondary.
    pub power_out: f64,
    /// Heat in the CVT since standstill.
    pub heat: f64,
}

/// When a distance was covered, or a speed reached; SI.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Mark {
    /// Distance from the start.
    pub distance: f64,
    /// Time since standstill.
    pub time: f64,
    /// Speed of the vehicle.
    pub speed: f64,
}

impl Mark {
    fn of(point: &LaunchPoint) -> Self {
        Self { distance: point.distance, time: point.time, speed: point.speed }
    }
}

/// Where the energy went from standstill until all that was asked for had been reached ([`Launch::end`]), J.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Energy {
    /// From the engine.
    pub engine: f64,
    /// Heat in the CVT while the clutch slips.
    pub clutch_heat: f64,
    /// Heat in the CVT afterwards.
    pub belt_heat: f64,
    /// Heat in the final drive.
    pub final_drive_heat: f64,
    /// Against rolling, grade and air.
    pub resistance: f64,
    /// Of the moving vehicle.
    pub kinetic: f64,
    /// What is unaccounted for.
    pub unaccounted: f64,
}

/// A launch.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Launch {
    /// Speed at which the drive delivers what the road takes, m/s; where the shift curve ends before, the speed there.
    pub top_speed: f64,
    /// Whether the shift curve ends before the acceleration does.
    pub limited_by_curve: bool,
    /// When the clutch no longer slips.
    pub lock_up: Mark,
    /// When the share of the top speed that counts was reached.
    pub done: Mark,
    /// When each distance was covered, in the order asked for.
    pub marks: Vec<Mark>,
    /// When all of that had been reached: where the table over time ends, and until when energies are counted.
    pub end: Mark,
    /// Where the energy went until then.
    pub energy: Energy,
    /// The launch over time.
    #[serde(skip)]
    pub points: Vec<LaunchPoint>,
}

/// Speed, distance, energy from the engine, out of the secondary, into resistance, heat in the CVT while the clutch
/// slips, and heat in the final drive.
const STATE: usize = 7;
/// Share of the top speed from which on it is held.
const HELD: f64 = 0.999;
type State = [f64; STATE];

impl Launch {
    /// Where the drive is held at the end of its shift curve by an engine that would have to brake, as a warning.
    pub fn held_back(&self) -> Option<String> {
        let held = self.points.iter().filter(|point| point.power_in < 0.0 && point.speed >= HELD * self.top_speed);
        let most = held.map(|point| -point.power_in).reduce(f64::max)?;
        Some(format!(
            "Downhill the speed is held at the end of the shift curve, for which the engine would have to brake with \
             up to {:.1} kW: what it brakes with is not in its table, and the vehicle may run faster.",
            1e-3 * most
        ))
    }
}

struct Motion<'a> {
    curve: &'a LaunchCurve,
    vehicle: &'a Vehicle,
    take_off: f64,
    /// Speed of the vehicle at which the curve ends.
    last: f64,
    /// At the end the speed is this, and the distance that.
    end: (f64, f64),
}

impl Motion<'_> {
    fn acceleration(&self, speed: f64) -> f64 {
        self.vehicle.acceleration(self.vehicle.secondary_speed(speed), self.delivered(speed).torque)
    }

    /// The drive at a speed of the vehicle; where the curve has ended, it delivers no more than the road takes. Where
    /// that is less than nothing, the engine is given what the wheels do, less the share that the drive loses.
    fn delivered(&self, speed: f64) -> Delivered {
        let secondary = self.vehicle.secondary_speed(speed);
        let mut at = self.curve.at(secondary);
        if speed >= self.last && self.vehicle.acceleration(secondary, at.torque) > 0.0 {
            let (torque, efficiency) = (self.vehicle.holding_torque(secondary), at.efficiency());
            let power_out = torque * secondary;
            let power_in = if power_out < 0.0 { efficiency * power_out } else { power_out / efficiency };
            (at.power_in, at.power_out, at.torque) = (power_in, power_out, torque);
        }
        at
    }

    fn derivative(&self, state: &State) -> State {
        let speed = state[0].max(0.0);
        let secondary = self.vehicle.secondary_speed(speed);
        let at = self.delivered(speed);
        let load = self.vehicle.load(secondary);
        let slips = speed < self.take_off;
        let heat = if slips { at.power_in - at.power_out } else { 0.0 };
        [
            self.vehicle.acceleration(secondary, at.torque),
            speed,
            at.power_in,
            at.power_out,
            load.resistance * speed,
            heat,
            self.vehicle.final_drive_heat(at.power_out),
        ]
    }
}

impl Event<f64, State> for Motion<'_> {
    fn config(&self) -> EventConfig {
        EventConfig::new(CrossingDirection::Positive, Some(1))
    }

    fn event(&self, _: f64, state: &State) -> f64 {
        (state[0] / self.end.0 - 1.0).min(state[1] / self.end.1.max(f64::MIN_POSITIVE) - 1.0)
    }
}

/// A vehicle from standstill to its top speed and over all distances asked for.
///
/// # Errors
/// See [`LaunchError`].
pub fn launch(curve: &LaunchCurve, vehicle: &Vehicle, options: &LaunchOptions) -> Result<Launch, LaunchError> {
    check(options)?;
    let per_speed = vehicle.secondary_speed(1.0);
    let (take_off, last) = (curve.ends().0 / per_speed, curve.ends().1 / per_speed);
    let far = options.distances.iter().copied().fold(0.0, f64::max);
    let mut motion = Motion { curve, vehicle, take_off, last, end: (last, far) };
    if motion.acceleration(0.0) <= 0.0 {
        return Err(LaunchError::Stalls { torque: curve.at(0.0).torque, load: vehicle.load(0.0).torque });
    }
    let (top_speed, limited_by_curve) = top(&motion, last);
    if top_speed <= take_off {
        return Err(LaunchError::NeverLocks { top_speed, take_off });
    }
    let goal = options.share_of_top * top_speed;
    // A small share is reached while the clutch still slips, and when it locks up is told all the same.
    let last_goal = goal.max(take_off);
    motion.end = (last_goal, far);
    // How long it takes, and then at even times.
    let whole = integrate(&motion, None)?;
    let mut moments = whole.0.iter().zip(&whole.1);
    let Some((&end, _)) = moments.find(|(time, state)| motion.event(**time, state) > -ENDED) else {
        let [speed, distance, ..] = whole.1.last().copied().unwrap_or_default();
        return Err(LaunchError::Endless { time: LONGEST, reached: (speed, distance), wanted: (last_goal, far) });
    };
    let lost = || LaunchError::Integration("the end of a phase was not found".into());
    let table = |end: f64| -> Result<(Vec<LaunchPoint>, Option<State>), LaunchError> {
        let times: Vec<f64> = (0..=ROWS).map(|i| end * i as f64 / ROWS as f64).collect();
        let (times, states) = integrate(&motion, Some(&times))?;
        let points = times.iter().zip(&states).map(|(time, state)| point(&motion, *time, state)).collect();
        Ok((points, states.last().copied()))
    };
    // The integrator ends a part of a step behind what ended it: the table ends there.
    let beyond = table(end)?.0;
    let reached = crossing(&beyond, |point| (point.speed, point.acceleration), last_goal).ok_or_else(lost)?;
    let covered = crossing(&beyond, |point| (point.distance, point.speed), far).map_or(0.0, |mark| mark.time);
    let (points, state) = table(reached.time.max(covered).min(end))?;
    // Over a long distance the rows lie too far apart to tell when something happens on the way to the top speed.
    let early = if covered > reached.time { table((LATER * reached.time).min(end))?.0 } else { Vec::new() };
    let mark = |of: &dyn Fn(&LaunchPoint) -> (f64, f64), wanted: f64| {
        crossing(&early, of, wanted).or_else(|| crossing(&points, of, wanted))
    };
    let speeds = |wanted: f64| mark(&|point| (point.speed, point.acceleration), wanted);
    let marks =
        options.distances.iter().map(|wanted| mark(&|point| (point.distance, point.speed), *wanted).ok_or_else(lost));
    Ok(Launch {
        top_speed,
        limited_by_curve,
        lock_up: speeds(take_off).ok_or_else(lost)?,
        done: speeds(goal).unwrap_or(reached),
        marks: marks.collect::<Result<_, _>>()?,
        end: points.last().map(Mark::of).ok_or_else(lost)?,
        energy: energy(vehicle, &state.ok_or_else(lost)?),
        points,
    })
}

fn check(options: &LaunchOptions) -> Result<(), LaunchError> {
    for &given in &options.distances {
        if !(given > 0.0 && given.is_finite()) {
            return Err(LaunchError::Parameter { what: "a distance in m", given, expected: "a positive one" });
        }
    }
    let given = options.share_of_top;
    if given > 0.0 && given < 1.0 {
        return Ok(());
    }
    Err(LaunchError::Parameter { what: "the share of the top speed", given, expected: "a share above 0 and below 1" })
}

/// The first speed at which the vehicle accelerates no more, and whether it is the end of the curve.
fn top(motion: &Motion<'_>, last: f64) -> (f64, bool) {
    let speed = |i: usize| (1.0 - 1e-12) * last * i as f64 / LOOKED as f64;
    let Some(slower) = (1..=LOOKED).find(|i| motion.acceleration(speed(*i)) <= 0.0) else { return (last, true) };
    let (mut low, mut high) = (speed(slower - 1), speed(slower));
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if motion.acceleration(middle) > 0.0 { low = middle } else { high = middle }
    }
    (low, false)
}

fn integrate(motion: &Motion<'_>, times: Option<&[f64]>) -> Result<(Vec<f64>, Vec<State>), LaunchError> {
    let derivative = |_: f64, state: &State, derivative: &mut State| *derivative = motion.derivative(state);
    let method = ExplicitRungeKutta::dopri5().rtol(RELATIVE).atol(ABSOLUTE).h_max(LONGEST_STEP).max_steps(100_000);
    let end = times.and_then(|times| times.last().copied()).unwrap_or(LONGEST);
    let problem = IVP::ode_from_fn(&derivative, 0.0, end, [0.0; STATE]).method(method);
    let solved = match times {
        Some(times) => problem.t_eval(times).solve(),
        None => problem.event(motion).solve(),
    };
    let given_up =
        |error| LaunchError::Integration(integrator::reason(&error, |time| format!("{time:.3} s after the start")));
    let solution = solved.map_err(given_up)?;
    Ok((solution.t, solution.y))
}

fn point(motion: &Motion<'_>, time: f64, state: &State) -> LaunchPoint {
    let [speed, distance, ..] = *state;
    let secondary_speed = motion.vehicle.secondary_speed(speed);
    let at = motion.delivered(speed);
    LaunchPoint {
        time,
        speed,
        distance,
        acceleration: motion.acceleration(speed),
        phase: if speed < motion.take_off { LaunchPhase::Clutch } else { LaunchPhase::Belt },
        engine_speed: at.engine_speed,
        secondary_speed,
        ratio: at.ratio,
        power_in: at.power_in,
        power_out: at.power_out,
        heat: state[2] - state[3],
    }
}

/// When a quantity that only grows has a value: by the cubic through both neighbours' values and rates.
fn crossing(points: &[LaunchPoint], of: impl Fn(&LaunchPoint) -> (f64, f64), wanted: f64) -> Option<Mark> {
    let pair = points.windows(2).find(|pair| of(&pair[0]).0 <= wanted && wanted <= of(&pair[1]).0 * (1.0 + ENDED))?;
    let (a, b) = (&pair[0], &pair[1]);
    let width = b.time - a.time;
    let cubic = |from: (f64, f64), to: (f64, f64), t: f64| {
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * from.0
            + (t3 - 2.0 * t2 + t) * width * from.1
            + (3.0 * t2 - 2.0 * t3) * to.0
            + (t3 - t2) * width * to.1
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if cubic(of(a), of(b), middle) < wanted { low = middle } else { high = middle }
    }
    let t = 0.5 * (low + high);
    Some(Mark {
        time: a.time + t * width,
        distance: cubic((a.distance, a.speed), (b.distance, b.speed), t),
        speed: cubic((a.speed, a.acceleration), (b.speed, b.acceleration), t),
    })
}

/// Where the energy went.
fn energy(vehicle: &Vehicle, state: &State) -> Energy {
    let [speed, _, engine, secondary, resistance, clutch_heat, final_drive_heat] = *state;
    let kinetic = 0.5 * vehicle.mass * speed * speed;
    let belt_heat = engine - secondary - clutch_heat;
    let unaccounted = engine - clutch_heat - belt_heat - final_drive_heat - resistance - kinetic;
    Energy { engine, clutch_heat, belt_heat, final_drive_heat, resistance, kinetic, unaccounted }
}
