//! Derivatives of stated models against formulas, in batches with a stride.

use solver::model::{Differentiated, Model, Scalar};
use solver::{Layout, Points, Problem, Region, Scope};

/// Two regions, an integral, constants of both kinds, eleven inputs to the boundary.
struct Pair;

impl Model for Pair {
    fn layout(&self) -> Layout {
        let first = Region::dense("first", (0.0, 1.0), &["u", "v", "w"], &["area"], 2);
        let second = Region::dense("second", (-1.0, 2.0), &["q"], &[], 2);
        Layout::dense(vec![first, second], &["eps", "lambda"], &["one", "two", "three", "four", "five"])
    }

    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        if region == 0 {
            f[0] = y[1] * s;
            f[1] = y[0].exp() * c[1] / c[0];
            f[2] = y[2].sin() * y[0] + 1.0;
            f[3] = y[2] * y[2];
        } else {
            f[0] = -y[0] * c[1] + s.cos();
        }
    }

    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        g[0] = ends[0] - ends[7].tanh();
        g[1] = ends[3] * ends[4];
        g[2] = integrals[0] - c[1];
        g[3] = ends[5].powi(3) - 2.0;
        g[4] = ends[1] + ends[6] * c[0];
    }
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-14 * (1.0 + b.abs()), "{a} is not {b}");
}

/// Derivatives of region 0 at one point, `(4 rows) × (3 states, eps, lambda)`, by the formulas.
fn expected(s: f64, y: [f64; 3], c: [f64; 2]) -> [[f64; 5]; 4] {
    let e = y[0].exp();
    [
        [0.0, s, 0.0, 0.0, 0.0],
        [e * c[1] / c[0], 0.0, 0.0, -e * c[1] / (c[0] * c[0]), e / c[0]],
        [y[2].sin(), 0.0, y[2].cos() * y[0], 0.0, 0.0],
        [0.0, 0.0, 2.0 * y[2], 0.0, 0.0],
    ]
}

fn check_region(problem: &Differentiated<Pair>, scope: Scope) {
    let (len, stride, c) = (3, 4, [0.3, 1.7]);
    let s = [0.1, 0.5, 0.9, f64::NAN];
    let y: Vec<f64> = (0..3 * stride).map(|i| 0.2 + 0.1 * i as f64).collect();
    let region = &problem.layout().regions[0];
    let mut f = vec![f64::NAN; 4 * stride];
    let mut dy = vec![f64::NAN; region.state_pattern.len() * stride];
    let mut dc = vec![f64::NAN; region.constant_pattern.len() * stride];
    let at = Points { len, stride, s: &s, y: &y };
    problem.rhs_jacobian(0, &at, &c, scope, &mut f, &mut dy, &mut dc);
    let mut value = vec![f64::NAN; 4 * stride];
    problem.rhs(0, &at, &c, &mut value);
    let written = if scope == Scope::All { region.constant_pattern.len() } else { region.default_entries };
    for j in 0..len {
        let expected = expected(s[j], [y[j], y[stride + j], y[2 * stride + j]], c);
        (0..4).for_each(|row| close(f[row * stride + j], value[row * stride + j]));
        for (entry, &(row, state)) in region.state_pattern.iter().enumerate() {
            close(dy[entry * stride + j], expected[row][state]);
        }
        for (entry, &(row, constant)) in region.constant_pattern.iter().enumerate().take(written) {
            close(dc[entry * stride + j], expected[row][3 + constant]);
        }
    }
    assert!(
        dc.iter().skip(written * stride).all(|value| value.is_nan()),
        "a constant that is no default unknown was written"
    );
}

#[test]
fn derivatives_equal_the_formulas() {
    check_region(&Differentiated::new(Pair).unwrap(), Scope::All);
    check_region(&Differentiated::new(Pair).unwrap(), Scope::DefaultUnknowns);
    let default = Differentiated::with_default_unknowns(Pair, &["lambda"]).unwrap();
    assert_eq!(default.layout().regions[0].default_entries, 4);
    check_region(&default, Scope::DefaultUnknowns);
    check_region(&default, Scope::All);
}

#[test]
fn narrowing_keeps_exactly_what_the_formulas_depend_on() {
    let problem = Differentiated::with_default_unknowns(Pair, &["lambda"]).unwrap().narrowed(2).unwrap();
    let region = &problem.layout().regions[0];
    assert_eq!(region.state_pattern, [(0, 1), (1, 0), (2, 0), (2, 2), (3, 2)]);
    assert_eq!(region.constant_pattern, [(1, 1), (1, 0)]);
    assert_eq!(region.default_entries, 1);
    assert_eq!(problem.layout().regions[1].state_pattern, [(0, 0)]);
    let boundary = [(0, 0), (0, 7), (1, 3), (1, 4), (2, 8), (2, 10), (3, 5), (4, 1), (4, 6), (4, 9)];
    assert_eq!(problem.layout().boundary_pattern, boundary);
    check_region(&problem, Scope::DefaultUnknowns);
    check_region(&problem, Scope::All);
}

#[test]
fn boundary_derivatives_equal_the_formulas() {
    let problem = Differentiated::new(Pair).unwrap();
    let ends = [0.4, 0.3, 0.2, 0.9, 1.1, 1.3, 0.7, 0.6];
    let (integrals, c) = ([2.5], [0.3, 1.7]);
    let mut g = [0.0; 5];
    let mut dz = vec![f64::NAN; 5 * 11];
    problem.boundary_jacobian(&ends, &integrals, &c, &mut g, &mut dz);
    let mut expected = [[0.0; 11]; 5];
    (expected[0][0], expected[0][7]) = (1.0, -1.0 / 0.6_f64.cosh().powi(2));
    (expected[1][3], expected[1][4]) = (1.1, 0.9);
    (expected[2][8], expected[2][10]) = (1.0, -1.0);
    expected[3][5] = 3.0 * 1.3 * 1.3;
    (expected[4][1], expected[4][6], expected[4][9]) = (1.0, 0.3, 0.7);
    for (&derivative, &(row, input)) in dz.iter().zip(&problem.layout().boundary_pattern) {
        close(derivative, expected[row][input]);
    }
    let mut value = [0.0; 5];
    problem.boundary(&ends, &integrals, &c, &mut value);
    g.iter().zip(value).for_each(|(&a, b)| close(a, b));
}

#[test]
fn an_inconsistent_layout_is_refused() {
    struct Wrong;
    impl Model for Wrong {
        fn layout(&self) -> Layout {
            let mut region = Region::dense("r", (0.0, 1.0), &["y"], &[], 0);
            region.state_pattern.push((0, 7));
            Layout::dense(vec![region], &[], &["end"])
        }
        fn rhs<S: Scalar>(&self, _: usize, _: S, _: &[S], _: &[S], _: &mut [S]) {}
        fn boundary<S: Scalar>(&self, _: &[S], _: &[S], _: &[S], _: &mut [S]) {}
    }
    assert!(Differentiated::new(Wrong).is_err());
}

/// Functions whose derivatives by num-dual are not a number where they exist.
#[test]
fn powers_and_hyperbolic_tangents_have_derivatives_everywhere() {
    struct Powers;
    impl Model for Powers {
        fn layout(&self) -> Layout {
            Layout::dense(vec![Region::dense("only", (0.0, 1.0), &["u", "v"], &[], 0)], &[], &["left", "right"])
        }
        fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
            (f[0], f[1]) = (y[0].power(1.5), (y[1] * 355.0).hyperbolic_tangent());
        }
        fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
            (g[0], g[1]) = (ends[0], ends[1]);
        }
    }
    let problem = Differentiated::new(Powers).unwrap();
    for (y, value, slopes) in [([0.0, 2.0], [0.0, 1.0], [0.0, 0.0]), ([4.0, 0.0], [8.0, 0.0], [3.0, 355.0])] {
        let (mut f, mut dy) = ([9.0; 2], [9.0; 4]);
        let at = Points { len: 1, stride: 1, s: &[0.5], y: &y };
        problem.rhs_jacobian(0, &at, &[], Scope::All, &mut f, &mut dy, &mut []);
        let pattern = &problem.layout().regions[0].state_pattern;
        let slope = |i: usize| dy[pattern.iter().position(|&entry| entry == (i, i)).unwrap()];
        assert_eq!((f, [slope(0), slope(1)]), (value, slopes));
    }
}
