//! Every number of the cold start that was chosen, what it is relative to, and what chose it.
//!
//! All are dimensionless, so that a drive and its model at another scale start alike. "The base case" is that of Table
//! 6.1; "the survey" is `benches/survey.rs`, tuned on seed 1 and judged on others.

/// Torque of the start over slack tension times radius of the primary. At the base case's 100 N this is 0.5 N·m, from
/// which Newton's iteration on the straight belt takes six steps.
pub(super) const TORQUE: f64 = 0.0732;

/// Slip threshold of the start over the belt's speed R_P ω_P, if the case's is lower: friction is then linear in the
/// sliding speed almost everywhere, as sliding speeds are the belt's speed times penetration over radius (below
/// [`DEEPEST`]) or times differences of strain. 1 m/s in the base case.
pub(super) const THRESHOLD: f64 = 0.041_117;

/// T/(k R² tan β) of the smaller pulley, at most, in the start: a tighter belt sinks too deep for the straight guess.
/// 220 N in the base case. Of its ratios from 0.72 to 1.74, 0.008 takes more steps to reach the case's tension.
pub(super) const DEEPEST: f64 = 0.012;

/// T R²/EI of the smaller pulley, at least, in the start: a looser belt does not wrap. Beside the base case's ratios
/// from 0.6 to 2, 1.2 loses starts and 2.5 costs steps.
pub(super) const LEAST_WRAPPED: f64 = 1.7;

/// Share of the tension that the groove's elasticity carries, against friction, in the start's penetration.
pub(super) const PENETRATION_SHARE: f64 = 0.8;
/// Share of the wrap over which the start's penetration rises from zero.
pub(super) const RISE: f64 = 0.1;
/// The start's penetration over the radius, at most, whatever the tension: beyond it, the guess has no belt left.
pub(super) const DEEPEST_GUESS: f64 = 0.1;
/// Mesh intervals of each region at the start.
pub(super) const INTERVALS: usize = 40;

/// Factors on the start's slack tension where it is to be tighter or looser. Four times the tension solved none of 1100
/// designs of the survey that twice had not.
pub(super) const TIGHT: f64 = 2.0;
pub(super) const LOOSE: f64 = 0.5;
/// Factor on [`THRESHOLD`] where the slip threshold is to be larger.
pub(super) const LARGE_THRESHOLD: f64 = 10.0;
/// Factor on the mass per length where inertia is to count less.
pub(super) const LIGHT: f64 = 0.01;
/// Factor on the bending stiffness where the belt is to bend more easily.
pub(super) const HARD_BENDING: f64 = 0.1;
/// Factor on the case's slip threshold at which the tension is moved, where the rest of the threshold's way comes last.
pub(super) const LATE_THRESHOLD: f64 = 30.0;
/// Factor on the case's slip threshold at which the smooth friction law is as steep at rest as the case's own.
pub(super) const SMOOTH_THRESHOLD: f64 = 4.0;
