//! The real binary: frames old and new, time stamps over every roll-over, the converter's errors, latencies, the
//! ignition
//! relay and the watchdog.

#![allow(clippy::unwrap_used)]

mod common;

use std::fmt::Write as _;

use common::{MILLISECOND, conversion, firmware, frame, schedule_conversions, start};
use rig_core::frame::{FRAME_LENGTH, IDENTITY_LENGTH, LEGACY_LENGTH};
use rig_core::wire::{GRANT, REGISTER_IDENTITY, REGISTER_PERMIT, WITHDRAW};
use rig_core::{Frame, Identity, LegacyFrame};
use rig_simulator::pulses::{Disturbance, Random, schedule};
use rig_simulator::{Bench, CYCLES_PER_SECOND, Event, PRIMARY_PIN, SECONDARY_PIN};

const CYCLES_PER_MICROSECOND: u64 = 16;

#[test]
fn an_old_logger_reads_what_it_always_read() {
    let mut bench = start();
    let begin = bench.cycle();
    schedule(&mut bench, PRIMARY_PIN, 3000.0, (begin, begin + CYCLES_PER_SECOND), Disturbance::default(), 1);
    schedule(&mut bench, SECONDARY_PIN, 1585.0, (begin, begin + CYCLES_PER_SECOND), Disturbance::default(), 2);
    bench.schedule(begin + 250 * MILLISECOND, conversion(35_145));
    bench.run(300 * MILLISECOND).unwrap();
    // As smbus does it: register 0, repeated start, 20 bytes; and as Wire's master does it: 20 bytes.
    let selected = bench.transfer(&[0], LEGACY_LENGTH).unwrap();
    let plain = bench.read(LEGACY_LENGTH).unwrap();
    for bytes in [selected, plain] {
        let frame = LegacyFrame::from_bytes(&bytes).unwrap();
        assert_eq!((frame.primary_rpm, frame.secondary_rpm, frame.torque), (3000, 1585, 35_145));
        let sent = 255 * 1000;
        assert!(frame.torque_stamp.abs_diff(sent) < 3000, "{frame:?}");
    }
    let identity = Identity::from_bytes(&bench.transfer(&[REGISTER_IDENTITY], IDENTITY_LENGTH).unwrap()).unwrap();
    assert_eq!(identity, rig_core::device::identity([0, 1, 0]));
}

#[test]
fn every_frame_of_a_busy_device_is_whole_and_numbered() {
    let mut bench = start();
    let begin = bench.cycle();
    let end = begin + CYCLES_PER_SECOND;
    let noisy = Disturbance { jitter: 0.01, bounces: 2, missing: 0.05 };
    schedule(&mut bench, PRIMARY_PIN, 3800.0, (begin, end), noisy, 3);
    schedule(&mut bench, SECONDARY_PIN, 7600.0, (begin, end), noisy, 4);
    schedule_conversions(&mut bench, begin, end);
    let mut random = Random::new(5);
    let mut before: Option<Frame> = None;
    let mut reads = 0;
    while bench.cycle() < end - 20 * MILLISECOND {
        // Also the worst that a master can do: a read given up half way, a write without a read.
        if random.uniform() < 0.2 {
            bench.transfer(&[1], 1 + (random.uniform() * 40.0) as usize).unwrap();
            bench.write(&[REGISTER_PERMIT]).unwrap();
            reads += 1;
        }
        let now = frame(&mut bench);
        reads += 1;
        if let Some(before) = before {
            let step = now.sequence.wrapping_sub(before.sequence);
            assert!(step <= reads + 1, "{step} {reads}");
            assert_eq!(step == 0, now == before);
            if step > 0 {
                reads = 0;
            }
            assert!(now.snapshot.now >= before.snapshot.now);
            assert!(now.snapshot.primary.last_pulse >= before.snapshot.primary.last_pulse);
        }
        before = Some(now);
        bench.run((random.uniform() * 4.0 * MILLISECOND as f64) as u64).unwrap();
    }
}

#[test]
fn time_goes_on_where_the_thesis_s_clock_rolled_over() {
    // Overflows of the 16-bit counter just before 2^32 µs (71.6 min) and before 2^32 ticks (4.8 h).
    for (overflows, bits) in [(16_383u32, 32), (65_535, 34)] {
        let mut bench = start();
        bench.set_variable("rig_overflows", overflows).unwrap();
        let begin = bench.cycle();
        let end = begin + CYCLES_PER_SECOND;
        schedule(&mut bench, PRIMARY_PIN, 3400.0, (begin, end), Disturbance::default(), 1);
        schedule(&mut bench, SECONDARY_PIN, 7000.0, (begin, end), Disturbance::default(), 1);
        let (mut seen_before, mut seen_after) = (false, false);
        let mut last = 0;
        bench.run(180 * MILLISECOND).unwrap();
        while bench.cycle() < end {
            let now = frame(&mut bench).snapshot;
            assert!(now.now.microseconds() > last);
            last = now.now.microseconds();
            seen_before |= last < 1 << bits;
            seen_after |= last >= 1 << bits;
            for (reading, rpm) in [(now.primary, 3400.0), (now.secondary, 7000.0)] {
                let error = (reading.speed.rpm_exact() - rpm).abs();
                // Two stamps within 8 µs each, over four revolutions.
                assert!(error < rpm * rpm * 16e-6 / 240.0, "{rpm}: {reading:?}");
            }
            bench.run(5 * MILLISECOND).unwrap();
        }
        assert!(seen_before && seen_after);
    }
}

#[test]
fn a_bad_conversion_is_counted_and_never_shown() {
    let mut bench = start();
    bench.schedule(bench.cycle() + MILLISECOND, conversion(30_000));
    bench.run(10 * MILLISECOND).unwrap();
    assert_eq!(frame(&mut bench).snapshot.torque, 30_000);
    for (count, status) in (1u8..).zip([0x2d, 0x0c, 0xff, 0x05]) {
        bench.schedule(bench.cycle() + MILLISECOND, Event::Conversion((0xffffu32 << 8) | status));
        bench.run(10 * MILLISECOND).unwrap();
        let snapshot = frame(&mut bench).snapshot;
        assert_eq!((snapshot.torque, snapshot.counters.conversion_errors), (30_000, count), "{status:x}");
    }
    bench.run(100 * MILLISECOND).unwrap();
    assert!(frame(&mut bench).snapshot.torque_stale);
}

#[test]
fn the_relay_closes_only_while_the_logger_asks_for_it() {
    let mut bench = start();
    assert!(!bench.relay().0);
    frame(&mut bench);
    bench.run(10 * MILLISECOND).unwrap();
    assert!(!bench.relay().0, "reading alone permits nothing");
    for _ in 0..5 {
        bench.transfer(&[REGISTER_PERMIT, GRANT], FRAME_LENGTH).unwrap();
        bench.run(200 * MILLISECOND).unwrap();
        assert!(bench.relay().0);
        assert!(frame(&mut bench).snapshot.permitted);
    }
    bench.transfer(&[REGISTER_PERMIT, GRANT], FRAME_LENGTH).unwrap();
    let last = bench.cycle();
    bench.run(400 * MILLISECOND).unwrap();
    let (closed, changed) = bench.relay();
    assert!(!closed);
    let after = (changed - last) / MILLISECOND;
    assert!((245..=255).contains(&after), "{after} ms");
    bench.transfer(&[REGISTER_PERMIT, GRANT], FRAME_LENGTH).unwrap();
    bench.run(10 * MILLISECOND).unwrap();
    assert!(bench.relay().0);
    bench.transfer(&[REGISTER_PERMIT, WITHDRAW], FRAME_LENGTH).unwrap();
    bench.run(5 * MILLISECOND).unwrap();
    assert!(!bench.relay().0);
}

#[test]
fn a_hang_ends_in_a_reset_that_opens_the_relay_and_says_so() {
    let mut bench = start();
    bench.transfer(&[REGISTER_PERMIT, GRANT], FRAME_LENGTH).unwrap();
    bench.run(10 * MILLISECOND).unwrap();
    assert!(bench.relay().0);
    bench.hang().unwrap();
    bench.run(290 * MILLISECOND).unwrap();
    let snapshot = frame(&mut bench).snapshot;
    assert!(!snapshot.permitted);
    assert_eq!(snapshot.counters.reset_cause & 0b1000, 0b1000, "{snapshot:?}");
    assert!(snapshot.now.microseconds() < 60_000);
}

/// Cycles from an edge to the first frame that knows of it, and how exact its stamp is.
#[test]
fn latencies() {
    let mut bench = start();
    let begin = bench.cycle();
    let end = begin + 2 * CYCLES_PER_SECOND;
    let passages = schedule(&mut bench, PRIMARY_PIN, 2991.0, (begin, end), Disturbance::default(), 1);
    schedule(&mut bench, SECONDARY_PIN, 1585.0, (begin, end), Disturbance::default(), 2);
    let conversions = schedule_conversions(&mut bench, begin, end);
    let (mut stamps, mut conversion_stamps, mut ages) = (Vec::new(), Vec::new(), Vec::new());
    bench.run(30 * MILLISECOND).unwrap();
    while bench.cycle() < end {
        let asked = bench.cycle();
        let snapshot = frame(&mut bench).snapshot;
        let stamp = snapshot.primary.last_pulse.unwrap().microseconds() * CYCLES_PER_MICROSECOND;
        stamps.push(nearest(&passages, stamp));
        conversion_stamps
            .push(nearest(&conversions, snapshot.torque_at.unwrap().microseconds() * CYCLES_PER_MICROSECOND));
        ages.push(asked as f64 - (snapshot.now.microseconds() * CYCLES_PER_MICROSECOND) as f64);
        bench.run(6 * MILLISECOND + bench.cycle() % 977).unwrap();
    }
    let [stamp, conversion_stamp, age] = [&stamps, &conversion_stamps, &ages].map(|values| range(values));
    let hold = bench.longest_hold() as f64 / 16.0;
    let step = step_response();
    let mut table = String::from("| what | measured |\n|---|---|\n");
    writeln!(table, "| spread of a pulse's time stamp | {:.1} µs |", (stamp.1 - stamp.0) / 16.0).unwrap();
    writeln!(
        table,
        "| spread of a conversion's time stamp | {:.0} µs |",
        (conversion_stamp.1 - conversion_stamp.0) / 16.0
    )
    .unwrap();
    writeln!(table, "| age of a frame when it is asked for, spread | {:.0} µs |", (age.1 - age.0) / 16.0).unwrap();
    writeln!(table, "| longest hold of the bus's clock line | {hold:.0} µs |").unwrap();
    writeln!(table, "| step from 3000 to 3600 rpm known within 1 % after | {step:.1} ms |").unwrap();
    println!("{table}");
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/simavr-latency.md"), &table).unwrap();
    assert!(stamp.1 - stamp.0 <= 40.0 * 16.0, "{stamp:?}");
    assert!(conversion_stamp.1 - conversion_stamp.0 <= 3000.0 * 16.0, "{conversion_stamp:?}");
    assert!(age.1 - age.0 <= 6000.0 * 16.0, "{age:?}");
    assert!(hold <= 60.0);
    // Four revolutions at 3600 rpm are 67 ms.
    assert!(step <= 67.0 + 20.0 + 7.0, "{step}");
}

fn nearest(moments: &[u64], stamp: u64) -> f64 {
    let near = moments.iter().min_by_key(|moment| moment.abs_diff(stamp)).copied().unwrap();
    stamp as f64 - near as f64
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
}

fn step_response() -> f64 {
    let mut bench = Bench::start(&firmware(), 400_000).unwrap();
    let begin = bench.cycle() + 5 * MILLISECOND;
    let step = begin + CYCLES_PER_SECOND / 2;
    let slow = schedule(&mut bench, PRIMARY_PIN, 3000.0, (begin, step), Disturbance::default(), 1);
    let from = slow.last().unwrap() + CYCLES_PER_SECOND / 60;
    for pulse in 0..60 {
        let at = from + pulse * CYCLES_PER_SECOND / 60;
        bench.schedule(at, Event::Pin(PRIMARY_PIN, false));
        bench.schedule(at + 8000, Event::Pin(PRIMARY_PIN, true));
    }
    bench.run_to(step).unwrap();
    while (frame(&mut bench).snapshot.primary.speed.rpm_exact() - 3600.0).abs() > 36.0 {
        bench.run(MILLISECOND).unwrap();
    }
    (bench.cycle() - slow.last().unwrap()) as f64 / MILLISECOND as f64
}
