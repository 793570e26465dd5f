//! From a solution to what it means.

use generated::Symbol;
use solver::{Points, Solution};

use super::schema::{BeltResult, Efficiency, Energy, Pulley, Span};
use crate::drive::{Belt, Constant, Output, RegionId, SEPARATOR, inputs};

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
        let s = refined(solution.regions()[region.index()].mesh(), inner);
        Self::at(belt, solution, region, s)
    }

    /// Samples a region at some places.
    pub fn at(belt: &Belt, solution: &Solution, region: RegionId, s: Vec<f64>) -> Self {
        let part = &solution.regions()[region.index()];
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

/// The outputs of a solution by their names in the result object, from the generated outputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Outputs(Vec<f64>);

impl Outputs {
    /// Of a solution.
    pub fn new(belt: &Belt, solution: &Solution) -> Self {
        let (ends, integrals) = inputs(solution);
        Self(belt.outputs(&ends, &integrals, solution.constants()))
    }

    /// An output.
    pub fn value(&self, output: Output) -> f64 {
        self.0.get(output.index()).copied().unwrap_or(f64::NAN)
    }

    /// An output by region and key; NaN if there is none.
    pub fn get(&self, region: &str, key: &str) -> f64 {
        let named = |output: &Output| output.name().split_once(SEPARATOR) == Some((region, key));
        Output::all().find(named).map_or(f64::NAN, |output| self.value(output))
    }
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

/// Mean of `v` over `s` with weights `w`, all taken as linear between samples.
fn weighted_mean(s: &[f64], v: &[f64], w: &[f64]) -> f64 {
    let parts = s.windows(2).zip(v.windows(2)).zip(w.windows(2));
    let (sum, weight) = parts.fold((0.0, 0.0), |(sum, weight), ((s, v), w)| {
        let half = 0.5 * (s[1] - s[0]);
        (sum + half * (v[0] * w[0] + v[1] * w[1]), weight + half * (w[0] + w[1]))
    });
    sum / weight
}

/// What a contact shows along its length.
struct Contact {
    penetration: f64,
    slowest: f64,
    fastest: f64,
    adhesion: f64,
    utilization: f64,
}

impl Contact {
    fn new(belt: &Belt, solution: &Solution, region: RegionId) -> Self {
        let kernel = belt.kernel(region);
        let sampled = Sampled::new(belt, solution, region, INNER);
        let at = |symbols: &[Symbol], name: &str| symbols.iter().position(|symbol| symbol.name == name);
        let column =
            |values: &[Vec<f64>], at: Option<usize>| at.and_then(|at| values.get(at).cloned()).unwrap_or_default();
        let sliding = column(&sampled.fields, at(kernel.fields, "speed"));
        let threshold = solution.constants().get(Constant::SlipThreshold.index()).copied().unwrap_or(f64::NAN);
        let (slowest, fastest) = extremes(&sliding);
        Self {
            penetration: extremes(&column(&sampled.states, at(kernel.states, "x"))).1,
            slowest,
            fastest,
            adhesion: share_below(&sampled.s, &sliding, threshold),
            utilization: {
                let field = |name: &str| column(&sampled.fields, at(kernel.fields, name));
                let friction = solution.constants().get(Constant::FrictionCoefficient.index()).copied();
                let along = field("mu").into_iter().zip(field("beta_s")).zip(field("gamma"));
                let along: Vec<f64> = along.map(|((mu, beta), gamma)| mu * beta.cos() * gamma.sin()).collect();
                weighted_mean(&sampled.s, &along, &field("p")).abs() / friction.unwrap_or(f64::NAN)
            },
        }
    }
}

/// One pulley, `region` being its contact.
pub fn pulley(belt: &Belt, solution: &Solution, outputs: &Outputs, region: RegionId) -> Pulley {
    let contact = Contact::new(belt, solution, region);
    let output = |key: &str| outputs.get(region.name(), key);
    Pulley {
        speed: output("speed"),
        torque: output("torque"),
        power: output("power"),
        axial_force: output("axial_force"),
        wrap_angle: output("wrap_angle"),
        entry_angle: output("entry_angle"),
        exit_angle: output("exit_angle"),
        orientation_angle: output("orientation_angle"),
        max_penetration: contact.penetration,
        min_sliding_speed: contact.slowest,
        max_sliding_speed: contact.fastest,
        adhesion_fraction: contact.adhesion,
        friction_utilization: contact.utilization,
        radius: radius(solution, region),
        resultant_x: output("resultant_x"),
        resultant_y: output("resultant_y"),
        binding_moment: output("binding_moment"),
        friction_loss: output("friction_loss"),
        entry_tension: output("entry_tension"),
        exit_tension: output("exit_tension"),
    }
}

/// Nominal radius of the pulley that a contact lies on.
fn radius(solution: &Solution, region: RegionId) -> f64 {
    let constant = if region == RegionId::Primary { Constant::PrimaryRadius } else { Constant::SecondaryRadius };
    solution.constants().get(constant.index()).copied().unwrap_or(f64::NAN)
}

/// One span.
pub fn span(belt: &Belt, solution: &Solution, outputs: &Outputs, region: RegionId) -> Span {
    let output = |key: &str| outputs.get(region.name(), key);
    let sampled = Sampled::new(belt, solution, region, INNER);
    let (min_tension, max_tension) = extremes(sampled.states.first().map_or(&[], Vec::as_slice));
    Span {
        arc_length: output("arc_length"),
        unstretched_length: output("unstretched_length"),
        min_tension,
        max_tension,
    }
}

/// Efficiencies.
pub fn efficiency(outputs: &Outputs) -> Efficiency {
    let output = |key: &str| outputs.get("efficiency", key);
    Efficiency {
        speed: output("speed"),
        torque: output("torque"),
        overall: output("overall"),
        overall_with_losses: None,
    }
}

/// The belt as a whole, `length` being what it measures unstretched, m.
pub fn belt(outputs: &Outputs, length: f64) -> BeltResult {
    let output = |key: &str| outputs.get("belt", key);
    let unstretched_length = output("unstretched_length");
    BeltResult {
        mass_flow: output("mass_flow"),
        unstretched_length,
        length_error: unstretched_length - length,
        temperature: None,
    }
}

/// The energy audit.
pub fn energy(outputs: &Outputs) -> Energy {
    let output = |key: &str| outputs.get("energy", key);
    Energy {
        power_in: output("power_in"),
        power_out: output("power_out"),
        friction_loss: output("friction_loss"),
        imbalance: output("imbalance"),
        stretch_work: output("stretch_work"),
        closure: output("closure"),
    }
}
