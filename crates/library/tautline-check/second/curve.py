"""The length of a polygon."""

import math

import numpy as np

from intervals import INF, Interval, of, up
from jets import Jet
from metric import gram, positive
from refused import require
from work import UNLIMITED, batches

# A part of a chord is halved if its length is not known better than this, relative to itself.
LOOSE = 1e-3

# How often a chord may be halved, and the most parts that are looked at together.
HALVINGS, BATCH = 12, 1 << 10


def length_above(formula, points, work=UNLIMITED):
    """An upper bound on the length of a polygon, all of which is proved to lie where H is defined and
    positive definite."""
    moved = (points[1:] != points[:-1]).any(axis=1)
    start, end = points[:-1][moved], points[1:][moved]
    if not len(start):
        # Equal points make no chord, but H has to be a metric there.
        h = gram(formula, [of(x) for x in points[:1].T])
        require(is_metric(h, formula.dimension).all(), "H is not proved to be a metric at a point")
        return 0.0
    chords = [np.arange(len(start))[part] for part in batches(len(start), BATCH)]
    left, lengths = [(HALVINGS, part, np.zeros(len(part))) for part in chords], []
    while left:
        halvings, chord, at = left.pop()
        work.spend(6 * formula.weight * len(at))
        width = 2.0 ** (halvings - HALVINGS)
        metric, length, rough = parts_of_chords(formula, start[chord], end[chord], at, width)
        bounded = metric & np.isfinite(length.lo + length.hi)
        if halvings:
            known = bounded & (length.hi - length.lo <= LOOSE * (length.hi + length.lo))
            lengths.extend(length.hi[known])
            chord, at = chord[~known], at[~known]
            if chord.size:
                left += [(halvings - 1, chord, at), (halvings - 1, chord, at + width / 2)]
        else:
            where = f"on chord {chord[~metric][:1].tolist()} of the curve"
            require(metric.all(), f"H is not proved to be a metric {where}")
            lengths.extend(np.where(bounded, length.hi, rough))
    try:
        return float(up(math.fsum(lengths)))
    except OverflowError:
        return INF


def is_metric(h, n):
    """Where H is proved to be defined and positive definite."""
    finite = [np.isfinite(entry.lo + entry.hi) for entry in h.values()]
    return np.all(finite, axis=0) & positive(h, n, of(0.0))


def parts_of_chords(formula, start, end, at, width):
    """For parts of chords from these parameters on, whether H is proved to be a metric on them, and
    two bounds on the length.

    The speed g on a part has the integral w (g(middle) + w² g''(somewhere)/24) ≤ w sup g.
    """
    n, origin = formula.dimension, [of(x) for x in start.T]
    d = [of(y) - x for y, x in zip(end.T, origin)]
    sides = list(zip(np.minimum(start, end).T, np.maximum(start, end).T))

    def on(s):
        """H on the part, and the square of the speed."""
        x = []
        for xi, di, side in zip(origin, d, sides):
            xi = Jet(s, [of(1.0)]) * di + xi
            # A chord that ends at a knot of a table does not reach beyond it.
            x.append(Jet(xi.value.within(*side), xi.first))
        h = formula(x, lambda c: Jet(c, [None]))
        terms = [h[i, j] * (d[i] * d[j]).scaled(1.0 if i == j else 2.0) for i, j in h]
        values = {
            ij: Interval(*np.broadcast_arrays(e.value.lo, e.value.hi, at)[:2])
            for ij, e in h.items()
        }
        return values, sum(terms[1:], terms[0])

    h, square = on(Interval(at, at + width))
    bent = square.sqrt().second.get((0, 0)) or of(0.0)
    speed = on(of(at + width / 2))[1].sqrt().value
    length = (speed + bent * width**2 / 24.0) * width
    greatest = of(np.maximum(square.value.hi, 0)).sqrt() * width
    return is_metric(h, n), length, greatest.hi
