//! What generation refuses: wrong dimensions, undeclared divisors, unknown symbols.
#![allow(clippy::unwrap_used, clippy::panic)]

use eqgen::physics::boundary::{self, Ends};
use eqgen::physics::{beam::Shear, span};
use eqgen::plan::{Definition, Function, Origin, Plan, read};
use eqgen::{Error, dimension, emit, symbolic};

fn plan(inputs: &[&str]) -> Plan {
    Plan::new(inputs.iter().map(|&name| name.into()).collect(), Default::default()).unwrap()
}

#[test]
fn wrong_dimension_names_the_term() {
    symbolic(|| {
        let mut plan = plan(&["R", "x", "EI", "T"]);
        match plan.primitive("r", "R - x + T", "") {
            Err(Error::Dimension { step, term, found, .. }) => {
                assert_eq!((step.as_str(), term.as_str(), found.as_str()), ("r", "T", "[kg m s^-2]"));
            }
            other => panic!("{other:?}"),
        }
        assert!(matches!(plan.primitive("r", "R^2 - x", ""), Err(Error::Dimension { .. })));
        assert!(matches!(plan.primitive("mu", "cos(R)", ""), Err(Error::Dimension { .. })));
        assert!(matches!(plan.apply("speed", Function::Sqrt, &["R"], ""), Err(Error::Dimension { .. })));
        plan.primitive("r", "R - x", "").unwrap();
        assert!(matches!(plan.primitive("r", "R", ""), Err(Error::Redefined { .. })));
    })
    .unwrap();
}

#[test]
fn unknown_symbols_are_refused() {
    symbolic(|| {
        let mut plan = plan(&["R"]);
        assert!(matches!(plan.primitive("r", "R - x", ""), Err(Error::UnknownSymbol { symbol, .. }) if symbol == "x"));
        assert!(matches!(plan.primitive("nonsense", "R", ""), Err(Error::UnknownSymbol { .. })));
        assert!(matches!(plan.primitive("r", "R -* 2", ""), Err(Error::Parse { .. })));
    })
    .unwrap();
}

#[test]
fn undeclared_divisors_are_refused() {
    symbolic(|| {
        let divide = |guard: Option<&str>| {
            let mut plan = plan(&["s", "R", "x", "EI"]);
            plan.primitive("r", "R - x", "").unwrap();
            plan.primitive("Q", "EI/r^2", "").unwrap();
            guard.iter().for_each(|guard| plan.nonzero(guard, "for the test").unwrap());
            emit::Import::new(&plan, 1).map(|_| ())
        };
        assert!(
            matches!(divide(None), Err(Error::UndeclaredDivisor { step, divisor }) if step == "Q" && divisor == "r")
        );
        assert!(divide(Some("R - x")).is_ok());
        assert!(divide(Some("x - R")).is_ok());
        assert!(divide(Some("R")).is_err());
    })
    .unwrap();
}

/// The thesis prints L² on the wrong side of both span equations; their dimensions alone show it.
#[test]
fn dimensions_find_the_printed_span_slip() {
    symbolic(|| {
        let printed = span::model(span::Equations::AsPrinted).unwrap().plan;
        for name in ["tau_hat_1", "vartheta_hat_3"] {
            refused(&printed, name);
        }
        let derived = span::model(span::Equations::Derived).unwrap().plan;
        assert!(derived.steps.iter().all(|step| step.origin != Origin::Printed));
    })
    .unwrap();
}

/// The thesis prints zero shear without Φ: θ̂'' is per region squared, x̂'/R per region.
#[test]
fn dimensions_find_the_missing_wrap_angle() {
    symbolic(|| {
        let printed = boundary::model(Ends::AsPrinted, Shear::Linearised).unwrap().plan;
        for end in ["P1", "P2", "S1", "S2"] {
            refused(&printed, &format!("shear_{end}"));
        }
    })
    .unwrap();
}

fn refused(printed: &Plan, name: &str) {
    let step = printed.step(name).unwrap();
    assert_eq!(step.origin, Origin::Printed);
    let Definition::Expression(value) = &step.definition else { panic!("{name} is no expression") };
    match printed.check_dimensions(name, value) {
        Err(error @ Error::Dimension { .. }) => println!("{error}"),
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn dimensions_of_sums_and_powers() {
    symbolic(|| {
        let known = eqgen::physics::notation::dimensions();
        let of = |text: &str| dimension::dimension("", &read("", text).unwrap(), &known).unwrap().to_string();
        assert_eq!(of("EI/R^2"), "[kg m s^-2]");
        assert_eq!(of("Phi*theta1"), "[region^-2]");
        assert_eq!(of("M_in*omega_P"), "[kg m^2 s^-3]");
        assert_eq!(of("cos(theta)^2 + 1"), "[1]");
    })
    .unwrap();
}

/// What a reader is told of the conditions: that the belt's curvature and shear follow from bending, and that all else
/// is typed in.
#[test]
fn conditions_say_whether_they_are_typed_in_or_derived() {
    symbolic(|| {
        for shear in [Shear::Linearised, Shear::Full] {
            let set = boundary::model(Ends::Continuous, shear).unwrap();
            let of = |origin: Origin| {
                let steps = set.equations.iter().filter_map(|equation| set.plan.step(&equation.name));
                steps.filter(|step| step.origin == origin).map(|step| step.name.clone()).collect::<Vec<_>>()
            };
            let (typed, derived) = (of(Origin::Primitive), of(Origin::Derived));
            assert_eq!((typed.len(), derived.len()), (18, 8));
            assert!(
                derived.iter().all(|name| name.starts_with("curvature") || name.starts_with("shear")),
                "{derived:?}"
            );
        }
    })
    .unwrap();
}
