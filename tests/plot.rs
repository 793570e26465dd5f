//! Figures and the report of a solved case.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::result::{Outcome, run};
use sheave::{plot, report};

fn base() -> Outcome {
    let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    run(&Case::base().resolve().unwrap(), &options).unwrap()
}

#[test]
fn every_figure_has_axes_with_units_and_points_in_both_formats() {
    for figure in plot::drive(&base()).unwrap() {
        for axis in [&figure.x, &figure.y] {
            assert!(axis.label.ends_with(')') && axis.label.contains('('), "{}: {}", figure.name, axis.label);
        }
        assert!(figure.series.iter().all(|series| series.points.len() > 1), "{}", figure.name);
        let svg = figure.svg().unwrap();
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
        assert!(svg.contains(&figure.x.label) && svg.contains(&figure.y.label));
        assert!(!svg.contains("_{") && !svg.contains(['\u{e000}', '\u{e001}', '\u{e002}']));
        assert!(svg.matches("<polyline").count() > 5);
        let png = figure.png().unwrap();
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    }
}

#[test]
fn figures_are_the_same_every_time() {
    let outcome = base();
    let draw = || plot::drive(&outcome).unwrap().iter().map(|figure| figure.svg().unwrap()).collect::<String>();
    assert_eq!(draw(), draw());
}

#[test]
fn the_loss_split_adds_up() {
    let outcome = base();
    let split = report::losses(&outcome).unwrap();
    for (part, whole) in [
        (split.primary, outcome.result.primary.friction_loss),
        (split.secondary, outcome.result.secondary.friction_loss),
    ] {
        assert!((part.entry + part.seated + part.exit - whole).abs() < 1e-9 * whole);
        assert!((part.radial + part.tangential - whole).abs() < 1e-9 * whole);
        assert!(part.entry > 0.0 && part.seated > 0.0 && part.exit > 0.0 && part.radial > 0.0 && part.tangential > 0.0);
    }
}

fn warned(settings: &[(&str, &str)]) -> Vec<String> {
    let mut case = Case::base();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    sheave::result::warnings(&run(&case.resolve().unwrap(), &options).unwrap())
}

#[test]
fn warnings_are_given_when_they_are_due() {
    assert_eq!(warned(&[]), Vec::<String>::new());
    for (settings, said) in [
        (&[("edition", "published")][..], "Energy is not conserved"),
        (&[("belt.length", "840 mm")], "The belt does not fit"),
        (&[("edition", "thesis"), ("operating_point.slack_tension", "25 N")], "Little slip reserve"),
    ] {
        let warnings = warned(settings);
        assert!(warnings.iter().any(|text| text.contains(said)), "{settings:?}: {warnings:?}");
    }
}
