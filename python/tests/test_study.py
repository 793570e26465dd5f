"""Studies: grids, tables in other packages' types, parts."""

import json
import pickle
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest

import sheave

OVER = {"slack_tension": ["100 N", "0.15 kN", 200.0], "drive.ratio": np.array([0.9, 1.0])}


@pytest.fixture(scope="module")
def table() -> sheave.Table:
    return sheave.sweep(over=OVER, tolerance=1e-3)


def test_rows_stand_in_input_order(table: sheave.Table) -> None:
    assert len(table) == 6 and table.failures == 0
    assert table.axes == [(["operating_point.slack_tension"], 3), (["drive.ratio"], 2)]
    assert table.columns[:3] == ["operating_point.slack_tension", "drive.ratio", "converged"]
    assert table["operating_point.slack_tension"].tolist() == [100, 100, 150, 150, 200, 200]
    assert table["converged"] == [True] * 6 and table["failure"] == [None] * 6
    assert table["solver.newton_iterations"].dtype == float
    one = sheave.solve(slack_tension=150, ratio=0.9, tolerance=1e-3)
    assert table["primary.axial_force"][2] == pytest.approx(one.primary.axial_force, rel=1e-3)


def test_grids_are_said_in_several_ways(table: sheave.Table) -> None:
    texts = ["operating_point.slack_tension=100..200 N:3", "drive.ratio=0.9,1.0"]
    same = sheave.sweep(over=texts, tolerance=1e-3, jobs=1)
    assert same["primary.axial_force"].tolist() == table["primary.axial_force"].tolist()
    joined = sheave.sweep(over="drive.ratio=0.9,1&operating_point.slack_tension=100,200", tolerance=1e-2)
    assert joined.axes == [(["drive.ratio", "operating_point.slack_tension"], 2)]
    editions = sheave.sweep(over={"edition": ["thesis", "consistent"]}, tolerance=1e-2)
    assert editions["edition"] == ["thesis", "consistent"]


def test_each_value_has_its_own_unit() -> None:
    """Numbers are in SI units, whatever units others have."""
    pint = pytest.importorskip("pint")
    q = pint.UnitRegistry().Quantity
    newtons = [100.0, 150.0, 200.0]
    for values in (
        [100.0, "150 N", "0.2 kN"],
        [q(0.1, "kN"), 150, "200 N"],
        q(np.array([0.1, 0.15, 0.2]), "kN"),
        (np.float32(100), np.int64(150), 200),
        pytest.importorskip("pandas").Series(newtons),
        pytest.importorskip("polars").Series(newtons),
        (value for value in newtons),
    ):
        study = sheave.Study(over=MappingProxyType({"slack_tension": values}), tolerance=1e-2)
        assert study.run()["operating_point.slack_tension"].tolist() == pytest.approx(newtons)
    for wrong in (1.0, q(1, "kN"), [True, False], np.array([True]), {"a": 1}):
        with pytest.raises(TypeError):
            sheave.Study(over={"slack_tension": wrong})


def test_a_study_file_says_what_varies(root: Path) -> None:
    path = root / "examples" / "slack_tension.toml"
    study = sheave.Study(path)
    assert len(study) > 2 and study.axes[0][0] == ["operating_point.slack_tension"]
    again = sheave.Study(path, over={"slack_tension": [100.0, 200.0], "drive.ratio": [1.0, 1.1, 1.2]})
    assert dict((tuple(keys), points) for keys, points in again.axes) == {
        **{tuple(keys): points for keys, points in study.axes},
        ("operating_point.slack_tension",): 2,
        ("drive.ratio",): 3,
    }
    text = "[sweep]\nover = ['drive.ratio = 0.9..1.1:2']\n"
    assert sheave.sweep(text, tolerance=1e-2)["drive.ratio"].tolist() == [0.9, 1.1]
    with pytest.raises(sheave.StudyError, match="nothing is varied"):
        sheave.sweep(slack_tension="120 N")


def test_arrays_are_views(table: sheave.Table) -> None:
    column = table["efficiency.overall"]
    assert np.shares_memory(column, table["efficiency.overall"]) and not column.flags.writeable


def test_tables_go_through_arrow(table: sheave.Table) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    arrow = table.to_arrow()
    assert arrow.num_rows == 6 and arrow.column_names == table.columns
    numbers = arrow["efficiency.overall"].chunk(0)
    assert numbers.buffers()[1].address == table["efficiency.overall"].ctypes.data, "a copy was made"
    assert pyarrow.schema(table).field("converged").type == pyarrow.bool_()
    assert arrow.schema.field("solver.newton_iterations").type == pyarrow.int64()
    frame = table.to_pandas()
    assert frame["efficiency.overall"].tolist() == table["efficiency.overall"].tolist()
    polars = table.to_polars()
    assert polars["efficiency.overall"].to_list() == table["efficiency.overall"].tolist()
    del table
    assert arrow["converged"].to_pylist() == [True] * 6


def test_tables_become_datasets_of_xarray(table: sheave.Table) -> None:
    pytest.importorskip("xarray")
    data = table.to_xarray()
    assert dict(data.sizes) == {"operating_point__slack_tension": 3, "drive__ratio": 2}
    assert data.efficiency__overall.attrs["column"] == "efficiency.overall"
    picked = data.primary__axial_force.sel(operating_point__slack_tension=150, drive__ratio=0.9)
    assert float(picked) == table["primary.axial_force"][2]
    joined = sheave.sweep(over="drive.ratio=0.9,1&operating_point.slack_tension=100,200", tolerance=1e-2).to_xarray()
    assert joined.operating_point__slack_tension.dims == ("drive__ratio",)


def test_tables_can_be_pickled(table: sheave.Table) -> None:
    failing = sheave.sweep(over={"drive.center_distance": ["214 mm", "100 mm"]}, tolerance=1e-2)
    for one in (table, failing):
        copy = pickle.loads(pickle.dumps(one))
        assert copy.columns == one.columns and copy.axes == one.axes and copy.failures == one.failures
        for column in one.columns:
            np.testing.assert_array_equal(copy[column], one[column])


def test_limits_and_optima_over_a_grid() -> None:
    study = sheave.Study(over={"ratio": [0.9, 1.0], "primary_torque": [10.0, 18.0]}, tolerance=1e-3)
    limits, best = study.limits(), study.optima(jobs=1)
    assert limits.axes == best.axes == study.axes and limits.failures == best.failures == 0
    one = sheave.limit(ratio=1.0, primary_torque=18.0, tolerance=1e-3).smallest_clamp
    assert one is not None
    assert limits["smallest_clamp.slack_tension.value"][3] == pytest.approx(one.slack_tension.value, rel=1e-3)
    # What is varied is not sought.
    assert not any(column.startswith("largest_torque") for column in limits.columns)
    clamp = sheave.optimum(ratio=1.0, primary_torque=18.0, tolerance=1e-3).state.slack_tension
    assert best["state.slack_tension"][3] == pytest.approx(clamp, rel=1e-2)
    with pytest.raises(ValueError, match="least_speed_efficiency"):
        study.limits(least_speed_efficiency=1.0)


def test_points_without_a_solution_keep_their_rows() -> None:
    table = sheave.sweep(over={"drive.center_distance": ["214 mm", "100 mm"]}, tolerance=1e-2)
    assert table.failures == 1 and table["converged"] == [True, False]
    assert np.isnan(table["primary.axial_force"]).tolist() == [False, True]
    assert table["failure"][0] is None and table["failure"][1]
    pytest.importorskip("pyarrow")
    assert table.to_arrow()["primary.axial_force"].null_count == 1


def test_tables_are_written_whole(table: sheave.Table, tmp_path: Path) -> None:
    for name in ("table.csv", "table.json", "table.parquet"):
        table.write(tmp_path / name)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["table.csv", "table.json", "table.parquet"]
    rows = json.loads((tmp_path / "table.json").read_text())
    assert [row["drive.ratio"] for row in rows] == [0.9, 1.0] * 3
    parquet = pytest.importorskip("pyarrow.parquet")
    assert parquet.read_table(tmp_path / "table.parquet").to_pylist() == table.to_arrow().to_pylist()
    # Types too, also of texts where there are none: parts of a study are read together.
    assert parquet.read_table(tmp_path / "table.parquet").schema.field("failure").type == "string"
    with pytest.raises(ValueError, match=r"\.parquet"):
        table.write(tmp_path / "table.xlsx")
    with pytest.raises(FileNotFoundError, match="cannot write"):
        table.write(tmp_path / "nowhere" / "table.csv")


def test_files_appear_whole_whoever_writes_them(table: sheave.Table, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "table.parquet"
    table.write(path)

    def write(_: int) -> None:
        for _ in range(50):
            table.write(path)

    with ThreadPoolExecutor(3) as pool:
        writers = [pool.submit(write, k) for k in range(2)]
        while not all(writer.done() for writer in writers):
            assert parquet.read_metadata(path).num_rows == len(table)
        for writer in writers:
            writer.result()
    assert [path.name for path in tmp_path.iterdir()] == ["table.parquet"]


@pytest.mark.parametrize(
    "over",
    [
        {},
        {"drive.ratio": []},
        {"drive.ratioo": [1.0]},
        {"drive.ratio": ["1..2"]},
        {"drive.ratio": [1.0, -1.0]},
        {"slack_tension": ["1 kg"]},
        "drive.ratio",
        ["drive.ratio=1..2:3", "drive.ratio=1,2"],
        {"drive.ratio": "1..2:99999999"},
    ],
)
def test_grids_that_are_wrong_are_refused(over: object) -> None:
    with pytest.raises(ValueError):
        sheave.sweep(over=over)
    with pytest.raises(TypeError):
        sheave.sweep(over=3)


def test_progress_is_told_and_what_it_raises_ends_the_study() -> None:
    told: list[int] = []
    sheave.sweep(over={"drive.ratio": np.linspace(0.9, 1.1, 4)}, tolerance=1e-2, progress=told.append)
    assert told == sorted(told) and told[-1] == 4
    pytest.importorskip("tqdm")
    sheave.sweep(over={"drive.ratio": [1.0]}, tolerance=1e-2, progress=True)

    def refuse(solved: int) -> None:
        raise RuntimeError(f"no more after {solved}")

    with pytest.raises(RuntimeError, match="no more after"):
        sheave.sweep(over={"drive.ratio": np.linspace(0.8, 1.5, 500)}, tolerance=1e-6, progress=refuse)


def test_a_study_is_solved_in_parts() -> None:
    study = sheave.Study(over={"slack_tension": np.linspace(100, 200, 17), "drive.ratio": [0.95, 1.05]}, tolerance=1e-2)
    assert study.parts() == [(0, 32), (32, 34)] and study.parts(33) == [(0, 34)] and len(study) == 34
    whole = study.run()
    last = study.run(32, 34)
    assert len(last) == 2
    assert last["primary.axial_force"].tolist() == whole["primary.axial_force"].tolist()[32:]
    copy = pickle.loads(pickle.dumps(study))
    assert copy.fingerprint == study.fingerprint
    assert copy.run(32, 34)["efficiency.overall"].tolist() == last["efficiency.overall"].tolist()
    with pytest.raises(ValueError, match="the study has 34"):
        study.run(3, 35)
    fast = sheave.Study(over={"primary_speed": ["29000 rpm", "30000 rpm"], "edition": ["thesis", "consistent"]})
    assert pickle.loads(pickle.dumps(fast)).fingerprint == fast.fingerprint
