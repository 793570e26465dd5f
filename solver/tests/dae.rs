//! Semi-explicit differential-algebraic problems: against the same equations differentiated by hand, exact solutions,
//! finite differences; what is refused.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp)]

use solver::dae::{Dae, Reduced};
use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Guess, Layout, LayoutError, Multipliers, Options, Orbit, Order, Points, Problem, Region, Scope, SolveError, solve,
};

/// A flow from x = 0 to 2 in two pieces, y' = -z w with z and w given by two coupled equations,
/// `0 = z + a tanh(w) - 2 y`, `0 = w³ + w - z`, an integral ∫ z and the unknown a, such that the integral is 1; in the
/// second piece, 0 = z - y² only, and y' = -z.
struct Pieces;

/// The equations as they stand.
fn first_piece<S: Scalar>(y: S, z: S, w: S, a: S, power: f64) -> [S; 3] {
    [-z * w, z + a * w.hyperbolic_tangent() - y * 2.0, w.power(power) + w - z]
}

const POWER: f64 = 3.0;

impl Dae for Pieces {
    fn layout(&self) -> Layout {
        let first = Region::dense("first", (0.0, 1.0), &["y", "z", "w"], &["flow"], 1);
        let second = Region::dense("second", (1.0, 2.0), &["u", "v"], &[], 1);
        Layout::dense(vec![first, second], &["a"], &["start", "joint", "flow"])
    }
    fn algebraic(&self, region: usize) -> usize {
        2 - region
    }
    fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        if region == 0 {
            f[..3].copy_from_slice(&first_piece(y[0], y[1], y[2], c[0], POWER));
            f[3] = y[1];
        } else {
            (f[0], f[1]) = (-y[1], y[1] - y[0] * y[0]);
        }
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], _: &[S], g: &mut [S]) {
        // Ends: y, z, w at 0, then at 1; u, v at 1, then at 2.
        (g[0], g[1], g[2]) = (ends[0] - 1.5, ends[6] - ends[3], integrals[0] - 1.0);
    }
}

/// The same, with z' and w' by hand.
struct ByHand;

impl Model for ByHand {
    fn layout(&self) -> Layout {
        let mut layout = Pieces.layout();
        let more = ["z", "w", "v"].map(|name| format!("{name} at its start"));
        layout.equations.extend(more);
        let names: Vec<&str> = layout.equations.iter().map(String::as_str).collect();
        Layout::dense(layout.regions.clone(), &["a"], &names)
    }
    fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
        if region == 1 {
            (f[0], f[1]) = (-y[1], -y[0] * y[1] * 2.0);
            return;
        }
        let (z, w, a) = (y[1], y[2], c[0]);
        f[0] = -z * w;
        // z' + a (1 - tanh² w) w' = 2 y',  (3 w² + 1) w' = z'.
        let (slope, cubic) = (-w.tanh() * w.tanh() + 1.0, w * w * 3.0 + 1.0);
        f[2] = f[0] * 2.0 / (cubic + a * slope);
        f[1] = f[2] * cubic;
        f[3] = z;
    }
    fn boundary<S: Scalar>(&self, ends: &[S], integrals: &[S], c: &[S], g: &mut [S]) {
        Pieces.boundary(ends, integrals, c, &mut g[..3]);
        let [_, first, second] = first_piece(ends[0], ends[1], ends[2], c[0], POWER);
        (g[3], g[4], g[5]) = (first, second, ends[7] - ends[6] * ends[6]);
    }
}

fn guess(layout: &Layout) -> Guess {
    Guess::uniform(layout, 12, &[1.0], |_, _, y| y.fill(0.8))
}

#[test]
fn it_is_solved_as_if_it_had_been_differentiated_by_hand() {
    let problem = Differentiated::new(Reduced::new(Pieces).unwrap()).unwrap();
    let by_hand = Differentiated::new(ByHand).unwrap();
    assert_eq!(problem.layout().equations.len(), by_hand.layout().equations.len());
    for (order, tolerance) in [(Order::Four, 1e-5), (Order::Six, 1e-8), (Order::Eight, 1e-10)] {
        let options = Options { order, tolerance, ..Options::default() };
        let ours = solve(&problem, &guess(problem.layout()), &[0], &options).unwrap();
        let theirs = solve(&by_hand, &guess(by_hand.layout()), &[0], &options).unwrap();
        // The same equations up to rounding: as many iterations, and the same numbers.
        assert_eq!(ours.stats().newton_iterations, theirs.stats().newton_iterations, "{order:?}");
        assert!((ours.constants()[0] - theirs.constants()[0]).abs() < 1e-11, "{order:?}");
        for (ours, theirs) in ours.regions().iter().zip(theirs.regions()) {
            assert_eq!(ours.mesh(), theirs.mesh(), "{order:?}");
            for state in 0..ours.states() {
                let pairs = ours.state(state).iter().zip(theirs.state(state));
                assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 1e-11), "{order:?}, state {state}");
            }
        }
        assert!(problem.model().remainder(&theirs) < 10.0 * tolerance);
        // And g holds along the way, to the tolerance; z moves by much more than that.
        let remainder = problem.model().remainder(&ours);
        assert!(remainder < 10.0 * tolerance, "{order:?}: {remainder:e}");
        let z = ours.regions()[0].state(1);
        assert!((z[0] - z[z.len() - 1]).abs() > 0.1);
    }
}

#[test]
fn the_joint_is_met_and_the_second_piece_has_its_exact_solution() {
    let problem = Differentiated::new(Reduced::new(Pieces).unwrap()).unwrap();
    let options = Options { tolerance: 1e-9, ..Options::default() };
    let solution = solve(&problem, &guess(problem.layout()), &[0], &options).unwrap();
    let second = &solution.regions()[1];
    // u' = -u², so that 1/u grows by 1 each unit of length.
    let (from, to) = (second.eval(1.0)[0], second.eval(2.0));
    assert!((1.0 / to[0] - 1.0 / from - 1.0).abs() < 1e-8);
    assert!((to[1] - to[0] * to[0]).abs() < 1e-8);
}

/// All derivatives of the reduced equations and boundary conditions against central differences.
#[test]
fn derivatives_are_those_of_the_reduced_equations() {
    let problem = Differentiated::new(Reduced::new(Pieces).unwrap()).unwrap();
    let layout = problem.layout();
    const STEP: f64 = 1e-5;
    let near = |a: f64, b: f64| (a - b).abs() < 1e-8 * (1.0 + a.abs());
    for (index, region) in layout.regions.iter().enumerate() {
        let states: Vec<f64> = (0..region.states.len()).map(|i| 0.9 - 0.2 * i as f64).collect();
        let (s, c, rows) = ([0.3], [0.7], region.rows());
        let value = |y: &[f64], c: &[f64]| {
            let mut f = vec![0.0; rows];
            problem.rhs(index, &Points { len: 1, stride: 1, s: &s, y }, c, &mut f);
            f
        };
        let (mut f, mut dy) = (vec![0.0; rows], vec![0.0; region.state_pattern.len()]);
        let mut dc = vec![0.0; region.constant_pattern.len()];
        let at = Points { len: 1, stride: 1, s: &s, y: &states };
        problem.rhs_jacobian(index, &at, &c, Scope::All, &mut f, &mut dy, &mut dc);
        let difference = |row: usize, (up, down): (Vec<f64>, Vec<f64>)| (up[row] - down[row]) / (2.0 * STEP);
        let moved = |x: &[f64], i: usize, by: f64| {
            let mut x = x.to_vec();
            x[i] += by;
            x
        };
        for (&(row, state), dy) in region.state_pattern.iter().zip(&dy) {
            let sides = [STEP, -STEP].map(|by| value(&moved(&states, state, by), &c));
            let found = difference(row, sides.into());
            assert!(near(found, *dy), "region {index}, row {row}, state {state}: {found} {dy}");
        }
        for (&(row, constant), dc) in region.constant_pattern.iter().zip(&dc) {
            let sides = [STEP, -STEP].map(|by| value(&states, &moved(&c, constant, by)));
            let found = difference(row, sides.into());
            assert!(near(found, *dc), "region {index}, row {row}, constant {constant}: {found} {dc}");
        }
    }
    // The boundary: no derivative outside the pattern, and those inside as they are.
    let inputs: Vec<f64> = (0..layout.inputs()).map(|i| 0.3 + 0.05 * i as f64).collect();
    let (ends, integrals) = (layout.ends(), layout.integrals());
    let value = |inputs: &[f64]| {
        let (ends, rest) = inputs.split_at(ends);
        let (integrals, constants) = rest.split_at(integrals);
        let mut g = vec![0.0; layout.equations.len()];
        problem.boundary(ends, integrals, constants, &mut g);
        g
    };
    let mut dense = vec![vec![0.0; inputs.len()]; layout.equations.len()];
    let (mut g, mut dz) = (vec![0.0; layout.equations.len()], vec![0.0; layout.boundary_pattern.len()]);
    let (of_ends, rest) = inputs.split_at(ends);
    problem.boundary_jacobian(of_ends, &rest[..integrals], &rest[integrals..], &mut g, &mut dz);
    for (&(row, input), dz) in layout.boundary_pattern.iter().zip(&dz) {
        dense[row][input] += dz;
    }
    for input in 0..inputs.len() {
        let [up, down] = [STEP, -STEP].map(|by| {
            let mut moved = inputs.clone();
            moved[input] += by;
            value(&moved)
        });
        for (row, dense) in dense.iter().enumerate() {
            let found = (up[row] - down[row]) / (2.0 * STEP);
            assert!(near(found, dense[input]), "equation {row}, input {input}: {found} {}", dense[input]);
        }
    }
}

/// Patterns narrower than dense, constants that are not default unknowns, and none that is algebraic in one region.
#[test]
fn patterns_are_widened_by_what_the_algebraic_rows_need_alone() {
    struct Narrow;
    impl Dae for Narrow {
        fn layout(&self) -> Layout {
            let mut plain = Region::dense("plain", (0.0, 1.0), &["p"], &[], 3);
            plain.constant_pattern.clear();
            plain.default_entries = 0;
            let mut bent = Region::dense("bent", (0.0, 1.0), &["y", "z"], &["i"], 0);
            // y' of z and constant 1; g of y, z and constant 0; the integrand of y and constant 2.
            bent.state_pattern = vec![(0, 1), (1, 0), (1, 1), (2, 0)];
            bent.constant_pattern = vec![(0, 1), (1, 0), (2, 2)];
            bent.default_entries = 1;
            Layout::dense(vec![plain, bent], &["k", "l", "m"], &["one", "two"])
        }
        fn algebraic(&self, region: usize) -> usize {
            region
        }
        fn rhs<S: Scalar>(&self, region: usize, _: S, y: &[S], c: &[S], f: &mut [S]) {
            if region == 0 {
                f[0] = y[0];
                return;
            }
            (f[0], f[1], f[2]) = (y[1] * c[1], y[1].exp() - y[0] * c[0], y[0] * c[2]);
        }
        fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
            (g[0], g[1]) = (ends[0] - 1.0, ends[2] - 1.0);
        }
    }
    let layout = Model::layout(&Reduced::new(Narrow).unwrap());
    assert_eq!(layout.regions[0], Narrow.layout().regions[0]);
    let bent = &layout.regions[1];
    assert_eq!(bent.state_pattern, [(0, 1), (2, 0), (1, 0), (1, 1)]);
    assert_eq!(bent.constant_pattern, [(0, 1), (1, 1), (2, 2), (1, 0)]);
    assert_eq!(bent.default_entries, 2);
    assert_eq!(layout.equations[2], "0 = g of z at the start of bent");
    // The ends: p twice, then y, z twice; one integral; k, l, m.
    let of_g: Vec<_> = layout.boundary_pattern.iter().filter(|(row, _)| *row == 2).map(|(_, input)| *input).collect();
    assert_eq!(of_g, [2, 3, 7]);
}

/// y' = z, 0 = y - x: of index 2. And more algebraic equations than states.
#[test]
fn what_is_not_of_index_1_is_refused_with_the_name_of_z() {
    struct Higher(usize);
    impl Dae for Higher {
        fn layout(&self) -> Layout {
            Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["y", "z"], &[], 0)], &[], &["start"])
        }
        fn algebraic(&self, _: usize) -> usize {
            self.0
        }
        fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
            (f[0], f[1]) = (y[1], y[0] - s);
        }
        fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
            g[0] = ends[0];
        }
    }
    let problem = Differentiated::new(Reduced::new(Higher(1)).unwrap()).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, s, y| (y[0], y[1]) = (s, 1.0));
    let error = solve(&problem, &guess, &[], &Options::default()).unwrap_err();
    assert!(matches!(error, SolveError::Newton { .. }), "{error:?}");
    let told = error.to_string();
    assert!(told.contains('z') && told.contains("line"), "{told}");
    let refused = Reduced::new(Higher(3)).map(|_| ());
    assert_eq!(refused, Err(LayoutError::Algebraic { region: "line".into(), algebraic: 3, states: 2 }));
}

/// Second derivatives of the two functions of [`Scalar`], which ∂g/∂z has.
#[test]
fn powers_and_hyperbolic_tangents_have_second_derivatives() {
    struct Curved(f64);
    impl Dae for Curved {
        fn layout(&self) -> Layout {
            Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["y", "z"], &[], 0)], &[], &["start"])
        }
        fn algebraic(&self, _: usize) -> usize {
            1
        }
        fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
            f[0] = S::from(1.0);
            f[1] = y[1].power(self.0) + y[1].hyperbolic_tangent() - y[0] - s * 2.0;
        }
        fn boundary<S: Scalar>(&self, ends: &[S], _: &[S], _: &[S], g: &mut [S]) {
            g[0] = ends[0];
        }
    }
    for (power, z) in [(1.5, 0.7), (2.5, 2.0), (-0.5, 0.3), (3.0, -0.4), (0.0, 0.2), (1.0, 30.0)] {
        let problem = Differentiated::new(Reduced::new(Curved(power)).unwrap()).unwrap();
        let (y, mut f, mut dy) = ([0.1, z], [0.0; 2], [0.0; 4]);
        let at = Points { len: 1, stride: 1, s: &[0.0], y: &y };
        problem.rhs_jacobian(0, &at, &[], Scope::All, &mut f, &mut dy, &mut []);
        // z' = 3 / g_z, ∂z'/∂z = -3 g_zz / g_z².
        let (tanh, second) = (z.tanh(), power * (power - 1.0) * z.powf(power - 2.0));
        let slope = power * z.powf(power - 1.0) + 1.0 - tanh * tanh;
        let bend = second - 2.0 * tanh * (1.0 - tanh * tanh);
        assert!((f[1] - 3.0 / slope).abs() < 1e-12 * (3.0 / slope).abs(), "{power} {z}: {}", f[1]);
        assert!((dy[3] + 3.0 * bend / (slope * slope)).abs() < 1e-11 * (1.0 + bend.abs()), "{power} {z}: {}", dy[3]);
    }
}

/// `u' = v, v' = z, 0 = z + 2u + 0.2v - cos s`: a forced oscillator with friction, a spring of stiffness 2 and unit
/// mass.
struct Oscillator;

impl Dae for Oscillator {
    fn layout(&self) -> Layout {
        let period = Region::dense("period", (0.0, std::f64::consts::TAU), &["u", "v", "z"], &[], 0);
        Layout::dense(vec![period], &[], &["u returns", "v returns"])
    }
    fn algebraic(&self, _: usize) -> usize {
        1
    }
    fn rhs<S: Scalar>(&self, _: usize, s: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1], f[2]) = (y[1], y[2], y[2] + y[0] * 2.0 + y[1] * 0.2 - s.cos());
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[3] - e[0], e[4] - e[1]);
    }
}

/// That g stays as it is gives the differentiated equations a multiplier 1 that the problem does not have.
#[test]
fn an_algebraic_equation_has_no_multiplier() {
    let problem = Differentiated::new(Reduced::new(Oscillator).unwrap()).unwrap();
    let guess = Guess::uniform(problem.layout(), 20, &[], |_, _, y| y.fill(0.0));
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let solution = solve(&problem, &guess, &[], &Options { order, tolerance: 1e-8, ..Options::default() }).unwrap();
        let multipliers = Multipliers::new(&problem, &solution, 0, Orbit::Forced, 1e-8).unwrap();
        let [one, other] = multipliers.values() else { panic!("{multipliers:?}") };
        // u'' + 0.2 u' + 2 u = 0 decays as exp(-0.1 s), and turns by √1.99 s.
        let wanted = (-0.1 * std::f64::consts::TAU).exp();
        let turned = (1.99_f64.sqrt() * std::f64::consts::TAU).cos();
        for value in [one, other] {
            assert!((value.modulus() - wanted).abs() < 1e-7, "{order:?}: {value:?}");
            assert!((value.re - wanted * turned).abs() < 1e-7, "{order:?}: {value:?}");
        }
        assert!(multipliers.is_stable() && multipliers.torus() > 0.0 && multipliers.trivial().is_none());
    }
}
