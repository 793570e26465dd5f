//! Texts and bytes of every kind that is read, made at random: nothing may panic, hang, or be believed that is damaged.
//!
//! `SHEAVE_FUZZ=30000 cargo test --test fuzz` tries that many of each; few by default.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use proptest::prelude::*;
use sheave::case::{Case, TABLE};
use sheave::drive::SolveOptions;
use sheave::quantity;
use sheave::small::size::BeltDrive;
use sheave::study::{Axis, Journal, Study, StudyFile, table};
use std::sync::OnceLock;

fn cases() -> ProptestConfig {
    let cases = std::env::var("SHEAVE_FUZZ").ok().and_then(|text| text.parse().ok()).unwrap_or(250);
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Pieces of which files and arguments are made, and pieces that do not belong.
fn piece() -> impl Strategy<Value = String> {
    let key = (0..TABLE.len()).prop_map(|at| TABLE[at].name().to_owned());
    let path = (0..TABLE.len()).prop_map(|at| TABLE[at].path.to_owned());
    let section =
        prop::sample::select(vec!["[belt]", "[sheave]", "[drive]", "[operating_point]", "[model]", "[sweep]"]);
    let value = prop_oneof![
        "[-+]?[0-9]{1,3}(\\.[0-9]{1,3})?(e[-+]?[0-9]{1,3})?",
        "\"[-+]?[0-9.]{1,6} ?(mm|N|N\\*m|rpm|kN|deg|lb|%|ft-lb|Nm²|1/s|m\\^2|1)\"",
        Just("\"both\"".to_owned()),
        Just("nan".to_owned()),
        Just("1e308".to_owned()),
    ];
    let odd = prop_oneof![
        prop::sample::select(vec![
            "\u{feff}",
            "\u{1b}[31m",
            "\u{202e}",
            "\0",
            "\"",
            "'''",
            "[[",
            "{",
            "}",
            "#",
            "\\u0000"
        ])
        .prop_map(str::to_owned),
        ".{0,8}",
    ];
    prop_oneof![
        6 => (key, value.clone()).prop_map(|(key, value)| format!("{key} = {value}\n")),
        3 => (path, value).prop_map(|(path, value)| format!("{path}={value}")),
        5 => section.prop_map(|section| format!("\n{section}\n")),
        2 => Just("over = [\"drive.ratio = 0.8..1.2 : 3\"]\n".to_owned()),
        1 => Just("\n".to_owned()),
        2 => odd,
    ]
}

fn text() -> impl Strategy<Value = String> {
    prop::collection::vec(piece(), 0..12).prop_map(|pieces| pieces.concat())
}

/// What is shown of an error, as a terminal would have it.
fn shown(error: impl miette::Diagnostic + Send + Sync + 'static) {
    let text = format!("{:?}", miette::Report::new(error));
    assert!(!text.contains("\u{1b}]") && !text.contains('\u{7}') && !text.contains('\u{202e}'), "{text:?}");
}

fn study() -> Study {
    let axes = [Axis::parse("drive.ratio=0.9..1.1:4").unwrap()];
    Study::new(Case::base(), axes, SolveOptions { tolerance: 1e-1, ..SolveOptions::default() }).unwrap()
}

/// A journal with all rows of the study, solved once.
fn journal() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| {
        let (folder, study) = (tempfile::tempdir().unwrap(), study());
        let path = folder.path().join("journal");
        let (mut journal, _) = Journal::begin(&path, &study).unwrap();
        let table = table(&study, Some(1)).unwrap();
        for (index, cells) in table.rows.iter().enumerate() {
            let row = sheave::study::Row { index, columns: table.columns.clone(), cells: cells.clone() };
            journal.add(row).unwrap();
        }
        drop(journal);
        std::fs::read(path).unwrap()
    })
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn case_files(text in text(), setting in piece()) {
        match Case::from_toml("fuzz.toml", &text) {
            Ok(mut case) => {
                let _ = case.assign(&setting);
                match case.resolve() {
                    Ok(resolved) => {
                        if let Err(error) = case.check_posed(&resolved) {
                            shown(error);
                        }
                    }
                    Err(error) => shown(error),
                }
                let _ = case.remarks();
            }
            Err(error) => shown(error),
        }
    }

    #[test]
    fn settings(key in "[a-z_.]{0,30}", value in ".{0,40}", swap in ".{0,40}") {
        let mut case = Case::base();
        if let Err(error) = case.set(&key, &value) {
            shown(error);
        }
        if let Err(error) = case.swap(&swap) {
            shown(error);
        }
        if let Err(error) = case.unset(&value) {
            shown(error);
        }
    }

    #[test]
    fn study_files(text in text()) {
        if let Ok(file) = StudyFile::from_toml("fuzz.toml", &text) {
            let _ = Study::new(file.case, file.axes, SolveOptions::default());
        }
    }

    #[test]
    fn axes(text in "(drive\\.ratio|edition|belt\\.length)?=?[-0-9.,:& a-zµ\"]{0,30}", any in ".{0,60}") {
        let _ = Axis::parse(&text);
        let _ = Axis::parse(&any);
    }

    #[test]
    fn quantities(text in "[-+0-9.eE]{0,8} ?[a-zA-Zµ°·%*/^()⁻²³ 0-9-]{0,16}", any in ".{0,40}") {
        if let Ok(quantity) = quantity::parse(&text) {
            assert!(quantity.si.is_finite());
        }
        let _ = quantity::parse(&any);
    }

    #[test]
    fn drives_to_size(text in text(), number in any::<f64>()) {
        let _ = BeltDrive::from_toml("fuzz.toml", &text);
        let text = format!("[input]\ndiameter = \"{number:e} mm\"\n[linear]\nmass = \"{number:e} kg\"\n");
        if let Ok(drive) = BeltDrive::from_toml("fuzz.toml",
            &text) && let Ok(sizing) = sheave::small::size::size(&drive) {
            assert!(sizing.torque.drive.is_finite() && sizing.inertia.total.is_finite());
        }
    }

    #[test]
    fn journals(edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..3_u8), 1..6)) {
        let (folder, study) = (tempfile::tempdir().unwrap(), study());
        let path = folder.path().join("journal");
        let mut bytes = journal().to_vec();
        for (at, byte, kind) in edits {
            let at = at.index(bytes.len().max(1));
            match kind {
                _ if bytes.is_empty() => {}
                0 => bytes[at] = byte,
                1 => bytes.truncate(at),
                _ => bytes.insert(at, byte),
            }
        }
        std::fs::write(&path, &bytes).unwrap();
        match Journal::resume(&path, &study) {
            Ok(damaged) => {
                // What is believed is what was written.
                let stored = damaged.finish().unwrap();
                let sound = String::from_utf8_lossy(journal()).into_owned();
                sheave::study::Rows::each(&stored, &mut |cells| {
                    let force = cells.iter().find_map(sheave::study::Cell::number).unwrap();
                    assert!(sound.contains(&format!("[{force},")) || sound.contains(&format!("[{force:?},")),
                        "{cells:?}");
                    Ok(())
                }).unwrap();
            }
            Err(_) => assert!(std::fs::read(&path).unwrap() == bytes, "a file that was refused was changed"),
        }
    }
}
