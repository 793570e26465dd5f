//! Chapters 6 and 7 of the thesis: its numbers, its figures, and what the command writes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::Value;
use sheave::case::Edition;
use sheave::report::{REPRODUCED, Reproduction};
use sheave::study::thesis::{RATIOS, chapters, checks, figures, number_in_thesis};
use std::path::Path;
use std::process::Command;

#[test]
fn every_number_and_statement_is_met_by_the_equations_as_printed() {
    let (all, points) = chapters(&[Edition::Published], RATIOS, None).unwrap();
    // The base case; eleven lines, of which the four families share one with the operating range.
    assert_eq!(points, 1 + 11 * RATIOS);
    let [chapters] = &all[..] else { panic!("one edition was asked for") };
    assert_eq!(chapters.failures, Vec::<String>::new());
    let checks = checks(chapters).unwrap();
    assert!(checks.len() >= 51);
    for check in &checks {
        assert!(check.met, "{check:?}");
    }

    let names: Vec<String> = figures(chapters).unwrap().into_iter().map(|figure| figure.name).collect();
    let numbers: String = names.iter().filter_map(|name| number_in_thesis(name)).collect::<Vec<_>>().join(" ");
    let shown: Vec<&str> = numbers.split([' ', ',']).filter(|text| text.contains('.')).collect();
    for (chapter, last) in [(6, 28), (7, 18)] {
        // Figure 6.19 defines an angle and shows no result.
        for figure in (1..=last).filter(|figure| (chapter, *figure) != (6, 19)) {
            let number = format!("{chapter}.{figure}");
            assert!(shown.contains(&number.as_str()), "Figure {number} is missing");
        }
    }
}

#[test]
fn what_the_slips_did_shows_beside_the_other_editions() {
    let (all, _) = chapters(&REPRODUCED, 2, None).unwrap();
    let unaccounted: Vec<f64> = all.iter().map(|chapters| chapters.base.result.energy.closure.unwrap()).collect();
    let [published, thesis, consistent] = unaccounted[..] else { panic!("three editions were asked for") };
    assert!(published > 0.05 && thesis.abs() < 0.01 && consistent.abs() < 1e-6, "{unaccounted:?}");
    let reproduction = Reproduction::new(all, String::new()).unwrap();
    let text = reproduction.markdown();
    for said in ["| published | thesis | consistent |", "183.4 ± 0.1 deg", "| unaccounted for |"] {
        assert!(text.contains(said), "{said}: {text}");
    }
    // The thesis's statements are not all true of its model done right, and then it is said how often not.
    assert!(text.contains("not at"), "{text}");
}

fn reproduce(folder: &Path, jobs: &str) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    command.args(["reproduce", "--points", "2", "--jobs", jobs, "--out", folder.to_str().unwrap()]);
    let output = command.env_remove("RUST_LOG").output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert!(output.stderr.is_empty(), "{output:?}");
}

#[test]
fn the_command_writes_figures_tables_and_verdicts_whatever_the_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let [one, two] = ["1", "2"].map(|jobs| folder.path().join(jobs));
    reproduce(&one, "1");
    reproduce(&two, "2");
    let verdicts: Value = serde_json::from_slice(&std::fs::read(one.join("verdicts.json")).unwrap()).unwrap();
    for edition in ["published", "thesis", "consistent"] {
        assert!(verdicts[edition].as_array().unwrap().len() >= 51);
        let mut files = 0;
        for entry in std::fs::read_dir(one.join(edition)).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            let other = std::fs::read(two.join(edition).join(name)).unwrap();
            // A result says how long it took.
            assert!(name == "base.json" || std::fs::read(&path).unwrap() == other, "{edition}/{name}");
            files += 1;
        }
        assert!(files > 80, "{files} files of {edition}");
    }
    let page = std::fs::read_to_string(one.join("report.html")).unwrap();
    assert!(page.matches("<svg").count() > 110 && page.ends_with("</html>\n"));
}
