"""Tests of the curve: its length from above, and the domain of the metric."""

import itertools
import math
import random
import unittest
from fractions import Fraction

import numpy as np

import campaign
import curve
from curve import length_above
from formula import Formula
from refused import Refused
from table import Table
from work import Work


def polygon(*points):
    return np.array(points, float).reshape(len(points), -1)


POCKET = ["s1 = sqr(x1);", "s2 = sqr(x2);", "s3 = s1 + s2;", "s4 = s3 * -50.0;", "s5 = exp(s4);"]
POCKET += [
    "s6 = s5 * -0.9;",
    "s7 = s6 + 1.0;",
    "s8 = s5 * -3.0;",
    "s9 = s8 + 1.0;",
    "s10 = number(0.0);",
]
POCKET += ["[s7, s10; s10, s9]"]


class Length(unittest.TestCase):
    def test_it_is_an_upper_bound_and_close(self):
        # H = (1 + x²)², with the length 1 + 1/3 from 0 to 1.
        f = Formula(["s1 = sqr(x1);", "s2 = s1 + 1.0;", "s3 = sqr(s2);", "[s3]"], 1)
        for points in ([0, 1], [1, 0], [0, 0.5, 1], [0, 0.3, 0.3, 0.9, 1], np.linspace(0, 1, 50)):
            x = polygon(*points)
            steps = [Fraction(b) - Fraction(a) for a, b in zip(x[:-1, 0], x[1:, 0])]
            exact = sum(map(abs, steps)) * Fraction(4, 3)
            found = length_above(f, x)
            self.assertTrue(
                exact <= Fraction(found) <= exact * (1 + Fraction(1e-3)), (found, exact)
            )
        # On a chord of length w, g'' is known to about 10 w, so that w² g''/24 is to w³/2.
        self.assertLessEqual(length_above(f, polygon(*np.linspace(0, 1, 400))), 4 / 3 + 400**-3)
        # There and back.
        self.assertGreaterEqual(length_above(f, polygon(0, 1, 0)), 8 / 3)

    def test_the_curvature_of_the_speed_counts_with_its_sign(self):
        # The speed 1 + x² is above the midpoint rule on a part of a thousandth of it, and the speed
        # 1 − x² below.
        for sign, lines in (
            (1, ["s1 = sqr(x1);", "s2 = s1 + 1.0;"]),
            (-1, ["s1 = sqr(x1);", "s2 = s1 * -1.0;", "s3 = s2 + 1.0;"]),
        ):
            last = f"s{len(lines)}"
            f = Formula([*lines, f"s{len(lines) + 1} = sqr({last});", f"[s{len(lines) + 1}]"], 1)
            for a, b in ((0.0, 0.05), (0.1, 0.12), (0.0, 0.5)):
                exact = b - a + sign * (b**3 - a**3) / 3
                found = length_above(f, polygon(a, b))
                self.assertTrue(exact <= found <= exact * (1 + 1e-3))
                midpoint = (b - a) * (1 + sign * ((a + b) / 2) ** 2)
                if sign > 0 and b < 0.5:
                    self.assertGreater(found, midpoint)

    def test_a_constant_metric_loses_only_rounding(self):
        f = Formula(["s1 = number(2.0);", "s2 = number(0.5);", "[s1, s2; s2, s1]"], 2)
        chance = random.Random(1)
        for _ in range(20):
            x = polygon(*[[chance.uniform(-1, 1), chance.uniform(-1, 1)] for _ in range(6)])
            found, least = Fraction(length_above(f, x)), Fraction(0)
            for a, b in zip(x[:-1], x[1:]):
                d, e = (Fraction(q) - Fraction(p) for p, q in zip(a, b))
                square = 2 * d * d + d * e + 2 * e * e
                root = Fraction(math.isqrt(square.numerator * 2**200 // square.denominator), 2**100)
                least += root
            self.assertTrue(least <= found <= least * (1 + Fraction(1e-14)))

    def test_chords_end_at_knots(self):
        # H = 1 + 0.05 T'' is linear on cells; the first numbers are those of a table of the field.
        f = Formula(
            ["s1 = table1_2(x1);", "s2 = s1 * 0.05;", "s3 = s2 + 1.0;", "[s3]"],
            1,
            [Table(np.array([0.0, 1.0, 0.0, 1.0]))],
        )
        bends = {0: 1.0, 1: -2.0, 2: 2.0, 3: -1.0}
        for points in ([0, 1], [0, 1, 2, 3], [0.1, 1, 1.7, 2, 2.9, 3], [3, 2, 1, 0]):
            exact = 0.0
            for a, b in zip(points, points[1:]):
                a, b = min(a, b), max(a, b)
                k = math.floor(a)
                h = [1 + 0.05 * (bends[k] + (x - k) * (bends[k + 1] - bends[k])) for x in (a, b)]
                exact += (
                    (b - a)
                    * 2
                    / 3
                    * (h[0] + math.sqrt(h[0] * h[1]) + h[1])
                    / (math.sqrt(h[0]) + math.sqrt(h[1]))
                )
            found = length_above(f, polygon(*points))
            self.assertTrue(exact * (1 - 1e-14) <= found <= exact * (1 + 1e-3))
            # No part is halved 12 times, as one that reaches beyond its cell would be.
            work = Work(math.inf)
            length_above(f, polygon(*points), work)
            self.assertLess(work.spent, 6 * f.weight * 12 * len(points))
        # A fine polygon with knots among its points is as good as one over a smooth metric.
        fine = length_above(f, polygon(*np.linspace(0, 3, 301)))
        self.assertLess(fine, length_above(f, polygon(0, 1, 2, 3)))
        x = np.linspace(0, 3, 300001)
        x = 0.5 * (x[1:] + x[:-1])
        exact = np.mean(np.sqrt(1 + 0.05 * np.interp(x, list(bends), list(bends.values())))) * 3
        self.assertTrue(exact * (1 - 1e-10) <= fine <= exact * (1 + 1e-6))

    def test_a_chord_over_a_knot_has_the_greatest_speed_on_its_last_part(self):
        # There, the second derivative is not bounded: 2⁻¹² of the chord has no better bound.
        f = Formula(
            ["s1 = table1_2(x1);", "s2 = s1 * 0.05;", "s3 = s2 + 1.0;", "[s3]"],
            1,
            [Table(np.array([0.0, 1.0, 0.0, 1.0]))],
        )
        for a, b in ((-0.3, 1.4), (0.3, 1.1), (0.9, 1.1)):
            x = np.linspace(a, b, 200001)
            x = 0.5 * (x[1:] + x[:-1])
            h = 1 + 0.05 * np.interp(x, [-2, -1, 0, 1, 2, 3], [0, 0, 1, -2, 2, -1])
            exact = np.mean(np.sqrt(h)) * (b - a)
            found = length_above(f, polygon(a, b))
            self.assertTrue(exact * (1 - 1e-9) <= found <= exact * (1 + 1e-3), (a, b, found, exact))


class Domain(unittest.TestCase):
    def refuses(self, f, points):
        with self.assertRaises(Refused):
            length_above(f, points)

    def test_a_curve_does_not_pass_where_the_metric_is_indefinite(self):
        f = Formula(POCKET, 2)
        # The speed along the axis is positive everywhere: 1 − 0.9 exp(−50x²). H is not, where
        # exp(−50x²) ≥ 1/3, that is for |x| ≤ 0.148.
        for cuts in ([], [0.6], [-0.9, -0.3, 0.3, 0.9], [-0.16, 0.16], [-0.2, -0.13], [0.14, 0.16]):
            self.refuses(f, polygon(*[[x, 0] for x in [-1, *cuts, 1]]))
        # One part among many is enough, at the begin, in the middle or at the end.
        for x in (np.linspace(-1, 0.01, 200), np.linspace(0.1, 1, 200), np.linspace(-1, 1, 1001)):
            self.refuses(f, np.array([x, 0 * x]).T)
        for y in (0.3, 0.2, -0.17):
            around = polygon([-1, 0], [-0.5, y], [0.5, y], [1, 0])
            if abs(y) > 0.149:
                self.assertLess(length_above(f, around), 4)
            else:
                self.refuses(f, around)

    def test_after_a_chord_over_a_knot_others_are_in_the_domain_too(self):
        # H = 1 + 0.50001 T'' is negative within 1e-5 of 1. Where the first chord crosses the knot 0, no
        # second derivative is bounded, so that it is halved 12 times. At 3/7 of it, as the second chord
        # reaches 1 at 3/7.
        f = Formula(
            ["s1 = table1_2(x1);", "s2 = s1 * 0.50001;", "s3 = s2 + 1.0;", "[s3]"],
            1,
            [Table(np.array([0.0, 1.0, 0.0, 1.0]))],
        )
        self.assertLess(length_above(f, polygon(-0.3, 0.4)), 1.2)
        self.refuses(f, polygon(-0.3, 0.4, 1.8))
        self.refuses(f, polygon(1.8, 0.4, -0.3))

    def test_of_many_chords_each_is_in_the_domain(self):
        f, before = Formula(POCKET, 2), curve.BATCH
        try:
            curve.BATCH = 8
            good = np.array([[x, 0.4] for x in np.linspace(-1, 1, 60)])
            self.assertLess(length_above(f, good), 2.1)
            for at in range(1, 58, 7):
                bad = np.insert(good, at + 1, [[0.1, 0.05], [0.1, 0.06]], axis=0)
                self.refuses(f, bad)
        finally:
            curve.BATCH = before

    def test_a_curve_of_one_point_is_in_the_domain_too(self):
        f = Formula(POCKET, 2)
        for points in (polygon([0.1, 0.0]), polygon([0.1, 0.0], [0.1, 0.0])):
            self.refuses(f, points)
            self.assertEqual(length_above(f, points + 1.0), 0.0)
        f = Formula(["s1 = recip(x1);", "s2 = s1^0;", "[s2]"], 1)
        self.refuses(f, polygon(0))
        self.assertEqual(length_above(f, polygon(1)), 0.0)

    def test_a_matrix_with_a_zero_or_two_negative_eigenvalues_is_no_metric(self):
        for entries in (
            ("1.0", "1.0", "1.0"),
            ("-1.0", "0.0", "-1.0"),
            ("1.0", "2.0", "1.0"),
            ("0.0", "0.0", "1.0"),
        ):
            names = {x: f"s{i + 1}" for i, x in enumerate(dict.fromkeys(entries))}
            a, b, c = (names[x] for x in entries)
            f = Formula(
                [*(f"{s} = number({x});" for x, s in names.items()), f"[{a}, {b}; {b}, {c}]"], 2
            )
            self.refuses(f, polygon([0, 0], [1, 0.1]))
            self.refuses(f, polygon([0, 0]))

    def test_no_curve_of_the_campaign_leaves_the_domain(self):
        chance, refused = random.Random(2), 0
        for family, n in itertools.product((campaign.pocket, campaign.pole), (1, 2, 2, 3)):
            for _ in range(3):
                metric = family(chance, n)
                start = np.array([chance.uniform(-1, -0.2) for _ in range(n)])
                end = np.array([chance.uniform(0.2, 1) for _ in range(n)])
                points = np.linspace(start, end, chance.choice([2, 3, 20]))
                _, good = metric.on_polygon(points, 400 // len(points))
                try:
                    length_above(metric.formula, points)
                    self.assertTrue(good, metric.lines)
                except Refused:
                    refused += 1
        self.assertGreater(refused, 8)


if __name__ == "__main__":
    unittest.main()
