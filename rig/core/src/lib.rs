//! What the dynamometer's microcontroller and its logger have in common, without the standard library.
//!
//! The firmware (ATmega328P) runs this code against its registers; the tests and the simulated rig run the same code
//! on the host. Times are counts of the microcontroller's 4 µs clock ([`Instant`]), speeds are a number of revolutions
//! over a number of such counts ([`Speed`]), so that nothing is divided where interrupts wait.

#![no_std]
#![forbid(unsafe_code)]

pub mod ad7171;
pub mod clock;
pub mod device;
pub mod frame;
pub mod permit;
pub mod snapshot;
pub mod speed;
pub mod wire;

pub use clock::{Clock, Instant, TICK_MICROSECONDS, TICKS_PER_SECOND};
pub use device::BusAnswer;
pub use frame::{Frame, FrameError, Identity, LegacyFrame};
pub use permit::RunPermit;
pub use snapshot::{Counters, Snapshot};
pub use speed::{PulseLimits, Reading, Speed, SpeedMeter, Verdict};
