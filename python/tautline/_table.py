"""Arrays as smooth functions, for metrics that were measured and not written."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from ._convert import array
from ._tautline import ProblemError, Spline
from ._trace import Traced


class Table:
    """An array of one to three axes as a function with continuous second derivatives, in grid units.

    `table(i, j)` is near `values[i, j]`, and defined for all real numbers: outside of the array it goes
    on with the values at the border. It is a cubic B-spline with the values as coefficients, which
    smooths them: it lies between neighbouring values, so a positive array is a positive function. With
    `interpolate` it has the values themselves, and may overshoot between them.

    It can be called with numbers, and with the coordinates of a traced function.

    >>> import numpy as np
    >>> height = Table([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]])
    >>> round(height(1, 1), 6), round(height(1, 0.5), 6), height(9, 1)
    (0.444444, 0.319444, 0.0)
    """

    __slots__ = ("spline",)

    def __init__(self, values: npt.ArrayLike, *, interpolate: bool = False) -> None:
        found = array(values, "the table")
        if found.ndim == 0:
            raise ProblemError("a table is an array of one to three axes, not a number")
        self.spline = Spline(found, interpolate)

    def __reduce__(self) -> tuple[type[Table], tuple[NDArray[np.float64]]]:
        return Table, (self.spline.coefficients,)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the array."""
        return tuple(self.spline.shape)

    def __call__(self, *x: Any) -> Any:
        axes = len(self.spline.shape)
        if len(x) != axes:
            raise ProblemError(f"a table on {axes} axes takes {axes} arguments, not {len(x)}")
        if any(isinstance(u, Traced) for u in x):
            return Traced.called(self, x)
        arrays = np.broadcast_arrays(*(array(u, "an argument of a table") for u in x))
        values = [self.spline.value(list(u), (0, 0, 0)) for u in zip(*(a.ravel() for a in arrays))]
        return values[0] if arrays[0].ndim == 0 else np.reshape(values, arrays[0].shape)

    def __repr__(self) -> str:
        return f"<tautline.Table of shape {self.shape}>"
