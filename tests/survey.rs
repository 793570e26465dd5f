//! Designs of the survey that stand for a class each: what kept them from being solved or settled before.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "a test fails by panicking")]

use sheave::case::{Case, Clamp, Resolved};
use sheave::design::{LimitKind, LimitOptions, Verdict, largest_torque, smallest_slack_tension, verdict};
use sheave::drive::{Constant, Failure, Output, Question, Route, SolveOptions, Trouble, solve};

#[path = "../benches/designs/mod.rs"]
mod designs;

/// Designs that are solved, near their limits and far from them; the second lies beside the curve from easier loads.
const SOLVED: [(&str, u64, u64); 5] =
    [("consistent", 2, 0), ("consistent", 2, 87), ("thesis", 3, 0), ("published", 3, 0), ("string", 1, 7)];

/// Of seed 2, as the survey solves it.
fn case(index: u64) -> Resolved {
    designs::case("consistent", &designs::design(2, index)).unwrap()
}

fn options() -> SolveOptions {
    SolveOptions { tolerance: 1e-3, ..SolveOptions::default() }
}

/// In engine braking the secondary runs away where the primary slips: the belt that it drives is stretched by its own
/// inertia, and the curve to the primary's rest takes some tens of solutions rather than some hundreds.
#[test]
fn the_slip_limit_of_engine_braking_is_followed_to_the_rest_of_the_primary() {
    let options = LimitOptions { solve: options(), least_speed_efficiency: 0.0 };
    for (index, torque, tension) in [(24, -22.564, 667.27), (149, -16.175, 958.9)] {
        let case = case(index);
        let given = Question::of(&case).constants;
        let (largest, curve) = largest_torque(&case, &options).unwrap();
        assert_eq!(largest.kind, LimitKind::Collapse, "{index}");
        assert!((largest.value / torque - 1.0).abs() < 1e-3, "{index}: {}", largest.value);
        assert!(curve.points.len() < 60, "{index}: {}", curve.points.len());
        assert!(curve.points.last().unwrap().state.speed_efficiency < 0.011, "{index}");
        let (smallest, _) = smallest_slack_tension(&case, &options).unwrap();
        assert!((smallest.value / tension - 1.0).abs() < 1e-3, "{index}: {}", smallest.value);
        // The same limit, from two sides: what is asked for lies beyond it.
        assert!(largest.value > given[Constant::PrimaryTorque] && smallest.value > given[Constant::SlackTension]);
    }
}

/// What lies beyond its slip limit by less than a hundredth is told, too.
#[test]
fn a_brake_just_beyond_its_slip_limit_is_told() {
    let case = case(264);
    let failure = solve(&case, &options()).unwrap_err();
    match verdict(&case, &failure, &options()) {
        Verdict::Tension { given, limit, .. } => {
            assert!(limit.value > given && limit.value < 1.01 * given, "{given}: {}", limit.value);
        }
        other => panic!("{other}"),
    }
}

/// What lies beyond its limit by less than a thousandth is told where the limit is known as well as that; what lies
/// beyond by less than any limit is known to is not.
#[test]
fn a_limit_is_known_as_well_as_a_proof_asks() {
    let design = designs::case("thesis", &designs::design(10, 141)).unwrap();
    let at = |tension: f64| {
        let mut case = design.clone();
        case.operating_point.clamp = Clamp::SlackTension(tension);
        verdict(&case, &lost(&case), &options())
    };
    let limit = 579.164;
    for share in [1.7e-3, 5e-4] {
        match at(limit / (1.0 + share)) {
            Verdict::Tension { limit: found, easing: None, .. } => {
                assert!((found.value / limit - 1.0).abs() < 1e-5, "{}", found.value);
            }
            other => panic!("{share}: {other}"),
        }
    }
    for share in [3e-5, -3e-5, -5e-4] {
        assert_eq!(at(limit / (1.0 + share)), Verdict::Open, "{share}");
    }
}

/// Where friction is steep, nodes that are added to a mesh, and the kinks of the law, are what Newton's iteration fails
/// at: meshes that are fine before the threshold is small lead there, and a law without kinks.
#[test]
fn fine_meshes_and_smooth_friction_lead_to_small_slip_thresholds() {
    let mut routes = Vec::new();
    for index in [144, 163, 190, 254] {
        let solved = solve(&case(index), &options()).unwrap_or_else(|failure| {
            panic!("{failure}: sheave solve --tol 1e-3 {}", designs::settings(&designs::design(2, index)))
        });
        // The solution is that of the case's own law.
        assert!(
            solved.solution.max_defect() <= 1e-3 && solved.question.constants == Question::of(&case(index)).constants
        );
        routes.push(solved.route);
    }
    for route in [Route::Fine, Route::Smooth] {
        assert!(routes.contains(&Some(route)), "{routes:?}");
    }
}

/// Where a belt without bending stiffness adheres, Newton's iteration is lost at the kinks of the friction law, unless
/// they are at nodes. All but the first were lost before.
#[test]
fn a_string_adheres_with_the_kinks_of_its_law_at_nodes() {
    for index in [4, 3, 5, 72] {
        let case = designs::case("string", &designs::design(1, index)).unwrap();
        let solved = solve(&case, &options()).unwrap();
        assert_eq!(solved.route, Some(Route::Kinks), "{index}");
        // The solution is that of the drive's own problem.
        assert!(solved.solution.max_defect() <= 1e-3, "{index}");
        assert_eq!(solved.question.constants, Question::of(&case).constants);
        assert_eq!(solved.solution.constants().len(), Constant::ALL.len());
        assert_eq!(solved.solution.regions().len(), 4);
    }
}

/// At a slip threshold at which the string's belt adheres nearly everywhere, it is what a beam becomes as its bending
/// stiffness vanishes: another model, another mesh, another route.
#[test]
fn a_string_is_the_limit_of_a_beam_at_a_small_slip_threshold() {
    let outputs = |edition: &str, stiffness: f64| {
        let mut case = Case::default();
        case.set("edition", edition).unwrap();
        case.set("sheave.slip_threshold", "1e-4 m/s").unwrap();
        if edition != "string" {
            case.set("belt.bending_stiffness", &stiffness.to_string()).unwrap();
        }
        let solved = solve(&case.resolve().unwrap(), &SolveOptions { tolerance: 1e-4, ..options() }).unwrap();
        let values = solved.belt.output_values(&solved.solution).unwrap();
        [Output::PrimaryAxialForce, Output::SecondaryAxialForce, Output::EfficiencyOverall]
            .map(|output| values.get(output).unwrap())
    };
    let (string, beam) = (outputs("string", 0.0), outputs("thesis", 1e-5));
    for (string, beam) in string.into_iter().zip(beam) {
        assert!((string / beam - 1.0).abs() < 1e-3, "{string} and {beam}");
    }
}

/// As if a case had been lost at the end of its path, for no reason that the belt shows.
fn lost(case: &Resolved) -> Failure {
    let given = Question::of(case).constants;
    Failure::Lost {
        trouble: Trouble::Unknown,
        torque: given[Constant::PrimaryTorque],
        slip_threshold: given[Constant::SlipThreshold],
        slack_tension: given[Constant::SlackTension],
        cause: Box::new(solver::SolveError::Cancelled),
    }
}

fn proof(edition: &str, seed: u64, index: u64) -> Verdict {
    let case = designs::case(edition, &designs::design(seed, index)).unwrap();
    verdict(&case, &lost(&case), &SolveOptions { work_limit: 4_000_000, ..options() })
}

/// Where the curve is lost at the case's own slip threshold, the limit is followed there from larger ones, or so far
/// that what is left of the way cannot bring it to the case.
#[test]
fn limits_are_followed_from_larger_slip_thresholds() {
    match proof("consistent", 1, 134) {
        Verdict::Tension { given, limit, easing: None } => {
            assert!((limit.value / 655.602 - 1.0).abs() < 1e-4 && given < 642.0, "{given}: {}", limit.value);
        }
        other => panic!("{other}"),
    }
    match proof("thesis", 3, 115) {
        Verdict::Tension { given, limit, easing: Some(easing) } => {
            assert!((limit.value / 459.346 - 1.0).abs() < 1e-4 && given < 433.0, "{given}: {}", limit.value);
            assert!(easing.slip_threshold < 1e-3 && easing.change < 1e-4, "{easing:?}");
        }
        other => panic!("{other}"),
    }
}

/// A belt without bending stiffness slips, too: a fold, and a pulley at rest.
#[test]
fn limits_of_a_string_are_followed() {
    match proof("string", 1, 52) {
        Verdict::Tension { given, limit, .. } => {
            assert_eq!(limit.kind, LimitKind::Fold);
            assert!((limit.value / 47.68 - 1.0).abs() < 1e-3 && given < 36.0, "{given}: {}", limit.value);
        }
        other => panic!("{other}"),
    }
    match proof("string", 1, 48) {
        Verdict::Torque { given, limit, .. } => {
            assert_eq!(limit.kind, LimitKind::Collapse);
            assert!((limit.value / -26.50 - 1.0).abs() < 1e-3 && given < -36.0, "{given}: {}", limit.value);
        }
        other => panic!("{other}"),
    }
}

/// No proof is found against a design that is solved.
#[test]
fn what_is_solved_lies_before_every_limit() {
    for (edition, seed, index) in SOLVED {
        match proof(edition, seed, index) {
            Verdict::Open => {}
            wrong => panic!("{edition} {seed} {index}: {wrong}"),
        }
    }
}
