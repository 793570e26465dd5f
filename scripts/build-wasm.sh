#!/usr/bin/env bash
# The lean library for the browser (wasm32-unknown-unknown), see scripts/wasm-cargo.sh. The page has a build of its own:
# web/build.sh.
set -euo pipefail
cd "$(dirname "$0")/.."
exec scripts/wasm-cargo.sh build --release --lib -p sheave --no-default-features --locked "$@"
