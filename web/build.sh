#!/usr/bin/env bash
# The page: web/dist, static files that any web server serves. Needs Rust for wasm32-unknown-unknown
# (scripts/wasm-cargo.sh says how) and nothing else.
set -euo pipefail
cd "$(dirname "$0")"

# Two numbers at a time: every browser that has WebAssembly has had these instructions since 2023.
export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS="-C target-feature=+simd128" TARGET_DIR=target
(cd wasm && ../../scripts/wasm-cargo.sh build --release --locked "$@")
module=$(ls -t wasm/target*/wasm32-unknown-unknown/release/sheave_page.wasm | head -1)

rm -rf dist.part
mkdir dist.part
cp page/* ../LICENSE-MIT ../LICENSE-APACHE dist.part/
rm dist.part/live-engine.js
cp "$module" dist.part/sheave.wasm
version=$(cat dist.part/* | sha256sum | cut -c1-16)
sed -i "s/const VERSION = \"development\";/const VERSION = \"sheave-$version\";/" dist.part/sw.js
grep -q "sheave-$version" dist.part/sw.js
rm -rf dist
mv dist.part dist
echo "web/dist: module of $(wc -c < dist/sheave.wasm) bytes, $(gzip -9 -c dist/sheave.wasm | wc -c) compressed;" \
  "version $version"
