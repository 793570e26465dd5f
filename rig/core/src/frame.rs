//! What goes over the bus: the thesis's frame of 20 bytes, a versioned frame with a check that catches errors, an
//! identity.
//!
//! All numbers are sent with their most significant byte first. The check of the versioned frame and of the identity is
//! CRC-16/IBM-3740 (polynomial 0x1021, start 0xffff): any burst of up to 16 bits is found, where the thesis's plain sum
//! misses two bytes exchanged.

use crate::clock::Instant;
use crate::snapshot::Snapshot;
use crate::speed::{Reading, Speed};

/// The address of the microcontroller on the bus, as in Appendix G.
pub const BUS_ADDRESS: u8 = 0x03;
/// Version of [`Frame`], its first byte.
pub const FRAME_VERSION: u8 = 1;
/// Length of [`Frame`].
pub const FRAME_LENGTH: usize = 49;
/// Length of [`LegacyFrame`].
pub const LEGACY_LENGTH: usize = 20;
/// Length of [`Identity`].
pub const IDENTITY_LENGTH: usize = 18;

const CHECK: crc::Crc<u16, crc::Table<0>> = crc::Crc::<u16, crc::Table<0>>::new(&crc::CRC_16_IBM_3740);

/// CRC-16/IBM-3740 of some bytes, computed without a table (the microcontroller has 2 KiB of memory).
#[must_use]
#[inline(never)]
pub fn checksum(bytes: &[u8]) -> u16 {
    CHECK.checksum(bytes)
}

/// Why bytes are no frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameError {
    /// Not as many bytes as the frame has.
    Length {
        /// Bytes given.
        given: usize,
        /// Bytes of the frame.
        expected: usize,
    },
    /// The check does not fit: the transfer was disturbed.
    Check,
    /// A version that this program does not know.
    Version(u8),
}

impl core::fmt::Display for FrameError {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Length { given, expected } => write!(f, "{given} bytes came where {expected} were expected"),
            Self::Check => write!(f, "the check does not fit: the transfer was disturbed"),
            Self::Version(version) => {
                write!(f, "frame version {version} is unknown (this program reads version {FRAME_VERSION})")
            }
        }
    }
}

impl core::error::Error for FrameError {}

struct Writer<'a> {
    bytes: &'a mut [u8],
    at: usize,
}

impl Writer<'_> {
    fn put(&mut self, bytes: &[u8]) {
        for byte in bytes {
            if let Some(place) = self.bytes.get_mut(self.at) {
                *place = *byte;
            }
            self.at += 1;
        }
    }
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let mut taken = [0; N];
        for place in &mut taken {
            *place = self.bytes.get(self.at).copied().unwrap_or(0);
            self.at += 1;
        }
        taken
    }

    fn byte(&mut self) -> u8 {
        let [byte] = self.take();
        byte
    }
}

/// Seals the bytes with their check in the last two.
fn seal(bytes: &mut [u8]) {
    if let Some((sealed, check)) = bytes.split_last_chunk_mut::<2>() {
        *check = checksum(sealed).to_be_bytes();
    }
}

fn open(bytes: &[u8], expected: usize) -> Result<(), FrameError> {
    if bytes.len() != expected {
        return Err(FrameError::Length { given: bytes.len(), expected });
    }
    match bytes.split_last_chunk::<2>() {
        Some((sealed, check)) if checksum(sealed).to_be_bytes() == *check => Ok(()),
        _ => Err(FrameError::Check),
    }
}

/// The versioned frame: a snapshot of everything, and which reading of the bus it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// One more than the versioned frames that had been read when this one was made, modulo 65,536. Equal for two
    /// frames
    /// with equal content. A master that has read n frames since a fresh one and finds a step of more than n + 1 knows
    /// that
    /// others were read meanwhile, or that the device started anew.
    pub sequence: u16,
    /// What was measured.
    pub snapshot: Snapshot,
}

const PRIMARY_STOPPED: u8 = 1;
const SECONDARY_STOPPED: u8 = 1 << 1;
const PRIMARY_TOO_FAST: u8 = 1 << 2;
const SECONDARY_TOO_FAST: u8 = 1 << 3;
const PERMITTED: u8 = 1 << 4;
const TORQUE_STALE: u8 = 1 << 5;

fn flag(set: bool, bit: u8) -> u8 {
    if set { bit } else { 0 }
}

fn age(now: Instant, at: Option<Instant>) -> u32 {
    at.map_or(u32::MAX, |at| now.since(at))
}

fn moment(now: Instant, age: u32) -> Option<Instant> {
    (age != u32::MAX).then(|| Instant(now.0.saturating_sub(u64::from(age))))
}

#[inline(never)]
fn put_reading(writer: &mut Writer<'_>, now: Instant, reading: &Reading) {
    writer.put(&reading.speed.ticks.to_be_bytes());
    writer.put(&[reading.speed.revolutions, reading.bounces, reading.missing]);
    writer.put(&age(now, reading.last_pulse).to_be_bytes());
    writer.put(&reading.accepted.to_be_bytes());
}

fn take_reading(reader: &mut Reader<'_>, now: Instant, stopped: bool, too_fast: bool) -> Reading {
    let ticks = u32::from_be_bytes(reader.take());
    let [revolutions, bounces, missing] = reader.take();
    let last_pulse = moment(now, u32::from_be_bytes(reader.take()));
    let accepted = u16::from_be_bytes(reader.take());
    Reading { speed: Speed { ticks, revolutions }, last_pulse, stopped, too_fast, bounces, missing, accepted }
}

/// Writes the versioned frame of a snapshot in place.
///
/// In place and not inlined, as all that composes answers: on the microcontroller a stack frame of more than 63 bytes
/// is
/// costly to address, and the compiler's code for such frames has been seen to be wrong.
#[inline(never)]
pub fn write_frame(bytes: &mut [u8; FRAME_LENGTH], sequence: u16, snapshot: &Snapshot) {
    let Snapshot { now, primary, secondary, counters, .. } = snapshot;
    let flags = flag(primary.stopped, PRIMARY_STOPPED)
        | flag(secondary.stopped, SECONDARY_STOPPED)
        | flag(primary.too_fast, PRIMARY_TOO_FAST)
        | flag(secondary.too_fast, SECONDARY_TOO_FAST)
        | flag(snapshot.permitted, PERMITTED)
        | flag(snapshot.torque_stale, TORQUE_STALE);
    let mut writer = Writer { bytes, at: 0 };
    writer.put(&[FRAME_VERSION, flags]);
    writer.put(&sequence.to_be_bytes());
    writer.put(&now.microseconds().to_be_bytes());
    put_reading(&mut writer, *now, primary);
    put_reading(&mut writer, *now, secondary);
    writer.put(&snapshot.torque.to_be_bytes());
    writer.put(&age(*now, snapshot.torque_at).to_be_bytes());
    writer.put(&[counters.conversions, counters.conversion_errors, counters.reset_cause]);
    seal(bytes);
}

/// Place of the sequence number in a versioned frame.
const SEQUENCE_AT: usize = 2;

/// What each bit of the sequence number, the lowest first, contributes to the check. A CRC is linear: changing some
/// bits of a message changes its check by the exclusive or of their contributions, whatever the rest of the message is.
const SEQUENCE_CONTRIBUTIONS: [u16; 16] = {
    let mut contributions = [0; 16];
    let mut bit = 0;
    while bit < 16 {
        // The bit alone, followed by the rest of the sealed bytes, all zero: one division step for each bit after it.
        let mut register = 1u16 << bit;
        let mut shifts = (FRAME_LENGTH - 2 - SEQUENCE_AT) * 8;
        while shifts > 0 {
            register = if register & 0x8000 == 0 { register << 1 } else { (register << 1) ^ 0x1021 };
            shifts -= 1;
        }
        contributions[bit] = register;
        bit += 1;
    }
    contributions
};

/// Gives a versioned frame another sequence number and the check that belongs to it, in some 20 µs on the
/// microcontroller where composing the whole frame takes more than a millisecond.
#[inline(never)]
pub fn renumber(bytes: &mut [u8; FRAME_LENGTH], sequence: u16) {
    let [_, _, high, low, ..] = bytes;
    let mut changed = u16::from_be_bytes([*high, *low]) ^ sequence;
    [*high, *low] = sequence.to_be_bytes();
    let mut change = 0;
    for contribution in &SEQUENCE_CONTRIBUTIONS {
        if changed & 1 == 1 {
            change ^= contribution;
        }
        changed >>= 1;
    }
    if let Some(check) = bytes.last_chunk_mut::<2>() {
        *check = (u16::from_be_bytes(*check) ^ change).to_be_bytes();
    }
}

/// Writes the thesis's frame of a snapshot in place.
#[inline(never)]
pub fn write_legacy(bytes: &mut [u8; LEGACY_LENGTH], snapshot: &Snapshot) {
    let stamp = |at: Option<Instant>| at.map_or(0, Instant::legacy_stamp);
    let mut writer = Writer { bytes, at: 0 };
    writer.put(&snapshot.primary.speed.rpm().to_be_bytes());
    writer.put(&stamp(snapshot.primary.last_pulse).to_be_bytes());
    writer.put(&snapshot.secondary.speed.rpm().to_be_bytes());
    writer.put(&stamp(snapshot.secondary.last_pulse).to_be_bytes());
    writer.put(&snapshot.torque.to_be_bytes());
    writer.put(&stamp(snapshot.torque_at).to_be_bytes());
    let sum = legacy_sum(bytes);
    if let Some(place) = bytes.last_chunk_mut::<2>() {
        *place = sum.to_be_bytes();
    }
}

/// The thesis's check: the sum of all bytes before it.
fn legacy_sum(bytes: &[u8; LEGACY_LENGTH]) -> u16 {
    bytes.iter().take(LEGACY_LENGTH - 2).map(|byte| u16::from(*byte)).sum()
}

impl Frame {
    /// The frame's bytes.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; FRAME_LENGTH] {
        let mut bytes = [0; FRAME_LENGTH];
        write_frame(&mut bytes, self.sequence, &self.snapshot);
        bytes
    }

    /// A frame from its bytes.
    ///
    /// # Errors
    /// If the length or the check is wrong, or the version unknown.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FrameError> {
        open(bytes, FRAME_LENGTH)?;
        let mut reader = Reader { bytes, at: 0 };
        let version = reader.byte();
        if version != FRAME_VERSION {
            return Err(FrameError::Version(version));
        }
        let flags = reader.byte();
        let sequence = u16::from_be_bytes(reader.take());
        let now = Instant::from_microseconds(u64::from_be_bytes(reader.take()));
        let is = |bit: u8| flags & bit != 0;
        let primary = take_reading(&mut reader, now, is(PRIMARY_STOPPED), is(PRIMARY_TOO_FAST));
        let secondary = take_reading(&mut reader, now, is(SECONDARY_STOPPED), is(SECONDARY_TOO_FAST));
        let torque = u16::from_be_bytes(reader.take());
        let torque_at = moment(now, u32::from_be_bytes(reader.take()));
        let [conversions, conversion_errors, reset_cause] = reader.take();
        let counters = crate::snapshot::Counters { conversions, conversion_errors, reset_cause };
        let permitted = is(PERMITTED);
        let torque_stale = is(TORQUE_STALE);
        let snapshot = Snapshot { now, primary, secondary, torque, torque_at, torque_stale, permitted, counters };
        Ok(Self { sequence, snapshot })
    }
}

/// The thesis's frame (Appendix G): speeds in rpm, the converter's value, each with its time in µs, and the sum of all
/// bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LegacyFrame {
    /// Speed of the primary, rpm.
    pub primary_rpm: u16,
    /// Its last pulse, µs modulo 2³².
    pub primary_stamp: u32,
    /// Speed of the secondary, rpm.
    pub secondary_rpm: u16,
    /// Its last pulse, µs modulo 2³².
    pub secondary_stamp: u32,
    /// The converter's last good value.
    pub torque: u16,
    /// When it came, µs modulo 2³².
    pub torque_stamp: u32,
}

impl LegacyFrame {
    /// A frame from its bytes.
    ///
    /// # Errors
    /// If the length or the sum is wrong.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FrameError> {
        if bytes.len() != LEGACY_LENGTH {
            return Err(FrameError::Length { given: bytes.len(), expected: LEGACY_LENGTH });
        }
        let mut whole = [0; LEGACY_LENGTH];
        whole.copy_from_slice(bytes);
        if !bytes.ends_with(&legacy_sum(&whole).to_be_bytes()) {
            return Err(FrameError::Check);
        }
        let mut reader = Reader { bytes, at: 0 };
        Ok(Self {
            primary_rpm: u16::from_be_bytes(reader.take()),
            primary_stamp: u32::from_be_bytes(reader.take()),
            secondary_rpm: u16::from_be_bytes(reader.take()),
            secondary_stamp: u32::from_be_bytes(reader.take()),
            torque: u16::from_be_bytes(reader.take()),
            torque_stamp: u32::from_be_bytes(reader.take()),
        })
    }
}

/// What the firmware says of itself; the logger writes it beside every run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Identity {
    /// Major, minor and patch number of the firmware.
    pub firmware: [u8; 3],
    /// Length of a tick in microseconds.
    pub tick_microseconds: u8,
    /// Revolutions that a speed is taken over.
    pub revolutions: u8,
    /// Shortest period of the primary, ticks.
    pub primary_shortest_period: u32,
    /// Shortest period of the secondary, ticks.
    pub secondary_shortest_period: u32,
    /// How long a run permit lasts, in units of 10 ms.
    pub permit_centiseconds: u16,
}

impl Identity {
    /// The identity's bytes.
    #[must_use]
    pub fn to_bytes(&self) -> [u8; IDENTITY_LENGTH] {
        let mut bytes = [0; IDENTITY_LENGTH];
        let mut writer = Writer { bytes: &mut bytes, at: 0 };
        writer.put(&[FRAME_VERSION]);
        writer.put(&self.firmware);
        writer.put(&[self.tick_microseconds, self.revolutions]);
        writer.put(&self.primary_shortest_period.to_be_bytes());
        writer.put(&self.secondary_shortest_period.to_be_bytes());
        writer.put(&self.permit_centiseconds.to_be_bytes());
        seal(&mut bytes);
        bytes
    }

    /// An identity from its bytes.
    ///
    /// # Errors
    /// If the length or the check is wrong, or the version unknown.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, FrameError> {
        open(bytes, IDENTITY_LENGTH)?;
        let mut reader = Reader { bytes, at: 0 };
        let version = reader.byte();
        if version != FRAME_VERSION {
            return Err(FrameError::Version(version));
        }
        Ok(Self {
            firmware: reader.take(),
            tick_microseconds: reader.byte(),
            revolutions: reader.byte(),
            primary_shortest_period: u32::from_be_bytes(reader.take()),
            secondary_shortest_period: u32::from_be_bytes(reader.take()),
            permit_centiseconds: u16::from_be_bytes(reader.take()),
        })
    }
}
