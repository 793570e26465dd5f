//! The committed copy is what comes out today, on every run.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;

#[test]
fn golden_copy_is_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/golden");
    let files = eqgen::generate().unwrap();
    assert_eq!(files, eqgen::generate().unwrap(), "two runs differ");
    for file in &files {
        let committed = std::fs::read_to_string(folder.join(&file.name)).unwrap_or_default();
        assert!(
            committed == file.text,
            "generated/golden/{} is out of date; write it anew with: cargo run -p sheave-eqgen -- write",
            file.name
        );
    }
    let mut names: Vec<_> = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    let mut expected: Vec<_> = files.iter().map(|file| std::ffi::OsString::from(&file.name)).collect();
    expected.sort();
    assert_eq!(names, expected, "generated/golden holds a file that nothing generates");
}

/// What the kernels cost: a change that makes one dearer shows in review.
#[test]
fn operation_counts() {
    let counts = |file: &eqgen::SourceFile| {
        let lines =
            file.text.lines().take_while(|line| line.starts_with("//")).filter(|line| line.starts_with("//   "));
        let lines: Vec<String> = lines.map(|line| line.replacen("//   ", "    ", 1)).collect();
        (!lines.is_empty()).then(|| format!("{}\n{}\n", file.name, lines.join("\n")))
    };
    let all: String = eqgen::generate().unwrap().iter().filter_map(counts).collect();
    insta::assert_snapshot!(all);
}
