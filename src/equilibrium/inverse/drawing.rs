//! Curves of made parts to scale, and as DXF.

use std::fmt::Write;

use super::shape::Shape;
use crate::actuator::{AngleFrom, Profile};
use crate::case::Actuation;

/// A curve to scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Its name: layer of the DXF, and in the figure.
    pub name: &'static str,
    /// What its axes are.
    pub axes: [&'static str; 2],
    /// Its points, m.
    pub points: Vec<(f64, f64)>,
}

/// Points between two of a profile.
const BETWEEN: usize = 4;

/// The curves of a shape.
pub(super) fn outlines(shape: &Shape, actuation: &Actuation) -> Vec<Outline> {
    match shape {
        // A table of coefficients says nothing of a form.
        Shape::Coefficient(_) => Vec::new(),
        Shape::Ramp(profile) => {
            vec![Outline {
                name: "RAMP",
                axes: ["travel", "radius of the centre of mass"],
                points: dense(profile).collect(),
            }]
        }
        Shape::Roller(profile) => vec![Outline {
            name: "ROLLER_CENTRE",
            axes: ["place on the ramp", "radius of the roller's centre"],
            points: dense(profile).collect(),
        }],
        Shape::Cam(profile) => vec![Outline {
            name: "PITCH_CURVE",
            axes: ["along the arm", "across the arm"],
            points: dense(profile)
                .map(|(distance, angle)| (distance * libm::cos(angle), distance * libm::sin(angle)))
                .collect(),
        }],
        Shape::Helix(profile, turns) => {
            let crate::actuator::SecondaryActuator::Helix { helix, .. } = &actuation.secondary else {
                return Vec::new();
            };
            let points = turns.iter().zip(profile.places()).map(|(turn, opening)| (helix.radius * turn, *opening));
            vec![Outline {
                name: "HELIX_UNROLLED",
                axes: ["turn times helix radius", "opening"],
                points: points.collect(),
            }]
        }
    }
}

/// The convention of the case's helix angles in words.
pub(super) const fn from_words(from: AngleFrom) -> &'static str {
    match from {
        AngleFrom::Rotation => "from the plane of rotation",
        AngleFrom::Axis => "from the shaft's axis",
    }
}

fn dense(profile: &Profile) -> impl Iterator<Item = (f64, f64)> + '_ {
    let last = profile.places().last().copied();
    let inner = profile.places().windows(2).flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        (0..BETWEEN).map(move |i| from + (to - from) * i as f64 / BETWEEN as f64)
    });
    inner.chain(last).map(|place| (place, profile.at(place).value))
}

/// The surface on which a roller of a radius in m runs whose centre follows a profile of increasing places, on the side
/// of larger radii; nothing where the surface would cross itself.
pub fn surface(profile: &Profile, roller: f64) -> Result<Outline, f64> {
    let offset = |(place, radius): (f64, f64)| {
        let slope = profile.at(place).slope;
        let along = (1.0 + slope * slope).sqrt();
        (place - roller * slope / along, radius + roller / along)
    };
    let points: Vec<(f64, f64)> = dense(profile).map(offset).collect();
    match points.windows(2).position(|pair| pair[1].0 <= pair[0].0) {
        Some(at) => Err(points[at].0),
        None => Ok(Outline { name: "RAMP", axes: ["place on the ramp", "radius of the ramp"], points }),
    }
}

/// The curves as DXF (AutoCAD R12, which every program for sheet and solid parts reads), in millimetres: each an open
/// polyline on a layer of its name.
///
/// R12 polylines are a dozen pairs of group codes; the library for DXF brings some forty packages with it, one for
/// images among them.
pub fn dxf(outlines: &[Outline]) -> String {
    let mut text = String::from(
        "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1009\n  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n",
    );
    for outline in outlines {
        let layer = outline.name;
        // Writing to a string cannot fail.
        let _ = write!(text, "  0\nPOLYLINE\n  8\n{layer}\n 66\n1\n 70\n0\n 10\n0.0\n 20\n0.0\n 30\n0.0\n");
        for (x, y) in &outline.points {
            let (x, y) = (1e3 * x, 1e3 * y);
            let _ = write!(text, "  0\nVERTEX\n  8\n{layer}\n 10\n{x:.6}\n 20\n{y:.6}\n 30\n0.0\n");
        }
        let _ = write!(text, "  0\nSEQEND\n  8\n{layer}\n");
    }
    text + "  0\nENDSEC\n  0\nEOF\n"
}
