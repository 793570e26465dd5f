"""Figures by matplotlib, in the style of the library's own figures.

>>> import sheave, sheave.plot
>>> result = sheave.solve(tolerance=1e-3)
>>> axes = sheave.plot.draw(result, "tension")
>>> axes.get_ylabel()
'tractive tension $T$ (N)'
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._sheave import Result

__all__ = ["PALETTE", "STYLE", "draw", "figures", "style"]

PALETTE = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#3c3c3c")
"""Colours that people of any colour vision can distinguish (M. Okabe, K. Ito, "Color Universal Design", 2008)."""

_INK, _GUIDE, _GRID = "#222222", "#828282", "#e4e4e4"

STYLE: dict[str, Any] = {
    "figure.figsize": (6.4, 3.8),
    "figure.dpi": 110,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 200,
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 10,
    "mathtext.fontset": "dejavusans",
    "text.color": _INK,
    "axes.edgecolor": _INK,
    "axes.labelcolor": _INK,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.titleweight": "normal",
    "grid.color": _GRID,
    "grid.linewidth": 0.8,
    "xtick.color": _INK,
    "ytick.color": _INK,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "image.cmap": "viridis",
}
"""Settings of matplotlib: ``matplotlib.rcParams.update(STYLE)``; ``style()`` adds the palette."""


def _settings() -> dict[str, Any]:
    from cycler import cycler

    return {**STYLE, "axes.prop_cycle": cycler(color=PALETTE)}


@contextmanager
def _restored(before: dict[str, Any]) -> Iterator[None]:
    import matplotlib

    try:
        yield
    finally:
        matplotlib.rcParams.update(before)


def style() -> Any:
    """Sets the style for all figures from here on; as a context manager, for those within it."""
    import matplotlib

    settings = _settings()
    before = {key: matplotlib.rcParams[key] for key in settings}
    matplotlib.rcParams.update(settings)
    return _restored(before)


def figures(result: Result) -> list[str]:
    """Names of the figures that ``draw`` knows of a result."""
    return list(result.figures())


def draw(result: Result, name: str = "trajectory", axes: Any = None) -> Any:
    """Draws a figure of a result, by default the belt's path, and gives its axes.

    Raises ``KeyError`` for a name that is not among ``figures(result)``.
    """
    all_figures = result.figures()
    if name not in all_figures:
        raise KeyError(f"no figure {name!r}: there are {', '.join(all_figures)}")
    figure = all_figures[name]
    if axes is None:
        axes = _new_axes(figure["equal"])
    number = 0
    for series in figure["series"]:
        x = [float("nan") if value is None else value for value in series["x"]]
        y = [float("nan") if value is None else value for value in series["y"]]
        if series["look"] == "guide":
            axes.plot(x, y, color=_GUIDE, linewidth=0.9, linestyle=(0, (4, 3)), label=_math(series["label"]) or None)
            continue
        color = series["color"]
        if color is None:
            color, number = number, number + 1
        options = {"color": PALETTE[color % len(PALETTE)], "label": _math(series["label"]) or None}
        if series["look"] == "dots":
            axes.plot(x, y, linestyle="none", marker="o", **options)
        else:
            dashes = (0, (4, 2)) if series["look"] == "dashed" else "solid"
            axes.plot(x, y, linestyle=dashes, marker="o" if series["marked"] else None, **options)
    for mark in figure["marks"]:
        axes.annotate(_math(mark["text"]), mark["at"], ha="center", va="center", fontsize=9)
    _dress(axes, figure)
    return axes


def _new_axes(equal: bool) -> Any:
    import matplotlib
    from matplotlib import pyplot

    with matplotlib.rc_context(_settings()):
        _, axes = pyplot.subplots(figsize=(7.2, 3.6) if equal else None)
    return axes


def _dress(axes: Any, figure: dict[str, Any]) -> None:
    axes.set_title(figure["caption"])
    for axis, side in ((axes.xaxis, figure["x"]), (axes.yaxis, figure["y"])):
        axis.set_label_text(_math(side["label"]))
        scale, limits = (axes.set_xscale, axes.set_xlim) if axis is axes.xaxis else (axes.set_yscale, axes.set_ylim)
        if side["logarithmic"]:
            scale("log")
        if side["range"]:
            limits(*side["range"])
        if side["step"]:
            from matplotlib.ticker import MultipleLocator

            axis.set_major_locator(MultipleLocator(side["step"]))
    if figure["equal"]:
        axes.set_aspect("equal", adjustable="datalim")
    labels = sum(bool(series["label"]) for series in figure["series"])
    if labels and figure["equal"]:
        # Below: a picture in its true shape has no corner to spare.
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=labels)
    elif labels:
        axes.legend(loc="best")


_SYMBOL = re.compile(r"(?<![A-Za-z])([A-Za-zα-ωΑ-Ωϑ])_\{?([A-Za-z0-9]+)\}?|(?<=\s)([A-Zγθϑ])(?=\s\()")


def _math(label: str) -> str:
    """Symbols of a label in italics, with their indices."""

    def symbol(match: re.Match[str]) -> str:
        if match[1]:
            return f"${match[1]}_{{\\mathrm{{{match[2]}}}}}$"
        return f"${match[3]}$"

    return _SYMBOL.sub(symbol, label)
