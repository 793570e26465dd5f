//! The belt pulley as a component, by hand and by its power balance; and beside the full model.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use nalgebra::{Matrix4, Vector4};
use serde_json::Value;
use sheave::small::pulley::{BeltPulley, BeltType, Branch, Direction, End, Ports, Pull, PulleyError, Shaft};
use std::f64::consts::PI;
use std::process::{Command, Output};
use std::sync::{Arc, Mutex};

fn flat() -> BeltPulley {
    BeltPulley {
        belt: BeltType::Flat { friction_coefficient: 0.3 },
        direction: Direction::Opposite,
        radius: 0.1,
        wrap_angle: PI,
        mass_per_length: 0.5,
        inertia: 0.02,
        bearing_damping: 0.01,
        velocity_threshold: 1e-2,
        force_threshold: 1e-3,
    }
}

fn pull(end: End, tension: f64) -> Pull {
    Pull { end, tension }
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance, "{what}: {found}, not {expected}");
}

/// 4 m/s and 0.5 kg/m make 8 N of centrifugal tension; e^(0.3 π) = 2.566332395208148.
#[test]
fn sliding_belt_by_hand() {
    let euler = 2.566_332_395_208_148;
    // The belt is 1 m/s faster than the rim: it drags the pulley, B is the tight branch.
    let ports = flat().balance(4.0, 30.0, 5.0, pull(End::B, 108.0)).unwrap();
    assert_near(ports.a.tension, 8.0 + 100.0 / euler, 1e-6, "F_A");
    assert_eq!((ports.a.velocity, ports.b.velocity), (-4.0, 4.0));
    // (F_B − F_A) R − b ω − J dω/dt
    assert_near(ports.s.torque, (100.0 - 100.0 / euler) * 0.1 - 0.3 - 0.1, 1e-6, "T_S");
    let again = flat().balance(4.0, 30.0, 5.0, pull(End::A, ports.a.tension)).unwrap();
    assert_near(again.b.tension, 108.0, 1e-7, "F_B");
    assert_eq!(flat().slack_branches(&ports), []);
    // The rim is 1 m/s faster than the belt: A is the tight branch.
    let ports = flat().balance(4.0, 50.0, 0.0, pull(End::B, 108.0)).unwrap();
    assert_near(ports.a.tension, 8.0 + 100.0 * euler, 1e-5, "F_A");
    assert_near(ports.s.torque, (100.0 - 100.0 * euler) * 0.1 - 0.5, 1e-6, "T_S");
    let again = flat().balance(4.0, 50.0, 0.0, pull(End::A, ports.a.tension)).unwrap();
    assert_near(again.b.tension, 108.0, 1e-7, "F_B");
}

/// f' = 0.3/sin 17° = 1.02609108595 on a groove of 34°; a groove of 180° is flat.
#[test]
fn wedge_and_smoothing_by_hand() {
    let wedge =
        |sheave_angle: f64| BeltPulley { belt: BeltType::V { friction_coefficient: 0.3, sheave_angle }, ..flat() };
    assert_near(wedge(34f64.to_radians()).effective_coefficient(), 1.026_091_085_95, 1e-9, "f'");
    assert_near(wedge(PI).effective_coefficient(), 0.3, 1e-15, "f'");
    // At the threshold friction has reached tanh 4 = 0.999329299739067 of its coefficient, at a quarter of it tanh 1.
    for (share, reached) in [(1.0, 0.999_329_299_739_067), (0.25, 0.761_594_155_955_764_9), (0.0, 0.0)] {
        let pulley = wedge(34f64.to_radians());
        let velocity = 3.0 + share * pulley.velocity_threshold;
        let ports = pulley.balance(velocity, 30.0, 0.0, pull(End::B, 200.0)).unwrap();
        let behaviour = pulley.behaviour(&ports);
        assert_near(behaviour.friction_coefficient, -1.026_091_085_95 * reached, 1e-9, "μ");
        let (excess_a, excess_b) =
            (ports.a.tension - behaviour.centrifugal_tension, ports.b.tension - behaviour.centrifugal_tension);
        assert_near(excess_a / excess_b, (-1.026_091_085_95 * reached * PI).exp(), 1e-8, "ratio");
    }
}

#[test]
fn ends_move_both_ways() {
    let opposite = flat().balance(4.0, 40.0, 0.0, pull(End::A, 50.0)).unwrap();
    let equal =
        BeltPulley { direction: Direction::Equal, ..flat() }.balance(4.0, 40.0, 0.0, pull(End::A, 50.0)).unwrap();
    assert_eq!((opposite.a.velocity, equal.a.velocity), (-4.0, 4.0));
    assert_eq!((opposite.b, opposite.s), (equal.b, equal.s));
    // Backwards, the same happens with the branches exchanged.
    let forward = flat().balance(4.0, 30.0, 0.0, pull(End::B, 108.0)).unwrap();
    let backward = flat().balance(-4.0, -30.0, 0.0, pull(End::A, 108.0)).unwrap();
    assert_near(backward.b.tension, forward.a.tension, 1e-6, "F");
    assert_near(backward.s.torque, -forward.s.torque, 1e-7, "T_S");
}

#[test]
fn an_ideal_belt_does_not_slip() {
    let pulley = BeltPulley { belt: BeltType::Ideal, ..flat() };
    assert_eq!(pulley.balance(4.0, 40.0, 0.0, pull(End::A, 50.0)), Err(PulleyError::Ideal));
    let ports = Ports {
        a: Branch { velocity: -4.0, tension: 500.0 },
        b: Branch { velocity: 4.0, tension: 20.0 },
        s: Shaft { speed: 40.0, acceleration: 0.0, torque: -48.4 },
    };
    let residuals = pulley.residuals(&ports);
    assert!(residuals.iter().all(|residual| residual.abs() < 1e-12), "{residuals:?}");
    let behaviour = pulley.behaviour(&ports);
    assert_eq!((behaviour.friction_loss, behaviour.friction_coefficient), (0.0, 0.0));
    assert_near(behaviour.belt_power, behaviour.shaft_power + behaviour.bearing_loss, 1e-9, "power");
}

/// Any motion, either direction, taut or slack: the component is passive and its books balance.
#[test]
fn friction_never_delivers_power() {
    let mut largest = 0.0f64;
    for index in 0..4000u32 {
        // A lattice that fills the ranges evenly.
        let at = |step: f64, low: f64, high: f64| low + (high - low) * (f64::from(index) * step).fract();
        let (velocity, tension) = (at(0.754_877_666, -5.0, 5.0), at(0.569_840_291, -20.0, 300.0));
        let speed = velocity / 0.1 + at(0.618_033_989, -0.5, 0.5);
        let acceleration = at(0.819_172_513, -50.0, 50.0);
        let end = if index % 2 == 0 { End::A } else { End::B };
        let pulley = BeltPulley { force_threshold: 1.0, ..flat() };
        let ports = pulley.balance(velocity, speed, acceleration, pull(end, tension)).unwrap();
        let residuals = pulley.residuals(&ports);
        assert!(residuals.iter().all(|residual| residual.abs() < 1e-9), "{residuals:?} {ports:?}");
        let behaviour = pulley.behaviour(&ports);
        assert!(behaviour.friction_loss >= 0.0, "{behaviour:?}");
        let spent = behaviour.shaft_power + behaviour.friction_loss + behaviour.bearing_loss + behaviour.kinetic_power;
        assert_near(behaviour.belt_power, spent, 1e-9 * behaviour.belt_power.abs().max(10.0), "power");
        largest = largest.max(behaviour.friction_loss);
    }
    assert!(largest > 1.0);
}

/// As the source prints it, V_rel = V_A − ω R with V_A = −V_B: then friction pulls the belt the way it slides. And the
/// printed torque (F_A + F_B) R … is there without friction.
#[test]
fn printed_signs_deliver_power() {
    let pulley = flat();
    let ports = pulley.balance(4.0, 30.0, 0.0, pull(End::B, 108.0)).unwrap();
    // The belt slides forward at 1 m/s; the printed V_rel is −7 m/s, so that A is the tight branch and not B.
    let (slip, printed) = (4.0 - 30.0 * 0.1, ports.a.velocity - 30.0 * 0.1);
    assert_eq!((slip, printed), (1.0, -7.0));
    let printed_tension = 8.0 + 100.0 * (0.3 * PI).exp();
    assert_near((108.0 - printed_tension) * slip, -156.633_239_5, 1e-6, "the printed law's friction loss");
    assert_near(pulley.behaviour(&ports).friction_loss, 100.0 - 100.0 * (-0.3 * PI).exp(), 1e-6, "friction loss");
    let smooth = BeltPulley { belt: BeltType::Flat { friction_coefficient: 0.0 }, bearing_damping: 0.0, ..pulley };
    let ports = smooth.balance(4.0, 30.0, 0.0, pull(End::B, 108.0)).unwrap();
    let printed = (ports.a.tension + ports.b.tension) * 0.1;
    assert!(ports.s.torque.abs() < 1e-12 && printed > 20.0);
}

#[test]
fn derivatives_are_those_of_the_residuals() {
    for pulley in [
        flat(),
        BeltPulley {
            direction: Direction::Equal,
            belt: BeltType::V { friction_coefficient: 0.4, sheave_angle: 0.5 },
            ..flat()
        },
        BeltPulley { belt: BeltType::Ideal, ..flat() },
    ] {
        let at = [-3.99, 120.0, 4.0, 90.0, 39.98, 2.0, 1.5];
        let ports = |v: [f64; 7]| Ports {
            a: Branch { velocity: v[0], tension: v[1] },
            b: Branch { velocity: v[2], tension: v[3] },
            s: Shaft { speed: v[4], acceleration: v[5], torque: v[6] },
        };
        let jacobian = pulley.jacobian(&ports(at));
        for column in 0..7 {
            let step = 1e-5;
            let moved = |by: f64| {
                let mut values = at;
                values[column] += by;
                pulley.residuals(&ports(values))
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..3 {
                let difference = (up[row] - down[row]) / (2.0 * step);
                assert_near(
                    jacobian[row][column],
                    difference,
                    1e-4 * difference.abs().max(1.0),
                    &format!("{row} {column}"),
                );
            }
        }
    }
}

/// Two pulleys joined at their ports: the tight span leads from B of the driven one to A of the driving one, the slack
/// span back. Newton's method with the components' derivatives finds belt speed, tight tension, output speed and input
/// torque.
#[test]
fn two_components_make_a_drive() {
    let driving =
        BeltPulley { belt: BeltType::V { friction_coefficient: 0.3, sheave_angle: 0.6 }, inertia: 0.0, ..flat() };
    let driven = BeltPulley { radius: 0.15, ..driving };
    let (input_speed, slack, load) = (50.0, 120.0, 30.0);
    let joined = |x: &Vector4<f64>| {
        let at = |pulley: &BeltPulley, arriving: f64, leaving: f64, speed: f64, torque: f64| {
            let ports = Ports {
                a: Branch { velocity: -x[0], tension: arriving },
                b: Branch { velocity: x[0], tension: leaving },
                s: Shaft { speed, acceleration: 0.0, torque },
            };
            (pulley.residuals(&ports), pulley.jacobian(&ports), pulley.behaviour(&ports))
        };
        (at(&driving, x[1], slack, input_speed, x[3]), at(&driven, slack, x[1], x[2], load))
    };
    let mut x = Vector4::new(5.0, 320.0, 33.3, -20.0);
    for _ in 0..50 {
        let ((f, df, _), (g, dg, _)) = joined(&x);
        let residual = Vector4::new(f[1], f[2], g[1], g[2]);
        // Columns: V_A, F_A, V_B, F_B, ω, dω/dt, T_S; V_A = −V_B.
        let first = |row: usize| [df[row][2] - df[row][0], df[row][1], 0.0, df[row][6]];
        let second = |row: usize| [dg[row][2] - dg[row][0], dg[row][3], dg[row][4], 0.0];
        let rows = [first(1), first(2), second(1), second(2)];
        let jacobian = Matrix4::from_fn(|row, column| rows[row][column]);
        // The smooth friction law is steep: speeds move by its width at most.
        let step = jacobian.lu().solve(&residual).unwrap();
        let limit = (0.5 * driving.velocity_threshold / step[0].abs().max(step[2].abs() * 0.15)).min(1.0);
        x -= limit * step;
    }
    let ((f, _, first), (g, _, second)) = joined(&x);
    assert!(f.iter().chain(&g).all(|residual| residual.abs() < 1e-9), "{f:?} {g:?}");
    // (t − s) R − b ω = load on the driven pulley; both creep.
    let tight = slack + (load + driven.bearing_damping * x[2]) / driven.radius;
    assert_near(x[1], tight, 1e-8, "tight tension");
    assert!(first.relative_velocity < 0.0 && second.relative_velocity > 0.0);
    assert!(x[2] < input_speed * driving.radius / driven.radius);
    // What goes in comes out, or is lost to creep and bearings.
    let losses = first.friction_loss + second.friction_loss + first.bearing_loss + second.bearing_loss;
    assert_near(-x[3] * input_speed, load * x[2] + losses, 1e-7, "power");
}

/// What a subscriber writes.
#[derive(Clone, Default)]
struct Log(Arc<Mutex<Vec<u8>>>);

impl std::io::Write for Log {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap().extend_from_slice(bytes);
        Ok(bytes.len())
    }
    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_lost_tension_is_told() {
    let log = Log::default();
    let writer = log.clone();
    let subscriber = tracing_subscriber::fmt().with_writer(move || writer.clone()).with_ansi(false).finish();
    let said = || String::from_utf8(std::mem::take(&mut *log.0.lock().unwrap())).unwrap();
    tracing::subscriber::with_default(subscriber, || {
        let ports = flat().balance(4.0, 30.0, 0.0, pull(End::B, 108.0)).unwrap();
        assert!(flat().slack_branches(&ports).is_empty() && said().is_empty());
        // 5 N is less than the 8 N that centrifugal force takes: the belt lifts off, and friction is gone.
        let ports = flat().balance(4.0, 30.0, 0.0, pull(End::B, 5.0)).unwrap();
        assert_eq!(flat().slack_branches(&ports), [End::A, End::B]);
        assert_near(ports.a.tension, 5.0, 1e-6, "F_A");
        let warning = said();
        assert!(warning.contains("WARN") && warning.contains("branch A") && warning.contains("branch B"), "{warning}");
    });
}

#[test]
fn nonsense_is_refused() {
    for (pulley, what) in [
        (BeltPulley { radius: 0.0, ..flat() }, "radius"),
        (BeltPulley { wrap_angle: f64::NAN, ..flat() }, "wrap_angle"),
        (BeltPulley { velocity_threshold: 0.0, ..flat() }, "velocity_threshold"),
        (BeltPulley { belt: BeltType::Flat { friction_coefficient: -0.1 }, ..flat() }, "friction_coefficient"),
        (BeltPulley { belt: BeltType::V { friction_coefficient: 0.3, sheave_angle: 4.0 }, ..flat() }, "sheave_angle"),
    ] {
        let error = pulley.balance(1.0, 10.0, 0.0, pull(End::A, 100.0)).unwrap_err();
        assert!(matches!(error, PulleyError::Parameter { what: found, .. } if found == what), "{error}");
    }
    let error = flat().balance(f64::INFINITY, 10.0, 0.0, pull(End::A, 100.0)).unwrap_err();
    assert!(error.to_string().contains("velocity"));
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

#[test]
fn the_command_sets_euler_beside_the_full_model() {
    let case = ["--tol=1e-4", "--json", "--set=drive.ratio=1.2", "--edition=thesis"];
    let full = object(&sheave(&[&["solve"], &case[..]].concat()));
    let all = object(&sheave(&[&["pulley"], &case[..]].concat()));
    assert_eq!((&all["converged"], &all["belt"], &all["edition"]), (&true.into(), &"v".into(), &"thesis".into()));
    for (pulley, [tight, slack]) in
        [("primary", ["entry_tension", "exit_tension"]), ("secondary", ["exit_tension", "entry_tension"])]
    {
        let of = |key: &str| all[pulley][key].as_f64().unwrap();
        let full = |key: &str| full[pulley][key].as_f64().unwrap();
        let ratio = full(tight) / full(slack);
        assert_near(of("tension_ratio"), ratio, 1e-9 * ratio, "ratio");
        let friction = 0.4 / 12f64.to_radians().sin();
        let largest = (friction * full("wrap_angle")).exp();
        assert_near(of("largest_ratio"), largest, 1e-9 * largest, "largest ratio");
        let share = ratio.ln() / (friction * full("wrap_angle"));
        assert_near(of("share"), share, 1e-12, "share");
        assert_near(of("sliding_speed"), 1e-4 / 4.0 * share.atanh(), 1e-15, "sliding speed");
        let radius = all["inputs"]["drive"][format!("{pulley}_radius")].as_f64().unwrap();
        assert_near(of("torque"), (full(tight) - full(slack)) * radius, 1e-9, "torque");
        // The nominal radius and no shear: near the full model's torque, not equal to it.
        assert!((of("torque") / full("torque") - 1.0).abs() < 0.1, "{} {}", of("torque"), full("torque"));
        assert_near(of("friction_loss"), (full(tight) - full(slack)) * of("sliding_speed"), 1e-9, "loss");
    }
    // A radius that is solved for is the solution's: the torques stay near each other.
    let closed = ["pulley", "--tol=1e-4", "--json", "--set=drive.free=secondary_radius", "--edition=thesis"];
    let closed = object(&sheave(&closed));
    let of = |key: &str| closed["secondary"][key].as_f64().unwrap();
    assert!((of("torque") / of("full_torque") - 1.0).abs() < 0.1, "{closed}");
    let string =
        object(&sheave(&["pulley", "--tol=1e-4", "--json", "--edition=string", "--set=sheave.slip_threshold=2e-2"]));
    assert_eq!(string["converged"], true);
    let ideal = object(&sheave(&[&["pulley", "--belt=ideal"], &case[..]].concat()));
    assert!(ideal["primary"]["largest_ratio"].is_null() && ideal["primary"]["share"] == 0.0);
}

#[test]
fn the_command_prints_a_table_and_refuses_nonsense() {
    let output = sheave(&["pulley", "--tol=1e-3", "--belt=flat", "--edition=thesis"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("Belt pulley, flat belt") && text.contains("tension ratio, full model"), "{text}");
    for (arguments, status) in [
        (vec!["pulley", "--belt=round"], 2),
        (vec!["pulley", "--set=belt.length=3 kg", "--json"], 2),
        (vec!["pulley", "--set=operating_point.slack_tension=1 N", "--edition=thesis", "--tol=1e-3", "--json"], 3),
    ] {
        let output = sheave(&arguments);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {output:?}");
        if arguments.contains(&"--json") {
            assert_eq!(object(&output)["converged"], false);
        }
    }
}
