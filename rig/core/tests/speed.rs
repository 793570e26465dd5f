//! The speed meter against pulse trains whose true speed is known.

use proptest::prelude::*;
use rig_core::{Instant, PulseLimits, SpeedMeter, TICKS_PER_SECOND, Verdict};

const MINUTE: f64 = 60.0 * TICKS_PER_SECOND as f64;

/// Feeds pulses of a constant speed from `start` on and returns the meter and the moment of the last one.
fn turn(meter: &mut SpeedMeter, rpm: f64, pulses: u32, start: u64) -> Instant {
    let mut at = Instant(start);
    for pulse in 0..pulses {
        at = Instant(start + (f64::from(pulse) * MINUTE / rpm).round() as u64);
        meter.pulse(at);
    }
    at
}

#[test]
fn constant_speed_is_measured_to_the_resolution_of_the_clock() {
    for rpm in (150..=9900u16).step_by(50) {
        let mut meter = SpeedMeter::new(PulseLimits::SECONDARY);
        let at = turn(&mut meter, f64::from(rpm), 12, 1 << 33);
        let measured = meter.reading(at).speed;
        let error = (measured.rpm_exact() / f64::from(rpm) - 1.0).abs();
        // One tick in four revolutions.
        assert!(error <= f64::from(rpm) / MINUTE / 4.0 * 1.01, "{rpm}: {measured:?}");
        assert!(measured.rpm().abs_diff(rpm) <= 1, "{rpm}: {}", measured.rpm());
    }
}

#[test]
fn a_bounce_changes_nothing_but_its_count() {
    let (mut clean, mut bouncing) = (SpeedMeter::new(PulseLimits::PRIMARY), SpeedMeter::new(PulseLimits::PRIMARY));
    let mut last = Instant(0);
    for pulse in 0..20u64 {
        last = Instant(pulse * 4000);
        clean.pulse(last);
        bouncing.pulse(last);
        for bounce in [3, 40, 900] {
            assert_eq!(bouncing.pulse(Instant(last.0 + bounce)), Verdict::Bounce);
        }
    }
    assert_eq!(clean.reading(last).speed, bouncing.reading(last).speed);
    assert_eq!(bouncing.reading(last).bounces, 60);
    assert!(!bouncing.reading(last).too_fast);
}

#[test]
fn missing_pulses_are_repaired_and_counted_four_long_intervals_are_a_slower_shaft() {
    let mut meter = SpeedMeter::new(PulseLimits::PRIMARY);
    let at = turn(&mut meter, 3000.0, 10, 0);
    for gap in 1..=3u8 {
        let now = Instant(at.0 + u64::from(gap) * 10_000);
        assert_eq!(meter.pulse(now), Verdict::Repaired(2));
        assert_eq!(meter.reading(now).speed.rpm(), 3000);
        assert_eq!(meter.reading(now).missing, gap);
    }
    assert_eq!(meter.pulse(Instant(at.0 + 40_000)), Verdict::Revolution);
    assert_eq!(meter.reading(Instant(at.0 + 40_000)).speed.rpm(), 1500);
}

#[test]
fn a_shaft_that_stops_is_bounded_then_zero_and_starts_without_a_false_period() {
    let mut meter = SpeedMeter::new(PulseLimits::PRIMARY);
    assert!(meter.reading(Instant(0)).stopped);
    let at = turn(&mut meter, 3000.0, 10, 0);
    let later = |seconds: f64| Instant(at.0 + (seconds * f64::from(TICKS_PER_SECOND)) as u64);
    assert_eq!(meter.reading(later(0.04)).speed.rpm(), 3000);
    assert_eq!(meter.reading(later(0.1)).speed.rpm(), 600);
    assert_eq!(meter.reading(later(0.3)).speed.rpm(), 200);
    let stopped = meter.reading(later(0.5));
    assert!(stopped.stopped && stopped.speed.rpm() == 0);
    assert_eq!(meter.pulse(later(2.0)), Verdict::First);
    assert_eq!(meter.reading(later(2.0)).speed.rpm(), 0);
    meter.pulse(later(2.02));
    assert_eq!(meter.reading(later(2.02)).speed.rpm(), 3000);
}

#[test]
fn a_shaft_faster_than_its_limit_is_named_not_halved_in_silence() {
    for rpm in [6100.0, 7000.0, 9000.0, 13_000.0, 20_000.0] {
        let mut meter = SpeedMeter::new(PulseLimits::PRIMARY);
        let at = turn(&mut meter, rpm, 40, 0);
        assert!(meter.reading(at).too_fast, "{rpm}");
    }
    let mut meter = SpeedMeter::new(PulseLimits::PRIMARY);
    let at = turn(&mut meter, 5900.0, 40, 0);
    assert!(!meter.reading(at).too_fast);
}

proptest! {
    /// Whatever comes in: no panic, a speed below the limit, and a time-out that holds.
    #[test]
    fn any_pulse_train_gives_a_plausible_speed(steps in prop::collection::vec(0u32..400_000, 1..200)) {
        let mut meter = SpeedMeter::new(PulseLimits::SECONDARY);
        let mut at = 0u64;
        for step in steps {
            at += u64::from(step);
            meter.pulse(Instant(at));
            let reading = meter.reading(Instant(at));
            prop_assert!(reading.speed.rpm() <= 10_000);
            // A repaired interval counts several revolutions: never a period below three quarters of the limit.
            prop_assert!(reading.speed.revolutions <= 12);
        }
        prop_assert!(meter.reading(Instant(at + 125_000)).stopped);
    }
}
