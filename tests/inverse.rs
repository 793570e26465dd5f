//! Ramps and helices made for a speed: read again as parts, the drive holds it; what cannot be made is refused.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::f64::consts::PI;
use std::path::{Path, PathBuf};

use sheave::actuator::{AngleFrom, Mechanism, PrimaryActuator, Profile};
use sheave::case::{Case, Key};
use sheave::drive::SolveOptions;
use sheave::equilibrium::inverse::{
    Inverse, InverseError, InverseOptions, Made, Shape, dxf, inverse, inverse_summary, inverse_table, surface,
};
use sheave::equilibrium::{Direction, Phase, equilibrium};
use sheave::study::Cell;

const RPM: f64 = PI / 30.0;
const MM: f64 = 1e-3;

fn example(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(path)
}

fn gx9() -> Case {
    Case::read(&example("drive/gx9.toml")).unwrap()
}

/// The drive of the box of parts, with one of each kind.
fn tuksbaja() -> Case {
    let mut case = Case::read(&example("tune/tuksbaja.toml")).unwrap();
    for (key, value) in [
        ("engine.throttle", "0.5"),
        ("primary.actuator.mass", "72 g"),
        ("primary.actuator.coefficients", "39.467, 39.32, 38.353, 37.442, 37.967 mm"),
        ("primary.spring.free_length", "106 mm"),
        ("primary.spring.rate", "8.2 N/mm"),
        ("secondary.actuator.helix_angle", "32 deg"),
        ("secondary.spring.pretension", "66 deg"),
        ("secondary.spring.preload", "117 N"),
        ("secondary.spring.rate", "4.27 N/mm"),
        ("secondary.spring.torsion_rate", "4.55 N*m/rad"),
    ] {
        case.set(key, value).unwrap();
    }
    case
}

fn options(target: f64, made: Made) -> InverseOptions {
    let solve = SolveOptions { tolerance: 1e-5, ..SolveOptions::default() };
    InverseOptions { points: 17, checked: 2, solve, ..InverseOptions::new(target * RPM, made) }
}

fn made(case: &Case, options: &InverseOptions) -> Inverse {
    inverse(case, options).unwrap_or_else(|error| panic!("{error}"))
}

/// The drive with the parts as files of their own, as a team would have them, holds the target within 5 rpm.
fn holds(case: &Case, found: &Inverse) {
    let target = found.options.target;
    assert!(found.check.largest_deviation < 5.0 * RPM, "{:?}", found.check);
    let folder = tempfile::tempdir().unwrap();
    let mut text = case.to_toml();
    for (i, part) in found.parts.iter().enumerate() {
        // What the part says goes out of the case, and the part's name into it.
        let name = format!("part{i}.toml");
        std::fs::write(folder.path().join(&name), &part.text).unwrap();
        let heading = format!("[{}]\n", part.section);
        let (before, after) = text.split_once(&heading).unwrap();
        let rest = after.find("\n[").map_or("", |at| &after[at..]);
        text = format!("{before}{heading}file = \"{name}\"\n{rest}");
    }
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let again = Case::read(&path).unwrap().resolve().unwrap_or_else(|error| panic!("{error}"));
    let place = found.points.len() / 3;
    let (a, b) = (&found.points[place], &found.points[place + 1]);
    let speed = 0.5 * (a.secondary_speed + b.secondary_speed);
    let solved = equilibrium(&again, speed, Direction::Up, &SolveOptions::default()).unwrap();
    assert_eq!(solved.phase, Phase::Shift);
    let missed = (solved.primary_speed() - target) / RPM;
    assert!(missed.abs() < 5.0, "{missed} rpm");
}

#[test]
fn a_ramp_for_roller_arms_holds_the_target() {
    let case = gx9();
    let found = made(&case, &options(3150.0, Made::Ramp));
    let [part] = found.parts.as_slice() else { panic!("{}", found.parts.len()) };
    let Shape::Roller(path) = &part.shape else { panic!("{:?}", part.shape) };
    assert!((15..=18).contains(&path.places().len()) && part.section == "primary.actuator");
    // It begins where the case's ramp has the roller.
    let resolved = case.resolve().unwrap();
    let PrimaryActuator::Flyweights { flyweights, .. } = &resolved.parts.actuation.as_ref().unwrap().primary else {
        panic!("no flyweights")
    };
    let Mechanism::RollerArm(arm) = &flyweights.mechanism else { panic!("no arm") };
    assert!((path.values()[0] - arm.ramp.at(path.places()[0]).value).abs() < 1e-6);
    // In the table the roller stands on the ramp that was made where the arm has it at the row's travel.
    let made = found.case.resolve().unwrap();
    let PrimaryActuator::Flyweights { flyweights, .. } = &made.parts.actuation.as_ref().unwrap().primary else {
        panic!("no flyweights")
    };
    let Mechanism::RollerArm(arm) = &flyweights.mechanism else { panic!("no arm") };
    let rows = columns(&found, ["primary_travel", "ramp_radius"]);
    assert_eq!(rows.len(), part.travels.len());
    assert!(rows[0][0].abs() < 1e-12 && part.travels.len() > found.points.len(), "no place before the belt's");
    for [travel, radius] in &rows {
        let wanted = arm.radius(arm.angle(*travel).unwrap());
        assert!((radius - wanted).abs() < 1e-6, "at {travel}: {radius} for {wanted}");
    }
    // Low ratio is the first point of the belt, not the open primary.
    let [_, radius] = rows[rows.len() - found.points.len()];
    let said = format!("{:.2} mm at low ratio", 1e3 * radius);
    let summary = inverse_summary(&found, AngleFrom::Rotation);
    assert!(summary.contains(&said), "{said}: {summary}");
    holds(&case, &found);
}

/// The numbers of two columns of the table, in all its rows.
fn columns(found: &Inverse, names: [&str; 2]) -> Vec<[f64; 2]> {
    let table = inverse_table(found);
    let at = names.map(|name| table.columns.iter().position(|column| column == name).unwrap());
    let number = |cell: &Cell| match cell {
        Cell::Number(number) => number.as_f64().unwrap(),
        other => panic!("{other:?}"),
    };
    table.rows.iter().map(|row| at.map(|at| number(&row[at]))).collect()
}

#[test]
fn coefficients_hold_the_target() {
    let case = tuksbaja();
    let found = made(&case, &options(3300.0, Made::Ramp));
    // Three of 72 g: what the belt takes and the spring gives is N m ω² r dr/ds.
    let Shape::Coefficient(profile) = &found.parts[0].shape else { panic!("{:?}", found.parts[0].shape) };
    // Before the points of the belt there may be one where the primary is open.
    let extra = profile.values().len() - found.points.len();
    for (point, coefficient) in found.points.iter().zip(&profile.values()[extra..]) {
        let spring = 8.2e3 * (0.106 - 0.059 + point.primary_travel);
        let force = 3.0 * 0.072 * (3300.0 * RPM).powi(2) * coefficient;
        assert!((force - spring - point.primary_axial_force).abs() < 1e-6 * force, "{point:?} {force} {spring}");
    }
    holds(&case, &found);
}

/// A weight that slides along a radius, with friction.
#[test]
fn a_ramp_for_sliding_weights_holds_the_target() {
    let mut case = tuksbaja();
    for key in ["primary.actuator.coefficients", "primary.actuator.travels"] {
        case.unset(key).unwrap();
    }
    case.set("primary.actuator.type", "ramp").unwrap();
    case.set("primary.actuator.travels", "0, 10, 20, 26 mm").unwrap();
    case.set("primary.actuator.radii", "40, 50, 58, 62 mm").unwrap();
    case.set("primary.actuator.friction_angle", "2 deg").unwrap();
    let found = made(&case, &options(3300.0, Made::Ramp));
    let Shape::Ramp(profile) = &found.parts[0].shape else { panic!("{:?}", found.parts[0].shape) };
    assert!(profile.values().windows(2).all(|pair| pair[1] > pair[0]), "{profile:?}");
    holds(&case, &found);
}

/// The example with flyweights on cams, their rollers on a pitch curve of these distances in m and angles in rad.
fn with_cam(roller_start: &str, distances: &[f64], angles: &[f64]) -> Case {
    let mut case = gx9();
    for key in case.keys().filter(|key| key.entry().section() == "primary.actuator").collect::<Vec<_>>() {
        case.unset(key.path()).unwrap();
    }
    for (key, value) in [
        ("type", "cam"),
        ("count", "4"),
        ("mass", "134 g"),
        ("pivot_radius", "40 mm"),
        ("roller_radius", "52 mm"),
        ("roller_start", roller_start),
        ("mass_distance", "28 mm"),
        ("mass_angle", "-17 deg"),
    ] {
        case.set(&format!("primary.actuator.{key}"), value).unwrap();
    }
    case.set_list(Key::PitchDistances, distances).unwrap();
    case.set_list(Key::PitchAngles, angles).unwrap();
    case
}

#[test]
fn a_cam_holds_the_target() {
    let distances: Vec<f64> = (0..=11).map(|i| (24.0 + 2.0 * f64::from(i)) * MM).collect();
    let angles: Vec<f64> = distances.iter().map(|d| 0.6 - 45.0 * (d - 0.024) - 300.0 * (d - 0.024).powi(2)).collect();
    let case = with_cam("25 mm", &distances, &angles);
    let found = made(&case, &options(3150.0, Made::Ramp));
    assert!(matches!(&found.parts[0].shape, Shape::Cam(profile) if profile.values().len() >= 15));
    holds(&case, &found);
}

/// The roller comes nearer to the pivot as the primary closes: the profile's places fall as the travel grows.
#[test]
fn a_cam_to_which_the_roller_comes_nearer_is_told_along_the_shift() {
    let distances: Vec<f64> = (11..=25).map(|i| 2.0 * f64::from(i) * MM).collect();
    let angles: Vec<f64> = distances.iter().map(|distance| 0.72 - 20.0 * distance).collect();
    let case = with_cam("-46 mm", &distances, &angles);
    let found = made(&case, &options(3200.0, Made::Ramp));
    let rows = columns(&found, ["primary_travel", "pitch_distance"]);
    for [travel, distance] in &rows {
        let wanted = (12.0 * MM).hypot(travel - 46.0 * MM);
        assert!((distance - wanted).abs() < 1e-9, "at {travel}: {distance} for {wanted}");
    }
    let angles = columns(&found, ["primary_travel", "pitch_angle"]);
    let [low, high] = [rows.len() - found.points.len(), rows.len() - 1].map(|row| angles[row][1].to_degrees());
    let said = format!("{low:.2} ° at low ratio to {high:.2} ° at high ratio");
    let summary = inverse_summary(&found, AngleFrom::Rotation);
    assert!(summary.contains(&said), "{said}: {summary}");
}

#[test]
fn a_helix_holds_the_target() {
    // The case's own flyweights press too little at 3400 rpm to hold the torque at high ratio.
    let mut case = gx9();
    case.set("primary.actuator.mass", "175 g").unwrap();
    // As many points as the trapezoidal rule below needs.
    let found = made(&case, &InverseOptions { points: 25, ..options(3400.0, Made::Helix) });
    let Shape::Helix(angles, turns) = &found.parts[0].shape else { panic!("{:?}", found.parts[0].shape) };
    // The turn is the integral of ds/(r_h tan α), here by the trapezoidal rule.
    let slope = |at: usize| 1.0 / (46.04e-3 * angles.values()[at].tan());
    let pieces =
        (1..turns.len()).map(|at| 0.5 * (slope(at) + slope(at - 1)) * (angles.places()[at] - angles.places()[at - 1]));
    let sum: f64 = pieces.sum();
    assert!((sum / turns.last().unwrap() - 1.0).abs() < 1e-3, "{sum} {turns:?}");
    holds(&case, &found);
}

#[test]
fn both_profiles_leave_the_reserve_that_is_asked_for() {
    let case = gx9();
    let asked = InverseOptions { reserve: 0.4, ..options(3100.0, Made::Both) };
    let found = made(&case, &asked);
    assert_eq!(found.parts.len(), 2);
    for point in &found.points {
        assert!((point.slip_reserve - 0.4).abs() < 1e-5, "{point:?}");
    }
    for point in &found.check.points {
        assert!((point.slip_reserve - 0.4).abs() < 5e-3, "{point:?}");
    }
    holds(&case, &found);
}

/// The ramp of the example is stated as a polynomial; its path of the roller's centre was computed elsewhere.
#[test]
fn the_surface_of_a_ramp_is_a_rollers_radius_from_the_path_of_its_centre() {
    let resolved = gx9().resolve().unwrap();
    let PrimaryActuator::Flyweights { flyweights, .. } = &resolved.parts.actuation.as_ref().unwrap().primary else {
        panic!("no flyweights")
    };
    let Mechanism::RollerArm(arm) = &flyweights.mechanism else { panic!("no arm") };
    let outline = surface(&arm.ramp, 6.35 * MM).unwrap();
    assert!(outline.points.len() > 100);
    // But for the ends of the table, where its slope is known less well.
    for (place, radius) in &outline.points[4..outline.points.len() - 4] {
        let x = place / MM;
        let stated = 65.23 - (20.25 - 0.805 * x + 0.01 * x * x);
        assert!((radius / MM - stated).abs() < 0.01, "at {x} mm: {} mm, stated {stated} mm", radius / MM);
    }
    // A hollow tighter than the roller.
    let hollow: Vec<f64> = (0..41).map(|i| f64::from(i) * 0.25 * MM).collect();
    let radii = hollow.iter().map(|x| 40.0 * MM + 20.0 * (x - 5.0 * MM).powi(2) / MM).collect();
    let hollow = Profile::new(hollow, radii).unwrap();
    assert!(surface(&hollow, 6.35 * MM).is_err() && surface(&hollow, 1e-6).is_ok());
}

#[test]
fn a_drawing_is_one_polyline_a_curve_in_millimetres() {
    let path = Profile::new(vec![0.0, 0.01], vec![0.04, 0.05]).unwrap();
    let text = dxf(&[surface(&path, 1e-9).unwrap()]);
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    assert_eq!(lines.len() % 2, 0, "group codes and values come in pairs");
    let pairs: Vec<(i32, &str)> = lines.chunks(2).map(|pair| (pair[0].parse().unwrap(), pair[1])).collect();
    let count = |wanted: (i32, &str)| pairs.iter().filter(|pair| **pair == wanted).count();
    assert_eq!((count((0, "POLYLINE")), count((0, "VERTEX")), count((0, "SEQEND"))), (1, 5, 1));
    assert_eq!(pairs.last(), Some(&(0, "EOF")));
    let x: Vec<f64> = pairs.iter().filter(|pair| pair.0 == 10).map(|pair| pair.1.parse().unwrap()).collect();
    assert!((x.last().unwrap() - 10.0).abs() < 1e-5, "{x:?}");
}

#[test]
fn what_cannot_be_made_is_refused_with_the_reason() {
    let refused = |case: &Case, options: &InverseOptions| inverse(case, options).map(|_| ()).unwrap_err();
    let with = |key: &str, value: &str| {
        let mut case = gx9();
        case.set(key, value).unwrap();
        case
    };
    let quick = |made: Made| InverseOptions { points: 7, checked: 1, ..options(3400.0, made) };
    // The spring presses with more than the belt takes: the helix would have to pull.
    let mut stiff = with("secondary.spring.preload", "2000 N");
    stiff.set("primary.actuator.mass", "175 g").unwrap();
    let error = refused(&stiff, &quick(Made::Helix));
    assert!(matches!(error, InverseError::WrongSign { part: "helix", .. }), "{error}");
    assert!(error.to_string().contains("would have to pull"), "{error}");
    // Flyweights that are too light for any ramp.
    let error = refused(&with("primary.actuator.mass", "20 g"), &quick(Made::Ramp));
    let light = matches!(error, InverseError::Slope { .. } | InverseError::Folds { .. });
    assert!(light && error.to_string().contains("heavier"), "{error}");
    // More reserve than the helix gives.
    let error = refused(&gx9(), &InverseOptions { reserve: 0.6, ..quick(Made::Ramp) });
    assert!(matches!(error, InverseError::Reserve { .. }), "{error}");
    // A spring that is solid before full shift.
    let mut solid = gx9();
    solid.set("primary.spring.installed_length", "50 mm").unwrap();
    solid.set("primary.spring.solid_length", "40 mm").unwrap();
    assert!(refused(&solid, &quick(Made::Ramp)).to_string().contains("solid length"));
    // A target that the engine does not have, a servo, a stop that is missing.
    let error = refused(&gx9(), &options(6000.0, Made::Ramp));
    assert!(error.is_bad_input() && error.to_string().contains("1800 rpm to 4000 rpm"), "{error}");
    let mut servo = gx9();
    for key in servo.keys().collect::<Vec<_>>() {
        let section = key.entry().section();
        if section == "primary.actuator" || section == "primary.spring" {
            servo.unset(key.path()).unwrap();
        }
    }
    servo.set("primary.actuator.type", "servo").unwrap();
    servo.set_si(Key::PrimaryServoForce, 800.0).unwrap();
    let error = refused(&servo, &quick(Made::Ramp));
    assert!(matches!(error, InverseError::Missing { what: "flyweights", .. }), "{error}");
    let mut endless = gx9();
    endless.unset("primary.travel").unwrap();
    let error = refused(&endless, &quick(Made::Ramp));
    assert!(matches!(error, InverseError::Missing { what: "stop at high ratio", .. }), "{error}");
}

/// The equations have states with the belt on a radius of the secondary that has nothing to do with its length.
#[test]
fn no_profile_is_made_from_a_belt_far_deeper_than_its_length_leaves_it() {
    let error = inverse(&gx9(), &options(3500.0, Made::Helix)).map(|_| ()).unwrap_err();
    let InverseError::Deep { ratio, left, .. } = error else { panic!("{error}") };
    assert!(ratio < 0.7 * left && left > 0.55, "{ratio} {left}");
    assert!(!error.is_bad_input() && error.to_string().contains("deeper in the secondary"), "{error}");
}

/// A profile over travels at which no primary stands, and one with which the engine leaves the target, are told.
#[test]
fn what_a_profile_is_not_good_for_is_said() {
    let found = made(&gx9(), &InverseOptions { points: 7, checked: 1, ..options(3950.0, Made::Ramp) });
    let told = found.remarks();
    assert!(found.points[0].primary_travel < -MM && told[0].contains("3.11 mm farther open"), "{told:?}");
    let coarse = made(&gx9(), &InverseOptions { points: 5, checked: 9, ..options(3000.0, Made::Ramp) });
    let told = coarse.remarks();
    let missed = format!("leaves the target by up to {:.0} rpm", coarse.check.largest_deviation / RPM);
    assert!(coarse.check.largest_deviation > 30.0 * RPM && told[0].contains(&missed), "{told:?}");
}

/// Nobody makes a helix of a belt that buckles, or that slips, without being told.
#[test]
fn what_the_belt_does_on_the_way_is_said() {
    let mut found = made(&gx9(), &InverseOptions { points: 7, checked: 1, ..options(3800.0, Made::Helix) });
    assert!(found.remarks().is_empty() && found.points.iter().all(|point| !point.buckled), "{:?}", found.remarks());
    found.points[2].buckled = true;
    found.points[4].slip_reserve = 0.02;
    let told = found.remarks();
    let at = |place: usize| format!("{:.2}", found.points[place].ratio);
    assert!(told.len() == 2 && told[0].contains("buckles") && told[0].contains(&at(2)), "{told:?}");
    assert!(told[1].contains("slips") && told[1].contains(&at(4)), "{told:?}");
}

/// What is asked for and cannot be is said before the profile is made, and leaves no folder behind.
#[test]
fn bad_arguments_leave_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("case.toml");
    std::fs::write(&file, tuksbaja().to_toml()).unwrap();
    let out = folder.path().join("out");
    let ramp = |extra: &[&str]| {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"));
        let output = command.arg("ramp").arg(&file).args(extra).arg("--out").arg(&out).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(!out.exists(), "{extra:?}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let said = ramp(&["--target", "30 rpm"]);
    assert!(said.contains("the target is 30 rpm"), "{said}");
    // No engine turns so slowly: the roller is looked at before.
    let said = ramp(&["--target", "30 rpm", "--roller-radius", "6 mm"]);
    assert!(said.contains("--roller-radius is for primary.actuator.type = \"arm\""), "{said}");
    std::fs::write(&out, "mine").unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_sheave"));
    let output = command.args(["ramp", "--target", "3000 rpm"]).arg(&file).arg("--out").arg(&out).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("expected the name of a folder"), "{output:?}");
}
