"""What a call costs beside the library alone.

Of both, the time from the resolved case to the result is taken off, which the library measures itself; what is left is
the same work each time, so that the least of many is what it costs, whatever else the machine does.
"""

import time

import pytest

import sheave
from sheave._sheave import bare_seconds

REPEATS = 400


def least_overheads() -> tuple[float, float]:
    """Seconds beside the solution itself, by the library alone and by a call: the least of many, in turns."""
    case, bare, called = sheave.Case(slack_tension="120 N"), [], []
    near = sheave.solve(case, tolerance=1e-1)
    for _ in range(REPEATS):
        ((seconds, solving),) = bare_seconds(case, near, 1, 1e-1)
        bare.append(seconds - solving)
        start = time.perf_counter()
        result = sheave.solve(case, tolerance=1e-1, near=near)
        seconds = time.perf_counter() - start
        assert result.solver.wall_time is not None
        called.append(seconds - result.solver.wall_time)
    return min(bare), min(called)


@pytest.mark.skipif("not config.getoption('--measure')")
def test_a_call_costs_little_more_than_the_library() -> None:
    bare, called = least_overheads()
    print(f"beside the solution: {1e6 * bare:.1f} µs by the library, {1e6 * called:.1f} µs by a call")
    assert called - bare < 50e-6
