//! Power that flows back: engine braking of a belt and of whole drives, where losses add to what brakes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::ops::ControlFlow;
use std::path::Path;

use sheave::case::{Case, Resolved};
use sheave::drive::SolveOptions;
use sheave::equilibrium::{Direction, DriveReport, ShiftOptions, equilibrium_outcome, shift_branch};
use sheave::launch::{LaunchCurve, LaunchOptions, launch};
use sheave::quantity::Unit;
use sheave::result::{DriveResult, run};
use support::{Read, assert_derivatives};

#[path = "support/derivatives.rs"]
mod support;

/// The example drive with an engine of one torque at all speeds.
fn dragged(torque: &str, settings: &[(&str, &str)]) -> Resolved {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml");
    let engine = "file = \"parts/ch440.toml\"";
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(engine));
    let text = text.replace(engine, &format!("speeds = \"1000, 5000 rpm\"\ntorques = \"{torque}, {torque} N*m\""));
    let parts = path.parent().unwrap().join("parts");
    let text = text.replace("file = \"parts", &format!("file = \"{}", parts.display()));
    let case = Case::from_toml("dragged", &text).unwrap();
    let set = |case: Case, (key, value): &(&str, &str)| case.with(key, value).unwrap();
    settings.iter().fold(case, set).resolve().unwrap()
}

fn driven(case: &Resolved) -> DriveReport {
    let options = SolveOptions { tolerance: 1e-5, ..SolveOptions::default() };
    let speed = Unit::RPM.to_si(4500.0);
    let (found, outcome) = equilibrium_outcome(None, case, speed, Direction::Up, &options).unwrap();
    DriveReport::new(case, &found, outcome, false).unwrap()
}

/// The engine takes what it takes: the wheels have to give the losses as well, and the vehicle slows down faster.
#[test]
fn losses_add_to_what_an_engine_brakes_with() {
    let torques = ["-3", "-1", "-0.3", "0", "0.3", "1", "3"];
    let mut before: Option<(f64, f64)> = None;
    for torque in torques {
        let [elastic, whole, geared] = [
            &[("losses.include", "off")][..],
            &[("losses.include", "on")],
            &[("losses.include", "on"), ("losses.gear_efficiency", "0.9")],
        ]
        .map(|settings| driven(&dragged(torque, settings)));
        let losses = whole.drive.losses.as_ref().unwrap();
        let hysteresis = losses.bending + losses.groove + losses.cord;
        let expected = elastic.power_out - hysteresis;
        println!("{torque}: {} W in, {} W out, {hysteresis} W of hysteresis", whole.power_in, whole.power_out);
        assert!((whole.power_out - expected).abs() < 1e-6 * expected.abs(), "{torque}: {}", whole.power_out);
        // Behind gears the same power is less, or, where it goes in, more.
        let gears = if expected < 0.0 { 1.0 / 0.9 } else { 0.9 };
        assert!((geared.power_out - gears * expected).abs() < 1e-6 * expected.abs(), "{torque}: {}", geared.power_out);
        let [first, second, third] = [&elastic, &whole, &geared].map(|report| report.acceleration.unwrap());
        assert!(first > second && second > third, "{torque}: {first} {second} {third}");
        // What becomes heat, and what comes out, follow the torque without a jump.
        let heat = whole.power_in - whole.power_out;
        assert!(heat > hysteresis, "{torque}: {heat}");
        if let Some((heat_before, out_before)) = before {
            assert!((heat - heat_before).abs() < 60.0 && whole.power_out > out_before, "{torque}: {heat}");
        }
        before = Some((heat, whole.power_out));
        let share = whole.efficiency;
        if torque.starts_with('-') {
            assert!((share.unwrap() - whole.power_in / whole.power_out).abs() < 1e-9, "{torque}: {share:?}");
        }
    }
}

/// Where losses leave less than nothing, gears do not give.
#[test]
fn gears_take_their_share_whichever_way_power_goes() {
    for torque in ["1", "0.2", "-0.2", "-1", "8"] {
        let case = Case::base()
            .with("operating_point.primary_torque", &format!("{torque} N*m"))
            .and_then(|case| case.with("operating_point.slack_tension", "300 N"))
            .and_then(|case| case.with("losses.gear_efficiency", "0.5"))
            .unwrap();
        let outcome = run(&case.resolve().unwrap(), &SolveOptions::default()).unwrap();
        let losses = outcome.result.losses.as_ref().unwrap();
        assert!(losses.gears > 0.0, "{torque}: {}", losses.gears);
        let through = if losses.power_out > 0.0 { 0.5 } else { 2.0 };
        let arriving = losses.power_out + losses.gears;
        assert!((losses.power_out - through * arriving).abs() < 1e-9 * arriving.abs(), "{torque}");
        let said = sheave::result::warnings(&outcome);
        let nothing = said.iter().any(|said| said.contains("nothing arrives"));
        let flows = outcome.result.efficiency.overall.is_some();
        assert_eq!(nothing, flows && losses.power_out < 0.0, "{torque}: {said:?}");
    }
}

fn braking(settings: &[(&str, &str)]) -> Case {
    let given = [
        ("operating_point.primary_torque", "-10 N*m"),
        ("operating_point.slack_tension", "400 N"),
        ("drive.primary_radius", "60 mm"),
        ("drive.secondary_radius", "78 mm"),
    ];
    let set = |case: Case, (key, value): &(&str, &str)| case.with(key, value).unwrap();
    given.iter().chain(settings).fold(Case::base(), set)
}

fn solved(case: &Case) -> DriveResult<Resolved> {
    let options = SolveOptions { tolerance: 1e-8, sensitivities: true, ..SolveOptions::default() };
    run(&case.resolve().unwrap(), &options).unwrap().result
}

const EFFICIENCIES: [(&str, Read); 4] = [
    ("efficiency.overall", |result| result.efficiency.overall.unwrap()),
    ("efficiency.torque", |result| result.efficiency.torque.unwrap()),
    ("efficiency.speed", |result| result.efficiency.speed.unwrap()),
    ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
];

/// Efficiencies are those of the pulley that is driven over the one that drives, and so are their derivatives.
#[test]
fn derivatives_of_efficiencies_are_those_of_what_is_told() {
    let case = braking(&[]);
    let result = solved(&case);
    for (key, value) in [("sheave.friction_coefficient", 0.45), ("belt.bending_stiffness", 0.2602)] {
        let case = case.clone().with(key, &format!("{value}")).unwrap();
        let at = if key == "belt.bending_stiffness" { result.clone() } else { solved(&case) };
        assert_derivatives((&case, &at), (key, value, 1e-3), solved, &EFFICIENCIES);
    }
    // Of gears through which less arrives than nothing.
    let case = braking(&[("operating_point.primary_torque", "-1 N*m"), ("losses.gear_efficiency", "0.8")]);
    let result = solved(&case);
    assert!(result.losses.as_ref().unwrap().power_out < 0.0);
    let gears: [(&str, Read); 2] = [
        ("losses.gears", |result| result.losses.as_ref().unwrap().gears),
        ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
    ];
    assert_derivatives((&case, &result), ("losses.gear_efficiency", 0.8, 1e-3), solved, &gears);
}

/// An efficiency that is prescribed is the one that is told, and so are derivatives by it.
#[test]
fn an_efficiency_that_is_prescribed_is_the_one_that_is_told() {
    let asked = |efficiency: f64| {
        let mut case = braking(&[]);
        case.swap(&format!("belt.bending_stiffness for efficiency.overall = {efficiency}")).unwrap();
        solved(&case)
    };
    let [less, result, more] = [0.9299, 0.93, 0.9301].map(asked);
    assert!((result.efficiency.overall.unwrap() - 0.93).abs() < 1e-7, "{:?}", result.efficiency);
    let force = |result: &DriveResult<Resolved>| result.primary.axial_force;
    let difference = (force(&more) - force(&less)) / 2e-4;
    let found = result.sensitivities.as_ref().unwrap()["primary.axial_force"]["efficiency.overall"];
    assert!((found / difference - 1.0).abs() < 5e-3, "{found} and {difference}");
    let mut case = braking(&[]);
    case.swap("belt.bending_stiffness for efficiency.overall = 1.09").unwrap();
    let error = run(&case.resolve().unwrap(), &SolveOptions::default()).unwrap_err().to_string();
    assert!(error.contains("`efficiency.overall` = 1.09 cannot be reached"), "{error}");
}

/// Past the end of the shift curve a hill drives the engine: through a drive that loses its share of that, too.
#[test]
fn downhill_a_drive_makes_no_energy() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml");
    let case = Case::read(&path).unwrap().with("vehicle.grade", "-0.2").unwrap();
    let case = case.with("vehicle.final_efficiency", "0.9").unwrap().resolve().unwrap();
    let solve = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    let options = ShiftOptions { points: 8, directions: vec![Direction::Up], solve, ..ShiftOptions::default() };
    let branch = shift_branch(&case, Direction::Up, &options, &mut |_| ControlFlow::Continue(())).unwrap();
    let curve = LaunchCurve::new(&branch).unwrap();
    let vehicle = case.parts.vehicle.unwrap();
    let found =
        launch(&curve, &vehicle, &LaunchOptions { distances: vec![400.0], ..LaunchOptions::default() }).unwrap();
    assert!(found.points.windows(2).all(|pair| pair[0].heat <= pair[1].heat), "heat becomes less");
    let held: Vec<_> = found.points.iter().filter(|point| point.power_out < 0.0).collect();
    assert!(held.len() > 3);
    for point in held {
        assert!(point.power_in < 0.0 && point.power_in > point.power_out, "{point:?}");
        assert!(point.acceleration.abs() < 1e-9, "{point:?}");
    }
    assert!(found.energy.belt_heat > 0.0 && found.energy.final_drive_heat > 0.0, "{:?}", found.energy);
    assert!(found.held_back().is_some_and(|said| said.contains("the engine would have to brake with up to")));
    let flat = case.parts.vehicle.map(|vehicle| sheave::powertrain::Vehicle { grade: 0.0, ..vehicle }).unwrap();
    assert_eq!(launch(&curve, &flat, &LaunchOptions::default()).unwrap().held_back(), None);
    assert!(found.energy.unaccounted.abs() < 1e-3 * found.energy.resistance.abs(), "{:?}", found.energy);
}
