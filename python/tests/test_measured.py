"""Images, fields and tables: their places, their axes, and what is refused."""

import unittest

import numpy as np

import tautline as tl


class Images(unittest.TestCase):
    def test_given_starts_alone_leave_the_lattice_out(self):
        wall = np.ones((64, 64))
        wall[30:34, :60] = 1e3
        image = tl.Metric.image(wall, spacing=0.5, origin=[1.0, -2.0])
        ends = [6.0, 0.5], [26.0, 0.5]
        with self.assertWarns(tl.UnresolvedWarning):
            curve = tl.solve(image, *ends, starts=np.array(ends), only_these_starts=True)
        # Straight through the wall; round it is less than 100.
        self.assertGreater(float(curve.length), 500)
        flat = tl.Metric.image(np.ones((4, 4)))
        straight = np.array([[0.0, 0.0], [3.0, 3.0]])
        curve = tl.solve(flat, *straight, starts=straight, only_these_starts=True, tolerance=1e-3)
        self.assertAlmostEqual(float(curve.length), 18**0.5)

    def test_obstacles_keep_the_lattice(self):
        image = tl.Metric.image(np.ones((5, 4)), spacing=0.5)
        self.assertEqual(image.avoiding(tl.ball([9, 9], 1), margin=0.1).lattice, image.lattice)


class Fields(unittest.TestCase):
    def test_a_field_has_its_matrices_at_its_places(self):
        scale = 1 + np.arange(6.0)[:, None] ** 2 + np.arange(5.0)
        h = scale[..., None, None] * np.eye(2)
        field = tl.Metric.field(h, spacing=[0.5, 2], origin=[1, -1], interpolate=True)
        np.testing.assert_allclose(field([1 + 0.5 * 3, -1 + 2 * 2]), h[3, 2], rtol=1e-12)
        self.assertEqual(field.lattice, ([1, -1], [3.5, 7], [0.5, 2]))

    def test_halves_that_differ_by_roundings_are_their_mean(self):
        h = np.tile([[2.0, 0.5], [0.5, 1.0]], (4, 3, 1, 1))
        h[2, 1, 0, 1] = np.nextafter(0.5, 1)
        found = tl.Metric.field(h, interpolate=True)([2, 1])
        self.assertEqual(found[0, 1], found[1, 0])
        self.assertAlmostEqual(found[0, 1], 0.5, places=14)
        for wrong in (0.5 + 1e-9, np.nan):
            h[2, 1, 0, 1] = wrong
            with self.assertRaisesRegex(tl.ProblemError, r"\(2, 1\).*must be symmetric"):
                tl.Metric.field(h)

    def test_a_matrix_that_is_only_semidefinite_is_refused(self):
        h = np.tile(np.eye(2), (4, 3, 1, 1))
        h[1, 0, 1, 1] = 0
        with self.assertRaisesRegex(tl.ProblemError, r"\(1, 0\)"):
            tl.Metric.field(h)


class Tables(unittest.TestCase):
    def test_an_argument_of_a_table_may_be_a_number(self):
        table = tl.Table([[1.0, 1.0, 1.0], [1.0, 4.0, 2.0], [2.0, 2.0, 2.0]])
        for v in (0.5, np.float32(1.5), np.array(0.5), np.True_):
            first = tl.Metric.phi(lambda x: table(x[0], v), 1)([1.2])[0, 0]
            second = tl.Metric.phi(lambda x: table(v, x[0]), 1)([1.2])[0, 0]
            self.assertAlmostEqual(first, table(1.2, v), places=14)
            self.assertAlmostEqual(second, table(v, 1.2), places=14)


if __name__ == "__main__":
    unittest.main()
