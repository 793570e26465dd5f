from pathlib import Path

import pytest

import sheave

ROOT = Path(__file__).resolve().parents[2]
"""The project's folder: its examples are cases of these tests."""


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def base() -> sheave.Result:
    """The base case with its sensitivities."""
    return sheave.solve(tolerance=1e-4, sensitivities=True)
