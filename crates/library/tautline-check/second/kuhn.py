"""Kuhn's simplices, and quadratic polynomials on them."""

import itertools

import numpy as np

from intervals import INF, of
from jets import upper


class Simplex:
    def __init__(self, axes):
        n, self.axes = len(axes), axes
        self.corners = np.array(
            [[int(axis in axes[:m]) for axis in range(n)] for m in range(n + 1)]
        )

    def corner(self, m):
        """The number of a corner among the 2^D of the cube."""
        return int(np.ravel_multi_index(self.corners[m], (2,) * len(self.axes)))

    def node(self, values, i, j):
        """The values at the midpoint of two corners, in each cube."""
        return values[
            np.ravel_multi_index(self.corners[i] + self.corners[j], (3,) * len(self.axes))
        ]

    def bernstein(self, values):
        """The coefficients b with φ = Σ bᵢⱼ λᵢ λⱼ: φ lies between the least and the greatest."""

        def coefficient(i, j):
            a, b = (of(self.node(values, k, k)) for k in (i, j))
            return a if i == j else of(self.node(values, i, j)).scaled(2.0) - (a + b).scaled(0.5)

        return {ij: coefficient(*ij) for ij in upper(len(self.axes) + 1)}

    def gradient(self, values, k, side):
        """The gradient at the corner k.

        Along an edge from k the derivative is 4(mid − at k) − (end − at k); the axis π(m) is the
        difference of the edges to m and to m − 1. This holds for m or m − 1 = k, too.
        """
        gradient = [None] * len(self.axes)
        for m, axis in enumerate(self.axes, 1):
            mids = of(self.node(values, k, m)) - of(self.node(values, k, m - 1))
            ends = of(self.node(values, m, m)) - of(self.node(values, m - 1, m - 1))
            gradient[axis] = (mids.scaled(4.0) - ends).scaled(1 / side)
        return gradient


def simplices(n):
    return [Simplex(axes) for axes in itertools.permutations(range(n))]


def least(form):
    return np.min([b.lo for b in form.values()], axis=0)


def bounds(form):
    """Bounds on all values, infinite where a coefficient is unknown."""
    lo, hi = least(form), np.max([b.hi for b in form.values()], axis=0)
    return np.where(np.isnan(lo), -INF, lo), np.where(np.isnan(hi), INF, hi)
