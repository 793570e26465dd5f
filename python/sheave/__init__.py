"""Rubber V-belt CVTs, computed: axial forces, efficiency and belt path from one boundary value problem.

>>> import sheave
>>> result = sheave.solve(slack_tension="120 N", tolerance=1e-3)
>>> round(result.primary.axial_force)
1133
>>> result.efficiency.overall > 0.95
True

Quantities are texts with a unit (``"120 N"``), numbers in SI units, or quantities of pint; results are in SI units,
ratios as fractions. Every call leaves the interpreter to other threads while it computes, and Ctrl-C ends it.
"""

from . import bvp, errors
from ._api import (
    Belt,
    BestClamp,
    ClampLimits,
    Comparison,
    DriveState,
    Limit,
    Limits,
    Operating,
    belt,
    compare,
    dyno,
    limit,
    map,
    optimum,
    sensitivities,
    sweep,
)
from ._sheave import (
    BeltMap,
    BeltResult,
    Case,
    Efficiency,
    Energy,
    Heat,
    Losses,
    Profile,
    Pulley,
    Region,
    Result,
    SolverReport,
    Span,
    Study,
    Table,
    __version__,
    keys,
    solve,
)
from .errors import BenchError, CaseError, DesignError, Error, MapError, Place, SolveError, StudyError

__all__ = [
    "Belt",
    "BeltMap",
    "BeltResult",
    "BenchError",
    "BestClamp",
    "Case",
    "CaseError",
    "ClampLimits",
    "Comparison",
    "DesignError",
    "DriveState",
    "Efficiency",
    "Energy",
    "Error",
    "Heat",
    "Limit",
    "Limits",
    "Losses",
    "MapError",
    "Operating",
    "Place",
    "Profile",
    "Pulley",
    "Region",
    "Result",
    "SolveError",
    "SolverReport",
    "Span",
    "Study",
    "StudyError",
    "Table",
    "__version__",
    "belt",
    "bvp",
    "compare",
    "dyno",
    "errors",
    "keys",
    "limit",
    "map",
    "optimum",
    "sensitivities",
    "solve",
    "sweep",
]
