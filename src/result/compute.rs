//! From a solution to what it means.

use std::f64::consts::PI;

use solver::{Points, RegionSolution, Solution};

use super::schema::{BeltResult, Efficiency, Energy, Pulley, Span};
use crate::drive::{Belt, Constant, Constants, RegionId};

/// Points inside each interval at which extremes are looked for, besides its nodes.
const INNER: usize = 3;

/// A region's states and derived fields at its nodes and between them.
#[derive(Debug, Clone)]
pub struct Sampled {
    /// Independent variable in `[0, 1]`, increasing.
    pub s: Vec<f64>,
    /// States, component by component.
    pub states: Vec<Vec<f64>>,
    /// Derived fields in the order of the kernel's list.
    pub fields: Vec<Vec<f64>>,
}

impl Sampled {
    /// Samples a region at its nodes and at `inner` points inside each interval.
    pub fn new(belt: &Belt, solution: &Solution, region: RegionId, inner: usize) -> Self {
        let part = &solution.regions()[region.index()];
        let s = refined(part.mesh(), inner);
        let mut states = vec![Vec::with_capacity(s.len()); part.states()];
        let mut y = vec![0.0; part.states()];
        for &s in &s {
            part.eval_into(s, &mut y);
            states.iter_mut().zip(&y).for_each(|(values, y)| values.push(*y));
        }
        let flat = states.concat();
        let points = Points { len: s.len(), stride: s.len(), s: &s, y: &flat };
        let fields = belt.fields(region, &points, solution.constants());
        let fields = fields.chunks_exact(s.len()).map(<[f64]>::to_vec).collect();
        Self { s, states, fields }
    }
}

/// Nodes, and `inner` equidistant points between each two.
pub fn refined(mesh: &[f64], inner: usize) -> Vec<f64> {
    let steps = inner + 1;
    let part = |pair: &[f64]| {
        let (a, h) = (pair[0], pair[1] - pair[0]);
        (0..steps).map(move |i| a + h * i as f64 / steps as f64).collect::<Vec<_>>()
    };
    mesh.windows(2).flat_map(part).chain(mesh.last().copied()).collect()
}

/// Reads a solution: constants, integrals and sampled regions.
pub struct Reading<'a> {
    belt: &'a Belt,
    solution: &'a Solution,
    constants: Constants,
}

/// The smallest and largest of some values.
fn extremes(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(*value), high.max(*value)))
}

/// Share of `[0, 1]` on which `v` lies below `threshold`, `v` taken as linear between its samples.
fn share_below(s: &[f64], v: &[f64], threshold: f64) -> f64 {
    let part = |(s, v): (&[f64], &[f64])| {
        let (a, b) = (v[0] - threshold, v[1] - threshold);
        let share = match (a < 0.0, b < 0.0) {
            (true, true) => 1.0,
            (false, false) => 0.0,
            (true, false) => a / (a - b),
            (false, true) => b / (b - a),
        };
        share * (s[1] - s[0])
    };
    s.windows(2).zip(v.windows(2)).map(part).sum()
}

impl<'a> Reading<'a> {
    /// Of a solution of `belt`.
    pub fn new(belt: &'a Belt, solution: &'a Solution) -> Self {
        let mut constants = Constants([0.0; Constant::ALL.len()]);
        constants.0.iter_mut().zip(solution.constants()).for_each(|(to, from)| *to = *from);
        Self { belt, solution, constants }
    }

    /// The drive's constants, given and found.
    pub fn constants(&self) -> &Constants {
        &self.constants
    }

    fn part(&self, region: RegionId) -> &'a RegionSolution {
        &self.solution.regions()[region.index()]
    }

    /// An integral over a region by its name in the notation; NaN if there is none.
    fn integral(&self, region: RegionId, name: &str) -> f64 {
        let at = self.belt.kernel(region).integrals.iter().position(|symbol| symbol.name == name);
        at.and_then(|at| self.part(region).integrals().get(at).copied()).unwrap_or(f64::NAN)
    }

    /// A state's values in a region.
    fn state(&self, region: RegionId, name: &str) -> &'a [f64] {
        let at = self.belt.kernel(region).states.iter().position(|symbol| symbol.name == name);
        at.map_or(&[], |at| self.part(region).state(at))
    }

    fn ends(&self, region: RegionId, name: &str) -> (f64, f64) {
        let values = self.state(region, name);
        (values.first().copied().unwrap_or(f64::NAN), values.last().copied().unwrap_or(f64::NAN))
    }

    fn speed(&self, region: RegionId) -> f64 {
        let primary = self.constants[Constant::PrimarySpeed];
        if region == RegionId::Primary { primary } else { primary * self.constants[Constant::SpeedRatio] }
    }

    /// One pulley, `region` being its contact.
    pub fn pulley(&self, region: RegionId) -> Pulley {
        let c = &self.constants;
        let sampled = Sampled::new(self.belt, self.solution, region, INNER);
        let kernel = self.belt.kernel(region);
        let field = |name: &str| kernel.fields.iter().position(|symbol| symbol.name == name).map(|at| &sampled.fields[at]);
        let states = |name: &str| kernel.states.iter().position(|symbol| symbol.name == name).map(|at| &sampled.states[at]);
        let nothing = Vec::new();
        let sliding = field("speed").unwrap_or(&nothing);
        let (wrap, orientation, entry) = match region {
            RegionId::Primary => (c[Constant::PrimaryWrap], c[Constant::PrimaryOrientation], c[Constant::PrimaryOrientation]),
            _ => {
                let (wrap, orientation) = (c[Constant::SecondaryWrap], c[Constant::SecondaryOrientation]);
                (wrap, orientation, PI - orientation - wrap)
            }
        };
        let force = self.integral(region, "A");
        let (moment_x, moment_y) = (self.integral(region, "A_x"), self.integral(region, "A_y"));
        let (sin, cos) = entry.sin_cos();
        let resultant = nalgebra::Vector2::new(cos * moment_x - sin * moment_y, sin * moment_x + cos * moment_y) / force;
        let (speed, torque) = (self.speed(region), self.integral(region, "M").abs());
        let (entry_angle, exit_angle) = self.ends(region, "theta");
        let (entry_tension, exit_tension) = self.ends(region, "T");
        let (slowest, fastest) = extremes(sliding);
        Pulley {
            speed,
            torque,
            power: speed * torque,
            axial_force: force,
            wrap_angle: wrap,
            entry_angle,
            exit_angle,
            orientation_angle: orientation,
            max_penetration: extremes(states("x").unwrap_or(&nothing)).1,
            min_sliding_speed: slowest,
            max_sliding_speed: fastest,
            adhesion_fraction: share_below(&sampled.s, sliding, c[Constant::SlipThreshold]),
            resultant_x: resultant.x,
            resultant_y: resultant.y,
            binding_moment: force * resultant.norm(),
            friction_loss: self.integral(region, "W"),
            entry_tension,
            exit_tension,
        }
    }

    /// One span.
    pub fn span(&self, region: RegionId) -> Span {
        let length = if region == RegionId::TightSpan { Constant::TightLength } else { Constant::SlackLength };
        let (min_tension, max_tension) = extremes(self.state(region, "tau"));
        Span {
            arc_length: self.constants[length],
            unstretched_length: self.integral(region, "L_o"),
            min_tension,
            max_tension,
        }
    }

    /// Efficiencies (6.7)–(6.9).
    pub fn efficiency(&self, primary: &Pulley, secondary: &Pulley) -> Efficiency {
        let radii = self.constants[Constant::SecondaryRadius] / self.constants[Constant::PrimaryRadius];
        let (speed, torque) = (secondary.speed / primary.speed * radii, secondary.torque / primary.torque / radii);
        Efficiency { speed, torque, overall: speed * torque }
    }

    /// The belt as a whole, `length` being what it measures unstretched, m.
    pub fn belt(&self, length: f64) -> BeltResult {
        let c = &self.constants;
        let mass_flow = c[Constant::Flow] * c[Constant::MassPerLength] * c[Constant::PrimaryRadius] * c[Constant::PrimarySpeed];
        let unstretched_length = RegionId::ALL.into_iter().map(|region| self.integral(region, "L_o")).sum();
        BeltResult { mass_flow, unstretched_length, length_error: unstretched_length - length }
    }

    /// The energy audit.
    pub fn energy(&self, primary: &Pulley, secondary: &Pulley) -> Energy {
        let (power_in, power_out) = (primary.power, secondary.power);
        let friction_loss = primary.friction_loss + secondary.friction_loss;
        Energy { power_in, power_out, friction_loss, imbalance: (power_in - power_out - friction_loss) / power_in }
    }
}
