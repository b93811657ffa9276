"""Tests of the second checker: python3 -m unittest, in this folder."""

import itertools
import math
import random
import struct
import unittest

import numpy as np
from flint import arb

from certificate import Certificate
from check import check
from intervals import Interval
from jets import Jet
from refused import Refused
from region import required_cubes
from sweep import Sweep
from table import Table


def bits(*numbers):
    return " ".join(struct.pack(">d", float(x)).hex() for x in numbers)


def places(cubes, n):
    """The points from n k to n k + n of all cubes k, in lexicographic order."""
    offsets = list(itertools.product(range(n + 1), repeat=len(cubes[0])))
    return sorted(
        {tuple(n * k + o for k, o in zip(cube, off)) for cube in cubes for off in offsets}
    )


def level(exponent, cubes, functions):
    cubes = sorted(map(tuple, cubes))
    nodes = np.array(places(cubes, 2)) * 2.0 ** (exponent - 1)
    values = [bits(*(f(x) for f in functions)) for x in nodes]
    runs = [" ".join(map(str, cube)) + " 1" for cube in cubes]
    return [f"level {exponent} {len(cubes)} {len(nodes)}", *runs, *values]


def lines(metric, ends, hi, region, levels=(), curve=()):
    dimension = len(metric[-1].split("; "))
    curve = [f"curve {len(curve)}", *(bits(*x) for x in curve)] if len(curve) else []
    head = ["tautline-distance 1", f"dimension {dimension}", f"metric {len(metric)}", *metric]
    sets = [f"{name} {kind} {bits(*x)}" for name, (kind, *x) in zip(("from", "to"), ends)]
    head += [*sets, f"hi {bits(hi)}", f"region {region}", *curve]
    return head + [line for level in levels for line in level] + ["end"]


def text(*arguments, **named):
    return "\n".join(lines(*arguments, **named)) + "\n"


def flat(n):
    """The metric I."""
    rows = "; ".join(", ".join("s1" if i == j else "s2" for j in range(n)) for i in range(n))
    return ["s1 = number(1.0);"] + ["s2 = number(0.0);"] * (n > 1) + [f"[{rows}]"]


def required(hi, ends, exponent, c1=1.0):
    sets = [[(kind, np.array(x))] for kind, *x in ends]
    sizes = {"point": 0, "ball": 1, "half-space": 1}
    dimension = min(len(x) - sizes[kind] for kind, *x in ends if kind in sizes)
    found = required_cubes(("declared", c1), sets, hi, exponent, dimension)
    return np.unique(np.concatenate([*found]), axis=0)


def along(x, y):
    """The distances to two points along the line through them."""
    x, y = np.array(x), np.array(y)
    unit = (y - x) / np.linalg.norm(y - x)
    return [lambda z: unit @ (z - x), lambda z: unit @ (y - z)]


class Numbers(unittest.TestCase):
    functions = "sqr recip sqrt exp ln sin cos tan atan sinh cosh tanh".split()

    def test_functions_and_their_derivatives_lie_in_their_enclosures(self):
        chance = random.Random(1)
        for name, _ in itertools.product(self.functions, range(200)):
            low = chance.uniform(0.1, 3)
            x = arb(chance.uniform(0, 1))
            box = Interval(low, low + chance.choice([0, 1e-9, 0.3]))
            x = arb(float(box.lo)) + x * (arb(float(box.hi)) - arb(float(box.lo)))
            at, h = {}, arb(2) ** -100
            for step in (-1, 0, 1):
                t = x + step * h
                values = {"sqr": t * t, "recip": 1 / t, "ln": t.log() if name == "ln" else None}
                at[step] = values[name] if name in values else getattr(t, name)()
            jet = getattr(Jet(box, [Interval(1.0)]), name)()
            if name == "tan" and not np.isfinite(jet.value.lo):
                continue
            self.inside(at[0], jet.value)

    def test_powers_lie_in_their_enclosures_also_of_large_exponents(self):
        for n in (-3, -2, 2, 3, 6, 7, 12, 2**20 - 1, 2**30):
            for low, high in ((-1.0, -0.9), (-0.5, 1.0), (0.999999, 1.000001)):
                if n < 0 and low <= 0 <= high:
                    continue
                power = Interval(low, high).powi(n)
                for x in (low, 0.3 * low + 0.7 * high, high):
                    self.inside(arb(x) ** n, power)

    def inside(self, value, interval):
        self.assertTrue(arb(float(interval.lo)) <= value.upper(), interval.lo)
        self.assertTrue(value.lower() <= arb(float(interval.hi)), interval.hi)

    def test_second_derivatives_are_those_of_the_formula(self):
        # Differences of first derivatives at distance 1e-5, with an error of about 1e-9.
        chance = random.Random(2)
        for name, _ in itertools.product(self.functions + ["powi", "over"], range(20)):

            def f(x):
                jet = Jet(x, [Interval(1.0)])
                if name == "over":
                    return (jet + 1.0) / (jet * jet + 2.0)
                return jet.powi(-3) if name == "powi" else getattr(jet, name)()

            x, step = chance.uniform(0.3, 1.2), 1e-5
            low, middle, high = (f(Interval(x + k * step)) for k in (-1, 0, 1))
            for order in (1, 2):
                ends = [j.value.lo if order == 1 else j.first[0].lo for j in (low, high)]
                found = middle.first[0] if order == 1 else middle.second[0, 0]
                self.assertAlmostEqual((ends[1] - ends[0]) / (2 * step), found.lo, delta=1e-5)


class Tables(unittest.TestCase):
    @staticmethod
    def value(c, u, orders):
        """A derivative at a point by the formula of the cubic B-spline."""

        def b(t, order):
            t = abs(t) if order % 2 == 0 else t
            sign, t = (-1.0, -t) if order % 2 and t < 0 else (1.0, t)
            near = [(4 - 6 * t**2 + 3 * t**3) / 6, -2 * t + 1.5 * t**2, -2 + 3 * t]
            far = [(2 - t) ** 3 / 6, -((2 - t) ** 2) / 2, 2 - t]
            return 0.0 if t >= 2 else sign * (near if t < 1 else far)[order]

        total = 0.0
        spans = [range(math.floor(x) - 2, math.floor(x) + 4) for x in u]
        for at in itertools.product(*spans):
            weight = math.prod(b(x - i, order) for x, i, order in zip(u, at, orders))
            total += weight * c[tuple(min(max(i, 0), n - 1) for i, n in zip(at, c.shape))]
        return total

    def test_bounds_contain_the_derivatives_and_are_close_on_small_boxes(self):
        chance = random.Random(2)
        for shape in [(6,), (4, 5), (2, 3, 4)]:
            c = np.array([chance.uniform(1, 5) for _ in range(math.prod(shape))]).reshape(shape)
            for width in (0.0, 1e-3, 0.3, 1.0, 3.0, 20.0):
                orders = tuple(chance.choice([0, 1, 2]) for _ in shape)
                if sum(orders) > 3:
                    continue
                low = [chance.uniform(-4, n + 3) for n in shape]
                low[0] = float(round(low[0]))
                box = [Interval(np.array([x]), np.array([x + width])) for x in low]
                found = Table(c)(orders, box)
                values = []
                for _ in range(40):
                    u = [x + width * chance.random() for x in low]
                    values.append(self.value(c, u, orders))
                    self.assertLessEqual(found.lo[0] - 1e-12, values[-1], (low, width, orders))
                    self.assertLessEqual(values[-1], found.hi[0] + 1e-12, (low, width, orders))
                # A derivative of the next order is at most 5 * 8.
                slack = 40 * len(shape) * width + 1e-12
                if width < 0.5:
                    self.assertLessEqual(found.hi[0] - found.lo[0], 2 * slack)

    def test_third_derivatives_have_both_values_and_fourth_ones_none_across_a_node(self):
        table = Table(np.array([0.0, 0.0, 1.0, 5.0]))
        node = [Interval(np.array([1.0]), np.array([1.0]))]
        both = table((3,), node)
        # Third differences from the cells at 0 and at 1.
        self.assertEqual((both.lo[0], both.hi[0]), (1.0, 2.0))
        across = [Interval(np.array([0.5]), np.array([1.5]))]
        self.assertTrue(np.isnan(table((4,), across).lo[0]))
        self.assertEqual(table((4,), [Interval(np.array([0.0]), np.array([1.0]))]).hi[0], 0.0)

    def test_a_certificate_calls_its_tables_in_order(self):
        metric = ["s1 = table1(x1);", "[s1]"]
        ends = [("point", 0.0), ("point", 1.0)]
        cubes = required(1.5, ends, -2)
        run = f"level -2 {len(cubes)} {2 * len(cubes) + 1}"
        nodes = [bits(k / 8, 1 - k / 8) for k in range(2 * cubes.min(), 2 * cubes.max() + 3)]
        cubes_and_nodes = [run, *(f"{k[0]} 1" for k in cubes), *nodes]
        whole = lines(metric, ends, 1.5, f"declared {bits(1.0)}", [cubes_and_nodes])
        table = ["table 2", bits(1.0, 1.0)]
        good = "\n".join([*whole[:2], *table, *whole[2:]]) + "\n"
        lower, _ = check(Certificate(good))
        self.assertAlmostEqual(lower, 1.0, places=2)
        for wrong in (
            good.replace("table1", "table2"),
            good.replace("table1", "table1_3"),
            good.replace("table1(x1)", "table1(x1, x1)"),
            good.replace("table 2", "table 3"),
            good.replace("metric", "\n".join([*table, "metric"])),
            good.replace("table 2\n" + bits(1.0), "table 2\n" + bits(math.inf)),
        ):
            with self.assertRaises(Refused):
                Certificate(wrong)


class Bounds(unittest.TestCase):
    def test_linear_functions_on_a_flat_space_lose_only_rounding(self):
        for n in (1, 2, 3):
            chance = np.random.default_rng(n)
            x, y = chance.uniform(-1, 1, n), chance.uniform(-1, 1, n)
            d, ends = math.dist(x, y), [("point", *x), ("point", *y)]
            cubes = required(1.001 * d, ends, math.floor(math.log2(d)) - 2)
            levels = [level(math.floor(math.log2(d)) - 2, cubes, along(x, y))]
            file = text(flat(n), ends, 1.001 * d, f"declared {bits(1)}", levels, [x, y])
            lower, upper = check(Certificate(file))
            self.assertTrue(d * (1 - 1e-13) <= lower <= d * (1 + 1e-15) <= upper * (1 + 2e-15))

    def test_noise_in_the_values_only_weakens_the_bound(self):
        chance = random.Random(3)
        ends = [("point", 0.1, 0.05), ("ball", 1.3, 0.2, 0.25)]
        d = math.hypot(1.2, 0.15) - 0.25
        for noise in (1e-3, 0.1, 10.0):
            exact = [lambda x: math.dist(x, (0.1, 0.05)), lambda x: math.dist(x, (1.3, 0.2)) - 0.25]
            noisy = [lambda x, f=f: f(x) + noise * chance.uniform(-1, 1) for f in exact]
            hi = 1.1 * d
            levels = [level(-4, required(hi, ends, -4), noisy)]
            lower, _ = check(Certificate(text(flat(2), ends, hi, f"declared {bits(1)}", levels)))
            self.assertLessEqual(lower, d)

    def test_the_vertex_test_is_sharp_and_half_its_shift_would_be_wrong(self):
        # H = 1 + |x - c|² on a square of side 1/2 about c: the least H is 1, at c.
        metric = ["s1 = x1 - 0.25;", "s2 = s1^2;", "s3 = x2 - 0.25;", "s4 = s3^2;"]
        metric += ["s5 = s2 + s4;", "s6 = s5 + 1.0;", "s7 = number(0.0);", "[s6, s7; s7, s6]"]
        ends = [("point", 0.0, 0.0), ("point", 0.5, 0.5)]
        levels = [level(-1, [(0, 0)], [lambda x: x[0], lambda x: x[1]])]
        c = Certificate(text(metric, ends, 1.0, f"declared {bits(1)}", levels))
        for q in Sweep(c.formula, c.sets, c.levels[0]).q:
            self.assertTrue(np.all((1 <= q) & (q <= 1 + 1e-13)))

    def test_a_polynomial_may_exceed_its_values_at_the_nodes(self):
        # In these two cubes; with the range of the nodal values, the bound would be 1.778.
        heights = {0.0: 0.0, 0.5: 0.5, 1.0: 1.0, 1.5: 9.0, 2.0: 10.0}
        ends = [("point", 0.05, 0.53), ("point", 1.8, 0.53)]
        values = level(0, [(0, 0), (1, 0)], [lambda x: heights[x[0]], lambda x: 0.0])
        c = Certificate(text(flat(2), ends, 1.8, "exit-two", [values]))
        found, _ = Sweep(c.formula, c.sets, c.levels[0]).shorter_than(1.8)
        self.assertLessEqual(found, 1.75)

    def test_functions_with_small_slopes_keep_the_geodesic(self):
        # Slopes are at most 1: without that, twice the values would drop everything.
        x, y, hi = (0.0, 0.03), (1.0, 0.03), 1.001
        ends, halves = (
            [("point", *x), ("point", *y)],
            [lambda z, f=f: f(z) / 2 for f in along(x, y)],
        )
        levels = [level(-4, required(hi, ends, -4), halves)]
        lower, _ = check(
            Certificate(text(flat(2), ends, hi, f"declared {bits(1)}", levels, [x, y]))
        )
        self.assertTrue(0.49 < lower <= 0.5)

    def test_nothing_is_proved_above_hi(self):
        x, y = (0.0, 0.03), (1.0, 0.03)
        ends = [("point", *x), ("point", *y)]
        # Without ψ, the large simplices at the second set are kept.
        for exponent, functions in ((-4, along(x, y)), (-2, [along(x, y)[0], lambda z: 0.0])):
            levels = [level(exponent, required(1.1, ends, exponent), functions)]
            file = text(flat(2), ends, 0.97, f"declared {bits(1)}", levels)
            self.assertEqual(check(Certificate(file))[0], 0.97)

    def test_axes_are_not_confused(self):
        metric = ["s1 = number(2.0);", "s2 = number(0.5);", "s3 = number(0.25);"]
        metric += ["[s1, s2, s2; s2, s1, s3; s2, s3, s2]"]
        h = np.array([[2, 0.5, 0.5], [0.5, 2, 0.25], [0.5, 0.25, 0.5]])
        x, y = np.array([0.1, 0.2, -0.3]), np.array([0.5, 0.3, 0.6])
        d = math.sqrt((y - x) @ h @ (y - x))
        p, ends, c1 = h @ (y - x) / d, [("point", *x), ("point", *y)], 0.25
        levels = [
            level(-2, required(d, ends, -2, c1), [lambda z: p @ (z - x), lambda z: p @ (y - z)])
        ]
        file = text(metric, ends, d, f"declared {bits(c1)}", levels)
        lower, _ = check(Certificate(file))
        self.assertTrue(d * (1 - 1e-13) <= lower <= d * (1 + 1e-15))

    def test_the_values_on_all_of_a_set_count(self):
        box = ("box", -0.3, -0.2, 0.0, 0.2)
        for ends, d in (([box, ("point", 1.0, 0.05)], 1.0), ([("point", -1.0, 0.05), box], 0.7)):
            levels = [level(-4, required(1.5, ends, -4), [lambda x: x[0], lambda x: 0.0])]
            lower, _ = check(Certificate(text(flat(2), ends, 1.4, f"declared {bits(1)}", levels)))
            self.assertTrue(d * (1 - 1e-13) <= lower <= d)

    def test_values_that_grow_too_fast_in_one_cube_cost_nothing_else(self):
        ends, hi = [("point", 0.03), ("point", 1.03)], 1.5
        steep = [lambda x: x[0] + 2 * min(max(x[0] - 0.5, 0), 0.125), lambda x: 0.0]
        levels = [level(-3, required(hi, ends, -3), steep)]
        lower, _ = check(Certificate(text(flat(1), ends, hi, f"declared {bits(1)}", levels)))
        self.assertTrue(0.999 < lower <= 1.0)

    def test_cubes_too_large_for_the_vertex_test_prove_nothing(self):
        # H = JᵀJ for the map (x₁ + 0.6 sin 3x₂, x₂), whose curvature exceeds its eigenvalues.
        metric = ["s1 = x2 * 3.0;", "s2 = cos(s1);", "s3 = s2 * 1.8;", "s4 = number(1.0);"]
        metric += ["s5 = sqr(s3);", "s6 = s5 + 1.0;", "[s4, s3; s3, s6]"]
        x, y = (0.05, 0.03), (1.95, 0.03)
        ends, hi = [("point", *x), ("point", *y)], 1.2 * 1.9
        distances = [lambda z: 5 * math.dist(z, x), lambda z: 5 * math.dist(z, y)]
        for exponent in (0, -1):
            levels = [level(exponent, required(hi, ends, exponent, 0.15), distances)]
            file = text(metric, ends, hi, f"declared {bits(0.15)}", levels)
            self.assertEqual(check(Certificate(file))[0], 0)

    def test_curves_do_not_leave_cubes_with_an_exit(self):
        # The boundary has distance 0.97 or more from each point; with a side moved, 0.5 from one.
        x, y = (0.0, 0.03), (0.5, 0.03)
        ends = [("point", *x), ("point", *y)]
        functions = [lambda z: math.dist(z, x), lambda z: math.dist(z, y)]

        def bound(hi, region, low, high):
            cubes = list(itertools.product(*map(range, low, high)))
            file = text(flat(2), ends, hi, region, [level(-3, cubes, functions)])
            return check(Certificate(file))[0]

        for hi, region in ((0.8, "exit-one"), (1.6, "exit-two")):
            self.assertTrue(0.4 < bound(hi, region, (-8, -8), (12, 8)) <= 0.5)
            for low, high in (((-4, -8), (12, 8)), ((-8, -4), (12, 8)), ((-8, -8), (12, 4))):
                with self.assertRaises(Refused):
                    bound(hi, region, low, high)
        with self.assertRaises(Refused):
            bound(0.8, "exit-one", (-8, -8), (6, 8))

    def test_a_formula_that_is_undefined_in_a_cube_proves_nothing_there(self):
        # 1 + 0/x: each of two cubes touches 0, and the values cost nothing in them.
        metric = ["s1 = recip(x1);", "s2 = s1 * 0.0;", "s3 = s2 + 1.0;", "[s3]"]
        ends, hi = [("point", -1.0), ("point", 1.0)], 2.0001
        levels = [level(-4, required(hi, ends, -4), along((-1.0,), (1.0,)))]
        lower, _ = check(Certificate(text(metric, ends, hi, f"declared {bits(1)}", levels)))
        self.assertTrue(1.87 < lower < 1.876)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.x, self.y, self.hi = (0.0, 0.03), (1.0, 0.03), 1.0001
        self.ends = [("point", *self.x), ("point", *self.y)]
        self.cubes = required(self.hi, self.ends, -4)
        levels = [level(-4, self.cubes, along(self.x, self.y))]
        self.region = f"tubes {bits(0.51, 0.999)}"
        self.lines = lines(flat(2), self.ends, self.hi, self.region, levels, [self.x, self.y])
        self.accepts(self.lines)

    def accepts(self, lines):
        return check(Certificate("\n".join(lines) + "\n"))

    def refuses(self, lines):
        with self.assertRaises(Refused):
            self.accepts(lines)

    def changed(self, start, new):
        at = next(i for i, line in enumerate(self.lines) if line.startswith(start))
        return self.lines[:at] + new + self.lines[at + 1 :]

    def test_a_cube_less(self):
        for missing in (0, len(self.cubes) // 2):
            cubes = np.delete(self.cubes, missing, axis=0)
            levels = [level(-4, cubes, along(self.x, self.y))]
            self.refuses(lines(flat(2), self.ends, self.hi, self.region, levels))

    def test_a_cube_that_just_touches_the_region_is_not_required(self):
        # 2 (|x| + |x − 1|) < 6 from −1 to 2, and for the ball from −1.5 to 2, without the ends.
        for first, cubes in ((("point", 0.0), [-1, 0, 1]), (("ball", -0.5, 0.5), [-2, -1, 0, 1])):
            ends = [first, ("point", 1.0)]
            self.assertEqual(required(6.0, ends, 0, 4.0).ravel().tolist(), cubes)
            self.assertEqual(required(6.000001, ends, 0, 4.0).ravel().tolist(), [-2, -1, 0, 1, 2])

    def test_places_beyond_machine_integers(self):
        # With places of 32 bits that wrap, no cube would be required, and 100 would be proved.
        far = 2.0**20
        ends, region = [("point", far), ("point", far + 1)], f"tubes {bits(100, 0.5)}"
        for levels in ([["level -13 0 0"]], [level(-13, [(0,)], along((far,), (far + 1,)))]):
            self.refuses(lines(flat(1), ends, 100.0, region, levels))

    def test_tubes_that_are_thin_or_have_no_such_constant(self):
        for numbers in ((0.25, 0.999), (0.5, 0.999), (0.51, 1.001), (math.inf, 0.999), (-1, 0.999)):
            self.refuses(self.changed("region", [f"region tubes {bits(*numbers)}"]))

    def test_a_single_tube_as_thin_as_two(self):
        ends, hi = [("ball", 0.0, 0.03, 0.1), ("half-space", -1.0, 0.0, -1.0)], 1.0
        functions = [lambda z: math.dist(z, (0.0, 0.03)) - 0.1, lambda z: 1 - z[0]]
        levels = [level(-4, required(hi, ends, -4, 0.999), functions)]
        lower, _ = self.accepts(lines(flat(2), ends, hi, f"tubes {bits(1.01, 0.999)}", levels))
        self.assertTrue(0.88 < lower <= 0.9)
        self.refuses(lines(flat(2), ends, hi, f"tubes {bits(0.51, 0.999)}", levels))

    def test_a_cube_given_twice(self):
        at = next(i for i, line in enumerate(self.lines) if line.startswith("level"))
        word, exponent, runs, nodes = self.lines[at].split()
        head = f"{word} {exponent} {int(runs) + 1} {nodes}"
        self.refuses([*self.lines[:at], head, self.lines[at + 1], *self.lines[at + 1 :]])

    def test_a_region_without_a_constant(self):
        for c1 in (0.0, -1.0, math.nan, math.inf, 0.5):
            self.refuses(self.changed("region", [f"region declared {bits(c1)}"]))

    def test_an_exit_that_is_too_cheap(self):
        for region in ("exit-one", "exit-two"):
            self.refuses(self.changed("region", [f"region {region}"]))

    def test_a_curve_elsewhere(self):
        self.refuses(self.changed("to", [f"to point {bits(1.0, 0.031)}"]))
        self.refuses(self.changed("hi", [f"hi {bits(0.9999)}"]))

    def test_a_curve_where_the_metric_is_undefined(self):
        # 0/x + 1 as a power: without its own value, nothing shows that it is undefined at 0.
        metric, sides = ["s1 = recip(x1);", "s2 = s1^0;", "[s2]"], [(k,) for k in range(-128, 128)]
        for x, y, curve in ((-1, 2, [[-1], [2]]), (0, 0, [[0]]), (0, 0, [[0], [0]])):
            distances = [lambda z, x=x: abs(z[0] - x), lambda z, y=y: abs(z[0] - y)]
            ends, levels = [("point", x), ("point", y)], [level(-4, sides, distances)]
            self.refuses(lines(metric, ends, 3.5, "exit-one", levels, curve))
            self.accepts(lines(metric, ends, 3.5, "exit-one", levels))
            self.accepts(lines(flat(1), ends, 3.5, "exit-one", levels, curve))

    def test_text_that_the_format_does_not_name(self):
        for start, new in (
            ("hi", ["hi 1.0"]),
            ("hi", ["hi 7ff8000000000000"]),
            ("hi", ["hi  " + bits(1.0001)]),
            ("hi", ["hi " + bits(1.0001, 1.0001)]),
            ("metric", ["metric 3 steps"]),
            ("curve", ["curve 2 2"]),
            ("hi", ["hi " + bits(1.0001), "M " + bits(0)]),
            ("hi", ["hi " + bits(1.0001).upper()]),
            ("dimension", ["dimension 02"]),
            ("dimension", ["dimension 3"]),
            ("s1", ["s1 = number(1e999);"]),
            ("s1", ["s1 = number(inf);"]),
            ("s1", ["s1 = s2 + 1.0;"]),
            ("s1", ["s2 = number(1.0);"]),
            ("from", ["from ball " + bits(0, 0.03, -1)]),
            ("from", []),
            ("end", []),
            ("end", ["end", "end"]),
        ):
            self.refuses(self.changed(start, new))

    def test_values_that_are_not_finite_or_missing(self):
        values = self.lines[-2].split()
        for new in (
            ["7ff8000000000000 " + values[1]],
            ["7ff0000000000000 " + values[1]],
            [values[0]],
            [],
        ):
            self.refuses(self.lines[:-2] + new + ["end"])

    def test_levels_of_other_sides(self):
        for exponent in (-6, -3):
            more = level(exponent, self.cubes, along(self.x, self.y))
            self.refuses(self.lines[:-1] + more + ["end"])


if __name__ == "__main__":
    unittest.main()
