"""Files that appear whole."""

from __future__ import annotations

import os
import uuid
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@contextmanager
def appearing(target: Path) -> Iterator[Path]:
    """A place beside ``target`` to write to, which takes its name in the end; nothing is left of it if that fails.

    Processes of several machines, or containers, may have the same number: the place has a name of its own.
    """
    if not target.parent.is_dir():
        raise FileNotFoundError(2, "No such folder", str(target.parent))
    if target.is_dir():
        raise IsADirectoryError(21, "Is a folder", str(target))
    beside = target.with_name(f"{target.name}.{uuid.uuid4().hex}.part")
    try:
        yield beside
        os.replace(beside, target)
    finally:
        beside.unlink(missing_ok=True)
