//! The library as a program uses it: solve, sweep, limits, and results that are read back.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::sync::Mutex;

use serde_json::Value;
use sheave::prelude::*;

fn rough() -> SolveOptions {
    SolveOptions { tolerance: 1e-3, ..SolveOptions::default() }
}

#[test]
fn a_case_is_built_with_units_or_in_si_and_solved() {
    let text = Case::base().with("operating_point.slack_tension", "120 N").unwrap();
    let typed = Case::base().with_si(Key::SlackTension, 120.0).unwrap();
    let (text, typed) = (sheave::solve_with(&text, &rough()).unwrap(), sheave::solve_with(&typed, &rough()).unwrap());
    assert_eq!(text.result.primary, typed.result.primary);
    assert!((text.result.primary.exit_tension - 120.0).abs() < 1e-6);
    let error = Case::base().with("operating_point.slack_tension", "3 kg").unwrap_err();
    assert!(error.to_string().contains("`operating_point.slack_tension` = 3 kg"), "{error}");
}

#[test]
fn what_is_wrong_is_an_error_with_its_place_and_hint() {
    let case = Case::from_toml("my.toml", "[drive]\nprimary_radius = 68").unwrap_err();
    assert_eq!((case.places()[0].source.name.as_str(), case.places()[0].given()), ("my.toml", "68"));
    let hint = sheave::Error::from(case).hint().unwrap();
    assert!(hint.contains("mm"), "{hint}");
}

#[test]
fn a_sweep_as_iterator_and_as_table_say_the_same() {
    let axes = || [Axis::parse("operating_point.slack_tension=100 N..200 N:3").unwrap()];
    let table = sheave::sweep_table(Case::base(), axes(), rough()).unwrap();
    let sweep = sheave::sweep(Case::base(), axes(), rough()).unwrap();
    assert_eq!(sweep.size_hint(), (3, Some(3)));
    let mut count = 0;
    for (row, item) in sweep.enumerate() {
        let (point, outcome) = item.unwrap();
        assert_eq!(point.varied.len(), 1);
        let (force, listed) = (outcome.unwrap().result.primary.axial_force, table.number(row, "primary.axial_force"));
        assert!((force - listed).abs() < 1e-3 * listed, "{row}: {force} {listed}");
        count += 1;
    }
    assert_eq!(count, table.rows.len());
}

/// Points behind one another are solved on meshes that hardly differ: few are refined twice, and what is left out of
/// one is not put in again on the next.
#[test]
fn points_behind_one_another_share_their_meshes() {
    const TORQUES: usize = 16;
    let axes = [
        Axis::parse("operating_point.slack_tension=60 N..300 N:4").unwrap(),
        Axis::parse(&format!("operating_point.primary_torque=3..18:{TORQUES}")).unwrap(),
    ];
    let options = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
    let (mut evaluations, mut meshes, mut points) = (0, 0, 0);
    for (index, item) in sheave::sweep(Case::base(), axes, options).unwrap().enumerate() {
        let solved = item.unwrap().1.unwrap().solved;
        if index % TORQUES > 0 {
            evaluations += solved.stats.jacobian_points;
            meshes += solved.stats.meshes;
            points += 1;
        }
    }
    assert_eq!(points, 4 * (TORQUES - 1));
    assert!(evaluations < 1750 * points, "{} evaluations with derivatives a point", evaluations / points);
    assert!(10 * meshes < 22 * points, "{meshes} meshes for {points} points");
}

/// What begins a chain is solved from what begins another one with the same pulley radii, be the slack tension a third
/// higher: the belt need not be laid anew.
#[test]
fn chains_begin_where_it_takes_the_least() {
    let axes = [
        Axis::parse("drive.ratio=0.72..0.866:2").unwrap(),
        Axis::parse("operating_point.slack_tension=60 N..300 N:8").unwrap(),
        Axis::parse("operating_point.primary_torque=3..4:2").unwrap(),
    ];
    let options = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
    let study = sheave::study::Study::new(Case::base(), axes.to_vec(), options).unwrap();
    let found = Mutex::new(Vec::new());
    let first_of_chain = |index: usize| index.is_multiple_of(2);
    sheave::study::visit(&study, Some(1), first_of_chain, |index, _, outcome| {
        let solved = &outcome.map_err(std::io::Error::other)?.solved;
        found.lock().unwrap().push((index, solved.stats.factorisations));
        Ok(())
    })
    .unwrap();
    let mut found = found.into_inner().unwrap();
    found.sort_unstable();
    assert_eq!(found.len(), 16);
    // From nothing it is some 60 each.
    let second_ratio: usize = found[8..].iter().map(|(_, factorisations)| factorisations).sum();
    assert!(second_ratio < 8 * 25, "{found:?}");
}

/// A chain is solved from its tight end, whichever way its axis counts: rows of both ways are those of their points,
/// and take as much work.
#[test]
fn chains_run_from_the_tight_belt_to_the_loose_one() {
    let work = |from: f64, to: f64| {
        let axis = Axis::parse(&format!("operating_point.slack_tension={from}..{to} N:8")).unwrap();
        let study = sheave::study::Study::new(Case::base(), vec![axis], rough()).unwrap();
        let found = Mutex::new(Vec::new());
        sheave::study::visit(
            &study,
            Some(1),
            |_| true,
            |index, _, outcome| {
                let outcome = outcome.map_err(std::io::Error::other)?;
                let given = from + (to - from) * index as f64 / 7.0;
                assert!((outcome.result.primary.exit_tension - given).abs() < 1e-6 * given, "point {index}");
                found.lock().unwrap().push((index, outcome.solved.stats.factorisations));
                Ok(())
            },
        )
        .unwrap();
        found.into_inner().unwrap()
    };
    let (up, down) = (work(60.0, 300.0), work(300.0, 60.0));
    let points = |found: &[(usize, usize)]| found.iter().map(|(index, _)| *index).collect::<Vec<_>>();
    assert_eq!(points(&up), [7, 6, 5, 4, 3, 2, 1, 0]);
    assert_eq!(points(&down), [0, 1, 2, 3, 4, 5, 6, 7]);
    let costs = |found: Vec<(usize, usize)>| found.into_iter().map(|(_, factorisations)| factorisations);
    assert_eq!(costs(up).collect::<Vec<_>>(), costs(down).collect::<Vec<_>>());
}

/// What intervals have become too long for along a chain is foreseen: most of its points take one mesh.
#[test]
fn points_of_a_chain_take_one_mesh() {
    let axes = ["operating_point.slack_tension=100..300 N:3", "operating_point.primary_torque=3..18:16"];
    let axes = axes.map(|axis| Axis::parse(axis).unwrap());
    let options = SolveOptions { tolerance: 1e-4, ..SolveOptions::default() };
    let points = sheave::sweep(Case::base(), axes, options).unwrap();
    let meshes: Vec<usize> = points.map(|item| item.unwrap().1.unwrap().solved.solution.history().len()).collect();
    // The first few of a chain tell how it goes on.
    let once = meshes.chunks(16).flat_map(|chain| &chain[5..]).filter(|meshes| **meshes == 1).count();
    assert!(once >= 25, "{once}: {meshes:?}");
}

/// A belt without bending stiffness, too, is solved from its neighbour, whose nodes it needs.
#[test]
fn strings_are_solved_from_one_another() {
    let mut case = Case::base();
    for (key, value) in [("edition", "string"), ("sheave.slip_threshold", "20 mm/s"), ("belt.loss_tangent", "0")] {
        case.set(key, value).unwrap();
    }
    let axis = Axis::parse("operating_point.slack_tension=100 N..200 N:5").unwrap();
    for (index, item) in sheave::sweep(case, [axis], SolveOptions::default()).unwrap().enumerate() {
        let solved = item.unwrap().1.unwrap().solved;
        let (steps, iterations) = (solved.continuation_steps, solved.stats.newton_iterations);
        assert!(index == 0 || (steps == 1 && iterations < 60), "point {index}: {steps} steps, {iterations} iterations");
    }
}

#[test]
fn a_result_is_read_back_as_it_was_written() {
    let options = SolveOptions { sensitivities: true, ..rough() };
    let result = sheave::solve_with(&Case::base(), &options).unwrap().result;
    let text = serde_json::to_string(&result).unwrap();
    let read: DriveResult<Value> = serde_json::from_str(&text).unwrap();
    assert_eq!(serde_json::to_value(&read).unwrap(), serde_json::to_value(&result).unwrap());
    assert_eq!(read.primary, result.primary);
    assert_eq!(read.sensitivities, result.sensitivities);
}

#[test]
fn limits_and_the_best_clamp_of_a_case() {
    let options = LimitOptions { solve: rough(), ..LimitOptions::default() };
    let limit = sheave::largest_torque(&Case::base(), &options).unwrap();
    assert!(limit.value > 18.0, "the base case carries 18 N·m: {limit:?}");
    let best = sheave::optimum(&Case::base(), &rough()).unwrap();
    let here = sheave::solve_with(&Case::base(), &rough()).unwrap().result.efficiency.overall.unwrap();
    assert!(best.state.overall_efficiency >= here - 1e-4, "{} {here}", best.state.overall_efficiency);
}

/// Ended from outside: a solve fails at once, and a study hands over no row that could be mistaken for a result.
#[test]
fn work_that_is_cancelled_ends() {
    use sheave::study::{Axis, Study, StudyError};
    let cancel = sheave::Cancel::new();
    let outcome = sheave::cancellable(&cancel, || sheave::solve_with(&Case::base(), &rough()));
    assert!(outcome.is_ok());
    cancel.cancel();
    let outcome = sheave::cancellable(&cancel, || sheave::solve_with(&Case::base(), &rough()));
    assert!(outcome.is_err_and(|error| error.to_string().contains("cancelled")));
    assert!(sheave::solve_with(&Case::base(), &rough()).is_ok(), "the handle outlives its work");

    let axes = [Axis::parse("drive.ratio=0.9..1.2:8").unwrap()];
    let study = Study::new(Case::base(), axes, rough()).unwrap();
    let solved = std::sync::atomic::AtomicUsize::new(0);
    let keep = |row: sheave::study::Row| {
        if cancel.is_cancelled() {
            assert!(row.failure().is_some(), "a solution after the end");
            return Err(std::io::ErrorKind::Interrupted.into());
        }
        solved.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        Ok(())
    };
    let run = sheave::cancellable(&cancel, || sheave::study::run(&study, Some(2), |_| true, keep));
    assert!(matches!(run, Err(StudyError::Cancelled)), "{run:?}");
    assert_eq!(solved.into_inner(), 0);
}

/// The parts of a study cover it, and what one gives on its own is what it gives as part of the whole.
#[test]
fn a_study_is_computed_in_parts() {
    use sheave::study::{Axis, Row, Study, run, table};
    let axes = || {
        ["operating_point.slack_tension=100..250 N:20", "drive.ratio=0.9..1.1:2"].map(|text| Axis::parse(text).unwrap())
    };
    let study = Study::new(Case::base(), axes(), rough()).unwrap();
    let parts = study.parts(0);
    assert_eq!(parts, [0..32, 32..40]);
    assert_eq!(study.parts(33), vec![0..40]);
    let whole = table(&study, Some(1)).unwrap();
    let rows = Mutex::new(Vec::new());
    let keep = |row: Row| {
        rows.lock().unwrap().push(row);
        Ok(())
    };
    run(&study, Some(1), |index| parts[1].contains(&index), keep).unwrap();
    let rows = rows.into_inner().unwrap();
    assert_eq!(rows.len(), 8);
    for row in rows {
        assert_eq!(row.cells, whole.rows[row.index], "point {}", row.index);
    }
    // A part is done before the next is begun, so that whoever stops has the rows that the time has paid for.
    let order = Mutex::new(Vec::new());
    let keep = |row: Row| {
        order.lock().unwrap().push(row.index);
        Ok(())
    };
    run(&study, Some(1), |_| true, keep).unwrap();
    let order = order.into_inner().unwrap();
    assert!(order.len() == 40 && order[..32].iter().all(|index| parts[0].contains(index)), "{order:?}");
}
