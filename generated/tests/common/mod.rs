//! Random states inside physical ranges, and ways to call kernels. Not every test uses all of it.
#![allow(dead_code, clippy::panic)]

use generated::{BOUNDARIES, BoundaryKernel, OUTPUT_SETS, RegionFn, RegionKernel, RegionOut, Symbol};

/// Splitmix64: small, seeded, the same everywhere.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// Where the sliding speed lies against the threshold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slip {
    Below,
    Beyond,
}

/// One point: independent variable, states, constants.
#[derive(Debug, Clone)]
pub struct Point {
    pub s: f64,
    pub y: Vec<f64>,
    pub constants: Vec<f64>,
}

/// A random point for any kernel, by the names of its symbols.
pub fn point(kernel: &RegionKernel, random: &mut Random, slip: Slip) -> Point {
    let (omega, radius) = (random.between(200.0, 450.0), random.between(0.05, 0.1));
    let mut draw = |name: &str| match name {
        "T" | "tau" => random.between(20.0, 900.0),
        "theta" => random.between(-0.1, 0.1),
        "theta1" => random.between(-1.0, 1.0),
        "theta2" => random.between(-10.0, 10.0),
        "x" => random.between(1e-5, 2e-3),
        "vartheta" => random.between(-4.0, 7.0),
        "vartheta1" | "vartheta2" => random.between(-3.0, 3.0),
        "Phi" => random.between(2.0, 4.0),
        "L" => random.between(0.05, 0.4),
        "sigma" => random.between(0.85, 0.98),
        "flow" => random.between(0.99, 1.01),
        "EA" => random.between(5e4, 4e5),
        "EI" => random.between(0.05, 0.5),
        "k" => random.between(5e6, 3e7),
        "m_o" => random.between(0.2, 0.6),
        "R" | "R_P" => radius,
        "beta" => random.between(0.15, 0.35),
        "mu_k" => random.between(0.2, 0.6),
        "v_thr" if slip == Slip::Beyond => random.between(1e-3, 1e-1),
        "v_thr" => random.between(20.0, 40.0),
        "omega_P" => omega,
        other => panic!("no range for {other}"),
    };
    Point {
        y: kernel.states.iter().map(|state| draw(state.name())).collect(),
        constants: kernel.constants.iter().map(|constant| draw(constant.name())).collect(),
        s: random.between(0.0, 1.0),
    }
}

/// Everything that one call writes.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Written {
    pub f: Vec<f64>,
    pub dy: Vec<f64>,
    pub dc: Vec<f64>,
    pub fields: Vec<f64>,
}

/// Rows of everything that a kernel's functions may write.
pub fn room(kernel: &RegionKernel, stride: usize) -> Written {
    let rows = |count: usize| vec![f64::NAN; count * stride];
    Written {
        f: rows(kernel.states.len() + kernel.integrals.len()),
        dy: rows(kernel.state_pattern.len()),
        dc: rows(kernel.constant_pattern.len()),
        fields: rows(kernel.fields.len()),
    }
}

/// Calls a function on a batch.
pub fn call(function: RegionFn, m: usize, stride: usize, s: &[f64], y: &[f64], constants: &[f64], to: &mut Written) {
    let mut out = RegionOut { f: &mut to.f, dy: &mut to.dy, dc: &mut to.dc, fields: &mut to.fields };
    function(m, stride, s, y, constants, &mut out);
}

/// Calls a function at one point.
pub fn at(kernel: &RegionKernel, function: RegionFn, point: &Point) -> Written {
    let mut written = room(kernel, 1);
    call(function, 1, 1, &[point.s], &point.y, &point.constants, &mut written);
    written
}

/// Ridders' extrapolation of central differences: the derivative of every component, and an estimate of its error.
pub fn ridders(f: impl Fn(f64) -> Vec<f64>, at: f64, first_step: f64) -> Vec<(f64, f64)> {
    const SHRINK: f64 = 1.6;
    const ROWS: usize = 8;
    let difference = |h: f64| {
        let (up, down) = (f(at + h), f(at - h));
        up.iter().zip(down).map(|(up, down)| (up - down) / (2.0 * h)).collect::<Vec<f64>>()
    };
    let count = f(at).len();
    let mut best = vec![(0.0, f64::INFINITY); count];
    let mut table: Vec<Vec<f64>> = Vec::new();
    let mut h = first_step;
    for row in 0..ROWS {
        let mut new = vec![difference(h)];
        for column in 1..=row {
            let factor = SHRINK.powi(2 * column as i32);
            let previous = &table[column - 1];
            let next: Vec<f64> =
                (0..count).map(|i| (new[column - 1][i] * factor - previous[i]) / (factor - 1.0)).collect();
            for (i, best) in best.iter_mut().enumerate() {
                let error = (next[i] - new[column - 1][i]).abs().max((next[i] - previous[i]).abs());
                if error <= best.1 {
                    *best = (next[i], error);
                }
            }
            new.push(next);
        }
        table = new;
        h /= SHRINK;
    }
    best
}

/// Symbols of a region's states, then of its constants.
pub fn inputs(kernel: &RegionKernel) -> impl Iterator<Item = &'static Symbol> {
    let states = kernel.states.iter().map(|state| state.symbol());
    states.chain(kernel.constants.iter().map(|constant| constant.symbol()))
}

/// All sets of equations in ends, integrals and constants: boundary equations and outputs.
pub fn sets() -> impl Iterator<Item = &'static BoundaryKernel> {
    BOUNDARIES.iter().copied().chain(OUTPUT_SETS.iter().map(|outputs| &outputs.set))
}
