//! Bending: moment and shear of the belt as a beam, exact and linearised.

use symbolica::atom::{Atom, AtomCore};

use super::kinematics::{ARC, PSI, SLOPE};
use crate::derive::{Linear, linear_in, linearise, on_path, total_derivative};
use crate::error::Error;
use crate::plan::{Plan, read};

/// How the shear depends on θ and x.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shear {
    /// First order in θ, θ', θ'', x, x', x'' (3.37).
    Linearised,
    /// As it is.
    Full,
}

impl Shear {
    /// As in the case file.
    pub fn name(self) -> &'static str {
        match self {
            Shear::Linearised => "linearised",
            Shear::Full => "full",
        }
    }
}

/// What is small in (3.37); θ''' is kept as it stands.
pub const SMALL: [&str; 6] = ["theta", "theta_1", "theta_2", "x", "x_1", "x_2"];

/// Bending of the belt in a groove, in the jets of θ and x.
#[derive(Debug, Clone)]
pub struct Bending {
    /// dψ/ds.
    pub curvature: Atom,
    /// M_b (3.32).
    pub moment: Atom,
    /// M_b' (3.34).
    pub moment_1: Atom,
    /// M_b'' (3.36).
    pub moment_2: Atom,
    /// Q (3.33).
    pub shear: Atom,
    /// Q' (3.35).
    pub shear_1: Atom,
}

impl Bending {
    /// Euler and Bernoulli: M_b = EI dψ/ds (3.26), Q = dM_b/ds (3.27), all else by differentiation.
    ///
    /// # Errors
    /// None, as long as the relations typed in are readable.
    pub fn derive() -> Result<Self, Error> {
        let arc = read("arc", ARC)?;
        let along_belt = |rate: Atom| rate / &arc;
        let curvature = along_belt(total_derivative(&read("psi", PSI)?)?);
        let moment = read("M_b", "EI")? * &curvature;
        let moment_1 = total_derivative(&moment)?;
        let moment_2 = total_derivative(&moment_1)?;
        let shear = along_belt(moment_1.clone());
        let shear_1 = total_derivative(&shear)?;
        Ok(Self { curvature, moment, moment_1, moment_2, shear, shear_1 })
    }

    /// Q and Q' of the chosen form as functions of tanθ, ds/dφ, θ', θ'', θ''' and x: x' and x'' follow
    /// the belt's path (3.24).
    ///
    /// # Errors
    /// As [`Bending::derive`].
    pub fn on_path(&self, form: Shear) -> Result<(Atom, Atom), Error> {
        let slope = read("x_1", SLOPE)?;
        let shape = |exact: &Atom| match form {
            Shear::Linearised => linearise(exact, &SMALL),
            Shear::Full => exact.clone(),
        };
        let compact = |exact: &Atom| -> Result<Atom, Error> { in_arc(&on_path(&shape(exact), &slope)?) };
        Ok((compact(&self.shear)?, compact(&self.shear_1)?))
    }
}

/// sinθ as tanθ cosθ, cosθ as (R − x)/(ds/dφ): the belt's shear is short in these.
fn in_arc(expression: &Atom) -> Result<Atom, Error> {
    let read = |text| read("arc", text);
    let tangent = expression.replace(read("sin(theta)")?).with(read("tan_theta*cos(theta)")?);
    Ok(tangent.replace(read("cos(theta)")?).with(read("(R - x)/arc")?).factor())
}

/// Adds M_b, Q and the two parts of Q' = ∂Q'/∂θ''' (θ''' − θ'''_0) to a plan.
///
/// # Errors
/// As [`Plan::derived`].
pub fn add_bending(plan: &mut Plan, form: Shear) -> Result<(), Error> {
    plan.nonzero("EI", "the belt resists bending")?;
    plan.nonzero("R", "a pulley has a radius")?;
    plan.nonzero("R + 2*x", "x stays far below R")?;
    plan.law("psi", PSI, "(3.2)")?;
    plan.law("M_b", "EI*psi_s", "(3.26)")?;
    plan.law("Q", "M_b_1/arc", "(3.27), (3.33)")?;
    let bending = Bending::derive()?;
    let (shear, shear_1) = bending.on_path(form)?;
    let Linear { coefficient, rest } = linear_in(&shear_1, "theta_3")?;
    let numbers = match form {
        Shear::Linearised => ("(3.38)", "(3.40)"),
        Shear::Full => ("(3.33)", "(3.35)"),
    };
    plan.derived("M_b", in_arc(&bending.moment)?, "(3.32)")?;
    plan.derived("Q", shear, numbers.0)?;
    plan.derived("theta_30", (-rest / &coefficient).factor(), numbers.1)?;
    plan.derived("Q_theta3", coefficient, numbers.1)
}
