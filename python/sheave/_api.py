"""What is made of the extension's answers: typed results, progress in notebooks."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _sheave
from ._files import appearing
from ._sheave import BeltMap, Case, Table

if TYPE_CHECKING:
    from os import PathLike

    CaseLike = Union[str, PathLike[str], Mapping[str, Any], Case, None]

__all__ = [
    "Belt",
    "BestClamp",
    "ClampLimits",
    "Comparison",
    "DriveState",
    "Limit",
    "Limits",
    "Operating",
    "belt",
    "compare",
    "dyno",
    "limit",
    "map",
    "optimum",
    "progress_bar",
    "sensitivities",
    "sweep",
]

Progress = Union[bool, Callable[[int], Any], None]


def in_notebook() -> bool:
    """Whether this runs in the kernel of a notebook."""
    try:
        from IPython import get_ipython
    except ImportError:
        return False
    shell = get_ipython()
    return shell is not None and "IPKernelApp" in shell.config


def progress_bar(progress: Progress, points: Optional[int]) -> AbstractContextManager[Optional[Callable[[int], Any]]]:
    """What is told of points as they are solved: a bar of tqdm, without an end for None points, or the function given.

    Without a word (None), a bar is shown in notebooks where tqdm is installed, and nothing elsewhere.
    """
    if callable(progress):
        return nullcontext(progress)
    if progress is False or (progress is None and not in_notebook()):
        return nullcontext(None)
    try:
        from tqdm.auto import tqdm
    except ImportError:
        if progress:
            raise
        return nullcontext(None)
    return _Bar(tqdm(total=points, unit=" points"))


class _Bar(AbstractContextManager[Optional[Callable[[int], Any]]]):
    def __init__(self, bar: Any) -> None:
        self.bar = bar

    def __enter__(self) -> Callable[[int], Any]:
        return self.show

    def show(self, solved: int) -> None:
        self.bar.update(solved - self.bar.n)

    def __exit__(self, *_: object) -> None:
        self.bar.close()


def sweep(
    case: CaseLike = None,
    /,
    *,
    over: Any = None,
    jobs: Optional[int] = None,
    tolerance: float = 1e-6,
    order: int = 4,
    progress: Progress = None,
    **keys: Any,
) -> Table:
    """Solves a case over a grid of any of its keys: a ``Table`` with one row a point, the last axis fastest.

    ``over`` is a dictionary of keys and their values, or texts as ``sheave sweep --over`` takes them::

        sweep(over={"drive.ratio": numpy.linspace(0.8, 1.6, 9), "slack_tension": ["100 N", "150 N"]})
        sweep(over=["drive.ratio=0.8..1.6:9", "operating_point.slack_tension=100,150 N"])

    Numbers are in SI units, whatever units others beside them have. The case may be a study file, which says itself
    what varies: ``over`` then takes the place of what it says of the same keys, or may be left out. ``jobs`` is the
    number of threads, all cores without it. ``progress`` is True or False for a bar of tqdm, or a function that is
    called with the number of points solved; without it there is a bar in notebooks. Rows depend on the grid alone, not
    on ``jobs``. All other arguments are keys of the case.

    Raises ``CaseError``, ``StudyError``; a point without a solution has a row whose ``failure`` says why.
    """
    study = _sheave.Study(case, over=over, tolerance=tolerance, order=order, **keys)
    with progress_bar(progress, len(study)) as tell:
        return study.run(jobs=jobs, progress=tell)


def sensitivities(
    case: CaseLike = None, /, *, tolerance: float = 1e-6, order: int = 4, **keys: Any
) -> dict[str, dict[str, float]]:
    """Derivatives of every output with respect to everything that is given, SI over SI, from one solution.

    By output with dots (``"efficiency.overall"``), then by key (``"belt.bending_stiffness"``). They are exact: one
    elimination with the factorisation at the solution, no differences.

    Raises ``CaseError``, ``SolveError``.
    """
    result = _sheave.solve(case, tolerance=tolerance, order=order, sensitivities=True, **keys)
    return result.sensitivities or {}


@dataclass(frozen=True)
class DriveState:
    """Where a drive stands. SI units, ratios as fractions."""

    primary_torque: float
    """Torque into the primary, N·m."""
    secondary_torque: float
    """Torque out of the secondary, N·m."""
    slack_tension: float
    """Tractive tension at the exit of the primary, N."""
    tight_tension: float
    """Tractive tension at the entry of the primary, N."""
    primary_axial_force: float
    """Axial force on the primary, N."""
    secondary_axial_force: float
    """Axial force on the secondary, N."""
    speed_ratio: float
    """Speed of the secondary over that of the primary."""
    speed_efficiency: float
    """Rim speed of the secondary over that of the primary (6.7)."""
    overall_efficiency: float
    """Power out over power in (6.9)."""


@dataclass(frozen=True)
class Limit:
    """A limit, and the drive there."""

    value: float
    """The limiting value, N or N·m."""
    kind: str
    """``"fold"``, ``"collapse"``, ``"speed_efficiency"``, or ``"lost"`` where the limit lies beyond."""
    state: DriveState
    """The drive there."""
    reason: Optional[str] = None
    """Why the solution was lost, where it was."""
    belt_temperature: Optional[float] = None
    """Temperature of the belt, K; None where the case does not say what cools it."""

    @classmethod
    def _of(cls, fields: Mapping[str, Any]) -> Limit:
        return cls(**{**fields, "state": DriveState(**fields["state"])})


@dataclass(frozen=True)
class ClampLimits:
    """The smallest clamps that carry the torque of a case, in the ways to give one."""

    slack_tension: Limit
    """Tractive tension at the exit of the primary, N."""
    primary_axial_force: Limit
    """Axial force on the primary, N."""
    secondary_axial_force: Limit
    """Axial force on the secondary, N."""


@dataclass(frozen=True)
class Limits:
    """The limits of a drive."""

    edition: str
    largest_torque: Limit
    """The largest torque that the case's clamp carries."""
    smallest_clamp: Optional[ClampLimits]
    """The smallest clamps for the case's torque; None where the case's load is a speed."""


def limit(
    case: CaseLike = None,
    /,
    *,
    least_speed_efficiency: float = 0.95,
    tolerance: float = 1e-6,
    **keys: Any,
) -> Limits:
    """The largest torque for the clamp of a case, and the smallest clamps for its torque.

    The drive is followed to a speed efficiency of ``least_speed_efficiency``, below which it counts as slipping; with 0
    it is followed until the secondary stands still.

    Raises ``CaseError``, ``DesignError``.
    """
    found = _sheave.limit(case, least_speed_efficiency=least_speed_efficiency, tolerance=tolerance, **keys)
    smallest = found["smallest_clamp"]
    clamps = None if smallest is None else ClampLimits(**{key: Limit._of(one) for key, one in smallest.items()})
    return Limits(found["edition"], Limit._of(found["largest_torque"]), clamps)


@dataclass(frozen=True)
class BestClamp:
    """The clamp of best overall efficiency."""

    edition: str
    state: DriveState
    """The drive at the best clamp."""
    bound: str
    """``"inner"``, or the end of the clamps tried: ``"loosest"``, ``"tightest"``."""
    gradient: float
    """Derivative of the overall efficiency with respect to the slack tension there, 1/N."""
    evaluations: int
    """Solutions that it took."""
    efficiency_with_losses: Optional[float] = None
    """Efficiency with hysteresis, drag and gears, which is then what is best; None where friction alone counts."""
    belt_temperature: Optional[float] = None
    """Temperature of the belt, K; None where the case does not say what cools it."""


def optimum(case: CaseLike = None, /, *, tolerance: float = 1e-6, **keys: Any) -> BestClamp:
    """The clamp of best overall efficiency for the torque of a case.

    Raises ``CaseError``, ``DesignError``.
    """
    found = _sheave.optimum(case, tolerance=tolerance, **keys)
    return BestClamp(**{**found, "state": DriveState(**found["state"])})


def map(
    case: CaseLike = None,
    /,
    *,
    over: Union[Mapping[str, Any], Sequence[str], str],
    accuracy: float = 1e-3,
    tolerance: Optional[float] = None,
    max_points: int = 20_000,
    least_speed_efficiency: float = 0.9,
    jobs: Optional[int] = None,
    progress: Progress = None,
    **keys: Any,
) -> BeltMap:
    """Makes a map of what a belt does over two or more keys of its case, read between its nodes with a known error.

    ``over`` is a dictionary of keys and their ranges or breakpoints, or texts as ``sheave map --over`` takes them::

        map(over={"ratio": "0.7..3.2", "torque": "0..30 N*m", "clamp": [500, 1000, 2000]})

    Breakpoints are numbers in SI units, texts with units, or quantities of pint. The keys may be shortened to their
    last part; ``ratio``, ``torque``, ``speed`` and ``clamp`` (the axial force on the secondary) are usual. Breakpoints
    are added until the error at points that took no part is within ``accuracy``; points are solved to ``tolerance``, a
    hundredth of the accuracy without it.

    Raises ``CaseError``, ``MapError``, ``StudyError``.
    """
    # How many points it takes is known at the end only.
    with progress_bar(progress, max_points) as tell:
        return _sheave.map(
            case,
            over=over,
            accuracy=accuracy,
            tolerance=tolerance,
            max_points=max_points,
            least_speed_efficiency=least_speed_efficiency,
            jobs=jobs,
            progress=tell,
            **keys,
        )


@dataclass(frozen=True)
class Belt:
    """The properties of a belt from bench tests. SI units."""

    name: Optional[str]
    temperature: Optional[float]
    """Temperature of the belt in use, K."""
    length: float
    """Unstretched length, m."""
    mass_per_length: float
    """kg/m."""
    longitudinal_stiffness: float
    """EA, N."""
    bending_stiffness: float
    """EI, N·m²."""
    radial_stiffness: float
    """k, N/m²."""
    warnings: list[str]
    case_file: str
    """The case file with the table ``[belt]``, everything on the way as comments."""
    details: dict[str, Any] = field(repr=False)
    """Everything on the way, as ``sheave belt --json`` has it."""

    def case(self, **keys: Any) -> Case:
        """The case with this belt, and some keys more."""
        return Case(self.case_file).with_(**keys)


def belt(file: Union[str, PathLike[str]], *, temperature: Any = None) -> Belt:
    """Finds a belt's properties from the bench tests that a file describes.

    ``temperature`` is that of the belt in use: ``"60 degC"``, kelvins, or a quantity of pint.

    Raises ``BenchError``, and ``ValueError`` for a temperature that is none.
    """
    found = _sheave.belt(file, temperature=temperature)
    case_file, warnings = found.pop("case_file"), found.pop("warnings")
    own = {key: value for key, value in found["belt"].items() if isinstance(value, float)}
    names = ("length", "mass_per_length", "longitudinal_stiffness", "bending_stiffness", "radial_stiffness")
    return Belt(
        name=found.get("name"),
        temperature=found.get("temperature"),
        warnings=warnings,
        case_file=case_file,
        details=found,
        **{name: own[name] for name in names},
    )


@dataclass(frozen=True)
class Operating:
    """Operating points from the logs of a dynamometer."""

    points: list[dict[str, Any]] = field(repr=False)
    """The averaged windows; means with their standard errors, in SI units."""
    records: list[dict[str, Any]] = field(repr=False)
    """What was read, record by record, with the faults of its rows."""
    warnings: list[str]
    csv: str = field(repr=False)
    """The table that ``compare`` reads."""

    @property
    def steady(self) -> list[dict[str, Any]]:
        """The points that are steady."""
        return [point for point in self.points if point["steady"]]

    def write(self, path: Union[str, PathLike[str]]) -> Path:
        """Writes the table that ``compare`` reads; the file appears whole."""
        target = Path(path)
        with appearing(target) as beside:
            beside.write_text(self.csv, encoding="utf-8")
        return target

    def to_pandas(self) -> Any:
        """The table that ``compare`` reads, as a DataFrame of pandas."""
        import io

        import pandas

        return pandas.read_csv(io.StringIO(self.csv))


def dyno(paths: Union[str, PathLike[str], Iterable[Union[str, PathLike[str]]]], **options: Any) -> Operating:
    """Reduces raw logs of a dynamometer, or folders of them, to operating points.

    Options are those of ``sheave dyno``: ``calibration`` and ``engine`` (files), ``gear`` (speed of the brake's shaft
    over the secondary's), ``torque_at`` (``"secondary"`` or ``"brake"``), ``rate`` (Hz), ``window`` and ``longest_gap``
    (s), ``primary``, ``secondary`` and ``torque`` (names of columns), ``secondary_factor``, ``runs`` (file),
    ``revolutions_per_firing``.

    Raises ``BenchError``.
    """
    each = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    found = _sheave.dyno(each, **options)
    return Operating(found["points"], found["records"], found["warnings"], found["csv"])


@dataclass(frozen=True)
class Comparison:
    """Measured operating points against the model."""

    points: list[dict[str, Any]] = field(repr=False)
    """Each with its measured and its modelled efficiency, whether it was used, and why not."""
    scale: float
    """Scale of the engine's power, by least squares; 1 where the input torque of all points was measured."""
    scale_interval: tuple[float, Optional[float]]
    """Its 95 % interval; ``None`` for an upper end that the points do not determine."""
    mean_error: float
    """Model less measurement, mean."""
    rms: float
    """Root mean square of the same."""
    rms_after_scale: float
    r_squared: Optional[float]
    """``None`` where the measurements do not differ."""
    r_squared_after_scale: Optional[float]
    fit: Optional[dict[str, Any]]
    """Constants that were fitted, with their intervals."""
    warnings: list[str]
    summary: str = field(repr=False)
    """As a person reads it."""
    details: dict[str, Any] = field(repr=False)
    """All of it, as ``sheave compare --json`` has it."""

    def to_pandas(self) -> Any:
        """The points as a DataFrame of pandas."""
        import pandas

        return pandas.DataFrame(self.points)


def compare(
    case: CaseLike = None,
    /,
    *,
    data: Union[str, PathLike[str]],
    engine: Union[str, PathLike[str], None] = None,
    flyweights: Union[str, PathLike[str], None] = None,
    radii: str = "speeds",
    fit: Union[str, Sequence[str]] = (),
    tolerance: float = 1e-4,
    **keys: Any,
) -> Comparison:
    """Compares measured operating points with the model, and fits constants to them.

    ``data`` is the table that ``dyno`` writes, ``engine`` the engine's curve, ``flyweights`` describes the primary's
    flyweights and spring, ``radii`` says what the radii follow from (``"speeds"`` or ``"ratio"``), ``fit`` names the
    key or keys whose constants are found.

    Raises ``CaseError``, ``BenchError``.
    """
    found = _sheave.compare(
        case,
        data=data,
        engine=engine,
        flyweights=flyweights,
        radii=radii,
        fit=[fit] if isinstance(fit, str) else list(fit),
        tolerance=tolerance,
        **keys,
    )
    summary = found.pop("summary")
    return Comparison(
        points=found["points"],
        scale=found["scale"],
        scale_interval=tuple(found["scale_interval"]),
        mean_error=found["mean_error"],
        rms=found["rms"],
        rms_after_scale=found["rms_after_scale"],
        r_squared=found["r_squared"],
        r_squared_after_scale=found["r_squared_after_scale"],
        fit=found.get("fit"),
        warnings=found["warnings"],
        summary=summary,
        details=found,
    )
