//! One pulley of a drive line, wrapped by an ideal, flat or V-belt: a component with three ports.
//!
//! The belt is rigid and runs from branch A over the pulley to branch B; both branches are pulled away from the pulley.
//! The tight and the slack branch obey Euler's relation with centrifugal tension; friction is smooth in the sliding
//! speed; the pulley has inertia and its bearing damps.
//!
//! | port | variables |
//! |---|---|
//! | A, B | velocity V in m/s, tension F in N: [`Branch`] |
//! | S | speed ω in rad/s, its rate in rad/s², torque T on the shaft in N·m: [`Shaft`] |
//!
//! [`BeltPulley::residuals`] and [`BeltPulley::jacobian`] state the component's three equations for a system's solver;
//! [`BeltPulley::balance`] solves them for one pulley whose motion and one of whose tensions are known.

mod error;

pub use error::PulleyError;

use crate::formula::Inputs;
use error::check;
use generated::{
    BELT_PULLEY, BELT_PULLEY_LIMITS, BeltPulleyInput as Variable, BeltPulleyLimit, BeltPulleyLimitInput,
    BeltPulleyOutput as Behaves,
};
use std::f64::consts::PI;

/// The belt, and how it grips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BeltType {
    /// It does not slip: its tensions do not depend on friction.
    Ideal,
    /// Friction on the circumference.
    Flat {
        /// f, coefficient of friction.
        friction_coefficient: f64,
    },
    /// Friction on the two faces of a groove: f' = f/sin(φ/2).
    V {
        /// f, coefficient of friction on a face.
        friction_coefficient: f64,
        /// φ, angle between the faces, rad.
        sheave_angle: f64,
    },
}

/// How the two ends of the belt move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// V_A = −V_B: both velocities count away from the pulley.
    Opposite,
    /// V_A = V_B: that of A counts towards the pulley.
    Equal,
}

/// A pulley wrapped by a belt, SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltPulley {
    /// The belt's grip.
    pub belt: BeltType,
    /// How the ends move.
    pub direction: Direction,
    /// R, radius, m.
    pub radius: f64,
    /// θ, wrap angle, rad.
    pub wrap_angle: f64,
    /// ρ, mass per length of the belt, kg/m.
    pub mass_per_length: f64,
    /// J, moment of inertia of the pulley, kg·m².
    pub inertia: f64,
    /// b, viscous damping of the bearing, N·m·s/rad.
    pub bearing_damping: f64,
    /// V_thr, sliding speed at which friction reaches 0.999 of its coefficient, m/s.
    pub velocity_threshold: f64,
    /// F_thr, tension in excess of the centrifugal one about which friction fades, N.
    pub force_threshold: f64,
}

/// A port where a branch of the belt ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// V, m/s.
    pub velocity: f64,
    /// F, tension, N.
    pub tension: f64,
}

/// The port of the shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shaft {
    /// ω_S, rad/s; the belt runs from A to B where it is positive.
    pub speed: f64,
    /// dω_S/dt, rad/s².
    pub acceleration: f64,
    /// T_S, torque of the pulley on the shaft, N·m.
    pub torque: f64,
}

/// All ports.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ports {
    /// Branch A, from which the belt comes where the shaft's speed is positive.
    pub a: Branch,
    /// Branch B.
    pub b: Branch,
    /// The shaft.
    pub s: Shaft,
}

/// One of the two branches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// Branch A.
    A,
    /// Branch B.
    B,
}

impl End {
    /// The letter of its branch.
    pub const fn name(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
        }
    }
}

/// A branch's tension that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull {
    /// Which branch.
    pub end: End,
    /// F, N.
    pub tension: f64,
}

/// What the pulley does with its ports' variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Behaviour {
    /// V_rel = V_B − ω_S R, velocity of the belt against the rim, m/s.
    pub relative_velocity: f64,
    /// F_C = ρ V_B², N.
    pub centrifugal_tension: f64,
    /// μ = −f tanh(4 V_rel/V_thr).
    pub friction_coefficient: f64,
    /// Power that the branches deliver, W.
    pub belt_power: f64,
    /// Power that the shaft takes, W.
    pub shaft_power: f64,
    /// Power lost to sliding, W; never negative.
    pub friction_loss: f64,
    /// Power lost in the bearing, W.
    pub bearing_loss: f64,
    /// Power that accelerates the pulley, W.
    pub kinetic_power: f64,
}

/// The ports' variables among the formulae's inputs, in the order of the columns of [`BeltPulley::jacobian`].
const VARIABLES: [Variable; 7] = [
    Variable::VelocityA,
    Variable::TensionA,
    Variable::VelocityB,
    Variable::TensionB,
    Variable::ShaftSpeed,
    Variable::ShaftAcceleration,
    Variable::ShaftTorque,
];

impl BeltPulley {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`PulleyError::Parameter`] names the first that is out of its range.
    pub fn check(&self) -> Result<(), PulleyError> {
        let friction = match self.belt {
            BeltType::Ideal => 0.0,
            BeltType::Flat { friction_coefficient } | BeltType::V { friction_coefficient, .. } => friction_coefficient,
        };
        let angle = if let BeltType::V { sheave_angle, .. } = self.belt { sheave_angle } else { PI };
        check("friction_coefficient", "", friction, friction >= 0.0, "a number from 0")?;
        check("sheave_angle", "rad", angle, angle > 0.0 && angle <= PI, "an angle above 0 and up to π")?;
        check("radius", "m", self.radius, self.radius > 0.0, "a positive length")?;
        check("wrap_angle", "rad", self.wrap_angle, self.wrap_angle > 0.0, "a positive angle")?;
        check("mass_per_length", "kg/m", self.mass_per_length, self.mass_per_length >= 0.0, "a number from 0")?;
        check("inertia", "kg·m²", self.inertia, self.inertia >= 0.0, "a number from 0")?;
        check("bearing_damping", "N·m·s/rad", self.bearing_damping, self.bearing_damping >= 0.0, "a number from 0")?;
        check("velocity_threshold", "m/s", self.velocity_threshold, self.velocity_threshold > 0.0, "a positive speed")?;
        check("force_threshold", "N", self.force_threshold, self.force_threshold > 0.0, "a positive force")
    }

    /// The coefficient of friction that Euler's relation takes: f of a flat belt, f' of a V-belt, infinite
    /// of an ideal one.
    pub fn effective_coefficient(&self) -> f64 {
        match self.belt {
            BeltType::Ideal => f64::INFINITY,
            BeltType::Flat { friction_coefficient } => friction_coefficient,
            BeltType::V { friction_coefficient, sheave_angle } => {
                let face = [
                    (BeltPulleyLimitInput::FaceFriction, friction_coefficient),
                    (BeltPulleyLimitInput::GrooveAngle, sheave_angle),
                ];
                Inputs::new(&BELT_PULLEY_LIMITS).with(&face).outputs().get(BeltPulleyLimit::WedgeCoefficient)
            }
        }
    }

    /// The component's three equations: direction of the ends, friction (no slip for an ideal belt), moments.
    fn equations(&self) -> [Behaves; 3] {
        let direction = match self.direction {
            Direction::Opposite => Behaves::Opposite,
            Direction::Equal => Behaves::Equal,
        };
        [direction, if self.belt == BeltType::Ideal { Behaves::Adhesion } else { Behaves::Friction }, Behaves::Torque]
    }

    fn inputs(&self, ports: &Ports) -> Inputs<Variable, Behaves> {
        let Ports { a, b, s } = ports;
        let values = [a.velocity, a.tension, b.velocity, b.tension, s.speed, s.acceleration, s.torque];
        let ports: Vec<(Variable, f64)> = VARIABLES.into_iter().zip(values).collect();
        Inputs::new(&BELT_PULLEY).with(&ports).with(&[
            (Variable::Radius, self.radius),
            (Variable::Inertia, self.inertia),
            (Variable::BearingDamping, self.bearing_damping),
            (Variable::MassPerLength, self.mass_per_length),
            (Variable::WrapAngle, self.wrap_angle),
            (Variable::FrictionCoefficient, self.effective_coefficient()),
            (Variable::VelocityThreshold, self.velocity_threshold),
            (Variable::ForceThreshold, self.force_threshold),
        ])
    }

    /// The component's equations at some values of its ports' variables: direction in m/s, friction in N (for an ideal
    /// belt no slip in m/s), moments in N·m. All vanish where the ports fit.
    pub fn residuals(&self, ports: &Ports) -> [f64; 3] {
        let outputs = self.inputs(ports).outputs();
        self.equations().map(|equation| outputs.get(equation))
    }

    /// Derivatives of [`BeltPulley::residuals`] in V_A, F_A, V_B, F_B, ω_S, dω_S/dt, T_S.
    pub fn jacobian(&self, ports: &Ports) -> [[f64; 7]; 3] {
        let outputs = self.inputs(ports).linearised();
        self.equations().map(|equation| VARIABLES.map(|variable| outputs.derivative(equation, variable)))
    }

    /// What happens on the pulley, its power balance included.
    pub fn behaviour(&self, ports: &Ports) -> Behaviour {
        let outputs = self.inputs(ports).outputs();
        // An ideal belt has no coefficient, nor a loss.
        let ideal = self.belt == BeltType::Ideal;
        let unless_ideal = |output| if ideal { 0.0 } else { outputs.get(output) };
        Behaviour {
            relative_velocity: outputs.get(Behaves::RelativeVelocity),
            centrifugal_tension: outputs.get(Behaves::CentrifugalTension),
            friction_coefficient: unless_ideal(Behaves::FrictionCoefficient),
            belt_power: outputs.get(Behaves::BeltPower),
            shaft_power: outputs.get(Behaves::ShaftPower),
            friction_loss: unless_ideal(Behaves::FrictionLoss),
            bearing_loss: outputs.get(Behaves::BearingLoss),
            kinetic_power: outputs.get(Behaves::KineticPower),
        }
    }

    /// The branches that have lost their tension: those that centrifugal tension lifts off the pulley. What the
    /// component says then is not to be relied on.
    pub fn slack_branches(&self, ports: &Ports) -> Vec<End> {
        let lift_off = self.behaviour(ports).centrifugal_tension;
        let branches = [(End::A, ports.a.tension), (End::B, ports.b.tension)];
        branches
            .into_iter()
            .filter(|(_, tension)| *tension <= lift_off || tension.is_nan())
            .map(|(end, _)| end)
            .collect()
    }

    /// The ports of a pulley that turns at `speed` rad/s, faster by `acceleration` rad/s², under a belt that runs at
    /// `velocity` m/s from A to B, with one tension known: friction gives the other, the moments the torque. Tells a
    /// warning where a branch loses its tension.
    ///
    /// # Errors
    /// [`PulleyError::Parameter`]; [`PulleyError::Ideal`]: an ideal belt leaves both tensions open.
    pub fn balance(&self, velocity: f64, speed: f64, acceleration: f64, pull: Pull) -> Result<Ports, PulleyError> {
        self.check()?;
        for (what, unit, value) in [
            ("velocity", "m/s", velocity),
            ("speed", "rad/s", speed),
            ("acceleration", "rad/s²", acceleration),
            ("tension", "N", pull.tension),
        ] {
            check(what, unit, value, true, "a finite number")?;
        }
        if self.belt == BeltType::Ideal {
            return Err(PulleyError::Ideal);
        }
        let a_velocity = if self.direction == Direction::Opposite { -velocity } else { velocity };
        let mut ports = Ports {
            a: Branch { velocity: a_velocity, tension: pull.tension },
            b: Branch { velocity, tension: pull.tension },
            s: Shaft { speed, acceleration, torque: 0.0 },
        };
        self.balance_friction(&mut ports, pull.end)?;
        // The balance of moments is linear in the torque, with coefficient one.
        ports.s.torque -= self.inputs(&ports).outputs().get(Behaves::Torque);
        for end in self.slack_branches(&ports) {
            tracing::warn!(
                "branch {} of the belt has lost its tension; the pulley's state is not to be relied on",
                end.name()
            );
        }
        Ok(ports)
    }

    /// Newton's method for the tension that is not known. The relation is increasing in both, convex or concave.
    fn balance_friction(&self, ports: &mut Ports, known: End) -> Result<(), PulleyError> {
        const STEPS: usize = 100;
        // The step behind it would be this one's square.
        const LAST_STEP: f64 = 1e-10;
        for _ in 0..STEPS {
            let (unknown, input) = match known {
                End::A => (&ports.b, Variable::TensionB),
                End::B => (&ports.a, Variable::TensionA),
            };
            let from = unknown.tension;
            let outputs = self.inputs(ports).linearised();
            let step = -outputs.get(Behaves::Friction) / outputs.derivative(Behaves::Friction, input);
            let unknown = match known {
                End::A => &mut ports.b,
                End::B => &mut ports.a,
            };
            unknown.tension = from + step;
            if step.abs() <= LAST_STEP * from.abs().max(self.force_threshold) {
                return Ok(());
            }
        }
        Err(PulleyError::NotConverged { steps: STEPS })
    }
}
