//! Actuators: what presses the sheaves of a drive together.
//!
//! On the primary, [`Flyweights`] press against a [`Spring`]: F_P = F_fly(ω_P, s) − F_spring(s). On the secondary a
//! spring and a [`Helix`] press: F_S = F_spring(s) + F_helix(M_S, s). Travel s is measured from where the primary's
//! sheaves stand farthest apart and from where the secondary's stand closest; s = 2 tan β ΔR ([`travel`]).
//!
//! Their laws are derived in the same place as the belt's (`eqgen/src/physics/small/actuator.rs`), and each force comes
//! with its exact derivatives. Friction turns the force of a contact by its friction angle, and its sign follows the
//! direction of the [`Shift`]: between the two directions lies the band in which a drive does not shift at all.
//!
//! ```
//! use sheave::actuator::{Flyweights, Mechanism, Profile, Shift, Spring};
//! // Three flyweights of 72 g with a measured r dr/ds of about 39 mm, against a spring of 8.2 N/mm.
//! let coefficient = Profile::new(vec![0.0, 0.0288], vec![0.0395, 0.0380])?;
//! let mechanism = Mechanism::Coefficient { coefficient, lost: 0.0 };
//! let flyweights = Flyweights { count: 3, mass: 0.072, mechanism };
//! let spring = Spring::from_lengths(0.106, 8.2e3, 0.059, None)?;
//! let speed = 3000.0 * std::f64::consts::PI / 30.0;
//! let clamp = flyweights.force(speed, 0.0, Shift::Closing)?.value - spring.force(0.0)?.value;
//! assert!((clamp - 456.7).abs() < 0.1, "{clamp} N");
//! # Ok::<(), sheave::actuator::ActuatorError>(())
//! ```

mod error;
mod flyweight;
mod helix;
mod profile;
mod pulley;
mod shift;
mod spring;

pub use error::ActuatorError;
pub use flyweight::{CamArm, CamState, FlyweightForce, Flyweights, Mechanism, RollerArm, RollerState};
pub use helix::{AngleFrom, Helix, HelixForce};
pub use profile::{Jet, Profile, ProfileError};
pub use pulley::{ActuatorForce, PrimaryActuator, SecondaryActuator};
pub use shift::Shift;
pub use spring::{Spring, SpringForce};

use generated::{SHEAVE_TRAVEL, SheaveTravelInput, SheaveTravelOutput};

use crate::formula::Inputs;

/// Travel of a movable sheave in m, positive where it closes, between the belt's radii `start` and `radius` in m in a
/// groove of half angle `half_angle` in rad.
pub fn travel(half_angle: f64, start: f64, radius: f64) -> f64 {
    use SheaveTravelInput as Input;
    let inputs = [(Input::HalfAngle, half_angle), (Input::Radius, radius), (Input::Start, start)];
    Inputs::new(&SHEAVE_TRAVEL).with(&inputs).outputs().get(SheaveTravelOutput::Travel)
}

/// What a movable sheave travels for a unit of the belt's radius: [`travel`] is in proportion to it.
pub fn travel_by_radius(half_angle: f64) -> f64 {
    travel(half_angle, 0.0, 1.0)
}
