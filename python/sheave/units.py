"""Quantities of pint, which is optional, as the library reads them."""

from __future__ import annotations

from typing import Any

__all__ = ["text"]


def text(quantity: Any) -> str:
    """A quantity of pint as a text with base units, which the library checks against what the key takes.

    >>> import pint
    >>> text(pint.Quantity(3, "kN"))
    '3000.0 kg*m/s^2'
    """
    base = quantity.to_base_units()
    number = float(base.magnitude)
    unit = f"{base.units:~C}".replace("**", "^").replace("Δ", "")
    return f"{number!r} {unit}".strip()
