//! The table of the README holds what `cargo bench -p sheave-solver --bench testset -- --write` wrote last.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::path::Path;

/// Cells of every row of a page's tables.
fn rows(page: &str) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap();
    let cells = |line: &str| {
        let inner = line.strip_prefix("| ")?.strip_suffix(" |")?;
        Some(inner.split('|').map(|cell| cell.trim().to_owned()).collect())
    };
    text.lines().filter_map(cells).collect()
}

#[test]
fn problems_shown_first_have_the_figures_of_the_whole_table() {
    let whole = rows("docs/testset.md");
    let shown = rows("README.md");
    let problems = shown.iter().filter(|row| row.len() == 9 && row[0].starts_with('T'));
    let mut compared = 0;
    for row in problems {
        let parameter: f64 = row[2].parse().unwrap();
        let of_problem = |other: &&Vec<String>| {
            other.len() == 15 && other[0] == row[0] && other[1].parse::<f64>().is_ok_and(|value| value == parameter)
        };
        let there = whole.iter().find(of_problem).unwrap();
        // Order 6, then SciPy.
        assert_eq!(row[3..6], there[6..9], "{}", row[0]);
        assert_eq!(row[6..9], there[12..15], "{}", row[0]);
        compared += 1;
    }
    assert_eq!(compared, 8);
}
