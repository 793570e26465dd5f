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
    /// What the generated enums call it; empty for what no caller asks for.
    pub variant: String,
    /// Number of the equation that introduces it.
    pub source: &'static str,
}

/// One row of a table of symbols.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// Name in Rust, in tables and files.
    pub name: &'static str,
    /// As the thesis prints it.
    pub symbol: &'static str,
    /// SI unit, empty for a pure number.
    pub unit: &'static str,
    /// Exponent of the region's own unit.
    pub region: i8,
    /// What it is.
    pub doc: &'static str,
    /// What the generated enums call it; empty for what no caller asks for.
    pub variant: &'static str,
    /// Number of the equation that introduces it.
    pub source: &'static str,
}

/// A row from name, printed symbol, SI unit, exponent of the region's own unit, and meaning.
pub const fn row(name: &'static str, symbol: &'static str, unit: &'static str, region: i8, doc: &'static str) -> Row {
    Row { name, symbol, unit, region, doc, variant: "", source: "" }
}

impl Row {
    /// The same row, which callers of the kernels know as this variant of a generated enum; with the number of the
    /// equation that introduces it.
    #[must_use]
    pub const fn identity(self, variant: &'static str, source: &'static str) -> Self {
        Self { variant, source, ..self }
    }
}

/// Independent variables and states.
const STATES: &[Row] = &[
    row("s", "ŝ", "", 1, "position in the region, 0 at its entry and 1 at its exit; φ̂ = ŝ in a groove"),
    row("T", "T", "N", 0, "tractive tension F − G V").identity("Tension", "(3.6)"),
    row("theta", "θ", "rad", 0, "inclination of the belt against the pulley's circle; positive unseats")
        .identity("Inclination", "(3.2)"),
    row("theta1", "θ̂'", "rad", -1, "first derivative of θ along the region") // d/dŝ
        .identity("InclinationDerivative", "(5.2)"),
    row("theta2", "θ̂''", "rad", -2, "second derivative of θ along the region")
        .identity("InclinationSecondDerivative", "(5.3)"),
    row("x", "x", "m", 0, "radial penetration R − r").identity("Penetration", "(3.24)"),
    row("tau", "τ", "N", 0, "tractive tension in a span").identity("SpanTension", "(3.45)"),
    row("vartheta", "ϑ", "rad", 0, "direction of the belt in a span against the line of centres")
        .identity("Direction", "(3.43)"),
    row("vartheta1", "ϑ̂'", "rad", -1, "first derivative of ϑ along the span") // d/dŝ
        .identity("DirectionDerivative", "(5.10)"),
    row("vartheta2", "ϑ̂''", "rad", -2, "second derivative of ϑ along the span")
        .identity("DirectionSecondDerivative", "(5.11)"),
];

/// Constants as a single region knows them.
const LOCAL_CONSTANTS: &[Row] = &[
    row("Phi", "Φ", "rad", -1, "wrap angle").identity("WrapAngle", "(5.1)"),
    row("L", "L", "m", -1, "arc length of the span").identity("SpanLength", "(5.9)"),
    row("sigma", "σ", "", 0, "speed of the pulley over the primary's, ω/ω_P").identity("PulleySpeedRatio", "(3.12)"),
    row(
        "flow",
        "g",
        "",
        0,
        "mass flow over that of an unstretched belt at the primary's nominal speed, G/(m_o R_P ω_P)",
    )
    .identity("Flow", "(3.5)"),
    row("EA", "EA", "N", 0, "longitudinal stiffness").identity("LongitudinalStiffness", "(3.8)"),
    row("EI", "EI", "N m^2", 0, "bending stiffness").identity("BendingStiffness", "(3.26)"),
    row("k", "k", "N/m^2", 0, "radial stiffness: axial force per length and penetration, both sheaves together")
        .identity("RadialStiffness", "(3.16)"),
    row("m_o", "m_o", "kg/m", 0, "mass per length, unloaded").identity("MassPerLength", "(3.5)"),
    row("R", "R", "m", 0, "nominal radius of the pulley").identity("PulleyRadius", "(3.12)"),
    row("R_P", "R_P", "m", 0, "nominal radius of the primary").identity("PrimaryRadius", "Table 6.1"),
    row("beta", "β", "rad", 0, "half angle of the sheave's groove").identity("HalfAngle", "(3.7)"),
    row("mu_k", "μ_k", "", 0, "kinetic coefficient of friction").identity("FrictionCoefficient", "Fig. 3.6"),
    row("v_thr", "v_thr", "m/s", 0, "slip threshold of the friction law").identity("SlipThreshold", "Fig. 3.6"),
    row("omega_P", "ω_P", "rad/s", 0, "angular speed of the primary").identity("PrimarySpeed", "Table 6.1"),
];

/// Constants of the whole drive; the names above keep their meaning.
const GLOBAL_CONSTANTS: &[Row] = &[
    row("speed_ratio", "σ_S", "", 0, "speed of the secondary over the primary's, ω_S/ω_P")
        .identity("SpeedRatio", "(6.7)"),
    row("Phi_P", "Φ_P", "rad", -1, "wrap angle of the primary").identity("PrimaryWrap", "(5.17)"),
    row("Phi_S", "Φ_S", "rad", -1, "wrap angle of the secondary").identity("SecondaryWrap", "(5.19)"),
    row("C_P", "C_P", "rad", 0, "orientation of the primary: from the line of centres to the belt's entry")
        .identity("PrimaryOrientation", "(5.17)"),
    row("C_S", "C_S", "rad", 0, "orientation of the secondary: from the line of centres to the belt's exit")
        .identity("SecondaryOrientation", "(5.19)"),
    row("L_t", "L_t", "m", -1, "arc length of the tight span").identity("TightLength", "(5.27)"),
    row("L_s", "L_s", "m", -1, "arc length of the slack span").identity("SlackLength", "(5.29)"),
    row("R_S", "R_S", "m", 0, "nominal radius of the secondary").identity("SecondaryRadius", "Table 6.1"),
    row("L_c", "L_c", "m", 0, "distance between the pulleys' centres").identity("CenterDistance", "Table 6.1"),
    row("M_in", "M_in", "N m", 0, "torque that drives the primary").identity("PrimaryTorque", "5.3.5"),
    row("T_slack", "T_slack", "N", 0, "tractive tension where the belt leaves the primary")
        .identity("SlackTension", "5.3.5"),
];

/// Integrals along a region.
const INTEGRALS: &[Row] = &[
    row("M", "M", "N m", 0, "torque of friction on the belt").identity("Torque", "(5.54)"),
    row("A", "A", "N", 0, "axial force on one sheave").identity("AxialForce", "(5.58)"),
    row("L_o", "L_o", "m", 0, "unstretched length of the belt in the region").identity("UnstretchedLength", "(5.55)"),
    row("W", "W", "W", 0, "power lost to friction").identity("FrictionLoss", "power of friction"),
    row("E", "E", "W", 0, "power that changes of speed take from the energy stored in bending and squeezing")
        .identity("StrainEnergyFlux", "energy balance"),
    row("A_x", "A_x", "N m", 0, "first moment of the axial force along the direction of the entry")
        .identity("AxialMomentAlong", "(6.1)"),
    row("A_y", "A_y", "N m", 0, "first moment of the axial force across the direction of the entry")
        .identity("AxialMomentAcross", "(6.2)"),
    row("X", "X̂", "", 1, "progress along the line of centres over L").identity("PositionAlong", "(5.25)"),
    row("Y", "Ŷ", "", 1, "progress across the line of centres over L").identity("PositionAcross", "(5.26)"),
];

/// Jets: derivatives with respect to the wrap angle φ, and to the arc length.
const JETS: &[Row] = &[
    row("phi", "φ", "rad", 0, "wrap angle from the entry"),
    row("theta_1", "θ'", "rad", 0, "dθ/dφ"),
    row("theta_2", "θ''", "rad", 0, "d²θ/dφ²"),
    row("theta_3", "θ'''", "rad", 0, "d³θ/dφ³"),
    row("psi", "ψ", "rad", 0, "direction of the belt against a fixed one"),
    row("psi_s", "dψ/ds", "rad/m", 0, "curvature of the belt"),
    row("M_b_1", "M_b'", "N m", 0, "dM_b/dφ"),
    row("M_b_2", "M_b''", "N m", 0, "d²M_b/dφ²"),
    row("Q_1", "Q'", "N", 0, "dQ/dφ"),
    row("T_1", "T'", "N", 0, "dT/dφ"),
    row("x_1", "x'", "m", 0, "dx/dφ"),
    row("x_2", "x''", "m", 0, "d²x/dφ²"),
    row("vartheta_1", "ϑ'", "rad/m", 0, "dϑ/ds, the belt's curvature in a span"),
    row("vartheta_2", "ϑ''", "rad/m^2", 0, "d²ϑ/ds²"),
    row("vartheta_3", "ϑ'''", "rad/m^3", 0, "d³ϑ/ds³"),
    row("tau_1", "τ'", "N/m", 0, "dτ/ds"),
];

/// Everything computed on the way, derived fields included.
const QUANTITIES: &[Row] = &[
    row("v_0", "v_0", "m/s", 0, "guard speed that keeps |v| away from zero"),
    row("s_1", "ŝ_1", "", 1, "position of a region's entry"),
    row("s_2", "ŝ_2", "", 1, "position of a region's exit"),
    row("G", "G", "kg/s", 0, "mass flow of the belt"),
    row("omega", "ω", "rad/s", 0, "angular speed of the pulley"),
    row("r", "r", "m", 0, "radius of the belt"),
    row("arc", "s'", "m", 0, "arc length per wrap angle, ds/dφ"),
    row("F", "F", "N", 0, "belt tension").identity("BeltTension", "(3.10)"),
    row("V", "V", "m/s", 0, "belt speed").identity("BeltSpeed", "(3.11)"),
    row("v_r", "v_r", "m/s", 0, "radial sliding speed").identity("RadialSlidingSpeed", "(3.12)"),
    row("v_t", "v_t", "m/s", 0, "circumferential sliding speed").identity("TangentialSlidingSpeed", "(3.12)"),
    row("speed", "|v|", "m/s", 0, "sliding speed in the plane of the pulley").identity("SlidingSpeed", "(3.12)"),
    row("tan_theta", "tanθ", "", 0, "tangent of the inclination"),
    row("face_speed", "w", "m/s", 0, "sliding speed on the sheave's face, |v|/cosβ_s"),
    row("f_r", "f_r", "", 0, "friction over normal force, its part along the radius: μ cosβ_s cosγ"),
    row("f_t", "f_t", "", 0, "friction over normal force, its part around the pulley: μ cosβ_s sinγ"),
    row("q", "q", "N", 0, "normal force of both sheaves per wrap angle, times cosθ"),
    row("gamma", "γ", "rad", 0, "sliding angle from the outward radius, 0 to 2π").identity("SlidingAngle", "(3.13)"),
    row("gamma_a", "γ*", "rad", 0, "sliding angle, −π to π"),
    row("slip", "u", "", 0, "sliding speed over the slip threshold, |v|/v_thr"),
    row("saturation", "h", "", 0, "share of the kinetic friction that is reached, μ/μ_k"),
    row("mu", "μ", "", 0, "coefficient of friction").identity("FrictionAtPoint", "Fig. 3.6"),
    row("beta_s", "β_s", "rad", 0, "apparent sheave angle").identity("ApparentSheaveAngle", "(3.14)"),
    row("p", "p", "N/m", 0, "normal pressure of one sheave on the belt, per length").identity("Pressure", "(3.18)"),
    row("n", "n", "N", 0, "outward load on the belt per wrap angle"),
    row("t", "t", "N", 0, "load along the belt per wrap angle"),
    row("M_b", "M_b", "N m", 0, "bending moment").identity("BendingMoment", "(3.26)"),
    row("Q", "Q", "N", 0, "transverse shear force").identity("Shear", "(3.27)"),
    row("Q_theta3", "∂Q'/∂θ'''", "N", 0, "coefficient of θ''' in Q'"),
    row("theta_30", "θ'''_0", "rad", 0, "third derivative of θ at which the shear does not change"),
    row("stretch", "λ", "", 0, "stretched over unstretched length, 1 + F/EA"),
    row("axial", "dA/ds", "N/m", 0, "axial force on one sheave per length").identity("AxialForcePerLength", "(5.58)"),
    row("loss", "dW/ds", "W/m", 0, "power lost to friction per length").identity("LossPerLength", "power of friction"),
    row("loss_radial", "dW_r/ds", "W/m", 0, "the part of dW/ds lost to sliding up and down the sheave")
        .identity("RadialLossPerLength", "power of friction"),
    row("loss_tangential", "dW_t/ds", "W/m", 0, "the part of dW/ds lost to sliding around the pulley")
        .identity("TangentialLossPerLength", "power of friction"),
    row("loss_phi", "dW/dφ", "W/rad", 0, "power lost to friction per wrap angle")
        .identity("LossPerWrap", "power of friction"),
    row("T_hat_1", "T̂'", "N", -1, "derivative of T along the region"),
    row("theta_hat_3", "θ̂'''", "rad", -3, "third derivative of θ along the region"),
    row("theta_hat_1", "θ̂'", "rad", -1, "derivative of θ along the region"),
    row("vartheta_hat_1", "ϑ̂'", "rad", -1, "derivative of ϑ along the span"),
    row("x_hat_1", "x̂'", "m", -1, "derivative of x along the region"),
    row("M_hat_1", "M̂'", "N m", -1, "derivative of M along the region"),
    row("A_hat_1", "Â'", "N", -1, "derivative of A along the region"),
    row("L_o_hat_1", "L̂_o'", "m", -1, "derivative of L_o along the region"),
    row("W_hat_1", "Ŵ'", "W", -1, "derivative of W along the region"),
    row("E_hat_1", "Ê'", "W", -1, "derivative of E along the region"),
    row("V_T", "dV/dT", "s/kg", 0, "change of belt speed with tractive tension"),
    row("stored", "e", "N", 0, "energy per length of bending, less that of squeezing"),
    row("A_x_hat_1", "Â_x'", "N m", -1, "derivative of A_x along the region"),
    row("A_y_hat_1", "Â_y'", "N m", -1, "derivative of A_y along the region"),
    row("tau_hat_1", "τ̂'", "N", -1, "derivative of τ along the span"),
    row("vartheta_hat_3", "ϑ̂'''", "rad", -3, "third derivative of ϑ along the span"),
    row("X_hat_1", "X̂'", "", 0, "derivative of X along the span"),
    row("Y_hat_1", "Ŷ'", "", 0, "derivative of Y along the span"),
];

impl From<&Row> for Symbol {
    fn from(row: &Row) -> Self {
        let Row { name, symbol, unit, region, doc, variant, source } = *row;
        let dimension = Dimension::of_unit(unit).unwrap_or_else(|| unreachable!("unit of {name}")).per_region(region);
        Self {
            name: name.into(),
            symbol: symbol.into(),
            unit,
            dimension,
            doc: doc.into(),
            variant: variant.into(),
            source,
        }
    }
}

/// `wrap_angle` or `primary.wrap_angle` as the name of a variant: `WrapAngle`, `PrimaryWrapAngle`.
pub fn camel_case(name: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    name.split(['_', '.']).map(word).collect()
}

/// The whole table, in its order.
pub fn all() -> Vec<Symbol> {
    rows().map(Symbol::from).collect()
}

/// The symbol of that name.
pub fn find(name: &str) -> Option<Symbol> {
    rows().find(|row| row.name == name).map(Symbol::from)
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
    for row in rows() {
        let _ = parse!(row.name);
    }
}
