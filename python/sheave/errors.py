"""Exceptions, which keep the place at fault and what to try."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Optional

__all__ = ["BenchError", "CaseError", "DesignError", "Error", "MapError", "Place", "SolveError", "StudyError"]


@dataclass(frozen=True)
class Place:
    """Where something stands in a case file, a description or an argument."""

    source: str
    """Name of the file; ``"argument"`` for what a call says by itself, ``"case"`` for a case file given as text."""
    line: int
    """Counted from 1."""
    column: int
    """Counted from 1."""
    text: str
    """What stands there."""
    label: str
    """What is wrong with it, in a word or two."""

    def __str__(self) -> str:
        if self.source == "argument":
            return f"{self.text} ({self.label})"
        return f"{self.source}, line {self.line}, column {self.column}: {self.text} ({self.label})"


class Error(Exception):
    """What goes wrong in sheave.

    ``message`` says what is wrong, ``hint`` what to try (None where there is no more to say), ``places`` where it
    stands, the place at fault first.
    """

    def __init__(
        self,
        message: str,
        hint: Optional[str] = None,
        places: Sequence[Any] = (),
        others: Sequence[Any] = (),
    ) -> None:
        # All of them are arguments of the exception, so that it can be pickled.
        super().__init__(message, hint, places, others)
        self.message = message
        self.hint = hint
        self.places = tuple(place if isinstance(place, Place) else Place(*place) for place in places)
        self.others = tuple(type(self)(*other) for other in others)
        """What else is wrong with the same text, as exceptions of the same type."""

    def __str__(self) -> str:
        lines = [self.message]
        lines += [f"  in {place}" for place in self.places if place.source != "argument"]
        if self.hint:
            lines.append(f"  hint: {self.hint}")
        lines += [str(other) for other in self.others]
        return "\n".join(lines)


class CaseError(Error, ValueError):
    """A case is wrong: a key, a value, or what does not go together. Nothing was computed."""


class SolveError(Error, RuntimeError):
    """There is no solution, or none was found."""


class DesignError(Error, RuntimeError):
    """There is no limit or optimum, or none was found."""


class MapError(Error, ValueError):
    """A map cannot be made or read, or has no value at a point."""


class StudyError(Error, ValueError):
    """A study cannot be begun: its grid is wrong."""


class BenchError(Error, ValueError):
    """Measurements or a description cannot be used."""
