"""The page of the guide about Python, and images and fields as it describes them."""

import pathlib
import pickle
import re
import unittest
import warnings

import numpy as np

import tautline_geodesics as tautline

PAGE = pathlib.Path(__file__).parents[2] / "guide" / "pages" / "python.md"


class TheGuide(unittest.TestCase):
    def test_the_blocks_of_its_page_run_in_their_order(self):
        blocks = re.findall(r"^```python[^\n]*\n(.*?)^```", PAGE.read_text("utf-8"), re.M | re.S)
        self.assertGreaterEqual(len(blocks), 4)
        names = {}
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            for number, block in enumerate(blocks):
                exec(compile(block, f"block {number} of {PAGE.name}", "exec"), names)


class Lattices(unittest.TestCase):
    def test_an_image_is_searched_along_its_pixels(self):
        wall = np.ones((64, 64))
        wall[30:34, :60] = 1e3
        image = tautline.Metric.image(wall, spacing=0.5, origin=[1.0, -2.0])
        self.assertEqual(image.lattice, ([1.0, -2.0], [32.5, 29.5], [0.5, 0.5]))
        ends = [6.0, 0.5], [26.0, 0.5]
        found = float(tautline.solve(image, *ends, n=256).length)
        # Straight to the end of the wall and back: twice the root of 10² + 27.5², which a rounded corner
        # of a wall exceeds by little.
        self.assertTrue(58.5 < found < 63, found)
        # So is what another process gets.
        again = pickle.loads(pickle.dumps(image))
        self.assertEqual(again.lattice, image.lattice)
        image.lattice = None
        with self.assertWarns(tautline.UnresolvedWarning):
            straight = tautline.solve(image, *ends, n=256)
        self.assertGreater(float(straight.length), 500)

    def test_sets_beside_the_lattice_are_joined_without_it(self):
        image = tautline.Metric.image(np.ones((4, 4)))
        with self.assertWarnsRegex(tautline.UnresolvedWarning, "no node of the lattice .* second set"):
            curve = tautline.solve(image, [1, 1], [1, 9])
        self.assertAlmostEqual(float(curve.length), 8.0, delta=1e-12)

    def test_what_is_no_lattice_is_refused(self):
        metric = tautline.Metric.cost("2 - cos(x1)", 2)
        for lattice, says in [
            (([0, 0], [1, 1], 0.0), "the spacing 0"),
            (([0, 0], [1, -1], 0.1), "coordinate 2"),
            (([0, 0, 0], [1, 1, 1], 0.1), "a corner of a lattice has 3 coordinates"),
        ]:
            metric.lattice = lattice
            with self.assertRaisesRegex(ValueError, says):
                tautline.solve(metric, [0, 0], [1, 1])

    def test_classes_find_every_way_past_the_hills(self):
        hills = "1 + " + " + ".join(f"20*exp(-(x1^2 + (x2 - ({y}))^2)/0.08)" for y in (-1.0, 0.1, 1.3))
        metric, ends = tautline.Metric.cost(hills, 2), ([-2, 0], [2, 0.1])
        with self.assertRaisesRegex(ValueError, "classes = 4 without a lattice"):
            tautline.solve(metric, *ends, n=64, classes=4)
        near = tautline.solve(metric, *ends, n=64, scope="local")
        self.assertLess(len(near.other_minima) + 1, 4)
        metric.lattice = ([-2.2, -2.0], [2.2, 2.2], 0.1)
        # Below, above and twice between them.
        self.assertEqual(len(tautline.solve(metric, *ends, n=64, classes=4).other_minima) + 1, 4)
        for classes in (0, 1.5, True):
            with self.assertRaisesRegex(ValueError, "classes is .*; expected a whole number"):
                tautline.solve(metric, *ends, n=64, classes=classes)


class Tables(unittest.TestCase):
    def test_metrics_that_call_other_tables_are_others(self):
        first, second = ([1.0, 2.0, 4.0], [3.0, 1.0, 1.0])
        tables = {"a": first, "b": second}
        one = tautline.Metric("[9 + a(x1) - 0.1*b(x1)]", 1, tables=tables)
        self.assertNotEqual(one, tautline.Metric("[9 + b(x1) - 0.1*a(x1)]", 1, tables=tables))
        exchanged = {"b": first, "a": second}
        self.assertEqual(one, tautline.Metric("[9 + b(x1) - 0.1*a(x1)]", 1, tables=exchanged))

    def test_large_images_have_coarser_lattices(self):
        for shape, spacing in [((3000, 3000), 1.0), ((300, 300, 300), 0.5), ((40, 2000), (100.0, 1.0))]:
            image = tautline.Metric.image(np.ones(shape), spacing=spacing, spline="smoothing")
            first, last, step = (np.array(x) for x in image.lattice)
            self.assertLess(np.prod(np.floor((last - first) / step) + 1), 2.1e6)
            np.testing.assert_array_equal(step / step.min(), spacing / np.min(spacing) * np.ones(len(shape)))
        with self.assertRaisesRegex(tautline.ProblemError, "more than .* coefficients as a monotone spline"):
            tautline.Metric.image(np.ones((300, 300, 300)))


class Fields(unittest.TestCase):
    def test_a_field_is_the_metric_of_its_matrices(self):
        # Splines reproduce linear functions inside of their grid.
        x = np.stack(np.meshgrid(np.arange(9) / 2, np.arange(8) / 2, indexing="ij"), axis=-1)
        a = np.array([[3.0, 0.5], [0.5, 2.0]]) + 0.25 * x[..., :1, None] * np.eye(2)
        field = tautline.Metric.field(a, spacing=0.5)
        text = tautline.Metric("[3 + x1/4, 0.5; 0.5, 2 + x1/4]", 2)
        ends = [1.0, 1.0], [3.0, 2.5]
        curves = [tautline.solve(metric, *ends, n=64) for metric in (field, text)]
        lengths = [float(curve.length) for curve in curves]
        self.assertAlmostEqual(lengths[0], lengths[1], delta=1e-12)
        # The least eigenvalue is 5/2 - 1/√2, on the border; constants have a tolerance of 1e-3.
        self.assertGreater(field.constants()["c1"].lower, 0.998 * (2.5 - 0.5**0.5))
        found = curves[0].certificate(gap=1e-2)
        self.assertLess(found.lower, lengths[0])
        self.assertTrue(found.reached)
        self.assertEqual(tautline.check(found.text).lower, found.lower)

    def test_what_is_no_field_is_refused(self):
        good = np.tile(np.eye(2), (4, 3, 1, 1))
        for h, says in [
            (np.eye(2), "shape"),
            (np.ones((4, 3, 2)), "shape"),
            (np.ones((4, 3, 3, 3)), "shape"),
            (good * np.array([1.0, -1.0]), r"\(0, 0\)"),
            (good + np.array([[0.0, 0.5], [0.0, 0.0]]), "symmetric"),
            (np.where(np.arange(3)[:, None, None] == 2, np.nan, good), r"\(0, 2\)"),
        ]:
            with self.assertRaisesRegex(ValueError, says):
                tautline.Metric.field(h)


if __name__ == "__main__":
    unittest.main()
