"""Measures what Python costs: one call beside the library alone, and a sweep beside the command.

    python measure.py [--command ../target/release/sheave] [--points 10000] [--rounds 5] [--jobs 1]

The package and the command have to be of the same sources and of release builds. Other load of the machine is printed
with the figures; both kinds of runs alternate, and the least of each counts.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Optional

import sheave
from sheave._sheave import bare_seconds

LOOSE = 1e-1
"""Tolerance of the solutions of single calls: the less they take, the better shows what is beside them."""


def load() -> str:
    """How much else runs."""
    one, five, _ = os.getloadavg()
    return f"load {one:.1f} (5 minutes: {five:.1f}) on {os.cpu_count()} cores"


def calls(repeats: int) -> tuple[float, float]:
    """Seconds beside the solution itself, by the library alone and by a call: the least of many, in turns.

    Of both, the time from the resolved case to the result is taken off, which the library measures itself; what is left
    is the same work each time.
    """
    case, bare, called = sheave.Case(slack_tension="120 N"), [], []
    near = sheave.solve(case, tolerance=LOOSE)
    result: Optional[sheave.Result]
    for _ in range(repeats):
        ((seconds, solving),) = bare_seconds(case, near, 1, LOOSE)
        bare.append(seconds - solving)
        # Of neither is it counted that a result is given back.
        result = None
        start = time.perf_counter()
        result = sheave.solve(case, tolerance=LOOSE, near=near)
        seconds = time.perf_counter() - start
        assert result.solver.wall_time is not None
        called.append(seconds - result.solver.wall_time)
    return min(bare), min(called)


def sweeps(command: Path, points: int, rounds: int, jobs: int) -> tuple[float, float]:
    """Seconds of a sweep with its table written, by the command and from Python: the least of some, in turns."""
    side = round(points**0.5)
    over = [f"drive.ratio=0.9..1.3:{side}", f"operating_point.slack_tension=90..200 N:{side}"]
    by_command, by_python = [], []
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / name for name in ("command.csv", "python.csv")]
        case = Path(folder) / "case.toml"
        case.write_text("")
        arguments = [str(command), "sweep", str(case), "--tol", "1e-3", "--jobs", str(jobs), "--out", str(paths[0])]
        arguments += [word for axis in over for word in ("--over", axis)]
        for _ in range(rounds):
            for path in paths:
                path.unlink(missing_ok=True)
            start = time.perf_counter()
            subprocess.run(arguments, check=True, stderr=subprocess.DEVNULL)
            by_command.append(time.perf_counter() - start)
            start = time.perf_counter()
            sheave.sweep(case, over=over, tolerance=1e-3, jobs=jobs).write(paths[1])
            by_python.append(time.perf_counter() - start)
            same = paths[0].read_bytes() == paths[1].read_bytes()
            print(f"  command {by_command[-1]:.2f} s, Python {by_python[-1]:.2f} s, same table: {same}; {load()}")
    return min(by_command), min(by_python)


def main() -> None:
    """Measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    root = Path(__file__).resolve().parents[1]
    parser.add_argument("--command", type=Path, default=root / "target" / "release" / "sheave")
    parser.add_argument("--calls", type=int, default=2000)
    parser.add_argument("--points", type=int, default=10_000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    bare, called = calls(given.calls)
    print(
        f"beside the solution: {1e6 * bare:.1f} µs by the library, {1e6 * called:.1f} µs by a call, "
        f"{1e6 * (called - bare):.1f} µs for Python; least of {given.calls}, {load()}"
    )
    if not given.command.exists():
        print(f"no sweep: {given.command} is missing (cargo build --release)", file=sys.stderr)
        return
    by_command, by_python = sweeps(given.command, given.points, given.rounds, given.jobs)
    print(
        f"a sweep of {given.points} points on {given.jobs} threads: {by_command:.2f} s by the command, "
        f"{by_python:.2f} s from Python, {100 * (by_python / by_command - 1):+.1f} %; least of {given.rounds}"
    )


if __name__ == "__main__":
    main()
