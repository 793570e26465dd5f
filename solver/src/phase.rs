//! The phases of a solve, and what follows from what is found on a set of meshes.
//!
//! | phase | failed | rough | unconverged | inaccurate | oversized | good |
//! |---|---|---|---|---|---|---|
//! | search | rescue | refine | give up | tighten | coarsen | accept |
//! | tighten | rescue | refine | rescue | tighten | coarsen | accept |
//! | coarsen | fall back | fall back | fall back | fall back | coarsen | accept |
//!
//! A *fallback* is a solution whose defects meet the tolerance, held while a better one, or one on coarser meshes, is
//! sought. To *give up* is to fall back too, where there is a fallback; else it is a failure.

/// What a solve is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Phase {
    /// Meshes on which the defects meet the tolerance are sought.
    Search,
    /// The defects met the tolerance, but the estimated error did not: they are held to less.
    Tighten,
    /// The solution is good, and its meshes are finer than it needs.
    Coarsen,
}

/// What is found on one set of meshes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Finding {
    /// Newton's iteration did not converge.
    Failed,
    /// Defects exceed what they are held to.
    Rough,
    /// Defects are small enough, but Newton's iteration ended short of its tolerance.
    Unconverged,
    /// Defects are small enough, the estimated error is not.
    Inaccurate,
    /// All is small enough, and the meshes are far finer than need be.
    Oversized,
    /// All is small enough.
    Good,
}

/// What to do next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Action {
    /// This solution is the one.
    Accept,
    /// The fallback is the one.
    FallBack,
    /// No better solution is to be had: the fallback is the one, if there is a fallback.
    GiveUp,
    /// Other meshes or another kind of iteration, so that Newton's iteration may converge.
    Rescue,
    /// Finer meshes where the defects are too large.
    Refine,
    /// The same, for defects held to less.
    Tighten,
    /// Coarser meshes.
    Coarsen,
}

/// The transition table: see the module's head.
pub(crate) fn action(phase: Phase, finding: Finding) -> Action {
    match (phase, finding) {
        (_, Finding::Good) => Action::Accept,
        (_, Finding::Oversized) => Action::Coarsen,
        (Phase::Coarsen, _) => Action::FallBack,
        (_, Finding::Failed) | (Phase::Tighten, Finding::Unconverged) => Action::Rescue,
        (_, Finding::Rough) => Action::Refine,
        (Phase::Search, Finding::Unconverged) => Action::GiveUp,
        (_, Finding::Inaccurate) => Action::Tighten,
    }
}

/// The phase in which an action leaves a solve that goes on.
pub(crate) fn phase_after(phase: Phase, action: Action) -> Phase {
    match action {
        Action::Tighten => Phase::Tighten,
        Action::Coarsen => Phase::Coarsen,
        Action::Accept | Action::FallBack | Action::GiveUp | Action::Rescue | Action::Refine => phase,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PHASES: [(Phase, &str); 3] =
        [(Phase::Search, "search"), (Phase::Tighten, "tighten"), (Phase::Coarsen, "coarsen")];
    const FINDINGS: [(Finding, &str); 6] = [
        (Finding::Failed, "failed"),
        (Finding::Rough, "rough"),
        (Finding::Unconverged, "unconverged"),
        (Finding::Inaccurate, "inaccurate"),
        (Finding::Oversized, "oversized"),
        (Finding::Good, "good"),
    ];

    fn name(action: Action) -> &'static str {
        match action {
            Action::Accept => "accept",
            Action::FallBack => "fall back",
            Action::GiveUp => "give up",
            Action::Rescue => "rescue",
            Action::Refine => "refine",
            Action::Tighten => "tighten",
            Action::Coarsen => "coarsen",
        }
    }

    /// The table that is read is the one that is used.
    #[test]
    fn the_printed_table_is_the_transition_table() {
        let mut printed = vec![format!("//! | phase | {} |", FINDINGS.map(|(_, name)| name).join(" | "))];
        printed.push("//! |---|---|---|---|---|---|---|".to_owned());
        for (phase, label) in PHASES {
            let cells = FINDINGS.map(|(finding, _)| name(action(phase, finding)));
            printed.push(format!("//! | {label} | {} |", cells.join(" | ")));
        }
        let table: Vec<&str> = include_str!("phase.rs").lines().filter(|line| line.starts_with("//! |")).collect();
        assert_eq!(table, printed);
    }

    /// What a coarser mesh is tried for is never given up for a failure.
    #[test]
    fn coarsening_ends_in_a_solution_whatever_is_found() {
        for (finding, _) in FINDINGS {
            let next = action(Phase::Coarsen, finding);
            assert!(matches!(next, Action::Accept | Action::FallBack | Action::Coarsen), "{finding:?}");
            assert_eq!(phase_after(Phase::Coarsen, next), Phase::Coarsen);
        }
    }
}
