//! The belt's problem with every contact divided.
//!
//! Each piece of a contact has one branch of the friction law, whatever |v| is there. Where two pieces meet, states go
//! on, and what is known of the joint tells how long the pieces are: at a kink, |v| = v_thr. Newton's iteration sees no
//! kink, and the mesh has a node at each.

use generated::{RegionConstant, RegionOut};
use solver::{Layout, Points, Problem, Scope};

use super::division::{Joint, Sliding, Structure};
use crate::drive::belt::{BeltProblem, is_physical, magnitude};
use crate::drive::region::{BoundRegion, RegionId, Source};
use crate::model::{Constant, Constants, Integral, State};

/// The contacts, in the order of [`Structure`], and their wrap angles.
pub(super) const CONTACTS: [(RegionId, Constant); 2] =
    [(RegionId::Primary, Constant::PrimaryWrap), (RegionId::Secondary, Constant::SecondaryWrap)];

/// Smallest typical magnitude of a piece's wrap angle, rad: that of each is the angle itself.
const LEAST_WRAP: f64 = 1e-12;

/// A piece of a contact, or a whole span.
#[derive(Debug, Clone)]
pub(super) struct Part {
    /// The region of the drive that it is a part of.
    pub region: RegionId,
    /// Its branch of the friction law, in a contact.
    pub sliding: Option<Sliding>,
    bound: BoundRegion,
}

/// See the module's head. Behind the drive's constants stand the wrap angles of the parts.
#[derive(Debug, Clone)]
pub(super) struct Kinked<'a> {
    own: &'a BeltProblem,
    pub parts: Vec<Part>,
    /// Where a part of a contact is followed by another: the index of the first, and what they meet at.
    joints: Vec<(usize, Joint)>,
    /// Place of the friction loss among a contact's rows.
    loss: usize,
    /// Place of θ among a contact's states.
    inclination: usize,
    layout: Layout,
}

impl<'a> Kinked<'a> {
    /// `None` where the kernels do not tell the loss by friction.
    pub fn new(own: &'a BeltProblem, structure: &Structure, constants: &Constants) -> Option<Self> {
        let (mut parts, mut joints) = (Vec::<Part>::new(), Vec::new());
        let mut extra = Constant::ALL.len();
        for region in RegionId::ALL {
            let kernel = own.kernel(region);
            let Some(contact) = CONTACTS.iter().position(|(contact, _)| *contact == region) else {
                parts.push(Part { region, sliding: None, bound: BoundRegion::new(region, kernel)? });
                continue;
            };
            for &(sliding, joint) in &structure[contact] {
                let bound = BoundRegion::bound(kernel, |local| match local {
                    RegionConstant::WrapAngle => Some(Source::Constant(extra)),
                    other => region.source(other),
                })?;
                joints.extend(joint.map(|joint| (parts.len(), joint)));
                parts.push(Part { region, sliding: Some(sliding), bound });
                extra += 1;
            }
        }
        let contact = own.kernel(RegionId::Primary);
        let loss = contact.states.len() + contact.integral(Integral::FrictionLoss)?;
        let inclination = contact.state(State::Inclination)?;
        let mut kinked = Self { own, parts, joints, loss, inclination, layout: own.layout().clone() };
        kinked.lay_out(constants);
        Some(kinked)
    }

    /// Regions, constants, and then boundary equations, whose inputs stand where those say.
    fn lay_out(&mut self, constants: &Constants) {
        let own = self.own.layout();
        let rim = constants[Constant::PrimaryRadius] * constants[Constant::PrimarySpeed];
        let region = |(index, part): (usize, &Part)| {
            let mut region = own.regions[part.region.index()].clone();
            region.name = format!("part {index}, {}", region.name);
            region.constant_pattern.clone_from(&part.bound.pattern);
            region.default_entries = part.bound.default_entries;
            if part.sliding == Some(Sliding::Adhering) {
                // There θ is v_thr/V at most.
                region.states[self.inclination].scale = magnitude(constants[Constant::SlipThreshold] / rim);
            }
            region
        };
        let regions = self.parts.iter().enumerate().map(region).collect();
        let wrap = |(part, _)| solver::Constant { name: format!("wrap angle of part {part}"), scale: Some(LEAST_WRAP) };
        let wraps: Vec<_> = self.wraps().map(wrap).collect();
        self.layout.regions = regions;
        self.layout.constants.extend(wraps);
        let mut pattern: Vec<(usize, usize)> = Vec::new();
        for &(row, input) in &own.boundary_pattern {
            pattern.extend(self.inputs_of(input).into_iter().map(|input| (row, input)));
        }
        self.layout.boundary_pattern = pattern;
        self.add_joints();
        let first = self.layout.ends() + self.layout.integrals();
        for (region, wrap) in CONTACTS {
            let row = self.layout.equations.len();
            let wraps = self.wraps().filter(|(index, _)| self.parts[*index].region == region);
            let entries: Vec<_> = wraps.map(|(_, constant)| constant).chain([wrap.index()]).collect();
            self.layout.boundary_pattern.extend(entries.into_iter().map(|constant| (row, first + constant)));
            self.layout.equations.push(format!("wrap angles of the parts of {}", region.name()));
        }
    }

    /// The equations of the joints.
    fn add_joints(&mut self) {
        let first = self.layout.ends() + self.layout.integrals();
        let (mut equations, mut pattern) = (Vec::new(), Vec::new());
        let before = self.layout.equations.len();
        for &(joint, kind) in &self.joints {
            for (state, of) in self.layout.regions[joint].states.iter().enumerate() {
                let row = before + equations.len();
                let ends = [self.layout.end(joint, state, true), self.layout.end(joint + 1, state, false)];
                pattern.extend(ends.map(|end| (row, end)));
                equations.push(format!("{} behind part {joint}", of.name));
            }
            let row = before + equations.len();
            if kind == Joint::Kink {
                let bound = &self.parts[joint].bound;
                let by_state = bound.kernel.state_pattern.iter().filter(|entry| entry.0 == self.loss);
                pattern.extend(by_state.map(|entry| (row, self.layout.end(joint, entry.1, true))));
                let by_constant = bound.pattern.iter().filter(|entry| entry.0 == self.loss);
                pattern.extend(by_constant.map(|entry| (row, first + entry.1)));
                equations.push(format!("sliding speed behind part {joint}"));
            } else {
                pattern.push((row, self.layout.end(joint, self.inclination, true)));
                equations.push(format!("inclination behind part {joint}"));
            }
        }
        self.layout.equations.extend(equations);
        self.layout.boundary_pattern.extend(pattern);
    }

    /// The parts of contacts, and the places of their wrap angles among the constants.
    pub fn wraps(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let contacts = (0..self.parts.len()).filter(|&index| self.parts[index].sliding.is_some());
        contacts.zip(Constant::ALL.len()..)
    }

    /// The unknown constants.
    pub fn unknowns(&self) -> Vec<usize> {
        (0..Constant::UNKNOWN).chain(self.wraps().map(|(_, constant)| constant)).collect()
    }

    /// The inputs of the boundary equations that stand for one of the drive's own problem: ends of the first and last
    /// parts, and the integrals of all.
    fn inputs_of(&self, input: usize) -> Vec<usize> {
        let own = self.own.layout();
        let (ends, integrals) = (own.ends(), own.integrals());
        if input >= ends + integrals {
            return vec![self.layout.ends() + self.layout.integrals() + input - ends - integrals];
        }
        let parts_of = |region: usize| (0..self.parts.len()).filter(move |&p| self.parts[p].region.index() == region);
        let mut rest = input;
        if input < ends {
            for (index, region) in own.regions.iter().enumerate() {
                let n = region.states.len();
                if rest < 2 * n {
                    let exit = rest >= n;
                    let part = if exit { parts_of(index).next_back() } else { parts_of(index).next() };
                    return part.map(|part| self.layout.end(part, rest % n, exit)).into_iter().collect();
                }
                rest -= 2 * n;
            }
        }
        rest = input - ends;
        for (index, region) in own.regions.iter().enumerate() {
            let k = region.integrals.len();
            if rest < k {
                let before = |part: usize| -> usize {
                    self.layout.regions.iter().take(part).map(|region| region.integrals.len()).sum()
                };
                return parts_of(index).map(|part| self.layout.ends() + before(part) + rest).collect();
            }
            rest -= k;
        }
        Vec::new()
    }

    /// Ends and integrals of the drive's own regions.
    fn own_inputs(&self, ends: &[f64], integrals: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let own = self.own.layout();
        let at = |input: &usize| match input.checked_sub(ends.len()) {
            None => ends[*input],
            Some(integral) => integrals[integral],
        };
        let sum = |input: usize| self.inputs_of(input).iter().map(at).sum();
        let (count, all) = (own.ends(), own.ends() + own.integrals());
        ((0..count).map(sum).collect(), (count..all).map(sum).collect())
    }

    /// Local constants of a part's kernel under a branch of the law.
    fn local(part: &Part, sliding: Option<Sliding>, constants: &[f64]) -> Vec<f64> {
        let mut local = part.bound.local(constants);
        if let Some(sliding) = sliding {
            let kernel = part.bound.kernel;
            local.iter_mut().zip(kernel.constants).for_each(|(value, of)| *value *= sliding.factor(*of));
        }
        local
    }

    /// Factor on derivatives with respect to a constant of the drive under a branch of the law.
    fn chain(sliding: Option<Sliding>, constant: usize) -> f64 {
        let of = |local| sliding.map_or(1.0, |sliding| sliding.factor(local));
        if constant == Constant::SlipThreshold.index() {
            of(RegionConstant::SlipThreshold)
        } else if constant == Constant::FrictionCoefficient.index() {
            of(RegionConstant::FrictionCoefficient)
        } else {
            1.0
        }
    }

    /// |v|/v_thr − 1 where a part ends, and its derivatives in the entries of the boundary equations' pattern: told by
    /// the loss by friction under either branch of the law, which are one where |v| is v_thr.
    fn kink(&self, joint: usize, ends: &[f64], constants: &[f64], dz: &mut Vec<f64>) -> f64 {
        let part = &self.parts[joint];
        let kernel = part.bound.kernel;
        let start = self.layout.end(joint, 0, true);
        let y = &ends[start..start + kernel.states.len()];
        let of = |sliding| self.loss_under(part, sliding, y, constants);
        let (adhering, slipping) = (of(Sliding::Adhering), of(Sliding::Slipping));
        let ratio = adhering.0 / slipping.0;
        let slope = |(a, s): (&f64, &f64)| ratio * (a / adhering.0 - s / slipping.0);
        let states = kernel.state_pattern.iter().zip(adhering.1.iter().zip(&slipping.1));
        dz.extend(states.filter(|(entry, _)| entry.0 == self.loss).map(|(_, pair)| slope(pair)));
        let constants = part.bound.pattern.iter().zip(adhering.2.iter().zip(&slipping.2));
        dz.extend(constants.filter(|(entry, _)| entry.0 == self.loss).map(|(_, pair)| slope(pair)));
        ratio - 1.0
    }

    /// The loss by friction at a point under a branch of the law, and its derivatives with respect to states and
    /// constants: all entries of the part's patterns.
    fn loss_under(&self, part: &Part, sliding: Sliding, y: &[f64], constants: &[f64]) -> (f64, Vec<f64>, Vec<f64>) {
        let kernel = part.bound.kernel;
        let local = Self::local(part, Some(sliding), constants);
        let rows = kernel.states.len() + kernel.integrals.len();
        let (mut f, mut dy) = (vec![0.0; rows], vec![0.0; kernel.state_pattern.len()]);
        let (mut own, mut dc) = (vec![0.0; kernel.constant_pattern.len()], vec![0.0; part.bound.pattern.len()]);
        let mut out = RegionOut { f: &mut f, dy: &mut dy, dc: &mut own, fields: &mut [] };
        (kernel.full)(1, 1, &[1.0], y, &local, &mut out);
        part.bound.gather(part.bound.pattern.len(), 1, &own, &mut dc);
        for (entry, value) in part.bound.pattern.iter().zip(&mut dc) {
            *value *= Self::chain(Some(sliding), entry.1);
        }
        (f[self.loss], dy, dc)
    }

    fn own_constants<'c>(&self, constants: &'c [f64]) -> &'c [f64] {
        &constants[..Constant::ALL.len().min(constants.len())]
    }

    /// Whether the constants describe a belt, and pieces that have a length.
    fn is_sound(&self, constants: &[f64]) -> bool {
        is_physical(self.own_constants(constants))
            && self.wraps().all(|(_, constant)| constants.get(constant).is_some_and(|wrap| *wrap > 0.0))
    }

    /// Residuals of the joints' equations and of the sums of wrap angles, and their derivatives, entry by entry of the
    /// pattern.
    fn conditions(&self, ends: &[f64], constants: &[f64], g: &mut [f64], dz: &mut Vec<f64>) {
        let mut g = g.iter_mut();
        let mut next = |value: f64| {
            if let Some(g) = g.next() {
                *g = value;
            }
        };
        for &(joint, kind) in &self.joints {
            for state in 0..self.layout.regions[joint].states.len() {
                let [before, behind] = [(joint, true), (joint + 1, false)];
                next(
                    ends[self.layout.end(before.0, state, before.1)] - ends[self.layout.end(behind.0, state, behind.1)],
                );
                dz.extend([1.0, -1.0]);
            }
            let theta = ends[self.layout.end(joint, self.inclination, true)];
            match kind {
                Joint::Kink => next(self.kink(joint, ends, constants, dz)),
                Joint::Reversal => next(theta),
                Joint::Unseating(given) => next(theta - given),
            }
            if kind != Joint::Kink {
                dz.push(1.0);
            }
        }
        for (region, wrap) in CONTACTS {
            let parts = self.wraps().filter(|(index, _)| self.parts[*index].region == region);
            let wraps: Vec<f64> = parts.map(|(_, constant)| constants[constant]).collect();
            next(wraps.iter().sum::<f64>() - constants[wrap.index()]);
            dz.extend(wraps.iter().map(|_| 1.0).chain([-1.0]));
        }
    }
}

impl Problem for Kinked<'_> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        if !self.is_sound(constants) {
            return f.fill(f64::NAN);
        }
        let part = &self.parts[region];
        let mut out = RegionOut { f, dy: &mut [], dc: &mut [], fields: &mut [] };
        let local = Self::local(part, part.sliding, constants);
        (part.bound.kernel.value)(at.len, at.stride, at.s, at.y, &local, &mut out);
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
        if !self.is_sound(constants) {
            return f.fill(f64::NAN);
        }
        let part = &self.parts[region];
        let (bound, kernel) = (&part.bound, part.bound.kernel);
        let local = Self::local(part, part.sliding, constants);
        let (function, kernel_entries, entries) = match scope {
            Scope::DefaultUnknowns => (kernel.jacobian, kernel.default_entries, bound.default_entries),
            Scope::All => (kernel.full, kernel.constant_pattern.len(), bound.pattern.len()),
        };
        let mut own = vec![0.0; kernel_entries * at.stride];
        let mut out = RegionOut { f, dy, dc: &mut own, fields: &mut [] };
        function(at.len, at.stride, at.s, at.y, &local, &mut out);
        bound.gather(entries, at.stride, &own, dc);
        for (entry, values) in bound.pattern.iter().zip(dc.chunks_exact_mut(at.stride)).take(entries) {
            let factor = Self::chain(part.sliding, entry.1);
            if factor != 1.0 {
                values.iter_mut().for_each(|value| *value *= factor);
            }
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        let (own_ends, own_integrals) = self.own_inputs(ends, integrals);
        let (own, more) = g.split_at_mut(self.own.layout().equations.len());
        self.own.boundary(&own_ends, &own_integrals, self.own_constants(constants), own);
        self.conditions(ends, constants, more, &mut Vec::new());
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        let (own_ends, own_integrals) = self.own_inputs(ends, integrals);
        let pattern = &self.own.layout().boundary_pattern;
        let (own, more) = g.split_at_mut(self.own.layout().equations.len());
        let mut own_dz = vec![0.0; pattern.len()];
        self.own.boundary_jacobian(&own_ends, &own_integrals, self.own_constants(constants), own, &mut own_dz);
        let mut all = Vec::with_capacity(dz.len());
        for (&(_, input), value) in pattern.iter().zip(own_dz) {
            all.extend(self.inputs_of(input).iter().map(|_| value));
        }
        self.conditions(ends, constants, more, &mut all);
        dz.copy_from_slice(&all);
    }
}
