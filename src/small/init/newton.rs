//! Newton's method for v_0 and one more unknown.

use super::state::{InitError, PulleyId, gross_slip};
use super::{ClosedForms, Derived, Given, Inputs, Residual, SimpleDrive};

/// Steps at most; fewer than ten are usual.
const STEPS: usize = 100;
/// Halvings of a step at most.
const HALVINGS: usize = 60;
/// A step that changes the belt's tension by less than this share is the last: the next would change it by its square.
const LAST_STEP: f64 = 1e-8;
/// Roundings of v_0 in its last digit that are no step.
const ROUNDINGS: f64 = 64.0;

/// Two equations for two unknowns.
pub(super) struct System<'a> {
    pub drive: &'a SimpleDrive,
    /// They are among the residuals.
    pub equations: [Residual; 2],
    /// The unknown beside v_0.
    pub unknown: Given,
    /// The pulley whose axial force is given.
    pub clamped: PulleyId,
}

impl System<'_> {
    /// Solves from where `closed` stands and leaves the solution there; the number of steps.
    pub fn solve(&self, mut residuals: Inputs<Given, Residual>, closed: &mut ClosedForms) -> Result<usize, InitError> {
        for input in [Given::InputSpeed, Given::OutputSpeed, Given::OutputTorque, Given::InputTorque, Given::BeltSpeed]
        {
            residuals.set(input, closed.get(input));
        }
        for step in 1..=STEPS {
            let to = self.step(&residuals);
            match self.walk(&mut residuals, closed, to) {
                Some(1.0) if self.is_last(closed, to) => return Ok(step),
                Some(_) => {}
                None => return Err(self.failure(closed, step)),
            }
        }
        Err(self.failure(closed, STEPS))
    }

    /// Why it ended: near where all of the contact slides there is no solution if the force is too small for one.
    fn failure(&self, closed: &ClosedForms, steps: usize) -> InitError {
        match gross_slip(closed, self.clamped) {
            slip @ InitError::GrossSlip { axial_force, smallest, .. } if axial_force <= smallest => slip,
            _ => InitError::NotConverged { steps },
        }
    }

    /// The full step in the unknown and v_0, by Cramer's rule.
    fn step(&self, residuals: &Inputs<Given, Residual>) -> [f64; 2] {
        let at = residuals.linearised();
        let [f, g] = self.equations;
        let entry = |equation, unknown| at.derivative(equation, unknown);
        let [[f_x, f_v], [g_x, g_v]] =
            [f, g].map(|equation| [entry(equation, self.unknown), entry(equation, Given::BeltSpeed)]);
        let (f, g) = (at.get(f), at.get(g));
        let determinant = f_x * g_v - f_v * g_x;
        [(f_v * g - g_v * f) / determinant, (g_x * f - f_x * g) / determinant]
    }

    /// Takes the step, halved until the belt is tight and some of it adheres; the share that was taken, if there is
    /// one.
    fn walk(&self, residuals: &mut Inputs<Given, Residual>, closed: &mut ClosedForms, step: [f64; 2]) -> Option<f64> {
        let from = [self.unknown, Given::BeltSpeed].map(|input| residuals.get(input));
        let mut go = |share: f64, closed: &mut ClosedForms| {
            for ((input, from), step) in [self.unknown, Given::BeltSpeed].into_iter().zip(from).zip(step) {
                let to = if share == 0.0 { from } else { from + share * step };
                residuals.set(input, to);
                closed.set(input, to);
            }
        };
        let mut share = 1.0;
        for _ in 0..HALVINGS {
            go(share, closed);
            if is_possible(self.drive, closed, self.clamped) {
                return Some(share);
            }
            share /= 2.0;
        }
        go(0.0, closed);
        None
    }

    /// Whether a step changes the belt's tension by so small a share that none is left.
    fn is_last(&self, closed: &ClosedForms, [x, v_0]: [f64; 2]) -> bool {
        let outputs = closed.outputs();
        let tension = outputs.get(Derived::TightTension).max(outputs.get(Derived::SlackTension));
        let per_strain = self.drive.longitudinal_stiffness / tension;
        let by_speed = (v_0 / closed.get(Given::BeltSpeed)).abs() * per_strain;
        let radius = self.drive.input_radius.min(self.drive.output_radius);
        let is_torque = matches!(self.unknown, Given::InputTorque | Given::OutputTorque);
        let by_torque = if is_torque { x.abs() / (radius * tension) } else { 0.0 };
        by_speed.max(by_torque) < LAST_STEP.max(ROUNDINGS * f64::EPSILON * per_strain)
    }
}

/// Whether the belt runs more slowly than a wave along it, is pressed into both grooves, and adheres somewhere on
/// `pulley`.
pub(super) fn is_possible(drive: &SimpleDrive, closed: &ClosedForms, pulley: PulleyId) -> bool {
    let outputs = closed.outputs();
    let (v_0, lift_off) = (closed.get(Given::BeltSpeed), outputs.get(Derived::LiftOffForce));
    // K has a pole where the belt is as fast as a wave, and is negative beyond.
    let runs = v_0 > 0.0 && lift_off >= 0.0;
    let tight = outputs.get(Derived::SlackForce) > lift_off && outputs.get(Derived::TightForce) > lift_off;
    let sliding = match pulley {
        PulleyId::Output => outputs.get(Derived::OutputSlidingAngle),
        PulleyId::Input => outputs.get(Derived::InputSlidingAngle),
    };
    runs && tight && sliding <= drive.contact_angle(pulley)
}
