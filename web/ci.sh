#!/usr/bin/env bash
# Everything of the page: its module, `sheave live`, formatting and clippy of both, the module against the native
# program, and the page in Chromium. Needs Rust, Node.js 20 or later with npm, Chromium, and for wasm32 what
# scripts/wasm-cargo.sh says; what is missing is installed where apt-get may be used, and is an error otherwise.
# npm's packages are those of package-lock.json.
set -euo pipefail
cd "$(dirname "$0")"

missing=()
command -v node >/dev/null || missing+=(nodejs)
command -v npm >/dev/null || missing+=(npm)
[ -n "${CHROMIUM:-}" ] || command -v chromium >/dev/null || command -v google-chrome >/dev/null || missing+=(chromium)
[ -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown/lib" ] \
  || dpkg -s rustc-web cargo-web rust-web-src >/dev/null 2>&1 || missing+=(rustc-web cargo-web rust-web-src)
if [ "${#missing[@]}" -gt 0 ]; then
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    apt-get update -qq && apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
  else
    echo "missing: ${missing[*]} (apt-get install ${missing[*]})" >&2
    exit 1
  fi
fi
major=$(node --print 'process.versions.node.split(".")[0]')
[ "$major" -ge 20 ] || { echo "Node.js $major is too old: 20 or later is needed" >&2; exit 1; }

(cd wasm && cargo fmt --check && cargo clippy --locked --target-dir ../../target/golden -- -D warnings)
(cd lanes && cargo fmt --check)
./build.sh
lanes/build.sh

# The command with `live`, from the committed equations; what else is built from these shares its packages. Without the
# feature `faer`, as the module is built: its factorisation of the small dense system rounds otherwise, and the tests
# ask for the same iterations and the same bits.
features=(--no-default-features --features live --locked --target-dir target/golden)
# The tests build the program; built on its own, it would have the packages compiled with other features once more.
(cd .. && cargo clippy "${features[@]}" --all-targets -- -D warnings \
  && cargo test "${features[@]}" --test live --test live_server)

npm ci --silent --no-audit --no-fund
npx prettier --check "page/*.{js,css,html}" "tests/*.mjs"
SHEAVE="$(dirname "$PWD")/target/golden/debug/sheave" npm test
head -n 1 shots/cases.md
