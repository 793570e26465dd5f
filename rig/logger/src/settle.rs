//! Whether a quantity has settled: decided by the data instead of by the clock (the thesis waits four seconds).
//!
//! The signal is averaged in blocks as long as several working cycles of the engine, and a straight line is laid
//! through
//! the last blocks. Settled is what is shown to drift by less than its tolerance over them: the slope together with its
//! 95 % interval, not the slope alone, so that noise delays the answer and never hastens it.

/// Blocks that the line goes through.
const BLOCKS: usize = 6;
/// Student's t for four degrees of freedom, 95 %, two-sided.
const T_95: f64 = 2.776;

/// One quantity.
#[derive(Clone, Debug)]
pub struct Settling {
    tolerance: f64,
    block_ms: u64,
    block_end_ms: Option<u64>,
    sum: f64,
    count: u32,
    blocks: Vec<f64>,
}

impl Settling {
    /// A quantity that counts as settled when it drifts by less than `tolerance` over six blocks of `block_ms`.
    #[must_use]
    pub fn new(tolerance: f64, block_ms: u64) -> Self {
        Self { tolerance, block_ms, block_end_ms: None, sum: 0.0, count: 0, blocks: Vec::new() }
    }

    /// A value at a time.
    pub fn push(&mut self, time_ms: u64, value: f64) {
        if !value.is_finite() {
            return;
        }
        let end = *self.block_end_ms.get_or_insert(time_ms + self.block_ms);
        if time_ms >= end && self.count > 0 {
            self.blocks.push(self.sum / f64::from(self.count));
            if self.blocks.len() > BLOCKS {
                self.blocks.remove(0);
            }
            (self.sum, self.count) = (0.0, 0);
            self.block_end_ms = Some(time_ms + self.block_ms);
        }
        self.sum += value;
        self.count += 1;
    }

    /// Forgets everything: the load has changed.
    pub fn restart(&mut self) {
        *self = Self::new(self.tolerance, self.block_ms);
    }

    /// Drift over the blocks and its 95 % interval, once there are enough.
    #[must_use]
    pub fn drift(&self) -> Option<(f64, f64)> {
        if self.blocks.len() < BLOCKS {
            return None;
        }
        let middle = (BLOCKS - 1) as f64 / 2.0;
        let mean = self.blocks.iter().sum::<f64>() / BLOCKS as f64;
        let offsets = || self.blocks.iter().zip(0u32..).map(|(value, place)| (f64::from(place) - middle, value - mean));
        let xx: f64 = offsets().map(|(x, _)| x * x).sum();
        let slope = offsets().map(|(x, y)| x * y).sum::<f64>() / xx;
        let residual: f64 = offsets().map(|(x, y)| (y - slope * x).powi(2)).sum();
        let error = (residual / (BLOCKS - 2) as f64 / xx).sqrt();
        let span = (BLOCKS - 1) as f64;
        Some((slope * span, T_95 * error * span))
    }

    /// Whether the quantity has settled.
    #[must_use]
    pub fn settled(&self) -> bool {
        self.drift().is_some_and(|(drift, interval)| drift.abs() + interval < self.tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Time at which an exponential approach with noise is called settled, ms, and how far it then has to go.
    fn settle(time_constant_ms: f64, noise: f64) -> (u64, f64) {
        let mut settling = Settling::new(15.0, 300);
        for step in 0..20_000u64 {
            let time = step * 7;
            let left = 400.0 * (-(time as f64) / time_constant_ms).exp();
            let wave = noise * (time as f64 * 0.157).sin();
            settling.push(time, 2000.0 + left + wave);
            if settling.settled() {
                return (time, left);
            }
        }
        panic!("never settled");
    }

    #[test]
    fn slow_approaches_are_waited_for_and_fast_ones_are_not() {
        let (fast, left) = settle(200.0, 20.0);
        assert!(fast < 4000 && left < 15.0, "{fast} ms, {left} rpm left");
        let (slow, left) = settle(3000.0, 20.0);
        assert!(slow > 6000 && left < 30.0, "{slow} ms, {left} rpm left");
    }

    #[test]
    fn nothing_is_settled_before_six_blocks_nor_while_it_drifts() {
        let mut settling = Settling::new(15.0, 300);
        for time in (0..1800).step_by(7) {
            settling.push(time, 2000.0);
            assert!(!settling.settled());
        }
        settling.restart();
        for time in (0..60_000).step_by(7) {
            settling.push(time, time as f64 * 0.02);
            assert!(!settling.settled(), "30 rpm in six blocks");
        }
    }
}
