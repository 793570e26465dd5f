//! The belt loop as a boundary value problem: the generated kernels joined under the solver's trait.

use std::cell::RefCell;

use generated::{BoundaryKernel, OutputKernel, RegionKernel, RegionOut};
use solver::{Layout, Points, Problem, Region, Scope, Solution};

use super::closing::{BoundLaw, Closing};
use super::inputs::inputs;
use super::model::Kernels;
use super::outputs::{OutputGradients, OutputValues};
use super::question::Known;
use super::region::{BoundRegion, RegionId};
use crate::model::{Constant, Constants, Field, InternalError, ModelChoices, Output, State};

/// The boundary value problem of one belt drive.
///
/// Two contacts and two spans, each on `[0, 1]`, joined by the boundary equations. Outputs that are prescribed add an
/// equation each, "output − target = 0", and a constant each, the target: it follows the [`Constant`]s in the layout.
/// Laws that close the drive add an equation "law − target = 0" and a target each, behind those.
#[derive(Debug, Clone)]
pub struct BeltProblem {
    pub(super) regions: [BoundRegion; 4],
    pub(super) boundary: &'static BoundaryKernel,
    outputs: &'static OutputKernel,
    prescribed: Vec<Prescribed>,
    laws: Vec<BoundLaw>,
    layout: Layout,
}

/// An output that is prescribed.
#[derive(Debug, Clone, Copy)]
struct Prescribed {
    output: Output,
    /// Its row among the outputs of the drive.
    row: usize,
}

impl BeltProblem {
    /// Joins the kernels that `model` chooses; `constants` only tell the typical magnitudes of the states.
    /// `None` for a model that has no kernels.
    pub fn new(model: &ModelChoices, constants: &Constants) -> Option<Self> {
        let kernels = Kernels::of(model)?;
        let bind = |region: RegionId| {
            BoundRegion::new(region, if region.is_contact() { kernels.contact } else { kernels.span })
        };
        let regions = [
            bind(RegionId::Primary)?,
            bind(RegionId::SlackSpan)?,
            bind(RegionId::Secondary)?,
            bind(RegionId::TightSpan)?,
        ];
        let layout = layout(&regions, kernels.boundary, constants);
        Some(Self {
            regions,
            boundary: kernels.boundary,
            outputs: kernels.outputs,
            prescribed: Vec::new(),
            laws: Vec::new(),
            layout,
        })
    }

    /// As [`new`](Self::new), with outputs prescribed; beside each its typical magnitude.
    ///
    /// # Errors
    /// [`InternalError::Output`] for an output that drives of this model do not have, which
    /// [`Question::check`](super::Question::check) refuses before.
    pub fn prescribing(
        model: &ModelChoices,
        constants: &Constants,
        outputs: &[(Output, f64)],
    ) -> Result<Option<Self>, InternalError> {
        let Some(mut belt) = Self::new(model, constants) else { return Ok(None) };
        for &(output, scale) in outputs {
            let row = belt.outputs.row(output).ok_or(InternalError::Output(output))?;
            prescribe(&mut belt.layout, belt.outputs, Prescribed { output, row }, scale);
            belt.prescribed.push(Prescribed { output, row });
        }
        Ok(Some(belt))
    }

    /// This problem, closed by laws as well; to be asked once, after all outputs are prescribed.
    ///
    /// # Errors
    /// [`InternalError::Output`] for a law of an output that the drives of this model do not have.
    pub fn closed(mut self, closings: &[Closing]) -> Result<Self, InternalError> {
        let constants = self.first_constant();
        for closing in closings {
            let law = BoundLaw::new(closing.law.clone(), self.outputs, constants)?;
            let (row, target) = (self.layout.equations.len(), self.layout.inputs());
            self.layout.boundary_pattern.extend(law.inputs.iter().map(|input| (row, *input)));
            self.layout.boundary_pattern.push((row, target));
            let name = law.law.name().to_owned();
            let scale = Some(law.law.scale()).filter(|scale| *scale > 0.0);
            self.layout.equations.push(name.clone());
            self.layout.constants.push(solver::Constant { name, scale });
            self.laws.push(law);
        }
        Ok(self)
    }

    /// Place of the first constant among the inputs of the boundary equations.
    fn first_constant(&self) -> usize {
        self.layout.ends() + self.layout.integrals()
    }

    /// The outputs that are prescribed, in the order of their equations and targets.
    pub fn prescribed(&self) -> impl Iterator<Item = Output> + '_ {
        self.prescribed.iter().map(|prescribed| prescribed.output)
    }

    /// The outputs of a solution of this problem.
    ///
    /// # Errors
    /// [`InternalError::Length`] for a solution of another problem.
    pub fn output_values(&self, solution: &Solution) -> Result<OutputValues, InternalError> {
        let (ends, integrals) = self.inputs(solution)?;
        Ok(OutputValues::new(self.outputs, self.output_rows(&ends, &integrals, solution.constants())))
    }

    /// The outputs of a solution of this problem, and the gradient of each with respect to ends, integrals and
    /// constants.
    ///
    /// # Errors
    /// [`InternalError::Length`] for a solution of another problem.
    pub fn output_gradients(&self, solution: &Solution) -> Result<(OutputValues, OutputGradients), InternalError> {
        let (ends, integrals) = self.inputs(solution)?;
        let set = &self.outputs.set;
        let mut values = vec![0.0; set.equations.len()];
        let mut partials = vec![0.0; set.pattern.len()];
        (set.jacobian)(&ends, &integrals, solution.constants(), &mut values, &mut partials);
        let mut gradients = vec![vec![0.0; self.layout.inputs()]; values.len()];
        for (&(row, input), partial) in set.pattern.iter().zip(&partials) {
            gradients[row][input] += partial;
        }
        Ok((OutputValues::new(self.outputs, values), OutputGradients::new(self.outputs, gradients)))
    }

    /// Ends and integrals of a solution, as many as the kernels take.
    fn inputs(&self, solution: &Solution) -> Result<(Vec<f64>, Vec<f64>), InternalError> {
        let (ends, integrals) = inputs(solution);
        let set = &self.outputs.set;
        for (what, found, expected) in [
            ("the vector of ends", ends.len(), set.ends.len()),
            ("the vector of integrals", integrals.len(), set.integrals.len()),
            ("the vector of constants", solution.constants().len(), set.constants.len()),
        ] {
            if found < expected {
                return Err(InternalError::Length { what, found, expected });
            }
        }
        Ok((ends, integrals))
    }

    /// One value an equation of the outputs' set.
    fn output_rows(&self, ends: &[f64], integrals: &[f64], constants: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.outputs.set.equations.len()];
        (self.outputs.set.value)(ends, integrals, constants, &mut values);
        values
    }

    /// Residuals of the prescribed outputs.
    fn misses(&self, rows: &[f64], constants: &[f64], g: &mut [f64]) {
        let targets = constants.get(Constant::ALL.len()..).unwrap_or_default();
        for ((g, prescribed), target) in g.iter_mut().zip(&self.prescribed).zip(targets) {
            *g = rows[prescribed.row] - target;
        }
        let (behind, targets) = (g.iter_mut().skip(self.prescribed.len()), targets.iter().skip(self.prescribed.len()));
        for ((g, law), target) in behind.zip(&self.laws).zip(targets) {
            *g = law.value(rows, constants).0 - target;
        }
    }

    /// The kernel of a region.
    pub fn kernel(&self, region: RegionId) -> &'static RegionKernel {
        self.regions[region.index()].kernel
    }

    /// Derived fields of a region at some points: `fields * points.stride` values, in the order of the kernel's list.
    pub fn fields(&self, region: RegionId, at: &Points<'_>, constants: &[f64]) -> Vec<f64> {
        let mut fields = vec![0.0; self.kernel(region).fields.len() * at.stride];
        self.write_fields(region, at, constants, &mut fields);
        fields
    }

    fn write_fields(&self, region: RegionId, at: &Points<'_>, constants: &[f64], fields: &mut [f64]) {
        let bound = &self.regions[region.index()];
        let mut out = RegionOut { f: &mut [], dy: &mut [], dc: &mut [], fields };
        (bound.kernel.fields_fn)(at.len, at.stride, at.s, at.y, &bound.local(constants), &mut out);
    }

    /// One derived field of a region where its states are given: all places of the first state, then those of the next.
    /// Nothing if the region does not have the field.
    pub fn field(&self, region: RegionId, field: Field, states: &[f64], constants: &[f64]) -> Option<Vec<f64>> {
        let kernel = self.kernel(region);
        let (row, len) = (kernel.field(field)?, states.len().checked_div(kernel.states.len())?);
        // A belt is the same everywhere along it: no field depends on the place but by the states.
        with_room((1 + kernel.fields.len()) * len, |room| {
            let (s, fields) = room.split_at_mut(len);
            s.fill(0.0);
            self.write_fields(region, &Points { len, stride: len, s, y: states }, constants, fields);
            fields.get(row * len..(row + 1) * len).map(<[f64]>::to_vec)
        })
    }
}

thread_local! {
    /// For [`with_room`].
    static ROOM: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// More numbers than this are not kept for the next.
const MOST_ROOM: usize = 1 << 18;

/// Hands so many numbers to `work`, whatever they are: kernels give more than is asked of them, many times a solve, and
/// to clear what they write into would take as long as the writing.
fn with_room<T>(len: usize, work: impl FnOnce(&mut [f64]) -> T) -> T {
    let mut room = ROOM.take();
    room.resize(room.len().max(len), 0.0);
    let done = work(&mut room[..len]);
    if room.len() <= MOST_ROOM {
        ROOM.set(room);
    }
    done
}

/// A typical magnitude, from a value of the case; none if that is zero or not finite.
pub(super) fn magnitude(value: f64) -> Option<f64> {
    Some(value.abs()).filter(|magnitude| magnitude.is_finite() && *magnitude > 0.0)
}

/// Names, sizes, sparsity and typical magnitudes.
fn layout(regions: &[BoundRegion; 4], boundary: &BoundaryKernel, constants: &Constants) -> Layout {
    let tension = constants[Constant::SlackTension];
    let penetration = tension
        / (constants[Constant::RadialStiffness]
            * constants[Constant::PrimaryRadius]
            * libm::tan(constants[Constant::HalfAngle]));
    let scale = |state: State| match state {
        State::Tension | State::SpanTension => tension,
        State::Penetration => penetration,
        State::Inclination => 0.01,
        State::InclinationDerivative
        | State::InclinationSecondDerivative
        | State::Direction
        | State::DirectionDerivative
        | State::DirectionSecondDerivative => 0.1,
    };
    let region = |(id, bound): (RegionId, &BoundRegion)| Region {
        name: id.name().to_owned(),
        interval: (0.0, 1.0),
        states: bound
            .kernel
            .states
            .iter()
            .map(|state| solver::State { name: state.name().to_owned(), scale: magnitude(scale(*state)) })
            .collect(),
        integrals: bound.kernel.integrals.iter().map(|integral| integral.name().to_owned()).collect(),
        state_pattern: bound.kernel.state_pattern.to_vec(),
        constant_pattern: bound.pattern.clone(),
        default_entries: bound.default_entries,
    };
    Layout {
        regions: RegionId::ALL.into_iter().zip(regions).map(region).collect(),
        constants: Constant::ALL
            .into_iter()
            .map(|constant| solver::Constant {
                name: constant.name().to_owned(),
                scale: magnitude(constants[constant]),
            })
            .collect(),
        equations: boundary.equations.iter().map(|equation| equation.name.to_owned()).collect(),
        boundary_pattern: boundary.pattern.to_vec(),
    }
}

/// Adds an equation and its target.
fn prescribe(layout: &mut Layout, outputs: &OutputKernel, prescribed: Prescribed, scale: f64) {
    let (row, target) = (layout.equations.len(), layout.inputs());
    let entries = outputs.set.pattern.iter().filter(|(other, _)| *other == prescribed.row);
    layout.boundary_pattern.extend(entries.map(|&(_, input)| (row, input)));
    layout.boundary_pattern.push((row, target));
    let name = Known::Output(prescribed.output).name();
    let scale = Some(scale.abs()).filter(|scale| *scale > 0.0);
    layout.equations.push(name.clone());
    layout.constants.push(solver::Constant { name, scale });
}

/// A secondary that stands still may seem to turn back by this share of the primary's speed while its stall is sought.
const LEAST_RATIO: f64 = -1e-3;

/// Whether the constants describe a belt at all: it runs forward, more slowly than a wave along it, over positive
/// angles and lengths and pulleys that stand apart. Velocity is quadratic in the mass flow (3.11); its other root, a
/// belt that flows backwards under compression, satisfies the same equations and is shut out here.
pub(super) fn is_physical(constants: &[f64]) -> bool {
    let Ok(constants) = Constants::try_from(constants) else { return false };
    let value = |constant: Constant| constants[constant];
    let positive = [
        Constant::Flow,
        Constant::PrimaryWrap,
        Constant::SecondaryWrap,
        Constant::TightLength,
        Constant::SlackLength,
        Constant::PrimaryRadius,
        Constant::SecondaryRadius,
        Constant::PrimarySpeed,
    ];
    let apart = value(Constant::PrimaryRadius) + value(Constant::SecondaryRadius) < value(Constant::CenterDistance);
    let unstretched_speed = value(Constant::Flow) * value(Constant::PrimaryRadius) * value(Constant::PrimarySpeed);
    let wave_speed = (value(Constant::LongitudinalStiffness) / value(Constant::MassPerLength)).sqrt();
    positive.into_iter().all(|constant| value(constant) > 0.0)
        && value(Constant::SpeedRatio) >= LEAST_RATIO
        && apart
        && unstretched_speed < wave_speed
}

impl Problem for BeltProblem {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        if !is_physical(constants) {
            return f.fill(f64::NAN);
        }
        let bound = &self.regions[region];
        let mut out = RegionOut { f, dy: &mut [], dc: &mut [], fields: &mut [] };
        (bound.kernel.value)(at.len, at.stride, at.s, at.y, &bound.local(constants), &mut out);
    }

    fn rhs_jacobian(
        &self,
        region: usize,
        at: &Points<'_>,
        constants: &[f64],
        scope: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        if !is_physical(constants) {
            return f.fill(f64::NAN);
        }
        let bound = &self.regions[region];
        let local = bound.local(constants);
        let (function, kernel_entries, entries) = match scope {
            Scope::DefaultUnknowns => (bound.kernel.jacobian, bound.kernel.default_entries, bound.default_entries),
            Scope::All => (bound.kernel.full, bound.kernel.constant_pattern.len(), bound.pattern.len()),
        };
        if scope == Scope::DefaultUnknowns && bound.direct() {
            let mut out = RegionOut { f, dy, dc, fields: &mut [] };
            return function(at.len, at.stride, at.s, at.y, &local, &mut out);
        }
        with_room(kernel_entries * at.stride, |own| {
            let mut out = RegionOut { f, dy, dc: &mut *own, fields: &mut [] };
            function(at.len, at.stride, at.s, at.y, &local, &mut out);
            bound.gather(entries, at.stride, own, dc);
        });
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (own, more) = g.split_at_mut(self.boundary.equations.len().min(g.len()));
        (self.boundary.value)(ends, integrals, constants, own);
        if !more.is_empty() {
            self.misses(&self.output_rows(ends, integrals, constants), constants, more);
        }
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        let (own, more) = g.split_at_mut(self.boundary.equations.len().min(g.len()));
        let (own_entries, entries) = dz.split_at_mut(self.boundary.pattern.len().min(dz.len()));
        (self.boundary.jacobian)(ends, integrals, constants, own, own_entries);
        if more.is_empty() {
            return;
        }
        let set = &self.outputs.set;
        let mut values = vec![0.0; set.equations.len()];
        let mut partials = vec![0.0; set.pattern.len()];
        (set.jacobian)(ends, integrals, constants, &mut values, &mut partials);
        self.misses(&values, constants, more);
        // As `prescribe` lists them: the output's own entries, then that of its target.
        let own = |prescribed: &Prescribed| {
            let row = prescribed.row;
            let own = set.pattern.iter().zip(&partials).filter(move |((other, _), _)| *other == row);
            own.map(|(_, partial)| *partial).chain([-1.0]).collect::<Vec<_>>()
        };
        let first = self.first_constant();
        let law = |law: &BoundLaw| {
            let (_, own) = law.value(&values, constants);
            let gradient = law.gradient(&own, self.outputs, &partials, first);
            gradient.into_iter().chain([-1.0]).collect::<Vec<_>>()
        };
        let values = self.prescribed.iter().flat_map(own).chain(self.laws.iter().flat_map(law));
        entries.iter_mut().zip(values).for_each(|(entry, value)| *entry = value);
    }
}
