//! Cases as a library user meets them: what is accepted, what it means, and how every mistake is shown.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use miette::{GraphicalReportHandler, GraphicalTheme};
use proptest::prelude::*;
use sheave::case::{
    Bending, Case, CaseError, Clamp, Edition, Ends, Fourth, Free, Friction, Key, Load, Resolved, Setting, Shear, Spans,
    Speed, TABLE, ValueKind,
};

fn resolve(toml: &str) -> Result<Resolved, CaseError> {
    Case::from_toml("case.toml", toml)?.resolve()
}

fn resolved(toml: &str) -> Resolved {
    resolve(toml).unwrap_or_else(|error| panic!("{toml}\n{error}"))
}

/// As people see it on a terminal without colours.
fn rendered(error: &CaseError) -> String {
    let mut text = String::new();
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode_nocolor()).with_width(110);
    handler.render_report(&mut text, error).unwrap();
    text
}

#[test]
fn an_empty_file_is_the_base_case() {
    let case = resolved("");
    assert_eq!(case, Case::base().resolve().unwrap());
    assert_eq!(case.edition, Edition::Consistent);
    // Table 6.1
    assert_eq!(case.belt.length, 0.8572);
    assert_eq!(case.belt.mass_per_length, 0.4375);
    assert_eq!(case.belt.longitudinal_stiffness, 243.5e3);
    assert_eq!(case.belt.bending_stiffness, 0.2602);
    assert_eq!(case.belt.radial_stiffness, 18.71e6);
    assert_eq!(case.sheave.half_angle, 0.20943951023931953);
    assert_eq!(case.sheave.friction_coefficient, 0.4);
    assert_eq!(case.sheave.slip_threshold, 1e-4);
    assert_eq!(case.drive.center_distance, 0.214);
    assert_eq!(case.drive.primary_radius, 0.068309);
    assert_eq!(case.drive.secondary_radius, 0.068309);
    assert_eq!(case.operating_point.speed, Speed::Primary(356.0471674068432));
    assert_eq!(case.operating_point.load, Load::PrimaryTorque(18.0));
    assert_eq!(case.operating_point.clamp, Clamp::SlackTension(100.0));
}

#[test]
fn the_example_spells_the_base_case_out() {
    let example = include_str!("../examples/baja.toml");
    assert_eq!(resolved(example), resolved(""));
    let case = Case::from_toml("baja.toml", example).unwrap();
    // Actuators, engine and vehicle are those of examples/drive.
    let parts = ["primary", "secondary", "engine", "vehicle"];
    for entry in TABLE.iter().filter(|entry| !parts.contains(&entry.path.split('.').next().unwrap_or_default())) {
        assert!(example.contains(entry.name()) || entry.key == Key::Free, "{} is not mentioned", entry.path);
        assert!(case.has(entry.key) || entry.base().is_none(), "{} is not given", entry.path);
    }
}

#[test]
fn editions_stand_for_models_that_can_be_refined() {
    let model = |toml: &str| resolved(toml).model;
    let bending = |shear, ends, spans| Some(Bending { shear, ends, spans });
    use {Ends::*, Shear::*};
    assert_eq!(model("edition = 'published'").bending, bending(Linearised, Ends::AsPrinted, Spans::AsPrinted));
    assert_eq!(model("edition = 'thesis'").bending, bending(Linearised, Zero, Spans::Derived));
    assert_eq!(model("edition = 'consistent'").bending, bending(Full, Continuous, Spans::Derived));
    assert_eq!(model("edition = 'string'").bending, None);
    assert_eq!(
        model("edition = 'thesis'\nmodel.ends = 'continuous'").bending,
        bending(Linearised, Continuous, Spans::Derived)
    );
    assert_eq!(
        model("edition = 'published'\nmodel = { ends = 'zero', shear = 'full' }").bending,
        bending(Full, Zero, Spans::AsPrinted)
    );
    assert_eq!(model("model.friction = 'tanh'\nedition = 'string'").friction, Friction::Tanh);
}

#[test]
fn the_operating_point_has_three_slots() {
    let point = |toml: &str| resolved(&format!("[operating_point]\n{toml}")).operating_point;
    let base = point("");
    assert_eq!(point("secondary_speed = 300").speed, Speed::Secondary(300.0));
    assert_eq!(point("secondary_speed = 300").load, base.load);
    assert_eq!(point("secondary_torque = '16 N*m'").load, Load::SecondaryTorque(16.0));
    assert_eq!(point("speed_ratio = 0.95").load, Load::SpeedRatio(0.95));
    let both = point("secondary_speed = 300\nprimary_speed = 310");
    assert_eq!((both.speed, both.load), (Speed::Primary(310.0), Load::SecondarySpeed(300.0)));
    assert_eq!(point("tight_tension = 350").clamp, Clamp::TightTension(350.0));
    assert_eq!(point("primary_axial_force = 900").clamp, Clamp::PrimaryAxialForce(900.0));
    assert_eq!(point("secondary_axial_force = 500").clamp, Clamp::SecondaryAxialForce(500.0));
    let closed =
        resolved("drive.free = 'both'\n[operating_point]\nprimary_axial_force = 900\nsecondary_axial_force = '500 N'");
    assert_eq!(closed.operating_point.clamp, Clamp::PrimaryAxialForce(900.0));
    assert_eq!(closed.operating_point.fourth, Some(Fourth::Clamp(Clamp::SecondaryAxialForce(500.0))));
    let closed = resolved(
        "drive.free = 'both'\n[operating_point]\nprimary_speed = 300\nsecondary_speed = 200\nprimary_torque = 18",
    );
    assert_eq!(closed.operating_point.load, Load::PrimaryTorque(18.0));
    assert_eq!(closed.operating_point.fourth, Some(Fourth::Load(Load::SecondarySpeed(200.0))));
}

#[test]
fn radii_follow_from_the_ratio_or_from_the_other_radius() {
    let drive = |toml: &str| resolved(&format!("[drive]\n{toml}")).drive;
    for ratio in [0.72, 1.0, 1.74] {
        let drive = drive(&format!("ratio = {ratio}"));
        assert_eq!(drive.secondary_radius, ratio * drive.primary_radius);
        let length =
            sheave::case::geometry::pitch_length(drive.primary_radius, drive.secondary_radius, drive.center_distance);
        assert!((length - 0.8572).abs() < 1e-15);
    }
    assert_eq!(drive("primary_radius = '70 mm'").secondary_radius, 0.068309);
    let free = drive("secondary_radius = '80 mm'\nfree = 'primary_radius'");
    assert_eq!((free.free, free.secondary_radius), (Some(Free::PrimaryRadius), 0.08));
    assert!(free.primary_radius < 0.068309);
    assert_eq!(drive("ratio = 1.2\nfree = 'secondary_radius'").primary_radius, drive("ratio = 1.2").primary_radius);
}

#[test]
fn setting_replaces_and_unsetting_removes() {
    let mut case = Case::from_toml("case.toml", "operating_point.slack_tension = '120 N'").unwrap();
    case.assign("operating_point.slack_tension=130 N").unwrap();
    assert_eq!(case.resolve().unwrap().operating_point.clamp, Clamp::SlackTension(130.0));
    case.assign(" operating_point.slack_tension = \"140 N\" ").unwrap();
    assert_eq!(case.resolve().unwrap().operating_point.clamp, Clamp::SlackTension(140.0));
    case.set_si(Key::SlackTension, 0.1 + 0.2).unwrap();
    assert_eq!(case.resolve().unwrap().operating_point.clamp, Clamp::SlackTension(0.1 + 0.2));
    let before = case.clone();
    assert!(case.set("operating_point.slack_tension", "-1 N").is_err());
    assert_eq!(case, before);
    case.set("operating_point.tight_tension", "350 N").unwrap();
    assert!(case.resolve().is_err());
    case.unset("operating_point.slack_tension").unwrap();
    assert_eq!(case.resolve().unwrap().operating_point.clamp, Clamp::TightTension(350.0));
}

#[test]
fn inputs_are_sections_of_si_values() {
    let inputs =
        serde_json::to_string_pretty(&resolved("[drive]\nsecondary_radius = '70 mm'\nfree = 'primary_radius'"));
    insta::assert_snapshot!("inputs", inputs.unwrap());
}

/// Settings whose values serialise to themselves, so that a case can be written from them.
fn rewritten(resolved: &Resolved) -> Case {
    let mut case = Case::base();
    for (key, setting) in resolved.settings() {
        match setting {
            Setting::Number(value) => case.set_si(key, value).unwrap(),
            Setting::List(values) => case.set_list(key, &values).unwrap(),
            Setting::Name(name) => case.set(key.path(), name).unwrap(),
            Setting::Table(grid) => case.set(key.path(), &grid.to_string()).unwrap(),
        }
    }
    case
}

/// Every quantity that may be a table.
const TABLES: &str = "[belt]
loss_tangent = { frequency = ['10 Hz', '0.1 kHz'], temperature = ['25 degC', '140 degF'], value = [[0.15, 0.12], \
    [0.16, '13 %']] }
cord_loss_tangent = { frequency = [10, 100], value = [0.01, 0.02] }
bending_stiffness = { temperature = ['25 degC', '60 degC'], value = ['0.4031 N*m^2', 0.2602] }
[belt.radial_stiffness]
temperature = ['25 degC', '60 degC']
value = ['28.98 MPa', '18.71 MPa']
";

#[test]
fn tables_stand_in_place_of_numbers() {
    let case = resolved(TABLES);
    // Read at the reference temperature where no other is known.
    assert!((case.belt.bending_stiffness / 0.2602 - 1.0).abs() < 1e-12, "{:?}", case.belt);
    assert!((case.belt.radial_stiffness / 18.71e6 - 1.0).abs() < 1e-12, "{:?}", case.belt);
    let tangent = case.losses.loss_tangent.at(10.0, 298.15);
    assert!((tangent.value - 0.15).abs() < 1e-12, "{tangent:?}");
    assert!((case.losses.loss_tangent.at(100.0, 333.15).value - 0.13).abs() < 1e-12);
    assert!((case.losses.cord_loss_tangent.at(31.622_776_601_683_79, 300.0).value - 0.015).abs() < 1e-12);
    let inputs = serde_json::to_value(&case).unwrap();
    assert_eq!(inputs["belt"]["cord_loss_tangent"]["frequency"], serde_json::json!([10.0, 100.0]));
    assert_eq!(inputs["belt"]["bending_stiffness"]["value"], serde_json::json!([0.4031, 0.2602]));
    assert_eq!(inputs["thermal"]["reference"], serde_json::json!(333.15));
    // A number set later takes a table's place, and a table that of a number.
    let mut case = Case::from_toml("test", TABLES).unwrap();
    case.set("belt.bending_stiffness", "0.3").unwrap();
    assert_eq!(case.resolve().unwrap().belt.bending_stiffness, 0.3);
    case.set("belt.bending_stiffness", "{ temperature = ['60 degC'], value = [0.25] }").unwrap();
    assert!((case.resolve().unwrap().belt.bending_stiffness - 0.25).abs() < 1e-15);
    // At another reference, the geometric mean half way.
    case.set("thermal.reference", "42.5 degC").unwrap();
    let half_way = case.resolve().unwrap().belt.radial_stiffness;
    assert!((half_way / (28.98e6_f64 * 18.71e6).sqrt() - 1.0).abs() < 1e-12, "{half_way}");
}

#[test]
fn a_bare_temperature_in_degrees_celsius_is_not_taken_for_one_in_kelvin() {
    for key in ["thermal.ambient", "thermal.reference"] {
        let mut case = Case::default();
        let error = case.set(key, "25").unwrap_err();
        assert!(error.to_string().contains("from 150 K and up to 2000 K"), "{error}");
        assert_eq!(error.hint().as_deref(), Some("a bare number is in SI units; did you mean \"25 degC\"?"));
        case.set(key, "25 degC").unwrap();
        case.set("thermal.ambient", "25 degC").unwrap();
        case.set("thermal.heat_transfer", "10 W/K").unwrap();
        case.resolve().unwrap();
    }
}

/// What is wrong with a table is underlined at its own place.
#[test]
fn tables_that_are_none_are_refused_where_they_are_wrong() {
    for (toml, words, underlined) in [
        ("belt.loss_tangent = { value = [0.1] }", "needs `temperature`, `frequency` or both", "{ value = [0.1] }"),
        ("belt.loss_tangent = { temperature = ['25 degC'] }", "`value` is not given", "{ temperature = ['25 degC'] }"),
        ("belt.loss_tangent = { temperature = ['25 mm'], value = [0.1] }", "`temperature` has '25 mm'", "'25 mm'"),
        ("belt.loss_tangent = { frequency = [true], value = [0.1] }", "an item of `frequency` is a boolean", "true"),
        ("belt.loss_tangent = { frequency = 3, value = [0.1] }", "`frequency` is an integer: expected a list", "3"),
        ("belt.loss_tangent = { frequency = [1, 2], value = [0.1] }", "has 1 rows: expected 2", "[0.1]"),
        ("belt.loss_tangent = { frequency = [1, 1], value = [0.1, 0.1] }", "number 2", "{ frequency"),
        ("belt.loss_tangent = { frequency = [1], value = [20] }", "out of range", "20"),
        ("belt.loss_tangent = { frequency = [1], values = [20] }", "`values` has no place in it", "values"),
        ("belt.bending_stiffness = { frequency = [1], value = [20] }", "`frequency` has no place in it", "frequency"),
        ("belt.bending_stiffness = { temperature = [300], value = ['3 kg'] }", "belt.bending_stiffness", "'3 kg'"),
        ("belt.length = { temperature = [300], value = [1] }", "`belt.length` is a table", "{ temperature"),
        (
            "belt.bending_stiffness = { temperature = [300], value = [1] }\nthermal.bending_softening = 0.01",
            "the table says how",
            "{ temperature",
        ),
    ] {
        let error = Case::from_toml("test", toml).and_then(|case| case.resolve().map(|_| ())).unwrap_err();
        assert!(error.to_string().contains(words), "{toml}: {error}");
        let place = &error.places()[0];
        assert!(place.given().starts_with(underlined), "{toml}: {:?}", place.given());
    }
    // In an argument, places count from the argument's own start.
    let mut case = Case::base();
    let error = case.assign("belt.loss_tangent={ frequency = [1], value = [20] }").unwrap_err();
    assert_eq!(error.places()[0].given(), "20");
    assert!(case.assign("belt.loss_tangent={ frequency = [1], value").is_err());
}

#[test]
fn inputs_make_the_same_case_again() {
    for toml in [
        "",
        "edition = 'published'",
        "edition = 'string'",
        "edition = 'thesis'\nmodel = { shear = 'full', friction = 'tanh' }\ndrive.ratio = 1.3",
        "drive = { free = 'secondary_radius', primary_radius = 0.06 }\noperating_point.speed_ratio = 0.7",
        "drive.free = 'both'\noperating_point = { primary_axial_force = 900, secondary_axial_force = 500 }",
        "operating_point = { primary_speed = 300, secondary_speed = 290, tight_tension = 400 }",
        "thermal.reference = '50 degC'",
        TABLES,
        "belt.perimeter = '80 mm'\nthermal = { ambient = '20 degC', heat_transfer_per_area = 160, reference = 320 }",
    ] {
        let first = resolved(toml);
        assert_eq!(rewritten(&first).resolve().unwrap(), first, "{toml}");
    }
}

/// One file for each kind of mistake.
const MISTAKES: &[(&str, &str)] = &[
    ("syntax", "[belt]\nlength = \"857.2 mm\nmass_per_length = 1"),
    ("key given twice", "[belt]\nlength = 1\nlength = 2"),
    ("unknown key", "[belt]\nlenght = \"857.2 mm\""),
    ("unknown key at the top", "title = \"mine\""),
    ("unknown section", "[sheaves]\nhalf_angle = \"12 deg\""),
    ("section of another kind", "belt = 3"),
    ("boolean", "[belt]\nlength = true"),
    ("table", "[belt.length]\nvalue = 3"),
    ("array", "[belt]\nlength = [1, 2]"),
    ("hexadecimal", "[belt]\nlength = 0x10"),
    ("number for a choice", "edition = 3"),
    ("unknown choice", "edition = \"publised\""),
    ("no number", "[sheave]\nfriction_coefficient = \"high\""),
    ("unknown unit", "[belt]\nlength = \"857.2 MM\""),
    ("comma", "[belt]\nlength = \"857,2 mm\""),
    ("wrong dimension", "[belt]\n# in the shop they weigh it\nlength = \"3 kg\""),
    ("frequency", "[operating_point]\nprimary_speed = \"50 Hz\""),
    ("not a number", "[sheave]\nfriction_coefficient = nan"),
    ("infinite", "[operating_point]\nprimary_torque = \"inf N*m\""),
    ("too large for a number", "[operating_point]\nprimary_torque = 1e999"),
    ("negative", "[operating_point]\nslack_tension = \"-100 N\""),
    ("zero", "[belt]\nbending_stiffness = 0"),
    ("too large", "[sheave]\nhalf_angle = \"45 deg\""),
    ("unit forgotten", "[sheave]\nhalf_angle = 12"),
    ("two clamps", "[operating_point]\nslack_tension = \"100 N\"\nprimary_axial_force = \"900 N\""),
    ("two loads", "[operating_point]\nspeed_ratio = 0.99\nsecondary_torque = 17"),
    ("two speeds and a torque", "[operating_point]\nprimary_speed = 300\nprimary_torque = 17\nsecondary_speed = 290"),
    ("two speeds and their ratio", "[operating_point]\nprimary_speed = 300\nspeed_ratio = 0.97\nsecondary_speed = 290"),
    ("ratio and radius", "[drive]\nratio = 1.2\nsecondary_radius = \"70 mm\""),
    ("overlap", "[drive]\nprimary_radius = \"150 mm\"\n\n\ncenter_distance = \"200 mm\""),
    ("belt too short", "[belt]\nlength = \"400 mm\"\n[drive]\nratio = 1.2"),
    ("belt too long", "[drive]\nratio = 1.2\ncenter_distance = \"150 mm\""),
    ("free and given", "[drive]\nfree = \"primary_radius\"\nprimary_radius = \"70 mm\""),
    ("free and ratio", "[drive]\nfree = \"both\"\nratio = 1.1"),
    ("free without a fourth key", "[drive]\nfree = \"both\""),
    (
        "free with a fifth key",
        "drive.free = \"both\"\n[operating_point]\ntight_tension = 1\nslack_tension = 2\nprimary_torque = \
        1\nsecondary_torque = 2",
    ),
    (
        "free with a third clamp",
        "drive.free = \"both\"\n[operating_point]\ntight_tension = 1\nslack_tension = 2\nprimary_axial_force = 1",
    ),
    ("free and no room", "[drive]\nfree = \"primary_radius\"\nsecondary_radius = \"300 mm\""),
    ("shear of a string", "edition = \"string\"\n[model]\nshear = \"full\""),
    ("printed ends with full shear", "[model]\nends = \"as-printed\""),
    ("full shear with printed ends", "edition = \"published\"\n[model]\nshear = \"full\""),
];

#[test]
fn every_mistake_is_shown_in_its_place() {
    let mut all = String::new();
    for (name, toml) in MISTAKES {
        let error = resolve(toml).expect_err(name);
        all += &format!("## {name}\n{}\n", rendered(&error));
        let span = error.places().first().unwrap_or_else(|| panic!("{name} has no place")).value.clone();
        assert!(span.end <= toml.len(), "{name}: {span:?}");
    }
    insta::assert_snapshot!("mistakes", all);
}

#[test]
fn mistakes_in_arguments_are_shown_too() {
    let mut all = String::new();
    for assignment in
        ["belt.length", "belt.lenght=3", "=3", "belt.length=", "belt.length = 3 kg", "edition=x", "\u{1f980}=\u{1f980}"]
    {
        let error = Case::base().assign(assignment).expect_err(assignment);
        all += &format!("## {assignment}\n{}\n", rendered(&error));
    }
    let mut case = Case::from_toml("case.toml", "[operating_point]\nslack_tension = \"100 N\"").unwrap();
    case.assign("operating_point.tight_tension=300 N").unwrap();
    all += &format!("## file and argument\n{}\n", rendered(&case.resolve().unwrap_err()));
    all += &format!("## unset\n{}\n", rendered(&case.unset("belt").unwrap_err()));
    insta::assert_snapshot!("arguments", all);
}

#[test]
fn every_range_is_checked_at_both_ends() {
    for entry in &TABLE {
        let ValueKind::Quantity { unit, range, .. } = entry.kind else { continue };
        for bound in [range.low, range.high] {
            use sheave::case::RangeEnd::{Closed, None, Open};
            let (value, allowed) = match bound {
                None => continue,
                Open(value) => (value, false),
                Closed(value) => (value, true),
            };
            let set = Case::base().set_si(entry.key, unit.to_si(value));
            assert_eq!(set.is_ok(), allowed, "{} = {value} {}", entry.path, unit.symbol);
        }
        assert!(Case::base().set_si(entry.key, f64::NAN).is_err(), "{}", entry.path);
        assert!(Case::base().set_si(entry.key, f64::INFINITY).is_err(), "{}", entry.path);
        let signed = matches!(
            entry.key,
            Key::PrimaryTorque | Key::SecondaryTorque | Key::MassAngle | Key::RampStart | Key::RollerStart | Key::Grade
        );
        assert_eq!(Case::base().set_si(entry.key, -1.0).is_ok(), signed, "{}", entry.path);
    }
}

#[test]
fn a_missing_file_is_named() {
    let error = Case::read(std::path::Path::new("no/such/case.toml")).unwrap_err();
    assert!(error.to_string().starts_with("cannot read the case file `no/such/case.toml`: "), "{error}");
    assert!(Case::read(std::path::Path::new(".")).is_err());
}

/// A line that could stand in a case file, or nearly.
fn line() -> impl Strategy<Value = String> {
    let path = prop_oneof![
        8 => (0..TABLE.len()).prop_map(|index| TABLE[index].path.to_owned()),
        1 => "[a-z_.]{0,12}",
        1 => Just("belt".to_owned()),
    ];
    let value = prop_oneof![
        4 => (0..TABLE.len()).prop_map(|index| TABLE[index].example()),
        2 => any::<f64>().prop_map(|number| format!("{number:?}")),
        1 => any::<i64>().prop_map(|number| number.to_string()),
        1 => "\"[-0-9.e]{0,4} ?[a-zA-Z*/^µ°²]{0,6}\"",
        1 => "[-\\[\\]{}0-9a-z\"'.,_: ]{0,10}",
    ];
    (path, value).prop_map(|(path, value)| format!("{path} = {value}"))
}

proptest! {
    #[test]
    fn no_file_panics(text in "\\PC*") {
        let _ = resolve(&text).map_err(|error| rendered(&error));
    }

    #[test]
    fn no_plausible_file_panics(lines in prop::collection::vec(line(), 0..6)) {
        match resolve(&lines.join("\n")) {
            Err(error) => prop_assert!(!rendered(&error).is_empty()),
            Ok(resolved) => prop_assert_eq!(rewritten(&resolved).resolve(), Ok(resolved)),
        }
    }

    #[test]
    fn no_assignment_panics(text in "\\PC*", likely in line()) {
        for assignment in [text, likely] {
            let mut case = Case::base();
            let _ = case.assign(&assignment).and_then(|()| case.resolve()).map_err(|error| rendered(&error));
        }
    }
}

/// Wherever and however it was written; arrays may be given as a file has them.
#[test]
fn cases_are_equal_by_what_they_give() {
    let case = |settings: &[(&str, &str)]| {
        let mut case = Case::base();
        settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
        case
    };
    let text = "[drive]\nratio = 1.2\n[operating_point]\nslack_tension = \"0.12 kN\"\n";
    let read = Case::from_toml("one.toml", text).unwrap();
    assert_eq!(read, case(&[("operating_point.slack_tension", "120 N"), ("drive.ratio", "1.2")]));
    assert_ne!(read, case(&[("operating_point.slack_tension", "121 N"), ("drive.ratio", "1.2")]));
    assert_ne!(read, case(&[("drive.ratio", "1.2")]));
    let mut swapped = read.clone();
    swapped.swap("belt.bending_stiffness for efficiency.overall = 0.96").unwrap();
    assert_ne!(read, swapped);
    let curve = |speeds: &str| case(&[("engine.speeds", speeds)]);
    assert_eq!(curve("[200.0, 300.0]"), curve("200, 300 rad/s"));
}
