//! From a resolved case to the question it asks: what is given, what is unknown for it, and where the search starts.

use super::estimate::{EFFICIENCY, estimate};
use super::power::told;
use super::question::{Known, Question, Swap};
use super::start;
use crate::case::geometry::radii_of_ratio;
use crate::case::{Case, CaseError, Fourth, Free, Key, Load, OperatingPoint, Resolved, Speed};
use crate::model::{Constant, Constants};

impl Question {
    /// What a case asks. Where a given constant is unknown, its value is an estimate.
    pub fn of(case: &Resolved) -> Self {
        let mut constants = Constants([0.0; Constant::ALL.len()]);
        let (primary, secondary) = radii(case);
        for (constant, value) in [
            (Constant::LongitudinalStiffness, case.belt.longitudinal_stiffness),
            (Constant::BendingStiffness, case.belt.bending_stiffness),
            (Constant::RadialStiffness, case.belt.radial_stiffness),
            (Constant::MassPerLength, case.belt.mass_per_length),
            (Constant::PrimaryRadius, primary),
            (Constant::SecondaryRadius, secondary),
            (Constant::CenterDistance, case.drive.center_distance),
            (Constant::HalfAngle, case.sheave.half_angle),
            (Constant::FrictionCoefficient, case.sheave.friction_coefficient),
            (Constant::SlipThreshold, case.sheave.slip_threshold),
        ] {
            constants[constant] = value;
        }
        let swaps = swaps(case);
        let mut constants = start::constants(&constants);
        estimate(&mut constants, case);
        Self { constants, swaps, closings: Vec::new() }
    }
}

impl Case {
    /// Refuses a question that has no answer whatever the numbers, at the places that ask it.
    ///
    /// # Errors
    /// [`CaseProblem::IllPosed`](crate::case::CaseProblem::IllPosed).
    pub fn check_posed(&self, resolved: &Resolved) -> Result<(), CaseError> {
        Question::of(resolved).check(&resolved.model).map_err(|reason| self.ill_posed(resolved, reason))
    }
}

/// What the slots of the operating point and the free radii make of the givens.
fn swaps(case: &Resolved) -> Vec<Swap> {
    let point = &case.operating_point;
    let mut swaps = Vec::new();
    let mut add = |free: Constant, (key, value): (Key, f64)| {
        // A key that gives a constant as it stands needs no swap.
        let known = match key {
            Key::SpeedRatio => Known::Constant(Constant::SpeedRatio),
            key => match key.output() {
                Some(output) => Known::Output(output),
                None => return,
            },
        };
        swaps.push(Swap { free, known, value });
    };
    add(Constant::PrimarySpeed, point.speed.setting());
    add(Constant::PrimaryTorque, point.load.setting());
    add(Constant::SlackTension, point.clamp.setting());
    let length = (Key::BeltLength, case.belt.length);
    match case.drive.free {
        None => {}
        Some(Free::PrimaryRadius) => add(Constant::PrimaryRadius, length),
        Some(Free::SecondaryRadius) => add(Constant::SecondaryRadius, length),
        Some(Free::Both) => {
            add(Constant::PrimaryRadius, length);
            if let Some(fourth) = point.fourth {
                add(Constant::SecondaryRadius, fourth.setting());
            }
        }
    }
    swaps.extend(case.swaps.iter().map(|swap| Swap {
        free: swap.constant,
        known: Known::Output(swap.output),
        value: told(swap.output, swap.value, brakes(case)),
    }));
    swaps
}

/// Whether the operating point is one of engine braking.
fn brakes(case: &Resolved) -> bool {
    matches!(case.operating_point.load, Load::PrimaryTorque(torque) | Load::SecondaryTorque(torque) if torque < 0.0)
}

/// The radii; where both are free, those of (6.12) at the ratio that the operating point suggests.
fn radii(case: &Resolved) -> (f64, f64) {
    let drive = &case.drive;
    let suggested = match drive.free {
        Some(Free::Both) => radii_of_ratio(ratio(&case.operating_point), case.belt.length, drive.center_distance).ok(),
        _ => None,
    };
    suggested.unwrap_or((drive.primary_radius, drive.secondary_radius))
}

/// R_S/R_P from the ratio of speeds, else from that of torques, else 1.
fn ratio(point: &OperatingPoint) -> f64 {
    let (Speed::Primary(speed) | Speed::Secondary(speed)) = point.speed;
    let fourth = match point.fourth {
        Some(Fourth::Load(load)) => Some(load),
        _ => None,
    };
    let (mut input, mut output, mut ratio) = (None, None, None);
    for load in [Some(point.load), fourth].into_iter().flatten() {
        match load {
            Load::SpeedRatio(given) => ratio = Some(1.0 / given),
            Load::SecondarySpeed(given) => ratio = Some(speed / given),
            Load::PrimaryTorque(torque) => input = Some(torque),
            Load::SecondaryTorque(torque) => output = Some(torque),
        }
    }
    let torques = input.zip(output).map(|(input, output)| output / (EFFICIENCY * input));
    ratio.or(torques).unwrap_or(1.0)
}
