"""Metrics with obstacles."""

import math
import pickle
import unittest

import numpy as np

import tautline_geodesics as tl

ENDS = [-3.0, 0.1], [3.0, -0.1]


class Obstacles(unittest.TestCase):
    def setUp(self):
        self.free = tl.Metric.phi("1", 2)

    def test_curves_go_round_a_ball_and_their_lengths_fall_to_the_shortest(self):
        # Two tangents and an arc; the ends are opposite each other.
        r = math.hypot(*ENDS[0])
        shortest = 2 * math.sqrt(r * r - 1) + math.pi - 2 * math.acos(1 / r)
        last = math.inf
        for margin in (0.1, 0.03, 0.01, 0.003):
            metric = self.free.avoiding(tl.ball([0, 0], 1), margin=margin)
            curve = tl.solve(metric, *ENDS)
            self.assertTrue(np.all(np.hypot(*curve.points.T) > 1))
            self.assertTrue(shortest < float(curve.length) < last)
            last = float(curve.length)
        self.assertLess(last, shortest + 0.03)

    def test_curves_go_round_a_box(self):
        square = self.free.avoiding(tl.box([-1, -1], [1, 1]), margin=1e-4)
        curve = tl.solve(square, [-2, 0], [2, 0], n=1024)
        self.assertTrue(np.all(np.abs(curve.points).max(axis=1) > 1))
        # Two sides of √2 and one of 2.
        self.assertAlmostEqual(float(curve.length), 2 + 2 * math.sqrt(2), delta=0.01)
        self.assertEqual(curve.doubts, [])

    def test_the_way_round_a_pillar_thinner_than_a_chord_is_found(self):
        pillar = self.free.avoiding(tl.ball([0, 0], 0.005), margin=1e-4)
        curve = tl.solve(pillar, [-3, 0], [3, 0])
        self.assertGreater(np.hypot(*curve.points.T).min(), 0.005)
        self.assertAlmostEqual(float(curve.length), 6, delta=1e-4)
        together = tl.distance_matrix(pillar, np.array([[-3.0, 0], [3, 0]]))
        self.assertEqual(together[0, 1], float(curve.length))

    def test_a_text_and_a_set_are_the_same_obstacle(self):
        ball = self.free.avoiding(tl.ball([1, -2], 0.5), margin=0.1)
        text = self.free.avoiding("sqrt((x1 - 1)^2 + (x2 + 2)^2) - 0.5", margin=0.1)
        x = np.array([[0.0, 0.0], [1.0, -1.4], [3.0, 5.0]])
        np.testing.assert_allclose(ball(x), text(x), rtol=1e-12)
        # (1 + (m/δ)²) I at the distance 0.1, which is the margin.
        np.testing.assert_allclose(ball([1.0, -1.4]), 2 * np.eye(2), rtol=1e-12)
        self.assertTrue(np.isnan(ball([1.0, -2.0])).any())

    def test_a_function_is_the_obstacle_of_its_text(self):
        text = self.free.avoiding("x1^2 + x2^2 - 1", tl.ball([5, 5], 1), margin=0.1)
        function = self.free.avoiding(lambda x: x @ x - 1, tl.ball([5, 5], 1), margin=0.1)
        again = pickle.loads(pickle.dumps(function))
        x = np.array([[2.0, 0.5], [-1.0, -1.4], [3.0, 5.0]])
        np.testing.assert_allclose(function(x), text(x), rtol=1e-14)
        np.testing.assert_array_equal(function(x), again(x))
        table = tl.Table(np.ones((4, 4)))
        for wrong, says in [(lambda x: table(x[0], x[1]), "walls"), (3.0, "3.0 is no obstacle")]:
            with self.assertRaisesRegex(tl.ProblemError, says):
                self.free.avoiding(wrong, margin=0.1)

    def test_a_sympy_expression_is_an_obstacle(self):
        try:
            import sympy
        except ImportError:
            self.skipTest("no SymPy")
        x, y = sympy.symbols("x y")
        found = self.free.avoiding(x**2 + y**2 - 1, margin=0.1, variables=(x, y))
        text = self.free.avoiding("x1^2 + x2^2 - 1", margin=0.1)
        np.testing.assert_allclose(found([2.0, 0.5]), text([2.0, 0.5]), rtol=1e-14)

    def test_a_metric_with_obstacles_keeps_its_tables_and_goes_to_other_processes(self):
        image = tl.Metric.image(np.ones((12, 9))).avoiding(
            tl.ball([5, 4], 2) | tl.half_space([0, 1], at_least=7), margin=0.05
        )
        again = pickle.loads(pickle.dumps(image))
        self.assertEqual(image, again)
        ends = [1, 4], [10, 4]
        curves = [tl.solve(metric, *ends, n=128) for metric in (image, again)]
        np.testing.assert_array_equal(curves[0].points, curves[1].points)
        self.assertGreater(np.hypot(*(curves[0].points - [5, 4]).T).min(), 2)

    def test_a_cost_stays_positive_beside_obstacles(self):
        table = tl.Table(np.full((4, 2), -2.0))
        for cost in (tl.Metric.cost("x1 - 5", 2), tl.Metric.cost(lambda x: table(*x), 2)):
            metric = cost.avoiding(tl.ball([9, 9], 1), margin=0.1)
            for each in (metric, pickle.loads(pickle.dumps(metric))):
                with self.assertRaisesRegex(tl.MetricError, "^the cost is -.*expected a positive"):
                    tl.solve(each, [0, 0.5], [3, 0.5], n=16)

    def test_what_is_in_an_obstacle_is_said(self):
        metric = self.free.avoiding(tl.ball([0, 0], 1), margin=0.1)
        with self.assertRaisesRegex(tl.MetricError, r"the point \[0.5, 0.0\] is in an obstacle"):
            tl.solve(metric, [0.5, 0], [3, 0])
        wall = self.free.avoiding("x1^2 - 1", margin=0.1)
        for each in (wall, pickle.loads(pickle.dumps(wall))):
            with self.assertRaisesRegex(tl.MetricError, "every search runs into an obstacle"):
                tl.solve(each, *ENDS)

    def test_each_end_is_looked_at_and_each_of_the_obstacles(self):
        twice = self.free.avoiding(tl.ball([0, 0], 1), margin=0.1).avoiding(
            tl.ball([9, 9], 1), margin=0.1
        )
        inside = r"the point \[0.5, 0.0\] is in an obstacle"
        for ends in ([[0.5, 0], [3, 0]], [[3, 0], [0.5, 0]]):
            with self.assertRaisesRegex(tl.MetricError, inside):
                tl.solve(twice, *ends)

    def test_an_end_where_the_metric_itself_is_undefined_is_in_no_obstacle(self):
        logarithm = tl.Metric.phi("2 + ln(x1)", 2).avoiding(tl.ball([5, 5], 1), margin=0.1)
        with self.assertRaisesRegex(tl.MetricError, "out of the domain"):
            tl.solve(logarithm, [-1, 0], [3, 0])

    def test_what_is_no_obstacle_is_refused(self):
        for obstacle, margin, says in [
            (tl.ball([0, 0], 0), 0.1, "no obstacle"),
            (tl.sphere([0, 0], 1), 0.1, "no obstacle"),
            (tl.ball([0, 0, 0], 1), 0.1, "3 coordinates"),
            (tl.ball([0, 0], 1), 0.0, "the margin of the obstacles is 0"),
            (tl.ball([0, 0], 1), math.inf, "the margin of the obstacles is inf"),
            ("x3", 0.1, "x3"),
        ]:
            with self.assertRaisesRegex(ValueError, says):
                self.free.avoiding(obstacle, margin=margin)
        black = tl.Metric.black_box(lambda x: np.tile(np.eye(2), (len(x), 1, 1)), 2)
        with self.assertRaisesRegex(tl.ProblemError, "no formula"):
            black.avoiding(tl.ball([0, 0], 1), margin=0.1)


if __name__ == "__main__":
    unittest.main()
