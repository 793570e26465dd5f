"""Boundary value problems with functions of Python, beside SciPy and exact solutions."""

from collections.abc import Callable
from typing import Any, Literal, Union

import numpy as np
import pytest
from numpy.typing import NDArray

import sheave
from sheave import bvp

Array = NDArray[np.float64]


def bratu(x: Array, y: Array) -> Array:
    return np.vstack((y[1], -np.exp(y[0])))


def fixed_ends(a: Array, b: Array) -> Array:
    return np.array([a[0], b[0]])


def layer(x: Array, y: Array) -> Array:
    """1e-3 y'' = y, with layers at both ends."""
    return np.vstack((y[1], y[0] / 1e-3))


def ends_of_layer(a: Array, b: Array) -> Array:
    return np.array([a[0] - 1, b[0] - 1])


def eigenvalue(x: Array, y: Array, p: Array) -> Array:
    """Mathieu's equation y'' + (p - 2 q cos 2x) y = 0 with q = 5."""
    return np.vstack((y[1], -(p[0] - 10 * np.cos(2 * x)) * y[0]))


def ends_of_eigenvalue(a: Array, b: Array, p: Array) -> Array:
    return np.array([a[1], b[1], a[0] - 1])


def blasius(x: Array, y: Array) -> Array:
    return np.vstack((y[1], y[2], -0.5 * y[0] * y[2]))


def ends_of_blasius(a: Array, b: Array) -> Array:
    return np.array([a[0], a[1], b[1] - 1])


def flow(x: Array, y: Array) -> Array:
    """A membrane of a swirling flow: three states with products."""
    return np.vstack((y[1], y[2], -y[0] * y[2] + y[1] ** 2 - 0.25))


def ends_of_flow(a: Array, b: Array) -> Array:
    return np.array([a[0], a[1] - 0.1, b[1] - 0.5])


PROBLEMS: dict[str, tuple[Callable[..., Array], Callable[..., Array], float, Array, list[float] | None]] = {
    "Bratu": (bratu, fixed_ends, 1.0, np.zeros(2), None),
    "layers": (layer, ends_of_layer, 1.0, np.zeros(2), None),
    "Mathieu": (eigenvalue, ends_of_eigenvalue, np.pi, np.array([1.0, 0.0]), [15.0]),
    "Blasius": (blasius, ends_of_blasius, 10.0, np.array([5.0, 1.0, 0.1]), None),
    "flow": (flow, ends_of_flow, 5.0, np.array([1.0, 0.5, 0.0]), None),
}


def guess(name: str) -> tuple[Array, Array]:
    _, _, length, start, _ = PROBLEMS[name]
    x = np.linspace(0, length, 31)
    y = np.tile(start[:, None], (1, x.size))
    if name == "Mathieu":
        y[0], y[1] = np.cos(4 * x), -4 * np.sin(4 * x)
    return x, y


@pytest.mark.parametrize("name", PROBLEMS)
def test_solutions_are_those_of_scipy(name: str) -> None:
    integrate = pytest.importorskip("scipy.integrate")
    f, bc, length, _, p = PROBLEMS[name]
    x, y = guess(name)
    theirs = integrate.solve_bvp(f, bc, x, y, p=p, tol=1e-8, max_nodes=200_000)
    assert theirs.success
    places = np.linspace(0, length, 41)
    wanted = theirs.sol(places)
    size = np.max(np.abs(wanted))
    for jacobian in (None, "complex"):
        ours = bvp.solve(f, bc, x, y, p, jacobian=jacobian, tol=1e-7)
        assert ours.success and ours.max_defect <= 1e-7 and ours.error_estimate <= 1e-7
        assert np.max(np.abs(ours.sol(places) - wanted)) < 1e-6 * size
        if p is None:
            assert ours.p is None
        else:
            assert ours.p is not None and ours.p == pytest.approx(theirs.p, rel=1e-7)
        assert ours.y.shape == ours.yp.shape == (len(y), ours.x.size)
        assert np.allclose(ours.sol(ours.x), ours.y)


def test_an_exact_solution_is_met_in_both_orders() -> None:
    x = np.linspace(0, 1, 11)
    places = np.linspace(0, 1, 200)
    s = 1e-3**0.5
    exact = (np.exp(-places / s) + np.exp((places - 1) / s)) / (1 + np.exp(-1 / s))
    nodes = {}
    for order in (4, 6):
        solution = bvp.solve(layer, ends_of_layer, x, np.zeros((2, 11)), order=order, tol=1e-8)
        assert np.max(np.abs(solution.sol(places)[0] - exact)) < 1e-7
        nodes[order] = solution.x.size
    assert nodes[6] < nodes[4]
    assert solution.sol(0.5).shape == (2,) and solution.sol(places.reshape(20, 10)).shape == (2, 20, 10)


def test_an_end_may_be_singular() -> None:
    # Emden's equation u'' + 2 u'/x + u^5 = 0, which is 0/0 at 0: u = (1 + x^2/3)^(-1/2).
    def star(x: Array, y: Array) -> Array:
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.vstack((y[1], -2 * y[1] / x - y[0] ** 5))

    def ends(a: Array, b: Array) -> Array:
        return np.array([a[1], b[0] - 0.75**0.5])

    x = np.linspace(0, 1, 11)
    places = np.linspace(0, 1, 200)
    methods: tuple[Union[int, Literal["gauss"]], ...] = (8, "gauss")
    for order in methods:
        solution = bvp.solve(star, ends, x, np.vstack((np.ones(11), np.zeros(11))), order=order, tol=1e-9)
        assert np.max(np.abs(solution.sol(places)[0] - (1 + places**2 / 3) ** -0.5)) < 1e-9
        assert np.all(np.isfinite(solution.yp))
    with pytest.raises(sheave.SolveError, match="undefined"):
        bvp.solve(star, ends, x, np.ones((2, 11)), order=6)
    with pytest.raises(ValueError, match='4, 6, 8 or "gauss"'):
        bvp.solve(star, ends, x, np.ones((2, 11)), order=5)


def test_jacobians_may_be_given() -> None:
    calls = 0

    def jacobian(x: Array, y: Array, p: Array) -> tuple[Array, Array]:
        nonlocal calls
        calls += 1
        by_states = np.zeros((2, 2, x.size))
        by_states[0, 1] = 1
        by_states[1, 0] = -(p[0] - 10 * np.cos(2 * x))
        by_parameters = np.zeros((2, 1, x.size))
        by_parameters[1, 0] = -y[0]
        return by_states, by_parameters

    def boundary_jacobian(a: Array, b: Array, p: Array) -> tuple[Array, Array, Array]:
        return np.array([[0, 1], [0, 0], [1.0, 0]]), np.array([[0, 0], [0, 1.0], [0, 0]]), np.zeros((3, 1))

    x, y = guess("Mathieu")
    both: dict[str, Any] = {"jacobian": jacobian, "boundary_jacobian": boundary_jacobian}
    given = bvp.solve(eigenvalue, ends_of_eigenvalue, x, y, [15.0], **both)
    assert calls > 0 and given.p is not None
    exact = bvp.solve(eigenvalue, ends_of_eigenvalue, x, y, [15.0], jacobian="complex")
    assert exact.p is not None and given.p[0] == pytest.approx(exact.p[0], rel=1e-9)
    # The fourth characteristic value a_4(5) (Abramowitz & Stegun, 1964, table 20.1).
    assert given.p[0] == pytest.approx(17.09658, abs=1e-4)


def test_a_jacobian_of_sympy_is_one() -> None:
    sympy = pytest.importorskip("sympy")
    u, v = sympy.symbols("u v")
    right = sympy.Matrix([v, -sympy.exp(u)])
    entries = sympy.lambdify((u, v), list(right.jacobian([u, v])), "numpy")

    def jacobian(x: Array, y: Array) -> Array:
        matrix = np.zeros((4, x.size))
        for entry, values in enumerate(entries(y[0], y[1])):
            matrix[entry] = values
        return matrix.reshape(2, 2, x.size)

    x = np.linspace(0, 1, 11)
    solution = bvp.solve(bratu, fixed_ends, x, np.zeros((2, 11)), jacobian=jacobian)
    assert solution.sol(0.5)[0] == pytest.approx(0.14053921, abs=1e-6)


def test_what_the_functions_raise_is_raised() -> None:
    x, y = np.linspace(0, 1, 11), np.zeros((2, 11))

    def broken(x: Array, y: Array) -> Array:
        raise ZeroDivisionError("on purpose")

    with pytest.raises(ZeroDivisionError, match="on purpose"):
        bvp.solve(broken, fixed_ends, x, y)
    with pytest.raises(ZeroDivisionError):
        bvp.solve(bratu, broken, x, y)
    with pytest.raises(ValueError, match=r"f returned an array of shape \[3, "):
        bvp.solve(lambda x, y: np.zeros((3, x.size)), fixed_ends, x, y)
    with pytest.raises(ValueError, match=r"bc returned an array of shape \[3\]"):
        bvp.solve(bratu, lambda a, b: np.zeros(3), x, y)
    with pytest.raises(ValueError, match="boundary_jacobian returned 1 arrays"):
        bvp.solve(bratu, fixed_ends, x, y, boundary_jacobian=lambda a, b: [np.zeros((2, 2))])

    def interrupted(x: Array, y: Array) -> Array:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        bvp.solve(interrupted, fixed_ends, x, y)


def test_what_has_no_solution_says_what_to_try() -> None:
    x = np.linspace(0, 1, 11)
    with pytest.raises(sheave.SolveError) as caught:
        bvp.solve(lambda x, y: np.vstack((y[1], -10 * np.exp(y[0]))), fixed_ends, x, np.zeros((2, 11)))
    assert caught.value.hint
    with pytest.raises(sheave.SolveError, match=r"not finite|undefined"):
        bvp.solve(lambda x, y: np.full((2, x.size), np.nan), fixed_ends, x, np.zeros((2, 11)))


@pytest.mark.parametrize(
    ("mesh", "states", "parameters"),
    [
        ([0.0], np.zeros((2, 1)), None),
        ([], np.zeros((2, 0)), None),
        ([0.0, 1.0], np.zeros((2, 3)), None),
        ([0.0, 1.0], np.zeros(2), None),
        ([0.0, 1.0], np.zeros((0, 2)), None),
        ([1.0, 0.0], np.zeros((2, 2)), None),
        ([0.0, 1.0], np.full((2, 2), np.nan), None),
        ([0.0, 1.0], np.zeros((2, 2)), [[1.0]]),
    ],
)
def test_guesses_are_checked(mesh: list[float], states: Array, parameters: Any) -> None:
    with pytest.raises(ValueError, match=r"mesh|guess|parameters"):
        bvp.solve(bratu, fixed_ends, mesh, states, parameters)


def test_complex_numbers_are_refused() -> None:
    x = np.linspace(0, 1, 11)
    with pytest.raises(TypeError, match="guess is complex"):
        bvp.solve(bratu, fixed_ends, x, np.zeros((2, 11), complex))

    def turning(_: Array, y: Array) -> Any:
        return np.vstack((y[1], np.emath.sqrt(y[0] - 2)))

    with pytest.raises(TypeError, match="returned complex numbers"):
        bvp.solve(turning, fixed_ends, x, np.zeros((2, 11)))


def test_a_complex_step_needs_complex_results() -> None:
    # A result of its own type loses the imaginary parts, and all derivatives with them.
    def real(_: Array, y: Array) -> Any:
        out = np.empty((2, y.shape[1]))
        out[0], out[1] = y[1].real, -np.exp(y[0].real)
        return out

    with pytest.raises(TypeError, match="real numbers for complex states"):
        bvp.solve(real, fixed_ends, np.linspace(0, 1, 11), np.zeros((2, 11)), jacobian="complex")


def test_hints_name_what_there_is_here() -> None:
    """Not the functions and options of the Rust library."""
    x = np.linspace(0, 1, 11)
    zeros = np.zeros((2, 11))

    def singular(x: Array, y: Array) -> Array:
        with np.errstate(all="ignore"):
            return np.vstack((y[1], -2 * y[1] / x - y[0]))

    def layer(_: Array, y: Array) -> Array:
        return np.vstack((y[1], y[0] / 1e-12))

    def stiff(_: Array, y: Array) -> Array:
        return np.vstack((y[1], np.exp(300 * y[0])))

    def free(a: Array, b: Array) -> Array:
        return np.array([a[1], b[1]])

    def fixed(a: Array, b: Array) -> Array:
        return np.array([a[0] - 1, b[0]])

    problems: list[tuple[Any, Any, dict[str, Any]]] = [
        (singular, lambda a, b: np.array([a[1], b[0] - 1]), {}),
        (lambda x, y: np.vstack((y[1], -10 * np.exp(y[0]))), fixed_ends, {}),
        (lambda x, y: np.vstack((y[1], 0 * y[0])), free, {}),
        (layer, fixed, {"max_nodes": 12, "tol": 1e-8}),
        (bratu, fixed_ends, {"max_nodes": 12, "tol": 1e-11}),
        (bratu, fixed_ends, {"work_limit": 20}),
        (stiff, fixed, {}),
    ]
    said = []
    for f, ends, options in problems:
        with pytest.raises(sheave.SolveError) as caught:
            bvp.solve(f, ends, x, zeros, **options)
        hint = caught.value.hint
        assert hint is not None
        said.append(hint)
        for word in ("::", "Order", "solve_automatically", "accept_inaccurate", "boundary_tolerance", "arclength"):
            assert word not in hint, hint
    assert 'order="gauss"' in said[0] and "max_nodes" in said[3] and "work_limit" in said[5]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"tol": 0}, r"^tol = 0: expected a positive number$"),
        ({"tol": float("nan")}, r"^tol = nan: expected a positive number$"),
        ({"tol": float("inf")}, r"^tol = inf: expected a positive number$"),
        ({"bc_tol": -1}, r"^bc_tol = -1: expected a positive number$"),
        ({"max_nodes": 0}, r"^max_nodes = 0: expected a whole number from 2 on$"),
        ({"max_nodes": -5}, r"^max_nodes = -5: expected a whole number from 2 on$"),
        ({"work_limit": -1}, r"^work_limit = -1: expected a whole number from 1 on$"),
        ({"work_limit": 2**70}, r"^work_limit = 1180591620717411303424: expected a whole number up to "),
    ],
)
def test_options_that_are_none_are_named_as_they_are_here(options: dict[str, Any], said: str) -> None:
    x = np.linspace(0, 1, 11)
    with pytest.raises(ValueError, match=said):
        bvp.solve(bratu, fixed_ends, x, np.zeros((2, 11)), **options)


def test_options_of_another_type_are_named_as_they_are_here() -> None:
    x = np.linspace(0, 1, 11)
    wrong: list[tuple[str, Any]] = [
        ("tol", "1e-6"),
        ("tol", True),
        ("bc_tol", [1e-6]),
        ("max_nodes", 12.5),
        ("work_limit", "many"),
    ]
    for name, given in wrong:
        with pytest.raises(TypeError, match=rf"^{name} = .*: expected a "):
            bvp.solve(bratu, fixed_ends, x, np.zeros((2, 11)), **{name: given})
    assert bvp.solve(bratu, fixed_ends, x, np.zeros((2, 11)), tol=np.float32(1e-4), max_nodes=np.int64(100)).success


def test_a_jacobian_with_parameters_is_a_pair() -> None:
    x = np.linspace(0, 1, 11)
    guess = np.vstack((np.sin(np.pi * x) / np.pi, np.cos(np.pi * x)))

    def f(_: Array, y: Array, p: Array) -> Array:
        return np.vstack((y[1], -p[0] * y[0]))

    def ends(a: Array, b: Array, _: Array) -> Array:
        return np.array([a[0], b[0], a[1] - 1])

    def by_states(_: Array, y: Array, p: Array) -> Array:
        one, zero = np.ones_like(y[0]), np.zeros_like(y[0])
        return np.array([[zero, one], [-p[0] * one, zero]])

    def by_parameters(_: Array, y: Array, __: Array) -> Array:
        return np.array([[np.zeros_like(y[0])], [-y[0]]])

    def pair(*at: Array) -> Any:
        return [by_states(*at), by_parameters(*at)]

    found = bvp.solve(f, ends, x, guess, [9.0], jacobian=pair)
    assert found.p is not None and found.p[0] == pytest.approx(np.pi**2, rel=1e-5)
    with pytest.raises(TypeError, match="expected a pair of df/dy"):
        bvp.solve(f, ends, x, guess, [9.0], jacobian=by_states)
