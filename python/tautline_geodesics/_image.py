"""Cost images and sampled tensor fields as functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from ._convert import array
from ._table import Table
from ._tautline import ProblemError, Spline

# The first node, the corner at which the nodes end, and their spacing.
Lattice: TypeAlias = tuple[npt.ArrayLike, npt.ArrayLike, npt.ArrayLike]

# More nodes than this take more time than they are worth.
MOST_NODES = 2_000_000

# What to do about cells without a cost.
WALLS = " with walls=True cells that are masked, NaN or infinite are walls"

# The halves of a matrix may differ by this part of its largest entry: an inverse has such roundings.
ROUNDING = 1e-12


def of_image(
    cost: npt.ArrayLike,
    spacing: npt.ArrayLike,
    origin: npt.ArrayLike,
    spline: str,
    walls: bool,
) -> tuple[Callable[[Any], Any], Lattice, float | None]:
    """The cost as a function of a point, its nodes, and the least length of a curve through a wall."""
    if walls and spline == "smoothing":
        raise ProblemError('walls=True and spline="smoothing", which would spread the walls')
    values, is_wall = _and_walls(cost) if walls else (array(cost, "the cost", WALLS), None)
    wrong = ~((values > 0) & np.isfinite(values))
    if is_wall is not None:
        wrong &= ~is_wall
    if wrong.any():
        index = tuple(int(i) for i in np.argwhere(wrong)[0])
        hint = "" if values[index] <= 0 else f";{WALLS}"
        raise ProblemError(
            f"the cost at {index} is {values[index]}; it must be positive and finite{hint}"
        )
    start, step = _nodes(spacing, origin, values.ndim)
    crossing = None
    if is_wall is not None:
        # No curve through all other cells is longer, and four times as much for a unit of length lets none
        # through a corner where two walls touch: the integral of the cost there is more than 0.3 of it.
        crossing = values.size * float(values[~is_wall].max()) * float(np.linalg.norm(step))
        values = np.where(is_wall, 4.0 * crossing / float(step.min()), values)
    table = Table(values, spline=spline)
    if (least := table.spline.range()[0]) <= 0:
        raise ProblemError(
            f"the cubic spline is not proved positive: it undershoots the least cost {values.min()} by up to "
            f'{values.min() - least:.3g}, to {least:.3g}. Leave out spline="cubic", or take the logarithm: '
            'with t = Table(np.log(image), spline="cubic"), Metric.cost(lambda x: np.exp(t(*x)), …)'
        )
    return lambda x: table(*((x - start) / step)), _lattice(start, step, table.shape), crossing


def _and_walls(cost: npt.ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.bool_] | None]:
    """The costs, and which of them are walls, if some are."""
    given: Any = np.ma.asarray(cost)
    values = array(given.data, "the cost")
    is_wall = np.ma.getmaskarray(given) | np.isnan(values) | (values == np.inf)
    if is_wall.all():
        raise ProblemError("all cells of the cost are walls")
    return values, is_wall if is_wall.any() else None


def of_field(
    h: npt.ArrayLike, spacing: npt.ArrayLike, origin: npt.ArrayLike, spline: str
) -> tuple[Callable[[Any], Any], Lattice]:
    """The matrix as a function of a point, and its nodes."""
    values = array(h, "the field")
    axes = values.ndim - 2
    if axes < 1 or values.shape[-2:] != (axes, axes):
        raise ProblemError(
            f"the field has the shape {values.shape}; expected (n, 1, 1), (n, m, 2, 2) or "
            "(n, m, l, 3, 3), a matrix at each point"
        )
    values = _symmetric(values)
    # NaN is not symmetric either.
    wrong = ~np.all(values == np.swapaxes(values, -1, -2), axis=(-1, -2))
    if not wrong.any():
        wrong = ~(np.linalg.eigvalsh(values)[..., 0] > 0)
    if wrong.any():
        index = tuple(int(i) for i in np.argwhere(wrong)[0])
        raise ProblemError(
            f"the matrix at {index} is {values[index].tolist()}; it must be symmetric and positive "
            "definite"
        )
    upper = [(i, j) for i in range(axes) for j in range(i, axes)]
    if spline == "monotone":
        entries = np.stack([values[..., i, j] for i, j in upper], -1)
        tables = dict(zip(upper, map(Table._of, Spline.matrices(entries, axes))))
    else:
        tables = {(i, j): Table(values[..., i, j], spline=spline) for i, j in upper}
    start, step = _nodes(spacing, origin, axes)

    def matrix(x: Any) -> list[list[Any]]:
        u = (x - start) / step
        called = {entry: table(*u) for entry, table in tables.items()}
        return [[called[min(i, j), max(i, j)] for j in range(axes)] for i in range(axes)]

    return matrix, _lattice(start, step, values.shape[:axes])


def _symmetric(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The matrices with the mean of both halves, where these differ by roundings."""
    transposed = np.swapaxes(values, -1, -2)
    largest = np.abs(values).max(axis=(-1, -2), keepdims=True, initial=0.0)
    is_rounding = np.abs(values - transposed) <= ROUNDING * largest
    return np.where(is_rounding & (values != transposed), 0.5 * values + 0.5 * transposed, values)


def _nodes(
    spacing: npt.ArrayLike, origin: npt.ArrayLike, axes: int
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The first node, and the step along each axis."""
    step, start = _along(spacing, axes, "the spacing"), _along(origin, axes, "the origin")
    if not np.all(step > 0):
        raise ProblemError(f"the spacing {step.tolist()}; it must be positive")
    return start, step


def _lattice(
    start: NDArray[np.float64], step: NDArray[np.float64], shape: tuple[int, ...]
) -> Lattice:
    counts = np.array(shape)
    last = start + step * (counts - 1)
    # Of a large array every second, third, … entry along each axis is a node.
    every = 1
    while np.prod((counts - 1) // every + 1.0) > MOST_NODES:
        every += 1
    return start.tolist(), last.tolist(), (every * step).tolist()


def _along(x: npt.ArrayLike, axes: int, what: str) -> NDArray[np.float64]:
    """A number for each axis."""
    found = array(x, what)
    if found.shape not in ((), (axes,)):
        raise ProblemError(
            f"{what} has the shape {found.shape}; expected a number, or one for each of {axes} axes"
        )
    return np.broadcast_to(found, (axes,))
