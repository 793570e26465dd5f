//! The example that is no belt: its committed kernels are what its equations give, and no symbol of the belt is in
//! them.
#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "../examples/elastica/equations.rs"]
mod equations;

use eqgen::plan::Plan;
use eqgen::{Error, symbolic};

#[test]
fn committed_kernels_are_current() {
    let files = equations::files().unwrap();
    assert_eq!(files.len(), 3);
    for file in files {
        let path = format!("{}/examples/elastica/{}", env!("CARGO_MANIFEST_DIR"), file.name);
        let advice = "write it anew with: cargo run -p sheave-eqgen --example elastica_write";
        assert!(std::fs::read_to_string(&path).unwrap() == file.text, "{path} is out of date; {advice}");
    }
}

#[test]
fn a_notation_of_its_own_knows_no_belt() {
    let refused = symbolic(|| Plan::in_notation_of(&["T_slack"], Vec::new()).map(|_| ())).unwrap();
    assert!(matches!(refused, Err(Error::UnknownSymbol { symbol, .. }) if symbol == "T_slack"));
}
