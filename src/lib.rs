//! Rubber V-belt CVTs, computed: axial forces, efficiency and belt path from one boundary value problem.
//!
//! # The problem
//!
//! A belt with bending stiffness runs around two pulleys, primary `P` and secondary `S`. Along each contact, over the
//! angle φ̂ from its entry, the tractive tension T, the angle of inclination θ with its derivatives and the penetration
//! x satisfy
//!
//! ```text
//! T'   = f_T(T, θ, θ', θ'', x; c)    tangential momentum: friction drives or brakes the belt
//! θ''' = f_θ(T, θ, θ', θ'', x; c)    radial momentum, with the bending moment M_b = EI dψ/ds, solved for θ'''
//! x'   = −(R − x) tan θ              geometry (3.24)
//! ```
//!
//! and along each span, where nothing touches the belt, the tension τ and the direction ϑ satisfy the same balances
//! without contact. Friction follows Coulomb's law against the sliding velocity, and is proportional to it below a
//! threshold. The constants c are those of belt, pulleys and operating point, which are given, and eight that are found
//! with the states: speed ratio, mass flow, two wrap and two orientation angles, two lengths of spans. 26 conditions at
//! the ends of the four regions determine them: tension, direction, curvature and (in the consistent edition) shear are
//! continuous, torque and tension are what is given, and both spans close the loop. [`solver`] solves this by
//! collocation with Newton's method and continuation, from nothing. Success means that defects and boundary residuals
//! hold on the final mesh.
//!
//! # An example
//!
//! ```
//! use sheave::prelude::*;
//!
//! let case = Case::base().with("drive.ratio", "1.2")?.with_si(Key::SlackTension, 120.0)?;
//! let outcome = sheave::solve(&case)?;
//! let result = &outcome.result;
//! assert!(result.efficiency.overall.is_some_and(|share| share > 0.9));
//! assert!(result.energy.closure.is_some_and(|share| share.abs() < 1e-4));
//! println!("{:.0} N clamp the primary", result.primary.axial_force);
//! # Ok::<(), sheave::Error>(())
//! ```
//!
//! [`sweep`] solves over a grid, [`largest_torque`], [`smallest_clamps`] and [`optimum`] find limits and the best
//! clamp.
//!
//! # What is where
//!
//! A [`case`] is solved by the [`drive`], and its [`result`] says what the belt does; a [`study`] does so over a grid,
//! [`design`] finds limits and the best clamp; [`plot`] and `report` (feature `figures`) show it. [`small`] models
//! stand beside the full one, and [`actuator`]s press the sheaves together. [`equilibrium`] finds where a whole drive
//! settles, and `launch` (feature `ode`) drives a vehicle with it. What the page in the browser asks is answered
//! by [`live`]. `bench` (a feature) leads from measurements
//! to what a case needs.

#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod actuator;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod beltmap;
#[cfg(feature = "bench")]
pub mod bench;
mod cancel;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod case;
pub mod clock;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod design;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod drive;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod equilibrium;
mod facade;
mod formula;
#[cfg(feature = "ode")]
mod integrator;
#[cfg(feature = "ode")]
pub mod launch;
pub mod live;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod losses;
pub mod model;
pub mod plot;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod powertrain;
pub mod prelude;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod quantity;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod random;
#[cfg(feature = "figures")]
pub mod report;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod result;
pub mod small;
pub mod study;
pub mod text;
mod threads;
#[cfg_attr(not(test), deny(clippy::disallowed_methods))]
pub mod tune;

pub use cancel::cancellable;
pub use facade::{Error, Sweep, largest_torque, optimum, smallest_clamps, solve, solve_with, sweep, sweep_table};
/// The boundary value solver, for programs that read the solution itself: meshes, interpolation, statistics.
pub use solver;
pub use solver::Cancel;
