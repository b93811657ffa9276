"""The Python module, as its users see it."""

import doctest
import math
import pathlib
import signal
import threading
import time
import unittest

import numpy as np

import tautline_geodesics as tl


def load_tests(loader, tests, pattern):
    """The examples of the documentation are tests."""
    for module in (tl, tl._metric, tl._table, tl._trace):
        tests.addTests(doctest.DocTestSuite(module))
    return tests


class Solving(unittest.TestCase):
    def test_a_ball_and_a_half_space(self):
        valleys = tl.Metric("cost(2 - cos(x1))", 2)
        curve = tl.solve(valleys, tl.ball([0, 0], 0.5), tl.half_space([1, 0], at_least=3))
        self.assertAlmostEqual(curve.length.value, 5 - math.sin(3) + math.sin(0.5), places=6)
        self.assertEqual(curve.points.shape, (257, 2))
        self.assertTrue(curve.converged and curve.resolved)

    def test_unions(self):
        flat = tl.Metric("1 I", 2)
        either = tl.ball([0, 3], 1) | tl.point([0, -2.5])
        self.assertAlmostEqual(float(tl.solve(flat, [0, 0], either).length), 2.0)

    def test_a_batch_has_the_curves_of_single_solves(self):
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        starts, goals = np.array([[-1.5, 0.05]] * 3), np.array([[1.5, -0.1], [0, 1.5], [0, -1.5]])
        for curve, a, b in zip(tl.solve_batch(hill, starts, goals), starts, goals):
            np.testing.assert_array_equal(curve.points, tl.solve(hill, a, b).points)

    def test_distance_matrices(self):
        flat = tl.Metric("1 I", 3)
        x = np.random.default_rng(7).normal(size=(6, 3))
        exact = np.linalg.norm(x[:, None] - x[None], axis=2)
        np.testing.assert_allclose(tl.distance_matrix(flat, x), exact, atol=1e-12)
        np.testing.assert_allclose(tl.distance_matrix(flat, x[:2], x), exact[:2], atol=1e-12)

    def test_certificates(self):
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        found = tl.solve(hill, [-1.5, 0.05], [1.5, -0.1]).certificate(1e-2)
        self.assertTrue(found.reached and found.lower < 4.6752711725 < found.upper)
        verdict = tl.check(found.text)
        self.assertEqual((verdict.lower, verdict.upper), (found.lower, found.upper))
        with self.assertRaisesRegex(tl.NotCertified, "refused"):
            tl.check(found.text.replace("from point", "from pint"))

    def test_matrices_at_many_points(self):
        metric = tl.Metric("[1 + x1^2, x2/4; x2/4, 2]", 2)
        x = np.random.default_rng(3).uniform(-1, 1, (4, 3, 2))
        h = metric(x)
        self.assertEqual(h.shape, (4, 3, 2, 2))
        np.testing.assert_array_equal(h[2, 1], metric(x[2, 1]))
        np.testing.assert_array_equal(h[..., 0, 1], x[..., 1] / 4)
        for wrong in (1.0, [1.0, 2.0, 3.0]):
            with self.assertRaises(tl.ProblemError):
                metric(wrong)

    def test_pictures(self):
        import matplotlib

        matplotlib.use("Agg")
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        curve = tl.solve(hill, [-1.5, 0.05], [1.5, -0.1])
        ax = tl.plot(hill, [curve, *curve.other_minima], color="tab:red")
        np.testing.assert_array_equal(ax.lines[0].get_xydata(), curve.points)
        self.assertEqual(len(ax.lines), 2)
        # The background is the cost: 5 on the hill, 1 far out.
        background = ax.collections[0].get_array()
        self.assertTrue(4.9 < background.max() <= 5 and 1 <= background.min() < 1.1)
        with self.assertRaisesRegex(tl.ProblemError, r"\(0, 2\) of curves in 2 dim"):
            tl.plot(hill, curve, coordinates=(0, 2))

    def test_theorems(self):
        # The numbers of the example in Rust.
        self.assertEqual(f"{tl.theorem_1_1_excess((1, 2, 0.5, 1), 2.9963, 2, 512):.3e}", "3.052e+03")
        left, other = (tl.theorem_1_3_excess((1, 2, 0.5, 1), 3, 2, n) for n in (512, 2048))
        self.assertTrue(1.9 < left / other < 4.1)
        with self.assertRaisesRegex(tl.ProblemError, "n = 0"):
            tl.theorem_1_1_excess((1, 2, 0.5, 1), 3, 2, 0)

    def test_bounds_and_constants(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        curve = tl.solve(valleys, [0, 0], [1, 0.5])
        bounds = curve.bounds()
        self.assertTrue(bounds.lower <= float(curve.extrapolated) <= bounds.upper)
        self.assertTrue(bounds.constants_proved, bounds)
        self.assertIn(bounds.global_minimum, ("proved", "not needed"))
        loose = curve.bounds(claimed=(1, 9, 5, None))
        self.assertFalse(loose.constants_proved)
        self.assertLess(loose.lower, bounds.lower)
        c1 = valleys.constants()["c1"]
        self.assertTrue(c1.proved and 1 - 1e-3 <= c1.lower <= 1 <= c1.upper)
        within = valleys.constants(tl.ball([math.pi, 0], 0.1))["c1"]
        self.assertGreater(within.lower, 8.9)
        with self.assertRaisesRegex(tl.NotCertified, "ball or a box"):
            tl.Metric.phi("1 + x1^2", 1).constants()
        with self.assertRaisesRegex(tl.ProblemError, "union"):
            valleys.constants(tl.ball([0, 0], 1) | tl.ball([3, 0], 1))
        with self.assertRaisesRegex(tl.ProblemError, "c2"):
            curve.bounds(claimed=(2, 1, 1, None))

    def test_control_c_ends_a_search(self):
        # A job in the background of a shell ignores it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
        curve = tl.solve(hill, [-1.5, 0.05], [1.5, -0.1])
        far = tl.Metric.cost("1 + 4*exp(-2*((x1 - 1e6)^2 + x2^2))", 2)
        rng = np.random.default_rng(0)
        weights = rng.normal(size=(32, 8)) / 3, rng.normal(size=(40, 32)) / 6
        decoder = tl.Metric.pullback(lambda z: weights[1] @ np.tanh(weights[0] @ z), 8)
        for search in (
            lambda: curve.certificate(1e-12, cubes=10**8),
            lambda: tl.solve(decoder, -np.ones(8), np.linspace(0, 1, 8), n=5000),
            # Rounding is far above the tolerance.
            lambda: tl.solve(far, [1e6 - 1.5, 0.05], [1e6 + 1.5, -0.1], tolerance=1e-13),
            lambda: tl.Metric.phi("2 + sin(7*x1)*sin(5*x2)*sin(x3)*sin(x4)", 4).constants(
                tolerance=1e-9, boxes=10**9
            ),
        ):
            timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
            start = time.monotonic()
            timer.start()
            with self.assertRaises(KeyboardInterrupt):
                search()
            self.assertLess(time.monotonic() - start, 1.5)

    def test_a_set_is_refused_where_it_is_made(self):
        cases = [
            ("coordinate NaN at index 1", lambda: tl.point([0, math.nan])),
            ("the set is empty", lambda: tl.points(np.zeros((0, 2)))),
            ("radius -1", lambda: tl.ball([3, 0], -1)),
            ("coordinate inf at index 1", lambda: tl.box([0, 0], [1, math.inf])),
            ("upper corner -1 at index 1", lambda: tl.box([0, 0], [1, -1])),
            ("normal", lambda: tl.half_space([0, 0], at_most=1)),
            ("1 coordinates in dimension 2", lambda: tl.segment([0, 0], [1])),
            ("direction 1 depends", lambda: tl.affine_subspace([0, 0], [[1, 0], [2, 0]])),
        ]
        for message, attempt in cases:
            with self.assertRaisesRegex(tl.ProblemError, message):
                attempt()

    def test_errors_have_the_numbers(self):
        flat = tl.Metric("1 I", 2)
        cases = [
            (tl.ProblemError, "3 coordinates in 2 dim", lambda: tl.solve(flat, [0, 0, 0], [1, 1])),
            (tl.ProblemError, "radius", lambda: tl.solve(flat, [0, 0], tl.ball([3, 0], -1))),
            (tl.ProblemError, "n is 0; expected", lambda: tl.solve(flat, [0, 0], [1, 1], n=0)),
            (tl.ProblemError, "\"midpoint\" is no rule; .* 'simpson'", lambda: tl.solve(flat, [0, 0], [1, 1], rule="midpoint")),
            (tl.ProblemError, "\"far\" is no scope; the scopes are 'automatic', 'local'", lambda: tl.solve(flat, [0, 0], [1, 1], scope="far")),
            (tl.MetricError, "", lambda: tl.solve(tl.Metric("x1 I", 1), [-1], [1])),
            (tl.ProblemError, "gap", lambda: tl.solve(flat, [0, 0], [1, 1]).certificate(2)),
            (tl.ProblemError, "dimension", lambda: tl.Metric("1 I")),
            (tl.ProblemError, "257 dimensions", lambda: tl.Metric("1 I", 257)),
            (tl.ProblemError, "", lambda: tl.Metric("sine(x1) I", 1)),
            (tl.ProblemError, "shape", lambda: tl.solve_batch(flat, [[0, 0]], [[1, 1], [2, 2]])),
        ]
        for kind, message, attempt in cases:
            with self.assertRaisesRegex(kind, message):
                attempt()


class Tracing(unittest.TestCase):
    def test_functions_and_texts_are_the_same_program(self):
        def swirl(x):
            u = np.exp(-(x[0] ** 2) - x[1] ** 2)
            return np.array([[2 + u * np.sin(x[0]), 0.5 * u], [0.5 * u, 2.0 - np.tanh(x[1])]])

        text = "u = exp(-x1^2 - x2^2); [2 + u*sin(x1), 0.5*u; 0.5*u, 2 - tanh(x2)]"
        self.assertEqual(tl.Metric(swirl, 2), tl.Metric(text, 2))
        x = [0.3, -0.7]
        np.testing.assert_allclose(tl.Metric(swirl, 2)(x), swirl(np.array(x)), rtol=1e-15)

    def test_array_operations(self):
        a = np.array([[2.0, 0.5], [0.5, 1.0]])
        metric = tl.Metric(lambda x: a * (1 + x @ x) + np.outer(np.sin(x), np.sin(x)), 2)
        x = np.array([0.4, -1.2])
        np.testing.assert_allclose(metric(x), a * (1 + x @ x) + np.outer(np.sin(x), np.sin(x)))

    def test_forms(self):
        self.assertEqual(
            tl.Metric.cost(lambda x: 2 - np.cos(x[0]), 2), tl.Metric("cost(2 - cos(x1))", 2)
        )
        sphere = tl.Metric.pullback(
            lambda x: [np.cos(x[0]) * np.sin(x[1]), np.sin(x[0]) * np.sin(x[1]), np.cos(x[1])], 2
        )
        self.assertAlmostEqual(float(tl.solve(sphere, [0, 1.5], [1, 1.5]).length), 2 * math.asin(math.sin(0.5) * math.sin(1.5)), places=4)

    def test_branches_are_refused(self):
        for branch in (
            lambda x: np.eye(2) * (x[0] if x[0] > 0 else 1),
            lambda x: np.eye(2) * max(x[0], 1),
            lambda x: np.eye(2) * abs(x[0]),
            lambda x: np.eye(2) * math.sin(x[0]),
        ):
            with self.assertRaisesRegex(tl.TraceError, "recorded once"):
                tl.Metric(branch, 2)
        with self.assertRaisesRegex(tl.TraceError, "floor"):
            tl.Metric.cost(lambda x: np.floor(x[0] + 0), 2)
        with self.assertRaisesRegex(tl.ProblemError, "Metric.cost"):
            tl.Metric(lambda x: 2 + x[0] ** 2, 2)

    def test_sympy(self):
        sympy = __import__("sympy")
        x, y = sympy.symbols("x y")
        metric = tl.Metric(sympy.Matrix([[1 + x**2, 0], [0, 2 + sympy.sin(y)]]), variables=[x, y])
        self.assertEqual(metric(np.array([0.5, 0.0])).tolist(), [[1.25, 0.0], [0.0, 2.0]])


class BlackBoxes(unittest.TestCase):
    hill = tl.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
    ends = [-1.5, 0.05], [1.5, -0.1]

    @staticmethod
    def values(x):
        cost = 1 + 4 * np.exp(-2 * np.sum(x**2, axis=1))
        return cost[:, None, None] ** 2 * np.eye(2)

    def assert_same_minimum(self, black_box):
        found, expected = (tl.solve(metric, *self.ends) for metric in (black_box, self.hill))
        self.assertTrue(found.converged, found)
        # The energy of a minimiser does not see errors of the derivatives of 1e-10.
        self.assertAlmostEqual(float(found.length), float(expected.length), delta=1e-11)

    def test_values_alone(self):
        black_box = tl.Metric.black_box(self.values, 2)
        self.assert_same_minimum(black_box)
        np.testing.assert_allclose(black_box([0.3, 0.1]), self.hill([0.3, 0.1]), rtol=1e-15)
        matrix = tl.distance_matrix(black_box, [[-1.5, 0.05], [1.5, -0.1], [0, 1]])
        exact = tl.distance_matrix(self.hill, [[-1.5, 0.05], [1.5, -0.1], [0, 1]])
        np.testing.assert_allclose(matrix, exact, rtol=1e-11)
        with self.assertRaisesRegex(tl.NotCertified, "by its values only"):
            tl.solve(black_box, *self.ends).certificate()

    def test_derivatives_by_jax(self):
        try:
            import jax
        except ImportError:
            self.skipTest("jax is not installed")
        jax.config.update("jax_enable_x64", True)

        def h(x):
            return (1 + 4 * jax.numpy.exp(-2 * x @ x)) ** 2 * jax.numpy.eye(2)

        at_all = lambda f: jax.jit(jax.vmap(f))
        first, second = jax.jacfwd(h), jax.jacfwd(jax.jacfwd(h))
        for given in ({}, {"first": at_all(first)}, {"first": at_all(first), "second": at_all(second)}):
            self.assert_same_minimum(tl.Metric.black_box(at_all(h), 2, **given))

    def test_derivatives_in_the_wrong_order_are_not_those_of_h(self):
        def first(x):
            e = np.exp(-2 * np.sum(x**2, axis=1))
            slope = (2 * (1 + 4 * e) * -16 * e)[:, None] * x
            return np.eye(2)[None, :, :, None] * slope[:, None, None, :]

        self.assert_same_minimum(tl.Metric.black_box(self.values, 2, first=first))
        swapped = tl.Metric.black_box(self.values, 2, first=lambda x: np.moveaxis(first(x), 3, 1))
        found = tl.solve(swapped, *self.ends)
        exact = tl.solve(self.hill, *self.ends)
        self.assertGreater(abs(float(found.length) - float(exact.length)), 1e-6)

    def test_derivatives_along_a_vector(self):
        def along(x, v):
            """The factors of the cost c = 1 + 4 e, of which H is c² I: c, its slope and second derivatives."""
            e = 4 * np.exp(-2 * np.sum(x**2, axis=1))
            slope = -4 * e[:, None] * x
            bend = e[:, None, None] * (16 * x[:, :, None] * x[:, None, :] - 4 * np.eye(2))
            return 1 + e, slope, bend

        def first(x, v):
            c, slope, _ = along(x, v)
            return v[:, :, None] * (2 * c[:, None] * slope)[:, None, :]

        def second(x, v):
            c, slope, bend = along(x, v)
            outer = slope[:, :, None] * slope[:, None, :]
            return np.sum(v**2, axis=1)[:, None, None] * 2 * (outer + c[:, None, None] * bend)

        for given in ({"first_along": first}, {"first_along": first, "second_along": second}):
            self.assert_same_minimum(tl.Metric.black_box(self.values, 2, **given))
        swapped = tl.Metric.black_box(self.values, 2, first_along=lambda x, v: np.moveaxis(first(x, v), 2, 1))
        found, exact = (tl.solve(metric, *self.ends) for metric in (swapped, self.hill))
        self.assertGreater(abs(float(found.length) - float(exact.length)), 1e-6)
        with self.assertRaisesRegex(ValueError, "second_along without first_along"):
            tl.Metric.black_box(self.values, 2, second_along=second)
        flat = tl.Metric.black_box(self.values, 2, first_along=lambda x, v: np.zeros((len(x), 2)))
        with self.assertRaisesRegex(tl.ProblemError, r"the first derivative has the shape \[\d+, 2\]"):
            tl.solve(flat, *self.ends)

    def test_a_decoder_of_forty_latent_dimensions(self):
        """x ↦ (x, W tanh(A x)): the pullback as a black box along vectors, in more dimensions than 32."""
        d, hidden, outputs = 40, 24, 30
        random = np.random.default_rng(65)
        a, w = random.normal(size=(hidden, d)) / d**0.5, random.normal(size=(outputs, hidden)) / hidden**0.5
        inner = w.T @ w

        def slopes(x):
            t = np.tanh(x @ a.T)
            return t, 1 - t**2

        def h(x):
            s = slopes(x)[1]
            return np.eye(d) + np.einsum("ki,mk,kl,ml,lj->mij", a, s, inner, s, a, optimize=True)

        def first(x, v):
            # H v = v + Aᵀ S M S A v, with S = diag(s(A x)) and s′ = −2 t s.
            t, s = slopes(x)
            u = v @ a.T
            back = (s * u) @ inner
            bent = -2 * t * s
            one = np.einsum("ki,mk,kj->mij", a, bent * back, a, optimize=True)
            return one + np.einsum("ki,mk,kl,ml,lj->mij", a, s, inner, bent * u, a, optimize=True)

        metric = tl.Metric.black_box(h, d, first_along=first)
        with self.assertRaisesRegex(tl.ProblemError, "at most 32 dimensions without"):
            tl.Metric.black_box(h, d)
        start, goal = -np.ones(d) / 2, random.normal(size=d) / 4
        curve = tl.solve(metric, start, goal, n=16)
        self.assertTrue(curve.converged, curve)
        images = np.concatenate([curve.points, np.tanh(curve.points @ a.T) @ w.T], axis=1)
        middle = 0.5 * (curve.points[1:] + curve.points[:-1])
        chords = np.diff(curve.points, axis=0)
        lengths = np.einsum("mi,mij,mj->m", chords, h(middle), chords) ** 0.5
        # A minimiser of the energy has chords of nearly one length, and is shorter than the straight line.
        self.assertLess(np.ptp(lengths), 1e-2 * lengths.mean())
        self.assertAlmostEqual(lengths.sum(), np.linalg.norm(np.diff(images, axis=0), axis=1).sum(), delta=1e-2)
        line = start + np.linspace(0, 1, 17)[:, None] * (goal - start)
        straight = np.concatenate([line, np.tanh(line @ a.T) @ w.T], axis=1)
        straight = np.linalg.norm(np.diff(straight, axis=0), axis=1).sum()
        self.assertLess(float(curve.length), straight)

    def test_what_a_function_raises_is_raised(self):
        def broken(x):
            raise KeyError("of the user")

        cases = [
            (KeyError, "of the user", broken),
            (tl.ProblemError, r"H has the shape \[2, 2\] at 1 points|H has the shape", lambda x: np.eye(2)),
            (tl.ProblemError, "jax_enable_x64", lambda x: self.values(x).astype(np.float32)),
            (tl.ProblemError, "of type float16", lambda x: self.values(x).astype(np.float16)),
            (TypeError, "H is complex", lambda x: self.values(x) + 0j),
            (TypeError, "H is complex", lambda x: (self.values(x) + 1e-3j).tolist()),
            (tl.MetricError, "", lambda x: -self.values(x)),
            (TypeError, "", None),
        ]
        for kind, message, h in cases:
            for attempt in (
                lambda: tl.solve(tl.Metric.black_box(h, 2), [0, 0], [1, 1]),
                lambda: tl.solve_batch(tl.Metric.black_box(h, 2), [[0, 0]], [[1, 1]]),
            ):
                expected = tl.ProblemError if kind is tl.MetricError else kind
                with self.assertRaisesRegex(expected, message):
                    attempt()
        with self.assertRaisesRegex(tl.ProblemError, "step"):
            tl.Metric.black_box(self.values, 2, step=0)
        first = tl.Metric.black_box(self.values, 2, first=lambda x: np.zeros((len(x), 2, 2, 2), complex))
        with self.assertRaisesRegex(TypeError, "the first derivative is complex"):
            tl.solve(first, *self.ends)


class Tables(unittest.TestCase):
    rows = np.array([[1.0, 1.0, 1.0], [1.0, 4.0, 2.0], [2.0, 2.0, 2.0], [3.0, 1.0, 1.0]])

    def test_a_table_has_its_array(self):
        table = tl.Table(self.rows)
        self.assertEqual(table.shape, (4, 3))
        for through in (table, tl.Table(self.rows, spline="cubic")):
            np.testing.assert_allclose(through(*np.indices((4, 3))), self.rows, atol=1e-13)
        # The weights of a cubic B-spline: 1/6, 2/3, 1/6.
        w = np.array([1, 4, 1]) / 6
        smooth = tl.Table(self.rows, spline="smoothing")
        self.assertAlmostEqual(smooth(1, 1), w @ self.rows[:3] @ w, places=14)
        with self.assertRaisesRegex(tl.ProblemError, "spline='linear'; expected one of monotone, cubic"):
            tl.Table(self.rows, spline="linear")
        self.assertEqual(table(-9, 99), 1.0)
        with self.assertRaisesRegex(tl.ProblemError, "2 axes takes 2 arguments, not 1"):
            table(1)
        for wrong in ([[1.0, math.nan]], 3.0, np.zeros((2, 2, 2, 2)), np.zeros((0, 3))):
            with self.assertRaises(tl.ProblemError):
                tl.Table(wrong)

    def test_texts_and_functions_call_tables(self):
        table = tl.Table(self.rows)
        text = tl.Metric("cost(2*h(x1, x2 - 1))", 2, tables={"h": table})
        traced = tl.Metric.cost(lambda x: 2 * table(x[0], x[1] - 1), 2)
        x = [1.25, 0.5]
        np.testing.assert_array_equal(text(x), traced(x))
        self.assertAlmostEqual(text(x)[0, 0], (2 * table(1.25, -0.5)) ** 2, places=13)
        with self.assertRaisesRegex(tl.ProblemError, "takes 2 arguments, found 1"):
            tl.Metric("cost(h(x1))", 1, tables={"h": table})

    def test_an_image_has_proofs(self):
        image = tl.Metric.image(self.rows, spacing=[0.5, 2], origin=[1, -1])
        np.testing.assert_allclose(
            image([1 + 0.5 * 2.25, -1 + 2 * 0.75]), np.eye(2) * tl.Table(self.rows)(2.25, 0.75) ** 2
        )
        constants = image.constants()
        self.assertTrue(constants["c1"].proved and 0.998 <= constants["c1"].lower <= 1)
        curve = tl.solve(image, [0.5, -1], [3, 4])
        bounds, found = curve.bounds(), curve.certificate(2e-2)
        exact = float(curve.extrapolated)
        self.assertTrue(bounds.lower <= exact <= bounds.upper)
        self.assertTrue(found.reached and found.lower <= exact <= found.upper)
        self.assertEqual(tl.check(found.text).lower, found.lower)
        with self.assertRaisesRegex(tl.ProblemError, "spacing"):
            tl.Metric.image(self.rows, spacing=0)
        with self.assertRaisesRegex(tl.ProblemError, r"\(0, 1\) is nan"):
            tl.Metric.image([[1, math.nan]])
        with self.assertRaisesRegex(tl.ProblemError, r"\(0, 0\) is -1.0"):
            tl.Metric.image(self.rows - 2)


class Notebooks(unittest.TestCase):
    def test_notebooks_run(self):
        import nbclient
        import nbformat

        folder = pathlib.Path(__file__).parent.parent / "notebooks"
        paths = sorted(folder.glob("*.ipynb"))
        self.assertTrue(paths)
        for path in paths:
            notebook = nbformat.read(path, as_version=4)
            nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
            outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
            self.assertTrue(any("image/png" in output.get("data", {}) for output in outputs))
            self.assertFalse([o for o in outputs if o.output_type == "stream" and o.name == "stderr"])


if __name__ == "__main__":
    unittest.main()
