//! How a contact is divided: into pieces of one branch of the friction law each.

use generated::RegionConstant;

use crate::drive::tuning::SLIVER;

/// A branch of the viscous Coulomb law, μ = μ_k min(1, |v|/v_thr).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sliding {
    /// |v| ≥ v_thr: μ = μ_k.
    Slipping,
    /// |v| ≤ v_thr: μ = μ_k |v|/v_thr.
    Adhering,
}

/// Factor on the law's constants that leaves one of its branches alone for all sliding speeds that a belt has: with
/// μ_k and v_thr both so much larger, the slope μ_k/v_thr is what it was; with v_thr so much smaller, μ is μ_k.
const FAR: f64 = 1e9;

impl Sliding {
    /// The other branch.
    pub const fn other(self) -> Self {
        match self {
            Self::Slipping => Self::Adhering,
            Self::Adhering => Self::Slipping,
        }
    }

    /// What a constant of the law is multiplied with for this branch alone to be left.
    pub const fn factor(self, constant: RegionConstant) -> f64 {
        match (self, constant) {
            (Self::Slipping, RegionConstant::SlipThreshold) => 1.0 / FAR,
            (Self::Adhering, RegionConstant::SlipThreshold | RegionConstant::FrictionCoefficient) => FAR,
            _ => 1.0,
        }
    }
}

/// What two pieces of a contact meet at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Joint {
    /// |v| is the slip threshold.
    Kink,
    /// The belt turns from seating to unseating: θ = 0. It does so within v_thr/V of a radian where it adheres, which
    /// is hardly seen unless a node stays there.
    Reversal,
    /// The belt is on its way out of the groove: θ has this value. What it slips with before makes the layer in which
    /// it turns outwards, which this node follows.
    Unseating(f64),
}

/// A piece of a contact.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    /// Its branch of the law.
    pub sliding: Sliding,
    /// Share of the wrap angle at which it begins.
    pub from: f64,
    /// Share at which it ends.
    pub to: f64,
    /// What it meets the next piece at; nothing for the last.
    pub end: Option<Joint>,
}

impl Piece {
    pub fn length(&self) -> f64 {
        self.to - self.from
    }
}

/// The pieces of the primary's contact and of the secondary's, in the order in which the belt runs through them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Division(pub [Vec<Piece>; 2]);

/// Branches and joints of a division, wherever its joints lie.
pub(super) type Structure = [Vec<(Sliding, Option<Joint>)>; 2];

impl Division {
    pub fn structure(&self) -> Structure {
        self.0.each_ref().map(|pieces| pieces.iter().map(|piece| (piece.sliding, piece.end)).collect())
    }

    /// With short adhering blocks slipping, if there are any: they are about to vanish.
    pub fn without_slivers(&self) -> Option<Self> {
        let mut other = self.clone();
        let mut changed = false;
        for pieces in &mut other.0 {
            for (first, last) in blocks(pieces) {
                let length = pieces[last].to - pieces[first].from;
                if pieces[first].sliding == Sliding::Adhering && length < SLIVER {
                    pieces[first..=last].iter_mut().for_each(|piece| piece.sliding = Sliding::Slipping);
                    changed = true;
                }
            }
            *pieces = merged(std::mem::take(pieces));
        }
        changed.then_some(other)
    }

    /// With a block of pieces of one branch, `first` to `last` of a contact, under the other.
    pub fn flipped(&self, contact: usize, (first, last): (usize, usize)) -> Self {
        let mut other = self.clone();
        let pieces = &mut other.0[contact];
        pieces[first..=last].iter_mut().for_each(|piece| piece.sliding = piece.sliding.other());
        *pieces = merged(std::mem::take(pieces));
        other
    }

    /// With a kink just behind the place where the belt turns in the groove moved to before it, by a few of the
    /// `layer`s in which an adhering belt turns.
    pub fn swapped(&self, layer: f64) -> Vec<Self> {
        let mut others = Vec::new();
        for contact in 0..self.0.len() {
            for (at, pair) in self.0[contact].windows(2).enumerate() {
                let (before, behind) = (&pair[0], &pair[1]);
                let adhering = [before, behind].iter().all(|piece| piece.sliding == Sliding::Adhering);
                if before.end != Some(Joint::Reversal) || !adhering || behind.end.is_none() || behind.length() > SLIVER
                {
                    continue;
                }
                for layers in [3.0, 30.0] {
                    let mut other = self.clone();
                    let pieces = &mut other.0[contact];
                    let kink = before.to - (layers * layer).min(0.3 * before.length());
                    pieces[at + 1].sliding = Sliding::Slipping;
                    (pieces[at].to, pieces[at].end) = (kink, Some(Joint::Kink));
                    let turning = Piece { sliding: Sliding::Slipping, from: kink, ..before.clone() };
                    pieces.insert(at + 1, turning);
                    *pieces = merged(std::mem::take(pieces));
                    others.push(other);
                }
            }
        }
        others
    }
}

/// First and last of the pieces of one branch that stand together.
pub(super) fn blocks(pieces: &[Piece]) -> Vec<(usize, usize)> {
    let mut blocks: Vec<(usize, usize)> = Vec::new();
    for (index, piece) in pieces.iter().enumerate() {
        match blocks.last_mut() {
            Some((first, last)) if pieces[*first].sliding == piece.sliding => *last = index,
            _ => blocks.push((index, index)),
        }
    }
    blocks
}

/// Pieces of one branch are one where nothing but a kink lies between them.
pub(super) fn merged(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        match out.last_mut() {
            Some(last) if last.sliding == piece.sliding && last.end == Some(Joint::Kink) => {
                (last.to, last.end) = (piece.to, piece.end);
            }
            _ => out.push(piece),
        }
    }
    out
}

/// Divides a piece at a place within it; nothing happens elsewhere.
pub(super) fn cut(pieces: &mut Vec<Piece>, at: f64, joint: Joint) {
    const APART: f64 = 1e-12;
    let Some(index) = pieces.iter().position(|piece| piece.from + APART < at && at < piece.to - APART) else { return };
    let behind = Piece { from: at, ..pieces[index].clone() };
    (pieces[index].to, pieces[index].end) = (at, Some(joint));
    pieces.insert(index + 1, behind);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn division(shares: &[(Sliding, f64, Option<Joint>)]) -> Division {
        let mut from = 0.0;
        let pieces =
            shares.iter().map(|&(sliding, to, end)| Piece { sliding, from: std::mem::replace(&mut from, to), to, end });
        Division([pieces.collect(), Vec::new()])
    }

    const KINK: Option<Joint> = Some(Joint::Kink);
    const TURN: Option<Joint> = Some(Joint::Reversal);
    use Sliding::{Adhering, Slipping};

    #[test]
    fn an_adhering_sliver_goes_and_its_neighbours_are_one() {
        let before =
            division(&[(Slipping, 0.3, KINK), (Adhering, 0.3001, KINK), (Slipping, 0.9, TURN), (Slipping, 1.0, None)]);
        assert_eq!(before.without_slivers(), Some(division(&[(Slipping, 0.9, TURN), (Slipping, 1.0, None)])));
        let long =
            division(&[(Slipping, 0.3, KINK), (Adhering, 0.8, TURN), (Adhering, 0.9, KINK), (Slipping, 1.0, None)]);
        assert_eq!(long.without_slivers(), None);
    }

    #[test]
    fn a_kink_is_moved_to_before_the_place_where_the_belt_turns() {
        let before =
            division(&[(Slipping, 0.1, KINK), (Adhering, 0.9, TURN), (Adhering, 0.9001, KINK), (Slipping, 1.0, None)]);
        let swapped = before.swapped(1e-3);
        assert_eq!(swapped.len(), 2);
        let kinds = [(Slipping, KINK), (Adhering, KINK), (Slipping, TURN), (Slipping, None)];
        assert_eq!(swapped[0].structure()[0], kinds);
        assert!((swapped[0].0[0][1].to - 0.897).abs() < 1e-12 && swapped[0].0[0][2].to == 0.9);
    }

    #[test]
    fn a_cut_divides_the_piece_it_lies_in_and_no_other() {
        let mut pieces = division(&[(Slipping, 0.5, KINK), (Adhering, 1.0, None)]).0[0].clone();
        cut(&mut pieces, 0.5, Joint::Reversal);
        assert_eq!(pieces.len(), 2);
        cut(&mut pieces, 0.75, Joint::Reversal);
        assert_eq!(
            Division([pieces, Vec::new()]).structure()[0],
            [(Slipping, KINK), (Adhering, TURN), (Adhering, None)]
        );
    }
}
