//! The test set solved: true errors, and no success that is none.

use crate::problems;
use crate::problems::catalogue::{Case, record};
use crate::problems::folds::{BRATU, NON};
use crate::problems::run::{How, errors, run};
use solver::{Accuracy, Guess, Options, Order, solve};

const TOLERANCE: f64 = 1e-6;

/// A success, judged in tolerances.
struct Judged {
    error: f64,
    estimate: f64,
    accuracy: Accuracy,
    how: How,
}

/// Solves and judges one case; `None` if it failed.
fn judge(case: &Case, parameter: Option<f64>, order: Order) -> Option<Judged> {
    let options = Options { order, tolerance: TOLERANCE, ..Options::default() };
    let outcome = run(case, parameter, &options);
    match outcome.solution {
        Ok(solution) => {
            let errors = errors(case, parameter, &solution);
            let again = solve(&*case.problem, &Guess::from(&solution), &case.unknowns, &options).unwrap();
            let (iterations, intervals) = (again.stats().newton_iterations, again.intervals());
            assert_eq!((iterations, intervals), (1, solution.intervals()), "{} at {parameter:?} again", case.id);
            assert!(!errors.everywhere.is_nan(), "{} at {parameter:?}: nothing to compare with", case.id);
            let error = errors.tabulated.max(errors.everywhere) / TOLERANCE;
            let (estimate, accuracy) = (solution.error_estimate() / TOLERANCE, solution.accuracy());
            Some(Judged { error, estimate, accuracy, how: outcome.how })
        }
        Err(reason) => {
            println!("{} at {parameter:?}, {order:?}: {reason}", case.label());
            None
        }
    }
}

#[test]
fn moderate_parameters_are_solved_to_ten_times_the_tolerance() {
    for case in problems::cases() {
        let parameter = case.parameters()[0];
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            match judge(&case, parameter, order) {
                None => panic!("{} at {parameter:?}, {order:?} failed", case.id),
                Some(Judged { error, accuracy, how, .. }) => {
                    assert!(error <= 10.0, "{} at {parameter:?}, {order:?}: {error} tolerances", case.id);
                    assert_eq!(accuracy, Accuracy::Met, "{} at {parameter:?}, {order:?}", case.id);
                    // T26 needs continuation even here; T23 does where no other order finds where to start from.
                    let is_long = case.id == "T26" || (case.id == "T23" && order == Order::SixGauss);
                    assert!(how == How::Direct || is_long, "{} at {parameter:?} went by {how:?}", case.id);
                }
            }
        }
    }
}

/// T35 alone may be less accurate, its condition number being about exp(1/(2 eps)); but it must say so.
#[test]
fn hard_parameters_are_solved_to_ten_times_the_tolerance() {
    for case in problems::cases().into_iter().filter(|case| case.parameters().len() > 1) {
        let parameter = case.parameters()[1];
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            let Some(Judged { error, estimate, accuracy, .. }) = judge(&case, parameter, order) else {
                panic!("{} at {parameter:?} failed", case.id);
            };
            if case.id == "T35" {
                let short = matches!(accuracy, Accuracy::Short { .. });
                assert!(
                    error <= 10.0 || (short && error < 10.0 * estimate),
                    "{error} tolerances, {estimate} estimated"
                );
            } else {
                assert!(error <= 10.0, "{} at {parameter:?}, {order:?}: {error} tolerances", case.id);
            }
        }
    }
}

/// A periodic orbit of unknown period from a rough guess, on twenty meshes: an iteration that insists on progress at
/// every step succeeds on a few of them only. Some lead to the orbit run through backwards or twice, which are
/// solutions too.
#[test]
fn a_rough_guess_of_a_periodic_orbit_leads_to_it_from_nearly_every_mesh() {
    let mut case = problems::cases().into_iter().find(|case| case.id == "NERVE").unwrap();
    let period = case.references(None)[0].constants[0];
    let (mut solved, mut plain) = (0, 0);
    for intervals in [2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 50, 60, 80, 100, 150, 200] {
        case = case.intervals(intervals);
        for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
            let options = Options { order, tolerance: TOLERANCE, ..Options::default() };
            let solution = match run(&case, None, &options).solution {
                Ok(solution) => solution,
                Err(reason) => {
                    println!("{intervals} intervals, {order:?}: {reason}");
                    continue;
                }
            };
            assert_eq!(solution.accuracy(), Accuracy::Met);
            let periods = solution.constants()[case.unknowns[0]] / period;
            assert!((periods - periods.round()).abs() < 1e-5 && periods.round() != 0.0, "{periods}");
            solved += 1;
            plain += usize::from(errors(&case, None, &solution).tabulated <= 10.0 * TOLERANCE);
        }
    }
    println!("{solved} of 60 solved, {plain} of them by the plain orbit");
    assert!(solved >= 51 && plain >= 30, "{solved} {plain}");
}

/// The smooth solution is found from the guess; the one with a corner by continuation from where both agree.
#[test]
fn the_corner_solution_is_reached_by_continuation() {
    let case = problems::nonlinear::corner();
    let options = Options { order: Order::Six, tolerance: TOLERANCE, ..Options::default() };
    let (solution, _) = problems::run::continued(&case, Some(20.0), &options).unwrap();
    let errors = errors(&case, Some(20.0), &solution.unwrap());
    assert!(errors.tabulated.max(errors.everywhere) < 10.0 * TOLERANCE, "{errors:?}");
}

#[test]
fn folds_as_boundary_value_problems_have_eight_digits() {
    for fold in [BRATU, NON] {
        let found = fold.locate();
        for (value, reference) in found.values().into_iter().zip(fold.reference()) {
            assert!((value - reference).abs() < 0.5e-8 * reference.abs(), "{}: {value} is not {reference}", fold.id);
        }
    }
}

/// Both branches of Bratu's problem, at the parameters of the data.
#[test]
fn both_branches_of_bratus_problem() {
    let cases = problems::cases();
    let case = cases.iter().find(|case| case.id == "T34").unwrap();
    for branch in record("FOLD_BRATU")["branches"].as_array().unwrap() {
        let [lambda, peak, slope] = ["lam", "y1_max", "y2_at_0"].map(|name| branch[name].as_f64().unwrap());
        let guess = Guess::uniform(case.problem.layout(), 20, &[lambda], |_, x, y| {
            let (sin, cos) = (std::f64::consts::PI * x).sin_cos();
            (y[0], y[1]) = (peak * sin, std::f64::consts::PI * peak * cos);
        });
        let options = Options { order: Order::Six, tolerance: 1e-9, ..Options::default() };
        let solution = solve(&*case.problem, &guess, &[], &options).unwrap();
        let line = &solution.regions()[0];
        let error = (line.eval(0.5)[0] - peak).abs().max((line.state(1)[0] - slope).abs() / (1.0 + slope));
        assert!(error < 1e-8, "lambda = {lambda}, peak {peak}: {error}");
    }
}
