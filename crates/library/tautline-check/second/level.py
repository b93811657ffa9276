"""One level: cubes of one side, and two numbers at each of their nodes."""

import itertools
import math

import numpy as np

from refused import require

# The most places in a box around the cubes.
WIDEST = 1 << 48


class Level:
    """Cubes (rows of places), their side, and two values at each of their nodes."""

    def __init__(self, exponent, cubes, values):
        self.exponent, self.side, self.cubes = exponent, 2.0**exponent, cubes
        self.dimension = cubes.shape[1]
        require(len(cubes), "a level has no cubes")
        self.low = cubes.min(axis=0)
        widths = cubes.max(axis=0) - self.low + 1
        # So the keys below have less than 64 bits.
        apart = math.prod(widths.tolist()) > WIDEST
        require(not apart, "a box around the cubes of a level has more than 2^48 places")
        self.extent = widths + 2
        _, self.nodes = self.numbers(2)
        found = self.nodes.max(initial=-1) + 1
        require(found == len(values), f"{len(values)} pairs of values for {found} nodes")
        self.at_nodes = values
        self.keys = self.key(cubes, 1)

    def values(self, cubes):
        """The values of φ and of ψ at the 3^D nodes of some cubes, a column for each cube."""
        return [self.at_nodes[:, f][self.nodes[:, cubes]] for f in (0, 1)]

    def key(self, places, n):
        """A number for each place of the lattice of side/n, increasing lexicographically."""
        return np.ravel_multi_index(
            tuple((places - n * self.low + 1).T), tuple(n * self.extent + 3)
        )

    def numbers(self, n):
        """The points from n k to n k + n of all cubes k, and their numbers, cube by cube."""
        offsets = np.array(list(itertools.product(range(n + 1), repeat=self.dimension)))
        keys = np.array([self.key(n * self.cubes + offset, n) for offset in offsets])
        keys, numbers = np.unique(keys, return_inverse=True)
        points = np.unravel_index(keys, tuple(n * self.extent + 3))
        return np.array(points) + (n * self.low - 1)[:, None], numbers.reshape(len(offsets), -1)

    def holds(self, places):
        """Whether there is a cube at each place."""
        near = ((places >= self.low - 1) & (places < self.low + self.extent)).all(axis=1)
        found = np.zeros(len(places), bool)
        found[near] = np.isin(self.key(places[near], 1), self.keys)
        return found
