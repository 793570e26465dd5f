//! What hysteresis follows along the belt, read from a solution: curvature, penetration and strain over the unstretched
//! coordinate, with their slopes, at the nodes of the solution's own meshes.

use generated::{
    BoundaryKernel, HYSTERESIS_CONTACT, HYSTERESIS_SPAN, HysteresisContactInput, HysteresisSpanInput, RegionKernel,
};
use solver::{RegionSolution, Solution};

use super::series::Track;
use crate::drive::{BeltProblem, RegionId, Source};
use crate::model::{Integral, RegionConstant, State};

/// Places of what the generated formulae give; the penetration's slope is a groove's alone.
pub(super) const CURVATURE: usize = 1;
pub(super) const CURVATURE_SLOPE: usize = 2;
pub(super) const STRAIN: usize = 3;
pub(super) const STRAIN_SLOPE: usize = 4;
pub(super) const PENETRATION_SLOPE: usize = 5;
/// Their names, in order.
pub(super) const NAMES: [&str; 6] =
    ["material", "curvature", "curvature_slope", "strain", "strain_slope", "penetration_slope"];

/// What stands for an input of the formulae.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Input {
    /// A state of the region.
    State(usize),
    /// The derivative of a state along the region.
    Slope(usize),
    /// A constant of the drive.
    Constant(usize),
    /// The number one.
    One,
}

/// The formulae of a region with their inputs bound.
#[derive(Debug)]
pub(super) struct Followed {
    pub kernel: &'static BoundaryKernel,
    pub inputs: Vec<Input>,
    /// Place of the penetration among the states of a contact.
    pub penetration: Option<usize>,
    /// Place of the unstretched length among the integrals.
    pub length: usize,
}

/// What an input of the formulae is, before it is bound to a region.
enum Meaning {
    State(State),
    Slope(State),
    Constant(RegionConstant),
}

fn in_contact(input: HysteresisContactInput) -> Meaning {
    match input {
        HysteresisContactInput::T => Meaning::State(State::Tension),
        HysteresisContactInput::Theta => Meaning::State(State::Inclination),
        HysteresisContactInput::Theta1 => Meaning::State(State::InclinationDerivative),
        HysteresisContactInput::Theta2 => Meaning::State(State::InclinationSecondDerivative),
        HysteresisContactInput::X => Meaning::State(State::Penetration),
        HysteresisContactInput::THat1 => Meaning::Slope(State::Tension),
        HysteresisContactInput::Phi => Meaning::Constant(RegionConstant::WrapAngle),
        HysteresisContactInput::R => Meaning::Constant(RegionConstant::PulleyRadius),
        HysteresisContactInput::Flow => Meaning::Constant(RegionConstant::Flow),
        HysteresisContactInput::EA => Meaning::Constant(RegionConstant::LongitudinalStiffness),
        HysteresisContactInput::MO => Meaning::Constant(RegionConstant::MassPerLength),
        HysteresisContactInput::RP => Meaning::Constant(RegionConstant::PrimaryRadius),
        HysteresisContactInput::OmegaP => Meaning::Constant(RegionConstant::PrimarySpeed),
    }
}

fn in_span(input: HysteresisSpanInput) -> Meaning {
    match input {
        HysteresisSpanInput::Tau => Meaning::State(State::SpanTension),
        HysteresisSpanInput::Vartheta1 => Meaning::State(State::DirectionDerivative),
        HysteresisSpanInput::Vartheta2 => Meaning::State(State::DirectionSecondDerivative),
        HysteresisSpanInput::TauHat1 => Meaning::Slope(State::SpanTension),
        HysteresisSpanInput::L => Meaning::Constant(RegionConstant::SpanLength),
        HysteresisSpanInput::Flow => Meaning::Constant(RegionConstant::Flow),
        HysteresisSpanInput::EA => Meaning::Constant(RegionConstant::LongitudinalStiffness),
        HysteresisSpanInput::MO => Meaning::Constant(RegionConstant::MassPerLength),
        HysteresisSpanInput::RP => Meaning::Constant(RegionConstant::PrimaryRadius),
        HysteresisSpanInput::OmegaP => Meaning::Constant(RegionConstant::PrimarySpeed),
    }
}

impl Followed {
    /// Of a region; `None` for a region whose states are not those of a belt that resists bending.
    pub fn new(region: RegionId, states: &RegionKernel) -> Option<Self> {
        let (kernel, meanings): (_, Vec<Meaning>) = if region.is_contact() {
            (&HYSTERESIS_CONTACT.set, HysteresisContactInput::ALL.into_iter().map(in_contact).collect())
        } else {
            (&HYSTERESIS_SPAN.set, HysteresisSpanInput::ALL.into_iter().map(in_span).collect())
        };
        let state = |state: State| states.states.iter().position(|other| *other == state);
        let input = |meaning: Meaning| match meaning {
            Meaning::State(of) => state(of).map(Input::State),
            Meaning::Slope(of) => state(of).map(Input::Slope),
            Meaning::Constant(constant) => match region.source(constant)? {
                Source::Constant(constant) => Some(Input::Constant(constant)),
                Source::One => Some(Input::One),
            },
        };
        let inputs = meanings.into_iter().map(input).collect::<Option<_>>()?;
        let length = states.integrals.iter().position(|integral| *integral == Integral::UnstretchedLength)?;
        Some(Self { kernel, inputs, penetration: state(State::Penetration), length })
    }

    /// Where the values of the inputs stand in a region of a solution.
    pub fn columns<'a>(&self, part: &'a RegionSolution, constants: &[f64]) -> Columns<'a> {
        let column = |input: &Input| match *input {
            Input::State(i) => Column::Nodes(part.state(i)),
            Input::Slope(i) => Column::Nodes(part.slope(i)),
            Input::Constant(constant) => Column::Everywhere(constants.get(constant).copied().unwrap_or(f64::NAN)),
            Input::One => Column::Everywhere(1.0),
        };
        Columns(self.inputs.iter().map(column).collect())
    }
}

/// The inputs of a region's formulae in a solution.
pub(super) struct Columns<'a>(Vec<Column<'a>>);

enum Column<'a> {
    /// One value a node.
    Nodes(&'a [f64]),
    /// The same at all nodes.
    Everywhere(f64),
}

impl Columns<'_> {
    /// Their values at a node.
    pub fn at(&self, node: usize, values: &mut Vec<f64>) {
        values.clear();
        values.extend(self.0.iter().map(|column| match *column {
            Column::Nodes(values) => values.get(node).copied().unwrap_or(f64::NAN),
            Column::Everywhere(value) => value,
        }));
    }
}

/// A solution followed around the loop.
#[derive(Debug)]
pub(super) struct Tracks {
    /// Unstretched length of the loop, m.
    pub length: f64,
    /// Curvature, 1/m, region by region.
    pub curvature: Vec<Track>,
    /// Penetration, m; nothing in the spans.
    pub penetration: Vec<Track>,
    /// Strain of the cord.
    pub strain: Vec<Track>,
}

impl Tracks {
    /// Of a solution; `None` for a belt without bending stiffness.
    pub fn new(belt: &BeltProblem, solution: &Solution) -> Option<Self> {
        let followed = RegionId::ALL
            .into_iter()
            .map(|region| Followed::new(region, belt.kernel(region)))
            .collect::<Option<Vec<_>>>()?;
        let parts = || followed.iter().zip(solution.regions());
        let length = parts().filter_map(|(followed, part)| part.integrals().get(followed.length)).sum();
        let mut tracks = Self { length, curvature: Vec::new(), penetration: Vec::new(), strain: Vec::new() };
        let (mut start, mut inputs, mut found) = (0.0, Vec::new(), [0.0; NAMES.len()]);
        for (followed, part) in parts() {
            let cumulative = part.cumulative(followed.length);
            let u: Vec<f64> = cumulative.iter().map(|passed| (start + passed) / length).collect();
            start += cumulative.last().copied().unwrap_or(0.0);
            let room = || Vec::with_capacity(u.len());
            let empty = || Track { u: u.clone(), value: room(), slope: room() };
            let (mut curvature, mut strain, mut penetration) = (empty(), empty(), empty());
            let columns = followed.columns(part, solution.constants());
            for node in 0..u.len() {
                columns.at(node, &mut inputs);
                (followed.kernel.value)(&[], &[], &inputs, &mut found);
                curvature.value.push(found[CURVATURE]);
                curvature.slope.push(found[CURVATURE_SLOPE] * length);
                strain.value.push(found[STRAIN]);
                strain.slope.push(found[STRAIN_SLOPE] * length);
                penetration.slope.push(found[PENETRATION_SLOPE] * length);
            }
            tracks.curvature.push(curvature);
            tracks.strain.push(strain);
            tracks.penetration.push(match followed.penetration {
                Some(state) => Track { value: part.state(state).to_vec(), ..penetration },
                None => Track::default(),
            });
        }
        Some(tracks)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formulae_give_what_is_read_here() {
        for (kernel, count) in [(&HYSTERESIS_CONTACT.set, NAMES.len()), (&HYSTERESIS_SPAN.set, NAMES.len() - 1)] {
            let names: Vec<&str> = kernel.equations.iter().map(|equation| equation.name).collect();
            assert_eq!(names, NAMES[..count]);
        }
    }
}
