//! How long things take, where there is a clock.

#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
use std::time::Instant;

/// Measures the time since its start. In a browser's sandbox (`wasm32-unknown-unknown`), where the standard library has
/// no clock, it measures nothing.
#[derive(Debug, Clone, Copy)]
pub struct Stopwatch {
    #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
    start: Instant,
}

impl Stopwatch {
    /// Starts now.
    pub fn start() -> Self {
        Self {
            #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
            start: Instant::now(),
        }
    }

    /// Seconds since the start; nothing where there is no clock.
    pub fn seconds(&self) -> Option<f64> {
        #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
        let seconds = Some(self.start.elapsed().as_secs_f64());
        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        let seconds = None;
        seconds
    }
}
