"""Studies on more than one machine, by Dask.

A study is computed in parts (``Study.parts``) that depend on the grid alone. Each part is solved by one worker, with
the rows it would have in the whole, and stands in one Parquet file of a folder; a file appears when it is whole, under
the name of its part. So each row is there exactly once whatever happens: a part whose worker dies is solved again
elsewhere, one that two workers have solved is the same file twice, and a run that was ended goes on with the parts that
are missing.

The folder must be one that all workers and the caller reach under the same path. How workers are started is Dask's
affair: ``LocalCluster``, ``SSHCluster``, ``dask_kubernetes``, ``dask_jobqueue.SLURMCluster``.

    from distributed import Client
    import sheave.distributed

    study = sheave.Study("baja.toml", over={"drive.ratio": ratios, "slack_tension": tensions})
    with Client(n_workers=8, threads_per_worker=1) as client:
        dataset = sheave.distributed.run(study, "map", client=client)
    table = dataset.to_arrow()
"""

from __future__ import annotations

import functools
import json
import os
import pickle
import uuid
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

from ._api import Progress, progress_bar
from ._files import appearing
from ._sheave import Study
from .errors import StudyError

if TYPE_CHECKING:
    from os import PathLike

__all__ = ["Dataset", "run", "solve_part"]

_STUDY = "study.json"
_PART_POINTS = 256


@dataclass(frozen=True)
class Dataset:
    """The parts of a study in a folder."""

    folder: Path
    study: Study
    points: int
    """Points that a part has at least, the last excepted."""

    @property
    def parts(self) -> list[tuple[int, int]]:
        """All parts, as pairs of the first point and the one behind the last."""
        return self.study.parts(self.points)

    def path(self, part: tuple[int, int]) -> Path:
        """The file of a part."""
        return self.folder / f"part-{part[0]:08d}-{part[1]:08d}.parquet"

    @property
    def missing(self) -> list[tuple[int, int]]:
        """Parts that are not solved yet."""
        return [part for part in self.parts if not self.path(part).exists()]

    @property
    def complete(self) -> bool:
        """Whether all parts are there."""
        return not self.missing

    def to_arrow(self) -> Any:
        """The whole study as one table of pyarrow, rows in input order.

        Raises ``StudyError`` while parts are missing, or where a file does not have the rows of its part.
        """
        import pyarrow
        from pyarrow import parquet

        missing = self.missing
        if missing:
            raise StudyError(
                f"{len(missing)} of {len(self.parts)} parts are missing in {self.folder}",
                "run the study again with the same folder: it goes on with the parts that are missing",
            )
        tables = []
        for part in self.parts:
            table = parquet.read_table(self.path(part))
            if table.num_rows != part[1] - part[0]:
                raise StudyError(
                    f"{self.path(part)} has {table.num_rows} rows in place of {part[1] - part[0]}",
                    "remove the file and run the study again",
                )
            tables.append(table)
        return pyarrow.concat_tables(_alike(tables)).combine_chunks()

    def to_pandas(self) -> Any:
        """The whole study as a DataFrame of pandas."""
        return self.to_arrow().to_pandas()

    def write(self, path: Union[str, PathLike[str]]) -> Path:
        """Writes the whole study into one Parquet file, which appears whole: the same bytes whoever solved it."""
        from pyarrow import parquet

        target = Path(path)
        with appearing(target) as beside:
            parquet.write_table(self.to_arrow(), beside)
        return target


def _alike(tables: list[Any]) -> Iterator[Any]:
    """Tables of parts with the same columns: one that a part does not have, or has no value in, is empty there."""
    import pyarrow

    kinds: dict[str, Any] = {}
    for table in tables:
        for place, field in enumerate(table.schema):
            empty = table.column(place).null_count == table.num_rows
            if field.name not in kinds or (kinds[field.name] is None and not empty):
                kinds[field.name] = None if empty else field.type
            elif not empty and kinds[field.name] != field.type:
                # A count in one part and a number in another.
                kinds[field.name] = pyarrow.float64()
    texts = {"failure", "edition"}
    schema = pyarrow.schema(
        [(name, kind or (pyarrow.string() if name in texts else pyarrow.float64())) for name, kind in _in_order(kinds)]
    )
    for table in tables:
        columns = []
        for field in schema:
            place = table.schema.get_field_index(field.name)
            if place < 0 or table.column(place).null_count == table.num_rows:
                columns.append(pyarrow.nulls(table.num_rows, field.type))
            else:
                columns.append(table.column(place).cast(field.type))
        yield pyarrow.table(columns, schema=schema)


def _in_order(kinds: dict[str, Any]) -> list[tuple[str, Any]]:
    """``failure`` last, as in any table of a study."""
    return sorted(kinds.items(), key=lambda item: item[0] == "failure")


@functools.lru_cache(maxsize=2)
def _study(pickled: bytes) -> Study:
    """A study, which a worker makes once: all points of its grid are checked."""
    study: Study = pickle.loads(pickled)
    return study


def solve_part(study: bytes, part: tuple[int, int], path: str) -> str:
    """Solves a part of a pickled study on one thread and writes its file, which appears whole; gives the path.

    A file that is there already stays: its rows are those that would be written.
    """
    if not os.path.exists(path):
        _study(study).run(part[0], part[1], jobs=1).write(path)
    return path


def run(
    study: Study,
    folder: Union[str, PathLike[str]],
    *,
    client: Any = None,
    points: int = _PART_POINTS,
    attempts: int = 10,
    progress: Progress = None,
) -> Dataset:
    """Solves a study on the workers of a Dask cluster, and gives its dataset.

    ``folder`` is created if need be; of one that has parts of the same study, those that are missing are solved, and
    one of another study is refused. ``client`` is a ``distributed.Client``, or the one that is current. ``points`` is
    the least number of points of a part. A part whose worker dies is solved again elsewhere; one that Dask gives up,
    because it has taken several workers with it or because the cluster has lost its task, is handed out anew,
    ``attempts`` times in all.

    Raises ``StudyError`` where parts are still missing then, and what a part raises.
    """
    dataset = prepare(study, folder, points)
    for _ in range(max(attempts, 1)):
        missing = dataset.missing
        if not missing:
            break
        _solve(dataset, missing, client, progress)
    missing = dataset.missing
    if missing:
        raise StudyError(
            f"{len(missing)} of {len(dataset.parts)} parts were not solved in {attempts} attempts: their workers died",
            "look at the workers' memory and logs, then run the study again with the same folder",
        )
    return dataset


def _solve(dataset: Dataset, missing: list[tuple[int, int]], client: Any, progress: Progress) -> None:
    """Hands out parts once; those that the cluster loses stay missing."""
    from distributed import KilledWorker, as_completed, get_client
    from distributed.client import FutureCancelledError

    client = client or get_client()
    study = pickle.dumps(dataset.study)
    # The study goes with each task: data that is scattered dies with the workers that hold it.
    futures = {
        client.submit(solve_part, study, part, str(dataset.path(part)), pure=False, key=_key(part)): part
        for part in missing
    }
    solved = len(dataset.study) - sum(stop - start for start, stop in missing)
    try:
        with progress_bar(progress, len(dataset.study)) as tell:
            for future in as_completed(futures):
                try:
                    future.result()
                except (KilledWorker, FutureCancelledError):
                    continue
                start, stop = futures[future]
                solved += stop - start
                if tell is not None:
                    tell(solved)
    finally:
        client.cancel(list(futures))


def _key(part: tuple[int, int]) -> str:
    """A task's name, for Dask's pages; no two tasks have one name, so that one that was lost can be handed out anew."""
    return f"sheave-{part[0]}-{part[1]}-{uuid.uuid4().hex[:12]}"


def prepare(study: Study, folder: Union[str, PathLike[str]], points: int = _PART_POINTS) -> Dataset:
    """The dataset of a study in a folder, which is created or checked; nothing is solved.

    Raises ``StudyError`` for a folder that has another study, or the same in other parts.
    """
    place = Path(folder).absolute()
    place.mkdir(parents=True, exist_ok=True)
    said = {"study": study.fingerprint, "points": points, "rows": len(study)}
    text = json.dumps(said, indent=1)
    stated = place / _STUDY
    if stated.exists():
        if json.loads(stated.read_text(encoding="utf-8")) != said:
            raise StudyError(
                f"{place} has the parts of another study, or of this one divided otherwise",
                "choose another folder, or the same points for a part",
            )
    elif any(place.glob("part-*.parquet")):
        raise StudyError(f"{place} has parts and no {_STUDY}: nobody can say of which study", "choose another folder")
    else:
        with appearing(stated) as beside:
            beside.write_text(text, encoding="utf-8")
    return Dataset(place, study, points)
