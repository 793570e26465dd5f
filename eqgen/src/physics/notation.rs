//! The notation: every symbol with its name, its unit and what it means. No expression may use any other.

use symbolica::parse;

use crate::dimension::{Dimension, Dimensions};

/// One symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Symbol {
    /// Name in Rust, in tables and files.
    pub name: String,
    /// As the thesis prints it.
    pub symbol: String,
    /// SI unit, empty for a pure number.
    pub unit: &'static str,
    /// Dimension, the region's own unit included.
    pub dimension: Dimension,
    /// What it is.
    pub doc: String,
}

/// (name, symbol, unit, exponent of the region, meaning)
pub type Row = (&'static str, &'static str, &'static str, i8, &'static str);

/// Independent variables and states.
const STATES: &[Row] = &[
    ("s", "ŝ", "", 1, "position in the region, 0 at its entry and 1 at its exit; φ̂ = ŝ in a groove"),
    ("T", "T", "N", 0, "tractive tension F − G V"),
    ("theta", "θ", "rad", 0, "inclination of the belt against the pulley's circle; positive unseats"),
    ("theta1", "θ̂'", "rad", -1, "first derivative of θ along the region"),
    ("theta2", "θ̂''", "rad", -2, "second derivative of θ along the region"),
    ("x", "x", "m", 0, "radial penetration R − r"),
    ("tau", "τ", "N", 0, "tractive tension in a span"),
    ("vartheta", "ϑ", "rad", 0, "direction of the belt in a span against the line of centres"),
    ("vartheta1", "ϑ̂'", "rad", -1, "first derivative of ϑ along the span"),
    ("vartheta2", "ϑ̂''", "rad", -2, "second derivative of ϑ along the span"),
];

/// Constants as a single region knows them.
const LOCAL_CONSTANTS: &[Row] = &[
    ("Phi", "Φ", "rad", -1, "wrap angle"),
    ("L", "L", "m", -1, "arc length of the span"),
    ("sigma", "σ", "", 0, "speed of the pulley over the primary's, ω/ω_P"),
    ("flow", "g", "", 0, "mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P)"),
    ("EA", "EA", "N", 0, "longitudinal stiffness"),
    ("EI", "EI", "N m^2", 0, "bending stiffness"),
    ("k", "k", "N/m^2", 0, "radial stiffness: axial force per length and penetration, both sheaves together"),
    ("m_o", "m_o", "kg/m", 0, "mass per length, unloaded"),
    ("R", "R", "m", 0, "nominal radius of the pulley"),
    ("R_P", "R_P", "m", 0, "nominal radius of the primary"),
    ("beta", "β", "rad", 0, "half angle of the sheave's groove"),
    ("mu_k", "μ_k", "", 0, "kinetic coefficient of friction"),
    ("v_thr", "v_thr", "m/s", 0, "slip threshold of the friction law"),
    ("omega_P", "ω_P", "rad/s", 0, "angular speed of the primary"),
];

/// Constants of the whole drive; the names above keep their meaning.
const GLOBAL_CONSTANTS: &[Row] = &[
    ("speed_ratio", "σ_S", "", 0, "speed of the secondary over the primary's, ω_S/ω_P"),
    ("Phi_P", "Φ_P", "rad", -1, "wrap angle of the primary"),
    ("Phi_S", "Φ_S", "rad", -1, "wrap angle of the secondary"),
    ("C_P", "C_P", "rad", 0, "orientation of the primary: from the line of centres to the belt's entry"),
    ("C_S", "C_S", "rad", 0, "orientation of the secondary: from the line of centres to the belt's exit"),
    ("L_t", "L_t", "m", -1, "arc length of the tight span"),
    ("L_s", "L_s", "m", -1, "arc length of the slack span"),
    ("R_S", "R_S", "m", 0, "nominal radius of the secondary"),
    ("L_c", "L_c", "m", 0, "distance between the pulleys' centres"),
    ("M_in", "M_in", "N m", 0, "torque that drives the primary"),
    ("T_slack", "T_slack", "N", 0, "tractive tension where the belt leaves the primary"),
];

/// Integrals along a region.
const INTEGRALS: &[Row] = &[
    ("M", "M", "N m", 0, "torque of friction on the belt"),
    ("A", "A", "N", 0, "axial force on one sheave"),
    ("L_o", "L_o", "m", 0, "unstretched length of the belt in the region"),
    ("W", "W", "W", 0, "power lost to friction"),
    ("E", "E", "W", 0, "power that changes of speed take from the energy stored in bending and squeezing"),
    ("A_x", "A_x", "N m", 0, "first moment of the axial force along the direction of the entry"),
    ("A_y", "A_y", "N m", 0, "first moment of the axial force across the direction of the entry"),
    ("X", "X̂", "", 1, "progress along the line of centres over L"),
    ("Y", "Ŷ", "", 1, "progress across the line of centres over L"),
];

/// Jets: derivatives with respect to the wrap angle φ, and to the arc length.
const JETS: &[Row] = &[
    ("phi", "φ", "rad", 0, "wrap angle from the entry"),
    ("theta_1", "θ'", "rad", 0, "dθ/dφ"),
    ("theta_2", "θ''", "rad", 0, "d²θ/dφ²"),
    ("theta_3", "θ'''", "rad", 0, "d³θ/dφ³"),
    ("psi", "ψ", "rad", 0, "direction of the belt against a fixed one"),
    ("psi_s", "dψ/ds", "rad/m", 0, "curvature of the belt"),
    ("M_b_1", "M_b'", "N m", 0, "dM_b/dφ"),
    ("M_b_2", "M_b''", "N m", 0, "d²M_b/dφ²"),
    ("Q_1", "Q'", "N", 0, "dQ/dφ"),
    ("T_1", "T'", "N", 0, "dT/dφ"),
    ("x_1", "x'", "m", 0, "dx/dφ"),
    ("x_2", "x''", "m", 0, "d²x/dφ²"),
    ("vartheta_1", "ϑ'", "rad/m", 0, "dϑ/ds, the belt's curvature in a span"),
    ("vartheta_2", "ϑ''", "rad/m^2", 0, "d²ϑ/ds²"),
    ("vartheta_3", "ϑ'''", "rad/m^3", 0, "d³ϑ/ds³"),
    ("tau_1", "τ'", "N/m", 0, "dτ/ds"),
];

/// Everything computed on the way, derived fields included.
const QUANTITIES: &[Row] = &[
    ("v_0", "v_0", "m/s", 0, "guard speed that keeps |v| away from zero"),
    ("s_1", "ŝ_1", "", 1, "position of a region's entry"),
    ("s_2", "ŝ_2", "", 1, "position of a region's exit"),
    ("G", "G", "kg/s", 0, "mass flow of the belt"),
    ("omega", "ω", "rad/s", 0, "angular speed of the pulley"),
    ("r", "r", "m", 0, "radius of the belt"),
    ("arc", "s'", "m", 0, "arc length per wrap angle, ds/dφ"),
    ("F", "F", "N", 0, "belt tension"),
    ("V", "V", "m/s", 0, "belt speed"),
    ("v_r", "v_r", "m/s", 0, "radial sliding speed"),
    ("v_t", "v_t", "m/s", 0, "circumferential sliding speed"),
    ("speed", "|v|", "m/s", 0, "sliding speed in the plane of the pulley"),
    ("tan_theta", "tanθ", "", 0, "tangent of the inclination"),
    ("face_speed", "w", "m/s", 0, "sliding speed on the sheave's face, |v|/cosβ_s"),
    ("f_r", "f_r", "", 0, "friction over normal force, its part along the radius: μ cosβ_s cosγ"),
    ("f_t", "f_t", "", 0, "friction over normal force, its part around the pulley: μ cosβ_s sinγ"),
    ("q", "q", "N", 0, "normal force of both sheaves per wrap angle, times cosθ"),
    ("gamma", "γ", "rad", 0, "sliding angle from the outward radius, 0 to 2π"),
    ("gamma_a", "γ*", "rad", 0, "sliding angle, −π to π"),
    ("slip", "u", "", 0, "sliding speed over the slip threshold, |v|/v_thr"),
    ("saturation", "h", "", 0, "share of the kinetic friction that is reached, μ/μ_k"),
    ("mu", "μ", "", 0, "coefficient of friction"),
    ("beta_s", "β_s", "rad", 0, "apparent sheave angle"),
    ("p", "p", "N/m", 0, "normal pressure of one sheave on the belt, per length"),
    ("n", "n", "N", 0, "outward load on the belt per wrap angle"),
    ("t", "t", "N", 0, "load along the belt per wrap angle"),
    ("M_b", "M_b", "N m", 0, "bending moment"),
    ("Q", "Q", "N", 0, "transverse shear force"),
    ("Q_theta3", "∂Q'/∂θ'''", "N", 0, "coefficient of θ''' in Q'"),
    ("theta_30", "θ'''_0", "rad", 0, "third derivative of θ at which the shear does not change"),
    ("stretch", "λ", "", 0, "stretched over unstretched length, 1 + F/EA"),
    ("axial", "dA/ds", "N/m", 0, "axial force on one sheave per length"),
    ("loss", "dW/ds", "W/m", 0, "power lost to friction per length"),
    ("loss_radial", "dW_r/ds", "W/m", 0, "the part of dW/ds lost to sliding up and down the sheave"),
    ("loss_tangential", "dW_t/ds", "W/m", 0, "the part of dW/ds lost to sliding around the pulley"),
    ("loss_phi", "dW/dφ", "W/rad", 0, "power lost to friction per wrap angle"),
    ("T_hat_1", "T̂'", "N", -1, "derivative of T along the region"),
    ("theta_hat_3", "θ̂'''", "rad", -3, "third derivative of θ along the region"),
    ("theta_hat_1", "θ̂'", "rad", -1, "derivative of θ along the region"),
    ("vartheta_hat_1", "ϑ̂'", "rad", -1, "derivative of ϑ along the span"),
    ("x_hat_1", "x̂'", "m", -1, "derivative of x along the region"),
    ("M_hat_1", "M̂'", "N m", -1, "derivative of M along the region"),
    ("A_hat_1", "Â'", "N", -1, "derivative of A along the region"),
    ("L_o_hat_1", "L̂_o'", "m", -1, "derivative of L_o along the region"),
    ("W_hat_1", "Ŵ'", "W", -1, "derivative of W along the region"),
    ("E_hat_1", "Ê'", "W", -1, "derivative of E along the region"),
    ("V_T", "dV/dT", "s/kg", 0, "change of belt speed with tractive tension"),
    ("stored", "e", "N", 0, "energy per length of bending, less that of squeezing"),
    ("A_x_hat_1", "Â_x'", "N m", -1, "derivative of A_x along the region"),
    ("A_y_hat_1", "Â_y'", "N m", -1, "derivative of A_y along the region"),
    ("tau_hat_1", "τ̂'", "N", -1, "derivative of τ along the span"),
    ("vartheta_hat_3", "ϑ̂'''", "rad", -3, "third derivative of ϑ along the span"),
    ("X_hat_1", "X̂'", "", 0, "derivative of X along the span"),
    ("Y_hat_1", "Ŷ'", "", 0, "derivative of Y along the span"),
];

impl From<&Row> for Symbol {
    fn from(&(name, symbol, unit, region, doc): &Row) -> Self {
        let dimension = Dimension::of_unit(unit).unwrap_or_else(|| unreachable!("unit of {name}")).per_region(region);
        Self { name: name.into(), symbol: symbol.into(), unit, dimension, doc: doc.into() }
    }
}

/// The whole table, in its order.
pub fn all() -> Vec<Symbol> {
    rows().map(Symbol::from).collect()
}

/// The symbol of that name.
pub fn find(name: &str) -> Option<Symbol> {
    rows().find(|row| row.0 == name).map(Symbol::from)
}

/// Dimensions of all symbols of the table.
pub fn dimensions() -> Dimensions {
    all().into_iter().map(|symbol| (symbol.name, symbol.dimension)).collect()
}

fn rows() -> impl Iterator<Item = &'static Row> {
    [STATES, LOCAL_CONSTANTS, GLOBAL_CONSTANTS, INTEGRALS, JETS, QUANTITIES].into_iter().flatten()
}

/// Makes the symbols known to Symbolica in the table's order, which fixes the order of terms and so the emitted text.
pub(crate) fn register() {
    for (name, ..) in rows() {
        let _ = parse!(name);
    }
}
