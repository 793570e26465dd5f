//! The thesis's own code, Appendices C and D, transcribed by hand and compared with the kernels of `published`.
#![allow(non_snake_case, clippy::unwrap_used, clippy::panic)]

mod common;

use std::f64::consts::PI;

use common::{Random, Slip, at, point};
use generated::{BOUNDARY_AS_PRINTED, CONTACT_LINEARISED_VISCOUS_COULOMB, RegionKernel, SPAN_AS_PRINTED};

const TOLERANCE: f64 = 1e-12;

fn constant(kernel: &RegionKernel, constants: &[f64], name: &str) -> f64 {
    constants[kernel.constants.iter().position(|constant| constant.name() == name).unwrap()]
}

fn close(found: f64, printed: f64, size: f64, what: &str) {
    let error = (found - printed).abs();
    assert!(
        error <= TOLERANCE * size.max(printed.abs()),
        "{what}: {found} and {printed}, off by {error:e} of {size:e}"
    );
}

/// `rhs_bend_lin_vec.m`, primary contact: T, θ, θ̂', θ̂'', x, x̂' and the integrals M, A, L_o; then the size of the
/// largest term in T and θ̂''.
struct Contact {
    rates: [f64; 6],
    integrands: [f64; 3],
    sizes: [f64; 2],
}

fn appendix_c_contact(z: [f64; 6], w: f64, G: f64, psi: f64, c: impl Fn(&str) -> f64) -> Contact {
    let [T, theta, d_theta, d2_theta, x, d_x] = z;
    let (EA, EI, k, m_o, R) = (c("EA"), c("EI"), c("k"), c("m_o"), c("R"));
    let (mu_nom, beta, slip_threshold) = (c("mu_k"), c("beta"), c("v_thr"));
    let (cos_theta, sin_theta, tan_theta) = (theta.cos(), theta.sin(), theta.tan());
    let sec_theta = 1.0 / cos_theta;
    // Algebraic relations for sheave forces
    let F = (T + G.powi(2) / m_o) / (1.0 - G.powi(2) / (EA * m_o));
    let V = (T + EA) * G / (EA * m_o - G.powi(2));
    let mag_V_s = ((V * sin_theta).powi(2) + (V * cos_theta - (R - x) * w).powi(2)).sqrt();
    let slope = mu_nom / slip_threshold;
    let mu = if mag_V_s > slip_threshold { mu_nom } else { slope * mag_V_s };
    let Numerator = cos_theta - (m_o * w / G) * (R - x) / (1.0 + F / EA);
    let Denominator = sin_theta;
    let mag = (Numerator.powi(2) + Denominator.powi(2)).sqrt();
    let cos_gamma = Denominator / mag;
    let sin_gamma = Numerator / mag;
    let tan_beta_s = beta.tan() * cos_gamma;
    let cos_beta_s = 1.0 / (1.0 + tan_beta_s.powi(2)).sqrt();
    let sin_beta_s = tan_beta_s * cos_beta_s;
    let p = k * x / (2.0 * (beta.cos() + mu * sin_beta_s));
    // Linearized bending stiffness terms
    let d2_x = psi * (-R * d_theta * sec_theta.powi(2) + d_x * tan_theta + x * d_theta * sec_theta.powi(2));
    let Q = -EI / (R.powi(2) * psi.powi(2)) * d2_theta + EI / (R.powi(3) * psi) * d_x;
    let psi_d_Q = EI / (R.powi(3) * psi.powi(2)) * d2_x;
    let d3_theta_coeff = (-EI * (R + 2.0 * x)) / (R.powi(3) * psi.powi(3) * T);
    let load = (2.0 * p / T) * (beta.sin() - mu * cos_beta_s * (cos_gamma - sin_gamma * tan_theta)) * (R - x);
    let d3_theta = (1.0 - load - psi_d_Q / T - d_theta / psi) / d3_theta_coeff;
    // ODE system
    let along =
        psi * 2.0 * p * (-beta.sin() * tan_theta + mu * cos_beta_s * (tan_theta * cos_gamma + sin_gamma)) * (R - x);
    let torque = (2.0 * mu * p * cos_beta_s * sin_gamma * (R - x).powi(2)) * psi / cos_theta;
    let axial = k * x / 2.0 * (psi * (R - x) / cos_theta);
    let unstretched = psi * (R - x) / cos_theta * 1.0 / (1.0 + F / EA);
    Contact {
        rates: [along - psi * Q + Q * d_theta, d_theta, d2_theta, d3_theta, d_x, d2_x],
        integrands: [torque, axial, unstretched],
        sizes: [along.abs() + (psi * Q).abs(), (1.0 + load.abs()) / d3_theta_coeff.abs()],
    }
}

#[test]
fn contact_is_appendix_c() {
    let kernel = &CONTACT_LINEARISED_VISCOUS_COULOMB;
    let mut random = Random::new(21);
    for sample in 0..1000 {
        let slip = if sample % 2 == 0 { Slip::Below } else { Slip::Beyond };
        let point = point(kernel, &mut random, slip);
        let c = |name: &str| constant(kernel, &point.constants, name);
        let (psi, w) = (c("Phi"), c("sigma") * c("omega_P"));
        let G = c("flow") * c("m_o") * c("R_P") * c("omega_P");
        let [T, theta, d_theta, d2_theta, x] = point.y[..] else { panic!("five states") };
        // x' is a state there, held to this by (5.52).
        let d_x = psi * (-(c("R") - x) * theta.tan());
        let printed = appendix_c_contact([T, theta, d_theta, d2_theta, x, d_x], w, G, psi, c);
        let found = at(kernel, kernel.value, &point).f;
        let [dT, dtheta, dtheta1, dtheta2, dx, _] = printed.rates;
        close(found[0], dT, printed.sizes[0], "T");
        close(found[1], dtheta, 0.0, "theta");
        close(found[2], dtheta1, 0.0, "theta1");
        close(found[3], dtheta2, printed.sizes[1], "theta2");
        close(found[4], dx, 0.0, "x");
        for (row, printed) in printed.integrands.into_iter().enumerate() {
            close(found[5 + row], printed, 0.0, kernel.integrals[row].name());
        }
    }
}

#[test]
fn span_is_appendix_c() {
    let kernel = &SPAN_AS_PRINTED;
    let mut random = Random::new(22);
    for _ in 0..1000 {
        let point = point(kernel, &mut random, Slip::Below);
        let c = |name: &str| constant(kernel, &point.constants, name);
        let (L, EI, EA, m_o) = (c("L"), c("EI"), c("EA"), c("m_o"));
        let G = c("flow") * m_o * c("R_P") * c("omega_P");
        let [T, theta, d_theta, d2_theta] = point.y[..] else { panic!("four states") };
        let F = (T + G.powi(2) / m_o) / (1.0 - G.powi(2) / (EA * m_o));
        let printed = [
            -L.powi(2) * EI * d_theta * d2_theta,
            d_theta,
            d2_theta,
            T / (L.powi(2) * EI) * d_theta,
            theta.cos(),
            theta.sin(),
            L / (1.0 + F / EA),
        ];
        let found = at(kernel, kernel.value, &point).f;
        printed.into_iter().zip(found).for_each(|(printed, found)| close(found, printed, 0.1, "span"));
    }
}

/// z(·) of the thesis at one end of all regions, as far as `bc_bend_lin.m` uses it; indices are its own.
struct Stack([f64; 41]);

impl Stack {
    fn at(&self, index: usize) -> f64 {
        self.0[index]
    }
}

/// `bc_bend_lin.m`, the conditions that are equations here, by the names they have here.
fn appendix_d(za: &Stack, zb: &Stack, R_P: f64, R_S: f64, L: f64, T_slack: f64, M_P: f64) -> Vec<(&'static str, f64)> {
    let (a, b) = (|i| za.at(i), |i| zb.at(i));
    let E_St = PI / 2.0 - a(19) - b(2);
    let E_Ss = -3.0 * PI / 2.0 + (3.0 * PI - (a(19) + a(9))) - a(2);
    let E_Pt = a(20) - PI / 2.0 - a(11);
    let E_Ps = a(20) + a(18) - 3.0 * PI / 2.0 - b(11);
    let (x_St, y_St) = (L - R_S * a(19).cos(), R_S * a(19).sin());
    let (x_Ss, y_Ss) = (L - R_S * (a(19) + a(9)).cos(), R_S * (a(19) + a(9)).sin());
    let (x_Pt, y_Pt) = (R_P * a(20).cos(), R_P * a(20).sin());
    let (x_Ps, y_Ps) = (R_P * (a(20) + a(18)).cos(), R_P * (a(20) + a(18)).sin());
    vec![
        ("penetration_S1", a(5)),
        ("penetration_S2", b(5)),
        ("torque", b(17) - M_P),
        ("slack_tension", b(10) - T_slack),
        ("penetration_P1", a(14)),
        ("penetration_P2", b(14)),
        ("tension_S1", a(1) - b(28)),
        ("tension_S2", b(1) - a(21)),
        ("tension_P1", a(10) - b(21)),
        ("tension_P2", b(10) - a(28)),
        ("direction_S1", E_Ss - b(29)),
        ("direction_S2", E_St + PI - a(22)),
        ("direction_P1", E_Pt + PI - b(22)),
        ("direction_P2", E_Ps - a(29)),
        ("curvature_S1", (a(2).cos() / (R_S - a(5)) * (1.0 - 1.0 / a(9) * a(3))) - b(30) / a(34)),
        ("curvature_S2", (b(2).cos() / (R_S - b(5)) * (1.0 - 1.0 / a(9) * b(3))) - a(23) / a(27)),
        ("curvature_P1", (a(11).cos() / (R_P - a(14)) * (1.0 - 1.0 / a(18) * a(12))) - b(23) / a(27)),
        ("curvature_P2", (b(11).cos() / (R_P - b(14)) * (1.0 - 1.0 / a(18) * b(12))) - a(30) / a(34)),
        ("shear_S1", -a(4) + a(6) / R_S),
        ("shear_S2", -b(4) + b(6) / R_S),
        ("shear_P1", -a(13) + a(15) / R_P),
        ("shear_P2", -b(13) + a(15) / R_P),
        // Positions at the start of a span are those of its X̂, Ŷ there; the end's follow from the integral.
        ("closure_X_t", (x_Pt - b(25) * a(27)) - (x_St - a(25) * a(27))),
        ("closure_Y_t", (y_Pt - b(26) * a(27)) - (y_St - a(26) * a(27))),
        ("closure_X_s", (x_Ss - b(32) * a(34)) - (x_Ps - a(32) * a(34))),
        ("closure_Y_s", (y_Ss - b(33) * a(34)) - (y_Ps - a(33) * a(34))),
    ]
}

/// What an equation here has been multiplied with.
fn scale(name: &str, R_P: f64, R_S: f64) -> f64 {
    let (kind, place) = name.split_once('_').unwrap_or((name, ""));
    let radius = if place.starts_with('P') { R_P } else { R_S };
    match kind {
        "penetration" => 1.0 / radius,
        "curvature" => radius,
        "closure" if name.ends_with("_s") => 1.0 / R_P,
        "closure" => 1.0 / R_S,
        _ => 1.0,
    }
}

#[test]
fn boundary_is_appendix_d() {
    let kernel = &BOUNDARY_AS_PRINTED;
    let mut random = Random::new(23);
    for _ in 0..1000 {
        let mut draw = |name: &str| match name {
            _ if name.starts_with("x_") => random.between(-1e-3, 1e-3),
            _ if name.starts_with("R_") => random.between(0.05, 0.1),
            _ if name.starts_with("Phi") => random.between(2.0, 4.0),
            _ if name.starts_with("theta_") => random.between(-0.2, 0.2),
            _ => random.between(0.1, 0.9),
        };
        let ends: Vec<f64> = kernel.ends.iter().map(|symbol| draw(symbol.name)).collect();
        let integrals: Vec<f64> = kernel.integrals.iter().map(|symbol| draw(symbol.name)).collect();
        let constants: Vec<f64> = kernel.constants.iter().map(|symbol| draw(symbol.name)).collect();
        let named: std::collections::BTreeMap<&str, f64> = kernel
            .ends
            .iter()
            .chain(kernel.integrals)
            .chain(kernel.constants)
            .map(|symbol| symbol.name)
            .zip(ends.iter().chain(&integrals).chain(&constants).copied())
            .collect();
        let n = |name: String| named.get(name.as_str()).copied().unwrap_or_else(|| panic!("{name}"));
        let stack = |end: &str| {
            let slope = |pulley: &str| {
                let at = format!("{pulley}{end}");
                let radius = n(format!("R_{pulley}")) - n(format!("x_{at}"));
                -n(format!("Phi_{pulley}")) * radius * n(format!("theta_{at}")).tan()
            };
            let mut z = [f64::NAN; 41];
            for (first, at) in [(1, format!("S{end}")), (10, format!("P{end}"))] {
                for (offset, state) in ["T", "theta", "theta1", "theta2", "x"].into_iter().enumerate() {
                    z[first + offset] = n(format!("{state}_{at}"));
                }
            }
            (z[6], z[15]) = (slope("S"), slope("P"));
            (z[9], z[18]) = (n("Phi_S".into()), n("Phi_P".into()));
            (z[19], z[20]) = (n("C_S".into()), n("C_P".into()));
            for (first, span) in [(21, "t"), (28, "s")] {
                for (offset, state) in ["tau", "vartheta", "vartheta1", "vartheta2"].into_iter().enumerate() {
                    z[first + offset] = n(format!("{state}_{span}{end}"));
                }
                z[first + 6] = n(format!("L_{span}"));
                let ending = if end == "1" { 0.0 } else { 1.0 };
                z[first + 4] = ending * n(format!("X_{span}"));
                z[first + 5] = ending * n(format!("Y_{span}"));
            }
            z[17] = n("M_P".into());
            Stack(z)
        };
        let (R_P, R_S) = (n("R_P".into()), n("R_S".into()));
        // There the primary's torque on the belt is what is prescribed; it is −M_in.
        let printed =
            appendix_d(&stack("1"), &stack("2"), R_P, R_S, n("L_c".into()), n("T_slack".into()), -n("M_in".into()));
        assert_eq!(printed.len(), kernel.equations.len());
        let mut g = vec![f64::NAN; kernel.equations.len()];
        (kernel.value)(&ends, &integrals, &constants, &mut g);
        for (name, printed) in printed {
            let row =
                kernel.equations.iter().position(|equation| equation.name == name).unwrap_or_else(|| panic!("{name}"));
            close(g[row], scale(name, R_P, R_S) * printed, 10.0, name);
        }
    }
}
