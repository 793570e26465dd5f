//! Friction with its kinks at nodes of the mesh.
//!
//! Where a belt without bending stiffness begins to adhere, the point at which |v| passes the slip threshold moves
//! along the wrap by more than a mesh interval with every correction, and Newton's iteration is lost. Here every
//! contact is divided where the law has its kink ([`division`]), each piece has one branch of the law throughout, and
//! how long the pieces are is unknown ([`problem`]): the iteration sees smooth equations. Which pieces there are
//! follows from the solution itself ([`held`]), on the way down in the slip threshold ([`descent`]).

mod descent;
mod division;
mod held;
mod problem;
#[cfg(test)]
mod tests;

pub(super) use descent::Descent;
