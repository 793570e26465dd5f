//! What eqgen derives against what the thesis prints: the difference has to vanish symbolically.
#![allow(clippy::unwrap_used, clippy::panic)]

use eqgen::Error;
use eqgen::derive::{linearise, on_path, substitute};
use eqgen::physics::beam::{Bending, SMALL, Shear};
use eqgen::physics::kinematics::{self, SLOPE};
use eqgen::physics::{contact, span};
use eqgen::plan::{Definition, read};
use eqgen::symbolic;
use symbolica::atom::{Atom, AtomCore};

/// `derived − printed`, brought over one denominator.
fn assert_printed(derived: &Atom, printed: &str, number: &str) {
    let printed = read(number, printed).unwrap();
    let difference = (derived - &printed).factor();
    assert!(difference.is_zero(), "{number}: derived {derived}, printed {printed}, difference {difference}");
}

const M_1: &str = "EI*cos(theta)*x_1/(R-x)^2 - EI*cos(theta)*x_1*theta_1/(R-x)^2 - EI*cos(theta)*theta_2/(R-x) \
    - EI*sin(theta)*theta_1/(R-x) + EI*sin(theta)*theta_1^2/(R-x)";

const M_2: &str = "2*EI*cos(theta)*x_1^2/(R-x)^3 - 2*EI*cos(theta)*x_1^2*theta_1/(R-x)^3 \
    - EI*cos(theta)*theta_1^2/(R-x) + EI*cos(theta)*theta_1^3/(R-x) \
    + EI*cos(theta)*x_2/(R-x)^2 - EI*cos(theta)*theta_1*x_2/(R-x)^2 - 2*EI*cos(theta)*x_1*theta_2/(R-x)^2 \
    - EI*cos(theta)*theta_3/(R-x) \
    - 2*EI*sin(theta)*x_1*theta_1/(R-x)^2 + 2*EI*sin(theta)*x_1*theta_1^2/(R-x)^2 - EI*sin(theta)*theta_2/(R-x) \
    + 3*EI*sin(theta)*theta_1*theta_2/(R-x)";

#[test]
fn bending_is_3_32_to_3_36() {
    symbolic(|| {
        let bending = Bending::derive().unwrap();
        assert_printed(&bending.moment, "cos(theta)/(R-x)*EI*(1-theta_1)", "(3.32)");
        assert_printed(&bending.moment_1, M_1, "(3.34)");
        assert_printed(&bending.moment_2, M_2, "(3.36)");
        assert_printed(&bending.shear, &format!("cos(theta)/(R-x)*({M_1})"), "(3.33)");
        let shear_1 =
            format!("(-sin(theta)*theta_1*(R-x) + cos(theta)*x_1)/(R-x)^2*({M_1}) + cos(theta)/(R-x)*({M_2})");
        assert_printed(&bending.shear_1, &shear_1, "(3.35)");
    })
    .unwrap();
}

#[test]
fn linearised_shear_is_3_38_and_3_40() {
    symbolic(|| {
        let bending = Bending::derive().unwrap();
        assert_printed(&linearise(&bending.shear, &SMALL), "-EI/R^2*theta_2 + EI/R^3*x_1", "(3.38)");
        assert_printed(&linearise(&bending.shear_1, &SMALL), "EI/R^3*x_2 - EI/R^3*(R + 2*x)*theta_3", "(3.40)");
    })
    .unwrap();
}

#[test]
fn path_is_3_42() {
    symbolic(|| {
        let slope = read("x_1", SLOPE).unwrap();
        let bend = on_path(&read("x_2", "x_2").unwrap(), &slope).unwrap();
        let printed = read("(3.42)", "-(R-x)*theta_1/cos(theta)^2 + sin(theta)/cos(theta)*x_1").unwrap();
        let printed = substitute(&printed, &[("x_1", slope)]);
        // The two differ by cos² + sin² = 1.
        let one = |atom: &Atom| {
            atom.replace(read("", "sin(theta)").unwrap().pow(2)).with(read("", "1-cos(theta)^2").unwrap())
        };
        let difference = one(&(bend - printed).expand()).expand().factor();
        assert!(difference.is_zero(), "(3.42): {difference}");
    })
    .unwrap();
}

#[test]
fn stretch_is_3_10_and_3_11() {
    symbolic(|| {
        let (tension, speed) = kinematics::stretch("T").unwrap();
        assert_printed(&tension, "(T + G^2/m_o)/(1 - G^2/(EA*m_o))", "(3.10)");
        assert_printed(&speed, "G*(T + EA)/(EA*m_o - G^2)", "(3.11)");
    })
    .unwrap();
}

/// The value of a step, with the plan's own steps put in wherever `inline` names them.
fn value(plan: &eqgen::plan::Plan, name: &str, inline: &[&str]) -> Result<Atom, Error> {
    let of = |name: &str| match plan.step(name).map(|step| step.definition.clone()) {
        Some(Definition::Expression(value)) => value,
        other => panic!("{name}: {other:?}"),
    };
    let mut value = of(name);
    for name in inline {
        value = substitute(&value, &[(name, of(name))]);
    }
    Ok(value)
}

#[test]
fn isolated_contact_is_3_41_and_5_5() {
    symbolic(|| {
        let model = contact::model(Shear::Linearised, eqgen::physics::friction::Law::ViscousCoulomb).unwrap();
        let highest = value(&model.plan, "theta_3", &["Q_theta3", "theta_30"]).unwrap();
        // (3.41) with the sign of Q' as (3.39) and the thesis's code have it, and x'' by (3.42).
        let bend = on_path(&read("", "x_2").unwrap(), &read("", SLOPE).unwrap()).unwrap();
        let printed = read("", "-T*R^3/(EI*(R+2*x))*(1 - n/T - theta_1 - EI/(T*R^3)*x_2)").unwrap();
        let printed = substitute(&printed, &[("x_2", bend)]);
        let tangent = [("tan_theta", read("", "sin(theta)/cos(theta)").unwrap())];
        let difference = (substitute(&highest, &tangent) - printed).factor();
        assert!(difference.is_zero(), "(3.41): {difference}");
        let tension = value(&model.plan, "T_hat_1", &["theta_1"]).unwrap();
        assert_printed(&tension, "Phi*(t + (theta1/Phi - 1)*Q)", "(5.5)");
    })
    .unwrap();
}

#[test]
fn spans_are_5_13_and_5_14() {
    symbolic(|| {
        let model = span::model(span::Equations::Derived).unwrap();
        let tension = value(&model.plan, "tau_hat_1", &[]).unwrap();
        assert_printed(&tension, "-EI/L^2*vartheta1*vartheta2", "(5.13)");
        let bend = value(&model.plan, "vartheta_hat_3", &[]).unwrap();
        assert_printed(&bend, "L^2*tau*vartheta1/EI", "(5.14)");
    })
    .unwrap();
}
