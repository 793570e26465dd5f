//! Launches against closed forms, and of a whole drive.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::equilibrium::{Direction, ShiftBranch, ShiftOptions, shift_branch};
use sheave::launch::{LaunchCurve, LaunchError, LaunchOptions, LaunchPhase, launch};
use sheave::powertrain::Vehicle;

const RPM: f64 = std::f64::consts::PI / 30.0;

fn vehicle() -> Vehicle {
    Vehicle {
        mass: 250.0,
        final_ratio: 8.0,
        wheel_radius: 0.28,
        rolling_resistance: 0.0,
        drag_area: 0.0,
        grade: 0.0,
        air_density: 1.2,
        final_efficiency: 0.9,
    }
}

/// A drive that delivers one torque at every speed: v = a t, s = a t²/2.
#[test]
fn a_constant_torque_makes_a_constant_acceleration() {
    let speeds = [50.0, 100.0, 400.0, 1000.0];
    let torque = 40.0;
    let out = speeds.map(|speed| torque * speed);
    let power = out.map(|power| power / 0.8);
    let curve = LaunchCurve::from_values(&speeds, [&[300.0; 4], &[2.0; 4], &power, &out]).unwrap();
    let options = LaunchOptions { distances: vec![30.48, 45.72], share_of_top: 0.5 };
    let found = launch(&curve, &vehicle(), &options).unwrap();
    let acceleration = 0.9 * torque * 8.0 / 0.28 / 250.0;
    for (mark, distance) in found.marks.iter().zip([30.48f64, 45.72]) {
        let time = (2.0 * distance / acceleration).sqrt();
        assert!((mark.time - time).abs() < 1e-6 && (mark.distance - distance).abs() < 1e-9, "{mark:?} {time}");
        assert!((mark.speed - acceleration * time).abs() < 1e-5, "{mark:?}");
    }
    let take_off = 50.0 * 0.28 / 8.0;
    assert!((found.lock_up.time - take_off / acceleration).abs() < 1e-6, "{:?}", found.lock_up);
    // While the clutch slips the engine gives what it gives at take-off, and all torque arrives.
    let expected = (power[0] - 0.5 * out[0]) * found.lock_up.time;
    assert!((found.energy.clutch_heat / expected - 1.0).abs() < 1e-5, "{:?} {expected}", found.energy);
    assert!(found.energy.unaccounted.abs() < 1e-6 * found.energy.engine, "{:?}", found.energy);
    assert!(found.limited_by_curve && found.points[0].phase == LaunchPhase::Clutch);
}

/// Constant power P against drag k v²: the top speed is where P = k v³, and m v dv/dt = P − k v³, so that u = v³ has
/// du/dt = 3 v (P − k u)/m, no closed form in time; over the distance s, however, du/ds = 3 (P − k u)/m.
#[test]
fn power_against_drag_ends_at_the_top_speed() {
    let speeds: Vec<f64> = (1..=400).map(f64::from).collect();
    let out = vec![5000.0; 400];
    let power = vec![6000.0; 400];
    let (engine, ratio) = (vec![300.0; 400], vec![1.0; 400]);
    let curve = LaunchCurve::from_values(&speeds, [&engine, &ratio, &power, &out]).unwrap();
    let drag = Vehicle { drag_area: 0.6, ..vehicle() };
    let options = LaunchOptions { distances: vec![20.0], share_of_top: 0.9 };
    let found = launch(&curve, &drag, &options).unwrap();
    let resistance = 0.5 * 1.2 * 0.6;
    let top = (0.9 * 5000.0f64 / resistance).cbrt();
    // Within the curve of 400 rad/s, 14 m/s, if it is slower; else the curve ends it.
    let end = 400.0 * 0.28 / 8.0;
    assert_eq!(found.limited_by_curve, top > end);
    assert!((found.top_speed - top.min(end)).abs() < 1e-6, "{} {top} {end}", found.top_speed);
    let left = |mark: &sheave::launch::Mark| 1.0 - (mark.speed / top).powi(3);
    let wanted = (left(&found.marks[0]) / left(&found.done)).ln() * 250.0 / (3.0 * resistance);
    let passed = found.done.distance - found.marks[0].distance;
    assert!((passed / wanted - 1.0).abs() < 1e-4, "{passed} m, {wanted} m");
    assert!(found.energy.unaccounted.abs() < 1e-6 * found.energy.engine, "{:?}", found.energy);
}

/// When something happens on the way does not depend on how far the launch is followed.
#[test]
fn a_long_distance_changes_nothing_before_it() {
    let speeds = [50.0, 100.0, 200.0, 400.0];
    let out = speeds.map(|speed| 40.0 * speed / (1.0 + speed / 200.0));
    let power = out.map(|power| power / 0.8);
    let curve = LaunchCurve::from_values(&speeds, [&[300.0; 4], &[2.0; 4], &power, &out]).unwrap();
    let drag = Vehicle { drag_area: 0.6, ..vehicle() };
    let over = |distances: Vec<f64>| launch(&curve, &drag, &LaunchOptions { distances, share_of_top: 0.9 }).unwrap();
    let (short, long) = (over(vec![10.0]), over(vec![10.0, 8000.0]));
    for (a, b) in [(short.lock_up, long.lock_up), (short.marks[0], long.marks[0]), (short.done, long.done)] {
        assert!((a.time - b.time).abs() < 1e-4 && (a.distance - b.distance).abs() < 1e-3, "{a:?} {b:?}");
    }
}

#[test]
fn what_does_not_start_or_is_wrong_is_said() {
    let speeds = [50.0, 100.0, 200.0, 400.0];
    let out = speeds.map(|speed| 20.0 * speed);
    let curve = LaunchCurve::from_values(&speeds, [&[300.0; 4], &[2.0; 4], &out, &out]).unwrap();
    let steep = Vehicle { grade: 1.0, ..vehicle() };
    let error = launch(&curve, &steep, &LaunchOptions::default()).unwrap_err();
    assert!(matches!(error, LaunchError::Stalls { .. }), "{error}");
    for options in [
        LaunchOptions { distances: vec![-1.0], ..LaunchOptions::default() },
        LaunchOptions { share_of_top: 1.0, ..LaunchOptions::default() },
    ] {
        let error = launch(&curve, &vehicle(), &options).unwrap_err();
        assert!(matches!(error, LaunchError::Parameter { .. }), "{error}");
    }
}

/// A drive that takes off at 50 rad/s and delivers a constant torque.
fn steady() -> LaunchCurve {
    let speeds = [50.0, 100.0, 200.0, 400.0];
    let out = speeds.map(|speed| 20.0 * speed);
    LaunchCurve::from_values(&speeds, [&[300.0; 4], &[2.0; 4], &out.map(|out| out / 0.8), &out]).unwrap()
}

/// The clutch slips for good only where the top speed itself lies below take-off, whatever share of it counts.
#[test]
fn a_share_below_take_off_is_reached_while_the_clutch_slips() {
    let options = LaunchOptions { distances: vec![1.0], share_of_top: 0.05 };
    let found = launch(&steady(), &vehicle(), &options).unwrap();
    let acceleration = 0.9 * 20.0 * 8.0 / 0.28 / 250.0;
    let (take_off, goal) = (50.0 * 0.28 / 8.0, 0.05 * 400.0 * 0.28 / 8.0);
    assert!(goal < take_off);
    assert!((found.done.time - goal / acceleration).abs() < 1e-6, "{:?}", found.done);
    assert!((found.lock_up.time - take_off / acceleration).abs() < 1e-6, "{:?}", found.lock_up);
    // Drag that the torque meets just above take-off, and just below.
    let force = 0.9 * 20.0 * 8.0 / 0.28;
    for (share, locks) in [(1.005, true), (0.995, false)] {
        let drag = Vehicle { drag_area: force / (0.5 * 1.2 * (share * take_off).powi(2)), ..vehicle() };
        let found = launch(&steady(), &drag, &LaunchOptions { distances: vec![1.0], ..LaunchOptions::default() });
        match found {
            Ok(found) => assert!(locks && (found.top_speed / take_off - share).abs() < 1e-6, "{found:?}"),
            Err(error) => assert!(!locks && matches!(error, LaunchError::NeverLocks { .. }), "{share}: {error}"),
        }
    }
}

/// Twenty kilometres take longer than ten minutes; what would take for ever says how far it comes.
#[test]
fn a_long_distance_is_covered_and_energies_are_told_with_their_end() {
    let over = |distance: f64| LaunchOptions { distances: vec![distance], ..LaunchOptions::default() };
    let slow = Vehicle { rolling_resistance: 0.05, ..vehicle() };
    let found = launch(&steady(), &slow, &over(20e3)).unwrap();
    assert!(found.marks[0].time > 1000.0 && found.end.time == found.marks[0].time, "{:?}", found.end);
    assert!((found.end.distance - 20e3).abs() < 1e-3 && found.done.time < 60.0, "{:?} {:?}", found.end, found.done);
    let kinetic = 0.5 * slow.mass * found.end.speed.powi(2);
    assert!((found.energy.kinetic / kinetic - 1.0).abs() < 1e-9, "{:?}", found.energy);
    let error = launch(&steady(), &slow, &over(1e9)).unwrap_err();
    let LaunchError::Endless { time, reached, wanted } = error else { panic!("{error}") };
    assert_eq!(wanted.1, 1e9);
    assert!(reached.1 > 0.9 * time * found.top_speed && reached.1 < wanted.1, "{reached:?}");
}

/// The whole drive of the example: the audit closes, and the acceleration is that of the shift curve's points.
#[test]
fn a_whole_drive_launches() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml");
    let case = Case::read(&path).unwrap().resolve().unwrap();
    let solve = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
    let options = ShiftOptions { points: 12, solve, ..ShiftOptions::default() };
    let branch = shift_branch(&case, Direction::Up, &options, &mut |_| std::ops::ControlFlow::Continue(())).unwrap();
    let curve = LaunchCurve::new(&branch).unwrap();
    let vehicle = case.parts.vehicle.unwrap();
    let found = launch(&curve, &vehicle, &LaunchOptions::default()).unwrap();
    assert!(found.energy.unaccounted.abs() < 1e-5 * found.energy.engine, "{:?}", found.energy);
    let [hundred, hundred_fifty] = found.marks.as_slice() else { panic!("{:?}", found.marks) };
    assert!(hundred.time < hundred_fifty.time && hundred.time > 2.0 && hundred_fifty.time < 8.0, "{found:?}");
    for point in branch.points.iter().filter_map(|point| point.report.as_ref().ok()) {
        let at = curve.at(point.secondary_speed);
        assert!((at.engine_speed / point.primary_speed - 1.0).abs() < 1e-9, "{at:?}");
        let acceleration = vehicle.acceleration(point.secondary_speed, at.torque);
        assert!((acceleration - point.acceleration.unwrap()).abs() < 1e-9, "{acceleration}");
    }
    let clutch = found.points.iter().filter(|point| point.phase == LaunchPhase::Clutch);
    let engine = branch.take_off.unwrap().primary_speed;
    for point in clutch {
        assert!((point.engine_speed - engine).abs() < 1e-6 * engine, "{} {engine}", point.engine_speed / RPM);
    }
    // Where no take-off was found, the clutch slips until the first state of the curve, and that is said; where the
    // engine cannot run so slowly, nothing is told.
    let engine = case.parts.engine.as_ref().unwrap();
    assert_eq!(curve.beginning(&branch, engine).unwrap(), None);
    let without = ShiftBranch { take_off: None, ..branch.clone() };
    let said = curve.beginning(&without, engine).unwrap().unwrap();
    assert!(said.contains("No take-off was found"), "{said}");
    let speeds = [5.0, 100.0, 200.0, 400.0];
    let stalling = LaunchCurve::from_values(&speeds, [&[27.0, 300.0, 300.0, 300.0], &[2.0; 4], &[1e3; 4], &[9e2; 4]]);
    let error = stalling.unwrap().beginning(&without, engine).unwrap_err();
    assert!(matches!(error, LaunchError::NoTakeOff { .. }), "{error}");
}
