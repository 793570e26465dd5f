#!/usr/bin/env python3
"""The test set solved by scipy.integrate.solve_bvp: the peer's column of docs/testset.md.

    python3 -m venv VENV && VENV/bin/pip install numpy scipy
    VENV/bin/python testset_scipy.py run       [ID...] > scipy.json     one record a run
    VENV/bin/python testset_scipy.py samples           > samples.json   right-hand sides and conditions at scattered
                                                                        points

`run`: tolerance 1e-6, 21 uniform nodes, at most 100,000 nodes, a cap of 20 s a run, SciPy's own finite differences;
seconds are the best of up to seven solves in a process of its own. `samples`: for checking another transcription
against this one.

A problem of two regions is stacked on one interval [0, 1]; its right-hand side carries the region's length.
"""
import json, multiprocessing, os, sys, time, warnings
import numpy as np
from numpy import array, cos, cosh, exp, ones, pi, sin, sinh, sqrt, stack, tan, zeros
from scipy.integrate import solve_bvp
from scipy.special import erf, jv  # noqa: F401  (erf: for whoever adds exact solutions)

HERE = os.path.dirname(os.path.abspath(__file__))
DATA = os.path.join(HERE, "..", "tests", "data", "bvp-testset.json")
CAP, TOL = 20.0, 1e-6
BUTLER = dict(k=1.64, ioA=0.01, ioC=1e-4, V=0.5, f=38.9)
BESSEL_NU = 3.4123


def dirichlet(left, right):
    """y1 given at both ends, as functions of the parameter."""
    return lambda ya, yb, p, e: array([ya[0] - left(e), yb[0] - right(e)])


def cosine_forcing(x, y, p, e):
    return stack([y[1], (y[0] - (e * pi**2 + 1) * cos(pi * x)) / e])


def lagerstrom(x, y, p, e):
    return stack([y[1], y[0] * (1 - y[1]) / e])


def spb(x, y, p, e):
    return stack([y[1], (y[0] * (y[0] ** 2 - 1) * y[1] + y[0]) / e])


def zero(n):
    return lambda x, e: zeros((n, x.size))


def line(left, right):
    return lambda x, e: stack([left + (right - left) * (x - x[0]) / (x[-1] - x[0]),
                               np.full_like(x, (right - left) / (x[-1] - x[0]))])


def constant(*values):
    return lambda x, e: array(values, float)[:, None] * ones(x.size)


def const(value):
    return lambda e: value


P = {}


def add(id, interval, fun, bc, guess, p=(), S=None, nodes=21):
    P[id] = dict(interval=interval, fun=fun, bc=bc, guess=guess, p=list(p), S=S, nodes=nodes)


# ---- linear
add("T01", (0, 1), lambda x, y, p, e: stack([y[1], y[0] / e]), dirichlet(const(1), const(0)), zero(2))
add("T02", (0, 1), lambda x, y, p, e: stack([y[1], y[1] / e]), dirichlet(const(1), const(0)), zero(2))
add("T03", (-1, 1), lambda x, y, p, e: stack([y[1], (-(2 + cos(pi * x)) * y[1] + y[0] - (1 + e * pi**2) * cos(pi * x)
                                                     - (2 + cos(pi * x)) * pi * sin(pi * x)) / e]),
    dirichlet(const(-1), const(-1)), zero(2))
add("T04", (-1, 1), lambda x, y, p, e: stack([y[1], ((1 + e) * y[0] - y[1]) / e]),
    dirichlet(lambda e: 1 + exp(-2), lambda e: 1 + exp(-2 * (1 + e) / e)), zero(2))
add("T06", (-1, 1), lambda x, y, p, e: stack([y[1], (-x * y[1] - e * pi**2 * cos(pi * x) - pi * x * sin(pi * x)) / e]),
    dirichlet(const(-2), const(0)), zero(2))
add("T07", (-1, 1), lambda x, y, p, e: stack([y[1], (-x * y[1] + y[0] - (1 + e * pi**2) * cos(pi * x)
                                                     - pi * x * sin(pi * x)) / e]),
    dirichlet(const(-1), const(1)), zero(2))
add("T08", (0, 1), lambda x, y, p, e: stack([y[1], -y[1] / e]), dirichlet(const(1), const(2)), zero(2))
add("T10", (-1, 1), lambda x, y, p, e: stack([y[1], -x * y[1] / e]), dirichlet(const(0), const(2)), zero(2))
add("T11", (-1, 1), cosine_forcing, dirichlet(const(-1), const(-1)), zero(2))
add("T12", (-1, 1), cosine_forcing, dirichlet(const(-1), const(0)), zero(2))
add("T13", (-1, 1), cosine_forcing, dirichlet(const(0), const(-1)), zero(2))
add("T16", (0, 1), lambda x, y, p, e: stack([y[1], -pi**2 * y[0] / (4 * e**2)]),
    dirichlet(const(0), lambda e: sin(pi / (2 * e))), zero(2))
add("T17", (-0.1, 0.1), lambda x, y, p, e: stack([y[1], -3 * e * y[0] / (e + x**2) ** 2]),
    dirichlet(lambda e: -0.1 / sqrt(e + 0.01), lambda e: 0.1 / sqrt(e + 0.01)), zero(2))
add("T18", (0, 1), lambda x, y, p, e: stack([y[1], -y[1] / e]), dirichlet(const(1), lambda e: exp(-1 / e)), zero(2))
add("T35", (-1, 1), lambda x, y, p, e: stack([y[1], (x * y[1] - y[0]) / e]), dirichlet(const(1), const(2)), zero(2))
add("RCBVP", (1 / (3 * pi), 1), lambda x, y, p, e: stack([y[1], -2 * y[1] / x - y[0] / x**4]),
    dirichlet(const(0), const(sin(1.0))), constant(1, 1))
add("BESSEL_HALF", (1, 6), lambda x, y, p, e: stack([y[1], -y[1] / x - (1 - 1 / (4 * x**2)) * y[0] + sqrt(x) * cos(x)]),
    dirichlet(const(1), const(-0.5)), zero(2))
add("COLSYS1", (1, 2), lambda x, y, p, e: stack([y[1], y[2], y[3], (1 - 6 * x**2 * y[3] - 6 * x * y[2]) / x**3]),
    lambda ya, yb, p, e: array([ya[0], ya[2], yb[0], yb[2]]), zero(4))


def musl(x, y, p, e):
    c, s, E = cos(2 * x), sin(2 * x), exp(x)
    return stack([(1 - 2 * c) * y[0] + (1 + 2 * s) * y[2] + (-1 + 2 * c - 2 * s) * E, 2 * y[1] - E,
                  (-1 + 2 * s) * y[0] + (1 + 2 * c) * y[2] + (1 - 2 * c - 2 * s) * E])


add("MUSL", (0, 6), musl, lambda ya, yb, p, e: ya + yb - 1 - exp(6), constant(1, 1, 1))
A3 = array([[0.0, 1, 2], [1, 0, 3], [2, 3, 4]])
add("MAT3", (0, 1), lambda x, y, p, e: A3 @ y,
    lambda ya, yb, p, e: array([array([1, 2, 3]) @ ya - 1, array([4, 5, 6]) @ yb - 2, array([7, 8, 9]) @ yb - 3]),
    zero(3))

# ---- nonlinear
add("T19", (0, 1), lambda x, y, p, e: stack([y[1], (pi / 2 * sin(pi * x / 2) * exp(2 * y[0]) - exp(y[0]) * y[1]) / e]),
    dirichlet(const(0), const(0)), zero(2))
add("T21", (0, 1), lambda x, y, p, e: stack([y[1], (y[0] + y[0] ** 2 - exp(-2 * x / sqrt(e))) / e]),
    dirichlet(const(1), lambda e: exp(-1 / sqrt(e))), zero(2))
add("T22", (0, 1), lambda x, y, p, e: stack([y[1], -(y[1] + y[0] ** 2) / e]), dirichlet(const(0), const(0.5)), zero(2))
add("T23", (0, 1), lambda x, y, p, e: stack([y[1], e * sinh(e * y[0])]), dirichlet(const(0), const(1)), zero(2))
add("T25", (0, 1), lagerstrom, dirichlet(const(-1 / 3), const(1 / 3)), line(-1 / 3, 1 / 3))
add("T26", (0, 1), lagerstrom, dirichlet(const(1), const(-1 / 3)), line(1, -1 / 3))
add("T28", (0, 1), lagerstrom, dirichlet(const(1), const(1.5)), line(1, 1.5))
add("T29", (0, 1), lagerstrom, dirichlet(const(0), const(1.5)), line(0, 1.5))
add("T31", (0, 1), lambda x, y, p, e: stack([sin(y[1]), y[2], -y[3] / e, ((y[0] - 1) * cos(y[1]) - y[2] * (
    1 / cos(y[1]) + e * y[3] * tan(y[1]))) / e]), lambda ya, yb, p, e: array([ya[0], ya[2], yb[0], yb[2]]), zero(4))
add("T33", (0, 1), lambda x, y, p, e: stack([y[1], (y[0] * y[3] - y[2] * y[1]) / e, y[3], y[4], y[5],
                                             (-y[2] * y[5] - y[0] * y[1]) / e]),
    lambda ya, yb, p, e: array([ya[0] + 1, ya[2], ya[3], yb[0] - 1, yb[2], yb[3]]),
    lambda x, e: stack([-1 + 2 * x, 2 + 0 * x, 0 * x, 0 * x, 0 * x, 0 * x]))
add("T34", (0, 1), lambda x, y, p, e: stack([y[1], -e * exp(y[0])]), dirichlet(const(0), const(0)), zero(2))
cosh3 = lambda C: np.arccosh(sqrt((1 + C) / C) * cosh(sqrt(C) / 2))
add("COSH3", (0, 1), lambda x, y, p, e: stack([y[1], cosh(y[0]) / sinh(y[0]) ** 3]), dirichlet(cosh3, cosh3),
    constant(1, 0))
add("EMDEN", (0, 1), lambda x, y, p, e: stack([y[1], -y[0] ** 5]),
    lambda ya, yb, p, e: array([ya[1], yb[0] - sqrt(3) / 2]), constant(sqrt(3) / 2, 1e-4), S=array([[0, 0], [0, -2.0]]))
add("ESI", (0, 20), lambda x, y, p, e: stack([y[1], -(x * y[0] - 1) * y[0]]),
    lambda ya, yb, p, e: array([ya[1], yb[0] + yb[1]]),
    lambda x, e: np.where(x <= 1.5, stack([2 + 0 * x, 0 * x]), stack([2 * exp(1.5 - x), -2 * exp(1.5 - x)])),
    S=array([[0, 0], [0, -4.0]]))
g, b = 40, 0.2
for k, start in (("CATALYST1", 1), ("CATALYST2", 0.5), ("CATALYST3", 0)):
    add(k, (0, 1), lambda x, y, p, e: stack([y[1], e**2 * y[0] * exp(g * b * (1 - y[0]) / (1 + b * (1 - y[0])))]),
        lambda ya, yb, p, e: array([ya[1], yb[0] - 1]), constant(start, 0), S=array([[0, 0], [0, -2.0]]))


def measles(x, y, p, e):
    bx, mu, lam = 1575 * (1 + cos(2 * pi * x)), 0.02, 0.0279
    return stack([mu - bx * y[0] * y[2], bx * y[0] * y[2] - y[1] / lam, y[1] / lam - y[2] / e])


add("MEASLES", (0, 1), measles, lambda ya, yb, p, e: ya - yb, constant(0.07, 5e-4, 2e-3))
add("SPB", (0, 1), spb, dirichlet(const(1.5), const(1.2)), line(1.5, 1.2))
add("SPB_M", (0, 1), spb, dirichlet(const(1.5), const(-1.2)), line(1.5, -1.2))


def disk(x, y, p, L):
    n = 0.2
    c, s = (3 - n) / 2, 12 / L if L <= 120 else 0.1 - 0.05 * (L - 120) / 80
    G, G1, H, H1, H2 = y
    return stack([G1, L**2 * s * (G - 1) - L * (c * H * G1 + (n - 1) * H1 * G), H1, H2,
                  L**3 * (1 - G**2) + L**2 * s * H1 - L * (c * H * H2 + n * H1**2)])


def disk_guess(x, L):
    z = L * x
    E = exp(-z)
    return stack([1 - E, L * E, -z**2 * E, L * (z**2 - 2 * z) * E, L**2 * (-z**2 + 4 * z - 2) * E])


add("COLSYS3", (0, 1), disk, lambda ya, yb, p, e: array([ya[0], ya[2], ya[3], yb[0] - 1, yb[3]]), disk_guess)


def butler(ya, yb, p, e):
    k, ioA, ioC, V, f = BUTLER.values()
    h = V - yb[0] - 1
    return array([ioA * (exp(-f * ya[0]) - exp(f * ya[0])) + k * ya[1], ioC * (exp(f * h) - exp(-f * h)) - k * yb[1]])


add("BUTLERVOLMER", (0, 0.1), lambda x, y, p, e: stack([y[1], 0 * y[1]]), butler, zero(2))

# ---- unknown constants
add("MATHIEU", (0, pi), lambda x, y, p, e: stack([y[1], -(p[0] - 10 * cos(2 * x)) * y[0]]),
    lambda ya, yb, p, e: array([ya[1], yb[1], ya[0] - 1]), lambda x, e: stack([cos(4 * x), -4 * sin(4 * x)]), p=[15])
add("LUBRICATION", (-pi / 2, pi / 2), lambda x, y, p, e: stack([(sin(x) ** 2 - p[0] * sin(x) ** 4 / y[0]) / e]),
    lambda ya, yb, p, e: array([ya[0] - 1, yb[0] - 1]), constant(0.5), p=[1])
add("ELASTICA", (0, 0.5), lambda x, y, p, e: stack([cos(y[2]), sin(y[2]), y[3], p[0] * cos(y[2])]),
    lambda ya, yb, p, e: array([ya[0], ya[1], ya[3], yb[1], yb[2] + pi / 2]), zero(4), p=[-10])
add("NERVE", (0, 1), lambda x, y, p, e: stack([3 * p[0] * (y[0] + y[1] - y[0] ** 3 / 3 - 1.3),
                                               -p[0] * (y[0] - 0.7 + 0.8 * y[1]) / 3]),
    lambda ya, yb, p, e: array([ya[0] - yb[0], ya[1] - yb[1], -p[0] * (ya[0] - 0.7 + 0.8 * ya[1]) / 3 - 1]),
    lambda x, e: stack([sin(2 * pi * x), cos(2 * pi * x)]), p=[2 * pi], nodes=5)

# ---- two regions, stacked on [0, 1]


def flow(t, y, p, kappa):
    n, lam = 0.05, 2.0
    eta = lam**2 / (n * kappa**2)
    v1, C1, v2, C2 = y
    return stack([(C1 - 1) / n, (v1 * C1 - t) / eta, (lam - 1) * (C2 - 1) / n, (lam - 1) * (v2 * C2 - 1) / eta])


add("THREEBVP", (0, 1), flow, lambda ya, yb, p, e: array([ya[0], yb[0] - ya[2], yb[1] - ya[3], yb[3] - 1]),
    constant(1, 1, 1, 1))


def bessel(t, y, p, e):
    nu, (x1, x2) = BESSEL_NU, (1 + 4 * t, 5 + 5 * t)
    one = lambda x, u, w, v: [w, -w / x + (nu**2 / x**2 - 1) * u, x ** (nu + 1) * u]
    return stack([4 * f for f in one(x1, *y[:3])] + [5 * f for f in one(x2, *y[3:])])


def bessel_ends(ya, yb, p, e):
    nu = BESSEL_NU
    return array([ya[0] - jv(nu, 1), yb[0] - ya[3], yb[1] - ya[4], yb[2] - ya[5], yb[2] - 5 ** (nu + 1) * jv(nu + 1, 5),
                  yb[3] - jv(nu, 10)])


add("BESSEL_MP", (0, 1), bessel, bessel_ends, zero(6))

# ---- folds: right-hand sides only, solve_bvp follows no branch
add("FOLD_BRATU", (0, 1), P["T34"]["fun"], P["T34"]["bc"], zero(2))
add("FOLD_NON", (0, 1), lambda x, y, p, e: stack([y[1], -e * exp(x**3 * y[0])]), dirichlet(const(0), const(0)), zero(2))


def references():
    with open(DATA) as file:
        return {problem["id"]: problem for problem in json.load(file)["problems"]}


def solve_once(q, e):
    a, b = q["interval"]
    x = np.linspace(a, b, q["nodes"])
    unknown = bool(q["p"])
    fun = (lambda x, y, p: q["fun"](x, y, p, e)) if unknown else (lambda x, y: q["fun"](x, y, (), e))
    bc = (lambda ya, yb, p: q["bc"](ya, yb, p, e)) if unknown else (lambda ya, yb: q["bc"](ya, yb, (), e))
    return solve_bvp(fun, bc, x, q["guess"](x, e), p=q["p"] or None, S=q["S"], tol=TOL, max_nodes=100_000)


def worker(name, e, records, pipe):
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    q, best, r = P[name], np.inf, None
    begin = time.perf_counter()
    for _ in range(7):
        start = time.perf_counter()
        try:
            r = solve_once(q, e)
        except Exception as reason:  # a failure to report, of whatever kind
            pipe.send(dict(status=f"failed: {type(reason).__name__}"))
            return
        best = min(best, time.perf_counter() - start)
        if r.status != 0 or time.perf_counter() - begin > 0.5:
            break
    out = dict(status="converged" if r.status == 0 else "failed: " + (
        "singular Jacobian" if r.status == 2 else "max_nodes exceeded"),
        seconds=best, nodes=int(r.x.size), iterations=int(r.niter))
    if r.status == 0:
        errors = []
        for record in records:
            y, peak = array(record["y"]), array(record["max_abs_component"])
            error = np.max(np.abs(r.sol(array(record["x"])) - y) / (1 + peak[:, None]))
            if record.get("parameters_found"):
                expected = record["parameters_found"]
                error = max(error, np.max(np.abs(r.p - expected) / (1 + np.abs(expected))))
            errors.append(float(error))
        out["error"] = min(errors)
    pipe.send(out)


def run(ids):
    out = []
    for id, problem in references().items():
        if id.startswith("FOLD") or (ids and id not in ids):
            continue
        names = [name for name in P if name == id or (name[:-1] == id and name[-1].isdigit())]
        for e in problem["parameters"] or [None]:
            records = [r for r in problem["references"] if r["parameter"] == e]
            for name in names:
                mine = [r for r in records if r.get("solution") == name] or records
                here, there = multiprocessing.Pipe()
                task = multiprocessing.Process(target=worker, args=(name, e, mine, there))
                task.start()
                result = here.recv() if here.poll(CAP) else dict(status=f"failed: stopped at {CAP:.0f} s")
                task.kill()
                task.join()
                out.append(dict(id=id, variant=name if name != id else None, parameter=e, **result))
                print(out[-1], file=sys.stderr)
    json.dump(out, sys.stdout, indent=1)


def samples():
    random, out = np.random.default_rng(7), []
    for id, problem in references().items():
        q = P[id] if id in P else P[id + "1"]
        a, b = q["interval"]
        n = q["guess"](np.linspace(a, b, 3), 1.0).shape[0]
        for e in (problem["parameters"] or [2.5])[:1]:
            for _ in range(3):
                x = round(random.uniform(a, b), 6)
                y, ya, yb = (np.round(random.uniform(0.2, 1.2, n), 6) for _ in range(3))
                p = np.round(random.uniform(0.5, 2, len(q["p"])), 6)
                f = q["fun"](array([x]), y[:, None], p, e)[:, 0]
                f = f + (q["S"] @ y / x if q["S"] is not None else 0)
                out.append(dict(id=id, parameter=e, x=x, y=y.tolist(), ya=ya.tolist(), yb=yb.tolist(), p=p.tolist(),
                                f=f.tolist(), g=q["bc"](ya, yb, p, e).tolist()))
    print("[" + ",\n".join(json.dumps(record) for record in out) + "]")


if __name__ == "__main__":
    if sys.argv[1:2] == ["samples"]:
        samples()
    elif sys.argv[1:2] == ["run"]:
        run(sys.argv[2:])
    else:
        sys.exit(__doc__)
