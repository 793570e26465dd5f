//! A drive that is changed while one looks at it: the questions that the page asks.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::{Value, json};
use sheave::live::Live;
use sheave::prelude::*;

fn ask(live: &mut Live, question: Value) -> Value {
    serde_json::from_str(&live.answer(&question.to_string())).unwrap()
}

/// A slider at a value: where the drive was, it goes from there.
fn slide(live: &mut Live, case: &str, key: &str, value: &str) -> Value {
    let set = json!([[key, value]]);
    ask(live, json!({ "ask": "solve", "case": case, "set": set, "tolerance": 1e-3, "follow": true }))
}

/// A slider at a value, until the drive has followed or has lost its way.
fn arrive(live: &mut Live, case: &str, key: &str, value: &str) -> Value {
    let mut answer = slide(live, case, key, value);
    for _ in 0..80 {
        if answer["on_the_way"] != true {
            break;
        }
        let case = text(&answer, "case").to_owned();
        answer = slide(live, &case, key, value);
    }
    assert_eq!(answer["on_the_way"], Value::Null, "{key} {value}");
    answer
}

fn force(answer: &Value) -> f64 {
    answer["result"]["primary"]["axial_force"].as_f64().unwrap_or_else(|| panic!("{answer}"))
}

fn text<'a>(answer: &'a Value, key: &str) -> &'a str {
    answer[key].as_str().unwrap_or_else(|| panic!("{answer}"))
}

#[test]
fn followed_or_from_nothing_the_drive_is_the_same() {
    let mut live = Live::default();
    let mut case = String::new();
    for torque in ["18 N*m", "20 N*m", "23 N*m", "60 N*m"] {
        let answer = arrive(&mut live, &case, "operating_point.primary_torque", torque);
        case = text(&answer, "case").to_owned();
    }
    let rested = ask(&mut live, json!({ "ask": "solve", "case": case, "tolerance": 1e-8 }));
    let cold = Case::base().with("operating_point.primary_torque", "60 N*m").unwrap();
    let cold = sheave::solve_with(&cold, &SolveOptions { tolerance: 1e-8, ..SolveOptions::default() }).unwrap();
    let cold = cold.result.primary.axial_force;
    assert!((force(&rested) - cold).abs() < 1e-6 * cold, "{} {cold}", force(&rested));
}

#[test]
fn what_is_moved_takes_the_place_of_what_it_excludes_and_the_rest_stays() {
    let mut live = Live::default();
    let ratio = slide(&mut live, "", "drive.ratio", "1.3");
    let secondary = ratio["values"]["drive.secondary_radius"].as_f64().unwrap();
    let radius = slide(&mut live, text(&ratio, "case"), "drive.primary_radius", "60 mm");
    assert_eq!(radius["values"]["drive.secondary_radius"].as_f64(), Some(secondary));
    assert!(!text(&radius, "case").contains("ratio"), "{radius}");
    let free = slide(&mut live, text(&radius, "case"), "drive.free", "secondary_radius");
    assert!(free["failure"].is_null() && !text(&free, "case").contains("secondary_radius ="), "{free}");
    let clamped = slide(&mut live, text(&free, "case"), "operating_point.secondary_axial_force", "700 N");
    assert!((clamped["result"]["secondary"]["axial_force"].as_f64().unwrap() - 700.0).abs() < 0.1);
    let tension = clamped["values"]["operating_point.slack_tension"].as_f64().unwrap();
    let shown = clamped["result"]["primary"]["exit_tension"].as_f64().unwrap();
    assert_eq!(tension, shown);
    let out = json!({ "ask": "solve", "case": text(&clamped, "case"), "tolerance": 1e-3,
        "unset": ["operating_point.secondary_axial_force", "drive.free"] });
    assert_eq!(ask(&mut live, out)["given"], json!(["drive.primary_radius"]));
    let speed = slide(&mut live, "", "operating_point.secondary_speed", "3000 rpm");
    let given = |answer: &Value| answer["given"].clone();
    assert_eq!(given(&speed), json!(["operating_point.secondary_speed"]));
    let speed = slide(&mut live, text(&speed, "case"), "operating_point.primary_speed", "3000 rpm");
    assert_eq!(given(&speed), json!(["operating_point.primary_speed"]));
}

#[test]
fn where_the_belt_slips_the_way_ends_and_the_limit_is_named() {
    let mut live = Live::default();
    let start = slide(&mut live, "", "operating_point.primary_axial_force", "900 N");
    let answer = arrive(&mut live, text(&start, "case"), "operating_point.primary_torque", "60 N*m");
    let message = text(&answer["failure"], "message");
    assert!(message.starts_with("the belt slips beyond primary torque = 32.1"), "{message}");
    assert_eq!(answer["values"]["operating_point.primary_torque"], 60.0);
    assert!(answer["scene"]["primary"]["x"].as_array().is_some_and(|x| x.len() > 100));
    // Farther on the same way nothing is computed again, and back there is a solution.
    let farther = slide(&mut live, text(&answer, "case"), "operating_point.primary_torque", "61 N*m");
    assert_eq!(farther["failure"]["message"], answer["failure"]["message"]);
    let limit = ask(&mut live, json!({ "ask": "largest_torque", "case": text(&farther, "case"), "tolerance": 1e-3 }));
    let largest = limit["torque"]["value"].as_f64().unwrap();
    assert!((32.1..32.2).contains(&largest), "{limit}");
    let back = slide(&mut live, text(&farther, "case"), "operating_point.primary_torque", "30 N*m");
    assert!(force(&back) > 0.0);
    let clamps = json!({ "ask": "smallest_clamps", "case": text(&farther, "case"), "tolerance": 1e-3 });
    let clamp = ask(&mut live, clamps)["operating_point.primary_axial_force"]["value"].as_f64().unwrap();
    assert!(clamp > 900.0, "{clamp}");
}

#[test]
fn what_is_wrong_is_said_and_nothing_is_lost() {
    let mut live = Live::default();
    for (question, kind, said) in [
        ("", "usage", "not understood"),
        ("[]", "usage", "not understood"),
        (r#"{"ask": "everything"}"#, "usage", "everything"),
        (r#"{"ask": "solve", "tolerance": 1}"#, "usage", "1e-10"),
        (r#"{"ask": "solve", "case": "belt = <script>"}"#, "input", "not valid TOML"),
        (r#"{"ask": "solve", "case": "[engine]\nfile = \"/etc/passwd\""}"#, "input", "unknown key `engine.file`"),
        (r#"{"ask": "solve", "set": [["drive.ratio", "two"]]}"#, "input", "drive.ratio"),
        (r#"{"ask": "solve", "set": [["drive.ratoi", "2"]]}"#, "input", "drive.ratio"),
        (r#"{"ask": "solve", "set": [["drive.ratio", "0"]]}"#, "input", "drive.ratio"),
        (r#"{"ask": "solve", "set": [["drive.ratio", "90"]]}"#, "no_solution", "too stiff"),
        (r#"{"ask": "solve", "set": [["thermal.ambient", "20 degC"]]}"#, "input", "heat_transfer"),
    ] {
        let answer: Value = serde_json::from_str(&live.answer(question)).unwrap();
        let failure = &answer["failure"];
        assert_eq!(failure["kind"], kind, "{question}: {answer}");
        assert!(format!("{failure}").contains(said), "{question}: {failure}");
    }
    assert_eq!(ask(&mut live, json!({ "ask": "profile" }))["csv"], "");
    assert!(force(&slide(&mut live, "", "drive.ratio", "1.1")) > 0.0);
    let keys = ask(&mut live, json!({ "ask": "keys" }));
    assert_eq!(keys["keys"].as_array().unwrap().len(), sheave::case::TABLE.len());
}

#[test]
fn every_edition_heat_and_a_margin_are_shown() {
    let mut live = Live::default();
    for edition in ["string", "thesis", "published", "consistent"] {
        // At the base case's threshold, a string has no solution that the solver finds.
        let answer = slide(&mut live, "[sheave]\nslip_threshold = \"5 mm/s\"", "edition", edition);
        assert_eq!(answer["result"]["edition"], edition);
        assert!(answer["scene"]["tight_span"]["x"].as_array().is_some_and(|x| x.len() > 10), "{edition}");
    }
    let set = json!([["thermal.ambient", "25 degC"], ["thermal.heat_transfer", "10 W/K"]]);
    let warm = ask(&mut live, json!({ "ask": "solve", "case": "", "set": set, "tolerance": 1e-3 }));
    assert!(warm["result"]["belt"]["temperature"].as_f64().is_some_and(|kelvin| kelvin > 298.15));
    assert!((warm["values"]["thermal.ambient"].as_f64().unwrap() - 25.0).abs() < 1e-9);
    let margin = slide(&mut live, "", "operating_point.slip_reserve", "30 %");
    assert!((margin["result"]["slip_reserve"].as_f64().unwrap() - 0.3).abs() < 1e-3);
}

/// The example drive, whole, as the page has it.
const GX9: &str = include_str!("../web/page/gx9.toml");

#[test]
fn the_pages_drive_is_the_example() {
    let pages = Case::from_toml_alone("gx9.toml", GX9).unwrap();
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml");
    let example = Case::read(&path).unwrap();
    assert_eq!(pages.resolve().unwrap().settings(), example.resolve().unwrap().settings());
}

/// A shift curve as the page asks for it: what it begins with, then point after point, and what is said of them.
fn curve(live: &mut Live, case: &str, set: &Value) -> (Value, Vec<Value>, Value) {
    let question =
        json!({ "ask": "shift", "case": case, "set": set, "direction": "up", "points": 4, "tolerance": 1e-3 });
    let begun = ask(live, question);
    let (mut points, mut remarks) = (Vec::new(), Value::Null);
    while let Some(left) = begun["left"].as_u64() {
        let next = ask(live, json!({ "ask": "shift_next", "direction": "up" }));
        assert_eq!(next["left"].as_u64(), Some((left as usize - 1 - points.len()) as u64), "{next}");
        points.push(next["point"].clone());
        if points.len() == left as usize {
            remarks = next["remarks"].clone();
            break;
        }
        assert!(next.get("remarks").is_none(), "{next}");
    }
    (begun, points, remarks)
}

#[test]
fn a_shift_curve_comes_point_by_point() {
    let mut live = Live::default();
    let (begun, points, remarks) = curve(&mut live, GX9, &json!([]));
    assert!(begun["failure"].is_null() && begun["missing"] == json!([]), "{begun}");
    assert!(begun["given"].as_array().unwrap().contains(&json!("primary.actuator.mass")), "{begun}");
    assert!(begun["values"]["primary.actuator.mass"].as_f64().is_some_and(|grams| (grams - 134.0).abs() < 1e-9));
    // The same as the library has it at once.
    let case = Case::from_toml_alone("gx9.toml", GX9).unwrap().resolve().unwrap();
    let solve = SolveOptions { tolerance: 1e-3, uncertainty: false, ..SolveOptions::default() };
    let options = sheave::equilibrium::ShiftOptions { points: 4, solve, ..Default::default() };
    let mut go_on = |_: &_| std::ops::ControlFlow::Continue(());
    let direction = sheave::equilibrium::Direction::Up;
    let branch = sheave::equilibrium::shift_branch(&case, direction, &options, &mut go_on).unwrap();
    assert_eq!(branch.points.len(), points.len());
    assert_eq!(begun["shift_out"]["ratio"].as_f64(), branch.shift_out.map(|place| place.ratio));
    for (point, shown) in branch.points.iter().zip(&points) {
        let report = point.report.as_ref().unwrap();
        assert_eq!(shown["primary_speed"].as_f64(), Some(report.primary_speed));
        assert_eq!(shown["efficiency"].as_f64(), report.efficiency);
        assert_eq!(shown["doubt"].as_str(), report.doubt.map(sheave::result::Doubt::name));
    }
    let reports = branch.points.iter().filter_map(|point| point.report.as_deref().ok());
    assert_eq!(remarks, json!(sheave::equilibrium::over_curve(&case, reports)));
    assert!(remarks[0].as_str().unwrap().contains("the belt adheres on neither pulley"), "{remarks}");
    // Behind the last there is none.
    let next = ask(&mut live, json!({ "ask": "shift_next", "direction": "up" }));
    assert_eq!(next, json!({ "point": null, "left": 0 }));
    let back = ask(&mut live, json!({ "ask": "shift_next", "direction": "back" }));
    assert_eq!(back, json!({ "point": null, "left": 0 }));
}

#[test]
fn a_curve_beside_another_is_the_same_as_from_nothing() {
    let set = json!([["primary.actuator.mass", "140 g"]]);
    let mut live = Live::default();
    curve(&mut live, GX9, &json!([]));
    let (begun, beside, _) = curve(&mut live, GX9, &set);
    assert!(text(&begun, "case").contains("140 g"));
    let (cold, alone, _) = curve(&mut Live::default(), GX9, &set);
    let ratio = |answer: &Value| answer["full_shift"]["ratio"].as_f64().unwrap();
    assert!((ratio(&begun) / ratio(&cold) - 1.0).abs() < 1e-3);
    for (one, other) in beside.iter().zip(&alone) {
        let speed = |point: &Value| point["primary_speed"].as_f64().unwrap_or_else(|| panic!("{point}"));
        assert!((speed(one) / speed(other) - 1.0).abs() < 2e-3, "{one} {other}");
    }
}

#[test]
fn a_belt_alone_has_no_shift_curve() {
    let mut live = Live::default();
    let answer = ask(&mut live, json!({ "ask": "shift", "case": "", "direction": "up", "points": 4 }));
    assert_eq!(answer["failure"]["kind"], "input");
    assert!(text(&answer["failure"], "message").contains("actuators"), "{answer}");
    assert_eq!(answer["case"], "", "the page shows the case nevertheless");
    let wrong = ask(&mut live, json!({ "ask": "shift", "case": "", "direction": "sideways", "points": 4 }));
    assert_eq!(wrong["failure"]["kind"], "usage");
}

#[test]
fn a_box_of_parts_is_searched_while_one_looks() {
    let parts = "[mass]\nprimary.actuator.mass = [\"134 g\", \"160 g\"]\n\
                 [helix]\nsecondary.actuator.helix_angle = [\"31 deg\", \"34 deg\"]\n";
    let question = json!({ "ask": "tune", "case": GX9, "parts": parts, "target": "3200 rpm" });
    let answer = ask(&mut Live::default(), question);
    assert_eq!(answer["candidates"], 4, "{answer}");
    let tunes = answer["tunes"].as_array().unwrap();
    assert!(!tunes.is_empty(), "{answer}");
    let deviation = |tune: &Value| tune["rms_deviation"].as_f64().unwrap();
    assert!(tunes.windows(2).all(|pair| deviation(&pair[0]) <= deviation(&pair[1])));
    assert!(tunes[0]["confirmed"]["rms_deviation"].as_f64().is_some(), "{}", tunes[0]);
    // Each has its case, which is one.
    let helix = text(&tunes[0]["parts"], "helix");
    assert!(text(&tunes[0], "case").contains(&format!("helix_angle = \"{helix}\"")), "{}", tunes[0]);
    let wrong = |parts: &str, target: &str| {
        let question = json!({ "ask": "tune", "case": GX9, "parts": parts, "target": target });
        let answer = ask(&mut Live::default(), question);
        text(&answer["failure"], "message").to_owned()
    };
    assert!(wrong("[mass", "3200 rpm").contains("parts"));
    assert!(wrong(parts, "3200 kg").contains("expected a speed"));
    assert!(wrong("", "3200 rpm").contains("no parts"));
}

/// The drive that is shown is among the combinations, and shifts with a third of its friction in reserve: a map too
/// coarse beside the slip limit has no values where it runs.
#[test]
fn a_search_refuses_no_drive_that_shifts() {
    let parts = "[mass]\nprimary.actuator.mass = [\"120 g\", \"134 g\"]\n";
    let question = json!({ "ask": "tune", "case": GX9, "parts": parts, "target": "3300 rpm" });
    let answer = ask(&mut Live::default(), question);
    assert_eq!((&answer["shifting"], &answer["candidates"]), (&2.into(), &2.into()), "{answer}");
}
