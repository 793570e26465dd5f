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
    # Those of the registry's own system may be pounds and yards.
    _, units = quantity._REGISTRY.get_base_units(quantity.to_root_units().units, system="mks")
    base = quantity.to(units)
    number = float(base.magnitude)
    unit = f"{base.units:~C}".replace("**", "^").replace("Δ", "")
    return f"{number!r} {unit}".strip()
