//! The simple belt drive over its torque: creep, sliding angle and axial forces, up to gross slip.

use sheave::case::Case;
use sheave::small::init::{InitError, SimpleDrive, Situation, solve};

fn main() -> Result<(), sheave::case::CaseError> {
    let drive = SimpleDrive::of_case(&Case::base().resolve()?);
    println!("{:>9}{:>12}{:>10}{:>12}{:>12}", "M_O", "v_0", "creep", "sliding", "F_CI");
    for step in 0..=8 {
        let output_torque = 4.0 * f64::from(step);
        let given = Situation::One { input_speed: 356.0, output_torque, output_axial_force: 550.0 };
        match solve(&drive, given) {
            Ok(state) => println!(
                "{output_torque:>5.1} N·m{:>8.3} m/s{:>8.3} %{:>8.1} deg{:>10.1} N",
                state.belt_speed,
                100.0
                    * (1.0 - drive.output_radius * state.output_speed / (drive.input_radius * state.input_speed)).abs(),
                state.sliding_angle.to_degrees(),
                state.input_axial_force,
            ),
            Err(error @ InitError::GrossSlip { .. }) => println!("{output_torque:>5.1} N·m  {error}"),
            Err(error) => println!("{output_torque:>5.1} N·m  no state: {error}"),
        }
    }
    Ok(())
}
