//! How well the real binary measures: speeds from 0 to 9000 rpm under jitter, bounces and gaps, with the bus and the
//! converter at work all the time. The table goes to standard output and to `target/simavr-speed.md`.

#![allow(clippy::unwrap_used)]

mod common;

use std::fmt::Write as _;

use common::{MILLISECOND, frame, schedule_conversions, start};
use rig_core::speed::Reading;
use rig_simulator::pulses::{Disturbance, schedule};
use rig_simulator::{CYCLES_PER_SECOND, PRIMARY_PIN, SECONDARY_PIN};

const CLEAN: Disturbance = Disturbance { jitter: 0.0, bounces: 0, missing: 0.0 };
const SCENARIOS: [(&str, Disturbance); 4] = [
    ("clean", CLEAN),
    ("jitter", Disturbance { jitter: 0.005, ..CLEAN }),
    ("bounces", Disturbance { bounces: 3, ..CLEAN }),
    ("missing", Disturbance { missing: 0.1, ..CLEAN }),
];

/// Primary and secondary speed, rpm. Above 6000 rpm the primary's shortest period of 10 ms is left: it must say so.
const SPEEDS: [(f64, f64); 8] = [
    (0.0, 0.0),
    (150.0, 300.0),
    (800.0, 1300.0),
    (1800.0, 1585.0),
    (2991.0, 3500.0),
    (3800.0, 5000.0),
    (5900.0, 7600.0),
    (9000.0, 9000.0),
];

struct Errors {
    largest: f64,
    squares: f64,
    count: f64,
}

fn add(errors: &mut Errors, reading: &Reading, rpm: f64) {
    let error = reading.speed.rpm_exact() - rpm;
    errors.largest = errors.largest.max(error.abs());
    errors.squares += error * error;
    errors.count += 1.0;
}

/// Errors of both shafts over half a second of readings at 150 Hz, after the speed has been constant for long enough.
fn measure(primary: f64, secondary: f64, with: Disturbance) -> [Errors; 2] {
    let mut bench = start();
    let begin = bench.cycle();
    let settle = if primary > 0.0 { (6.0 * 60_000.0 / primary.min(secondary) + 150.0) as u64 * MILLISECOND } else { 0 };
    let end = begin + settle + CYCLES_PER_SECOND / 2;
    for (pin, rpm, seed) in [(PRIMARY_PIN, primary, 7), (SECONDARY_PIN, secondary, 11)] {
        if rpm > 0.0 {
            schedule(&mut bench, pin, rpm, (begin, end), with, seed);
        }
    }
    schedule_conversions(&mut bench, begin, end);
    bench.run_to(begin + settle).unwrap();
    let mut errors = [(); 2].map(|()| Errors { largest: 0.0, squares: 0.0, count: 0.0 });
    while bench.cycle() < end - 8 * MILLISECOND {
        let frame = frame(&mut bench);
        if primary > 6000.0 {
            assert!(frame.snapshot.primary.too_fast, "{primary} rpm read as {:?}", frame.snapshot.primary);
        } else {
            assert!(!frame.snapshot.primary.too_fast);
            add(&mut errors[0], &frame.snapshot.primary, primary);
        }
        add(&mut errors[1], &frame.snapshot.secondary, secondary);
        bench.run(6 * MILLISECOND).unwrap();
    }
    errors
}

/// What may be expected, rpm: stamps are good to two ticks at either end; jitter adds its own two ends over four
/// revolutions; a gap is repaired to within the same.
fn allowed(rpm: f64, with: Disturbance) -> f64 {
    let four_revolutions = 4.0 * 60.0 / rpm;
    rpm * (16e-6 / four_revolutions + 2.0 * with.jitter / 4.0) * 1.02 + 1e-9
}

#[test]
fn speeds_from_0_to_9000_rpm() {
    let mut table = String::from("| scenario | shaft | true, rpm | largest error, rpm | rms error, rpm | readings |\n");
    table.push_str("|---|---|---|---|---|---|\n");
    for (name, with) in SCENARIOS {
        for (primary, secondary) in SPEEDS {
            let errors = measure(primary, secondary, with);
            for (shaft, rpm, errors) in [("primary", primary, &errors[0]), ("secondary", secondary, &errors[1])] {
                if errors.count == 0.0 {
                    writeln!(table, "| {name} | {shaft} | {rpm} | flagged as too fast | | |").unwrap();
                    continue;
                }
                let rms = (errors.squares / errors.count).sqrt();
                let (largest, count) = (errors.largest, errors.count);
                writeln!(table, "| {name} | {shaft} | {rpm} | {largest:.3} | {rms:.3} | {count} |").unwrap();
                let allowed = if rpm == 0.0 { 0.0 } else { allowed(rpm, with) };
                assert!(largest <= allowed, "{name} {shaft} {rpm}: {largest} > {allowed}\n{table}");
            }
        }
    }
    println!("{table}");
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/simavr-speed.md"), &table).unwrap();
}
