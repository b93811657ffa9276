"""Arrays as smooth functions, for metrics that were measured and not written."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from ._convert import array
from ._tautline import ProblemError, Spline
from ._trace import Traced

# How a function goes between the values of an array.
KINDS = ("monotone", "cubic", "smoothing")


class Table:
    """An array of one to three axes as a function with continuous second derivatives, in grid units.

    `table(i, j)` is `values[i, j]`, and defined for all real numbers: outside of the array it goes on with
    the values at the border. Between the values it is a cubic spline of one of three kinds:

    - "monotone" stays between neighbouring values, so a positive array is a positive function, and a jump
      does not ring;
    - "cubic" is more accurate where the values are smooth, and overshoots where they jump;
    - "smoothing" replaces each value by a mean of those around it.

    It can be called with numbers, and with the coordinates of a traced function.

    >>> import numpy as np
    >>> height = Table([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]])
    >>> height(1, 1), height(1, 0.5), height(9, 1)
    (1.0, 0.5, 0.0)
    >>> smooth = Table([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]], spline="smoothing")
    >>> round(smooth(1, 1), 6), round(smooth(1, 0.5), 6)
    (0.444444, 0.319444)
    """

    __slots__ = ("spline",)

    def __init__(self, values: npt.ArrayLike, *, spline: str = "monotone") -> None:
        found = array(values, "the table")
        if found.ndim == 0:
            raise ProblemError("a table is an array of one to three axes, not a number")
        if spline not in KINDS:
            raise ProblemError(f"spline={spline!r}; expected one of {', '.join(KINDS)}")
        self.spline = Spline(found, spline)

    @classmethod
    def _of(cls, spline: Spline) -> Table:
        table = cls.__new__(cls)
        table.spline = spline
        return table

    def __reduce__(self) -> tuple[Callable[[Spline], Table], tuple[Spline]]:
        return Table._of, (self.spline,)

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
        values = [self.spline.value(list(u)) for u in zip(*(a.ravel() for a in arrays))]
        return values[0] if arrays[0].ndim == 0 else np.reshape(values, arrays[0].shape)

    def __repr__(self) -> str:
        return f"<tautline.Table of shape {self.shape}>"
