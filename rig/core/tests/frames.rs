//! Frames there and back, and what disturbs them.

use proptest::prelude::*;
use rig_core::device::{Device, identity};
use rig_core::{BusAnswer, Frame, FrameError, Identity, Instant, LegacyFrame};

fn device() -> (Device, Instant) {
    let mut device = Device::new(0b1000);
    for pulse in 0..9 {
        device.primary.pulse(Instant(5_000_035_000 + pulse * 5000));
        device.secondary.pulse(Instant(5_000_000_100 + pulse * 9463));
    }
    device.conversion(Instant(5_000_075_000), Ok(35_145));
    device.conversion(Instant(5_000_077_000), Err(rig_core::ad7171::ConversionError::Reported));
    device.permit.grant(Instant(5_000_077_000));
    (device, Instant(5_000_078_000))
}

fn answer() -> (BusAnswer, rig_core::Snapshot) {
    let (mut device, now) = device();
    let snapshot = device.snapshot(now);
    let mut answer = BusAnswer::empty();
    answer.fill(&snapshot, 0xbeef);
    (answer, snapshot)
}

#[test]
fn the_versioned_frame_carries_the_whole_snapshot() {
    let (answer, snapshot) = answer();
    let frame = Frame::from_bytes(&answer.frame).unwrap();
    assert_eq!(frame, Frame { sequence: 0xbeef, snapshot });
    assert_eq!(frame.snapshot.primary.speed.rpm(), 3000);
    assert_eq!(frame.snapshot.secondary.speed.rpm(), 1585);
    assert!(frame.snapshot.permitted && !frame.snapshot.torque_stale);
    assert_eq!(frame.snapshot.counters.conversion_errors, 1);
    assert_eq!(Identity::from_bytes(&identity([1, 2, 3]).to_bytes()).unwrap(), identity([1, 2, 3]));
}

#[test]
fn a_frame_with_a_new_number_is_the_frame_made_with_that_number() {
    let (mut answer, snapshot) = answer();
    for sequence in [0, 1, 0x8000, 0xbeef, 0xbef0, 0xffff, 0x1234] {
        answer.renumber(sequence);
        assert_eq!(answer.frame, Frame { sequence, snapshot }.to_bytes(), "{sequence:x}");
    }
}

/// Byte by byte what Appendix G sends and Appendix H takes apart.
#[test]
fn the_old_frame_is_the_one_of_the_thesis() {
    let (answer, snapshot) = answer();
    let bytes = answer.legacy.map(u64::from);
    assert_eq!(bytes[0] * 256 + bytes[1], 3000);
    let stamp = bytes[2] * 16_777_216 + bytes[3] * 65_536 + bytes[4] * 256 + bytes[5];
    assert_eq!(stamp, snapshot.primary.last_pulse.unwrap().microseconds() % (1 << 32));
    assert_eq!(bytes[6] * 256 + bytes[7], 1585);
    assert_eq!(bytes[12] * 256 + bytes[13], 35_145);
    assert_eq!(bytes[18] * 256 + bytes[19], bytes[..18].iter().sum());
    assert_eq!(LegacyFrame::from_bytes(&answer.legacy).unwrap().secondary_rpm, 1585);
}

#[test]
fn every_single_and_double_bit_error_and_every_exchange_of_two_bytes_is_found() {
    let (answer, _) = answer();
    let bits = answer.frame.len() * 8;
    for first in 0..bits {
        for second in first..bits {
            let mut bytes = answer.frame;
            bytes[first / 8] ^= 1 << (first % 8);
            if second != first {
                bytes[second / 8] ^= 1 << (second % 8);
            }
            assert_eq!(Frame::from_bytes(&bytes), Err(FrameError::Check), "{first} {second}");
        }
    }
    for first in 0..answer.frame.len() {
        for second in 0..first {
            let mut bytes = answer.frame;
            bytes.swap(first, second);
            assert_eq!(Frame::from_bytes(&bytes).is_err(), bytes != answer.frame, "{first} {second}");
        }
    }
}

#[test]
fn what_is_no_frame_is_named() {
    assert_eq!(Frame::from_bytes(&[]), Err(FrameError::Length { given: 0, expected: 49 }));
    assert_eq!(LegacyFrame::from_bytes(&[1; 20]), Err(FrameError::Check));
    let (answer, _) = answer();
    let mut bytes = answer.frame;
    bytes[0] = 9;
    let check = rig_core::frame::checksum(&bytes[..47]).to_be_bytes();
    bytes[47..].copy_from_slice(&check);
    assert_eq!(Frame::from_bytes(&bytes), Err(FrameError::Version(9)));
    // The standard's own check value.
    assert_eq!(rig_core::frame::checksum(b"123456789"), 0x29b1);
}

proptest! {
    #[test]
    fn no_bytes_panic(bytes in prop::collection::vec(any::<u8>(), 0..80)) {
        let _ = Frame::from_bytes(&bytes);
        let _ = LegacyFrame::from_bytes(&bytes);
        let _ = Identity::from_bytes(&bytes);
    }
}
