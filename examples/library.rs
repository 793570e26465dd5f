//! A belt, a sweep over its clamp, and the torque that it carries: `cargo run --release --example library`.

use sheave::prelude::*;

fn main() -> Result<(), sheave::Error> {
    let case = Case::base().with("drive.ratio", "1.2")?.with("operating_point.primary_torque", "15 N*m")?;

    // One operating point, with derivatives.
    let outcome = sheave::solve_with(&case, &SolveOptions { sensitivities: true, ..SolveOptions::default() })?;
    print!("{}", summary(&outcome.result));
    for warning in warnings(&outcome) {
        println!("warning: {warning}");
    }
    let slope = outcome.result.sensitivities.as_ref().and_then(|all| all.get("efficiency.overall"));
    if let Some(slope) = slope.and_then(|row| row.get("operating_point.slack_tension")) {
        println!("d(overall efficiency)/d(slack tension) = {slope:.2e} per N");
    }

    // The same over the clamp, point by point.
    let axis = Axis::parse("operating_point.slack_tension=80 N..200 N:5")?;
    for point in sheave::sweep(case.clone(), [axis], SolveOptions::default())? {
        let (point, outcome) = point?;
        match outcome {
            Ok(outcome) => println!("{:?}: {:.4?}", point.varied, outcome.result.efficiency.overall),
            Err(error) => println!("{:?}: {error}", point.varied),
        }
    }

    // What this clamp carries at most.
    let limit = sheave::largest_torque(&case, &LimitOptions::default())?;
    println!("{:.2} N·m at most: {}", limit.value, limit.kind.name());
    Ok(())
}
