"""The length of a polygon."""

import math

import numpy as np

from intervals import INF, Interval, of, up
from jets import Jet

# A part of a chord is halved if its length is not known better than this, relative to itself.
LOOSE = 1e-3


def length_above(formula, points):
    """An upper bound on the length of a polygon, infinite if the metric is undefined somewhere on it.

    The speed g on a part of a chord has the integral w (g(middle) + w² g''(somewhere)/24).
    """
    # Equal points make no chord, but the metric has to be defined there.
    first = formula([of(x) for x in points[0]], of)
    if not all(np.isfinite(entry.lo + entry.hi).all() for entry in first.values()):
        return INF
    moved = (points[1:] != points[:-1]).any(axis=1)
    start, end = points[:-1][moved], points[1:][moved]
    chord, at, width, lengths = np.arange(len(start)), np.zeros(len(start)), 1.0, []
    for halvings in reversed(range(13)):
        origin = [of(x) for x in start[chord].T]
        d = [of(y) - x for y, x in zip(end[chord].T, origin)]

        def speed(s):
            x = [Jet(s, [of(1.0)]) * di + xi for xi, di in zip(origin, d)]
            h = formula(x, lambda c: Jet(c, [None]))
            terms = [h[i, j] * (d[i] * d[j]).scaled(1.0 if i == j else 2.0) for i, j in h]
            return sum(terms[1:], terms[0]).sqrt()

        whole = speed(Interval(at, at + width))
        bent = whole.second.get((0, 0)) or of(0.0)
        length = (speed(of(at + width / 2)).value + bent * width**2 / 24.0) * width
        known = np.isfinite(length.lo + length.hi + whole.value.lo + whole.value.hi)
        if halvings:
            known &= length.hi - length.lo <= LOOSE * (length.hi + length.lo)
        lengths.extend(length.hi[known])
        chord, at = np.tile(chord[~known], 2), np.concatenate([at[~known], at[~known] + width / 2])
        width /= 2
        if not chord.size:
            return up(math.fsum(lengths))
    return INF
