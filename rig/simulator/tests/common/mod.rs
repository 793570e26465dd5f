//! What the tests of the binary share.

#![allow(dead_code)]

use std::path::PathBuf;

use rig_core::Frame;
use rig_core::ad7171::GOOD_STATUS;
use rig_core::wire::REGISTER_FRAME;
use rig_simulator::{Bench, CYCLES_PER_SECOND, Event};

/// Cycles in a millisecond.
pub const MILLISECOND: u64 = CYCLES_PER_SECOND / 1000;

/// The firmware: from `RIG_FIRMWARE`, or where build-firmware.sh puts it.
pub fn firmware() -> PathBuf {
    let built = concat!(env!("CARGO_MANIFEST_DIR"), "/../firmware/target/avr-none/release/rig-firmware.elf");
    let path = std::env::var_os("RIG_FIRMWARE").map_or_else(|| PathBuf::from(built), PathBuf::from);
    assert!(path.is_file(), "{} is missing: run rig/build-firmware.sh first", path.display());
    path
}

/// A device that has started, on a bus of 400 kHz.
pub fn start() -> Bench {
    let mut bench = Bench::start(&firmware(), 400_000).unwrap();
    bench.run(5 * MILLISECOND).unwrap();
    bench
}

/// Reads the versioned frame.
pub fn frame(bench: &mut Bench) -> Frame {
    Frame::from_bytes(&bench.transfer(&[REGISTER_FRAME], rig_core::frame::FRAME_LENGTH).unwrap()).unwrap()
}

/// A conversion as the converter sends it.
pub fn conversion(value: u16) -> Event {
    Event::Conversion(u32::from(value) << 8 | u32::from(GOOD_STATUS))
}

/// Conversions at 125 Hz with values that count up.
pub fn schedule_conversions(bench: &mut Bench, from: u64, to: u64) -> Vec<u64> {
    let ready: Vec<u64> = (from..to).step_by(8 * MILLISECOND as usize).collect();
    for (value, at) in (35_000u16..).zip(&ready) {
        bench.schedule(*at, conversion(value));
    }
    ready
}
