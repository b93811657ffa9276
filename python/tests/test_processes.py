"""What goes to other processes, and how computations run there."""

import copy
import multiprocessing
import os
import pickle
import unittest
import warnings

import numpy as np

import tautline_geodesics as tl

HILL = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
START, GOAL = [-1.5, 0.05], [1.5, -0.1]


def two_costs(x):
    cost = np.where(x[:, 0] > 1, 2 + (x[:, 0] - 1) ** 4, 2)
    return cost[:, None, None] ** 2 * np.eye(2)


def length(metric, start, goal):
    return float(tl.solve(metric, start, goal, n=32).length)


def everything(_=None):
    """What uses all threads."""
    valleys = tl.Metric.cost("2 - cos(x1)", 2)
    curve = tl.solve(valleys, [0, 0], [1, 0.5], n=64)
    found = curve.certificate(0.2)
    return (
        [float(curve.length) for curve in tl.solve_batch(HILL, [START] * 2, [GOAL] * 2)],
        tl.distance_matrix(HILL, [START, GOAL, [0, 1]]).tolist(),
        (found.lower, found.upper),
        tl.check(found.text).lower,
        valleys.constants()["c1"].lower,
    )


class Pickles(unittest.TestCase):
    def copies(self, value):
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            yield pickle.loads(pickle.dumps(value, protocol))
        yield from (copy.copy(value), copy.deepcopy(value))

    def test_metrics(self):
        rows = np.array([[1.0, 1.0, 1.0], [1.0, 4.0, 2.0], [2.0, 2.0, 2.0]])
        metrics = [
            HILL,
            tl.Metric("[1 + a*x1^2, 0; 0, 1]", 2, parameters={"a": 0.25}),
            tl.Metric.cost(lambda x: 2 - np.cos(x[0]), 2),
            tl.Metric.image(rows, spacing=0.5),
            tl.Metric("cost(2*h(x1, x2))", 2, tables={"h": tl.Table(rows, spline="cubic")}),
            tl.Metric.black_box(two_costs, 2, step=1e-4),
        ]
        for metric in metrics:
            expected = length(metric, [0, 0], [0.7, 0.9])
            for other in self.copies(metric):
                self.assertEqual(metric, other)
                self.assertEqual(hash(metric), hash(other))
                np.testing.assert_array_equal(metric([0.3, 0.4]), other([0.3, 0.4]))
                self.assertEqual(length(other, [0, 0], [0.7, 0.9]), expected)
        with self.assertRaises((pickle.PicklingError, AttributeError, TypeError)):
            pickle.dumps(tl.Metric.black_box(lambda x: two_costs(x), 2))

    def test_metrics_with_other_tables_are_not_equal(self):
        images = [tl.Metric.image([[1.0, 2.0], [3.0, last]]) for last in (4.0, 4.0, 5.0)]
        self.assertEqual(images[0], images[1])
        self.assertNotEqual(images[0], images[2])

    def test_tables_and_splines(self):
        table = tl.Table([[1.0, 2.0, 5.0], [0.0, 3.0, 1.0]], spline="cubic")
        for other in self.copies(table):
            self.assertEqual(other(0.3, 1.2), table(0.3, 1.2))
        for other in self.copies(table.spline):
            np.testing.assert_array_equal(other.coefficients, table.spline.coefficients)

    def test_sets(self):
        flat = tl.Metric("1 I", 2)
        sets = [
            (tl.point([0, 2]), 2),
            (tl.points([[0, 3], [4, 0]]), 3),
            (tl.ball([0, 3], 1), 2),
            (tl.sphere([0, 3], 2), 1),
            (tl.box([-1, 1], [1, 2]), 1),
            (tl.half_space([0, 1], at_least=2), 2),
            (tl.segment([-1, 1], [1, 1]), 1),
            (tl.affine_subspace([5, 2], [[1, 0]]), 2),
            (tl.point([0, 9]) | tl.ball([0, 3], 1) | tl.half_space([0, -2], at_least=5), 2),
        ]
        for each, distance in sets:
            for other in self.copies(each):
                self.assertEqual(repr(other), repr(each))
                self.assertAlmostEqual(float(tl.solve(flat, [0, 0], other).length), distance)
        for pieces, message in [
            (("ball", {"centre": [0.0]}), "a ball needs radius"),
            (("ball", {"centre": [0.0], "radius": 1.0, "r": 2.0}), "a ball with r"),
            (("cone", {}), "cone"),
            (
                ("half_space", {"normal": [1.0], "at_least": 1.0, "at_most": 1.0}),
                "a half-space has either at_least or at_most",
            ),
        ]:
            with self.assertRaisesRegex(tl.ProblemError, message):
                tl.Set([pieces])

    def test_results(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        curve = tl.solve(valleys, [0, 0], [1, 0.5])
        found = curve.certificate(0.1)
        constants = HILL.constants()
        results = [found, tl.check(found.text), curve.bounds(), *constants.values()]
        for result in results:
            for other in self.copies(result):
                self.assertEqual(result, other)
                self.assertEqual(repr(result), repr(other))
        self.assertNotEqual(constants["c1"], constants["c2"])
        for other in self.copies(curve.length):
            self.assertEqual((other.value, other.error), (curve.length.value, curve.length.error))
        self.assertEqual(tl.check(pickle.loads(pickle.dumps(found)).text).lower, found.lower)

    def test_a_curve_is_its_own_copy_and_says_what_to_send(self):
        curve = tl.solve(HILL, START, GOAL, n=32)
        self.assertIs(copy.copy(curve), curve)
        self.assertIs(copy.deepcopy([curve])[0], curve)
        with self.assertRaisesRegex(TypeError, r"curve\.points"):
            pickle.dumps(curve)

    def test_a_pool_of_processes_solves(self):
        goals = [[1.5, -0.1], [0.0, 1.5]]
        expected = [length(HILL, START, goal) for goal in goals]
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            found = pool.starmap(length, [(HILL, tl.point(START), goal) for goal in goals])
        self.assertEqual(found, expected)

    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork")
    def test_a_child_by_fork_solves_on_threads_of_its_own(self):
        # Threads in this process, which the child does not have.
        expected = everything()
        with warnings.catch_warnings():
            # Python warns of threads before a fork.
            warnings.simplefilter("ignore", DeprecationWarning)
            pool = multiprocessing.get_context("fork").Pool(2)
        with pool:
            found = pool.map_async(everything, [None] * 3).get(timeout=60)
        self.assertEqual(found, [expected] * 3)


if __name__ == "__main__":
    unittest.main()
