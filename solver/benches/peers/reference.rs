//! What errors are measured against where a solution is not known: computed by this crate to 1e-11, and again by a peer
//! to 1e-10 or better, which must agree.

use crate::cases::Case;
use crate::codes::{Code, Configuration};
use crate::system::stated;
use solver::{Options, Order, Solution};

/// Both may differ by so much, relative to the largest |u|.
const APART: f64 = 1e-9;

/// What errors are measured against.
pub enum Truth {
    /// The case's solution is known.
    Exact,
    /// It has been computed.
    Computed(Box<Solution>),
}

impl Truth {
    /// Panics where a solution that is not known is not found, or no peer finds the same.
    pub fn of(case: &'static Case) -> Self {
        if case.exact(case.interval.0).is_some() {
            return Self::Exact;
        }
        let solved = |tolerance: f64| {
            let options = Options { order: Order::Eight, tolerance, ..Options::default() };
            [40, 80, 160, 20].into_iter().find_map(|intervals| {
                let problem = stated(case, case.conditions(), intervals);
                problem.solve(&options).ok()
            })
        };
        let solution = solved(1e-11).or_else(|| solved(1e-10));
        let solution = solution.unwrap_or_else(|| panic!("{}: no solution to compare with", case.name));
        let truth = Self::Computed(Box::new(solution));
        let confirmed = peers().any(|(code, configuration)| {
            let found = code.solve(case, &configuration);
            found.is_some_and(|found| found.judged(case, &truth).error <= APART)
        });
        assert!(confirmed, "{}: no peer finds the same solution", case.name);
        truth
    }
}

/// What confirms a solution: the peers at tolerances of 1e-10, and at those that they find shocks with.
fn peers() -> impl Iterator<Item = (Code, Configuration)> {
    let colnew = [7, 6, 5].into_iter().flat_map(|points| {
        [20, 40, 80].map(|intervals| (Code::Colnew, Configuration::Colnew { points, tolerance: 1e-10, intervals }))
    });
    let twpbvpc = [1e-10, 1e-8, 1e-6].into_iter().flat_map(|tolerance| {
        [true, false].map(|conditioning| (Code::Twpbvpc, Configuration::Twpbvpc { conditioning, tolerance }))
    });
    colnew.chain(twpbvpc)
}
