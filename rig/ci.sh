#!/usr/bin/env bash
# Everything of the rig: host tests, firmware, the firmware's binary in simavr with its error tables, clippy,
# formatting, and, where the program `sheave` has been built (or is named by SHEAVE), the way from a simulated run to
# the model. Needs Rust and, from Debian, gcc-avr avr-libc libsimavr-dev simavr, and rustc-web cargo-web rust-web-src
# where no nightly Rust with its library's sources is installed; what is missing is installed where apt-get may be used,
# and is an error otherwise.
set -euo pipefail
cd "$(dirname "$0")"

missing=()
command -v avr-gcc >/dev/null || missing+=(gcc-avr avr-libc)
[ -f /usr/include/simavr/sim_avr.h ] || missing+=(libsimavr-dev simavr)
# A nightly Rust is of use only with its library's sources: build-firmware.sh asks the same.
{ nightly=$(rustup run nightly rustc --print sysroot 2>/dev/null) \
    && [ -d "$nightly/lib/rustlib/src/rust/library/core" ]; } \
  || dpkg -s rustc-web cargo-web rust-web-src >/dev/null 2>&1 || missing+=(rustc-web cargo-web rust-web-src)
if [ "${#missing[@]}" -gt 0 ]; then
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq && apt-get install -y -qq "${missing[@]}" >/dev/null
  else
    echo "missing: ${missing[*]} (apt-get install ${missing[*]})" >&2
    exit 1
  fi
fi

cargo fmt --all --check
(cd firmware && cargo fmt --check)
cargo clippy --workspace --all-targets --all-features --locked -- -D warnings
cargo test --locked --features rig-logger/linux
firmware=$(./build-firmware.sh)
# Larger stack frames are addressed by code that changes the flags between a comparison and its branch.
if avr-objdump -d "$firmware" | grep -qE 'subi\s+r28'; then
  echo "the firmware has a stack frame of more than 63 bytes: compose in place instead" >&2
  exit 1
fi
avr-size "$firmware"
cargo test --locked -p rig-simulator
cat target/simavr-speed.md target/simavr-latency.md target/simavr-step.md target/faults.md
# A program that is named must be there; one that merely happens not to be built yet is said to be missing.
if [ -n "${SHEAVE:-}" ]; then
  ./closed-loop.sh "$SHEAVE"
elif [ -x ../target/debug/sheave ]; then
  ./closed-loop.sh "$(dirname "$PWD")/target/debug/sheave"
else
  echo "not run: closed-loop.sh, because ../target/debug/sheave is not built and SHEAVE names no other" >&2
fi
