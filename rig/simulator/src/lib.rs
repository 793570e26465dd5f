//! The firmware's own binary, run by simavr cycle by cycle, with everything that a real device has around it: Hall
//! sensors,
//! converter, ignition relay, and a bus master.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ffi::{CString, c_char, c_int};
use std::path::Path;

pub mod pulses;

/// Cycles in one second.
pub const CYCLES_PER_SECOND: u64 = 16_000_000;

#[repr(C)]
struct RawChip {
    _private: [u8; 0],
}

unsafe extern "C" {
    fn chip_open(path: *const c_char) -> *mut RawChip;
    fn chip_close(chip: *mut RawChip);
    fn chip_cycle(chip: *mut RawChip) -> u64;
    fn chip_run(chip: *mut RawChip, cycle: u64) -> c_int;
    fn chip_pin(chip: *mut RawChip, number: c_int, high: c_int);
    fn chip_conversion(chip: *mut RawChip, bits: u32);
    fn chip_relay(chip: *mut RawChip, changed: *mut u64) -> c_int;
    fn chip_bus_status(chip: *mut RawChip, status: u8, data: c_int);
    fn chip_bus_held(chip: *mut RawChip) -> c_int;
    fn chip_bus_address(chip: *mut RawChip) -> c_int;
    fn chip_bus_data(chip: *mut RawChip) -> u8;
    fn chip_variable(chip: *mut RawChip, name: *const c_char) -> c_int;
    fn chip_poke(chip: *mut RawChip, address: c_int, value: u8);
    fn chip_hang(chip: *mut RawChip) -> c_int;
}

/// What went wrong with the simulated device.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SimulationError {
    /// The firmware could not be loaded.
    Load,
    /// The processor stopped or ran into nowhere, at this cycle.
    Crashed(u64),
    /// The slave held the clock line for more than 20 ms, or does not listen to the address.
    BusStuck,
    /// The firmware has no variable of this name.
    NoVariable(&'static str),
}

impl std::fmt::Display for SimulationError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for SimulationError {}

/// Something that happens to the device from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Event {
    /// A pin of port D takes a level.
    Pin(u8, bool),
    /// The converter has a result, 24 bits with its status.
    Conversion(u32),
}

/// The primary's Hall sensor, at D2.
pub const PRIMARY_PIN: u8 = 2;
/// The secondary's Hall sensor, at D3.
pub const SECONDARY_PIN: u8 = 3;

/// The device and its surroundings.
pub struct Bench {
    chip: *mut RawChip,
    events: BinaryHeap<Reverse<(u64, Event)>>,
    cycles_per_bit: u64,
    longest_hold: u64,
}

impl Drop for Bench {
    fn drop(&mut self) {
        // SAFETY: `chip` came from `chip_open` and is closed once.
        unsafe { chip_close(self.chip) };
    }
}

impl Bench {
    /// Starts the firmware in the file given (ELF), with a bus at `bus_hertz`.
    ///
    /// # Errors
    /// If it cannot be loaded.
    pub fn start(firmware: &Path, bus_hertz: u64) -> Result<Self, SimulationError> {
        let path = CString::new(firmware.to_string_lossy().as_bytes()).map_err(|_| SimulationError::Load)?;
        // SAFETY: a string with its end; null is checked.
        let chip = unsafe { chip_open(path.as_ptr()) };
        if chip.is_null() {
            return Err(SimulationError::Load);
        }
        Ok(Self { chip, events: BinaryHeap::new(), cycles_per_bit: CYCLES_PER_SECOND / bus_hertz, longest_hold: 0 })
    }

    /// The present cycle.
    #[must_use]
    pub fn cycle(&self) -> u64 {
        // SAFETY: `chip` is open.
        unsafe { chip_cycle(self.chip) }
    }

    /// Lets something happen at a cycle to come.
    pub fn schedule(&mut self, cycle: u64, event: Event) {
        self.events.push(Reverse((cycle, event)));
    }

    /// Runs to a cycle, letting everything happen that was scheduled before it.
    ///
    /// # Errors
    /// If the processor crashes.
    pub fn run_to(&mut self, cycle: u64) -> Result<(), SimulationError> {
        while let Some(Reverse((at, event))) = self.events.peek().copied() {
            if at > cycle {
                break;
            }
            self.events.pop();
            self.step_to(at)?;
            // SAFETY: `chip` is open.
            unsafe {
                match event {
                    Event::Pin(pin, high) => chip_pin(self.chip, c_int::from(pin), c_int::from(high)),
                    Event::Conversion(bits) => chip_conversion(self.chip, bits),
                }
            }
        }
        self.step_to(cycle)
    }

    /// Runs for a number of cycles.
    ///
    /// # Errors
    /// If the processor crashes.
    pub fn run(&mut self, cycles: u64) -> Result<(), SimulationError> {
        self.run_to(self.cycle() + cycles)
    }

    fn step_to(&mut self, cycle: u64) -> Result<(), SimulationError> {
        // SAFETY: `chip` is open.
        if unsafe { chip_run(self.chip, cycle) } == 0 { Err(SimulationError::Crashed(self.cycle())) } else { Ok(()) }
    }

    /// The ignition relay: whether it is closed, and the cycle of its last change.
    #[must_use]
    pub fn relay(&self) -> (bool, u64) {
        let mut changed = 0;
        // SAFETY: `chip` is open, the pointer is valid for the call.
        let closed = unsafe { chip_relay(self.chip, &mut changed) };
        (closed != 0, changed)
    }

    /// The longest time, in cycles, for which the slave has held the clock line.
    #[must_use]
    pub fn longest_hold(&self) -> u64 {
        self.longest_hold
    }

    /// Raises a state of the bus and waits until the slave has answered it.
    fn bus(&mut self, status: u8, data: Option<u8>) -> Result<(), SimulationError> {
        let start = self.cycle();
        // SAFETY: `chip` is open.
        unsafe { chip_bus_status(self.chip, status, data.map_or(-1, c_int::from)) };
        // SAFETY: as above.
        while unsafe { chip_bus_held(self.chip) } != 0 {
            self.run(8)?;
            if self.cycle() - start > CYCLES_PER_SECOND / 50 {
                return Err(SimulationError::BusStuck);
            }
        }
        self.longest_hold = self.longest_hold.max(self.cycle() - start);
        Ok(())
    }

    fn byte_time(&mut self) -> Result<(), SimulationError> {
        self.run(9 * self.cycles_per_bit)
    }

    fn address(&mut self) -> Result<(), SimulationError> {
        // SAFETY: `chip` is open.
        if unsafe { chip_bus_address(self.chip) } != c_int::from(rig_core::frame::BUS_ADDRESS) {
            return Err(SimulationError::BusStuck);
        }
        self.byte_time()
    }

    /// The master writes.
    ///
    /// # Errors
    /// If the slave does not answer.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), SimulationError> {
        self.address()?;
        self.bus(0x60, None)?;
        for byte in bytes {
            self.byte_time()?;
            self.bus(0x80, Some(*byte))?;
        }
        self.bus(0xa0, None)
    }

    /// The master reads `count` bytes.
    ///
    /// # Errors
    /// If the slave does not answer.
    pub fn read(&mut self, count: usize) -> Result<Vec<u8>, SimulationError> {
        self.address()?;
        self.bus(0xa8, None)?;
        let mut bytes = Vec::with_capacity(count);
        for place in 0..count {
            // SAFETY: `chip` is open.
            bytes.push(unsafe { chip_bus_data(self.chip) });
            self.byte_time()?;
            self.bus(if place + 1 == count { 0xc0 } else { 0xb8 }, None)?;
        }
        Ok(bytes)
    }

    /// Selects a register and reads, as one transfer with a repeated start.
    ///
    /// # Errors
    /// If the slave does not answer.
    pub fn transfer(&mut self, write: &[u8], count: usize) -> Result<Vec<u8>, SimulationError> {
        self.write(write)?;
        self.read(count)
    }

    /// Sets four bytes of a variable of the firmware.
    ///
    /// # Errors
    /// If there is no such variable.
    pub fn set_variable(&mut self, name: &'static str, value: u32) -> Result<(), SimulationError> {
        let text = CString::new(name).map_err(|_| SimulationError::NoVariable(name))?;
        // SAFETY: `chip` is open, the string has its end.
        let address = unsafe { chip_variable(self.chip, text.as_ptr()) };
        if address < 0 {
            return Err(SimulationError::NoVariable(name));
        }
        for (offset, byte) in (0..).zip(value.to_le_bytes()) {
            // SAFETY: an address of the firmware's own memory.
            unsafe { chip_poke(self.chip, address + offset, byte) };
        }
        Ok(())
    }

    /// The program hangs with interrupts off.
    ///
    /// # Errors
    /// If the program has no instruction that jumps to itself.
    pub fn hang(&mut self) -> Result<(), SimulationError> {
        // SAFETY: `chip` is open.
        if unsafe { chip_hang(self.chip) } == 0 { Err(SimulationError::NoVariable("self jump")) } else { Ok(()) }
    }
}
