#!/usr/bin/env bash
# The Python package: its wheel, built and installed into a clean environment, its tests, its stubs, its notebooks, its
# page. Needs Rust, a C compiler and Python (3.10 or later) with venv; everything else is installed from PyPI into
# target/venv.
set -euo pipefail
cd "$(dirname "$0")"

python=${PYTHON:-python3}
for tool in cargo "$python"; do
  command -v "$tool" >/dev/null || { echo "missing: $tool" >&2; exit 1; }
done
"$python" -c 'import sys, venv; sys.exit(sys.version_info < (3, 10))' \
  || { echo "missing: Python 3.10 or later with venv" >&2; exit 1; }

cargo fmt --check
# Beside what else is made of the committed equations: most packages are the same.
cargo clippy --locked --all-targets --target-dir ../target/golden -- -D warnings

# Clean: nothing that a developer has installed can stand in for what the package says it needs.
rm -rf target/venv target/wheels
"$python" -m venv target/venv
venv=$PWD/target/venv/bin
"$venv/pip" install --quiet --disable-pip-version-check 'maturin>=1.9,<2'
"$venv/maturin" build --locked --release --out target/wheels --interpreter "$venv/python" --quiet
wheel=$(echo target/wheels/sheave-*.whl)

# With numpy alone, which is all that the package needs.
"$venv/pip" install --quiet "$wheel"
(cd / && "$venv/python" -c 'import sheave; print(sheave.solve(tolerance=1e-3))')

"$venv/pip" install --quiet "$wheel[test]"
"$venv/ruff" check sheave tests notebooks measure.py
"$venv/ruff" format --check sheave tests notebooks measure.py
"$venv/mypy"
# Away from the sources, so that what is installed is what is tested.
(cd target && "$venv/python" -m mypy.stubtest sheave._sheave --allowlist ../tests/stubtest.txt)
"$venv/pytest"
MPLBACKEND=agg "$venv/pytest" --doctest-modules --pyargs sheave
(cd .. && "$venv/python" -m doctest docs/python.md)
"$venv/pytest" --nbmake --nbmake-timeout=600 notebooks
