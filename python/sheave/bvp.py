"""Boundary value problems written in Python, solved by sheave's collocation.

``y' = f(x, y, p)`` on ``[a, b]`` with ``bc(y(a), y(b), p) = 0``. Functions are those of ``scipy.integrate.solve_bvp``:
``f(x, y)`` takes all points at once, ``x`` of shape (m,) and ``y`` of shape (n, m), and gives an array of shape (n, m);
with unknown parameters both functions take ``p`` of shape (k,) as well, and ``bc`` gives n + k residuals.

Bratu's problem ``u'' = -exp(u)``, ``u(0) = u(1) = 0``:

>>> import numpy as np
>>> from sheave import bvp
>>> x = np.linspace(0, 1, 11)
>>> solution = bvp.solve(lambda x, y: np.vstack((y[1], -np.exp(y[0]))), lambda a, b: np.array([a[0], b[0]]),
...                      x, np.zeros((2, x.size)))
>>> round(float(solution.sol(0.5)[0]), 6)
0.140539
"""

from __future__ import annotations

import math
import operator
import sys
from collections.abc import Callable
from typing import Any, Literal, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._sheave import BvpSolution, solve_bvp

__all__ = ["Solution", "complex_step", "solve"]

Array = NDArray[np.float64]


class Solution:
    """The solution of a boundary value problem; the names are those of SciPy's ``BVPResult`` where it has them."""

    success = True
    """Always: where there is no solution, ``solve`` raises ``SolveError``."""
    status = 0
    message = "Defects, boundary residuals and the estimated error meet the tolerance."

    def __init__(self, found: BvpSolution) -> None:
        self._found = found

    def sol(self, x: ArrayLike) -> Array:
        """States at ``x`` by the continuous extension: shape (n,) for a number, (n,) + x.shape for an array."""
        places = np.asarray(x, dtype=np.float64)
        values = np.asarray(self._found.evaluate(places.ravel().tolist()))
        return values.reshape((values.shape[0], *places.shape))

    @property
    def x(self) -> Array:
        """Nodes of the final mesh, shape (m,)."""
        return self._found.x

    @property
    def y(self) -> Array:
        """States at the nodes, shape (n, m)."""
        return self._found.y

    @property
    def yp(self) -> Array:
        """Derivatives of the states at the nodes, shape (n, m)."""
        return self._found.yp

    @property
    def p(self) -> Optional[Array]:
        """Parameters found, shape (k,); None without parameters."""
        return self._found.p

    @property
    def niter(self) -> int:
        """Newton iterations in all."""
        return self._found.niter

    @property
    def meshes(self) -> int:
        """Number of meshes that it took."""
        return self._found.meshes

    @property
    def evaluations(self) -> int:
        """Points at which the right-hand side was evaluated for its own sake or for its derivatives."""
        return self._found.evaluations

    @property
    def max_defect(self) -> float:
        """Largest relative defect on the final mesh."""
        return self._found.max_defect

    @property
    def max_boundary_residual(self) -> float:
        """Largest boundary residual, relative to the largest term of its equation."""
        return self._found.max_boundary_residual

    @property
    def error_estimate(self) -> float:
        """Estimated true error at the nodes and in the parameters, relative to typical magnitudes."""
        return self._found.error_estimate

    def __repr__(self) -> str:
        n, m = self.y.shape
        return f"<sheave.bvp.Solution: {n} states at {m} nodes, estimated error {self.error_estimate:.1e}>"


def solve(
    f: Callable[..., ArrayLike],
    bc: Callable[..., ArrayLike],
    mesh: ArrayLike,
    guess: ArrayLike,
    parameters: Optional[ArrayLike] = None,
    *,
    jacobian: Union[Callable[..., Any], str, None] = None,
    boundary_jacobian: Optional[Callable[..., Any]] = None,
    tol: float = 1e-6,
    bc_tol: Optional[float] = None,
    order: Union[int, Literal["gauss"]] = 4,
    max_nodes: int = 20_000,
    work_limit: Optional[int] = None,
) -> Solution:
    """Solves a boundary value problem.

    ``mesh`` is the first mesh, shape (m,), whose ends are the interval; ``guess`` the states on it, shape (n, m);
    ``parameters`` a guess of the unknown parameters, shape (k,). ``tol`` bounds the relative defect and the estimated
    error (SciPy's bounds the defect alone, and is 1e-3 unless it is said), ``bc_tol`` the boundary residuals, ``order``
    is that of the collocation, 4, 6 or 8, ``max_nodes`` limits the mesh and ``work_limit`` the evaluations in all.

    ``order="gauss"`` collocates at three Gauss points, which is of order 6. With it, and with order 8, what ``f`` gives
    at the ends of the interval may be NaN or infinite: there an equation may be singular, as with ``2*u'/x`` at 0.

    ``jacobian(x, y[, p])`` gives df/dy of shape (n, n, m), with parameters a pair of it and df/dp of shape (n, k, m);
    ``boundary_jacobian(ya, yb[, p])`` gives dbc/dya, dbc/dyb of shape (n + k, n) and with parameters dbc/dp of shape (n
    + k, k): SciPy's ``fun_jac`` and ``bc_jac``. ``jacobian="complex"`` differentiates ``f`` by the complex step, which
    is exact where ``f`` is analytic and takes complex arrays; without either, forward differences are taken.

    What the functions raise is raised here. Raises ``SolveError`` with what to try where there is no solution, and
    ``ValueError`` for a mesh, a guess, tolerances and limits that are none.
    """
    for name, given in (("mesh", mesh), ("guess", guess), ("parameters", parameters)):
        if given is not None and np.iscomplexobj(given):
            raise TypeError(f"{name} is complex: expected real numbers; state real and imaginary parts as states")
    nodes = np.ascontiguousarray(mesh, dtype=np.float64)
    states = np.array(guess, dtype=np.float64)
    if nodes.ndim != 1 or nodes.size < 2:
        raise ValueError(f"mesh: expected an array of at least two nodes, not one of shape {nodes.shape}")
    if states.ndim != 2 or states.shape[1] != nodes.size or states.shape[0] == 0:
        raise ValueError(f"guess: expected an array of shape (n, {nodes.size}), not one of shape {states.shape}")
    for name, numbers in (("mesh", nodes), ("guess", states)):
        if not np.all(np.isfinite(numbers)):
            raise ValueError(f"{name}: expected finite numbers")
    if not np.all(np.diff(nodes) > 0):
        raise ValueError("mesh: expected nodes that increase")
    _check_positive("tol", tol)
    if bc_tol is not None:
        _check_positive("bc_tol", bc_tol)
    _check_at_least("max_nodes", max_nodes, 2)
    if work_limit is not None:
        _check_at_least("work_limit", work_limit, 1)
    unknowns = np.zeros(0) if parameters is None else np.array(parameters, dtype=np.float64)
    if unknowns.ndim != 1:
        raise ValueError(f"parameters: expected an array of shape (k,), not one of shape {unknowns.shape}")
    if isinstance(jacobian, str):
        if jacobian != "complex":
            raise ValueError(f'jacobian = "{jacobian}": expected a function, "complex" or None')
        jacobian = complex_step(f)
    found = solve_bvp(
        f,
        bc,
        nodes.tolist(),
        states.tolist(),
        unknowns.tolist(),
        jacobian,
        boundary_jacobian,
        tol,
        bc_tol,
        str(order),
        max_nodes - 1,
        work_limit,
    )
    return Solution(found)


def _check_positive(name: str, given: float) -> None:
    expected = f"{name} = {given!r}: expected a positive number"
    if isinstance(given, (str, bytes, bool, np.bool_)):
        raise TypeError(expected)
    try:
        number = float(given)
    except (TypeError, ValueError):
        raise TypeError(expected) from None
    if not 0 < number < math.inf:
        raise ValueError(expected)


def _check_at_least(name: str, given: int, least: int) -> None:
    expected = f"{name} = {given!r}: expected a whole number from {least} on"
    try:
        number = operator.index(given)
    except TypeError:
        raise TypeError(expected) from None
    if number < least:
        raise ValueError(expected)
    if number > sys.maxsize:
        raise ValueError(f"{name} = {given!r}: expected a whole number up to {sys.maxsize}")


def complex_step(f: Callable[..., ArrayLike]) -> Callable[..., Any]:
    """The Jacobian of ``f`` by the complex step: df/dy = Im f(y + i h)/h with h so small that nothing is lost.

    ``f`` must be analytic, and must not take real parts or absolute values; its result is complex where states are.
    """
    h = 1e-200

    def column(*arguments: Any) -> Array:
        values = np.asarray(f(*arguments))
        if not np.iscomplexobj(values):
            raise TypeError(
                "f returned real numbers for complex states, of which no derivatives can be told: "
                "make its result with the states' type, as np.empty_like(y) does"
            )
        return np.imag(values) / h

    def jacobian(x: Array, y: Array, *p: Array) -> Any:
        n = y.shape[0]
        by_states = np.empty((n, n, x.size))
        for j in range(n):
            moved = y.astype(np.complex128)
            moved[j] += 1j * h
            by_states[:, j] = column(x, moved, *p)
        if not p:
            return by_states
        (values,) = p
        by_parameters = np.empty((n, values.size, x.size))
        for j in range(values.size):
            shifted = values.astype(np.complex128)
            shifted[j] += 1j * h
            by_parameters[:, j] = column(x, y.astype(np.complex128), shifted)
        return by_states, by_parameters

    return jacobian
