//! Derivatives that are wrong are told, right ones are not.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::model::{Differentiated, Model, Scalar};
use solver::{Guess, Layout, Points, Problem, Region, Scope, WrongDerivative, check_derivatives};

/// Two regions with an integral and two constants, `dense` patterns, derivatives by hand: those of `Mistake` are wrong.
struct Written {
    layout: Layout,
    mistake: Mistake,
    /// Magnitude of the states of the first region.
    size: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Mistake {
    None,
    State,
    Small,
    Constant,
    Integrand,
    Value,
    Nan,
    End,
    Integral,
}

impl Written {
    fn new(mistake: Mistake, size: f64) -> Self {
        let regions = vec![
            Region::dense("first", (0.0, 1.0), &["u", "v"], &["area"], 2),
            Region::dense("second", (0.0, 2.0), &["w"], &[], 2),
        ];
        Self { layout: Layout::dense(regions, &["p", "q"], &["left", "right", "between", "size"]), mistake, size }
    }

    fn guess(&self) -> Guess {
        Guess::uniform(&self.layout, 20, &[1.5, -0.3], |region, s, y| match region {
            0 => (y[0], y[1]) = (self.size * s.sin(), self.size * (1.0 + s)),
            _ => y[0] = s - 1.0,
        })
    }

    fn wrong(&self) -> Vec<WrongDerivative> {
        check_derivatives(self, &self.guess()).unwrap()
    }
}

impl Problem for Written {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, region: usize, at: &Points<'_>, c: &[f64], f: &mut [f64]) {
        let size = self.size;
        for j in 0..at.len {
            let mut put = |row: usize, value: f64| f[row * at.stride + j] = value;
            if region == 0 {
                let (u, v) = (at.at(0, j) / size, at.at(1, j) / size);
                put(0, size * v);
                put(1, -size * c[0] * u.exp());
                put(2, u * u * c[1]);
            } else {
                // A kink at w = 0, where a node lies.
                put(0, at.at(0, j).abs() + c[0] * c[1]);
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
        let (size, is) = (self.size, |mistake: Mistake| self.mistake == mistake);
        for j in 0..at.len {
            let put = |out: &mut [f64], values: &[f64]| {
                values.iter().enumerate().for_each(|(entry, value)| out[entry * at.stride + j] = *value);
            };
            if region == 0 {
                let u = at.at(0, j) / size;
                let by_u = if is(Mistake::State) { 1.0 } else { -1.0 } * c[0] * u.exp();
                let by_u = if is(Mistake::Small) { by_u * 1.0001 } else { by_u };
                let by_u = if is(Mistake::Nan) { f64::NAN } else { by_u };
                put(dy, &[0.0, 1.0, by_u, 0.0, 2.0 * u * c[1] / size, 0.0]);
                let by_p = if is(Mistake::Constant) { 0.0 } else { -size * u.exp() };
                let by_q = if is(Mistake::Integrand) { u } else { u * u };
                put(dc, &[0.0, 0.0, by_p, 0.0, 0.0, by_q]);
                if is(Mistake::Value) {
                    f[at.stride + j] *= 1.0 + 1e-9;
                }
            } else {
                put(dy, &[if at.at(0, j) < 0.0 { -1.0 } else { 1.0 }]);
                put(dc, &[c[1], c[0]]);
            }
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], c: &[f64], g: &mut [f64]) {
        (g[0], g[1]) = (ends[0], ends[2] - self.size);
        (g[2], g[3]) = (ends[4] * ends[3] - ends[5], integrals[0] * integrals[0] - c[1]);
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], c: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.boundary(ends, integrals, c, g);
        dz.fill(0.0);
        let inputs = self.layout.inputs();
        let mut put = |row: usize, input: usize, value: f64| {
            // The last entry may not be in the pattern.
            dz.get_mut(row * inputs + input).into_iter().for_each(|entry| *entry = value);
        };
        put(0, 0, 1.0);
        put(1, 2, 1.0);
        put(2, 4, if self.mistake == Mistake::End { ends[4] } else { ends[3] });
        put(2, 3, ends[4]);
        put(2, 5, -1.0);
        put(3, 6, if self.mistake == Mistake::Integral { integrals[0] } else { 2.0 * integrals[0] });
        put(3, 8, -1.0);
    }
}

#[test]
fn each_mistake_is_told_and_nothing_else() {
    for size in [1.0, 1e-8, 1e8] {
        assert_eq!(Written::new(Mistake::None, size).wrong(), []);
        for (mistake, told) in [
            (Mistake::State, "the derivative of v' by u at "),
            (Mistake::Small, "the derivative of v' by u at "),
            (Mistake::Constant, "the derivative of v' by constant p at "),
            (Mistake::Integrand, "the derivative of integrand area by constant q at "),
            (Mistake::Value, "the value of v' beside its derivatives at "),
            (Mistake::Nan, "the derivative of v' by u at "),
            (Mistake::End, "the derivative of equation between by w at the entry of second is stated as "),
            (Mistake::Integral, "the derivative of equation size by integral area of first is stated as "),
        ] {
            let wrong = Written::new(mistake, size).wrong();
            assert_eq!(wrong.len(), 1, "{mistake:?} at {size}: {wrong:?}");
            let text = wrong[0].to_string();
            assert!(text.starts_with(told), "{mistake:?} at {size}: {text}");
        }
    }
}

/// What is not in a pattern is stated to be zero.
#[test]
fn a_pattern_that_lacks_an_entry_is_told() {
    let mut written = Written::new(Mistake::None, 1.0);
    assert_eq!(written.layout.boundary_pattern.pop(), Some((3, 8)));
    let wrong = written.wrong();
    let told = "the derivative of equation size by constant q is stated as 0e0, and is ";
    assert!(wrong.len() == 1 && wrong[0].to_string().starts_with(told), "{wrong:?}");
    assert!((wrong[0].found + 1.0).abs() < 1e-6);
}

/// Dual numbers are right, and so are differences: on the worst of right-hand sides nothing is told.
#[test]
fn derivatives_that_are_made_here_are_right() {
    let dual = Bvp::new(
        &["u", "v", "w"],
        (0.0, 1.0),
        |x, y, p, f| {
            f[0] = (y[1] * p[0]).tanh() + (y[2] + 2.0).sqrt();
            f[1] = (y[0] - x).abs() * (y[1] * 40.0).sin();
            f[2] = (y[0] * y[2]).exp() / (y[1] + 3.0);
        },
        |a, b, p, g| (g[0], g[1], g[2], g[3]) = (a[0] * b[1], b[0] - p[0], a[2].powi(3), b[2] * p[0].exp()),
    )
    .unknown("p", 0.7)
    .guess(12, |x, y| y.copy_from_slice(&[x, 0.2 - x, 0.5]));
    assert_eq!(check_derivatives(&dual, &dual.start()).unwrap(), []);
    let undefined = Bvp::new(&["u"], (0.0, 1.0), |_, y, _, f| f[0] = y[0].ln(), |a, _, _, g| g[0] = a[0] - 1.0)
        .guess(5, |x, y| y[0] = x - 0.5);
    assert_eq!(check_derivatives(&undefined, &undefined.start()).unwrap(), []);
    let mut other = dual.start();
    other.constants.clear();
    assert!(check_derivatives(&dual, &other).is_err());
}

/// `u' = a b u`, in which the layout has derivatives by `a` alone.
struct Lacking;

impl Model for Lacking {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u"], &[], 1)], &["a", "b"], &["left"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = y[0] * c[0] * c[1];
    }
    fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
        g[0] = ends[0] - 1.0;
    }
}

#[test]
fn derivatives_that_no_pattern_has_are_told() {
    let problem = Differentiated::new(Lacking).unwrap();
    let at = Guess::uniform(problem.layout(), 10, &[2.0, 3.0], |_, s, y| y[0] = 1.0 + s);
    let wrong = check_derivatives(&problem, &at).unwrap();
    let [wrong] = wrong.as_slice() else { panic!("{wrong:?}") };
    assert_eq!((wrong.of.as_str(), wrong.by.as_deref(), wrong.stated), ("u'", Some("constant b"), 0.0), "{wrong}");
}
