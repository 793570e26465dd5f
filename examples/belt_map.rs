//! A small map of the base drive: made, and read between its nodes.

use sheave::beltmap::{KeepNothing, MapAxis, MapOptions, MapPlan, Quantity};
use sheave::prelude::*;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let axes = vec![MapAxis::parse("ratio=0.8..1.6")?, MapAxis::parse("slack_tension=80..240 N")?];
    let options = MapOptions { accuracy: 5e-3, ..MapOptions::default() };
    let map = MapPlan::new(Case::base(), axes, options)?.build(&KeepNothing)?;
    let report = map.report();
    println!("{} nodes, {} check points, largest error {:.1e}\n", report.nodes, report.checks, report.error.largest);
    println!("{:>6}{:>10}{:>10}{:>10}{:>12}{:>10}", "ratio", "T_slack", "A_P", "A_S", "efficiency", "reserve");
    for ratio in [0.9, 1.2, 1.5] {
        for tension in [100.0, 200.0] {
            let point = map.at(&[ratio, tension])?;
            let [primary, secondary] =
                [Quantity::PrimaryAxialForce, Quantity::SecondaryAxialForce].map(|force| point.value(force));
            println!(
                "{ratio:>6.2}{tension:>8.0} N{:>8.0} N{:>8.0} N{:>10.2} %{:>8.1} %",
                primary?,
                secondary?,
                100.0 * point.efficiency()?,
                100.0 * point.slip_reserve()?
            );
        }
    }
    Ok(())
}
