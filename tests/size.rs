//! Sizing by hand, by kinetic energy, and from files; and `sheave size`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use sheave::small::size::{BeltDrive, IDLER, Idler, SizeProblem, TABLE, size};
use std::process::{Command, Output};

const FILE: &str = r#"
[belt]
mass = "400 g"
[linear]
mass = "49.6 kg"
force = "120 N"
friction_force = 20
[input]
diameter = "100 mm"
inertia = "20 kg*cm^2"
[output]
diameter = "250 mm"
inertia = "0.02 kg*m^2"
load_inertia = "0.5 kg*m^2"
load_torque = "40 N*m"
[motion]
acceleration = "30 rad/s^2"
[[idler]]
inertia = "3e-4 kg*m^2"
diameter = "60 mm"
"#;

fn assert_near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{what}: {found}, not {expected}");
}

#[test]
fn a_drive_by_hand() {
    let drive = BeltDrive::from_toml("drive.toml", FILE).unwrap();
    assert_eq!((drive.belt_mass, drive.input_inertia, drive.acceleration), (0.4, 2e-3, 30.0));
    assert_eq!(drive.idlers, [Idler { inertia: 3e-4, diameter: 0.06 }]);
    let sizing = size(&drive).unwrap();
    assert_near(sizing.ratio, 2.5, "n (3.25)");
    assert_near(sizing.inertia.load, 0.125, "50 · 0.1²/4 (3.22)");
    assert_near(sizing.inertia.idlers, 3e-4 / 0.36, "3e-4 · (100/60)²");
    assert_near(sizing.inertia.rotating, 2e-3 + 3e-4 / 0.36 + 0.52 / 6.25, "I_p");
    assert_near(sizing.inertia.total, 0.125 + 2e-3 + 3e-4 / 0.36 + 0.0832, "I_tot (3.27)");
    assert_near(sizing.torque.external, 6.0, "0.1 · 120/2 (3.23)");
    assert_near(sizing.torque.friction, 1.0, "0.1 · 20/2 (3.24)");
    assert_near(sizing.torque.load, 16.0, "40/2.5 (3.26)");
    assert_near(sizing.torque.steady, 23.0, "sum");
    assert_near(sizing.torque.acceleration, 30.0 * sizing.inertia.total, "I α");
    assert_near(sizing.torque.drive, 23.0 + 6.331, "all");
}

/// ½ I ω² is the sum of all that moves, whatever the diameters; (3.21) as printed is not.
#[test]
fn inertia_is_kinetic_energy() {
    let mut drive = BeltDrive {
        belt_mass: 1.3,
        linear_mass: 7.0,
        input_inertia: 0.03,
        output_diameter: 0.31,
        output_inertia: 0.11,
        load_inertia: 0.7,
        ..BeltDrive::new(0.17)
    };
    drive.idlers = vec![Idler { inertia: 0.004, diameter: 0.05 }, Idler { inertia: 0.01, diameter: 0.4 }];
    let omega = 12.0;
    let v = omega * 0.17 / 2.0;
    let turning = |inertia: f64, diameter: f64| inertia * (2.0 * v / diameter).powi(2) / 2.0;
    let energy =
        8.3 * v * v / 2.0 + turning(0.03, 0.17) + turning(0.81, 0.31) + turning(0.004, 0.05) + turning(0.01, 0.4);
    let sizing = size(&drive).unwrap();
    assert_near(sizing.inertia.total * omega * omega / 2.0, energy, "energy");
    let printed = 0.03 + 0.11 + 0.7 + 0.004 + 0.01 + sizing.inertia.load;
    assert!((printed / sizing.inertia.total - 1.0).abs() > 0.5, "{printed}");
    // Power in is power out.
    let loaded = BeltDrive { force: 100.0, friction_force: 10.0, load_torque: 5.0, ..drive };
    let torque = size(&loaded).unwrap().torque;
    assert_near(torque.steady * omega, 110.0 * v + 5.0 * 2.0 * v / 0.31, "power");
}

#[test]
fn one_size_of_pulleys_is_3_21_as_printed() {
    let drive = BeltDrive {
        linear_mass: 20.0,
        input_inertia: 0.01,
        output_inertia: 0.02,
        idlers: vec![Idler { inertia: 0.003, diameter: 0.2 }],
        ..BeltDrive::new(0.2)
    };
    let sizing = size(&drive).unwrap();
    assert_near(sizing.inertia.total, 0.01 + 0.02 + 0.003 + 20.0 * 0.04 / 4.0, "I_tot");
    assert_eq!(sizing.ratio, 1.0);
    assert_eq!(sizing.torque.drive, 0.0);
}

#[test]
fn what_is_wrong_is_said() {
    for (text, said, at) in [
        ("[input]\ndiameter = 3 kg", "not valid TOML", "3 kg"),
        (
            "[input]\ndiameter = \"3 kg\"",
            "`input.diameter` = \"3 kg\": its unit is that of a mass, not of a length",
            "3 kg",
        ),
        ("[input]\ndiameter = \"0 mm\"", "out of range: expected a length above 0 mm", "0 mm"),
        (
            "[input]\ndiamter = 1",
            "unknown key `input.diamter`: expected one of input.diameter, input.inertia",
            "diamter",
        ),
        ("[motor]\npower = 1", "unknown key `motor.power`: expected one of belt.mass", "power"),
        ("input = 3", "`input` is an integer: expected a table of keys", "3"),
        ("idler = [3]", "`idler` is an array: expected a table of keys", "[3]"),
        ("[input]\ninertia = true", "`input.inertia` is a boolean: expected a moment of inertia", "true"),
        ("[input]\ninertia = nan", "not a finite number", "nan"),
        ("[linear]\nmass = \"-1 kg\"", "out of range", "-1 kg"),
        ("[[idler]]\ninertia = 1", "`idler.diameter` is not given", ""),
        ("[belt]\nmass = 1", "`input.diameter` is not given: expected a length above 0 mm, such as \"100 mm\"", ""),
    ] {
        let error = BeltDrive::from_toml("drive.toml", text).unwrap_err();
        assert!(error.to_string().contains(said), "{text}: {error}");
        let given = error.place().map_or("", |place| place.given());
        assert!(given.contains(at), "{text}: {given}");
    }
    let error = BeltDrive::read(None, &["linear.mass".into()], &[]).unwrap_err();
    assert!(matches!(error.problem(), SizeProblem::Assignment { .. }));
    // Keys of an idler exist, in files and as a whole.
    let error = BeltDrive::read(None, &["idler.diameter=3 mm".into()], &[]).unwrap_err();
    assert!(matches!(error.problem(), SizeProblem::IdlerKey { .. }), "{error}");
    assert!(error.to_string().contains("--idler"), "{error}");
    let error = BeltDrive::read(None, &["input.diameter=1 m".into()], &["1".into()]).unwrap_err();
    assert!(matches!(error.problem(), SizeProblem::IdlerText { .. }));
    let error = BeltDrive::read(None, &["input.diameter=1 m".into()], &["1,-2 mm".into()]).unwrap_err();
    assert!(error.to_string().contains("`idler.diameter` = -2 mm is out of range"), "{error}");
    let error = size(&BeltDrive { input_inertia: f64::NAN, ..BeltDrive::new(0.1) }).unwrap_err();
    assert!(error.to_string().contains("input.inertia"), "{error}");
    let error = size(&BeltDrive::new(-0.1)).unwrap_err();
    assert!(error.to_string().contains("input.diameter"), "{error}");
}

#[test]
fn every_key_can_be_written_as_its_example() {
    for entry in &TABLE {
        let settings = [
            "input.diameter=\"1 m\"".to_owned(),
            format!("{}=\"{} {}\"", entry.path, entry.example, entry.unit.symbol),
        ];
        BeltDrive::read(None, &settings, &[]).unwrap_or_else(|error| panic!("{}: {error}", entry.path));
    }
    let [inertia, diameter] = IDLER.each_ref().map(|entry| format!("{} {}", entry.example, entry.unit.symbol));
    let drive = BeltDrive::read(None, &["input.diameter=1".into()], &[format!("{inertia}, {diameter}")]).unwrap();
    assert_eq!(drive.idlers, [Idler { inertia: 3e-4, diameter: 0.06 }]);
}

fn sheave(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sheave"))
        .args(arguments)
        .env_remove("RUST_LOG")
        .env("NO_COLOR", "1")
        .output()
        .unwrap()
}

#[test]
fn the_command_reads_a_file_and_changes_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("drive.toml");
    std::fs::write(&path, FILE).unwrap();
    let file = path.to_str().unwrap();
    let output = sheave(&["size", file, "--json", "--set=linear.force=0 N", "--idler", "3e-4 kg*m^2, 60 mm"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let object: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(object["inputs"]["linear"]["force"], 0.0);
    assert_eq!(object["inputs"]["idler"].as_array().unwrap().len(), 2);
    assert_near(object["torque"]["steady"].as_f64().unwrap(), 17.0, "steady");
    assert_near(object["inertia"]["idlers"].as_f64().unwrap(), 6e-4 / 0.36, "idlers");
    // What it prints as inputs can be read again.
    let again: String = object["inputs"]
        .as_object()
        .unwrap()
        .iter()
        .filter(|(section, _)| *section != "idler")
        .map(|(section, keys)| {
            format!("[{section}]\n")
                + &keys.as_object().unwrap().iter().map(|(key, value)| format!("{key} = {value}\n")).collect::<String>()
        })
        .collect();
    let drive = BeltDrive::from_toml("again", &again).unwrap();
    assert_eq!(drive.load_torque, 40.0);
    let text = String::from_utf8(sheave(&["size", file]).stdout).unwrap();
    assert!(text.contains("ratio 2.5000") && text.contains("29.331000  N·m"), "{text}");
}

#[test]
fn the_command_refuses_with_status_2() {
    for arguments in [vec!["size"], vec!["size", "no-such.toml"], vec!["size", "--set=input.diameter=3 kg"]] {
        let output = sheave(&arguments);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{output:?}");
        let json = sheave(&[&arguments[..], &["--json"]].concat());
        let object: Value = serde_json::from_slice(&json.stdout).unwrap();
        assert!(object["failure"]["kind"] == "input" && json.status.code() == Some(2));
    }
    let message = String::from_utf8(sheave(&["size", "--set=input.diameter=3 kg"]).stderr).unwrap();
    assert!(message.contains("--set:1:16") && message.contains("here"), "{message}");
    let help = String::from_utf8(sheave(&["size", "--help"]).stdout).unwrap();
    assert!(TABLE.iter().all(|entry| help.contains(entry.path)), "{help}");
}

#[test]
fn the_example_is_sound() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/size/conveyor.toml");
    let sizing = size(&BeltDrive::read(Some(&path), &[], &[]).unwrap()).unwrap();
    assert!(sizing.torque.drive > 0.0);
}
