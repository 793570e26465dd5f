//! The shift curve as a function of the speed of the secondary.

use thiserror::Error;

use crate::actuator::{Profile, ProfileError};
use crate::equilibrium::{EquilibriumError, ShiftBranch};
use crate::powertrain::Engine;
use crate::quantity::{km_per_h, rpm};

/// Why there is no launch.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum LaunchError {
    /// The case lacks a part.
    #[error("the case has no {what}: {needs}")]
    Missing {
        /// What is missing.
        what: &'static str,
        /// What to give.
        needs: &'static str,
    },
    /// The drive has no shift curve.
    #[error(transparent)]
    Equilibrium(#[from] EquilibriumError),
    /// Too little of the shift curve was found.
    #[error("the shift curve has {points} points with an equilibrium, and four are needed: {reason}")]
    Curve {
        /// How many there are.
        points: usize,
        /// Why others have none.
        reason: String,
    },
    /// Points of the shift curve make no function of the secondary's speed.
    #[error("the shift curve: {0}")]
    Profile(#[from] ProfileError),
    /// The vehicle does not start.
    #[error(
        "the vehicle does not start: the secondary delivers {torque:.1} N·m at take-off, and rolling resistance and \
         grade take {load:.1} N·m"
    )]
    Stalls {
        /// Torque of the secondary at take-off, N·m.
        torque: f64,
        /// Torque that the road takes at standstill, N·m.
        load: f64,
    },
    /// A number out of its range.
    #[error("{what} is {given}: expected {expected}")]
    Parameter {
        /// What it is.
        what: &'static str,
        /// As given.
        given: f64,
        /// What is expected.
        expected: &'static str,
    },
    /// The launch did not end.
    #[error(
        "the launch does not end within {time:.0} s, the longest that is computed: the vehicle has come to {:.1} of \
         {:.1} km/h and over {:.0} of {:.0} m; ask for a shorter distance, or for a smaller share of the top speed",
        km_per_h(reached.0), km_per_h(wanted.0), reached.1, wanted.1
    )]
    Endless {
        /// The longest launch, s.
        time: f64,
        /// Speed and distance by then, m/s and m.
        reached: (f64, f64),
        /// Speed and distance at which it would have ended, m/s and m.
        wanted: (f64, f64),
    },
    /// Nothing says how fast the engine runs while the clutch slips.
    #[error(
        "the drive has no take-off, at which the engine would run while the clutch slips: its slowest state has the \
         engine at {:.0} rpm, and its torque is given from {:.0} rpm on; {reason}",
        rpm(*engine), rpm(*slowest)
    )]
    NoTakeOff {
        /// Speed of the engine in the slowest state that was found, rad/s.
        engine: f64,
        /// The least speed for which its torque is given, rad/s.
        slowest: f64,
        /// Why there is no take-off.
        reason: String,
    },
    /// What resists holds the vehicle below the speed at which the clutch locks up.
    #[error(
        "the vehicle gets no faster than {:.1} km/h against what resists it, and the belt takes the drive off at \
         {:.1} km/h: the clutch slips for good; check the resistance, or take a shorter final drive",
        km_per_h(*top_speed), km_per_h(*take_off)
    )]
    NeverLocks {
        /// The speed that it reaches, m/s.
        top_speed: f64,
        /// The speed at which the clutch would lock up, m/s.
        take_off: f64,
    },
    /// The integration was given up.
    #[error("the launch cannot be integrated: {0}")]
    Integration(String),
}

/// A quantity over the speed of the secondary, in pieces that meet where the drive goes from one phase to the next.
#[derive(Debug, Clone)]
struct Pieces(Vec<Profile>);

impl Pieces {
    fn new(speeds: &[f64], values: &[f64], breaks: &[usize]) -> Result<Self, ProfileError> {
        let mut pieces = Vec::new();
        let mut from = 0;
        for &to in breaks.iter().chain([&(speeds.len() - 1)]).filter(|to| **to > 0) {
            if to > from {
                pieces.push(Profile::new(speeds[from..=to].to_vec(), values[from..=to].to_vec())?);
                from = to;
            }
        }
        Ok(Self(pieces))
    }

    /// Within the curve's ends.
    fn at(&self, speed: f64) -> f64 {
        let piece = self.0.iter().find(|piece| speed <= piece.domain().1).or(self.0.last());
        piece.map_or(f64::NAN, |piece| piece.at(speed.clamp(piece.domain().0, piece.domain().1)).value)
    }
}

/// What a drive does along its shift curve, as functions of the speed of the secondary in rad/s.
#[derive(Debug, Clone)]
pub struct LaunchCurve {
    engine: Pieces,
    ratio: Pieces,
    power_in: Pieces,
    power_out: Pieces,
    /// Speed of the secondary at take-off and where the curve ends, rad/s.
    ends: (f64, f64),
}

/// A drive at a speed of its secondary; SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Delivered {
    /// Speed of the engine.
    pub engine_speed: f64,
    /// R_S/R_P.
    pub ratio: f64,
    /// Power from the engine.
    pub power_in: f64,
    /// Power out of the secondary.
    pub power_out: f64,
    /// Torque out of the secondary.
    pub torque: f64,
}

impl Delivered {
    /// Share of the power that goes through, whichever way it goes; 1 where none does.
    pub(super) fn efficiency(&self) -> f64 {
        let shares = [self.power_out / self.power_in, self.power_in / self.power_out];
        shares.into_iter().filter(|share| *share > 0.0).fold(1.0, f64::min)
    }
}

impl LaunchCurve {
    /// From the points of a shift curve that begins at take-off.
    ///
    /// # Errors
    /// [`LaunchError::Curve`] where there are too few.
    pub fn new(branch: &ShiftBranch) -> Result<Self, LaunchError> {
        let found: Vec<_> =
            branch.points.iter().filter_map(|point| Some((point, point.report.as_ref().ok()?))).collect();
        let failure = branch.points.iter().find_map(|point| point.report.as_ref().err().cloned());
        if found.len() < 4 {
            let reason = failure.or(branch.remarks.first().cloned()).unwrap_or_else(|| "no more were asked for".into());
            return Err(LaunchError::Curve { points: found.len(), reason });
        }
        let speeds: Vec<f64> = found.iter().map(|(point, _)| point.secondary_speed).collect();
        // The last point of a phase is the first of the next.
        let breaks: Vec<usize> =
            (1..found.len() - 1).filter(|at| found[*at].1.phase != found[at + 1].1.phase).collect();
        let pieces = |of: &dyn Fn(&crate::equilibrium::DriveReport) -> f64| {
            let values: Vec<f64> = found.iter().map(|(_, report)| of(report)).collect();
            Pieces::new(&speeds, &values, &breaks)
        };
        let ends = (speeds.first().copied().unwrap_or(0.0), speeds.last().copied().unwrap_or(0.0));
        Ok(Self {
            engine: pieces(&|report| report.primary_speed)?,
            ratio: pieces(&|report| report.ratio)?,
            power_in: pieces(&|report| report.power_in)?,
            power_out: pieces(&|report| report.power_out)?,
            ends,
        })
    }

    /// Whether the curve begins where a clutch can: at take-off, or where no take-off was found at a state in which the
    /// engine can run; then a warning that says what is told of the clutch rests on.
    ///
    /// # Errors
    /// [`LaunchError::NoTakeOff`].
    pub fn beginning(&self, branch: &ShiftBranch, engine: &Engine) -> Result<Option<String>, LaunchError> {
        if branch.take_off.is_some() {
            return Ok(None);
        }
        let (running, slowest) = (self.engine.at(self.ends.0), engine.range().0);
        if running < slowest {
            let reason = match branch.remarks.as_slice() {
                [] => "its sheaves are held".to_owned(),
                remarks => remarks.join("; "),
            };
            return Err(LaunchError::NoTakeOff { engine: running, slowest, reason });
        }
        Ok(Some(format!(
            "No take-off was found: the clutch is taken to slip until the slowest state that was found, with the \
             engine at {:.0} rpm; times and the clutch's heat rest on that.",
            rpm(running)
        )))
    }

    /// From functions' values at increasing speeds of the secondary: engine speed, ratio, power in and out, all SI.
    ///
    /// # Errors
    /// [`LaunchError::Profile`].
    pub fn from_values(speeds: &[f64], values: [&[f64]; 4]) -> Result<Self, LaunchError> {
        let piece = |values: &[f64]| Profile::new(speeds.to_vec(), values.to_vec()).map(|piece| Pieces(vec![piece]));
        let [engine, ratio, power_in, power_out] = values;
        let ends = (speeds.first().copied().unwrap_or(0.0), speeds.last().copied().unwrap_or(0.0));
        Ok(Self {
            engine: piece(engine)?,
            ratio: piece(ratio)?,
            power_in: piece(power_in)?,
            power_out: piece(power_out)?,
            ends,
        })
    }

    /// Speed of the secondary at take-off and where the curve ends, rad/s.
    pub fn ends(&self) -> (f64, f64) {
        self.ends
    }

    /// The drive at a speed of its secondary in rad/s; below take-off the clutch slips.
    pub fn at(&self, speed: f64) -> Delivered {
        let (first, last) = self.ends;
        let there = speed.clamp(first, last);
        let (engine_speed, ratio) = (self.engine.at(there), self.ratio.at(there));
        let (power_in, power_out) = (self.power_in.at(there), self.power_out.at(there));
        let torque = power_out / there;
        // The torque of take-off at whatever speed the secondary has.
        Delivered { engine_speed, ratio, power_in, power_out: torque * speed.min(last), torque }
    }
}
