#!/usr/bin/env bash
# The module of the lanes' test: web/lanes/lanes.wasm.
set -euo pipefail
cd "$(dirname "$0")"
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128" TARGET_DIR=../wasm/target
../../scripts/wasm-cargo.sh build --release --locked "$@"
cp "$(ls -t ../wasm/target*/wasm32-unknown-unknown/release/sheave_lanes.wasm | head -1)" lanes.wasm
