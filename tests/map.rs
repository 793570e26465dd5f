//! Belt maps: their error against solutions at other points, their files, interruptions, threads.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use sheave::beltmap::{
    BeltMap, Keep, KeepNothing, MapAxis, MapError, MapFormat, MapOptions, MapPlan, Outside, Quantity,
};
use sheave::case::{Case, Key};
use sheave::drive::SolveOptions;
use sheave::result::DriveResult;
use sheave::study::Row;
use std::collections::HashMap;
use std::path::Path;
use std::process::{Command, Output};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn options(accuracy: f64) -> MapOptions {
    let solve = SolveOptions { tolerance: 1e-5, ..SolveOptions::default() };
    MapOptions { accuracy, solve, ..MapOptions::default() }
}

fn map(case: Case, axes: &[&str], options: MapOptions) -> BeltMap {
    let axes = axes.iter().map(|axis| MapAxis::parse(axis).unwrap()).collect();
    MapPlan::new(case, axes, options).unwrap().build(&KeepNothing).unwrap()
}

fn quiet() -> Case {
    Case::base().with("losses.include", "off").unwrap()
}

/// A quantity of a map as the result object has it.
fn solved<I>(result: &DriveResult<I>, quantity: Quantity) -> f64 {
    let (primary, secondary) = (&result.primary, &result.secondary);
    match quantity {
        Quantity::PrimaryAxialForce => primary.axial_force,
        Quantity::SecondaryAxialForce => secondary.axial_force,
        Quantity::PrimarySpeed => primary.speed,
        Quantity::PrimaryTorque => primary.torque,
        Quantity::SecondaryTorque => secondary.torque,
        Quantity::SpeedLoss => 1.0 - secondary.speed * secondary.radius / (primary.speed * primary.radius),
        Quantity::PrimaryUtilization => primary.friction_utilization,
        Quantity::SecondaryUtilization => secondary.friction_utilization,
        Quantity::PrimaryRadius => primary.radius,
        Quantity::SecondaryRadius => secondary.radius,
        Quantity::SlackTension => primary.exit_tension,
        Quantity::TightTension => primary.entry_tension,
        Quantity::Losses => result.losses.as_ref().unwrap().total,
    }
}

/// Shares in [0, 1] without a pattern: a linear congruential generator of Knuth's.
fn shares(count: usize) -> Vec<f64> {
    let mut state = 20_261_122_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..count).map(|_| next()).collect()
}

/// Largest error of a map at random points, against solutions from nothing.
fn error_at_random_points(map: &BeltMap, case: &Case, points: usize, shares_within: f64) -> f64 {
    let largest = |quantity: Quantity| {
        let of = |axis: &MapAxis| axis.breakpoints().to_vec();
        let grid: Vec<Vec<f64>> = map.axes().iter().map(of).collect();
        let corners = grid.iter().fold(vec![Vec::new()], |all: Vec<Vec<f64>>, axis| {
            all.iter().flat_map(|at| axis.iter().map(move |x| [at.as_slice(), &[*x]].concat())).collect()
        });
        corners.iter().filter_map(|at| map.at(at).ok()?.value(quantity).ok()).fold(0.0_f64, |a, b| a.max(b.abs()))
    };
    let largest: Vec<f64> = map.quantities().iter().map(|quantity| largest(*quantity)).collect();
    let draws = shares(points * map.axes().len());
    let mut worst = 0.0_f64;
    for draw in draws.chunks(map.axes().len()) {
        let at: Vec<f64> = map
            .axes()
            .iter()
            .zip(draw)
            .map(|(axis, share)| axis.range().0 + share * (axis.range().1 - axis.range().0))
            .collect();
        let point = map.at(&at).unwrap();
        let mut case = case.clone().with("drive.free", "primary_radius").unwrap();
        for (axis, value) in map.axes().iter().zip(&at) {
            case = case.with_si(axis.key(), *value).unwrap();
        }
        let outcome = sheave::solve_with(&case, &options(0.1).solve).unwrap();
        for (quantity, largest) in map.quantities().iter().zip(&largest) {
            let (found, exact) = (point.value(*quantity).unwrap(), solved(&outcome.result, *quantity));
            let share =
                matches!(quantity, Quantity::SpeedLoss | Quantity::PrimaryUtilization | Quantity::SecondaryUtilization);
            let scale = if share { 1.0 } else { exact.abs().max(0.1 * largest) };
            worst = worst.max((found - exact).abs() / scale);
        }
        let efficiency = outcome.result.efficiency.overall.unwrap();
        assert!((point.efficiency().unwrap() - efficiency).abs() < shares_within, "{at:?}");
        assert!((point.slip_reserve().unwrap() - outcome.result.slip_reserve).abs() < shares_within, "{at:?}");
        if map.quantities().contains(&Quantity::Losses) {
            let with = outcome.result.efficiency.overall_with_losses.unwrap();
            assert!((point.efficiency_with_losses().unwrap() - with).abs() < shares_within, "{at:?}");
        }
    }
    worst
}

#[test]
fn a_map_holds_its_error_at_points_that_nobody_looked_at() {
    let axes = ["ratio=0.9..1.3", "slack_tension=80..200 N"];
    let map = map(Case::base(), &axes, options(3e-3));
    let report = map.report();
    assert!(report.reached && report.error.largest <= 3e-3 && report.checks >= report.usable_cells, "{report:?}");
    assert_eq!((report.solved, report.usable_cells), (report.nodes, report.cells));
    let worst = error_at_random_points(&map, &Case::base(), 8, 5e-3);
    assert!(worst <= 3e-3, "{worst:.2e} at random points, {:.2e} at check points", report.error.largest);
    // Linear interpolation of the same table is worse, and the report says so.
    assert!(report.linear_error.largest > report.error.largest);
}

#[test]
fn a_coarse_map_reports_a_larger_error() {
    let axes = ["ratio=0.8..1.8", "torque=2..40 N*m"];
    let coarse = map(quiet(), &axes, MapOptions { max_points: 14, ..options(1e-3) });
    let report = coarse.report();
    assert!(!report.reached, "{report:?}");
    assert_eq!((report.nodes, report.checks), (9, 4));
    assert!(report.error.largest > 1e-3, "{report:?}");
    // And rightly so.
    let worst = error_at_random_points(&coarse, &quiet(), 6, 1.0);
    assert!(worst > 1e-3, "{worst:.2e} at random points, {:.2e} at check points", report.error.largest);
}

#[test]
fn gradients_are_those_of_the_values() {
    let map = map(quiet(), &["ratio=0.9..1.3", "slack_tension=80..200 N"], options(2e-3));
    let at = [1.07, 131.0];
    let point = map.at(&at).unwrap();
    for quantity in map.quantities() {
        for (axis, (slope, step)) in point.slopes(*quantity).unwrap().iter().zip([1e-5, 1e-3]).enumerate() {
            let moved = |sign: f64| {
                let mut at = at;
                at[axis] += sign * step;
                map.at(&at).unwrap().value(*quantity).unwrap()
            };
            let difference = (moved(1.0) - moved(-1.0)) / (2.0 * step);
            let size = point.value(*quantity).unwrap().abs() / at[axis];
            assert!((slope - difference).abs() < 1e-6 * size, "{}: {slope} {difference}", quantity.name());
        }
    }
}

#[test]
fn nothing_is_said_beyond_the_map_and_beyond_the_slip_limit() {
    let axes = ["torque=2..100 N*m", "slack_tension=2..200 N"];
    let few = MapOptions { max_points: 30, least_speed_efficiency: 0.95, ..options(2e-2) };
    let map = map(quiet(), &axes, few);
    let report = map.report();
    assert!(report.slipping + report.unsolved > 0 && report.usable_cells < report.cells, "{report:?}");
    assert!(matches!(map.at(&[100.0, 2.0]), Err(Outside::Slipping)));
    assert!(map.at(&[2.0, 200.0]).is_ok());
    assert!(matches!(map.at(&[101.0, 100.0]), Err(Outside::Range { key: Key::PrimaryTorque, .. })));
    assert!(matches!(map.at(&[f64::NAN, 100.0]), Err(Outside::Range { .. })));
    assert!(matches!(map.at(&[10.0]), Err(Outside::Coordinates { given: 1, expected: 2 })));
    assert!(map.at(&[10.0, 150.0]).unwrap().value(Quantity::Losses).is_err());
}

#[test]
fn what_cannot_be_mapped_is_refused() {
    let refused = |case: Case, axes: &[&str]| {
        let axes = axes.iter().map(|axis| MapAxis::parse(axis)).collect::<Result<Vec<_>, MapError>>();
        axes.and_then(|axes| MapPlan::new(case, axes, options(1e-3))).unwrap_err().to_string()
    };
    assert!(refused(Case::base(), &[]).contains("needs axes"));
    assert!(refused(Case::base(), &["ratio=1..2", "ratio=1..2"]).contains("twice"));
    let hot = Case::base().with("thermal.heat_transfer", "10 W/K").unwrap();
    let hot = hot.with("thermal.ambient", "25 degC").unwrap();
    assert!(refused(hot, &["ratio=1..2"]).contains("one temperature"));
    let reserve = Case::base().with("operating_point.slip_reserve", "20 %").unwrap();
    assert!(refused(reserve, &["ratio=1..2"]).contains("slip_reserve"));
    let axes = || vec![MapAxis::parse("ratio=1..2").unwrap()];
    let wrong = MapPlan::new(Case::base(), axes(), MapOptions { accuracy: 1e-5, ..options(1e-3) });
    assert!(wrong.unwrap_err().to_string().contains("tolerance"));
}

fn sheave(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.arg("map").args(arguments).env_remove("RUST_LOG").env("NO_COLOR", "1").output().unwrap()
}

const SMALL: [&str; 9] = [
    "--losses",
    "off",
    "--accuracy",
    "1e-2",
    "--tol",
    "1e-4",
    "--over",
    "ratio=0.9..1.1",
    "--over=slack_tension=100..200 N",
];

fn written(path: &Path, arguments: &[&str]) -> Vec<u8> {
    let output = sheave(&[&SMALL[..], arguments, &["--out", path.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{output:?}");
    std::fs::read(path).unwrap()
}

#[test]
fn threads_and_interruptions_change_no_byte_and_files_are_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.csv");
    let one = written(&path, &["--jobs", "1"]);
    assert!(one == written(&path, &["--jobs", "2"]));
    assert!(!folder.path().join("map.csv.journal").exists());
    let map = BeltMap::read(&path).unwrap();
    let mut again = Vec::new();
    MapFormat::Csv.write(&map, &mut again).unwrap();
    assert!(again == one, "what is read and written again is the same");

    let journal = folder.path().join("map.csv.journal");
    let output = sheave(&[&SMALL[..], &["--out", path.to_str().unwrap(), "--json"]].concat());
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((told["command"].as_str(), told["reached"].as_bool()), (Some("map"), Some(true)));
    assert_eq!(told["nodes"].as_u64(), Some(map.report().nodes as u64));
    assert!(told["error"]["largest"].as_f64().unwrap() <= 1e-2 && told["inputs"].is_object());
    assert!(!journal.exists());
}

/// Keeps rows, as long as it may.
#[derive(Default)]
struct Rows {
    rows: Mutex<HashMap<usize, Row>>,
    most: usize,
    added: AtomicUsize,
}

impl Keep for Rows {
    fn kept(&self, point: usize) -> Option<Row> {
        self.rows.lock().unwrap().get(&point).cloned()
    }

    fn keep(&self, row: Row) -> std::io::Result<()> {
        if self.added.fetch_add(1, Ordering::SeqCst) >= self.most {
            return Err(std::io::Error::other("interrupted"));
        }
        self.rows.lock().unwrap().insert(row.index, row);
        Ok(())
    }
}

#[test]
fn an_interrupted_map_is_completed_to_the_same() {
    let axes =
        || ["ratio=0.9..1.1", "slack_tension=100..200 N"].iter().map(|axis| MapAxis::parse(axis).unwrap()).collect();
    let plan = MapPlan::new(quiet(), axes(), options(1e-2)).unwrap();
    let whole = plan.build(&KeepNothing).unwrap();
    let mut rows = Rows { most: 7, ..Rows::default() };
    assert!(plan.build(&rows).is_err());
    assert_eq!(rows.rows.lock().unwrap().len(), 7);
    rows.most = usize::MAX;
    rows.added = AtomicUsize::new(0);
    let completed = plan.build(&rows).unwrap();
    let points = whole.report().nodes + whole.report().checks;
    assert_eq!((rows.added.into_inner(), completed.table()), (points - 7, whole.table()));
    assert_eq!(completed.report(), whole.report());
}

#[test]
fn files_that_are_no_maps_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.csv");
    let text = String::from_utf8(written(&path, &[])).unwrap();
    let said = |text: &str| {
        std::fs::write(&path, text).unwrap();
        BeltMap::read(&path).unwrap_err().to_string()
    };
    assert!(said("a,b\n1,2\n").contains("does not begin as a belt map"));
    let (head, rows) = text.split_once('\n').unwrap();
    assert!(said(&format!("{head}\n")).contains("column"));
    let last = rows.trim_end().rsplit_once('\n').unwrap().0;
    assert!(said(&format!("{head}\n{last}\n")).contains("not those of a grid"));
    let (columns, first) = (rows.lines().next().unwrap(), rows.lines().nth(1).unwrap());
    let twice = format!(
        "{head}\n{columns}\n{first}\n{}",
        rows.lines().skip(1).skip(1).map(|row| format!("{row}\n")).collect::<String>()
    );
    assert!(!said(&twice.replacen(first, "nonsense", 1)).is_empty());
    assert!(BeltMap::read(&folder.path().join("none.csv")).is_err());
}

#[test]
fn netcdf_and_parquet_hold_the_same_numbers() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    let folder = tempfile::tempdir().unwrap();
    let map = map(quiet(), &["ratio=0.9..1.1", "slack_tension=100..200 N"], options(1e-2));
    let table = map.table();
    let forces: Vec<f64> = (0..table.rows.len()).map(|row| table.number(row, "primary.axial_force")).collect();
    let written = |name: &str| {
        let path = folder.path().join(name);
        let mut file = std::fs::File::create(&path).unwrap();
        MapFormat::of(&path).unwrap().write(&map, &mut file).unwrap();
        path
    };

    let path = written("map.nc");
    let mut reader = netcdf3::FileReader::open(&path).unwrap();
    assert_eq!(reader.read_var_f64("ratio").unwrap(), map.axes()[0].breakpoints());
    assert_eq!(reader.read_var_f64("primary_axial_force").unwrap(), forces);
    let set = reader.data_set();
    assert_eq!(set.get_var("primary_axial_force").unwrap().dim_names(), ["ratio", "slack_tension"]);
    assert_eq!(set.get_var_attr_as_string("primary_axial_force_by_slack_tension", "units").unwrap(), "N/(N)");
    assert_eq!(set.get_global_attr_f64("largest_error").unwrap(), [map.report().error.largest]);

    // What an axis prescribes is told by its breakpoints, not a second time.
    let by_torque = self::map(quiet(), &["torque=15..18", "slack_tension=100..200 N"], options(1e-1));
    let path = folder.path().join("torque.nc");
    MapFormat::of(&path).unwrap().write(&by_torque, &mut std::fs::File::create(&path).unwrap()).unwrap();
    let mut reader = netcdf3::FileReader::open(&path).unwrap();
    assert_eq!(reader.read_var_f64("primary_torque").unwrap(), by_torque.axes()[0].breakpoints());
    assert_eq!(reader.data_set().get_var("secondary_torque").unwrap().dim_names(), ["primary_torque", "slack_tension"]);

    let path = written("map.parquet");
    let reader = SerializedFileReader::new(std::fs::File::open(&path).unwrap()).unwrap();
    let metadata = reader.metadata().file_metadata().key_value_metadata().unwrap();
    assert!(
        metadata.iter().any(|pair| pair.key == "sheave_belt_map" && pair.value.as_ref().unwrap().contains("accuracy"))
    );
    assert_eq!(reader.metadata().file_metadata().num_rows(), forces.len() as i64);
}

#[test]
fn bad_arguments_compute_nothing_and_a_missed_accuracy_is_told() {
    for (arguments, said) in [
        (vec!["--over", "ratio=1..2", "--out", "map.txt"], ".nc"),
        (vec!["--over", "ratio=1..2", "--json"], "--out"),
        (vec!["--over", "edition=thesis,published"], "no axis"),
        (vec![], "--over"),
        (vec!["--over", "ratio=1..2", "--accuracy", "7"], "accuracy"),
    ] {
        let output = sheave(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        let message = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(message.contains(said), "{arguments:?} does not say {said}: {message}");
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.csv");
    let over = ["--losses", "off", "--over", "ratio=0.8..1.4", "--over", "slack_tension=70..200 N", "--tol", "1e-5"];
    let few = ["--accuracy", "1e-4", "--max-points", "20", "--json", "--out", path.to_str().unwrap()];
    let output = sheave(&[&over[..], &few].concat());
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(told["reached"].as_bool(), Some(false));
    assert!(told["failure"]["message"].as_str().unwrap().contains("did not suffice"));
    assert!(!BeltMap::read(&path).unwrap().report().reached);
}
