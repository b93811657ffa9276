"""The sets: lists of pieces, each a kind and its numbers."""

from fractions import Fraction

import numpy as np

from intervals import INF, Interval, add_down, add_up, of
from jets import upper
from kuhn import bounds, least
from work import batches

# The most pairs of a piece and a box that are looked at together.
MOST_PAIRS = 1 << 18


def constraints(piece):
    kind, x = piece
    n = {"point": len(x), "ball": len(x) - 1, "half-space": len(x) - 1, "box": len(x) // 2}[kind]
    if kind == "ball":
        return [(x[:n], np.zeros(n), of(x[n]).sqr())]
    if kind == "half-space":
        return [(None, x[:n], of(x[n]))]
    sides = [
        (None, np.eye(n)[i] * s, of(s * x[i + (n if s > 0 else 0)]))
        for i in range(n)
        for s in (1, -1)
    ]
    return sides


def polar(constraint, x, y):
    """The Bernstein coefficient for two vertices; for x = y the value there."""
    centre, normal, offset = constraint
    total = -offset
    for i, (xi, yi) in enumerate(zip(x, y)):
        if abs(normal[i]) == 1:
            # Facets may lie in the side of a box or of a half-space: this product is exact.
            total = total + ((xi + yi) if normal[i] > 0 else -(xi + yi)).scaled(0.5)
        elif normal[i] != 0:
            total = total + ((xi + yi) * normal[i]).scaled(0.5)
        if centre is not None:
            product = (xi - centre[i]).sqr() if x is y else (xi - centre[i]) * (yi - centre[i])
            total = total + product
    return total


def norm(x):
    found = sum((xi.sqr() for xi in x), of(0.0)).sqrt()
    # It is no less than any coordinate, which is exact where all others are 0.
    return Interval(np.max([found.lo, *(xi.mignitude() for xi in x)], axis=0), found.hi)


def distances_below(kind, numbers, x):
    """Lower bounds on the distance between each set of one kind, a row of numbers, and each box."""
    n, columns = len(x), numbers.T[:, :, None]
    if kind == "half-space":
        height = sum((xi * c for xi, c in zip(x, columns)), of(0.0)) - columns[n]
        distance = height.positive() / norm([of(c) for c in columns[:n]])
    elif kind == "box":
        gaps = zip(x, columns, columns[n:])
        distance = norm([(of(a) - xi).positive() + (xi - b).positive() for xi, a, b in gaps])
    else:
        distance = norm([xi - c for xi, c in zip(x, columns)])
        distance = distance - (columns[n] if kind == "ball" else 0.0)
    return np.where(distance.lo > 0, distance.lo, 0)


def distance_below(pieces, x):
    """A lower bound on the distance between a set and each box."""
    found = np.full(x[0].lo.shape, INF)
    for kind in {kind for kind, _ in pieces}:
        numbers = np.array([s for other, s in pieces if other == kind])
        for rows in batches(len(numbers), max(1, MOST_PAIRS // max(1, found.size))):
            found = np.minimum(found, distances_below(kind, numbers[rows], x).min(axis=0))
    return found


def bounding_box(pieces, n):
    """The smallest box around a set, rounded outward; None if the set is unbounded."""
    if any(kind == "half-space" for kind, _ in pieces):
        return None
    ends = []
    for kind, x in pieces:
        r = x[n] if kind == "ball" else 0.0
        low, high = x[:n], x[n:] if kind == "box" else x[:n]
        ends.append((add_down(low, -r), add_up(high, r)))
    return [Interval(min(lo[i] for lo, _ in ends), max(hi[i] for _, hi in ends)) for i in range(n)]


def contains(pieces, x):
    """Whether a point lies in a set, in exact arithmetic."""
    x = list(map(Fraction, x))

    def in_piece(kind, s):
        s, n = list(map(Fraction, s)), len(x)
        if kind == "half-space":
            return sum(a * b for a, b in zip(s, x)) <= s[n]
        if kind == "box":
            return all(a <= b <= c for a, b, c in zip(s, x, s[n:]))
        return sum((a - b) ** 2 for a, b in zip(s, x)) <= (s[n] ** 2 if kind == "ball" else 0)

    return any(in_piece(*piece) for piece in pieces)


def on_piece(piece, simplex, low, side, forms):
    """Where a piece may meet the simplex, and for each form bounds on its values there."""
    kind, s = piece
    n = len(low)
    if kind == "point" or kind == "ball" and s[n] == 0:
        height = [(of(s[axis]) - low[axis]).scaled(1 / side) for axis in simplex.axes]
        weights = [a - b for a, b in zip([of(1.0), *height], [*height, of(0.0)])]
        meets = np.all([(w.hi >= 0) & (w.lo <= 1) for w in weights], axis=0)
        weights = [
            Interval(np.maximum(w.lo, 0), np.minimum(w.hi, 1)).where(meets, 0.0) for w in weights
        ]
        values = []
        for form in forms:
            terms = [
                (weights[i] * weights[j] * b).scaled(1.0 if i == j else 2.0)
                for (i, j), b in form.items()
            ]
            value, (lo, hi) = sum(terms, of(0.0)), bounds(form)
            values.append(
                (np.where(value.lo > lo, value.lo, lo), np.where(value.hi < hi, value.hi, hi))
            )
        return meets, values
    vertices = [[of(low[i] + side * w[i]) for i in range(n)] for w in simplex.corners]
    functions = [
        {(i, j): polar(c, vertices[i], vertices[j]) for i, j in upper(n + 1)}
        for c in constraints(piece)
    ]
    meets = ~np.any([least(b) > 0 for b in functions], axis=0)
    values = []
    for form in forms:
        negative = {ij: -b for ij, b in form.items()}
        values.append((least_where(form, functions), -least_where(negative, functions)))
        # Bounds that cross prove that there is no such point.
        meets &= values[-1][0] <= values[-1][1]
    return meets, values


def least_where(form, functions):
    """A lower bound on a form where all functions b ≤ 0: there φ ≥ φ + Σ μ b for all μ ≥ 0.

    The μ, floats, make the gradient of the sum small, one function after the other.
    """

    def slopes(form, n):
        return np.array([(form[m, m].lo - form[m - 1, m - 1].lo) for m in range(1, n + 1)])

    n, total = max(i for i, _ in form), form
    for b in functions:
        direction = slopes(b, n)
        factor = -(slopes(total, n) * direction).sum(axis=0) / (direction**2).sum(axis=0)
        touches = ~(np.max([c.hi for c in b.values()], axis=0) < 0)
        factor = np.where(touches & (factor > 0) & np.isfinite(factor), factor, 0.0)
        total = {ij: total[ij] + b[ij] * factor for ij in form}
    found, plain = least(total), bounds(form)[0]
    return np.where(found > plain, found, plain)
