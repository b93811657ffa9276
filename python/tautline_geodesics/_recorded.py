"""What was recorded, as definitions of a text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._trace import Number, TraceError, Traced, number

if TYPE_CHECKING:
    from ._table import Table


def coordinates(dimension: int) -> np.ndarray:
    x = np.empty(dimension, object)
    x[:] = [Traced(f"x{i + 1}") for i in range(dimension)]
    return x


def written(numbers: Sequence[Any]) -> tuple[list[str], list[str], dict[str, Table]]:
    """The steps that these numbers need, in the order in which they were computed, as definitions of a
    text; the names of the numbers, and the tables by their names."""
    for x in numbers:
        if not isinstance(x, (Traced, *Number)):
            raise TraceError(f"{x!r} in a metric, which is no number")
    needed = {id(x): x for x in numbers if isinstance(x, Traced)}
    left = list(needed.values())
    # Without recursion: formulas may be deep.
    while left:
        for argument in left.pop().arguments:
            if id(argument) not in needed:
                needed[id(argument)] = argument
                left.append(argument)
    names: dict[int, str] = {}
    lines: list[str] = []
    tables: list[Table] = []
    for x in sorted(needed.values(), key=lambda x: x.order):
        names[id(x)] = x.text.format(*(names[id(argument)] for argument in x.arguments))
        if x.table is not None:
            if not any(x.table is table for table in tables):
                tables.append(x.table)
            number_of = next(i for i, table in enumerate(tables) if table is x.table)
            names[id(x)] = f"table{number_of + 1}{names[id(x)]}"
        if x.arguments:
            lines.append(f"t{len(lines) + 1} = {names[id(x)]};")
            names[id(x)] = f"t{len(lines)}"
    named = {f"table{i + 1}": table for i, table in enumerate(tables)}
    results = [names[id(x)] if isinstance(x, Traced) else number(float(x)) for x in numbers]
    return lines, results, named
