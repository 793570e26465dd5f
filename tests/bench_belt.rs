//! Belt properties from bench tests: every number of the thesis's sections 4.1 to 4.6 from its raw inputs, a second
//! belt, and every mistake with its words; `sheave belt` and `sheave radii` as they are called.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use sheave::bench::belt::{Description, Properties};
use sheave::bench::radii::{Geometry, Limits};
use sheave::bench::{BenchError, temperature};
use sheave::case::Case;
use std::path::Path;
use std::process::{Command, Output};

const CVTECH: &str = include_str!("../examples/belts/cvtech.toml");

fn example(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/belts").join(name)
}

fn thesis(celsius: f64) -> Properties {
    let description = Description::parse("cvtech.toml", CVTECH).unwrap();
    description.evaluate(Some(celsius + 273.15)).unwrap()
}

/// What a key of `belt_properties` is called here, in the unit of the published number.
fn found(key: &str) -> f64 {
    let (warm, cool) = (thesis(60.0), thesis(25.0));
    let section = warm.section.unwrap();
    match key {
        "storage modulus at 25 C" => 1e-6 * cool.rubber.unwrap().storage_modulus.unwrap(),
        "storage modulus at 60 C" => 1e-6 * warm.rubber.unwrap().storage_modulus.unwrap(),
        "Young's modulus at 25 C" => 1e-6 * cool.rubber.unwrap().youngs_modulus,
        "Young's modulus at 60 C" => 1e-6 * warm.rubber.unwrap().youngs_modulus,
        "EA of 27 yarns" => 1e-3 * warm.yarns.unwrap().all,
        "EA of the rubber at 60 C" => 1e-3 * warm.tension.stiffness,
        "EA in all" => 1e-3 * warm.belt.longitudinal_stiffness,
        "I about the neutral axis" => warm.bending.second_moment.unwrap(),
        "equivalent height" => 1e3 * section.height,
        "neutral axis above the yarns" => 1e3 * section.above_cords,
        "area" => section.area,
        "I about the yarns" => section.about_cords,
        "EI at 60 C" => warm.belt.bending_stiffness,
        "k at 25 C" => 1e-6 * cool.belt.radial_stiffness,
        "k at 60 C" => 1e-6 * warm.belt.radial_stiffness,
        "pitch length" => 1e3 * warm.belt.length,
        "mass per length" => warm.belt.mass_per_length,
        other => panic!("nothing is computed for `{other}`"),
    }
}

#[test]
fn every_published_number_from_the_raw_inputs() {
    let published: Value = serde_json::from_str(include_str!("../data/published.json")).unwrap();
    let rows = published["belt_properties"].as_array().unwrap();
    assert_eq!(rows.len(), 17);
    for row in rows {
        let (key, value) = (row["key"].as_str().unwrap(), row["value"].as_f64().unwrap());
        // Half a unit of the last digit printed where no tolerance is stated.
        let tolerance = row["tol"].as_f64().unwrap_or(if value > 100.0 { 0.05 } else { 0.005 });
        let computed = found(key);
        println!("{key:<34} {computed:<14.8e} {value:<12} off by {:+.1e}, tolerance {tolerance:e}", computed - value);
        assert!((computed - value).abs() <= tolerance * (1.0 + 1e-12), "{key}: {computed}, published {value}");
    }
}

#[test]
fn the_case_file_is_read_by_a_case() {
    let properties = thesis(60.0);
    let case = Case::from_toml("belt.toml", &properties.case_file()).unwrap().resolve().unwrap();
    let (read, belt) = (case.belt, properties.belt);
    for (read, computed) in [
        (read.length, belt.length),
        (read.mass_per_length, belt.mass_per_length),
        (read.longitudinal_stiffness, belt.longitudinal_stiffness),
        (read.bending_stiffness, belt.bending_stiffness),
        (read.radial_stiffness, belt.radial_stiffness),
    ] {
        assert!((read / computed - 1.0).abs() < 1e-6, "{read} {computed}");
    }
}

#[test]
fn a_second_belt_from_a_lumped_model() {
    let properties = Description::read(&example("g-force.toml")).unwrap().evaluate(None).unwrap();
    let belt = properties.belt;
    let near = |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    near(belt.longitudinal_stiffness, 54.69e6 * 0.0173);
    near(belt.bending_stiffness, 10.4215 * 0.0173);
    near(belt.radial_stiffness, 4.0 * 604_520.0 / 0.0173 * 15f64.to_radians().tan());
    near(belt.mass_per_length, 1.0 / 0.8636);
    assert!(properties.section.is_none() && properties.rubber.is_none() && properties.figures().is_empty());
    Case::from_toml("belt.toml", &properties.case_file()).unwrap().resolve().unwrap();
}

#[test]
fn temperature_moves_what_rubber_carries_and_nothing_else() {
    let [cool, between, warm] = [25.0, 40.0, 60.0].map(thesis);
    assert_eq!(cool.yarns, warm.yarns);
    assert_eq!(cool.length, warm.length);
    // The section is one of geometry: the moment was found at 60 °C whatever the belt's temperature.
    assert_eq!(cool.section, warm.section);
    let ratio = cool.rubber.unwrap().youngs_modulus / warm.rubber.unwrap().youngs_modulus;
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
    near(cool.belt.bending_stiffness / warm.belt.bending_stiffness, ratio);
    near(cool.belt.radial_stiffness / warm.belt.radial_stiffness, ratio);
    near(cool.tension.stiffness / warm.tension.stiffness, ratio);
    // Geometric mean at the share of the way.
    near(between.rubber.unwrap().youngs_modulus, 140.13e6 * (90.45f64 / 140.13).powf(15.0 / 35.0));
    assert_eq!(temperature("77 °F").unwrap(), 298.15);
    assert!(temperature("60").unwrap_err().contains("60 degC"));
}

#[test]
fn raw_data_of_a_testing_machine_are_fitted() {
    let folder = tempfile::tempdir().unwrap();
    let mut csv = "extension (mm),load (N)\n".to_owned();
    for at in 0..600 {
        let x = f64::from(at) * 0.001;
        // A toe in front, and a wave around the line.
        let load = if x < 0.05 { 400.0 * x } else { 1747.0 * x - 67.0 + 4.0 * (40.0 * x).sin() };
        csv += &format!("{x},{load}\n");
    }
    csv += "broken,row\n,\n0.3\n";
    std::fs::write(folder.path().join("lateral.csv"), csv).unwrap();
    let text = CVTECH.replace("slope = \"1747 N/mm\"", "csv = \"lateral.csv\"\nfrom = \"50 N\"\nto = \"1000 N\"");
    let file = folder.path().join("belt.toml");
    std::fs::write(&file, text).unwrap();
    let properties = Description::read(&file).unwrap().evaluate(None).unwrap();
    let line = properties.lateral.line.unwrap();
    assert!((1e-3 * line.slope - 1747.0).abs() < 5.0 && line.r_squared > 0.999, "{line:?}");
    assert!(properties.warnings.iter().any(|warning| warning.contains("3 rows")), "{:?}", properties.warnings);
}

#[test]
fn amplitudes_and_phase_are_moduli() {
    let phase = (1.0f64 / 8.2).atan();
    let modulus = 30.15e6 / phase.cos();
    let amplitudes = format!("stress_amplitude = {}\nstrain_amplitude = 0.01\nphase = {phase}", 0.01 * modulus);
    let text = CVTECH.replace("storage_modulus = \"30.15 MPa\"\nstorage_over_loss = 8.2", &amplitudes);
    let properties = Description::parse("belt.toml", &text).unwrap().evaluate(None).unwrap();
    assert!((properties.belt.bending_stiffness / thesis(60.0).belt.bending_stiffness - 1.0).abs() < 1e-12);
    assert!((properties.rubber.unwrap().storage_over_loss.unwrap() - 8.2).abs() < 1e-9);
}

fn refused(from: &str, to: &str) -> String {
    assert!(CVTECH.contains(from), "{from}");
    let read = Description::parse("belt.toml", &CVTECH.replacen(from, to, 1));
    match read.and_then(|description| description.evaluate(None)) {
        Ok(_) => panic!("{to} was taken"),
        Err(error) => said(&error),
    }
}

fn said(error: &BenchError) -> String {
    format!("{error}\n{}", error.advice().unwrap_or_default())
}

#[test]
fn mistakes_are_named() {
    for (from, to, words) in [
        ("force = \"100 N\"", "force = \"100 mm\"", "`tension.force` = \"100 mm\": its unit is that of a length"),
        ("force = \"100 N\"", "", "`tension.force` is not given: expected a force"),
        ("force = \"100 N\"", "forces = 1", "unknown key `tension.forces`"),
        ("count = 27", "count = 27.5", "whole number"),
        ("count = 27", "count = 0", "out of range"),
        ("\"555 g/den\"", "\"555 kg\"", "its unit is that of a mass"),
        ("\"555 g/den\"", "\"49 N/tex\"", "gravity has no use"),
        ("moment = \"0.05 N*m\"", "moment = \"50 N*m\"", "check the units of moment"),
        ("temperature = \"60 degC\"", "temperature = \"90 degC\"", "lies outside"),
        ("temperature = \"60 degC\"", "temperature = 60", "did you mean `60 degC`"),
        ("poisson_ratio = 0.5", "poisson_ratio = 0.6", "out of range"),
        (
            "storage_modulus = \"46.71 MPa\"",
            "storage_modulus = \"46.71 MPa\"\nyoungs_modulus = 1e8",
            "one of these only",
        ),
        ("outside_circumference = \"875.1 mm\"", "outside_circumference = \"8 mm\"", "deeper"),
        ("mass = \"375 g\"", "mass = \"375 kg\"", "out of range"),
        ("[length]", "[[length]]\n[lengths]", "unknown key `lengths`"),
        ("slope = \"1747 N/mm\"", "csv = \"nowhere.csv\"", "cannot read `nowhere.csv`"),
        ("[yarns]", "[yarns", "not valid TOML"),
        ("force = \"100 N\"", "force = \"100 N\"\ncsv = \"t.csv\"", "`tension.force`: a table of the same test"),
        ("force = \"100 N\"", "stiffness = \"150 N/mm\"", "`tension.elongation`: the stiffness of the same test"),
        (
            "storage_over_loss = 8.2",
            "storage_over_loss = 8.2\nloss_modulus = \"3 MPa\"",
            "loss_modulus`: the ratio of both moduli is given, too",
        ),
        (
            "slope = \"1747 N/mm\"",
            "csv = \"nowhere.csv\"\nfrom = \"900 N\"\nto = \"100 N\"",
            "`lateral.from`: the smallest load, 900 N, is not below the largest",
        ),
        ("slope = \"1747 N/mm\"", "slope = \"1747 N/mm\"\nto = \"1 kN\"", "`lateral.to`: it chooses rows of a table"),
    ] {
        let text = refused(from, to);
        assert!(text.contains(words), "{to}: {text}");
    }
    let error = Description::parse("b.toml", "yarns = 3").unwrap_err();
    assert!(said(&error).contains("`yarns` is an integer: expected a table of keys"), "{error}");
    let lumped = std::fs::read_to_string(example("g-force.toml")).unwrap();
    let error = Description::parse("b.toml", &lumped).unwrap().evaluate(Some(300.0)).unwrap_err();
    assert!(said(&error).contains("nothing says how"), "{error}");
}

#[test]
fn a_name_stays_within_its_comment() {
    let text = CVTECH.replacen("name = \"CVTech belt\"", "name = \"A\\nfoo = 1\\r\\u001b\"", 1);
    let file = Description::parse("belt.toml", &text).unwrap().evaluate(None).unwrap().case_file();
    assert!(file.starts_with("# A\\nfoo = 1\\u{d}\\u{1b} at 60.0 °C\n#\n"), "{file}");
    Case::from_toml("belt.toml", &file).unwrap();
}

#[test]
fn radii_both_ways_and_travel() {
    let drive = Geometry { pitch_length: 0.8572, center_distance: 0.214, half_angle: 12f64.to_radians() };
    let limits = Limits { primary: (0.045, 0.09), secondary: (0.04, 0.085) };
    let range = drive.shift_range(&limits).unwrap();
    assert!((range.low.primary_radius - 0.0498).abs() < 1e-3 && range.low.secondary_radius <= 0.085 + 1e-12);
    for at in 0..=50 {
        let share = f64::from(at) / 50.0;
        let primary = range.low.primary_radius + share * (range.high.primary_radius - range.low.primary_radius);
        let radii = drive.at_primary(primary).unwrap();
        assert!(drive.error(primary, radii.secondary_radius).abs() < 1e-12);
        assert!((drive.at_secondary(radii.secondary_radius).unwrap().primary_radius - primary).abs() < 1e-12);
        assert!((drive.at_ratio(radii.ratio).unwrap().primary_radius - primary).abs() < 1e-12);
        let travel = drive.travel(range.low.primary_radius, primary);
        assert!((drive.at_travel(travel, range.low.primary_radius).unwrap().primary_radius - primary).abs() < 1e-12);
        // Spans and arcs are all there is of the belt.
        let arcs = radii.primary_wrap_angle * primary + radii.secondary_wrap_angle * radii.secondary_radius;
        assert!((arcs + 2.0 * radii.span_length - 0.8572).abs() < 1e-12);
    }
    // The thesis's radius at full shift, 93 mm: its spring is compressed by 2 tan β (0.093 − R_P) less elsewhere (9.3).
    assert!((drive.travel(0.0683, 0.093) - 2.0 * 12f64.to_radians().tan() * 0.0247).abs() < 1e-15);
    for (error, words) in [
        (drive.at_primary(0.3).unwrap_err(), "leaves no room"),
        (drive.at_ratio(-1.0).unwrap_err(), "above zero"),
        (drive.at_travel(-0.1, 0.06).unwrap_err(), "opens by no more than"),
        (Geometry { pitch_length: 0.4, ..drive }.at_ratio(1.0).unwrap_err(), "does not close: the belt is too short"),
        (Geometry { pitch_length: 2.0, ..drive }.at_ratio(1.0).unwrap_err(), "does not close: the belt is too long"),
        (drive.shift_range(&Limits { primary: (0.09, 0.04), ..limits }).unwrap_err(), "no range"),
        (drive.shift_range(&Limits { primary: (0.01, 0.02), secondary: (0.01, 0.02) }).unwrap_err(), "fits nowhere"),
    ] {
        assert!(error.to_string().contains(words), "{error}");
    }
}

fn sheave(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_sheave")).args(arguments).output().unwrap()
}

#[test]
fn the_commands_as_they_are_called() {
    let file = example("cvtech.toml");
    let file = file.to_str().unwrap();
    let object: Value = serde_json::from_slice(&sheave(&["belt", file, "--json"]).stdout).unwrap();
    assert_eq!((object["schema"].as_u64(), object["command"].as_str()), (Some(1), Some("belt")));
    assert!((object["belt"]["bending_stiffness"].as_f64().unwrap() - 0.2602).abs() < 2e-4);
    assert_eq!(object["inputs"]["tension.force"], 100.0);
    assert!(object["warnings"].is_array());

    let cool: Value =
        serde_json::from_slice(&sheave(&["belt", file, "--temperature", "25 degC", "--json"]).stdout).unwrap();
    assert!((cool["belt"]["radial_stiffness"].as_f64().unwrap() - 28.98e6).abs() < 1e4);

    let folder = tempfile::tempdir().unwrap();
    let out = sheave(&["belt", file, "--out", folder.path().to_str().unwrap()]);
    assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
    for name in ["belt.toml", "result.json", "section.svg", "section.png", "modulus.svg", "report.html"] {
        assert!(folder.path().join(name).metadata().unwrap().len() > 0, "{name}");
    }
    assert_eq!(std::fs::read(folder.path().join("belt.toml")).unwrap(), out.stdout);

    // A belt in winter: refused for where the rubber was tested, not for the sign.
    let cold = sheave(&["belt", file, "--temperature", "-5 degC"]);
    // Without the frame in which long messages are broken.
    let said = String::from_utf8_lossy(&cold.stderr).replace('│', " ");
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains("-5.0 °C lies outside"), "{said}");
    let hot = sheave(&["belt", file, "--temperature", "90 degC", "--json"]);
    assert_eq!(hot.status.code(), Some(2));
    let object: Value = serde_json::from_slice(&hot.stdout).unwrap();
    assert_eq!(object["failure"]["kind"], "input");
    assert!(object["failure"]["message"].as_str().unwrap().contains("lies outside"));

    let limits = ["--primary-limits", "40..93 mm", "--secondary-limits", "40 mm..95 mm"];
    let radii = sheave(&[["radii", "--ratio", "1.74", "--json"].as_slice(), &limits].concat());
    let object: Value = serde_json::from_slice(&radii.stdout).unwrap();
    assert_eq!(object["command"], "radii");
    assert!((object["ratio"].as_f64().unwrap() - 1.74).abs() < 1e-12);
    assert!(object["shift_range"]["low"]["ratio"].as_f64().unwrap() > 1.74);
    let none = sheave(&["radii", "--set", "belt.length=0.4 m", "--set", "drive.free=secondary_radius", "--json"]);
    assert_eq!(none.status.code(), Some(2));
    let object: Value = serde_json::from_slice(&none.stdout).unwrap();
    assert!(object["failure"]["message"].as_str().unwrap().contains("too short"), "{object}");
    assert_eq!(sheave(&["radii", "--primary", "300 mm"]).status.code(), Some(2));
}

/// What was measured of a belt beside its stiffnesses is in the case, too: another belt's is not taken for it.
#[test]
fn the_case_has_all_that_was_measured() {
    let description = CVTECH.replace("storage_over_loss = 8.2", "storage_over_loss = 5.5");
    let description = description.replace("sample_length =", "sheave_half_angle = \"13 deg\"\nsample_length =");
    let properties = Description::parse("belt.toml", &description).unwrap().evaluate(None).unwrap();
    let mut case = Case::from_toml("belt.toml", &properties.case_file()).unwrap();
    case.set("thermal.ambient", "25 degC").unwrap();
    case.set("thermal.heat_transfer_per_area", "200").unwrap();
    let read = case.resolve().unwrap();
    assert!((read.losses.loss_tangent.largest() - 1.0 / 5.5).abs() < 1e-7, "{:?}", read.losses);
    assert!((read.sheave.half_angle.to_degrees() - 13.0).abs() < 1e-9);
    let thermal = read.thermal.unwrap();
    assert!((thermal.reference - 333.15).abs() < 1e-9);
    // 140.13 MPa at 25 °C, 90.45 MPa at 60 °C.
    let softening = (140.13_f64 / 90.45).ln() / 35.0;
    for found in [thermal.bending_softening, thermal.radial_softening] {
        assert!((found / softening - 1.0).abs() < 1e-6, "{found} {softening}");
    }
    // The thesis's section is 77.3 mm around.
    assert!((1e3 * thermal.surface.unwrap().perimeter - 77.3).abs() < 0.05, "{:?}", thermal.surface);
    // At another temperature the stiffnesses are those there, and so is the temperature that they are told for.
    let cool = Description::parse("belt.toml", &description).unwrap().evaluate(Some(303.15)).unwrap();
    let file = cool.case_file();
    let read = Case::from_toml("belt.toml", &file).unwrap().resolve().unwrap();
    assert!((read.stiffnesses.reference - 303.15).abs() < 1e-9);
    // The loss modulus was measured at 60 °C alone.
    assert!(file.contains("No loss tangent was measured here"), "{file}");
    assert!(cool.warnings.iter().any(|said| said.starts_with("no loss tangent is known at 30.0 °C")));
    assert!(properties.warnings.is_empty(), "{:?}", properties.warnings);
    let lumped = Description::read(&example("g-force.toml")).unwrap().evaluate(None).unwrap();
    let read = Case::from_toml("belt.toml", &lumped.case_file()).unwrap().resolve().unwrap();
    assert!((read.sheave.half_angle.to_degrees() - 15.0).abs() < 1e-9);
}

#[test]
fn what_would_not_be_used_is_refused() {
    for (from, to, words) in [
        ("radius = \"3653 mm\"", "radius = \"3653 mm\"\nlength = \"17 mm\"", "`bending.length`: it belongs to"),
        (
            "outside_circumference = \"875.1 mm\"",
            "pitch_length = \"857 mm\"\ncord_depth = \"3 mm\"",
            "`length.cord_depth`: it makes a pitch length",
        ),
    ] {
        let text = refused(from, to);
        assert!(text.contains(words), "{to}: {text}");
    }
    let lumped = std::fs::read_to_string(example("g-force.toml")).unwrap();
    let refused = |from: &str, to: &str| {
        assert!(lumped.contains(from), "{from}");
        let read = Description::parse("b.toml", &lumped.replacen(from, to, 1));
        said(&read.and_then(|description| description.evaluate(None)).unwrap_err())
    };
    let text = refused("[tension]", "[rubber]\npoisson_ratio = 0.5\n[tension]");
    assert!(text.contains("`rubber.poisson_ratio`: there is no [[rubber.test]]"), "{text}");
    let rubber = "[[rubber.test]]\ntemperature = \"25 degC\"\nyoungs_modulus = \"140 MPa\"\n";
    let text = refused("[tension]", &format!("[rubber]\npoisson_ratio = 0.5\n{rubber}[tension]"));
    assert!(text.contains("`rubber.poisson_ratio`: it makes Young's modulus"), "{text}");
    let text = refused("[tension]", "[tension]\ntemperature = \"25 degC\"");
    assert!(text.contains("`tension.temperature`: without [yarns]"), "{text}");
    // The stiffness between two nodes is one of rubber, as that by moment and radius is.
    let text = refused("[tension]", &format!("{rubber}[tension]"));
    assert!(text.contains("`bending.temperature` is not given"), "{text}");
}

#[test]
fn a_folder_that_is_a_file_is_refused_before_anything_is_done() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    std::fs::write(&taken, "mine").unwrap();
    let file = example("cvtech.toml");
    for out in [taken.clone(), taken.join("below")] {
        let output = sheave(&["belt", file.to_str().unwrap(), "--out", out.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(output.stdout.is_empty());
        assert!(String::from_utf8_lossy(&output.stderr).contains("expected the name of a folder"), "{output:?}");
    }
}

/// Decimal commas make more cells than there are columns: half of each number is none.
#[test]
fn raw_data_with_decimal_commas_are_no_data() {
    let parse = |text: &str| {
        use sheave::quantity::Dimension;
        sheave::bench::belt::parse_columns("t.csv", text.as_bytes(), [Dimension::LENGTH, Dimension::FORCE])
    };
    let error = parse("mm,N\n0,1,50,2\n0,2,100,4\n").unwrap_err().to_string();
    assert!(error.contains("no row has two numbers, with decimal points"), "{error}");
    let marked = parse("\u{feff}mm,N\n0.1,50,\n0.2,100,,\n").unwrap();
    assert_eq!((marked.rows.len(), marked.bad), (2, None));
}

#[test]
fn reading_raw_data_ends_when_it_is_cancelled() {
    use sheave::quantity::Dimension;
    let cancel = sheave::Cancel::new();
    cancel.cancel();
    let read = || sheave::bench::belt::parse_columns("t.csv", b"mm,N\n1,2\n", [Dimension::LENGTH, Dimension::FORCE]);
    let error = sheave::cancellable(&cancel, read).unwrap_err();
    assert!(matches!(error.problem(), sheave::bench::BenchProblem::Cancelled), "{error}");
}
