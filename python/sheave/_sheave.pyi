"""The extension module of sheave: what touches the Rust library. Import ``sheave``, not this."""

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Optional, Union, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

_CaseLike = Union[str, PathLike[str], Mapping[str, Any], Case, None]
_Array = NDArray[np.float64]

__version__: str

@final
class Pulley:
    """One pulley and its contact."""

    @property
    def speed(self) -> float:
        """Speed of rotation, rad/s."""
    @property
    def torque(self) -> float:
        """Torque, N·m (5.54): into the primary, out of the secondary; negative where the secondary drives."""
    @property
    def power(self) -> float:
        """Power, W: into the primary, out of the secondary; negative where the secondary drives."""
    @property
    def axial_force(self) -> float:
        """Axial force between the sheaves, N (5.58)."""
    @property
    def wrap_angle(self) -> float:
        """Wrap angle, rad."""
    @property
    def entry_angle(self) -> float:
        """Angle of inclination where the belt enters, rad."""
    @property
    def exit_angle(self) -> float:
        """Angle of inclination where the belt leaves, rad."""
    @property
    def orientation_angle(self) -> float:
        """Orientation angle, rad (5.17) to (5.20)."""
    @property
    def max_penetration(self) -> float:
        """Largest radial penetration, m."""
    @property
    def min_sliding_speed(self) -> float:
        """Smallest sliding speed, m/s."""
    @property
    def max_sliding_speed(self) -> float:
        """Largest sliding speed, m/s."""
    @property
    def adhesion_fraction(self) -> float:
        """Share of the wrap angle on which the belt slides more slowly than the slip threshold."""
    @property
    def friction_utilization(self) -> float:
        """Share of the friction at hand that drives or brakes the pulley."""
    @property
    def radius(self) -> float:
        """Nominal radius, m."""
    @property
    def resultant_x(self) -> float:
        """Where the axial force acts, m from the pulley's centre, towards the secondary's centre from the primary's."""
    @property
    def resultant_y(self) -> float:
        """Where the axial force acts, m from the pulley's centre, towards the tight span."""
    @property
    def binding_moment(self) -> float:
        """Moment of the axial force about the pulley's centre, N·m."""
    @property
    def friction_loss(self) -> float:
        """Power lost to friction, W."""
    @property
    def entry_tension(self) -> float:
        """Tractive tension where the belt enters, N."""
    @property
    def exit_tension(self) -> float:
        """Tractive tension where the belt leaves, N."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Span:
    """One span."""

    @property
    def arc_length(self) -> float:
        """Arc length, m."""
    @property
    def unstretched_length(self) -> float:
        """Length when unloaded, m (5.56)."""
    @property
    def min_tension(self) -> float:
        """Smallest tractive tension, N."""
    @property
    def max_tension(self) -> float:
        """Largest tractive tension, N."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Efficiency:
    """Efficiencies as fractions, of the driven pulley over the driving one; None where neither drives the other."""

    @property
    def speed(self) -> Optional[float]:
        """Rim speed of the driven pulley over that of the driving one (6.7)."""
    @property
    def torque(self) -> Optional[float]:
        """Rim force of the driven pulley over that of the driving one (6.8)."""
    @property
    def overall(self) -> Optional[float]:
        """Power out over power in (6.9)."""
    @property
    def overall_with_losses(self) -> Optional[float]:
        """The same with hysteresis, drag and gears, where they are told."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class OtherSolution:
    """The other of two operating points of a prescribed axial force."""

    @property
    def slack_tension(self) -> float:
        """Tractive tension at the exit of the primary, N."""
    @property
    def friction_utilization(self) -> float:
        """Share of the friction at hand that is used."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class BeltResult:
    """The belt as a whole."""

    @property
    def mass_flow(self) -> float:
        """Mass flow, kg/s (3.5)."""
    @property
    def unstretched_length(self) -> float:
        """Length of the loop when unloaded, m."""
    @property
    def length_error(self) -> float:
        """What the drive needs less what the belt has, m."""
    @property
    def temperature(self) -> Optional[float]:
        """Temperature, K; None where the case does not say what cools the belt."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Energy:
    """The energy audit, for full shear with continuous ends:
    power in = power out + friction loss + strain energy flux."""

    @property
    def power_in(self) -> float:
        """Power into the primary, W."""
    @property
    def power_out(self) -> float:
        """Power out of the secondary, W."""
    @property
    def friction_loss(self) -> float:
        """Power that friction turns to heat, W."""
    @property
    def imbalance(self) -> Optional[float]:
        """(power_in - power_out - friction_loss)/power_in; None without power in."""
    @property
    def stretch_work(self) -> float:
        """Power that the belt's stretching takes from the energy of bending and squeezing, W."""
    @property
    def closure(self) -> Optional[float]:
        """What nothing accounts for, over power_in; None without power in."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Hysteresis:
    """Power that hysteresis takes in one region, W."""

    @property
    def bending(self) -> float:
        """Of bending the belt."""
    @property
    def groove(self) -> float:
        """Of squeezing it in the groove."""
    @property
    def cord(self) -> float:
        """Of stretching its cord."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Harmonics:
    """How many harmonics were summed."""

    @property
    def bending(self) -> int:
        """Of the curvature."""
    @property
    def groove(self) -> int:
        """Of the penetration."""
    @property
    def cord(self) -> int:
        """Of the strain."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Losses:
    """Power lost besides friction, W. What hysteresis takes in a region may be negative, where the belt gives back more
    than it takes."""

    @property
    def bending(self) -> float:
        """Of bending the belt."""
    @property
    def groove(self) -> float:
        """Of squeezing it in the groove."""
    @property
    def cord(self) -> float:
        """Of stretching its cord."""
    @property
    def drag(self) -> float:
        """Of drag at both pulleys."""
    @property
    def gears(self) -> float:
        """Of gears behind the secondary."""
    @property
    def total(self) -> float:
        """All of these."""
    @property
    def primary(self) -> Hysteresis:
        """Hysteresis in the primary's contact."""
    @property
    def slack_span(self) -> Hysteresis:
        """Hysteresis in the span from the primary to the secondary."""
    @property
    def secondary(self) -> Hysteresis:
        """Hysteresis in the secondary's contact."""
    @property
    def tight_span(self) -> Hysteresis:
        """Hysteresis in the span from the secondary to the primary."""
    @property
    def primary_drag(self) -> float:
        """Power that drags at the primary."""
    @property
    def secondary_drag(self) -> float:
        """Power that drags at the secondary."""
    @property
    def power_out(self) -> float:
        """Power that arrives."""
    @property
    def harmonics(self) -> Harmonics:
        """How many harmonics were summed."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Heat:
    """Heat, W, and the stiffnesses at the belt's temperature."""

    @property
    def belt(self) -> float:
        """Heat that goes into the belt, W."""
    @property
    def primary(self) -> float:
        """Friction's heat that goes into the sheaves of the primary, W."""
    @property
    def secondary(self) -> float:
        """Friction's heat that goes into the sheaves of the secondary, W."""
    @property
    def hotter(self) -> str:
        """The pulley whose sheaves take more heat: "primary" or "secondary"."""
    @property
    def bending_stiffness(self) -> float:
        """Bending stiffness at the temperature, N·m²."""
    @property
    def radial_stiffness(self) -> float:
        """Radial stiffness at the temperature, N/m²."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class MeshIntervals:
    """Intervals of the meshes by region."""

    @property
    def primary(self) -> int:
        """Contact with the primary."""
    @property
    def secondary(self) -> int:
        """Contact with the secondary."""
    @property
    def tight_span(self) -> int:
        """Span from the secondary to the primary."""
    @property
    def slack_span(self) -> int:
        """Span from the primary to the secondary."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class SolverReport:
    """How the solution was found, and how well it holds."""

    @property
    def order(self) -> int:
        """Order of the collocation."""
    @property
    def tolerance(self) -> float:
        """Relative tolerance on the defect."""
    @property
    def mesh_intervals(self) -> MeshIntervals:
        """Intervals of the final meshes."""
    @property
    def max_residual(self) -> float:
        """Largest relative defect on the final meshes."""
    @property
    def max_boundary_residual(self) -> float:
        """Largest boundary residual, scaled."""
    @property
    def newton_iterations(self) -> int:
        """Newton iterations in all."""
    @property
    def continuation_steps(self) -> int:
        """Continuation steps in all."""
    @property
    def wall_time(self) -> Optional[float]:
        """Seconds from the resolved case to the result."""
    def to_dict(self) -> dict[str, Any]:
        """All fields by name."""

@final
class Case:
    """A case: what is given of a drive, every key optional; the base case of the thesis (Table 6.1) applies to others.

    A quantity is a text with a unit ("120 N"), a number in SI units, or a quantity of pint. Keys are named as in a case
    file ("operating_point.slack_tension"), or by their last part alone where that says which ("slack_tension").
    """

    def __new__(cls, case: _CaseLike = None, /, **keys: Any) -> Case: ...
    def with_(self, keys: Optional[Mapping[str, Any]] = None, /, **more: Any) -> Case:
        """The case with some keys set in place of what was given for them."""
    def without(self, *keys: str) -> Case:
        """The case without some of its keys."""
    def swap(self, text: str) -> Case:
        """The case with a constant made unknown and an output prescribed in its place."""
    @property
    def given(self) -> dict[str, Any]:
        """What was given, by key, in SI units: numbers, lists of them, names, and tables as dictionaries."""
    @property
    def remarks(self) -> list[str]:
        """What is worth knowing of the case before it is solved."""
    def resolve(self) -> dict[str, Any]:
        """The case with everything filled in, resolved to SI units. Raises CaseError."""
    def __eq__(self, other: object, /) -> bool: ...
    def __ne__(self, other: object, /) -> bool: ...
    __hash__: None  # type: ignore[assignment]

@final
class Region:
    """One region of the belt: a contact or a span. Columns are those of ``profile.csv``, as attributes or by name.

    The arrays are views of memory that the region holds: nothing is copied, and they cannot be written to.
    """

    @property
    def position(self) -> _Array:
        """Position in the region, from 0 where the belt enters to 1."""
    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
    @property
    def units(self) -> dict[str, str]:
        """Unit of each column; empty for a pure number."""
    @property
    def meanings(self) -> dict[str, str]:
        """What each column is."""
    def to_dict(self) -> dict[str, _Array]:
        """All columns by name."""
    def __getitem__(self, name: str, /) -> _Array: ...
    def __getattr__(self, name: str, /) -> _Array: ...
    def __dir__(self) -> list[str]: ...
    def __len__(self) -> int: ...

@final
class Profile:
    """Every state and derived field along the belt, region by region."""

    @property
    def primary(self) -> Region:
        """Contact with the primary."""
    @property
    def slack_span(self) -> Region:
        """Span from the primary to the secondary."""
    @property
    def secondary(self) -> Region:
        """Contact with the secondary."""
    @property
    def tight_span(self) -> Region:
        """Span from the secondary to the primary."""

@final
class Result:
    """A solved drive. SI units, ratios as fractions."""

    @property
    def primary(self) -> Pulley:
        """The driving pulley."""
    @property
    def secondary(self) -> Pulley:
        """The driven pulley."""
    @property
    def tight_span(self) -> Span:
        """The span from the secondary to the primary."""
    @property
    def slack_span(self) -> Span:
        """The span from the primary to the secondary."""
    @property
    def efficiency(self) -> Efficiency:
        """Efficiencies (6.7) to (6.9)."""
    @property
    def belt(self) -> BeltResult:
        """The belt as a whole."""
    @property
    def energy(self) -> Energy:
        """The energy audit."""
    @property
    def losses(self) -> Optional[Losses]:
        """Power lost besides friction; None where it is not told."""
    @property
    def thermal(self) -> Optional[Heat]:
        """Heat; None where the case does not say what cools the belt."""
    @property
    def solver(self) -> SolverReport:
        """How the solution was found."""
    @property
    def edition(self) -> str:
        """Name of the edition of the equations."""
    @property
    def slip_reserve(self) -> float:
        """Share of the friction at hand that is not yet used."""
    @property
    def friction_utilization(self) -> float:
        """Share of the friction at hand that is used: 1 less the slip reserve."""
    @property
    def found(self) -> dict[str, float]:
        """What was solved for in place of what was prescribed: value in SI units by key of the case file."""
    @property
    def inputs(self) -> dict[str, Any]:
        """The case, resolved to SI units, with what was found."""
    @property
    def other_solution(self) -> Optional[OtherSolution]:
        """The other operating point of an axial force that belongs to two; None where only one was found."""
    @property
    def uncertainty(self) -> Optional[dict[str, float]]:
        """Estimated errors of the outputs, SI, without sign, by output; None where the equations are singular."""
    @property
    def sensitivities(self) -> Optional[dict[str, dict[str, float]]]:
        """Derivatives of the outputs with respect to everything given, SI over SI: by output, then by key."""
    def sensitivity(self, output: str, key: str) -> float:
        """One derivative: that of an output ("efficiency.overall") with respect to a key ("bending_stiffness")."""
    @property
    def warnings(self) -> list[str]:
        """What is to be known before the result is used."""
    @property
    def json(self) -> str:
        """The result as the one JSON object that ``sheave solve --json`` prints."""
    def to_dict(self) -> dict[str, Any]:
        """The same as dictionaries."""
    @property
    def summary(self) -> str:
        """A summary in engineering units, as a person reads it."""
    def profile(self, between: int = 1) -> Profile:
        """Every state and derived field along the belt, at the nodes and at ``between`` points between each two."""
    def figures(self) -> dict[str, dict[str, Any]]:
        """The figures of the result as data: name, caption, axes and series, in the units of the axes."""
    def svg(self, name: str = "trajectory") -> str:
        """A figure as SVG: "trajectory" is the belt's path."""
    def report(self) -> str:
        """The page about the result, with all figures, as HTML."""
    def _repr_html_(self) -> str: ...

@final
class Table:
    """A finished study: one row a point in input order.

    Whatever reads Arrow reads it without a copy. A column of numbers is an array of numpy:
    ``table["efficiency.overall"]``.
    """

    @property
    def columns(self) -> list[str]:
        """Names of the columns."""
    @property
    def axes(self) -> list[tuple[list[str], int]]:
        """What varies: for each axis, its keys and its number of points. The last axis is the fastest."""
    @property
    def failures(self) -> int:
        """How many points have no solution."""
    def __len__(self) -> int: ...
    def __getitem__(self, name: str, /) -> Any:
        """A column: an array of numpy for numbers, a list for names and truths."""
    def write(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the table into a file: .csv, .parquet or .json. The file appears whole."""
    def to_arrow(self) -> Any:
        """As a table of pyarrow, without a copy."""
    def to_pandas(self) -> Any:
        """As a DataFrame of pandas."""
    def to_polars(self) -> Any:
        """As a DataFrame of polars, without a copy."""
    def to_xarray(self) -> Any:
        """As a Dataset of xarray: a dimension for each axis."""
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_stream__(self, requested_schema: Optional[object] = None) -> object: ...

@final
class Study:
    """A study that is not yet solved: a case, what varies in it, and how accurately it is solved."""

    def __new__(
        cls, case: _CaseLike = None, /, *, over: Any = None, tolerance: float = 1e-6, order: int = 4, **keys: Any
    ) -> Study: ...
    def __len__(self) -> int: ...
    @property
    def axes(self) -> list[tuple[list[str], int]]:
        """What varies: for each axis, its keys and its number of points. The last axis is the fastest."""
    @property
    def fingerprint(self) -> str:
        """Everything the rows depend on, as a line of text."""
    def parts(self, points: int = 0) -> list[tuple[int, int]]:
        """The points in parts that can be solved apart: each of at least ``points`` points, the last excepted."""
    def run(
        self,
        start: int = 0,
        stop: Optional[int] = None,
        *,
        jobs: Optional[int] = None,
        progress: Optional[Callable[[int], Any]] = None,
    ) -> Table:
        """Solves all points, or those from ``start`` to below ``stop``."""
    def limits(self, *, least_speed_efficiency: float = 0.95, jobs: Optional[int] = None) -> Table:
        """The limits at every point: the largest torque, unless the load is what varies, and the smallest clamps,
        unless the clamp is."""
    def optima(self, *, jobs: Optional[int] = None) -> Table:
        """The clamp of best overall efficiency at every point."""

@final
class BeltMap:
    """A table of what a belt does over two or more keys of its case, read between its nodes with a known error."""

    @staticmethod
    def read(path: Union[str, PathLike[str]]) -> BeltMap:
        """Reads a map that was written as CSV, by ``write`` or by ``sheave map``. Raises MapError."""
    def write(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the map; the ending of the name says in which form. The file appears whole."""
    @property
    def keys(self) -> list[str]:
        """What the map is over, in the order of coordinates: the keys of its axes."""
    @property
    def units(self) -> dict[str, str]:
        """Unit of each axis, by key."""
    @property
    def breakpoints(self) -> dict[str, _Array]:
        """Where the map has nodes, SI: breakpoints by key."""
    @property
    def quantities(self) -> dict[str, str]:
        """What the map tells, with its unit."""
    @property
    def report(self) -> dict[str, Any]:
        """How the map was made, and how accurate it is."""
    @property
    def inputs(self) -> dict[str, Any]:
        """The case in the middle of the map, resolved to SI units."""
    def at(self, *coordinates: float, **by_key: float) -> dict[str, float]:
        """Everything at one point: its coordinates in the order of ``keys``, or by key, named as for ``over``.

        Raises MapError outside the map.
        """
    def interpolate(self, quantity: str, points: ArrayLike) -> tuple[_Array, _Array]:
        """A quantity at many points of shape (m, axes): values (m,) and derivatives (m, axes); NaN outside."""
    def table_bytes(self) -> bytes:
        """The table of the map as the library of a Functional Mock-up Unit reads it."""

@final
class ShiftBranches:
    """The branches of a shift curve."""

    @property
    def edition(self) -> str:
        """Name of the edition of the equations."""
    @property
    def warnings(self) -> list[str]:
        """What is to be known before the curve is used."""
    def table(self) -> Table:
        """One row a point."""
    def told(self) -> list[dict[str, Any]]:
        """What is known of each branch, as dictionaries."""
    def figures(self, other: Optional[ShiftBranches] = None, name: str = "other") -> dict[str, Any]:
        """The panels of the figure as data."""
    def svg(self, other: Optional[ShiftBranches] = None, name: str = "other") -> str:
        """The figure as SVG."""

@final
class Ranked:
    """What was found in a box of parts."""

    def told(self) -> dict[str, Any]:
        """All of it as dictionaries."""
    def table(self, pareto: bool = False) -> Table:
        """All tunes with their parts and merits, best first."""
    @property
    def map(self) -> BeltMap:
        """The map on which combinations were screened."""
    def case(self, candidate: int) -> Case:
        """The case with the parts of a combination in it."""
    @property
    def summary(self) -> str:
        """The best in words."""
    def figures(self) -> dict[str, Any]:
        """Deviation over slip reserve as data."""
    def svg(self) -> str:
        """Deviation over slip reserve as SVG."""

@final
class BvpSolution:
    """The solution of a boundary value problem."""

    @property
    def x(self) -> _Array: ...
    @property
    def y(self) -> _Array: ...
    @property
    def yp(self) -> _Array: ...
    @property
    def p(self) -> Optional[_Array]: ...
    @property
    def max_defect(self) -> float: ...
    @property
    def max_boundary_residual(self) -> float: ...
    @property
    def error_estimate(self) -> float: ...
    @property
    def accurate(self) -> bool: ...
    @property
    def niter(self) -> int: ...
    @property
    def meshes(self) -> int: ...
    @property
    def evaluations(self) -> int: ...
    def evaluate(self, x: Sequence[float]) -> _Array: ...

def solve(
    case: _CaseLike = None,
    /,
    *,
    tolerance: float = 1e-6,
    order: int = 4,
    sensitivities: bool = False,
    near: Optional[Result] = None,
    branch: Optional[str] = None,
    work_limit: int = ...,
    **keys: Any,
) -> Result:
    """Solves a case.

    ``case`` is a path, the text of a case file, a dictionary of keys or a Case; without it, the base case is solved.
    ``tolerance`` bounds the relative defect (1e-12 to 0.1), ``order`` is that of the collocation (4, 6 or 8). With
    ``sensitivities``, the result has the derivatives of all outputs with respect to everything given. ``near`` is a
    result of a similar case from which the search starts; if that does not lead to a solution, it starts from nothing.
    Where an axial force is given that belongs to two operating points, ``branch`` says which is meant: that of the
    tighter belt ("tight", as without a word) or of the looser ("loose"); ``other_solution`` has what is known of the
    other. From a result nearby, the other is looked for only where ``branch`` is given. ``work_limit`` is the work that
    the search may take, in Newton iterations, each counted once for every interval of the mesh. All other arguments are
    keys of the case.

    Raises CaseError, SolveError.
    """

def keys() -> list[dict[str, Any]]:
    """All keys of a case file: name, unit, default in SI units, choices, what is expected, and meaning."""

def rebuild_case(given: Mapping[str, Any], swaps: Sequence[str]) -> Case: ...
def rebuild_study(case: Case, axes: Sequence[str], tolerance: float, order: int) -> Study: ...
def rebuild_table(columns: Sequence[str], rows: str, axes: Sequence[tuple[list[str], int]]) -> Table: ...
def bare_seconds(case: Case, near: Result, repeats: int, tolerance: float) -> list[tuple[float, float]]: ...
def limit(
    case: _CaseLike = None,
    /,
    *,
    least_speed_efficiency: float = 0.95,
    tolerance: float = 1e-6,
    **keys: Any,
) -> dict[str, Any]: ...
def optimum(case: _CaseLike = None, /, *, tolerance: float = 1e-6, **keys: Any) -> dict[str, Any]: ...
def map(
    case: _CaseLike = None,
    /,
    *,
    over: Any,
    accuracy: float = 1e-3,
    tolerance: Optional[float] = None,
    max_points: int = 20_000,
    least_speed_efficiency: float = 0.9,
    jobs: Optional[int] = None,
    progress: Optional[Callable[[int], Any]] = None,
    **keys: Any,
) -> BeltMap: ...
def drive(
    case: _CaseLike = None,
    /,
    *,
    speed: Any = None,
    vehicle_speed: Any = None,
    direction: str = "up",
    tolerance: float = 1e-6,
    order: int = 4,
    **keys: Any,
) -> tuple[dict[str, Any], Result]: ...
def shift(
    case: _CaseLike = None,
    /,
    *,
    points: int = 24,
    direction: str = "both",
    start: Any = None,
    stop: Any = None,
    data: Union[str, PathLike[str], None] = None,
    tolerance: float = 1e-6,
    progress: Optional[Callable[[int], Any]] = None,
    **keys: Any,
) -> ShiftBranches: ...
def tune(
    case: _CaseLike = None,
    /,
    *,
    parts: Union[str, PathLike[str], Mapping[str, Any]],
    target: Any,
    map: Optional[BeltMap] = None,
    accuracy: float = 1e-2,
    max_points: int = 20_000,
    points: int = 11,
    least_reserve: float = 0.0,
    best: int = 10,
    jobs: Optional[int] = None,
    progress: Optional[Callable[[int], Any]] = None,
    **keys: Any,
) -> Ranked: ...
def fmu_library() -> tuple[str, str, bytes]: ...
def belt(file: Union[str, PathLike[str]], *, temperature: Any = None) -> dict[str, Any]: ...
def dyno(
    paths: Sequence[Union[str, PathLike[str]]],
    *,
    calibration: Union[str, PathLike[str], None] = None,
    engine: Union[str, PathLike[str], None] = None,
    gear: float = 1.0,
    torque_at: str = "secondary",
    rate: float = 125.0,
    window: float = 3.0,
    longest_gap: float = 0.25,
    primary: Optional[str] = None,
    secondary: Optional[str] = None,
    torque: Optional[str] = None,
    secondary_factor: float = 1.0,
    runs: Union[str, PathLike[str], None] = None,
    revolutions_per_firing: float = 2.0,
) -> dict[str, Any]: ...
def compare(
    case: _CaseLike = None,
    /,
    *,
    data: Union[str, PathLike[str]],
    engine: Union[str, PathLike[str], None] = None,
    flyweights: Union[str, PathLike[str], None] = None,
    radii: str = "speeds",
    fit: Sequence[str] = ...,
    tolerance: float = 1e-4,
    **keys: Any,
) -> dict[str, Any]: ...
def solve_bvp(
    f: Callable[..., ArrayLike],
    bc: Callable[..., ArrayLike],
    mesh: Sequence[float],
    guess: Sequence[Sequence[float]],
    parameters: Sequence[float],
    jacobian: Optional[Callable[..., Any]],
    boundary_jacobian: Optional[Callable[..., Any]],
    tolerance: float,
    boundary_tolerance: Optional[float],
    order: str,
    max_intervals: int,
    work_limit: Optional[int],
) -> BvpSolution: ...
