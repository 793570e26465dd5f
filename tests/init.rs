//! The simple belt drive against its own primitive relations, in all seven situations, both ways; and `sheave init`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use sheave::small::init::{InitError, InitialState, Method, PulleyId, SimpleDrive, Situation, solve};
use std::f64::consts::{FRAC_PI_2, PI};
use std::process::{Command, Output};

/// Splitmix64, as in the kernels' tests.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let bits = z ^ (z >> 31);
        low + (high - low) * ((bits >> 11) as f64 / (1u64 << 53) as f64)
    }
}

fn random_drive(random: &mut Random) -> SimpleDrive {
    let (input_radius, output_radius) = (random.between(0.03, 0.12), random.between(0.03, 0.12));
    let center_distance = (input_radius + output_radius) * random.between(1.1, 2.5);
    let half_angle = random.between(0.15, 0.4);
    SimpleDrive {
        input_radius,
        output_radius,
        half_contact_angle: FRAC_PI_2 + ((output_radius - input_radius) / center_distance).asin(),
        longitudinal_stiffness: random.between(2e4, 4e5),
        mass_per_length: random.between(0.05, 0.8),
        friction_coefficient: random.between(0.2, 0.6) / half_angle.sin(),
        half_angle,
    }
}

/// A state from the primitive relations alone: belt speed, slack force and sliding angle are chosen, the longitudinal
/// force and the axial load S' = (L (EA − m* v_0²) − m* v_0² EA)/(2 tan δ_0 EA) of (12) are followed around each pulley
/// in steps.
fn reference(drive: &SimpleDrive, v_0: f64, excess: f64, sliding: f64, drives: bool) -> InitialState {
    let (ea, m) = (drive.longitudinal_stiffness, drive.mass_per_length);
    let lift_off = m * v_0 * v_0 * ea / (ea - m * v_0 * v_0);
    let loose = lift_off + excess;
    let taut = lift_off + excess * (drive.friction_coefficient * sliding).exp();
    // Where the output drives, the belt is taut where it enters the output pulley.
    let (output_in, input_in) = if drives { (loose, taut) } else { (taut, loose) };
    let axial = |entry: f64, rate: f64, contact: f64| {
        let load = |theta: f64| {
            let slid = (theta - (contact - sliding)).max(0.0);
            let force = lift_off + (entry - lift_off) * (rate * slid).exp();
            (force * (ea - m * v_0 * v_0) - m * v_0 * v_0 * ea) / (2.0 * drive.half_angle.tan() * ea)
        };
        simpson(&load, 0.0, contact - sliding, 2) + simpson(&load, contact - sliding, contact, 2000)
    };
    let rate = if drives { drive.friction_coefficient } else { -drive.friction_coefficient };
    InitialState {
        input_speed: v_0 * (1.0 + input_in / ea) / drive.input_radius,
        output_speed: v_0 * (1.0 + output_in / ea) / drive.output_radius,
        input_torque: drive.input_radius * (output_in - input_in),
        output_torque: drive.output_radius * (input_in - output_in),
        input_axial_force: axial(input_in, -rate, drive.contact_angle(PulleyId::Input)),
        output_axial_force: axial(output_in, rate, drive.contact_angle(PulleyId::Output)),
        belt_speed: v_0,
        sliding_angle: sliding,
        lift_off_force: lift_off,
        slack_force: output_in,
        tight_force: input_in,
        slack_tension: output_in - m * v_0 * v_0 * (1.0 + output_in / ea),
        tight_tension: input_in - m * v_0 * v_0 * (1.0 + input_in / ea),
        method: Method::Closed,
    }
}

fn simpson(f: &impl Fn(f64) -> f64, from: f64, to: f64, intervals: usize) -> f64 {
    let h = (to - from) / intervals as f64;
    let weight = |i: usize| if i == 0 || i == intervals { 1.0 } else { 2.0 + 2.0 * (i % 2) as f64 };
    (0..=intervals).map(|i| weight(i) * f(from + i as f64 * h)).sum::<f64>() * h / 3.0
}

fn random_state(drive: &SimpleDrive, random: &mut Random, drives: bool) -> InitialState {
    let fastest = (drive.longitudinal_stiffness / drive.mass_per_length).sqrt();
    let v_0 = random.between(2.0, (0.2 * fastest).min(45.0));
    let contact = drive.contact_angle(PulleyId::Input).min(drive.contact_angle(PulleyId::Output));
    // As far as e^(μ* Φ) = 100: a belt that is tighter on one side than a drive can be.
    let most = contact.min(100f64.ln() / drive.friction_coefficient);
    reference(drive, v_0, random.between(20.0, 300.0), random.between(0.02, 0.95) * most, drives)
}

/// All seven questions to which a state is the answer.
fn situations(state: &InitialState) -> [Situation; 7] {
    let InitialState {
        input_speed,
        output_speed,
        input_torque,
        output_torque,
        input_axial_force,
        output_axial_force,
        ..
    } = *state;
    [
        Situation::One { input_speed, output_torque, output_axial_force },
        Situation::Two { output_speed, input_torque, input_axial_force },
        Situation::Three { input_speed, output_speed, output_axial_force },
        Situation::Four { input_speed, output_speed, input_axial_force },
        Situation::Five { input_speed, output_torque, input_axial_force },
        Situation::Six { input_speed, input_torque, output_axial_force },
        Situation::Seven { input_speed, input_torque, input_axial_force },
    ]
}

fn quantities(state: &InitialState) -> [(&'static str, f64); 13] {
    [
        ("ω_I", state.input_speed),
        ("ω_O", state.output_speed),
        ("M_I", state.input_torque),
        ("M_O", state.output_torque),
        ("F_CI", state.input_axial_force),
        ("F_CO", state.output_axial_force),
        ("v_0", state.belt_speed),
        ("Φ", state.sliding_angle),
        ("K", state.lift_off_force),
        ("L_Oin", state.slack_force),
        ("L_Iin", state.tight_force),
        ("slack", state.slack_tension),
        ("tight", state.tight_tension),
    ]
}

fn assert_same(found: &InitialState, expected: &InitialState, tolerance: f64, what: &str) {
    for ((name, found), (_, expected)) in quantities(found).into_iter().zip(quantities(expected)) {
        let error = (found - expected).abs() / expected.abs().max(1e-3);
        assert!(error <= tolerance, "{what}: {name} is {found}, not {expected} ({error:.1e})");
    }
}

/// Strains are small differences of speeds: what rounding the speeds does to the tension, relative.
fn rounding(drive: &SimpleDrive, state: &InitialState) -> f64 {
    let tension = state.slack_tension.min(state.tight_tension);
    let torque = state.output_torque.abs() / drive.output_radius;
    16.0 * f64::EPSILON * drive.longitudinal_stiffness / tension.min(torque)
}

#[test]
fn seven_situations_round_trip_on_random_drives() {
    let mut random = Random(2012);
    let (mut worst, mut most) = (0.0f64, 0);
    for sample in 0..60 {
        let drive = random_drive(&mut random);
        let expected = random_state(&drive, &mut random, sample % 4 != 3);
        let tolerance = rounding(&drive, &expected).max(1e-11);
        worst = worst.max(tolerance);
        for (index, situation) in situations(&expected).into_iter().enumerate() {
            assert_eq!(usize::from(situation.number()), index + 1);
            let what = format!("drive {sample}, situation {}", index + 1);
            let found =
                solve(&drive, situation).unwrap_or_else(|error| panic!("{what}: {error}, {drive:?}, {expected:?}"));
            let Method::Newton { iterations } = found.method else { panic!("{what}: in closed form") };
            most = most.max(iterations);
            assert_same(&found, &expected, tolerance, &what);
            // What it finds answers the other six.
            for (other, situation) in situations(&found).into_iter().enumerate().filter(|(other, _)| *other != index) {
                let again =
                    solve(&drive, situation).unwrap_or_else(|error| panic!("{what} into {}: {error}", other + 1));
                assert_same(&again, &found, tolerance, &format!("{what} into {}", other + 1));
            }
        }
    }
    println!("loosest tolerance {worst:.1e}, {most} steps at most");
    assert!(worst < 1e-8 && most <= 30, "{worst:e}, {most}");
}

#[test]
fn without_a_torque_all_seven_are_closed_forms() {
    let mut random = Random(220);
    for _ in 0..20 {
        let drive = random_drive(&mut random);
        let mut expected = random_state(&drive, &mut random, true);
        let v_0 = expected.belt_speed;
        expected = reference(&drive, v_0, expected.slack_force - expected.lift_off_force, 0.0, true);
        for situation in situations(&expected) {
            let found = solve(&drive, situation).unwrap();
            assert_eq!(found.method, Method::Closed, "{}", situation.number());
            assert_eq!((found.input_torque, found.output_torque, found.sliding_angle), (0.0, 0.0, 0.0));
            assert_same(&found, &expected, 1e-9, &format!("situation {}", situation.number()));
        }
        // (15) as printed, which cancels; r_O ω_O in it is the speed of either rim.
        let (f, half) = (expected.input_axial_force * drive.half_angle.tan(), PI - drive.half_contact_angle);
        let (ea, m, rim) =
            (drive.longitudinal_stiffness, drive.mass_per_length, drive.output_radius * expected.output_speed);
        let b = f + ea * half;
        let printed = ((b * b + 4.0 * ea * m * (rim * half).powi(2)).sqrt() - b) / (2.0 * m * rim * half);
        assert!((printed / v_0 - 1.0).abs() < 1e-9, "{printed} {v_0}");
    }
}

#[test]
fn a_small_torque_leads_to_no_torque() {
    let drive = random_drive(&mut Random(7));
    let solve = |output_torque: f64| {
        let given = Situation::One { input_speed: 200.0, output_torque, output_axial_force: 400.0 };
        solve(&drive, given).unwrap()
    };
    let (nothing, little, opposite) = (solve(0.0), solve(1e-6), solve(-1e-6));
    for other in [&little, &opposite] {
        for ((name, a), (_, b)) in quantities(&nothing).into_iter().zip(quantities(other)) {
            assert!((a - b).abs() <= 1e-4 * a.abs().max(1.0), "{name}: {a} {b}");
        }
    }
}

/// Speeds that differ by little more than rounding: the torque is noise, and small.
#[test]
fn nearly_equal_rims_have_nearly_no_torque() {
    let drive = random_drive(&mut Random(8));
    let rim = drive.input_radius * 200.0;
    for slip in [1e-15, 1e-14, 1e-13, 1e-12, -1e-13, 1e-9] {
        let (input_speed, output_speed) = (200.0, rim * (1.0 - slip) / drive.output_radius);
        for situation in [
            Situation::Three { input_speed, output_speed, output_axial_force: 400.0 },
            Situation::Four { input_speed, output_speed, input_axial_force: 400.0 },
        ] {
            let state = solve(&drive, situation).unwrap_or_else(|error| panic!("{slip}: {error}"));
            let expected = slip * drive.longitudinal_stiffness * drive.output_radius;
            assert!(
                (state.output_torque - expected).abs() < 1e-10 + 0.01 * expected.abs(),
                "{slip}: {}",
                state.output_torque
            );
        }
    }
}

/// Whatever the numbers: a state that satisfies its equations, or a reason.
#[test]
fn no_numbers_panic() {
    let mut random = Random(99);
    let (mut solved, mut refused, mut lost) = (0, 0, 0);
    for _ in 0..600 {
        let mut power = |low: f64, high: f64| 10f64.powf(random.between(low, high));
        let drive = SimpleDrive {
            input_radius: power(-4.0, 2.0),
            output_radius: power(-4.0, 2.0),
            half_contact_angle: power(-1.0, 0.49),
            longitudinal_stiffness: power(0.0, 9.0),
            mass_per_length: power(-6.0, 3.0),
            friction_coefficient: power(-3.0, 2.0),
            half_angle: power(-2.0, 0.19),
        };
        let state = InitialState {
            input_speed: power(-3.0, 5.0),
            output_speed: power(-3.0, 5.0),
            input_torque: -power(-6.0, 6.0),
            output_torque: power(-6.0, 6.0),
            input_axial_force: power(-3.0, 6.0),
            output_axial_force: power(-3.0, 6.0),
            ..reference(&drive, 1.0, 1.0, 0.1, true)
        };
        for situation in situations(&state) {
            match solve(&drive, situation) {
                Ok(state) => {
                    assert!(quantities(&state).iter().all(|(_, value)| value.is_finite()), "{drive:?} {state:?}");
                    assert!(state.sliding_angle >= 0.0, "{drive:?} {situation:?} {state:?}");
                    solved += 1;
                }
                Err(error) => {
                    // Forces that a belt could bear, and slack tensions that rounding leaves of its strain.
                    let (ea, contact) = (drive.longitudinal_stiffness, drive.contact_angle(PulleyId::Input).max(PI));
                    let forces =
                        [state.input_axial_force, state.output_axial_force, state.output_torque / drive.output_radius];
                    let sane = forces.iter().all(|force| *force < 0.1 * ea && *force > 1e-9 * ea)
                        && drive.friction_coefficient * contact < 12.0;
                    if matches!(error, InitError::NotConverged { .. }) {
                        assert!(!sane, "{error}: {drive:?} {situation:?}");
                        lost += 1;
                    }
                    refused += 1;
                }
            }
        }
    }
    println!("{solved} solved, {refused} refused, {lost} lost");
    assert!(solved > 1000 && refused > 1000 && lost < 100, "{solved}, {refused}, {lost}");
}

/// By hand: r = 0.1 m on both pulleys, φ = π/2, EA = 1e5 N, m* = 0, δ_0 with tan δ_0 = 0.25, F_CO = 200 N, ω_I = 100
/// rad/s. Then L is F tan δ_0/φ = 100/π N everywhere, and v_0 = r ω/(1 + L/EA).
#[test]
fn a_light_belt_by_hand() {
    let drive = SimpleDrive {
        input_radius: 0.1,
        output_radius: 0.1,
        half_contact_angle: FRAC_PI_2,
        longitudinal_stiffness: 1e5,
        mass_per_length: 1e-12,
        friction_coefficient: 1.5,
        half_angle: 0.25f64.atan(),
    };
    let given = Situation::One { input_speed: 100.0, output_torque: 0.0, output_axial_force: 200.0 };
    let state = solve(&drive, given).unwrap();
    assert!((state.slack_tension - 100.0 / PI).abs() < 1e-8, "{}", state.slack_tension);
    assert!((state.belt_speed - 9.996817914027584).abs() < 1e-12, "{}", state.belt_speed);
    assert!((state.input_axial_force - 200.0).abs() < 1e-7);
    // The belt slides on all of both pulleys from F = M/(2 μ* r tan δ_0) on: 0.75 N·m at 10 N.
    let loaded = |axial: f64| Situation::One { input_speed: 100.0, output_torque: 0.75, output_axial_force: axial };
    let state = solve(&drive, loaded(10.001)).unwrap();
    assert!(state.sliding_angle > 3.1 && state.sliding_angle <= PI, "{}", state.sliding_angle);
    let Err(InitError::GrossSlip { pulley, smallest, .. }) = solve(&drive, loaded(9.999)) else { panic!("no slip") };
    assert_eq!(pulley, PulleyId::Output);
    assert!((smallest - 10.0).abs() < 1e-9, "{smallest}");
    // With a shorter contact on the input, that is where it ends.
    let uneven = SimpleDrive { half_contact_angle: 0.6 * PI, ..drive };
    let error = solve(&uneven, loaded(10.01)).unwrap_err();
    let InitError::ShortContact { pulley: PulleyId::Input, sliding, contact } = error else { panic!("{error}") };
    assert!((contact - 0.8 * PI).abs() < 1e-15 && sliding > contact && sliding <= 1.2 * PI, "{sliding}");
}

/// (21) as printed has r_I r_O where (2) asks for r_O².
#[test]
fn printed_21_violates_2_unless_radii_are_equal() {
    let mut random = Random(21);
    for _ in 0..20 {
        let drive = random_drive(&mut random);
        let state = random_state(&drive, &mut random, true);
        let (r_i, r_o, ea) = (drive.input_radius, drive.output_radius, drive.longitudinal_stiffness);
        let output_speed =
            |square: f64| r_i * state.input_speed / r_o - state.belt_speed * state.output_torque / (square * ea);
        let slip = state.input_speed * r_i / r_o - state.output_speed;
        assert!((output_speed(r_o * r_o) - state.output_speed).abs() < 1e-9 * slip);
        let error = (output_speed(r_i * r_o) - state.output_speed).abs() / slip;
        assert!((error - (r_o / r_i - 1.0).abs()).abs() < 1e-6, "{error}");
    }
}

/// (24) as printed: L_O for L_I, and the factor EA on the second term only.
#[test]
fn printed_24_is_neither_force() {
    let mut random = Random(24);
    let drive = random_drive(&mut random);
    let state = random_state(&drive, &mut random, true);
    let (ea, m, v_0) = (drive.longitudinal_stiffness, drive.mass_per_length, state.belt_speed);
    let (strain, lift_off) = (drive.input_radius * state.input_speed / v_0, ea / (ea - m * v_0 * v_0));
    let mended = (strain - lift_off) * ea;
    assert!((mended - (state.tight_force - state.lift_off_force)).abs() < 1e-6 * mended);
    let printed = strain - lift_off * ea;
    for force in [state.tight_force, state.slack_force] {
        assert!((printed - (force - state.lift_off_force)).abs() > 1e3);
    }
}

/// 2.4 allows M_I = r_I (K − L_Iin): there the logarithm of (16) is infinite, and long before that no contact is left.
#[test]
fn the_bound_of_2_4_is_out_of_reach() {
    let mut random = Random(16);
    for _ in 0..20 {
        let drive = random_drive(&mut random);
        let state = random_state(&drive, &mut random, true);
        let bound = drive.input_radius * (state.lift_off_force - state.tight_force);
        assert!(state.input_torque > bound);
        let angle = -(bound / (drive.input_radius * (state.tight_force - state.lift_off_force)) + 1.0).ln();
        assert_eq!(angle, f64::INFINITY);
        // At the true bound the contact that is the shorter slides from end to end.
        let contact = drive.contact_angle(PulleyId::Input).min(drive.contact_angle(PulleyId::Output));
        let excess = 1000.0 * (-drive.friction_coefficient * contact).exp();
        let more = reference(&drive, state.belt_speed, excess, 1.001 * contact, true);
        for situation in situations(&more) {
            let error = solve(&drive, situation).unwrap_err();
            let slips = matches!(error, InitError::GrossSlip { .. } | InitError::ShortContact { .. });
            assert!(slips, "{}: {error}", situation.number());
        }
    }
}

/// Base case, 900 N on the input: with v_0 as without a torque (15) and ω_O from it (21), the slack span is pressed
/// into no groove from 8.33 N·m on; a solution exists all the same.
#[test]
fn the_printed_start_may_be_impossible() {
    let (radius, ea, m, half_angle) = (0.068309, 243.5e3, 0.4375, 12f64.to_radians());
    let drive = SimpleDrive {
        input_radius: radius,
        output_radius: radius,
        half_contact_angle: FRAC_PI_2,
        longitudinal_stiffness: ea,
        mass_per_length: m,
        friction_coefficient: 0.4 / half_angle.sin(),
        half_angle,
    };
    let given = |output_torque| Situation::Five { input_speed: 356.0, output_torque, input_axial_force: 900.0 };
    let start = solve(&drive, given(0.0)).unwrap();
    for (torque, possible) in [(8.0, true), (9.0, false), (18.0, false)] {
        let output_speed = start.output_speed - start.belt_speed * torque / (radius * radius * ea);
        let slack = ea * (radius * output_speed / start.belt_speed - 1.0);
        assert_eq!(slack > start.lift_off_force, possible, "{torque}: {slack}");
        let state = solve(&drive, given(torque)).unwrap();
        assert!(state.slack_force > state.lift_off_force && state.sliding_angle < PI);
    }
}

#[test]
fn nonsense_is_refused() {
    let drive = random_drive(&mut Random(1));
    let given = |input_speed, output_torque, output_axial_force| Situation::One {
        input_speed,
        output_torque,
        output_axial_force,
    };
    for (situation, what) in [
        (given(f64::NAN, 1.0, 100.0), "input_speed"),
        (given(-1.0, 1.0, 100.0), "input_speed"),
        (given(100.0, f64::INFINITY, 100.0), "output_torque"),
        (given(100.0, 1.0, 0.0), "output_axial_force"),
    ] {
        let error = solve(&drive, situation).unwrap_err();
        assert!(matches!(error, InitError::Given { what: found, .. } if found == what), "{error}");
    }
    for drive in [
        SimpleDrive { half_angle: 1.6, ..drive },
        SimpleDrive { half_contact_angle: PI, ..drive },
        SimpleDrive { friction_coefficient: 0.0, ..drive },
        SimpleDrive { mass_per_length: f64::NAN, ..drive },
    ] {
        assert!(matches!(solve(&drive, given(100.0, 1.0, 100.0)), Err(InitError::Given { .. })));
    }
    let error = solve(&drive, given(100.0, 1e9, 100.0)).unwrap_err();
    assert!(matches!(error, InitError::Overloaded { .. } | InitError::GrossSlip { .. }), "{error}");
}

fn sheave(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sheave"))
        .args(arguments)
        .env_remove("RUST_LOG")
        .env("NO_COLOR", "1")
        .output()
        .unwrap()
}

fn object(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {output:?}"))
}

/// The seven situations through the case file's keys: what one says, the others confirm.
#[test]
fn the_command_knows_seven_situations() {
    let run = |settings: &[(&str, f64)]| {
        let mut arguments = vec!["init".to_owned(), "--json".to_owned(), "--set=drive.ratio=1.2".to_owned()];
        arguments.extend(settings.iter().map(|(key, value)| format!("--set=operating_point.{key}={value:e}")));
        let output = sheave(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {output:?}");
        object(&output)
    };
    let first = run(&[("primary_speed", 300.0), ("secondary_torque", 15.0), ("secondary_axial_force", 700.0)]);
    assert_eq!(first["situation"], 1);
    let at = |object: &Value, pulley: &str, key: &str| object[pulley][key].as_f64().unwrap();
    let of = |pulley, key| at(&first, pulley, key);
    let (speed_i, speed_o) = (of("primary", "speed"), of("secondary", "speed"));
    let (torque_i, torque_o) = (of("primary", "torque"), of("secondary", "torque"));
    let (force_i, force_o) = (of("primary", "axial_force"), of("secondary", "axial_force"));
    assert!(torque_i > 0.0 && torque_o == 15.0 && of("primary", "power") > of("secondary", "power"));
    for (situation, settings) in [
        (2, [("secondary_speed", speed_o), ("primary_torque", torque_i), ("primary_axial_force", force_i)]),
        (3, [("primary_speed", speed_i), ("secondary_speed", speed_o), ("secondary_axial_force", force_o)]),
        (4, [("primary_speed", speed_i), ("speed_ratio", speed_o / speed_i), ("primary_axial_force", force_i)]),
        (5, [("primary_speed", speed_i), ("secondary_torque", torque_o), ("primary_axial_force", force_i)]),
        (6, [("primary_speed", speed_i), ("primary_torque", torque_i), ("secondary_axial_force", force_o)]),
        (7, [("primary_speed", speed_i), ("primary_torque", torque_i), ("primary_axial_force", force_i)]),
    ] {
        let other = run(&settings);
        assert_eq!(other["situation"], situation);
        for pulley in ["primary", "secondary"] {
            for key in ["speed", "torque", "axial_force", "sliding_angle"] {
                let (a, b) = (at(&other, pulley, key), of(pulley, key));
                assert!((a / b - 1.0).abs() < 1e-8, "situation {situation}, {pulley}.{key}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_command_says_what_is_wrong() {
    let force = "--set=operating_point.primary_axial_force=900 N";
    for (arguments, status, said) in [
        (vec!["init"], 2, "none of the seven situations"),
        (
            vec![
                "init",
                "--set=operating_point.secondary_speed=3400 rpm",
                "--set=operating_point.secondary_torque=1",
                force,
            ],
            2,
            "seven",
        ),
        (vec!["init", "--set=drive.free=primary_radius", "--unset=drive.primary_radius", force], 2, "drive.free"),
        (vec!["init", "--set=operating_point.primary_axial_force=3 kg"], 2, "wrong dimension"),
        (vec!["init", "--set=operating_point.primary_axial_force=100 N"], 3, "slides on all of the input pulley"),
        (vec!["init", force], 0, ""),
        (vec!["init", force, "--no-load"], 0, ""),
    ] {
        let output = sheave(&arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {output:?}");
        let message = String::from_utf8(output.stderr.clone()).unwrap();
        assert!(message.contains(said), "{arguments:?}: {message}");
        assert_eq!(output.stdout.is_empty(), status != 0);
        let mut json = arguments.clone();
        json.push("--json");
        assert_eq!(object(&sheave(&json))["converged"], status == 0);
    }
    let unloaded = object(&sheave(&["init", "--json", force, "--no-load"]));
    assert_eq!((&unloaded["iterations"], &unloaded["primary"]["torque"]), (&Value::from(0), &Value::from(0.0)));
}

/// A belt that brakes carries more on the span that is slack where it drives: by the torque over the radius.
#[test]
fn the_summary_of_a_belt_that_brakes_calls_the_tighter_span_tight() {
    let set = |key: &str, value: &str| ["--set".to_owned(), format!("operating_point.{key}={value}")];
    let arguments = [set("primary_axial_force", "900 N"), set("primary_torque", "-15 N*m")].concat();
    let arguments: Vec<&str> = std::iter::once("init").chain(arguments.iter().map(String::as_str)).collect();
    let told = String::from_utf8(sheave(&arguments).stdout).unwrap();
    let row = told.lines().find(|line| line.contains("longitudinal force")).unwrap();
    let values: Vec<f64> = row.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    assert!(values[0] - values[1] > 200.0, "{row}");
    assert!(told.contains("the belt brakes: the tight span runs off the primary"), "{told}");
}
