//! Compiles the small C layer over simavr and links Debian's library (packages libsimavr-dev, simavr).

fn main() {
    println!("cargo:rerun-if-changed=src/chip.c");
    cc::Build::new().file("src/chip.c").flag("-std=gnu11").warnings(true).compile("chip");
    println!("cargo:rustc-link-lib=simavr");
}
