"""What a call costs beside the library alone. Numbers are compared in turns, so that other load counts for both."""

import statistics
import time

import pytest

import sheave
from sheave._sheave import bare_seconds


def differences(repeats: int, tolerance: float) -> list[float]:
    """Seconds that a call takes above the bare library, in turns; each pair one after the other."""
    case = sheave.Case(slack_tension="120 N")
    found = []
    for _ in range(repeats):
        (bare,) = bare_seconds(case, 1, tolerance)
        start = time.perf_counter()
        sheave.solve(case, tolerance=tolerance)
        found.append(time.perf_counter() - start - bare)
    return found


@pytest.mark.skipif("not config.getoption('--measure')")
def test_a_call_costs_little_more_than_the_library() -> None:
    differences(20, 1e-2)
    found = differences(300, 1e-2)
    median = statistics.median(found)
    print(f"median of {len(found)} differences: {1e6 * median:.0f} µs")
    assert median < 50e-6
