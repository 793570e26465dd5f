//! A solution of a drive, whole or divided, and how its sliding speeds ask for it to be divided.

use solver::{Guess, RegionGuess, RegionSolution, Solution};

use super::division::{Division, Joint, Piece, Sliding, blocks, cut, merged};
use super::problem::{CONTACTS, Kinked};
use crate::drive::belt::BeltProblem;
use crate::drive::region::RegionId;
use crate::drive::tuning::{NEAR_THRESHOLD, UNSEATING, UNSEATING_SPEED};
use crate::model::{Constant, Field, State};

/// Points of each mesh interval at which sliding speeds are looked at.
const SAMPLES: usize = 4;
/// Bisections that find where a value is passed.
const BISECTIONS: usize = 50;
/// Fewest intervals of a piece.
const FEWEST: usize = 6;
/// Nodes are no nearer to a piece's ends than this share of it.
const NEAREST: f64 = 1e-7;

/// A solution of the problem with divided contacts, or of the drive's own.
pub(super) struct Held<'a> {
    own: &'a BeltProblem,
    /// Its contacts' pieces, if they are divided.
    division: Option<Division>,
    pub solution: Solution,
}

/// A point of a contact.
struct Point {
    /// Share of the wrap angle.
    s: f64,
    y: Vec<f64>,
    /// |v| over the slip threshold.
    ratio: f64,
    /// The branch of the law under which it was found, if it was found under one alone.
    law: Option<Sliding>,
}

impl<'a> Held<'a> {
    pub fn whole(own: &'a BeltProblem, solution: Solution) -> Self {
        Self { own, division: None, solution }
    }

    /// A solution of a divided problem, whose joints are where its constants say.
    pub fn divided(own: &'a BeltProblem, kinked: &Kinked<'_>, division: &Division, solution: Solution) -> Self {
        let mut division = division.clone();
        let constants = solution.constants();
        let mut wraps = kinked.wraps().map(|(_, constant)| constants[constant]);
        for (pieces, (_, whole)) in division.0.iter_mut().zip(CONTACTS) {
            let mut from = 0.0;
            for piece in pieces {
                let share = wraps.next().unwrap_or(f64::NAN) / constants[whole.index()];
                piece.from = from;
                piece.to = if piece.end.is_some() { from + share } else { 1.0 };
                from = piece.to;
            }
        }
        Self { own, division: Some(division), solution }
    }

    pub const fn own(&self) -> &'a BeltProblem {
        self.own
    }

    pub const fn division(&self) -> Option<&Division> {
        self.division.as_ref()
    }

    /// The drive's own constants.
    pub fn constants(&self) -> &[f64] {
        &self.solution.constants()[..Constant::ALL.len()]
    }

    pub fn threshold(&self) -> f64 {
        self.constants()[Constant::SlipThreshold.index()]
    }

    /// The parts of a region: its branch, shares of the wrap angle from which and to which it goes, and its solution.
    fn parts(&self, region: RegionId) -> Vec<(Option<Sliding>, f64, f64, &RegionSolution)> {
        let regions = self.solution.regions();
        let Some(Division([primary, secondary])) = &self.division else {
            return regions.get(region.index()).map(|part| (None, 0.0, 1.0, part)).into_iter().collect();
        };
        let (first, pieces) = match region {
            RegionId::Primary => (0, primary),
            RegionId::Secondary => (primary.len() + 1, secondary),
            RegionId::SlackSpan => return vec![(None, 0.0, 1.0, &regions[primary.len()])],
            RegionId::TightSpan => return vec![(None, 0.0, 1.0, &regions[primary.len() + 1 + secondary.len()])],
        };
        let of = |(piece, part): (&Piece, _)| (Some(piece.sliding), piece.from, piece.to, part);
        pieces.iter().zip(&regions[first..]).map(of).collect()
    }

    /// States at a share of the wrap angle.
    fn at(&self, region: RegionId, s: f64) -> Vec<f64> {
        let parts = self.parts(region);
        let within = parts.iter().find(|part| s <= part.2).or(parts.last());
        within.map_or_else(Vec::new, |(_, from, to, part)| part.eval(((s - from) / (to - from)).clamp(0.0, 1.0)))
    }

    /// |v|/v_thr for states of a contact; nothing where the belt does not tell it.
    fn ratios(&self, region: RegionId, states: &[Vec<f64>]) -> Option<Vec<f64>> {
        let count = self.own.kernel(region).states.len();
        let y: Vec<f64> = (0..count).flat_map(|i| states.iter().map(move |y| y[i])).collect();
        let speeds = self.own.field(region, Field::SlidingSpeed, &y, self.constants())?;
        Some(speeds.iter().map(|speed| speed / self.threshold()).collect())
    }

    /// A contact from its entry to its exit.
    fn profile(&self, region: RegionId) -> Option<Vec<Point>> {
        let mut points = Vec::new();
        for (law, from, to, part) in self.parts(region) {
            let inside = part
                .mesh()
                .windows(2)
                .flat_map(|pair| (0..SAMPLES).map(move |k| pair[0] + (pair[1] - pair[0]) * k as f64 / SAMPLES as f64));
            let places: Vec<f64> = inside.skip(usize::from(from > 0.0)).chain([1.0]).collect();
            let states: Vec<Vec<f64>> = places.iter().map(|s| part.eval(*s)).collect();
            let ratios = self.ratios(region, &states)?;
            let shares = places.iter().map(|s| if *s == 1.0 { to } else { from + (to - from) * s });
            let all = shares.zip(states).zip(ratios);
            points.extend(all.map(|((s, y), ratio)| Point { s, y, ratio, law }));
        }
        Some(points)
    }

    /// Where a value passes zero between two places.
    fn root(&self, region: RegionId, (a, b): (f64, f64), value: impl Fn(&[f64]) -> f64) -> f64 {
        let (mut low, mut high) = (a, b);
        let sign = value(&self.at(region, a)) > 0.0;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if (value(&self.at(region, middle)) > 0.0) == sign { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }

    /// The division that |v| asks for: pieces keep their branch of the law, and joints their places, unless |v| is
    /// beyond the threshold by more than the share `clear` of it.
    pub fn asked(&self, clear: f64) -> Option<Division> {
        let [primary, secondary] = [0, 1].map(|contact| self.asked_of(contact, clear));
        Some(Division([primary?, secondary?]))
    }

    fn asked_of(&self, contact: usize, clear: f64) -> Option<Vec<Piece>> {
        let (region, _) = CONTACTS[contact];
        let points = self.profile(region)?;
        let of = |point: &Point| match point.law {
            Some(Sliding::Slipping) if point.ratio >= 1.0 - clear => Sliding::Slipping,
            None if point.ratio > 1.0 => Sliding::Slipping,
            Some(Sliding::Adhering) if point.ratio > 1.0 + clear => Sliding::Slipping,
            _ => Sliding::Adhering,
        };
        let excess = |y: &[f64]| self.ratios(region, &[y.to_vec()]).map_or(f64::NAN, |ratios| ratios[0] - 1.0);
        let mut pieces = vec![Piece { sliding: of(points.first()?), from: 0.0, to: 1.0, end: None }];
        for pair in points.windows(2) {
            let (a, b) = (&pair[0], &pair[1]);
            let sliding = of(b);
            if of(a) == sliding {
                continue;
            }
            // A joint that is held stays where it is.
            let held = a.law.is_some() && a.law != b.law;
            let passes = (a.ratio > 1.0) != (b.ratio > 1.0);
            let at = match (held, passes) {
                (true, _) => a.s,
                (false, true) => self.root(region, (a.s, b.s), excess),
                (false, false) => 0.5 * (a.s + b.s),
            };
            if let Some(last) = pieces.last_mut() {
                (last.to, last.end) = (at, Some(Joint::Kink));
            }
            pieces.push(Piece { sliding, from: at, to: 1.0, end: None });
        }
        self.mark(contact, &points, &mut pieces)?;
        Some(merged(pieces))
    }

    /// Adds the joints that are no kinks: those that are held, or where θ has their values.
    fn mark(&self, contact: usize, points: &[Point], pieces: &mut Vec<Piece>) -> Option<()> {
        let (region, _) = CONTACTS[contact];
        let inclination = self.own.kernel(region).state(State::Inclination)?;
        let held = |is: fn(&Joint) -> bool| {
            let pieces = self.division.as_ref().map(|division| &division.0[contact]);
            pieces?.iter().find_map(|piece| piece.end.filter(is).map(|joint| (joint, piece.to, f64::INFINITY)))
        };
        let rises = |joint: Joint, theta: f64| {
            let passes = |pair: &&[Point]| pair[0].y[inclination] < theta && pair[1].y[inclination] >= theta;
            let pair = points.windows(2).rev().find(passes)?;
            let at = self.root(region, (pair[0].s, pair[1].s), |y| y[inclination] - theta);
            Some((joint, at, pair[1].ratio))
        };
        let reversal = held(|joint| matches!(joint, Joint::Reversal)).or_else(|| rises(Joint::Reversal, 0.0));
        if let Some((joint, at, _)) = reversal {
            cut(pieces, at, joint);
        }
        let theta = UNSEATING * points.last()?.y[inclination];
        let unseating = held(|joint| matches!(joint, Joint::Unseating(_))).or_else(|| {
            let last = pieces.last()?.from;
            rises(Joint::Unseating(theta), theta).filter(|(_, at, ratio)| *ratio > UNSEATING_SPEED && last < *at)
        });
        if let Some((joint, at, _)) = unseating {
            cut(pieces, at, joint);
        }
        Some(())
    }

    /// The division with that block of one branch under the other in which |v| is nearest to the threshold; nothing if
    /// it is far from it everywhere.
    pub fn flipped(&self) -> Option<Division> {
        let division = self.division()?;
        let mut nearest: Option<(f64, usize, (usize, usize))> = None;
        for (contact, (region, _)) in CONTACTS.into_iter().enumerate() {
            let (points, pieces) = (self.profile(region)?, &division.0[contact]);
            for (first, last) in blocks(pieces) {
                let within = |point: &&Point| (pieces[first].from..=pieces[last].to).contains(&point.s);
                let far = points.iter().filter(within).map(|point| libm::log(point.ratio).abs()).fold(0.0, f64::max);
                if far < nearest.map_or(NEAR_THRESHOLD, |nearest| nearest.0) {
                    nearest = Some((far, contact, (first, last)));
                }
            }
        }
        nearest.map(|(_, contact, block)| division.flipped(contact, block))
    }

    /// The angle over which an adhering belt turns, as a share of a radian: v_thr/(R_P ω_P).
    pub fn layer(&self) -> f64 {
        let of = |constant: Constant| self.constants()[constant.index()];
        self.threshold() / (of(Constant::PrimaryRadius) * of(Constant::PrimarySpeed))
    }

    /// As a guess for the problem with contacts divided otherwise.
    pub fn guess(&self, division: &Division) -> Guess {
        let mut constants = self.constants().to_vec();
        let mut regions = Vec::new();
        for region in RegionId::ALL {
            let Some(contact) = CONTACTS.iter().position(|(contact, _)| *contact == region) else {
                regions.extend(self.parts(region).into_iter().map(|(_, _, _, part)| RegionGuess::from(part)));
                continue;
            };
            let parts = self.parts(region);
            let nodes = parts.iter().flat_map(|(_, a, b, part)| part.mesh().iter().map(move |s| a + (b - a) * s));
            let nodes: Vec<f64> = nodes.collect();
            let wrap = self.constants()[CONTACTS[contact].1.index()];
            for piece in &division.0[contact] {
                constants.push(wrap * piece.length());
                let mesh = mesh_of(piece, &nodes);
                let y: Vec<Vec<f64>> = mesh.iter().map(|s| self.at(region, piece.from + piece.length() * s)).collect();
                let states = (0..self.own.kernel(region).states.len()).map(|i| y.iter().map(|y| y[i]).collect());
                regions.push(RegionGuess { mesh, states: states.collect() });
            }
        }
        Guess { regions, constants }
    }

    /// As a guess for the drive's own problem, with a node at every joint.
    pub fn own_guess(&self) -> Guess {
        let whole = |region: RegionId| {
            let mut parts = self.parts(region).into_iter();
            let mut whole = parts.next().map(|(_, from, to, part)| placed(part, from, to))?;
            for (_, from, to, part) in parts {
                let next = placed(part, from, to);
                whole.mesh.extend_from_slice(&next.mesh[1..]);
                whole.states.iter_mut().zip(&next.states).for_each(|(all, next)| all.extend_from_slice(&next[1..]));
            }
            Some(whole)
        };
        Guess { regions: RegionId::ALL.into_iter().filter_map(whole).collect(), constants: self.constants().to_vec() }
    }
}

/// A part at its nodes, from one share of the wrap angle to another.
fn placed(part: &RegionSolution, from: f64, to: f64) -> RegionGuess {
    let mut placed = RegionGuess::from(part);
    placed.mesh.iter_mut().for_each(|s| *s = if *s == 1.0 { to } else { from + (to - from) * *s });
    placed
}

/// A mesh for a piece, of the nodes that lie within it.
fn mesh_of(piece: &Piece, nodes: &[f64]) -> Vec<f64> {
    let mut mesh = vec![0.0];
    for s in nodes.iter().map(|node| (node - piece.from) / piece.length()) {
        if s - mesh[mesh.len() - 1] > NEAREST && 1.0 - s > NEAREST {
            mesh.push(s);
        }
    }
    mesh.push(1.0);
    while mesh.len() <= FEWEST {
        mesh = mesh.windows(2).flat_map(|pair| [pair[0], 0.5 * (pair[0] + pair[1])]).chain([1.0]).collect();
    }
    mesh
}
