//! All kernels against the model written down a second time, by hand and without any symbolic work: sliding angle and
//! apparent sheave angle as angles, shear by arithmetic on power series in the wrap angle.
#![allow(non_snake_case, clippy::unwrap_used, clippy::panic)]

mod common;
mod series;

use std::f64::consts::PI;

use common::{Point, Random, Slip, at, point};
use generated::{BOUNDARIES, BOUNDARY_STRING, BoundaryKernel, REGIONS, RegionKernel, Symbol};
use series::Series;

const TOLERANCE: f64 = 2e-11;

/// Values by name; what a kernel does not have is zero.
struct Names<'a>(&'a RegionKernel, &'a Point);

impl Names<'_> {
    fn get(&self, name: &str) -> f64 {
        let Names(kernel, point) = self;
        let named = common::inputs(kernel).zip(point.y.iter().chain(&point.constants));
        named.into_iter().find(|(symbol, _)| symbol.name == name).map_or(0.0, |(_, value)| *value)
    }
}

/// Shear and its derivative at one point of a groove.
struct Shear {
    M_b: f64,
    Q: f64,
    Q_1: f64,
}

/// θ = θ_0 + θ' φ + θ'' φ²/2 + θ''' φ³/6; x from x' = −(R − x) tanθ, power by power.
fn series_of_path(theta: [f64; 4], x: f64, R: f64) -> (Series, Series) {
    let angle = Series([theta[0], theta[1], theta[2] / 2.0, theta[3] / 6.0]);
    let mut depth = Series([x, 0.0, 0.0, 0.0]);
    for power in 0..3 {
        let slope = Series::constant(0.0) - (Series::constant(R) - depth) * angle.sin() / angle.cos();
        depth.0[power + 1] = slope.0[power] / (power + 1) as f64;
    }
    (angle, depth)
}

fn exact_shear(theta: [f64; 4], x: f64, R: f64, EI: f64) -> Shear {
    let (angle, depth) = series_of_path(theta, x, R);
    let per_length = angle.cos() / (Series::constant(R) - depth);
    let psi_1 = Series::constant(1.0) - angle.derivative();
    let moment = Series::constant(EI) * psi_1 * per_length;
    let shear = moment.derivative() * per_length;
    Shear { M_b: moment.0[0], Q: shear.0[0], Q_1: shear.derivative().0[0] }
}

/// (3.38), (3.40).
fn linear_shear(theta: [f64; 4], x: f64, R: f64, EI: f64) -> Shear {
    let (_, depth) = series_of_path(theta, x, R);
    let (x_1, x_2) = (depth.0[1], 2.0 * depth.0[2]);
    let Q = -EI / R.powi(2) * theta[2] + EI / R.powi(3) * x_1;
    let Q_1 = EI / R.powi(3) * x_2 - EI / R.powi(3) * (R + 2.0 * x) * theta[3];
    Shear { M_b: EI * (1.0 - theta[1]) * theta[0].cos() / (R - x), Q, Q_1 }
}

fn shear(kernel: &str, theta: [f64; 4], x: f64, R: f64, EI: f64) -> Shear {
    if kernel.contains("full") { exact_shear(theta, x, R, EI) } else { linear_shear(theta, x, R, EI) }
}

/// Rows with their size where terms cancel, then fields.
struct Naive {
    rows: Vec<(f64, f64)>,
    fields: Vec<f64>,
}

fn contact(kernel: &RegionKernel, point: &Point) -> Naive {
    let names = Names(kernel, point);
    let c = |name: &str| names.get(name);
    let (T, theta, x, Phi, R) = (c("T"), c("theta"), c("x"), c("Phi"), c("R"));
    let (theta_1, theta_2) = (c("theta1") / Phi, c("theta2") / Phi.powi(2));
    let (EA, EI, k, m_o, beta) = (c("EA"), c("EI"), c("k"), c("m_o"), c("beta"));
    let G = c("flow") * m_o * c("R_P") * c("omega_P");
    let F = (T + G * G / m_o) / (1.0 - G * G / (EA * m_o));
    let V = G / m_o * (1.0 + F / EA);
    let v_r = V * theta.sin();
    let v_t = V * theta.cos() - (R - x) * c("sigma") * c("omega_P");
    let (speed, gamma) = (v_r.hypot(v_t), v_t.atan2(v_r).rem_euclid(2.0 * PI));
    let share =
        if kernel.name.contains("tanh") { (4.0 * speed / c("v_thr")).tanh() } else { (speed / c("v_thr")).min(1.0) };
    let mu = c("mu_k") * share;
    let beta_s = (beta.tan() * gamma.cos()).atan();
    let p = k * x / (2.0 * (beta.cos() + mu * beta_s.sin()));
    let arc = (R - x) / theta.cos();
    let n = 2.0 * p * (beta.sin() * theta.cos() - mu * beta_s.cos() * (theta + gamma).cos()) * arc;
    let t = 2.0 * p * (-beta.sin() * theta.sin() + mu * beta_s.cos() * (theta + gamma).sin()) * arc;
    // Q' is linear in θ''': two values give the one at which T (1 − θ') = n + Q'.
    let at = |theta_3: f64| shear(kernel.name, [theta, theta_1, theta_2, theta_3], x, R, EI);
    let is_string = kernel.name.contains("string");
    let none = || Shear { M_b: 0.0, Q: 0.0, Q_1: 0.0 };
    let (here, there) = if is_string { (none(), none()) } else { (at(0.0), at(1.0)) };
    let theta_3 = (T * (1.0 - theta_1) - n - here.Q_1) / (there.Q_1 - here.Q_1);
    let size = (T.abs() + n.abs() + here.Q_1.abs()) / (there.Q_1 - here.Q_1).abs();
    let turn = Phi * (1.0 - n / T);
    let T_1 = Phi * (t - here.Q * (1.0 - theta_1));
    let axial = k * x / 2.0;
    let loss = 2.0 * mu * p * speed / beta_s.cos();
    // dV/dT times the energy per length.
    let V_T = G / (EA * m_o - G * G);
    let stored = here.M_b.powi(2) / (2.0 * EI) - k * beta.tan() * x * x / 2.0;
    let place = |angle: f64| Phi * axial * arc * (R - x) * angle;
    let exact = |value: f64| (value, value.abs());
    let angles = if is_string {
        vec![(turn, Phi * (1.0 + (n / T).abs()))]
    } else {
        vec![exact(c("theta1")), exact(c("theta2")), (Phi.powi(3) * theta_3, Phi.powi(3) * size)]
    };
    let mut rows = vec![(T_1, Phi * (t.abs() + here.Q.abs()))];
    rows.extend(angles);
    rows.extend([
        exact(-Phi * (R - x) * theta.tan()),
        exact(Phi * 2.0 * mu * p * beta_s.cos() * gamma.sin() * (R - x) * arc),
        exact(Phi * axial * arc),
        exact(Phi * arc / (1.0 + F / EA)),
        exact(Phi * loss * arc),
        exact(place((Phi * point.s).cos())),
        exact(place((Phi * point.s).sin())),
        (stored * V_T * T_1, (here.M_b.powi(2) / EI + stored.abs()) * V_T * Phi * (t.abs() + here.Q.abs())),
    ]);
    // Sliding up the face at v_r/cosβ and around at v_t.
    let force = 2.0 * mu * p * beta_s.cos() / speed;
    let (radial, tangential) = (force * (v_r / beta.cos()).powi(2), force * v_t.powi(2));
    let fields = vec![
        F,
        V,
        v_r,
        v_t,
        speed,
        gamma,
        mu,
        p,
        beta_s,
        here.Q,
        here.M_b,
        axial,
        loss,
        radial,
        tangential,
        loss * arc,
    ];
    Naive { rows, fields }
}

fn span(kernel: &RegionKernel, point: &Point) -> Naive {
    let names = Names(kernel, point);
    let c = |name: &str| names.get(name);
    let (tau, direction, first, second) = (c("tau"), c("vartheta"), c("vartheta1"), c("vartheta2"));
    let (L, EA, EI, m_o) = (c("L"), c("EA"), c("EI"), c("m_o"));
    let G = c("flow") * m_o * c("R_P") * c("omega_P");
    let F = (tau + G * G / m_o) / (1.0 - G * G / (EA * m_o));
    let (M_b, Q) = (EI * first / L, EI * second / L.powi(2));
    let slip = if kernel.name.ends_with("printed") { L.powi(4) } else { 1.0 };
    let tau_1 = -slip * EI / L.powi(2) * first * second;
    let V_T = G / (EA * m_o - G * G);
    let angles = match kernel.name {
        "span_string" => vec![0.0],
        _ => vec![first, second, L.powi(2) / slip * tau * first / EI],
    };
    let integrands = [direction.cos(), direction.sin(), L / (1.0 + F / EA), M_b.powi(2) / (2.0 * EI) * V_T * tau_1];
    let rows = [tau_1].into_iter().chain(angles).chain(integrands);
    let fields = vec![F, G / m_o * (1.0 + F / EA), M_b, Q];
    Naive { rows: rows.map(|value| (value, value.abs().max(1e-3))).collect(), fields }
}

fn close(found: f64, expected: f64, size: f64, what: &str) {
    let error = (found - expected).abs();
    assert!(error <= TOLERANCE * size, "{what}: {found} and {expected}, off by {error:e} of {size:e}");
}

#[test]
fn regions() {
    for kernel in REGIONS {
        let mut random = Random::new(31);
        for sample in 0..1000 {
            let slip = if sample % 2 == 0 { Slip::Below } else { Slip::Beyond };
            let point = point(kernel, &mut random, slip);
            let naive = if kernel.name.starts_with("span") { span(kernel, &point) } else { contact(kernel, &point) };
            let found = at(kernel, kernel.value, &point).f;
            assert_eq!(found.len(), naive.rows.len());
            for (row, (found, (value, size))) in found.iter().zip(naive.rows).enumerate() {
                close(*found, value, size, &format!("{}, row {row}", kernel.name));
            }
            let fields = at(kernel, kernel.fields_fn, &point).fields;
            assert_eq!(fields.len(), naive.fields.len());
            for (symbol, (found, value)) in
                kernel.fields.iter().map(|field| field.symbol()).zip(fields.into_iter().zip(naive.fields))
            {
                // Shear is the difference of larger terms.
                let size = if symbol.name == "Q" { 10.0 } else { value.abs() };
                close(found, value, size, &format!("{}, {}", kernel.name, symbol.name));
            }
        }
    }
}

/// The shear conditions of every set; everything else in them is compared with Appendix D elsewhere.
#[test]
fn shear_at_the_ends() {
    for kernel in BOUNDARIES.iter().filter(|kernel| kernel.name.contains("full") || kernel.name.contains("linear")) {
        let mut random = Random::new(33);
        for _ in 0..200 {
            check_shear(kernel, &mut random);
        }
    }
}

fn check_shear(kernel: &BoundaryKernel, random: &mut Random) {
    let mut draw = |name: &str| match name {
        _ if name.starts_with("x_") => random.between(-1e-3, 1e-3),
        _ if name.starts_with("R_") => random.between(0.05, 0.1),
        _ if name.starts_with("Phi") => random.between(2.0, 4.0),
        _ if name.starts_with("theta_") => random.between(-0.2, 0.2),
        _ => random.between(0.1, 0.9),
    };
    let ends: Vec<f64> = kernel.ends.iter().map(|symbol| draw(symbol.name)).collect();
    let constants: Vec<f64> = kernel.constants.iter().map(|symbol| draw(symbol.name)).collect();
    let get = |name: &str| {
        let named = kernel.ends.iter().zip(&ends).chain(kernel.constants.iter().zip(&constants));
        named
            .into_iter()
            .find(|(symbol, _)| symbol.name == name)
            .map(|(_, value)| *value)
            .unwrap_or_else(|| panic!("{name}"))
    };
    let mut g = vec![f64::NAN; kernel.equations.len()];
    (kernel.value)(&ends, &vec![0.5; kernel.integrals.len()], &constants, &mut g);
    for (end, span) in [("P1", "t2"), ("P2", "s1"), ("S1", "s2"), ("S2", "t1")] {
        let (R, Phi) = (get(&format!("R_{}", &end[..1])), get(&format!("Phi_{}", &end[..1])));
        let L = get(&format!("L_{}", &span[..1]));
        let theta = [
            get(&format!("theta_{end}")),
            get(&format!("theta1_{end}")) / Phi,
            get(&format!("theta2_{end}")) / Phi.powi(2),
            0.0,
        ];
        let in_groove = shear(kernel.name, theta, get(&format!("x_{end}")), R, 1.0).Q;
        let in_span =
            if kernel.name.contains("continuous") { get(&format!("vartheta2_{span}")) / L.powi(2) } else { 0.0 };
        let row = kernel.equations.iter().position(|equation| equation.name == format!("shear_{end}")).unwrap();
        close(g[row], (in_groove - in_span) * R * R, 1.0, &format!("{}, {end}", kernel.name));
    }
}

/// All sets share their other equations; that of a string has no more than them.
#[test]
fn other_conditions_are_shared() {
    // The same value for the same name in every set.
    let value =
        |name: &str| Random::new(name.bytes().fold(7, |seed, byte| 31 * seed + u64::from(byte))).between(0.1, 0.9);
    let residuals = |kernel: &BoundaryKernel| {
        let values = |symbols: &[Symbol]| symbols.iter().map(|symbol| value(symbol.name)).collect::<Vec<f64>>();
        let mut g = vec![f64::NAN; kernel.equations.len()];
        (kernel.value)(&values(kernel.ends), &values(kernel.integrals), &values(kernel.constants), &mut g);
        kernel.equations.iter().map(|equation| equation.name).zip(g).collect::<Vec<_>>()
    };
    let own = |name: &str| name.starts_with("shear") || name.starts_with("curvature");
    let string = residuals(&BOUNDARY_STRING);
    assert!(string.len() == 18 && string.iter().all(|(name, _)| !own(name)));
    let sets = BOUNDARIES.iter().filter(|set| set.equations.iter().any(|equation| equation.name == "shear_P1"));
    let mut first = None;
    for set in sets {
        let all = residuals(set);
        assert_eq!(all.len(), 26);
        let curved: Vec<_> = all.iter().filter(|(name, _)| !name.starts_with("shear")).copied().collect();
        assert_eq!(first.get_or_insert_with(|| curved.clone()), &curved, "{}", set.name);
        let shared: Vec<_> = all.into_iter().filter(|(name, _)| !own(name)).collect();
        assert_eq!(shared, string, "{}", set.name);
    }
    assert!(first.is_some());
}
