"""One case: what goes in, what comes out, what is refused."""

import json
import os
import pickle
import signal
import threading
import time
from collections import UserDict
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest

import sheave


def test_a_case_is_a_path_a_text_a_dictionary_or_nothing(root: Path) -> None:
    text = '[operating_point]\nslack_tension = "120 N"\n'
    given = [
        sheave.solve(text, tolerance=1e-3),
        sheave.solve({"operating_point": {"slack_tension": "120 N"}}, tolerance=1e-3),
        sheave.solve({"operating_point.slack_tension": 120.0}, tolerance=1e-3),
        sheave.solve(slack_tension="0.12 kN", tolerance=1e-3),
        sheave.solve(operating_point__slack_tension=np.float64(120), tolerance=1e-3),
        sheave.solve(sheave.Case(slack_tension=120), tolerance=1e-3),
    ]
    forces = {result.primary.axial_force for result in given}
    assert len(forces) == 1
    assert given[0].primary.exit_tension == pytest.approx(120, rel=1e-6)
    path = root / "examples" / "baja.toml"
    assert sheave.solve(path, tolerance=1e-3).edition == sheave.solve(str(path), tolerance=1e-3).edition


def test_a_name_may_have_an_equals_sign(root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "ratio=1.2"
    folder.mkdir()
    for name in ("case.toml", "case"):
        (folder / name).write_text("[drive]\nratio = 1.2\n")
        assert sheave.Case(str(folder / name)).given == {"drive.ratio": 1.2}
        assert sheave.Case(f"ratio=1.2/{name}").given == {"drive.ratio": 1.2}
    with pytest.raises(sheave.CaseError, match="cannot read"):
        sheave.Case("ratio=1.3/case.toml")
    assert sheave.Case("drive.ratio = 1.2").given == {"drive.ratio": 1.2}


def test_any_mapping_is_a_dictionary() -> None:
    keys = {"drive": MappingProxyType({"ratio": 1.2}), "slack_tension": "120 N"}
    given = {"drive.ratio": 1.2, "operating_point.slack_tension": 120.0}
    assert sheave.Case(MappingProxyType(keys)).given == sheave.Case(UserDict(keys)).given == given
    assert sheave.Case().with_(UserDict(keys)).given == given
    with pytest.raises(TypeError, match="a key is a text"):
        sheave.Case({1: 2})  # type: ignore[dict-item]
    with pytest.raises(TypeError, match="dictionary of keys"):
        sheave.Case().with_([1])  # type: ignore[arg-type]


def test_keys_take_the_place_of_those_that_say_the_same_in_another_way(root: Path) -> None:
    path = root / "examples" / "baja.toml"
    result = sheave.solve(path, tolerance=1e-3, primary_axial_force="1050 N")
    assert result.primary.axial_force == pytest.approx(1050, rel=1e-3)
    assert set(result.found) == {"operating_point.slack_tension"}
    both = sheave.solve(drive={"primary_radius": "60 mm", "secondary_radius": "76.8 mm"}, tolerance=1e-3)
    assert both.primary.radius == pytest.approx(0.06)
    assert sheave.Case(drive={"primary_radius": 0.06}).with_(ratio=1.2).given == {"drive.ratio": 1.2}


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ({"drive.ratio": 1.2, "ratio": 1.3}, r"`drive\.ratio` and `ratio` are the same key, which is given twice"),
        ({"ratio": 1.2, "drive__ratio": 1.2}, r"`ratio` and `drive__ratio` are the same key"),
        ({"drive": {"ratio": 1.2}, "ratio": 1.3}, r"`drive\.ratio` and `ratio` are the same key"),
        ({"drive": {"ratio": 1.2}, "drive.ratio": 1.3}, r"`drive\.ratio` is given twice: expected it once"),
    ],
)
def test_a_key_is_given_once(keys: dict[str, Any], said: str) -> None:
    with pytest.raises(sheave.CaseError, match=said):
        sheave.solve(keys)
    with pytest.raises(sheave.CaseError, match=said):
        sheave.Case(**keys)
    with pytest.raises(sheave.CaseError, match=said):
        sheave.Case().with_(keys)


def test_a_key_of_a_call_takes_the_place_of_that_of_the_case() -> None:
    assert sheave.Case({"drive.ratio": 1.2}, ratio=1.3).given == {"drive.ratio": 1.3}
    assert sheave.Case({"drive.ratio": 1.2, "ratio": None}).given == {"drive.ratio": 1.2}
    assert sheave.Case().with_({"ratio": 1.2}, drive__ratio=1.3).given == {"drive.ratio": 1.3}


@pytest.mark.filterwarnings("error")
def test_what_only_passes_for_a_number_is_refused() -> None:
    """Truths, times and complex numbers, alone, in lists and in arrays."""
    others: list[Any] = [
        True,
        np.True_,
        np.array(True),
        np.timedelta64(5),
        np.timedelta64(5, "s"),
        np.datetime64(5, "s"),
        np.array(5, "m8"),
        np.complex128(3),
        3j,
    ]
    for other in others:
        with pytest.raises(TypeError, match=r"`slack_tension`: a value is a text with a unit"):
            sheave.Case(slack_tension=other)
        with pytest.raises(TypeError, match=r"`radii`: a value is a text with a unit"):
            sheave.Case(radii=[0.038, other])
        with pytest.raises(TypeError, match=r"a value is a text with a unit"):
            sheave.Study(over={"slack_tension": [100.0, other]})
    for array in (np.array([5, 6], "m8"), np.array([5, 6], "m8[s]"), np.array([True, False]), np.array([3j])):
        with pytest.raises(TypeError, match=r"a value is a text with a unit"):
            sheave.Case(radii=array)
        with pytest.raises(TypeError, match=r"a value is a text with a unit"):
            sheave.Study(over={"slack_tension": array})
    numbers: list[Any] = [5, 5.0, np.float32(5), np.int8(5), np.array(5.0), Fraction(5), Decimal(5)]
    for number in numbers:
        assert sheave.Case(slack_tension=number).given == {"operating_point.slack_tension": 5.0}
    assert sheave.Case(radii=np.array([0.038, 0.04])).given == {"primary.actuator.radii": [0.038, 0.04]}


def test_a_truth_with_a_unit_is_refused() -> None:
    pint = pytest.importorskip("pint")
    with pytest.raises(TypeError, match=r"`slack_tension`: a value is"):
        sheave.Case(slack_tension=pint.UnitRegistry().Quantity(np.True_, "N"))


def test_quantities_of_pint_are_read_whatever_the_registrys_system() -> None:
    pint = pytest.importorskip("pint")
    for system in ("US", "imperial", "cgs"):
        quantity = pint.UnitRegistry(system=system).Quantity(120, "N")
        result = sheave.solve(slack_tension=quantity, tolerance=1e-3)
        assert result.primary.exit_tension == pytest.approx(120.0, rel=1e-6)


def test_quantities_of_pint_are_checked_by_their_dimension() -> None:
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    keys = {"slack_tension": q(120, "N"), "primary_speed": q(3400, "rpm"), "half_angle": q(12, "deg")}
    result = sheave.solve(keys, tolerance=1e-3)
    assert result.primary.speed == pytest.approx(3400 * np.pi / 30, rel=1e-12)
    same = sheave.solve(slack_tension="120 N", tolerance=1e-3)
    assert result.primary.axial_force == pytest.approx(same.primary.axial_force, rel=1e-9)
    assert sheave.Case(ambient=q(25, "degC")).given["thermal.ambient"] == pytest.approx(298.15)
    with pytest.raises(sheave.CaseError, match="slack_tension"):
        sheave.solve(slack_tension=q(120, "mm"))


def test_results_say_what_the_json_says(base: sheave.Result) -> None:
    object = json.loads(base.json)
    assert object == base.to_dict()
    assert object["command"] == "solve" and object["converged"] is True
    spans = ("tight_span", "slack_span")
    for name in ("primary", "secondary", *spans, "efficiency", "belt", "energy", "losses", "solver"):
        part = getattr(base, name).to_dict()
        for field, value in part.items():
            assert object[name].get(field) == value, f"{name}.{field}"
    pulley = base.primary.to_dict()
    assert set(pulley) == set(object["primary"])
    assert base.energy.power_in == pytest.approx(18 * 3400 * np.pi / 30)
    assert base.slip_reserve == 1 - base.friction_utilization
    assert base.inputs["drive"]["primary_radius"] == pytest.approx(0.068309)
    assert "axial" in str(base) and "sheave.Result" in repr(base)


def test_results_have_attributes_for_all_of_the_json(root: Path) -> None:
    def check(told: dict[str, object], result: object, path: str) -> None:
        for name, value in told.items():
            assert hasattr(result, name), f"{path}.{name}"
            part = getattr(result, name)
            if isinstance(value, dict) and not isinstance(part, dict):
                check(value, part, f"{path}.{name}")
            else:
                assert part == value, f"{path}.{name}"

    result = sheave.solve(root / "examples" / "heat.toml", tolerance=1e-3, sensitivities=True)
    told = result.to_dict()
    for envelope in ("schema", "command", "converged"):
        told.pop(envelope)
    check(told, result, "result")
    assert result.losses is not None and result.losses.to_dict()["harmonics"]["bending"] > 0
    assert result.uncertainty is not None and 0 < result.uncertainty["primary.axial_force"] < 1


def test_losses_are_told_at_any_tolerance(root: Path) -> None:
    """Also where the harmonics lead to no such accuracy: what is left out of them is left out of the heat as well."""
    path = root / "examples" / "heat.toml"
    usual, tight = (sheave.solve(path, tolerance=tolerance) for tolerance in (1e-8, 1e-10))
    assert usual.losses is not None and tight.losses is not None
    assert tight.losses.total == pytest.approx(usual.losses.total, rel=1e-6)
    assert tight.belt.temperature == pytest.approx(usual.belt.temperature, rel=1e-7)


def test_sensitivities_are_those_of_differences(base: sheave.Result) -> None:
    step = 1e-3
    forces = []
    for sign in (-1, 1):
        moved = sheave.solve(slack_tension=100 * (1 + sign * step), tolerance=1e-8)
        forces.append(moved.primary.axial_force)
    differences = (forces[1] - forces[0]) / (200 * step)
    assert base.sensitivity("primary.axial_force", "slack_tension") == pytest.approx(differences, rel=1e-3)
    rows = sheave.sensitivities(tolerance=1e-4)
    assert rows == base.sensitivities
    with pytest.raises(KeyError, match="no derivatives"):
        base.sensitivity("primary.axial_farce", "slack_tension")
    with pytest.raises(ValueError, match="sensitivities=True"):
        sheave.solve(tolerance=1e-3).sensitivity("primary.axial_force", "slack_tension")


def test_profiles_are_arrays_that_outlive_their_result() -> None:
    result = sheave.solve(tolerance=1e-3)
    region = result.profile(between=0).primary
    tension = region.T
    assert tension is not region["T"] and np.shares_memory(tension, region["T"])
    assert not tension.flags.owndata and not tension.flags.writeable
    with pytest.raises(ValueError):
        tension[0] = 0.0
    with pytest.raises(ValueError):
        tension.flags.writeable = True
    assert len(region) == region.position.size == tension.size
    entry, exit = result.primary.entry_tension, result.primary.exit_tension
    del result, region
    assert (tension[0], tension[-1]) == pytest.approx((entry, exit))


def test_profiles_name_their_columns(base: sheave.Result) -> None:
    profile = base.profile(between=2)
    region = profile.secondary
    assert "T" in region.columns and region.units["T"] == "N" and "tractive tension" in region.meanings["T"]
    assert set(region.to_dict()) == {"position", *region.columns}
    assert np.max(region.x) == pytest.approx(base.secondary.max_penetration, rel=1e-3)
    assert len(profile.tight_span) > 2 and "T" in dir(region)
    with pytest.raises(KeyError, match="no column `tensoin`"):
        region["tensoin"]
    with pytest.raises(AttributeError):
        region.tension_


def test_results_show_themselves_in_notebooks(base: sheave.Result) -> None:
    html = base._repr_html_()
    assert "<svg" in html and "does it slip?" in html
    assert base.svg("tension").startswith("<svg")
    assert base.report().lstrip().lower().startswith("<!doctype html")
    with pytest.raises(KeyError, match="trajectory"):
        base.svg("path")


def test_what_is_wrong_keeps_its_place_and_hint(tmp_path: Path) -> None:
    file = tmp_path / "my.toml"
    file.write_text('[drive]\nprimary_radius = 68\nratioo = 1\n[belt]\nlength = "3 kg"\n')
    with pytest.raises(sheave.CaseError) as caught:
        sheave.solve(file)
    error = caught.value
    assert isinstance(error, ValueError)
    place = error.places[0]
    assert (place.source, place.line, place.column, place.text) == (str(file), 2, 18, "68")
    assert error.hint and "mm" in error.hint
    assert [other.places[0].line for other in error.others] == [3, 5]
    assert "line 2, column 18" in str(error) and "hint:" in str(error)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.places, again.hint) == (str(error), error.places, error.hint)
    with pytest.raises(sheave.CaseError, match="unknown key `slack_tensoin`"):
        sheave.solve(slack_tensoin="120 N")
    with pytest.raises(sheave.CaseError, match="cannot read"):
        sheave.solve(tmp_path / "nowhere.toml")
    with pytest.raises(sheave.CaseError, match="not valid TOML"):
        sheave.solve("[drive\nratio = 1")


def test_what_has_no_solution_says_why() -> None:
    with pytest.raises(sheave.SolveError) as caught:
        sheave.solve(slack_tension="1 N", primary_torque="80 N*m", tolerance=1e-2)
    assert caught.value.hint and "sheave.limit" in caught.value.hint


def test_what_cannot_be_solved_is_proven_where_it_can_be() -> None:
    """As the command says it: not where the search ended, but what the drive would take."""
    with pytest.raises(sheave.SolveError, match=r"takes a slack tension of at least 20\.\d+ N, and 1\.00 N is given"):
        sheave.solve(slack_tension="1 N", primary_torque="80 N*m", tolerance=1e-2)
    with pytest.raises(sheave.SolveError, match="work limit") as caught:
        sheave.solve(work_limit=10)
    assert caught.value.hint and "`work_limit`" in caught.value.hint


def test_an_axial_force_may_belong_to_two_operating_points() -> None:
    keys = {"primary_axial_force": "110 N", "primary_torque": "3 N*m"}
    tight = sheave.solve(keys, tolerance=1e-4)
    loose = sheave.solve(keys, tolerance=1e-4, branch="loose")
    assert tight.primary.axial_force == pytest.approx(loose.primary.axial_force, rel=1e-3)
    assert tight.primary.exit_tension > 10 * loose.primary.exit_tension
    for one, other in ((tight, loose), (loose, tight)):
        assert one.other_solution is not None
        assert one.other_solution.slack_tension == pytest.approx(other.primary.exit_tension, rel=1e-2)
        assert one.other_solution.friction_utilization == pytest.approx(other.friction_utilization, rel=1e-2)
        assert one.to_dict()["other_solution"] == one.other_solution.to_dict()
    assert any('branch="loose"' in warning for warning in tight.warnings)
    # From the looser nearby the tighter is found, unless the looser is asked for.
    near = sheave.solve(keys, tolerance=1e-4, near=loose)
    assert near.primary.exit_tension == pytest.approx(tight.primary.exit_tension, rel=1e-2)
    near = sheave.solve(keys, tolerance=1e-4, near=tight, branch="loose")
    assert near.primary.exit_tension == pytest.approx(loose.primary.exit_tension, rel=1e-2)
    only = sheave.solve(primary_axial_force="1050 N", tolerance=1e-2, branch="loose")
    assert only.other_solution is None and any("Only one operating point" in warning for warning in only.warnings)
    with pytest.raises(ValueError, match='"tight" or "loose"'):
        sheave.solve(keys, branch="both")


@pytest.mark.parametrize(
    "arguments",
    [
        {"tolerance": 1.0},
        {"tolerance": float("nan")},
        {"order": 5},
        {"order": -4},
        {"work_limit": 0},
    ],
)
def test_options_are_checked(arguments: dict[str, float]) -> None:
    with pytest.raises(ValueError):
        sheave.solve(**arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [True, [1.0], object(), float("nan"), float("inf"), "", "120 Nm", b"120 N"])
def test_values_that_are_none_are_refused(value: object) -> None:
    with pytest.raises((TypeError, sheave.CaseError)):
        sheave.solve(slack_tension=value)


def test_a_result_nearby_is_a_start(base: sheave.Result) -> None:
    near = sheave.solve(slack_tension="101 N", near=base, tolerance=1e-4)
    cold = sheave.solve(slack_tension="101 N", tolerance=1e-4)
    assert near.primary.axial_force == pytest.approx(cold.primary.axial_force, rel=1e-4)
    assert near.solver.newton_iterations < cold.solver.newton_iterations
    # Of another model: from nothing.
    other = sheave.solve(edition="thesis", near=base, tolerance=1e-3)
    assert other.edition == "thesis"


def test_what_is_said_of_calls_speaks_of_them() -> None:
    calls: list[Callable[[], object]] = [lambda: sheave.Case().without("rtaio"), lambda: sheave.Case().swap("nonsense")]
    for call in calls:
        with pytest.raises(sheave.CaseError) as caught:
            call()
        assert [place.source for place in caught.value.places] == ["argument"] and "--" not in str(caught.value)
    with pytest.raises(sheave.CaseError) as caught:
        sheave.solve("[sweep]\nover = ['drive.ratio=1..1.2:3']\n")
    assert caught.value.hint and "`sheave.sweep(FILE)`" in caught.value.hint


def test_summaries_speak_of_keys() -> None:
    result = sheave.solve(slack_tension="60 N", primary_torque="80 N*m", tolerance=1e-3)
    for page in (result.summary, result._repr_html_()):
        assert 'slip_reserve="20%" solves for it' in page and "--reserve" not in page


def test_cases_are_plain_values() -> None:
    case = sheave.Case(slack_tension="120 N", edition="thesis", primary_speed="30000 rpm")
    assert case.given["edition"] == "thesis"
    copy = pickle.loads(pickle.dumps(case))
    assert copy.given == case.given
    assert set(case.without("edition").given) == {"operating_point.slack_tension", "operating_point.primary_speed"}
    swapped = case.swap("belt.bending_stiffness for efficiency.overall = 0.96")
    assert ".swap(" in repr(swapped) and ".swap(" in repr(pickle.loads(pickle.dumps(swapped)))
    assert case.resolve()["operating_point"]["slack_tension"] == 120
    table = {row["key"]: row for row in sheave.keys()}
    assert table["drive.center_distance"]["default"] == pytest.approx(0.214)


def test_what_cannot_be_pickled_says_what_can(base: sheave.Result) -> None:
    with pytest.raises(TypeError, match="to_dict"):
        pickle.dumps(base)
    assert pickle.loads(pickle.dumps(base.to_dict())) == base.to_dict()


def test_cases_are_equal_by_what_they_give(root: Path) -> None:
    case = sheave.Case(ratio=1.2, slack_tension="120 N")
    assert pickle.loads(pickle.dumps(case)) == case == sheave.Case(slack_tension=120.0, ratio=1.2)
    assert sheave.Case("[drive]\nratio = 1.2\n") == sheave.Case(ratio=1.2) != sheave.Case(ratio=1.3)
    # Lists, too, make the case again from which they are told.
    for name in ("drive/gx9.toml", "baja.toml"):
        whole = sheave.Case(root / "examples" / name)
        assert sheave.Case(whole.given) == whole


def test_lists_are_lists_tuples_arrays_or_texts() -> None:
    text = sheave.Case({"engine.speeds": "200, 300 rad/s", "engine.torques": "20, 21 N*m"})
    for of in (list, tuple, np.array):
        assert sheave.Case({"engine.speeds": of([200.0, 300.0]), "engine.torques": of([20.0, 21.0])}) == text
    with pytest.raises(sheave.CaseError, match="has no unit"):
        sheave.Case({"engine.speeds": "1800 rpm, 2000"})
    for truth in (True, np.True_):
        with pytest.raises(TypeError):
            sheave.Case(slack_tension=truth)
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    of_pint = {"engine.speeds": q(np.array([200.0, 300.0]), "rad/s"), "engine.torques": [q(20, "N*m"), 21.0]}
    assert sheave.Case(of_pint) == text
    with pytest.raises(sheave.CaseError, match="an array"):
        sheave.Case(slack_tension=q(np.array([1.0, 2.0]), "N"))


def test_tables_are_dictionaries_of_what_stands_over_what() -> None:
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    given = {"belt.bending_stiffness": {"temperature": [298.15, 333.15], "value": [0.4, 0.26]}}
    for table in (
        {"temperature": ["25 degC", "60 degC"], "value": ["0.4 N*m^2", "0.26 N*m^2"]},
        {"temperature": q(np.array([25.0, 60.0]), "degC"), "value": q([0.4, 0.26], "N*m^2")},
        {"temperature": np.array([298.15, 333.15]), "value": (0.4, 0.26)},
        given["belt.bending_stiffness"],
    ):
        case = sheave.Case(bending_stiffness=table)
        assert case.given == {
            key: {axis: pytest.approx(row) for axis, row in one.items()} for key, one in given.items()
        }
    with pytest.raises(sheave.CaseError, match="`temperatures` has no place in it"):
        sheave.Case(bending_stiffness={"temperatures": [298.15], "value": [0.4]})


def test_other_threads_run_meanwhile() -> None:
    """The lock is free while a solve computes: a counting thread goes on."""
    counted = 0
    stop = threading.Event()

    def count() -> None:
        nonlocal counted
        while not stop.is_set():
            counted += 1
            time.sleep(1e-4)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    sheave.solve(tolerance=1e-9)
    after = counted
    stop.set()
    thread.join()
    assert after - before > 3


def test_threads_solve_at_once() -> None:
    results: list[sheave.Result] = []
    threads = [threading.Thread(target=lambda: results.append(sheave.solve(tolerance=1e-4))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({result.primary.axial_force for result in results}) == 1 and len(results) == 4


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_ends_a_computation() -> None:
    """A sweep that would take minutes ends with the first signal, and the next call works."""
    # In the background of a shell the signal is ignored from the start.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            sheave.sweep(over={"drive.ratio": np.linspace(0.8, 1.5, 2000), "slack_tension": "100..300 N:20"})
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 60
    assert sheave.solve(tolerance=1e-2).primary.torque == pytest.approx(18)


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_ends_the_check_of_a_grid() -> None:
    """All points of a study are checked when it is made: a million take seconds."""
    over = {"ratio": np.linspace(0.7, 1.7, 1000), "slack_tension": np.linspace(60, 300, 1000)}
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.2, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            sheave.Study(over=over)
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 1.5
    assert len(sheave.Study(over={"ratio": [1.0, 1.1]})) == 2


class Enough(Exception):
    """Raised by a handler of signals."""


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_signals_are_handled_while_a_call_computes() -> None:
    """Handlers run during a call and may compute themselves; what they raise ends the call."""
    seen = 0

    def handle(*_: object) -> None:
        nonlocal seen
        seen += 1
        if seen == 3:
            raise Enough
        sheave.solve(tolerance=1e-1)

    before = signal.signal(signal.SIGALRM, handle)
    signal.setitimer(signal.ITIMER_REAL, 0.06, 0.06)
    try:
        # Handled behind the call, the signals of its whole time would be one.
        with pytest.raises(Enough):
            sheave.limit(tolerance=1e-9)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert seen == 3
    assert sheave.solve(tolerance=1e-2).primary.torque == pytest.approx(18)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_fork_computes_on_its_own() -> None:
    sheave.solve(tolerance=1e-2)
    child = os.fork()
    if child == 0:
        try:
            fine = abs(sheave.solve(tolerance=1e-2).primary.torque - 18) < 1e-6
            os._exit(0 if fine else 1)
        except BaseException:
            os._exit(2)
    _, status = os.waitpid(child, 0)
    assert os.waitstatus_to_exitcode(status) == 0
