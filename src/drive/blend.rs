//! The belt between two friction laws: the right-hand side (1 − λ) f + λ f_smooth, from the smooth law at λ = 1 to the
//! case's own at λ = 0.

use solver::{Guess, Layout, Points, Problem, Scope, Solution};

use super::belt::BeltProblem;
use super::route::smooth_law;
use crate::case::ModelChoices;
use crate::model::{Constant, Constants};

/// A belt's problem with one more constant, the weight λ of the smooth friction law; it is the last.
#[derive(Debug, Clone)]
pub(super) struct Blend<'a> {
    own: &'a BeltProblem,
    smooth: BeltProblem,
    /// Factor on the slip threshold in the smooth law.
    threshold: f64,
    layout: Layout,
}

impl<'a> Blend<'a> {
    /// Between the law of `own`, whose model is `model`, and the smooth one; `None` where the model has no smooth law.
    pub fn new(own: &'a BeltProblem, model: &ModelChoices, constants: &Constants) -> Option<Self> {
        let (model, threshold) = smooth_law(model)?;
        let smooth = BeltProblem::new(&model, constants)?;
        let mut layout = own.layout().clone();
        let same = layout.regions.iter().zip(&smooth.layout().regions).all(|(own, smooth)| {
            own.states == smooth.states
                && own.integrals == smooth.integrals
                && own.state_pattern == smooth.state_pattern
                && own.constant_pattern == smooth.constant_pattern
                && own.default_entries == smooth.default_entries
        });
        let weight = layout.constants.len();
        layout.constants.push(solver::Constant { name: "weight of smooth friction".to_owned(), scale: Some(1.0) });
        for region in &mut layout.regions {
            region.constant_pattern.extend((0..region.rows()).map(|row| (row, weight)));
        }
        same.then_some(Self { own, smooth, threshold, layout })
    }

    /// Place of the weight among the constants.
    pub fn weight(&self) -> usize {
        self.own.layout().constants.len()
    }

    /// A solution under the smooth law, whose slip threshold is that of the law, as a guess at λ = 1.
    pub fn begin(&self, smooth: &Solution) -> Guess {
        let mut guess = Guess::from(smooth);
        if let Some(threshold) = guess.constants.get_mut(Constant::SlipThreshold.index()) {
            *threshold /= self.threshold;
        }
        guess.constants.push(1.0);
        guess
    }

    /// A solution at λ = 0 as a guess for the belt's own problem.
    pub fn end(&self, solution: &Solution) -> Guess {
        let mut guess = Guess::from(solution);
        guess.constants.truncate(self.weight());
        guess
    }

    /// The constants of the belt's own problem, those of the smooth one, and the weight of that.
    fn split<'c>(&self, constants: &'c [f64]) -> (&'c [f64], Vec<f64>, f64) {
        let (own, weight) = constants.split_at(self.weight().min(constants.len()));
        let mut smooth = own.to_vec();
        if let Some(threshold) = smooth.get_mut(Constant::SlipThreshold.index()) {
            *threshold *= self.threshold;
        }
        (own, smooth, weight.first().copied().unwrap_or(f64::NAN))
    }
}

/// `(1 − weight) own + weight smooth` in place of `own`.
fn mix(own: &mut [f64], smooth: &[f64], weight: f64) {
    own.iter_mut().zip(smooth).for_each(|(own, smooth)| *own += weight * (smooth - *own));
}

impl Problem for Blend<'_> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, constants: &[f64], f: &mut [f64]) {
        let (own, smooth, weight) = self.split(constants);
        self.own.rhs(region, at, own, f);
        if weight != 0.0 {
            let mut other = vec![0.0; f.len()];
            self.smooth.rhs(region, at, &smooth, &mut other);
            mix(f, &other, weight);
        }
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
        let (own, smooth, weight) = self.split(constants);
        let pattern = &self.own.layout().regions[region].constant_pattern;
        let entries = match scope {
            Scope::DefaultUnknowns => self.own.layout().regions[region].default_entries,
            Scope::All => pattern.len(),
        };
        let (dc, by_weight) = dc.split_at_mut((entries * at.stride).min(dc.len()));
        self.own.rhs_jacobian(region, at, own, scope, f, dy, dc);
        if weight == 0.0 && by_weight.is_empty() {
            return;
        }
        let (mut g, mut gy, mut gc) = (vec![0.0; f.len()], vec![0.0; dy.len()], vec![0.0; dc.len()]);
        self.smooth.rhs_jacobian(region, at, &smooth, scope, &mut g, &mut gy, &mut gc);
        let by_threshold = |&(_, constant): &(usize, usize)| constant == Constant::SlipThreshold.index();
        for (_, gc) in pattern.iter().zip(gc.chunks_exact_mut(at.stride)).filter(|(entry, _)| by_threshold(entry)) {
            gc.iter_mut().for_each(|gc| *gc *= self.threshold);
        }
        by_weight.iter_mut().zip(f.iter().zip(&g)).for_each(|(by, (own, smooth))| *by = smooth - own);
        mix(f, &g, weight);
        mix(dy, &gy, weight);
        mix(dc, &gc, weight);
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64]) {
        self.own.boundary(ends, integrals, self.split(constants).0, g);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], constants: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.own.boundary_jacobian(ends, integrals, self.split(constants).0, g, dz);
    }
}
