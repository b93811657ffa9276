"""What may be given, and what is said of the rest."""

import importlib.metadata
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import tautline_geodesics as tl

FLAT = tl.Metric("1 I", 2)
VALLEYS = tl.Metric.cost("2 - cos(x1)", 2)

# An ordinary script, as mypy reads it.
SCRIPT = """
import numpy as np
import tautline_geodesics as tl

hill = tl.Metric.cost(lambda x: 1 + np.exp(-(x @ x)), dimension=2)
curve = tl.solve(hill, [0, 0], np.array([1, 0.5]), starts=np.zeros((3, 2)))
again = tl.solve(hill, (0, 0), tl.ball([3, 0], 1), n=64, starts=[curve, [[0, 0], [1, 1]]])
value, error = curve.length
print(f"{curve.length:.3f}", round(curve.length, 2), curve.length < 3)
goals = [[1.0, 2.0], [3.0, 4.0]]
curves = tl.solve_batch(hill, [0, 0], goals)
print(curves[0].points.shape)
found, messages = tl.solve_batch(hill, goals, goals, on_error="return")
print([each.length for each in found if each is not None], messages)
matrix = tl.distance_matrix(hill, np.array(goals))
print(matrix.sum(), hill([0, 0])[0, 0], hill.constants()["c1"].lower)
image = tl.Metric.image([[1, 2], [3, 4]], spacing=(0.5, 1))
tables = tl.Metric("cost(1 + h(x1))", 1, tables={"h": [1.0, 2.0]}, parameters=None)
print(tl.check(curve.certificate(0.1)), tl.sweep.Plan, curve.bounds(claimed=hill.constants()))
"""


class Points(unittest.TestCase):
    def test_lists_tuples_arrays_and_numbers_are_points(self):
        for start, goal in [([0, 0], (3, 4)), (np.zeros(2, np.int8), np.array([3, 4], np.float32))]:
            self.assertEqual(float(tl.solve(FLAT, start, goal, n=8).length), 5.0)
        line = tl.Metric("1 I", 1)
        self.assertEqual(float(tl.solve(line, 0, np.float64(2), n=8).length), 2.0)
        near = tl.union([0, 9], tl.ball(np.array([0, 3]), np.int64(1)))
        self.assertAlmostEqual(float(tl.solve(FLAT, [0, 0], near, n=8).length), 2.0)

    def test_a_wrong_shape_says_which_is_expected(self):
        cases = [
            (r"the start has the shape \(1, 2\); expected \(D,\)", [[0, 0]]),
            (r"the start has rows of different lengths: \[\[0, 0\], \[1\]\]", [[0, 0], [1]]),
            ("the start is 'ab'; expected numbers", "ab"),
            ("the start is None", None),
            ("a point has 3 coordinates in 2 dim", [0, 0, 0]),
        ]
        for message, start in cases:
            with self.assertRaisesRegex(tl.ProblemError, message):
                tl.solve(FLAT, start, [1, 1])
        with self.assertRaisesRegex(tl.ProblemError, r"the array of points has the shape \(2,\)"):
            tl.points([1, 2])
        with self.assertRaisesRegex(tl.ProblemError, r"the radius has the shape \(1,\)"):
            tl.ball([0, 0], [1])

    def test_complex_numbers_are_type_errors(self):
        for attempt in (
            lambda: tl.solve(FLAT, [1j, 0], [1, 1]),
            lambda: FLAT(np.array([1j, 0])),
            lambda: tl.distance_matrix(FLAT, np.zeros((2, 2), complex)),
            lambda: tl.Table([1, 2j]),
            lambda: tl.Table([1, 2])(1j),
            lambda: tl.Table([1, 2])(np.array([1j])),
            lambda: tl.ball([0, 0], 1j),
            lambda: tl.Metric("cost(2 + k*x1)", 1, parameters={"k": 1j}),
            lambda: tl.Metric.image(np.ones((2, 2), complex)),
        ):
            with self.assertRaisesRegex(TypeError, "complex"):
                attempt()

    def test_masked_cells_are_refused(self):
        def masked(*shape):
            return np.ma.masked_array(np.ones(shape), np.arange(np.prod(shape)).reshape(shape) == 0)

        for attempt in (
            lambda: tl.solve(FLAT, masked(2), [1, 1]),
            lambda: tl.solve(FLAT, [np.ma.masked, 0], [1, 1]),
            lambda: tl.solve(FLAT, [0, 0], [1, 1], starts=masked(3, 2)),
            lambda: tl.solve(FLAT, [0, 0], [1, 1], starts=[masked(3, 2)]),
            lambda: tl.solve_batch(FLAT, [0, 0], masked(3, 2)),
            lambda: tl.solve_batch(FLAT, masked(3, 2), [0, 0]),
            lambda: tl.distance_matrix(FLAT, masked(3, 2)),
            lambda: FLAT(masked(3, 2)),
            lambda: FLAT([masked(2), [0, 0]]),
            lambda: tl.Table(masked(4, 4)),
            lambda: tl.Table(np.ones((4, 4)))(masked(2), 0),
            lambda: tl.Metric.image(masked(4, 4)),
            lambda: tl.Metric.image(np.ones((4, 4)), spacing=masked(2)),
            lambda: tl.Metric.field(masked(4, 2, 2, 2)),
            lambda: tl.Metric("cost(1 + h(x1))", 1, tables={"h": masked(4)}),
            lambda: tl.Metric("cost(2 + k*x1)", 1, parameters={"k": np.ma.masked}),
            lambda: tl.Metric(masked(2, 2)),
            lambda: tl.Metric(lambda x: masked(2, 2), 2),
            lambda: tl.Metric(lambda x: [masked(2), [0, 1]], 2),
            lambda: tl.solve(tl.Metric.black_box(lambda x: masked(len(x), 2, 2), 2), [0, 0], [1, 1]),
            lambda: tl.ball(masked(2), 1),
            lambda: tl.points(masked(3, 2)),
            lambda: tl.union(masked(2)),
            lambda: tl.affine_subspace([0, 0], masked(1, 2)),
        ):
            with self.assertRaisesRegex(tl.ProblemError, "masked cells"):
                attempt()
        # Without a masked cell it is an array.
        whole = np.ma.masked_array([3.0, 4.0], [False, False])
        self.assertEqual(float(tl.solve(FLAT, [0, 0], whole, n=8).length), 5.0)

    def test_a_matrix_of_distances_needs_finite_points(self):
        with self.assertRaisesRegex(tl.ProblemError, r"row 1 of a is \[nan, 1.0\]"):
            tl.distance_matrix(FLAT, [[0, 0], [np.nan, 1]])
        with self.assertRaisesRegex(tl.ProblemError, r"row 0 of b is \[inf, 1.0\]"):
            tl.distance_matrix(FLAT, [[0, 0]], [[np.inf, 1]])

    def test_numbers_of_chords_and_threads_are_whole(self):
        for name, value in (("n", 1000.0), ("n", 0), ("n", True), ("threads", "a"), ("steps", -1)):
            message = f"{name} is {value!r}; expected a whole number of at least 1"
            with self.assertRaisesRegex(tl.ProblemError, message):
                tl.solve(FLAT, [0, 0], [1, 1], **{name: value})
        self.assertEqual(tl.solve(FLAT, [0, 0], [1, 1], n=np.int64(8)).n, 8)

    def test_starts_are_an_array_or_a_curve_or_a_list_of_them(self):
        array = np.array([[0, 0], [0.5, 0.9], [1, 1]])
        curve = tl.solve(FLAT, [0, 0], [1, 1], n=8)
        for starts in (array, array.tolist(), [array], [array, [[0, 0], [1, 1]]], curve, [curve, array]):
            found = tl.solve(FLAT, [0, 0], [1, 1], n=8, starts=starts, only_these_starts=True)
            self.assertAlmostEqual(float(found.length), 2**0.5)
        with self.assertRaisesRegex(tl.ProblemError, r"start 0 has the shape \(2,\); expected \(m, D\)"):
            tl.solve(FLAT, [0, 0], [1, 1], starts=[0, 1])

    def test_a_search_looks_as_far_as_its_scope(self):
        # Seven hills, between which a path through a lattice finds a shorter way than the starts do.
        hills = (
            (-1.05, -0.27, 29.1, 0.152), (-0.96, -0.28, 7.43, 0.114), (0.04, 0.10, 5.02, 0.173),
            (-0.34, 0.52, 23.8, 0.235), (0.81, -1.12, 9.52, 0.321), (-0.99, -0.77, 8.63, 0.160),
            (-1.16, 0.93, 22.7, 0.133),
        )
        hill = "{2}*exp(-((x1 - ({0}))^2 + (x2 - ({1}))^2)/(2*{3}^2))"
        metric = tl.Metric(f"cost(sqrt(1 + {' + '.join(hill.format(*each) for each in hills)}))", dimension=2)
        ends = [-1.8, -0.712], [1.8, 0.731]
        default, local = tl.solve(metric, *ends), tl.solve(metric, *ends, scope="local")
        self.assertLess(float(default.length), 0.95 * float(local.length))
        self.assertEqual(float(tl.solve(metric, *ends, scope="automatic").length), float(default.length))

    def test_a_black_box_is_not_asked_far_beyond_the_ends(self):
        def beside_the_axis(x):
            if (x[:, 0] <= 0).any():
                raise ValueError("not a point of the half-plane")
            return np.tile(np.eye(2), (len(x), 1, 1))

        metric = tl.Metric.black_box(beside_the_axis, 2)
        self.assertAlmostEqual(float(tl.solve(metric, [0.1, 0], [1, 0]).length), 0.9)

    def test_a_text_is_no_metric(self):
        with self.assertRaisesRegex(tl.ProblemError, r"'cost\(2\)'; a Metric is needed"):
            tl.solve("cost(2)", [0, 0], [1, 1])


class Batches(unittest.TestCase):
    def test_a_point_goes_with_all_rows(self):
        goals = [[3, 4], [0, 2]]
        lengths = [float(curve.length) for curve in tl.solve_batch(FLAT, [0, 0], goals, n=8)]
        self.assertEqual(lengths, [5.0, 2.0])
        lengths = [float(curve.length) for curve in tl.solve_batch(FLAT, goals, [0, 0], n=8)]
        self.assertEqual(lengths, [5.0, 2.0])

    def test_threads_do_not_change_the_curves(self):
        goals = np.random.default_rng(5).normal(size=(6, 2))
        curves = [tl.solve_batch(VALLEYS, [0, 0], goals, n=32, threads=k) for k in (None, 1, 3)]
        for one, two, three in zip(*curves):
            np.testing.assert_array_equal(one.points, two.points)
            np.testing.assert_array_equal(one.points, three.points)
        matrices = [tl.distance_matrix(VALLEYS, goals, n=32, threads=k) for k in (None, 1)]
        np.testing.assert_array_equal(*matrices)

    def test_errors_are_returned_if_that_is_wanted(self):
        signed = tl.Metric("(x1 + 1) I", 2)
        goals = [[1, 0], [-2, 0], [2, 0]]
        curves, messages = tl.solve_batch(signed, [0, 0], goals, n=16, on_error="return")
        self.assertEqual([curve is None for curve in curves], [False, True, False])
        self.assertEqual([message is None for message in messages], [True, False, True])
        with self.assertRaisesRegex(tl.ProblemError, "row 1: "):
            tl.solve_batch(signed, [0, 0], goals, n=16)
        with self.assertRaisesRegex(tl.ProblemError, "on_error is 'ignore'"):
            tl.solve_batch(signed, [0, 0], goals, on_error="ignore")


class Metrics(unittest.TestCase):
    def test_constants_are_metrics(self):
        self.assertEqual(tl.Metric.cost(2.0, 2)([0, 0]).tolist(), [[4.0, 0.0], [0.0, 4.0]])
        self.assertEqual(tl.Metric(np.eye(2), 2), tl.Metric([[1, 0], [0, 1]]))
        self.assertEqual(tl.Metric.diag([1, 2], 2)([0, 0]).tolist(), [[1.0, 0.0], [0.0, 2.0]])
        with self.assertRaisesRegex(tl.ProblemError, r"H has the shape \(3, 3\), not \(2, 2\)"):
            tl.Metric(np.eye(3), 2)

    def test_sympy_goes_into_all_forms(self):
        import sympy
        from sympy import cos, sin

        x, y, k = sympy.symbols("x y k")
        forms = [
            (tl.Metric.cost(k - cos(x), variables=(x, y), parameters={"k": 2}), tl.Metric.cost(lambda x: 2 - np.cos(x[0]), 2)),
            (tl.Metric.speed(2 + sin(x), variables=(x, y)), tl.Metric.speed("2 + sin(x1)", 2)),
            (tl.Metric.phi(1 + x**2, variables=(x, y)), tl.Metric.phi("1 + x1^2", 2)),
            (tl.Metric.graph(x * y, variables=[x, y]), tl.Metric.graph("x1*x2", 2)),
            (tl.Metric.diag([1 + x**2, 2], variables=(x, y)), tl.Metric.diag("1 + x1^2, 2", 2)),
            (tl.Metric.pullback(sympy.Matrix([x, y, x * y]), variables=(x, y)), tl.Metric.pullback("x1, x2, x1*x2", 2)),
            (tl.Metric([[1 + x**2, 0], [0, 1]], variables=(x, y)), tl.Metric("[1 + x1^2, 0; 0, 1]", 2)),
        ]
        for found, expected in forms:
            np.testing.assert_allclose(found([0.3, 0.8]), expected([0.3, 0.8]), rtol=1e-14)
        matrix = sympy.Matrix([[1 + x**2, 0], [0, 1 + y**2]])
        cases = [
            (r"variables=\(x, y\) are needed", lambda: tl.Metric(matrix, 2)),
            (r"3 dimensions, but 2 variables \(x, y\)", lambda: tl.Metric(matrix, 3, variables=(x, y))),
            ("y: neither in `variables` nor", lambda: tl.Metric.cost(2 + y**2, variables=(x,))),
            ("parameter k is not used", lambda: tl.Metric(matrix, variables=(x, y), parameters={"k": 1})),
            (r"x is twice in variables=\(x, x\)", lambda: tl.Metric.cost(2 + x**2, variables=(x, x))),
            (r"x is twice in variables=\(x, x\)", lambda: tl.Metric.cost(2 + x**2, variables=(x, "x"))),
            (r"x \+ y in `variables` is no symbol", lambda: tl.Metric.cost(2 + x**2, variables=(x, x + y))),
            ("2 in `variables` is no symbol", lambda: tl.Metric.cost(2 + x**2, variables=(x, 2))),
            (
                "two symbols have the name x",
                lambda: tl.Metric.cost(2 + x + sympy.Symbol("x", real=True), variables=(x, y)),
            ),
        ]
        for message, attempt in cases:
            with self.assertRaisesRegex(tl.ProblemError, message):
                attempt()

    def test_arrays_are_tables(self):
        rows = np.arange(6.0).reshape(2, 3)
        text = "cost(1 + h(x1, x2))"
        metric = tl.Metric(text, 2, tables={"h": rows})
        self.assertEqual(metric, tl.Metric(text, 2, tables={"h": tl.Table(rows)}))

    def test_parameters_are_numbers_that_are_used(self):
        with self.assertRaisesRegex(tl.ProblemError, "the parameter k is nan"):
            tl.Metric.cost("2 + k*x1", 1, parameters={"k": float("nan")})
        with self.assertRaisesRegex(tl.ProblemError, "the parameter k is inf; expected a finite number"):
            tl.Metric.cost("2 + k*x1", 1, parameters={"k": float("inf")})
        with self.assertRaisesRegex(tl.ProblemError, r"H is \[\[inf\]\]; expected finite numbers"):
            tl.Metric([[float("inf")]])
        with self.assertRaisesRegex(tl.ProblemError, "boxes is -1; expected a whole number of at least 1"):
            VALLEYS.constants(boxes=-1)
        with self.assertRaisesRegex(tl.ProblemError, "a number beyond the range of f64"):
            tl.Metric.phi(lambda x: x[0] ** 10**400, 1)
        with self.assertRaisesRegex(tl.ProblemError, "the table f is not used"):
            tl.Metric.cost("1 + x1^2", 2, tables={"f": np.ones((3, 3))})
        with self.assertRaisesRegex(tl.ProblemError, "the parameter k is not used"):
            tl.Metric.cost("2 + kk*x1", 1, parameters={"kk": 0.5, "k": 1})

    def test_places_count_in_the_text_that_was_given(self):
        cases = [
            (lambda: tl.Metric.cost("2 - cosine(x1)", 2), 4, "unknown function cosine; the functions are sqr, "),
            (lambda: tl.Metric.cost("2 - log(x1)", 2), 4, "the natural logarithm is ln"),
            (lambda: tl.Metric.cost("2 - k", 2), 4, "unknown name k; coordinates are x1, x2"),
            (lambda: tl.Metric.pullback(["x1", "x2", "sine(x1)"], 2), 8, "unknown function sine"),
            (lambda: tl.Metric("u = é;\n[1]", 1), 4, ""),
        ]
        for attempt, place, message in cases:
            with self.assertRaisesRegex(tl.ProblemError, f"^at character {place}: .*{message}"):
                attempt()
        with self.assertRaises(tl.ProblemError) as caught:
            tl.Metric("u = x1;\n[1, 0; 0, 1 + v]", 2)
        *_, line, caret = str(caught.exception).splitlines()
        self.assertEqual(line[caret.index("^")], "v")

    def test_all_functions_that_a_message_lists_are_known(self):
        with self.assertRaises(tl.ProblemError) as caught:
            tl.Metric.cost("cosine(x1)", 1)
        listed = str(caught.exception).splitlines()[0].partition("the functions are ")[2].split(", ")
        self.assertEqual(len(listed), 12)
        for name in listed:
            self.assertIn(name, tl.Metric.__doc__)
            tl.Metric.cost(f"2 + {name}(x1)", 1)

    def test_a_function_is_told_what_it_gets_and_what_it_returns(self):
        cases = [
            (r"gets one array x of shape \(2,\), and takes \(x, y\)", lambda: tl.Metric(lambda x, y: 1 + x * y, 2)),
            (r"cost: returned the shape \(2,\), expected a number", lambda: tl.Metric.cost(lambda x: 1 + x**2, 2)),
            (r"diag: returned the shape \(2, 2\), expected \(2,\)", lambda: tl.Metric.diag(lambda x: np.eye(2), 2)),
        ]
        for message, attempt in cases:
            with self.assertRaisesRegex(tl.ProblemError, message):
                attempt()

    def test_a_negative_cost_is_refused_on_its_curve(self):
        for metric in (
            tl.Metric.cost("x1 - 0.5", 2),
            tl.Metric("u = x1 - 0.5; cost(u)", 2),
            tl.Metric.cost(lambda x: x[0] - 0.5, 2),
        ):
            message = r"the cost is -0.5 at \[0.0, 0.0\]; expected a positive function"
            with self.assertRaisesRegex(tl.MetricError, message):
                tl.solve(metric, [0, 0], [0.4, 0])
            with self.assertRaisesRegex(tl.ProblemError, f"row 0: {message}"):
                tl.solve_batch(metric, [0, 0], [[0.4, 0]])
        self.assertGreater(float(tl.solve(tl.Metric.cost("x1 + 0.5", 2), [0, 0], [0.4, 0]).length), 0)
        with self.assertRaisesRegex(tl.MetricError, "the speed is -"):
            tl.solve(tl.Metric.speed("-1 - x1^2", 2), [0, 0], [0.4, 0])

    def test_an_interpolated_image_that_may_not_be_positive_is_refused(self):
        rows = np.ones((5, 5))
        rows[2, 2] = 20
        with self.assertRaisesRegex(tl.ProblemError, r"undershoots the least cost 1.0 by up to 1\d\.\d"):
            tl.Metric.image(rows, spline="cubic")
        logarithm = tl.Table(np.log(rows), spline="cubic")
        cost = tl.Metric.cost(lambda x: np.exp(logarithm(*x)), 2)([2, 2])[0, 0] ** 0.5
        self.assertAlmostEqual(cost, 20, places=9)
        rows[2, 2] = 1.1
        self.assertAlmostEqual(tl.Metric.image(rows, spline="cubic")([2, 2])[0, 0], 1.21)


class Proofs(unittest.TestCase):
    curve = tl.solve(VALLEYS, [0, 0], [1, 0.5], n=64)

    def test_an_accuracy_is_between_0_and_1(self):
        for wrong in (np.inf, np.nan, -1e-3, 0.0, 1.0, -np.inf):
            for attempt in (
                lambda: VALLEYS.constants(tolerance=wrong),
                lambda: self.curve.bounds(tolerance=wrong),
            ):
                message = f"(?i)the tolerance {wrong} is out of range; expected a number between 0 and 1"
                with self.assertRaisesRegex(tl.ProblemError, message):
                    attempt()
            with self.assertRaisesRegex(tl.ProblemError, "a gap of .* which is not between 0 and 1"):
                self.curve.certificate(wrong)
            with self.assertRaisesRegex(tl.ProblemError, "the tolerance is "):
                tl.solve(VALLEYS, [0, 0], [1, 0.5], tolerance=wrong)
        self.assertIsNotNone(VALLEYS.constants(tolerance=0.5)["c1"].lower)

    def test_constants_that_are_proved_may_be_claimed(self):
        constants = VALLEYS.constants()
        four = (constants["c1"].lower, *(constants[name].upper for name in ("c2", "L_H", "M_H")))
        self.assertEqual(self.curve.bounds(claimed=constants), self.curve.bounds(claimed=four))
        excess = tl.theorem_1_1_excess(constants, self.curve.length, 2, 64)
        self.assertEqual(excess, tl.theorem_1_1_excess(four, float(self.curve.length), 2, 64))
        with self.assertRaisesRegex(tl.ProblemError, "the constants are 3; expected"):
            self.curve.bounds(claimed=3)
        with self.assertRaisesRegex(tl.ProblemError, "no proved bound on c2"):
            self.curve.bounds(claimed={"c1": constants["c1"]})

    def test_a_certificate_is_checked_as_it_is_as_a_text_and_as_a_file(self):
        found = self.curve.certificate(0.2)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.certificate")
            found.save(path)
            for given in (found, found.text, path):
                self.assertEqual(tl.check(given).lower, found.lower)
            with self.assertRaisesRegex(tl.NotCertified, r"check\(pathlib.Path\("):
                tl.check(str(path))
            with self.assertRaisesRegex(FileNotFoundError, "nowhere"):
                found.save(os.path.join(folder, "nowhere", "a"))
        with self.assertRaisesRegex(TypeError, "3 is no certificate"):
            tl.check(3)


class Module(unittest.TestCase):
    def test_the_oldest_numpy_raises_what_a_comparison_raises(self):
        # Before 1.25, `array == v` swallows the refusal of a branch.
        required = importlib.metadata.requires("tautline-geodesics") or []
        self.assertIn("numpy>=1.25", [each.replace(" ", "") for each in required])

    def test_the_module_lists_what_it_offers(self):
        self.assertEqual(set(dir(tl)), {*tl.__all__, "sweep"})
        self.assertTrue(all(hasattr(tl, name) for name in dir(tl)))

    def test_sweeps_are_an_attribute_that_is_imported_when_it_is_used(self):
        script = (
            "import sys, tautline_geodesics as tautline; "
            "assert 'tautline_geodesics.sweep' not in sys.modules; tautline.sweep.Plan; "
            "assert 'tautline_geodesics.sweep' in sys.modules"
        )
        subprocess.run([sys.executable, "-c", script], check=True)

    def test_an_ordinary_script_has_strict_types(self):
        try:
            import mypy  # noqa: F401
        except ImportError:
            self.skipTest("mypy is not installed")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "script.py")
            path.write_text(SCRIPT)
            command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", folder, str(path)]
            found = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)


if __name__ == "__main__":
    unittest.main()
