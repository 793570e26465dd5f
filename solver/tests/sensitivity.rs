//! Sensitivities, forward and adjoint, against differences of full solves; conditioning.

#![allow(clippy::unwrap_used, clippy::needless_range_loop)]

use solver::model::{Differentiated, Model, Scalar};
use solver::{
    Condensation, Functional, Guess, Layout, Linearisation, Options, Order, Problem, Region, Solution, solve,
};

/// A hot rod in two pieces whose interface temperature and heat flow are continuous; the source strength `q` follows
/// from the mean temperature. Constants: conductivities, exponent of radiation, ends, mean; unknown: source.
struct Rod;

const UNKNOWN: [usize; 1] = [5];

impl Model for Rod {
    fn layout(&self) -> Layout {
        let constants = ["k1", "k2", "radiation", "left", "mean", "source"];
        let first = Region::dense("copper", (0.0, 1.0), &["T", "flow"], &["heat", "lost"], constants.len());
        let second = Region::dense("steel", (1.0, 1.5), &["T", "flow"], &["heat"], constants.len());
        Layout::dense(vec![first, second], &constants, &["left", "joint T", "joint flow", "right", "mean"])
    }
    fn rhs<S: Scalar>(&self, region: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
        f[0] = -y[1] / c[region];
        f[1] = c[5] * (s * 2.0).cos() - c[2] * y[0].powi(3);
        f[2] = y[0];
        if region == 0 {
            f[3] = c[2] * y[0].powi(3);
        }
    }
    fn boundary<S: Scalar>(&self, e: &[S], i: &[S], c: &[S], g: &mut [S]) {
        (g[0], g[1], g[2]) = (e[0] - c[3], e[2] - e[4], e[3] - e[5]);
        (g[3], g[4]) = (e[7] - e[6] * c[2], i[0] + i[2] - c[4]);
    }
}

const CONSTANTS: [f64; 6] = [1.3, 0.4, 0.3, 1.0, 1.8, 1.0];

fn solved(constants: &[f64], order: Order) -> Solution {
    let problem = Differentiated::new(Rod).unwrap();
    let guess = Guess::uniform(problem.layout(), 8, constants, |_, _, y| (y[0], y[1]) = (1.0, 0.0));
    solve(&problem, &guess, &UNKNOWN, &Options { order, tolerance: 1e-11, ..Options::default() }).unwrap()
}

/// Ends, integrals and constants.
fn inputs(solution: &Solution) -> Vec<f64> {
    let mut out = Vec::new();
    for region in solution.regions() {
        out.extend((0..2).map(|i| region.state(i)[0]));
        out.extend((0..2).map(|i| region.state(i)[region.intervals()]));
    }
    out.extend(solution.regions().iter().flat_map(|region| region.integrals().iter().copied()));
    out.extend(solution.constants());
    out
}

#[test]
fn tangents_and_adjoints_agree_with_differences_of_solves() {
    let problem = Differentiated::new(Rod).unwrap();
    for order in [Order::Four, Order::Six, Order::Eight, Order::SixGauss] {
        let solution = solved(&CONSTANTS, order);
        let linearisation = Linearisation::new(&problem, &solution).unwrap();
        assert_eq!(linearisation.stats().factorisations, 1);
        let condensation = Condensation::new(&problem, &solution).unwrap();
        assert_eq!((condensation.stats().factorisations, condensation.stats().linear_solves), (1, 5));
        assert!(condensation.rates(5).is_none() && condensation.rates(6).is_none());
        let size = problem.layout().inputs();
        // Rows of the Jacobian by adjoints: one functional an input.
        let gradients: Vec<Vec<f64>> = (0..size)
            .map(|input| {
                let mut weights = vec![0.0; size];
                weights[input] = 1.0;
                linearisation.gradient(&Functional { inputs: weights, ..Functional::default() })
            })
            .collect();
        for constant in 0..5 {
            let step = 1e-4;
            let moved = |by: f64| {
                let mut constants = CONSTANTS;
                constants[constant] += by;
                inputs(&solved(&constants, order))
            };
            let (far, near) = ((moved(2.0 * step), moved(-2.0 * step)), (moved(step), moved(-step)));
            let tangent = linearisation.sensitivity(constant).inputs();
            for input in 0..size {
                // Fourth-order differences.
                let difference =
                    (8.0 * (near.0[input] - near.1[input]) - (far.0[input] - far.1[input])) / (12.0 * step);
                let tolerance = 1e-6 * (1.0 + difference.abs());
                assert!(
                    (tangent[input] - difference).abs() < tolerance,
                    "{constant} {input}: {} {difference}",
                    tangent[input]
                );
                assert!((gradients[input][constant] - tangent[input]).abs() < 1e-9, "adjoint {constant} {input}");
                let condensed = condensation.rates(constant).unwrap()[input];
                assert!((condensed - tangent[input]).abs() < 1e-9, "condensed {constant} {input}");
            }
        }
    }
}

#[test]
fn an_adjoint_of_interior_values_agrees_with_the_tangent() {
    let problem = Differentiated::new(Rod).unwrap();
    let solution = solved(&CONSTANTS, Order::Four);
    let linearisation = Linearisation::new(&problem, &solution).unwrap();
    let last = solution.regions()[1].intervals();
    let nodes = vec![(0, 3, 1, 2.0), (1, 0, 0, 0.5), (1, last - 1, 0, -1.0), (1, last, 1, 0.25)];
    let gradient = linearisation.gradient(&Functional { nodes: nodes.clone(), ..Functional::default() });
    for constant in 0..5 {
        let tangent = linearisation.sensitivity(constant);
        let forward: f64 = nodes.iter().map(|&(r, j, i, weight)| weight * tangent.regions[r].states[i][j]).sum();
        assert!((gradient[constant] - forward).abs() < 1e-10 * (1.0 + forward.abs()), "{constant}");
    }
    assert_eq!(gradient[5], 0.0);
}

/// `ε u' = v, ε v' = u`, `u(0) = u(1) = 1`: layers of width ε at both ends.
struct Layer(f64);

impl Model for Layer {
    fn layout(&self) -> Layout {
        Layout::dense(vec![Region::dense("line", (0.0, 1.0), &["u", "v"], &[], 0)], &[], &["left", "right"])
    }
    fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
        (f[0], f[1]) = (y[1] / self.0, y[0] / self.0);
    }
    fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
        (g[0], g[1]) = (e[0] - 1.0, e[2] - 1.0);
    }
}

#[test]
fn conditioning_tells_a_layer_from_an_ill_posed_problem() {
    let problem = Differentiated::new(Layer(0.01)).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, _, y| y.fill(0.0));
    let solution = solve(&problem, &guess, &[], &Options::default()).unwrap();
    let conditioning = Linearisation::new(&problem, &solution).unwrap().conditioning();
    println!("{conditioning:?} {}", conditioning.stiffness());
    // Unit changes at either end reach 1 there (u + u', each of size 1) and decay over 0.01.
    assert!((conditioning.kappa1 - 1.0).abs() < 0.1);
    assert!((conditioning.gamma1 - 0.02).abs() < 0.005);
    assert!((30.0..100.0).contains(&conditioning.stiffness()));
    // u'' = -(1-δ)² π² u is nearly singular.
    struct Resonant;
    impl Model for Resonant {
        fn layout(&self) -> Layout {
            Layer(1.0).layout()
        }
        fn rhs<S: Scalar>(&self, _: usize, _: S, y: &[S], _: &[S], f: &mut [S]) {
            (f[0], f[1]) = (y[1], -y[0] * (std::f64::consts::PI * 0.9999).powi(2));
        }
        fn boundary<S: Scalar>(&self, e: &[S], i: &[S], c: &[S], g: &mut [S]) {
            Layer(1.0).boundary(e, i, c, g);
        }
    }
    let problem = Differentiated::new(Resonant).unwrap();
    let solution = solve(&problem, &guess, &[], &Options::default()).unwrap();
    let conditioning = Linearisation::new(&problem, &solution).unwrap().conditioning();
    println!("{conditioning:?} {}", conditioning.stiffness());
    assert!(conditioning.kappa() > 1e3, "{conditioning:?}");
}

#[test]
fn what_is_singular_at_the_solution_is_named_by_the_condensation_too() {
    /// The left end twice.
    struct Twice;
    impl Model for Twice {
        fn layout(&self) -> Layout {
            Layer(1.0).layout()
        }
        fn rhs<S: Scalar>(&self, r: usize, s: S, y: &[S], c: &[S], f: &mut [S]) {
            Layer(1.0).rhs(r, s, y, c, f);
        }
        fn boundary<S: Scalar>(&self, e: &[S], _: &[S], _: &[S], g: &mut [S]) {
            (g[0], g[1]) = (e[0] - 1.0, e[0] - 1.0);
        }
    }
    let problem = Differentiated::new(Layer(1.0)).unwrap();
    let guess = Guess::uniform(problem.layout(), 10, &[], |_, _, y| y.fill(0.0));
    let solution = solve(&problem, &guess, &[], &Options::default()).unwrap();
    let twice = Differentiated::new(Twice).unwrap();
    let error = Condensation::new(&twice, &solution).unwrap_err();
    assert!(error.to_string().contains("have rank 3 of 4"), "{error}");
    assert_eq!(error.to_string(), Linearisation::new(&twice, &solution).map(|_| ()).unwrap_err().to_string());
}

#[test]
fn weights_on_single_intervals_add_up_to_those_on_integrals() {
    let problem = Differentiated::new(Rod).unwrap();
    let solution = solved(&CONSTANTS, Order::Four);
    let linearisation = Linearisation::new(&problem, &solution).unwrap();
    let layout = problem.layout();
    let mut first = layout.ends();
    for (region, part) in solution.regions().iter().enumerate() {
        for k in 0..part.integrals().len() {
            let mut inputs = vec![0.0; layout.inputs()];
            inputs[first + k] = 1.0;
            let whole = linearisation.gradient(&Functional { inputs, ..Functional::default() });
            let intervals = (0..part.intervals()).map(|interval| (region, interval, k, 1.0)).collect();
            let parts = linearisation.gradient(&Functional { intervals, ..Functional::default() });
            for (whole, parts) in whole.iter().zip(&parts) {
                assert!((whole - parts).abs() < 1e-9 * (1.0 + whole.abs()), "{region} {k}: {whole} and {parts}");
            }
        }
        first += part.integrals().len();
    }
}
