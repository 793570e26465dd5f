//! A belt brake as a component: torque and loss over the sliding speed, its slack branch pulled with 100 N.

use sheave::small::pulley::{BeltPulley, BeltType, Direction, End, Pull, PulleyError};
use std::f64::consts::PI;

fn main() -> Result<(), PulleyError> {
    let pulley = BeltPulley {
        belt: BeltType::V { friction_coefficient: 0.3, sheave_angle: 34f64.to_radians() },
        direction: Direction::Opposite,
        radius: 0.1,
        wrap_angle: PI,
        mass_per_length: 0.2,
        inertia: 0.01,
        bearing_damping: 2e-3,
        velocity_threshold: 1e-2,
        force_threshold: 1.0,
    };
    println!("{:>10}{:>12}{:>14}{:>12}{:>10}", "V_rel", "F_A", "F_B", "T_S", "loss");
    for share in [0.0, 0.1, 0.2, 0.5, 1.0, 2.0] {
        let speed = 50.0;
        let velocity = speed * pulley.radius + share * pulley.velocity_threshold;
        let ports = pulley.balance(velocity, speed, 0.0, Pull { end: End::A, tension: 100.0 })?;
        let behaviour = pulley.behaviour(&ports);
        println!(
            "{:>5.1} mm/s{:>10.1} N{:>12.1} N{:>8.2} N·m{:>8.2} W",
            1e3 * behaviour.relative_velocity,
            ports.a.tension,
            ports.b.tension,
            ports.s.torque,
            behaviour.friction_loss.abs()
        );
    }
    Ok(())
}
