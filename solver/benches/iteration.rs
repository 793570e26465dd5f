//! Time of the parts of one Newton iteration on four regions of 5, 4, 5, 4 states with eight unknown constants,
//! the right-hand sides being cheap: what the solver itself costs. `cargo bench -p sheave-solver --bench iteration`.

use solver::{Guess, Layout, Options, Order, Points, Problem, Region, Scope, solve};
use std::time::Instant;

/// `y_i' = c_r (y_{i+1} - y_i³/10) + s`, closed in rings; integrals of `y_0 y_1` (two a region).
struct Rings {
    layout: Layout,
}

const STATES: [usize; 4] = [5, 4, 5, 4];

impl Rings {
    fn new() -> Self {
        let mut regions = Vec::new();
        for (r, n) in STATES.into_iter().enumerate() {
            let names = ["a", "b", "c", "d", "e"];
            let mut region = Region::dense(["p", "q", "r", "s"][r], (0.0, 1.0), &names[..n], &["i", "j"], 0);
            region.state_pattern = Vec::new();
            for i in 0..n {
                region.state_pattern.extend([(i, i), (i, (i + 1) % n), (i, (i + 2) % n)]);
            }
            region.state_pattern.extend([(n, 0), (n, 1), (n + 1, 1), (n + 1, 2)]);
            region.constant_pattern = (0..n).flat_map(|i| [(i, r), (i, 4 + r)]).collect();
            region.default_entries = 2 * n;
            regions.push(region);
        }
        let constants = ["c0", "c1", "c2", "c3", "d0", "d1", "d2", "d3"];
        let equations: Vec<String> = (0..26).map(|i| format!("e{i}")).collect();
        let equations: Vec<&str> = equations.iter().map(String::as_str).collect();
        let mut layout = Layout::dense(regions, &constants, &equations);
        let inputs = layout.inputs();
        layout.boundary_pattern = (0..26).flat_map(|e| (0..5).map(move |i| (e, (7 * e + 11 * i) % inputs))).collect();
        layout.boundary_pattern.extend((0..8).map(|c| (18 + c, 36 + c)));
        Self { layout }
    }
}

impl Problem for Rings {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, c: &[f64], f: &mut [f64]) {
        let (n, m) = (STATES[region], at.stride);
        for i in 0..n {
            for p in 0..at.len {
                let (y, z, w) = (at.y[i * m + p], at.y[(i + 1) % n * m + p], at.y[(i + 2) % n * m + p]);
                f[i * m + p] = c[region] * (z - 0.1 * y * y * y) + c[4 + region] * w * y + at.s[p];
            }
        }
        for k in 0..2 {
            for p in 0..at.len {
                f[(n + k) * m + p] = at.y[k * m + p] * at.y[(k + 1) * m + p];
            }
        }
    }

    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        c: &[f64],
        _: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        self.rhs(region, at, c, f);
        let (n, m) = (STATES[region], at.stride);
        for i in 0..n {
            for p in 0..at.len {
                let (y, z, w) = (at.y[i * m + p], at.y[(i + 1) % n * m + p], at.y[(i + 2) % n * m + p]);
                dy[3 * i * m + p] = -0.3 * c[region] * y * y + c[4 + region] * w;
                dy[(3 * i + 1) * m + p] = c[region];
                dy[(3 * i + 2) * m + p] = c[4 + region] * y;
                dc[2 * i * m + p] = z - 0.1 * y * y * y;
                dc[(2 * i + 1) * m + p] = w * y;
            }
        }
        for k in 0..2 {
            for p in 0..at.len {
                dy[(3 * n + 2 * k) * m + p] = at.y[(k + 1) * m + p];
                dy[(3 * n + 2 * k + 1) * m + p] = at.y[k * m + p];
            }
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], c: &[f64], g: &mut [f64]) {
        let inputs: Vec<f64> = ends.iter().chain(integrals).chain(c).copied().collect();
        g.fill(-0.3);
        for (k, &(equation, input)) in self.layout.boundary_pattern.iter().enumerate() {
            g[equation] += (1.0 + 0.37 * (k % 7) as f64) * inputs[input];
        }
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], c: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.boundary(ends, integrals, c, g);
        dz.iter_mut().enumerate().for_each(|(k, dz)| *dz = 1.0 + 0.37 * (k % 7) as f64);
    }
}

fn main() {
    let problem = Rings::new();
    for order in [Order::Four, Order::Six, Order::Eight] {
        let guess = Guess::uniform(problem.layout(), 150, &[1.0, 0.9, 1.1, 1.2, 0.2, 0.3, 0.1, 0.2], |_, s, y| {
            y.iter_mut().enumerate().for_each(|(i, y)| *y = 0.1 * s + 0.1 * i as f64);
        });
        let unknowns: Vec<usize> = (0..8).collect();
        // One mesh, as given.
        let options =
            Options { order, tolerance: 1e3, newton_tolerance: Some(1e-10), max_meshes: 1, ..Options::default() };
        let solution = match solve(&problem, &guess, &unknowns, &options) {
            Ok(solution) => solution,
            Err(error) => {
                println!("{error}");
                return;
            }
        };
        println!("{order:?}: {:?}", solution.stats());
        let warm = Guess::from(&solution);
        let repeats = 2000;
        let start = Instant::now();
        for _ in 0..repeats {
            let again = solve(&problem, &warm, &unknowns, &options);
            assert!(again.is_ok_and(|again| again.stats().newton_iterations == 1));
        }
        let each = start.elapsed().as_secs_f64() / f64::from(repeats);
        println!(
            "{order:?}: one solve of {} intervals with one Newton iteration: {:.1} us",
            solution.intervals(),
            each * 1e6
        );
    }
}
