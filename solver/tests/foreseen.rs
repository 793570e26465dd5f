//! Errors that are foreseen: defects aim at less before they meet the tolerance, where that would not be enough.

#![allow(clippy::unwrap_used)]

use solver::bvp::Bvp;
use solver::{Control, Options, Solution};

/// `u'' = -100 u + min(|x - 0.3417|, 0.2)`, `u(0) = 1`, `u(1) = -0.3`: defects are amplified, and there are kinks,
/// which take some meshes more than all else.
fn kinked(options: &Options) -> Solution {
    let problem = Bvp::new(
        &["u", "slope"],
        (0.0, 1.0),
        |x: f64, u, _, f| (f[0], f[1]) = (u[1], u[0] * -100.0 + (x - 0.3417).abs().min(0.2)),
        |a, b, _, g| (g[0], g[1]) = (a[0] - 1.0, b[0] + 0.3),
    );
    problem.guess(10, |_, u| u.fill(0.0)).solve(options).unwrap()
}

#[test]
fn no_mesh_is_made_for_defects_that_will_not_do() {
    for tolerance in [1e-8, 1e-9] {
        let options = Options { tolerance, ..Options::default() };
        let (solution, by_defect) = (kinked(&options), kinked(&Options { control: Control::Defect, ..options }));
        // Defects at the tolerance are not enough.
        assert!(by_defect.error_estimate() > 1.5 * tolerance && solution.error_estimate() <= tolerance);
        let (last, before) = solution.history().split_last().unwrap();
        assert!(last.defects[0] < 0.5 * tolerance, "{last:?}");
        for record in before {
            assert!(record.defects[0] > tolerance, "{:?}", solution.history());
        }
        assert!(before.last().unwrap().intervals[0] >= 200, "{before:?}");
    }
}
