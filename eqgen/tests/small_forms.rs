//! What eqgen derives for the small models against what their sources print: the difference has to vanish symbolically,
//! and must not where a source is wrong. Plain numbers are those of Z. Wang, *Belt Velocity Initialization* (2012).
#![allow(clippy::unwrap_used, clippy::panic)]

use eqgen::derive::{quadratic_in, substitute};
use eqgen::physics::small::{drive, pulley, sizing};
use eqgen::plan::{Definition, Plan, read};
use eqgen::{Error, symbolic};
use symbolica::atom::{Atom, AtomCore};
use symbolica::symbol;

/// The value of a step, with the plan's own steps put in wherever `inline` names them.
fn value(plan: &Plan, name: &str, inline: &[&str]) -> Atom {
    let of = |name: &str| match plan.step(name).map(|step| step.definition.clone()) {
        Some(Definition::Expression(value)) => value,
        other => panic!("{name}: {other:?}"),
    };
    inline.iter().fold(of(name), |value, name| substitute(&value, &[(name, of(name))]))
}

fn difference(derived: &Atom, printed: &str) -> Atom {
    (derived - read("printed", printed).unwrap()).factor()
}

fn assert_printed(derived: &Atom, printed: &str, number: &str) {
    let difference = difference(derived, printed);
    assert!(difference.is_zero(), "{number}: derived {derived}, printed {printed}, difference {difference}");
}

const FORCES: [&str; 3] = ["K", "L_Oin", "L_Iin"];

#[test]
fn belt_forces_are_those_of_sections_1_and_2() {
    symbolic(|| {
        let plan = drive::residuals().unwrap().plan;
        assert_printed(&value(&plan, "K", &[]), "EA*m_star*v_0^2/(EA - m_star*v_0^2)", "K");
        assert_printed(&value(&plan, "L_Iin", &[]), "EA*r_I*omega_I/v_0 - EA", "(7)");
        let excess = |force: &str| (value(&plan, force, &[]) - value(&plan, "K", &[])) / read("", "EA").unwrap();
        assert_printed(&excess("L_Oin"), "r_O*omega_O/v_0 - EA/(EA - m_star*v_0^2)", "(4)");
        // (24): the left side is L_I, and EA multiplies both terms.
        let ea = read("", "EA").unwrap();
        let excess = excess("L_Iin") * ea;
        assert_printed(&excess, "(r_I*omega_I/v_0 - EA/(EA - m_star*v_0^2))*EA", "(24) corrected");
        assert!(!difference(&excess, "r_I*omega_I/v_0 - EA/(EA - m_star*v_0^2)*EA").is_zero(), "(24) as printed");
    })
    .unwrap();
}

#[test]
fn residuals_are_2_5_13_18() {
    symbolic(|| {
        let plan = drive::residuals().unwrap().plan;
        assert_printed(&value(&plan, "speed_O", &[]), "r_I*omega_I - v_0*M_O/(EA*r_O) - r_O*omega_O", "(2)");
        assert_printed(&value(&plan, "speed_I", &[]), "r_I*omega_I + v_0*M_I/(EA*r_I) - r_O*omega_O", "(18)");
        assert_printed(&value(&plan, "ratio_O", &[]), "M_O/(r_O*(L_Oin - K)) + 1", "(2.221)");
        assert_printed(&value(&plan, "ratio_I", &[]), "M_I/(r_I*(L_Iin - K)) + 1", "(16)");
        assert_printed(&value(&plan, "Phi_I", &[]), "-log_I/mu_star", "(16)");
        let twice = |name: &str| value(&plan, name, &FORCES) * read("", "2*tan_delta").unwrap();
        assert_printed(
            &twice("axial_O"),
            "2*F_CO*tan_delta - (EA - m_star*v_0^2)*(2*phi_O*(r_O*omega_O/v_0 - 1) + M_O/(mu_star*r_O*EA) \
             - (r_O*omega_O/v_0 - EA/(EA - m_star*v_0^2))*Phi_O) + 2*m_star*v_0^2*phi_O",
            "(5)",
        );
        assert_printed(
            &twice("axial_I"),
            "2*F_CI*tan_delta - (EA - m_star*v_0^2)*(2*(pi - phi_O)*(r_I*omega_I/v_0 - 1) - M_I/(mu_star*r_I*EA) \
             - (r_I*omega_I/v_0 - EA/(EA - m_star*v_0^2))*Phi_I) + 2*m_star*v_0^2*(pi - phi_O)",
            "(13)",
        );
    })
    .unwrap();
}

/// The integral of L over the sliding arc in (12): its derivative is L at the arc's end, it vanishes with the arc, and
/// it is what the derivation has in its place.
#[test]
fn sliding_arc_is_that_of_12() {
    symbolic(|| {
        let read = |text: &str| read("(12)", text).unwrap();
        let integral = read("(L_Iin - K)*(exp(-mu_star*Phi_I) - 1)/(-mu_star) + K*Phi_I");
        let end = read("(L_Iin - K)*exp(-mu_star*Phi_I) + K");
        let slope = integral.derivative(symbol!("eqgen::Phi_I"));
        let open = (slope - &end).factor();
        assert!(open.is_zero(), "not its integral: {open}");
        let start = substitute(&integral, &[("Phi_I", Atom::num(0))]).factor();
        assert!(start.is_zero(), "not from zero: {start}");
        let derived = (end - read("L_Iin")) / read("-mu_star") + read("K*Phi_I");
        let open = (derived - integral).factor();
        assert!(open.is_zero(), "not (L_out − L_in)/(−μ*) + K Φ: {open}");
    })
    .unwrap();
}

#[test]
fn closed_forms_are_6_to_26() {
    symbolic(|| {
        let plan = drive::closed().unwrap().plan;
        let of = |name: &str| value(&plan, name, &[]);
        for (name, printed, number) in [
            ("a_O", "u*phi_O*m_star", "(6)"),
            ("b_O", "F_CO*tan_delta + EA*phi_O", "(6)"),
            ("c_O", "-EA*u*phi_O", "(6)"),
            ("a_I", "u*(pi - phi_O)*m_star", "(14)"),
            ("b_I", "F_CI*tan_delta + EA*(pi - phi_O)", "(14)"),
            ("c_I", "-EA*u*(pi - phi_O)", "(14)"),
            ("M_O_of_M_I", "-M_I*r_O/r_I", "(11)"),
            ("M_I_of_M_O", "-M_O*r_I/r_O", "(20)"),
            ("M_O_of_speeds", "(r_I*omega_I - r_O*omega_O)*r_O*EA/v_0", "(17)"),
            ("M_I_of_speeds", "-(r_I*omega_I - r_O*omega_O)*r_I*EA/v_0", "(19)"),
            ("omega_I_of_M_O", "(v_0*M_O/(EA*r_O) + r_O*omega_O)/r_I", "(2)"),
            ("omega_O_of_M_O", "r_I*omega_I/r_O - v_0*M_O/(r_O^2*EA)", "(21) corrected"),
        ] {
            assert_printed(&of(name), printed, number);
        }
        assert!(
            !difference(&of("omega_O_of_M_O"), "r_I*omega_I/r_O - v_0*M_O/(r_I*r_O*EA)").is_zero(),
            "(21) as printed"
        );
        let ratio = |name| value(&plan, name, &FORCES);
        let (above, below) =
            ("(r_I*omega_I*(EA - m_star*v_0^2) - EA*v_0)", "(r_O*omega_O*(EA - m_star*v_0^2) - EA*v_0)");
        assert_printed(&ratio("ratio_O"), &format!("{above}/{below}"), "(22)");
        assert_printed(&ratio("ratio_I"), &format!("{below}/{above}"), "(25)");
        let twice = |name: &str, inline: &[&str]| value(&plan, name, inline) * read("", "2*tan_delta").unwrap();
        let inline = |torque: &'static str, angle: &'static str| [torque, angle, "K", "L_Oin", "L_Iin"];
        assert_printed(
            &twice("F_CO_of_speeds", &inline("M_O_of_speeds", "Phi_O")),
            "(EA - m_star*v_0^2)*(2*phi_O*(r_O*omega_O/v_0 - 1) + (r_I*omega_I - r_O*omega_O)/(mu_star*v_0) \
             - (r_O*omega_O/v_0 - EA/(EA - m_star*v_0^2))*log_O/mu_star) - 2*m_star*v_0^2*phi_O",
            "(23)",
        );
        assert_printed(
            &twice("F_CI_of_speeds", &inline("M_I_of_speeds", "Phi_I")),
            "(EA - m_star*v_0^2)*(2*(pi - phi_O)*(r_I*omega_I/v_0 - 1) - (r_O*omega_O - r_I*omega_I)/(mu_star*v_0) \
             + (r_I*omega_I/v_0 - EA/(EA - m_star*v_0^2))*log_I/mu_star) - 2*m_star*v_0^2*(pi - phi_O)",
            "(26)",
        );
    })
    .unwrap();
}

/// At no torque F_CO tan δ_0 = φ (1 − m* v_0²/EA) (L − K): the force vanishes with L − K, not with L.
#[test]
fn condition_of_1_3_is_on_l_less_k() {
    symbolic(|| {
        let plan = drive::residuals().unwrap().plan;
        let unloaded = [("M_O", Atom::num(0)), ("Phi_O", Atom::num(0)), ("F_CO", Atom::num(0))];
        let force = substitute(&value(&plan, "axial_O", &[]), &unloaded) * read("", "-tan_delta").unwrap();
        assert_printed(&force, "phi_O*(1 - m_star*v_0^2/EA)*(L_Oin - K)", "1.3");
    })
    .unwrap();
}

#[test]
fn moment_of_the_pulley_is_a_difference() {
    symbolic(|| {
        let plan = pulley::model().unwrap().plan;
        let torque = value(&plan, "torque", &[]);
        assert_printed(&torque, "T_S - (F_B - F_A)*R + omega*b + J*alpha", "T_S");
        // Power in is power out, losses and acceleration.
        let of = |name| value(&plan, name, &["V_rel"]);
        let out = value(&plan, "shaft_power", &[]) + of("bearing_loss") + of("kinetic_power");
        let balance = value(&plan, "belt_power", &[]) - out - of("friction_loss");
        assert!(balance.expand().is_zero(), "{balance}");
        // The printed torque (F_A + F_B) R tanh(·) tanh(·) − ω b leaves it open whatever the hyperbolic tangents are.
        let printed = read("T_S", "((F_A + F_B)*R*h - omega*b)*omega").unwrap();
        let open = value(&plan, "belt_power", &[]) - printed - of("bearing_loss") - of("friction_loss");
        assert!(!open.expand().is_zero());
    })
    .unwrap();
}

#[test]
fn sizing_is_3_21_to_3_27() {
    symbolic(|| {
        let plan = sizing::model().unwrap().plan;
        let of = |name: &str| value(&plan, name, &[]);
        for (name, printed, number) in [
            ("ratio", "D_out/D_in", "(3.25)"),
            ("load_inertia", "(M_belt + M_load)*D_in^2/4", "(3.22)"),
            ("external_torque", "D_in*F/2", "(3.23)"),
            ("friction_torque", "D_in*F_f/2", "(3.24)"),
            ("input_torque", "T_out/(D_out/D_in)", "(3.26)"),
            ("rotating_inertia", "I_p1 + I_idlers + (I_RL + I_p2)/(D_out/D_in)^2", "(3.27)"),
        ] {
            assert_printed(&of(name), printed, number);
        }
        // (3.21) adds up inertias as they are, which energy allows where all pulleys are of one size.
        let same = substitute(&of("rotating_inertia"), &[("D_out", read("", "D_in").unwrap())]);
        assert_printed(&same.factor(), "I_p1 + I_idlers + I_RL + I_p2", "(3.21)");
        assert!(!difference(&of("rotating_inertia"), "I_p1 + I_idlers + I_RL + I_p2").is_zero(), "(3.21) as printed");
        let idler = sizing::idler().unwrap().plan;
        assert_printed(&value(&idler, "reflected_inertia", &[]), "I_idler*(D_in/D)^2", "idler");
    })
    .unwrap();
}

#[test]
fn what_is_not_quadratic_is_refused() {
    symbolic(|| {
        let of = |text: &str| quadratic_in(&read("", text).unwrap(), "v_0");
        assert!(matches!(of("m_star*v_0^3 + v_0^2"), Err(Error::NotQuadratic { .. })));
        assert!(matches!(of("m_star*v_0 + EA"), Err(Error::NotQuadratic { .. })));
        let parts = of("3*v_0^2 - EA*v_0 + 5").unwrap();
        assert_printed(&parts.square, "3", "square");
        assert_printed(&parts.linear, "-EA", "linear");
        assert_printed(&parts.constant, "5", "constant");
    })
    .unwrap();
}
