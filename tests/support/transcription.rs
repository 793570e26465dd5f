//! The belt equations written out by hand, for numbers of any kind: what the generated kernels are compared with.
//!
//! Contacts follow the thesis's Appendix C and D for linearised shear; the full shear is written from (3.32)–(3.36)
//! by hand. Nothing here comes of the symbolic derivation.

use solver::model::Scalar as Number;

/// Which equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// Q and Q' in full, or linearised.
    pub full_shear: bool,
    /// Shear continuous at the ends, or zero.
    pub continuous: bool,
    /// Spans and conditions as printed.
    pub printed: bool,
    /// μ = μ_k tanh(4 |v|/v_thr).
    pub tanh: bool,
}

/// The constants in the drive's order: unknown ones first.
#[derive(Debug, Clone, Copy)]
pub struct Constants<S> {
    pub speed_ratio: S,
    pub flow: S,
    pub phi_p: S,
    pub phi_s: S,
    pub c_p: S,
    pub c_s: S,
    pub l_t: S,
    pub l_s: S,
    pub ea: S,
    pub ei: S,
    pub k: S,
    pub m_o: S,
    pub r_p: S,
    pub r_s: S,
    pub l_c: S,
    pub beta: S,
    pub mu_k: S,
    pub v_thr: S,
    pub omega_p: S,
    pub m_in: S,
    pub t_slack: S,
}

impl<S: Number> Constants<S> {
    /// Reads the drive's vector of constants.
    pub fn new(c: &[S]) -> Self {
        let [speed_ratio, flow, phi_p, phi_s, c_p, c_s, l_t, l_s, ea, ei, k, m_o, r_p, r_s, l_c, beta, mu_k, v_thr,
            omega_p, m_in, t_slack] =
            c.try_into().unwrap();
        Self {
            speed_ratio, flow, phi_p, phi_s, c_p, c_s, l_t, l_s, ea, ei, k, m_o, r_p, r_s, l_c, beta, mu_k, v_thr,
                omega_p, m_in, t_slack,
        }
    }

    /// Mass flow G, kg/s.
    pub fn mass_flow(&self) -> S {
        self.flow * self.m_o * self.r_p * self.omega_p
    }
}

/// A contact: five derivatives with respect to φ̂, then the integrands M, A, L_o, W, A_x, A_y, E.
pub fn contact<S: Number>(choice: Choice, primary: bool, s: f64, y: &[S], c: &Constants<S>) -> [S; 12] {
    let one = S::from(1.0);
    let (r_n, phi, w) =
        if primary { (c.r_p, c.phi_p, c.omega_p) } else { (c.r_s, c.phi_s, c.omega_p * c.speed_ratio) };
    let (t, th, d1, d2, x) = (y[0], y[1], y[2] / phi, y[3] / (phi * phi), y[4]);
    let g = c.mass_flow();
    let (st, ct) = (th.sin(), th.cos());
    let tan = st / ct;
    let r = r_n - x;
    let f = (t + g * g / c.m_o) / (one - g * g / (c.ea * c.m_o));
    let v = (t + c.ea) * g / (c.ea * c.m_o - g * g);
    let (vr, vt) = (v * st, v * ct - r * w);
    let speed = (vr * vr + vt * vt + 1e-24).sqrt();
    let mu = if choice.tanh {
        c.mu_k * (speed * 4.0 / c.v_thr).tanh()
    } else if speed.re() > c.v_thr.re() {
        c.mu_k
    } else {
        c.mu_k * speed / c.v_thr
    };
    let (cg, sg) = (vr / speed, vt / speed);
    let (sb, cb, tb) = (c.beta.sin(), c.beta.cos(), c.beta.tan() * cg);
    let cbs = one / (one + tb * tb).sqrt();
    let p = c.k * x / ((cb + mu * tb * cbs) * 2.0);
    let n = p * 2.0 * (sb - mu * cbs * (cg - sg * tan)) * r;
    let tang = p * 2.0 * (-sb * tan + mu * cbs * (tan * cg + sg)) * r;
    let x1 = -r * tan;
    let x2 = x1 * tan - r * d1 / (ct * ct);
    let (q, d3) = if choice.full_shear { full_shear(c.ei, r, n, t, [st, ct, d1, d2], [x1,
        x2]) } else { linearised_shear(c.ei, r_n, x, n, t, [d1, d2], [x1, x2]) };
    let t1 = tang - q * (one - d1);
    let a1 = c.k * x / 2.0 * r / ct;
    let angle = phi * s;
    let curvature = (one - d1) * ct / r;
    let stored = (c.ei * curvature * curvature - c.k * c.beta.tan() * x * x) / 2.0;
    let v_t = g / (c.ea * c.m_o - g * g);
    [
        t1 * phi,
        y[2],
        y[3],
        d3 * phi.powi(3),
        x1 * phi,
        mu * p * 2.0 * cbs * sg * r * r / ct * phi,
        a1 * phi,
        r / ct / (one + f / c.ea) * phi,
        mu * p * 2.0 * speed / cbs * r / ct * phi,
        a1 * phi * r * angle.cos(),
        a1 * phi * r * angle.sin(),
        stored * v_t * t1 * phi,
    ]
}

/// Q (3.38), and θ''' of T (1 − θ') = n + Q' with Q' from (3.40).
fn linearised_shear<S: Number>(ei: S, r: S, x: S, n: S, t: S, [d1, d2]: [S; 2], [x1, x2]: [S; 2]) -> (S, S) {
    let r3 = r * r * r;
    let q = ei / r3 * (x1 - r * d2);
    let d3 = (n + ei / r3 * x2 - t * (S::from(1.0) - d1)) * r3 / (ei * (r + x * 2.0));
    (q, d3)
}

/// Q (3.33), (3.34), and θ''' of T (1 − θ') = n + Q' with Q' from (3.35), (3.36).
fn full_shear<S: Number>(ei: S, r: S, n: S, t: S, [st, ct, d1, d2]: [S; 4], [x1, x2]: [S; 2]) -> (S, S) {
    let one = S::from(1.0);
    let m1 = ei * ct * x1 * (one - d1) / (r * r) - ei * ct * d2 / r - ei * st * d1 * (one - d1) / r;
    // (3.36) but for its term in θ'''.
    let m2 = ei * ct * x1 * x1 * (one - d1) * 2.0 / (r * r * r) - ei * ct * d1 * d1 * (one - d1) / r
        + ei * ct * x2 * (one - d1) / (r * r)
        - ei * ct * x1 * d2 * 2.0 / (r * r)
        - ei * st * x1 * d1 * (one - d1) * 2.0 / (r * r)
        - ei * st * d2 / r
        + ei * st * d1 * d2 * 3.0 / r;
    let q = ct / r * m1;
    let q1_rest = (-st * d1 * r + ct * x1) / (r * r) * m1 + ct / r * m2;
    // Q' = q1_rest − (EI cos²θ/r²) θ'''.
    let d3 = (n + q1_rest - t * (one - d1)) * r * r / (ei * ct * ct);
    (q, d3)
}

/// A span: four derivatives with respect to ŝ, then the integrands X̂, Ŷ, L_o, E.
pub fn span<S: Number>(choice: Choice, tight: bool, y: &[S], c: &Constants<S>) -> [S; 8] {
    let one = S::from(1.0);
    let l = if tight { c.l_t } else { c.l_s };
    let g = c.mass_flow();
    let f = (y[0] + g * g / c.m_o) / (one - g * g / (c.ea * c.m_o));
    let (t1, d3) = if choice.printed {
        (-l * l * c.ei * y[2] * y[3], y[0] * y[2] / (l * l * c.ei))
    } else {
        (-c.ei / (l * l) * y[2] * y[3], l * l / c.ei * y[0] * y[2])
    };
    let stored = c.ei * (y[2] / l).powi(2) / 2.0;
    let e1 = stored * g / (c.ea * c.m_o - g * g) * t1;
    [t1, y[2], y[3], d3, y[1].cos(), y[1].sin(), l / (one + f / c.ea), e1]
}

/// The 26 boundary equations. `ends`: region by region (primary, slack span, secondary, tight span), entry then exit;
/// integrals likewise.
pub fn boundary<S: Number>(choice: Choice, ends: &[S], integrals: &[S], c: &Constants<S>) -> Vec<S> {
    let pi = std::f64::consts::PI;
    let one = S::from(1.0);
    let (p1, p2, s1, s2) = (&ends[0..5], &ends[5..10], &ends[18..23], &ends[23..28]);
    let (slack1, slack2, tight1, tight2) = (&ends[10..14], &ends[14..18], &ends[28..32], &ends[32..36]);
    let curvature = |y: &[S], r: S, phi: S| y[1].cos() / (r - y[4]) * (one - y[2] / phi);
    let mut g = vec![p1[4] / c.r_p, p2[4] / c.r_p, s1[4] / c.r_s, s2[4] / c.r_s];
    for (contact, span) in [(p1, tight2), (p2, slack1), (s1, slack2), (s2, tight1)] {
        g.push(contact[0] - span[0]);
    }
    g.push(c.c_p + pi / 2.0 - p1[1] - tight2[1]);
    g.push(c.c_p + c.phi_p - 1.5 * pi - p2[1] - slack1[1]);
    g.push(-c.c_s - c.phi_s + 1.5 * pi - s1[1] - slack2[1]);
    g.push(-c.c_s + 1.5 * pi - s2[1] - tight1[1]);
    g.push(curvature(p1, c.r_p, c.phi_p) - tight2[2] / c.l_t);
    g.push(curvature(p2, c.r_p, c.phi_p) - slack1[2] / c.l_s);
    g.push(curvature(s1, c.r_s, c.phi_s) - slack2[2] / c.l_s);
    g.push(curvature(s2, c.r_s, c.phi_s) - tight1[2] / c.l_t);
    if choice.printed {
        // x̂' of the entry stands in the condition at the primary's exit too.
        let x1 = |y: &[S], r: S, phi: S| -phi * (r - y[4]) * y[1].tan();
        g.push(-p1[3] + x1(p1, c.r_p, c.phi_p) / c.r_p);
        g.push(-p2[3] + x1(p1, c.r_p, c.phi_p) / c.r_p);
        g.push(-s1[3] + x1(s1, c.r_s, c.phi_s) / c.r_s);
        g.push(-s2[3] + x1(s2, c.r_s, c.phi_s) / c.r_s);
    } else {
        let ends = [(p1, tight2, c.r_p, c.phi_p, c.l_t), (p2, slack1, c.r_p, c.phi_p, c.l_s), (s1, slack2, c.r_s,
            c.phi_s, c.l_s), (s2, tight1, c.r_s, c.phi_s, c.l_t)];
        for (contact, span, r, phi, l) in ends {
            let q = shear(choice, contact, r, phi, c.ei);
            g.push(if choice.continuous { q - c.ei * span[3] / (l * l) } else { q });
        }
    }
    let primary = |a: S| [c.r_p * a.cos(), c.r_p * a.sin()];
    let secondary = |a: S| [c.l_c - c.r_s * a.cos(), c.r_s * a.sin()];
    let (slack_from, slack_to) = (primary(c.c_p + c.phi_p), secondary(c.c_s + c.phi_s));
    let (tight_from, tight_to) = (secondary(c.c_s), primary(c.c_p));
    for i in 0..2 {
        g.push(slack_to[i] - slack_from[i] - c.l_s * integrals[7 + i]);
        g.push(tight_to[i] - tight_from[i] - c.l_t * integrals[18 + i]);
    }
    g.push(integrals[0] + c.m_in);
    g.push(p2[0] - c.t_slack);
    g
}

fn shear<S: Number>(choice: Choice, y: &[S], r_n: S, phi: S, ei: S) -> S {
    let (th, d1, d2, r) = (y[1], y[2] / phi, y[3] / (phi * phi), r_n - y[4]);
    let x1 = -r * th.tan();
    if choice.full_shear {
        full_shear(ei, r, r, r, [th.sin(), th.cos(), d1, d2], [x1, x1]).0
    } else {
        linearised_shear(ei, r_n, y[4], r, r, [d1, d2], [x1, x1]).0
    }
}
