"""Functions of NumPy and SymPy as formulas."""

import operator
import re
import unittest
from fractions import Fraction

import numpy as np

import tautline_geodesics as tl
from tautline_geodesics._recorded import coordinates
from tautline_geodesics._trace import UFUNCS, Traced

OPERATIONS = operator.add, operator.sub, operator.mul, operator.truediv, operator.pow


class Scalars(unittest.TestCase):
    def test_a_scalar_of_numpy_on_either_side_of_a_symbol_is_a_number(self):
        scalars = [
            np.float64(2),
            np.float32(2),
            np.float16(2),
            np.longdouble(2),
            np.int64(2),
            np.int8(2),
            np.uint8(2),
            np.bool_(True),
            np.array(2.0),
            np.array(2),
        ]
        x = coordinates(2)
        for k in scalars:
            number = bool(k) if k.dtype == bool else 2.0
            for operation in OPERATIONS:
                for found, expected in (
                    (operation(k, x[0]), operation(number, x[0])),
                    (operation(x[0], k), operation(x[0], number)),
                    (operation(k, x)[0], operation(number, x[0])),
                    (operation(x, k)[1], operation(x[1], number)),
                    (operation(np.array([k, k]), x)[1], operation(number, x[1])),
                    (operation(np.array([k, k]), x[0])[1], operation(number, x[0])),
                ):
                    self.assertIsInstance(found, Traced, (k, operation))
                    self.assertEqual(found.text, expected.text, (k, operation))

    def test_a_rate_from_an_array_is_the_number_in_the_text(self):
        k = np.linspace(0, 5, 6)[1]
        traced = tl.Metric.cost(lambda x: 1 + k * np.exp(-2 * (x @ x)), 2)
        self.assertEqual(traced, tl.Metric.cost(lambda x: 1 + 1.0 * np.exp(-2 * (x @ x)), 2))
        far = tl.Metric.cost(lambda x: np.float64(3) ** x[0] + np.int8(2), 1)
        self.assertAlmostEqual(far([1.0])[0, 0], 25.0)

    def test_functions_of_arrays_of_symbols(self):
        x = np.array([0.3, 0.8])
        for function in (np.exp, np.sin, np.cos, np.tanh, np.sqrt, np.log, np.square, np.reciprocal):
            metric = tl.Metric.diag(lambda x: np.float64(3) + function(np.float32(2) * x), 2)
            np.testing.assert_allclose(np.diag(metric(x)), 3 + function(2 * x), rtol=1e-15)

    def test_a_sympy_matrix_with_a_root_of_two(self):
        import sympy

        x, y = sympy.symbols("x y")
        matrix = sympy.Matrix([[sympy.sqrt(2) + sympy.sqrt(2) * x**2, 0], [0, 1 + y**2 / 3]])
        h = tl.Metric(matrix, variables=[x, y])([0.5, 2.0])
        np.testing.assert_allclose(np.diag(h), [1.25 * 2**0.5, 7 / 3], rtol=1e-15)


class Numbers(unittest.TestCase):
    def test_a_float_of_sympy_is_its_double(self):
        import sympy

        x = sympy.Symbol("x")
        for k in (1 / 3, 0.1, -2 / 3, 1e-300, 5e-324, 1.7976931348623157e308, 0.1 + 0.2):
            metric = tl.Metric.phi(sympy.Float(k) * x, variables=[x])
            self.assertEqual(metric([1.0])[0, 0], k)
            self.assertEqual(metric, tl.Metric.phi(lambda x: k * x[0], 1))
            given = tl.Metric.phi(sympy.Symbol("k") * x, variables=[x], parameters={"k": k})
            self.assertEqual(metric, given)
        typed = (sympy.Float("0.1"), sympy.Float(0.1), 0.1, sympy.Float("0.1", 15))
        self.assertEqual(len({tl.Metric.phi(k * x, variables=[x]).program.text for k in typed}), 1)
        quarter = tl.Metric.phi(sympy.Float("0.25", 40) * x**2.0, variables=[x])
        self.assertEqual(quarter([2.0])[0, 0], 1.0)

    def test_a_float_of_sympy_with_more_digits_is_refused(self):
        import sympy

        x = sympy.Symbol("x")
        for k in (sympy.pi.evalf(30), sympy.Float("0.1", 20), sympy.Float("1e-400")):
            for entry in (k * x, x + k, sympy.exp(x) ** k, x**k):
                with self.assertRaisesRegex(tl.ProblemError, "more digits than a double"):
                    tl.Metric.phi(entry, variables=[x])
        for entry in (sympy.Float("1e400") * x, sympy.exp(sympy.Float("1e400")) * x):
            with self.assertRaisesRegex(tl.ProblemError, "larger than all doubles"):
                tl.Metric.phi(entry, variables=[x])

    def test_intervals_enclose_the_exact_numbers_of_sympy(self):
        import sympy

        x, k = sympy.symbols("x k")
        third = sympy.Rational(1, 3)
        numbers = [third, -third, 2 * third, sympy.Rational(2**60 + 1, 3), sympy.Integer(2**53 + 1)]
        numbers += [sympy.Rational(1, 10), sympy.Rational(3**40, 7**30), third / 2**1060]
        numbers += [sympy.pi, sympy.E, sympy.GoldenRatio, 2 * sympy.pi / 3, 1 / sympy.pi]
        numbers += [sympy.sqrt(2), sympy.cbrt(3), sympy.log(2), sympy.sin(1), sympy.atanh(third)]
        numbers += [sympy.sqrt(2) ** 3 + sympy.exp(-2), 2**third, 10 ** sympy.pi]
        for number in numbers:
            exact = Fraction(*map(int, sympy.Rational(str(number.evalf(60))).as_numer_denom()))
            metric = tl.Metric.phi(sympy.Abs(number), variables=[x])
            bounds = metric.constants()["c1"]
            self.assertLessEqual(Fraction(bounds.lower), abs(exact), number)
            self.assertGreaterEqual(Fraction(bounds.upper), abs(exact), number)
            self.assertLess(bounds.upper - bounds.lower, 1e-13 * abs(exact) + 1e-320, number)
        # What SymPy makes of a parameter is exact too, up to the parameter.
        root = tl.Metric.phi(sympy.sqrt(k), variables=[x], parameters={"k": 2.0})
        self.assertEqual(root, tl.Metric.phi(sympy.sqrt(2), variables=[x]))
        power = tl.Metric.phi(1 + x ** (2 * k), variables=[x], parameters={"k": 1.5})
        self.assertEqual(power([2.0])[0, 0], 9.0)
        many = tl.Metric.phi((1 + k) ** 365 + (k * x) ** 20, variables=[x], parameters={"k": 0.01})
        np.testing.assert_allclose(many([3.0])[0, 0], 1.01**365 + 0.03**20, rtol=1e-13)
        for exponent in (third, 0.3, sympy.sqrt(2), -third):
            root = tl.Metric.phi(k**exponent, variables=[x], parameters={"k": 5})
            exact = sympy.Integer(5) ** (sympy.Rational(exponent) if exponent == 0.3 else exponent)
            bounds, exact = root.constants()["c1"], sympy.Rational(str(exact.evalf(60)))
            self.assertTrue(bounds.lower <= exact <= bounds.upper, exponent)
        with self.assertRaisesRegex(tl.TraceError, "a power of -2.0"):
            tl.Metric.phi(k**x, variables=[x], parameters={"k": -2})

    def test_numbers_of_sympy_beside_coordinates(self):
        import sympy

        x, y = sympy.symbols("x y")
        third = sympy.Rational(1, 3)
        forms = [
            (1 + x**2 / 3, 1 + 0.49 / 3),
            (2 + sympy.sin(sympy.pi * x), 2 + np.sin(np.pi * 0.7)),
            (third**x + 2**y + sympy.pi**x, 3**-0.7 + 2**0.2 + np.pi**0.7),
            (sympy.Rational(5, 3) * x * y + 1, 5 / 3 * 0.7 * 0.2 + 1),
            (x ** sympy.Rational(-3, 2) + sympy.log(x + 2, 10), 0.7**-1.5 + np.log10(2.7)),
        ]
        for form, expected in forms:
            found = tl.Metric.phi(form, variables=[x, y])([0.7, 0.2])[0, 0]
            self.assertAlmostEqual(found, expected, delta=4e-16 * expected, msg=form)
        division = tl.Metric.phi(x / 3, variables=[x, y])
        self.assertEqual(division, tl.Metric.phi("x1/3", 2))

    def test_what_is_no_number_of_a_formula_is_refused(self):
        import sympy

        x = sympy.Symbol("x")
        for number in (sympy.I, sympy.oo, sympy.zoo, sympy.sqrt(-2), sympy.EulerGamma, sympy.gamma(sympy.pi)):
            with self.assertRaisesRegex(tl.TraceError, "the number .* in a formula, which "):
                tl.Metric.phi(x + number, variables=[x])
        with self.assertRaisesRegex(tl.ProblemError, "the parameter k is inf"):
            tl.Metric.phi(x * sympy.Symbol("k"), variables=[x], parameters={"k": np.inf})

    def test_functions_of_the_table_bring_no_rounded_number_along(self):
        for name in UFUNCS:
            x = coordinates(2)
            ufunc = getattr(np, name)
            arguments = {2: [(x[0], x[1]), (x[0], 2), (2, x[1])]}.get(ufunc.nin, [(x[0],)])
            for given in arguments:
                if name in ("power", "float_power") and given[1] is x[1] and given[0] is x[0]:
                    continue
                recorded = ufunc(*given)
                text = tl.Metric.phi(lambda x: recorded, 2).program.text
                numbers = re.findall(r"(?<![\w.])\d[\d.]*(?:e[+-]?\d+)?", text)
                self.assertTrue(all(float(number).is_integer() for number in numbers), text)
        self.assertIn("ln(", tl.Metric.phi(lambda x: 2 ** x[0], 1).program.text)
        self.assertIn("ln(", tl.Metric.phi(lambda x: 0.3 ** x[0], 1).program.text)

    def test_a_certificate_has_the_steps_of_numbers(self):
        import sympy

        x, y = sympy.symbols("x y")
        for metric, step in (
            (tl.Metric.cost(lambda x: 2 + 2 ** -(x @ x), 2), "ln("),
            (tl.Metric.cost(2 + sympy.cos(sympy.pi * x) * y / 3, variables=[x, y]), "atan("),
        ):
            found = tl.solve(metric, [-0.5, 0.05], [0.5, -0.1], n=32).certificate(0.2)
            self.assertIn(step, found.text)
            self.assertEqual(tl.check(found.text).lower, found.lower)

    def test_whole_numbers_lose_no_digits(self):
        huge = 2**53 + 1
        for metric in (tl.Metric.phi(lambda x: huge + 0 * x[0], 1), tl.Metric.phi(lambda x: huge, 1)):
            bounds = metric.constants(tl.ball([0], 1))["c1"]
            self.assertTrue(bounds.lower <= huge <= bounds.upper)
        with self.assertRaisesRegex(tl.TraceError, "a whole number of 2049 bits"):
            tl.Metric.phi(lambda x: x[0] + 2**2048, 1)


class Functions(unittest.TestCase):
    def test_all_functions_of_the_table_have_the_values_of_numpy(self):
        for name in UFUNCS:
            ufunc = getattr(np, name)
            # Where all of them are defined.
            x = np.array([1.3, 1.7]) if name == "arccosh" else np.array([0.3, 0.7])
            # Powers of two coordinates are refused.
            second = 2 if "power" in name else x[1]
            given = (x[0], second)[: ufunc.nin]
            metric = tl.Metric.phi(lambda x: 10 + ufunc(*(x[0], 2 if "power" in name else x[1])[: ufunc.nin]), 2)
            np.testing.assert_allclose(metric(x)[0, 0], 10 + ufunc(*given), rtol=1e-15, err_msg=name)
            if ufunc.nin == 1:
                metric = tl.Metric.diag(lambda x: 10 + ufunc(x), 2)
                np.testing.assert_allclose(np.diag(metric(x)), 10 + ufunc(x), rtol=1e-15, err_msg=name)

    def test_a_branch_that_somebody_catches_is_refused_all_the_same(self):
        def compared(x):
            # As NumPy before 1.25 does in `x == 0`.
            try:
                same = x == 0
            except TypeError:
                same = False
            return 2.0 if same is False else 3.0 + x[0]

        def decided(x):
            try:
                return 2.0 if x[0] else 3.0
            except TypeError:
                return 4.0

        def less(x):
            try:
                return 2.0 if x[0] < 1 else 3.0
            except TypeError:
                return 4.0

        for function in (compared, decided, less):
            with self.assertRaisesRegex(tl.TraceError, "would follow one of the branches"):
                tl.Metric.phi(function, 2)
        # The next function is another one.
        self.assertEqual(tl.Metric.phi(lambda x: 2.0, 2)([0, 0])[0, 0], 2.0)

    def test_what_needs_an_array_of_numbers_says_so(self):
        for function in (np.sinc, np.i0, np.angle, np.cbrt, np.round, np.rint, lambda u: u % 1, lambda u: u // 2):
            for attempt in (lambda x: 2 + function(x[0]), lambda x: 2 + sum(function(x))):
                with self.assertRaises(tl.TraceError):
                    tl.Metric.phi(attempt, 2)
        with self.assertRaisesRegex(tl.TraceError, "needs arrays of numbers.*black_box"):
            tl.Metric.phi(lambda x: x[0] * x[0].dtype.itemsize, 1)

    def test_compositions_have_the_values_of_numpy(self):
        names = (
            "exp2 expm1 log2 log10 log1p arcsin arccos arctanh radians degrees deg2rad rad2deg"
        )
        x = np.array([0.3, 0.2])
        for name in names.split():
            function = getattr(np, name)
            metric = tl.Metric.diag(lambda x: 10 + function(x), 2)
            np.testing.assert_allclose(np.diag(metric(x)), 10 + function(x), rtol=1e-15, err_msg=name)
        metric = tl.Metric.diag(lambda x: 10 + np.arccosh(x[0]), 1)
        np.testing.assert_allclose(metric([1.3])[0, 0], 10 + np.arccosh(1.3), rtol=1e-15)

    def test_powers_may_be_halves(self):
        for power in (-2.5, -1.5, -0.5, 0.5, 1.5, 2.5, np.float64(3.5)):
            metric = tl.Metric.phi(lambda x: (1 + x[0] ** 2) ** power, 1)
            np.testing.assert_allclose(metric([0.7])[0, 0], 1.49**power, rtol=1e-15)
        with self.assertRaisesRegex(tl.TraceError, "power 0.3: exponents are integers or halves"):
            tl.Metric.phi(lambda x: (1 + x[0] ** 2) ** 0.3, 1)

    def test_functions_of_arrays_that_numpy_does_not_know_say_what_to_write(self):
        for function in (lambda x: np.hypot(1.0, x).sum(), lambda x: np.float_power(x, 2).sum()):
            with self.assertRaisesRegex(tl.TraceError, "for each entry"):
                tl.Metric.cost(function, 2)
        each = tl.Metric.cost(lambda x: np.hypot(1.0, x[0]) + np.float_power(x[1], 2), 2)
        self.assertAlmostEqual(each([0.75, 2.0])[0, 0], 5.25**2)

    def test_a_hypotenuse_has_two_sides(self):
        metric = tl.Metric.phi(
            lambda x: np.hypot(x[0], 4) + np.hypot(x[0], x[1]) + np.hypot(5, x[1]), 2
        )
        self.assertAlmostEqual(metric([3.0, 12.0])[0, 0], 5 + 153**0.5 + 13)

    def test_numbers_that_are_not_finite_are_refused(self):
        for k in (np.inf, np.nan):
            with self.assertRaisesRegex(tl.TraceError, f"the number {k}"):
                tl.Metric.phi(lambda x: 1 + k * x[0], 1)

    def test_symbols_of_sympy_are_known_by_their_names(self):
        import sympy

        x, k = sympy.Symbol("x", real=True), sympy.Symbol("lambda", positive=True)
        metric = tl.Metric.phi(k + x**2, variables=[x], parameters={"lambda": 2})
        self.assertEqual(metric([3.0])[0, 0], 11)
        with self.assertRaisesRegex(tl.ProblemError, "are parameters, and"):
            tl.Metric.phi(1 + x**2, variables=[x], parameters={"x": 2})

    def test_functions_with_kinks_have_smooth_replacements(self):
        for function, instead in (
            (lambda x: np.abs(x[0]), r"np.sqrt\(u\*\*2 \+ 1e-4\)"),
            (lambda x: np.abs(x).sum(), r"np.sqrt\(u\*\*2 \+ 1e-4\) in place of abs"),
            (lambda x: np.maximum(x[0], 1), r"\(u \+ v \+ np.sqrt"),
            (lambda x: np.maximum(x, 1)[0], r"\(u \+ v \+ np.sqrt"),
            (lambda x: np.where(x[0] > 1, 1, 2), "np.sqrt"),
        ):
            with self.assertRaisesRegex(tl.TraceError, f"{instead}.*black_box"):
                tl.Metric.cost(function, 2)

    def test_symbols_are_not_put_into_arrays_of_floats(self):
        def filled(x):
            h = np.zeros((2, 2))
            h[0, 0] = 1 + x[0] ** 2
            return h

        def added(x):
            h = np.eye(2)
            h += np.outer(x, x)
            return h

        def scaled(x):
            h = np.eye(2)
            h *= x[0]
            return h

        for function in (filled, added, scaled):
            with self.assertRaisesRegex(tl.TraceError, "dtype=object"):
                tl.Metric(function, 2)


if __name__ == "__main__":
    unittest.main()
