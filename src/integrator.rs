//! What an integrator says where it gives up, in words.

use differential_equations::prelude::Error;
use differential_equations::traits::State;

/// Why an integration was given up; `place` says where that was.
pub(crate) fn reason<Y: State<f64>>(error: &Error<f64, Y>, place: impl Fn(f64) -> String) -> String {
    match error {
        Error::MaxSteps { t, .. } => format!("it takes too many steps, and the last one ends {}", place(*t)),
        Error::StepSize { t, .. } => format!("its steps become too small {}", place(*t)),
        Error::Stiffness { t, .. } => format!("it is too stiff for an explicit method {}", place(*t)),
        Error::LinearAlgebra { t, msg, .. } => format!("its algebra fails {}: {msg}", place(*t)),
        Error::BadInput { msg } => format!("the integrator refuses it: {msg}"),
        // Of values between steps and of equations with delays, which nobody asks for.
        Error::OutOfBounds { .. } | Error::NoLags | Error::InsufficientHistory { .. } => {
            "internal error: the integrator was asked for what it does not have; please report this case".to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_it_was_given_up_is_said() {
        let error: Error<f64, f64> = Error::StepSize { t: 2.5, y: 1.0 };
        assert_eq!(reason(&error, |time| format!("at {time:.1} s")), "its steps become too small at 2.5 s");
    }
}
