//! The dynamometer's measuring device on an ATmega328P (an Arduino Nano) with a 16 MHz crystal.
//!
//! | pin | what |
//! |---|---|
//! | D2 (PD2, INT0) | Hall sensor of the primary, falling edge |
//! | D3 (PD3, INT1) | Hall sensor of the secondary, falling edge |
//! | D4 (PD4) | clock to the AD7171 |
//! | D5 (PD5) | data from the AD7171 |
//! | D6 (PD6) | ignition relay: high while the run permit holds; a pull-down keeps it low through a reset |
//! | A4, A5 (PC4, PC5) | I²C, address 0x03 |
//!
//! Interrupts do as little as can be: a Hall edge is stamped and queued, a bus byte is handed over. All reckoning is
//! done
//! in the main loop, which composes the bus's answers from one snapshot into a spare buffer and exchanges the buffers
//! while
//! the bus is at rest, so that no answer mixes two moments. The loop restarts the watchdog; a hang resets the device
//! within
//! a quarter of a second, and a device in reset has dropped the ignition relay.

#![no_std]
#![no_main]
#![feature(abi_avr_interrupt)]

mod bus;
mod pulses;

use core::cell::{Cell, UnsafeCell};

use avr_device::atmega328p::{PORTD, Peripherals};
use avr_device::interrupt::{self, Mutex};
use rig_core::device::Device;
use rig_core::wire::Request;
use rig_core::{Clock, Instant, Snapshot, ad7171};

/// Times that the 16-bit counter has overflowed. Under this name a simulator finds it, to come near a roll-over
/// quickly.
#[unsafe(export_name = "rig_overflows")]
#[used]
static OVERFLOWS: Mutex<Cell<Clock>> = Mutex::new(Cell::new(Clock::new()));

const CLOCK_PIN: u8 = 1 << 4;
const DATA_PIN: u8 = 1 << 5;
const PERMIT_PIN: u8 = 1 << 6;
const HALL_PINS: u8 = 1 << 2 | 1 << 3;

/// The present moment. Needs interrupts to be held off, which a critical section proves.
fn now(section: interrupt::CriticalSection<'_>) -> Instant {
    // SAFETY: only reads two registers of the timer.
    let timer = unsafe { Peripherals::steal() }.TC1;
    let counter = timer.tcnt1().read().bits();
    let pending = timer.tifr1().read().bits() & 1 != 0;
    OVERFLOWS.borrow(section).get().instant(counter, pending)
}

#[avr_device::interrupt(atmega328p)]
fn TIMER1_OVF() {
    // SAFETY: an interrupt of this processor is not interrupted.
    let section = unsafe { interrupt::CriticalSection::new() };
    let overflows = OVERFLOWS.borrow(section);
    let mut clock = overflows.get();
    clock.overflow();
    overflows.set(clock);
}

struct ConverterWires<'a>(&'a PORTD);

impl ad7171::Wires for ConverterWires<'_> {
    fn data_is_high(&mut self) -> bool {
        self.0.pind().read().bits() & DATA_PIN != 0
    }

    fn clock_pulse(&mut self) -> bool {
        set(self.0, CLOCK_PIN, false);
        // The converter shows the bit at most 80 ns after the falling edge; each of these takes longer.
        set(self.0, CLOCK_PIN, true);
        self.data_is_high()
    }
}

fn set(port: &PORTD, pin: u8, high: bool) {
    port.portd().modify(|register, writer| {
        let bits = if high { register.bits() | pin } else { register.bits() & !pin };
        // SAFETY: every value of an output register is valid.
        unsafe { writer.bits(bits) }
    });
}

/// Why the processor started, as it says itself; read once and cleared.
fn reset_cause(peripherals: &Peripherals) -> u8 {
    let cause = peripherals.CPU.mcusr().read().bits() & 0x0f;
    // SAFETY: clearing the register is what it is for.
    peripherals.CPU.mcusr().write(|writer| unsafe { writer.bits(0) });
    cause
}

/// The watchdog resets the processor after 0.25 s without a restart.
#[inline(never)]
fn start_watchdog(peripherals: &Peripherals) {
    interrupt::free(|_| {
        avr_device::asm::wdr();
        // SAFETY: the two writes that the data sheet asks for within four cycles: unlock, then 0.25 s (WDP2) and reset
        // (WDE).
        peripherals.WDT.wdtcsr().write(|writer| unsafe { writer.bits(0b0001_1000) });
        peripherals.WDT.wdtcsr().write(|writer| unsafe { writer.bits(0b0000_1100) });
    });
}

#[inline(never)]
fn set_up(peripherals: &Peripherals) {
    let port = &peripherals.PORTD;
    // SAFETY: documented values of the data sheet: outputs D4 and D6, pull-ups on the sensors, clock high, relay low;
    // timer 1 counts 4 µs steps and interrupts on overflow; INT0 and INT1 on falling edges.
    unsafe {
        port.portd().write(|writer| writer.bits(CLOCK_PIN | DATA_PIN | HALL_PINS));
        port.ddrd().write(|writer| writer.bits(CLOCK_PIN | PERMIT_PIN));
        peripherals.TC1.tccr1a().write(|writer| writer.bits(0));
        peripherals.TC1.tccr1b().write(|writer| writer.bits(0b011));
        peripherals.TC1.timsk1().write(|writer| writer.bits(1));
        peripherals.EXINT.eicra().write(|writer| writer.bits(0b1010));
        peripherals.EXINT.eifr().write(|writer| writer.bits(0b11));
        peripherals.EXINT.eimsk().write(|writer| writer.bits(0b11));
    }
    bus::set_up(&peripherals.TWI);
}

/// What the main loop alone uses. It has its place in memory rather than on the stack: stack frames stay below 64
/// bytes,
/// beyond which the compiler's code for this processor is slow and has been seen to be wrong.
struct OfMain<T>(UnsafeCell<T>);

// SAFETY: only `main` takes a reference, once.
unsafe impl<T> Sync for OfMain<T> {}

static DEVICE: OfMain<Device> = OfMain(UnsafeCell::new(Device::new(0)));
static SNAPSHOT: OfMain<Snapshot> = OfMain(UnsafeCell::new(Snapshot::EMPTY));

#[avr_device::entry]
fn main() -> ! {
    // SAFETY: the only place that owns the peripherals; interrupts touch the registers named in them alone.
    let peripherals = unsafe { Peripherals::steal() };
    // SAFETY: the only references to these.
    let (device, snapshot) = unsafe { (&mut *DEVICE.0.get(), &mut *SNAPSHOT.0.get()) };
    device.started_because(reset_cause(&peripherals));
    start_watchdog(&peripherals);
    set_up(&peripherals);
    // SAFETY: everything that an interrupt uses is initialised.
    unsafe { interrupt::enable() };
    loop {
        avr_device::asm::wdr();
        take_pulses(device);
        convert(device, &peripherals.PORTD);
        let moment = interrupt::free(now);
        match bus::take_request() {
            Request::Grant => device.permit.grant(moment),
            Request::Withdraw => device.permit.withdraw(),
            Request::None => {}
        }
        device.observe(moment, snapshot);
        set(&peripherals.PORTD, PERMIT_PIN, snapshot.permitted);
        bus::publish(snapshot);
    }
}

#[inline(never)]
fn take_pulses(device: &mut Device) {
    while let Some(at) = pulses::PRIMARY.take() {
        device.primary.pulse(at);
    }
    while let Some(at) = pulses::SECONDARY.take() {
        device.secondary.pulse(at);
    }
}

#[inline(never)]
fn convert(device: &mut Device, port: &PORTD) {
    if port.pind().read().bits() & DATA_PIN == 0 {
        let at = interrupt::free(now);
        if let Some(result) = ad7171::poll(&mut ConverterWires(port)) {
            device.conversion(at, result);
        }
    }
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // The watchdog resets the device; the relay is dropped at once.
    interrupt::disable();
    // SAFETY: the program has ended, nothing else uses the port.
    set(&unsafe { Peripherals::steal() }.PORTD, PERMIT_PIN, false);
    loop {}
}
