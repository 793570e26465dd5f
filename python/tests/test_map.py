"""Belt maps, and the units made of them, run by FMPy."""

import hashlib
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sheave
import sheave.fmu


@pytest.fixture(scope="module")
def belt_map() -> sheave.BeltMap:
    over = {"ratio": "0.9..1.2", "torque": "6..18 N*m"}
    return sheave.map(over=over, accuracy=2e-2, slack_tension="150 N")


def test_a_map_says_what_a_solution_says(belt_map: sheave.BeltMap) -> None:
    assert belt_map.keys == ["drive.ratio", "operating_point.primary_torque"]
    assert belt_map.report["reached"] and belt_map.units["operating_point.primary_torque"] == "N*m"
    point = belt_map.at(1.07, 11.0)
    solved = sheave.solve(ratio=1.07, primary_torque=11.0, slack_tension="150 N", tolerance=1e-5)
    assert point["secondary.axial_force"] == pytest.approx(solved.secondary.axial_force, rel=2e-2)
    assert point["efficiency.overall"] == pytest.approx(solved.efficiency.overall, abs=1e-2)
    with_losses = solved.efficiency.overall_with_losses
    assert with_losses is not None and solved.efficiency.overall is not None
    assert point["efficiency.overall_with_losses"] == pytest.approx(with_losses, abs=1e-2)
    assert with_losses < solved.efficiency.overall - 1e-2
    with pytest.raises(ValueError, match=r"`slip_reserve`: expected one that it interpolates: .*`losses\.total`"):
        belt_map.interpolate("slip_reserve", np.array([[1.07, 11.0]]))
    assert belt_map.at(ratio=1.07, primary_torque=11.0) == point
    with pytest.raises(sheave.MapError, match=r"drive\.ratio"):
        belt_map.at(3.0, 11.0)
    with pytest.raises(ValueError, match="is not given"):
        belt_map.at(ratio=1.0)
    with pytest.raises(TypeError, match="not both"):
        belt_map.at(1.07, 11.0, ratio=1.0, primary_torque=11.0)


def test_maps_are_over_what_keys_are_otherwise() -> None:
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    ratios, newtons = [0.9, 1.0, 1.1], [1000.0, 1200.0, 1400.0]
    for over in (
        {"drive__ratio": ratios, "clamp": newtons},
        {"ratio": tuple(ratios), "secondary_axial_force": [q(1, "kN"), 1200.0, "1.4 kN"]},
        {"ratio": np.array(ratios), "operating_point__secondary_axial_force": q(np.array([1.0, 1.2, 1.4]), "kN")},
        ["ratio=0.9,1,1.1", "clamp=1000..1400 N"],
    ):
        made = sheave.map(over=over, accuracy=0.1, max_points=100)
        assert made.breakpoints["drive.ratio"].tolist() == pytest.approx(ratios)
        assert made.breakpoints["operating_point.secondary_axial_force"].tolist() == pytest.approx(newtons)
    # As the command solves its points: to a hundredth of the accuracy.
    assert made.report["tolerance"] == pytest.approx(1e-3)
    with pytest.raises(sheave.CaseError, match="kg"):
        sheave.map(over={"ratio": ratios, "clamp": [q(1, "kg"), q(2, "kg")]})
    with pytest.raises(TypeError, match="several values"):
        sheave.map(over={"ratio": ratios, "clamp": 1000.0})
    with pytest.raises(ValueError, match="ratioo"):
        sheave.map(over={"ratioo": ratios, "clamp": newtons})
    with pytest.raises(sheave.MapError) as caught:
        sheave.map(over=[])
    assert "--" not in str(caught.value)


def test_a_point_is_named_as_the_map_was(belt_map: sheave.BeltMap) -> None:
    point = belt_map.at(1.07, 11.0)
    assert belt_map.at(ratio=1.07, torque=11.0) == point
    assert belt_map.at(drive__ratio=1.07, operating_point__primary_torque=11) == point
    with pytest.raises(ValueError, match=r"`clamp` is no axis of the map: expected `drive\.ratio`, `operating_point"):
        belt_map.at(ratio=1.07, clamp=11.0)
    with pytest.raises(ValueError, match="`mass` is a key of several sections"):
        belt_map.at(ratio=1.07, mass=11.0)
    with pytest.raises(ValueError, match=r"`ratio` and `drive\.ratio` are the same key"):
        belt_map.at(**{"ratio": 1.0, "drive.ratio": 0.9, "torque": 11.0})
    wrong: list[Any] = [True, np.True_, np.timedelta64(11), "11 N*m", None]
    for one in wrong:
        with pytest.raises(TypeError, match=r"`torque` = .*: expected a number in SI units"):
            belt_map.at(ratio=1.07, torque=one)


def test_many_points_are_read_at_once_with_derivatives(belt_map: sheave.BeltMap) -> None:
    points = np.array([[1.0, 9.0], [1.1, 17.0], [2.0, 9.0]])
    values, slopes = belt_map.interpolate("primary.axial_force", points)
    assert np.isnan(values).tolist() == [False, False, True] and slopes.shape == (3, 2)
    same, _ = belt_map.interpolate("primary.axial_force", [[1.0, 9.0], [1.1, 17.0]])
    assert same.tolist() == values[:2].tolist()
    refused: list[Any] = [[1.0, 9.0], [[1.0, 9.0, 3.0]], [["a", "b"]]]
    for wrong in refused:
        with pytest.raises(ValueError):
            belt_map.interpolate("primary.axial_force", wrong)
    step = 1e-6
    for axis in range(2):
        moved = points[:2].copy()
        moved[:, axis] += step
        differences = (belt_map.interpolate("primary.axial_force", moved)[0] - values[:2]) / step
        assert differences == pytest.approx(slopes[:2, axis], rel=1e-4, abs=1e-3)


def test_a_map_is_read_as_it_was_written(belt_map: sheave.BeltMap, tmp_path: Path) -> None:
    belt_map.write(tmp_path / "map.csv")
    again = sheave.BeltMap.read(tmp_path / "map.csv")
    assert again.at(1.07, 11.0) == pytest.approx(belt_map.at(1.07, 11.0), rel=1e-12)
    with pytest.raises(sheave.MapError):
        sheave.BeltMap.read(tmp_path / "nowhere.csv")
    belt_map.write(tmp_path / "map.nc")
    data = pytest.importorskip("xarray").open_dataset(tmp_path / "map.nc", engine="scipy")
    assert any("axial_force" in str(name) for name in data.variables)
    data.close()
    with pytest.raises(ValueError, match=r"\.nc"):
        belt_map.write(tmp_path / "map.txt")


@pytest.fixture(scope="module")
def unit(belt_map: sheave.BeltMap, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return sheave.fmu.export(belt_map, tmp_path_factory.mktemp("fmu") / "drive.fmu")


def test_a_unit_is_valid_and_the_same_for_the_same_map(belt_map: sheave.BeltMap, unit: Path, tmp_path: Path) -> None:
    fmpy = pytest.importorskip("fmpy")
    again = sheave.fmu.export(belt_map, tmp_path / "again.fmu")
    assert hashlib.sha256(again.read_bytes()).digest() == hashlib.sha256(unit.read_bytes()).digest()
    with zipfile.ZipFile(unit) as archive:
        assert "modelDescription.xml" in archive.namelist()
    description = fmpy.read_model_description(str(unit), validate=True)
    assert description.fmiVersion == "2.0" and description.coSimulation is not None
    from fmpy.validation import validate_fmu

    assert validate_fmu(str(unit)) == []
    with pytest.raises(ValueError, match=r"\.fmu"):
        sheave.fmu.export(belt_map, tmp_path / "drive.zip")
    with pytest.raises(ValueError, match="name of C"):
        sheave.fmu.export(belt_map, tmp_path / "drive.fmu", name="my drive")


def test_a_simulator_gets_what_the_map_says(belt_map: sheave.BeltMap, unit: Path) -> None:
    """A ramp of torque at a shifting ratio, simulated by FMPy, beside the map itself."""
    fmpy = pytest.importorskip("fmpy")
    time = np.linspace(0, 1, 21)
    ratio, torque = 0.92 + 0.25 * time, 7 + 10 * time
    names = [f"inputs.{key}" for key in belt_map.keys]
    signals: Any = np.array(
        list(zip(time, ratio, torque, strict=True)), dtype=[("time", float), *((n, float) for n in names)]
    )
    outputs = [
        "primary.axial_force",
        "secondary.torque",
        "secondary.speed",
        "slip_reserve",
        "efficiency.overall",
        "efficiency.overall_with_losses",
        "valid",
    ]
    result = fmpy.simulate_fmu(str(unit), stop_time=1.0, output_interval=0.05, input=signals, output=[*names, *outputs])
    assert len(result) == 21 and np.all(result["valid"])
    for row in result:
        wanted = belt_map.at(row[names[0]], row[names[1]])
        for name in outputs[:-1]:
            assert row[name] == pytest.approx(wanted[name], rel=1e-9), name


def test_outside_the_map_a_unit_says_so(belt_map: sheave.BeltMap, unit: Path) -> None:
    fmpy = pytest.importorskip("fmpy")
    from fmpy.fmi2 import FMU2Slave

    description = fmpy.read_model_description(str(unit))
    reference = {variable.name: variable.valueReference for variable in description.modelVariables}
    folder = fmpy.extract(str(unit))
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="a",
    )
    slave.instantiate()
    slave.setupExperiment(startTime=0.0)
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    inputs = [reference[f"inputs.{key}"] for key in belt_map.keys]
    force, valid = reference["primary.axial_force"], reference["valid"]
    slave.setReal(inputs, [1.1, 12.0])
    slave.doStep(0.0, 0.1)
    assert slave.getBoolean([valid]) == [True]
    inside = slave.getReal([force])[0]
    _, slopes = belt_map.interpolate("primary.axial_force", np.array([[1.1, 12.0]]))
    derivative = slave.getDirectionalDerivative([force], inputs, [1.0, 0.0])
    assert derivative[0] == pytest.approx(slopes[0, 0], rel=1e-9)
    state = slave.getFMUState()
    slave.setReal(inputs, [5.0, 12.0])
    slave.doStep(0.1, 0.1)
    assert slave.getBoolean([valid]) == [False] and np.isnan(slave.getReal([force])[0])
    slave.setBoolean([reference["hold"]], [True])
    slave.doStep(0.2, 0.1)
    assert slave.getReal([force])[0] == pytest.approx(belt_map.at(1.2, 12.0)["primary.axial_force"], rel=1e-9)
    # What is held does not move with the input that left the map, and does with the other.
    assert slave.getDirectionalDerivative([force], inputs, [1.0, 0.0]) == [0.0]
    _, slopes = belt_map.interpolate("primary.axial_force", np.array([[1.2, 12.0]]))
    assert slave.getDirectionalDerivative([force], inputs, [0.0, 1.0])[0] == pytest.approx(slopes[0, 1], rel=1e-9)
    slave.setFMUState(state)
    assert slave.getReal([force])[0] == inside
    slave.freeFMUState(state)
    slave.terminate()
    slave.freeInstance()
