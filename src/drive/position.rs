//! Where a solution stands with regard to a question, and where the question wants it.

use solver::{Problem, Solution};

use super::belt::BeltProblem;
use super::closing;
use super::failure::Failure;
use super::question::{Known, Question};
use super::solved::Solved;
use crate::model::{Constant, Constants, InternalError};

/// All constants of the problem that a question poses, in the order of its layout: those of the drive, then what its
/// prescribed outputs and its laws are asked to be.
#[derive(Debug, Clone)]
pub(super) struct Position {
    pub drive: Constants,
    pub targets: Vec<f64>,
}

impl Position {
    /// What a question asks; of a given constant that is unknown, the value near which it is sought.
    pub fn asked(question: &Question) -> Self {
        let mut drive = question.constants.clone();
        for swap in &question.swaps {
            if let Known::Constant(constant) = swap.known {
                drive[constant] = swap.value;
            }
        }
        let laws = question.closings.iter().map(|_| 0.0);
        Self { drive, targets: question.conditions().map(|(_, value)| value).chain(laws).collect() }
    }

    /// Where the solution of another question stands: every prescribed output and every law at the value that it has
    /// there.
    ///
    /// # Errors
    /// [`Failure::Internal`] for an output that the drives of this model do not have.
    pub fn of(from: &Solved, question: &Question) -> Result<Self, Failure> {
        let drive = Constants::try_from(from.solution.constants())?;
        if question.is_ordinary() {
            return Ok(Self { drive, targets: Vec::new() });
        }
        let values = from.belt.output_values(&from.solution)?;
        let outputs = question.conditions().map(|(output, _)| values.get(output));
        let laws = question.closings.iter().map(|closing| closing::residual(&*closing.law, &values, &drive.0));
        let targets = outputs.chain(laws).collect::<Result<_, InternalError>>()?;
        Ok(Self { drive, targets })
    }

    /// That of a solution of the question's own problem.
    ///
    /// # Errors
    /// [`InternalError::Length`] for a solution of another problem.
    pub fn within(solution: &Solution) -> Result<Self, InternalError> {
        let constants = solution.constants();
        let targets = constants.get(Constant::ALL.len()..).unwrap_or_default().to_vec();
        Ok(Self { drive: Constants::try_from(constants)?, targets })
    }

    /// A share of the path to another position: the slip threshold moves geometrically, all others linearly.
    pub fn toward(&self, to: &Self, share: f64) -> Self {
        let between = |(here, there): (&f64, &f64)| if share == 1.0 { *there } else { here + share * (there - here) };
        let targets = self.targets.iter().zip(&to.targets).map(between).collect();
        Self { drive: self.drive.toward(&to.drive, share), targets }
    }

    /// As one vector.
    pub fn vector(&self) -> Vec<f64> {
        self.drive.0.iter().chain(&self.targets).copied().collect()
    }

    /// Typical magnitude of each value: its own, and that of the equation for what an equation asks for.
    pub fn magnitudes(&self, belt: &BeltProblem) -> Vec<f64> {
        let scales = belt.layout().constants.iter().skip(Constant::ALL.len()).map(|constant| constant.scale);
        let targets = self.targets.iter().zip(scales).map(|(value, scale)| value.abs().max(scale.unwrap_or(0.0)));
        let own = self.drive.0.iter().map(|value| value.abs()).chain(targets);
        own.map(|size| size.max(f64::MIN_POSITIVE)).collect()
    }
}

impl Constants {
    /// Those of a solution.
    pub(super) fn of(solution: &Solution) -> Self {
        let value = |constant: Constant| solution.constants().get(constant.index()).copied().unwrap_or(f64::NAN);
        Self(Constant::ALL.map(value))
    }

    /// A share of the path to other constants: the slip threshold moves geometrically, all others linearly.
    pub(super) fn toward(&self, to: &Self, share: f64) -> Self {
        let mut constants = self.clone();
        for constant in Constant::ALL {
            let (here, there) = (self[constant], to[constant]);
            constants[constant] = match constant {
                _ if share == 1.0 => there,
                Constant::SlipThreshold if here > 0.0 && there > 0.0 => here * libm::pow(there / here, share),
                _ => here + share * (there - here),
            };
        }
        constants
    }
}
