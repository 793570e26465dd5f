//! Operating points given in other ways: what is prescribed comes back, whatever it stands in place of.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::case::{Case, Resolved};
use sheave::drive::{
    Constant, Failure, IllPosed, Output, Question, SolveOptions, Solved, approach_question, solve, solve_along,
    solve_question,
};
use sheave::result::{Outcome, run};
use solver::Order;

fn case(settings: &[(&str, String)]) -> Resolved {
    let mut case = Case::base();
    for (key, value) in settings {
        case.set(key, value).unwrap();
    }
    case.resolve().unwrap_or_else(|error| panic!("{settings:?}: {error}"))
}

fn outcome(settings: &[(&str, String)], options: &SolveOptions) -> Outcome {
    run(&case(settings), options).unwrap_or_else(|failure| panic!("{settings:?}: {failure}"))
}

fn set(key: &'static str, value: f64) -> (&'static str, String) {
    (key, format!("{value:e}"))
}

fn accurate() -> SolveOptions {
    SolveOptions { tolerance: 1e-9, order: Order::Six, sensitivities: false, ..SolveOptions::default() }
}

fn rough() -> SolveOptions {
    SolveOptions { tolerance: 1e-4, ..SolveOptions::default() }
}

/// What can be given for each slot, as a result has it.
fn slots(outcome: &Outcome) -> [Vec<(&'static str, f64)>; 3] {
    let result = &outcome.result;
    let (primary, secondary) = (&result.primary, &result.secondary);
    [
        vec![("operating_point.primary_speed", primary.speed), ("operating_point.secondary_speed", secondary.speed)],
        vec![
            ("operating_point.primary_torque", primary.torque),
            ("operating_point.secondary_torque", secondary.torque),
            ("operating_point.speed_ratio", secondary.speed / primary.speed),
        ],
        vec![
            ("operating_point.slack_tension", primary.exit_tension),
            ("operating_point.tight_tension", primary.entry_tension),
            ("operating_point.primary_axial_force", primary.axial_force),
            ("operating_point.secondary_axial_force", secondary.axial_force),
        ],
    ]
}

/// Speed, torque and slack tension of the primary.
fn ordinary(solved: &Solved) -> [f64; 3] {
    [Constant::PrimarySpeed, Constant::PrimaryTorque, Constant::SlackTension].map(|constant| solved.constant(constant))
}

/// Gives the operating point of a solved drive in every way, and asks for the ordinary one back.
fn round_trips(drive: &[(&'static str, String)], [speeds, kinds]: [usize; 2]) -> usize {
    let known = outcome(drive, &accurate());
    let [all_speeds, loads, clamps] = slots(&known);
    let mut ways = 0;
    for speed in all_speeds.iter().take(speeds) {
        for load in loads.iter().take(kinds) {
            for clamp in &clamps {
                let point = [set(speed.0, speed.1), set(load.0, load.1), set(clamp.0, clamp.1)];
                let found = outcome(&[drive, &point].concat(), &accurate());
                for (found, known) in ordinary(&found.solved).into_iter().zip(ordinary(&known.solved)) {
                    assert!((found - known).abs() <= 1e-8 * known, "{drive:?} {point:?}: {found} for {known}");
                }
                ways += 1;
            }
        }
    }
    ways
}

#[test]
fn every_way_to_give_an_operating_point_gives_the_same() {
    assert_eq!(round_trips(&[("edition", "consistent".into())], [2, 3]), 24);
}

#[test]
fn it_does_so_in_other_editions_and_with_smooth_friction() {
    assert_eq!(round_trips(&[("edition", "thesis".into()), set("drive.ratio", 1.3)], [1, 3]), 12);
    assert_eq!(round_trips(&[("edition", "published".into())], [1, 1]), 4);
    // At the base case's threshold of 1e-4 m/s, rounding of sliding speeds moves the torque by 1e-7 with this law.
    let smooth = [("model.friction", "tanh".into()), set("sheave.slip_threshold", 1e-3), set("drive.ratio", 0.8)];
    assert_eq!(round_trips(&smooth, [1, 1]), 4);
}

#[test]
fn a_closed_belt_fits_from_a_cold_start() {
    for edition in ["consistent", "thesis"] {
        for ratio in [1.74, 1.2, 0.86, 0.72] {
            for free in ["primary_radius", "secondary_radius"] {
                let settings = [("edition", edition.into()), set("drive.ratio", ratio), ("drive.free", free.into())];
                let result = outcome(&settings, &rough()).result;
                assert!(result.belt.length_error.abs() <= 1e-9, "{settings:?}: {:e}", result.belt.length_error);
                let found = result.secondary.radius / result.primary.radius;
                assert!((found / ratio - 1.0).abs() < 0.02, "{settings:?}: {found}");
            }
        }
    }
}

#[test]
fn with_the_length_closed_the_ratio_follows_from_axial_forces_alone() {
    let options = SolveOptions { tolerance: 1e-8, ..accurate() };
    for ratio in [1.3, 0.8] {
        let known = outcome(&[set("drive.ratio", ratio), ("drive.free", "primary_radius".into())], &options).result;
        let settings = [
            ("drive.free", "both".into()),
            set("operating_point.primary_axial_force", known.primary.axial_force),
            set("operating_point.secondary_axial_force", known.secondary.axial_force),
        ];
        let found = outcome(&settings, &options).result;
        for (found, known) in [
            (found.primary.radius, known.primary.radius),
            (found.secondary.radius, known.secondary.radius),
            (found.primary.exit_tension, known.primary.exit_tension),
            (found.secondary.torque, known.secondary.torque),
        ] {
            assert!((found / known - 1.0).abs() < 1e-6, "ratio {ratio}: {found} for {known}");
        }
        assert!(found.belt.length_error.abs() <= 1e-9);
    }
    // A fourth key of any kind closes it.
    let settings = [
        ("drive.free", "both".into()),
        set("operating_point.primary_torque", 18.0),
        set("operating_point.speed_ratio", 0.8),
    ];
    let result = outcome(&settings, &rough()).result;
    assert!((result.secondary.speed / result.primary.speed - 0.8).abs() < 1e-9);
    assert!(result.belt.length_error.abs() <= 1e-9);
}

#[test]
fn inputs_are_what_was_asked_and_pulleys_have_the_radii_found() {
    let result = outcome(&[set("drive.ratio", 1.2), ("drive.free", "primary_radius".into())], &rough()).result;
    let object = serde_json::to_value(&result).unwrap();
    let drive = object["inputs"]["drive"].as_object().unwrap();
    assert_eq!(drive["free"], "primary_radius");
    assert_eq!(
        (&drive["primary_radius"], &object["found"]["drive.primary_radius"]),
        (&drive["primary_radius"], &drive["primary_radius"])
    );
    let (primary, secondary) = (object["primary"]["radius"].as_f64(), object["secondary"]["radius"].as_f64());
    assert_eq!((drive["secondary_radius"].as_f64(), primary), (secondary, Some(result.primary.radius)));
    // Asked again with the radius that was found, the belt has the length it was closed to.
    let again = [set("drive.primary_radius", primary.unwrap()), set("drive.secondary_radius", secondary.unwrap())];
    assert!(outcome(&again, &rough()).result.belt.length_error.abs() < 1e-6);
}

#[test]
fn any_given_constant_may_be_unknown_and_any_output_prescribed() {
    let case = case(&[set("sheave.slip_threshold", 1e-3)]);
    let options = SolveOptions { tolerance: 1e-8, ..accurate() };
    let known = run(&case, &options).unwrap();
    let result = serde_json::to_value(&known.result).unwrap();
    let pairs = [
        (Constant::LongitudinalStiffness, "belt.unstretched_length"),
        (Constant::BendingStiffness, "primary.entry_angle"),
        (Constant::RadialStiffness, "secondary.resultant_y"),
        (Constant::MassPerLength, "belt.mass_flow"),
        (Constant::PrimaryRadius, "primary.wrap_angle"),
        (Constant::SecondaryRadius, "slack_span.arc_length"),
        (Constant::CenterDistance, "tight_span.unstretched_length"),
        (Constant::HalfAngle, "primary.axial_force"),
        (Constant::FrictionCoefficient, "secondary.binding_moment"),
        (Constant::SlipThreshold, "secondary.exit_tension"),
        (Constant::PrimarySpeed, "energy.friction_loss"),
        (Constant::PrimaryTorque, "efficiency.speed"),
        (Constant::SlackTension, "efficiency.overall"),
    ];
    for (constant, path) in pairs {
        let (region, key) = path.split_once('.').unwrap();
        let value = result[region][key].as_f64().unwrap();
        let mut question = Question::of(&case).swap(constant, path.parse::<Output>().unwrap(), value);
        question.constants[constant] *= 1.02;
        let solved = solve_question(&case.model, &question, &options);
        let solved = solved.unwrap_or_else(|failure| panic!("{constant:?} from {path}: {failure}"));
        let (found, expected) = (solved.constant(constant), known.solved.constant(constant));
        assert!((found / expected - 1.0).abs() < 1e-4, "{constant:?} from {path}: {found} for {expected}");
    }
}

/// Where the way from the stiffness that is given is lost, others begin at other stiffnesses.
#[test]
fn a_value_is_found_from_other_starts_where_the_first_way_is_lost() {
    for efficiency in [0.94, 0.93, 0.92, 0.9] {
        let question = Question::of(&case(&[])).swap(Constant::BendingStiffness, Output::EfficiencyOverall, efficiency);
        let solved = solve_question(&case(&[]).model, &question, &rough()).unwrap();
        let stiffness = solved.constant(Constant::BendingStiffness);
        let found = outcome(&[set("belt.bending_stiffness", stiffness)], &rough()).result.efficiency.overall.unwrap();
        assert!((found - efficiency).abs() < 2e-4, "{efficiency}: {found} at {stiffness}");
    }
}

#[test]
fn questions_without_an_answer_are_refused_with_their_reason() {
    let case = case(&[]);
    let output = |path: &str| path.parse::<Output>().unwrap();
    let said = |question: &Question| match solve_question(&case.model, question, &rough()) {
        Err(Failure::IllPosed(reason)) => (reason.clone(), reason.to_string()),
        other => panic!("{:?}", other.map(|solved| ordinary(&solved))),
    };
    let ask = || Question::of(&case);

    // What is prescribed is given already.
    let (reason, text) = said(&ask().swap(Constant::SlackTension, output("primary.torque"), 20.0));
    assert!(matches!(&reason, IllPosed::Dependent { names, .. } if names.len() == 2), "{reason:?}");
    for part in
        ["`operating_point.primary_torque`", "`primary.torque`", "`operating_point.slack_tension` would be left"]
    {
        assert!(text.contains(part), "{text}");
    }
    said(&ask().swap(Constant::SlackTension, output("primary.speed"), 300.0));
    said(&ask().swap(Constant::PrimaryTorque, output("primary.exit_tension"), 90.0));
    // No weight changes the belt's path.
    let weighed = ask().swap(Constant::MassPerLength, output("primary.wrap_angle"), 3.0);
    let (reason, text) = said(&weighed);
    assert!(matches!(&reason, IllPosed::NoInfluence { free, .. } if free.len() == 1), "{reason:?}");
    assert!(text.contains("`primary.wrap_angle` does not depend on `belt.mass_per_length`"), "{text}");
    // From a solution, too, it is what is prescribed that is not reached: a belt is there.
    let from = solve_question(&case.model, &ask(), &rough()).unwrap();
    let failure = approach_question(&from, &case.model, &weighed, &rough()).unwrap_err();
    assert!(matches!(&failure, Failure::Unreached { reached, .. } if reached.len() == 1), "{failure:?}");
    // Power is given by torque and speed.
    let (_, text) = said(&ask().swap(Constant::SlackTension, output("primary.power"), 6000.0));
    assert!(
        text.contains("primary_torque") && text.contains("primary_speed") && text.contains("primary.power"),
        "{text}"
    );
    // Two conditions for one thing.
    let speeds = ask().swap(Constant::PrimaryTorque, output("secondary.speed"), 350.0).swap(
        Constant::SlackTension,
        output("efficiency.speed"),
        0.99,
    );
    let (_, text) = said(&speeds);
    assert!(text.contains("secondary_speed") && text.contains("efficiency.speed"), "{text}");
    said(&ask().swap_constant(Constant::PrimaryTorque, Constant::SpeedRatio, 0.99).swap(
        Constant::SlackTension,
        output("efficiency.speed"),
        0.99,
    ));
    let force = output("primary.axial_force");
    said(&ask().swap(Constant::PrimaryTorque, force, 900.0).swap(Constant::SlackTension, force, 950.0));
    let efficiencies = ask()
        .swap(Constant::PrimaryTorque, output("efficiency.speed"), 0.99)
        .swap(Constant::SlackTension, output("efficiency.torque"), 0.95)
        .swap(Constant::BendingStiffness, output("efficiency.overall"), 0.94);
    said(&efficiencies);

    let (reason, _) = said(&ask().swap(Constant::SpeedRatio, force, 900.0));
    assert!(matches!(reason, IllPosed::Unknown { .. }));
    let (reason, _) = said(&ask().swap_constant(Constant::PrimaryTorque, Constant::HalfAngle, 0.2));
    assert!(matches!(reason, IllPosed::Given { .. }));
    let (reason, _) = said(&ask().swap(Constant::SlackTension, force, f64::NAN));
    assert!(matches!(reason, IllPosed::Value { .. }));
}

#[test]
fn what_cannot_be_reached_says_how_far_it_was() {
    // Faster than without load: the secondary drives.
    let fast = case(&[set("operating_point.speed_ratio", 1.02)]);
    assert!(solve(&fast, &rough()).unwrap().constant(Constant::PrimaryTorque) < 0.0);
    // The belt would have to be far longer than the pulleys, at this ratio, allow.
    let far = case(&[set("operating_point.primary_axial_force", 1e6)]);
    match solve(&far, &rough()) {
        Err(Failure::Unreached { reached, .. }) => {
            assert_eq!(reached.len(), 1);
            assert_eq!((reached[0].name.as_str(), reached[0].asked), ("operating_point.primary_axial_force", 1e6));
            assert!(reached[0].value < 1e6 && reached[0].value > 0.0);
        }
        other => panic!("{:?}", other.map(|solved| ordinary(&solved))),
    }
}

#[test]
fn sensitivities_are_with_respect_to_what_is_given() {
    let options = SolveOptions { tolerance: 1e-9, sensitivities: true, ..accurate() };
    let smooth = [("model.friction", "tanh".to_owned()), set("sheave.slip_threshold", 1e-2)];
    let at =
        |force: f64| outcome(&[&smooth[..], &[set("operating_point.primary_axial_force", force)]].concat(), &options);
    let found = at(1000.0).result.sensitivities.unwrap()["primary.exit_tension"].clone();
    let tension = |force: f64| at(force).result.primary.exit_tension;
    let difference = (tension(1002.0) - tension(998.0)) / 4.0;
    let derivative = found["operating_point.primary_axial_force"];
    assert!((derivative / difference - 1.0).abs() < 1e-5, "{derivative} for {difference}");
    assert!(!found.contains_key("operating_point.slack_tension"));
}

/// The keys and values of the seven input situations of a solved drive: two of speeds and torques, and one axial force.
fn situations(known: &Outcome) -> [[(&'static str, f64); 3]; 7] {
    let [speeds, loads, clamps] = slots(known);
    let (speed_in, speed_out) = (speeds[0], speeds[1]);
    let (torque_in, torque_out) = (loads[0], loads[1]);
    let (clamp_in, clamp_out) = (clamps[2], clamps[3]);
    [
        [speed_in, torque_out, clamp_out],
        [speed_out, torque_in, clamp_in],
        [speed_in, speed_out, clamp_out],
        [speed_in, speed_out, clamp_in],
        [speed_in, torque_out, clamp_in],
        [speed_in, torque_in, clamp_out],
        [speed_in, torque_in, clamp_in],
    ]
}

#[test]
fn the_seven_input_situations_are_operating_points() {
    let drive = [set("drive.ratio", 1.2), set("operating_point.slack_tension", 140.0)];
    let known = outcome(&drive, &accurate());
    for situation in situations(&known) {
        let settings: Vec<_> =
            [set("drive.ratio", 1.2)].into_iter().chain(situation.map(|(key, value)| set(key, value))).collect();
        let found = outcome(&settings, &accurate());
        for (found, known) in ordinary(&found.solved).into_iter().zip(ordinary(&known.solved)) {
            assert!((found / known - 1.0).abs() <= 1e-8, "{situation:?}: {found} for {known}");
        }
    }
}

/// With rules of thumb alone these 56 took 1472 steps.
#[test]
fn the_seven_input_situations_start_from_the_simple_drive() {
    let drives = [(0.85, 20.0, 200.0), (1.7, 22.0, 300.0), (1.45, 18.0, 220.0), (1.0, 10.0, 230.0)];
    let mut steps = 0;
    for edition in ["consistent", "thesis"] {
        for (ratio, torque, tension) in drives {
            let drive = [("edition", edition.into()), set("drive.ratio", ratio)];
            let point = [set("operating_point.primary_torque", torque), set("operating_point.slack_tension", tension)];
            let known = outcome(&[drive.clone(), point].concat(), &rough());
            for situation in situations(&known) {
                let settings: Vec<_> =
                    drive.clone().into_iter().chain(situation.map(|(key, value)| set(key, value))).collect();
                steps += outcome(&settings, &rough()).result.solver.continuation_steps;
            }
        }
    }
    assert!(steps < 1400, "{steps}");
}

#[test]
fn a_case_file_may_ask_for_any_constant() {
    let text = "swap = ['belt.bending_stiffness for efficiency.overall = 0.96', \
                'operating_point.slack_tension for secondary.axial_force = 0.6 kN']\n[drive]\nratio = 1.1";
    let case = Case::from_toml("case.toml", text).unwrap();
    let resolved = case.resolve().unwrap();
    case.check_posed(&resolved).unwrap();
    let outcome = run(&resolved, &rough()).unwrap();
    let result = &outcome.result;
    assert!(
        (result.efficiency.overall.unwrap() - 0.96).abs() < 1e-8 && (result.secondary.axial_force - 600.0).abs() < 1e-5
    );
    assert!(outcome.solved.constant(Constant::BendingStiffness) > 0.0);
    // What is written is read again.
    let inputs = serde_json::to_value(&resolved).unwrap();
    let again: Vec<&str> = inputs["swap"].as_array().unwrap().iter().map(|swap| swap.as_str().unwrap()).collect();
    let mut copy = Case::base();
    again.iter().for_each(|swap| copy.swap(swap).unwrap());
    assert_eq!(copy.resolve().unwrap().swaps, resolved.swaps);
}

#[test]
fn swaps_that_mean_nothing_are_bad_input() {
    for (text, said) in [
        ("belt.bending_stiffness", "KEY for OUTPUT"),
        ("belt.bending_stifness for efficiency.overall = 0.96", "`belt.bending_stiffness`"),
        ("belt.length for efficiency.overall = 0.96", "gives no constant"),
        ("belt.bending_stiffness for efficiency.overal = 0.96", "`efficiency.overall`"),
        ("belt.bending_stiffness for primary.axial_force = 3 kg", "a force"),
        ("belt.bending_stiffness for primary.axial_force = inf", "finite"),
    ] {
        let error = Case::base().swap(text).unwrap_err().to_string();
        assert!(error.contains(said), "{text}: {error}");
    }
    assert!(Case::from_toml("case.toml", "swap = 3").is_err());
    assert!(Case::from_toml("case.toml", "swap = [3]").is_err());
    // Understood, but without an answer: two conditions for one constant, a condition that says what is given.
    let command = |swaps: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"));
        command.args(["solve", "--json", "--tol", "1e-3"]);
        for swap in swaps {
            command.args(["--swap", swap]);
        }
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (status, text) = command(&["belt.bending_stiffness for primary.power = 6 kW"]);
    assert_eq!(status, Some(2), "{text}");
    let object: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(object["failure"]["message"].as_str().unwrap().contains("`primary.power`"), "{text}");
    let twice = "belt.bending_stiffness for efficiency.overall = 0.96";
    assert_eq!(command(&[twice, "belt.bending_stiffness for primary.axial_force = 900"]).0, Some(2));
    let (status, text) = command(&[twice]);
    assert_eq!(status, Some(0), "{text}");
}

/// Questions nearby are one predicted step apart, whatever is prescribed in place of what: a chain of them takes a
/// fraction of the work of as many cold starts, and ends at the same drives.
#[test]
fn a_neighbour_of_a_prescribed_drive_is_one_step_away() {
    let known = outcome(&[set("drive.ratio", 1.3), ("drive.free", "primary_radius".into())], &rough()).result;
    let forces = [known.primary.axial_force, known.secondary.axial_force];
    type Settings = Vec<(&'static str, String)>;
    let chains: [(&str, &dyn Fn(f64) -> Settings); 3] = [
        ("ratio of a closed belt", &|share| {
            vec![set("drive.ratio", 1.3 * share), ("drive.free", "primary_radius".into())]
        }),
        ("axial force", &|share| vec![set("operating_point.primary_axial_force", forces[0] * share)]),
        ("both axial forces of a closed belt", &|share| {
            vec![
                ("drive.free", "both".into()),
                set("operating_point.primary_axial_force", forces[0] * share),
                set("operating_point.secondary_axial_force", forces[1]),
            ]
        }),
    ];
    for (name, settings) in chains {
        let [mut warm, mut cold] = [0, 0];
        let mut trail: Vec<Solved> = Vec::new();
        for step in 0..6 {
            let case = case(&settings(1.0 - 0.01 * f64::from(step)));
            let from_nothing = solve(&case, &rough()).unwrap_or_else(|failure| panic!("{name} {step}: {failure}"));
            if step == 0 {
                trail.push(from_nothing);
                continue;
            }
            let near: Vec<&Solved> = trail.iter().skip(trail.len().saturating_sub(2)).collect();
            let solved =
                solve_along(&near, &case, &rough()).unwrap_or_else(|failure| panic!("{name} {step}: {failure}"));
            assert_eq!(solved.continuation_steps, 1, "{name}, step {step}");
            for constant in Constant::ALL {
                let (a, b) = (solved.constant(constant), from_nothing.constant(constant));
                assert!((a - b).abs() <= 1e-3 * b.abs(), "{name}, step {step}, {constant:?}: {a} and {b}");
            }
            warm += solved.stats.newton_iterations;
            cold += from_nothing.stats.newton_iterations;
            trail.push(solved);
        }
        println!("{name}: {warm} Newton iterations from neighbours, {cold} from nothing");
        assert!(4 * warm <= cold, "{name}: {warm} from neighbours, {cold} from nothing");
    }
}
