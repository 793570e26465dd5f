//! An hour of the automated test, as fast as it can: the efficiency that comes out is the one that went in.

#![allow(clippy::unwrap_used)]

use rig_logger::calibration::Calibration;
use rig_logger::hardware::Hardware;
use rig_logger::journal::Recorder;
use rig_logger::runs::{self, Metadata};
use rig_logger::session::{OperatingLimits, Session};
use rig_logger::simulated::SimulatedRig;
use rig_logger::steady::{Nobody, Plan, run};

fn torque_of_engine(rpm: f64) -> f64 {
    let text = include_str!("../data/engine-power.csv");
    let points: Vec<(f64, f64)> = text
        .lines()
        .map(|line| line.split_once(',').unwrap())
        .map(|(rpm, hp)| (rpm.parse::<f64>().unwrap(), hp.parse::<f64>().unwrap()))
        .map(|(rpm, hp)| (rpm, hp * 745.7 / (rpm * std::f64::consts::PI / 30.0)))
        .collect();
    let after = points.iter().position(|point| point.0 > rpm).unwrap();
    let ((x0, y0), (x1, y1)) = (points[after - 1], points[after]);
    y0 + (y1 - y0) * (rpm - x0) / (x1 - x0)
}

#[test]
fn an_hour_of_steady_states_gives_back_the_efficiency_of_the_model() {
    let parent = tempfile::tempdir().unwrap();
    let mut rig = SimulatedRig::new(false);
    let metadata = Metadata::now("simulated", &rig.identity().unwrap(), Calibration::THESIS);
    let folder = runs::create(parent.path(), &metadata).unwrap();
    let recorder = Recorder::create(&folder).unwrap();
    let mut session = Session::new(rig, Calibration::THESIS, OperatingLimits::RIG, recorder);
    let plan = Plan { brake_step_ms: 40, read_ms: 10_000, passes: 5, ..Plan::THESIS };
    let points = run(&mut session, &plan, &mut Nobody);
    let seconds = session.status().time as f64 * 1e-6;
    assert_eq!(session.cause(), None, "{:?}", session.status());
    assert!(session.finish().1);
    let exported = runs::export(&folder).unwrap();
    // The table made from the journal is that of the test, but for disturbed transfers, whose places it leaves empty.
    let numbers = |text: &str| -> Vec<Vec<String>> {
        text.lines().skip(1).map(|row| row.split(',').map(str::to_owned).collect()).collect()
    };
    let table = numbers(&std::fs::read_to_string(folder.join("points.csv")).unwrap());
    let live = numbers(&runs::points_table(&points));
    assert_eq!(table.len(), live.len());
    for (row, wanted) in table.iter().zip(&live) {
        assert_eq!([&row[0], &row[1], &row[11]], [&wanted[0], &wanted[1], &wanted[11]], "{row:?} {wanted:?}");
        for column in [2, 4, 6, 9, 10] {
            let [found, wanted] = [row, wanted].map(|row| row[column].parse::<f64>().unwrap());
            assert!((found - wanted).abs() <= 2e-4 * wanted.abs() + 0.011, "{column}: {row:?} {wanted}");
        }
    }
    let settled = points.iter().filter(|point| point.settled).count();
    let mut errors: Vec<f64> = points
        .iter()
        .filter(|point| point.settled)
        .map(|point| {
            let ((p, _), (s, _), (t, _)) = (point.primary_rpm, point.secondary_rpm, point.torque);
            let measured = t * s / (torque_of_engine(p) * p);
            // What the plant loses beside the belt: the drag of its own bearings, 0.002 N·m·s.
            let drag = 0.002 * s * std::f64::consts::PI / 30.0;
            let model = rig_logger::simulated::drive::efficiency(p / s, torque_of_engine(p))
                - drag * s / (torque_of_engine(p) * p);
            measured - model
        })
        .collect();
    errors.sort_by(f64::total_cmp);
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64).sqrt();
    println!(
        "{seconds:.0} s, {} points, {settled} settled, efficiency: mean error {mean:.4}, rms {rms:.4}",
        points.len()
    );
    println!("first {:?}\nlast {:?}", points.first(), points.last());
    if let Some(keep) = std::env::var_os("RIG_KEEP_RUN") {
        std::fs::rename(&folder, keep).unwrap();
    }
    assert!(seconds > 1800.0 && points.len() > 100, "{seconds} {}", points.len());
    assert_eq!(exported.points, points.len());
    assert_eq!(exported.bad_lines, 0);
    assert!(settled * 10 > points.len() * 8);
    assert!(mean.abs() < 0.01 && rms < 0.02, "{mean} {rms}");
}
