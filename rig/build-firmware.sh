#!/usr/bin/env bash
# Builds the firmware for the ATmega328P and prints the path of the program (ELF).
#
# Two ways: nightly Rust with its library sources (rustup toolchain install nightly --component rust-src), or Debian's
# rustc-web, cargo-web and rust-web-src, for machines that reach only package registries. Both link with avr-gcc.
set -euo pipefail
cd "$(dirname "$0")/firmware"
export RUSTFLAGS="-C target-cpu=atmega328p" CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
arguments=(build --release --locked -Z build-std=core --target avr-none)

if ! command -v avr-gcc >/dev/null; then
  echo "avr-gcc is missing, which links the firmware: apt-get install gcc-avr avr-libc" >&2
  exit 1
fi
if command -v rustup >/dev/null && nightly=$(rustup run nightly rustc --print sysroot 2>/dev/null) \
   && [ -d "$nightly/lib/rustlib/src/rust/library/core" ]; then
  rustup run nightly cargo "${arguments[@]}" >&2
elif command -v dpkg >/dev/null && dpkg -s rustc-web cargo-web rust-web-src >/dev/null 2>&1; then
  RUSTC="$(dpkg -L rustc-web | grep 'bin/rustc$')" RUSTC_BOOTSTRAP=1 \
    "$(dpkg -L cargo-web | grep '^/usr/bin/cargo$')" "${arguments[@]}" >&2
else
  echo "No compiler for the ATmega328P was found. Either of these provides one:" >&2
  echo "  rustup toolchain install nightly --component rust-src" >&2
  echo "  apt-get install rustc-web cargo-web rust-web-src  (Debian)" >&2
  exit 1
fi
echo "$CARGO_TARGET_DIR/avr-none/release/rig-firmware.elf"
