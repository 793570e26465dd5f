"""Limits, the best clamp, and what is made of measurements."""

from pathlib import Path

import numpy as np
import pytest

import sheave


def test_limits_are_those_of_the_model() -> None:
    limits = sheave.limit(tolerance=1e-3)
    assert limits.largest_torque.value > 18
    assert limits.largest_torque.kind in {"fold", "collapse", "speed_efficiency"}
    smallest = limits.smallest_clamp
    assert smallest is not None and smallest.slack_tension.value < 100
    assert smallest.slack_tension.state.primary_torque == pytest.approx(18, rel=1e-6)
    # The clamp at its limit for 18 N·m carries just these.
    back = sheave.limit(slack_tension=smallest.slack_tension.value, tolerance=1e-3)
    assert back.largest_torque.value == pytest.approx(18, rel=1e-2)
    by_speed = sheave.limit(speed_ratio=0.98, tolerance=1e-3)
    assert by_speed.smallest_clamp is None
    with pytest.raises(ValueError, match="least_speed_efficiency"):
        sheave.limit(least_speed_efficiency=1.0)


def test_the_best_clamp_is_better_than_its_neighbours() -> None:
    best = sheave.optimum(tolerance=1e-5)
    assert best.bound == "inner"
    tension = best.state.slack_tension
    for factor in (0.8, 1.25):
        other = sheave.solve(slack_tension=factor * tension, tolerance=1e-5)
        assert other.efficiency.overall is not None
        assert other.efficiency.overall < best.state.overall_efficiency
    with pytest.raises(sheave.DesignError, match="primary_torque"):
        sheave.optimum(primary_torque="-5 N*m")


def test_limits_and_optima_say_how_warm_the_belt_is(root: Path) -> None:
    path = root / "examples" / "heat.toml"
    limits = sheave.limit(path, tolerance=1e-3)
    smallest = limits.smallest_clamp
    assert smallest is not None
    warm = smallest.slack_tension.belt_temperature
    assert warm is not None and limits.largest_torque.belt_temperature is not None
    assert 300 < warm < limits.largest_torque.belt_temperature < 600
    best = sheave.optimum(path, tolerance=1e-3, include="on")
    assert best.belt_temperature is not None and 300 < best.belt_temperature < 400
    assert best.efficiency_with_losses is not None
    assert best.efficiency_with_losses < best.state.overall_efficiency
    cold = sheave.optimum(tolerance=1e-3)
    assert cold.belt_temperature is None and cold.efficiency_with_losses is None


def test_a_belt_is_found_from_bench_tests(root: Path) -> None:
    belt = sheave.belt(root / "examples" / "belts" / "cvtech.toml")
    assert 0.5 < belt.length < 1.5 and belt.longitudinal_stiffness > 1e4
    case = belt.case(slack_tension="150 N")
    assert case.given["belt.length"] == pytest.approx(belt.length, rel=1e-3)
    assert belt.details["belt"]["longitudinal_stiffness"] == belt.longitudinal_stiffness
    with pytest.raises(sheave.BenchError, match="cannot read"):
        sheave.belt(root / "nowhere.toml")


@pytest.mark.parametrize("kelvins", [60, "60", 60.0, np.float64(60)])
def test_temperatures_that_no_belt_has_are_refused(root: Path, kelvins: object) -> None:
    said = r"^temperature = 60(\.0)?: a bare number is in kelvin, and 60 K is no belt's; did you mean `60 degC`\?$"
    with pytest.raises(ValueError, match=said):
        sheave.belt(root / "examples" / "belts" / "cvtech.toml", temperature=kelvins)


def test_what_is_no_temperature_is_refused(root: Path) -> None:
    path = root / "examples" / "belts" / "cvtech.toml"
    for wrong in (-5, float("nan"), float("inf"), "nan", "60 parsec", "-300 degC"):
        with pytest.raises(ValueError, match=f"^temperature = {wrong}: ") as caught:
            sheave.belt(path, temperature=wrong)
        assert not isinstance(caught.value, sheave.BenchError)
    warm = sheave.belt(path, temperature="60 degC")
    assert sheave.belt(path, temperature=333.15).bending_stiffness == warm.bending_stiffness


def test_logs_become_operating_points_and_are_compared(root: Path, tmp_path: Path) -> None:
    made = root / "examples" / "made"
    logs = sorted(path for path in made.iterdir() if path.name.split("_")[0] in {"P", "S", "ADC"})
    found = sheave.dyno(logs, calibration=made / "calibration.csv", engine=made / "engine.csv")
    assert len(found.records) == 8 and found.steady
    data = found.write(tmp_path / "points.csv")
    assert data.read_text() == found.csv and len(found.to_pandas()) == len(found.points)
    compared = sheave.compare(data=data, engine=made / "engine.csv", tolerance=1e-3)
    used = [point for point in compared.points if point["used"]]
    assert used and compared.scale > 0 and "scale" in compared.summary
    low, high = compared.scale_interval
    assert high is not None and low <= compared.scale <= high
    assert len(compared.to_pandas()) == len(compared.points)
    fits = [
        sheave.compare(data=data, engine=made / "engine.csv", tolerance=1e-2, fit=fit).fit
        for fit in ("sheave.friction_coefficient", ["sheave.friction_coefficient"], "friction_coefficient")
    ]
    assert fits[0] is not None and fits[0] == fits[1] == fits[2]
    assert [constant["key"] for constant in fits[0]["constants"]] == ["sheave.friction_coefficient"]
    with pytest.raises(sheave.BenchError, match="`nothing` cannot be fitted"):
        sheave.compare(data=data, engine=made / "engine.csv", fit="nothing")
    with pytest.raises(ValueError, match="torque_at"):
        sheave.dyno(logs, torque_at="nowhere")
    with pytest.raises(sheave.BenchError) as caught:
        sheave.dyno([path for path in logs if path.name.startswith(("P", "S"))], window=600.0)
    assert "(window)" in str(caught.value) and "--" not in str(caught.value)
    with pytest.raises(sheave.BenchError) as caught:
        sheave.compare(data=data, tolerance=1e-3)
    assert "--" not in str(caught.value)
    with pytest.raises(sheave.BenchError):
        sheave.dyno(root / "README.md")
    with pytest.raises(sheave.BenchError):
        sheave.compare(data=root / "README.md")
