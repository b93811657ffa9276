"""Cost images as functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from ._convert import array
from ._table import Table
from ._tautline import ProblemError


def of_image(
    cost: npt.ArrayLike, spacing: npt.ArrayLike, origin: npt.ArrayLike, interpolate: bool
) -> tuple[Callable[[Any], Any], int]:
    """The cost as a function of a point, and the number of axes."""
    values = array(cost, "the cost")
    if not np.all(values > 0):
        index = tuple(int(i) for i in np.argwhere(~(values > 0))[0])
        raise ProblemError(f"the cost at {index} is {values[index]}; it must be positive")
    table = Table(values, interpolate=interpolate)
    if (least := table.spline.range((0, 0, 0))[0]) <= 0:
        raise ProblemError(
            f"the interpolated cost is not proved positive: it undershoots the least value "
            f"{values.min()} by up to {values.min() - least:.3g}, to {least:.3g}. Leave out "
            "`interpolate`, smooth the image, or interpolate its logarithm: with "
            "t = Table(np.log(image), interpolate=True), Metric.cost(lambda x: np.exp(t(*x)), …)"
        )
    axes = len(table.shape)
    step, start = _along(spacing, axes, "the spacing"), _along(origin, axes, "the origin")
    if not np.all(step > 0):
        raise ProblemError(f"the spacing {step.tolist()}; it must be positive")
    return lambda x: table(*((x - start) / step)), axes


def _along(x: npt.ArrayLike, axes: int, what: str) -> NDArray[np.float64]:
    """A number for each axis."""
    found = array(x, what)
    if found.shape not in ((), (axes,)):
        raise ProblemError(
            f"{what} has the shape {found.shape}; expected a number, or one for each of {axes} axes"
        )
    return np.broadcast_to(found, (axes,))
