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

/// Between two reads of a master as fast as can be, or as slow, there is a fresh answer: composed within two turns of
/// the main loop, which the bus's interrupts slow down to two fifths of its speed at 400 kHz, to four fifths at 100
/// kHz.
#[test]
fn no_polling_rate_starves_the_answers() {
    for (hertz, speed) in [(100_000, 0.8), (400_000, 0.4)] {
        let mut bench = Bench::start(&firmware(), hertz).unwrap();
        bench.run(5 * MILLISECOND).unwrap();
        for gap_us in [20, 50, 200, 400, 700, 1000, 1200, 1270, 1300, 1500, 2000, 4000, 6667] {
            let mut oldest = 0.0f64;
            for _ in 0..30 {
                bench.run(gap_us * CYCLES_PER_MICROSECOND).unwrap();
                let asked = bench.cycle() as f64;
                let made = frame(&mut bench).snapshot.now.microseconds() * CYCLES_PER_MICROSECOND;
                oldest = oldest.max((asked - made as f64) / MILLISECOND as f64);
            }
            assert!(oldest <= 2.0 * TURN_MS / speed, "{hertz} Hz, {gap_us} µs between reads: {oldest:.2} ms old");
        }
    }
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
    println!("{table}");
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/simavr-latency.md"), &table).unwrap();
    assert!(stamp.1 - stamp.0 <= 40.0 * 16.0, "{stamp:?}");
    assert!(conversion_stamp.1 - conversion_stamp.0 <= 3000.0 * 16.0, "{conversion_stamp:?}");
    assert!(hold <= 60.0);
    assert!((age.1 - age.0) / MILLISECOND as f64 <= TURN_MS, "{age:?}");
}

fn nearest(moments: &[u64], stamp: u64) -> f64 {
    let near = moments.iter().min_by_key(|moment| moment.abs_diff(stamp)).copied().unwrap();
    stamp as f64 - near as f64
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
}

/// A jump of the primary's speed at a point between two pulses, and how it became known.
struct Step {
    /// From the jump to the pulse after which a meter without any delay would be within 1 % for good, ms.
    by_revolutions: f64,
    /// From that pulse to the end of the first read that is within 1 %, ms.
    by_device: f64,
    /// The longest read, ms.
    read: f64,
}

/// The jump comes after `phase` of a revolution at the old speed; frames are asked for `gap` cycles after the last one.
fn step_response(from: f64, to: f64, phase: f64, gap: u64) -> Step {
    let mut bench = Bench::start(&firmware(), 400_000).unwrap();
    let (old, new) = (60.0 * CYCLES_PER_SECOND as f64 / from, 60.0 * CYCLES_PER_SECOND as f64 / to);
    let begin = bench.cycle() + 5 * MILLISECOND;
    let mut moments: Vec<f64> = (0..12).map(|pulse| begin as f64 + f64::from(pulse) * old).collect();
    let jump = moments.last().unwrap() + phase * old;
    moments.extend((0..24).map(|pulse| jump + (1.0 - phase) * new + f64::from(pulse) * new));
    for at in &moments {
        bench.schedule(*at as u64, Event::Pin(PRIMARY_PIN, false));
        bench.schedule(*at as u64 + 8000, Event::Pin(PRIMARY_PIN, true));
    }
    let within = |period: f64| (new / period - 1.0).abs() <= 0.01;
    let last_wrong = (4..moments.len()).rev().find(|last| !within((moments[*last] - moments[last - 4]) / 4.0)).unwrap();
    let knowable = moments[last_wrong + 1];
    bench.run_to(jump as u64).unwrap();
    let mut read: f64 = 0.0;
    loop {
        let asked = bench.cycle();
        let speed = frame(&mut bench).snapshot.primary.speed.rpm_exact();
        read = read.max((bench.cycle() - asked) as f64);
        if (speed / to - 1.0).abs() <= 0.01 {
            break;
        }
        bench.run(gap).unwrap();
    }
    let millisecond = MILLISECOND as f64;
    Step {
        by_revolutions: (knowable - jump) / millisecond,
        by_device: (bench.cycle() as f64 - knowable) / millisecond,
        read: read / millisecond,
    }
}

/// One turn of the main loop with the bus at rest, ms; `latencies` measures it as the spread of the frames' age.
const TURN_MS: f64 = 1.5;

/// A step from 3000 to 3600 rpm, at every phase of the revolution against the jump and with fast and slow polling.
///
/// The bound has two parts. Revolutions: a jump at a fraction f of a revolution is known once four intervals are within
/// 1 %, which takes 4 − f periods where f is at most a fifth (the mixed interval is then as good as a new one) and
/// 5 − f otherwise: at most 4.8 periods. Device: a pulse waits for the next turn of the main loop and is published at
/// the end of that turn, or of the read that is under way then; two turns slowed down by the bus to two fifths, one
/// read, one time between reads, and the read that brings it.
#[test]
fn a_step_of_speed_is_known_in_time_at_every_phase() {
    let mut table = String::from(
        "| frames asked for | step 3000 to 3600 rpm within 1 %, at the latest | of this: revolutions | device and bus \
        |\n\
         |---|---|---|---|\n",
    );
    for (name, gap_us) in
        [("1 ms after the last one", 1000), ("1.3 ms after the last one", 1300), ("150 times a second", 5300)]
    {
        let (mut total, mut revolutions, mut device) = (0.0f64, 0.0f64, 0.0f64);
        for phase in 0..20 {
            let step = step_response(3000.0, 3600.0, f64::from(phase) / 20.0, gap_us * CYCLES_PER_MICROSECOND);
            let bound = 2.0 * TURN_MS / 0.4 + gap_us as f64 / 1000.0 + 2.0 * step.read;
            assert!(
                step.by_device > 0.0 && step.by_device <= bound,
                "{name}, {phase}/20: {} > {bound}",
                step.by_device
            );
            assert!(step.by_revolutions <= 4.8 * 60_000.0 / 3600.0, "{phase}/20: {}", step.by_revolutions);
            total = total.max(step.by_revolutions + step.by_device);
            revolutions = revolutions.max(step.by_revolutions);
            device = device.max(step.by_device);
        }
        writeln!(table, "| {name} | {total:.1} ms | {revolutions:.1} ms | {device:.1} ms |").unwrap();
    }
    println!("{table}");
    std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/../target/simavr-step.md"), &table).unwrap();
}
