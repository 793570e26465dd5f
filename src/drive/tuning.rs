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
/// Tolerance, at most, of the slip threshold's way where meshes are to be fine before the threshold is small. Of 16
/// designs of the survey that were lost at thresholds of 1e-5 to 1.2e-4 m/s, the two routes that use it solve 12; by
/// smooth friction alone, 9 for a twelfth of the work, and with 1e-4 or 1e-5 no more than 7.
pub(super) const FINE_TOLERANCE: f64 = 1e-3;
/// The same for a belt without bending stiffness, which is followed to 1e-3 anyway. Of eight designs lost before, four
/// are solved with it, and three with 1e-3.
pub(super) const STRING_FINE_TOLERANCE: f64 = 1e-4;
/// Parts of the work, of all those of a drive's routes together, that the route with the kinks at nodes may take. The
/// solutions that it finds take 140,000 in the median, a tenth of them more than 280,000.
pub(super) const KINK_PARTS: usize = 4;
/// Parts of the work that the direct route and the two on fine meshes may take; the others have one each. Where the
/// direct one's last stage, down to the slip threshold, takes 350,000, the others arrive no sooner; with one part each,
/// the two on fine meshes solve 2 and 9 of those 16 designs, with two parts 7 and 11.
pub(super) const TWO_PARTS: usize = 2;
/// Slip threshold of the smooth friction law over the case's, by which the law is steeper at rest than the case's own.
/// Where a belt comes to rest in its groove, 0.999 and more of the friction at hand holds it over half of the wrap.
/// Under a law that is only as steep, at four times the threshold, it slides there with several thresholds, and the
/// case's own law takes it for slipping: of those 16 designs it solves 6 where 1 solves 11. Of 23 others, which were
/// lost with 1, 1/2 solves one more.
pub(super) const SMOOTH_THRESHOLD: f64 = 0.5;
/// The same for a belt without bending stiffness: of eight designs lost before, 1 solves two, 1/2 solves four.
pub(super) const STRING_SMOOTH_THRESHOLD: f64 = 0.5;

/// Factor on the slip threshold of a step with the kinks of the friction law at nodes.
pub(super) const THRESHOLD_STEP: f64 = 0.7;
/// Tolerance of these steps. On the way into the groove θ falls by four decades before the belt adheres: a node that is
/// added there has to lie within the slip threshold. Of 200 designs of the survey, 99 are solved with 1e-3 and 157 with
/// 1e-5.
pub(super) const KINK_TOLERANCE: f64 = 1e-5;
/// Share of the slip threshold by which |v| may contradict the branch of the law that a piece of a contact has, on the
/// way, at first and where it is looked closer.
pub(super) const LARGEST_CONTRADICTION: f64 = 0.05;
pub(super) const LEAST_CONTRADICTION: f64 = 1e-3;
/// Share of the wrap angle below which an adhering piece may be about to vanish.
pub(super) const SLIVER: f64 = 1e-2;
/// |ln(|v|/v_thr)|, at most, in a piece that is tried under the other branch of the law.
pub(super) const NEAR_THRESHOLD: f64 = 1.0;
/// Inclination over that at the exit at which a node follows the belt on its way out of the groove,
pub(super) const UNSEATING: f64 = 0.1;
/// and |v|/v_thr there, at least.
pub(super) const UNSEATING_SPEED: f64 = 5.0;
