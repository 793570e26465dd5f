//! Which input pulley lets the smallest motor accelerate a conveyor: torque and reflected inertia over its diameter.

use sheave::small::size::{BeltDrive, Idler, SizeError, size};

fn main() -> Result<(), SizeError> {
    println!("{:>8}{:>14}{:>14}{:>14}", "D_in", "inertia", "steady", "in all");
    for diameter in [0.04, 0.06, 0.08, 0.1, 0.15, 0.2] {
        // The belt is to reach 1 m/s in half a second, whatever the pulley.
        let drive = BeltDrive {
            linear_mass: 50.0,
            friction_force: 20.0,
            output_diameter: 0.25,
            output_inertia: 0.02,
            acceleration: 2.0 / (diameter / 2.0),
            idlers: vec![Idler { inertia: 3e-4, diameter: 0.06 }; 4],
            ..BeltDrive::new(diameter)
        };
        let sizing = size(&drive)?;
        println!(
            "{:>5.0} mm{:>8.4} kg·m²{:>10.3} N·m{:>10.3} N·m",
            1e3 * diameter,
            sizing.inertia.total,
            sizing.torque.steady,
            sizing.torque.drive
        );
    }
    Ok(())
}
