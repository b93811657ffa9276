"""Curves of one problem and of many."""

from __future__ import annotations

import itertools
import warnings
from collections.abc import Sequence
from typing import Any, Literal, TypeAlias, Union, overload

import numpy as np
import numpy.typing as npt
from numpy.typing import NDArray

from ._convert import array, finite_rows, number, rows, vector, whole
from ._metric import Metric
from ._sets import SetLike, as_set
from ._tautline import Curve, LatticeError, MetricError, ProblemError, Set, SignError

# A polygon from which a search starts, or several.
Starts: TypeAlias = Union[Curve, npt.ArrayLike, Sequence[Any]]


# Why there is no curve among walls.
NO_WAY = (
    "every curve that was found crosses a wall: no way between the walls joins the start and the goal, an end "
    "is in a wall, or the chords do not resolve the walls; more chords, or a way as `starts`, may help"
)


class UnresolvedWarning(UserWarning):
    """A curve may not be a shortest one: its chords do not resolve the metric, its length misses the
    tolerance, or another minimum that was met is shorter."""


def solve(
    metric: Metric,
    start: SetLike,
    goal: SetLike,
    *,
    n: int | None = None,
    tolerance: float | None = None,
    rule: str = "trapezoidal",
    starts: Starts = (),
    only_these_starts: bool = False,
    scope: str = "automatic",
    classes: int = 1,
    steps: int | None = None,
    threads: int | None = None,
    period: npt.ArrayLike | None = None,
) -> Curve:
    """A shortest curve of `n` chords from `start` to `goal`: sets, or points of shape (D,).

    Where the rule does not see the metric, or another minimum is shorter, there are up to four times as many
    chords, then Simpson's rule; `curve.n` and `curve.rule` say which. The `scope` "local" keeps `n` and the
    rule. Without `n` there are 256 chords, or as many as are needed for a relative error of the length of at most
    `tolerance`, by extrapolation: see `Curve.is_within`. A search along a `lattice` needs `n`.

    `rule` is one of `RULES`, such as "trapezoidal" (the metric in the middle of each chord) or
    "left_endpoint". `starts` are polygons from which a search starts besides the automatic ones, or
    in place of them: an array of shape (m, D), a curve, or a list of such. `steps` is the largest
    number of Newton steps of a search on one grid. With the `scope` "automatic" a search in two or three
    dimensions also looks along a path through a coarse lattice around what the starts led to, if the metric
    is a formula; with "local" it uses the starts alone. `threads` is 1 or 2. If the metric has a
    `lattice`, as an image has, a second search starts from a shortest path along it, unless
    `only_these_starts`, and the shorter curve is returned. With `classes` above 1 the paths are the
    shortest ones of as many homotopy classes, ways around the peaks and holes of the metric, and
    `Curve.other_minima` has up to eight of the curves to which they lead. Sets that are far from its
    nodes are joined without it.

    `period` has the period of each coordinate, such as [0, 2π] where x2 is an angle, and 0 for a coordinate
    without one: the goal is then those of its translates that come near to the start by their coordinates, for
    the curve and for what is proved of it. The result is a local minimiser: `Curve.certificate` says whether another curve may be
    shorter.

    Warns with `UnresolvedWarning` if the chords do not resolve the metric, if the search did not end at a
    strict minimum, if a shorter local minimum was met, if a black box jumps, if the tolerance is missed, or if no path along the lattice joins the sets. Raises `MetricError`
    if the metric is not finite, symmetric and positive definite along a curve, `ProblemError` if the input
    is wrong.
    """
    if n is not None and tolerance is not None:
        raise ProblemError(f"n = {n} and tolerance = {tolerance}; expected one of them")
    chords = 256 if n is None else n
    options = _options(
        metric, chords, rule, steps, threads, _polygons(starts), only_these_starts, scope
    )
    searches_lattice = metric.lattice is not None and not only_these_starts
    if tolerance is not None and searches_lattice:
        raise ProblemError(
            "a tolerance besides a lattice, which the metric has: a search along a lattice has a number of "
            "chords. Give n, or set metric.lattice = None"
        )
    if tolerance is not None:
        options["tolerance"] = number(tolerance, "the tolerance")
    classes = whole(classes, "classes")
    if classes > 1 and not searches_lattice:
        raise ProblemError(
            f"classes = {classes} without a lattice: set metric.lattice to its first node, its last one, and the "
            "spacing"
        )
    if searches_lattice:
        options["lattice"], options["classes"] = _lattice(metric.lattice), classes
    ends = as_set(start, "the start"), as_set(goal, "the goal")
    if period is not None:
        ends = ends[0], _periodic(metric, *ends, vector(period, "the period"))
    beside = ""
    try:
        curve = metric.program.solve(*ends, options)
    except SignError as error:
        raise MetricError(str(error)) from None
    except MetricError as error:
        why = _in_obstacle(metric, start, goal)
        raise MetricError(f"{why}: {error}" if why else str(error)) from None
    except LatticeError as error:
        curve = metric.program.solve(*ends, {**options, "lattice": None})
        beside = str(error)
    if _crosses(metric, curve):
        raise MetricError(NO_WAY)
    doubts = [*([beside] if beside else []), *curve.doubts]
    if tolerance is not None and not curve.is_within(tolerance):
        doubts.append(f"the relative error of its length may exceed {tolerance} with {curve.n} chords")
    if doubts:
        warnings.warn(
            f"the curve of length {float(curve.length)!r} may not be a shortest one: {'; '.join(doubts)}",
            UnresolvedWarning,
            stacklevel=2,
        )
    return curve


def _periodic(metric: Metric, start: Set, goal: Set, period: list[float]) -> Set:
    """The translates of the goal that come near to the start."""
    if metric._free is not None:
        raise ProblemError(
            "a period besides obstacles, which have no translates: write a cost that is high in them, and has the "
            "period"
        )
    return metric.program.periodic(start, goal, period)


def _translates(
    metric: Metric,
    starts: NDArray[np.float64],
    goals: NDArray[np.float64],
    period: npt.ArrayLike | None,
) -> list[NDArray[np.float64]]:
    """The goals; with a period, those of their translates that come near to the starts."""
    if period is None:
        return [goals]
    periods = np.array(vector(period, "the period"))
    # Refuses a period that the metric does not have. Of many rows some hundred are enough.
    every = max(1, len(starts) // 100)
    for start, goal in zip(starts[::every], goals[::every]):
        _periodic(metric, as_set(start, "the start"), as_set(goal, "the goal"), periods.tolist())
    axes = np.flatnonzero(periods)
    steps: list[NDArray[np.float64]] = []
    if len(axes) <= 3:
        steps = [np.array(step, float) for step in itertools.product((0, -1, 1), repeat=len(axes))]
    else:
        steps = [np.zeros(len(axes)), *np.eye(len(axes)), *-np.eye(len(axes))]
    nearest = np.round((starts[:, axes] - goals[:, axes]) / periods[axes])
    translates = []
    for step in steps:
        moved = np.array(goals)
        moved[:, axes] += (nearest + step) * periods[axes]
        translates.append(moved)
    return translates


def _crosses(metric: Metric, curve: Curve) -> bool:
    """Whether a curve goes through a wall of an image."""
    return metric._crossing is not None and float(curve.length) >= metric._crossing


def _lattice(lattice: Any) -> tuple[list[float], list[float], list[float]]:
    """The nodes of a lattice, as lists."""
    if not isinstance(lattice, (list, tuple)) or len(lattice) != 3:
        raise ProblemError(
            f"the lattice is {lattice!r}; expected the first node, the last one, and the spacing"
        )
    lower, upper, spacing = lattice
    return (
        vector(lower, "the first node"),
        vector(upper, "the last node"),
        vector(spacing, "the spacing of the nodes"),
    )


def _in_obstacle(metric: Metric, *ends: SetLike) -> str:
    """Says that an end is in an obstacle, or that every search ran into one, if that is so."""
    if metric._free is None:
        return ""
    for end in ends:
        if not isinstance(end, Set):
            x = np.atleast_1d(np.asarray(end, float))
            if np.isfinite(metric._free(x)).all() and not np.isfinite(metric(x)).all():
                return f"the point {x.tolist()} is in an obstacle"
    return (
        "every search runs into an obstacle, or out of the domain of the metric: name a way round it as "
        "`starts`, or give the metric a `lattice`"
    )


@overload
def solve_batch(
    metric: Metric,
    starts: npt.ArrayLike,
    goals: npt.ArrayLike,
    *,
    n: int = ...,
    rule: str = ...,
    steps: int | None = ...,
    threads: int | None = ...,
    scope: str = ...,
    period: npt.ArrayLike | None = ...,
    on_error: Literal["raise"] = ...,
) -> list[Curve]: ...
@overload
def solve_batch(
    metric: Metric,
    starts: npt.ArrayLike,
    goals: npt.ArrayLike,
    *,
    n: int = ...,
    rule: str = ...,
    steps: int | None = ...,
    threads: int | None = ...,
    scope: str = ...,
    period: npt.ArrayLike | None = ...,
    on_error: Literal["return"],
) -> tuple[list[Curve | None], list[str | None]]: ...
def solve_batch(
    metric: Metric,
    starts: npt.ArrayLike,
    goals: npt.ArrayLike,
    *,
    n: int = 256,
    rule: str = "trapezoidal",
    steps: int | None = None,
    threads: int | None = None,
    scope: str = "automatic",
    period: npt.ArrayLike | None = None,
    on_error: Literal["raise", "return"] = "raise",
) -> list[Curve] | tuple[list[Curve | None], list[str | None]]:
    """Curves between the rows of two arrays of shape (m, D), on all processors or on `threads`.

    One of them may be a single point, of shape (D,). The curves equal those of `solve` with the same
    `scope` bit for bit. With the `scope` "local" the `lattice` of an image is left out, which takes less time.
    With a `period`, as of `solve`, each curve is the shortest one to a translate of its goal.
    Raises `ProblemError` with the row of the first problem that has no curve; with
    `on_error="return"` it returns a pair of lists in place of that, the curves and the messages, with
    None where there is no curve and no message.
    """
    if on_error not in ("raise", "return"):
        raise ProblemError(f"on_error is {on_error!r}; expected 'raise' or 'return'")
    options = _options(metric, n, rule, steps, threads, scope=scope)
    pairs = _pairs(starts, goals)
    curves, messages = _many(metric, *pairs, options, period)
    if on_error == "return":
        return curves, messages
    for row, message in enumerate(messages):
        if message is not None:
            raise ProblemError(f"row {row}: {message}")
    return [curve for curve in curves if curve is not None]


def distance_matrix(
    metric: Metric,
    a: npt.ArrayLike,
    b: npt.ArrayLike | None = None,
    *,
    n: int = 64,
    rule: str = "trapezoidal",
    threads: int | None = None,
    scope: str = "automatic",
    period: npt.ArrayLike | None = None,
) -> NDArray[np.float64]:
    """The lengths of the curves between the rows of `a` and those of `b`, of shape (len(a), len(b)).

    Without `b` the rows of `a` are paired with each other: the matrix is symmetric, and each pair is
    solved once, with the `scope` of `solve`: "local" takes less time. NaN where there is no curve.
    With a `period`, as of `solve`, the length is that to the nearest translate. Warns with
    `UnresolvedWarning` how many of the curves are not resolved, not at a strict minimum, or longer than
    another local minimum that was met.
    """
    options, x = _options(metric, n, rule, None, threads, scope=scope), finite_rows(a, "a")
    if b is None:
        i, j = np.triu_indices(len(x), 1)
        matrix = np.zeros((len(x), len(x)))
        matrix[i, j] = _lengths(metric, x[i], x[j], options, period)
        return matrix + matrix.T
    y = finite_rows(b, "b")
    i, j = (index.ravel() for index in np.indices((len(x), len(y))))
    return _lengths(metric, x[i], y[j], options, period).reshape(len(x), len(y))


def _lengths(
    metric: Metric,
    starts: NDArray[np.float64],
    goals: NDArray[np.float64],
    options: dict[str, Any],
    period: npt.ArrayLike | None,
) -> NDArray[np.float64]:
    curves, _ = _many(metric, starts, goals, options, period)
    lengths, doubtful = metric.program.lengths(curves, options["threads"])
    if doubtful:
        warnings.warn(
            f"{doubtful} of {len(curves)} curves are not resolved by {options['n']} chords, not at a strict "
            "minimum, or longer than another minimum that was met; `curve.doubts` of `solve` says which it is",
            UnresolvedWarning,
            stacklevel=3,
        )
    return lengths


def _many(
    metric: Metric,
    starts: NDArray[np.float64],
    goals: NDArray[np.float64],
    options: dict[str, Any],
    period: npt.ArrayLike | None,
) -> tuple[list[Curve | None], list[str | None]]:
    """The curves between rows, or why there are none."""
    if metric.lattice is not None and options["scope"] != "local":
        options = {**options, "lattice": _lattice(metric.lattice)}
    curves: list[Curve | None] = [None] * len(starts)
    messages: list[str | None] = [None] * len(starts)
    for k, translates in enumerate(_translates(metric, starts, goals, period)):
        for row, (curve, why) in enumerate(zip(*_of_rows(metric, starts, translates, options))):
            if curve is not None and _crosses(metric, curve):
                curve, why = None, NO_WAY
            known = curves[row]
            if curve is not None and (known is None or float(curve.length) < float(known.length)):
                curves[row], messages[row] = curve, None
            elif k == 0:
                messages[row] = why
    return curves, messages


def _of_rows(
    metric: Metric,
    starts: NDArray[np.float64],
    goals: NDArray[np.float64],
    options: dict[str, Any],
) -> tuple[list[Curve | None], list[str | None]]:
    curves, messages = metric.program.solve_batch(starts, goals, options)
    if options["lattice"] is None:
        return curves, messages
    # Ends that are far from the nodes are joined without the lattice.
    failed = [row for row, curve in enumerate(curves) if curve is None]
    again = metric.program.solve_batch(starts[failed], goals[failed], {**options, "lattice": None})
    for row, curve, why in zip(failed, *again):
        curves[row], messages[row] = curve, why
    return curves, messages


def _options(
    metric: Metric,
    n: int,
    rule: str,
    steps: int | None = None,
    threads: int | None = None,
    starts: Sequence[Any] = (),
    only_these_starts: bool = False,
    scope: str = "automatic",
) -> dict[str, Any]:
    if not isinstance(metric, Metric):
        raise ProblemError(
            f"the metric is {metric!r}; a Metric is needed, such as Metric(…, dimension=2)"
        )
    return {
        "n": whole(n, "n"),
        "tolerance": None,
        "rule": rule if isinstance(rule, str) else repr(rule),
        "steps": None if steps is None else whole(steps, "steps"),
        "threads": None if threads is None else whole(threads, "threads"),
        "starts": starts,
        "only_these_starts": only_these_starts,
        "scope": scope if isinstance(scope, str) else repr(scope),
        "lattice": None,
        "classes": 1,
    }


def _polygons(starts: Starts) -> list[list[list[float]]]:
    """The polygons of an array, of a curve, or of a list of them."""
    several: Sequence[Any]
    if isinstance(starts, Curve):
        several = [starts]
    elif isinstance(starts, (list, tuple)) and any(isinstance(each, Curve) for each in starts):
        several = starts
    elif isinstance(starts, (list, tuple)) and all(np.ndim(each) == 2 for each in starts):
        # They may have different numbers of points.
        several = starts
    else:
        found = array(starts, "starts")
        several = found if found.ndim == 3 else [found]  # type: ignore[assignment]
    polygons = (each.points if isinstance(each, Curve) else each for each in several)
    return [rows(polygon, f"start {i}").tolist() for i, polygon in enumerate(polygons)]


def _pairs(
    starts: npt.ArrayLike, goals: npt.ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The rows of two arrays, of which one may be a point for all rows of the other."""
    a, b = array(starts, "starts"), array(goals, "goals")
    if a.ndim == 1 and b.ndim == 2:
        a = np.broadcast_to(a, (len(b), len(a)))
    elif b.ndim == 1 and a.ndim == 2:
        b = np.broadcast_to(b, (len(a), len(b)))
    return np.ascontiguousarray(rows(a, "starts")), np.ascontiguousarray(rows(b, "goals"))
