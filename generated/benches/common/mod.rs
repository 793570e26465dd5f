//! A batch of points of a kernel, near the base case.

use generated::{RegionFn, RegionKernel, RegionOut};

/// Points per call: the order of a region's mesh. No multiple of 64: rows a power of two apart share the cache's sets.
pub const POINTS: usize = 250;

/// The base case, near enough: what a kernel costs does not depend on it.
fn magnitude(name: &str) -> f64 {
    match name {
        "T" | "tau" => 200.0,
        "theta" | "theta1" => 1e-2,
        "theta2" | "vartheta1" | "vartheta2" => 0.1,
        "x" => 1e-4,
        "vartheta" => 3.0,
        "Phi" => 3.1,
        "L" => 0.2,
        "sigma" => 0.99,
        "flow" => 1.0,
        "EA" => 243.5e3,
        "EI" => 0.26,
        "k" => 18.71e6,
        "m_o" => 0.4375,
        "R" | "R_P" => 0.068,
        "beta" => 0.2,
        "mu_k" => 0.4,
        "v_thr" => 1e-4,
        _ => 356.0,
    }
}

pub struct Batch {
    s: Vec<f64>,
    y: Vec<f64>,
    constants: Vec<f64>,
    f: Vec<f64>,
    dy: Vec<f64>,
    dc: Vec<f64>,
    fields: Vec<f64>,
}

impl Batch {
    pub fn new(kernel: &RegionKernel) -> Self {
        let s: Vec<f64> = (0..POINTS).map(|j| j as f64 / POINTS as f64).collect();
        let vary = |name: &'static str| s.iter().map(move |s| magnitude(name) * (1.0 + 0.1 * (7.0 * s).sin()));
        let y = kernel.states.iter().flat_map(|state| vary(state.name())).collect();
        let constants = kernel.constants.iter().map(|constant| magnitude(constant.name())).collect();
        let rows = |count: usize| vec![0.0; count * POINTS];
        Self {
            y,
            constants,
            f: rows(kernel.states.len() + kernel.integrals.len()),
            dy: rows(kernel.state_pattern.len()),
            dc: rows(kernel.constant_pattern.len()),
            fields: rows(kernel.fields.len()),
            s,
        }
    }

    pub fn run(&mut self, function: RegionFn) {
        let (f, dy, dc, fields) = (&mut self.f, &mut self.dy, &mut self.dc, &mut self.fields);
        let mut out = RegionOut { f, dy, dc, fields };
        function(POINTS, POINTS, &self.s, &self.y, &self.constants, &mut out);
    }
}
