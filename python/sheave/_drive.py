"""Whole drives as typed results: where a drive settles, its shift curve, the tune of a box of parts."""

from __future__ import annotations

import html
import math
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _sheave
from ._api import Progress, progress_bar
from ._sheave import BeltMap, Case, Result, Table
from .errors import DesignError

if TYPE_CHECKING:
    from os import PathLike

    from ._api import CaseLike

__all__ = [
    "Confirmed",
    "Deviation",
    "Equilibrium",
    "Landmark",
    "Merits",
    "PartEffect",
    "Refused",
    "ShiftBranch",
    "ShiftCurve",
    "Tune",
    "Tuning",
    "drive",
    "shift",
    "tune",
]

_SHOWN = 10
"""Tunes that a notebook shows."""


def _only(kind: type, told: Mapping[str, Any]) -> dict[str, Any]:
    """What is told of a dataclass's fields."""
    return {one.name: told[one.name] for one in fields(kind) if one.name in told}


def _rpm(speed: float) -> float:
    return speed * 30 / math.pi


def _rows(rows: list[list[str]], header: list[str]) -> str:
    """A table of HTML, its cells escaped."""
    cell = '<td style="text-align:left">{}</td>'
    head = "".join(f'<th style="text-align:left">{html.escape(one)}</th>' for one in header)
    body = "".join("<tr>" + "".join(cell.format(html.escape(one)) for one in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _warned(warnings: list[str]) -> str:
    return "".join(f"<p><strong>Warning.</strong> {html.escape(warning)}</p>" for warning in warnings)


@dataclass(frozen=True)
class PartEffect:
    """What a part does to an equilibrium, exactly: derivatives with respect to its key, in SI units."""

    key: str
    """The part's key in the case file."""
    primary_speed: float
    """Of the primary's speed at the same speed of the secondary, rad/s over the key's unit."""
    ratio: float
    """Of the ratio at the same speed of the secondary, over the key's unit."""
    shift_speed: Optional[float]
    """Of the primary's speed at the same ratio: how the shift line moves. None at a stop."""


@dataclass(frozen=True)
class Equilibrium:
    """Where a whole drive settles. SI units, ratios as fractions."""

    edition: str
    phase: str
    """Where the sheaves stand: ``"low"``, ``"shift"``, ``"high"`` or ``"held"``."""
    stop: Optional[str]
    """The stop on which a sheave rests."""
    stop_force: Optional[float]
    """Force on that stop, N."""
    direction: str
    """Which way friction in the actuators acts: ``"up"``, ``"back"`` or ``"frictionless"``."""
    secondary_speed: float
    """Speed of the secondary, rad/s."""
    primary_speed: float
    """Speed of engine and primary, rad/s."""
    vehicle_speed: Optional[float]
    """Speed of the vehicle, m/s; None for a case without one."""
    acceleration: Optional[float]
    """What the vehicle's acceleration would be, m/s²."""
    speed_ratio: float
    """Speed of the primary over that of the secondary."""
    ratio: float
    """Radius on the secondary over that on the primary."""
    primary_torque: float
    """Torque into the primary, N·m."""
    primary_travel: float
    """Travel of the primary from its start, m."""
    secondary_travel: float
    """Opening of the secondary from where it is closed, m."""
    flyweight_force: Optional[float]
    """Force of the flyweights, N; None where a motor holds the primary."""
    primary_spring_force: Optional[float]
    """Force of the primary's spring, N, negative as it opens the sheaves."""
    primary_axial_force: float
    """Axial force of the belt on the primary, N."""
    helix_force: float
    """Force of the helix with its torsion spring, N."""
    secondary_spring_force: float
    """Force of the secondary's spring in compression, N."""
    secondary_axial_force: float
    """Axial force of the belt on the secondary, N."""
    force_residual: float
    """Difference of actuator and belt where they balance, over the belt's force."""
    slip_reserve: float
    """Share of the friction at hand that is left over."""
    slipping: bool
    """Whether the belt slips as a whole, or is about to."""
    doubt: Optional[str]
    """What else keeps the drive from being sound, the worst of it: ``"buckled"``, ``"pushed"``, ``"driven"`` or
    ``"sliding"``; None for a sound drive."""
    slip: str
    """The same in words."""
    speed_efficiency: Optional[float]
    efficiency: Optional[float]
    """Overall efficiency, with losses besides friction where the case has them."""
    power_in: float
    """Power from the engine, W."""
    power_out: float
    """Power out of the secondary, W."""
    belt_temperature: Optional[float]
    """Temperature of the belt, K; None where the case does not say what cools it."""
    parts: list[PartEffect] = field(repr=False)
    """What each part does to speed and ratio."""
    warnings: list[str] = field(repr=False)
    """What is to be known before the result is used."""
    belt: Result = field(repr=False)
    """What the belt does, as ``solve`` has it."""
    summary: str = field(repr=False)
    """In engineering units, as a person reads it."""

    def to_dict(self) -> dict[str, Any]:
        """The numbers by name, without the belt's solution and the parts."""
        left_out = {"parts", "warnings", "belt", "summary"}
        return {one.name: getattr(self, one.name) for one in fields(self) if one.name not in left_out}

    def to_pandas(self) -> Any:
        """What each part does, as a DataFrame of pandas with a row a part."""
        import pandas

        return pandas.DataFrame([vars(part) for part in self.parts]).set_index("key")

    def _repr_html_(self) -> str:
        svg = self.belt.svg("trajectory")
        text = html.escape(self.summary)
        drawing = f'<div style="max-width:640px">{svg}</div>'
        return f'<div class="sheave">{drawing}<pre>{text}</pre>{_warned(self.warnings)}</div>'

    def __str__(self) -> str:
        return self.summary


def drive(
    case: CaseLike = None,
    /,
    *,
    speed: Any = None,
    vehicle_speed: Any = None,
    direction: str = "up",
    tolerance: float = 1e-6,
    order: int = 4,
    **keys: Any,
) -> Equilibrium:
    """Finds where a whole drive settles: belt, actuators and engine as one problem.

    The case has ``[primary.actuator]`` and ``[secondary.actuator]`` with their springs, ``[engine]``, and if it likes
    ``[vehicle]``. ``speed`` is the secondary's (``"2000 rpm"``), ``vehicle_speed`` the vehicle's in its place
    (``"30 km/h"``); ``direction`` says which way the drive shifts, ``"up"``, ``"back"`` or ``"frictionless"``. All
    other arguments are keys of the case.

    Raises ``CaseError``, ``SolveError``.
    """
    told, belt = _sheave.drive(
        case, speed=speed, vehicle_speed=vehicle_speed, direction=direction, tolerance=tolerance, order=order, **keys
    )
    parts = [PartEffect(**_only(PartEffect, part)) for part in told["parts"]]
    return Equilibrium(**{**_only(Equilibrium, told), "parts": parts, "belt": belt})


@dataclass(frozen=True)
class Landmark:
    """A point of a shift curve that means something by itself."""

    primary_speed: float
    """rad/s."""
    secondary_speed: float
    """rad/s."""
    ratio: float
    """Radius on the secondary over that on the primary."""


@dataclass(frozen=True)
class Deviation:
    """Measured speeds of the primary beside a branch."""

    points: int
    """Measured points between the ends of the branch."""
    rms: float
    """Root mean square of curve less measured, rad/s."""
    mean: float
    """Mean of curve less measured, rad/s."""


@dataclass(frozen=True)
class ShiftBranch:
    """What is known of a shift curve in one direction."""

    direction: str
    engagement_speed: Optional[float]
    """Speed of the primary in rad/s from which flyweights overcome their spring."""
    take_off: Optional[Landmark]
    """Where the belt takes the drive off."""
    shift_out: Optional[Landmark]
    """Where the drive leaves the low stop."""
    full_shift: Optional[Landmark]
    """Where it arrives at the high stop."""
    deviation: Optional[Deviation]
    """How far measured points lie from it, where there are some."""
    remarks: list[str]
    """Why something is missing."""

    @classmethod
    def _of(cls, told: Mapping[str, Any]) -> ShiftBranch:
        kinds: dict[str, Any] = {
            "take_off": Landmark,
            "shift_out": Landmark,
            "full_shift": Landmark,
            "deviation": Deviation,
        }
        made = {name: told[name] and kind(**_only(kind, told[name])) for name, kind in kinds.items()}
        return cls(**{**_only(cls, told), **made})


class ShiftCurve:
    """The shift curve of a whole drive: engine speed over road speed, up and back."""

    def __init__(self, found: _sheave.ShiftBranches) -> None:
        self._found = found
        self.edition: str = found.edition
        self.branches: list[ShiftBranch] = [ShiftBranch._of(told) for told in found.told()]
        self.warnings: list[str] = found.warnings

    @cached_property
    def table(self) -> Table:
        """One row a point, by direction and speed of the secondary; a point without an equilibrium says why."""
        return self._found.table()

    def branch(self, direction: str) -> ShiftBranch:
        """The branch of a direction, ``"up"``, ``"back"`` or ``"frictionless"``. Raises KeyError if there is none."""
        for branch in self.branches:
            if branch.direction == direction:
                return branch
        raise KeyError(direction)

    def to_pandas(self) -> Any:
        """The points as a DataFrame of pandas."""
        return self.table.to_pandas()

    def figures(self, beside: Optional[ShiftCurve] = None, name: str = "other") -> dict[str, Any]:
        """The panels of the figure as data; another curve is drawn beside it under ``name``."""
        return self._found.figures(None if beside is None else beside._found, name)

    def svg(self, beside: Optional[ShiftCurve] = None, name: str = "other") -> str:
        """The figure as SVG; another curve is drawn beside it under ``name``."""
        return self._found.svg(None if beside is None else beside._found, name)

    def _repr_html_(self) -> str:
        names = {
            "take_off": "the belt takes the drive off",
            "shift_out": "it leaves the low stop",
            "full_shift": "it arrives at the high stop",
        }
        rows = []
        for branch in self.branches:
            if branch.engagement_speed is not None:
                rows.append([branch.direction, "flyweights engage", f"{_rpm(branch.engagement_speed):.0f}", "", ""])
            for attribute, name in names.items():
                place: Optional[Landmark] = getattr(branch, attribute)
                if place is not None:
                    speeds = [f"{_rpm(place.primary_speed):.0f}", f"{_rpm(place.secondary_speed):.0f}"]
                    rows.append([branch.direction, name, *speeds, f"{place.ratio:.2f}"])
        header = ["direction", "where", "engine (rpm)", "secondary (rpm)", "ratio"]
        remarks = [remark for branch in self.branches for remark in branch.remarks]
        return (
            f'<div class="sheave"><div style="max-width:640px">{self.svg()}</div>{_rows(rows, header)}'
            f"{_warned([*self.warnings, *remarks])}</div>"
        )

    def __repr__(self) -> str:
        directions = " and ".join(branch.direction for branch in self.branches)
        failures = f", {self.table.failures} without an equilibrium" if self.table.failures else ""
        return f"<sheave.ShiftCurve: {len(self.table)} points, {directions}{failures}>"


def shift(
    case: CaseLike = None,
    /,
    *,
    points: int = 24,
    direction: str = "both",
    start: Any = None,
    stop: Any = None,
    data: Union[str, PathLike[str], None] = None,
    tolerance: float = 1e-6,
    progress: Progress = None,
    **keys: Any,
) -> ShiftCurve:
    """Computes the shift curve of a whole drive: engine speed over road speed, up and back.

    ``points`` are those of each direction, half of them between the stops. ``direction`` is ``"both"`` (up and back),
    ``"up"``, ``"back"`` or ``"frictionless"``. ``start`` and ``stop`` are speeds of the secondary; without them the
    curve goes from where the belt takes the drive off to where the engine gives no more torque. ``data`` is a CSV file
    of measured speeds, with the columns ``secondary_rpm`` and ``primary_rpm``. ``progress`` is as for ``sweep``. All
    other arguments are keys of the case.

    Raises ``CaseError``, ``BenchError`` for the data; a point without an equilibrium says so in its row.
    """
    # How many points the phases have is known when their ends are.
    with progress_bar(progress, None) as tell:
        return ShiftCurve(
            _sheave.shift(
                case,
                points=points,
                direction=direction,
                start=start,
                stop=stop,
                data=data,
                tolerance=tolerance,
                progress=tell,
                **keys,
            )
        )


@dataclass(frozen=True)
class Merits:
    """What a combination of parts does over the shift."""

    rms_deviation: float
    """Root mean square of the engine's speed less the target, rad/s."""
    mean_speed: float
    """Mean of the engine's speed, rad/s."""
    smallest_slip_reserve: float
    """Smallest share of the friction at hand that is left over."""
    mean_efficiency: float
    """Mean of power out over power in, with losses besides friction where the case has them."""


@dataclass(frozen=True)
class Confirmed:
    """What full solutions say of a combination of parts."""

    merits: Optional[Merits]
    """Over the points of the shift on the map that have a solution at their speed of the secondary."""
    points: int
    """How many of the points have one."""
    at_stop: int
    """How many of these rest on a stop."""
    largest_difference: float
    """Largest difference of the engine's speed between map and full solution, rad/s."""
    failures: list[str]
    """Why points have none."""

    @classmethod
    def _of(cls, told: Mapping[str, Any]) -> Confirmed:
        merits = Merits(**_only(Merits, told)) if "rms_deviation" in told else None
        return cls(**{**_only(cls, told), "merits": merits})


@dataclass(frozen=True)
class Tune:
    """A combination of parts that shifts."""

    candidate: int
    """Its number among all combinations."""
    parts: dict[str, str]
    """Names of its parts, by kind."""
    merits: Merits
    """As screened on the map."""
    points: int
    """Points over which these are."""
    last_ratio: float
    """Nominal ratio of the last: where a sheave comes to its stop at high ratio, or the nominal end of the shift."""
    pareto: bool
    """Whether no other beats it: is no worse in deviation, slip reserve and efficiency, and better in one of them."""
    confirmed: Optional[Confirmed]
    """As full solutions have it; of the best alone."""

    @classmethod
    def _of(cls, told: Mapping[str, Any]) -> Tune:
        confirmed = told.get("confirmed")
        return cls(
            candidate=told["candidate"],
            parts=told["parts"],
            merits=Merits(**_only(Merits, told)),
            points=told["points"],
            last_ratio=told["last_ratio"],
            pareto=told["pareto"],
            confirmed=confirmed and Confirmed._of(confirmed),
        )


@dataclass(frozen=True)
class Refused:
    """Combinations that were refused for the same reason."""

    reason: str
    count: int
    candidate: int
    """The first of them."""
    example: str
    """What is wrong with that."""


class Tuning:
    """What was found in a box of parts."""

    def __init__(self, found: _sheave.Ranked) -> None:
        told = found.told()
        self._found = found
        self.target: float = told["target"]
        """Speed asked for, rad/s."""
        self.candidates: int = told["candidates"]
        """Combinations in the box."""
        self.points: int = told["points"]
        """Points of the shift of each, at most."""
        self.ratios: list[float] = told["ratios"]
        """Nominal ratios of these."""
        self.readings: int = told["readings"]
        """Readings of the map."""
        self.in_full: int = told["in_full"]
        """Points that were sought by full solutions, because the map has no values there."""
        self.tunes: list[Tune] = [Tune._of(one) for one in told["tunes"]]
        """Combinations that shift, the smallest deviation first."""
        self.refused: list[Refused] = [Refused(**_only(Refused, one)) for one in told["refused"]]
        """The others."""

    @property
    def map(self) -> BeltMap:
        """The map on which combinations were screened: ``tune(..., map=this)`` uses it again."""
        return self._found.map

    @property
    def best(self) -> Tune:
        """The combination of smallest deviation. Raises ``DesignError`` where none shifts, with the reasons."""
        if not self.tunes:
            reasons = "; ".join(f"{one.count} {one.reason} ({one.example})" for one in self.refused)
            raise DesignError(f"none of {self.candidates} combinations shifts: {reasons}")
        return self.tunes[0]

    @property
    def pareto(self) -> list[Tune]:
        """Those that no other beats in deviation, slip reserve and efficiency at once."""
        return [one for one in self.tunes if one.pareto]

    @cached_property
    def table(self) -> Table:
        """All that shift, one row each with its parts and merits, best first."""
        return self._found.table()

    def case(self, tune: Union[Tune, int]) -> Case:
        """The case with the parts of a combination in it."""
        return self._found.case(tune if isinstance(tune, int) else tune.candidate)

    def to_pandas(self) -> Any:
        """All that shift as a DataFrame of pandas."""
        return self.table.to_pandas()

    def figures(self) -> dict[str, Any]:
        """Deviation over slip reserve as data."""
        return self._found.figures()

    def svg(self) -> str:
        """Deviation over slip reserve as SVG."""
        return self._found.svg()

    @property
    def summary(self) -> str:
        """The best in words."""
        return self._found.summary

    def _repr_html_(self) -> str:
        if not self.tunes:
            return f"<pre>{html.escape(self.summary)}</pre>"
        rows = []
        for one in self.tunes[:_SHOWN]:
            full = one.confirmed.merits if one.confirmed else None
            rows.append(
                [
                    *one.parts.values(),
                    f"{_rpm(one.merits.rms_deviation):.1f}",
                    f"{_rpm(full.rms_deviation):.1f}" if full else "",
                    f"{100 * one.merits.smallest_slip_reserve:.1f}",
                    f"{100 * one.merits.mean_efficiency:.2f}",
                    "*" if one.pareto else "",
                ]
            )
        header = [
            *self.tunes[0].parts,
            "rms deviation (rpm)",
            "by full solutions",
            "slip reserve (%)",
            "efficiency (%)",
            "beaten by none",
        ]
        return f'<div class="sheave"><div style="max-width:640px">{self.svg()}</div>{_rows(rows, header)}</div>'

    def __repr__(self) -> str:
        target = f"{_rpm(self.target):.0f} rpm"
        return f"<sheave.Tuning: {len(self.tunes)} of {self.candidates} combinations shift, for {target}>"

    def __str__(self) -> str:
        return self.summary


def tune(
    case: CaseLike = None,
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
    progress: Progress = None,
    **keys: Any,
) -> Tuning:
    """Finds the combination of parts that holds the engine at ``target`` (``"3400 rpm"``) over the whole shift.

    ``parts`` is a file of parts, or the same as a dictionary: a kind has parts by name, each with the keys of the case
    that it sets; or one key with a list of values. Keys and values are those of cases, so that keys may be shortened,
    and an array is a list::

        tune("drive.toml", target="3400 rpm", parts={
            "flyweight": {"light": {"primary.actuator.mass": "45 g"}, "heavy": {"primary.actuator.mass": "72 g"}},
            "helix": {"helix_angle": ["32 deg", "36 deg"]},
        })

    The belt is mapped to ``accuracy`` in at most ``max_points`` points, unless there is a ``map``; every combination is
    balanced against the map at ``points`` of the shift, and the ``best`` are confirmed by full solutions. ``progress``
    is as for ``sweep``, with points of the map and combinations counted together. All other arguments are keys of the
    case.

    Raises ``CaseError`` also for the box of parts, ``MapError``, ``StudyError``.
    """
    # How many points it takes is known at the end only.
    with progress_bar(progress, None) as tell:
        return Tuning(
            _sheave.tune(
                case,
                parts=parts,
                target=target,
                map=map,
                accuracy=accuracy,
                max_points=max_points,
                points=points,
                least_reserve=least_reserve,
                best=best,
                jobs=jobs,
                progress=tell,
                **keys,
            )
        )
