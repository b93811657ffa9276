"""The sets between which curves run."""

from __future__ import annotations

from typing import TypeAlias, Union

import numpy.typing as npt

from . import _tautline
from ._convert import number, rows, vector
from ._tautline import Set

# A set, or the coordinates of a point.
SetLike: TypeAlias = Union[Set, npt.ArrayLike]


def as_set(x: SetLike, what: str) -> Set:
    """A set as it is, and the set of one point of its coordinates."""
    return x if isinstance(x, Set) else _tautline.point(vector(x, what))


def point(x: npt.ArrayLike) -> Set:
    """The set of one point, an array of shape (D,)."""
    return _tautline.point(vector(x, "a point"))


def points(x: npt.ArrayLike) -> Set:
    """Finitely many points, an array of shape (m, D)."""
    return _tautline.points(rows(x, "the array of points").tolist())


def ball(centre: npt.ArrayLike, radius: float) -> Set:
    """The ball |x - centre| <= radius."""
    return _tautline.ball(vector(centre, "the centre"), number(radius, "the radius"))


def sphere(centre: npt.ArrayLike, radius: float) -> Set:
    """The sphere |x - centre| = radius."""
    return _tautline.sphere(vector(centre, "the centre"), number(radius, "the radius"))


def box(lower: npt.ArrayLike, upper: npt.ArrayLike) -> Set:
    """The box lower <= x <= upper."""
    return _tautline.box(vector(lower, "the lower corner"), vector(upper, "the upper corner"))


def half_space(
    normal: npt.ArrayLike, *, at_most: float | None = None, at_least: float | None = None
) -> Set:
    """The half-space normal·x <= at_most, or normal·x >= at_least."""
    return _tautline.half_space(
        vector(normal, "the normal"),
        at_most=None if at_most is None else number(at_most, "at_most"),
        at_least=None if at_least is None else number(at_least, "at_least"),
    )


def segment(start: npt.ArrayLike, end: npt.ArrayLike) -> Set:
    """The segment between two points."""
    return _tautline.segment(vector(start, "the start"), vector(end, "the end"))


def affine_subspace(point: npt.ArrayLike, directions: npt.ArrayLike) -> Set:
    """The points point + t1 directions[0] + t2 directions[1] + … for all real t."""
    found = rows(directions, "the array of directions").tolist()
    return _tautline.affine_subspace(vector(point, "the point"), found)


def union(*sets: SetLike) -> Set:
    """The union of sets and points."""
    return _tautline.union(*(as_set(each, "a point of the union") for each in sets))
