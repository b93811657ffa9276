"""What the user gives, as numbers and arrays. Errors have the offending numbers."""

from __future__ import annotations

import math
import operator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._tautline import ProblemError


def array(x: Any, what: str) -> NDArray[np.float64]:
    """An array of real numbers."""
    try:
        found = np.asarray(x)
    except ValueError:
        raise ProblemError(f"{what} has rows of different lengths: {_short(x)}") from None
    entries = found.ravel().tolist() if found.dtype.kind == "O" else []
    if found.dtype.kind == "c" or any(isinstance(entry, complex) for entry in entries):
        raise TypeError(f"{what} is complex: {_short(x)}; expected real numbers")
    if found.dtype.kind not in "biufO" or any(entry is None for entry in entries):
        raise ProblemError(f"{what} is {_short(x)}; expected numbers")
    try:
        return np.ascontiguousarray(found, np.float64).reshape(found.shape)
    except (TypeError, ValueError):
        raise ProblemError(f"{what} is {_short(x)}; expected numbers") from None


def vector(x: Any, what: str) -> list[float]:
    """The coordinates of a point. A number is a point on the line."""
    found = array(x, what)
    if found.ndim > 1:
        raise ProblemError(
            f"{what} has the shape {found.shape}; expected (D,), one number for each coordinate"
        )
    return np.atleast_1d(found).tolist()  # type: ignore[no-any-return]


def rows(x: Any, what: str) -> NDArray[np.float64]:
    """Many points, one in each row."""
    found = array(x, what)
    if found.ndim != 2:
        raise ProblemError(f"{what} has the shape {found.shape}; expected (m, D), a point in each row")
    return found


def finite_rows(x: Any, what: str) -> NDArray[np.float64]:
    found = rows(x, what)
    wrong = np.flatnonzero(~np.isfinite(found).all(1))
    if wrong.size:
        row = int(wrong[0])
        raise ProblemError(f"row {row} of {what} is {found[row].tolist()}; coordinates are finite")
    return found


def number(x: Any, what: str) -> float:
    """A number that is not NaN."""
    found = array(x, what)
    if found.ndim:
        raise ProblemError(f"{what} has the shape {found.shape}; expected a number")
    if math.isnan(float(found)):
        raise ProblemError(f"{what} is {float(found)}; expected a number")
    return float(found)


def whole(x: Any, what: str) -> int:
    """A whole number of at least 1."""
    try:
        found = operator.index(x)
    except TypeError:
        found = 0
    # Larger numbers do not reach the library, which says what is the largest one for it.
    found = min(found, 2**63 - 1)
    if found < 1 or isinstance(x, (bool, np.bool_)):
        raise ProblemError(f"{what} is {_short(x)}; expected a whole number of at least 1")
    return found


def plain(x: Any) -> Any:
    """A scalar of NumPy as a number of Python; anything else as it is."""
    if isinstance(x, np.ndarray) and x.ndim == 0:
        x = x[()]
    if isinstance(x, np.floating):
        # `item` of a long double is a long double.
        return float(x)
    return x.item() if isinstance(x, np.generic) else x


def _short(x: Any) -> str:
    text = " ".join(repr(x).split())
    return text if len(text) <= 60 else f"{text[:57]}..."
