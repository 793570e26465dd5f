"""Whole drives: equilibria, shift curves, the search for a tune."""

import os
import signal
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sheave

RPM = np.pi / 30
PARTS = {
    "mass": {"primary.actuator.mass": ["134 g", 0.160]},
    "primary_spring": {
        "soft": {"primary.spring.rate": "45 lbf/in", "primary.spring.preload": "60 lbf"},
        "as built": {"primary.spring.rate": "60 lbf/in", "primary.spring.preload": "67.5 lbf"},
        "far too strong": {"primary.spring.rate": "60 lbf/in", "primary.spring.preload": "20 kN"},
    },
    "helix": {"secondary.actuator.helix_angle": ["31 deg", "34 deg"]},
    "pretension": {"secondary.spring.pretension": ["45 deg", "75 deg"]},
}


@pytest.fixture(scope="module")
def gx9(root: Path) -> sheave.Case:
    return sheave.Case(root / "examples" / "drive" / "gx9.toml")


@pytest.fixture(scope="module")
def settled(gx9: sheave.Case) -> sheave.Equilibrium:
    return sheave.drive(gx9, speed="2000 rpm", tolerance=1e-4)


def test_a_drive_settles_where_its_forces_balance(settled: sheave.Equilibrium) -> None:
    assert settled.secondary_speed == pytest.approx(2000 * RPM)
    assert settled.phase in {"low", "shift", "high"}
    assert abs(settled.force_residual) < 1e-6
    assert settled.flyweight_force is not None and settled.primary_spring_force is not None
    presses = settled.flyweight_force + settled.primary_spring_force
    # A stop carries what is left over.
    if settled.phase == "shift":
        assert presses == pytest.approx(settled.primary_axial_force, rel=1e-6)
    assert settled.belt.primary.axial_force == settled.primary_axial_force
    assert settled.belt.secondary.speed == settled.secondary_speed
    assert settled.ratio == pytest.approx(settled.belt.secondary.radius / settled.belt.primary.radius)


def test_an_equilibrium_is_shown(settled: sheave.Equilibrium) -> None:
    assert "does it slip?" in str(settled) and settled.slip in settled.summary
    html = settled._repr_html_()
    assert "<svg" in html and "engine and primary" in html
    told = settled.to_dict()
    assert told["primary_speed"] == settled.primary_speed and "belt" not in told
    parts = settled.to_pandas()
    assert len(parts) == len(settled.parts) > 0
    assert np.isfinite(parts["primary_speed"]).all()


def test_what_a_part_does_is_its_derivative(gx9: sheave.Case) -> None:
    """Heavier flyweights pull the engine down, as much as the exact derivative says."""

    def speed(mass: float) -> sheave.Equilibrium:
        return sheave.drive(gx9.with_({"primary.actuator.mass": mass}), speed="2000 rpm", tolerance=1e-8)

    mass = gx9.given["primary.actuator.mass"]
    assert isinstance(mass, float)
    step = 1e-3 * mass
    here = speed(mass)
    (effect,) = (part for part in here.parts if part.key == "primary.actuator.mass")
    difference = (speed(mass + step).primary_speed - speed(mass - step).primary_speed) / (2 * step)
    assert effect.primary_speed == pytest.approx(difference, rel=1e-3)


def test_a_drive_is_told_its_speed_in_one_way(gx9: sheave.Case, settled: sheave.Equilibrium) -> None:
    by_vehicle = sheave.drive(gx9, vehicle_speed=settled.vehicle_speed, tolerance=1e-4)
    assert by_vehicle.primary_speed == pytest.approx(settled.primary_speed, rel=1e-3)
    by_case = sheave.drive(gx9, secondary_speed="2000 rpm", tolerance=1e-4)
    assert by_case.primary_speed == pytest.approx(settled.primary_speed, rel=1e-3)
    unused = sheave.drive(gx9, speed=2000 * RPM, slack_tension="120 N", tolerance=1e-3)
    assert any("slack_tension" in warning for warning in unused.warnings)


@pytest.mark.parametrize(
    ("keys", "reason"),
    [
        ({"speed": "2000 rpm", "direction": "down"}, "direction"),
        ({}, "at which speed"),
        ({"speed": "2000 rpm", "vehicle_speed": "30 km/h"}, "not both"),
        ({"speed": "-3 rad/s"}, "positive"),
        ({"speed": -5}, r"^speed = -5: expected an angular speed that is positive and finite$"),
        ({"vehicle_speed": -5}, r"^vehicle_speed = -5: expected a speed that is positive and finite$"),
        ({"speed": float("nan")}, "positive"),
        ({"speed": "3 kg"}, "speed"),
        ({"speed": "2000 rpm", "tolerance": 2.0}, "tolerance"),
    ],
)
def test_wrong_questions_are_refused(gx9: sheave.Case, keys: dict[str, Any], reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        sheave.drive(gx9, **keys)


def test_a_case_without_actuators_has_no_equilibrium() -> None:
    with pytest.raises(sheave.CaseError, match="actuators"):
        sheave.drive(speed="2000 rpm")
    with pytest.raises(sheave.CaseError, match="actuators"):
        sheave.shift()


def test_a_shift_curve_has_a_table_and_landmarks(gx9: sheave.Case, tmp_path: Path) -> None:
    told: list[int] = []
    curve = sheave.shift(gx9, points=6, direction="up", tolerance=1e-3, progress=told.append)
    assert told[-1] == len(curve.table) >= 5
    speeds = curve.table["secondary_speed"]
    assert np.all(np.diff(speeds) > 0)
    branch = curve.branch("up")
    assert branch.engagement_speed is not None and branch.shift_out is not None and branch.full_shift is not None
    assert branch.shift_out.ratio > branch.full_shift.ratio
    assert branch.deviation is None
    with pytest.raises(KeyError):
        curve.branch("back")
    frame = curve.to_pandas()
    assert set(frame["direction"]) == {"up"} and frame["converged"].all()
    assert set(frame["phase"]) <= {"engagement", "low", "shift", "high"}
    html = curve._repr_html_()
    assert "<svg" in html and "it leaves the low stop" in html
    assert "shift" in curve.figures() and "points, up" in repr(curve)
    # Points of the curve itself deviate from it by nothing.
    data = tmp_path / "measured.csv"
    rows = zip(speeds, curve.table["primary_speed"], strict=True)
    data.write_text("secondary_speed,primary_speed\n" + "".join(f"{one},{other}\n" for one, other in rows))
    same = sheave.shift(gx9, points=6, direction="up", tolerance=1e-3, data=data)
    deviation = same.branch("up").deviation
    assert deviation is not None and deviation.points >= 4 and deviation.rms < 1e-6
    assert "that one" in curve.svg(beside=same, name="that one")
    with pytest.raises(sheave.BenchError, match="cannot be read"):
        sheave.shift(gx9, data=tmp_path / "nowhere.csv")
    with pytest.raises(ValueError, match="points"):
        sheave.shift(gx9, points=1)


@pytest.fixture(scope="module")
def tuning(gx9: sheave.Case) -> sheave.Tuning:
    return sheave.tune(gx9, parts=PARTS, target="3200 rpm", accuracy=5e-2, max_points=300, points=5, best=1)


def test_a_box_of_parts_is_searched(tuning: sheave.Tuning) -> None:
    assert tuning.candidates == 24
    assert len(tuning.tunes) + sum(refused.count for refused in tuning.refused) == 24
    assert tuning.tunes and all(one.parts["primary_spring"] != "far too strong" for one in tuning.tunes)
    best = tuning.best
    assert set(best.parts) == set(PARTS)
    deviations = [one.merits.rms_deviation for one in tuning.tunes]
    assert deviations == sorted(deviations) and best.pareto and best in tuning.pareto
    assert best.confirmed is not None and best.confirmed.points == 5
    assert best.confirmed.merits is not None
    assert best.confirmed.largest_difference < 0.03 * tuning.target
    assert all(one.confirmed is None for one in tuning.tunes[1:])


def test_a_tune_is_a_case_that_settles(tuning: sheave.Tuning) -> None:
    """The full solution of the best holds the engine where the search says that it does."""
    best = tuning.best
    case = tuning.case(best)
    assert case.given["secondary.actuator.helix_angle"] == pytest.approx(
        np.radians(float(best.parts["helix"].split()[0]))
    )
    found = sheave.drive(case, speed=2000 * RPM, tolerance=1e-4)
    assert found.phase == "shift"
    assert abs(found.primary_speed - best.merits.mean_speed) < 0.15 * tuning.target
    with pytest.raises(ValueError, match="there are 24"):
        tuning.case(24)


def test_a_tuning_is_shown_and_its_map_used_again(tuning: sheave.Tuning, gx9: sheave.Case) -> None:
    frame = tuning.to_pandas()
    assert len(frame) == len(tuning.tunes) and frame["rms_deviation"].is_monotonic_increasing
    html = tuning._repr_html_()
    assert "<svg" in html and "beaten by none" in html and "combinations shift" in repr(tuning)
    assert "combinations of parts for 3200 rpm" in str(tuning) and "pareto" in tuning.figures()
    told: list[int] = []
    options: dict[str, Any] = {"target": 3200 * RPM, "points": 5, "best": 0}
    again = sheave.tune(gx9, parts=PARTS, map=tuning.map, progress=told.append, **options)
    assert [one.candidate for one in again.tunes] == [one.candidate for one in tuning.tunes]
    assert told[-1] == 24, "combinations alone: there was no map to make"
    with pytest.raises(sheave.MapError, match=r"made with `sheave\.friction_coefficient` = "):
        sheave.tune(gx9.with_({"sheave.friction_coefficient": 0.2}), parts=PARTS, map=tuning.map, **options)
    # A reserve that none keeps: nothing shifts, and the map is not lost.
    none = sheave.tune(gx9, parts=PARTS, map=tuning.map, least_reserve=0.99, **options)
    assert not none.tunes and "slip reserve" in none._repr_html_()
    with pytest.raises(sheave.DesignError, match="slip reserve"):
        _ = none.best


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_ends_a_search_of_many_combinations(tuning: sheave.Tuning, gx9: sheave.Case) -> None:
    parts = {
        "mass": {"primary.actuator.mass": np.linspace(0.1, 0.2, 30).tolist()},
        "helix": {"secondary.actuator.helix_angle": [f"{angle} deg" for angle in np.linspace(25, 40, 30)]},
        "pretension": {"secondary.spring.pretension": [f"{angle} deg" for angle in np.linspace(45, 75, 30)]},
    }
    sent: list[float] = []

    def interrupt(_: int) -> None:
        if not sent:
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            sheave.tune(gx9, parts=parts, map=tuning.map, target="3200 rpm", points=5, best=0, progress=interrupt)
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - sent[0] < 5


def test_wrong_boxes_are_refused(gx9: sheave.Case, tmp_path: Path) -> None:
    wrong = {"helix": {"secondary.actuator.helix_angel": ["34 deg"]}}
    with pytest.raises(sheave.CaseError, match=r"did you mean `secondary\.actuator\.helix_angle`"):
        sheave.tune(gx9, parts=wrong, target="3400 rpm")
    with pytest.raises(sheave.CaseError, match=r"nowhere\.toml"):
        sheave.tune(gx9, parts=tmp_path / "nowhere.toml", target="3400 rpm")
    with pytest.raises(ValueError, match="target"):
        sheave.tune(gx9, parts=PARTS, target="-1 rpm")
    with pytest.raises(ValueError, match="number of points"):
        sheave.tune(gx9, parts=PARTS, target="3400 rpm", points=1)
    with pytest.raises(ValueError, match="jobs"):
        sheave.tune(gx9, parts=PARTS, target="3400 rpm", jobs=0)
    with pytest.raises(sheave.CaseError, match="actuators"):
        sheave.tune(parts={"a": {"b": {}}}, target="3400 rpm")
    with pytest.raises(sheave.CaseError, match=r"`a` sets `belt\.length`: expected keys of \[primary\.actuator\]"):
        sheave.tune(gx9, parts={"a": {"b": {"belt.length": "800 mm"}}}, target="3400 rpm")


def test_speeds_are_numbers(gx9: sheave.Case) -> None:
    for wrong in (True, np.True_, np.timedelta64(5), 3j):
        with pytest.raises(TypeError, match=r"`speed`: a value is a text with a unit"):
            sheave.drive(gx9, speed=wrong)
    with pytest.raises(ValueError, match=r"^start = -5: expected an angular speed that is positive and finite$"):
        sheave.shift(gx9, start=-5)


def test_parts_are_what_keys_and_values_are_otherwise(tuning: sheave.Tuning, gx9: sheave.Case) -> None:
    """Lists, tuples, arrays and quantities with arrays, shortened keys, sections as dictionaries."""
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    options: dict[str, Any] = {"target": "3200 rpm", "points": 3, "best": 0, "map": tuning.map}

    def masses(parts: dict[str, Any]) -> set[str]:
        found = sheave.tune(gx9, parts={"mass": parts}, **options)
        cases = [found.case(candidate) for candidate in range(found.candidates)]
        return {f"{case.given['primary.actuator.mass']:.4f}" for case in cases}

    wanted = {"0.1340", "0.1600"}
    boxes: list[dict[str, Any]] = [
        {"primary.actuator.mass": ("134 g", 0.160)},
        {"primary.actuator.mass": np.array([0.134, 0.160])},
        {"primary__actuator__mass": q(np.array([134.0, 160.0]), "g")},
        {"primary.actuator.mass": [q(134.0, "g"), np.float64(0.160)]},
        {"primary": {"actuator": {"mass": ["134 g", "160 g"]}}},
        {"primary.actuator": {"mass": ["134 g", "160 g"]}},
        {"a": {"primary": {"actuator.mass": "134 g"}}, "b": {"primary.actuator": {"mass": 0.160}}},
        {"a": {"primary.actuator.mass": "134 g"}, "b": {"primary.actuator.mass": 0.160, "pretension": None}},
    ]
    for box in boxes:
        assert masses(box) == wanted, box
    helix = {"helix": {"helix_angle": ["31 deg", "34 deg"]}, "pretension": {"a": {"pretension": "60 deg"}}}
    found = sheave.tune(gx9, parts=helix, **options)
    assert found.candidates == 2
    assert {one.parts["helix"] for one in found.tunes} <= {"31 deg", "34 deg"}
    assert found.case(0).given["secondary.actuator.helix_angle"] == pytest.approx(np.radians(31))
    # A name may have any character.
    odd = 'the "light"\\ one\x7f\n'
    found = sheave.tune(gx9, parts={odd: {odd: {"secondary.actuator.helix_angle": "31 deg"}}}, **options)
    assert found.candidates == 1


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ({"mass": {"primary.actuator.mass": [True]}}, ["`mass`", "`primary.actuator.mass` = True", "expected a mass"]),
        ({"mass": {"primary.actuator.mass": [None]}}, ["`primary.actuator.mass` = None", "expected a mass"]),
        ({"mass": {"primary.actuator.mass": [np.timedelta64(5)]}}, ["`primary.actuator.mass` = ", "expected a mass"]),
        (
            {"mass": {"primary.actuator.mass": range(3, 5)}},
            ["`primary.actuator.mass` = range(3, 5)", "expected a list of values, each a mass"],
        ),
        ({"mass": {"primary.actuator.mass": "134 g"}}, ["`primary.actuator.mass` = '134 g'", "expected a list"]),
        ({"mass": {"light": {"primary.actuator.mass": True}}}, ["`mass.light`", "= True", "expected a mass"]),
        ({"mass": {"light": {"primary.actuator.mass": {1: 2}}}}, ["`mass.light`", "= {1: 2}", "expected a mass"]),
        ({"mass": ["134 g"]}, ["`mass` = ['134 g']", "expected a dictionary of parts"]),
        ({"mass": None}, ["`mass` = None", "expected a dictionary of parts"]),
        ({"mass": {"light": 3}}, ["`mass`: `light` = 3", "expected a part"]),
        ({"mass": {"light": {"primary.actuator.mas": True}}}, ["did you mean `primary.actuator.mass`?"]),
        ({"mass": {3: ["134 g"]}}, ["3: expected names"]),
        ({3: {}}, ["3: expected names"]),
        ({"a": {"rate": [1.0]}}, ["`a`: `rate` is a key of several sections"]),
        (
            {"a": {"helix_angle": ["31 deg"], "secondary.actuator.helix_angle": ["32 deg"]}},
            ["`a`: ", "`helix_angle` and `secondary.actuator.helix_angle` are the same key"],
        ),
        (
            {"a": {"b": {"helix_angle": "31 deg", "secondary.actuator.helix_angle": "32 deg"}}},
            ["`a.b`: ", "`helix_angle` and `secondary.actuator.helix_angle` are the same key"],
        ),
    ],
)
def test_wrong_dictionaries_of_parts_are_refused(gx9: sheave.Case, parts: dict[Any, Any], said: list[str]) -> None:
    with pytest.raises(sheave.CaseError) as caught:
        sheave.tune(gx9, parts=parts, target="3200 rpm", accuracy=0.1, max_points=30, points=3, best=0)
    for words in said:
        assert words in str(caught.value), str(caught.value)


def test_parts_are_a_path_or_a_dictionary(gx9: sheave.Case) -> None:
    with pytest.raises(TypeError, match=r"parts: expected the path of a file of parts or a dictionary"):
        sheave.tune(gx9, parts=3, target="3200 rpm")  # type: ignore[arg-type]


def test_a_shift_curve_ends_at_a_higher_speed_than_it_begins(gx9: sheave.Case) -> None:
    for start, stop in (("3000 rpm", "1000 rpm"), ("2000 rpm", "2000 rpm")):
        with pytest.raises(ValueError, match=r"start is .* expected a higher speed to end at"):
            sheave.shift(gx9, start=start, stop=stop, points=3)


def test_a_drive_prescribes_no_output_of_its_belt(gx9: sheave.Case) -> None:
    swapped = gx9.swap("belt.bending_stiffness for efficiency.overall = 0.96")
    with pytest.raises(sheave.CaseError, match=r"`sheave\.drive` prescribes no output"):
        sheave.drive(swapped, speed="2000 rpm")
    with pytest.raises(sheave.CaseError, match=r"`sheave\.shift` prescribes no output"):
        sheave.shift(swapped)
