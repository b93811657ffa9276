"""Tests of the sets: distances, membership, and values of polynomials on them."""

import math
import random
import unittest
from fractions import Fraction

import numpy as np

import sets
from intervals import Interval, of
from kuhn import simplices
from sets import bounding_box, contains, distance_below, on_piece


def some_piece(chance, n, near=1.0):
    x = np.array([chance.uniform(-near, near) for _ in range(n)])
    kind = chance.choice(["point", "ball", "box", "half-space"])
    if kind == "ball":
        return kind, np.append(x, chance.choice([0.0, 0.2, 0.7]))
    if kind == "box":
        return kind, np.append(x, x + np.array([chance.choice([0.0, 0.3, 1.0]) for _ in range(n)]))
    if kind == "half-space":
        normal = np.array([chance.uniform(-3, 3) for _ in range(n)])
        return kind, np.append(normal, chance.uniform(-1, 1))
    return kind, x


def distance(piece, x):
    """The distance of points, rows of x, from a piece."""
    (kind, s), n = piece, x.shape[1]
    if kind == "half-space":
        return np.maximum(x @ s[:n] - s[n], 0) / np.linalg.norm(s[:n])
    if kind == "box":
        return np.linalg.norm(np.maximum(0, np.maximum(s[:n] - x, x - s[n:])), axis=1)
    return np.maximum(np.linalg.norm(x - s[:n], axis=1) - (s[n] if kind == "ball" else 0), 0)


class Distances(unittest.TestCase):
    def test_of_a_union_the_nearest_piece_counts(self):
        chance = random.Random(1)
        for _ in range(200):
            n = chance.randint(1, 4)
            pieces = [some_piece(chance, n) for _ in range(chance.randint(1, 5))]
            x = np.array([[chance.uniform(-2, 2) for _ in range(n)] for _ in range(5)])
            exact = np.min([distance(piece, x) for piece in pieces], axis=0)
            found = distance_below(pieces, [of(xi) for xi in x.T])
            np.testing.assert_allclose(found, exact, rtol=1e-12, atol=1e-12)
            # From a box to a set: at most the distance of its points, and no less by more than its
            # diagonal.
            size = chance.choice([0.01, 0.5])
            found = distance_below(pieces, [Interval(xi, xi + size) for xi in x.T])
            self.assertTrue((found <= exact + 1e-12).all())
            self.assertTrue((found >= exact - size * math.sqrt(n) - 1e-12).all())

    def test_many_pieces_are_as_few_at_a_time(self):
        chance, before = random.Random(2), sets.MOST_PAIRS
        pieces = [some_piece(chance, 2) for _ in range(50)]
        x = [Interval(np.linspace(-2, 2, 7), np.linspace(-2, 2, 7) + 0.1)] * 2
        whole = distance_below(pieces, x)
        try:
            sets.MOST_PAIRS = 20
            np.testing.assert_array_equal(distance_below(pieces, x), whole)
        finally:
            sets.MOST_PAIRS = before

    def test_distances_are_rounded_down(self):
        for x, r in ((0.1, 0.0), (0.7, 0.3), (3.3, 1.1)):
            found = Fraction(
                float(
                    distance_below(
                        [("ball", np.array([0.0, 0.0, r]))], [of(np.array([x])), of(np.array([x]))]
                    )[0]
                )
            )
            self.assertLessEqual((found + Fraction(r)) ** 2, 2 * Fraction(x) ** 2)

    def test_a_union_with_a_half_space_is_unbounded(self):
        ball, wall = ("ball", np.array([0.0, 1.0, 0.5])), ("half-space", np.array([1.0, 0.0, -3.0]))
        self.assertIsNone(bounding_box([ball, wall], 2))
        self.assertIsNone(bounding_box([wall, ball], 2))
        x, y = bounding_box([ball, ("point", np.array([4.0, 1.0]))], 2)
        self.assertEqual([(x.lo, x.hi), (y.lo, y.hi)], [(-0.5, 4.0), (0.5, 1.5)])


class Membership(unittest.TestCase):
    def test_it_is_exact_and_the_boundary_belongs_to_the_set(self):
        # In doubles, the middle of 0.3 and its neighbours are on the same side.
        just_out = np.nextafter(0.1, 1)
        for pieces, x, expected in (
            ([("ball", [0.0, 0.1])], [0.1], True),
            ([("ball", [0.0, 0.1])], [just_out], False),
            ([("ball", [0.0, 0.0, 5.0])], [3.0, 4.0], True),
            ([("ball", [0.0, 0.0, 5.0])], [3.0, np.nextafter(4.0, 5)], False),
            # 0.1² + 0.2² is more than the square of the double next to its root.
            ([("ball", [0.0, 0.0, 0.2])], [0.2, 1e-200], False),
            ([("ball", [0.0, 0.0, 0.2])], [np.nextafter(0.2, 0), 1e-200], True),
            (
                [("half-space", [0.1, 0.2, 0.3])],
                [1.0, 1.0],
                Fraction(0.1) + Fraction(0.2) <= Fraction(0.3),
            ),
            ([("half-space", [1.0, 1.0, 1.0])], [1.0, 1e-300], False),
            ([("half-space", [1.0, 1.0, 1.0])], [0.5, 0.5], True),
            ([("box", [0.0, 0.0, 1.0, 1.0])], [1.0, 0.0], True),
            ([("box", [0.0, 0.0, 1.0, 1.0])], [1.0, -5e-324], False),
            ([("point", [0.1])], [0.1], True),
            ([("point", [0.1])], [just_out], False),
            ([("point", [0.0]), ("ball", [3.0, 1.0])], [4.0], True),
            ([("point", [0.0]), ("ball", [3.0, 1.0])], [0.0], True),
            ([("point", [0.0]), ("ball", [3.0, 1.0])], [1.0], False),
        ):
            pieces = [(kind, np.array(s)) for kind, s in pieces]
            self.assertEqual(contains(pieces, np.array(x)), expected, (pieces, x))


class OnSimplices(unittest.TestCase):
    def test_values_on_a_piece_lie_in_their_bounds_and_no_simplex_is_missed(self):
        chance, met, tight = random.Random(3), 0, 0
        for _ in range(150):
            n, side = chance.randint(1, 3), chance.choice([0.5, 1.0])
            low = np.array([chance.choice([-0.5, -0.25, 0.0]) for _ in range(n)])
            simplex = chance.choice(simplices(n))
            nodes = np.array([chance.uniform(-1, 1) for _ in range(3**n)])[:, None]
            form = simplex.bernstein(nodes)
            piece = some_piece(chance, n, 0.6)
            if chance.random() < 0.3 and piece[0] in ("point", "ball"):
                # On a face of several simplices.
                piece[1][:n] = low + side * np.array(
                    [chance.choice([0.0, 0.5, 1.0]) for _ in range(n)]
                )
            meets, ((lo, hi),) = on_piece(
                piece, simplex, [of(x).lo[None] for x in low], side, [form]
            )
            weights = np.array([self.weights(chance, n) for _ in range(300)])
            points = weights @ (low + side * simplex.corners)
            if piece[0] in ("point", "ball"):
                points = np.vstack([points, piece[1][None, :n]])
                y = (piece[1][:n] - low)[list(simplex.axes)] / side
                weights = np.vstack([weights, np.append(1, y) - np.append(y, 0)])
            inside = (distance(piece, points) == 0) & (weights >= 0).all(axis=1)
            values = sum(
                float(b.lo[0]) * weights[:, i] * weights[:, j] * (1 if i == j else 2)
                for (i, j), b in form.items()
            )[inside]
            if inside.any():
                met += 1
                self.assertTrue(meets[0], (piece, low, simplex.axes))
                self.assertLessEqual(lo[0], values.min() + 1e-12)
                self.assertGreaterEqual(hi[0], values.max() - 1e-12)
                whole = max(float(b.hi[0]) for b in form.values()) - min(
                    float(b.lo[0]) for b in form.values()
                )
                tight += bool(hi[0] - lo[0] < 0.9 * whole)
        self.assertGreater(met, 50)
        self.assertGreater(tight, 10)

    @staticmethod
    def weights(chance, n):
        w = np.array([-math.log(1 - chance.random()) for _ in range(n + 1)])
        return w / w.sum()

    def test_a_point_on_a_face_meets_every_simplex_with_the_face(self):
        for n in (1, 2, 3):
            for k in range(3**n):
                x = np.array(np.unravel_index(k, (3,) * n)) / 2.0
                for simplex in simplices(n):
                    y = np.sort(x)[::-1]
                    inside = (x[list(simplex.axes)] == y).all()
                    form = simplex.bernstein(np.zeros((3**n, 1)))
                    meets, _ = on_piece(("point", x), simplex, [np.zeros(1)] * n, 1.0, [form])
                    self.assertEqual(bool(meets[0]), bool(inside), (x, simplex.axes))


if __name__ == "__main__":
    unittest.main()
