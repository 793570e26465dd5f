"""Studies on several workers: every row once, whatever dies."""

import os
import signal
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import sheave

distributed = pytest.importorskip("distributed")
pytest.importorskip("pyarrow")

import sheave.distributed  # noqa: E402  (Dask is optional)


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Two workers, processes of their own, which are started anew when they die."""
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None, silence_logs=50
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def study(points: int) -> sheave.Study:
    """A grid whose last axis is one point long, so that every point is a chain: small parts, many of them."""
    return sheave.Study(over={"slack_tension": np.linspace(80, 300, points), "drive.ratio": [1.0]}, tolerance=1e-2)


def test_a_dataset_is_the_table_of_the_study(client: Any, tmp_path: Path) -> None:
    here = study(70)
    told: list[int] = []
    dataset = sheave.distributed.run(here, tmp_path / "study", client=client, points=1, progress=told.append)
    assert len(dataset.parts) == 5 and dataset.complete and told[-1] == 70
    assert dataset.to_arrow().equals(here.run().to_arrow())
    names = sorted(path.name for path in dataset.folder.iterdir())
    assert names == [*(f"part-{a:08d}-{b:08d}.parquet" for a, b in dataset.parts), "study.json"]


def test_a_study_goes_on_with_the_parts_that_are_missing(client: Any, tmp_path: Path) -> None:
    here = study(70)
    dataset = sheave.distributed.run(here, tmp_path, client=client, points=1)
    before = {part: dataset.path(part).stat().st_mtime_ns for part in dataset.parts}
    bytes_before = {part: dataset.path(part).read_bytes() for part in dataset.parts}
    lost = dataset.parts[2]
    dataset.path(lost).unlink()
    with pytest.raises(sheave.StudyError, match="1 of 5 parts are missing"):
        dataset.to_arrow()
    again = sheave.distributed.run(here, tmp_path, client=client, points=1)
    after = {part: again.path(part).stat().st_mtime_ns for part in again.parts}
    assert {part for part in after if after[part] != before[part]} == {lost}
    assert {part: again.path(part).read_bytes() for part in again.parts} == bytes_before


def test_a_folder_of_another_study_is_refused(client: Any, tmp_path: Path) -> None:
    sheave.distributed.prepare(study(70), tmp_path, points=1)
    with pytest.raises(sheave.StudyError, match="another study"):
        sheave.distributed.run(study(71), tmp_path, client=client, points=1)
    with pytest.raises(sheave.StudyError, match="another study"):
        sheave.distributed.run(study(70), tmp_path, client=client, points=2)
    (tmp_path / "study.json").unlink()
    (tmp_path / "part-00000000-00000016.parquet").write_bytes(b"")
    with pytest.raises(sheave.StudyError, match="nobody can say"):
        sheave.distributed.run(study(70), tmp_path, client=client, points=1)


def test_every_row_is_there_once_when_workers_are_killed(client: Any, tmp_path: Path) -> None:
    """Workers die in the middle of the study, without warning; the table has the same bytes as one undisturbed."""
    here = study(int(os.environ.get("SHEAVE_TEST_POINTS", "320")))
    killed: list[int] = []
    dataset = sheave.distributed.prepare(here, tmp_path / "killed", points=1)
    parts = len(dataset.parts)

    def kill() -> None:
        for share in (0.2, 0.5):
            while parts - len(dataset.missing) < share * parts:
                time.sleep(0.02)
            workers = client.run(os.getpid)
            victim = next(iter(workers.values()))
            os.kill(victim, signal.SIGKILL)
            killed.append(victim)

    killer = threading.Thread(target=kill)
    killer.start()
    dataset = sheave.distributed.run(here, tmp_path / "killed", client=client, points=1)
    killer.join()
    assert len(killed) == 2, "nobody was killed"
    table = dataset.to_arrow()
    assert table.num_rows == len(here)
    undisturbed = sheave.distributed.run(here, tmp_path / "undisturbed", client=client, points=1)
    assert dataset.write(tmp_path / "a.parquet").read_bytes() == undisturbed.write(tmp_path / "b.parquet").read_bytes()
    assert table.equals(here.run().to_arrow())
