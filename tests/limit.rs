//! Limits and optima: what they are, that they are where they say, and that they do not depend on the mesh.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::case::{Case, Resolved};
use sheave::design::{
    DesignError, LimitKind, LimitOptions, OptimumPlace, largest_torque, limit_figures, limit_map, optimum,
    optimum_figures, optimum_map, smallest_clamps,
};
use sheave::drive::{Constant, Question, SolveOptions, solve, step_to_question};
use sheave::model::Output;
use sheave::result::run;
use sheave::study::{Axis, Study};
use sheave::{Cancel, cancellable};
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

fn case(settings: &[(&str, &str)]) -> Resolved {
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    case.resolve().unwrap()
}

fn to(tolerance: f64) -> SolveOptions {
    SolveOptions { tolerance, ..SolveOptions::default() }
}

fn limits(tolerance: f64) -> LimitOptions {
    LimitOptions { solve: to(tolerance), least_speed_efficiency: 0.0 }
}

#[test]
fn the_slip_limit_of_the_thesis_is_the_collapse_of_the_speed_ratio() {
    let thesis = case(&[("edition", "thesis")]);
    let (rough, branch) = smallest_clamps(&thesis, &limits(1e-4)).unwrap();
    let (fine, _) = smallest_clamps(&thesis, &limits(1e-6)).unwrap();
    for (rough, fine) in [
        (&rough.slack_tension, &fine.slack_tension),
        (&rough.primary_axial_force, &fine.primary_axial_force),
        (&rough.secondary_axial_force, &fine.secondary_axial_force),
    ] {
        assert_eq!((&rough.kind, &fine.kind), (&LimitKind::Collapse, &LimitKind::Collapse));
        assert!((rough.value / fine.value - 1.0).abs() < 1e-4, "{} {}", rough.value, fine.value);
        assert_eq!(fine.state.speed_efficiency, 0.0);
        assert!((fine.state.primary_torque - 18.0).abs() < 1e-6);
    }
    assert!((fine.slack_tension.value - 18.349).abs() < 0.002, "{}", fine.slack_tension.value);
    // Few solutions tell it: work, not luck.
    assert!(branch.points.len() < 30, "{}", branch.points.len());
    // No drive is possible below, one is above; and the other way round it is the same limit.
    let at = |tension: f64| case(&[("edition", "thesis"), ("operating_point.slack_tension", &tension.to_string())]);
    assert!(solve(&at(18.2), &to(1e-4)).is_err());
    assert!(solve(&at(18.6), &to(1e-4)).is_ok());
    let (torque, _) = largest_torque(&at(fine.slack_tension.value), &limits(1e-6)).unwrap();
    assert_eq!(torque.kind, LimitKind::Collapse);
    assert!((torque.value - 18.0).abs() < 1e-3, "{}", torque.value);
}

#[test]
fn a_clamp_below_the_limit_does_not_hide_it() {
    // A stiff belt on a small primary carries little torque, but wants more tension than its torque suggests.
    let at = |tension: &str| {
        case(&[
            ("edition", "thesis"),
            ("drive.ratio", "1.9289"),
            ("operating_point.slack_tension", tension),
            ("operating_point.primary_torque", "2.7514"),
            ("operating_point.primary_speed", "588.47"),
            ("belt.bending_stiffness", "0.49951"),
            ("sheave.friction_coefficient", "0.37205"),
        ])
    };
    assert!(solve(&at("20"), &to(1e-4)).is_err());
    let [below, above] = ["20", "150"].map(|tension| smallest_clamps(&at(tension), &limits(1e-5)).unwrap().0);
    assert!(below.slack_tension.value > 20.0, "{}", below.slack_tension.value);
    assert_eq!(below.slack_tension.kind, above.slack_tension.kind);
    assert!((below.slack_tension.value / above.slack_tension.value - 1.0).abs() < 1e-4);
    let [below, above] = ["20", "150"].map(|tension| optimum(&at(tension), &to(1e-5)).unwrap());
    assert!((below.state.slack_tension / above.state.slack_tension - 1.0).abs() < 1e-3);
}

#[test]
fn continuous_shear_carries_the_torque_without_slack_tension() {
    let (limit, _) = smallest_clamps(&case(&[]), &limits(1e-5)).unwrap();
    assert_eq!(limit.slack_tension.kind, LimitKind::Collapse);
    assert!((-1.0..0.0).contains(&limit.slack_tension.value), "{}", limit.slack_tension.value);
    assert!((limit.primary_axial_force.value - 458.0).abs() < 0.5);
}

#[test]
fn the_printed_equations_fold_in_the_secondarys_axial_force() {
    let published = [("edition", "published")];
    let (limits, branch) = smallest_clamps(&case(&published), &limits(1e-6)).unwrap();
    let fold = &limits.secondary_axial_force;
    assert_eq!((&fold.kind, &limits.slack_tension.kind), (&LimitKind::Fold, &LimitKind::Collapse));
    assert!(fold.state.speed_efficiency > 0.5 && fold.state.speed_efficiency < 0.95, "{:?}", fold.state);
    let values = branch.points.iter().map(|point| point.state.secondary_axial_force);
    assert!(values.fold(f64::INFINITY, f64::min) >= fold.value - 1e-4);
    let with = |force: f64| {
        let force = ("operating_point.secondary_axial_force", force.to_string());
        solve(&case(&[published[0], (force.0, &force.1)]), &to(1e-4))
    };
    assert!(with(fold.value + 0.5).is_ok());
    assert!(with(fold.value - 0.5).is_err());
}

/// On the first, slack tension and speed efficiency turn close to each other; on the others, the axial force has a
/// minimum and a maximum at nearly the same speed.
#[test]
fn curves_that_turn_twice_are_followed() {
    let drive = |edition: &str, torque: &str, ratio: &str| {
        let keys = [("edition", edition), ("operating_point.primary_torque", torque), ("drive.ratio", ratio)];
        smallest_clamps(&case(&keys), &limits(1e-5)).unwrap()
    };
    let (smallest, branch) = drive("thesis", "12", "1.2");
    assert_eq!(
        (&smallest.slack_tension.kind, &smallest.primary_axial_force.kind),
        (&LimitKind::Fold, &LimitKind::Collapse)
    );
    assert!((smallest.slack_tension.value - 3.2855).abs() < 2e-4, "{:?}", smallest.slack_tension);
    assert!((smallest.slack_tension.state.speed_efficiency - 0.9112).abs() < 1e-4);
    assert!((smallest.primary_axial_force.value - 238.348).abs() < 1e-2);
    assert!(branch.points.len() < 45, "{}", branch.points.len());
    for (ratio, force) in [("1.02", 171.901), ("1.44", 228.298)] {
        let smallest = drive("consistent", "6", ratio).0.primary_axial_force;
        assert_eq!(smallest.kind, LimitKind::Fold, "ratio {ratio}");
        assert!((smallest.value - force).abs() < 2e-3, "ratio {ratio}: {}", smallest.value);
    }
}

#[test]
fn a_least_speed_efficiency_is_a_limit_of_its_own() {
    let options = LimitOptions { least_speed_efficiency: 0.95, ..limits(1e-5) };
    let (limit, _) = largest_torque(&case(&[("operating_point.slack_tension", "20")]), &options).unwrap();
    assert_eq!(limit.kind, LimitKind::SpeedEfficiency);
    assert!((limit.state.speed_efficiency - 0.95).abs() < 1e-9);
    let (stall, _) = largest_torque(&case(&[("operating_point.slack_tension", "20")]), &limits(1e-5)).unwrap();
    assert!(limit.value < stall.value);
    // The clamp may be given in any way, the belt may be closed.
    let force = [("operating_point.primary_axial_force", "818.6"), ("drive.free", "primary_radius")];
    let (limit, branch) = largest_torque(&case(&force), &options).unwrap();
    assert!((limit.state.primary_axial_force - 818.6).abs() < 1e-6 && limit.value > 18.0);
    let mut lengths = branch.points.iter().map(|point| point.value(Output::BeltUnstretchedLength).unwrap());
    assert!(lengths.all(|length| (length - 0.8572).abs() < 1e-9));
}

/// A string at a small slip threshold is hardly ever solved from a string nearby.
#[test]
fn a_string_has_a_best_clamp_too() {
    let best = optimum(&case(&[("edition", "string")]), &to(1e-3)).unwrap();
    assert_eq!(best.bound, OptimumPlace::Inner);
    assert!(best.state.slack_tension > 15.0 && best.state.slack_tension < 35.0, "{:?}", best.state);
}

/// A drive that is beyond what is asked of it from the start has no limit, and its start is none.
#[test]
fn a_start_beyond_the_criterion_is_no_limit() {
    let options = LimitOptions { least_speed_efficiency: 0.9999, ..limits(1e-3) };
    let error = largest_torque(&Case::base().resolve().unwrap(), &options).unwrap_err();
    assert!(matches!(error, DesignError::Beyond { had, .. } if had < 0.9999), "{error}");
    assert!(error.to_string().contains("no drive was found with a speed efficiency of 99.99 %"), "{error}");
}

#[test]
fn the_best_clamp_is_where_the_gradient_vanishes() {
    for (edition, tension, efficiency) in [("consistent", 38.57, 0.96191), ("thesis", 64.52, 0.97002)] {
        let rough = optimum(&case(&[("edition", edition)]), &to(1e-4)).unwrap();
        let best = optimum(&case(&[("edition", edition)]), &to(1e-6)).unwrap();
        assert_eq!(best.bound, OptimumPlace::Inner);
        assert!((best.state.slack_tension - tension).abs() < 0.02, "{edition}: {}", best.state.slack_tension);
        assert!((best.state.overall_efficiency - efficiency).abs() < 2e-5);
        assert!((rough.state.slack_tension / best.state.slack_tension - 1.0).abs() < 1e-3);
        assert!(best.evaluations <= 40, "{edition}: {}", best.evaluations);
        for factor in [0.9, 1.1] {
            let beside = (best.state.slack_tension * factor).to_string();
            let beside = case(&[("edition", edition), ("operating_point.slack_tension", &beside)]);
            let beside = run(&beside, &to(1e-6)).unwrap().result;
            assert!(beside.efficiency.overall.unwrap() < best.state.overall_efficiency);
        }
    }
}

#[test]
fn the_slip_reserve_falls_to_nothing_at_the_limit() {
    for (edition, tensions) in [("thesis", ["200", "60", "25", "18.4"]), ("consistent", ["200", "40", "5", "0.2"])] {
        let reserves = tensions.map(|tension| {
            let case = case(&[("edition", edition), ("operating_point.slack_tension", tension)]);
            run(&case, &to(1e-5)).unwrap().result.slip_reserve
        });
        assert!(reserves.windows(2).all(|pair| pair[0] > pair[1]), "{edition}: {reserves:?}");
        assert!(reserves[0] > 0.5 && reserves[3] < 0.01 && reserves[3] > 0.0, "{edition}: {reserves:?}");
    }
}

#[test]
fn maps_are_tables_with_figures() {
    let axes =
        ["operating_point.primary_torque=10,18 N*m", "drive.ratio=0.8,1.2"].map(|axis| Axis::parse(axis).unwrap());
    let study = Study::new(Case::base(), axes, to(1e-4)).unwrap();
    let limit = limit_map(&study, Some(2), &limits(1e-4)).unwrap();
    let best = optimum_map(&study, Some(1), &to(1e-4)).unwrap();
    assert_eq!((limit.failures(), best.failures(), limit.rows.len()), (0, 0, 4));
    let force = |row| limit.number(row, "smallest_clamp.primary_axial_force.value");
    let chosen = |row| best.number(row, "state.primary_axial_force");
    assert!((0..4).all(|row| force(row) < chosen(row)));
    assert!(force(0) < force(2) && chosen(1) < chosen(3));
    for figure in limit_figures(&study, &limit).into_iter().chain(optimum_figures(&study, &best)) {
        assert_eq!(figure.series.len(), 2);
        assert!(figure.series.iter().all(|series| series.points.iter().all(|(x, y)| x.is_finite() && y.is_finite())));
        assert!(figure.series.iter().any(|series| series.label == "M_{in} = 10 N·m"));
        assert!(figure.svg().unwrap().contains(" = 10 N·m"));
    }
}

#[test]
fn cases_without_an_answer_are_bad_input() {
    let speed = case(&[("operating_point.secondary_speed", "300")]);
    assert!(matches!(largest_torque(&speed, &limits(1e-4)), Err(DesignError::Given { .. })));
    let ratio = case(&[("operating_point.speed_ratio", "0.99")]);
    assert!(matches!(smallest_clamps(&ratio, &limits(1e-4)), Err(DesignError::Given { .. })));
    assert!(matches!(optimum(&ratio, &to(1e-4)), Err(DesignError::Given { .. })));
}

#[test]
fn the_commands_say_what_the_library_finds() {
    let sheave = |arguments: &[&str]| {
        let program =
            Command::new(env!("CARGO_BIN_EXE_sheave")).args(arguments).env_remove("RUST_LOG").output().unwrap();
        (program.status.code(), String::from_utf8(program.stdout).unwrap(), String::from_utf8(program.stderr).unwrap())
    };
    let thesis = ["--tol", "1e-4", "--edition", "thesis", "--set", "operating_point.slack_tension=20"];
    let (status, text, _) = sheave(&[&["limit", "--stall"], &thesis[..]].concat());
    assert_eq!(status, Some(0));
    assert!(
        text.contains("smallest slack tension for a primary torque of 18.00 N·m") && text.contains("18.34"),
        "{text}"
    );
    let (status, text, _) = sheave(&[&["limit", "--stall", "--json"], &thesis[..]].concat());
    let object: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((status, &object["smallest_clamp"]["slack_tension"]["kind"]), (Some(0), &"collapse".into()));
    // Without being asked for the stall, it stops where a drive stops being of use, at a clamp that can be given.
    let base = ["limit", "--json", "--tol", "1e-4"];
    let (status, text, _) = sheave(&base);
    let object: serde_json::Value = serde_json::from_str(&text).unwrap();
    let clamp = &object["smallest_clamp"]["slack_tension"];
    assert_eq!(object["warnings"], serde_json::json!([]));
    assert_eq!((status, &clamp["kind"]), (Some(0), &"speed_efficiency".into()));
    let tension = format!("operating_point.slack_tension={}", clamp["value"]);
    let (status, text, _) = sheave(&["solve", "--json", "--tol", "1e-4", "--set", &tension]);
    let solved: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(status, Some(0));
    assert!((solved["efficiency"]["speed"].as_f64().unwrap() - 0.95).abs() < 1e-3);
    let (status, text, _) = sheave(&[&["optimum", "--json"], &thesis[..]].concat());
    let object: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((status, &object["bound"]), (Some(0), &"inner".into()));

    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_str().unwrap();
    let over = ["--over", "operating_point.primary_torque=12,18 N*m"];
    let (status, text, _) = sheave(&[&["optimum", "--out", path], &over[..], &thesis[..4]].concat());
    assert_eq!((status, text.as_str()), (Some(0), ""));
    for name in ["map.csv", "best_slack_tension.svg", "best_efficiency.png"] {
        assert!(folder.path().join(name).exists(), "{name}");
    }
    let (status, text, error) = sheave(&["optimum", "--set", "operating_point.speed_ratio=0.99"]);
    assert_eq!((status, text.as_str()), (Some(2), ""));
    assert!(error.contains("operating_point.speed_ratio"), "{error}");
    // Where the curve is lost, what is told is a bound, and said to be one.
    let (status, text, error) = sheave(&["limit", "--json", "--edition", "string"]);
    let object: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!((status, &object["largest_torque"]["kind"]), (Some(0), &"lost".into()));
    let said = object["warnings"][0].as_str().unwrap();
    assert!(said.starts_with("Only a bound is known") && said.contains("largest torque"), "{said}");
    assert!(error.contains(said) && said.contains("a larger `sheave.slip_threshold`"), "{error}");
    // What it says to try helps.
    let (status, text, error) = sheave(&["limit", "--edition", "string", "--set", "sheave.slip_threshold=0.1"]);
    assert!(status == Some(0) && text.contains("127.88") && !error.contains("Only a bound"), "{text}{error}");
    // A light torque is carried with less tractive tension than none, which no case can ask for.
    let (status, text, error) = sheave(&["limit", "--set", "operating_point.primary_torque=3"]);
    assert!(status == Some(0) && text.contains(" -3.7"), "{text}");
    assert!(error.contains("The smallest slack tension is below zero"), "{error}");
    assert_eq!(sheave(&["limit", "--least-speed-efficiency", "1.5"]).0, Some(2));
    assert_eq!(sheave(&["limit", "--over", "drive.ratio"]).0, Some(2));
}

/// Between ratio 1.52 and 1.53 the smallest axial force on the primary jumps, for the curve from a tight belt comes to
/// rest in another way: the way of the larger ratio exists at the smaller one, too, at less force.
#[test]
fn a_belt_comes_to_rest_in_two_ways() {
    let at = |ratio: f64| case(&[("drive.ratio", &ratio.to_string())]);
    let stall = |ratio: f64| {
        let (limits, branch) = smallest_clamps(&at(ratio), &limits(1e-4)).unwrap();
        assert_eq!(limits.primary_axial_force.kind, LimitKind::Collapse);
        (limits.primary_axial_force.value, branch.points.last().unwrap().solved.clone())
    };
    let (above, mut solved) = stall(1.53);
    let (below, _) = stall(1.52);
    assert!((above - 420.2).abs() < 0.5 && (below - 466.3).abs() < 0.5, "{above} {below}");
    for step in 1..=4 {
        let case = at(1.53 - 0.0025 * f64::from(step));
        let question = Question::of(&case).swap(Constant::SlackTension, Output::EfficiencySpeed, 0.0);
        solved = step_to_question(&solved, &case.model, &question, &to(1e-4)).unwrap();
    }
    let force = solved.belt.output_values(&solved.solution).unwrap().get(Output::PrimaryAxialForce).unwrap();
    assert!((force - above).abs() < 5.0 && force < below - 30.0, "{force}");
}

/// A search that is ended has found nothing: least of all that the loosest belt is best.
#[test]
fn a_search_for_the_best_clamp_ends_when_it_is_cancelled() {
    let asked = Arc::new(AtomicUsize::new(0));
    let case = case(&[("losses.include", "on")]);
    let ending_after = |limit: usize| {
        asked.store(0, Ordering::Relaxed);
        let count = asked.clone();
        let cancel = Cancel::asking(move || count.fetch_add(1, Ordering::Relaxed) >= limit);
        cancellable(&cancel, || optimum(&case, &to(1e-4)))
    };
    assert!(ending_after(usize::MAX).is_ok());
    let all = asked.load(Ordering::Relaxed);
    for share in [1, 5, 9, 13, 17] {
        let ended = ending_after(all * share / 20);
        assert!(
            matches!(&ended, Err(DesignError::Start(failure)) if failure.is_cancelled()),
            "{share} of 20: {ended:?}"
        );
    }
}

#[test]
fn a_map_without_an_answer_is_no_success() {
    let torques = ["--over", "operating_point.primary_torque=-10,-20 N*m", "--tol", "1e-3"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    let program = command.arg("optimum").args(torques).env_remove("RUST_LOG").output().unwrap();
    let text = String::from_utf8(program.stdout).unwrap();
    assert_eq!((program.status.code(), text.lines().count()), (Some(3), 3), "{text}");
}
