//! The I²C slave: register writes come in, prepared answers go out, one byte for each interrupt.

use core::cell::{Cell, UnsafeCell};

use avr_device::atmega328p::{Peripherals, TWI};
use avr_device::interrupt::{self, Mutex};
use rig_core::frame::{BUS_ADDRESS, IDENTITY_LENGTH};
use rig_core::wire::{Request, Selected, Selection};
use rig_core::{BusAnswer, Snapshot};

/// Three sets of answers: the bus reads one, another may be complete and waiting, the main loop writes a third.
struct Answers(UnsafeCell<[BusAnswer; 3]>);

// SAFETY: `READY` and `WAITING` say which sets the bus may read; the main loop writes the one that neither names.
unsafe impl Sync for Answers {}

static ANSWERS: Answers = Answers(UnsafeCell::new([const { BusAnswer::empty() }; 3]));
/// The identity's bytes, written once before the bus is listened to.
struct IdentityBytes(UnsafeCell<[u8; IDENTITY_LENGTH]>);

// SAFETY: written before interrupts are enabled, only read afterwards.
unsafe impl Sync for IdentityBytes {}

static IDENTITY: IdentityBytes = IdentityBytes(UnsafeCell::new([0; IDENTITY_LENGTH]));
/// Which set the bus reads.
static READY: Mutex<Cell<u8>> = Mutex::new(Cell::new(0));
/// Which set takes its place when the read under way ends; the same one if none waits.
static WAITING: Mutex<Cell<u8>> = Mutex::new(Cell::new(0));
/// A read is under way.
static BUSY: Mutex<Cell<bool>> = Mutex::new(Cell::new(false));
/// Versioned frames read so far.
static SERVED: Mutex<Cell<u16>> = Mutex::new(Cell::new(0));
static REQUEST: Mutex<Cell<Request>> = Mutex::new(Cell::new(Request::None));
static SELECTION: Mutex<Cell<Selection>> = Mutex::new(Cell::new(Selection::new()));
static NEXT_BYTE: Mutex<Cell<u8>> = Mutex::new(Cell::new(0));

/// Go on: interrupt flag cleared, acknowledge, enabled, with interrupt.
const GO_ON: u8 = 1 << 7 | 1 << 6 | 1 << 2 | 1;
/// The same, giving up a disturbed transfer (TWSTO).
const RECOVER: u8 = GO_ON | 1 << 4;

/// Listens to the device's address.
#[inline(never)]
pub fn set_up(bus: &TWI) {
    // SAFETY: interrupts are still off.
    unsafe { *IDENTITY.0.get() = rig_core::device::identity([0, 1, 0]).to_bytes() };
    // SAFETY: documented values: the slave's address in the upper seven bits, then enabled.
    unsafe {
        bus.twar().write(|writer| writer.bits(BUS_ADDRESS << 1));
        bus.twcr().write(|writer| writer.bits(GO_ON));
    }
}

/// What the master has asked for since the last call.
pub fn take_request() -> Request {
    interrupt::free(|section| REQUEST.borrow(section).replace(Request::None))
}

/// The number that an answer handed over now must bear: one more than the frames read so far, the one that is being
/// read included.
fn next_sequence(section: interrupt::CriticalSection<'_>) -> u16 {
    let reading = BUSY.borrow(section).get() && SELECTION.borrow(section).get().selected == Selected::Frame;
    SERVED.borrow(section).get().wrapping_add(1).wrapping_add(u16::from(reading))
}

/// Composes the answers for a snapshot and hands them to the bus: at once while it is at rest, else at the end of the
/// read that is under way.
///
/// Composing takes longer than a fast master leaves between two reads. Answers are therefore never thrown away because
/// something was read meanwhile, nor overwritten while they wait: only their sequence number is made anew.
#[inline(never)]
pub fn publish(snapshot: &Snapshot) {
    let (spare, mut sequence) = interrupt::free(|section| {
        let (ready, waiting) = (READY.borrow(section).get(), WAITING.borrow(section).get());
        let spare = (0..3).find(|set| *set != ready && *set != waiting).unwrap_or(0);
        (spare, next_sequence(section))
    });
    // SAFETY: neither `READY` nor `WAITING` names this set before it is handed over below.
    let Some(answer) = (unsafe { &mut *ANSWERS.0.get() }).get_mut(usize::from(spare)) else { return };
    answer.fill(snapshot, sequence);
    // A read lasts far longer than a new number: the second attempt succeeds.
    for _ in 0..4 {
        let wanted = interrupt::free(|section| {
            let wanted = next_sequence(section);
            if wanted == sequence {
                WAITING.borrow(section).set(spare);
                if !BUSY.borrow(section).get() {
                    READY.borrow(section).set(spare);
                }
            }
            wanted
        });
        if wanted == sequence {
            return;
        }
        sequence = wanted;
        answer.renumber(sequence);
    }
}

fn next_byte(section: interrupt::CriticalSection<'_>) -> u8 {
    let place = NEXT_BYTE.borrow(section);
    let at = usize::from(place.get());
    place.set(place.get().saturating_add(1));
    let ready = usize::from(READY.borrow(section).get());
    // SAFETY: the main loop never writes this set.
    let Some(answer) = (unsafe { &*ANSWERS.0.get() }).get(ready) else { return 0xff };
    let bytes: &[u8] = match SELECTION.borrow(section).get().selected {
        Selected::Legacy => &answer.legacy,
        Selected::Frame => &answer.frame,
        // SAFETY: only read since interrupts were enabled.
        Selected::Identity => unsafe { &*IDENTITY.0.get() },
    };
    bytes.get(at).copied().unwrap_or(0xff)
}

fn end_read(section: interrupt::CriticalSection<'_>) {
    if BUSY.borrow(section).replace(false) {
        let selection = SELECTION.borrow(section);
        let mut ended = selection.get();
        if ended.selected == Selected::Frame {
            let served = SERVED.borrow(section);
            served.set(served.get().wrapping_add(1));
        }
        ended.end_read();
        selection.set(ended);
        READY.borrow(section).set(WAITING.borrow(section).get());
    }
}

#[avr_device::interrupt(atmega328p)]
fn TWI() {
    // SAFETY: an interrupt of this processor is not interrupted, and nothing else uses the bus's registers.
    let (section, bus) = unsafe { (interrupt::CriticalSection::new(), Peripherals::steal().TWI) };
    let selection = SELECTION.borrow(section);
    let mut go_on = GO_ON;
    match bus.twsr().read().bits() & 0xf8 {
        // Addressed to be written to, directly or by a general call or after losing the bus.
        0x60 | 0x68 | 0x70 | 0x78 => {
            end_read(section);
            let mut started = selection.get();
            started.start_write();
            selection.set(started);
        }
        // A byte written.
        0x80 | 0x88 | 0x90 | 0x98 => {
            let mut written = selection.get();
            let request = written.byte(bus.twdr().read().bits());
            selection.set(written);
            if request != Request::None {
                REQUEST.borrow(section).set(request);
            }
        }
        // Addressed to be read.
        0xa8 | 0xb0 => {
            // A read that its master gave up without a word ends here.
            end_read(section);
            BUSY.borrow(section).set(true);
            NEXT_BYTE.borrow(section).set(0);
            let byte = next_byte(section);
            // SAFETY: every byte may be sent.
            bus.twdr().write(|writer| unsafe { writer.bits(byte) });
        }
        // A byte read, more wanted.
        0xb8 => {
            let byte = next_byte(section);
            // SAFETY: every byte may be sent.
            bus.twdr().write(|writer| unsafe { writer.bits(byte) });
        }
        // The last byte read.
        0xc0 | 0xc8 => end_read(section),
        // An illegal start or stop.
        0x00 => {
            end_read(section);
            go_on = RECOVER;
        }
        // The end of a write, and states that a slave does not enter.
        _ => {}
    }
    // SAFETY: a documented value.
    bus.twcr().write(|writer| unsafe { writer.bits(go_on) });
}
