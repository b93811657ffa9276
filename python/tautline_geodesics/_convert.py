"""What the user gives, as numbers and arrays. Errors have the offending numbers."""

from __future__ import annotations

import math
import operator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._tautline import ProblemError


def array(x: Any, what: str, hint: str = "") -> NDArray[np.float64]:
    """An array of real numbers. An error about masked cells ends with the hint."""
    refuse_masked(x, what, hint)
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


def refuse_masked(x: Any, what: str, hint: str = "") -> None:
    """Refuses cells without a number, which NumPy would take with the number under the mask."""
    if _is_masked(x):
        raise ProblemError(
            f"{what} has masked cells: {_short(x)}; expected numbers, such as those of `filled`"
            f"{hint and f';{hint}'}"
        )


def _is_masked(x: Any) -> bool:
    if isinstance(x, np.ma.MaskedArray):
        return bool(np.ma.is_masked(x))
    if isinstance(x, np.ndarray) and x.dtype.kind == "O":
        x = x.ravel().tolist()
    return isinstance(x, (list, tuple)) and any(map(_is_masked, x))


def returned(x: Any, what: str) -> NDArray[np.float64]:
    """What the function of a black box returned: real numbers in double precision."""
    found = array(x, what)
    given = np.asarray(x)
    entries = given.ravel().tolist() if given.dtype.kind == "O" else []
    for dtype in (given.dtype, *(entry.dtype for entry in entries if isinstance(entry, np.generic))):
        if dtype.kind == "f" and dtype.itemsize < 8:
            raise ProblemError(
                f"{what} is of type {dtype.name}, which is too coarse for a search: compute it in double "
                "precision; in JAX, call jax.config.update('jax_enable_x64', True) first"
            )
    return found


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


def finite(x: Any, what: str) -> float:
    """A number that is neither infinite nor NaN."""
    found = number(x, what)
    if math.isinf(found):
        raise ProblemError(f"{what} is {found}; expected a finite number")
    return found


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
