//! The base case: cold start, a warm step, all sensitivities. `cargo bench --bench belt`.

use criterion::{Criterion, criterion_group, criterion_main};
use sheave::case::{Case, Resolved};
use sheave::drive::{Constant, SolveOptions, solve};
use sheave::result::sensitivities;
use solver::{Guess, Options};
use std::hint::black_box;

fn base(edition: &str) -> Resolved {
    let mut case = Case::default();
    let resolved = case.set("edition", edition).and_then(|()| case.resolve());
    resolved.unwrap_or_else(|error| unreachable!("the base case: {error}"))
}

fn belt(criterion: &mut Criterion) {
    let options = SolveOptions { tolerance: 1e-3, ..SolveOptions::default() };
    for edition in ["published", "thesis", "consistent"] {
        let case = base(edition);
        let mut group = criterion.benchmark_group(edition);
        group.bench_function("cold, 1e-3", |bench| bench.iter(|| solve(black_box(&case), &options).is_ok()));
        let Ok(solved) = solve(&case, &options) else { continue };
        let unknowns: Vec<usize> = (0..Constant::UNKNOWN).collect();
        let solver = Options { tolerance: 1e-3, ..Options::default() };
        let mut guess = Guess::from(&solved.solution);
        group.bench_function("solved again, 1e-3", |bench| {
            bench.iter(|| solver::solve(&solved.belt, black_box(&guess), &unknowns, &solver).is_ok());
        });
        guess.constants[Constant::SlackTension.index()] = 125.0;
        group.bench_function("slack tension 100 N to 125 N, 1e-3", |bench| {
            bench.iter(|| solver::solve(&solved.belt, black_box(&guess), &unknowns, &solver).is_ok());
        });
        group.bench_function("all sensitivities", |bench| bench.iter(|| sensitivities(black_box(&solved)).is_ok()));
    }
}

criterion_group!(benches, belt);
criterion_main!(benches);
