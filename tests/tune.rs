//! The search for a tune: what it finds, what it refuses, how much work it is.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use sheave::beltmap::{BeltMap, KeepNothing, MapFormat, MapOptions};
use sheave::case::{Case, Key};
use sheave::drive::SolveOptions;
use sheave::equilibrium::{Direction, equilibrium};
use sheave::tune::{
    Part, PartKind, PartsBox, PartsProblem, Ranking, Screen, TuneError, TuneOptions, TunePlan, Unfit, Work,
};
use std::path::Path;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

const RPM: f64 = std::f64::consts::PI / 30.0;
const TARGET: f64 = 3400.0 * RPM;

fn example(name: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/tune").join(name)
}

fn drive() -> Case {
    let mut case = Case::read(&example("tuksbaja.toml")).unwrap();
    // The load at which the coarse map of these tests has combinations that shift.
    case.set("engine.throttle", "0.4").unwrap();
    case
}

fn whole_box() -> PartsBox {
    PartsBox::read(&example("tuksbaja-parts.toml")).unwrap()
}

fn plan(parts: PartsBox, confirmed: usize) -> TunePlan {
    TunePlan::new(drive(), parts, TuneOptions { points: 3, confirmed, ..TuneOptions::new(TARGET) }).unwrap()
}

/// One coarse map for all tests: no part changes the belt.
fn map() -> &'static BeltMap {
    static MAP: OnceLock<BeltMap> = OnceLock::new();
    MAP.get_or_init(|| {
        let solve = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
        let options = MapOptions { accuracy: 5e-2, solve, max_points: 300, ..MapOptions::default() };
        plan(whole_box(), 0).map(options).unwrap().build(&KeepNothing).unwrap()
    })
}

/// The search of the whole box on that map, its best tune confirmed, and how often it told of a combination done.
fn search() -> &'static (Ranking, usize) {
    static SEARCH: OnceLock<(Ranking, usize)> = OnceLock::new();
    SEARCH.get_or_init(|| {
        let done = AtomicUsize::new(0);
        let ranking = plan(whole_box(), 1).search(map(), &|| _ = done.fetch_add(1, Ordering::Relaxed)).unwrap();
        (ranking, done.into_inner())
    })
}

#[test]
fn the_box_of_tuksbaja_is_searched_within_bounded_work() {
    let (ranking, done) = search();
    assert_eq!((ranking.candidates, *done), (10_800, 10_800));
    let refused: usize = ranking.refused.iter().map(|refused| refused.count).sum();
    assert_eq!(ranking.tunes.len() + refused, 10_800);
    assert!(!ranking.tunes.is_empty(), "{:?}", ranking.refused);
    // Twenty-two readings a point: a few Newton steps where the parts balance, several starts where they do not.
    assert!(ranking.readings < 25 * 3 * 10_800, "{} readings of the map", ranking.readings);
    let deviation = |at: usize| ranking.tunes[at].merits.rms_deviation;
    assert!((1..ranking.tunes.len()).all(|at| deviation(at - 1) <= deviation(at)));
    assert!(ranking.tunes[0].pareto);
    // Whoever is not on the front is beaten by one who is.
    let front: Vec<_> = ranking.tunes.iter().filter(|tune| tune.pareto).map(|tune| tune.merits).collect();
    for tune in ranking.tunes.iter().filter(|tune| !tune.pareto) {
        let m = tune.merits;
        assert!(front.iter().any(|best| {
            best.rms_deviation <= m.rms_deviation
                && best.smallest_slip_reserve >= m.smallest_slip_reserve
                && best.mean_efficiency >= m.mean_efficiency
                && *best != m
        }));
    }
}

/// Parts under two names make two combinations that do the same: both are on the front, or neither is.
#[test]
fn combinations_that_do_the_same_do_not_beat_one_another() {
    let part = r#"
        primary.actuator.mass = "72 g"
        primary.actuator.coefficients = "39.467, 39.32, 38.353, 37.442, 37.967 mm"
        primary.spring.free_length = "144 mm"
        primary.spring.rate = "1.2 N/mm"
        secondary.spring.preload = "117 N"
        secondary.spring.rate = "4.27 N/mm"
        secondary.spring.torsion_rate = "4.55 N*m/rad"
        secondary.spring.pretension = "22 deg"
        secondary.actuator.helix_angle = "42 deg"
    "#;
    let parts = PartsBox::from_toml("parts", &format!("[all.one]{part}[all.other]{part}")).unwrap();
    let ranking = plan(parts, 0).search(map(), &|| ()).unwrap();
    let [one, other] = ranking.tunes.as_slice() else { panic!("{:?}", ranking.refused) };
    assert_eq!(one.merits, other.merits);
    assert!(one.pareto && other.pareto);
}

#[test]
fn a_full_solution_confirms_what_the_map_says() {
    let (ranking, _) = search();
    let tune = ranking.tunes.first().unwrap_or_else(|| panic!("{:?}", ranking.refused));
    let confirmed = tune.confirmed.as_ref().unwrap();
    assert!(confirmed.points >= 2, "{confirmed:?}");
    // The map of these tests is accurate to 5 %, and the speed goes with the square root of the force.
    assert!(confirmed.largest_difference < 0.03 * TARGET, "{confirmed:?}");
}

/// What the screen refuses on the map, the whole drive confirms: with flyweights that are too light it has not yet
/// shifted to the ratio at which they were found so, and its engine turns faster than the map has it.
#[test]
fn a_full_solution_confirms_a_refusal() {
    let (ranking, _) = search();
    let light = ranking.refused.iter().find(|refused| refused.reason == "flyweights too light");
    let light = light.unwrap_or_else(|| panic!("{:?}", ranking.refused));
    let ratio = light.example.strip_prefix("at ratio ").and_then(|rest| rest.split(',').next());
    let ratio: f64 = ratio.and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{light:?}"));
    let case = whole_box().case(&drive(), light.candidate).unwrap().resolve().unwrap();
    let fastest = map().axis(Key::PrimarySpeed).map(|at| map().axes()[at].range().1).unwrap();
    let found = equilibrium(&case, fastest / ratio, Direction::Up, &SolveOptions::default()).unwrap();
    assert!(found.primary_speed() > 0.99 * fastest, "{:?} {} {fastest}", found.forces, found.primary_speed());
}

/// The drive of a Baja car, with no losses besides friction.
fn gx9(changes: &[(&str, &str)]) -> Case {
    let mut case = Case::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/drive/gx9.toml")).unwrap();
    case.set("losses.include", "off").unwrap();
    changes.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    case
}

/// A search over seven points of the shift, and the map of this accuracy on which it screens.
fn on_a_map_of(accuracy: f64, case: Case, parts: &str) -> (TunePlan, BeltMap) {
    let parts = PartsBox::from_toml("parts", parts).unwrap();
    let options = TuneOptions { points: 7, confirmed: 10, ..TuneOptions::new(TARGET) };
    let plan = TunePlan::new(case, parts, options).unwrap();
    let solve = SolveOptions { tolerance: 0.01 * accuracy, ..SolveOptions::default() };
    let map = plan.map(MapOptions { accuracy, solve, ..MapOptions::default() }).unwrap().build(&KeepNothing).unwrap();
    (plan, map)
}

/// Cells of a coarse map reach far over the slip limit, and have no values. Drives lie in them that hold with a third
/// of the friction to spare: they shift, as full solutions have them.
#[test]
fn drives_that_hold_shift_however_coarse_the_map() {
    let parts = r#"
        [helix]
        secondary.actuator.helix_angle = ["38 deg"]
        [rest.own]
        primary.actuator.mass = "134 g"
        [rest.loose]
        primary.actuator.mass = "122 g"
        primary.spring.rate = "45 lbf/in"
        primary.spring.preload = "50 lbf"
        secondary.spring.pretension = "40 deg"
    "#;
    let (plan, map) = on_a_map_of(1e-1, gx9(&[]), parts);
    let ranking = plan.search(&map, &|| ()).unwrap();
    assert_eq!(ranking.tunes.len(), 2, "{:?}", ranking.refused);
    assert!(ranking.in_full > 0, "no point lies beside the slip limit");
    for tune in &ranking.tunes {
        assert!(tune.merits.smallest_slip_reserve > 0.25, "{:?}", tune.merits);
        let full = tune.confirmed.as_ref().unwrap();
        assert!(full.points >= 7 && full.failures.is_empty(), "{full:?}");
        let reserve = full.merits.unwrap().smallest_slip_reserve;
        assert!((reserve - tune.merits.smallest_slip_reserve).abs() < 0.02, "{full:?} {:?}", tune.merits);
        assert!(full.largest_difference < 0.02 * TARGET, "{full:?}");
    }
}

/// A belt that is clamped tightly sinks into its grooves, and the primary comes to its stop before the ratio to which a
/// belt without load would shift: the shift ends there, where the stop carries nothing yet.
#[test]
fn a_shift_ends_where_the_primary_comes_to_its_stop() {
    let parts = r#"
        [all.tight]
        primary.actuator.mass = "170 g"
        primary.spring.rate = "45 lbf/in"
        primary.spring.preload = "50 lbf"
        secondary.actuator.helix_angle = "28 deg"
        secondary.spring.pretension = "100 deg"
    "#;
    let (plan, map) = on_a_map_of(3e-2, gx9(&[]), parts);
    let ranking = plan.search(&map, &|| ()).unwrap();
    let tune = ranking.tunes.first().unwrap_or_else(|| panic!("{:?}", ranking.refused));
    let last = tune.shift.last().unwrap();
    assert!((last.travels.0 - 19.05e-3).abs() < 2e-6, "{last:?}");
    assert!(last.ratio > *ranking.ratios.last().unwrap() + 0.01, "{last:?}");
    assert_eq!((tune.last_ratio, tune.points), (last.ratio, tune.shift.len()));
    let case = plan.parts().case(&gx9(&[]), 0).unwrap().resolve().unwrap();
    let full = equilibrium(&case, last.secondary_speed, Direction::Up, &SolveOptions::default()).unwrap();
    let belt = full.forces.primary_belt;
    assert!(full.forces.stop.unwrap_or(0.0) < 0.03 * belt, "{:?}", full.forces);
    let confirmed = tune.confirmed.as_ref().unwrap();
    assert!(confirmed.points == tune.points && confirmed.at_stop <= 2, "{confirmed:?}");
    assert!(confirmed.largest_difference < 0.01 * TARGET, "{confirmed:?}");
    let (screened, full) = (tune.merits, confirmed.merits.unwrap());
    assert!((screened.rms_deviation - full.rms_deviation).abs() < 0.005 * TARGET, "{screened:?} {full:?}");
    assert!(sheave::tune::summary(&ranking).contains("1 comes to a stop before that ratio"));
}

/// What is refused as slipping is beyond the limit of the belt: with what helix and spring press it does not carry the
/// torque, and with little more than what it is said to take it does.
#[test]
fn a_combination_that_slips_is_refused_by_the_limit_of_the_belt() {
    let case = gx9(&[("sheave.friction_coefficient", "0.2")]);
    let (plan, map) = on_a_map_of(1e-1, case.clone(), "[helix]\nsecondary.actuator.helix_angle = [\"45 deg\"]");
    let first = plan.case();
    let (actuation, engine) = (first.parts.actuation.as_ref().unwrap(), first.parts.engine.as_ref().unwrap());
    let ratio = 2.5;
    let screen = Screen::new(&map).unwrap();
    let shift = screen.shift(first, actuation, engine, (&[ratio], TARGET), &mut Work::default());
    let Err(Unfit::Slips { speed, torque, presses, needs, .. }) = shift else { panic!("{shift:?}") };
    assert!(presses < 0.9 * needs, "{presses} N of {needs} N");
    let reserve = |force: f64| {
        let mut case = case.clone();
        for (key, value) in [
            ("drive.ratio", ratio.to_string()),
            ("drive.free", "primary_radius".to_owned()),
            ("operating_point.primary_speed", format!("{speed} rad/s")),
            ("operating_point.primary_torque", format!("{torque} N*m")),
            ("operating_point.secondary_axial_force", format!("{force} N")),
        ] {
            case.set(key, &value).unwrap();
        }
        let solved = sheave::drive::solve(&case.resolve().unwrap(), &SolveOptions::default()).ok()?;
        let [primary, secondary] = sheave::result::utilizations(&solved).unwrap();
        Some(1.0 - primary.abs().max(secondary.abs()))
    };
    assert!(reserve(presses).is_none_or(|reserve| reserve < 0.02), "{:?}", reserve(presses));
    assert!(reserve(1.05 * needs).is_some_and(|reserve| reserve > 0.0), "{:?}", reserve(1.05 * needs));
}

#[test]
fn bad_parts_are_refused_with_the_reason() {
    let text = |spring: &str, pretension: &str| {
        format!(
            r#"
            [flyweight.1072]
            primary.actuator.mass = "72 g"
            primary.actuator.coefficients = "39.467, 39.32, 38.353, 37.442, 37.967 mm"
            [primary_spring]
            one = {{ primary.spring.free_length = "138 mm", primary.spring.rate = "1.4 N/mm" }}
            other = {{ {spring} }}
            [rest.red]
            secondary.spring.preload = "117 N"
            secondary.spring.rate = "4.27 N/mm"
            secondary.spring.torsion_rate = "4.55 N*m/rad"
            secondary.spring.pretension = "{pretension}"
            secondary.actuator.helix_angle = "32 deg"
            "#
        )
    };
    let refused = |spring: &str| {
        let parts = PartsBox::from_toml("parts", &text(spring, "66 deg")).unwrap();
        let ranking = plan(parts, 0).search(map(), &|| ()).unwrap();
        let counts: Vec<(usize, String)> =
            ranking.refused.iter().map(|refused| (refused.count, refused.example.clone())).collect();
        (ranking.tunes.len(), counts)
    };
    // A spring that is compressed beyond its solid length.
    let solid = [
        r#"primary.spring.free_length = "106 mm""#,
        r#"primary.spring.rate = "8.2 N/mm""#,
        r#"primary.spring.solid_length = "45 mm""#,
    ]
    .join(", ");
    let (_, counts) = refused(&solid);
    assert!(counts.iter().any(|(count, why)| *count == 1 && why.contains("solid length")), "{counts:?}");
    // A spring shorter than its place.
    let (_, counts) = refused(r#"primary.spring.free_length = "40 mm", primary.spring.rate = "8.2 N/mm""#);
    assert!(counts.iter().any(|(count, why)| *count == 1 && why.contains("free length")), "{counts:?}");
    // A spring so stiff that nothing balances it.
    let (_, counts) = refused(r#"primary.spring.free_length = "300 mm", primary.spring.rate = "80 N/mm""#);
    assert!(counts.iter().any(|(count, _)| *count == 1), "{counts:?}");
}

/// A map that was made with another belt, other sheaves, another edition or other losses tells nothing of this case.
#[test]
fn a_map_of_another_case_is_refused() {
    let checked = |changes: &[(&str, &str)]| {
        let mut case = drive();
        changes.iter().for_each(|(key, value)| case.set(key, value).unwrap());
        let options = TuneOptions { points: 3, confirmed: 0, ..TuneOptions::new(TARGET) };
        let plan = TunePlan::new(case, whole_box(), options).unwrap();
        let checked = plan.check_map(map());
        if checked.is_err() {
            // A search refuses it as well.
            assert!(plan.search(map(), &|| ()).is_err());
        }
        checked
    };
    let differs = |changes: &[(&str, &str)]| match checked(changes) {
        Err(TuneError::OtherMap { key, map, case }) => (key, map, case),
        other => panic!("{changes:?}: {other:?}"),
    };
    let said = |key, map: &str, case: &str| (key, map.to_owned(), case.to_owned());
    let changed = differs(&[("sheave.friction_coefficient", "0.2")]);
    assert_eq!(changed, said("sheave.friction_coefficient", "0.4", "0.2"));
    let changed = differs(&[("belt.bending_stiffness", "0.5 N*m^2")]);
    assert_eq!(changed, said("belt.bending_stiffness", "0.2602 N·m²", "0.5 N·m²"));
    assert_eq!(differs(&[("losses.include", "on")]), said("losses.include", "\"off\"", "\"on\""));
    assert_eq!(differs(&[("edition", "published")]), said("edition", "\"consistent\"", "\"published\""));
    assert_eq!(differs(&[("drive.center_distance", "267 mm")]), said("drive.center_distance", "266.4 mm", "267 mm"));
    assert_eq!(differs(&[("belt.mass_per_length", "0.36 kg/m"), ("edition", "string")]).0, "edition");
    // One quantity in another unit is the same, and what the map does not depend on may differ: the engine, and losses
    // that neither tells.
    for same in [
        [("belt.length", "104.14 cm"), ("sheave.half_angle", "0.209439510239 rad")],
        [("engine.throttle", "0.41"), ("secondary.actuator.helix_radius", "44 mm")],
        [("belt.loss_tangent", "0.2"), ("losses.gear_efficiency", "0.9")],
    ] {
        assert!(checked(&same).is_ok(), "{same:?}: {:?}", checked(&same));
    }
    // As a file has it, the map is the same.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.csv");
    MapFormat::Csv.write(map(), &mut std::fs::File::create(&path).unwrap()).unwrap();
    assert!(plan(whole_box(), 0).check_map(&BeltMap::read(&path).unwrap()).is_ok());
}

/// With losses on, map and full solutions tell one efficiency: that with losses.
#[test]
fn efficiencies_of_one_tune_are_of_one_kind() {
    let mut case = drive();
    case.set("losses.include", "on").unwrap();
    let parts = r#"
        [all.1072]
        primary.actuator.mass = "72 g"
        primary.actuator.coefficients = "39.467, 39.32, 38.353, 37.442, 37.967 mm"
        primary.spring.free_length = "144 mm"
        primary.spring.rate = "1.2 N/mm"
        secondary.spring.preload = "117 N"
        secondary.spring.rate = "4.27 N/mm"
        secondary.spring.torsion_rate = "4.55 N*m/rad"
        secondary.spring.pretension = "22 deg"
        secondary.actuator.helix_angle = "42 deg"
    "#;
    let parts = PartsBox::from_toml("parts", parts).unwrap();
    let options = TuneOptions { points: 3, confirmed: 1, ..TuneOptions::new(TARGET) };
    let plan = TunePlan::new(case, parts, options).unwrap();
    let solve = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
    let options = MapOptions { accuracy: 5e-2, solve, max_points: 300, ..MapOptions::default() };
    let map = plan.map(options).unwrap().build(&KeepNothing).unwrap();
    let ranking = plan.search(&map, &|| ()).unwrap();
    let tune = ranking.tunes.first().unwrap_or_else(|| panic!("{:?}", ranking.refused));
    let full = tune.confirmed.as_ref().unwrap();
    assert_eq!(full.points, 3, "{full:?}");
    let full = full.merits.unwrap();
    assert!((full.mean_efficiency - tune.merits.mean_efficiency).abs() < 0.01, "{full:?} {:?}", tune.merits);
    // What friction alone takes is far from that.
    let engine = plan.case().parts.engine.as_ref().unwrap();
    let elastic = tune.shift.iter().map(|point| {
        let torque = engine.torque(point.primary_speed).value;
        let at = map.at(&[point.ratio, point.primary_speed, torque, point.slack_tension]).unwrap();
        at.efficiency().unwrap()
    });
    let elastic = elastic.sum::<f64>() / tune.shift.len() as f64;
    assert!(elastic > tune.merits.mean_efficiency + 0.02, "{elastic} {:?}", tune.merits);
}

#[test]
fn what_a_search_needs_is_said() {
    let said = |case: Case, text: &str| {
        let parts = PartsBox::from_toml("parts", text).unwrap();
        TunePlan::new(case, parts, TuneOptions::new(TARGET)).map(|_| ()).unwrap_err().to_string()
    };
    let masses = "[flyweight]\nprimary.actuator.mass = [\"60 g\", \"70 g\"]";
    assert!(said(drive(), masses).contains("none of the 2 combinations"));
    let parts = PartsBox::from_toml("parts", masses).unwrap();
    let wrong = TunePlan::new(drive(), parts, TuneOptions::new(-1.0));
    assert!(matches!(wrong, Err(TuneError::Parameter { what: "the target", .. })));
    // In rpm, with the engine's range: also where a map is given, for which none is planned.
    let wrong = TunePlan::new(drive(), whole_box(), TuneOptions::new(340.0 * RPM)).map(|_| ()).unwrap_err().to_string();
    let expected = "the target is 340 rpm: expected a speed above 1800 rpm, from which the engine is known, and below \
                    3820 rpm, at which its governor leaves 40 % of the torque";
    assert_eq!(wrong, expected);
    // A box made by hand is checked as one that is read.
    let part = Part { name: "long".into(), settings: vec![("belt.length".into(), "1.1 m".into())] };
    let parts = PartsBox { kinds: vec![PartKind { name: "belt".into(), parts: vec![part] }] };
    let wrong = TunePlan::new(drive(), parts, TuneOptions::new(TARGET));
    assert!(matches!(wrong, Err(TuneError::Box(PartsProblem::Shared { key: Key::BeltLength, .. }))));
}
