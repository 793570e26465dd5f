//! The report as a browser shows it. Skipped where there is no Chromium.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The browser, by its usual names, or as the environment variable CHROMIUM says.
fn browser() -> Option<PathBuf> {
    let given = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let folders: Vec<PathBuf> = std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()).collect();
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    let usual = names.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    given.into_iter().chain(usual).find(|path| path.is_file() && runs(path))
}

/// Whether the browser opens anything at all here.
fn runs(browser: &Path) -> bool {
    let profile = tempfile::tempdir().unwrap();
    let mut command = headless(browser, profile.path());
    command
        .args(["--dump-dom", "data:text/html,<p>here</p>"])
        .output()
        .is_ok_and(|output| output.status.success() && !output.stdout.is_empty())
}

/// A browser without a window, with a profile of its own.
fn headless(browser: &Path, profile: &Path) -> Command {
    let mut command = Command::new(browser);
    command.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"]);
    command.arg(format!("--user-data-dir={}", profile.display()));
    command
}

/// Opens a page without a network; what the browser says, the page's console included, is on standard error.
fn open(browser: &Path, profile: &Path, page: &Path, arguments: &[String]) -> Output {
    let mut command = headless(browser, profile);
    command.args(["--hide-scrollbars", "--window-size=1280,3000"]);
    command.args(["--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr"]).args(arguments);
    command.arg(format!("file://{}", page.display())).output().unwrap()
}

fn console(output: &Output) -> Vec<String> {
    let said = String::from_utf8_lossy(&output.stderr);
    said.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect()
}

/// Width and height of a PNG.
fn size(png: &[u8]) -> (u32, u32) {
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn the_report_opens_offline_with_all_figures_and_without_complaints() {
    let Some(browser) = browser() else {
        eprintln!("skipped: no Chromium that runs on this machine");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let profile = folder.path().join("profile");
    let results = folder.path().join("results");
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    let solved = command.args(["solve", "--tol", "1e-3", "--out", results.to_str().unwrap()]).output().unwrap();
    assert!(solved.status.success(), "{solved:?}");
    let page = results.join("report.html");

    let picture = folder.path().join("report.png");
    let shot = open(&browser, &profile, &page, &[format!("--screenshot={}", picture.display())]);
    assert_eq!(console(&shot), Vec::<String>::new());
    let picture = std::fs::read(picture).unwrap();
    assert_eq!(size(&picture), (1280, 3000));
    // Not an empty page: that would be a tenth of it.
    assert!(picture.len() > 100_000, "{} bytes", picture.len());

    let dom = open(&browser, &profile, &page, &["--dump-dom".to_owned()]);
    let dom = String::from_utf8(dom.stdout).unwrap();
    let figures = std::fs::read_dir(&results)
        .unwrap()
        .filter(|entry| entry.as_ref().unwrap().path().extension().is_some_and(|extension| extension == "svg"));
    let figures = figures.count();
    assert!(figures >= 11);
    assert_eq!(dom.matches("<svg").count(), figures);
    assert_eq!(dom.matches("<figcaption>").count(), figures);
    for link in dom.split("href=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
        let target = link.strip_prefix('#').map(|id| dom.contains(&format!("id=\"{id}\"")));
        assert!(link == "data:," || target == Some(true), "{link} leads nowhere");
    }

    // A page that does complain is noticed.
    let bad = folder.path().join("bad.html");
    std::fs::write(&bad, "<script>console.error('no')</script>").unwrap();
    let said = open(&browser, &profile, &bad, &["--dump-dom".to_owned()]);
    assert_eq!(console(&said).len(), 1, "{said:?}");
}
