"""Tests of intervals, jets and tables against exact arithmetic and against many digits."""

import itertools
import math
import random
import unittest
from fractions import Fraction

import numpy as np
from flint import arb, ctx

from formula import Formula
from intervals import Interval, add_down, add_up, of
from jets import Jet
from table import Table
from test_check import Tables


def double(chance):
    """A number of any size, also one that overflows or underflows in products."""
    mantissa = chance.uniform(1, 2) * chance.choice([-1, 1])
    return chance.choice(
        [0.0, mantissa * 2.0 ** chance.choice([0, 1, -1, 30, -30, 530, -540, 1000, -1060])]
    )


class Exact(unittest.TestCase):
    def holds(self, interval, exact):
        lo, hi = float(interval.lo), float(interval.hi)
        if lo > -math.inf:
            self.assertLessEqual(Fraction(lo), exact)
        if hi < math.inf:
            self.assertLessEqual(exact, Fraction(hi))

    def test_sums_products_and_quotients_contain_the_rational_numbers(self):
        chance = random.Random(1)
        for _ in range(1500):
            ends = [sorted([double(chance), double(chance)]) for _ in range(2)]
            if chance.random() < 0.5:
                ends = [[e[0]] * 2 for e in ends]
            a, b = (Interval(*e) for e in ends)
            for x, y in itertools.product(*ends):
                p, q = Fraction(x), Fraction(y)
                self.holds(a + b, p + q)
                self.holds(a - b, p - q)
                self.holds(a * b, p * q)
                self.holds(a.sqr(), p * p)
                self.holds(of(x).scaled(0.5), p / 2)
                self.holds(of(x).scaled(2.0**-60), p / 2**60)
                self.holds(Interval(add_down(x, y), add_up(x, y)), p + q)
                if not b.lo <= 0 <= b.hi:
                    self.holds(a / b, p / q)
                    self.holds(b.recip(), 1 / q)
                else:
                    self.assertTrue(np.isnan((a / b).lo))
                if a.lo >= 0:
                    root = a.sqrt()
                    self.assertLessEqual(Fraction(float(root.lo)) ** 2, p)
                    if root.hi < math.inf:
                        self.assertGreaterEqual(Fraction(float(root.hi)) ** 2, p)
                else:
                    self.assertTrue(np.isnan(a.sqrt().lo))

    def test_intervals_are_narrow(self):
        chance = random.Random(2)
        for _ in range(300):
            x, y = (chance.uniform(0.1, 3) for _ in range(2))
            for found in (of(x) + y, of(x) * y, of(x) / y, of(x).sqrt(), of(x).sqr(), of(x).exp()):
                self.assertLessEqual(found.hi - found.lo, 8e-16 * abs(found.hi))

    def test_functions_on_wide_boxes_contain_the_values_between(self):
        chance = random.Random(3)
        for name in "sqr exp atan sinh tanh cosh cos sin tan sqrt ln recip".split():
            for _ in range(60):
                low = chance.uniform(-8, 8)
                box = Interval(low, low + chance.choice([0.0, 0.3, 2, 7]))
                found = getattr(box, name)()
                points = [
                    low,
                    float(box.hi),
                    *(chance.uniform(low, float(box.hi)) for _ in range(12)),
                ]
                # Extremes and poles at multiples of a quarter turn, next to the true ones.
                points += [
                    k * math.pi / 2 for k in range(-6, 11) if box.lo < k * math.pi / 2 < box.hi
                ]
                points += [0.0] * bool(box.lo <= 0 <= box.hi)
                for x in points:
                    value = self.exactly(name, x)
                    if value is None:
                        self.assertTrue(np.isnan(found.lo), (name, low))
                    elif not np.isnan(found.lo):
                        self.assertTrue(
                            arb(float(found.lo)) <= value <= arb(float(found.hi)), (name, x)
                        )
                if name == "tan" and any(
                    box.lo < (k + 0.5) * math.pi < box.hi for k in range(-6, 9)
                ):
                    self.assertTrue(np.isnan(found.lo), float(box.lo))

    @staticmethod
    def exactly(name, x):
        """The value with many digits, None where it is undefined."""
        before, ctx.prec = ctx.prec, 300
        try:
            x = arb(x)
            if name == "sqr":
                return x * x
            if name == "recip":
                return None if x == 0 else 1 / x
            if name == "sqrt" and x < 0 or name == "ln" and x <= 0:
                return None
            return getattr(x, "log" if name == "ln" else name)()
        finally:
            ctx.prec = before

    def test_functions_at_doubles_are_rounded_outward(self):
        chance = random.Random(4)
        for name in "exp ln atan sinh tanh cosh cos sin tan".split():
            for _ in range(150):
                x = chance.uniform(0.1, 2) * chance.choice(
                    [1.0, 1e-3, 1e3 if name in ("cos", "sin", "ln") else 1.0]
                )
                found, value = getattr(of(x), name)(), self.exactly(name, x)
                self.assertTrue(arb(float(found.lo)) <= value <= arb(float(found.hi)), (name, x))

    def test_what_is_undefined_stays_undefined(self):
        nothing = Interval(np.nan)
        for name in "sqr exp atan sinh tanh cosh cos sin tan sqrt ln recip".split():
            found = getattr(nothing, name)()
            self.assertTrue(np.isnan(found.lo) and np.isnan(found.hi), name)
        for found in (nothing + 1.0, nothing * 0.0, nothing.powi(0), of(0.0) / nothing, -nothing):
            self.assertTrue(np.isnan(found.lo) and np.isnan(found.hi))
        for name in ("exp", "sinh", "cosh"):
            found = getattr(Interval(0.0, np.inf), name)()
            self.assertEqual(np.isnan(found.lo), np.isnan(found.hi), name)


class Digits:
    """A number with 300 digits, with the operations of formulas."""

    def __init__(self, x):
        self.x = x

    def __neg__(self):
        return Digits(-self.x)

    def __add__(self, other):
        return Digits(self.x + digits(other))

    def __sub__(self, other):
        return Digits(self.x - digits(other))

    def __mul__(self, other):
        return Digits(self.x * digits(other))

    def __truediv__(self, other):
        return Digits(self.x / digits(other))

    def powi(self, n):
        return Digits(self.x**n)

    def sqr(self):
        return Digits(self.x * self.x)

    def recip(self):
        return Digits(1 / self.x)

    def ln(self):
        return Digits(self.x.log())

    def __getattr__(self, name):
        return lambda: Digits(getattr(self.x, name)())


def digits(x):
    return x.x if isinstance(x, Digits) else arb(x)


class Derivatives(unittest.TestCase):
    def setUp(self):
        self.before, ctx.prec = ctx.prec, 1000

    def tearDown(self):
        ctx.prec = self.before

    def test_jets_of_two_variables_contain_the_derivatives(self):
        chance = random.Random(5)
        for _ in range(60):
            lines = self.formula(chance)
            formula = Formula(lines, 2)
            x = [chance.uniform(0.3, 1.2), chance.uniform(0.3, 1.2)]
            unit = [[of(1.0) if i == j else None for j in range(2)] for i in range(2)]
            jet = formula([Jet(of(v), u) for v, u in zip(x, unit)], lambda c: Jet(c, [None] * 2))[
                0, 0
            ]

            def f(a, b):
                point = [Digits(arb(x[0]) + a * h), Digits(arb(x[1]) + b * h)]
                return formula(point, lambda c: Digits(arb(c)))[0, 0].x

            h = arb(2) ** -200
            values = {(a, b): f(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1)}
            first = [
                (values[1, 0] - values[-1, 0]) / (2 * h),
                (values[0, 1] - values[0, -1]) / (2 * h),
            ]
            mixed = (values[1, 1] - values[1, -1] - values[-1, 1] + values[-1, -1]) / (4 * h * h)
            second = {
                (0, 0): (values[1, 0] - 2 * values[0, 0] + values[-1, 0]) / (h * h),
                (1, 1): (values[0, 1] - 2 * values[0, 0] + values[0, -1]) / (h * h),
                (0, 1): mixed,
            }
            self.near(jet.value, values[0, 0], lines)
            for i in range(2):
                self.near(jet.first[i], first[i], lines)
            for ij, value in second.items():
                self.near(jet.second.get(ij), value, lines)

    def near(self, interval, value, lines):
        """The interval holds the value, whose differences have some 100 digits, and is narrow."""
        interval = of(0.0) if interval is None else interval
        low, high, value = float(interval.lo), float(interval.hi), float(value)
        slack = 1e-15 * abs(value)
        self.assertTrue(low - slack <= value <= high + slack, (low, value, high, lines))
        self.assertLessEqual(high - low, 1e-9 * (1 + abs(value)), lines)

    @staticmethod
    def formula(chance):
        """A random formula that is defined about (0.3 … 1.2)², and uses each operation."""
        names, lines = ["x1", "x2"], []

        def add(text):
            lines.append(f"s{len(lines) + 1} = {text};")
            names.append(f"s{len(lines)}")

        add("x1 * x2")
        add("x1 + x2")
        for _ in range(6):
            a, b = chance.choice(names), chance.choice(names)
            # Positive, and not large, so that every function is defined.
            add(f"sin({a})")
            add(f"sqr(s{len(lines)})")
            add(f"s{len(lines)} + 0.5")
            safe = f"s{len(lines)}"
            add(
                chance.choice(
                    [f"{b} / {safe}", f"{safe}^3", f"{safe}^-2", f"sqrt({safe})", f"ln({safe})"]
                    + [
                        f"exp({safe})",
                        f"tan({safe})",
                        f"atan({b})",
                        f"sinh({safe})",
                        f"cosh({safe})",
                    ]
                    + [
                        f"tanh({b})",
                        f"cos({b})",
                        f"recip({safe})",
                        f"{b} * {safe}",
                        f"{b} - {safe}",
                    ]
                )
            )
        # Every step is used.
        total = "s1"
        for n in range(2, len(lines) + 1):
            add(f"{total} + s{n}")
            total = f"s{len(lines)}"
        return [*lines, f"[{total}, {total}; {total}, {total}]"]


class TablesOfSteps(unittest.TestCase):
    def test_derivatives_of_a_table_of_steps(self):
        chance = random.Random(6)
        c = np.array([[chance.uniform(1, 5) for _ in range(5)] for _ in range(6)])
        lines = [
            "s1 = sqr(x1);",
            "s2 = s1 + x2;",
            "s3 = x1 * x2;",
            "s4 = table1(s2, s3);",
            "[s4, s4; s4, s4]",
        ]
        formula = Formula(lines, 2, [Table(c)])
        h = 1e-4
        for _ in range(30):
            x = [chance.uniform(0.2, 1.6), chance.uniform(0.2, 1.6)]
            arguments = [x[0] ** 2 + x[1], x[0] * x[1]]
            # Third derivatives jump at knots: away from them, differences have an error below 1e-5.
            if any(abs(u - round(u)) < 1e-2 for u in arguments):
                continue

            def f(a, b):
                y = [x[0] + a * h, x[1] + b * h]
                return Tables.value(c, [y[0] ** 2 + y[1], y[0] * y[1]], (0, 0))

            unit = [[of(1.0) if i == j else None for j in range(2)] for i in range(2)]
            jet = formula(
                [Jet(of(np.array([v])), u) for v, u in zip(x, unit)], lambda c: Jet(c, [None] * 2)
            )[0, 0]
            second = {
                (0, 0): (f(1, 0) - 2 * f(0, 0) + f(-1, 0)) / h**2,
                (1, 1): (f(0, 1) - 2 * f(0, 0) + f(0, -1)) / h**2,
                (0, 1): (f(1, 1) - f(1, -1) - f(-1, 1) + f(-1, -1)) / (4 * h**2),
            }
            first = [(f(1, 0) - f(-1, 0)) / (2 * h), (f(0, 1) - f(0, -1)) / (2 * h)]
            self.assertAlmostEqual(float(jet.value.lo[0]), f(0, 0), delta=1e-12)
            for i in range(2):
                self.assertAlmostEqual(float(jet.first[i].lo[0]), first[i], delta=1e-5)
            for ij, value in second.items():
                self.assertAlmostEqual(float(jet.second[ij].lo[0]), value, delta=1e-4)

    def test_a_box_over_many_cells_has_all_coefficients(self):
        # A line is its own spline: from 0.5 to 20.9 in 21 cells, with the coefficients −1 to 22.
        found = Table(np.arange(40.0))((0,), [Interval(np.array([0.5]), np.array([20.9]))])
        self.assertTrue(found.lo[0] <= 0.5 and 20.9 <= found.hi[0])
        squares = Table(np.arange(40.0) ** 3)((1,), [Interval(np.array([5.0]), np.array([25.0]))])
        self.assertLessEqual(3 * 24.9**2, squares.hi[0])

    def test_each_box_has_its_own_cells_and_all_of_them(self):
        chance = random.Random(7)
        for shape in [(5,), (4, 3), (3, 2, 3)]:
            c = np.array([chance.uniform(-2, 2) for _ in range(math.prod(shape))]).reshape(shape)
            low = [np.array([chance.uniform(-3, n + 2) for _ in range(40)]) for n in shape]
            box = [Interval(x, x + chance.choice([0.4, 1.3])) for x in low]
            together = Table(c)((0,) * len(shape), box)
            for k in range(40):
                alone = Table(c)((0,) * len(shape), [side[k : k + 1] for side in box])
                self.assertEqual((together.lo[k], together.hi[k]), (alone.lo[0], alone.hi[0]))
                for _ in range(5):
                    u = [chance.uniform(float(side.lo[k]), float(side.hi[k])) for side in box]
                    value = Tables.value(c, u, (0,) * len(shape))
                    self.assertTrue(together.lo[k] - 1e-12 <= value <= together.hi[k] + 1e-12)


if __name__ == "__main__":
    unittest.main()
