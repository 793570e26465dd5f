//! Random numbers that are the same on every machine: for made data, benchmarks and tests.

use std::f64::consts::TAU;

/// A deterministic stream of 64-bit numbers (G. L. Steele, D. Lea, C. H. Flood, SplitMix64, OOPSLA 2014).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number of 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [0, 1).
    pub fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform between two numbers; with `log`, in their logarithms.
    pub fn between(&mut self, from: f64, to: f64, log: bool) -> f64 {
        let u = self.uniform();
        if log { from * libm::pow(to / from, u) } else { from + (to - from) * u }
    }

    /// Normal with standard deviation 1 (G. E. P. Box, M. E. Muller, Ann. Math. Stat. 29, 1958).
    pub fn normal(&mut self) -> f64 {
        let (a, b) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * libm::log(a)).sqrt() * libm::cos(TAU * b)
    }

    /// Whether something happens that has this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.uniform() < probability
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_stream() {
        // The first numbers of seed 1234567 as the authors' own code gives them.
        let mut random = Random::new(1_234_567);
        let first = [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423];
        assert_eq!([random.bits(), random.bits(), random.bits()], first);
    }

    #[test]
    fn moments_are_those_of_their_distributions() {
        let mut random = Random::new(7);
        let count = 100_000;
        let (mut sum, mut square) = (0.0, 0.0);
        for _ in 0..count {
            let x = random.normal();
            (sum, square) = (sum + x, square + x * x);
        }
        let count = f64::from(count);
        assert!((sum / count).abs() < 0.02 && (square / count - 1.0).abs() < 0.02, "{sum} {square}");
        assert!((0..1000).all(|_| (2.0..8.0).contains(&random.between(2.0, 8.0, true))));
    }
}
