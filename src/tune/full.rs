//! Points of a shift by full solutions: those that the map does not tell, and those that confirm it.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::drive::Drive;
use super::unfit::{ShiftPoint, Unfit};
use crate::beltmap::{Quantity, Report, holds};
use crate::case::Resolved;
use crate::drive::{SolveOptions, Solved};
use crate::equilibrium::{AtRatio, Direction, Equilibrium, EquilibriumError};
use crate::losses::losses;
use crate::model::{Constant, Output};
use crate::result::slip_reserve;

/// Parts of the range of speeds at whose ends the loosest belt is known.
const PARTS: u32 = 16;
/// Factor between the slack tensions among which the loosest belt is sought first, and halvings of the last interval.
const LOOSER: f64 = 0.7;
const HALVINGS: usize = 7;

/// A place for the loosest belt that holds at a ratio and a speed, or for there being none.
type Place = Arc<OnceLock<Option<LoosestBelt>>>;

/// The loosest belt that holds, by ratio and speed: it depends on no part, and is found once for all combinations.
#[derive(Debug, Default)]
struct Loosest(Mutex<BTreeMap<(u64, u32), Place>>);

#[derive(Debug)]
struct LoosestBelt {
    solved: Solved,
    /// Whether it is loosest because the map goes no farther: looser ones hold as well.
    ends: bool,
}

/// What full solutions are sought over, and to which tolerance.
#[derive(Debug)]
pub(super) struct InFull {
    /// Speeds of the primary, rad/s.
    speeds: (f64, f64),
    /// Slack tensions, N.
    tensions: (f64, f64),
    /// Speed efficiency from which on a belt holds, however little friction is left.
    least_speed_efficiency: f64,
    options: SolveOptions,
    loosest: Loosest,
}

impl InFull {
    /// Over what a map is over, as accurate as its nodes.
    pub fn new(speeds: (f64, f64), tensions: (f64, f64), report: &Report) -> Self {
        let options = SolveOptions { tolerance: report.tolerance, uncertainty: false, ..SolveOptions::default() };
        let least_speed_efficiency = report.least_speed_efficiency;
        Self { speeds, tensions, least_speed_efficiency, options, loosest: Loosest::default() }
    }

    /// The point of a shift at which both pulleys balance, in cells of the map that have no values. That a cell has
    /// none says only that the belt slips at one of its corners: how large it is depends on the map's accuracy, and
    /// drives that hold lie in it. Whether a combination slips is therefore decided by the belt itself.
    ///
    /// # Errors
    /// See [`Unfit`].
    pub fn point(&self, drive: &Drive<'_>, ratio: f64) -> Result<ShiftPoint, Unfit> {
        let unsolved = |error| unsolved(ratio, error);
        let at = AtRatio::new(drive.case, ratio, Direction::Up, &self.options).map_err(unsolved)?;
        let loosest = self.held(drive, &at, ratio, 0)?;
        if let Ok(found) = at.balance(&loosest)
            && self.holds(&found.solved)
            && (self.speeds.0..=self.speeds.1).contains(&found.primary_speed())
        {
            return self.read(drive, ratio, &found);
        }
        let mut above = at.clamped(self.speed(0), &loosest).map_err(unsolved)?;
        if on_primary(&above).1 < 0.0 {
            let (presses, rest) = on_primary(&above);
            return Err(Unfit::TooLight { ratio, speed: self.speed(0), presses, needs: presses - rest });
        }
        // Down from the largest speed, to where the flyweights hold the belt no longer or the secondary does not.
        for part in 1..=PARTS {
            self.held(drive, &at, ratio, part)?;
            let below = at.clamped(self.speed(part), &above.solved).map_err(unsolved)?;
            if on_primary(&below).1 < 0.0 {
                let found = at.balance(&below.solved).or_else(|_| at.balance(&above.solved)).map_err(unsolved)?;
                return self.read(drive, ratio, &found);
            }
            above = below;
        }
        let (presses, rest) = on_primary(&above);
        Err(Unfit::TooHeavy { ratio, speed: self.speed(PARTS), presses, needs: presses - rest })
    }

    /// The speed so many parts below the largest, rad/s.
    fn speed(&self, part: u32) -> f64 {
        let (from, to) = self.speeds;
        to - (to - from) * f64::from(part) / f64::from(PARTS)
    }

    fn holds(&self, solved: &Solved) -> bool {
        let kept = solved.belt.output_values(&solved.solution).and_then(|values| values.get(Output::EfficiencySpeed));
        let left = slip_reserve(solved).unwrap_or(f64::NAN);
        kept.is_ok_and(|kept| holds(kept, left, self.least_speed_efficiency))
    }

    /// The loosest belt at a speed, which the secondary's actuator presses with at least as much as it takes.
    fn held(&self, drive: &Drive<'_>, at: &AtRatio<'_>, ratio: f64, part: u32) -> Result<Solved, Unfit> {
        let speed = self.speed(part);
        let key = (ratio.to_bits(), part);
        let mut all = self.loosest.0.lock().unwrap_or_else(PoisonError::into_inner);
        let place = Arc::clone(all.entry(key).or_default());
        drop(all);
        let loosest = place.get_or_init(|| self.loosest_belt(at, speed)).as_ref();
        let loosest = loosest.ok_or(Unfit::Untold { ratio, speed, tension: self.tensions.1 })?;
        let beside = at.beside(&loosest.solved).map_err(|error| unsolved(ratio, error))?;
        let (presses, needs) = (beside.forces.secondary.value, beside.forces.secondary_belt);
        if presses >= needs {
            return Ok(loosest.solved.clone());
        }
        if loosest.ends {
            return Err(Unfit::Loose { ratio, speed, tension: self.tensions.0 });
        }
        let torque = drive.engine.torque(speed).value;
        Err(Unfit::Slips { ratio, speed, torque, presses, needs })
    }

    /// From tight to loose, each from the one before.
    fn loosest_belt(&self, at: &AtRatio<'_>, speed: f64) -> Option<LoosestBelt> {
        let (least, most) = self.tensions;
        let belt = |tension: f64, near: Option<&Solved>| {
            at.belt(speed, tension, near).ok().filter(|solved| self.holds(solved))
        };
        let (mut tension, mut solved) = (most, belt(most, None));
        while solved.is_none() && tension > least {
            tension = (LOOSER * tension).max(least);
            solved = belt(tension, None);
        }
        let mut solved = solved?;
        let mut below = least;
        while tension > least {
            let looser = (LOOSER * tension).max(least);
            match belt(looser, Some(&solved)) {
                Some(found) => (tension, solved) = (looser, found),
                None => {
                    below = looser;
                    break;
                }
            }
        }
        if tension <= least {
            return Some(LoosestBelt { solved, ends: true });
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (below + tension);
            match belt(middle, Some(&solved)) {
                Some(found) => (tension, solved) = (middle, found),
                None => below = middle,
            }
        }
        Some(LoosestBelt { solved, ends: false })
    }

    /// A balance as a point of the shift, if its slack tension is one over which the map is.
    fn read(&self, drive: &Drive<'_>, ratio: f64, found: &Equilibrium) -> Result<ShiftPoint, Unfit> {
        let (least, most) = self.tensions;
        let (tension, speed) = (found.solved.constant(Constant::SlackTension), found.primary_speed());
        if tension < least {
            return Err(Unfit::Loose { ratio, speed, tension: least });
        }
        if tension > most {
            return Err(Unfit::Tight { ratio, tension: most });
        }
        if !self.holds(&found.solved) {
            return Err(Unfit::Lost { ratio });
        }
        let efficiency = efficiency(drive.case, found, self.options.tolerance);
        let efficiency = efficiency.map_err(|reason| Unfit::Unsolved { ratio, reason })?;
        let secondary_speed = found.output(Output::SecondarySpeed).unwrap_or(f64::NAN);
        Ok(solved_point(found, (ratio, secondary_speed), efficiency))
    }
}

fn unsolved(ratio: f64, error: EquilibriumError) -> Unfit {
    match error {
        EquilibriumError::Actuator { error, .. } => Unfit::Actuator { ratio, error },
        other => Unfit::Unsolved { ratio, reason: other.to_string() },
    }
}

/// What presses on the primary, and that less what the belt takes, N.
fn on_primary(found: &Equilibrium) -> (f64, f64) {
    let presses = found.forces.primary.map_or(f64::NAN, |force| force.value);
    (presses, presses - found.forces.primary_belt)
}

/// Power out over power in of a full solution, with losses where the map of the same case has them; or why it cannot be
/// told.
pub(super) fn efficiency(case: &Resolved, found: &Equilibrium, tolerance: f64) -> Result<f64, String> {
    if Quantity::of_case(case).contains(&Quantity::Losses) {
        let told = losses(case, &found.solved, case.stiffnesses.reference, tolerance);
        return told.map(|losses| losses.efficiency).map_err(|error| error.to_string());
    }
    found.output(Output::EfficiencyOverall).map_err(|error| error.to_string())
}

/// A point of the shift as a full solution has it: at a nominal ratio, and at a speed of the secondary.
pub(super) fn solved_point(found: &Equilibrium, (ratio, secondary_speed): (f64, f64), efficiency: f64) -> ShiftPoint {
    ShiftPoint {
        ratio,
        primary_speed: found.primary_speed(),
        secondary_speed,
        slack_tension: found.output(Output::PrimaryExitTension).unwrap_or(f64::NAN),
        slip_reserve: slip_reserve(&found.solved).unwrap_or(f64::NAN),
        efficiency,
        travels: (found.primary_travel, found.secondary_travel),
    }
}
