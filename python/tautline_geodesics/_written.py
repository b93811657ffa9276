"""What the user gives as a metric, as the text of a formula."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from ._convert import array, plain, refuse_masked
from ._recorded import coordinates, written
from ._table import Table
from ._tautline import ProblemError
from ._trace import UFUNCS, Number, TraceError, no_branches, numeral

# The forms that take one function.
SCALARS = ("cost", "speed", "phi", "graph")


class Written(NamedTuple):
    """A text, the tables that it calls, and how many characters were put before what the user wrote."""

    text: str
    tables: dict[str, Table]
    skipped: int = 0


def of_matrix(what: Any, dimension: int) -> Written:
    """A metric by its matrix: a text, a function, or constant numbers."""
    if isinstance(what, str):
        return Written(what, {})
    h = _values(what, dimension) if callable(what) else _constants(what, "H")
    if h.shape != (dimension, dimension):
        hint = "; for f² I use Metric.cost, for a diagonal Metric.diag" if h.ndim < 2 else ""
        raise ProblemError(f"H has the shape {h.shape}, not {(dimension, dimension)}{hint}")
    lines, names, tables = written(h.ravel().tolist())
    rows = [", ".join(names[i : i + dimension]) for i in range(0, len(names), dimension)]
    return Written("\n".join([*lines, f"[{'; '.join(rows)}]"]), tables)


def of_form(form: str, f: Any, dimension: int) -> Written:
    """A metric by the functions of a form, such as a cost."""
    if isinstance(f, str):
        return Written(f"{form}({f})", {}, len(form) + 1)
    if isinstance(f, (list, tuple)) and any(isinstance(each, str) for each in f):
        return Written(f"{form}({', '.join(map(str, f))})", {}, len(form) + 1)
    values = _values(f, dimension) if callable(f) else _constants(f, form)
    # A row or a column of SymPy is a vector.
    is_vector = values.ndim <= 1 or values.ndim == 2 and 1 in values.shape
    if values.size != 1 if form in SCALARS else not is_vector:
        expected = "a number" if form in SCALARS else (dimension,) if form == "diag" else "(m,)"
        raise ProblemError(f"{form}: returned the shape {values.shape}, expected {expected}")
    lines, names, tables = written(values.ravel().tolist())
    return Written("\n".join([*lines, f"{form}({', '.join(names)})"]), tables)


def check_used(given: Mapping[str, Any], names: set[str], what: str = "parameter") -> None:
    """Refuses parameters, or tables, that a metric does not use."""
    if unused := [name for name in given if name not in names]:
        raise ProblemError(f"the {what} {unused[0]} is not used")


def words(text: str) -> set[str]:
    return set(re.findall(r"[^\W\d]\w*", text))


def sign(text: str) -> tuple[str, str] | None:
    """The name of a cost or a speed, and the text of the function itself as a metric."""
    found = re.search(r"(?:\A|[;\n])\s*(cost|speed)\s*\(", text)
    if found is None:
        return None
    start, end = found.span(1)
    # In brackets, since a definition may have any name.
    return found[1], f"{text[:start]}{text[end:]} I"


def _constants(what: Any, name: str) -> np.ndarray:
    """Numbers as an array of objects."""
    found = array(what, name)
    if not np.isfinite(found).all():
        raise ProblemError(f"{name} is {found.tolist()}; expected finite numbers")
    return found.astype(object)


def _values(function: Callable[[np.ndarray], Any], dimension: int) -> np.ndarray:
    """What a function returns for symbols."""
    x = coordinates(dimension)
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        signature = None
    if signature is not None:
        try:
            signature.bind(x)
        except TypeError:
            raise ProblemError(
                f"the function gets one array x of shape ({dimension},), and takes {signature}"
            ) from None
    try:
        with no_branches():
            found = function(x)
    except (TypeError, AttributeError) as error:
        # Of NumPy, which does not ask the symbols in an array.
        missing = re.search(r"'(float|int|Traced)' object has no attribute '(\w+)'", str(error))
        if missing is not None and missing[1] == "Traced":
            raise TraceError(
                f"a function needs arrays of numbers, and not of symbols: {error}. Write it with "
                f"{', '.join(sorted(UFUNCS))}, or give a black box to `Metric.black_box`"
            ) from None
        is_missing = missing is not None and isinstance(getattr(np, missing[2], None), np.ufunc)
        if is_missing or "ufunc" in str(error) and "dtype('O')" not in str(error):
            raise TraceError(
                f"a function of NumPy does not take an array of symbols: {error}. Call it for each entry, "
                f"as in np.hypot(1.0, x[0]); there are {', '.join(sorted(UFUNCS))}"
            ) from None
        if "dtype('O')" not in str(error):
            raise
        raise TraceError(
            "symbols were added into an array of floats, as by `a += x`: write `a = a + x`, or make the "
            f"array with dtype=object ({error})"
        ) from None
    refuse_masked(found, "what the function returned")
    if isinstance(found, (list, tuple)):
        try:
            found = np.asarray(found, object)
        except ValueError:
            raise ProblemError(f"the function returned rows of different lengths: {found}") from None
    values = np.asarray(found, object)
    entries = [plain(each) for each in values.ravel().tolist()]
    for each in entries:
        if isinstance(each, complex):
            raise TypeError(f"the function returned the complex number {each!r}; expected real ones")
    result = np.empty(len(entries), object)
    result[:] = [numeral(each) if isinstance(each, Number) else each for each in entries]
    return result.reshape(values.shape)
