//! The belt's path in the plane of the pulleys: the origin is the primary's centre, x points to the secondary's, and
//! the belt runs counter-clockwise. Lengths are in m.

use std::f64::consts::PI;

use crate::drive::{RegionId, Solved};
use crate::model::{Constant, Constants, Integral, InternalError, State};
use crate::result::Sampled;

/// Points of a span between two nodes of its mesh, the second node with them.
const PARTS: usize = 6;

/// A solved drive, to be drawn.
#[derive(Debug)]
pub struct Trajectory<'a> {
    solved: &'a Solved,
    constants: Constants,
}

/// A pulley and the part of it that the belt touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rim {
    /// Nominal radius of the belt, m.
    pub radius: f64,
    /// Where the centre lies on the line of centres, m.
    pub center: f64,
    /// Direction from the centre to where the belt enters, rad.
    pub entry: f64,
    /// Wrap angle Φ, rad.
    pub wrap: f64,
}

/// A part of the path.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// Positions in the region, from 0 to 1.
    pub s: Vec<f64>,
    /// Points, m.
    pub points: Vec<(f64, f64)>,
}

/// A contact or a span, as such.
enum Place {
    Contact(Rim),
    Span { before: RegionId, length: f64 },
}

impl<'a> Trajectory<'a> {
    /// Of a solved drive.
    ///
    /// # Errors
    /// None, unless this program is broken.
    pub fn new(solved: &'a Solved) -> Result<Self, InternalError> {
        Ok(Self { solved, constants: Constants::try_from(solved.solution.constants())? })
    }

    /// The primary.
    pub fn primary(&self) -> Rim {
        Rim {
            radius: self.constants[Constant::PrimaryRadius],
            center: 0.0,
            entry: self.constants[Constant::PrimaryOrientation],
            wrap: self.constants[Constant::PrimaryWrap],
        }
    }

    /// The secondary.
    pub fn secondary(&self) -> Rim {
        let wrap = self.constants[Constant::SecondaryWrap];
        Rim {
            radius: self.constants[Constant::SecondaryRadius],
            center: self.constants[Constant::CenterDistance],
            entry: PI - self.constants[Constant::SecondaryOrientation] - wrap,
            wrap,
        }
    }

    fn place(&self, region: RegionId) -> Place {
        match region {
            RegionId::Primary => Place::Contact(self.primary()),
            RegionId::Secondary => Place::Contact(self.secondary()),
            RegionId::SlackSpan => {
                Place::Span { before: RegionId::Primary, length: self.constants[Constant::SlackLength] }
            }
            RegionId::TightSpan => {
                Place::Span { before: RegionId::Secondary, length: self.constants[Constant::TightLength] }
            }
        }
    }

    /// The path in a region: in a contact at the positions `s`, in a span at the nodes of its mesh and between them.
    ///
    /// # Errors
    /// None, unless this program is broken.
    pub fn path(&self, region: RegionId, s: &[f64]) -> Result<Path, InternalError> {
        match self.place(region) {
            Place::Contact(rim) => self.contact(region, rim, s.to_vec()),
            Place::Span { before, length } => self.span(region, before, length),
        }
    }

    /// The belt lies at the radius R − x.
    fn contact(&self, region: RegionId, rim: Rim, s: Vec<f64>) -> Result<Path, InternalError> {
        let sampled = Sampled::at(&self.solved.belt, &self.solved.solution, region, s);
        let at = |(s, x): (&f64, &f64)| {
            let (sin, cos) = libm::sincos(rim.entry + rim.wrap * s);
            (rim.center + (rim.radius - x) * cos, (rim.radius - x) * sin)
        };
        let points = sampled.s.iter().zip(sampled.state(State::Penetration)?).map(at).collect();
        Ok(Path { points, s: sampled.s })
    }

    /// From where the contact before it ends, along the integrals of the direction.
    fn span(&self, region: RegionId, before: RegionId, length: f64) -> Result<Path, InternalError> {
        let Some(&(x0, y0)) = self.path(before, &[1.0])?.points.last() else { return Ok(Path::default()) };
        let part = &self.solved.solution.regions()[region.index()];
        let kernel = self.solved.belt.kernel(region);
        let integral = |integral: Integral| {
            let row = kernel.integral(integral).ok_or(InternalError::Integral { region: region.name(), integral });
            row.map(|row| part.cumulative(row))
        };
        let across = integral(Integral::PositionAcross)?;
        let nodes = integral(Integral::PositionAlong)?.iter().zip(across).map(|(x, y)| (*x, *y));
        let state = State::Direction;
        let row = kernel.state(state).ok_or(InternalError::State { region: region.name(), state })?;
        let Path { s, points } = between(part.mesh(), &nodes.collect::<Vec<_>>(), part.state(row));
        let points = points.into_iter().map(|(x, y)| (x0 + length * x, y0 + length * y)).collect();
        Ok(Path { s, points })
    }
}

/// A curve of unit speed through its nodes, with points between them by Hermite's cubic.
fn between(s: &[f64], nodes: &[(f64, f64)], direction: &[f64]) -> Path {
    let mut path =
        Path { s: s.first().copied().into_iter().collect(), points: nodes.first().copied().into_iter().collect() };
    for ((s, ends), angles) in s.windows(2).zip(nodes.windows(2)).zip(direction.windows(2)) {
        let (&[s0, s1], &[a, b], &[from, to]) = (s, ends, angles) else { continue };
        let h = s1 - s0;
        let cubic = |t: f64, a: f64, b: f64, slope_a: f64, slope_b: f64| {
            let u = 1.0 - t;
            u * u * (1.0 + 2.0 * t) * a + t * t * (3.0 - 2.0 * t) * b + h * t * u * (u * slope_a - t * slope_b)
        };
        for part in 1..=PARTS {
            let t = part as f64 / PARTS as f64;
            path.s.push(s0 + h * t);
            path.points.push((
                cubic(t, a.0, b.0, libm::cos(from), libm::cos(to)),
                cubic(t, a.1, b.1, libm::sin(from), libm::sin(to)),
            ));
        }
    }
    path
}
