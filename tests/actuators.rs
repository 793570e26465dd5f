//! Forces of actuators against virtual work, differences, the thesis's (9.3), and parts measured on a bench.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::PI;

use sheave::actuator::{
    ActuatorError, AngleFrom, CamArm, Flyweights, Helix, Mechanism, Profile, RollerArm, Shift, Spring, travel,
};

const SPEED: f64 = 320.0;

/// A Gaged GX9 as shua5115/Terps-Racing-Baja-Simulator (MIT) states it: arm 33.02 mm, pivot radius 41.88 mm; the path
/// of the centre of a roller of 6.35 mm on a ramp 20.25 − 0.805 x + 0.01 x² mm below a cage of 65.23 mm, by points.
fn gaged() -> RollerArm {
    let (cage, roller) = (65.231e-3, 6.35e-3);
    let points: Vec<(f64, f64)> = (0..=60)
        .map(|i| {
            let x = 1e-3 * f64::from(i) * 0.5;
            let depth = 1e-3 * (20.25 - 0.805e3 * x + 0.01e6 * x * x);
            let slope = 0.805 - 0.02e3 * x;
            let length = (1.0 + slope * slope).sqrt();
            (x + roller * slope / length, cage - depth - roller / length)
        })
        .collect();
    let (places, radii) = points.into_iter().unzip();
    RollerArm {
        pivot_radius: 41.877e-3,
        arm_length: 33.02e-3,
        mass_distance: 30e-3,
        mass_angle: 0.1,
        ramp: Profile::new(places, radii).unwrap(),
        ramp_start: 41e-3,
        friction_angle: 0.0,
    }
}

fn cam_arm() -> CamArm {
    let distances: Vec<f64> = (0..=20).map(|i| 0.024 + 1e-3 * f64::from(i)).collect();
    let angles = distances.iter().map(|d| 0.6 - 45.0 * (d - 0.024) - 300.0 * (d - 0.024).powi(2)).collect();
    CamArm {
        pivot_radius: 40e-3,
        roller_radius: 52e-3,
        start: 25e-3,
        mass_distance: 28e-3,
        mass_angle: -0.3,
        pitch_curve: Profile::new(distances, angles).unwrap(),
        friction_angle: 0.0,
    }
}

fn flyweights(mechanism: Mechanism) -> Flyweights {
    Flyweights { count: 4, mass: 0.134, mechanism }
}

/// Radius of the arm's centre of mass, by bisection for the angle at which the roller bears on its ramp.
fn mass_radius(arm: &RollerArm, travel: f64) -> f64 {
    let gap = |angle: f64| {
        let place = arm.ramp_start + travel - arm.arm_length * angle.cos();
        arm.pivot_radius + arm.arm_length * angle.sin() - arm.ramp.at(place).value
    };
    let (mut low, mut high) = (-0.5, 0.8);
    assert!(gap(low) < 0.0 && gap(high) > 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if gap(middle) < 0.0 { low = middle } else { high = middle }
    }
    arm.pivot_radius + arm.mass_distance * (low + arm.mass_angle).sin()
}

/// Without friction ∫F ds is what the masses gain in the rotating frame: N m ω² (r₂² − r₁²)/2.
#[test]
fn a_roller_arm_does_the_work_of_its_masses() {
    let arm = gaged();
    let weights = flyweights(Mechanism::RollerArm(arm.clone()));
    let (from, to, steps) = (1e-3, 11e-3, 2000);
    let step = (to - from) / f64::from(steps);
    let force = |at: f64| weights.force(SPEED, at, Shift::Frictionless).unwrap().value;
    let work: f64 = (0..steps).map(|i| step * force(from + step * (f64::from(i) + 0.5))).sum();
    let gain = 0.5 * 4.0 * 0.134 * SPEED * SPEED * (mass_radius(&arm, to).powi(2) - mass_radius(&arm, from).powi(2));
    assert!((work / gain - 1.0).abs() < 1e-6, "{work} J of {gain} J");
}

/// The same for a cam arm, whose angle follows from its travel: θ = χ − ξ(d).
#[test]
fn a_cam_arm_does_the_work_of_its_masses() {
    let arm = cam_arm();
    let radius = |travel: f64| {
        let (across, along) = (arm.roller_radius - arm.pivot_radius, arm.start + travel);
        let angle = across.atan2(along) - arm.pitch_curve.at(across.hypot(along)).value;
        arm.pivot_radius + arm.mass_distance * (angle + arm.mass_angle).sin()
    };
    let weights = flyweights(Mechanism::CamArm(arm.clone()));
    let (from, to, steps) = (0.0, 12e-3, 2000);
    let step = (to - from) / f64::from(steps);
    let force = |at: f64| weights.force(SPEED, at, Shift::Frictionless).unwrap().value;
    let work: f64 = (0..steps).map(|i| step * force(from + step * (f64::from(i) + 0.5))).sum();
    let gain = 0.5 * 4.0 * 0.134 * SPEED * SPEED * (radius(to).powi(2) - radius(from).powi(2));
    assert!((work / gain - 1.0).abs() < 1e-6, "{work} J of {gain} J");
}

#[test]
fn derivatives_are_those_of_differences() {
    let ramp = Profile::new(vec![0.0, 5e-3, 12e-3], vec![38e-3, 43e-3, 48e-3]).unwrap();
    let table = Profile::new(vec![0.0, 7e-3, 12e-3], vec![0.039, 0.036, 0.034]).unwrap();
    let roller = RollerArm { friction_angle: 0.05, ..gaged() };
    let cam = CamArm { friction_angle: 0.05, ..cam_arm() };
    for mechanism in [
        Mechanism::Coefficient { coefficient: table, lost: 0.03 },
        Mechanism::Ramp { radius: ramp, friction_angle: 0.06 },
        Mechanism::RollerArm(roller),
        Mechanism::CamArm(cam),
    ] {
        let weights = flyweights(mechanism);
        for shift in [Shift::Closing, Shift::Opening, Shift::Frictionless] {
            let at = |speed: f64, travel: f64| weights.force(speed, travel, shift).unwrap();
            let (place, h) = (4.3e-3, 1e-7);
            let found = at(SPEED, place);
            let by_travel = (at(SPEED, place + h).value - at(SPEED, place - h).value) / (2.0 * h);
            let by_speed = (at(SPEED + 1e-3, place).value - at(SPEED - 1e-3, place).value) / 2e-3;
            let scale = found.value / 1e-2;
            assert!((found.by_travel - by_travel).abs() < 1e-5 * scale, "{weights:?}: {found:?}, {by_travel}");
            assert!((found.by_speed - by_speed).abs() < 1e-6 * by_speed, "{weights:?}: {found:?}, {by_speed}");
            assert!((found.by_mass * 0.134 / found.value - 1.0).abs() < 1e-12);
        }
    }
}

/// Friction takes of the force where the sheave closes, and adds to it where it opens: between the two nothing moves.
#[test]
fn friction_opens_a_band() {
    let roller = RollerArm { friction_angle: 3f64.to_radians(), ..gaged() };
    let weights = flyweights(Mechanism::RollerArm(roller));
    let [closing, none, opening] = [Shift::Closing, Shift::Frictionless, Shift::Opening]
        .map(|shift| weights.force(SPEED, 5e-3, shift).unwrap().value);
    assert!(closing < none && none < opening, "{closing} {none} {opening}");
    let mut helix = Helix::constant(46e-3, 38f64.to_radians()).unwrap();
    helix.friction_angle = 3f64.to_radians();
    let [closing, none, opening] = [Shift::Closing, Shift::Frictionless, Shift::Opening]
        .map(|shift| helix.force(30.0, 2e-3, shift).unwrap().value);
    assert!(closing < none && none < opening, "{closing} {none} {opening}");
}

/// (9.3): F_A = 3 m r ΔD_R/ΔD_A ω² − (950 − 18200·2 tan β (0.093 − R_P)), with m = 0.228 kg and β = 12°.
#[test]
fn the_primary_of_the_thesis() {
    let beta = 12f64.to_radians();
    let spring = Spring { preload: 950.0, rate: 18200.0, lengths: None };
    let (radius, slope) = (0.04, 0.9);
    let coefficient = Profile::line(0.0, radius * slope, 0.0);
    let weights = Flyweights { count: 3, mass: 0.228, mechanism: Mechanism::Coefficient { coefficient, lost: 0.0 } };
    for primary in [0.045, 0.068, 0.093] {
        // From full shift: the travel is negative.
        let at = travel(beta, 0.093, primary);
        let force = weights.force(SPEED, at, Shift::Closing).unwrap().value - spring.force(at).unwrap().value;
        let printed =
            3.0 * 0.228 * radius * slope * SPEED * SPEED - (950.0 - 18200.0 * 2.0 * beta.tan() * (0.093 - primary));
        assert!((force - printed).abs() < 1e-9 * printed.abs(), "{force} N, printed {printed} N");
    }
}

/// Without a spring the speed that a clamp needs goes with 1/√m: m₂ = m₁ (n₁/n₂)².
#[test]
fn tuners_rule_of_thumb() {
    let ramp = Profile::new(vec![0.0, 12e-3], vec![38e-3, 48e-3]).unwrap();
    let weights =
        |mass| Flyweights { count: 3, mass, mechanism: Mechanism::Ramp { radius: ramp.clone(), friction_angle: 0.05 } };
    let (n1, n2): (f64, f64) = (3400.0, 3600.0);
    let clamp = |mass: f64, n: f64| weights(mass).force(n * PI / 30.0, 3e-3, Shift::Closing).unwrap().value;
    let lighter = 0.2 * (n1 / n2).powi(2);
    assert!((clamp(lighter, n2) / clamp(0.2, n1) - 1.0).abs() < 1e-12);
}

/// Frictionless, the helix does the work that its torque does: F ds = T dφ; a varying helix turns by the integral.
#[test]
fn a_helix_does_the_work_of_its_torque() {
    let angle = Profile::new(vec![0.0, 9e-3, 18e-3], vec![0.75, 0.65, 0.5]).unwrap();
    let mut helix = Helix::varying(46e-3, &angle).unwrap();
    (helix.torsion_rate, helix.pretension, helix.torque_share) = (3.8, 1.2, 0.5);
    let (torque, steps) = (25.0, 4000);
    let step = 18e-3 / f64::from(steps);
    let mut work = [0.0, 0.0];
    for i in 0..steps {
        let at = step * (f64::from(i) + 0.5);
        let force = helix.force(torque, at, Shift::Frictionless).unwrap();
        let turned = helix.turn(at + 0.5 * step) - helix.turn(at - 0.5 * step);
        work[0] += force.value * step;
        work[1] += force.torque * turned;
    }
    assert!((work[0] / work[1] - 1.0).abs() < 1e-6, "{work:?}");
    // By hand where the angle is 0.65 rad: (ζ M + κ (φ₀ + φ))/(r tan α).
    let force = helix.force(torque, 9e-3, Shift::Frictionless).unwrap();
    let by_hand = (0.5 * torque + 3.8 * (1.2 + helix.turn(9e-3))) / (46e-3 * 0.65f64.tan());
    assert!((force.value / by_hand - 1.0).abs() < 1e-4, "{} N, by hand {by_hand} N", force.value);
    let h = 1e-7;
    let at = |torque: f64, opening: f64| helix.force(torque, opening, Shift::Frictionless).unwrap().value;
    let by_opening = (at(torque, 4e-3 + h) - at(torque, 4e-3 - h)) / (2.0 * h);
    let found = helix.force(torque, 4e-3, Shift::Frictionless).unwrap();
    assert!((found.by_opening - by_opening).abs() < 1e-4 * by_opening.abs(), "{} {by_opening}", found.by_opening);
    assert!((found.by_torque - (at(26.0, 4e-3) - at(25.0, 4e-3))).abs() < 1e-8 * found.value);
}

#[test]
fn angles_may_be_measured_from_the_axis() {
    let from_axis = AngleFrom::Axis.from_rotation(52f64.to_radians());
    assert!((from_axis - AngleFrom::Rotation.from_rotation(38f64.to_radians())).abs() < 1e-15);
}

/// Spring "purple" and flyweight "1072" of the bench of the University of Pretoria (HP-Eng1004/TuksBaja_CVT_Code_2025,
/// MIT): the primary presses from about 2060 rpm on, where its measured curve begins to rise.
#[test]
fn a_measured_primary_engages_where_it_was_seen_to() {
    let table = Profile::new(
        [0.0, 4.5, 11.7, 18.9, 26.1, 33.3].iter().map(|mm| 1e-3 * mm).collect(),
        vec![0.034533, 0.039467, 0.03932, 0.038353, 0.037442, 0.037967],
    );
    let mechanism = Mechanism::Coefficient { coefficient: table.unwrap(), lost: 0.0 };
    let weights = Flyweights { count: 3, mass: 0.072, mechanism };
    let spring = Spring::from_lengths(0.106, 8.2e3, 0.0635, None).unwrap();
    let clamp = |rpm: f64| {
        weights.force(rpm * PI / 30.0, 0.0, Shift::Closing).unwrap().value - spring.force(0.0).unwrap().value
    };
    assert!(clamp(2050.0) < 0.0 && clamp(2075.0) > 0.0, "{} {}", clamp(2050.0), clamp(2075.0));
}

#[test]
fn parts_that_cannot_work_are_refused() {
    let steep = Profile::new(vec![0.0, 10e-3], vec![40e-3, 40.2e-3]).unwrap();
    let locked = flyweights(Mechanism::Ramp { radius: steep, friction_angle: 0.05 });
    let refused = locked.force(SPEED, 1e-3, Shift::Closing).unwrap_err();
    assert!(matches!(refused, ActuatorError::NoForce { .. }), "{refused}");
    let short = flyweights(Mechanism::RollerArm(RollerArm { arm_length: 5e-3, ..gaged() }));
    assert!(matches!(short.force(SPEED, 0.0, Shift::Closing), Err(ActuatorError::OffRamp { .. })));
    let spring = Spring::from_lengths(0.1, 5e3, 0.06, Some(0.03)).unwrap();
    assert_eq!(
        spring.force(0.035).unwrap_err().to_string(),
        "at a travel of 35.000 mm the spring would be 25.00 mm long, shorter than its solid length of 30.00 mm"
    );
    let helix = Helix::constant(46e-3, 0.6).unwrap();
    let refused = helix.force(-5.0, 0.0, Shift::Frictionless).unwrap_err();
    assert!(matches!(refused, ActuatorError::HelixContact { .. }), "{refused}");
    assert!(Helix::constant(46e-3, 1.6).unwrap_err().to_string().starts_with("the helix angle is 1.6"));
    assert!(Spring::from_lengths(0.05, 5e3, 0.06, None).is_err());
}
