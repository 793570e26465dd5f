//! Efficiency over slack tension: where the belt is clamped just enough.

use sheave::case::Case;
use sheave::drive::SolveOptions;
use sheave::study::{Axis, Study, StudyError, table};

fn main() -> Result<(), StudyError> {
    let axes = [Axis::parse("operating_point.slack_tension = 40..200 N : 9")?];
    let study = Study::new(Case::base(), axes, SolveOptions { tolerance: 1e-4, ..SolveOptions::default() })?;
    let table = table(&study, None)?;
    println!("{:>8}{:>12}{:>14}", "T_slack", "efficiency", "A_P");
    for row in 0..table.rows.len() {
        let number = |column: &str| table.number(row, column);
        let (tension, efficiency) = (number("operating_point.slack_tension"), 100.0 * number("efficiency.overall"));
        println!("{tension:>6.0} N{efficiency:>10.2} %{:>12.1} N", number("primary.axial_force"));
    }
    Ok(())
}
