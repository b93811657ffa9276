"""Shortest curves between two closed sets, under a metric that you write as one formula.

>>> import tautline
>>> valleys = tautline.Metric.cost("2 - cos(x1)", dimension=2)
>>> curve = tautline.solve(valleys, tautline.ball([0, 0], 0.5), tautline.half_space([1, 0], at_least=3))
>>> round(curve.extrapolated.value, 6)  # 5 - sin 3 + sin 1/2
5.338306

Lengths are in units of the metric, coordinates in units of their own. A metric is a text, a SymPy
matrix, or a Python function, which is called once with symbols; see `Metric`.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from ._metric import Metric
from ._plot import plot
from ._table import Table
from ._tautline import (
    Bounds,
    Certificate,
    Constant,
    Curve,
    Estimate,
    MetricError,
    NotCertified,
    ProblemError,
    Program,
    Set,
    Verdict,
    __version__,
    affine_subspace,
    ball,
    box,
    check,
    half_space,
    point,
    points,
    segment,
    sphere,
    theorem_1_1_excess,
    theorem_1_3_excess,
    union,
)
from ._trace import TraceError, Traced


class UnresolvedWarning(UserWarning):
    """A curve may not be a shortest one: its chords do not resolve the metric, or another minimum that
    was met is shorter."""


__all__ = [
    "Bounds",
    "Certificate",
    "Constant",
    "Curve",
    "Estimate",
    "Metric",
    "MetricError",
    "NotCertified",
    "ProblemError",
    "Program",
    "Set",
    "Table",
    "TraceError",
    "Traced",
    "UnresolvedWarning",
    "Verdict",
    "__version__",
    "affine_subspace",
    "ball",
    "box",
    "check",
    "distance_matrix",
    "half_space",
    "plot",
    "point",
    "points",
    "segment",
    "solve",
    "solve_batch",
    "sphere",
    "theorem_1_1_excess",
    "theorem_1_3_excess",
    "union",
]


def solve(
    metric: Metric,
    start: Set | Sequence[float],
    goal: Set | Sequence[float],
    *,
    n: int = 256,
    rule: str = "trapezoidal",
    starts: Sequence[Any] = (),
    only_these_starts: bool = False,
    steps: int | None = None,
    threads: int | None = None,
) -> Curve:
    """A shortest curve of `n` chords from `start` to `goal`: sets, or points of shape (D,).

    `rule` is "trapezoidal" (the metric in the middle of each chord), "left_endpoint" or
    "true_trapezoid". `starts` are polygons, arrays of shape (m, D), from which a search starts
    besides the automatic ones, or in place of them. `steps` is the largest number of Newton steps
    of a search on one grid. The result is a local minimiser: `Curve.certificate` says whether
    another curve may be shorter.

    Warns with `UnresolvedWarning` if the chords do not resolve the metric, or if a shorter local minimum
    was met. Raises `MetricError` if the metric is not finite, symmetric and positive definite along a curve,
    `ProblemError` if the input is wrong.
    """
    given = [np.asarray(polygon, float).tolist() for polygon in starts]
    options = _options(n, rule, steps, threads, given, only_these_starts)
    curve = metric.program.solve(start, goal, options)
    if doubts := curve.doubts:
        warnings.warn(
            f"the curve of length {float(curve.length)!r} may not be a shortest one: {'; '.join(doubts)}. "
            "More chords `n` or other `starts` may help",
            UnresolvedWarning,
            stacklevel=2,
        )
    return curve


def solve_batch(
    metric: Metric,
    starts: Any,
    goals: Any,
    *,
    n: int = 256,
    rule: str = "trapezoidal",
    steps: int | None = None,
) -> list[Curve]:
    """Curves between the rows of two arrays of shape (m, D), on all processors.

    They equal those of `solve` bit for bit. Raises `ProblemError` with the row of the first
    problem that has no curve.
    """
    curves, messages = metric.program.solve_batch(
        _rows(starts), _rows(goals), _options(n, rule, steps)
    )
    for row, message in enumerate(messages):
        if message is not None:
            raise ProblemError(f"row {row}: {message}")
    return [curve for curve in curves if curve is not None]


def distance_matrix(
    metric: Metric, a: Any, b: Any = None, *, n: int = 64, rule: str = "trapezoidal"
) -> np.ndarray:
    """The lengths of the curves between the rows of `a` and those of `b`, of shape (len(a), len(b)).

    Without `b` the rows of `a` are paired with each other: the matrix is symmetric, and each pair is
    solved once. NaN where there is no curve. Warns with `UnresolvedWarning` how many of the curves are
    not resolved, or longer than another local minimum that was met.
    """
    a, options = _rows(a), _options(n, rule)
    if b is None:
        i, j = np.triu_indices(len(a), 1)
        matrix = np.zeros((len(a), len(a)))
        matrix[i, j] = _lengths(metric, a[i], a[j], options)
        return matrix + matrix.T
    b = _rows(b)
    i, j = (index.ravel() for index in np.indices((len(a), len(b))))
    return _lengths(metric, a[i], b[j], options).reshape(len(a), len(b))


def _lengths(
    metric: Metric, starts: np.ndarray, goals: np.ndarray, options: dict[str, Any]
) -> np.ndarray:
    lengths, doubtful = metric.program.lengths(starts, goals, options)
    if doubtful:
        warnings.warn(
            f"{doubtful} of {len(lengths)} curves are not resolved by {options['n']} chords, or longer "
            "than another minimum that was met. More chords `n` may help; `solve` says which it is",
            UnresolvedWarning,
            stacklevel=3,
        )
    return lengths


def _options(
    n: int,
    rule: str,
    steps: int | None = None,
    threads: int | None = None,
    starts: Sequence[Any] = (),
    only_these_starts: bool = False,
) -> dict[str, Any]:
    return {
        "n": n,
        "rule": rule,
        "steps": steps,
        "threads": threads,
        "starts": starts,
        "only_these_starts": only_these_starts,
    }


def _rows(x: Any) -> np.ndarray:
    array = np.ascontiguousarray(x, float)
    if array.ndim != 2:
        raise ProblemError(f"an array of shape (m, D) is needed, not of shape {array.shape}")
    return array
