#!/usr/bin/env bash
# The page: web/dist, static files that any web server serves. Needs Rust for wasm32-unknown-unknown (scripts/wasm-cargo.sh says how)
# and nothing else.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128" TARGET_DIR=target
(cd wasm && ../../scripts/wasm-cargo.sh build --release --locked "$@")
