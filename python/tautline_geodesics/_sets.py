"""The sets between which curves run."""

from __future__ import annotations

import functools
import operator
from typing import TypeAlias, Union

import numpy.typing as npt

from ._convert import number, rows, vector
from ._tautline import Set

# A set, or the coordinates of a point.
SetLike: TypeAlias = Union[Set, npt.ArrayLike]


def as_set(x: SetLike, what: str) -> Set:
    """A set as it is, and the set of one point of its coordinates."""
    return x if isinstance(x, Set) else _point(x, what)


def _point(x: npt.ArrayLike, what: str) -> Set:
    return Set([("point", {"position": vector(x, what)})])


def point(x: npt.ArrayLike) -> Set:
    """The set of one point, an array of shape (D,)."""
    return _point(x, "a point")


def points(x: npt.ArrayLike) -> Set:
    """Finitely many points, an array of shape (m, D)."""
    return Set([("points", {"points": rows(x, "the array of points").tolist()})])


def ball(centre: npt.ArrayLike, radius: float) -> Set:
    """The ball |x - centre| <= radius."""
    return _round("ball", centre, radius)


def sphere(centre: npt.ArrayLike, radius: float) -> Set:
    """The sphere |x - centre| = radius."""
    return _round("sphere", centre, radius)


def _round(kind: str, centre: npt.ArrayLike, radius: float) -> Set:
    return Set(
        [(kind, {"centre": vector(centre, "the centre"), "radius": number(radius, "the radius")})]
    )


def box(lower: npt.ArrayLike, upper: npt.ArrayLike) -> Set:
    """The box lower <= x <= upper."""
    corners = {
        "lower": vector(lower, "the lower corner"),
        "upper": vector(upper, "the upper corner"),
    }
    return Set([("box", corners)])


def half_space(
    normal: npt.ArrayLike, *, at_most: float | None = None, at_least: float | None = None
) -> Set:
    """The half-space normal·x <= at_most, or normal·x >= at_least."""
    sides = {"at_most": at_most, "at_least": at_least}
    given = {name: number(side, name) for name, side in sides.items() if side is not None}
    return Set([("half_space", {"normal": vector(normal, "the normal"), **given})])


def segment(start: npt.ArrayLike, end: npt.ArrayLike) -> Set:
    """The segment between two points."""
    return Set([("segment", {"from": vector(start, "the start"), "to": vector(end, "the end")})])


def affine_subspace(point: npt.ArrayLike, directions: npt.ArrayLike) -> Set:
    """The points point + t1 directions[0] + t2 directions[1] + … for all real t."""
    found = rows(directions, "the array of directions").tolist()
    return Set([("affine", {"through": vector(point, "the point"), "directions": found})])


def union(*sets: SetLike) -> Set:
    """The union of sets and points."""
    empty = Set([])
    return functools.reduce(
        operator.or_, (as_set(each, "a point of the union") for each in sets), empty
    )
