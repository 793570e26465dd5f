//! Hall edges on their way from their interrupts to the main loop.

use core::cell::Cell;

use avr_device::interrupt::{self, Mutex};
use rig_core::Instant;

/// Room for the edges of one turn of the main loop (less than 2 ms); a burst of bounces beyond it is dropped, its first
/// edge, which is the true one, is not.
const ROOM: u8 = 8;

/// A queue of moments.
pub struct Pulses {
    moments: Mutex<[Cell<Instant>; ROOM as usize]>,
    first: Mutex<Cell<u8>>,
    count: Mutex<Cell<u8>>,
}

/// Edges of the primary's sensor.
pub static PRIMARY: Pulses = Pulses::new();
/// Edges of the secondary's sensor.
pub static SECONDARY: Pulses = Pulses::new();

impl Pulses {
    const fn new() -> Self {
        Self {
            moments: Mutex::new([const { Cell::new(Instant(0)) }; ROOM as usize]),
            first: Mutex::new(Cell::new(0)),
            count: Mutex::new(Cell::new(0)),
        }
    }

    fn put(&self, section: interrupt::CriticalSection<'_>, at: Instant) {
        let count = self.count.borrow(section);
        let place = (self.first.borrow(section).get() + count.get()) % ROOM;
        if count.get() < ROOM
            && let Some(moment) = self.moments.borrow(section).get(usize::from(place))
        {
            moment.set(at);
            count.set(count.get() + 1);
        }
    }

    /// The earliest edge that has not been taken yet.
    pub fn take(&self) -> Option<Instant> {
        interrupt::free(|section| {
            let count = self.count.borrow(section);
            let first = self.first.borrow(section);
            if count.get() == 0 {
                return None;
            }
            let moment = self.moments.borrow(section).get(usize::from(first.get())).map(Cell::get);
            first.set((first.get() + 1) % ROOM);
            count.set(count.get() - 1);
            moment
        })
    }
}

#[avr_device::interrupt(atmega328p)]
fn INT0() {
    // SAFETY: an interrupt of this processor is not interrupted.
    let section = unsafe { interrupt::CriticalSection::new() };
    PRIMARY.put(section, crate::now(section));
}

#[avr_device::interrupt(atmega328p)]
fn INT1() {
    // SAFETY: an interrupt of this processor is not interrupted.
    let section = unsafe { interrupt::CriticalSection::new() };
    SECONDARY.put(section, crate::now(section));
}
