"""Tables of studies as other packages have them. Each package is imported when it is asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._sheave import Table

__all__ = ["to_arrow", "to_pandas", "to_polars", "to_xarray"]


def to_arrow(table: Table) -> Any:
    """As ``pyarrow.Table``, without a copy."""
    import pyarrow

    return pyarrow.table(table)


def to_pandas(table: Table) -> Any:
    """As ``pandas.DataFrame``."""
    return to_arrow(table).to_pandas()


def to_polars(table: Table) -> Any:
    """As ``polars.DataFrame``, without a copy."""
    import polars

    return polars.DataFrame(table)


def to_xarray(table: Table) -> Any:
    """As ``xarray.Dataset``: a dimension for each axis, named by its first key, and every column over them.

    Dots of names become ``__``, so that ``dataset.efficiency__overall`` works; ``attrs["column"]`` has the name of the
    column. What a second key of an axis says stands along the axis as a further coordinate.
    """
    import xarray

    axes = table.axes
    shape = tuple(points for _, points in axes)
    if len(table) != int(np.prod(shape)):
        raise ValueError(f"the table has {len(table)} rows of a grid of {int(np.prod(shape))}: solve all of it first")

    def name(column: str) -> str:
        return column.replace(".", "__")

    dims = [name(keys[0]) for keys, _ in axes]
    coords: dict[str, Any] = {}
    for axis, (keys, _) in enumerate(axes):
        for key in keys:
            values = np.asarray(table[key]).reshape(shape)
            along = np.moveaxis(values, axis, 0).reshape(shape[axis], -1)[:, 0]
            coords[name(key)] = (dims[axis], along, {"column": key})
    data: dict[str, Any] = {}
    for column in table.columns:
        if name(column) in coords:
            continue
        values = np.asarray(table[column])
        data[name(column)] = (dims, values.reshape(shape), {"column": column})
    return xarray.Dataset(data, coords=coords)
