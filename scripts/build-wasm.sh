#!/usr/bin/env bash
# The library for the browser (wasm32-unknown-unknown). With the target installed (rustup target add wasm32-unknown-unknown)
# in the ordinary way; otherwise with Debian's rustc-web and rust-web-src, which build the standard library from its source.
set -euo pipefail
cd "$(dirname "$0")/.."
target=wasm32-unknown-unknown
arguments=(build --release --lib -p sheave --no-default-features --target "$target" --locked)
if [ -d "$(rustc --print sysroot)/lib/rustlib/$target/lib" ]; then
  exec cargo "${arguments[@]}" --target-dir target/wasm "$@"
fi
if dpkg -L rustc-web >/dev/null 2>&1 && dpkg -L rust-web-src >/dev/null 2>&1; then
  linker=$(rustup run stable rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld
  RUSTC=$(dpkg -L rustc-web | grep 'bin/rustc$')
  cargo=$(dpkg -L cargo-web | grep '^.usr.bin.cargo$')
  export RUSTC RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker
  exec "$cargo" "${arguments[@]}" -Z build-std=std,panic_abort --target-dir target/wasm-debian "$@"
fi
echo "there is no $target here: rustup target add $target, or on Debian apt-get install rustc-web rust-web-src" >&2
exit 1
