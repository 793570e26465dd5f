//! The keys of a description of a belt's tests.

use crate::bench::sheet::{Entry, QuantityKind};
use crate::case::{Range, RangeEnd};
use crate::quantity::{Dimension, Unit};
use std::f64::consts::PI;

const STIFFNESS: Dimension = Dimension::new(0, 1, -2, 0);
const ANGULAR_STIFFNESS: Dimension = Dimension::new(2, 1, -2, -1);
const ACCELERATION: Dimension = Dimension::new(1, 0, -2, 0);

const fn kind(unit: Unit, range: Range) -> QuantityKind {
    QuantityKind::Quantity { unit, range }
}

const NUMBER: Unit = Unit::decimal("", 0, Dimension::NONE);
const MM: QuantityKind = kind(Unit::decimal("mm", -3, Dimension::LENGTH), Range::positive_to(1e5));
const MPA: QuantityKind = kind(Unit::decimal("MPa", 6, Dimension::PRESSURE), Range::POSITIVE);
const DEG: Unit = Unit::new("deg", 0, PI, 180.0, Dimension::ANGLE);
const PLAIN: QuantityKind = kind(NUMBER, Range::POSITIVE);

const fn entry(path: &'static str, kind: QuantityKind, example: &'static str, doc: &'static str) -> Entry {
    Entry { path, kind, example, doc }
}

/// Every key, by sections.
#[rustfmt::skip]
pub static TABLE: [Entry; 43] = [
    entry("name", QuantityKind::Text, "\"CVTech\"", "what the belt is called"),
    entry("source", QuantityKind::Text, "\"...\"", "where the numbers come from"),
    entry("temperature", QuantityKind::Temperature, "\"60 degC\"",
        "temperature of the belt in use; --temperature goes before it"),
    entry("rubber.poisson_ratio", kind(NUMBER, Range { low: RangeEnd::Open(-1.0), high: RangeEnd::Closed(0.5) }), "0.5",
        "ν of the rubber (4.3); 0.5 if it is not given"),
    entry("rubber.test.temperature", QuantityKind::Temperature, "\"25 degC\"",
        "one [[rubber.test]] for each temperature tested"),
    entry("rubber.test.storage_modulus", MPA, "\"46.71 MPa\"", "G' in shear"),
    entry("rubber.test.loss_modulus", MPA, "\"5.7 MPa\"", "G'' in shear"),
    entry("rubber.test.storage_over_loss", PLAIN, "8.2", "G'/G'', in place of G''"),
    entry("rubber.test.stress_amplitude", MPA, "\"0.47 MPa\"", "τ_o; with strain and phase in place of the moduli \
        (4.1), (4.2)"),
    entry("rubber.test.strain_amplitude", PLAIN, "0.01", "γ_o"),
    entry("rubber.test.phase", kind(DEG, Range { low: RangeEnd::Closed(0.0), high: RangeEnd::Open(90.0) }),
        "\"6.95 deg\"", "δ between stress and strain"),
    entry("rubber.test.youngs_modulus", MPA, "\"140.1 MPa\"", "E itself, in place of all moduli in shear"),
    entry("yarns.count", kind(NUMBER, Range { low: RangeEnd::Closed(1.0), high: RangeEnd::Closed(1e4) }), "27",
        "yarns across the belt"),
    entry("yarns.linear_density", kind(Unit::new("den", -3, 1.0, 9000.0, Dimension::MASS_PER_LENGTH),
        Range::POSITIVE), "\"1500 den\"", "of one yarn"),
    entry("yarns.specific_modulus", QuantityKind::SpecificModulus, "\"555 g/den\"",
        "tensile modulus over linear density; \"49 N/tex\" as well"),
    entry("yarns.gravity", kind(Unit::decimal("m/s^2", 0, ACCELERATION), Range::positive_to(100.0)),
        "\"9.80665 m/s^2\"",
        "that makes grams of a data sheet forces; standard gravity if it is not given"),
    entry("tension.temperature", QuantityKind::Temperature, "\"60 degC\"", "of the tension test or simulation"),
    entry("tension.force", kind(Unit::decimal("N", 0, Dimension::FORCE), Range::POSITIVE), "\"100 N\"",
        "F on the rubber alone if there is a section [yarns], else on the whole belt"),
    entry("tension.elongation", MM, "\"0.6651 mm\"", "ΔL"),
    entry("tension.length", MM, "\"152.66 mm\"", "L of the unloaded sample, or of a segment"),
    entry("tension.stiffness", kind(Unit::decimal("kN/m", 3, STIFFNESS), Range::POSITIVE), "\"54690 kN/m\"",
        "of a sample or segment of that length, in place of force and elongation"),
    entry("tension.csv", QuantityKind::Text, "\"tension.csv\"",
        "elongation, force with a header such as `mm,N`, in place of both"),
    entry("bending.temperature", QuantityKind::Temperature, "\"60 degC\"", "of the bending test or simulation"),
    entry("bending.moment", kind(Unit::decimal("N*m", 0, Dimension::TORQUE), Range::POSITIVE), "\"0.05 N*m\"",
        "M on the rubber alone if there is a section [section], else on the whole belt"),
    entry("bending.radius", MM, "\"3653 mm\"", "ρ that the moment causes"),
    entry("bending.angular_stiffness", kind(Unit::decimal("N*m/rad", 0, ANGULAR_STIFFNESS), Range::POSITIVE),
        "\"10.42 N*m/rad\"",
        "of the whole belt between two nodes, with bending.length in place of moment and radius"),
    entry("bending.length", MM, "\"17.3 mm\"", "between those nodes"),
    entry("section.width", MM, "\"30.51 mm\"", "of the belt at the cords, the widest place"),
    entry("section.cord_depth", MM, "\"2.85 mm\"", "height of the rectangle on the other side of the cords"),
    entry("section.half_angle", kind(DEG, Range { low: RangeEnd::Closed(0.0), high: RangeEnd::Open(60.0) }),
        "\"12 deg\"",
        "half the wedge angle of the trapezoid"),
    entry("section.outline", QuantityKind::Outline, "[[\"0 mm\", \"2.85 mm\"], [\"3 mm\", \"14 mm\"]]",
        "the real section for the figure: across, and from the outside surface"),
    entry("lateral.temperature", QuantityKind::Temperature, "\"25 degC\"", "of the test of the lateral stiffness"),
    entry("lateral.slope", kind(Unit::decimal("N/mm", 3, STIFFNESS), Range::POSITIVE), "\"1747 N/mm\"",
        "m, load per displacement between the two wedges"),
    entry("lateral.csv", QuantityKind::Text, "\"lateral.csv\"",
        "displacement, load with a header such as `mm,N`, in place of the slope"),
    entry("lateral.from", kind(Unit::decimal("N", 0, Dimension::FORCE), Range { low: RangeEnd::Closed(0.0),
        high: RangeEnd::None }),
        "\"100 N\"", "smallest load that the line is fitted to"),
    entry("lateral.to", kind(Unit::decimal("N", 0, Dimension::FORCE), Range::POSITIVE), "\"1200 N\"", "largest such \
        load"),
    entry("lateral.sample_length", MM, "\"51.25 mm\"", "L_S along the belt"),
    entry("lateral.half_angle", kind(DEG, Range::positive_below(45.0)), "\"12 deg\"", "β of the wedges"),
    entry("lateral.sheave_half_angle", kind(DEG, Range::positive_below(45.0)), "\"12 deg\"",
        "β of the sheaves in use; the wedges' if it is not given"),
    entry("length.outside_circumference", MM, "\"875.1 mm\"", "of the belt laid out as a circle"),
    entry("length.cord_depth", MM, "\"2.85 mm\"", "of the cords below the outside; section.cord_depth if it is not \
        given"),
    entry("length.pitch_length", MM, "\"857.2 mm\"", "in place of these two"),
    entry("length.mass", kind(Unit::decimal("g", -3, Dimension::MASS), Range::positive_to(1e5)), "\"375 g\"",
        "of the whole belt"),
];
