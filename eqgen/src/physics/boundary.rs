//! How the regions meet, and the operating point: 26 equations.
//!
//! The belt runs through primary contact P, slack span s, secondary contact S and tight span t; both pulleys turn
//! counter-clockwise, the primary's centre is the origin and the secondary's (L_c, 0). 1 is an entry, 2 an exit.

use symbolica::atom::{Atom, AtomCore};

use super::beam::{Bending, Shear};
use super::kinematics::SLOPE;
use super::model::{BeltTheory, BoundaryModel, Role};
use super::{contact, notation, span, string};
use crate::derive::substitute;
use crate::dimension::{Dimension, Dimensions};
use crate::error::Error;
use crate::plan::{Plan, read};

/// What holds for the shear where the belt enters and leaves a groove.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// Q = 0 on the pulley's side.
    Zero,
    /// Q is the same on both sides.
    Continuous,
    /// Zero as Appendix D prints it: without Φ, and with the entry's x' at the primary's exit.
    AsPrinted,
}

/// Constants of the drive, in order; the first eight are the default unknowns.
pub const CONSTANTS: [&str; 21] = [
    "speed_ratio",
    "flow",
    "Phi_P",
    "Phi_S",
    "C_P",
    "C_S",
    "L_t",
    "L_s",
    "EA",
    "EI",
    "k",
    "m_o",
    "R_P",
    "R_S",
    "L_c",
    "beta",
    "mu_k",
    "v_thr",
    "omega_P",
    "M_in",
    "T_slack",
];

/// States of a region of a belt.
fn states(belt: BeltTheory, is_contact: bool) -> &'static [&'static str] {
    match (belt, is_contact) {
        (BeltTheory::Beam, true) => &contact::STATES,
        (BeltTheory::Beam, false) => &span::STATES,
        (BeltTheory::String, true) => &string::CONTACT_STATES,
        (BeltTheory::String, false) => &string::SPAN_STATES,
    }
}

/// Regions in the order of the belt's travel: suffix, name, and whether it is a contact.
const REGIONS: [(&str, &str, bool); 4] =
    [("P", "primary", true), ("s", "slack span", false), ("S", "secondary", true), ("t", "tight span", false)];

/// Where a contact region ends and a span begins, or the other way round.
struct Interface {
    /// Suffix of the contact's symbols.
    contact: &'static str,
    /// Suffix of the span's symbols.
    span: &'static str,
    /// Which pulley.
    pulley: &'static str,
    /// Which span.
    length: &'static str,
    /// Belt direction in the span, (5.21) to (5.24) with (5.35) to (5.38), its signs corrected.
    direction: &'static str,
    /// Position, (5.17) to (5.20).
    position: [&'static str; 2],
    /// Numbers of: penetration, tension, direction, curvature, shear.
    numbers: [&'static str; 5],
}

const INTERFACES: [Interface; 4] = [
    Interface {
        contact: "P1",
        span: "t2",
        pulley: "P",
        length: "t",
        direction: "C_P + pi/2 - theta_P1",
        position: ["R_P*cos(C_P)", "R_P*sin(C_P)"],
        numbers: ["(5.51)", "(5.47)", "(5.21), (5.35)", "(5.39)", "(5.43)"],
    },
    Interface {
        contact: "P2",
        span: "s1",
        pulley: "P",
        length: "s",
        direction: "C_P + Phi_P*s_2 - 3*pi/2 - theta_P2",
        position: ["R_P*cos(C_P + Phi_P*s_2)", "R_P*sin(C_P + Phi_P*s_2)"],
        numbers: ["(5.51)", "(5.48)", "(5.22), (5.36)", "(5.40)", "(5.44)"],
    },
    Interface {
        contact: "S1",
        span: "s2",
        pulley: "S",
        length: "s",
        direction: "3*pi/2 - C_S - Phi_S*s_2 - theta_S1",
        position: ["L_c - R_S*cos(C_S + Phi_S*s_2)", "R_S*sin(C_S + Phi_S*s_2)"],
        numbers: ["(5.51)", "(5.49)", "(5.23), (5.37)", "(5.41)", "(5.45)"],
    },
    Interface {
        contact: "S2",
        span: "t1",
        pulley: "S",
        length: "t",
        direction: "3*pi/2 - C_S - theta_S2",
        position: ["L_c - R_S*cos(C_S)", "R_S*sin(C_S)"],
        numbers: ["(5.51)", "(5.50)", "(5.24), (5.38)", "(5.42)", "(5.46)"],
    },
];

impl Interface {
    /// An expression of the contact region in this end's symbols.
    fn at_contact(&self, expression: &Atom) -> Result<Atom, Error> {
        let (end, wrap) = (self.contact, format!("Phi_{}", self.pulley));
        let symbol = |text: String| read("end", &text);
        let radius = format!("(R_{} - x_{end})", self.pulley);
        let replacements = [
            ("tan_theta", symbol(format!("sin(theta_{end})/cos(theta_{end})"))?),
            ("arc", symbol(format!("{radius}/cos(theta_{end})"))?),
            ("theta", symbol(format!("theta_{end}"))?),
            ("theta_1", symbol(format!("theta1_{end}/{wrap}"))?),
            ("theta_2", symbol(format!("theta2_{end}/{wrap}^2"))?),
            ("x", symbol(format!("x_{end}"))?),
            ("R", symbol(format!("R_{}", self.pulley))?),
        ];
        Ok(substitute(expression, &replacements))
    }

    /// An expression of the span in this end's symbols.
    fn at_span(&self, expression: &Atom) -> Result<Atom, Error> {
        let (end, length) = (self.span, format!("L_{}", self.length));
        let symbol = |text: String| read("end", &text);
        let replacements = [
            ("vartheta_1", symbol(format!("vartheta1_{end}/{length}"))?),
            ("vartheta_2", symbol(format!("vartheta2_{end}/{length}^2"))?),
        ];
        Ok(substitute(expression, &replacements))
    }

    fn radius(&self) -> Result<Atom, Error> {
        read("radius", &format!("R_{}", self.pulley))
    }
}

/// The boundary equations with that shear at the ends.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn model(ends: Ends, shear: Shear) -> Result<BoundaryModel, Error> {
    let mut set = Equations::new(BeltTheory::Beam)?;
    for end in &INTERFACES {
        set.penetration(end)?;
    }
    for end in &INTERFACES {
        set.tension(end)?;
    }
    for end in &INTERFACES {
        set.direction(end)?;
    }
    let bending = Bending::derive()?;
    for end in &INTERFACES {
        set.curvature(end, &bending)?;
    }
    let (force, _) = bending.on_path(shear)?;
    for end in &INTERFACES {
        match ends {
            Ends::Zero => set.zero_shear(end, &force)?,
            Ends::Continuous => set.continuous_shear(end, &force)?,
            Ends::AsPrinted => set.printed_shear(end)?,
        }
    }
    let [p1, p2, s1, s2] = &INTERFACES;
    set.closure("s", p2, s1, "(5.29) to (5.32)")?;
    set.closure("t", s2, p1, "(5.27), (5.28), (5.33), (5.34)")?;
    set.operating_point()?;
    let name = match ends {
        Ends::Zero => format!("boundary_zero_{}", shear.name()),
        Ends::Continuous => format!("boundary_continuous_{}", shear.name()),
        Ends::AsPrinted => "boundary_as_printed".into(),
    };
    let what = match ends {
        Ends::Zero => "no shear where the belt meets a pulley",
        Ends::Continuous => "shear continuous where the belt meets a pulley",
        Ends::AsPrinted => "conditions as Appendix D prints them",
    };
    Ok(set.finish(name, format!("Boundary equations: {what}, {} shear.", shear.name())))
}

/// The boundary equations of a belt without bending stiffness: 18, nothing said of curvature and shear.
///
/// # Errors
/// If an equation is inconsistent; the message names it.
pub fn string_model() -> Result<BoundaryModel, Error> {
    let mut set = Equations::new(BeltTheory::String)?;
    for end in &INTERFACES {
        set.penetration(end)?;
    }
    for end in &INTERFACES {
        set.tension(end)?;
    }
    for end in &INTERFACES {
        set.direction(end)?;
    }
    let [p1, p2, s1, s2] = &INTERFACES;
    set.closure("s", p2, s1, "(5.29) to (5.32)")?;
    set.closure("t", s2, p1, "(5.27), (5.28), (5.33), (5.34)")?;
    set.operating_point()?;
    Ok(set.finish("boundary_string".into(), "Boundary equations of a belt without bending stiffness.".into()))
}

struct Equations {
    plan: Plan,
    ends: Vec<notation::Symbol>,
    integrals: Vec<notation::Symbol>,
    equations: Vec<notation::Symbol>,
}

impl Equations {
    fn new(belt: BeltTheory) -> Result<Self, Error> {
        let (ends, integrals) = (end_symbols(belt), integral_symbols());
        let own = ends.iter().chain(&integrals).map(|symbol| (symbol.name.clone(), symbol.dimension));
        let extra: Dimensions = own.chain(equation_dimensions()).collect();
        let symbols = ends.iter().chain(&integrals).map(|symbol| symbol.name.clone());
        let inputs = symbols.chain(CONSTANTS.iter().map(|&name| name.into())).collect();
        let mut plan = Plan::new(inputs, extra)?;
        plan.number("s_2", 1.0, "a region ends where its variable is 1")?;
        for constant in ["R_P", "R_S", "Phi_P", "Phi_S", "L_t", "L_s", "EI"] {
            plan.nonzero(constant, "a length, angle or stiffness")?;
        }
        for end in &INTERFACES {
            plan.nonzero(&format!("R_{} - x_{}", end.pulley, end.contact), "x stays far below R")?;
            plan.nonzero(&format!("cos(theta_{})", end.contact), "|θ| < 90°")?;
        }
        Ok(Self { plan, ends, integrals, equations: Vec::new() })
    }

    fn finish(self, name: String, doc: String) -> BoundaryModel {
        let constants = CONSTANTS.iter().filter_map(|name| notation::find(name)).collect();
        let Self { plan, ends, integrals, equations } = self;
        BoundaryModel { name, doc, plan, ends, integrals, constants, equations, role: Role::Conditions }
    }

    /// Adds a condition that follows from other relations.
    fn add(&mut self, name: String, value: Atom, doc: String, source: &'static str) -> Result<(), Error> {
        self.plan.derived(&name, value, source)?;
        self.list(name, doc, source);
        Ok(())
    }

    /// Adds a condition that is typed in.
    fn typed(&mut self, name: String, value: Atom, doc: String, source: &'static str) -> Result<(), Error> {
        self.plan.typed(&name, value, source)?;
        self.list(name, doc, source);
        Ok(())
    }

    /// Adds a step of the plan to the list of equations.
    fn list(&mut self, name: String, doc: String, source: &'static str) {
        let (dimension, unit) = residual(&name);
        let (symbol, variant) = (String::new(), String::new());
        self.equations.push(notation::Symbol { name, symbol, unit, dimension, doc, variant, source });
    }

    fn penetration(&mut self, end: &Interface) -> Result<(), Error> {
        let at = end.contact;
        let value = read(at, &format!("x_{at}/R_{}", end.pulley))?;
        self.typed(format!("penetration_{at}"), value, format!("x_{at} = 0, over R"), end.numbers[0])
    }

    fn tension(&mut self, end: &Interface) -> Result<(), Error> {
        let (at, span) = (end.contact, end.span);
        let value = read(at, &format!("T_{at} - tau_{span}"))?;
        self.typed(format!("tension_{at}"), value, format!("T_{at} = τ_{span}"), end.numbers[1])
    }

    fn direction(&mut self, end: &Interface) -> Result<(), Error> {
        let (at, span) = (end.contact, end.span);
        let value = read(at, &format!("{} - vartheta_{span}", end.direction))?;
        self.typed(
            format!("direction_{at}"),
            value,
            format!("the belt's direction at {at} is ϑ_{span}"),
            end.numbers[2],
        )
    }

    fn curvature(&mut self, end: &Interface, bending: &Bending) -> Result<(), Error> {
        let (at, span) = (end.contact, end.span);
        let in_span = end.at_span(&read(at, "vartheta_1")?)?;
        let value = end.radius()? * (end.at_contact(&bending.curvature)? - in_span);
        let doc = format!("the belt's curvature at {at} is that at {span}, times R");
        self.add(format!("curvature_{at}"), value, doc, end.numbers[3])
    }

    /// Q R²/EI, which is of the order of θ''.
    fn scaled(end: &Interface, force: Atom) -> Result<Atom, Error> {
        Ok(end.radius()?.pow(2) * (force / read("EI", "EI")?).factor())
    }

    fn zero_shear(&mut self, end: &Interface, force: &Atom) -> Result<(), Error> {
        let at = end.contact;
        let value = Self::scaled(end, end.at_contact(force)?)?;
        self.add(format!("shear_{at}"), value, format!("Q_{at} = 0, times R²/EI"), end.numbers[4])
    }

    fn continuous_shear(&mut self, end: &Interface, force: &Atom) -> Result<(), Error> {
        let (at, span) = (end.contact, end.span);
        let in_span = Self::scaled(end, end.at_span(&read(at, span::SHEAR)?)?)?;
        let value = Self::scaled(end, end.at_contact(force)?)? - in_span;
        let doc = format!("Q_{at} is that of the span at {span}, times R²/EI");
        self.add(format!("shear_{at}"), value, doc, "(3.33), (3.43)")
    }

    /// −θ̂'' + x̂'/R with x̂' = Φ x'; at the primary's exit the entry's x̂' stands in.
    fn printed_shear(&mut self, end: &Interface) -> Result<(), Error> {
        let [entry, ..] = &INTERFACES;
        let (at, taken) = (end.contact, if end.contact == "P2" { entry } else { end });
        let slope = taken.at_contact(&read(at, SLOPE)?)? * read(at, &format!("Phi_{}", taken.pulley))?;
        let value = slope / end.radius()? - read(at, &format!("theta2_{at}"))?;
        let source = "(D) bc(23) to bc(26)";
        self.plan.as_printed(&format!("shear_{at}"), value, source)?;
        let doc = format!("−θ̂''_{at} + x̂'_{}/R = 0", taken.contact);
        self.list(format!("shear_{at}"), doc, source);
        Ok(())
    }

    /// The span leads from one pulley's rim to the other's.
    fn closure(&mut self, span: &str, from: &Interface, to: &Interface, source: &'static str) -> Result<(), Error> {
        for (index, axis) in ["X", "Y"].into_iter().enumerate() {
            let text = format!("{} - ({}) - L_{span}*{axis}_{span}", to.position[index], from.position[index]);
            let value = read(axis, &text)? / from.radius()?;
            let doc = format!("the {axis} span {span} covers leads from {} to {}, over R", from.contact, to.contact);
            self.typed(format!("closure_{axis}_{span}"), value, doc, source)?;
        }
        Ok(())
    }

    fn operating_point(&mut self) -> Result<(), Error> {
        let torque = read("torque", "M_P + M_in")?;
        self.typed("torque".into(), torque, "M_P = −M_in: friction on the belt drives it backwards".into(), "5.3.5")?;
        let slack = read("slack", "T_P2 - T_slack")?;
        self.typed("slack_tension".into(), slack, "T_P2 = T_slack".into(), "5.3.5")
    }
}

pub(super) fn end_symbols(belt: BeltTheory) -> Vec<notation::Symbol> {
    let mut all = Vec::new();
    for (region, title, is_contact) in REGIONS {
        let states = states(belt, is_contact);
        for (end, place) in [("1", "entry"), ("2", "exit")] {
            let here = states.iter().filter_map(|name| notation::find(name));
            all.extend(
                here.map(|symbol| suffixed(symbol, &format!("{region}{end}"), &format!("{place} of the {title}"))),
            );
        }
    }
    all
}

pub(super) fn integral_symbols() -> Vec<notation::Symbol> {
    let mut all = Vec::new();
    for (region, title, is_contact) in REGIONS {
        let integrals: &[&str] = if is_contact { &contact::INTEGRALS } else { &span::INTEGRALS };
        let here = integrals.iter().filter_map(|name| notation::find(name));
        all.extend(here.map(|symbol| suffixed(symbol, region, &format!("the whole {title}"))));
    }
    all
}

fn suffixed(symbol: notation::Symbol, suffix: &str, place: &str) -> notation::Symbol {
    notation::Symbol {
        name: format!("{}_{suffix}", symbol.name),
        symbol: format!("{}_{suffix}", symbol.symbol),
        doc: format!("{}: {place}", symbol.doc),
        ..symbol
    }
}

/// Dimensions of the residuals.
fn equation_dimensions() -> Vec<(String, Dimension)> {
    let interface = ["penetration", "tension", "direction", "curvature", "shear"];
    let at_ends = INTERFACES.iter().flat_map(|end| interface.map(|name| format!("{name}_{}", end.contact)));
    let closures = ["closure_X_s", "closure_Y_s", "closure_X_t", "closure_Y_t"].map(str::to_owned);
    let point = ["torque", "slack_tension"].map(str::to_owned);
    let names = at_ends.chain(closures).chain(point);
    names.map(|name| (residual(&name).0, name)).map(|(dimension, name)| (name, dimension)).collect()
}

/// Dimension and SI unit of a residual: forces and the torque have one, all others are pure numbers.
fn residual(name: &str) -> (Dimension, &'static str) {
    let unit = match name {
        "torque" => "N m",
        _ if name.contains("tension") => "N",
        _ => "",
    };
    (Dimension::of_unit(unit).unwrap_or_else(|| unreachable!("unit of {name}")), unit)
}
