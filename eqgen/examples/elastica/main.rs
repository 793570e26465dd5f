//! A boundary value problem that has nothing to do with belts, from its equations to its solution: Euler's elastica.
//!
//! ```text
//! equations.rs                                    what is typed in
//! cargo run -p sheave-eqgen --example elastica_write     derives the kernels and writes them
//! cargo run -p sheave-eqgen --example elastica           solves with them
//! ```
//!
//! The load is the unknown; Euler's elliptic integral gives it exactly: P/P₁ = (2 K(sin α/2)/π)², P₁ = π² EI/L².

// What generated code runs on.
#[allow(dead_code)]
#[path = "../../../generated/src/function.rs"]
mod function;
#[path = "../../../generated/src/lane.rs"]
mod lane;
#[cfg(target_arch = "x86_64")]
#[path = "../../../generated/src/lane_x86.rs"]
mod lane_x86;
#[allow(dead_code)]
#[path = "../../../generated/src/sweep.rs"]
mod sweep;
#[allow(dead_code)]
#[path = "../../../generated/src/types.rs"]
mod types;
#[allow(dead_code)]
mod vocabulary {
    use crate::types::{Dimension, Identity, Symbol};
    include!("vocabulary.rs");
}

#[allow(clippy::all, dead_code, non_snake_case, unused_imports)]
mod strut {
    use crate::function::*;
    use crate::lane::Lane;
    use crate::sweep::{Chunk, Sweep, sweep};
    use crate::types::RegionKernel;
    use crate::vocabulary::{Field, Integral, RegionConstant, State};
    include!("strut.rs");
}

#[allow(clippy::all, non_snake_case, unused_imports, unused_variables)]
mod strut_ends {
    use crate::types::{BoundaryKernel, Dimension, Symbol};
    use crate::vocabulary::Constant;
    include!("strut_ends.rs");
    fn sized<'a>(slice: &'a mut [f64], size: usize, _: &str) -> &'a mut [f64] {
        &mut slice[..size]
    }
}

use solver::{Guess, Layout, Options, Points, Problem, Region, Scope, solve};
use std::error::Error;
use std::f64::consts::PI;
use types::RegionOut;

/// The strut under the solver's trait.
struct Strut {
    layout: Layout,
}

impl Strut {
    fn new() -> Self {
        let (kernel, ends) = (strut::KERNEL, strut_ends::KERNEL);
        let region = Region {
            name: kernel.name.to_owned(),
            interval: (0.0, 1.0),
            states: kernel
                .states
                .iter()
                .map(|state| solver::State { name: state.name().to_owned(), scale: None })
                .collect(),
            integrals: kernel.integrals.iter().map(|integral| integral.name().to_owned()).collect(),
            state_pattern: kernel.state_pattern.to_vec(),
            constant_pattern: kernel.constant_pattern.to_vec(),
            default_entries: kernel.usual_entries,
        };
        let constants =
            ends.constants.iter().map(|symbol| solver::Constant { name: symbol.name.to_owned(), scale: None });
        let equations = ends.equations.iter().map(|equation| equation.name.to_owned()).collect();
        let boundary_pattern = ends.pattern.to_vec();
        Self { layout: Layout { regions: vec![region], constants: constants.collect(), equations, boundary_pattern } }
    }
}

impl Problem for Strut {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, _: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let mut out = RegionOut { f, dy: &mut [], dc: &mut [], fields: &mut [] };
        (strut::KERNEL.value)(at.len, at.stride, at.s, at.y, constants, &mut out);
    }

    fn rhs_jacobian(
        &self,
        _: usize,
        at: &Points<'_>,
        constants: &[f64],
        scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        let function = if scope == Scope::All { strut::KERNEL.full } else { strut::KERNEL.jacobian };
        let mut out = RegionOut { f, dy, dc, fields: &mut [] };
        function(at.len, at.stride, at.s, at.y, constants, &mut out);
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        (strut_ends::KERNEL.value)(ends, integrals, constants, g);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        (strut_ends::KERNEL.jacobian)(ends, integrals, constants, g, dz);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let (length, stiffness) = (1.0_f64, 1.0);
    let euler = PI.powi(2) * stiffness / length.powi(2);
    println!("   α      P/P₁          exact          X/L       intervals  Newton iterations");
    let strut = Strut::new();
    for degrees in [20.0_f64, 40.0, 60.0, 80.0, 100.0, 120.0, 140.0, 160.0, 176.0] {
        let alpha = degrees.to_radians();
        let guess = Guess::uniform(strut.layout(), 20, &[1.1 * euler, length, stiffness, alpha], |_, s, y| {
            y.copy_from_slice(&[alpha * (PI * s).cos(), -alpha * PI * (PI * s).sin()]);
        });
        let solution = solve(&strut, &guess, &[0], &Options { tolerance: 1e-9, ..Options::default() })?;
        let load = solution.constants().first().copied().unwrap_or(f64::NAN) / euler;
        let distance = solution.regions().first().and_then(|region| region.integrals().first().copied());
        let iterations = solution.stats().newton_iterations;
        let (exact, distance) = (exact(alpha), distance.unwrap_or(f64::NAN));
        println!(
            "{degrees:5}°  {load:12.9}  {exact:12.9}  {distance:11.7}  {:7}  {iterations:8}",
            solution.intervals()
        );
        if (load / exact - 1.0).abs() > 1e-7 {
            return Err(format!("the load at {degrees}° is wrong").into());
        }
    }
    Ok(())
}

/// P/P₁: K by the arithmetic-geometric mean, K(k) = π/(2 agm(1, √(1 − k²))).
fn exact(alpha: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, (alpha / 2.0).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a.powi(-2)
}
