#!/usr/bin/env bash
# cargo for the browser (wasm32-unknown-unknown): scripts/wasm-cargo.sh SUBCOMMAND ARGUMENTS... With the target
# installed (rustup target add wasm32-unknown-unknown) in the ordinary way; otherwise with Debian's rustc-web and
# rust-web-src, which build the standard library from its source. TARGET_DIR is where it builds, `target/wasm` if it
# is not set; the two ways differ in the compiler and do not share a directory.
set -euo pipefail
target=wasm32-unknown-unknown
subcommand=$1
shift
folder=${TARGET_DIR:-target/wasm}
if [ -d "$(rustc --print sysroot)/lib/rustlib/$target/lib" ]; then
  exec cargo "$subcommand" --target "$target" --target-dir "$folder" "$@"
fi
if dpkg -L rustc-web cargo-web rust-web-src >/dev/null 2>&1; then
  linker=$(rustup run stable rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld
  RUSTC=$(dpkg -L rustc-web | grep 'bin/rustc$')
  cargo=$(dpkg -L cargo-web | grep '^.usr.bin.cargo$')
  export RUSTC RUSTC_BOOTSTRAP=1 CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=$linker
  exec "$cargo" "$subcommand" -Z build-std=std,panic_abort --target "$target" --target-dir "$folder-debian" "$@"
fi
echo "there is no $target here: rustup target add $target, or on Debian" \
  "apt-get install rustc-web cargo-web rust-web-src" >&2
exit 1
