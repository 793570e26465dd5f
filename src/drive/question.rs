//! What is asked of a drive: its constants, and which of the given ones are unknown for something else that is
//! prescribed.

use super::closing::Closing;
use crate::case::{constant_label, output_label};
use crate::model::{Constant, Constants, Output};

/// What is prescribed in place of a given constant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// An output: one more boundary equation, "output − value = 0".
    Output(Output),
    /// A constant that is unknown by default, as the speed ratio is: no equation more, an unknown less.
    Constant(Constant),
}

impl Known {
    /// How messages name it: by its key of the case file, or as in the result object.
    pub fn name(self) -> String {
        match self {
            Self::Output(output) => output_label(output),
            Self::Constant(constant) => constant_label(constant),
        }
        .to_owned()
    }
}

/// A given constant made unknown, and what is prescribed in its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swap {
    /// The constant that is found.
    pub free: Constant,
    /// What is prescribed.
    pub known: Known,
    /// Its value, SI.
    pub value: f64,
}

/// A boundary value problem about a drive: by default eight constants are unknown and all others given; each swap
/// makes a given one unknown and prescribes something in its place. All of it is solved at once.
///
/// ```
/// use sheave::case::Case;
/// use sheave::drive::{Constant, Output, Question, SolveOptions, solve_question};
/// // How stiff may the belt be for 96 % overall efficiency?
/// let case = Case::base().resolve()?;
/// let question = Question::of(&case).swap(Constant::BendingStiffness, Output::EfficiencyOverall, 0.96);
/// let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
/// let solved = solve_question(&case.model, &question, &options)?;
/// assert!(solved.solution.constants()[Constant::BendingStiffness.index()] < 0.2602);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Question {
    /// Given constants; where an unknown one is, the value near which an ordinary solution is sought first.
    pub constants: Constants,
    /// What is prescribed in place of what.
    pub swaps: Vec<Swap>,
    /// Laws that close the drive, each with the given constant that is found for it.
    pub closings: Vec<Closing>,
}

impl Question {
    /// The ordinary question: everything given but the eight default unknowns.
    pub fn new(constants: Constants) -> Self {
        Self { constants, swaps: Vec::new(), closings: Vec::new() }
    }

    /// The question with `free` unknown and `output` prescribed in its place.
    #[must_use]
    pub fn swap(mut self, free: Constant, output: Output, value: f64) -> Self {
        self.swaps.push(Swap { free, known: Known::Output(output), value });
        self
    }

    /// The question with a constant unknown, and a law that determines it.
    #[must_use]
    pub fn close(mut self, closing: Closing) -> Self {
        self.closings.push(closing);
        self
    }

    /// Whether it is the ordinary question: nothing prescribed in place of a given constant.
    pub fn is_ordinary(&self) -> bool {
        self.swaps.is_empty() && self.closings.is_empty()
    }

    /// The question with `free` unknown and `known`, which is unknown by default, given in its place.
    #[must_use]
    pub fn swap_constant(mut self, free: Constant, known: Constant, value: f64) -> Self {
        self.swaps.push(Swap { free, known: Known::Constant(known), value });
        self
    }

    /// The constants that are found, in order.
    pub fn unknowns(&self) -> Vec<Constant> {
        let fixed = |constant: &Constant| !self.swaps.iter().any(|swap| swap.known == Known::Constant(*constant));
        let default = Constant::ALL.into_iter().take(Constant::UNKNOWN).filter(fixed);
        let mut unknowns: Vec<Constant> = default.chain(self.freed()).collect();
        unknowns.sort();
        unknowns
    }

    /// Whether a given constant is unknown.
    pub fn frees(&self, constant: Constant) -> bool {
        self.freed().any(|freed| freed == constant)
    }

    /// The constants that are unknown for something else.
    fn freed(&self) -> impl Iterator<Item = Constant> + '_ {
        self.swaps.iter().map(|swap| swap.free).chain(self.closings.iter().map(|closing| closing.free))
    }

    /// Outputs that are prescribed, with their values, in the order in which their equations follow the belt's own.
    pub fn conditions(&self) -> impl Iterator<Item = (Output, f64)> + '_ {
        self.swaps.iter().filter_map(|swap| match swap.known {
            Known::Output(output) => Some((output, swap.value)),
            Known::Constant(_) => None,
        })
    }
}
