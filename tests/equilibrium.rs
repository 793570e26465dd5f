//! Equilibria of whole drives: belt, actuators and engine as one problem, against the laws called by hand, against each
//! other, and their derivatives against differences.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::path::Path;

use sheave::case::{Case, Key, Resolved};
use sheave::drive::{Constant, Output, SolveOptions, Trouble, solve};
use sheave::equilibrium::{
    Direction, Equilibrium, EquilibriumError, Phase, ReportedPhase, ShiftOptions, Stop, equilibrium, equilibrium_from,
    equilibrium_outcome, over_curve, sensitivities, shift_branch, shift_table,
};
use sheave::result::{Doubt, run};

const RPM: f64 = PI / 30.0;
const UP: Direction = Direction::Up;

fn gx9() -> Case {
    Case::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml")).unwrap()
}

fn resolved(case: &Case) -> Resolved {
    case.resolve().unwrap_or_else(|error| panic!("{error}"))
}

fn options() -> SolveOptions {
    SolveOptions::default()
}

fn first() -> (Resolved, Equilibrium) {
    let case = resolved(&gx9());
    let found = equilibrium(&case, 2500.0 * RPM, UP, &options()).unwrap_or_else(|error| panic!("{error}"));
    (case, found)
}

/// Every law holds at the solution, by the parts' own functions; and an ordinary solve of the operating point that was
/// found gives the same forces.
#[test]
fn the_equilibrium_is_one_of_every_part() {
    let (case, found) = first();
    assert_eq!(found.phase, Phase::Shift);
    assert!(found.forces.residual < 1e-9, "{:?}", found.forces);
    let parts = case.parts.actuation.as_ref().unwrap();
    let (engine, speed) = (case.parts.engine.as_ref().unwrap(), found.primary_speed());
    let torque = found.solved.constant(Constant::PrimaryTorque);
    assert!((torque / engine.torque(speed).value - 1.0).abs() < 1e-9);
    assert!((found.output(Output::SecondarySpeed).unwrap() / (2500.0 * RPM) - 1.0).abs() < 1e-9);
    assert!((found.output(Output::BeltUnstretchedLength).unwrap() / case.belt.length - 1.0).abs() < 1e-9);
    let slope = 2.0 * case.sheave.half_angle.tan();
    let travel = slope * (found.solved.constant(Constant::PrimaryRadius) - parts.start_radius);
    let press = parts.primary.force(speed, travel, UP.primary()).unwrap().unwrap().value;
    let opening = slope * (parts.closed_radius - found.solved.constant(Constant::SecondaryRadius));
    let torque = found.output(Output::SecondaryTorque).unwrap();
    let squeeze = parts.secondary.force(torque, opening, UP.secondary()).unwrap().value;
    // By another way: all that was found is given, and an ordinary problem is solved from nothing.
    let again = solve(&found.operating_case(&case), &options()).unwrap();
    let outputs = again.belt.output_values(&again.solution).unwrap();
    for (output, value) in [(Output::PrimaryAxialForce, press), (Output::SecondaryAxialForce, squeeze)] {
        let belt = outputs.get(output).unwrap();
        assert!((belt / value - 1.0).abs() < 1e-4, "{output:?}: belt {belt} N, actuator {value} N");
    }
}

/// Exact sensitivities against equilibria with the part a little larger and smaller.
#[test]
fn sensitivities_are_those_of_differences() {
    sensitivities_are_differences(&gx9(), &options());
}

/// Where the belt is as warm as its losses make it, its temperature follows what each part changes: without that, the
/// derivative by the flyweights' mass would be 0.8 % off here.
#[test]
fn the_temperature_follows_the_parts() {
    sensitivities_are_differences(&warm("off"), &SolveOptions { tolerance: 1e-7, ..options() });
}

fn sensitivities_are_differences(base: &Case, options: &SolveOptions) {
    let (case, speed) = (resolved(base), 2500.0 * RPM);
    let (found, outcome) = equilibrium_outcome(None, &case, speed, UP, options).unwrap();
    let exact = sensitivities(&case, &found, &outcome.result).unwrap();
    for (key, value, share) in [
        (Key::FlyweightMass, 0.134, 5e-3),
        (Key::PrimarySpringPreload, 300.254_96, 5e-3),
        (Key::HelixAngle, 38f64.to_radians(), 5e-3),
        (Key::Pretension, 60f64.to_radians(), 5e-3),
        (Key::Throttle, 1.0, -5e-3),
    ] {
        let part = exact.iter().find(|part| part.key == key).unwrap_or_else(|| panic!("{key:?}"));
        let at = |value: f64| {
            let mut changed = base.clone();
            changed.set_si(key, value).unwrap();
            equilibrium_outcome(Some(&found), &resolved(&changed), speed, UP, options).unwrap().0
        };
        let step = share * value;
        // A throttle beyond 1 is none: one-sided, of second order.
        let (one, two) = (at(value + step), at(if share > 0.0 { value - step } else { value + 2.0 * step }));
        let difference = |of: &dyn Fn(&Equilibrium) -> f64| {
            if share > 0.0 {
                (of(&one) - of(&two)) / (2.0 * step)
            } else {
                (4.0 * of(&one) - of(&two) - 3.0 * of(&found)) / (2.0 * step)
            }
        };
        let (by_speed, by_ratio) = (difference(&Equilibrium::primary_speed), difference(&ratio));
        assert!((part.primary_speed / by_speed - 1.0).abs() < 1e-3, "{key:?}: {part:?}, difference {by_speed}");
        assert!((part.ratio / by_ratio - 1.0).abs() < 1e-3, "{key:?}: {part:?}, difference {by_ratio}");
    }
}

/// The drive with a belt that its losses heat, and whose loss tangent grows with its temperature.
fn warm(losses: &str) -> Case {
    let mut case = gx9();
    let tangent = "{ temperature = ['60 degC', '110 degC'], value = [0.12, 0.2] }";
    for (key, value) in [
        ("losses.include", losses),
        ("belt.loss_tangent", tangent),
        ("thermal.ambient", "25 degC"),
        ("thermal.heat_transfer", "14 W/K"),
        ("thermal.bending_softening", "0.012"),
        ("thermal.radial_softening", "0.012"),
    ] {
        case.set(key, value).unwrap();
    }
    case
}

/// The belt of a whole drive is as warm as that of an ordinary solve of the operating point that was found, its loss
/// tangent being read at that temperature, and as warm whether its losses are told or not.
#[test]
fn the_belt_is_as_warm_as_its_losses_make_it() {
    let case = resolved(&warm("on"));
    let (found, outcome) = equilibrium_outcome(None, &case, 2500.0 * RPM, UP, &options()).unwrap();
    let (kelvin, told) = (outcome.result.belt.temperature.unwrap(), outcome.result.losses.unwrap());
    let again = run(&found.operating_case(&case), &options()).unwrap().result;
    assert!((kelvin - again.belt.temperature.unwrap()).abs() < 0.02, "{kelvin} {:?}", again.belt.temperature);
    assert!((told.bending / again.losses.unwrap().bending - 1.0).abs() < 1e-3);
    assert!(kelvin > case.stiffnesses.reference + 10.0, "{kelvin}: nothing of the tables would be seen");
    let untold = resolved(&warm("off"));
    let (same, outcome) = equilibrium_outcome(None, &untold, 2500.0 * RPM, UP, &options()).unwrap();
    assert!(outcome.result.losses.is_none());
    assert_eq!((outcome.result.belt.temperature, same.primary_speed()), (Some(kelvin), found.primary_speed()));
}

/// A warm start finds what a start from nothing finds.
#[test]
fn the_way_does_not_matter() {
    let (case, found) = first();
    let warm = equilibrium_from(&found, &case, 2800.0 * RPM, UP, &options()).unwrap();
    let cold = equilibrium(&case, 2800.0 * RPM, UP, &options()).unwrap();
    assert!(
        (warm.primary_speed() / cold.primary_speed() - 1.0).abs() < 1e-4,
        "{} {}",
        warm.primary_speed(),
        cold.primary_speed()
    );
}

/// Friction in the actuators makes a band: shifting back takes a lower speed of the engine than shifting up.
#[test]
fn shifting_back_takes_a_lower_speed() {
    let mut case = gx9();
    case.set("primary.actuator.friction_angle", "2 deg").unwrap();
    case.set("secondary.actuator.friction_angle", "2 deg").unwrap();
    let case = resolved(&case);
    let up = equilibrium(&case, 2500.0 * RPM, UP, &options()).unwrap();
    let back = equilibrium_from(&up, &case, 2500.0 * RPM, Direction::Back, &options()).unwrap();
    let band = (up.primary_speed() - back.primary_speed()) / RPM;
    assert!(band > 20.0 && band < 1000.0, "{band} rpm");
}

/// At low speed the secondary rests closed on its stop; faster, the drive shifts.
#[test]
fn at_low_speed_the_secondary_rests_on_its_stop() {
    let case = resolved(&gx9());
    let found = equilibrium(&case, 1100.0 * RPM, UP, &options()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.phase, Phase::Low);
    assert!(found.secondary_travel.abs() < 1e-12 && found.forces.stop.is_some_and(|force| force > 0.0));
    let faster = equilibrium_from(&found, &case, 1700.0 * RPM, UP, &options()).unwrap();
    assert_eq!(faster.phase, Phase::Shift, "{:?}", faster.forces);
}

/// A shift curve has all phases, its stops at the landmarks, and every point an equilibrium.
#[test]
fn a_shift_curve_has_its_phases() {
    let case = resolved(&gx9());
    let options = ShiftOptions {
        points: 8,
        from: Some(1050.0 * RPM),
        solve: SolveOptions { tolerance: 1e-4, ..SolveOptions::default() },
        ..ShiftOptions::default()
    };
    let branch = shift_branch(&case, UP, &options, &mut |_| ControlFlow::Continue(())).unwrap();
    let failed: Vec<&String> = branch.points.iter().filter_map(|point| point.report.as_ref().err()).collect();
    assert!(failed.is_empty(), "{failed:?}");
    let engagement = branch.engagement.unwrap() / RPM;
    assert!(engagement > 1000.0 && engagement < 2600.0, "{engagement} rpm");
    let (out, full) = (branch.shift_out.unwrap(), branch.full_shift.unwrap());
    assert!(out.secondary_speed < full.secondary_speed && out.ratio > full.ratio, "{out:?} {full:?}");
    let phases: Vec<_> = branch.points.iter().map(|point| point.report.as_ref().unwrap().phase).collect();
    for phase in [ReportedPhase::Low, ReportedPhase::Shift, ReportedPhase::High] {
        assert!(phases.contains(&phase), "{phases:?}");
    }
    assert_eq!(shift_table(std::slice::from_ref(&branch)).rows.len(), branch.points.len());
}

/// With friction in the actuators the ends of the phases are out of reach of one step from the middle of the shift.
#[test]
fn a_shift_curve_with_friction_has_its_phases() {
    let friction = [("primary.actuator.friction_angle", "2 deg"), ("secondary.actuator.friction_angle", "3 deg")];
    let case = friction.iter().fold(gx9(), |case, (key, angle)| case.with(key, angle).unwrap());
    let solve = SolveOptions { tolerance: 1e-4, ..options() };
    let options = ShiftOptions { points: 2, solve, ..ShiftOptions::default() };
    let go_on = &mut |_: &_| ControlFlow::Continue(());
    let branch = shift_branch(&resolved(&case), UP, &options, go_on).unwrap();
    assert!(branch.remarks.is_empty(), "{:?}", branch.remarks);
    let (out, full) = (branch.shift_out.unwrap(), branch.full_shift.unwrap());
    assert!(out.ratio > 2.5 && full.ratio < 0.65 && branch.take_off.unwrap().ratio > out.ratio, "{branch:?}");
    assert!(branch.points.iter().all(|point| point.report.is_ok()));
    // Each phase has its end for its last point.
    let phases: Vec<_> = branch.points.iter().map(|point| point.report.as_ref().unwrap().phase).collect();
    let wanted = [ReportedPhase::Engagement, ReportedPhase::Low, ReportedPhase::Shift, ReportedPhase::High];
    assert_eq!(phases, wanted);
}

/// The ends of the phases are those of the belt as warm as it becomes there, as the points of the curve are.
#[test]
fn the_ends_of_the_phases_are_those_of_a_warm_belt() {
    let heat = [("thermal.ambient", "25 degC"), ("thermal.heat_transfer", "20 W/K")];
    let case = heat.iter().fold(gx9(), |case, (key, value)| case.with(key, value).unwrap());
    let solve = SolveOptions { tolerance: 1e-4, ..options() };
    let options = ShiftOptions { points: 2, solve, ..ShiftOptions::default() };
    let along =
        |case: &Case| shift_branch(&resolved(case), UP, &options, &mut |_: &_| ControlFlow::Continue(())).unwrap();
    let (warm, given) = (along(&case), along(&gx9()));
    assert!(warm.remarks.is_empty(), "{:?}", warm.remarks);
    for (end, as_given) in
        [(warm.take_off, given.take_off), (warm.shift_out, given.shift_out), (warm.full_shift, given.full_shift)]
    {
        let (end, as_given) = (end.unwrap(), as_given.unwrap());
        let point = warm.points.iter().find(|point| point.secondary_speed == end.secondary_speed).unwrap();
        let report = point.report.as_ref().unwrap();
        let apart = (report.primary_speed - end.primary_speed).abs();
        assert!(apart < 0.1 * RPM && (report.ratio / end.ratio - 1.0).abs() < 1e-3, "{end:?} {report:?}");
        assert!((as_given.primary_speed - end.primary_speed).abs() > 5.0 * RPM, "{end:?} {as_given:?}");
    }
}

/// Beyond the travel the primary rests on its stop, which carries what the belt does not.
#[test]
fn a_stop_carries_what_is_too_much() {
    let mut case = gx9();
    case.set("primary.travel", "10 mm").unwrap();
    let case = resolved(&case);
    let found = equilibrium(&case, 3000.0 * RPM, UP, &options()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.phase, Phase::High(Stop::PrimaryClosed));
    assert!((found.primary_travel - 10e-3).abs() < 1e-12, "{}", found.primary_travel);
    let press = found.forces.primary.unwrap().value;
    let stop = found.forces.stop.unwrap();
    assert!(stop > 0.0 && (press - found.forces.primary_belt - stop).abs() < 1e-9 * press, "{:?}", found.forces);
    // From there back to where it shifts.
    let slower = equilibrium_from(&found, &case, 1600.0 * RPM, UP, &options()).unwrap();
    assert_eq!(slower.phase, Phase::Shift, "{:?}", slower.forces);
    assert!(slower.primary_travel < 10e-3);
}

#[test]
fn what_is_missing_is_said() {
    let error = equilibrium(&resolved(&Case::base()), 300.0, UP, &options()).unwrap_err();
    assert!(matches!(error, EquilibriumError::Missing { what: "actuators", .. }), "{error}");
    let mut case = gx9();
    case.unset("engine.speeds").unwrap();
    let error = case.resolve().unwrap_err();
    assert!(error.to_string().contains("needs `engine.speeds`"), "{error}");
    // In the key's unit, not in rad/s.
    let mut case = gx9();
    case.set("engine.speeds", "1800, 2400, 3400, 3000, 3800 rpm").unwrap();
    case.set("engine.torques", "18, 19, 19, 18, 16 N m").unwrap();
    let error = case.resolve().unwrap_err();
    assert!(error.to_string().contains("number 4 is 3000 rpm, not beyond 3400 rpm"), "{error}");
    let error = equilibrium(&resolved(&gx9()), -1.0, UP, &options()).unwrap_err();
    assert!(matches!(error, EquilibriumError::Speed(_)), "{error}");
}

fn ratio(found: &Equilibrium) -> f64 {
    found.solved.constant(Constant::SecondaryRadius) / found.solved.constant(Constant::PrimaryRadius)
}

/// The Baja car with other parts.
fn with(settings: &[(&str, &str)]) -> Resolved {
    let mut case = gx9();
    for (key, value) in settings {
        case.set(key, value).unwrap_or_else(|error| panic!("{error}"));
    }
    resolved(&case)
}

/// Ratios of a curve up between two speeds of the secondary in rpm.
fn ratios(case: &Resolved, from: f64, to: f64, points: usize) -> Vec<f64> {
    let range = ShiftOptions { points, from: Some(from * RPM), to: Some(to * RPM), ..ShiftOptions::default() };
    let branch = shift_branch(case, UP, &range, &mut |_| ControlFlow::Continue(())).unwrap();
    branch.points.iter().map(|point| point.report.as_ref().unwrap().ratio).collect()
}

/// A steep helix with friction leaves two equilibria at one speed: one at which the belt holds, and one at a ratio
/// below 1 at which half of the speed is lost. Search and curve take the one that holds, and so the curve has no jump.
#[test]
fn of_two_equilibria_the_one_that_holds_is_found() {
    let steep = with(&[
        ("secondary.actuator.helix_angle", "49.4 deg"),
        ("secondary.actuator.friction_angle", "5.3 deg"),
        ("secondary.spring.pretension", "64 deg"),
        ("primary.actuator.friction_angle", "2.9 deg"),
    ]);
    // Here the belt slips from the take-off on, and holds only later.
    let weak = with(&[
        ("primary.actuator.mass", "93 g"),
        ("secondary.actuator.helix_angle", "46.5 deg"),
        ("secondary.spring.pretension", "31 deg"),
        ("primary.spring.preload", "439 N"),
        ("primary.spring.rate", "16.5 N/mm"),
        ("secondary.actuator.friction_angle", "3.2 deg"),
        ("engine.throttle", "0.81"),
    ]);
    for (case, from, to, there) in [(steep, 1114.0, 2307.7, 1.2016), (weak, 1121.0, 2504.0, 1.2307)] {
        let found = equilibrium(&case, to * RPM, UP, &options()).unwrap();
        assert!((ratio(&found) - there).abs() < 2e-3, "{}", ratio(&found));
        let ratios = ratios(&case, from, to, 4);
        assert!(ratios.windows(2).all(|pair| pair[1] < pair[0] && pair[1] > 0.7 * pair[0]), "{ratios:?}");
        assert!((ratios[ratios.len() - 1] / ratio(&found) - 1.0).abs() < 1e-5, "{ratios:?}");
    }
}

/// A drive that begins to shift before its belt holds has no take-off at its low stop; and a state in which the belt
/// has left the secondary is no full shift, though its equations hold.
#[test]
fn a_curve_has_no_ends_to_which_the_drive_does_not_come() {
    let case = with(&[
        ("primary.actuator.mass", "100 g"),
        ("secondary.actuator.helix_angle", "45.4 deg"),
        ("secondary.spring.pretension", "69 deg"),
        ("primary.spring.preload", "437 N"),
        ("primary.spring.rate", "9.9 N/mm"),
        ("secondary.actuator.friction_angle", "0.8 deg"),
        ("engine.throttle", "0.56"),
        ("sheave.friction_coefficient", "0.31"),
    ]);
    let few = ShiftOptions { points: 4, to: Some(3000.0 * RPM), ..ShiftOptions::default() };
    let branch = shift_branch(&case, UP, &few, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!((branch.take_off, branch.full_shift), (None, None));
    let told = |words: &str| branch.remarks.iter().any(|remark| remark.contains(words));
    assert!(told("the secondary opens before") && told("far deeper"), "{:?}", branch.remarks);
    let speeds: Vec<f64> = branch.points.iter().map(|point| point.report.as_ref().unwrap().primary_speed).collect();
    assert!(speeds.windows(2).all(|pair| pair[1] > pair[0] && pair[1] < 1.2 * pair[0]), "{speeds:?}");
}

/// A helix that carries little torque leaves the slack strand no tension towards the high stop: there the belt is held
/// by its speed alone, until no state is left. The curve goes on to the high stop, where it is taut again.
#[test]
fn a_belt_that_buckles_is_told_and_passed() {
    let case = with(&[("secondary.actuator.torque_share", "0.6")]);
    let few = ShiftOptions { points: 4, from: Some(6100.0 * RPM), ..ShiftOptions::default() };
    let branch = shift_branch(&case, UP, &few, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(branch.full_shift, None);
    assert!(branch.remarks.iter().any(|remark| remark.contains("the belt buckles")), "{:?}", branch.remarks);
    let reports: Vec<_> = branch.points.iter().filter_map(|point| point.report.as_ref().ok()).collect();
    let doubts: Vec<_> = reports.iter().map(|report| report.doubt).collect();
    assert!(doubts.first() == Some(&None) && doubts.contains(&Some(Doubt::Pushed)), "{doubts:?}");
    let last = reports.last().unwrap();
    assert_eq!((last.phase, last.doubt), (ReportedPhase::High, None));
    assert!((last.primary_speed / RPM - 3975.0).abs() < 10.0, "{}", last.primary_speed / RPM);
    let pushed = reports.iter().find(|report| report.doubt == Some(Doubt::Pushed)).unwrap();
    assert!(pushed.slip_words().starts_with("amber: it does not slip, but a strand"), "{}", pushed.slip_words());
    let said = over_curve(&case, reports.into_iter().map(Box::as_ref));
    assert!(said.iter().any(|sentence| sentence.contains("a strand of the belt is pushed")), "{said:?}");
    // Where there are two at the high stop, one of them pushed, the other is found from nothing.
    let found = equilibrium(&case, 6700.0 * RPM, UP, &options()).unwrap();
    assert!((found.primary_speed() / RPM - 3897.3).abs() < 1.0, "{}", found.primary_speed() / RPM);
    // Between them there is none.
    let missing = equilibrium(&case, 6605.0 * RPM, UP, &options()).unwrap_err();
    let buckles = match &missing {
        EquilibriumError::Failure { failure, .. } => matches!(failure.trouble(), Some(Trouble::Buckles { .. })),
        _ => false,
    };
    assert!(buckles && missing.hint().is_some_and(|hint| hint.contains("clamp the belt tighter")), "{missing}");
}

/// Where the flyweights would leave the primary open if the belt did not slip, it slips: the engine turns faster than
/// the road has it, and presses it together. Found from nothing as from a faster road.
#[test]
fn a_drive_that_slips_as_a_clutch_is_found_from_nothing() {
    let case = resolved(&gx9());
    let found = equilibrium(&case, 300.0 * RPM, UP, &options()).unwrap();
    let mut near = equilibrium(&case, 600.0 * RPM, UP, &options()).unwrap();
    for speed in [520.0, 440.0, 380.0, 330.0, 300.0] {
        near = equilibrium_from(&near, &case, speed * RPM, UP, &options()).unwrap();
    }
    assert!((found.primary_speed() / near.primary_speed() - 1.0).abs() < 1e-5);
    assert_eq!(found.phase, Phase::Low);
    assert!(found.output(Output::EfficiencySpeed).unwrap() < 0.5);
}

/// A primary that is open cannot let the belt lie deeper: with such radii at the low stop the secondary would not
/// close.
#[test]
fn stops_that_no_belt_meets_are_refused() {
    let mut case = gx9();
    // Closed on the secondary the belt lies at 29.6 mm on the primary.
    case.set("primary.start_radius", "29 mm").unwrap();
    assert!(case.resolve().is_ok());
    case.set("primary.start_radius", "35 mm").unwrap();
    let told = case.resolve().unwrap_err().to_string();
    assert!(told.contains("primary.start_radius") && told.contains("hold the secondary open"), "{told}");
}

/// The base case's radii, which nobody gave, do not fit pulleys this close; those of a whole drive follow from it.
#[test]
fn a_whole_drive_needs_no_radii() {
    let mut case = gx9();
    case.set("drive.center_distance", "130 mm").unwrap();
    case.set("belt.length", "600 mm").unwrap();
    case.set("secondary.closed_radius", "75 mm").unwrap();
    case.set("primary.travel", "5 mm").unwrap();
    let told = case.resolve().map(|_| ()).map_err(|error| error.to_string());
    assert_eq!(told, Ok(()));
    case.set("drive.primary_radius", "68 mm").unwrap();
    assert!(case.resolve().unwrap_err().to_string().contains("overlap"));
}

/// At high speeds the equations have a solution with a belt far off the secondary, and starts from nothing may lead
/// there or nowhere: the drive is found from a slower road, as along its curve.
#[test]
fn a_fast_drive_is_found_where_its_belt_lies() {
    let first = with(&[
        ("primary.actuator.mass", "93 g"),
        ("secondary.actuator.helix_angle", "45.5 deg"),
        ("secondary.spring.pretension", "104 deg"),
        ("primary.spring.preload", "205 N"),
        ("primary.spring.rate", "11.0 N/mm"),
        ("secondary.actuator.friction_angle", "4.5 deg"),
        ("engine.throttle", "0.83"),
        ("sheave.friction_coefficient", "0.48"),
    ]);
    let second = with(&[
        ("primary.actuator.mass", "170 g"),
        ("secondary.actuator.helix_angle", "42.4 deg"),
        ("secondary.spring.pretension", "42 deg"),
        ("primary.spring.preload", "180 N"),
        ("primary.spring.rate", "16.3 N/mm"),
        ("secondary.actuator.friction_angle", "2.9 deg"),
        ("engine.throttle", "0.97"),
        ("sheave.friction_coefficient", "0.57"),
    ]);
    for (case, speed, there) in [(first, 6757.0, 0.579), (second, 6937.0, 0.573)] {
        let found = equilibrium(&case, speed * RPM, Direction::Back, &options()).unwrap();
        assert!((ratio(&found) - there).abs() < 2e-3, "{}", ratio(&found));
        let near = equilibrium(&case, 5500.0 * RPM, Direction::Back, &options()).unwrap();
        let near = equilibrium_from(&near, &case, 6200.0 * RPM, Direction::Back, &options()).unwrap();
        let along = equilibrium_from(&near, &case, speed * RPM, Direction::Back, &options()).unwrap();
        assert!((ratio(&found) / ratio(&along) - 1.0).abs() < 1e-5);
    }
}
