"""What results say of themselves."""

import math
import operator
import unittest
import warnings
from unittest import mock

import numpy as np

import tautline_geodesics as tl

# A hill, and below it a thin wall that few chords do not see.
WALL = tl.Metric.cost(
    "1 + 4*exp(-2*(x1^2 + x2^2)) + 20*exp(-800*x1^2)*(1 - tanh(4*x2))", dimension=2
)
ENDS = [-1.5, -0.05], [1.5, -0.05]


class Estimates(unittest.TestCase):
    length = tl.Estimate(4.675289135171557, 2e-15)

    def test_an_estimate_is_used_as_its_number(self):
        length = self.length
        self.assertEqual(f"{length:.3f} {length:8.2e}", "4.675 4.68e+00")
        self.assertEqual(f"{length}", "Estimate(value=4.675289135171557, error=2.0e-15)")
        self.assertEqual((round(length, 2), round(length)), (4.68, 5))
        value, error = length
        self.assertEqual((value, error), (4.675289135171557, 2e-15))
        self.assertTrue(4 < length < 5 and length > np.float32(4) and length <= 4.675289135171557)
        self.assertEqual(length, 4.675289135171557)
        self.assertEqual(hash(length), hash(4.675289135171557))
        self.assertEqual(sorted([length, tl.Estimate(1, 0)])[0], 1)
        self.assertEqual(float(max(length, 7)), 7.0)
        with self.assertRaises(TypeError):
            operator.lt(length, "5")

    def test_estimates_are_calculated_with_as_numbers(self):
        length, value = self.length, self.length.value
        two = tl.Estimate(2.0, 0.5)
        for found, expected in [
            (length + 1, value + 1),
            (1 + length, 1 + value),
            (length - two, value - 2),
            (10 - length, 10 - value),
            (length * 2, 2 * value),
            (2 * length, 2 * value),
            (length / two, value / 2),
            (1 / length, 1 / value),
            (length**2, value**2),
            (-length, -value),
            (abs(-1 * length), value),
            (sum([length, length]), 2 * value),
            (math.sqrt(length), value**0.5),
            (np.sqrt(length), value**0.5),
        ]:
            self.assertEqual(found, expected)
            self.assertIsInstance(found, float)
        self.assertEqual((np.array([1.0, 2.0]) * length).tolist(), [value, 2 * value])
        self.assertEqual(np.array([length, two], dtype=float).tolist(), [value, 2.0])
        with self.assertRaises(TypeError):
            length + "1"

    def test_estimates_are_equal_if_both_parts_are(self):
        self.assertEqual(self.length, tl.Estimate(4.675289135171557, 2e-15))
        self.assertNotEqual(self.length, tl.Estimate(4.675289135171557, 1e-15))
        self.assertFalse(self.length != tl.Estimate(4.675289135171557, 2e-15))
        self.assertNotEqual(self.length, None)


class Doubts(unittest.TestCase):
    def test_a_curve_says_that_it_is_not_resolved_and_that_another_is_shorter(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            curve = tl.solve(WALL, *ENDS, n=8, scope="local")
        shorter = float(curve.other_minima[0].length)
        self.assertLess(shorter, float(curve.length))
        self.assertFalse(curve.resolved)
        self.assertEqual(curve.shorter_minimum, shorter)
        first, second = curve.doubts
        self.assertRegex(first, "^the metric changes between the points of the rule, .* with 8 chords$")
        self.assertRegex(second, "^another minimum is shorter, ")
        self.assertAlmostEqual(float(second.split(", ")[1]), shorter, delta=1e-9)
        self.assertTrue(repr(curve).endswith(f", converged, {first}, {second}>"))
        self.assertEqual([each.category for each in caught], [tl.UnresolvedWarning])
        self.assertIn(f"{first}; {second}", str(caught[0].message))
        self.assertEqual(caught[0].filename, __file__)

    def test_the_shortest_curve_that_was_met_is_the_answer(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            one = tl.solve(WALL, *ENDS, n=8)
            many = tl.solve_batch(WALL, [ENDS[0]], [ENDS[1]], n=8)[0]
        self.assertEqual((one.doubts, one.points.tolist()), ([], many.points.tolist()))
        self.assertEqual(one.rule, many.rule)
        fine = tl.solve(WALL, *ENDS, n=512)
        self.assertAlmostEqual(float(one.length) / float(fine.length), 1, delta=0.02)

    def test_no_pair_on_the_sphere_is_closer_than_its_angle(self):
        sphere = tl.Metric.cost("2/(1 + x1^2 + x2^2)", 2)
        x = np.random.default_rng(1).uniform(-2, 2, (40, 2))
        squares = (x**2).sum(axis=1)
        on_sphere = np.c_[2 * x, squares - 1] / (1 + squares)[:, None]
        exact = np.arccos(np.clip(on_sphere @ on_sphere.T, -1, 1))
        for n in (64, 256):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = tl.distance_matrix(sphere, x, n=n)
            error = (found - exact)[~np.eye(40, dtype=bool)] / exact[~np.eye(40, dtype=bool)]
            self.assertTrue(np.all((error > -1e-12) & (error < 1e-2)), (error.min(), error.max()))

    def test_a_search_that_steps_over_a_pole_is_sent_back(self):
        exact = math.acosh(1 + 0.5e6)
        for plane in (tl.Metric.cost("1/x2", 2), tl.Metric.speed(lambda x: x[1], 2)):
            curve = tl.solve(plane, [0, 1e-3], [1, 1e-3], n=4096)
            self.assertAlmostEqual(float(curve.length) / exact, 1, delta=1e-6)
            (together,) = tl.solve_batch(plane, [[0, 1e-3]], [[1, 1e-3]], n=4096)
            np.testing.assert_array_equal(together.points, curve.points)

    def test_a_longer_minimum_is_no_doubt(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            curve = tl.solve(WALL, *ENDS, n=128)
        self.assertEqual(len(curve.other_minima), 1)
        self.assertEqual((curve.doubts, curve.shorter_minimum), ([], None))
        self.assertTrue(repr(curve).endswith("converged>"))

    def test_a_matrix_counts_the_pairs_with_doubts(self):
        with self.assertWarnsRegex(tl.UnresolvedWarning, "^2 of 3 curves .* by 8 chords") as warned:
            tl.distance_matrix(WALL, [*ENDS, [1.5, -0.5]], n=8, scope="local")
        self.assertEqual(warned.filename, __file__)


class Proofs(unittest.TestCase):
    def test_a_certificate_shows_its_gap_and_whether_it_is_reached(self):
        curve = tl.solve(tl.Metric.cost("2 - cos(x1)", 2), [0, 0], [1, 0.5], n=64)
        good, poor = curve.certificate(0.2), curve.certificate(1e-6, cubes=100)
        self.assertRegex(repr(good), r"gap [1-9]\.\de-\d, reached>$")
        self.assertRegex(repr(poor), rf"gap [1-9]\.\de-\d, not reached: {poor.ended}>$")
        upper = f"upper = {good.upper!r}>"
        self.assertTrue(repr(tl.check(good.text)).endswith(upper))

    def test_a_tolerance_takes_as_many_chords_as_it_needs(self):
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        ends = [-1.5, 0.05], [1.5, -0.1]
        distance = float(tl.solve(hill, *ends, n=8192).extrapolated)
        for tolerance in (1e-4, 1e-9):
            curve = tl.solve(hill, *ends, tolerance=tolerance)
            error = float(curve.length) / distance - 1
            self.assertTrue(abs(error) <= tolerance and curve.is_within(tolerance))
            self.assertEqual(curve.n > 256, tolerance == 1e-9)
        # The excess itself is above a hundredth of the tolerance.
        self.assertTrue(error > 1e-11 and not curve.is_within(1e-11))
        self.assertFalse(curve.is_within(float("nan")) or curve.is_within(0))
        # A search that ends too early.
        coarse = tl.solve(hill, *ends)
        ended = tl.Metric.cost("1", 2)
        ended.program = mock.Mock(solve=lambda *_: coarse)
        with self.assertWarnsRegex(tl.UnresolvedWarning, "may exceed 1e-09 with 256 chords"):
            tl.solve(ended, *ends, tolerance=1e-9)
        with self.assertRaisesRegex(tl.ProblemError, "n = 256 and tolerance = 0.1"):
            tl.solve(hill, *ends, n=256, tolerance=0.1)
        for wrong in (0, -1.0, 1.0, 1e-300):
            with self.assertRaisesRegex(tl.ProblemError, "must be at least 1e-13"):
                tl.solve(hill, *ends, tolerance=wrong)
        with self.assertRaisesRegex(tl.ProblemError, "a tolerance besides a lattice.*metric.lattice = None"):
            tl.solve(tl.Metric.image(np.ones((4, 4))), [0, 0], [3, 3], tolerance=1e-3)
        image = tl.Metric.image(np.ones((4, 4)))
        image.lattice = None
        self.assertAlmostEqual(float(tl.solve(image, [0, 0], [3, 3], tolerance=1e-3).length), 18**0.5)

    def test_the_straight_distance_needs_no_global_minimum(self):
        # A curve on the wrong side of a hill, and a bound that holds for all curves.
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        curve = tl.solve(hill, [-1.5, 0.05], [1.5, -0.1], n=64)
        bounds = curve.bounds(claimed=(1, 25, 1e6, None))
        self.assertEqual(bounds.lower_by, "Proposition 3.3")
        self.assertEqual(bounds.global_minimum, "not needed")
        self.assertAlmostEqual(bounds.lower, math.hypot(3, 0.15), places=9)


class Batches(unittest.TestCase):
    hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)

    def test_each_rule_arrives(self):
        a, b = [-1.5, 0.05], [1.5, -0.1]
        for rule in tl.RULES:
            one = tl.solve(self.hill, a, b, n=32, rule=rule)
            [curve] = tl.solve_batch(self.hill, a, [b], n=32, rule=rule)
            np.testing.assert_array_equal(curve.points, one.points)
            matrix = tl.distance_matrix(self.hill, [a], [b], n=32, rule=rule)
            self.assertEqual(matrix[0, 0], float(one.length))

    def test_a_tolerance_of_constants_arrives(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        rough, fine = (valleys.constants(tolerance=t)["L_H"] for t in (0.5, 1e-6))
        self.assertLess(fine.upper - fine.lower, 1e-5)
        self.assertGreater(rough.upper - rough.lower, 1e-5)

    def test_black_boxes_are_equal_if_their_functions_are(self):
        def one(x):
            return np.ones((len(x), 1, 1))

        def two(x):
            return 2 * one(x)

        box = tl.Metric.black_box(one, 1)
        self.assertEqual(box, tl.Metric.black_box(one, 1))
        for other in (
            tl.Metric.black_box(two, 1),
            tl.Metric.black_box(one, 1, step=1e-4),
            tl.Metric.phi("1", 1),
        ):
            self.assertNotEqual(box, other)


if __name__ == "__main__":
    unittest.main()
