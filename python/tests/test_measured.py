"""Images, fields and tables: their places, their axes, and what is refused."""

import unittest

import numpy as np

import tautline_geodesics as tl


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

    def test_an_image_has_its_costs(self):
        # Rough ground: between pixels the cost is between those around.
        costs = np.exp(np.random.default_rng(0).normal(size=(20, 30)))
        image = tl.Metric.image(costs, spacing=0.5, origin=[1, -2])

        def at(i, j):
            return np.sqrt(image(np.stack([1 + 0.5 * i, -2 + 0.5 * j], -1))[..., 0, 0])

        i, j = np.indices((20, 30)).astype(float)
        np.testing.assert_allclose(at(i, j), costs, rtol=1e-12)
        around = np.lib.stride_tricks.sliding_window_view(np.pad(costs, 1, mode="edge"), (4, 4))
        between = at(i[:-1, :-1] + 0.3, j[:-1, :-1] + 0.8)
        low, high = around.min((-1, -2)), around.max((-1, -2))
        self.assertTrue(np.all((between >= low * (1 - 1e-12)) & (between <= high * (1 + 1e-12))))

    def test_a_road_one_pixel_wide_is_a_road(self):
        ground = np.full((60, 60), 10.0)
        ground[30] = 1
        curve = tl.solve(tl.Metric.image(ground), [30, 5], [30, 55])
        self.assertAlmostEqual(float(curve.length), 50.0, delta=1e-9)
        smooth = tl.solve(tl.Metric.image(ground, spline="smoothing"), [30, 5], [30, 55])
        # 10 − 9 · 2/3, beside which the curve finds nothing better.
        self.assertAlmostEqual(float(smooth.length), 200.0, delta=1e-6)

    def test_what_is_masked_is_a_wall_if_asked(self):
        ground = np.ma.array(np.ones((40, 40)), mask=np.zeros((40, 40), bool))
        ground[20, :35] = np.ma.masked
        holes = ground.filled(np.nan)
        # Round the end of the wall, over the free pixel (20, 35), or along the pixels beside the wall.
        shortest, beside = 2 * np.hypot(10, 30), 2 * np.hypot(9, 30) + 2
        for walls in (ground, holes, np.where(np.isnan(holes), np.inf, holes)):
            with self.assertRaisesRegex(tl.ProblemError, "with walls=True cells that are masked, NaN or inf"):
                tl.Metric.image(walls)
            image = tl.Metric.image(walls, walls=True)
            curve = tl.solve(image, [10, 5], [30, 5], n=512)
            self.assertTrue(shortest < float(curve.length) < beside + 1e-3, curve.length)
        ground[20] = np.ma.masked
        image = tl.Metric.image(ground, walls=True)
        with self.assertRaisesRegex(tl.MetricError, "crosses a wall: no way between the walls"):
            tl.solve(image, [10, 5], [30, 5])
        ends = [[10, 5], [30, 5], [12, 5]]
        matrix = tl.distance_matrix(image, ends)
        np.testing.assert_array_equal(np.isnan(matrix), [[0, 1, 0], [1, 0, 1], [0, 1, 0]])
        self.assertAlmostEqual(matrix[0, 2], 2.0)
        curves, messages = tl.solve_batch(image, ends[0], ends[1:], on_error="return")
        self.assertEqual([curve is None for curve in curves], [True, False])
        self.assertIn("no way", messages[0])
        with self.assertRaisesRegex(tl.ProblemError, r"\(0, 1\) is -1.0; it must be positive"):
            tl.Metric.image([[np.nan, -1.0]], walls=True)
        with self.assertRaisesRegex(tl.ProblemError, "would spread the walls"):
            tl.Metric.image(holes, walls=True, spline="smoothing")
        with self.assertRaisesRegex(tl.ProblemError, "all cells of the cost are walls"):
            tl.Metric.image([[np.nan, np.inf]], walls=True)

    def test_a_wall_along_a_diagonal_is_a_wall(self):
        ground = np.ones((20, 20))
        i = np.arange(15)
        ground[i, i] = np.nan
        curve = tl.solve(tl.Metric.image(ground, walls=True), [3, 12], [12, 3], n=512)
        # Round the end of the wall at (14, 14), and not beyond the free pixel (15, 15).
        end, beside = 2 * np.hypot(11, 2), 2 * np.hypot(12, 3)
        self.assertTrue(end < float(curve.length) < beside, curve.length)

    def test_obstacles_keep_the_lattice(self):
        image = tl.Metric.image(np.ones((5, 4)), spacing=0.5)
        self.assertEqual(image.avoiding(tl.ball([9, 9], 1), margin=0.1).lattice, image.lattice)


class Periods(unittest.TestCase):
    def test_distances_on_a_flat_torus(self):
        # The nearest translate along each axis is the nearest of all.
        flat, period = tl.Metric.phi("1", 2), np.array([2 * np.pi, 3.0])
        a, b = np.random.default_rng(3).uniform(-10, 10, (2, 200, 2))
        steps = np.abs(a - b) % period
        exact = np.hypot(*np.minimum(steps, period - steps).T)
        batch = [float(curve.length) for curve in tl.solve_batch(flat, a, b, period=period)]
        np.testing.assert_allclose(batch, exact, rtol=1e-13)
        single = [float(tl.solve(flat, x, y, period=period).length) for x, y in zip(a, b)]
        np.testing.assert_allclose(single, exact, rtol=1e-13)
        matrix = tl.distance_matrix(flat, a[:2], b[:2], period=period)
        np.testing.assert_allclose(np.diag(matrix), exact[:2], rtol=1e-13)

    def test_great_circles_over_the_date_line(self):
        globe = tl.Metric.diag(["(6371*pi/180*cos(x2*pi/180))^2", "(6371*pi/180)^2"], 2)
        tokyo, oakland = [139.7, 35.7], [-122.4, 37.8]
        curve = tl.solve(globe, tokyo, oakland, period=[360, 0])
        # By the haversine of the angle between them.
        (l1, p1), (l2, p2) = np.deg2rad([tokyo, oakland])
        h = np.sin((p2 - p1) / 2) ** 2 + np.cos(p1) * np.cos(p2) * np.sin((l2 - l1) / 2) ** 2
        self.assertAlmostEqual(float(curve.length), 2 * 6371 * np.arcsin(h**0.5), delta=0.5)
        np.testing.assert_allclose(curve.points[-1], [360 - 122.4, 37.8])
        found = curve.certificate(1e-3)
        self.assertTrue(found.reached and found.upper < 8272)

    def test_a_period_that_the_metric_does_not_have_is_refused(self):
        metric = tl.Metric.cost("2 + cos(x1)", 2)
        with self.assertRaisesRegex(tl.ProblemError, r"does not have the period 6 in x1: at \["):
            tl.solve(metric, [0, 0], [3, 0], period=[6, 0])
        with self.assertRaisesRegex(tl.ProblemError, "the period has 1 coordinates"):
            tl.distance_matrix(metric, [[0, 0], [3, 0]], period=[2 * np.pi])
        # Row 1 alone shows that the cost has no period.
        bump = tl.Metric.cost("1 + 5*exp(-100*(x1 - 1)^2)", 2)
        with self.assertRaisesRegex(tl.ProblemError, "does not have the period 2"):
            tl.solve_batch(bump, [[5, 0], [0, 0]], [[5.1, 0], [1.9, 0]], period=[2, 0])
        with self.assertRaisesRegex(tl.ProblemError, "a period besides obstacles"):
            free = tl.Metric.phi("1", 2)
            tl.solve(free.avoiding(tl.ball([8, 0], 1), margin=1e-9), [0, 0], [6, 0], period=[10, 0])
        with self.assertRaisesRegex(tl.ProblemError, "period -1"):
            tl.solve(metric, [0, 0], [3, 0], period=[0, -1])


class Fields(unittest.TestCase):
    def test_a_field_has_its_matrices_at_its_places(self):
        scale = 1 + np.arange(6.0)[:, None] ** 2 + np.arange(5.0)
        h = scale[..., None, None] * np.eye(2)
        field = tl.Metric.field(h, spacing=[0.5, 2], origin=[1, -1], spline="cubic")
        np.testing.assert_allclose(field([1 + 0.5 * 3, -1 + 2 * 2]), h[3, 2], rtol=1e-12)
        self.assertEqual(field.lattice, ([1, -1], [3.5, 7], [0.5, 2]))

    def test_a_field_stays_positive_definite(self):
        # The axes turn by 60 degrees from node to node, with a contrast of 10⁴.
        i, j = np.indices((6, 6))
        c, s = np.cos((i + j) * np.pi / 3), np.sin((i + j) * np.pi / 3)
        turn = np.moveaxis(np.array([[c, -s], [s, c]]), (0, 1), (-2, -1))
        h = turn @ np.diag([1.0, 1e-4]) @ np.swapaxes(turn, -1, -2)
        h = (h + np.swapaxes(h, -1, -2)) / 2
        field = tl.Metric.field(h)
        np.testing.assert_allclose(field(np.stack([i, j], -1).astype(float)), h, atol=1e-14)
        points = np.random.default_rng(1).uniform(-1, 6, (2000, 2))
        # A coefficient has at least half of the least eigenvalue of its node, in two passes.
        self.assertGreater(np.linalg.eigvalsh(field(points)).min(), 0.99e-4 / 4)

    def test_halves_that_differ_by_roundings_are_their_mean(self):
        h = np.tile([[2.0, 0.5], [0.5, 1.0]], (4, 3, 1, 1))
        h[2, 1, 0, 1] = np.nextafter(0.5, 1)
        found = tl.Metric.field(h, spline="cubic")([2, 1])
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
