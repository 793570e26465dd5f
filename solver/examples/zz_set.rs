#![allow(missing_docs, dead_code, clippy::all)]
#[path = "../tests/testset/problems/mod.rs"]
mod problems;
use problems::run::{How, errors, run};
use solver::{Options, Order};
fn main() {
    let filter: Vec<String> = std::env::args().skip(1).collect();
    let control = if filter.iter().any(|f| f == "defect") { solver::Control::Defect } else { solver::Control::Error };
    let tolerance = filter.iter().find_map(|f| f.strip_prefix("tol=").and_then(|t| t.parse().ok())).unwrap_or(1e-6);
    let names: Vec<&String> = filter.iter().filter(|f| !f.contains('=') && *f != "defect").collect();
    let (mut total, mut n, mut bad) = (0.0, 0, 0);
    let count: Option<usize> = filter.iter().find_map(|f| f.strip_prefix("n=").and_then(|t| t.parse().ok()));
    for mut case in problems::cases() {
        if let Some(c) = count {
            case.intervals = c;
        }
        if !names.is_empty() && !names.iter().any(|f| case.id == f.as_str()) {
            continue;
        }
        for parameter in case.parameters() {
            for order in [Order::Four, Order::Six] {
                let options = Options { order, control, tolerance, ..Options::default() };
                let outcome = run(&case, parameter, &options);
                total += outcome.seconds;
                let how = match outcome.how {
                    How::Direct => "direct".to_owned(),
                    How::Continued(steps) => format!("{steps} steps"),
                    #[allow(unreachable_patterns)]
                    _ => "other".to_owned(),
                };
                print!(
                    "{:11} {:7.1e} {:1} {how:9} {:7.2}ms ",
                    case.label(),
                    parameter.unwrap_or(f64::NAN),
                    order.number(),
                    1e3 * outcome.seconds
                );
                match &outcome.solution {
                    Ok(s) => {
                        let e = errors(&case, parameter, s);
                        n += s.intervals();
                        let worst = e.tabulated.max(e.everywhere) / tolerance;
                        let mark = if !(worst <= 10.0) {
                            bad += 1;
                            "  <<<<<"
                        } else {
                            ""
                        };
                        println!(
                            "{:8.1e} {:8.1e} est {:8.1e} N {:5} it {:3} meshes {:2} def {:.1e}{mark}",
                            e.tabulated,
                            e.everywhere,
                            s.error_estimate(),
                            s.intervals(),
                            s.stats().newton_iterations,
                            s.stats().meshes,
                            s.max_defect()
                        );
                        if names.len() > 0 {
                            for h in s.history() {
                                println!("      {:?} {:?} {}", h.intervals, h.defects, h.newton_iterations);
                            }
                        }
                    }
                    Err(e) => {
                        bad += 1;
                        println!("FAILED {e}")
                    }
                }
                if names.len() > 0 {
                    println!("     direct: {:?}", outcome.direct);
                }
            }
        }
    }
    println!("total {:.1} ms, {n} intervals, {bad} bad", 1e3 * total);
}
